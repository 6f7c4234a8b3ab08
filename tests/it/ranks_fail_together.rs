//! What fails on one rank fails on all, and leaves histories as they were.

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
use crate::ranks_share_a_contact::{PATIENCE, pair};
use crate::ranks_share_a_history::{ball, begun, fine, friction, run};

/// Slabs that are missing, or not of one state, are told; so is a file that one rank cannot read.
#[test]
fn slabs_that_do_not_belong_together_are_refused() {
    let (grid, boundary) = (fine(), Boundary::NonPeriodic);
    let alone = HalfSpace::with_boundary(grid, pair(), boundary).unwrap();
    let begin = |bodies: &HalfSpace| begun(bodies, false);
    let slabs: Vec<Vec<u8>> = Threads::run(3, PATIENCE, |rank| {
        let number = rank.rank();
        let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap();
        let mut history = begin(&bodies);
        let bytes = history.to_bytes();
        run(&mut history, 5..6);
        if number == 2 {
            history.to_bytes()
        } else {
            bytes
        }
    });
    let refused = |slabs: &[Vec<u8>]| {
        let slabs = slabs.iter().map(|bytes| State::from_bytes(bytes));
        State::from_slabs(&alone, slabs).map(drop).unwrap_err()
    };
    // A chunk is 32 rows. The third rank has those from the third of four on, and from the sixth of eight in the campaign.
    let row = kit::thorough(64, 160);
    let other = Error::Ranks(RankFailure::InconsistentSlabs { row });
    assert_eq!(refused(&slabs), other);
    let missing = Error::Ranks(RankFailure::MissingSlab { row });
    assert_eq!(refused(&slabs[..2]), missing);
    // Slabs of two steps on the ranks that hold them, and bytes that are damaged on one.
    for (rank, byte) in [(2, None), (1, Some(40))] {
        let outcomes = Threads::run(3, PATIENCE, |own| {
            let number = own.rank();
            let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(own)).unwrap();
            let mut bytes = slabs[number].clone();
            if let (true, Some(byte)) = (number == rank, byte) {
                bytes[byte] ^= 1;
            }
            History::from_bytes(&bodies, &bytes).map(drop)
        });
        for (number, outcome) in outcomes.iter().enumerate() {
            let is_told = match byte {
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
            assert!(is_told, "{outcome:?}");
        }
    }
}

