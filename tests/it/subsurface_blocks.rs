//! Stresses at many points below many loaded cells, which are summed in blocks, equal the sum cell by cell.

use kit::Random;
use stickslip::subsurface::{Body, PointResult, Tractions, at_points};
use stickslip::{ElasticPair, Field, Grid, HalfSpace, Material};

fn bodies(grid: Grid) -> HalfSpace {
    let body = |g, nu| Material::from_shear_modulus(g, nu).unwrap();
    let pair = ElasticPair::new(body(1.0, 0.3), body(3.0, 0.1)).unwrap();
    HalfSpace::new(grid, pair).unwrap()
}

fn components(result: &PointResult) -> [f64; 9] {
    let ([ux, uy, uz], s) = (result.displacement, result.stress);
    [ux, uy, uz, s.xx, s.yy, s.zz, s.xy, s.xz, s.yz]
}

/// Returns the largest errors of displacements and stresses relative to the largest displacement and stress at the point, and at
/// all points. Up to three points are summed cell by cell.
fn errors(
    bodies: &HalfSpace,
    body: Body,
    tractions: Tractions<'_>,
    points: &[[f64; 3]],
) -> [f64; 2] {
    let found = at_points(bodies, body, tractions, points).unwrap();
    let one_by_one = points
        .chunks(3)
        .flat_map(|few| at_points(bodies, body, tractions, few).unwrap());
    let pairs: Vec<_> = found
        .iter()
        .zip(one_by_one)
        .map(|(found, expected)| (components(found), components(&expected)))
        .collect();
    assert_eq!(pairs.len(), points.len());
    let mut worst = [0.0_f64; 2];
    for range in [0..3, 3..9] {
        let largest = |values: &[f64; 9]| kit::max_abs(&values[range.clone()]);
        let overall = pairs.iter().map(|(_, b)| largest(b)).fold(0.0, f64::max);
        for (a, b) in &pairs {
            assert!(a.iter().all(|value| value.is_finite()));
            let error = kit::max_difference(&a[range.clone()], &b[range.clone()]);
            worst = [
                worst[0].max(error / largest(b)),
                worst[1].max(error / overall),
            ];
        }
    }
    worst
}

/// Returns points on the surface and at depths from 0.1 to 100 cells, most of them below a grid of square cells.
fn places(grid: Grid, count: usize, random: &mut Random) -> Vec<[f64; 3]> {
    let [x, y] = [grid.dx() * grid.nx() as f64, grid.dy() * grid.ny() as f64];
    let place = |i| {
        let reach = if i % 5 == 4 { 1.5 } else { 0.5 };
        let at = [x, y].map(|side| reach * side * random.uniform(-1.0, 1.0));
        let depth = random.decade(-1.0, 2.0) * grid.dx();
        [at[0], at[1], if i % 6 == 0 { 0.0 } else { depth }]
    };
    (0..count).map(place).collect()
}

/// Returns a field of values between -1 and 1.
fn random_field(grid: Grid, random: &mut Random) -> Field {
    let mut field = Field::zeros(grid);
    field.as_mut_slice().fill_with(|| random.uniform(-1.0, 1.0));
    field
}

#[test]
fn blocks_equal_sum_over_cells() {
    let sizes = [(64, 80, 1.0), (130, 41, 0.3), (4096, 1, 1.0)];
    for (nx, ny, aspect) in &sizes[..kit::thorough(2, 3)] {
        let grid = Grid::new(*nx, *ny, 1.0, *aspect).unwrap();
        let bodies = bodies(grid);
        let mut random = Random(7);
        let [p, qx, qy] = [0, 1, 2].map(|_| random_field(grid, &mut random));
        let cap = Field::from_fn(grid, |x, y| {
            (1.0 - (x * x + y * y) / 2000.0).max(0.0).sqrt()
        });
        let spots = p.map(|value| if value > 0.9 { value } else { 0.0 });
        let spread = Field::constant(grid, 1.0);
        let none = Field::zeros(grid);
        let points = places(grid, kit::thorough(10, 300), &mut random);
        for (p, q, tolerance) in [
            (&p, Some([&qx, &qy]), 1e-12),
            (&cap, None, 1e-13),
            (&spots, Some([&none, &spots]), 1e-13),
            (&spread, Some([&spread, &none]), 1e-13),
        ] {
            let tractions = Tractions::new(p);
            let tractions = q.map_or(tractions, |q| tractions.with_traction(q));
            for body in [Body::One, Body::Two] {
                let [at_point, overall] = errors(&bodies, body, tractions, &points);
                assert!(at_point < tolerance, "{nx} {body:?} {at_point:e}");
                assert!(overall < 1e-13, "{nx} {body:?} {overall:e}");
            }
        }
    }
}

/// The error of one cell in a block does not cancel against others, so it is the bound of the method.
#[test]
fn error_of_single_cell_is_bounded() {
    let grid = kit::square(64, 64.0);
    let bodies = bodies(grid);
    let mut random = Random(3);
    let mut worst: f64 = 0.0;
    for _ in 0..kit::thorough(6, 60) {
        let loaded = random.integer(0, 63);
        let load = |size| {
            let value = |ix, iy| {
                if [ix, iy] == [loaded, 40] {
                    size
                } else {
                    1e-30
                }
            };
            Field::from_indices(grid, value)
        };
        let (p, qx, qy) = (load(1.0), load(random.uniform(-1.0, 1.0)), load(0.5));
        let tractions = Tractions::new(&p).with_traction([&qx, &qy]);
        let points = places(grid, kit::thorough(12, 24), &mut random);
        worst = worst.max(errors(&bodies, Body::One, tractions, &points)[0]);
    }
    assert!(worst < 5e-12, "{worst:e}");
}

#[test]
fn blocks_are_bitwise_identical_for_any_number_of_threads() {
    let grid = kit::square(80, 80.0);
    let bodies = bodies(grid);
    let mut random = Random(5);
    let field = random_field(grid, &mut random);
    let points = places(grid, 100, &mut random);
    let tractions = Tractions::new(&field).with_traction([&field, &field]);
    let at = |threads, points: &[[f64; 3]]| {
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = builder.build().unwrap();
        pool.install(|| at_points(&bodies, Body::One, tractions, points).unwrap())
    };
    let alone = at(1, &points);
    assert_eq!(alone, at(3, &points));
    // A result does not depend on the other points.
    assert_eq!(alone[..4], at(2, &points[..4]));
}
