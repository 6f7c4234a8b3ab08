//! The minimisation problem and its solution strategy. If the active sets of the selected method cycle, projected gradients and
//! then proximal points follow.

use std::ops::ControlFlow;

use crate::cgm::active_set_solve::ActiveSetSolve;
use crate::cgm::certificate::Iterate;
use crate::cgm::diagonal::CellCompliance;
use crate::cgm::law::state::{LinearisedSet, TotalFeasibility};
use crate::cgm::linear::SparseInverse;
use crate::cgm::newton::newton;
use crate::cgm::safeguard::projected_gradient::Objective;
use crate::cgm::totals::Total;
use crate::cgm::{Constraint, InitialGuess, Method, Settings, Workspace, law};
use crate::error::{
    Error, Result, all_finite, all_non_negative, check_converged, finite, length, positive,
};
use crate::numerics::cell_vector::{at, minus};
use crate::observer::Observer;
use crate::operator::{Identity, LowerBound, MeanBound, Operator, usable_bound};
use crate::parallel;
use crate::parallel::layout::Layout;
use crate::report::{Iteration, Report, Status};

/// The minimisation problem: `1/2 x'(C + D)x + b'x` over `x_i` in `K_i`, optionally with totals of the components.
#[derive(Debug, Clone)]
pub struct Problem<'a, C, K, P = Identity, const N: usize = 1> {
    pub(super) operator: C,
    pub(super) preconditioner: P,
    sparse: Option<SparseInverse<N>>,
    pub(super) layout: Layout,
    /// Additional compliance of the cells.
    pub(super) own: CellCompliance<'a>,
    linear: [&'a [f64]; N],
    datum: [f64; N],
    pub(super) constraint: K,
    pub(super) totals: [Total; N],
    pub(super) is_examined_elsewhere: bool,
}

