//! The reusable solver of steady rolling.

use std::sync::Arc;

use crate::bodies::component::Direction;
use crate::cgm::{
    AbsBound, CellCompliance, Disc, InitialGuess, Problem, Settings, Total, Workspace,
    minimise_from,
};
use crate::contact::{
    Cancellation, Contact, Model, SolveContext, Solver, has_iterate, model_fields, with_counts_of,
};
use crate::error::{Error, Result};
use crate::memory::fallible::{TryClone, filled, try_each, vector, zeros};
use crate::numerics::cell_vector::{at, minus, plus, slices};
use crate::observer::Observer;
use crate::operator::Operator;
use crate::report::{Report, Status};
use crate::rolling::WindowShift;
use crate::rolling::steady::inverse::SteadyPreconditioner;
use crate::rolling::steady::neglected_lift::SteadyLift;
use crate::rolling::steady::reload::Press;
use crate::rolling::steady::slip_operator::SteadyOperator;
use crate::rolling::steady::spin_search::SpinSearch;
use crate::rolling::steady::stiffness::RollingSensitivity;
use crate::rolling::steady::trend::CreepTrend;
use crate::rolling::{RollingControl, RollingProblem, RollingSolution, SpinControl};
use crate::tangential::{
    CouplingDisplacement, EntryCompliance, Friction, PressureOnWindow, TangentialModel,
};
use crate::warning::Warning;

/// Maximum number of solves at given spins in the search for the spin of a moment.
const SPINS: usize = 60;
/// Ratio of the tolerance of the solves in the search for a spin to the tolerance of the moment.
const SHARPER: f64 = 0.1;
/// Smallest ratio of these two tolerances, used if the error of the moment is too large with the ratio `SHARPER`.
const SHARPEST: f64 = 2e-4;

/// Solver for a sequence of creepages, forces or spins. Each solve starts from the last solution. The normal load can change
/// between solves. [`stiffness`](RollingSolver::stiffness) belongs to the last solution, and returns an error between a change of
/// the input and the next solve. After [`reset`](Solver::reset) the stiffness belongs to a contact that sticks everywhere.
///
/// For a prescribed moment, several solves determine the spin. The tolerance of each of these solves is at most a tenth of the
/// tolerance of the settings. The report contains the sum of the work of these solves, and the limits apply to all of them
/// together. The load error of a moment is relative to half the range of the moments that spins cause. The result is
/// [`Error::NotConverged`] if no spin is found for a moment near the limit. If memory runs out during the search, the solution
/// contains the result at a different spin.
///
/// ```
/// use stickslip::rolling::{RollingControl, RollingProblem, SpinControl};
/// use stickslip::*;
/// let grid = Grid::square(24, 3.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?)?;
/// let (ball, load) = (surface::sphere(grid, 1.0)?, NormalLoad::Force(4.0 / 3.0));
/// let normal = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
/// let mut solver = RollingProblem::builder(&bodies, &normal, Friction::coulomb(0.3)?)
///     .build()?
///     .into_solver()?;
/// let mut rolling = solver.new_solution();
/// for force in [0.1, 0.2, 0.3, 0.39] {
///     solver.set_load([RollingControl::Force(force), RollingControl::Creepage(0.0)], SpinControl::Spin(0.0))?;
///     let before = rolling.creepage()[0];
///     solver.solve_into(&mut rolling)?;
///     assert!((rolling.force()[0] - force).abs() < 1e-9 && rolling.creepage()[0] > before);
/// }
/// # Ok::<(), Error>(())
/// ```
pub type RollingSolver = Solver<RollingProblem>;

