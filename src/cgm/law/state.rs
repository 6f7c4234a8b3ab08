//! Linearisation of the sets: the motion of a cell in the linear problem, and the interface of each type of set.
//!
//! The semismooth Newton method linearises the condition of every cell. A cell that cannot move leaves the linear system. A cell
//! inside its set moves freely. A cell on a curved bound moves along the tangent, and the curvature of the bound adds a
//! stiffness.

use crate::cgm::{Constraint, ConstraintSet};
use crate::error::Result;
use crate::parallel::layout::Layout;

/// Row of one cell in the linear problem of an outer step.
///
/// A change `v` of the unknowns changes the tractions by [`extend`](Self::extend). [`restrict`](Self::restrict) forms the
/// equations of the cell from the resulting displacements `w`. If the problem is the optimality condition of a minimum, the two
/// maps are transposes of each other.
pub(crate) trait Row<const N: usize>:
    Copy + std::fmt::Debug + Send + Sync + 'static
{
    /// Whether some cell that can move has fewer free directions than components.
    const IS_CURVED: bool = true;
    /// Whether the same cells move throughout the solve: all cells whose set has more than one point.
    const IS_STEADY: bool = false;
    /// Whether a row can have an additional displacement of its cell (see [`lag`](Self::lag)).
    const HAS_LAG: bool = false;
    /// Row of a cell that moves in any direction.
    const FREE: Self;
    /// Row of a cell that does not move.
    const FIXED: Self;

    /// Returns whether the linear system contains the cell.
    fn moves(self) -> bool;

    /// Returns whether the cell moves in any direction.
    fn is_free(self) -> bool;

    /// Returns whether the cell moves in the same way as in another state.
    #[inline]
    fn is_like(self, other: Self) -> bool {
        self.moves() == other.moves() && self.is_free() == other.is_free()
    }

    /// Returns the change of the tractions for a change of the unknowns.
    #[inline]
    fn extend(self, v: [f64; N]) -> [f64; N] {
        v
    }

    /// Returns the residual of the equations of the cell for these displacements.
    #[inline]
    fn restrict(self, w: [f64; N]) -> [f64; N] {
        w
    }

    /// Returns the term that the curvature of a bound adds to the equations for a change of the unknowns.
    #[inline]
    fn bend(self, _v: [f64; N]) -> [f64; N] {
        [0.0; N]
    }

    /// Returns the additional displacement of the cell under a change `d` of its tractions. The displacement that the operator
    /// computes is not included.
    fn lag(self, _d: [f64; N]) -> [f64; N] {
        [0.0; N]
    }

    /// Returns the tractions that the inverse operator receives for a residual.
    #[inline]
    fn weighted(self, r: [f64; N]) -> [f64; N] {
        r
    }

    /// Returns the preconditioned residual, where `answer` is the result of the inverse operator.
    #[inline]
    fn preconditioned(self, answer: [f64; N], _r: [f64; N]) -> [f64; N] {
        answer
    }

    /// Passes the current stiffness to the preconditioner. The arguments are the [compliance](crate::Operator::self_compliance)
    /// of a cell in the operator and the additional compliance `diagonal` of this cell.
    #[must_use]
    fn with_preconditioner_weight(self, _self_compliance: f64, _diagonal: f64) -> Self {
        self
    }

    /// Returns the motion of a cell after a gradient `g` has released the cell from its bound. If `g` does not push the cell away
    /// from the bound, the motion is unchanged.
    #[must_use]
    fn released_from_bound(self, _g: [f64; N]) -> Self {
        self
    }
}

/// Position of prescribed sums in the range that the sets allow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum TotalFeasibility<const N: usize> {
    /// The sums are strictly between the extremes: multipliers exist.
    Inside,
    /// The sums require every cell at the extreme point of its set along this direction.
    Extreme([f64; N]),
}

/// Interface of a type of set for the solver, in addition to [`ConstraintSet`].
pub(crate) trait LinearisedSet<const N: usize>:
    Copy + std::fmt::Debug + Send + Sync + 'static
{
    /// Motion of a cell of this set.
    type CellMotion: Row<N>;

    /// Returns an error if the set is empty.
    fn check(self, cell: usize) -> Result<()>;

    /// Returns whether the set has more than one point.
    fn can_move(self) -> bool;

    /// Returns whether a point is inside the bounds, where the whole gradient must vanish.
    fn is_inside(self, x: [f64; N]) -> bool;

    /// Returns the forbidden part of a gradient `g` at a point `x` of the set. The forbidden part is not an inward normal of a
    /// bound and must vanish at the minimum. Returns NaN if `g` is NaN.
    #[must_use]
    fn forbidden(self, x: [f64; N], g: [f64; N]) -> [f64; N];

    /// Returns `g.x` minus the least `g.y` over the points `y` of the set, or infinity if there is no least value.
    #[must_use]
    fn duality_gap(self, x: [f64; N], g: [f64; N]) -> f64;
    /// Returns the distance of a point from the set, or zero within round-off.
    fn excess(self, x: [f64; N]) -> f64;

    /// Returns the extreme point along a direction.
    fn extreme(self, direction: [f64; N]) -> [f64; N];

    /// Returns `x + d`, or the point of a bound if `x + d` reaches the bound up to round-off.
    fn arrive(self, x: [f64; N], d: [f64; N]) -> [f64; N];

    /// Returns the motion of a cell at `x` before its gradient has been computed.
    fn motion(self, x: [f64; N]) -> Self::CellMotion;

    /// Returns the motion with the curvature of the bound for a gradient `g`.
    #[inline]
    fn measured(self, motion: Self::CellMotion, _g: [f64; N]) -> Self::CellMotion {
        motion
    }

    /// Returns the next motion of the cell and its projected unknowns. `x` are the unknowns and `g` is the gradient from the
    /// solution of the linear system. A gradient of the wrong sign below `noise` is ignored. `weighing` determines the weight of
    /// the motion in the preconditioner. It contains the [compliance](crate::Operator::self_compliance) of a cell and the
    /// additional compliance of this cell.
    fn next(
        self,
        was: Self::CellMotion,
        x: [f64; N],
        g: [f64; N],
        noise: f64,
        weighing: [f64; 2],
    ) -> (Self::CellMotion, [f64; N]);

    /// Returns the position of prescribed sums, or an error if the sets cannot carry them.
    fn reach(
        layout: &Layout,
        constraint: &impl Constraint<N, Set = Self>,
        sums: [Option<f64>; N],
    ) -> Result<TotalFeasibility<N>>
    where
        Self: ConstraintSet<N>;

    /// Moves the values of the cells to the nearest points of their sets at which the prescribed sums are met. Moves only the
    /// cells of `preferred` if they suffice. If all cells [move](Row::IS_STEADY), also moves the cells inside their bounds.
    /// Otherwise moves all cells. Returns whether the cells keep their motion states.
    fn restore(
        layout: &Layout,
        x: [&mut [f64]; N],
        constraint: &impl Constraint<N, Set = Self>,
        preferred: impl Fn(usize) -> bool + Sync,
        sums: [Option<f64>; N],
    ) -> bool
    where
        Self: ConstraintSet<N>;
}
