//! What bodies hand out: operators and preconditioners, however they are made.

use std::sync::Arc;

use crate::error::Result;
use crate::fft::{CirculantInverse, Convolution, ConvolutionWorkspace, SingleWorkspace};
use crate::layout::Layout;
use crate::operator::Operator;

/// Displacements of the whole grid from tractions on it (lengths from pressures): N components of each.
/// Obtained from [`HalfSpace::operator`](crate::HalfSpace::operator) and
/// [`HalfSpace::tensor_operator`](crate::HalfSpace::tensor_operator); a clone is another pointer to it.
#[derive(Debug, Clone)]
pub struct ElasticOperator<const N: usize = 1>(pub(super) Arc<Convolution<N>>);

/// Approximate inverse of an [`ElasticOperator`], symmetric and positive definite. Obtained from
/// [`HalfSpace::preconditioner`](crate::HalfSpace::preconditioner) and
/// [`HalfSpace::tensor_preconditioner`](crate::HalfSpace::tensor_preconditioner); a clone is another
/// pointer to it.
#[derive(Debug, Clone)]
pub struct ElasticPreconditioner<const N: usize = 1>(pub(super) Arc<CirculantInverse<N>>);

/// An operator that leaves everything to the one it points to.
macro_rules! operator_by {
    ($name:ident, $workspace:ident) => {
        impl<const N: usize> Operator<N> for $name<N> {
            type Workspace = $workspace<N>;

            fn cells(&self) -> usize {
                self.0.cells()
            }

            fn layout(&self) -> Layout {
                self.0.layout()
            }

            fn workspace(&self) -> $workspace<N> {
                self.0.workspace()
            }

            fn try_workspace(&self) -> Result<$workspace<N>> {
                self.0.try_workspace()
            }

            fn apply(&self, x: [&[f64]; N], out: [&mut [f64]; N], workspace: &mut $workspace<N>) {
                self.0.apply(x, out, workspace);
            }

            fn apply_f32(
                &self,
                x: [&[f64]; N],
                out: [&mut [f64]; N],
                workspace: &mut $workspace<N>,
            ) {
                self.0.apply_f32(x, out, workspace);
            }

            fn lower_bound(&self) -> f64 {
                self.0.lower_bound()
            }
        }
    };
}

operator_by!(ElasticOperator, ConvolutionWorkspace);
operator_by!(ElasticPreconditioner, SingleWorkspace);
