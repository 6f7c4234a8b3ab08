//! Limits on the surface, exact symmetries and rows of points.
#![expect(clippy::float_cmp, reason = "these symmetries are exact")]

use super::{Numbers, at, error};
use crate::subsurface::kernel::{LoadedRectangle, PotentialIntegral};

const SIDES: [[f64; 2]; 5] = [[0.5, 0.5], [0.5, 0.8], [3.0, 0.5], [1e-3, 1.0], [1e3, 1.0]];

/// Returns points inside the cell, next to it, on the lines of its edges and far away.
fn places(sides: [f64; 2]) -> Vec<[f64; 2]> {
    let of = |side: f64| [0.0, 0.3, 1.0, 1.0 + 1e-9, 1.4, 5.0, 17.0, 400.0, 1e5].map(|k| k * side);
    let [xs, ys] = sides.map(of);
    xs.iter().flat_map(|&x| ys.map(|y| [x, y])).collect()
}

const DEPTHS: [f64; 7] = [0.0, 1e-9, 1e-3, 0.2, 2.0, 50.0, 1e6];

#[test]
fn parity_is_exact() {
    for sides in SIDES {
        let cell = LoadedRectangle::new(sides[0], sides[1]);
        for [x, y] in places(sides) {
            for z in DEPTHS {
                let values = cell.integrals([x, y, z]);
                assert!(values.iter().all(|value| value.is_finite()));
                for (mirror, axis) in [([-x, y, z], 0), ([x, -y, z], 1)] {
                    let mirrored = cell.integrals(mirror);
                    for integral in PotentialIntegral::ALL {
                        let is_odd = integral.is_odd()[axis];
                        let sign = if is_odd { -1.0 } else { 1.0 };
                        let value = values[integral.index()];
                        assert_eq!(mirrored[integral.index()], sign * value, "{integral:?}");
                        let is_on_axis = [x, y][axis] == 0.0;
                        assert!(!(is_odd && is_on_axis) || value == 0.0, "{integral:?}");
                    }
                }
            }
        }
    }
}

/// Checks that a traction along y acts like a traction along x with the axes exchanged.
#[test]
fn axes_can_be_exchanged() {
    let exchanged = [1, 0, 2, 4, 3, 5, 6, 8, 7];
    for sides in &SIDES[..3] {
        let cell = LoadedRectangle::new(sides[0], sides[1]);
        let turned = LoadedRectangle::new(sides[1], sides[0]);
        for [x, y] in places(*sides) {
            for z in DEPTHS {
                let found = at(&cell, [x, y, z], 0.3);
                let other = at(&turned, [y, x, z], 0.3);
                for (found, other) in [(found[0], other[0]), (found[2], other[1])] {
                    let error = error(&found, &exchanged.map(|k| other[k]));
                    assert!(error < 1e-14, "{error:e} {sides:?} {x} {y} {z}");
                }
            }
        }
    }
}

#[test]
fn the_surface_carries_the_load() {
    let mut numbers = Numbers::new();
    for [a, b] in SIDES {
        let cell = LoadedRectangle::new(a, b);
        for _ in 0..200 {
            let point = [
                a * numbers.between(-2.0, 2.0),
                b * numbers.between(-2.0, 2.0),
                0.0,
            ];
            let is_inside = point[0].abs() < a && point[1].abs() < b;
            let load = if is_inside { -1.0 } else { 0.0 };
            let nu = numbers.between(0.0, 0.5);
            let [p, qx, qy] = at(&cell, point, nu).map(|of| [of[5], of[7], of[8]]);
            let expected = [[load, 0.0, 0.0], [0.0, load, 0.0], [0.0, 0.0, load]];
            for (found, expected) in [p, qx, qy].iter().zip(expected) {
                for (found, expected) in found.iter().zip(expected) {
                    assert!((found - expected).abs() < 1e-15, "{found} {expected}");
                }
            }
        }
    }
}

#[test]
fn the_surface_is_the_limit_from_inside() {
    let mut numbers = Numbers::new();
    for [a, b] in SIDES {
        let cell = LoadedRectangle::new(a, b);
        for _ in 0..200 {
            let [x, y] = [
                a * numbers.between(-2.0, 2.0),
                b * numbers.between(-2.0, 2.0),
            ];
            let distance = (x.abs() - a).abs().min((y.abs() - b).abs());
            let z = 1e-17 * distance;
            let [above, below] = [0.0, z].map(|z| at(&cell, [x, y, z], 0.3));
            for (above, below) in above.iter().zip(below) {
                let error = error(above, &below);
                assert!(error < 1e-12, "{error:e} {a} {b} {x} {y}");
            }
        }
    }
}

