//! Gaussian filters transmit half the amplitude of a wave at their nesting index. Their parts sum to the surface, and
//! missing heights have no effect. Filtering recovers the contact of a noisy measurement.

use std::collections::BTreeMap;
use std::f64::consts::{LN_2, PI, TAU};

use kit::Random;
use proptest::prelude::*;
use stickslip::surface::{self, GaussianFilter, SelfAffine, crop};
use stickslip::{
    Boundary, Error, Field, Grid, HalfSpace, NormalLoad, NormalProblem, NormalSolution,
};

fn noise(grid: Grid, seed: u64, size: f64) -> Field {
    let mut random = Random(seed);
    Field::from_fn(grid, |_, _| random.uniform(-size, size))
}

fn with_holes(field: &Field, seed: u64, share: f64) -> Field {
    let (mut random, mut holed) = (Random(seed), field.clone());
    for z in holed.as_mut_slice() {
        if random.uniform(0.0, 1.0) < share {
            *z = f64::NAN;
        }
    }
    holed
}

#[track_caller]
fn assert_close(found: &Field, expected: &Field, tolerance: f64) {
    for (cell, (a, b)) in found.iter().zip(expected.iter()).enumerate() {
        assert!((a - b).abs() <= tolerance, "cell {cell}: {a} is not {b}");
    }
}

/// Returns the transmitted fraction, in the middle of the surface, of a wave with the given numbers of periods along
/// the sides.
fn transmission(filter: GaussianFilter, grid: Grid, periods: [f64; 2]) -> f64 {
    let sides = [grid.nx() as f64 * grid.dx(), grid.ny() as f64 * grid.dy()];
    let q = [0, 1].map(|axis| TAU * periods[axis] / sides[axis]);
    let wave = Field::from_fn(grid, |x, y| (q[0] * x + q[1] * y).cos());
    let filtered = filter.apply(&wave).unwrap();
    // The amplitude is a least-squares fit over the middle half.
    let middle = |field: &Field| {
        let range = |cells: usize| match cells {
            1 => 0..1,
            cells => cells / 4..3 * cells / 4,
        };
        crop(field, range(grid.nx()), range(grid.ny())).unwrap()
    };
    let (left, wave) = (middle(filtered.heights()), middle(&wave));
    let product = |a: &Field| a.iter().zip(wave.iter()).map(|(a, b)| a * b).sum::<f64>();
    product(&left) / product(&wave)
}

#[test]
fn filter_transmits_half_of_a_wave_at_nesting_index() {
    // Covers wavelengths relative to the side, numbers of periods along x and y, and both types of filters.
    let grid = Grid::new(96, 120, 1.0, 0.8).unwrap();
    let side: f64 = 96.0;
    for periods in [
        [3.0, 0.0],
        [0.0, 5.0],
        [3.0, 4.0],
        [12.0, 0.0],
        [9.0, -12.0],
        [0.0, 30.0],
    ] {
        let length = side / f64::hypot(periods[0], periods[1]);
        for (factor, passed) in [(1.0, 0.5), (2.0, 0.0625), (0.5, 0.5f64.powf(0.25))] {
            if factor * length < 2.0 {
                continue;
            }
            let [s, l] = [GaussianFilter::s, GaussianFilter::l].map(|new| new(factor * length));
            let found = transmission(s.periodic(), grid, periods);
            assert!(
                (found - passed).abs() < 1e-13,
                "{periods:?} {factor}: {found}"
            );
            let found = transmission(l.periodic(), grid, periods);
            assert!(
                (found - 1.0 + passed).abs() < 1e-13,
                "{periods:?} {factor}: {found}"
            );
            // The middle of a non-periodic surface has the same transmission, whether or not the wave fits the sides.
            if factor * length < 0.4 * side {
                let periods = periods.map(|count| 0.97 * count);
                let filter = GaussianFilter::s(factor * length / 0.97);
                let found = transmission(filter, grid, periods);
                assert!(
                    (found - passed).abs() < 1e-3,
                    "{periods:?} {factor}: {found}"
                );
            }
        }
    }
}

