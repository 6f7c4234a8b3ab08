//! The reusable solver of coupled steady rolling.

use crate::bodies::component::Direction;
use crate::cgm::Settings;
use crate::contact::{
    Cancellation, Contact, Model, SolveContext, Solver, has_iterate, model_fields, with_counts_of,
};
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::memory::fallible::{self, TryClone};
use crate::normal::{GapChange, LastGap, NormalLoad, NormalProblem, NormalSolution, NormalSolver};
use crate::observer::Observer;
use crate::parallel::layout::Layout;
use crate::parallel::reduce;
use crate::report::{Report, Status};
use crate::rolling::coupled::{
    CoupledRollingProblem, CoupledRollingReport, CoupledRollingSolution,
};
use crate::rolling::steady::options::RollingOptions;
use crate::rolling::{RollingControl, RollingProblem, RollingSolution, RollingSolver};
use crate::tangential::{Lifting, TangentialModel, lift_residual};

/// Tolerance of the halves in the first pass.
const START: f64 = 1e-3;
/// Ratio of the tolerance of the halves to the error of the coupling in later passes. With a ratio of 0.1, the passes
/// alternated between two states under strong friction.
const SHARPER: f64 = 0.03;
/// Fraction of the tolerance that is available for the errors of the halves.
const HALVES: f64 = 0.3;
/// Smallest tolerance of the tractions. A smaller tolerance would be below round-off.
const LEAST_TOLERANCE: f64 = 1e-13;
/// Maximum number of passes of a solve.
const MOST_PASSES: usize = 100;
/// Number of passes without halving the error after which the solve has stalled.
const PATIENCE: usize = 15;
/// Factor that reduces a force to just below the friction capacity of an intermediate pass.
const HELD: f64 = 0.999;
/// Measured derivative of the pressure with respect to the tractions, divided by beta.
const TYPICAL: f64 = 0.7;

/// Solver of coupled rolling for a sequence of loads. Each solve starts from the last solution.
///
/// ```
/// use stickslip::rolling::{CoupledRollingProblem, RollingControl, SpinControl};
/// use stickslip::*;
/// let grid = Grid::square(24, 3.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?)?;
/// let (ball, friction) = (surface::sphere(grid, 1.0)?, Friction::coulomb(0.3)?);
/// let press = NormalLoad::Force(4.0 / 3.0);
/// let mut solver = CoupledRollingProblem::builder(&bodies, &ball, friction, press)
///     .build()?
///     .into_solver()?;
/// let mut rolling = solver.new_solution();
/// for force in [0.1, 0.2, 0.3] {
///     solver.set_load([RollingControl::Force(force), RollingControl::Creepage(0.0)], SpinControl::Spin(0.0))?;
///     let before = rolling.rolling().creepage()[0];
///     solver.solve_into(&mut rolling)?;
///     assert!((rolling.rolling().force()[0] - force).abs() < 1e-8);
///     assert!(rolling.rolling().creepage()[0] > before);
/// }
/// # Ok::<(), Error>(())
/// ```
pub type CoupledRollingSolver = Solver<CoupledRollingProblem>;

/// Engine of coupled rolling.
#[derive(Clone)]
pub(crate) struct CoupledRollingEngine {
    pub(super) normal: NormalSolver,
    /// Rolling solver of the last pass, or `None` before the first pass.
    pub(super) rolling: Option<RollingSolver>,
    /// Operator of the lift on the whole grid, or `None` for bodies that are not coupled.
    pub(super) lifting: Option<Lifting>,
    /// Bound on the coupling between the energy norms, times the square root of the largest tangential eigenvalue.
    reach: f64,
    /// Tractions whose lift the gap contains.
    traction: [Vec<f64>; 2],
    lift: Vec<f64>,
    spin: f64,
    is_warm: bool,
    pub(super) last_gap: LastGap,
    /// Name of the input that has changed since the last solution, for error messages.
    pub(super) changed: Option<&'static str>,
    /// Normal half of the last solution of coupled bodies.
    pub(super) last: Option<NormalSolution>,
    pub(super) report: CoupledRollingReport,
}

/// Outcome of a pass over both halves.
struct Pass {
    /// Status of a half that did not reach its tolerance, or `None` if neither half failed.
    failure: Option<Status>,
    /// Error for a force beyond the friction capacity, if the pass reduced a force.
    held: Option<Error>,
}

