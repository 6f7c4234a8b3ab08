//! The inverse of the nearest periodic operator: a preconditioner.

use crate::fft::length::smooth_length;
use crate::fft::single::{SingleProduct, SingleWorkspace};
use crate::fft::spectrum::Spectrum;
use crate::influence::Table;
use crate::operator::Operator;

/// Approximate inverse of a [`Convolution`](super::Convolution): the coefficient wrapped around
/// the unpadded grid (Strang's circulant), inverted in Fourier space.
///
/// In single precision throughout; a product costs about a quarter of the operator's. Obtained from
/// [`HalfSpace::preconditioner`](crate::HalfSpace::preconditioner).
#[derive(Debug, Clone)]
pub struct CirculantInverse {
    product: SingleProduct,
}

impl CirculantInverse {
    /// On `[nx, ny]` cells, from a table of an even component, with eigenvalues below `floor`
    /// raised to it: wrapping may produce some that no cut of the operator has.
    pub(crate) fn of_table(size: [usize; 2], table: &Table, floor: f64) -> Self {
        let torus = size.map(smooth_length);
        let spectrum = Spectrum::of_table(table, torus);
        let [_, high] = spectrum.extremes();
        let floor = floor.max(1e-12 * high);
        Self {
            product: SingleProduct::new(size, torus, &spectrum, |value| 1.0 / value.max(floor)),
        }
    }
}

impl Operator for CirculantInverse {
    type Workspace = SingleWorkspace;

    fn len(&self) -> usize {
        self.product.len()
    }

    fn workspace(&self) -> SingleWorkspace {
        self.product.workspace()
    }

    fn apply(&self, x: &[f64], out: &mut [f64], workspace: &mut SingleWorkspace) {
        self.product.apply(x, out, workspace);
    }
}
