//! Tangential problem and its restriction to coarser cells.

use std::borrow::Cow;

use crate::bodies::component::Direction;
use crate::cgm::{
    AbsBound, Ball, CellCompliance, ConstraintSet, LinearisedSet, NormBound, Total, reduce,
};
use crate::contact::{ElasticProblem, ElasticSolver, GridTransfer, MultilevelProblem};
use crate::error::Result;
use crate::memory::fallible::{self, try_each};
use crate::numerics::cell_vector::{at, norm, slices, slices_mut};
use crate::parallel::layout::Layout;
use crate::tangential::friction_limits::is_at_limit;

/// Input of a tangential solve. It consists of friction limits, entry compliances if any, the negated prescribed
/// motion, and the prescribed sums of the tractions along `directions`.
pub(super) struct FrictionProblem<'a, const N: usize> {
    pub(super) directions: [Direction; N],
    pub(super) limits: Cow<'a, [f64]>,
    pub(super) own: CellCompliance<'a>,
    pub(super) linear: [Cow<'a, [f64]>; N],
    pub(super) totals: [Total; N],
}

impl<const N: usize> FrictionProblem<'_, N> {
    /// Returns the sum of the friction limits, a traction times the number of cells.
    fn capacity(&self, layout: &Layout) -> f64 {
        reduce::total(layout, &self.limits)
    }
}

impl<const N: usize> MultilevelProblem<N> for FrictionProblem<'_, N>
where
    NormBound: Ball<N>,
{
    type Set = <NormBound as Ball<N>>::Set;
    type Constraint<'b>
        = AbsBound<'b>
    where
        Self: 'b;

    fn directions(&self) -> [Direction; N] {
        self.directions
    }

    fn problem(&self, solver: &ElasticSolver<Self::Set, N>) -> ElasticProblem<'_, AbsBound<'_>, N> {
        solver
            .problem(slices(&self.linear), AbsBound(&self.limits))
            .own(self.own)
            .totals(self.totals)
    }

    /// Restricts the problem to coarser cells and omits the entry compliances. The sums remain the same fraction of the
    /// friction capacity.
    fn coarsened(&self, levels: GridTransfer<'_>) -> Result<Self> {
        let mut coarse = Self {
            directions: self.directions,
            limits: levels.coarsened(&self.limits)?.into(),
            own: CellCompliance::default(),
            linear: try_each(|n| levels.coarsened(&self.linear[n]).map(Cow::from))?,
            totals: self.totals,
        };
        let [coarse_capacity, capacity] = [
            coarse.capacity(&levels.coarse_layout()),
            self.capacity(&levels.layout()),
        ];
        let part = coarse_capacity / capacity;
        coarse.totals = self.totals.map(|total| total.scaled(part));
        Ok(coarse)
    }

    /// Distributes the sums in proportion to the friction limits. This start is feasible, and it is accurate near
    /// sliding.
    fn plain_start(&self, layout: &Layout) -> Result<[Vec<f64>; N]> {
        let capacity = self.capacity(layout);
        try_each(|n| {
            let fraction = self.totals[n].sum().map_or(0.0, |sum| sum / capacity);
            let parts = self.limits.iter().map(|limit| fraction * limit);
            fallible::collected(self.limits.len(), parts)
        })
    }

    /// Interpolates the tractions in the stick zone and sets the tractions in the slip zone to the limit. The reserve
    /// of a cell is its limit minus its traction. The reserve falls to zero at the edge of the stick zone, as a
    /// pressure falls to zero at the edge of the contact. The stick zone is therefore prolongated like a contact. A
    /// cell with zero interpolated traction receives the direction of the total.
    fn refined_start(
        &self,
        levels: GridTransfer<'_>,
        coarse: &Self,
        answer: &[Vec<f64>; N],
    ) -> Result<[Vec<f64>; N]> {
        let coarse_layout = levels.coarse_layout();
        let overall = answer
            .each_ref()
            .map(|part| reduce::total(&coarse_layout, part));
        let mut start: [_; N] = try_each(|n| levels.refined(&answer[n]))?;
        let answer = slices(answer);
        let reserves = coarse.limits.iter().enumerate();
        let reserves = reserves.map(|(cell, &limit)| reserve(at(&answer, cell), limit));
        let reserves = fallible::collected(coarse.limits.len(), reserves)?;
        let reserves = levels.refined_zone(&reserves)?;
        for (cell, &limit) in self.limits.iter().enumerate() {
            let interpolated = at(&slices(&start), cell);
            let traction = prolongated_traction(interpolated, limit, reserves[cell] > 0.0, overall);
            for (part, value) in start.iter_mut().zip(traction) {
                part[cell] = value;
            }
        }
        if N > 1 {
            // Without this step the deficit of the sums would also move the slipping cells, which would then count as
            // sticking.
            let (sums, limits) = (self.totals.map(Total::sum), AbsBound(&self.limits));
            let sticks = |cell: usize| reserves[cell] > 0.0;
            let parts = slices_mut(&mut start);
            Self::Set::restore(&levels.layout(), parts, &limits, sticks, sums);
        }
        Ok(start)
    }
}

/// Returns the reserve of a cell, the friction limit minus the traction. The reserve is exactly zero at the limit.
pub(crate) fn reserve<const N: usize>(traction: [f64; N], limit: f64) -> f64 {
    let length = norm(traction);
    if is_at_limit(length, limit) {
        0.0
    } else {
        limit - length
    }
}

/// Returns the prolongated traction of a cell within its limit. If the cell slips, the traction is at the limit.
/// `otherwise` is the direction for a cell without interpolated traction.
pub(crate) fn prolongated_traction<const N: usize>(
    interpolated: [f64; N],
    limit: f64,
    sticks: bool,
    otherwise: [f64; N],
) -> [f64; N]
where
    NormBound: Ball<N>,
{
    let direction = if norm(interpolated) > 0.0 {
        interpolated
    } else {
        otherwise
    };
    let (set, length) = (NormBound::of_radius(limit), norm(direction));
    if sticks || length == 0.0 {
        set.project(interpolated)
    } else {
        set.extreme(direction.map(|q| q / length))
    }
}