impl Contact for CoupledRollingProblem {
    type Solution = CoupledRollingSolution;
    type Report = CoupledRollingReport;
}

impl Model<CoupledRollingSolution> for CoupledRollingProblem {
    type Engine = CoupledRollingEngine;

    model_fields!(options.settings);

    fn check_settings(&self, settings: &Settings) -> Result<()> {
        TangentialModel::Vector.check(settings)
    }

    fn engine(&self) -> Result<CoupledRollingEngine> {
        let bodies = &self.bodies;
        let (cells, size) = (bodies.grid().cells(), bodies.grid().size());
        let normal = NormalProblem::builder(bodies, self.gap.clone(), self.normal)
            .settings(self.options.settings)
            .build()?
            .into_solver()?;
        let (mut lifting, mut reach) = (None, 0.0);
        if bodies.pair().is_coupled() {
            let [x, y, z] = [Direction::X, Direction::Y, Direction::Z];
            let coupling = bodies.compliance([z, x, y], size)?.operator.coupling();
            let plane = bodies.compliance([x, y], size)?.operator.upper_bound();
            lifting = Some(Lifting::new(bodies, size)?);
            reach = coupling * plane.sqrt();
        }
        Ok(CoupledRollingEngine {
            normal,
            rolling: None,
            lifting,
            reach,
            traction: fallible::vector(cells)?,
            lift: fallible::zeros(cells)?,
            spin: 0.0,
            is_warm: false,
            last_gap: LastGap::new(bodies.grid())?,
            changed: None,
            last: None,
            report: CoupledRollingReport::unsolved(),
        })
    }

    fn empty_solution(&self) -> Result<CoupledRollingSolution> {
        let surface = (self.bodies.boundary(), self.bodies.cell_value());
        Ok(CoupledRollingSolution {
            normal: NormalSolution::empty(&self.gap, surface, self.bodies.pair())?,
            rolling: RollingSolution::empty(self.bodies.grid())?,
            report: CoupledRollingReport::unsolved(),
        })
    }

    fn check_solution(&self, solution: &CoupledRollingSolution) -> Result<()> {
        let grid = self.bodies.grid();
        grid.check_equal("solution", solution.normal.grid())?;
        grid.check_equal("solution", solution.rolling.grid())
    }

    fn solve(
        solver: &mut CoupledRollingSolver,
        solution: &mut CoupledRollingSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let cancellation = Cancellation::default();
        let settings = solver.problem.options.settings;
        let mut observer = cancellation.watch(&settings, observer);
        let mut conditions = SolveContext::new(&settings, &mut observer);
        // If a solve ends without an iterate, neither the earlier solution nor a new one is available.
        solver.engine.changed = Some("the input");
        let CoupledRollingEngine {
            normal, last_gap, ..
        } = &mut solver.engine;
        let CoupledRollingProblem { bodies, gap, .. } = &solver.problem;
        let wear = last_gap.take_wear(bodies, gap, normal.last_contact());
        let outcome = solver.solve_passes(solution, &mut conditions);
        let outcome = cancellation.applied(&solver.problem.bodies, outcome, || {
            solver.engine.report.work.cancelled()
        });
        solver.finish(solution, &outcome, wear);
        outcome
    }

    fn report(solver: &CoupledRollingSolver) -> &CoupledRollingReport {
        &solver.engine.report
    }

    fn reset(solver: &mut CoupledRollingSolver) {
        let engine = &mut solver.engine;
        engine.normal.reset();
        engine.rolling = None;
        for part in &mut engine.traction {
            part.fill(0.0);
        }
        engine.spin = 0.0;
        engine.is_warm = false;
        engine.last = None;
    }
}

