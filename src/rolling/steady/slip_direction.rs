//! Corrections of the direction of slip, for slip that turns within the contact.
//!
//! The slip s of a step is a mean over the step, and the traction at the end of the step opposes it: where the slip turns,
//! the direction of the traction lags by half a step, and forces converge with first order in the step. The slip at the end
//! of the step is
//!
//! ```math
//! s_\text{end} = s + \tfrac12 (s - s') + O(d^2) ,
//! ```
//!
//! with the slip s' of the step before, at the place of the particle before. A correction solves the problem once more, with
//! $`\tfrac12 (s - s')`$ of the last solution added to the slip of cells that slip in both steps. The added term is fixed in
//! each solve, so that each is monotone and has its certificate.

use crate::cgm::Settings;
use crate::contact::{Conditions, with_counts_of};
use crate::error::Result;
use crate::memory::fallible;
use crate::numerics::cell_vector::{at, slices};
use crate::observer::Observer;
use crate::rolling::{RollingSolution, RollingSolver};
use crate::tangential::is_at_limit;

impl RollingSolver {
    /// Solves at the present spin, and corrects the direction of slip as often as the problem states. The report of all
    /// passes is in `passes`.
    pub(in crate::rolling) fn solve_at_spin(
        &mut self,
        settings: &Settings,
        solution: &mut RollingSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let corrections = self.problem.slip_corrections;
        self.lag.iter_mut().for_each(Vec::clear);
        if corrections == 0 {
            let outcome = self.solve_pass(settings, solution, observer);
            self.passes.clone_from(self.workspace.report());
            return outcome;
        }
        let conditions = Conditions::new(settings, observer);
        self.passes.clear();
        for pass in 0..=corrections {
            if pass > 0 {
                conditions.check_iterations_left(&mut self.passes)?;
                self.correct_direction()?;
            }
            let settings = conditions.left(&self.passes);
            let mut watch = with_counts_of(&self.passes, &mut *conditions.observer);
            let outcome = self.solve_pass(&settings, solution, &mut watch);
            drop(watch);
            self.passes.add_pass(self.workspace.report());
            self.passes.time = conditions.start.elapsed();
            solution.set_report(&self.passes);
            outcome?;
        }
        Ok(())
    }

    /// Takes half the change of the slip since the step before, in cells that slip in both steps.
    fn correct_direction(&mut self) -> Result<()> {
        let (cells, step) = (self.limits.len(), self.problem.step);
        let mut lag = fallible::vector(cells)?;
        let slips = |cell: usize| {
            let [x, y] = at(&slices(&self.traction), cell);
            self.limits[cell] > 0.0 && is_at_limit(x.hypot(y), self.limits[cell])
        };
        for cell in (0..cells).filter(|cell| slips(*cell)) {
            let Some(before) = step.before(cell).filter(|before| slips(*before)) else {
                continue;
            };
            let (now, before) = (self.slip_of_step(cell), self.slip_of_step(before));
            for axis in 0..2 {
                lag[axis][cell] = 0.5 * (now[axis] - before[axis]);
            }
        }
        self.lag = lag;
        Ok(())
    }

    /// Returns the slip of a cell over a step in the last solution.
    pub(in crate::rolling) fn slip_of_step(&self, cell: usize) -> [f64; 2] {
        let slip = self.slip(cell);
        [0, 1].map(|axis| slip[axis] - self.lag[axis].get(cell).unwrap_or(&0.0))
    }
}
