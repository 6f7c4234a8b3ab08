//! Displacements that a growth of the tractions in proportion to the pressure would cause in the cells of a window.

use crate::buffer;
use crate::cgm::vector::plus;
use crate::contact_map::neighbours;
use crate::error::Result;
use crate::half_space::Region;
use crate::tangential::engine::{PlaneVector, at, zeros};
use crate::tangential::{Axis, Increment, Pressed, centre};

/// A growth of traction in proportion to that of the pressure: along an axis, or about a point.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Growth {
    AlongX,
    AlongY,
    About,
}

/// Displacements by growths, and how far they are from the motion of the cells. All of no cells until they are asked for.
#[derive(Debug, Clone, Default)]
pub(crate) struct GrowthFields {
    displacement: [PlaneVector; 3],
    excess: Excess,
}

/// A cell of the contact without an excess of its own.
const UNKNOWN: u32 = u32::MAX - 1;
/// A cell outside the contact.
const OUTSIDE: u32 = u32::MAX;

/// By how much a growth displaces cells beyond their motion; where ranks share the region, with the row before its first
/// and the row after its last.
#[derive(Debug, Clone, Default)]
struct Excess {
    size: [usize; 2],
    /// Of what lies here, and of the whole window along y.
    repeats: [bool; 2],
    is_closed: bool,
    /// Where the first cell of the region lies.
    first: usize,
    cells: usize,
    values: PlaneVector,
    /// How many cells away the excess of a cell comes from, [`UNKNOWN`] or [`OUTSIDE`].
    rings: Vec<u32>,
    /// Cells in the order in which they get their excess from others.
    order: Vec<u32>,
}

impl GrowthFields {
    /// Growth of the normal displacement of a cell in the step; until the excess is found, in whose memory it is.
    pub(crate) fn normal(&self, cell: usize) -> f64 {
        let Excess { values, first, .. } = &self.excess;
        let [x, y] = values;
        (if x.is_empty() { y } else { x })[first + cell]
    }

    /// The displacement of a cell by a growth; zero for one that was never asked for.
    pub(crate) fn displacement(&self, growth: Growth, cell: usize) -> [f64; 2] {
        at(&self.displacement[growth as usize], cell)
    }

    /// The excess of a cell; zero where the contact has none.
    pub(crate) fn excess(&self, cell: usize) -> [f64; 2] {
        self.excess.of(cell)
    }
}

impl Increment {
    /// Takes what pressing did to a cell of the grid held here: its pressure before, and the growth of its normal
    /// displacement.
    pub(crate) fn set_pressing(
        &mut self,
        repeats: [bool; 2],
        before: &[f64],
        normal: impl Fn(usize) -> f64,
    ) -> Result<()> {
        let (Pressed { region, .. }, excess) = (&self.pressed, &mut self.growth.excess);
        let axis = self.axes[0].index();
        region.gather(before, &mut self.linear[axis]);
        excess.begin(region, self.axes, &self.pressed.pressure, repeats)?;
        let own = excess.first..excess.first + excess.cells;
        region.collect(normal, &mut excess.values[axis][own]);
        Ok(())
    }

    /// Pressure of a cell at the beginning of the step; until that is solved, in the memory of its linear term.
    pub(crate) fn before(&self, cell: usize) -> f64 {
        self.linear[self.axes[0].index()][cell]
    }

    /// Finds the displacements that the growth of the pressure would cause as a traction of this direction and size in
    /// each point. The present tractions are lost.
    pub(crate) fn find_growth(
        &mut self,
        growth: Growth,
        direction: impl Fn([f64; 2]) -> [f64; 2],
    ) -> Result<()> {
        for (k, point) in self.points() {
            let grown = self.pressed.pressure[k] - self.before(k);
            let direction = direction(point);
            for axis in self.axes.iter().map(|axis| axis.index()) {
                self.traction[axis][k] = grown * direction[axis];
            }
        }
        let displacement = &mut self.growth.displacement[growth as usize];
        if displacement.iter().all(Vec::is_empty) {
            *displacement = zeros(self.axes, self.pressed.region.cells())?;
        }
        self.engine.apply(&self.traction, displacement)
    }

    /// Finds by how much a growth displaces the cells of the contact beyond their motion. Those where `own` tells it, of a
    /// cell and its centre, hand it on to the rest of the contact, ring by ring: each cell takes the mean of its neighbours
    /// that are nearer.
    pub(crate) fn find_excess(&mut self, own: impl Fn(&Self, usize, [f64; 2]) -> Option<[f64; 2]>) {
        // Out of the increment and back, so that the rest of it can be read.
        let mut excess = std::mem::take(&mut self.growth.excess);
        for (k, point) in self.points() {
            if self.pressed.pressure[k] > 0.0 {
                if let Some(value) = own(self, k, point) {
                    excess.set(excess.first + k, value, 0);
                }
            }
        }
        excess.carry(&self.pressed.region);
        self.growth.excess = excess;
    }

