//! A rectangle near the point: closed form, after division if it is slender.

use super::integral::{Integral, Values, sign};
use super::{far, gauss, near};

/// The extent of a rectangle along one axis, as seen from the point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Interval {
    /// The upper and the lower end. Neighbours share them to the last bit.
    pub(super) ends: [f64; 2],
    pub(super) middle: f64,
    pub(super) half: f64,
}

impl Interval {
    /// Of half length `half` around `middle`. Both are kept: differences of the ends would lose digits far away.
    pub(super) fn new(middle: f64, half: f64) -> Self {
        let ends = [middle + half, middle - half];
        Self { ends, middle, half }
    }

    fn between(ends: [f64; 2]) -> Self {
        let middle = 0.5 * (ends[0] + ends[1]);
        let half = 0.5 * (ends[0] - ends[1]);
        Self { ends, middle, half }
    }

    /// Its halves. Only an interval near the point is divided, so differences of the ends keep their digits.
    fn halves(&self) -> [Self; 2] {
        let [end, start] = self.ends;
        [[end, self.middle], [self.middle, start]].map(Self::between)
    }

    /// The interval, or its mirror image, around a middle that is not negative; the sign of the middle.
    fn mirrored(&self) -> (Self, f64) {
        if self.middle >= 0.0 {
            return (*self, 1.0);
        }
        let [end, start] = self.ends;
        let mirrored = Self {
            ends: [-start, -end],
            middle: -self.middle,
            half: self.half,
        };
        (mirrored, -1.0)
    }
}

/// A part of the cell as seen from the point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub(super) x: Interval,
    pub(super) y: Interval,
    pub(super) z: f64,
    /// What replaces a zero distance inside a logarithm.
    pub(super) unit: f64,
}

/// The greatest ratio of sides for the closed form. It cancels in units of the shorter side.
const SLENDEREST: f64 = 2.0;

impl Piece {
    pub(super) fn integrals(&self) -> Values {
        let ((x, sign_x), (y, sign_y)) = (self.x.mirrored(), self.y.mirrored());
        let mut values = Self { x, y, ..*self }.in_quadrant();
        for (value, integral) in values.iter_mut().zip(Integral::ALL) {
            *value *= sign(integral, [sign_x, sign_y]);
        }
        values
    }

    /// The integrals over a piece whose centre lies in the quadrant `x >= 0`, `y >= 0`.
    fn in_quadrant(&self) -> Values {
        let Self { x, y, z, .. } = *self;
        let sides = [x.half, y.half];
        if let Some(rule) = gauss::rule(sides, [x.middle, y.middle, z]) {
            far::integrals(sides, rule, &[x.middle], [y.middle, z]).map(|[value]| value)
        } else if x.half > SLENDEREST * y.half {
            sum_of(x.halves().map(|x| Self { x, ..*self }))
        } else if y.half > SLENDEREST * x.half {
            sum_of(y.halves().map(|y| Self { y, ..*self }))
        } else {
            near::integrals(self)
        }
    }
}

fn sum_of(pieces: [Piece; 2]) -> Values {
    let [mut values, others] = pieces.map(|piece| piece.integrals());
    for (value, other) in values.iter_mut().zip(others) {
        *value += other;
    }
    values
}
