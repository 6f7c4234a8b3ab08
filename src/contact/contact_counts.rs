//! Counts of a contact map, over all ranks.

use std::array::from_fn;
use std::sync::Arc;

use crate::contact::fragments::{Fragments, SpotSums, layout_of};
use crate::contact::map::ContactMap;
use crate::error::{Error, Result};
use crate::memory::fallible;
use crate::parallel::ranks::RankGroup;
use crate::parallel::ranks::partition::RowPartition;
use crate::parallel::reduce::Reduction;
use crate::warning::RESOLVED;

/// Counts of a contact map.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct ContactCounts {
    /// Number of cells in the set.
    pub(crate) cells: usize,
    /// Number of pairs of neighbours along x or y with exactly one cell in the set.
    pub(crate) switches: usize,
    /// Number of cells of the set on the edges across which the grid is not periodic.
    pub(crate) cells_on_edge: usize,
    /// Numbers of columns and rows from the first to the last cell. On a periodic grid this range may cross the edges.
    pub(crate) extent: Option<[usize; 2]>,
    pub(crate) spots: Spots,
}

/// Counts of spots.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Spots {
    pub(crate) all: usize,
    /// Number of spots with too few cells.
    pub(crate) unresolved: usize,
    /// Number of cells of these spots.
    pub(crate) unresolved_cells: usize,
    /// Whether any spot extends from the first column to the last, and from the first row to the last.
    pub(crate) is_across: [bool; 2],
}

impl<F: Fn(usize) -> bool + Sync> ContactMap<'_, F> {
    /// Computes all counts, over all ranks if each rank stores a slab of the map. After a failure of a rank the counts are zero.
    pub(crate) fn survey(&self, share: Option<&Arc<RowPartition>>) -> Result<ContactCounts> {
        match self.try_survey(share) {
            // The solve that contains the survey returns the failure.
            Err(Error::Ranks(_)) => Ok(ContactCounts::default()),
            counts => counts,
        }
    }

    fn try_survey(&self, share: Option<&Arc<RowPartition>>) -> Result<ContactCounts> {
        let layout = layout_of(self.grid, share);
        let mut fragments = Fragments::of(self, share, |_| SpotSums::default())?;
        let (columns, rows) = layout.collective_result(taken(&fragments.labels, self.grid.nx()))?;
        let closed = layout.collective_result(fragments.take_closed())?;
        let own = closed.iter().map(|spot| self.tally(spot));
        let own = own.fold([self.cells_on_edge(), 0, 0, 0, 0, 0, 0, 0], Reduction::plus);
        let closed = layout.combined(own, Reduction::plus);
        let (_, spots) = fragments.joined()?;
        let tallies = spots.iter().map(|spot| self.tally(spot));
        let [
            cells_on_edge,
            cells,
            switches,
            all,
            unresolved,
            unresolved_cells,
            along_x,
            along_y,
        ] = tallies.fold(closed, Reduction::plus);
        let team = share.map(|share| &**share.team());
        let (columns, _) = RankGroup::gathered_of(team, columns)?;
        let (rows, _) = RankGroup::gathered_of(team, rows)?;
        let columns = (0..self.grid.nx()).map(|column| {
            let mut slabs = columns.chunks_exact(self.grid.nx().div_ceil(64));
            slabs.any(|words| words[column / 64] >> (column % 64) & 1 != 0)
        });
        let extent = span(columns, self.repeats[0]).zip(span(rows.into_iter(), self.repeats[1]));
        Ok(ContactCounts {
            cells,
            switches,
            cells_on_edge,
            extent: extent.map(<[usize; 2]>::from),
            spots: Spots {
                all,
                unresolved,
                unresolved_cells,
                is_across: [along_x > 0, along_y > 0],
            },
        })
    }

    /// Returns the contribution of a spot to the counts.
    fn tally(&self, spot: &SpotSums) -> [usize; 8] {
        let ends: [usize; 2] = from_fn(|axis| {
            let [first, last] = spot.at_edges[axis];
            if self.repeats[axis] { 0 } else { first + last }
        });
        let [along_y, along_x] = spot.open_sides;
        let [across_x, across_y] = spot
            .at_edges
            .map(|[first, last]| usize::from(first > 0 && last > 0));
        let unresolved = usize::from(spot.cells < RESOLVED);
        [
            0,
            spot.cells,
            along_y + along_x - ends[0] - ends[1],
            1,
            unresolved,
            unresolved * spot.cells,
            across_x,
            across_y,
        ]
    }
}

