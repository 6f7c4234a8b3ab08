//! Fields: samples on a grid.

use std::sync::Arc;

use std::ops::{Add, Index, IndexMut, Mul, Range, Sub};

use crate::error::{Result, all_finite, finite, length};
use crate::grid::Grid;
use crate::grid::per_cell::PerCell;
use crate::memory::fallible::{self, TryClone, try_clone, unwrap_or_abort};
use crate::parallel;
use crate::parallel::layout::Layout;
use crate::support::debug::shown;

/// Field with one number per cell of a [`Grid`], in row-major order with x fastest.
///
/// The memory layout equals the layout of a C-ordered NumPy array of shape `(ny, nx)`. Sample `(ix, iy)` is stored at
/// index `iy * nx + ix`. The unit is the unit of the sampled quantity.
///
/// # Memory
///
/// If memory runs out, the constructors and operations of `Field` abort the program, as `Vec` does. Bodies and surfaces
/// return [`Error::Memory`](crate::Error::Memory) for such a grid, and [`TryClone`] copies a field without aborting.
///
/// ```
/// use stickslip::{Field, Grid};
/// let grid = Grid::new(3, 2, 1.0, 1.0)?;
/// let field = Field::from_fn(grid, |x, y| x + 10.0 * y);
/// assert_eq!(field.get(2, 1), Some(6.0));
/// assert_eq!(field[(2, 1)], 6.0);
/// assert_eq!(field.as_slice()[5], 6.0);
/// let doubled = (&field + &field)?;
/// assert_eq!(doubled, &field * 2.0);
/// assert_eq!((doubled.mean(), field.iter().count()), (2.0 * field.mean(), 6));
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "RawField")
)]
pub struct Field {
    grid: Grid,
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::numbers"))]
    samples: Vec<f64>,
}

shown!(Field: grid, min(), max());

/// Implements `Clone` field by field. Unlike the derived implementation, `clone_from` then reuses the memory of each
/// field.
macro_rules! clone_in_place {
    ($type:ident $(<const $n:ident: usize>)? { $($field:ident),* $(,)? }) => {
        impl$(<const $n: usize>)? Clone for $type$(<$n>)? {
            fn clone(&self) -> Self {
                Self { $($field: self.$field.clone()),* }
            }

            fn clone_from(&mut self, source: &Self) {
                $(self.$field.clone_from(&source.$field);)*
            }
        }
    };
}

pub(crate) use clone_in_place;

clone_in_place!(Field { grid, samples });

try_clone!(Field { samples } { grid });

/// Deserialised values before their check.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct RawField {
    grid: Grid,
    #[serde(with = "crate::support::serialise::numbers")]
    samples: Vec<f64>,
}

#[cfg(feature = "serde")]
impl TryFrom<RawField> for Field {
    type Error = crate::error::Error;

    fn try_from(read: RawField) -> Result<Self> {
        Self::from_vec(read.grid, read.samples)
    }
}

/// Copies the field into a shared pointer.
impl From<&Field> for Arc<Field> {
    fn from(field: &Field) -> Self {
        Self::new(field.clone())
    }
}

/// Replaces a shared field. Memory is allocated only if the old samples have another owner.
///
/// # Errors
/// - [`Error::Memory`](crate::Error::Memory) if memory runs out. The field is then unchanged.
pub(crate) fn replace(shared: &mut Arc<Field>, field: &Field) -> Result<()> {
    match Arc::get_mut(shared) {
        Some(own) => own.try_clone_from(field)?,
        None => *shared = Arc::new(field.try_clone()?),
    }
    Ok(())
}

impl PerCell<Field> {
    /// Checks that the samples are on the grid. The error message contains the name `quantity`.
    pub(crate) fn check(&self, quantity: &'static str, grid: Grid) -> Result<()> {
        match self {
            Self::Cells(field) => grid.check_equal(quantity, field.grid()),
            Self::Uniform(_) => Ok(()),
        }
    }
}

impl Field {
    /// Creates a field that is zero in every cell.
    #[must_use]
    pub fn zeros(grid: Grid) -> Self {
        Self::constant(grid, 0.0)
    }

    /// Creates a field like [`Self::zeros`], but returns an error if memory runs out.
    pub(crate) fn try_zeros(grid: Grid) -> Result<Self> {
        let samples = fallible::zeros(grid.cells())?;
        Ok(Self { grid, samples })
    }

