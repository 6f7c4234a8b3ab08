//! Wear laws and jumps over cycles.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::Field;
use stickslip::history::wear::{self, Coefficient};

use crate::argument::Object;
use crate::array::{Array, copy};
use crate::digits::short;
use crate::error::{OrRaise, named};
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::history::Cycle;
use crate::real::Real;
use crate::samples::{Samples, Spread, grid_of, one_unit};
use crate::work::unobserved_on;

/// Returns a wear coefficient in the form required by the crate.
fn coefficient_of(given: &Spread) -> Coefficient<'_> {
    match given {
        Spread::Uniform(value) => Coefficient::Uniform(*value),
        Spread::PerCell(field) => Coefficient::PerCell(field),
    }
}

/// Noun for the coefficient in messages.
const COEFFICIENT: &str = "coefficient of wear";

/// Remedies for a single number instead of one number per cell. A total would wear every cell, also outside the contact.
const ENERGY_OF_CELLS: &str =
    "give the energy of each cell, step.dissipation or cycle.dissipation, instead of a total";
const ACCUMULATED_OF_CELLS: &str = "give the energy of each cell since the start, history.accumulated_dissipation, instead of a total";
const PRESSURE_OF_CELLS: &str =
    "give the pressure of each cell, history.pressure or cycle.slip_pressure";
const SLIP_OF_CELLS: &str = "give the slip of each cell, step.slip_distance or cycle.slip_distance";

/// Returns the previous depth, to which the laws add, or zero if none is given.
fn before(py: Python<'_>, depth: Option<&Samples<'_>>, grid: stickslip::Grid) -> PyResult<Field> {
    match depth {
        None => Ok(Field::zeros(grid)),
        Some(depth) => depth.on(py, "depth", grid).map(Arc::unwrap_or_clone),
    }
}

/// Returns an error if the units of the cell sides or lengths of two arguments differ.
fn check_units(fields: &[&Samples<'_>], depth: Option<&Samples<'_>>) -> PyResult<()> {
    let all: Vec<_> = fields.iter().copied().chain(depth).collect();
    one_unit(&all).map(|_| ())
}

/// Returns the grid of fields whose cell sizes are irrelevant: a known grid, the grid of an array, or a grid of unit cells.
fn of_any_cells(
    py: Python<'_>,
    grid: Option<&Grid>,
    fields: &[&Samples<'_>],
) -> PyResult<stickslip::Grid> {
    let shape = fields.iter().find_map(|field| field.shape());
    match (grid_of(grid, fields), shape) {
        (Err(_), Some((ny, nx))) => match fields.iter().find_map(|field| field.grid_of_array()) {
            Some(grid) => Ok(grid),
            None => stickslip::Grid::new(nx, ny, 1.0, 1.0).or_raise(py),
        },
        (known, _) => known,
    }
}

/// Computes the wear depth by Archard's law, ``coefficient * pressure * slip_distance`` (lengths).
///
/// Parameters
/// ----------
/// coefficient : float, Field or array_like of shape (ny, nx)
///     Volume removed per normal force and sliding distance, of one body or of both together (one over a pressure, 1/Pa in SI
///     units; 1 mm3/(N m) is 1e-9 1/Pa), not negative.
/// pressure, slip_distance : Field or array_like of shape (ny, nx)
///     Pressure, and the length of the slip path of each cell under this pressure (lengths), not negative, in a step or a
///     cycle.
/// depth : Field or array_like of shape (ny, nx), optional
///     Depth removed earlier (lengths), to which the result is added; zero by default.
/// grid : Grid, optional
///     The grid of arrays; not required, because the law does not depend on the size of the cells.
///
/// Returns
/// -------
/// ndarray of shape (ny, nx)
///     Wear depths (lengths).
///
/// Raises
/// ------
/// NegativeOrNotFinite, Sample, GridMismatch, NotFinite
/// Shape
///     If an array does not have one entry per cell. A single number, such as a total energy, is rejected too.
/// ValueError
///     If the units of the slip and of the earlier depth differ.
/// TypeError
///     If the pressure or the slip is an array of the energies of cells.
#[pyfunction]
#[pyo3(signature = (coefficient, pressure, slip_distance, *, depth=None, grid=None))]
pub(crate) fn archard<'py>(
    py: Python<'py>,
    coefficient: Samples<'py>,
    pressure: Samples<'py>,
    slip_distance: Samples<'py>,
    depth: Option<Samples<'py>>,
    grid: Option<Object<Grid>>,
) -> PyResult<Array<'py>> {
    let mut fields = vec![&pressure, &slip_distance, &coefficient];
    fields.extend(depth.as_ref());
    let grid = of_any_cells(py, grid.as_deref(), &fields)?;
    pressure.check_no_energies("pressure")?;
    slip_distance.check_no_energies("slip length")?;
    check_units(&[&slip_distance], depth.as_ref())?;
    let mut worn = before(py, depth.as_ref(), grid)?;
    let given = coefficient.spread(py, COEFFICIENT, Some(&Grid(grid)))?;
    let pressure = pressure.of_each_cell(py, "pressure", grid, PRESSURE_OF_CELLS)?;
    let distance = slip_distance.of_each_cell(py, "slip length", grid, SLIP_OF_CELLS)?;
    unobserved_on(py, grid, || {
        wear::archard(coefficient_of(&given), &pressure, &distance, &mut worn)
    })?;
    Ok(copy(py, &worn))
}

