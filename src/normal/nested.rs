//! The normal problem on coarser cells.

use crate::buffer;
use crate::cascade::{Levels, Scene};
use crate::cgm::{Carried, Constraint, Interval, Total};
use crate::error::Result;
use crate::half_space::{HalfSpace, Region};
use crate::influence::Direction;
use crate::per_cell::PerCell;

/// How many times the cells of a coarse window a grid has at least: operators of the grid are kept, those of windows are
/// made for one solve.
const FEW: usize = 4;

/// The gap from a datum, the largest pressures, and their sum: all a normal contact depends on.
pub(super) struct PressureScene {
    pub(super) linear: Vec<f64>,
    pub(super) limits: PerCell<Vec<f64>>,
    pub(super) total: Total,
    /// Cells of all ranks together.
    pub(super) cells: usize,
}

impl Scene<1> for PressureScene {
    type Set = Interval;

    fn directions(&self) -> [Direction; 1] {
        [Direction::Z]
    }

    fn constraint(&self) -> impl Constraint<1, Set = Interval> {
        Carried(self.limits.map(Vec::as_slice))
    }

    fn linear(&self) -> [&[f64]; 1] {
        [&self.linear]
    }

    fn totals(&self) -> [Total; 1] {
        [self.total]
    }

    fn coarsened(&self, levels: Levels<'_>) -> Result<Self> {
        Ok(Self {
            linear: levels.coarsened(&self.linear)?,
            limits: self.limits.try_map(|limits| levels.coarsened(limits))?,
            cells: levels.coarse_layout().of_all_ranks(),
            total: self.total.scaled(0.25),
        })
    }

    /// Around the pressure, with room for it to spread.
    fn confined(
        &self,
        bodies: &HalfSpace,
        [start]: &[Vec<f64>; 1],
    ) -> Result<Option<(Region, Self)>> {
        let grid = bodies.grid();
        let contact = bodies.around(|i| start[i] > 0.0);
        let window = contact.map(|contact| bodies.confined(contact.widened(grid)));
        let Some(window) = window.filter(|window| FEW * window.cells() <= grid.whole().cells())
        else {
            return Ok(None);
        };
        let region = Region::new(bodies, window);
        let inside = |whole: &Vec<f64>| {
            let mut part = buffer::zeros(region.cells())?;
            region.gather(whole, &mut part);
            Ok(part)
        };
        let part = Self {
            linear: inside(&self.linear)?,
            limits: self.limits.try_map(inside)?,
            total: self.total,
            cells: window.cells(),
        };
        Ok(Some((region, part)))
    }

    /// Uniform pressure under a force, zero under an approach.
    fn plain_start(&self) -> Result<[Vec<f64>; 1]> {
        let mean = self.total.sum().unwrap_or(0.0) / self.cells as f64;
        Ok([buffer::filled(mean, self.linear.len())?])
    }

    fn refined_start(
        &self,
        levels: Levels<'_>,
        _: &Self,
        [answer]: &[Vec<f64>; 1],
    ) -> Result<[Vec<f64>; 1]> {
        Ok([levels.refined(answer)?])
    }
}
