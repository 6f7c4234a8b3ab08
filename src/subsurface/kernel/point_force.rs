//! Displacements and stresses below point forces on the surface.

use std::f64::consts::PI;

use super::weights::FieldComponent;

/// Displacements, times the shear modulus, and stresses, in the order of [`FieldComponent`]. They are summed in `N` lanes.
pub(crate) type PointForceSums<const N: usize> = [[f64; N]; FieldComponent::COUNT];

/// Adds the displacements, times `4 pi G`, and the stresses, times `2 pi`, at `[x, y, z]` relative to each force, by the formulas
/// of Boussinesq and Cerruti. They are the functions under the integrals of the [module](super). `e` is `1 - 2 nu`.
#[inline]
pub(crate) fn add_point_forces<const N: usize>(
    sums: &mut PointForceSums<N>,
    [pressing, along_x, along_y]: [&[f64; N]; 3],
    xs: &[f64; N],
    [y, z]: [f64; 2],
    e: f64,
) {
    let (y2, z2) = (y * y, z * z);
    for lane in 0..N {
        let (p, qx, qy, x) = (pressing[lane], along_x[lane], along_y[lane], xs[lane]);
        let (x2, xy) = (x * x, x * y);
        let r = ((x2 + y2) + z2).sqrt();
        // One division gives i = 1/r and s = 1/(r + z). The variable t is r/(r + z).
        let sum = r + z;
        let is = 1.0 / (r * sum);
        let (i, s) = (sum * is, r * is);
        let (i3, t) = (i * i * i, r * s);
        let m = i3 * s * (1.0 + t);
        let n = is * s;
        let k = i3 * (s * s) * (1.0 + 2.0 * t);

        let along = x * qx + y * qy;
        let lever = (along + z * p) * i3;
        let three = 3.0 * lever * (i * i);
        let (wxyy, wxxy) = (x * (n - y2 * k), y * (n - x2 * k));
        let (wxxx, wyyy) = (x * i3 - wxyy, y * i3 - wxxy);
        let (lxx, lyy) = (is - x2 * m, is - y2 * m);

        let mut add = |component: FieldComponent, value| sums[component as usize][lane] += value;
        let ux = s * qx - n * (x * along) - x * is * p;
        let uy = s * qy - n * (y * along) - y * is * p;
        let uz = i * p + is * along;
        add(FieldComponent::Ux, i * qx + x * lever + e * ux);
        add(FieldComponent::Uy, i * qy + y * lever + e * uy);
        add(FieldComponent::Uz, i * p + z * lever + e * uz);
        let xx = lyy * p + wxyy * qx + wyyy * qy;
        let yy = lxx * p + wxxx * qx + wxxy * qy;
        let xy_part = xy * m * p - wxxy * qx - wxyy * qy;
        add(FieldComponent::Sxx, e * xx - three * x2);
        add(FieldComponent::Syy, e * yy - three * y2);
        add(FieldComponent::Szz, -three * z2);
        add(FieldComponent::Sxy, e * xy_part - three * xy);
        add(FieldComponent::Sxz, -three * x * z);
        add(FieldComponent::Syz, -three * y * z);
    }
}

/// Returns the sums over the lanes, divided by `4 pi` and `2 pi`.
pub(crate) fn totals<const N: usize>(sums: &PointForceSums<N>) -> [f64; FieldComponent::COUNT] {
    FieldComponent::ALL.map(|component| {
        let mut total = 0.0;
        for value in sums[component as usize] {
            total += value;
        }
        let divisor = if component.is_displacement() {
            4.0 * PI
        } else {
            2.0 * PI
        };
        total / divisor
    })
}
