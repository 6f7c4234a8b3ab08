//! Partition of a rectangle of cells over ranks, and exchange of its rows.

use std::ops::Range;
use std::sync::Arc;

use bytemuck::{cast_slice, cast_slice_mut};

use crate::error::Result;
use crate::memory::fallible;
use crate::parallel::layout::chunk_of;
use crate::parallel::ranks::{RankGroup, WireFormat};
use crate::parallel::{self, Combine, Split, Work};

/// Approximate number of words that a rank receives in one round.
const ROUND_WORDS: usize = 1 << 19;

/// A rectangle of cells in slabs of rows, one slab per rank in the order of the ranks. Slabs end at chunk boundaries of the
/// summation tree and may be empty.
#[derive(Debug)]
pub(crate) struct RowPartition {
    team: Arc<RankGroup>,
    size: [usize; 2],
    chunk: usize,
    /// First chunk of each rank, and the number of all chunks.
    chunks: Vec<usize>,
    /// First row of each rank, and the number of all rows.
    rows: Vec<usize>,
    /// Number of tree nodes that each rank computes.
    nodes: Vec<usize>,
}

/// Two partitions are equal if the same ranks have the same rows.
impl PartialEq for RowPartition {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.team, &other.team) && self.size == other.size
    }
}

impl RowPartition {
    /// Distributes `[columns, rows]` evenly.
    pub(crate) fn new(team: &Arc<RankGroup>, size: [usize; 2]) -> Self {
        let [columns, all_rows] = size;
        let (ranks, chunk) = (team.size(), chunk_of(size));
        // Smallest even number of rows that is a whole number of chunks. It is even because rows are transformed two at a
        // time.
        let step = chunk / greatest_common_divisor(chunk, columns);
        let step = step * (1 + step % 2);
        let steps = all_rows.div_ceil(step);
        let first = |rank: usize| (steps * rank / ranks * step).min(all_rows);
        Self::of(team, size, chunk, (0..=ranks).map(first).collect())
    }

    /// Returns the partition of a range of rows, with the given number of columns, in chunks of one row. The rows remain on their
    /// ranks.
    pub(crate) fn within(&self, columns: usize, all: Range<usize>) -> Self {
        let first = |row: &usize| row.clamp(&all.start, &all.end) - all.start;
        let rows = self.rows.iter().map(first).collect();
        Self::of(&self.team, [columns, all.len()], columns, rows)
    }

    /// Creates a partition from the first rows of the ranks.
    fn of(team: &Arc<RankGroup>, size: [usize; 2], chunk: usize, rows: Vec<usize>) -> Self {
        let (columns, ranks) = (size[0], team.size());
        let chunks: Vec<usize> = rows
            .iter()
            .map(|row| (row * columns).div_ceil(chunk))
            .collect();
        let mut share = Self {
            team: Arc::clone(team),
            size,
            chunk,
            chunks,
            rows,
            nodes: Vec::new(),
        };
        let count = |rank: usize| {
            let mut count = 0;
            visit(0..share.all_chunks(), &share.chunks_of(rank), &mut |_| {
                count += 1;
            });
            count
        };
        share.nodes = (0..ranks).map(count).collect();
        share
    }

    pub(crate) fn team(&self) -> &Arc<RankGroup> {
        &self.team
    }

    /// Returns whether every rank has the same rows as in another partition.
    pub(crate) fn has_rows_of(&self, other: &Self) -> bool {
        self.rows == other.rows
    }

    /// Returns the number of local cells.
    pub(crate) fn cells(&self) -> usize {
        self.local_rows().len() * self.size[0]
    }

    pub(crate) fn chunk(&self) -> usize {
        self.chunk
    }

    /// Returns `[columns, rows]` of all ranks together.
    pub(crate) fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Returns the rows of a rank.
    pub(crate) fn rows_of(&self, rank: usize) -> Range<usize> {
        self.rows[rank]..self.rows[rank + 1]
    }

    /// Returns the rows of this rank.
    pub(crate) fn local_rows(&self) -> Range<usize> {
        self.rows_of(self.team.rank())
    }

    fn chunks_of(&self, rank: usize) -> Range<usize> {
        self.chunks[rank]..self.chunks[rank + 1]
    }

    fn all_chunks(&self) -> usize {
        self.chunks[self.team.size()]
    }

