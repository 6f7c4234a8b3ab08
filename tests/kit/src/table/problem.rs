//! Contact problems of the scenes. A problem has the bodies, gap and friction of a scene, and the loads of one of its
//! steps, from rest.

use std::fmt;
use std::ops::ControlFlow;

use stickslip::cgm::Settings;
use stickslip::rolling::{
    CoupledRollingProblem, CoupledRollingSolver, RollingControl, RollingProblem, RollingSolver,
    SpinControl,
};
use stickslip::{
    Axis, CoupledProblem, CoupledSolver, Coupling, Field, Iteration, NormalControl, NormalLoad,
    NormalProblem, NormalSolution, NormalSolver, Report, Result, TangentialControl, TangentialLoad,
    TangentialModel, TangentialProblem, TangentialSolver, Zone,
};

use super::{Measured, Roll, Scene, Step, UnitTransform};

/// Kind of a problem. A separate problem has tractions under the pressure of a normal problem.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    Normal,
    Separate,
    Coupled,
}

/// Input of a problem: the scene, the step with its loads, and the kind.
#[derive(Debug, Clone)]
pub struct Problem {
    pub scene: Scene,
    pub step: Step,
    pub kind: Kind,
}

/// Solver of a problem. A separate problem is stored with its pressure.
#[derive(Debug, Clone)]
#[allow(clippy::large_enum_variant, reason = "a test has few solvers")]
pub enum ProblemSolver {
    Normal(NormalSolver),
    Tangential(NormalSolution, TangentialSolver),
    Coupled(CoupledSolver),
    Rolling(NormalSolution, RollingSolver),
    CoupledRolling(CoupledRollingSolver),
}

/// Solution of a problem of any kind.
#[derive(Debug, Clone)]
pub struct Found {
    pub normal: NormalSolution,
    pub traction: [Field; 2],
    /// Slip, or slip per length rolled.
    pub slip: [Field; 2],
    pub zones: Vec<Zone>,
    /// Shifts and twist, or creepages and spin.
    pub motion: [f64; 3],
    /// Forces along x and y, and moment.
    pub force: [f64; 3],
    pub report: Report,
}

/// Returns the solution from a solution of tractions, whose accessors of the motion have the given names.
macro_rules! found {
    ($normal:expr, $of:expr, $shift:ident, $turn:ident, $report:expr) => {{
        let of = &$of;
        let ([x, y], [fx, fy]) = (of.$shift(), of.force());
        Found {
            normal: $normal.clone(),
            traction: of.traction().map(Field::clone),
            slip: of.slip().map(Field::clone),
            zones: of.zones().to_vec(),
            motion: [x, y, of.$turn()],
            force: [fx, fy, of.moment()],
            report: $report.clone(),
        }
    }};
}

/// Evaluates an expression with the solver of any kind.
macro_rules! with_solver {
    ($solver:expr, $name:ident => $value:expr) => {
        match $solver {
            Self::Normal($name) => $value,
            Self::Tangential(_, $name) => $value,
            Self::Coupled($name) => $value,
            Self::Rolling(_, $name) => $value,
            Self::CoupledRolling($name) => $value,
        }
    };
}

impl ProblemSolver {
    pub fn set_settings(&mut self, settings: Settings) -> Result<()> {
        with_solver!(self, solver => solver.set_settings(settings))
    }

    /// Sets the loads of a problem of the same kind. The pressure of a separate problem remains.
    pub fn set_loads(&mut self, problem: &Problem) -> Result<()> {
        let step = &problem.step;
        let (press, shear) = (normal_load(step), problem.shear_load(step));
        let controls = step
            .roll
            .map(|roll| (rolling_controls(step, &roll), SpinControl::Spin(roll.spin)));
        match self {
            Self::Normal(solver) => solver.set_load(press),
            Self::Tangential(_, solver) => solver.set_load(shear),
            Self::Coupled(solver) => solver.set_loads(press, shear),
            Self::Rolling(_, solver) => {
                let (controls, spin) = controls.unwrap();
                solver.set_load(controls, spin)
            }
            Self::CoupledRolling(solver) => {
                let (controls, spin) = controls.unwrap();
                solver.set_normal_load(press)?;
                solver.set_load(controls, spin)
            }
        }
    }

