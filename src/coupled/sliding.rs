//! Sliding under a prescribed force if the friction capacity depends on the unknown pressure.

use crate::cgm::cone::ConeStart;
use crate::cgm::{Total, reduce};
use crate::contact::SolveContext;
use crate::coupled::increment::CoupledIncrement;
use crate::coupled::window_solver::CoupledRequest;
use crate::error::{Error, Result};
use crate::memory::fallible::TryClone;
use crate::report::Status;

/// Shift of the sliding solve, divided by the largest displacement. The directions of slip of the cells differ by the
/// inverse of this ratio.
const FAR: f64 = 1e6;
/// Least tolerance of the sliding solve. Round-off prevents smaller errors, because the slip of a cell is a small
/// difference between shift and displacement.
const LEAST_TOLERANCE: f64 = 1e-8;

impl CoupledIncrement {
    /// Solves for a force that may exceed the friction capacity. If the solve stalls, the function computes the force
    /// at which the bodies slide in the direction of the load. This force determines whether the prescribed force is an
    /// error.
    ///
    /// # Errors
    /// - [`Error::BeyondFrictionCapacity`] if the bodies slide under the force.
    /// - Errors of [`Self::solve_on_window`].
    pub(super) fn solve_or_slide(
        &mut self,
        task: CoupledRequest<'_>,
        start: ConeStart,
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        let (demand, datum) = (task.demand, task.datum);
        let outcome = self.solve_on_window(task, start, conditions);
        if !is_stalled(&outcome) {
            return outcome;
        }
        let [x, y] = demand.tangential.force();
        let force = x.hypot(y);
        let kept = self.tractions.try_clone()?;
        let slid = self.slide(task, [x / force, y / force], conditions);
        if slid.is_ok() {
            self.pressed.set(&self.tractions[0], demand.friction);
            let limit = self.pressed.limits.sum * self.bodies.grid().cell_area();
            if force >= limit {
                self.forget();
                return Err(Error::BeyondFrictionCapacity {
                    force,
                    limit,
                    remedy: self.pressed.limits.remedy,
                });
            }
        }
        self.tractions = kept;
        self.set_linear(demand.gap, datum);
        let patient = CoupledRequest {
            is_doubtful: false,
            ..task
        };
        self.solve_on_window(patient, ConeStart::Halves, conditions)
    }

    /// Solves for the tractions of bodies that slide in a direction.
    fn slide(
        &mut self,
        task: CoupledRequest<'_>,
        direction: [f64; 2],
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        let layout = self.bodies.grid_layout();
        let ([normal, ..], [demand, ..]) = (self.displacement(), &self.linear);
        // Under a prescribed approach the iterate may be arbitrary. The overlap of the bodies then bounds the largest
        // displacement.
        let largest = reduce::max(&layout, |i| match task.totals[0] {
            Total::Free => -demand[i],
            Total::Sum(_) | Total::Spring { .. } => normal[i].abs(),
        });
        let far = if largest > 0.0 { FAR * largest } else { 1.0 };
        for (linear, part) in self.linear[1..].iter_mut().zip(direction) {
            linear.fill(-far * part);
        }
        let [approach, ..] = task.multiplier;
        let sliding = CoupledRequest {
            totals: [task.totals[0], Total::Free, Total::Free],
            multiplier: [approach, 0.0, 0.0],
            is_doubtful: false,
            ..task
        };
        let settings = conditions.settings;
        let loosened = settings.tolerance(settings.tolerance.max(LEAST_TOLERANCE));
        self.solve_on_window(sliding, ConeStart::Halves, &mut conditions.under(&loosened))
    }
}

fn is_stalled(outcome: &Result<()>) -> bool {
    matches!(outcome, Err(Error::NotConverged(report)) if report.status == Status::Stalled)
}
