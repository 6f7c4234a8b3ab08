//! A history, step by step.

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::{Arc, Mutex};

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyType};
use rayon::prelude::*;
use stickslip::history::{StepResult as Step, TouchRule};
use stickslip::{Axis, Coupling, Error, TangentialModel, cgm};

use crate::array::{Array, copy, zones};
use crate::choice::Choice;
use crate::error::{OrRaise, raised};
use crate::field::Samples;
use crate::friction::{AnyFriction, AnyHardness, Friction};
use crate::grid::{Boundary, Grid};
use crate::half_space::HalfSpace;
use crate::held::{lock, pair};
use crate::history::{State, StepResult};
use crate::load::{self, LoadStep, Tangential};
use crate::normal::NormalSolution;
use crate::pickle::ByItself;
use crate::progress::Progress;
use crate::report::warn;
use crate::settings::{Settings, chosen};
use crate::spots::ContactSpots;
use crate::stiffness::ContactStiffness;
use crate::tangential::RelativeDisplacement;
use crate::work::{solve, unobserved};

/// The class, the bodies and the bytes of a history.
type Saved<'py> = (Bound<'py, PyType>, HalfSpace, Bound<'py, PyBytes>);

/// Two bodies in contact that remember their load: pressure, traction, slip and energy, step by step.
///
/// Its arrays are copies, since the next step changes them; :meth:`state` is a snapshot whose arrays are views. One thread
/// at a time may use it. A step that fails, or that Ctrl-C ends, leaves it as it was.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
/// gap : Field or array_like of shape (ny, nx)
///     The gap before loading (lengths); copied.
/// friction : Friction, float or array_like of shape (ny, nx)
/// axis : Axis or str, default "x"
///     Of the scalar model.
/// model : TangentialModel or str, default "scalar"
///     "vector" takes loads of any direction, and twist.
/// coupling : Coupling or str, default "full"
/// touch_rule : TouchRule or str, default "growth"
/// relative_displacement : RelativeDisplacement, optional
///     The pattern; steps prescribe its amount.
/// hardness : Hardness, float or array_like, optional
/// permanent_set : bool, default False
///     Whether what yields under the hardness stays.
/// settings, tolerance, method, max_iterations, time_limit : optional
///     As of :class:`Settings`.
///
/// Raises
/// ------
/// GridMismatch, Shape, Sample, NotModelled, Method, Tolerance, IterationLimit
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
    bodies: HalfSpace,
}

pub(crate) struct Work {
    pub(crate) history: stickslip::History,
    /// Counts what changes the last step.
    pub(crate) taken: u64,
}

const NAME: &str = "history";

impl History {
    fn of(history: stickslip::History, bodies: &HalfSpace) -> Self {
        Self {
            work: Mutex::new(Work { history, taken: 0 }),
            bodies: bodies.clone(),
        }
    }

    pub(crate) fn cells(&self) -> usize {
        self.bodies.0.grid().cells()
    }

    pub(crate) fn grid(&self) -> stickslip::Grid {
        self.bodies.0.grid()
    }

    /// The last step, if it still is the one of this number.
    pub(crate) fn read_step<T>(
        &self,
        number: u64,
        read: impl FnOnce(&Step) -> T,
    ) -> PyResult<Option<T>> {
        let work = lock(&self.work, NAME)?;
        Ok((work.taken == number).then(|| read(work.history.last_step())))
    }

    pub(crate) fn read<T>(&self, read: impl FnOnce(&stickslip::History) -> T) -> PyResult<T> {
        Ok(read(&lock(&self.work, NAME)?.history))
    }

    fn change(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&mut stickslip::History) -> stickslip::Result<()> + Send,
    ) -> PyResult<()> {
        let mut work = lock(&self.work, NAME)?;
        let history = &mut work.history;
        unobserved(py, self.cells(), || change(history))
    }
}

