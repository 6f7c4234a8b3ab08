//! The problem of coupled steady rolling and the checks of its input.

use std::sync::Arc;

use crate::coupled::check_joint;
use crate::error::{Error, RankFailure, Result};
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::memory::fallible::try_clone;
use crate::normal::NormalLoad;
use crate::rolling::RollingShift;
use crate::rolling::coupled::{CoupledRollingSolution, CoupledRollingSolver};
use crate::rolling::steady::options::{RollingOptions, rolling_methods};
use crate::rolling::steady::problem::{check_forces, check_motion};
use crate::rolling::{LeadingEdge, RollingControl, SpinControl};
use crate::support::debug::shown;
use crate::tangential::EntryRule;
use crate::tangential::{Axis, Friction, TangentialModel};

/// Bodies, gap, friction and loads of steady rolling in which the tractions change the pressure.
///
/// Between bodies of different materials tractions lift the surfaces, and the pressure changes. A
/// [`RollingProblem`](crate::rolling::RollingProblem) uses a given pressure and neglects the lift. This problem
/// solves for pressure and tractions together. Each pass of the solve adds the lift to the gap and solves for the pressure and
/// the tractions again. The passes end when the tractions no longer change. For bodies that [are not
/// coupled](crate::ElasticPair::is_coupled) one pass is exact. Its results are bitwise identical to the results of a
/// [`NormalProblem`](crate::NormalProblem) and a `RollingProblem`.
///
/// ```
/// use stickslip::rolling::{CoupledRollingProblem, RollingControl, RollingProblem};
/// use stickslip::*;
/// // A compressible rubber roller (nu = 0) on a rigid plane: beta = 1/2.
/// let grid = Grid::square(24, 3.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?)?;
/// let (ball, friction) = (surface::sphere(grid, 1.0)?, Friction::coulomb(0.3)?);
/// let press = NormalLoad::Force(4.0 / 3.0);
/// let free = [RollingControl::Force(0.0), RollingControl::Creepage(0.0)];
/// let rolling = CoupledRollingProblem::builder(&bodies, &ball, friction.clone(), press)
///     .control(Axis::X, free[0])
///     .build()?
///     .solve()?;
/// assert!(rolling.report().is_converged());
///
/// // The tractions of free rolling raise the peak pressure.
/// let smooth = NormalProblem::builder(&bodies, &ball, press).build()?.solve()?;
/// assert!(rolling.normal().pressure().max() > 1.02 * smooth.pressure().max());
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct CoupledRollingProblem {
    pub(super) bodies: HalfSpace,
    pub(super) gap: Arc<Field>,
    pub(super) friction: Friction,
    pub(super) normal: NormalLoad,
    pub(super) options: RollingOptions,
}

try_clone!(CoupledRollingProblem { friction } { bodies, gap, normal, options });

shown!(CoupledRollingProblem: bodies, normal, options);

/// Options of a [`CoupledRollingProblem`], all with defaults.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct CoupledRollingProblemBuilder {
    problem: CoupledRollingProblem,
}

impl CoupledRollingProblem {
    /// Creates a builder from the bodies, the gap before loading (lengths, on the grid of the bodies), the friction and the
    /// normal load. Without options both creepages and the spin are zero. A gap passed by reference is copied. A gap passed by
    /// value or in an [`Arc`] is not copied.
    pub fn builder(
        bodies: &HalfSpace,
        gap: impl Into<Arc<Field>>,
        friction: Friction,
        normal: NormalLoad,
    ) -> CoupledRollingProblemBuilder {
        CoupledRollingProblemBuilder {
            problem: Self {
                bodies: bodies.clone(),
                gap: gap.into(),
                friction,
                normal,
                options: RollingOptions::default(),
            },
        }
    }

