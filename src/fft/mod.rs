//! Fast convolution of a traction field with an influence coefficient.
//!
//! The displacement of a cell is the sum of the tractions of all cells, each multiplied by the coefficient at the distance
//! between the two cells. This is a discrete convolution. It is computed by real Fourier transforms on a grid padded with
//! zeros to at least `2 n - 1` cells per axis, so that no image of the contact wraps around (Liu, Wang & Liu, Wear 243
//! (2000) 101, <https://doi.org/10.1016/S0043-1648(00)00427-0>).
//!
//! - [`Convolution`] is the operator of a half-space, free (padded with zeros) or periodic (not padded), exact up to
//!   round-off.
//! - [`CirculantInverse`] is a preconditioner: the approximate inverse on the grid and two cells beyond its edge, exact on a
//!   periodic grid.
//!
//! The transforms use AVX or NEON if the processor supports it. Transforms for processors that support only SSE (from before
//! 2013) take long to compile and are not included. A program that needs these transforms can enable the feature `sse` of
//! `rustfft`.

mod aligned;
mod circulant_inverse;
mod columns;
mod convolution;
mod eigenvalues;
mod exchange;
mod length;
mod plan;
mod precision;
mod rows;
mod single_precision;
mod spectrum;
mod superposition;
mod symbol;
mod tiles;
mod torus;
mod uniform_wave;

pub use circulant_inverse::CirculantInverse;
pub use convolution::Convolution;
pub(crate) use convolution::samples;
pub(crate) use length::smooth_length;
pub(crate) use superposition::{Kernels, Superposition, Torus};
pub(crate) use uniform_wave::UniformWave;
