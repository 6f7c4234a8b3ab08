//! Real numbers and arrays of real numbers. Objects that NumPy would convert with a loss or by a guess are rejected, and
//! so are arrays of the wrong shape.

use numpy::{AllowTypeChange, PyArrayLike2};
use pyo3::exceptions::{PyOverflowError, PyTypeError};
#[cfg(feature = "stubs")]
use pyo3::inspect::PyStaticExpr;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyFloat, PyInt, PyString, PyTuple};

use crate::conversion::{kind_of, missing_value};
use crate::error::named;
use crate::field::Field;
use crate::friction::Friction;
use crate::half_space::HalfSpace;
use crate::history::History;
use crate::normal::NormalSolution;

/// Returns an object as a NumPy array, if it can be converted.
fn as_array<'py>(object: &Bound<'py, PyAny>) -> Option<Bound<'py, PyAny>> {
    let numpy = object.py().import("numpy").ok()?;
    numpy.call_method1("asanyarray", (object,)).ok()
}

/// Returns the kind of entries of an object that are not real numbers: complex numbers, text, times or a missing value.
fn unreal(object: &Bound<'_, PyAny>) -> PyResult<Option<&'static str>> {
    if let Some(missing) = missing_value(object) {
        return Ok(Some(missing));
    }
    let Some(array) = as_array(object) else {
        return Ok(None);
    };
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    Ok(match &kind[..] {
        "O" if has_text(&array)? => Some("text"),
        "c" => Some("complex: give the real part, .real"),
        "U" | "S" | "T" => Some("text"),
        "M" | "m" => Some("times"),
        _ => None,
    })
}

/// Returns whether an array of objects contains text, which NumPy would convert to numbers if it can.
fn has_text(array: &Bound<'_, PyAny>) -> PyResult<bool> {
    for entry in array.getattr("flat")?.try_iter()? {
        let entry = entry?;
        if entry.is_instance_of::<PyString>() || entry.is_instance_of::<PyBytes>() {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Reads a truth value of Python or NumPy as an argument.
pub(crate) fn flag(object: &Bound<'_, PyAny>) -> PyResult<bool> {
    object.extract().map_err(|_: PyErr| {
        let is_short = object.is_none()
            || object.is_instance_of::<PyString>()
            || object.is_instance_of::<PyInt>();
        let shown = object.repr().ok().filter(|_| is_short);
        let found = shown.map_or_else(|| kind_of(object), |text| text.to_string());
        let message = format!("must be True or False, got {found}");
        unnamed(object.py(), "ArgumentType", &message)
    })
}

/// Returns the number of dimensions of an array of truth values; a single truth value of Python or NumPy has none. Returns `None`
/// for other objects.
fn dimensions_of_truth(object: &Bound<'_, PyAny>) -> PyResult<Option<usize>> {
    let Some(array) = as_array(object) else {
        return Ok(None);
    };
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    if kind == "b" {
        array.getattr("ndim")?.extract().map(Some)
    } else {
        Ok(None)
    }
}

/// Returns `Ok` unless an object is a truth value or an array of truth values, such as a mask of cells. NumPy would convert them
/// to 0 and 1.
pub(crate) fn is_no_mask(object: &Bound<'_, PyAny>, quantity: &str) -> PyResult<()> {
    match dimensions_of_truth(object)? {
        None => Ok(()),
        Some(0) => Err(PyTypeError::new_err(format!(
            "{quantity} must be a real number, got a truth value"
        ))),
        Some(_) => Err(PyTypeError::new_err(format!(
            "{quantity} must be real numbers, got truth values: convert a mask by mask.astype(float)"
        ))),
    }
}

/// Returns `Ok` unless an object is a single truth value.
pub(crate) fn is_no_truth_value(object: &Bound<'_, PyAny>, quantity: &str) -> PyResult<()> {
    match dimensions_of_truth(object)? {
        Some(0) => is_no_mask(object, quantity),
        _ => Ok(()),
    }
}

/// Returns whether an object is an array of numbers of half precision.
fn is_half_precision(object: &Bound<'_, PyAny>) -> PyResult<bool> {
    let Some(array) = as_array(object) else {
        return Ok(false);
    };
    let dtype = array.getattr("dtype")?;
    let (kind, size): (String, usize) = (
        dtype.getattr("kind")?.extract()?,
        dtype.getattr("itemsize")?.extract()?,
    );
    let dimensions: usize = array.getattr("ndim")?.extract()?;
    Ok(kind == "f" && size == 2 && dimensions > 0)
}

/// Returns `Ok` unless an object contains complex numbers, text or times, or has numbers of half precision.
pub(crate) fn is_real(object: &Bound<'_, PyAny>, quantity: &str) -> PyResult<()> {
    if is_half_precision(object)? {
        return Err(PyTypeError::new_err(format!(
            "the type float16 of {quantity} has three digits: give array.astype(float) if this is intended"
        )));
    }
    match unreal(object)? {
        None => Ok(()),
        Some(found) => Err(PyTypeError::new_err(format!(
            "{quantity} must be real numbers, got {found}"
        ))),
    }
}

/// Real number as an argument. Without this class, Python would silently take the real part of a complex number of NumPy.
#[derive(Clone, Copy)]
pub(crate) struct Real(pub(crate) f64);

impl From<Real> for f64 {
    fn from(number: Real) -> Self {
        number.0
    }
}

impl FromPyObject<'_, '_> for Real {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = <f64 as FromPyObject<'_, '_>>::INPUT_TYPE;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        let found = if object.is_instance_of::<PyFloat>() {
            None
        } else if dimensions_of_truth(&object)? == Some(0) {
            Some("a truth value")
        } else {
            unreal(&object)?
        };
        match found {
            None => {
                let number: PyResult<f64> = object.extract();
                number.map(Self).map_err(|error| {
                    refused(
                        &object,
                        error,
                        "a real number",
                        "is too large for a real number",
                    )
                })
            }
            Some(found) => Err(unnamed(
                object.py(),
                "ArgumentType",
                &format!("must be a real number, got {found}"),
            )),
        }
    }
}

/// Declares whole numbers as arguments.
macro_rules! whole {
    ($($(#[$doc:meta])* $name:ident($type:ty);)+) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub(crate) struct $name(pub(crate) $type);

        impl FromPyObject<'_, '_> for $name {
            type Error = PyErr;

            #[cfg(feature = "stubs")]
            const INPUT_TYPE: PyStaticExpr = <$type as FromPyObject<'_, '_>>::INPUT_TYPE;

            fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
                if dimensions_of_truth(&object)? == Some(0) {
                    let message = "must be a whole number, got a truth value";
                    return Err(unnamed(object.py(), "ArgumentType", message));
                }
                let number: PyResult<$type> = object.extract();
                number.map(Self).map_err(|error| {
                    let is_negative = object.lt(0).unwrap_or(false);
                    let range = if is_negative {
                        "must not be negative"
                    } else {
                        "is too large for a whole number"
                    };
                    refused(&object, error, "a whole number", range)
                })
            }
        }
    )+};
}

whole! {
    /// Number of items, or an index.
    Count(usize);
    /// Seed of random numbers.
    Seed(u64);
    /// Whole number of either sign, whose range the function checks.
    Whole(i64);
}

/// Creates an exception of ``stickslip.errors`` about an argument. PyO3 adds a note with the name of the argument, and the
/// exception moves the name from the note to its message.
pub(crate) fn unnamed(py: Python<'_>, class: &str, message: &str) -> PyErr {
    named(py, class, message, &PyDict::new(py)).unwrap_or_else(|failure| failure)
}

/// Starts the message of an exception created by [`unnamed`] with the name of a part of an argument.
pub(crate) fn named_by(py: Python<'_>, error: PyErr, part: &str) -> PyErr {
    let value = error.value(py);
    if value.hasattr("argument").unwrap_or(true) {
        return error;
    }
    let class = value.get_type().name().map(|name| name.to_string());
    match class {
        Ok(class) => of_argument(py, &class, part, &value.to_string()),
        Err(_) => error,
    }
}

/// Creates the exception for an argument of a wrong type, of which the caller states the name.
pub(crate) fn wrong_type(py: Python<'_>, argument: &str, message: &str) -> PyErr {
    of_argument(py, "ArgumentType", argument, message)
}

/// Creates the exception for an argument out of range, of which the caller states the name.
pub(crate) fn out_of_range(py: Python<'_>, argument: &str, message: &str) -> PyErr {
    of_argument(py, "ArgumentRange", argument, message)
}

fn of_argument(py: Python<'_>, class: &str, argument: &str, message: &str) -> PyErr {
    let exception = || {
        let attributes = PyDict::new(py);
        attributes.set_item("argument", argument)?;
        named(py, class, &format!("{argument} {message}"), &attributes)
    };
    exception().unwrap_or_else(|failure| failure)
}

/// Returns the exception for an object that is not the expected number.
fn refused(object: &Bound<'_, PyAny>, error: PyErr, expected: &str, range: &str) -> PyErr {
    let py = object.py();
    if error.is_instance_of::<PyOverflowError>(py) {
        return unnamed(py, "ArgumentRange", &format!("{range}, got {object}"));
    }
    if !error.is_instance_of::<PyTypeError>(py) {
        return error;
    }
    let found = found(object);
    unnamed(
        py,
        "ArgumentType",
        &format!("must be {expected}, got {found}"),
    )
}

/// Describes an object of a wrong type: the shape of an array, the length of a sequence, or the name of the type.
fn found(object: &Bound<'_, PyAny>) -> String {
    let shape = object
        .getattr("shape")
        .ok()
        .filter(|shape| !shape.is_none());
    let is_number = |shape: &Bound<'_, PyAny>| shape.len().is_ok_and(|axes| axes == 0);
    if object.is_none()
        || object.is_instance_of::<PyFloat>()
        || shape.as_ref().is_some_and(is_number)
    {
        return object.to_string();
    }
    if let Some(shape) = shape {
        return format!("an array of shape {shape}");
    }
    let length = object.len();
    let length = length.map_or_else(|_| String::new(), |length| format!(" of length {length}"));
    format!("{}{length}", kind_of(object))
}

/// Returns whether an object is a field or a two-dimensional array.
pub(crate) fn is_plane(object: &Bound<'_, PyAny>) -> bool {
    let dimensions = |array: Bound<'_, PyAny>| array.getattr("ndim")?.extract::<usize>();
    object.is_instance_of::<Field>() || dimensions(object.clone()).is_ok_and(|count| count == 2)
}

/// Creates the exception for an array that does not have the shape of the grid.
pub(crate) fn misshapen(
    py: Python<'_>,
    quantity: &str,
    grid: stickslip::Grid,
    found: &[usize],
) -> PyErr {
    let shape =
        PyTuple::new(py, found).map_or_else(|_| format!("{found:?}"), |shape| shape.to_string());
    let expected = (grid.ny(), grid.nx());
    let message = format!("{quantity} has shape {shape}, expected (ny, nx) = {expected:?}");
    shape_error(py, quantity, grid, found, &message)
}

/// Creates the exception for an argument that does not have the shape of the grid, with a message.
pub(crate) fn shape_error(
    py: Python<'_>,
    quantity: &str,
    grid: stickslip::Grid,
    found: &[usize],
    message: &str,
) -> PyErr {
    let exception = || -> PyResult<PyErr> {
        let expected = (grid.ny(), grid.nx());
        let found = PyTuple::new(py, found)?;
        let numbers = PyDict::new(py);
        numbers.set_item("quantity", quantity)?;
        numbers.set_item("expected", expected)?;
        numbers.set_item("found", found)?;
        named(py, "Shape", message, &numbers)
    };
    exception().unwrap_or_else(|failure| failure)
}

/// Returns an array whose masked entries are NaN. Other objects are returned unchanged.
pub(crate) fn filled<'py>(object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    if object.hasattr("mask")? && object.hasattr("filled")? {
        let real = object.call_method1("astype", ("float64",))?;
        real.call_method1("filled", (f64::NAN,))
    } else {
        Ok(object.clone())
    }
}

/// Returns an array of numbers, in which masked entries and missing values of pandas are NaN.
pub(crate) fn numbers<'py, T>(object: &Bound<'py, PyAny>) -> PyResult<T>
where
    T: for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    filled(object)?.extract().or_else(|error| {
        let module = object.py().import("stickslip._tables")?;
        let known = module.call_method1("with_nan", (object,))?;
        if known.is_none() {
            return Err(error);
        }
        known.extract()
    })
}

