//! Layout of the cells of a vector: chunks whose sums are added in a fixed tree, distributed over ranks.

use std::borrow::Cow;
use std::ops::{ControlFlow, Range};
use std::sync::Arc;

use crate::error::Result;
use crate::parallel::ranks::partition::RowPartition;
use crate::parallel::ranks::{RankGroup, WireFormat};
use crate::parallel::{self, Blocks, CHUNK, Combine, Split, Work};
use crate::report::Status;

/// Local cells of an [`Operator`](crate::Operator), and the order of their sums.
///
/// Sums over cells follow a tree of chunks, which depends only on the rows and columns of the cells. Results are bitwise
/// identical for any number of threads and ranks that share the cells.
///
/// ```
/// use stickslip::{ElasticPair, Grid, HalfSpace, Layout, Material, Operator, influence::Component};
/// // Cells of bodies are in rows, and cells of a user-defined operator are by default in one sequence.
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
    /// Ranks that share the cells, or that all perform the same work on their own cells.
    team: Option<Arc<RankGroup>>,
}

impl Layout {
    /// Creates the layout of consecutive cells, all local.
    #[must_use]
    pub fn flat(cells: usize) -> Self {
        Self {
            cells,
            chunk: CHUNK,
            share: None,
            team: None,
        }
    }

    /// Creates the layout of a rectangle of cells, `[columns, rows]`, all local.
    pub(crate) fn of([columns, rows]: [usize; 2]) -> Self {
        Self {
            cells: columns * rows,
            chunk: chunk_of([columns, rows]),
            share: None,
            team: None,
        }
    }

    /// Creates the layout of a rectangle of cells in chunks of one row, all local.
    pub(crate) fn of_rows([columns, rows]: [usize; 2]) -> Self {
        Self {
            chunk: columns,
            ..Self::flat(columns * rows)
        }
    }

    /// Creates the layout of the local part of a partition.
    pub(crate) fn shared(share: Arc<RowPartition>) -> Self {
        Self {
            cells: share.cells(),
            chunk: share.chunk(),
            team: Some(Arc::clone(share.team())),
            share: Some(share),
        }
    }

    /// Returns the layout of the same cells with a team. The team shares the cells, or each of its ranks has all cells and
    /// performs the same work.
    pub(crate) fn alike(mut self, team: Option<&Arc<RankGroup>>) -> Self {
        self.team = team.cloned();
        self
    }

    /// Returns the number of local cells.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.cells
    }

    /// Returns the number of cells of all ranks together.
    pub(crate) fn of_all_ranks(&self) -> usize {
        match &self.share {
            Some(share) => share.size().into_iter().product(),
            None => self.cells,
        }
    }

    /// Returns the number of cells of a chunk. The last chunk may have fewer.
    pub(crate) fn chunk(&self) -> usize {
        self.chunk
    }

    /// Returns the number of local chunks.
    pub(crate) fn tasks(&self) -> usize {
        self.cells.div_ceil(self.chunk)
    }

    /// Returns the cells of a chunk.
    pub(crate) fn range(&self, task: usize) -> Range<usize> {
        task * self.chunk..((task + 1) * self.chunk).min(self.cells)
    }

    /// Returns the local result of a step that every rank takes, or an error if the step failed on any rank. The call is
    /// collective.
    pub(crate) fn collective_result<T>(&self, result: Result<T>) -> Result<T> {
        RankGroup::agreed_of(self.team.as_deref(), result)
    }

    /// Reduces the values of all ranks that share the cells.
    pub(crate) fn combined<T: WireFormat>(&self, own: T, combine: impl Fn(T, T) -> T) -> T {
        let team = self.share.as_ref().map(|share| &**share.team());
        RankGroup::combined_of(team, own, combine)
    }

    /// Returns an error with the name `quantity` if there are ranks. Features that ranks do not support call this function.
    pub(crate) fn check_alone(&self, quantity: &'static str) -> Result<()> {
        RankGroup::check_alone(self.team.as_deref(), quantity)
    }

    /// Returns the decision of the first rank about continuing, for all ranks. Ranks that have lost each other report a stall.
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

    /// Returns an error if the ranks have lost each other.
    pub(crate) fn check(&self) -> Result<()> {
        self.team.as_ref().map_or(Ok(()), |team| team.check())
    }

    /// Returns a vector with up to `reach` rows of other ranks before and after the local rows. The call is collective.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if the vector cannot be allocated.
    /// - [`Error::Ranks`](crate::Error::Ranks) if the vector of another rank cannot be allocated.
    pub(crate) fn with_halo<'a>(&self, local: &'a [f64], reach: usize) -> Result<Halo<'a>> {
        let Some(share) = &self.share else {
            return Ok(Halo {
                values: Cow::Borrowed(local),
                before: 0,
            });
        };
        let [columns, rows] = share.size();
        let wider = |rank: usize| match share.rows_of(rank) {
            own if own.is_empty() => own,
            own => own.start.saturating_sub(reach)..(own.end + reach).min(rows),
        };
        let before = share.local_rows().start - wider(share.team().rank()).start;
        let values = share.fetch(local, columns, |rank| [0..columns, wider(rank)])?;
        Ok(Halo {
            values: Cow::Owned(values),
            before: before * columns,
        })
    }

    /// Splits a slice with one entry per cell into chunks.
    pub(crate) fn blocks<'a, T>(&self, items: &'a mut [T]) -> Blocks<'a, T> {
        Blocks {
            items,
            width: self.chunk,
        }
    }

    /// Calls `work(chunk, its part of data)` for all local chunks and combines the results of all ranks pairwise in the tree.
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
            // A rank without cells has nothing to compute.
            _ if self.tasks() == 0 => T::ZERO,
            _ => parallel::sweep_cells(self.cells, 0..self.tasks(), data, work, combine),
        }
    }

    /// Computes the values of the nodes of the tree that are local, for any type.
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

    /// Computes the value of the whole tree from the values of [`Layout::at_nodes`].
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

    /// Combines read-only results of ranges of cells, like [`Layout::sweep`].
    pub(crate) fn fold<T: WireFormat>(
        &self,
        leaf: impl Fn(Range<usize>) -> T + Sync,
        combine: impl Fn(T, T) -> T + Sync,
    ) -> T {
        self.sweep((), |task, ()| leaf(self.range(task)), combine)
    }
}

/// Local values and the values of the adjacent rows of other ranks.
pub(crate) struct Halo<'a> {
    pub(crate) values: Cow<'a, [f64]>,
    /// Number of values before the first local value.
    pub(crate) before: usize,
}

/// Returns the number of cells of a chunk: whole rows, or equal pieces of a long row, about [`CHUNK`] cells. A single row may be
/// cut anywhere.
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
            // A prime number of columns cannot be divided into equal pieces.
            ([4099, 2], 4096),
        ] {
            assert_eq!(chunk_of(size), chunk);
        }
    }
}
