//! Transform of an N x N tensor of influence coefficients: one quarter plane of real symmetric matrices.

use std::array::from_fn;
use std::ops::Range;

use num_complex::Complex;

use crate::error::Result;
use crate::fft::eigenvalues::{coupling, eigenvalue_range, inverse_above};
use crate::fft::plan::zero;
use crate::fft::precision::Real;
use crate::fft::spectrum::{StridedLines, transform};
use crate::fft::torus::TorusLayout;
use crate::influence::InfluenceKernel;
use crate::memory::fallible;
use crate::parallel;

/// Two-dimensional transform of a tensor of kernels of known parity, wrapped around an `mx` x `my` torus. It is a Hermitian N x
/// N matrix for every wave, or any single kernel for N = 1.
///
/// A kernel that is even in both axes or odd in both axes has a real spectrum. A kernel that is odd in one axis has an imaginary
/// spectrum. The other three quarters of the plane follow from the parity. An imaginary entry couples an in-plane direction with
/// the normal. The matrix of a wave is therefore `A = D S D*`, where S is real and symmetric and D is a diagonal matrix with
/// entries 1 and i. The matrices take N (N + 1)/2 real numbers per wave of one quarter. Each of these numbers takes 8 bytes per
/// cell of the unpadded grid.
#[derive(Debug, Clone)]
pub(super) struct Symbol<T, const N: usize> {
    /// Values of S. Each local column of `0..=mx/2` has `my / 2 + 1` values for each entry of the upper triangle, row by row.
    values: Vec<T>,
    /// First local column.
    first: usize,
    shape: SymbolShape<N>,
    frame: TorusLayout,
}

#[derive(Debug, Clone, Copy)]
struct SymbolShape<const N: usize> {
    /// Number of values of an entry in a column.
    height: usize,
    parity: Parity<N>,
}

/// Rules that derive the matrices of all waves from the real matrices of a quarter of the waves.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parity<const N: usize> {
    /// Whether each entry changes sign with the wave number along y.
    is_odd_y: [[bool; N]; N],
    /// Whether each input field is multiplied by -i before S is applied, and whether each output field is multiplied by i
    /// afterwards.
    turns_in: [bool; N],
    turns_out: [bool; N],
}

impl<const N: usize> Parity<N> {
    /// Creates the rules for kernels with the given parities in x and y, indexed by displacement, then traction.
    pub(super) fn new(is_odd: [[[bool; 2]; N]; N]) -> Self {
        let is_imaginary = |[is_odd_x, is_odd_y]: [bool; 2]| is_odd_x != is_odd_y;
        let first = is_imaginary(is_odd[0][0]);
        Self {
            is_odd_y: is_odd.map(|row| row.map(|[_, is_odd_y]| is_odd_y)),
            turns_in: from_fn(|j| is_imaginary(is_odd[0][j]) != first),
            turns_out: from_fn(|i| is_imaginary(is_odd[i][0])),
        }
    }

    /// Returns whether the values of an entry of S are the negatives of its real or imaginary spectrum.
    ///
    /// The transform A of an imaginary entry is i times its values. S is -i A if row i is rotated, and i A if column j is
    /// rotated.
    pub(super) fn negates(&self, i: usize, j: usize) -> bool {
        self.turns_in[j] && !self.turns_out[i]
    }
}

impl<const N: usize> SymbolShape<N> {
    /// Number of entries of the upper triangle.
    const ENTRIES: usize = N * (N + 1) / 2;

    fn new(height: usize, kernels: [[&InfluenceKernel; N]; N]) -> Self {
        let is_odd = kernels.map(|row| row.map(InfluenceKernel::is_odd));
        let parity = Parity::new(is_odd);
        Self { height, parity }
    }

    /// Returns the number of values of a column.
    fn stride(&self) -> usize {
        Self::ENTRIES * self.height
    }

    /// Returns the range of the values of an entry in a column.
    fn entry(&self, i: usize, j: usize) -> Range<usize> {
        let (i, j) = if i < j { (i, j) } else { (j, i) };
        let place = i * (2 * N - i - 1) / 2 + j;
        place * self.height..(place + 1) * self.height
    }

    /// Returns S at row `row` of a column.
    fn matrix<T: Copy>(&self, column: &[T], row: usize) -> [[T; N]; N] {
        from_fn(|i| from_fn(|j| column[self.entry(i, j)][row]))
    }
}

