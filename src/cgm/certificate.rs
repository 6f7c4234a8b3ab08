//! How far an iterate can be from the minimum, from one product.
//!
//! Let `x` be feasible with gradient `g = C x + b - delta` (the multiplier may be any number when a
//! total is prescribed), `x*` the minimum and `E^2 = (x - x*)' C (x - x*)`. Because the gradient at
//! the minimum has a non-negative product with `x - x*`, and the two gradients differ by
//! `C (x - x*)`,
//!
//! ```math
//! E^2 \le g' (x - x^*) .
//! ```
//!
//! Each entry's share of the right side is bounded in one of two ways: by its duality gap
//! `a_i = g_i x_i - min over y_i of g_i y_i`, or, with a lower bound `lambda` of the eigenvalues of
//! `C`, through `sum r_i (x - x*)_i <= |r| E / sqrt(lambda)`, where `r_i` is the part of `g_i` that
//! complementarity does not allow. With `A` the sum of the first and `B = |r| / sqrt(lambda)`,
//! `E^2 <= A + B E`, hence
//!
//! ```math
//! E \le B/2 + \sqrt{B^2/4 + A} .
//! ```
//!
//! A total missed by round-off is reported by itself: `x*` is the minimum of the total `x` has.
//!
//! The first is the Frank-Wolfe gap (<https://doi.org/10.1002/nav.3800030109>), of first order in
//! the residual; the second is of second order.

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
        let violated = violation(x[i], bounds, gradient(i));
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

/// `a / b`, zero when `a` is.
fn ratio(a: f64, b: f64) -> f64 {
    if a == 0.0 { 0.0 } else { a / b.max(0.0) }
}
