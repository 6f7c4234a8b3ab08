//! Heights of a given skewness and kurtosis: Johnson's system of distributions.

use std::f64::consts::TAU;

/// Curve that maps a standard normal number `g` to a Johnson distribution of positive skewness.
#[derive(Debug, Clone, Copy)]
struct Curve {
    is_bounded: bool,
    /// `1/delta`, the strength of the nonlinearity.
    steepness: f64,
    /// `gamma/delta`, the deviation from symmetry.
    offset: f64,
}

impl Curve {
    /// Evaluates the curve: `sinh` for heavy tails, the logistic function for light tails. For a large offset both
    /// functions approach `exp`, which gives the lognormal distribution.
    fn bend(&self, g: f64) -> f64 {
        if self.is_bounded {
            let power = (self.steepness * g - self.offset).exp();
            power / (1.0 + power)
        } else {
            (self.steepness * g + self.offset).sinh()
        }
    }

    /// Computes skewness and kurtosis by the trapezoidal rule.
    fn moments(&self) -> [f64; 2] {
        let nodes = -90..=90;
        let samples: Vec<_> = nodes
            .map(|node| 0.1 * f64::from(node))
            .map(|g| ((-0.5 * g * g).exp(), self.bend(g)))
            .collect();
        let mean_of = |f: &dyn Fn(f64) -> f64| {
            let sum: f64 = samples.iter().map(|(weight, v)| weight * f(*v)).sum();
            sum * 0.1 / TAU.sqrt()
        };
        let mean = mean_of(&|v| v);
        let deviation = mean_of(&|v| (v - mean).powi(2)).sqrt();
        [3, 4].map(|power| mean_of(&|v| ((v - mean) / deviation).powi(power)))
    }
}

/// Largest offset, at which the curve is exponential to within round-off.
const LARGEST_OFFSET: f64 = 20.0;
/// Smallest and largest steepness. The flattest curve is close to the normal distribution. The steepest curve is close
/// to a distribution of two values or of infinite kurtosis.
const STEEPNESS: [f64; 2] = [0.05, 5.0];

/// Computes the curve of the given skewness (not negative) and kurtosis. The result is accurate enough to start an
/// iteration.
fn curve(skewness: f64, kurtosis: f64) -> Curve {
    // The kurtosis of the lognormal distribution of this skewness is given by Johnson (1949).
    let half = 1.0 + 0.5 * skewness * skewness;
    let root = (half + (half * half - 1.0).sqrt()).cbrt();
    let omega = root + 1.0 / root - 1.0;
    let lognormal_kurtosis = omega.powi(4) + 2.0 * omega.powi(3) + 3.0 * omega.powi(2) - 3.0;
    let is_bounded = kurtosis < lognormal_kurtosis;

    // As the curve becomes steeper, its kurtosis moves away from the lognormal value.
    let flattest = omega.ln().sqrt().max(STEEPNESS[0]);
    let of_skewness = |steepness: f64| {
        let with = |offset| Curve {
            is_bounded,
            steepness,
            offset,
        };
        with(bisect([0.0, LARGEST_OFFSET], |offset| {
            with(offset).moments()[0] < skewness
        }))
    };
    let steepness = bisect([flattest, STEEPNESS[1].max(flattest)], |steepness| {
        (of_skewness(steepness).moments()[1] > kurtosis) == is_bounded
    });
    of_skewness(steepness)
}

/// Computes the largest number that satisfies a monotonic condition, to one part in a million of the interval.
fn bisect([mut low, mut high]: [f64; 2], holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..20 {
        let middle = 0.5 * (low + high);
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Returns `count` heights in ascending order, at equal steps of probability. Their distribution has approximately the
/// given skewness and kurtosis. The mean and the unit of the heights are arbitrary.
pub(super) fn sorted_heights([skewness, kurtosis]: [f64; 2], count: usize) -> Vec<f64> {
    let curve = curve(skewness.abs(), kurtosis);
    let mut heights: Vec<_> = sorted_normal(count).map(|g| curve.bend(g)).collect();
    if skewness < 0.0 {
        heights.reverse();
        for height in &mut heights {
            *height = -*height;
        }
    }
    heights
}

/// Returns `count` normal numbers in ascending order, one for each of `count` intervals of equal probability.
fn sorted_normal(count: usize) -> impl Iterator<Item = f64> {
    const STEP: f64 = 0.01;
    let density = |g: f64| (-0.5 * g * g).exp() / TAU.sqrt();
    // The probability of each step follows from Simpson's rule. The steps start at -9, because the probability of
    // smaller values is negligible.
    let step = move |low: f64| {
        let inner = 4.0 * density(low + 0.5 * STEP);
        STEP / 6.0 * (density(low) + inner + density(low + STEP))
    };
    let (mut low, mut below, mut within) = (-9.0, 0.0, step(-9.0));
    (0..count).map(move |index| {
        let wanted = (index as f64 + 0.5) / count as f64;
        while below + within < wanted && low < 9.0 {
            below += within;
            low += STEP;
            within = step(low);
        }
        low + STEP * ((wanted - below) / within).min(1.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_have_about_the_moments_asked_for() {
        for (skewness, kurtosis) in [
            (0.0, 1.8),
            (0.0, 2.5),
            (0.0, 3.0),
            (0.0, 6.0),
            (-0.3, 3.0),
            (0.5, 2.0),
            (0.5, 3.443), // lognormal
            (-1.0, 2.5),
            (1.0, 6.0),
            (2.0, 9.0),
        ] {
            let heights = sorted_heights([skewness, kurtosis], 100_000);
            assert!(heights.is_sorted());
            let mean_of = |f: &dyn Fn(f64) -> f64| {
                heights.iter().map(|z| f(*z)).sum::<f64>() / heights.len() as f64
            };
            let mean = mean_of(&|z| z);
            let deviation = mean_of(&|z| (z - mean).powi(2)).sqrt();
            let reached = [3, 4].map(|power| mean_of(&|z| ((z - mean) / deviation).powi(power)));
            let error = [reached[0] - skewness, reached[1] - kurtosis];
            assert!(error[0].abs() < 0.01, "{skewness} {kurtosis}: {reached:?}");
            // A hundred thousand heights do not resolve the extreme part of heavy tails.
            assert!(
                error[1].abs() < 0.02 * kurtosis,
                "{skewness} {kurtosis}: {reached:?}"
            );
        }
    }

    #[test]
    fn normal_numbers_divide_the_probability() {
        let numbers: Vec<_> = sorted_normal(1001).collect();
        assert!(numbers[500].abs() < 1e-6);
        assert!((numbers[841] - 0.99717).abs() < 1e-4); // Quantile of 841.5/1001.
        assert!((numbers[0] + 3.29081).abs() < 1e-4); // Quantile of 0.5/1001.
        for (low, high) in numbers.iter().zip(numbers.iter().rev()) {
            assert!((low + high).abs() < 1e-6);
        }
    }
}
