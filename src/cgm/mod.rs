//! The constrained minimiser behind every contact problem: one solver for any number of unknowns per cell.
//! ```math
//! \min_x \; \tfrac12 x' C x + b' x
//! \quad\text{over}\quad x_i \in K_i,
//! \quad\text{optionally}\quad \textstyle\sum_i x_i = S .
//! ```
//!
//! Each cell `i` has `N` unknowns. `C` is a positive definite [`Operator`](crate::Operator). It is symmetric unless it [reports
//! otherwise](crate::Operator::is_symmetric). `K_i` is the set that a [`Constraint`] assigns to the cell: an [`Interval`] for one
//! unknown, a [`Disc`] for two. A [`Total`] prescribes the sum of a component or ties it to a spring. The solver returns the
//! multiplier of the total. For a normal contact, `x` is the pressure, `b` is the gap, and the multiplier is the approach. `S` is
//! then the load divided by the area of a cell. For a tangential contact, `x` is the traction, which friction limits along one
//! axis or in the plane. The multiplier is then the shift. Vectors are arrays of one slice per component. A
//! [diagonal](Problem::diagonal) `D`, an additional compliance of the cells, may be added to `C`. The following statements then
//! hold for `C + D`.
//!
//! The solver is a semismooth Newton method. The sets determine how each cell may move. Conjugate gradients solve the linear
//! problem of the moving cells, bordered by the totals. Then the sets are updated. For intervals this is a primal-dual active-set
//! method. For discs the linear problem contains the curvature of the circles. If the sets cycle, projected-gradient steps move
//! the iterate away from the cycle. If the sets still cycle, proximal-point steps, a sequence of better conditioned problems,
//! lead to the minimum. Without symmetry there is no objective, but the optimality conditions are the same. GMRES then replaces
//! conjugate gradients.
//!
//! [`Method`] selects the iteration. For every method and outcome, the returned iterate is feasible and the
//! [`Report`](crate::Report) is recomputed from a product with it. The duality gap in the report bounds the error in the energy
//! norm (see [`Report::duality_gap`](crate::Report::duality_gap)).
//!
//! # The certified error
//!
//! Let `x` be feasible with gradient `g = C x + b - delta`. If a total is prescribed, the multiplier may be any number. Let `x*`
//! be the minimiser and `E^2 = (x - x*)' C (x - x*)`. The scalar product of the gradient at the minimiser with `x - x*` is not
//! negative. The two gradients differ by `C (x - x*)`. Therefore
//!
//! ```math
//! E^2 \le g' (x - x^*) .
//! ```
//!
//! The contribution of each entry to the right-hand side is bounded in one of two ways. The first bound is its duality gap
//! `a_i = g_i x_i - min over y_i of g_i y_i`. The second bound uses a lower bound `lambda` of the eigenvalues of `C`:
//! `sum r_i (x - x*)_i <= |r| E / sqrt(lambda)`. Here `r_i` is the part of `g_i` that complementarity does not allow. Let `A` be
//! the sum of the first bounds and `B = |r| / sqrt(lambda)`. Then `E^2 <= A + B E`, hence
//!
//! ```math
//! E \le B/2 + \sqrt{B^2/4 + A} .
//! ```
//!
//! The first bound is the Frank-Wolfe gap (<https://doi.org/10.1002/nav.3800030109>) and is of first order in the residual. The
//! second bound is of second order. Only the first bound is available for an operator that does not provide `lambda`. This bound
//! is infinite while a cell without an upper bound has a gradient that would increase its unknown. An iteration with such an
//! operator uses only the residual as its stopping criterion.
//!
//! A spring of compliance `c` adds the term `c (sum x)^2 / 2` to the objective. It adds the term `c (sum (x - x*))^2 >= 0` to
//! `E^2`. Its multiplier follows the sum, `delta = X - c sum x`. Thus `g` is the gradient of the whole objective. The bound also
//! holds for the energy norm of `C` without the spring. In `B`, the mean of `r` over the `n` cells is then divided by `n c`
//! instead of `lambda` if `n c` is larger. It is also divided by `n c` if the operator maps constants to zero, because only the
//! spring then resists the mean. Residuals are relative to the largest displacement or, if larger, to the product of the least
//! spring compliance and `sum |x|`.
//!
//! A deviation of a total due to round-off is reported separately: here `x*` is the minimiser for the total of `x`. If the
//! operator maps constants to zero, `lambda` bounds the other eigenvalues. In this case `x*` is the minimiser for the total of
//! `x` even if no total is prescribed. Therefore `x - x*` has sum zero. Such an operator belongs to a periodic grid. Under a
//! prescribed approach the bound is then relative to the contact under the computed force, and excludes the error of this force.
//! An example is a bowl at 0.999 of the mean gap, on 64 x 64 cells with a tolerance of 1e-2. The bound is 0.9 %, and the error of
//! the force is 3.8 %.
//!
//! All these statements hold up to the round-off of the product.
//!
//! # Round-off
//!
//! An iteration with a tolerance below the round-off of the product ends with [`Status::Stalled`](crate::Status::Stalled) and
//! reports the certified error that was reached. The table lists
//! [`Report::energy_error_bound`](crate::Report::energy_error_bound) for a tolerance of 1e-16. The first of the three values is
//! the bound for the pressure. The others are the bounds for the traction in the scalar and in the vector model at 0.6 of the
//! sliding force.
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
//! The error of the first two surfaces grows approximately as the square root of the number of cells along a side. The error
//! bound from the residual and the smallest eigenvalue grows in the same way. In the vector model, the motion under a force
//! within 1e-7 of sliding depends on the last digits of the force. A few of these solves stall much earlier.
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
pub(crate) use law::state::{LinearisedSet, Row};
pub use law::{AbsBound, Ball, Bounds, Constraint, ConstraintSet, NonNegative, NormBound};
pub(crate) use law::{BoundedPressure, UNLIMITED};
pub(crate) use linear::{FixedSetSystem, LinearWorkspace, SparseFactors, SparseInverse};
pub(crate) use problem::minimise_from;
pub use problem::{Minimum, Problem, minimise, minimise_with};
pub(crate) use settings::settings_methods;
pub use settings::{Method, Settings};
pub(crate) use start::InitialGuess;
pub use totals::Total;
pub use workspace::Workspace;

/// Type of the motion of a cell under a constraint.
pub(crate) type MotionOf<K, const N: usize> =
    <<K as Constraint<N>>::Set as LinearisedSet<N>>::CellMotion;
