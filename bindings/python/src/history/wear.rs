//! Laws of wear, and jumps over cycles.

use std::sync::Arc;

use pyo3::prelude::*;
use stickslip::Field;
use stickslip::history::wear::{self, Coefficient};

use crate::array::{Array, copy};
use crate::error::OrRaise;
use crate::field::{Samples, Spread, grid_of};
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::history::Cycle;
use crate::work::unobserved;

/// A coefficient of wear as the crate takes it.
fn coefficient_of(given: &Spread) -> Coefficient<'_> {
    match given {
        Spread::Uniform(value) => Coefficient::Uniform(*value),
        Spread::PerCell(field) => Coefficient::PerCell(field),
    }
}

/// What the coefficient is called in messages.
const COEFFICIENT: &str = "coefficient of wear";

/// The depth before, zero if none is given, which the laws add to.
fn before(py: Python<'_>, depth: Option<&Samples<'_>>, grid: stickslip::Grid) -> PyResult<Field> {
    match depth {
        None => Ok(Field::zeros(grid)),
        Some(depth) => depth.on(py, "depth", grid).map(Arc::unwrap_or_clone),
    }
}

/// Archard's law: the depth ``coefficient * pressure * slip_distance`` (lengths).
///
/// Parameters
/// ----------
/// coefficient : float or array_like of shape (ny, nx)
///     One over a pressure.
/// pressure, slip_distance : Field or array_like of shape (ny, nx)
/// depth : Field or array_like, optional
///     What has been removed before, which is added.
/// grid : Grid, optional
///     Needed where no Field is given.
///
/// Returns
/// -------
/// ndarray of shape (ny, nx)
#[pyfunction]
#[pyo3(signature = (coefficient, pressure, slip_distance, *, depth=None, grid=None))]
pub(crate) fn archard<'py>(
    py: Python<'py>,
    coefficient: Samples<'py>,
    pressure: Samples<'py>,
    slip_distance: Samples<'py>,
    depth: Option<Samples<'py>>,
    grid: Option<&Grid>,
) -> PyResult<Array<'py>> {
    let grid = grid_of(grid, &[&pressure, &slip_distance])?;
    let mut worn = before(py, depth.as_ref(), grid)?;
    let given = coefficient.spread(py, COEFFICIENT, Some(&Grid(grid)))?;
    let pressure = pressure.on(py, "pressure", grid)?;
    let distance = slip_distance.on(py, "slip length", grid)?;
    unobserved(py, grid.cells(), || {
        wear::archard(coefficient_of(&given), &pressure, &distance, &mut worn)
    })?;
    Ok(copy(py, &worn))
}

/// The energy law: the depth ``coefficient * energy / cell area`` (lengths).
///
/// Parameters
/// ----------
/// coefficient : float or array_like of shape (ny, nx)
///     A volume over an energy.
/// energy : Field or array_like of shape (ny, nx)
///     Dissipated by each cell.
/// depth, grid : optional
///     As of :func:`archard`.
#[pyfunction]
#[pyo3(signature = (coefficient, energy, *, depth=None, grid=None))]
pub(crate) fn energy<'py>(
    py: Python<'py>,
    coefficient: Samples<'py>,
    energy: Samples<'py>,
    depth: Option<Samples<'py>>,
    grid: Option<&Grid>,
) -> PyResult<Array<'py>> {
    let grid = grid_of(grid, &[&energy])?;
    let mut worn = before(py, depth.as_ref(), grid)?;
    let given = coefficient.spread(py, COEFFICIENT, Some(&Grid(grid)))?;
    let energy = energy.on(py, "energy", grid)?;
    unobserved(py, grid.cells(), || {
        wear::energy(coefficient_of(&given), &energy, &mut worn)
    })?;
    Ok(copy(py, &worn))
}

