//! The results of every history are bitwise identical if it is saved, copied or restored to an earlier state. They are
//! also bitwise identical if it is disturbed by failing steps or run concurrently with others. The number of threads
//! and the number of ranks do not change the results.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::thread;

use kit::table::{Scene, UnitTransform, bits, cells, known, scenes};
use stickslip::Iteration;
use stickslip::history::{Rolling, State};
use stickslip::ranks::Threads;
use stickslip::{
    Axis, Error, HalfSpace, History, LoadStep, NormalLoad, Status, TangentialControl,
    TangentialModel, TryClone,
};

use crate::rank_contacts::PATIENCE;
use crate::scene_laws::{LawResult, assert_every};

const POSE: UnitTransform = UnitTransform::IN_PLACE;

/// Returns the scene with an ordinary tolerance.
fn with_ordinary_tolerance(scene: &Scene) -> Scene {
    Scene {
        tolerance: 1e-7,
        ..scene.clone()
    }
}

/// Returns the scene with an ordinary tolerance. Except in the campaign, the last steps are omitted.
fn shortened(scene: &Scene) -> Scene {
    let mut scene = with_ordinary_tolerance(scene);
    scene.path.truncate(kit::thorough(5, usize::MAX));
    scene
}

/// Returns an error with the text from `what` if the values differ.
fn check_equal<T: PartialEq + ?Sized>(
    found: &T,
    expected: &T,
    what: impl FnOnce() -> String,
) -> LawResult {
    if found == expected {
        Ok(())
    } else {
        Err(what())
    }
}

/// Sets a different gap, friction and tolerance, and applies loads that need a different window. These steps may fail.
fn disturb(history: &mut History, scene: &Scene) {
    let other = history.unloaded_gap().map(|gap| 0.5 * gap + 0.01);
    history.set_gap(&other).unwrap();
    history.set_friction(&kit::coulomb(0.2)).unwrap();
    let settings = history.settings().tolerance(1e-4);
    history.set_settings(settings).unwrap();
    let heavy = LoadStep::hold().normal(NormalLoad::Force(0.15));
    let _ = history.step(&heavy);
    let _ = history.step(&scene.load(&scene.path[1], &POSE));
}

/// Covers the state before the first contact, and the states after all steps.
#[test]
fn history_saved_copied_or_restored_is_bitwise_identical() {
    assert_every(scenes(), |scene| {
        let scene = shortened(scene);
        let bodies = scene.half_space(&POSE);
        let mut history = scene.history(&bodies, &POSE);
        let other = Scene {
            model: TangentialModel::Vector,
            hardness: None,
            ..scene.clone()
        };
        let mut returned = other.history(&bodies, &POSE);
        let mut copies: Vec<(&str, History)> = Vec::new();
        for (number, step) in scene.path.iter().enumerate() {
            let (saved, state) = (history.to_bytes(), history.state().clone());
            let restored = History::from_bytes(&bodies, &saved).unwrap();
            check_equal(&restored.to_bytes(), &saved, || {
                format!("bytes of step {number}")
            })?;
            let read = State::from_bytes(&saved).unwrap();
            if number % kit::thorough(3, 1) == 0 {
                disturb(&mut returned, &scene);
            }
            returned.set_state(&state).unwrap();
            check_equal(&returned.to_bytes(), &saved, || {
                format!("return to step {number}")
            })?;
            if number == 3 || kit::thorough(false, true) {
                let stiffness = history.stiffness().ok();
                let moved = History::from_state(&bodies, state.clone()).unwrap();
                let others = [
                    ("returned", &returned),
                    ("restored", &restored),
                    ("moved", &moved),
                ];
                for (how, other) in others {
                    check_equal(&other.stiffness().ok(), &stiffness, || {
                        format!("stiffness before step {number}, {how}")
                    })?;
                }
            }
            let mut fresh = vec![
                ("restored", restored),
                ("from a state", History::from_state(&bodies, read).unwrap()),
                ("cloned", history.try_clone().unwrap()),
            ];
            // Some copies are taken halfway and continue independently.
            if number == scene.path.len() / 2 {
                copies = fresh.clone();
                copies.push(("copied", history.clone()));
            }
            // The other copies have the bytes compared above. Outside the campaign only one of these copies is used in
            // turn.
            if kit::thorough(true, false) {
                fresh.swap(0, number % 3);
                fresh.truncate(1);
            }
            scene.take(&mut history, step, &POSE);
            scene.take(&mut returned, step, &POSE);
            let expected = bits(&history);
            check_equal(&bits(&returned), &expected, || {
                format!("step {number} of a history restored to an earlier state")
            })?;
            for (how, copy) in copies.iter_mut().chain(&mut fresh) {
                scene.take(copy, step, &POSE);
                check_equal(&bits(copy), &expected, || format!("step {number}, {how}"))?;
            }
        }
        let mut alone = scene.history(&scene.half_space(&POSE), &POSE);
        scene.run(&mut alone, &POSE);
        check_equal(&bits(&alone), &bits(&history), || {
            "without a save".to_owned()
        })
    });
}

