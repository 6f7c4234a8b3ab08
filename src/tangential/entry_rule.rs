//! Friction law of cells that come into contact within a step.

use crate::bodies::material::ElasticPair;
use crate::cgm::{CellCompliance, reduce};
use crate::error::Result;
use crate::grid::Grid;
use crate::half_space::{HalfSpace, Region};
use crate::memory::fallible;
use crate::parallel::layout::Layout;
use crate::tangential::Axis;

/// Motion that a cell follows if it comes into contact within a step.
///
/// The documentation of [`history`](crate::history#entry-rule) derives [`Self::SinceTouch`] and compares the two rules.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum EntryRule {
    /// The cell follows the motion from the moment of touch, while its pressure grows. It lags behind the motion by
    /// $`\kappa\,(g/p)\,q`$. Here g is the gap at the start of the step. The pressure p and the traction q are the
    /// values at the end of the step.
    #[default]
    SinceTouch,
    /// The cell follows the motion of the whole step, including the part before it touches. Codes that use only the
    /// start of the step, such as CONTACT, follow this rule. If the contact grows, the error is of first order in the
    /// length of the steps.
    WholeStep,
}

/// Returns $`\kappa = 1 + c_l / 2 c_n`$ with $`c_n = \sum (1 - \nu)/G`$ and $`c_l = \sum \nu/G`$. It is the ratio of
/// the tangential to the normal displacement of a cell under an equal traction and pressure on the cell. For coated and
/// uncoated bodies it is the mean of both [directions](ratios_of_compliances).
pub(crate) fn ratio_of_compliances(bodies: &HalfSpace) -> f64 {
    if bodies.pair().is_coated() {
        let [along, across] = ratios_of_compliances(bodies.pair(), bodies.grid());
        return 0.5 * (along + across);
    }
    let compliances = bodies.pair().compliances();
    1.0 + 0.5 * compliances.lateral / compliances.normal
}

/// Returns the ratios of compliances $`1`$ and $`1 + c_l/c_n`$. The first holds across an edge of the contact (plane
/// strain), and the second along the edge (antiplane strain). For coated bodies the ratios are $`C_l/C_n`$ and
/// $`C_t/C_n`$ of the waves whose half-length is the longer side of a cell.
pub(crate) fn ratios_of_compliances(pair: &ElasticPair, grid: Grid) -> [f64; 2] {
    if pair.is_coated() {
        let found = pair.times_k(std::f64::consts::PI / grid.dx().max(grid.dy()));
        return [found.along, found.across].map(|tangential| tangential / found.normal);
    }
    let compliances = pair.compliances();
    [1.0, 1.0 + compliances.lateral / compliances.normal]
}

/// Returns the entry compliance $`B = \kappa\,g/p`$ of a cell with `closing` $`= \kappa g`$, or zero without pressure.
pub(crate) fn entry_compliance(closing: f64, pressure: f64) -> f64 {
    if pressure > 0.0 {
        (closing / pressure).min(f64::MAX)
    } else {
        0.0
    }
}

/// Entry compliance of a cell, a symmetric tensor.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EntryCompliance {
    pub(crate) xx: f64,
    pub(crate) xy: f64,
    pub(crate) yy: f64,
}

impl EntryCompliance {
    pub(crate) const NONE: Self = Self {
        xx: 0.0,
        xy: 0.0,
        yy: 0.0,
    };

    /// Returns the mean over all directions.
    pub(crate) fn mean(&self) -> f64 {
        0.5 * self.xx + 0.5 * self.yy
    }

    /// Returns `[a, b]` of the deviator, the matrix with the rows `[a, b]` and `[b, -a]`.
    pub(crate) fn deviator(&self) -> [f64; 2] {
        [0.5 * self.xx - 0.5 * self.yy, self.xy]
    }
}

/// Entry compliances of the cells of a region in one step.
#[derive(Debug, Clone, Default)]
pub(crate) struct EntryCompliances {
    /// Mean over all directions. Empty if no cell comes into contact.
    pub(crate) mean: Vec<f64>,
    /// Deviators in the plane. `[a, b]` is the matrix with the rows `[a, b]` and `[b, -a]`. The vector is empty if the
    /// compliances are the same in all directions.
    pub(crate) deviator: Vec<[f64; 2]>,
    /// Whether a cell of any rank may come into contact in the step.
    pub(crate) is_active: bool,
}

impl EntryCompliances {
    /// Sets the entry compliance $`B = \kappa\,g/p`$ of each cell. `gap` returns the gap of each cell of the grid at the
    /// start of the step. The gap of a cell in the earlier contact is zero. `pressure` is a function of a cell of the
    /// region.
    pub(crate) fn set(
        &mut self,
        bodies: &HalfSpace,
        region: &Region,
        gap: impl Fn(usize) -> f64,
        pressure: impl Fn(usize) -> f64,
    ) -> Result<()> {
        let kappa = ratio_of_compliances(bodies);
        fallible::resize(&mut self.mean, region.cells(), 0.0)?;
        region.collect(|cell| kappa * gap(cell), &mut self.mean);
        for (k, value) in self.mean.iter_mut().enumerate() {
            *value = entry_compliance(*value, pressure(k));
        }
        self.deviator.clear();
        self.is_active = true;
        Ok(())
    }

    /// Sets the entry compliances for rolling, which depend on the direction. `of` returns the compliance of a cell, given
    /// its index in the region and its index in the grid.
    pub(crate) fn set_rolling(
        &mut self,
        axes: &[Axis],
        region: &Region,
        of: impl Fn(usize, usize) -> EntryCompliance,
    ) -> Result<()> {
        let cells = region.cells();
        self.clear();
        fallible::make_room(&mut self.mean, cells)?;
        if axes == Axis::BOTH {
            fallible::make_room(&mut self.deviator, cells)?;
        }
        for (k, index) in region.own().indices().enumerate() {
            let own = of(k, index);
            match axes {
                [Axis::X] => self.mean.push(own.xx),
                [Axis::Y] => self.mean.push(own.yy),
                _ => {
                    self.mean.push(own.mean());
                    self.deviator.push(own.deviator());
                }
            }
        }
        self.is_active = true;
        Ok(())
    }

    /// Removes all compliances, because no cell comes into contact in the step.
    pub(crate) fn clear(&mut self) {
        self.is_active = false;
        self.mean.clear();
        self.deviator.clear();
    }

    /// Removes all compliances if they are zero on all ranks.
    pub(crate) fn clear_if_zero(&mut self, layout: &Layout) {
        if self.is_active && !reduce::any(layout, |k| self.mean[k] > 0.0) {
            self.clear();
        }
    }

    /// Returns the compliances of the cells.
    pub(crate) fn cells(&self) -> CellCompliance<'_> {
        CellCompliance::new(&self.mean, &self.deviator)
    }
}
