//! What the coefficients of bodies have besides those of homogeneous half-spaces, or in their place.

use std::sync::Arc;

use crate::bodies::kernel::{CoefficientTable, Given, Kernel};
use crate::influence::Rest;

/// That of bodies on a grid that does not repeat along both axes.
#[derive(Debug)]
pub(crate) enum Added {
    /// Added to the coefficients of the half-spaces that short waves see.
    Rest(Box<Rest>),
    /// In place of all else.
    Table(CoefficientTable),
}

impl Added {
    /// Of a pair or a kernel; `None` of homogeneous bodies, which need nothing.
    pub(crate) fn of(kernel: &Kernel) -> Option<Arc<Self>> {
        let added = match kernel.given() {
            None => Self::Rest(Box::new(Rest::of(kernel.pair())?)),
            Some(Given::Isotropic(isotropic)) => {
                Self::Rest(Box::new(Rest::of_kernel(kernel, isotropic)))
            }
            Some(Given::Table(table)) => Self::Table(CoefficientTable::clone(table)),
            // On grids that take it there are symbols; operators need none.
            Some(Given::Orthotropic(_) | Given::Operators(_)) => return None,
        };
        Some(Arc::new(added))
    }

    /// That on cells of twice the sides.
    pub(crate) fn coarser(self: &Arc<Self>) -> Arc<Self> {
        match &**self {
            Self::Rest(_) => Arc::clone(self),
            Self::Table(table) => Arc::new(Self::Table(table.coarser())),
        }
    }
}
