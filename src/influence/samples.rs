//! Integrals sampled at every cell distance, shared by all coefficients and all coarser grids.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use crate::bodies::component::Component;
use crate::bodies::material::ElasticPair;
use crate::error::{Result, all_finite, memory};
use crate::grid::Grid;
use crate::grid::cell_value::CellValue;
use crate::influence::far_field::FarFieldSeries;
use crate::influence::integrals::Integral;
use crate::influence::periodic_images::Images;
use crate::influence::{KernelCorrection, Rectangle, Table};
use crate::memory::fallible;
use crate::parallel::ranks::partition::RowPartition;
use crate::parallel::{self, get_or_make};

/// Integrals over one cell at the distances `(i, j)` of a grid with `0 <= i < nx` and `0 <= j < ny`. The integrals are in units
/// of the cell size, so the same samples are valid for a cell twice as large. Each integral is sampled on first use and takes 8
/// bytes per distance.
#[derive(Debug)]
pub(crate) struct Samples {
    rectangle: Rectangle,
    sides: [f64; 2],
    size: [usize; 2],
    /// Partition of the distances along y over the ranks, if they are distributed. Each rank samples its own distances.
    share: Option<Arc<RowPartition>>,
    /// Images and number of cells per period, if the grid is periodic along y.
    images: Option<(Images, usize)>,
    cell_value: CellValue,
    values: [OnceLock<Arc<Vec<f64>>>; Integral::COUNT],
    /// Correction that coated bodies add to each coefficient, or a kernel that replaces the coefficients, in the same unit.
    added: Option<Arc<KernelCorrection>>,
    rests: [OnceLock<Arc<Vec<f64>>>; Component::ALL.len()],
}

/// Quantity that is sampled.
#[derive(Debug, Clone, Copy)]
enum Sampled {
    Integral(Integral),
    LayerCorrection(Component),
}

/// Method for the rows of a sampled quantity.
#[derive(Debug)]
enum Rows {
    Cell(Box<FarFieldSeries>),
    Images(Images, Integral),
    LayerCorrection(Component),
}

impl Sampled {
    fn is_odd(self) -> [bool; 2] {
        match self {
            Self::Integral(integral) => integral.is_odd(),
            Self::LayerCorrection(component) => component.is_odd(),
        }
    }
}

impl Samples {
    /// Creates the samples for the cells of `grid`, up to `size` distances along each axis.
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the sides of a cell cannot be halved or compared.
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub(crate) fn new(grid: Grid, size: [usize; 2]) -> Result<Self> {
        memory("the influence coefficients", size, size_of::<f64>())?;
        Ok(Self {
            rectangle: Rectangle::new(0.5 * grid.dx(), 0.5 * grid.dy())?,
            sides: [grid.dx(), grid.dy()],
            size,
            share: None,
            images: None,
            cell_value: CellValue::default(),
            values: Default::default(),
            added: None,
            rests: Default::default(),
        })
    }

    /// Creates the samples for a grid that is periodic along y. Displacements are relative to a datum (a length).
    pub(crate) fn repeating_along_y(grid: Grid, size: [usize; 2], datum: f64) -> Result<Self> {
        let samples = Self::new(grid, size)?;
        let unit = samples.rectangle.unit;
        let images = Images {
            period: grid.dy() / unit * grid.ny() as f64,
            datum: datum / unit,
        };
        Ok(Self {
            images: Some((images, grid.ny())),
            ..samples
        })
    }

    /// Distributes the distances along y over ranks.
    pub(crate) fn shared(self, share: Option<Arc<RowPartition>>) -> Self {
        Self { share, ..self }
    }

    /// Sets whether cell values are uniform over the cell or values at its centre.
    pub(crate) fn of(self, cell_value: CellValue) -> Self {
        Self { cell_value, ..self }
    }

    /// Sets the correction to the coefficients of the outermost layers of coated bodies.
    pub(crate) fn coated(self, added: Option<Arc<KernelCorrection>>) -> Self {
        Self { added, ..self }
    }

    /// Returns whether the samples are valid for cells of any size.
    pub(crate) fn have_no_scale(&self) -> bool {
        self.images.is_none() && self.added.is_none()
    }

    /// Returns a coefficient of the pair on a grid whose cells have the size of the sampled cells or a multiple of this size.
    ///
    /// # Errors
    /// - The errors of [`Samples::new`].
    /// - [`Error::IncompleteKernel`](crate::Error::IncompleteKernel) for a coefficient that a table does not contain.
    /// - [`Error::Sample`](crate::Error::Sample) for a coefficient that is not finite.
    pub(crate) fn table(
        &self,
        grid: Grid,
        pair: &ElasticPair,
        component: Component,
    ) -> Result<Table> {
        let scale = Rectangle::new(0.5 * grid.dx(), 0.5 * grid.dy())?.scale();
        let compliances = match self.added.as_deref() {
            Some(KernelCorrection::Table(table)) => {
                table.check_has(component)?;
                None
            }
            _ => Some(pair.compliances()),
        };
        let parts = compliances.into_iter().flat_map(|of| component.parts(of));
        let parts = parts.map(|(weight, integral)| {
            let make = || self.sample(Sampled::Integral(integral)).map(Arc::new);
            let values = get_or_make(&self.values[integral as usize], make)?;
            Ok((weight, Arc::clone(values)))
        });
        let mut parts = parts.collect::<Result<Vec<_>>>()?;
        if self.added.is_some() {
            let make = || {
                let values = self.sample(Sampled::LayerCorrection(component))?;
                // A user-defined response can be NaN for some waves.
                all_finite("coefficient of the kernel", &values)?;
                Ok(Arc::new(values))
            };
            let values = get_or_make(&self.rests[component as usize], make)?;
            parts.push((1.0, Arc::clone(values)));
        }
        Ok(Table::new(
            component,
            self.size,
            self.share.clone(),
            scale,
            parts,
        ))
    }

