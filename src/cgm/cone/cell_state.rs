//! State of a cell of the friction cone in the semismooth Newton method: apart, frictionless, sticking or slipping.

use crate::cgm::Disc;
use crate::cgm::cone::{FrictionCone, N};
use crate::cgm::law::disc_motion::Weight;
use crate::cgm::law::state::Row;
use crate::numerics::cell_vector::{dot, norm, plus};

/// State of a cell in the linear system of a step.
///
/// The unknowns of the cell are the changes of the pressure and of the traction. A sticking cell has both components of the
/// traction. A slipping cell has only the component along the circle of its limit. The radius of this circle follows the
/// pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ConeCellState {
    pub(super) kind: CellKind,
    /// Whether the cell is at its hardness and its pressure is fixed.
    pub(super) is_held: bool,
    /// Weight of the tangential residual in the preconditioner.
    weight: Weight,
    pub(super) lag: EntryLag,
}

/// Lag of a cell that comes into contact in the step: $`\kappa g\,q/p`$ for a gap g.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct EntryLag {
    /// Mean of the entry compliance $`\kappa g/p`$ over all directions. The mean is zero if the cell does not come into contact.
    pub(super) own: f64,
    /// Deviatoric part of the entry compliance: `[a, b]` of the matrix with the rows `[a, b]` and `[b, -a]`.
    pub(super) deviator: [f64; 2],
    /// Traction over pressure, $`q/p`$.
    pub(super) ratio: [f64; 2],
}

impl EntryLag {
    const NONE: Self = Self {
        own: 0.0,
        deviator: [0.0; 2],
        ratio: [0.0; 2],
    };
}

/// Contact state of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum CellKind {
    /// The cell is apart from the other body.
    Open,
    /// The cell is in contact and carries no shear.
    Frictionless,
    /// The cell is in contact and moves with the other body.
    Stick,
    /// The cell is in contact and slips at its friction limit.
    Slip(Slip),
}

/// State of a slipping cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slip {
    /// Unit direction of the traction.
    pub(super) normal: [f64; 2],
    /// Friction limit.
    limit: f64,
    /// Derivative of the friction limit with respect to the pressure.
    pub(super) slope: f64,
    /// Stiffness added by the curvature of the circle: the slip divided by the limit.
    stiffness: f64,
}

impl Slip {
    /// Creates a slipping state along a unit direction. [`ConeCellState::measured`] sets the other fields.
    fn along(normal: [f64; 2]) -> CellKind {
        CellKind::Slip(Self {
            normal,
            limit: 0.0,
            slope: 0.0,
            stiffness: 0.0,
        })
    }

    pub(super) fn tangent(self) -> [f64; 2] {
        [-self.normal[1], self.normal[0]]
    }
}

/// Thresholds for a change of state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Noise {
    /// Overlap up to which a gap counts as round-off of the inner solution.
    pub(super) gap: f64,
    /// Slip along the traction that counts as round-off of the inner solution.
    pub(super) slip: f64,
    /// Lag of a cell that comes into contact, per unit ratio of traction to pressure.
    pub(super) lag: f64,
    /// Maximum pressure of the cell.
    pub(super) hardness: f64,
}

/// Returns a traction of length `size` in the direction of `v`, which must not be zero.
fn along(v: [f64; 2], size: f64) -> [f64; 2] {
    let scale = size / norm(v);
    v.map(|v| v * scale)
}

impl ConeCellState {
    pub(super) const OPEN: Self = Self::new(CellKind::Open, false);

    const fn new(kind: CellKind, is_held: bool) -> Self {
        Self {
            kind,
            is_held,
            weight: Weight::PATTERN,
            lag: EntryLag::NONE,
        }
    }

    /// Returns the state for the tractions of a start.
    pub(super) fn of([p, x, y]: [f64; N], limit: f64, hardness: f64) -> Self {
        let q = [x, y];
        let kind = if p <= 0.0 {
            CellKind::Open
        } else if limit <= 0.0 {
            CellKind::Frictionless
        } else if (Disc { radius: limit }).is_at_limit(q) {
            Slip::along(along(q, 1.0))
        } else {
            CellKind::Stick
        };
        Self::new(kind, p > 0.0 && p >= hardness)
    }

    /// Returns the state with slip replaced by stick.
    pub(super) fn stuck(self) -> Self {
        match self.kind {
            CellKind::Slip(_) => Self {
                kind: CellKind::Stick,
                ..self
            },
            _ => self,
        }
    }

    /// Returns `value`, a change of the pressure or an equation of the gap, or zero if the pressure is fixed.
    pub(super) fn pressed(self, value: f64) -> f64 {
        if self.is_held { 0.0 } else { value }
    }

    /// Returns the state with limit, slope and stiffness at slip `s`. In the stiffness, `least` replaces a smaller limit.
    /// `self_compliance` is the displacement of a cell under a unit traction on this cell.
    pub(super) fn measured(
        mut self,
        s: [f64; 2],
        [limit, slope]: [f64; 2],
        least: f64,
        self_compliance: f64,
    ) -> Self {
        let mut alone = self.lag.own;
        if let CellKind::Slip(slip) = &mut self.kind {
            let stiffness = (-dot(s, slip.normal)).max(0.0) / limit.max(least);
            (slip.limit, slip.slope, slip.stiffness) = (limit, slope, stiffness);
            alone += stiffness;
        }
        self.weight = if alone > 0.0 {
            Weight::new(alone, self_compliance)
        } else {
            Weight::PATTERN
        };
        self
    }

