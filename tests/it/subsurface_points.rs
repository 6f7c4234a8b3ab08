//! Stresses and displacements at points below the surface of a half-space agree with other programs, closed forms and
//! equilibrium.

use proptest::prelude::*;
use stickslip::subsurface::{Body, Planes, PointResult, Stress, Tractions, at_points};
use stickslip::{
    Axis, Boundary, CoupledProblem, ElasticPair, Error, Field, Grid, HalfSpace, History, LoadStep,
    Material, NormalLoad, NormalProblem, TangentialControl, TangentialLoad, TangentialModel,
};

macro_rules! data {
    ($name:literal) => {
        include_str!(concat!("../data/subsurface/", $name))
    };
}

const ONE_RECTANGLE: &str = data!("one_rectangle.csv");
const HARD_POINTS: &str = data!("hard_points.csv");
const CASES: [[&str; 2]; 3] = [
    [
        data!("s01_hertz_ball.tractions.csv"),
        data!("s01_hertz_ball.points.csv"),
    ],
    [
        data!("s02_partial_slip_ball.tractions.csv"),
        data!("s02_partial_slip_ball.points.csv"),
    ],
    [
        data!("s03_sliding_ball.tractions.csv"),
        data!("s03_sliding_ball.points.csv"),
    ],
];

fn numbers(line: &str) -> Vec<f64> {
    line.trim_start_matches("# ")
        .split(',')
        .map(|text| text.parse().unwrap())
        .collect()
}

fn whole(number: f64) -> usize {
    (0..4096).find(|&n| n as f64 == number).unwrap()
}

/// Returns the rows of the table without the comments and the header.
fn rows(table: &str) -> impl Iterator<Item = Vec<f64>> {
    table
        .lines()
        .filter(|line| !line.starts_with('#'))
        .skip(1)
        .map(numbers)
}

fn on_rigid(grid: Grid, nu: f64) -> HalfSpace {
    let body = Material::from_shear_modulus(1.0, nu).unwrap();
    HalfSpace::new(grid, ElasticPair::new(body, Material::rigid()).unwrap()).unwrap()
}

fn components(response: &PointResult) -> [f64; 9] {
    let ([ux, uy, uz], s) = (response.displacement, response.stress);
    [ux, uy, uz, s.xx, s.yy, s.zz, s.xy, s.xz, s.yz]
}

/// Returns the largest error, relative to the largest displacement or the largest stress.
fn error(found: &[f64], expected: &[f64]) -> f64 {
    let mut worst: f64 = 0.0;
    for range in [0..3, 3..9] {
        let pairs = || found[range.clone()].iter().zip(&expected[range.clone()]);
        let scale = pairs().fold(f64::MIN_POSITIVE, |scale, (_, b)| scale.max(b.abs()));
        for (a, b) in pairs() {
            assert!(a.is_finite());
            worst = worst.max((a - b).abs() / scale);
        }
    }
    worst
}

/// The tolerance is 2e-14 of the largest component at every depth, plus 2e-16 times the aspect ratio for slender cells.
#[test]
fn single_rectangle_matches_multiprecision_values() {
    for (table, count) in [(ONE_RECTANGLE, 30), (HARD_POINTS, 35)] {
        assert_eq!(rows(table).count(), count);
        for row in rows(table) {
            let (&[a, b, nu, x, y, z], expected) = row.split_first_chunk::<6>().unwrap();
            assert_eq!(expected.len(), 27);
            let grid = Grid::new(1, 1, 2.0 * a, 2.0 * b).unwrap();
            let bodies = on_rigid(grid, nu);
            for (load, expected) in expected.chunks(9).enumerate() {
                let of = |k| Field::constant(grid, if k == load { 1.0 } else { 0.0 });
                let [p, qx, qy] = [0, 1, 2].map(of);
                let tractions = Tractions::new(&p).with_traction([&qx, &qy]);
                let found = at_points(&bodies, Body::One, tractions, &[[x, y, z]]).unwrap();
                let error = error(&components(&found[0]), expected);
                assert!(
                    error < 2e-14 + 2e-16 * (a / b).max(b / a),
                    "{error:e} {row:?}"
                );
            }
        }
    }
}

