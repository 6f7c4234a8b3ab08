//! Differences of the antiderivatives between the two ends of an edge of the cell, without cancellation.

use super::piece::Extent;

/// Edge parallel to y, in coordinates relative to the point. The edge is at the distance `X` along x and extends from
/// `Y_2` to `Y_1` along y. For an edge parallel to x the axes are exchanged.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    /// Distance `X`.
    pub(super) offset: f64,
    pub(super) z: f64,
    /// Interval from `Y_2` to `Y_1 >= |Y_2|`.
    pub(super) extent: Extent,
    /// Distances `r_1 >= r_2` of the ends.
    pub(super) distances: [f64; 2],
    /// Length that replaces a zero distance inside a logarithm.
    pub(super) unit: f64,
}

/// Differences of functions between the ends of an edge: the value at `(X, Y_1)` minus the value at `(X, Y_2)`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Differences {
    /// Difference of `asinh(Y/rho)` with `rho^2 = X^2 + z^2`.
    pub(super) asinh: f64,
    /// Difference of `arctan(XY/(rho^2 + zr))`.
    pub(super) theta: f64,
    /// Difference of `arctan(XY/(zr))`.
    pub(super) solid_angle: f64,
    /// Difference of `ln(r + z)`.
    pub(super) logarithm: f64,
    /// Difference of `r`.
    pub(super) distance: f64,
    /// Difference of `X/(r + z)`.
    pub(super) ratio: f64,
    /// Differences of `X/r` and `z/r`.
    pub(super) inverse: [f64; 2],
    /// Differences of `Y/(r rho^2)` times `X^2`, times `zX` and times `z^2`.
    pub(super) cubes: [f64; 3],
}

/// Returns a ratio of lengths, or zero if both lengths vanish. Zero is the mean of an odd function around an edge or a
/// corner.
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
        // The value is Y_1^2 - Y_2^2, which equals r_1^2 - r_2^2.
        let length = 2.0 * self.extent.half;
        let squares = 2.0 * self.extent.middle * length;
        let distance = ratio(squares, r1 + r2);

        // The lever is Y_1 r_2 - Y_2 r_1, and the factors are X^2, zX and z^2. The lever is divided by rho^2 if it
        // vanishes with rho. Otherwise the factors are divided by rho^2.
        let (lever, [xx, xz, zz]) = if y2 > 0.0 {
            (squares / (y1 * r2 + y2 * r1), [x * x, x * z, z * z])
        } else {
            // On an edge of the surface the limits of X/rho from both sides differ only in sign.
            let xx = if rho == 0.0 { 1.0 } else { cosine * cosine };
            (y1 * r2 - y2 * r1, [xx, cosine * sine, sine * sine])
        };
        let product = r1 * r2;
        let [sum1, sum2] = [r1 + z, r2 + z];
        // Both arcs are angles between two directions. They are computed from their sine and cosine, divided by rho^2.
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

    /// Returns the potential of a uniform line, `ln((r_1 + r_2 + l)/(r_1 + r_2 - l))` for an edge of length `l`.
    fn asinh(&self, rho: f64) -> f64 {
        let length = 2.0 * self.extent.half;
        let ([y1, y2], [r1, r2]) = (self.extent.ends, self.distances);
        if rho == 0.0 && y2 < 0.0 {
            return (-4.0 * (y1 / self.unit) * (y2 / self.unit)).ln();
        }
        if r2 == 0.0 {
            return (2.0 * length / self.unit).ln();
        }
        // The gaps are r_1 - Y_1 and r_2 + Y_2.
        let gap1 = rho * (rho / (r1 + y1));
        let gap2 = if y2 > 0.0 {
            r2 + y2
        } else {
            rho * (rho / (r2 - y2))
        };
        (2.0 * length / (gap1 + gap2)).ln_1p()
    }
}
