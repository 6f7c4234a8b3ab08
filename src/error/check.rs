//! Checks of arguments, each with its error.

use std::ops::RangeInclusive;

use crate::error::{Error, Result};
use crate::report::{Report, Status};

/// Checks that `value` is positive and finite.
pub(crate) fn positive(quantity: &'static str, value: f64) -> Result<f64> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotPositive { quantity, value })
    }
}

/// Checks that `value` is zero or positive, and finite.
pub(crate) fn non_negative(quantity: &'static str, value: f64) -> Result<f64> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NegativeOrNotFinite { quantity, value })
    }
}

/// Checks that `value` is finite.
pub(crate) fn finite(quantity: &'static str, value: f64) -> Result<f64> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { quantity, value })
    }
}

/// Range of numbers for which sums over all cells neither overflow nor underflow. The summands may be squares of such
/// numbers or products of two such numbers.
const WITH_SQUARES: RangeInclusive<f64> = 1e-130..=1e130;

/// Checks that the squares of a positive value, and of small fractions of this value, neither overflow nor underflow.
pub(crate) fn has_squares(quantity: &'static str, value: f64, remedy: &'static str) -> Result<f64> {
    if WITH_SQUARES.contains(&value) {
        Ok(value)
    } else {
        Err(Error::ExtremeNumber {
            quantity,
            value,
            least: *WITH_SQUARES.start(),
            most: *WITH_SQUARES.end(),
            remedy,
        })
    }
}

/// Checks that an isotropic body with this Poisson's ratio is stable.
pub(crate) fn poisson_ratio(value: f64) -> Result<()> {
    if value > -1.0 && value <= 0.5 {
        Ok(())
    } else {
        Err(Error::PoissonRatio(value))
    }
}

/// Checks that every sample is finite.
pub(crate) fn all_finite(quantity: &'static str, samples: &[f64]) -> Result<()> {
    samples_obey(quantity, samples, "must be finite", f64::is_finite)
}

/// Checks that every sample is zero or positive, and finite.
pub(crate) fn all_non_negative(quantity: &'static str, samples: &[f64]) -> Result<()> {
    samples_obey(
        quantity,
        samples,
        "must be non-negative and finite",
        |value| value >= 0.0 && value.is_finite(),
    )
}

/// Number of samples that are tested together.
const SCANNED: usize = 512;

/// Checks that every sample obeys the rule. The error reports the first sample that violates the rule.
pub(crate) fn samples_obey(
    quantity: &'static str,
    samples: &[f64],
    rule: &'static str,
    obeys: impl Fn(f64) -> bool,
) -> Result<()> {
    // The test of a chunk has no early exit, so that the loop can be vectorised.
    let is_broken = |chunk: &[f64]| !chunk.iter().fold(true, |all, &value| all & obeys(value));
    let broken = samples.chunks(SCANNED).position(is_broken);
    let found = broken.and_then(|chunk| {
        let first = chunk * SCANNED;
        let position = samples[first..].iter().position(|&value| !obeys(value));
        position.map(|position| first + position)
    });
    match found {
        None => Ok(()),
        Some(index) => Err(Error::Sample {
            quantity,
            index,
            value: samples[index],
            rule,
        }),
    }
}

/// Checks that a slice has the expected length.
pub(crate) fn length(quantity: &'static str, expected: usize, found: usize) -> Result<()> {
    if expected == found {
        Ok(())
    } else {
        Err(Error::Length {
            quantity,
            expected,
            found,
        })
    }
}

/// Checks that memory for `[columns, rows]` of `each` bytes can be allocated now. The function requests and releases
/// the memory without writing to it.
pub(crate) fn memory(quantity: &'static str, counts: [usize; 2], each: usize) -> Result<()> {
    let [columns, rows, each] = [counts[0], counts[1], each].map(|count| count as u128);
    let bytes = columns.saturating_mul(rows).saturating_mul(each);
    let can_be_had = usize::try_from(bytes).is_ok_and(|bytes| {
        let mut probe = Vec::<u8>::new();
        let outcome = probe.try_reserve_exact(bytes);
        // Without this use, the compiler may assume that an unused allocation succeeds.
        std::hint::black_box(&mut probe);
        outcome.is_ok()
    });
    if can_be_had {
        Ok(())
    } else {
        Err(Error::Memory { quantity, bytes })
    }
}

/// Returns an error for a solution that has not converged, or that no solve has filled.
pub(crate) fn check_converged(report: &Report) -> Result<()> {
    if report.is_converged() {
        Ok(())
    } else {
        Err(Error::NotConverged(Box::new(report.clone())))
    }
}

/// Returns an error for a solution that no solve has filled.
pub(crate) fn check_solved(report: &Report) -> Result<()> {
    if report.status == Status::Unsolved {
        return Err(Error::NotConverged(Box::new(report.clone())));
    }
    Ok(())
}

/// Returns the error of an iteration that reached its limit.
pub(crate) fn not_converged(iterations: usize, residual: f64) -> Error {
    Error::NotConverged(Box::new(Report {
        status: Status::IterationLimit,
        iterations,
        residual,
        ..Report::unsolved()
    }))
}

/// Checks that a value is at least its lower limit, within round-off.
pub(crate) fn at_least(
    least_is: &'static str,
    least: f64,
    quantity: &'static str,
    value: f64,
) -> Result<f64> {
    if value >= least * (1.0 - ROUND_OFF) {
        Ok(value)
    } else {
        Err(Error::BelowMinimum {
            quantity,
            value,
            least_is,
            least,
        })
    }
}

/// Relative deficit at which a value that should equal its lower limit is still accepted.
const ROUND_OFF: f64 = 1e-9;

/// Remedy for a load beyond the friction limit.
pub(crate) const SLIDE: &str = "prescribe a shift or a spring to let the body slide";
/// Remedy for a load of rolling bodies beyond the friction limit.
pub(crate) const ROLL: &str = "prescribe the creepage, or lower the force";

/// Remedy for a load beyond a friction limit with a largest shear stress.
pub(crate) const SLIDE_UNDER_CAP: &str = "check the unit of the largest shear stress, or prescribe a shift or a spring to let the body slide";
/// Remedy for a load of rolling bodies beyond a friction limit with a largest shear stress.
pub(crate) const ROLL_UNDER_CAP: &str =
    "check the unit of the largest shear stress, or prescribe the creepage, or lower the force";

/// Replaces the remedy for a force beyond the friction capacity.
pub(crate) fn with_remedy(error: Error, remedy: &'static str) -> Error {
    match error {
        Error::BeyondFrictionCapacity { force, limit, .. } => Error::BeyondFrictionCapacity {
            force,
            limit,
            remedy,
        },
        other => other,
    }
}
