//! The inverse of the nearest periodic operator: a preconditioner.

use std::sync::Arc;

use crate::error::Result;
use crate::fft::length::smooth_length;
use crate::fft::single_precision::{SingleProduct, SingleScratch};
use crate::fft::symbol::Symbol;
use crate::fft::torus::TorusLayout;
use crate::influence::Kernel;
use crate::operator::{Operator, Scratch};
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::RowPartition;

/// Cells between a grid and its images around the torus. Without them cells at opposite edges are neighbours, and conjugate
/// gradients converge a fifth to a quarter slower where both are in contact; more than two make no difference (measured).
const APART: usize = 2;

/// Approximate inverse of a [`Convolution`](super::Convolution): the coefficients wrapped around the grid and two cells
/// beyond its edge (Strang's circulant), inverted in Fourier space. On a periodic grid, which is not padded, the inverse is
/// exact for tractions of mean zero, and a mean weighs as much as the largest eigenvalue.
///
/// In single precision throughout; a product costs about a quarter of the operator's. Memory: one byte per
/// cell for each of the N (N + 1)/2 coefficients, and 4 N per cell in each workspace. Obtained from
/// [`HalfSpace::preconditioner`](crate::HalfSpace::preconditioner).
#[derive(Debug, Clone)]
pub struct CirculantInverse<const N: usize = 1> {
    product: SingleProduct<N>,
}

impl<const N: usize> CirculantInverse<N> {
    /// On `[nx, ny]` cells, from a symmetric tensor of kernels, with eigenvalues below `floor` raised to
    /// it: wrapping may produce some that no cut of the operator has.
    ///
    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
    pub(crate) fn new(
        size: [usize; 2],
        share: Option<Arc<RowPartition>>,
        kernels: [[&Kernel; N]; N],
        floor: f64,
    ) -> Result<Self> {
        Self::with_mean((size, share), kernels, floor, false)
    }

    /// Creates the inverse for displacements that are known up to a uniform one, on a grid that repeats along y: a mean
    /// weighs as much as the longest wave, whatever the datum of the displacements.
    ///
    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
    pub(crate) fn up_to_mean(
        size: [usize; 2],
        kernels: [[&Kernel; N]; N],
        floor: f64,
    ) -> Result<Self> {
        Self::with_mean((size, None), kernels, floor, true)
    }

    fn with_mean(
        (size, share): ([usize; 2], Option<Arc<RowPartition>>),
        kernels: [[&Kernel; N]; N],
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
        // A single cell that repeats has no wave but the mean: any weight will do.
        let high = if high > 0.0 { high } else { 1.0 };
        // A datum that is too near makes the mean of a grid that repeats along y negative.
        let is_mean_unbounded = repeats == [false, true] && symbol.least_of_mean() <= floor;
        let symbol = if is_up_to_mean {
            symbol.with_mean_of_longest_wave()
        } else if repeats == [true; 2] || is_mean_unbounded {
            symbol.with_mean(high)
        } else {
            symbol
        };
        // Where no bound of the operator is known: far below what the directions have each alone.
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
