//! The threads that large contacts are shared among.

use std::process::id;
use std::sync::{Arc, PoisonError, RwLock};

use rayon::{ThreadPool, ThreadPoolBuilder};
use stickslip_rs::CELLS_ON_ONE_THREAD;

use crate::call::call;
use crate::error::Failure;
use crate::status::{STICKSLIP_NO_THREADS, stickslip_status};

/// The pool that was asked for, with the process that made it; `None` for rayon's own.
static POOL: RwLock<Option<(u32, Arc<ThreadPool>)>> = RwLock::new(None);

/// Runs work on so many cells where its threads are.
pub(crate) fn enter<T: Send>(cells: usize, work: impl FnOnce() -> T + Send) -> T {
    if cells <= CELLS_ON_ONE_THREAD {
        return work();
    }
    enter_always(work)
}

/// Runs work on the threads asked for.
pub(crate) fn enter_always<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    let pool = POOL.read().unwrap_or_else(PoisonError::into_inner).clone();
    match pool {
        Some((_, pool)) => pool.install(work),
        None => work(),
    }
}

/// Sets how many threads solve contacts of more than 4096 cells and batches, from the next call on; 0 for the default, one
/// for each processor (or RAYON_NUM_THREADS). Calls under way keep the threads they have. Results have the same bits on
/// any number of threads.
///
/// Threads do not survive a fork: a child process calls this before its first such solve (also with the number it had).
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_set_num_threads(count: usize) -> stickslip_status {
    call(|| {
        let none = |problem: &dyn std::fmt::Display| {
            let message = format!("cannot make {count} threads: {problem}");
            Failure::new(STICKSLIP_NO_THREADS, message)
        };
        if count > rayon::max_num_threads() {
            return Err(none(&"too many"));
        }
        let threads = || ThreadPoolBuilder::new().num_threads(count);
        // Rayon's own pool can be made once, and is there at the latest when the crate asks how many threads it has.
        let pool = if threads().build_global().is_ok() {
            None
        } else {
            let built = threads().build();
            Some((id(), Arc::new(built.map_err(|error| none(&error))?)))
        };
        let mut place = POOL.write().unwrap_or_else(PoisonError::into_inner);
        let old = std::mem::replace(&mut *place, pool);
        drop(place);
        match old {
            // The threads of a parent are not here to be told to end.
            Some((made_by, old)) if made_by != id() => std::mem::forget(old),
            old => drop(old),
        }
        Ok(())
    })
}
