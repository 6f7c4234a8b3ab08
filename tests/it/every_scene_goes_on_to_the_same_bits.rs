//! Every kind of history comes to the same bits whether it is saved, copied, returned to, disturbed by steps that fail, run
//! beside others, on any number of threads or shared by any number of ranks.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::thread;

use kit::table::{Scene, UnitTransform, bits, cells, known, scenes};
use stickslip::cgm::Iteration;
use stickslip::history::State;
use stickslip::ranks::Threads;
use stickslip::{
    Axis, Friction, HalfSpace, History, LoadStep, NormalControl, TangentialControl,
    TangentialModel, TryClone,
};

use crate::every_scene_obeys_the_laws::{Law, every};
use crate::ranks_share_a_contact::PATIENCE;

const POSE: UnitTransform = UnitTransform::IN_PLACE;

/// The scene, solved to what is usual.
fn usual(scene: &Scene) -> Scene {
    Scene {
        tolerance: 1e-7,
        ..scene.clone()
    }
}

/// The scene, solved to what is usual, and outside the campaign without its last steps.
fn shortened(scene: &Scene) -> Scene {
    let mut scene = usual(scene);
    scene.path.truncate(kit::thorough(5, usize::MAX));
    scene
}

/// Whether both are the same; `what` is what differs otherwise.
fn same<T: PartialEq + ?Sized>(found: &T, expected: &T, what: impl FnOnce() -> String) -> Law {
    if found == expected {
        Ok(())
    } else {
        Err(what())
    }
}

/// Another gap, friction and tolerance, and loads that need another window; steps may fail.
fn lead_astray(history: &mut History, scene: &Scene) {
    let other = history.gap().map(|gap| 0.5 * gap + 0.01);
    history.set_gap(&other).unwrap();
    history
        .set_friction(&Friction::coulomb(0.2).unwrap())
        .unwrap();
    let settings = history.settings().tolerance(1e-4);
    history.set_settings(settings).unwrap();
    let heavy = LoadStep::hold().normal(NormalControl::Force(0.15));
    let _ = history.step(&heavy);
    let _ = history.step(&scene.load(&scene.path[1], &POSE));
}

/// Before anything has touched, and after any step.
#[test]
fn saved_copied_or_returned_to() {
    every(scenes(), |scene| {
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
            same(&restored.to_bytes(), &saved, || {
                format!("bytes of step {number}")
            })?;
            let read = State::from_bytes(&saved).unwrap();
            if number % kit::thorough(3, 1) == 0 {
                lead_astray(&mut returned, &scene);
            }
            returned.set_state(&state).unwrap();
            same(&returned.to_bytes(), &saved, || {
                format!("return to step {number}")
            })?;
            if number % kit::thorough(3, 1) == 0 {
                let stiffness = history.stiffness().ok();
                for (how, other) in [("returned", &returned), ("restored", &restored)] {
                    same(&other.stiffness().ok(), &stiffness, || {
                        format!("stiffness before step {number}, {how}")
                    })?;
                }
            }
            let mut fresh = vec![
                ("restored", restored),
                ("from a state", History::from_state(&bodies, read).unwrap()),
                ("cloned", history.try_clone().unwrap()),
            ];
            // Half way some are left to go on by themselves.
            if number == scene.path.len() / 2 {
                copies = fresh.clone();
                copies.push(("copied", history.clone()));
            }
            // The others have the bytes that are compared above, and are left out in turn.
            if kit::thorough(true, false) {
                fresh.swap(0, number % 3);
                fresh.truncate(1);
            }
            scene.take(&mut history, step, &POSE);
            scene.take(&mut returned, step, &POSE);
            let expected = bits(&history);
            same(&bits(&returned), &expected, || {
                format!("step {number} of a history that has returned")
            })?;
            for (how, copy) in copies.iter_mut().chain(&mut fresh) {
                scene.take(copy, step, &POSE);
                same(&bits(copy), &expected, || format!("step {number}, {how}"))?;
            }
        }
        let mut alone = scene.history(&scene.half_space(&POSE), &POSE);
        scene.run(&mut alone, &POSE);
        same(&bits(&alone), &bits(&history), || {
            "without a save".to_owned()
        })
    });
}

