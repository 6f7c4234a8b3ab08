//! Both methods find the exact minimum of small random problems, and the certificate never underestimates the error.

use kit::Random;
use stickslip::cgm::{self, AbsBound, Bounds, Method, Minimum, NonNegative, Problem, Settings};
use stickslip::dense::DenseOperator;
use stickslip::influence::Component;
use stickslip::{Error, Field, Grid, HalfSpace, Operator, Result, Scratch};

/// Cells, bodies and gap of a small random problem.
struct RandomProblem {
    bodies: HalfSpace,
    gap: Field,
    random: Random,
}

impl RandomProblem {
    fn new(seed: u64) -> Self {
        let mut random = Random(seed);
        let (nx, ny) = (random.integer(1, 12), random.integer(1, 12));
        let dx = 10_f64.powf(random.uniform(-3.0, 3.0));
        let grid = Grid::new(nx, ny, dx, dx * random.uniform(0.3, 3.0)).unwrap();
        let bodies = kit::unit_bodies(grid, random.uniform(0.0, 0.5));
        // The gap consists of a bowl, a tilt and noise of random size.
        let size = dx * nx.max(ny) as f64;
        let (bowl, tilt) = (random.uniform(0.0, 0.3), random.uniform(-0.05, 0.05));
        let noise = size * 10_f64.powf(random.uniform(-4.0, -1.0));
        let gap = Field::from_fn(grid, |x, y| {
            bowl * (x * x + y * y) / size + tilt * x + noise * random.uniform(0.0, 1.0)
        });
        Self {
            bodies,
            gap,
            random,
        }
    }
}

fn settings_of_both_methods() -> [Settings; 2] {
    let settings = Settings::default().tolerance(1e-11);
    [
        settings.method(Method::ActiveSet),
        settings.method(Method::PolonskyKeer),
    ]
}

/// Computes `|x - x*|_C / |x|_C` with the matrix.
fn energy_error(matrix: &DenseOperator, x: &[f64], exact: &[f64]) -> f64 {
    let norm = |v: &[f64]| {
        let mut product = vec![0.0; v.len()];
        matrix.apply([v], [&mut product], &mut Scratch::none());
        v.iter()
            .zip(&product)
            .map(|(a, b)| a * b)
            .sum::<f64>()
            .sqrt()
    };
    let difference: Vec<f64> = x.iter().zip(exact).map(|(a, b)| a - b).collect();
    let size = norm(x);
    if size > 0.0 {
        norm(&difference) / size
    } else {
        norm(&difference)
    }
}

fn assert_certified(found: &Minimum, error: f64, scene: u64) {
    // Allows for round-off of the dense reference, amplified by the condition number.
    let bound = found.report.energy_error_bound() + 1e-12;
    assert!(
        error <= bound,
        "scene {scene}: error {error:e}, certified {bound:e}"
    );
}

#[test]
fn normal_contact_under_force_has_the_exact_minimum() {
    for seed in 0..kit::thorough(60, 200) {
        let mut scene = RandomProblem::new(seed);
        let matrix = DenseOperator::of_half_space(&scene.bodies, Component::ZZ).unwrap();
        let total = 10_f64.powf(scene.random.uniform(-4.0, 1.0)) * scene.gap.grid().nx() as f64;
        let linear = scene.gap.as_slice();
        let exact = matrix.minimise(linear, &NonNegative, Some(total)).unwrap();
        for settings in settings_of_both_methods() {
            let problem = Problem::new(
                scene.bodies.operator(Component::ZZ).unwrap(),
                [linear],
                NonNegative,
            )
            .preconditioner(scene.bodies.preconditioner(Component::ZZ).unwrap().unwrap())
            .total(total);
            let mut x = vec![total / linear.len() as f64; linear.len()];
            let found = cgm::minimise(&problem, &settings, [&mut x])
                .unwrap_or_else(|e| panic!("scene {seed} {:?}: {e}", settings.method));
            let error = energy_error(&matrix, &x, &exact.x);
            assert!(
                error < 1e-9,
                "scene {seed} {:?}: {error:e}",
                settings.method
            );
            assert_certified(&found, error, seed);
            let scale = exact.multiplier.abs().max(kit::max_abs(linear));
            assert!(
                (found.multiplier[0] - exact.multiplier).abs() < 1e-9 * scale,
                "scene {seed}"
            );
            assert!(x.iter().all(|&x| x >= 0.0));
            assert!((x.iter().sum::<f64>() - total).abs() <= 1e-13 * total);
        }
    }
}

