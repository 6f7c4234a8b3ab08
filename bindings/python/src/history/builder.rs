//! Construction of a history, and changes of its data for later steps.

use std::sync::Mutex;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use stickslip::history::{EntryRule, StepResult as Step};
use stickslip::{Axis, Coupling, TangentialModel, cgm};

use crate::argument::Object;
use crate::choice::Choice;
use crate::field::Field;
use crate::friction::{AnyFriction, warn_of_lost_cap};
use crate::half_space::HalfSpace;
use crate::history::step::Numbers;
use crate::normal::AnyHardness;
use crate::real::{Count, Real};
use crate::samples::Samples;
use crate::settings::{Settings, chosen};
use crate::solution_pool::lock;
use crate::tangential::RelativeDisplacement;
use crate::unit::{Unit, check_relative};
use crate::work::unobserved_on;

/// Two bodies in contact with memory of their load: pressure, traction, slip and energy, step by step.
///
/// The arrays are copies, because the next step changes the data; :meth:`state` is a snapshot whose arrays are views.
/// One thread at a time may use a history. A step that fails, or that is interrupted by Ctrl-C, leaves the history
/// unchanged.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// gap : Field or array_like of shape (ny, nx)
///     The gap before loading (lengths); copied.
/// friction : Friction, float or array_like of shape (ny, nx)
///     Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
/// axis : Axis or str, default "x"
///     The axis of tangential load and tractions in the scalar model; the vector model has none.
/// model : TangentialModel or str, default "scalar"
///     "scalar" computes the traction along the axis; "vector" computes both components and supports loads of any
///     direction and twist. Give "vector" with the coupling "one_way": "scalar" omits the tractions across the axis, and the
///     stick radius of a pressed ball is then too large, several times for a small friction coefficient.
/// coupling : Coupling or str, default "full"
///     Coupling for bodies of different materials: "full" solves pressure and traction simultaneously; "one_way" includes
///     the tangential displacements due to pressure only; "neglected" omits both.
/// entry_rule : EntryRule or str, default "since_touch"
///     Part of the motion of a step that a cell follows if it comes into contact within the step: "since_touch" for the
///     motion since first touch, "whole_step" for the whole motion.
/// relative_displacement : RelativeDisplacement, optional
///     The pattern of a displacement that is not caused by the contact. Steps prescribe its factor; none by default.
/// hardness : Hardness, float or array_like of shape (ny, nx), optional
///     The largest pressure that the cells can carry; no limit by default.
/// permanent_set : bool, default False
///     Whether the yielded depth remains and is added to the gap of later steps; requires ``hardness``.
/// settings : Settings, optional
///     Method, tolerance and limits; ``Settings()`` by default.
/// tolerance, method, max_iterations, time_limit : optional
///     See :class:`Settings`; these arguments take precedence over ``settings``.
///
/// Raises
/// ------
/// GridMismatch, Shape, Sample, UnsupportedByModel, Method, Tolerance, IterationLimit
/// ValueError
///     If ``permanent_set`` is true without ``hardness``, or if the units of gap and relative displacement differ.
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(48, 0.3e-3)
/// >>> steel = stickslip.Material(213e9, 0.29)
/// >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
/// >>> history = stickslip.History(bodies, stickslip.surface.sphere(grid, 3.5e-3), 0.5)
/// >>> step = history.step(normal_force=100.0)
/// >>> cycle = sum(history.step(force_x=force).energy.dissipated_energy for force in (30.0, -30.0, 30.0))
/// >>> history.step(force_x=0.0).shift[0] > 0.0  # without force, not without shear
/// True
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct History {
    pub(crate) work: Mutex<Work>,
    pub(super) bodies: HalfSpace,
}

pub(crate) struct Work {
    pub(crate) history: stickslip::History,
    /// Counter of the changes of the last step.
    pub(crate) taken: u64,
    /// Unit of the gap.
    pub(super) unit: Option<Unit>,
}

