//! The scene of a tangential contact, checked once.

use crate::bodies::coupling::Coupling;
use crate::cgm::{Method, Settings, settings_methods};
use crate::error::{Error, Result};
use crate::half_space::HalfSpace;
use crate::memory::fallible::{TryClone, try_clone};
use crate::support::debug::shown;
use crate::tangential::pressure_source::contact_window;
use crate::tangential::{
    Axis, Friction, PressureOnWindow, PressureSource, RelativeDisplacement, TangentialIncrement,
    TangentialLoad, TangentialModel, TangentialSolution, TangentialSolver, check_axes,
};

/// Bodies, pressure, friction and tangential load.
///
/// ```
/// use stickslip::analytical::{CattaneoMindlin, HertzSphere};
/// use stickslip::{
///     ElasticPair, Friction, Grid, HalfSpace, Material, NormalControl, NormalProblem, TangentialLoad,
///     TangentialProblem, surface,
/// };
///
/// let grid = Grid::square(64, 0.30e-3)?;
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 3.5e-3)?;
/// let normal = NormalProblem::builder(&bodies, &ball, NormalControl::Force(100.0)).build()?.solve()?;
///
/// let friction = Friction::coulomb(0.5)?;
/// let load = TangentialLoad::force([20.0, 0.0]);
/// let tangential = TangentialProblem::builder(&bodies, &normal, friction, load).build()?.solve()?;
///
/// let hertz = HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
/// let exact = CattaneoMindlin::new(hertz, 0.5, 20.0)?;
/// assert!((tangential.stick_ratio() - exact.stick_ratio()).abs() < 0.02);
/// assert!((tangential.shift()[0] / exact.shift() - 1.0).abs() < 1e-3);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Clone)]
pub struct TangentialProblem {
    pub(super) bodies: HalfSpace,
    pub(super) pressed: PressureOnWindow,
    pub(super) friction: Friction,
    pub(super) load: TangentialLoad,
    pub(super) model: TangentialModel,
    pub(super) coupling: Coupling,
    pub(super) relative: Option<RelativeDisplacement>,
    pub(super) settings: Settings,
}

shown!(TangentialProblem: bodies, friction, load, model, coupling, relative, settings);

/// Options of a [`TangentialProblem`]; each has a default.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct TangentialProblemBuilder<'a, 'p> {
    bodies: &'a HalfSpace,
    pressure: PressureSource<'p>,
    friction: Friction,
    load: TangentialLoad,
    model: TangentialModel,
    coupling: Coupling,
    relative: Option<RelativeDisplacement>,
    settings: Settings,
}

try_clone!(TangentialProblem { pressed, friction, relative } { bodies, load, model, coupling, settings });

impl TangentialProblem {
    /// Starts from what is required: bodies, a solved normal contact on them or a field of pressure, friction,
    /// load.
    #[doc(alias = "partial slip")]
    #[doc(alias = "stick slip")]
    pub fn builder<'a, 'p>(
        bodies: &'a HalfSpace,
        pressure: impl Into<PressureSource<'p>>,
        friction: Friction,
        load: TangentialLoad,
    ) -> TangentialProblemBuilder<'a, 'p> {
        TangentialProblemBuilder {
            bodies,
            pressure: pressure.into(),
            friction,
            load,
            model: TangentialModel::default(),
            coupling: Coupling::OneWay,
            relative: None,
            settings: Settings::default(),
        }
    }

    /// Solves once, with buffers of its own.
    ///
    /// # Errors
    /// [`Error::NotConverged`] with the report, use [`TangentialSolver::solve_into`] to keep the last iterate; as
    /// [`HalfSpace::operator`].
    pub fn solve(&self) -> Result<TangentialSolution> {
        let mut solver = TangentialSolver::new(self.try_clone()?)?;
        let mut solution = solver.try_new_solution()?;
        solver.solve_into(&mut solution)?;
        Ok(solution)
    }

    /// The reusable form: a solver that owns its buffers and lets load, friction and pressure change.
    ///
    /// # Errors
    /// As [`HalfSpace::operator`].
    pub fn into_solver(self) -> Result<TangentialSolver> {
        TangentialSolver::new(self)
    }

    /// Its step from rest, along these axes, under this pressure.
    pub(super) fn increment(
        &self,
        axes: &'static [Axis],
        pressed: PressureOnWindow,
    ) -> Result<TangentialIncrement> {
        let mut increment = TangentialIncrement::new(&self.bodies, axes, pressed, self.coupling)?;
        increment.draw(self.relative.as_ref());
        Ok(increment)
    }

    /// Largest tangential force friction holds: the integral of the friction limit.
    #[must_use]
    pub fn friction_capacity(&self) -> f64 {
        self.pressed.limits.sum * self.bodies.grid().cell_area()
    }
}

