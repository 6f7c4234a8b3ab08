//! One influence coefficient of a grid with any boundary.

use crate::bodies::component::Component;
use crate::influence::{Symbols, Table};

/// One influence coefficient, in the form from which its spectrum is computed.
#[derive(Debug)]
pub(crate) enum InfluenceKernel {
    /// Coefficient at every distance, for free surroundings.
    Table(Table),
    /// Coefficient at every distance, up to half the period along y, for a grid that is periodic along y.
    Rows(Table),
    /// Symbol at every wave, for a grid that is periodic along both axes.
    Symbols(Symbols),
}

impl InfluenceKernel {
    /// Returns whether the grid is periodic along x and along y.
    pub(crate) fn repeats(&self) -> [bool; 2] {
        match self {
            Self::Table(_) => [false; 2],
            Self::Rows(_) => [false, true],
            Self::Symbols(_) => [true; 2],
        }
    }

    /// Returns whether the coefficient is odd in x and odd in y.
    pub(crate) fn is_odd(&self) -> [bool; 2] {
        self.component().is_odd()
    }

    /// Returns the smaller symbol of the two waves with one period over a periodic grid. Returns zero for other
    /// boundaries.
    pub(crate) fn least_of_one_period(&self) -> f64 {
        match self {
            Self::Table(_) | Self::Rows(_) => 0.0,
            Self::Symbols(symbols) => symbols.at([1, 0]).min(symbols.at([0, 1])),
        }
    }

    fn component(&self) -> Component {
        match self {
            Self::Table(table) | Self::Rows(table) => table.component(),
            Self::Symbols(symbols) => symbols.component(),
        }
    }
}