/// Computes the wear depth by the energy law, ``coefficient * energy / cell area`` (lengths).
///
/// Parameters
/// ----------
/// coefficient : float, Field or array_like of shape (ny, nx)
///     Volume removed per dissipated energy, of one body or of both together (one over a pressure, 1/Pa in SI units; 1 mm3/J
///     is 1e-9 1/Pa), not negative.
/// energy : Field or array_like of shape (ny, nx)
///     Energy dissipated in each cell in a step or a cycle (forces times lengths), not negative.
/// depth : optional
///     See :func:`archard`.
/// grid : Grid, optional
///     Grid that gives the area of a cell. It is required for an array that does not contain its grid. The dissipation of a
///     cycle, a step, a history and a state contains it; a grid with other cells is then rejected.
///
/// Returns
/// -------
/// ndarray of shape (ny, nx)
///     Wear depths (lengths).
///
/// Raises
/// ------
/// NegativeOrNotFinite, Sample, GridMismatch, NotFinite
/// Shape
///     If an array does not have one entry per cell. A single number, such as a total energy, is rejected too.
/// ValueError
///     If the units of the energies and of the earlier depth differ.
/// TypeError
///     If an array contains energies per area.
#[pyfunction]
#[pyo3(signature = (coefficient, energy, *, depth=None, grid=None))]
pub(crate) fn energy<'py>(
    py: Python<'py>,
    coefficient: Samples<'py>,
    energy: Samples<'py>,
    depth: Option<Samples<'py>>,
    grid: Option<Object<Grid>>,
) -> PyResult<Array<'py>> {
    energy.check_not_per_area("energy")?;
    check_units(&[&energy], depth.as_ref())?;
    let grid = grid_of(grid.as_deref(), &[&energy])?;
    let mut worn = before(py, depth.as_ref(), grid)?;
    let given = coefficient.spread(py, COEFFICIENT, Some(&Grid(grid)))?;
    let energy = energy.of_each_cell(py, "energy", grid, ENERGY_OF_CELLS)?;
    unobserved_on(py, grid, || {
        wear::energy(coefficient_of(&given), &energy, &mut worn)
    })?;
    Ok(copy(py, &worn))
}