/// Loads that no history takes: not numbers, pulling, and more than friction holds.
fn refused(history: &History) -> Vec<LoadStep> {
    let hold = LoadStep::hold();
    let along = |control| hold.tangential(Axis::X, control);
    let too_far = along(TangentialControl::Force(1e3));
    vec![
        hold.normal(NormalControl::Force(-1.0)),
        hold.normal(NormalControl::Approach(f64::NAN)),
        along(TangentialControl::Force(f64::NAN)),
        along(TangentialControl::Spring {
            position: 1.0,
            stiffness: -1.0,
        }),
        hold.twist(f64::NAN),
        // After a contact far wider than the last.
        too_far.normal(NormalControl::Force(0.12)),
        hold.normal(NormalControl::Force(history.normal().force()))
            .tangential(Axis::Y, TangentialControl::Force(1e3)),
    ]
}

#[test]
fn after_steps_that_were_refused_cancelled_or_interrupted() {
    every(scenes(), |scene| {
        let scene = shortened(scene);
        let mut history = scene.history(&scene.half_space(&POSE), &POSE);
        let mut twin = history.clone();
        let mut stopped = 0;
        for (number, step) in scene.path.iter().enumerate() {
            let before = history.to_bytes();
            for load in refused(&history) {
                let is_refused = history.step(&load).is_err();
                same(&is_refused, &true, || format!("{load:?} is taken"))?;
                same(&history.to_bytes(), &before, || {
                    format!("{load:?} before step {number}")
                })?;
            }
            let load = scene.load(step, &POSE);
            let mut has_ended = false;
            for (calls, panics) in [(0, false), (2, true), (5, false), (9, true)] {
                let mut left = calls;
                let observer = |_: &Iteration| {
                    if left > 0 {
                        left -= 1;
                        return ControlFlow::Continue(());
                    }
                    if panics {
                        // Without the message of a panic.
                        resume_unwind(Box::new("observed"));
                    }
                    ControlFlow::Break(())
                };
                let stepped = AssertUnwindSafe(|| history.step_observed(&load, observer).is_ok());
                has_ended = catch_unwind(stepped).unwrap_or(false);
                if has_ended {
                    break;
                }
                stopped += 1;
                same(&history.to_bytes(), &before, || {
                    format!("step {number}, stopped at {calls}")
                })?;
            }
            if has_ended {
                scene.wear(&mut history, &POSE);
            } else {
                scene.take(&mut history, step, &POSE);
            }
            scene.take(&mut twin, step, &POSE);
            same(&bits(&history), &bits(&twin), || format!("step {number}"))?;
        }
        same(&(stopped > 3), &true, || {
            "hardly any step was stopped".to_owned()
        })
    });
}

/// What each scene comes to by itself, on bodies that nobody else has prepared.
fn alone(scenes: &[Scene]) -> Vec<Vec<u8>> {
    let run = |scene: &Scene| {
        let mut history = scene.history(&scene.half_space(&POSE), &POSE);
        scene.run(&mut history, &POSE);
        bits(&history)
    };
    scenes.iter().map(run).collect()
}

/// Scenes without wear, whose histories one call may step, cut to the same number of steps.
fn unworn() -> Vec<Scene> {
    let mut scenes: Vec<_> = scenes().iter().map(usual).collect();
    scenes.retain(|scene| scene.wear == 0.0);
    for scene in &mut scenes {
        scene.path.truncate(kit::thorough(3, 5));
    }
    scenes
}

/// What a scene comes to over these bodies, half way handed over to another thread as what was saved.
fn handed_over(scene: &Scene, bodies: &HalfSpace) -> Vec<u8> {
    let mut history = scene.history(bodies, &POSE);
    let (first, then) = scene.path.split_at(2);
    for step in first {
        scene.take(&mut history, step, &POSE);
    }
    let saved = history.to_bytes();
    let go_on = || {
        let mut history = History::from_bytes(bodies, &saved).unwrap();
        for step in then {
            scene.take(&mut history, step, &POSE);
        }
        bits(&history)
    };
    thread::scope(|scope| scope.spawn(go_on).join().unwrap())
}

