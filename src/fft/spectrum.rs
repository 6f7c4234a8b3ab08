//! The transform of one influence coefficient, stored as one real quarter plane.

use std::ops::Range;
use std::sync::Arc;

use num_complex::Complex;
use realfft::RealFftPlanner;

use crate::error::Result;
use crate::fft::torus::TorusLayout;
use crate::influence::InfluenceKernel;
use crate::memory::fallible;
use crate::parallel::ranks::partition::RowPartition;
use crate::parallel::{self, Blocks};

/// Destination of values: the range `entry` of each chunk of `stride` numbers.
pub(super) struct StridedLines<'a> {
    pub(super) values: &'a mut [f64],
    pub(super) stride: usize,
    pub(super) entry: Range<usize>,
}

/// Writes the transform of a kernel on the `mx` x `my` torus of a frame, multiplied by `sign`. For an imaginary
/// transform it writes the imaginary part. Each local wave number along x, of `0..=mx/2`, has a line of `my / 2 + 1`
/// numbers.
///
/// # Errors
/// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
pub(super) fn transform(
    kernel: &InfluenceKernel,
    frame: &TorusLayout,
    sign: f64,
    lines: StridedLines<'_>,
) -> Result<()> {
    match kernel {
        InfluenceKernel::Table(table) | InfluenceKernel::Rows(table) => {
            let is_odd = table.component().is_odd();
            let row = |j: usize, samples: &mut [f64]| table.write_row(j, samples);
            of_samples(is_odd, frame, table.share(), sign, lines, row)
        }
        InfluenceKernel::Symbols(symbols) => {
            let StridedLines {
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

/// Transforms a kernel whose samples reach at least half around the torus. `row` writes the samples of one distance
/// along y.
///
/// Along an axis of `m` samples, sample `d` of the torus is the kernel at the distance `min(d, m - d)`. The parity of
/// the kernel determines its sign. An odd kernel vanishes halfway around the torus. If the rows of the samples are
/// distributed, each rank transforms its own rows along x and its own columns along y. Between the two transforms the
/// ranks exchange the samples collectively.
///
/// # Errors
/// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
/// - [`Error::Ranks`](crate::Error::Ranks) if a rank fails.
pub(super) fn of_samples(
    [is_odd_x, is_odd_y]: [bool; 2],
    frame: &TorusLayout,
    share: Option<&Arc<RowPartition>>,
    sign: f64,
    lines: StridedLines<'_>,
    row: impl Fn(usize, &mut [f64]) + Sync,
) -> Result<()> {
    // Each odd axis contributes a factor of -i. One odd axis makes the spectrum imaginary. Two odd axes change its sign.
    let sign = if is_odd_x || is_odd_y { -sign } else { sign };

    // The first transform is along x, with one row per distance along y. The second is along y, with one column per
    // wave number along x.
    let ([mx, my], width) = (frame.torus, frame.width());
    let height = my / 2 + 1;
    let own_rows = share.map_or(0..height, |share| {
        let own = share.local_rows();
        own.start.min(height)..own.end.min(height)
    });
    let transformed = || {
        let mut rows = fallible::zeros(width * own_rows.len())?;
        let row_lines = StridedLines {
            values: &mut rows,
            stride: width,
            entry: 0..width,
        };
        half_transforms(mx, is_odd_x, row_lines, |lines, samples| {
            for (j, samples) in lines.zip(samples.chunks_exact_mut(width)) {
                row(own_rows.start + j, samples);
            }
        })?;
        Ok(rows)
    };
    let (rows, width) = match share {
        Some(share) => {
            let own = frame.own_columns().len();
            let wanted = |rank| [frame.columns_of(rank), 0..height];
            let found = transformed()
                .and_then(|rows| Ok((rows, share.blocks(wanted)?, fallible::zeros(own * height)?)));
            let (rows, blocks, mut found) = share.team().collective_result(found)?;
            share.fetch_into(&rows, width, wanted, blocks, &mut found);
            (found, own)
        }
        None => (transformed()?, width),
    };
    half_transforms(my, is_odd_y, lines, |lines, samples| {
        for (j, row) in rows.chunks_exact(width).enumerate() {
            let line = samples[j..].iter_mut().step_by(height);
            for (sample, value) in line.zip(&row[lines.clone()]) {
                *sample = sign * value;
            }
        }
    })
}

/// Number of lines whose samples are computed together: the numbers in a cache line.
const AT_ONCE: usize = 8;

/// Computes the sums `sum_d f(line, d) e^(2 pi i k d/m)` of each line for `k = 0..=m/2`, with the samples wrapped
/// around a circle of `m`. They are cosine sums for an even kernel and sine sums for an odd kernel. `sample` writes the
/// samples `d = 0..=m/2` of some lines, line by line.
fn half_transforms(
    m: usize,
    is_odd: bool,
    lines: StridedLines<'_>,
    sample: impl Fn(Range<usize>, &mut [f64]) + Sync,
) -> Result<()> {
    let StridedLines {
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
        let mut samples = fallible::zeros(AT_ONCE * half)?;
        let mut wrapped = fallible::zeros(m)?;
        let mut complex = fallible::filled(zero, transform.complex_len())?;
        let mut scratch = fallible::filled(zero, transform.get_scratch_len())?;
        let firsts = (task * per_task..).step_by(AT_ONCE);
        for (first, out) in firsts.zip(block.items.chunks_mut(AT_ONCE * stride)) {
            let lines = out.len() / stride;
            let samples = &mut samples[..lines * half];
            sample(first..first + lines, samples);
            for (samples, out) in samples.chunks(half).zip(out.chunks_exact_mut(stride)) {
                wrap(samples, is_odd, &mut wrapped);
                // The transform fails only for buffers of a wrong length.
                transform
                    .process_with_scratch(&mut wrapped, &mut complex, &mut scratch)
                    .expect("the transform made its own buffers");
                for (out, z) in out[entry.clone()].iter_mut().zip(&complex) {
                    *out = if is_odd { -z.im } else { z.re };
                }
            }
        }
        Ok(())
    };
    parallel::sweep(0..count.div_ceil(per_task), data, &work, &Result::and)
}

/// Wraps samples from zero to half the circle around the circle. Odd samples vanish at the points that are their own
/// images.
fn wrap(samples: &[f64], is_odd: bool, circle: &mut [f64]) {
    let own_image = |sample: f64| if is_odd { 0.0 } else { sample };
    let m = circle.len();
    circle[0] = own_image(samples[0]);
    let (there, back) = circle[1..].split_at_mut((m - 1) / 2);
    let sign = if is_odd { -1.0 } else { 1.0 };
    let places = there.iter_mut().zip(back.iter_mut().rev());
    for ((there, back), sample) in places.zip(&samples[1..]) {
        (*there, *back) = (*sample, sign * sample);
    }
    if m % 2 == 0 {
        back[0] = own_image(samples[m / 2]);
    }
}