/// Returns the bodies, the pressure and the tractions of a case of the other code.
fn case(tractions: &str) -> (HalfSpace, [Field; 3]) {
    let header = numbers(tractions.lines().nth(1).unwrap());
    let [nx, ny, dx, dy, g1, nu1, g2, nu2] = header.try_into().unwrap();
    let grid = Grid::new(whole(nx), whole(ny), dx, dy).unwrap();
    let body = |g, nu| Material::from_shear_modulus(g, nu).unwrap();
    let pair = ElasticPair::new(body(g1, nu1), body(g2, nu2)).unwrap();
    let mut fields = [0, 1, 2].map(|_| Field::zeros(grid));
    for row in rows(tractions) {
        let cell = (whole(row[1]) - 1) * grid.nx() + whole(row[0]) - 1;
        for (field, value) in fields.iter_mut().zip(&row[2..]) {
            field.as_mut_slice()[cell] = *value;
        }
    }
    (HalfSpace::new(grid, pair).unwrap(), fields)
}

#[test]
fn point_stresses_match_reference_code() {
    for ([tractions, points], count) in CASES.into_iter().zip([48, 63, 48]) {
        let (bodies, [p, qx, qy]) = case(tractions);
        let tractions = Tractions::new(&p).with_traction([&qx, &qy]);
        let mut compared = 0;
        for (body, number) in [(Body::One, 1.0), (Body::Two, 2.0)] {
            let rows: Vec<_> = rows(points).filter(|row| row[3] == number).collect();
            let places: Vec<_> = rows
                .iter()
                .map(|row| [row[0], row[1], row[2].abs()])
                .collect();
            let found = at_points(&bodies, body, tractions, &places).unwrap();
            for (found, row) in found.iter().zip(&rows) {
                let error = error(&components(found), &row[4..]);
                assert!(error < 1e-12, "{error:e} {row:?}");
                compared += 1;
            }
        }
        assert_eq!(compared, count);
    }
}

/// Both bodies use the same axes: the surface stresses balance the tractions, and the displacements have opposite
/// signs.
#[test]
fn point_stresses_of_both_bodies_have_signs_of_common_axes() {
    let (bodies, [p, qx, qy]) = case(CASES[1][0]);
    let tractions = Tractions::new(&p).with_traction([&qx, &qy]);
    let surface = [[0.33, 0.21, 0.0], [-0.45, 0.27, 0.0]];
    for body in [Body::One, Body::Two] {
        for (found, [x, y, _]) in at_points(&bodies, body, tractions, &surface)
            .unwrap()
            .iter()
            .zip(surface)
        {
            let [column, row] = [x, y].map(|at: f64| (at / 0.06 + 19.5).round());
            let cell = whole(40.0 * row + column);
            let [p, qx, qy] = [&p, &qx, &qy].map(|field| field.as_slice()[cell]);
            let Stress { zz, xz, yz, .. } = found.stress;
            assert!((zz + p).abs() + (xz + qx).abs() + (yz + qy).abs() < 1e-13 * 4.0);
            let [ux, _, uz] = found.displacement;
            let side = if body == Body::One { 1.0 } else { -1.0 };
            assert!(side * uz > 0.0 && side * ux > 0.0);
        }
    }
}

