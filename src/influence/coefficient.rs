//! One influence coefficient of a grid, whatever surrounds it.

use crate::bodies::component::Component;
use crate::influence::{Symbols, Table};

/// One influence coefficient, in the form from which its spectrum is made.
#[derive(Debug)]
pub(crate) enum Kernel {
    /// Free surroundings: the coefficient at every distance.
    Table(Table),
    /// A grid that repeats along y: the coefficient at every distance up to half the period.
    Rows(Table),
    /// A grid that repeats: its symbol at every wave.
    Symbols(Symbols),
}

impl Kernel {
    /// Whether the grid repeats along x and along y.
    pub(crate) fn repeats(&self) -> [bool; 2] {
        match self {
            Self::Table(_) => [false; 2],
            Self::Rows(_) => [false, true],
            Self::Symbols(_) => [true; 2],
        }
    }

    /// Whether the coefficient is odd in x and odd in y.
    pub(crate) fn is_odd(&self) -> [bool; 2] {
        self.component().is_odd()
    }

    /// Returns the lesser symbol of the two waves of one period over a periodic grid; zero for other surroundings.
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
