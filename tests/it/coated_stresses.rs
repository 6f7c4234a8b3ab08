//! Stresses on planes in and below layers are continuous at interfaces, in equilibrium, and equal to an independent
//! quadrature. If the layer has the material of the body, they equal the stresses of a homogeneous body.

use std::f64::consts::TAU;

use kit::max_abs;
use stickslip::influence::Direction::{X, Y, Z};
use stickslip::layers::Layer;
use stickslip::subsurface::{Body, Plane, Planes, Stress, Tractions, at_points};
use stickslip::{
    Boundary, CellValue, ElasticPair, Error, Field, Grid, HalfSpace, Material, Operator,
};

/// Stresses under a pressure (1 - r^2)^3. The layer has G = 3, nu = 0.35 and h = 0.4, and the body below it has G = 1
/// and nu = 0.25. They were computed from Hankel integrals of Love's strain function to 40 digits. A plus after a depth
/// denotes the lower side of the interface.
const BELOW: &str = include_str!("../data/layers/below.csv");

const BOUNDARIES: [Boundary; 3] = [
    Boundary::NonPeriodic,
    Boundary::Periodic,
    Boundary::PeriodicAlongY { datum: 50.0 },
];

fn layer(shear_modulus: f64, nu: f64, thickness: f64) -> Layer {
    Layer::new(2.0 * (1.0 + nu) * shear_modulus, nu, thickness).unwrap()
}

fn body(shear_modulus: f64, nu: f64) -> Material {
    Material::from_shear_modulus(shear_modulus, nu).unwrap()
}

fn bodies(one: Material, other: Material, boundary: Boundary, sides: [f64; 2]) -> HalfSpace {
    let rows = if matches!(boundary, Boundary::PeriodicAlongY { .. }) {
        1
    } else {
        10
    };
    let grid = Grid::new(14, rows, sides[0], sides[1]).unwrap();
    let pair = ElasticPair::new(one, other).unwrap();
    HalfSpace::with_boundary(grid, pair, boundary).unwrap()
}

/// Returns a pressure and two tractions.
fn loads(grid: Grid) -> [Field; 3] {
    let bump =
        |x: f64, y: f64| (-3.0 * (x * x / (grid.dx() * grid.dx()) + 0.7 * y * y) / 9.0).exp();
    [
        Field::from_fn(grid, bump),
        Field::from_fn(grid, |x, y| 0.4 * bump(x - 0.5 * grid.dx(), y)),
        Field::from_fn(grid, |x, y| 0.3 * bump(x + grid.dx(), y) * (1.0 + 0.3 * x)),
    ]
}

fn planes(bodies: &HalfSpace, body: Body, depths: &[f64]) -> Vec<Plane> {
    let [p, x, y] = loads(bodies.grid());
    let tractions = Tractions::new(&p).with_traction([&x, &y]);
    let mut planes = Planes::new(bodies, depths).unwrap().with_displacements();
    (0..depths.len())
        .map(|n| planes.solve(n, body, tractions).unwrap())
        .collect()
}

/// Returns the displacements, normal stresses and shear stresses.
fn fields(plane: &Plane) -> Vec<&Field> {
    let displacement = plane.displacement().unwrap();
    [displacement, plane.normal_stress(), plane.shear_stress()].concat()
}

fn assert_near(one: &Field, other: &Field, tolerance: f64, what: &str) {
    let error = one
        .as_slice()
        .iter()
        .zip(other.as_slice())
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    assert!(error <= tolerance, "{what}: {error:e}");
}

#[test]
fn layer_of_same_material_changes_nothing() {
    for boundary in BOUNDARIES {
        for nu in [0.3, 0.5] {
            let plain = body(2.0, nu);
            let coated = plain
                .coated(&[layer(2.0, nu, 0.8), layer(2.0, nu, 0.3)])
                .unwrap();
            for (which, pair) in [
                (Body::One, [coated, body(1.0, 0.2)]),
                (Body::Two, [body(1.0, 0.2), coated]),
            ] {
                for &sides in kit::thorough(&[[0.3, 0.4]][..], &[[0.3, 0.4], [3.0, 2.0]]) {
                    let depths = kit::thorough(
                        &[0.0, 0.8, 1.0, 1.5][..],
                        &[0.0, 0.1, 0.79, 0.8, 1.0, 1.1, 1.5, 20.0],
                    );
                    let alone =
                        pair.map(|material| if material == coated { plain } else { material });
                    let found = planes(&bodies(pair[0], pair[1], boundary, sides), which, depths);
                    let expected =
                        planes(&bodies(alone[0], alone[1], boundary, sides), which, depths);
                    for (found, expected) in found.iter().zip(&expected) {
                        let unit = max_abs(fields(expected)[2].as_slice()).max(1.0);
                        for (n, (found, expected)) in
                            fields(found).iter().zip(fields(expected)).enumerate()
                        {
                            let what =
                                format!("{boundary:?} {nu} {sides:?} {which:?} component {n}");
                            assert_near(found, expected, 1e-11 * unit, &what);
                        }
                    }
                }
            }
        }
    }
}

