//! The prescribed total.

use crate::cgm::constraint::Constraint;
use crate::cgm::reduce;
use crate::error::{Error, Result};
use crate::parallel;

/// Where a prescribed total lies between the least and the greatest the bounds allow.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Reach {
    /// Strictly between: a minimum with a multiplier exists.
    Inside,
    /// All entries at their lower bounds.
    AtLower,
    /// All entries at their upper bounds.
    AtUpper,
}

/// Relative distance from an extreme total that still counts as the extreme.
const EDGE: f64 = 1e-12;

/// Finds where the total lies, or refuses it.
pub(super) fn reach(len: usize, constraint: &impl Constraint, total: f64) -> Result<Reach> {
    let [lower, upper, lower_size, upper_size] = reduce::sums(len, |i| {
        let [lower, upper] = constraint.bounds(i);
        [lower, upper, lower.abs(), upper.abs()]
    });
    // Round-off of either sum; an infinite side is never reached.
    let edge = |size: f64| if size.is_finite() { EDGE * size } else { 0.0 };
    let (low_edge, high_edge) = (edge(lower_size), edge(upper_size));
    if !total.is_finite() || total < lower - low_edge || total > upper + high_edge {
        Err(Error::Total {
            total,
            lower,
            upper,
        })
    } else if total <= lower + low_edge {
        Ok(Reach::AtLower)
    } else if total >= upper - high_edge {
        Ok(Reach::AtUpper)
    } else {
        Ok(Reach::Inside)
    }
}

/// Moves the selected entries to the nearest point within their bounds that gives the total:
/// `x_i = P_i(x_i + t)`, with one `t` for all. Returns whether the total was reached.
pub(super) fn restore(
    x: &mut [f64],
    constraint: &impl Constraint,
    selected: impl Fn(usize) -> bool + Sync,
    total: f64,
) -> bool {
    // A `t` far larger than what it leaves rounds that off; from there the next one is small.
    (0..2).any(|_| shift(x, constraint, &selected, total))
}

/// One move. The sum grows with `t` piecewise linearly, so Newton's method between brackets ends in a
/// few passes.
fn shift(
    x: &mut [f64],
    constraint: &impl Constraint,
    selected: impl Fn(usize) -> bool + Sync,
    total: f64,
) -> bool {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut shift = 0.0;
    for _ in 0..200 {
        let [sum, moving, magnitude, may_rise, may_fall] = reduce::sums(x.len(), |i| {
            if !selected(i) {
                return [x[i], 0.0, x[i].abs(), 0.0, 0.0];
            }
            let value = constraint.project(i, x[i] + shift);
            let [lower, upper] = constraint.bounds(i);
            let one_if = |condition: bool| f64::from(u8::from(condition));
            let is_moving = value > lower && value < upper;
            let (rises, falls) = (one_if(value < upper), one_if(value > lower));
            [value, one_if(is_moving), value.abs(), rises, falls]
        });
        let missing = total - sum;
        let has_room = if missing > 0.0 { may_rise } else { may_fall };
        if missing.abs() <= 1e-14 * magnitude || has_room == 0.0 {
            break;
        }
        if missing > 0.0 {
            low = shift;
        } else {
            high = shift;
        }
        let newton = shift + missing / moving;
        let next = if newton > low && newton < high {
            newton
        } else if low.is_finite() && high.is_finite() {
            0.5 * (low + high)
        } else {
            // Nothing moves and one side is open: step out until something does.
            let step = magnitude.max(missing.abs()).max(shift.abs());
            shift + step.copysign(missing)
        };
        if !next.is_finite() || (next - shift).abs() <= f64::EPSILON * shift.abs() {
            break;
        }
        shift = next;
    }
    parallel::update(x, |first, chunk| {
        for (i, value) in (first..).zip(chunk) {
            if selected(i) {
                *value = constraint.project(i, *value + shift);
            }
        }
    });
    let [sum, magnitude] = reduce::sums(x.len(), |i| [x[i], x[i].abs()]);
    (total - sum).abs() <= 1e-12 * magnitude
}