#[test]
fn filter_of_profiles_acts_along_one_axis() {
    let line = Grid::new(200, 1, 0.5, 3.0).unwrap();
    for index in [4.0, 10.0] {
        let found = transmission(
            GaussianFilter::s(index).periodic(),
            line,
            [100.0 / index, 0.0],
        );
        assert!((found - 0.5).abs() < 1e-13);
    }
    let grid = Grid::new(64, 48, 1.0, 1.0).unwrap();
    let field = with_holes(&noise(grid, 5, 1.0), 6, 0.1);
    let rows = GaussianFilter::s(9.0).along_x().apply(&field).unwrap();
    for iy in [0, 17, 47] {
        let row = crop(&field, 0..64, iy..iy + 1).unwrap();
        let alone = GaussianFilter::s(9.0).apply(&row).unwrap();
        let of_rows = crop(rows.heights(), 0..64, iy..iy + 1).unwrap();
        for (a, b) in alone.heights().iter().zip(of_rows.iter()) {
            assert!(a.is_nan() && b.is_nan() || (a - b).abs() < 1e-13);
        }
    }
    // Filtering along y equals filtering the transposed surface along x.
    let turned = |field: &Field| {
        let grid = Grid::new(48, 64, 1.0, 1.0).unwrap();
        Field::from_indices(grid, |ix, iy| field[(iy, ix)])
    };
    let field = noise(grid, 8, 1.0);
    let columns = GaussianFilter::l(7.0).along_y().apply(&field).unwrap();
    let rows = GaussianFilter::l(7.0)
        .along_x()
        .apply(&turned(&field))
        .unwrap();
    assert_close(&turned(columns.heights()), rows.heights(), 1e-13);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(8, 24)))]

    /// The filtered surface and the removed parts sum to the original, and missing heights stay missing. The choice of
    /// the datum and of the unit has no other effect.
    #[test]
    fn filter_parts_sum_to_the_surface(
        [nx, ny] in [1usize..50, 2usize..50], seed in any::<u64>(), share in 0.0..0.6,
        indices in [0.0f64..1.0, 0.0f64..1.0], kind in 0usize..3, axis in 0usize..3, is_periodic: bool,
    ) {
        let grid = Grid::new(nx, ny, 0.5, 0.5).unwrap();
        let side = 0.5 * if nx > 1 { nx.min(ny) } else { ny } as f64;
        prop_assume!(side >= 1.0);
        let at = |part: f64| 1.0 + part * (side - 1.0);
        let [s, l] = [indices[0].min(indices[1]), indices[0].max(indices[1])].map(at);
        let filter = [GaussianFilter::s(s), GaussianFilter::l(l), GaussianFilter::sl(s, l)][kind];
        let filter = [filter, filter.along_x(), filter.along_y()][axis];
        let filter = if is_periodic { filter.periodic() } else { filter };
        let surface = with_holes(&noise(grid, seed, 1.0), seed ^ 1, share);
        prop_assume!(surface.iter().any(|z| !z.is_nan()));
        let filtered = filter.apply(&surface).unwrap();
        prop_assert_eq!(filtered.short_waves().is_some(), kind != 1);
        prop_assert_eq!(filtered.long_waves().is_some(), kind != 0);
        let parts = [Some(filtered.heights()), filtered.short_waves(), filtered.long_waves()];
        for (cell, &z) in surface.iter().enumerate() {
            let sum: f64 = parts.iter().flatten().map(|part| part.as_slice()[cell]).sum();
            prop_assert!(z.is_nan() && sum.is_nan() || (sum - z).abs() < 1e-12);
        }
        let moved = filter.apply(&surface.map(|z| 4.0 + 0.25 * z)).unwrap();
        let datum = if kind == 0 { 4.0 } else { 0.0 };
        for (a, b) in moved.heights().iter().zip(filtered.heights().iter()) {
            prop_assert!(b.is_nan() || (a - datum - 0.25 * b).abs() < 1e-12);
        }
        // A flat surface remains flat, regardless of missing heights.
        let flat = filter.apply(&surface.map(|z| 0.0 * z + 3.0)).unwrap();
        let expected = if kind == 0 { 3.0 } else { 0.0 };
        prop_assert!(flat.heights().iter().all(|z| z.is_nan() || (z - expected).abs() == 0.0));
    }
}

/// Compares the filtered heights with the direct sum over the available heights, which uses the weights of the standard.
#[test]
fn filter_weights_match_the_standard() {
    let grid = Grid::new(40, 31, 1.0, 1.25).unwrap();
    let surface = with_holes(&noise(grid, 21, 1.0), 22, 0.3);
    let index = 10.0;
    let filtered = GaussianFilter::s(index).apply(&surface).unwrap();
    let alpha = (LN_2 / PI).sqrt();
    for (ix, iy) in [(0, 0), (39, 15), (20, 15), (3, 30), (17, 9), (18, 9)] {
        let [x, y] = grid.position(ix, iy);
        let (mut sum, mut weights) = (0.0, 0.0);
        for (cell, z) in surface.iter().enumerate().filter(|(_, z)| !z.is_nan()) {
            let [u, v] = grid.position(cell % 40, cell / 40);
            let square = ((x - u).powi(2) + (y - v).powi(2)) / (alpha * index).powi(2);
            let weight = (-PI * square).exp();
            (sum, weights) = (sum + weight * z, weights + weight);
        }
        let found = filtered.heights()[(ix, iy)];
        let is_missing = surface[(ix, iy)].is_nan();
        assert!(is_missing && found.is_nan() || (found - sum / weights).abs() < 1e-5);
    }
}