/// An edge between cells of equal tractions has no effect, however its position is rounded.
#[test]
fn edges_between_equal_cells_have_no_effect() {
    let grid = Grid::new(7, 5, 0.1, 0.3).unwrap();
    let bodies = on_rigid(grid, 0.3);
    let (p, q) = (Field::constant(grid, 1.0), Field::constant(grid, 0.4));
    let whole = Grid::new(1, 1, 0.7, 1.5).unwrap();
    let one = on_rigid(whole, 0.3);
    let (p_of_one, q_of_one) = (Field::constant(whole, 1.0), Field::constant(whole, 0.4));
    for ix in 0..6 {
        for iy in 0..4 {
            let corner = [0.5 * (grid.x(ix) + grid.x(ix + 1)), grid.y(iy) + 0.15, 0.0];
            let points = [
                corner,
                [corner[0], grid.y(iy), 0.0],
                [grid.x(ix), corner[1], 0.0],
            ];
            let at = |bodies, p, q| {
                at_points(
                    bodies,
                    Body::One,
                    Tractions::new(p).with_traction([q, q]),
                    &points,
                )
                .unwrap()
            };
            let (many, one) = (at(&bodies, &p, &q), at(&one, &p_of_one, &q_of_one));
            for (many, one) in many.iter().zip(&one) {
                let error = error(&components(many), &components(one));
                assert!(error < 1e-13, "{ix} {iy} {error:e}");
            }
        }
    }
}

#[test]
fn invalid_points_and_bodies_are_rejected() {
    let grid = Grid::new(3, 2, 1.0, 1.0).unwrap();
    let bodies = on_rigid(grid, 0.3);
    let p = Field::constant(grid, 1.0);
    let at = |body, p: &Field, point| at_points(&bodies, body, Tractions::new(p), &[point; 1]);
    for bad in [
        [f64::NAN, 0.0, 1.0],
        [0.0, f64::INFINITY, 1.0],
        [0.0, 0.0, -1e-9],
    ] {
        let points = [[0.0; 3], bad];
        kit::assert_refused! {
            at_points(&bodies, Body::One, Tractions::new(&p), &points) => Error::Sample { index: 1, .. },
        }
    }
    kit::assert_refused! {
        at(Body::One, &p, [0.0, 0.0, f64::NAN]) => Error::Sample { .. },
        at(Body::Two, &p, [0.0; 3]) => Error::RigidBody("body 2"),
    }
    let other = Field::zeros(Grid::new(2, 2, 1.0, 1.0).unwrap());
    kit::assert_refused! { at(Body::One, &other, [0.0; 3]) => Error::GridMismatch { .. } }
    let broken = Field::constant(grid, f64::NAN);
    kit::assert_refused! { at(Body::One, &broken, [0.0; 3]) => Error::Sample { .. } }
    let repeats = HalfSpace::with_boundary(grid, *bodies.pair(), Boundary::Periodic).unwrap();
    let refused = at_points(&repeats, Body::One, Tractions::new(&p), &[[0.0; 3]]);
    assert!(matches!(refused, Err(Error::DivergentPeriodicSum(_))));
    assert!(
        at_points(&bodies, Body::One, Tractions::new(&p), &[])
            .unwrap()
            .is_empty()
    );
}