/// Engine of steady rolling.
#[derive(Clone)]
pub(crate) struct RollingEngine {
    /// Pressure and limits that are checked before the problem accepts them.
    pub(in crate::rolling) candidate: PressureOnWindow,
    /// Coupling operators for the tangential displacement due to the pressure, for bodies of different materials. `None` before
    /// the first change of the pressure.
    pub(in crate::rolling) drawing: Option<CouplingDisplacement>,
    /// Normal solver for new loads, or `None` until the caller has set a solver.
    pub(in crate::rolling) press: Option<Box<Press>>,
    pub(in crate::rolling) operator: Arc<SteadyOperator>,
    pub(in crate::rolling) inverse: Arc<SteadyPreconditioner>,
    pub(in crate::rolling) workspace: Workspace<Disc, 2>,
    /// Unit of tractions and displacements: one, or a power of two if their squares would overflow or underflow.
    pub(in crate::rolling) unit: f64,
    pub(in crate::rolling) limits: Vec<f64>,
    pub(in crate::rolling) traction: [Vec<f64>; 2],
    /// Linear term of each cell in a solve.
    pub(in crate::rolling) linear: [Vec<f64>; 2],
    /// Entry compliance B of cells that carry traction.
    pub(in crate::rolling) own_mean: Vec<f64>,
    pub(in crate::rolling) own_deviator: Vec<[f64; 2]>,
    /// Spin of the last solve, at which the search for the spin of a moment starts.
    pub(in crate::rolling) spin: f64,
    pub(in crate::rolling) report: Report,
    /// Report of the last solve at one spin.
    pub(in crate::rolling) passes: Report,
    /// Contribution to `linear` that corrects the direction of slip. Empty without corrections.
    pub(in crate::rolling) lag: [Vec<f64>; 2],
    /// Whether there is a last solution.
    pub(in crate::rolling) is_warm: bool,
    /// Name of the input that has changed since the last solution, for error messages.
    pub(in crate::rolling) changed: Option<&'static str>,
    pub(in crate::rolling) trend: CreepTrend,
    /// Initial guess of the next solve.
    known: InitialGuess<2>,
    /// Whether the pressure has changed since the last solution.
    pub(in crate::rolling) has_new_pressure: bool,
    pub(in crate::rolling) follow: Option<RollingSensitivity>,
    /// Operators of the neglected lift, for bodies of different materials with one-way coupling.
    pub(in crate::rolling) lifting: Option<SteadyLift>,
}

impl RollingEngine {
    /// Updates the limits from the problem, and the quantities that depend on them.
    pub(in crate::rolling) fn take_limits(&mut self, problem: &RollingProblem) {
        let limits = &problem.pressed.limits;
        let unit = limits.unit().unwrap_or(1.0);
        let ratio = self.unit / unit;
        let scaled = self.traction.iter_mut().chain(&mut self.trend.change);
        for traction in scaled.flatten() {
            // If the ratio of the units overflows, the old tractions are useless and become zero.
            *traction = if ratio.is_finite() {
                ratio * *traction
            } else {
                0.0
            };
        }
        self.unit = unit;
        let follows = std::mem::take(&mut self.has_new_pressure);
        for (cell, limit) in limits.cells.iter().enumerate() {
            let before = ratio * self.limits[cell];
            // Tractions scaled with the pressure are close to the next solution. In the time loop of a wheel this start
            // reduces the number of products from 30.4 to 19.4.
            if follows && before > 0.0 {
                for traction in self.traction.iter_mut().chain(&mut self.trend.change) {
                    traction[cell] *= limit / unit / before;
                }
            }
            let carries = *limit > 0.0;
            let own = if carries {
                problem.own[cell]
            } else {
                EntryCompliance::NONE
            };
            self.limits[cell] = limit / unit;
            (self.own_mean[cell], self.own_deviator[cell]) = (own.mean(), own.deviator());
        }
    }

    pub(in crate::rolling) fn own(&self) -> CellCompliance<'_> {
        CellCompliance::new(&self.own_mean, &self.own_deviator)
    }
}

impl Contact for RollingProblem {
    type Solution = RollingSolution;
    type Report = Report;
}

impl Model<RollingSolution> for RollingProblem {
    type Engine = RollingEngine;

    model_fields!(options.settings);

    fn check_settings(&self, settings: &Settings) -> Result<()> {
        TangentialModel::Vector.check(settings)
    }

    fn engine(&self) -> Result<RollingEngine> {
        let step = self.step;
        let (bodies, directions) = (&self.bodies, [Direction::X, Direction::Y]);
        let compliance = bodies.compliance(directions, step.size)?;
        let operator = compliance.operator.clone();
        let inverse = bodies.inverse_up_to_mean(compliance, directions, step.size)?;
        let alone = self_compliance(&operator, step)?;
        let operator = SteadyOperator::new(operator, step, self.chain, alone);
        let inverse = SteadyPreconditioner::new(inverse, step);
        let (operator, inverse) = (Arc::new(operator), Arc::new(inverse));
        let cells = operator.cells();
        let mut engine = RollingEngine {
            lifting: SteadyLift::new(bodies, &self.pressed)?,
            limits: zeros(cells)?,
            unit: 1.0,
            workspace: Problem::new(Arc::clone(&operator), [&[]; 2], AbsBound(&[]))
                .preconditioner(Arc::clone(&inverse))
                .workspace()?,
            traction: try_each(|_| zeros(cells))?,
            linear: try_each(|_| zeros(cells))?,
            own_mean: zeros(cells)?,
            own_deviator: filled([0.0; 2], cells)?,
            spin: 0.0,
            report: Report::with_room(),
            passes: Report::with_room(),
            lag: vector(if self.options.slip_corrections == 0 {
                0
            } else {
                cells
            })?,
            is_warm: false,
            changed: None,
            has_new_pressure: false,
            trend: CreepTrend::new(cells)?,
            known: InitialGuess::Nothing,
            candidate: self.pressed.try_clone()?,
            drawing: None,
            press: None,
            follow: None,
            operator,
            inverse,
        };
        engine.take_limits(self);
        Ok(engine)
    }

