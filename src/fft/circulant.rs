//! The inverse of the nearest periodic operator: a preconditioner.

use crate::fft::plan::{Plan, TransformWorkspace, smooth_length};
use crate::fft::spectrum::Spectrum;
use crate::influence::Table;
use crate::operator::Operator;

/// Approximate inverse of a [`Convolution`](super::Convolution): the coefficient wrapped around
/// the unpadded grid (Strang's circulant), inverted in Fourier space.
///
/// A product costs about a quarter of the operator's. Obtained from
/// [`HalfSpace::preconditioner`](crate::HalfSpace::preconditioner).
#[derive(Debug, Clone)]
pub struct CirculantInverse {
    plan: Plan,
    spectrum: Spectrum,
}

impl CirculantInverse {
    /// On `[nx, ny]` cells, from a table of an even component, with eigenvalues below `floor`
    /// raised to it: wrapping may produce some that no cut of the operator has.
    pub(crate) fn of_table(size: [usize; 2], table: &Table, floor: f64) -> Self {
        let torus = size.map(smooth_length);
        let spectrum = Spectrum::of_table(table, torus);
        let [_, high] = spectrum.extremes();
        let floor = floor.max(1e-12 * high);
        let normalisation = 1.0 / (torus[0] * torus[1]) as f64;
        Self {
            plan: Plan::new(size, torus),
            spectrum: spectrum.map(|value| normalisation / value.max(floor)),
        }
    }
}

impl Operator for CirculantInverse {
    type Workspace = TransformWorkspace;

    fn len(&self) -> usize {
        self.plan.nx * self.plan.ny
    }

    fn workspace(&self) -> TransformWorkspace {
        self.plan.workspace()
    }

    fn apply(&self, x: &[f64], out: &mut [f64], workspace: &mut TransformWorkspace) {
        self.plan.convolve(&self.spectrum, x, out, workspace);
    }
}
