//! Every global sum, maximum and search of the engine: the one place a distributed grid would change.
//!
//! Sums follow a fixed tree of chunks, so that their bits do not depend on the number of threads.

use std::ops::Range;

use crate::parallel;
pub(crate) use crate::parallel::sums;

/// Quantities that add up: numbers, and arrays and tuples of them.
pub(crate) trait Tally: Copy + Send {
    const ZERO: Self;

    fn plus(self, other: Self) -> Self;
}

impl Tally for () {
    const ZERO: Self = ();

    fn plus(self, (): Self) -> Self {}
}

impl Tally for f64 {
    const ZERO: Self = 0.0;

    #[inline]
    fn plus(self, other: Self) -> Self {
        self + other
    }
}

impl Tally for usize {
    const ZERO: Self = 0;

    fn plus(self, other: Self) -> Self {
        self + other
    }
}

impl<T: Tally, const K: usize> Tally for [T; K] {
    const ZERO: Self = [T::ZERO; K];

    #[inline]
    fn plus(mut self, other: Self) -> Self {
        for (a, b) in self.iter_mut().zip(other) {
            *a = a.plus(b);
        }
        self
    }
}

/// A tuple adds up part by part.
macro_rules! tally_of_tuple {
    ($($part:ident $place:tt),+) => {
        impl<$($part: Tally),+> Tally for ($($part,)+) {
            const ZERO: Self = ($($part::ZERO,)+);

            #[inline]
            fn plus(self, other: Self) -> Self {
                ($(self.$place.plus(other.$place),)+)
            }
        }
    };
}

tally_of_tuple!(A 0, B 1);
tally_of_tuple!(A 0, B 1, C 2);
tally_of_tuple!(A 0, B 1, C 2, D 3);

/// What the chunks of `0..len` add up to.
pub(crate) fn over_chunks<T: Tally>(len: usize, leaf: impl Fn(Range<usize>) -> T + Sync) -> T {
    parallel::fold(len, leaf, T::plus)
}

/// The sum of a slice.
pub(crate) fn total(values: &[f64]) -> f64 {
    over_chunks(values.len(), |range| in_lanes(&values[range]))
}

/// The sum of `f(i)` over `0..len`, bit for bit that of the slice of these values.
pub(crate) fn total_of(len: usize, f: impl Fn(usize) -> f64 + Sync) -> f64 {
    over_chunks(len, |range| {
        let mut lanes = [0.0; 8];
        let whole = range.start + range.len() / 8 * 8;
        for i in range.start..whole {
            lanes[(i - range.start) % 8] += f(i);
        }
        let rest: f64 = (whole..range.end).map(&f).sum();
        lanes.iter().sum::<f64>() + rest
    })
}

/// The sum of a chunk, in lanes so that additions overlap.
pub(crate) fn in_lanes(values: &[f64]) -> f64 {
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
pub(crate) fn sum<T: Tally>(len: usize, f: impl Fn(usize) -> T + Sync) -> T {
    over_chunks(len, |range| range.map(&f).fold(T::ZERO, T::plus))
}

/// The larger of two numbers; NaN if either is.
#[inline]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// `max f(i)` over `0..len` of non-negative quantities; NaN wins, so that it is seen.
pub(crate) fn max(len: usize, f: impl Fn(usize) -> f64 + Sync) -> f64 {
    parallel::fold(len, |range| range.map(&f).fold(0.0, larger), larger)
}

/// Index of the least `f(i)` among the entries where it is given, the first of equals.
pub(crate) fn least(len: usize, f: impl Fn(usize) -> Option<f64> + Sync) -> Option<(usize, f64)> {
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

/// The first index where a condition holds.
pub(crate) fn first(len: usize, holds: impl Fn(usize) -> bool + Sync) -> Option<usize> {
    parallel::fold(len, |mut range| range.find(|&i| holds(i)), Option::or)
}

/// Any other quantity of chunks, combined pairwise in the fixed tree.
pub(crate) fn fold<T: Send>(
    len: usize,
    leaf: impl Fn(Range<usize>) -> T + Sync,
    combine: impl Fn(T, T) -> T + Sync,
) -> T {
    parallel::fold(len, leaf, combine)
}
