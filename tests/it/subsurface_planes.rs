//! Planes below the surface agree with sums over cells for free bodies, and with the periodic half-space for periodic
//! grids.

use kit::{boundaries, max_abs};
use proptest::prelude::*;
use stickslip::influence::Direction::{X, Y, Z};
use stickslip::subsurface::{Body, Plane, Planes, Stress, Tractions, at_points};
use stickslip::{Boundary, ElasticPair, Error, Field, Grid, HalfSpace, Material, Operator};

fn pair(nu1: f64, nu2: f64) -> ElasticPair {
    let body = |g, nu| Material::from_shear_modulus(g, nu).unwrap();
    ElasticPair::new(body(1.0, nu1), body(2.5, nu2)).unwrap()
}

/// Returns irregular tractions, with some cells that carry no traction.
fn irregular_tractions(grid: Grid, seed: usize) -> [Field; 3] {
    [3, 5, 7].map(|prime: usize| {
        Field::from_indices(grid, |ix, iy| {
            let i = seed + ix + 31 * iy;
            if i % 4 == 0 {
                0.0
            } else {
                ((prime * i * i + 11 * i) % 17) as f64 - 7.0
            }
        })
    })
}

fn of(fields: &[Field; 3]) -> Tractions<'_> {
    Tractions::new(&fields[0]).with_traction([&fields[1], &fields[2]])
}

/// Returns all nine components, displacements first.
fn components(plane: &Plane) -> [&Field; 9] {
    let ([ux, uy, uz], [xx, yy, zz], [xy, xz, yz]) = (
        plane.displacement().unwrap(),
        plane.normal_stress(),
        plane.shear_stress(),
    );
    [ux, uy, uz, xx, yy, zz, xy, xz, yz]
}

/// Returns the largest difference of two planes, relative to the largest displacement or stress.
fn difference(found: &[&[f64]; 9], expected: &[&[f64]; 9]) -> f64 {
    difference_relative_to(found, expected, expected)
}

/// Returns the largest difference of two planes, relative to the largest displacement or stress of a third plane.
fn difference_relative_to(
    found: &[&[f64]; 9],
    expected: &[&[f64]; 9],
    largest: &[&[f64]; 9],
) -> f64 {
    let mut worst: f64 = 0.0;
    for range in [0..3, 3..9] {
        let fields = || found[range.clone()].iter().zip(&expected[range.clone()]);
        let largest = largest[range.clone()].iter();
        let scale = largest.fold(1e-300_f64, |scale, b| scale.max(max_abs(b)));
        for (found, expected) in fields() {
            assert_eq!(found.len(), expected.len());
            for (a, b) in found.iter().zip(*expected) {
                worst = worst.max((a - b).abs() / scale);
            }
        }
    }
    worst
}

fn slices(plane: &Plane) -> [&[f64]; 9] {
    components(plane).map(Field::as_slice)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(6, 40)))]

    /// The tolerance is 1e-13 of the largest component caused by the magnitudes of the tractions, because their resultants
    /// may nearly cancel. Planes are on the surface and below it, in both bodies, with and without shear.
    #[test]
    fn plane_is_sum_over_cells(
        nx in 1..kit::thorough(8, 12_usize), ny in 1..kit::thorough(8, 12_usize), aspect in 0.3..3.0_f64,
        depth in prop_oneof![Just(0.0), 1e-3..60.0_f64], nu in -0.4..0.5_f64, seed in 0..1000_usize,
    ) {
        let grid = Grid::new(nx, ny, 1.0, aspect).unwrap();
        let bodies = HalfSpace::new(grid, pair(nu, 0.5 - nu.abs())).unwrap();
        let fields = irregular_tractions(grid, seed);
        let sizes = fields.each_ref().map(|field| field.map(f64::abs));
        let mut planes = Planes::new(&bodies, &[depth]).unwrap().with_displacements();
        let points: Vec<_> = (0..grid.cells())
            .map(|i| [grid.x(i % nx), grid.y(i / nx), depth])
            .collect();
        for body in [Body::One, Body::Two] {
            for (tractions, sizes) in [
                (of(&fields), of(&sizes)),
                (Tractions::new(&fields[0]), Tractions::new(&sizes[0])),
            ] {
                let plane = planes.solve(0, body, tractions).unwrap();
                let [expected, largest] = [tractions, sizes].map(|tractions| -> [Vec<f64>; 9] {
                    let sums = at_points(&bodies, body, tractions, &points).unwrap();
                    std::array::from_fn(|k| {
                        let component = |r: &stickslip::subsurface::PointResult| {
                            let (u, s) = (r.displacement, r.stress);
                            [u[0], u[1], u[2], s.xx, s.yy, s.zz, s.xy, s.xz, s.yz][k]
                        };
                        sums.iter().map(component).collect()
                    })
                });
                let [expected, largest] = [&expected, &largest].map(|of| of.each_ref().map(|e| &e[..]));
                let error = difference_relative_to(&slices(&plane), &expected, &largest);
                prop_assert!(error < 1e-13, "{error:e}");
            }
        }
    }
}

