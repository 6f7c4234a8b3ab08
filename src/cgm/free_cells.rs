//! List of the moving cells. For intervals the list is the complement of the active set. The cost of vector operations is
//! proportional to the length of this list, not to the size of the grid.

use std::array::from_fn;
use std::ops::Range;

use crate::cgm::law::state::Row;
use crate::cgm::reduce::Reduction;
use crate::error::Result;
use crate::memory::fallible;
use crate::numerics::cell_vector::{Adjacent, Places, chunks, put};
use crate::parallel::layout::Layout;
use crate::parallel::ranks::WireFormat;
use crate::parallel::{Blocks, Split, UnevenChunks};

/// List of the moving cells, chunk by chunk of the grid.
///
/// A compressed vector stores the values of the moving cells in order. Its range `starts[t]..starts[t + 1]` belongs to
/// chunk `t` of the grid.
#[derive(Debug, Clone)]
pub(in crate::cgm) struct FreeCells {
    layout: Layout,
    /// Offsets of the cells from the first cell of their chunk. The list of a chunk starts at the index of its first cell.
    offsets: Vec<u16>,
    counts: Vec<usize>,
    starts: Vec<usize>,
    /// Start of each chunk in a full vector, and the end of the vector.
    firsts: Vec<usize>,
    /// Number of moving cells on all ranks together.
    all: usize,
}

/// The moving cells of one chunk.
pub(in crate::cgm) struct ChunkCells<'a> {
    /// Range of the cells in a compressed vector.
    pub(in crate::cgm) range: Range<usize>,
    /// Range of the chunk in a full vector.
    pub(in crate::cgm) chunk: Range<usize>,
    offsets: &'a [u16],
}

/// Number of cells that a sweep over groups processes together, and number of its lanes.
const LANES: usize = 4;

/// Work of a sweep on groups of cells.
pub(in crate::cgm) trait GroupWork {
    type Sum: Reduction;

    /// Processes `W` successive cells of the list and returns the term of each. `k` is the position of the first cell in the
    /// compressed part, and `places` are the positions of the cells in the chunk.
    fn group<P: Places<W>, const W: usize>(&mut self, k: usize, places: P) -> [Self::Sum; W];
}

impl ChunkCells<'_> {
    /// Returns the positions of the cells in their chunk of a full vector.
    pub(in crate::cgm) fn places(&self) -> impl Iterator<Item = usize> {
        self.offsets.iter().map(|&offset| usize::from(offset))
    }

    /// Visits the cells whose motion is stored: all cells or only the moving cells. `f` receives the position of the motion in
    /// its chunk and the position of the cell in its chunk.
    pub(in crate::cgm) fn visit<M: Row<N>, const N: usize>(&self, mut f: impl FnMut(usize, usize)) {
        if M::IS_STEADY {
            self.places().enumerate().for_each(|(k, place)| f(k, place));
        } else {
            (0..self.chunk.len()).for_each(|place| f(place, place));
        }
    }

    /// Returns the row of a listed cell at position `k` of the list and at position `place` of the chunk.
    #[inline]
    pub(in crate::cgm) fn row<R: Row<N>, const N: usize>(
        &self,
        rows: &[R],
        k: usize,
        place: usize,
    ) -> R {
        if R::IS_STEADY {
            rows[self.range.start + k]
        } else if R::IS_CURVED {
            rows[self.chunk.start + place]
        } else {
            R::FREE
        }
    }

    /// Sums `f(position in the compressed part, position in the chunk)` in several lanes, so that the processor overlaps
    /// additions.
    #[inline]
    pub(in crate::cgm) fn sums<T: Reduction>(&self, mut f: impl FnMut(usize, usize) -> T) -> T {
        let mut lanes = [T::ZERO; LANES];
        let groups = self.offsets.chunks_exact(LANES);
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

    /// Sums the terms of the cells in the order of [`sums`](Self::sums). The cells of a group are processed together, so that the
    /// compiler uses vector instructions. Compressed vectors are always read in runs, full vectors if the cells are adjacent.
    #[inline]
    pub(in crate::cgm) fn sums_of_groups<W: GroupWork>(&self, work: &mut W) -> W::Sum {
        let mut lanes = [W::Sum::ZERO; LANES];
        let groups = self.offsets.chunks_exact(LANES);
        let rest = groups.remainder();
        let mut k = 0;
        for group in groups {
            let place = |lane: usize| usize::from(group[lane]);
            // The offsets ascend, so the first and the last offset show whether the cells are adjacent.
            let terms: [_; LANES] = if place(LANES - 1) - place(0) == LANES - 1 {
                work.group(k, Adjacent(place(0)))
            } else {
                work.group(k, from_fn(place))
            };
            lanes = from_fn(|lane| lanes[lane].plus(terms[lane]));
            k += LANES;
        }
        for (number, &offset) in rest.iter().enumerate() {
            let [term] = work.group(k + number, Adjacent(usize::from(offset)));
            lanes = from_fn(|lane| {
                if lane == number {
                    lanes[lane].plus(term)
                } else {
                    lanes[lane]
                }
            });
        }
        lanes.into_iter().fold(W::Sum::ZERO, W::Sum::plus)
    }

    /// Returns the rows of `W` successive cells, as [`row`](Self::row).
    #[inline]
    pub(in crate::cgm) fn rows<R: Row<N>, const N: usize, const W: usize>(
        &self,
        rows: &[R],
        k: usize,
        places: impl Places<W>,
    ) -> [R; W] {
        let places = places.all();
        from_fn(|lane| self.row(rows, k + lane, places[lane]))
    }

    /// Sums `f(item, position in the compressed part, position in the chunk)` like [`sums`](Self::sums), where `items` are the
    /// entries of compressed vectors. One bounds check per cell covers all these vectors.
    #[inline]
    pub(in crate::cgm) fn sums_of<I, T: Reduction>(
        &self,
        mut items: impl Iterator<Item = I>,
        mut f: impl FnMut(I, usize, usize) -> T,
    ) -> T {
        self.sums(|k, place| items.next().map_or(T::ZERO, |item| f(item, k, place)))
    }
}

