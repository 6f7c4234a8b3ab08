//! What is done to surfaces before they are pressed together.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use stickslip::surface;

use crate::conversion;
use crate::digits::short;
use crate::error::OrRaise;
use crate::field::{Field, Samples, one_unit};
use crate::grid::Grid;
use crate::progress::Progress;
use crate::unit::Unit;
use crate::work::{solve, unobserved_on};

/// The sum of fields on one grid, cell by cell: the gap between two bodies is the sum of both shapes. Surfaces must be in
/// one unit.
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

/// Heights turned upside down (lengths).
#[pyfunction]
pub(crate) fn inverted(heights: Samples<'_>) -> PyResult<Field> {
    let made = surface::inverted(&*heights.alone("heights")?);
    Ok(Field::made(made, heights.unit()?))
}

/// Heights with x mirrored, as the surface of a body that is turned over is seen.
#[pyfunction]
pub(crate) fn mirror_x(heights: Samples<'_>) -> PyResult<Field> {
    let made = surface::mirror_x(&*heights.alone("heights")?);
    Ok(Field::made(made, heights.unit()?))
}

/// The gap of a rough body against a flat one: the largest height less each height (lengths, non-negative).
#[pyfunction]
pub(crate) fn gap_from_heights(py: Python<'_>, heights: Samples<'_>) -> PyResult<Field> {
    let (unit, heights) = (heights.unit()?, heights.alone("heights")?);
    let gap = surface::gap_from_heights(&heights).or_raise_on(py, heights.grid())?;
    Ok(Field::made(gap, unit))
}

/// The gap between two rough bodies, touching at one point. Heights point out of their body, both as seen from body 1.
/// Surfaces must be in one unit.
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

/// The part of a surface in the columns ``columns[0]`` to before ``columns[1]`` and the rows ``rows[0]`` to before
/// ``rows[1]``, on a grid of its own around the origin.
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

/// A surface at the cell centres of another grid, by cubic interpolation along x and y.
///
/// Raises
/// ------
/// Sample, BeyondSamples, Memory
#[pyfunction]
pub(crate) fn resample(py: Python<'_>, heights: Samples<'_>, grid: &Grid) -> PyResult<Field> {
    let (unit, heights) = (heights.unit()?, heights.alone("heights")?);
    // The work is that of the cells made, and what is wrong lies in those given.
    let outcome = solve(py, grid.0.cells(), Progress::none(), |_| {
        surface::resample(&heights, grid.0)
    })?;
    let resampled = outcome.or_raise_on(py, heights.grid())?;
    Ok(Field::made(resampled, unit))
}

/// A surface whose missing heights (NaN) are filled smoothly.
#[pyclass(frozen, module = "stickslip.surface")]
pub(crate) struct Filled(surface::Filled, Option<Unit>);

#[pymethods]
impl Filled {
    /// All heights (lengths).
    #[getter]
    fn heights(&self) -> Field {
        Field::made(self.0.heights().clone(), self.1.clone())
    }

    /// How many were missing.
    #[getter]
    fn filled_cells(&self) -> usize {
        self.0.filled_cells()
    }

    fn __repr__(&self) -> String {
        format!("Filled(filled_cells={})", self.0.filled_cells())
    }
}

/// Fills missing heights, which are NaN, by the smoothest surface through the rim of each hole (Laplace's equation).
///
/// Raises
/// ------
/// Sample
///     For an infinite height.
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
#[pyclass(frozen, module = "stickslip.surface")]
pub(crate) struct Levelled(surface::Levelled, Option<Unit>);

#[pymethods]
impl Levelled {
    /// The heights left (lengths).
    #[getter]
    fn heights(&self) -> Field {
        Field::made(self.0.heights().clone(), self.1.clone())
    }

    /// What was taken off (lengths).
    #[getter]
    fn form(&self) -> Field {
        Field::made(self.0.form().clone(), self.1.clone())
    }

    fn __repr__(&self) -> String {
        let (low, high) = (self.0.heights().min(), self.0.heights().max());
        format!("Levelled(heights from {} to {})", short(low), short(high))
    }
}

/// The form to be taken off: "mean", "plane", or the degree of a polynomial.
fn form_of(form: &Bound<'_, PyAny>) -> PyResult<surface::Form> {
    if let Ok(degree) = form.extract::<usize>() {
        return Ok(surface::Form::Polynomial(degree));
    }
    match form.extract::<String>().as_deref() {
        Ok("mean") => Ok(surface::Form::Mean),
        Ok("plane") => Ok(surface::Form::Plane),
        _ => Err(PyTypeError::new_err(
            "form must be 'mean', 'plane' or the degree of a polynomial",
        )),
    }
}

/// Takes a form off a surface, by least squares.
///
/// Parameters
/// ----------
/// heights : Field or topography
///     Lengths.
/// form : "mean", "plane" or int
///     A number is the degree of a polynomial in x and y.
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
