//! Input of a coupled contact, checked when it is built.

use std::sync::Arc;

use crate::cgm::{Settings, settings_methods};
use crate::coupled::check_joint;
use crate::coupled::{CoupledSolution, CoupledSolver};
use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::memory::fallible::try_clone;
use crate::normal::{Hardness, NormalLoad};
use crate::tangential::{Axis, Friction, RelativeDisplacement, TangentialLoad, TangentialModel};

/// Bodies, gap, friction and loads of a contact with coupled pressure and tractions, in one step from rest.
///
/// For bodies without coupling or without friction, one step has the result of gradual pressing. One step also has this result if
/// the contact has its full size from the first load (a flat punch). In a growing contact of dissimilar bodies, cells that come
/// into contact later slip less than in one step. A ball of $`\beta = 1/2`$ pressed in one step sticks on 0.23 of the contact
/// radius. Pressed in 32 steps, it sticks on 0.50 of the contact radius ([Spence](crate::analytical::SpencePressing)). The
/// solution of such a contact has the warning [`SingleLoadStep`](crate::Warning::SingleLoadStep).
/// [`History::press`](crate::History::press) takes as many steps as a tolerance requires.
///
/// ```
/// use stickslip::*;
/// // A compressible rubber pad (nu = 0) on a rigid ball: beta = 1/2.
/// let grid = Grid::square(32, 3.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?)?;
/// let (ball, friction) = (surface::sphere(grid, 10.0)?, Friction::coulomb(0.3)?);
/// let press = NormalLoad::Force(0.1);
/// let still = TangentialLoad::shift([0.0, 0.0]);
/// let contact = CoupledProblem::builder(&bodies, &ball, friction, press, still).build()?.solve()?;
///
/// // The ball is pressed in one step, so its stick zone differs from that of a growing load.
/// assert!(contact.warnings().contains(&Warning::SingleLoadStep));
///
/// // Inward shear, which friction holds, makes the contact stiffer than a frictionless one.
/// let smooth = NormalProblem::builder(&bodies, &ball, press).build()?.solve()?;
/// let (stuck, free) = (contact.normal(), &smooth);
/// assert!(stuck.approach() < free.approach() && stuck.pressure().max() > free.pressure().max());
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct CoupledProblem {
    pub(crate) bodies: HalfSpace,
    pub(crate) gap: Arc<Field>,
    pub(crate) friction: Friction,
    pub(crate) hardness: Option<Hardness>,
    pub(crate) normal: NormalLoad,
    pub(crate) tangential: TangentialLoad,
    pub(crate) relative: Option<RelativeDisplacement>,
    pub(super) settings: Settings,
}

try_clone!(CoupledProblem { friction, hardness, relative } { bodies, gap, normal, tangential, settings });

/// Options of a [`CoupledProblem`], all with defaults.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct CoupledProblemBuilder {
    problem: CoupledProblem,
}

impl CoupledProblem {
    /// Starts a builder from the required input: bodies, initial gap (lengths, on the grid of the bodies), friction,
    /// normal and tangential load. A gap passed by reference is copied. A gap passed by value or in an [`Arc`] is not
    /// copied.
    ///
    /// A tangential load of zero force differs from a load of zero shift. The tractions due to pressing alone sum to
    /// zero only if the contact is symmetric.
    #[doc(alias = "dissimilar")]
    pub fn builder(
        bodies: &HalfSpace,
        gap: impl Into<Arc<Field>>,
        friction: Friction,
        normal: NormalLoad,
        tangential: TangentialLoad,
    ) -> CoupledProblemBuilder {
        CoupledProblemBuilder {
            problem: Self {
                bodies: bodies.clone(),
                gap: gap.into(),
                friction,
                hardness: None,
                normal,
                tangential,
                relative: None,
                settings: Settings::default(),
            },
        }
    }

