//! The threads that large contacts are shared among.

use std::num::NonZero;
use std::process::id;
use std::ptr::null_mut;
use std::sync::atomic::{AtomicPtr, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::available_parallelism;

use rayon::{ThreadPool, ThreadPoolBuilder};
use stickslip_rs::SERIAL_CELL_LIMIT;

use crate::call::{Outcome, call};
use crate::error::Failure;
use crate::status::{STICKSLIP_NO_THREADS, stickslip_status};

/// How many threads were asked for; 0 for the default.
static ASKED: AtomicUsize = AtomicUsize::new(0);

/// The pool of this process; null, or that of another process, before its first use. What came through a fork is left as it
/// is: its threads are not here to be told to end, and its lock may be held by one of them.
static POOLS: AtomicPtr<Pools> = AtomicPtr::new(null_mut());

/// The threads of a process.
struct Pools {
    process: u32,
    pool: Mutex<Option<Arc<ThreadPool>>>,
}

impl Pools {
    fn of_this_process() -> &'static Self {
        let process = id();
        let present = POOLS.load(Ordering::Acquire);
        // SAFETY: what is stored here is never freed.
        if let Some(found) = unsafe { present.as_ref() }.filter(|found| found.process == process) {
            return found;
        }
        let pool = Mutex::new(None);
        let made = Box::into_raw(Box::new(Self { process, pool }));
        let order = Ordering::AcqRel;
        match POOLS.compare_exchange(present, made, order, Ordering::Acquire) {
            // SAFETY: it is never freed from now on.
            Ok(_) => unsafe { &*made },
            Err(other) => {
                // SAFETY: from the box above, and nobody else has seen it.
                drop(unsafe { Box::from_raw(made) });
                // SAFETY: another thread of this process was first.
                unsafe { &*other }
            }
        }
    }

    /// The pool of so many threads; none of one, which is that of the caller.
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
    let message = format!("cannot make {threads} threads: {problem}");
    Failure::new(STICKSLIP_NO_THREADS, message)
}

/// So many threads, or the default, as rayon counts them.
fn threads(asked: usize) -> usize {
    let positive = |count: &usize| *count > 0;
    let variable = || std::env::var("RAYON_NUM_THREADS").ok()?.parse().ok();
    let processors = || available_parallelism().map_or(1, NonZero::get);
    Some(asked)
        .filter(positive)
        .or_else(|| variable().filter(positive))
        .unwrap_or_else(processors)
}

/// Runs work on so many cells where its threads are.
pub(crate) fn enter<T: Send>(cells: usize, work: impl FnOnce() -> T + Send) -> T {
    if cells <= SERIAL_CELL_LIMIT {
        return work();
    }
    enter_always(|_| work())
}

/// Runs work on the threads asked for, and tells it whether there are several. Where the default ones cannot be made it stays
/// on the thread that calls.
pub(crate) fn enter_always<T: Send>(work: impl FnOnce(bool) -> T + Send) -> T {
    let threads = threads(ASKED.load(Ordering::Relaxed));
    match Pools::of_this_process().pool(threads) {
        Ok(Some(pool)) => pool.install(|| work(true)),
        Ok(None) | Err(_) => work(false),
    }
}

/// Sets how many threads solve contacts of more than 4096 cells and batches, from the next call on; 0 for the default, one
/// for each processor (or RAYON_NUM_THREADS). With 1 all is done by the thread that calls, and no other is ever started.
/// Calls under way keep the threads they have. Results have the same bits on any number of threads.
///
/// Threads do not survive a fork: a child process makes as many of its own at its first such call.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_set_num_threads(count: usize) -> stickslip_status {
    call(|| {
        if count > rayon::max_num_threads() {
            return Err(none(count, &"too many"));
        }
        Pools::of_this_process().pool(threads(count))?;
        ASKED.store(count, Ordering::Relaxed);
        Ok(())
    })
}