/// Returns a stack of three layers, the outermost first.
fn stack() -> Material {
    let layers = [
        layer(4.0, 0.3, 0.5),
        layer(0.2, 0.5, 0.3),
        layer(10.0, 0.0, 0.2),
    ];
    body(1.0, 0.25).coated(&layers).unwrap()
}

/// A plane at the surface has the applied tractions as stresses, and the displacements computed by the operators.
#[test]
fn surface_plane_has_tractions_and_displacements() {
    for boundary in BOUNDARIES {
        for sides in [[0.3, 0.4], [2.0, 1.5]] {
            let bed = Material::rigid().coated(&[layer(0.7, 0.4, 0.6)]).unwrap();
            let bodies = bodies(stack(), bed, boundary, sides);
            let tractions = loads(bodies.grid());
            let [one, two] =
                [Body::One, Body::Two].map(|body| planes(&bodies, body, &[0.0]).remove(0));
            for plane in [&one, &two] {
                let ([_, _, zz], [_, xz, yz]) = (plane.normal_stress(), plane.shear_stress());
                for (stress, traction) in [zz, xz, yz].into_iter().zip(&tractions) {
                    let carried = traction.map(|q| -q);
                    assert_near(stress, &carried, 1e-10, &format!("{boundary:?} {sides:?}"));
                }
            }
            let operator = bodies.tensor_operator([Z, X, Y]).unwrap();
            let mut moved: [_; 3] = std::array::from_fn(|_| Field::zeros(bodies.grid()));
            operator.apply(
                tractions.each_ref().map(Field::as_slice),
                moved.each_mut().map(Field::as_mut_slice),
                &mut operator.scratch().unwrap(),
            );
            let [x, y, z] = [0, 1, 2].map(|n| {
                let [one, two] = [&one, &two].map(|plane| plane.displacement().unwrap()[n]);
                let both = one.as_slice().iter().zip(two.as_slice());
                Field::from_vec(bodies.grid(), both.map(|(a, b)| a - b).collect()).unwrap()
            });
            let unit = max_abs(moved[0].as_slice());
            for (found, expected) in [z, x, y].iter().zip(&moved) {
                assert_near(
                    found,
                    expected,
                    1e-10 * unit,
                    &format!("{boundary:?} {sides:?} moved"),
                );
            }
        }
    }
}

/// Displacements, the stresses across the interface and the strains along it are continuous. The stresses along the
/// interface are discontinuous.
#[test]
fn interface_is_continuous() {
    for boundary in BOUNDARIES {
        let bodies = bodies(stack(), body(1.0, 0.3), boundary, [0.3, 0.4]);
        let layers = [(4.0, 0.3), (0.2, 0.5), (10.0, 0.0), (1.0, 0.25)];
        for (n, depth) in [0.5_f64, 0.5 + 0.3, 0.5 + 0.3 + 0.2]
            .into_iter()
            .enumerate()
        {
            let beyond = f64::from_bits(depth.to_bits() + 1);
            let [above, below] = planes(&bodies, Body::One, &[depth, beyond])
                .try_into()
                .unwrap();
            let unit = max_abs(above.displacement().unwrap()[2].as_slice());
            for (one, other) in fields(&above)[..3].iter().zip(fields(&below)) {
                assert_near(
                    one,
                    other,
                    1e-9 * unit,
                    &format!("{boundary:?} {depth} displacement"),
                );
            }
            let strains = |stress: Stress, (modulus, nu): (f64, f64)| {
                let trace = stress.xx + stress.yy + stress.zz;
                let strain = |normal: f64| (normal - nu / (1.0 + nu) * trace) / (2.0 * modulus);
                [
                    strain(stress.xx),
                    strain(stress.yy),
                    stress.xy / (2.0 * modulus),
                ]
            };
            let mut jump: f64 = 0.0;
            for (one, other) in above.stresses().zip(below.stresses()) {
                for (a, b) in [(one.zz, other.zz), (one.xz, other.xz), (one.yz, other.yz)] {
                    assert!((a - b).abs() < 1e-9, "{boundary:?} {depth}: {a} and {b}");
                }
                for (a, b) in strains(one, layers[n])
                    .iter()
                    .zip(strains(other, layers[n + 1]))
                {
                    assert!(
                        (a - b).abs() < 1e-8,
                        "{boundary:?} {depth} strain: {a} and {b}"
                    );
                }
                jump = jump.max((one.xx - other.xx).abs());
            }
            assert!(jump > 1e-2);
        }
    }
}

