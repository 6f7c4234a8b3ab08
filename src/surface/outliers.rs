//! Removal of outliers from a measured surface.

use super::fill::fill_missing;
use super::heights::finite_or_missing;
use crate::error::{Error, Result, non_negative};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::parallel;

/// Ratio of the standard deviation to the median absolute deviation of normally distributed numbers.
const NORMAL: f64 = 1.482_602_218_505_602;

/// Part of the largest height below which a deviation is round-off.
const ROUND_OFF: f64 = 1e-12;

/// Removal of outliers: points that are not typical of the heights around them, such as spikes of an optical instrument.
///
/// The deviation of a point is its height minus the median of the means of pairs. A pair consists of two measured points
/// on opposite sides of the point, up to `radius` cells away along each axis (default 2, so 12 pairs). A tilt therefore
/// causes no deviation, even at an edge. A point is an outlier if the size of its deviation exceeds
///
/// ```math
/// k\,\max(\sigma,\ \sigma_{\text{local}})
/// ```
///
/// with the threshold $`k`$. The scale $`\sigma`$ is 1.4826 times the median of the sizes of the deviations of all points. It
/// estimates the standard deviation of the deviations. Outliers have little effect on a median.
///
/// The local scale distinguishes an outlier from an edge, ridge or groove of the surface. All points along an edge deviate,
/// whereas an outlier deviates alone. A straight line through the point contains `2 radius` of the other points that are at
/// most `radius` cells away along each axis. The scale $`\sigma_{\text{local}}`$ is the deviation with this rank (the fourth
/// largest of 24), divided by its value for a standard normal distribution. Near missing heights and edges of the grid, the
/// rank is reduced in proportion to the number of other points.
///
/// The points are examined in the order of their deviations, the largest first. The deviation of a point is computed again
/// without previous outliers, and must again exceed the limit.
///
/// # Accuracy
/// - Smooth surfaces lose no points: spheres, waves, steps, ramps, cones and pyramids at the default radius and $`k = 6`$. At
///   $`k = 3`$ some points of oblique edges of a surface without roughness are outliers.
/// - The threshold $`k = 3`$ removes about 0.3 % of normally distributed independent heights.
/// - A group of more than `2 radius` outliers counts as an edge. Use a larger radius to remove it.
/// - An outlier next to an edge is detected only if it exceeds the deviation at the edge several times.
/// - On a single row of cells, the point of a ridge deviates alone and is an outlier.
/// - The corner points of the surface have no pairs and are not outliers. Deviations below 1e-12 of the largest height are
///   round-off.
///
/// # References
/// - ISO 16610-1 and ISO 25178-2 define outliers and leave the method open.
/// - F. R. Hampel, The influence curve and its role in robust estimation, *J. Am. Stat. Assoc.* 69 (1974) 383-393,
///   [doi:10.1080/01621459.1974.10482962](https://doi.org/10.1080/01621459.1974.10482962), for the median and its scale.
///
/// ```
/// use stickslip::{Field, Grid, surface::OutlierFilter};
/// let grid = Grid::square(32, 32.0)?;
/// let clean = Field::from_fn(grid, |x, y| 0.1 * x + (0.3 * y).sin());
/// let mut measured = clean.clone();
/// measured.as_mut_slice()[500] += 50.0;
/// let found = OutlierFilter::new(6.0).apply(&measured)?;
/// assert_eq!(found.outliers(), &[500]);
/// assert!(found.heights().as_slice()[500].is_nan());
/// let height = found.interpolated()?.as_slice()[500];
/// assert!((height - clean.as_slice()[500]).abs() < 0.05);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct OutlierFilter {
    threshold: f64,
    radius: usize,
}

/// A surface without its outliers.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct WithoutOutliers {
    heights: Field,
    outliers: Vec<usize>,
}

impl WithoutOutliers {
    /// Returns the heights (lengths), with NaN at the outliers. Missing heights stay missing.
    #[must_use]
    pub fn heights(&self) -> &Field {
        &self.heights
    }

    /// Returns the cells of the outliers in ascending order, as indices of the samples.
    #[must_use]
    pub fn outliers(&self) -> &[usize] {
        &self.outliers
    }

