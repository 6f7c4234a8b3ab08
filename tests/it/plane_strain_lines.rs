//! A line of cells on a grid that is periodic along y is in plane strain. The kernels are the kernels of strips, and
//! the solutions agree with the closed forms of cylinders. Any number of equal rows has the same solution.

use kit::{max_difference, unit_pair};
use proptest::prelude::*;
use stickslip::analytical::{CattaneoMindlinLine, HertzLine, RoundedPunch, SpencePressing};
use stickslip::influence::Component;
use stickslip::{
    Axis, Boundary, CoupledProblem, ElasticPair, Error, Field, Grid, HalfSpace, History, LoadStep,
    Material, NormalLoad, NormalProblem, NormalSolution, Operator, TangentialControl,
    TangentialLoad, TangentialModel, TangentialProblem, surface,
};

const DATUM: f64 = 40.0;
const FRICTION: f64 = 0.5;

fn along_y(grid: Grid, pair: &ElasticPair) -> HalfSpace {
    let boundary = Boundary::PeriodicAlongY { datum: DATUM };
    HalfSpace::with_boundary(grid, *pair, boundary).unwrap()
}

/// Returns the coefficients from the first cell to each cell.
fn column(bodies: &HalfSpace, component: Component) -> Vec<f64> {
    let operator = bodies.operator(component).unwrap();
    let mut traction = vec![0.0; bodies.grid().cells()];
    let mut displacement = traction.clone();
    traction[0] = 1.0;
    let (t, u) = ([&traction[..]], [&mut displacement[..]]);
    operator.apply(t, u, &mut operator.scratch().unwrap());
    displacement
}

/// Integrates by eight-point Gauss-Legendre quadrature on many intervals.
fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    const RULE: [[f64; 2]; 4] = [
        [0.183_434_642_495_649_8, 0.362_683_783_378_362],
        [0.525_532_409_916_329, 0.313_706_645_877_887_27],
        [0.796_666_477_413_626_7, 0.222_381_034_453_374_48],
        [0.960_289_856_497_536_3, 0.101_228_536_290_376_26],
    ];
    let parts = 400;
    let half = 0.5 * (to - from) / f64::from(parts);
    (0..parts)
        .map(|part| {
            let middle = from + (2.0 * f64::from(part) + 1.0) * half;
            let pairs = RULE
                .iter()
                .map(|[node, weight]| weight * (f(middle - half * node) + f(middle + half * node)));
            half * pairs.sum::<f64>()
        })
        .sum()
}

/// Compares with Flamant's line loads along x and z and the antiplane line load, integrated over a cell.
#[test]
fn line_kernels_match_line_loads() {
    let nu = 0.2;
    let body = Material::from_shear_modulus(1.0, nu).unwrap();
    let pair = ElasticPair::new(body, Material::rigid()).unwrap();
    let grid = Grid::line(9, 0.5).unwrap();
    let bodies = along_y(grid, &pair);
    let unit = 1.0 / std::f64::consts::PI;
    for component in Component::ALL {
        let column = column(&bodies, component);
        for (cell, found) in column.iter().enumerate().skip(1) {
            let x = 0.5 * cell as f64;
            let logarithm =
                |factor: f64| integral(|s| -factor * unit * ((x - s) / DATUM).ln(), -0.25, 0.25);
            let step = 0.5 * 0.25 * (1.0 - 2.0 * nu);
            let expected = match component {
                Component::XX | Component::ZZ => logarithm(1.0 - nu),
                Component::YY => logarithm(1.0),
                Component::ZX => step,
                Component::XZ => -step,
                _ => 0.0,
            };
            assert!(
                (found - expected).abs() < 1e-13,
                "{component:?} {cell}: {found} is not {expected}"
            );
        }
    }
}

