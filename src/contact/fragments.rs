//! Connected parts of a contact map. The local rows are divided into fragments, which are then joined across the ends of slabs
//! and the edges of a periodic grid.

use std::sync::Arc;

use crate::contact::map::ContactMap;
use crate::error::Result;
use crate::grid::Grid;
use crate::memory::fallible;
use crate::numerics::cell_vector::{minus, plus};
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::RowPartition;
use crate::parallel::ranks::{RankGroup, WireFormat};

/// Sums over cells. They use integer arithmetic and are therefore bitwise identical for any order of the cells.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct SpotSums {
    pub(crate) cells: usize,
    pub(crate) stick: usize,
    /// Numbers of cell sides along y and along x at which the contact ends.
    pub(crate) open_sides: [usize; 2],
    /// Numbers of cells in the first and the last column, and in the first and the last row of the whole grid.
    pub(crate) at_edges: [[usize; 2]; 2],
    /// Sums of the columns and of the rows, counted from the first column and row of the whole grid. Sums below 2^53 are exact.
    pub(crate) place: [f64; 2],
    /// Sum of the pressure, in fractions of a unit.
    pub(crate) parts: u128,
    /// Largest pressure.
    pub(crate) largest: f64,
}

impl SpotSums {
    /// Adds the sums of other cells. Their columns and rows are shifted by `beyond` from the positions at which they were
    /// counted.
    fn add(&mut self, other: &Self, beyond: [f64; 2]) {
        self.cells += other.cells;
        self.stick += other.stick;
        self.parts += other.parts;
        self.largest = self.largest.max(other.largest);
        for (axis, beyond) in beyond.into_iter().enumerate() {
            self.open_sides[axis] += other.open_sides[axis];
            self.place[axis] += other.place[axis] + beyond * other.cells as f64;
            for end in [0, 1] {
                self.at_edges[axis][end] += other.at_edges[axis][end];
            }
        }
    }
}

/// Sums as sent in a message, with the pressure split into two halves.
type SpotMessage = ([[usize; 2]; 4], [f64; 3], [u64; 2]);

impl WireFormat for SpotSums {
    const COUNT: usize = SpotMessage::COUNT;
    const ZERO: Self = Self {
        cells: 0,
        stick: 0,
        open_sides: [0; 2],
        at_edges: [[0; 2]; 2],
        place: [0.0; 2],
        parts: 0,
        largest: 0.0,
    };

    #[expect(clippy::cast_possible_truncation, reason = "one half and the other")]
    fn write(self, words: &mut Vec<u64>) {
        let ([columns, rows], [x, y]) = (self.at_edges, self.place);
        let halves = [self.parts as u64, (self.parts >> 64) as u64];
        let counts = [[self.cells, self.stick], self.open_sides, columns, rows];
        (counts, [x, y, self.largest], halves).write(words);
    }

    fn read(words: &mut &[u64]) -> Self {
        let (counts, [x, y, largest], [low, high]) = SpotMessage::read(words);
        let [[cells, stick], open_sides, columns, rows] = counts;
        Self {
            cells,
            stick,
            open_sides,
            at_edges: [columns, rows],
            place: [x, y],
            parts: u128::from(low) | u128::from(high) << 64,
            largest,
        }
    }
}

/// Fragments of the spots in the local rows, cut at the ends of the slab and at the edges of the grid.
pub(crate) struct Fragments<'a> {
    grid: Grid,
    repeats: [bool; 2],
    share: Option<&'a Arc<RowPartition>>,
    layout: Layout,
    /// Number of the fragment of every local cell, counted from one, or zero outside the contact.
    pub(crate) labels: Vec<u32>,
    sums: Vec<SpotSums>,
}

/// Type of a link across the end of a slab.
const SLABS: usize = 0;
/// Type of a link across the edge of the grid in x.
const EDGE_X: usize = 1;
/// Type of a link across the edge of the grid in y.
const EDGE_Y: usize = 2;

