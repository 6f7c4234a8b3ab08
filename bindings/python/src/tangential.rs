//! Tangential contact under a given pressure.

use std::sync::{Arc, Mutex};

use pyo3::exceptions::{PyRuntimeError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::PyType;
#[cfg(feature = "stubs")]
use pyo3::{PyTypeInfo, inspect::PyStaticExpr, type_hint_identifier, type_hint_union};
use stickslip::{Coupling, PressureSource, TangentialModel, cgm};

use crate::array::{Array, copy, view, zones};
use crate::choice::Choice;
use crate::error::{OrRaise, with_iterate};
use crate::field::{Field, Samples};
use crate::friction::AnyFriction;
use crate::grid::{Boundary, ElasticPair, Grid};
use crate::half_space::HalfSpace;
use crate::held::{Spare, lock, pair};
use crate::load::{Tangential, TangentialLoad};
use crate::normal::NormalSolution;
use crate::pickle::{Reduced, Stored, reduced};
use crate::progress::Progress;
use crate::report::{Report, Warning, warn};
use crate::settings::{Settings, chosen};
use crate::spots::ContactSpots;
use crate::stiffness::TangentialStiffness;
use crate::work::{solve, unobserved};

/// Whose memory a tangential solution is.
enum Source {
    Own(Arc<stickslip::TangentialSolution>),
    OfCoupled(Arc<stickslip::CoupledSolution>),
}

/// Traction, slip, zones and shift of a tangential contact. Vectors are (x, y); the scalar model leaves the component
/// across the load at zero. Arrays are read-only views of its memory, those of the zones a copy.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct TangentialSolution(Source);

impl TangentialSolution {
    pub(crate) fn own(solution: Arc<stickslip::TangentialSolution>) -> Self {
        Self(Source::Own(solution))
    }

    pub(crate) fn of_coupled(solution: &Arc<stickslip::CoupledSolution>) -> Self {
        Self(Source::OfCoupled(Arc::clone(solution)))
    }

    pub(crate) fn get(&self) -> &stickslip::TangentialSolution {
        match &self.0 {
            Source::Own(solution) => solution,
            Source::OfCoupled(solution) => solution.shear(),
        }
    }
}

impl Stored for TangentialSolution {
    type Content = stickslip::TangentialSolution;

    const KIND: &'static str = "TangentialSolution";

    fn of_content(content: Self::Content) -> Self {
        Self::own(Arc::new(content))
    }
}

#[pymethods]
impl TangentialSolution {
    /// The grid of its fields.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.get().grid())
    }

    /// Shear traction on body 1 along x and y (pressures); exactly zero outside the contact.
    #[getter]
    fn traction<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |solution| solution.get().traction()[0]),
            view(slf, |solution| solution.get().traction()[1]),
        )
    }

    /// Slip of the surface of body 1 over that of body 2 along x and y (lengths); exactly zero in stick cells.
    #[getter]
    fn slip<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |solution| solution.get().slip()[0]),
            view(slf, |solution| solution.get().slip()[1]),
        )
    }

    /// The zone of every cell, bytes of shape (ny, nx): the numbers of :class:`Zone`, 0 separated, 1 stick, 2 slip.
    #[getter]
    fn zones<'py>(&self, py: Python<'py>) -> Array<'py> {
        zones(py, self.get().grid(), self.get().zones())
    }

    /// The axis of the load in the scalar model, ``None`` in the vector model.
    #[getter]
    fn axis(&self) -> Option<Choice<stickslip::Axis>> {
        self.get().axis().map(Choice)
    }

    /// Shift, the rigid motion of body 2 relative to body 1 along x and y (lengths).
    #[getter]
    fn shift(&self) -> (f64, f64) {
        pair(self.get().shift())
    }

    /// Rotation of body 2 about the origin of the grid (radians).
    #[getter]
    fn twist(&self) -> f64 {
        self.get().twist()
    }

    /// Tangential force that body 2 exerts on body 1.
    #[getter]
    fn force(&self) -> (f64, f64) {
        pair(self.get().force())
    }

    /// Moment about z, at the origin, on body 1.
    #[getter]
    fn moment(&self) -> f64 {
        self.get().moment()
    }

    /// Whether the whole contact slips.
    #[getter]
    fn is_gross_slip(&self) -> bool {
        self.get().is_gross_slip()
    }

    /// Stick area over contact area, by counting cells.
    #[getter]
    fn stick_ratio(&self) -> f64 {
        self.get().stick_ratio()
    }

    /// Area of the stick zone.
    #[getter]
    fn stick_area(&self) -> f64 {
        self.get().stick_area()
    }

    /// Area of the slip zone.
    #[getter]
    fn slip_area(&self) -> f64 {
        self.get().slip_area()
    }

    /// Energy dissipated by the step.
    #[getter]
    fn dissipated_energy(&self) -> f64 {
        self.get().dissipated_energy()
    }

    /// What lies beyond the edge of the grid.
    #[getter]
    fn boundary(&self) -> Boundary {
        Boundary(self.get().boundary())
    }

    /// How the solve ended, what it cost, how large its error can be.
    #[getter]
    fn report(&self) -> Report {
        Report::of(self.get().report())
    }

    /// Remarks that the result may mislead.
    #[getter]
    fn warnings(&self) -> Vec<Warning> {
        Warning::all(self.get().warnings())
    }

    /// The contact spots of the normal contact below it, with their stick ratios.
    fn spots(&self, py: Python<'_>, normal: &NormalSolution) -> PyResult<ContactSpots> {
        self.get()
            .spots(normal.get())
            .or_raise(py)
            .map(ContactSpots::of)
    }

    /// Displacement of body 1 relative to body 2 by the tractions along x and y, of all cells (lengths): one product.
    fn displacement<'py>(
        &self,
        py: Python<'py>,
        bodies: &HalfSpace,
    ) -> PyResult<(Array<'py>, Array<'py>)> {
        let solution = self.get();
        let moved = unobserved(py, solution.grid().cells(), || {
            solution.displacement(&bodies.0)
        })?;
        Ok(moved.each_ref().map(|field| copy(py, field)).into())
    }

    /// Elastic energy of shear: one product.
    fn elastic_energy(&self, py: Python<'_>, bodies: &HalfSpace) -> PyResult<f64> {
        let solution = self.get();
        unobserved(py, solution.grid().cells(), || {
            solution.elastic_energy(&bodies.0)
        })
    }

    /// The tangential stiffness, on loading and at reversal.
    fn stiffness(&self, py: Python<'_>, bodies: &HalfSpace) -> PyResult<TangentialStiffness> {
        let solution = self.get();
        let found = unobserved(py, solution.grid().cells(), || {
            solution.stiffness(&bodies.0)
        });
        found.map(TangentialStiffness)
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.get() == other.get()
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced::<Self>(py, self.get())
    }

    fn __repr__(&self) -> String {
        let solution = self.get();
        let ([force_x, force_y], [x, y]) = (solution.force(), solution.shift());
        format!(
            "TangentialSolution(force=({force_x:.6e}, {force_y:.6e}), shift=({x:.6e}, {y:.6e}), stick_ratio={:.4}, {})",
            solution.stick_ratio(),
            solution.report().status
        )
    }
}

