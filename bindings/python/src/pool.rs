//! The threads of solves.

use std::sync::{Arc, Mutex, PoisonError};

use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// The pool, with the process that it belongs to: the threads of a pool do not live on in a forked one.
struct Owned {
    process: u32,
    threads: usize,
    pool: Arc<ThreadPool>,
}

/// Locked by threads that hold the GIL only, and a fork needs that too: no fork finds it locked.
static POOL: Mutex<Option<Owned>> = Mutex::new(None);

fn built(threads: usize) -> PyResult<Arc<ThreadPool>> {
    let builder = ThreadPoolBuilder::new().num_threads(threads);
    let named = builder.thread_name(|index| format!("stickslip-{index}"));
    let pool = named.build();
    pool.map(Arc::new)
        .map_err(|error| PyRuntimeError::new_err(error.to_string()))
}

/// The pool of this process, made when it is first needed.
pub(crate) fn of_this_process(_py: Python<'_>) -> PyResult<Arc<ThreadPool>> {
    let mut place = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    let process = std::process::id();
    let (threads, is_foreign) = place
        .as_ref()
        .map_or((0, true), |owned| (owned.threads, owned.process != process));
    if is_foreign {
        let pool = built(threads)?;
        let owned = Owned {
            process,
            threads,
            pool,
        };
        // The threads of a pool that came through a fork cannot be told to end.
        std::mem::forget(place.replace(owned));
    }
    let pool = place.as_ref().map(|owned| Arc::clone(&owned.pool));
    pool.ok_or_else(|| PyRuntimeError::new_err("no pool"))
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
/// else the number of cores.
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
    let pool = built(threads)?;
    let process = std::process::id();
    let mut place = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    let before = place.replace(Owned {
        process,
        threads,
        pool,
    });
    if before
        .as_ref()
        .is_some_and(|owned| owned.process != process)
    {
        std::mem::forget(before);
    }
    Ok(())
}

/// The number of threads of a solve.
#[pyfunction]
pub(crate) fn num_threads(py: Python<'_>) -> PyResult<usize> {
    Ok(of_this_process(py)?.current_num_threads())
}
