//! Integrals over a cell and all its images along y.

use crate::influence::integrals::{Cell, Integral};
use crate::numerics::gauss::GAUSS_4;

/// Row of cells that is periodic along y, in the unit of the [`Cell`].
///
/// The integrals of the images with numbers up to [`WHOLE`] have the weight one in the sum. The weights of the next
/// images decrease to zero. A uniform strip replaces the farther images. The weights correct for the difference up to
/// the fifteenth derivative at the end of the strip. They are the weights of the midpoint rule with Gregory's end
/// corrections in central differences. The remaining error is 4e-15 of an image at the distance of one period.
///
/// The strip has infinite displacement. The displacement of `1/R` is taken relative to the datum. The displacements of
/// `X^2/R^3` are relative to an arbitrary point of the surface. The choice has no effect, because the strip moves all
/// these points by the same amount.
#[derive(Debug, Clone, Copy)]
pub(super) struct Images {
    /// Period of the row.
    pub(super) period: f64,
    /// Distance at which a line load causes no displacement.
    pub(super) datum: f64,
}

/// Number of images on each side with the weight one.
const WHOLE: i32 = 8;

/// Differences between one and the weights of the images up to [`END`], starting at the end. They are also the weights
/// of the images beyond the end, which would be zero without the correction.
const CORRECTIONS: [f64; 8] = [
    5.984_979_299_564_494e-2,
    -8.555_555_935_044_48e-3,
    2.027_846_776_850_52e-3,
    -4.855_957_311_855_492_4e-4,
    9.934_977_992_661_57e-5,
    -1.546_661_444_853_505e-5,
    1.589_200_089_739_652_3e-6,
    -7.981_009_139_050_703e-8,
];

/// Number of the last image inside the section of the strip that images replace.
const END: i32 = WHOLE + 8;

/// Distance in periods beyond which images act like a strip up to round-off, `exp(-2 pi 6) = 4e-17`.
pub(crate) const FAR: f64 = 6.0;

impl Images {
    /// Computes the integral at the points `(x, y)` of a row, with ascending `x >= 0` and `0 <= y <= period/2`.
    pub(super) fn along_row(
        self,
        cell: Cell,
        integral: Integral,
        xs: &[f64],
        y: f64,
        out: &mut [f64],
    ) {
        // At these y the images on both sides are symmetric, so odd integrals vanish.
        if integral.is_odd()[1] && (y == 0.0 || 2.0 * y >= self.period) {
            out.fill(0.0);
            return;
        }
        let share = 2.0 * cell.b / self.period;
        for (out, &x) in out.iter_mut().zip(xs) {
            *out = share * self.of_strip(cell.a, integral, x);
        }
        // A cell as long as the period is a strip.
        if share >= 1.0 {
            return;
        }
        let near = xs.partition_point(|x| *x < cell.a + FAR * self.period);
        let (xs, out) = (&xs[..near], &mut out[..near]);
        let mut part = vec![0.0; near];
        let mut add = |cell: Cell, y: f64, weight: f64| {
            cell.along_row(integral, xs, y.abs(), &mut part);
            let is_negative = integral.is_odd()[1] && y < 0.0;
            let weight = if is_negative { -weight } else { weight };
            for (out, part) in out.iter_mut().zip(&part) {
                *out += weight * part;
            }
        };
        for piece in pieces(cell.b, self.period) {
            let other = Cell {
                b: piece.half,
                ..cell
            };
            add(other, y + piece.offset, piece.weight);
        }
    }

    /// Returns the integral over an infinitely long strip of half width `a` along y.
    fn of_strip(self, a: f64, integral: Integral, x: f64) -> f64 {
        match integral {
            // The integral of -2 ln(|x|/d) is 4 a - 2 (x + a) ln(|x + a|/d) + 2 (x - a) ln(|x - a|/d). It is computed
            // in terms that do not cancel.
            Integral::Potential => {
                let log = |x: f64| (x / self.datum).abs().ln();
                let inner = if x == 0.0 {
                    2.0 * log(a)
                } else {
                    log(x + a) + log(x - a) + x / a * (2.0 * a / (x - a)).ln_1p()
                };
                2.0 * a * (2.0 - inner)
            }
            Integral::RadialX => std::f64::consts::TAU * x.min(a),
            Integral::AlongX | Integral::Diagonal | Integral::RadialY => 0.0,
        }
    }
}

/// Piece of the same width as the cell. Its integrals, multiplied by the weight, contribute to the difference between a
/// strip and a row of images.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ImageStrip {
    /// Half side along y.
    pub(crate) half: f64,
    /// Whether the piece belongs to the strip that is subtracted, and is not an image.
    pub(crate) is_strip: bool,
    /// Distance of the piece from the cell towards lower y.
    pub(crate) offset: f64,
    pub(crate) weight: f64,
}

/// Returns the pieces that must be added to a uniform strip. The sum is the row of images of a cell with half side b.
pub(crate) fn pieces(b: f64, period: f64) -> impl Iterator<Item = ImageStrip> {
    let share = 2.0 * b / period;
    // A uniform strip represents cells of a finite length, so its ends are averaged over this length.
    let strip = GAUSS_4.into_iter().map(move |[node, part]| ImageStrip {
        half: (f64::from(END) + 0.5) * period,
        is_strip: true,
        offset: node * b,
        weight: -0.5 * part * share,
    });
    let last = END + 8;
    let images = (-last..=last).map(move |image| ImageStrip {
        half: b,
        is_strip: false,
        offset: f64::from(image) * period,
        weight: weight(image),
    });
    strip.chain(images)
}

/// Returns the weight of an image.
fn weight(image: i32) -> f64 {
    let image = image.abs();
    let beyond = image - END;
    if image <= WHOLE {
        1.0
    } else if beyond <= 0 {
        1.0 - CORRECTIONS[beyond.unsigned_abs() as usize]
    } else {
        CORRECTIONS[beyond.unsigned_abs() as usize - 1]
    }
}
