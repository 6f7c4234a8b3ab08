//! States of histories: snapshots, bytes, files and pickles.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyType};

use crate::error::OrRaise;
use crate::half_space::HalfSpace;
use crate::history::{History, State};
use crate::pickle::{Standalone, by_itself};
use crate::work::unobserved_on;

/// The class, the bodies and the bytes of a history.
type Saved<'py> = (Bound<'py, PyType>, HalfSpace, Bound<'py, PyBytes>);

#[pymethods]
impl History {
    /// A snapshot of the state.
    fn state(&self) -> PyResult<State> {
        self.read(|history| State(Arc::new(history.state().clone())))
    }

    /// Returns to a state, of this history or of another on equal bodies.
    fn set_state(&self, py: Python<'_>, state: &State) -> PyResult<()> {
        self.change(py, |history| history.set_state(&state.0))
    }

    /// A history that continues from a state, on the bodies it belongs to.
    #[staticmethod]
    fn from_state(py: Python<'_>, bodies: &HalfSpace, state: &State) -> PyResult<Self> {
        let history = unobserved_on(py, bodies.0.grid(), || {
            stickslip::History::from_state(&bodies.0, (*state.0).clone())
        })?;
        Ok(Self::of(history, bodies))
    }

    /// Its bytes: all that the next step needs but the bodies.
    fn to_bytes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = self.read(stickslip::History::to_bytes)?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// A history from its bytes, on the bodies it had; it continues to the same bits.
    #[staticmethod]
    fn from_bytes(py: Python<'_>, bodies: &HalfSpace, bytes: &[u8]) -> PyResult<Self> {
        let history = unobserved_on(py, bodies.0.grid(), || {
            stickslip::History::from_bytes(&bodies.0, bytes)
        })?;
        Ok(Self::of(history, bodies))
    }

    /// Saves the state in a file, which is replaced as a whole or not at all.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        self.read(|history| history.save(&path))?.or_raise(py)
    }

    /// A history from a file of :meth:`save`, on the bodies it had.
    #[staticmethod]
    fn load(py: Python<'_>, bodies: &HalfSpace, path: PathBuf) -> PyResult<Self> {
        let history = unobserved_on(py, bodies.0.grid(), || {
            stickslip::History::load(&bodies.0, &path)
        })?;
        Ok(Self::of(history, bodies))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Standalone<'py, Saved<'py>>> {
        let (py, own) = (slf.py(), slf.get());
        by_itself(py, (slf.get_type(), own.bodies(), own.to_bytes(py)?))
    }
}
