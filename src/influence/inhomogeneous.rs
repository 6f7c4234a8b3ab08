//! Corrections to the coefficients of homogeneous half-spaces, or coefficients that replace them.

use std::sync::Arc;

use crate::bodies::kernel::{CoefficientTable, Kernel, KernelSource};
use crate::influence::LayerCorrection;

/// Correction or replacement of the coefficients for inhomogeneous bodies. The grid is not periodic along both axes.
#[derive(Debug)]
pub(crate) enum KernelCorrection {
    /// Correction added to the coefficients of the half-spaces that determine the response to short waves.
    LayerCorrection(Box<LayerCorrection>),
    /// Table that replaces all other coefficients.
    Table(CoefficientTable),
}

impl KernelCorrection {
    /// Creates the correction of a pair or a kernel. Returns `None` for homogeneous bodies, which require no
    /// correction.
    pub(crate) fn of(kernel: &Kernel) -> Option<Arc<Self>> {
        let added = match kernel.given() {
            None => Self::LayerCorrection(Box::new(LayerCorrection::of(kernel.pair())?)),
            Some(KernelSource::Isotropic(isotropic)) => {
                Self::LayerCorrection(Box::new(LayerCorrection::of_kernel(kernel, isotropic)))
            }
            Some(KernelSource::Table(table)) => Self::Table(CoefficientTable::clone(table)),
            // Grids that accept these kernels use symbols, and operators need no coefficients.
            Some(KernelSource::Orthotropic(_) | KernelSource::Operators(_)) => return None,
        };
        Some(Arc::new(added))
    }

    /// Returns the correction on cells with twice the side lengths.
    pub(crate) fn coarser(self: &Arc<Self>) -> Arc<Self> {
        match &**self {
            Self::LayerCorrection(_) => Arc::clone(self),
            Self::Table(table) => Arc::new(Self::Table(table.coarser())),
        }
    }
}
