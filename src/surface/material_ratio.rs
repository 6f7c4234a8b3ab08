//! Areal material ratio curve of a surface, and the parameters of its core, peaks and valleys.

use super::heights::{about_mean, finite_or_missing, measured_points};
use super::slab::Slab;
use crate::error::{Error, Result, finite, memory};
use crate::grid::field::Field;

/// Part of the material ratio that the equivalent straight line represents.
const CORE: f64 = 0.4;

/// Areal material ratio curve (Abbott-Firestone curve) and the functional parameters of ISO 25178-2:2021.
///
/// The material ratio $`S_{mr}(c)`$ is the fraction of the measured points whose height is at least $`c`$. Heights point out
/// of the body and are relative to their mean. They are not filtered, and no form except the mean is removed. Missing
/// heights (NaN) have no weight. Ratios are fractions, not percentages.
///
/// # Core
/// The *equivalent straight line* of the curve is determined in two steps. First, the secants over 40 % of the material
/// ratio are compared. The first secant of the smallest height difference selects the central region. Then a straight
/// line is fitted to the heights in this region by least squares. The line reaches the heights $`c_1`$ and $`c_2`$ at
/// the material ratios 0 and 1, and
///
/// ```math
/// S_k = c_1 - c_2, \quad S_{mr1} = S_{mr}(c_1), \quad S_{mr2} = S_{mr}(c_2), \quad
/// S_{pk} = \frac{2}{S_{mr1}} \int_{c_1}^\infty S_{mr}\,\mathrm dc, \quad
/// S_{vk} = \frac{2}{1 - S_{mr2}} \int_{-\infty}^{c_2} (1 - S_{mr})\,\mathrm dc .
/// ```
///
/// $`S_{pk}`$ and $`S_{vk}`$ are the heights of the right triangles whose areas equal the areas of peaks and valleys
/// outside the core. They are zero without peaks or valleys.
///
/// The curve of $`n`$ points is a staircase: the $`k`$-th highest point, counted from zero, occupies the ratios from
/// $`k/n`$ to $`(k + 1)/n`$. The fit uses the middle of each stair. Gaussian heights have $`S_k = 2.574\,S_q`$. Heights
/// that are uniformly distributed, as on a triangular wave, have $`S_k = S_z`$ without peaks and valleys.
///
/// # References
/// - ISO 25178-2:2021, areal parameters; ISO 21920-2:2021 (formerly ISO 13565-2) for the equivalent straight line.
///
/// ```
/// use stickslip::{Field, Grid, surface::MaterialRatio};
/// // A ramp: its heights are distributed uniformly from -1 to 1.
/// let grid = Grid::new(1000, 1, 0.002, 1.0)?;
/// let ramp = MaterialRatio::of(&Field::from_fn(grid, |x, _| x))?;
/// assert!((ramp.core_height() - 2.0).abs() < 1e-9);
/// assert!((ramp.material_ratio(0.5) - 0.25).abs() < 1e-3);
/// assert!((ramp.height(0.75) + 0.5).abs() < 1e-9);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MaterialRatio {
    /// Measured heights relative to their mean, from the highest to the deepest.
    heights: Vec<f64>,
    core: Core,
}

/// Parameters of the equivalent straight line.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Core {
    /// Heights of the line at the material ratios 0 and 1.
    limits: [f64; 2],
    /// Material ratios of the curve at these heights.
    ratios: [f64; 2],
    reduced_peak_height: f64,
    reduced_valley_depth: f64,
}

impl MaterialRatio {
    /// Computes the material ratio curve by sorting the measured heights.
    ///
    /// # Errors
    /// - [`Error::Sample`] with the first infinite height.
    /// - [`Error::Undetermined`] if all heights are missing.
    /// - [`Error::NotFinite`] if the range of the heights overflows.
    /// - [`Error::Memory`] if memory runs out.
    /// - [`Error::GridSize`] for a field without cells.
    pub fn of(heights: &Field) -> Result<Self> {
        let slab = Slab::alone(heights)?;
        finite_or_missing(heights)?;
        let points = measured_points(heights, &slab);
        if points == 0 {
            return Err(Error::Undetermined {
                quantity: "surface",
                unknowns: heights.grid().cells(),
                known: 0,
            });
        }
        memory("material ratio curve", heights.grid().size(), 16)?;
        let (deviations, _) = about_mean(heights, &slab, points);
        let mut heights = deviations.into_vec();
        heights.retain(|z| !z.is_nan());
        heights.sort_unstable_by(|a, b| b.total_cmp(a));
        finite("range of the heights", heights[0] - heights[points - 1])?;
        let core = Core::of(&heights);
        Ok(Self { heights, core })
    }

    /// Returns the number of measured heights.
    #[must_use]
    pub fn measured_points(&self) -> usize {
        self.heights.len()
    }

