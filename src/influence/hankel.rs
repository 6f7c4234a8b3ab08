//! Functions of a distance that are smooth on the scale of a depth: their tables, Hankel integrals and integrals over cells.

use std::f64::consts::{SQRT_2, TAU};
use std::sync::LazyLock;

use crate::numerics::gauss::{
    GAUSS_2, GAUSS_3, GAUSS_4, GAUSS_5, GAUSS_6, GAUSS_8, GAUSS_12, QuadratureRule,
};

/// Number of pieces of a table. The pieces end at half the scale, at the scale, at twice the scale and so on.
pub(crate) const PIECES: usize = 100;
/// Number of Chebyshev coefficients per piece.
pub(crate) const TERMS: usize = 21;
/// Maximum phase of the wave over a panel of twelve points, at the far end of a piece.
const PHASE: f64 = 7.0;

/// Gauss rules along a side of a cell. Each rule has a minimum for the sum of the semi-axes of the ellipse through the nearest
/// singularity of the kernels, in half sides. The error of a rule with n points is this sum to the power -2n, about 1e-14.
pub(crate) const RULES: [(f64, QuadratureRule); 7] = [
    (3200.0, &GAUSS_2),
    (215.0, &GAUSS_3),
    (56.0, &GAUSS_4),
    (25.0, &GAUSS_5),
    (14.7, &GAUSS_6),
    (7.5, &GAUSS_8),
    (3.9, &GAUSS_12),
];

/// Returns the cheapest rule along a side of half length `a` for a cell centre at the given distance. The nearest
/// singularity of the functions is at i times the scale. Returns `None` if the side is too long.
pub(crate) fn rule(a: f64, distance: f64, scale: f64) -> Option<usize> {
    let away = (distance - a).max(0.0).hypot(scale) / a;
    let ellipse = away + (away * away + 1.0).sqrt();
    RULES.iter().position(|(least, _)| ellipse >= *least)
}

/// Returns the piece that contains a distance.
pub(crate) fn piece_of(distance: f64, scale: f64) -> usize {
    // The exponent bits of a ratio in [1, 2) are 0x3ff.
    let exponent = (2.0 * distance / scale).to_bits() >> 52;
    (exponent as usize + 2)
        .saturating_sub(0x400)
        .min(PIECES - 1)
}

/// Returns the ends of a piece.
pub(crate) fn ends_of(piece: usize, scale: f64) -> [f64; 2] {
    let end = 0.5 * scale * 2.0_f64.powi(i32::try_from(piece).unwrap_or(0));
    [if piece == 0 { 0.0 } else { 0.5 * end }, end]
}

/// Returns the wave numbers and weights of a quadrature for distances between the ends of a piece. The response is negligible for
/// wave numbers above `gone`. The first interval ends at `least`, because the response hardly varies below this wave number.
///
/// Far from the origin, short waves are cut off smoothly on the scale of the distance. The error of this cut-off is below
/// round-off.
pub(crate) fn wave_numbers([near, far]: [f64; 2], gone: f64, least: f64) -> Vec<(f64, f64)> {
    let is_cut = near * gone > 156.0;
    let last = if is_cut { 156.0 / near } else { gone };
    let weight = |k: f64| {
        if is_cut {
            0.5 * libm::erfc((k * near - 78.0) / 12.5)
        } else {
            1.0
        }
    };
    let mut waves = Vec::new();
    let mut start = 0.0;
    while start < last {
        let end = (SQRT_2 * start).max(least).min(last);
        let panels = ((end - start) * far / PHASE).ceil().max(1.0);
        let half = 0.5 * (end - start) / panels;
        let mut panel = 0.0;
        while panel < panels {
            let middle = start + half * (2.0 * panel + 1.0);
            panel += 1.0;
            waves.extend(GAUSS_12.map(|[node, part]| {
                let k = middle + half * node;
                (k, half * part * weight(k))
            }));
        }
        start = end;
    }
    waves
}

/// Returns the zeros of the first unused Chebyshev polynomial, mapped to the interval between two ends.
pub(crate) fn nodes([start, end]: [f64; 2]) -> [f64; TERMS] {
    let cosine = |node: usize| COSINES[1][node];
    std::array::from_fn(|node| 0.5 * (start + end) + 0.5 * (end - start) * cosine(node))
}

/// Returns the Chebyshev coefficients of a function from its values at the nodes.
pub(crate) fn chebyshev(value: impl Fn(usize) -> f64) -> [f64; TERMS] {
    std::array::from_fn(|term| {
        let share = if term == 0 { 1.0 } else { 2.0 } / TERMS as f64;
        let waves = COSINES[term].iter().enumerate();
        share
            * waves
                .map(|(node, cosine)| cosine * value(node))
                .sum::<f64>()
    })
}

/// Values of the Chebyshev polynomials at the nodes, by term.
static COSINES: LazyLock<[[f64; TERMS]; TERMS]> = LazyLock::new(|| {
    let angle = |node: usize| 0.5 * TAU * (node as f64 + 0.5) / TERMS as f64;
    std::array::from_fn(|term| std::array::from_fn(|node| (term as f64 * angle(node)).cos()))
});

/// Returns the Chebyshev coefficients of several functions between two ends.
pub(crate) fn tabulated<const F: usize>(
    ends: [f64; 2],
    at: impl Fn(f64) -> [f64; F],
) -> [[f64; TERMS]; F] {
    let values = nodes(ends).map(at);
    std::array::from_fn(|function| chebyshev(|node| values[node][function]))
}

/// Returns $`J_0(x)`$, $`J_1(x)/x`$, $`J_2(x)/x^2`$ and $`J_3(x)/x^3`$.
pub(crate) fn bessel(x: f64) -> [f64; 4] {
    let zero = libm::j0(x);
    let square = -0.25 * x * x;
    let series = |order: u32, start: f64| {
        let mut term = start;
        let mut sum = start;
        for n in 1..14 {
            term *= square / f64::from(n * (n + order));
            sum += term;
        }
        sum
    };
    if x >= 2.0 {
        let one = libm::j1(x) / x;
        let two = (2.0 * one - zero) / (x * x);
        let three = if x < 4.0 {
            series(3, 1.0 / 48.0)
        } else {
            (4.0 * two - one) / (x * x)
        };
        return [zero, one, two, three];
    }
    [
        zero,
        series(1, 0.5),
        series(2, 0.125),
        series(3, 1.0 / 48.0),
    ]
}