    fn empty_solution(&self) -> Result<RollingSolution> {
        RollingSolution::empty(self.bodies.grid())
    }

    fn check_solution(&self, solution: &RollingSolution) -> Result<()> {
        self.bodies.grid().check_equal("solution", solution.grid())
    }

    fn solve(
        solver: &mut RollingSolver,
        solution: &mut RollingSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        // After a solve without an iterate, neither the earlier solution nor a new one is available.
        solver.engine.changed = Some("the input");
        solver.engine.take_limits(&solver.problem);
        solver.extrapolate();
        let cancellation = Cancellation::default();
        let settings = solver.problem.options.settings;
        let mut observer = cancellation.watch(&settings, observer);
        let outcome = match solver.problem.options.spin {
            SpinControl::Spin(spin) => {
                solver.engine.spin = spin;
                let outcome = solver.solve_at_spin(&settings, solution, &mut observer);
                solver.engine.report.clone_from(&solver.engine.passes);
                outcome
            }
            SpinControl::Moment(moment) => solver.solve_for_moment(moment, solution, &mut observer),
        };
        let RollingEngine {
            trend,
            traction,
            report,
            changed,
            ..
        } = &mut solver.engine;
        trend.finish(traction);
        if outcome.is_err() {
            trend.forget();
        }
        if has_iterate(&outcome) {
            *changed = None;
        }
        cancellation.applied(&solver.problem.bodies, outcome, || {
            let report = report.cancelled();
            solution.set_report(&report);
            report
        })
    }

    fn report(solver: &RollingSolver) -> &Report {
        &solver.engine.report
    }

    fn reset(solver: &mut RollingSolver) {
        let engine = &mut solver.engine;
        for value in engine.traction.iter_mut().flatten() {
            *value = 0.0;
        }
        engine.spin = 0.0;
        engine.is_warm = false;
        engine.changed = None;
        engine.trend.forget();
        engine.take_limits(&solver.problem);
    }
}

impl RollingSolver {
    /// Sets the controls of the next solve: forces or creepages along x and y, and the spin or moment. They replace all earlier
    /// controls.
    ///
    /// # Errors
    /// - [`Error::NotFinite`], [`Error::UnsupportedByModel`], [`Error::BeyondFrictionCapacity`] or
    ///   [`Error::BeyondFrictionMoment`]. All controls are then unchanged.
    pub fn set_load(&mut self, controls: [RollingControl; 2], spin: SpinControl) -> Result<()> {
        self.problem.check(controls, spin)?;
        if self.problem.options.set_load(controls, spin) {
            self.engine.changed = Some("the load");
        }
        Ok(())
    }

    /// Returns the friction of the next solve, with its cap: the last friction that was given or [set](Self::set_friction).
    #[must_use]
    pub fn friction(&self) -> &Friction {
        &self.problem.friction
    }

