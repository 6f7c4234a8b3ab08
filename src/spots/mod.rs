//! Contact spots: connected sets of contact cells, with their area, load and perimeter.

#[cfg(test)]
mod tests;

use crate::contact::fragments::{Fragments, SpotSums, layout_of};
use crate::contact::map::ContactMap;
use crate::error::Result;
#[cfg(feature = "serde")]
use crate::error::{at_least, length};
use crate::grid::Grid;
use crate::grid::record::checked_struct;
#[cfg(feature = "history")]
use crate::history::History;
use crate::memory::fallible;
use crate::normal::NormalSolution;
use crate::parallel::ranks::RankGroup;
use crate::support::debug::shown;
use crate::tangential::{TangentialSolution, Zone};

checked_struct! {
    /// Spots of a contact: sets of contact cells connected through their sides, also across the edges of a periodic grid. If
    /// [ranks](crate::ranks) share the contact, every rank has all spots, and the labels of its local cells.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::new(64, 32, 0.25, 0.25)?;
    /// let rubber = Material::new(1.0, 0.5)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
    /// // Two balls side by side, the second lower by 0.05.
    /// let ball = |x: f64, y: f64| (x * x + y * y) / 20.0;
    /// let gap = Field::from_fn(grid, |x, y| ball(x + 4.0, y).min(ball(x - 4.0, y) + 0.05));
    /// let contact = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(0.5)).build()?.solve()?;
    ///
    /// let spots = contact.spots()?;
    /// let [first, second] = spots.as_slice() else { panic!("{} spots", spots.as_slice().len()) };
    /// assert!(first.load > second.load && (first.load + second.load - 0.5).abs() < 1e-9);
    /// assert!((first.centroid[0] + 4.0).abs() < 0.1 && (second.centroid[0] - 4.0).abs() < 0.1);
    /// assert_eq!(spots.label(16 * 64 + 16), Some(0));
    /// # Ok::<(), Error>(())
    /// ```
    #[derive(Clone, PartialEq)]
    pub struct ContactSpots {
        grid: Grid,
        /// Number of the spot of every cell, counted from one, or zero outside the contact.
        labels: Vec<u32>,
        spots: Vec<Spot>,
    }
    #[serde(remote = "ContactSpots")]
    check(read) {
        length("list of labels", read.grid.cells(), read.labels.len())?;
        let largest = read.labels.iter().copied().max().unwrap_or(0);
        at_least(
            "the largest label of a cell",
            f64::from(largest),
            "number of contact spots",
            read.spots.len() as f64,
        )
        .map(|_| ())
    }
}

shown!(ContactSpots: grid, largest());

/// A contact spot.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Spot {
    /// Number of cells of the spot.
    pub cells: usize,
    /// Area, computed by counting cells (a length squared). The [areas of the edges](crate::edges::Edges::areas_of) include the
    /// fractions of the cells at the edge.
    pub area: f64,
    /// Normal force on the spot (a force).
    pub load: f64,
    /// Load divided by area (a pressure).
    pub mean_pressure: f64,
    /// Largest pressure of the cells of the spot (a pressure).
    pub max_pressure: f64,
    /// Centre of the area, in coordinates of the whole grid (lengths). For a spot across the edges of a periodic grid, the centre
    /// is given inside the grid. The centre is not meaningful for a spot that spans the whole period.
    pub centroid: [f64; 2],
    /// Length of the edge along the sides of the cells (a length). For a round spot it exceeds the true length by a factor of
    /// 4/pi.
    pub perimeter: f64,
    /// Number of sticking cells divided by the number of cells, or `None` for the spots of a [`NormalSolution`].
    pub stick_ratio: Option<f64>,
}

