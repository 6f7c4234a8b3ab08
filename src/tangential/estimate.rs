//! How far the tractions of the cells are from those of infinitely small ones.

use crate::grid::discretisation::estimate;
use crate::tangential::TangentialSolution;

impl TangentialSolution {
    /// An estimate of the discretisation error of the tractions, as that of the pressure
    /// ([`NormalSolution::discretisation_estimate`](crate::NormalSolution::discretisation_estimate)): the sum of the magnitudes
    /// of the errors over that of the magnitudes of the tractions, both components together. `None` without traction, and on a
    /// slab of a grid that ranks share.
    ///
    /// The table lists the estimate over the error of the means in partial slip, on N x N cells over three contact radii. The
    /// contacts are a sphere, a gap r^4 and an ellipse 2 : 1, each at six places between the cells and at 10 to 90 % of the
    /// sliding force.
    ///
    /// | slip ring | N | values at the centres | uniform cells |
    /// |---|---|---|---|
    /// | one cell or more | 48 to 192 | 0.78 to 1.29 | 0.86 to 1.15 |
    /// | one cell or more | 32 | 0.77 to 1.23 | 0.85 to 1.13 |
    /// | one cell or more | 24 | 0.81 to 1.57 | 0.84 to 1.27 |
    /// | half a cell to one cell | 24 to 128 | 0.57 to 1.46 | 0.67 to 1.19 |
    /// | less than half a cell | 24 to 64 | 0.43 to 0.88 | 0.58 to 1.03 |
    ///
    /// The ring of an ellipse is that at its longer half axis. Ratios of spheres lie between 0.81 and 1.23 for values at the
    /// centres of 48 cells or more. A traction that changes its sign from cell to cell,
    /// as after many reversals, has more error at its many edges than one of the same sum.
    #[must_use]
    pub fn discretisation_estimate(&self) -> Option<f64> {
        estimate(self.traction(), self.boundary(), self.cell_value())
    }
}
