//! Semismooth Newton method: an outer loop that updates the sets and an inner loop of unclipped preconditioned conjugate
//! gradients.
//!
//! Each outer step measures the residual, in single precision while the residual is large. The step then solves the linear
//! problem of the moving cells to a moderate accuracy. These cells may violate their bounds. From this equilibrated state, the
//! step determines the next motion of all cells simultaneously. For intervals this is the primal-dual active-set method
//! (Hintermueller, Ito & Kunisch, SIAM J. Optim. 13 (2002) 865, <https://doi.org/10.1137/S1052623401383558>). For discs it is a
//! semismooth Newton method with the curvature of the circles in the linear problem.

use std::ops::ControlFlow;

use crate::cgm::active_set_solve::{ActiveSetSolve, SINGLE};
use crate::cgm::degenerate::BoundState;
use crate::cgm::law::state::{LinearisedSet, Row};
use crate::cgm::linear::BASES;
use crate::cgm::monitor::{INNER_REDUCTION, Progress};
use crate::cgm::totals::Total;
use crate::cgm::{Constraint, InitialGuess, MotionOf, reduce};
use crate::numerics::cell_vector::{at, minus, norm, slices, within};
use crate::report::Status;

/// Number of outer steps without progress that count as a cycle.
const CYCLE: usize = 12;
/// Number of outer steps without progress that count as a cycle with curved bounds, whose sets settle in fewer steps.
const CYCLE_CURVED: usize = 5;

/// Residual of an interpolated start below which its gradient identifies the sets.
const NEAR: f64 = 0.1;

/// Operations of a problem that Newton's method requires.
pub(super) trait NewtonSteps {
    /// Projects the start onto its sets.
    fn begin(&mut self) -> ControlFlow<Status>;

    /// Measures the residual of the optimality conditions. Breaks if the solve has ended.
    fn examine(&mut self) -> ControlFlow<Status, f64>;

    /// Returns whether the steps make no progress: the sets cycle.
    fn has_stalled(&mut self, merit: f64) -> bool;

    /// Sets up the linear problem for the current motion of the cells. Returns whether the linear problem has a
    /// solution.
    fn linearise(&mut self, merit: f64) -> ControlFlow<Status, bool>;

    /// Solves the linear problem and lets the cells leave their sets.
    fn solve_linear(&mut self, merit: f64) -> ControlFlow<Status>;

    /// Determines the next motion of all cells simultaneously from the equilibrated state, and projects the cells onto their
    /// sets.
    fn decide(&mut self) -> ControlFlow<Status>;

    /// Returns the final status of a problem whose sets cycle if its residual is round-off. Otherwise returns `None`.
    fn stuck(&self) -> Option<Status>;
}

/// Runs the semismooth Newton method. Returns the final status, or `None` if the sets cycle.
pub(super) fn newton(problem: &mut impl NewtonSteps) -> Option<Status> {
    match newton_steps(problem) {
        ControlFlow::Break(status) => Some(status),
        ControlFlow::Continue(()) => problem.stuck(),
    }
}

fn newton_steps(problem: &mut impl NewtonSteps) -> ControlFlow<Status> {
    problem.begin()?;
    loop {
        let merit = problem.examine()?;
        if problem.has_stalled(merit) || !problem.linearise(merit)? {
            return ControlFlow::Continue(());
        }
        problem.solve_linear(merit)?;
        problem.decide()?;
    }
}

impl<K: Constraint<N>, const N: usize> NewtonSteps for ActiveSetSolve<'_, '_, K, N> {
    fn begin(&mut self) -> ControlFlow<Status> {
        let cycle = if MotionOf::<K, N>::IS_CURVED {
            CYCLE_CURVED
        } else {
            CYCLE
        };
        self.progress = Progress::new(cycle, self.inner_reduction);
        self.is_near = self.start == InitialGuess::Interpolated;
        self.mark_and_measure()
    }

    fn examine(&mut self) -> ControlFlow<Status, f64> {
        if self.totals.is_well_posed() {
            self.set_multiplier();
        }
        let findings = self.certificate();
        self.displacement = findings.displacement;
        let mut merit = self.merit(&findings);
        let mut keeps_sets = true;
        if merit <= self.monitor.tolerance() {
            // Convergence is decided for the iterate that will be returned.
            let feasible = self.make_feasible();
            keeps_sets = feasible.keeps_sets;
            if !feasible.unchanged {
                let findings = self.certificate();
                merit = self.merit(&findings);
            }
            self.shown = self.monitor.is_last().then_some(merit);
        }
        self.monitor.check_termination(merit)?;
        self.shown = None;
        if !keeps_sets {
            // Some cells were far beyond their bounds. Moving these cells has pushed other cells off their bounds.
            self.mark_and_measure()?;
        }
        ControlFlow::Continue(merit)
    }

