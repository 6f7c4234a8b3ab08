//! The stress at a point and the quantities derived from it.

use std::ops::{Add, AddAssign, Mul, Sub};

use crate::numerics::jacobi::diagonalised;

/// Symmetric stress tensor at a point (pressures, tensile positive), along the axes x, y and z. The axis z points into
/// body 1.
///
/// ```
/// use stickslip::subsurface::Stress;
/// // Pure shear in the plane of x and y.
/// let stress = Stress { xy: 2.0, ..Stress::default() };
/// assert!((stress.von_mises() - 12_f64.sqrt()).abs() < 1e-15);
/// let principal = stress.principal();
/// assert_eq!(principal.values, [2.0, 0.0, -2.0]);
/// assert!((principal.directions[0][0] - principal.directions[0][1]).abs() < 1e-15);
/// assert_eq!(stress.hydrostatic(), 0.0);
/// // Stresses of two loads add up, and scale with the load.
/// let tension = Stress { xx: 3.0, ..Stress::default() };
/// assert_eq!((stress + 2.0 * tension).xx, 6.0);
/// assert_eq!(stress + tension - tension, stress);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[expect(missing_docs, reason = "the type says what the two letters mean")]
pub struct Stress {
    pub xx: f64,
    pub yy: f64,
    pub zz: f64,
    pub xy: f64,
    pub xz: f64,
    pub yz: f64,
}

/// Principal stresses and their directions.
///
/// ```
/// use stickslip::subsurface::Stress;
/// // Tension of 5 along [3, 4, 0]/5.
/// let stress = Stress { xx: 1.8, yy: 3.2, xy: 2.4, ..Stress::default() };
/// let principal = stress.principal();
/// assert!((principal.values[0] - 5.0).abs() < 1e-14 && principal.values[2].abs() < 1e-14);
/// let [x, y, z] = principal.directions[0];
/// assert!((0.6 * x + 0.8 * y).abs() > 1.0 - 1e-15 && z.abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Principal {
    /// Principal stresses (pressures, tensile positive), in descending order.
    pub values: [f64; 3],
    /// Unit vector `[x, y, z]` of each principal stress. The vectors are orthogonal and form a right-handed set. The
    /// signs of the first two vectors are arbitrary. The directions of equal stresses are arbitrary within their plane.
    pub directions: [[f64; 3]; 3],
}

impl Stress {
    /// Returns the components `[xx, yy, zz, xy, xz, yz]`.
    pub(super) fn components(&self) -> [f64; 6] {
        [self.xx, self.yy, self.zz, self.xy, self.xz, self.yz]
    }

    /// Combines each component with the same component of another stress.
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            xx: f(self.xx, other.xx),
            yy: f(self.yy, other.yy),
            zz: f(self.zz, other.zz),
            xy: f(self.xy, other.xy),
            xz: f(self.xz, other.xz),
            yz: f(self.yz, other.yz),
        }
    }

    /// Returns the von Mises equivalent stress (a pressure), never negative:
    ///
    /// ```math
    /// \sigma_v^2 = \tfrac12 \left[(\sigma_{xx} - \sigma_{yy})^2 + (\sigma_{yy} - \sigma_{zz})^2
    ///   + (\sigma_{zz} - \sigma_{xx})^2\right] + 3 (\sigma_{xy}^2 + \sigma_{xz}^2 + \sigma_{yz}^2).
    /// ```
    #[doc(alias = "von Mises")]
    #[doc(alias = "equivalent stress")]
    #[must_use]
    pub fn von_mises(&self) -> f64 {
        let Self {
            xx,
            yy,
            zz,
            xy,
            xz,
            yz,
        } = *self;
        let [a, b, c] = [xx - yy, yy - zz, zz - xx].map(|difference| difference * difference);
        (0.5 * (a + b + c) + 3.0 * (xy * xy + xz * xz + yz * yz)).sqrt()
    }

    /// Returns the mean of the three normal stresses, `(xx + yy + zz)/3` (a pressure). The mean is positive in tension
    /// and negative under compression. Its negative is the hydrostatic pressure.
    #[must_use]
    pub fn hydrostatic(&self) -> f64 {
        (self.xx + self.yy + self.zz) / 3.0
    }

    /// Returns the largest shear stress on any plane through the point (a pressure). This value, Tresca's measure, is
    /// half the difference of the largest and the smallest principal stress.
    #[must_use]
    pub fn max_shear(&self) -> f64 {
        let [largest, _, smallest] = self.principal().values;
        0.5 * (largest - smallest)
    }

    /// Returns the principal stresses and their directions. The errors are of the order of round-off. The errors of the
    /// values are relative to the largest stress.
    #[must_use]
    pub fn principal(&self) -> Principal {
        let Self {
            xx,
            yy,
            zz,
            xy,
            xz,
            yz,
        } = *self;
        let (values, vectors) = diagonalised([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]);
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| values[j].total_cmp(&values[i]));
        let [a, b, _] = order.map(|i| vectors.map(|row| row[i]));
        // Each rotation has added round-off to the axes.
        let a = unit(a);
        let along = dot(a, b);
        let b = unit([0, 1, 2].map(|k| b[k] - along * a[k]));
        let c = [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ];
        Principal {
            values: order.map(|i| values[i]),
            directions: [a, b, c],
        }
    }
}

/// Adds the stresses of two loads.
impl Add for Stress {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl AddAssign for Stress {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Stress {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

/// Multiplies the stress of a load by a factor.
impl Mul<f64> for Stress {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        self.zip(self, |a, _| a * factor)
    }
}

impl Mul<Stress> for f64 {
    type Output = Stress;

    fn mul(self, stress: Stress) -> Stress {
        stress * self
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    v.map(|component| component / length)
}
