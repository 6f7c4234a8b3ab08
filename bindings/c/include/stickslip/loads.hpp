// Friction, loads and tractions.

#ifndef STICKSLIP_LOADS_HPP
#define STICKSLIP_LOADS_HPP

#include <cstdint>
#include <stdexcept>

#include "core.hpp"

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

/// Returns a step of a history, which holds pressure, shift and twist if it does not prescribe them. A held shift does not
/// hold the tangential force (see stickslip_load_step).
inline LoadStep step(stickslip_normal_load normal, stickslip_control x = held(), stickslip_control y = held()) {
    return {normal, x, y, 0, 0.0, 0, 0.0, {}, {}};
}

/// Returns the step with rolling by a number of cells and with creepages; the leading edge is at the largest x by default.
/// A creepage is a motion of body 2 over body 1, opposite to Kalker's. Along an axis with a prescribed force, the creepage is a
/// result and must be zero here. Throws std::invalid_argument if the number of cells is zero, because the step would then not
/// roll.
inline LoadStep rolled(LoadStep step, std::uint32_t cells, double creepage_x = 0.0, double creepage_y = 0.0,
                       double spin = 0.0, std::int32_t leading_edge = STICKSLIP_PLUS_X) {
    if (cells == 0) {
        throw std::invalid_argument("rolled: cells is 0: a rolling step covers at least one cell");
    }
    step.roll = {cells, leading_edge, {creepage_x, creepage_y}, spin};
    return step;
}

using RollingControl = stickslip_rolling_control;
/// Spin or moment of rolling bodies, a different type than the load along an axis.
struct SpinControl {
    stickslip_rolling_control about;
};
using CreepPoint = stickslip_creep_point;
using CreepForce = stickslip_creep_force;

inline RollingControl creepage(double value) { return {STICKSLIP_CREEPAGE, value}; }
inline RollingControl rolling_force(double value) { return {STICKSLIP_FORCE, value}; }
inline SpinControl spin(double value) { return {{STICKSLIP_SPIN, value}}; }
inline SpinControl moment(double value) { return {{STICKSLIP_MOMENT, value}}; }

/// Returns a load of rolling bodies: a creepage or a force along x and y, and a spin or a moment.
inline stickslip_rolling_load rolling(RollingControl x, RollingControl y = creepage(0.0),
                                      SpinControl about = spin(0.0)) {
    return {x, y, about.about, {}};
}

using Tractions = stickslip_tractions;
using Point = stickslip_point;
using Response = stickslip_response;

/// Returns tractions without shear; the samples are not copied.
inline Tractions tractions(Field pressure) { return {pressure.data(), nullptr, nullptr, pressure.size()}; }

/// Returns a pressure with tractions along x and y; the samples are not copied.
inline Tractions tractions(Field pressure, Field x, Field y) {
    if (x.size() != pressure.size() || y.size() != pressure.size()) {
        throw std::invalid_argument("pressure and tractions must have the same length");
    }
    return {pressure.data(), x.data(), y.data(), pressure.size()};
}

} // namespace stickslip

#endif // STICKSLIP_LOADS_HPP
