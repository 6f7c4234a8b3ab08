//! Progress reports of solves.

use pyo3::call::PyCallArgs;
use pyo3::prelude::*;
use pyo3::types::PyBool;

use crate::conversion::kind_of;
use crate::real::wrong_type;

/// The argument ``progress``: nothing, a callable, or ``True`` for a progress bar of tqdm.
pub(crate) struct Progress<'py> {
    callback: Option<Py<PyAny>>,
    /// The progress bar, which must be closed at the end.
    bar: Option<Bound<'py, PyAny>>,
}

impl<'py> Progress<'py> {
    pub(crate) fn none() -> Self {
        Self {
            callback: None,
            bar: None,
        }
    }

    pub(crate) fn of(argument: Option<&Bound<'py, PyAny>>) -> PyResult<Self> {
        Self::with_bar(argument, "Bar", ())
    }

    /// Returns the progress of a solve on several grids.
    pub(crate) fn of_grids(argument: Option<&Bound<'py, PyAny>>) -> PyResult<Self> {
        Self::with_bar(argument, "GridBar", ())
    }

    /// Returns the progress of solves at `count` points.
    pub(crate) fn of_points(argument: Option<&Bound<'py, PyAny>>, count: usize) -> PyResult<Self> {
        Self::with_bar(argument, "PointBar", (count,))
    }

    fn with_bar(
        argument: Option<&Bound<'py, PyAny>>,
        class: &str,
        arguments: impl PyCallArgs<'py>,
    ) -> PyResult<Self> {
        let Some(argument) = argument else {
            return Ok(Self::none());
        };
        let Ok(is_wanted) = argument.cast::<PyBool>() else {
            if !argument.is_callable() {
                let message = format!("must be a callable or a bool, got {}", kind_of(argument));
                return Err(wrong_type(argument.py(), "progress", &message));
            }
            return Ok(Self {
                callback: Some(argument.clone().unbind()),
                bar: None,
            });
        };
        if !is_wanted.is_true() {
            return Ok(Self::none());
        }
        let module = argument.py().import("stickslip._progress")?;
        let bar = module.getattr(class)?.call1(arguments)?;
        Ok(Self {
            callback: Some(bar.clone().unbind()),
            bar: Some(bar),
        })
    }

    pub(crate) fn callback(&self) -> Option<&Py<PyAny>> {
        self.callback.as_ref()
    }

    pub(crate) fn close(&self) -> PyResult<()> {
        self.bar
            .as_ref()
            .map_or(Ok(()), |bar| bar.call_method0("close").map(|_| ()))
    }
}
