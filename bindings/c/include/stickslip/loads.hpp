// Friction and loads.

#ifndef STICKSLIP_LOADS_HPP
#define STICKSLIP_LOADS_HPP

#include <cstdint>

#include "../stickslip.h"

namespace stickslip {

using LoadStep = stickslip_load_step;

inline stickslip_friction coulomb(double coefficient) { return stickslip_coulomb(coefficient); }

inline stickslip_normal_load press_by_force(double force) { return {STICKSLIP_FORCE, force}; }
inline stickslip_normal_load press_by_approach(double approach) { return {STICKSLIP_APPROACH, approach}; }
inline stickslip_normal_load held_pressure() { return {STICKSLIP_HOLD, 0.0}; }

inline stickslip_control held() { return {STICKSLIP_HOLD, 0.0, 0.0}; }
inline stickslip_control force(double value) { return {STICKSLIP_FORCE, value, 0.0}; }
inline stickslip_control shift(double value) { return {STICKSLIP_SHIFT, value, 0.0}; }
inline stickslip_control spring(double position, double stiffness) { return {STICKSLIP_SPRING, position, stiffness}; }

/// Returns a tangential load from rest.
inline stickslip_tangential_load tangential(stickslip_control x, stickslip_control y = held(), double twist = 0.0) {
    return {x, y, twist, {}};
}

/// Returns a step of a history, which holds pressure, shift and twist if it does not prescribe them. A held shift does not hold
/// the tangential force (see stickslip_load_step).
inline LoadStep step(stickslip_normal_load normal, stickslip_control x = held(), stickslip_control y = held()) {
    return {normal, x, y, 0, 0.0, 0, 0.0, {}, {}};
}

/// Returns the step with rolling by a number of cells and with creepages; the leading edge is at the largest x by default.
/// A creepage is a motion of body 2 over body 1, opposite to Kalker's. Along an axis with a prescribed force, the creepage is a
/// result and must be zero here.
inline LoadStep rolled(LoadStep step, std::uint32_t cells, double creepage_x = 0.0, double creepage_y = 0.0,
                       double spin = 0.0, std::int32_t leading_edge = STICKSLIP_PLUS_X) {
    step.roll = {cells, leading_edge, {creepage_x, creepage_y}, spin};
    return step;
}

} // namespace stickslip

#endif // STICKSLIP_LOADS_HPP
