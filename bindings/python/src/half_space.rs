//! Pairs of elastic half-spaces on a grid.

use std::sync::Arc;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::argument::{Object, by_value};
use crate::boundary::{Boundary, Surroundings};
use crate::choice::Choice;
use crate::digits::short;
use crate::error::OrRaise;
use crate::function::raising;
use crate::grid::{Grid, size};
use crate::material::{Bodies, ElasticPair};
use crate::ranks::Communicator;
use crate::readers::readers;

/// A pair of half-spaces on a grid. Its influence coefficients and buffers are created on first use and shared. Two pairs
/// with equal grid, bodies, boundary and cell value are equal.
///
/// Parameters
/// ----------
/// grid : Grid
///     The cells that may come into contact.
/// pair : ElasticPair, two Materials, or Kernel
///     The two bodies; z points into the first.
/// boundary : Boundary or str, default "non_periodic"
///     Boundary condition at the edge of the grid: "non_periodic", "periodic" or ("periodic_along_y", datum).
/// cell_value : CellValue or str, default "uniform"
///     Meaning of the pressure and the traction of a cell: "uniform" over the cell, or the value at its "centre".
///
/// Raises
/// ------
/// NotPositive, Memory, BelowMinimum, UnsupportedForCoatings, IncompleteKernel, GridMismatch, Length, UnsupportedByModel
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> steel = stickslip.Material(213e9, 0.29)
/// >>> bodies = stickslip.HalfSpace(stickslip.Grid.square(64, 0.4e-3), (steel, steel))
/// >>> bodies.grid.cells
/// 4096
#[pyclass(frozen, module = "stickslip")]
#[derive(Clone)]
pub(crate) struct HalfSpace(pub(crate) stickslip::HalfSpace);

readers! { HalfSpace.0:
    /// The grid; for :meth:`distributed` bodies, the local rows.
    grid(): Grid => Grid,
    /// Boundary condition at the edge of the grid.
    boundary(): Boundary => Boundary,
    /// Meaning of the pressure and the traction of a cell.
    cell_value(): Choice<stickslip::CellValue> => Choice,
}

by_value!(HalfSpace);

#[pymethods]
impl HalfSpace {
    #[new]
    #[pyo3(signature = (grid, pair, boundary=None, cell_value=None))]
    fn new(
        py: Python<'_>,
        grid: Object<Grid>,
        pair: Bodies,
        boundary: Option<Surroundings>,
        cell_value: Option<Choice<stickslip::CellValue>>,
    ) -> PyResult<Self> {
        let boundary = boundary.map(|boundary| boundary.0).unwrap_or_default();
        let bodies = raising(|| stickslip::HalfSpace::with_boundary(grid.0, pair.0, boundary))?;
        let cell_value = cell_value.map(|chosen| chosen.0).unwrap_or_default();
        let bodies = bodies.and_then(|bodies| bodies.with_cell_value(cell_value));
        bodies.or_raise(py).map(Self)
    }

