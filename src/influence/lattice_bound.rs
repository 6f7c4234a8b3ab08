//! An estimate from below of the eigenvalues of free grids by those of the infinite lattice of their cells.

use std::f64::consts::{PI, TAU};

use crate::bodies::component::Component;
use crate::bodies::kernel::Kernel;
use crate::bodies::layers::Response;
use crate::grid::Grid;
use crate::grid::cell_value::CellValue;

/// Steps of the phase from no wave to two cells a period.
const STEPS: i32 = 16;
/// Octaves below the first step.
const OCTAVES: i32 = 12;
/// Shells of aliases that are added up.
const SHELLS: i32 = 12;

/// A Hermitian matrix of two rows: its diagonal, and the entry beside it, real or imaginary. Of one row it is diagonal.
type HermitianPair = [f64; 3];

/// An estimate from below of the eigenvalues of the compliance of some directions, of any rectangle of the cells of a free
/// grid.
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
/// S is even in each phase and smooth but at no phase, where it has a pole, or on a rigid base a limit. It is sampled in
/// steps of pi/16, and from there by twelve octaves below them. A sample that is the least one along an axis is lowered
/// by half of the second difference along it, at least 1.5 times as much as a parabola through the samples may be lower
/// between them; and where S falls towards no phase, by what it falls over the last octave. So it is an estimate of the
/// least eigenvalue on the safe side, not an enclosure. Zero where S is not a number.
///
/// On a grid that repeats along y, tractions have the phases of its waves along y alone. They are sampled if they are few.
/// No phase stands for a wave along x of infinite length, which tractions without a mean do not contain: their energy is
/// the integral over all other phases, and the bound is that of tractions without a mean.
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
    // No wave has no phase.
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

/// The phases along y of the waves of a grid of some cells that repeats; `None` if samples of all phases are fewer.
fn waves_along_y(cells: usize) -> Option<Vec<f64>> {
    let waves = 0..=cells / 2;
    (cells < 2 * STEPS as usize).then(|| waves.map(|n| TAU * n as f64 / cells as f64).collect())
}

/// The sum over the aliases of a phase, and the last shell of them, which bounds those left out.
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
fn least(([xx, yy, xy], unknown): (HermitianPair, HermitianPair)) -> f64 {
    let radius = (0.5 * (xx - yy)).hypot(xy);
    0.5 * (xx + yy) - radius - unknown.iter().map(|part| part.abs()).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bodies::layers::Layer;
    use crate::bodies::material::{ElasticPair, Material};

    /// On a rigid base there is no pole: long waves press a bed by its oedometric compliance, an incompressible one not at
    /// all.
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

    /// Nothing is known of bodies whose response is not a number.
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