/// surfalize truncates the weights at four standard deviations, 0.75 nesting indices, which neglects 6e-5 of the
/// weights per axis.
#[test]
fn filter_matches_surfalize() {
    let text = include_str!("../data/surface/filtered.csv");
    let mut cases: BTreeMap<&str, Vec<Vec<&str>>> = BTreeMap::new();
    for line in text.lines().skip(1) {
        let words: Vec<&str> = line.split(',').collect();
        cases.entry(words[0]).or_default().push(words);
    }
    assert_eq!(cases.len(), 5);
    for (case, rows) in cases {
        let number = |word: &str| word.parse::<f64>().unwrap();
        let [dx, dy, index] = [1, 2, 3].map(|column| number(rows[0][column]));
        let (left, edges) = (rows[0][4], rows[0][5]);
        let grid = Grid::new(48, 36, dx, dy).unwrap();
        let case: usize = case.parse().unwrap();
        let surface = Field::from_indices(grid, |ix, iy| {
            let scatter = (7 * ix * ix + 13 * iy * iy + 5 * ix * iy + 3 * case * ix) % 17;
            let waves = 2.0 * ix as f64 / 48.0 + (case + 1) as f64 * iy as f64 / 36.0;
            (TAU * waves).sin() + scatter as f64 / 17.0
        });
        let filter = match left {
            "lowpass" => GaussianFilter::s(index),
            _ => GaussianFilter::l(index),
        };
        let filter = if edges == "wrap" {
            filter.periodic()
        } else {
            filter
        };
        let filtered = filter.apply(&surface).unwrap();
        // Points near the edges are excluded, because surfalize mirrors the surface at the edges.
        let margin = |side: f64| {
            if edges == "wrap" {
                0.0
            } else {
                0.75 * index / side + 1.0
            }
        };
        let mut compared = 0;
        for row in rows {
            let [ix, iy] = [6, 7].map(|column| row[column].parse::<usize>().unwrap());
            let is_inside = |i: usize, cells: f64, side: f64| {
                i as f64 >= margin(side) && i as f64 <= cells - 1.0 - margin(side)
            };
            if is_inside(ix, 48.0, dx) && is_inside(iy, 36.0, dy) {
                let difference = filtered.heights()[(ix, iy)] - number(row[8]);
                assert!(
                    difference.abs() < 1e-4,
                    "case {case} ({ix}, {iy}): {difference:e}"
                );
                compared += 1;
            }
        }
        assert!(compared > 15, "case {case}: {compared}");
    }
}

#[test]
fn filter_edge_effect_reaches_half_an_index() {
    let grid = Grid::new(120, 90, 1.0, 1.0).unwrap();
    let rough = SelfAffine::with_rms_height(1.0)
        .roll_off_wavelength(40.0)
        .seed(3);
    let large = rough
        .generate(Grid::new(180, 150, 1.0, 1.0).unwrap())
        .unwrap();
    let cut = |field: &Field| crop(field, 30..150, 30..120).unwrap();
    let filter = GaussianFilter::l(24.0);
    let whole = filter.apply(large.heights()).unwrap();
    let part = filter.apply(&cut(large.heights())).unwrap();
    let difference = cut(whole.heights()).minus(part.heights()).unwrap();
    let [columns, rows] = filter.valid_range(grid);
    assert_eq!([columns.clone(), rows.clone()], [12..108, 12..78]);
    let inside = crop(&difference, columns, rows).unwrap();
    let largest = |field: &Field| field.max().max(-field.min());
    assert!(largest(&inside) < 0.01 && largest(&difference) > 0.1);
    assert_eq!(filter.periodic().valid_range(grid), [0..120, 0..90]);
    assert_eq!(filter.along_y().valid_range(grid), [0..120, 12..78]);
    let wide = GaussianFilter::s(500.0).valid_range(grid);
    assert!(wide.iter().all(std::ops::Range::is_empty));
}

