//! Individual contact spots.

use pyo3::prelude::*;

use crate::array::{Array, labels};
use crate::digits::{counted, short, tuple};
use crate::grid::Grid;
use crate::pickle::picklable;
use crate::readers::{frame, readers, record};
use crate::sequence::{Entries, entry, pair};

/// A connected spot of contact cells.
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, PartialEq)]
pub(crate) struct Spot(stickslip::Spot);

readers! { Spot.0:
    /// Number of cells of the spot.
    cells: usize,
    /// Area of the spot (a length squared).
    area: f64,
    /// Force that the spot carries.
    load: f64,
    /// Ratio of load to area.
    mean_pressure: f64,
    /// Largest pressure in the spot.
    max_pressure: f64,
    /// Mean position of the cells (lengths).
    centroid: (f64, f64) => pair,
    /// Length of the edge of the spot along the sides of cells.
    perimeter: f64,
    /// Ratio of stick cells to all cells of the spot; ``None`` without a tangential contact.
    stick_ratio: Option<f64>,
}

#[pymethods]
impl Spot {
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

record!(Spot: cells, area, load, mean_pressure, max_pressure, centroid, perimeter, stick_ratio);

/// The connected spots of a contact: a sequence of :class:`Spot`.
#[pyclass(frozen, eq, module = "stickslip", sequence)]
#[derive(PartialEq)]
pub(crate) struct ContactSpots(pub(crate) stickslip::ContactSpots);

picklable!(ContactSpots: stickslip::ContactSpots);

frame!(ContactSpots, columns:
    cells, area, load, mean_pressure, max_pressure, centroid, perimeter, stick_ratio);

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
