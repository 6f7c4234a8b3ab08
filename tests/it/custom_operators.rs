//! The engine works with user-defined operators and constraints of one or two unknowns per cell. Its results satisfy
//! the conditions of the minimum, which are sufficient for a convex problem.

use kit::Random;
use stickslip::cgm::{
    self, Bounds, Constraint, Disc, Interval, NonNegative, Problem, Settings, Total,
};
use stickslip::{Error, Operator, Scratch};

/// A positive definite matrix over all components of all cells, and a lower bound of its eigenvalues if the bound is
/// known.
struct DenseMatrix {
    rows: Vec<Vec<f64>>,
    cells: usize,
    is_symmetric: bool,
    lower_bound: f64,
}

impl DenseMatrix {
    fn random(cells: usize, components: usize, random: &mut Random) -> Self {
        let size = cells * components;
        let root: Vec<Vec<f64>> = (0..size)
            .map(|_| (0..size).map(|_| random.uniform(-1.0, 1.0)).collect())
            .collect();
        let entry = |i: usize, j: usize| {
            let product: f64 = root[i].iter().zip(&root[j]).map(|(a, b)| a * b).sum();
            product + if i == j { 0.1 * size as f64 } else { 0.0 }
        };
        let rows = (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect());
        Self {
            rows: rows.collect(),
            cells,
            is_symmetric: true,
            lower_bound: 0.0,
        }
    }

    /// Adds an antisymmetric matrix with entries as large as the existing entries.
    fn with_antisymmetric_part(mut self, random: &mut Random) -> Self {
        let size = self.rows.len();
        let root = (size as f64).sqrt();
        for i in 0..size {
            for j in 0..i {
                let part = root * random.uniform(-1.0, 1.0);
                self.rows[i][j] += part;
                self.rows[j][i] -= part;
            }
        }
        self.is_symmetric = false;
        self
    }
}

impl<const N: usize> Operator<N> for DenseMatrix {
    fn cells(&self) -> usize {
        self.cells
    }

    fn apply(&self, x: [&[f64]; N], u: [&mut [f64]; N], _: &mut Scratch) {
        for (c, u) in u.into_iter().enumerate() {
            for (i, u) in u.iter_mut().enumerate() {
                let row = self.rows[c * self.cells + i].chunks_exact(self.cells);
                let products = row
                    .zip(x)
                    .flat_map(|(row, x)| row.iter().zip(x).map(|(a, x)| a * x));
                *u = products.sum();
            }
        }
    }

    fn is_symmetric(&self) -> bool {
        self.is_symmetric
    }

    fn lower_bound(&self) -> f64 {
        self.lower_bound
    }
}

/// Discs of given radii, some of which are zero.
struct Discs(Vec<f64>);

impl Constraint<2> for Discs {
    type Set = Disc;

    fn of(&self, cell: usize) -> Disc {
        Disc {
            radius: self.0[cell],
        }
    }
}

/// Intervals with a common centre.
struct Intervals(f64);

impl Constraint for Intervals {
    type Set = Interval;

    fn of(&self, _: usize) -> Interval {
        Interval {
            lower: self.0 - 0.5,
            upper: self.0 + 0.5,
        }
    }
}

/// Returns the scale of the residuals: the larger of the largest displacement and the elongation of the stiffest
/// spring.
fn scale<const N: usize>(totals: [Total; N], u: [&[f64]; N], x: [&[f64]; N]) -> f64 {
    let size = |v: [&[f64]; N], i: usize| v.iter().map(|v| v[i].powi(2)).sum::<f64>().sqrt();
    let cells = 0..x[0].len();
    let largest = cells.clone().fold(0.0, |max: f64, i| max.max(size(u, i)));
    let springs = totals.iter().filter_map(|total| match total {
        Total::Spring { compliance, .. } => Some(*compliance),
        _ => None,
    });
    let magnitude: f64 = cells.map(|i| size(x, i)).sum();
    springs
        .reduce(f64::min)
        .map_or(largest, |compliance| largest.max(compliance * magnitude))
}

