//! Reusable solvers of normal contacts.

use std::sync::Mutex;

use pyo3::prelude::*;
use pyo3::types::PyTuple;
use stickslip::{NormalLoad, cgm};

use crate::argument::Object;
use crate::array::{Array, snapshot};
use crate::choice::Choice;
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::load;
use crate::normal::{AnyHardness, NormalProblem, NormalSolution};
use crate::real::{Count, Real};
use crate::samples::Samples;
use crate::sensitivity::{Sensitivity, computed, sensitive, workspace};
use crate::settings::Settings;
use crate::solution_pool::lock;
use crate::solver::{Reused, solver};
use crate::unit::{Unit, set_in};
use crate::work::{unobserved_on, watch};

/// Solves normal contacts on one grid repeatedly, each time from the last solution. The arguments are those of
/// :class:`NormalProblem`; load and gap may change between calls.
///
/// One thread at a time may use a solver. The memory of a solution is reused once the caller has dropped it.
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(32, 8.0)
/// >>> bodies = stickslip.HalfSpace(grid, (stickslip.Material(1.0, 0.3), stickslip.Material.rigid()))
/// >>> solver = stickslip.NormalSolver(bodies, stickslip.surface.sphere(grid, 10.0), force=0.5)
/// >>> [round(solver.solve(force=force).force, 12) for force in (0.5, 1.0, 0.7)]
/// [0.5, 1.0, 0.7]
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct NormalSolver(Reused<stickslip::NormalSolver>, Mutex<SolverArguments>);

/// Load and gap of the problem to be solved.
struct SolverArguments {
    load: NormalLoad,
    gap: Field,
}

impl SolverArguments {
    /// Returns the gap that replaces the gap of these arguments.
    fn next_gap(&self, py: Python<'_>, gap: Option<Samples<'_>>) -> PyResult<Option<Field>> {
        let Field(last, unit) = &self.gap;
        gap.map(|gap| gap.next_gap(py, last.grid(), unit.as_ref()))
            .transpose()
    }

    /// Sets the load, the gap or both; if one is rejected, both remain unchanged.
    fn set(
        &mut self,
        solver: &mut stickslip::NormalSolver,
        load: Option<NormalLoad>,
        gap: Option<Field>,
    ) -> stickslip::Result<()> {
        match (load, gap) {
            (None, None) => {}
            (Some(load), None) => {
                solver.set_load(load)?;
                self.load = load;
            }
            (None, Some(gap)) => {
                solver.set_gap(&gap.0)?;
                self.gap = gap;
            }
            (Some(load), Some(gap)) => {
                let given = Self { load, gap };
                if let Err(refused) = given.set_both(solver) {
                    self.set_both(solver)?;
                    return Err(refused);
                }
                *self = given;
            }
        }
        Ok(())
    }

    /// Sets load and gap. Each new argument is checked together with the other new argument, and not with the previous
    /// data. A zero force is valid with any gap.
    fn set_both(&self, solver: &mut stickslip::NormalSolver) -> stickslip::Result<()> {
        solver.set_load(NormalLoad::Force(0.0))?;
        solver.set_gap(&self.gap.0)?;
        solver.set_load(self.load)
    }
}

impl NormalSolver {
    pub(super) fn of(
        py: Python<'_>,
        solver: impl FnOnce() -> stickslip::Result<stickslip::NormalSolver> + Send,
        load: NormalLoad,
        gap: Field,
    ) -> PyResult<Self> {
        let solver = Reused::new(py, gap.0.grid(), solver)?;
        Ok(Self(solver, Mutex::new(SolverArguments { load, gap })))
    }

    /// Returns a copy of the solver of the crate.
    pub(crate) fn copied(&self) -> PyResult<stickslip::NormalSolver> {
        self.0.with(|solver| solver.clone())
    }

    /// Returns the unit of the gap.
    pub(crate) fn unit_of_gap(&self) -> PyResult<Option<Unit>> {
        Ok(lock(&self.1, "solver")?.gap.1.clone())
    }

    fn change(
        &self,
        py: Python<'_>,
        load: Option<NormalLoad>,
        gap: Option<Samples<'_>>,
    ) -> PyResult<()> {
        let mut given = lock(&self.1, "solver")?;
        let given = &mut *given;
        let gap = given.next_gap(py, gap)?;
        self.0.change(py, |solver| given.set(solver, load, gap))
    }
}

solver!(NormalSolver: NormalSolution);
sensitive!(NormalSolver: NormalSolution);

