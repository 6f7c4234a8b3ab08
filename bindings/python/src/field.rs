//! Fields on a grid.

use std::sync::Arc;

use numpy::IntoPyArray;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::pyclass::CompareOp;
use pyo3::types::{PyBool, PyDict, PyString, PyTuple};
use stickslip::Error;

use crate::argument::Object;
use crate::array::{Array, mask, view};
use crate::conversion::entries;
use crate::digits::short;
use crate::error::OrRaise;
use crate::grid::{Grid, size};
use crate::numpy_functions::{apply_to_arrays, apply_to_fields, as_numpy, reduced_by};
use crate::pickle::{Reduced, Stored, reduced};
use crate::real::Count;
use crate::samples::Samples;
use crate::unit::{Unit, agree, factor, known, one_of};
use crate::xarray::only_first_operand;

/// Samples at the cells of a grid, one number per cell, such as gaps, heights or pressures. A field is immutable.
///
/// Every argument that accepts a field also accepts an array of shape (ny, nx), which is copied. A Field is created once
/// and shared, so repeated calls copy nothing. ``numpy.asarray(field)`` is a read-only view of a field, and
/// ``field[iy, ix]`` is a sample. A sum, difference, product, quotient or power with a field, an array or a number, in
/// either order, is computed cell by cell and is a field. A quotient by zero, and any other result that is not finite, issues the
/// warning of NumPy. A comparison by ``<``, ``<=``, ``>`` or ``>=`` is an array of booleans, and so is a comparison by ``==`` or ``!=``
/// with a number or an array. Two fields are compared as a whole by ``==`` and ``!=``, whose result is one truth value; compare
/// their arrays for a result per cell. Fields have no hash. Other NumPy functions, such as ``numpy.maximum``, treat a field as its array: their result has no unit, and fields of
/// different units raise an error. The axes of an array of xarray with the
/// dimensions x and y are recognised by their names, also by NumPy functions of a field. Its coordinates x and y, if any, must rise in
/// steps of the cell sides. Dimensions of other names raise an error if they have coordinates. The labels of a DataFrame of pandas are
/// either such coordinates, whole numbers that rise in steps of one, or names. Its rows are y and its columns x. Other labels, such as
/// those of a reversed or shuffled table, raise an error. A transposed table raises an error if its axes have the names y and x, or if
/// its coordinates do not agree with the cell sides. On a grid of equal sides, a transposed table without names is not noticed. Masked cells and the value ``NA`` of pandas are missing points
/// (NaN). They are rejected in a gap or a pressure, and :func:`surface.fill_missing <stickslip.surface.fill_missing>` fills them.
///
/// Parameters
/// ----------
/// grid : Grid
///     Grid of the samples.
/// samples : array_like of shape (ny, nx), or float
///     The values, row-major with x fastest, or one value for all cells.
/// unit : str, optional
///     The unit of the lengths of a surface, such as ``"um"``: heights and cell sides. Accepted units are those of
///     :meth:`to_unit`. Results computed from the surface keep the unit, and operations on surfaces of different units raise
///     an error. The unit is optional; the package computes in any consistent units.
///
/// Notes
/// -----
/// A number, an array or a field without a unit takes the unit of the other operand in sums, differences and comparisons.
/// A product with it and a quotient by it keep the unit, so ``heights * 1e-6`` does not convert a unit; :meth:`to_unit`
/// does. Products and ratios of two fields with units, inverse fields and powers have no unit. A gap that replaces the gap of
/// a solver or history has the unit of that gap, and raises an error if it states another unit.
///
/// Bodies, loads and grids have no unit. A gap is therefore used as given: its lengths must have the unit of the sides of the
/// grid, and moduli and forces a consistent unit. ``Field(grid, heights, "um")`` states that heights and cell sides are both in
/// micrometres. Heights in micrometres on a grid in metres are converted by their factor, ``Field(grid, 1e-6 * heights, "m")``.
/// An array of xarray whose attribute ``units`` differs from the attribute ``units`` of its coordinates raises an error;
/// coordinates without this attribute have the unit of the array.
/// In sums with an array of xarray, the field must be the first operand, ``field + array``; the reverse order raises an error. The
/// reverse order of a ``Variable`` of xarray raises none and ignores the names of its axes.
///
/// Raises
/// ------
/// ValueError
///     If the unit is not a unit of length.
/// Shape, GridMismatch
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
#[pyclass(frozen, module = "stickslip")]
#[derive(Clone)]
pub(crate) struct Field(pub(crate) Arc<stickslip::Field>, pub(crate) Option<Unit>);

