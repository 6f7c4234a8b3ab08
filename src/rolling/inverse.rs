//! The approximate inverse of what a traction contributes to the slip.

use std::sync::Arc;

use crate::buffer::{or_abort, try_each, zeros};
use crate::error::Result;
use crate::fft::CirculantInverse;
use crate::operator::Operator;
use crate::rolling::entering::Compliance;
use crate::rolling::step::Step;

/// The sum from the leading edge on, then the circulant inverse of C: the preconditioner.
#[derive(Debug, Clone)]
pub(super) struct SteadyInverse {
    inverse: Arc<CirculantInverse<2>>,
    step: Step,
    /// The part of its slip that a cell hands on; the rest its own compliance takes.
    handed_on: Vec<f64>,
}

impl SteadyInverse {
    /// Of cells that have `own` compliance beside that of their displacement over a step, `elastic`.
    pub(super) fn new(
        inverse: Arc<CirculantInverse<2>>,
        step: Step,
        elastic: f64,
        own: &[Compliance],
    ) -> Self {
        Self {
            inverse,
            step,
            handed_on: own
                .iter()
                .map(|own| elastic / (elastic + own.mean()))
                .collect(),
        }
    }
}

/// The buffers: those of the inverse, and the sums.
pub(super) type SteadyInverseWorkspace = (
    <CirculantInverse<2> as Operator<2>>::Workspace,
    [Vec<f64>; 2],
);

impl Operator<2> for SteadyInverse {
    type Workspace = SteadyInverseWorkspace;

    fn cells(&self) -> usize {
        self.handed_on.len()
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
            for ((sum, x), part) in sum.iter_mut().zip(x).zip(&self.handed_on) {
                *sum = part * x;
            }
            self.step.sum(sum);
        }
        let sums = sums.each_ref().map(Vec::as_slice);
        self.inverse.apply(sums, out, workspace);
    }

    fn is_symmetric(&self) -> bool {
        false
    }
}