impl FreeCells {
    /// Creates an empty list for the cells of a layout.
    pub(in crate::cgm) fn new(layout: Layout) -> Result<Self> {
        let (cells, chunks) = (layout.cells(), layout.tasks());
        let first = |chunk: usize| (chunk * layout.chunk()).min(cells);
        Ok(Self {
            offsets: fallible::zeros(cells)?,
            counts: fallible::filled(0, chunks)?,
            starts: fallible::filled(0, chunks + 1)?,
            firsts: fallible::collected(chunks + 1, (0..=chunks).map(first))?,
            all: 0,
            layout,
        })
    }

    /// Lists the moving cells.
    pub(in crate::cgm) fn update(&mut self, moves: impl Fn(usize) -> bool + Sync) {
        let layout = &self.layout;
        let data = (
            layout.blocks(&mut self.offsets),
            Blocks {
                items: &mut self.counts,
                width: 1,
            },
        );
        let work = |task: usize, (list, counts): (Blocks<'_, u16>, Blocks<'_, usize>)| {
            let mut count = 0;
            // A chunk has fewer cells than a `u16` has values.
            for (offset, cell) in (0_u16..).zip(layout.range(task)) {
                list.items[count] = offset;
                count += usize::from(moves(cell));
            }
            counts.items[0] = count;
            count
        };
        self.all = layout.sweep(data, work, |a, b| a + b);
        let mut start = 0;
        for (next, count) in self.starts[1..].iter_mut().zip(&self.counts) {
            start += count;
            *next = start;
        }
    }

    pub(in crate::cgm) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Returns the number of local moving cells.
    pub(in crate::cgm) fn len(&self) -> usize {
        self.starts[self.counts.len()]
    }

    /// Returns the number of moving cells on all ranks together.
    pub(in crate::cgm) fn of_all_ranks(&self) -> usize {
        self.all
    }

    /// Returns whether some cells have no stored motion.
    pub(in crate::cgm) fn leaves_any<M: Row<N>, const N: usize>(&self) -> bool {
        M::IS_STEADY && self.all < self.layout.of_all_ranks()
    }

    /// Returns whether a condition holds for any of the stored motions.
    pub(in crate::cgm) fn any<M: Row<N>, const N: usize>(
        &self,
        motions: &[M],
        holds: impl Fn(M) -> bool + Sync,
    ) -> bool {
        let starts = if M::IS_STEADY {
            &self.starts
        } else {
            &self.firsts
        };
        let of = |chunk: usize| &motions[starts[chunk]..starts[chunk + 1]];
        let work = |chunk: usize, ()| of(chunk).iter().any(|&motion| holds(motion));
        self.layout.sweep((), work, |a, b| a || b)
    }

    /// Returns the number of cells that move in any direction.
    pub(in crate::cgm) fn free<R: Row<N>, const N: usize>(&self, rows: &[R]) -> usize {
        self.sweep((), |entries, ()| {
            entries.sums(|k, place| usize::from(entries.row(rows, k, place).is_free()))
        })
    }