    /// Sets the friction of the next solve. The new friction replaces the earlier coefficient and the earlier cap.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid differs.
    /// - The errors of [`set_load`](Self::set_load) for the current loads.
    /// - [`Error::NotFinite`] if the limits overflow.
    /// - [`Error::Memory`] if memory runs out.
    ///
    /// The friction is unchanged after an error.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        let problem = &mut self.problem;
        friction.check(problem.bodies.grid())?;
        let pressure = &problem.pressed.pressure;
        self.engine.candidate.pressure.copy_from_slice(pressure);
        self.engine.candidate.set_friction(friction);
        self.take_candidate(|problem| problem.friction.try_clone_from(friction))?;
        self.engine.changed = Some("the friction");
        Ok(())
    }

    /// Accepts the candidate pressure and limits if they allow the current loads and `work` succeeds.
    pub(in crate::rolling) fn take_candidate(
        &mut self,
        work: impl FnOnce(&mut RollingProblem) -> Result<()>,
    ) -> Result<()> {
        let problem = &mut self.problem;
        std::mem::swap(&mut problem.pressed, &mut self.engine.candidate);
        let checked = problem.check(problem.options.controls, problem.options.spin);
        let taken = checked.and_then(|()| work(problem));
        if taken.is_err() {
            std::mem::swap(&mut problem.pressed, &mut self.engine.candidate);
        } else if !self.engine.is_warm {
            self.engine.take_limits(&self.problem);
        }
        taken
    }

    /// Extrapolates the last tractions along their trend if creepages and spin change as in the last solve.
    fn extrapolate(&mut self) {
        let problem = &self.problem;
        let [x, y] = problem.options.controls.map(|control| match control {
            RollingControl::Creepage(creepage) => creepage,
            RollingControl::Force(_) => 0.0,
        });
        let turn = match problem.options.spin {
            SpinControl::Spin(spin) => spin * problem.lever(),
            SpinControl::Moment(_) => 0.0,
        };
        let is_near = self
            .engine
            .trend
            .start([x, y, turn], &mut self.engine.traction);
        if !std::mem::replace(&mut self.engine.is_warm, true) {
            self.engine.trend.forget();
        }
        self.engine.known = if is_near {
            InitialGuess::Interpolated
        } else {
            InitialGuess::Nothing
        };
    }

    /// Solves at the current spin with the current corrections of the slip directions.
    pub(in crate::rolling) fn solve_pass(
        &mut self,
        settings: &Settings,
        solution: &mut RollingSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let totals = self.compute_totals();
        self.start_sliding();
        let problem = &self.problem;
        let linear = self.engine.linear.each_ref().map(Vec::as_slice);
        let task = Problem::new(
            Arc::clone(&self.engine.operator),
            linear,
            AbsBound(&self.engine.limits),
        )
        .own(CellCompliance::new(
            &self.engine.own_mean,
            &self.engine.own_deviator,
        ))
        .preconditioner(Arc::clone(&self.engine.inverse))
        .totals(totals);
        let traction = self.engine.traction.each_mut().map(Vec::as_mut_slice);
        let workspace = &mut self.engine.workspace;
        let known = std::mem::replace(&mut self.engine.known, InitialGuess::Nothing);
        let posed = task.posed();
        let outcome = minimise_from(&posed, settings, traction, known, workspace, observer);
        if has_iterate(&outcome) {
            let unit = self.engine.unit;
            let multiplier = self.engine.workspace.multiplier().map(|shift| shift * unit);
            let creepage = [0, 1].map(|axis| match problem.options.controls[axis] {
                RollingControl::Creepage(creepage) => creepage,
                RollingControl::Force(_) => multiplier[axis] / problem.length,
            });
            let slip = |cell: usize| self.slip_of_step(cell).map(|slip| unit * slip);
            let traction = |cell: usize| at(&slices(&self.engine.traction), cell).map(|q| unit * q);
            let answer = solution.of(problem, traction, slip);
            answer.set_motion(creepage, self.engine.spin, self.engine.workspace.report());
            let (pressed, traction) = (&self.problem.pressed, slices(&self.engine.traction));
            let lift = self.engine.lifting.as_mut();
            let lift = lift.map_or(0.0, |lift| {
                lift.residual(pressed, traction, self.engine.unit)
            });
            let tolerance = self.problem.options.settings.tolerance;
            solution.set_neglected_lift(Warning::lift_beyond(lift, tolerance));
        }
        outcome
    }

    /// Returns the slip that is opposite to the traction of a cell in the last solution. This slip is the mean slip over the
    /// step. If directions are corrected, it is the slip at the end of the step.
    pub(in crate::rolling) fn slip(&self, cell: usize) -> [f64; 2] {
        let product = self.engine.workspace.product();
        let moved = plus(
            at(&product, cell),
            1.0,
            at(&slices(&self.engine.linear), cell),
        );
        let q = at(&slices(&self.engine.traction), cell);
        let slip = self.engine.own().added(moved, 1.0, cell, q);
        minus(slip, self.engine.workspace.multiplier())
    }

    /// Finds the spin of a moment by solves at given spins, starting at the spin of the last solve. Restores this spin after
    /// an error.
    fn solve_for_moment(
        &mut self,
        moment: f64,
        solution: &mut RollingSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let start = self.engine.spin;
        let settings = self.problem.options.settings;
        let mut conditions = SolveContext::new(&settings, observer);
        let outcome = self.search_spin(moment, solution, &mut conditions);
        if outcome.is_err() {
            self.engine.spin = start;
        }
        outcome
    }

    fn search_spin(
        &mut self,
        moment: f64,
        solution: &mut RollingSolution,
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        let tolerance = conditions.settings.tolerance;
        let ends = self.problem.moment_ends(self.problem.options.controls)?;
        let (half_range, stride) = (0.5 * (ends[1] - ends[0]).abs(), self.stride());
        let start = || SpinSearch::new(stride, ends.map(|end| moment - end));
        let (mut search, mut sharper) = (start(), SHARPER);
        self.engine.report.clear();
        for _ in 0..SPINS {
            let mut settings = conditions.with_remaining_limits(&self.engine.report);
            settings.tolerance = sharper * tolerance;
            let mut watch = with_counts_of(&self.engine.report, &mut *conditions.observer);
            let outcome = self.solve_at_spin(&settings, solution, &mut watch);
            drop(watch);
            if !has_iterate(&outcome) {
                return outcome;
            }
            self.engine.report.add_pass(&self.engine.passes);
            self.engine.report.time = conditions.start.elapsed();
            let missing = moment - solution.moment();
            let error = (missing / half_range).abs();
            self.engine.report.load_error = self.engine.report.load_error.max(error);
            // Near round-off a solve with a smaller tolerance can stall although it is accurate enough.
            let pass = &self.engine.passes;
            let is_stopped = !matches!(pass.status, Status::Converged | Status::Stalled);
            let is_sound = outcome.is_ok() || !is_stopped && pass.is_within(tolerance);
            let is_exhausted = self.engine.report.iterations >= conditions.settings.max_iterations;
            self.engine.report.status = if is_sound && error <= tolerance {
                Status::Converged
            } else if is_stopped {
                pass.status
            } else if is_exhausted {
                Status::IterationLimit
            } else {
                Status::Stalled
            };
            solution.set_report(&self.engine.report);
            if self.engine.report.is_converged() {
                return Ok(());
            }
            if is_stopped || is_exhausted {
                break;
            }
            if let Some(spin) = search.next(self.engine.spin, missing) {
                self.engine.spin = spin;
            } else if sharper > SHARPEST {
                // The moments of the last two spins differ by less than the error of the solves.
                sharper *= SHARPER;
                search = start();
            } else {
                break;
            }
        }
        Err(Error::NotConverged(Box::new(self.engine.report.clone())))
    }

    /// Returns a spin at which the cells farthest from the origin are near their limits.
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

    /// Returns the approximate displacement of a cell along its path through the contact under tractions at their
    /// limits.
    pub(in crate::rolling) fn largest_slip(&self) -> f64 {
        let limit = self
            .engine
            .limits
            .iter()
            .fold(0.0, |most: f64, limit| most.max(*limit));
        self.problem.chain as f64
            * self.engine.operator.self_compliance()
            * self.engine.unit
            * limit
    }

    /// Writes the linear term of each cell and returns the prescribed totals.
    fn compute_totals(&mut self) -> [Total; 2] {
        let problem = &self.problem;
        let given = problem.options.controls.map(|control| match control {
            RollingControl::Creepage(creepage) => creepage,
            RollingControl::Force(_) => 0.0,
        });
        let motion = [given[0], given[1], self.engine.spin];
        for (cell, index) in problem.pressed.window().indices().enumerate() {
            let motions = problem.motions(index);
            for axis in 0..2 {
                let parts = motions.iter().zip(motion);
                let moved = parts.fold(0.0, |sum, (part, motion)| sum + motion * part[axis]);
                let lag = self.engine.lag[axis].get(cell).unwrap_or(&0.0);
                self.engine.linear[axis][cell] =
                    (problem.drawn[axis][cell] - moved) / self.engine.unit + lag;
            }
        }
        let area = problem.bodies.grid().cell_area();
        problem.options.controls.map(|control| match control {
            RollingControl::Creepage(_) => Total::Free,
            RollingControl::Force(force) => Total::Sum(force / area / self.engine.unit),
        })
    }
}

/// Returns the slip of a cell over a step due to a unit traction of that cell.
fn self_compliance(compliance: &impl Operator<2>, step: WindowShift) -> Result<f64> {
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
