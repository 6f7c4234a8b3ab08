//! Fields on a grid, and what is taken for one.

use std::sync::Arc;

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use stickslip::Error;

use crate::argument::argument;
use crate::array::{Array, view};
use crate::conversion::kind_of;
use crate::digits::short;
use crate::error::OrRaise;
use crate::grid::{Grid, size};
use crate::pickle::{Reduced, Stored, reduced};
use crate::real::{is_real, misshapen, plane};
use crate::unit::{Unit, is_same, metres, one_of};

/// Samples at the cells of a grid, one number a cell: gaps, heights, pressures. It is never changed.
///
/// Whatever takes a field takes an array of shape (ny, nx) too, and copies it; a Field is made once and shared, so that
/// repeated calls copy nothing. ``numpy.asarray(field)`` is a read-only view of it, and ``field[iy, ix]`` a sample. Sums,
/// differences, products and quotients with fields, arrays and numbers, in either order and cell by cell, are fields; other
/// functions of NumPy take it as its array.
///
/// Parameters
/// ----------
/// grid : Grid
///     Where it lives.
/// samples : array_like of shape (ny, nx), or float
///     Its values, row-major with x fastest; or one for all cells.
/// unit : str, optional
///     The unit of the lengths of a surface, such as ``"um"``. What is made of the surface keeps it, and surfaces of
///     several units are refused together; the package computes in any, and asks for none.
///
/// Examples
/// --------
/// >>> import numpy as np, stickslip
/// >>> grid = stickslip.Grid(4, 3, 0.5, 0.5)
/// >>> field = stickslip.Field(grid, np.arange(12.0).reshape(3, 4))
/// >>> field
/// Field(4 x 3 cells, 0 to 11)
/// >>> (field + 1.0).array[0]
/// array([1., 2., 3., 4.])
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone)]
pub(crate) struct Field(pub(crate) Arc<stickslip::Field>, pub(crate) Option<Unit>);

/// Of the same samples, and in the same unit where both state one.
impl PartialEq for Field {
    fn eq(&self, other: &Self) -> bool {
        let is_other = |(own, other): (&Unit, &Unit)| !is_same(own, other);
        self.0 == other.0 && !self.1.as_ref().zip(other.1.as_ref()).is_some_and(is_other)
    }
}

impl From<stickslip::Field> for Field {
    fn from(field: stickslip::Field) -> Self {
        Arc::new(field).into()
    }
}

impl From<Arc<stickslip::Field>> for Field {
    fn from(field: Arc<stickslip::Field>) -> Self {
        Self(field, None)
    }
}

#[pymethods]
impl Field {
    #[new]
    #[pyo3(signature = (grid, samples, unit=None))]
    fn new(
        py: Python<'_>,
        grid: &Grid,
        samples: Samples<'_>,
        unit: Option<&str>,
    ) -> PyResult<Self> {
        let unit = unit.map(Unit::from).or(samples.unit()?);
        Ok(Self(samples.on(py, "samples", grid.0)?, unit))
    }

    /// The unit of the lengths of a surface, if it is known.
    #[getter]
    fn unit(&self) -> Option<&str> {
        self.1.as_deref()
    }

    /// A surface in another unit: its heights and the sides of its cells, from its own unit.
    ///
    /// Units are m, dm, cm, mm, um, nm, pm and A, and the micro sign in the place of u.
    ///
    /// Raises
    /// ------
    /// ValueError
    ///     If the unit of the surface is not known, or either is none of these.
    fn to_unit(&self, py: Python<'_>, unit: &str) -> PyResult<Self> {
        let own = self.1.as_deref().ok_or_else(|| {
            PyValueError::new_err("the surface has no unit: Field(grid, samples, unit=...)")
        })?;
        let factor = metres(own)? / metres(unit)?;
        let (grid, samples) = (self.0.grid(), self.0.scaled(factor).into_vec());
        let grid =
            stickslip::Grid::new(grid.nx(), grid.ny(), grid.dx() * factor, grid.dy() * factor);
        let field = grid.and_then(|grid| stickslip::Field::from_vec(grid, samples));
        Ok(Self(Arc::new(field.or_raise(py)?), Some(unit.into())))
    }

