//! Closed forms: alike classes, declared from their lists of parameters, numbers and functions.

mod pressing;
mod rough;
mod shear;

pub(crate) use pressing::*;
pub(crate) use rough::*;
pub(crate) use shear::*;

use numpy::ndarray::{ArrayD, Zip};
use numpy::{AllowTypeChange, IntoPyArray, PyArrayLikeDyn};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
#[cfg(feature = "stubs")]
use pyo3::{inspect::PyStaticExpr, type_hint_identifier};

/// Coordinates: a number, or an array of any shape.
pub(crate) struct Coordinates(ArrayD<f64>);

impl FromPyObject<'_, '_> for Coordinates {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_identifier!("numpy.typing", "ArrayLike");

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        let array: PyArrayLikeDyn<'_, f64, AllowTypeChange> = object.extract()?;
        Ok(Self(array.as_array().to_owned()))
    }
}

/// A number for a number, an array for an array.
pub(crate) struct Values(ArrayD<f64>);

impl<'py> IntoPyObject<'py> for Values {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const OUTPUT_TYPE: PyStaticExpr = type_hint_identifier!("typing", "Any");

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match (self.0.ndim(), self.0.first()) {
            (0, Some(value)) => Ok(value.into_pyobject(py)?.into_any()),
            _ => Ok(self.0.into_pyarray(py).into_any()),
        }
    }
}

/// A function of one coordinate.
pub(crate) fn along(coordinates: Coordinates, function: impl Fn(f64) -> f64) -> Values {
    Values(coordinates.0.mapv_into(function))
}

/// A function of two coordinates, of one shape once they are broadcast.
pub(crate) fn across(
    x: Coordinates,
    y: Coordinates,
    function: impl Fn(f64, f64) -> f64,
) -> PyResult<Values> {
    let shape = if x.0.len() >= y.0.len() {
        x.0.dim()
    } else {
        y.0.dim()
    };
    let (Some(x), Some(y)) = (x.0.broadcast(shape.clone()), y.0.broadcast(shape)) else {
        return Err(PyValueError::new_err("the shapes of x and y do not fit"));
    };
    Ok(Values(
        Zip::from(x).and(y).map_collect(|x, y| function(*x, *y)),
    ))
}

/// Declares the class of a closed form: what it is made from, the other objects that it has, its numbers, its pairs of
/// numbers, and its functions of one coordinate and of two.
macro_rules! closed_form {
    (
        $(#[$doc:meta])*
        $class:ident($($argument:ident: $given:ty => $value:expr),*)
        objects { $($(#[$object_doc:meta])* $object:ident: $object_class:ty = $wrapped:expr),* $(,)? }
        numbers { $($(#[$number_doc:meta])* $number:ident),* $(,)? }
        pairs { $($(#[$pair_doc:meta])* $pair:ident),* $(,)? }
        along { $($(#[$along_doc:meta])* $along:ident($coordinate:ident)),* $(,)? }
        across { $($(#[$across_doc:meta])* $across:ident),* $(,)? }
        $(also { $($also:item)* })?
    ) => {
        $(#[$doc])*
        #[pyo3::pyclass(frozen, eq, module = "stickslip.analytical", from_py_object)]
        #[derive(Clone, PartialEq)]
        pub(crate) struct $class(pub(crate) stickslip::analytical::$class);

        #[pyo3::pymethods]
        impl $class {
            #[new]
            fn new(py: pyo3::Python<'_>, $($argument: $given),*) -> pyo3::PyResult<Self> {
                let form = stickslip::analytical::$class::new($($value),*);
                crate::error::OrRaise::or_raise(form, py).map(Self)
            }

            $(
                $(#[$object_doc])*
                #[getter]
                fn $object(&self) -> $object_class {
                    ($wrapped)(self.0.$object())
                }
            )*

            $(
                $(#[$number_doc])*
                #[getter]
                fn $number(&self) -> f64 {
                    self.0.$number()
                }
            )*

            $(
                $(#[$pair_doc])*
                #[getter]
                fn $pair(&self) -> (f64, f64) {
                    crate::sequence::pair(self.0.$pair())
                }
            )*

            $(
                $(#[$along_doc])*
                fn $along(&self, $coordinate: crate::analytical::Coordinates) -> crate::analytical::Values {
                    crate::analytical::along($coordinate, |at| self.0.$along(at))
                }
            )*

            $(
                $(#[$across_doc])*
                fn $across(
                    &self,
                    x: crate::analytical::Coordinates,
                    y: crate::analytical::Coordinates,
                ) -> pyo3::PyResult<crate::analytical::Values> {
                    crate::analytical::across(x, y, |x, y| self.0.$across(x, y))
                }
            )*

            fn __repr__(&self) -> String {
                let numbers: Vec<String> =
                    vec![$(format!("{}={:.6e}", stringify!($number), self.0.$number())),*];
                format!("{}({})", stringify!($class), numbers.join(", "))
            }
        }

        $(#[pyo3::pymethods] impl $class { $($also)* })?
    };
}

pub(crate) use closed_form;

/// Stick ratio of a nominally flat rough contact under light loads, 1 - F / (mu W).
#[pyfunction]
pub(crate) fn linear_stick_ratio(
    py: Python<'_>,
    load: f64,
    friction: f64,
    force: f64,
) -> PyResult<f64> {
    crate::error::OrRaise::or_raise(
        stickslip::analytical::linear_stick_ratio(load, friction, force),
        py,
    )
}
