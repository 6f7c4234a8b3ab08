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

#[cfg(test)]
mod tests {
    use super::examine;
    use crate::cgm::certificate::Certificate;

    /// Cells of the traction (3, 4) and the displacement (1, 2): limit and slip of each.
    fn examined(
        cells: &[(f64, [f64; 2])],
        totals: [Option<f64>; 2],
        lower_bound: f64,
    ) -> Certificate {
        let both = |[x, y]: [f64; 2]| [vec![x; cells.len()], vec![y; cells.len()]].concat();
        let limits: Vec<f64> = cells.iter().map(|(limit, _)| *limit).collect();
        let slip = |i: usize| cells[i].1;
        let (q, u) = (both([3.0, 4.0]), both([1.0, 2.0]));
        examine(&q, &u, slip, &limits, totals, lower_bound)
    }

    fn assert_near(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-13 * b.abs(), "{a} is not {b}");
    }

    /// Slip of length 5/4 along the traction and against it, and one against it and half as much across.
    const ALONG: [f64; 2] = [0.75, 1.0];
    const AGAINST: [f64; 2] = [-0.75, -1.0];
    const ASKEW: [f64; 2] = [-0.25, -1.375];
    const ASKEW_SQUARED: f64 = 1.953125;

    /// What is forbidden of the slip, and by how much the traction could still give way, `g.q + limit |g|`.
    #[test]
    fn each_share_is_its_formula() {
        let askew = ASKEW_SQUARED.sqrt();
        for (limit, slip, forbidden, dual) in [
            (10.0, ALONG, 1.25, 18.75),
            (10.0, [1.5, 2.0], 2.5, 37.5),
            (10.0, AGAINST, 1.25, 6.25),
            (5.0, ALONG, 1.25, 12.5),
            (5.0, AGAINST, 0.0, 0.0),
            (5.0, ASKEW, 0.625, 5.0 * askew - 6.25),
            (10.0, ASKEW, askew, 10.0 * askew - 6.25),
        ] {
            let cell = [(limit, slip)];
            // By the gap, of an energy of 11 and a displacement of the root of 5.
            let found = examined(&cell, [None, None], 1e-3);
            assert_near(found.gap, dual / 11.0);
            assert_near(found.residual, forbidden / 5.0_f64.sqrt());
            assert_eq!(found.free, usize::from(limit > 5.0));
            // By the eigenvalue, which makes 4 * 5 and 4 * 25 of the traction.
            let found = examined(&cell, [None, None], 4.0);
            assert_near(found.gap, (forbidden * forbidden / 4.0).min(dual) / 100.0);
            assert_near(found.residual, forbidden / 20.0);
        }
    }

    #[test]
    fn shares_of_both_kinds_add_up() {
        // The third cell carries nothing, and shows nothing.
        let cells = [(200.0, ALONG), (5.0, ASKEW), (0.0, [1e9; 2])];
        let found = examined(&cells, [Some(7.0), None], 0.1);
        let dual = 5.0 * ASKEW_SQUARED.sqrt() - 6.25;
        let eigen = 15.625_f64;
        let bound = 0.5 * eigen.sqrt() + (0.25 * eigen + dual).sqrt();
        assert_near(found.gap, bound * bound / 22.0);
        assert_near(found.residual, 1.25 / 5.0_f64.sqrt());
        assert_near(found.load_error, 0.1);
        assert_eq!(found.free, 1);
        // The loads of both axes, missed by 3 and by 4.
        let found = examined(&cells, [Some(9.0), Some(12.0)], 0.1);
        assert_near(found.load_error, 0.5);

        // More cells than one task examines.
        let mut cells = vec![(10.0, ALONG); 5000];
        cells[4500..].fill((5.0, ALONG));
        let found = examined(&cells, [Some(15002.0), None], 1e-3);
        assert_near(found.gap, (4500.0 * 18.75 + 500.0 * 12.5) / (5000.0 * 11.0));
        assert_near(found.load_error, 2.0 / 25000.0);
        assert_eq!(found.free, 4500);
    }
}