/// A pressure: a solved normal contact, or a field.
pub(crate) struct Pressure<'py>(Bound<'py, PyAny>);

impl<'py> FromPyObject<'_, 'py> for Pressure<'py> {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        NormalSolution::TYPE_HINT,
        Field::TYPE_HINT,
        type_hint_identifier!("numpy.typing", "ArrayLike")
    );

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        Ok(Self(object.to_owned()))
    }
}

/// It with its memory held.
enum Given<'a> {
    Solved(&'a stickslip::NormalSolution),
    Field(Arc<stickslip::Field>),
}

impl Given<'_> {
    fn source(&self) -> PressureSource<'_> {
        match self {
            Self::Solved(solution) => PressureSource::Solved(solution),
            Self::Field(field) => PressureSource::Prescribed(field),
        }
    }
}

impl Pressure<'_> {
    fn given(&self, py: Python<'_>, grid: stickslip::Grid) -> PyResult<Given<'_>> {
        if let Ok(solution) = self.0.cast::<NormalSolution>() {
            return Ok(Given::Solved(solution.get().get()));
        }
        let samples: Samples<'_> = self.0.extract()?;
        samples.on(py, "pressure", grid).map(Given::Field)
    }
}

/// A displacement of body 1 relative to body 2 that the contact does not cause: bulk strain, thermal expansion.
///
/// Parameters
/// ----------
/// along_x, along_y : Field or array_like of shape (ny, nx)
///     Lengths.
/// grid : Grid, optional
///     Where arrays live; Fields know it.
///
/// Raises
/// ------
/// GridMismatch, Sample
#[pyclass(frozen, eq, module = "stickslip.tangential", from_py_object)]
#[derive(Clone, PartialEq)]
pub(crate) struct RelativeDisplacement(pub(crate) stickslip::tangential::RelativeDisplacement);