/// Stresses in planes below rows that are periodic along y equal sums over images. This is also true for points that are
/// whole periods away.
#[test]
fn plane_of_periodic_rows_is_sum_over_images() {
    for (nx, ny) in [(9, 1), (5, 4)] {
        let grid = Grid::new(nx, ny, 1.0, 0.8).unwrap();
        let boundary = Boundary::PeriodicAlongY { datum: 20.0 };
        let bodies = HalfSpace::with_boundary(grid, pair(0.3, 0.1), boundary).unwrap();
        let fields = irregular_tractions(grid, 4);
        for &depth in kit::thorough(&[0.0, 2.0][..], &[0.0, 0.1, 2.0, 30.0]) {
            let mut planes = Planes::new(&bodies, &[depth]).unwrap().with_displacements();
            let plane = planes.solve(0, Body::One, of(&fields)).unwrap();
            let period = 0.8 * ny as f64;
            for &away in kit::thorough(&[-3.0 * period][..], &[0.0, -3.0 * period]) {
                let points: Vec<_> = (0..grid.cells())
                    .map(|i| [grid.x(i % nx), grid.y(i / nx) + away, depth])
                    .collect();
                let sums = at_points(&bodies, Body::One, of(&fields), &points).unwrap();
                let column = |k: usize| -> Vec<f64> {
                    let values = sums.iter().map(|r| {
                        let (u, s) = (r.displacement, r.stress);
                        [u[0], u[1], u[2], s.xx, s.yy, s.zz, s.xy, s.xz, s.yz][k]
                    });
                    values.collect()
                };
                let expected: [Vec<f64>; 9] = std::array::from_fn(column);
                let error = difference(&slices(&plane), &expected.each_ref().map(|e| &e[..]));
                assert!(error < 2e-13, "{nx} {ny} {depth} {error:e}");
            }
        }
        // The points are on the edge between cells of equal pressure within a pressed strip, where sxx = szz = -p.
        let even = Field::constant(grid, 1.0);
        let points = [grid.y(0), grid.y(0) + 0.4, 0.1].map(|y| [grid.x(1) + 0.5, y, 0.0]);
        for found in at_points(&bodies, Body::One, Tractions::new(&even), &points).unwrap() {
            assert!((found.stress.xx + 1.0).abs() + (found.stress.zz + 1.0).abs() < 1e-12);
        }
    }
}

/// At depth zero the stresses balance the tractions, and the relative displacement of the bodies equals the displacement that the
/// contact operators give.
#[test]
fn plane_at_depth_zero_has_surface_tractions_and_displacements() {
    for (nx, ny) in [(12, 10), (9, 7), (16, 1), (8, 2)] {
        let grid = Grid::new(nx, ny, 1.0, 0.7).unwrap();
        for boundary in boundaries(grid) {
            let bodies = HalfSpace::with_boundary(grid, pair(0.3, 0.1), boundary).unwrap();
            let fields = irregular_tractions(grid, 5);
            let mut planes = Planes::new(&bodies, &[0.0]).unwrap().with_displacements();
            let [one, two] =
                [Body::One, Body::Two].map(|body| planes.solve(0, body, of(&fields)).unwrap());
            for plane in [&one, &two] {
                let ([_, _, zz], [_, xz, yz]) = (plane.normal_stress(), plane.shear_stress());
                for (stress, traction) in [zz, xz, yz].iter().zip(&fields) {
                    for (stress, traction) in stress.as_slice().iter().zip(traction.as_slice()) {
                        assert!((stress + traction).abs() < 1e-12);
                    }
                }
            }
            let operator = bodies.tensor_operator([X, Y, Z]).unwrap();
            let mut expected = [0, 1, 2].map(|_| vec![0.0; grid.cells()]);
            operator.apply(
                [1, 2, 0].map(|k: usize| fields[k].as_slice()),
                expected.each_mut().map(|u| &mut u[..]),
                &mut operator.scratch().unwrap(),
            );
            let largest = expected
                .iter()
                .fold(0.0_f64, |scale, u| scale.max(max_abs(u)));
            let [one, two] = [&one, &two].map(|plane| plane.displacement().unwrap());
            for (k, expected) in expected.iter().enumerate() {
                for (i, expected) in expected.iter().enumerate() {
                    let found = one[k].as_slice()[i] - two[k].as_slice()[i];
                    let error = (found - expected).abs() / largest;
                    assert!(error < 2e-13, "{boundary:?} {nx} {ny} {k} {error:e}");
                }
            }
        }
    }
}

