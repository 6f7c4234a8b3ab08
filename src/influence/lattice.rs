//! A bound of the eigenvalues of free grids by those of the infinite lattice of their cells.

use std::f64::consts::{PI, TAU};

use crate::cell_value::CellValue;
use crate::grid::Grid;
use crate::influence::Component;
use crate::kernel::Kernel;
use crate::layers::Response;

/// Steps of the phase from no wave to two cells a period.
const STEPS: usize = 16;
/// Shells of aliases that are added up.
const SHELLS: i32 = 12;

/// A Hermitian matrix of two rows: its diagonal, and the entry beside it, real or imaginary. Of one row it is diagonal.
type Pair = [f64; 3];

/// A bound from below of the eigenvalues of the compliance of some directions, of any rectangle of the cells of a free grid.
///
/// Let $`C_j`$ be the coefficients at all distances j of an infinite lattice, and $`S(\theta) = \sum_j C_j\,e^{-i\theta
/// \cdot j}`$. Tractions t that vanish beyond some cells have the energy
///
/// ```math
/// t' C t = \frac{1}{4 \pi^2} \int \hat t^*\,S(\theta)\,\hat t\;\mathrm{d}\theta \ge \min_\theta
/// \lambda_{min}(S(\theta))\;t't ,
/// ```
///
/// no continuation of the kernel is needed. By Poisson's sum S adds up the aliases of a wave, with the factors of a cell,
///
/// ```math
/// S(\theta) = \sum_m \hat C(k_m)\,\frac{\sin(k_x h_x/2)}{k_x h_x/2}\,\frac{\sin(k_y h_y/2)}{k_y h_y/2}, \qquad
/// k_m = (\theta + 2 \pi m)/h ,
/// ```
///
/// times $`1 + (4 - 2\cos\theta_x - 2\cos\theta_y)/24`$ for values at [centres](CellValue::Centre). Shells of aliases
/// alternate in sign and fall as the cube of their number: the last one that is added bounds the sum of all that are not.
/// S is even in each phase, smooth but for its pole at no phase, and is sampled in steps of pi/16. A sample that is the least
/// one along an axis is taken to be lower by a quarter of the second difference along it, twice what a parabola through the
/// samples may be lower between them. The bound is as sure as these two remarks.
pub(crate) fn least_of_lattice<const N: usize>(
    grid: Grid,
    bodies: &Kernel,
    cell_value: CellValue,
    components: [[Component; N]; N],
) -> f64 {
    let (first, last) = (components[0], components[N - 1]);
    let beside = (N > 1).then_some(first[N - 1]);
    let parts = [Some(first[0]), Some(last[N - 1]), beside];
    let phases = |n: usize| PI * n as f64 / STEPS as f64;
    let width = STEPS + 1;
    let samples: Vec<f64> = (0..width * width)
        .map(|n| {
            let theta = [phases(n % width), phases(n / width)];
            let cosines: f64 = theta.iter().map(|theta| theta.cos()).sum();
            let factor = match cell_value {
                CellValue::Uniform => 1.0,
                CellValue::Centre => 1.0 + (4.0 - 2.0 * cosines) / 24.0,
            };
            factor * least(aliases(grid, bodies, parts, theta))
        })
        .collect();
    // The mean, which has no bound, is left out.
    let at = |x: usize, y: usize| samples[y * width + x];
    let mut bound = f64::INFINITY;
    for n in 1..width * width {
        let (x, y) = (n % width, n / width);
        let own = at(x, y);
        let beside = |place: usize| {
            let next = if place < STEPS { place + 1 } else { STEPS - 1 };
            [place.abs_diff(1), next]
        };
        let between = |[before, after]: [f64; 2]| {
            let rises = [before - own, after - own];
            if rises[0].min(rises[1]) >= 0.0 {
                0.25 * (rises[0] + rises[1])
            } else {
                0.0
            }
        };
        let lower = between(beside(x).map(|x| at(x, y))) + between(beside(y).map(|y| at(x, y)));
        if lower.is_finite() {
            bound = bound.min(own - lower);
        }
    }
    bound
}

/// The sum over the aliases of a phase, less what those left out may take from its least eigenvalue; infinite at no phase.
fn aliases(
    grid: Grid,
    bodies: &Kernel,
    parts: [Option<Component>; 3],
    theta: [f64; 2],
) -> (Pair, Pair) {
    let (mut sum, mut shell) = ([0.0; 3], [0.0; 3]);
    if theta.iter().all(|phase| *phase == 0.0) {
        return ([f64::INFINITY, f64::INFINITY, 0.0], shell);
    }
    let sides = [grid.dx(), grid.dy()];
    for number in 0..=SHELLS {
        shell = [0.0; 3];
        for m in shell_of(number) {
            let phase: [f64; 2] =
                std::array::from_fn(|axis| theta[axis] + TAU * f64::from(m[axis]));
            let factor = phase.map(|phase| sinc(0.5 * phase)).iter().product::<f64>();
            if factor == 0.0 {
                continue;
            }
            let [x, y] = std::array::from_fn(|axis| phase[axis] / sides[axis]);
            let k = x.hypot(y);
            let found: Response = bodies.times_k(k);
            for (sum, part) in shell.iter_mut().zip(parts) {
                let part = part.map_or(0.0, |part| part.of_response(found, [x / k, y / k]));
                *sum += factor * part / k;
            }
        }
        for (sum, part) in sum.iter_mut().zip(shell) {
            *sum += part;
        }
    }
    (sum, shell)
}

/// The aliases whose larger number along an axis is this one.
fn shell_of(number: i32) -> impl Iterator<Item = [i32; 2]> {
    let all = -number..=number;
    all.clone()
        .flat_map(move |y| all.clone().map(move |x| [x, y]))
        .filter(move |[x, y]| x.abs().max(y.abs()) == number)
}

fn sinc(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

/// The least eigenvalue, less the norm of what is not known.
fn least(([xx, yy, xy], unknown): (Pair, Pair)) -> f64 {
    let radius = (0.5 * (xx - yy)).hypot(xy);
    let radius = if radius.is_nan() { 0.0 } else { radius };
    0.5 * (xx + yy) - radius - unknown.iter().map(|part| part.abs()).sum::<f64>()
}
