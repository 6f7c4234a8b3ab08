//! A fretting loop takes the steps of its path, with results bitwise identical to the results of separate steps. The
//! loop stops when the cycles are steady, and reports if they do not become steady. A failed step leaves the history in
//! the state after the last successful step.

use std::ops::ControlFlow;

use kit::unit_bodies;
use stickslip::history::{Cycle, FrettingLoop, LoadPath, StopReason, wear};
use stickslip::{
    Axis, Error, Field, HalfSpace, History, LoadStep, NormalLoad, TangentialControl,
    TangentialModel,
};

const FRICTION: f64 = 0.4;
const LOAD: f64 = 4.0;
const LIMIT: f64 = FRICTION * LOAD;

fn sphere_problem() -> (HalfSpace, Field) {
    let grid = kit::square(48, 12.0);
    (unit_bodies(grid, 0.3), kit::sphere(grid, 20.0))
}

/// Presses the sphere in a history with a fixed axis, or with the vector model.
fn press_sphere(axis: Option<Axis>) -> History {
    let (bodies, ball) = sphere_problem();
    let builder = History::builder(&bodies, &ball, kit::coulomb(FRICTION));
    let builder = match axis {
        Some(axis) => builder.axis(axis),
        None => builder.model(TangentialModel::Vector),
    };
    let mut history = builder.tolerance(1e-7).build().unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(LOAD));
    history.step(&press).unwrap();
    history
}

#[test]
fn loop_takes_the_steps_of_its_path() {
    for (axis, along) in [(Axis::X, [1.0, 0.0]), (Axis::Y, [0.0, 1.0])] {
        let path = LoadPath::sine(along.map(|part| 0.6 * LIMIT * part), 8).unwrap();
        let (mut driven, mut twin) = (press_sphere(Some(axis)), press_sphere(Some(axis)));
        let fretting = FrettingLoop::new(path.clone(), LoadStep::force);
        let outcome = fretting.run(&mut driven, 3).unwrap();
        assert_eq!(
            (outcome.cycles, outcome.ending),
            (3, StopReason::CycleLimit)
        );
        for force in path.cycles(3) {
            let force = force[axis.index()];
            twin.step(&LoadStep::hold().tangential(axis, TangentialControl::Force(force)))
                .unwrap();
        }
        assert_eq!(driven.to_bytes(), twin.to_bytes());

        // Taking the cycles one at a time gives the same result.
        let (mut again, mut cycle) = (press_sphere(Some(axis)), Cycle::new(&driven));
        for _ in 0..3 {
            fretting.cycle(&mut again, &mut cycle).unwrap();
        }
        assert_eq!(again.to_bytes(), twin.to_bytes());
        assert_eq!(cycle, outcome.last);
    }
}

/// After the first loading, the second cycle closes. In the vector model, the tractions across the load need some more
/// cycles.
#[test]
fn loop_stops_when_steady() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let by_force = |y| LoadPath::ellipse([0.7 * LIMIT, y * LIMIT], quarter, 16).unwrap();
    let by_shift = LoadPath::triangle([0.4, 0.0], 16).unwrap();
    let load = |force: [f64; 2]| LoadStep::force(force).normal(NormalLoad::Force(LOAD));
    let sheared = FrettingLoop::new(by_force(0.0), load).until_steady(1e-4);
    let shifted = FrettingLoop::new(by_shift, LoadStep::shift).until_steady(1e-4);
    let mut along = [(); 2].map(|()| press_sphere(Some(Axis::X)));
    for outcome in [
        sheared.run(&mut along[0], 20).unwrap(),
        shifted.run(&mut along[1], 20).unwrap(),
    ] {
        assert_eq!((outcome.cycles, outcome.ending), (2, StopReason::Steady));
        assert!(outcome.last.cyclic_residual().unwrap() <= 1e-4);
        assert_eq!(outcome.last.steps(), 16);
    }
    let outcome = sheared.run(&mut press_sphere(None), 20).unwrap();
    assert_eq!(outcome.ending, StopReason::Steady);
    assert!((2..=8).contains(&outcome.cycles));
    // An elliptic path becomes steady, too, and then remains steady.
    let round = FrettingLoop::new(by_force(0.4), LoadStep::force).until_steady(1e-3);
    let mut history = press_sphere(None);
    let outcome = round.run(&mut history, 20).unwrap();
    assert_eq!(outcome.ending, StopReason::Steady);
    assert!((2..=8).contains(&outcome.cycles));
    let next = round.run(&mut history, 20).unwrap();
    assert_eq!((next.cycles, next.ending), (1, StopReason::Steady));
    let energies = [&outcome, &next].map(|outcome| outcome.last.energy().dissipated_energy);
    assert!((energies[1] / energies[0] - 1.0).abs() < 1e-2);
}

