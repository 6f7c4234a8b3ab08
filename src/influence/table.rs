//! One influence coefficient sampled at every distance of a grid.

use std::sync::Arc;

use crate::bodies::component::Component;
use crate::bodies::kernel::Kernel;
use crate::bodies::material::ElasticPair;
use crate::error::Result;
use crate::grid::Grid;
use crate::influence::{KernelCorrection, Samples};
use crate::parallel;
use crate::parallel::ranks::partition::RowPartition;
use crate::support::debug::shown;

/// One influence coefficient at the cell distances `(i dx, j dy)` with `0 <= i < nx` and `0 <= j < ny`.
///
/// Coefficients at distances of the opposite sign follow from the parity of the component. Only a quarter of the samples that a
/// convolution needs is therefore evaluated and stored. A sample takes 8 bytes, or 16 bytes for `XX` and `YY`.
///
/// ```
/// use stickslip::{ElasticPair, Grid, Material, influence::{Component, Table}};
/// let steel = Material::new(210e9, 0.3)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let grid = Grid::new(8, 8, 1e-6, 1e-6)?;
/// let table = Table::sample(grid, &pair, Component::XY)?;
/// assert_eq!(table.get(3, -2), Some(-table.get(3, 2).unwrap()));
/// assert_eq!(table.get(8, 0), None);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct Table {
    component: Component,
    nx: usize,
    ny: usize,
    /// Partition of the rows over ranks, if they are distributed, and the first local row.
    share: Option<Arc<RowPartition>>,
    first_row: usize,
    /// Weights and integrals, row by row.
    parts: Vec<(f64, Arc<Vec<f64>>)>,
    /// Scale of the sum of the parts.
    scale: f64,
}

shown!(Table: component, nx, ny);

impl Table {
    /// Samples a coefficient of the pair at every cell distance of the grid.
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the sides of a cell cannot be halved or compared.
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    /// - [`Error::IncompleteKernel`](crate::Error::IncompleteKernel) for a pair that represents a [`Kernel`].
    pub fn sample(grid: Grid, pair: &ElasticPair, component: Component) -> Result<Self> {
        pair.check_no_kernel()?;
        let added = KernelCorrection::of(&Kernel::from(*pair));
        let samples = Samples::new(grid, grid.size())?.coated(added);
        parallel::enter_with(grid.cells(), || samples.table(grid, pair, component))
    }

    pub(super) fn new(
        component: Component,
        [nx, ny]: [usize; 2],
        share: Option<Arc<RowPartition>>,
        scale: f64,
        parts: Vec<(f64, Arc<Vec<f64>>)>,
    ) -> Self {
        Self {
            component,
            nx,
            ny,
            first_row: share.as_ref().map_or(0, |share| share.local_rows().start),
            share,
            parts,
            scale,
        }
    }

    /// Returns the sampled component.
    #[must_use]
    pub fn component(&self) -> Component {
        self.component
    }

    /// Returns the number of sampled distances along x and along y.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        [self.nx, self.ny]
    }

    /// Returns the coefficient (a length over a pressure) for a displaced cell that is `i` columns and `j` rows from the loaded
    /// cell. Returns `None` beyond the sampled distances.
    #[must_use]
    pub fn get(&self, i: isize, j: isize) -> Option<f64> {
        let (column, row) = (i.unsigned_abs(), j.unsigned_abs());
        if column >= self.nx || row >= self.ny {
            return None;
        }
        let value = self.at(column, row);
        let [odd_x, odd_y] = self.component.is_odd();
        let negative = (odd_x && i < 0) != (odd_y && j < 0);
        Some(if negative { -value } else { value })
    }

    /// Returns the partition of the rows over ranks, if they are distributed.
    pub(crate) fn share(&self) -> Option<&Arc<RowPartition>> {
        self.share.as_ref()
    }

    /// Returns the coefficient at a distance of `column` columns and `row` rows, which must be sampled on this rank.
    pub(crate) fn at(&self, column: usize, row: usize) -> f64 {
        let index = (row - self.first_row) * self.nx + column;
        let parts = self.parts.iter();
        let sum: f64 = parts.map(|(weight, values)| weight * values[index]).sum();
        sum * self.scale
    }

    /// Writes the coefficients of a row, starting at distance zero.
    pub(crate) fn write_row(&self, row: usize, out: &mut [f64]) {
        let first = (row - self.first_row) * self.nx;
        out.fill(0.0);
        for (weight, values) in &self.parts {
            for (out, value) in out.iter_mut().zip(&values[first..first + self.nx]) {
                *out += weight * value;
            }
        }
        for out in out {
            *out *= self.scale;
        }
    }
}
