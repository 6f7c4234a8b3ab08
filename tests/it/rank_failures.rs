//! A failure on one rank is reported by all ranks and leaves their histories unchanged.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use stickslip::history::{AdaptiveSteps, Cycle, FrettingLoop, LoadPath, State};
use stickslip::influence::Component;
use stickslip::layers::Response;
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::*;

use crate::distributed_io_is_atomic::LostRank;
use crate::rank_contacts::{PATIENCE, assert_rejected_by, on_ranks, pair};
use crate::rank_histories::{ball, fine, friction, run, started};

/// Missing slabs, slabs of different states, and a file that one rank cannot read are reported.
#[test]
fn mismatched_slabs_are_rejected() {
    let (grid, boundary) = (fine(), Boundary::NonPeriodic);
    let alone = HalfSpace::with_boundary(grid, pair(), boundary).unwrap();
    let begin = |bodies: &HalfSpace| started(bodies, false);
    let slabs: Vec<Vec<u8>> = on_ranks(3, grid, boundary, |bodies, rank| {
        let mut history = begin(bodies);
        let bytes = history.to_bytes();
        run(&mut history, 5..6);
        if rank == 2 { history.to_bytes() } else { bytes }
    });
    let rejected = |slabs: &[Vec<u8>]| {
        let slabs = slabs.iter().map(|bytes| State::from_bytes(bytes));
        State::from_slabs(&alone, slabs).map(drop).unwrap_err()
    };
    // A chunk has 32 rows. The local rows of the third rank start with the third of four chunks. In the thorough run
    // they start with the sixth of eight chunks.
    let row = kit::thorough(64, 160);
    let other = Error::Ranks(RankFailure::InconsistentSlabs { row });
    assert_eq!(rejected(&slabs), other);
    let missing = Error::Ranks(RankFailure::MissingSlab { row });
    assert_eq!(rejected(&slabs[..2]), missing);
    // First the slabs are of two different steps, then the bytes of one rank are damaged.
    for (rank, byte) in [(2, None), (1, Some(40))] {
        let outcomes = on_ranks(3, grid, boundary, |bodies, number| {
            let mut bytes = slabs[number].clone();
            if let (true, Some(byte)) = (number == rank, byte) {
                bytes[byte] ^= 1;
            }
            History::from_bytes(bodies, &bytes).map(drop)
        });
        for (number, outcome) in outcomes.iter().enumerate() {
            let is_reported = match byte {
                None => matches!(
                    outcome,
                    Err(Error::Ranks(RankFailure::InconsistentInput(_)))
                ),
                Some(_) if number == rank => matches!(outcome, Err(Error::Format { .. })),
                Some(_) => matches!(
                    outcome,
                    Err(Error::Ranks(RankFailure::RejectedByRank { rank: 1 }))
                ),
            };
            assert!(is_reported, "{outcome:?}");
        }
    }
}

