//! The scene of a normal contact, checked once.

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

/// What presses the bodies together.
///
/// A problem takes it from rest; a step of a [`History`](crate::History) reaches it at its end.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum NormalControl {
    /// The normal force W >= 0; the approach follows. Zero force is first touch.
    Force(f64),
    /// The approach delta of the bodies from the datum of the gap (a length, positive when they
    /// come together); the force follows. At or below the least gap nothing touches. On a periodic grid
    /// it must stay below the mean gap, which it would close, and the certified error is measured against the exact
    /// contact under the force that was found.
    Approach(f64),
    /// The pressure as it is, whatever the gap has become: nothing is solved. A problem has no pressure to hold, and
    /// refuses it.
    Hold,
}

impl NormalControl {
    /// The number that a gap is measured from, and what is prescribed of the sum of the pressures: without a datum far from
    /// the contact the sums keep their last digits.
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

    /// `Ok` if the load can press the gap, and the hardness carries it; both must have been checked.
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
                finite("normal force over the area of a cell", pressure)?;
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

/// Returns an error if a load is not zero, and the squares of the pressures or of the displacements that it causes leave the
/// range of numbers.
fn check_size(load: f64, [pressure, displacement]: [f64; 2]) -> Result<()> {
    if load == 0.0 {
        return Ok(());
    }
    let remedy = "choose other units of length or pressure, or a load that is zero";
    has_squares("the pressure that the normal load causes", pressure, remedy)?;
    let quantity = "the displacement that the normal load causes";
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

/// Options of a [`NormalProblem`]; each has a default.
#[derive(Debug, Clone)]
#[must_use = "a builder does nothing until build() is called"]
pub struct NormalProblemBuilder<'a> {
    bodies: &'a HalfSpace,
    gap: Arc<Field>,
    load: NormalControl,
    hardness: Option<Hardness>,
    settings: Settings,
}

impl NormalProblem {
    /// Starts from what is required: bodies, initial gap (lengths, on the grid of the bodies) and
    /// load. The gap is copied from a reference; given by value, or in an [`Arc`], it is not.
    pub fn builder(
        bodies: &HalfSpace,
        gap: impl Into<Arc<Field>>,
        load: NormalControl,
    ) -> NormalProblemBuilder<'_> {
        NormalProblemBuilder {
            bodies,
            gap: gap.into(),
            load,
            hardness: None,
            settings: Settings::default(),
        }
    }

    /// What is to be solved.
    pub(super) fn pressing(&self) -> NormalInput<'_> {
        NormalInput {
            bodies: &self.bodies,
            gap: &self.gap,
            hardness: self.hardness.as_ref(),
            control: self.load,
            settings: &self.settings,
        }
    }

    /// Solves once, with buffers of its own.
    ///
    /// # Errors
    /// [`Error::NotConverged`] with the report, use [`NormalSolver::solve_into`] to keep the last iterate; as
    /// [`HalfSpace::operator`].
    pub fn solve(&self) -> Result<NormalSolution> {
        NormalSolver::new(self.try_clone()?)?.into_solution()
    }

    /// The reusable form: a solver that owns its buffers and lets load and gap change.
    ///
    /// # Errors
    /// As [`HalfSpace::operator`].
    pub fn into_solver(self) -> Result<NormalSolver> {
        NormalSolver::new(self)
    }
}

impl NormalProblemBuilder<'_> {
    settings_methods!();

    /// The largest pressure the cells carry (default: no limit). A force beyond what all cells carry together is refused;
    /// an approach may bring them all to their limit.
    pub fn hardness(mut self, hardness: Hardness) -> Self {
        self.hardness = Some(hardness);
        self
    }

    /// Checks everything.
    ///
    /// # Errors
    /// [`Error::GridMismatch`] if the gap lives on another grid, [`Error::Sample`] if it is not
    /// finite, [`Error::NegativeOrNotFinite`] or [`Error::NotFinite`] for the load, [`Error::Tolerance`],
    /// [`Error::IterationLimit`]; [`Error::ApproachBeyondMeanGap`] on a periodic grid;
    /// [`Error::BeyondHardness`]; [`Error::ExtremeNumber`] if the load is not zero, and the pressure or the displacement that
    /// it causes lies outside 1e-130 to 1e130; [`Error::Ranks`].
    pub fn build(self) -> Result<NormalProblem> {
        let hardness = self.hardness.as_ref();
        self.bodies.collective_result_checked(
            self.check(),
            &[
                ("normal load", &self.load),
                ("hardness", &hardness.map(Hardness::common)),
                ("settings", &self.settings.common()),
            ],
        )?;
        self.load.check(self.bodies, &self.gap, hardness)?;
        Ok(NormalProblem {
            bodies: self.bodies.clone(),
            gap: self.gap,
            load: self.load,
            hardness: self.hardness,
            settings: self.settings,
        })
    }

    /// `Ok` if everything is right that a rank sees by itself.
    fn check(&self) -> Result<()> {
        self.bodies.check_directions([Direction::Z], false)?;
        check_gap(self.bodies, &self.gap)?;
        if let Some(hardness) = &self.hardness {
            hardness.check(self.bodies.grid())?;
        }
        self.settings.check()
    }
}

pub(super) fn check_gap(bodies: &HalfSpace, gap: &Field) -> Result<()> {
    gap.check("gap", bodies.grid())
}