fn assert_totals_satisfied<const N: usize>(
    totals: [Total; N],
    x: [&[f64]; N],
    multiplier: [f64; N],
) {
    for ((total, x), multiplier) in totals.into_iter().zip(x).zip(multiplier) {
        let (sum, size): (f64, f64) = (x.iter().sum(), x.iter().map(|x| x.abs()).sum());
        match total {
            Total::Sum(asked) => assert!((sum - asked).abs() < 1e-12 * size),
            Total::Spring {
                far_end,
                compliance,
            } => assert!((multiplier - (far_end - compliance * sum)).abs() < 1e-12 * (1.0 + size)),
            _ => assert_eq!(multiplier, 0.0),
        }
    }
}

#[test]
fn two_unknowns_per_cell_satisfy_minimum_conditions() {
    let settings = Settings::default().tolerance(1e-10);
    for seed in (0..120).step_by(kit::thorough(2, 1)) {
        let mut random = Random(seed);
        let cells = random.integer(1, 20);
        let mut matrix = DenseMatrix::random(cells, 2, &mut random);
        if seed >= 60 {
            matrix = matrix.with_antisymmetric_part(&mut random);
        }
        let mut field = || -> Vec<f64> { (0..cells).map(|_| random.uniform(-3.0, 3.0)).collect() };
        let (bx, by) = (field(), field());
        let radii: Vec<f64> = (0..cells)
            .map(|_| random.uniform(-0.1, 0.3).max(0.0))
            .collect();
        let limit: f64 = radii.iter().sum();
        let mut total = || match random.integer(0, 2) {
            0 => Total::Free,
            1 => Total::Sum(0.6 * limit * random.uniform(-1.0, 1.0)),
            _ => Total::Spring {
                far_end: random.uniform(-2.0, 2.0),
                compliance: 10_f64.powf(random.uniform(-3.0, 3.0)),
            },
        };
        let totals = [total(), total()];
        let problem = Problem::new(&matrix, [&bx, &by], Discs(radii.clone())).totals(totals);
        let (mut x, mut y) = (vec![0.0; cells], vec![0.0; cells]);
        let found = cgm::minimise(&problem, &settings, [&mut x, &mut y])
            .unwrap_or_else(|error| panic!("{seed} {totals:?}: {error}"));
        if limit == 0.0 {
            continue;
        }
        assert_totals_satisfied(totals, [&x, &y], found.multiplier);

        let (mut ux, mut uy) = (vec![0.0; cells], vec![0.0; cells]);
        matrix.apply([&x, &y], [&mut ux, &mut uy], &mut Scratch::none());
        let scale = scale(totals, [&ux, &uy], [&x, &y]);
        for i in 0..cells {
            let size = x[i].hypot(y[i]);
            assert!(size <= radii[i] * (1.0 + 1e-14), "{seed}");
            let g = [
                ux[i] + bx[i] - found.multiplier[0],
                uy[i] + by[i] - found.multiplier[1],
            ];
            // Inside the disc the gradient vanishes. On the boundary of the disc the gradient is opposite to the
            // vector.
            let (along, across) = if size > 0.0 {
                let (along, across) = (g[0] * x[i] + g[1] * y[i], g[0] * y[i] - g[1] * x[i]);
                (along / size, across / size)
            } else {
                (g[0].hypot(g[1]), 0.0)
            };
            if radii[i] > 0.0 {
                let is_at_limit = size > radii[i] * (1.0 - 1e-9);
                let wrong = if is_at_limit {
                    along.max(0.0)
                } else {
                    along.abs()
                };
                assert!(wrong.max(across.abs()) < 1e-9 * scale, "{seed} {totals:?}");
            }
        }
    }
}