    /// Distributes the rows of the bodies over the ranks of a communicator, which solve one contact together. All calls
    /// are collective: every rank creates the bodies and then makes the same calls in the same order. Grid and arrays are
    /// local, that is, restricted to the rows of the rank (:attr:`Grid.rows`). Results for the whole contact, such as
    /// forces, areas, reports and spots, are available on every rank. All results are bitwise identical to those of one
    /// process.
    ///
    /// Parameters
    /// ----------
    /// grid : Grid
    ///     The whole grid.
    /// pair : ElasticPair, two Materials, or Kernel
    ///     The two bodies; z points into the first.
    /// comm : mpi4py.MPI.Comm, or any object with three of its methods
    ///     The methods are ``Get_rank()``, ``Get_size()`` and ``sendrecv(block, dest=, source=)``, which sends
    ///     ``bytes`` to one rank and returns ``bytes`` from another. Messages may have any length and must arrive in
    ///     the order of sending. The communicator must not receive other messages: pass a duplicate of a communicator
    ///     that is also used elsewhere. The methods are called one at a time, possibly on threads of the package. An
    ///     exception in a method is raised as :class:`~stickslip.errors.Ranks`, and the original exception is passed to
    ///     `sys.unraisablehook`.
    /// boundary : Boundary or str, default "non_periodic"
    ///     See the class.
    /// cell_value : CellValue or str, default "uniform"
    ///     See the class.
    ///
    /// Raises
    /// ------
    /// NotPositive, Memory, BelowMinimum, UnsupportedForCoatings, IncompleteKernel, GridMismatch, Ranks
    ///
    /// Notes
    /// -----
    /// Ranks can be threads of one process; each rank then creates its bodies and solves on its own thread.
    ///
    /// Examples
    /// --------
    /// Run as ``mpirun -n 4 python -m mpi4py press.py``, which ends all ranks when one has failed::
    ///
    ///     from mpi4py import MPI
    ///     import stickslip as ss
    ///
    ///     pair = ss.Material(213e9, 0.29), ss.Material.rigid()
    ///     bodies = ss.HalfSpace.distributed(ss.Grid.square(4096, 0.4e-3), pair, MPI.COMM_WORLD.Dup())
    ///     ball = ss.surface.sphere(bodies.grid, 3.5e-3)  # its own rows
    ///     normal = ss.NormalProblem(bodies, ball, force=100.0).solve()
    ///     print(bodies.grid.rows, normal.pressure.shape, normal.contact_area)
    #[staticmethod]
    #[pyo3(signature = (grid, pair, comm, boundary=None, cell_value=None))]
    fn distributed(
        py: Python<'_>,
        grid: Object<Grid>,
        pair: Bodies,
        comm: Bound<'_, PyAny>,
        boundary: Option<Surroundings>,
        cell_value: Option<Choice<stickslip::CellValue>>,
    ) -> PyResult<Self> {
        let boundary = boundary.map(|boundary| boundary.0).unwrap_or_default();
        let cell_value = cell_value.map(|chosen| chosen.0).unwrap_or_default();
        let ranks = Arc::new(Communicator::of(&comm)?);
        let make = || {
            let bodies = stickslip::HalfSpace::distributed(grid.0, pair.0, boundary, ranks)?;
            bodies.with_cell_value(cell_value)
        };
        let made = py.detach(|| raising(make))?;
        made.or_raise(py).map(Self)
    }

    /// The two bodies.
    #[getter]
    fn pair(&self) -> ElasticPair {
        self.0.pair().into()
    }

    fn __eq__(&self, other: &Self) -> bool {
        let (own, other) = (&self.0, &other.0);
        own.grid() == other.grid()
            && own.pair() == other.pair()
            && own.boundary() == other.boundary()
            && own.cell_value() == other.cell_value()
    }

    /// Equal pairs have equal hashes.
    fn __hash__(&self) -> u64 {
        self.grid().__hash__()
    }

    #[expect(clippy::type_complexity, reason = "what pickle takes")]
    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(
        Bound<'py, pyo3::types::PyType>,
        (Grid, ElasticPair, Boundary, Choice<stickslip::CellValue>),
    )> {
        let bodies = slf.get();
        let refused = if bodies.0.pair().stands_for_kernel() {
            Some("bodies of a Kernel cannot be pickled: create them again from the Kernel")
        } else {
            // Only distributed bodies perform gather operations when they are created.
            let is_shared = bodies.0.traffic().gathers > 0;
            is_shared.then_some(
                "bodies that are distributed over ranks cannot be pickled: create them again",
            )
        };
        if let Some(refused) = refused {
            return Err(PyTypeError::new_err(refused));
        }
        Ok((
            slf.get_type(),
            (
                bodies.grid(),
                bodies.pair(),
                bodies.boundary(),
                bodies.cell_value(),
            ),
        ))
    }

    fn __repr__(&self) -> String {
        let grid = self.0.grid();
        format!(
            "HalfSpace({} of {} x {}, {}, E* = {})",
            size(grid),
            short(grid.dx()),
            short(grid.dy()),
            self.boundary().__repr__(),
            short(self.0.pair().contact_modulus())
        )
    }
}