/// The kernel of a period equals the sum of two entries of the kernel of twice the period. The second kernel sums one more
/// period of images exactly.
#[test]
fn kernel_of_twice_the_period_adds_up_to_kernel_of_period() {
    let nu = 0.2;
    let body = Material::from_shear_modulus(1.0, nu).unwrap();
    let pair = ElasticPair::new(body, Material::rigid()).unwrap();
    for (nx, ny, dy) in [(40, 4, 0.5), (6, 7, 0.2), (40, 1, 1.0), (3, 2, 9.0)] {
        let [one, two] = [ny, 2 * ny].map(|ny| {
            let bodies = along_y(Grid::new(nx, ny, 0.5, dy).unwrap(), &pair);
            Component::ALL.map(|component| column(&bodies, component))
        });
        for (n, component) in Component::ALL.into_iter().enumerate() {
            let scale = one[8][0];
            for cell in 0..nx * ny {
                let sum = two[n][cell] + two[n][cell + nx * ny];
                let error = (sum - one[n][cell]).abs() / scale;
                assert!(error < 1e-13, "{component:?} {nx} {ny} {cell}: {error:e}");
            }
        }
    }
}

fn press(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    let problem = NormalProblem::builder(bodies, gap, NormalLoad::Force(force));
    kit::solve(problem.tolerance(1e-13))
}

fn shear(normal: &NormalSolution, bodies: &HalfSpace, force: f64) -> stickslip::TangentialSolution {
    let load = TangentialLoad::force([force, 0.0]);
    let problem = TangentialProblem::builder(bodies, normal, kit::coulomb(FRICTION), load);
    kit::solve(problem.tolerance(1e-13))
}

/// Starts from coarser cells keep the number of iterations on the finest grid independent of the number of cells.
#[test]
fn finer_lines_take_no_more_iterations() {
    let pair = unit_pair(0.3);
    for nx in [512, 2048, 8192] {
        let grid = Grid::new(nx, 1, 4.8 / nx as f64, 1.0).unwrap();
        let bodies = along_y(grid, &pair);
        let gap = surface::cylinder(grid, 20.0).unwrap();
        let normal = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(0.06));
        let normal = kit::solve(normal.tolerance(1e-6));
        let load = TangentialLoad::force([0.012, 0.0]);
        let sheared = TangentialProblem::builder(&bodies, &normal, kit::coulomb(FRICTION), load);
        let sheared = kit::solve(sheared.tolerance(1e-6));
        for report in [normal.report(), sheared.report()] {
            // Up to 14 iterations were measured.
            assert!(report.iterations <= 16, "{nx}: {report}");
        }
    }
}

/// Equal rows give the solution of a single line, and rough rows do not.
#[test]
fn equal_rows_match_single_line() {
    let pair = unit_pair(0.3);
    let answers = [1, 4, 64].map(|ny| {
        let grid = Grid::new(96, ny, 0.05, 1.0 / ny as f64).unwrap();
        let bodies = along_y(grid, &pair);
        let gap = surface::cylinder(grid, 20.0).unwrap();
        let gap = Field::from_fn(grid, |x, _| 0.002 * (9.0 * x).sin())
            .as_slice()
            .iter()
            .zip(gap.as_slice())
            .map(|(a, b)| a + b)
            .collect();
        let gap = Field::from_vec(grid, gap).unwrap();
        let normal = press(&bodies, &gap, 0.06);
        let sheared = shear(&normal, &bodies, 0.012);
        let energy = normal.elastic_energy(&bodies).unwrap();
        (normal, sheared, energy)
    });
    let (line, line_sheared, line_energy) = &answers[0];
    for (rows, sheared, energy) in &answers[1..] {
        for (row, of_line) in [
            (rows.pressure(), line.pressure()),
            (sheared.traction()[0], line_sheared.traction()[0]),
        ] {
            let scale = of_line.max();
            for row in row.as_slice().chunks_exact(96) {
                let error = max_difference(row, of_line.as_slice()) / scale;
                assert!(error < 1e-12, "{error:e}");
            }
        }
        assert!((rows.approach() / line.approach() - 1.0).abs() < 1e-12);
        assert!((sheared.shift()[0] / line_sheared.shift()[0] - 1.0).abs() < 1e-12);
        assert!((energy / line_energy - 1.0).abs() < 1e-12);
    }
}

