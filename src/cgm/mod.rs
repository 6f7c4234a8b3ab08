//! The constrained minimum every contact problem is: the engine, which knows no physics.
//!
//! ```math
//! \min_x \; \tfrac12 x' C x + b' x
//! \quad\text{over}\quad x_i \in K_i,
//! \quad\text{optionally}\quad \textstyle\sum_i x_i = S .
//! ```
//!
//! `C` is an [`Operator`], symmetric and positive definite; `K_i` a [`Constraint`]; the multiplier
//! of the total is returned. For a normal contact `x` is the pressure, `b` the gap, `S` the load
//! over the cell area and the multiplier the approach; for a tangential one `x` is the traction
//! between its friction limits, and the multiplier the shift.
//!
//! Two methods stand behind one setting, see [`Method`]. Whatever the method and the outcome, the
//! iterate returned is feasible and the [`Report`] is computed from a fresh product with it; its
//! certified gap bounds the error in the energy norm (see [`Report::certified_gap`]).
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
//! the residual; the second is of second order. For an operator that does not know such a `lambda` the
//! first is all there is (infinite while an entry without an upper bound wants to grow), and an
//! iteration then stops on the residual alone.
//!
//! A total missed by round-off is reported by itself: `x*` is the minimum of the total `x` has. The same
//! `x*` is meant, whether or not a total is prescribed, where the operator maps constants to zero and
//! `lambda` bounds the other eigenvalues: `x - x*` then has sum zero. All of this holds up to the round-off
//! of the product.
//!
//! # Round-off
//!
//! A tolerance below what the product leaves ends as [`Status::Stalled`], with the certified error that was
//! reached. Measured with a tolerance of 1e-16, [`Report::energy_error_bound`] of the pressure, and of the traction in
//! the scalar and the plane model at 0.6 of the sliding force:
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
//! let problem = Problem::new(Identity::new(2), &[-2.0, 1.0], NonNegative);
//! let mut x = [0.0; 2];
//! let minimum = cgm::minimise(&problem, &Settings::default(), &mut x)?;
//! assert!((x[0] - 2.0).abs() < 1e-8 && x[1] == 0.0);
//! assert!(minimum.report.certified_gap < 1e-16);
//! # Ok::<(), stickslip::Error>(())
//! ```

mod active_set;
mod balance;
mod certificate;
mod constraint;
mod free_set;
mod inner;
pub(crate) mod plane;
mod polonsky_keer;
mod progress;
mod projected_gradient;
mod reduce;
mod run;
mod settings;
mod watch;

pub(crate) use certificate::{Certificate, examine};
pub use constraint::{Constraint, Interval, Magnitude, NonNegative};
pub(crate) use reduce::total as sum_of_chunks;
pub use settings::{Method, Settings};
pub(crate) use settings::{settings_methods, solver_settings};

pub use crate::report::{Iteration, Report, Status};

use std::ops::ControlFlow;

use crate::error::{Error, Result, all_finite, length};
use crate::operator::{Identity, Operator};
use crate::parallel;
use free_set::FreeSet;
use run::Run;

/// What to minimise: `1/2 x'Cx + b'x` over `x_i` in `K_i`, optionally with `sum x = S`.
#[derive(Debug, Clone)]
pub struct Problem<'a, C, K, P = Identity> {
    operator: C,
    preconditioner: P,
    linear: &'a [f64],
    constraint: K,
    total: Option<f64>,
}

impl<'a, C: Operator, K: Constraint> Problem<'a, C, K> {
    /// Operator `C`, linear term `b` and constraint `K`; no total prescribed, no preconditioner.
    pub fn new(operator: C, linear: &'a [f64], constraint: K) -> Self {
        let preconditioner = Identity::new(operator.cells());
        Self {
            operator,
            preconditioner,
            linear,
            constraint,
            total: None,
        }
    }
}

impl<'a, C: Operator, K: Constraint, P: Operator> Problem<'a, C, K, P> {
    /// With a prescribed total, `sum x = total`.
    #[must_use]
    pub fn total(mut self, total: f64) -> Self {
        self.total = Some(total);
        self
    }

    /// With an approximate inverse of `C`, symmetric and positive definite; only
    /// [`Method::ActiveSet`] uses it.
    #[must_use]
    pub fn preconditioner<Q: Operator>(self, preconditioner: Q) -> Problem<'a, C, K, Q> {
        Problem {
            operator: self.operator,
            preconditioner,
            linear: self.linear,
            constraint: self.constraint,
            total: self.total,
        }
    }

    /// Buffers for solving this problem and all of its size.
    #[must_use]
    pub fn workspace(&self) -> Workspace<C, P> {
        Workspace::new(&self.operator, &self.preconditioner)
    }

    fn check(&self, x: &[f64]) -> Result<()> {
        let len = self.operator.cells();
        length("preconditioner", len, self.preconditioner.cells())?;
        length("linear term", len, self.linear.len())?;
        length("start", len, x.len())?;
        all_finite("linear term", self.linear)?;
        all_finite("start", x)?;
        self.constraint.check(len)
    }
}

/// The answer beside `x` itself.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Minimum {
    /// Multiplier of the total, so that `C x + b - multiplier` vanishes on free entries; zero when
    /// no total is prescribed.
    pub multiplier: f64,
    /// Status, cost and certified error.
    pub report: Report,
}

