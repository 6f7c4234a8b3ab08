//! The nine influence coefficients agree with values from 80-digit arithmetic at near and far points.

use approx::assert_relative_eq;
use kit::l2_difference;
use proptest::prelude::*;
use stickslip::fft::Convolution;
use stickslip::influence::{Component, Rectangle, Table, Tensor};
use stickslip::{ElasticPair, Field, Grid, Material, Operator};

/// Reference values at 60 points of a single body and at 7 points of a pair. The header of the file names the source.
const REFERENCE: &str = include_str!("../data/influence.csv");

/// Reference values at 96 points of a single body and at 24 points of a pair, computed independently of [`REFERENCE`].
/// Aspect ratios of the cells run from 1:100 to 100:1. Points are inside a cell, on its edge, next to it and up to a
/// million cells away. Poisson's ratios are -0.5, 0, 0.29, 0.499999 and 0.5.
const RANDOM_POINTS: &str = include_str!("../data/influence/random_points.csv");

fn material(modulus: &str, poisson_ratio: &str) -> Material {
    let nu = poisson_ratio.parse().unwrap();
    match modulus.split_at(1) {
        ("E", value) => Material::new(value.parse().unwrap(), nu).unwrap(),
        ("G", value) => Material::from_shear_modulus(value.parse().unwrap(), nu).unwrap(),
        _ => Material::rigid(),
    }
}

fn components(t: &Tensor) -> [f64; 9] {
    [t.xx, t.xy, t.xz, t.yx, t.yy, t.yz, t.zx, t.zy, t.zz]
}

/// Compares the coefficients with a table, and returns the number of points in the table.
fn compare(table: &str) -> usize {
    let rows = table.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|line| {
        let columns: Vec<&str> = line.split(',').collect();
        let number = |i: usize| columns[i].parse::<f64>().unwrap();
        let rectangle = Rectangle::new(number(3), number(4)).unwrap();
        let bodies = [
            material(columns[5], columns[6]),
            material(columns[7], columns[8]),
        ];
        let tensor = if bodies[1].is_rigid() {
            rectangle.tensor(&bodies[0], number(1), number(2))
        } else {
            let pair = ElasticPair::new(bodies[0], bodies[1]).unwrap();
            rectangle.pair_tensor(&pair, number(1), number(2))
        };
        let expected: Vec<f64> = (9..18).map(number).collect();
        let normal = expected[8];
        let coupling = expected[6].hypot(expected[7]);
        for (k, (found, expected)) in components(&tensor).iter().zip(&expected).enumerate() {
            let scale = if [2, 5, 6, 7].contains(&k) {
                coupling
            } else {
                normal
            };
            let error = (found - expected).abs();
            assert!(
                error <= 1e-14 * scale,
                "{}: component {k} is {found:e}, expected {expected:e}, error {:e}",
                columns[0],
                error / scale
            );
        }
    })
    .count()
}

#[test]
fn coefficients_match_exact_values() {
    assert_eq!(compare(REFERENCE), 67);
}

#[test]
fn coefficients_match_exact_values_at_random_points() {
    assert_eq!(compare(RANDOM_POINTS), 120);
}

#[test]
fn pair_with_rigid_body_has_coefficients_of_other_body() {
    let rectangle = Rectangle::new(0.5, 0.7).unwrap();
    let rubber = Material::new(3.0, 0.49).unwrap();
    assert_eq!(
        components(&rectangle.tensor(&Material::rigid(), 0.3, 0.2)),
        [0.0; 9]
    );
    let pair = ElasticPair::new(rubber, Material::rigid()).unwrap();
    assert_eq!(
        rectangle.pair_tensor(&pair, 0.3, 0.2),
        rectangle.tensor(&rubber, 0.3, 0.2)
    );
    // For body 2 the signs of the shear and therefore of the coupling are reversed.
    let pair = ElasticPair::new(Material::rigid(), rubber).unwrap();
    assert_eq!(
        rectangle.pair_tensor(&pair, 0.3, 0.2).zx,
        -rectangle.tensor(&rubber, 0.3, 0.2).zx
    );
}

#[test]
fn table_stores_coefficients_at_every_distance() {
    let pair = ElasticPair::new(
        Material::new(1.0, 0.2).unwrap(),
        Material::new(2.0, 0.4).unwrap(),
    )
    .unwrap();
    let grid = Grid::new(5, 4, 0.3, 0.5).unwrap();
    let rectangle = Rectangle::new(0.15, 0.25).unwrap();
    for (k, component) in Component::ALL.into_iter().enumerate() {
        let table = Table::sample(grid, &pair, component).unwrap();
        assert_eq!((table.component(), table.size()), (component, [5, 4]));
        for i in -4..=4_isize {
            for j in -3..=3_isize {
                let tensor = rectangle.pair_tensor(&pair, i as f64 * 0.3, j as f64 * 0.5);
                assert_eq!(
                    table.get(i, j),
                    Some(components(&tensor)[k]),
                    "{component:?} {i} {j}"
                );
            }
        }
        assert_eq!((table.get(5, 0), table.get(0, -4)), (None, None));
    }
}

