//! Preparation of surfaces before they are pressed together.

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use stickslip::surface;

use crate::argument::Object;
use crate::conversion;
use crate::digits::{short, tuple};
use crate::error::OrRaise;
use crate::field::Field;
use crate::grid::Grid;
use crate::progress::Progress;
use crate::readers::readers;
use crate::real::Count;
use crate::samples::{Samples, one_unit};
use crate::surface::processed::processed;
use crate::unit::Unit;
use crate::work::{solve, unobserved_on};

/// Returns the sum of fields on one grid, cell by cell: the gap between two bodies is the sum of both shapes. All
/// surfaces must have the same unit.
#[pyfunction]
pub(crate) fn sum(py: Python<'_>, fields: Vec<Samples<'_>>) -> PyResult<Field> {
    let unit = one_unit(&fields.iter().collect::<Vec<_>>())?;
    let fields: Vec<_> = fields
        .iter()
        .map(|field| field.alone("field"))
        .collect::<PyResult<_>>()?;
    let fields: Vec<&stickslip::Field> = fields.iter().map(|field| &**field).collect();
    let sum = surface::sum(&fields).or_raise(py)?;
    Ok(Field::made(sum, unit))
}

/// Returns the heights turned upside down (lengths).
#[pyfunction]
pub(crate) fn inverted(heights: Samples<'_>) -> PyResult<Field> {
    let made = surface::inverted(&*heights.alone("heights")?);
    Ok(Field::made(made, heights.unit()?))
}

/// Returns the heights with x mirrored, as for a body that is turned over.
#[pyfunction]
pub(crate) fn mirror_x(heights: Samples<'_>) -> PyResult<Field> {
    let made = surface::mirror_x(&*heights.alone("heights")?);
    Ok(Field::made(made, heights.unit()?))
}

/// Returns the gap of a rough body against a flat body: the largest height minus each height (lengths, non-negative).
#[pyfunction]
pub(crate) fn gap_from_heights(py: Python<'_>, heights: Samples<'_>) -> PyResult<Field> {
    let (unit, heights) = (heights.unit()?, heights.alone("heights")?);
    let gap = surface::gap_from_heights(&heights).or_raise_on(py, heights.grid())?;
    Ok(Field::made(gap, unit))
}

/// Returns the gap between two rough bodies that touch at one point. Heights are positive outwards from their body; both
/// surfaces are given as viewed from body 1. Both surfaces must have the same unit.
#[pyfunction]
pub(crate) fn gap_between(
    py: Python<'_>,
    upper: Samples<'_>,
    lower: Samples<'_>,
) -> PyResult<Field> {
    let unit = one_unit(&[&upper, &lower])?;
    let (upper, lower) = (upper.alone("upper")?, lower.alone("lower")?);
    let gap = surface::gap_between(&upper, &lower).or_raise_on(py, upper.grid())?;
    Ok(Field::made(gap, unit))
}

/// Returns the part of a surface in the half-open ranges of columns ``columns[0]`` to ``columns[1]`` and of rows
/// ``rows[0]`` to ``rows[1]``, on a separate grid centred on the origin.
///
/// Raises
/// ------
/// Range
#[pyfunction]
pub(crate) fn crop(
    py: Python<'_>,
    heights: Samples<'_>,
    columns: conversion::Columns,
    rows: conversion::Rows,
) -> PyResult<Field> {
    let (unit, heights) = (heights.unit()?, heights.alone("heights")?);
    let cropped = surface::crop(&heights, columns.0.0..columns.0.1, rows.0.0..rows.0.1);
    Ok(Field::made(cropped.or_raise(py)?, unit))
}