    pub fn reset(&mut self) {
        with_solver!(self, solver => solver.reset());
    }

    /// Solves, and returns the outcome and the last iterate.
    pub fn solve(
        &mut self,
        observer: &mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send),
    ) -> (Result<()>, Found) {
        match self {
            Self::Normal(solver) => {
                let mut normal = solver.new_solution();
                let outcome = solver.solve_observed(&mut normal, observer);
                let [zero, none] = [(); 2].map(|()| Field::zeros(normal.grid()));
                let found = Found {
                    traction: [zero.clone(), zero],
                    slip: [none.clone(), none],
                    zones: Vec::new(),
                    motion: [0.0; 3],
                    force: [0.0; 3],
                    report: normal.report().clone(),
                    normal,
                };
                (outcome, found)
            }
            Self::Tangential(normal, solver) => {
                let mut of = solver.new_solution();
                let outcome = solver.solve_observed(&mut of, observer);
                (outcome, found!(normal, of, shift, twist, of.report()))
            }
            Self::Coupled(solver) => {
                let mut both = solver.new_solution();
                let outcome = solver.solve_observed(&mut both, observer);
                let (of, report) = (both.tangential(), &both.report().work);
                (outcome, found!(both.normal(), of, shift, twist, report))
            }
            Self::Rolling(normal, solver) => {
                let mut of = solver.new_solution();
                let outcome = solver.solve_observed(&mut of, observer);
                (outcome, found!(normal, of, creepage, spin, of.report()))
            }
            Self::CoupledRolling(solver) => {
                let mut both = solver.new_solution();
                let outcome = solver.solve_observed(&mut both, observer);
                let (of, report) = (both.rolling(), &both.report().work);
                (outcome, found!(both.normal(), of, creepage, spin, report))
            }
        }
    }
}

/// Returns the load of the normal problem.
fn normal_load(step: &Step) -> NormalLoad {
    match step.normal {
        NormalControl::Force(force) => NormalLoad::Force(force),
        NormalControl::Approach(approach) => NormalLoad::Approach(approach),
        other => panic!("{other:?} is no load from rest"),
    }
}

fn rolling_controls(step: &Step, roll: &Roll) -> [RollingControl; 2] {
    [0, 1].map(|axis| match step.shear[axis] {
        TangentialControl::Force(force) => RollingControl::Force(force),
        _ => RollingControl::Creepage(roll.creepage[axis]),
    })
}

/// Sets the loads, the motion and the settings of a builder of a rolling problem.
macro_rules! rolling {
    ($builder:expr, $problem:expr, $step:expr, $roll:expr, $settings:expr) => {{
        let roll = $roll;
        let [x, y] = rolling_controls($step, &roll);
        $builder
            .leading_edge(roll.edge)
            .step(roll.cells)
            .control(Axis::X, x)
            .control(Axis::Y, y)
            .spin(roll.spin)
            .entry_rule($problem.scene.entry_rule)
            .settings($settings)
            .build()?
            .into_solver()?
    }};
}

impl Problem {
    /// Returns the problems of a scene with the loads of up to `count` steps.
    pub fn of(scene: &Scene, count: usize) -> Vec<Self> {
        let is_load = |step: &&Step| {
            let is_hold = |control: &TangentialControl| *control == TangentialControl::Hold;
            step.normal != NormalControl::Hold
                && (step.roll.is_some() || !step.shear.iter().all(is_hold))
        };
        let kinds: &[Kind] = if scene.is_fully_coupled() {
            &[Kind::Coupled]
        } else {
            &[Kind::Normal, Kind::Separate]
        };
        let steps = scene.path.iter().filter(is_load).take(count);
        let problems = steps.flat_map(|step| {
            kinds.iter().map(|&kind| Self {
                scene: scene.clone(),
                step: *step,
                kind,
            })
        });
        problems.collect()
    }

