//! Thread pool of the solves.

use std::cell::{Cell, RefCell};
use std::sync::{Arc, Mutex, PoisonError};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::real::{Whole, out_of_range};

/// Number of threads and their pool, with the process that owns it: the threads of a pool do not survive in a forked
/// process.
struct Owned {
    process: u32,
    threads: usize,
    /// `None` for one thread, which is the thread of the caller.
    pool: Option<Arc<ThreadPool>>,
}

/// The lock is taken only by threads that hold the GIL, and a fork also requires the GIL. The lock is therefore never
/// taken during a fork.
static POOL: Mutex<Option<Owned>> = Mutex::new(None);

/// Largest number of threads. More threads than cores take time to start and save none.
const MOST_THREADS: usize = 1024;

impl Owned {
    fn new(threads: usize) -> PyResult<Self> {
        let builder = ThreadPoolBuilder::new().num_threads(threads);
        let named = builder.thread_name(|index| format!("stickslip-{index}"));
        let pool = (threads > 1).then(|| named.build().map(Arc::new));
        Ok(Self {
            process: std::process::id(),
            threads,
            pool: pool
                .transpose()
                .map_err(|error| PyRuntimeError::new_err(error.to_string()))?,
        })
    }

    /// Replaces the previous pool.
    fn put(self, place: &mut Option<Self>) {
        let process = self.process;
        let before = place.replace(self);
        // The threads of a pool inherited through a fork do not exist and cannot be joined.
        if before
            .as_ref()
            .is_some_and(|before| before.process != process)
        {
            std::mem::forget(before);
        }
    }
}

thread_local! {
    /// Whether this thread is a rank with its own pool: ranks that wait for each other must not wait for the same
    /// threads.
    static IS_RANK: Cell<bool> = const { Cell::new(false) };
    static OWN: RefCell<Option<Owned>> = const { RefCell::new(None) };
}

/// Makes later solves called on this thread run in their own pool.
pub(crate) fn keep_apart() {
    IS_RANK.set(true);
}

/// Returns the default number of threads of rayon.
fn default_threads() -> usize {
    let asked = std::env::var("RAYON_NUM_THREADS").ok();
    let asked = asked.and_then(|threads| threads.parse().ok());
    asked
        .filter(|threads| *threads > 0)
        .unwrap_or_else(|| std::thread::available_parallelism().map_or(1, std::num::NonZero::get))
}

/// Keeps work outside the pool of this package on the calling thread. Such work would otherwise start rayon's global
/// pool, which does not survive in a forked process.
pub(crate) fn initialise() {
    stickslip::disable_global_pool();
}

/// Returns the pool of this process or of this rank, created on first use; `None` if work runs on the calling thread.
pub(crate) fn of_this_process(_py: Python<'_>) -> PyResult<Option<Arc<ThreadPool>>> {
    let mut place = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    let threads = place
        .as_ref()
        .map_or_else(default_threads, |owned| owned.threads);
    let found = |place: &mut Option<Owned>| {
        let id = (std::process::id(), threads);
        if place
            .as_ref()
            .is_none_or(|owned| (owned.process, owned.threads) != id)
        {
            Owned::new(threads)?.put(place);
        }
        Ok(place.as_ref().and_then(|owned| owned.pool.clone()))
    };
    if IS_RANK.get() {
        OWN.with_borrow_mut(found)
    } else {
        found(&mut place)
    }
}

/// Runs short work in this thread, which counts as a separate pool. The work can then never wait for threads that a
/// fork has left behind.
pub(crate) fn alone<T>(work: impl FnOnce() -> T) -> T {
    thread_local! {
        static ALONE: Option<ThreadPool> = ThreadPoolBuilder::new()
            .num_threads(1)
            .use_current_thread()
            .build()
            .ok();
    }
    ALONE.with(|_| work())
}

/// Sets the number of threads of all later solves in this process; running solves are not affected.
///
/// Results are bitwise identical for any number of threads. The default is the environment variable
/// ``RAYON_NUM_THREADS``, or the number of cores if it is not set. With one thread, all work runs on the calling thread
/// and no other thread is started.
///
/// Parameters
/// ----------
/// threads : int
///     Number of threads, from 1 to 1024. For the number of cores give ``os.cpu_count()``.
///
/// Raises
/// ------
/// ArgumentType, ArgumentRange
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> stickslip.set_num_threads(2)
/// >>> stickslip.num_threads()
/// 2
#[pyfunction]
pub(crate) fn set_num_threads(py: Python<'_>, threads: Whole) -> PyResult<()> {
    let Some(threads) = usize::try_from(threads.0).ok().filter(|count| *count > 0) else {
        let message = format!(
            "must be at least 1, got {}: for the number of cores give os.cpu_count()",
            threads.0
        );
        return Err(out_of_range(py, "threads", &message));
    };
    if threads > MOST_THREADS {
        let message = format!(
            "must be at most {MOST_THREADS}, got {threads}: for the number of cores give os.cpu_count()"
        );
        return Err(out_of_range(py, "threads", &message));
    }
    let owned = Owned::new(threads)?;
    owned.put(&mut POOL.lock().unwrap_or_else(PoisonError::into_inner));
    Ok(())
}

/// Returns the number of threads of a solve.
#[pyfunction]
pub(crate) fn num_threads(_py: Python<'_>) -> usize {
    let place = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    place
        .as_ref()
        .map_or_else(default_threads, |owned| owned.threads)
}
