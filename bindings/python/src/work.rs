//! How a solve runs: without the GIL, on threads that survive a fork, ended by signals and by what follows its progress.

use std::cell::Cell;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use pyo3::exceptions::{PyKeyboardInterrupt, PyRuntimeError};
use pyo3::prelude::*;
use stickslip::{Error, Iteration, Result};

use crate::pool;
use crate::progress::Progress;

/// What a solve calls before each product, and other work, without an iteration, where it may be broken off.
pub(crate) type Observer<'a> = &'a mut (dyn FnMut(Option<&Iteration>) -> ControlFlow<()> + Send);

/// Where work without iterations may be broken off. What it returns then only ends the work: the exception that broke it
/// off takes its place.
pub(crate) fn look(observer: Observer<'_>) -> Result<()> {
    observer(None)
        .is_continue()
        .then_some(())
        .ok_or(Error::EmptyPath)
}

/// How often signals are looked for.
const PATIENCE: Duration = Duration::from_millis(5);

/// Cells up to which the crate works in the calling thread.
const SHORT: usize = 4096;

thread_local! {
    /// Whether this thread is in a callback of a solve, which occupies the pool.
    static IS_CALLED_BACK: Cell<bool> = const { Cell::new(false) };
}

/// Solves something on so many cells. The outer error is that of Python: an exception of a signal handler, which Ctrl-C
/// calls, or of the callable that follows the progress. The solve has then ended at its next product.
///
/// Signals are handled in the main thread only, and a long solve is none of its business: it goes to the pool while the
/// calling thread waits for it and looks for signals. A short one runs in the calling thread.
pub(crate) fn solve<T: Send>(
    py: Python<'_>,
    cells: usize,
    progress: Progress<'_>,
    work: impl FnOnce(Observer<'_>) -> Result<T> + Send,
) -> PyResult<Result<T>> {
    if IS_CALLED_BACK.get() {
        return Err(PyRuntimeError::new_err(
            "a solve cannot begin within the progress callback of another",
        ));
    }
    let callback = progress.callback();
    let (outcome, interruption) = if cells <= SHORT {
        in_place(py, callback, work)
    } else {
        in_pool(py, callback, work)?
    };
    progress.close()?;
    match (interruption, outcome) {
        (None, outcome) => Ok(outcome),
        // It came after the last product: what was asked for is done, and the interrupt is that of the next line.
        (Some(exception), Ok(done)) if exception.is_instance_of::<PyKeyboardInterrupt>(py) => {
            py.import("_thread")?.call_method0("interrupt_main")?;
            Ok(Ok(done))
        }
        (Some(exception), _) => Err(exception),
    }
}

/// Work that no observer sees. A signal is raised when it is done.
pub(crate) fn unobserved<T: Send>(
    py: Python<'_>,
    cells: usize,
    work: impl FnOnce() -> Result<T> + Send,
) -> PyResult<T> {
    let outcome = solve(py, cells, Progress::none(), |_| work())?;
    outcome.map_err(|error| crate::error::raised(py, error))
}

/// What a solve came to, and what interrupted it.
type Ended<T> = (Result<T>, Option<PyErr>);

fn in_place<T: Send>(
    py: Python<'_>,
    callback: Option<&Py<PyAny>>,
    work: impl FnOnce(Observer<'_>) -> Result<T> + Send,
) -> Ended<T> {
    let mut interruption = None;
    let outcome = py.detach(|| {
        let mut looked = Instant::now();
        let mut observer = |iteration: Option<&Iteration>| {
            let is_due = looked.elapsed() >= PATIENCE;
            if interruption.is_none() && (is_due || callback.is_some()) {
                let outcome = Python::attach(|py| {
                    if let Some(iteration) = iteration {
                        called(py, callback, iteration)?;
                    }
                    py.check_signals()
                });
                interruption = outcome.err();
                looked = Instant::now();
            }
            match interruption {
                None => ControlFlow::Continue(()),
                Some(_) => ControlFlow::Break(()),
            }
        };
        pool::alone(|| work(&mut observer))
    });
    (outcome, interruption)
}

/// What the thread of the solve and the calling thread say to each other.
#[derive(Default)]
struct Talk {
    said: Mutex<Said>,
    changed: Condvar,
    stop: AtomicBool,
}

#[derive(Default)]
struct Said {
    is_done: bool,
    /// What the callback is to be called with; gone once it has been.
    iteration: Option<Iteration>,
}

impl Talk {
    fn said(&self) -> MutexGuard<'_, Said> {
        self.said.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Lets the calling thread call back, and waits until it has.
    fn call(&self, iteration: Iteration) {
        let mut said = self.said();
        said.iteration = Some(iteration);
        self.changed.notify_all();
        while said.iteration.is_some() {
            said = self
                .changed
                .wait(said)
                .unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Waits for the end, for a call or for the time to look for signals; says whether the end has come.
    fn wait(&self) -> (bool, Option<Iteration>) {
        let mut said = self.said();
        if !said.is_done && said.iteration.is_none() {
            let waited = self.changed.wait_timeout(said, PATIENCE);
            said = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
        (said.is_done, said.iteration)
    }

    fn called(&self) {
        self.said().iteration = None;
        self.changed.notify_all();
    }
}

/// Says that the solve is done, also where it panics.
struct Done<'a>(&'a Talk);

impl Drop for Done<'_> {
    fn drop(&mut self) {
        self.0.said().is_done = true;
        self.0.changed.notify_all();
    }
}

fn in_pool<T: Send>(
    py: Python<'_>,
    callback: Option<&Py<PyAny>>,
    work: impl FnOnce(Observer<'_>) -> Result<T> + Send,
) -> PyResult<Ended<T>> {
    let pool = pool::of_this_process(py)?;
    let talk = Talk::default();
    let is_followed = callback.is_some();
    let mut outcome = None;
    let mut interruption = None;
    pool.in_place_scope(|scope| {
        scope.spawn(|_| {
            let done = Done(&talk);
            let mut observer = |iteration: Option<&Iteration>| {
                let is_stopped = || talk.stop.load(Ordering::Relaxed);
                let shown = iteration.filter(|_| is_followed && !is_stopped());
                if let Some(iteration) = shown {
                    talk.call(*iteration);
                }
                if is_stopped() {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            };
            outcome = Some(work(&mut observer));
            drop(done);
        });
        loop {
            let (is_done, iteration) = py.detach(|| talk.wait());
            if is_done {
                break;
            }
            if interruption.is_none() {
                let seen = iteration.map_or(Ok(()), |iteration| called(py, callback, &iteration));
                interruption = seen.and_then(|()| py.check_signals()).err();
                talk.stop.store(interruption.is_some(), Ordering::Relaxed);
            }
            if iteration.is_some() {
                talk.called();
            }
        }
    });
    let outcome = outcome.ok_or_else(|| PyRuntimeError::new_err("the solve has not run"))?;
    Ok((outcome, interruption))
}

fn called(py: Python<'_>, callback: Option<&Py<PyAny>>, iteration: &Iteration) -> PyResult<()> {
    let Some(callback) = callback else {
        return Ok(());
    };
    IS_CALLED_BACK.set(true);
    let outcome = callback.call1(py, (crate::report::Iteration(*iteration),));
    IS_CALLED_BACK.set(false);
    outcome.map(|_| ())
}
