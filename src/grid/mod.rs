//! The rectangular grid of cells on which every field is sampled.

pub(crate) mod boundary;
pub(crate) mod cell_value;
pub(crate) mod coarsening;
pub(crate) mod discretisation;
pub(crate) mod field;
pub(crate) mod neighbours;
pub(crate) mod per_cell;
pub(crate) mod window;

use std::ops::Range;

use crate::error::{Error, Result, positive};
use crate::parallel::layout::Layout;

/// A rectangle of `nx` x `ny` cells of sides `dx` x `dy`, centred on the origin.
///
/// The centre of cell `(ix, iy)` is `x = (ix - (nx - 1)/2) dx`, `y = (iy - (ny - 1)/2) dy`.
/// The paper writes the sides as 2a and 2b. Lengths are in any consistent unit.
///
/// Two grids count as the same if they have equal numbers of cells and sides that agree to a relative 1e-12: a side
/// computed by division, or read from a file, may differ from another in its last bits. Solutions then differ by no
/// more than that. `==` is exact.
///
/// ```
/// let grid = stickslip::Grid::new(4, 2, 0.5, 1.0)?;
/// assert_eq!(grid.position(0, 0), [-0.75, -0.5]);
/// assert_eq!(grid.area(), 4.0);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "RawGrid")
)]
pub struct Grid {
    nx: usize,
    ny: usize,
    dx: f64,
    dy: f64,
    /// Where the rows lie in the grid that this one is a slab of, and the rows of that: from zero, and as many, if it is
    /// whole. What is saved of a slab is a grid of its own.
    #[cfg_attr(feature = "serde", serde(skip))]
    first_row: usize,
    #[cfg_attr(feature = "serde", serde(skip))]
    all_rows: usize,
}

/// The values read, before they are checked.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct RawGrid {
    nx: usize,
    ny: usize,
    dx: f64,
    dy: f64,
}

#[cfg(feature = "serde")]
impl TryFrom<RawGrid> for Grid {
    type Error = Error;

    fn try_from(read: RawGrid) -> Result<Self> {
        Self::new(read.nx, read.ny, read.dx, read.dy)
    }
}

impl Grid {
    /// A grid of `nx` x `ny` cells of sides `dx` x `dy` (lengths).
    ///
    /// # Errors
    /// [`Error::GridSize`] if a number of cells is zero; [`Error::Memory`] if memory cannot index the padded
    /// grid; [`Error::NotPositive`] if a side, the cell area or the grid area is not positive and finite.
    pub fn new(nx: usize, ny: usize, dx: f64, dy: f64) -> Result<Self> {
        if nx == 0 || ny == 0 {
            return Err(Error::GridSize { nx, ny });
        }
        // The padded transform of a grid holds up to 4 nx ny complex numbers.
        let bytes = (nx as u128 * ny as u128).saturating_mul(128);
        if isize::try_from(bytes).is_err() {
            let quantity = "a padded grid";
            return Err(Error::Memory { quantity, bytes });
        }
        let grid = Self {
            nx,
            ny,
            dx: positive("cell side dx", dx)?,
            dy: positive("cell side dy", dy)?,
            first_row: 0,
            all_rows: ny,
        };
        positive("cell area", grid.cell_area())?;
        positive("grid area", grid.area())?;
        Ok(grid)
    }

    /// A square grid of `n` x `n` cells and the given side (a length).
    ///
    /// # Errors
    /// As [`Grid::new`].
    pub fn square(n: usize, side: f64) -> Result<Self> {
        positive("grid side", side)?;
        let cell = side / n.max(1) as f64;
        Self::new(n, n, cell, cell)
    }

    /// A line of `n` cells of side `dx` (a length) along x, each of unit length along y: on bodies with
    /// [`Boundary::PeriodicAlongY`](crate::Boundary::PeriodicAlongY) a line contact in plane strain, and all forces and
    /// energies are those per unit length.
    ///
    /// # Errors
    /// As [`Grid::new`].
    pub fn line(n: usize, dx: f64) -> Result<Self> {
        Self::new(n, 1, dx, 1.0)
    }

