//! Corrections of the direction of slip, for slip that turns within the contact.
//!
//! The slip s of a step is the mean slip over the step. The traction at the end of the step opposes this mean. If the slip
//! turns, the direction of the traction lags by half a step. Forces then converge with first order in the step. The slip at
//! the end of the step is
//!
//! ```math
//! s_\text{end} = s + \tfrac12 (s - s') + O(d^2) ,
//! ```
//!
//! with the slip s' of the previous step at the previous position of the particle. A correction adds $`\tfrac12 (s - s')`$
//! of the last solution to the slip of cells that slip in both steps, and solves the problem again. The added term is
//! constant during a solve. Each solve is therefore monotone and has its certificate.

use crate::cgm::Settings;
use crate::contact::{SolveContext, has_iterate, with_counts_of};
use crate::error::{Error, Result};
use crate::numerics::cell_vector::{at, slices};
use crate::observer::Observer;
use crate::rolling::{RollingSolution, RollingSolver};
use crate::tangential::is_at_limit;

impl RollingSolver {
    /// Solves at the current spin and applies the prescribed number of corrections to the direction of slip. Stores the
    /// report of all passes in `passes`.
    pub(in crate::rolling) fn solve_at_spin(
        &mut self,
        settings: &Settings,
        solution: &mut RollingSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        for part in &mut self.engine.lag {
            part.fill(0.0);
        }
        let corrections = self.problem.options.slip_corrections;
        if corrections == 0 {
            let outcome = self.solve_pass(settings, solution, observer);
            self.engine
                .passes
                .clone_from(self.engine.workspace.report());
            return outcome;
        }
        let conditions = SolveContext::new(settings, observer);
        self.engine.passes.clear();
        for pass in 0..=corrections {
            if pass > 0 {
                let left = conditions.check_iterations_left(&mut self.engine.passes);
                solution.set_report(&self.engine.passes);
                left?;
                self.correct_direction();
            }
            let settings = conditions.with_remaining_limits(&self.engine.passes);
            let mut watch = with_counts_of(&self.engine.passes, &mut *conditions.observer);
            let outcome = self.solve_pass(&settings, solution, &mut watch);
            drop(watch);
            if !has_iterate(&outcome) {
                return outcome;
            }
            self.engine.passes.add_pass(self.engine.workspace.report());
            self.engine.passes.time = conditions.start.elapsed();
            solution.set_report(&self.engine.passes);
            if outcome.is_err() {
                return Err(Error::NotConverged(Box::new(self.engine.passes.clone())));
            }
        }
        Ok(())
    }

    /// Sets the correction to half the change of the slip since the previous step, in cells that slip in both steps.
    fn correct_direction(&mut self) {
        let (cells, step) = (self.engine.limits.len(), self.problem.step);
        let slips = |traction: &[Vec<f64>; 2], cell: usize| {
            let [x, y] = at(&slices(traction), cell);
            self.engine.limits[cell] > 0.0 && is_at_limit(x.hypot(y), self.engine.limits[cell])
        };
        for place in 0..cells {
            // The loop starts at the trailing edge, so that the upstream cell still contains its previous correction.
            let cell = if step.edge.is_positive() {
                place
            } else {
                cells - 1 - place
            };
            let before = step.before(cell);
            let before = before.filter(|before| slips(&self.engine.traction, *before));
            let lag = match before {
                Some(before) if slips(&self.engine.traction, cell) => {
                    let (now, before) = (self.slip_of_step(cell), self.slip_of_step(before));
                    [0, 1].map(|axis| 0.5 * (now[axis] - before[axis]))
                }
                _ => [0.0; 2],
            };
            for (part, lag) in self.engine.lag.iter_mut().zip(lag) {
                part[cell] = lag;
            }
        }
    }

    /// Returns the slip of a cell over a step in the last solution.
    pub(in crate::rolling) fn slip_of_step(&self, cell: usize) -> [f64; 2] {
        let slip = self.slip(cell);
        [0, 1].map(|axis| slip[axis] - self.engine.lag[axis].get(cell).unwrap_or(&0.0))
    }
}