/// Depths that are negligible compared with the cell give the values of the surface. Far away the response decays, and
/// points are rejected where its squares and cubes would overflow.
#[test]
fn extreme_points_are_finite_or_rejected() {
    let pair = *on_rigid(kit::square(1, 1.0), 0.3).pair();
    let along_y = Boundary::PeriodicAlongY { datum: 10.0 };
    let square = Grid::new(4, 4, 1.0, 1.5).unwrap();
    for (grid, boundary) in [
        (square, Boundary::NonPeriodic),
        (square, along_y),
        (square, Boundary::Periodic),
        (Grid::line(4, 1.0).unwrap(), along_y),
    ] {
        let bodies = HalfSpace::with_boundary(grid, pair, boundary).unwrap();
        let p = Field::from_fn(grid, |x, y| 1.0 + 0.1 * x + 0.2 * y);
        let q = Field::constant(grid, 0.3);
        let tractions = || Tractions::new(&p).with_traction([&q, &q]);
        let at = |point| at_points(&bodies, Body::One, tractions(), &[point]).map(|found| found[0]);
        let plane = |depth| {
            let mut planes = Planes::new(&bodies, &[depth])?.with_displacements();
            planes.solve(0, Body::One, tractions())
        };
        let is_far = |error: &Error| {
            let rule = "must lie within 1e60 cells of the grid";
            matches!(error, Error::Sample { rule: found, .. } if found.ends_with(rule))
        };
        let places = [[0.0, 0.0], [2.0, 3.0], [7.0, 0.0], [0.5, 0.0], [1.0, 0.3]];
        let places = &places[..kit::thorough(3, 5)];
        for depth in [5e-324, 1e-310, 1e-200, 1e-162, 1e-151] {
            for &[x, y] in places {
                if boundary != Boundary::Periodic {
                    assert_eq!(at([x, y, depth]).unwrap(), at([x, y, 0.0]).unwrap());
                }
            }
            let (found, surface) = (plane(depth).unwrap(), plane(0.0).unwrap());
            assert!(found.stresses().eq(surface.stresses()));
            assert_eq!(found.displacement(), surface.displacement());
        }
        for exponent in (-149..=308).step_by(kit::thorough(91, 7)) {
            let far = 10_f64.powi(exponent);
            for &[x, y] in places {
                for point in [[x, y, far], [far, y, 0.0], [x, -far, 0.1], [far, far, far]] {
                    match at(point) {
                        Ok(found) => assert!(components(&found).iter().all(|c| c.is_finite())),
                        Err(Error::DivergentPeriodicSum(_)) => {
                            assert_eq!(boundary, Boundary::Periodic);
                        }
                        Err(error) => assert!(is_far(&error) && exponent >= 60, "{error}"),
                    }
                }
            }
            match plane(far) {
                Ok(plane) => {
                    assert!(plane.stresses().all(|s| s.von_mises().is_finite()));
                    let fields = plane.displacement().unwrap();
                    assert!(
                        fields
                            .iter()
                            .all(|u| u.as_slice().iter().all(|u| u.is_finite()))
                    );
                }
                Err(error) => assert!(is_far(&error) && exponent >= 60, "{error}"),
            }
        }
    }
}

/// Solutions of every type are accepted as a source of tractions. Solutions for different bodies are rejected.
#[test]
fn solutions_are_accepted_as_tractions() {
    let grid = kit::square(12, 2.4);
    let body = |e| Material::new(e, 0.3).unwrap();
    let pair = ElasticPair::new(body(1.0), body(2.0)).unwrap();
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let gap = kit::sphere(grid, 5.0);
    let (press, friction) = (NormalLoad::Force(0.1), kit::coulomb(0.4));
    let pull = TangentialLoad::force([0.02, 0.01]);
    let points = [[0.1, 0.2, 0.0], [-0.3, 0.1, 0.4], [2.0, 3.0, 1.0]];
    let at = |tractions: Tractions<'_>| at_points(&bodies, Body::Two, tractions, &points);

    let normal = kit::solve(NormalProblem::builder(&bodies, &gap, press));
    let pressed = Tractions::new(normal.pressure());
    assert_eq!(at(Tractions::from(&normal)), at(pressed));

    let problem = CoupledProblem::builder(&bodies, &gap, friction.clone(), press, pull);
    let coupled = kit::solve(problem);
    let (normal, shear) = (coupled.normal(), coupled.tangential());
    let expected = at(Tractions::new(normal.pressure()).with_traction(shear.traction()));
    assert_eq!(at(Tractions::from(&coupled)), expected);
    assert_eq!(at(Tractions::from((normal, shear))), expected);

    let builder = History::builder(&bodies, &gap, friction).model(TangentialModel::Vector);
    let mut history = builder.build().unwrap();
    let step = LoadStep::hold()
        .normal(press)
        .tangential(Axis::X, TangentialControl::Force(0.02));
    history.step(&step).unwrap();
    let expected = at(Tractions::new(history.pressure()).with_traction(history.traction()));
    assert_eq!(at(Tractions::from(&history)), expected);
    assert_eq!(at(Tractions::from(history.state())), expected);

    let others = HalfSpace::new(grid, ElasticPair::new(body(1.0), body(1.0)).unwrap()).unwrap();
    kit::assert_refused! { at_points(&others, Body::One, normal, &points) => Error::MaterialMismatch { .. } }
    let others = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
    kit::assert_refused! { at_points(&others, Body::One, normal, &points) => Error::BoundaryMismatch { .. } }
}

