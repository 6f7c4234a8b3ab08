//! The transform of one influence coefficient: one real quarter plane.

use std::ops::Range;

use realfft::RealFftPlanner;

use crate::influence::Kernel;
use crate::parallel::{self, Blocks};

/// Where numbers go: the places `entry` of each piece of `stride` numbers.
pub(super) struct Lines<'a> {
    pub(super) values: &'a mut [f64],
    pub(super) stride: usize,
    pub(super) entry: Range<usize>,
}

/// Writes the transform of a kernel on an `mx` x `my` torus, or its imaginary part, times `sign`: a line
/// of `my / 2 + 1` numbers for each wave number `0..=mx/2` along x.
pub(super) fn transform(kernel: &Kernel, torus: [usize; 2], sign: f64, lines: Lines<'_>) {
    match kernel {
        Kernel::Table(table) | Kernel::Rows(table) => {
            let is_odd = table.component().is_odd();
            of_samples(is_odd, torus, sign, lines, |i, j| table.at(i, j));
        }
        Kernel::Symbols(symbols) => {
            let Lines {
                values,
                stride,
                entry,
            } = lines;
            parallel::rows(values, stride, |column, out| {
                for (row, value) in out[entry.clone()].iter_mut().enumerate() {
                    *value = sign * symbols.at([column, row]);
                }
            });
        }
    }
}

/// Transforms a kernel whose samples reach at least half around the torus.
///
/// Along an axis the sample `d` of the torus is that at distance `min(d, m - d)`, with the sign of
/// its parity; an odd kernel vanishes half way around.
pub(super) fn of_samples(
    [is_odd_x, is_odd_y]: [bool; 2],
    [mx, my]: [usize; 2],
    sign: f64,
    lines: Lines<'_>,
    at: impl Fn(usize, usize) -> f64 + Sync,
) {
    // An odd axis contributes -i: one makes the spectrum imaginary, two turn its sign.
    let sign = if is_odd_x || is_odd_y { -sign } else { sign };

    // Along x, one row per distance in y; then along y, one column per wave number in x.
    let (width, height) = (mx / 2 + 1, my / 2 + 1);
    let mut rows = vec![0.0; width * height];
    let row_lines = Lines {
        values: &mut rows,
        stride: width,
        entry: 0..width,
    };
    half_transforms(mx, is_odd_x, row_lines, |j, i| at(i, j));
    half_transforms(my, is_odd_y, lines, |i, j| sign * rows[j * width + i]);
}

/// For each line, the cosine (even) or sine (odd) sums `sum_d f(line, d) e^(2 pi i k d/m)` of the samples
/// wrapped around a circle of `m`, for `k = 0..=m/2`.
fn half_transforms(
    m: usize,
    is_odd: bool,
    lines: Lines<'_>,
    sample: impl Fn(usize, usize) -> f64 + Sync,
) {
    let Lines {
        values,
        stride,
        entry,
    } = lines;
    let half = m / 2 + 1;
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(m);
    let count = values.len() / stride;
    let per_task = count.div_ceil(parallel::lanes());
    let data = Blocks {
        items: values,
        width: per_task * stride,
    };
    let work = |task: usize, block: Blocks<'_, f64>| {
        let mut wrapped = transform.make_input_vec();
        let mut complex = transform.make_output_vec();
        let mut scratch = transform.make_scratch_vec();
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
    };
    parallel::sweep(0..count.div_ceil(per_task), data, &work, &|(), ()| ());
}
