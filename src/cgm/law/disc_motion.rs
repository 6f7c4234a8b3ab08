//! How a cell of a disc moves: freely while it sticks, along the circle while it slips.

use crate::cgm::law::state::{CellMotion, Row};
use crate::numerics::cell_vector::{dot, norm};

/// How a cell of a disc may move.
#[expect(
    unnameable_types,
    reason = "it appears in the sealed traits of the sets alone"
)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DiscMotion {
    /// In any direction: it sticks.
    Free,
    /// Along the circle: it slips.
    Tangential {
        /// Direction of the circle where the vector is.
        tangent: [f64; 2],
        /// Gradient against the vector over the radius: what the curvature of the circle adds to the stiffness.
        stiffness: f64,
        /// What the preconditioner makes of a residual here.
        weight: Weight,
    },
    /// Not at all.
    Fixed,
}

/// What of a residual the preconditioner answers as a smooth pattern, and what the cell alone.
///
/// The inverse operator $`M`$ does not know the stiffness $`k`$ of the circles, nor what cells have of their own, which
/// is a part of $`k`$. Both limits of the system $`C + k`$
/// have an inverse at hand: that of $`k \ll C`$ is $`M`$, that of $`k \gg C`$ is $`1 / (c_1 + k)`$ in each cell, with
/// $`c_1`$ the compliance of a cell that moves alone. Between them the preconditioner is
///
/// ```math
/// W M W + (1 - W^2)\, (c_1 + k)^{-1}, \qquad W = \frac{e}{e + k} ,
/// ```
///
/// with the weights $`0 < W \le 1`$ of the cells: symmetric and positive definite like both parts, and exact in both
/// limits. The stiffness $`e`$ at which a pattern counts a quarter is a choice, measured: half of $`c_1`$. From two fifths
/// to three fifths of it, and with $`c_1`$ from four to six least eigenvalues of a half-space, the steps change by 2 % on
/// smooth and rough balls in growing contact; the root of the weight costs a tenth more, in cells that enter a third.
#[expect(
    unnameable_types,
    reason = "it appears in the sealed traits of the sets alone"
)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weight {
    /// Of the residual before, and of the answer after the inverse operator.
    pattern: f64,
    /// Answer of the cell alone.
    own: f64,
}

impl Weight {
    pub(in crate::cgm) const PATTERN: Self = Self {
        pattern: 1.0,
        own: 0.0,
    };

    /// For a stiffness of the circle beside an operator of this [compliance](crate::Operator::self_compliance) of a cell.
    pub(crate) fn new(stiffness: f64, self_compliance: f64) -> Self {
        let even = 0.5 * self_compliance;
        if even <= 0.0 {
            return Self::PATTERN;
        }
        let pattern = even / (even + stiffness);
        Self {
            pattern,
            own: (1.0 - pattern * pattern) / (self_compliance + stiffness),
        }
    }

    /// What of a residual goes to the inverse operator.
    pub(crate) fn weighted(self, r: f64) -> f64 {
        self.pattern * r
    }

    /// The preconditioned residual, with the answer of the inverse operator and what went there.
    pub(in crate::cgm) fn preconditioned_from(self, answer: f64, weighted: f64) -> f64 {
        self.preconditioned(answer, weighted / self.pattern.max(f64::MIN_POSITIVE))
    }

    /// The preconditioned residual, with the answer of the inverse operator.
    pub(crate) fn preconditioned(self, answer: f64, r: f64) -> f64 {
        self.pattern * answer + self.own * r
    }
}

impl DiscMotion {
    /// At its limit with this traction, of this stiffness, of which the preconditioner is not told yet.
    pub(in crate::cgm) fn along(q: [f64; 2], stiffness: f64) -> Self {
        let size = norm(q);
        Self::Tangential {
            tangent: [-q[1] / size, q[0] / size],
            stiffness,
            weight: Weight::PATTERN,
        }
    }
}

impl Row<2> for DiscMotion {
    const IS_CURVED: bool = true;
    const IS_STEADY: bool = true;
    const FREE: Self = Self::Free;
    const FIXED: Self = Self::Fixed;

    fn moves(self) -> bool {
        self != Self::Fixed
    }

    fn is_free(self) -> bool {
        self == Self::Free
    }

    /// The unknowns are a vector along the tangent.
    #[inline]
    fn extend(self, v: [f64; 2]) -> [f64; 2] {
        v
    }

    #[inline]
    fn restrict(self, w: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Free => w,
            Self::Tangential { tangent, .. } => tangent.map(|t| t * dot(tangent, w)),
            Self::Fixed => [0.0; 2],
        }
    }

    #[inline]
    fn bend(self, d: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Tangential { stiffness, .. } => d.map(|d| stiffness * d),
            Self::Free | Self::Fixed => [0.0; 2],
        }
    }

    #[inline]
    fn weighted(self, r: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Tangential { weight, .. } => r.map(|r| weight.weighted(r)),
            Self::Free | Self::Fixed => r,
        }
    }

    #[inline]
    fn preconditioned(self, answer: [f64; 2], r: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Free => answer,
            Self::Tangential {
                tangent, weight, ..
            } => {
                let along = weight.pattern * dot(tangent, answer);
                [0, 1].map(|c| tangent[c] * along + weight.own * r[c])
            }
            Self::Fixed => [0.0; 2],
        }
    }
}

impl CellMotion<2> for DiscMotion {
    fn with_preconditioner_weight(mut self, self_compliance: f64, diagonal: f64) -> Self {
        if let Self::Tangential {
            stiffness, weight, ..
        } = &mut self
        {
            *weight = Weight::new(*stiffness + diagonal, self_compliance);
        }
        self
    }

    fn released_from_bound(self, _: [f64; 2]) -> Self {
        self
    }
}
