//! The normal problem on coarser cells.

use crate::cgm::{NonNegative, Settings};
use crate::error::Result;
use crate::half_space::HalfSpace;
use crate::influence::Direction;
use crate::stage::{Nested, Observer, Stage};
use crate::window::{coarsened, refined};

/// The gap from a datum: all a pressure has to know.
pub(super) struct PressureScene {
    pub(super) linear: Vec<f64>,
}

impl Nested for PressureScene {
    type Stage = Stage;
    type Total = Option<f64>;

    fn coarse_scene(&self, size: [usize; 2]) -> Self {
        Self {
            linear: coarsened(size, &self.linear),
        }
    }

    fn coarse_total(&self, _: &Self, total: Option<f64>) -> Option<f64> {
        total.map(|total| 0.25 * total)
    }

    /// Uniform pressure under a force, none under an approach.
    fn plain_start(&self, total: Option<f64>) -> Vec<f64> {
        let cells = self.linear.len();
        vec![total.unwrap_or(0.0) / cells as f64; cells]
    }

    fn refined_start(&self, size: [usize; 2], _: &Self, answer: &[f64]) -> Vec<f64> {
        refined(size, answer)
    }

    fn stage(&self, bodies: &HalfSpace, size: [usize; 2], start: Vec<f64>) -> Result<Stage> {
        Stage::with_start(bodies, Direction::Z, size, &self.linear, start)
    }

    fn minimise(
        &self,
        stage: &mut Stage,
        total: Option<f64>,
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        stage.minimise(NonNegative, total, settings, observer)
    }

    fn answer(stage: &Stage) -> &[f64] {
        &stage.x
    }
}
