//! Closed form of the integrals over a rectangle near the point. A slender rectangle is divided first.

use super::integral::{PotentialIntegral, Values, sign};
use super::{far, near};
use crate::numerics::gauss::QuadratureRule;

/// Extent of a rectangle along one axis, relative to the point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extent {
    /// Upper and lower end. The common ends of neighbours are bitwise identical.
    pub(super) ends: [f64; 2],
    pub(super) middle: f64,
    pub(super) half: f64,
}

impl Extent {
    /// Creates an interval of half length `half` around `middle`. The half length and the middle are stored, because
    /// differences of the ends would lose accuracy far from the point.
    pub(super) fn new(middle: f64, half: f64) -> Self {
        let ends = [middle + half, middle - half];
        Self { ends, middle, half }
    }

    fn between(ends: [f64; 2]) -> Self {
        let middle = 0.5 * (ends[0] + ends[1]);
        let half = 0.5 * (ends[0] - ends[1]);
        Self { ends, middle, half }
    }

    /// Returns the halves of the interval. Only intervals near the point are divided, so differences of the ends
    /// are accurate.
    fn halves(&self) -> [Self; 2] {
        let [end, start] = self.ends;
        [[end, self.middle], [self.middle, start]].map(Self::between)
    }

    /// Returns the interval or its mirror image, with a non-negative middle, and the sign of the original
    /// middle.
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

/// Part of the cell relative to the point.
#[derive(Debug, Clone, Copy)]
pub(super) struct CellPart {
    pub(super) x: Extent,
    pub(super) y: Extent,
    pub(super) z: f64,
    /// Length that replaces a zero distance inside a logarithm.
    pub(super) unit: f64,
}

/// Largest ratio of sides for which the closed form is used. The cancellation error is relative to the shorter
/// side.
const SLENDEREST: f64 = 2.0;

impl CellPart {
    pub(super) fn integrals(&self) -> Values {
        let Some(halves) = self.halves() else {
            return self.whole();
        };
        // A list replaces recursion, because very slender cells are divided about a hundred times.
        let (mut values, mut pending) = ([0.0; PotentialIntegral::COUNT], halves.to_vec());
        while let Some(piece) = pending.pop() {
            if let Some(halves) = piece.halves() {
                pending.extend(halves);
                continue;
            }
            for (value, part) in values.iter_mut().zip(piece.whole()) {
                *value += part;
            }
        }
        values
    }

    /// Returns the halves of the piece, or `None` if the piece is compact or far from the point.
    fn halves(&self) -> Option<[Self; 2]> {
        let Self { x, y, .. } = self;
        if self.rule().is_some() {
            None
        } else if x.half > SLENDEREST * y.half {
            Some(x.halves().map(|x| Self { x, ..*self }))
        } else if y.half > SLENDEREST * x.half {
            Some(y.halves().map(|y| Self { y, ..*self }))
        } else {
            None
        }
    }

    /// Returns the integrals without subdivision: by quadrature if the piece is far away, otherwise in closed
    /// form.
    fn whole(&self) -> Values {
        let ((x, sign_x), (y, sign_y)) = (self.x.mirrored(), self.y.mirrored());
        let mut values = match self.rule() {
            Some(rule) => {
                let (sides, place) = ([x.half, y.half], [y.middle, self.z]);
                far::integrals(sides, rule, &[x.middle], place).map(|[value]| value)
            }
            None => near::integrals(&Self { x, y, ..*self }),
        };
        for (value, integral) in values.iter_mut().zip(PotentialIntegral::ALL) {
            *value *= sign(integral, [sign_x, sign_y]);
        }
        values
    }

    /// Returns the quadrature rule that suffices at this distance, or `None` near the point.
    fn rule(&self) -> Option<QuadratureRule> {
        let Self { x, y, z, .. } = self;
        far::rule([x.half, y.half], [x.middle, y.middle, *z])
    }
}
