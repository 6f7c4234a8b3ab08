// A steel ball on steel, pressed and sheared, compared with the solutions of Hertz and of Cattaneo and Mindlin. SI units.
//   press_and_shear_cpp [cells along a side, default 128]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <stickslip.hpp>

namespace {

// Prints a number and its closed-form value, and returns whether they agree.
bool agrees(const char *name, double found, double exact, double tolerance) {
    const double error = found / exact - 1.0;
    std::printf("%-16s %.6e  closed form %.6e  difference %+.1e\n", name, found, exact, error);
    return std::abs(error) <= tolerance;
}

bool run(std::size_t n) {
    const double radius = 3.5e-3, load = 100.0, drag = 20.0, mu = 0.5, side = 0.40e-3;
    const stickslip::Grid grid = {n, n, side / double(n), side / double(n)};
    const auto steel = stickslip::elastic(213e9, 0.29);
    const stickslip::HalfSpace bodies(grid, steel, steel);

    stickslip::NormalSolver presser(bodies, stickslip::sphere(grid, radius), stickslip::press_by_force(load));
    std::size_t looks = 0;
    const auto pressed = presser.solve([&](const stickslip::Iteration &) { return ++looks > 0; });
    stickslip::TangentialSolver shearer(bodies, pressed, stickslip::coulomb(mu),
                                        stickslip::tangential(stickslip::force(drag)));
    const auto sheared = shearer.solve();

    const auto pressure = pressed.pressure(); // a view of the solution, not a copy
    const double largest = *std::max_element(pressure.begin(), pressure.end());
    const auto pair = bodies.pair();
    const double a = std::cbrt(0.75 * load * radius / pair.contact_modulus);
    const double peak = 1.5 * load / (std::acos(-1.0) * a * a);
    const double stick = std::cbrt(1.0 - drag / (mu * load));
    const double shift = 3.0 * mu * load / (16.0 * pair.tangential_modulus * a) * (1.0 - stick * stick);
    // The grid resolves pressure and shift to a fraction of a cell, and the stick zone to whole cells.
    const double cells = a / grid.dx;
    bool good = agrees("approach", pressed.result().approach, a * a / radius, 0.3 / (cells * cells));
    good &= agrees("largest pressure", largest, peak, 3.0 / (cells * cells));
    good &= agrees("shift", sheared.result().shift[0], shift, 1.0 / (cells * cells));
    good &= agrees("stick ratio", sheared.result().stick_ratio, stick * stick, 0.6 / cells);
    const auto zones = sheared.zones();
    good &= std::count(zones.begin(), zones.end(), STICKSLIP_STICK) > 0 && looks > 0;

    // A force above the friction capacity is rejected; the error contains the limit.
    try {
        shearer.set_load(stickslip::tangential(stickslip::force(60.0)));
        good = false;
    } catch (const stickslip::Error &error) {
        std::printf("refused: %s\n", error.what());
        good &= error.code() == STICKSLIP_BEYOND_FRICTION_CAPACITY && error.numbers().value == 60.0;
    }
    // An exception of the observer propagates out of the solve.
    try {
        shearer.reset();
        shearer.solve([](const stickslip::Iteration &) -> bool { throw std::string("enough"); });
        good = false;
    } catch (const std::string &thrown) {
        good &= thrown == "enough";
    }
    return good;
}

} // namespace

int main(int argc, char **argv) {
    try {
        return run(argc > 1 ? std::stoul(argv[1]) : 128) ? 0 : 1;
    } catch (const stickslip::Error &error) {
        std::fprintf(stderr, "error %d: %s\n", int(error.code()), error.what());
        return 1;
    }
}
