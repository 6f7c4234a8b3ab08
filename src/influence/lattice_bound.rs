//! Conservative estimates of the smallest eigenvalues on free grids, computed on the infinite lattice of their cells.

use std::f64::consts::{PI, TAU};

use crate::bodies::component::Component;
use crate::bodies::kernel::Kernel;
use crate::bodies::layers::Response;
use crate::grid::Grid;
use crate::grid::cell_value::CellValue;

/// Number of steps of the phase from zero to a wave of two cells per period.
const STEPS: i32 = 16;
/// Number of octaves below the first step.
const OCTAVES: i32 = 12;
/// Number of shells of aliases in the sum.
const SHELLS: i32 = 12;

/// Hermitian 2 x 2 matrix: its diagonal, and the off-diagonal entry, which is real or imaginary. A 1 x 1 matrix is stored as a
/// diagonal matrix.
type HermitianPair = [f64; 3];

/// Returns a lower estimate of the eigenvalues of the compliance for some directions. The estimate is valid for any rectangle of
/// cells of a free grid.
///
/// Let $`C_j`$ be the coefficients at all distances j of an infinite lattice, and
/// $`S(\theta) = \sum_j C_j\,e^{-i\theta \cdot j}`$. Tractions t that vanish outside some cells have the energy
///
/// ```math
/// t' C t = \frac{1}{4 \pi^2} \int \hat t^*\,S(\theta)\,\hat t\;\mathrm{d}\theta \ge \min_\theta
/// \lambda_{min}(S(\theta))\;t't ,
/// ```
///
/// so no continuation of the kernel is needed. By the Poisson sum formula, S is the sum over the aliases of a wave with
/// the factors of a cell,
///
/// ```math
/// S(\theta) = \sum_m \hat C(k_m)\,\frac{\sin(k_x h_x/2)}{k_x h_x/2}\,\frac{\sin(k_y h_y/2)}{k_y h_y/2}, \qquad
/// k_m = (\theta + 2 \pi m)/h ,
/// ```
///
/// times $`1 + (4 - 2\cos\theta_x - 2\cos\theta_y)/24`$ for values at [centres](CellValue::Centre). Shells of aliases alternate
/// in sign and decrease as the inverse cube of their number. The last shell of the sum therefore bounds the sum of all omitted
/// shells. S is even in each phase. It is smooth except at phase zero, where it has a pole (or a limit for a body on a rigid
/// base). It is sampled in steps of pi/16, and in twelve octaves below the first step. If a sample is a minimum along an axis, it
/// is lowered by half of the second difference along this axis. A parabola through the samples can fall below the sample by at
/// most two thirds of this reduction. If S decreases towards phase zero, the sample is lowered by the decrease over the last
/// octave. The result is a conservative estimate of the smallest eigenvalue, not an enclosure. It is zero if S is NaN.
///
/// On a grid that is periodic along y, tractions contain only the phases of the waves that fit the period along y. If there are
/// few of these phases, they are sampled. Phase zero corresponds to a wave along x of infinite length, which tractions without a
/// mean do not contain. The energy of such tractions is the integral over all other phases. The result is therefore the bound for
/// tractions without a mean.
pub(crate) fn least_of_lattice<const N: usize>(
    (grid, repeats_along_y): (Grid, bool),
    bodies: &Kernel,
    cell_value: CellValue,
    components: [[Component; N]; N],
) -> f64 {
    let (first, last) = (components[0], components[N - 1]);
    let beside = (N > 1).then_some(first[N - 1]);
    let parts = [Some(first[0]), Some(last[N - 1]), beside];
    let octaves = (1..=OCTAVES).rev().map(|n| (-f64::from(n)).exp2());
    let steps = std::iter::once(0.0)
        .chain(octaves)
        .chain((1..=STEPS).map(f64::from));
    let phases: Vec<f64> = steps.map(|step| PI / f64::from(STEPS) * step).collect();
    let width = phases.len();
    let waves = repeats_along_y.then(|| waves_along_y(grid.ny())).flatten();
    let is_smooth_along_y = waves.is_none();
    let phases_y = waves.unwrap_or_else(|| phases.clone());
    let count = width * phases_y.len();
    // Phase zero does not belong to a wave.
    let mut samples = vec![f64::INFINITY; count];
    for n in 1..count {
        let theta = [phases[n % width], phases_y[n / width]];
        let cosines: f64 = theta.iter().map(|theta| theta.cos()).sum();
        let factor = match cell_value {
            CellValue::Uniform => 1.0,
            CellValue::Centre => 1.0 + (4.0 - 2.0 * cosines) / 24.0,
        };
        samples[n] = factor * least(aliases(grid, bodies, parts, theta));
    }
    if samples.iter().any(|sample| sample.is_nan()) {
        return 0.0;
    }
    let lowered = |n: usize, stride: usize| {
        if stride == width && !is_smooth_along_y {
            return 0.0;
        }
        let (own, place) = (samples[n], n / stride % width);
        let after = if place + 1 < width {
            n + stride
        } else {
            n - stride
        };
        let before = if place > 0 { n - stride } else { after };
        let rises = [before, after].map(|beside| samples[beside] - own);
        match rises {
            [_, rise] if before == 0 => rise.max(0.0),
            rises if rises[0].min(rises[1]) < 0.0 => 0.0,
            [before, after] => 0.5 * (before + after),
        }
    };
    let bounds = (1..count).map(|n| samples[n] - lowered(n, 1) - lowered(n, width));
    bounds.fold(f64::INFINITY, f64::min)
}