/// Returns the plane repeated over a larger grid, in the order of [`components`].
fn repeated(plane: &Plane, times: [usize; 2]) -> [Vec<f64>; 9] {
    let grid = plane.grid();
    components(plane).map(|field| {
        let rows = (0..times[1] * grid.ny()).map(|iy| {
            let row = &field.as_slice()[iy % grid.ny() * grid.nx()..][..grid.nx()];
            row.repeat(times[0])
        });
        rows.collect::<Vec<_>>().concat()
    })
}

/// Twice the period with repeated tractions gives the same planes.
#[test]
fn plane_of_twice_the_period_repeats_plane_of_period() {
    let cases = [
        (Boundary::Periodic, [2, 2], [6, 5]),
        (Boundary::Periodic, [1, 2], [8, 6]),
        (Boundary::PeriodicAlongY { datum: 30.0 }, [1, 2], [9, 5]),
        (Boundary::PeriodicAlongY { datum: 30.0 }, [1, 3], [7, 2]),
        (Boundary::PeriodicAlongY { datum: 30.0 }, [1, 4], [12, 1]),
    ];
    for (boundary, times, [nx, ny]) in cases {
        // An odd component of the wave with two cells per period is lost, whereas more cells resolve that wave. Both
        // grids therefore carry resolved waves only.
        let grid = Grid::new(nx, ny, 1.0, 1.3).unwrap();
        let larger = Grid::new(nx * times[0], ny * times[1], 1.0, 1.3).unwrap();
        let mut fields = irregular_tractions(grid, 3);
        if boundary == Boundary::Periodic {
            fields = [0, 1, 2].map(|k| {
                let phase = f64::from(k);
                Field::from_indices(grid, |ix, iy| {
                    let [x, y] = [ix as f64 / nx as f64, iy as f64 / ny as f64];
                    let [x, y] = [x, y].map(|t| std::f64::consts::TAU * t);
                    1.0 + phase + (x + phase).cos() + (2.0 * y - x).sin() + (x + y).cos()
                })
            });
        }
        let fields_of_larger = fields.each_ref().map(|field| {
            Field::from_indices(larger, |ix, iy| field.get(ix % nx, iy % ny).unwrap())
        });
        let depths = [0.0, 0.01, 0.8, 3.0, 20.0];
        let planes = |grid, fields| {
            let bodies = HalfSpace::with_boundary(grid, pair(0.3, 0.45), boundary).unwrap();
            let mut planes = Planes::new(&bodies, &depths).unwrap().with_displacements();
            [0, 1, 2, 3, 4].map(|i| planes.solve(i, Body::Two, of(fields)).unwrap())
        };
        for (one, two) in planes(grid, &fields)
            .iter()
            .zip(planes(larger, &fields_of_larger))
        {
            let one = repeated(one, times);
            let error = difference(&slices(&two), &one.each_ref().map(|field| &field[..]));
            assert!(
                error < 1e-13,
                "{boundary:?} {times:?} {} {error:e}",
                two.depth()
            );
        }
    }
}

/// A plane wave is in equilibrium, and its stresses follow from its displacements by Hooke's law.
#[test]
fn wave_is_in_equilibrium_and_obeys_hooke() {
    let (nu, step) = (0.3, 0.02);
    let grid = Grid::new(16, 8, 1.0, 1.5).unwrap();
    let bodies = HalfSpace::with_boundary(grid, pair(nu, 0.2), Boundary::Periodic).unwrap();
    // The wavelengths are 8 and 4 cells, so that a quarter of a wavelength is 2 cells and 1 cell.
    let k = [8.0, 4.0 * 1.5].map(|length| std::f64::consts::TAU / length);
    let wave = |phase: f64| Field::from_fn(grid, |x, y| (k[0] * x + k[1] * y + phase).cos());
    let fields = [wave(0.0), wave(1.0), wave(2.3)];
    for depth in [0.1, 0.7, 2.0] {
        let depths: Vec<f64> = (-3..=3).map(|j| depth + step * f64::from(j)).collect();
        let mut planes = Planes::new(&bodies, &depths).unwrap().with_displacements();
        let solved: Vec<Plane> = (0..7)
            .map(|j| planes.solve(j, Body::One, of(&fields)).unwrap())
            .collect();
        let at = |plane: &Plane, c: usize, ix: usize, iy: usize| {
            components(plane)[c].get(ix % 16, iy % 8).unwrap()
        };
        for (ix, iy) in [(0, 0), (3, 5), (10, 2)] {
            let value = |c| at(&solved[3], c, ix, iy);
            let dx = |c| k[0] * at(&solved[3], c, ix + 2, iy);
            let dy = |c| k[1] * at(&solved[3], c, ix, iy + 1);
            let dz = |c| {
                let pair = |j: usize| at(&solved[3 + j], c, ix, iy) - at(&solved[3 - j], c, ix, iy);
                (45.0 * pair(1) - 9.0 * pair(2) + pair(3)) / (60.0 * step)
            };
            for [x, y, z] in [[3, 6, 7], [6, 4, 8], [7, 8, 5]] {
                let force = dx(x) + dy(y) + dz(z);
                assert!(force.abs() < 1e-9, "{force:e}");
            }
            // The shear modulus is 1.
            let mean = 2.0 * nu / (1.0 - 2.0 * nu) * (dx(0) + dy(1) + dz(2));
            let hooke = [
                2.0 * dx(0) + mean,
                2.0 * dy(1) + mean,
                2.0 * dz(2) + mean,
                dx(1) + dy(0),
                dx(2) + dz(0),
                dy(2) + dz(1),
            ];
            for (c, expected) in (3..9).zip(hooke) {
                assert!((value(c) - expected).abs() < 1e-9);
            }
        }
    }
}

