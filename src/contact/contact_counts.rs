//! Counts of a contact map. They are computed in strips of rows, which are joined over threads and ranks.

use std::array::from_fn;
use std::ops::Range;

use crate::contact::map::ContactMap;
use crate::parallel;
use crate::parallel::ranks::{RankGroup, WireFormat};
use crate::warning::RESOLVED;

/// Counts of a contact map.
#[derive(Debug, Clone, Copy, PartialEq)]
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

/// Counts of adjacent rows of a map, with the runs and spots for joining the rows with other rows.
#[derive(Debug, Clone, Default)]
struct Strip {
    rows: usize,
    cells: usize,
    switches: usize,
    cells_on_edge: usize,
    /// One bit per column, which is set if the column has a cell.
    columns: Vec<u64>,
    /// Numbers of rows without a cell. They count the rows below the first row with a cell, the rows above the last row with a
    /// cell, and the longest run between these two rows.
    free: [usize; 3],
    /// Runs of the first row and of the last row.
    ends: [Vec<RowSegment>; 2],
    /// Spots of the first row or the last row.
    open: Vec<PartialSpot>,
    /// Counts of all other spots.
    closed: Spots,
}

/// Run of adjacent cells of a row that belong to one spot.
#[derive(Debug, Clone)]
struct RowSegment {
    columns: Range<usize>,
    spot: usize,
}

/// Partial counts of a spot.
#[derive(Debug, Clone, Copy, Default)]
struct PartialSpot {
    cells: usize,
    /// Whether the spot touches the first and the last column, and the first and the last row.
    edges: [[bool; 2]; 2],
}

/// Header of a strip in a message. It contains counts of cells, numbers of rows without a cell and counts of closed spots. It
/// also contains the numbers of runs at both ends and of open spots that follow the header.
type StripHeader = (
    [usize; 4],
    [usize; 3],
    (usize, [usize; 2], [bool; 2]),
    [usize; 3],
);

impl<F: Fn(usize) -> bool + Sync> ContactMap<'_, F> {
    /// Computes all counts, over all ranks if the map of each rank is its slab.
    pub(crate) fn survey(&self, team: Option<&RankGroup>) -> ContactCounts {
        let [columns, rows] = self.grid.size();
        let mut slab = parallel::fold_rows(
            rows,
            columns,
            |rows| {
                let strips = rows.map(|row| self.strip_of(row));
                strips.fold(Strip::default(), Strip::joined)
            },
            Strip::joined,
        );
        slab.cells_on_edge = self.cells_on_edge();
        let Some(team) = team else {
            return slab.survey(columns, self.repeats);
        };
        let whole = over_ranks(slab, columns, team);
        whole.survey(columns, self.repeats).of_first(team)
    }

    fn strip_of(&self, row: usize) -> Strip {
        let (nx, along_x) = (self.grid.nx(), self.repeats[0]);
        let (all_rows, number) = (self.grid.whole().ny(), self.grid.rows().start + row);
        let is_end = [number == 0, number + 1 == all_rows];
        let mut strip = Strip {
            rows: 1,
            columns: vec![0; nx.div_ceil(64)],
            ..Strip::default()
        };
        let mut runs: Vec<RowSegment> = Vec::new();
        for column in (0..nx).filter(|column| (self.contains)(row * nx + column)) {
            strip.cells += 1;
            strip.columns[column / 64] |= 1 << (column % 64);
            match runs.last_mut() {
                Some(run) if run.columns.end == column => run.columns.end += 1,
                _ => runs.push(RowSegment {
                    columns: column..column + 1,
                    spot: runs.len(),
                }),
            }
        }
        let ends = |runs: &[RowSegment]| {
            let (first, last) = (runs.first()?, runs.last()?);
            Some([first.columns.start == 0, last.columns.end == nx])
        };
        let [at_first, at_last] = ends(&runs).unwrap_or_default();
        let within = 2 * runs.len() - usize::from(at_first) - usize::from(at_last);
        strip.switches = within + usize::from(along_x && at_first != at_last);
        let count = if along_x && at_first && at_last && runs.len() > 1 {
            // The last run and the first run are one run across the periodic edge.
            if let Some(last) = runs.last_mut() {
                last.spot = 0;
            }
            runs.len() - 1
        } else {
            runs.len()
        };
        strip.open = vec![PartialSpot::default(); count];
        for run in &runs {
            let spot = &mut strip.open[run.spot];
            spot.cells += run.columns.len();
            spot.edges[0][0] |= run.columns.start == 0;
            spot.edges[0][1] |= run.columns.end == nx;
            spot.edges[1] = is_end;
        }
        strip.free = [usize::from(runs.is_empty()), 0, 0];
        strip.ends = [runs.clone(), runs];
        strip
    }
}