/// Returns the errors of the cylinder on `n` cells: of the peak pressure, the pressure in the L1 norm, the approach, the
/// stick half-width, the traction and the shift.
fn errors(n: usize) -> [f64; 6] {
    let pair = kit::alike(210e3, 0.3);
    let hertz = HertzLine::new(&pair, 10.0, 100.0).unwrap();
    let exact = CattaneoMindlinLine::new(hertz, FRICTION, 0.6 * FRICTION * 100.0).unwrap();
    let grid = Grid::line(n, 2.6 * hertz.half_width() / n as f64).unwrap();
    let bodies = along_y(grid, &pair);
    let normal = press(&bodies, &surface::cylinder(grid, 10.0).unwrap(), 100.0);
    assert!(normal.warnings().is_empty());
    let sheared = shear(&normal, &bodies, exact.force());
    let l1 = |found: &Field, exact: &dyn Fn(f64) -> f64, force: f64| {
        let cells = found.as_slice().iter().enumerate();
        let sum: f64 = cells.map(|(i, q)| (q - exact(grid.x(i))).abs()).sum();
        sum * grid.dx() / force
    };
    let relative = |found: f64, exact: f64| (found / exact - 1.0).abs();
    [
        relative(normal.pressure().max(), hertz.max_pressure()),
        l1(normal.pressure(), &|x| hertz.pressure(x), 100.0),
        relative(normal.approach(), hertz.approach(DATUM)),
        (0.5 * sheared.stick_area() - exact.stick_half_width()).abs() / grid.dx(),
        l1(sheared.traction()[0], &|x| exact.traction(x), exact.force()),
        relative(sheared.shift()[0], exact.shift(DATUM)),
    ]
}

/// Peak pressure, approach and shift converge with second order in the cell size. Tractions converge with order 3/2 in the
/// L1 norm, as for the sphere. The width of the stick zone is correct to one cell.
#[test]
fn cylinders_match_hertz_and_cattaneo() {
    let laws = [
        (4e-4, 2.0),
        (4e-3, 1.5),
        (4e-5, 2.0),
        (1.0, 0.0),
        (8e-3, 1.5),
        (4e-5, 2.0),
    ];
    for n in [64, 128, 256, 512, 1024] {
        for (k, (error, (factor, order))) in errors(n).into_iter().zip(laws).enumerate() {
            let limit = factor * (64.0 / n as f64).powf(order);
            assert!(error < limit, "{n} {k}: {error:e}");
        }
    }
}

/// The area of the hysteresis loop of a cycle between two forces agrees with the closed form. It equals the dissipated
/// energy, and the energy balance closes.
#[test]
fn cycle_dissipates_area_of_its_loop() {
    let pair = unit_pair(0.3);
    let (radius, load) = (50.0, 0.02);
    let hertz = HertzLine::new(&pair, radius, load).unwrap();
    let force = 0.7 * FRICTION * load;
    let exact = CattaneoMindlinLine::new(hertz, FRICTION, force).unwrap();
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let grid = Grid::line(512, 2.4 * hertz.half_width() / 512.0).unwrap();
        let bodies = along_y(grid, &pair);
        let gap = surface::cylinder(grid, radius).unwrap();
        let builder = History::builder(&bodies, &gap, kit::coulomb(FRICTION));
        let mut history = builder.model(model).tolerance(1e-10).build().unwrap();
        history
            .step(&LoadStep::hold().normal(NormalLoad::Force(load)))
            .unwrap();
        let mut dissipated = [0.0; 4];
        for half in &mut dissipated {
            let sign = if history.tangential_force()[0] > 0.0 {
                -1.0
            } else {
                1.0
            };
            let control = TangentialControl::Force(sign * force);
            let step = history
                .step(&LoadStep::hold().tangential(Axis::X, control))
                .unwrap();
            let energy = step.energy();
            assert!(energy.imbalance().abs() < 1e-12 * energy.elastic_after);
            *half = energy.dissipated_energy;
        }
        let cycle = dissipated[2] + dissipated[3];
        let error = (cycle / exact.energy_per_cycle() - 1.0).abs();
        assert!(error < 3e-5, "{error:e}");
        assert!((dissipated[0] / (0.25 * cycle) - 1.0).abs() < 1e-4);
    }
}

