//! What to minimise, and the one loop that does.

use std::ops::ControlFlow;

use crate::cgm::active_set_solve::ActiveSetSolve;
use crate::cgm::certificate::Iterate;
use crate::cgm::diagonal::CellCompliance;
use crate::cgm::law::state::{LinearisedSet, TotalFeasibility};
use crate::cgm::newton::newton;
use crate::cgm::safeguard::projected_gradient::Objective;
use crate::cgm::totals::Total;
use crate::cgm::{Constraint, InitialGuess, Method, Settings, Workspace, law};
use crate::error::{Error, Result, all_finite, all_non_negative, finite, length, positive};
use crate::numerics::cell_vector::{at, minus};
use crate::observer::Observer;
use crate::operator::{Identity, LowerBound, MeanBound, Operator};
use crate::parallel;
use crate::parallel::layout::Layout;
use crate::report::{Iteration, Report, Status};

/// What to minimise: `1/2 x'(C + D)x + b'x` over `x_i` in `K_i`, optionally with totals of the components.
#[derive(Debug, Clone)]
pub struct Problem<'a, C, K, P = Identity, const N: usize = 1> {
    pub(super) operator: C,
    pub(super) preconditioner: P,
    pub(super) layout: Layout,
    /// Compliance that cells have of their own.
    pub(super) own: CellCompliance<'a>,
    linear: [&'a [f64]; N],
    datum: [f64; N],
    pub(super) constraint: K,
    pub(super) totals: [Total; N],
    pub(super) is_examined_elsewhere: bool,
}

impl<'a, C: Operator<N>, K: Constraint<N>, const N: usize> Problem<'a, C, K, Identity, N> {
    /// Operator `C`, linear term `b`, component by component, and constraint `K`; no total prescribed, no
    /// preconditioner.
    pub fn new(operator: C, linear: [&'a [f64]; N], constraint: K) -> Self {
        let preconditioner = Identity::new(operator.cells());
        Self {
            layout: operator.layout(),
            operator,
            preconditioner,
            own: CellCompliance::default(),
            linear,
            datum: [0.0; N],
            constraint,
            totals: [Total::Free; N],
            is_examined_elsewhere: false,
        }
    }
}

impl<'a, C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize> Problem<'a, C, K, P, N> {
    /// With the totals of the components (default: free).
    #[must_use]
    pub fn totals(mut self, totals: [Total; N]) -> Self {
        self.totals = totals;
        self
    }

    /// With a compliance of its own added to each cell, `C + D` in place of `C`: a number that is not negative for all
    /// components of the cell (default: none, as an empty slice is). [`Workspace::product`] stays that of `C`.
    ///
    /// ```
    /// use stickslip::cgm::{self, NonNegative, Problem, Settings};
    /// use stickslip::Identity;
    ///
    /// // Two springs pressed by 1, one of them in series with another that is three times as soft.
    /// let (linear, own) = ([-1.0; 2], [0.0, 3.0]);
    /// let problem = Problem::new(Identity::new(2), [&linear], NonNegative).diagonal(&own);
    /// let mut x = [0.0; 2];
    /// cgm::minimise(&problem, &Settings::default(), [&mut x])?;
    /// assert!((x[0] - 1.0).abs() < 1e-8 && (x[1] - 0.25).abs() < 1e-8);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    #[must_use]
    pub fn diagonal(self, diagonal: &'a [f64]) -> Self {
        self.own(CellCompliance::isotropic(diagonal))
    }

    /// With a symmetric tensor added to each cell that is not negative in any direction.
    pub(crate) fn own(mut self, own: CellCompliance<'a>) -> Self {
        self.own = own;
        self
    }

    /// With each component of the linear term measured from a number, which is taken from it.
    pub(crate) fn datum(mut self, datum: [f64; N]) -> Self {
        self.datum = datum;
        self
    }

    /// Marks a problem whose answer is only a start, or is examined by the caller with an exact product. It may then be
    /// judged by a product that is wrong by a small part of the tolerance; report and kept product are as accurate as
    /// that, and certify nothing.
    pub(crate) fn verified_by_caller(mut self) -> Self {
        self.is_examined_elsewhere = true;
        self
    }

    /// With the layout of the operator, also of ranks that all solve the same.
    pub(crate) fn layout(mut self, layout: &Layout) -> Self {
        self.layout.clone_from(layout);
        self
    }

    /// With an approximate inverse of `C`, symmetric and positive definite; only
    /// [`Method::ActiveSet`] uses it.
    #[must_use]
    pub fn preconditioner<Q: Operator<N>>(self, preconditioner: Q) -> Problem<'a, C, K, Q, N> {
        Problem {
            operator: self.operator,
            preconditioner,
            layout: self.layout,
            own: self.own,
            linear: self.linear,
            datum: self.datum,
            constraint: self.constraint,
            totals: self.totals,
            is_examined_elsewhere: self.is_examined_elsewhere,
        }
    }