    /// Returns the areal material ratio Smr(c): the fraction of the points that are at least as high as `height` above the
    /// mean (a length). It is NaN for a NaN height.
    #[doc(alias = "Smr")]
    #[must_use]
    pub fn material_ratio(&self, height: f64) -> f64 {
        if height.is_nan() {
            return f64::NAN;
        }
        self.heights.partition_point(|&z| z >= height) as f64 / self.heights.len() as f64
    }

    /// Returns the inverse areal material ratio Smc(p): the height above the mean (a length) at a material ratio from 0 to 1.
    /// The heights are interpolated linearly between the middles of the stairs. Other ratios, such as a ratio in per cent, return NaN.
    #[doc(alias = "Smc")]
    #[must_use]
    pub fn height(&self, material_ratio: f64) -> f64 {
        if !(0.0..=1.0).contains(&material_ratio) {
            return f64::NAN;
        }
        let last = self.heights.len() - 1;
        let place = (material_ratio * self.heights.len() as f64 - 0.5).clamp(0.0, last as f64);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the place is clamped to the indices"
        )]
        let lower = place as usize;
        let upper = (lower + 1).min(last);
        let part = place - lower as f64;
        self.heights[lower] + part * (self.heights[upper] - self.heights[lower])
    }

    /// Returns the core height Sk (a length), the height difference of the equivalent straight line.
    #[doc(alias = "Sk")]
    #[must_use]
    pub fn core_height(&self) -> f64 {
        self.core.limits[0] - self.core.limits[1]
    }

    /// Returns the reduced peak height Spk (a length).
    #[doc(alias = "Spk")]
    #[must_use]
    pub fn reduced_peak_height(&self) -> f64 {
        self.core.reduced_peak_height
    }

    /// Returns the reduced valley depth Svk (a length).
    #[doc(alias = "Svk")]
    #[must_use]
    pub fn reduced_valley_depth(&self) -> f64 {
        self.core.reduced_valley_depth
    }

    /// Returns the material ratio Smr1 that separates the peaks from the core (a fraction).
    #[doc(alias = "Smr1")]
    #[must_use]
    pub fn peak_material_ratio(&self) -> f64 {
        self.core.ratios[0]
    }

    /// Returns the material ratio Smr2 that separates the core from the valleys (a fraction).
    #[doc(alias = "Smr2")]
    #[must_use]
    pub fn valley_material_ratio(&self) -> f64 {
        self.core.ratios[1]
    }
}

