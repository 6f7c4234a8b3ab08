//! No call returns a result of an earlier input or of a rejected step. The last step is missing after a restored state, and
//! a stiffness is an error after a change of the input.

use std::ops::ControlFlow;

use kit::unit_bodies;
use stickslip::cgm::Settings;
use stickslip::history::{AdaptiveSteps, Cycle};
use stickslip::rolling::{CoupledRollingProblem, RollingControl, RollingProblem, SpinControl};
use stickslip::sensitivity::Functional;
use stickslip::stiffness::{ContactStiffness, StiffnessWorkspace};
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Axis, CoupledProblem, ElasticPair, Error, Field, Friction, Grid, HalfSpace, History, LoadStep,
    Material, NormalLoad, NormalProblem, NormalSolution, Status, TangentialControl, TangentialLoad,
    TangentialProblem, surface,
};

const FORCE: f64 = 1.0;
const FRICTION: f64 = 0.3;

fn friction() -> Friction {
    Friction::coulomb(FRICTION).unwrap()
}

fn bodies() -> HalfSpace {
    unit_bodies(Grid::square(24, 3.0).unwrap(), 0.3)
}

fn press() -> LoadStep {
    LoadStep::hold().normal(NormalLoad::Force(FORCE))
}

/// Returns a step to a fraction of the friction capacity.
fn shear(part: f64) -> LoadStep {
    LoadStep::force([part * FRICTION * FORCE, 0.0])
}

fn pressed(bodies: &HalfSpace) -> History {
    let ball = surface::sphere(bodies.grid(), 1.0).unwrap();
    let mut history = History::builder(bodies, &ball, friction()).build().unwrap();
    history.step(&press()).unwrap();
    history
}

fn has_no_last_step(history: &History) -> bool {
    history
        .last_step()
        .is_err_and(|error| error == Error::NoLastStep)
}

#[test]
fn only_step_that_led_to_state_is_last_step() {
    let bodies = bodies();
    let ball = surface::sphere(bodies.grid(), 1.0).unwrap();
    let new = History::builder(&bodies, &ball, friction())
        .build()
        .unwrap();
    assert!(has_no_last_step(&new));
    let mut history = pressed(&bodies);
    let before = history.state().clone();
    history.step(&shear(0.9)).unwrap();
    assert_eq!(history.last_step().unwrap().shift(), history.shift());
    let read = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
    assert!(has_no_last_step(&read));
    assert!(has_no_last_step(
        &History::from_state(&bodies, before.clone()).unwrap()
    ));
    assert!(history.clone().last_step().is_ok());

    // A failed step undoes nothing, and a restored state undoes the step.
    kit::assert_refused! { history.step(&shear(1.1)) => Error::BeyondFrictionCapacity { .. } }
    assert!(history.last_step().is_ok());
    history.set_state(&before).unwrap();
    assert!(has_no_last_step(&history) && has_no_last_step(&history.clone()));
    history.step(&shear(0.4)).unwrap();
    assert_eq!(history.last_step().unwrap().shift(), history.shift());
}

/// A retry adds the accepted step to the cycle, and not the rejected one.
#[test]
fn cycle_of_retried_steps_equals_cycle_of_accepted_steps() {
    let bodies = bodies();
    let (mut history, mut direct) = (pressed(&bodies), pressed(&bodies));
    let mut cycles = [&history, &direct].map(Cycle::new);
    let mut kept = history.state().clone();
    for part in [0.4, 0.8, -0.4, -0.8, 0.0] {
        kept.clone_from(history.state());
        history.step(&shear(-part)).unwrap();
        history.set_state(&kept).unwrap();
        let before = cycles[0].clone();
        kit::assert_refused! { cycles[0].add(&history) => Error::NoLastStep }
        assert_eq!(cycles[0], before);
        history.step(&shear(part)).unwrap();
        cycles[0].add(&history).unwrap();
        direct.step(&shear(part)).unwrap();
        cycles[1].add(&direct).unwrap();
    }
    assert_eq!(cycles[0], cycles[1]);
    assert!(cycles[0].energy().dissipated_energy > 0.0);

    // A cycle does not accept the last step of a history that was restored beyond the start of the cycle.
    let mut early = Cycle::new(&pressed(&bodies));
    history.set_state(&kept).unwrap();
    kit::assert_refused! { early.add(&history) => Error::NoLastStep }
}

