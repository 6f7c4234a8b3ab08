//! How the cells of a vector lie: in chunks, whose sums add up in a fixed tree, and dealt out to ranks.

use std::ops::{ControlFlow, Range};
use std::sync::Arc;

use crate::error::Result;
use crate::parallel::ranks::partition::RowPartition;
use crate::parallel::ranks::{RankGroup, WireFormat};
use crate::parallel::{self, Blocks, CHUNK, Combine, Split, Work};
use crate::report::Status;

/// The cells of an [`Operator`](crate::Operator) that are held here, and how they add up.
///
/// Sums over cells follow a tree of chunks, which depends on the rows and columns of the cells alone: neither the
/// threads nor the ranks that share the cells change a bit of them.
///
/// ```
/// use stickslip::{ElasticPair, Grid, HalfSpace, Layout, Material, Operator, influence::Component};
/// // Fields of bodies lie in rows; those of an operator of one's own, unless it tells otherwise, in one piece.
/// let pair = ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?;
/// let bodies = HalfSpace::new(Grid::new(40, 30, 1.0, 1.0)?, pair)?;
/// let rows = bodies.operator(Component::ZZ)?.layout();
/// assert_eq!(rows.cells(), Layout::flat(1200).cells());
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Layout {
    cells: usize,
    chunk: usize,
    share: Option<Arc<RowPartition>>,
    /// Those that share the cells, or that all do the same on cells of their own.
    team: Option<Arc<RankGroup>>,
}

impl Layout {
    /// Cells one behind the other, all of them here.
    #[must_use]
    pub fn flat(cells: usize) -> Self {
        Self {
            cells,
            chunk: CHUNK,
            share: None,
            team: None,
        }
    }

    /// A rectangle of cells, `[columns, rows]`, all of them here.
    pub(crate) fn of([columns, rows]: [usize; 2]) -> Self {
        Self {
            cells: columns * rows,
            chunk: chunk_of([columns, rows]),
            share: None,
            team: None,
        }
    }

    /// A rectangle of cells in chunks of one row, all of them here.
    pub(crate) fn of_rows([columns, rows]: [usize; 2]) -> Self {
        Self {
            chunk: columns,
            ..Self::flat(columns * rows)
        }
    }

    /// The part of this rank.
    pub(crate) fn shared(share: Arc<RowPartition>) -> Self {
        Self {
            cells: share.cells(),
            chunk: share.chunk(),
            team: Some(Arc::clone(share.team())),
            share: Some(share),
        }
    }

    /// The same cells, of a team, if there is one, that shares them or of which every rank has all and does the same.
    pub(crate) fn alike(mut self, team: Option<&Arc<RankGroup>>) -> Self {
        self.team = team.cloned();
        self
    }

