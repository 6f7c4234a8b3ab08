// Gaps, rough surfaces and their statistics.

#ifndef STICKSLIP_SURFACE_HPP
#define STICKSLIP_SURFACE_HPP

#include <vector>

#include "core.hpp"

namespace stickslip {

/// Returns the gap between a sphere and a plane.
inline std::vector<double> sphere(const Grid &grid, double radius) {
    std::vector<double> gap(grid.nx * grid.ny);
    check(stickslip_surface_sphere(&grid, radius, gap.data(), gap.size()));
    return gap;
}

/// Returns the gap between an ellipsoid with the radii of curvature radius_x and radius_y at the origin, and a plane.
inline std::vector<double> ellipsoid(const Grid &grid, double radius_x, double radius_y) {
    std::vector<double> gap(grid.nx * grid.ny);
    check(stickslip_surface_ellipsoid(&grid, radius_x, radius_y, gap.data(), gap.size()));
    return gap;
}

/// Returns the gap between a cylinder along y and a plane.
inline std::vector<double> cylinder(const Grid &grid, double radius) {
    std::vector<double> gap(grid.nx * grid.ny);
    check(stickslip_surface_cylinder(&grid, radius, gap.data(), gap.size()));
    return gap;
}

using SelfAffine = stickslip_self_affine;
using Statistics = stickslip_statistics;

/// Returns the heights of a random surface; its gap to a plane is a constant minus the height. The observer is called before
/// each transform of the surface.
inline std::vector<double> self_affine(const Grid &grid, const SelfAffine &surface, const Observe &observe = nullptr) {
    std::vector<double> heights(grid.nx * grid.ny);
    detail::Watch(observe).run([&](const stickslip_observer *observer) {
        return stickslip_surface_self_affine_observed(&grid, &surface, observer, heights.data(), heights.size());
    });
    return heights;
}

/// Returns the statistics of heights.
inline Statistics statistics(const Grid &grid, const FieldArgument &heights) {
    Statistics found{};
    check(stickslip_surface_statistics(&grid, heights.data(), heights.size(), &found));
    return found;
}

} // namespace stickslip

#endif // STICKSLIP_SURFACE_HPP
