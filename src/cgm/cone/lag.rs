//! Entry compliance: cells that come into contact in the step lag behind their motion by $`\kappa g\,q/p`$.
//!
//! The lag depends on the unknown pressure. Its change is $`\kappa g/p\,(dq - r\,dp)`$ with $`r = q/p`$. If a cell slips from the
//! moment of contact, $`r = m'(0)\,n`$ while its pressure is zero.

use crate::cgm::cone::cell_state::{CellKind, ConeCellState, EntryLag};
use crate::cgm::cone::{ConeProblem, ConeRun, FrictionCone, N};
use crate::cgm::reduce;
use crate::numerics::cell_vector::{at, slices, update_cells};

/// Fraction of the largest pressure that replaces a smaller pressure in `kappa g / p`.
const LEAST: f64 = 1e-9;

impl<F: FrictionCone> ConeProblem<'_, F> {
    /// Returns the mean of $`\kappa g`$ over all directions for a cell.
    pub(super) fn closing_of(&self, cell: usize) -> f64 {
        self.closing.map_or(0.0, |closing| closing.mean(cell))
    }

    /// Returns the traction of a cell divided by its pressure.
    pub(super) fn ratio(&self, cell: usize, law: ConeCellState, [p, x, y]: [f64; N]) -> [f64; 2] {
        match law.kind {
            _ if p > 0.0 => [x / p, y / p],
            CellKind::Slip(slip) => slip.normal.map(|n| self.friction.slope(cell, 0.0) * n),
            CellKind::Open | CellKind::Frictionless | CellKind::Stick => [0.0; 2],
        }
    }
}

impl<F: FrictionCone> ConeRun<'_, '_, F> {
    /// Updates the entry compliance at the current pressure, and adds the lag to the product.
    pub(super) fn refresh_lag(&mut self) {
        let problem = self.problem;
        let Some(closing) = problem.closing else {
            return;
        };
        let x = slices(&self.x);
        let least = LEAST * reduce::max(problem.layout, |i| x[0][i]);
        self.workspace.linear.update_rows(|i, law| {
            let own = match closing.mean(i) {
                0.0 => 0.0,
                closing => (closing / x[0][i].max(least)).min(f64::MAX),
            };
            let per_pressure = if own > 0.0 {
                own / closing.mean(i)
            } else {
                0.0
            };
            law.lag = EntryLag {
                own,
                deviator: closing.deviator(i).map(|part| part * per_pressure),
                ratio: problem.ratio(i, *law, at(&x, i)),
            };
        });
        self.add_entry_compliance(1.0);
    }

    /// Adds `part` times the last computed lag to the product.
    pub(super) fn add_entry_compliance(&mut self, part: f64) {
        let (problem, w) = (self.problem, &mut *self.workspace);
        let Some(closing) = problem.closing else {
            return;
        };
        let laws = &w.linear.rows;
        let [_, along_x, along_y] = &mut w.product;
        update_cells(&mut [&mut **along_x, &mut **along_y], |i, u| {
            closing.added(u, part, i, laws[i].lag.ratio)
        });
    }
}