fn stress() -> impl Strategy<Value = Stress> {
    proptest::array::uniform6(-1.0..1.0_f64).prop_map(|[xx, yy, zz, xy, xz, yz]| Stress {
        xx,
        yy,
        zz,
        xy,
        xz,
        yz,
    })
}

fn matrix(s: &Stress) -> [[f64; 3]; 3] {
    [[s.xx, s.xy, s.xz], [s.xy, s.yy, s.yz], [s.xz, s.yz, s.zz]]
}

fn product(matrix: &[[f64; 3]; 3], v: &[f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

proptest! {
    /// Principal directions are orthonormal eigenvectors and form a right-handed set. Principal values are in
    /// descending order.
    #[test]
    fn principal_stresses_are_eigenvalues(stress in stress()) {
        let principal = stress.principal();
        let [a, b, c] = principal.values;
        prop_assert!(a >= b && b >= c);
        for (value, direction) in principal.values.iter().zip(&principal.directions) {
            for (image, along) in product(&matrix(&stress), direction).iter().zip(direction) {
                prop_assert!((image - value * along).abs() < 5e-15);
            }
        }
        let [u, v, w] = &principal.directions;
        for (pair, expected) in [((u, u), 1.0), ((v, v), 1.0), ((w, w), 1.0), ((u, v), 0.0), ((u, w), 0.0), ((v, w), 0.0)] {
            prop_assert!((dot(pair.0, pair.1) - expected).abs() < 2e-15);
        }
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        prop_assert!(dot(&cross, w) > 0.999);
    }

    /// The von Mises stress follows from the principal values. Invariants do not depend on the axes, and a hydrostatic
    /// stress adds no shear.
    #[test]
    fn invariants_are_independent_of_axes(stress in stress(), axes in stress(), pressure in -2.0..2.0_f64) {
        let [a, b, c] = stress.principal().values;
        let squares = (a - b).powi(2) + (b - c).powi(2) + (c - a).powi(2);
        prop_assert!((stress.von_mises() - (0.5 * squares).sqrt()).abs() < 1e-14);
        prop_assert!((stress.max_shear() - 0.5 * (a - c)).abs() < 1e-15);
        prop_assert!((stress.hydrostatic() - (a + b + c) / 3.0).abs() < 1e-15);

        let turn = axes.principal().directions;
        let image = turn.map(|row| product(&matrix(&stress), &row));
        let entry = |i: usize, j: usize| dot(&image[i], &turn[j]);
        let turned = Stress {
            xx: entry(0, 0) + pressure, yy: entry(1, 1) + pressure, zz: entry(2, 2) + pressure,
            xy: entry(0, 1), xz: entry(0, 2), yz: entry(1, 2),
        };
        prop_assert!((turned.von_mises() - stress.von_mises()).abs() < 1e-14);
        prop_assert!((turned.max_shear() - stress.max_shear()).abs() < 1e-14);
        prop_assert!((turned.hydrostatic() - stress.hydrostatic() - pressure).abs() < 1e-14);
    }
}

/// A negative pressure is tension. The stress of a pair of contacts is the sum of their stresses.
#[test]
fn negative_pressure_is_tension() {
    let grid = Grid::square(8, 1.0).unwrap();
    let bodies = on_rigid(grid, 0.3);
    let points = [[0.1, 0.2, 0.0], [0.3, -0.1, 0.4]];
    let [push, pull] = [0.5, -0.5].map(|p| {
        let pressure = Field::constant(grid, p);
        at_points(&bodies, Body::One, Tractions::new(&pressure), &points).unwrap()
    });
    assert!(push[0].stress.zz < 0.0 && pull[0].stress.zz > 0.0);
    for (push, pull) in push.iter().zip(&pull) {
        let [push, pull] = [push, pull].map(components);
        let sums = push.iter().zip(pull).map(|(a, b)| a + b);
        assert!(sums.into_iter().all(|sum| sum.abs() < 1e-14));
    }
}
