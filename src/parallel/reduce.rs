//! Reductions over cells: sums, maxima and searches.
//!
//! Sums follow the tree of a [`Layout`]. They are therefore bitwise identical for any number of threads and ranks.

use std::array::from_fn;
use std::collections::VecDeque;
use std::ops::Range;

use crate::parallel::layout::Layout;
use crate::parallel::ranks::WireFormat;

/// Quantities that can be added: numbers, and arrays and tuples of them.
pub(crate) trait Reduction: WireFormat {
    fn plus(self, other: Self) -> Self;
}

impl Reduction for () {
    fn plus(self, (): Self) -> Self {}
}

impl Reduction for f64 {
    #[inline]
    fn plus(self, other: Self) -> Self {
        self + other
    }
}

impl Reduction for usize {
    fn plus(self, other: Self) -> Self {
        self + other
    }
}

impl<T: Reduction, const K: usize> Reduction for [T; K] {
    #[inline]
    fn plus(mut self, other: Self) -> Self {
        for (a, b) in self.iter_mut().zip(other) {
            *a = a.plus(b);
        }
        self
    }
}

/// Implements [`Reduction`] for a tuple, component by component.
macro_rules! tally_of_tuple {
    ($($part:ident $place:tt),+) => {
        impl<$($part: Reduction),+> Reduction for ($($part,)+) {
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

/// Sums the results of the chunks.
pub(crate) fn over_chunks<T: Reduction>(
    layout: &Layout,
    leaf: impl Fn(Range<usize>) -> T + Sync,
) -> T {
    layout.fold(leaf, T::plus)
}

/// Returns the sum of a slice.
pub(crate) fn total(layout: &Layout, values: &[f64]) -> f64 {
    over_chunks(layout, |range| in_lanes(&values[range]))
}

/// Returns the sum of `f(i)` over the cells, bitwise identical to the sum of the slice of these values.
pub(crate) fn total_of(layout: &Layout, f: impl Fn(usize) -> f64 + Sync) -> f64 {
    over_chunks(layout, |range| {
        let mut lanes = [0.0; 8];
        let whole = range.start + range.len() / 8 * 8;
        for i in range.start..whole {
            lanes[(i - range.start) % 8] += f(i);
        }
        let rest: f64 = (whole..range.end).map(&f).sum();
        lanes.iter().sum::<f64>() + rest
    })
}

/// Returns the sum of a chunk, in lanes so that additions overlap.
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

/// Returns `sum f(i)` over the cells.
pub(crate) fn sum<T: Reduction>(layout: &Layout, f: impl Fn(usize) -> T + Sync) -> T {
    over_chunks(layout, |range| range.map(&f).fold(T::ZERO, T::plus))
}

/// Returns sums by groups, `sum f(i).1` over the cells with `f(i).0 = group`, for groups from zero to `count`. Neighbouring cells
/// should belong to groups with similar numbers.
pub(crate) fn grouped<T: Reduction>(
    layout: &Layout,
    count: usize,
    f: impl Fn(usize) -> Option<(usize, T)> + Sync,
) -> Vec<T> {
    /// Number of sums in one reduction over the ranks.
    const AT_ONCE: usize = 64;
    let leaf = |cells: Range<usize>| {
        let values = cells.filter_map(&f);
        values.fold(Groups::default(), Groups::with)
    };
    let nodes = layout.at_nodes(leaf, |low, high: Groups<T>| {
        (high.first..).zip(high.sums).fold(low, Groups::with)
    });
    let mut sums = Vec::new();
    for first in (0..count).step_by(AT_ONCE) {
        let own = nodes.iter().map(|node| from_fn(|k| node.get(first + k)));
        sums.extend(layout.finished(own, <[T; AT_ONCE]>::plus));
    }
    sums.truncate(count);
    sums
}

/// Sums of the groups from the first to the last group with a value.
struct Groups<T> {
    first: usize,
    sums: VecDeque<T>,
}

impl<T> Default for Groups<T> {
    fn default() -> Self {
        let sums = VecDeque::new();
        Self { first: 0, sums }
    }
}

impl<T: Reduction> Groups<T> {
    fn with(mut self, (group, value): (usize, T)) -> Self {
        if self.sums.is_empty() {
            self.first = group;
        }
        while group < self.first {
            self.sums.push_front(T::ZERO);
            self.first -= 1;
        }
        let place = group - self.first;
        if self.sums.len() <= place {
            self.sums.resize(place + 1, T::ZERO);
        }
        self.sums[place] = self.sums[place].plus(value);
        self
    }

    fn get(&self, group: usize) -> T {
        let place = group.checked_sub(self.first);
        let sum = place.and_then(|place| self.sums.get(place));
        sum.copied().unwrap_or(T::ZERO)
    }
}

/// Returns the larger of two numbers, or NaN if either is NaN.
#[inline]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// Returns `max f(i)` over the cells for non-negative quantities. NaN propagates, so that it is detected.
pub(crate) fn max(layout: &Layout, f: impl Fn(usize) -> f64 + Sync) -> f64 {
    layout.fold(|range| range.map(&f).fold(0.0, larger), larger)
}

/// Returns the least of the values `f(i)` that are `Some`, with the other value that `f` returns for its cell. If several values
/// are equal, returns the first.
pub(crate) fn least<T: WireFormat>(
    layout: &Layout,
    f: impl Fn(usize) -> Option<(f64, T)> + Sync,
) -> Option<(f64, T)> {
    let lesser = |a: Option<(f64, T)>, b: Option<(f64, T)>| match (a, b) {
        (Some(a), Some(b)) => Some(if b.0 < a.0 { b } else { a }),
        (a, b) => a.or(b),
    };
    layout.fold(|range| range.map(&f).fold(None, lesser), lesser)
}

/// Returns the first of the values `f(i)` that is `Some`.
pub(crate) fn first<T: WireFormat>(
    layout: &Layout,
    f: impl Fn(usize) -> Option<T> + Sync,
) -> Option<T> {
    layout.fold(|mut range| range.find_map(&f), Option::or)
}

/// Returns whether a condition holds in any cell.
pub(crate) fn any(layout: &Layout, holds: impl Fn(usize) -> bool + Sync) -> bool {
    layout.fold(|mut range| range.any(&holds), |a, b| a || b)
}

/// Combines any other quantity of chunks pairwise in the tree.
pub(crate) fn fold<T: WireFormat>(
    layout: &Layout,
    leaf: impl Fn(Range<usize>) -> T + Sync,
    combine: impl Fn(T, T) -> T + Sync,
) -> T {
    layout.fold(leaf, combine)
}
