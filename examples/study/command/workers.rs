//! Parallel solves with one thread each and a common half-space.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::failure::Failure;
use super::plan::Plan;
use super::row::Row;
use super::solve::StudyCase;

/// Cases of a press that must be solved.
#[derive(Debug)]
pub(super) struct Job {
    pub(super) press: usize,
    pub(super) cases: Vec<usize>,
}

/// Solves jobs on the given number of threads. `take` runs on the calling thread. It receives the rows in the order in which
/// they are finished, and `None` if no row has arrived for a second. After the first failure no further job is started.
///
/// Each solve runs in a pool of one thread, because it would otherwise use all threads. Cases are independent, so threads never
/// wait as long as jobs remain.
pub(super) fn work(
    plan: &Plan,
    jobs: &[Job],
    threads: usize,
    mut take: impl FnMut(Option<Row>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let scene = &StudyCase::new(plan)?;
    let pool = |_| ThreadPoolBuilder::new().num_threads(1).build();
    let pools = (0..threads.min(jobs.len()))
        .map(pool)
        .collect::<Result<Vec<ThreadPool>, _>>()?;
    let next = &AtomicUsize::new(0);
    let (sender, rows) = mpsc::channel();
    thread::scope(|scope| {
        for pool in pools {
            let sender = sender.clone();
            let solve = move || {
                while let Some(job) = jobs.get(next.fetch_add(1, Ordering::Relaxed)) {
                    // The receiver is dropped after a row could not be written.
                    let send = |row| sender.send(Ok(row)).is_ok();
                    if let Err(error) = scene.press(job.press, &job.cases, send) {
                        let _ = sender.send(Err(error));
                        next.store(jobs.len(), Ordering::Relaxed);
                    }
                }
            };
            scope.spawn(move || pool.install(solve));
        }
        drop(sender);
        loop {
            let row = match rows.recv_timeout(Duration::from_secs(1)) {
                Ok(row) => Some(row),
                Err(RecvTimeoutError::Timeout) => None,
                Err(RecvTimeoutError::Disconnected) => return Ok(()),
            };
            let taken = row.transpose().map_err(Failure::from);
            if let Err(failure) = taken.and_then(&mut take) {
                next.store(jobs.len(), Ordering::Relaxed);
                return Err(failure);
            }
        }
    })
}
