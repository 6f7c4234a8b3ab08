//! Cells that enter the contact lag behind their motion by $`\kappa g\,q/p`$.
//!
//! The lag depends on the pressure that is sought. With $`r = q/p`$ its change is $`\kappa g/p\,(dq - r\,dp)`$; a cell that
//! slips from the moment it touches has $`r = m'(0)\,n`$ while its pressure is zero.

use crate::buffer;
use crate::cgm::cone::law::{Kind, Law};
use crate::cgm::cone::{Cone, ConeProblem, ConeRun, N};
use crate::cgm::reduce;
use crate::cgm::vector::{at, plus, slices, update_cells};
use crate::error::Result;
use crate::operator::Operator;
use crate::parallel;

/// Part of the largest pressure that stands for a smaller one in `kappa g / p`.
const LEAST: f64 = 1e-9;

impl<C, P, F: Cone> ConeProblem<'_, C, P, F> {
    /// $`\kappa g`$ of a cell.
    pub(super) fn closing_of(&self, cell: usize) -> f64 {
        self.closing.map_or(0.0, |closing| closing[cell])
    }

    /// Traction over pressure of a cell.
    fn ratio(&self, cell: usize, law: Law, [p, x, y]: [f64; N]) -> [f64; 2] {
        match law.kind {
            _ if p > 0.0 => [x / p, y / p],
            Kind::Slip(slip) => slip.normal.map(|n| self.friction.slope(cell, 0.0) * n),
            Kind::Open | Kind::Smooth | Kind::Stick => [0.0; 2],
        }
    }
}

impl<C: Operator<N>, P: Operator<N>, F: Cone> ConeRun<'_, '_, C, P, F> {
    /// Makes room for what the cells have of their own.
    pub(super) fn make_own(&mut self, cells: usize) -> Result<()> {
        let w = &mut *self.workspace;
        w.own.clear();
        w.ratio.clear();
        buffer::resize(&mut w.own, cells, 0.0)?;
        buffer::resize(&mut w.ratio, cells, [0.0; 2])
    }

    /// Finds traction over pressure of the cells.
    pub(super) fn set_ratios(&mut self) {
        let (problem, w) = (self.problem, &mut *self.workspace);
        let (x, laws) = (slices(&self.x), &w.laws);
        parallel::update(&mut w.ratio, |first, ratios| {
            for (i, ratio) in (first..).zip(ratios) {
                *ratio = problem.ratio(i, laws[i], at(&x, i));
            }
        });
    }

    /// Finds what the cells have of their own at the present pressure, and adds the lag to the product.
    pub(super) fn refresh_lag(&mut self) {
        let problem = self.problem;
        let Some(closing) = problem.closing else {
            return;
        };
        let pressure = &*self.x[0];
        let least = LEAST * reduce::max(problem.layout, |i| pressure[i]);
        parallel::update(&mut self.workspace.own, |first, own| {
            for (i, own) in (first..).zip(own) {
                *own = match closing[i] {
                    0.0 => 0.0,
                    closing => (closing / pressure[i].max(least)).min(f64::MAX),
                };
            }
        });
        self.set_ratios();
        self.add_lag(1.0);
    }

    /// Adds so many times the lag, as it was last found, to the product.
    pub(super) fn add_lag(&mut self, part: f64) {
        let (problem, w) = (self.problem, &mut *self.workspace);
        let Some(closing) = problem.closing else {
            return;
        };
        let ratio = &w.ratio;
        let [_, along_x, along_y] = &mut w.product;
        update_cells(&mut [&mut **along_x, &mut **along_y], |i, u| {
            plus(u, part * closing[i], ratio[i])
        });
    }

    /// Adds to the image what changes of the tractions change of the lag.
    pub(super) fn add_change_of_lag(&mut self) {
        let w = &mut *self.workspace;
        if w.own.is_empty() {
            return;
        }
        let (own, ratio, d) = (&w.own, &w.ratio, slices(&w.direction));
        let [_, along_x, along_y] = &mut w.image;
        update_cells(&mut [&mut **along_x, &mut **along_y], |i, u| {
            let [dp, dx, dy] = at(&d, i);
            plus(u, own[i], plus([dx, dy], -dp, ratio[i]))
        });
    }
}
