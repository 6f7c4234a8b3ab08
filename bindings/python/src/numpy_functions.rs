//! NumPy functions of fields and surfaces.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyTuple};

use crate::conversion::entries;
use crate::error::OrRaise;
use crate::field::{Field, same_grid};
use crate::real::{in_axes, unnamed};
use crate::unit::{Unit, one_of};

/// NumPy functions that accept operands of different units: products, quotients, powers and logic, as in the arithmetic of
/// fields.
const IGNORE_UNITS: [&str; 21] = [
    "multiply",
    "divide",
    "true_divide",
    "matmul",
    "power",
    "float_power",
    "logical_and",
    "logical_or",
    "logical_xor",
    "dot",
    "vdot",
    "inner",
    "outer",
    "tensordot",
    "einsum",
    "kron",
    "cross",
    "convolve",
    "correlate",
    "cov",
    "corrcoef",
];

/// Returns the result of a NumPy function of the samples. Without arguments, it is the result of the crate, if there is one.
pub(crate) fn reduced_by<'py>(
    field: &Bound<'py, Field>,
    function: &str,
    plain: Option<fn(&stickslip::Field) -> f64>,
    arguments: &Bound<'py, PyTuple>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = field.py();
    let is_none = |(_, value): (_, Bound<'py, PyAny>)| value.is_none();
    let is_plain =
        arguments.is_empty() && options.is_none_or(|options| options.iter().all(is_none));
    if let Some(plain) = plain.filter(|_| is_plain) {
        return Ok(PyFloat::new(py, plain(&field.get().0)).into_any());
    }
    let samples = std::iter::once(Field::array(field).0);
    let all: Vec<_> = samples.chain(arguments.iter()).collect();
    let function = py.import("numpy")?.getattr(function)?;
    function.call(PyTuple::new(py, all)?, options)
}

/// Returns a field, or the heights of a surface.
fn field_of(object: &Bound<'_, PyAny>) -> Option<Field> {
    let heights = object.getattr("heights").ok();
    let field = heights.as_ref().unwrap_or(object).cast::<Field>();
    field.ok().map(|field| field.get().clone())
}

/// Returns an error if fields or surfaces, which a NumPy function combines cell by cell, are on different grids.
fn on_one_grid(py: Python<'_>, operands: &[Bound<'_, PyAny>]) -> PyResult<()> {
    let mut grids = operands
        .iter()
        .filter_map(field_of)
        .map(|field| field.0.grid());
    let Some(first) = grids.next() else {
        return Ok(());
    };
    grids.try_for_each(|grid| same_grid(first, grid, "operand").or_raise(py))
}

/// Applies a NumPy function with a field among its operands. Fields of different units are rejected, as in arithmetic.
pub(crate) fn apply_to_fields<'py>(
    field: &Bound<'py, Field>,
    ufunc: &Bound<'py, PyAny>,
    method: &str,
    inputs: Vec<Bound<'py, PyAny>>,
    kwargs: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let output = kwargs.and_then(|kwargs| kwargs.get_item("out").ok().flatten());
    let outputs = output.map(|output| output.try_iter()?.collect::<PyResult<Vec<_>>>());
    let is_changed = |place: &Bound<'py, PyAny>| place.cast::<Field>().is_ok();
    let is_output = outputs
        .transpose()?
        .is_some_and(|all| all.iter().any(is_changed));
    if is_output || method == "at" && inputs.first().is_some_and(is_changed) {
        return Err(unnamed(
            field.py(),
            "ArgumentType",
            "a Field does not change: give numpy.array(field), a copy, as the output",
        ));
    }
    let name: String = ufunc.getattr("__name__")?.extract()?;
    if let ("__call__", [left, right], None) = (method, &inputs[..], kwargs) {
        let reflected = match &name[..] {
            "add" => Some("__radd__"),
            "subtract" => Some("__rsub__"),
            "multiply" => Some("__rmul__"),
            "divide" | "true_divide" => Some("__rtruediv__"),
            "power" => Some("__rpow__"),
            _ => None,
        };
        if let Some(reflected) = reflected.filter(|_| right.is(field)) {
            return field.call_method1(reflected, (left,));
        }
    }
    if method == "__call__" {
        on_one_grid(field.py(), &inputs)?;
    }
    if !IGNORE_UNITS.contains(&&name[..]) {
        one_of(
            inputs
                .iter()
                .map(|input| field_of(input).and_then(|field| field.1)),
        )?;
    }
    let grid = field.get().0.grid();
    let arrays = inputs.into_iter().map(|input| match input.cast::<Field>() {
        Ok(field) => Ok(Field::array(field).0),
        Err(_) => in_axes(&input, "operand", Some([grid.dx(), grid.dy()])),
    });
    let arrays = PyTuple::new(field.py(), arrays.collect::<PyResult<Vec<_>>>()?)?;
    ufunc.getattr(method)?.call(arrays, kwargs)
}

