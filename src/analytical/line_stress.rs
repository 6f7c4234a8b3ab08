//! Stresses in a half-space in plane strain below a traction in the form of half an ellipse.

/// Stresses `[xx, zz, xz]` at `x` and at the depth `z`, in half-widths, under the pressure $`\sqrt{1-x^2}`$ (positive in
/// tension). Johnson (1985), 4.49.
pub(super) fn of_pressure(x: f64, z: f64) -> [f64; 3] {
    let Roots { m, n, size } = Roots::new(x, z);
    let part = over(z * z + n * n, size);
    [
        2.0 * z - m * (1.0 + part),
        -m * (1.0 - part),
        -n * over(m * m - z * z, size),
    ]
}

/// The same under the traction $`\sqrt{1-x^2}`$ along x. Johnson (1985), 7.2.
pub(super) fn of_traction(x: f64, z: f64) -> [f64; 3] {
    let Roots { m, n, size } = Roots::new(x, z);
    let [along, _, across] = of_pressure(x, z);
    // n - x, beside the contact by n^2 - x^2 = m^2 - z^2 - 1: far away the difference would cancel.
    let beside = x * x > 1.0 + z * z;
    let excess = if beside {
        (m * m - z * z - 1.0) / (n + x)
    } else {
        n - x
    };
    [2.0 * excess - n * over(z * z - m * m, size), across, along]
}

/// m and n of $`m^2 - n^2 = 1 - x^2 + z^2`$ and $`mn = xz`$, with $`m \ge 0`$, and $`m^2 + n^2`$.
struct Roots {
    m: f64,
    n: f64,
    size: f64,
}

impl Roots {
    fn new(x: f64, z: f64) -> Self {
        let difference = (1.0 - x) * (1.0 + x) + z * z;
        let product = (x * z).abs();
        let size = difference.hypot(2.0 * product);
        // The larger one by a sum that does not cancel.
        let larger = (0.5 * (size + difference.abs())).sqrt();
        let smaller = over(product, larger);
        let [m, n] = if difference >= 0.0 {
            [larger, smaller]
        } else {
            [smaller, larger]
        };
        Self {
            m,
            n: n.copysign(x),
            size,
        }
    }
}

/// A ratio that comes with a factor of zero where both are zero.
fn over(part: f64, whole: f64) -> f64 {
    if whole == 0.0 { 0.0 } else { part / whole }
}
