//! State of one solve, shared by all methods: products, sums, the examination of an iterate and the end of the iteration.

use crate::cgm::certificate::{Certificate, examine};
use crate::cgm::law::state::{LinearisedSet, Row};
use crate::cgm::linear::{Linear, UpdatedIterate};
use crate::cgm::monitor::{INNER_REDUCTION, Monitor, Progress};
use crate::cgm::problem::Posed;
use crate::cgm::totals::{Total, TotalsSystem, hold_springs, sums_of};
use crate::cgm::{Constraint, ConstraintSet, InitialGuess, MotionOf, Settings, Workspace, reduce};
use crate::numerics::cell_vector::{at, dot, minus, norm, plus, slices, slices_mut, update_cells};
use crate::observer::Observer;
use crate::operator::{LowerBound, MeanBound, Operator, Scratch};
use crate::parallel::layout::Layout;
use crate::report::{Report, Status};

/// Error of a product in single precision, relative to the largest displacement.
pub(super) const SINGLE: f64 = 1e-6;
/// Accepted error of a product, as a fraction of the tolerance, if the caller examines the solution. The fraction is small
/// because the errors of all cells add up in the energy norm.
const ACCEPTED: f64 = 0.03;

/// Fraction of the smallest eigenvalue below which a curvature is round-off of single precision.
const FLAT: f64 = 1e-3;
/// Fraction of the smallest eigenvalue that replaces a curvature below [`FLAT`]. A step with this curvature reaches the
/// bounds.
const FLATTEST: f64 = 1e-30;
/// Replacement for the curvature if no eigenvalue is known. The number is small in any system of units.
const NOTHING: f64 = 1e-60;

/// Precision of a product.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Precision {
    Double,
    Single,
}

impl Precision {
    /// Computes `out = C x` and counts the product.
    pub(super) fn apply<const N: usize>(
        self,
        operator: &dyn Operator<N>,
        x: [&[f64]; N],
        out: [&mut [f64]; N],
        scratch: &mut Scratch,
        report: &mut Report,
    ) {
        match self {
            Self::Double => {
                operator.apply(x, out, scratch);
                report.double_precision_products += 1;
            }
            Self::Single => {
                operator.apply_f32(x, out, scratch);
                report.single_precision_products += 1;
            }
        }
    }
}

/// Outcome of moving an iterate into its sets.
pub(super) struct ProjectionOutcome {
    /// Whether all cells keep their motion states.
    pub(super) keeps_sets: bool,
    /// Whether nothing has changed, including multipliers and product.
    pub(super) unchanged: bool,
}