    fn sample(&self, sampled: Sampled) -> Result<Vec<f64>> {
        let [nx, ny] = self.size;
        let rows = self
            .share
            .as_ref()
            .map_or(0..ny, |share| share.local_rows());
        match self.cell_value {
            CellValue::Uniform => {
                let row = |row: usize| (rows.start + row, false);
                self.integrals(sampled, [nx, rows.len()], row)
            }
            CellValue::Centre => self.at_centres(sampled, rows),
        }
    }

    /// Returns the integral, or the correction, at all columns of the given number of rows. `row` returns the number of each row,
    /// and whether the sign of its values is reversed.
    fn integrals(
        &self,
        sampled: Sampled,
        [columns, rows]: [usize; 2],
        row: impl Fn(usize) -> (usize, bool) + Sync,
    ) -> Result<Vec<f64>> {
        let Rectangle { cell, unit } = self.rectangle;
        let distance = |steps: usize, axis: usize| steps as f64 * self.sides[axis] / unit;
        let xs = fallible::collected(columns, (0..columns).map(|i| distance(i, 0)))?;
        let sampler = match (sampled, self.images) {
            (Sampled::Integral(integral), None) => {
                Rows::Cell(Box::new(FarFieldSeries::new(cell, integral)))
            }
            (Sampled::Integral(integral), Some((images, _))) => Rows::Images(images, integral),
            (Sampled::LayerCorrection(component), _) => Rows::LayerCorrection(component),
        };
        let mut values = fallible::zeros(columns * rows)?;
        parallel::rows(&mut values, columns, |index, out| {
            let (row, is_negative) = row(index);
            let y = distance(row, 1);
            match &sampler {
                Rows::Cell(series) => series.along_row(&xs, y, out),
                Rows::Images(images, integral) => images.along_row(cell, *integral, &xs, y, out),
                Rows::LayerCorrection(component) => self.rests_along_row(*component, row, &xs, out),
            }
            if is_negative {
                for value in out {
                    *value = -*value;
                }
            }
        });
        Ok(values)
    }

    /// Writes the correction that coated bodies add to a coefficient, at the points of a row. On a grid that is periodic along y
    /// the correction includes all images.
    fn rests_along_row(&self, component: Component, row: usize, xs: &[f64], out: &mut [f64]) {
        let unit = self.rectangle.unit;
        let rest = match self.added.as_deref() {
            None => return out.fill(0.0),
            Some(KernelCorrection::Table(table)) => {
                for (column, out) in out.iter_mut().enumerate() {
                    *out = table.at(component, [column, row]) / self.rectangle.scale();
                }
                return;
            }
            Some(KernelCorrection::LayerCorrection(rest)) => rest,
        };
        let y = row as f64 * self.sides[1] / unit;
        let sides = self.rectangle.half_sides();
        let lengths: Vec<f64> = xs.iter().map(|x| x * unit).collect();
        match self.images {
            None => rest.along_row(component, sides, &lengths, y * unit, out),
            Some((images, _)) => {
                let of = [images.period, images.datum].map(|length| length * unit);
                for (out, x) in out.iter_mut().zip(&lengths) {
                    *out = rest.over_rows(component, sides, [*x, y * unit], of);
                }
            }
        }
        for out in out {
            *out /= unit;
        }
    }

    /// Returns the integral minus 1/24 of its second differences, computed from samples that extend one distance further
    /// on all sides.
    fn at_centres(&self, sampled: Sampled, rows: Range<usize>) -> Result<Vec<f64>> {
        let [nx, _] = self.size;
        let (width, [odd_x, odd_y]) = (nx + 1, sampled.is_odd());
        let folded = |row: usize| {
            // The rows before the first and after the last row are also needed on this rank.
            let (row, is_before) = match (rows.start + row).checked_sub(1) {
                Some(row) => (row, false),
                None => (1, true),
            };
            let beyond = self.images.map(|(_, period)| period);
            match beyond.filter(|period| 2 * row > *period) {
                Some(period) => (period - row, odd_y && !is_before),
                None => (row, odd_y && is_before),
            }
        };
        let wider = self.integrals(sampled, [width, rows.len() + 2], folded)?;
        let mut values = fallible::zeros(nx * rows.len())?;
        parallel::rows(&mut values, nx, |row, out| {
            let [below, own, above] = [0, 1, 2].map(|k| &wider[(row + k) * width..][..width]);
            for (i, out) in out.iter_mut().enumerate() {
                let before = match i.checked_sub(1) {
                    Some(before) => own[before],
                    None if odd_x => -own[1],
                    None => own[1],
                };
                let neighbours = (before + own[i + 1]) + (below[i] + above[i]);
                *out = own[i] - (neighbours - 4.0 * own[i]) / 24.0;
            }
        });
        Ok(values)
    }
}
