//! Solution on the finest grid, with the estimate of each quantity.

use super::measures::{Measures, Quantity};
use super::region::Extent;
use crate::edges::TangentialEdges;
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
#[cfg(feature = "history")]
use crate::history::History;
use crate::normal::NormalSolution;
use crate::support::debug::shown;
use crate::tangential::{Friction, TangentialSolution};
use crate::warning::Warning;

/// Reason why the refinement of the grid ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum AdaptiveStatus {
    /// All estimates are at most their targets.
    Reached,
    /// The next grid would exceed the limit of the cells.
    CellLimit,
    /// The time limit passed.
    TimeLimit,
    /// The cells are as small as the distance between the samples of the gap.
    SampleSpacing,
    /// The observer cancelled.
    Cancelled,
}

/// Estimated error of a quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Estimate {
    /// Quantity, which defines the error.
    pub quantity: Quantity,
    /// Estimated error.
    pub error: f64,
    /// Target of the quantity, if the problem has one.
    pub target: Option<f64>,
}

/// Grid of a solve and the estimates after it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct GridRecord {
    /// Grid of the solve.
    pub grid: Grid,
    /// Centre of the grid in the coordinates of the gap, `[x, y]` (lengths).
    pub centre: [f64; 2],
    /// Estimates of all quantities, or an empty list after the first solve of an extent.
    pub estimates: Vec<Estimate>,
}

/// Contact with estimated errors, on the finest grid of the solve.
pub struct AdaptiveSolution {
    pub(super) bodies: HalfSpace,
    pub(super) gap: Field,
    pub(super) extent: Extent,
    pub(super) contact: SolvedContact,
    pub(super) measures: Measures,
    pub(super) estimates: Vec<Estimate>,
    pub(super) status: AdaptiveStatus,
    pub(super) grids: Vec<GridRecord>,
}

shown!(AdaptiveSolution: grid(), centre(), status, estimates);

/// Contact on one grid.
pub(super) enum SolvedContact {
    Normal(Box<NormalSolution>),
    Sheared(Box<(NormalSolution, TangentialSolution, Friction)>),
    #[cfg(feature = "history")]
    Step(Box<History>),
}

impl SolvedContact {
    pub(super) fn normal(&self) -> &NormalSolution {
        match self {
            Self::Normal(normal) => normal,
            Self::Sheared(both) => &both.0,
            #[cfg(feature = "history")]
            Self::Step(history) => history.normal(),
        }
    }
}