impl<const N: usize> Symbol<f64, N> {
    /// Creates the symbol of a symmetric tensor of kernels (indexed by displacement, then traction), or of one kernel of any
    /// parity. Tables must reach at least half around the torus.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub(super) fn new(frame: &TorusLayout, kernels: [[&InfluenceKernel; N]; N]) -> Result<Self> {
        let shape = SymbolShape::new(frame.torus[1] / 2 + 1, kernels);
        let columns = frame.own_columns();
        let values = frame.run_collectively(|| {
            let mut values = fallible::zeros(columns.len() * shape.stride())?;
            for (i, j) in upper_triangle::<N>() {
                let sign = if shape.parity.negates(i, j) {
                    -1.0
                } else {
                    1.0
                };
                let lines = StridedLines {
                    values: &mut values,
                    stride: shape.stride(),
                    entry: shape.entry(i, j),
                };
                transform(kernels[i][j], frame, sign, lines)?;
            }
            Ok(values)
        });
        Ok(Self {
            values: values?,
            first: columns.start,
            shape,
            frame: frame.clone(),
        })
    }

    /// Returns the smallest and largest eigenvalue of all waves, or of all waves except the mean.
    pub(super) fn extremes(&self, without_mean: bool) -> [f64; 2] {
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        let wider = |[low, high]: [f64; 2], [least, greatest]: [f64; 2]| {
            [low.min(least), high.max(greatest)]
        };
        let SymbolShape { height, .. } = self.shape;
        let matrix = |wave: usize| {
            let column = &self.values[wave / height * self.shape.stride()..];
            self.shape.matrix(column, wave % height)
        };
        let first = usize::from(without_mean && self.first == 0);
        let leaf = |waves: Range<usize>| {
            let waves = waves.skip_while(|&wave| wave < first);
            waves
                .map(|wave| eigenvalue_range(matrix(wave)))
                .fold(none, wider)
        };
        let own = parallel::fold(self.values.len() / SymbolShape::<N>::ENTRIES, leaf, wider);
        self.frame.over_ranks(own, wider)
    }

    /// Returns the largest magnitude of an entry.
    pub(super) fn largest_entry(&self) -> f64 {
        let larger = |a: f64, b: f64| a.max(b.abs());
        let leaf = |range: Range<usize>| self.values[range].iter().copied().fold(0.0, larger);
        let own = parallel::fold(self.values.len(), leaf, f64::max);
        self.frame.over_ranks(own, f64::max)
    }

    /// Returns the smallest entry on the diagonal.
    pub(super) fn least_diagonal(&self) -> f64 {
        let columns = self.values.chunks_exact(self.shape.stride());
        let entries = columns.flat_map(|column| (0..N).map(|i| &column[self.shape.entry(i, i)]));
        let own = entries.flatten().copied().fold(f64::INFINITY, f64::min);
        self.frame.over_ranks(own, f64::min)
    }

    /// Returns the smallest diagonal entry of the mean.
    pub(super) fn least_of_mean(&self) -> f64 {
        let has_mean = self.first == 0 && !self.values.is_empty();
        let entries = (0..N).filter(|_| has_mean);
        let entries = entries.map(|i| self.values[self.shape.entry(i, i).start]);
        let own = entries.fold(f64::INFINITY, f64::min);
        self.frame.over_ranks(own, f64::min)
    }

    /// Replaces the matrix of the mean by the matrix of the longest wave along x. This requires at least two columns, all of them
    /// local.
    pub(super) fn with_mean_of_longest_wave(mut self) -> Self {
        let stride = self.shape.stride();
        if self.first == 0 && self.values.len() >= 2 * stride {
            for (i, j) in upper_triangle::<N>() {
                let entry = self.shape.entry(i, j).start;
                self.values[entry] = self.values[stride + entry];
            }
        }
        self
    }

    /// Replaces the matrix of the mean by a multiple of the identity.
    pub(super) fn with_mean(mut self, value: f64) -> Self {
        let has_mean = self.first == 0 && !self.values.is_empty();
        for (i, j) in upper_triangle::<N>().filter(|_| has_mean) {
            let entry = self.shape.entry(i, j);
            self.values[entry.start] = if i == j { value } else { 0.0 };
        }
        self
    }

    /// Applies a function to every entry.
    pub(super) fn map<T: Real>(&self, f: impl Fn(f64) -> f64 + Sync) -> Result<Symbol<T, N>> {
        let mut values = fallible::zeros(self.values.len())?;
        parallel::update(&mut values, |first, chunk| {
            for (value, &from) in chunk.iter_mut().zip(&self.values[first..]) {
                *value = T::of(f(from));
            }
        });
        Ok(Symbol {
            values,
            first: self.first,
            shape: self.shape,
            frame: self.frame.clone(),
        })
    }

    /// Multiplies every entry by a factor.
    pub(super) fn scaled(mut self, factor: f64) -> Self {
        parallel::update(&mut self.values, |_, chunk| {
            for value in chunk {
                *value *= factor;
            }
        });
        self
    }

    /// Inverts the matrices, with eigenvalues below `floor` raised to `floor`.
    pub(super) fn inverse_above(mut self, floor: f64) -> Self {
        let shape = self.shape;
        parallel::rows(&mut self.values, shape.stride(), |_, column| {
            for row in 0..shape.height {
                let inverse = inverse_above(shape.matrix(column, row), floor);
                for (i, j) in upper_triangle::<N>() {
                    column[shape.entry(i, j).start + row] = inverse[i][j];
                }
            }
        });
        self
    }
}