    /// The grid.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.0.grid())
    }

    /// Its shape as an array, (ny, nx).
    #[getter]
    fn shape(&self) -> (usize, usize) {
        self.grid().shape()
    }

    /// A read-only array of shape (ny, nx) on the memory of the field, without a copy.
    #[getter]
    fn array<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |field| &field.0)
    }

    /// The largest sample; NaN is passed over.
    fn max(&self) -> f64 {
        self.0.max()
    }

    /// The least sample; NaN is passed over.
    fn min(&self) -> f64 {
        self.0.min()
    }

    /// The mean of the samples.
    fn mean(&self) -> f64 {
        self.0.mean()
    }

    /// The sum of the samples times the area of a cell.
    fn integral(&self) -> f64 {
        self.0.integral()
    }

    /// As of :attr:`array`: ``field[iy, ix]`` is a sample, ``field[iy]`` a row.
    fn __getitem__<'py>(
        slf: &Bound<'py, Self>,
        index: Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        Self::array(slf).0.get_item(index)
    }

    /// The sample of a cell, by column and row; ``None`` beyond the grid.
    fn get(&self, ix: usize, iy: usize) -> Option<f64> {
        self.0.get(ix, iy)
    }

    #[pyo3(signature = (dtype=None, copy=None))]
    fn __array__<'py>(
        slf: &Bound<'py, Self>,
        dtype: Option<Bound<'py, PyAny>>,
        copy: Option<bool>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let array = Self::array(slf).0;
        if dtype.is_none() && copy != Some(true) {
            return Ok(array);
        }
        let kwargs = PyDict::new(slf.py());
        kwargs.set_item("copy", copy.unwrap_or(false))?;
        let dtype = match dtype {
            Some(dtype) => dtype,
            None => array.getattr("dtype")?,
        };
        array.call_method("astype", (dtype,), Some(&kwargs))
    }

    /// What NumPy calls instead of its function where one of the operands is a field.
    #[pyo3(signature = (ufunc, method, *inputs, **kwargs))]
    fn __array_ufunc__<'py>(
        slf: &Bound<'py, Self>,
        ufunc: Bound<'py, PyAny>,
        method: &str,
        inputs: Vec<Bound<'py, PyAny>>,
        kwargs: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let name: String = ufunc.getattr("__name__")?.extract()?;
        if let ("__call__", [left, right], None) = (method, &inputs[..], &kwargs) {
            let reflected = match &name[..] {
                "add" => Some("__radd__"),
                "subtract" => Some("__rsub__"),
                "multiply" => Some("__rmul__"),
                "divide" | "true_divide" => Some("__rtruediv__"),
                _ => None,
            };
            if let Some(reflected) = reflected.filter(|_| right.is(slf)) {
                return slf.call_method1(reflected, (left,));
            }
        }
        let arrays = inputs.into_iter().map(|input| match input.cast::<Self>() {
            Ok(field) => Self::array(field).0,
            Err(_) => input,
        });
        let arrays = PyTuple::new(slf.py(), arrays.collect::<Vec<_>>())?;
        ufunc.getattr(method)?.call(arrays, kwargs.as_ref())
    }

    fn __add__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.of_one_unit(py, &other, |own, other| own + other)
    }

    fn __radd__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.of_one_unit(py, &other, |own, other| other + own)
    }

    fn __sub__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.of_one_unit(py, &other, |own, other| own - other)
    }

    fn __rsub__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.of_one_unit(py, &other, |own, other| other - own)
    }

    fn __mul__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.by_cell(py, &other, |own, other| own * other)
    }

    fn __rmul__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.by_cell(py, &other, |own, other| own * other)
    }

    fn __truediv__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.by_cell(py, &other, |own, other| own / other)
    }

    fn __rtruediv__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.by_cell(py, &other, |own, other| other / own)
    }

    fn __neg__(&self) -> Self {
        Self(Arc::new(self.0.scaled(-1.0)), self.1.clone())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced::<Self>(
            py,
            &((*self.0).clone(), self.1.as_deref().map(String::from)),
        )
    }

    fn __repr__(&self) -> String {
        let size = size(self.0.grid());
        if self.0.min() > self.0.max() {
            return format!("Field({size}, all NaN)");
        }
        let unit = self.1.as_ref().map(|unit| format!(" {unit}"));
        format!(
            "Field({size}, {} to {}{})",
            short(self.0.min()),
            short(self.0.max()),
            unit.unwrap_or_default()
        )
    }
}