    /// Solves the contact from rest in one step.
    ///
    /// # Errors
    /// - [`Error::NotConverged`](crate::Error::NotConverged) with the report if a limit is reached. Use
    ///   [`CoupledSolver::solve_into`] to keep the last iterate.
    /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) for a force that slides the contact.
    /// - Errors of [`HalfSpace::operator`].
    pub fn solve(&self) -> Result<CoupledSolution> {
        CoupledSolver::solve_once(self)
    }

    /// Creates a reusable solver, which owns its buffers and lets gap, friction and loads change.
    ///
    /// # Errors
    /// Errors of [`HalfSpace::operator`].
    pub fn into_solver(self) -> Result<CoupledSolver> {
        CoupledSolver::new(self)
    }

    /// Checks the input that a rank can check without the other ranks.
    fn check(&self) -> Result<()> {
        check_joint(&self.bodies)?;
        let grid = self.bodies.grid();
        self.gap.check("gap", grid)?;
        self.friction.check(grid)?;
        if let Some(hardness) = &self.hardness {
            hardness.check(grid)?;
        }
        self.tangential
            .demand()
            .check(Axis::BOTH, &self.bodies, [0.0; 2])?;
        if let Some(relative) = &self.relative {
            relative.check(&self.bodies, Axis::BOTH)?;
        }
        self.settings.check()?;
        TangentialModel::Vector.check(&self.settings)
    }
}

impl CoupledProblemBuilder {
    settings_methods!(problem.settings);

    /// Sets a displacement of body 1 relative to body 2 that the contact does not cause (default: none).
    pub fn relative_displacement(mut self, relative: RelativeDisplacement) -> Self {
        self.problem.relative = Some(relative);
        self
    }

    /// Sets the largest pressure that the cells can carry (default: no limit). A force beyond the capacity of all cells
    /// is an error. An approach may bring all cells to their limit.
    ///
    /// ```
    /// use stickslip::{*, normal::Hardness};
    /// let grid = Grid::square(32, 3.0)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?)?;
    /// let (ball, friction) = (surface::sphere(grid, 10.0)?, Friction::coulomb(0.3)?);
    /// let (press, drag) = (NormalLoad::Force(0.1), TangentialLoad::force([0.01, 0.0]));
    /// let soft = CoupledProblem::builder(&bodies, ball, friction, press, drag).hardness(Hardness::uniform(0.05)?);
    /// let contact = soft.build()?.solve()?;
    /// assert!(contact.normal().pressure().max() == 0.05 && contact.normal().yielded_cells() > 0);
    /// // Yielded cells carry traction up to the friction limit of their pressure.
    /// assert!(contact.tangential().traction()[0].max() <= 0.3 * 0.05 * (1.0 + 1e-12));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn hardness(mut self, hardness: Hardness) -> Self {
        self.problem.hardness = Some(hardness);
        self
    }

    /// Checks the input and creates the problem.
    ///
    /// # Errors
    /// - [`GridMismatch`](crate::Error::GridMismatch) if the grid of the gap, friction, hardness or relative
    ///   displacement differs.
    /// - [`Sample`](crate::Error::Sample) if the gap is not finite, or for a bulk strain along a periodic axis.
    /// - [`NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite), [`NotFinite`](crate::Error::NotFinite),
    ///   [`NotPositive`](crate::Error::NotPositive) or [`UnsupportedByModel`](crate::Error::UnsupportedByModel) if a load is
    ///   invalid or not supported.
    /// - [`ApproachBeyondMeanGap`](crate::Error::ApproachBeyondMeanGap) on a periodic grid if the approach is not less
    ///   than the mean gap.
    /// - [`BeyondHardness`](crate::Error::BeyondHardness) if the force exceeds the capacity of the cells.
    /// - [`Method`](crate::Error::Method) for [`Method::PolonskyKeer`](crate::cgm::Method::PolonskyKeer).
    /// - [`Tolerance`](crate::Error::Tolerance) or [`IterationLimit`](crate::Error::IterationLimit) if a setting is out
    ///   of range.
    /// - [`Ranks`](crate::Error::Ranks) if ranks fail or pass different input.
    pub fn build(self) -> Result<CoupledProblem> {
        let problem = self.problem;
        let hardness = problem.hardness.as_ref();
        problem.bodies.collective_result_checked(
            problem.check(),
            &[
                ("normal load", &problem.normal),
                ("tangential load", &problem.tangential),
                ("friction", &problem.friction.common()),
                ("hardness", &hardness.map(Hardness::common)),
                ("relative displacement", &problem.relative.is_some()),
                ("settings", &problem.settings.common()),
            ],
        )?;
        problem
            .normal
            .check(&problem.bodies, &problem.gap, hardness)?;
        Ok(problem)
    }
}
