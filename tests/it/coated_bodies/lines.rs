//! Coated bodies on grids that are periodic along y. A different datum changes displacements by a constant and has no
//! other effect.

use kit::{Random, max_abs, max_difference, press, thorough};
use stickslip::cgm::{Method, NonNegative};
use stickslip::dense::DenseOperator;
use stickslip::influence::Component;
use stickslip::layers::Layer;
use stickslip::{
    Boundary, CellValue, CoupledProblem, EigenvalueBound, ElasticPair, Error, Field, Grid,
    HalfSpace, Material, NormalLoad, NormalProblem, Operator, Scratch, TangentialControl,
    TangentialLoad, TangentialModel, TangentialProblem, surface,
};

use super::against_rigid;

/// A coated half-space on a grid that is periodic along y. The moduli are Young's moduli.
#[derive(Clone, Copy, Debug)]
struct CoatedStrip {
    grid: Grid,
    layer: Layer,
    substrate: f64,
    cell_value: CellValue,
}

impl CoatedStrip {
    /// Creates a line of 16 cells with a total length of one.
    fn line(modulus: f64, thickness: f64) -> Self {
        Self {
            grid: Grid::line(16, 1.0 / 16.0).unwrap(),
            layer: Layer::new(modulus, 0.3, thickness).unwrap(),
            substrate: 1.0,
            cell_value: CellValue::Uniform,
        }
    }

    fn random(random: &mut Random) -> Self {
        let nx = random.integer(3, thorough(16, 28));
        // Grids with several rows take most of the time.
        let ny = random.pick(thorough(&[1], &[1, 1, 2, 3, 5]));
        let length = random.decade(-0.5, 1.5);
        let sides = [
            length / nx as f64,
            length * random.decade(-1.5, 0.0) / ny as f64,
        ];
        let layer = Layer::new(
            random.decade(-1.0, 3.0),
            random.uniform(0.0, 0.5),
            random.decade(-1.7, 0.5),
        );
        Self {
            grid: Grid::new(nx, ny, sides[0], sides[1]).unwrap(),
            layer: layer.unwrap(),
            substrate: 1.0,
            cell_value: random.pick(&[CellValue::Uniform, CellValue::Centre]),
        }
    }

    fn length(&self) -> f64 {
        self.grid.dx() * self.grid.nx() as f64
    }

    fn pair(&self) -> ElasticPair {
        let base = Material::new(self.substrate, 0.3).unwrap();
        against_rigid(base.coated(&[self.layer]).unwrap())
    }

    fn bodies(&self, datum: f64) -> HalfSpace {
        let boundary = Boundary::PeriodicAlongY { datum };
        let bodies = HalfSpace::with_boundary(self.grid, self.pair(), boundary).unwrap();
        bodies.with_cell_value(self.cell_value).unwrap()
    }

    /// Returns the derivative of the displacement with respect to the logarithm of the datum, for a force on one
    /// period.
    fn drift(&self, force: f64) -> f64 {
        let period = self.grid.dy() * self.grid.ny() as f64;
        2.0 * (1.0 - 0.3 * 0.3) / self.substrate / std::f64::consts::PI * force / period
    }
}

/// Computes `x' C y` for a matrix C.
fn bilinear_form(matrix: &DenseOperator, x: &[f64], y: &[f64]) -> f64 {
    let mut image = vec![0.0; y.len()];
    matrix.apply([y], [&mut image], &mut Scratch::none());
    x.iter().zip(&image).map(|(x, u)| x * u).sum()
}

/// Adds a number to every entry of the matrix.
fn with_added_constant(matrix: &DenseOperator, by: f64) -> DenseOperator {
    let cells = matrix.cells();
    let entry = |n: usize| matrix.get(n / cells, n % cells).unwrap() + by;
    DenseOperator::from_rows(cells, (0..cells * cells).map(entry).collect()).unwrap()
}

/// Returns the matrix of the normal compliance.
fn dense_matrix(bodies: &HalfSpace) -> DenseOperator {
    DenseOperator::of_half_space(bodies, Component::ZZ).unwrap()
}

fn assert_independent_of_datum(strip: &CoatedStrip, method: Method, gap: &Field, force: f64) {
    let datums = [1.0, 1.5, 10.0, 1e4];
    let found = datums.map(|datum| {
        let bodies = strip.bodies(datum);
        let normal = kit::press_by(&bodies, gap, NormalLoad::Force(force), 1e-9, method);
        let displacement = normal.displacement(&bodies).unwrap();
        (normal, displacement)
    });
    let (last, far) = &found[3];
    let (peak, moved) = (last.pressure().max(), max_abs(far.as_slice()));
    for ((one, displacement), datum) in found.iter().zip(datums) {
        let error = max_difference(one.pressure().as_slice(), last.pressure().as_slice());
        assert!(error < 1e-7 * peak, "{strip:?} {datum}: {:e}", error / peak);
        let by = strip.drift(force) * (datums[3] / datum).ln();
        let error = (last.approach() - one.approach() - by).abs();
        assert!(error < 1e-7 * moved, "{strip:?} {datum}: {error:e}");
        for (far, near) in far.as_slice().iter().zip(displacement.as_slice()) {
            assert!((far - near - by).abs() < 1e-7 * moved, "{strip:?} {datum}");
        }
    }
}

