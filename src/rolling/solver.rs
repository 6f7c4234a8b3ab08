//! The reusable solver of steady rolling.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::buffer::{TryClone, filled, or_abort, try_each, zeros};
use crate::cgm::vector::{at, minus, plus, slices};
use crate::cgm::{
    self, Disc, Magnitude, Own, Problem, Settings, Total, Workspace, solver_settings,
};
use crate::contact::{Cancellation, Conditions, has_iterate, with_counts_of};
use crate::error::{Error, Result};
use crate::history::Passage;
use crate::influence::Direction;
use crate::operator::Operator;
use crate::report::{Iteration, Report, Status};
use crate::rolling::inverse::SteadyInverse;
use crate::rolling::operator::SteadyOperator;
use crate::rolling::spin_search::SpinSearch;
use crate::rolling::stiffness::Follow;
use crate::rolling::{RollingControl, RollingProblem, RollingSolution, SpinControl};
use crate::shown::shown;
use crate::tangential::{Friction, OwnCompliance, TangentialModel};
use crate::watch::Observer;

/// Solves at given spins after which the spin of a moment counts as not found.
const SPINS: usize = 60;
/// Their tolerance over that of the moment.
const SHARPER: f64 = 0.1;
/// The least of such tolerances, where solves to the first leave too large an error in the moment.
const SHARPEST: f64 = 2e-4;

/// Solves for one creepage, force or spin after the other, each from the answer of the last.
///
/// ```
/// use stickslip::rolling::{RollingControl, RollingProblem};
/// use stickslip::*;
/// let grid = Grid::square(24, 3.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?)?;
/// let (ball, load) = (surface::sphere(grid, 1.0)?, NormalControl::Force(4.0 / 3.0));
/// let normal = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
/// let mut solver = RollingProblem::builder(&bodies, &normal, Friction::coulomb(0.3)?)
///     .build()?
///     .into_solver()?;
/// let mut rolling = solver.new_solution();
/// for force in [0.1, 0.2, 0.3, 0.39] {
///     solver.set_control([RollingControl::Force(force), RollingControl::Creepage(0.0)], 0.0)?;
///     let before = rolling.creepage()[0];
///     solver.solve_into(&mut rolling)?;
///     assert!((rolling.force()[0] - force).abs() < 1e-9 && rolling.creepage()[0] > before);
/// }
/// # Ok::<(), Error>(())
/// ```
pub struct RollingSolver {
    pub(super) problem: RollingProblem,
    pub(super) operator: Arc<SteadyOperator>,
    pub(super) inverse: Arc<SteadyInverse>,
    pub(super) workspace: Workspace<Disc, 2>,
    /// What tractions and displacements are measured in: one, or a power of two where their squares would leave the range
    /// of numbers.
    pub(super) unit: f64,
    pub(super) limits: Vec<f64>,
    pub(super) traction: [Vec<f64>; 2],
    /// What a solve asks of each cell.
    pub(super) linear: [Vec<f64>; 2],
    /// The compliance B that cells that carry traction have of their own.
    own_mean: Vec<f64>,
    own_deviator: Vec<[f64; 2]>,
    /// The spin of the last solve, from which the search for that of a moment starts.
    pub(super) spin: f64,
    report: Report,
    /// Whether there is a last answer.
    is_warm: bool,
    pub(super) follow: Option<Follow>,
}

shown!(RollingSolver: problem);

impl RollingSolver {
    pub(super) fn new(problem: RollingProblem) -> Result<Self> {
        let step = problem.step;
        let (bodies, directions) = (&problem.bodies, [Direction::X, Direction::Y]);
        let compliance = bodies.compliance(directions, step.size)?;
        let operator = compliance.operator.clone();
        let inverse = bodies.inverse_up_to_mean(compliance, directions, step.size)?;
        let alone = self_compliance(&operator, step)?;
        let operator = SteadyOperator::new(operator, step, problem.chain, alone);
        let inverse = SteadyInverse::new(inverse, step);
        let (operator, inverse) = (Arc::new(operator), Arc::new(inverse));
        let cells = operator.cells();
        let mut solver = Self {
            limits: zeros(cells)?,
            unit: 1.0,
            workspace: Problem::new(Arc::clone(&operator), [&[]; 2], Magnitude(&[]))
                .preconditioner(Arc::clone(&inverse))
                .workspace()?,
            traction: try_each(|_| zeros(cells))?,
            linear: try_each(|_| zeros(cells))?,
            own_mean: zeros(cells)?,
            own_deviator: filled([0.0; 2], cells)?,
            spin: 0.0,
            report: Report::with_room(),
            is_warm: false,
            follow: None,
            operator,
            inverse,
            problem,
        };
        solver.take_limits();
        Ok(solver)
    }