impl CoupledRollingSolver {
    /// Repeats passes until the pressure and the tractions are consistent with each other.
    fn solve_passes(
        &mut self,
        solution: &mut CoupledRollingSolution,
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        self.engine.report.clear();
        let tolerance = conditions.settings.tolerance;
        let floor = if self.engine.lifting.is_some() {
            HALVES * tolerance
        } else {
            tolerance
        };
        let mut inner = if self.engine.lifting.is_some() {
            START.max(floor)
        } else {
            tolerance
        };
        let (mut best, mut without) = (f64::INFINITY, 0);
        let mut before = fallible::zeros(self.engine.lift.len())?;
        loop {
            let pass = self.solve_pass(inner, solution, conditions)?;
            self.engine.report.passes += 1;
            self.engine.report.work.time = conditions.start.elapsed();
            let error = self.examine(&mut before, solution)?;
            if let Some(status) = pass.failure {
                return self.engine.report.end(status);
            }
            let is_sharp = inner <= floor;
            if is_sharp && self.engine.report.merit() <= tolerance {
                if let Some(error) = pass.held {
                    return Err(error);
                }
                return self.engine.report.end(Status::Converged);
            }
            if self.engine.lifting.is_none() {
                return self.engine.report.end(Status::Stalled);
            }
            if error < 0.5 * best {
                (best, without) = (error, 0);
            } else {
                without += 1;
            }
            let is_stuck = without >= PATIENCE || self.engine.report.passes >= MOST_PASSES;
            if is_stuck || error.is_nan() {
                return self.engine.report.end(Status::Stalled);
            }
            conditions.check_iterations_left(&mut self.engine.report.work)?;
            for (kept, found) in self
                .engine
                .traction
                .iter_mut()
                .zip(solution.rolling.traction())
            {
                kept.copy_from_slice(found.as_slice());
            }
            inner = (SHARPER * error).clamp(floor, START.max(floor));
        }
    }

    /// Returns the new tractions minus the tractions whose lift the gap contains.
    fn residual_of(&self, rolling: &RollingSolution) -> Result<[Vec<f64>; 2]> {
        fallible::try_each(|axis| {
            let found = rolling.traction()[axis].as_slice();
            let pairs = found.iter().zip(&self.engine.traction[axis]);
            fallible::collected(found.len(), pairs.map(|(found, known)| found - known))
        })
    }