    /// Returns the heights (lengths) with interpolated heights at the outliers, as by [`fill_missing`]. Heights that were
    /// missing before stay missing.
    ///
    /// # Errors
    /// - [`Error::Undetermined`] if no measured height remains.
    /// - [`Error::NotConverged`] as for [`fill_missing`].
    pub fn interpolated(&self) -> Result<Field> {
        let mut heights = self.heights.clone();
        if self.outliers.is_empty() {
            return Ok(heights);
        }
        let filled = fill_missing(&self.heights)?.into_heights();
        for &cell in &self.outliers {
            if let (Some(height), Some(filled)) = (
                heights.as_mut_slice().get_mut(cell),
                filled.as_slice().get(cell),
            ) {
                *height = *filled;
            }
        }
        Ok(heights)
    }

    /// Returns the heights with NaN at the outliers, without the list of the outliers.
    #[must_use]
    pub fn into_heights(self) -> Field {
        self.heights
    }
}

impl OutlierFilter {
    /// Creates a filter with the threshold $`k`$, in estimated standard deviations, and the radius 2.
    #[must_use]
    pub fn new(threshold: f64) -> Self {
        Self {
            threshold,
            radius: 2,
        }
    }

    /// Sets the radius of the pairs in cells (default 2). It must be at least 1.
    #[must_use]
    pub fn radius(mut self, cells: usize) -> Self {
        self.radius = cells;
        self
    }

