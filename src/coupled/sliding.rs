//! Forces that slide the bodies, where what friction holds is known only with the pressure.

use crate::cgm::{Total, reduce};
use crate::contact::SolveContext;
use crate::coupled::increment::CoupledIncrement;
use crate::coupled::window_solver::{CoupledRequest, CoupledStart};
use crate::error::{Error, Result, SLIDE};
use crate::memory::fallible::TryClone;
use crate::report::Status;

/// Shift at which the bodies slide, over the largest displacement: the slip of the cells differs in direction by one over
/// it.
const FAR: f64 = 1e6;
/// Least tolerance of that: the slip of the cells is what displacements leave of the shift.
const LEAST_TOLERANCE: f64 = 1e-8;

impl CoupledIncrement {
    /// Solves for a force that may be beyond friction. Where that stalls, the force at which the bodies slide in its
    /// direction decides.
    ///
    /// # Errors
    /// [`Error::BeyondFrictionCapacity`]; as [`Self::solve_on_window`].
    pub(super) fn solve_or_slide(
        &mut self,
        task: CoupledRequest<'_>,
        start: CoupledStart,
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
                    remedy: SLIDE,
                });
            }
        }
        self.tractions = kept;
        self.set_linear(demand.gap, datum);
        let patient = CoupledRequest {
            is_doubtful: false,
            ..task
        };
        self.solve_on_window(patient, CoupledStart::Halves, conditions)
    }

    /// The tractions of bodies that slide in a direction.
    fn slide(
        &mut self,
        task: CoupledRequest<'_>,
        direction: [f64; 2],
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        let layout = self.bodies.grid_layout();
        let ([normal, ..], [demand, ..]) = (self.displacement(), &self.linear);
        // The iterate of a prescribed approach may be anything; its overlap is the largest displacement.
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
        self.solve_on_window(
            sliding,
            CoupledStart::Halves,
            &mut conditions.under(&loosened),
        )
    }
}

fn is_stalled(outcome: &Result<()>) -> bool {
    matches!(outcome, Err(Error::NotConverged(report)) if report.status == Status::Stalled)
}