/// Returns loads that every history rejects: not finite, tensile, or beyond the friction capacity.
fn invalid_loads(history: &History) -> Vec<LoadStep> {
    let hold = LoadStep::hold();
    let along = |control| hold.tangential(Axis::X, control);
    let too_far = along(TangentialControl::Force(1e3));
    vec![
        hold.normal(NormalLoad::Force(-1.0)),
        hold.normal(NormalLoad::Approach(f64::NAN)),
        along(TangentialControl::Force(f64::NAN)),
        along(TangentialControl::Spring {
            position: 1.0,
            stiffness: -1.0,
        }),
        hold.twist(f64::NAN),
        hold.roll(Rolling::new(0)),
        hold.roll(Rolling::new(1).creepage([f64::NAN, 0.0])),
        // This load requires a contact far wider than the last contact.
        too_far.normal(NormalLoad::Force(0.12)),
        hold.normal(NormalLoad::Force(history.normal().force()))
            .tangential(Axis::Y, TangentialControl::Force(1e3)),
    ]
}

#[test]
fn history_after_failed_steps_is_bitwise_identical() {
    assert_every(scenes(), |scene| {
        let scene = shortened(scene);
        let mut history = scene.history(&scene.half_space(&POSE), &POSE);
        let mut twin = history.clone();
        let mut stopped = 0;
        for (number, step) in scene.path.iter().enumerate() {
            let before = history.to_bytes();
            for load in invalid_loads(&history) {
                let is_refused = history.step(&load).is_err();
                check_equal(&is_refused, &true, || format!("{load:?} is accepted"))?;
                check_equal(&history.to_bytes(), &before, || {
                    format!("{load:?} before step {number}")
                })?;
            }
            let load = scene.load(step, &POSE);
            let mut last = 1;
            loop {
                let (mut calls, panics) = (0, stopped % 2 == 1);
                let observer = |_: &Iteration| {
                    calls += 1;
                    match calls == last {
                        false => ControlFlow::Continue(()),
                        // Panics without printing a message.
                        true if panics => resume_unwind(Box::new("observed")),
                        true => ControlFlow::Break(()),
                    }
                };
                let stepped = AssertUnwindSafe(|| history.step_observed(&load, observer).map(drop));
                match catch_unwind(stepped) {
                    Ok(Ok(())) if calls < last => break,
                    Ok(Err(Error::NotConverged(report))) if report.status == Status::Cancelled => {}
                    Err(_) if panics => {}
                    _ => return Err(format!("step {number} continues after call {last}")),
                }
                stopped += 1;
                check_equal(&history.to_bytes(), &before, || {
                    format!("step {number}, stopped at call {last}")
                })?;
                last += kit::thorough(8, 1);
            }
            scene.wear(&mut history, &POSE);
            scene.take(&mut twin, step, &POSE);
            check_equal(&bits(&history), &bits(&twin), || format!("step {number}"))?;
        }
        check_equal(&(stopped > 10), &true, || {
            "at most ten steps were stopped".to_owned()
        })
    });
}

/// Returns the result of each scene on its own bodies, without any shared preparation.
fn run_separately(scenes: &[Scene]) -> Vec<Vec<u8>> {
    let run = |scene: &Scene| {
        let mut history = scene.history(&scene.half_space(&POSE), &POSE);
        scene.run(&mut history, &POSE);
        bits(&history)
    };
    scenes.iter().map(run).collect()
}

