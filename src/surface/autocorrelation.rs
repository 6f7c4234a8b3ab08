//! Autocorrelation function of a surface, its length and the texture aspect ratio.

use num_complex::Complex;

use super::heights::{about_mean, finite_or_missing, measured_points};
use super::slab::Slab;
use super::waves::Waves;
use crate::error::{Error, Result, memory};
use crate::fft::smooth_length;
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::parallel;

/// Memory in bytes per cell of the torus, for two fields and their waves.
const BYTES: usize = 48;

/// Autocorrelation function of the heights, with the spatial parameters of ISO 25178-2:2021.
///
/// The heights $`z`$ are relative to their mean. At the lag $`t`$, the function is the mean product of two heights at
/// this distance, divided by its value without a lag. The mean is over all pairs of measured points:
///
/// ```math
/// f(t) = \frac{\langle z(x)\, z(x + t) \rangle}{\langle z^2 \rangle} .
/// ```
///
/// Lags extend to half the length of the grid along each axis. A measured surface ends at its edges, so larger lags have
/// fewer pairs. A [periodic](Self::of_periodic) surface continues beyond its edges. Missing heights (NaN) form no pairs.
/// [`level`](super::level()) the surface first, because a tilt correlates over any distance.
///
/// # Parameters
/// Each ray from the origin to a lag at the edge of the domain has the decay length $`r`$. The decay length is the first distance
/// at which $`f`$ falls to the threshold $`s`$ (usually 0.2). The value of $`f`$ on a ray is interpolated linearly between the
/// lags. Then
///
/// ```math
/// S_{al} = \min r , \qquad S_{tr} = \frac{\min r}{\max r} .
/// ```
///
/// If $`f`$ does not fall to the threshold along a ray, as along the lay of a ground surface, $`r`$ is the length of the
/// ray. The true ratio is then smaller than Str.
///
/// # References
/// - ISO 25178-2:2021, spatial parameters.
///
/// ```
/// use std::f64::consts::TAU;
/// use stickslip::{Field, Grid, surface::Autocorrelation};
/// // The autocorrelation function of a wave is a wave: it falls to 0.2 at arccos(0.2)/(2 pi) of the wavelength.
/// let grid = Grid::square(256, 256.0)?;
/// let wave = Field::from_fn(grid, |x, _| (TAU * x / 128.0).sin());
/// let correlation = Autocorrelation::of_periodic(&wave)?;
/// let expected = 128.0 * 0.2_f64.acos() / TAU;
/// assert!((correlation.decay_length(0.2).unwrap() / expected - 1.0).abs() < 1e-4);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Autocorrelation {
    values: Field,
}

impl Autocorrelation {
    /// Computes the function of a surface that ends at its edges.
    ///
    /// # Errors
    /// - [`Error::Sample`] with the first infinite height.
    /// - [`Error::Undetermined`] if all heights are missing or equal.
    /// - [`Error::Memory`] if memory runs out.
    /// - [`Error::GridSize`] for a field without cells.
    pub fn of(heights: &Field) -> Result<Self> {
        // Zeros beyond the surface separate it from its periodic images at all lags.
        Self::on_torus(heights, |cells| smooth_length(cells + cells / 2))
    }

    /// Computes the function of a surface that continues periodically beyond its edges.
    ///
    /// # Errors
    /// The errors of [`of`](Self::of).
    pub fn of_periodic(heights: &Field) -> Result<Self> {
        Self::on_torus(heights, |cells| cells)
    }