    /// Takes the limits of the problem, and what follows from them.
    fn take_limits(&mut self) {
        let limits = &self.problem.pressed.limits;
        let unit = limits.unit().unwrap_or(1.0);
        let ratio = self.unit / unit;
        for traction in self.traction.iter_mut().flatten() {
            // Beside limits so much smaller the old tractions tell nothing.
            *traction = if ratio.is_finite() {
                ratio * *traction
            } else {
                0.0
            };
        }
        self.unit = unit;
        for (cell, limit) in limits.cells.iter().enumerate() {
            let carries = *limit > 0.0;
            let own = if carries {
                self.problem.own[cell]
            } else {
                OwnCompliance::NONE
            };
            self.limits[cell] = limit / unit;
            (self.own_mean[cell], self.own_deviator[cell]) = (own.mean(), own.deviator());
        }
    }

    solver_settings!(problem.settings, problem.bodies, |_, settings| {
        TangentialModel::Vector.check(settings)
    });

    /// Changes what is prescribed of the next solve: along x and along y, and the spin or moment.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotModelled`], [`Error::BeyondFrictionCapacity`] or [`Error::BeyondFrictionMoment`];
    /// all is then as it was.
    pub fn set_control(
        &mut self,
        controls: [RollingControl; 2],
        spin: impl Into<SpinControl>,
    ) -> Result<()> {
        let spin = spin.into();
        self.problem.check(controls, spin)?;
        (self.problem.controls, self.problem.spin) = (controls, spin);
        Ok(())
    }

