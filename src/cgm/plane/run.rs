//! One solve of a problem in the plane under way: products, examination, the end.

use std::ops::ControlFlow;

use crate::cgm::certificate::Certificate;
use crate::cgm::plane::certificate::examine;
use crate::cgm::plane::disc::{at, both, both_mut, dot, norm, restore};
use crate::cgm::plane::{Problem, Workspace, update_cells};
use crate::cgm::watch::Watch;
use crate::cgm::{Settings, reduce};
use crate::operator::Operator;
use crate::parallel;
use crate::report::{Iteration, Status};

pub(super) struct Run<'a, 'b, C: Operator<2>, P: Operator<2>> {
    pub(super) problem: &'a Problem<'b, C, P>,
    pub(super) watch: Watch<'a>,
    pub(super) q: &'a mut [f64],
    pub(super) workspace: &'a mut Workspace<C, P>,
    /// Whether `workspace.product` belongs to `q`.
    pub(super) is_fresh: bool,
    pub(super) lower_bound: f64,
    /// Cells within their limits, as last examined.
    free: usize,
    /// Whether the totals leave no choice.
    is_at_limit: bool,
}

impl<'a, 'b, C: Operator<2>, P: Operator<2>> Run<'a, 'b, C, P> {
    pub(super) fn new(
        problem: &'a Problem<'b, C, P>,
        settings: &'a Settings,
        q: &'a mut [f64],
        workspace: &'a mut Workspace<C, P>,
        observer: &'a mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send),
    ) -> Self {
        workspace.multiplier = [0.0; 2];
        Self {
            watch: Watch::new(settings, observer, &mut workspace.report),
            lower_bound: problem.operator.lower_bound().max(0.0),
            problem,
            q,
            workspace,
            is_fresh: false,
            free: 0,
            is_at_limit: false,
        }
    }

    pub(super) fn cells(&self) -> usize {
        self.problem.limits.len()
    }

    /// `product = C q`, `gradient = C q + b`; to single precision that is enough to go on by, not to end by.
    pub(super) fn refresh(&mut self, is_rough: bool) {
        let Workspace {
            operator,
            product,
            gradient,
            report,
            ..
        } = &mut *self.workspace;
        if is_rough {
            self.problem
                .operator
                .apply_f32(both(self.q), both_mut(product), operator);
            report.rough_convolutions += 1;
        } else {
            self.problem
                .operator
                .apply(both(self.q), both_mut(product), operator);
            report.convolutions += 1;
        }
        let (product, linear) = (&*product, self.problem.linear);
        parallel::update(gradient, |first, chunk| {
            let terms = product[first..].iter().zip(&linear[first..]);
            for (value, (u, b)) in chunk.iter_mut().zip(terms) {
                *value = u + b;
            }
        });
        self.is_fresh = !is_rough;
    }

    /// `image = C direction`.
    pub(super) fn apply_to_direction(&mut self, is_rough: bool) {
        let Workspace {
            operator,
            direction,
            image,
            report,
            ..
        } = &mut *self.workspace;
        if is_rough {
            self.problem
                .operator
                .apply_f32(both(direction), both_mut(image), operator);
            report.rough_convolutions += 1;
        } else {
            self.problem
                .operator
                .apply(both(direction), both_mut(image), operator);
            report.convolutions += 1;
        }
    }

    pub(super) fn count_step(&mut self) {
        self.watch.count_step(&mut self.workspace.report);
    }

    pub(super) fn proceed(&mut self) -> ControlFlow<Status> {
        self.watch.proceed(self.free, &self.workspace.report)
    }

    pub(super) fn ask(&mut self) -> ControlFlow<Status> {
        self.watch.ask(self.free, &self.workspace.report)
    }

    pub(super) fn judge(&mut self, merit: f64, free: usize) -> ControlFlow<Status> {
        self.watch.judge(merit, free, &mut self.workspace.report)
    }

