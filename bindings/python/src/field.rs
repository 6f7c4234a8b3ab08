//! Fields on a grid and arguments that are converted to fields.

use std::sync::Arc;

use numpy::{IntoPyArray, PyUntypedArray};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::pyclass::CompareOp;
use pyo3::types::{PyBool, PyDict, PyFloat, PyTuple};
use stickslip::Error;

use crate::argument::{Object, argument};
use crate::array::{Array, mask, view};
use crate::conversion::{entries, kind_of};
use crate::digits::short;
use crate::error::OrRaise;
use crate::grid::{Grid, size};
use crate::pickle::{Reduced, Stored, reduced};
use crate::real::{
    Count, by_axis, check_coordinates, in_axes, is_no_mask, is_no_truth_value, is_real, misshapen,
    plane, shape_error, unnamed, wrong_type,
};
use crate::unit::{Unit, factor, is_same, known, of_next_gap, one_of};
use crate::xarray::only_first_operand;

/// Samples at the cells of a grid, one number per cell, such as gaps, heights or pressures. A field is immutable.
///
/// Every argument that accepts a field also accepts an array of shape (ny, nx), which is copied. A Field is created once
/// and shared, so repeated calls copy nothing. ``numpy.asarray(field)`` is a read-only view of a field, and
/// ``field[iy, ix]`` is a sample. A sum, difference, product, quotient or power with a field, an array or a number, in
/// either order, is computed cell by cell and is a field. A quotient by zero, and any other result that is not finite, issues the
/// warning of NumPy. A comparison by ``<``, ``<=``, ``>`` or ``>=`` is an array of booleans. Two fields are compared as a whole by
/// ``==``. Other NumPy functions, such as ``numpy.maximum``, treat a field as its array: their result has no unit, and fields of
/// different units raise an error. The axes of an array of xarray with the
/// dimensions x and y are recognised by their names, also by NumPy functions of a field. Its coordinates x and y, if any, must rise in
/// steps of the cell sides. Dimensions of other names raise an error if they have coordinates. The labels of a DataFrame of pandas are
/// either such coordinates, whole numbers that rise in steps of one, or names. Its rows are y and its columns x. Other labels, such as
/// those of a reversed, shuffled or transposed table, raise an error. Masked cells and the value ``NA`` of pandas are missing points
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
        grid: Object<Grid>,
        samples: Samples<'_>,
        unit: Option<&str>,
    ) -> PyResult<Self> {
        is_no_truth_value(&samples.0, "samples")?;
        let unit = one_of([unit.map(known).transpose()?, samples.unit()?])?;
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
    fn array<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
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
        let output = kwargs
            .as_ref()
            .and_then(|kwargs| kwargs.get_item("out").ok().flatten());
        let outputs = output.map(|output| output.try_iter()?.collect::<PyResult<Vec<_>>>());
        let is_changed = |place: &Bound<'py, PyAny>| place.cast::<Self>().is_ok();
        let is_output = outputs
            .transpose()?
            .is_some_and(|all| all.iter().any(is_changed));
        if is_output || method == "at" && inputs.first().is_some_and(is_changed) {
            return Err(unnamed(
                slf.py(),
                "ArgumentType",
                "a Field does not change: give numpy.array(field), a copy, as the output",
            ));
        }
        let name: String = ufunc.getattr("__name__")?.extract()?;
        if let ("__call__", [left, right], None) = (method, &inputs[..], &kwargs) {
            let reflected = match &name[..] {
                "add" => Some("__radd__"),
                "subtract" => Some("__rsub__"),
                "multiply" => Some("__rmul__"),
                "divide" | "true_divide" => Some("__rtruediv__"),
                "power" => Some("__rpow__"),
                _ => None,
            };
            if let Some(reflected) = reflected.filter(|_| right.is(slf)) {
                return slf.call_method1(reflected, (left,));
            }
        }
        if method == "__call__" {
            on_one_grid(slf.py(), &inputs)?;
        }
        if !IGNORE_UNITS.contains(&&name[..]) {
            one_of(
                inputs
                    .iter()
                    .map(|input| field_of(input).and_then(|field| field.1)),
            )?;
        }
        let grid = slf.get().0.grid();
        let arrays = inputs.into_iter().map(|input| match input.cast::<Self>() {
            Ok(field) => Ok(Self::array(field).0),
            Err(_) => in_axes(&input, "operand", Some([grid.dx(), grid.dy()])),
        });
        let arrays = PyTuple::new(slf.py(), arrays.collect::<PyResult<Vec<_>>>()?)?;
        ufunc.getattr(method)?.call(arrays, kwargs.as_ref())
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
        let compared: fn(f64, f64) -> bool = match comparison {
            CompareOp::Eq | CompareOp::Ne => {
                let Ok(other) = other.cast::<Self>() else {
                    return Ok(py.NotImplemented().into_bound(py));
                };
                let is_equal = self == other.get();
                let is_wanted = matches!(comparison, CompareOp::Eq);
                return Ok(PyBool::new(py, is_equal == is_wanted).to_owned().into_any());
            }
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

/// Returns the result of a NumPy function of the samples. Without arguments, it is the result of the crate, if there is one.
fn reduced_by<'py>(
    slf: &Bound<'py, Field>,
    function: &str,
    plain: Option<fn(&stickslip::Field) -> f64>,
    arguments: &Bound<'py, PyTuple>,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = slf.py();
    let is_none = |(_, value): (_, Bound<'py, PyAny>)| value.is_none();
    let is_plain =
        arguments.is_empty() && options.is_none_or(|options| options.iter().all(is_none));
    if let Some(plain) = plain.filter(|_| is_plain) {
        return Ok(PyFloat::new(py, plain(&slf.get().0)).into_any());
    }
    let samples = std::iter::once(Field::array(slf).0);
    let all: Vec<_> = samples.chain(arguments.iter()).collect();
    let function = py.import("numpy")?.getattr(function)?;
    function.call(PyTuple::new(py, all)?, options)
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

argument! {
    /// Argument that is converted to a field: a field, an array of shape (ny, nx), one number for all cells, or a
    /// topography object with heights and sizes.
    Samples: Field
}

impl Samples<'_> {
    /// Returns the samples as a field on this grid. A field on a different grid is passed on unchanged; the crate then
    /// rejects it and names both grids.
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
                 convert it to a gap by surface.gap_from_heights(topography)"
            )));
        }
        if self.has_heights() {
            // The heights themselves as a gap would press the valleys together instead of the peaks.
            let remedy = match quantity {
                "gap" => "convert them to a gap by surface.gap_from_heights(rough.heights)",
                _ => "give its .heights",
            };
            return Err(PyTypeError::new_err(format!(
                "{quantity} is a {}, which has heights: {remedy}",
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
        check_coordinates(&self.0, quantity, Some([grid.dx(), grid.dy()]))?;
        let samples = match samples.as_slice() {
            Some(samples) => samples.to_vec(),
            None => samples.iter().copied().collect(),
        };
        // The crate rejects a grid of the array that differs from the grid of the call.
        let grid = self.own_grid().unwrap_or(grid);
        let field = stickslip::Field::from_vec(grid, samples).or_raise(py)?;
        Ok(Arc::new(field))
    }

    /// Returns the samples as a field on this grid, as [`on`](Self::on), but rejects a field on a different grid.
    pub(crate) fn only_on(
        &self,
        py: Python<'_>,
        quantity: &'static str,
        grid: stickslip::Grid,
    ) -> PyResult<Arc<stickslip::Field>> {
        let field = self.on(py, quantity, grid)?;
        same_grid(grid, field.grid(), quantity).or_raise(py)?;
        Ok(field)
    }

    /// Returns the samples as a field on this grid, as [`on`](Self::on), but rejects a single number. For a gap or a pressure, a
    /// number is more likely the next argument, such as a coefficient of friction, than a uniform field.
    pub(crate) fn per_cell(
        &self,
        py: Python<'_>,
        quantity: &str,
        grid: stickslip::Grid,
    ) -> PyResult<Arc<stickslip::Field>> {
        self.per_cell_or(py, quantity, grid, "")
    }

    /// Returns the samples as a gap with its unit, as [`per_cell`](Self::per_cell).
    pub(crate) fn gap(&self, py: Python<'_>, grid: stickslip::Grid) -> PyResult<Field> {
        Ok(Field(self.per_cell(py, "gap", grid)?, self.unit()?))
    }

    /// Returns the samples as a gap, as [`gap`](Self::gap), of a constructor whose next argument is friction.
    pub(crate) fn gap_before_friction(
        &self,
        py: Python<'_>,
        grid: stickslip::Grid,
    ) -> PyResult<Field> {
        let gap = self.per_cell_or(py, "gap", grid, ", and friction after the gap")?;
        Ok(Field(gap, self.unit()?))
    }

    /// Returns the samples as a gap that replaces a gap of this unit, or an error if the units differ.
    pub(crate) fn next_gap(
        &self,
        py: Python<'_>,
        grid: stickslip::Grid,
        last: Option<&Unit>,
    ) -> PyResult<Field> {
        let Field(gap, unit) = self.gap(py, grid)?;
        Ok(Field(gap, of_next_gap(last, unit)?))
    }

    /// Returns the samples as [`per_cell`](Self::per_cell), with an addition to the remedy for a single number.
    fn per_cell_or(
        &self,
        py: Python<'_>,
        quantity: &str,
        grid: stickslip::Grid,
        order: &str,
    ) -> PyResult<Arc<stickslip::Field>> {
        if let Some(number) = self.number() {
            let message = format!(
                "must be a Field or an array of shape (ny, nx), got the number {}: for a uniform {quantity} give Field(grid, {0}){order}",
                short(number)
            );
            return Err(wrong_type(py, quantity, &message));
        }
        is_no_mask(&self.0, quantity)?;
        self.on(py, quantity, grid)
    }

    /// Returns the samples as a field on this grid, as [`on`](Self::on), but rejects a single number and an array of one number
    /// on a larger grid. Such a number is more likely the total or the largest value of a quantity that differs between cells.
    pub(crate) fn of_each_cell(
        &self,
        py: Python<'_>,
        quantity: &str,
        grid: stickslip::Grid,
        remedy: &str,
    ) -> PyResult<Arc<stickslip::Field>> {
        // Arrays of NumPy with one entry have this method.
        let entry = || self.0.call_method0("item").ok()?.extract().ok();
        let number: Option<f64> = self.number().or_else(entry);
        match number.filter(|_| grid.cells() > 1) {
            Some(number) => {
                let message = format!(
                    "{quantity} is the number {}, expected an array of shape (ny, nx) = {:?}: {remedy}",
                    short(number),
                    (grid.ny(), grid.nx())
                );
                let shape: Option<Vec<usize>> = self
                    .0
                    .getattr("shape")
                    .and_then(|shape| shape.extract())
                    .ok();
                Err(shape_error(
                    py,
                    quantity,
                    grid,
                    &shape.unwrap_or_default(),
                    &message,
                ))
            }
            None => self.on(py, quantity, grid),
        }
    }

    /// Returns the single number, if the argument is one. An array with one entry gives no value for other cells.
    pub(crate) fn number(&self) -> Option<f64> {
        let dimensions = self.0.getattr("ndim").and_then(|count| count.extract());
        let is_array = dimensions.is_ok_and(|count: usize| count > 0);
        if is_array {
            None
        } else {
            self.0.extract().ok()
        }
    }

    /// Returns the shape of an array.
    pub(crate) fn shape(&self) -> Option<(usize, usize)> {
        by_axis(&self.0).ok()?.getattr("shape").ok()?.extract().ok()
    }

    /// Returns one number or a field on this grid; without a grid, on the field's own grid. A field on a different grid is
    /// rejected.
    pub(crate) fn spread(
        &self,
        py: Python<'_>,
        quantity: &'static str,
        grid: Option<&Grid>,
    ) -> PyResult<Spread> {
        is_real(&self.0, quantity)?;
        is_no_mask(&self.0, quantity)?;
        match self.number() {
            Some(value) => Ok(Spread::Uniform(value)),
            None => self
                .only_on(py, quantity, grid_of(grid, &[self])?)
                .map(Spread::PerCell),
        }
    }

    /// Returns the samples as a field on their own grid.
    pub(crate) fn alone(&self, quantity: &str) -> PyResult<Arc<stickslip::Field>> {
        self.alone_or(quantity, ": create a Field by Field(grid, array)")
    }

    /// Returns the samples as [`alone`](Self::alone), with the remedy for an array.
    pub(crate) fn alone_or(&self, quantity: &str, remedy: &str) -> PyResult<Arc<stickslip::Field>> {
        self.known()?.ok_or_else(|| {
            let instead = if self.has_heights() {
                format!(", got {}: give its .heights", kind_of(&self.0))
            } else if self.0.hasattr("dims").unwrap_or(false) {
                ": convert an array of xarray by io.from_xarray(array)".into()
            } else {
                remedy.into()
            };
            PyTypeError::new_err(format!(
                "{quantity} must be a Field or a topography, which contain their grid{instead}"
            ))
        })
    }

    /// Returns the unit of the lengths of a field, a topography or an array of xarray, if it states one. The unit of another
    /// quantity, such as a pressure, is ignored.
    pub(crate) fn unit(&self) -> PyResult<Option<Unit>> {
        if let Ok(field) = self.0.cast::<Field>() {
            return Ok(field.get().1.clone());
        }
        if self.0.hasattr("dims")? && self.0.hasattr("attrs")? {
            let unit = self.0.getattr("attrs")?.call_method1("get", ("units",))?;
            return Ok(unit
                .extract()
                .ok()
                .and_then(|unit: String| known(&unit).ok()));
        }
        if !self.is_topography()? || !self.0.hasattr("unit")? {
            return Ok(None);
        }
        let unit = self.0.getattr("unit")?;
        if unit.is_none() {
            return Ok(None);
        }
        known(unit.str()?.to_str()?).map(Some)
    }

    /// Returns the grid of an array that contains it, as the array of the energies of cells.
    fn own_grid(&self) -> Option<stickslip::Grid> {
        let array = self.0.cast::<PyUntypedArray>().ok()?;
        let grid = array.getattr("grid").ok()?;
        grid.cast::<Grid>().ok().map(|grid| grid.get().0)
    }

    fn field(&self) -> Option<Arc<stickslip::Field>> {
        let field = self.0.cast::<Field>().ok()?;
        Some(Arc::clone(&field.get().0))
    }

    /// Returns whether the object is a rough, filled or levelled surface of the package, which has heights.
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
        match self.own_grid() {
            Some(grid) => self.on(self.0.py(), "samples", grid).map(Some),
            None => Ok(None),
        }
    }
}

/// Returns the common unit of surfaces, or an error if two units differ. Surfaces without a unit are ignored.
pub(crate) fn one_unit(fields: &[&Samples<'_>]) -> PyResult<Option<Unit>> {
    let units: PyResult<Vec<_>> = fields.iter().map(|field| field.unit()).collect();
    one_of(units?)
}

/// One number for all cells, or one number per cell.
pub(crate) enum Spread {
    Uniform(f64),
    PerCell(Arc<stickslip::Field>),
}

/// Returns the given grid, or the grid of the first field that has one.
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
        "an array does not contain the sides of its cells: give grid= (such as history.grid or solution.grid), or a Field",
    ))
}
