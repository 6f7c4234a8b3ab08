//! Gaps of adaptive contacts: Python functions of the position, and samples.

use std::ops::ControlFlow;
use std::sync::{Arc, Mutex, PoisonError};

use numpy::{PyArray1, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
#[cfg(feature = "stubs")]
use pyo3::{PyTypeInfo, inspect::PyStaticExpr, type_hint_identifier, type_hint_union};
use stickslip::adaptive::{GapFunction, GridRecord, SampledGap};
use stickslip::surface::Interpolation;
use stickslip::{Error, Result};

use crate::choice::Choice;
use crate::conversion::kind_of;
use crate::digits::as_python;
use crate::error::{OrRaise, named};
use crate::field::Field;
use crate::function::raise;
use crate::real::{filled, is_real};
use crate::unit::Unit;
use crate::work::Observer;

/// Largest number of positions in a call of a Python function, which bounds the memory of its arrays.
const MOST_POSITIONS: usize = 1 << 16;

/// Gap as an argument: a Python function or samples.
pub(super) enum GapArgument<'py> {
    Function(Bound<'py, PyAny>),
    Samples(Field),
}

impl<'py> FromPyObject<'_, 'py> for GapArgument<'py> {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        type_hint_identifier!("collections.abc", "Callable"),
        Field::TYPE_HINT
    );

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(field) = object.cast::<Field>() {
            return Ok(Self::Samples(field.get().clone()));
        }
        if object.is_callable() {
            return Ok(Self::Function(object.to_owned()));
        }
        Err(PyTypeError::new_err(format!(
            "gap must be a function gap(x, y) or a Field, got {}: create a Field from an array by Field(grid, array)",
            kind_of(&object)
        )))
    }
}

impl GapArgument<'_> {
    /// Returns the unit of the lengths of samples, if they state one.
    pub(super) fn unit(&self) -> Option<Unit> {
        match self {
            Self::Function(_) => None,
            Self::Samples(field) => field.1.clone(),
        }
    }
}

/// Gap of a problem.
pub(super) enum Gap {
    Function(Py<PyAny>),
    Samples(SampledGap),
}

impl Gap {
    pub(super) fn new(
        py: Python<'_>,
        argument: &GapArgument<'_>,
        interpolation: Option<Choice<Interpolation>>,
    ) -> PyResult<Self> {
        match argument {
            GapArgument::Function(_) if interpolation.is_some() => Err(PyTypeError::new_err(
                "interpolation applies to a gap that is a Field, got a function",
            )),
            GapArgument::Function(function) => Ok(Self::Function(function.clone().unbind())),
            GapArgument::Samples(field) => {
                let samples = Arc::unwrap_or_clone(Arc::clone(&field.0));
                let grid = samples.grid();
                let interpolation = interpolation.map(|chosen| chosen.0).unwrap_or_default();
                let gap = SampledGap::new(samples, interpolation).or_raise_on(py, grid)?;
                Ok(Self::Samples(gap))
            }
        }
    }
}

/// Observer of a solve that is called between grids, and between calls of a Python function.
pub(super) struct SharedObserver<'a>(Mutex<Observer<'a, GridRecord>>);

impl<'a> SharedObserver<'a> {
    pub(super) fn new(observer: Observer<'a, GridRecord>) -> Self {
        Self(Mutex::new(observer))
    }

    pub(super) fn call(&self, record: Option<&GridRecord>) -> ControlFlow<()> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)(record)
    }
}

/// Gap during a solve, which an interrupt ends.
pub(super) struct ObservedGap<'a, 'b> {
    pub(super) gap: &'a Gap,
    pub(super) observer: &'a SharedObserver<'b>,
}

impl GapFunction for ObservedGap<'_, '_> {
    fn evaluate(&self, positions: &[[f64; 2]], gaps: &mut [f64]) -> Result<()> {
        let function = match self.gap {
            Gap::Samples(samples) => return samples.evaluate(positions, gaps),
            Gap::Function(function) => function,
        };
        let parts = positions.chunks(MOST_POSITIONS);
        for (positions, gaps) in parts.zip(gaps.chunks_mut(MOST_POSITIONS)) {
            Python::attach(|py| {
                let function = function.bind(py);
                if let Err(exception) = evaluate(function, positions, gaps) {
                    raise(py, exception, function);
                }
            });
            if self.observer.call(None).is_break() {
                // The error only ends the solve; the exception of the function or the interrupt is raised instead.
                return Err(Error::EmptyPath);
            }
        }
        Ok(())
    }

    fn sample_spacing(&self) -> Option<[f64; 2]> {
        match self.gap {
            Gap::Samples(samples) => samples.sample_spacing(),
            Gap::Function(_) => None,
        }
    }
}

/// Evaluates a Python function at the given positions.
fn evaluate(function: &Bound<'_, PyAny>, positions: &[[f64; 2]], gaps: &mut [f64]) -> PyResult<()> {
    let py = function.py();
    let along =
        |axis: usize| PyArray1::from_iter(py, positions.iter().map(|position| position[axis]));
    let found = function.call1((along(0), along(1)))?;
    is_real(&found, "gap(x, y)")?;
    let array = py
        .import("numpy")?
        .call_method1("asarray", (filled(&found)?, "float64"))?;
    let array: PyReadonlyArrayDyn<'_, f64> = array.extract()?;
    if array.shape() != [positions.len()] {
        let shape = array.getattr("shape")?;
        return Err(PyValueError::new_err(format!(
            "gap(x, y) must return an array of the shape of x and y, ({},), got shape {shape}",
            positions.len()
        )));
    }
    for (gap, value) in gaps.iter_mut().zip(array.as_array()) {
        *gap = *value;
    }
    match gaps.iter().position(|gap| !gap.is_finite()) {
        None => Ok(()),
        Some(index) => Err(infinite(py, index, positions[index], gaps[index])?),
    }
}

/// Creates the exception for a gap that is not finite.
fn infinite(py: Python<'_>, index: usize, [x, y]: [f64; 2], gap: f64) -> PyResult<PyErr> {
    let rule = "must be finite at every position of the region";
    let [gap_text, x, y] = [gap, x, y].map(|number| as_python(py, number));
    let message = format!(
        "gap(x, y) is {} at x = {}, y = {}, but {rule}",
        gap_text?, x?, y?
    );
    let attributes = PyDict::new(py);
    attributes.set_item("quantity", "gap")?;
    attributes.set_item("index", index)?;
    attributes.set_item("row", py.None())?;
    attributes.set_item("column", py.None())?;
    attributes.set_item("value", gap)?;
    attributes.set_item("rule", rule)?;
    named(py, "Sample", &message, &attributes)
}
