//! Input of a normal contact, checked when it is built.

use std::sync::Arc;

use crate::bodies::component::Direction;
use crate::cgm::{Settings, Total, settings_methods};
use crate::error::{Error, Result, finite, has_squares, non_negative};
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::memory::fallible::{TryClone, try_clone};
use crate::normal::pressure_solver::NormalInput;
use crate::normal::{Hardness, NormalSolution, NormalSolver};

/// Prescribed normal load: a force, an approach or a fixed pressure.
///
/// A [`NormalProblem`] applies the load to unloaded bodies. A step of a [`History`](crate::History) reaches the load at
/// its end.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum NormalControl {
    /// Normal force W >= 0, from which the approach follows. The bodies just touch at zero force.
    Force(f64),
    /// Approach delta of the bodies from the datum of the gap (a length, positive for bodies that move together). The
    /// force follows from the approach. At an approach at or below the least gap, the bodies do not touch.
    ///
    /// On a periodic grid the approach must be less than the mean gap, because the mean gap closes the whole gap. On
    /// such a grid the certified error is measured against the exact contact under the computed force.
    Approach(f64),
    /// Unchanged pressure for any gap. A step then does not solve for the pressure. A [`NormalProblem`] has no earlier
    /// pressure and returns an error.
    Hold,
}

impl NormalControl {
    /// Returns the datum of the gap and the prescribed total of the pressures. A datum near the contact avoids
    /// cancellation in sums of gaps.
    pub(crate) fn to_datum_and_total(
        self,
        bodies: &HalfSpace,
        gap: &Field,
    ) -> Result<(f64, Total)> {
        match self {
            Self::Force(force) => {
                let sum = Total::Sum(force / bodies.grid().cell_area());
                Ok((bodies.least(gap), sum))
            }
            Self::Approach(approach) => Ok((approach, Total::Free)),
            Self::Hold => Err(Error::NoPressureToHold),
        }
    }

    /// Returns an error if the load cannot act on the gap or exceeds the hardness. Gap and hardness must have been
    /// checked.
    pub(crate) fn check(
        self,
        bodies: &HalfSpace,
        gap: &Field,
        hardness: Option<&Hardness>,
    ) -> Result<()> {
        match self {
            Self::Force(force) => {
                non_negative("normal force", force)?;
                let pressure = force / gap.grid().cell_area();
                finite("normal force divided by the cell area", pressure)?;
                let mean = force / bodies.grid().whole().area();
                check_size(force, [mean, mean * bodies.cell_compliance()])?;
            }
            Self::Approach(approach) => {
                finite("approach", approach)?;
                let mean_gap = || bodies.integral(gap) / bodies.grid().whole().area();
                if bodies.boundary() == Boundary::Periodic && approach >= mean_gap() {
                    let mean_gap = mean_gap();
                    return Err(Error::ApproachBeyondMeanGap { approach, mean_gap });
                }
                let depth = (approach - bodies.least(gap)).max(0.0);
                check_size(depth, [depth / bodies.cell_compliance(), depth])?;
            }
            Self::Hold => return Err(Error::NoPressureToHold),
        }
        hardness.map_or(Ok(()), |hardness| hardness.check_load(bodies, self))
    }
}

/// Returns an error if a non-zero load causes pressures or displacements whose squares overflow or underflow.
fn check_size(load: f64, [pressure, displacement]: [f64; 2]) -> Result<()> {
    if load == 0.0 {
        return Ok(());
    }
    let remedy = "choose different units of length or pressure, or a zero load";
    has_squares("the pressure due to the normal load", pressure, remedy)?;
    let quantity = "the displacement due to the normal load";
    has_squares(quantity, displacement, remedy).map(drop)
}

/// Bodies, gap and load of a normal contact.
///
/// ```
/// use stickslip::analytical::HertzSphere;
/// use stickslip::{ElasticPair, Grid, HalfSpace, Material, NormalControl, NormalProblem, surface};
///
/// let grid = Grid::square(64, 0.40e-3)?;
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 3.5e-3)?;
/// let contact = NormalProblem::builder(&bodies, &ball, NormalControl::Force(100.0)).build()?.solve()?;
///
/// let hertz = HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
/// assert!((contact.pressure().max() / hertz.max_pressure() - 1.0).abs() < 2e-3);
/// assert!((contact.approach() / hertz.approach() - 1.0).abs() < 2e-4);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct NormalProblem {
    pub(super) bodies: HalfSpace,
    pub(super) gap: Arc<Field>,
    pub(super) load: NormalControl,
    pub(super) hardness: Option<Hardness>,
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
        load: NormalControl,
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
            control: self.load,
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
    /// - [`Error::NotConverged`] with the report if a limit is reached. Use [`NormalSolver::solve_into`] to keep the
    ///   last iterate.
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
    /// is an error. An approach may bring all cells to their limit.
    pub fn hardness(mut self, hardness: Hardness) -> Self {
        self.problem.hardness = Some(hardness);
        self
    }

    /// Checks the input and creates the problem.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid of the gap or of the hardness differs from the grid of the bodies.
    /// - [`Error::Sample`] if the gap is not finite.
    /// - [`Error::NegativeOrNotFinite`] or [`Error::NotFinite`] if the load is negative or not finite.
    /// - [`Error::Tolerance`] or [`Error::IterationLimit`] if a setting is out of range.
    /// - [`Error::ApproachBeyondMeanGap`] on a periodic grid if the approach is not less than the mean gap.
    /// - [`Error::BeyondHardness`] if the force exceeds the capacity of the cells.
    /// - [`Error::ExtremeNumber`] if the load is not zero and the pressure or displacement that it causes lies outside
    ///   1e-130 to 1e130.
    /// - [`Error::Ranks`] if ranks fail or pass different input.
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