/// State of one solve.
pub(super) struct ActiveSetSolve<'a, 'b, K: Constraint<N>, const N: usize> {
    pub(super) problem: &'a Posed<'b, K, N>,
    pub(super) monitor: Monitor<'a>,
    pub(super) x: [&'a mut [f64]; N],
    pub(super) workspace: &'a mut Workspace<K::Set, N>,
    /// Bound on the error of product and gradient for the current `x`, relative to the largest displacement. The bound is zero
    /// after a product in double precision. It is infinite after a change of `x`.
    pub(super) product_error: f64,
    /// Error bound of the gradient alone, which is updated by the steps of the linear problem.
    pub(super) gradient_error: f64,
    /// Knowledge about the iterate with which the method starts. A previous solution is feasible and its product is up to date.
    pub(super) start: InitialGuess<N>,
    /// Lower bound of the eigenvalues on the unknowns that the totals allow.
    pub(super) lower_bound: LowerBound,
    /// Displacement of a cell under a unit traction on this cell.
    pub(super) self_compliance: f64,
    /// Reduction of the inner residual with which the next pass of Newton's method starts.
    pub(super) inner_reduction: f64,
    /// Stiffness added to the operator around the centre of a proximal-point stage, or zero outside such stages.
    pub(super) restraint: f64,
    /// Restraint above which the inverse of the operator alone is useless as a preconditioner.
    pub(super) stiff: f64,
    /// Merit of the last verified iterate, or `None` if the iterate is not feasible or has changed after the verification.
    pub(super) shown: Option<f64>,
    pub(super) progress: Progress,
    pub(super) totals: TotalsSystem<N>,
    /// Whether the moving cells are scattered.
    pub(super) is_scattered: bool,
    /// Whether the gradient of the start identifies the cells that become free.
    pub(super) is_near: bool,
    /// Largest displacement at the last examination.
    pub(super) displacement: f64,
    /// Whether the totals determine all unknowns because every cell is at an extreme point of its set.
    is_extreme: bool,
}

impl<'a, 'b, K: Constraint<N>, const N: usize> ActiveSetSolve<'a, 'b, K, N> {
    pub(super) fn new(
        problem: &'a Posed<'b, K, N>,
        settings: &'a Settings,
        x: [&'a mut [f64]; N],
        workspace: &'a mut Workspace<K::Set, N>,
        observer: Observer<'a>,
    ) -> Self {
        workspace.multiplier = [0.0; N];
        workspace.linear.report.eigenvalue_bound = problem.lower_bound.known;
        Self {
            monitor: Monitor::new(
                settings,
                problem.layout,
                observer,
                &mut workspace.linear.report,
            ),
            lower_bound: problem.lower_bound,
            self_compliance: problem.operator.self_compliance().max(0.0),
            problem,
            x,
            workspace,
            product_error: f64::INFINITY,
            gradient_error: f64::INFINITY,
            start: InitialGuess::Nothing,
            inner_reduction: INNER_REDUCTION,
            restraint: 0.0,
            stiff: f64::INFINITY,
            shown: None,
            progress: Progress::new(0, INNER_REDUCTION),
            totals: TotalsSystem::NONE,
            is_scattered: false,
            is_near: false,
            displacement: 0.0,
            is_extreme: false,
        }
    }

    /// Determines whether springs alone store the energy of uniform unknowns. Does nothing if the result would not affect the
    /// error bound.
    ///
    /// The test sets all unknowns to one. If the bound holds for all unknowns, the operator then displaces some cell by at least
    /// the bound.
    pub(super) fn find_bound_of_mean(&mut self) {
        let (least, layout) = (self.lower_bound.value, self.layout());
        let cells = layout.of_all_ranks();
        let springs = self.problem.totals.map(|total| {
            let compliance = total.compliance();
            compliance.map(|compliance| cells as f64 * compliance)
        });
        for (component, spring) in springs.iter().enumerate() {
            if spring.is_none_or(|compliance| compliance >= least) {
                continue;
            }
            let w = &mut *self.workspace;
            for (c, direction) in w.linear.direction.iter_mut().enumerate() {
                direction.fill(if c == component { 1.0 } else { 0.0 });
            }
            let (direction, image) = (slices(&w.linear.direction), slices_mut(&mut w.linear.image));
            (self.problem.operator).apply(direction, image, &mut w.linear.operator);
            let image = slices(&w.linear.image);
            if reduce::max(layout, |i| norm(at(&image, i))) < 0.5 * least {
                self.lower_bound.mean = MeanBound::Springs;
            }
        }
    }

    /// Returns the layout of the cells.
    pub(super) fn layout(&self) -> &'a Layout {
        self.problem.layout
    }

    /// Returns the prescribed sums.
    pub(super) fn sums(&self) -> [Option<f64>; N] {
        self.problem.totals.map(Total::sum)
    }

    /// Projects the start onto its sets and determines the motion of every cell. Keeps the product if the start was examined.
    pub(super) fn mark_start(&mut self) {
        let constraint = self.problem.constraint;
        let start = std::mem::replace(&mut self.start, InitialGuess::Nothing);
        if !matches!(start, InitialGuess::PreviousSolution(_)) {
            update_cells(&mut self.x, |i, x| constraint.of(i).project(x));
            self.product_error = f64::INFINITY;
        }
        let (x, w) = (slices(&self.x), &mut *self.workspace);
        if MotionOf::<K, N>::IS_STEADY {
            w.linear.moving.update(|i| constraint.of(i).can_move());
        }
        let of = |i: usize| constraint.of(i).motion(at(&x, i));
        w.linear.update_rows(|i, motion| *motion = of(i));
    }

