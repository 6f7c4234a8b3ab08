//! The tangential problem on coarser cells.

use std::borrow::Cow;

use crate::cascade::Scene;
use crate::cgm::vector::{at, norm, slices};
use crate::cgm::{Admissible, Ball, Constraint, Linearised, Magnitude, Total, Within, reduce};
use crate::influence::Direction;
use crate::tangential::limits::is_at_limit;
use crate::window::{coarsened, refined};

/// Friction limits, minus the prescribed motion, and the prescribed sums of the tractions along `directions`.
pub(super) struct FrictionScene<'a, const N: usize> {
    pub(super) directions: [Direction; N],
    pub(super) limits: Cow<'a, [f64]>,
    pub(super) linear: [Cow<'a, [f64]>; N],
    pub(super) totals: [Total; N],
}

impl<const N: usize> FrictionScene<'_, N> {
    /// What friction holds, as a traction times cells.
    fn capacity(&self) -> f64 {
        reduce::total(&self.limits)
    }
}

impl<const N: usize> Scene<N> for FrictionScene<'_, N>
where
    Within: Ball<N>,
{
    type Set = <Within as Ball<N>>::Set;

    fn directions(&self) -> [Direction; N] {
        self.directions
    }

    fn constraint(&self) -> impl Constraint<N, Set = Self::Set> {
        Magnitude(&self.limits)
    }

    fn linear(&self) -> [&[f64]; N] {
        slices(&self.linear)
    }

    fn totals(&self) -> [Total; N] {
        self.totals
    }

    /// With sums that are the same part of what friction holds.
    fn coarsened(&self, size: [usize; 2]) -> Self {
        let linear = self.linear.each_ref();
        let mut coarse = Self {
            directions: self.directions,
            limits: coarsened(size, &self.limits).into(),
            linear: linear.map(|linear| coarsened(size, linear).into()),
            totals: self.totals,
        };
        let part = coarse.capacity() / self.capacity();
        coarse.totals = self.totals.map(|total| total.scaled(part));
        coarse
    }

    /// The sums spread in proportion to the limits: feasible, and close near sliding.
    fn plain_start(&self) -> [Vec<f64>; N] {
        let capacity = self.capacity();
        self.totals.map(|total| {
            let fraction = total.sum().map_or(0.0, |sum| sum / capacity);
            self.limits.iter().map(|limit| fraction * limit).collect()
        })
    }

    /// Interpolated where the coarse cell sticks, at the limit where it slips or is apart: the zone is handed down
    /// with the traction. The direction is that of the whole where the interpolated traction is zero.
    fn refined_start(
        &self,
        size: [usize; 2],
        coarse: &Self,
        answer: &[Vec<f64>; N],
    ) -> [Vec<f64>; N] {
        let overall = answer.each_ref().map(|part| reduce::total(part));
        let mut start = answer.each_ref().map(|part| refined(size, part));
        let (answer, columns) = (slices(answer), size[0].div_ceil(2));
        for (cell, &limit) in self.limits.iter().enumerate() {
            let parent = (cell / size[0] / 2) * columns + cell % size[0] / 2;
            let interpolated = at(&slices(&start), cell);
            let direction = if norm(interpolated) > 0.0 {
                interpolated
            } else {
                overall
            };
            let length = norm(direction);
            let slips = is_at_limit(norm(at(&answer, parent)), coarse.limits[parent]);
            let set = Within::of_radius(limit);
            let traction = if slips && length > 0.0 {
                set.extreme(direction.map(|q| q / length))
            } else {
                set.project(interpolated)
            };
            for (part, value) in start.iter_mut().zip(traction) {
                part[cell] = value;
            }
        }
        start
    }
}
