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

impl<C: Operator<N>, const N: usize> Sprung<C, N> {
    pub(super) fn rigidly(bodies: C) -> Self {
        Self {
            bodies,
            compliance: [0.0; N],
        }
    }

    /// What the springs stretch under a traction, `c sum q`.
    pub(super) fn stretch(&self, traction: [&[f64]; N]) -> [f64; N] {
        let sums: [f64; N] = parallel::sums(traction[0].len(), |i| traction.map(|part| part[i]));
        std::array::from_fn(|n| self.compliance[n] * sums[n])
    }

    fn add_stretch(&self, traction: [&[f64]; N], out: [&mut [f64]; N]) {
        if self.compliance.iter().all(|compliance| *compliance == 0.0) {
            return;
        }
        for (part, stretch) in out.into_iter().zip(self.stretch(traction)) {
            parallel::update(part, |_, chunk| {
                for value in chunk {
                    *value += stretch;
                }
            });
        }
    }
}

impl<C: Operator<N>, const N: usize> Operator<N> for Sprung<C, N> {
    type Workspace = C::Workspace;

    fn cells(&self) -> usize {
        self.bodies.cells()
    }

    fn workspace(&self) -> C::Workspace {
        self.bodies.workspace()
    }

    fn apply(&self, x: [&[f64]; N], mut out: [&mut [f64]; N], workspace: &mut C::Workspace) {
        self.bodies
            .apply(x, out.each_mut().map(|out| &mut **out), workspace);
        self.add_stretch(x, out);
    }

    fn apply_f32(&self, x: [&[f64]; N], mut out: [&mut [f64]; N], workspace: &mut C::Workspace) {
        self.bodies
            .apply_f32(x, out.each_mut().map(|out| &mut **out), workspace);
        self.add_stretch(x, out);
    }

    fn lower_bound(&self) -> f64 {
        self.bodies.lower_bound()
    }
}
