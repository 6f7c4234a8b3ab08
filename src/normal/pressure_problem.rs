//! Input of the pressure solve, and its restriction to coarser cells.

use std::borrow::Cow;

use crate::bodies::component::Direction;
use crate::cgm::{BoundedPressure, Interval, Total};
use crate::contact::{
    ElasticProblem, ElasticSolver, GridTransfer, LoadIncrement, LoadPoint, MultilevelProblem,
};
use crate::error::Result;
use crate::grid::per_cell::PerCell;
use crate::half_space::{HalfSpace, Region};
use crate::memory::fallible;
use crate::parallel::layout::Layout;

/// Least ratio of the cells of the grid to the cells of a coarse window. At this ratio or a larger ratio, a nested
/// start uses the window instead of the grid. Operators of the whole grid are cached, whereas operators of such windows
/// are created for one solve.
const FEW: usize = 4;

/// Relative change of a load below which it counts as round-off.
const NO_CHANGE: f64 = 1e-12;

/// Gap, pressure limits and load of a pressure solve.
#[derive(Debug, Clone, Copy)]
pub(super) struct PressureProblem<C> {
    pub(super) gap: C,
    /// Datum of the gap: the least gap under a prescribed force, or the prescribed approach.
    pub(super) datum: f64,
    /// Largest pressure that each cell can carry.
    pub(super) limits: PerCell<C>,
    /// Sum of the pressures if the force is prescribed.
    pub(super) total: Total,
}

impl<C: AsRef<[f64]>> PressureProblem<C> {
    pub(super) fn constraint(&self) -> BoundedPressure<'_> {
        BoundedPressure(self.limits.map(C::as_ref))
    }

    /// Returns the quadratic program to minimise.
    pub(super) fn problem(
        &self,
        solver: &ElasticSolver<Interval, 1>,
    ) -> ElasticProblem<'_, BoundedPressure<'_>, 1> {
        solver
            .problem([self.gap.as_ref()], self.constraint())
            .datum([self.datum])
            .totals([self.total])
    }

    /// Returns the change of load from `reached` to the prescribed load, or [`LoadIncrement::Nothing`] if the change is
    /// round-off.
    pub(super) fn remaining_load(&self, reached: LoadPoint) -> LoadIncrement {
        let beyond = |wanted: f64, reached: f64| {
            let ahead = wanted - reached;
            (ahead.abs() > NO_CHANGE * wanted.abs()).then_some(ahead)
        };
        let ahead = match self.total {
            Total::Sum(sum) => beyond(sum, reached[0]).map(LoadIncrement::Total),
            _ => beyond(self.datum, reached[1]).map(LoadIncrement::Motion),
        };
        ahead.unwrap_or(LoadIncrement::Nothing)
    }
}

impl MultilevelProblem<1> for PressureProblem<Cow<'_, [f64]>> {
    type Set = Interval;
    type Constraint<'a>
        = BoundedPressure<'a>
    where
        Self: 'a;

    fn directions(&self) -> [Direction; 1] {
        [Direction::Z]
    }

    fn problem(
        &self,
        solver: &ElasticSolver<Interval, 1>,
    ) -> ElasticProblem<'_, BoundedPressure<'_>, 1> {
        self.problem(solver)
    }

    fn coarsened(&self, levels: GridTransfer<'_>) -> Result<Self> {
        Ok(Self {
            gap: Cow::Owned(levels.coarsened(&self.gap)?),
            limits: self
                .limits
                .try_map(|limits| levels.coarsened(limits).map(Cow::Owned))?,
            total: self.total.scaled(levels.part_of_area()),
            ..*self
        })
    }

    /// Restricts the problem to a window around the pressure, with room for the contact to spread.
    fn restrict_to_window(
        &self,
        bodies: &HalfSpace,
        [start]: &[Vec<f64>; 1],
    ) -> Result<Option<(Region, Self)>> {
        let grid = bodies.grid();
        let contact = bodies.around(|i| start[i] > 0.0);
        let window = contact.map(|contact| bodies.restrict_to_window(contact.widened(grid)));
        let Some(window) = window.filter(|window| FEW * window.cells() <= grid.whole().cells())
        else {
            return Ok(None);
        };
        let region = Region::new(bodies, window);
        let inside = |whole: &Cow<'_, [f64]>| {
            let mut part = fallible::zeros(region.cells())?;
            region.gather(whole, &mut part);
            Ok(Cow::Owned(part))
        };
        let part = Self {
            gap: inside(&self.gap)?,
            limits: self.limits.try_map(inside)?,
            ..*self
        };
        Ok(Some((region, part)))
    }

    /// Returns a uniform pressure under a force and zero under an approach.
    fn plain_start(&self, layout: &Layout) -> Result<[Vec<f64>; 1]> {
        let mean = self.total.sum().unwrap_or(0.0) / layout.of_all_ranks() as f64;
        Ok([fallible::filled(mean, self.gap.len())?])
    }

    fn refined_start(
        &self,
        levels: GridTransfer<'_>,
        _: &Self,
        [answer]: &[Vec<f64>; 1],
    ) -> Result<[Vec<f64>; 1]> {
        Ok([levels.refined_zone(answer)?])
    }
}
