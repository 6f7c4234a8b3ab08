//! What the two methods share: products, limits, the examination of an iterate, the end.

use std::ops::ControlFlow;

use crate::cgm::certificate::{self, Certificate, violation};
use crate::cgm::watch::Watch;
use crate::cgm::{Constraint, Problem, Settings, State, Workspace, balance, reduce};
use crate::operator::Operator;
use crate::parallel::{self, Blocks, CHUNK, blocks};
use crate::report::{Iteration, Status};

/// Of the least stiffness there is but for constants: less is none, in single precision; and what is
/// taken for none, to get to the bounds in a step.
pub(super) const FLAT: f64 = 1e-3;
pub(super) const FLATTEST: f64 = 1e-30;

/// One solve under way.
pub(super) struct Run<'a, 'b, C: Operator, K, P: Operator> {
    pub(super) problem: &'a Problem<'b, C, K, P>,
    pub(super) watch: Watch<'a>,
    pub(super) x: &'a mut [f64],
    pub(super) workspace: &'a mut Workspace<C, P>,
    /// Whether `workspace.product` belongs to `x`.
    pub(super) is_fresh: bool,
    /// Free entries, as last examined.
    free: usize,
    /// Of the eigenvalues; zero if none is known.
    lower_bound: f64,
    /// Whether the total leaves no choice: the unknowns stand at their bounds.
    is_extreme: bool,
}

impl<'a, 'b, C: Operator, K: Constraint, P: Operator> Run<'a, 'b, C, K, P> {
    pub(super) fn new(
        problem: &'a Problem<'b, C, K, P>,
        settings: &'a Settings,
        x: &'a mut [f64],
        workspace: &'a mut Workspace<C, P>,
        observer: &'a mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send),
    ) -> Self {
        workspace.multiplier = 0.0;
        let watch = Watch::new(settings, observer, &mut workspace.report);
        Self {
            problem,
            watch,
            x,
            workspace,
            is_fresh: false,
            free: 0,
            // A bound that is no number, or negative, is none.
            lower_bound: problem.operator.lower_bound().max(0.0),
            is_extreme: false,
        }
    }

    pub(super) fn len(&self) -> usize {
        self.x.len()
    }

    /// Brings the start within its bounds and marks every entry.
    pub(super) fn mark_start(&mut self) {
        let constraint = &self.problem.constraint;
        let work = |task: usize, (values, marks): (Blocks<'_, f64>, Blocks<'_, State>)| {
            for ((i, value), state) in (task * CHUNK..).zip(values.items).zip(marks.items) {
                let [lower, upper] = constraint.bounds(i);
                *value = constraint.project(i, *value);
                *state = if lower >= upper {
                    State::Fixed
                } else if *value <= lower {
                    State::Lower
                } else if *value >= upper {
                    State::Upper
                } else {
                    State::Free
                };
            }
        };
        let tasks = self.x.len().div_ceil(CHUNK);
        let data = (blocks(self.x), blocks(&mut self.workspace.state));
        parallel::sweep(0..tasks, data, &work, &|(), ()| ());
        self.is_fresh = false;
    }

    /// `image = C direction`.
    pub(super) fn apply_to_direction(&mut self) {
        let Workspace {
            operator,
            direction,
            image,
            report,
            ..
        } = &mut *self.workspace;
        self.problem.operator.apply([direction], [image], operator);
        report.convolutions += 1;
    }

    /// `image = C direction`, to single precision.
    pub(super) fn apply_roughly_to_direction(&mut self) {
        let Workspace {
            operator,
            direction,
            image,
            report,
            ..
        } = &mut *self.workspace;
        self.problem
            .operator
            .apply_f32([direction], [image], operator);
        report.rough_convolutions += 1;
    }

    /// The curvature that takes a direction `d` of `square = d' d` on the free entries to their bounds, if
    /// its own, `d' C d`, is none: an operator that maps constants to zero lets all entries together slide.
    pub(super) fn slide(&self, free: usize, curvature: f64, square: f64) -> Option<f64> {
        let stiffness = self.lower_bound * square;
        let slides = self.problem.total.is_none() && free == self.len();
        (slides && curvature < FLAT * stiffness).then_some(FLATTEST * stiffness)
    }

    /// `product = C x`, `gradient = C x + b`.
    pub(super) fn refresh(&mut self) {
        let Workspace {
            operator,
            product,
            report,
            ..
        } = &mut *self.workspace;
        self.problem.operator.apply([self.x], [product], operator);
        report.convolutions += 1;
        self.form_gradient();
        self.is_fresh = true;
    }

    /// The same to single precision: enough to go on by, not to end by.
    pub(super) fn refresh_roughly(&mut self) {
        let Workspace {
            operator,
            product,
            report,
            ..
        } = &mut *self.workspace;
        self.problem
            .operator
            .apply_f32([self.x], [product], operator);
        report.rough_convolutions += 1;
        self.form_gradient();
    }

    fn form_gradient(&mut self) {
        let Workspace {
            product, gradient, ..
        } = &mut *self.workspace;
        let (product, linear) = (&*product, self.problem.linear);
        parallel::update(gradient, |first, chunk| {
            let terms = product[first..].iter().zip(&linear[first..]);
            for (value, (u, b)) in chunk.iter_mut().zip(terms) {
                *value = u + b;
            }
        });
    }