#[pymethods]
impl RelativeDisplacement {
    #[new]
    #[pyo3(signature = (along_x, along_y, *, grid=None))]
    fn new(
        py: Python<'_>,
        along_x: Samples<'_>,
        along_y: Samples<'_>,
        grid: Option<&Grid>,
    ) -> PyResult<Self> {
        let grid = crate::field::grid_of(grid, &along_x, "along_x")?;
        let fields = [
            (*along_x.on(py, "along_x", grid)?).clone(),
            (*along_y.on(py, "along_y", grid)?).clone(),
        ];
        let relative = stickslip::tangential::RelativeDisplacement::new(fields);
        relative.or_raise(py).map(Self)
    }

    /// That of a uniform strain ``[[xx, xy], [yx, yy]]`` of body 1, none at the origin.
    #[staticmethod]
    fn bulk_strain(py: Python<'_>, grid: &Grid, strain: [[f64; 2]; 2]) -> PyResult<Self> {
        let relative = stickslip::tangential::RelativeDisplacement::bulk_strain(grid.0, strain);
        relative.or_raise(py).map(Self)
    }

    /// Its components along x and y.
    #[getter]
    fn fields<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |relative| relative.0.fields()[0]),
            view(slf, |relative| relative.0.fields()[1]),
        )
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyType>, (Field, Field)) {
        let fields = slf.get().0.fields().map(|field| Field::from(field.clone()));
        (slf.get_type(), fields.into())
    }

    fn __repr__(&self) -> String {
        let grid = self.0.fields()[0].grid();
        format!("RelativeDisplacement({} x {} cells)", grid.nx(), grid.ny())
    }
}

/// Bodies, pressure, friction and tangential load: one monotonic step from the unsheared state.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
/// pressure : NormalSolution, Field or array_like of shape (ny, nx)
/// friction : Friction, float or array_like of shape (ny, nx)
///     A number is a coefficient of friction.
/// load : TangentialLoad, optional
///     Instead of the keywords that :class:`TangentialLoad` has too: ``force``, ``shift``, ``spring``, ``force_x`` ...
/// model : TangentialModel or str, default "scalar"
/// coupling : Coupling or str, default "one_way"
/// relative_displacement : RelativeDisplacement, optional
/// settings, tolerance, method, max_iterations, time_limit : optional
///     As of :class:`Settings`.
///
/// Raises
/// ------
/// NotConverged, Sample, GridMismatch, BoundaryMismatch, MaterialMismatch, CoupledMaterials, ObliqueLoad, NotModelled,
/// NotFinite, EmptyContact, BeyondFrictionCapacity, Tolerance, IterationLimit
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(64, 0.3e-3)
/// >>> steel = stickslip.Material(213e9, 0.29)
/// >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
/// >>> ball = stickslip.surface.sphere(grid, 3.5e-3)
/// >>> normal = stickslip.NormalProblem(bodies, ball, force=100.0).solve()
/// >>> shear = stickslip.TangentialProblem(bodies, normal, 0.5, force_x=20.0).solve()
/// >>> hertz = stickslip.analytical.HertzSphere(bodies.pair, 3.5e-3, 100.0)
/// >>> exact = stickslip.analytical.CattaneoMindlin(hertz, 0.5, 20.0)
/// >>> abs(shear.stick_ratio - exact.stick_ratio) < 0.02
/// True
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct TangentialProblem(stickslip::TangentialProblem, Grid);

