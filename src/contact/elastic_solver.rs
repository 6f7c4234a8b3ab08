//! Contact problems of a half-space for the minimiser: the operator, its preconditioner and the buffers of the solves.

use crate::bodies::component::Direction;
use crate::cgm::{
    self, Constraint, ConstraintSet, InitialGuess, Problem, Settings, SparseInverse, Total,
    Workspace,
};
use crate::contact::has_iterate;
use crate::error::Result;
use crate::half_space::{Compliance, ElasticOperator, ElasticPreconditioner, HalfSpace};
use crate::memory::pool::PooledBuffer;
use crate::observer::Observer;
use crate::operator::Operator;
use crate::parallel::layout::Layout;
use crate::report::Report;

/// Minimiser on a rectangle of cells for one type of constraint set. It acquires its buffers from a pool at the first solve
/// and keeps them until [`rest`](Self::rest). Solvers of the same rectangle that work sequentially share the buffers.
#[derive(Debug, Clone)]
pub(crate) struct ElasticSolver<S: ConstraintSet<N>, const N: usize> {
    compliance: Compliance<N>,
    sparse: Option<SparseInverse<N>>,
    layout: Layout,
    workspace: PooledBuffer<Workspace<S, N>>,
    multiplier: [f64; N],
    report: Report,
}

/// Type of the problems of an [`ElasticSolver`].
pub(crate) type ElasticProblem<'a, K, const N: usize> =
    Problem<'a, ElasticOperator<N>, K, ElasticPreconditioner<N>, N>;

/// Returns the multipliers of an earlier solve, with zero for components without a prescribed total.
pub(crate) fn multipliers<const N: usize>(totals: [Total; N], known: [f64; N]) -> [f64; N] {
    std::array::from_fn(|n| match totals[n] {
        Total::Free => 0.0,
        _ => known[n],
    })
}

impl<S: ConstraintSet<N>, const N: usize> ElasticSolver<S, N> {
    /// Creates the solver for tractions and displacements along these directions, on `size` cells.
    pub(crate) fn new(
        bodies: &HalfSpace,
        directions: [Direction; N],
        size: [usize; 2],
    ) -> Result<Self> {
        let compliance = bodies.compliance(directions, size)?;
        Ok(Self {
            layout: compliance.operator.layout().alike(bodies.team()),
            compliance,
            sparse: bodies.sparse_inverse(directions, size)?,
            workspace: PooledBuffer::new(bodies.pool_of_products(directions, size)?),
            multiplier: [0.0; N],
            report: Report::with_room(),
        })
    }

    /// Creates a problem with this operator and preconditioner, a linear term and sets.
    pub(crate) fn problem<'a, K: Constraint<N>>(
        &self,
        linear: [&'a [f64]; N],
        constraint: K,
    ) -> ElasticProblem<'a, K, N> {
        let Compliance { operator, inverse } = &self.compliance;
        Problem::new(operator.clone(), linear, constraint)
            .layout(&self.layout)
            .preconditioner(inverse.clone())
            .sparse(self.sparse.clone())
    }

    /// Minimises from `x` and stores the solution in `x`. `known` contains the prior knowledge about the initial guess. The
    /// accessors return multiplier, product and report, whether or not the solve converged.
    pub(crate) fn minimise(
        &mut self,
        problem: &ElasticProblem<'_, impl Constraint<N, Set = S>, N>,
        (x, known): ([&mut [f64]; N], InitialGuess<N>),
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        self.minimise_with(
            problem,
            problem.uniform_compliance(),
            (x, known),
            settings,
            observer,
        )
    }

    /// Minimises as [`minimise`](Self::minimise), with these compliances of uniform unknowns. They are `None` for all components if
    /// the constraint admits only zero, because the solution is then unique for any total.
    pub(crate) fn minimise_with(
        &mut self,
        problem: &ElasticProblem<'_, impl Constraint<N, Set = S>, N>,
        uniform_compliance: [Option<f64>; N],
        (x, known): ([&mut [f64]; N], InitialGuess<N>),
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        let operator = &self.compliance.operator;
        let bound = operator.lower_bound_of(uniform_compliance)?;
        let workspace = self.workspace.take(|| problem.workspace())?;
        let posed = problem.posed().bounded(bound);
        let outcome = cgm::minimise_from(&posed, settings, x, known, workspace, observer);
        if has_iterate(&outcome) {
            self.multiplier = workspace.multiplier();
            self.report.clone_from(workspace.report());
        }
        outcome
    }

    /// Releases the buffers to the pool, including the product of the solution.
    pub(crate) fn rest(&mut self) {
        self.workspace.give_back();
    }

    /// Writes `C x` to `out`. The stored solution is unchanged.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if the buffers must be allocated and the memory does not suffice.
    pub(crate) fn apply(&mut self, x: [&[f64]; N], out: [&mut [f64]; N]) -> Result<()> {
        let Compliance { operator, inverse } = &self.compliance;
        let workspace = self.workspace.take(|| Workspace::new(operator, inverse))?;
        operator.apply(x, out, workspace.operator_mut());
        Ok(())
    }

    /// Returns `C x` of the solution. The slices are empty after the release of the buffers.
    pub(crate) fn product(&self) -> [&[f64]; N] {
        self.workspace.held().map_or([&[]; N], Workspace::product)
    }

    /// Returns only the product and drops the buffers.
    pub(crate) fn into_product(self) -> [Vec<f64>; N] {
        let workspace = self.workspace.into_piece();
        workspace.map_or([const { Vec::new() }; N], Workspace::into_product)
    }

    pub(crate) fn multiplier(&self) -> [f64; N] {
        self.multiplier
    }

    /// Multiplies multipliers and product by a factor, for a change of unit.
    pub(crate) fn rescale(&mut self, factor: f64) {
        for multiplier in &mut self.multiplier {
            *multiplier *= factor;
        }
        if let Some(workspace) = self.workspace.held_mut() {
            workspace.rescale(factor);
        }
    }

    pub(crate) fn report(&self) -> &Report {
        &self.report
    }
}