    /// Moves cells to restore the sums. Moves all cells if `all` is set. Otherwise moves only the moving cells or only the cells
    /// inside their bounds if these cells suffice. Returns whether the cells keep their motion states.
    pub(super) fn restore_totals(&mut self, all: bool) -> bool {
        let motions = &self.workspace.linear.rows;
        let is_steady = MotionOf::<K, N>::IS_STEADY;
        let preferred = |i: usize| all || !is_steady && motions[i].moves();
        let (constraint, sums) = (self.problem.constraint, self.problem.totals.map(Total::sum));
        self.product_error = f64::INFINITY;
        let layout = self.problem.layout;
        K::Set::restore(layout, slices_mut(&mut self.x), constraint, preferred, sums)
    }

    /// Returns the linear problem of the semismooth Newton step for the current motion of the cells.
    pub(super) fn linear(&mut self) -> Linear<'_, 'a, MotionOf<K, N>, N> {
        self.parts().0
    }

    /// Returns the linear problem and the iterate that its solution updates.
    pub(super) fn parts(
        &mut self,
    ) -> (Linear<'_, 'a, MotionOf<K, N>, N>, UpdatedIterate<'_, 'a, N>) {
        let w = &mut *self.workspace;
        let linear = Linear {
            operator: self.problem.operator,
            preconditioner: self.problem.preconditioner,
            sparse: self.problem.sparse.filter(|_| self.is_scattered),
            layout: self.problem.layout,
            own: self.problem.own,
            self_compliance: self.self_compliance,
            restraint: self.restraint,
            stiff: self.stiff,
            monitor: &mut self.monitor,
            workspace: &mut w.linear,
        };
        let moved = UpdatedIterate {
            x: &mut self.x,
            displacement: &mut w.gradient,
            gap: [&[]; N],
            multiplier: &mut w.multiplier,
        };
        (linear, moved)
    }

    /// Computes `product = (C + D) x` and `gradient = (C + D) x + b`.
    pub(super) fn refresh(&mut self) {
        self.refresh_in(Precision::Double);
        self.product_error = 0.0;
    }

    /// Computes product and gradient in single precision. This precision suffices for the iteration. A test of convergence may
    /// use the result only if the solution is [examined elsewhere](crate::cgm::Problem::verified_by_caller).
    pub(super) fn refresh_f32(&mut self) {
        self.refresh_in(Precision::Single);
        self.product_error = SINGLE;
    }

    /// Returns whether product and gradient belong to the current `x`.
    pub(super) fn is_fresh(&self) -> bool {
        self.product_error == 0.0
    }

    /// Returns the accepted error of product and gradient of the returned iterate. The accepted error is zero unless
    /// the iterate is [examined elsewhere](crate::cgm::Problem::verified_by_caller).
    fn accepted_error(&self) -> f64 {
        if self.problem.is_examined_elsewhere {
            ACCEPTED * self.monitor.tolerance()
        } else {
            0.0
        }
    }

    /// Accepts the updated gradient for the current `x` if its error is small enough, and derives the product from the
    /// gradient. Returns whether the gradient was accepted.
    pub(super) fn adopt_gradient(&mut self) -> bool {
        let is_close = self.gradient_error <= self.accepted_error();
        if is_close {
            let (w, problem) = (&mut *self.workspace, self.problem);
            let gradient = slices(&w.gradient);
            update_cells(&mut w.product, |i, _| {
                minus(at(&gradient, i), problem.linear(i))
            });
            self.product_error = self.gradient_error;
        }
        is_close
    }

    fn refresh_in(&mut self, precision: Precision) {
        let w = &mut *self.workspace;
        let (x, product) = (slices(&self.x), slices_mut(&mut w.product));
        let (operator, report) = (&self.problem.operator, &mut self.monitor.report);
        precision.apply(operator, x, product, &mut w.linear.operator, report);
        let restraint = self.restraint;
        if restraint > 0.0 {
            let centre = slices(&w.centre);
            update_cells(&mut w.product, |i, u| {
                plus(u, restraint, minus(at(&x, i), at(&centre, i)))
            });
        }
        self.add_diagonal(1.0);
        self.form_gradient();
    }

