//! Common parts of the solvers of all contacts: one-time solves and reusable solvers.

use std::ops::ControlFlow;
use std::sync::{Arc, Mutex, MutexGuard};

use pyo3::PyClass;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use stickslip::{Iteration, Result};

use crate::error::{OrRaise, with_iterate};
use crate::progress::Progress;
use crate::report::warn;
use crate::solution_pool::{Spare, lock};
use crate::work::{Observer, Stage, solve, solve_in_stages, unobserved_on};

/// Solver of the crate.
pub(crate) trait Solver: Send + Sized {
    type Solution: Send + Sync;
    /// Python class of the solutions.
    type Object: PyClass + Into<PyClassInitializer<Self::Object>> + From<Arc<Self::Solution>>;

    fn new_solution(&self) -> Self::Solution;

    fn solve_observed(
        &mut self,
        solution: &mut Self::Solution,
        observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<()>;

    fn warnings(solution: &Self::Solution) -> Vec<stickslip::Warning>;
}

/// Solves a problem once, with a solver created for it.
pub(crate) fn solve_once<'py, S: Solver>(
    py: Python<'py>,
    cells: usize,
    solver: impl FnOnce() -> Result<S> + Send,
    progress: Option<Bound<'py, PyAny>>,
    is_warned: bool,
) -> PyResult<Bound<'py, S::Object>> {
    solve_sheared(py, cells, solver, progress, is_warned, Vec::new)
}

/// Solves a problem once. The warnings of its normal contact, which the solve of this contact has issued, are not issued again.
pub(crate) fn solve_sheared<'py, S: Solver>(
    py: Python<'py>,
    cells: usize,
    solver: impl FnOnce() -> Result<S> + Send,
    progress: Option<Bound<'py, PyAny>>,
    is_warned: bool,
    of_contact: impl FnOnce() -> Vec<stickslip::Warning>,
) -> PyResult<Bound<'py, S::Object>> {
    let progress = Progress::of(progress.as_ref())?;
    let mut solution = None;
    let outcome = solve(py, cells, progress, |observer| {
        let mut solver = solver()?;
        let solution = solution.insert(solver.new_solution());
        solver.solve_observed(solution, |iteration| observer(Some(iteration)))
    })?;
    finished::<S>(py, outcome, solution.map(Arc::new), is_warned, of_contact)
}

/// Returns the solution as an object, or the exception with the last iterate attached.
fn finished<S: Solver>(
    py: Python<'_>,
    outcome: Result<()>,
    solution: Option<Arc<S::Solution>>,
    is_warned: bool,
    of_contact: impl FnOnce() -> Vec<stickslip::Warning>,
) -> PyResult<Bound<'_, S::Object>> {
    let solution =
        || solution.ok_or_else(|| PyRuntimeError::new_err("the solve returned no solution"));
    match outcome {
        Ok(()) => {
            let solution = solution()?;
            warn(py, is_warned, || {
                let mut warnings = S::warnings(&solution);
                let issued = of_contact();
                warnings.retain(|warning| !issued.contains(warning));
                warnings
            })?;
            Bound::new(py, S::Object::from(solution))
        }
        Err(error) => Err(with_iterate(py, error, || {
            Bound::new(py, S::Object::from(solution()?)).map(Bound::into_any)
        })),
    }
}

/// Reusable solver that one thread at a time may use, and the solutions whose memory it reuses.
pub(crate) struct Reused<S: Solver> {
    work: Mutex<(S, Spare<S::Solution>)>,
    grid: stickslip::Grid,
}

impl<S: Solver> Reused<S> {
    /// Creates the solver of a problem on this grid.
    pub(crate) fn new(
        py: Python<'_>,
        grid: stickslip::Grid,
        solver: impl FnOnce() -> Result<S> + Send,
    ) -> PyResult<Self> {
        let solver = unobserved_on(py, grid, solver)?;
        Ok(Self {
            work: Mutex::new((solver, Spare::new())),
            grid,
        })
    }

    pub(crate) fn grid(&self) -> stickslip::Grid {
        self.grid
    }