impl Stored for Field {
    type Content = (stickslip::Field, Option<String>);

    const KIND: &'static str = "Field";

    fn of_content((field, unit): Self::Content) -> Self {
        Self(Arc::new(field), unit.map(Unit::from))
    }
}

impl Field {
    /// What has been made of surfaces in this unit.
    pub(crate) fn made(field: stickslip::Field, unit: Option<Unit>) -> Self {
        Self(Arc::new(field), unit)
    }

    /// An operation of each cell with that of another field, which must be in the same unit.
    fn of_one_unit(
        &self,
        py: Python<'_>,
        other: &Samples<'_>,
        operation: fn(f64, f64) -> f64,
    ) -> PyResult<Self> {
        let unit = one_of([self.1.clone(), other.unit()?])?;
        Ok(Self(self.by_cell(py, other, operation)?.0, unit))
    }

    /// An operation of each cell with that of another field.
    fn by_cell(
        &self,
        py: Python<'_>,
        other: &Samples<'_>,
        operation: fn(f64, f64) -> f64,
    ) -> PyResult<Self> {
        let grid = self.0.grid();
        let other = other.on(py, "other field", grid)?;
        // Whether both are on one grid is for the crate to say: its difference is then overwritten.
        let difference = self.0.minus(&other).map_err(|mut error| {
            if let Error::GridMismatch { quantity, .. } = &mut error {
                *quantity = "other field";
            }
            error
        });
        let mut result = difference.or_raise(py)?;
        let pairs = self.0.as_slice().iter().zip(other.as_slice());
        for (sample, (own, other)) in result.as_mut_slice().iter_mut().zip(pairs) {
            *sample = operation(*own, *other);
        }
        Ok(result.into())
    }
}

argument! {
    /// What is taken for a field: a field, an array of shape (ny, nx), one number for all cells, or a topography that
    /// knows its heights and sizes.
    Samples: Field
}