    /// Removes the outliers of a surface.
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`] for a threshold that is negative or not finite.
    /// - [`Error::BelowMinimum`] for the radius zero.
    /// - [`Error::Sample`] with the first infinite height.
    pub fn apply(&self, heights: &Field) -> Result<WithoutOutliers> {
        let threshold = non_negative("threshold of the outliers", self.threshold)?;
        if self.radius == 0 {
            return Err(Error::BelowMinimum {
                quantity: "radius of the pairs",
                value: 0.0,
                least: 1.0,
                least_is: "one cell",
            });
        }
        finite_or_missing(heights)?;
        let grid = heights.grid();
        let mut deviations = vec![f64::NAN; grid.cells()];
        parallel::rows(&mut deviations, grid.nx().max(1), |iy, row| {
            let mut means = Vec::new();
            for (ix, deviation) in row.iter_mut().enumerate() {
                *deviation = self.deviation(heights, [ix, iy], &mut means);
            }
        });
        let mut sizes: Vec<f64> = deviations.iter().map(|d| d.abs()).collect();
        sizes.retain(|size| !size.is_nan());
        let scale = NORMAL * nearest_median(&mut sizes, 0.0).unwrap_or(0.0);
        let largest = heights.max().abs().max(heights.min().abs());
        let limit = (threshold * scale).max(ROUND_OFF * largest);
        let mut candidates: Vec<usize> = (0..grid.cells())
            .filter(|&cell| deviations[cell].abs() > limit)
            .collect();
        // A candidate next to an outlier may be typical of the other points.
        candidates.sort_by(|&a, &b| deviations[b].abs().total_cmp(&deviations[a].abs()));
        let mut heights = heights.clone();
        let (mut outliers, mut values) = (Vec::new(), Vec::new());
        for cell in candidates {
            let place = [cell % grid.nx(), cell / grid.nx()];
            let local = self.local_scale(&deviations, grid, place, &mut values);
            let limit = limit.max(threshold * local);
            let again = self.deviation(&heights, place, &mut values);
            if deviations[cell].abs() > limit && again.abs() > limit {
                heights.as_mut_slice()[cell] = f64::NAN;
                deviations[cell] = f64::NAN;
                outliers.push(cell);
            }
        }
        outliers.sort_unstable();
        Ok(WithoutOutliers { heights, outliers })
    }

    /// Estimates the standard deviation of the deviations around a point from the rank that separates a line of points from
    /// single points. The result is zero for a point without neighbours.
    fn local_scale(
        &self,
        deviations: &[f64],
        grid: Grid,
        [ix, iy]: [usize; 2],
        sizes: &mut Vec<f64>,
    ) -> f64 {
        let [nx, ny] = grid.size();
        let around = |at: usize, cells: usize| {
            at.saturating_sub(self.radius)
                ..at.saturating_add(self.radius).saturating_add(1).min(cells)
        };
        sizes.clear();
        for y in around(iy, ny) {
            for x in around(ix, nx).filter(|x| [*x, y] != [ix, iy]) {
                let size = deviations[y * nx + x].abs();
                if !size.is_nan() {
                    sizes.push(size);
                }
            }
        }
        if sizes.is_empty() {
            return 0.0;
        }
        let side = 2.0 * self.radius as f64 + 1.0;
        let (count, line) = (sizes.len(), (side - 1.0) / (side * side - 1.0));
        let rank = whole_part(line * count as f64).clamp(1, count);
        let (_, &mut size, _) = sizes.select_nth_unstable_by(count - rank, f64::total_cmp);
        // Blom's plotting position of a normal order statistic.
        let exceeded = (rank as f64 - 0.375) / (count as f64 + 0.25);
        size / normal_size(exceeded)
    }

    /// Computes the height of a point minus the median of the means of the pairs around it. The result is NaN for a missing
    /// point and for a point without pairs.
    fn deviation(&self, heights: &Field, [ix, iy]: [usize; 2], means: &mut Vec<f64>) -> f64 {
        let [nx, ny] = heights.grid().size();
        let z = heights.as_slice();
        let height = z[iy * nx + ix];
        if height.is_nan() {
            return f64::NAN;
        }
        let reach = |at: usize, cells: usize| self.radius.min(at).min(cells - 1 - at);
        let (reach_x, reach_y) = (reach(ix, nx), reach(iy, ny));
        means.clear();
        for up in 0..=reach_y {
            // In the row of the point, the points on the left are opposite to those on the right.
            let first = if up == 0 { ix + 1 } else { ix - reach_x };
            for x in first..=ix + reach_x {
                let mean = 0.5 * z[(iy + up) * nx + x] + 0.5 * z[(iy - up) * nx + (2 * ix - x)];
                if !mean.is_nan() {
                    means.push(mean);
                }
            }
        }
        nearest_median(means, height).map_or(f64::NAN, |median| height - median)
    }
}

/// Returns the integer part of a number that is positive.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the number is positive and not above a number of cells"
)]
fn whole_part(value: f64) -> usize {
    value as usize
}

/// Returns the size that a standard normal number exceeds with a probability between 0 and 1, with an error below 1e-3.
/// Abramowitz and Stegun (1964), 26.2.23.
fn normal_size(probability: f64) -> f64 {
    let t = (-2.0 * (0.5 * probability).ln()).sqrt();
    let numerator = 2.515_517 + t * (0.802_853 + t * 0.010_328);
    let denominator = 1.0 + t * (1.432_788 + t * (0.189_269 + t * 0.001_308));
    t - numerator / denominator
}

/// Returns the median of the values, whose order changes, or `None` without values. An even number of values has two medians. The
/// result is the median nearer to `target`.
fn nearest_median(values: &mut [f64], target: f64) -> Option<f64> {
    if values.is_empty() {
        return None;
    }
    let count = values.len();
    let (below, &mut upper, _) = values.select_nth_unstable_by(count / 2, f64::total_cmp);
    let lower = below.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let is_lower = count % 2 == 0 && (lower - target).abs() < (upper - target).abs();
    Some(if is_lower { lower } else { upper })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rough(grid: Grid) -> Field {
        let mut state = 1_u64;
        Field::from_fn(grid, |x, y| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            let noise = (state >> 40) as f64 / (1_u64 << 24) as f64 - 0.5;
            0.05 * x + (0.2 * y).cos() + 0.02 * noise
        })
    }

    #[test]
    fn spikes_are_removed_and_all_other_points_stay() {
        let grid = Grid::new(40, 30, 1.0, 1.0).unwrap();
        let clean = rough(grid);
        let mut measured = clean.clone();
        // One spike at an edge, two neighbouring spikes inside, and one spike next to a hole.
        let spikes = [20, 15 * 40 + 7, 15 * 40 + 8, 20 * 40 + 31];
        for cell in spikes {
            measured.as_mut_slice()[cell] += if cell % 2 == 0 { 3.0 } else { -3.0 };
        }
        measured.as_mut_slice()[20 * 40 + 32] = f64::NAN;
        let found = OutlierFilter::new(8.0).apply(&measured).unwrap();
        assert_eq!(found.outliers(), spikes);
        let filled = found.interpolated().unwrap();
        for cell in 0..grid.cells() {
            let [z, filled, clean] =
                [found.heights(), &filled, &clean].map(|field| field.as_slice()[cell]);
            if spikes.contains(&cell) {
                assert!(
                    z.is_nan() && (filled - clean).abs() < 0.2,
                    "{filled} {clean}"
                );
            } else if cell == 20 * 40 + 32 {
                assert!(z.is_nan() && filled.is_nan());
            } else {
                assert!(z.to_bits() == clean.to_bits() && filled.to_bits() == clean.to_bits());
            }
        }
    }

    #[test]
    fn plane_without_noise_has_no_outlier_even_at_its_edges() {
        let grid = Grid::new(12, 9, 0.1, 0.3).unwrap();
        let mut plane = Field::from_fn(grid, |x, y| 1e3 + 0.7 * x - 0.4 * y);
        let found = OutlierFilter::new(3.0).apply(&plane).unwrap();
        assert_eq!(found.outliers(), &[] as &[usize]);
        assert_eq!(found.interpolated().unwrap(), plane);
        // A small spike inside, and one next to a corner.
        plane.as_mut_slice()[40] += 1e-3;
        plane.as_mut_slice()[2] -= 1e-3;
        for radius in [1, 2] {
            let found = OutlierFilter::new(3.0)
                .radius(radius)
                .apply(&plane)
                .unwrap();
            assert_eq!(found.outliers(), &[2, 40]);
        }
    }

    /// Name of a surface and its height at a point.
    type Named<'a> = (&'a str, &'a dyn Fn(f64, f64) -> f64);

    #[test]
    fn smooth_surfaces_with_edges_lose_no_point() {
        let grid = Grid::square(48, 48.0).unwrap();
        let (sine, cosine) = 0.47_f64.sin_cos();
        let along = move |x: f64, y: f64| cosine * x + sine * y;
        let surfaces: [Named<'_>; 13] = [
            ("sphere", &|x, y| (1200.0 - x * x - y * y).max(0.0).sqrt()),
            ("sphere on a plane", &|x, y| {
                (400.0 - x * x - y * y).max(0.0).sqrt()
            }),
            ("ramp", &|x, _| x.max(0.0)),
            ("oblique ramp", &|x, y| along(x, y).max(0.0)),
            ("ridge", &|x, _| -(x - 0.5).abs()),
            ("wave", &|x, y| (0.7 * x).sin() * (0.5 * y).sin()),
            ("wave on a plane", &|x, _| {
                if x.abs() < 8.0 {
                    1.0 + (0.125 * x * std::f64::consts::PI).cos()
                } else {
                    0.0
                }
            }),
            ("step", &|x, y| 0.3 * x - 0.2 * y + f64::from(x > 0.0)),
            ("oblique step", &|x, y| f64::from(along(x, y) > 0.0)),
            ("square", &|x, y| f64::from(x.abs().max(y.abs()) < 9.0)),
            ("punch", &|x, y| f64::from(x.hypot(y) < 11.0)),
            ("cone", &|x, y| (8.0 - x.hypot(y)).max(0.0)),
            ("pyramid", &|x, y| -(x - 0.5).abs().max((y - 0.5).abs())),
        ];
        for (name, surface) in surfaces {
            let clean = Field::from_fn(grid, surface);
            let found = OutlierFilter::new(6.0).apply(&clean).unwrap();
            assert_eq!(found.outliers(), &[] as &[usize], "{name}");
            // A spike is found at a distance from the edges, which cause larger deviations.
            let mut measured = clean;
            measured.as_mut_slice()[5 * 48 + 5] += 9.0;
            let found = OutlierFilter::new(6.0).apply(&measured).unwrap();
            assert_eq!(found.outliers(), &[5 * 48 + 5], "{name}");
        }
    }

    #[test]
    fn normal_noise_loses_expected_fraction() {
        // The sum of twelve uniform numbers is nearly normal. A fraction of 0.27 % of a normal distribution is beyond
        // three sigma.
        let mut state = 7_u64;
        let mut uniform = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let grid = Grid::square(200, 1.0).unwrap();
        let noise = Field::from_fn(grid, |_, _| (0..12).map(|_| uniform()).sum::<f64>());
        for radius in [2, 5] {
            let filter = OutlierFilter::new(3.0).radius(radius);
            let found = filter.apply(&noise).unwrap();
            let fraction = found.outliers().len() as f64 / grid.cells() as f64;
            assert!((0.0015..0.004).contains(&fraction), "{fraction}");
        }
    }

    #[test]
    fn invalid_filters_and_heights_are_rejected() {
        let grid = Grid::new(4, 3, 1.0, 1.0).unwrap();
        let flat = Field::constant(grid, 1.0);
        let negative = OutlierFilter::new(-1.0).apply(&flat);
        assert!(matches!(negative, Err(Error::NegativeOrNotFinite { .. })));
        let narrow = OutlierFilter::new(3.0).radius(0).apply(&flat);
        assert!(matches!(narrow, Err(Error::BelowMinimum { .. })));
        let infinite = OutlierFilter::new(3.0).apply(&Field::constant(grid, f64::INFINITY));
        assert!(matches!(infinite, Err(Error::Sample { index: 0, .. })));
        let missing = OutlierFilter::new(3.0).apply(&Field::constant(grid, f64::NAN));
        assert!(missing.unwrap().outliers().is_empty());
    }
}
