//! Motion of a cell of a disc in the semismooth Newton step. The motion is free while the cell sticks, and along the circle while
//! it slips.

use crate::cgm::law::state::Row;
use crate::numerics::cell_vector::{dot, norm};

/// Motion of a cell of a disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum DiscMotion {
    /// The cell sticks and moves in any direction.
    Free,
    /// The cell slips and moves along the circle.
    Tangential {
        /// Direction of the circle at the traction.
        tangent: [f64; 2],
        /// Stiffness added by the curvature of the circle: the component of the gradient against the traction, divided by the
        /// radius.
        stiffness: f64,
        /// Weight of the cell in the preconditioner.
        weight: Weight,
    },
    /// The cell does not move.
    Fixed,
}

/// Weights of a cell in the preconditioner: a weight for the inverse operator and a weight for the single cell.
///
/// Let $`k`$ be the sum of the stiffness of the circle and the additional compliance of the cell. The inverse operator $`M`$ does
/// not include $`k`$. The inverse of the system $`C + k`$ is known in two limits. It is $`M`$ for $`k \ll C`$. For $`k \gg C`$ it
/// is $`1 / (c_1 + k)`$ in each cell, where $`c_1`$ is the compliance of a single moving cell. Between these limits the
/// preconditioner is
///
/// ```math
/// W M W + (1 - W^2)\, (c_1 + k)^{-1}, \qquad W = \frac{e}{e + k} ,
/// ```
///
/// with the weights $`0 < W \le 1`$ of the cells. Both terms are symmetric and positive definite, and so is the preconditioner.
/// It is exact in both limits. At the stiffness $`e`$, the weight $`W^2`$ of $`M`$ is one quarter. The value of $`e`$ is half of
/// $`c_1`$, chosen from measurements on smooth and rough balls in growing contact. For values from two fifths to three fifths of
/// $`c_1`$, the number of steps changed by 2 %. In these tests $`c_1`$ was four to six times the least eigenvalue of a
/// half-space. The square root of this weight would require a tenth more steps, or a third more if cells come into contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Weight {
    /// Factor of the input and of the result of the inverse operator.
    pattern: f64,
    /// Factor of the residual in the term of the single cell.
    own: f64,
}

impl Weight {
    pub(in crate::cgm) const PATTERN: Self = Self {
        pattern: 1.0,
        own: 0.0,
    };

    /// Creates the weights for a stiffness of the circle and an operator with this [compliance](crate::Operator::self_compliance)
    /// of a cell.
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

    /// Returns the part of a residual that the inverse operator receives.
    pub(crate) fn weighted(self, r: f64) -> f64 {
        self.pattern * r
    }

    /// Returns the preconditioned residual from the result of the inverse operator and its input.
    pub(in crate::cgm) fn preconditioned_from(self, answer: f64, weighted: f64) -> f64 {
        self.preconditioned(answer, weighted / self.pattern.max(f64::MIN_POSITIVE))
    }

    /// Returns the preconditioned residual from the result of the inverse operator and the residual.
    pub(crate) fn preconditioned(self, answer: f64, r: f64) -> f64 {
        self.pattern * answer + self.own * r
    }
}

impl DiscMotion {
    /// Creates the motion of a slipping cell with this traction and stiffness. The preconditioner does not include the stiffness
    /// yet.
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
    const IS_STEADY: bool = true;
    const FREE: Self = Self::Free;
    const FIXED: Self = Self::Fixed;

    fn moves(self) -> bool {
        self != Self::Fixed
    }

    fn is_free(self) -> bool {
        self == Self::Free
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

    fn with_preconditioner_weight(mut self, self_compliance: f64, diagonal: f64) -> Self {
        if let Self::Tangential {
            stiffness, weight, ..
        } = &mut self
        {
            *weight = Weight::new(*stiffness + diagonal, self_compliance);
        }
        self
    }
}
