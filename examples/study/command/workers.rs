//! One thread per solve, one half-space for all.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

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

/// Solves jobs on so many threads; `take` gets the rows on the calling thread, in the order in which they are finished.
/// After the first failure no further job is begun.
///
/// Each solve runs in a pool of one thread, as it would otherwise divide itself among all threads. Cases are
/// independent, so that threads wait for nothing as long as there are more jobs than threads.
pub(super) fn work(
    plan: &Plan,
    jobs: &[Job],
    threads: usize,
    mut take: impl FnMut(Row) -> Result<(), Failure>,
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
        for row in rows {
            if let Err(failure) = row.map_err(Failure::from).and_then(&mut take) {
                next.store(jobs.len(), Ordering::Relaxed);
                return Err(failure);
            }
        }
        Ok(())
    })
}
