//! Limits of the values without a warning.

use crate::error::Result;
use crate::grid::Grid;
use crate::report::Status;
use crate::warning::Warning;

/// Discretisation error above which a warning is given.
const LARGEST_ERROR: f64 = 0.05;
/// Discretisation error after the suggested refinement.
const SMALL_ERROR: f64 = 0.01;

/// Largest thickness of a layer without a warning, over the longest side of the grid. The error of the approach without the material
/// below the layer is of the order of the contact radius over the thickness.
pub(crate) const THICKEST_LAYER: usize = 10;

/// Largest shift of a step without a warning, in tenths of the longest side of the grid.
const LARGEST_SHIFT: usize = 10;

/// Largest limit of the pressure or of the traction without a warning, in plane-strain moduli.
const LARGEST_LIMIT: f64 = 1.0;

/// Largest component of a bulk strain without a warning, in tenths of a per cent.
const LARGEST_STRAIN: usize = 20;

/// Largest twist of a step without a warning, in tenths of a radian.
const LARGEST_TWIST: usize = 2;

/// Smallest creepage with a warning. The margin allows for round-off of a creepage of a tenth.
const LARGE_CREEPAGE: f64 = 0.1 * (1.0 - 1e-12);

/// Largest coefficient of friction without a warning, in tenths.
const LARGEST_FRICTION: usize = 50;

/// Largest coupling of pressure and traction without a warning in the scalar model, in per cent of the coefficient of friction.
pub(super) const LARGEST_COUPLING: usize = 50;

/// Largest change of the gap without a warning, in tenths of the largest normal displacement.
const LARGEST_GAP_CHANGE: usize = 10;
/// Largest change without a warning of a gap that a solver compares with its last gap. Changes of a study can resemble wear.
const LARGEST_WEAR: usize = 100;

/// Largest contact modulus without a warning, in largest pressures of a contact at its hardness.
pub(crate) const LOWEST_HARDNESS: usize = 10_000;

/// Largest friction capacity without a cap for which no warning is given, in capacities with the cap.
pub(super) const LOWEST_CAP: usize = 100;

/// Largest contact modulus without a warning, in largest prescribed pressures.
pub(super) const LOWEST_PRESSURE: usize = 10_000_000;

/// Largest pressure without a warning, in thousandths of the contact modulus.
const LARGEST_PRESSURE: usize = 500;

/// Largest mean jump of a gap across a periodic border without a warning, in largest mean steps between neighbouring cells.
pub(crate) const LARGEST_SEAM: usize = 5;

/// Largest residual of a cycle without a warning, in per cent.
pub(super) const LARGEST_RESIDUAL: usize = 10;

/// Number of spots above which a contact counts as rough. The radius of the spots then cannot be chosen.
pub(super) const MANY_SPOTS: usize = 10;

/// Returns the factor by which the cell size must be divided for a small discretisation error.
pub(super) fn refinement(estimate: f64) -> f64 {
    (estimate / SMALL_ERROR).cbrt().powi(2)
}

impl Warning {
    /// Returns the warning for an estimated discretisation error. `contact` contains the number of cells on the radius
    /// of a contact spot and the number of spots.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "both are positive, and what is no number of cells saturates"
    )]
    pub(crate) fn of_discretisation(
        estimate: Option<f64>,
        contact: impl FnOnce() -> Result<(f64, usize)>,
    ) -> Result<Option<Self>> {
        let Some(estimate) = estimate.filter(|estimate| *estimate > LARGEST_ERROR) else {
            return Ok(None);
        };
        let (radius, spots) = contact()?;
        Ok(Some(Self::DiscretisationError {
            per_mille: (1e3 * estimate).round() as usize,
            cells_per_radius: (radius * refinement(estimate)).ceil() as usize,
            spots,
        }))
    }
}