impl AdaptiveSolution {
    /// Returns the grid.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.gap.grid()
    }

    /// Returns the centre of the grid in the coordinates of the gap, `[x, y]` (lengths).
    #[must_use]
    pub fn centre(&self) -> [f64; 2] {
        self.extent.centre()
    }

    /// Returns the centre of cell `(ix, iy)` in the coordinates of the gap, `[x, y]` (lengths).
    #[must_use]
    pub fn position(&self, ix: usize, iy: usize) -> [f64; 2] {
        let ([x, y], [cx, cy]) = (self.grid().position(ix, iy), self.centre());
        [cx + x, cy + y]
    }

    /// Returns the bodies on the grid, for instance for a further problem.
    #[must_use]
    pub fn bodies(&self) -> &HalfSpace {
        &self.bodies
    }

    /// Returns the gap at the centres of the cells (lengths).
    #[must_use]
    pub fn gap(&self) -> &Field {
        &self.gap
    }

    /// Returns the normal contact. Its positions and moments refer to the [centre](Self::centre) of the grid.
    #[must_use]
    pub fn normal(&self) -> &NormalSolution {
        self.contact.normal()
    }

    /// Returns the tangential contact, or `None` without [`shear`](super::AdaptiveProblemBuilder::shear).
    #[must_use]
    pub fn tangential(&self) -> Option<&TangentialSolution> {
        if let SolvedContact::Sheared(both) = &self.contact {
            Some(&both.1)
        } else {
            None
        }
    }

    /// Returns the history after its first step, or `None` without
    /// [`first_step`](super::AdaptiveProblemBuilder::first_step).
    #[cfg(feature = "history")]
    #[cfg_attr(docsrs, doc(cfg(feature = "history")))]
    #[must_use]
    pub fn history(&self) -> Option<&History> {
        match &self.contact {
            SolvedContact::Step(history) => Some(history),
            _ => None,
        }
    }

    /// Returns the history after its first step for further steps, or `None` without
    /// [`first_step`](super::AdaptiveProblemBuilder::first_step).
    ///
    /// Its settings are those of the adaptive solve, whose tolerance is 2 % of the smallest target (2e-4 for the default
    /// targets). Call [`set_settings`](History::set_settings) for a smaller tolerance. Its grid is centred on the
    /// [centre](Self::centre): add the centre to positions, for instance in the gap for [`set_gap`](History::set_gap).
    #[cfg(feature = "history")]
    #[cfg_attr(docsrs, doc(cfg(feature = "history")))]
    #[must_use]
    pub fn into_history(self) -> Option<History> {
        match self.contact {
            SolvedContact::Step(history) => Some(*history),
            _ => None,
        }
    }

    /// Returns the contact area (a length squared) from the [edges](crate::edges) inside the cells.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.measures.area
    }

    /// Returns the edges of contact and stick zone inside the cells, or `None` without friction.
    ///
    /// # Errors
    /// The errors of [`NormalSolution::edges`].
    pub fn edges(&self) -> Result<Option<TangentialEdges>> {
        match &self.contact {
            SolvedContact::Normal(_) => Ok(None),
            SolvedContact::Sheared(both) => both.1.edges(&both.0, &both.2).map(Some),
            #[cfg(feature = "history")]
            SolvedContact::Step(history) => history.edges().map(Some),
        }
    }

    /// Returns the reason why the refinement ended.
    #[must_use]
    pub fn status(&self) -> AdaptiveStatus {
        self.status
    }

    /// Returns the estimates of all quantities. The list is empty if only one grid was solved.
    #[must_use]
    pub fn estimates(&self) -> &[Estimate] {
        &self.estimates
    }

    /// Returns the estimated error of a quantity, or `None` if it was not estimated.
    #[must_use]
    pub fn estimate(&self, quantity: Quantity) -> Option<f64> {
        let mut estimates = self.estimates.iter();
        estimates
            .find(|estimate| estimate.quantity == quantity)
            .map(|estimate| estimate.error)
    }

    /// Returns the difference of a quantity from a solution on a finer grid, as defined by [`Quantity`]. The finer grid should
    /// have at least twice as many cells along a side. The comparison of fields on similar grids has an additional error due to
    /// interpolation. The difference is zero for a tangential quantity without friction.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn difference(&self, finer: &Self, quantity: Quantity) -> Result<f64> {
        finer.measures.difference(&self.measures, quantity)
    }

    /// Returns the grids of all solves after the search for the contact.
    #[must_use]
    pub fn grids(&self) -> &[GridRecord] {
        &self.grids
    }

    /// Returns the warnings of the normal contact, of the tangential contact or of the first step, and
    /// [`Warning::AccuracyNotReached`] if a limit ended the refinement. Each kind of warning occurs once.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub fn warnings(&self) -> Result<Vec<Warning>> {
        let mut warnings = self.normal().try_warnings()?;
        let of_shear = match &self.contact {
            SolvedContact::Normal(_) => Vec::new(),
            SolvedContact::Sheared(both) => both.1.try_warnings()?,
            #[cfg(feature = "history")]
            SolvedContact::Step(history) => history.last_step()?.warnings(),
        };
        for warning in of_shear {
            let kind = std::mem::discriminant(&warning);
            if warnings
                .iter()
                .all(|other| std::mem::discriminant(other) != kind)
            {
                warnings.push(warning);
            }
        }
        if self.status != AdaptiveStatus::Reached {
            let ratios = self.estimates.iter().filter_map(Estimate::ratio);
            warnings.push(Warning::accuracy_not_reached(ratios.fold(0.0, f64::max)));
        }
        Ok(warnings)
    }
}

impl Estimate {
    /// Returns the error divided by the target, or `None` without a target.
    pub(super) fn ratio(&self) -> Option<f64> {
        self.target.map(|target| self.error / target)
    }
}
