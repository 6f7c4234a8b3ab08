//! How a rectangle of cells is dealt out to ranks, and how its rows travel between them.

use std::ops::Range;
use std::sync::Arc;

use crate::layout::chunk_of;
use crate::parallel::{self, Combine, Split, Work};
use crate::ranks::{Team, Words};

/// A rectangle of cells in slabs of rows, one slab a rank, in their order; a slab may be empty. A slab ends where a chunk
/// of the tree of sums ends.
#[derive(Debug)]
pub(crate) struct Share {
    team: Arc<Team>,
    size: [usize; 2],
    chunk: usize,
    /// First chunk of each rank, and the number of all.
    chunks: Vec<usize>,
    /// First row of each rank, and the number of all.
    rows: Vec<usize>,
    /// How many nodes of the tree each rank adds up.
    nodes: Vec<usize>,
}

/// Whether the same ranks have the same rows.
impl PartialEq for Share {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.team, &other.team) && self.size == other.size
    }
}

impl Share {
    /// `[columns, rows]` dealt out evenly.
    pub(crate) fn new(team: &Arc<Team>, size: [usize; 2]) -> Self {
        let [columns, all_rows] = size;
        let (ranks, chunk) = (team.size(), chunk_of(size));
        // As few rows as are whole chunks.
        let step = chunk / greatest_common_divisor(chunk, columns);
        let steps = all_rows.div_ceil(step);
        let first = |rank: usize| (steps * rank / ranks * step).min(all_rows);
        Self::of(team, size, chunk, (0..=ranks).map(first).collect())
    }

    /// So many columns of some rows, which stay where they lie, in chunks of one row.
    pub(crate) fn within(&self, columns: usize, all: Range<usize>) -> Self {
        let first = |row: &usize| row.clamp(&all.start, &all.end) - all.start;
        let rows = self.rows.iter().map(first).collect();
        Self::of(&self.team, [columns, all.len()], columns, rows)
    }

    /// Rows that begin there, of each rank.
    fn of(team: &Arc<Team>, size: [usize; 2], chunk: usize, rows: Vec<usize>) -> Self {
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

    pub(crate) fn team(&self) -> &Arc<Team> {
        &self.team
    }

    /// Whether every rank has the rows that it has in another share.
    pub(crate) fn has_rows_of(&self, other: &Self) -> bool {
        self.rows == other.rows
    }

    /// Cells of this rank.
    pub(crate) fn cells(&self) -> usize {
        self.own_rows().len() * self.size[0]
    }

    pub(crate) fn chunk(&self) -> usize {
        self.chunk
    }

    /// `[columns, rows]` of all ranks together.
    pub(crate) fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The rows of a rank.
    pub(crate) fn rows_of(&self, rank: usize) -> Range<usize> {
        self.rows[rank]..self.rows[rank + 1]
    }

    /// The rows of this rank.
    pub(crate) fn own_rows(&self) -> Range<usize> {
        self.rows_of(self.team.rank())
    }

    fn chunks_of(&self, rank: usize) -> Range<usize> {
        self.chunks[rank]..self.chunks[rank + 1]
    }

    fn all_chunks(&self) -> usize {
        self.chunks[self.team.size()]
    }

    /// [`Layout::sweep`](crate::layout::Layout::sweep) over the chunks of all ranks. Each adds up the largest nodes of the
    /// tree that it holds wholly, and all finish the tree from these. What ranks that lost each other return is theirs
    /// alone.
    pub(crate) fn sweep<D: Split, T: Words>(
        &self,
        data: D,
        work: &Work<'_, D, T>,
        combine: &Combine<'_, T>,
    ) -> T {
        let own = self.chunks_of(self.team.rank());
        let mut words = Vec::new();
        let mut left = Some(data);
        visit(0..self.all_chunks(), &own, &mut |node| {
            let Some(data) = left.take() else { return };
            let (data, rest) = data.split(node.len());
            left = Some(rest);
            let local = node.start - own.start..node.end - own.start;
            parallel::sweep_cells(self.cells(), local, data, work, combine).write(&mut words);
        });
        let counts: Vec<usize> = self.nodes.iter().map(|nodes| nodes * T::COUNT).collect();
        let all = self.team.gather(&words, &counts);
        // Of a rank on its own without any node nothing is known: zeros end its work soon.
        let mut all = &all.unwrap_or(words)[..];
        self.finish(0..self.all_chunks(), &mut all, combine)
    }

    /// The value of a node of the tree, from those that ranks hold wholly, in their order.
    fn finish<T: Words>(
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

    /// The columns and rows that each rank wants of a field whose rows, of so many columns, are dealt out so: those for
    /// this rank, row by row.
    pub(crate) fn fetch(
        &self,
        field: &[f64],
        columns: usize,
        wanted: impl Fn(usize) -> [Range<usize>; 2],
    ) -> Vec<f64> {
        let (me, ranks) = (self.team.rank(), self.team.size());
        let (own, [own_columns, own_wanted]) = (self.own_rows(), wanted(me));
        let width = own_columns.len();
        let mut found = vec![0.0; own_wanted.len() * width];
        for step in 0..ranks {
            let (to, from) = ((me + step) % ranks, (me + ranks - step) % ranks);
            let [sent_columns, rows] = wanted(to);
            let row = |row: usize| &field[(row - own.start) * columns..][sent_columns.clone()];
            let sent = common(&own, &rows).flat_map(row);
            let received = common(&self.rows_of(from), &own_wanted);
            let first = (received.start - own_wanted.start) * width;
            let place = &mut found[first..first + received.len() * width];
            if step == 0 {
                place
                    .iter_mut()
                    .zip(sent)
                    .for_each(|(place, x)| *place = *x);
            } else {
                // Its length is known to no iterator, and a guess takes up to twice as much.
                let mut block = Vec::with_capacity(common(&own, &rows).len() * sent_columns.len());
                block.extend(sent.map(|x| x.to_bits()));
                let block = self.team.swap(block, to, from);
                for (place, word) in place.iter_mut().zip(block) {
                    *place = f64::from_bits(word);
                }
            }
        }
        found
    }
}

/// What two ranges have in common; an empty range at the start of the second if nothing.
fn common(one: &Range<usize>, other: &Range<usize>) -> Range<usize> {
    let (start, end) = (one.start.max(other.start), one.end.min(other.end));
    if start < end {
        start..end
    } else {
        other.start..other.start
    }
}

/// The halves of a node of the tree, as [`parallel::sweep`] takes them.
fn children(node: Range<usize>) -> [Range<usize>; 2] {
    let middle = node.start + node.len() / 2;
    [node.start..middle, middle..node.end]
}

/// Visits the largest nodes of the tree that lie wholly in a range.
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