    /// Creates the buffers for solving this problem, or others of its size and kind of set.
    ///
    /// # Errors
    /// [`Error::Memory`] if there is not enough of it.
    pub fn workspace(&self) -> Result<Workspace<K::Set, N>> {
        Workspace::new(&self.operator, &self.preconditioner)
    }

    /// The problem without the types of its operators.
    pub(crate) fn posed(&self) -> Posed<'_, K, N> {
        Posed {
            operator: &self.operator,
            preconditioner: &self.preconditioner,
            layout: &self.layout,
            own: self.own,
            linear: self.linear,
            datum: self.datum,
            constraint: &self.constraint,
            totals: self.totals,
            lower_bound: LowerBound {
                // A bound that is not a number, or negative, says nothing.
                value: self.operator.lower_bound().max(0.0),
                known: self.operator.eigenvalue_bound(),
                mean: MeanBound::Operator,
            },
            is_examined_elsewhere: self.is_examined_elsewhere,
        }
    }

    /// Compliance that the totals add to uniform unknowns; `None` where the sum is prescribed.
    pub(crate) fn uniform_compliance(&self) -> [Option<f64>; N] {
        let cells = self.layout.of_all_ranks();
        self.totals.map(|total| total.uniform_compliance(cells))
    }
}

/// A problem as the iterations take it: they are compiled once for each constraint, not for each operator.
pub(crate) struct Posed<'a, K, const N: usize> {
    pub(super) operator: &'a dyn Operator<N>,
    pub(super) preconditioner: &'a dyn Operator<N>,
    pub(super) layout: &'a Layout,
    /// Compliance that cells have of their own.
    pub(super) own: CellCompliance<'a>,
    linear: [&'a [f64]; N],
    datum: [f64; N],
    pub(super) constraint: &'a K,
    pub(super) totals: [Total; N],
    /// Bound of the eigenvalues for the unknowns that the totals allow.
    pub(super) lower_bound: LowerBound,
    pub(super) is_examined_elsewhere: bool,
}

impl<'a, K: Constraint<N>, const N: usize> Posed<'a, K, N> {
    /// With a lower bound of the eigenvalues of the unknowns that the totals allow (default: the bound of the operator).
    pub(crate) fn bounded(self, lower_bound: LowerBound) -> Self {
        Self {
            lower_bound,
            ..self
        }
    }

    /// The linear term of a cell.
    pub(super) fn linear(&self, cell: usize) -> [f64; N] {
        minus(at(&self.linear, cell), self.datum)
    }

    /// An iterate to examine, with its product and multipliers.
    pub(super) fn iterate<'b>(
        &self,
        x: [&'b [f64]; N],
        product: [&'b [f64]; N],
        multiplier: [f64; N],
    ) -> Iterate<'b, N>
    where
        'a: 'b,
    {
        Iterate {
            layout: self.layout,
            x,
            product,
            linear: self.linear,
            datum: self.datum,
            totals: self.totals,
            multiplier,
        }
    }

    fn check(&self, settings: &Settings, x: &[&mut [f64]; N]) -> Result<()> {
        settings.check()?;
        if settings.method == Method::PolonskyKeer {
            self.check_single_loop()?;
        }
        let cells = self.operator.cells();
        length("preconditioner", cells, self.preconditioner.cells())?;
        let (diagonal, deviator) = self.own.parts();
        if !diagonal.is_empty() {
            length("diagonal", cells, diagonal.len())?;
            all_non_negative("diagonal", diagonal)?;
        }
        if !deviator.is_empty() {
            length("diagonal", cells, deviator.len())?;
            all_finite("diagonal", deviator.as_flattened())?;
        }
        for linear in self.linear {
            length("linear term", cells, linear.len())?;
            all_finite("linear term", linear)?;
        }
        for x in x {
            length("start", cells, x.len())?;
            all_finite("start", x)?;
        }
        for total in self.totals {
            if let Total::Spring {
                far_end,
                compliance,
            } = total
            {
                finite("far end of a spring", far_end)?;
                positive("compliance of a spring", compliance)?;
            }
        }
        law::check(self.constraint, cells)
    }

    /// The single loop solves symmetric problems of intervals without springs.
    fn check_single_loop(&self) -> Result<()> {
        let has_spring = self.totals.iter().any(|total| total.is_spring());
        let quantity = if has_spring {
            "springs"
        } else if !K::Set::HAS_SINGLE_LOOP {
            "several components a cell"
        } else if !self.operator.is_symmetric() {
            "operators that are not symmetric"
        } else {
            return Ok(());
        };
        Err(Error::Method {
            method: "PolonskyKeer",
            quantity,
        })
    }
}

impl<C: Operator, K: Constraint, P: Operator> Problem<'_, C, K, P> {
    /// With a prescribed total of the one component, `sum x = total`.
    #[must_use]
    pub fn total(self, total: f64) -> Self {
        self.totals([Total::Sum(total)])
    }
}

/// The answer beside `x` itself.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Minimum<const N: usize = 1> {
    /// Multipliers of the totals, so that `C x + b - multiplier` vanishes on free cells; zero where no total is
    /// prescribed.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::array"))]
    pub multiplier: [f64; N],
    /// Status, cost and certified error.
    pub report: Report,
}