impl Symbol<f64, 3> {
    /// Returns the largest [coupling] of the first component with the others, over all waves for which the coupling is defined.
    pub(super) fn coupling(&self) -> f64 {
        let SymbolShape { height, .. } = self.shape;
        let of_wave = |wave: usize| {
            let column = &self.values[wave / height * self.shape.stride()..];
            coupling(self.shape.matrix(column, wave % height))
        };
        let leaf = |waves: Range<usize>| waves.map(of_wave).fold(0.0, f64::max);
        let own = parallel::fold(
            self.values.len() / SymbolShape::<3>::ENTRIES,
            leaf,
            f64::max,
        );
        self.frame.over_ranks(own, f64::max)
    }
}

impl<T: Real, const N: usize> Symbol<T, N> {
    /// Multiplies the transformed columns of wave number `kx` of all fields in place.
    pub(super) fn multiply(&self, kx: usize, columns: &mut [&mut [Complex<T>]; N]) {
        let values = &self.values[(kx - self.first) * self.shape.stride()..][..self.shape.stride()];
        let quarter = from_fn(|i| from_fn(|j| &values[self.shape.entry(i, j)]));
        self.shape.parity.multiply(quarter, columns);
    }

    /// Multiplies all columns of a single wave along y, which are consecutive in memory.
    pub(super) fn multiply_line(&self, lines: &mut [&mut [Complex<T>]; N]) {
        if N == 1 {
            let quarter = from_fn(|_| from_fn(|_| &self.values[..]));
            return self.shape.parity.multiply(quarter, lines);
        }
        for kx in 0..lines[0].len() {
            let mut waves = lines.each_mut().map(|line| &mut line[kx..=kx]);
            self.multiply(kx, &mut waves);
        }
    }
}

impl<const N: usize> Parity<N> {
    /// Multiplies transformed columns in place by the matrices of the lower half of their waves, entry by entry.
    pub(super) fn multiply<T: Real>(
        &self,
        quarter: [[&[T]; N]; N],
        columns: &mut [&mut [Complex<T>]; N],
    ) {
        for (column, turns) in columns.iter_mut().zip(self.turns_in) {
            if turns {
                turn(column, |z| Complex::new(z.im, -z.re));
            }
        }
        let height = quarter[0][0].len();
        let mut high = from_fn(|_| <&mut [Complex<T>]>::default());
        let mut halves = high.iter_mut();
        let low = columns.each_mut().map(|column| {
            let (low, rest) = column.split_at_mut(height);
            if let Some(half) = halves.next() {
                *half = rest;
            }
            low
        });
        let even = [[T::one(); N]; N];
        multiply_half(quarter, even, low, |k, _| k);
        // The upper half mirrors the lower half, with the opposite sign for entries odd in y.
        let sign = |is_odd| if is_odd { -T::one() } else { T::one() };
        let signs = self.is_odd_y.map(|row| row.map(sign));
        let beyond_mean = quarter.map(|row| row.map(|entry| &entry[1..]));
        multiply_half(beyond_mean, signs, high, |k, len| len - 1 - k);
        for (column, turns) in columns.iter_mut().zip(self.turns_out) {
            if turns {
                turn(column, |z| Complex::new(-z.im, z.re));
            }
        }
    }
}

/// Returns the rows and columns of the entries on and above the diagonal, row by row.
fn upper_triangle<const N: usize>() -> impl Iterator<Item = (usize, usize)> {
    (0..N).flat_map(|i| (i..N).map(move |j| (i, j)))
}

/// Multiplies half of the waves of all fields. Wave `k` is at `place(k, number of waves)`.
#[expect(
    clippy::needless_range_loop,
    reason = "chains of iterators and closures keep the compiler from vector instructions here"
)]
fn multiply_half<T: Real, const N: usize>(
    mut entries: [[&[T]; N]; N],
    signs: [[T; N]; N],
    mut columns: [&mut [Complex<T>]; N],
    place: impl Fn(usize, usize) -> usize,
) {
    // Slices of equal length avoid bounds checks in the loop.
    let len = columns[0].len();
    for i in 0..N {
        columns[i] = &mut std::mem::take(&mut columns[i])[..len];
        for entry in &mut entries[i] {
            *entry = &entry[..len];
        }
    }
    for k in 0..len {
        let place = place(k, len);
        let mut product = [zero(); N];
        for i in 0..N {
            product[i] = columns[0][place] * (entries[i][0][k] * signs[i][0]);
            for j in 1..N {
                product[i] = product[i] + columns[j][place] * (entries[i][j][k] * signs[i][j]);
            }
        }
        for i in 0..N {
            columns[i][place] = product[i];
        }
    }
}

fn turn<T: Real>(column: &mut [Complex<T>], f: impl Fn(Complex<T>) -> Complex<T>) {
    for z in column {
        *z = f(*z);
    }
}
