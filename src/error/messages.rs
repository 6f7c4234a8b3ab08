//! Error messages that are not a fixed sentence of their variant.

#[cfg(test)]
mod tests;

use crate::error::{ROLL_UNDER_CAP, SLIDE_UNDER_CAP};
use crate::report::{Report, Status};

/// Returns the name of a file as a prefix for the description of a problem in the file.
pub(super) fn prefix(file: Option<&str>) -> String {
    file.map_or_else(String::new, |file| format!("{file}: "))
}

/// Returns the text for a number of bytes, in MiB below 1 GiB and in GiB above.
pub(super) fn size(bytes: u128) -> String {
    const MIB: f64 = 1_048_576.0;
    let mib = bytes as f64 / MIB;
    let (value, unit) = if mib < 1024.0 {
        (mib, "MiB")
    } else {
        (mib / 1024.0, "GiB")
    };
    let decimals = match value {
        ..0.01 => 6,
        ..10.0 => 3,
        _ => 1,
    };
    format!("{value:.decimals$} {unit}")
}

/// Returns the text for a given value, or an empty text for zero, the number of an absent value.
pub(super) fn given(value: f64) -> String {
    if value == 0.0 {
        String::new()
    } else {
        format!(", got {value:?}")
    }
}

/// Returns a count with its noun in the singular or the plural.
pub(crate) fn counted(count: usize, noun: &str) -> String {
    match noun.strip_suffix('y') {
        _ if count == 1 => format!("1 {noun}"),
        Some(stem) => format!("{count} {stem}ies"),
        None => format!("{count} {noun}s"),
    }
}

/// Relative difference at which a force equals its limit within round-off.
const EQUAL: f64 = 1e-9;

/// Ratio of a force to its limit above which the units of force and pressure may differ.
const LARGEST_RATIO: f64 = 100.0;

/// Returns the message for a tangential force beyond the friction capacity, with a remedy.
pub(super) fn beyond_capacity(force: f64, limit: f64, remedy: &str) -> String {
    let remedy = if limit > 0.0 {
        remedy
    } else {
        "give a positive coefficient of friction"
    };
    let verb = if force > limit * (1.0 + EQUAL) {
        "exceeds"
    } else {
        "reaches"
    };
    // Without friction, the units do not cause the error. A low cap is a more likely cause.
    let is_capped = [SLIDE_UNDER_CAP, ROLL_UNDER_CAP].contains(&remedy);
    let units = if limit > 0.0 && force > LARGEST_RATIO * limit && !is_capped {
        ", or check the units of force and pressure"
    } else {
        ""
    };
    format!("the tangential force {force:?} {verb} the friction limit {limit:?}: {remedy}{units}")
}

/// Returns the message for a normal force beyond the hardness, with a remedy.
pub(super) fn beyond_hardness(force: f64, capacity: f64) -> String {
    format!(
        "the normal force {force:?} exceeds {capacity:?}, the largest force that the cells can carry at their hardness: check the unit of the hardness, use a larger grid, or prescribe an approach"
    )
}

/// Returns the message for a height distribution that was not reached.
pub(super) fn heights_not_reached(skewness: f64, kurtosis: f64, reached: [f64; 2]) -> String {
    format!(
        "no surface of this spectrum was found with a skewness of {skewness:?} and a kurtosis of {kurtosis:?}: request values nearer to {:?} and {:?}, at which the search ended",
        reached[0], reached[1]
    )
}

/// Returns the message for a quantity that the known points do not determine.
pub(super) fn undetermined(quantity: &str, unknowns: usize, known: usize) -> String {
    let unknowns = counted(unknowns, "unknown");
    if known == 0 {
        return format!(
            "the {quantity} has {unknowns}, but all points are missing (NaN): check the source of the data, and provide known points"
        );
    }
    let known = counted(known, "known point");
    format!("the {quantity} has {unknowns}, but there are only {known}: provide more known points")
}

/// Returns the message for an approach that does not determine the pressure.
pub(super) fn beyond_mean_gap(approach: f64, mean_gap: f64) -> String {
    format!(
        "the approach {approach:?} closes the gap of a periodic contact everywhere, so that the pressure is undetermined: prescribe an approach below the mean gap {mean_gap:?}, or a normal force"
    )
}

/// Returns the message for a step that does not continue a cycle, with a remedy.
pub(super) fn out_of_order(step: u64, last: u64) -> String {
    if step == last + 1 {
        format!(
            "step {step} did not start from the state after step {last}, with which the cycle ends: add steps of one history only, and begin the cycle anew after a change of the state"
        )
    } else {
        format!(
            "step {step} of the history does not follow step {last}, the last step of the cycle: add every step of one history once, in order, after it is accepted"
        )
    }
}

/// Returns the message for a cycle that cannot represent the following cycles, with a remedy.
pub(super) fn not_closed(residual: f64, limit: f64) -> String {
    format!(
        "the residual of the cycle (relative to its amplitude) is {residual:?}, but must be at most {limit:?} for a jump: compute another cycle on this gap first, or raise the limit"
    )
}

/// Residual below which a stalled solve is limited by round-off. The smallest residuals of hard problems are larger than 1e-12.
const NEAR_ROUND_OFF: f64 = 1e-9;

/// Returns the message for a solve that has not converged, with a remedy for the status.
pub(super) fn not_converged(report: &Report) -> String {
    let remedy = match report.status {
        Status::Unsolved => ": solve first",
        // The limit of an iteration without an operator is fixed.
        Status::IterationLimit if report.products() > 0 => ": raise the iteration limit",
        Status::TimeLimit => ": raise the time limit",
        Status::Stalled if report.residual <= NEAR_ROUND_OFF => {
            ": the tolerance is below round-off, so set it above these errors (1e-12 or more)"
        }
        _ => "",
    };
    format!("the calculation has not converged: {report}{remedy}")
}
