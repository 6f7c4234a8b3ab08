//! The approximate inverse of what a traction contributes to the slip.

use crate::buffer::{or_abort, try_each, zeros};
use crate::cgm::vector::slices;
use crate::error::Result;
use crate::fft::SingleWorkspace;
use crate::half_space::ElasticPreconditioner;
use crate::history::Passage;
use crate::operator::Operator;

/// The sum from the leading edge on, then the circulant inverse of C: the preconditioner.
#[derive(Debug, Clone)]
pub(super) struct SteadyInverse {
    inverse: ElasticPreconditioner<2>,
    step: Passage,
}

impl SteadyInverse {
    pub(super) fn new(inverse: ElasticPreconditioner<2>, step: Passage) -> Self {
        Self { inverse, step }
    }
}

/// The buffers: those of the inverse, and the sums.
pub(super) type SteadyInverseWorkspace = (SingleWorkspace<2>, [Vec<f64>; 2]);

impl Operator<2> for SteadyInverse {
    type Workspace = SteadyInverseWorkspace;

    fn cells(&self) -> usize {
        self.inverse.cells()
    }

    fn workspace(&self) -> Self::Workspace {
        or_abort(self.try_workspace())
    }

    fn try_workspace(&self) -> Result<Self::Workspace> {
        let sums = try_each(|_| zeros(self.cells()))?;
        Ok((self.inverse.try_workspace()?, sums))
    }

    fn apply(&self, x: [&[f64]; 2], out: [&mut [f64]; 2], (workspace, sums): &mut Self::Workspace) {
        for (sum, x) in sums.iter_mut().zip(x) {
            sum.copy_from_slice(x);
            self.step.sum(sum);
        }
        self.inverse.apply_f32(slices(sums), out, workspace);
    }

    fn is_symmetric(&self) -> bool {
        false
    }
}
