//! The approximate inverse of the operator of steady rolling.

use crate::error::Result;
use crate::half_space::ElasticPreconditioner;
use crate::memory::fallible::vector;
use crate::numerics::cell_vector::slices;
use crate::operator::{Operator, Scratch};
use crate::rolling::WindowShift;

/// Preconditioner of steady rolling: the sum from the leading edge, followed by the circulant inverse of C.
///
/// The sum assumes that the displacement vanishes ahead of the window. On a grid that is periodic along y, and in rows
/// of long cells, this displacement is large. The slip does not depend on this displacement, so the inverse of C acts
/// on displacements up to a constant. In a test with an inverse that includes the mean of C, the linear problem did not
/// converge. This inverse spread a prescribed force over the cells with a sum near zero.
#[derive(Debug, Clone)]
pub(in crate::rolling) struct SteadyPreconditioner {
    inverse: ElasticPreconditioner<2>,
    step: WindowShift,
}

impl SteadyPreconditioner {
    pub(in crate::rolling) fn new(inverse: ElasticPreconditioner<2>, step: WindowShift) -> Self {
        Self { inverse, step }
    }
}

/// Scratch of the inverse operator, and the sums of both components from the leading edge.
type Buffers = (Scratch, [Vec<f64>; 2]);

impl Operator<2> for SteadyPreconditioner {
    fn cells(&self) -> usize {
        self.inverse.cells()
    }

    fn scratch(&self) -> Result<Scratch> {
        let buffers: Buffers = (self.inverse.scratch()?, vector(self.cells())?);
        Ok(Scratch::new(buffers))
    }

    fn apply(&self, x: [&[f64]; 2], out: [&mut [f64]; 2], scratch: &mut Scratch) {
        let (scratch, sums): &mut Buffers = scratch.buffers();
        for (sum, x) in sums.iter_mut().zip(x) {
            sum.copy_from_slice(x);
            self.step.sum(sum);
        }
        self.inverse.apply_f32(slices(sums), out, scratch);
    }

    fn is_symmetric(&self) -> bool {
        false
    }
}
