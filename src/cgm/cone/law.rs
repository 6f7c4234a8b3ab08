//! How a cell of the cone moves: apart, without friction, sticking or slipping.

use crate::cgm::cone::{Cone, N};
use crate::cgm::turn::Weight;
use crate::cgm::vector::{dot, norm};

/// How a cell may move, in the linear system of a step.
///
/// Its unknowns are the changes of the pressure and of the traction: of both components where it sticks, along the
/// circle of its limit where it slips, where the limit follows the pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Law {
    /// Apart.
    Open,
    /// In contact, and carries no shear.
    Smooth,
    /// In contact, and moves with the other body.
    Stick,
    /// In contact at its limit.
    Slip(Slip),
}

/// A cell at its limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slip {
    /// Direction of the traction.
    pub(super) normal: [f64; 2],
    /// The limit, and how it grows with the pressure.
    limit: f64,
    slope: f64,
    /// Slip over the limit: what the curvature of the circle adds to the stiffness.
    stiffness: f64,
    weight: Weight,
}

impl Slip {
    /// Along a direction of length one; the rest is [measured](Law::measured).
    fn along(normal: [f64; 2]) -> Law {
        Law::Slip(Self {
            normal,
            limit: 0.0,
            slope: 0.0,
            stiffness: 0.0,
            weight: Weight::PATTERN,
        })
    }

    fn tangent(self) -> [f64; 2] {
        [-self.normal[1], self.normal[0]]
    }
}

/// What a change of sets is decided by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Noise {
    /// An overlap that is round-off of the inner solution.
    pub(super) gap: f64,
    /// A slip along the traction that is.
    pub(super) slip: f64,
    /// By how much a cell that touches lags, for each traction over pressure.
    pub(super) lag: f64,
}

/// Relative distance from the limit within which a traction is at it.
const RIM: f64 = 1e-12;

/// A traction `size` in the direction of `v`, which is not zero.
fn along(v: [f64; 2], size: f64) -> [f64; 2] {
    let scale = size / norm(v);
    v.map(|v| v * scale)
}

impl Law {
    /// At the tractions of a start.
    pub(super) fn of([p, x, y]: [f64; N], limit: f64) -> Self {
        let q = [x, y];
        if p <= 0.0 {
            Self::Open
        } else if limit <= 0.0 {
            Self::Smooth
        } else if norm(q) >= limit * (1.0 - RIM) {
            Slip::along(along(q, 1.0))
        } else {
            Self::Stick
        }
    }

    pub(super) fn touches(self) -> bool {
        self != Self::Open
    }

    pub(super) fn sticks(self) -> bool {
        self == Self::Stick
    }

    /// The same but slip, which becomes stick.
    pub(super) fn stuck(self) -> Self {
        match self {
            Self::Slip(_) => Self::Stick,
            other => other,
        }
    }

    /// What the cell can do of a uniform motion, a matrix of x and y.
    pub(super) fn mobility(self) -> [[f64; 2]; 2] {
        match self {
            Self::Open | Self::Smooth => [[0.0; 2]; 2],
            Self::Stick => [[1.0, 0.0], [0.0, 1.0]],
            Self::Slip(slip) => {
                let t = slip.tangent();
                t.map(|along| t.map(|t| along * t))
            }
        }
    }

    /// With limit, slope and stiffness at slip `s`; limits below `least` have the stiffness of that. The last are the least
    /// eigenvalue of the operator and what the cell has of its own.
    pub(super) fn measured(
        self,
        s: [f64; 2],
        [limit, slope]: [f64; 2],
        least: f64,
        [lower_bound, own]: [f64; 2],
    ) -> Self {
        let Self::Slip(slip) = self else { return self };
        let stiffness = (-dot(s, slip.normal)).max(0.0) / limit.max(least);
        Self::Slip(Slip {
            limit,
            slope,
            stiffness,
            weight: Weight::new(stiffness + own, lower_bound),
            ..slip
        })
    }

    /// The change of the tractions that changes of the unknowns make.
    pub(super) fn extend(self, v: [f64; N]) -> [f64; N] {
        match self {
            Self::Open => [0.0; N],
            Self::Smooth => [v[0], 0.0, 0.0],
            Self::Stick => v,
            Self::Slip(slip) => {
                let (n, t, grown) = (slip.normal, slip.tangent(), slip.slope * v[0]);
                [v[0], grown * n[0] + v[1] * t[0], grown * n[1] + v[1] * t[1]]
            }
        }
    }