/// Returns the scenes without wear. They have the same number of steps, so that a single call can step their histories.
fn scenes_without_wear() -> Vec<Scene> {
    let mut scenes: Vec<_> = scenes().iter().map(with_ordinary_tolerance).collect();
    scenes.retain(|scene| scene.wear == 0.0);
    for scene in &mut scenes {
        scene.path.truncate(kit::thorough(3, 5));
    }
    scenes
}

/// Runs a scene on the given bodies. The state is saved after two steps and continued on a different thread.
fn run_on_two_threads(scene: &Scene, bodies: &HalfSpace) -> Vec<u8> {
    let mut history = scene.history(bodies, &POSE);
    let (first, then) = scene.path.split_at(2);
    for step in first {
        scene.take(&mut history, step, &POSE);
    }
    let saved = history.to_bytes();
    let continue_history = || {
        let mut history = History::from_bytes(bodies, &saved).unwrap();
        for step in then {
            scene.take(&mut history, step, &POSE);
        }
        bits(&history)
    };
    thread::scope(|scope| scope.spawn(continue_history).join().unwrap())
}

/// Runs all scenes concurrently, with two runs of each scene on the same bodies. One of the two runs changes its thread
/// halfway.
#[test]
fn history_run_concurrently_is_bitwise_identical() {
    let scenes = scenes_without_wear();
    let expected = run_separately(&scenes);
    let bodies: Vec<_> = scenes.iter().map(|scene| scene.half_space(&POSE)).collect();
    thread::scope(|scope| {
        for ((scene, bodies), expected) in scenes.iter().zip(&bodies).zip(&expected) {
            scope.spawn(|| {
                let mut history = scene.history(bodies, &POSE);
                scene.run(&mut history, &POSE);
                assert!(bits(&history) == *expected, "{}", scene.name);
            });
            scope.spawn(|| {
                let found = run_on_two_threads(scene, bodies);
                assert!(found == *expected, "{}, on two threads", scene.name);
            });
        }
    });
}

#[cfg(feature = "parallel")]
fn thread_pool(threads: usize) -> rayon::ThreadPool {
    let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
    builder.build().unwrap()
}

/// Runs the histories in one call, and as tasks of a pool that wait for nested tasks and steal tasks from each other.
#[cfg(feature = "parallel")]
#[test]
fn histories_in_one_call_or_pool_are_bitwise_identical() {
    use rayon::prelude::*;

    let scenes = scenes_without_wear();
    let expected = run_separately(&scenes);
    for &threads in kit::thorough(&[3][..], &[1, 3]) {
        let mut histories: Vec<_> = scenes
            .iter()
            .map(|scene| scene.history(&scene.half_space(&POSE), &POSE))
            .collect();
        let run = |scene: &Scene| run_separately(std::slice::from_ref(scene)).remove(0);
        let tasks: Vec<_> = thread_pool(threads).install(|| {
            for number in 0..scenes[0].path.len() {
                let loads: Vec<_> = scenes
                    .iter()
                    .map(|scene| scene.load(&scene.path[number], &POSE))
                    .collect();
                let failed = History::step_all(&mut histories, &loads).unwrap();
                assert!(failed.is_empty(), "{failed:?}");
            }
            scenes.par_iter().map(run).collect()
        });
        for (i, scene) in scenes.iter().enumerate() {
            assert!(bits(&histories[i]) == expected[i], "{}", scene.name);
            assert!(tasks[i] == expected[i], "{}, in a pool", scene.name);
        }
    }
}

/// Returns the scene in two steps on a grid that is refined by `times` along x and y. Every thread and rank then has
/// cells.
fn refined(scene: &Scene, times: usize) -> Scene {
    let mut scene = Scene {
        tolerance: 1e-3,
        ..scene.clone()
    };
    if scene.size[0] > 40 {
        scene.path.truncate(2);
        return scene.finer([2, times / 2]);
    }
    scene.path.drain(..1);
    scene.path.truncate(2);
    scene.finer([times, times])
}

#[cfg(feature = "parallel")]
#[test]
fn history_on_any_number_of_threads_is_bitwise_identical() {
    assert_every(some_scenes(), |scene| {
        let scene = [refined(scene, kit::thorough(5, 6))];
        let one = thread_pool(1).install(|| run_separately(&scene));
        check_equal(
            &thread_pool(3).install(|| run_separately(&scene)),
            &one,
            || "three threads".to_owned(),
        )
    });
}