    /// Examines the iterate with the product at hand, and writes the findings to the report.
    pub(super) fn examine(&mut self) -> Certificate {
        let Workspace {
            product,
            gradient,
            multiplier,
            ..
        } = &*self.workspace;
        let [x, y] = *multiplier;
        let slip = |i: usize| {
            let [gx, gy] = at(gradient, i);
            [gx - x, gy - y]
        };
        let Problem { limits, totals, .. } = *self.problem;
        let findings = examine(self.q, product, slip, limits, totals, self.lower_bound);
        findings.write_to(&mut self.workspace.report);
        self.free = findings.free;
        findings
    }

    /// What has to fall to the tolerance.
    pub(super) fn merit(&self, findings: &Certificate) -> f64 {
        findings.merit(self.lower_bound)
    }

    /// The multipliers at which nothing drives the tractions from zero, if there are any.
    pub(super) fn multiplier_at_zero(&self) -> Option<[f64; 2]> {
        let Problem {
            linear,
            totals,
            limits,
            ..
        } = self.problem;
        let first = (0..self.cells()).find(|&i| limits[i] > 0.0);
        let at_first = first.map_or([0.0; 2], |i| at(linear, i));
        let mut multiplier = [0.0; 2];
        for axis in 0..2 {
            match totals[axis] {
                None => {}
                Some(0.0) => multiplier[axis] = at_first[axis],
                Some(_) => return None,
            }
        }
        let rests = |i: usize| {
            let g = at(linear, i);
            limits[i] <= 0.0 || (0..2).all(|axis| g[axis] - multiplier[axis] == 0.0)
        };
        (0..self.cells()).all(rests).then_some(multiplier)
    }

    pub(super) fn at_zero(&mut self, multiplier: [f64; 2]) -> Status {
        self.q.fill(0.0);
        self.refresh(false);
        self.workspace.multiplier = multiplier;
        Status::Converged
    }

    /// Every cell at its limit along a direction, the only tractions of these totals; the multiplier is the
    /// slip-free motion of the cell that lets go last.
    pub(super) fn at_limit(&mut self, direction: [f64; 2]) -> Status {
        let limits = self.problem.limits;
        update_cells(self.q, |i, _| direction.map(|n| n * limits[i]));
        self.is_at_limit = true;
        self.refresh(false);
        let gradient = &self.workspace.gradient;
        let last = reduce::least(limits.len(), |i| {
            (limits[i] > 0.0).then(|| -dot(at(gradient, i), direction))
        });
        if let Some((cell, _)) = last {
            let (motion, totals) = (at(gradient, cell), self.problem.totals);
            // Where the motion is prescribed there is none beyond.
            self.workspace.multiplier =
                [0, 1].map(|axis| totals[axis].map_or(0.0, |_| motion[axis]));
        }
        Status::Converged
    }

    /// Moves the iterate within its discs and to its totals, if it is not there but for round-off; its
    /// product is then fresh.
    pub(super) fn make_feasible(&mut self) {
        let Problem { limits, totals, .. } = *self.problem;
        if !self.is_at_limit {
            let q = &*self.q;
            let [outside] = reduce::max(limits.len(), |i| {
                let excess = norm(at(q, i)) - limits[i];
                // A traction put on its circle may be a rounding outside.
                [(excess - 4.0 * f64::EPSILON * limits[i]).max(0.0)]
            });
            let [x, y, size] = reduce::sums(limits.len(), |i| {
                let q = at(q, i);
                [q[0], q[1], norm(q)]
            });
            let missing = |axis: usize, sum: f64| totals[axis].map_or(0.0, |total| total - sum);
            if outside > 0.0 || norm([missing(0, x), missing(1, y)]) > 1e-13 * size {
                restore(self.q, limits, totals);
                self.is_fresh = false;
            }
        }
        if !self.is_fresh {
            self.refresh(false);
        }
    }

    /// Leaves a feasible iterate, and a report computed from it: what that shows is the last word.
    pub(super) fn finish(&mut self, status: Status) -> Status {
        self.make_feasible();
        let findings = self.examine();
        let mut merit = self.merit(&findings);
        if self.is_at_limit {
            // No other tractions have these totals: nothing is left to be wrong but the totals. Slip is along
            // all of them only in the limit of a large motion.
            merit = findings.load_error;
            let report = &mut self.workspace.report;
            (report.residual, report.certified_gap) = (0.0, 0.0);
        }
        self.watch.finish(status, merit, &mut self.workspace.report)
    }
}
