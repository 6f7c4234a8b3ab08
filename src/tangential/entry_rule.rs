//! Friction law of cells that come into contact within a step.

use crate::bodies::material::ElasticPair;
use crate::cgm::{CellCompliance, reduce};
use crate::error::Result;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::parallel;
use crate::tangential::{Axis, TangentialIncrement, at};

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

impl TangentialIncrement {
    /// Sets the entry compliance $`B = \kappa\,g/p`$ of the cells that come into contact in this step. `gap` returns
    /// the gap of each cell of the grid at the start of the step. The gap of a cell in the earlier contact is zero.
    pub(crate) fn enter(&mut self, gap: impl Fn(usize) -> f64) -> Result<()> {
        let (pressed, diagonal) = (&self.pressed, &mut self.diagonal);
        fallible::resize(diagonal, pressed.region.cells(), 0.0)?;
        pressed.region.collect(gap, diagonal);
        let kappa = ratio_of_compliances(&self.bodies);
        let (pressure, limits) = (&pressed.pressure, &pressed.limits.cells);
        parallel::update(diagonal, |first, chunk| {
            for (k, value) in (first..).zip(chunk) {
                *value = if limits[k] > 0.0 {
                    entry_compliance(kappa * *value, pressure[k])
                } else {
                    0.0
                };
            }
        });
        self.deviator.clear();
        self.has_entered = reduce::any(pressed.region.layout(), |k| diagonal[k] > 0.0);
        if !self.has_entered {
            self.diagonal.clear();
        }
        Ok(())
    }

    /// Sets the entry compliance for rolling, in which it depends on the direction. `own` returns the compliance of a
    /// cell of the grid, given its pressure.
    pub(crate) fn set_rolling_entry_compliance(
        &mut self,
        own: impl Fn(usize, f64) -> EntryCompliance,
    ) -> Result<()> {
        let cells = self.pressed.region.cells();
        fallible::resize(&mut self.diagonal, cells, 0.0)?;
        self.deviator.clear();
        if let [_, _] = self.axes {
            fallible::resize(&mut self.deviator, cells, [0.0; 2])?;
        }
        self.has_entered = false;
        for (k, index) in self.pressed.region.own().indices().enumerate() {
            let own = if self.pressed.limits.cells[k] > 0.0 {
                own(index, self.pressed.pressure[k])
            } else {
                EntryCompliance::NONE
            };
            self.diagonal[k] = match self.axes {
                [Axis::X] => own.xx,
                [Axis::Y] => own.yy,
                _ => own.mean(),
            };
            if let Some(deviator) = self.deviator.get_mut(k) {
                *deviator = own.deviator();
            }
            self.has_entered |= self.diagonal[k] > 0.0;
        }
        if !self.has_entered {
            self.enter_nowhere();
        }
        Ok(())
    }

    /// Clears the entry compliances, because no cell comes into contact in this step.
    pub(crate) fn enter_nowhere(&mut self) {
        self.has_entered = false;
        self.diagonal.clear();
        self.deviator.clear();
    }

    /// Returns the number of cells that [`Self::write_entered`] needs room for.
    pub(crate) fn entered_cells(&self) -> usize {
        if self.has_entered {
            self.pressed.region.held().cells()
        } else {
            0
        }
    }

    /// Writes the mean entry compliance of the cells of the window in the last step to `entered`. If no cell came into
    /// contact, `entered` becomes empty. Returns whether a cell of any rank came into contact.
    pub(crate) fn write_entered(&self, entered: &mut Vec<f64>) -> bool {
        entered.clear();
        if self.has_entered {
            entered.extend_from_slice(&self.pressed.region.given(&self.diagonal));
        }
        self.has_entered
    }

    /// Subtracts the lag $`B q`$ from the offsets of the cells that came into contact. The lag is the motion that a
    /// cell has not followed.
    pub(super) fn subtract_entry_lag(&mut self) {
        let own = CellCompliance::new(&self.diagonal, &self.deviator);
        for cell in 0..self.diagonal.len() {
            let lag = own.added([0.0; 2], 1.0, cell, at(&self.traction, cell));
            for axis in self.axes.iter().map(|axis| axis.index()) {
                self.offset[axis][cell] -= lag[axis];
            }
        }
    }
}
