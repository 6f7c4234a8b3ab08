//! How far the pressure of the cells is from that of infinitely small ones.

use crate::grid::discretisation::estimate;
use crate::normal::NormalSolution;
use crate::warning::Warning;

impl NormalSolution {
    /// An estimate of the discretisation error of the pressure: the sum of its differences from the means of the exact pressure
    /// over the cells, relative to the sum of the pressure. `None` without contact, and on a slab of a grid that ranks share.
    ///
    /// ```math
    /// \frac{\sum |p - \bar p|}{\sum p} \approx f\,\frac{\sum |\Delta_h p|}{24 \sum p}, \qquad
    /// \Delta_h p = p_{i-1,j} + p_{i+1,j} + p_{i,j-1} + p_{i,j+1} - 4\,p_{i,j}
    /// ```
    ///
    /// with f = 1.4 for [uniform cells](crate::CellValue::Uniform), 1 for [values at the centres](crate::CellValue::Centre) and
    /// 1.25 on grids with [`Boundary::Periodic`](crate::Boundary::Periodic): inside the second difference is what the cells
    /// miss, and at the edge of the contact it is as large as it. It is an estimate, no bound; a solver's
    /// [certificate](crate::Report) is a bound of another error, that of the solution on the given cells. It falls with the
    /// power 3/2 of the cells. Compared with exact means:
    ///
    /// | contact | estimate over error |
    /// |---|---|
    /// | spheres, ellipses, gaps r^4, partial slip; anywhere between 16 to 48 cells over three contact radii | 0.8 to 1.35 |
    /// | the same on 96 to 192 cells | 0.9 to 1.15 |
    /// | the same in the middle of a cell, where errors cancel, on 16 to 48 cells | 0.7 to 1.7 |
    /// | ellipses of 5 to 1 whose short axis is 3 cells long, along the grid | 0.8 to 1.5 |
    /// | rough surfaces, shortest wave of 5 to 24 cells, that repeat | 0.9 to 1.25 |
    /// | the same on free grids, 50 to 700 cells in contact | 0.7 to 1.4 |
    /// | straight edges along the lines of the grid | 0.4 to 4, by where they fall |
    /// | flat punch, whose pressure is infinite at the edge | 0.3 to 0.4 |
    ///
    /// The error at the centres of the cells is half to nine tenths of that of the means.
    ///
    /// Approach, shift and energy have no such estimate. Their errors are 1e-3 to 1e-6 on 32 to 128 cells over three contact
    /// radii, and of either sign, by where the edge falls between the cells. The difference from a solve on half the cells
    /// tells that of the approach of uniform cells only: a third of it is 0.4 to 1.2 times the error on 64 and 128 cells
    /// (a sphere and an ellipse 2:1 at 8 places each). Of the approach of centre values, of energies, of the shift in
    /// partial slip and of rough surfaces the quotient lies anywhere between -100 and 60, also for other orders.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(64, 3.0)?;
    /// let pair = ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?;
    /// let (ball, load) = (surface::sphere(grid, 1.0)?, NormalControl::Force(4.0 / 3.0));
    /// let bodies = HalfSpace::new(grid, pair)?;
    /// let contact = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
    /// let estimate = contact.discretisation_estimate().unwrap_or(0.0);
    /// assert!((estimate - 0.0043).abs() < 0.0005); // the error is 0.0042
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn discretisation_estimate(&self) -> Option<f64> {
        estimate([&self.pressure], self.boundary, self.cell_value())
    }

    /// What the estimate has to be remarked on.
    pub(super) fn discretisation_warning(&self) -> Option<Warning> {
        let contact = || self.contact_map().mean_spot();
        Warning::of_discretisation(self.discretisation_estimate(), contact)
    }
}
