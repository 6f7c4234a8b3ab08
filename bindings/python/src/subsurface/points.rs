//! Stresses and displacements at points.

use pyo3::prelude::*;
use stickslip::Error;
use stickslip::subsurface::{self, Body};

use crate::argument::Object;
use crate::array::Array;
use crate::choice::Choice;
use crate::conversion;
use crate::digits::{counted, short, tuple};
use crate::error::OrRaise;
use crate::half_space::HalfSpace;
use crate::pickle::picklable;
use crate::progress::Progress;
use crate::readers::frame;
use crate::sequence::{Entries, entry};
use crate::subsurface::{Loaded, Stress};
use crate::work::{solve, watch};

/// Displacement and stress at a point.
#[pyclass(frozen, eq, module = "stickslip.subsurface")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct PointResult(subsurface::PointResult);

#[pymethods]
impl PointResult {
    /// Displacement of the body itself along x, y and z (lengths), not relative to the other body.
    #[getter]
    fn displacement(&self) -> (f64, f64, f64) {
        self.0.displacement.into()
    }

    /// Stress at the point.
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

picklable!(PointResult: subsurface::PointResult);

/// Displacements and stresses at points: a sequence of :class:`PointResult`, and arrays with one number per point, in the
/// order of the points.
#[pyclass(frozen, eq, module = "stickslip.subsurface", sequence)]
#[derive(Clone, PartialEq)]
pub(crate) struct PointResults(Vec<subsurface::PointResult>);

impl PointResults {
    fn stress<'py>(&self, py: Python<'py>, of: impl Fn(&subsurface::Stress) -> f64) -> Array<'py> {
        Array::new(py, self.0.iter().map(|response| of(&response.stress)))
    }

    fn displacement_along<'py>(&self, py: Python<'py>, axis: usize) -> Array<'py> {
        Array::new(
            py,
            self.0.iter().map(|response| response.displacement[axis]),
        )
    }
}

#[pymethods]
impl PointResults {
    /// Displacement of the body itself along x, y and z (lengths), not relative to the other body.
    #[getter]
    fn displacement<'py>(&self, py: Python<'py>) -> (Array<'py>, Array<'py>, Array<'py>) {
        (
            self.displacement_along(py, 0),
            self.displacement_along(py, 1),
            self.displacement_along(py, 2),
        )
    }

    /// Components xx, yy and zz (pressures, tensile positive).
    #[getter]
    fn normal_stress<'py>(&self, py: Python<'py>) -> (Array<'py>, Array<'py>, Array<'py>) {
        (
            self.stress(py, |stress| stress.xx),
            self.stress(py, |stress| stress.yy),
            self.stress(py, |stress| stress.zz),
        )
    }

    /// Components xy, xz and yz (pressures).
    #[getter]
    fn shear_stress<'py>(&self, py: Python<'py>) -> (Array<'py>, Array<'py>, Array<'py>) {
        (
            self.stress(py, |stress| stress.xy),
            self.stress(py, |stress| stress.xz),
            self.stress(py, |stress| stress.yz),
        )
    }

    /// Von Mises' equivalent stress (pressures).
    #[getter]
    fn von_mises<'py>(&self, py: Python<'py>) -> Array<'py> {
        self.stress(py, subsurface::Stress::von_mises)
    }

    /// Mean of the normal stresses (pressures, tensile positive).
    #[getter]
    fn hydrostatic<'py>(&self, py: Python<'py>) -> Array<'py> {
        self.stress(py, subsurface::Stress::hydrostatic)
    }

    /// Largest shear stress (pressures).
    #[getter]
    fn max_shear<'py>(&self, py: Python<'py>) -> Array<'py> {
        self.stress(py, subsurface::Stress::max_shear)
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }

    fn __iter__(&self) -> Entries<PointResult> {
        Entries::of(&self.0, PointResult)
    }

    fn __getitem__(&self, index: isize) -> PyResult<PointResult> {
        entry(&self.0, index, "point").copied().map(PointResult)
    }

    fn __repr__(&self) -> String {
        format!("PointResults({})", counted(self.0.len(), "point"))
    }
}

picklable!(PointResults: Vec<subsurface::PointResult>);

frame!(PointResults, record: displacement, normal_stress, shear_stress, von_mises, hydrostatic, max_shear);

/// Computes stress and displacement at points of a body without a coating, by summing over all cells. If there are more
/// than 2048 loaded cells and more than three points, distant cells are summed in blocks. For coated bodies, and on grids
/// that are periodic along x and y, use :class:`Planes`.
///
/// The tractions are uniform on each cell. Values at depth zero are the limits from inside the body.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// body : Body or str
///     "one" or "two".
/// tractions : solution, (normal, shear), State, History, array_like or (array_like, (array_like, array_like))
///     The tractions of a solution of any kind or of a pair of a normal and a tangential solution, or fields: a pressure,
///     or a pressure and the tractions along x and y.
/// points : array_like of shape (n, 3)
///     Points ``(x, y, depth)`` (lengths), with the depth below the surface of the body. The columns of a table of pandas are
///     recognised by these names.
/// uniform_stress : Stress, optional
///     A uniform stress of the body, such as a bulk stress, which is added to the stress of the tractions everywhere;
///     none by default. Displacements are due to the tractions only.
///
/// Returns
/// -------
/// PointResults
///     The results at the points, as a sequence and as arrays.
///
/// Raises
/// ------
/// Sample, GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch, RigidBody, Memory, Ranks
/// UnsupportedForCoatings
///     If the body is coated.
/// DivergentPeriodicSum
///     If the grid is periodic along x and y.
#[pyfunction]
#[pyo3(signature = (bodies, body, tractions, points, *, uniform_stress=None))]
pub(crate) fn at_points(
    py: Python<'_>,
    bodies: Object<HalfSpace>,
    body: Choice<Body>,
    tractions: Loaded<'_>,
    points: conversion::Points,
    uniform_stress: Option<Stress>,
) -> PyResult<PointResults> {
    let (grid, points) = (bodies.0.grid(), points.0);
    let held = tractions.held(py, grid)?;
    let (tractions, work) = (
        held.tractions(uniform_stress),
        grid.cells().saturating_mul(points.len()),
    );
    let outcome = solve(py, work, Progress::none(), |observer| {
        subsurface::at_points_observed(&bodies.0, body.0, tractions, &points, watch(observer))
    })?;
    // The index in the error is that of a point, not of a cell.
    let found = match outcome {
        Err(Error::Sample {
            quantity: "point", ..
        }) => outcome.or_raise(py)?,
        _ => outcome.or_raise_on(py, grid)?,
    };
    Ok(PointResults(found))
}