    fn lock(&self) -> PyResult<MutexGuard<'_, (S, Spare<S::Solution>)>> {
        lock(&self.work, "solver")
    }

    /// Reads the solver, or changes it with little work.
    pub(crate) fn with<T>(&self, work: impl FnOnce(&mut S) -> T) -> PyResult<T> {
        Ok(work(&mut self.lock()?.0))
    }

    /// Changes the problem of the next solve, with work on all cells.
    pub(crate) fn change(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&mut S) -> Result<()> + Send,
    ) -> PyResult<()> {
        self.unobserved(py, change)
    }

    /// Runs long work with the solver that returns no solution.
    pub(crate) fn unobserved<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut S) -> Result<T> + Send,
    ) -> PyResult<T> {
        let mut held = self.lock()?;
        let solver = &mut held.0;
        unobserved_on(py, self.grid, || work(solver))
    }

    /// Runs long work with the solver that returns no solution, and that a signal can end.
    pub(crate) fn observed<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut S, Observer<'_>) -> Result<T> + Send,
    ) -> PyResult<T> {
        self.observed_in_stages(py, Progress::none(), work)
    }

    /// Runs long work like [`Self::observed`], which the progress callback can also end.
    pub(crate) fn observed_in_stages<T: Send, G: Stage>(
        &self,
        py: Python<'_>,
        progress: Progress<'_>,
        work: impl FnOnce(&mut S, Observer<'_, G>) -> Result<T> + Send,
    ) -> PyResult<T> {
        let mut held = self.lock()?;
        let solver = &mut held.0;
        let outcome = solve_in_stages(py, self.grid.cells(), progress, |observer| {
            work(solver, observer)
        })?;
        outcome.or_raise_on(py, self.grid)
    }

    /// Solves after the problem of the solve has been set.
    pub(crate) fn solve<'py>(
        &self,
        py: Python<'py>,
        set: impl FnOnce(&mut S) -> PyResult<()>,
        progress: Option<Bound<'py, PyAny>>,
        is_warned: bool,
    ) -> PyResult<Bound<'py, S::Object>> {
        let progress = Progress::of(progress.as_ref())?;
        let mut work = self.lock()?;
        let (solver, spare) = &mut *work;
        set(solver)?;
        let mut solution = spare.take(|| solver.new_solution());
        let into = Arc::get_mut(&mut solution);
        let into = into.ok_or_else(|| PyRuntimeError::new_err("the solution is still in use"))?;
        let outcome = solve(py, self.grid.cells(), progress, |observer| {
            solver.solve_observed(into, |iteration| observer(Some(iteration)))
        })?;
        spare.keep(&solution);
        finished::<S>(py, outcome, Some(solution), is_warned, Vec::new)
    }
}

/// Declares constructors that reject the call and state the creation from a problem.
macro_rules! created_by {
    ($($class:ident: $call:literal);+ $(;)?) => {$(
        #[pyo3::pymethods]
        impl $class {
            #[new]
            #[pyo3(signature = (*_arguments, **_options), text_signature = None)]
            fn new(
                _arguments: &pyo3::Bound<'_, pyo3::types::PyTuple>,
                _options: Option<&pyo3::Bound<'_, pyo3::types::PyDict>>,
            ) -> pyo3::PyResult<Self> {
                Err(pyo3::exceptions::PyTypeError::new_err(concat!(
                    stringify!($class), " is created from its problem, by ", $call, ".solver()"
                )))
            }
        }
    )+};
}

pub(crate) use created_by;

/// Declares a Python class for a reusable solver of the crate, with the methods that all solvers share.
macro_rules! solver {
    ($class:ident: $solution:ident) => {
        crate::solver::solver!(
            stickslip::$class as $class: stickslip::$solution as $solution, |solution| solution.warnings()
        );
    };
    ($own:ty as $class:ident: $content:ty as $solution:ident, $warnings:expr) => {
        impl crate::solver::Solver for $own {
            type Solution = $content;
            type Object = $solution;

            fn new_solution(&self) -> Self::Solution {
                self.new_solution()
            }

            fn solve_observed(
                &mut self,
                solution: &mut Self::Solution,
                observer: impl FnMut(&stickslip::Iteration) -> std::ops::ControlFlow<()> + Send,
            ) -> stickslip::Result<()> {
                self.solve_observed(solution, observer)
            }

            fn warnings(solution: &Self::Solution) -> Vec<stickslip::Warning> {
                let warnings: fn(&Self::Solution) -> Vec<stickslip::Warning> = $warnings;
                warnings(solution)
            }
        }

        #[pyo3::pymethods]
        impl $class {
            /// Discards the last solution, so that the next solve starts like the first.
            fn reset(&self) -> pyo3::PyResult<()> {
                self.0.with(|solver| solver.reset())
            }

            /// Settings of the next solve; assignable.
            #[getter]
            fn settings(&self) -> pyo3::PyResult<crate::settings::Settings> {
                self.0
                    .with(|solver| crate::settings::Settings(*solver.settings()))
            }

            #[setter]
            fn set_settings(
                &self,
                py: pyo3::Python<'_>,
                settings: crate::settings::Settings,
            ) -> pyo3::PyResult<()> {
                let outcome = self.0.with(|solver| solver.set_settings(settings.0))?;
                crate::error::OrRaise::or_raise(outcome, py)
            }

            fn __repr__(&self) -> String {
                format!(
                    "{}({})",
                    stringify!($class),
                    crate::grid::size(self.0.grid())
                )
            }
        }
    };
}

pub(crate) use solver;

/// Declares the friction of a solver of the crate that has friction.
macro_rules! frictional {
    ($class:ident) => {
        #[pyo3::pymethods]
        impl $class {
            /// The friction of the next solve, as last set, with its ``max_shear_stress``.
            #[getter]
            fn friction(&self) -> pyo3::PyResult<crate::friction::Friction> {
                self.0
                    .with(|solver| crate::friction::Friction(solver.friction().clone()))
            }

            /// Sets the friction of the next solve. A law or a coefficient replaces the last law, with its ``max_shear_stress``. A
            /// coefficient alone has none; a warning is issued if the last law had one.
            fn set_friction(
                &self,
                py: pyo3::Python<'_>,
                friction: crate::friction::AnyFriction<'_>,
            ) -> pyo3::PyResult<()> {
                let is_law = friction.is_law();
                let friction = friction.on(py, self.0.grid())?;
                let mut last = None;
                self.0.change(py, |solver| {
                    last = solver.friction().cap();
                    solver.set_friction(&friction)
                })?;
                crate::friction::warn_of_lost_cap(py, last, is_law)
            }
        }
    };
}

pub(crate) use frictional;
