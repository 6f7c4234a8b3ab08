//! Largest pressure that the bodies can carry.

use std::sync::Arc;

use pyo3::prelude::*;
use stickslip::normal::Hardness as Limit;

use crate::argument::{Object, argument};
use crate::digits::short;
use crate::error::OrRaise;
use crate::field::Field;
use crate::grid::Grid;
use crate::normal::NormalSolution;
use crate::pickle::picklable;
use crate::samples::{Samples, Spread};

/// The largest pressure that the softer body can carry, for all cells or for each cell. Cells at this pressure yield.
///
/// Parameters
/// ----------
/// limit : float, Field or array_like of shape (ny, nx)
///     The largest pressure: one positive number, or one number per cell, not negative. A cell whose limit is zero
///     carries no load.
/// grid : Grid, optional
///     Grid of the limits; required for an array, because only a Field has its own grid.
///
/// Raises
/// ------
/// NotPositive, Sample, Shape, GridMismatch
#[pyclass(frozen, eq, module = "stickslip.normal")]
#[derive(Clone, PartialEq)]
pub(crate) struct Hardness(pub(crate) Limit);

#[pymethods]
impl Hardness {
    #[new]
    #[pyo3(signature = (limit, *, grid=None))]
    fn new(py: Python<'_>, limit: Samples<'_>, grid: Option<Object<Grid>>) -> PyResult<Self> {
        limit_of(py, &limit, grid.as_deref()).map(Self)
    }

    /// Returns the largest pressure of a cell (row-major index), or NaN if the index is out of range.
    fn of_cell(&self, index: usize) -> f64 {
        self.0.of_cell(index)
    }

    /// Returns the largest normal force that the cells of a grid can carry.
    fn capacity(&self, grid: Object<Grid>) -> f64 {
        self.0.capacity(grid.0)
    }

    /// Returns the overlap of the surfaces of a solved contact in cells whose pressure is at the limit (lengths).
    fn overlap(&self, py: Python<'_>, contact: Object<NormalSolution>) -> PyResult<Field> {
        self.0.overlap(contact.get()).or_raise(py).map(Into::into)
    }

    fn __repr__(&self) -> String {
        if self.0.of_cell(usize::MAX).is_nan() {
            "Hardness(<per cell>)".into()
        } else {
            format!("Hardness({})", short(self.0.of_cell(0)))
        }
    }
}

picklable!(Hardness: Limit);

/// Returns one largest pressure, or one per cell of a grid.
fn limit_of(py: Python<'_>, limit: &Samples<'_>, grid: Option<&Grid>) -> PyResult<Limit> {
    match limit.spread(py, "hardness", grid)? {
        Spread::Uniform(limit) => Limit::uniform(limit).or_raise(py),
        Spread::PerCell(field) => {
            let grid = field.grid();
            Limit::per_cell(Arc::unwrap_or_clone(field)).or_raise_on(py, grid)
        }
    }
}

argument! {
    /// Argument that is converted to a hardness: a Hardness, one pressure, or one pressure per cell.
    AnyHardness: Hardness; "float"
}

impl AnyHardness<'_> {
    pub(crate) fn on(self, py: Python<'_>, grid: stickslip::Grid) -> PyResult<Limit> {
        if let Ok(hardness) = self.0.cast::<Hardness>() {
            return Ok(hardness.get().0.clone());
        }
        limit_of(py, &self.0.extract()?, Some(&Grid(grid)))
    }
}
