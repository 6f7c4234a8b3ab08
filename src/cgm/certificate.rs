//! How far an iterate can be from the minimum, from one product.
//!
//! The page of the module [`cgm`](crate::cgm) derives the bound.

use crate::cgm::constraint::Constraint;
use crate::cgm::reduce;
use crate::report::Report;

/// What one fresh product says about an iterate.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Certificate {
    /// Largest complementarity residual over the largest displacement.
    pub(super) residual: f64,
    /// Bound on `E^2 / (x' C x)`.
    pub(super) gap: f64,
    /// `|sum x - total| / sum |x|`.
    pub(super) load_error: f64,
    /// Entries strictly between their bounds.
    pub(super) free: usize,
}

impl Certificate {
    pub(crate) fn write_to(&self, report: &mut Report) {
        report.residual = self.residual;
        report.certified_gap = self.gap;
        report.load_error = self.load_error;
    }
}

/// The part of a gradient that complementarity forbids at this value.
pub(super) fn violation(value: f64, [lower, upper]: [f64; 2], gradient: f64) -> f64 {
    if lower >= upper {
        0.0
    } else if value <= lower {
        gradient.min(0.0)
    } else if value >= upper {
        gradient.max(0.0)
    } else {
        gradient
    }
}

/// Examines a feasible `x` with its fresh product `C x`.
pub(crate) fn examine(
    x: &[f64],
    product: &[f64],
    linear: &[f64],
    constraint: &impl Constraint,
    total: Option<f64>,
    multiplier: f64,
    lower_bound: f64,
) -> Certificate {
    let gradient = |i: usize| product[i] + linear[i] - multiplier;
    let [displacement, violated] = reduce::max(x.len(), |i| {
        let bounds = constraint.bounds(i);
        if bounds[0] >= bounds[1] {
            return [0.0, 0.0];
        }
        let g = gradient(i);
        // The minimum or maximum of a NaN and a number is the number: pass it on by hand.
        let violated = if g.is_nan() {
            g
        } else {
            violation(x[i], bounds, g)
        };
        [product[i].abs(), violated.abs()]
    });
    let [energy, sum, magnitude, free, linear_share, squares] = reduce::sums(x.len(), |i| {
        let bounds = constraint.bounds(i);
        let g = gradient(i);
        let dual = g * x[i] - constraint.least_product(i, g);
        let violated = violation(x[i], bounds, g);
        let square = violated * violated / lower_bound;
        // Either share is valid; alone, `dual` costs itself and `square` costs itself.
        let (dual, square) = if dual <= square || violated == 0.0 {
            (dual.max(0.0), 0.0)
        } else {
            (0.0, square)
        };
        let is_free = x[i] > bounds[0] && x[i] < bounds[1];
        [
            x[i] * product[i],
            x[i],
            x[i].abs(),
            f64::from(u8::from(is_free)),
            dual,
            square,
        ]
    });
    let load = total.map_or(0.0, |total| (sum - total).abs());
    let bound = 0.5 * squares.sqrt() + (0.25 * squares + linear_share).sqrt();
    Certificate {
        residual: ratio(violated, displacement),
        gap: ratio(bound * bound, energy),
        load_error: ratio(load, magnitude),
        free: count(free),
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a sum of ones is a whole number that fits"
)]
fn count(sum_of_ones: f64) -> usize {
    sum_of_ones as usize
}

/// `a / b`, zero when `a` is; NaN if either is, so that a broken product is seen.
fn ratio(a: f64, b: f64) -> f64 {
    if a == 0.0 && !b.is_nan() {
        0.0
    } else if b < 0.0 {
        f64::INFINITY
    } else {
        a / b
    }
}