/// Finds the minimum from the start `x` and leaves it in `x`.
///
/// # Errors
/// [`Error::Length`], [`Error::Sample`], [`Error::Bounds`], [`Error::NegativeOrNotFinite`], [`Error::Total`] or
/// [`Error::BeyondFrictionCapacity`] for sums the sets cannot hold, [`Error::NotPositive`] or [`Error::NotFinite`] for
/// a spring, [`Error::Method`] for a method that does not work with the sets, [`Error::Tolerance`] or
/// [`Error::IterationLimit`] before any work, with `x` as it was; [`Error::NotConverged`] with the last feasible
/// iterate in `x`; [`Error::NotPositive`] in its place if a preconditioner that is not positive definite is the cause;
/// [`Error::Memory`].
pub fn minimise<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    problem: &Problem<'_, C, K, P, N>,
    settings: &Settings,
    x: [&mut [f64]; N],
) -> Result<Minimum<N>> {
    // An operator may claim any number of unknowns; the start is there.
    problem.posed().check(settings, &x)?;
    let mut workspace = problem.workspace()?;
    minimise_with(problem, settings, x, &mut workspace, &mut |_| {
        ControlFlow::Continue(())
    })?;
    Ok(Minimum {
        multiplier: workspace.multiplier,
        report: workspace.linear.report,
    })
}

/// [`minimise`] with the caller's workspace, which also keeps the product, the multiplier and the
/// report, and with an observer: it sees every step and may cancel. Allocates nothing once the
/// workspace has seen a solve as long as this one.
///
/// # Errors
/// As [`minimise`].
pub fn minimise_with<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    problem: &Problem<'_, C, K, P, N>,
    settings: &Settings,
    x: [&mut [f64]; N],
    workspace: &mut Workspace<K::Set, N>,
    observer: &mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send),
) -> Result<()> {
    minimise_from(
        &problem.posed(),
        settings,
        x,
        InitialGuess::Nothing,
        workspace,
        observer,
    )
}

/// [`minimise_with`] from a start of which something is known.
pub(crate) fn minimise_from<K: Constraint<N>, const N: usize>(
    problem: &Posed<'_, K, N>,
    settings: &Settings,
    x: [&mut [f64]; N],
    known: InitialGuess<N>,
    workspace: &mut Workspace<K::Set, N>,
    observer: Observer<'_>,
) -> Result<()> {
    let cells = x[0].len();
    let checked = problem.check(settings, &x);
    let checked = checked.and_then(|()| length("workspace", cells, workspace.linear.rows.len()));
    problem.layout.collective_result(checked)?;
    let solve = || -> Result<Status> {
        let sums = problem.totals.map(Total::sum);
        let reach = K::Set::reach(problem.layout, problem.constraint, sums)?;
        let mut run = ActiveSetSolve::new(problem, settings, x, workspace, observer);
        run.find_bound_of_mean();
        let status = match (run.multiplier_at_zero(), reach) {
            (Some(multiplier), _) => run.at_zero(multiplier),
            (None, TotalFeasibility::Extreme(direction)) => run.at_extreme(direction),
            (None, TotalFeasibility::Inside) => match run.verify_start(known) {
                Some(status) => {
                    run.add_diagonal(-1.0);
                    return Ok(status);
                }
                None => iterate(&mut run),
            },
        };
        let status = run.finish(status);
        // The product that is kept is that of the operator alone.
        run.add_diagonal(-1.0);
        if let Some(allocation_error) = run.monitor.allocation_error.take() {
            return Err(allocation_error);
        }
        let has_failed = matches!(status, Status::Stalled | Status::IterationLimit);
        if has_failed && settings.method == Method::ActiveSet {
            run.check_preconditioner()?;
        }
        Ok(status)
    };
    let status = parallel::enter_with(cells, solve)?;
    problem.layout.check()?;
    if status == Status::Converged {
        Ok(())
    } else {
        Err(Error::NotConverged(Box::new(
            workspace.linear.report.clone(),
        )))
    }
}

/// Projected gradients after each of the first cycles.
const GRADIENTS: [usize; 2] = [32, 64];

/// The chosen method, led past the place where its sets cycle.
fn iterate<K: Constraint<N>, const N: usize>(run: &mut ActiveSetSolve<'_, '_, K, N>) -> Status {
    let once = |run: &mut ActiveSetSolve<'_, '_, K, N>| match run.monitor.settings.method {
        Method::ActiveSet => newton(run),
        Method::PolonskyKeer => K::Set::single_loop(run),
    };
    // Without symmetry there is no objective that could fall.
    let is_symmetric = run.problem.operator.is_symmetric();
    for steps in GRADIENTS.into_iter().filter(|_| is_symmetric) {
        if let Some(status) = once(run) {
            return status;
        }
        match run.project_gradients(steps) {
            ControlFlow::Break(status) => return status,
            ControlFlow::Continue(Objective::Stands) => break,
            ControlFlow::Continue(Objective::Falls) => {}
        }
    }
    once(run).unwrap_or_else(|| run.by_proximal_points())
}
