//! The constrained minimum behind every contact problem: one engine for any number of unknowns a cell.
//!
//! ```math
//! \min_x \; \tfrac12 x' C x + b' x
//! \quad\text{over}\quad x_i \in K_i,
//! \quad\text{optionally}\quad \textstyle\sum_i x_i = S .
//! ```
//!
//! Each cell `i` has `N` unknowns. `C` is an [`Operator`](crate::Operator), positive definite, and symmetric but where it
//! [says otherwise](crate::Operator::is_symmetric); `K_i` is
//! the set that a [`Constraint`] gives the cell, an [`Interval`] for one unknown or a [`Disc`] for two. A [`Total`]
//! prescribes the sum of a component, or ties it to a spring; its multiplier is returned. For a normal contact `x` is
//! the pressure, `b` the gap, `S` the load over the cell area and the multiplier the approach; for a tangential one `x`
//! is the traction within its friction limit, along one axis or in the plane, and the multiplier the shift. Vectors are
//! arrays of one slice a component. To `C` a [diagonal](Problem::diagonal) `D` may be added, a compliance that cells have of
//! their own; what follows then holds of `C + D`.
//!
//! The solver is Newton's method on the law of every cell: the sets decide how each cell may move, conjugate gradients
//! solve the linear problem of the cells that move, bordered by the totals, and then the sets are decided again. For
//! intervals that is an active-set method; for discs the linear problem contains the curvature of the circles. If the
//! sets cycle, projected gradients lead past that place; if they still do, better conditioned problems lead to the
//! minimum. Without symmetry there is no minimum, but the conditions are the same: GMRES takes the place of conjugate
//! gradients.
//!
//! [`Method`] selects the iteration. Whatever the method and the outcome, the iterate returned is feasible and the
//! [`Report`] is recomputed from a product with it; its duality gap bounds the error in the energy norm (see
//! [`Report::duality_gap`]).
//!
//! # The certified error
//!
//! Let `x` be feasible with gradient `g = C x + b - delta` (the multiplier may be any number when a
//! total is prescribed), `x*` the minimum and `E^2 = (x - x*)' C (x - x*)`. Because the gradient at
//! the minimum has a non-negative product with `x - x*`, and the two gradients differ by
//! `C (x - x*)`,
//!
//! ```math
//! E^2 \le g' (x - x^*) .
//! ```
//!
//! Each entry's share of the right side is bounded in one of two ways: by its duality gap
//! `a_i = g_i x_i - min over y_i of g_i y_i`, or, with a lower bound `lambda` of the eigenvalues of
//! `C`, through `sum r_i (x - x*)_i <= |r| E / sqrt(lambda)`, where `r_i` is the part of `g_i` that
//! complementarity does not allow. With `A` the sum of the first and `B = |r| / sqrt(lambda)`,
//! `E^2 <= A + B E`, hence
//!
//! ```math
//! E \le B/2 + \sqrt{B^2/4 + A} .
//! ```
//!
//! The first is the Frank-Wolfe gap (<https://doi.org/10.1002/nav.3800030109>), of first order in
//! the residual; the second is of second order. For an operator that does not know such a `lambda` only the
//! first is available (infinite while a cell without an upper bound wants to grow), and an
//! iteration then stops on the residual alone.
//!
//! A spring of compliance `c` adds `c (sum x)^2 / 2` to the objective and `c (sum (x - x*))^2 >= 0` to `E^2`. Its
//! multiplier follows the sum, `delta = X - c sum x`, so that `g` is the gradient of the whole objective and the bound
//! holds for the energy norm of `C` alone too. In `B`, the mean of `r` over the `n` cells is then divided by `n c`
//! instead of `lambda`: if `n c` is more, or if the operator maps constants to zero and only the spring resists the mean.
//! Residuals are then relative to the largest displacement, or to the stretch of the stiffest spring if all unknowns
//! pulled one way, if that is more.
//!
//! A total missed by round-off is reported separately: `x*` is the minimum of the total `x` has. The same
//! `x*` is meant, whether or not a total is prescribed, where the operator maps constants to zero and
//! `lambda` bounds the other eigenvalues: `x - x*` then has sum zero. All of this holds up to the round-off
//! of the product.
//!
//! # Round-off
//!
//! A tolerance below what the product leaves ends as [`Status::Stalled`], with the certified error that was
//! reached. Measured with a tolerance of 1e-16, [`Report::energy_error_bound`] of the pressure, and of the traction in
//! the scalar and the vector model at 0.6 of the sliding force:
//!
//! | cells | sphere | rough surface | flat on flat |
//! |--:|---|---|---|
//! | 32 x 32 | 2.3e-15, 0.7e-15, 0.7e-15 | 0.7e-15, 0.1e-15, 0.3e-15 | 3.7e-14, 6.6e-14, 3.3e-14 |
//! | 64 x 64 | 2.3e-15, 2.3e-15, 1.8e-15 | 1.4e-15, 0.4e-15, 0.2e-15 | 2.7e-13, 2.2e-13, 1.9e-13 |
//! | 128 x 128 | 6.2e-15, 3.3e-15, 4.5e-15 | 1.7e-15, 0.9e-15, 0.6e-15 | 9.1e-14, 4.3e-13, 2.0e-13 |
//! | 256 x 256 | 8.6e-15, 2.4e-15, 4.0e-15 | 1.8e-15, 1.2e-15, 1.2e-15 | 8.3e-13, 0.9e-13, 1.4e-13 |
//! | 512 x 512 | 1.1e-14, 3.3e-15, 6.5e-15 | 3.6e-15, 1.1e-15, 0.8e-15 | 8.5e-13, 0.3e-13, 4.4e-13 |
//! | 1024 x 1024 | 1.2e-14, 5.7e-15, 4.7e-15 | 4.6e-15, 2.7e-15, 1.1e-15 | not measured |
//!
//! That of the first two grows about as the root of the cells along a side, as what the smallest eigenvalue makes
//! of the residual. In the plane, a force within 1e-7 of sliding may stall much earlier on some scenes, where the
//! last digits of the force decide on the motion.
//!
//! # Example
//!
//! ```
//! use stickslip::cgm::{self, NonNegative, Problem, Settings};
//! use stickslip::{Identity, Operator};
//!
//! // The point of the first quadrant nearest to (2, -1): C = 1, b = -(2, -1).
//! let problem = Problem::new(Identity::new(2), [&[-2.0, 1.0]], NonNegative);
//! let mut x = [0.0; 2];
//! let minimum = cgm::minimise(&problem, &Settings::default(), [&mut x])?;
//! assert!((x[0] - 2.0).abs() < 1e-8 && x[1] == 0.0);
//! assert!(minimum.report.duality_gap < 1e-16);
//! # Ok::<(), stickslip::Error>(())
//! ```

