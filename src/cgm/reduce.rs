//! Every global sum and maximum of the engine: the one place a distributed grid would change.
//!
//! Sums follow a fixed tree of chunks, so that their bits do not depend on the number of threads.

use crate::parallel;
pub(super) use crate::parallel::sums;

/// The sum of a slice.
pub(crate) fn total(values: &[f64]) -> f64 {
    parallel::fold(values.len(), |range| in_lanes(&values[range]), |a, b| a + b)
}

/// The sum of a chunk, in lanes so that additions overlap.
pub(super) fn in_lanes(values: &[f64]) -> f64 {
    let mut lanes = [0.0; 8];
    let groups = values.chunks_exact(8);
    let rest: f64 = groups.remainder().iter().sum();
    for group in groups {
        for (lane, value) in lanes.iter_mut().zip(group) {
            *lane += value;
        }
    }
    lanes.iter().sum::<f64>() + rest
}

/// `sum f(i)` over `0..len`.
pub(super) fn sum(len: usize, f: impl Fn(usize) -> f64 + Sync) -> f64 {
    parallel::fold(len, |range| range.map(&f).sum::<f64>(), |a, b| a + b)
}

/// `max f(i)` over `0..len` of non-negative quantities; NaN wins, so that it is seen.
pub(super) fn max<const K: usize>(len: usize, f: impl Fn(usize) -> [f64; K] + Sync) -> [f64; K] {
    let larger = |mut a: [f64; K], b: [f64; K]| {
        for (a, b) in a.iter_mut().zip(b) {
            if b > *a || b.is_nan() {
                *a = b;
            }
        }
        a
    };
    parallel::fold(len, |range| range.map(&f).fold([0.0; K], larger), larger)
}

/// Index of the least `f(i)` among the entries where it is given, the first of equals.
pub(super) fn least(len: usize, f: impl Fn(usize) -> Option<f64> + Sync) -> Option<(usize, f64)> {
    let lesser = |a: Option<(usize, f64)>, b: Option<(usize, f64)>| match (a, b) {
        (Some(a), Some(b)) => Some(if b.1 < a.1 { b } else { a }),
        (a, b) => a.or(b),
    };
    parallel::fold(
        len,
        |range| {
            range
                .map(|i| f(i).map(|value| (i, value)))
                .fold(None, lesser)
        },
        lesser,
    )
}
