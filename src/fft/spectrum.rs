//! The transform of one influence coefficient: one real quarter plane.

use std::ops::Range;
use std::sync::Arc;

use num_complex::Complex;
use realfft::RealFftPlanner;

use crate::buffer;
use crate::error::Result;
use crate::fft::frame::Frame;
use crate::influence::Kernel;
use crate::parallel::{self, Blocks};
use crate::share::Share;

/// Where numbers go: the places `entry` of each piece of `stride` numbers.
pub(super) struct Lines<'a> {
    pub(super) values: &'a mut [f64],
    pub(super) stride: usize,
    pub(super) entry: Range<usize>,
}

/// Writes the transform of a kernel on the `mx` x `my` torus of a frame, or its imaginary part, times `sign`: a line
/// of `my / 2 + 1` numbers for each wave number along x that is multiplied here, of `0..=mx/2`.
///
/// # Errors
/// [`Error::Memory`](crate::Error::Memory).
pub(super) fn transform(kernel: &Kernel, frame: &Frame, sign: f64, lines: Lines<'_>) -> Result<()> {
    match kernel {
        Kernel::Table(table) | Kernel::Rows(table) => {
            let is_odd = table.component().is_odd();
            let at = |i: usize, j: usize| table.at(i, j);
            of_samples(is_odd, frame, table.share(), sign, lines, at)
        }
        Kernel::Symbols(symbols) => {
            let Lines {
                values,
                stride,
                entry,
            } = lines;
            let first = frame.own_columns().start;
            parallel::rows(values, stride, |column, out| {
                for (row, value) in out[entry.clone()].iter_mut().enumerate() {
                    *value = sign * symbols.at([first + column, row]);
                }
            });
            Ok(())
        }
    }
}

/// Transforms a kernel whose samples reach at least half around the torus.
///
/// Along an axis the sample `d` of the torus is that at distance `min(d, m - d)`, with the sign of
/// its parity; an odd kernel vanishes half way around. Of samples whose rows are dealt out each rank transforms its own
/// along x, and its columns along y; they agree in between.
///
/// # Errors
/// [`Error::Memory`](crate::Error::Memory); [`Error::Ranks`](crate::Error::Ranks).
pub(super) fn of_samples(
    [is_odd_x, is_odd_y]: [bool; 2],
    frame: &Frame,
    share: Option<&Arc<Share>>,
    sign: f64,
    lines: Lines<'_>,
    at: impl Fn(usize, usize) -> f64 + Sync,
) -> Result<()> {
    // An odd axis contributes -i: one makes the spectrum imaginary, two turn its sign.
    let sign = if is_odd_x || is_odd_y { -sign } else { sign };

    // Along x, one row per distance in y; then along y, one column per wave number in x.
    let ([mx, my], width) = (frame.torus, frame.width());
    let height = my / 2 + 1;
    let own_rows = share.map_or(0..height, |share| {
        let own = share.own_rows();
        own.start.min(height)..own.end.min(height)
    });
    let transformed = || {
        let mut rows = buffer::zeros(width * own_rows.len())?;
        let row_lines = Lines {
            values: &mut rows,
            stride: width,
            entry: 0..width,
        };
        half_transforms(mx, is_odd_x, row_lines, |j, i| at(i, own_rows.start + j))?;
        Ok(rows)
    };
    let (rows, width) = match share {
        Some(share) => {
            let own = frame.own_columns().len();
            let found = transformed().and_then(|rows| Ok((rows, buffer::zeros(own * height)?)));
            let (rows, mut found) = share.team().agreed(found)?;
            let wanted = |rank| [frame.columns_of(rank), 0..height];
            share.fetch_into(&rows, width, wanted, &mut found);
            (found, own)
        }
        None => (transformed()?, width),
    };
    half_transforms(my, is_odd_y, lines, |i, j| sign * rows[j * width + i])
}

/// For each line, the cosine (even) or sine (odd) sums `sum_d f(line, d) e^(2 pi i k d/m)` of the samples
/// wrapped around a circle of `m`, for `k = 0..=m/2`.
fn half_transforms(
    m: usize,
    is_odd: bool,
    lines: Lines<'_>,
    sample: impl Fn(usize, usize) -> f64 + Sync,
) -> Result<()> {
    let Lines {
        values,
        stride,
        entry,
    } = lines;
    let half = m / 2 + 1;
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(m);
    let count = values.len() / stride;
    let per_task = count.div_ceil(parallel::lanes()).max(1);
    let data = Blocks {
        items: values,
        width: per_task * stride,
    };
    let work = |task: usize, block: Blocks<'_, f64>| {
        let zero = Complex::new(0.0, 0.0);
        let mut wrapped = buffer::zeros(m)?;
        let mut complex = buffer::filled(zero, transform.complex_len())?;
        let mut scratch = buffer::filled(zero, transform.get_scratch_len())?;
        for (index, out) in block.items.chunks_exact_mut(stride).enumerate() {
            let line = task * per_task + index;
            for d in 0..half {
                let value = sample(line, d);
                let is_own_image = d == 0 || 2 * d == m;
                wrapped[(m - d) % m] = if is_odd { -value } else { value };
                wrapped[d] = if is_odd && is_own_image { 0.0 } else { value };
            }
            // Fails for a wrong length alone; all were made by the transform.
            transform
                .process_with_scratch(&mut wrapped, &mut complex, &mut scratch)
                .expect("the transform made its own buffers");
            for (out, z) in out[entry.clone()].iter_mut().zip(&complex) {
                *out = if is_odd { -z.im } else { z.re };
            }
        }
        Ok(())
    };
    parallel::sweep(0..count.div_ceil(per_task), data, &work, &Result::and)
}
