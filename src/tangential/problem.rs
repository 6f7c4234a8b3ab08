//! Input of a tangential contact, checked when it is built.

use crate::bodies::coupling::Coupling;
use crate::cgm::{Method, Settings, settings_methods};
use crate::error::{Error, Result};
use crate::half_space::HalfSpace;
use crate::memory::fallible::try_clone;
use crate::support::debug::shown;
use crate::tangential::pressure_source::contact_window;
use crate::tangential::{
    Axis, Friction, PressureOnWindow, PressureSource, RelativeDisplacement, TangentialIncrement,
    TangentialLoad, TangentialModel, TangentialSolution, TangentialSolver, check_axes,
};

/// Bodies, pressure, friction and load of a tangential contact.
///
/// ```
/// use stickslip::analytical::{CattaneoMindlin, HertzSphere};
/// use stickslip::{
///     ElasticPair, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem, TangentialLoad,
///     TangentialProblem, surface,
/// };
///
/// let grid = Grid::square(64, 0.30e-3)?;
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 3.5e-3)?;
/// let normal = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(100.0)).build()?.solve()?;
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
    pub(crate) bodies: HalfSpace,
    pub(super) pressed: PressureOnWindow,
    /// Whether the pressure is a field instead of a solved contact.
    pub(super) is_prescribed: bool,
    pub(crate) friction: Friction,
    pub(crate) load: TangentialLoad,
    pub(super) model: TangentialModel,
    pub(crate) coupling: Coupling,
    pub(crate) relative: Option<RelativeDisplacement>,
    pub(super) settings: Settings,
}

shown!(TangentialProblem: bodies, friction, load, model, coupling, relative, settings);

/// Options of a [`TangentialProblem`], all with defaults.
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

try_clone!(TangentialProblem { pressed, friction, relative } { bodies, is_prescribed, load, model, coupling, settings });

impl TangentialProblem {
    /// Starts a builder from the required input: bodies, pressure, friction and load. The pressure is a solved normal
    /// contact on these bodies or a field. Only a solved contact states its materials, so a field from other bodies is accepted.
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

    /// Solves the contact once with temporary buffers.
    ///
    /// # Errors
    /// - [`Error::NotConverged`] with the report if a limit is reached. Use [`TangentialSolver::solve_into`] to keep
    ///   the last iterate.
    /// - Errors of [`HalfSpace::operator`].
    pub fn solve(&self) -> Result<TangentialSolution> {
        TangentialSolver::solve_once(self)
    }

    /// Creates a reusable solver, which owns its buffers and lets load, friction and pressure change.
    ///
    /// # Errors
    /// Errors of [`HalfSpace::operator`].
    pub fn into_solver(self) -> Result<TangentialSolver> {
        TangentialSolver::new(self)
    }

    /// Creates the step from rest along these axes under this pressure.
    pub(super) fn increment(
        &self,
        axes: &'static [Axis],
        pressed: PressureOnWindow,
    ) -> Result<TangentialIncrement> {
        let mut increment = TangentialIncrement::new(&self.bodies, axes, pressed, self.coupling)?;
        increment.draw(self.relative.as_ref());
        Ok(increment)
    }

    /// Returns the largest tangential force that friction can carry, the integral of the friction limit.
    #[must_use]
    pub fn friction_capacity(&self) -> f64 {
        self.pressed.limits.sum * self.bodies.grid().cell_area()
    }
}

