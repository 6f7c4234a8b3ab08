//! Outer steps of the semismooth Newton method: measure, solve the linear system, update the state of all cells simultaneously.

use std::ops::ControlFlow;

use crate::cgm::active_set_solve::Precision;
use crate::cgm::certificate::{Iterate, IterateMeasures, measure};
use crate::cgm::cone::cell_state::{ConeCellState, Noise};
use crate::cgm::cone::workspace::gradient;
use crate::cgm::cone::{ConeMeasures, ConeRun, ConeStart, FrictionCone, N};
use crate::cgm::law::state::Row;
use crate::cgm::linear::{BASES, Linear, UpdatedIterate};
use crate::cgm::newton::NewtonSteps;
use crate::cgm::{AbsBound, BoundedPressure, CellCompliance, ConstraintSet, Disc, reduce};
use crate::numerics::cell_vector::{norm, slices, slices_mut};
use crate::parallel;
use crate::report::Status;

/// Residual of the present tractions above which a sweep of alternating solves is cheaper than Newton's method.
const POOR: f64 = 0.1;
/// Reduction of the inner residual for sets from a coarser grid.
const FIRST_REDUCTION: f64 = 0.3;
/// Reduction of the inner residual while the sets change.
const INNER_REDUCTION: f64 = 0.03;
/// Lower limit of the reduction of the inner residual for sets that no longer change.
const LEAST_REDUCTION: f64 = 1e-5;
/// Residual above which a product in single precision identifies the sets as well as a product in double precision.
const EARLY: f64 = 1e-3;
/// Number of steps without halving the residual after which the method is stuck.
const PATIENCE: usize = 4;
/// Deficit of the totals, relative to their size, that counts as round-off.
const ROUND_OFF: f64 = 1e-12;
/// Fraction of the tolerance that counts as noise of the inner solution.
const NOISE: f64 = 0.1;
/// Fraction of the largest limit below which a limit counts as zero.
pub(super) const NOTHING: f64 = 1e-9;

/// Progress of the outer steps of a solve.
#[derive(Debug)]
pub(super) struct NewtonProgress {
    /// Least residual so far.
    best: f64,
    /// Number of steps without halving the residual.
    without: usize,
    /// Least deficit of the totals so far.
    missing: f64,
    /// Number of cells that changed sets in the last step.
    changes: usize,
    residual: f64,
    load_error: f64,
}

impl NewtonProgress {
    pub(super) const BEGIN: Self = Self {
        best: f64::INFINITY,
        without: 0,
        missing: f64::INFINITY,
        changes: usize::MAX,
        residual: f64::INFINITY,
        load_error: f64::INFINITY,
    };
}

impl<F: FrictionCone> NewtonSteps for ConeRun<'_, '_, F> {
    fn begin(&mut self) -> ControlFlow<Status> {
        self.set_laws();
        ControlFlow::Continue(())
    }

    fn examine(&mut self) -> ControlFlow<Status, f64> {
        let is_early = self.course.best > EARLY && self.course.best.is_finite();
        self.refresh_in(if is_early {
            Precision::Single
        } else {
            Precision::Double
        });
        let mut findings = self.findings();
        if is_early && findings.merit() <= self.monitor.tolerance() {
            // Only a product in double precision may end the solve.
            self.refresh();
            findings = self.findings();
        }
        let merit = findings.merit();
        self.monitor.check_termination(merit)?;
        (self.course.residual, self.course.load_error) = (findings.residual, findings.load_error);
        ControlFlow::Continue(merit)
    }

    fn has_stalled(&mut self, merit: f64) -> bool {
        let course = &mut self.course;
        // A deficit of the totals does not matter, because the first step corrects it.
        let is_present = course.best.is_infinite() && self.start == ConeStart::Present;
        if is_present && course.residual > POOR {
            return true;
        }
        // Close to sliding, the shift grows with each step and the tractions rotate into the direction of the force. The residual
        // is constant during these steps, so the force converges first.
        let is_nearer = course.missing > ROUND_OFF && course.load_error < 0.5 * course.missing;
        course.missing = course.missing.min(course.load_error);
        if merit < 0.5 * course.best {
            (course.best, course.without) = (merit, 0);
        } else if is_nearer {
            course.without = 0;
        } else {
            course.without += 1;
        }
        course.without >= PATIENCE
    }

