//! Execution of long work: without the GIL, in a pool that is recreated after a fork, and interruptible by signals and by
//! the progress callback. All other work runs on the calling thread.

use std::cell::Cell;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use pyo3::exceptions::{PyKeyboardInterrupt, PyRuntimeError};
use pyo3::prelude::*;
use rayon::ThreadPool;
use stickslip::{Error, Iteration, Result, SERIAL_CELL_LIMIT};

use crate::error::OrRaise;
use crate::function::{has_raised, raising};
use crate::pool;
use crate::progress::Progress;

/// Stage of a work, which is passed to the progress callback.
pub(crate) trait Stage: Clone + Send {
    /// Returns the stage as an object of Python.
    fn object(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>>;
}

impl Stage for Iteration {
    fn object(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        Bound::new(py, crate::report::Iteration(self)).map(Bound::into_any)
    }
}

/// Function that a solve calls before each product, or at another stage. Other work calls it without a stage at points
/// where it can be interrupted.
pub(crate) type Observer<'a, S = Iteration> =
    &'a mut (dyn FnMut(Option<&S>) -> ControlFlow<()> + Send);

/// Returns `Ok` if work without iterations may continue. The error only ends the work; the caller raises the exception
/// that interrupted it.
pub(crate) fn unless_broken_off(observer: Observer<'_>) -> Result<()> {
    observer(None)
        .is_continue()
        .then_some(())
        .ok_or(Error::EmptyPath)
}

/// Interval between checks for signals.
const SIGNAL_INTERVAL: Duration = Duration::from_millis(5);

thread_local! {
    /// Whether this thread runs a callback of a solve, which occupies the pool.
    static IS_CALLED_BACK: Cell<bool> = const { Cell::new(false) };
}

/// Solves a problem on the given number of cells. The outer error is a Python exception, raised by a signal handler (as
/// for Ctrl-C), by the progress callback, or by a function that is an operator. The solve then ends at its next product.
/// If the progress callback returns `False`, the solve is cancelled: the inner result is its error or its partial result.
///
/// Python handles signals on the main thread only. A long solve therefore runs in the pool, while the calling thread
/// waits for it and checks for signals. A short solve runs on the calling thread, and so does every solve if there is
/// only one thread.
pub(crate) fn solve<T: Send>(
    py: Python<'_>,
    cells: usize,
    progress: Progress<'_>,
    work: impl FnOnce(Observer<'_>) -> Result<T> + Send,
) -> PyResult<Result<T>> {
    solve_in_stages(py, cells, progress, work)
}

/// Runs a solve like [`solve`], whose progress callback receives stages of any kind.
pub(crate) fn solve_in_stages<T: Send, S: Stage>(
    py: Python<'_>,
    cells: usize,
    progress: Progress<'_>,
    work: impl FnOnce(Observer<'_, S>) -> Result<T> + Send,
) -> PyResult<Result<T>> {
    if IS_CALLED_BACK.get() {
        return Err(PyRuntimeError::new_err(
            "a solve cannot start within the progress callback of a different solve",
        ));
    }
    let callback = progress.callback();
    let pool = if cells <= SERIAL_CELL_LIMIT {
        None
    } else {
        pool::of_this_process(py)?
    };
    // If the thread belongs to the pool, it runs an operator that calls back. It must not wait for other threads, which
    // may be doing the same.
    let pool = pool.filter(|pool| pool.current_thread_index().is_none());
    let ended = match pool {
        None => in_place(py, callback, work),
        Some(pool) => in_pool(py, &pool, callback, work),
    };
    progress.close()?;
    let (outcome, interruption) = ended?;
    match (interruption, outcome) {
        (None, outcome) => Ok(outcome),
        // The interrupt came after the last product: the result is complete, and the interrupt is raised for the next
        // line.
        (Some(exception), Ok(done)) if exception.is_instance_of::<PyKeyboardInterrupt>(py) => {
            py.import("_thread")?.call_method0("interrupt_main")?;
            Ok(Ok(done))
        }
        (Some(exception), _) => Err(exception),
    }
}

/// Returns the observer in the form that the crate calls.
pub(crate) fn watch(
    observer: Observer<'_>,
) -> impl FnMut(&Iteration) -> ControlFlow<()> + Send + '_ {
    |iteration| observer(Some(iteration))
}

/// Runs long work other than a solve on the cells of a grid. Messages about a wrong sample use the grid.
pub(crate) fn observed_on<T: Send>(
    py: Python<'_>,
    grid: stickslip::Grid,
    work: impl FnOnce(Observer<'_>) -> Result<T> + Send,
) -> PyResult<T> {
    solve(py, grid.cells(), Progress::none(), work)?.or_raise_on(py, grid)
}

/// Runs work without an observer. A signal is raised when the work has finished.
pub(crate) fn unobserved<T: Send>(
    py: Python<'_>,
    cells: usize,
    work: impl FnOnce() -> Result<T> + Send,
) -> PyResult<T> {
    let outcome = solve(py, cells, Progress::none(), |_| work())?;
    outcome.or_raise(py)
}

/// Runs work without an observer on the cells of a grid. Messages about a wrong sample use the grid.
pub(crate) fn unobserved_on<T: Send>(
    py: Python<'_>,
    grid: stickslip::Grid,
    work: impl FnOnce() -> Result<T> + Send,
) -> PyResult<T> {
    observed_on(py, grid, |_| work())
}

/// Result of a solve and the exception that interrupted it.
type Ended<T> = (Result<T>, Option<PyErr>);

fn in_place<T: Send, S: Stage>(
    py: Python<'_>,
    callback: Option<&Py<PyAny>>,
    work: impl FnOnce(Observer<'_, S>) -> Result<T> + Send,
) -> PyResult<Ended<T>> {
    let mut interruption = None;
    let outcome = py.detach(|| {
        let mut is_cancelled = false;
        let mut looked = Instant::now();
        let mut observer = |stage: Option<&S>| {
            let is_due = looked.elapsed() >= SIGNAL_INTERVAL;
            if interruption.is_none() && (is_due || callback.is_some()) {
                let outcome = Python::attach(|py| {
                    if let Some(stage) = stage.filter(|_| !is_cancelled) {
                        is_cancelled = called(py, callback, stage)?.is_break();
                    }
                    py.check_signals()
                });
                interruption = outcome.err();
                looked = Instant::now();
            }
            match interruption {
                None if !is_cancelled && !has_raised() => ControlFlow::Continue(()),
                _ => ControlFlow::Break(()),
            }
        };
        pool::alone(|| raising(|| work(&mut observer)))
    });
    Ok((outcome?, interruption))
}

/// State shared by the thread of the solve and the calling thread.
struct Exchange<S> {
    messages: Mutex<Messages<S>>,
    changed: Condvar,
    stop: AtomicBool,
}

struct Messages<S> {
    is_done: bool,
    /// Stage to be passed to the callback; `None` once it has been called.
    stage: Option<S>,
}

impl<S: Stage> Exchange<S> {
    fn new() -> Self {
        Self {
            messages: Mutex::new(Messages {
                is_done: false,
                stage: None,
            }),
            changed: Condvar::new(),
            stop: AtomicBool::new(false),
        }
    }

    /// Requests a callback from the calling thread and waits until it has returned.
    fn call(&self, stage: S) {
        let mut messages = self.messages();
        messages.stage = Some(stage);
        self.changed.notify_all();
        while messages.stage.is_some() {
            messages = self
                .changed
                .wait(messages)
                .unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Waits for the end, for a callback request or for the next signal check; returns whether the end has come.
    fn wait(&self) -> (bool, Option<S>) {
        let mut messages = self.messages();
        if !messages.is_done && messages.stage.is_none() {
            let waited = self.changed.wait_timeout(messages, SIGNAL_INTERVAL);
            messages = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
        (messages.is_done, messages.stage.clone())
    }

    fn called(&self) {
        self.messages().stage = None;
        self.changed.notify_all();
    }
}

impl<S> Exchange<S> {
    fn messages(&self) -> MutexGuard<'_, Messages<S>> {
        self.messages.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Guard that reports the end of the solve, even if it panics.
struct Done<'a, S>(&'a Exchange<S>);

impl<S> Drop for Done<'_, S> {
    fn drop(&mut self) {
        self.0.messages().is_done = true;
        self.0.changed.notify_all();
    }
}

fn in_pool<T: Send, S: Stage>(
    py: Python<'_>,
    pool: &ThreadPool,
    callback: Option<&Py<PyAny>>,
    work: impl FnOnce(Observer<'_, S>) -> Result<T> + Send,
) -> PyResult<Ended<T>> {
    let exchange = Exchange::new();
    let is_followed = callback.is_some();
    let mut outcome = None;
    let mut interruption = None;
    let mut is_cancelled = false;
    pool.in_place_scope(|scope| {
        scope.spawn(|_| {
            let done = Done(&exchange);
            let mut observer = |stage: Option<&S>| {
                let is_stopped = || exchange.stop.load(Ordering::Relaxed);
                let shown = stage.filter(|_| is_followed && !is_stopped());
                if let Some(stage) = shown {
                    exchange.call(stage.clone());
                }
                if is_stopped() || has_raised() {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            };
            outcome = Some(raising(|| work(&mut observer)));
            drop(done);
        });
        loop {
            let (is_done, stage) = py.detach(|| exchange.wait());
            if is_done {
                break;
            }
            if interruption.is_none() {
                let shown = stage.as_ref().filter(|_| !is_cancelled);
                let answer = shown.map_or(Ok(ControlFlow::Continue(())), |stage| {
                    called(py, callback, stage)
                });
                let seen = answer.and_then(|answer| {
                    is_cancelled |= answer.is_break();
                    py.check_signals()
                });
                interruption = seen.err();
                let is_stopped = is_cancelled || interruption.is_some();
                exchange.stop.store(is_stopped, Ordering::Relaxed);
            }
            if stage.is_some() {
                exchange.called();
            }
        }
    });
    let outcome = outcome.ok_or_else(|| PyRuntimeError::new_err("the solve has not run"))?;
    Ok((outcome?, interruption))
}

/// Calls the progress callback, which cancels the work by returning `False`.
fn called(
    py: Python<'_>,
    callback: Option<&Py<PyAny>>,
    stage: &impl Stage,
) -> PyResult<ControlFlow<()>> {
    let Some(callback) = callback else {
        return Ok(ControlFlow::Continue(()));
    };
    let stage = stage.clone().object(py)?;
    IS_CALLED_BACK.set(true);
    let outcome = callback.call1(py, (stage,));
    IS_CALLED_BACK.set(false);
    let is_cancelled = outcome?.extract::<bool>(py).is_ok_and(|goes_on| !goes_on);
    Ok(if is_cancelled {
        ControlFlow::Break(())
    } else {
        ControlFlow::Continue(())
    })
}