/// Under a uniform traction the stresses do not change with depth, and there is no lateral strain.
#[test]
fn uniform_traction_causes_no_lateral_strain() {
    let grid = Grid::new(6, 4, 1.0, 1.0).unwrap();
    let bodies = HalfSpace::with_boundary(grid, pair(0.25, 0.4), Boundary::Periodic).unwrap();
    let fields = [3.0, 0.5, -0.25].map(|value| Field::constant(grid, value));
    let mut planes = Planes::new(&bodies, &[0.0, 5.0])
        .unwrap()
        .with_displacements();
    for (body, nu) in [(Body::One, 0.25), (Body::Two, 0.4)] {
        for index in [0, 1] {
            let plane = planes.solve(index, body, of(&fields)).unwrap();
            let lateral = -3.0 * nu / (1.0 - nu);
            let expected = Stress {
                xx: lateral,
                yy: lateral,
                zz: -3.0,
                xy: 0.0,
                xz: -0.5,
                yz: 0.25,
            };
            for stress in plane.stresses() {
                let difference = Stress {
                    xx: stress.xx - expected.xx,
                    yy: stress.yy - expected.yy,
                    zz: stress.zz - expected.zz,
                    xy: stress.xy,
                    xz: stress.xz - expected.xz,
                    yz: stress.yz - expected.yz,
                };
                assert!(difference.von_mises() + difference.hydrostatic().abs() < 1e-14);
            }
            assert!(
                plane
                    .displacement()
                    .unwrap()
                    .iter()
                    .all(|u| max_abs(u.as_slice()) < 1e-15)
            );
        }
    }
}

/// Equal rows give the same planes as a single row of cells, at every depth.
#[test]
fn equal_rows_match_single_row() {
    let boundary = Boundary::PeriodicAlongY { datum: 50.0 };
    let (line, rows) = (
        Grid::line(14, 0.8).unwrap(),
        Grid::new(14, 6, 0.8, 0.45).unwrap(),
    );
    let fields = irregular_tractions(line, 2);
    let on_rows = fields
        .each_ref()
        .map(|f| Field::from_indices(rows, |ix, _| f.as_slice()[ix]));
    let depths = [0.0, 1e-3, 0.5, 4.0, 30.0];
    let solve = |grid, fields: &[Field; 3]| {
        let bodies = HalfSpace::with_boundary(grid, pair(0.2, 0.3), boundary).unwrap();
        let mut planes = Planes::new(&bodies, &depths).unwrap().with_displacements();
        [0, 1, 2, 3, 4].map(|i| planes.solve(i, Body::One, of(fields)).unwrap())
    };
    for (one, many) in solve(line, &fields).iter().zip(solve(rows, &on_rows)) {
        let one = repeated(one, [1, 6]);
        let error = difference(&slices(&many), &one.each_ref().map(|field| &field[..]));
        assert!(error < 1e-13, "{} {error:e}", many.depth());
    }
}

/// Returns the stresses xx, zz and xz of `McEwen` (1949), given in Johnson (1985), equation 4.49. The half-width and the
/// largest pressure are one.
fn mcewen(x: f64, z: f64) -> [f64; 3] {
    let sum = 1.0 - x * x + z * z;
    let root = (sum * sum + 4.0 * x * x * z * z).sqrt();
    let (m, n) = (
        (0.5 * (root + sum)).sqrt(),
        (0.5 * (root - sum)).max(0.0).sqrt(),
    );
    let n = n.copysign(x);
    let ratio = (z * z + n * n) / (m * m + n * n);
    let shear = -n * (m * m - z * z) / (m * m + n * n);
    [-m * (1.0 + ratio) + 2.0 * z, -m * (1.0 - ratio), shear]
}

