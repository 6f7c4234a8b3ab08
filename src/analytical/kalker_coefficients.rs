//! Creep forces of an elliptic contact without slip.

use super::kalker_table::TABLE;
use crate::error::{Error, Result, at_least, positive};

/// Kalker's creepage and spin coefficients. They give the forces of an elliptic contact that rolls with creepages so small that
/// it slips only at its trailing edge.
///
/// The contact of two equal bodies rolls along x. It has the semi-axes a along x and b along y, and $`c = \sqrt{ab}`$. The
/// creepages are $`\xi`$ along x and $`\eta`$ along y, and the spin is $`\varphi`$ (one over a length). They cause the forces and
/// the moment on body 1
///
/// ```math
/// F_x = G c^2\,C_{11}\,\xi, \qquad F_y = G c^2\,(C_{22}\,\eta + c\,C_{23}\,\varphi), \qquad
/// M = G c^3\,(C_{32}\,\eta + c\,C_{33}\,\varphi), \qquad C_{32} = -C_{23} ,
/// ```
///
/// where $`G`$ is the shear modulus of the bodies: twice the [`equivalent_shear_modulus`] of their pair. The formulas have
/// positive $`C_{11}, C_{22}, C_{23}, C_{33}`$ and the signs of [`rolling`](crate::rolling) with the leading edge
/// at +x. The coefficients depend neither on the pressure nor on the friction.
///
/// The values were computed with this crate for $`a/b`$ from 1/16 to 16. They result from [steady
/// rolling](crate::rolling::RollingProblem) on 24 grids of 32 to 128 cells across each axis. The values are extrapolated to zero
/// cell size and to reciprocity, $`C_{32} = -C_{23}`$. They are accurate to about 0.1 % ($`C_{33}`$ to 0.3 %).
///
/// Between the tabulated values, logarithms are interpolated in $`\ln(a/b)`$. The compliances $`1/C_{11}, 1/C_{22}, 1/C_{23}`$
/// and the spin per moment without lateral force are interpolated as parabolas in $`\nu`$. The interpolation adds an error of at
/// most 0.1 % for $`a/b`$ from 0.09 to 2.8 and up to 0.4 % outside this range. The error of $`C_{33}`$ is up to 1 % near 16,
/// because this coefficient is a small difference of larger terms.
///
/// Kalker's three-digit values of $`C_{11}`$, $`C_{22}`$ and $`C_{23}`$ differ by less than 0.6 % for $`0.2 \le a/b \le 2`$ and
/// by up to 1.2 % at 10. The exception is $`C_{11} = 4.83`$ at $`a/b = 0.5`$, $`\nu = 0.5`$. A value of 4.87 would be consistent
/// with the neighbouring values.
///
/// J. J. Kalker, Three-dimensional elastic bodies in rolling contact (1990), section 4.2 and table E.3,
/// <https://doi.org/10.1007/978-94-015-7889-9>. A copy of the table in circulation has 1.15 instead of 1.25 for $`C_{23}`$ at
/// $`a/b = 0.8`$, $`\nu = 0.25`$.
///
/// ```
/// use stickslip::analytical::KalkerCoefficients;
/// let circle = KalkerCoefficients::new(1.0, 0.25)?;
/// // Printed: 4.12, 3.67, 1.47.
/// assert!((circle.c11() / 4.12 - 1.0).abs() < 5e-3);
/// assert!((circle.c22() / 3.67 - 1.0).abs() < 5e-3);
/// assert!((circle.c23() / 1.47 - 1.0).abs() < 5e-3);
/// assert_eq!(circle.c32(), -circle.c23());
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// [`equivalent_shear_modulus`]: crate::ElasticPair::equivalent_shear_modulus
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct KalkerCoefficients {
    c11: f64,
    c22: f64,
    c23: f64,
    c33: f64,
}

