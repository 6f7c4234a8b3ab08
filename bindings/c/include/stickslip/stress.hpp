// Stress and displacement below the surface, and closed-form solutions.

#ifndef STICKSLIP_STRESS_HPP
#define STICKSLIP_STRESS_HPP

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "bodies.hpp"

namespace stickslip {

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

/// Returns displacement and stress of STICKSLIP_BODY_1 or STICKSLIP_BODY_2 at points; the body must not be coated.
inline std::vector<Response> stress_at(const HalfSpace &bodies, std::int32_t body, const Tractions &tractions,
                                       const std::vector<Point> &points) {
    std::vector<Response> responses(points.size());
    check(stickslip_stress_at_points(bodies.get(), body, &tractions, points.data(), points.size(), responses.data()));
    return responses;
}

/// Planes at chosen depths below each body. The fields are those of the last solved plane.
class Planes {
  public:
    Planes(const HalfSpace &bodies, const std::vector<double> &depths, bool with_displacements = false)
        : own_(detail::made<Own>([&](auto **out) {
              return stickslip_planes_new(bodies.get(), depths.data(), depths.size(), with_displacements ? 1 : 0, out);
          })) {}

    void solve(std::size_t index, std::int32_t body, const Tractions &tractions) {
        check(stickslip_planes_solve(own_.get(), index, body, &tractions));
    }
    /// Returns a field, STICKSLIP_STRESS_XX to STICKSLIP_STRESS_YZ or STICKSLIP_DISPLACEMENT_X to STICKSLIP_DISPLACEMENT_Z.
    Field field(std::int32_t which) const {
        return detail::viewed<double>(
            [&](std::size_t *size) { return stickslip_planes_field(own_.get(), which, size); });
    }
    /// Returns STICKSLIP_VON_MISES, STICKSLIP_MAX_SHEAR or STICKSLIP_HYDROSTATIC of each cell.
    std::vector<double> measure(std::int32_t which) const {
        std::vector<double> values(field(STICKSLIP_STRESS_XX).size());
        check(stickslip_planes_measure(own_.get(), which, values.data(), values.size()));
        return values;
    }

  private:
    using Own = detail::Owned<stickslip_planes, stickslip_planes_free>;
    Own own_;
};

/// Returns the Hertz contact of a sphere under a normal force.
inline stickslip_hertz hertz_sphere(const HalfSpace &bodies, double radius, double force) {
    return detail::asked<stickslip_hertz>(
        [&](auto *out) { return stickslip_hertz_sphere(bodies.get(), radius, force, out); });
}

/// Returns the Cattaneo-Mindlin contact of a sphere under a normal and a tangential force.
inline stickslip_cattaneo_mindlin cattaneo_mindlin_sphere(const HalfSpace &bodies, double radius, double force,
                                                          double friction, double tangential_force) {
    return detail::asked<stickslip_cattaneo_mindlin>([&](auto *out) {
        return stickslip_cattaneo_mindlin_sphere(bodies.get(), radius, force, friction, tangential_force, out);
    });
}

} // namespace stickslip

#endif // STICKSLIP_STRESS_HPP
