//! Edges of contacts and stick zones with sub-cell resolution.

use numpy::IntoPyArray;
use numpy::PyArrayMethods;
use pyo3::prelude::*;

use crate::array::{Array, view};
use crate::digits::short;
use crate::error::OrRaise;
use crate::grid::Grid;
use crate::pickle::picklable;
use crate::spots::ContactSpots;

/// The edge of a contact or of its stick zone with sub-cell resolution, returned by :meth:`NormalSolution.edges`,
/// :meth:`TangentialSolution.edges` and :meth:`History.edges`.
///
/// At a distance s from a smooth edge, the pressure is proportional to the square root of s and the gap to s to the
/// power 3/2. In 7 x 7 cells about each cell at the edge, one quadratic function is fitted to the square of the
/// pressure and to the gap to the power 2/3. If the fit is rejected, the cell keeps its computed pressure, and its area
/// is corrected by a mean value.
#[pyclass(frozen, eq, module = "stickslip.edges")]
#[derive(Clone, PartialEq)]
pub(crate) struct Edges(pub(crate) stickslip::edges::Edges);

#[pymethods]
impl Edges {
    /// Grid of the cells.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.0.grid())
    }

    /// Area of the contact or stick zone, with the covered parts of the cells at the edge (a length squared).
    #[getter]
    fn area(&self) -> f64 {
        self.0.area()
    }

    /// Fraction of the cells at the edge whose fit was rejected.
    #[getter]
    fn unfitted_fraction(&self) -> f64 {
        self.0.unfitted_fraction()
    }

    /// Values at the centres of all cells, shape (ny, nx): the pressure for a contact, or the margin to the friction
    /// limit for a stick zone (pressures).
    #[getter]
    fn centres<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |edges| edges.0.centres())
    }

    /// Mean values over the cells, shape (ny, nx), of the quantity of :attr:`centres`.
    #[getter]
    fn means<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |edges| edges.0.means())
    }

    /// The edge as line segments (lengths): an array of shape (n, 2, 2), with the coordinates (x, y) of both ends of each
    /// segment.
    #[getter]
    fn outline<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let pieces = self.0.outline();
        let numbers: Vec<f64> = pieces.iter().flatten().flatten().copied().collect();
        let array = numbers.into_pyarray(py).reshape([pieces.len(), 2, 2])?;
        Ok(Array::of(array))
    }

    /// Flat indices of the cells at the edge, in increasing order.
    #[getter]
    fn cells<'py>(&self, py: Python<'py>) -> Array<'py, u64> {
        Array::new(py, self.0.cells().iter().map(|cell| cell.index as u64))
    }

    /// Covered fraction of each cell of :attr:`cells`, from 0 to 1.
    #[getter]
    fn covered<'py>(&self, py: Python<'py>) -> Array<'py> {
        Array::new(py, self.0.cells().iter().map(|cell| cell.covered))
    }

    /// Returns the areas of the contact spots, in their order, with the covered parts of the cells at the edges (lengths
    /// squared).
    fn areas_of<'py>(&self, py: Python<'py>, spots: &ContactSpots) -> PyResult<Array<'py>> {
        let areas = self.0.areas_of(&spots.0).or_raise(py)?;
        Ok(Array::new(py, areas))
    }

    /// Whether the edge was fitted, for each cell of :attr:`cells`.
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

picklable!(Edges: stickslip::edges::Edges);

/// The edges of a contact in partial slip and of its stick zone.
#[pyclass(frozen, eq, module = "stickslip.edges")]
#[derive(Clone, PartialEq)]
pub(crate) struct TangentialEdges(pub(crate) stickslip::edges::TangentialEdges);

#[pymethods]
impl TangentialEdges {
    /// Grid of the cells.
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

    /// Means of the traction over the cells, shape (ny, nx).
    #[getter]
    fn mean_traction<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |edges| edges.0.mean_traction())
    }

    /// The largest traction at the centre of a cell (a pressure).
    #[getter]
    fn peak_traction(&self) -> f64 {
        self.0.peak_traction()
    }

    /// Area of the stick zone, with the covered parts of the cells at its edge (a length squared).
    #[getter]
    fn stick_area(&self) -> f64 {
        self.0.stick_area()
    }

    /// Contact area minus stick area.
    #[getter]
    fn slip_area(&self) -> f64 {
        self.0.slip_area()
    }

    /// Ratio of stick area to contact area.
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

picklable!(TangentialEdges: stickslip::edges::TangentialEdges);
