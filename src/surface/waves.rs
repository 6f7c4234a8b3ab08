//! Representation of a surface as a sum of waves: the two-dimensional real Fourier transform.

use std::f64::consts::TAU;
use std::sync::Arc;

use bytemuck::cast_slice;
use num_complex::Complex;
use realfft::RealFftPlanner;
use rustfft::FftPlanner;

use super::slab::Slab;
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::memory::fallible::{self, unwrap_or_abort};
use crate::parallel;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::RankGroup;
use crate::parallel::ranks::partition::RowPartition;
use crate::parallel::reduce::{self, Reduction};

/// Complex amplitudes `a(i, j)` of a periodic field,
///
/// ```math
/// z(x_m, y_n) = \sum_{i, j} a_{ij}\, e^{2 \pi \mathrm{i} (i m / n_x + j n / n_y)} ,
/// ```
///
/// Only amplitudes with `i >= 0` are stored. The other amplitudes are their conjugates.
#[derive(Debug, Clone)]
pub(super) struct Waves {
    grid: Grid,
    /// First local column.
    first: usize,
    /// Layout of the amplitudes, column by column.
    layout: Layout,
    /// Amplitudes in `ny` rows for each local column of `0..=nx/2`.
    amplitudes: Vec<Complex<f64>>,
}

/// Wave to which an amplitude belongs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mode {
    /// Number of periods along each side of the grid.
    pub(super) numbers: [i64; 2],
    /// Wave vector: `2 pi` divided by the wavelength, along x and along y.
    pub(super) wave_vector: [f64; 2],
    /// Number of waves that the amplitude represents. The number is one if the column is its own mirror image, and two
    /// otherwise.
    pub(super) copies: f64,
    /// Whether a component is at the limit of two cells per period. At this limit the sign of the wave vector is
    /// undetermined.
    pub(super) is_at_limit: bool,
}

impl Waves {
    /// Creates waves of zero amplitude.
    pub(super) fn none(grid: Grid) -> Self {
        unwrap_or_abort(Self::none_on(grid, None))
    }

    /// Creates waves of zero amplitude whose columns may be distributed over ranks.
    pub(super) fn none_on(grid: Grid, columns: Option<&Arc<RowPartition>>) -> Result<Self> {
        let (first, layout) = match columns {
            Some(columns) => (
                columns.local_rows().start,
                Layout::shared(Arc::clone(columns)),
            ),
            None => (0, Layout::of(size_of_waves(grid))),
        };
        Ok(Self {
            grid,
            first,
            amplitudes: fallible::filled(Complex::default(), layout.cells())?,
            layout,
        })
    }

    /// Transforms a field, continued periodically.
    pub(super) fn of(field: &Field) -> Self {
        unwrap_or_abort(Self::of_slab(field, &Slab::new(field.grid(), None)))
    }

    /// Transforms a field from its local slab. If the field is distributed by rows, the waves are distributed by
    /// columns.
    pub(super) fn of_slab(field: &Field, slab: &Slab) -> Result<Self> {
        let grid = slab.whole();
        let (nx, ny, width) = (grid.nx(), grid.ny(), columns(grid));
        let along_x = RealFftPlanner::new().plan_fft_forward(nx);
        let rows = fallible::filled(Complex::default(), width * field.grid().ny());
        let mut rows = slab.layout().collective_result(rows)?;
        parallel::rows(&mut rows, width, |row, out| {
            let mut samples = field.as_slice()[row * nx..][..nx].to_vec();
            along_x
                .process(&mut samples, out)
                .expect("a row and its transform have the lengths planned");
        });
        let Some([dealt, columns]) = slab.shares() else {
            return Ok(Self::none_on(grid, None)?.filled_along_y(&rows));
        };
        // A row of complex numbers is exchanged as a row of twice as many reals.
        let wanted = |rank: usize| {
            let columns = columns.rows_of(rank);
            [2 * columns.start..2 * columns.end, 0..ny]
        };
        let rows = dealt.fetch(cast_slice(&rows), 2 * width, wanted)?;
        let waves = Self::none_on(grid, Some(&columns));
        let waves = slab.layout().collective_result(waves)?;
        Ok(waves.filled_along_y(cast_slice(&rows)))
    }

    /// Computes the local waves from the transforms along x of all rows in the local columns.
    fn filled_along_y(mut self, rows: &[Complex<f64>]) -> Self {
        let (grid, ny) = (self.grid, self.grid.ny());
        let width = self.layout.cells() / ny;
        let along_y = FftPlanner::new().plan_fft_forward(ny);
        let scale = 1.0 / grid.cells() as f64;
        parallel::rows(&mut self.amplitudes, ny, |column, out| {
            for (row, value) in out.iter_mut().enumerate() {
                *value = rows[row * width + column] * scale;
            }
            along_y.process(out);
        });
        self
    }