impl ContactSpots {
    fn new(normal: &NormalSolution, zones: Option<&[Zone]>) -> Result<Self> {
        let (grid, share) = (normal.grid(), normal.share());
        let pressure = normal.pressure().as_slice();
        let largest = normal.pressure().max().max(0.0);
        let largest = layout_of(grid, share).combined(largest, f64::max);
        let power = f64::from_bits(largest.to_bits() & (0x7ff << 52));
        let unit = power.max(f64::MIN_POSITIVE);
        let map = ContactMap {
            grid,
            repeats: normal.boundary().repeats(),
            contains: |cell: usize| pressure[cell] > 0.0,
            counted: None,
        };
        let fragments = Fragments::of(&map, share, |cell| {
            let sticks = zones.is_some_and(|zones| zones[cell] == Zone::Stick);
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "no pressure is negative, and less than a part counts for nothing"
            )]
            let parts = (pressure[cell] / unit * PARTS) as u128;
            SpotSums {
                stick: usize::from(sticks),
                parts,
                largest: pressure[cell],
                ..SpotSums::default()
            }
        })?;
        let (labels, sums) = fragments.joined()?;
        let spots = sums.iter().map(|sums| spot(sums, grid, unit, zones));
        Ok(Self {
            grid,
            spots: fallible::collected(sums.len(), spots)?,
            labels,
        })
    }

    /// Returns the spots, in the order of their first cells.
    #[must_use]
    pub fn as_slice(&self) -> &[Spot] {
        &self.spots
    }

    /// Returns the index in [`ContactSpots::as_slice`] of the spot that contains a cell, or `None` outside the contact and the
    /// grid.
    #[must_use]
    pub fn label(&self, cell: usize) -> Option<usize> {
        let label = self.labels.get(cell).copied().unwrap_or(0);
        (label as usize).checked_sub(1)
    }

    /// Returns the number of the spot of every cell, counted from one, or zero outside the contact. The numbers are in row-major
    /// order with x fastest.
    #[must_use]
    pub fn labels(&self) -> &[u32] {
        &self.labels
    }

    /// Returns the grid of the labels.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// Returns the spot with the largest number of cells, or `None` without contact. If several spots are equal, the first spot
    /// is returned.
    #[must_use]
    pub fn largest(&self) -> Option<&Spot> {
        self.spots.iter().rev().max_by_key(|spot| spot.cells)
    }
}

/// Number of fractions per unit of the pressure. The unit is the largest power of two that does not exceed the largest pressure.
/// Therefore sums over 2^47 cells do not overflow.
const PARTS: f64 = (1_u128 << 80) as f64;

/// Returns the spot with these sums over its cells.
fn spot(sums: &SpotSums, grid: Grid, unit: f64, zones: Option<&[Zone]>) -> Spot {
    let (whole, cells) = (grid.whole().size(), sums.cells as f64);
    let (area, load) = (
        cells * grid.cell_area(),
        sums.parts as f64 / PARTS * unit * grid.cell_area(),
    );
    let centre = |axis: usize| {
        let (count, side) = (whole[axis] as f64, [grid.dx(), grid.dy()][axis]);
        let place = (sums.place[axis] / cells + 0.5).rem_euclid(count) - 0.5;
        (place - 0.5 * (count - 1.0)) * side
    };
    let [along_y, along_x] = sums.open_sides.map(|sides| sides as f64);
    Spot {
        cells: sums.cells,
        area,
        load,
        mean_pressure: load / area,
        max_pressure: sums.largest,
        centroid: [centre(0), centre(1)],
        perimeter: along_y * grid.dy() + along_x * grid.dx(),
        stick_ratio: zones.map(|_| sums.stick as f64 / cells),
    }
}

impl NormalSolution {
    /// Returns the contact spots. The call is collective over the ranks that share the contact.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if the memory does not suffice.
    /// - [`Error::Ranks`](crate::Error::Ranks) if a rank has failed or been lost.
    pub fn spots(&self) -> Result<ContactSpots> {
        ContactSpots::new(self, None)
    }
}

impl TangentialSolution {
    /// Returns the contact spots with the sticking fraction of each spot. `normal` must be the solution from which the tangential
    /// problem took its pressure. The call is collective over the ranks that share the contact.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch), [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch),
    ///   [`Error::CellValueMismatch`](crate::Error::CellValueMismatch) or
    ///   [`Error::MaterialMismatch`](crate::Error::MaterialMismatch) if the normal contact belongs to different bodies.
    /// - [`Error::OutdatedSolution`](crate::Error::OutdatedSolution) if the solution was computed for a different pressure.
    /// - The errors of [`NormalSolution::spots`].
    pub fn spots(&self, normal: &NormalSolution) -> Result<ContactSpots> {
        let checked = self.check_normal(normal, "stick ratio of a spot");
        RankGroup::agreed_of(normal.share().map(|share| &**share.team()), checked)?;
        ContactSpots::new(normal, Some(self.zones()))
    }
}

#[cfg(feature = "history")]
impl History {
    /// Returns the contact spots after the last step, with the sticking fraction of each spot. The call is collective over the
    /// ranks that share the history.
    ///
    /// # Errors
    /// The errors of [`NormalSolution::spots`].
    pub fn spots(&self) -> Result<ContactSpots> {
        ContactSpots::new(self.normal(), Some(self.zones()))
    }
}
