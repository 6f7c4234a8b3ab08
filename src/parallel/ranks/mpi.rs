//! Ranks that are processes of an MPI program.

use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use mpi::Threading;
use mpi::point_to_point::MatchedReceiveVec;
use mpi::request::scope;
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, Destination, Source};

use crate::error::{Error, Result};
use crate::parallel::ranks::{RankFailure, Ranks, launcher};

/// A rank that is a process started by `mpirun`, created by [`Mpi::run`].
///
/// ```no_run
/// use std::sync::Arc;
/// use std::time::Duration;
/// use stickslip::ranks::Mpi;
/// use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Material};
///
/// let grid = Grid::square(8192, 8.0)?;
/// let pair = ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?;
/// let rows = Mpi::run(Duration::from_secs(600), |rank| {
///     let bodies = HalfSpace::distributed(grid, pair, Boundary::NonPeriodic, Arc::new(rank))?;
/// // Gaps on `bodies.grid()`, problems and solutions are used as without ranks.
///     stickslip::Result::Ok(bodies.grid().rows())
/// })??;
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug)]
pub struct Mpi {
    rank: usize,
    size: usize,
    /// State shared with [`Mpi::run`]. The lock makes the rank `Sync` and separates calls of MPI. It is never contended.
    post: Arc<Mutex<PeerQueues>>,
}

/// Tags of MPI messages: a block of data, and the last message of a rank.
const BLOCK: i32 = 1;
const LEFT: i32 = 2;

/// Number of initial probes for a message. The thread yields after each of them and sleeps after each later probe.
const EAGER: u32 = 1 << 12;
/// Duration of the sleep between later probes for a message.
const NAP: Duration = Duration::from_micros(50);

impl Mpi {
    /// Initialises MPI, runs the work as the rank of this process, and finalises MPI. A call of the work that waits for another
    /// rank longer than `patience` returns [`RankFailure::Timeout`].
    ///
    /// The work uses the rayon pool of its process, as without MPI. Calls of MPI are made one at a time, by the thread that
    /// currently runs the work. The MPI library must therefore grant `MPI_THREAD_SERIALIZED`, as Open MPI, MPICH and their
    /// derivatives do.
    ///
    /// All messages of an exchange are sent and received concurrently, as individual messages. The function does not use
    /// collective calls of MPI. Collective calls cannot be tested for one rank and cannot be cancelled, so a lost rank would
    /// block the others forever.
    ///
    /// MPI can be finalised only by all ranks together. This function aborts all processes in two cases. In the first case, a
    /// block cannot be sent within `patience`. In the second case, a call has timed out while it waited for a rank, and this rank
    /// is silent for another `patience` after the work. The function first writes the rank and the reason to standard error.
    /// Otherwise it waits for the other ranks without a time limit.
    ///
    /// # Errors
    /// The function returns [`Error::Ranks`], before any work, with
    /// - [`RankFailure::MpiAlreadyInitialised`] if MPI is already initialised.
    /// - [`RankFailure::InsufficientThreadLevel`] if the MPI library does not grant the thread level.
    /// - [`RankFailure::SeparateMpiJobs`] if the process is alone in its communicator although several processes were started.
    ///   Possible causes are the launcher of a different MPI library and a batch job of several tasks. The number of processes is
    ///   read from the first of these variables that is set: `OMPI_COMM_WORLD_SIZE`, `PMI_SIZE`, `MV2_COMM_WORLD_SIZE`,
    ///   `SLURM_STEP_NUM_TASKS` and `SLURM_NTASKS`.
    ///
    /// # Panics
    /// Panics if the work panics, or if more than 2^31 ranks are started.
    pub fn run<T>(patience: Duration, work: impl FnOnce(Self) -> T) -> Result<T> {
        // MPI is finalised when this value is dropped, after everything else.
        let (_universe, granted) = mpi::initialize_with_threading(Threading::Serialized)
            .ok_or(Error::Ranks(RankFailure::MpiAlreadyInitialised))?;
        if !matches!(granted, Threading::Serialized | Threading::Multiple) {
            return Err(Error::Ranks(RankFailure::InsufficientThreadLevel));
        }
        let world = SimpleCommunicator::world();
        let number = |rank: i32| usize::try_from(rank).expect("ranks are not negative");
        let (rank, size) = (number(world.rank()), number(world.size()));
        launcher::check(size, |name| std::env::var(name).ok()).map_err(Error::Ranks)?;
        let post = Arc::new(Mutex::new(PeerQueues {
            have_left: vec![false; size],
            are_given_up: vec![false; size],
            has_parted: false,
            patience,
        }));
        let own = Self {
            rank,
            size,
            post: Arc::clone(&post),
        };
        let result = catch_unwind(AssertUnwindSafe(|| work(own)));
        lock(&post).part();
        Ok(result.unwrap_or_else(|panic| resume_unwind(panic)))
    }

