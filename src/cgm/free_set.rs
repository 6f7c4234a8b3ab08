//! The free entries as a list, so that vector work costs what they are and not what the grid is.

use crate::cgm::State;
use crate::parallel::{self, Blocks, CHUNK, Ragged, blocks};

/// Where the free entries stand, chunk by chunk of the grid.
///
/// A compressed vector holds their values in order; chunk `t` of the grid owns the range
/// `starts[t]..starts[t + 1]` of it, and the entries there lie `offsets` from the chunk's first.
#[derive(Debug)]
pub(super) struct FreeSet {
    offsets: Vec<u16>,
    starts: Vec<usize>,
}

/// One chunk: its index and the offsets of its free entries.
type Chunk<'a> = (usize, &'a [u16]);

impl FreeSet {
    pub(super) fn with_capacity(len: usize) -> Self {
        Self {
            offsets: Vec::with_capacity(len),
            starts: Vec::with_capacity(len.div_ceil(CHUNK) + 1),
        }
    }

    /// Lists the entries now free.
    pub(super) fn update(&mut self, state: &[State]) {
        self.offsets.clear();
        self.starts.clear();
        self.starts.push(0);
        for chunk in state.chunks(CHUNK) {
            // A chunk has fewer entries than a u16 has values.
            for (offset, state) in (0_u16..).zip(chunk) {
                if *state == State::Free {
                    self.offsets.push(offset);
                }
            }
            self.starts.push(self.offsets.len());
        }
    }

    /// Free entries.
    pub(super) fn len(&self) -> usize {
        self.offsets.len()
    }

    fn chunks(&self) -> usize {
        self.starts.len() - 1
    }

    fn chunk(&self, index: usize) -> Chunk<'_> {
        (
            index * CHUNK,
            &self.offsets[self.starts[index]..self.starts[index + 1]],
        )
    }

    fn range(&self, index: usize) -> std::ops::Range<usize> {
        self.starts[index]..self.starts[index + 1]
    }

    fn ragged<'a>(&'a self, items: &'a mut [f64]) -> Ragged<'a, f64> {
        Ragged {
            items: &mut items[..self.offsets.len()],
            starts: &self.starts,
        }
    }

    /// Writes a compressed vector to its places in a full one.
    pub(super) fn scatter(&self, value: impl Fn(usize) -> f64 + Sync, full: &mut [f64]) {
        self.visit(|k, item| *item = value(k), full);
    }

    /// Adds a compressed vector to its places in a full one.
    pub(super) fn add(&self, value: impl Fn(usize) -> f64 + Sync, full: &mut [f64]) {
        self.visit(|k, item| *item += value(k), full);
    }

    fn visit(&self, f: impl Fn(usize, &mut f64) + Sync, full: &mut [f64]) {
        let work = |task: usize, full: Blocks<'_, f64>| {
            let (_, offsets) = self.chunk(task);
            for (k, &offset) in self.range(task).zip(offsets) {
                f(k, &mut full.items[usize::from(offset)]);
            }
        };
        parallel::sweep(0..self.chunks(), blocks(full), &work, &|(), ()| ());
    }

    /// `sums of f(k, i)` over the free entries: `k` in the compressed vectors, `i` in the full ones.
    pub(super) fn sums<const K: usize>(
        &self,
        f: impl Fn(usize, usize) -> [f64; K] + Sync,
    ) -> [f64; K] {
        let work = |task: usize, ()| {
            let (first, offsets) = self.chunk(task);
            let mut sum = [0.0; K];
            for (k, &offset) in self.range(task).zip(offsets) {
                add(&mut sum, f(k, first + usize::from(offset)));
            }
            sum
        };
        parallel::sweep(0..self.chunks(), (), &work, &merge)
    }

    /// Replaces each item of a compressed vector by the first of what `f(k, i, item)` returns, and
    /// sums the rest.
    pub(super) fn update_sums<const K: usize>(
        &self,
        compressed: &mut [f64],
        f: impl Fn(usize, usize, f64) -> (f64, [f64; K]) + Sync,
    ) -> [f64; K] {
        let work = |task: usize, part: Ragged<'_, f64>| {
            let (first, offsets) = self.chunk(task);
            let mut sum = [0.0; K];
            for ((k, &offset), item) in self.range(task).zip(offsets).zip(part.items) {
                let (value, terms) = f(k, first + usize::from(offset), *item);
                *item = value;
                add(&mut sum, terms);
            }
            sum
        };
        parallel::sweep(0..self.chunks(), self.ragged(compressed), &work, &merge)
    }
}

fn add<const K: usize>(sum: &mut [f64; K], terms: [f64; K]) {
    for (sum, term) in sum.iter_mut().zip(terms) {
        *sum += term;
    }
}

fn merge<const K: usize>(mut a: [f64; K], b: [f64; K]) -> [f64; K] {
    add(&mut a, b);
    a
}