#[test]
fn error_estimate_of_steps_leaves_no_last_step() {
    let mut history = pressed(&bodies());
    let (load, start) = (shear(0.7), history.to_bytes());
    let mut steps = AdaptiveSteps::new(&history, 0.01).unwrap();
    let mut cycle = Cycle::new(&history);
    assert!(steps.error(&mut history, &load).unwrap().traction < 0.01);
    assert_eq!(history.to_bytes(), start);
    kit::assert_refused! { cycle.add(&history) => Error::NoLastStep }
    let mut observed = 0;
    let taken = steps.step_observed(&mut history, &load, |history| {
        observed += 1;
        assert_eq!(history.last_step()?.shift(), history.shift());
        cycle.add(history)
    });
    assert_eq!((taken, cycle.steps()), (Ok(observed), observed));
    assert_eq!(history.last_step().unwrap().shift(), history.shift());

    // A load that fails before any step keeps the last step. A load that is undone does not.
    let taken = history.steps();
    let beyond = LoadStep::force([2.0 * FRICTION * FORCE, 0.0]);
    kit::assert_refused! { history.press(&beyond, 0.1) => Error::BeyondFrictionCapacity { .. } }
    assert!(history.last_step().is_ok() && history.steps() == taken);
    let stopped = steps.step_observed(&mut history, &shear(0.2), |_| Err(Error::EmptyPath));
    assert_eq!((stopped, history.steps()), (Err(Error::EmptyPath), taken));
    assert!(has_no_last_step(&history));
}

fn outdated<T: std::fmt::Debug>(outcome: stickslip::Result<T>) -> &'static str {
    match outcome {
        Err(Error::OutdatedSolution { changed, .. }) => changed,
        other => panic!("not outdated: {other:?}"),
    }
}

fn next_step(history: &History) -> stickslip::Result<ContactStiffness> {
    let mut workspace = StiffnessWorkspace::new().next_step(true);
    history.stiffness_with(&mut workspace, |_| ControlFlow::Continue(()))
}

#[test]
fn stiffness_of_history_requires_step_after_new_friction_or_gap() {
    let bodies = bodies();
    let mut history = pressed(&bodies);
    history.step(&shear(0.6)).unwrap();
    let expected = history.stiffness().unwrap();
    // An equal friction changes no limit.
    history.set_friction(&friction()).unwrap();
    assert_eq!(history.stiffness().unwrap(), expected);

    let less = Friction::coulomb(0.9 * FRICTION).unwrap();
    history.set_friction(&less).unwrap();
    assert_eq!(outdated(history.stiffness()), "the friction");
    assert_eq!(outdated(next_step(&history)), "the friction");
    // The mark is part of the state.
    let read = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
    assert!(read.state() == history.state() && read.state().is_friction_new());
    assert_eq!(outdated(read.stiffness()), "the friction");
    history.step(&shear(0.6)).unwrap();
    assert!(next_step(&history).is_ok());
    assert_ne!(history.stiffness().unwrap(), expected);

    let worn = history.unloaded_gap().map(|gap| gap.max(0.01));
    history.set_gap(&worn).unwrap();
    assert_eq!(outdated(history.stiffness()), "the gap");
    // A step that holds the pressure does not follow the gap.
    history.step(&shear(0.5)).unwrap();
    assert_eq!(outdated(next_step(&history)), "the gap");
    history.step(&press()).unwrap();
    assert!(history.stiffness().is_ok() && next_step(&history).is_ok());
}

