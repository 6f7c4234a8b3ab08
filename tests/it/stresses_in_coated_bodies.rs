//! Planes in layers and below them: those of one body where the layer is of its material, continuous where they must be,
//! in equilibrium, and those of an independent quadrature.

use kit::max_abs;
use stickslip::influence::Component;
use stickslip::layers::Layer;
use stickslip::subsurface::{Body, Plane, Planes, Tractions, at_points};
use stickslip::{Boundary, CellValue, ElasticPair, Error, Field, Grid, HalfSpace, Material, Operator};

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
    let rows = if matches!(boundary, Boundary::PeriodicAlongY { .. }) { 1 } else { 10 };
    let grid = Grid::new(14, rows, sides[0], sides[1]).unwrap();
    let pair = ElasticPair::new(one, other).unwrap();
    HalfSpace::with_boundary(grid, pair, boundary).unwrap()
}

/// A pressure and two tractions.
fn loads(grid: Grid) -> [Field; 3] {
    let bump = |x: f64, y: f64| (-3.0 * (x * x / (grid.dx() * grid.dx()) + 0.7 * y * y) / 9.0).exp();
    [
        Field::from_fn(grid, |x, y| bump(x, y)),
        Field::from_fn(grid, |x, y| 0.4 * bump(x - 0.5 * grid.dx(), y)),
        Field::from_fn(grid, |x, y| 0.3 * bump(x + grid.dx(), y) * (1.0 + 0.3 * x)),
    ]
}

fn planes(bodies: &HalfSpace, body: Body, depths: &[f64]) -> Vec<Plane> {
    let [p, x, y] = loads(bodies.grid());
    let tractions = Tractions::new(&p).with_traction([&x, &y]);
    let mut planes = Planes::new(bodies, depths).unwrap().with_displacements();
    (0..depths.len()).map(|n| planes.solve(n, body, tractions).unwrap()).collect()
}

/// Displacements, normal and shear stresses.
fn fields(plane: &Plane) -> Vec<&Field> {
    let displacement = plane.displacement().unwrap();
    [displacement, plane.normal_stress(), plane.shear_stress()].concat()
}

fn assert_near(one: &Field, other: &Field, tolerance: f64, what: &str) {
    let error = one.as_slice().iter().zip(other.as_slice()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(error <= tolerance, "{what}: {error:e}");
}

#[test]
fn a_layer_of_the_material_below_changes_nothing() {
    for boundary in BOUNDARIES {
        for nu in [0.3, 0.5] {
            let plain = body(2.0, nu);
            let coated = plain.coated(&[layer(2.0, nu, 0.8), layer(2.0, nu, 0.3)]).unwrap();
            for (which, pair) in [(Body::One, [coated, body(1.0, 0.2)]), (Body::Two, [body(1.0, 0.2), coated])] {
                for sides in [[0.3, 0.4], [3.0, 2.0]] {
                    let depths = [0.0, 0.1, 0.79, 0.8, 1.0, 1.1, 1.5, 20.0];
                    let alone = pair.map(|material| if material == coated { plain } else { material });
                    let found = planes(&bodies(pair[0], pair[1], boundary, sides), which, &depths);
                    let expected = planes(&bodies(alone[0], alone[1], boundary, sides), which, &depths);
                    for (found, expected) in found.iter().zip(&expected) {
                        let unit = max_abs(fields(&expected)[2].as_slice()).max(1.0);
                        for (n, (found, expected)) in fields(found).iter().zip(fields(expected)).enumerate() {
                            let what = format!("{boundary:?} {nu} {sides:?} {which:?} component {n}");
                            assert_near(found, expected, 1e-11 * unit, &what);
                        }
                    }
                }
            }
        }
    }
}
