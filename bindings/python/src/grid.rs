//! Grids of rectangular cells.

use std::hash::{DefaultHasher, Hash, Hasher};

use pyo3::prelude::*;
use pyo3::types::PySlice;

use crate::argument::by_value;
use crate::array::Array;
use crate::digits::short;
use crate::error::OrRaise;
use crate::pickle::picklable;
use crate::readers::readers;
use crate::real::{Count, Real};

/// A rectangular grid of equal cells, centred on the origin.
///
/// Parameters
/// ----------
/// nx, ny : int
///     Number of cells along x and y, at least one.
/// dx, dy : float
///     Sides of a cell along x and y (lengths), positive.
///
/// Raises
/// ------
/// GridSize, NotPositive
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(128, 0.4e-3)
/// >>> grid.shape, grid.dx
/// ((128, 128), 3.125e-06)
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Grid(pub(crate) stickslip::Grid);

readers! { Grid.0:
    /// Number of cells along x.
    nx(): usize,
    /// Number of cells along y.
    ny(): usize,
    /// Side of a cell along x (a length).
    dx(): f64,
    /// Side of a cell along y (a length).
    dy(): f64,
    /// Number of cells.
    cells(): usize,
    /// Area of a cell (a length squared).
    cell_area(): f64,
    /// Area of all cells (a length squared).
    area(): f64,
    /// The whole grid if this grid is a slab of its rows, created by :meth:`HalfSpace.distributed`; otherwise this grid.
    whole(): Self => Self,
}

by_value!(Grid);

#[pymethods]
impl Grid {
    #[new]
    fn new(py: Python<'_>, nx: Count, ny: Count, dx: Real, dy: Real) -> PyResult<Self> {
        stickslip::Grid::new(nx.0, ny.0, dx.0, dy.0)
            .or_raise(py)
            .map(Self)
    }

    /// Returns a grid of ``n`` x ``n`` square cells. The argument ``side`` (a length) is the side of the grid, not of a
    /// cell.
    #[staticmethod]
    fn square(py: Python<'_>, n: Count, side: Real) -> PyResult<Self> {
        stickslip::Grid::square(n.0, side.0).or_raise(py).map(Self)
    }

    /// Returns a line of ``n`` cells along x, each ``dx`` long and one unit of length wide. Forces are then per unit
    /// length. The argument ``dx`` is the side of a cell, and not of the grid as ``side`` of :meth:`square`.
    #[staticmethod]
    fn line(py: Python<'_>, n: Count, dx: Real) -> PyResult<Self> {
        stickslip::Grid::line(n.0, dx.0).or_raise(py).map(Self)
    }

    /// Shape of the arrays on the grid, (ny, nx).
    #[getter]
    pub(crate) fn shape(&self) -> (usize, usize) {
        (self.0.ny(), self.0.nx())
    }

    /// Coordinates of the cell centres along x (lengths).
    #[getter]
    fn x<'py>(&self, py: Python<'py>) -> Array<'py> {
        Array::new(py, (0..self.0.nx()).map(|ix| self.0.x(ix)))
    }

    /// Coordinates of the cell centres along y (lengths).
    #[getter]
    fn y<'py>(&self, py: Python<'py>) -> Array<'py> {
        Array::new(py, (0..self.0.ny()).map(|iy| self.0.y(iy)))
    }

    /// Edges of the grid ``(left, right, bottom, top)`` (lengths), in the order of ``extent`` of matplotlib's ``imshow``.
    #[getter]
    fn extent(&self) -> (f64, f64, f64, f64) {
        let x = 0.5 * self.0.dx() * self.0.nx() as f64;
        let y = |row: usize| (row as f64 - 0.5 * self.0.whole().ny() as f64) * self.0.dy();
        (-x, x, y(self.0.rows().start), y(self.0.rows().end))
    }

    /// Slice of the local rows in the :attr:`whole` grid: ``array[grid.rows]`` selects them from an array of the whole
    /// grid.
    #[getter]
    fn rows<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PySlice>> {
        let rows = self.0.rows();
        Ok(PySlice::new(
            py,
            rows.start.try_into()?,
            rows.end.try_into()?,
            1,
        ))
    }

    fn __repr__(&self) -> String {
        let grid = self.0;
        format!(
            "Grid(nx={}, ny={}, dx={}, dy={})",
            grid.nx(),
            grid.ny(),
            short(grid.dx()),
            short(grid.dy())
        )
    }

    /// Equal grids have equal hashes.
    pub(crate) fn __hash__(&self) -> u64 {
        let grid = self.0;
        let mut hasher = DefaultHasher::new();
        // The sides are positive, so equal sides have equal bit patterns.
        (
            grid.nx(),
            grid.ny(),
            grid.dx().to_bits(),
            grid.dy().to_bits(),
        )
            .hash(&mut hasher);
        hasher.finish()
    }
}

picklable!(Grid: stickslip::Grid);

/// Formats the size of a grid.
pub(crate) fn size(grid: stickslip::Grid) -> String {
    format!("{} x {} cells", grid.nx(), grid.ny())
}