/// Computes the wear depth by the energy law with a threshold: the increase of ``coefficient * max(0, accumulated / cell
/// area - threshold)`` in a step or a cycle (lengths).
///
/// Parameters
/// ----------
/// coefficient : float, Field or array_like of shape (ny, nx)
///     See :func:`energy`.
/// threshold : float
///     The energy per area up to which there is no wear, not negative.
/// accumulated, energy : Field or array_like of shape (ny, nx)
///     Energies dissipated in each cell (forces times lengths, not negative): ``accumulated`` since the start, including
///     this step or cycle, and ``energy`` in this step or cycle alone.
/// depth : optional
///     See :func:`archard`.
/// grid : Grid, optional
///     Grid that gives the area of a cell. It is required for an array that does not contain its grid. The dissipation of a
///     cycle, a step, a history and a state contains it; a grid with other cells is then rejected.
///
/// Returns
/// -------
/// ndarray of shape (ny, nx)
///     Wear depths (lengths).
///
/// Raises
/// ------
/// NegativeOrNotFinite, Sample, GridMismatch, NotFinite
/// Shape
///     If an array does not have one entry per cell. A single number, such as a total energy, is rejected too.
/// ValueError
///     If the units of the energies and of the earlier depth differ.
/// TypeError
///     If an array contains energies per area.
#[pyfunction]
#[pyo3(signature = (coefficient, threshold, accumulated, energy, *, depth=None, grid=None))]
pub(crate) fn threshold_energy<'py>(
    py: Python<'py>,
    coefficient: Samples<'py>,
    threshold: Real,
    accumulated: Samples<'py>,
    energy: Samples<'py>,
    depth: Option<Samples<'py>>,
    grid: Option<Object<Grid>>,
) -> PyResult<Array<'py>> {
    accumulated.check_not_per_area("accumulated energy")?;
    energy.check_not_per_area("energy")?;
    check_units(&[&accumulated, &energy], depth.as_ref())?;
    let grid = grid_of(grid.as_deref(), &[&accumulated, &energy])?;
    let mut worn = before(py, depth.as_ref(), grid)?;
    let given = coefficient.spread(py, COEFFICIENT, Some(&Grid(grid)))?;
    let accumulated =
        accumulated.of_each_cell(py, "accumulated energy", grid, ACCUMULATED_OF_CELLS)?;
    let energy = energy.of_each_cell(py, "energy", grid, ENERGY_OF_CELLS)?;
    unobserved_on(py, grid, || {
        wear::threshold_energy(
            coefficient_of(&given),
            threshold.0,
            &accumulated,
            &energy,
            &mut worn,
        )
    })?;
    Ok(copy(py, &worn))
}

/// Returns the number of cycles whose wear by Archard's law can be removed in one update before the pressure oscillates
/// with growing amplitude: ``1.16 h / (E* k s)`` on square cells of side h (0.90 on a periodic grid), with the wear
/// coefficient k and the slip s.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// coefficient : float, Field or array_like of shape (ny, nx)
///     Coefficient of :func:`archard` for both bodies together (one over a pressure). For the energy law, pass its
///     coefficient times the coefficient of friction.
/// slip_distance : Field or array_like of shape (ny, nx)
///     Length of the slip path of each cell in one cycle (lengths), not negative: :attr:`Cycle.slip_distance`.
///
/// Returns
/// -------
/// float
///     The limit, not rounded; infinite without slip. For fewer than half of these cycles, no pattern of pressure changes
///     sign. To multiply a depth, use :meth:`CycleJump.cycles`, which remains below this limit and is never infinite.
///
/// Raises
/// ------
/// NegativeOrNotFinite, Sample, GridMismatch, Shape
///
/// Examples
/// --------
/// >>> import numpy as np, stickslip
/// >>> grid = stickslip.Grid.square(64, 64e-6)  # cells of a micrometre
/// >>> bodies = stickslip.HalfSpace(grid, (stickslip.Material(115e9, 0.0), stickslip.Material.rigid()))
/// >>> cycles = stickslip.wear.max_stable_cycles(bodies, 1e-14, np.full(grid.shape, 40e-6))
/// >>> round(cycles, 1)
/// 25.2
#[pyfunction]
pub(crate) fn max_stable_cycles(
    py: Python<'_>,
    bodies: Object<HalfSpace>,
    coefficient: Samples<'_>,
    slip_distance: Samples<'_>,
) -> PyResult<f64> {
    let grid = bodies.0.grid();
    let given = coefficient.spread(py, COEFFICIENT, Some(&Grid(grid)))?;
    let distance = slip_distance.on(py, "slip length", grid)?;
    unobserved_on(py, grid, || {
        wear::max_stable_cycles(&bodies.0, coefficient_of(&given), &distance)
    })
}