/// Inputs that must be the same on all ranks are compared. An error of the observer of one rank is returned by all
/// ranks, even if the observer itself has made collective calls.
#[test]
fn differing_ranks_are_reported() {
    let (grid, boundary) = (fine(), Boundary::NonPeriodic);
    let patience = std::time::Duration::from_secs(20);
    let outcomes = Threads::run(3, patience, |rank| {
        let is_first = rank.rank() == 0;
        let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap();
        let mut history = started(&bodies, false);
        let chosen = if is_first {
            kit::coulomb(0.4)
        } else {
            friction(&bodies)
        };
        let different = Error::Ranks(RankFailure::InconsistentInput("friction"));
        assert_eq!(history.set_friction(&chosen), Err(different));
        let path = LoadPath::triangle([0.1, 0.0], 4).unwrap();
        let fretting = FrettingLoop::new(path, LoadStep::force);
        let mut outcomes = Vec::new();
        for is_early in [true, false] {
            let before = history.to_bytes();
            let outcome = fretting.run_observed(&mut history, 2, |history, _| {
                let mut gap = history.unloaded_gap().clone();
                if is_first && is_early {
                    return Err(Error::EmptyPath);
                }
                if is_first {
                    gap.as_mut_slice()[0] = f64::NAN;
                }
                history.set_gap(&gap)?;
                Ok(ControlFlow::Continue(()))
            });
            outcomes.push(outcome.map(drop));
            let mut adaptive = AdaptiveSteps::new(&history, 0.05).unwrap();
            let load = LoadStep::force([0.05, 0.0]);
            let own = if is_first {
                Err(Error::EmptyPath)
            } else {
                Ok(())
            };
            let kept = history.to_bytes();
            let outcome = adaptive.step_observed(&mut history, &load, |_| own.clone());
            assert!(history.to_bytes() == kept && kept != before);
            outcomes.push(outcome.map(drop));
        }
        outcomes
    });
    for place in 0..4 {
        let outcomes: Vec<_> = outcomes.iter().map(|of| of[place].clone()).collect();
        assert_rejected_by(0, &outcomes, |error| match place {
            2 => matches!(error, Error::Sample { .. }),
            _ => *error == Error::EmptyPath,
        });
    }
}

/// Ranks that return to different steps of a history report this immediately and keep their states.
#[test]
fn ranks_returning_to_different_steps_are_reported() {
    on_ranks(3, fine(), Boundary::NonPeriodic, |bodies, rank| {
        let is_first = rank == 0;
        let mut history = started(bodies, false);
        let early = history.state().clone();
        run(&mut history, 5..7);
        let late = history.state().clone();
        run(&mut history, 7..8);
        let before = history.to_bytes();
        let different = Error::Ranks(RankFailure::InconsistentInput(
            "state (except for its fields)",
        ));
        kit::assert_refused! { history.set_state(if is_first { &early } else { &late }) => error if error == different }
        assert!(history.to_bytes() == before);
        history.set_state(&early).unwrap();
        assert!(history.to_bytes() == early.to_bytes());
    });
}

/// All ranks reject coefficients that one rank cannot compute, and can continue with other coefficients.
#[test]
fn kernel_failing_on_one_rank_is_rejected_by_all() {
    let (near, boundary) = (pair(), Boundary::NonPeriodic);
    let grid = Grid::new(64, 200, 0.1, 0.1).unwrap();
    let outcomes = Threads::run(3, PATIENCE, |rank| {
        let is_last = rank.rank() == 2;
        let fails = Arc::new(AtomicBool::new(false));
        let broken = Arc::clone(&fails);
        let response = move |k: f64| {
            let found = near.response(k).unwrap();
            let is_broken = broken.load(Relaxed);
            let normal = if is_broken { f64::NAN } else { found.normal };
            Response { normal, ..found }
        };
        let kernel = Kernel::isotropic(near, 0.4, response).unwrap();
        let bodies = HalfSpace::distributed(grid, &kernel, boundary, Arc::new(rank)).unwrap();
        fails.store(is_last, Relaxed);
        let failed = bodies.operator(Component::ZZ).map(drop);
        (failed, bodies.operator(Component::XX).map(drop))
    });
    let (failed, others): (Vec<_>, Vec<_>) = outcomes.into_iter().unzip();
    assert_rejected_by(2, &failed, |error| matches!(error, Error::Sample { .. }));
    assert_eq!(others, vec![Ok(()); 3]);
}