impl Strip {
    /// Joins the strip with the rows above it.
    fn joined(self, mut above: Self) -> Self {
        if self.rows == 0 {
            return above;
        }
        if above.rows == 0 {
            return self;
        }
        let mut strip = Self {
            rows: self.rows + above.rows,
            cells: self.cells + above.cells,
            switches: self.switches + above.switches,
            cells_on_edge: self.cells_on_edge + above.cells_on_edge,
            closed: self.closed.plus(above.closed),
            columns: self.columns,
            ..Self::default()
        };
        for (columns, above) in strip.columns.iter_mut().zip(&above.columns) {
            *columns |= above;
        }
        let ([first, last, within], [first_above, last_above, within_above]) =
            (self.free, above.free);
        strip.free = match (self.cells, above.cells) {
            (0, 0) => [first + first_above, 0, 0],
            (0, _) => [first + first_above, last_above, within_above],
            (_, 0) => [first, last + first_above, within],
            _ => [
                first,
                last_above,
                within.max(last + first_above).max(within_above),
            ],
        };
        let ([bottom, below], [over, top]) = (self.ends, &mut above.ends);
        let mut spots = Joined::new([self.open, above.open]);
        for run in over.iter_mut().chain(top.iter_mut()) {
            run.spot += spots.second;
        }
        strip.switches += spots.join(&below, over);
        strip.ends = [bottom, std::mem::take(top)];
        strip.close(spots);
        strip
    }

    /// Keeps the spots of the end rows, and counts the other spots as closed.
    fn close(&mut self, mut joined: Joined) {
        let mut places = vec![None; joined.spots.len()];
        for run in self.ends.iter_mut().flatten() {
            let root = joined.root(run.spot);
            run.spot = *places[root].get_or_insert_with(|| {
                self.open.push(joined.spots[root]);
                self.open.len() - 1
            });
        }
        for (spot, place) in places.iter().enumerate() {
            if joined.root(spot) == spot && place.is_none() {
                self.closed.add(&joined.spots[spot]);
            }
        }
    }

    /// Returns the counts of a strip with all rows.
    fn survey(mut self, width: usize, [along_x, along_y]: [bool; 2]) -> ContactCounts {
        let [bottom, top] = std::mem::take(&mut self.ends);
        let mut spots = Joined::new([std::mem::take(&mut self.open), Vec::new()]);
        if along_y {
            self.switches += spots.join(&top, &bottom);
        }
        self.close(spots);
        let extent = (self.cells > 0).then(|| {
            let columns = span(width, self.free_columns(width), along_x);
            [columns, span(self.rows, self.free, along_y)]
        });
        ContactCounts {
            cells: self.cells,
            switches: self.switches,
            cells_on_edge: self.cells_on_edge,
            extent,
            spots: self.closed,
        }
    }

    /// Returns the numbers of columns without a cell, in the format of the numbers of rows.
    fn free_columns(&self, width: usize) -> [usize; 3] {
        let is_taken = |column: &usize| (self.columns[column / 64] >> (column % 64)) & 1 != 0;
        let taken: Vec<usize> = (0..width).filter(is_taken).collect();
        let within = taken.windows(2).map(|pair| pair[1] - pair[0] - 1).max();
        let [first, last] =
            [taken.first(), taken.last()].map(|column| column.copied().unwrap_or(0));
        [first, width - 1 - last, within.unwrap_or(0)]
    }

    fn write(&self, width: usize, words: &mut Vec<u64>) {
        let closed = self.closed;
        let head: StripHeader = (
            [self.rows, self.cells, self.switches, self.cells_on_edge],
            self.free,
            (
                closed.all,
                [closed.unresolved, closed.unresolved_cells],
                closed.is_across,
            ),
            [self.ends[0].len(), self.ends[1].len(), self.open.len()],
        );
        head.write(words);
        let columns = (0..width.div_ceil(64)).map(|word| self.columns.get(word).copied());
        words.extend(columns.map(|word| word.unwrap_or(0)));
        for run in self.ends.iter().flatten() {
            [run.columns.start, run.columns.end, run.spot].write(words);
        }
        for spot in &self.open {
            (spot.cells, spot.edges).write(words);
        }
    }