/// Applies a NumPy function to operands of which some have heights. Each is replaced by its heights, a field with a unit.
pub(crate) fn apply_to_heights<'py>(
    ufunc: &Bound<'py, PyAny>,
    method: &str,
    inputs: Vec<Bound<'py, PyAny>>,
    kwargs: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let fields = inputs
        .into_iter()
        .map(|input| match input.getattr("heights") {
            Ok(heights) if heights.is_instance_of::<Field>() => heights,
            _ => input,
        });
    let fields = PyTuple::new(ufunc.py(), fields.collect::<Vec<_>>())?;
    ufunc.getattr(method)?.call(fields, kwargs)
}

/// Calls a NumPy function with the arrays of all fields and surfaces among its arguments, also in tuples and lists. Surfaces of
/// different units are rejected.
pub(crate) fn apply_to_arrays<'py>(
    function: &Bound<'py, PyAny>,
    arguments: &Bound<'py, PyAny>,
    options: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyAny>> {
    let name: String = function.getattr("__name__")?.extract()?;
    if name == "where" {
        on_one_grid(function.py(), &arguments.extract::<Vec<_>>()?)?;
    }
    let mut units = Vec::new();
    let arguments = as_arrays(arguments, &mut units)?;
    let plain = PyDict::new(function.py());
    for (name, value) in options {
        plain.set_item(name, as_arrays(&value, &mut units)?)?;
    }
    if !IGNORE_UNITS.contains(&&name[..]) {
        one_of(units)?;
    }
    function.call(arguments.cast::<PyTuple>()?, Some(&plain))
}

/// Replaces fields and surfaces by their arrays, and collects their units. The axes of arrays of xarray are recognised by name.
fn as_arrays<'py>(
    value: &Bound<'py, PyAny>,
    units: &mut Vec<Option<Unit>>,
) -> PyResult<Bound<'py, PyAny>> {
    let heights = value.getattr("heights").ok();
    if let Ok(field) = heights.as_ref().unwrap_or(value).cast::<Field>() {
        units.push(field.get().1.clone());
        return Ok(Field::array(field).0);
    }
    let Some(parts) = entries(value) else {
        return in_axes(value, "operand", None);
    };
    let parts: PyResult<Vec<_>> = parts.iter().map(|part| as_arrays(&part, units)).collect();
    let parts = PyTuple::new(value.py(), parts?)?;
    Ok(if value.is_instance_of::<PyTuple>() {
        parts.into_any()
    } else {
        parts.to_list().into_any()
    })
}

/// Returns an array in the form that NumPy requests by the method ``__array__``.
pub(crate) fn as_numpy<'py>(
    array: Bound<'py, PyAny>,
    dtype: Option<Bound<'py, PyAny>>,
    copy: Option<bool>,
) -> PyResult<Bound<'py, PyAny>> {
    if dtype.is_none() && copy != Some(true) {
        return Ok(array);
    }
    let options = PyDict::new(array.py());
    options.set_item("copy", copy.unwrap_or(false))?;
    let dtype = match dtype {
        Some(dtype) => dtype,
        None => array.getattr("dtype")?,
    };
    array.call_method("astype", (dtype,), Some(&options))
}