#[test]
fn loop_that_is_not_steady_reports_cycle_limit() {
    let path = LoadPath::sine([0.7 * LIMIT, 0.0], 8).unwrap();
    let fretting = FrettingLoop::new(path, LoadStep::force).until_steady(1e-4);
    let mut history = press_sphere(Some(Axis::X));
    let outcome = fretting.run(&mut history, 1).unwrap();
    assert_eq!(
        (outcome.cycles, outcome.ending),
        (1, StopReason::CycleLimit)
    );
    assert!(outcome.last.cyclic_residual().unwrap() > 0.1);
    let none = fretting.run(&mut history, 0).unwrap();
    assert_eq!((none.cycles, none.last.steps()), (0, 0));

    // A contact that wears during the loop does not become steady.
    let (bodies, mut gap) = sphere_problem();
    let mut history = History::builder(&bodies, &gap, kit::coulomb(FRICTION))
        .build()
        .unwrap();
    let path = LoadPath::sine([0.3, 0.0], 8).unwrap();
    let load = |shift| LoadStep::shift(shift).normal(NormalLoad::Force(LOAD));
    let outcome = FrettingLoop::new(path, load)
        .until_steady(1e-4)
        .run_observed(&mut history, 4, |history, _| {
            let energy = history.last_step().unwrap().dissipation();
            wear::energy(0.5, energy, &mut gap)?;
            history.set_gap(&gap)?;
            Ok(ControlFlow::Continue(()))
        })
        .unwrap();
    assert_eq!(
        (outcome.cycles, outcome.ending),
        (4, StopReason::CycleLimit)
    );
    assert!(outcome.last.cyclic_residual().unwrap() > 1e-3);
    assert!(history.unloaded_gap() == &gap && gap != sphere_problem().1);
}

#[test]
fn loop_observer_is_called_after_every_step_and_can_stop() {
    let path = LoadPath::sine([0.7 * LIMIT, 0.0], 8).unwrap();
    let fretting = FrettingLoop::new(path.clone(), LoadStep::force);
    let mut history = press_sphere(Some(Axis::X));
    let before = history.steps();
    let mut seen = Vec::new();
    let outcome = fretting
        .run_observed(&mut history, 5, |history, cycle| {
            seen.push((history.steps() - before, cycle.steps()));
            Ok(if seen.len() == 11 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            })
        })
        .unwrap();
    assert_eq!((outcome.cycles, outcome.ending), (1, StopReason::Stopped));
    assert_eq!(outcome.last.steps(), 3);
    assert_eq!(seen.len(), 11);
    assert!(
        seen.iter()
            .enumerate()
            .all(|(n, &step)| step == (n as u64 + 1, n % 8 + 1))
    );
    // An error returned by the observer also ends the loop.
    let refused = fretting.run_observed(&mut history, 1, |_, _| Err(Error::EmptyContact));
    assert_eq!(refused.unwrap_err(), Error::EmptyContact);
}

#[test]
fn loop_failed_step_leaves_state_after_last_good_step() {
    let mut history = press_sphere(Some(Axis::X));
    let mut twin = press_sphere(Some(Axis::X));
    let path = LoadPath::table(
        [0.3, -0.4, 0.5, 1.1]
            .map(|part| [part * LIMIT, 0.0])
            .to_vec(),
    );
    let path = path.unwrap();
    for &force in &path.steps()[..3] {
        twin.step(&LoadStep::force(force)).unwrap();
    }
    let fretting = FrettingLoop::new(path, LoadStep::force);
    let mut cycle = Cycle::new(&history);
    kit::assert_refused! { fretting.cycle(&mut history, &mut cycle) => Error::BeyondFrictionCapacity { .. } }
    assert_eq!((history.steps(), cycle.steps()), (4, 3));
    assert_eq!(history.to_bytes(), twin.to_bytes());
}

/// A cycle contains consecutive steps. The observer may take a step between two cycles only.
#[test]
fn loop_rejects_step_of_observer_within_cycle() {
    let path = LoadPath::triangle([0.3 * LIMIT, 0.0], 4).unwrap();
    let fretting = FrettingLoop::new(path, LoadStep::force);
    for (at, is_accepted) in [(2, false), (4, true)] {
        let mut history = press_sphere(Some(Axis::X));
        let outcome = fretting.run_observed(&mut history, 2, |history, cycle| {
            if cycle.steps() == at {
                history.step(&LoadStep::force([0.1 * LIMIT, 0.0]))?;
            }
            Ok(ControlFlow::Continue(()))
        });
        if is_accepted {
            assert_eq!(outcome.unwrap().last.steps(), 4);
        } else {
            assert!(matches!(outcome, Err(Error::StepOutOfOrder { .. })));
        }
    }
}

#[test]
fn loop_with_invalid_input_is_rejected_before_any_step() {
    let mut history = press_sphere(Some(Axis::X));
    let before = history.to_bytes();
    let path = LoadPath::sine([0.0, 0.1], 4).unwrap();
    for tolerance in [0.0, 1.0, -1e-3, f64::NAN] {
        let fretting = FrettingLoop::new(path.clone(), LoadStep::force).until_steady(tolerance);
        kit::assert_refused! { fretting.run(&mut history, 3) => Error::Tolerance(_) }
    }
    // The load ignores the path.
    let held = FrettingLoop::new(path.clone(), |_| LoadStep::hold());
    kit::assert_refused! { held.run(&mut history, 3) => Error::UnsupportedByModel { .. } }
    let mut cycle = Cycle::new(&history);
    kit::assert_refused! { held.cycle(&mut history, &mut cycle) => Error::UnsupportedByModel { .. } }
    // The path crosses the axis of the history.
    let fretting = FrettingLoop::new(path, LoadStep::force);
    kit::assert_refused! { fretting.run(&mut history, 3) => Error::UnsupportedByModel { .. } }
    assert_eq!(history.to_bytes(), before);
}