/// Link between two fragments. The second fragment starts where the first fragment ends. The first pair contains the numbers of
/// the fragments among the fragments of all ranks. The second pair contains the type of the link and the number of adjacent pairs
/// of cells.
type Link = ([usize; 2], (usize, usize));

impl<'a> Fragments<'a> {
    /// Finds the fragments of the local rows of a map. `share` is the partition of the rows over ranks. `of_cell` returns the
    /// zone and the pressure of a cell in the contact.
    pub(crate) fn of(
        map: &ContactMap<'_, impl Fn(usize) -> bool + Sync>,
        share: Option<&'a Arc<RowPartition>>,
        of_cell: impl Fn(usize) -> SpotSums,
    ) -> Result<Self> {
        let (grid, layout) = (map.grid, layout_of(map.grid, share));
        let found = layout.collective_result(labelled(map, of_cell))?;
        Ok(Self {
            grid,
            repeats: map.repeats,
            share,
            layout,
            labels: found.0,
            sums: found.1,
        })
    }

    /// Removes the fragments that no fragment of another rank can meet, and returns their sums. Without ranks, removes no
    /// fragment.
    pub(crate) fn take_closed(&mut self) -> Result<Vec<SpotSums>> {
        let (mut open, mut closed) = (Vec::new(), Vec::new());
        if self.share.is_none() {
            return Ok(closed);
        }
        let nx = self.grid.nx();
        let mut numbers: Vec<u32> = fallible::filled(0, self.sums.len())?;
        let rows = self.labels.chunks_exact(nx);
        let [first, last] = [rows.clone().next(), rows.clone().next_back()];
        let columns = rows
            .filter(|_| self.repeats[0])
            .flat_map(|row| [&row[0], &row[nx - 1]]);
        let ends = first.into_iter().chain(last).flatten().chain(columns);
        for label in ends.filter(|label| **label > 0) {
            numbers[*label as usize - 1] = 1;
        }
        for (sums, number) in self.sums.iter().zip(&mut numbers) {
            let is_open = *number > 0;
            if is_open {
                *number = label(open.len());
            }
            fallible::push(if is_open { &mut open } else { &mut closed }, *sums)?;
        }
        renumber(&mut self.labels, &numbers);
        self.sums = open;
        Ok(closed)
    }

    /// Joins the fragments. Returns the number of the spot of every local cell, counted from one. Also returns the sums of all
    /// spots, in the order of their first cells.
    pub(crate) fn joined(mut self) -> Result<(Vec<u32>, Vec<SpotSums>)> {
        let team = self.share.map(|share| &**share.team());
        let own = std::mem::take(&mut self.sums);
        let (mut fragments, lengths) = RankGroup::gathered_of(team, own)?;
        let before = team.map_or(0, RankGroup::rank);
        let first: usize = lengths.iter().take(before).sum();
        let below = self.row_below(first, fragments.len());
        let links = self.layout.collective_result(self.links(first, &below))?;
        let (mut links, _) = RankGroup::gathered_of(team, links)?;
        // If a spot closes around the grid, the order of the links determines the counting direction of the positions of its
        // cells.
        links.sort_by_key(|(_, (across, _))| *across);
        let whole = self.grid.whole().size().map(|count| count as f64);
        let mut join = || {
            let alone = (0..fragments.len()).map(|fragment| (fragment, [0.0; 2]));
            let mut sets = DisjointSets(fallible::collected(fragments.len(), alone)?);
            for (ends, (across, pairs)) in &links {
                let beyond = match *across {
                    EDGE_X => [whole[0], 0.0],
                    EDGE_Y => [0.0, whole[1]],
                    _ => [0.0; 2],
                };
                sets.join(*ends, beyond);
                for end in ends {
                    fragments[*end].open_sides[usize::from(*across != EDGE_X)] -= pairs;
                }
            }
            sets.sums(&fragments)
        };
        let (spots, sums) = self.layout.collective_result(join())?;
        renumber(&mut self.labels, spots.get(first..).unwrap_or(&[]));
        Ok((self.labels, sums))
    }

