//! Steps short enough for a tolerance.

use std::sync::Mutex;

use pyo3::prelude::*;

use crate::digits::short;
use crate::error::OrRaise;
use crate::history::{Cycle, History, builder};
use crate::load::LoadStep;
use crate::pickle::picklable;
use crate::progress::Progress;
use crate::real::Real;
use crate::report;
use crate::sequence::pair;
use crate::solution_pool::lock;
use crate::work::{solve, unless_broken_off, unobserved};

/// What one step differs by from the same load in two.
#[pyclass(frozen, eq, module = "stickslip.history")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct StepErrorEstimate(stickslip::history::StepErrorEstimate);

#[pymethods]
impl StepErrorEstimate {
    /// Sum of the lengths of the differences of the tractions, over the sum of the friction limits.
    #[getter]
    fn traction(&self) -> f64 {
        self.0.traction
    }

    /// Difference of the tangential force.
    #[getter]
    fn force(&self) -> (f64, f64) {
        pair(self.0.force)
    }

    /// Difference of the shift (lengths).
    #[getter]
    fn shift(&self) -> (f64, f64) {
        pair(self.0.shift)
    }

    /// Difference of the energy dissipated.
    #[getter]
    fn dissipated_energy(&self) -> f64 {
        self.0.dissipated_energy
    }

    fn __repr__(&self) -> String {
        format!(
            "StepErrorEstimate(traction={}, dissipated_energy={})",
            short(self.0.traction),
            short(self.0.dissipated_energy)
        )
    }
}

picklable!(StepErrorEstimate: stickslip::history::StepErrorEstimate);

/// Takes a load in steps short enough for a tolerance, and tells the error of a step. Its buffers take the memory of four
/// states.
///
/// Parameters
/// ----------
/// history : History
///     For histories on the grid of this one.
/// tolerance : float
///     Of :attr:`StepErrorEstimate.traction` for a whole load, in (0, 1); at least about a hundred times the tolerance of the history's
///     settings.
///
/// Raises
/// ------
/// Tolerance
#[pyclass(frozen, module = "stickslip.history")]
pub(crate) struct AdaptiveSteps(Mutex<stickslip::history::AdaptiveSteps>);

const NAME: &str = "object that takes adaptive steps";

#[pymethods]
impl AdaptiveSteps {
    #[new]
    fn new(py: Python<'_>, history: &History, tolerance: Real) -> PyResult<Self> {
        let steps =
            history.read(|history| stickslip::history::AdaptiveSteps::new(history, tolerance.0))?;
        steps.or_raise(py).map(|steps| Self(Mutex::new(steps)))
    }

    /// The error that a single step makes with this load; the history is then as it was, but for its last step.
    fn error(
        &self,
        py: Python<'_>,
        history: &History,
        load: LoadStep,
    ) -> PyResult<StepErrorEstimate> {
        let (mut steps, mut work) = (lock(&self.0, NAME)?, lock(&history.work, builder::NAME)?);
        let (steps, work) = (&mut *steps, &mut *work);
        unobserved(py, history.cells(), || {
            work.tried(|history| steps.error(history, &load.0))
        })
        .map(StepErrorEstimate)
    }

    /// Takes a load, in as many steps as it needs, and returns how many. Ctrl-C ends it after the part under way; the
    /// history is then as it was, but for its last step.
    ///
    /// Parameters
    /// ----------
    /// history : History
    ///     The history that takes the load.
    /// load : LoadStep
    ///     What is prescribed at its end, reached in proportion.
    /// cycle : Cycle, optional
    ///     To which each step is added.
    /// warn : bool, default True
    ///     Whether the remarks on the last step go to ``warnings`` too, each kind once a place.
    ///
    /// Raises
    /// ------
    /// GridMismatch, StepTooLong
    ///     And what :meth:`History.step` raises.
    #[pyo3(signature = (history, load, *, cycle=None, warn=true))]
    fn step(
        &self,
        py: Python<'_>,
        history: &History,
        load: LoadStep,
        cycle: Option<&Cycle>,
        warn: bool,
    ) -> PyResult<usize> {
        let (mut steps, mut work) = (lock(&self.0, NAME)?, lock(&history.work, builder::NAME)?);
        let mut cycle = cycle.map(Cycle::lock).transpose()?;
        let (steps, work) = (&mut *steps, &mut *work);
        let mut cycle = cycle.as_deref_mut();
        let outcome = solve(py, history.cells(), Progress::none(), |observer| {
            let seen = |history: &_| {
                if let Some(cycle) = &mut cycle {
                    cycle.add(history)?;
                }
                unless_broken_off(observer)
            };
            work.tried(|history| steps.step_observed(history, &load.0, seen))
        })?;
        let count = outcome.or_raise(py)?;
        report::warn(py, warn, || work.history.last_step().warnings())?;
        Ok(count)
    }

    fn __repr__(&self) -> String {
        "AdaptiveSteps()".into()
    }
}