/// Fields are equal if their samples are equal and their units do not differ; a missing unit matches any unit.
impl PartialEq for Field {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0 && agree(self.1.as_ref(), other.1.as_ref())
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
        grid: Object<Grid>,
        samples: Samples<'_>,
        unit: Option<&str>,
    ) -> PyResult<Self> {
        samples.check_no_truth_value("samples")?;
        let unit = one_of([unit.map(known).transpose()?, samples.unit()?])?;
        if unit.is_some() {
            samples.check_no_energies("a field of lengths")?;
        }
        let field = samples.only_on(py, "samples", grid.0)?;
        Ok(Self(field, unit))
    }

    /// Priority over a DataFrame of pandas in arithmetic. The DataFrame would apply its transposed blocks to the field.
    #[classattr]
    fn __pandas_priority__() -> u32 {
        5000
    }

    /// Unit of the lengths of a surface; ``None`` if it is not known.
    #[getter]
    fn unit(&self) -> Option<&str> {
        self.1.as_deref()
    }

    /// Converts the heights and the cell sides of a surface from its own unit to another unit.
    ///
    /// Accepted units are km, m, dm, cm, mm, um, nm, A and pm; the micro sign may replace the letter u.
    ///
    /// Raises
    /// ------
    /// ValueError
    ///     If the unit of the surface is not known, or if either unit is not in this list.
    fn to_unit(&self, py: Python<'_>, unit: &str) -> PyResult<Self> {
        let own = self.1.as_deref().ok_or_else(|| {
            PyValueError::new_err(
                "the surface has no unit: give one by Field(grid, samples, unit=...)",
            )
        })?;
        let factor = factor(own, unit)?;
        let (grid, samples) = (self.0.grid(), self.0.scaled(factor).into_vec());
        let grid =
            stickslip::Grid::new(grid.nx(), grid.ny(), grid.dx() * factor, grid.dy() * factor);
        let field = grid.and_then(|grid| stickslip::Field::from_vec(grid, samples));
        Ok(Self(Arc::new(field.or_raise(py)?), Some(unit.into())))
    }

    /// Grid of the field.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.0.grid())
    }

    /// Shape of the field as an array, (ny, nx).
    #[getter]
    fn shape(&self) -> (usize, usize) {
        self.grid().shape()
    }

    /// A read-only array of shape (ny, nx) on the memory of the field, without a copy.
    #[getter]
    pub(crate) fn array<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |field| &field.0)
    }

    /// Returns the largest sample; NaN is ignored. The arguments are those of :func:`numpy.nanmax`, such as the axis.
    #[pyo3(signature = (*arguments, **options), text_signature = "($self, axis=None, **options)")]
    fn max<'py>(
        slf: &Bound<'py, Self>,
        arguments: &Bound<'py, PyTuple>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        reduced_by(
            slf,
            "nanmax",
            Some(stickslip::Field::max),
            arguments,
            options,
        )
    }

    /// Returns the smallest sample; NaN is ignored. The arguments are those of :func:`numpy.nanmin`, such as the axis.
    #[pyo3(signature = (*arguments, **options), text_signature = "($self, axis=None, **options)")]
    fn min<'py>(
        slf: &Bound<'py, Self>,
        arguments: &Bound<'py, PyTuple>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        reduced_by(
            slf,
            "nanmin",
            Some(stickslip::Field::min),
            arguments,
            options,
        )
    }

    /// Returns the mean of the samples. The arguments are those of :func:`numpy.mean`, such as the axis.
    #[pyo3(signature = (*arguments, **options), text_signature = "($self, axis=None, **options)")]
    fn mean<'py>(
        slf: &Bound<'py, Self>,
        arguments: &Bound<'py, PyTuple>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        reduced_by(
            slf,
            "mean",
            Some(stickslip::Field::mean),
            arguments,
            options,
        )
    }

    /// Returns the sum of the samples. The arguments are those of :func:`numpy.sum`, such as the axis.
    #[pyo3(signature = (*arguments, **options), text_signature = "($self, axis=None, **options)")]
    fn sum<'py>(
        slf: &Bound<'py, Self>,
        arguments: &Bound<'py, PyTuple>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        reduced_by(slf, "sum", None, arguments, options)
    }

    /// Returns the standard deviation of the samples. The arguments are those of :func:`numpy.std`, such as the axis.
    #[pyo3(signature = (*arguments, **options), text_signature = "($self, axis=None, **options)")]
    fn std<'py>(
        slf: &Bound<'py, Self>,
        arguments: &Bound<'py, PyTuple>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        reduced_by(slf, "std", None, arguments, options)
    }

    /// Returns the sum of the samples times the area of a cell.
    fn integral(&self) -> f64 {
        self.0.integral()
    }

    /// Indexes :attr:`array`: ``field[iy, ix]`` is a sample, and ``field[iy]`` is a row.
    fn __getitem__<'py>(
        slf: &Bound<'py, Self>,
        index: Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        Self::array(slf).0.get_item(index)
    }

    /// Returns the sample of a cell, given by column and row, or ``None`` outside the grid.
    fn get(&self, ix: Count, iy: Count) -> Option<f64> {
        self.0.get(ix.0, iy.0)
    }

    #[pyo3(signature = (dtype=None, copy=None))]
    fn __array__<'py>(
        slf: &Bound<'py, Self>,
        dtype: Option<Bound<'py, PyAny>>,
        copy: Option<bool>,
    ) -> PyResult<Bound<'py, PyAny>> {
        as_numpy(Self::array(slf).0, dtype, copy)
    }

    /// Implements NumPy functions with a field among their operands. Fields of different units are rejected, as in arithmetic.
    #[pyo3(signature = (ufunc, method, *inputs, **kwargs))]
    fn __array_ufunc__<'py>(
        slf: &Bound<'py, Self>,
        ufunc: Bound<'py, PyAny>,
        method: &str,
        inputs: Vec<Bound<'py, PyAny>>,
        kwargs: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        apply_to_fields(slf, &ufunc, method, inputs, kwargs.as_ref())
    }

    /// Implements NumPy functions that are not ufuncs, such as ``numpy.stack``, in the same way.
    fn __array_function__<'py>(
        &self,
        function: &Bound<'py, PyAny>,
        _types: &Bound<'py, PyAny>,
        arguments: &Bound<'py, PyAny>,
        options: &Bound<'py, PyDict>,
    ) -> PyResult<Bound<'py, PyAny>> {
        apply_to_arrays(function, arguments, options)
    }

    fn __add__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.of_one_unit(py, &other, &SUM, false)
    }

    fn __radd__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.of_one_unit(py, &other, &SUM, true)
    }

    fn __sub__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.of_one_unit(py, &other, &DIFFERENCE, false)
    }

    fn __rsub__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.of_one_unit(py, &other, &DIFFERENCE, true)
    }

    fn __mul__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.times(py, &other, false)
    }

    fn __rmul__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.times(py, &other, true)
    }

    fn __truediv__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        let unit = match other.unit()? {
            None => self.1.clone(),
            Some(_) => None,
        };
        let quotient = self.by_cell(py, &other, &QUOTIENT, false)?;
        Ok(Self(quotient.0, unit))
    }

    fn __rtruediv__(&self, py: Python<'_>, other: Samples<'_>) -> PyResult<Self> {
        self.by_cell(py, &other, &QUOTIENT, true)
    }

    fn __pow__(
        &self,
        py: Python<'_>,
        other: Samples<'_>,
        modulo: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        without_modulo(modulo.as_ref())?;
        self.by_cell(py, &other, &POWER, false)
    }

    fn __rpow__(
        &self,
        py: Python<'_>,
        other: Samples<'_>,
        modulo: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        without_modulo(modulo.as_ref())?;
        self.by_cell(py, &other, &POWER, true)
    }

    fn __abs__(&self, py: Python<'_>) -> PyResult<Self> {
        let samples = self.0.as_slice().iter().map(|sample| sample.abs());
        let field = stickslip::Field::from_vec(self.0.grid(), samples.collect()).or_raise(py)?;
        Ok(Self(Arc::new(field), self.1.clone()))
    }

    fn __pos__(&self) -> Self {
        self.clone()
    }

    fn __richcmp__<'py>(
        &self,
        py: Python<'py>,
        other: &Bound<'py, PyAny>,
        comparison: CompareOp,
    ) -> PyResult<Bound<'py, PyAny>> {
        let is_equality = matches!(comparison, CompareOp::Eq | CompareOp::Ne);
        if let (true, Ok(other)) = (is_equality, other.cast::<Self>()) {
            let is_equal = self == other.get();
            let is_wanted = matches!(comparison, CompareOp::Eq);
            return Ok(PyBool::new(py, is_equal == is_wanted).to_owned().into_any());
        }
        if is_equality && !has_samples(other)? {
            return Ok(py.NotImplemented().into_bound(py));
        }
        #[expect(clippy::float_cmp, reason = "the caller asks for equal numbers")]
        let compared: fn(f64, f64) -> bool = match comparison {
            CompareOp::Eq => |own, other| own == other,
            CompareOp::Ne => |own, other| own != other,
            CompareOp::Lt => |own, other| own < other,
            CompareOp::Le => |own, other| own <= other,
            CompareOp::Gt => |own, other| own > other,
            CompareOp::Ge => |own, other| own >= other,
        };
        let other: Samples<'_> = other.extract()?;
        one_of([self.1.clone(), other.unit()?])?;
        let other = self.beside(py, &other)?;
        let pairs = self.0.as_slice().iter().zip(other.as_slice());
        let cells = pairs.map(|(own, other)| compared(*own, *other));
        Ok(mask(py, self.0.grid(), cells).0)
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

