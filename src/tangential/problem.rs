//! The scene of a tangential contact, checked once.

use crate::cgm::{Settings, settings_methods, sum_of_chunks};
use crate::error::{Error, Result, finite};
use crate::half_space::HalfSpace;
use crate::tangential::pressure::contact_window;
use crate::tangential::{Axis, Friction, Lateral, Pressure, TangentialSolution, TangentialSolver};
use crate::window::Window;

/// What shears the contact, as `[x, y]`; one component must be zero, unless the model is that of the plane
/// ([`Lateral::Coupled`]).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum TangentialLoad {
    /// The tangential force that body 2 exerts on body 1 (a force, either sign); the shift follows.
    Force([f64; 2]),
    /// The shift: the rigid motion of body 2 relative to body 1, far from the contact (a length,
    /// either sign); the force follows, of the same sign. On a periodic grid it is measured from the mean
    /// plane of the surface, and the certified error against the exact contact under the force that was found.
    Shift([f64; 2]),
}

impl TangentialLoad {
    /// Both components.
    pub(super) fn components(self) -> Result<[f64; 2]> {
        let (Self::Force([x, y]) | Self::Shift([x, y])) = self;
        finite("tangential load along x", x)?;
        finite("tangential load along y", y)?;
        Ok([x, y])
    }

    /// The axis of the load and its value there. No load at all is along x.
    pub(super) fn along(self) -> Result<(Axis, f64)> {
        let [x, y] = self.components()?;
        if y == 0.0 {
            Ok((Axis::X, x))
        } else if x == 0.0 {
            Ok((Axis::Y, y))
        } else {
            Err(Error::ObliqueLoad { x, y })
        }
    }
}

/// Coupling between pressure and shear below which the pair counts as uncoupled.
const UNCOUPLED: f64 = 1e-12;
/// Relative distance from the friction limit within which the force slides the contact.
const SLIDING: f64 = 1e-12;

/// Bodies, pressure, friction and tangential load.
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
/// let load = TangentialLoad::Force([20.0, 0.0]);
/// let shear = TangentialProblem::builder(&bodies, &normal, friction, load).build()?.solve()?;
///
/// let hertz = HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
/// let exact = CattaneoMindlin::new(hertz, 0.5, 20.0)?;
/// assert!((shear.stick_ratio() - exact.stick_ratio()).abs() < 0.02);
/// assert!((shear.shift()[0] / exact.shift() - 1.0).abs() < 1e-3);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct TangentialProblem {
    pub(super) bodies: HalfSpace,
    pub(super) window: Window,
    /// Pressure of the cells of the window.
    pub(super) pressure: Vec<f64>,
    pub(super) friction: Friction,
    pub(super) limits: Limits,
    pub(super) load: TangentialLoad,
    pub(super) lateral: Lateral,
    pub(super) settings: Settings,
}

/// Options of a [`TangentialProblem`]; each has a default.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct TangentialProblemBuilder<'a> {
    bodies: &'a HalfSpace,
    pressure: Pressure<'a>,
    friction: Friction,
    load: TangentialLoad,
    lateral: Lateral,
    settings: Settings,
    neglect_coupling: bool,
}

impl TangentialProblem {
    /// Starts from what is required: bodies, a solved normal contact on them or a field of pressure, friction,
    /// load.
    pub fn builder<'a>(
        bodies: &'a HalfSpace,
        pressure: impl Into<Pressure<'a>>,
        friction: Friction,
        load: TangentialLoad,
    ) -> TangentialProblemBuilder<'a> {
        TangentialProblemBuilder {
            bodies,
            pressure: pressure.into(),
            friction,
            load,
            lateral: Lateral::default(),
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
    pub fn sliding_force(&self) -> f64 {
        self.limits.sum * self.bodies.grid().cell_area()
    }
}