    /// Changes the friction of the next solve. [`stiffness`](Self::stiffness) is about the last answer, if there is one,
    /// until that solve.
    ///
    /// # Errors
    /// [`Error::GridMismatch`]; as [`set_control`](Self::set_control) for the present loads, [`Error::NotFinite`] also if
    /// the limits overflow; [`Error::Memory`]; the friction is then as it was.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        friction.check(self.problem.bodies.grid())?;
        let mut pressed = self.problem.pressed.try_clone()?;
        pressed.set_friction(friction);
        std::mem::swap(&mut self.problem.pressed, &mut pressed);
        let RollingProblem { controls, spin, .. } = self.problem;
        let checked = self.problem.check(controls, spin);
        if checked.is_err() {
            self.problem.pressed = pressed;
        } else if !self.is_warm {
            self.take_limits();
        }
        checked
    }

    /// Forgets the last answer: the next solve starts as the first did, and [`stiffness`](Self::stiffness) is that of a
    /// contact that sticks.
    pub fn reset(&mut self) {
        for value in self.traction.iter_mut().flatten() {
            *value = 0.0;
        }
        self.spin = 0.0;
        self.is_warm = false;
        self.take_limits();
    }

    /// An empty solution of the right size for [`Self::solve_into`].
    #[must_use]
    pub fn new_solution(&self) -> RollingSolution {
        or_abort(self.try_new_solution())
    }

    /// [`Self::new_solution`] where memory may run out.
    ///
    /// # Errors
    /// [`Error::Memory`].
    pub fn try_new_solution(&self) -> Result<RollingSolution> {
        RollingSolution::empty(self.problem.bodies.grid())
    }

    /// Solves into `solution`, whose last content does not matter. The spin of a moment is found by several solves, each
    /// to a tenth of the tolerance or less; their report adds up the work, and the limits hold for all of them together.
    /// The load error of a moment is relative to half the range of the moments that spins cause.
    ///
    /// # Errors
    /// [`Error::GridMismatch`], nothing changed; [`Error::NotConverged`] with the last feasible iterate in `solution`, also
    /// where the spin of a moment near the limit is not found; [`Error::Memory`], which during the search for the spin of a
    /// moment leaves the answer at another spin in `solution`.
    pub fn solve_into(&mut self, solution: &mut RollingSolution) -> Result<()> {
        self.solve_observed(solution, |_| ControlFlow::Continue(()))
    }

    /// [`Self::solve_into`] with an observer that sees every step and may cancel. Once it has cancelled, the solve returns
    /// [`Error::NotConverged`] with [`Status::Cancelled`], even if the iterate is within the tolerance.
    ///
    /// # Errors
    /// As [`Self::solve_into`].
    pub fn solve_observed(
        &mut self,
        solution: &mut RollingSolution,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<()> {
        self.problem
            .bodies
            .grid()
            .expect("solution", solution.grid())?;
        self.take_limits();
        self.is_warm = true;
        let cancellation = Cancellation::default();
        let mut observer = cancellation.watch(&mut observer);
        let outcome = match self.problem.spin {
            SpinControl::Spin(spin) => {
                self.spin = spin;
                let settings = self.problem.settings;
                let outcome = self.solve_at_spin(&settings, solution, &mut observer);
                self.report.clone_from(self.workspace.report());
                outcome
            }
            SpinControl::Moment(moment) => self.solve_for_moment(moment, solution, &mut observer),
        };
        cancellation.applied(&self.problem.bodies, outcome, || {
            let report = self.report.cancelled();
            solution.set_report(&report);
            report
        })
    }

    /// Solves at the spin as it is.
    fn solve_at_spin(
        &mut self,
        settings: &Settings,
        solution: &mut RollingSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let totals = self.prescribe();
        self.start_sliding();
        let problem = &self.problem;
        let linear = self.linear.each_ref().map(Vec::as_slice);
        let task = Problem::new(Arc::clone(&self.operator), linear, Magnitude(&self.limits))
            .own(Own::new(&self.own_mean, &self.own_deviator))
            .preconditioner(Arc::clone(&self.inverse))
            .totals(totals);
        let traction = self.traction.each_mut().map(Vec::as_mut_slice);
        let workspace = &mut self.workspace;
        let outcome = cgm::minimise_with(&task, settings, traction, workspace, observer);
        if has_iterate(&outcome) {
            let unit = self.unit;
            let multiplier = self.workspace.multiplier().map(|shift| shift * unit);
            let creepage = [0, 1].map(|axis| match problem.controls[axis] {
                RollingControl::Creepage(creepage) => creepage,
                RollingControl::Force(_) => multiplier[axis] / problem.length,
            });
            let slip = |cell: usize| self.slip(cell).map(|slip| unit * slip);
            let traction = |cell: usize| at(&slices(&self.traction), cell).map(|q| unit * q);
            let answer = solution.of(problem, traction, slip);
            answer.set_motion(creepage, self.spin, self.workspace.report());
        }
        outcome
    }

    pub(super) fn own(&self) -> Own<'_> {
        Own::new(&self.own_mean, &self.own_deviator)
    }

    /// Slip of a cell over a step in the last answer.
    pub(super) fn slip(&self, cell: usize) -> [f64; 2] {
        let product = self.workspace.product();
        let moved = plus(at(&product, cell), 1.0, at(&slices(&self.linear), cell));
        let q = at(&slices(&self.traction), cell);
        let slip = self.own().added(moved, 1.0, cell, q);
        minus(slip, self.workspace.multiplier())
    }

    /// Finds the spin of a moment by solves at given spins, from that of the last solve on; one that fails leaves it.
    fn solve_for_moment(
        &mut self,
        moment: f64,
        solution: &mut RollingSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let start = self.spin;
        let settings = self.problem.settings;
        let mut conditions = Conditions::new(&settings, observer);
        let outcome = self.search_spin(moment, solution, &mut conditions);
        if outcome.is_err() {
            self.spin = start;
        }
        outcome
    }

    fn search_spin(
        &mut self,
        moment: f64,
        solution: &mut RollingSolution,
        conditions: &mut Conditions<'_, '_>,
    ) -> Result<()> {
        let tolerance = conditions.settings.tolerance;
        let ends = self.problem.moment_ends(self.problem.controls)?;
        let (half_range, stride) = (0.5 * (ends[1] - ends[0]).abs(), self.stride());
        let start = || SpinSearch::new(stride, ends.map(|end| moment - end));
        let (mut search, mut sharper) = (start(), SHARPER);
        self.report.clear();
        for _ in 0..SPINS {
            let mut settings = conditions.left(&self.report);
            settings.tolerance = sharper * tolerance;
            let mut watch = with_counts_of(&self.report, &mut *conditions.observer);
            let outcome = self.solve_at_spin(&settings, solution, &mut watch);
            drop(watch);
            if !has_iterate(&outcome) {
                return outcome;
            }
            self.report.add_pass(self.workspace.report());
            self.report.time = conditions.start.elapsed();
            let missing = moment - solution.moment();
            let error = (missing / half_range).abs();
            self.report.load_error = self.report.load_error.max(error);
            // Near round-off a sharper solve stalls although it is sharp enough.
            let pass = self.workspace.report();
            let is_stopped = !matches!(pass.status, Status::Converged | Status::Stalled);
            let is_sound = outcome.is_ok() || !is_stopped && pass.is_within(tolerance);
            let is_exhausted = self.report.iterations >= conditions.settings.max_iterations;
            self.report.status = if is_sound && error <= tolerance {
                Status::Converged
            } else if is_stopped {
                pass.status
            } else if is_exhausted {
                Status::IterationLimit
            } else {
                Status::Stalled
            };
            solution.set_report(&self.report);
            if self.report.is_converged() {
                return Ok(());
            }
            if is_stopped || is_exhausted {
                break;
            }
            if let Some(spin) = search.next(self.spin, missing) {
                self.spin = spin;
            } else if sharper > SHARPEST {
                // The moments of the last spins differ by what the tolerance leaves.
                sharper *= SHARPER;
                search = start();
            } else {
                break;
            }
        }
        Err(Error::NotConverged(Box::new(self.report.clone())))
    }

    /// A spin at which the cells farthest from the origin are near their limits.
    fn stride(&self) -> f64 {
        let problem = &self.problem;
        let motions = problem
            .pressed
            .window()
            .indices()
            .map(|i| problem.motions(i)[2]);
        let farthest = motions.fold(0.0, |most: f64, [x, y]| most.max(x.hypot(y)));
        self.largest_slip() / farthest
    }

    /// Returns about how far tractions at their limits displace a cell on its way through the contact.
    pub(super) fn largest_slip(&self) -> f64 {
        let limit = self
            .limits
            .iter()
            .fold(0.0, |most: f64, limit| most.max(*limit));
        self.problem.chain as f64 * self.operator.self_compliance() * self.unit * limit
    }

    /// Writes what each cell is to follow, and returns what is prescribed of the sums.
    fn prescribe(&mut self) -> [Total; 2] {
        let problem = &self.problem;
        let given = problem.controls.map(|control| match control {
            RollingControl::Creepage(creepage) => creepage,
            RollingControl::Force(_) => 0.0,
        });
        let motion = [given[0], given[1], self.spin];
        for (cell, index) in problem.pressed.window().indices().enumerate() {
            let motions = problem.motions(index);
            for axis in 0..2 {
                let parts = motions.iter().zip(motion);
                let moved = parts.fold(0.0, |sum, (part, motion)| sum + motion * part[axis]);
                self.linear[axis][cell] = (problem.drawn[axis][cell] - moved) / self.unit;
            }
        }
        let area = problem.bodies.grid().cell_area();
        problem.controls.map(|control| match control {
            RollingControl::Creepage(_) => Total::Free,
            RollingControl::Force(force) => Total::Sum(force / area / self.unit),
        })
    }

    /// The report of the last solve.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }
}

/// What a cell slips over a step by a traction of its own.
fn self_compliance(compliance: &impl Operator<2>, step: Passage) -> Result<f64> {
    let cells = compliance.cells();
    let (mut unit, mut image): ([Vec<f64>; 2], [Vec<f64>; 2]) =
        (try_each(|_| zeros(cells))?, try_each(|_| zeros(cells))?);
    let last = step.trailing_cell();
    unit[0][last] = 1.0;
    compliance.apply(
        unit.each_ref().map(Vec::as_slice),
        image.each_mut().map(Vec::as_mut_slice),
        &mut compliance.scratch()?,
    );
    step.difference(&mut image[0]);
    Ok(image[0][last])
}