/// A force determines the pressure for any datum, and the displacements up to a constant.
#[test]
fn line_force_gives_the_same_pressure_for_any_datum() {
    for (modulus, thickness) in [(10.0, 1.0), (100.0, 0.05), (100.0, 1.0), (1e3, 0.01)] {
        let strip = CoatedStrip::line(modulus, thickness);
        let flat = Field::zeros(strip.grid);
        for gap in [surface::cylinder(strip.grid, 0.3).unwrap(), flat] {
            for method in [Method::ActiveSet, Method::PolonskyKeer] {
                assert_independent_of_datum(&strip, method, &gap, 0.05);
            }
        }
    }
}

/// A prescribed approach is rejected only if the compliance is indefinite.
#[test]
fn line_approach_requires_a_definite_compliance() {
    let mut random = Random(5);
    let (mut refused, mut solved) = (0, 0);
    for _ in 0..thorough(3, 600) {
        let strip = CoatedStrip::random(&mut random);
        let datum = strip.length() * random.decade(0.0, 0.7);
        let bodies = strip.bodies(datum);
        let gap = surface::cylinder(strip.grid, strip.length()).unwrap();
        let approach = NormalLoad::Approach(0.1 * gap.max());
        let solve = |bodies: &HalfSpace| {
            let problem = NormalProblem::builder(bodies, &gap, approach);
            problem.build().unwrap().solve()
        };
        let matrix = dense_matrix(&bodies);
        match solve(&bodies) {
            Ok(found) => {
                solved += 1;
                assert!(matrix.lower_bound() > 0.0, "{strip:?} {datum}");
                let exact: Vec<f64> = gap.as_slice().iter().map(|g| g - 0.1 * gap.max()).collect();
                let exact = matrix.minimise(&exact, &NonNegative, None).unwrap().x;
                let error = max_difference(found.pressure().as_slice(), &exact);
                assert!(
                    error <= 1e-4 * max_abs(&exact),
                    "{strip:?} {datum} {error:e}"
                );
            }
            Err(error @ Error::DatumTooNear { least, .. }) => {
                refused += 1;
                assert!(matrix.lower_bound() == 0.0, "{strip:?} {datum}: {error}");
                let message = error.to_string();
                assert!(message.contains(&format!("{datum:?}")) && message.contains("force"));
                assert!(
                    solve(&strip.bodies(1.001 * least)).is_ok(),
                    "{strip:?} {least}"
                );
                let nearer = 0.999 * least;
                if nearer > datum {
                    assert!(solve(&strip.bodies(nearer)).is_err(), "{strip:?} {least}");
                }
            }
            Err(Error::NotDefinite { .. }) => {}
            Err(error) => panic!("{strip:?} {datum}: {error}"),
        }
    }
    assert!(
        refused > 0 && solved > 0,
        "{refused} refused, {solved} solved"
    );
}

/// The error bound is never below the true error, and no force is rejected because of the datum.
#[test]
fn line_certificate_is_valid_for_any_datum() {
    let mut random = Random(6);
    let (mut estimates, mut refused) = (0, 0);
    let count = thorough(3, 400);
    for case in 0..count {
        let strip = match case {
            0 => CoatedStrip::line(100.0, 0.05),
            _ => CoatedStrip::random(&mut random),
        };
        let datums = [1.0, 2.0, 1e3].map(|ratio| ratio * strip.length());
        let height = 0.1 * strip.length();
        let gap = Field::from_fn(strip.grid, |_, _| random.uniform(0.0, height));
        let force = random.decade(-3.0, 0.0) * strip.grid.area();
        let mut lower = Vec::new();
        for datum in datums {
            let bodies = strip.bodies(datum);
            let problem = |tolerance| {
                let load = NormalLoad::Force(force);
                let problem = NormalProblem::builder(&bodies, &gap, load).tolerance(tolerance);
                problem.build().unwrap().solve()
            };
            let matrix = dense_matrix(&bodies);
            let large = 1e3
                * (0..matrix.cells())
                    .fold(0.0, |a, i| f64::max(a, matrix.get(0, i).unwrap().abs()));
            let definite = with_added_constant(&matrix, large);
            let own = bodies.operator(Component::ZZ).unwrap().lower_bound();
            assert!(
                own <= matrix.lower_bound() * (1.0 + 1e-9),
                "{strip:?} {datum}"
            );
            lower.push(own);
            if let Err(Error::NotDefinite { .. }) = problem(1e-2) {
                refused += 1;
                continue;
            }
            let total = Some(force / strip.grid.cell_area());
            let exact = definite
                .minimise(gap.as_slice(), &NonNegative, total)
                .unwrap();
            for tolerance in [0.3, 1e-2, 1e-5] {
                let found = problem(tolerance).unwrap();
                let pressure = found.pressure().as_slice();
                let difference: Vec<f64> =
                    pressure.iter().zip(&exact.x).map(|(a, b)| a - b).collect();
                let error = bilinear_form(&definite, &difference, &difference);
                // The mean of a difference consists of round-off, which the added constant would amplify.
                let error = error - large * difference.iter().sum::<f64>().powi(2);
                let squares: f64 = pressure.iter().map(|p| p * p).sum();
                let energy = bilinear_form(&matrix, pressure, pressure);
                let report = found.report();
                let unit = energy.max(definite.lower_bound() * squares);
                let bound = report.duality_gap * unit;
                assert!(
                    error <= bound * (1.0 + 1e-6) + 1e-11 * unit.abs(),
                    "{strip:?} {datum} {error:e} {bound:e}"
                );
                if report.eigenvalue_bound == EigenvalueBound::Estimated {
                    estimates += 1;
                }
            }
        }
    }
    assert!(estimates > 0);
    assert!(refused <= 1 + 3 * count / 20, "{refused} refused");
}

