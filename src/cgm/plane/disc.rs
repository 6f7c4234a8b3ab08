//! Discs of tractions: the nearest point, and the nearest points of given sums.

use std::ops::Range;

use crate::cgm::reduce;
use crate::error::{Error, Result};
use crate::parallel::{self, Blocks, CHUNK, blocks};

/// The tractions a cell can carry: `|q| <= limit`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Disc(pub(crate) f64);

/// Relative distance from the circle within which a traction is on it.
const RIM: f64 = 1e-12;

impl Disc {
    /// The nearest traction of the disc.
    pub(crate) fn project(self, q: [f64; 2]) -> [f64; 2] {
        let size = norm(q);
        if size > self.0 {
            q.map(|q| q * (self.0 / size))
        } else {
            q
        }
    }

    /// Whether a traction is at the limit.
    pub(crate) fn is_at_limit(self, q: [f64; 2]) -> bool {
        norm(q) >= self.0 * (1.0 - RIM)
    }
}

/// Length of a vector; infinite of one beyond 1e150, whose square overflows, and zero below 1e-160.
pub(crate) fn norm(v: [f64; 2]) -> f64 {
    dot(v, v).sqrt()
}

pub(crate) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The two components of a cell.
pub(super) fn at(vector: &[f64], i: usize) -> [f64; 2] {
    [vector[i], vector[vector.len() / 2 + i]]
}

/// The two components of the cells of a chunk, by their place in it.
pub(super) fn pair<'a>(
    vector: &'a [f64],
    chunk: &Range<usize>,
) -> impl Fn(usize) -> [f64; 2] + use<'a> {
    let (x, y) = vector.split_at(vector.len() / 2);
    let (x, y) = (&x[chunk.clone()], &y[chunk.clone()]);
    move |place| [x[place], y[place]]
}

/// Both components of a vector.
pub(crate) fn both(vector: &[f64]) -> [&[f64]; 2] {
    vector.split_at(vector.len() / 2).into()
}

/// Both components of a vector to write to.
pub(super) fn both_mut(vector: &mut [f64]) -> [&mut [f64]; 2] {
    vector.split_at_mut(vector.len() / 2).into()
}

/// Both components of a vector to write to, chunk by chunk.
pub(super) type Halves<'a> = (Blocks<'a, f64>, Blocks<'a, f64>);

pub(super) fn halves(vector: &mut [f64]) -> Halves<'_> {
    let (x, y) = vector.split_at_mut(vector.len() / 2);
    (blocks(x), blocks(y))
}

/// Replaces the components of every cell.
pub(crate) fn update_cells(vector: &mut [f64], f: impl Fn(usize, [f64; 2]) -> [f64; 2] + Sync) {
    let tasks = (vector.len() / 2).div_ceil(CHUNK);
    let work = |task: usize, (x, y): Halves<'_>| {
        let cells = x.items.iter_mut().zip(y.items);
        for (i, (x, y)) in (task * CHUNK..).zip(cells) {
            [*x, *y] = f(i, [*x, *y]);
        }
    };
    parallel::sweep(0..tasks, halves(vector), &work, &|(), ()| ());
}

/// Where prescribed totals lie in what the discs allow together.
pub(super) enum Reach {
    Inside,
    /// All cells at their limits, along this direction.
    AtLimit([f64; 2]),
}

/// Relative distance from the limit that still counts as the limit.
const EDGE: f64 = 1e-12;

/// Finds where the totals lie, or refuses them; `limit` is the sum of all limits.
pub(super) fn reach(totals: [Option<f64>; 2], limit: f64) -> Result<Reach> {
    let total = totals.map(|total| total.unwrap_or(0.0));
    let size = norm(total);
    if size.is_nan() || size > limit * (1.0 + EDGE) {
        return Err(Error::BeyondSliding { force: size, limit });
    }
    Ok(if size > 0.0 && size >= limit * (1.0 - EDGE) {
        Reach::AtLimit(total.map(|total| total / size))
    } else {
        Reach::Inside
    })
}

/// Moves every cell to the nearest traction within its disc that gives the totals:
/// `q_i = P_i(q_i + t)`, with one `t` for all.
///
/// The totals are the gradient of a convex function of `t`: Newton's method, damped.
pub(super) fn restore(q: &mut [f64], limits: &[f64], totals: [Option<f64>; 2]) {
    if totals == [None, None] {
        update_cells(q, |i, q| Disc(limits[i]).project(q));
        return;
    }
    let miss = |t: [f64; 2]| -> ([f64; 2], [f64; 3], f64) {
        let old = &*q;
        let [x, y, xx, yy, xy, size] = reduce::sums(limits.len(), |i| {
            let [x, y] = at(old, i);
            let moved = [x + t[0], y + t[1]];
            let (limit, length) = (limits[i], norm(moved));
            let [px, py] = Disc(limit).project(moved);
            // The derivative of the projection: along the circle, shrunk, once outside.
            let [xx, yy, xy] = if limit <= 0.0 {
                [0.0; 3]
            } else if length > limit {
                let [nx, ny] = moved.map(|q| q / length);
                let shrunk = limit / length;
                [ny * ny * shrunk, nx * nx * shrunk, -nx * ny * shrunk]
            } else {
                [1.0, 1.0, 0.0]
            };
            [px, py, xx, yy, xy, norm([px, py])]
        });
        let missing = |axis: usize, sum: f64| totals[axis].map_or(0.0, |total| total - sum);
        ([missing(0, x), missing(1, y)], [xx, yy, xy], size)
    };
    let mut t = [0.0; 2];
    let (mut missing, mut slope, mut size) = miss(t);
    for _ in 0..100 {
        if norm(missing) <= 1e-14 * size {
            break;
        }
        let step = newton_step(slope, missing, totals);
        let mut part = 1.0;
        loop {
            let next = [t[0] + part * step[0], t[1] + part * step[1]];
            let found = miss(next);
            if norm(found.0) < norm(missing) {
                t = next;
                (missing, slope, size) = found;
                break;
            }
            part *= 0.5;
            if part < 1e-9 {
                break;
            }
        }
        if part < 1e-9 {
            break;
        }
    }
    update_cells(q, |i, [x, y]| Disc(limits[i]).project([x + t[0], y + t[1]]));
}

/// Solves for the components whose total is prescribed.
fn newton_step([xx, yy, xy]: [f64; 3], missing: [f64; 2], totals: [Option<f64>; 2]) -> [f64; 2] {
    let floor = f64::EPSILON * (xx + yy);
    match totals {
        [Some(_), Some(_)] => {
            let determinant = xx * yy - xy * xy;
            if determinant > floor * (xx + yy) {
                [
                    (yy * missing[0] - xy * missing[1]) / determinant,
                    (xx * missing[1] - xy * missing[0]) / determinant,
                ]
            } else {
                missing.map(|missing| missing / (xx + yy).max(f64::MIN_POSITIVE))
            }
        }
        [Some(_), None] => [missing[0] / xx.max(floor), 0.0],
        _ => [0.0, missing[1] / yy.max(floor)],
    }
}
