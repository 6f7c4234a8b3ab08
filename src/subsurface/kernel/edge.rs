//! Differences of the antiderivatives between the two ends of an edge of the cell, free of cancellation.

use super::piece::Extent;

/// An edge parallel to y, seen from the point: at the distance `X` along x, from `Y_2` to `Y_1` along y. An edge
/// parallel to x is one with the axes exchanged.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    /// `X`.
    pub(super) offset: f64,
    pub(super) z: f64,
    /// From `Y_2` to `Y_1 >= |Y_2|`.
    pub(super) extent: Extent,
    /// The distances `r_1 >= r_2` of the ends.
    pub(super) distances: [f64; 2],
    /// What replaces a zero distance inside a logarithm.
    pub(super) unit: f64,
}

/// The differences "at `(X, Y_1)` minus at `(X, Y_2)`" of an edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Differences {
    /// `asinh(Y/rho)` with `rho^2 = X^2 + z^2`.
    pub(super) asinh: f64,
    /// `arctan(XY/(rho^2 + zr))`.
    pub(super) theta: f64,
    /// `arctan(XY/(zr))`.
    pub(super) solid_angle: f64,
    /// `ln(r + z)`.
    pub(super) logarithm: f64,
    /// `r`.
    pub(super) distance: f64,
    /// `X/(r + z)`.
    pub(super) ratio: f64,
    /// `1/r` times `X`, and times z.
    pub(super) inverse: [f64; 2],
    /// `Y/(r rho^2)` times `X^2`, times `zX` and times `z^2`.
    pub(super) cubes: [f64; 3],
}

/// A ratio of lengths, zero if both vanish: the mean of what is odd around an edge or a corner.
fn ratio(numerator: f64, denominator: f64) -> f64 {
    if denominator == 0.0 {
        0.0
    } else {
        numerator / denominator
    }
}

impl Edge {
    pub(super) fn differences(&self) -> Differences {
        let Self { offset: x, z, .. } = *self;
        let ([y1, y2], [r1, r2]) = (self.extent.ends, self.distances);
        let rho = (x * x + z * z).sqrt();
        let (cosine, sine) = (ratio(x, rho), ratio(z, rho));
        // Y_1^2 - Y_2^2, which is also r_1^2 - r_2^2.
        let length = 2.0 * self.extent.half;
        let squares = 2.0 * self.extent.middle * length;
        let distance = ratio(squares, r1 + r2);

        // Y_1 r_2 - Y_2 r_1, over rho^2 where it vanishes with it, and what remains of X^2, zX and z^2 over rho^2.
        let (lever, [xx, xz, zz]) = if y2 > 0.0 {
            (squares / (y1 * r2 + y2 * r1), [x * x, x * z, z * z])
        } else {
            // On an edge of the surface the limit of X/rho is the same from both sides but for the sign.
            let xx = if rho == 0.0 { 1.0 } else { cosine * cosine };
            (y1 * r2 - y2 * r1, [xx, cosine * sine, sine * sine])
        };
        let product = r1 * r2;
        let [sum1, sum2] = [r1 + z, r2 + z];
        // Both arcs as angles between two directions, from sine and cosine over rho^2.
        let opening = cosine * cosine * y1 * y2;
        let radial = (rho + sine * r1) * (rho + sine * r2);
        Differences {
            asinh: self.asinh(rho),
            theta: (x * length + xz * lever).atan2(radial + opening),
            solid_angle: (xz * lever).atan2(sine * sine * product + opening),
            logarithm: if sum2 == 0.0 {
                (sum1 / self.unit).ln()
            } else {
                (distance / sum2).ln_1p()
            },
            distance,
            ratio: -ratio(x, sum2) * distance / sum1,
            inverse: [x, z].map(|factor| -ratio(factor, r2) * distance / r1),
            cubes: [xx, xz, zz].map(|factor| ratio(factor * lever, product)),
        }
    }

    /// The potential of a uniform line, `ln((r_1 + r_2 + l)/(r_1 + r_2 - l))` of an edge of length `l`.
    fn asinh(&self, rho: f64) -> f64 {
        let length = 2.0 * self.extent.half;
        let ([y1, y2], [r1, r2]) = (self.extent.ends, self.distances);
        if rho == 0.0 && y2 < 0.0 {
            return (-4.0 * (y1 / self.unit) * (y2 / self.unit)).ln();
        }
        if r2 == 0.0 {
            return (2.0 * length / self.unit).ln();
        }
        // r_1 - Y_1 and r_2 + Y_2.
        let gap1 = rho * (rho / (r1 + y1));
        let gap2 = if y2 > 0.0 {
            r2 + y2
        } else {
            rho * (rho / (r2 - y2))
        };
        (2.0 * length / (gap1 + gap2)).ln_1p()
    }
}