impl Work {
    /// Runs steps and increments the counter if they have changed the last step. A failed attempt can also change it.
    pub(super) fn tried<T>(
        &mut self,
        attempt: impl FnOnce(&mut stickslip::History) -> stickslip::Result<T>,
    ) -> stickslip::Result<T> {
        let numbers = |history: &stickslip::History| history.last_step().map(Numbers::of);
        let before = numbers(&self.history);
        let outcome = attempt(&mut self.history);
        // Two steps differ at least in their run times.
        let is_same = outcome.is_err() && numbers(&self.history) == before;
        self.taken += u64::from(!is_same);
        outcome
    }
}

/// Noun for a history in messages.
pub(crate) const NAME: &str = "history";

impl History {
    /// Wraps a history, with the unit of its gap.
    pub(crate) fn of(history: stickslip::History, bodies: &HalfSpace, unit: Option<Unit>) -> Self {
        let taken = 0;
        Self {
            work: Mutex::new(Work {
                history,
                taken,
                unit,
            }),
            bodies: bodies.clone(),
        }
    }

    pub(crate) fn cells(&self) -> usize {
        self.bodies.0.grid().cells()
    }

    pub(crate) fn grid(&self) -> stickslip::Grid {
        self.bodies.0.grid()
    }

    /// Reads the last step if it still has this number and led to the present state.
    pub(crate) fn read_step<T>(
        &self,
        number: u64,
        read: impl FnOnce(&Step) -> T,
    ) -> PyResult<Option<T>> {
        let work = lock(&self.work, NAME)?;
        let step = work.history.last_step().ok();
        Ok(step.filter(|_| work.taken == number).map(read))
    }

    pub(crate) fn read<T>(&self, read: impl FnOnce(&stickslip::History) -> T) -> PyResult<T> {
        Ok(read(&lock(&self.work, NAME)?.history))
    }

    pub(super) fn change(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&mut stickslip::History) -> stickslip::Result<()> + Send,
    ) -> PyResult<()> {
        let mut work = lock(&self.work, NAME)?;
        let history = &mut work.history;
        unobserved_on(py, self.grid(), || change(history))
    }
}

