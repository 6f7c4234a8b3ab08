//! The transform of an N x N tensor of influence coefficients: one quarter plane of real symmetric matrices.

use std::array::from_fn;
use std::ops::Range;

use num_complex::Complex;

use crate::error::Result;
use crate::fft::eigenvalues::{coupling, eigenvalue_range, inverse_above};
use crate::fft::plan::zero;
use crate::fft::precision::Real;
use crate::fft::spectrum::{StridedLines, transform};
use crate::fft::torus::TorusLayout;
use crate::influence::Kernel;
use crate::memory::fallible;
use crate::parallel;

/// The two-dimensional transform of a tensor of kernels of known parity, wrapped around an `mx` x `my`
/// torus: a Hermitian N x N matrix for every wave, or for N = 1 any single kernel.
///
/// A kernel even in both axes, or odd in both, has a real spectrum, one odd in one axis an imaginary one;
/// the other three quarters of the plane follow from the parity. An imaginary entry couples a direction in
/// the plane with the normal. So the diagonal matrix D with entries 1 and i makes the matrix of a wave
/// `A = D S D*` with S real and symmetric: N (N + 1)/2 real numbers per wave of one quarter, 8 bytes each
/// per cell of the unpadded grid.
#[derive(Debug, Clone)]
pub(super) struct Symbol<T, const N: usize> {
    /// For each column of `0..=mx/2` that is multiplied here and each entry of the upper triangle of S, row by row, `my / 2 + 1`
    /// values.
    values: Vec<T>,
    /// The first column here.
    first: usize,
    shape: Shape<N>,
    frame: TorusLayout,
}

#[derive(Debug, Clone, Copy)]
struct Shape<const N: usize> {
    /// Values of an entry in a column.
    height: usize,
    parity: Parity<N>,
}

/// How the matrices of all waves follow from the real ones of a quarter of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parity<const N: usize> {
    /// Which entries change sign with the wave number along y.
    is_odd_y: [[bool; N]; N],
    /// Which fields are multiplied by -i on the way into S, and which by i on the way out.
    turns_in: [bool; N],
    turns_out: [bool; N],
}

impl<const N: usize> Parity<N> {
    /// For kernels that are odd in x and in y as told: what comes out, then what goes in.
    pub(super) fn new(is_odd: [[[bool; 2]; N]; N]) -> Self {
        let is_imaginary = |[is_odd_x, is_odd_y]: [bool; 2]| is_odd_x != is_odd_y;
        let first = is_imaginary(is_odd[0][0]);
        Self {
            is_odd_y: is_odd.map(|row| row.map(|[_, is_odd_y]| is_odd_y)),
            turns_in: from_fn(|j| is_imaginary(is_odd[0][j]) != first),
            turns_out: from_fn(|i| is_imaginary(is_odd[i][0])),
        }
    }

    /// Whether an entry of S is the negative of what its spectrum is, or is i times.
    ///
    /// The transform of an imaginary entry is i times its values. S is -i times that if row i is turned, i times that
    /// if column j is.
    pub(super) fn negates(&self, i: usize, j: usize) -> bool {
        self.turns_in[j] && !self.turns_out[i]
    }
}

impl<const N: usize> Shape<N> {
    /// Entries of the upper triangle.
    const ENTRIES: usize = N * (N + 1) / 2;

    fn new(height: usize, kernels: [[&Kernel; N]; N]) -> Self {
        let is_odd = kernels.map(|row| row.map(Kernel::is_odd));
        let parity = Parity::new(is_odd);
        Self { height, parity }
    }

    /// Values of a column.
    fn stride(&self) -> usize {
        Self::ENTRIES * self.height
    }

    /// Where the values of an entry lie in a column.
    fn entry(&self, i: usize, j: usize) -> Range<usize> {
        let (i, j) = if i < j { (i, j) } else { (j, i) };
        let place = i * (2 * N - i - 1) / 2 + j;
        place * self.height..(place + 1) * self.height
    }

    /// S at row `row` of a column.
    fn matrix<T: Copy>(&self, column: &[T], row: usize) -> [[T; N]; N] {
        from_fn(|i| from_fn(|j| column[self.entry(i, j)][row]))
    }
}

