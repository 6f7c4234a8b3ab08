//! The inverse of the nearest periodic operator: a preconditioner.

use std::sync::Arc;

use crate::error::Result;
use crate::fft::length::smooth_length;
use crate::fft::single_precision::{SingleProduct, SingleScratch};
use crate::fft::symbol::Symbol;
use crate::fft::torus::TorusLayout;
use crate::influence::InfluenceKernel;
use crate::operator::{Operator, Scratch};
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::RowPartition;

/// Number of cells between a grid and its images around the torus. Without such cells, opposite edges of the grid are adjacent.
/// In measurements, conjugate gradients then converged a fifth to a quarter more slowly if both edges were in contact. More than
/// two cells made no difference.
const APART: usize = 2;

/// Approximate inverse of a [`Convolution`](super::Convolution). The coefficients are wrapped around the grid and two cells
/// beyond its edge (Strang's circulant), and inverted in Fourier space. On a periodic grid, which is not padded, the
/// inverse is exact for tractions of mean zero. The mean has the weight of the largest eigenvalue.
///
/// All computations are in single precision. A product takes about a quarter of the time of an operator product.
/// [`HalfSpace::preconditioner`](crate::HalfSpace::preconditioner) returns this preconditioner.
///
/// # Memory
///
/// The inverse takes one byte per cell for each of the N (N + 1)/2 coefficients. Each workspace takes 4 N bytes per cell.
#[derive(Debug, Clone)]
pub struct CirculantInverse<const N: usize = 1> {
    product: SingleProduct<N>,
}

impl<const N: usize> CirculantInverse<N> {
    /// Creates the inverse on `[nx, ny]` cells from a symmetric tensor of kernels. Eigenvalues below `floor` are raised to
    /// `floor`, because wrapping can produce smaller eigenvalues than the operator has on any part of the grid.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub(crate) fn new(
        size: [usize; 2],
        share: Option<Arc<RowPartition>>,
        kernels: [[&InfluenceKernel; N]; N],
        floor: f64,
    ) -> Result<Self> {
        Self::with_mean((size, share), kernels, floor, false)
    }

    /// Creates the inverse for displacements up to a constant. The grid is periodic along y. The mean has the weight of the
    /// longest wave, independent of the datum of the displacements.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub(crate) fn up_to_mean(
        size: [usize; 2],
        kernels: [[&InfluenceKernel; N]; N],
        floor: f64,
    ) -> Result<Self> {
        Self::with_mean((size, None), kernels, floor, true)
    }

    fn with_mean(
        (size, share): ([usize; 2], Option<Arc<RowPartition>>),
        kernels: [[&InfluenceKernel; N]; N],
        floor: f64,
        is_up_to_mean: bool,
    ) -> Result<Self> {
        let repeats = kernels[0][0].repeats();
        let torus = std::array::from_fn(|axis| match (size[axis], repeats[axis]) {
            (cells, true) => cells,
            (cells, false) => smooth_length((cells + APART).min(2 * cells - 1)),
        });
        let frame = TorusLayout { size, torus, share };
        let symbol = Symbol::new(&frame, kernels)?;
        let [_, high] = symbol.extremes(false);
        // A single periodic cell has no wave except the mean, so any weight is valid.
        let high = if high > 0.0 { high } else { 1.0 };
        // On a grid that is periodic along y, the mean has a negative eigenvalue if the datum is too near.
        let is_mean_unbounded = repeats == [false, true] && symbol.least_of_mean() <= floor;
        let symbol = if is_up_to_mean {
            symbol.with_mean_of_longest_wave()
        } else if repeats == [true; 2] || is_mean_unbounded {
            symbol.with_mean(high)
        } else {
            symbol
        };
        // If no bound of the operator is available, the floor is far below the diagonal entries of the symbol.
        let floor = floor.max(1e-12 * high).max(1e-2 * symbol.least_diagonal());
        Ok(Self {
            product: SingleProduct::new(frame, &symbol.inverse_above(floor))?,
        })
    }
}

impl<const N: usize> Operator<N> for CirculantInverse<N> {
    fn cells(&self) -> usize {
        self.product.cells()
    }

    fn layout(&self) -> Layout {
        self.product.layout()
    }

    fn scratch(&self) -> Result<Scratch> {
        Ok(Scratch::new(self.product.buffers()?))
    }

    fn apply(&self, x: [&[f64]; N], out: [&mut [f64]; N], scratch: &mut Scratch) {
        let SingleScratch { tiles, scratch } = scratch.buffers();
        self.product.apply(x, out, tiles, scratch);
    }
}