    /// Returns the sum of the waves as a field. If a column is its own mirror image, the amplitudes of opposite rows in
    /// the column should be conjugates. Only the Hermitian part of the amplitudes contributes.
    pub(super) fn into_field(self) -> Field {
        let (grid, ny) = (self.grid, self.grid.ny());
        let amplitudes = self.summed_along_y();
        along_rows(grid, |column, row| amplitudes[column * ny + row])
    }

    /// Returns the local rows of the sum of the waves. [`shared_columns`] gives the distribution of the columns of the waves, and
    /// `rows` the distribution of the rows of the field.
    pub(super) fn into_slab(self, columns: &RowPartition, rows: &RowPartition) -> Result<Field> {
        let (grid, count) = (self.grid, self.grid.nx() / 2 + 1);
        let slab = grid.slab(rows.local_rows());
        let height = slab.ny();
        let amplitudes = self.summed_along_y();
        // A column of complex numbers is exchanged as a row of twice as many reals.
        let wanted = |rank: usize| {
            let rows = rows.rows_of(rank);
            [2 * rows.start..2 * rows.end, 0..count]
        };
        let found = columns.fetch(cast_slice(&amplitudes), 2 * grid.ny(), wanted)?;
        let found: &[Complex<f64>] = cast_slice(&found);
        Ok(along_rows(slab, |column, row| found[column * height + row]))
    }

    /// Returns the amplitudes of the waves along x in every row.
    fn summed_along_y(mut self) -> Vec<Complex<f64>> {
        let ny = self.grid.ny();
        let along_y = FftPlanner::new().plan_fft_inverse(ny);
        parallel::rows(&mut self.amplitudes, ny, |_, column| {
            along_y.process(column);
        });
        self.amplitudes
    }

    /// Returns the mode of the shortest wave of the grid.
    pub(super) fn shortest(&self) -> Mode {
        Mode::new(self.grid, self.grid.nx() / 2, self.grid.ny() / 2)
    }

    /// Iterates over the local amplitudes and their modes.
    pub(super) fn iter(&self) -> impl Iterator<Item = (Mode, Complex<f64>)> + '_ {
        let grid = self.grid;
        let values = (self.first..).zip(self.amplitudes.chunks_exact(grid.ny()));
        values.flat_map(move |(column, values)| {
            let values = values.iter().enumerate();
            values.map(move |(row, &value)| (Mode::new(grid, column, row), value))
        })
    }

    /// Computes sums over the amplitudes of all ranks.
    pub(super) fn sums<const K: usize>(
        &self,
        f: impl Fn(Mode, Complex<f64>) -> [f64; K] + Sync,
    ) -> [f64; K] {
        let ny = self.grid.ny();
        reduce::sum(&self.layout, |i| {
            let mode = Mode::new(self.grid, self.first + i / ny, i % ny);
            f(mode, self.amplitudes[i])
        })
    }

    /// Computes sums over the amplitudes of all ranks for each group of modes.
    pub(super) fn grouped<T: Reduction>(
        &self,
        count: usize,
        f: impl Fn(Mode, Complex<f64>) -> Option<(usize, T)> + Sync,
    ) -> Vec<T> {
        let ny = self.grid.ny();
        reduce::grouped(&self.layout, count, |i| {
            let mode = Mode::new(self.grid, self.first + i / ny, i % ny);
            f(mode, self.amplitudes[i])
        })
    }

    /// Replaces every amplitude by a function of its mode and of the amplitude.
    pub(super) fn update(&mut self, f: impl Fn(Mode, Complex<f64>) -> Complex<f64> + Sync) {
        self.update_with([], |mode, value, []| f(mode, value));
    }

    /// Replaces every amplitude by a function of its mode and of the amplitudes of this mode. The amplitudes are the
    /// replaced amplitude and the amplitudes in other waves on the same grid.
    pub(super) fn update_with<const N: usize>(
        &mut self,
        others: [&Self; N],
        f: impl Fn(Mode, Complex<f64>, [Complex<f64>; N]) -> Complex<f64> + Sync,
    ) {
        let (grid, first) = (self.grid, self.first);
        let ny = grid.ny();
        parallel::rows(&mut self.amplitudes, ny, |column, values| {
            for (row, value) in values.iter_mut().enumerate() {
                let likes = others.map(|other| other.amplitudes[column * ny + row]);
                *value = f(Mode::new(grid, first + column, row), *value, likes);
            }
        });
    }

    /// Makes the amplitudes of opposite rows conjugates if their column is its own mirror image. The amplitude of the
    /// positive row is kept.
    pub(super) fn pair_opposite_rows(&mut self) {
        let (first, nx, ny) = (self.first, self.grid.nx(), self.grid.ny());
        let columns = (first..).zip(self.amplitudes.chunks_exact_mut(ny));
        for (_, values) in columns.filter(|(column, _)| *column == 0 || 2 * column == nx) {
            for row in 1..ny.div_ceil(2) {
                values[ny - row] = values[row].conj();
            }
        }
    }
}

