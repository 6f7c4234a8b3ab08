//! The scene of a tangential contact, checked once.

use crate::cgm::{Method, Settings, settings_methods};
use crate::error::{Error, Result};
use crate::half_space::HalfSpace;
use crate::tangential::pressure::contact_window;
use crate::tangential::{
    Friction, Pressed, PressureSource, TangentialLoad, TangentialModel, TangentialSolution,
    TangentialSolver,
};

/// Coupling between pressure and shear below which the pair counts as uncoupled.
const UNCOUPLED: f64 = 1e-12;

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
/// let shear = TangentialProblem::builder(&bodies, &normal, friction, load).build()?.solve()?;
///
/// let hertz = HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
/// let exact = CattaneoMindlin::new(hertz, 0.5, 20.0)?;
/// assert!((shear.stick_ratio() - exact.stick_ratio()).abs() < 0.02);
/// assert!((shear.shift()[0] / exact.shift() - 1.0).abs() < 1e-3);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[doc(alias = "partial slip")]
#[doc(alias = "stick slip")]
#[derive(Debug, Clone)]
pub struct TangentialProblem {
    pub(super) bodies: HalfSpace,
    pub(super) pressed: Pressed,
    pub(super) friction: Friction,
    pub(super) load: TangentialLoad,
    pub(super) model: TangentialModel,
    pub(super) settings: Settings,
}

/// Options of a [`TangentialProblem`]; each has a default.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct TangentialProblemBuilder<'a, 'p> {
    bodies: &'a HalfSpace,
    pressure: PressureSource<'p>,
    friction: Friction,
    load: TangentialLoad,
    model: TangentialModel,
    settings: Settings,
    neglect_coupling: bool,
}

impl TangentialProblem {
    /// Starts from what is required: bodies, a solved normal contact on them or a field of pressure, friction,
    /// load.
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
            settings: Settings::default(),
            neglect_coupling: false,
        }
    }

    /// Solves once, with buffers of its own.
    ///
    /// # Errors
    /// [`Error::NotConverged`] with the report, use [`TangentialSolver::solve_into`] to keep the last iterate; as
    /// [`HalfSpace::operator`].
    pub fn solve(&self) -> Result<TangentialSolution> {
        let mut solver = TangentialSolver::new(self.clone())?;
        let mut solution = solver.new_solution();
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

    /// Largest tangential force friction holds: the integral of the friction limit.
    #[must_use]
    pub fn friction_capacity(&self) -> f64 {
        self.pressed.limits.sum * self.bodies.grid().cell_area()
    }
}

impl TangentialProblemBuilder<'_, '_> {
    settings_methods!();

    /// Which tractions are found (default [`TangentialModel::Scalar`]).
    pub fn model(mut self, model: TangentialModel) -> Self {
        self.model = model;
        self
    }

    /// Accepts a pair of materials whose pressure and shear are coupled, and neglects that: an
    /// error of order beta and mu beta in the tractions (default: such a pair is refused).
    pub fn neglect_coupling(mut self) -> Self {
        self.neglect_coupling = true;
        self
    }

    /// Checks everything and cuts out the contact.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if the normal contact is not, with its report; [`Error::Sample`] for a prescribed
    /// pressure that is negative or not finite; [`Error::GridMismatch`], [`Error::BoundaryMismatch`] or
    /// [`Error::MaterialMismatch`] for one of other bodies; [`Error::CoupledMaterials`], [`Error::ObliqueLoad`],
    /// [`Error::NotFinite`], [`Error::EmptyContact`], [`Error::BeyondFrictionCapacity`],
    /// [`Error::Tolerance`], [`Error::IterationLimit`].
    pub fn build(self) -> Result<TangentialProblem> {
        let grid = self.bodies.grid();
        self.friction.check(grid)?;
        let axes = self.load.axes(self.model)?;
        let demand = self.load.demand();
        demand.check(axes, self.bodies.boundary())?;
        self.settings.check()?;
        self.model.check(&self.settings)?;
        check_coupling(self.bodies, self.neglect_coupling)?;
        let samples = self.pressure.checked(self.bodies)?;
        let mut pressed = Pressed::new(contact_window(self.bodies, samples)?);
        pressed.set(samples, &self.friction);
        pressed.limits.check(demand.force(), grid.cell_area())?;
        Ok(TangentialProblem {
            bodies: self.bodies.clone(),
            pressed,
            friction: self.friction,
            load: self.load,
            model: self.model,
            settings: self.settings,
        })
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

/// `Ok` if shear does not change the pressure, or that is to be neglected.
fn check_coupling(bodies: &HalfSpace, is_neglected: bool) -> Result<()> {
    if is_coupled(bodies) && !is_neglected {
        let beta = bodies.pair().dundurs_beta();
        return Err(Error::CoupledMaterials { beta });
    }
    Ok(())
}

/// Whether pressure and shear are coupled.
pub(crate) fn is_coupled(bodies: &HalfSpace) -> bool {
    bodies.pair().dundurs_beta().abs() > UNCOUPLED
}
