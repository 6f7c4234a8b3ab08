//! The stress at a point and what is read from it.

/// The symmetric stress tensor at a point (pressures), tensile positive, along the axes x, y and z, with z into body 1.
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
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Principal {
    /// The principal stresses (pressures, tensile positive), the largest first.
    pub values: [f64; 3],
    /// The unit vector `[x, y, z]` of each. They are orthogonal and form a right-handed set; the signs of the first two
    /// are arbitrary, and directions of equal stresses are any within their plane.
    pub directions: [[f64; 3]; 3],
}

impl Stress {
    /// Von Mises' equivalent stress (a pressure), never negative:
    ///
    /// ```math
    /// \sigma_v^2 = \tfrac12 \left[(\sigma_{xx} - \sigma_{yy})^2 + (\sigma_{yy} - \sigma_{zz})^2
    ///   + (\sigma_{zz} - \sigma_{xx})^2\right] + 3 (\sigma_{xy}^2 + \sigma_{xz}^2 + \sigma_{yz}^2).
    /// ```
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

    /// The mean of the three normal stresses, `(xx + yy + zz)/3` (a pressure): positive in tension, negative under
    /// compression. Its negative is the hydrostatic pressure.
    #[must_use]
    pub fn hydrostatic(&self) -> f64 {
        (self.xx + self.yy + self.zz) / 3.0
    }

    /// The largest shear stress on any plane through the point, half the difference of the largest and the smallest
    /// principal stress (a pressure): Tresca's measure.
    #[must_use]
    pub fn max_shear(&self) -> f64 {
        let [largest, _, smallest] = self.principal().values;
        0.5 * (largest - smallest)
    }

    /// Principal stresses and their directions, by Jacobi's rotations: errors are round-off of the largest stress.
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
        let mut matrix = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        // Convergence is quadratic: six sweeps leave nothing.
        for _ in 0..8 {
            for [p, q] in [[0, 1], [0, 2], [1, 2]] {
                rotate(&mut matrix, &mut axes, [p, q]);
            }
        }
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| matrix[j][j].total_cmp(&matrix[i][i]));
        let [a, b, _] = order.map(|i| axes[i]);
        let c = [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ];
        Principal {
            values: order.map(|i| matrix[i][i]),
            directions: [a, b, c],
        }
    }
}

/// Turns two axes so that the entry between them vanishes; the rows of `axes` are the directions.
fn rotate(matrix: &mut [[f64; 3]; 3], axes: &mut [[f64; 3]; 3], [p, q]: [usize; 2]) {
    let entry = matrix[p][q];
    if entry == 0.0 {
        return;
    }
    // The smaller of the two angles; a ratio that overflows gives zero.
    let ratio = (matrix[q][q] - matrix[p][p]) / (2.0 * entry);
    let tangent = 1.0_f64.copysign(ratio) / (ratio.abs() + ratio.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = tangent * cosine;
    matrix[p][p] -= tangent * entry;
    matrix[q][q] += tangent * entry;
    (matrix[p][q], matrix[q][p]) = (0.0, 0.0);
    let third = 3 - p - q;
    let [at_p, at_q] = [matrix[p][third], matrix[q][third]];
    let [at_p, at_q] = [cosine * at_p - sine * at_q, sine * at_p + cosine * at_q];
    (matrix[p][third], matrix[third][p]) = (at_p, at_p);
    (matrix[q][third], matrix[third][q]) = (at_q, at_q);
    let [axis_p, axis_q] = [axes[p], axes[q]];
    for k in 0..3 {
        axes[p][k] = cosine * axis_p[k] - sine * axis_q[k];
        axes[q][k] = sine * axis_p[k] + cosine * axis_q[k];
    }
}