/// Returns the distribution of the columns of waves over the ranks of a grid.
pub(super) fn shared_columns(grid: Grid, team: &Arc<RankGroup>) -> RowPartition {
    RowPartition::new(team, size_of_waves(grid))
}

/// Computes the rows of a field from the amplitudes of the waves along x. `at` returns the amplitude of a column and a
/// row.
fn along_rows(grid: Grid, at: impl Fn(usize, usize) -> Complex<f64> + Sync) -> Field {
    let (nx, width) = (grid.nx(), columns(grid));
    let along_x = RealFftPlanner::new().plan_fft_inverse(nx);
    let mut field = Field::zeros(grid);
    parallel::rows(field.as_mut_slice(), nx, |row, out| {
        let mut waves: Vec<Complex<f64>> = (0..width).map(|column| at(column, row)).collect();
        waves[0].im = 0.0;
        if nx % 2 == 0 {
            waves[width - 1].im = 0.0;
        }
        along_x
            .process(&mut waves, out)
            .expect("a row and its transform have the lengths planned, and real ends");
    });
    field
}

impl Mode {
    /// Iterates over all modes of a grid, column by column.
    pub(super) fn all(grid: Grid) -> impl Iterator<Item = Self> {
        let columns = 0..columns(grid);
        columns.flat_map(move |column| (0..grid.ny()).map(move |row| Self::new(grid, column, row)))
    }

    fn new(grid: Grid, column: usize, row: usize) -> Self {
        let (nx, ny) = (grid.nx(), grid.ny());
        let signed = |count: usize| i64::try_from(count).unwrap_or(i64::MAX);
        let j = if 2 * row <= ny {
            signed(row)
        } else {
            signed(row) - signed(ny)
        };
        let numbers = [signed(column), j];
        Self {
            numbers,
            wave_vector: [
                TAU * numbers[0] as f64 / (nx as f64 * grid.dx()),
                TAU * numbers[1] as f64 / (ny as f64 * grid.dy()),
            ],
            copies: if column == 0 || 2 * column == nx {
                1.0
            } else {
                2.0
            },
            is_at_limit: 2 * column == nx || 2 * row == ny,
        }
    }

    /// Returns the length of the wave vector.
    pub(super) fn wave_number(&self) -> f64 {
        self.wave_vector[0].hypot(self.wave_vector[1])
    }
}

/// Returns the number of amplitudes per column and the number of columns.
fn size_of_waves(grid: Grid) -> [usize; 2] {
    [grid.ny(), columns(grid)]
}

/// Returns the number of stored columns of the transform of a field.
fn columns(grid: Grid) -> usize {
    grid.nx() / 2 + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_of_a_field_add_up_to_it_again() {
        for [nx, ny] in [[8, 6], [7, 5], [1, 4], [5, 1], [16, 9]] {
            let grid = Grid::new(nx, ny, 0.5, 0.25).unwrap();
            let field = Field::from_fn(grid, |x, y| (3.0 * x + 1.0).sin() * (y - 0.3) + x * y);
            let waves = Waves::of(&field);
            let mean_square: f64 = waves.iter().map(|(m, a)| m.copies * a.norm_sqr()).sum();
            let samples = field.as_slice().iter().map(|z| z * z);
            let expected = samples.sum::<f64>() / grid.cells() as f64;
            assert!((mean_square - expected).abs() < 1e-14 * expected.max(1.0));
            let again = waves.into_field();
            for (a, b) in again.as_slice().iter().zip(field.as_slice()) {
                assert!((a - b).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn a_single_wave_has_a_single_amplitude() {
        let grid = Grid::new(12, 10, 0.5, 0.3).unwrap();
        let field = Field::from_fn(grid, |x, y| {
            (TAU * (2.0 * x / 6.0 - 3.0 * y / 3.0) + 0.4).cos()
        });
        for (mode, amplitude) in Waves::of(&field).iter() {
            let expected = if mode.numbers == [2, -3] { 0.5 } else { 0.0 };
            assert!((amplitude.norm() - expected).abs() < 1e-15, "{mode:?}");
        }
    }
}
