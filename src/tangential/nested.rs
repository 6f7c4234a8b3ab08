//! The tangential problem on coarser cells.

use crate::cgm::plane::{Disc, norm};
use crate::cgm::{Magnitude, Settings};
use crate::error::Result;
use crate::half_space::HalfSpace;
use crate::influence::Direction;
use crate::stage::{Nested, Observer, PlaneStage, Stage};
use crate::window::{coarsened, refined};

/// What friction holds, as a traction times cells.
fn capacity(limits: &[f64]) -> f64 {
    limits.iter().sum()
}

/// A total spread in proportion to the limits: feasible, and close near sliding.
fn in_proportion(limits: &[f64], total: Option<f64>) -> Vec<f64> {
    let fraction = total.map_or(0.0, |total| total / capacity(limits));
    limits.iter().map(|limit| fraction * limit).collect()
}

/// Friction limits, and minus the shift where that is prescribed.
pub(super) struct FrictionScene {
    pub(super) direction: Direction,
    pub(super) limits: Vec<f64>,
    pub(super) linear: Vec<f64>,
}

impl Nested for FrictionScene {
    type Stage = Stage;
    type Total = Option<f64>;

    fn coarse_scene(&self, size: [usize; 2]) -> Self {
        Self {
            direction: self.direction,
            limits: coarsened(size, &self.limits),
            linear: coarsened(size, &self.linear),
        }
    }

    /// The same part of what friction holds.
    fn coarse_total(&self, coarse: &Self, total: Option<f64>) -> Option<f64> {
        let ratio = capacity(&coarse.limits) / capacity(&self.limits);
        total.map(|total| total * ratio)
    }

    fn plain_start(&self, total: Option<f64>) -> Vec<f64> {
        in_proportion(&self.limits, total)
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

    fn stage(&self, bodies: &HalfSpace, size: [usize; 2], start: Vec<f64>) -> Result<Stage> {
        Stage::with_start(bodies, self.direction, size, &self.linear, start)
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

    fn answer(stage: &Stage) -> &[f64] {
        &stage.x
    }
}

/// Friction limits, and minus the motion where that is prescribed, of both tractions in the plane.
pub(super) struct PlaneScene {
    pub(super) limits: Vec<f64>,
    pub(super) linear: Vec<f64>,
}

/// A function of each component of a vector of the plane.
fn by_component(vector: &[f64], f: impl Fn(&[f64]) -> Vec<f64>) -> Vec<f64> {
    let (x, y) = vector.split_at(vector.len() / 2);
    [f(x), f(y)].concat()
}

impl Nested for PlaneScene {
    type Stage = PlaneStage;
    type Total = [Option<f64>; 2];

    fn coarse_scene(&self, size: [usize; 2]) -> Self {
        Self {
            limits: coarsened(size, &self.limits),
            linear: by_component(&self.linear, |linear| coarsened(size, linear)),
        }
    }

    /// The same part of what friction holds.
    fn coarse_total(&self, coarse: &Self, totals: [Option<f64>; 2]) -> [Option<f64>; 2] {
        let ratio = capacity(&coarse.limits) / capacity(&self.limits);
        totals.map(|total| total.map(|total| total * ratio))
    }

    fn plain_start(&self, totals: [Option<f64>; 2]) -> Vec<f64> {
        totals
            .map(|total| in_proportion(&self.limits, total))
            .concat()
    }

    /// Interpolated; at the limit where the coarse cell slips or is apart, and in the direction of the whole
    /// where there is none to interpolate.
    fn refined_start(&self, size: [usize; 2], coarse: &Self, answer: &[f64]) -> Vec<f64> {
        let mut start = by_component(answer, |component| refined(size, component));
        let (cells, coarse_cells) = (self.limits.len(), coarse.limits.len());
        let columns = size[0].div_ceil(2);
        let (answer_x, answer_y) = answer.split_at(coarse_cells);
        let overall = [answer_x, answer_y].map(|component| component.iter().sum::<f64>());
        let (x, y) = start.split_at_mut(cells);
        for (cell, (x, y)) in x.iter_mut().zip(y).enumerate() {
            let parent = (cell / size[0] / 2) * columns + cell % size[0] / 2;
            let at_parent = [answer_x[parent], answer_y[parent]];
            let (disc, parents) = (Disc(self.limits[cell]), Disc(coarse.limits[parent]));
            let at_cell = [*x, *y];
            let direction = if norm(at_cell) > 0.0 {
                at_cell
            } else {
                overall
            };
            let length = norm(direction);
            [*x, *y] = if parents.is_at_limit(at_parent) && length > 0.0 {
                direction.map(|q| q * (disc.0 / length))
            } else {
                disc.project(at_cell)
            };
        }
        start
    }

    fn stage(&self, bodies: &HalfSpace, size: [usize; 2], start: Vec<f64>) -> Result<PlaneStage> {
        let mut stage = PlaneStage::new(bodies, size)?;
        stage.linear.copy_from_slice(&self.linear);
        stage.q = start;
        Ok(stage)
    }

    fn minimise(
        &self,
        stage: &mut PlaneStage,
        totals: [Option<f64>; 2],
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        stage.minimise(&self.limits, totals, settings, observer)
    }

    fn answer(stage: &PlaneStage) -> &[f64] {
        &stage.q
    }
}