    fn on_torus(heights: &Field, length: impl Fn(usize) -> usize) -> Result<Self> {
        let slab = Slab::alone(heights)?;
        finite_or_missing(heights)?;
        let points = measured_points(heights, &slab);
        let cells = heights.grid().cells();
        let undetermined = |known: usize| Error::Undetermined {
            quantity: "autocorrelation function",
            unknowns: cells,
            known,
        };
        if points == 0 {
            return Err(undetermined(0));
        }
        let size = heights.grid().size().map(length);
        memory("autocorrelation function", size, BYTES)?;
        let (deviations, _) = about_mean(heights, &slab, points);
        // Squares of heights in units of the largest deviation neither overflow nor underflow.
        let largest = deviations.max().max(-deviations.min());
        if largest == 0.0 {
            return Err(undetermined(1));
        }
        let deviations = deviations.map(|z| z / largest);
        let torus = heights.grid().of_size(size);
        let is_padded = size != heights.grid().size();
        let products = parallel::enter_with(torus.cells(), || {
            let products = correlated(&deviations, torus, |z| if z.is_nan() { 0.0 } else { z });
            if points == cells && !is_padded {
                return products;
            }
            let mut products = products;
            let pairs = correlated(&deviations, torus, |z| f64::from(!z.is_nan()));
            for (product, pairs) in products.as_mut_slice().iter_mut().zip(pairs.iter()) {
                // The number of pairs is a whole number up to round-off.
                let pairs = (pairs * torus.cells() as f64).round();
                *product = if pairs > 0.0 {
                    *product * torus.cells() as f64 / pairs
                } else {
                    f64::NAN
                };
            }
            products
        });
        Ok(Self {
            values: centred(&products, heights.grid()),
        })
    }

    /// Returns the function on a grid of lags. The lag of a cell is the position of the cell, and the lag zero is in the
    /// middle. The function is NaN at lags without a pair of measured points.
    #[must_use]
    pub fn values(&self) -> &Field {
        &self.values
    }

    /// Returns the autocorrelation length Sal (a length): the smallest distance over which the function falls to a
    /// threshold, usually 0.2. Returns `None` if the function stays above the threshold at all lags, or if the threshold is not
    /// between 0 and 1.
    #[doc(alias = "Sal")]
    #[must_use]
    pub fn decay_length(&self, threshold: f64) -> Option<f64> {
        self.shortest_and_longest(threshold).map(|[least, _]| least)
    }

    /// Returns the texture aspect ratio Str, from 0 to 1: the smallest divided by the largest distance over which the
    /// function falls to a threshold, usually 0.2. Returns `None` if the function stays above the threshold at all lags, or if the
    /// threshold is not between 0 and 1.
    #[doc(alias = "Str")]
    #[must_use]
    pub fn texture_aspect_ratio(&self, threshold: f64) -> Option<f64> {
        self.shortest_and_longest(threshold)
            .map(|[least, most]| least / most)
    }

    /// Returns the smallest decay length, and the largest decay length or length of a ray without decay.
    fn shortest_and_longest(&self, threshold: f64) -> Option<[f64; 2]> {
        if !(threshold > 0.0 && threshold < 1.0) {
            return None;
        }
        let [nx, ny] = self.values.grid().size().map(|cells| cells / 2);
        // The function is even. Half of the rays are sufficient. A profile has one ray.
        let top = (0..=2 * nx).filter(|&x| ny > 0 || x == 2 * nx);
        let top = top.map(|x| (x, 2 * ny));
        let sides = (ny..2 * ny).flat_map(|y| [(0, y), (2 * nx, y)]);
        let sides = sides.filter(|_| nx > 0);
        let (mut least, mut most) = (None::<f64>, 0.0_f64);
        for (x, y) in top.chain(sides).filter(|end| *end != (nx, ny)) {
            let (decay, length) = self.along_ray(x, y, threshold);
            if let Some(decay) = decay {
                least = Some(least.map_or(decay, |least| least.min(decay)));
            }
            most = most.max(decay.unwrap_or(length));
        }
        least.map(|least| [least, most])
    }

    /// Returns the decay length along the ray from the middle to a cell at the edge, if there is one, and the length of the
    /// ray.
    fn along_ray(&self, x: usize, y: usize, threshold: f64) -> (Option<f64>, f64) {
        let grid = self.values.grid();
        let middle = grid.size().map(|cells| cells / 2);
        let steps = [x as f64 - middle[0] as f64, y as f64 - middle[1] as f64];
        let length = (steps[0] * grid.dx()).hypot(steps[1] * grid.dy());
        let lines = steps.map(f64::abs);
        // Positions along the ray, as fractions of its length, of the next grid lines across x and across y.
        let mut next = [1.0, 1.0];
        let [mut before, mut from] = [1.0, 0.0];
        while next[0] <= lines[0] || next[1] <= lines[1] {
            let parts = [next[0] / lines[0], next[1] / lines[1]];
            let axis = usize::from(lines[0] == 0.0 || parts[1] < parts[0]);
            let part = parts[axis];
            next[axis] += 1.0;
            let place = [0, 1].map(|other| middle[other] as f64 + part * steps[other]);
            let value = self.interpolated(place, 1 - axis);
            if value <= threshold {
                let inner = (before - threshold) / (before - value);
                return (Some(length * (from + inner * (part - from))), length);
            }
            if !value.is_nan() {
                [before, from] = [value, part];
            }
        }
        (None, length)
    }