#[pymethods]
impl TangentialProblem {
    #[new]
    #[pyo3(signature = (bodies, pressure, friction, load=None, *, force=None, shift=None, spring=None, force_x=None,
        force_y=None, shift_x=None, shift_y=None, spring_x=None, spring_y=None, twist=None, model=None, coupling=None,
        relative_displacement=None, settings=None, tolerance=None, method=None, max_iterations=None, time_limit=None))]
    fn new(
        py: Python<'_>,
        bodies: &HalfSpace,
        pressure: Pressure<'_>,
        friction: AnyFriction<'_>,
        load: Option<TangentialLoad>,
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
        model: Option<Choice<TangentialModel>>,
        coupling: Option<Choice<Coupling>>,
        relative_displacement: Option<RelativeDisplacement>,
        settings: Option<Settings>,
        tolerance: Option<f64>,
        method: Option<Choice<cgm::Method>>,
        max_iterations: Option<usize>,
        time_limit: Option<f64>,
    ) -> PyResult<Self> {
        let settings = chosen(settings, tolerance, method, max_iterations, time_limit)?;
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
        let load = whole_load(load, &given, twist)?;
        let grid = bodies.0.grid();
        let friction = friction.on(py, grid)?;
        let pressure = pressure.given(py, grid)?;
        let built = unobserved(py, grid.cells(), || {
            let builder =
                stickslip::TangentialProblem::builder(&bodies.0, pressure.source(), friction, load);
            let mut builder = builder.settings(settings);
            if let Some(model) = model {
                builder = builder.model(model.0);
            }
            if let Some(coupling) = coupling {
                builder = builder.coupling(coupling.0);
            }
            if let Some(relative) = relative_displacement {
                builder = builder.relative_displacement(relative.0);
            }
            builder.build()
        })?;
        Ok(Self(built, Grid(grid)))
    }

    /// Largest tangential force that friction holds.
    #[getter]
    fn friction_capacity(&self) -> f64 {
        self.0.friction_capacity()
    }

    /// Solves once; see :meth:`NormalProblem.solve`.
    #[pyo3(signature = (*, progress=None, warn=false))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        warn: bool,
    ) -> PyResult<Bound<'py, TangentialSolution>> {
        let progress = Progress::of(progress.as_ref())?;
        let mut solution = None;
        let outcome = solve(py, self.1.0.cells(), progress, |observer| {
            let mut solver = self.0.clone().into_solver()?;
            let solution = solution.insert(solver.new_solution());
            solver.solve_observed(solution, |iteration| observer(Some(iteration)))
        })?;
        finished(py, outcome, solution.map(Arc::new), warn)
    }

    /// The reusable form.
    fn solver(&self, py: Python<'_>) -> PyResult<TangentialSolver> {
        let solver = unobserved(py, self.1.0.cells(), || self.0.clone().into_solver())?;
        let work = Work {
            solver,
            spare: Spare::new(),
        };
        Ok(TangentialSolver {
            work: Mutex::new(work),
            grid: self.1,
        })
    }

    fn __repr__(&self) -> String {
        format!(
            "TangentialProblem({} x {} cells, friction_capacity={})",
            self.1.0.nx(),
            self.1.0.ny(),
            self.0.friction_capacity()
        )
    }
}

/// A load as an object or by keywords.
pub(crate) fn whole_load(
    load: Option<TangentialLoad>,
    given: &Tangential,
    twist: Option<f64>,
) -> PyResult<stickslip::TangentialLoad> {
    let by_keywords = given.load(twist)?;
    match load {
        None => Ok(by_keywords),
        Some(load) if given.is_empty() && twist.is_none() => Ok(load.0),
        Some(_) => Err(PyTypeError::new_err(
            "give a load or its keywords, not both",
        )),
    }
}

fn finished(
    py: Python<'_>,
    outcome: stickslip::Result<()>,
    solution: Option<Arc<stickslip::TangentialSolution>>,
    is_warned: bool,
) -> PyResult<Bound<'_, TangentialSolution>> {
    let object = || {
        let solution = solution.ok_or_else(|| PyRuntimeError::new_err("the solve left nothing"))?;
        Bound::new(py, TangentialSolution::own(solution))
    };
    match outcome {
        Ok(()) => {
            let solution = object()?;
            warn(py, is_warned, || solution.get().get().warnings())?;
            Ok(solution)
        }
        Err(error) => Err(with_iterate(py, error, || object().map(Bound::into_any))),
    }
}

/// Solves tangential contacts again and again, each time from the last answer; made by
/// :meth:`TangentialProblem.solver`. Load, friction and pressure may change between calls. It does not remember slip.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct TangentialSolver {
    work: Mutex<Work>,
    grid: Grid,
}

struct Work {
    solver: stickslip::TangentialSolver,
    spare: Spare<stickslip::TangentialSolution>,
}

