//! One influence coefficient sampled at every distance of a grid.

use crate::error::Result;
use crate::grid::Grid;
use crate::influence::{Component, Rectangle};
use crate::material::ElasticPair;
use crate::parallel;

/// One influence coefficient at the cell distances `(i dx, j dy)`, `0 <= i < nx`, `0 <= j < ny`.
///
/// Distances of the other sign follow from the parity of the component, so that only a quarter of
/// what a convolution needs is evaluated and kept: 8 bytes per sample.
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
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    component: Component,
    nx: usize,
    ny: usize,
    samples: Vec<f64>,
}

impl Table {
    /// Samples a coefficient of the pair at every cell distance of the grid.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) if the sides of a cell cannot be halved or compared.
    pub fn sample(grid: Grid, pair: &ElasticPair, component: Component) -> Result<Self> {
        let rectangle = Rectangle::new(0.5 * grid.dx(), 0.5 * grid.dy())?;
        let compliances = pair.compliances();
        let (nx, ny) = (grid.nx(), grid.ny());
        let mut samples = vec![0.0; grid.cells()];
        parallel::update(&mut samples, |first, chunk| {
            for (offset, sample) in chunk.iter_mut().enumerate() {
                let (i, j) = ((first + offset) % nx, (first + offset) / nx);
                let (x, y) = (i as f64 * grid.dx(), j as f64 * grid.dy());
                *sample = rectangle.coefficient(component, compliances, x, y);
            }
        });
        Ok(Self {
            component,
            nx,
            ny,
            samples,
        })
    }

    /// Which coefficient was sampled.
    #[must_use]
    pub fn component(&self) -> Component {
        self.component
    }

    /// Distances sampled along x and along y.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        [self.nx, self.ny]
    }

    /// The coefficient (a length over a pressure) from a cell to the one `i` columns and `j` rows
    /// further; `None` beyond the distances sampled.
    #[must_use]
    pub fn get(&self, i: isize, j: isize) -> Option<f64> {
        let (column, row) = (i.unsigned_abs(), j.unsigned_abs());
        if column >= self.nx || row >= self.ny {
            return None;
        }
        let value = *self.samples.get(row * self.nx + column)?;
        let [odd_x, odd_y] = self.component.is_odd();
        let negative = (odd_x && i < 0) != (odd_y && j < 0);
        Some(if negative { -value } else { value })
    }

    /// The samples at row distance `j`, from column distance zero up.
    pub(crate) fn row(&self, j: usize) -> &[f64] {
        &self.samples[j * self.nx..(j + 1) * self.nx]
    }
}
