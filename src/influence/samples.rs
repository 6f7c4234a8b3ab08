//! The integrals sampled at every cell distance, once for all coefficients and all coarser grids.

use std::sync::{Arc, OnceLock};

use crate::error::Result;
use crate::grid::Grid;
use crate::influence::integrals::Integral;
use crate::influence::{Component, Rectangle, Table};
use crate::material::ElasticPair;
use crate::parallel::{self, get_or_make};

/// The integrals over one cell at the distances `(i, j)` of a grid, `0 <= i < nx`, `0 <= j < ny`, in
/// units of the cell size, so that they are the same for a cell twice as large. Each integral is
/// sampled on first use, 8 bytes per distance.
#[derive(Debug)]
pub(crate) struct Samples {
    rectangle: Rectangle,
    sides: [f64; 2],
    size: [usize; 2],
    values: [OnceLock<Arc<[f64]>>; Integral::COUNT],
}

impl Samples {
    /// For the cells of `grid`, up to `size` distances along each axis.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) if the sides of a cell cannot be halved or
    /// compared.
    pub(crate) fn new(grid: Grid, size: [usize; 2]) -> Result<Self> {
        Ok(Self {
            rectangle: Rectangle::new(0.5 * grid.dx(), 0.5 * grid.dy())?,
            sides: [grid.dx(), grid.dy()],
            size,
            values: Default::default(),
        })
    }

    /// A coefficient of the pair on a grid whose cells are the sampled ones or a multiple of them.
    ///
    /// # Errors
    /// As [`Samples::new`].
    pub(crate) fn table(
        &self,
        grid: Grid,
        pair: &ElasticPair,
        component: Component,
    ) -> Result<Table> {
        let scale = Rectangle::new(0.5 * grid.dx(), 0.5 * grid.dy())?.scale();
        let parts = component.parts(pair.compliances());
        let parts = parts.map(|(weight, integral)| {
            let make = || Ok(self.sample(integral));
            let values = get_or_make(&self.values[integral as usize], make)?;
            Ok((weight, Arc::clone(values)))
        });
        Ok(Table::new(
            component,
            self.size,
            scale,
            parts.collect::<Result<_>>()?,
        ))
    }

    fn sample(&self, integral: Integral) -> Arc<[f64]> {
        let [nx, ny] = self.size;
        let Rectangle { cell, unit } = self.rectangle;
        let distance = |steps: usize, axis: usize| steps as f64 * self.sides[axis] / unit;
        let xs: Vec<f64> = (0..nx).map(|i| distance(i, 0)).collect();
        let mut values = vec![0.0; nx * ny];
        parallel::rows(&mut values, nx, |row, out| {
            cell.along_row(integral, &xs, distance(row, 1), out);
        });
        values.into()
    }
}