#[test]
fn one_unknown_per_cell_satisfies_minimum_conditions() {
    let settings = Settings::default().tolerance(1e-10);
    for seed in 100..220 {
        let mut random = Random(seed);
        let cells = random.integer(1, 20);
        let mut matrix = DenseMatrix::random(cells, 1, &mut random);
        if seed >= 160 {
            matrix = matrix.with_antisymmetric_part(&mut random);
        }
        let linear: Vec<f64> = (0..cells).map(|_| random.uniform(-3.0, 3.0)).collect();
        let centre = random.uniform(-1.0, 1.0);
        let totals = [match random.integer(0, 2) {
            0 => Total::Free,
            1 => Total::Sum(cells as f64 * (centre + random.uniform(-0.3, 0.3))),
            _ => Total::Spring {
                far_end: random.uniform(-2.0, 2.0),
                compliance: 10_f64.powf(random.uniform(-3.0, 3.0)),
            },
        }];
        let problem = Problem::new(&matrix, [&linear], Intervals(centre)).totals(totals);
        let mut x = vec![0.0; cells];
        let found = cgm::minimise(&problem, &settings, [&mut x])
            .unwrap_or_else(|error| panic!("{seed} {totals:?}: {error}"));
        assert_totals_satisfied(totals, [&x], found.multiplier);

        let mut u = vec![0.0; cells];
        matrix.apply([&x], [&mut u], &mut Scratch::none());
        let scale = scale(totals, [&u], [&x]);
        for i in 0..cells {
            let g = u[i] + linear[i] - found.multiplier[0];
            let wrong = if x[i] <= centre - 0.5 {
                (-g).max(0.0)
            } else if x[i] >= centre + 0.5 {
                g.max(0.0)
            } else {
                g.abs()
            };
            assert!(wrong < 1e-9 * scale, "{seed} {totals:?}: {wrong:e}");
        }
    }
}

/// An infinite bound on the eigenvalues would certify any iterate. It counts as no bound.
#[test]
fn infinite_lower_bound_certifies_nothing() {
    let mut random = Random(7);
    let mut matrix = DenseMatrix::random(6, 2, &mut random);
    let solved = |matrix: &DenseMatrix| {
        let problem = Problem::new(matrix, [&[-1.0; 6], &[0.5; 6]], Discs(vec![0.1; 6]));
        let (mut x, mut y) = ([0.0; 6], [0.0; 6]);
        let settings = Settings::default();
        let found = cgm::minimise(&problem, &settings, [&mut x, &mut y]).unwrap();
        assert!(found.report.iterations > 0);
        [x, y]
    };
    let expected = solved(&matrix);
    matrix.lower_bound = f64::INFINITY;
    assert_eq!(solved(&matrix), expected);
}

/// The difference from the solution, in the norm of the symmetric part, is within the certificate.
#[test]
fn certificate_of_asymmetric_operator_bounds_error() {
    for seed in 300..kit::thorough(325, 360) {
        let mut random = Random(seed);
        let cells = random.integer(2, 20);
        let mut matrix =
            DenseMatrix::random(cells, 2, &mut random).with_antisymmetric_part(&mut random);
        matrix.lower_bound = 0.1 * (2 * cells) as f64;
        let mut field = || -> Vec<f64> { (0..cells).map(|_| random.uniform(-3.0, 3.0)).collect() };
        let (bx, by) = (field(), field());
        let problem = Problem::new(&matrix, [&bx, &by], Discs(vec![0.1; cells]));
        let solved = |tolerance: f64| {
            let (mut x, mut y) = (vec![0.0; cells], vec![0.0; cells]);
            let settings = Settings::default().tolerance(tolerance);
            let found = cgm::minimise(&problem, &settings, [&mut x, &mut y]).unwrap();
            (found.report.duality_gap, [x, y])
        };
        let (_, exact) = solved(1e-13);
        let (gap, rough) = solved(0.3);
        let product = |v: &[Vec<f64>; 2]| {
            let (mut ux, mut uy) = (vec![0.0; cells], vec![0.0; cells]);
            matrix.apply([&v[0], &v[1]], [&mut ux, &mut uy], &mut Scratch::none());
            let along = |v: &[f64], u: &[f64]| v.iter().zip(u).map(|(v, u)| v * u).sum::<f64>();
            along(&v[0], &ux) + along(&v[1], &uy)
        };
        let less = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a - b).collect();
        let error = [less(&rough[0], &exact[0]), less(&rough[1], &exact[1])];
        let (square, energy) = (product(&error), product(&rough));
        assert!(
            square <= gap * energy + 1e-24 * energy,
            "{seed}: {square:e} for {gap:e}"
        );
    }
}