    fn has_stalled(&mut self, merit: f64) -> bool {
        let slip = self.mean_slip_of_all().unwrap_or(0.0);
        let is_stuck = self.progress.has_stalled(merit, slip);
        if is_stuck {
            self.inner_reduction = self.progress.inner_reduction;
        }
        is_stuck
    }

    fn linearise(&mut self, merit: f64) -> ControlFlow<Status, bool> {
        let tells_sets = std::mem::take(&mut self.is_near) && merit < NEAR;
        if tells_sets && self.reclassify().0 > 0 {
            self.list_and_spread();
            if self.totals.is_well_posed() {
                self.set_multiplier();
            }
        }
        self.measure(false);
        ControlFlow::Continue(self.totals.is_well_posed())
    }

    fn solve_linear(&mut self, merit: f64) -> ControlFlow<Status> {
        let mut reduction = self.progress.reduction(merit, self.monitor.tolerance());
        if self.product_error.is_finite() {
            // Steps that reduce the residual below the error of its product do not bring the iterate nearer to the solution.
            reduction = reduction.max((self.product_error / merit).min(INNER_REDUCTION));
        }
        // The steps change the displacements by about the residual. Products in single precision add the fraction `SINGLE` of
        // this change to the error of the gradient.
        let gradient_error = self.product_error + SINGLE * merit;
        let outcome = if self.problem.operator.is_symmetric() {
            self.conjugate_gradients(reduction)
        } else {
            self.gmres(reduction)
        };
        self.gradient_error = gradient_error;
        outcome
    }

    fn decide(&mut self) -> ControlFlow<Status> {
        let (changes, sums) = self.reclassify();
        self.progress.changes = changes;
        if MotionOf::<K, N>::IS_CURVED || changes > 0 {
            // Projection has moved unknowns in addition to the steps. If no cell has changed its state, the following correction
            // is only round-off of the sums.
            self.gradient_error = f64::INFINITY;
            self.list_and_spread();
        }
        self.spread_missing(sums);
        self.monitor.notify_observer()?;
        if !self.adopt_gradient() {
            if self.progress.single_precision_suffices() {
                self.refresh_f32();
            } else {
                self.refresh();
            }
        }
        ControlFlow::Continue(())
    }

    fn stuck(&self) -> Option<Status> {
        self.monitor.stuck()
    }
}

impl<K: Constraint<N>, const N: usize> ActiveSetSolve<'_, '_, K, N> {
    /// Solves the linear problem of the moving cells with GMRES and updates unknowns, gradient and multipliers.
    fn gmres(&mut self, reduction: f64) -> ControlFlow<Status> {
        self.product_error = f64::INFINITY;
        let border = self.totals.border;
        let (mut linear, mut moved) = self.parts();
        let w = &mut *linear.workspace;
        let cells = w.rows.len();
        linear
            .monitor
            .record_allocation_failure(w.make_room_for_gmres())?;
        let limits = (BASES, reduction);
        let solved = linear.solve(&border, [0.0; N], limits, &mut moved);
        let room = linear.workspace.make_room(cells);
        linear.monitor.record_allocation_failure(room)?;
        solved.map_continue(|_| ())
    }

    /// Projects the start onto its sets, brings it near its totals and computes a first gradient.
    ///
    /// Curved bounds are measured before any deficit of the totals is distributed. Without their stiffness, the tractions of tiny
    /// cells at the rim would reverse.
    fn mark_and_measure(&mut self) -> ControlFlow<Status> {
        self.mark_start();
        if MotionOf::<K, N>::IS_CURVED {
            if !self.is_fresh() {
                self.restore_totals(true);
                self.monitor.notify_observer()?;
                self.refresh_f32();
            }
            self.list_moving();
            self.set_mean_multiplier();
            self.hold_springs();
            self.measure(true);
            self.set_totals();
            return ControlFlow::Continue(());
        }
        self.hold_springs();
        self.list_moving();
        self.set_totals();
        if !self.is_fresh() {
            let sums = std::array::from_fn(|c| reduce::total(self.layout(), self.x[c]));
            self.spread_missing(sums);
            self.monitor.notify_observer()?;
            self.refresh_f32();
        }
        ControlFlow::Continue(())
    }

    /// Lists the moving cells and determines how the totals are distributed over them.
    fn list_and_spread(&mut self) {
        if !MotionOf::<K, N>::IS_STEADY {
            self.list_moving();
        }
        self.set_totals();
    }