    /// Returns the links across the edge in x, and to the row below the first local row.
    fn links(&self, first: usize, below: &[u64]) -> Result<Vec<Link>> {
        let mut links: Vec<Link> = Vec::new();
        let mut link = |across: usize, one: Option<usize>, other: Option<usize>| {
            let Some((one, other)) = one.zip(other) else {
                return Ok(());
            };
            let ends = [one, other];
            match links.last_mut() {
                Some((last, (over, pairs))) if (*last, *over) == (ends, across) => *pairs += 1,
                _ => fallible::push(&mut links, (ends, (across, 1)))?,
            }
            Ok(())
        };
        let nx = self.grid.nx();
        let own = |label: u32| Some(first + (label as usize).checked_sub(1)?);
        for row in self.labels.chunks_exact(nx).filter(|_| self.repeats[0]) {
            link(EDGE_X, own(row[nx - 1]), own(row[0]))?;
        }
        let is_edge = self.grid.rows().start == 0;
        let across = if is_edge { EDGE_Y } else { SLABS };
        for (below, label) in below.iter().zip(&self.labels) {
            let below = usize::try_from(*below).unwrap_or(0);
            link(across, below.checked_sub(1), own(*label))?;
        }
        Ok(links)
    }

    /// Returns the numbers of the fragments in the row below the first local row, which may be on another rank. The numbers count
    /// the fragments of all ranks from one. The list is empty below the first row of a grid that is not periodic.
    fn row_below(&self, first: usize, fragments: usize) -> Vec<u64> {
        let (nx, repeats) = (self.grid.nx(), self.repeats[1]);
        let last = self.labels.chunks_exact(nx).next_back().unwrap_or(&[]);
        let top = |label: &u32| match *label {
            0 => 0,
            label => first as u64 + u64::from(label),
        };
        let mut top: Vec<u64> = last.iter().map(top).collect();
        let Some(share) = self.share else {
            top.truncate(if repeats { nx } else { 0 });
            return top;
        };
        let team = share.team();
        let (me, ranks) = (team.rank(), team.size());
        let holds = |rank: &usize| !share.rows_of(*rank).is_empty();
        let above = (me + 1..ranks).chain(0..=me).find(holds);
        let below = (0..me).rev().chain((me..ranks).rev()).find(holds);
        let (mut blocks, mut is_expected) = (vec![Vec::new(); ranks], vec![false; ranks]);
        let taker = above.filter(|rank| holds(&me) && (repeats || *rank > me));
        if let Some(taker) = taker {
            blocks[taker] = top;
        }
        let sender = below.filter(|rank| holds(&me) && (repeats || *rank < me));
        let Some(sender) = sender else {
            team.all_to_all(blocks, &is_expected);
            return Vec::new();
        };
        // A rank that has all rows keeps the row and sends no message.
        let own = std::mem::take(&mut blocks[me]);
        is_expected[sender] = sender != me;
        let mut received = team.all_to_all(blocks, &is_expected);
        if sender == me {
            return own;
        }
        let row = std::mem::take(&mut received[sender]);
        if row.len() == nx && row.iter().all(|number| *number <= fragments as u64) {
            return row;
        }
        team.out_of_step(sender);
        Vec::new()
    }
}

/// Returns the layout of the local cells of a grid.
pub(crate) fn layout_of(grid: Grid, share: Option<&Arc<RowPartition>>) -> Layout {
    match share {
        Some(share) => Layout::shared(Arc::clone(share)),
        None => Layout::of(grid.size()),
    }
}

