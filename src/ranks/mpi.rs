//! Ranks that are processes of an MPI program.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use mpi::Threading;
use mpi::point_to_point::MatchedReceiveVec;
use mpi::request::scope;
use mpi::topology::{Process, SimpleCommunicator};
use mpi::traits::{Communicator, Destination, Source};

use crate::error::{Error, Result};
use crate::ranks::{RankFailure, Ranks, launcher};

/// A rank that is a process started by `mpirun`. Made by [`Mpi::run`].
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
///     // Gaps on `bodies.grid()`, problems and solutions as ever.
///     stickslip::Result::Ok(bodies.grid().rows())
/// })??;
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug)]
pub struct Mpi {
    rank: usize,
    size: usize,
    /// The connection to the thread that holds the communicator. The lock makes the rank `Sync`, and is never contended.
    line: Mutex<Line>,
}

/// Requests to the thread that holds the communicator, and its answers.
#[derive(Debug)]
struct Line {
    requests: Sender<Request>,
    answers: Receiver<Swapped>,
}

/// The block received, or the reason why none was.
type Swapped = Result<Vec<u64>, RankFailure>;

#[derive(Debug)]
enum Request {
    Swap {
        block: Vec<u64>,
        to: usize,
        from: usize,
    },
    Leave,
}

/// The tags of MPI messages: a block of data, and the last message that a rank sends.
const BLOCK: i32 = 1;
const LEFT: i32 = 2;

/// Number of probes for a message between which the thread yields to others; between later ones it sleeps.
const EAGER: u32 = 1 << 12;
/// The length of such a sleep.
const NAP: Duration = Duration::from_micros(50);

impl Mpi {
    /// Initialises MPI, runs the work as the rank of this process in a thread of its own, and finalises MPI. A call of the
    /// work that waits for another rank longer than `patience` returns [`RankFailure::Silent`].
    ///
    /// The calling thread holds the communicator and exchanges messages for the work. The work uses the rayon pool of its
    /// process as without MPI.
    ///
    /// Only all ranks together can finalise MPI. If a call has waited for a rank in vain, and that rank is still silent for
    /// another `patience` after the work, or a block for it can neither be sent nor cancelled, this function does not return:
    /// it writes the rank and the reason to standard error and aborts all processes. Otherwise it waits for the other ranks
    /// without a limit, however long their work takes.
    ///
    /// # Errors
    /// [`Error::Ranks`], before any work: [`RankFailure::InUse`]; [`RankFailure::Apart`] if the process is alone in its
    /// communicator although several were started, as by the launcher of another MPI or by a batch job of several tasks
    /// (their number is that of the first of `OMPI_COMM_WORLD_SIZE`, `PMI_SIZE`, `MV2_COMM_WORLD_SIZE`,
    /// `SLURM_STEP_NUM_TASKS` and `SLURM_NTASKS` that is set).
    ///
    /// # Panics
    /// If the work panics, or more ranks than 2^31 are started.
    pub fn run<T: Send>(patience: Duration, work: impl FnOnce(Self) -> T + Send) -> Result<T> {
        let universe = mpi::initialize_with_threading(Threading::Funneled);
        let (universe, _) = universe.ok_or(Error::Ranks(RankFailure::InUse))?;
        let world = universe.world();
        let number = |rank: i32| usize::try_from(rank).expect("ranks are not negative");
        launcher::check(number(world.size()), |name| std::env::var(name).ok())
            .map_err(Error::Ranks)?;
        let (requests, to_serve) = channel();
        let (served, answers) = channel();
        let leave = requests.clone();
        let rank = Self {
            rank: number(world.rank()),
            size: number(world.size()),
            line: Mutex::new(Line { requests, answers }),
        };
        Ok(std::thread::scope(|threads| {
            let worker = threads.spawn(move || {
                let _leaving = Leaving(leave);
                work(rank)
            });
            let mut post = Post {
                have_left: vec![false; number(world.size())],
                are_given_up: vec![false; number(world.size())],
                world,
                patience,
            };
            for request in to_serve {
                let Request::Swap { block, to, from } = request else {
                    break;
                };
                if served.send(post.swap(&block, to, from)).is_err() {
                    break;
                }
            }
            let result = worker.join();
            post.part();
            result.unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        }))
    }
}

