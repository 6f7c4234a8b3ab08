//! Tests of the sphere of the paper: results of Table 2 on 512 x 512 cells, and the convergence of the error.
//!
//! Each error bound consists of an order and a constant. It limits the largest error over eight offsets of the sphere
//! within a cell. The argument of the bound is a/h, the ratio of contact radius to cell side.

use kit::{Random, Table2, l2_difference, max_abs};
use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::{
    Field, HalfSpace, NormalLoad, NormalProblem, NormalSolution, TangentialLoad, TangentialProblem,
    TangentialSolution,
};

fn hertz() -> HertzSphere {
    HertzSphere::new(&Table2::pair(), Table2::RADIUS, Table2::FORCE).unwrap()
}

fn exact(friction: f64, force: f64) -> CattaneoMindlin {
    CattaneoMindlin::new(hertz(), friction, force).unwrap()
}

/// Presses the sphere that touches at `centre` on `n` x `n` cells of a square of `width` contact radii.
fn press(n: usize, width: f64, centre: [f64; 2], tolerance: f64) -> (HalfSpace, NormalSolution) {
    let grid = kit::square(n, width * Table2::CONTACT_RADIUS);
    let bodies = HalfSpace::new(grid, Table2::pair()).unwrap();
    let ball = Field::from_fn(grid, |x, y| {
        ((x - centre[0]).powi(2) + (y - centre[1]).powi(2)) / (2.0 * Table2::RADIUS)
    });
    let load = NormalLoad::Force(Table2::FORCE);
    let problem = NormalProblem::builder(&bodies, &ball, load)
        .tolerance(tolerance)
        .build()
        .unwrap();
    let solution = problem.solve().unwrap();
    (bodies, solution)
}

fn shear(
    bodies: &HalfSpace,
    normal: &NormalSolution,
    friction: f64,
    force: f64,
    tolerance: f64,
) -> TangentialSolution {
    let load = TangentialLoad::force([force, 0.0]);
    kit::solve(
        TangentialProblem::builder(bodies, normal, kit::coulomb(friction), load)
            .tolerance(tolerance),
    )
}

fn relative(found: f64, expected: f64) -> f64 {
    (found / expected - 1.0).abs()
}

#[test]
fn sphere_on_512_cells_matches_table_2() {
    let (bodies, normal) = press(512, 3.0, [0.0; 2], 1e-6);
    let cells_per_radius = 512.0 / 3.0;
    // The expected values are the numbers of Table 2 of the paper, computed to 17 digits.
    assert!(relative(normal.pressure().max(), 2774530779.353719) < 1e-4);
    assert!(relative(normal.approach(), 4.916814175043048e-6) < 1e-5);
    assert!(relative(normal.force(), 100.0) < 1e-12);
    assert!(normal.warnings().is_empty());
    let area = std::f64::consts::PI * Table2::CONTACT_RADIUS.powi(2);
    assert!(relative(normal.contact_area(), area) < 0.45 / cells_per_radius);
    assert!(relative(normal.contact_area_corrected(), area) < 1e-3);
    assert!(normal.report().products() <= 40, "{}", normal.report());

    let main = shear(&bodies, &normal, Table2::FRICTION, 20.0, 1e-6);
    assert!(relative(main.shift()[0], 8.54456588081447e-7) < 1e-4);
    assert!(relative(main.force()[0], 20.0) < 1e-12);
    assert!((main.stick_ratio() - 0.7113786608980126).abs() < 0.5 / cells_per_radius + 1e-3);
    assert!(
        relative(
            main.dissipated_energy(),
            exact(0.5, 20.0).energy_of_first_quarter()
        ) < 1e-3
    );
    assert!(main.report().products() <= 40, "{}", main.report());

    // Figures 7 and 8f show the stick ratio and the shift under ten forces. The shifts are in micrometres.
    let shifts = [
        0.200809831448524,
        0.4092151420728142,
        0.6265151556832284,
        0.8544565880814471,
        1.0954930369758162,
        1.353282322692446,
        1.6337669577484002,
        1.9480075423772887,
        2.322660890973379,
        2.742346393547517,
    ];
    let forces = [5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 49.0];
    for (force, shift) in forces.into_iter().zip(shifts).step_by(kit::thorough(4, 1)) {
        let solution = shear(&bodies, &normal, Table2::FRICTION, force, 1e-6);
        let ratio = (1.0 - force / 50.0_f64).powf(2.0 / 3.0);
        assert!(
            (solution.stick_ratio() - ratio).abs() < 0.5 / cells_per_radius + 1e-3,
            "{force} N"
        );
        assert!(
            relative(solution.shift()[0], shift * 1e-6) < 1e-4,
            "{force} N"
        );
    }

    // Figure 9 shows profiles under forces below the limit, with the friction coefficient 0.2 that its caption states.
    let profiles = [
        (0.2, 2.3),
        (0.4, 0.55),
        (0.6, 0.55),
        (0.8, 0.55),
        (0.95, 0.23),
    ];
    for (f, bound) in profiles.into_iter().step_by(kit::thorough(4, 1)) {
        let force = f * 0.2 * Table2::FORCE;
        let solution = shear(&bodies, &normal, 0.2, force, 1e-6);
        let closed = exact(0.2, force);
        let expected = Field::from_fn(bodies.grid(), |x, y| closed.traction(x.hypot(y)));
        let error = l2_difference(solution.traction()[0].as_slice(), expected.as_slice());
        assert!(
            error < bound / cells_per_radius,
            "F/(mu W) = {f}: {error:e}"
        );
    }
}