/// The stresses below a cylinder agree with the closed form and satisfy plane strain along the cylinder.
#[test]
fn cylinder_stresses_match_mcewen() {
    let errors = [128, 512].map(|n| {
        let grid = Grid::line(n, 3.0 / n as f64).unwrap();
        let boundary = Boundary::PeriodicAlongY { datum: 10.0 };
        let bodies = HalfSpace::with_boundary(grid, pair(0.3, 0.3), boundary).unwrap();
        let pressure = Field::from_fn(grid, |x, _| (1.0 - x * x).max(0.0).sqrt());
        let mut planes = Planes::new(&bodies, &[0.2, 0.786, 2.0]).unwrap();
        let mut worst: f64 = 0.0;
        planes
            .through(Body::One, Tractions::new(&pressure), |plane| {
                for (ix, stress) in plane.stresses().enumerate() {
                    let [xx, zz, xz] = mcewen(grid.x(ix), plane.depth());
                    for difference in [stress.xx - xx, stress.zz - zz, stress.xz - xz] {
                        worst = worst.max(difference.abs());
                    }
                    assert!((stress.yy - 0.3 * (stress.xx + stress.zz)).abs() < 1e-14);
                    assert!(stress.xy.abs() + stress.yz.abs() < 1e-14);
                }
                Ok(())
            })
            .unwrap();
        // The largest shear stress is 0.300 p0 at the depth 0.786 a.
        let largest = planes
            .solve(1, Body::One, Tractions::new(&pressure))
            .unwrap();
        assert!((largest.map(|stress| stress.max_shear()).max() - 0.300).abs() < 1e-3);
        worst
    });
    // The error is of order 3/2 at the edge of the contact.
    assert!(
        errors[1] < 2e-4 && errors[1] < 0.2 * errors[0],
        "{errors:?}"
    );
}

/// A sliding cylinder has its largest tension on the surface at the trailing edge, where the tractions vanish as the square root
/// of the distance from the edge. This tension is twice the friction coefficient times the largest pressure. The largest tension
/// of the cells converges to this value from below, with an error proportional to the square root of the cell size.
#[test]
fn sliding_cylinder_has_largest_tension_at_trailing_edge() {
    let tension = |n: usize| {
        let grid = Grid::line(n + n / 4, 2.0 / n as f64).unwrap();
        let boundary = Boundary::PeriodicAlongY { datum: 10.0 };
        let bodies = HalfSpace::with_boundary(grid, pair(0.3, 0.3), boundary).unwrap();
        let pressure = Field::from_fn(grid, |x, _| (1.0 - x * x).max(0.0).sqrt());
        let (shear, none) = (pressure.scaled(0.5), Field::zeros(grid));
        let tractions = Tractions::new(&pressure).with_traction([&shear, &none]);
        let mut planes = Planes::new(&bodies, &[0.0]).unwrap();
        let surface = planes.solve(0, Body::One, tractions).unwrap();
        let along_x = surface.normal_stress()[0].as_slice();
        let (cell, largest) = (0..along_x.len())
            .map(|i| (i, along_x[i]))
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap();
        // This is the first cell behind the contact.
        assert_eq!(cell + 1, n / 8);
        largest
    };
    let found = [128, 512, 2048].map(tension);
    for (n, found) in [128.0, 512.0, 2048.0_f64].iter().zip(found) {
        assert!(found < 1.0 && found > 1.0 - 1.35 / n.sqrt(), "{n} {found}");
    }
    // The error halves if the cell size is divided by four.
    let limit = 2.0 * found[2] - found[1];
    assert!((limit - 1.0).abs() < 2e-3, "{limit}");
}

/// Returns Hertz's ball on a body with the given Poisson's ratio, on `n` cells along a side. The contact radius and the
/// largest pressure are one.
fn ball(n: usize, nu: f64) -> (HalfSpace, Field) {
    let grid = kit::square(n, 2.2);
    let bodies = HalfSpace::new(grid, pair(nu, 0.2)).unwrap();
    let pressure = Field::from_fn(grid, |x, y| (1.0 - x * x - y * y).max(0.0).sqrt());
    (bodies, pressure)
}

/// The maximum shear stresses on the axis and their depths are known for three Poisson's ratios.
#[test]
fn ball_has_largest_shear_stress_near_half_the_contact_radius() {
    let known = [
        (0.25, 0.643356806, 0.464313193),
        (0.3, 0.620041, 0.480864),
        (0.5, 0.532697, 0.547868),
    ];
    for (nu, von_mises, depth) in known {
        let (bodies, pressure) = ball(96, nu);
        let points = [-0.04, 0.0, 0.04].map(|shift| [0.0, 0.0, depth + shift]);
        let found = at_points(&bodies, Body::One, Tractions::new(&pressure), &points).unwrap();
        let [before, at, after] = [0, 1, 2].map(|i: usize| found[i].stress.von_mises());
        assert!(before < at && after < at);
        // The place is the vertex of the parabola through the three values.
        let place = 0.02 * (after - before) / (2.0 * at - before - after);
        assert!(place.abs() < 2e-3, "{place}");
        assert!((at - von_mises).abs() < 2e-4, "{at}");
        assert!((found[1].stress.max_shear() - 0.5 * von_mises).abs() < 1e-4);
        if nu == 0.3 {
            assert!((found[1].stress.max_shear() - 0.310).abs() < 5e-4);
        }
    }
}