/// A new pattern changes the tractions in the next step, unless the amount is zero.
#[test]
fn stiffness_of_history_requires_step_after_new_relative_displacement() {
    let bodies = bodies();
    let strain = |part: f64| {
        RelativeDisplacement::bulk_strain(bodies.grid(), [[part, 0.0], [0.0, 0.0]]).unwrap()
    };
    let mut history = pressed(&bodies);
    history.step(&shear(0.4)).unwrap();
    history.set_relative_displacement(&strain(1e-3)).unwrap();
    let expected = history.stiffness().unwrap();
    history
        .step(&shear(0.4).relative_displacement(0.5))
        .unwrap();
    history.set_relative_displacement(&strain(1e-3)).unwrap();
    assert_ne!(history.stiffness().unwrap(), expected);

    history.set_relative_displacement(&strain(2e-3)).unwrap();
    let functional = Functional::Shift(Axis::X);
    for read in [
        history.clone(),
        History::from_bytes(&bodies, &history.to_bytes()).unwrap(),
    ] {
        assert_eq!(outdated(read.stiffness()), "the relative displacement");
        assert_eq!(outdated(next_step(&read)), "the relative displacement");
    }
    let found = history.sensitivity(&shear(0.4), &functional);
    assert_eq!(outdated(found), "the relative displacement");
    history.step(&shear(0.4)).unwrap();
    assert!(history.stiffness().is_ok() && next_step(&history).is_ok());
    assert!(history.sensitivity(&shear(0.4), &functional).is_ok());
}

/// The state replaces all settings of the next step. A setter acts only if it was called before the state was saved.
#[test]
fn restored_state_replaces_settings_of_next_step() {
    let bodies = bodies();
    let strain = |part: f64| {
        RelativeDisplacement::bulk_strain(bodies.grid(), [[part, 0.0], [0.0, 0.0]]).unwrap()
    };
    let next = press()
        .tangential(Axis::X, TangentialControl::Force(0.1))
        .relative_displacement(0.5);
    let set = |history: &mut History, part: f64| {
        let gap = history.unloaded_gap().map(|gap| gap.max(0.01 * part));
        history.set_gap(&gap).unwrap();
        let friction = Friction::coulomb(part * FRICTION).unwrap();
        history.set_friction(&friction).unwrap();
        let pattern = strain(1e-3 * part);
        history.set_relative_displacement(&pattern).unwrap();
        let settings: Settings = *history.settings();
        let settings = settings.tolerance(1e-7 * part);
        history.set_settings(settings).unwrap();
    };
    for is_set_before in [false, true] {
        let mut history = pressed(&bodies);
        history.step(&shear(0.4)).unwrap();
        if is_set_before {
            set(&mut history, 0.9);
        }
        let (kept, bytes) = (history.state().clone(), history.to_bytes());
        let mut expected = history.clone();
        if !is_set_before {
            let pattern = strain(0.0);
            expected.set_relative_displacement(&pattern).unwrap();
        }
        expected.step(&next).unwrap();

        set(&mut history, 0.8);
        history.set_state(&kept).unwrap();
        assert!(history.state() == &kept);
        let restored = [
            history,
            History::from_state(&bodies, kept).unwrap(),
            History::from_bytes(&bodies, &bytes).unwrap(),
        ];
        for mut history in restored {
            if !is_set_before {
                let outcome = history.step(&next).map(|_| ());
                kit::assert_refused! { outcome => Error::UnsupportedByModel { .. } }
                history.set_relative_displacement(&strain(0.0)).unwrap();
            }
            history.step(&next).unwrap();
            assert!(history.state() == expected.state(), "{is_set_before}");
        }
    }
}

/// The tractions follow a new friction in the next step. The pressure and its edges do not depend on the friction.
#[test]
fn edges_of_history_require_step_after_new_friction() {
    let bodies = bodies();
    let mut history = pressed(&bodies);
    history.step(&shear(0.6)).unwrap();
    let expected = history.edges().unwrap();
    history.set_friction(&friction()).unwrap();
    assert!(history.edges().unwrap() == expected);
    history
        .set_friction(&Friction::coulomb(0.9 * FRICTION).unwrap())
        .unwrap();
    assert_eq!(outdated(history.edges()), "the friction");
    assert!(history.normal().edges().is_ok());
    history.step(&shear(0.6)).unwrap();
    assert!(history.edges().unwrap() != expected);
    // A gap that has changed moves no edge of the last step.
    let worn = history.unloaded_gap().map(|gap| gap.max(0.01));
    history.set_gap(&worn).unwrap();
    assert!(history.edges().is_ok());
}

