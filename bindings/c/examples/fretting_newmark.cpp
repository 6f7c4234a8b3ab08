// A mass on a contact with friction under an alternating force. Time integration uses Newmark's rule of average
// acceleration. Each time step uses Newton's iteration with the tangent stiffness of the contact. The energy balance closes
// to the tolerance of Newton's iteration. SI units.
//   fretting_newmark_cpp [cells along a side, default 48] [time steps, default 160]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include <stickslip.hpp>

namespace {

constexpr double MASS = 1.0, LOAD = 100.0, AMPLITUDE = 20.0;
constexpr int STEPS_PER_CYCLE = 40;

// Contact below the mass; its force on the mass opposes the motion.
class Joint {
  public:
    explicit Joint(std::size_t n) : history_(make(n)), before_(history_), cycle_(history_) {
        history_.step(stickslip::step(stickslip::press_by_force(LOAD)));
    }

    double stuck_stiffness() const { return history_.stiffness().tangential.reversal[0][0]; }
    double stiffness() const { return history_.stiffness().tangential.loading[0][0]; }
    void begin_cycle() { cycle_.begin(history_); }
    void begin_step() { before_.keep(history_); }
    void end_step() { cycle_.add(history_); }
    stickslip_cycle_result cycle() const { return cycle_.result(); }

    // Moves the mass to a place, starting from its place before the time step.
    stickslip_step_result move(double place) {
        history_.set_state(before_);
        return history_.step(stickslip::step(stickslip::held_pressure(), stickslip::shift(place)));
    }

  private:
    static stickslip::History make(std::size_t n) {
        const stickslip::Grid grid = {n, n, 0.30e-3 / double(n), 0.30e-3 / double(n)};
        const auto steel = stickslip::elastic(213e9, 0.29);
        const stickslip::HalfSpace bodies(grid, steel, steel); // the history keeps the parts it needs
        auto options = stickslip_history_options_default();
        options.settings.tolerance = 1e-10;
        return {bodies, stickslip::sphere(grid, 3.5e-3), stickslip::coulomb(0.5), options};
    }

    stickslip::History history_;
    stickslip::State before_;
    stickslip::Cycle cycle_;
};

bool run(std::size_t n, int steps) {
    Joint joint(n);
    // The mass is driven at half of the natural frequency of the sticking contact.
    const double pulsation = 0.5 * std::sqrt(joint.stuck_stiffness() / MASS);
    const double dt = 2.0 * std::acos(-1.0) / pulsation / STEPS_PER_CYCLE;
    double x = 0.0, v = 0.0, a = 0.0, pull = 0.0, given = 0.0, dissipated = 0.0, stored = 0.0;
    int most_iterations = 0;
    for (int step = 1; step <= steps; step++) {
        if ((step - 1) % STEPS_PER_CYCLE == 0) {
            joint.begin_cycle();
        }
        const double ramp = std::min(1.0, double(step) / STEPS_PER_CYCLE);
        const double new_pull = ramp * AMPLITUDE * std::sin(pulsation * dt * step);
        joint.begin_step();
        double new_x = x + dt * v + 0.25 * dt * dt * a, new_a = 0.0;
        auto now = joint.move(new_x);
        for (int iteration = 0;; iteration++) {
            new_a = 4.0 / (dt * dt) * (new_x - x) - 4.0 / dt * v - a;
            const double missing = new_pull - now.force[0] - MASS * new_a;
            most_iterations = std::max(most_iterations, iteration);
            if (std::abs(missing) <= 1e-9 * AMPLITUDE) {
                break;
            }
            if (iteration == 30) {
                throw std::runtime_error("Newton does not converge in step " + std::to_string(step));
            }
            new_x += missing / (4.0 / (dt * dt) * MASS + joint.stiffness());
            now = joint.move(new_x);
        }
        joint.end_step();
        given += 0.5 * (pull + new_pull) * (new_x - x);
        dissipated += now.energy.dissipated_energy_midpoint;
        stored = now.energy.elastic_after;
        v += 0.5 * dt * (a + new_a);
        x = new_x, a = new_a, pull = new_pull;
    }
    const double moving = 0.5 * MASS * v * v;
    const double imbalance = (moving + stored + dissipated) / given - 1.0;
    const auto loop = joint.cycle();
    std::printf("%d time steps, at most %d iterations of Newton\n", steps, most_iterations);
    std::printf("given %.6e J = moving %.3e + stored %.3e + dissipated %.3e, imbalance %+.1e\n", given, moving, stored,
                dissipated, imbalance);
    std::printf("last cycle: force +-%.2f N, shift +-%.4f um\n", loop.force_amplitude[0], 1e6 * loop.shift_amplitude[0]);
    return std::abs(imbalance) < 1e-6 && dissipated > 0.0 && loop.regime == STICKSLIP_PARTIAL_SLIP;
}

} // namespace

int main(int argc, char **argv) {
    try {
        return run(argc > 1 ? std::stoul(argv[1]) : 48, argc > 2 ? std::stoi(argv[2]) : 160) ? 0 : 1;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
