//! How far an iterate of the plane can be from the minimum.

use std::ops::Range;

use crate::cgm::certificate::Certificate;
use crate::cgm::plane::disc::{Disc, at, dot, norm};
use crate::parallel;

/// What a cell, or several, have to say.
#[derive(Clone, Copy, Default)]
struct Findings {
    /// Largest squares: of displacement, forbidden slip, traction.
    largest: [f64; 3],
    /// `q' C q`, `q' q`, `q_x`, `q_y`, `|q|`, and the two shares of the bound.
    sums: [f64; 7],
    /// Cells within their limits.
    free: usize,
}

impl Findings {
    /// Takes note of a cell with a limit, displacement `u` and slip `g`; `stiffness` is one over the bound of
    /// the operator.
    #[inline]
    fn add(&mut self, q: [f64; 2], limit: f64, u: [f64; 2], g: [f64; 2], stiffness: f64) {
        let (square, size, slip) = (dot(q, q), norm(q), norm(g));
        let (along, across) = (dot(g, q), g[0] * q[1] - g[1] * q[0]);
        let is_free = !Disc(limit).is_at_limit(q);
        let is_against = along < 0.0;
        // What complementarity forbids of the slip: all of it within the limit, at the limit what is not against
        // the traction.
        let forbidden = if is_against && !is_free {
            across * across / square
        } else {
            dot(g, g)
        };
        // `g.q + limit |g|`, what the traction could still give way to the slip: with all its digits where the
        // two are opposite, as in every slipping cell.
        let turned = if is_against {
            across * across / (slip * size - along)
        } else {
            slip * size + along
        };
        let dual = slip * (limit - size).max(0.0) + turned;
        // Either share is valid; each is taken where it is the smaller.
        let eigen = forbidden * stiffness;
        let shares = if forbidden == 0.0 {
            [0.0, 0.0]
        } else if dual <= eigen {
            [dual, 0.0]
        } else {
            [0.0, eigen]
        };
        self.raise([dot(u, u), forbidden, square]);
        let terms = [dot(q, u), square, q[0], q[1], size, shares[0], shares[1]];
        for (sum, term) in self.sums.iter_mut().zip(terms) {
            *sum += term;
        }
        self.free += usize::from(is_free);
    }

    /// NaN wins, so that it is seen.
    fn raise(&mut self, values: [f64; 3]) {
        for (largest, value) in self.largest.iter_mut().zip(values) {
            if value > *largest || value.is_nan() {
                *largest = value;
            }
        }
    }

    fn and(mut self, other: Self) -> Self {
        self.raise(other.largest);
        for (a, b) in self.sums.iter_mut().zip(other.sums) {
            *a += b;
        }
        self.free += other.free;
        self
    }
}

/// Examines a feasible `q` with its fresh product `C q` and its slip `g = C q + b - delta`.
pub(crate) fn examine(
    q: &[f64],
    product: &[f64],
    slip: impl Fn(usize) -> [f64; 2] + Sync,
    limits: &[f64],
    totals: [Option<f64>; 2],
    lower_bound: f64,
) -> Certificate {
    let leaf = |range: Range<usize>| {
        let mut findings = Findings::default();
        for i in range.filter(|&i| limits[i] > 0.0) {
            let (q, u) = (at(q, i), at(product, i));
            findings.add(q, limits[i], u, slip(i), 1.0 / lower_bound);
        }
        findings
    };
    let Findings {
        largest,
        sums: [energy, squares, x, y, magnitude, dual, square],
        free,
    } = parallel::fold(limits.len(), leaf, Findings::and);
    let missing = |axis: usize, sum: f64| totals[axis].map_or(0.0, |total| total - sum);
    let bound = 0.5 * square.sqrt() + (0.25 * square + dual).sqrt();
    Certificate::new(
        largest.map(f64::sqrt),
        [energy, squares, magnitude],
        bound,
        norm([missing(0, x), missing(1, y)]),
        lower_bound,
        free,
    )
}