/// An error of a quantity and its bound `error <= constant * (a/h)^-order`.
struct ErrorBound {
    name: &'static str,
    constant: f64,
    order: f64,
    error: f64,
}

fn error_bound(name: &'static str, constant: f64, order: f64, error: f64) -> ErrorBound {
    ErrorBound {
        name,
        constant,
        order,
        error,
    }
}

#[test]
fn errors_are_within_convergence_bounds() {
    let mut random = Random(5);
    let closed = hertz();
    for &n in kit::thorough(&[32, 64, 128][..], &[32, 64, 128, 256]) {
        for _ in 0..2 {
            let width = 2.6;
            let cell = width * closed.contact_radius() / n as f64;
            let centre = [0, 1].map(|_| random.uniform(-0.5, 0.5) * cell);
            let (bodies, normal) = press(n, width, centre, 1e-11);
            let mut bounds = normal_bounds(&normal, centre);
            for (f, constants) in [
                (0.1, [2.3, 0.25, 0.55]),
                (0.4, [0.55, 0.05, 0.55]),
                (0.9, [0.23, 0.01, 0.9]),
            ] {
                bounds.extend(tangential_bounds(&bodies, &normal, centre, f, constants));
            }
            let resolution = closed.contact_radius() / cell;
            for ErrorBound {
                name,
                constant,
                order,
                error,
            } in bounds
            {
                let bound = constant * resolution.powf(-order);
                assert!(
                    error <= bound,
                    "{name} at a/h = {resolution:.1}: {error:e} > {bound:e}"
                );
            }
        }
    }
}

fn distance(x: f64, y: f64, centre: [f64; 2]) -> f64 {
    (x - centre[0]).hypot(y - centre[1])
}

fn normal_bounds(normal: &NormalSolution, centre: [f64; 2]) -> Vec<ErrorBound> {
    let closed = hertz();
    let (a, p0) = (closed.contact_radius(), closed.max_pressure());
    let exact = Field::from_fn(normal.grid(), |x, y| {
        closed.pressure(distance(x, y, centre))
    });
    let is_inner = Field::from_fn(normal.grid(), |x, y| {
        f64::from(distance(x, y, centre) < 0.8 * a)
    });
    let samples = normal.pressure().as_slice().iter().zip(exact.as_slice());
    let errors: Vec<f64> = samples.map(|(found, exact)| (found - exact) / p0).collect();
    let inner: Vec<f64> = errors
        .iter()
        .zip(is_inner.as_slice())
        .map(|(e, i)| e * i)
        .collect();
    // The reference is the largest value at a cell centre, because the peak may lie between cells.
    let largest = relative(normal.pressure().max(), exact.max());
    let l2 = l2_difference(normal.pressure().as_slice(), exact.as_slice());
    let area = relative(normal.contact_area(), closed.contact_area());
    vec![
        error_bound("largest pressure", 0.10, 2.0, largest),
        error_bound("pressure within 0.8 a", 0.35, 2.0, max_abs(&inner)),
        error_bound("pressure, L2", 0.18, 1.0, l2),
        error_bound("pressure anywhere", 0.25, 0.5, max_abs(&errors)),
        error_bound(
            "approach",
            0.07,
            2.0,
            relative(normal.approach(), closed.approach()),
        ),
        error_bound("contact area", 0.45, 1.0, area),
    ]
}

fn tangential_bounds(
    bodies: &HalfSpace,
    normal: &NormalSolution,
    centre: [f64; 2],
    f: f64,
    [l2, shift, stick]: [f64; 3],
) -> [ErrorBound; 3] {
    let force = f * Table2::FRICTION * Table2::FORCE;
    let closed = exact(Table2::FRICTION, force);
    let solution = shear(bodies, normal, Table2::FRICTION, force, 1e-11);
    let traction = Field::from_fn(normal.grid(), |x, y| {
        closed.traction(distance(x, y, centre))
    });
    let found = solution.traction()[0].as_slice();
    let stick_area = closed.stick_ratio() * closed.hertz().contact_area();
    [
        error_bound(
            "traction, L2",
            l2,
            1.0,
            l2_difference(found, traction.as_slice()),
        ),
        error_bound(
            "shift",
            shift,
            1.5,
            relative(solution.shift()[0], closed.shift()),
        ),
        error_bound(
            "stick area",
            stick,
            1.0,
            relative(solution.stick_area(), stick_area),
        ),
    ]
}