impl<'a, C: Operator<N>, K: Constraint<N>, const N: usize> Problem<'a, C, K, Identity, N> {
    /// Creates the problem with operator `C`, linear term `b` (one slice per component) and constraint `K`. The problem has no
    /// prescribed total and no preconditioner.
    pub fn new(operator: C, linear: [&'a [f64]; N], constraint: K) -> Self {
        let preconditioner = Identity::new(operator.cells());
        Self {
            layout: operator.layout(),
            operator,
            preconditioner,
            sparse: None,
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
    /// Sets the totals of the components (default: free).
    #[must_use]
    pub fn totals(mut self, totals: [Total; N]) -> Self {
        self.totals = totals;
        self
    }

    /// Adds a compliance to each cell: the solver minimises with `C + D` instead of `C`. `D` has one non-negative number for all
    /// components of a cell. By default, and for an empty slice, no compliance is added. [`Workspace::product`] remains the
    /// product with `C`.
    ///
    /// ```
    /// use stickslip::cgm::{self, NonNegative, Problem, Settings};
    /// use stickslip::Identity;
    ///
    /// // Two springs are pressed by 1; one of them is in series with a third spring that is three times as soft.
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

    /// Adds a symmetric positive semidefinite tensor to each cell.
    pub(crate) fn own(mut self, own: CellCompliance<'a>) -> Self {
        self.own = own;
        self
    }

    /// Subtracts a constant from each component of the linear term.
    pub(crate) fn datum(mut self, datum: [f64; N]) -> Self {
        self.datum = datum;
        self
    }

    /// Marks a problem whose solution this solve does not certify. The solution is a start for a different solve, or the caller
    /// examines it with an exact product. Convergence may then be tested with a product whose error is a small fraction of the
    /// tolerance. The report and the stored product then also contain this error.
    pub(crate) fn verified_by_caller(mut self) -> Self {
        self.is_examined_elsewhere = true;
        self
    }

    /// Sets a replacement of the preconditioner for scattered cells.
    pub(crate) fn sparse(mut self, sparse: Option<SparseInverse<N>>) -> Self {
        self.sparse = sparse;
        self
    }

    /// Sets the layout of the cells. The ranks of the layout may also all solve the same problem.
    pub(crate) fn layout(mut self, layout: &Layout) -> Self {
        self.layout.clone_from(layout);
        self
    }

    /// Sets an approximate inverse of `C`, which must be symmetric and positive definite. Only [`Method::ActiveSet`] uses it.
    #[must_use]
    pub fn preconditioner<Q: Operator<N>>(self, preconditioner: Q) -> Problem<'a, C, K, Q, N> {
        Problem {
            operator: self.operator,
            preconditioner,
            sparse: self.sparse,
            layout: self.layout,
            own: self.own,
            linear: self.linear,
            datum: self.datum,
            constraint: self.constraint,
            totals: self.totals,
            is_examined_elsewhere: self.is_examined_elsewhere,
        }
    }

    /// Creates the buffers for this problem, which are also valid for other problems of the same size and type of set.
    ///
    /// # Errors
    /// - [`Error::Memory`] if the memory does not suffice.
    pub fn workspace(&self) -> Result<Workspace<K::Set, N>> {
        Workspace::new(&self.operator, &self.preconditioner)
    }

    /// Returns the problem with the types of its operators erased.
    pub(crate) fn posed(&self) -> Posed<'_, K, N> {
        Posed {
            operator: &self.operator,
            preconditioner: &self.preconditioner,
            sparse: self.sparse.as_ref(),
            layout: &self.layout,
            own: self.own,
            linear: self.linear,
            datum: self.datum,
            constraint: &self.constraint,
            totals: self.totals,
            lower_bound: LowerBound {
                value: usable_bound(self.operator.lower_bound()),
                of_all: usable_bound(self.operator.lower_bound()),
                known: self.operator.eigenvalue_bound(),
                mean: MeanBound::Operator,
            },
            is_examined_elsewhere: self.is_examined_elsewhere,
        }
    }

    /// Returns the compliance that the totals add to uniform unknowns, or `None` for a component whose sum is prescribed.
    pub(crate) fn uniform_compliance(&self) -> [Option<f64>; N] {
        let cells = self.layout.of_all_ranks();
        self.totals.map(|total| total.uniform_compliance(cells))
    }
}

/// A problem with erased operator types: the iterations are compiled once per constraint, not once per operator.
pub(crate) struct Posed<'a, K, const N: usize> {
    pub(super) operator: &'a dyn Operator<N>,
    pub(super) preconditioner: &'a dyn Operator<N>,
    /// Replacement of the preconditioner for scattered cells.
    pub(super) sparse: Option<&'a SparseInverse<N>>,
    pub(super) layout: &'a Layout,
    /// Additional compliance of the cells.
    pub(super) own: CellCompliance<'a>,
    linear: [&'a [f64]; N],
    datum: [f64; N],
    pub(super) constraint: &'a K,
    pub(super) totals: [Total; N],
    /// Lower bound of the eigenvalues on the unknowns that the totals allow.
    pub(super) lower_bound: LowerBound,
    pub(super) is_examined_elsewhere: bool,
}

impl<'a, K: Constraint<N>, const N: usize> Posed<'a, K, N> {
    /// Sets a lower bound of the eigenvalues on the unknowns that the totals allow (default: the bound of the operator).
    pub(crate) fn bounded(self, lower_bound: LowerBound) -> Self {
        Self {
            lower_bound,
            ..self
        }
    }

    /// Returns the linear term of a cell.
    pub(super) fn linear(&self, cell: usize) -> [f64; N] {
        minus(at(&self.linear, cell), self.datum)
    }

    /// Returns an iterate with its product and multipliers, ready for examination.
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

    /// Checks that the single loop is applicable: it requires a symmetric problem with intervals and without springs.
    fn check_single_loop(&self) -> Result<()> {
        let has_spring = self.totals.iter().any(|total| total.is_spring());
        let quantity = if has_spring {
            "springs"
        } else if N > 1 {
            "several components per cell"
        } else if !self.operator.is_symmetric() {
            "non-symmetric operators"
        } else {
            return Ok(());
        };
        Err(Error::Method {
            method: "Polonsky-Keer",
            quantity,
        })
    }
}

impl<C: Operator, K: Constraint, P: Operator> Problem<'_, C, K, P> {
    /// Prescribes the total of the only component, `sum x = total`.
    #[must_use]
    pub fn total(self, total: f64) -> Self {
        self.totals([Total::Sum(total)])
    }
}