/// Number of cycles to jump over: the largest factor by which the wear of a cycle can be multiplied without oscillations
/// of the pressure.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// cycle : Cycle
///     The cycle that represents the skipped cycles.
/// depth : Field or array_like of shape (ny, nx)
///     Depth that the cycle removed from both bodies together (lengths), not negative.
/// largest_depth : float, optional
///     The largest depth that a jump may remove in any cell (a length); no limit by default.
/// max_residual : float, default 0.25
///     The largest :attr:`Cycle.cyclic_residual` of a cycle that may represent the following cycles.
/// cycles_left : float, optional
///     The largest number of cycles to jump over, such as the rest of a simulation; no limit by default.
///
/// Raises
/// ------
/// GridMismatch, Shape, Sample
#[pyclass(frozen, module = "stickslip.wear")]
pub(crate) struct CycleJump {
    jump: wear::CycleJump,
    cycles_left: Option<f64>,
}

#[pymethods]
impl CycleJump {
    #[new]
    #[pyo3(signature = (bodies, cycle, depth, *, largest_depth=None, max_residual=None, cycles_left=None))]
    fn new(
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        cycle: Object<Cycle>,
        depth: Samples<'_>,
        largest_depth: Option<Real>,
        max_residual: Option<Real>,
        cycles_left: Option<Real>,
    ) -> PyResult<Self> {
        let grid = bodies.0.grid();
        let depth = depth.per_cell(py, "depth", grid)?;
        let cycle = &*cycle.lock()?;
        let mut jump = unobserved_on(py, grid, || wear::CycleJump::new(&bodies.0, cycle, &depth))?;
        if let Some(Real(depth)) = largest_depth {
            jump = jump.largest_depth(depth);
        }
        if let Some(Real(residual)) = max_residual {
            jump = jump.max_residual(residual);
        }
        let cycles_left = cycles_left.map(f64::from);
        if let Some(cycles) = cycles_left {
            jump = jump.cycles_left(cycles);
        }
        Ok(Self { jump, cycles_left })
    }

    /// Returns the number of whole cycles to jump over, or ``None`` if no limit applies, as in full stick without
    /// ``cycles_left``. Without wear, multiplying by the number of cycles would have no meaning, so the number is not infinite.
    ///
    /// Raises
    /// ------
    /// NoWholeCycle
    ///     If one cycle already removes more than the limit.
    /// CycleNotClosed, NotPositive, NegativeOrNotFinite
    fn cycles(&self, py: Python<'_>) -> PyResult<Option<u64>> {
        let cycles = self.jump.cycles().or_raise(py)?;
        let is_last = self.cycles_left.is_some_and(|left| left < 1.0);
        if cycles < 1.0 && !is_last {
            let numbers = PyDict::new(py);
            numbers.set_item("cycles", cycles)?;
            let message = format!(
                "a cycle removes more than the limit, which is {} cycles: \
                 reduce the wear coefficient, or wear the gap after each step of the cycle; \
                 check the unit of the coefficient (1 mm3/(N m) is 1e-9 1/Pa)",
                short(cycles)
            );
            return Err(named(py, "NoWholeCycle", &message, &numbers)?);
        }
        Ok(whole(cycles))
    }

    /// Whether no limit applies to the number of cycles: no cell wears, and ``cycles_left`` is not given.
    ///
    /// Raises
    /// ------
    /// CycleNotClosed, NotPositive, NegativeOrNotFinite
    #[getter]
    fn is_unlimited(&self, py: Python<'_>) -> PyResult<bool> {
        self.jump.cycles().or_raise(py).map(f64::is_infinite)
    }

    fn __repr__(&self) -> String {
        match self.jump.cycles().map(whole) {
            Ok(Some(cycles)) => format!("CycleJump(cycles={cycles})"),
            Ok(None) => "CycleJump(cycles=None)".into(),
            Err(error) => format!("CycleJump({error})"),
        }
    }
}

/// Returns the whole cycles of a limit; `None` for a limit that is infinite.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a limit is not negative, and its fraction is no whole cycle"
)]
fn whole(cycles: f64) -> Option<u64> {
    cycles.is_finite().then_some(cycles as u64)
}
