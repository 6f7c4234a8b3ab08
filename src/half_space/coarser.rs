//! Bodies on cells with sides twice as long, and the transfer of fields between the two grids.

use std::ops::Range;
use std::sync::Arc;

use crate::error::Result;
use crate::fft::samples;
use crate::grid::Grid;
use crate::grid::coarsening::{REACH, coarsened, halved, refined, refined_zone};
use crate::grid::field::Field;
use crate::half_space::coefficients::CellKernels;
use crate::half_space::{HalfSpace, Shared};
use crate::influence::KernelCorrection;
use crate::parallel::get_or_make;
use crate::parallel::ranks::partition::RowPartition;

/// Largest number of cells of a coarser grid that is not distributed. Every rank solves such a grid, because messages
/// would take longer than the solve.
const ALONE: usize = 1 << 16;

impl HalfSpace {
    /// Returns the same bodies on cells of twice the sides. The coarser grid is as large as the grid or one fine cell
    /// larger. A periodic grid must have [even numbers of cells](Self::can_be_coarser), or be a single row or column,
    /// whose width does not change.
    pub(crate) fn coarser(&self) -> Result<&Self> {
        let Shared {
            grid,
            kernels,
            coarser,
            ..
        } = &*self.shared;
        get_or_make(coarser, || {
            let [nx, ny] = halved(self.size());
            let [wide, high] = self.lines().map(|is_line| if is_line { 1.0 } else { 2.0 });
            let grid = Grid::new(nx, ny, wide * grid.dx(), high * grid.dy())?;
            let (boundary, cell_value) = (self.boundary(), self.cell_value());
            let share = self.share_of_coarser([nx, ny]);
            let added = kernels.added().map(KernelCorrection::coarser);
            let samples = match kernels.samples() {
                _ if share.is_some() => None,
                Some(samples) if self.keeps_kernels() && samples.have_no_scale() => {
                    Some(Arc::clone(samples))
                }
                _ => {
                    let dealt = (None, added.as_ref());
                    let samples = samples(grid, boundary, cell_value, grid.size(), dealt);
                    self.collective_result(samples)?.map(Arc::new)
                }
            };
            let dealt = (self.team().cloned(), share);
            let made = (samples, added);
            let kernels = CellKernels::new(grid, self.kernel(), boundary, cell_value, made);
            Ok(Self::of_kernels(kernels, dealt))
        })
    }

    /// Returns whether cells with doubled sides fit the grid and the bodies are defined on such cells.
    pub(crate) fn can_be_coarser(&self) -> bool {
        if self.kernel().user_operators().is_some() {
            return false;
        }
        let cells = self.size().into_iter().zip(self.boundary().repeats());
        let mut fits = cells.map(|(n, repeats)| !repeats || n == 1 || n % 2 == 0);
        fits.all(|fits| fits)
    }

    /// Returns the axes along which the grid is periodic with a single cell. Fields do not vary along these axes.
    pub(crate) fn lines(&self) -> [bool; 2] {
        let (size, repeats) = (self.size(), self.boundary().repeats());
        [0, 1].map(|axis| repeats[axis] && size[axis] == 1)
    }

    /// Returns the distribution of a coarser grid over ranks, or `None` if the coarser grid is not distributed.
    fn share_of_coarser(&self, [nx, ny]: [usize; 2]) -> Option<Arc<RowPartition>> {
        self.share([nx, ny]).filter(|_| nx * ny > ALONE)
    }

    /// Restricts a field of the grid to the cells of [`Self::coarser`].
    pub(crate) fn coarsened_field(&self, coarser: &Self, field: &Field) -> Result<Field> {
        let samples = self.coarsened(coarser, self.size(), field.as_slice())?;
        Field::from_vec(coarser.grid(), samples)
    }

    /// Restricts samples of `[nx, ny]` cells to the cells of [`Self::coarser`].
    pub(crate) fn coarsened(
        &self,
        coarser: &Self,
        [nx, ny]: [usize; 2],
        field: &[f64],
    ) -> Result<Vec<f64>> {
        let Some(fine) = self.share([nx, ny]) else {
            return coarsened([nx, ny], field);
        };
        let size = halved([nx, ny]);
        let coarse = coarser.share(size);
        let rows = |rank: usize| {
            let all = 0..size[1];
            let coarse = coarse.as_ref().map_or(all, |coarse| coarse.rows_of(rank));
            (2 * coarse.start).min(ny)..(2 * coarse.end).min(ny)
        };
        let own = rows(fine.team().rank());
        let found = fine.fetch(field, nx, |rank| [0..nx, rows(rank)])?;
        coarsened([nx, own.len()], &found)
    }

    /// Prolongates a field of the cells of [`Self::coarser`] to `[nx, ny]` cells by interpolation.
    pub(crate) fn refined(
        &self,
        coarser: &Self,
        size: [usize; 2],
        field: &[f64],
    ) -> Result<Vec<f64>> {
        self.on_finer(coarser, size, field, refined)
    }

    /// Prolongates a field that is positive in a zone. At the edge of the zone the field falls to zero like the square
    /// root of the distance from the edge.
    pub(crate) fn refined_zone(
        &self,
        coarser: &Self,
        size: [usize; 2],
        field: &[f64],
    ) -> Result<Vec<f64>> {
        self.on_finer(coarser, size, field, refined_zone)
    }

    /// Creates the local rows from the coarser cells. The function `make` receives the first of the coarser rows as its
    /// last argument.
    fn on_finer(
        &self,
        coarser: &Self,
        [nx, ny]: [usize; 2],
        field: &[f64],
        make: impl Fn([usize; 2], Range<usize>, &[f64], usize) -> Result<Vec<f64>>,
    ) -> Result<Vec<f64>> {
        let Some(fine) = self.share([nx, ny]) else {
            return make([nx, ny], 0..ny, field, 0);
        };
        let [width, height] = halved([nx, ny]);
        // The coarse cells near the rows are also needed.
        let rows = |rank: usize| {
            let fine = fine.rows_of(rank);
            if fine.is_empty() {
                return 0..0;
            }
            (fine.start / 2).saturating_sub(REACH)..(fine.end / 2 + REACH).min(height)
        };
        let own = fine.local_rows();
        match coarser.share([width, height]) {
            Some(coarse) => {
                let found = coarse.fetch(field, width, |rank| [0..width, rows(rank)])?;
                make(
                    [nx, ny],
                    own.clone(),
                    &found,
                    rows(fine.team().rank()).start,
                )
            }
            None => make([nx, ny], own, field, 0),
        }
    }
}