/// The forces on each part of a body balance.
#[test]
fn coated_stresses_are_in_equilibrium() {
    let grid = Grid::new(12, 10, 0.2, 0.3).unwrap();
    let pair = ElasticPair::new(stack(), Material::rigid()).unwrap();
    let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
    let k = [2.0 * TAU / 2.4, TAU / 3.0];
    let even = |x: f64, y: f64| (k[0] * x).cos() * (k[1] * y).cos();
    let (wave, none) = (Field::from_fn(grid, even), Field::zeros(grid));
    // Returns the part of a field that is odd along the given axes.
    let part = |field: &Field, odd: [bool; 2]| {
        let along = |x: f64, axis: usize| {
            if odd[axis] {
                (k[axis] * x).sin()
            } else {
                (k[axis] * x).cos()
            }
        };
        let mut sum = 0.0;
        for iy in 0..grid.ny() {
            for ix in 0..grid.nx() {
                let wave = along(grid.x(ix), 0) * along(grid.y(iy), 1);
                sum += field.get(ix, iy).unwrap() * wave;
            }
        }
        sum * 4.0 / grid.cells() as f64
    };
    let step = 0.01;
    // These are the weights of a central difference of eighth order.
    let weights = [0.8, -0.2, 4.0 / 105.0, -1.0 / 280.0].map(|weight| weight / step);
    for middle in [0.25, 0.65, 0.9, 1.3] {
        let depths: Vec<f64> = (-4..=4).map(|n| middle + step * f64::from(n)).collect();
        let mut planes = Planes::new(&bodies, &depths).unwrap();
        for shear in [false, true] {
            let tractions = if shear {
                Tractions::new(&none).with_traction([&wave, &none])
            } else {
                Tractions::new(&wave)
            };
            // The parities are given for a pressure. A traction along x inverts the parity along x. The sign is the sign
            // of d cos = -k sin.
            let odd = |x: bool, y: bool| [x != shear, y];
            let sign = if shear { 1.0 } else { -1.0 };
            let found: Vec<[f64; 6]> = (0..9)
                .map(|n| {
                    let plane = planes.solve(n, Body::One, tractions).unwrap();
                    let ([xx, yy, zz], [xy, xz, yz]) =
                        (plane.normal_stress(), plane.shear_stress());
                    [
                        part(xx, odd(false, false)),
                        part(yy, odd(false, false)),
                        part(zz, odd(false, false)),
                        part(xy, odd(true, true)),
                        part(xz, odd(true, false)),
                        part(yz, odd(false, true)),
                    ]
                })
                .collect();
            let [xx, yy, _, xy, xz, yz] = found[4];
            let slope = |n: usize| -> f64 {
                (0..4)
                    .map(|m| weights[m] * (found[5 + m][n] - found[3 - m][n]))
                    .sum()
            };
            let forces = [
                sign * k[0] * xx + k[1] * xy + slope(4),
                -sign * k[0] * xy - k[1] * yy + slope(5),
                -sign * k[0] * xz + k[1] * yz + slope(2),
            ];
            for force in forces {
                assert!(force.abs() < 1e-9, "{middle} {shear}: {forces:?}");
            }
        }
    }
}

#[test]
fn coated_stresses_match_independent_quadrature() {
    let grid = kit::square(65, 2.6);
    let coated = body(1.0, 0.25).coated(&[layer(3.0, 0.35, 0.4)]).unwrap();
    let pair = ElasticPair::new(coated, Material::rigid()).unwrap();
    let bodies = HalfSpace::new(grid, pair)
        .unwrap()
        .with_cell_value(CellValue::Centre)
        .unwrap();
    let pressure = Field::from_fn(grid, |x, y| (1.0 - x * x - y * y).max(0.0).powi(3));
    let mut count = 0;
    for row in BELOW.lines().skip(1) {
        let parts: Vec<&str> = row.split(',').collect();
        let depth: f64 = parts[0].trim_end_matches('+').parse().unwrap();
        let depth = if parts[0].ends_with('+') {
            f64::from_bits(depth.to_bits() + 1)
        } else {
            depth
        };
        let [xx, yy, zz, xz] = [2, 3, 4, 5].map(|n| parts[n].parse().unwrap());
        let expected = Stress {
            xx,
            yy,
            zz,
            xz,
            ..Stress::default()
        };
        let plane =
            Planes::new(&bodies, &[depth])
                .unwrap()
                .solve(0, Body::One, Tractions::new(&pressure));
        let found = plane.unwrap().get(parts[1].parse().unwrap(), 32).unwrap();
        let error = (found.von_mises() - expected.von_mises())
            .abs()
            .max((found - expected).von_mises());
        assert!(error < 2e-5, "{row}: {found:?}");
        count += 1;
    }
    assert_eq!(count, 20);
}

#[test]
fn unsupported_requests_are_rejected() {
    let bed = Material::rigid().coated(&[layer(1.0, 0.3, 0.5)]).unwrap();
    let bodies = bodies(bed, Material::rigid(), Boundary::NonPeriodic, [0.3, 0.4]);
    let pressure = Field::constant(bodies.grid(), 1.0);
    let mut planes = Planes::new(&bodies, &[0.5, 0.6]).unwrap();
    planes
        .solve(0, Body::One, Tractions::new(&pressure))
        .unwrap();
    kit::assert_refused! {
        planes.solve(1, Body::One, Tractions::new(&pressure)) => Error::RigidBody("the base of body 1"),
        planes.through(Body::One, Tractions::new(&pressure), |_| Ok(())) => Error::RigidBody(_),
        at_points(&bodies, Body::One, Tractions::new(&pressure), &[[0.0, 0.0, 0.1]])
            => Error::UnsupportedForCoatings { .. },
    }
}
