//! The tangential problem on coarser cells.

use std::borrow::Cow;

use crate::buffer::{self, try_each};
use crate::cascade::{Levels, Scene};
use crate::cgm::vector::{at, norm, slices, slices_mut};
use crate::cgm::{Admissible, Ball, Constraint, Linearised, Magnitude, Total, Within, reduce};
use crate::error::Result;
use crate::influence::Direction;
use crate::layout::Layout;
use crate::tangential::limits::is_at_limit;

/// Friction limits, minus the prescribed motion, and the prescribed sums of the tractions along `directions`.
pub(super) struct FrictionScene<'a, const N: usize> {
    pub(super) layout: Layout,
    pub(super) directions: [Direction; N],
    pub(super) limits: Cow<'a, [f64]>,
    pub(super) linear: [Cow<'a, [f64]>; N],
    pub(super) totals: [Total; N],
}

impl<const N: usize> FrictionScene<'_, N> {
    /// What friction holds, as a traction times cells.
    fn capacity(&self) -> f64 {
        reduce::total(&self.layout, &self.limits)
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
    fn coarsened(&self, levels: Levels<'_>) -> Result<Self> {
        let mut coarse = Self {
            layout: levels.coarse_layout(),
            directions: self.directions,
            limits: levels.coarsened(&self.limits)?.into(),
            linear: try_each(|n| levels.coarsened(&self.linear[n]).map(Cow::from))?,
            totals: self.totals,
        };
        let part = coarse.capacity() / self.capacity();
        coarse.totals = self.totals.map(|total| total.scaled(part));
        Ok(coarse)
    }

    /// The sums spread in proportion to the limits: feasible, and close near sliding.
    fn plain_start(&self) -> Result<[Vec<f64>; N]> {
        let capacity = self.capacity();
        try_each(|n| {
            let fraction = self.totals[n].sum().map_or(0.0, |sum| sum / capacity);
            let parts = self.limits.iter().map(|limit| fraction * limit);
            buffer::collected(self.limits.len(), parts)
        })
    }

    /// Interpolated where the coarse cell sticks, at the limit where it slips or is apart: the zone is handed down
    /// with the traction. The direction is that of the whole where the interpolated traction is zero.
    fn refined_start(
        &self,
        levels: Levels<'_>,
        coarse: &Self,
        answer: &[Vec<f64>; N],
    ) -> Result<[Vec<f64>; N]> {
        let overall = answer
            .each_ref()
            .map(|part| reduce::total(&coarse.layout, part));
        let mut start: [_; N] = try_each(|n| levels.refined(&answer[n]))?;
        let answer = slices(answer);
        let at_limit = (0..coarse.limits.len())
            .map(|cell| is_at_limit(norm(at(&answer, cell)), coarse.limits[cell]));
        let slips = levels.inherited(at_limit)?;
        for (cell, &limit) in self.limits.iter().enumerate() {
            let interpolated = at(&slices(&start), cell);
            let direction = if norm(interpolated) > 0.0 {
                interpolated
            } else {
                overall
            };
            let length = norm(direction);
            let set = Within::of_radius(limit);
            let traction = if slips[cell] && length > 0.0 {
                set.extreme(direction.map(|q| q / length))
            } else {
                set.project(interpolated)
            };
            for (part, value) in start.iter_mut().zip(traction) {
                part[cell] = value;
            }
        }
        if N > 1 {
            // Else what is missing of the sums would move the slipping cells too, and they would count as sticking.
            let sums = self.totals.map(Total::sum);
            let sticks = |cell: usize| !slips[cell];
            let parts = slices_mut(&mut start);
            Self::Set::restore(&self.layout, parts, &self.constraint(), sticks, sums);
        }
        Ok(start)
    }
}