impl<'p> TangentialProblemBuilder<'_, 'p> {
    settings_methods!();

    /// Which tractions are found (default [`TangentialModel::Scalar`]).
    pub fn model(mut self, model: TangentialModel) -> Self {
        self.model = model;
        self
    }

    /// Whether the pressure moves the surfaces of bodies of different materials tangentially (default
    /// [`Coupling::OneWay`]: it does, and the tractions are those that belong to this pressure). With the pressure of a normal
    /// problem, which is frictionless, that is Goodman's assumption; [`Coupling`] has its errors. [`Coupling::Full`] is
    /// refused for such bodies: there the pressure is not given ([`CoupledProblem`](crate::CoupledProblem)).
    ///
    /// The problem presses such bodies in one step. This is exact if the contact does not grow, as that of a flat punch.
    /// Elsewhere the stick zone is not the zone of a load that grows: press a history by
    /// [`History::press`](crate::History::press). The solution has the warning
    /// [`SingleLoadStep`](crate::Warning::SingleLoadStep).
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(48, 0.30e-3)?;
    /// let (aluminium, steel) = (Material::new(70e9, 0.33)?, Material::new(210e9, 0.3)?);
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(aluminium, steel)?)?;
    /// let ball = surface::sphere(grid, 3.5e-3)?;
    /// let normal = NormalProblem::builder(&bodies, &ball, NormalControl::Force(60.0)).build()?.solve()?;
    /// let at_rest = TangentialProblem::builder(
    ///     &bodies,
    ///     &normal,
    ///     Friction::coulomb(0.1)?,
    ///     TangentialLoad::force([0.0, 0.0]),
    /// );
    /// let tangential = at_rest.model(TangentialModel::Vector).build()?.solve()?;
    /// // Pressing alone draws the surface of aluminium inwards over that of steel, and makes the rim slip.
    /// assert!(tangential.slip_area() > 0.0 && tangential.stick_area() > 0.0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn coupling(mut self, coupling: Coupling) -> Self {
        self.coupling = coupling;
        self
    }

    /// A displacement of body 1 relative to body 2 that the contact does not cause, reached in proportion to the load
    /// (default: none).
    pub fn relative_displacement(mut self, relative: RelativeDisplacement) -> Self {
        self.relative = Some(relative);
        self
    }

    /// Checks everything and cuts out the contact.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if the normal contact is not, with its report; [`Error::Sample`] for a prescribed
    /// pressure that is negative or not finite, or a bulk strain along an axis on which the grid repeats; [`Error::GridMismatch`], [`Error::BoundaryMismatch`] or
    /// [`Error::MaterialMismatch`] for one of other bodies; [`Error::CoupledMaterials`], [`Error::ObliqueLoad`],
    /// [`Error::UnsupportedByModel`], [`Error::NotFinite`], [`Error::EmptyContact`], [`Error::BeyondFrictionCapacity`],
    /// [`Error::Tolerance`], [`Error::IterationLimit`]; [`Error::Ranks`].
    pub fn build(self) -> Result<TangentialProblem> {
        let grid = self.bodies.grid();
        let demand = self.load.demand();
        let samples = self.bodies.collective_result_checked(
            self.check(),
            &[
                ("tangential load", &self.load),
                ("friction", &self.friction.common()),
                ("relative displacement", &self.relative.is_some()),
                ("model", &self.model),
                ("coupling", &self.coupling),
                ("settings", &self.settings.common()),
            ],
        )?;
        let mut pressed =
            PressureOnWindow::new(self.bodies, contact_window(self.bodies, samples)?)?;
        pressed.set(samples, &self.friction);
        pressed.limits.check(demand.force(), grid.cell_area())?;
        Ok(TangentialProblem {
            bodies: self.bodies.clone(),
            pressed,
            friction: self.friction,
            load: self.load,
            model: self.model,
            coupling: self.coupling,
            relative: self.relative,
            settings: self.settings,
        })
    }

    /// What every rank checks of its own; returns the pressure of the cells held here.
    fn check(&self) -> Result<&'p [f64]> {
        let grid = self.bodies.grid();
        self.friction.check(grid)?;
        let axes = self.load.axes(self.model)?;
        self.load.demand().check(axes, self.bodies.boundary())?;
        self.settings.check()?;
        self.model.check(&self.settings)?;
        check_coupling(self.bodies, self.coupling)?;
        check_axes(self.bodies, axes, self.coupling)?;
        if let Some(relative) = &self.relative {
            relative.check(self.bodies, axes)?;
        }
        self.pressure.checked(self.bodies)
    }
}

impl TangentialModel {
    /// `Ok` if the model has the method.
    pub(crate) fn check(self, settings: &Settings) -> Result<()> {
        match (self, settings.method) {
            (Self::Vector, Method::PolonskyKeer) => Err(Error::Method {
                method: "PolonskyKeer",
                quantity: "both tractions",
            }),
            _ => Ok(()),
        }
    }
}

/// `Ok` if the pressure may be given.
fn check_coupling(bodies: &HalfSpace, coupling: Coupling) -> Result<()> {
    if coupling.is_joint(bodies.pair()) {
        let beta = bodies.pair().coupling_strength();
        return Err(Error::CoupledMaterials { beta });
    }
    Ok(())
}
