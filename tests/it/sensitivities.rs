//! Sensitivities agree with central differences of solves whose cells keep their sets.

mod cost;
mod coupled;
mod history;
mod normal;
mod tangential;

use stickslip::layers::Layer;
use stickslip::sensitivity::Sensitivity;
use stickslip::{
    Boundary, CellValue, ElasticPair, Field, Grid, HalfSpace, Kernel, Material, surface,
};

/// Tolerance of the solves whose differences are computed.
const SOLVE: f64 = 1e-13;

/// Relative error that a derivative may have.
const ALLOWED: f64 = 1e-6;

/// Type of the bodies of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Bodies {
    /// Homogeneous bodies of different materials.
    Homogeneous,
    /// Two equal bodies.
    Equal,
    Coated,
    Kernel,
}

/// Bodies and gap of a scene, which a test changes slightly.
#[derive(Debug, Clone)]
struct Surface {
    bodies: Bodies,
    /// Factor of all moduli.
    scale: f64,
    poisson_ratios: [f64; 2],
    boundary: Boundary,
    cell_value: CellValue,
    gap: Field,
}

impl Surface {
    fn sphere(bodies: Bodies, cell_value: CellValue) -> Self {
        let grid = Grid::square(32, 12.0).unwrap();
        Self {
            bodies,
            scale: 1.0,
            poisson_ratios: match bodies {
                Bodies::Homogeneous => [0.2, 0.35],
                _ => [0.3; 2],
            },
            boundary: Boundary::NonPeriodic,
            cell_value,
            gap: surface::sphere(grid, 20.0).unwrap(),
        }
    }

    fn rough(bodies: Bodies, boundary: Boundary) -> Self {
        let grid = Grid::square(32, 64.0).unwrap();
        Self {
            gap: kit::rough(grid, 4),
            boundary,
            ..Self::sphere(bodies, CellValue::Uniform)
        }
    }

    fn bodies(&self) -> HalfSpace {
        let moduli = [1.0, 2.5].map(|modulus| modulus * self.scale);
        let [one, two] = [0, 1].map(|n| Material::new(moduli[n], self.poisson_ratios[n]).unwrap());
        let equal = Material::new(moduli[0], self.poisson_ratios[1]).unwrap();
        let layer = Layer::new(4.0 * self.scale, 0.2, 0.8).unwrap();
        let coated = ElasticPair::new(one.coated(&[layer]).unwrap(), Material::rigid()).unwrap();
        let kernel = match self.bodies {
            Bodies::Homogeneous => ElasticPair::new(one, two).unwrap().into(),
            Bodies::Equal => ElasticPair::new(one, equal).unwrap().into(),
            Bodies::Coated => coated.into(),
            Bodies::Kernel => {
                let near = Material::new(4.0 * self.scale, 0.2).unwrap();
                let near = ElasticPair::new(near, Material::rigid()).unwrap();
                Kernel::isotropic(near, 0.8, move |k| coated.response(k).unwrap()).unwrap()
            }
        };
        let bodies = HalfSpace::with_boundary(self.gap.grid(), kernel, self.boundary).unwrap();
        bodies.with_cell_value(self.cell_value).unwrap()
    }
}

/// Returns numbers of both signs between 0.5 and 1.5 in magnitude, mostly positive.
fn random_field(grid: Grid, seed: u64) -> Field {
    let mut random = kit::Random(seed);
    Field::from_fn(grid, |_, _| {
        let sign = if random.chance(0.2) { -1.0 } else { 1.0 };
        sign * random.uniform(0.5, 1.5)
    })
}

/// Returns the scalar product of the derivative with respect to a field and a direction.
fn along(derivative: Option<&Field>, direction: &Field) -> f64 {
    let derivative = derivative.unwrap().as_slice().iter();
    derivative
        .zip(direction.as_slice())
        .map(|(d, v)| d * v)
        .sum()
}

/// Input of a scene, the size of its changes, and the derivative with respect to it.
struct Change<'a, I> {
    name: &'a str,
    input: I,
    size: f64,
    derivative: Box<dyn Fn(&Sensitivity) -> f64 + 'a>,
}

impl<'a, I> Change<'a, I> {
    fn new(
        name: &'a str,
        input: I,
        size: f64,
        derivative: impl Fn(&Sensitivity) -> f64 + 'a,
    ) -> Self {
        Self {
            name,
            input,
            size,
            derivative: Box::new(derivative),
        }
    }
}

/// Asserts that the derivatives along all changes at once equal extrapolated central differences with this relative step. If
/// they do not, each change is compared alone, so that the message names the wrong one.
///
/// `solved` returns the values of all functionals and a description of the sets after changes of the inputs.
#[track_caller]
fn assert_differences<I: Copy, S: PartialEq>(
    name: &str,
    step: f64,
    found: &[Sensitivity],
    changes: &[Change<'_, I>],
    solved: impl Fn(&[(I, f64)]) -> (Vec<f64>, S),
) {
    let (_, sets) = solved(&[]);
    let fault = |changes: &[Change<'_, I>]| {
        let slopes = |step: f64| {
            let [more, less] = [step, -step].map(|step| {
                let moves = changes
                    .iter()
                    .map(|change| (change.input, step * change.size));
                let (values, moved) = solved(&moves.collect::<Vec<_>>());
                (moved == sets).then_some(values)
            });
            let pairs = more?.into_iter().zip(less?);
            Some(pairs.map(move |(more, less)| (more - less) / (2.0 * step)))
        };
        let (Some(narrow), Some(wide)) = (slopes(step), slopes(2.0 * step)) else {
            return Some("the sets differ".to_owned());
        };
        let mut compared = found.iter().zip(narrow.zip(wide)).enumerate();
        compared.find_map(|(n, (found, (narrow, wide)))| {
            let expected = (4.0 * narrow - wide) / 3.0;
            let parts = changes
                .iter()
                .map(|change| change.size * (change.derivative)(found));
            let derivative: f64 = parts.sum();
            // A derivative that vanishes is compared with the round-off of the difference.
            let round_off = 1e-12 * found.value.abs() / step;
            let error = (derivative - expected).abs();
            (error > ALLOWED * expected.abs() + round_off)
                .then(|| format!("{derivative:e} of functional {n} for {expected:e}"))
        })
    };
    if let Some(message) = fault(changes) {
        for change in changes {
            let alone = fault(std::slice::from_ref(change));
            assert!(
                alone.is_none(),
                "{name}: {}: {}",
                change.name,
                alone.unwrap_or_default()
            );
        }
        panic!("{name}: all changes at once: {message}");
    }
}
