//! The transform of an influence coefficient: one real quarter plane.

use std::ops::Range;

use num_complex::Complex;
use realfft::RealFftPlanner;

use crate::fft::real::Real;
use crate::influence::{Component, Symbols, Table};
use crate::parallel::{self, Blocks, CHUNK, blocks};

/// The two-dimensional transform of a kernel of known parity, wrapped around an `mx` x `my` torus.
///
/// A kernel even in both axes has a real spectrum, one odd in one axis an imaginary one, one odd in
/// both a real one again; the other three quarters follow from the parity. So one real number per
/// wave number of one quarter is all there is to keep: 8 bytes per cell of the unpadded grid.
#[derive(Debug, Clone)]
pub(super) struct Spectrum<T> {
    /// `my / 2 + 1` values for each column `0..=mx/2`.
    values: Vec<T>,
    height: usize,
    is_odd_y: bool,
    is_imaginary: bool,
}

impl Spectrum<f64> {
    /// Transforms a table that reaches at least half around the torus.
    ///
    /// `extend` along an axis: sample `d` of the torus is the table's at distance `min(d, m - d)`,
    /// with the sign of its parity; an odd kernel vanishes half way around.
    pub(super) fn of_table(table: &Table, [mx, my]: [usize; 2]) -> Self {
        let [is_odd_x, is_odd_y] = table.component().is_odd();
        let (width, height) = (mx / 2 + 1, my / 2 + 1);

        // Along x, one row per distance in y; then along y, one column per wave number in x.
        let mut rows = vec![0.0; width * height];
        half_transforms(mx, is_odd_x, &mut rows, |j, i| table.at(i, j));
        let mut values = vec![0.0; width * height];
        half_transforms(my, is_odd_y, &mut values, |i, j| rows[j * width + i]);

        // An odd axis contributes -i: one makes the spectrum imaginary, two turn its sign.
        if is_odd_x || is_odd_y {
            for value in &mut values {
                *value = -*value;
            }
        }
        Self::of_values(table.component(), height, values)
    }

    /// The symbols of a periodic kernel, on a torus without padding.
    pub(super) fn of_symbols(symbols: &Symbols) -> Self {
        let [width, height] = symbols.size().map(|n| n / 2 + 1);
        let mut values = vec![0.0; width * height];
        parallel::rows(&mut values, height, |column, out| {
            for (row, value) in out.iter_mut().enumerate() {
                *value = symbols.at([column, row]);
            }
        });
        Self::of_values(symbols.component(), height, values)
    }

    fn of_values(component: Component, height: usize, values: Vec<f64>) -> Self {
        let [is_odd_x, is_odd_y] = component.is_odd();
        Self {
            values,
            height,
            is_odd_y,
            is_imaginary: is_odd_x != is_odd_y,
        }
    }

    /// Smallest and largest value; for an even kernel the eigenvalues of the torus.
    pub(super) fn extremes(&self) -> [f64; 2] {
        extremes(&self.values)
    }

    /// The same of fields of mean zero.
    pub(super) fn extremes_without_mean(&self) -> [f64; 2] {
        extremes(&self.values[1..])
    }

    /// With another value for the mean.
    pub(super) fn with_mean(mut self, value: f64) -> Self {
        self.values[0] = value;
        self
    }

    /// The spectrum with every value replaced.
    pub(super) fn map<T: Real>(&self, f: impl Fn(f64) -> f64) -> Spectrum<T> {
        Spectrum {
            values: self.values.iter().map(|&value| T::of(f(value))).collect(),
            height: self.height,
            is_odd_y: self.is_odd_y,
            is_imaginary: self.is_imaginary,
        }
    }
}

impl<T: Real> Spectrum<T> {
    /// Multiplies the transformed column of wave number `kx` in place.
    pub(super) fn multiply(&self, kx: usize, column: &mut [Complex<T>]) {
        let quarter = &self.values[kx * self.height..(kx + 1) * self.height];
        let mirrored = if self.is_odd_y { -T::one() } else { T::one() };
        let (low, high) = column.split_at_mut(self.height);
        if self.is_imaginary {
            for (z, &value) in low.iter_mut().zip(quarter) {
                *z = Complex::new(-value * z.im, value * z.re);
            }
            for (z, &value) in high.iter_mut().rev().zip(&quarter[1..]) {
                *z = Complex::new(-value * z.im, value * z.re) * mirrored;
            }
        } else {
            for (z, &value) in low.iter_mut().zip(quarter) {
                *z = *z * value;
            }
            for (z, &value) in high.iter_mut().rev().zip(&quarter[1..]) {
                *z = *z * (value * mirrored);
            }
        }
    }
}

fn extremes(values: &[f64]) -> [f64; 2] {
    values
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| {
            [low.min(value), high.max(value)]
        })
}

/// The transforms of a tensor with components `xx`, `yy` and `xy = yx` of the same torus: the first two
/// even in both axes, the last odd in both.
#[derive(Debug, Clone)]
pub(super) struct PairSpectrum<T> {
    pub(super) xx: Spectrum<T>,
    pub(super) yy: Spectrum<T>,
    pub(super) xy: Spectrum<T>,
}