/// A step that all ranks reject, or during which one rank is lost, leaves the history unchanged.
#[test]
fn failed_step_leaves_ranks_unchanged() {
    let grid = fine();
    let lost = on_ranks(3, grid, Boundary::NonPeriodic, |bodies, number| {
        let gap = ball(bodies);
        let builder = History::builder(bodies, &gap, kit::coulomb(0.3));
        let mut history = builder.coupling(Coupling::OneWay).build().unwrap();
        history
            .step(&LoadStep::force([0.2, 0.0]).normal(NormalLoad::Force(2.0)))
            .unwrap();
        let before = history.to_bytes();
        let too_much = LoadStep::force([9.0, 0.0]).normal(NormalLoad::Force(12.0));
        kit::assert_refused! { history.step(&too_much) => Error::BeyondFrictionCapacity { .. } }
        assert!(history.to_bytes() == before);

        // The second rank leaves during the next step.
        let larger = LoadStep::force([1.0, 0.0]).normal(NormalLoad::Force(12.0));
        let mut calls = 0;
        let outcome = catch_unwind(AssertUnwindSafe(|| {
            history
                .step_observed(&larger, |_| {
                    calls += 1;
                    assert!(number != 1 || calls < 8, "a rank is lost");
                    ControlFlow::Continue(())
                })
                .map(drop)
        }));
        assert!(history.to_bytes() == before);
        outcome
    });
    assert!(lost[1].is_err());
    for rank in [0, 2] {
        kit::assert_refused! { lost[rank].as_ref().unwrap() => Error::Ranks(_) }
    }
}

/// A rank is lost at any moment of a step. Each of the other ranks then has taken the step either completely or not
/// at all.
#[test]
fn step_is_taken_completely_or_not_at_all() {
    let grid = Grid::new(64, 150, 0.15, 0.1).unwrap();
    let last = usize::MAX;
    // Returns the state of each rank before and after the step, its outcome, and the number of calls it made.
    let step_until = |calls: usize, coupling: Coupling, is_adaptive: bool| {
        Threads::run(3, PATIENCE, |rank| {
            let is_lost = rank.rank() == 1;
            let ranks = Arc::new(LostRank {
                rank,
                calls_left: last.into(),
            });
            let shared: Arc<dyn Ranks> = Arc::clone(&ranks) as _;
            let boundary = Boundary::NonPeriodic;
            let bodies = HalfSpace::distributed(grid, pair(), boundary, shared).unwrap();
            let gap = ball(&bodies);
            let builder = History::builder(&bodies, &gap, friction(&bodies));
            let builder = builder.coupling(coupling).tolerance(1e-3);
            let mut history = builder.build().unwrap();
            let press = LoadStep::force([0.2, 0.0]).normal(NormalLoad::Force(2.0));
            history.step(&press).unwrap();
            let before = history.to_bytes();
            let mut adaptive = is_adaptive.then(|| AdaptiveSteps::new(&history, 0.2).unwrap());
            let calls = if is_lost { calls } else { last };
            ranks.calls_left.store(calls, Relaxed);
            let larger = LoadStep::force([0.5, 0.0]).normal(NormalLoad::Force(4.0));
            let step = || match &mut adaptive {
                Some(adaptive) => adaptive.step(&mut history, &larger).map(drop),
                None => history.step(&larger).map(drop),
            };
            let outcome = catch_unwind(AssertUnwindSafe(step));
            let used = calls - ranks.calls_left.load(Relaxed);
            (before, history.to_bytes(), outcome.ok(), used)
        })
    };
    let kinds = [
        (Coupling::Full, false),
        (Coupling::OneWay, true),
        (Coupling::OneWay, false),
    ];
    for (coupling, is_adaptive) in kinds.into_iter().take(kit::thorough(2, 3)) {
        let whole = step_until(last, coupling, is_adaptive);
        let (all, mut rejected) = (whole[1].3, 0);
        // The last calls of a step are made while the new state is committed.
        let [parts, stride] = kit::thorough([2, 8], [6, 1]);
        let moments = (0..all).step_by(all / parts);
        let moments = moments.chain((all - 24..all).step_by(stride));
        for calls in moments {
            let parts = step_until(calls, coupling, is_adaptive);
            for rank in [0, 2] {
                let (before, after, outcome, _) = &parts[rank];
                match outcome {
                    Some(Ok(())) => assert!(
                        after == &whole[rank].1,
                        "accepted step, {calls} of {all} calls"
                    ),
                    Some(Err(Error::Ranks(_))) => {
                        assert!(after == before, "rejected step, {calls} of {all} calls");
                        rejected += 1;
                    }
                    other => panic!("{other:?}"),
                }
            }
        }
        assert!(rejected > kit::thorough(8, 40), "{rejected}");
    }
}