/// Von Mises stress, sxx, szz and sxz below a ball that slides along x (nu = 0.3), in the plane y = 0 or at `[x, y, z]`.
/// They are quadratures of Hamilton and Goodman's problem. The last point for each friction has the largest von Mises
/// stress below the surface.
#[expect(clippy::type_complexity, reason = "a table")]
const SLIDING: [(f64, [([f64; 3], f64, [f64; 3]); 4], [f64; 3]); 2] = [
    (
        0.25,
        [
            (
                [0.0, 0.0, 0.48],
                0.632191050961,
                [-0.192703645005, -0.812743823147, -0.071217278812],
            ),
            (
                [0.5, 0.0, 0.25],
                0.591823006076,
                [-0.436451035326, -0.822767876591, -0.229937725417],
            ),
            (
                [0.5, 0.5, 0.5],
                0.563318982440,
                [-0.182129614775, -0.532063011471, -0.187725054917],
            ),
            (
                [1.2, 0.0, 0.3],
                0.314700300618,
                [-0.258694499244, -0.086982913545, -0.149576780582],
            ),
        ],
        [0.27028, 0.44405, 0.647593455],
    ),
    (
        0.5,
        [
            (
                [0.0, 0.0, 0.48],
                0.667317489751,
                [-0.192703645005, -0.812743823147, -0.142434557624],
            ),
            (
                [0.5, 0.0, 0.25],
                0.725991837238,
                [-0.552444627381, -0.852576718708, -0.340640082366],
            ),
            (
                [-0.5, 0.0, 0.25],
                0.599667497383,
                [-0.088470259159, -0.733341350240, -0.102169345430],
            ),
            (
                [3.0, 1.0, 1.0],
                0.057760490994,
                [-0.046477954125, -0.007225512388, -0.019992961652],
            ),
        ],
        [0.46146, 0.33127, 0.732064998],
    ),
];

#[test]
fn sliding_ball_matches_hamilton() {
    let (bodies, pressure) = ball(128, 0.3);
    let none = Field::zeros(pressure.grid());
    for (friction, known, [x, z, largest]) in SLIDING {
        let shear = pressure.scaled(friction);
        let tractions = Tractions::new(&pressure).with_traction([&shear, &none]);
        let at = |point| at_points(&bodies, Body::One, tractions, &[point]).unwrap()[0].stress;
        for (point, von_mises, components) in known {
            let found = at(point);
            for (found, known) in [found.xx, found.zz, found.xz].iter().zip(components) {
                assert!(
                    (found - known).abs() < 3e-4,
                    "{friction} {point:?} {found} {known}"
                );
            }
            assert!((found.von_mises() - von_mises).abs() < 3e-4);
        }
        let top = at([x, 0.0, z]).von_mises();
        assert!((top - largest).abs() < 3e-4, "{top}");
        for [dx, dz] in [[0.05, 0.0], [-0.05, 0.0], [0.0, 0.05], [0.0, -0.05]] {
            assert!(at([x + dx, 0.0, z + dz]).von_mises() < top);
        }
    }
}