/// Interpolates a surface at the cell centres of another grid, with cubic interpolation along x and y. The sides of the grid
/// are in the unit of the heights.
///
/// Raises
/// ------
/// Sample, BeyondSamples, Memory
/// ValueError
///     If the whole grid is smaller than one cell of the heights, as a grid in another unit would be.
#[pyfunction]
pub(crate) fn resample(
    py: Python<'_>,
    heights: Samples<'_>,
    grid: Object<Grid>,
) -> PyResult<Field> {
    let (unit, heights) = (heights.unit()?, heights.alone("heights")?);
    let sides =
        |grid: stickslip::Grid| [grid.nx() as f64 * grid.dx(), grid.ny() as f64 * grid.dy()];
    let (cell, whole) = ([heights.grid().dx(), heights.grid().dy()], sides(grid.0));
    if whole[0] < cell[0] && whole[1] < cell[1] {
        let unit = unit.as_deref().map(|unit| format!(", in {unit}"));
        let message = format!(
            "the sides of the grid, {}, are smaller than one cell of the heights, {}: give the grid in the unit of the heights{}",
            tuple(&whole),
            tuple(&cell),
            unit.unwrap_or_default()
        );
        return Err(PyValueError::new_err(message));
    }
    // The work is done for the cells of the new grid; wrong samples are among the given cells.
    let outcome = solve(py, grid.0.cells(), Progress::none(), |_| {
        surface::resample(&heights, grid.0)
    })?;
    let resampled = outcome.or_raise_on(py, heights.grid())?;
    Ok(Field::made(resampled, unit))
}

/// A surface whose missing heights (NaN) are filled smoothly.
#[pyclass(frozen, eq, module = "stickslip.surface")]
#[derive(PartialEq)]
pub(crate) struct Filled(surface::Filled, Option<Unit>);

processed! { Filled: surface::Filled;
    /// All heights (lengths).
}

readers! { Filled.0:
    /// Number of heights that were missing.
    filled_cells(): usize,
}

#[pymethods]
impl Filled {
    fn __repr__(&self) -> String {
        format!("Filled(filled_cells={})", self.0.filled_cells())
    }
}

/// Fills missing heights, which are NaN, with the smoothest surface through the rim of each hole (Laplace's equation).
///
/// Raises
/// ------
/// Sample
///     If a height is infinite.
/// Undetermined
///     If all heights are missing.
/// NotConverged
#[pyfunction]
pub(crate) fn fill_missing(py: Python<'_>, heights: Samples<'_>) -> PyResult<Filled> {
    let (unit, heights) = (heights.unit()?, heights.alone("heights")?);
    let filled = unobserved_on(py, heights.grid(), || surface::fill_missing(&heights))?;
    Ok(Filled(filled, unit))
}

/// A surface without its form.
#[pyclass(frozen, eq, module = "stickslip.surface")]
#[derive(PartialEq)]
pub(crate) struct Levelled(surface::Levelled, Option<Unit>);

processed! { Levelled: surface::Levelled;
    /// The remaining heights (lengths).
}

#[pymethods]
impl Levelled {
    /// The removed form (lengths).
    #[getter]
    fn form(&self) -> Field {
        self.with_unit(self.0.form())
    }

    fn __repr__(&self) -> String {
        let (low, high) = (self.0.heights().min(), self.0.heights().max());
        format!("Levelled(heights from {} to {})", short(low), short(high))
    }
}

/// Returns the form to be removed: "mean", "plane", or the degree of a polynomial.
fn form_of(form: &Bound<'_, PyAny>) -> PyResult<surface::Form> {
    // A truth value is not a degree.
    if let Ok(Count(degree)) = form.extract() {
        return Ok(surface::Form::Polynomial(degree));
    }
    match form.extract::<String>().as_deref() {
        Ok("mean") => Ok(surface::Form::Mean),
        Ok("plane") => Ok(surface::Form::Plane),
        _ => Err(PyTypeError::new_err(format!(
            "form must be 'mean', 'plane' or the degree of a polynomial, got {}",
            form.repr()?
        ))),
    }
}

/// Removes a form from a surface by least squares.
///
/// Parameters
/// ----------
/// heights : Field or topography
///     The heights (lengths).
/// form : "mean", "plane" or int
///     The form; a number is the degree of a polynomial in x and y.
///
/// Raises
/// ------
/// Degree, Sample, Undetermined
#[pyfunction]
pub(crate) fn level(
    py: Python<'_>,
    heights: Samples<'_>,
    form: Bound<'_, PyAny>,
) -> PyResult<Levelled> {
    let (unit, heights) = (heights.unit()?, heights.alone("heights")?);
    let form = form_of(&form)?;
    let levelled = unobserved_on(py, heights.grid(), || surface::level(&heights, form))?;
    Ok(Levelled(levelled, unit))
}
