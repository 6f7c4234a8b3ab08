//! Sums of convolutions of three fields: the responses to three tractions, three components at a time.

use std::array::from_fn;
use std::ops::Range;
use std::sync::Arc;

use crate::error::{Result, memory};
use crate::fft::length::torus;
use crate::fft::plan::{Plan, TaskScratch};
use crate::fft::spectrum::{StridedLines, of_samples};
use crate::fft::symbol::Parity;
use crate::fft::tiles::{Tile, Tiles, exchange};
use crate::fft::torus::TorusLayout;
use crate::memory::fallible::{self, unwrap_or_abort};
use crate::memory::pool::Pool;
use crate::parallel;
use crate::parallel::ranks::partition::RowPartition;

/// Transforms of three fields that are convolved with many kernels. The fields are transformed along their rows once,
/// and then [convolved](Self::convolve) with three times three kernels at a time.
///
/// # Memory
///
/// The transforms take 96 bytes per cell, and a small amount per task.
#[derive(Debug, Clone)]
pub(crate) struct Superposition {
    plan: Plan<f64>,
    sources: Tiles<3>,
    results: Tiles<3>,
    scratch: TaskScratch<f64, 3>,
    /// Nine kernels of a column of waves, for each task.
    columns: Pool<Vec<f64>>,
    /// Whether the sources are stored in bands of columns.
    is_loaded: bool,
}

/// Torus on which fields of a given size are convolved. Kernels are given for one quarter of its spectrum.
#[derive(Debug, Clone)]
pub(crate) struct Torus {
    frame: TorusLayout,
    /// Partition of the distances along y over the ranks, or `None` for a single process.
    distances: Option<Arc<RowPartition>>,
}

impl Torus {
    /// Creates the torus for fields of `[nx, ny]` cells, periodic or not along each axis, whose rows may be distributed
    /// over ranks.
    pub(crate) fn new(
        size: [usize; 2],
        repeats: [bool; 2],
        share: Option<Arc<RowPartition>>,
    ) -> Self {
        let torus = torus(size, repeats);
        let quarter = torus.map(|m| m / 2 + 1);
        let of = |share: &Arc<RowPartition>| Arc::new(RowPartition::new(share.team(), quarter));
        Self {
            distances: share.as_ref().map(of),
            frame: TorusLayout { size, torus, share },
        }
    }

    /// Returns the number of waves along each axis. This number is also the number of distances at which a kernel is
    /// sampled, from zero to half the torus.
    pub(crate) fn quarter(&self) -> [usize; 2] {
        self.frame.torus.map(|m| m / 2 + 1)
    }

    /// Returns the distances along y at which this rank samples kernels.
    pub(crate) fn own_distances(&self) -> Range<usize> {
        let all = 0..self.quarter()[1];
        self.distances
            .as_ref()
            .map_or(all, |share| share.local_rows())
    }

    /// Returns the waves along x whose kernels this rank multiplies.
    pub(crate) fn own_waves(&self) -> Range<usize> {
        self.frame.own_columns()
    }

    /// Returns the spectrum of a kernel, or its imaginary part if the kernel is odd in one axis. `at(i, j)` samples the
    /// kernel at the distances of a quarter. It is called for the [local distances](Self::own_distances) along y. The
    /// result contains the waves along y for each wave along x that this rank multiplies.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    /// - [`Error::Ranks`](crate::Error::Ranks) if a rank fails.
    pub(crate) fn spectrum(
        &self,
        is_odd: [bool; 2],
        at: impl Fn(usize, usize) -> f64 + Sync,
    ) -> Result<Vec<f64>> {
        let [_, height] = self.quarter();
        self.frame.run_collectively(|| {
            let mut values = fallible::zeros(self.own_waves().len() * height)?;
            let lines = StridedLines {
                values: &mut values,
                stride: height,
                entry: 0..height,
            };
            let distances = self.distances.as_ref();
            of_samples(is_odd, &self.frame, distances, 1.0, lines, |j, samples| {
                for (i, sample) in samples.iter_mut().enumerate() {
                    *sample = at(i, j);
                }
            })?;
            Ok(values)
        })
    }
}

/// Transfers the memory of tiles to the other order, regardless of the content of the tiles. `width` is the number of
/// tiles in a band of the first order.
fn lend(plan: &Plan<f64>, width: usize, from: &mut [Tile], to: &mut [Tile], spare: &mut Vec<Tile>) {
    if plan.frame.share.is_none() {
        return exchange(from, to, width);
    }
    // A rank may have more tiles in one order than in the other.
    spare.extend(from.iter_mut().map(std::mem::take));
    to.fill_with(|| spare.pop().unwrap_or_else(|| unwrap_or_abort(Tile::zero())));
}