#[test]
fn tangential_contact_under_force_has_the_exact_minimum() {
    for seed in 0..kit::thorough(60, 200) {
        let mut scene = RandomProblem::new(1000 + seed);
        let matrix = DenseOperator::of_half_space(&scene.bodies, Component::XX).unwrap();
        let cells = scene.gap.grid().cells();
        // The limits resemble a pressure, and some are zero. There may be slip of an earlier step.
        let limits: Vec<f64> = (0..cells)
            .map(|_| scene.random.uniform(-0.3, 1.0).max(0.0))
            .collect();
        let sum: f64 = limits.iter().sum();
        if sum == 0.0 {
            continue;
        }
        let total = scene.random.uniform(-0.999, 0.999) * sum;
        let remembered = scene.random.uniform(0.0, 1.0).round();
        let linear: Vec<f64> = (0..cells)
            .map(|_| remembered * scene.random.uniform(-0.1, 0.1))
            .collect();
        let exact = matrix
            .minimise(&linear, &AbsBound(&limits), Some(total))
            .unwrap();
        for settings in settings_of_both_methods() {
            let problem = Problem::new(
                scene.bodies.operator(Component::XX).unwrap(),
                [&linear],
                AbsBound(&limits),
            )
            .preconditioner(scene.bodies.preconditioner(Component::XX).unwrap().unwrap())
            .total(total);
            let mut x: Vec<f64> = limits.iter().map(|m| m * total / sum).collect();
            let found = cgm::minimise(&problem, &settings, [&mut x])
                .unwrap_or_else(|e| panic!("scene {seed} {:?}: {e}", settings.method));
            let error = energy_error(&matrix, &x, &exact.x);
            assert!(
                error < 1e-9,
                "scene {seed} {:?}: {error:e}",
                settings.method
            );
            assert_certified(&found, error, seed);
            assert!(x.iter().zip(&limits).all(|(x, m)| x.abs() <= *m));
        }
    }
}

#[test]
fn approach_control_has_the_exact_minimum() {
    for seed in 0..kit::thorough(40, 100) {
        let mut scene = RandomProblem::new(2000 + seed);
        let matrix = DenseOperator::of_half_space(&scene.bodies, Component::ZZ).unwrap();
        let span = scene.gap.max() - scene.gap.min();
        let approach = scene.gap.min() + scene.random.uniform(-0.1, 1.5) * span;
        let linear: Vec<f64> = scene.gap.as_slice().iter().map(|h| h - approach).collect();
        let exact = matrix.minimise(&linear, &NonNegative, None).unwrap();
        for settings in settings_of_both_methods() {
            let problem = Problem::new(
                scene.bodies.operator(Component::ZZ).unwrap(),
                [&linear],
                NonNegative,
            )
            .preconditioner(scene.bodies.preconditioner(Component::ZZ).unwrap().unwrap());
            let mut x = vec![0.0; linear.len()];
            let found = cgm::minimise(&problem, &settings, [&mut x])
                .unwrap_or_else(|e| panic!("scene {seed} {:?}: {e}", settings.method));
            let error = energy_error(&matrix, &x, &exact.x);
            assert!(
                error < 1e-9,
                "scene {seed} {:?}: {error:e}",
                settings.method
            );
            assert_certified(&found, error, seed);
        }
    }
}

/// If the solve is stopped at any iteration, the iterate is feasible and its certificate is valid. The certificate uses
/// the eigenvalue bound. Without the bound it uses the duality gap alone.
#[test]
fn certificate_bounds_error_of_unfinished_iterates() {
    let mut tightness = Vec::new();
    for seed in 0..kit::thorough(80, 200) {
        let mut scene = RandomProblem::new(3000 + seed);
        let matrix = DenseOperator::of_half_space(&scene.bodies, Component::ZZ).unwrap();
        let cells = scene.gap.grid().cells();
        let linear = scene.gap.as_slice();
        let total = 10_f64.powf(scene.random.uniform(-3.0, 1.0));
        let upper: Vec<f64> = (0..cells)
            .map(|_| scene.random.uniform(2.0, 5.0) * total / cells as f64)
            .collect();
        let lower = vec![0.0; cells];
        let interval = Bounds {
            lower: &lower,
            upper: &upper,
        };
        let exact = matrix.minimise(linear, &interval, Some(total)).unwrap();
        for method in [Method::ActiveSet, Method::PolonskyKeer] {
            let steps = scene.random.integer(1, 6);
            let settings = Settings::default()
                .tolerance(1e-12)
                .method(method)
                .max_iterations(steps);
            let fast = Problem::new(
                scene.bodies.operator(Component::ZZ).unwrap(),
                [linear],
                interval.clone(),
            )
            .total(total);
            let unbounded =
                Problem::new(WithoutBound(&matrix), [linear], interval.clone()).total(total);
            let start = vec![total / cells as f64; cells];
            let (mut x, mut y) = (start.clone(), start);
            let found = unwrap_report(cgm::minimise(&fast, &settings, [&mut x]));
            let error = energy_error(&matrix, &x, &exact.x);
            assert!(
                error <= found.energy_error_bound() + 1e-12,
                "scene {seed}: {error:e}, {found}"
            );
            tightness.push((found.energy_error_bound() + 1e-15) / (error + 1e-15));
            let found = unwrap_report(cgm::minimise(&unbounded, &settings, [&mut y]));
            let error = energy_error(&matrix, &y, &exact.x);
            assert!(
                error <= found.energy_error_bound() + 1e-12,
                "scene {seed}: {error:e}, {found}"
            );
            for x in [&x, &y] {
                assert!(x.iter().zip(&upper).all(|(x, u)| (0.0..=*u).contains(x)));
                assert!((x.iter().sum::<f64>() - total).abs() <= 1e-12 * total);
            }
        }
    }
    tightness.sort_by(f64::total_cmp);
    assert!(
        tightness[tightness.len() / 2] < 20.0,
        "median bound over error: {}",
        tightness[tightness.len() / 2]
    );
}

