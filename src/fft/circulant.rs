//! The inverse of the nearest periodic operator: a preconditioner.

use crate::fft::length::smooth_length;
use crate::fft::single::{SingleProduct, SingleWorkspace};
use crate::fft::spectrum::Spectrum;
use crate::influence::{Symbols, Table};
use crate::operator::Operator;

/// Approximate inverse of a [`Convolution`](super::Convolution): the coefficient wrapped around
/// the unpadded grid (Strang's circulant), inverted in Fourier space. On a periodic grid the inverse is
/// exact, and a mean weighs as much as the longest wave.
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
        Self::of_spectrum(size, torus, &Spectrum::of_table(table, torus), floor)
    }

    /// On a periodic grid, from the symbols of an even component.
    pub(crate) fn of_symbols(symbols: &Symbols) -> Self {
        let spectrum = Spectrum::of_symbols(symbols);
        let [low, high] = spectrum.extremes_without_mean();
        // A single cell has no wave but the mean: anything will do.
        let mean = if high > 0.0 { high } else { 1.0 };
        let size = symbols.size();
        Self::of_spectrum(size, size, &spectrum.with_mean(mean), low.min(mean))
    }

    fn of_spectrum(
        size: [usize; 2],
        torus: [usize; 2],
        spectrum: &Spectrum<f64>,
        floor: f64,
    ) -> Self {
        let [_, high] = spectrum.extremes();
        let floor = floor.max(1e-12 * high);
        Self {
            product: SingleProduct::new(size, torus, spectrum, |value| 1.0 / value.max(floor)),
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