/// A different datum changes approach and shift by a multiple of the force, and nothing else.
#[test]
fn datum_only_changes_approach_and_shift() {
    let pair = unit_pair(0.3);
    let grid = Grid::new(64, 4, 0.05, 0.3).unwrap();
    let gap = surface::cylinder(grid, 20.0).unwrap();
    let [near, far] = [10.0, 1e5].map(|datum| {
        let boundary = Boundary::PeriodicAlongY { datum };
        let bodies = HalfSpace::with_boundary(grid, pair, boundary).unwrap();
        let normal = press(&bodies, &gap, 0.06);
        let sheared = shear(&normal, &bodies, 0.012);
        (normal, sheared)
    });
    let scale = near.0.pressure().max();
    let error = max_difference(near.0.pressure().as_slice(), far.0.pressure().as_slice());
    assert!(error < 1e-10 * scale, "{:e}", error / scale);
    let moved = |force: f64| 2.0 * force / 1.2 / std::f64::consts::PI * 1e4_f64.ln();
    assert!((far.0.approach() - near.0.approach() - moved(0.06)).abs() < 1e-10);
    assert!((far.1.shift()[0] - near.1.shift()[0] - moved(0.012)).abs() < 1e-10);

    kit::assert_refused! {
        HalfSpace::with_boundary(grid, pair, Boundary::PeriodicAlongY { datum: 3.0 })
            => Error::BelowMinimum { value: 3.0, .. },
    }
    for datum in [f64::NAN, f64::INFINITY] {
        let refused = HalfSpace::with_boundary(grid, pair, Boundary::PeriodicAlongY { datum });
        assert!(matches!(refused, Err(Error::NotFinite { .. })));
    }
}

proptest! {
    /// If a load is moved along y by a number of rows, its displacement moves by the same number of rows.
    #[test]
    fn load_shifted_along_y_shifts_displacement(
        (nx, ny, rows, seed) in (4..20_usize, 1..12_usize, 0..12_usize, any::<u64>())
    ) {
        let grid = Grid::new(nx, ny, 0.5, 0.3).unwrap();
        let bodies = along_y(grid, &unit_pair(0.2));
        let mut random = kit::Random(seed);
        let traction: Vec<f64> = (0..nx * ny).map(|_| random.uniform(-1.0, 1.0)).collect();
        let turned = |field: &[f64]| {
            let mut field = field.to_vec();
            field.rotate_right(nx * (rows % ny));
            field
        };
        let operator = bodies.operator(Component::ZZ).unwrap();
        let product = |traction: &[f64]| {
            let mut u = vec![0.0; nx * ny];
            operator.apply([traction], [&mut u], &mut operator.scratch().unwrap());
            u
        };
        let (one, other) = (turned(&product(&traction)), product(&turned(&traction)));
        prop_assert!(max_difference(&one, &other) < 1e-13 * kit::max_abs(&one));
    }
}

