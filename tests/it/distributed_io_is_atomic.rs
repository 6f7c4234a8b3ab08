//! If a rank fails or is lost at any time while all ranks write a file, no partial file remains.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Arc, Mutex, mpsc};
use std::time::{Duration, Instant};

use stickslip::io::npy;
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::*;

use crate::distributed_io::{between, folder, height, names_in, on_ranks, pair};

/// Covers a single rank that cannot do its part.
#[test]
fn file_rejected_by_one_rank_is_not_written() {
    let folder = folder("one_refuses");
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let (npy, pvti) = (folder.join("field.npy"), folder.join("field.pvti"));
    fs::write(&npy, "old").unwrap();
    fs::write(&pvti, "old").unwrap();
    // The name of the piece of this rank is taken by a folder.
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
    // No list refers to a mixture of old and new pieces.
    assert!(!pvti.exists());
    assert!(!names_in(&folder).iter().any(|name| name.contains(".part")));
}

/// A rank that is lost after the given number of collective calls.
#[derive(Debug)]
pub(crate) struct LostRank {
    pub(crate) rank: Threads,
    pub(crate) calls_left: AtomicUsize,
}

impl Ranks for LostRank {
    fn rank(&self) -> usize {
        self.rank.rank()
    }

    fn size(&self) -> usize {
        self.rank.size()
    }

    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure> {
        let left = &self.calls_left;
        let one_less = |left: usize| left.checked_sub(1);
        // A killed process makes no further calls.
        assert!(
            left.fetch_update(Relaxed, Relaxed, one_less).is_ok(),
            "killed"
        );
        self.rank.swap(block, to, from)
    }
}

/// Loses each rank in turn before each of its calls, or before some of them, and checks the contents of the folder.
fn assert_old_or_new(
    folder: &Path,
    write: impl Fn(&HalfSpace) -> Result<()> + Sync,
    is_old_or_new: impl Fn(&Path) -> bool,
) {
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    for lost in 0..3 {
        // Each rank is lost before different calls.
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
                let ranks = Arc::new(LostRank {
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
                        // The temporary file was removed together with the lost rank.
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

/// If a rank is lost at any time, the file is either the old file or the new file.
#[test]
fn rank_killed_while_writing_leaves_old_or_new_file() {
    let folder = folder("killed");
    let path = folder.join("field.npy");
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let [old, new] =
        [1.0, 2.0].map(|factor| npy::to_bytes(&Field::from_fn(grid, height).scaled(factor)));
    let write = |bodies: &HalfSpace| {
        let factor = if bodies.grid() == grid { 1.0 } else { 2.0 };
        bodies.write_npy(&path, &Field::from_fn(bodies.grid(), height).scaled(factor))
    };
    assert_old_or_new(&folder, write, |_| {
        let found = fs::read(&path).unwrap();
        found == old || found == new
    });
}

/// Returns a history before its first step, on a gap scaled by `factor`.
fn new_history(bodies: &HalfSpace, factor: f64) -> History {
    let gap = Field::from_fn(bodies.grid(), height).scaled(factor);
    History::builder(bodies, &gap, kit::coulomb(0.3))
        .build()
        .unwrap()
}

/// Returns the factor of the gap of the history in a file.
fn saved_factor(path: &Path, grid: Grid) -> f64 {
    let bodies = HalfSpace::with_boundary(grid, pair(), Boundary::Periodic).unwrap();
    let history = History::load(&bodies, path).unwrap();
    let gap = Field::from_fn(grid, height);
    let factor = history.unloaded_gap().as_slice()[7] / gap.as_slice()[7];
    assert_eq!(*history.unloaded_gap(), gap.scaled(factor));
    factor
}

/// All slabs of a saved history are replaced together.
#[test]
fn rank_killed_while_saving_leaves_a_complete_history() {
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
    assert_old_or_new(&folder, write, |_| {
        let factor = saved_factor(&path, grid);
        factor == 1.0 || factor == 2.0
    });
}

/// If one rank cannot write, the earlier slabs of all ranks remain, regardless of the slabs already written.
#[test]
fn history_that_one_rank_cannot_write_is_not_saved() {
    let folder = folder("history_refused");
    let path = folder.join("run.state");
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let save = |factor: f64, of: &(dyn Fn(usize) -> std::path::PathBuf + Sync)| {
        on_ranks(3, grid, |bodies, rank| {
            new_history(bodies, factor).save(of(rank))
        })
    };
    let all = save(1.0, &|_| path.clone());
    assert!(all.iter().all(Result::is_ok), "{all:?}");
    assert_eq!(saved_factor(&path, grid), 1.0);
    // The folder of one rank does not exist.
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
    assert_eq!(saved_factor(&path, grid), 1.0);
    // The name of the file is taken by a folder.
    let taken = folder.join("taken.state");
    fs::create_dir(&taken).unwrap();
    let outcomes = save(2.0, &|_| taken.clone());
    assert!(outcomes.iter().all(Result::is_err), "{outcomes:?}");
    assert_eq!(names_in(&folder), ["run.state", "taken.state"]);
}

/// If a list of images exists, it refers either to the old or to the new images.
#[test]
fn rank_killed_while_writing_leaves_old_or_new_images() {
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
    assert_old_or_new(&folder, write, |_| {
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

/// The other ranks wait for a silent rank only until the timeout.
#[test]
fn silent_rank_causes_a_timeout() {
    let folder = folder("silent");
    let path = folder.join("field.npy");
    fs::write(&path, "old").unwrap();
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    // The timeout is long enough for the setup on a busy machine. The silent rank waits for the end of the other rank, however
    // long that takes.
    let (is_over, end) = mpsc::channel();
    let (is_over, end) = (Mutex::new(Some(is_over)), Mutex::new(end));
    let outcomes = Threads::run(2, Duration::from_secs(1), |rank| {
        let is_silent = rank.rank() == 1;
        // The end of this rank drops the sender, whether or not its setup succeeds.
        let waiting = if is_silent {
            None
        } else {
            is_over.lock().unwrap().take()
        };
        let ranks = Arc::new(rank);
        let bodies = HalfSpace::distributed(grid, pair(), Boundary::Periodic, ranks)?;
        if is_silent {
            let ended: Result<(), _> = end.lock().unwrap().recv();
            assert!(ended.is_err());
        }
        let outcome = bodies.write_npy(&path, &Field::zeros(bodies.grid()));
        drop(waiting);
        outcome
    });
    let silent = |failure| matches!(failure, RankFailure::Timeout { rank: 1, .. });
    assert!(matches!(&outcomes[0], Err(Error::Ranks(failure)) if silent(*failure)));
    assert!(outcomes[1].is_err(), "{outcomes:?}");
    assert_eq!(fs::read(&path).unwrap(), b"old");
    assert_eq!(names_in(&folder), ["field.npy"]);
}