impl KalkerCoefficients {
    /// Returns the coefficients of an ellipse for bodies of Poisson's ratio `poisson_ratio` (0 to 1/2). The ratio $`a/b`$ of the
    /// semi-axes along and across the rolling direction is `ratio` (1/16 to 16). For different bodies with a
    /// [`dundurs_beta`](crate::ElasticPair::dundurs_beta) of zero, use the [equivalent Poisson's
    /// ratio](crate::ElasticPair::equivalent_poisson_ratio). For equal and different bodies, the modulus G is twice the
    /// [equivalent shear modulus](crate::ElasticPair::equivalent_shear_modulus).
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if the ratio is not positive and finite.
    /// - [`Error::BelowMinimum`] for a ratio outside the table or a negative Poisson's ratio.
    /// - [`Error::PoissonRatio`] for a Poisson's ratio above 1/2.
    pub fn new(ratio: f64, poisson_ratio: f64) -> Result<Self> {
        positive("ratio of the semi-axes", ratio)?;
        let shorter = ratio.min(1.0 / ratio);
        let least = 0.5_f64.powi(OCTAVES);
        at_least(
            "the smallest value of the table",
            least,
            "ratio of the shorter to the longer semi-axis",
            shorter,
        )?;
        at_least(
            "the smallest value of the table",
            0.0,
            "Poisson's ratio",
            poisson_ratio,
        )?;
        if poisson_ratio > 0.5 {
            return Err(Error::PoissonRatio(poisson_ratio));
        }
        let at = 2.0 * (ratio.log2() + f64::from(OCTAVES));
        let nodes = [0, 1, 2]
            .map(|nu| [0, 1, 2, 3].map(|which| between_rows(at, |row| TABLE[row][which][nu])));
        let of = |compliance: fn([f64; 4]) -> f64| parabola(nodes.map(compliance), poisson_ratio);
        let c22 = 1.0 / of(|[_, c22, _, _]| 1.0 / c22);
        let c23 = 1.0 / of(|[_, _, c23, _]| 1.0 / c23);
        // The spin per moment without a lateral force.
        let turn = of(|[_, c22, c23, c33]| 1.0 / (c33 + c23 * c23 / c22));
        Ok(Self {
            c11: 1.0 / of(|[c11, ..]| 1.0 / c11),
            c22,
            c23,
            c33: 1.0 / turn - c23 * c23 / c22,
        })
    }

    /// Returns $`C_{11}`$, the force along x due to the creepage along x.
    #[must_use]
    pub fn c11(&self) -> f64 {
        self.c11
    }

    /// Returns $`C_{22}`$, the force along y due to the creepage along y.
    #[must_use]
    pub fn c22(&self) -> f64 {
        self.c22
    }

    /// Returns $`C_{23}`$, the force along y due to the spin.
    #[must_use]
    pub fn c23(&self) -> f64 {
        self.c23
    }

    /// Returns $`C_{32} = -C_{23}`$, the moment due to the creepage along y.
    #[must_use]
    pub fn c32(&self) -> f64 {
        -self.c23
    }

    /// Returns $`C_{33}`$, the moment due to the spin.
    #[must_use]
    pub fn c33(&self) -> f64 {
        self.c33
    }
}

/// Base-2 logarithm of the largest tabulated ratio. The smallest ratio is its reciprocal.
const OCTAVES: i32 = 4;

/// Evaluates the parabola through the values at the Poisson's ratios 0, 0.25 and 0.5.
fn parabola([none, quarter, half]: [f64; 3], poisson_ratio: f64) -> f64 {
    let t = 4.0 * poisson_ratio;
    0.5 * (t - 1.0) * (t - 2.0) * none - t * (t - 2.0) * quarter + 0.5 * t * (t - 1.0) * half
}

/// Interpolates a value between two rows of the table. The logarithm of the value is the cubic Hermite interpolant of
/// the two rows. The slopes are differences of the neighbouring rows.
fn between_rows(at: f64, value: impl Fn(usize) -> f64) -> f64 {
    let last = TABLE.len() - 1;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a place in the table, but for round-off"
    )]
    let row = (at.max(0.0) as usize).min(last - 1);
    let logarithm = |row: usize| value(row).ln();
    let slope = |row: usize| {
        // In the first and last row, the slope is taken from the parabola through the nearest three rows.
        let middle = row.clamp(1, last - 1);
        let [before, here, after] = [middle - 1, middle, middle + 1].map(logarithm);
        let bend = before - 2.0 * here + after;
        0.5 * (after - before) + bend * (row as f64 - middle as f64)
    };
    let (u, v) = (at - row as f64, (row + 1) as f64 - at);
    let sum = v * v * ((1.0 + 2.0 * u) * logarithm(row) + u * slope(row))
        + u * u * ((1.0 + 2.0 * v) * logarithm(row + 1) - v * slope(row + 1));
    sum.exp()
}