/// Everything an iteration writes to besides `x`; made once, reused by every solve of one size.
#[derive(Debug, Clone)]
pub struct Workspace<C: Operator, P: Operator = Identity> {
    operator: C::Workspace,
    preconditioner: P::Workspace,
    product: Vec<f64>,
    gradient: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
    inner: Inner,
    free_set: FreeSet,
    state: Vec<State>,
    report: Report,
    multiplier: f64,
}

/// Vectors of the inner iteration, compressed to the free entries.
#[derive(Debug, Clone)]
struct Inner {
    residual: Vec<f64>,
    last_residual: Vec<f64>,
    correction: Vec<f64>,
    direction: Vec<f64>,
    /// How a change of the total spreads, `w = M e`.
    spread: Vec<f64>,
    /// Its sum.
    weight: f64,
}

/// Where an entry stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Free,
    Lower,
    Upper,
    /// Equal bounds: it never moves.
    Fixed,
}

impl<C: Operator, P: Operator> Workspace<C, P> {
    /// Buffers for an operator and its preconditioner: nine numbers per entry besides their own.
    #[must_use]
    pub fn new(operator: &C, preconditioner: &P) -> Self {
        let len = operator.cells();
        let zeros = || vec![0.0; len];
        Self {
            operator: operator.workspace(),
            preconditioner: preconditioner.workspace(),
            product: zeros(),
            gradient: zeros(),
            direction: zeros(),
            image: zeros(),
            inner: Inner {
                residual: zeros(),
                last_residual: zeros(),
                correction: zeros(),
                direction: zeros(),
                spread: zeros(),
                weight: 1.0,
            },
            free_set: FreeSet::with_capacity(len),
            state: vec![State::Fixed; len],
            report: Report::with_room(),
            multiplier: 0.0,
        }
    }

    /// The product `C x` with the iterate last returned.
    #[must_use]
    pub fn product(&self) -> &[f64] {
        &self.product
    }

    /// The report of the last solve, converged or not.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// The multiplier of the last solve, converged or not.
    #[must_use]
    pub fn multiplier(&self) -> f64 {
        self.multiplier
    }
}

/// Finds the minimum from the start `x` and leaves it in `x`.
///
/// # Errors
/// [`Error::Length`], [`Error::Sample`], [`Error::Bounds`], [`Error::Total`],
/// [`Error::Tolerance`] or [`Error::IterationLimit`] before any work, with `x` as it was;
/// [`Error::NotConverged`] with the last feasible iterate in `x`.
pub fn minimise<C: Operator, K: Constraint, P: Operator>(
    problem: &Problem<'_, C, K, P>,
    settings: &Settings,
    x: &mut [f64],
) -> Result<Minimum> {
    settings.check()?;
    // An operator may claim any number of unknowns; the start is there.
    problem.check(x)?;
    let mut workspace = problem.workspace();
    minimise_with(problem, settings, x, &mut workspace, &mut |_| {
        ControlFlow::Continue(())
    })?;
    Ok(Minimum {
        multiplier: workspace.multiplier,
        report: workspace.report,
    })
}

/// [`minimise`] with the caller's workspace, which also keeps the product, the multiplier and the
/// report, and with an observer: it sees every step and may cancel. Allocates nothing once the
/// workspace has seen a solve as long as this one.
///
/// # Errors
/// As [`minimise`].
pub fn minimise_with<C: Operator, K: Constraint, P: Operator>(
    problem: &Problem<'_, C, K, P>,
    settings: &Settings,
    x: &mut [f64],
    workspace: &mut Workspace<C, P>,
    observer: &mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send),
) -> Result<()> {
    settings.check()?;
    problem.check(x)?;
    length("workspace", x.len(), workspace.product.len())?;
    let solve = || -> Result<Status> {
        let reach = match problem.total {
            Some(total) => Some(balance::reach(x.len(), &problem.constraint, total)?),
            None => None,
        };
        let mut run = Run::new(problem, settings, x, workspace, observer);
        let status = match (run.multiplier_at_zero(), reach) {
            (Some(multiplier), _) => run.at_zero(multiplier),
            (None, Some(balance::Reach::AtLower)) => run.at_extreme(State::Lower),
            (None, Some(balance::Reach::AtUpper)) => run.at_extreme(State::Upper),
            (None, Some(balance::Reach::Inside) | None) => iterate(&mut run),
        };
        Ok(run.finish(status))
    };
    let status = parallel::enter(solve)?;
    if status == Status::Converged {
        Ok(())
    } else {
        Err(Error::NotConverged(Box::new(workspace.report.clone())))
    }
}

/// The chosen method; each time its sets cycle, twice as many steps of a method that has none, until
/// that does not help any more.
fn iterate<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>) -> Status {
    let (mut detour, mut in_vain) = (32, 0);
    loop {
        let before = run.watch.best;
        let ended = match run.watch.settings.method {
            Method::ActiveSet => active_set::iterate(run),
            Method::PolonskyKeer => polonsky_keer::iterate(run),
        };
        if let Some(status) = ended {
            return status;
        }
        in_vain = if run.watch.best < 0.5 * before {
            0
        } else {
            in_vain + 1
        };
        if in_vain > DETOURS_IN_VAIN {
            return Status::Stalled;
        }
        match projected_gradient::iterate(run, detour) {
            ControlFlow::Break(status) => return status,
            // The objective no longer falls: one look by the method, and that is all.
            ControlFlow::Continue(true) => in_vain = DETOURS_IN_VAIN,
            ControlFlow::Continue(false) => {}
        }
        detour = (2 * detour).min(run.watch.settings.max_iterations);
    }
}

/// Detours after which the residual was not halved before the iteration counts as stalled.
const DETOURS_IN_VAIN: usize = 6;