    /// Lists the moving cells. If no cell moves, the iterate cannot change. In this case, cells are released unless no cell is
    /// pushed from its bound.
    fn list_moving(&mut self) {
        let w = &mut *self.workspace;
        if !MotionOf::<K, N>::IS_STEADY {
            w.linear.list_moving();
            if w.linear.moving.of_all_ranks() == 0 {
                match self.multiplier_at_bounds([1.0; N]) {
                    Some(BoundState::Rests) => {}
                    // Only cells that reduce the deficit are released. The other cells would return to their bounds in the next
                    // step.
                    Some(BoundState::Deficit(missing)) => self.release(|_, _| [-missing; N]),
                    Some(BoundState::Released) | None => {
                        if !self.is_fresh() {
                            self.refresh();
                        }
                        self.release(minus);
                    }
                }
                let w = &mut *self.workspace;
                w.linear.list_moving();
            }
        }
        let w = &mut *self.workspace;
        // The inner iteration writes the direction on the moving cells only. Components without a total have no spread.
        for part in &mut w.linear.direction {
            part.fill(0.0);
        }
        if N > 1 {
            w.linear.spread.fill([[0.0; N]; N]);
        }
        if let Some(sparse) = self.problem.sparse {
            self.is_scattered = w.linear.prepare(sparse);
        }
    }

    /// Releases the cells that are pushed off their bounds. `push` computes the pushing gradient from the gradient and the
    /// multiplier.
    fn release(&mut self, push: impl Fn([f64; N], [f64; N]) -> [f64; N] + Sync) {
        let w = &mut *self.workspace;
        let (gradient, multiplier) = (slices(&w.gradient), w.multiplier);
        w.linear.update_rows(|i, motion| {
            *motion = motion.released_from_bound(push(at(&gradient, i), multiplier));
        });
    }

    /// Sets the multipliers of the totals to the mean gradient on the free cells. If no cell is free, the mean over all moving
    /// cells is used. The multipliers of components without a total are zero.
    fn set_mean_multiplier(&mut self) {
        let w = &mut *self.workspace;
        let (motions, gradient) = (&w.linear.rows, slices(&w.gradient));
        let means: [([f64; N], f64); 2] = w.linear.moving.sweep((), |entries, ()| {
            let gradient = within(&gradient, &entries.chunk);
            entries.sums(|k, place| {
                let (g, nothing) = ((at(&gradient, place), 1.0), ([0.0; N], 0.0));
                if entries.row(motions, k, place).is_free() {
                    [g, nothing]
                } else {
                    [nothing, g]
                }
            })
        });
        let (sum, count) = if means[0].1 > 0.0 { means[0] } else { means[1] };
        let totals = self.problem.totals;
        w.multiplier = std::array::from_fn(|c| match totals[c] {
            Total::Free => 0.0,
            Total::Sum(_) | Total::Spring { .. } => sum[c] / count,
        });
    }

    /// Returns the length of the mean slip if the sets are settled and all cells slip under a prescribed sum.
    fn mean_slip_of_all(&self) -> Option<f64> {
        let is_settled = self.progress.changes == 0 && self.totals.has_sum() != [false; N];
        if !MotionOf::<K, N>::IS_CURVED || !is_settled || self.has_free_cell() {
            return None;
        }
        let w = &*self.workspace;
        let (gradient, multiplier) = (slices(&w.gradient), w.multiplier);
        let (sum, count): ([f64; N], f64) = w.linear.moving.sweep((), |entries, ()| {
            let gradient = within(&gradient, &entries.chunk);
            entries.sums(|_, place| (minus(at(&gradient, place), multiplier), 1.0))
        });
        Some(norm(sum) / count)
    }

    /// Measures the stiffness of every curved bound from the current gradient. Passes the stiffness to the preconditioner only if
    /// `weighed`.
    fn measure(&mut self, weighed: bool) {
        if !MotionOf::<K, N>::IS_CURVED {
            return;
        }
        let (problem, self_compliance) = (self.problem, self.self_compliance);
        let w = &mut *self.workspace;
        let (gradient, multiplier) = (slices(&w.gradient), w.multiplier);
        w.linear.update_rows(|i, motion| {
            let g = minus(at(&gradient, i), multiplier);
            *motion = problem.constraint.of(i).measured(*motion, g);
            if weighed {
                let own = problem.own.mean(i);
                *motion = motion.with_preconditioner_weight(self_compliance, own);
            }
        });
    }

    /// Determines the next motion of all cells simultaneously from the equilibrated state, and projects the cells onto their
    /// sets. Returns the number of changed cells and the sums of all unknowns.
    fn reclassify(&mut self) -> (usize, [f64; N]) {
        let problem = self.problem;
        // A gradient of the wrong sign below this value is noise of the inner solution. Without this threshold, cells would
        // alternate between two states.
        let noise = (0.01 * self.monitor.tolerance()).max(f64::EPSILON) * self.displacement;
        let self_compliance = self.self_compliance;
        self.product_error = f64::INFINITY;
        let w = &mut *self.workspace;
        let (gradient, multiplier) = (slices(&w.gradient), w.multiplier);
        let next = |cell: usize, was: MotionOf<K, N>, x: [f64; N]| {
            let g = minus(at(&gradient, cell), multiplier);
            let weighing = [self_compliance, problem.own.mean(cell)];
            (problem.constraint.of(cell)).next(was, x, g, noise, weighing)
        };
        w.linear.replace(problem.layout, &mut self.x, next)
    }
}
