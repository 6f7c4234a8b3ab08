//! Whatever rank refuses or is lost while all of them write a file, at whatever moment, nothing is written half.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::time::{Duration, Instant};

use stickslip::io::npy;
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::*;

use crate::files_of_slabs_are_those_of_the_whole::{
    between, folder, height, names_in, on_ranks, pair,
};

/// One rank alone that cannot do its part.
#[test]
fn what_one_rank_refuses_is_not_written() {
    let folder = folder("one_refuses");
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let (npy, pvti) = (folder.join("field.npy"), folder.join("field.pvti"));
    fs::write(&npy, "old").unwrap();
    fs::write(&pvti, "old").unwrap();
    // Its piece has the name of a folder.
    fs::create_dir(folder.join("field_1.vti")).unwrap();
    let outcomes = on_ranks(3, grid, |bodies, rank| {
        let slab = Field::zeros(bodies.grid());
        let elsewhere = Field::zeros(Grid::new(2, 2, 0.3, 0.2).unwrap());
        let given = if rank == 1 { &elsewhere } else { &slab };
        [
            bodies.write_npy(&npy, given),
            bodies.write_pvti(&pvti, &[("z", given)]),
        ]
    });
    for (rank, outcomes) in outcomes.iter().enumerate() {
        for outcome in outcomes {
            let refused = Error::Ranks(RankFailure::RejectedByRank { rank: 1 });
            let is_told = rank != 1 && *outcome == Err(refused);
            let is_own = matches!(outcome, Err(Error::GridMismatch { .. }));
            assert!(is_told || rank == 1 && is_own, "{outcome:?}");
        }
    }
    assert_eq!(fs::read(&npy).unwrap(), b"old");
    assert_eq!(fs::read(&pvti).unwrap(), b"old");
    assert_eq!(
        names_in(&folder),
        ["field.npy", "field.pvti", "field_1.vti"]
    );

    let outcomes = on_ranks(3, grid, |bodies, _| {
        bodies.write_pvti(&pvti, &[("z", &Field::zeros(bodies.grid()))])
    });
    assert!(outcomes.iter().all(Result::is_err), "{outcomes:?}");
    // No list of a mixture.
    assert!(!pvti.exists());
    assert!(!names_in(&folder).iter().any(|name| name.contains(".part")));
}

/// A rank that leaves after so many calls of the others.
#[derive(Debug)]
pub(crate) struct Leaving {
    pub(crate) rank: Threads,
    pub(crate) calls_left: AtomicUsize,
}

impl Ranks for Leaving {
    fn rank(&self) -> usize {
        self.rank.rank()
    }

    fn size(&self) -> usize {
        self.rank.size()
    }

    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure> {
        let left = &self.calls_left;
        let one_less = |left: usize| left.checked_sub(1);
        // What a killed process does next: nothing.
        assert!(
            left.fetch_update(Relaxed, Relaxed, one_less).is_ok(),
            "killed"
        );
        self.rank.swap(block, to, from)
    }
}

/// Loses each rank in turn before each of its calls, or before some of them, and asks what is left in the folder.
fn assert_nothing_half(
    folder: &Path,
    write: impl Fn(&HalfSpace) -> Result<()> + Sync,
    is_old_or_new: impl Fn(&Path) -> bool,
) {
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    for lost in 0..3 {
        // The ranks are lost before different calls.
        let [first, stride] = kit::thorough([2 * lost, 7], [0, 1]);
        let mut calls = first;
        loop {
            drop(fs::remove_dir_all(folder));
            fs::create_dir_all(folder).unwrap();
            let write_on = |rank: Threads| {
                let calls_left = if rank.rank() == lost {
                    calls
                } else {
                    usize::MAX
                };
                let ranks = Arc::new(Leaving {
                    rank,
                    calls_left: calls_left.into(),
                });
                let bodies = HalfSpace::distributed(grid, pair(), Boundary::Periodic, ranks)?;
                write(&bodies)
            };
            let old = HalfSpace::with_boundary(grid, pair(), Boundary::Periodic).unwrap();
            write(&old).unwrap();
            let start = Instant::now();
            let outcomes = Threads::run(3, Duration::from_secs(5), |rank| {
                catch_unwind(AssertUnwindSafe(|| write_on(rank)))
            });
            assert!(start.elapsed() < Duration::from_secs(4));
            let is_over = outcomes.iter().all(|outcome| matches!(outcome, Ok(Ok(()))));
            for (rank, outcome) in outcomes.into_iter().enumerate() {
                match outcome {
                    Err(_) => assert_eq!(rank, lost),
                    Ok(Ok(())) => {}
                    Ok(Err(error)) => assert!(
                        // The lost rank has taken the new file with it.
                        matches!(
                            error,
                            Error::Ranks(RankFailure::Disconnected { .. }) | Error::File { .. }
                        ),
                        "{error:?}"
                    ),
                }
            }
            assert!(is_old_or_new(folder), "rank {lost}, call {calls}");
            let is_part = |name: &String| name.contains(".part");
            assert!(!names_in(folder).iter().any(is_part));
            if is_over {
                break;
            }
            calls += stride;
        }
        assert!(calls >= 5, "{calls} calls");
    }
}

/// Whatever the moment at which a rank is lost, the file is the old one or the new one.
#[test]
fn a_rank_killed_in_the_middle_leaves_nothing_half() {
    let folder = folder("killed");
    let path = folder.join("field.npy");
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let [old, new] =
        [1.0, 2.0].map(|factor| npy::to_bytes(&Field::from_fn(grid, height).scaled(factor)));
    let write = |bodies: &HalfSpace| {
        let factor = if bodies.grid() == grid { 1.0 } else { 2.0 };
        bodies.write_npy(&path, &Field::from_fn(bodies.grid(), height).scaled(factor))
    };
    assert_nothing_half(&folder, write, |_| {
        let found = fs::read(&path).unwrap();
        found == old || found == new
    });
}

