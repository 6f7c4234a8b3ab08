//! Spots of distributed contacts: fragments of spots, joined across the ends of slabs and the edges of a periodic grid.

use std::sync::Arc;

use crate::error::Result;
use crate::grid::Grid;
use crate::memory::fallible;
use crate::normal::NormalSolution;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::RowPartition;
use crate::parallel::ranks::{RankGroup, WireFormat};
use crate::tangential::Zone;

/// Sums over cells. They use integer arithmetic and are therefore bitwise identical for any order of the cells.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SpotSums {
    pub(super) cells: usize,
    pub(super) stick: usize,
    /// Numbers of sides of cells along y and along x beyond which the contact ends.
    pub(super) open_sides: [usize; 2],
    /// Sums of the columns and rows, counted from the first ones of the whole grid; exact below 2^53.
    pub(super) place: [f64; 2],
    /// Sum of the pressure, in fractions of a unit.
    parts: u128,
    /// Largest pressure.
    pub(super) largest: f64,
}

/// Number of fractions per unit of the pressure. The unit is the largest power of two that is at most the largest pressure: sums
/// over 2^47 cells do not overflow.
const PARTS: f64 = (1_u128 << 80) as f64;

impl SpotSums {
    /// Returns the sum of the pressure.
    pub(super) fn pressure(&self, unit: f64) -> f64 {
        self.parts as f64 / PARTS * unit
    }

    /// Adds the sums of other cells, whose columns and rows are shifted by `beyond` from the place where they were counted.
    fn add(&mut self, other: &Self, beyond: [f64; 2]) {
        self.cells += other.cells;
        self.stick += other.stick;
        self.parts += other.parts;
        self.largest = self.largest.max(other.largest);
        for (axis, beyond) in beyond.into_iter().enumerate() {
            self.open_sides[axis] += other.open_sides[axis];
            self.place[axis] += other.place[axis] + beyond * other.cells as f64;
        }
    }
}

/// Sums as sent in a message, with the pressure split into two halves.
type FragmentMessage = ([usize; 4], [f64; 3], [u64; 2]);

impl WireFormat for SpotSums {
    const COUNT: usize = FragmentMessage::COUNT;
    const ZERO: Self = Self {
        cells: 0,
        stick: 0,
        open_sides: [0; 2],
        place: [0.0; 2],
        parts: 0,
        largest: 0.0,
    };

    #[expect(clippy::cast_possible_truncation, reason = "one half and the other")]
    fn write(self, words: &mut Vec<u64>) {
        let ([along_y, along_x], [x, y]) = (self.open_sides, self.place);
        let halves = [self.parts as u64, (self.parts >> 64) as u64];
        let counts = [self.cells, self.stick, along_y, along_x];
        (counts, [x, y, self.largest], halves).write(words);
    }

    fn read(words: &mut &[u64]) -> Self {
        let (counts, [x, y, largest], [low, high]) = FragmentMessage::read(words);
        let [cells, stick, along_y, along_x] = counts;
        Self {
            cells,
            stick,
            open_sides: [along_y, along_x],
            place: [x, y],
            parts: u128::from(low) | u128::from(high) << 64,
            largest,
        }
    }
}

/// Fragments of the spots in the local rows, cut at the ends of the slab and at the edges of the grid.
pub(super) struct Fragments<'a> {
    grid: Grid,
    repeats: [bool; 2],
    share: Option<&'a Arc<RowPartition>>,
    layout: Layout,
    /// Unit of the pressure.
    pub(super) unit: f64,
    /// Number of the fragment of every cell, counted from one; zero outside the contact.
    labels: Vec<u32>,
    sums: Vec<SpotSums>,
}

/// Place of links across the end of a slab.
const SLABS: usize = 0;
/// Place of links across the edge of the grid in x.
const EDGE_X: usize = 1;
/// Place of links across the edge of the grid in y.
const EDGE_Y: usize = 2;

/// Link of two fragments, the second of which starts where the first ends: the numbers of the fragments among the fragments of
/// all ranks, the kind of place where they meet, and the number of adjacent pairs of cells.
type Link = ([usize; 2], (usize, usize));

