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

/// Buffers of products in single precision: 8 bytes per cell for an operator, 4 for a preconditioner.
#[derive(Debug, Clone)]
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
            let is_nothing = x.iter().all(|x| x.abs() < f64::MIN_POSITIVE);
            out.fill(if is_nothing { 0.0 } else { f64::NAN });
        }
    }
}

/// `max |x|` of the entries that are numbers; in lanes, so that many compare at a time.
pub(super) fn largest_magnitude(x: &[f64]) -> f64 {
    let larger = |a: f64, b: f64| if b > a { b } else { a };
    let leaf = |range: Range<usize>| {
        let mut lanes = [0.0; 8];
        let groups = x[range].chunks_exact(8);
        let rest = groups.remainder().iter().map(|x| x.abs());
        let rest = rest.fold(0.0, larger);
        for group in groups {
            for (lane, x) in lanes.iter_mut().zip(group) {
                *lane = larger(*lane, x.abs());
            }
        }
        lanes.into_iter().fold(rest, larger)
    };
    parallel::fold(x.len(), leaf, larger)
}