mod active_set_solve;
mod certificate;
#[cfg(feature = "history")]
pub(crate) mod cone;
mod degenerate;
mod diagonal;
mod free_cells;
mod law;
mod linear;
mod monitor;
mod newton;
mod polonsky_keer;
mod problem;
mod safeguard;
mod settings;
mod start;
mod totals;
mod workspace;

pub(crate) use crate::parallel::reduce;
pub(crate) use certificate::{Certificate, Iterate, examine};
pub(crate) use diagonal::CellCompliance;
#[cfg(feature = "dense")]
pub(crate) use law::check as check_constraint;
pub use law::disc::Disc;
pub use law::interval::Interval;
pub(crate) use law::state::{CellMotion, LinearisedSet, Row};
pub use law::{AbsBound, Ball, Bounds, Constraint, ConstraintSet, NonNegative, NormBound};
pub(crate) use law::{BoundedPressure, UNLIMITED};
pub(crate) use linear::{FixedSetSystem, LinearWorkspace};
pub(crate) use problem::minimise_from;
pub use problem::{Minimum, Problem, minimise, minimise_with};
pub use settings::{Method, Settings};
pub(crate) use settings::{settings_methods, solver_settings};
pub(crate) use start::InitialGuess;
pub use totals::Total;
pub use workspace::Workspace;

pub use crate::report::{Iteration, Report, Status};

/// How a cell of a constraint may move.
pub(crate) type MotionOf<K, const N: usize> =
    <<K as Constraint<N>>::Set as LinearisedSet<N>>::CellMotion;