impl Core {
    /// Computes the parameters from heights in descending order.
    fn of(heights: &[f64]) -> Self {
        let count = heights.len();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a rounded fraction of a count"
        )]
        let width = (CORE * count as f64).round() as usize;
        let drop = |first: usize| heights[first] - heights[first + width];
        let mut first = 0;
        for start in 1..count - width {
            if drop(start) < drop(first) {
                first = start;
            }
        }
        let region = &heights[first..=first + width];
        let mean = region.iter().sum::<f64>() / region.len() as f64;
        let middle = 0.5 * (region.len() - 1) as f64;
        let [mut product, mut square] = [0.0, 0.0];
        for (k, z) in region.iter().enumerate() {
            let distance = k as f64 - middle;
            product += distance * (z - mean);
            square += distance * distance;
        }
        // A single point has no slope.
        let slope = if square > 0.0 { product / square } else { 0.0 };
        // The stairs of all points extend from minus one half to `count` minus one half.
        let at = |place: f64| mean + slope * (place - 0.5 - first as f64 - middle);
        let limits = [at(0.0), at(count as f64)];
        let ends = [
            heights.partition_point(|&z| z > limits[0]),
            heights.partition_point(|&z| z >= limits[1]),
        ];
        let mean_excess = |peaks: &[f64], from: f64| {
            // The standard sum of no numbers is -0.0.
            let excess = peaks.iter().fold(0.0, |sum, z| sum + (z - from).abs());
            excess / peaks.len().max(1) as f64
        };
        Self {
            limits,
            ratios: ends.map(|end| end as f64 / count as f64),
            reduced_peak_height: 2.0 * mean_excess(&heights[..ends[0]], limits[0]),
            reduced_valley_depth: 2.0 * mean_excess(&heights[ends[1]..], limits[1]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Grid;

    fn profile(heights: Vec<f64>) -> Field {
        let grid = Grid::new(heights.len(), 1, 1.0, 1.0).unwrap();
        Field::from_vec(grid, heights).unwrap()
    }

    /// Returns the density and the distribution function of the standard normal distribution, by the trapezoidal rule.
    fn normal(z: f64) -> [f64; 2] {
        let density = |t: f64| (-0.5 * t * t).exp() / std::f64::consts::TAU.sqrt();
        let steps = 400;
        let step = z / f64::from(steps);
        let inner: f64 = (1..steps).map(|k| density(step * f64::from(k))).sum();
        let ends = 0.5 * (density(0.0) + density(z));
        [density(z), 0.5 + step * (inner + ends)]
    }

    fn quantile(ratio: f64) -> f64 {
        let [mut low, mut high] = [-6.0, 6.0];
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if normal(middle)[1] < ratio {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    #[test]
    fn core_of_gaussian_heights_has_closed_form() {
        let count = 1000_u32;
        let heights = (0..count)
            .map(|k| quantile((f64::from(k) + 0.5) / f64::from(count)))
            .collect();
        let found = MaterialRatio::of(&profile(heights)).unwrap();
        // The slope of the least-squares line over the ratios 0.3 to 0.7 is the integral of (p - 1/2) times the quantile,
        // divided by 0.4^3/12. With p = Phi(z), the integral is erf(a)/(2 sqrt(pi)) - 0.4 phi(a) for Phi(a) = 0.7.
        let a = quantile(0.7);
        let error_function = 2.0 * normal(a * 2.0_f64.sqrt())[1] - 1.0;
        let integral = error_function / (2.0 * std::f64::consts::PI.sqrt()) - 0.4 * normal(a)[0];
        let core = integral / (0.4_f64.powi(3) / 12.0);
        assert!((core - 2.573_956).abs() < 1e-4);
        assert!((found.core_height() - core).abs() < 2e-3 * core);
        // Peaks above c = Sk/2 have the mean excess phi(c)/(1 - Phi(c)) - c.
        let c = 0.5 * core;
        let [density, distribution] = normal(c);
        let tail = 1.0 - distribution;
        let peak = 2.0 * (density / tail - c);
        assert!((found.peak_material_ratio() - tail).abs() < 1e-3);
        assert!((found.valley_material_ratio() - distribution).abs() < 1e-3);
        assert!((found.reduced_peak_height() - peak).abs() < 5e-3 * peak);
        assert!((found.reduced_valley_depth() - peak).abs() < 5e-3 * peak);
    }

    #[test]
    fn triangular_wave_has_straight_curve_without_peaks_and_valleys() {
        let rise = (0..50).map(|k| f64::from(k) - 24.5);
        let wave: Vec<f64> = rise.clone().chain(rise.rev()).collect();
        let found = MaterialRatio::of(&profile([&wave[..], &wave].concat())).unwrap();
        // Four points per level: the stairs of a level reach half a point beyond the mean of its points.
        assert!((found.core_height() - 50.0).abs() < 0.1);
        assert!(found.peak_material_ratio() < 1e-12);
        assert!(found.valley_material_ratio() > 1.0 - 1e-12);
        assert!(found.reduced_peak_height() == 0.0 && found.reduced_valley_depth() == 0.0);
        for (height, ratio) in [(-30.0, 1.0), (0.0, 0.5), (12.0, 0.26), (30.0, 0.0)] {
            assert!((found.material_ratio(height) - ratio).abs() < 1e-12);
        }
    }

    #[test]
    fn plateau_with_grooves_has_valleys_only() {
        // 900 points from 1 to -1, and 100 points of grooves from -1 to -21.
        let plateau = (0..900).map(|k| 1.0 - (f64::from(k) + 0.5) / 450.0);
        let grooves = (0..100).map(|k| -1.0 - (f64::from(k) + 0.5) / 5.0);
        let mut heights: Vec<f64> = plateau.chain(grooves).collect();
        heights.reverse();
        heights.insert(500, f64::NAN);
        let found = MaterialRatio::of(&profile(heights)).unwrap();
        assert_eq!(found.measured_points(), 1000);
        // The line continues the plateau to the ratio 1, where its height is 1 - 2/0.9.
        let core = 2.0 / 0.9;
        assert!((found.core_height() - core).abs() < 1e-9);
        assert!(found.peak_material_ratio() < 1e-12);
        // The grooves pass the lower end of the line at the depth core - 2 below the plateau, 1/20 of their width per unit.
        let remaining = 0.1 * (1.0 - (core - 2.0) / 20.0);
        assert!((1.0 - found.valley_material_ratio() - remaining).abs() < 1.5e-3);
        assert!((found.reduced_valley_depth() - (20.0 - (core - 2.0))).abs() < 0.2);
    }

    #[test]
    fn flat_surface_and_single_point_have_zero_heights() {
        for heights in [vec![3.0; 10], vec![3.0], vec![1.0, 2.0]] {
            let is_flat = heights.len() != 2;
            let found = MaterialRatio::of(&profile(heights)).unwrap();
            assert!(found.core_height().is_finite());
            assert!(!is_flat || found.core_height() == 0.0);
            assert!(found.height(0.5).abs() < f64::MIN_POSITIVE);
            assert!(
                [f64::NAN, -0.1, 50.0]
                    .map(|ratio| found.height(ratio))
                    .iter()
                    .all(|height| height.is_nan())
            );
            assert!(found.material_ratio(f64::NAN).is_nan());
        }
        let missing = MaterialRatio::of(&profile(vec![f64::NAN; 3]));
        assert!(matches!(missing, Err(Error::Undetermined { known: 0, .. })));
        let infinite = MaterialRatio::of(&profile(vec![1.0, f64::INFINITY]));
        assert!(matches!(infinite, Err(Error::Sample { index: 1, .. })));
    }
}