impl<'p> TangentialProblemBuilder<'_, 'p> {
    settings_methods!(settings);

    /// Sets the model of the tractions (default [`TangentialModel::Scalar`]).
    pub fn model(mut self, model: TangentialModel) -> Self {
        self.model = model;
        self
    }

    /// Sets whether the pressure moves the surfaces of bodies of different materials tangentially. The default
    /// ([`Coupling::OneWay`]) includes this displacement and computes the tractions for this pressure.
    ///
    /// The pressure of a normal problem is frictionless. For this pressure the default is Goodman's assumption, whose
    /// errors are listed at [`Coupling`]. [`Coupling::Full`] causes an error for such bodies, because the pressure then
    /// depends on the tractions ([`CoupledProblem`](crate::CoupledProblem)).
    ///
    /// In this problem, such bodies are pressed together in one step. One step is exact for a contact that does not
    /// grow, such as the contact of a flat punch. For other contacts the stick zone differs from the stick zone under a
    /// growing load. The solution then has the warning [`SingleLoadStep`](crate::Warning::SingleLoadStep). Use
    /// [`History::press`](crate::History::press) to press in several steps. In the scalar model, the pressure acts only along the
    /// axis of the tractions ([`NeglectedTraction`](crate::Warning::NeglectedTraction)).
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(48, 0.30e-3)?;
    /// let (aluminium, steel) = (Material::new(70e9, 0.33)?, Material::new(210e9, 0.3)?);
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(aluminium, steel)?)?;
    /// let ball = surface::sphere(grid, 3.5e-3)?;
    /// let normal = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(60.0)).build()?.solve()?;
    /// let at_rest = TangentialProblem::builder(
    ///     &bodies,
    ///     &normal,
    ///     Friction::coulomb(0.1)?,
    ///     TangentialLoad::force([0.0, 0.0]),
    /// );
    /// let tangential = at_rest.model(TangentialModel::Vector).build()?.solve()?;
    /// // Pressing alone draws the surface of aluminium inwards over the surface of steel and makes the rim slip.
    /// assert!(tangential.slip_area() > 0.0 && tangential.stick_area() > 0.0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn coupling(mut self, coupling: Coupling) -> Self {
        self.coupling = coupling;
        self
    }

    /// Sets a displacement of body 1 relative to body 2 that the contact does not cause (default: none). The
    /// displacement is applied in proportion to the load.
    pub fn relative_displacement(mut self, relative: RelativeDisplacement) -> Self {
        self.relative = Some(relative);
        self
    }

    /// Checks the input, and creates the problem on the bounding box of the contact.
    ///
    /// # Errors
    /// - [`Error::NotConverged`] with the report of the normal contact if it has not converged.
    /// - [`Error::Sample`] for a prescribed pressure that is negative or not finite, or for a bulk strain along a
    ///   periodic axis.
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`] or [`Error::MaterialMismatch`] if a field or contact
    ///   belongs to other bodies.
    /// - [`Error::CoupledMaterials`] for [`Coupling::Full`] with bodies of different materials.
    /// - [`Error::ObliqueLoad`] or [`Error::UnsupportedByModel`] if the model does not support the load, or if a spring is too long.
    /// - [`Error::NotFinite`] if a number of the load is not finite or the limits overflow.
    /// - [`Error::EmptyContact`] if no cell carries pressure.
    /// - [`Error::BeyondFrictionCapacity`] if the force exceeds the friction capacity.
    /// - [`Error::Tolerance`] or [`Error::IterationLimit`] if a setting is out of range.
    /// - [`Error::Ranks`] if ranks fail or pass different input.
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
            is_prescribed: self.pressure.is_prescribed(),
            friction: self.friction,
            load: self.load,
            model: self.model,
            coupling: self.coupling,
            relative: self.relative,
            settings: self.settings,
        })
    }

    /// Checks the input that a rank can check without the other ranks, and returns the pressure of the local cells.
    fn check(&self) -> Result<&'p [f64]> {
        let grid = self.bodies.grid();
        self.friction.check(grid)?;
        let axes = self.load.axes(self.model)?;
        self.load.demand().check(axes, self.bodies, [0.0; 2])?;
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
    /// Returns an error if the model does not support the method.
    pub(crate) fn check(self, settings: &Settings) -> Result<()> {
        match (self, settings.method) {
            (Self::Vector, Method::PolonskyKeer) => Err(Error::Method {
                method: "Polonsky-Keer",
                quantity: "the vector model",
            }),
            _ => Ok(()),
        }
    }
}

/// Returns an error if the coupling does not allow a prescribed pressure.
fn check_coupling(bodies: &HalfSpace, coupling: Coupling) -> Result<()> {
    if coupling.is_joint(bodies.pair()) {
        let beta = bodies.pair().coupling_strength();
        return Err(Error::CoupledMaterials { beta });
    }
    Ok(())
}
