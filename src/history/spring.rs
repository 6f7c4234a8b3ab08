//! Bodies that are dragged by a spring.

use std::sync::Arc;

use crate::fft::{Convolution, ConvolutionWorkspace};
use crate::operator::Operator;
use crate::parallel;

/// Bodies and spring in series: what the far end of the spring moves for a traction.
///
/// The force $`F = \Delta \sum q = k (X - \delta)`$ makes $`\delta = X - c \sum q`$ with
/// $`c = \Delta / k`$, and the slip $`C q - S - \delta`$ the gradient of the operator
/// $`C + c\,1 1'`$ with the prescribed motion X: symmetric, and its smallest eigenvalue no smaller.
#[derive(Debug, Clone)]
pub(super) struct Sprung {
    bodies: Arc<Convolution>,
    /// Cell area over the stiffness; zero without a spring.
    pub(super) compliance: f64,
}

impl Sprung {
    pub(super) fn rigidly(bodies: Arc<Convolution>) -> Self {
        Self {
            bodies,
            compliance: 0.0,
        }
    }

    /// What the spring stretches under a traction, `c sum q`.
    pub(super) fn stretch(&self, traction: &[f64]) -> f64 {
        let [sum] = parallel::sums(traction.len(), |i| [traction[i]]);
        self.compliance * sum
    }

    fn add_stretch(&self, traction: &[f64], out: &mut [f64]) {
        if self.compliance > 0.0 {
            let stretch = self.stretch(traction);
            parallel::update(out, |_, chunk| {
                for value in chunk {
                    *value += stretch;
                }
            });
        }
    }
}

impl Operator for Sprung {
    type Workspace = ConvolutionWorkspace;

    fn len(&self) -> usize {
        self.bodies.len()
    }

    fn workspace(&self) -> ConvolutionWorkspace {
        self.bodies.workspace()
    }

    fn apply(&self, x: &[f64], out: &mut [f64], workspace: &mut ConvolutionWorkspace) {
        self.bodies.apply(x, out, workspace);
        self.add_stretch(x, out);
    }

    fn apply_roughly(&self, x: &[f64], out: &mut [f64], workspace: &mut ConvolutionWorkspace) {
        self.bodies.apply_roughly(x, out, workspace);
        self.add_stretch(x, out);
    }

    fn lower_bound(&self) -> f64 {
        self.bodies.lower_bound()
    }
}