#[pymethods]
impl History {
    #[new]
    #[pyo3(signature = (bodies, gap, friction, *, axis=None, model=None, coupling=None, touch_rule=None,
        relative_displacement=None, hardness=None, permanent_set=false, settings=None, tolerance=None, method=None,
        max_iterations=None, time_limit=None))]
    fn new(
        py: Python<'_>,
        bodies: &HalfSpace,
        gap: Samples<'_>,
        friction: AnyFriction<'_>,
        axis: Option<Choice<Axis>>,
        model: Option<Choice<TangentialModel>>,
        coupling: Option<Choice<Coupling>>,
        touch_rule: Option<Choice<TouchRule>>,
        relative_displacement: Option<RelativeDisplacement>,
        hardness: Option<AnyHardness<'_>>,
        permanent_set: bool,
        settings: Option<Settings>,
        tolerance: Option<f64>,
        method: Option<Choice<cgm::Method>>,
        max_iterations: Option<usize>,
        time_limit: Option<f64>,
    ) -> PyResult<Self> {
        let settings = chosen(settings, tolerance, method, max_iterations, time_limit)?;
        let grid = bodies.0.grid();
        let gap = gap.on(py, "gap", grid)?;
        let friction = friction.on(py, grid)?;
        let hardness = hardness.map(|hardness| hardness.on(py, grid)).transpose()?;
        let history = unobserved(py, grid.cells(), || {
            let builder = stickslip::History::builder(&bodies.0, &gap, friction);
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
            if let Some(rule) = touch_rule {
                builder = builder.touch_rule(rule.0);
            }
            if let Some(relative) = relative_displacement {
                builder = builder.relative_displacement(relative.0);
            }
            if let Some(hardness) = hardness {
                builder = builder.hardness(hardness);
            }
            builder.build()
        })?;
        Ok(Self::of(history, bodies))
    }

    /// Takes a step, by a :class:`LoadStep` or its keywords; what is not named is held.
    ///
    /// Parameters
    /// ----------
    /// load : LoadStep, optional
    /// normal_force, approach, force, shift, spring, force_x, ... : optional
    ///     As of :class:`LoadStep`.
    /// progress : callable or bool, optional
    ///     As of :meth:`NormalProblem.solve`.
    /// warn : bool, default False
    ///     Whether the remarks on the step go to ``warnings.warn`` too.
    ///
    /// Returns
    /// -------
    /// StepResult
    ///     Its fields last until the next step; see :meth:`StepResult.keep`.
    ///
    /// Raises
    /// ------
    /// NotFinite, Negative, NotPositive, ApproachBeyondMeanGap, NotModelled, BeyondFrictionCapacity, NotConverged
    #[pyo3(signature = (load=None, *, normal_force=None, approach=None, force=None, shift=None, spring=None,
        force_x=None, force_y=None, shift_x=None, shift_y=None, spring_x=None, spring_y=None, twist=None,
        relative_displacement=None, progress=None, warn=false))]
    fn step<'py>(
        slf: &Bound<'py, Self>,
        load: Option<LoadStep>,
        normal_force: Option<f64>,
        approach: Option<f64>,
        force: Option<[f64; 2]>,
        shift: Option<[f64; 2]>,
        spring: Option<([f64; 2], f64)>,
        force_x: Option<f64>,
        force_y: Option<f64>,
        shift_x: Option<f64>,
        shift_y: Option<f64>,
        spring_x: Option<(f64, f64)>,
        spring_y: Option<(f64, f64)>,
        twist: Option<f64>,
        relative_displacement: Option<f64>,
        progress: Option<Bound<'py, PyAny>>,
        warn: bool,
    ) -> PyResult<StepResult> {
        let py = slf.py();
        let given = Tangential {
            force,
            shift,
            spring,
            force_x,
            force_y,
            shift_x,
            shift_y,
            spring_x,
            spring_y,
        };
        let normal = load::normal(normal_force, approach)?;
        let is_bare = normal.is_none() && twist.is_none() && relative_displacement.is_none();
        let by_keywords = given.step(normal, twist, relative_displacement)?;
        let load = match load {
            None => by_keywords,
            Some(load) if is_bare && given.is_empty() => load.0,
            Some(_) => {
                return Err(PyTypeError::new_err(
                    "give a load or its keywords, not both",
                ));
            }
        };
        let progress = Progress::of(progress.as_ref())?;
        let own = slf.get();
        let mut work = lock(&own.work, NAME)?;
        work.taken += 1;
        let number = work.taken;
        let history = &mut work.history;
        let outcome = solve(py, own.cells(), progress, |observer| {
            let seen = |iteration: &_| observer(Some(iteration));
            history.step_observed(&load, seen).map(|_| ())
        })?;
        outcome.or_raise(py)?;
        let step = StepResult::last(work.history.last_step(), slf.clone().unbind(), number);
        drop(work);
        self::warn(py, warn, || step.warnings_of())?;
        Ok(step)
    }

    /// Takes a step of each of many histories, at once.
    ///
    /// Parameters
    /// ----------
    /// histories : sequence of History
    /// loads : sequence of LoadStep
    ///
    /// Returns
    /// -------
    /// list of (int, StickslipError)
    ///     Those whose step has failed; they are as they were.
    #[staticmethod]
    fn step_all<'py>(
        py: Python<'py>,
        histories: Vec<Bound<'py, Self>>,
        loads: Vec<LoadStep>,
    ) -> PyResult<Vec<(usize, Bound<'py, PyAny>)>> {
        let (expected, found) = (histories.len(), loads.len());
        if expected != found {
            let quantity = "loads of the contacts";
            return Err(raised(
                py,
                Error::Length {
                    quantity,
                    expected,
                    found,
                },
            ));
        }
        let mut places = Vec::with_capacity(histories.len());
        for history in &histories {
            // One that is named twice is in use by its first step.
            let mut place = lock(&history.get().work, NAME)?;
            place.taken += 1;
            places.push(place);
        }
        let cells = histories.iter().map(|history| history.get().cells()).sum();
        let contacts = places.iter_mut().map(|place| &mut place.history);
        let mut contacts: Vec<_> = contacts.zip(&loads).enumerate().collect();
        let failed = solve(py, cells, Progress::none(), |observer| {
            let observer = Mutex::new(observer);
            let step =
                |(index, (history, load)): &mut (usize, (&mut stickslip::History, &LoadStep))| {
                    let seen = |_: &_| {
                        observer
                            .lock()
                            .map_or(ControlFlow::Continue(()), |mut seen| seen(None))
                    };
                    let outcome = history.step_observed(&load.0, seen);
                    outcome.err().map(|error| (*index, error))
                };
            Ok(contacts.par_iter_mut().filter_map(step).collect::<Vec<_>>())
        })?;
        let failed = failed.or_raise(py)?;
        let exception = |error| raised(py, error).into_value(py).into_bound(py).into_any();
        Ok(failed
            .into_iter()
            .map(|(index, error)| (index, exception(error)))
            .collect())
    }

    /// What the last step did.
    #[getter]
    fn last_step(slf: &Bound<'_, Self>) -> PyResult<StepResult> {
        let work = lock(&slf.get().work, NAME)?;
        Ok(StepResult::last(
            work.history.last_step(),
            slf.clone().unbind(),
            work.taken,
        ))
    }

    /// A snapshot of the state.
    fn state(&self) -> PyResult<State> {
        self.read(|history| State(Arc::new(history.state().clone())))
    }

    /// Returns to a state, of this history or of another on equal bodies.
    fn set_state(&self, py: Python<'_>, state: &State) -> PyResult<()> {
        self.change(py, |history| history.set_state(&state.0))
    }

    /// A history that continues from a state, on the bodies it belongs to.
    #[staticmethod]
    fn from_state(py: Python<'_>, bodies: &HalfSpace, state: &State) -> PyResult<Self> {
        let history = unobserved(py, bodies.0.grid().cells(), || {
            stickslip::History::from_state(&bodies.0, (*state.0).clone())
        })?;
        Ok(Self::of(history, bodies))
    }

    /// Its bytes: all that the next step needs but the bodies.
    fn to_bytes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = self.read(stickslip::History::to_bytes)?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// A history from its bytes, on the bodies it had; it continues to the same bits.
    #[staticmethod]
    fn from_bytes(py: Python<'_>, bodies: &HalfSpace, bytes: &[u8]) -> PyResult<Self> {
        let history = unobserved(py, bodies.0.grid().cells(), || {
            stickslip::History::from_bytes(&bodies.0, bytes)
        })?;
        Ok(Self::of(history, bodies))
    }

    /// Saves the state in a file, which is replaced as a whole or not at all.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        self.read(|history| history.save(&path))?.or_raise(py)
    }

    /// A history from a file of :meth:`save`, on the bodies it had.
    #[staticmethod]
    fn load(py: Python<'_>, bodies: &HalfSpace, path: PathBuf) -> PyResult<Self> {
        let history = unobserved(py, bodies.0.grid().cells(), || {
            stickslip::History::load(&bodies.0, &path)
        })?;
        Ok(Self::of(history, bodies))
    }

    /// Changes the gap of later steps, as wear does.
    fn set_gap(&self, py: Python<'_>, gap: Samples<'_>) -> PyResult<()> {
        let gap = gap.on(py, "gap", self.grid())?;
        self.change(py, |history| history.set_gap(&gap))
    }

    /// Changes the friction of later steps.
    fn set_friction(&self, py: Python<'_>, friction: AnyFriction<'_>) -> PyResult<()> {
        let friction = friction.on(py, self.grid())?;
        self.change(py, |history| history.set_friction(&friction))
    }

    /// Changes the pattern of the relative displacement.
    fn set_relative_displacement(
        &self,
        py: Python<'_>,
        pattern: RelativeDisplacement,
    ) -> PyResult<()> {
        self.change(py, |history| history.set_relative_displacement(&pattern.0))
    }

    /// Method, tolerance and limits of later steps; may be assigned.
    #[getter]
    fn settings(&self) -> PyResult<Settings> {
        self.read(|history| Settings(*history.settings()))
    }

    #[setter]
    fn set_settings(&self, py: Python<'_>, settings: Settings) -> PyResult<()> {
        self.change(py, |history| history.set_settings(settings.0))
    }

    /// The bodies.
    #[getter]
    fn bodies(&self) -> HalfSpace {
        self.bodies.clone()
    }

    /// The grid.
    #[getter(grid)]
    fn own_grid(&self) -> Grid {
        Grid(self.grid())
    }

    /// What lies beyond the edge of the grid.
    #[getter]
    fn boundary(&self) -> Boundary {
        Boundary(self.bodies.0.boundary())
    }

    /// The axis of the scalar model; ``None`` in the vector model.
    #[getter]
    fn axis(&self) -> PyResult<Option<Choice<Axis>>> {
        self.read(|history| history.axis().map(Choice))
    }

    /// The friction.
    #[getter]
    fn friction(&self) -> PyResult<Friction> {
        self.read(|history| Friction(history.friction().clone()))
    }

    /// The gap before loading, a copy.
    #[getter]
    fn gap<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.read(|history| copy(py, history.gap()))
    }

    /// The normal contact, a copy.
    #[getter]
    fn normal(&self) -> PyResult<NormalSolution> {
        self.read(|history| NormalSolution::own(Arc::new(history.normal().clone())))
    }

    /// Pressure, a copy.
    #[getter]
    fn pressure<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.read(|history| copy(py, history.pressure()))
    }

    /// Approach (a length).
    #[getter]
    fn approach(&self) -> PyResult<f64> {
        self.read(stickslip::History::approach)
    }

    /// Traction along x and y, copies.
    #[getter]
    fn traction<'py>(&self, py: Python<'py>) -> PyResult<(Array<'py>, Array<'py>)> {
        self.read(|history| history.traction().map(|field| copy(py, field)).into())
    }

    /// Slip since the start along x and y (lengths), copies.
    #[getter]
    fn slip<'py>(&self, py: Python<'py>) -> PyResult<(Array<'py>, Array<'py>)> {
        self.read(|history| history.slip().map(|field| copy(py, field)).into())
    }

    /// Length of the path that each cell slipped since the start, a copy.
    #[getter]
    fn accumulated_slip<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.read(|history| copy(py, history.accumulated_slip()))
    }

    /// Energy that each cell dissipated since the start, a copy.
    #[getter]
    fn dissipated_energy<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.read(|history| copy(py, history.dissipated_energy()))
    }

    /// Displacement of body 1 relative to body 2 by the tractions along x and y (lengths): one product.
    fn displacement<'py>(&self, py: Python<'py>) -> PyResult<(Array<'py>, Array<'py>)> {
        let mut work = lock(&self.work, NAME)?;
        let history = &mut work.history;
        let moved = unobserved(py, self.cells(), || history.displacement())?;
        Ok(moved.each_ref().map(|field| copy(py, field)).into())
    }

    /// The zone of every cell: 0 separated, 1 stick, 2 slip.
    #[getter]
    fn zones<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.read(|history| zones(py, history.grid(), history.zones()))
    }

    /// Shift of body 2 relative to body 1 since the start (lengths).
    #[getter]
    fn shift(&self) -> PyResult<(f64, f64)> {
        self.read(|history| pair(history.shift()))
    }

    /// Rotation of body 2 since the start (radians).
    #[getter]
    fn twist(&self) -> PyResult<f64> {
        self.read(stickslip::History::twist)
    }

    /// Tangential force that body 2 exerts on body 1.
    #[getter]
    fn force(&self) -> PyResult<(f64, f64)> {
        self.read(|history| pair(history.force()))
    }

    /// Moment about z, at the origin, on body 1.
    #[getter]
    fn moment(&self) -> PyResult<f64> {
        self.read(stickslip::History::moment)
    }

    /// Largest tangential force that friction holds.
    #[getter]
    fn friction_capacity(&self) -> PyResult<f64> {
        self.read(stickslip::History::friction_capacity)
    }

    /// Steps taken since the start.
    #[getter]
    fn steps(&self) -> PyResult<u64> {
        self.read(stickslip::History::steps)
    }

    /// The contact spots, with their stick ratios.
    #[getter]
    fn spots(&self) -> PyResult<ContactSpots> {
        self.read(|history| ContactSpots::of(history.spots()))
    }

    /// The slopes of the forces by approach, shift and twist.
    fn stiffness(&self, py: Python<'_>) -> PyResult<ContactStiffness> {
        let mut work = lock(&self.work, NAME)?;
        let history = &mut work.history;
        unobserved(py, self.cells(), || history.stiffness()).map(ContactStiffness)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<ByItself<'py, Saved<'py>>> {
        let restore = slf
            .py()
            .import("stickslip._stickslip")?
            .getattr("_history_from_bytes")?;
        let own = slf.get();
        Ok((
            restore,
            (slf.get_type(), own.bodies(), own.to_bytes(slf.py())?),
        ))
    }

    fn __repr__(&self) -> PyResult<String> {
        self.read(|history| {
            let ([force_x, force_y], [x, y]) = (history.force(), history.shift());
            format!(
                "History(steps={}, normal_force={:.6e}, force=({force_x:.6e}, {force_y:.6e}), shift=({x:.6e}, {y:.6e}))",
                history.steps(),
                history.normal().force()
            )
        })
    }
}

/// What pickle calls for a history.
#[pyfunction]
pub(crate) fn _history_from_bytes<'py>(
    kind: Bound<'py, PyType>,
    bodies: HalfSpace,
    bytes: Bound<'py, PyBytes>,
) -> PyResult<Bound<'py, PyAny>> {
    kind.call_method1("from_bytes", (bodies, bytes))
}
