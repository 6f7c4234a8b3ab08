//! Displacements that a growth of the tractions in proportion to the pressure would cause in the cells of a window.

use crate::boundary::Boundary;
use crate::cgm::vector::plus;
use crate::contact_map::neighbours;
use crate::tangential::Axis;
use crate::tangential::engine::PlaneVector;
use crate::tangential::engine::{at, zeros};

/// A growth of traction in proportion to that of the pressure: along an axis, or about a point.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Growth {
    AlongX,
    AlongY,
    About,
}

/// Displacements by growths, and how far they are from the motion of the cells. All of no cells until they are asked
/// for.
#[derive(Debug, Clone, Default)]
pub(crate) struct GrowthFields {
    displacement: [PlaneVector; 3],
    excess: PlaneVector,
    /// How many cells away the excess of a cell comes from, [`UNKNOWN`] or [`OUTSIDE`].
    rings: Vec<u32>,
    /// Cells in the order in which they get their excess from others.
    order: Vec<u32>,
}

/// A cell of the contact without an excess of its own.
const UNKNOWN: u32 = u32::MAX - 1;
/// A cell outside the contact.
const OUTSIDE: u32 = u32::MAX;

impl GrowthFields {
    /// The displacement of a cell by a growth; zero for one that was never asked for.
    pub(crate) fn displacement(&self, growth: Growth, cell: usize) -> [f64; 2] {
        at(&self.displacement[growth as usize], cell)
    }

    pub(super) fn displacement_mut(
        &mut self,
        growth: Growth,
        axes: &[Axis],
        cells: usize,
    ) -> &mut PlaneVector {
        let displacement = &mut self.displacement[growth as usize];
        if displacement.iter().all(Vec::is_empty) {
            *displacement = zeros(axes, cells);
        }
        displacement
    }

    /// Forgets the excess of all cells, of which only those of the contact can have one.
    pub(crate) fn begin_excess(
        &mut self,
        axes: &[Axis],
        contact: impl ExactSizeIterator<Item = bool>,
    ) {
        if self.rings.is_empty() {
            self.excess = zeros(axes, contact.len());
        }
        self.rings.clear();
        self.rings
            .extend(contact.map(|is_contact| if is_contact { UNKNOWN } else { OUTSIDE }));
    }

    /// Sets by how much the growth displaces a cell beyond its motion.
    pub(crate) fn set_excess(&mut self, cell: usize, excess: [f64; 2]) {
        self.rings[cell] = 0;
        for (part, excess) in self.excess.iter_mut().zip(excess) {
            if let Some(value) = part.get_mut(cell) {
                *value = excess;
            }
        }
    }

    /// The excess of a cell; zero where the contact has none.
    pub(crate) fn excess(&self, cell: usize) -> [f64; 2] {
        if self.rings[cell] < UNKNOWN {
            at(&self.excess, cell)
        } else {
            [0.0; 2]
        }
    }

    /// Carries the excess to the rest of the contact, ring by ring: each cell takes the mean of its neighbours that are
    /// nearer.
    pub(crate) fn carry_excess(&mut self, size: [usize; 2], boundary: Boundary) {
        self.order.clear();
        self.order.reserve(self.rings.len());
        for cell in 0..self.rings.len() {
            if self.rings[cell] == 0 {
                self.reach(cell, 1, size, boundary);
            }
        }
        // Each ring is what the one before has reached.
        let (mut first, mut ring) = (0, 1);
        while first < self.order.len() {
            let last = self.order.len();
            for place in first..last {
                self.set_from_neighbours(self.order[place] as usize, ring, size, boundary);
            }
            ring += 1;
            for place in first..last {
                self.reach(self.order[place] as usize, ring, size, boundary);
            }
            first = last;
        }
    }

    /// Puts the neighbours of a cell that have no excess into a ring.
    fn reach(&mut self, cell: usize, ring: u32, size: [usize; 2], boundary: Boundary) {
        for next in neighbours(cell, size, boundary).into_iter().flatten() {
            if self.rings[next] == UNKNOWN {
                self.rings[next] = ring;
                self.order.extend(u32::try_from(next));
            }
        }
    }

    /// Sets the excess of a cell to the mean of those of its neighbours in the rings before.
    fn set_from_neighbours(
        &mut self,
        cell: usize,
        ring: u32,
        size: [usize; 2],
        boundary: Boundary,
    ) {
        let near = neighbours(cell, size, boundary).into_iter().flatten();
        let (mut sum, mut count) = ([0.0; 2], 0.0);
        for other in near.filter(|&other| self.rings[other] < ring) {
            sum = plus(sum, 1.0, at(&self.excess, other));
            count += 1.0;
        }
        self.set_excess(cell, sum.map(|sum| sum / count));
        self.rings[cell] = ring;
    }
}