    /// Visits the moving cells with their position in a compressed vector.
    pub(in crate::cgm) fn places(&self, f: &mut impl FnMut(usize, usize)) {
        for task in 0..self.counts.len() {
            let (start, first) = (self.starts[task], self.firsts[task]);
            let offsets = &self.offsets[first..][..self.counts[task]];
            for (k, &offset) in offsets.iter().enumerate() {
                f(start + k, first + usize::from(offset));
            }
        }
    }

    /// Sets the entry of each moving cell in a compressed vector to `value(entry, cell, row)`.
    pub(in crate::cgm) fn set<R: Row<N>, T: Send, const N: usize>(
        &self,
        rows: &[R],
        vector: &mut [T],
        value: impl Fn(usize, usize, R) -> T + Sync,
    ) {
        self.sweep(self.compressed(vector), |entries, vector| {
            for (k, place) in entries.places().enumerate() {
                let (entry, cell) = (entries.range.start + k, entries.chunk.start + place);
                vector.items[k] = value(entry, cell, entries.row(rows, k, place));
            }
        });
    }

    /// Sets the components of each moving cell in a full vector to `value(entry, row)`, where `entry` is the position of the cell
    /// in a compressed vector.
    pub(in crate::cgm) fn set_full<R: Row<N>, const N: usize>(
        &self,
        rows: &[R],
        vector: &mut [Vec<f64>; N],
        value: impl Fn(usize, R) -> [f64; N] + Sync,
    ) {
        self.sweep(chunks(&self.layout, vector), |entries, mut vector| {
            for (k, place) in entries.places().enumerate() {
                let row = entries.row(rows, k, place);
                put(&mut vector, place, value(entries.range.start + k, row));
            }
        });
    }

    /// Sums over the pieces of a compressed vector.
    pub(in crate::cgm) fn sum<T: Reduction>(&self, leaf: impl Fn(Range<usize>) -> T + Sync) -> T {
        self.sweep((), |entries, ()| leaf(entries.range))
    }

    /// Splits a compressed vector into one piece per chunk.
    pub(in crate::cgm) fn compressed<'a, T>(&'a self, items: &'a mut [T]) -> UnevenChunks<'a, T> {
        UnevenChunks {
            items: &mut items[..self.len()],
            starts: &self.starts,
        }
    }

    /// Splits the stored motions into one piece per chunk.
    pub(in crate::cgm) fn motions<'a, M: Row<N>, const N: usize>(
        &'a self,
        motions: &'a mut [M],
    ) -> UnevenChunks<'a, M> {
        if M::IS_STEADY {
            self.compressed(motions)
        } else {
            UnevenChunks {
                items: motions,
                starts: &self.firsts,
            }
        }
    }

    /// Calls `work` with the entries of every chunk and with the values of this chunk, and sums the results.
    pub(in crate::cgm) fn sweep<D: Split, T: Reduction>(
        &self,
        data: D,
        work: impl Fn(ChunkCells<'_>, D) -> T + Sync,
    ) -> T {
        let work = |task: usize, data: D| {
            let entries = ChunkCells {
                range: self.starts[task]..self.starts[task + 1],
                chunk: self.layout.range(task),
                offsets: &self.offsets[self.firsts[task]..][..self.counts[task]],
            };
            work(entries, data)
        };
        self.layout.sweep(data, work, T::plus)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of the cells, and the visited cells.
    struct Values<'a> {
        values: &'a [f64],
        visited: Vec<(usize, usize)>,
    }

    impl GroupWork for Values<'_> {
        type Sum = f64;

        fn group<P: Places<W>, const W: usize>(&mut self, k: usize, places: P) -> [f64; W] {
            let cells = places.all().into_iter().enumerate();
            self.visited
                .extend(cells.map(|(lane, place)| (k + lane, place)));
            places.values(self.values)
        }
    }

    /// The list has runs shorter than a group, runs across groups, and a last group with fewer cells.
    #[test]
    fn sums_of_groups_visit_each_cell_once_in_the_order_of_sums() {
        let values: Vec<f64> = (0..40_u32).map(|i| f64::from(i).sin()).collect();
        let offsets = [
            0, 1, 2, 3, 5, 6, 7, 9, 12, 13, 14, 15, 16, 17, 18, 19, 30, 31, 39,
        ];
        let entries = ChunkCells {
            range: 0..offsets.len(),
            chunk: 0..values.len(),
            offsets: &offsets,
        };
        let mut work = Values {
            values: &values,
            visited: Vec::new(),
        };
        let sum = entries.sums_of_groups(&mut work);
        let expected = entries.sums(|_, place| values[place]);
        assert_eq!(sum.to_bits(), expected.to_bits());
        let listed: Vec<_> = entries.places().enumerate().collect();
        assert_eq!(work.visited, listed);
    }
}