    /// Returns the next state of a cell and its projected tractions. `x` are the tractions and `r` are the gap and the slip from
    /// the solution of the linear system.
    pub(super) fn next(
        self,
        cell: usize,
        x: [f64; N],
        r: [f64; N],
        friction: &impl FrictionCone,
        noise: Noise,
    ) -> (Self, [f64; N]) {
        let (q, s) = ([x[1], x[2]], [r[1], r[2]]);
        if self.kind == CellKind::Open {
            let kind = CellKind::entered(cell, r, friction, noise);
            return (Self { kind, ..self }, [0.0; N]);
        }
        if x[0] < 0.0 {
            return (Self::OPEN, [0.0; N]);
        }
        // A gap that opens at the hardness requires a lower pressure.
        let is_held = if self.is_held {
            r[0] <= noise.gap
        } else {
            x[0] > noise.hardness
        };
        let p = x[0].min(noise.hardness);
        let limit = friction.limit(cell, p);
        let carrying = |kind: CellKind, q: [f64; 2]| (Self::new(kind, is_held), [p, q[0], q[1]]);
        match self.kind {
            CellKind::Open | CellKind::Frictionless => {
                let has_friction = limit > 0.0;
                let kind = if has_friction {
                    CellKind::Stick
                } else {
                    CellKind::Frictionless
                };
                carrying(kind, [0.0; 2])
            }
            CellKind::Stick if norm(q) <= limit => carrying(self.kind, q),
            CellKind::Stick => carrying(Slip::along(along(q, 1.0)), along(q, limit)),
            CellKind::Slip(slip) => {
                let t = slip.tangent();
                if dot(s, slip.normal) > noise.slip {
                    let size = norm(q).min(limit);
                    let q = if size > 0.0 { along(q, size) } else { [0.0; 2] };
                    return carrying(CellKind::Stick, q);
                }
                // Limits the rotation to an eighth of a turn.
                let size = limit.max(slip.limit);
                let turned = if size > 0.0 { dot(t, q) / size } else { 0.0 };
                let turned = turned.clamp(-1.0, 1.0);
                let direction = [0, 1].map(|c| slip.normal[c] + turned * t[c]);
                let normal = along(direction, 1.0);
                carrying(Slip::along(normal), normal.map(|n| limit * n))
            }
        }
    }
}

impl Row<N> for ConeCellState {
    const HAS_LAG: bool = true;
    const FREE: Self = Self::new(CellKind::Stick, false);
    const FIXED: Self = Self::OPEN;

    fn moves(self) -> bool {
        self.kind != CellKind::Open
    }

    fn is_free(self) -> bool {
        self.kind == CellKind::Stick
    }

    fn is_like(self, other: Self) -> bool {
        let [now, then] = [self, other].map(|law| (law.moves(), law.is_free(), law.is_held));
        now == then
    }

    fn extend(self, v: [f64; N]) -> [f64; N] {
        let p = self.pressed(v[0]);
        match self.kind {
            CellKind::Open => [0.0; N],
            CellKind::Frictionless => [p, 0.0, 0.0],
            CellKind::Stick => [p, v[1], v[2]],
            CellKind::Slip(slip) => {
                let (n, t, grown) = (slip.normal, slip.tangent(), slip.slope * p);
                [p, grown * n[0] + v[1] * t[0], grown * n[1] + v[1] * t[1]]
            }
        }
    }

    fn restrict(self, w: [f64; N]) -> [f64; N] {
        let gap = self.pressed(w[0]);
        match self.kind {
            CellKind::Open => [0.0; N],
            CellKind::Frictionless => [gap, 0.0, 0.0],
            CellKind::Stick => [gap, w[1], w[2]],
            CellKind::Slip(slip) => [gap, dot(slip.tangent(), [w[1], w[2]]), 0.0],
        }
    }

    fn bend(self, v: [f64; N]) -> [f64; N] {
        match self.kind {
            CellKind::Slip(slip) => [0.0, slip.stiffness * v[1], 0.0],
            CellKind::Open | CellKind::Frictionless | CellKind::Stick => [0.0; N],
        }
    }

    fn lag(self, [dp, dx, dy]: [f64; N]) -> [f64; N] {
        let EntryLag {
            own,
            deviator: [a, b],
            ratio,
        } = self.lag;
        let [x, y] = plus([dx, dy], -dp, ratio);
        [0.0, own * x + (a * x + b * y), own * y + (b * x - a * y)]
    }

    fn weighted(self, r: [f64; N]) -> [f64; N] {
        let weight = self.weight;
        match self.kind {
            CellKind::Stick => [r[0], weight.weighted(r[1]), weight.weighted(r[2])],
            CellKind::Slip(slip) => {
                let (t, along) = (slip.tangent(), weight.weighted(r[1]));
                [r[0], along * t[0], along * t[1]]
            }
            CellKind::Open | CellKind::Frictionless => self.restrict(r),
        }
    }

    fn preconditioned(self, answer: [f64; N], r: [f64; N]) -> [f64; N] {
        let mut z = self.restrict(answer);
        let tangential = match self.kind {
            CellKind::Open | CellKind::Frictionless => 1..1,
            CellKind::Slip(_) => 1..2,
            CellKind::Stick => 1..N,
        };
        for c in tangential {
            z[c] = self.weight.preconditioned(z[c], r[c]);
        }
        z
    }
}

impl CellKind {
    /// Returns the next state of a cell that is apart.
    fn entered(cell: usize, r: [f64; N], friction: &impl FrictionCone, noise: Noise) -> Self {
        let (g, s) = (r[0], [r[1], r[2]]);
        let slope = friction.slope(cell, 0.0);
        if g >= -noise.gap {
            Self::Open
        } else if slope <= 0.0 {
            Self::Frictionless
        } else if norm(s) > slope * (noise.lag - g) {
            Slip::along(along(s, -1.0))
        } else {
            Self::Stick
        }
    }
}
