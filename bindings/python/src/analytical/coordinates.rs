//! Coordinates and values of closed-form solutions: numbers or arrays.

use numpy::ndarray::{ArrayD, Axis, Zip};
use numpy::{AllowTypeChange, IntoPyArray, PyArrayLikeDyn};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::real::{is_no_mask, is_real, numbers, out_of_range};
#[cfg(feature = "stubs")]
use pyo3::{inspect::PyStaticExpr, type_hint_identifier};

/// Coordinates: a number, or an array of any shape, with the names of its axes if it has names.
pub(crate) struct Coordinates(ArrayD<f64>, Option<Vec<String>>);

impl FromPyObject<'_, '_> for Coordinates {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_identifier!("numpy.typing", "ArrayLike");

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        is_real(&object, "coordinates")?;
        is_no_mask(&object, "coordinates")?;
        let names = object.getattr("dims").and_then(|names| names.extract());
        let array: PyArrayLikeDyn<'_, f64, AllowTypeChange> = numbers(&object)?;
        Ok(Self(array.as_array().to_owned(), names.ok()))
    }
}

impl Coordinates {
    /// Returns an error if a coordinate is outside its range. Missing coordinates are in any range.
    pub(crate) fn check(
        self,
        py: Python<'_>,
        name: &str,
        range: &str,
        is_within: impl Fn(f64) -> bool,
    ) -> PyResult<Self> {
        match self
            .0
            .iter()
            .find(|value| !value.is_nan() && !is_within(**value))
        {
            None => Ok(self),
            Some(value) => Err(out_of_range(
                py,
                name,
                &format!("must be {range}, got {value:?}"),
            )),
        }
    }

    /// Returns an error if a depth below the surface is negative.
    pub(super) fn check_depth(self, py: Python<'_>) -> PyResult<Self> {
        self.check(py, "depth", "zero or more, below the surface", |depth| {
            depth >= 0.0
        })
    }

    /// Evaluates a function at these coordinates.
    pub(crate) fn along(self, function: impl Fn(f64) -> f64) -> Values {
        let [values] = self.all_along(|at| [function(at)]);
        values
    }

    /// Evaluates several functions at these coordinates.
    pub(super) fn all_along<const N: usize>(
        self,
        functions: impl Fn(f64) -> [f64; N],
    ) -> [Values; N] {
        // A missing coordinate has no values. The functions would count it as outside the contact.
        let of_known = |at: f64| {
            if at.is_nan() {
                [f64::NAN; N]
            } else {
                functions(at)
            }
        };
        Values::each(&self.0.mapv(of_known))
    }

    /// Evaluates a function of these coordinates and others, which are broadcast to a common shape.
    pub(super) fn across(
        self,
        other: Self,
        function: impl Fn(f64, f64) -> f64,
    ) -> PyResult<Values> {
        let [values] = self.all_across(other, |x, y| [function(x, y)])?;
        Ok(values)
    }

    /// Evaluates several functions of these coordinates and others.
    pub(super) fn all_across<const N: usize>(
        self,
        other: Self,
        functions: impl Fn(f64, f64) -> [f64; N],
    ) -> PyResult<[Values; N]> {
        // Axes are combined from the last.
        let differ = |(own, other): &(&Vec<String>, &Vec<String>)| {
            own.iter()
                .rev()
                .zip(other.iter().rev())
                .any(|(a, b)| a != b)
        };
        let names = self.1.as_ref().zip(other.1.as_ref());
        if let Some((own, other)) = names.filter(differ) {
            return Err(PyValueError::new_err(format!(
                "the coordinates have the dimensions ({}) and ({}), but are combined by position: \
                 broadcast them by xarray.broadcast(...), or give .values",
                own.join(", "),
                other.join(", ")
            )));
        }
        let (x, y) = (self.0, other.0);
        // Axes are counted from the last; a missing axis has length one.
        let length = |array: &ArrayD<f64>, axis: usize| {
            let axis = array.ndim().checked_sub(axis + 1);
            axis.map_or(1, |axis| array.len_of(Axis(axis)))
        };
        let axes = (0..x.ndim().max(y.ndim())).rev();
        let shape: Vec<usize> = axes
            .map(|axis| match length(&x, axis) {
                1 => length(&y, axis),
                length => length,
            })
            .collect();
        let (Some(x), Some(y)) = (x.broadcast(&shape[..]), y.broadcast(&shape[..])) else {
            return Err(PyValueError::new_err(
                "the arrays x and y must have shapes that can be broadcast together",
            ));
        };
        let found = Zip::from(x).and(y).map_collect(|&x, &y| {
            if x.is_nan() || y.is_nan() {
                [f64::NAN; N]
            } else {
                functions(x, y)
            }
        });
        Ok(Values::each(&found))
    }
}

/// Values at coordinates: a number for a number, an array for an array.
pub(crate) struct Values(ArrayD<f64>);

impl Values {
    /// Returns the values of several functions.
    fn each<const N: usize>(found: &ArrayD<[f64; N]>) -> [Self; N] {
        std::array::from_fn(|index| Self(found.mapv(|values| values[index])))
    }
}

/// Stresses xx, zz and xz.
pub(super) type PlaneStrain = (Values, Values, Values);

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
