//! How a cell may move at a state of its set, and what the engine asks of each kind of set.
//!
//! Newton's method linearises the law of every cell: a cell that cannot move leaves the linear system, one inside
//! its set moves freely, and one on a curved bound moves along the tangent, against the curvature of the bound.

use crate::cgm::active_set_solve::ActiveSetSolve;
use crate::cgm::{Constraint, ConstraintSet};
use crate::error::Result;
use crate::parallel::layout::Layout;
use crate::report::Status;

/// How the unknowns of one cell enter the linear problem of an outer step.
///
/// A change `v` of the unknowns changes the tractions by [`extend`](Self::extend), and of the displacements `w` that
/// follow the cell has the equations [`restrict`](Self::restrict). Where the problem is the condition of a minimum one is
/// the transpose of the other.
#[expect(
    unnameable_types,
    reason = "it appears in the sealed traits of the sets alone"
)]
pub trait Row<const N: usize>: Copy + std::fmt::Debug + Send + Sync + 'static {
    /// Whether a cell that can move may move in less than all directions.
    const IS_CURVED: bool;
    /// Whether the same cells move from start to end: those whose set has more than a point.
    const IS_STEADY: bool;
    /// Whether a cell may displace itself.
    const HAS_LAG: bool = false;
    /// In any direction.
    const FREE: Self;
    /// Not at all.
    const FIXED: Self;

    /// Whether the cell takes part in the linear system.
    fn moves(self) -> bool;

    /// Whether the cell moves in any direction.
    fn is_free(self) -> bool;

    /// The change of the tractions that a change of the unknowns makes.
    fn extend(self, v: [f64; N]) -> [f64; N];

    /// The equations of the cell, from displacements.
    fn restrict(self, w: [f64; N]) -> [f64; N];

    /// What the curvature of a bound adds to the equations at a change of the unknowns.
    fn bend(self, v: [f64; N]) -> [f64; N];

    /// How far the cell is displaced, beside what the operator displaces it, by a change `d` of its tractions.
    fn lag(self, _d: [f64; N]) -> [f64; N] {
        [0.0; N]
    }

    /// The tractions that go to the inverse operator for a residual.
    fn weighted(self, r: [f64; N]) -> [f64; N];

    /// The preconditioned residual, with the `answer` of the inverse operator.
    fn preconditioned(self, answer: [f64; N], r: [f64; N]) -> [f64; N];
}

/// How one cell of a set may move.
#[expect(
    unnameable_types,
    reason = "it appears in the sealed traits of the sets alone"
)]
pub trait CellMotion<const N: usize>: Row<N> {
    /// With the stiffness in force known to the preconditioner, beside an operator of this
    /// [compliance](crate::Operator::self_compliance) of a cell and what the cell has of its own.
    #[must_use]
    fn with_preconditioner_weight(self, self_compliance: f64, diagonal: f64) -> Self;

    /// A cell that has to move although its bound holds it, if a gradient `g` pushes it from there.
    #[must_use]
    fn released_from_bound(self, g: [f64; N]) -> Self;
}

/// Where prescribed sums lie in what the sets allow together.
#[expect(
    unnameable_types,
    reason = "it appears in the sealed traits of the sets alone"
)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TotalFeasibility<const N: usize> {
    /// Strictly between the extremes: multipliers exist.
    Inside,
    /// Every cell at the extreme point of its set along this direction.
    Extreme([f64; N]),
}

/// What the engine asks of a kind of set, beside what [`ConstraintSet`] says of it.
#[expect(
    unnameable_types,
    reason = "it appears in the sealed traits of the sets alone"
)]
pub trait LinearisedSet<const N: usize>: Copy + std::fmt::Debug + Send + Sync + 'static {
    /// How a cell of this set may move.
    type CellMotion: CellMotion<N>;
    /// Whether [`Method::PolonskyKeer`](crate::cgm::Method::PolonskyKeer) is defined for it.
    const HAS_SINGLE_LOOP: bool;

    /// `Ok` if the set has a point.
    fn check(self, cell: usize) -> Result<()>;

    /// Whether the set has more than one point.
    fn can_move(self) -> bool;

    /// Whether a point is inside its bounds, where the whole gradient must vanish.
    fn is_inside(self, x: [f64; N]) -> bool;

    /// The part of a gradient `g` at a point `x` of the set that is not the inward normal of a bound: what
    /// must vanish at the minimum. NaN if `g` is.
    #[must_use]
    fn forbidden(self, x: [f64; N], g: [f64; N]) -> [f64; N];

    /// `g.x` less the least `g.y` over the points `y` of the set; infinite if there is no least.
    #[must_use]
    fn duality_gap(self, x: [f64; N], g: [f64; N]) -> f64;
    /// How far a point lies outside, by more than round-off.
    fn excess(self, x: [f64; N]) -> f64;

    /// The extreme point along a direction.
    fn extreme(self, direction: [f64; N]) -> [f64; N];

    /// `x + d`, exactly on a bound that it reaches up to round-off.
    fn arrive(self, x: [f64; N], d: [f64; N]) -> [f64; N];

    /// How a cell at `x` may move before anything is known of its gradient.
    fn motion(self, x: [f64; N]) -> Self::CellMotion;

    /// With the curvature that a gradient `g` gives the bound.
    fn measured(self, motion: Self::CellMotion, g: [f64; N]) -> Self::CellMotion;

    /// How the cell moves next, and where it stands, after the linear system has left it at `x` with the gradient
    /// `g`; a gradient of the wrong sign below `noise` is not taken for one. Its weight depends on the
    /// [compliance](crate::Operator::self_compliance) of a cell and on what the cell has of its own, `weighing`.
    fn next(
        self,
        was: Self::CellMotion,
        x: [f64; N],
        g: [f64; N],
        noise: f64,
        weighing: [f64; 2],
    ) -> (Self::CellMotion, [f64; N]);

    /// Where prescribed sums lie, or an error if the sets cannot hold them.
    fn reach(
        layout: &Layout,
        constraint: &impl Constraint<N, Set = Self>,
        sums: [Option<f64>; N],
    ) -> Result<TotalFeasibility<N>>
    where
        Self: ConstraintSet<N>;

    /// Moves the cells within their sets to the nearest points that have the sums: those of `preferred`, and where
    /// all cells [move](Row::IS_STEADY) those inside their bounds, alone if they suffice. Says whether the cells keep
    /// the way they move.
    fn restore(
        layout: &Layout,
        x: [&mut [f64]; N],
        constraint: &impl Constraint<N, Set = Self>,
        preferred: impl Fn(usize) -> bool + Sync,
        sums: [Option<f64>; N],
    ) -> bool
    where
        Self: ConstraintSet<N>;

    /// The iteration of [`Method::PolonskyKeer`](crate::cgm::Method::PolonskyKeer): ends with the status of the run,
    /// or `None` if the sets cycle.
    fn single_loop<K: Constraint<N, Set = Self>>(
        run: &mut ActiveSetSolve<'_, '_, K, N>,
    ) -> Option<Status>
    where
        Self: ConstraintSet<N>;
}