/// Returns the phases along y of the waves of a periodic grid. Returns `None` if sampling all phases requires fewer samples.
fn waves_along_y(cells: usize) -> Option<Vec<f64>> {
    let waves = 0..=cells / 2;
    (cells < 2 * STEPS as usize).then(|| waves.map(|n| TAU * n as f64 / cells as f64).collect())
}

/// Returns the sum over the aliases of a phase, and the last shell, which bounds the omitted aliases.
fn aliases(
    grid: Grid,
    bodies: &Kernel,
    parts: [Option<Component>; 3],
    theta: [f64; 2],
) -> (HermitianPair, HermitianPair) {
    let (mut sum, mut shell) = ([0.0; 3], [0.0; 3]);
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
            let found: Response = bodies.short_times_k(k);
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

/// Returns the aliases whose larger number along an axis is `number`.
fn shell_of(number: i32) -> impl Iterator<Item = [i32; 2]> {
    let all = -number..=number;
    all.clone()
        .flat_map(move |y| all.clone().map(move |x| [x, y]))
        .filter(move |[x, y]| x.abs().max(y.abs()) == number)
}

fn sinc(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

/// Returns the smallest eigenvalue minus a bound on the norm of the unknown part.
fn least(([xx, yy, xy], unknown): (HermitianPair, HermitianPair)) -> f64 {
    let radius = (0.5 * (xx - yy)).hypot(xy);
    0.5 * (xx + yy) - radius - unknown.iter().map(|part| part.abs()).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bodies::layers::Layer;
    use crate::bodies::material::{ElasticPair, Material};

    /// Checks a bed on a rigid base, which has no pole. Long waves compress it with its oedometric compliance, which is
    /// zero for an incompressible bed.
    #[test]
    fn a_bed_on_a_rigid_base_is_stiffest_for_long_waves() {
        for (nu, side) in [(0.5, 0.05), (0.5, 2.0), (0.45, 1.0)] {
            let bed = Layer::new(2.0 * (1.0 + nu), nu, 1.0).unwrap();
            let body = Material::rigid().coated(&[bed]).unwrap();
            let bodies = Kernel::from(ElasticPair::new(body, Material::rigid()).unwrap());
            let grid = Grid::new(24, 20, side, side).unwrap();
            let oedometric = (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu));
            let bound = least_of_lattice(
                (grid, false),
                &bodies,
                CellValue::Uniform,
                [[Component::ZZ]],
            );
            assert!(
                bound <= oedometric * (1.0 + 1e-9) + 1e-9,
                "{nu} {side}: {bound}"
            );
        }
    }

    /// Checks that the bound is zero for bodies whose response is NaN.
    #[test]
    fn what_is_not_a_number_bounds_nothing() {
        let near = ElasticPair::new(Material::new(1.0, 0.3).unwrap(), Material::rigid()).unwrap();
        let response = move |k: f64| match near.response(k) {
            Ok(found) if !(3.0..4.0).contains(&k) => found,
            _ => near.response(f64::MAX).unwrap().map(|_| f64::NAN),
        };
        let kernel = Kernel::isotropic(near, 1.0, response).unwrap();
        let grid = Grid::new(8, 8, 1.0, 1.0).unwrap();
        let bound = least_of_lattice(
            (grid, false),
            &kernel,
            CellValue::Uniform,
            [[Component::ZZ]],
        );
        assert!(bound.abs() < f64::MIN_POSITIVE);
    }
}