impl TangentialProblemBuilder<'_> {
    settings_methods!();

    /// What becomes of the traction across the load (default [`Lateral::Neglected`]). [`Lateral::Coupled`] has a
    /// semi-smooth Newton method of its own: [`method`](Self::method) is then without effect.
    pub fn lateral(mut self, lateral: Lateral) -> Self {
        self.lateral = lateral;
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
    /// [`Error::NotFinite`], [`Error::EmptyContact`], [`Error::BeyondSliding`],
    /// [`Error::Tolerance`], [`Error::IterationLimit`].
    pub fn build(self) -> Result<TangentialProblem> {
        let grid = self.bodies.grid();
        self.friction.check(grid)?;
        self.lateral.check(self.load)?;
        self.settings.check()?;
        check_coupling(self.bodies, self.neglect_coupling)?;
        let samples = self.pressure.checked(self.bodies)?;
        let window = contact_window(self.bodies, samples)?;
        let mut pressure = vec![0.0; window.cells()];
        window.gather(samples, &mut pressure);
        let mut limits = Limits::new(pressure.len());
        limits.set(&self.friction, window, &pressure);
        limits.check(self.load, grid.cell_area())?;
        Ok(TangentialProblem {
            bodies: self.bodies.clone(),
            window,
            pressure,
            friction: self.friction,
            limits,
            load: self.load,
            lateral: self.lateral,
            settings: self.settings,
        })
    }
}

/// `Ok` if shear does not change the pressure, or that is to be neglected.
pub(crate) fn check_coupling(bodies: &HalfSpace, is_neglected: bool) -> Result<()> {
    let beta = bodies.pair().dundurs_beta();
    if beta.abs() > UNCOUPLED && !is_neglected {
        return Err(Error::CoupledMaterials { beta });
    }
    Ok(())
}

impl Lateral {
    /// `Ok` if the model can carry the load.
    pub(super) fn check(self, load: TangentialLoad) -> Result<()> {
        match self {
            Self::Neglected => load.along().map(|_| ()),
            Self::Coupled => load.components().map(|_| ()),
        }
    }
}

/// Part of the largest limit below which a limit is none.
const NOTHING: f64 = 1e-30;

/// The friction limit of every cell of a window, and their sum.
#[derive(Debug, Clone)]
pub(crate) struct Limits {
    pub(crate) cells: Vec<f64>,
    pub(crate) sum: f64,
}

impl Limits {
    pub(crate) fn new(cells: usize) -> Self {
        Self {
            cells: vec![0.0; cells],
            sum: 0.0,
        }
    }

    pub(crate) fn set(&mut self, friction: &Friction, window: Window, pressure: &[f64]) {
        let limits = self.cells.iter_mut().zip(window.indices());
        for ((limit, index), &pressure) in limits.zip(pressure) {
            *limit = if pressure > 0.0 {
                friction.limit(index, pressure)
            } else {
                0.0
            };
        }
        // Beside the largest these carry nothing, and their squares would underflow.
        let least = NOTHING * self.cells.iter().copied().fold(0.0, f64::max);
        for limit in &mut self.cells {
            *limit = if *limit < least { 0.0 } else { *limit };
        }
        self.sum = sum_of_chunks(&self.cells);
    }

    /// Refuses a force that friction cannot hold.
    pub(crate) fn check(&self, load: TangentialLoad, cell_area: f64) -> Result<()> {
        let [x, y] = load.components()?;
        finite("sum of the friction limits", self.sum)?;
        let (force, limit) = (x.hypot(y), self.sum * cell_area);
        match load {
            TangentialLoad::Force(_) if force > limit * (1.0 + SLIDING) => {
                Err(Error::BeyondSliding { force, limit })
            }
            _ => Ok(()),
        }
    }

    /// The sums of tractions a force asks for; exactly at the limit when the force is within round-off of it.
    pub(crate) fn totals(&self, force: [f64; 2], cell_area: f64) -> [f64; 2] {
        let totals = force.map(|force| force / cell_area);
        let size = totals[0].hypot(totals[1]);
        if size > 0.0 && size >= self.sum * (1.0 - SLIDING) {
            totals.map(|total| total * (self.sum / size))
        } else {
            totals
        }
    }
}
