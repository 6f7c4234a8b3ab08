//! The half-space posed to the engine: one operator, its preconditioner and the buffers of their solves.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::cgm::{
    self, Admissible, Constraint, Iteration, Known, Problem, Settings, Total, WorkspaceOf,
};
use crate::error::Result;
use crate::fft::{CirculantInverse, Convolution};
use crate::half_space::{Compliance, HalfSpace};
use crate::influence::Direction;
use crate::operator::Operator;
use crate::report::Report;

/// Who watches a solve and may cancel it.
pub(crate) type Observer<'a> = &'a mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send);

/// The engine on a rectangle of cells, for one kind of set, with the buffers of a solve.
#[derive(Debug, Clone)]
pub(crate) struct ElasticSolver<S: Admissible<N>, const N: usize> {
    compliance: Compliance<N>,
    workspace: WorkspaceOf<Arc<Convolution<N>>, Arc<CirculantInverse<N>>, S, N>,
}

impl<S: Admissible<N>, const N: usize> ElasticSolver<S, N> {
    /// For tractions and displacements along these directions, on `size` cells.
    pub(crate) fn new(
        bodies: &HalfSpace,
        directions: [Direction; N],
        size: [usize; 2],
    ) -> Result<Self> {
        let compliance = bodies.compliance(directions, size)?;
        let workspace = WorkspaceOf::<_, _, S, N>::new(&compliance.operator, &compliance.inverse);
        Ok(Self {
            compliance,
            workspace,
        })
    }

    /// Tells the next solve of its start.
    pub(crate) fn start_from(&mut self, known: Known<N>) {
        self.workspace.start_from(known);
    }

    /// Minimises from `x` into `x`; the rest is in the accessors, converged or not.
    pub(crate) fn minimise(
        &mut self,
        linear: [&[f64]; N],
        constraint: impl Constraint<N, Set = S>,
        totals: [Total; N],
        x: [&mut [f64]; N],
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        let Compliance { operator, inverse } = &self.compliance;
        let problem = Problem::new(Arc::clone(operator), linear, constraint)
            .preconditioner(Arc::clone(inverse))
            .totals(totals);
        cgm::minimise_with(&problem, settings, x, &mut self.workspace, observer)
    }

    /// Writes `C x` to `out`; the answer stays.
    pub(crate) fn apply(&mut self, x: [&[f64]; N], out: [&mut [f64]; N]) {
        let workspace = self.workspace.operator_mut();
        self.compliance.operator.apply(x, out, workspace);
    }

    /// `C x` of the answer.
    pub(crate) fn product(&self) -> [&[f64]; N] {
        self.workspace.product()
    }

    pub(crate) fn multiplier(&self) -> [f64; N] {
        self.workspace.multiplier()
    }

    /// Measures the last answer in another unit.
    pub(crate) fn rescale(&mut self, factor: f64) {
        self.workspace.rescale(factor);
    }

    pub(crate) fn report(&self) -> &Report {
        self.workspace.report()
    }
}