impl Warning {
    /// Returns the warning for a ratio of an estimated error to its target.
    #[cfg(feature = "adaptive")]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the ratio is not negative, and a large one saturates"
    )]
    pub(crate) fn accuracy_not_reached(ratio: f64) -> Self {
        Self::AccuracyNotReached {
            tenths: (10.0 * ratio).ceil() as usize,
        }
    }

    /// Returns a shift over the longest side of the whole grid, in tenths, or `None` if the shift is small.
    pub(crate) fn shift_beyond(grid: Grid, [x, y]: [f64; 2]) -> Option<usize> {
        tenths_beyond(x.hypot(y) / grid.whole().reference_side(), LARGEST_SHIFT)
    }

    /// Returns the warning for the magnitude of a bulk strain in thousandths, or `None` if the strain is small.
    pub(crate) fn of_strain(per_mille: Option<usize>) -> Option<Self> {
        per_mille.map(|per_mille| Self::LargeBulkStrain { per_mille })
    }

    /// Returns the magnitude of a bulk strain in thousandths, or `None` if the strain is small.
    pub(crate) fn strain_beyond(strain: f64) -> Option<usize> {
        tenths_beyond(100.0 * strain, LARGEST_STRAIN)
    }

    /// Returns a twist in tenths of a radian, or `None` if the twist is small.
    pub(crate) fn twist_beyond(twist: f64) -> Option<usize> {
        tenths_beyond(twist.abs(), LARGEST_TWIST)
    }

    /// Returns the magnitude of a creepage, with the motion of the farthest contact cell by the spin, in per cent. Returns `None`
    /// if this creepage is small.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the magnitude is not negative, and a large one saturates"
    )]
    pub(crate) fn creepage_beyond([x, y]: [f64; 2], by_spin: f64) -> Option<usize> {
        let creepage = x.hypot(y) + by_spin.abs();
        (creepage >= LARGE_CREEPAGE).then(|| (100.0 * creepage).round() as usize)
    }

    /// Returns a coefficient of friction in tenths, or `None` if the coefficient is common.
    pub(crate) fn friction_beyond(coefficient: f64) -> Option<usize> {
        tenths_beyond(coefficient, LARGEST_FRICTION)
    }

    /// Returns a ratio of Dundurs' beta to the coefficient of friction in per cent, or `None` if the coupling is weak.
    pub(crate) fn coupling_beyond(ratio: f64) -> Option<usize> {
        tenths_beyond(10.0 * ratio, LARGEST_COUPLING)
    }

    /// Returns the warning about neglected tractions for a ratio in per cent, or `None` if the coupling is weak.
    pub(crate) fn of_coupling(per_cent: Option<usize>) -> Option<Self> {
        per_cent.map(|per_cent| Self::NeglectedTraction { per_cent })
    }

    /// Returns the ratio of the friction capacity without a cap to the capacity, or `None` if the ratio is small or the capacity is
    /// zero.
    pub(crate) fn cap_below(ratio: f64) -> Option<usize> {
        parts_beyond(ratio, LOWEST_CAP)
    }

    /// Returns the warning for a prescribed pressure with this ratio of its largest value to the contact modulus, or `None` if
    /// the ratio is common.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the ratio is not negative, and a large one saturates"
    )]
    pub(crate) fn of_pressure(ratio: f64) -> Option<Self> {
        let low = parts_beyond(1.0 / ratio, LOWEST_PRESSURE);
        let low = low.map(|parts| Self::LowPressure { parts });
        low.or_else(|| Self::pressure_beyond((1e3 * ratio).round() as usize))
    }

    /// Returns the warning for a largest pressure in thousandths of the contact modulus, or `None` if the pressure is common.
    pub(crate) fn pressure_beyond(per_mille: usize) -> Option<Self> {
        (per_mille > LARGEST_PRESSURE).then_some(Self::PressureBeyondModulus { per_mille })
    }

    /// Returns the warning about a low hardness at the pressure of a contact, or about a high hardness.
    pub(crate) fn of_hardness(parts: Option<usize>, per_mille: Option<usize>) -> Option<Self> {
        let low = parts.map(|parts| Self::LowHardness { parts });
        low.or_else(|| per_mille.map(|per_mille| Self::HardnessBeyondModulus { per_mille }))
    }

    /// Returns the ratio of a limit to the plane-strain modulus in thousandths, or `None` if the limit is at most this
    /// modulus.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the ratio is positive, and a large one saturates"
    )]
    pub(crate) fn limit_beyond(ratio: f64) -> Option<usize> {
        (ratio > LARGEST_LIMIT).then(|| (1e3 * ratio).round() as usize)
    }

    /// Returns the warning for a residual of a cycle, or `None` if the residual is small.
    #[cfg(feature = "history")]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the residual is not negative, and a large one saturates"
    )]
    pub(crate) fn open_beyond(residual: f64) -> Option<Self> {
        let per_cent = (100.0 * residual).round() as usize;
        (per_cent > LARGEST_RESIDUAL).then_some(Self::OpenCycle { per_cent })
    }

    /// Returns a change of the gap over the largest normal displacement, in tenths, or `None` if the change is small.
    pub(crate) fn gap_change_beyond(ratio: f64) -> Option<usize> {
        tenths_beyond(ratio, LARGEST_GAP_CHANGE)
    }

    /// Returns the wear between two solves over the largest normal displacement, in tenths, or `None` if the wear is small.
    pub(crate) fn wear_beyond(ratio: f64) -> Option<usize> {
        tenths_beyond(ratio, LARGEST_WEAR)
    }

    /// Returns the warning about a solve that ended before it converged.
    pub(crate) fn of_status(status: Status) -> Option<Self> {
        let is_final = matches!(status, Status::Converged | Status::Unsolved);
        (!is_final).then_some(Self::NotConverged)
    }

    /// Returns a neglected lift due to tractions, in millionths, or `None` if the lift is within the tolerance.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the lift is not negative, and a large one saturates"
    )]
    pub(crate) fn lift_beyond(lift: f64, tolerance: f64) -> Option<usize> {
        (lift > tolerance).then(|| (1e6 * lift).ceil() as usize)
    }
}

/// Returns a non-negative value in tenths, or `None` if it is at most the limit.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the value is not negative, and a large one saturates"
)]
fn tenths_beyond(value: f64, limit: usize) -> Option<usize> {
    let tenths = (10.0 * value).round() as usize;
    (tenths > limit).then_some(tenths)
}

/// Returns the nearest integer to a non-negative ratio, or `None` if the ratio is at most the limit.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the ratio is not negative, and a large one saturates"
)]
fn parts_beyond(ratio: f64, limit: usize) -> Option<usize> {
    (ratio > limit as f64).then(|| ratio.round() as usize)
}
