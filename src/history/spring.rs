//! Bodies that are dragged by springs.

use crate::operator::Operator;
use crate::parallel;

/// Bodies and springs in series, a spring along any of the N components: what the far ends move for a traction.
///
/// The force $`F = \Delta \sum q = k (X - \delta)`$ of a component makes $`\delta = X - c \sum q`$ with
/// $`c = \Delta / k`$, and the slip $`C q - S - \delta`$ the gradient of the operator
/// $`C + c\,1 1'`$ with the prescribed motion X: symmetric, and its smallest eigenvalue no smaller. Where the
/// grid repeats that is, as of the bodies alone, the least of tractions of sum zero.
#[derive(Debug, Clone)]
pub(super) struct Sprung<C, const N: usize> {
    pub(super) bodies: C,
    /// Cell area over the stiffness; zero without a spring.
    pub(super) compliance: [f64; N],
}

impl<C: Operator, const N: usize> Sprung<C, N> {
    pub(super) fn rigidly(bodies: C) -> Self {
        Self {
            bodies,
            compliance: [0.0; N],
        }
    }

    /// What the springs stretch under a traction, `c sum q`.
    pub(super) fn stretch(&self, traction: &[f64]) -> [f64; N] {
        let cells = traction.len() / N;
        let sums: [f64; N] =
            parallel::sums(cells, |i| std::array::from_fn(|n| traction[n * cells + i]));
        std::array::from_fn(|n| self.compliance[n] * sums[n])
    }

    fn add_stretch(&self, traction: &[f64], out: &mut [f64]) {
        if self.compliance.iter().all(|compliance| *compliance == 0.0) {
            return;
        }
        let parts = out.chunks_exact_mut(traction.len() / N);
        for (part, stretch) in parts.zip(self.stretch(traction)) {
            parallel::update(part, |_, chunk| {
                for value in chunk {
                    *value += stretch;
                }
            });
        }
    }
}

impl<C: Operator, const N: usize> Operator for Sprung<C, N> {
    type Workspace = C::Workspace;

    fn len(&self) -> usize {
        self.bodies.len()
    }

    fn workspace(&self) -> C::Workspace {
        self.bodies.workspace()
    }

    fn apply(&self, x: &[f64], out: &mut [f64], workspace: &mut C::Workspace) {
        self.bodies.apply(x, out, workspace);
        self.add_stretch(x, out);
    }

    fn apply_roughly(&self, x: &[f64], out: &mut [f64], workspace: &mut C::Workspace) {
        self.bodies.apply_roughly(x, out, workspace);
        self.add_stretch(x, out);
    }

    fn lower_bound(&self) -> f64 {
        self.bodies.lower_bound()
    }
}