    /// Runs [`Layout::sweep`](crate::parallel::layout::Layout::sweep) over the chunks of all ranks. Each rank computes the
    /// largest nodes of the tree that it owns entirely, and all ranks complete the tree from the values of these nodes. After a
    /// failed call the result is only local.
    pub(crate) fn sweep<D: Split, T: WireFormat>(
        &self,
        data: D,
        work: &Work<'_, D, T>,
        combine: &Combine<'_, T>,
    ) -> T {
        let mut left = Some(data);
        let values = self.local_subtrees().into_iter().filter_map(|node| {
            let (data, rest) = left.take()?.split(node.len());
            left = Some(rest);
            let value = parallel::sweep_cells(self.cells(), node, data, work, combine);
            Some(value)
        });
        self.finished(values, combine)
    }

    /// Returns the largest nodes of the tree that this rank owns entirely, as ranges of local chunks.
    pub(crate) fn local_subtrees(&self) -> Vec<Range<usize>> {
        let own = self.chunks_of(self.team.rank());
        let mut nodes = Vec::new();
        visit(0..self.all_chunks(), &own, &mut |node| {
            nodes.push(node.start - own.start..node.end - own.start);
        });
        nodes
    }

    /// Computes the value of the whole tree from the values of [`RowPartition::local_subtrees`] of all ranks.
    pub(crate) fn finished<T: WireFormat>(
        &self,
        own: impl Iterator<Item = T>,
        combine: &Combine<'_, T>,
    ) -> T {
        let mut words = Vec::new();
        own.for_each(|value| value.write(&mut words));
        let counts: Vec<usize> = self.nodes.iter().map(|nodes| nodes * T::COUNT).collect();
        let all = self.team.gather(&words, &counts);
        // After a failure a rank without a node has no values. Zeros let it finish its work soon.
        let mut all = &all.unwrap_or(words)[..];
        self.finish(0..self.all_chunks(), &mut all, combine)
    }

    /// Computes the value of a node of the tree from the values of the nodes that single ranks own entirely, in the order of the
    /// ranks.
    fn finish<T: WireFormat>(
        &self,
        node: Range<usize>,
        words: &mut &[u64],
        combine: &Combine<'_, T>,
    ) -> T {
        let is_whole = self
            .chunks
            .windows(2)
            .any(|ends| ends[0] <= node.start && node.end <= ends[1]);
        if is_whole {
            return T::read(words);
        }
        let [low, high] = children(node);
        let low = self.finish(low, words, combine);
        combine(low, self.finish(high, words, combine))
    }

    /// Fetches the columns and rows that each rank requests, from a distributed field with the given number of columns. Returns
    /// the values that this rank requested, row by row.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if the request cannot be allocated.
    /// - [`Error::Ranks`](crate::Error::Ranks) if the request of another rank cannot be allocated.
    pub(crate) fn fetch(
        &self,
        field: &[f64],
        columns: usize,
        wanted: impl Fn(usize) -> [Range<usize>; 2],
    ) -> Result<Vec<f64>> {
        let own = wanted(self.team.rank()).map(|range| range.len());
        let room = || {
            Ok((
                fallible::zeros(own[0].saturating_mul(own[1]))?,
                self.blocks(&wanted)?,
            ))
        };
        // All ranks have memory before the exchange starts, so that no rank waits for the others.
        let (mut found, blocks) = self.team.collective_result(room())?;
        self.fetch_into(field, columns, wanted, blocks, &mut found);
        Ok(found)
    }

    /// Returns the number of rounds of an exchange, for about [`ROUND_WORDS`] words per round on the rank that receives most.
    fn rounds(&self, wanted: impl Fn(usize) -> [Range<usize>; 2]) -> usize {
        let most = (0..self.team.size())
            .map(|rank| wanted(rank).map(|range| range.len()).iter().product());
        rounds(most.max().unwrap_or(0), ROUND_WORDS)
    }

    /// Returns the columns and rows that this rank sends to a rank in one of the rounds.
    fn sent(
        &self,
        [columns, rows]: [Range<usize>; 2],
        round: usize,
        rounds: usize,
    ) -> [Range<usize>; 2] {
        [
            columns,
            part(&common(&self.local_rows(), &rows), round, rounds),
        ]
    }

    /// Allocates the blocks that this rank sends in the first round of [`RowPartition::fetch_into`]. A rank that runs out of
    /// memory can thus report it before the exchange starts.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if the blocks cannot be allocated.
    pub(crate) fn blocks(
        &self,
        wanted: impl Fn(usize) -> [Range<usize>; 2],
    ) -> Result<Vec<Vec<u64>>> {
        let rounds = self.rounds(&wanted);
        let block = |rank: usize| {
            let words = self.sent(wanted(rank), 0, rounds).map(|range| range.len());
            let is_own = rank == self.team.rank();
            fallible::zeros(if is_own { 0 } else { words.iter().product() })
        };
        (0..self.team.size()).map(block).collect()
    }

