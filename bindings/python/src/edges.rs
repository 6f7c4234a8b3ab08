//! The edges of contacts and stick zones inside the cells.

use numpy::IntoPyArray;
use numpy::PyArrayMethods;
use pyo3::prelude::*;

use crate::array::{Array, view};
use crate::digits::short;
use crate::error::OrRaise;
use crate::grid::Grid;
use crate::spots::ContactSpots;

/// The edge of a contact or of its stick zone, found inside the cells: :meth:`NormalSolution.edges`,
/// :meth:`TangentialSolution.edges` and :meth:`History.edges`.
///
/// At a distance s from a smooth edge the pressure rises as the root of s and the gap opens as its power 3/2. A quadratic is
/// fitted to the square of the one and the power 2/3 of the other in 7 x 7 cells about each cell at the edge; where it does
/// not fit, the cell keeps its own pressure and has a mean correction of its area.
#[pyclass(frozen, eq, module = "stickslip.edges")]
#[derive(Clone, PartialEq)]
pub(crate) struct Edges(pub(crate) stickslip::edges::Edges);

#[pymethods]
impl Edges {
    /// The grid of the cells.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.0.grid())
    }

    /// Area with the parts of the cells at the edge (a length squared).
    #[getter]
    fn area(&self) -> f64 {
        self.0.area()
    }

    /// The part of the cells at the edge whose fit was refused.
    #[getter]
    fn unfitted_fraction(&self) -> f64 {
        self.0.unfitted_fraction()
    }

    /// Values at the centres of all cells, shape (ny, nx): of a contact the pressure, of a stick zone what friction could
    /// still bear (pressures).
    #[getter]
    fn centres<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |edges| edges.0.centres())
    }

    /// Means of the same over the cells, shape (ny, nx).
    #[getter]
    fn means<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |edges| edges.0.means())
    }

    /// The edge as straight pieces (lengths): an array of shape (n, 2, 2), of each piece (x, y) of both ends.
    #[getter]
    fn outline<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let pieces = self.0.outline();
        let numbers: Vec<f64> = pieces.iter().flatten().flatten().copied().collect();
        let array = numbers.into_pyarray(py).reshape([pieces.len(), 2, 2])?;
        Ok(Array::of(array))
    }

    /// The indices of the cells at the edge, in the flat grid, by rising index.
    #[getter]
    fn cells<'py>(&self, py: Python<'py>) -> Array<'py, u64> {
        Array::new(py, self.0.cells().iter().map(|cell| cell.index as u64))
    }

    /// The covered parts of these cells, from 0 to 1.
    #[getter]
    fn covered<'py>(&self, py: Python<'py>) -> Array<'py> {
        Array::new(py, self.0.cells().iter().map(|cell| cell.covered))
    }

    /// Areas of the spots of the contact, in their order, with the parts of the cells at the edges (lengths squared).
    fn areas_of<'py>(&self, py: Python<'py>, spots: &ContactSpots) -> PyResult<Array<'py>> {
        let areas = self.0.areas_of(&spots.0).or_raise(py)?;
        Ok(Array::new(py, areas))
    }

    /// Whether the edge was fitted in these cells.
    #[getter]
    fn is_fitted<'py>(&self, py: Python<'py>) -> Array<'py, bool> {
        Array::new(py, self.0.cells().iter().map(|cell| cell.is_fitted))
    }

    fn __repr__(&self) -> String {
        format!(
            "Edges(area={}, {} cells, unfitted_fraction={})",
            short(self.0.area()),
            self.0.cells().len(),
            short(self.0.unfitted_fraction())
        )
    }
}

/// The edges of a contact in partial slip: of the contact and of its stick zone.
#[pyclass(frozen, eq, module = "stickslip.edges")]
#[derive(Clone, PartialEq)]
pub(crate) struct TangentialEdges(pub(crate) stickslip::edges::TangentialEdges);

#[pymethods]
impl TangentialEdges {
    /// The grid of the cells.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.0.grid())
    }

    /// The edge of the contact.
    #[getter]
    fn contact(&self) -> Edges {
        Edges(self.0.contact().clone())
    }

    /// The edge of the stick zone.
    #[getter]
    fn stick(&self) -> Edges {
        Edges(self.0.stick().clone())
    }

    /// Magnitude of the traction at the centres of the cells (a pressure), shape (ny, nx).
    #[getter]
    fn traction<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |edges| edges.0.traction())
    }

    /// Its means over the cells, shape (ny, nx).
    #[getter]
    fn mean_traction<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |edges| edges.0.mean_traction())
    }

    /// The largest traction at the centre of a cell (a pressure).
    #[getter]
    fn peak_traction(&self) -> f64 {
        self.0.peak_traction()
    }

    /// Area of the stick zone, with the parts of the cells at its edge (a length squared).
    #[getter]
    fn stick_area(&self) -> f64 {
        self.0.stick_area()
    }

    /// Area of the contact less that of the stick zone.
    #[getter]
    fn slip_area(&self) -> f64 {
        self.0.slip_area()
    }

    /// Stick area over contact area.
    #[getter]
    fn stick_ratio(&self) -> f64 {
        self.0.stick_ratio()
    }

    fn __repr__(&self) -> String {
        format!(
            "TangentialEdges(stick_ratio={}, peak_traction={})",
            short(self.0.stick_ratio()),
            short(self.0.peak_traction())
        )
    }
}