    /// Cells held here.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.cells
    }

    /// Cells of all ranks together.
    pub(crate) fn of_all_ranks(&self) -> usize {
        match &self.share {
            Some(share) => share.size().into_iter().product(),
            None => self.cells,
        }
    }

    /// Cells of a chunk; the last one may have fewer.
    pub(crate) fn chunk(&self) -> usize {
        self.chunk
    }

    /// Chunks held here.
    pub(crate) fn tasks(&self) -> usize {
        self.cells.div_ceil(self.chunk)
    }

    /// The cells of a chunk.
    pub(crate) fn range(&self, task: usize) -> Range<usize> {
        task * self.chunk..((task + 1) * self.chunk).min(self.cells)
    }

    /// The result of a step that every rank takes by itself; an error if it failed on any.
    pub(crate) fn collective_result<T>(&self, result: Result<T>) -> Result<T> {
        RankGroup::agreed_of(self.team.as_deref(), result)
    }

    /// What the values of all ranks that share the cells come to.
    pub(crate) fn combined<T: WireFormat>(&self, own: T, combine: impl Fn(T, T) -> T) -> T {
        let team = self.share.as_ref().map(|share| &**share.team());
        RankGroup::combined_of(team, own, combine)
    }

    /// `Ok` without ranks, of what they cannot do together.
    pub(crate) fn check_alone(&self, quantity: &'static str) -> Result<()> {
        RankGroup::check_alone(self.team.as_deref(), quantity)
    }

    /// What the first rank says of going on, for all. Ranks that have lost each other have stalled.
    pub(crate) fn decided(&self, own: ControlFlow<Status>) -> ControlFlow<Status> {
        let Some(team) = &self.team else { return own };
        let endings = [Status::Cancelled, Status::TimeLimit, Status::Stalled];
        let place = |status| endings.iter().position(|ending| *ending == status);
        let code = own
            .break_value()
            .and_then(place)
            .map_or(0, |place| 1 + place as u64);
        match team.decided(code) {
            Some(0) => ControlFlow::Continue(()),
            Some(1) => ControlFlow::Break(Status::Cancelled),
            Some(2) => ControlFlow::Break(Status::TimeLimit),
            _ => ControlFlow::Break(Status::Stalled),
        }
    }

    /// `Ok` as long as the ranks have reached each other.
    pub(crate) fn check(&self) -> Result<()> {
        self.team.as_ref().map_or(Ok(()), |team| team.check())
    }

    /// A slice with an entry for each cell, cut into chunks.
    pub(crate) fn blocks<'a, T>(&self, items: &'a mut [T]) -> Blocks<'a, T> {
        Blocks {
            items,
            width: self.chunk,
        }
    }

    /// Runs `work(chunk, its part of data)` on all chunks held here and combines the results of all ranks pairwise in
    /// the tree.
    pub(crate) fn sweep<D: Split, T: WireFormat>(
        &self,
        data: D,
        work: impl Fn(usize, D) -> T + Sync,
        combine: impl Fn(T, T) -> T + Sync,
    ) -> T {
        self.sweep_any(data, &work, &combine)
    }

    fn sweep_any<D: Split, T: WireFormat>(
        &self,
        data: D,
        work: &Work<'_, D, T>,
        combine: &Combine<'_, T>,
    ) -> T {
        match &self.share {
            Some(share) if T::COUNT > 0 => share.sweep(data, work, combine),
            // A rank without cells has nothing to do.
            _ if self.tasks() == 0 => T::ZERO,
            _ => parallel::sweep_cells(self.cells, 0..self.tasks(), data, work, combine),
        }
    }

    /// What the nodes of the tree come to that are added up here, of anything.
    pub(crate) fn at_nodes<T: Send>(
        &self,
        leaf: impl Fn(Range<usize>) -> T + Sync,
        combine: impl Fn(T, T) -> T + Sync,
    ) -> Vec<T> {
        let work = |task: usize, ()| leaf(self.range(task));
        let at = |node| parallel::sweep_cells(self.cells, node, (), &work, &combine);
        match &self.share {
            Some(share) => share.local_subtrees().into_iter().map(at).collect(),
            None => vec![at(0..self.tasks())],
        }
    }

    /// The value of the whole tree, from those of [`Layout::at_nodes`].
    pub(crate) fn finished<T: WireFormat>(
        &self,
        mut own: impl Iterator<Item = T>,
        combine: impl Fn(T, T) -> T + Sync,
    ) -> T {
        match &self.share {
            Some(share) => share.finished(own, &combine),
            None => own.next().unwrap_or(T::ZERO),
        }
    }

    /// The same of ranges of cells, read-only.
    pub(crate) fn fold<T: WireFormat>(
        &self,
        leaf: impl Fn(Range<usize>) -> T + Sync,
        combine: impl Fn(T, T) -> T + Sync,
    ) -> T {
        self.sweep((), |task, ()| leaf(self.range(task)), combine)
    }
}

/// Cells of a chunk: whole rows, or equal pieces of a long row, about [`CHUNK`] of them. A single row is cut anywhere.
pub(crate) fn chunk_of([columns, rows]: [usize; 2]) -> usize {
    if rows <= 1 {
        return CHUNK;
    }
    if columns <= CHUNK {
        return CHUNK / columns.max(1) * columns.max(1);
    }
    let fewest = columns.div_ceil(CHUNK);
    let pieces = (fewest..4 * fewest).find(|pieces| columns % pieces == 0);
    pieces.map_or(CHUNK, |pieces| columns / pieces)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chunks_are_rows_or_pieces_of_rows() {
        for (size, chunk) in [
            ([64, 64], 4096),
            ([1, 9000], 4096),
            ([9000, 1], 4096),
            ([1000, 700], 4000),
            ([4096, 2], 4096),
            ([65536, 3], 4096),
            ([5000, 5000], 2500),
            // A prime has no pieces.
            ([4099, 2], 4096),
        ] {
            assert_eq!(chunk_of(size), chunk);
        }
    }
}
