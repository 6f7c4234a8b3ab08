//! States of histories as snapshots, bytes, files and pickles.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyType};

use crate::argument::Object;
use crate::content::Content;
use crate::error::OrRaise;
use crate::half_space::HalfSpace;
use crate::history::builder::NAME;
use crate::history::{History, State};
use crate::pickle::{Standalone, by_itself};
use crate::solution_pool::lock;
use crate::unit::of_state;
use crate::work::unobserved_on;

/// Class, bodies and bytes of a history.
type Saved<'py> = (Bound<'py, PyType>, HalfSpace, Bound<'py, PyBytes>);

#[pymethods]
impl History {
    /// Returns a snapshot of the state.
    fn state(&self) -> PyResult<State> {
        let work = lock(&self.work, NAME)?;
        Ok(State(
            Arc::new(work.history.state().clone()),
            work.unit.clone(),
        ))
    }

    /// Restores a state of this history or of a history on equal bodies. Gap, friction, hardness, permanent set, settings
    /// and model (scalar, vector or coupled) of the state replace those of the history. Changes made after the state was taken, as
    /// by :meth:`set_friction` or :meth:`set_gap`, are therefore lost. Make them again after this call.
    ///
    /// The history then has no :attr:`last_step` until its next step. Until then, :meth:`Cycle.add` raises ``NoLastStep``. In a
    /// retry, restore the state, take a smaller step, and add this step to the cycle. A rejected step that was added stays in
    /// the cycle: add a step only after it is accepted.
    ///
    /// Raises
    /// ------
    /// MaterialMismatch, GridMismatch, BoundaryMismatch
    /// ValueError
    ///     If the unit of the state differs from :attr:`unit`.
    fn set_state(&self, py: Python<'_>, state: Object<State>) -> PyResult<()> {
        let mut work = lock(&self.work, NAME)?;
        let unit = of_state(work.unit.as_ref(), state.1.as_ref())?;
        let history = &mut work.history;
        unobserved_on(py, self.grid(), || history.set_state(&state.0))?;
        work.unit = unit;
        Ok(())
    }

    /// Creates a history that continues from a state, on the bodies of that state.
    #[staticmethod]
    fn from_state(
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        state: Object<State>,
    ) -> PyResult<Self> {
        let history = unobserved_on(py, bodies.0.grid(), || {
            stickslip::History::from_state(&bodies.0, (*state.0).clone())
        })?;
        Ok(Self::of(history, &bodies, state.1.clone()))
    }

    /// Returns the state as bytes, with all data that the next step needs except the bodies.
    fn to_bytes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = self.read(stickslip::History::to_bytes)?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Restores a history from its bytes, on the same bodies. Continued steps give bitwise identical results on processors with
    /// the same vector instructions.
    #[staticmethod]
    fn from_bytes(py: Python<'_>, bodies: Object<HalfSpace>, bytes: Content<'_>) -> PyResult<Self> {
        let bytes: &[u8] = &bytes;
        let history = unobserved_on(py, bodies.0.grid(), || {
            stickslip::History::from_bytes(&bodies.0, bytes)
        })?;
        Ok(Self::of(history, &bodies, None))
    }

    /// Saves the state to a file. An existing file is replaced completely or not at all.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        self.read(|history| history.save(&path))?.or_raise(py)
    }

    /// Loads a history from a file written by :meth:`save`, on the same bodies.
    #[staticmethod]
    #[pyo3(signature = (bodies, path=None), text_signature = "(bodies, path)")]
    fn load(py: Python<'_>, bodies: Object<HalfSpace>, path: Option<PathBuf>) -> PyResult<Self> {
        let path = path.ok_or_else(|| {
            PyTypeError::new_err("give the path after the bodies: History.load(bodies, path)")
        })?;
        let history = unobserved_on(py, bodies.0.grid(), || {
            stickslip::History::load(&bodies.0, &path)
        })?;
        Ok(Self::of(history, &bodies, None))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Standalone<'py, Saved<'py>>> {
        let (py, own) = (slf.py(), slf.get());
        by_itself(py, (slf.get_type(), own.bodies(), own.to_bytes(py)?))
    }
}
