//! Ranks that are threads of one process.

use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use crate::parallel;
use crate::ranks::{RankFailure, Ranks};

/// A rank that is a thread of this process: the way to try a distributed program without MPI.
///
/// ```
/// use std::sync::Arc;
/// use std::time::Duration;
/// use stickslip::ranks::{Ranks, Threads};
/// use stickslip::{
///     Boundary, ElasticPair, Grid, HalfSpace, Material, NormalControl, NormalProblem, surface,
/// };
///
/// let pair = ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?;
/// let grid = Grid::square(96, 8.0)?;
/// let press = |bodies: &HalfSpace| -> stickslip::Result<f64> {
///     let ball = surface::sphere(bodies.grid(), 10.0)?;
///     let contact = NormalProblem::builder(bodies, &ball, NormalControl::Force(0.5)).build()?.solve()?;
///     Ok(contact.approach())
/// };
/// // Three ranks press a third of the ball each.
/// let approaches = Threads::run(3, Duration::from_secs(60), |rank| {
///     press(&HalfSpace::distributed(grid, pair, Boundary::NonPeriodic, Arc::new(rank))?)
/// });
/// let alone = press(&HalfSpace::new(grid, pair)?)?;
/// for approach in approaches {
///     assert_eq!(approach?.to_bits(), alone.to_bits());
/// }
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug)]
pub struct Threads {
    rank: usize,
    size: usize,
    patience: Duration,
    office: Arc<Office>,
}

/// Where blocks wait for their receivers.
#[derive(Debug)]
struct Office {
    post: Mutex<Post>,
    has_changed: Condvar,
}

#[derive(Debug)]
struct Post {
    /// By sender and receiver.
    blocks: Vec<VecDeque<Vec<u64>>>,
    has_left: Vec<bool>,
}

impl Office {
    fn post(&self) -> MutexGuard<'_, Post> {
        // What panics under the lock leaves queues of whole blocks.
        self.post.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Tells the others that a rank is gone, however its work ends.
struct Leaving<'a> {
    rank: usize,
    office: &'a Office,
}

impl Drop for Leaving<'_> {
    fn drop(&mut self) {
        self.office.post().has_left[self.rank] = true;
        self.office.has_changed.notify_all();
    }
}

impl Threads {
    /// Runs the work on `size` ranks at once, each on a thread of its own with an equal part of the threads of the
    /// caller's pool, and returns what each came to, in their order. A rank that waits for another longer than
    /// `patience` gives up.
    ///
    /// # Panics
    /// If the work panics on any rank, or a thread cannot be made.
    pub fn run<T: Send>(
        size: usize,
        patience: Duration,
        work: impl Fn(Self) -> T + Sync,
    ) -> Vec<T> {
        let office = Arc::new(Office {
            post: Mutex::new(Post {
                blocks: vec![VecDeque::new(); size * size],
                has_left: vec![false; size],
            }),
            has_changed: Condvar::new(),
        });
        let work = |rank: usize| {
            let _leaving = Leaving {
                rank,
                office: &office,
            };
            work(Self {
                rank,
                size,
                patience,
                office: Arc::clone(&office),
            })
        };
        let threads = (parallel::threads() / size.max(1)).max(1);
        std::thread::scope(|scope| {
            let start = |rank: usize| {
                let work = &work;
                scope.spawn(move || parallel::apart(threads, || work(rank)))
            };
            let ranks: Vec<_> = (0..size).map(start).collect();
            let ended = ranks.into_iter().map(|rank| {
                rank.join()
                    .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
            });
            ended.collect()
        })
    }

    fn send(&self, block: Vec<u64>, to: usize) {
        self.office.post().blocks[self.rank * self.size + to].push_back(block);
        self.office.has_changed.notify_all();
    }

    fn receive(&self, from: usize) -> Result<Vec<u64>, RankFailure> {
        let start = Instant::now();
        let mut post = self.office.post();
        loop {
            if let Some(block) = post.blocks[from * self.size + self.rank].pop_front() {
                return Ok(block);
            }
            if post.has_left[from] {
                return Err(RankFailure::Lost { rank: from });
            }
            let left = self.patience.saturating_sub(start.elapsed());
            if left.is_zero() {
                let seconds = self.patience.as_secs_f64();
                return Err(RankFailure::Silent {
                    rank: from,
                    seconds,
                });
            }
            let waited = self.office.has_changed.wait_timeout(post, left);
            post = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
    }
}

impl Ranks for Threads {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure> {
        self.send(block, to);
        self.receive(from)
    }
}
