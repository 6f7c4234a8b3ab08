//! The integrals by Gauss-Legendre quadrature for points far from the cell.

use crate::numerics::gauss::{
    GAUSS_3, GAUSS_4, GAUSS_5, GAUSS_6, GAUSS_8, GAUSS_12, GAUSS_16, QuadratureRule,
};
use crate::subsurface::kernel::integral::PotentialIntegral;

/// Returns the integrals over a rectangle of half sides a and b at `N` points of a row of the quadrant `x >= 0`,
/// `y >= 0`. The result at a point does not depend on the other points.
///
/// Below the cell, odd contributions in x cancel between two halves. The part `a - x..a + x` of the interval
/// `x - a..x + a` remains, which is the same integral with x and a exchanged.
pub(super) fn integrals<const N: usize>(
    [a, b]: [f64; 2],
    rule: QuadratureRule,
    xs: &[f64; N],
    [y, z]: [f64; 2],
) -> [[f64; N]; PotentialIntegral::COUNT] {
    let mut sums = product_rule(rule, [xs, &[a; N]], [y, b], z);
    let mut replace_odd = |axis: usize, others: [[f64; N]; PotentialIntegral::COUNT]| {
        for ((sum, other), integral) in sums.iter_mut().zip(others).zip(PotentialIntegral::ALL) {
            if integral.is_odd()[axis] {
                *sum = other;
            }
        }
    };
    if xs.iter().any(|&x| x < a) {
        let sides = [&xs.map(|x| x.max(a)), &xs.map(|x| x.min(a))];
        replace_odd(0, product_rule(rule, sides, [y, b], z));
    }
    if y < b {
        replace_odd(1, product_rule(rule, [xs, &[a; N]], [b, y], z));
    }
    sums
}

/// Returns the sums of the integrands over the nodes. `[x, a]` of each point and `[y, b]` are the centre and the half
/// side of an interval.
fn product_rule<const N: usize>(
    rule: QuadratureRule,
    [xs, a]: [&[f64; N]; 2],
    [y, b]: [f64; 2],
    z: f64,
) -> [[f64; N]; PotentialIntegral::COUNT] {
    let mut sums = [[0.0; N]; PotentialIntegral::COUNT];
    for &[node_y, weight_y] in rule {
        let y = y + b * node_y;
        for &[node_x, weight_x] in rule {
            let weight = weight_x * (b * weight_y);
            add_integrands(&mut sums, [xs, a], [node_x, weight], [y, z]);
        }
    }
    sums
}

/// Adds `a` times a weight times the functions under the integrals. These are derivatives of `1/r`, `ln(r + z)` and
/// `z ln(r + z) - r`, and products of three coordinates over `r^5/3`.
#[inline]
fn add_integrands<const N: usize>(
    sums: &mut [[f64; N]; PotentialIntegral::COUNT],
    [xs, a]: [&[f64; N]; 2],
    [node, weight]: [f64; 2],
    [y, z]: [f64; 2],
) {
    let (y2, z2) = (y * y, z * z);
    for (lane, (x, a)) in xs.iter().zip(a).enumerate() {
        let mut add = |integral: PotentialIntegral, value| sums[integral.index()][lane] += value;
        let (x, weight) = (x + a * node, a * weight);
        let x2 = x * x;
        let r = ((x2 + y2) + z2).sqrt();
        // One division gives i = 1/r and s = 1/(r + z); t = r/(r + z).
        let sum = r + z;
        let quotient = 1.0 / (r * sum);
        let (i, s) = (sum * quotient, r * quotient);
        let (i2, t) = (i * i, r * s);

        // The weight is included in one factor of each product.
        let wi3 = weight * i * i2;
        let three = 3.0 * wi3 * i2;
        let wis = weight * quotient;
        let (m, n) = (wi3 * s * (1.0 + t), wis * s);
        let k = wi3 * (s * s) * (1.0 + 2.0 * t);
        let (xy, three_x, three_y, three_z) = (x * y, three * x, three * y, three * z);

        add(PotentialIntegral::V, weight * i);
        add(PotentialIntegral::Lx, x * wis);
        add(PotentialIntegral::Ly, y * wis);
        add(PotentialIntegral::Wxx, x2 * n - weight * s);
        add(PotentialIntegral::Wxy, xy * n);
        add(PotentialIntegral::Lxx, wis - x2 * m);
        add(PotentialIntegral::Lxy, -(xy * m));
        add(PotentialIntegral::Wxxy, y * (n - x2 * k));
        add(PotentialIntegral::Wxyy, x * (n - y2 * k));
        add(PotentialIntegral::Txxx, three_x * x2);
        add(PotentialIntegral::Txxy, three_y * x2);
        add(PotentialIntegral::Txyy, three_x * y2);
        add(PotentialIntegral::Tyyy, three_y * y2);
        add(PotentialIntegral::Txxz, three_z * x2);
        add(PotentialIntegral::Txyz, three_z * xy);
        add(PotentialIntegral::Tyyz, three_z * y2);
        add(PotentialIntegral::Txzz, three_x * z2);
        add(PotentialIntegral::Tyzz, three_y * z2);
        add(PotentialIntegral::Tzzz, three_z * z2);
    }
}

/// Quadrature rules and their minimum distances, in longer sides. At larger distances than its minimum, the error of a
/// rule is below round-off. The hardest case is the shear stress under a tangential traction deep below the cell, which
/// is of second order in the ratio of side to depth. Below the smallest of these distances, the closed form loses at
/// most one digit by cancellation.
const RULES: [(f64, QuadratureRule); 7] = [
    (3000.0, &GAUSS_3),
    (150.0, &GAUSS_4),
    (30.0, &GAUSS_5),
    (13.0, &GAUSS_6),
    (4.5, &GAUSS_8),
    (2.0, &GAUSS_12),
    (1.5, &GAUSS_16),
];

/// Returns the cheapest sufficient rule for a rectangle of half sides a and b at a point; `None` if the point is near.
/// A rule is also returned for NaN, which the quadrature propagates.
pub(super) fn rule([a, b]: [f64; 2], [x, y, z]: [f64; 3]) -> Option<QuadratureRule> {
    let distance = ((x * x + y * y) + z * z).sqrt() / (2.0 * a.max(b));
    let suffices = |&&(reach, _): &&(f64, QuadratureRule)| distance >= reach || distance.is_nan();
    RULES.iter().find(suffices).map(|&(_, rule)| rule)
}