    /// Reads a strip with `width` columns. Returns `None` if the words are not a valid strip.
    fn read(mut words: &[u64], width: usize) -> Option<Self> {
        let words = &mut words;
        let columns = width.div_ceil(64);
        let rest = words.len().checked_sub(StripHeader::COUNT + columns)?;
        let ([rows, cells, switches, cells_on_edge], free, closed, lengths) =
            StripHeader::read(words);
        let (all, [unresolved, unresolved_cells], is_across) = closed;
        let [.., open] = lengths;
        let sizes = [3, 3, <(usize, [[bool; 2]; 2])>::COUNT];
        let wanted = lengths
            .iter()
            .zip(sizes)
            .try_fold(0_usize, |sum, (count, size)| {
                sum.checked_add(count.checked_mul(size)?)
            });
        if wanted != Some(rest) {
            return None;
        }
        let columns = (0..columns).map(|_| u64::read(words)).collect();
        let mut run = || {
            let [start, end, spot] = WireFormat::read(words);
            (spot < open).then_some(RowSegment {
                columns: start..end,
                spot,
            })
        };
        let mut end = |count| (0..count).map(|_| run()).collect::<Option<_>>();
        let ends = [end(lengths[0])?, end(lengths[1])?];
        let spot = |_| {
            let (cells, edges) = WireFormat::read(words);
            PartialSpot { cells, edges }
        };
        Some(Self {
            rows,
            cells,
            switches,
            cells_on_edge,
            columns,
            free,
            ends,
            open: (0..open).map(spot).collect(),
            closed: Spots {
                all,
                unresolved,
                unresolved_cells,
                is_across,
            },
        })
    }
}

impl Spots {
    fn plus(self, other: Self) -> Self {
        Self {
            all: self.all + other.all,
            unresolved: self.unresolved + other.unresolved,
            unresolved_cells: self.unresolved_cells + other.unresolved_cells,
            is_across: from_fn(|axis| self.is_across[axis] || other.is_across[axis]),
        }
    }

    fn add(&mut self, spot: &PartialSpot) {
        self.all += 1;
        if spot.cells < RESOLVED {
            self.unresolved += 1;
            self.unresolved_cells += spot.cells;
        }
        for (is_across, edges) in self.is_across.iter_mut().zip(spot.edges) {
            *is_across |= edges == [true; 2];
        }
    }
}

/// Disjoint sets of spots that turn out to be connected.
struct Joined {
    spots: Vec<PartialSpot>,
    parents: Vec<usize>,
    /// Index of the first spot of the second strip.
    second: usize,
}

impl Joined {
    fn new([mut spots, above]: [Vec<PartialSpot>; 2]) -> Self {
        let second = spots.len();
        spots.extend(above);
        Self {
            parents: (0..spots.len()).collect(),
            spots,
            second,
        }
    }

    fn root(&mut self, spot: usize) -> usize {
        let mut root = spot;
        while self.parents[root] != root {
            self.parents[root] = self.parents[self.parents[root]];
            root = self.parents[root];
        }
        root
    }

    /// Joins the spots of two adjacent rows. Returns the number of columns in which the rows differ.
    fn join(&mut self, below: &[RowSegment], above: &[RowSegment]) -> usize {
        let length =
            |runs: &[RowSegment]| -> usize { runs.iter().map(|run| run.columns.len()).sum() };
        let (mut common, mut next) = (0, 0);
        for run in below {
            while next < above.len() && above[next].columns.end <= run.columns.start {
                next += 1;
            }
            for over in &above[next..] {
                if over.columns.start >= run.columns.end {
                    break;
                }
                let end = run.columns.end.min(over.columns.end);
                common += end - run.columns.start.max(over.columns.start);
                let [one, other] = [run.spot, over.spot].map(|spot| self.root(spot));
                if one != other {
                    let (low, high) = (one.min(other), one.max(other));
                    self.parents[high] = low;
                    let joined = self.spots[high];
                    let spot = &mut self.spots[low];
                    spot.cells += joined.cells;
                    for (edges, joined) in spot
                        .edges
                        .as_flattened_mut()
                        .iter_mut()
                        .zip(joined.edges.as_flattened())
                    {
                        *edges |= joined;
                    }
                }
            }
        }
        length(below) + length(above) - 2 * common
    }
}

/// Returns the number of positions from the first occupied position to the last. On a periodic axis, returns the number of
/// positions outside the longest free run.
fn span(count: usize, [first, last, within]: [usize; 3], repeats: bool) -> usize {
    if repeats {
        count - within.max(first + last)
    } else {
        count - first - last
    }
}