fn normal(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    let problem = NormalProblem::builder(bodies, gap, NormalLoad::Force(force));
    problem.build().unwrap().solve().unwrap()
}

#[test]
fn stiffness_in_rolling_requires_solve_after_each_setter() {
    let bodies = bodies();
    let ball = surface::sphere(bodies.grid(), 1.0).unwrap();
    let contact = normal(&bodies, &ball, FORCE);
    let problem = RollingProblem::builder(&bodies, &contact, friction());
    let mut solver = problem
        .creepage([0.02, 0.0])
        .build()
        .unwrap()
        .into_solver()
        .unwrap();
    let press = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(FORCE));
    let press = press.build().unwrap().into_solver().unwrap();
    solver.set_normal_solver(press).unwrap();
    let mut rolling = solver.new_solution();
    let sticking = solver.stiffness().unwrap();
    let creepages = [0.03, 0.0].map(RollingControl::Creepage);
    // Before the first solve all cells stick, under any load.
    solver.set_load(creepages, SpinControl::Spin(0.0)).unwrap();
    assert_eq!(solver.stiffness().unwrap(), sticking);
    solver.solve_into(&mut rolling).unwrap();
    let slipping = solver.stiffness().unwrap();
    assert!(slipping[0][0] < sticking[0][0]);
    solver.set_load(creepages, SpinControl::Spin(0.0)).unwrap();
    assert_eq!(solver.stiffness().unwrap(), slipping);

    solver.set_load(creepages, SpinControl::Spin(0.1)).unwrap();
    assert_eq!(outdated(solver.stiffness()), "the load");
    solver.solve_into(&mut rolling).unwrap();
    solver
        .set_normal_load(NormalLoad::Force(0.9 * FORCE))
        .unwrap();
    assert_eq!(outdated(solver.stiffness()), "the pressure");
    solver.solve_into(&mut rolling).unwrap();
    solver
        .set_friction(&Friction::coulomb(0.2).unwrap())
        .unwrap();
    assert_eq!(outdated(solver.stiffness()), "the friction");
    solver.reset();
    let reset = solver.stiffness().unwrap();
    solver.solve_into(&mut rolling).unwrap();
    assert_ne!(solver.stiffness().unwrap(), reset);
}

#[test]
fn stiffness_in_coupled_rolling_requires_solve_after_each_setter() {
    let grid = Grid::square(20, 3.0).unwrap();
    let similar = ElasticPair::new(
        Material::new(2.0, 0.3).unwrap(),
        Material::new(2.0, 0.3).unwrap(),
    );
    let rubber = ElasticPair::new(Material::new(1.0, 0.0).unwrap(), Material::rigid());
    for pair in [similar.unwrap(), rubber.unwrap()] {
        let bodies = HalfSpace::new(grid, pair).unwrap();
        let ball = surface::sphere(grid, 1.0).unwrap();
        let press = NormalLoad::Force(FORCE);
        let problem = CoupledRollingProblem::builder(&bodies, &ball, friction(), press);
        let mut solver = problem
            .creepage([0.02, 0.0])
            .build()
            .unwrap()
            .into_solver()
            .unwrap();
        let mut rolling = solver.new_solution();
        kit::assert_refused! { solver.stiffness() => Error::NotConverged(_) }
        solver.solve_into(&mut rolling).unwrap();
        let expected = solver.stiffness().unwrap();
        let creepages = [0.02, 0.0].map(RollingControl::Creepage);
        solver.set_load(creepages, SpinControl::Spin(0.0)).unwrap();
        solver.set_normal_load(press).unwrap();
        assert_eq!(solver.stiffness().unwrap(), expected);

        solver.set_load(creepages, SpinControl::Spin(0.1)).unwrap();
        assert_eq!(outdated(solver.stiffness()), "the load");
        solver.solve_into(&mut rolling).unwrap();
        solver
            .set_normal_load(NormalLoad::Force(0.9 * FORCE))
            .unwrap();
        assert_eq!(outdated(solver.stiffness()), "the normal load");
        solver.solve_into(&mut rolling).unwrap();
        solver
            .set_friction(&Friction::coulomb(0.25).unwrap())
            .unwrap();
        assert_eq!(outdated(solver.stiffness()), "the friction");
        solver.solve_into(&mut rolling).unwrap();
        solver
            .set_gap(&surface::sphere(grid, 1.1).unwrap())
            .unwrap();
        assert_eq!(outdated(solver.stiffness()), "the gap");
        let cut = solver.solve_observed(&mut rolling, |_| ControlFlow::Break(()));
        assert!(matches!(cut, Err(Error::NotConverged(_))));
        assert!(solver.stiffness().is_err());
        solver.solve_into(&mut rolling).unwrap();
        assert!(solver.stiffness().is_ok());
    }
}