impl<'a> Fragments<'a> {
    pub(super) fn of(normal: &'a NormalSolution, zones: Option<&[Zone]>) -> Result<Self> {
        let (grid, pressure) = (normal.grid(), normal.pressure().as_slice());
        let share = normal.share();
        let layout = match share {
            Some(share) => Layout::shared(Arc::clone(share)),
            None => Layout::of(grid.size()),
        };
        let largest = layout.combined(normal.pressure().max().max(0.0), f64::max);
        let power = f64::from_bits(largest.to_bits() & (0x7ff << 52));
        let unit = power.max(f64::MIN_POSITIVE);
        let walk = || {
            let map = normal.own_map();
            let (mut labels, mut sums) = (fallible::filled(0, grid.cells())?, Vec::new());
            map.walk_spots(|fragment, cell| {
                labels[cell] = label(fragment);
                if sums.len() <= fragment {
                    fallible::push(&mut sums, SpotSums::default())?;
                }
                let (column, row) = (cell % grid.nx(), grid.rows().start + cell / grid.nx());
                let sticks = zones.is_some_and(|zones| zones[cell] == Zone::Stick);
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "no pressure is negative, and less than a part counts for nothing"
                )]
                let parts = (pressure[cell] / unit * PARTS) as u128;
                let own = SpotSums {
                    cells: 1,
                    stick: usize::from(sticks),
                    open_sides: map.open_sides(cell),
                    place: [column as f64, row as f64],
                    parts,
                    largest: pressure[cell],
                };
                sums[fragment].add(&own, [0.0; 2]);
                Ok(())
            })?;
            Ok((labels, sums))
        };
        let (labels, sums) = layout.collective_result(walk())?;
        Ok(Self {
            grid,
            repeats: normal.boundary().repeats(),
            share,
            layout,
            unit,
            labels,
            sums,
        })
    }

    /// Joins the fragments. Returns the number of the spot of every local cell, counted from one, and the sums of all spots, in
    /// the order of their first cells.
    pub(super) fn joined(mut self) -> Result<(Vec<u32>, Vec<SpotSums>)> {
        let team = self.share.map(|share| &**share.team());
        let (fragments, lengths) = RankGroup::gathered_of(team, std::mem::take(&mut self.sums))?;
        let before = team.map_or(0, RankGroup::rank);
        let first: usize = lengths.iter().take(before).sum();
        let below = self.row_below(first, fragments.len());
        let links = self.layout.collective_result(self.links(first, &below))?;
        let (mut links, _) = RankGroup::gathered_of(team, links)?;
        // If a spot closes around the grid, the order of the links determines the direction in which the positions of its cells
        // are counted.
        links.sort_by_key(|(_, (across, _))| *across);
        let whole = self.grid.whole().size();
        let (spots, sums) = self
            .layout
            .collective_result(join(fragments, &links, whole))?;
        for label in self.labels.iter_mut().filter(|label| **label > 0) {
            *label = spots[first + *label as usize - 1];
        }
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

    /// Returns the numbers of the fragments in the row below the first local row, which may be on another rank, among the
    /// fragments of all ranks, counted from one. The list is empty below the first row of a grid that is not periodic.
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
        // A rank that has all rows keeps the row instead of sending it to itself.
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

/// Returns the label of a fragment or spot, counted from one.
fn label(number: usize) -> u32 {
    u32::try_from(number + 1).unwrap_or(u32::MAX)
}

/// Returns the number of the spot of every fragment, counted from one, and the sums of the spots. `whole` is the number of
/// columns and rows of the grid.
fn join(
    mut fragments: Vec<SpotSums>,
    links: &[Link],
    whole: [usize; 2],
) -> Result<(Vec<u32>, Vec<SpotSums>)> {
    let alone = (0..fragments.len()).map(|fragment| (fragment, [0.0; 2]));
    let mut forest = DisjointSets(fallible::collected(fragments.len(), alone)?);
    for (ends, (across, pairs)) in links {
        let beyond = match *across {
            EDGE_X => [whole[0] as f64, 0.0],
            EDGE_Y => [0.0, whole[1] as f64],
            _ => [0.0; 2],
        };
        forest.join(*ends, beyond);
        for end in ends {
            fragments[*end].open_sides[usize::from(*across != EDGE_X)] -= pairs;
        }
    }
    let (mut spots, mut sums) = (fallible::with_room(fragments.len())?, Vec::new());
    for (fragment, own) in fragments.iter().enumerate() {
        let (root, beyond) = forest.root(fragment);
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

/// Disjoint sets of fragments that form one spot. Each entry has the parent fragment (itself for the first fragment of a spot),
/// and the shift in columns and rows from the fragment's own position to its position relative to the parent.
struct DisjointSets(Vec<(usize, [f64; 2])>);

impl DisjointSets {
    /// Returns the first fragment of a spot, and the shift of this fragment relative to it.
    fn root(&mut self, fragment: usize) -> (usize, [f64; 2]) {
        let (mut at, mut beyond) = (fragment, [0.0; 2]);
        loop {
            let (parent, own) = self.0[at];
            if parent == at {
                return (at, beyond);
            }
            let (next, further) = self.0[parent];
            let far = plus(own, further);
            self.0[at] = (next, far);
            (at, beyond) = (next, plus(beyond, far));
        }
    }

    /// Joins two fragments, where the second is shifted by `beyond` relative to the first.
    fn join(&mut self, [one, other]: [usize; 2], beyond: [f64; 2]) {
        let ((one, from), (other, to)) = (self.root(one), self.root(other));
        let far = plus(plus(from, beyond), to.map(|to| -to));
        if one < other {
            self.0[other] = (one, far);
        } else if other < one {
            self.0[one] = (other, far.map(|far| -far));
        }
    }
}

fn plus(one: [f64; 2], other: [f64; 2]) -> [f64; 2] {
    [one[0] + other[0], one[1] + other[1]]
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;
    use std::time::Duration;

    use super::*;
    use crate::bodies::material::{ElasticPair, Material};
    use crate::grid::boundary::Boundary;
    use crate::grid::field::Field;
    use crate::grid::neighbours::neighbours;
    use crate::half_space::HalfSpace;
    use crate::parallel::ranks::Threads;
    use crate::report::Report;
    use crate::spots::{ContactSpots, Spot};

    fn pair() -> ElasticPair {
        ElasticPair::new(Material::new(1.0, 0.3).unwrap(), Material::rigid()).unwrap()
    }

    /// Returns the spots of a slab with these pressures, in which every third cell sticks.
    fn spots(bodies: &HalfSpace, pressure: &[f64]) -> ContactSpots {
        let (grid, gap) = (bodies.grid(), Field::zeros(bodies.grid()));
        let first = grid.rows().start * grid.nx();
        let own = pressure[first..][..grid.cells()].to_vec();
        let zone = |cell| match (first + cell) % 3 {
            0 => Zone::Stick,
            _ => Zone::Slip,
        };
        let zones: Vec<Zone> = (0..grid.cells()).map(zone).collect();
        let fields = [own, vec![0.0; grid.cells()]];
        let normal = NormalSolution::of(bodies, &gap, fields, 0.0, Report::with_room()).unwrap();
        ContactSpots::new(&normal, Some(&zones)).unwrap()
    }

    /// A spot found by a walk from cell to cell: its cells, with the positions at which the walk reached them.
    type Walked = Vec<(usize, [f64; 2])>;

    /// Finds the spots by walks, and whether each spot closes around the grid.
    fn walked(grid: Grid, repeats: [bool; 2], pressure: &[f64]) -> Vec<(Walked, bool)> {
        let mut places: HashMap<usize, [f64; 2]> = HashMap::new();
        let mut found = Vec::new();
        for seed in 0..grid.cells() {
            if pressure[seed] == 0.0 || places.contains_key(&seed) {
                continue;
            }
            let place = [(seed % grid.nx()) as f64, (seed / grid.nx()) as f64];
            places.insert(seed, place);
            let (mut cells, mut done, mut closes) = (vec![(seed, place)], 0, false);
            while let Some(&(cell, place)) = cells.get(done) {
                done += 1;
                let steps = [[-1.0, 0.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0]];
                for (next, step) in neighbours(cell, grid.size(), repeats)
                    .into_iter()
                    .zip(steps)
                {
                    let Some(next) = next.filter(|next| pressure[*next] > 0.0) else {
                        continue;
                    };
                    let reached = plus(place, step);
                    match places.insert(next, reached) {
                        Some(known) if known.map(f64::to_bits) != reached.map(f64::to_bits) => {
                            closes = true;
                        }
                        Some(_) => {}
                        None => cells.push((next, reached)),
                    }
                }
            }
            found.push((cells, closes));
        }
        found
    }

    fn assert_is_walked(grid: Grid, repeats: [bool; 2], pressure: &[f64], spots: &ContactSpots) {
        let walked = walked(grid, repeats, pressure);
        assert_eq!(spots.as_slice().len(), walked.len());
        for (number, (spot, (cells, closes))) in spots.as_slice().iter().zip(&walked).enumerate() {
            let count = cells.len() as f64;
            let load: f64 = cells.iter().map(|(cell, _)| pressure[*cell]).sum();
            let load = load * grid.cell_area();
            let stick = cells.iter().filter(|(cell, _)| cell % 3 == 0).count();
            let mut sides = 0.0;
            for (cell, _) in cells {
                assert_eq!(spots.label(*cell), Some(number));
                let around = neighbours(*cell, grid.size(), repeats);
                for (next, side) in around.into_iter().zip([grid.dy(), grid.dx()].repeat(2)) {
                    let is_open = next.is_none_or(|next| pressure[next] == 0.0);
                    sides += if is_open { side } else { 0.0 };
                }
            }
            let Spot {
                load: found,
                perimeter,
                centroid,
                ..
            } = *spot;
            assert_eq!(spot.cells, cells.len());
            assert_eq!(spot.stick_ratio, Some(stick as f64 / count));
            // The rounding error of a sequential sum.
            let rounding = f64::EPSILON * (1.0 + 0.5 * count);
            assert!((found / load - 1.0).abs() < rounding, "{found} {load}");
            assert!((perimeter - sides).abs() <= 1e-12 * sides);
            let periods = [grid.nx() as f64 * grid.dx(), grid.ny() as f64 * grid.dy()];
            for axis in (0..2).filter(|_| !closes) {
                let mean = cells.iter().map(|(_, place)| place[axis]).sum::<f64>() / count;
                let side = [grid.dx(), grid.dy()][axis];
                let middle = 0.5 * (grid.size()[axis] as f64 - 1.0);
                let off = (mean - middle) * side - centroid[axis];
                let off = off - periods[axis] * (off / periods[axis]).round();
                assert!(off.abs() < 1e-12 * periods[axis], "{off}");
            }
        }
    }

    /// Tests contacts of random cells under random pressures. One process finds the same spots as the walks, also across edges
    /// and for spots that close around the grid. Ranks, some of which have few rows or none, find bitwise identical results.
    #[test]
    fn slabs_have_the_spots_of_the_whole() {
        let mut random = 1_u64;
        let mut next = || {
            random = random
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (random >> 33) as f64 / (1_u64 << 31) as f64
        };
        // With 1400 columns a rank has at least two rows.
        for (nx, ny) in [
            (1400, 12),
            (2100, 7),
            (70, 300),
            (9, 9),
            (4100, 1),
            (1, 9000),
        ] {
            for share in [0.02, 0.4, 0.62, 0.95] {
                let grid = Grid::new(nx, ny, 0.5, 0.7).unwrap();
                let pressure: Vec<f64> = (0..grid.cells())
                    .map(|_| if next() < share { next() + 1e-9 } else { 0.0 })
                    .collect();
                let datum = nx as f64;
                for boundary in [
                    Boundary::NonPeriodic,
                    Boundary::Periodic,
                    Boundary::PeriodicAlongY { datum },
                ] {
                    let alone = HalfSpace::with_boundary(grid, pair(), boundary).unwrap();
                    let whole = spots(&alone, &pressure);
                    assert_is_walked(grid, boundary.repeats(), &pressure, &whole);
                    for ranks in [1, 2, 3, 4, 7] {
                        let slabs = Threads::run(ranks, Duration::from_secs(60), |rank| {
                            let rank = Arc::new(rank);
                            let bodies = HalfSpace::distributed(grid, pair(), boundary, rank);
                            spots(&bodies.unwrap(), &pressure)
                        });
                        let labels: Vec<u32> = slabs
                            .iter()
                            .flat_map(|slab| slab.labels().to_vec())
                            .collect();
                        assert_eq!(labels, whole.labels());
                        for slab in slabs {
                            assert_eq!(slab.as_slice(), whole.as_slice());
                        }
                    }
                }
            }
        }
    }
}