/// All at once, two of each over the same bodies, one of them on two threads in turn.
#[test]
fn beside_other_histories() {
    let scenes = unworn();
    let expected = alone(&scenes);
    let bodies: Vec<_> = scenes.iter().map(|scene| scene.half_space(&POSE)).collect();
    thread::scope(|scope| {
        for ((scene, bodies), expected) in scenes.iter().zip(&bodies).zip(&expected) {
            scope.spawn(|| {
                let mut history = scene.history(bodies, &POSE);
                scene.run(&mut history, &POSE);
                assert!(bits(&history) == *expected, "{}", scene.name);
            });
            scope.spawn(|| {
                let found = handed_over(scene, bodies);
                assert!(found == *expected, "{}, handed over", scene.name);
            });
        }
    });
}

#[cfg(feature = "parallel")]
fn pool(threads: usize) -> rayon::ThreadPool {
    let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
    builder.build().unwrap()
}

/// In one call, and as tasks of a pool that wait for tasks of their own and steal one another's.
#[cfg(feature = "parallel")]
#[test]
fn many_in_one_call_or_one_pool() {
    use rayon::prelude::*;

    let scenes = unworn();
    let expected = alone(&scenes);
    for &threads in kit::thorough(&[3][..], &[1, 3]) {
        let mut histories: Vec<_> = scenes
            .iter()
            .map(|scene| scene.history(&scene.half_space(&POSE), &POSE))
            .collect();
        let run = |scene: &Scene| alone(std::slice::from_ref(scene)).remove(0);
        let tasks: Vec<_> = pool(threads).install(|| {
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

/// Enough cells that threads and ranks have some each, so many times in x and y, in two steps.
fn shared(scene: &Scene, times: usize) -> Scene {
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
fn on_any_number_of_threads() {
    every(some_scenes(), |scene| {
        let scene = [shared(scene, kit::thorough(5, 6))];
        let one = pool(1).install(|| alone(&scene));
        same(&pool(3).install(|| alone(&scene)), &one, || {
            "three threads".to_owned()
        })
    });
}

/// Scenes that together have every boundary, model, coupling and memory, and all scenes in the campaign.
fn some_scenes() -> Vec<Scene> {
    let chosen = [
        "rows",
        "strained line",
        "plane, friction of each cell",
        "plane, one way",
        "plane, repeating",
        "coupled, permanent set",
        "shrinking",
    ];
    let mut some = scenes();
    if kit::thorough(true, false) {
        some.retain(|scene| chosen.contains(&scene.name));
        assert_eq!(some.len(), chosen.len());
    }
    some
}

/// The scenes that ranks share.
pub(crate) fn shared_scenes() -> Vec<Scene> {
    let times = kit::thorough(4, 6);
    let scenes = some_scenes();
    scenes.iter().map(|scene| shared(scene, times)).collect()
}

/// What every rank knows of a history, and what is found in its cells, as bits; with the contact spots and their labels.
pub(crate) fn found(history: &History) -> (Vec<u64>, Vec<[u64; 9]>) {
    let spots = history.spots();
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

/// Whether the parts of ranks are those of the whole.
fn put_together(parts: Vec<(Vec<u64>, Vec<[u64; 9]>)>, whole: &(Vec<u64>, Vec<[u64; 9]>)) -> Law {
    let size = parts.len();
    for (rank, (known, _)) in parts.iter().enumerate() {
        same(known, &whole.0, || {
            format!("what rank {rank} of {size} knows")
        })?;
    }
    let cells: Vec<_> = parts.into_iter().flat_map(|(_, cells)| cells).collect();
    same(&cells, &whole.1, || format!("cells on {size} ranks"))
}

/// Begun and saved on some ranks, a history goes on on others, or on none.
#[test]
fn on_any_numbers_of_ranks() {
    let numbers = [(2, 3), (3, 1), (4, 2)];
    let mut numbers = numbers.into_iter().cycle();
    every(shared_scenes(), |scene| {
        let (from, to) = numbers.next().unwrap();
        let [first, then] = scene.path[..] else {
            panic!("two steps");
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
        put_together(parts, &found(&alone))?;
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
        put_together(parts, &found(&alone))
    });
}