/// Returns an array whose axes have the names (x, y), as an array of xarray, with its axes in the order (y, x). Other objects
/// are returned unchanged.
pub(crate) fn by_axis<'py>(object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let names = object.getattr("dims").ok();
    let names: Option<(String, String)> = names.and_then(|names| names.extract().ok());
    match names {
        Some((first, second)) if first == "x" && second == "y" => {
            object.call_method1("transpose", ("y", "x"))
        }
        _ => Ok(object.clone()),
    }
}

/// Returns an error if an array of xarray or a table of pandas has coordinates that do not rise in steps of the cell sides. Its
/// values would otherwise be mirrored or scaled without notice. Without cell sides, coordinates must only rise.
pub(crate) fn check_coordinates(
    object: &Bound<'_, PyAny>,
    quantity: &str,
    sides: Option<[f64; 2]>,
) -> PyResult<()> {
    let is_array = object.hasattr("dims")? && object.hasattr("coords")?;
    if !(is_array || object.hasattr("columns")? && object.hasattr("index")?) {
        return Ok(());
    }
    let module = object.py().import("stickslip.io._datasets")?;
    module.call_method1("check_coordinates", (object, quantity, sides))?;
    Ok(())
}

/// Returns an array with its axes in the order (y, x), after the check of its coordinates. Objects without named axes are
/// returned unchanged.
pub(crate) fn in_axes<'py>(
    object: &Bound<'py, PyAny>,
    quantity: &str,
    sides: Option<[f64; 2]>,
) -> PyResult<Bound<'py, PyAny>> {
    check_coordinates(object, quantity, sides)?;
    by_axis(object)
}