impl PairSpectrum<f64> {
    /// Smallest and largest eigenvalue of all waves, or of all but the mean.
    pub(super) fn extremes(&self, without_mean: bool) -> [f64; 2] {
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        let wider = |[low, high]: [f64; 2], [least, greatest]: [f64; 2]| {
            [low.min(least), high.max(greatest)]
        };
        let first = usize::from(without_mean);
        let leaf = |waves: Range<usize>| {
            let waves = waves.skip_while(|&wave| wave < first);
            waves
                .map(|wave| eigenvalues(self.tensor(wave)))
                .fold(none, wider)
        };
        parallel::fold(self.xx.values.len(), leaf, wider)
    }

    /// Largest magnitude of a component.
    pub(super) fn largest_component(&self) -> f64 {
        let leaf = |waves: Range<usize>| {
            waves
                .flat_map(|wave| self.tensor(wave))
                .fold(0.0, |largest: f64, value| largest.max(value.abs()))
        };
        parallel::fold(self.xx.values.len(), leaf, f64::max)
    }

    /// With the tensor `[xx, yy, xy]` of every wave replaced.
    pub(super) fn map<T: Real>(&self, f: impl Fn([f64; 3]) -> [f64; 3] + Sync) -> PairSpectrum<T> {
        let like = |spectrum: &Spectrum<f64>| Spectrum {
            values: vec![T::zero(); spectrum.values.len()],
            height: spectrum.height,
            is_odd_y: spectrum.is_odd_y,
            is_imaginary: spectrum.is_imaginary,
        };
        let mut mapped = PairSpectrum {
            xx: like(&self.xx),
            yy: like(&self.yy),
            xy: like(&self.xy),
        };
        let parts = [&mut mapped.xx, &mut mapped.yy, &mut mapped.xy];
        let work = |task: usize, mut parts: [Blocks<'_, T>; 3]| {
            for k in 0..parts[0].items.len() {
                let values = f(self.tensor(task * CHUNK + k));
                for (part, value) in parts.iter_mut().zip(values) {
                    part.items[k] = T::of(value);
                }
            }
        };
        let data = parts.map(|part| blocks(&mut part.values));
        let tasks = self.xx.values.len().div_ceil(CHUNK);
        parallel::sweep(0..tasks, data, &work, &|(), ()| ());
        mapped
    }

    /// `[xx, yy, xy]` of a wave.
    fn tensor(&self, wave: usize) -> [f64; 3] {
        [&self.xx, &self.yy, &self.xy].map(|part| part.values[wave])
    }
}

impl<T: Real> PairSpectrum<T> {
    /// Multiplies the transformed columns of wave number `kx` of both fields in place.
    pub(super) fn multiply(&self, kx: usize, columns: [&mut [Complex<T>]; 2]) {
        let quarter = |spectrum: &'_ Spectrum<T>| kx * spectrum.height..(kx + 1) * spectrum.height;
        let [xx, yy, xy] = [&self.xx, &self.yy, &self.xy].map(|s| &s.values[quarter(s)]);
        let [x, y] = columns.map(|column| column.split_at_mut(xx.len()));
        let lines = xx.iter().zip(yy).zip(xy);
        let turn = |(x, y): (&mut Complex<T>, &mut Complex<T>), xx: T, yy: T, xy: T| {
            let (a, b) = (*x, *y);
            *x = a * xx + b * xy;
            *y = a * xy + b * yy;
        };
        for (pair, ((&xx, &yy), &xy)) in x.0.iter_mut().zip(y.0).zip(lines.clone()) {
            turn(pair, xx, yy, xy);
        }
        // The upper half mirrors the lower, where the odd component has the other sign.
        let mirrored = x.1.iter_mut().rev().zip(y.1.iter_mut().rev());
        for (pair, ((&xx, &yy), &xy)) in mirrored.zip(lines.skip(1)) {
            turn(pair, xx, yy, -xy);
        }
    }
}

/// Smallest and largest eigenvalue of a symmetric tensor `[xx, yy, xy]`.
fn eigenvalues([xx, yy, xy]: [f64; 3]) -> [f64; 2] {
    let (mean, radius) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
    [mean - radius, mean + radius]
}

/// For each line of `out`, the cosine (even) or sine (odd) sums `sum_d f(line, d) e^(2 pi i k d/m)`
/// of the samples wrapped around a circle of `m`, for `k = 0..=m/2`.
fn half_transforms(
    m: usize,
    is_odd: bool,
    out: &mut [f64],
    sample: impl Fn(usize, usize) -> f64 + Sync,
) {
    let half = m / 2 + 1;
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(m);
    let lines = out.len() / half;
    let per_task = lines.div_ceil(parallel::lanes());
    let data = Blocks {
        items: out,
        width: per_task * half,
    };
    let work = |task: usize, block: Blocks<'_, f64>| {
        let mut wrapped = transform.make_input_vec();
        let mut complex = transform.make_output_vec();
        let mut scratch = transform.make_scratch_vec();
        for (index, out) in block.items.chunks_exact_mut(half).enumerate() {
            let line = task * per_task + index;
            for d in 0..half {
                let value = sample(line, d);
                let is_own_image = d == 0 || 2 * d == m;
                wrapped[(m - d) % m] = if is_odd { -value } else { value };
                wrapped[d] = if is_odd && is_own_image { 0.0 } else { value };
            }
            transform
                .process_with_scratch(&mut wrapped, &mut complex, &mut scratch)
                .expect("the transform made its own buffers");
            for (out, z) in out.iter_mut().zip(&complex) {
                *out = if is_odd { -z.im } else { z.re };
            }
        }
    };
    parallel::sweep(0..lines.div_ceil(per_task), data, &work, &|(), ()| ());
}
