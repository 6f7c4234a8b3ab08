//! One thread per solve, one half-space for all.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::failure::Failure;
use super::plan::Plan;
use super::row::Row;
use super::solve::Scene;

/// Cases of one press that are to be solved.
#[derive(Debug)]
pub(super) struct Job {
    pub(super) press: usize,
    pub(super) cases: Vec<usize>,
}

/// Solves jobs on so many threads; `take` gets the rows on the calling thread, in the order in which they are finished, and
/// `None` where no row came for a second. After the first failure no further job is begun.
///
/// Each solve runs in a pool of one thread, as it would otherwise divide itself among all threads. Cases are
/// independent, so that threads wait for nothing as long as there are more jobs than threads.
pub(super) fn work(
    plan: &Plan,
    jobs: &[Job],
    threads: usize,
    mut take: impl FnMut(Option<Row>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let scene = &Scene::new(plan)?;
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
                    // Nobody receives once a row could not be written.
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
