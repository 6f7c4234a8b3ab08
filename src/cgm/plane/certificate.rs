//! How far an iterate of the plane can be from the minimum.

use crate::cgm::certificate::Certificate;
use crate::cgm::plane::disc::{Disc, at, dot, norm};
use crate::cgm::reduce;

/// The part of a slip that complementarity forbids at this traction: all of it within the limit; at the limit
/// what is not against the traction.
pub(super) fn violation(q: [f64; 2], limit: f64, g: [f64; 2]) -> [f64; 2] {
    if limit <= 0.0 {
        return [0.0; 2];
    }
    let size = norm(q);
    if Disc(limit).is_at_limit(q) && size > 0.0 {
        let n = q.map(|q| q / size);
        let against = (-dot(g, n)).max(0.0);
        [g[0] + against * n[0], g[1] + against * n[1]]
    } else {
        g
    }
}

/// `g.q + limit |g|`, what the traction could still give way to a slip; never negative, and with all its digits
/// where the two are opposite, as in every slipping cell.
fn duality_gap(q: [f64; 2], limit: f64, g: [f64; 2]) -> f64 {
    let (size, along) = (norm(g) * norm(q), dot(g, q));
    let turned = if along < 0.0 {
        let across = g[0] * q[1] - g[1] * q[0];
        across * across / (size - along)
    } else {
        size + along
    };
    norm(g) * (limit - norm(q)).max(0.0) + turned
}

/// Examines a feasible `q` with its fresh product `C q` and its slip `g = C q + b - delta`.
pub(super) fn examine(
    q: &[f64],
    product: &[f64],
    slip: impl Fn(usize) -> [f64; 2] + Sync,
    limits: &[f64],
    totals: [Option<f64>; 2],
    lower_bound: f64,
) -> Certificate {
    let [displacement, violated, largest] = reduce::max(limits.len(), |i| {
        if limits[i] > 0.0 {
            let q = at(q, i);
            let violated = violation(q, limits[i], slip(i));
            [norm(at(product, i)), norm(violated), norm(q)]
        } else {
            [0.0; 3]
        }
    });
    let [energy, squares, x, y, magnitude, dual, square] = reduce::sums(limits.len(), |i| {
        let (q, g) = (at(q, i), slip(i));
        let limit = limits[i];
        if limit <= 0.0 {
            return [0.0; 7];
        }
        let violated = violation(q, limit, g);
        // Either share is valid; each is taken where it is the smaller.
        let dual = duality_gap(q, limit, g);
        let square = dot(violated, violated) / lower_bound;
        let is_zero = violated.iter().all(|&g| g == 0.0);
        let (dual, square) = match dual <= square {
            _ if is_zero => (0.0, 0.0),
            true => (dual, 0.0),
            false => (0.0, square),
        };
        [
            dot(q, at(product, i)),
            dot(q, q),
            q[0],
            q[1],
            norm(q),
            dual,
            square,
        ]
    });
    let is_free = |i: usize| limits[i] > 0.0 && !Disc(limits[i]).is_at_limit(at(q, i));
    let missing = |axis: usize, sum: f64| totals[axis].map_or(0.0, |total| total - sum);
    let bound = 0.5 * square.sqrt() + (0.25 * square + dual).sqrt();
    Certificate::new(
        [displacement, violated, largest],
        [energy, squares, magnitude],
        bound,
        norm([missing(0, x), missing(1, y)]),
        lower_bound,
        reduce::count(limits.len(), is_free),
    )
}