/// Multipliers and report of a minimum. The minimiser itself is returned in `x`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Minimum<const N: usize = 1> {
    /// Multipliers of the totals. `C x + b - multiplier` vanishes on free cells. The multiplier is zero for a component without a
    /// prescribed total.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::array"))]
    pub multiplier: [f64; N],
    /// Status, cost and certified error.
    pub report: Report,
}

/// Minimises the problem from the start `x` and stores the minimiser in `x`.
///
/// # Errors
/// Errors before any work leave `x` unchanged:
/// - [`Error::Length`], [`Error::Sample`], [`Error::Bounds`] or [`Error::NegativeOrNotFinite`] for invalid input.
/// - [`Error::Total`] or [`Error::BeyondFrictionCapacity`] for sums that the sets cannot carry.
/// - [`Error::NotPositive`] or [`Error::NotFinite`] for an invalid spring.
/// - [`Error::Method`] for a method that does not support the sets.
/// - [`Error::Tolerance`] or [`Error::IterationLimit`] for invalid settings.
///
/// Errors of the solve:
/// - [`Error::NotConverged`], with the last feasible iterate in `x`.
/// - [`Error::NotPositive`] instead, if the cause is a preconditioner that is not positive definite.
/// - [`Error::Memory`] if the memory does not suffice.
pub fn minimise<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    problem: &Problem<'_, C, K, P, N>,
    settings: &Settings,
    x: [&mut [f64]; N],
) -> Result<Minimum<N>> {
    // An operator may report any number of unknowns, whereas the start exists in memory. Therefore the lengths are compared
    // before any allocation.
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

/// Minimises like [`minimise`], with the caller's workspace and an observer. The workspace also stores the product, the
/// multiplier and the report. The observer is called at every step and may cancel the solve. The solve does not allocate memory
/// if the workspace was used before for a solve with at least as many steps.
///
/// # Errors
/// The errors of [`minimise`], and [`Error::Length`] if the workspace has a different number of cells.
///
/// # Panics
/// Operators of this crate panic if the workspace was created for a different operator with the same number of cells.
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

/// Minimises like [`minimise_with`], with prior knowledge about the start.
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
    let solve = || -> Result<()> {
        let sums = problem.totals.map(Total::sum);
        let reach = K::Set::reach(problem.layout, problem.constraint, sums)?;
        let mut run = ActiveSetSolve::new(problem, settings, x, workspace, observer);
        run.find_bound_of_mean();
        let status = match (run.multiplier_at_zero(), reach) {
            (Some(multiplier), _) => run.at_zero(multiplier),
            (None, TotalFeasibility::Extreme(direction)) => run.at_extreme(direction),
            (None, TotalFeasibility::Inside) if run.verify_start(known) => {
                run.add_diagonal(-1.0);
                return Ok(());
            }
            (None, TotalFeasibility::Inside) => iterate(&mut run),
        };
        let status = run.finish(status);
        // The stored product is the product with the operator alone, without the diagonal.
        run.add_diagonal(-1.0);
        if let Some(allocation_error) = run.monitor.allocation_error.take() {
            return Err(allocation_error);
        }
        let has_failed = matches!(status, Status::Stalled | Status::IterationLimit);
        if has_failed && settings.method == Method::ActiveSet {
            run.check_preconditioner()?;
        }
        Ok(())
    };
    parallel::enter_with(cells, solve)?;
    problem.layout.check()?;
    check_converged(&workspace.linear.report)
}

/// Number of projected-gradient steps after the first cycle and after the second cycle.
const GRADIENTS: [usize; 2] = [32, 64];

/// Runs the selected method. If its sets cycle, projected-gradient steps and finally proximal-point steps follow.
fn iterate<K: Constraint<N>, const N: usize>(run: &mut ActiveSetSolve<'_, '_, K, N>) -> Status {
    let once = |run: &mut ActiveSetSolve<'_, '_, K, N>| match run.monitor.settings.method {
        Method::ActiveSet => newton(run),
        Method::PolonskyKeer => run.polonsky_keer(),
    };
    // Without symmetry there is no objective to decrease.
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