    /// The equations of a cell, from displacements.
    pub(super) fn restrict(self, w: [f64; N]) -> [f64; N] {
        match self {
            Self::Open => [0.0; N],
            Self::Smooth => [w[0], 0.0, 0.0],
            Self::Stick => w,
            Self::Slip(slip) => [w[0], dot(slip.tangent(), [w[1], w[2]]), 0.0],
        }
    }

    /// The negative equations of a cell at its tractions, with gap and slip `r`: what is left to solve.
    pub(super) fn residual(self, x: [f64; N], r: [f64; N]) -> [f64; N] {
        let moved = match self {
            Self::Slip(slip) => [0.0, dot(slip.tangent(), [x[1], x[2]]), 0.0],
            Self::Open | Self::Smooth | Self::Stick => [0.0; N],
        };
        let (row, bend) = (self.restrict(r), self.bend(moved));
        std::array::from_fn(|c| -row[c] - bend[c])
    }

    /// What the curvature of the circle adds to the equations at changes of the unknowns.
    pub(super) fn bend(self, v: [f64; N]) -> [f64; N] {
        match self {
            Self::Slip(slip) => [0.0, slip.stiffness * v[1], 0.0],
            Self::Open | Self::Smooth | Self::Stick => [0.0; N],
        }
    }

    /// The pattern of tractions that goes to the inverse operator for a residual, of a cell with this weight while it
    /// sticks.
    pub(super) fn weighted(self, r: [f64; N], weight: Weight) -> [f64; N] {
        match self {
            Self::Stick => [r[0], weight.weighted(r[1]), weight.weighted(r[2])],
            Self::Slip(slip) => {
                let (t, along) = (slip.tangent(), slip.weight.weighted(r[1]));
                [r[0], along * t[0], along * t[1]]
            }
            other => other.restrict(r),
        }
    }

    /// The preconditioned residual, with the `answer` of the inverse operator.
    pub(super) fn preconditioned(self, answer: [f64; N], r: [f64; N], weight: Weight) -> [f64; N] {
        let mut z = self.restrict(answer);
        match self {
            Self::Open | Self::Smooth => {}
            Self::Stick => {
                for c in 1..N {
                    z[c] = weight.preconditioned(z[c], r[c]);
                }
            }
            Self::Slip(slip) => z[1] = slip.weight.preconditioned(z[1], r[1]),
        }
        z
    }

    /// How a cell moves next, and where it stands, after the linear system has left it at the tractions `x` with gap
    /// and slip `r`.
    pub(super) fn next(
        self,
        cell: usize,
        x: [f64; N],
        r: [f64; N],
        friction: &impl Cone,
        noise: Noise,
    ) -> (Self, [f64; N]) {
        let (p, q, s) = (x[0], [x[1], x[2]], [r[1], r[2]]);
        if self == Self::Open {
            return (Self::entered(cell, r, friction, noise), [0.0; N]);
        }
        if p < 0.0 {
            return (Self::Open, [0.0; N]);
        }
        let limit = friction.limit(cell, p);
        let carrying = |law: Self, q: [f64; 2]| (law, [p, q[0], q[1]]);
        match self {
            Self::Open | Self::Smooth => {
                let has_friction = limit > 0.0;
                let law = if has_friction {
                    Self::Stick
                } else {
                    Self::Smooth
                };
                carrying(law, [0.0; 2])
            }
            Self::Stick if norm(q) <= limit => carrying(self, q),
            Self::Stick => carrying(Slip::along(along(q, 1.0)), along(q, limit)),
            Self::Slip(slip) => {
                let t = slip.tangent();
                if dot(s, slip.normal) > noise.slip {
                    let size = norm(q).min(limit);
                    let q = if size > 0.0 { along(q, size) } else { [0.0; 2] };
                    return carrying(Self::Stick, q);
                }
                // At most an eighth of a turn.
                let size = limit.max(slip.limit);
                let turned = if size > 0.0 { dot(t, q) / size } else { 0.0 };
                let turned = turned.clamp(-1.0, 1.0);
                let direction = [0, 1].map(|c| slip.normal[c] + turned * t[c]);
                let normal = along(direction, 1.0);
                carrying(Slip::along(normal), normal.map(|n| limit * n))
            }
        }
    }

    /// What becomes of a cell that is apart.
    fn entered(cell: usize, r: [f64; N], friction: &impl Cone, noise: Noise) -> Self {
        let (g, s) = (r[0], [r[1], r[2]]);
        let slope = friction.slope(cell, 0.0);
        if g >= -noise.gap {
            Self::Open
        } else if slope <= 0.0 {
            Self::Smooth
        } else if norm(s) > slope * (noise.lag - g) {
            Slip::along(along(s, -1.0))
        } else {
            Self::Stick
        }
    }
}
