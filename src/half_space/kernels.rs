//! The kernels that operators are made of.

use std::sync::{Arc, OnceLock};

use crate::boundary::Boundary;
use crate::error::Result;
use crate::grid::Grid;
use crate::influence::{Component, Kernel, Samples, Symbols};
use crate::material::ElasticPair;
use crate::parallel::get_or_make;

/// The kernels of bodies on cells of one size, each made at its first use.
#[derive(Debug)]
pub(super) struct Kernels {
    grid: Grid,
    pair: ElasticPair,
    /// What they are made of, on this grid and on all coarser ones; none where they repeat.
    samples: Option<Arc<Samples>>,
    made: [OnceLock<Kernel>; Component::ALL.len()],
}

impl Kernels {
    pub(super) fn new(grid: Grid, pair: ElasticPair, samples: Option<Arc<Samples>>) -> Self {
        Self {
            grid,
            pair,
            samples,
            made: Default::default(),
        }
    }

    pub(super) fn samples(&self) -> Option<&Arc<Samples>> {
        self.samples.as_ref()
    }

    pub(super) fn boundary(&self) -> Boundary {
        match self.samples {
            Some(_) => Boundary::NonPeriodic,
            None => Boundary::Periodic,
        }
    }

    /// Those of these components.
    pub(super) fn of<const N: usize>(
        &self,
        components: [[Component; N]; N],
    ) -> Result<[[&Kernel; N]; N]> {
        let mut kernels = [[self.kernel(components[0][0])?; N]; N];
        for (row, components) in kernels.iter_mut().zip(components) {
            for (kernel, component) in row.iter_mut().zip(components) {
                *kernel = self.kernel(component)?;
            }
        }
        Ok(kernels)
    }

    fn kernel(&self, component: Component) -> Result<&Kernel> {
        let (grid, pair) = (self.grid, &self.pair);
        get_or_make(&self.made[component as usize], || {
            Ok(match &self.samples {
                Some(samples) => Kernel::Table(samples.table(grid, pair, component)?),
                None => Kernel::Symbols(Symbols::new(grid, pair, component)),
            })
        })
    }
}