    /// Adds `part` times the displacement caused by the diagonal `D` to the product.
    pub(super) fn add_diagonal(&mut self, part: f64) {
        let (x, problem) = (slices(&self.x), self.problem);
        if !problem.own.is_none() {
            update_cells(&mut self.workspace.product, |i, u| {
                problem.own.added(u, part, i, at(&x, i))
            });
        }
    }

    fn form_gradient(&mut self) {
        let w = &mut *self.workspace;
        let (product, problem) = (slices(&w.product), self.problem);
        update_cells(&mut w.gradient, |i, _| {
            plus(at(&product, i), 1.0, problem.linear(i))
        });
    }

    /// Returns a small replacement for the curvature `d' C d` of a direction `d` if this curvature is zero. The argument `square`
    /// is `d' d`. The resulting step brings the moving cells to their bounds. An operator that maps constants to zero does not
    /// resist a uniform direction. The operator of a single periodic cell maps everything to zero and has no stiffness for
    /// comparison.
    pub(super) fn slide(&self, curvature: f64, square: f64) -> Option<f64> {
        let stiffness = self.lower_bound.value * square;
        let is_flat = self.problem.totals.contains(&Total::Free)
            && (curvature < FLAT * stiffness || curvature == 0.0);
        let (moving, motions) = (&self.workspace.linear.moving, &self.workspace.linear.rows);
        let slides = || {
            !moving.leaves_any::<MotionOf<K, N>, N>()
                && !moving.any(motions, |motion| !motion.is_free())
        };
        let flattest = if stiffness > 0.0 {
            FLATTEST * stiffness
        } else {
            NOTHING * square
        };
        (is_flat && slides()).then_some(flattest)
    }

    /// Examines the iterate with the current product and writes the findings to the report. The findings are reliable only
    /// if that product is [fresh](Self::is_fresh).
    pub(super) fn certificate(&mut self) -> Certificate {
        let w = &*self.workspace;
        let (x, product) = (slices(&self.x), slices(&w.product));
        let iterate = self.problem.iterate(x, product, w.multiplier);
        let findings = examine(&iterate, self.problem.constraint, self.lower_bound);
        findings.write_to(&mut self.monitor.report);
        self.monitor.free = findings.free;
        findings
    }

    /// Returns the quantity that must fall to the tolerance.
    pub(super) fn merit(&self, findings: &Certificate) -> f64 {
        findings.merit(self.lower_bound.value)
    }

    /// Returns the multiplier for which `x = 0` is feasible and optimal, or `None` if no such multiplier exists. An iteration
    /// towards zero would lose the scale of its residual.
    pub(super) fn multiplier_at_zero(&self) -> Option<[f64; N]> {
        let Posed {
            constraint, totals, ..
        } = self.problem;
        let problem = self.problem;
        let linear = |i: usize| problem.linear(i);
        let first = || {
            reduce::first(self.layout(), |i| {
                constraint.of(i).can_move().then(|| linear(i))
            })
        };
        let mut multiplier = [0.0; N];
        for (c, total) in totals.iter().enumerate() {
            multiplier[c] = match *total {
                Total::Free => 0.0,
                Total::Sum(0.0) => first().map_or(0.0, |linear| linear[c]),
                Total::Sum(_) => return None,
                Total::Spring { far_end, .. } => far_end,
            };
        }
        let is_free = self.sums() == [None; N];
        let is_driven = |i: usize| {
            let set = constraint.of(i);
            let gradient = minus(problem.linear(i), multiplier);
            let rests = if is_free {
                norm(set.forbidden([0.0; N], gradient)) == 0.0
            } else {
                norm(gradient) == 0.0 || !set.can_move()
            };
            !rests || norm(set.project([0.0; N])) != 0.0
        };
        (!reduce::any(self.layout(), is_driven)).then_some(multiplier)
    }

    pub(super) fn at_zero(&mut self, multiplier: [f64; N]) -> Status {
        for x in &mut self.x {
            x.fill(0.0);
        }
        self.refresh();
        self.workspace.multiplier = multiplier;
        Status::Converged
    }