fn unwrap_report(outcome: Result<Minimum>) -> stickslip::Report {
    match outcome {
        Ok(minimum) => minimum.report,
        Err(Error::NotConverged(report)) => *report,
        Err(other) => panic!("{other}"),
    }
}

/// An operator that does not report its smallest eigenvalue.
struct WithoutBound<'a>(&'a DenseOperator);

impl Operator for WithoutBound<'_> {
    fn cells(&self) -> usize {
        self.0.cells()
    }

    fn apply(&self, [x]: [&[f64]; 1], [out]: [&mut [f64]; 1], _: &mut Scratch) {
        self.0.apply([x], [out], &mut Scratch::none());
    }
}

/// Compares the dense reference with minima computed by hand.
#[test]
fn dense_reference_solves_three_unknowns_exactly() {
    let matrix =
        DenseOperator::from_rows(3, vec![2.0, 1.0, 0.0, 1.0, 2.0, 1.0, 0.0, 1.0, 2.0]).unwrap();
    let free = matrix
        .minimise(&[-1.0, 0.5, -1.0], &NonNegative, None)
        .unwrap();
    assert!(kit::max_difference(&free.x, &[0.5, 0.0, 0.5]) < 1e-15);
    // The total gives x_1 = x_3 = (3 - x_2)/2. Equal gradients, 2 x_1 + x_2 - 1 = 2 x_1 + 2 x_2 + 1/2, would require
    // x_2 = -3/2, so that x_2 = 0.
    let held = matrix
        .minimise(&[-1.0, 0.5, -1.0], &NonNegative, Some(3.0))
        .unwrap();
    assert!(kit::max_difference(&held.x, &[1.5, 0.0, 1.5]) < 1e-15);
    assert!((held.multiplier - 2.0).abs() < 1e-15);
}

/// An operator that fails at a given product.
struct LimitedOperator {
    matrix: DenseOperator,
    sound_products: usize,
    products: std::sync::atomic::AtomicUsize,
}

impl Operator for LimitedOperator {
    fn cells(&self) -> usize {
        self.matrix.cells()
    }

    fn apply(&self, [x]: [&[f64]; 1], [out]: [&mut [f64]; 1], _: &mut Scratch) {
        self.matrix.apply([x], [&mut *out], &mut Scratch::none());
        let count = self
            .products
            .fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        if count >= self.sound_products {
            out[out.len() / 2] = f64::NAN;
        }
    }
}

#[test]
fn failing_operator_never_converges() {
    let mut scene = RandomProblem::new(5);
    let linear = scene.gap.as_slice().to_vec();
    let total = scene.random.uniform(0.1, 1.0);
    for method in [Method::ActiveSet, Method::PolonskyKeer] {
        for sound_products in 0..6 {
            for total in [None, Some(total)] {
                let operator = LimitedOperator {
                    matrix: DenseOperator::of_half_space(&scene.bodies, Component::ZZ).unwrap(),
                    sound_products,
                    products: 0.into(),
                };
                let depth = if total.is_none() {
                    scene.gap.max()
                } else {
                    0.0
                };
                let linear: Vec<f64> = linear.iter().map(|h| h - depth).collect();
                let mut problem = Problem::new(operator, [&linear], NonNegative);
                if let Some(total) = total {
                    problem = problem.total(total);
                }
                let mut x = vec![0.01; linear.len()];
                let settings = Settings::default().tolerance(1e-13).method(method);
                let outcome = cgm::minimise(&problem, &settings, [&mut x]);
                let Err(Error::NotConverged(report)) = outcome else {
                    panic!("{method:?} after {sound_products} products: {outcome:?}");
                };
                assert_eq!(report.status, stickslip::Status::Stalled);
                assert!(x.iter().all(|x| x.is_finite() && *x >= 0.0));
            }
        }
    }
}