#[test]
fn workspace_of_wrong_size_is_rejected() {
    let mut random = Random(7);
    let [small, large] = [3, 5].map(|cells| DenseMatrix::random(cells, 2, &mut random));
    let linear = [1.0; 5];
    let of = |matrix, cells| {
        let linear: &[f64] = &linear[..cells];
        Problem::new(matrix, [linear, linear], Discs(vec![0.1; cells]))
    };
    let mut workspace = of(&small, 3).workspace().unwrap();
    let (mut x, mut y) = ([0.0; 5], [0.0; 5]);
    let refused = cgm::minimise_with(
        &of(&large, 5),
        &Settings::default(),
        [&mut x, &mut y],
        &mut workspace,
        &mut |_| std::ops::ControlFlow::Continue(()),
    );
    assert!(matches!(refused, Err(Error::Length { .. })));
    assert_eq!((x, y), ([0.0; 5], [0.0; 5]));
}

/// Covers bounds on both sides and a total at loose tolerances. If the linear solve moves cells far beyond their
/// bounds, projecting them back pushes other cells off their bounds.
#[test]
fn loose_tolerances_are_met() {
    let mut random = Random(11);
    for trial in 0..kit::thorough(500, 4000) {
        let mut matrix = DenseMatrix::random(9, 1, &mut random);
        let (weight, ridge) = (
            10_f64.powf(random.uniform(-3.0, 0.0)),
            10_f64.powf(random.uniform(-4.0, 0.0)),
        );
        for (i, row) in matrix.rows.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                let diagonal = if i == j { 0.9 } else { 0.0 };
                *entry = weight * (*entry - diagonal) + if i == j { ridge } else { 0.0 };
            }
        }
        let linear: Vec<f64> = (0..9).map(|_| random.uniform(-1.0, 1.0)).collect();
        let lower: Vec<f64> = (0..9).map(|_| random.uniform(-0.5, 0.5)).collect();
        let upper: Vec<f64> = lower
            .iter()
            .map(|low| low + random.uniform(0.0, 1.0))
            .collect();
        let part = random.uniform(0.0, 1.0);
        let between = |low: &f64, high: &f64| low + part * (high - low);
        let total = lower
            .iter()
            .zip(&upper)
            .map(|(low, high)| between(low, high))
            .sum();
        let bounds = Bounds {
            lower: &lower,
            upper: &upper,
        };
        let mut x = lower.clone();
        let problem = Problem::new(matrix, [&linear], bounds).total(total);
        for tolerance in [0.3, 4e-2, 1e-2] {
            let settings = Settings::default().tolerance(tolerance);
            let found = cgm::minimise(&problem, &settings, [&mut x]);
            assert!(found.is_ok(), "{trial} to {tolerance}: {found:?}");
        }
    }
}

/// An operator whose product becomes NaN or infinite during a solve.
struct FailingOperator {
    matrix: DenseMatrix,
    products_left: std::sync::atomic::AtomicUsize,
    value: f64,
}

impl Operator for FailingOperator {
    fn cells(&self) -> usize {
        self.matrix.cells
    }

    fn apply(&self, x: [&[f64]; 1], [out]: [&mut [f64]; 1], _: &mut Scratch) {
        use std::sync::atomic::Ordering::Relaxed;
        self.matrix.apply(x, [&mut *out], &mut Scratch::none());
        let left = self.products_left.load(Relaxed);
        self.products_left.store(left.saturating_sub(1), Relaxed);
        if left == 0 {
            out[4] = self.value;
        }
    }
}

