//! Edges of contacts and stick zones with sub-cell resolution.

use numpy::IntoPyArray;
use numpy::PyArrayMethods;
use pyo3::prelude::*;

use crate::argument::Object;
use crate::array::{Array, view};
use crate::digits::short;
use crate::error::OrRaise;
use crate::grid::Grid;
use crate::pickle::picklable;
use crate::readers::readers;
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

readers! { Edges.0:
    /// Grid of the cells.
    grid(): Grid => Grid,
    /// Area of the contact or stick zone, with the covered parts of the cells at the edge (a length squared).
    area(): f64,
    /// Fraction of the cells at the edge whose fit was rejected.
    unfitted_fraction(): f64,
}

#[pymethods]
impl Edges {
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
    fn areas_of<'py>(&self, py: Python<'py>, spots: Object<ContactSpots>) -> PyResult<Array<'py>> {
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

readers! { TangentialEdges.0:
    /// Grid of the cells.
    grid(): Grid => Grid,
    /// The largest traction at the centre of a cell (a pressure).
    peak_traction(): f64,
    /// Area of the stick zone, with the covered parts of the cells at its edge (a length squared).
    stick_area(): f64,
    /// Contact area minus stick area.
    slip_area(): f64,
    /// Ratio of stick area to contact area.
    stick_ratio(): f64,
}

#[pymethods]
impl TangentialEdges {
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

    fn __repr__(&self) -> String {
        format!(
            "TangentialEdges(stick_ratio={}, peak_traction={})",
            short(self.0.stick_ratio()),
            short(self.0.peak_traction())
        )
    }
}

picklable!(TangentialEdges: stickslip::edges::TangentialEdges);