#[test]
fn stiffness_of_unsolved_solution_is_rejected() {
    let bodies = bodies();
    let ball = surface::sphere(bodies.grid(), 1.0).unwrap();
    let (press, drag) = (NormalLoad::Force(FORCE), TangentialLoad::force([0.1, 0.0]));
    let contact = normal(&bodies, &ball, FORCE);
    let is_unsolved = |error: &Error| matches!(error, Error::NotConverged(report) if report.status == Status::Unsolved);

    let problem = NormalProblem::builder(&bodies, &ball, press)
        .build()
        .unwrap();
    let empty = problem.into_solver().unwrap().new_solution();
    assert!(
        empty
            .stiffness(&bodies)
            .is_err_and(|error| is_unsolved(&error))
    );
    let problem = TangentialProblem::builder(&bodies, &contact, friction(), drag);
    let sheared = problem
        .build()
        .unwrap()
        .into_solver()
        .unwrap()
        .new_solution();
    assert!(
        sheared
            .stiffness(&bodies)
            .is_err_and(|error| is_unsolved(&error))
    );
    let both = ContactStiffness::new(&bodies, &contact, &friction(), &sheared);
    assert!(both.is_err_and(|error| is_unsolved(&error)));
    let problem = CoupledProblem::builder(&bodies, &ball, friction(), press, drag);
    let coupled = problem
        .build()
        .unwrap()
        .into_solver()
        .unwrap()
        .new_solution();
    let found = coupled.stiffness(&bodies, &friction());
    assert!(found.is_err_and(|error| is_unsolved(&error)));
}

/// A normal solver with another gap is legal. It determines the pressure of the next normal load, and not earlier.
#[test]
fn normal_solver_of_rolling_uses_own_gap_from_next_load_on() {
    let bodies = bodies();
    let [ball, worn] = [1.0, 1.3].map(|radius| surface::sphere(bodies.grid(), radius).unwrap());
    let load = NormalLoad::Force(FORCE);
    let of = |gap: &Field| {
        let contact = normal(&bodies, gap, FORCE);
        let problem = RollingProblem::builder(&bodies, &contact, friction());
        problem
            .creepage([0.02, 0.0])
            .build()
            .unwrap()
            .into_solver()
            .unwrap()
    };
    let (mut solver, mut before, mut after) = (of(&ball), of(&ball), of(&worn));
    // The solver has not solved yet, and belongs to another object of equal bodies.
    let problem = NormalProblem::builder(&self::bodies(), &worn, load)
        .build()
        .unwrap();
    solver
        .set_normal_solver(problem.into_solver().unwrap())
        .unwrap();
    let force = |solver: &mut stickslip::rolling::RollingSolver| {
        let mut rolling = solver.new_solution();
        solver.solve_into(&mut rolling).unwrap();
        rolling.force()[0]
    };
    assert_eq!(force(&mut solver), force(&mut before));
    solver.set_normal_load(load).unwrap();
    assert!((force(&mut solver) / force(&mut after) - 1.0).abs() < 1e-7);
    let contact = solver.normal().unwrap();
    assert_eq!(contact.pressure(), normal(&bodies, &worn, FORCE).pressure());
}