    /// Calls MPI, or returns an error if this rank has already sent its last messages.
    fn call<T>(
        &self,
        call: impl FnOnce(&mut PeerQueues) -> Result<T, RankFailure>,
    ) -> Result<T, RankFailure> {
        let mut post = lock(&self.post);
        if post.has_parted {
            return Err(RankFailure::Disconnected { rank: self.rank });
        }
        call(&mut post)
    }
}

/// Locks the state. A panic under the lock leaves the state valid.
fn lock(post: &Mutex<PeerQueues>) -> MutexGuard<'_, PeerQueues> {
    post.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Ranks for Mpi {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Result<Vec<u64>, RankFailure> {
        self.call(|post| {
            let mut received = Vec::new();
            post.exchange(&[(to, block)], vec![from], |_, block| received = block)?;
            Ok(received)
        })
    }

    fn all_to_all(
        &self,
        blocks: Vec<Vec<u64>>,
        is_expected: &[bool],
    ) -> Result<Vec<Vec<u64>>, RankFailure> {
        let sent = blocks.into_iter().enumerate();
        let sent: Vec<_> = sent
            .filter(|(to, block)| *to != self.rank && !block.is_empty())
            .collect();
        let others = (0..self.size).filter(|rank| *rank != self.rank && is_expected[*rank]);
        let awaited = others.collect();
        let mut received = vec![Vec::new(); self.size];
        self.call(|post| post.exchange(&sent, awaited, |from, block| received[from] = block))?;
        Ok(received)
    }
}

/// State of a rank's communication. Each call creates the communicator, because it cannot be moved between threads.
#[derive(Debug)]
struct PeerQueues {
    patience: Duration,
    /// Ranks whose last message has been received.
    have_left: Vec<bool>,
    /// Ranks for which a call has waited longer than the patience.
    are_given_up: Vec<bool>,
    /// Whether this rank has sent its last messages.
    has_parted: bool,
}

impl PeerQueues {
    /// Sends all blocks to their ranks together, and takes one block from each of the awaited ranks in order of arrival.
    fn exchange(
        &mut self,
        blocks: &[(usize, Vec<u64>)],
        awaited: Vec<usize>,
        mut take: impl FnMut(usize, Vec<u64>),
    ) -> Result<(), RankFailure> {
        let world = SimpleCommunicator::world();
        scope(|scope| {
            let mut sent = Vec::with_capacity(blocks.len());
            for (to, block) in blocks {
                let process = world.process_at_rank(rank_of(*to));
                sent.push((
                    *to,
                    process.immediate_send_with_tag(scope, &block[..], BLOCK),
                ));
            }
            let received = self.receive(&world, awaited, &mut take);
            if let Err(RankFailure::Timeout { rank, .. }) = received {
                self.are_given_up[rank] = true;
            }
            let mut clock;
            for (to, mut sent) in sent {
                clock = Clock::new(self.patience);
                // MPI may read the block until the send completes.
                while let Err(pending) = sent.test() {
                    if clock.is_over() {
                        Self::abort(&world, self.silent(to));
                    }
                    sent = pending;
                }
            }
            received
        })
    }

