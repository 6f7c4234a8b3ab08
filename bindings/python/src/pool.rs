//! The threads of solves.

use std::cell::{Cell, RefCell};
use std::sync::{Arc, Mutex, PoisonError};

use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// The number of threads, and their pool, with the process that it belongs to: the threads of a pool do not live on in a
/// forked one.
struct Owned {
    process: u32,
    threads: usize,
    /// None for one thread, which is that of the caller.
    pool: Option<Arc<ThreadPool>>,
}

/// Locked by threads that hold the GIL only, and a fork needs that too: no fork finds it locked.
static POOL: Mutex<Option<Owned>> = Mutex::new(None);

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

    /// Takes the place of what was there before.
    fn put(self, place: &mut Option<Self>) {
        let process = self.process;
        let before = place.replace(self);
        // The threads of a pool that came through a fork cannot be told to end.
        if before
            .as_ref()
            .is_some_and(|before| before.process != process)
        {
            std::mem::forget(before);
        }
    }
}

thread_local! {
    /// Whether this thread is a rank, whose pool is its own: ranks that wait for each other must not wait for the same threads.
    static IS_RANK: Cell<bool> = const { Cell::new(false) };
    static OWN: RefCell<Option<Owned>> = const { RefCell::new(None) };
}

/// Solves that this thread calls from now on run in a pool of its own.
pub(crate) fn keep_apart() {
    IS_RANK.set(true);
}

/// As rayon counts them.
fn default_threads() -> usize {
    let asked = std::env::var("RAYON_NUM_THREADS").ok();
    let asked = asked.and_then(|threads| threads.parse().ok());
    asked
        .filter(|threads| *threads > 0)
        .unwrap_or_else(|| std::thread::available_parallelism().map_or(1, std::num::NonZero::get))
}

/// Work outside of the pool of this package stays on the thread that calls: rayon's own pool, which other work would start,
/// does not live on in a forked process.
pub(crate) fn initialise() {
    stickslip::disable_global_pool();
}

/// The pool of this process, or of this rank, made when it is first needed; none where work stays on the calling thread.
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

/// Runs short work in this thread, which counts as a pool of its own: nothing in it can then wait for threads that a
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

/// Sets the number of threads of all later solves in this process; solves under way keep theirs.
///
/// Results do not depend on it, to the last bit. The default is the environment variable ``RAYON_NUM_THREADS``, or
/// else the number of cores. With one thread all work is done by the thread that calls: no other is ever started.
///
/// Parameters
/// ----------
/// threads : int
///     At least 1.
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> stickslip.set_num_threads(2)
/// >>> stickslip.num_threads()
/// 2
#[pyfunction]
pub(crate) fn set_num_threads(_py: Python<'_>, threads: usize) -> PyResult<()> {
    if threads == 0 {
        return Err(PyValueError::new_err(
            "at least one thread is needed, got 0",
        ));
    }
    let owned = Owned::new(threads)?;
    owned.put(&mut POOL.lock().unwrap_or_else(PoisonError::into_inner));
    Ok(())
}

/// The number of threads of a solve.
#[pyfunction]
pub(crate) fn num_threads(_py: Python<'_>) -> usize {
    let place = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    place
        .as_ref()
        .map_or_else(default_threads, |owned| owned.threads)
}