    fn linearise(&mut self, _: f64) -> ControlFlow<Status, bool> {
        let linear = &mut self.workspace.linear;
        linear.list_moving();
        self.monitor.record_allocation_failure(linear.list())?;
        self.free_hardness_cells();
        self.restore_stick();
        self.measure_slip();
        self.border = self.border();
        let missing = self.missing();
        let is_carried = |c: usize| self.border.active[c] || missing[c] == 0.0;
        ControlFlow::Continue((0..N).all(is_carried))
    }

    fn solve_linear(&mut self, merit: f64) -> ControlFlow<Status> {
        let (border, missing) = (self.border, self.missing());
        let reduction = if self.course.changes == usize::MAX && self.start == ConeStart::Coarse {
            FIRST_REDUCTION
        } else if self.course.changes > 0 {
            INNER_REDUCTION
        } else {
            (0.3 * self.monitor.tolerance() / merit).clamp(LEAST_REDUCTION, INNER_REDUCTION)
        };
        self.is_fresh = false;
        let (mut linear, mut moved) = self.parts();
        let solved = linear.solve(&border, missing, (BASES, reduction), &mut moved);
        solved.map_continue(|_| ())
    }

    fn decide(&mut self) -> ControlFlow<Status> {
        self.course.changes = self.reclassify(self.monitor.tolerance());
        self.hold_springs();
        ControlFlow::Continue(())
    }

    fn stuck(&self) -> Option<Status> {
        self.monitor.stuck()
    }
}

