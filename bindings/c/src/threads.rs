//! Threads for large contacts.

use std::num::NonZero;
use std::process::id;
use std::ptr::null_mut;
use std::sync::atomic::{AtomicPtr, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread::available_parallelism;

use rayon::{ThreadPool, ThreadPoolBuilder};
use stickslip_rs::SERIAL_CELL_LIMIT;

use crate::call::{Outcome, call};
use crate::error::Failure;
use crate::status::{STICKSLIP_NO_THREADS, stickslip_status};

/// Largest number of threads. More threads than cores take time to start and save none.
const MOST_THREADS: usize = 1024;

/// Requested number of threads; 0 for the default.
static ASKED: AtomicUsize = AtomicUsize::new(0);

/// Thread pool of this process. Before its first use the pointer is null or refers to the pool of the parent process. A
/// pool inherited through a fork is never touched: its threads do not exist in this process, and its lock may be held by
/// one of them.
static POOLS: AtomicPtr<Pools> = AtomicPtr::new(null_mut());

/// Threads of a process.
struct Pools {
    process: u32,
    pool: Mutex<Option<Arc<ThreadPool>>>,
}

impl Pools {
    fn of_this_process() -> &'static Self {
        let process = id();
        let present = POOLS.load(Ordering::Acquire);
        // SAFETY: a stored pool is never freed.
        if let Some(found) = unsafe { present.as_ref() }.filter(|found| found.process == process) {
            return found;
        }
        let pool = Mutex::new(None);
        let made = Box::into_raw(Box::new(Self { process, pool }));
        let order = Ordering::AcqRel;
        match POOLS.compare_exchange(present, made, order, Ordering::Acquire) {
            // SAFETY: the pool is stored, so it is never freed.
            Ok(_) => unsafe { &*made },
            Err(other) => {
                // SAFETY: the pointer comes from the box above, and no other code has a copy of it.
                drop(unsafe { Box::from_raw(made) });
                // SAFETY: another thread of this process stored its pool first.
                unsafe { &*other }
            }
        }
    }

    /// Returns a pool with the given number of threads; `None` for one thread, which is the calling thread.
    fn pool(&self, threads: usize) -> Outcome<Option<Arc<ThreadPool>>> {
        if threads == 1 {
            return Ok(None);
        }
        let mut place = self.pool.lock().unwrap_or_else(PoisonError::into_inner);
        let present = place.as_ref();
        if present.is_none_or(|pool| pool.current_num_threads() != threads) {
            let built = ThreadPoolBuilder::new().num_threads(threads).build();
            *place = Some(Arc::new(built.map_err(|error| none(threads, &error))?));
        }
        Ok(place.clone())
    }
}

fn none(threads: usize, problem: &dyn std::fmt::Display) -> Failure {
    let message = format!("cannot start {threads} threads: {problem}");
    Failure::new(STICKSLIP_NO_THREADS, message)
}

/// Returns the requested number of threads, or the default of rayon if the requested number is zero.
fn threads(asked: usize) -> usize {
    // The environment and the limits of the process are read once, because reading them takes longer than many calls.
    static DEFAULT: OnceLock<usize> = OnceLock::new();
    if asked > 0 {
        return asked;
    }
    *DEFAULT.get_or_init(|| {
        let variable = std::env::var("RAYON_NUM_THREADS").ok();
        let variable = variable.and_then(|count| count.parse().ok());
        let processors = || available_parallelism().map_or(1, NonZero::get);
        variable
            .filter(|count| *count > 0)
            .unwrap_or_else(processors)
    })
}

/// Runs work on the given number of cells on the appropriate threads.
pub(crate) fn enter<T: Send>(cells: usize, work: impl FnOnce() -> T + Send) -> T {
    if cells <= SERIAL_CELL_LIMIT {
        return work();
    }
    enter_always(|_| work())
}

/// Runs work on the requested threads, and passes to the work whether there are several threads. If the threads cannot be
/// created, the work stays on the calling thread.
pub(crate) fn enter_always<T: Send>(work: impl FnOnce(bool) -> T + Send) -> T {
    let threads = threads(ASKED.load(Ordering::Relaxed));
    match Pools::of_this_process().pool(threads) {
        Ok(Some(pool)) => pool.install(|| work(true)),
        Ok(None) | Err(_) => work(false),
    }
}

/// Sets the number of threads, at most 1024, that solve batches and contacts of more than 4096 cells, starting with the next call. A count
/// of 0 means the default: the value of RAYON_NUM_THREADS at its first use, or one thread for each processor if it is not set. With a count
/// of 1, the calling thread does all work, and no other thread is ever started. Running calls keep their threads. Results
/// are bitwise identical for any number of threads.
///
/// Threads do not survive a fork: a child process creates the same number of threads at its first call that uses them.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_set_num_threads(count: usize) -> stickslip_status {
    call(|| {
        if count > MOST_THREADS {
            let problem = format!("give at most {MOST_THREADS}, or 0 for the default");
            return Err(none(count, &problem));
        }
        Pools::of_this_process().pool(threads(count))?;
        ASKED.store(count, Ordering::Relaxed);
        Ok(())
    })
}