/// A history on a gap of this factor, before its first step.
fn history(bodies: &HalfSpace, factor: f64) -> History {
    let gap = Field::from_fn(bodies.grid(), height).scaled(factor);
    let friction = Friction::coulomb(0.3).unwrap();
    History::builder(bodies, &gap, friction).build().unwrap()
}

/// The factor of the gap of the history in a file.
fn factor_in(path: &Path, grid: Grid) -> f64 {
    let bodies = HalfSpace::with_boundary(grid, pair(), Boundary::Periodic).unwrap();
    let history = History::load(&bodies, path).unwrap();
    let gap = Field::from_fn(grid, height);
    let factor = history.gap().as_slice()[7] / gap.as_slice()[7];
    assert_eq!(*history.gap(), gap.scaled(factor));
    factor
}

/// The slabs of a history replace the earlier ones together.
#[test]
fn a_rank_killed_in_the_middle_leaves_a_whole_history() {
    let folder = folder("killed_history");
    let path = folder.join("run.state");
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let write = |bodies: &HalfSpace| {
        let factor = if bodies.grid() == grid { 1.0 } else { 2.0 };
        let gap = Field::from_fn(bodies.grid(), height).scaled(factor);
        let friction = Friction::coulomb(0.3)?;
        History::builder(bodies, &gap, friction)
            .build()?
            .save(&path)
    };
    assert_nothing_half(&folder, write, |_| {
        let factor = factor_in(&path, grid);
        factor == 1.0 || factor == 2.0
    });
}

/// A rank that cannot write leaves the earlier slabs of all, whatever has been written by the others.
#[test]
fn a_history_that_one_rank_cannot_write_is_not_saved() {
    let folder = folder("history_refused");
    let path = folder.join("run.state");
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let save = |factor: f64, of: &(dyn Fn(usize) -> std::path::PathBuf + Sync)| {
        on_ranks(3, grid, |bodies, rank| {
            history(bodies, factor).save(of(rank))
        })
    };
    let all = save(1.0, &|_| path.clone());
    assert!(all.iter().all(Result::is_ok), "{all:?}");
    assert_eq!(factor_in(&path, grid), 1.0);
    // The folder of one rank is not there.
    let nowhere = |rank| {
        if rank == 1 {
            folder.join("nowhere").join("run.state")
        } else {
            path.clone()
        }
    };
    for (rank, outcome) in save(2.0, &nowhere).iter().enumerate() {
        let refused = Error::Ranks(RankFailure::RejectedByRank { rank: 1 });
        let is_told = rank != 1 && *outcome == Err(refused);
        let is_own = rank == 1 && matches!(outcome, Err(Error::File { .. }));
        assert!(is_told || is_own, "{outcome:?}");
    }
    assert_eq!(factor_in(&path, grid), 1.0);
    // A folder has the name of the file.
    let taken = folder.join("taken.state");
    fs::create_dir(&taken).unwrap();
    let outcomes = save(2.0, &|_| taken.clone());
    assert!(outcomes.iter().all(Result::is_err), "{outcomes:?}");
    assert_eq!(names_in(&folder), ["run.state", "taken.state"]);
}

/// And a list is that of the old images or of the new ones, if there is any.
#[test]
fn a_rank_killed_in_the_middle_leaves_no_mixture() {
    let folder = folder("killed_images");
    let path = folder.join("field.pvti");
    let write = |bodies: &HalfSpace| {
        let name = if bodies.grid().rows() == (0..300) {
            "old"
        } else {
            "new"
        };
        bodies.write_pvti(&path, &[(name, &Field::from_fn(bodies.grid(), height))])
    };
    assert_nothing_half(&folder, write, |_| {
        let Ok(list) = fs::read_to_string(&path) else {
            return true;
        };
        let name = between(&list, "Name=\"", "\"").0;
        let mut pieces = 0;
        let mut rest = &list[..];
        while rest.contains("Source=") {
            let (file, after) = between(rest, "Source=\"", "\"");
            let piece = fs::read_to_string(folder.join(file)).unwrap();
            assert!(piece.contains(&format!("Name=\"{name}\"")) && piece.ends_with("</VTKFile>\n"));
            pieces += 1;
            rest = after;
        }
        pieces == if name == "old" { 1 } else { 3 }
    });
}

/// One that stops in the middle is waited for only so long.
#[test]
fn a_silent_rank_is_not_waited_for() {
    let folder = folder("silent");
    let path = folder.join("field.npy");
    fs::write(&path, "old").unwrap();
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let outcomes = Threads::run(2, Duration::from_millis(50), |rank| {
        let is_silent = rank.rank() == 1;
        let ranks = Arc::new(rank);
        let bodies = HalfSpace::distributed(grid, pair(), Boundary::Periodic, ranks)?;
        if is_silent {
            std::thread::sleep(Duration::from_millis(300));
        }
        bodies.write_npy(&path, &Field::zeros(bodies.grid()))
    });
    let silent = |failure| matches!(failure, RankFailure::Timeout { rank: 1, .. });
    assert!(matches!(&outcomes[0], Err(Error::Ranks(failure)) if silent(*failure)));
    assert!(outcomes[1].is_err(), "{outcomes:?}");
    assert_eq!(fs::read(&path).unwrap(), b"old");
    assert_eq!(names_in(&folder), ["field.npy"]);
}
