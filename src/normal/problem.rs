//! Input of a normal contact, checked when it is built.

use std::sync::Arc;

use crate::bodies::component::Direction;
use crate::cgm::{Settings, settings_methods};
use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::memory::fallible::{TryClone, try_clone};
use crate::normal::pressure_solver::NormalInput;
use crate::normal::{Hardness, NormalLoad, NormalSolution, NormalSolver};

/// Bodies, gap and load of a normal contact.
///
/// ```
/// use stickslip::analytical::HertzSphere;
/// use stickslip::{ElasticPair, Grid, HalfSpace, Material, NormalLoad, NormalProblem, surface};
///
/// let grid = Grid::square(64, 0.40e-3)?;
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 3.5e-3)?;
/// let contact = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(100.0)).build()?.solve()?;
///
/// let hertz = HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
/// assert!((contact.pressure().max() / hertz.max_pressure() - 1.0).abs() < 2e-3);
/// assert!((contact.approach() / hertz.approach() - 1.0).abs() < 2e-4);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct NormalProblem {
    pub(crate) bodies: HalfSpace,
    pub(crate) gap: Arc<Field>,
    pub(crate) load: NormalLoad,
    pub(crate) hardness: Option<Hardness>,
    pub(super) settings: Settings,
}

try_clone!(NormalProblem { hardness } { bodies, gap, load, settings });

/// Options of a [`NormalProblem`], all with defaults.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct NormalProblemBuilder {
    problem: NormalProblem,
}

impl NormalProblem {
    /// Starts a builder from the required input: bodies, initial gap (lengths, on the grid of the bodies) and load. A
    /// gap passed by reference is copied. A gap passed by value or in an [`Arc`] is not copied.
    pub fn builder(
        bodies: &HalfSpace,
        gap: impl Into<Arc<Field>>,
        load: NormalLoad,
    ) -> NormalProblemBuilder {
        NormalProblemBuilder {
            problem: Self {
                bodies: bodies.clone(),
                gap: gap.into(),
                load,
                hardness: None,
                settings: Settings::default(),
            },
        }
    }

    /// Returns the input of the pressure solver.
    pub(super) fn pressing(&self) -> NormalInput<'_> {
        NormalInput {
            bodies: &self.bodies,
            gap: &self.gap,
            hardness: self.hardness.as_ref(),
            load: self.load,
            settings: &self.settings,
        }
    }

    /// Checks the input that a rank can check without the other ranks.
    fn check(&self) -> Result<()> {
        self.bodies.check_directions([Direction::Z], false)?;
        check_gap(&self.bodies, &self.gap)?;
        if let Some(hardness) = &self.hardness {
            hardness.check(self.bodies.grid())?;
        }
        self.settings.check()
    }

    /// Solves the contact once with temporary buffers.
    ///
    /// # Errors
    /// - [`Error::NotConverged`](crate::Error::NotConverged) with the report if a limit is reached. Use
    ///   [`NormalSolver::solve_into`] to keep the last iterate.
    /// - Errors of [`HalfSpace::operator`].
    pub fn solve(&self) -> Result<NormalSolution> {
        NormalSolver::new(self.try_clone()?)?.into_solution()
    }

    /// Creates a reusable solver, which owns its buffers and lets load and gap change.
    ///
    /// # Errors
    /// Errors of [`HalfSpace::operator`].
    pub fn into_solver(self) -> Result<NormalSolver> {
        NormalSolver::new(self)
    }
}

impl NormalProblemBuilder {
    settings_methods!(problem.settings);

    /// Sets the largest pressure that the cells can carry (default: no limit). A force beyond the capacity of all cells
    /// causes an error. An approach may bring all cells to their limit.
    pub fn hardness(mut self, hardness: Hardness) -> Self {
        self.problem.hardness = Some(hardness);
        self
    }

    /// Checks the input and creates the problem.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the grid of the gap or of the hardness differs from the grid of
    ///   the bodies.
    /// - [`Error::Sample`](crate::Error::Sample) if the gap is not finite.
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) or [`Error::NotFinite`](crate::Error::NotFinite) if
    ///   the load is negative or not finite.
    /// - [`Error::Tolerance`](crate::Error::Tolerance) or [`Error::IterationLimit`](crate::Error::IterationLimit) if a setting is
    ///   out of range.
    /// - [`Error::ApproachBeyondMeanGap`](crate::Error::ApproachBeyondMeanGap) on a periodic grid if the approach is not less
    ///   than the mean gap.
    /// - [`Error::BeyondHardness`](crate::Error::BeyondHardness) if the force exceeds the capacity of the cells.
    /// - [`Error::ExtremeNumber`](crate::Error::ExtremeNumber) if the load is not zero and the pressure or displacement that it
    ///   causes lies outside 1e-130 to 1e130.
    /// - [`Error::Ranks`](crate::Error::Ranks) if ranks fail or pass different input.
    pub fn build(self) -> Result<NormalProblem> {
        let problem = self.problem;
        let hardness = problem.hardness.as_ref();
        problem.bodies.collective_result_checked(
            problem.check(),
            &[
                ("normal load", &problem.load),
                ("hardness", &hardness.map(Hardness::common)),
                ("settings", &problem.settings.common()),
            ],
        )?;
        problem
            .load
            .check(&problem.bodies, &problem.gap, hardness)?;
        Ok(problem)
    }
}

pub(super) fn check_gap(bodies: &HalfSpace, gap: &Field) -> Result<()> {
    gap.check("gap", bodies.grid())
}