/// The energy law beyond a threshold, an energy per area that wears nothing.
///
/// Parameters
/// ----------
/// coefficient : float or array_like of shape (ny, nx)
/// threshold : float
/// accumulated, energy : Field or array_like of shape (ny, nx)
///     Dissipated by each cell since the start, this part included, and in this part.
/// depth, grid : optional
///     As of :func:`archard`.
#[pyfunction]
#[pyo3(signature = (coefficient, threshold, accumulated, energy, *, depth=None, grid=None))]
pub(crate) fn threshold_energy<'py>(
    py: Python<'py>,
    coefficient: Samples<'py>,
    threshold: f64,
    accumulated: Samples<'py>,
    energy: Samples<'py>,
    depth: Option<Samples<'py>>,
    grid: Option<&Grid>,
) -> PyResult<Array<'py>> {
    let grid = grid_of(grid, &[&accumulated, &energy])?;
    let mut worn = before(py, depth.as_ref(), grid)?;
    let given = coefficient.spread(py, COEFFICIENT, Some(&Grid(grid)))?;
    let accumulated = accumulated.on(py, "accumulated energy", grid)?;
    let energy = energy.on(py, "energy", grid)?;
    unobserved(py, grid.cells(), || {
        wear::threshold_energy(
            coefficient_of(&given),
            threshold,
            &accumulated,
            &energy,
            &mut worn,
        )
    })?;
    Ok(copy(py, &worn))
}

/// Cycles whose wear by Archard's law may be taken off at once before the pressure swings without end.
#[pyfunction]
pub(crate) fn max_stable_cycles(
    py: Python<'_>,
    bodies: &HalfSpace,
    coefficient: Samples<'_>,
    slip_distance: Samples<'_>,
) -> PyResult<f64> {
    let grid = bodies.0.grid();
    let given = coefficient.spread(py, COEFFICIENT, Some(&Grid(grid)))?;
    let distance = slip_distance.on(py, "slip length", grid)?;
    unobserved(py, grid.cells(), || {
        wear::max_stable_cycles(&bodies.0, coefficient_of(&given), &distance)
    })
}

/// How many cycles to jump over: as many as a cycle's wear may be taken off at once, without the pressure swinging.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
/// cycle : Cycle
/// depth : Field or array_like of shape (ny, nx)
///     What the cycle removed, of both bodies together (lengths).
/// largest_depth : float, optional
///     The most that a jump may remove in any cell.
/// closed_within : float, optional
///     The largest residual of a cycle that may stand for those that follow.
/// cycles_left : float, optional
#[pyclass(frozen, module = "stickslip.wear")]
pub(crate) struct CycleJump(wear::CycleJump);

#[pymethods]
impl CycleJump {
    #[new]
    #[pyo3(signature = (bodies, cycle, depth, *, largest_depth=None, closed_within=None, cycles_left=None))]
    fn new(
        py: Python<'_>,
        bodies: &HalfSpace,
        cycle: &Cycle,
        depth: Samples<'_>,
        largest_depth: Option<f64>,
        closed_within: Option<f64>,
        cycles_left: Option<f64>,
    ) -> PyResult<Self> {
        let grid = bodies.0.grid();
        let depth = depth.on(py, "depth of the cycle", grid)?;
        let cycle = &*cycle.lock()?;
        let mut jump = unobserved(py, grid.cells(), || {
            wear::CycleJump::new(&bodies.0, cycle, &depth)
        })?;
        if let Some(depth) = largest_depth {
            jump = jump.largest_depth(depth);
        }
        if let Some(residual) = closed_within {
            jump = jump.closed_within(residual);
        }
        if let Some(cycles) = cycles_left {
            jump = jump.cycles_left(cycles);
        }
        Ok(Self(jump))
    }

    /// The cycles to jump over.
    ///
    /// Raises
    /// ------
    /// CycleNotClosed, NotPositive, Negative
    fn cycles(&self, py: Python<'_>) -> PyResult<f64> {
        self.0.cycles().or_raise(py)
    }

    fn __repr__(&self) -> String {
        match self.0.cycles() {
            Ok(cycles) => format!("CycleJump(cycles={cycles})"),
            Err(error) => format!("CycleJump({error})"),
        }
    }
}