/// A coefficient that is odd across an axis is exactly zero at any distance along the axis, without round-off.
#[test]
fn odd_coefficients_vanish_on_axes() {
    let pair = kit::unit_pair(0.3);
    let grid = Grid::new(30, 26, 0.3, 0.7).unwrap();
    for pair in [pair, kit::on_rigid(1.0, 0.2)] {
        for component in Component::ALL {
            let table = Table::sample(grid, &pair, component).unwrap();
            let [odd_x, odd_y] = component.is_odd();
            assert!(
                !odd_y || (0..30).all(|i| table.get(i, 0) == Some(0.0)),
                "{component:?}"
            );
            assert!(
                !odd_x || (0..26).all(|j| table.get(0, j) == Some(0.0)),
                "{component:?}"
            );
        }
    }
}

fn body() -> impl Strategy<Value = Material> {
    (-3.0..12.0_f64, -0.9..0.5_f64)
        .prop_map(|(decade, nu)| Material::new(10_f64.powf(decade), nu).unwrap())
}

/// Strategy for the sides (aspect ratio up to 100) and a point from the centre to far away.
fn cell_and_point() -> impl Strategy<Value = (f64, f64, f64, f64)> {
    (-9.0..3.0_f64, -2.0..2.0_f64, -3.0..6.0_f64, 0.0..6.3_f64).prop_map(
        |(size, aspect, distance, angle)| {
            let (a, b) = (10_f64.powf(size), 10_f64.powf(size + aspect));
            let r = a.max(b) * 10_f64.powf(distance);
            (a, b, r * angle.cos(), r * angle.sin())
        },
    )
}

proptest! {
    /// Covers mirror symmetry, exchange of the axes, and the identity of the trace.
    #[test]
    fn coefficients_obey_symmetries((a, b, x, y) in cell_and_point(), body in body()) {
        let cell = Rectangle::new(a, b).unwrap();
        let t = cell.tensor(&body, x, y);
        let mirrored = cell.tensor(&body, -x, y);
        prop_assert_eq!(
            components(&mirrored),
            [t.xx, -t.xy, -t.xz, -t.yx, t.yy, t.yz, -t.zx, t.zy, t.zz]
        );
        let swapped = Rectangle::new(b, a).unwrap().tensor(&body, y, x);
        assert_relative_eq!(swapped.xx, t.yy, max_relative = 1e-14);
        assert_relative_eq!(swapped.zx, t.zy, max_relative = 1e-13);
        assert_relative_eq!(swapped.zz, t.zz, max_relative = 1e-14);
        let nu = body.poisson_ratio();
        assert_relative_eq!(t.xx + t.yy, (2.0 - nu) / (1.0 - nu) * t.zz, max_relative = 1e-14);
        prop_assert!(t.xx > 0.0 && t.yy > 0.0 && t.zz > 0.0);
        prop_assert_eq!((t.xy, t.xz, t.yz), (t.yx, -t.zx, -t.zy));
    }

    #[test]
    fn cell_is_sum_of_its_quarters((a, b, x, y) in cell_and_point(), body in body()) {
        let whole = components(&Rectangle::new(a, b).unwrap().tensor(&body, x, y));
        let quarter = Rectangle::new(0.5 * a, 0.5 * b).unwrap();
        let mut sum = [0.0; 9];
        for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
            let part = components(&quarter.tensor(&body, x - 0.5 * sx * a, y - 0.5 * sy * b));
            for (sum, part) in sum.iter_mut().zip(part) {
                *sum += part;
            }
        }
        for (sum, whole_k) in sum.iter().zip(whole) {
            prop_assert!((sum - whole_k).abs() <= 2e-14 * whole[8], "{} {}", sum, whole_k);
        }
    }
}

/// The symbols of a periodic grid have the signs and magnitudes of the coefficients of a free half-space for all nine
/// components. The traction has zero mean, so its far field vanishes. The remaining difference is due to the uniform
/// pressure on the cells of the free grid and to the periodic images.
#[test]
fn periodic_grid_matches_free_grid_near_local_traction() {
    let cells = 128;
    let grid = Grid::new(cells, cells, 1.0, 1.5).unwrap();
    let pair = kit::on_rigid(1.0, 0.2);
    // The traction is the Laplacian of a Gaussian bell a few cells wide.
    let traction = Field::from_fn(grid, |x, y| {
        let r = (x * x + y * y) / 64.0;
        (1.0 - r) * (-r).exp()
    });
    for component in Component::ALL {
        let displacements = [
            Convolution::new(grid, &pair, component).unwrap(),
            Convolution::periodic(grid, &pair, component),
        ]
        .map(|operator| {
            let mut out = vec![0.0; grid.cells()];
            operator.apply(
                [traction.as_slice()],
                [&mut out],
                &mut operator.scratch().unwrap(),
            );
            out
        });
        let error = l2_difference(&displacements[1], &displacements[0]);
        assert!(error < 0.02, "{component:?} {error:e}");
    }
}