/// What must be the same on all ranks is compared; what an observer refuses on one, all refuse, also where it has asked
/// the others itself.
#[test]
fn ranks_that_differ_are_told() {
    let (grid, boundary) = (fine(), Boundary::NonPeriodic);
    let patience = std::time::Duration::from_secs(20);
    let outcomes = Threads::run(3, patience, |rank| {
        let is_first = rank.rank() == 0;
        let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap();
        let mut history = begun(&bodies, false);
        let other = Friction::coulomb(0.4).unwrap();
        let chosen = if is_first { other } else { friction(&bodies) };
        let different = Error::Ranks(RankFailure::InconsistentInput("friction"));
        assert_eq!(history.set_friction(&chosen), Err(different));
        let path = LoadPath::triangle([0.1, 0.0], 4).unwrap();
        let fretting = FrettingLoop::new(path, LoadStep::force);
        let mut outcomes = Vec::new();
        for is_early in [true, false] {
            let before = history.to_bytes();
            let outcome = fretting.run_observed(&mut history, 2, |history, _| {
                let mut gap = history.gap().clone();
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
    for (number, outcomes) in outcomes.iter().enumerate() {
        for outcome in outcomes {
            let is_refused = *outcome == Err(Error::Ranks(RankFailure::RejectedByRank { rank: 0 }));
            assert_eq!(is_refused, number != 0, "{outcome:?}");
            assert!(outcome.is_err());
        }
    }
}

/// Ranks that return to different steps of one history are told at once, and stay where they are.
#[test]
fn ranks_that_return_to_different_steps_are_told() {
    Threads::run(3, PATIENCE, |rank| {
        let is_first = rank.rank() == 0;
        let boundary = Boundary::NonPeriodic;
        let bodies = HalfSpace::distributed(fine(), pair(), boundary, Arc::new(rank)).unwrap();
        let mut history = begun(&bodies, false);
        let early = history.state().clone();
        run(&mut history, 5..7);
        let late = history.state().clone();
        run(&mut history, 7..8);
        let before = history.to_bytes();
        let different = Error::Ranks(RankFailure::InconsistentInput("state but for its fields"));
        let outcome = history.set_state(if is_first { &early } else { &late });
        assert_eq!(outcome, Err(different));
        assert!(history.to_bytes() == before);
        history.set_state(&early).unwrap();
        assert!(history.to_bytes() == early.to_bytes());
    });
}

/// Coefficients that one rank cannot make are refused by all, which go on with others.
#[test]
fn kernels_that_fail_on_one_rank_are_refused_by_all() {
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
    for (number, (failed, other)) in outcomes.iter().enumerate() {
        let is_told = match failed {
            Err(Error::Sample { .. }) => number == 2,
            failed => *failed == Err(Error::Ranks(RankFailure::RejectedByRank { rank: 2 })),
        };
        assert!(is_told && *other == Ok(()), "rank {number}: {failed:?}");
    }
}

/// What all ranks refuse, or what one of them is lost in, leaves the history as it was.
#[test]
fn failed_steps_leave_no_trace_on_ranks() {
    let grid = fine();
    let lost = Threads::run(3, PATIENCE, |rank| {
        let number = rank.rank();
        let boundary = Boundary::NonPeriodic;
        let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap();
        let gap = ball(&bodies);
        let builder = History::builder(&bodies, &gap, Friction::coulomb(0.3).unwrap());
        let mut history = builder.coupling(Coupling::OneWay).build().unwrap();
        history
            .step(&LoadStep::force([0.2, 0.0]).normal(NormalControl::Force(2.0)))
            .unwrap();
        let before = history.to_bytes();
        let too_much = LoadStep::force([9.0, 0.0]).normal(NormalControl::Force(12.0));
        let refused = history.step(&too_much).map(drop);
        assert!(
            matches!(refused, Err(Error::BeyondFrictionCapacity { .. })),
            "{refused:?}"
        );
        assert!(history.to_bytes() == before);

        // The second rank leaves in the middle of the next step.
        let larger = LoadStep::force([1.0, 0.0]).normal(NormalControl::Force(12.0));
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
        let outcome = lost[rank].as_ref().unwrap();
        assert!(matches!(outcome, Err(Error::Ranks(_))), "{outcome:?}");
    }
}

/// A rank may be lost at any moment of a step: the others have taken it wholly, or not at all.
#[test]
fn a_step_is_taken_wholly_or_not_at_all() {
    let grid = Grid::new(64, 150, 0.15, 0.1).unwrap();
    let last = usize::MAX;
    // What a rank has before and after the step, its outcome, and the calls it has made.
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
            let press = LoadStep::force([0.2, 0.0]).normal(NormalControl::Force(2.0));
            history.step(&press).unwrap();
            let before = history.to_bytes();
            let mut adaptive = is_adaptive.then(|| AdaptiveSteps::new(&history, 0.2).unwrap());
            let calls = if is_lost { calls } else { last };
            ranks.calls_left.store(calls, Relaxed);
            let larger = LoadStep::force([0.5, 0.0]).normal(NormalControl::Force(4.0));
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
        let (all, mut refused) = (whole[1].3, 0);
        // The last calls of a step are those on the way into the state.
        let [parts, stride] = kit::thorough([2, 8], [6, 1]);
        let moments = (0..all).step_by(all / parts);
        let moments = moments.chain((all - 24..all).step_by(stride));
        for calls in moments {
            let parts = step_until(calls, coupling, is_adaptive);
            for rank in [0, 2] {
                let (before, after, outcome, _) = &parts[rank];
                match outcome {
                    Some(Ok(())) => assert!(after == &whole[rank].1, "taken, {calls} of {all}"),
                    Some(Err(Error::Ranks(_))) => {
                        assert!(after == before, "refused, {calls} of {all}");
                        refused += 1;
                    }
                    other => panic!("{other:?}"),
                }
            }
        }
        assert!(refused > kit::thorough(8, 40), "{refused}");
    }
}

/// What a rank has of a history and of a cycle over it, and what it knows of the whole contact.
fn seen(history: &History, cycle: &Cycle) -> (Vec<u8>, [Cycle; 2], u64) {
    let cycles = [cycle.clone(), Cycle::new(history)];
    let capacity = history.friction_capacity().to_bits();
    (history.to_bytes(), cycles, capacity)
}

type Change = fn(&mut History, &mut Cycle, &State) -> Result<()>;

/// A rank may be lost at any moment of a change too, or while a cycle is added up.
#[test]
fn changes_are_made_wholly_or_not_at_all() {
    let grid = Grid::new(96, kit::thorough(90, 180), 0.1, 0.08).unwrap();
    let last = usize::MAX;
    // What a rank sees before and after the change, its outcome, and the calls it has made.
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
            let load =
                |force| LoadStep::force([0.1 * force, 0.0]).normal(NormalControl::Force(force));
            history.step(&load(2.0)).unwrap();
            let early = history.state().clone();
            let mut cycle = Cycle::new(&history);
            history.step(&load(3.0)).unwrap();
            let before = seen(&history, &cycle);
            let calls = if is_lost { calls } else { last };
            ranks.calls_left.store(calls, Relaxed);
            let change = || change(&mut history, &mut cycle, &early);
            let outcome = catch_unwind(AssertUnwindSafe(change));
            let used = calls - ranks.calls_left.load(Relaxed);
            (before, seen(&history, &cycle), outcome.ok(), used)
        })
    };
    let changes: [Change; 5] = [
        |history, cycle, _| cycle.begin(history),
        |history, cycle, _| cycle.add(history),
        |history, _, early| history.set_state(early),
        |history, _, _| {
            let worn = history.gap().map(|gap| gap + 1e-4);
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
            let mut refused = 0;
            for rank in [0, 2] {
                let (before, after, outcome, _) = &parts[rank];
                let what = format!("change {number}, {calls} of {all} calls, rank {rank}");
                match outcome {
                    Some(Ok(())) => assert!(*after == whole[rank].1, "made, {what}"),
                    Some(Err(Error::Ranks(_))) => {
                        assert!(after == before, "refused, {what}");
                        refused += 1;
                    }
                    other => panic!("{other:?}, {what}"),
                }
            }
            assert!(refused > 0, "change {number}, {calls} of {all} calls");
        }
    }
}