/// Joins the strips of all ranks into one strip on the first rank. Other ranks keep the partial strip that they have sent. Each
/// step halves the number of strips, and messages contain only the ends of the strips.
fn over_ranks(slab: Strip, width: usize, team: &RankGroup) -> Strip {
    let (me, ranks) = (team.rank(), team.size());
    let (mut strip, mut step) = (slab, 1);
    while step < ranks {
        let mut blocks = vec![Vec::new(); ranks];
        let mut is_expected = vec![false; ranks];
        let place = me % (2 * step);
        if place == step {
            strip.write(width, &mut blocks[me - step]);
        } else if place == 0 && me + step < ranks {
            is_expected[me + step] = true;
        }
        let received = team.all_to_all(blocks, &is_expected);
        if place == 0 && me + step < ranks {
            match Strip::read(&received[me + step], width) {
                Some(above) => strip = strip.joined(above),
                None => team.out_of_step(me + step),
            }
        }
        step *= 2;
    }
    strip
}

/// Message with the counts of a survey.
type Counts = (
    (usize, usize, usize),
    Option<[usize; 2]>,
    (usize, [usize; 2], [bool; 2]),
);

impl ContactCounts {
    /// Returns the counts of the first rank on all ranks.
    fn of_first(self, team: &RankGroup) -> Self {
        let found = self.spots;
        let (counts, extent, spots): Counts = team.of_first((
            (self.cells, self.switches, self.cells_on_edge),
            self.extent,
            (
                found.all,
                [found.unresolved, found.unresolved_cells],
                found.is_across,
            ),
        ));
        Self {
            cells: counts.0,
            switches: counts.1,
            cells_on_edge: counts.2,
            extent,
            spots: Spots {
                all: spots.0,
                unresolved: spots.1[0],
                unresolved_cells: spots.1[1],
                is_across: spots.2,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;
    use std::time::Duration;

    use super::*;
    use crate::grid::Grid;
    use crate::parallel::ranks::{Ranks, Threads};

    /// Distributes random maps over ranks, including slabs of one row and of no row. The counts of the ranks equal the counts of
    /// one process. Its spots equal the spots found by a walk from cell to cell.
    #[test]
    fn slabs_come_to_what_the_whole_comes_to() {
        let mut random = 1_u64;
        for (nx, ny) in [(70, 40), (9, 9), (1, 12), (12, 1), (2, 2), (130, 7)] {
            for percent in [3, 40, 60, 90] {
                let cells: Vec<bool> = (0..nx * ny)
                    .map(|_| {
                        random = random
                            .wrapping_mul(6_364_136_223_846_793_005)
                            .wrapping_add(1_442_695_040_888_963_407);
                        (random >> 33) % 100 < percent
                    })
                    .collect();
                for repeats in [[false; 2], [true; 2], [true, false], [false, true]] {
                    let grid = Grid::new(nx, ny, 1.0, 1.0).unwrap();
                    let map = |grid: Grid| {
                        let (first, cells) = (grid.rows().start * nx, &cells);
                        ContactMap {
                            grid,
                            repeats,
                            contains: move |i: usize| cells[first + i],
                            counted: None,
                        }
                    };
                    let whole = map(grid).survey(None);
                    let mut sizes = Vec::new();
                    map(grid)
                        .walk_spots(|spot, _| {
                            sizes.resize(sizes.len().max(spot + 1), 0);
                            sizes[spot] += 1;
                            Ok(())
                        })
                        .unwrap();
                    let unresolved = sizes.iter().filter(|size| **size < RESOLVED).count();
                    assert_eq!(whole.spots.all, sizes.len());
                    assert_eq!(whole.spots.unresolved, unresolved);
                    assert_eq!(whole.cells, sizes.iter().sum::<usize>());
                    assert_eq!(whole.switches, map(grid).switches());
                    for ranks in [2, 3, 5] {
                        let found = Threads::run(ranks, Duration::from_secs(60), |rank| {
                            // The first rank has no row, and the second rank has at most one row.
                            let end = |rank: usize| match rank {
                                0 | 1 if rank < ranks => 0,
                                2 if rank < ranks => 1,
                                _ => (ny * (rank - 1) / (ranks - 1)).max(1),
                            };
                            let slab = grid.slab(end(rank.rank())..end(rank.rank() + 1));
                            map(slab).survey(Some(&RankGroup::new(Arc::new(rank))))
                        });
                        assert!(
                            found.iter().all(|found| *found == whole),
                            "{found:?} {whole:?}"
                        );
                    }
                }
            }
        }
    }
}