/// Returns the number of the fragment of every local cell, counted from one, and the sums of the fragments. Each cell joins the
/// fragments of its neighbours to the left and below.
fn labelled(
    map: &ContactMap<'_, impl Fn(usize) -> bool + Sync>,
    of_cell: impl Fn(usize) -> SpotSums,
) -> Result<(Vec<u32>, Vec<SpotSums>)> {
    let (nx, whole) = (map.grid.nx(), map.grid.whole().size());
    let mut labels: Vec<u32> = fallible::filled(0, map.grid.cells())?;
    let (mut sets, mut sums) = (DisjointSets(Vec::new()), Vec::new());
    for (start, row) in (0..labels.len()).step_by(nx).zip(map.grid.rows()) {
        for column in (0..nx).filter(|column| (map.contains)(start + column)) {
            let cell = start + column;
            let left = if column > 0 { labels[cell - 1] } else { 0 };
            let below = if start > 0 { labels[cell - nx] } else { 0 };
            let fragment = match [left, below].map(|label| (label as usize).checked_sub(1)) {
                [Some(left), Some(below)] => {
                    if left != below {
                        sets.join([below, left], [0.0; 2]);
                    }
                    left
                }
                [Some(fragment), None] | [None, Some(fragment)] => fragment,
                [None, None] => {
                    fallible::push(&mut sets.0, (sums.len(), [0.0; 2]))?;
                    fallible::push(&mut sums, SpotSums::default())?;
                    sums.len() - 1
                }
            };
            labels[cell] = label(fragment);
            // A side between two cells of the contact is open for neither cell.
            let open = |neighbour: u32| if neighbour > 0 { 0 } else { 2 };
            let ends =
                |place: usize, count: usize| [place == 0, place + 1 == count].map(usize::from);
            let own = SpotSums {
                cells: 1,
                open_sides: [open(left), open(below)],
                at_edges: [ends(column, whole[0]), ends(row, whole[1])],
                place: [column as f64, row as f64],
                ..of_cell(cell)
            };
            sums[fragment].add(&own, [0.0; 2]);
        }
    }
    let (numbers, sums) = sets.sums(&sums)?;
    renumber(&mut labels, &numbers);
    Ok((labels, sums))
}

/// Returns the label of a fragment or spot, counted from one.
fn label(number: usize) -> u32 {
    u32::try_from(number + 1).unwrap_or(u32::MAX)
}

/// Replaces each label by the number of its fragment.
fn renumber(labels: &mut [u32], numbers: &[u32]) {
    for label in labels.iter_mut().filter(|label| **label > 0) {
        *label = numbers[*label as usize - 1];
    }
}

/// Disjoint sets of fragments that form one spot. Each entry contains the parent fragment, which is the fragment itself for the
/// first fragment of a spot. It also contains the shift, in columns and rows, between the position of the fragment and its
/// position relative to the parent.
struct DisjointSets(Vec<(usize, [f64; 2])>);

impl DisjointSets {
    /// Returns the first fragment of the spot of `fragment`, and the shift of `fragment` relative to this first fragment.
    fn root(&mut self, fragment: usize) -> (usize, [f64; 2]) {
        let (mut at, mut beyond) = (fragment, [0.0; 2]);
        loop {
            let (parent, own) = self.0[at];
            if parent == at {
                return (at, beyond);
            }
            let (next, further) = self.0[parent];
            let far = plus(own, 1.0, further);
            self.0[at] = (next, far);
            (at, beyond) = (next, plus(beyond, 1.0, far));
        }
    }

    /// Joins two fragments, where the second is shifted by `beyond` relative to the first.
    fn join(&mut self, [one, other]: [usize; 2], beyond: [f64; 2]) {
        let ((one, from), (other, to)) = (self.root(one), self.root(other));
        let far = minus(plus(from, 1.0, beyond), to);
        if one < other {
            self.0[other] = (one, far);
        } else if other < one {
            self.0[one] = (other, far.map(|far| -far));
        }
    }

    /// Returns the number of the spot of every fragment, counted from one, and the sums of the spots.
    fn sums(mut self, fragments: &[SpotSums]) -> Result<(Vec<u32>, Vec<SpotSums>)> {
        let (mut spots, mut sums) = (fallible::with_room(fragments.len())?, Vec::new());
        for (fragment, own) in fragments.iter().enumerate() {
            let (root, beyond) = self.root(fragment);
            if root == fragment {
                spots.push(label(sums.len()));
                fallible::push(&mut sums, SpotSums::default())?;
            } else {
                spots.push(spots[root]);
            }
            sums[spots[fragment] as usize - 1].add(own, beyond);
        }
        Ok((spots, sums))
    }
}