    /// Returns the function at a place on a grid line, interpolated along an axis.
    fn interpolated(&self, place: [f64; 2], axis: usize) -> f64 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "places are within the grid"
        )]
        let cell = |place: f64| place as usize;
        let size = self.values.grid().size();
        let mut low = [cell(place[0].round()), cell(place[1].round())];
        low[axis] = cell(place[axis]).min(size[axis] - 1);
        let part = place[axis] - low[axis] as f64;
        let at = |cell: [usize; 2]| self.values.as_slice()[cell[1] * size[0] + cell[0]];
        if part == 0.0 {
            return at(low);
        }
        let mut high = low;
        high[axis] = (low[axis] + 1).min(size[axis] - 1);
        (1.0 - part) * at(low) + part * at(high)
    }
}

/// Returns the mean over the torus of the product of a function of the heights with its copy, for every shift of the copy.
/// The function is zero beyond the surface.
fn correlated(heights: &Field, torus: Grid, f: impl Fn(f64) -> f64) -> Field {
    let mut padded = Field::zeros(torus);
    let rows = heights.as_slice().chunks_exact(heights.grid().nx());
    let targets = padded.as_mut_slice().chunks_exact_mut(torus.nx());
    for (row, target) in rows.zip(targets) {
        for (z, target) in row.iter().zip(target) {
            *target = f(*z);
        }
    }
    let mut waves = Waves::of(&padded);
    drop(padded);
    waves.update(|_, amplitude| Complex::from(amplitude.norm_sqr()));
    waves.into_field()
}