/// Returns one bit per column, which is set if the column contains a label. Also returns for each row of `nx` cells whether it
/// contains a label.
fn taken(labels: &[u32], nx: usize) -> Result<(Vec<u64>, Vec<bool>)> {
    // Plain loops without branches, which the compiler vectorises.
    let mut columns: Vec<u32> = fallible::filled(0, nx)?;
    let mut rows = fallible::with_room(labels.len() / nx)?;
    for row in labels.chunks_exact(nx) {
        for (column, label) in columns.iter_mut().zip(row) {
            *column |= label;
        }
        rows.push(row.iter().fold(0, |found, label| found | label) > 0);
    }
    let words = columns.chunks(64).map(|part| {
        let bits = part.iter().enumerate();
        bits.fold(0, |word, (bit, label)| word | u64::from(*label > 0) << bit)
    });
    Ok((fallible::collected(nx.div_ceil(64), words)?, rows))
}

/// Returns the number of positions from the first occupied position to the last, or `None` if no position is occupied. On a
/// periodic axis, returns the number of positions outside the longest free run.
fn span(is_taken: impl Iterator<Item = bool>, repeats: bool) -> Option<usize> {
    let (mut first, mut last, mut within, mut count) = (None, 0, 0, 0);
    for (place, is_taken) in is_taken.enumerate() {
        count = place + 1;
        if is_taken {
            if first.is_some() {
                within = within.max(place - last - 1);
            }
            first = first.or(Some(place));
            last = place;
        }
    }
    let first = first?;
    Some(if repeats {
        count - within.max(first + count - 1 - last)
    } else {
        last + 1 - first
    })
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;
    use std::time::Duration;

    use crate::bodies::material::{ElasticPair, Material};
    use crate::contact::map::ContactMap;
    use crate::grid::Grid;
    use crate::grid::boundary::Boundary;
    use crate::grid::neighbours::neighbours;
    use crate::half_space::HalfSpace;
    use crate::parallel::ranks::Threads;
    use crate::warning::RESOLVED;

    /// Returns the numbers of cells of the spots, found by walks from cell to cell.
    fn walked(grid: Grid, repeats: [bool; 2], cells: &[bool]) -> Vec<usize> {
        let (mut left, mut sizes) = (cells.to_vec(), Vec::new());
        for seed in 0..cells.len() {
            let (mut stack, mut size) = (vec![seed], 0);
            while let Some(cell) = stack.pop() {
                if std::mem::take(&mut left[cell]) {
                    size += 1;
                    let next = neighbours(cell, grid.size(), repeats);
                    stack.extend(next.into_iter().flatten());
                }
            }
            sizes.extend((size > 0).then_some(size));
        }
        sizes
    }

    /// Distributes random maps over ranks, some of which have few rows or none. The counts of the ranks equal the counts of one
    /// process. The spots of one process equal the spots found by a walk from cell to cell.
    #[test]
    fn slabs_come_to_what_the_whole_comes_to() {
        let mut random = 1_u64;
        for (nx, ny) in [
            (1400, 12),
            (70, 300),
            (9, 9),
            (1, 12),
            (12, 1),
            (2, 2),
            (2100, 7),
        ] {
            for percent in [3, 40, 60, 90] {
                let cells: Vec<bool> = (0..nx * ny)
                    .map(|_| {
                        random = random
                            .wrapping_mul(6_364_136_223_846_793_005)
                            .wrapping_add(1_442_695_040_888_963_407);
                        (random >> 33) % 100 < percent
                    })
                    .collect();
                let datum = nx as f64;
                for boundary in [
                    Boundary::NonPeriodic,
                    Boundary::Periodic,
                    Boundary::PeriodicAlongY { datum },
                ] {
                    let grid = Grid::new(nx, ny, 1.0, 1.0).unwrap();
                    let map = ContactMap {
                        grid,
                        repeats: boundary.repeats(),
                        contains: |i: usize| cells[i],
                        counted: None,
                    };
                    let whole = map.survey(None).unwrap();
                    let sizes = walked(grid, boundary.repeats(), &cells);
                    let unresolved = sizes.iter().filter(|size| **size < RESOLVED);
                    assert_eq!(whole.spots.all, sizes.len());
                    assert_eq!(whole.spots.unresolved, unresolved.clone().count());
                    assert_eq!(whole.spots.unresolved_cells, unresolved.sum::<usize>());
                    assert_eq!(whole.cells, map.cells());
                    assert_eq!(whole.switches, map.switches());
                    assert_eq!(whole.cells_on_edge, map.cells_on_edge());
                    for ranks in [2, 3, 5] {
                        let material = Material::new(1.0, 0.3).unwrap();
                        let pair = ElasticPair::new(material, Material::rigid()).unwrap();
                        let found = Threads::run(ranks, Duration::from_secs(60), |rank| {
                            let rank = Arc::new(rank);
                            let slab = HalfSpace::distributed(grid, pair, boundary, rank).unwrap();
                            let first = slab.first_cell();
                            slab.survey(|i| cells[first + i])
                        });
                        assert!(
                            found.iter().all(|found| *found == Some(whole)),
                            "{found:?} {whole:?}"
                        );
                    }
                }
            }
        }
    }
}
