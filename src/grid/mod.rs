//! Rectangular grid of cells on which every field is sampled.

pub(crate) mod boundary;
pub(crate) mod cell_value;
pub(crate) mod coarsening;
pub(crate) mod discretisation;
pub(crate) mod field;
pub(crate) mod neighbours;
pub(crate) mod per_cell;
pub(crate) mod record;
pub(crate) mod window;

use std::ops::Range;

use crate::error::{Error, Result, positive};
use crate::parallel::layout::Layout;

/// Rectangle of `nx` x `ny` cells of sides `dx` x `dy`, centred on the origin.
///
/// The centre of cell `(ix, iy)` has the coordinates `x = (ix - (nx - 1)/2) dx` and `y = (iy - (ny - 1)/2) dy`. The
/// paper writes the sides as 2a and 2b. Lengths are in any consistent unit.
///
/// Two grids are considered the same if their numbers of cells are equal and their sides agree to a relative 1e-12. A
/// side that was computed by division, or read from a file, may differ in its last bits. Solutions then differ by no
/// more than this tolerance. The operator `==` is exact.
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
    /// First row of this slab in the whole grid, and number of rows of the whole grid. The numbers are 0 and `ny` if
    /// the grid is whole. They are not serialised, so a slab is read back as a whole grid.
    #[cfg_attr(feature = "serde", serde(skip))]
    first_row: usize,
    #[cfg_attr(feature = "serde", serde(skip))]
    all_rows: usize,
}

/// Deserialised values before their check.
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
    /// Creates a grid of `nx` x `ny` cells of sides `dx` x `dy` (lengths).
    ///
    /// # Errors
    /// - [`Error::GridSize`] if a number of cells is zero.
    /// - [`Error::Memory`] if the padded grid is larger than the address space.
    /// - [`Error::NotPositive`] if a side, the cell area or the grid area is not positive and finite.
    pub fn new(nx: usize, ny: usize, dx: f64, dy: f64) -> Result<Self> {
        if nx == 0 || ny == 0 {
            return Err(Error::GridSize { nx, ny });
        }
        // The padded transform of a grid stores up to 4 nx ny complex numbers.
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

    /// Creates a square grid of `n` x `n` cells and the given side (a length).
    ///
    /// # Errors
    /// Returns the errors of [`Grid::new`].
    pub fn square(n: usize, side: f64) -> Result<Self> {
        positive("grid side", side)?;
        let cell = side / n.max(1) as f64;
        Self::new(n, n, cell, cell)
    }

    /// Creates a line of `n` cells of side `dx` (a length) along x, each of unit length along y. On bodies with
    /// [`Boundary::PeriodicAlongY`](crate::Boundary::PeriodicAlongY) the line is a line contact in plane strain. All
    /// forces and energies are then per unit length.
    ///
    /// # Errors
    /// Returns the errors of [`Grid::new`].
    pub fn line(n: usize, dx: f64) -> Result<Self> {
        Self::new(n, 1, dx, 1.0)
    }

    /// Returns a slab of some rows of this grid, or a slab without rows. The cells of the slab keep their positions in
    /// the whole grid. Each rank stores the fields of a [distributed](crate::HalfSpace::distributed) contact on a slab.
    pub(crate) fn slab(self, rows: Range<usize>) -> Self {
        Self {
            ny: rows.len(),
            first_row: self.first_row + rows.start,
            ..self
        }
    }

    /// Returns a grid of this cell size with the given numbers of cells, which may be zero.
    pub(crate) fn of_size(self, [nx, ny]: [usize; 2]) -> Self {
        Self {
            nx,
            ny,
            first_row: 0,
            all_rows: ny,
            ..self
        }
    }

    /// Returns the whole grid that contains this slab, or the grid itself if it is not a slab.
    #[must_use]
    pub fn whole(&self) -> Self {
        Self {
            ny: self.all_rows,
            first_row: 0,
            ..*self
        }
    }

    /// Returns the local rows of the whole grid: all rows, unless the grid is a slab of a
    /// [distributed](crate::HalfSpace::distributed) contact.
    #[must_use]
    pub fn rows(&self) -> Range<usize> {
        self.first_row..self.first_row + self.ny
    }

    /// Returns the number of cells along x.
    #[must_use]
    pub fn nx(&self) -> usize {
        self.nx
    }

    /// Returns the number of cells along y.
    #[must_use]
    pub fn ny(&self) -> usize {
        self.ny
    }

    /// Returns the side of a cell along x, 2a in the paper (a length).
    #[must_use]
    pub fn dx(&self) -> f64 {
        self.dx
    }

    /// Returns the side of a cell along y, 2b in the paper (a length).
    #[must_use]
    pub fn dy(&self) -> f64 {
        self.dy
    }

    /// Returns the number of cells, `nx * ny`.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.nx * self.ny
    }

    /// Returns the area of one cell (a length squared).
    #[must_use]
    pub fn cell_area(&self) -> f64 {
        self.dx * self.dy
    }

    /// Returns the area of the whole grid (a length squared).
    #[must_use]
    pub fn area(&self) -> f64 {
        self.cell_area() * self.cells() as f64
    }

    /// Returns the longer side of the grid (a length).
    pub(crate) fn longest_side(&self) -> f64 {
        (self.dx * self.nx as f64).max(self.dy * self.ny as f64)
    }

    /// Returns the side with which lengths are compared: the longest side, or the side along a single row or column of cells. The
    /// other side of such a grid is often an arbitrary period.
    pub(crate) fn reference_side(&self) -> f64 {
        match [self.nx, self.ny] {
            [_, 1] => self.dx * self.nx as f64,
            [1, _] => self.dy * self.ny as f64,
            _ => self.longest_side(),
        }
    }

    /// Checks that a quantity on the grid `found` is on this grid.
    pub(crate) fn check_equal(&self, quantity: &'static str, found: Self) -> Result<()> {
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

    /// Returns whether the numbers of cells are equal and the sides agree to round-off.
    pub(crate) fn agrees_with(&self, other: Self) -> bool {
        let is_near = |own: f64, other: f64| (own - other).abs() <= SAME_SIDE * own;
        self.size() == other.size()
            && self.rows() == other.rows()
            && is_near(self.dx, other.dx)
            && is_near(self.dy, other.dy)
    }

    /// Returns the layout of the cells of a field.
    pub(crate) fn layout(&self) -> Layout {
        Layout::of(self.size())
    }

    /// Returns the numbers of cells along x and y.
    pub(crate) fn size(&self) -> [usize; 2] {
        [self.nx, self.ny]
    }

    /// Returns x of the centre of column `ix` (a length). The column may lie outside the grid.
    #[must_use]
    pub fn x(&self, ix: usize) -> f64 {
        centre(ix, self.nx, self.dx)
    }

    /// Returns y of the centre of row `iy` (a length). The row may lie outside the grid.
    #[must_use]
    pub fn y(&self, iy: usize) -> f64 {
        centre(self.first_row + iy, self.all_rows, self.dy)
    }

    /// Returns the centre of cell `(ix, iy)`, `[x, y]` (lengths).
    #[must_use]
    pub fn position(&self, ix: usize, iy: usize) -> [f64; 2] {
        [self.x(ix), self.y(iy)]
    }
}

/// Relative tolerance for the sides of equal grids.
const SAME_SIDE: f64 = 1e-12;

/// Returns `(i - (n - 1)/2) d`, exactly antisymmetric about the middle of the grid.
#[inline]
fn centre(i: usize, n: usize, d: f64) -> f64 {
    (i as f64 - 0.5 * (n - 1) as f64) * d
}
