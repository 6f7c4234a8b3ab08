//! The approximate inverse of what a traction contributes to the slip.

use std::sync::Arc;

use crate::buffer::{or_abort, try_each, zeros};
use crate::cgm::Weight;
use crate::cgm::vector::{at, slices, update_cells};
use crate::error::Result;
use crate::fft::CirculantInverse;
use crate::history::Passage;
use crate::history::rolling_entry::Compliance;
use crate::operator::Operator;

/// The sum from the leading edge on, then the circulant inverse of C: the preconditioner.
#[derive(Debug, Clone)]
pub(super) struct SteadyInverse {
    inverse: Arc<CirculantInverse<2>>,
    step: Passage,
    /// The part of its slip that a cell hands on; the rest its own compliance takes.
    weights: Vec<Weight>,
}

impl SteadyInverse {
    /// Of cells that have `own` compliance beside that of their displacement over a step, `self_compliance`.
    pub(super) fn new(
        inverse: Arc<CirculantInverse<2>>,
        step: Passage,
        self_compliance: f64,
        own: &[Compliance],
    ) -> Self {
        Self {
            inverse,
            step,
            weights: own
                .iter()
                .map(|own| Weight::new(own.mean(), self_compliance))
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
        self.weights.len()
    }

    fn workspace(&self) -> Self::Workspace {
        or_abort(self.try_workspace())
    }

    fn try_workspace(&self) -> Result<Self::Workspace> {
        let sums = try_each(|_| zeros(self.cells()))?;
        Ok((self.inverse.try_workspace()?, sums))
    }

    fn apply(
        &self,
        x: [&[f64]; 2],
        mut out: [&mut [f64]; 2],
        (workspace, sums): &mut Self::Workspace,
    ) {
        for (sum, x) in sums.iter_mut().zip(x) {
            for ((sum, x), weight) in sum.iter_mut().zip(x).zip(&self.weights) {
                *sum = weight.weighted(*x);
            }
            self.step.sum(sum);
        }
        let tractions = out.each_mut().map(|part| &mut **part);
        self.inverse.apply_f32(slices(sums), tractions, workspace);
        update_cells(&mut out, |cell, answer| {
            let r = at(&x, cell);
            [0, 1].map(|axis| self.weights[cell].preconditioned(answer[axis], r[axis]))
        });
    }

    fn is_symmetric(&self) -> bool {
        false
    }
}