/// Presses and holds a flat punch of half-width one on a line of cells, with bodies of the given Dundurs' beta. Returns the
/// stick half-width with the frictionless pressure and with full coupling.
fn punch(cells: usize, beta: f64, coefficient: f64) -> [f64; 2] {
    let poisson_ratio = (1.0 - 2.0 * beta) / (2.0 - 2.0 * beta);
    // The edges of cells coincide with the edges of the punch.
    let grid = Grid::line(cells + cells / 8, 2.0 / cells as f64).unwrap();
    let bodies = along_y(grid, &kit::on_rigid(1.0, poisson_ratio));
    let gap = Field::from_fn(grid, |x, _| if x.abs() < 1.0 { 0.0 } else { 1e3 });
    let (press, still) = (NormalLoad::Force(1.0), TangentialLoad::shift([0.0; 2]));
    let friction = || kit::coulomb(coefficient);
    let normal = press_tightly(&bodies, &gap, press);
    let one_way = TangentialProblem::builder(&bodies, &normal, friction(), still);
    let one_way = kit::solve(one_way);
    let coupled = CoupledProblem::builder(&bodies, &gap, friction(), press, still);
    let coupled = kit::solve(coupled.tolerance(1e-8));
    [one_way.stick_ratio(), coupled.tangential().stick_ratio()]
}

fn press_tightly(bodies: &HalfSpace, gap: &Field, press: NormalLoad) -> NormalSolution {
    let problem = NormalProblem::builder(bodies, gap, press);
    kit::solve(problem.tolerance(1e-10))
}

/// The reference for one-way coupling is Spence's solution. The reference for full coupling is the result of an
/// independent method of line elements, accurate to 3e-5 in the coefficient. The error is of first order in the cell
/// size, since half-widths are whole multiples of a cell.
#[test]
fn dissimilar_punches_stick_as_in_spence() {
    let cases = [
        (0.5, [(0.3, 0.36868), (0.5, 0.48552), (0.7, 0.64745)]),
        (2.0 / 7.0, [(0.3, 0.18449), (0.5, 0.23740), (0.7, 0.30445)]),
        (0.117, [(0.3, 0.07222), (0.5, 0.09235), (0.7, 0.11727)]),
    ];
    for (beta, values) in cases {
        for (part, coefficient) in values {
            for &cells in kit::thorough(&[64, 256][..], &[64, 256, 1024]) {
                let [one_way, coupled] = punch(cells, beta, coefficient);
                let poisson_ratio = (1.0 - 2.0 * beta) / (2.0 - 2.0 * beta);
                let goodman =
                    SpencePressing::plane(&kit::on_rigid(1.0, poisson_ratio), coefficient).unwrap();
                let cell = 2.0 / cells as f64;
                assert!((one_way - goodman.stick_radius()).abs() < 0.65 * cell);
                assert!(
                    (coupled - part).abs() < 0.65 * cell,
                    "{beta} {part}: {coupled}"
                );
            }
        }
    }
}

/// The errors are measured in the L1 norm.
#[test]
fn rounded_punches_match_ciavarella() {
    let pair = unit_pair(0.3);
    for (flat, load) in [(0.3, 0.05), (0.9, 0.05), (0.9, 0.4)] {
        let exact = RoundedPunch::new(&pair, flat, 20.0, load).unwrap();
        for n in [128, 256, 512, 1024] {
            let grid = Grid::line(n, 2.4 * exact.half_width() / n as f64).unwrap();
            let bodies = along_y(grid, &pair);
            let gap = Field::from_fn(grid, |x, _| (x.abs() - flat).max(0.0).powi(2) / 40.0);
            let found = press(&bodies, &gap, load);
            let half_width = 0.5 * found.contact_cells() as f64 * grid.dx();
            assert!((half_width - exact.half_width()).abs() < grid.dx());
            let cells = found.pressure().as_slice().iter().enumerate();
            let error: f64 = cells
                .map(|(i, p)| (p - exact.pressure(grid.x(i))).abs())
                .sum();
            let error = error * grid.dx() / load;
            let law = 1.5e-3 * (128.0 / n as f64).powf(1.5);
            assert!(error < law, "{flat} {load} {n}: {error:e}");
        }
    }
}