#[pymethods]
impl TangentialSolver {
    /// Solves, for this load if one is given.
    #[pyo3(signature = (load=None, *, force=None, shift=None, spring=None, force_x=None, force_y=None, shift_x=None,
        shift_y=None, spring_x=None, spring_y=None, twist=None, progress=None, warn=false))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        load: Option<TangentialLoad>,
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
        progress: Option<Bound<'py, PyAny>>,
        warn: bool,
    ) -> PyResult<Bound<'py, TangentialSolution>> {
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
        let is_new = load.is_some() || !given.is_empty() || twist.is_some();
        let load = whole_load(load, &given, twist)?;
        let progress = Progress::of(progress.as_ref())?;
        let mut work = lock(&self.work, "solver")?;
        let Work { solver, spare } = &mut *work;
        let cells = self.grid.0.cells();
        if is_new {
            unobserved(py, cells, || solver.set_load(load))?;
        }
        let mut solution = spare.take(|| solver.new_solution());
        let into = Arc::get_mut(&mut solution);
        let into = into.ok_or_else(|| PyRuntimeError::new_err("the solution is held"))?;
        let outcome = solve(py, cells, progress, |observer| {
            solver.solve_observed(into, |iteration| observer(Some(iteration)))
        })?;
        spare.keep(&solution);
        finished(py, outcome, Some(solution), warn)
    }

    /// Changes the friction of the next solve.
    fn set_friction(&self, py: Python<'_>, friction: AnyFriction<'_>) -> PyResult<()> {
        let friction = friction.on(py, self.grid.0)?;
        let mut work = lock(&self.work, "solver")?;
        let solver = &mut work.solver;
        unobserved(py, self.grid.0.cells(), || solver.set_friction(&friction))
    }

    /// Changes the pressure of the next solve.
    fn set_pressure(&self, py: Python<'_>, pressure: Pressure<'_>) -> PyResult<()> {
        let pressure = pressure.given(py, self.grid.0)?;
        let mut work = lock(&self.work, "solver")?;
        let solver = &mut work.solver;
        unobserved(py, self.grid.0.cells(), || {
            solver.set_pressure(pressure.source())
        })
    }

    /// Changes the relative displacement of the next solve.
    fn set_relative_displacement(
        &self,
        py: Python<'_>,
        relative: RelativeDisplacement,
    ) -> PyResult<()> {
        let mut work = lock(&self.work, "solver")?;
        work.solver
            .set_relative_displacement(&relative.0)
            .or_raise(py)
    }

    /// Largest tangential force that friction holds.
    #[getter]
    fn friction_capacity(&self) -> PyResult<f64> {
        Ok(lock(&self.work, "solver")?.solver.friction_capacity())
    }

    /// The settings of the next solve; may be assigned.
    #[getter]
    fn settings(&self) -> PyResult<Settings> {
        Ok(Settings(*lock(&self.work, "solver")?.solver.settings()))
    }

    #[setter]
    fn set_settings(&self, py: Python<'_>, settings: Settings) -> PyResult<()> {
        let mut work = lock(&self.work, "solver")?;
        work.solver.set_settings(settings.0).or_raise(py)
    }

    /// Forgets the last answer.
    fn reset(&self) -> PyResult<()> {
        lock(&self.work, "solver")?.solver.reset();
        Ok(())
    }

    fn __repr__(&self) -> String {
        format!(
            "TangentialSolver({} x {} cells)",
            self.grid.0.nx(),
            self.grid.0.ny()
        )
    }
}

/// Jaeger's superposition: the traction of a contact under one force as the difference of two pressures.
///
/// Parameters
/// ----------
/// full, stick : NormalSolution
///     The contact, and the one whose contact is the stick zone.
/// pair : ElasticPair
/// friction : float
#[pyclass(frozen, module = "stickslip.tangential")]
pub(crate) struct JaegerSuperposition(stickslip::tangential::JaegerSuperposition);

#[pymethods]
impl JaegerSuperposition {
    #[new]
    fn new(
        py: Python<'_>,
        full: &NormalSolution,
        stick: &NormalSolution,
        pair: &ElasticPair,
        friction: f64,
    ) -> PyResult<Self> {
        let (full, stick) = (full.get(), stick.get());
        let found = stickslip::tangential::JaegerSuperposition::new(full, stick, &pair.0, friction);
        found.or_raise(py).map(Self)
    }

    /// The traction along the load (pressures).
    #[getter]
    fn traction<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |found| found.0.traction())
    }

    /// The zone of every cell, as of :attr:`TangentialSolution.zones`.
    #[getter]
    fn zones<'py>(&self, py: Python<'py>) -> Array<'py> {
        zones(py, self.0.traction().grid(), self.0.zones())
    }

    /// The shift (a length).
    #[getter]
    fn shift(&self) -> f64 {
        self.0.shift()
    }

    /// The force.
    #[getter]
    fn force(&self) -> f64 {
        self.0.force()
    }

    fn __repr__(&self) -> String {
        format!(
            "JaegerSuperposition(force={}, shift={})",
            self.0.force(),
            self.0.shift()
        )
    }
}