    /// Returns the tangential load of a step. The contact does not move along an axis that the step holds.
    fn shear_load(&self, step: &Step) -> TangentialLoad {
        let held = match self.scene.model {
            TangentialModel::Scalar => TangentialControl::Force(0.0),
            _ => TangentialControl::Shift(0.0),
        };
        let [x, y] = step.shear.map(|control| match control {
            TangentialControl::Hold => held,
            other => other,
        });
        let load = TangentialLoad::force([0.0; 2])
            .along(Axis::X, x)
            .along(Axis::Y, y);
        load.twist(step.twist.unwrap_or(0.0))
    }

    /// Returns the solver of the problem, transformed by the pose. The pressure of a separate problem has the tolerance
    /// of the scene.
    pub fn solver(&self, pose: &UnitTransform, settings: Settings) -> Result<ProblemSolver> {
        let scene = &self.scene;
        let bodies = &scene.half_space(pose);
        let (grid, step) = (bodies.grid(), &scene.transformed(&self.step, pose));
        let (gap, friction) = (scene.gap(grid, pose), scene.friction(grid, pose));
        let (hardness, press) = (scene.hardness(grid, pose), normal_load(step));
        let bulk = scene.bulk_strain(grid, pose, step.strain.unwrap_or(0.0));
        let shear = self.shear_load(step);
        if self.kind == Kind::Coupled {
            if let Some(roll) = step.roll {
                let rolling = CoupledRollingProblem::builder(bodies, gap, friction, press);
                let solver = rolling!(rolling, self, step, roll, settings);
                return Ok(ProblemSolver::CoupledRolling(solver));
            }
            let mut both = CoupledProblem::builder(bodies, gap, friction, press, shear);
            if let Some(hardness) = hardness {
                both = both.hardness(hardness);
            }
            if let Some(bulk) = bulk {
                both = both.relative_displacement(bulk);
            }
            let solver = both.settings(settings).build()?.into_solver()?;
            return Ok(ProblemSolver::Coupled(solver));
        }
        let mut problem = NormalProblem::builder(bodies, gap, press);
        if let Some(hardness) = hardness {
            problem = problem.hardness(hardness);
        }
        if self.kind == Kind::Normal {
            let solver = problem.settings(settings).build()?.into_solver()?;
            return Ok(ProblemSolver::Normal(solver));
        }
        let normal = problem.tolerance(scene.tolerance).build()?.solve()?;
        if let Some(roll) = step.roll {
            let rolling = RollingProblem::builder(bodies, &normal, friction);
            let solver = rolling!(rolling, self, step, roll, settings);
            return Ok(ProblemSolver::Rolling(normal, solver));
        }
        let mut problem = TangentialProblem::builder(bodies, &normal, friction, shear);
        if scene.coupling != Coupling::Full {
            problem = problem.coupling(scene.coupling);
        }
        if let Some(bulk) = bulk {
            problem = problem.relative_displacement(bulk);
        }
        let problem = problem.model(scene.model).settings(settings).build()?;
        let solver = problem.into_solver()?;
        Ok(ProblemSolver::Tangential(normal, solver))
    }

    /// Solves the problem in place with a tolerance.
    pub fn solve(&self, tolerance: f64) -> Found {
        self.solve_in(&UnitTransform::IN_PLACE, tolerance)
    }

    /// Solves the transformed problem with a tolerance.
    pub fn solve_in(&self, pose: &UnitTransform, tolerance: f64) -> Found {
        let settings = Settings::default().tolerance(tolerance);
        let solver = self.solver(pose, settings);
        let (outcome, found) = solver.unwrap().solve(&mut |_| ControlFlow::Continue(()));
        outcome.unwrap_or_else(|error| panic!("{self}: {error}"));
        found
    }

