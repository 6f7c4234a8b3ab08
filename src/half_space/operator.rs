//! What bodies hand out: operators and preconditioners, however they are made.

use std::sync::Arc;

use crate::bodies::kernel::SubOperator;
use crate::error::{Result, positive};
use crate::fft::{CirculantInverse, Convolution};
use crate::operator::{LowerBound, MeanBound, Operator, Scratch};
use crate::parallel::layout::Layout;
use crate::report::EigenvalueBound;

/// Displacements of the whole grid from tractions on it (lengths from pressures): N components of each.
/// Obtained from [`HalfSpace::operator`](crate::HalfSpace::operator) and
/// [`HalfSpace::tensor_operator`](crate::HalfSpace::tensor_operator); a clone is another pointer to it.
#[derive(Debug, Clone)]
pub struct ElasticOperator<const N: usize = 1>(OperatorKind<N>);

/// A convolution, or what a user gave.
#[derive(Debug, Clone)]
enum OperatorKind<const N: usize> {
    Convolution(Arc<Convolution<N>>),
    User(Arc<SubOperator<N>>),
}

impl<const N: usize> ElasticOperator<N> {
    /// Whether both point to the same.
    pub(crate) fn is(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (OperatorKind::Convolution(own), OperatorKind::Convolution(other)) => {
                Arc::ptr_eq(own, other)
            }
            (OperatorKind::User(own), OperatorKind::User(other)) => own.is(other),
            _ => false,
        }
    }

    /// The convolution; none of an operator of a user.
    pub(super) fn as_convolution(&self) -> Option<&Convolution<N>> {
        match &self.0 {
            OperatorKind::Convolution(convolution) => Some(convolution),
            OperatorKind::User(_) => None,
        }
    }

    /// The least eigenvalue of the periodic continuation, of whatever sign, without the mean on a grid that repeats; nothing of
    /// an operator of a user.
    pub(super) fn least_eigenvalue(&self) -> Option<f64> {
        match &self.0 {
            OperatorKind::Convolution(convolution) => Some(convolution.least_eigenvalue()),
            OperatorKind::User(_) => None,
        }
    }

    /// A lower bound of the eigenvalues of tractions without a mean on a grid that repeats, of all tractions on another grid,
    /// and how it is known.
    pub(crate) fn bound_without_mean(&self) -> (f64, EigenvalueBound) {
        match &self.0 {
            OperatorKind::Convolution(convolution) => {
                (convolution.lower_bound_without_mean(), convolution.known())
            }
            OperatorKind::User(part) => (part.lower_bound(), part.eigenvalue_bound()),
        }
    }

    /// A lower bound of the eigenvalues of the tractions that a problem allows. A component has no mean if its sum is
    /// prescribed (`None`). To others a uniform traction adds such a compliance: zero, or that of a spring.
    ///
    /// # Errors
    /// [`Error::DatumTooNear`](crate::Error::DatumTooNear) if the compliance of these tractions is not definite.
    pub(crate) fn lower_bound_of(&self, added: [Option<f64>; N]) -> Result<LowerBound> {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.lower_bound_of(added),
            OperatorKind::User(part) => Ok(LowerBound {
                value: part.lower_bound(),
                known: part.eigenvalue_bound(),
                mean: MeanBound::Operator,
            }),
        }
    }

    /// `Ok` if a bound of the least eigenvalue is known, or need not be stated.
    pub(crate) fn check_bounded(&self) -> Result<()> {
        if let OperatorKind::User(part) = &self.0 {
            positive("lower bound of an operator of a user", part.lower_bound())?;
        }
        Ok(())
    }

    /// A bound of the largest eigenvalue; infinity where none is known.
    pub(crate) fn upper_bound(&self) -> f64 {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.upper_bound(),
            OperatorKind::User(_) => f64::INFINITY,
        }
    }
}

impl ElasticOperator<3> {
    /// A bound of $`|p' B q| / (|p|\,|q|)`$, in the energy norms of the first component and of the other two, of what the
    /// first causes along the others: one if none is known.
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
    fn cells(&self) -> usize {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.cells(),
            OperatorKind::User(part) => part.cells(),
        }
    }

    fn layout(&self) -> Layout {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.layout(),
            OperatorKind::User(part) => part.layout(),
        }
    }

    fn scratch(&self) -> Result<Scratch> {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.scratch(),
            OperatorKind::User(part) => part.scratch(),
        }
    }

    fn apply(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.apply(x, out, scratch),
            OperatorKind::User(part) => part.apply(x, out, scratch),
        }
    }

    fn apply_f32(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.apply_f32(x, out, scratch),
            OperatorKind::User(part) => part.apply_f32(x, out, scratch),
        }
    }

    fn lower_bound(&self) -> f64 {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.lower_bound(),
            OperatorKind::User(part) => part.lower_bound(),
        }
    }

    fn eigenvalue_bound(&self) -> EigenvalueBound {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.eigenvalue_bound(),
            OperatorKind::User(part) => part.eigenvalue_bound(),
        }
    }

    fn self_compliance(&self) -> f64 {
        match &self.0 {
            OperatorKind::Convolution(convolution) => convolution.self_compliance(),
            OperatorKind::User(part) => part.self_compliance(),
        }
    }
}

/// Approximate inverse of an [`ElasticOperator`], symmetric and positive definite. Obtained from
/// [`HalfSpace::preconditioner`](crate::HalfSpace::preconditioner) and
/// [`HalfSpace::tensor_preconditioner`](crate::HalfSpace::tensor_preconditioner); a clone is another
/// pointer to it.
#[derive(Debug, Clone)]
pub struct ElasticPreconditioner<const N: usize = 1>(pub(super) Arc<CirculantInverse<N>>);

impl<const N: usize> ElasticPreconditioner<N> {
    /// Whether both point to the same: other bodies, and other windows, have others.
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
