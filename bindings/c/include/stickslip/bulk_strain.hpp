// Relative displacement due to a uniform strain of the bodies.

#ifndef STICKSLIP_BULK_STRAIN_HPP
#define STICKSLIP_BULK_STRAIN_HPP

#include <cstddef>
#include <vector>

#include "bodies.hpp"

namespace stickslip {

/// Displacement of body 1 relative to body 2 in each cell (lengths), a pattern for solvers and histories.
struct RelativeDisplacement {
    std::vector<double> x, y;
    /// Returns pointers to the arrays, which are valid until the arrays are changed or destroyed.
    stickslip_relative_displacement pattern() const & { return {x.data(), y.data(), x.size()}; }
};

/// Returns the displacement due to a uniform bulk strain, the strain of body 1 minus that of body 2. It is positive if body 1
/// is stretched; xy is half of the engineering shear strain. The displacement is zero at the origin of the grid. Throws
/// STICKSLIP_NOT_FINITE if a component is not finite, and STICKSLIP_INVALID_ARGUMENT for a component along a periodic axis.
inline RelativeDisplacement bulk_strain(const HalfSpace &bodies, double xx, double xy, double yy) {
    const stickslip_grid grid = bodies.grid();
    const std::size_t cells = grid.nx * grid.ny;
    RelativeDisplacement found{std::vector<double>(cells), std::vector<double>(cells)};
    check(stickslip_bulk_strain(bodies.get(), xx, xy, yy, found.x.data(), found.y.data(), cells));
    return found;
}

} // namespace stickslip

#endif // STICKSLIP_BULK_STRAIN_HPP