    /// Solves the problem once. Each call allocates its own buffers.
    ///
    /// # Errors
    /// - [`Error::NotConverged`] with the report if the solve does not converge. [`CoupledRollingSolver::solve_into`] keeps the
    ///   last iterate.
    /// - [`Error::EmptyContact`] if no cell carries pressure.
    /// - [`Error::GridTooShort`] if the grid ends less than a step ahead of the contact.
    /// - [`Error::BeyondFrictionCapacity`] or [`Error::BeyondFrictionMoment`] if the loads exceed the capacity of
    ///   friction.
    /// - [`Error::Memory`] if memory runs out.
    /// - The errors of [`HalfSpace::operator`].
    pub fn solve(&self) -> Result<CoupledRollingSolution> {
        CoupledRollingSolver::solve_once(self)
    }

    /// Returns the reusable solver. The gap, the friction and the loads can change between solves, and each solve starts
    /// from the last solution.
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out.
    /// - The errors of [`HalfSpace::operator`].
    pub fn into_solver(self) -> Result<CoupledRollingSolver> {
        CoupledRollingSolver::new(self)
    }

    /// Returns an error if no pressure can carry the loads. A prescribed normal force times the largest coefficient of friction
    /// bounds the friction capacity.
    pub(super) fn check(
        &self,
        friction: &Friction,
        normal: NormalLoad,
        controls: [RollingControl; 2],
        spin: SpinControl,
    ) -> Result<()> {
        let length =
            RollingShift::new(self.bodies.grid(), self.options.edge, self.options.cells).length;
        check_motion(&self.bodies, length, controls, spin)?;
        normal.check(&self.bodies, &self.gap, None)?;
        match normal {
            NormalLoad::Force(force) if force > 0.0 => {
                let coefficient = friction.largest_coefficient(&self.bodies);
                check_forces(controls, coefficient * force, friction.rolling_remedy())
            }
            _ => Ok(()),
        }
    }

    /// Checks a friction and a normal load like [`Self::check`], with the present motion.
    pub(super) fn check_capacity(&self, friction: &Friction, normal: NormalLoad) -> Result<()> {
        let RollingOptions { controls, spin, .. } = self.options;
        self.check(friction, normal, controls, spin)
    }
}

impl CoupledRollingProblemBuilder {
    rolling_methods!(problem.options);

    /// Checks all inputs that do not depend on the pressure.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the gap or the friction has a different grid.
    /// - [`Error::Sample`] if the gap is not finite.
    /// - [`Error::NegativeOrNotFinite`], [`Error::NotFinite`] or [`Error::ApproachBeyondMeanGap`] for an invalid normal
    ///   load.
    /// - [`Error::NotFinite`] if a creepage, a force, the spin or the moment is not finite.
    /// - [`Error::NotPositive`] for a step of zero cells.
    /// - [`Error::BeyondFrictionCapacity`] if the forces reach or exceed the largest coefficient of friction times a prescribed
    ///   normal force.
    /// - [`Error::UnsupportedByModel`] for rolling along an axis on which the grid is periodic, or for spin on such a
    ///   grid.
    /// - [`Error::UnsupportedForCoatings`] for user-defined operators.
    /// - [`Error::Tolerance`], [`Error::IterationLimit`] or [`Error::Method`] for invalid settings.
    /// - [`Error::Ranks`] if the bodies are distributed over ranks.
    pub fn build(self) -> Result<CoupledRollingProblem> {
        let problem = self.problem;
        let options = &problem.options;
        let (bodies, grid) = (&problem.bodies, problem.bodies.grid());
        if bodies.is_shared() {
            return Err(Error::Ranks(RankFailure::UnsupportedOnRanks(
                "steady rolling",
            )));
        }
        problem.gap.check("gap", grid)?;
        problem.friction.check(grid)?;
        options.settings.check()?;
        TangentialModel::Vector.check(&options.settings)?;
        RollingShift::new(grid, options.edge, options.cells).check(bodies)?;
        check_joint(bodies)?;
        problem.check(
            &problem.friction,
            problem.normal,
            options.controls,
            options.spin,
        )?;
        Ok(problem)
    }
}
