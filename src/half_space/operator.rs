//! Public operators and preconditioners of bodies.

use std::sync::Arc;

use crate::bodies::kernel::SubOperator;
use crate::error::{Result, positive};
use crate::fft::{CirculantInverse, Convolution};
use crate::operator::{LowerBound, MeanBound, Operator, Scratch, operator_methods};
use crate::parallel::layout::Layout;
use crate::report::EigenvalueBound;

/// Operator that computes displacements of the whole grid from tractions on the grid (lengths from pressures). Both
/// have N components. [`HalfSpace::operator`](crate::HalfSpace::operator) and
/// [`HalfSpace::tensor_operator`](crate::HalfSpace::tensor_operator) create it. Clones share the same operator.
#[derive(Debug, Clone)]
pub struct ElasticOperator<const N: usize = 1>(OperatorKind<N>);

/// Kind of operator: a convolution or a user-defined operator.
#[derive(Debug, Clone)]
enum OperatorKind<const N: usize> {
    Convolution(Arc<Convolution<N>>),
    User(Arc<SubOperator<N>>),
}

impl<const N: usize> ElasticOperator<N> {
    /// Returns whether `self` and `other` share the same operator.
    pub(crate) fn is(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (OperatorKind::Convolution(own), OperatorKind::Convolution(other)) => {
                Arc::ptr_eq(own, other)
            }
            (OperatorKind::User(own), OperatorKind::User(other)) => own.is(other),
            _ => false,
        }
    }

    /// Returns the convolution, or `None` for a user-defined operator.
    pub(super) fn as_convolution(&self) -> Option<&Convolution<N>> {
        match &self.0 {
            OperatorKind::Convolution(convolution) => Some(convolution),
            OperatorKind::User(_) => None,
        }
    }

    /// Returns the smallest eigenvalue of the periodic continuation, which may be negative. Returns `None` for a
    /// user-defined operator. On a periodic grid uniform tractions are excluded.
    pub(super) fn least_eigenvalue(&self) -> Option<f64> {
        match &self.0 {
            OperatorKind::Convolution(convolution) => Some(convolution.least_eigenvalue()),
            OperatorKind::User(_) => None,
        }
    }

    /// Returns a lower bound of the eigenvalues, and its origin. On a periodic grid the bound holds for tractions with
    /// zero mean. On other grids it holds for all tractions.
    pub(crate) fn bound_without_mean(&self) -> (f64, EigenvalueBound) {
        match &self.0 {
            OperatorKind::Convolution(convolution) => {
                (convolution.lower_bound_without_mean(), convolution.known())
            }
            OperatorKind::User(part) => (part.lower_bound(), part.eigenvalue_bound()),
        }
    }

    /// Returns a lower bound of the eigenvalues for the tractions that a problem allows. If the sum of a component is
    /// prescribed (`None`), its mean is zero. For other components `added` contains the compliance that acts on a
    /// uniform traction: zero, or the compliance of a spring.
    ///
    /// # Errors
    /// - [`Error::DatumTooNear`](crate::Error::DatumTooNear) if the compliance for these tractions is not positive
    ///   definite.
    pub(crate) fn lower_bound_of(&self, added: [Option<f64>; N]) -> Result<LowerBound> {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.lower_bound_of(added),
            OperatorKind::User(part) => Ok(LowerBound {
                value: part.lower_bound(),
                of_all: part.lower_bound(),
                known: part.eigenvalue_bound(),
                mean: MeanBound::Operator,
            }),
        }
    }

    /// Checks that a user-defined operator states a positive lower bound. Other operators need no stated bound.
    pub(crate) fn check_bounded(&self) -> Result<()> {
        if let OperatorKind::User(part) = &self.0 {
            positive("lower bound of a user-defined operator", part.lower_bound())?;
        }
        Ok(())
    }

    /// Returns an upper bound of the eigenvalues, or infinity if no bound is available.
    pub(crate) fn upper_bound(&self) -> f64 {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.upper_bound(),
            OperatorKind::User(_) => f64::INFINITY,
        }
    }

    fn kind(&self) -> &dyn Operator<N> {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution,
            OperatorKind::User(part) => part,
        }
    }
}

impl ElasticOperator<3> {
    /// Returns a bound of $`|p' B q| / (|p|\,|q|)`$, or 1 if no bound is available. B couples the first component to
    /// the other two components. The norms are the energy norms of the first component and of the other two components.
    pub(crate) fn coupling(&self) -> f64 {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.coupling(),
            OperatorKind::User(_) => 1.0,
        }
    }
}

impl<const N: usize> From<Arc<Convolution<N>>> for ElasticOperator<N> {
    fn from(convolution: Arc<Convolution<N>>) -> Self {
        Self(OperatorKind::Convolution(convolution))
    }
}

impl<const N: usize> From<SubOperator<N>> for ElasticOperator<N> {
    fn from(part: SubOperator<N>) -> Self {
        Self(OperatorKind::User(Arc::new(part)))
    }
}

impl<const N: usize> Operator<N> for ElasticOperator<N> {
    operator_methods!(self, self.kind());
}

/// Approximate inverse of an [`ElasticOperator`], symmetric and positive definite.
/// [`HalfSpace::preconditioner`](crate::HalfSpace::preconditioner) and
/// [`HalfSpace::tensor_preconditioner`](crate::HalfSpace::tensor_preconditioner) create it. Clones share the same
/// preconditioner.
#[derive(Debug, Clone)]
pub struct ElasticPreconditioner<const N: usize = 1>(pub(super) Arc<CirculantInverse<N>>);

impl<const N: usize> ElasticPreconditioner<N> {
    /// Returns whether `self` and `other` share the same preconditioner, which differs between bodies and between
    /// window sizes.
    pub(crate) fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl<const N: usize> Operator<N> for ElasticPreconditioner<N> {
    fn cells(&self) -> usize {
        self.0.cells()
    }

    fn layout(&self) -> Layout {
        self.0.layout()
    }

    fn scratch(&self) -> Result<Scratch> {
        self.0.scratch()
    }

    fn apply(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
        self.0.apply(x, out, scratch);
    }
}