    /// Creates a field with the same value in every cell.
    #[must_use]
    pub fn constant(grid: Grid, value: f64) -> Self {
        Self {
            grid,
            samples: vec![value; grid.cells()],
        }
    }

    /// Creates a field from a function of the cell centres, `f(x, y)`.
    #[must_use]
    pub fn from_fn(grid: Grid, f: impl FnMut(f64, f64) -> f64) -> Self {
        unwrap_or_abort(Self::try_from_fn(grid, f))
    }

    /// Creates a field like [`Self::from_fn`], but returns an error if memory runs out.
    pub(crate) fn try_from_fn(grid: Grid, mut f: impl FnMut(f64, f64) -> f64) -> Result<Self> {
        let mut samples = fallible::with_room(grid.cells())?;
        for iy in 0..grid.ny() {
            let y = grid.y(iy);
            samples.extend((0..grid.nx()).map(|ix| f(grid.x(ix), y)));
        }
        Ok(Self { grid, samples })
    }

    /// Creates a field from a function of column and row, `f(ix, iy)`.
    #[must_use]
    pub fn from_indices(grid: Grid, f: impl Fn(usize, usize) -> f64) -> Self {
        let cells = (0..grid.ny()).flat_map(|iy| (0..grid.nx()).map(move |ix| (ix, iy)));
        Self {
            grid,
            samples: cells.map(|(ix, iy)| f(ix, iy)).collect(),
        }
    }

    /// Creates a field from samples in row-major order, x fastest.
    ///
    /// # Errors
    /// - [`Error::Length`](crate::Error::Length) if the number of samples is not `nx * ny`.
    pub fn from_vec(grid: Grid, samples: Vec<f64>) -> Result<Self> {
        length("field", grid.cells(), samples.len())?;
        Ok(Self { grid, samples })
    }

    /// Returns the grid.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// Checks that the field is on the grid and that all its samples are finite.
    pub(crate) fn check(&self, quantity: &'static str, grid: Grid) -> Result<()> {
        grid.check_equal(quantity, self.grid)?;
        all_finite(quantity, &self.samples)
    }

    /// Returns the sample of cell `(ix, iy)`, or `None` outside the grid.
    #[must_use]
    pub fn get(&self, ix: usize, iy: usize) -> Option<f64> {
        if ix < self.grid.nx() && iy < self.grid.ny() {
            self.samples.get(iy * self.grid.nx() + ix).copied()
        } else {
            None
        }
    }

    /// Returns all samples, row-major with x fastest.
    #[must_use]
    pub fn as_slice(&self) -> &[f64] {
        &self.samples
    }