/// Covers forces, shifts and springs along both axes. For every datum that determines the traction, the traction is the
/// same.
#[test]
fn line_traction_is_independent_of_the_datum() {
    let strip = CoatedStrip {
        grid: Grid::new(12, thorough(1, 3), 0.1, 0.3).unwrap(),
        layer: Layer::new(10.0, 0.3, 1.0).unwrap(),
        substrate: 1.0,
        cell_value: CellValue::Uniform,
    };
    let gap = surface::cylinder(strip.grid, 3.0).unwrap();
    let friction = kit::coulomb(0.3);
    let datums = [1.2, 3.0, 1e3];
    let pressed = datums.map(|datum| {
        let bodies = strip.bodies(datum);
        let normal = press(&bodies, &gap, NormalLoad::Force(0.05), 1e-10);
        (bodies, normal)
    });
    for (method, force, model) in [
        (Method::ActiveSet, [0.01, 0.004], TangentialModel::Vector),
        (Method::ActiveSet, [0.0, 0.008], TangentialModel::Scalar),
        (Method::PolonskyKeer, [0.01, 0.0], TangentialModel::Scalar),
    ] {
        let found = pressed.each_ref().map(|(bodies, normal)| {
            let load = TangentialLoad::force(force);
            let problem = TangentialProblem::builder(bodies, normal, friction.clone(), load);
            let problem = problem.model(model).method(method).tolerance(1e-9);
            kit::solve(problem)
        });
        let (last, normal_peak) = (found[2].traction(), pressed[2].1.pressure().max());
        for one in &found[..2] {
            for axis in [0, 1] {
                let [a, b] = [one.traction(), last].map(|of| of[axis].as_slice());
                assert!(max_difference(a, b) < 1e-7 * normal_peak);
            }
        }
    }
    // A prescribed motion is rejected if the compliance is indefinite, and solved otherwise. With a distant datum it is
    // equivalent to a force.
    for load in [
        TangentialLoad::shift([0.02, 0.0]),
        TangentialLoad::force([0.0; 2]).along(
            stickslip::Axis::X,
            TangentialControl::Spring {
                position: 0.1,
                stiffness: 0.1,
            },
        ),
    ] {
        for (bodies, normal) in &pressed {
            let problem = TangentialProblem::builder(bodies, normal, friction.clone(), load)
                .model(TangentialModel::Scalar);
            let matrix = DenseOperator::of_half_space(bodies, Component::XX).unwrap();
            match problem.build().unwrap().solve() {
                Ok(found) => assert!(found.report().is_converged()),
                Err(Error::DatumTooNear { .. }) => assert!(matrix.lower_bound() == 0.0),
                Err(error) => panic!("{error}"),
            }
            // Without friction, zero tractions are the only solution under any datum.
            let frictionless = kit::coulomb(0.0);
            let problem = TangentialProblem::builder(bodies, normal, frictionless, load)
                .model(TangentialModel::Scalar);
            let found = problem.build().unwrap().solve().unwrap();
            assert!(max_abs(found.traction()[0].as_slice()) == 0.0);
        }
    }
    let (press, friction) = (NormalLoad::Force(0.05), kit::coulomb(0.0));
    let load = TangentialLoad::shift([0.02, 0.0]);
    for (bodies, normal) in &pressed {
        let problem = CoupledProblem::builder(bodies, &gap, friction.clone(), press, load);
        let found = problem.tolerance(1e-10).build().unwrap().solve().unwrap();
        for axis in [0, 1] {
            assert!(max_abs(found.tangential().traction()[axis].as_slice()) == 0.0);
        }
        let [p, uncoupled] = [found.normal(), normal].map(|of| of.pressure().as_slice());
        assert!(max_difference(p, uncoupled) < 1e-7 * normal.pressure().max());
    }
}