/// Returns the state of a history and of a cycle on a rank, and the friction capacity of the whole contact.
fn snapshot(history: &History, cycle: &Cycle) -> (Vec<u8>, [Cycle; 2], u64) {
    let cycles = [cycle.clone(), Cycle::new(history)];
    let capacity = history.friction_capacity().to_bits();
    (history.to_bytes(), cycles, capacity)
}

type Change = fn(&mut History, &mut Cycle, &State) -> Result<()>;

/// A rank is lost at any moment of a change or of the accumulation of a cycle. The change is then made completely or
/// not at all.
#[test]
fn change_is_made_completely_or_not_at_all() {
    let grid = Grid::new(96, kit::thorough(90, 180), 0.1, 0.08).unwrap();
    let last = usize::MAX;
    // Returns the state of each rank before and after the change, its outcome, and the number of calls it made.
    let change_until = |change: Change, calls: usize| {
        Threads::run(3, PATIENCE, |rank| {
            let is_lost = rank.rank() == 1;
            let ranks = Arc::new(LostRank {
                rank,
                calls_left: last.into(),
            });
            let shared: Arc<dyn Ranks> = Arc::clone(&ranks) as _;
            let boundary = Boundary::NonPeriodic;
            let bodies = HalfSpace::distributed(grid, pair(), boundary, shared).unwrap();
            let gap = ball(&bodies);
            let builder = History::builder(&bodies, &gap, friction(&bodies));
            let mut history = builder.coupling(Coupling::Neglected).build().unwrap();
            let load = |force| LoadStep::force([0.1 * force, 0.0]).normal(NormalLoad::Force(force));
            history.step(&load(2.0)).unwrap();
            let early = history.state().clone();
            let mut cycle = Cycle::new(&history);
            history.step(&load(3.0)).unwrap();
            let before = snapshot(&history, &cycle);
            let calls = if is_lost { calls } else { last };
            ranks.calls_left.store(calls, Relaxed);
            let change = || change(&mut history, &mut cycle, &early);
            let outcome = catch_unwind(AssertUnwindSafe(change));
            let used = calls - ranks.calls_left.load(Relaxed);
            (before, snapshot(&history, &cycle), outcome.ok(), used)
        })
    };
    let changes: [Change; 5] = [
        |history, cycle, _| cycle.begin(history),
        |history, cycle, _| cycle.add(history),
        |history, _, early| history.set_state(early),
        |history, _, _| {
            let worn = history.unloaded_gap().map(|gap| gap + 1e-4);
            history.set_gap(&worn)
        },
        |history, _, _| history.set_friction(&Friction::coulomb(0.2)?),
    ];
    for (number, change) in changes.into_iter().enumerate() {
        let whole = change_until(change, last);
        let all = whole[1].3;
        assert!(all > 0 && whole[0].0 != whole[0].1, "change {number}");
        for calls in (0..all).step_by(kit::thorough(11, 1)) {
            let parts = change_until(change, calls);
            let mut rejected = 0;
            for rank in [0, 2] {
                let (before, after, outcome, _) = &parts[rank];
                let what = format!("change {number}, {calls} of {all} calls, rank {rank}");
                match outcome {
                    Some(Ok(())) => assert!(*after == whole[rank].1, "made, {what}"),
                    Some(Err(Error::Ranks(_))) => {
                        assert!(after == before, "rejected, {what}");
                        rejected += 1;
                    }
                    other => panic!("{other:?}, {what}"),
                }
            }
            assert!(rejected > 0, "change {number}, {calls} of {all} calls");
        }
    }
}