/// At a friction coefficient of 0.5 the von Mises stress is larger at the trailing edge. At this edge Hamilton and Goodman
/// give `sxx = mu pi (4 + nu)/8 + (1 - 2 nu)/3` and `syy = 3 mu pi nu/8 - (1 - 2 nu)/3` on the surface. The other stresses
/// vanish, and the von Mises stress is 0.9567. The first cells behind the contact converge to this value from below, with
/// an error proportional to the square root of the cell size.
#[test]
fn sliding_ball_has_largest_stress_at_trailing_edge() {
    let (friction, nu) = (0.5, 0.3);
    let scale = friction * std::f64::consts::PI / 8.0;
    let edge = Stress {
        xx: scale * (4.0 + nu) + (1.0 - 2.0 * nu) / 3.0,
        yy: scale * 3.0 * nu - (1.0 - 2.0 * nu) / 3.0,
        ..Stress::default()
    };
    assert!((edge.von_mises() - 0.9567).abs() < 1e-4);
    let found = [220, 880].map(|n: usize| {
        let (bodies, pressure) = ball(n, nu);
        let grid = pressure.grid();
        let (shear, none) = (pressure.scaled(friction), Field::zeros(grid));
        let tractions = Tractions::new(&pressure).with_traction([&shear, &none]);
        let touches = |ix: &usize| pressure.get(*ix, n / 2).unwrap() > 0.0;
        let behind = (0..n).find(touches).unwrap() - 1;
        let point = [grid.x(behind), grid.y(n / 2), 0.0];
        let found = at_points(&bodies, Body::One, tractions, &[point]).unwrap()[0];
        let error = edge.von_mises() - found.stress.von_mises();
        assert!(
            error > 0.0 && error < 1.2 / (n as f64).sqrt(),
            "{n} {error}"
        );
        found.stress.von_mises()
    });
    // The error halves if the cell size is divided by four.
    let limit = 2.0 * found[1] - found[0];
    assert!((limit - edge.von_mises()).abs() < 2e-3, "{limit}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(4, 48)))]

    /// On a grid that is periodic along both axes, every plane carries the load. For any tractions, the sums of the
    /// stresses of a plane equal the sums of the tractions.
    #[test]
    fn every_periodic_plane_carries_the_load(
        nx in 1..24_usize, ny in 1..24_usize, aspect in 0.3..3.0_f64, nu in -0.4..0.5_f64,
        depth in prop_oneof![Just(0.0), 1e-3..60.0_f64], seed in 0..1000_usize,
    ) {
        let grid = Grid::new(nx, ny, 1.0, aspect).unwrap();
        let pair = pair(nu, 0.5 - nu.abs());
        let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
        let fields = irregular_tractions(grid, seed);
        let mut planes = Planes::new(&bodies, &[depth]).unwrap();
        for body in [Body::One, Body::Two] {
            let plane = planes.solve(0, body, of(&fields)).unwrap();
            let ([_, _, zz], [_, xz, yz]) = (plane.normal_stress(), plane.shear_stress());
            for (stress, traction) in [zz, xz, yz].into_iter().zip(&fields) {
                let error = (stress.integral() + traction.integral()).abs() / grid.area();
                prop_assert!(error <= 1e-13 * max_abs(traction.as_slice()), "{error:e}");
            }
        }
    }

    /// Below arbitrary tractions on free bodies and on periodic rows, the forces on a small cube balance. They are
    /// evaluated by central differences of sixth order.
    #[test]
    fn stresses_below_random_tractions_are_in_equilibrium(
        nx in 1..6_usize, ny in 1..6_usize, aspect in 0.3..3.0_f64, nu in -0.4..0.5_f64, repeats in any::<bool>(),
        at in [-6.0..6.0_f64, -6.0..6.0_f64, 0.4..6.0_f64], seed in 0..1000_usize,
    ) {
        let grid = Grid::new(nx, ny, 1.0, aspect).unwrap();
        let [free, _, along_y] = boundaries(grid);
        let boundary = if repeats { along_y } else { free };
        let bodies = HalfSpace::with_boundary(grid, pair(nu, 0.5 - nu.abs()), boundary).unwrap();
        let fields = irregular_tractions(grid, seed);
        let step = 0.01 * at[2];
        for (body, side) in [(Body::One, 1.0), (Body::Two, -1.0)] {
            let derivative = |axis: usize| {
                let points = [3.0, 2.0, 1.0, -1.0, -2.0, -3.0].map(|steps| {
                    let mut point = at;
                    point[axis] += steps * step;
                    point
                });
                let found = at_points(&bodies, body, of(&fields), &points).unwrap();
                let weights = [1.0, -9.0, 45.0, -45.0, 9.0, -1.0];
                // The axis z points out of body 2.
                let along = if axis == 2 { side } else { 1.0 };
                let sum = |component: fn(&Stress) -> f64| {
                    let terms = found.iter().zip(weights).map(|(r, weight)| weight * component(&r.stress));
                    along * terms.sum::<f64>() / (60.0 * step)
                };
                match axis {
                    0 => [sum(|s| s.xx), sum(|s| s.xy), sum(|s| s.xz)],
                    1 => [sum(|s| s.xy), sum(|s| s.yy), sum(|s| s.yz)],
                    _ => [sum(|s| s.xz), sum(|s| s.yz), sum(|s| s.zz)],
                }
            };
            let parts = [0, 1, 2].map(derivative);
            let scale = parts.as_flattened().iter().fold(1e-6, |scale: f64, part| scale.max(part.abs()));
            for k in 0..3 {
                let force: f64 = parts.iter().map(|part| part[k]).sum();
                prop_assert!(force.abs() < 1e-7 * scale, "{force:e} {scale:e}");
            }
        }
    }
}

#[test]
fn reused_planes_are_bitwise_identical() {
    let [nx, ny] = kit::thorough([14, 12], [70, 66]);
    let grid = Grid::new(nx, ny, 1.0, 0.7).unwrap();
    for boundary in boundaries(grid) {
        let bodies = HalfSpace::with_boundary(grid, pair(0.3, 0.1), boundary).unwrap();
        let (fields, others) = (irregular_tractions(grid, 1), irregular_tractions(grid, 8));
        let mut planes = Planes::new(&bodies, &[0.0, 2.5, 0.3])
            .unwrap()
            .with_displacements();
        let mut solved = Vec::new();
        let visit = |plane: &Plane| {
            solved.push(plane.clone());
            Ok(())
        };
        planes.through(Body::Two, of(&fields), visit).unwrap();
        assert_eq!(
            solved.iter().map(Plane::depth).collect::<Vec<_>>(),
            planes.depths()
        );
        assert!(
            solved
                .iter()
                .all(|plane| plane.z() <= 0.0 && plane.body() == Body::Two)
        );
        // The plane is solved for other tractions and by a clone in between.
        let mut reused = planes
            .solve(0, Body::One, Tractions::new(&others[0]))
            .unwrap();
        for index in [2, 0, 1] {
            planes
                .clone()
                .solve_into(index, Body::Two, of(&fields), &mut reused)
                .unwrap();
            assert!(reused == solved[index]);
            planes
                .solve_into(index, Body::Two, of(&fields), &mut reused)
                .unwrap();
            assert!(reused == solved[index]);
        }
        assert_eq!(reused.get(3, 4), reused.stresses().nth(4 * nx + 3));
        assert_eq!(reused.get(nx, 0), None);
    }
}

#[test]
fn invalid_planes_are_rejected() {
    let grid = Grid::new(4, 3, 1.0, 1.0).unwrap();
    let body = Material::new(1.0, 0.3).unwrap();
    let on_rigid = ElasticPair::new(body, Material::rigid()).unwrap();
    let bodies = HalfSpace::new(grid, on_rigid).unwrap();
    for bad in [-1e-9, f64::NAN, f64::INFINITY] {
        kit::assert_refused! { Planes::new(&bodies, &[0.0, bad]) => Error::Sample { index: 1, .. } }
    }
    let mut planes = Planes::new(&bodies, &[0.0, 1.0]).unwrap();
    let p = Field::constant(grid, 1.0);
    for (index, needed) in [(2, 3), (usize::MAX, usize::MAX)] {
        let refused = planes.solve(index, Body::One, Tractions::new(&p));
        let Err(Error::Length {
            expected, found, ..
        }) = refused
        else {
            panic!("{refused:?}")
        };
        assert_eq!((expected, found), (needed, 2));
    }
    kit::assert_refused! { planes.solve(0, Body::Two, Tractions::new(&p)) => Error::RigidBody("body 2") }
    let other = HalfSpace::new(Grid::new(3, 4, 1.0, 1.0).unwrap(), on_rigid).unwrap();
    let field = Field::zeros(other.grid());
    let mut plane = Planes::new(&other, &[0.0])
        .unwrap()
        .solve(0, Body::One, Tractions::new(&field))
        .unwrap();
    kit::assert_refused! {
        planes.solve_into(0, Body::One, Tractions::new(&p), &mut plane) => Error::GridMismatch { .. },
        planes.solve(0, Body::One, Tractions::new(&field)) => Error::GridMismatch { .. },
    }
}

/// A uniform stress, such as the stress of the bulk, is included in all stresses of planes and points. Displacements do not
/// include it.
#[test]
fn uniform_stress_is_added_to_planes_and_points() {
    let grid = Grid::new(7, 6, 0.4, 0.5).unwrap();
    let fields = irregular_tractions(grid, 3);
    let bulk = Stress {
        xx: 4.0,
        yy: 1.2,
        xy: -0.7,
        ..Stress::default()
    };
    let loads = of(&fields);
    for boundary in boundaries(grid) {
        let bodies = HalfSpace::with_boundary(grid, pair(0.3, 0.1), boundary).unwrap();
        let planes = Planes::new(&bodies, &[0.0, 0.3]).unwrap();
        let mut planes = planes.with_displacements();
        for body in [Body::One, Body::Two] {
            for index in [0, 1] {
                let alone = planes.solve(index, body, loads).unwrap();
                let both = loads.with_uniform_stress(bulk);
                let both = planes.solve(index, body, both).unwrap();
                for (sum, stress) in both.stresses().zip(alone.stresses()) {
                    assert_eq!(sum, stress + bulk);
                }
                let equivalent = both.map(|stress| stress.von_mises());
                assert!(max_abs(equivalent.as_slice()) > 1.0);
                assert_eq!(both.displacement(), alone.displacement());
            }
        }
        if boundary != Boundary::Periodic {
            let points = [[0.1, 0.2, 0.3]];
            let at = |loads| at_points(&bodies, Body::One, loads, &points).unwrap()[0];
            let (alone, both) = (at(loads), at(loads.with_uniform_stress(bulk)));
            assert_eq!(both.stress, alone.stress + bulk);
            assert_eq!(both.displacement, alone.displacement);
        }
        let broken = loads.with_uniform_stress(Stress {
            zz: f64::NAN,
            ..bulk
        });
        kit::assert_refused! { planes.solve(0, Body::One, broken) => Error::Sample { index: 2, .. } }
    }
}
