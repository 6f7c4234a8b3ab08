//! The cells that move as a list, so that vector work costs what they are and not what the grid is.

use std::ops::Range;

use crate::cgm::motion::Motion;
use crate::cgm::reduce::Tally;
use crate::parallel::{self, Blocks, CHUNK, Ragged, Split, blocks};

/// Where the cells that move stand, chunk by chunk of the grid.
///
/// A compressed vector holds their values in order; chunk `t` of the grid owns the range
/// `starts[t]..starts[t + 1]` of it.
#[derive(Debug, Clone)]
pub(super) struct MovingCells {
    /// How far from the chunk's first cell they lie; chunk `t` keeps its list at `t * CHUNK`.
    offsets: Vec<u16>,
    counts: Vec<usize>,
    starts: Vec<usize>,
    /// Where the chunks of a full vector start, and its end.
    firsts: Vec<usize>,
}

/// The cells that move of one chunk.
pub(super) struct Entries<'a> {
    /// Where they stand in a compressed vector.
    pub(super) range: Range<usize>,
    /// The chunk's cells in a full vector.
    pub(super) chunk: Range<usize>,
    offsets: &'a [u16],
}

impl Entries<'_> {
    /// Their places in the chunk of a full vector.
    pub(super) fn places(&self) -> impl Iterator<Item = usize> {
        self.offsets.iter().map(|&offset| usize::from(offset))
    }

    /// Visits the cells whose motion is kept, all or those that move, with the place of the motion in its chunk and of
    /// the cell in its.
    pub(super) fn visit<M: Motion<N>, const N: usize>(&self, mut f: impl FnMut(usize, usize)) {
        if M::IS_STEADY {
            self.places().enumerate().for_each(|(k, place)| f(k, place));
        } else {
            (0..self.chunk.len()).for_each(|place| f(place, place));
        }
    }

    /// How a listed cell moves: the one at place `k` of the list and `place` of the chunk.
    #[inline]
    pub(super) fn motion<M: Motion<N>, const N: usize>(
        &self,
        motions: &[M],
        k: usize,
        place: usize,
    ) -> M {
        if M::IS_STEADY {
            motions[self.range.start + k]
        } else if M::IS_CURVED {
            motions[self.chunk.start + place]
        } else {
            M::FREE
        }
    }

    /// Sums of `f(place in the compressed part, place in the chunk)`, in lanes so that additions
    /// overlap.
    #[inline]
    pub(super) fn sums<T: Tally>(&self, mut f: impl FnMut(usize, usize) -> T) -> T {
        let mut lanes = [T::ZERO; 4];
        let groups = self.offsets.chunks_exact(lanes.len());
        let rest = groups.remainder();
        let mut k = 0;
        for group in groups {
            for (lane, &offset) in lanes.iter_mut().zip(group) {
                *lane = lane.plus(f(k, usize::from(offset)));
                k += 1;
            }
        }
        for (lane, &offset) in lanes.iter_mut().zip(rest) {
            *lane = lane.plus(f(k, usize::from(offset)));
            k += 1;
        }
        lanes.into_iter().fold(T::ZERO, T::plus)
    }
}

impl MovingCells {
    pub(super) fn with_capacity(len: usize) -> Self {
        let chunks = len.div_ceil(CHUNK);
        Self {
            offsets: vec![0; len],
            counts: vec![0; chunks],
            starts: vec![0; chunks + 1],
            firsts: (0..=chunks).map(|chunk| (chunk * CHUNK).min(len)).collect(),
        }
    }

    /// Lists the cells that move.
    pub(super) fn update(&mut self, moves: impl Fn(usize) -> bool + Sync) {
        let len = self.offsets.len();
        let data = (
            blocks(&mut self.offsets),
            Blocks {
                items: &mut self.counts,
                width: 1,
            },
        );
        let work = |task: usize, (list, counts): (Blocks<'_, u16>, Blocks<'_, usize>)| {
            let mut count = 0;
            // A chunk has fewer cells than a u16 has values.
            for (offset, cell) in (0_u16..).zip(chunk(task, len)) {
                list.items[count] = offset;
                count += usize::from(moves(cell));
            }
            counts.items[0] = count;
        };
        parallel::sweep(0..len.div_ceil(CHUNK), data, &work, &|(), ()| ());
        let mut start = 0;
        for (next, count) in self.starts[1..].iter_mut().zip(&self.counts) {
            start += count;
            *next = start;
        }
    }

    /// Cells that move.
    pub(super) fn len(&self) -> usize {
        self.starts[self.counts.len()]
    }

    /// A compressed vector, of which each chunk owns its part.
    pub(super) fn compressed<'a, T>(&'a self, items: &'a mut [T]) -> Ragged<'a, T> {
        Ragged {
            items: &mut items[..self.len()],
            starts: &self.starts,
        }
    }

    /// How the cells move, as they are kept, of which each chunk owns its part.
    pub(super) fn motions<'a, M: Motion<N>, const N: usize>(
        &'a self,
        motions: &'a mut [M],
    ) -> Ragged<'a, M> {
        if M::IS_STEADY {
            self.compressed(motions)
        } else {
            Ragged {
                items: motions,
                starts: &self.firsts,
            }
        }
    }

    /// The same to read, in one piece.
    pub(super) fn kept<'a, M: Motion<N>, const N: usize>(&self, motions: &'a [M]) -> &'a [M] {
        if M::IS_STEADY {
            &motions[..self.len()]
        } else {
            motions
        }
    }

    /// Runs `work(entries, its part of data)` for every chunk and sums what it returns.
    pub(super) fn sweep<D: Split, T: Tally>(
        &self,
        data: D,
        work: impl Fn(Entries<'_>, D) -> T + Sync,
    ) -> T {
        let work = |task: usize, data: D| {
            let entries = Entries {
                range: self.starts[task]..self.starts[task + 1],
                chunk: chunk(task, self.offsets.len()),
                offsets: &self.offsets[task * CHUNK..][..self.counts[task]],
            };
            work(entries, data)
        };
        parallel::sweep(0..self.counts.len(), data, &work, &T::plus)
    }
}

fn chunk(task: usize, len: usize) -> Range<usize> {
    task * CHUNK..((task + 1) * CHUNK).min(len)
}
