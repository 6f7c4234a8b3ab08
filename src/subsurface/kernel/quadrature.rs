//! The quadrature that suffices at a distance from a cell.

use crate::numerics::gauss::{
    GAUSS_3, GAUSS_4, GAUSS_5, GAUSS_6, GAUSS_8, GAUSS_12, GAUSS_16, Rule,
};

/// Distances in longer sides, and the cheapest rule whose error stays below the rounding beyond them. Deep below the
/// cell the shear stress under a traction along it is of the second order in the ratio of side and depth, and asks most
/// of the rule. Nearer than the last, the closed form cancels no more than a digit.
const RULES: [(f64, Rule); 7] = [
    (3000.0, &GAUSS_3),
    (150.0, &GAUSS_4),
    (30.0, &GAUSS_5),
    (13.0, &GAUSS_6),
    (4.5, &GAUSS_8),
    (2.0, &GAUSS_12),
    (1.5, &GAUSS_16),
];

/// The cheapest rule that suffices for a rectangle of half sides a and b at a point; none near it. What is not a number
/// is left to the quadrature too, which passes it on.
pub(super) fn rule([a, b]: [f64; 2], [x, y, z]: [f64; 3]) -> Option<Rule> {
    let distance = ((x * x + y * y) + z * z).sqrt() / (2.0 * a.max(b));
    let suffices = |&&(reach, _): &&(f64, Rule)| distance >= reach || distance.is_nan();
    RULES.iter().find(suffices).map(|&(_, rule)| rule)
}
