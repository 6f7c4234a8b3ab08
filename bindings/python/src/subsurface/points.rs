//! Stress and displacement at points.

use pyo3::prelude::*;
use stickslip::Error;
use stickslip::subsurface::{self, Body};

use crate::choice::Choice;
use crate::digits::{short, tuple};
use crate::due;
use crate::error::OrRaise;
use crate::half_space::HalfSpace;
use crate::pickle::picklable;
use crate::progress::Progress;
use crate::subsurface::{Loaded, Stress};
use crate::work::{solve, watch};

/// Displacement and stress at a point.
#[pyclass(frozen, eq, module = "stickslip.subsurface")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Response(subsurface::Response);

#[pymethods]
impl Response {
    /// Displacement along x, y and z (lengths).
    #[getter]
    fn displacement(&self) -> (f64, f64, f64) {
        self.0.displacement.into()
    }

    /// Stress.
    #[getter]
    fn stress(&self) -> Stress {
        Stress(self.0.stress)
    }

    fn __repr__(&self) -> String {
        format!(
            "Response(displacement={}, von_mises={})",
            tuple(&self.0.displacement),
            short(self.0.stress.von_mises())
        )
    }
}

picklable!(Response: subsurface::Response);

/// Stress and displacement at points, by sums over all cells.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// body : Body or str
///     "one" or "two".
/// tractions : NormalSolution, (NormalSolution, TangentialSolution), CoupledSolution, State, History, array_like or \
///     (array_like, (array_like, array_like))
///     Those of a solution, or fields: a pressure, or a pressure and tractions along x and y.
/// points : array_like of shape (n, 3)
///     Each ``(x, y, depth)`` (lengths), the depth below the surface of the body.
///
/// Returns
/// -------
/// list of Response
///     Of each point in turn.
#[pyfunction]
pub(crate) fn at_points(
    py: Python<'_>,
    bodies: &HalfSpace,
    body: Choice<Body>,
    tractions: Loaded<'_>,
    points: due::Points,
) -> PyResult<Vec<Response>> {
    let (grid, points) = (bodies.0.grid(), points.0);
    let held = tractions.held(py, grid)?;
    let (tractions, work) = (held.tractions(), grid.cells().saturating_mul(points.len()));
    let outcome = solve(py, work, Progress::none(), |observer| {
        subsurface::at_points_observed(&bodies.0, body.0, tractions, &points, watch(observer))
    })?;
    // The index of a point is none of a cell.
    let found = match outcome {
        Err(Error::Sample {
            quantity: "points", ..
        }) => outcome.or_raise(py)?,
        _ => outcome.or_raise_on(py, grid)?,
    };
    Ok(found.into_iter().map(Response).collect())
}