    /// Receives a block from each of the awaited ranks, in any order. If a rank is lost, the function still receives the blocks
    /// of the others, so that they do not wait for this rank.
    fn receive(
        &mut self,
        world: &SimpleCommunicator,
        mut awaited: Vec<usize>,
        take: &mut dyn FnMut(usize, Vec<u64>),
    ) -> Result<(), RankFailure> {
        let mut clock = Clock::new(self.patience);
        let mut outcome = Ok(());
        while let Some(&next) = awaited.last() {
            for place in (0..awaited.len()).rev() {
                match self.arrived(world, awaited[place]) {
                    Ok(None) => continue,
                    Ok(Some(block)) => take(awaited[place], block),
                    Err(lost) => outcome = outcome.and(Err(lost)),
                }
                awaited.swap_remove(place);
                clock = Clock::new(self.patience);
            }
            if !awaited.is_empty() && clock.is_over() {
                return Err(self.silent(next));
            }
        }
        outcome
    }

    /// Returns the next block of a rank, or `None` if it has not arrived.
    fn arrived(
        &mut self,
        world: &SimpleCommunicator,
        from: usize,
    ) -> Result<Option<Vec<u64>>, RankFailure> {
        let lost = RankFailure::Disconnected { rank: from };
        if self.have_left[from] {
            return Err(lost);
        }
        let process = world.process_at_rank(rank_of(from));
        let Some(message) = process.immediate_matched_probe() else {
            return Ok(None);
        };
        let (block, status) = message.matched_receive_vec();
        if status.tag() == BLOCK {
            return Ok(Some(block));
        }
        self.have_left[from] = true;
        Err(lost)
    }

    fn silent(&self, rank: usize) -> RankFailure {
        let seconds = self.patience.as_secs_f64();
        RankFailure::Timeout { rank, seconds }
    }

    /// Aborts all processes.
    fn abort(world: &SimpleCommunicator, why: RankFailure) -> ! {
        let own = world.rank();
        let message =
            format!("stickslip: rank {own} cannot continue and aborts all ranks: {why}\n");
        // No error can reach a caller any more. One write keeps the messages of several ranks separate.
        let _ = std::io::stderr().write_all(message.as_bytes());
        world.abort(1)
    }

    /// Sends the last message to every other rank and receives their last messages. No rank then waits for this rank, and no
    /// message is unread when MPI is finalised. Aborts if a rank that has timed out is still silent, because the call that
    /// finalises MPI would wait for that rank forever.
    fn part(&mut self) {
        self.has_parted = true;
        let world = SimpleCommunicator::world();
        let own = world.rank();
        let others = (0..self.have_left.len()).filter(move |rank| rank_of(*rank) != own);
        for rank in others.clone() {
            let last: [u64; 0] = [];
            let process = world.process_at_rank(rank_of(rank));
            process.send_with_tag(&last[..], LEFT);
        }
        // The rank receives from all others together: while one rank is silent, others may wait for this rank to
        // receive a block.
        let mut left: Vec<usize> = others.collect();
        while !left.is_empty() {
            let received = self.receive(&world, left.clone(), &mut |_, _| ());
            left.retain(|rank| !self.have_left[*rank]);
            let given_up = left.iter().find(|rank| self.are_given_up[**rank]);
            if let (Err(RankFailure::Timeout { .. }), Some(rank)) = (received, given_up) {
                Self::abort(&world, self.silent(*rank));
            }
        }
    }
}

/// Returns the MPI number of a rank.
fn rank_of(rank: usize) -> i32 {
    i32::try_from(rank).expect("it came from MPI")
}

/// Time spent waiting between probes for a message.
struct Clock {
    start: Instant,
    patience: Duration,
    looks: u32,
}

impl Clock {
    fn new(patience: Duration) -> Self {
        Self {
            start: Instant::now(),
            patience,
            looks: 0,
        }
    }

    /// Yields or sleeps once, and returns whether the patience is exhausted.
    fn is_over(&mut self) -> bool {
        self.looks = self.looks.saturating_add(1);
        if self.looks < EAGER {
            std::thread::yield_now();
            return false;
        }
        std::thread::sleep(NAP);
        self.start.elapsed() >= self.patience
    }
}
