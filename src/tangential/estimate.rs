//! How far the tractions of the cells are from those of infinitely small ones.

use crate::discretisation::estimate;
use crate::tangential::TangentialSolution;

impl TangentialSolution {
    /// An estimate of the discretisation error of the tractions, as that of the pressure
    /// ([`NormalSolution::discretisation_estimate`](crate::NormalSolution::discretisation_estimate)): the sum of the magnitudes
    /// of the errors over that of the magnitudes of the tractions, both components together. `None` without traction, and on a
    /// slab of a grid that ranks share.
    ///
    /// In partial slip on a sphere, at 20 to 80 % of the sliding force, it is 0.9 to 1.05 times the error of the means on 48 to 192
    /// cells over three contact radii, and 0.74 to 1.02 times on 24. A traction that changes its sign from cell to cell,
    /// as after many reversals, has more error at its many edges than one of the same sum.
    #[must_use]
    pub fn discretisation_estimate(&self) -> Option<f64> {
        estimate(self.traction(), self.boundary(), self.cell_value())
    }
}
