//! Individual contact spots.

use pyo3::prelude::*;

use crate::array::{Array, labels};
use crate::digits::{counted, short, tuple};
use crate::grid::Grid;
use crate::pickle::picklable;
use crate::sequence::{Entries, entry, pair};

/// A connected spot of contact cells.
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, PartialEq)]
pub(crate) struct Spot(stickslip::Spot);

#[pymethods]
impl Spot {
    /// Number of cells of the spot.
    #[getter]
    fn cells(&self) -> usize {
        self.0.cells
    }

    /// Area of the spot (a length squared).
    #[getter]
    fn area(&self) -> f64 {
        self.0.area
    }

    /// Force that the spot carries.
    #[getter]
    fn load(&self) -> f64 {
        self.0.load
    }

    /// Ratio of load to area.
    #[getter]
    fn mean_pressure(&self) -> f64 {
        self.0.mean_pressure
    }

    /// Largest pressure in the spot.
    #[getter]
    fn max_pressure(&self) -> f64 {
        self.0.max_pressure
    }

    /// Mean position of the cells (lengths).
    #[getter]
    fn centroid(&self) -> (f64, f64) {
        pair(self.0.centroid)
    }

    /// Length of the edge of the spot along the sides of cells.
    #[getter]
    fn perimeter(&self) -> f64 {
        self.0.perimeter
    }

    /// Ratio of stick cells to all cells of the spot; ``None`` without a tangential contact.
    #[getter]
    fn stick_ratio(&self) -> Option<f64> {
        self.0.stick_ratio
    }

    fn __repr__(&self) -> String {
        format!(
            "Spot(cells={}, load={}, centroid={})",
            self.0.cells,
            short(self.0.load),
            tuple(&self.0.centroid)
        )
    }
}

picklable!(Spot: stickslip::Spot);

/// The connected spots of a contact: a sequence of :class:`Spot`.
#[pyclass(frozen, eq, module = "stickslip", sequence)]
#[derive(PartialEq)]
pub(crate) struct ContactSpots(pub(crate) stickslip::ContactSpots);

picklable!(ContactSpots: stickslip::ContactSpots);

impl ContactSpots {
    pub(crate) fn of(spots: stickslip::ContactSpots) -> Self {
        Self(spots)
    }
}

#[pymethods]
impl ContactSpots {
    /// Number of the spot of each cell, counted from 1, of shape (ny, nx); 0 outside the contact.
    #[getter]
    fn labels<'py>(&self, py: Python<'py>) -> Array<'py, u32> {
        labels(py, self.0.grid(), self.0.labels())
    }

    /// Grid of the labels.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.0.grid())
    }

    /// The spot with the largest area.
    #[getter]
    fn largest(&self) -> Option<Spot> {
        self.0.largest().copied().map(Spot)
    }

    fn __len__(&self) -> usize {
        self.0.as_slice().len()
    }

    fn __iter__(&self) -> Entries<Spot> {
        Entries::of(self.0.as_slice(), Spot)
    }

    fn __getitem__(&self, index: isize) -> PyResult<Spot> {
        entry(self.0.as_slice(), index, "spot").copied().map(Spot)
    }

    fn __repr__(&self) -> String {
        format!("ContactSpots({})", counted(self.0.as_slice().len(), "spot"))
    }
}