    /// Moves all cells to the only feasible point if the sums are the extreme sums along a direction. Sets the multiplier to the
    /// value at which the first cell would move.
    pub(super) fn at_extreme(&mut self, direction: [f64; N]) -> Status {
        let Posed {
            constraint, totals, ..
        } = self.problem;
        update_cells(&mut self.x, |i, _| constraint.of(i).extreme(direction));
        self.is_extreme = true;
        self.refresh();
        let gradient = slices(&self.workspace.gradient);
        let onset = reduce::least(self.layout(), |i| {
            let (moves, g) = (constraint.of(i).can_move(), at(&gradient, i));
            moves.then(|| (-dot(g, direction), g))
        });
        let sums = sums_of(self.layout(), &slices(&self.x));
        self.workspace.multiplier = std::array::from_fn(|c| {
            let last = onset.map_or(0.0, |(_, g)| g[c]);
            totals[c].held(last, sums[c])
        });
        Status::Converged
    }

    /// Moves the iterate into its sets and adjusts it to its sums, unless it is already feasible up to round-off. Afterwards its
    /// product is up to date or as accurate as required.
    pub(super) fn make_feasible(&mut self) -> ProjectionOutcome {
        let mut keeps_sets = true;
        let constraint = self.problem.constraint;
        let x = slices(&self.x);
        let outside: f64 = reduce::sum(self.layout(), |i| constraint.of(i).excess(at(&x, i)));
        let mut unchanged = outside == 0.0 && !self.has_springs();
        if outside > 0.0 {
            update_cells(&mut self.x, |i, x| constraint.of(i).project(x));
            // A traction on a cell displaces no other cell more than the loaded cell.
            self.move_by(self.self_compliance * outside / self.displacement);
        }
        let prescribed = self.sums();
        // At an extreme point the bounds themselves determine the total.
        if prescribed != [None; N] && !self.is_extreme {
            let x = slices(&self.x);
            let (sums, magnitude): ([f64; N], f64) =
                reduce::sum(self.layout(), |i| (at(&x, i), norm(at(&x, i))));
            let missing: [f64; N] =
                std::array::from_fn(|c| prescribed[c].map_or(0.0, |sum| sum - sums[c]));
            if norm(missing) > 1e-13 * magnitude {
                let product_error = self.product_error;
                keeps_sets = self.restore_totals(false);
                unchanged = false;
                if keeps_sets {
                    // Displacements change by about the relative deficit of the sum.
                    self.product_error = product_error;
                    self.move_by(norm(missing) / magnitude);
                }
            }
        }
        let accepted = self.accepted_error();
        if self.product_error > accepted {
            unchanged = false;
            if SINGLE <= accepted {
                self.refresh_f32();
            } else {
                self.refresh();
            }
        }
        self.hold_springs();
        ProjectionOutcome {
            keeps_sets,
            unchanged,
        }
    }

    /// Records a change of `x` without an update of the product. The relative error of the product grows by `part`.
    fn move_by(&mut self, part: f64) {
        let is_known = part > 0.0 && self.problem.own.is_none();
        if is_known && self.problem.is_examined_elsewhere {
            self.product_error += part;
        } else {
            self.product_error = f64::INFINITY;
        }
    }

    fn has_springs(&self) -> bool {
        self.problem.totals.iter().any(|total| total.is_spring())
    }

    /// Updates the multipliers of the springs to the current sums.
    pub(super) fn hold_springs(&mut self) {
        let multiplier = &mut self.workspace.multiplier;
        let Posed { totals, layout, .. } = self.problem;
        hold_springs(totals, layout, &slices(&self.x), multiplier);
    }

    /// Completes the solve with a feasible iterate and a report computed from it, which determines the final status.
    pub(super) fn finish(&mut self, status: Status) -> Status {
        if let Some(merit) = self.shown {
            let report = &mut self.workspace.linear.report;
            return self.monitor.finish(status, merit, report);
        }
        self.make_feasible();
        let findings = self.certificate();
        let mut merit = self.merit(&findings);
        if self.is_extreme && !merit.is_nan() {
            // No other unknowns have these sums, so only the sums can be inaccurate. The gradient points along the slip in all
            // cells only in the limit of a large motion.
            merit = findings.load_error;
            let report = &mut self.monitor.report;
            (report.residual, report.duality_gap) = (0.0, 0.0);
        }
        self.monitor
            .finish(status, merit, &mut self.workspace.linear.report)
    }
}