impl Samples<'_> {
    /// As a field on this grid. A field on another one is passed on: the crate refuses it with both grids.
    pub(crate) fn on(
        &self,
        py: Python<'_>,
        quantity: &str,
        grid: stickslip::Grid,
    ) -> PyResult<Arc<stickslip::Field>> {
        if let Some(field) = self.field() {
            return Ok(field);
        }
        if self.is_topography()? {
            return Err(PyTypeError::new_err(format!(
                "{quantity} is a topography, whose heights point out of its body: \
                 surface.gap_from_heights(topography) makes a gap of them"
            )));
        }
        if self.has_heights() {
            return Err(PyTypeError::new_err(format!(
                "{quantity} is a {}, which has heights: give its .heights, or \
                 surface.gap_from_heights(rough.heights), the gap under them",
                kind_of(&self.0)
            )));
        }
        is_real(&self.0, quantity)?;
        if let Some(value) = self.number() {
            return Ok(Arc::new(stickslip::Field::constant(grid, value)));
        }
        let samples = plane(&self.0, quantity, grid)?;
        let samples = samples.as_array();
        if samples.dim() != (grid.ny(), grid.nx()) {
            let (rows, columns) = samples.dim();
            return Err(misshapen(py, quantity, grid, &[rows, columns]));
        }
        let samples = match samples.as_slice() {
            Some(samples) => samples.to_vec(),
            None => samples.iter().copied().collect(),
        };
        let field = stickslip::Field::from_vec(grid, samples).or_raise(py)?;
        Ok(Arc::new(field))
    }

    /// As one number, if it is one.
    pub(crate) fn number(&self) -> Option<f64> {
        self.0.extract().ok()
    }

    /// The shape of an array.
    pub(crate) fn shape(&self) -> Option<(usize, usize)> {
        self.0.getattr("shape").ok()?.extract().ok()
    }

    /// As one number, or a field on this grid; without one, on the field's own.
    pub(crate) fn spread(
        &self,
        py: Python<'_>,
        quantity: &str,
        grid: Option<&Grid>,
    ) -> PyResult<Spread> {
        is_real(&self.0, quantity)?;
        match self.number() {
            Some(value) => Ok(Spread::Uniform(value)),
            None => self
                .on(py, quantity, grid_of(grid, &[self])?)
                .map(Spread::PerCell),
        }
    }

    /// As a field on a grid of its own.
    pub(crate) fn alone(&self, quantity: &str) -> PyResult<Arc<stickslip::Field>> {
        self.known()?.ok_or_else(|| {
            let instead = if self.has_heights() {
                format!(", got {}: give its .heights", kind_of(&self.0))
            } else {
                ": Field(grid, array)".into()
            };
            PyTypeError::new_err(format!(
                "{quantity} must be a Field or a topography, which know their grid{instead}"
            ))
        })
    }

    /// The unit of the lengths of a field or a topography, if it states one.
    pub(crate) fn unit(&self) -> PyResult<Option<Unit>> {
        if let Ok(field) = self.0.cast::<Field>() {
            return Ok(field.get().1.clone());
        }
        if !self.is_topography()? || !self.0.hasattr("unit")? {
            return Ok(None);
        }
        let unit = self.0.getattr("unit")?;
        if unit.is_none() {
            return Ok(None);
        }
        Ok(Some(unit.str()?.to_str()?.into()))
    }

    fn field(&self) -> Option<Arc<stickslip::Field>> {
        let field = self.0.cast::<Field>().ok()?;
        Some(Arc::clone(&field.get().0))
    }

    /// Whether it is an object of the package that has heights: a rough, a filled or a levelled surface.
    fn has_heights(&self) -> bool {
        let heights = self.0.getattr("heights");
        heights.is_ok_and(|heights| heights.is_instance_of::<Field>())
    }

    fn is_topography(&self) -> PyResult<bool> {
        Ok(self.0.hasattr("heights")? && self.0.hasattr("physical_sizes")?)
    }

    fn known(&self) -> PyResult<Option<Arc<stickslip::Field>>> {
        if let Some(field) = self.field() {
            return Ok(Some(field));
        }
        if self.is_topography()? {
            let module = self.0.py().import("stickslip.surface")?;
            let field = module.call_method1("from_topography", (&self.0,))?;
            return Ok(Some(Arc::clone(&field.cast::<Field>()?.get().0)));
        }
        Ok(None)
    }
}

/// The unit of surfaces, of which those that state one must state the same.
pub(crate) fn one_unit(fields: &[&Samples<'_>]) -> PyResult<Option<Unit>> {
    let units: PyResult<Vec<_>> = fields.iter().map(|field| field.unit()).collect();
    one_of(units?)
}

/// One number for all cells, or one of each.
pub(crate) enum Spread {
    Uniform(f64),
    PerCell(Arc<stickslip::Field>),
}

/// The grid that is given, or else that of the first field that knows its own.
pub(crate) fn grid_of(grid: Option<&Grid>, fields: &[&Samples<'_>]) -> PyResult<stickslip::Grid> {
    if let Some(grid) = grid {
        return Ok(grid.0);
    }
    for field in fields {
        if let Some(field) = field.known()? {
            return Ok(field.grid());
        }
    }
    Err(PyTypeError::new_err(
        "an array does not know the sides of its cells: give grid= (history.grid, solution.grid), or a Field",
    ))
}