/// Returns the remedy for an object of the package instead of an array. In the calls with both, the gap or the normal contact
/// precedes friction.
fn remedy(object: &Bound<'_, PyAny>) -> &'static str {
    if object.is_instance_of::<NormalSolution>() {
        ": a normal solution is given as the pressure, before friction"
    } else if object.is_instance_of::<Friction>() {
        ": friction is given after the gap or the pressure"
    } else if object.is_instance_of::<History>() {
        ": give one of its arrays, such as history.pressure or history.gap_as_set"
    } else if object.is_instance_of::<HalfSpace>() {
        ": the bodies are the first argument"
    } else {
        ""
    }
}

/// Returns a two-dimensional array of numbers; masked entries become NaN. The names of the axes determine their order, if
/// there are any.
pub(crate) fn plane<'py>(
    object: &Bound<'py, PyAny>,
    quantity: &str,
    grid: stickslip::Grid,
) -> PyResult<PyArrayLike2<'py, f64, AllowTypeChange>> {
    let object = &by_axis(object)?;
    numbers(object).map_err(|_| {
        let shape = as_array(object).and_then(|array| array.getattr("shape").ok()?.extract().ok());
        // NumPy converts an object of unknown type to a zero-dimensional array.
        let differs = |shape: &Vec<usize>| !shape.is_empty() && *shape != [grid.ny(), grid.nx()];
        match shape.filter(differs) {
            Some(shape) => misshapen(object.py(), quantity, grid, &shape),
            None => PyTypeError::new_err(format!(
                "{quantity} must be a Field or an array of real numbers of shape (ny, nx), got {}{}",
                kind_of(object),
                remedy(object)
            )),
        }
    })
}
