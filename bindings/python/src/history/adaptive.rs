//! Steps short enough for a given tolerance.

use std::sync::Mutex;

use pyo3::prelude::*;

use crate::argument::Object;
use crate::digits::short;
use crate::error::OrRaise;
use crate::history::{Cycle, History, builder};
use crate::load::StepArgument;
use crate::pickle::picklable;
use crate::progress::Progress;
use crate::readers::readers;
use crate::real::Real;
use crate::report;
use crate::sequence::pair;
use crate::solution_pool::lock;
use crate::work::{solve, unless_broken_off, unobserved};

/// Difference between the result of one step and the result of the same load in two steps.
#[pyclass(frozen, eq, module = "stickslip.history")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct StepErrorEstimate(stickslip::history::StepErrorEstimate);

readers! { StepErrorEstimate.0:
    /// Sum of the magnitudes of the traction differences, relative to the sum of the friction limits.
    traction: f64,
    /// Difference of the tangential force.
    force: (f64, f64) => pair,
    /// Difference of the shift (lengths).
    shift: (f64, f64) => pair,
    /// Difference of the dissipated energy.
    dissipated_energy: f64,
}

#[pymethods]
impl StepErrorEstimate {
    fn __repr__(&self) -> String {
        format!(
            "StepErrorEstimate(traction={}, dissipated_energy={})",
            short(self.0.traction),
            short(self.0.dissipated_energy)
        )
    }
}

picklable!(StepErrorEstimate: stickslip::history::StepErrorEstimate);

/// Applies a load in steps short enough for a given tolerance, and estimates the error of a step. The buffers of this
/// object require the memory of four states.
///
/// Parameters
/// ----------
/// history : History
///     A history on the grid of the histories to be stepped.
/// tolerance : float
///     Tolerance of :attr:`StepErrorEstimate.traction` for a whole load, in (0, 1). It must be at least about a hundred
///     times the tolerance of the history's settings.
///
/// Raises
/// ------
/// Tolerance
#[pyclass(frozen, module = "stickslip.history")]
pub(crate) struct AdaptiveSteps(Mutex<stickslip::history::AdaptiveSteps>);

const NAME: &str = "object for adaptive steps";

#[pymethods]
impl AdaptiveSteps {
    #[new]
    fn new(py: Python<'_>, history: Object<History>, tolerance: Real) -> PyResult<Self> {
        let steps =
            history.read(|history| stickslip::history::AdaptiveSteps::new(history, tolerance.0))?;
        steps.or_raise(py).map(|steps| Self(Mutex::new(steps)))
    }

    /// Returns the error of a single step with this load. The state of the history is unchanged afterwards. The history then
    /// has no last step until its next step.
    fn error(
        &self,
        py: Python<'_>,
        history: Object<History>,
        load: StepArgument,
    ) -> PyResult<StepErrorEstimate> {
        let (mut steps, mut work) = (lock(&self.0, NAME)?, lock(&history.work, builder::NAME)?);
        let (steps, work) = (&mut *steps, &mut *work);
        unobserved(py, history.cells(), || {
            work.tried(|history| steps.error(history, &load.0.0))
        })
        .map(StepErrorEstimate)
    }

    /// Applies a load in as many steps as the tolerance requires, and returns the number of steps. Ctrl-C takes effect
    /// after the current part. The state of the history is then unchanged, but it has no last step until its next step.
    ///
    /// The last step of the history is the last of these steps, with its slip and energy alone. For wear, give ``cycle``, or take the
    /// increase of :attr:`History.accumulated_dissipation`.
    ///
    /// Parameters
    /// ----------
    /// history : History
    ///     The history to which the load is applied.
    /// load : LoadStep
    ///     The load at the end of the last step. All prescribed quantities change proportionally from their previous
    ///     values.
    /// cycle : Cycle, optional
    ///     A cycle to which each step is added.
    /// warn : bool, default True
    ///     Whether the warnings of the last step are also issued through ``warnings``, each kind once per location.
    ///
    /// Raises
    /// ------
    /// GridMismatch, StepTooLong
    ///     In addition to the exceptions of :meth:`History.step`.
    #[pyo3(signature = (history, load, *, cycle=None, warn=true))]
    fn step(
        &self,
        py: Python<'_>,
        history: Object<History>,
        load: StepArgument,
        cycle: Option<Object<Cycle>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<usize> {
        let (mut steps, mut work) = (lock(&self.0, NAME)?, lock(&history.work, builder::NAME)?);
        let mut cycle = cycle.as_deref().map(Cycle::lock).transpose()?;
        let (steps, work) = (&mut *steps, &mut *work);
        let mut cycle = cycle.as_deref_mut();
        let outcome = solve(py, history.cells(), Progress::none(), |observer| {
            let seen = |history: &_| {
                if let Some(cycle) = &mut cycle {
                    cycle.add(history)?;
                }
                unless_broken_off(observer)
            };
            work.tried(|history| steps.step_observed(history, &load.0.0, seen))
        })?;
        let count = outcome.or_raise(py)?;
        let step = work.history.last_step().or_raise(py)?;
        report::warn(py, warn, || step.warnings())?;
        Ok(count)
    }

    fn __repr__(&self) -> String {
        "AdaptiveSteps()".into()
    }
}