#[pymethods]
impl NormalSolver {
    #[new]
    #[pyo3(signature = (bodies, gap, *positional, force=None, approach=None, hardness=None, settings=None, tolerance=None,
        method=None, max_iterations=None, time_limit=None),
        text_signature = "(bodies, gap, *, force=None, approach=None, hardness=None, settings=None, tolerance=None, \
            method=None, max_iterations=None, time_limit=None)")]
    fn new(
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        gap: Samples<'_>,
        positional: &Bound<'_, PyTuple>,
        force: Option<Real>,
        approach: Option<Real>,
        hardness: Option<AnyHardness<'_>>,
        settings: Option<Settings>,
        tolerance: Option<Real>,
        method: Option<Choice<cgm::Method>>,
        max_iterations: Option<Count>,
        time_limit: Option<Real>,
    ) -> PyResult<Self> {
        load::by_keyword("NormalSolver", positional, "force= or approach=")?;
        let problem = NormalProblem::new(
            py,
            bodies,
            gap,
            positional,
            force,
            approach,
            hardness,
            settings,
            tolerance,
            method,
            max_iterations,
            time_limit,
        )?;
        problem.solver(py)
    }

    /// Solves for the given load and gap; an omitted load or gap keeps its last value.
    ///
    /// The arguments set the problem of the solver. They remain set if the solve fails or is cancelled; invalid arguments
    /// leave it unchanged.
    ///
    /// Parameters
    /// ----------
    /// force, approach : float, optional
    ///     At most one of the two; see :class:`NormalProblem`.
    /// gap : Field or array_like of shape (ny, nx), optional
    ///     The gap before loading (lengths); copied. Its unit, if any, must be that of the earlier gaps.
    /// progress, warn : optional
    ///     See :meth:`NormalProblem.solve`.
    ///
    /// Returns
    /// -------
    /// NormalSolution
    ///
    /// Raises
    /// ------
    /// GridMismatch, Shape, Sample, NegativeOrNotFinite, NotFinite, ApproachBeyondMeanGap, BeyondHardness
    ///     If the load or the gap is invalid; both are then unchanged.
    /// ValueError
    ///     If the unit of the gap differs from that of the earlier gaps; load and gap are then unchanged.
    /// NotConverged
    ///     The exception has the attributes ``report`` and ``last_iterate``.
    #[pyo3(signature = (*positional, force=None, approach=None, gap=None, progress=None, warn=true),
        text_signature = "($self, *, force=None, approach=None, gap=None, progress=None, warn=True)")]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        positional: &Bound<'py, PyTuple>,
        force: Option<Real>,
        approach: Option<Real>,
        gap: Option<Samples<'_>>,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Bound<'py, NormalSolution>> {
        load::by_keyword("NormalSolver.solve", positional, "force= or approach=")?;
        let load = load::normal(force, approach)?;
        let mut given = lock(&self.1, "solver")?;
        let given = &mut *given;
        let gap = given.next_gap(py, gap)?;
        let set = |solver: &mut stickslip::NormalSolver| {
            if load.is_some() || gap.is_some() {
                let grid = self.0.grid();
                unobserved_on(py, grid, || given.set(solver, load, gap))?;
            }
            Ok(())
        };
        let outcome = self.0.solve(py, set, progress, warn);
        set_in(outcome, py, given.gap.1.as_ref())
    }

    /// Sets the load of the next solve.
    #[pyo3(signature = (*positional, force=None, approach=None),
        text_signature = "($self, *, force=None, approach=None)")]
    fn set_load(
        &self,
        py: Python<'_>,
        positional: &Bound<'_, PyTuple>,
        force: Option<Real>,
        approach: Option<Real>,
    ) -> PyResult<()> {
        load::by_keyword("NormalSolver.set_load", positional, "force= or approach=")?;
        self.change(py, Some(load::needed(force, approach)?), None)
    }

    /// The gap before loading of the next solve (lengths), as last set; a read-only copy.
    #[getter]
    fn gap<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.0.with(|solver| snapshot(py, solver.gap()))
    }

    /// Sets the gap of the next solve, for example after wear.
    ///
    /// Raises
    /// ------
    /// GapUnderLoad
    ///     If the gap is the gap of the last solution, which is the gap under load.
    /// ValueError
    ///     If the unit of the gap differs from that of the earlier gaps.
    fn set_gap(&self, py: Python<'_>, gap: Samples<'_>) -> PyResult<()> {
        self.change(py, None, Some(gap))
    }

    /// Continues sensitivities of a tangential contact through the normal contact that supplies its pressure.
    ///
    /// The results also contain the derivatives with respect to the gap and the normal load. The derivatives with respect to
    /// the modulus include the change of the pressure.
    ///
    /// Parameters
    /// ----------
    /// solution : NormalSolution
    ///     The solution of the present problem of this solver.
    /// sensitivities : sequence of Sensitivity
    ///     Results of :meth:`TangentialSolver.sensitivities`.
    /// tolerance : float, optional
    ///     Relative residual at which a linear problem counts as solved; 1e-11 by default.
    ///
    /// Returns
    /// -------
    /// list of Sensitivity
    ///
    /// Raises
    /// ------
    /// UnsupportedByModel
    ///     If a sensitivity has no derivative with respect to the pressure, or was chained before.
    /// OutdatedSolution
    ///     If a sensitivity was computed for another pressure, or the solution for another problem of this solver.
    /// GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch, NotPositive, EmptyContact, NotFinite, NotConverged
    ///     See :meth:`sensitivity`.
    ///
    /// Examples
    /// --------
    /// >>> import stickslip
    /// >>> from stickslip.sensitivity import Functional
    /// >>> grid = stickslip.Grid.square(48, 0.3e-3)
    /// >>> steel = stickslip.Material(213e9, 0.29)
    /// >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
    /// >>> presser = stickslip.NormalSolver(bodies, stickslip.surface.sphere(grid, 3.5e-3), force=100.0)
    /// >>> normal = presser.solve()
    /// >>> shearer = stickslip.TangentialProblem(bodies, normal, 0.5, shift_x=1.5e-6).solver()
    /// >>> found = shearer.sensitivities(shearer.solve(), [Functional.tangential_force("x")])
    /// >>> [chained] = presser.chain(normal, found)
    /// >>> chained.normal_load > 0.0 and chained.friction_coefficient > 0.0
    /// True
    #[pyo3(signature = (solution, sensitivities, *, tolerance=None))]
    fn chain(
        &self,
        py: Python<'_>,
        solution: &NormalSolution,
        sensitivities: Vec<Sensitivity>,
        tolerance: Option<Real>,
    ) -> PyResult<Vec<Sensitivity>> {
        let solution = solution.get();
        let sensitivities = sensitivities.into_iter().map(Into::into).collect();
        let workspace = workspace(py, tolerance, false)?;
        computed(py, &self.0, workspace, |solver, workspace, observer| {
            solver.chain_with(solution, sensitivities, workspace, watch(observer))
        })
    }
}