#[test]
fn filters_with_invalid_indices_are_rejected() {
    let grid = Grid::new(40, 30, 0.5, 1.0).unwrap();
    let surface = noise(grid, 1, 1.0);
    let size = |filter: GaussianFilter| {
        let filtered = filter.apply(&surface)?;
        Ok(filtered.heights().max())
    };
    for (quantity, make) in [
        (
            "nesting index of the S",
            GaussianFilter::s as fn(f64) -> GaussianFilter,
        ),
        ("nesting index of the L", GaussianFilter::l),
    ] {
        for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            kit::assert_refused! {
                size(make(value)) => Error::NotPositive { quantity: q, .. } if q.starts_with(quantity),
            }
        }
        // The smallest index is two cells of size 1 along y. Cells are half as long along x. The longer side of the
        // grid is 30, and the shorter side is 20.
        kit::assert_refused! {
            size(make(1.9)) => Error::BelowMinimum { value: 1.9, least: 2.0, .. },
            size(make(20.1)) => Error::BelowMinimum { value: 20.0, least: 20.1, .. },
            size(make(0.9).along_x()) => Error::BelowMinimum { least: 1.0, .. },
        }
        for filter in [
            make(2.0),
            make(20.0),
            make(1.0).along_x(),
            make(30.0).along_y(),
        ] {
            size(filter).unwrap();
        }
    }
    kit::assert_refused! { size(GaussianFilter::sl(8.0, 5.0)) => Error::BelowMinimum { value: 5.0, least: 8.0, .. } }
    let filter = GaussianFilter::s(4.0);
    let mut infinite = surface.clone();
    infinite.as_mut_slice()[17] = f64::NEG_INFINITY;
    kit::assert_refused! { filter.apply(&infinite) => Error::Sample { index: 17, .. } }
    let missing = Field::constant(grid, f64::NAN);
    kit::assert_refused! { filter.apply(&missing) => Error::Undetermined { known: 0, .. } }
    let tall = surface.map(|z| 1.7e308 * z.signum());
    assert!(matches!(filter.apply(&tall), Err(Error::NotFinite { .. })));
    let small = filter.apply(&surface.map(|z| 1e-300 * z)).unwrap();
    let expected = filter.apply(&surface).unwrap();
    assert_close(&small.heights().scaled(1e300), expected.heights(), 1e-13);
}

/// Returns the number of spots, the largest pressure and the area of a contact.
fn contact_quantities(contact: &NormalSolution) -> [f64; 3] {
    [
        contact.spots().unwrap().as_slice().len() as f64,
        contact.pressure().max(),
        contact.contact_area_corrected(),
    ]
}

/// Both surfaces are measured with noise, and pressed either unchanged or filtered.
#[test]
fn filter_removes_noise_from_a_contact() {
    let grid = kit::square(128, 128.0);
    let pair = kit::alike(1.0, 0.3);
    let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
    let bodies = &bodies;
    let clean = [1, 2].map(|seed| {
        let rough = SelfAffine::with_rms_height(0.2).roll_off_wavelength(64.0);
        let rough = rough
            .cut_off_wavelength(16.0)
            .seed(seed)
            .generate(grid)
            .unwrap();
        rough.into_heights()
    });
    let noisy = [0, 1].map(|body| (&clean[body] + &noise(grid, body as u64, 0.01)).unwrap());
    let press = |surfaces: &[Field; 2]| {
        let gap = surface::gap_between(&surfaces[0], &surfaces[1]).unwrap();
        let force = 0.002 * pair.contact_modulus() * grid.area();
        let problem = NormalProblem::builder(bodies, &gap, NormalLoad::Force(force));
        contact_quantities(&kit::solve(problem.tolerance(1e-6)))
    };
    // The index is less than a third of the shortest wavelength, so 93 % of the amplitude of this wave is transmitted.
    let filter = GaussianFilter::s(5.0).periodic();
    let filtered = |surfaces: &[Field; 2]| {
        surfaces
            .each_ref()
            .map(|z| filter.apply(z).unwrap().into_heights())
    };
    let ratios = |of: [f64; 3], to: [f64; 3]| [0, 1, 2].map(|k| of[k] / to[k]);
    let exact = press(&clean);
    let [spots, pressure, area] = ratios(press(&noisy), exact);
    assert!(
        spots > 5.0 && pressure > 1.4 && area < 0.9,
        "{spots} {pressure} {area}"
    );
    let [spots, pressure, area] = ratios(press(&filtered(&noisy)), exact);
    let is_back = (spots - 1.0).abs() < 1e-12 && (pressure - 1.0).abs() < 0.02;
    assert!(
        is_back && (area - 1.0).abs() < 0.04,
        "{spots} {pressure} {area}"
    );
    let [_, _, area] = ratios(press(&filtered(&noisy)), press(&filtered(&clean)));
    assert!((area - 1.0).abs() < 0.005, "{area}");
}
