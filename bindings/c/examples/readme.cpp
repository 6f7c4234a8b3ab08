// Example of the README.
#include <cmath>
// begin
#include <cstdio>
#include <stickslip.hpp>

int main() {
    const stickslip::Grid grid = {128, 128, 0.40e-3 / 128, 0.40e-3 / 128}; // cells and their sides, m
    const auto steel = stickslip::elastic(213e9, 0.29);
    const stickslip::HalfSpace bodies(grid, steel, steel);
    stickslip::History contact(bodies, stickslip::sphere(grid, 3.5e-3), stickslip::coulomb(0.5));
    contact.step(stickslip::step(stickslip::press_by_force(100.0)));
    const auto now = contact.step(stickslip::step(stickslip::held_pressure(), stickslip::force(20.0)));
    std::printf("stick ratio %.4f, shift %.4e m\n", now.stick_ratio, now.shift[0]);
    std::printf("stiffness at reversal %.4e N/m\n", contact.stiffness().tangential.reversal[0][0]);
    // end
    // Cattaneo and Mindlin.
    return std::abs(now.stick_ratio - 0.7114) < 0.01 && std::abs(now.shift[0] - 0.85446e-6) < 1e-9 ? 0 : 1;
}
