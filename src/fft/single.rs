//! A product in single precision, safe in any unit system.

use std::ops::Range;

use crate::fft::plan::{Buffers, Plan};
use crate::fft::spectrum::Spectrum;
use crate::parallel;

/// Plan and spectrum in single precision, the spectrum scaled to values about one.
#[derive(Debug, Clone)]
pub(super) struct SingleProduct {
    plan: Plan<f32>,
    spectrum: Spectrum<f32>,
    scale: f64,
}

/// Buffers of products in single precision: 16 bytes per cell.
#[derive(Debug)]
pub struct SingleWorkspace(Buffers<f32>);

impl SingleProduct {
    /// With the spectrum `f(value)` of each value of a spectrum in double precision.
    pub(super) fn new(
        size: [usize; 2],
        torus: [usize; 2],
        spectrum: &Spectrum<f64>,
        f: impl Fn(f64) -> f64,
    ) -> Self {
        let [low, high] = spectrum.extremes();
        let largest = f(low).abs().max(f(high).abs());
        let scale = if largest > 0.0 { largest } else { 1.0 };
        Self {
            plan: Plan::new(size, torus),
            spectrum: spectrum.map(|value| f(value) / scale),
            scale: scale / (torus[0] * torus[1]) as f64,
        }
    }

    pub(super) fn len(&self) -> usize {
        self.plan.nx * self.plan.ny
    }

    pub(super) fn workspace(&self) -> SingleWorkspace {
        SingleWorkspace(self.plan.workspace())
    }

    /// Scales the input to values about one: in some unit systems its squares, or the results,
    /// would not fit single precision.
    pub(super) fn apply(&self, x: &[f64], out: &mut [f64], workspace: &mut SingleWorkspace) {
        let largest = largest_magnitude(x);
        if largest.is_normal() {
            let scales = [1.0 / largest, largest * self.scale];
            self.plan
                .convolve(&self.spectrum, x, out, scales, &mut workspace.0);
        } else {
            // Nothing, or nothing that could be scaled; a broken input stays broken.
            out.fill(if largest < 1.0 { 0.0 } else { f64::NAN });
        }
    }
}

/// `max |x|`; NaN if any entry is. Magnitudes order as their bits do, with NaN above all, and
/// whole numbers compare many at a time.
fn largest_magnitude(x: &[f64]) -> f64 {
    let leaf = |range: Range<usize>| {
        x[range]
            .iter()
            .map(|x: &f64| x.abs().to_bits())
            .fold(0, u64::max)
    };
    f64::from_bits(parallel::fold(x.len(), leaf, u64::max))
}
