//! Many scenes side by side, one thread each, with a line of progress.

use std::error::Error;
use std::io::Write;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Instant;

/// What `solve` makes of each job, in the order of the jobs; `what` names them on the line of progress.
pub(crate) fn run<J: Sync, T: Send>(
    what: &str,
    jobs: &[J],
    solve: impl Fn(&J) -> stickslip::Result<T> + Sync,
) -> Result<Vec<T>, Box<dyn Error>> {
    let start = Instant::now();
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let work = || -> stickslip::Result<Vec<(usize, T)>> {
        let mut results = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(job) = jobs.get(index) else {
                return Ok(results);
            };
            results.push((index, solve(job)?));
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            let seconds = start.elapsed().as_secs_f64();
            eprint!("\r{what}: {done} of {}, {seconds:.1} s ", jobs.len());
            let _ = std::io::stderr().flush();
        }
    };
    // The library runs in the pool it is called from: with a pool of one thread a scene never waits for
    // another, and the scenes share the cores.
    let alone = || -> Result<Vec<(usize, T)>, Box<dyn Error + Send + Sync>> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
        Ok(pool.install(work)?)
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let parts = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(alone)).collect();
        let join = |worker: thread::ScopedJoinHandle<'_, _>| {
            worker
                .join()
                .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        };
        workers.into_iter().map(join).collect::<Result<Vec<_>, _>>()
    });
    eprintln!();
    let parts = parts.map_err(|error| -> Box<dyn Error> { error })?;
    let mut results: Vec<(usize, T)> = parts.into_iter().flatten().collect();
    results.sort_by_key(|(index, _)| *index);
    Ok(results.into_iter().map(|(_, result)| result).collect())
}