    /// Solves for the pressure over the lifted gap, then for the tractions under this pressure.
    fn solve_pass(
        &mut self,
        tolerance: f64,
        solution: &mut CoupledRollingSolution,
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<Pass> {
        let mut pass = Pass {
            failure: None,
            held: None,
        };
        self.lift_gap()?;
        let settings = conditions
            .with_remaining_limits(&self.engine.report.work)
            .tolerance(tolerance);
        self.engine.normal.set_settings(settings)?;
        let mut observer = with_counts_of(&self.engine.report.work, &mut *conditions.observer);
        let outcome = self
            .engine
            .normal
            .solve_observed(&mut solution.normal, &mut observer);
        drop(observer);
        pass.failure = ended(outcome, conditions.settings.tolerance)?;
        let report = solution.normal.report();
        self.engine.report.normal.add_pass(report);
        add_counts(&mut self.engine.report.work, report);
        if pass.failure.is_some() {
            let (normal, rolling) = (&solution.normal, &mut solution.rolling);
            rolling.restrict_to(&self.problem.friction, normal.pressure());
            return Ok(pass);
        }
        // A half that has stalled within the tolerance counts as converged.
        let (.., report) = solution.normal.parts_mut();
        report.status = Status::Converged;
        let settings = conditions
            .with_remaining_limits(&self.engine.report.work)
            .tolerance(tolerance);
        let mut posed = self.pose(&solution.normal, settings, &mut pass)?;
        if self.engine.lifting.is_some() {
            posed.options.settings.tolerance = (posed.noise() * tolerance).max(LEAST_TOLERANCE);
        }
        let mut solver = RollingSolver::new(posed)?;
        // The coupled solve takes the whole lift into account.
        solver.engine.lifting = None;
        if self.engine.report.passes > 0 {
            solver.take_start(
                solution.rolling.traction().map(Field::as_slice),
                self.engine.spin,
            );
        } else if self.engine.is_warm {
            solver.take_start(
                self.engine.traction.each_ref().map(Vec::as_slice),
                self.engine.spin,
            );
        }
        let allowed = conditions.settings.tolerance;
        for is_last in [false, true] {
            let mut observer = with_counts_of(&self.engine.report.work, &mut *conditions.observer);
            let outcome = solver.solve_observed(&mut solution.rolling, &mut observer);
            drop(observer);
            pass.failure = ended(outcome, allowed)?;
            let report = solution.rolling.report();
            self.engine.report.rolling.add_pass(report);
            add_counts(&mut self.engine.report.work, report);
            // The initial guess may have caused the stall, so the second attempt starts from zero tractions.
            if is_last || pass.failure != Some(Status::Stalled) {
                break;
            }
            solver.reset();
        }
        self.engine.spin = solution.rolling.spin();
        self.engine.is_warm = true;
        self.engine.rolling = Some(solver);
        Ok(pass)
    }

    /// Passes the gap with the lift due to the tractions to the normal solver.
    fn lift_gap(&mut self) -> Result<()> {
        self.engine.normal.set_load(self.problem.normal)?;
        let Some(lifting) = &mut self.engine.lifting else {
            return self.engine.normal.replace_gap(&self.problem.gap);
        };
        lifting.lift(
            self.engine
                .traction
                .each_ref()
                .map(|part| Some(part.as_slice())),
            &mut self.engine.lift,
        );
        let mut gap = self.problem.gap.try_clone()?;
        for (gap, lift) in gap.as_mut_slice().iter_mut().zip(&self.engine.lift) {
            *gap += lift;
        }
        self.engine.normal.replace_gap(&gap)
    }

    /// Creates the rolling problem for a pressure. Reduces the forces if they exceed the friction capacity under this
    /// pressure, because the pressure of a later pass may carry them.
    fn pose(
        &self,
        normal: &NormalSolution,
        settings: Settings,
        pass: &mut Pass,
    ) -> Result<RollingProblem> {
        let of = &self.problem;
        let posed = |controls: [RollingControl; 2]| {
            let options = RollingOptions {
                controls,
                settings,
                ..of.options
            };
            let friction = of.friction.try_clone()?;
            let builder = RollingProblem::builder(&of.bodies, normal, friction);
            builder.with_options(options).build()
        };
        match posed(of.options.controls) {
            Err(error @ Error::BeyondFrictionCapacity { force, limit, .. })
                if self.engine.lifting.is_some() && limit > 0.0 =>
            {
                pass.held = Some(error);
                posed(of.options.controls.map(|control| match control {
                    RollingControl::Force(part) => {
                        RollingControl::Force(HELD * limit / force * part)
                    }
                    creepage => creepage,
                }))
            }
            posed => posed,
        }
    }

    /// Computes the error of each half for the current state of the other half. Returns the error of the coupling
    /// between the halves.
    fn examine(&mut self, before: &mut [f64], solution: &CoupledRollingSolution) -> Result<f64> {
        let (normal, rolling) = (&solution.normal, &solution.rolling);
        let layout = normal.grid().layout();
        let pressure = normal.pressure().as_slice();
        let [change, size] = reduce::sum(&layout, |i| {
            let change = pressure[i] - before[i];
            [change * change, pressure[i] * pressure[i]]
        });
        before.copy_from_slice(pressure);
        let (coupling, energy) = self.coupling_errors(&layout, solution)?;
        let report = &mut self.engine.report;
        // A single pass is exact if the tractions cause no lift.
        report.pressure_change = match self.engine.lifting {
            None => 0.0,
            Some(_) => ratio(change.sqrt(), size.sqrt()),
        };
        report.coupling_residual = coupling;
        let (of_normal, of_rolling) = (normal.report(), rolling.report());
        report.pressure_error_bound = of_normal.energy_error_bound() + energy;
        report.traction_error_bound = of_rolling.energy_error_bound();
        let residuals = [of_normal.residual + coupling, of_rolling.residual];
        let loads = [of_normal.load_error, of_rolling.load_error];
        report.work.residual = reduce::larger(residuals[0], residuals[1]);
        report.work.load_error = reduce::larger(loads[0], loads[1]);
        report.work.eigenvalue_bound = of_normal.eigenvalue_bound.min(of_rolling.eigenvalue_bound);
        let beta = TYPICAL * self.problem.bodies.pair().coupling_strength().abs();
        let friction = self
            .problem
            .friction
            .largest_coefficient(&self.problem.bodies);
        let rest = 1.0 - beta * (beta + friction);
        let whole = report.pressure_error_bound + beta * report.traction_error_bound;
        report.error_estimate = (rest > 0.0).then(|| whole / rest);
        Ok(reduce::larger(coupling, energy))
    }

    /// Returns the residual of the normal law and a bound on the relative change of the pressure in the energy norm.
    /// Both are caused by the tractions whose lift the gap does not contain.
    fn coupling_errors(
        &mut self,
        layout: &Layout,
        solution: &CoupledRollingSolution,
    ) -> Result<(f64, f64)> {
        let residual = self.residual_of(&solution.rolling)?;
        let Some(lifting) = &mut self.engine.lifting else {
            return Ok((0.0, 0.0));
        };
        let normal = &solution.normal;
        let (pressure, gap) = (normal.pressure().as_slice(), normal.gap().as_slice());
        let (initial, approach) = (self.problem.gap.as_slice(), normal.approach());
        let known = &self.engine.lift;
        let displacement = |i: usize| gap[i] - (initial[i] + known[i] - approach);
        let mut lift = fallible::zeros(known.len())?;
        lifting.lift(
            residual.each_ref().map(|part| Some(part.as_slice())),
            &mut lift,
        );
        let is_fixed = matches!(self.problem.normal, NormalLoad::Approach(_));
        let is_contact = |i: usize| pressure[i] > 0.0;
        let coupling = lift_residual(layout, is_contact, |i| lift[i], displacement, is_fixed);
        let [squares, energy] = reduce::sum(layout, |i| {
            let [x, y] = [residual[0][i], residual[1][i]];
            [x * x + y * y, pressure[i] * displacement(i)]
        });
        let energy = ratio(self.engine.reach * squares.sqrt(), energy.max(0.0).sqrt());
        Ok((coupling, energy))
    }

    /// Writes the report and marks both halves as halves of a coupled contact.
    fn finish(
        &mut self,
        solution: &mut CoupledRollingSolution,
        outcome: &Result<()>,
        wear: GapChange,
    ) {
        if self.engine.lifting.is_some() {
            self.engine.report.work.duality_gap = f64::INFINITY;
        }
        solution.report.clone_from(&self.engine.report);
        if has_iterate(outcome) && self.engine.lifting.is_some() {
            let CoupledRollingProblem { bodies, gap, .. } = &self.problem;
            let normal = &mut solution.normal;
            normal.measure_scale(bodies, gap);
            normal.set_coupled(true);
            normal.parts_mut().3.clone_from(&self.engine.report.work);
            solution.rolling.set_report(&self.engine.report.work);
        }
        if has_iterate(outcome) {
            let CoupledRollingProblem { bodies, gap, .. } = &self.problem;
            let last_gap = &mut self.engine.last_gap;
            last_gap.finish((bodies, gap), wear, &mut solution.normal);
        } else {
            self.engine.last_gap.postpone(wear);
        }
        // The next solve starts from these tractions.
        for (kept, found) in self
            .engine
            .traction
            .iter_mut()
            .zip(solution.rolling.traction())
        {
            kept.copy_from_slice(found.as_slice());
        }
        if self.engine.lifting.is_some() {
            self.engine.last = solution.normal.try_clone().ok();
        }
        if !has_iterate(outcome) || !self.engine.report.work.residual.is_finite() {
            self.reset();
        } else {
            self.engine.changed = None;
        }
    }
}

/// Adds the counts of a half to the counts of the coupled solve.
fn add_counts(work: &mut Report, half: &Report) {
    let whole = (work.status, work.residual, work.duality_gap);
    work.add_pass(half);
    (work.status, work.residual, work.duality_gap) = whole;
}

/// Returns the status of a half, or `None` if it reached its tolerance or stalled within `allowed`.
fn ended(outcome: Result<()>, allowed: f64) -> Result<Option<Status>> {
    match outcome {
        Ok(()) => Ok(None),
        Err(Error::NotConverged(report)) => {
            let serves = report.status == Status::Stalled && report.is_within(allowed);
            Ok((!serves).then_some(report.status))
        }
        Err(error) => Err(error),
    }
}

fn ratio(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}

impl RollingProblem {
    /// Returns the ratio of the norm of rolling to the energy norm for the smoothest tractions. The tolerance of the
    /// tractions is multiplied by this ratio, because the lift follows the energy norm.
    fn noise(&self) -> f64 {
        let angle = std::f64::consts::PI / (self.chain as f64 + 1.0);
        std::f64::consts::SQRT_2 * (0.5 * angle).sin()
    }
}

impl RollingSolver {
    /// Sets tractions on the grid and a spin as the start of the next solve.
    fn take_start(&mut self, traction: [&[f64]; 2], spin: f64) {
        for (cell, index) in self.problem.pressed.window().indices().enumerate() {
            for (own, traction) in self.engine.traction.iter_mut().zip(traction) {
                own[cell] = traction[index] / self.engine.unit;
            }
        }
        self.engine.spin = spin;
    }
}
