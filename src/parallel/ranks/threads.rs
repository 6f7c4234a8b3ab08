//! Ranks that are threads of one process.

use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use crate::parallel;
use crate::parallel::ranks::{RankFailure, Ranks};

/// A rank that is a thread of this process. A distributed program can be developed and tested with such ranks, without MPI.
///
/// ```
/// use std::sync::Arc;
/// use std::time::Duration;
/// use stickslip::ranks::{Ranks, Threads};
/// use stickslip::{
///     Boundary, ElasticPair, Grid, HalfSpace, Material, NormalLoad, NormalProblem, surface,
/// };
///
/// let pair = ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?;
/// let grid = Grid::square(96, 8.0)?;
/// let press = |bodies: &HalfSpace| -> stickslip::Result<f64> {
///     let ball = surface::sphere(bodies.grid(), 10.0)?;
///     let contact = NormalProblem::builder(bodies, &ball, NormalLoad::Force(0.5)).build()?.solve()?;
///     Ok(contact.approach())
/// };
/// // Each of the three ranks stores a third of the ball.
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
    office: Arc<Mailboxes>,
}

/// Number of initial checks for a block. The thread yields after each of them, and then sleeps until a block arrives. It yields
/// first because most blocks arrive sooner than a sleeping thread wakes up.
const EAGER: u32 = 100;

/// Mailboxes of all ranks.
type Mailboxes = Vec<Mailbox>;

/// Blocks waiting for one rank.
#[derive(Debug)]
struct Mailbox {
    post: Mutex<MessageQueue>,
    has_changed: Condvar,
}

#[derive(Debug)]
struct MessageQueue {
    /// Blocks by sender.
    blocks: Vec<VecDeque<Vec<u64>>>,
    has_left: Vec<bool>,
}

impl Mailbox {
    fn new(size: usize) -> Self {
        Self {
            post: Mutex::new(MessageQueue {
                blocks: vec![VecDeque::new(); size],
                has_left: vec![false; size],
            }),
            has_changed: Condvar::new(),
        }
    }

    fn post(&self) -> MutexGuard<'_, MessageQueue> {
        // If a thread panics while it holds the lock, the queues still contain only complete blocks.
        self.post.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut MessageQueue)) {
        change(&mut self.post());
        self.has_changed.notify_all();
    }
}

/// Guard that notifies the other ranks when the work of a rank ends, including by a panic.
struct DisconnectGuard<'a> {
    rank: usize,
    office: &'a Mailboxes,
}

impl Drop for DisconnectGuard<'_> {
    fn drop(&mut self) {
        for mailbox in self.office {
            mailbox.change(|post| post.has_left[self.rank] = true);
        }
    }
}

impl Threads {
    /// Runs the work on `size` ranks concurrently and returns the results in the order of the ranks. Each rank runs on its own
    /// thread, with an equal part of the threads of the caller's pool. A call that waits for another rank longer than `patience`
    /// returns [`RankFailure::Timeout`].
    ///
    /// # Panics
    /// Panics if the work panics on any rank, or if a thread cannot be created.
    pub fn run<T: Send>(
        size: usize,
        patience: Duration,
        work: impl Fn(Self) -> T + Sync,
    ) -> Vec<T> {
        let mailboxes = (0..size).map(|_| Mailbox::new(size));
        let office: Arc<Mailboxes> = Arc::new(mailboxes.collect());
        let work = |rank: usize| {
            let _leaving = DisconnectGuard {
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
        self.office[to].change(|post| post.blocks[self.rank].push_back(block));
    }

    /// Receives a block from each of these ranks, in their order.
    fn receive(&self, from: impl Iterator<Item = usize>) -> Result<Vec<Vec<u64>>, RankFailure> {
        let start = Instant::now();
        let mailbox = &self.office[self.rank];
        let mut post = mailbox.post();
        let mut received = Vec::new();
        let mut looks = 0;
        for from in from {
            while post.blocks[from].is_empty() {
                if post.has_left[from] {
                    return Err(RankFailure::Disconnected { rank: from });
                }
                if looks < EAGER {
                    looks += 1;
                    drop(post);
                    std::thread::yield_now();
                    post = mailbox.post();
                    continue;
                }
                let left = self.patience.saturating_sub(start.elapsed());
                if left.is_zero() {
                    let seconds = self.patience.as_secs_f64();
                    return Err(RankFailure::Timeout {
                        rank: from,
                        seconds,
                    });
                }
                let waited = mailbox.has_changed.wait_timeout(post, left);
                post = waited.unwrap_or_else(PoisonError::into_inner).0;
            }
            received.extend(post.blocks[from].pop_front());
        }
        Ok(received)
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
        Ok(self.receive([from].into_iter())?.remove(0))
    }

    fn all_to_all(
        &self,
        blocks: Vec<Vec<u64>>,
        is_expected: &[bool],
    ) -> Result<Vec<Vec<u64>>, RankFailure> {
        for (to, block) in blocks.into_iter().enumerate() {
            if to != self.rank && !block.is_empty() {
                self.send(block, to);
            }
        }
        let comes = |from: &usize| *from != self.rank && is_expected[*from];
        let senders = (0..self.size).filter(comes);
        let mut received = vec![Vec::new(); self.size];
        for (from, block) in senders.clone().zip(self.receive(senders)?) {
            received[from] = block;
        }
        Ok(received)
    }
}