#[pymethods]
impl History {
    #[new]
    #[pyo3(signature = (bodies, gap, friction, *, axis=None, model=None, coupling=None, entry_rule=None,
        relative_displacement=None, hardness=None, permanent_set=false, settings=None, tolerance=None, method=None,
        max_iterations=None, time_limit=None))]
    fn new(
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        gap: Samples<'_>,
        friction: AnyFriction<'_>,
        axis: Option<Choice<Axis>>,
        model: Option<Choice<TangentialModel>>,
        coupling: Option<Choice<Coupling>>,
        entry_rule: Option<Choice<EntryRule>>,
        relative_displacement: Option<RelativeDisplacement>,
        hardness: Option<AnyHardness<'_>>,
        #[pyo3(from_py_with = crate::real::flag)] permanent_set: bool,
        settings: Option<Settings>,
        tolerance: Option<Real>,
        method: Option<Choice<cgm::Method>>,
        max_iterations: Option<Count>,
        time_limit: Option<Real>,
    ) -> PyResult<Self> {
        let settings = chosen(settings, tolerance, method, max_iterations, time_limit)?;
        if permanent_set && hardness.is_none() {
            return Err(PyValueError::new_err(
                "permanent_set=True has no effect without a hardness: give the largest pressure by hardness=",
            ));
        }
        let grid = bodies.0.grid();
        let gap = gap.gap_before_friction(py, grid)?;
        let friction = friction.on(py, grid)?;
        let hardness = hardness.map(|hardness| hardness.on(py, grid)).transpose()?;
        let Field(gap, mut unit) = gap;
        if let Some(relative) = &relative_displacement {
            check_relative("the gap", unit.as_ref(), relative.1.as_ref())?;
            unit = unit.or_else(|| relative.1.clone());
        }
        let history = unobserved_on(py, grid, || {
            let builder = stickslip::History::builder(&bodies.0, gap, friction);
            let mut builder = builder.settings(settings).permanent_set(permanent_set);
            if let Some(axis) = axis {
                builder = builder.axis(axis.0);
            }
            if let Some(model) = model {
                builder = builder.model(model.0);
            }
            if let Some(coupling) = coupling {
                builder = builder.coupling(coupling.0);
            }
            if let Some(rule) = entry_rule {
                builder = builder.entry_rule(rule.0);
            }
            if let Some(relative) = relative_displacement {
                builder = builder.relative_displacement(relative.0);
            }
            if let Some(hardness) = hardness {
                builder = builder.hardness(hardness);
            }
            builder.build()
        })?;
        Ok(Self::of(history, &bodies, unit))
    }

    /// Sets the gap of later steps (lengths), for example after wear.
    ///
    /// The gap is given without the yielded depth, which the history adds. To change the present gap, start from
    /// :attr:`gap_as_set`. With a permanent set, a gap that already contains the yielded depth is rejected.
    ///
    /// Raises
    /// ------
    /// GridMismatch, Shape, Sample
    /// UnsupportedByModel
    ///     If the history has a permanent set of ten cells or more and the gap already contains it.
    /// GapUnderLoad
    ///     If the gap is the gap under load of the present contact.
    /// ValueError
    ///     If the unit of the gap differs from :attr:`unit`; the gap is then unchanged.
    ///
    /// Examples
    /// --------
    /// >>> import stickslip
    /// >>> grid = stickslip.Grid.square(32, 0.3e-3)
    /// >>> steel = stickslip.Material(213e9, 0.29)
    /// >>> history = stickslip.History(stickslip.HalfSpace(grid, (steel, steel)), stickslip.surface.sphere(grid, 3.5e-3), 0.5)
    /// >>> step = history.step(normal_force=100.0)
    /// >>> step = history.step(normal_force=100.0, force_x=30.0)
    /// >>> depth = stickslip.wear.energy(1e-13, step.dissipation, grid=grid)
    /// >>> history.set_gap(history.gap_as_set + depth)
    /// >>> step = history.step(normal_force=100.0)
    fn set_gap(&self, py: Python<'_>, gap: Samples<'_>) -> PyResult<()> {
        let mut work = lock(&self.work, NAME)?;
        let Field(gap, unit) = gap.next_gap(py, self.grid(), work.unit.as_ref())?;
        let history = &mut work.history;
        unobserved_on(py, self.grid(), || history.set_gap(&gap))?;
        work.unit = unit;
        Ok(())
    }

    /// Sets the friction of later steps. A law or a coefficient replaces the last law, with its ``max_shear_stress``. A coefficient
    /// alone has none; a warning is issued if the last law had one. :meth:`stiffness` and :meth:`edges` raise
    /// ``OutdatedSolution`` until the next step.
    fn set_friction(&self, py: Python<'_>, friction: AnyFriction<'_>) -> PyResult<()> {
        let is_law = friction.is_law();
        let friction = friction.on(py, self.grid())?;
        let mut last = None;
        self.change(py, |history| {
            last = history.state().friction().cap();
            history.set_friction(&friction)
        })?;
        warn_of_lost_cap(py, last, is_law)
    }

    /// Sets the pattern of the relative displacement.
    ///
    /// Raises
    /// ------
    /// GridMismatch
    /// ValueError
    ///     If the unit of the pattern differs from :attr:`unit`.
    fn set_relative_displacement(
        &self,
        py: Python<'_>,
        pattern: RelativeDisplacement,
    ) -> PyResult<()> {
        let mut work = lock(&self.work, NAME)?;
        check_relative("the gap", work.unit.as_ref(), pattern.1.as_ref())?;
        let history = &mut work.history;
        unobserved_on(py, self.grid(), || {
            history.set_relative_displacement(&pattern.0)
        })?;
        work.unit = work.unit.take().or(pattern.1);
        Ok(())
    }

    /// Method, tolerance and limits of later steps; assignable.
    #[getter]
    fn settings(&self) -> PyResult<Settings> {
        self.read(|history| Settings(*history.settings()))
    }

    #[setter]
    fn set_settings(&self, py: Python<'_>, settings: Settings) -> PyResult<()> {
        self.change(py, |history| history.set_settings(settings.0))
    }
}