/// Returns scenes that together cover every boundary, model, coupling and type of memory. In the campaign it returns
/// all scenes.
pub(crate) fn some_scenes() -> Vec<Scene> {
    let chosen = [
        "rows",
        "strained line",
        "plane, friction of each cell",
        "plane, one way",
        "plane, repeating",
        "coupled, permanent set",
        "shrinking",
        "plane, rolled",
        "coupled, rolled",
        "coupled, coated",
        "kernel",
        "coupled, centre values",
    ];
    let mut some = scenes();
    if kit::thorough(true, false) {
        some.retain(|scene| chosen.contains(&scene.name));
        assert_eq!(some.len(), chosen.len());
    }
    some
}

/// Returns the scenes that are distributed over ranks.
pub(crate) fn shared_scenes() -> Vec<Scene> {
    // On finer grids, rows of coefficients of coated bodies contain pieces that are interpolated.
    let times = kit::thorough(5, 6);
    let scenes = some_scenes();
    let mut scenes: Vec<_> = scenes.iter().map(|scene| refined(scene, times)).collect();
    // Ranks do not roll.
    scenes.retain(|scene| !scene.rolls());
    scenes
}

/// Returns the global numbers of a history and the values of its local cells as bits, including contact spots and their
/// labels.
pub(crate) fn found(history: &History) -> (Vec<u64>, Vec<[u64; 9]>) {
    let spots = history.spots().unwrap();
    let sums = spots.as_slice().iter().flat_map(|spot| {
        let [x, y] = spot.centroid;
        let stick = spot.stick_ratio.unwrap_or(f64::NAN);
        [spot.load, spot.max_pressure, spot.perimeter, x, y, stick]
    });
    let known = known(history).into_iter().chain(sums);
    let cells = cells(history).into_iter().zip(spots.labels());
    let bits = cells.map(|(cell, label)| {
        let mut bits = [u64::from(*label); 9];
        bits[..8].copy_from_slice(&cell.map(f64::to_bits));
        bits
    });
    (known.map(f64::to_bits).collect(), bits.collect())
}

/// Checks that the results of the ranks equal the result of one process.
fn check_parts(
    parts: Vec<(Vec<u64>, Vec<[u64; 9]>)>,
    whole: &(Vec<u64>, Vec<[u64; 9]>),
) -> LawResult {
    let size = parts.len();
    for (rank, (known, _)) in parts.iter().enumerate() {
        check_equal(known, &whole.0, || {
            format!("global numbers of rank {rank} of {size}")
        })?;
    }
    let cells: Vec<_> = parts.into_iter().flat_map(|(_, cells)| cells).collect();
    check_equal(&cells, &whole.1, || format!("cells on {size} ranks"))
}

/// Starts and saves a history on some ranks and continues it on a different number of ranks, or on one process.
#[test]
fn history_on_any_number_of_ranks_is_bitwise_identical() {
    let numbers = [(2, 3), (3, 1), (4, 2)];
    let mut numbers = numbers.into_iter().cycle();
    assert_every(shared_scenes(), |scene| {
        let (from, to) = numbers.next().unwrap();
        let [first, then] = scene.path[..] else {
            panic!("the scene does not have two steps");
        };
        let mut alone = scene.history(&scene.half_space(&POSE), &POSE);
        scene.take(&mut alone, &first, &POSE);
        let parts = Threads::run(from, PATIENCE, |rank| {
            let bodies = scene.half_space_on(Arc::new(rank)).unwrap();
            let mut history = scene.history(&bodies, &POSE);
            scene.take(&mut history, &first, &POSE);
            (history.to_bytes(), found(&history))
        });
        let (slabs, parts): (Vec<_>, Vec<_>) = parts.into_iter().unzip();
        check_parts(parts, &found(&alone))?;
        let saved = alone.to_bytes();
        scene.take(&mut alone, &then, &POSE);
        let parts = Threads::run(to, PATIENCE, |rank| {
            let bodies = scene.half_space_on(Arc::new(rank)).unwrap();
            let slabs = slabs.iter().map(|bytes| State::from_bytes(bytes));
            let state = State::from_slabs(&bodies, slabs).unwrap();
            let mut history = History::from_state(&bodies, state).unwrap();
            assert!(to > 1 || history.to_bytes() == saved);
            scene.take(&mut history, &then, &POSE);
            found(&history)
        });
        check_parts(parts, &found(&alone))
    });
}