    /// Examines the iterate by the product at hand, and writes the findings to the report. They are certain only if
    /// that product is [fresh](Self::is_fresh).
    pub(super) fn examine(&mut self) -> Certificate {
        let findings = certificate::examine(
            self.x,
            &self.workspace.product,
            self.problem.linear,
            &self.problem.constraint,
            self.problem.total,
            self.workspace.multiplier,
            self.lower_bound,
        );
        findings.write_to(&mut self.workspace.report);
        self.free = findings.free;
        findings
    }

    /// What has to fall to the tolerance.
    pub(super) fn merit(&self, findings: &Certificate) -> f64 {
        findings.merit(self.lower_bound)
    }

    /// Records an examined step, and says if it is the last: converged or stopped.
    pub(super) fn judge(&mut self, merit: f64, free: usize) -> ControlFlow<Status> {
        self.watch.judge(merit, free, &mut self.workspace.report)
    }

    /// Counts a step.
    pub(super) fn count_step(&mut self) {
        self.watch.count_step(&mut self.workspace.report);
    }

    /// Asks observer, clock and limit whether to take another step.
    pub(super) fn proceed(&mut self) -> ControlFlow<Status> {
        self.watch.proceed(self.free, &self.workspace.report)
    }

    /// Asks observer and clock alone whether to go on.
    pub(super) fn ask(&mut self) -> ControlFlow<Status> {
        self.watch.ask(self.free, &self.workspace.report)
    }

    /// The multiplier at which nothing drives the unknowns from an allowed zero, if there is one. An
    /// iteration towards zero would have no size left to measure its residual by.
    pub(super) fn multiplier_at_zero(&self) -> Option<f64> {
        let Problem {
            linear,
            constraint,
            total,
            ..
        } = self.problem;
        let can_move = |i: &usize| {
            let [lower, upper] = constraint.bounds(*i);
            lower < upper
        };
        let multiplier = match total {
            None => 0.0,
            Some(0.0) => (0..self.len()).find(can_move).map_or(0.0, |i| linear[i]),
            Some(_) => return None,
        };
        let rests = |i: usize| {
            let gradient = linear[i] - multiplier;
            let is_at_rest = match total {
                None => violation(0.0, constraint.bounds(i), gradient) == 0.0,
                Some(_) => gradient == 0.0 || !can_move(&i),
            };
            is_at_rest && constraint.project(i, 0.0) == 0.0
        };
        (0..self.len()).all(rests).then_some(multiplier)
    }

    pub(super) fn at_zero(&mut self, multiplier: f64) -> Status {
        self.x.fill(0.0);
        self.refresh();
        self.workspace.multiplier = multiplier;
        Status::Converged
    }

    /// The only feasible point when the total is the least or the greatest the bounds allow; the
    /// multiplier is the one at which the first entry would move.
    pub(super) fn at_extreme(&mut self, side: State) -> Status {
        let constraint = &self.problem.constraint;
        parallel::update(self.x, |first, chunk| {
            for (i, value) in (first..).zip(chunk) {
                let [lower, upper] = constraint.bounds(i);
                *value = if side == State::Lower { lower } else { upper };
            }
        });
        self.is_extreme = true;
        self.refresh();
        let sign = if side == State::Lower { 1.0 } else { -1.0 };
        let gradient = &self.workspace.gradient;
        let onset = reduce::least(self.x.len(), |i| {
            let [lower, upper] = constraint.bounds(i);
            (lower < upper).then(|| sign * gradient[i])
        });
        self.workspace.multiplier = onset.map_or(0.0, |(_, value)| sign * value);
        Status::Converged
    }

    /// Moves the iterate within its bounds and to its total, if it is not there but for round-off;
    /// its product is then fresh.
    pub(super) fn make_feasible(&mut self) {
        let constraint = &self.problem.constraint;
        let x = &*self.x;
        let [outside] = reduce::max(x.len(), |i| [(constraint.project(i, x[i]) - x[i]).abs()]);
        if outside > 0.0 {
            parallel::update(self.x, |first, chunk| {
                for (i, value) in (first..).zip(chunk) {
                    *value = constraint.project(i, *value);
                }
            });
            self.is_fresh = false;
        }
        // At an extreme the bounds themselves are the total.
        if let (Some(total), false) = (self.problem.total, self.is_extreme) {
            let x = &*self.x;
            let [sum, magnitude] = reduce::sums(x.len(), |i| [x[i], x[i].abs()]);
            if (total - sum).abs() > 1e-13 * magnitude {
                let state = &self.workspace.state;
                let is_free = |i: usize| state[i] == State::Free;
                if !balance::restore(self.x, constraint, is_free, total) {
                    balance::restore(self.x, constraint, |_| true, total);
                }
                self.is_fresh = false;
            }
        }
        if !self.is_fresh {
            self.refresh();
        }
    }

    /// Leaves a feasible iterate, and a report computed from it: what that shows is the last word.
    pub(super) fn finish(&mut self, status: Status) -> Status {
        self.make_feasible();
        let findings = self.examine();
        let merit = self.merit(&findings);
        self.watch.finish(status, merit, &mut self.workspace.report)
    }
}
