//! Stresses in a half-space in plane strain below a semi-elliptical traction.

/// Returns the stresses `[xx, zz, xz]` (positive in tension) at `x` and at the depth `z`, in half-widths, under the
/// pressure $`\sqrt{1-x^2}`$. Johnson (1985), 4.49.
pub(super) fn of_pressure(x: f64, z: f64) -> [f64; 3] {
    let Roots { m, n, size } = Roots::new(x, z);
    let part = over(z * z + n * n, size);
    [
        2.0 * z - m * (1.0 + part),
        -m * (1.0 - part),
        -n * over(m * m - z * z, size),
    ]
}

/// Returns the stresses `[xx, zz, xz]` under the traction $`\sqrt{1-x^2}`$ along x. Johnson (1985), 7.2.
pub(super) fn of_traction(x: f64, z: f64) -> [f64; 3] {
    let Roots { m, n, size } = Roots::new(x, z);
    let [along, _, across] = of_pressure(x, z);
    // Next to the contact, n - x is computed from n^2 - x^2 = m^2 - z^2 - 1. The difference n - x would cancel far from
    // the contact.
    let beside = x * x > 1.0 + z * z;
    let excess = if beside {
        (m * m - z * z - 1.0) / (n + x)
    } else {
        n - x
    };
    [2.0 * excess - n * over(z * z - m * m, size), across, along]
}

/// Roots m and n of $`m^2 - n^2 = 1 - x^2 + z^2`$ and $`mn = xz`$, with $`m \ge 0`$, and $`m^2 + n^2`$.
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
        // The larger root follows from a sum without cancellation.
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

/// Returns `part / whole`, or zero if `whole` is zero. In this case `part` is also zero, and so is the factor by which
/// the caller multiplies the ratio.
fn over(part: f64, whole: f64) -> f64 {
    if whole == 0.0 { 0.0 } else { part / whole }
}