/// Allocates nine kernels of a column of waves.
fn table(plan: &Plan<f64>) -> Result<Vec<f64>> {
    fallible::zeros(9 * (plan.frame.torus[1] / 2 + 1))
}

/// Nine kernels, indexed by displacement or stress component and by traction.
pub(crate) trait Kernels: Sync {
    /// Returns whether each kernel is odd in x and in y.
    fn is_odd(&self) -> [[[bool; 2]; 3]; 3];

    /// Adds the spectrum of one kernel at the wave number `kx`, times a factor, to `out`.
    fn add(&self, out: &mut [f64], entry: [usize; 2], factor: f64, kx: usize);
}

impl Superposition {
    /// Creates the transforms for the fields of a torus.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub(crate) fn new(torus: &Torus) -> Result<Self> {
        let own = [torus.frame.size[0], torus.frame.local_rows().len()];
        memory("the transforms of tractions and stresses", own, 96)?;
        let plan = Plan::new(torus.frame.clone());
        let mut results = plan.tiles()?;
        let Tiles {
            by_rows,
            by_columns,
            spare,
            ..
        } = &mut results;
        for (rows, columns) in by_rows.iter_mut().zip(by_columns) {
            lend(&plan, plan.tiles_across(), rows, columns, spare);
        }
        Ok(Self {
            sources: plan.tiles()?,
            results,
            scratch: plan.scratch()?,
            columns: Pool::of(1, || table(&plan))?,
            plan,
            is_loaded: false,
        })
    }

    /// Loads and transforms the fields, each times its factor. `None` means a field of zeros.
    pub(crate) fn load(&mut self, fields: [Option<&[f64]>; 3], factors: [f64; 3]) {
        let Self {
            plan,
            sources,
            scratch,
            is_loaded,
            ..
        } = self;
        let Tiles {
            by_rows,
            occupied,
            by_columns,
            spare,
        } = sources;
        for n in 0..3 {
            let (rows, columns) = (&mut by_rows[n], &mut by_columns[n]);
            if *is_loaded {
                lend(plan, plan.tiles_along(), columns, rows, spare);
            }
            let own = &mut occupied[n][plan.own_tile_rows()];
            match fields[n] {
                Some(x) => plan.forward_rows(x, factors[n], rows, own, &scratch.rows),
                None => own.fill(false),
            }
            plan.to_columns(rows, columns, &mut occupied[n], spare);
        }
        *is_loaded = true;
    }

    /// Writes the sums of the convolutions of the loaded fields to three fields, each times its factor.
    pub(crate) fn convolve(
        &mut self,
        kernels: &impl Kernels,
        out: [&mut [f64]; 3],
        factors: [f64; 3],
    ) {
        let Self {
            plan,
            sources,
            results,
            scratch,
            columns,
            ..
        } = self;
        let height = plan.frame.torus[1] / 2 + 1;
        let parity = Parity::new(kernels.is_odd());
        let Tiles {
            by_rows,
            by_columns,
            spare,
            ..
        } = results;
        plan.columns_between(
            sources.by_columns.each_ref().map(|tiles| &tiles[..]),
            &sources.occupied,
            by_columns.each_mut().map(|tiles| &mut tiles[..]),
            &scratch.columns,
            |kx, waves| {
                columns.lend(
                    || table(plan),
                    |table| {
                        table.fill(0.0);
                        for (k, values) in table.chunks_exact_mut(height).enumerate() {
                            let entry @ [i, j] = [k / 3, k % 3];
                            let factor = if parity.negates(i, j) { -1.0 } else { 1.0 };
                            kernels.add(values, entry, factor, kx);
                        }
                        let entry = |k: usize| &table[k * height..(k + 1) * height];
                        parity.multiply(from_fn(|i| from_fn(|j| entry(3 * i + j))), waves);
                    },
                );
            },
        );
        let normalisation = 1.0 / plan.cells_of_torus();
        for (n, out) in out.into_iter().enumerate() {
            plan.to_rows(&mut by_columns[n], &mut by_rows[n], spare);
            plan.inverse_rows(&by_rows[n], out, factors[n] * normalisation, &scratch.rows);
            let (rows, columns) = (&mut by_rows[n], &mut by_columns[n]);
            lend(plan, plan.tiles_across(), rows, columns, spare);
        }
    }

    /// Runs work on fields of this size in the thread pool of the caller, which is entered once.
    pub(crate) fn enter<T: Send>(&mut self, work: impl FnOnce(&mut Self) -> T + Send) -> T {
        parallel::enter_with(self.plan.cells(), || work(self))
    }
}