impl<const N: usize> Symbol<f64, N> {
    /// Of a symmetric tensor of kernels (displacement, then traction), or of one kernel of any parity;
    /// tables must reach at least half around the torus.
    ///
    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
    pub(super) fn new(frame: &TorusLayout, kernels: [[&Kernel; N]; N]) -> Result<Self> {
        let shape = Shape::new(frame.torus[1] / 2 + 1, kernels);
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

    /// Smallest and largest eigenvalue of all waves, or of all but the mean.
    pub(super) fn extremes(&self, without_mean: bool) -> [f64; 2] {
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        let wider = |[low, high]: [f64; 2], [least, greatest]: [f64; 2]| {
            [low.min(least), high.max(greatest)]
        };
        let Shape { height, .. } = self.shape;
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
        let own = parallel::fold(self.values.len() / Shape::<N>::ENTRIES, leaf, wider);
        self.frame.over_ranks(own, wider)
    }

    /// Largest magnitude of an entry.
    pub(super) fn largest_entry(&self) -> f64 {
        let larger = |a: f64, b: f64| a.max(b.abs());
        let leaf = |range: Range<usize>| self.values[range].iter().copied().fold(0.0, larger);
        let own = parallel::fold(self.values.len(), leaf, f64::max);
        self.frame.over_ranks(own, f64::max)
    }

    /// Smallest entry on the diagonal.
    pub(super) fn least_diagonal(&self) -> f64 {
        let columns = self.values.chunks_exact(self.shape.stride());
        let entries = columns.flat_map(|column| (0..N).map(|i| &column[self.shape.entry(i, i)]));
        let own = entries.flatten().copied().fold(f64::INFINITY, f64::min);
        self.frame.over_ranks(own, f64::min)
    }

    /// Smallest entry on the diagonal of the mean.
    pub(super) fn least_of_mean(&self) -> f64 {
        let has_mean = self.first == 0 && !self.values.is_empty();
        let entries = (0..N).filter(|_| has_mean);
        let entries = entries.map(|i| self.values[self.shape.entry(i, i).start]);
        let own = entries.fold(f64::INFINITY, f64::min);
        self.frame.over_ranks(own, f64::min)
    }

    /// With the matrix of the longest wave along x for the mean, if all columns are here and there are two.
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

    /// With a multiple of the identity for the mean.
    pub(super) fn with_mean(mut self, value: f64) -> Self {
        let has_mean = self.first == 0 && !self.values.is_empty();
        for (i, j) in upper_triangle::<N>().filter(|_| has_mean) {
            let entry = self.shape.entry(i, j);
            self.values[entry.start] = if i == j { value } else { 0.0 };
        }
        self
    }

    /// Every entry replaced.
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

    /// Every entry times a factor.
    pub(super) fn scaled(mut self, factor: f64) -> Self {
        parallel::update(&mut self.values, |_, chunk| {
            for value in chunk {
                *value *= factor;
            }
        });
        self
    }

    /// The inverse, with eigenvalues below `floor` raised to it.
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
    /// The strongest [coupling] of the first component with the others, of all waves that have one.
    pub(super) fn coupling(&self) -> f64 {
        let Shape { height, .. } = self.shape;
        let of_wave = |wave: usize| {
            let column = &self.values[wave / height * self.shape.stride()..];
            coupling(self.shape.matrix(column, wave % height))
        };
        let leaf = |waves: Range<usize>| waves.map(of_wave).fold(0.0, f64::max);
        let own = parallel::fold(self.values.len() / Shape::<3>::ENTRIES, leaf, f64::max);
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

    /// The same of all columns of one wave, which follow one another.
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
        // The upper half mirrors the lower, where entries odd in y have the other sign.
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

/// Rows and columns of the entries on and above the diagonal, row by row.
fn upper_triangle<const N: usize>() -> impl Iterator<Item = (usize, usize)> {
    (0..N).flat_map(|i| (i..N).map(move |j| (i, j)))
}

/// Multiplies half the waves of all fields, of which number `k` is at `place(k, number of waves)`.
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
    // Slices of one length need no checks in the loop.
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
