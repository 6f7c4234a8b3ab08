//! Region where contact may occur, and the part of it that a grid covers.

use crate::error::{Error, Result, finite, positive};
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::memory::fallible;

/// Region of the surface where contact may occur.
///
/// A free grid covers only the part of the region where the bodies touch. A periodic grid covers the whole region along its
/// periodic axes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Region {
    pub(super) whole: Extent,
    pub(super) boundary: Boundary,
    pub(super) is_line: bool,
}

impl Region {
    /// Creates the rectangle between these ends along x and y (lengths). The bodies extend beyond it.
    ///
    /// # Errors
    /// - [`Error::NotFinite`] if an end is not finite.
    /// - [`Error::NotPositive`] if a side is not positive.
    pub fn rectangle(x: [f64; 2], y: [f64; 2]) -> Result<Self> {
        Self::new([x, y], Boundary::NonPeriodic, false)
    }

    /// Creates a rectangle with periodic surroundings ([`Boundary::Periodic`]). The gap must have these periods.
    ///
    /// # Errors
    /// The errors of [`Self::rectangle`].
    pub fn periodic(x: [f64; 2], y: [f64; 2]) -> Result<Self> {
        Self::new([x, y], Boundary::Periodic, false)
    }

    /// Creates a line from `x[0]` to `x[1]` (lengths) for a line contact in plane strain. All forces are per unit length. `datum`
    /// is the distance of [`Boundary::PeriodicAlongY`], at least the length of the line.
    ///
    /// # Errors
    /// - The errors of [`Self::rectangle`].
    /// - [`Error::NotPositive`] if the datum is not positive.
    /// - [`Error::BelowMinimum`] if the datum is less than the length of the line.
    pub fn line(x: [f64; 2], datum: f64) -> Result<Self> {
        let region = Self::new([x, [-0.5, 0.5]], Boundary::PeriodicAlongY { datum }, true)?;
        positive("datum", datum)?;
        let least = region.whole.sides()[0];
        if datum < least {
            return Err(Error::BelowMinimum {
                quantity: "datum",
                value: datum,
                least,
                least_is: "the length of the line",
            });
        }
        Ok(region)
    }

    fn new(ends: [[f64; 2]; 2], boundary: Boundary, is_line: bool) -> Result<Self> {
        let names = ["end of the region along x", "end of the region along y"];
        for (name, ends) in names.into_iter().zip(ends) {
            for end in ends {
                finite(name, end)?;
            }
        }
        let sides = ["side of the region along x", "side of the region along y"];
        for (side, [start, end]) in sides.into_iter().zip(ends) {
            positive(side, end - start)?;
        }
        let whole = Extent { ends };
        Ok(Self {
            whole,
            boundary,
            is_line,
        })
    }

    /// Returns the axes along which the grid may be smaller than the region.
    pub(super) fn is_free(&self) -> [bool; 2] {
        self.boundary.repeats().map(|repeats| !repeats)
    }
}

/// Rectangle that a grid covers, in the coordinates of the gap.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub(super) struct Extent {
    /// Start and end along x and along y.
    pub(super) ends: [[f64; 2]; 2],
}

impl Extent {
    pub(super) fn sides(&self) -> [f64; 2] {
        self.ends.map(|[start, end]| end - start)
    }

    pub(super) fn centre(&self) -> [f64; 2] {
        self.ends.map(|[start, end]| 0.5 * (start + end))
    }

    /// Returns the grid of `cells` cells that covers the rectangle.
    pub(super) fn grid(&self, cells: [usize; 2]) -> Result<Grid> {
        let [width, height] = self.sides();
        let [nx, ny] = cells;
        Grid::new(nx, ny, width / nx.max(1) as f64, height / ny.max(1) as f64)
    }

    /// Returns positions in each cell of a grid: `parts` x `parts` points at the centres of equal parts of the cell.
    /// The points of a cell are adjacent.
    pub(super) fn positions(&self, cells: [usize; 2], parts: [usize; 2]) -> Result<Vec<[f64; 2]>> {
        let at = |axis: usize, index: usize, part: usize| {
            let [start, end] = self.ends[axis];
            let place = (index * parts[axis] + part) as f64 + 0.5;
            start + (end - start) * place / (cells[axis] * parts[axis]) as f64
        };
        let count = cells[0] * cells[1] * parts[0] * parts[1];
        let mut positions = fallible::with_room(count)?;
        for iy in 0..cells[1] {
            for ix in 0..cells[0] {
                for py in 0..parts[1] {
                    for px in 0..parts[0] {
                        positions.push([at(0, ix, px), at(1, iy, py)]);
                    }
                }
            }
        }
        Ok(positions)
    }
}