    /// Iterates over all samples, row by row with x fastest.
    pub fn iter(&self) -> std::slice::Iter<'_, f64> {
        self.samples.iter()
    }

    /// Returns all samples for update, row-major with x fastest.
    #[must_use]
    pub fn as_mut_slice(&mut self) -> &mut [f64] {
        &mut self.samples
    }

    /// Adds `factor` times another field.
    ///
    /// ```
    /// use stickslip::{Field, Grid};
    /// let grid = Grid::square(8, 1.0)?;
    /// let (mut gap, depth) = (Field::constant(grid, 3.0), Field::constant(grid, 0.5));
    /// gap.add_scaled(100.0, &depth)?;
    /// assert_eq!(gap, Field::constant(grid, 53.0));
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the factor is not finite.
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the grids differ.
    ///
    /// The field is unchanged after an error.
    pub fn add_scaled(&mut self, factor: f64, other: &Self) -> Result<()> {
        finite("factor", factor)?;
        self.grid.check_equal("field to be added", other.grid)?;
        let other = other.as_slice();
        parallel::enter_with(other.len(), || {
            parallel::update(&mut self.samples, |first, chunk| {
                for (sample, other) in chunk.iter_mut().zip(&other[first..]) {
                    *sample += factor * other;
                }
            });
        });
        Ok(())
    }

    /// Applies a function to every sample and returns the new field.
    ///
    /// ```
    /// use stickslip::{Field, Grid};
    /// let heights = Field::from_fn(Grid::square(8, 1.0)?, |x, y| x * y);
    /// let highest = heights.max();
    /// let gap = heights.map(|z| highest - z);
    /// assert_eq!(gap.min(), 0.0);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    #[must_use]
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        Self {
            grid: self.grid,
            samples: self.samples.iter().map(|&sample| f(sample)).collect(),
        }
    }

    /// Returns the field times a factor.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        self.map(|sample| factor * sample)
    }

    /// Returns this field minus the other field.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the grids differ.
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn minus(&self, other: &Self) -> Result<Self> {
        let mut difference = self.try_clone()?;
        difference.add_scaled(-1.0, other)?;
        Ok(difference)
    }

    /// Returns the samples without the grid.
    #[must_use]
    pub fn into_vec(self) -> Vec<f64> {
        self.samples
    }

    /// Iterates over the rows in the order of increasing y. Each row runs along x.
    #[must_use]
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.samples.chunks_exact(self.grid.nx())
    }

    /// Returns the largest sample and ignores NaN.
    #[must_use]
    pub fn max(&self) -> f64 {
        self.extreme(f64::NEG_INFINITY, f64::max)
    }

    /// Returns the smallest sample and ignores NaN.
    #[must_use]
    pub fn min(&self) -> f64 {
        self.extreme(f64::INFINITY, f64::min)
    }

    fn extreme(&self, least: f64, of: impl Fn(f64, f64) -> f64 + Copy + Send + Sync) -> f64 {
        let samples = &self.samples;
        let leaf = |range: Range<usize>| samples[range].iter().copied().fold(least, of);
        let count = samples.len();
        parallel::enter_with(count, || parallel::fold(count, leaf, of))
    }

    /// Returns the mean of the samples.
    #[must_use]
    pub fn mean(&self) -> f64 {
        let samples = &self.samples;
        let leaf = |range: Range<usize>| samples[range].iter().fold(0.0, |sum, x| sum + x);
        parallel::fold(samples.len(), leaf, |a, b| a + b) / self.grid.cells() as f64
    }

    /// Returns the integral over the grid: the cell area times the sum of the samples.
    #[must_use]
    pub fn integral(&self) -> f64 {
        self.integral_over(&self.grid.layout())
    }

    /// Returns the integral over the distributed grid of all ranks, whose cells have this layout.
    pub(crate) fn integral_over(&self, layout: &Layout) -> f64 {
        let leaf = |range: Range<usize>| self.samples[range].iter().fold(0.0, |sum, x| sum + x);
        let sum = parallel::enter_with(self.samples.len(), || layout.fold(leaf, |a, b| a + b));
        self.grid.cell_area() * sum
    }
}

impl<'a> IntoIterator for &'a Field {
    type Item = &'a f64;
    type IntoIter = std::slice::Iter<'a, f64>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// Returns the sample of the cell in this column and row. [`Field::get`] is the alternative that does not panic.
///
/// # Panics
/// Panics if the cell is outside the grid, like the index of a slice.
impl Index<(usize, usize)> for Field {
    type Output = f64;

    fn index(&self, (ix, iy): (usize, usize)) -> &f64 {
        let start = iy * self.grid.nx();
        &self.samples[start..start + self.grid.nx()][ix]
    }
}

/// # Panics
/// Panics if the cell is outside the grid, like the index of a slice.
impl IndexMut<(usize, usize)> for Field {
    fn index_mut(&mut self, (ix, iy): (usize, usize)) -> &mut f64 {
        let (start, columns) = (iy * self.grid.nx(), self.grid.nx());
        &mut self.samples[start..start + columns][ix]
    }
}

/// Adds two fields cell by cell. Returns [`Error::GridMismatch`](crate::Error::GridMismatch) if their grids differ.
impl Add for &Field {
    type Output = Result<Field>;

    fn add(self, other: &Field) -> Result<Field> {
        let mut sum = self.clone();
        sum.add_scaled(1.0, other)?;
        Ok(sum)
    }
}

/// Subtracts two fields cell by cell: [`Field::minus`].
impl Sub for &Field {
    type Output = Result<Field>;

    fn sub(self, other: &Field) -> Result<Field> {
        self.minus(other)
    }
}

/// Multiplies two fields cell by cell. Returns [`Error::GridMismatch`](crate::Error::GridMismatch) if their grids
/// differ.
impl Mul for &Field {
    type Output = Result<Field>;

    fn mul(self, other: &Field) -> Result<Field> {
        self.grid
            .check_equal("field to be multiplied", other.grid)?;
        let pairs = self.iter().zip(other);
        Field::from_vec(self.grid, pairs.map(|(a, b)| a * b).collect())
    }
}

/// Multiplies the field by a factor: [`Field::scaled`].
impl Mul<f64> for &Field {
    type Output = Field;

    fn mul(self, factor: f64) -> Field {
        self.scaled(factor)
    }
}