/// Checks that the value on an edge is the mean of both sides without the logarithm of the distance. The unit of this
/// distance is the longer half side.
#[test]
fn edges_of_the_surface_have_the_finite_part() {
    let (a, b) = (0.75, 0.5);
    let cell = LoadedRectangle::new(a, b);
    let points = |step: f64| {
        let along_x = [[0.2, b - step], [0.2, b + step]];
        let along_y = [[a - step, -0.3], [a + step, -0.3]];
        [along_x, along_y]
    };
    let means = |step: f64| {
        points(step).map(|points| {
            let [inside, outside] = points.map(|[x, y]| cell.integrals([x, y, 0.0]));
            let mut mean = inside;
            for (mean, outside) in mean.iter_mut().zip(outside) {
                *mean = 0.5 * (*mean + outside);
            }
            mean
        })
    };
    // The ends remain exact.
    let [step, finer] = [24, 34].map(|n| 0.5_f64.powi(n));
    let edges = points(0.0).map(|[[x, y], _]| cell.integrals([x, y, 0.0]));
    for ((edge, coarse), fine) in edges.iter().zip(means(step)).zip(means(finer)) {
        for integral in PotentialIntegral::ALL {
            let k = integral.index();
            let slope = (coarse[k] - fine[k]) / (step / finer).ln();
            let finite = fine[k] - slope * (finer / a).ln();
            assert!(
                (edge[k] - finite).abs() < 1e-6,
                "{integral:?} {} {finite}",
                edge[k]
            );
        }
    }
}

/// Checks that a common edge and corner of neighbours with equal tractions have no effect.
#[test]
fn four_cells_are_one() {
    for [a, b] in SIDES {
        let (cell, large) = (
            LoadedRectangle::new(a, b),
            LoadedRectangle::new(2.0 * a, 2.0 * b),
        );
        let centres = [[a, b], [-a, b], [a, -b], [-a, -b]];
        for [x, y] in [
            [0.0, 0.0],
            [0.0, 0.5 * b],
            [0.3 * a, 0.0],
            [0.1 * a, -0.7 * b],
            [0.0, 3.0 * b],
        ] {
            for z in [0.0, 1e-6 * a, 0.1 * a, b] {
                let mut sum = [[0.0; 9]; 3];
                for [centre_x, centre_y] in centres {
                    let values = at(&cell, [x - centre_x, y - centre_y, z], 0.3);
                    for (sum, value) in sum.as_flattened_mut().iter_mut().zip(values.as_flattened())
                    {
                        *sum += value;
                    }
                }
                for (sum, expected) in sum.iter().zip(at(&large, [x, y, z], 0.3)) {
                    let error = error(sum, &expected);
                    assert!(error < 1e-12, "{error:e} {a} {b} {x} {y} {z}");
                }
            }
        }
    }
}

#[test]
fn rows_are_points() {
    for sides in SIDES {
        let cell = LoadedRectangle::new(sides[0], sides[1]);
        let xs: Vec<f64> = (-150..150).map(|k| 2.0 * sides[0] * f64::from(k)).collect();
        for y in [0.0, 0.4, 2.0, -2.0, 10.0, 900.0].map(|k| k * sides[1]) {
            for z in DEPTHS {
                let mut planes = vec![[0.0; 300]; PotentialIntegral::COUNT];
                let mut rows = planes.iter_mut().map(|plane| &mut plane[..]);
                let mut out =
                    [(); PotentialIntegral::COUNT].map(|()| rows.next().unwrap_or_default());
                cell.integrals_along_row(&xs, y, z, &mut out);
                for (k, &x) in xs.iter().enumerate() {
                    let point = cell.integrals([x, y, z]);
                    for (plane, value) in planes.iter().zip(point) {
                        assert_eq!(plane[k], value, "{sides:?} {x} {y} {z}");
                    }
                }
            }
        }
    }
}

#[test]
fn bad_numbers_are_passed_on() {
    let sizes = [
        [f64::NAN, 1.0],
        [0.0, 1.0],
        [1.0, -1.0],
        [f64::INFINITY, 1.0],
    ];
    for [a, b] in sizes {
        let values = LoadedRectangle::new(a, b).integrals([0.1, 0.2, 0.3]);
        assert!(values.iter().all(|value| value.is_nan()), "{a} {b}");
    }
    let slender = LoadedRectangle::new(1e-100, 1.0);
    assert!(
        slender
            .integrals([f64::NAN, 0.2, 0.3])
            .iter()
            .all(|value| value.is_nan())
    );
    assert!(
        slender
            .integrals([1e-101, 0.2, 0.0])
            .iter()
            .all(|value| value.is_finite())
    );
}