    /// Returns the problem that prescribes the motion of a solution.
    pub fn moved_as(&self, found: &Found) -> Self {
        let [x, y, turn] = found.motion;
        let mut moved = self.clone();
        moved.step.normal = NormalControl::Approach(found.normal.approach());
        moved.step.shear = [x, y].map(TangentialControl::Shift);
        if let Some(roll) = &mut moved.step.roll {
            (roll.creepage, roll.spin) = ([x, y], turn);
        }
        moved
    }

    /// Returns the problem that prescribes the forces of a solution.
    pub fn forced_as(&self, found: &Found) -> Self {
        let [x, y, _] = found.force;
        let mut forced = self.clone();
        forced.step.normal = NormalControl::Force(found.normal.force());
        forced.step.shear = [x, y].map(TangentialControl::Force);
        forced
    }

    /// Returns the problem with these parts of its normal and tangential loads. The pressure of a separate problem
    /// remains.
    pub fn part(&self, normal: f64, tangential: f64) -> Self {
        let mut part = self.clone();
        part.step.normal = match self.step.normal {
            NormalControl::Force(force) => NormalControl::Force(normal * force),
            NormalControl::Approach(approach) => NormalControl::Approach(normal * approach),
            other => other,
        };
        part.step.shear = self.step.shear.map(|control| match control {
            TangentialControl::Force(force) => TangentialControl::Force(tangential * force),
            TangentialControl::Shift(shift) => TangentialControl::Shift(tangential * shift),
            other => other,
        });
        if let Some(roll) = &mut part.step.roll {
            roll.creepage = roll.creepage.map(|creepage| tangential * creepage);
        }
        part
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { scene, step, kind } = self;
        write!(formatter, "{}, {kind:?}: {step:?}", scene.name)
    }
}

impl Found {
    /// Returns whether both solutions and their costs are equal. The times may differ.
    pub fn is_same(&self, other: &Self) -> bool {
        let parts = |of: &Self| {
            let cost = (of.report.history.clone(), of.report.products());
            (
                of.normal.clone(),
                of.traction.clone(),
                of.slip.clone(),
                of.zones.clone(),
                of.motion,
                cost,
            )
        };
        parts(self) == parts(other)
    }

    /// Returns the numbers of the solution, transformed back to the scene.
    pub fn measured(&self, scene: &Scene, pose: &UnitTransform, is_rolling: bool) -> Measured {
        let (mut measured, unit) = (Measured::default(), scene.energy_unit(pose));
        let along = |vector: [f64; 2]| pose.back(vector).map(|value| pose.side() * value);
        measured.add_field(
            pose,
            |of| &mut of.pressures,
            self.normal.pressure(),
            pose.pressure,
        );
        measured.add_field(pose, |of| &mut of.lengths, self.normal.gap(), pose.length);
        measured.add_vectors(
            pose,
            |of| &mut of.pressures,
            self.traction.each_ref(),
            pose.pressure,
        );
        measured.lengths.push(self.normal.approach() / pose.length);
        let ([x, y, turn], [fx, fy, moment]) = (self.motion, self.force);
        let forces = [self.normal.force()].into_iter().chain(along([fx, fy]));
        measured
            .forces
            .extend(forces.map(|force| force * pose.length / unit));
        measured.forces.push(pose.turn() * moment / unit);
        let turn = pose.turn() * turn;
        if is_rolling {
            measured.creepages.extend(along([x, y]));
            measured.creepages.push(turn * pose.length);
        } else {
            measured.add_vectors(
                pose,
                |of| &mut of.lengths,
                self.slip.each_ref(),
                pose.length,
            );
            measured
                .lengths
                .extend(along([x, y]).map(|shift| shift / pose.length));
            measured.creepages.push(turn);
        }
        measured
    }
}
