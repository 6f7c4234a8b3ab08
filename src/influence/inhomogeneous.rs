//! What the coefficients of bodies have besides those of homogeneous half-spaces, or in their place.

use std::sync::Arc;

use crate::bodies::kernel::{CoefficientTable, Kernel, KernelSource};
use crate::influence::LayerCorrection;

/// That of bodies on a grid that does not repeat along both axes.
#[derive(Debug)]
pub(crate) enum KernelCorrection {
    /// Added to the coefficients of the half-spaces that short waves see.
    LayerCorrection(Box<LayerCorrection>),
    /// In place of all else.
    Table(CoefficientTable),
}

impl KernelCorrection {
    /// Of a pair or a kernel; `None` of homogeneous bodies, which need nothing.
    pub(crate) fn of(kernel: &Kernel) -> Option<Arc<Self>> {
        let added = match kernel.given() {
            None => Self::LayerCorrection(Box::new(LayerCorrection::of(kernel.pair())?)),
            Some(KernelSource::Isotropic(isotropic)) => {
                Self::LayerCorrection(Box::new(LayerCorrection::of_kernel(kernel, isotropic)))
            }
            Some(KernelSource::Table(table)) => Self::Table(CoefficientTable::clone(table)),
            // On grids that take it there are symbols; operators need none.
            Some(KernelSource::Orthotropic(_) | KernelSource::Operators(_)) => return None,
        };
        Some(Arc::new(added))
    }

    /// That on cells of twice the sides.
    pub(crate) fn coarser(self: &Arc<Self>) -> Arc<Self> {
        match &**self {
            Self::LayerCorrection(_) => Arc::clone(self),
            Self::Table(table) => Arc::new(Self::Table(table.coarser())),
        }
    }
}