    /// Fetches columns and rows like [`RowPartition::fetch`], but into existing memory. `blocks` has one block for each
    /// rank (see [`RowPartition::blocks`]).
    pub(crate) fn fetch_into(
        &self,
        field: &[f64],
        columns: usize,
        wanted: impl Fn(usize) -> [Range<usize>; 2],
        mut blocks: Vec<Vec<u64>>,
        found: &mut [f64],
    ) {
        let (me, ranks) = (self.team.rank(), self.team.size());
        let (own, [own_columns, own_wanted]) = (self.local_rows(), wanted(me));
        let width = own_columns.len();
        let rounds = self.rounds(&wanted);
        let sent = |rank: usize, round: usize| self.sent(wanted(rank), round, rounds);
        let pack = |to: &mut [u64], [sent, rows]: [Range<usize>; 2]| {
            if !to.is_empty() {
                parallel::rows(to, sent.len(), |row, to| {
                    let row = &field[(rows.start + row - own.start) * columns..][sent.clone()];
                    to.copy_from_slice(cast_slice(row));
                });
            }
        };
        // The memory of received blocks is reused for the next blocks to send.
        for round in 0..rounds {
            let come = |rank: usize| part(&common(&self.rows_of(rank), &own_wanted), round, rounds);
            let place = |rank: usize| {
                let rows = come(rank);
                let first = (rows.start - own_wanted.start) * width;
                first..first + rows.len() * width
            };
            for rank in (0..ranks).filter(|rank| *rank != me) {
                let [columns, rows] = sent(rank, round);
                blocks[rank].resize(columns.len() * rows.len(), 0);
                pack(&mut blocks[rank], [columns, rows]);
            }
            pack(cast_slice_mut(&mut found[place(me)]), sent(me, round));
            let is_expected: Vec<bool> = (0..ranks).map(|rank| !place(rank).is_empty()).collect();
            blocks = self.team.all_to_all(blocks, &is_expected);
            for (rank, block) in blocks.iter().enumerate() {
                let place = &mut found[place(rank)];
                if rank == me {
                    continue;
                }
                if block.len() == place.len() {
                    parallel::copy(cast_slice(block), place);
                } else {
                    self.team.out_of_step(rank);
                }
            }
        }
    }
}

/// Returns the number of rounds of an exchange, given the number of items of a rank and the approximate number per round. At most
/// 16 rounds are used, because a sixteenth of the items takes little memory compared with the fields of a rank.
pub(crate) fn rounds(most: usize, of_a_round: usize) -> usize {
    most.div_ceil(of_a_round).clamp(1, 16)
}

/// Returns the part of a range that is sent in one of several rounds.
pub(crate) fn part(all: &Range<usize>, round: usize, rounds: usize) -> Range<usize> {
    let end = |round: usize| all.start + all.len() * round / rounds;
    end(round)..end(round + 1)
}

/// Returns the intersection of two ranges. If the ranges are disjoint, returns an empty range at the start of the second range.
fn common(one: &Range<usize>, other: &Range<usize>) -> Range<usize> {
    let (start, end) = (one.start.max(other.start), one.end.min(other.end));
    if start < end {
        start..end
    } else {
        other.start..other.start
    }
}

/// Returns the halves of a node of the tree, as in [`parallel::sweep`].
fn children(node: Range<usize>) -> [Range<usize>; 2] {
    let middle = node.start + node.len() / 2;
    [node.start..middle, middle..node.end]
}

/// Visits the largest nodes of the tree that lie entirely in a range.
fn visit(node: Range<usize>, range: &Range<usize>, f: &mut dyn FnMut(Range<usize>)) {
    if node.start >= range.end || node.end <= range.start {
        return;
    }
    if range.start <= node.start && node.end <= range.end {
        return f(node);
    }
    for child in children(node) {
        visit(child, range, f);
    }
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 {
        a
    } else {
        greatest_common_divisor(b, a % b)
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::error::{Error, RankFailure};
    use crate::parallel::ranks::Threads;

    #[test]
    fn fetch_without_memory_is_an_error_on_all_ranks() {
        let outcomes = Threads::run(2, Duration::from_secs(60), |rank| {
            let team = Arc::new(RankGroup::new(Arc::new(rank)));
            let partition = RowPartition::new(&team, [1 << 40, 4]);
            let everything = 1_usize << 60;
            // Only the second rank requests columns, from its own rows.
            partition.fetch(&[], 1 << 40, |rank| [0..rank * everything, 2..3])
        });
        assert!(matches!(
            outcomes[0],
            Err(Error::Ranks(RankFailure::RejectedByRank { rank: 1 }))
        ));
        assert!(matches!(outcomes[1], Err(Error::Memory { bytes, .. }) if bytes == 1 << 63));
    }
}