only_first_operand!(Field);

impl Stored for Field {
    type Content = (stickslip::Field, Option<String>);

    const KIND: &'static str = "Field";

    fn of_content((field, unit): Self::Content) -> Self {
        Self(Arc::new(field), unit.map(Unit::from))
    }
}

/// Operation on two samples, with the NumPy function of the same operation.
type Operation = (&'static str, fn(f64, f64) -> f64);

const SUM: Operation = ("add", |left, right| left + right);
const DIFFERENCE: Operation = ("subtract", |left, right| left - right);
const PRODUCT: Operation = ("multiply", |left, right| left * right);
const QUOTIENT: Operation = ("divide", |left, right| left / right);
const POWER: Operation = ("power", f64::powf);

impl Field {
    /// Wraps a field computed from surfaces in this unit.
    pub(crate) fn made(field: stickslip::Field, unit: Option<Unit>) -> Self {
        Self(Arc::new(field), unit)
    }

    /// Applies an operation cell by cell with a second field, whose unit must not differ.
    fn of_one_unit(
        &self,
        py: Python<'_>,
        other: &Samples<'_>,
        operation: &Operation,
        is_reflected: bool,
    ) -> PyResult<Self> {
        let unit = one_of([self.1.clone(), other.unit()?])?;
        if unit.is_some() {
            other.check_no_energies("the other operand of a field of lengths")?;
        }
        let field = self.by_cell(py, other, operation, is_reflected)?;
        Ok(Self(field.0, unit))
    }

    /// Returns the product cell by cell, with a unit if exactly one factor has a unit.
    fn times(&self, py: Python<'_>, other: &Samples<'_>, is_reflected: bool) -> PyResult<Self> {
        let unit = match (self.1.clone(), other.unit()?) {
            (Some(unit), None) | (None, Some(unit)) => Some(unit),
            _ => None,
        };
        let product = self.by_cell(py, other, &PRODUCT, is_reflected)?;
        Ok(Self(product.0, unit))
    }

    /// Applies an operation cell by cell with a second field, which is the first operand of a reflected operation. NumPy issues its
    /// warning of results that are not finite, such as quotients by zero. Missing points have none.
    fn by_cell(
        &self,
        py: Python<'_>,
        other: &Samples<'_>,
        (ufunc, operation): &Operation,
        is_reflected: bool,
    ) -> PyResult<Self> {
        let other = self.beside(py, other)?;
        let mut operands = [&*self.0, &*other];
        if is_reflected {
            operands.reverse();
        }
        let [left, right] = operands.map(stickslip::Field::as_slice);
        let pairs = || left.iter().zip(right).map(|(left, right)| (*left, *right));
        let samples = pairs().map(|(left, right)| operation(left, right));
        let samples: Vec<_> = samples.collect();
        let is_remarkable = |((left, right), sample): &((f64, f64), &f64)| {
            !(sample.is_finite() || left.is_nan() || right.is_nan())
        };
        let remarkable = pairs().zip(&samples).filter(is_remarkable);
        let (lefts, rights): (Vec<_>, Vec<_>) = remarkable.map(|(pair, _)| pair).unzip();
        if !lefts.is_empty() {
            let pairs = (lefts.into_pyarray(py), rights.into_pyarray(py));
            py.import("numpy")?.call_method1(*ufunc, pairs)?;
        }
        let field = stickslip::Field::from_vec(self.0.grid(), samples).or_raise(py)?;
        Ok(field.into())
    }

    /// Returns the second field of an operation, or an error if its grid differs.
    fn beside(&self, py: Python<'_>, other: &Samples<'_>) -> PyResult<Arc<stickslip::Field>> {
        other.only_on(py, "other field", self.0.grid())
    }
}

/// Returns whether a field is compared with an object cell by cell by ``==``: with a number, an array, a list or a tuple. Other
/// objects, such as ``None`` or text, differ from each field.
fn has_samples(object: &Bound<'_, PyAny>) -> PyResult<bool> {
    if object.is_instance_of::<PyString>() || object.hasattr("heights")? {
        return Ok(false);
    }
    let is_number = object.extract::<f64>().is_ok();
    Ok(is_number || entries(object).is_some() || object.hasattr("__array__")?)
}

/// Returns an error unless a field is on the given grid.
pub(crate) fn same_grid(
    grid: stickslip::Grid,
    found: stickslip::Grid,
    name: &'static str,
) -> stickslip::Result<()> {
    if found == grid {
        return Ok(());
    }
    // The crate accepts grids whose sides differ by round-off. It compares the grids when it computes a difference.
    let difference = stickslip::Field::zeros(grid).minus(&stickslip::Field::zeros(found));
    difference.map(|_| ()).map_err(|mut error| {
        if let Error::GridMismatch { quantity, .. } = &mut error {
            *quantity = name;
        }
        error
    })
}

/// Returns an error if the third argument of ``pow`` is given.
fn without_modulo(modulo: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
    match modulo {
        None => Ok(()),
        Some(_) => Err(PyTypeError::new_err(
            "the power of a field takes no modulus",
        )),
    }
}