impl<'a, F: FrictionCone> ConeRun<'a, '_, F> {
    /// Projects the tractions onto their cones and determines the state of the cells.
    pub(super) fn set_laws(&mut self) {
        self.is_fresh = false;
        let (friction, hardness) = (&self.problem.friction, self.problem.hardness);
        let of = |cell: usize, _, [p, x, y]: [f64; N]| {
            let hardness = hardness.of(cell);
            let pressure = p.max(0.0).min(hardness);
            let radius = friction.limit(cell, pressure);
            let [x, y] = Disc { radius }.project([x, y]);
            let tractions = [pressure, x, y];
            (ConeCellState::of(tractions, radius, hardness), tractions)
        };
        let linear = &mut self.workspace.linear;
        linear.replace(self.problem.layout, &mut self.x, of);
        self.hold_springs();
    }

    /// Computes `product = C x` and the friction limits of the pressures. Does nothing if both are up to date.
    pub(super) fn refresh(&mut self) {
        if !self.is_fresh {
            self.refresh_in(Precision::Double);
        }
    }

    fn refresh_in(&mut self, precision: Precision) {
        self.is_fresh = precision == Precision::Double;
        let w = &mut *self.workspace;
        let (operator, report) = (&self.problem.operator, &mut self.monitor.report);
        let product = slices_mut(&mut w.product);
        precision.apply(
            operator,
            slices(&self.x),
            product,
            &mut w.linear.operator,
            report,
        );
        let (friction, pressure) = (&self.problem.friction, &*self.x[0]);
        parallel::update(&mut w.limits, |first, limits| {
            for (i, limit) in (first..).zip(limits) {
                *limit = friction.limit(i, pressure[i]);
            }
        });
        self.refresh_lag();
    }

    /// Examines the iterate with the current product and writes the findings to the report.
    pub(super) fn findings(&mut self) -> ConeMeasures {
        let [least_normal, least_plane] = self.problem.lower_bounds;
        let hardness = BoundedPressure(self.problem.hardness);
        let normal = measure(&self.part([0]), &hardness, least_normal);
        let limits = AbsBound(&self.workspace.limits);
        let plane = measure(&self.part([1, 2]), &limits, least_plane);
        let findings = self.found(&normal, &plane);
        let report = &mut self.monitor.report;
        report.residual = findings.residual;
        report.load_error = findings.load_error;
        self.monitor.free = findings.free;
        findings
    }

    /// Returns these components of the iterate.
    fn part<const M: usize>(&self, components: [usize; M]) -> Iterate<'_, M> {
        let (problem, w) = (self.problem, &*self.workspace);
        Iterate {
            layout: problem.layout,
            x: components.map(|c| &*self.x[c]),
            product: components.map(|c| w.product[c].as_slice()),
            linear: components.map(|c| problem.linear[c]),
            datum: [0.0; M],
            totals: components.map(|c| problem.totals[c]),
            multiplier: components.map(|c| w.multiplier[c]),
        }
    }

    fn found(&self, normal: &IterateMeasures, plane: &IterateMeasures) -> ConeMeasures {
        let pressed = normal.measure();
        // If every cell has stuck since the start, the tangential motion is zero. The displacement caused by the pressure alone
        // is then the scale.
        let moved = reduce::larger(plane.measure(), self.problem.coupling * pressed);
        let ratio = |a: f64, b: f64| if a == 0.0 { 0.0 } else { a / b };
        let residuals = [
            ratio(normal.forbidden, pressed),
            ratio(plane.forbidden, moved),
        ];
        let energy = (normal.measured_energy() + plane.measured_energy()).sqrt();
        let has_squares = normal.has_squares() && plane.has_squares();
        let bounds = [normal.bound, plane.bound].map(|bound| {
            if has_squares {
                ratio(bound, energy)
            } else {
                f64::INFINITY
            }
        });
        ConeMeasures {
            residual: reduce::larger(residuals[0], residuals[1]),
            load_error: reduce::larger(normal.load_error, plane.load_error),
            bounds,
            free: plane.free,
        }
    }

    /// Updates the stiffness of every slipping cell from the last measured slip.
    fn measure_slip(&mut self) {
        let (friction, self_compliance) = (&self.problem.friction, self.problem.self_compliance);
        let w = &mut *self.workspace;
        let gradient = gradient(&w.product, self.problem.linear, w.multiplier);
        let (pressure, limits) = (&*self.x[0], &w.limits);
        let least = NOTHING * reduce::max(self.problem.layout, |i| limits[i]);
        w.linear.update_rows(|i, law| {
            if law.moves() {
                let [_, x, y] = gradient(i);
                let limit = [limits[i], friction.slope(i, pressure[i])];
                *law = law.measured([x, y], limit, least, self_compliance);
            }
        });
    }

    /// Returns the linear problem for the current state of the cells, which includes their entry compliance.
    pub(super) fn linear(&mut self) -> Linear<'_, 'a, ConeCellState, N> {
        self.parts().0
    }

    /// Returns the linear problem and the iterate that its solution updates.
    fn parts(&mut self) -> (Linear<'_, 'a, ConeCellState, N>, UpdatedIterate<'_, 'a, N>) {
        let (problem, w) = (self.problem, &mut *self.workspace);
        let linear = Linear {
            operator: &problem.operator,
            preconditioner: &problem.preconditioner,
            sparse: None,
            layout: problem.layout,
            own: CellCompliance::default(),
            self_compliance: 0.0,
            restraint: 0.0,
            stiff: f64::INFINITY,
            monitor: &mut self.monitor,
            workspace: &mut w.linear,
        };
        let moved = UpdatedIterate {
            x: &mut self.x,
            displacement: &mut w.product,
            gap: problem.linear,
            multiplier: &mut w.multiplier,
        };
        (linear, moved)
    }

    /// Determines the next state of every cell at the equilibrated state, and projects its tractions. Returns the number of
    /// changed cells.
    fn reclassify(&mut self, tolerance: f64) -> usize {
        self.is_fresh = false;
        let w = &mut *self.workspace;
        let gradient = gradient(&w.product, self.problem.linear, w.multiplier);
        let [z, x, y] = slices(&w.product);
        let sizes = |i: usize| norm([x[i], y[i]]);
        let noise = Noise {
            lag: 0.0,
            hardness: f64::INFINITY,
            gap: NOISE * tolerance * reduce::max(self.problem.layout, |i| z[i].abs()),
            slip: NOISE * tolerance * reduce::max(self.problem.layout, sizes),
        };
        let problem = self.problem;
        let next = |cell: usize, law: ConeCellState, tractions| {
            let noise = Noise {
                lag: problem.closing_of(cell),
                hardness: problem.hardness.of(cell),
                ..noise
            };
            law.next(cell, tractions, gradient(cell), &problem.friction, noise)
        };
        w.linear.replace(problem.layout, &mut self.x, next).0
    }
}
