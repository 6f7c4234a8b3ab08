//! Energy of uniform tractions on a grid that is periodic along y alone.

use crate::error::{Error, Result};
use crate::fft::Convolution;
use crate::memory::fallible;
use crate::operator::Operator;
use crate::parallel::layout::Layout;
use crate::parallel::reduce;

/// Lower bound of the energy of a traction component whose sum is not zero.
///
/// The unit vector e of a uniform traction and tractions w without a mean span all tractions. Let z be a given vector
/// without a mean, $`u = e - z`$, and $`\sigma = u' C u`$. Let $`\rho`$ be $`C u`$ minus its mean. With
/// $`w = v - \xi z`$ and the least eigenvalue $`\lambda`$ of the tractions without a mean,
///
/// ```math
/// (\xi e + w)' C (\xi e + w) \ge \sigma \xi^2 - 2 |\rho| |\xi| |v| + \lambda |v|^2 .
/// ```
///
/// The right-hand side is positive if $`\sigma \lambda > |\rho|^2`$. For the traction of a flat punch as wide as the
/// grid, $`\rho`$ vanishes. Conjugate gradients approximate this traction. The bound is sharp for this traction: the
/// compliance is positive definite if and only if the approach of the punch is positive. A change of the datum changes
/// only $`\sigma`$.
#[derive(Debug, Clone, Copy)]
pub(crate) struct UniformWave {
    /// Energy $`\sigma`$.
    energy: f64,
    /// Norm $`|\rho|`$.
    residual: f64,
    /// Norm $`|z|`$.
    deviation: f64,
    /// Distance at which a line load causes no displacement.
    datum: f64,
    /// Derivative of the energy with respect to the logarithm of the datum.
    slope: f64,
}

/// Fraction of $`\sigma \lambda`$ to which $`|\rho|^2`$ is reduced.
const SHARPNESS: f64 = 1e-8;

/// Maximum number of conjugate-gradient steps per cell.
const STEPS: usize = 4;

impl UniformWave {
    /// Computes the traction of a flat punch on a line of cells. `least` is the smallest eigenvalue for tractions
    /// without a mean.
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out.
    pub(crate) fn new(line: &Convolution, least: f64, [datum, slope]: [f64; 2]) -> Result<Self> {
        let (cells, layout) = (line.cells(), &line.layout());
        let mut scratch = line.scratch()?;
        let mut traction = fallible::filled(1.0 / (cells as f64).sqrt(), cells)?;
        let mut residual: Vec<f64> = fallible::zeros(cells)?;
        let mut image: Vec<f64> = fallible::zeros(cells)?;
        line.apply([&traction], [&mut residual], &mut scratch);
        let mut energy = dot(layout, &traction, &residual);
        subtract_mean(layout, &mut residual);
        let mut direction: Vec<f64> = fallible::zeros(cells)?;
        direction.copy_from_slice(&residual);
        let mut square = dot(layout, &residual, &residual);
        for _ in 0..STEPS * cells {
            if square <= SHARPNESS * energy.abs() * least {
                break;
            }
            line.apply([&direction], [&mut image], &mut scratch);
            subtract_mean(layout, &mut image);
            let curvature = dot(layout, &direction, &image);
            if curvature <= 0.0 {
                break;
            }
            let step = square / curvature;
            add(&mut traction, -step, &direction);
            add(&mut residual, -step, &image);
            energy -= step * square;
            let last = std::mem::replace(&mut square, dot(layout, &residual, &residual));
            for (direction, residual) in direction.iter_mut().zip(&residual) {
                *direction = residual + square / last * *direction;
            }
        }
        // A new product removes the round-off accumulated during the steps.
        line.apply([&traction], [&mut residual], &mut scratch);
        let energy = dot(layout, &traction, &residual);
        subtract_mean(layout, &mut residual);
        subtract_mean(layout, &mut traction);
        let round_off = 1e-14 * line.upper_bound();
        Ok(Self {
            energy: energy - round_off,
            residual: dot(layout, &residual, &residual).sqrt() + round_off,
            deviation: dot(layout, &traction, &traction).sqrt(),
            datum,
            slope,
        })
    }

    /// Returns a lower bound of the eigenvalues of all tractions, negative if the compliance is not positive definite.
    /// `added` is the compliance of a uniform traction in addition to the bodies, such as the compliance of a spring.
    pub(crate) fn bound(&self, least: f64, added: f64) -> f64 {
        let Self {
            residual,
            deviation,
            ..
        } = *self;
        let energy = self.energy + added;
        let determinant = energy * least - residual * residual;
        let trace =
            energy.abs() + 2.0 * residual * deviation + least * (1.0 + deviation * deviation);
        (determinant / trace).min(least)
    }

    /// Returns the error of a problem whose solution is not unique because the datum is too near.
    pub(crate) fn too_near(&self, least: f64, added: f64) -> Error {
        let missing = self.residual * self.residual / least - self.energy - added;
        Error::DatumTooNear {
            datum: self.datum,
            least: self.datum * (missing / self.slope).exp(),
        }
    }
}

fn dot(layout: &Layout, a: &[f64], b: &[f64]) -> f64 {
    reduce::sum(layout, |i| a[i] * b[i])
}

fn add(to: &mut [f64], factor: f64, what: &[f64]) {
    for (to, what) in to.iter_mut().zip(what) {
        *to += factor * what;
    }
}

fn subtract_mean(layout: &Layout, values: &mut [f64]) {
    let mean = reduce::total(layout, values) / values.len() as f64;
    for value in values {
        *value -= mean;
    }
}