/// If a product becomes NaN or infinite during a solve, the status reports a stall. The iterate is feasible and
/// finite.
#[test]
fn failing_operator_leaves_a_feasible_iterate() {
    let mut random = Random(3);
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for method in [cgm::Method::ActiveSet, cgm::Method::PolonskyKeer] {
            for products_left in 0..6 {
                let operator = FailingOperator {
                    matrix: DenseMatrix::random(9, 1, &mut random),
                    products_left: products_left.into(),
                    value,
                };
                let linear: Vec<f64> = (0..9).map(|_| random.uniform(-1.0, 1.0)).collect();
                let mut x = vec![2.0 / 9.0; 9];
                let problem = Problem::new(operator, [&linear], NonNegative).total(2.0);
                let settings = Settings::default().method(method).tolerance(1e-12);
                let found = cgm::minimise(&problem, &settings, [&mut x]);
                let Err(Error::NotConverged(report)) = found else {
                    panic!("{value} after {products_left}: {found:?}");
                };
                assert_ne!(report.status, stickslip::Status::Converged);
                assert!(x.iter().all(|x| *x >= 0.0 && x.is_finite()));
                assert!((x.iter().sum::<f64>() - 2.0).abs() < 1e-12);
            }
        }
    }
}

/// A diagonal matrix.
struct DiagonalOperator(Vec<f64>);

impl Operator for DiagonalOperator {
    fn cells(&self) -> usize {
        self.0.len()
    }

    fn apply(&self, [x]: [&[f64]; 1], [u]: [&mut [f64]; 1], _: &mut Scratch) {
        for ((u, x), entry) in u.iter_mut().zip(x).zip(&self.0) {
            *u = entry * x;
        }
    }
}

/// With a singular preconditioner the solve either reaches the minimum or returns an error about the preconditioner.
/// The iterate is feasible in both cases.
#[test]
fn singular_preconditioner_is_named_or_minimum_found() {
    let linear: Vec<f64> = (0..40).map(|i| f64::from(i * 7 % 11) - 6.0).collect();
    let totals = [
        Total::Free,
        Total::Sum(3.0),
        Total::Spring {
            far_end: 2.0,
            compliance: 0.5,
        },
    ];
    let one_entry = |entry: f64| (0..40).map(|i| if i == 5 { entry } else { 1.0 }).collect();
    let (mut named, mut solved) = (0, 0);
    // Each case gives the entries of the preconditioner and the range of the matrix entries in decades.
    for (entries, decades) in [
        (vec![0.0; 40], 0.3),
        (vec![0.0; 40], 9.0),
        (vec![-1.0; 40], 9.0),
        (vec![f64::NAN; 40], 0.3),
        (vec![f64::NAN; 40], 9.0),
        (vec![f64::INFINITY; 40], 9.0),
        (one_entry(0.0), 0.3),
        (one_entry(f64::NAN), 9.0),
    ] {
        let entry = |i: i32| 10_f64.powf(decades * f64::from(i) / 40.0);
        let matrix: Vec<f64> = (0..40).map(entry).collect();
        for total in totals {
            let problem = Problem::new(DiagonalOperator(matrix.clone()), [&linear], NonNegative);
            let problem = problem
                .totals([total])
                .preconditioner(DiagonalOperator(entries.clone()));
            let mut x = vec![3.0 / 40.0; 40];
            let settings = Settings::default().max_iterations(500);
            let found = cgm::minimise(&problem, &settings, [&mut x]);
            assert!(
                x.iter().all(|x| *x >= 0.0 && x.is_finite()),
                "{entries:?} {total:?}"
            );
            match found {
                Ok(minimum) => {
                    let [multiplier] = minimum.multiplier;
                    for ((x, b), c) in x.iter().zip(&linear).zip(&matrix) {
                        let gradient = c * x + b - multiplier;
                        let forbidden = if *x > 0.0 { gradient.abs() } else { -gradient };
                        assert!(forbidden < 1e-5, "{entries:?} {total:?}: {forbidden:e}");
                    }
                    solved += 1;
                }
                Err(Error::NotPositive { quantity, value }) => {
                    assert!(quantity.contains("preconditioner"));
                    assert!(value <= 0.0 || !value.is_finite());
                    named += 1;
                }
                Err(error) => panic!("{entries:?} {total:?} {decades}: {error}"),
            }
        }
    }
    assert!(named > 0 && solved > 0, "{named} named, {solved} solved");
}