    /// The cells of the region, and their centres.
    pub(crate) fn points(&self) -> impl Iterator<Item = (usize, [f64; 2])> + use<> {
        let (grid, own) = (self.bodies.grid().whole(), self.pressed.region.own());
        let indices = own.indices().enumerate();
        indices.map(move |(k, i)| (k, centre(grid, i)))
    }

    /// The centre of a cell of the region.
    pub(crate) fn point(&self, cell: usize) -> [f64; 2] {
        let own = self.pressed.region.own();
        centre(self.bodies.grid().whole(), own.index(cell))
    }
}

impl Excess {
    /// Forgets the excess of all cells of a region, of which only those under pressure can have one.
    fn begin(
        &mut self,
        region: &Region,
        axes: &[Axis],
        pressure: &[f64],
        repeats: [bool; 2],
    ) -> Result<()> {
        let [nx, ny] = region.own().size;
        let is_shared = region.is_shared();
        (self.cells, self.is_closed) = (pressure.len(), repeats[1]);
        (self.size, self.repeats, self.first) = if is_shared {
            ([nx, ny + 2], [repeats[0], false], nx)
        } else {
            ([nx, ny], repeats, 0)
        };
        let all = self.size[0] * self.size[1];
        if self.rings.len() != all {
            self.rings.clear();
            self.values = zeros(axes, all)?;
            buffer::resize(&mut self.rings, all, OUTSIDE)?;
        }
        self.order.clear();
        buffer::make_room(&mut self.order, self.cells)?;
        self.rings.fill(OUTSIDE);
        for (ring, pressure) in self.rings[self.first..].iter_mut().zip(pressure) {
            if *pressure > 0.0 {
                *ring = UNKNOWN;
            }
        }
        Ok(())
    }

    fn of(&self, cell: usize) -> [f64; 2] {
        let place = self.first + cell;
        if self.rings[place] < UNKNOWN {
            at(&self.values, place)
        } else {
            [0.0; 2]
        }
    }

    fn set(&mut self, place: usize, value: [f64; 2], ring: u32) {
        self.rings[place] = ring;
        for (part, value) in self.values.iter_mut().zip(value) {
            if let Some(part) = part.get_mut(place) {
                *part = value;
            }
        }
    }

    /// Whether a place is one of the region itself.
    fn is_own(&self, place: usize) -> bool {
        (self.first..self.first + self.cells).contains(&place)
    }

    fn carry(&mut self, region: &Region) {
        // Each ring is what the one before has reached.
        let (mut first, mut ring) = (0, 0);
        loop {
            self.swap_edges(region);
            let last = self.order.len();
            if ring == 0 {
                self.reach_from(0..self.rings.len(), 0);
            } else {
                for place in first..last {
                    self.reach(self.order[place] as usize, ring + 1);
                }
                self.reach_from(0..self.first, ring);
                self.reach_from(self.first + self.cells..self.rings.len(), ring);
            }
            if !region.any(self.order.len() > last) {
                return;
            }
            ring += 1;
            for place in last..self.order.len() {
                self.set_from_neighbours(self.order[place] as usize, ring);
            }
            first = last;
        }
    }

    /// Puts what places of a ring can reach into the next.
    fn reach_from(&mut self, places: std::ops::Range<usize>, ring: u32) {
        for place in places {
            if self.rings[place] == ring {
                self.reach(place, ring + 1);
            }
        }
    }

    /// Puts the neighbours of a cell that have no excess into a ring.
    fn reach(&mut self, place: usize, ring: u32) {
        for next in neighbours(place, self.size, self.repeats)
            .into_iter()
            .flatten()
        {
            if self.rings[next] == UNKNOWN && self.is_own(next) {
                self.rings[next] = ring;
                self.order.extend(u32::try_from(next));
            }
        }
    }

    /// Sets the excess of a cell to the mean of those of its neighbours in the rings before.
    fn set_from_neighbours(&mut self, place: usize, ring: u32) {
        let near = neighbours(place, self.size, self.repeats);
        let (mut sum, mut count) = ([0.0; 2], 0.0);
        for other in near.into_iter().flatten() {
            if self.rings[other] < ring {
                sum = plus(sum, 1.0, at(&self.values, other));
                count += 1.0;
            }
        }
        self.set(place, sum.map(|sum| sum / count), ring);
    }

    /// Takes over the row before the region and the row after it, from the ranks that have them.
    fn swap_edges(&mut self, region: &Region) {
        let [nx, _] = self.size;
        let edges = region.edges(self.is_closed, |cells| {
            let places = cells.map(|cell| self.first + cell);
            let known = |place| {
                let [x, y] = at(&self.values, place);
                [f64::from(self.rings[place]), x, y]
            };
            places.flat_map(known).collect()
        });
        let places = [0, self.first + self.cells];
        for (place, known) in places.into_iter().zip(edges) {
            let known = known.unwrap_or_default();
            for (place, known) in (place..place + nx).zip(known.chunks_exact(3)) {
                self.set(place, [known[1], known[2]], ring_of(known[0]));
            }
        }
    }
}

/// The ring that travelled as a number.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "it was one of these integers"
)]
fn ring_of(known: f64) -> u32 {
    known as u32
}
