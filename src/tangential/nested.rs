//! The tangential problem on coarser cells.

use crate::cgm::{Magnitude, Settings};
use crate::error::Result;
use crate::stage::{Nested, Observer, Stage};
use crate::window::{coarsened, refined};

/// Friction limits, and minus the shift where that is prescribed.
pub(super) struct FrictionScene {
    pub(super) limits: Vec<f64>,
    pub(super) linear: Vec<f64>,
}

impl FrictionScene {
    fn capacity(&self) -> f64 {
        self.limits.iter().sum()
    }
}

impl Nested for FrictionScene {
    fn coarse_scene(&self, size: [usize; 2]) -> Self {
        Self {
            limits: coarsened(size, &self.limits),
            linear: coarsened(size, &self.linear),
        }
    }

    /// The same part of what friction holds.
    fn coarse_total(&self, coarse: &Self, total: f64) -> f64 {
        total * (coarse.capacity() / self.capacity())
    }

    fn linear(&self) -> &[f64] {
        &self.linear
    }

    /// In proportion to the limits: feasible, and close near sliding.
    fn plain_start(&self, total: Option<f64>) -> Vec<f64> {
        let fraction = total.map_or(0.0, |total| total / self.capacity());
        self.limits.iter().map(|limit| fraction * limit).collect()
    }

    /// Interpolated where the coarse cell sticks, at the limit where it slips or is apart: the zone
    /// is handed down with the traction.
    fn refined_start(&self, size: [usize; 2], coarse: &Self, answer: &[f64]) -> Vec<f64> {
        let direction = answer.iter().sum::<f64>();
        let slipping = |traction: f64, limit: f64| traction.abs() >= limit;
        let columns = size[0].div_ceil(2);
        let mut start = refined(size, answer);
        for (cell, (traction, &limit)) in start.iter_mut().zip(&self.limits).enumerate() {
            let parent = (cell / size[0] / 2) * columns + cell % size[0] / 2;
            let at_parent = answer[parent];
            *traction = if slipping(at_parent, coarse.limits[parent]) {
                limit.copysign(if at_parent == 0.0 {
                    direction
                } else {
                    at_parent
                })
            } else {
                traction.clamp(-limit, limit)
            };
        }
        start
    }

    fn minimise(
        &self,
        stage: &mut Stage,
        total: Option<f64>,
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        stage.minimise(Magnitude(&self.limits), total, settings, observer)
    }
}
