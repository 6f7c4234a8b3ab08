//! Kernels from which operators are created.

use std::sync::{Arc, OnceLock};

use crate::bodies::component::Component;
use crate::bodies::kernel;
use crate::bodies::material::ElasticPair;
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::influence::{InfluenceKernel, KernelCorrection, Samples, Symbols};
use crate::parallel::get_or_make;

/// Kernels of bodies on cells of one size, each created at its first use.
#[derive(Debug)]
pub(super) struct CellKernels {
    grid: Grid,
    bodies: kernel::Kernel,
    boundary: Boundary,
    cell_value: CellValue,
    /// Samples from which the kernels are computed, or `None` on a grid that is periodic along both axes.
    samples: Option<Arc<Samples>>,
    /// Contribution of coated bodies in addition to their outermost layers, or a kernel that replaces the half-space.
    added: Option<Arc<KernelCorrection>>,
    made: [OnceLock<InfluenceKernel>; Component::ALL.len()],
}

impl CellKernels {
    pub(super) fn new(
        grid: Grid,
        bodies: &kernel::Kernel,
        boundary: Boundary,
        cell_value: CellValue,
        (samples, added): (Option<Arc<Samples>>, Option<Arc<KernelCorrection>>),
    ) -> Self {
        Self {
            grid,
            bodies: bodies.clone(),
            boundary,
            // The symbols of waves correspond to values at the centres.
            cell_value: match boundary {
                Boundary::Periodic => CellValue::Centre,
                _ => cell_value,
            },
            samples,
            added,
            made: Default::default(),
        }
    }

    /// Returns the whole grid.
    pub(super) fn grid(&self) -> Grid {
        self.grid
    }

    pub(super) fn pair(&self) -> &ElasticPair {
        self.bodies.pair()
    }

    pub(super) fn bodies(&self) -> &kernel::Kernel {
        &self.bodies
    }

    pub(super) fn samples(&self) -> Option<&Arc<Samples>> {
        self.samples.as_ref()
    }

    pub(super) fn added(&self) -> Option<&Arc<KernelCorrection>> {
        self.added.as_ref()
    }

    pub(super) fn boundary(&self) -> Boundary {
        self.boundary
    }

    pub(super) fn cell_value(&self) -> CellValue {
        self.cell_value
    }

    /// Returns the kernels of these components.
    pub(super) fn of<const N: usize>(
        &self,
        components: [[Component; N]; N],
    ) -> Result<[[&InfluenceKernel; N]; N]> {
        let mut kernels = [[self.kernel(components[0][0])?; N]; N];
        for (row, components) in kernels.iter_mut().zip(components) {
            for (kernel, component) in row.iter_mut().zip(components) {
                *kernel = self.kernel(component)?;
            }
        }
        Ok(kernels)
    }

    fn kernel(&self, component: Component) -> Result<&InfluenceKernel> {
        let (grid, bodies) = (self.grid, &self.bodies);
        get_or_make(&self.made[component as usize], || {
            let Some(samples) = &self.samples else {
                return Ok(InfluenceKernel::Symbols(Symbols::new(
                    grid, bodies, component,
                )));
            };
            let table = samples.table(grid, bodies.pair(), component)?;
            Ok(match self.boundary.repeats() {
                [false, false] => InfluenceKernel::Table(table),
                _ => InfluenceKernel::Rows(table),
            })
        })
    }
}