    /// Some rows of this grid, none of which may be held: cells and positions are then those of the slab, at their places in
    /// the whole grid. What ranks hold of a [distributed](crate::HalfSpace::distributed) contact lies on slabs.
    pub(crate) fn slab(self, rows: Range<usize>) -> Self {
        Self {
            ny: rows.len(),
            first_row: self.first_row + rows.start,
            ..self
        }
    }

    /// So many of its cells, of which there may be none.
    pub(crate) fn of_size(self, [nx, ny]: [usize; 2]) -> Self {
        Self {
            nx,
            ny,
            first_row: 0,
            all_rows: ny,
            ..self
        }
    }

    /// The grid that this one is a slab of; itself if it is whole.
    #[must_use]
    pub fn whole(&self) -> Self {
        Self {
            ny: self.all_rows,
            first_row: 0,
            ..*self
        }
    }

    /// The rows of the whole grid that are held here: all, unless the grid is a slab of a
    /// [distributed](crate::HalfSpace::distributed) one.
    #[must_use]
    pub fn rows(&self) -> Range<usize> {
        self.first_row..self.first_row + self.ny
    }

    /// Cells along x.
    #[must_use]
    pub fn nx(&self) -> usize {
        self.nx
    }

    /// Cells along y.
    #[must_use]
    pub fn ny(&self) -> usize {
        self.ny
    }

    /// Side of a cell along x, 2a in the paper (a length).
    #[must_use]
    pub fn dx(&self) -> f64 {
        self.dx
    }

    /// Side of a cell along y, 2b in the paper (a length).
    #[must_use]
    pub fn dy(&self) -> f64 {
        self.dy
    }

    /// Number of cells, `nx * ny`.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.nx * self.ny
    }

    /// Area of one cell (a length squared).
    #[must_use]
    pub fn cell_area(&self) -> f64 {
        self.dx * self.dy
    }

    /// Area of the whole grid (a length squared).
    #[must_use]
    pub fn area(&self) -> f64 {
        self.cell_area() * self.cells() as f64
    }

    /// `Ok` if a quantity on the grid `found` is on this grid.
    pub(crate) fn expect(&self, quantity: &'static str, found: Self) -> Result<()> {
        if self.agrees_with(found) {
            return Ok(());
        }
        Err(Error::GridMismatch {
            quantity,
            expected_cells: self.size(),
            expected_sides: [self.dx, self.dy],
            found_cells: found.size(),
            found_sides: [found.dx, found.dy],
        })
    }

    /// Whether the numbers of cells are equal, and the sides to round-off.
    pub(crate) fn agrees_with(&self, other: Self) -> bool {
        let is_near = |own: f64, other: f64| (own - other).abs() <= SAME_SIDE * own;
        self.size() == other.size()
            && self.rows() == other.rows()
            && is_near(self.dx, other.dx)
            && is_near(self.dy, other.dy)
    }

    /// How the cells of a field lie.
    pub(crate) fn layout(&self) -> Layout {
        Layout::of(self.size())
    }

    /// Cells along x and y.
    pub(crate) fn size(&self) -> [usize; 2] {
        [self.nx, self.ny]
    }

    /// x of the centre of column `ix` (a length); `ix` may lie outside the grid.
    #[must_use]
    pub fn x(&self, ix: usize) -> f64 {
        centre(ix, self.nx, self.dx)
    }

    /// y of the centre of row `iy` (a length); `iy` may lie outside the grid.
    #[must_use]
    pub fn y(&self, iy: usize) -> f64 {
        centre(self.first_row + iy, self.all_rows, self.dy)
    }

    /// Centre of cell `(ix, iy)`, `[x, y]` (lengths).
    #[must_use]
    pub fn position(&self, ix: usize, iy: usize) -> [f64; 2] {
        [self.x(ix), self.y(iy)]
    }
}

/// Relative difference by which the sides of the same grid may differ.
const SAME_SIDE: f64 = 1e-12;

/// `(i - (n - 1)/2) d`, exactly antisymmetric about the middle of the grid.
fn centre(i: usize, n: usize, d: f64) -> f64 {
    (i as f64 - 0.5 * (n - 1) as f64) * d
}