/// Returns the products relative to the product without a shift, with the lag zero in the middle.
fn centred(products: &Field, surface: Grid) -> Field {
    let [nx, ny] = products.grid().size();
    let half = surface.size().map(|cells| cells / 2);
    let lags = surface.of_size(half.map(|cells| 2 * cells + 1));
    let without_shift = products.as_slice()[0];
    let wrapped = |lag: usize, half: usize, cells: usize| (lag + cells - half) % cells;
    let mut centred = Field::zeros(lags);
    let rows = centred.as_mut_slice().chunks_exact_mut(lags.nx());
    for (iy, row) in rows.enumerate() {
        let from = wrapped(iy, half[1], ny) * nx;
        for (ix, value) in row.iter_mut().enumerate() {
            *value = products.as_slice()[from + wrapped(ix, half[0], nx)] / without_shift;
        }
    }
    centred
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn autocorrelation_of_wave_is_wave() {
        let grid = Grid::new(60, 20, 0.5, 2.0).unwrap();
        let wave = Field::from_fn(grid, |x, _| 3.0 + 2.0 * (TAU * x / 10.0 + 0.3).sin());
        let found = Autocorrelation::of_periodic(&wave).unwrap();
        let values = found.values();
        assert_eq!(values.grid().size(), [61, 21]);
        let expected = Field::from_fn(values.grid(), |x, _| (TAU * x / 10.0).cos());
        for (found, expected) in values.iter().zip(expected.iter()) {
            assert!((found - expected).abs() < 1e-13);
        }
        // The function is interpolated linearly between lags of 0.5, and it is constant along y up to the lag of 20.
        let short = found.decay_length(0.2).unwrap();
        let exact = 10.0 * 0.2_f64.acos() / TAU;
        assert!((short - exact).abs() < 0.01, "{short} {exact}");
        let ratio = found.texture_aspect_ratio(0.2).unwrap();
        let long = 20.0_f64.hypot(exact);
        assert!((ratio / (exact / long) - 1.0).abs() < 0.01, "{ratio}");
        for threshold in [20.0, 1.0, 0.0, -0.2, f64::NAN] {
            assert_eq!(found.decay_length(threshold), None);
            assert_eq!(found.texture_aspect_ratio(threshold), None);
        }
    }

    #[test]
    fn crossed_waves_have_shortest_decay_along_diagonal() {
        let grid = Grid::square(256, 256.0).unwrap();
        let crossed = Field::from_fn(grid, |x, y| {
            (TAU * x / 128.0).cos() + (TAU * y / 128.0).cos()
        });
        let found = Autocorrelation::of_periodic(&crossed).unwrap();
        // f = (cos kx + cos ky)/2 falls to 0.2 along an axis at arccos(-0.6)/k, along a diagonal at sqrt(2) arccos(0.2)/k.
        let along_axis = (-0.6_f64).acos() / TAU * 128.0;
        let along_diagonal = 2.0_f64.sqrt() * 0.2_f64.acos() / TAU * 128.0;
        let short = found.decay_length(0.2).unwrap();
        let ratio = found.texture_aspect_ratio(0.2).unwrap();
        assert!((short / along_diagonal - 1.0).abs() < 1e-3);
        assert!((ratio / (along_diagonal / along_axis) - 1.0).abs() < 2e-3);
        assert_eq!(found.decay_length(-1.5), None);
    }

    #[test]
    fn surface_with_edges_and_holes_uses_existing_pairs_only() {
        let grid = Grid::new(7, 6, 1.0, 0.5).unwrap();
        let mut heights = Field::from_fn(grid, |x, y| (3.0 * x).sin() + (5.0 * y + x * x).cos());
        for cell in [3, 17, 18] {
            heights.as_mut_slice()[cell] = f64::NAN;
        }
        let found = Autocorrelation::of(&heights).unwrap();
        let measured: Vec<f64> = heights.iter().copied().filter(|z| !z.is_nan()).collect();
        let mean = measured.iter().sum::<f64>() / measured.len() as f64;
        let at = |ix: usize, iy: usize| heights.as_slice()[iy * 7 + ix] - mean;
        let square =
            measured.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / measured.len() as f64;
        for (lag_x, lag_y) in [(0, 0), (1, 0), (3, 3), (2, 1), (0, 3)] {
            let mut products = Vec::new();
            for iy in 0..6 - lag_y {
                for ix in 0..7 - lag_x {
                    let product = at(ix, iy) * at(ix + lag_x, iy + lag_y);
                    if !product.is_nan() {
                        products.push(product);
                    }
                }
            }
            let expected = products.iter().sum::<f64>() / products.len() as f64 / square;
            for (ix, iy) in [(3 + lag_x, 3 + lag_y), (3 - lag_x, 3 - lag_y)] {
                let value = found.values().get(ix, iy).unwrap();
                assert!((value - expected).abs() < 1e-13, "{lag_x} {lag_y}");
            }
        }
    }

    #[test]
    fn profiles_have_one_decay_length() {
        let grid = Grid::new(200, 1, 0.1, 1.0).unwrap();
        let profile = Field::from_fn(grid, |x, _| (TAU * x / 10.0).sin());
        let found = Autocorrelation::of_periodic(&profile).unwrap();
        let short = found.decay_length(0.2).unwrap();
        assert!((short - 10.0 * 0.2_f64.acos() / TAU).abs() < 1e-3);
        assert_eq!(found.texture_aspect_ratio(0.2), Some(1.0));
    }

    #[test]
    fn flat_missing_and_infinite_heights_are_rejected() {
        let grid = Grid::new(4, 3, 1.0, 1.0).unwrap();
        for (value, known) in [(2.0, 1), (f64::NAN, 0)] {
            let outcome = Autocorrelation::of(&Field::constant(grid, value));
            assert!(matches!(outcome, Err(Error::Undetermined { known: k, .. }) if k == known));
        }
        let infinite = Autocorrelation::of(&Field::constant(grid, f64::INFINITY));
        assert!(matches!(infinite, Err(Error::Sample { index: 0, .. })));
    }
}