/// Tells the thread with the communicator that the work is done, however it ends.
struct Leaving(Sender<Request>);

impl Drop for Leaving {
    fn drop(&mut self) {
        // Nobody listens if that thread has ended.
        let _ = self.0.send(Request::Leave);
    }
}

impl Ranks for Mpi {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    fn swap(&self, block: Vec<u64>, to: usize, from: usize) -> Swapped {
        let line = self.line.lock().unwrap_or_else(PoisonError::into_inner);
        let lost = RankFailure::Lost { rank: self.rank };
        let request = Request::Swap { block, to, from };
        line.requests.send(request).map_err(|_| lost)?;
        line.answers.recv().map_err(|_| lost)?
    }
}

/// The communication of a rank, in the thread that holds the communicator.
struct Post {
    world: SimpleCommunicator,
    patience: Duration,
    /// Ranks whose last message has been read.
    have_left: Vec<bool>,
    /// Ranks for which a call has waited longer than the patience.
    are_given_up: Vec<bool>,
}

impl Post {
    fn process(&self, rank: usize) -> Process<'_> {
        self.world.process_at_rank(rank_of(rank))
    }

    fn swap(&mut self, block: &[u64], to: usize, from: usize) -> Swapped {
        scope(|scope| {
            let target = rank_of(to);
            let mut sent = self
                .world
                .process_at_rank(target)
                .immediate_send_with_tag(scope, block, BLOCK);
            let received = self.receive(from);
            self.are_given_up[from] |= matches!(received, Err(RankFailure::Silent { .. }));
            let mut clock = Clock::new(self.patience);
            // MPI may read the block until it is sent.
            while let Err(pending) = sent.test() {
                if clock.is_over() {
                    self.abort(self.silent(to));
                }
                sent = pending;
            }
            received
        })
    }

    fn receive(&mut self, from: usize) -> Swapped {
        let mut clock = Clock::new(self.patience);
        while !self.have_left[from] {
            if let Some(message) = self.process(from).immediate_matched_probe() {
                let (block, status) = message.matched_receive_vec();
                if status.tag() == BLOCK {
                    return Ok(block);
                }
                self.have_left[from] = true;
                break;
            }
            if clock.is_over() {
                return Err(self.silent(from));
            }
        }
        Err(RankFailure::Lost { rank: from })
    }

    fn silent(&self, rank: usize) -> RankFailure {
        let seconds = self.patience.as_secs_f64();
        RankFailure::Silent { rank, seconds }
    }

    /// Ends all processes.
    #[expect(clippy::print_stderr, reason = "no error can reach a caller any more")]
    fn abort(&self, why: RankFailure) -> ! {
        let own = self.world.rank();
        eprintln!("stickslip: rank {own} gives up: {why}; all ranks are aborted");
        self.world.abort(1)
    }

    /// Sends the last message to every other rank, and reads theirs, so that no rank waits for this one and no message is left
    /// unread when MPI is finalised. Aborts if a rank that was given up is still silent: to finalise would wait for it for ever.
    fn part(&mut self) {
        let own = self.world.rank();
        let others = (0..self.have_left.len()).filter(move |rank| rank_of(*rank) != own);
        for rank in others.clone() {
            let last: [u64; 0] = [];
            self.process(rank).send_with_tag(&last[..], LEFT);
        }
        for rank in others {
            let mut received = self.receive(rank);
            while received.is_ok() {
                received = self.receive(rank);
            }
            if let (true, Err(why @ RankFailure::Silent { .. })) =
                (self.are_given_up[rank], received)
            {
                self.abort(why);
            }
        }
    }
}

/// As MPI numbers a rank.
fn rank_of(rank: usize) -> i32 {
    i32::try_from(rank).expect("it came from MPI")
}

/// The time spent waiting between probes for a message.
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

    /// Yields or sleeps once, and returns whether the patience is over.
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
