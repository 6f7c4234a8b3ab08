//! Product in single precision for any system of units.

use std::ops::Range;

use crate::error::Result;
use crate::fft::plan::{Plan, TaskScratch};
use crate::fft::symbol::Symbol;
use crate::fft::tiles::Tiles;
use crate::fft::torus::TorusLayout;
use crate::parallel::layout::Layout;

/// Plan and symbol in single precision, with the symbol scaled to values of about one.
#[derive(Debug, Clone)]
pub(super) struct SingleProduct<const N: usize> {
    plan: Plan<f32>,
    symbol: Symbol<f32, N>,
    scale: f64,
}

/// Buffers used only for products in single precision. They take 4 bytes per component and per cell of the grid of the
/// preconditioner.
#[derive(Debug, Clone)]
pub(super) struct SingleScratch<const N: usize> {
    pub(super) tiles: Tiles<N>,
    pub(super) scratch: TaskScratch<f32, N>,
}

impl<const N: usize> SingleProduct<N> {
    pub(super) fn new(frame: TorusLayout, symbol: &Symbol<f64, N>) -> Result<Self> {
        let largest = symbol.largest_entry();
        let scale = if largest > 0.0 { largest } else { 1.0 };
        let plan = Plan::new(frame);
        Ok(Self {
            symbol: symbol.map(|value| value / scale)?,
            scale: scale / plan.cells_of_torus(),
            plan,
        })
    }

    pub(super) fn cells(&self) -> usize {
        self.plan.cells()
    }

    pub(super) fn layout(&self) -> Layout {
        self.plan.layout()
    }

    pub(super) fn buffers(&self) -> Result<SingleScratch<N>> {
        Ok(SingleScratch {
            tiles: self.plan.tiles_of_products()?,
            scratch: self.scratch()?,
        })
    }

    pub(super) fn scratch(&self) -> Result<TaskScratch<f32, N>> {
        self.plan.scratch()
    }

    /// Computes the product with the input scaled to values of about one. In some systems of units the
    /// squares of the input, or the results, would otherwise exceed the range of single precision.
    pub(super) fn apply(
        &self,
        x: [&[f64]; N],
        out: [&mut [f64]; N],
        tiles: &mut Tiles<N>,
        scratch: &TaskScratch<f32, N>,
    ) {
        let layout = self.layout();
        let largest = largest_magnitude(&layout, x);
        if largest.is_normal() {
            let scales = [1.0 / largest, largest * self.scale];
            self.plan
                .convolve(&self.symbol, x, out, scales, tiles, scratch);
        } else {
            // The input is zero or cannot be scaled. Invalid input gives NaN.
            let is_nothing = |x: &[f64]| x.iter().all(|x| x.abs() < f64::MIN_POSITIVE);
            let is_broken = x.iter().any(|x| !is_nothing(x));
            let value = if self.plan.frame.over_ranks(is_broken, |a, b| a || b) {
                f64::NAN
            } else {
                0.0
            };
            for out in out {
                out.fill(value);
            }
        }
    }
}

/// Returns the maximum of `|x|` over the entries of all components that are not NaN. A single reduction over
/// the ranks suffices.
fn largest_magnitude<const N: usize>(layout: &Layout, x: [&[f64]; N]) -> f64 {
    let leaf = |range: Range<usize>| {
        let of = |x: &[f64]| largest_of(&x[range.clone()]);
        x.map(of).into_iter().fold(0.0, larger)
    };
    layout.fold(leaf, larger)
}

/// Returns the maximum over one slice. The slice is divided into lanes for vector comparisons.
fn largest_of(x: &[f64]) -> f64 {
    let mut lanes = [0.0; 8];
    let groups = x.chunks_exact(8);
    let rest = groups.remainder().iter().map(|x| x.abs());
    let rest = rest.fold(0.0, larger);
    for group in groups {
        for (lane, x) in lanes.iter_mut().zip(group) {
            *lane = larger(*lane, x.abs());
        }
    }
    lanes.into_iter().fold(rest, larger)
}

/// Returns the larger number, or the first if the second is NaN.
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}
