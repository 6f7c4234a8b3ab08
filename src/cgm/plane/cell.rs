//! How a cell may move, and how the preconditioner sees it.

use crate::cgm::plane::disc::{dot, norm};

/// A cell that can carry a traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Cell {
    /// In any direction.
    Stick,
    /// Along the circle.
    Slip {
        /// Direction of the circle where the traction is.
        tangent: [f64; 2],
        /// Slip against the traction over the limit: what the curvature of the circle adds to the stiffness.
        stiffness: f64,
        share: Share,
    },
}

/// What of a residual the preconditioner answers as a smooth pattern, and what the cell by itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Share {
    /// Of the residual before, and of the answer after the inverse operator.
    weight: f64,
    /// Answer of the cell by itself.
    own: f64,
}

/// The stiffness at which pattern and cell share evenly, and the compliance of a cell that moves by itself, in
/// least eigenvalues of the operator: of the half-space a cell's own compliance is about two of them, and
/// the mean about four. Measured on spheres: half as much of either changes little, twice as much costs a third more
/// steps.
const EVEN: f64 = 2.0;
const SINGLE: f64 = 4.0;

impl Share {
    const PATTERN: Self = Self {
        weight: 1.0,
        own: 0.0,
    };

    /// For a stiffness of the circle beside an operator of this least eigenvalue.
    fn new(stiffness: f64, lower_bound: f64) -> Self {
        let even = EVEN * lower_bound;
        if even <= 0.0 {
            return Self::PATTERN;
        }
        let pattern = even / (even + stiffness);
        Self {
            weight: pattern.sqrt(),
            own: (1.0 - pattern) / (SINGLE * lower_bound + stiffness),
        }
    }
}

impl Cell {
    /// At its limit with this traction, before its slip is known.
    pub(super) fn slipping(q: [f64; 2]) -> Self {
        let size = norm(q);
        Self::Slip {
            tangent: [-q[1] / size, q[0] / size],
            stiffness: 0.0,
            share: Share::PATTERN,
        }
    }

    /// Lets go of a traction beyond the limit: as stiff as if its own compliance alone had held what is beyond. Were
    /// it not stiff before its slip is measured, a total that is spread in the meantime would turn it right round.
    pub(super) fn let_go(q: [f64; 2], limit: f64, lower_bound: f64) -> Self {
        let excess = SINGLE * lower_bound * (1.0 - limit / norm(q));
        let mut cell = Self::slipping(q);
        cell.stiffen(q.map(|q| -excess * q), limit);
        cell
    }

    /// At its limit with this traction, as stiff as it was.
    pub(super) fn turned_to(self, q: [f64; 2]) -> Self {
        match (self, Self::slipping(q)) {
            (
                Self::Slip {
                    stiffness, share, ..
                },
                Self::Slip { tangent, .. },
            ) => Self::Slip {
                tangent,
                stiffness,
                share,
            },
            (_, turned) => turned,
        }
    }

    /// Takes the stiffness that a slip `g` at the limit gives it.
    pub(super) fn stiffen(&mut self, g: [f64; 2], limit: f64) {
        if let Self::Slip {
            tangent, stiffness, ..
        } = self
        {
            // Across the tangent, outwards.
            let n = [tangent[1], -tangent[0]];
            *stiffness = (-dot(g, n)).max(0.0) / limit;
        }
    }

    /// Tells the preconditioner of the stiffness, beside an operator of this least eigenvalue.
    pub(super) fn share(&mut self, lower_bound: f64) {
        if let Self::Slip {
            stiffness, share, ..
        } = self
        {
            *share = Share::new(*stiffness, lower_bound);
        }
    }

    pub(super) fn is_stick(self) -> bool {
        self == Self::Stick
    }

    /// The part of a vector along which the cell can move.
    pub(super) fn project(self, v: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Stick => v,
            Self::Slip { tangent, .. } => tangent.map(|t| t * dot(tangent, v)),
        }
    }

    /// What of a residual goes to the inverse operator.
    pub(super) fn weighted(self, r: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Stick => r,
            Self::Slip { share, .. } => r.map(|r| share.weight * r),
        }
    }

    /// The preconditioned residual, with the `answer` of the inverse operator.
    pub(super) fn preconditioned(self, answer: [f64; 2], r: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Stick => answer,
            Self::Slip { tangent, share, .. } => {
                let along = share.weight * dot(tangent, answer);
                [0, 1].map(|b| tangent[b] * along + share.own * r[b])
            }
        }
    }

    pub(super) fn stiffness(self) -> f64 {
        match self {
            Self::Slip { stiffness, .. } => stiffness,
            Self::Stick => 0.0,
        }
    }
}
