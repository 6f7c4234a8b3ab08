//! Preparation of measured surfaces. Known heights are unchanged when missing heights are filled, when a surface is
//! cropped or resampled, and when the gap between two surfaces is computed.

use kit::Random;
use proptest::prelude::*;
use stickslip::surface::{
    crop, fill_missing, gap_between, gap_from_heights, inverted, mirror_x, resample,
};
use stickslip::{Error, Field, Grid};

fn grid(nx: usize, ny: usize, dx: f64, dy: f64) -> Grid {
    Grid::new(nx, ny, dx, dy).unwrap()
}

/// Returns the field without the samples where `is_missing(ix, iy)`.
fn with_holes(field: &Field, mut is_missing: impl FnMut(usize, usize) -> bool) -> Field {
    let nx = field.grid().nx();
    let mut holed = field.clone();
    for (cell, z) in holed.as_mut_slice().iter_mut().enumerate() {
        if is_missing(cell % nx, cell / nx) {
            *z = f64::NAN;
        }
    }
    holed
}

#[track_caller]
fn assert_close(found: &Field, expected: &Field, tolerance: f64) {
    assert_eq!(found.grid(), expected.grid());
    for (cell, (a, b)) in found.as_slice().iter().zip(expected.as_slice()).enumerate() {
        assert!((a - b).abs() <= tolerance, "cell {cell}: {a} is not {b}");
    }
}

fn noise(grid: Grid, seed: u64) -> Field {
    let mut random = Random(seed);
    Field::from_fn(grid, |_, _| random.uniform(-1.0, 1.0))
}

#[test]
fn filled_holes_continue_plane() {
    for (nx, ny, dx, dy) in [
        (40, 30, 1.0, 1.0),
        (33, 50, 0.2, 1.3),
        (200, 200, 1e-6, 3e-6),
    ] {
        let grid = grid(nx, ny, dx, dy);
        let plane = Field::from_fn(grid, |x, y| 5.0 + 0.7 * x / dx - 0.3 * y / dy);
        let range = plane.max() - plane.min();
        let mut random = Random(7);
        let holed = with_holes(&plane, |ix, iy| {
            let is_at_edge = ix == 0 || iy == 0 || ix + 1 == nx || iy + 1 == ny;
            let is_in_disc = (ix as f64 / nx as f64 - 0.5).hypot(iy as f64 / ny as f64 - 0.5) < 0.4;
            !is_at_edge && (is_in_disc || random.uniform(0.0, 1.0) < 0.3)
        });
        let missing = holed.as_slice().iter().filter(|z| z.is_nan()).count();
        let filled = fill_missing(&holed).unwrap();
        assert_eq!(filled.filled_cells(), missing);
        assert_close(filled.heights(), &plane, 1e-13 * range);
    }
}

#[test]
fn heights_of_any_magnitude_are_filled() {
    let plane = |unit: f64| Field::from_fn(grid(30, 20, 1.0, 1.0), |x, y| unit * (x - 0.3 * y));
    for unit in [1e-300, 1e-160, 1e160, 1e300] {
        let holed = with_holes(&plane(unit), |ix, iy| {
            (5..25).contains(&ix) && (5..15).contains(&iy)
        });
        let filled = fill_missing(&holed).unwrap();
        assert_close(filled.heights(), &plane(unit), 1e-12 * unit);
    }
}

#[test]
fn filled_heights_are_harmonic_and_known_heights_unchanged() {
    let grid = grid(31, 24, 1.0, 0.4);
    let measured = noise(grid, 3);
    let mut random = Random(11);
    let holed = with_holes(&measured, |ix, _| ix < 4 || random.uniform(0.0, 1.0) < 0.5);
    let filled = fill_missing(&holed).unwrap().into_heights();
    let at = |ix: usize, iy: usize| filled.get(ix, iy);
    for (cell, (before, after)) in holed.as_slice().iter().zip(filled.as_slice()).enumerate() {
        if !before.is_nan() {
            assert_eq!(before, after);
            continue;
        }
        let (ix, iy) = (cell % 31, cell / 31);
        let along_x = [ix.checked_sub(1).and_then(|ix| at(ix, iy)), at(ix + 1, iy)];
        let along_y = [iy.checked_sub(1).and_then(|iy| at(ix, iy)), at(ix, iy + 1)];
        let sum = |side: f64, neighbours: [Option<f64>; 2]| -> f64 {
            let differences = neighbours.into_iter().flatten().map(|z| z - after);
            differences.sum::<f64>() / (side * side)
        };
        let laplacian = sum(1.0, along_x) + sum(0.4, along_y);
        assert!(laplacian.abs() < 1e-12, "cell {cell}: {laplacian:e}");
    }
    assert!(filled.max() <= holed.max() && filled.min() >= holed.min());
}

#[test]
fn hole_at_edge_takes_height_of_its_rim() {
    let grid = grid(8, 5, 1.0, 1.0);
    let measured = Field::from_fn(grid, |_, y| 2.0 + y);
    let filled = fill_missing(&with_holes(&measured, |ix, _| ix < 3)).unwrap();
    assert_eq!(filled.filled_cells(), 15);
    let [left, right] = [0, 1].map(|ix| filled.heights().get(ix, 2).unwrap());
    assert!((left - right).abs() < 1e-14 && (left - 2.0).abs() < 1e-14);
    let single = fill_missing(&with_holes(&measured, |ix, iy| (ix, iy) != (4, 3))).unwrap();
    assert_close(single.heights(), &Field::constant(grid, 3.0), 1e-15);
}

#[test]
fn profiles_are_filled_along_their_axis() {
    let line = Field::from_fn(grid(1, 30, 2.0, 0.1), |_, y| 4.0 - 3.0 * y);
    let filled = fill_missing(&with_holes(&line, |_, iy| iy % 7 > 1 && iy < 28)).unwrap();
    assert_close(filled.heights(), &line, 1e-14);
}

#[test]
fn complete_surface_is_unchanged_and_empty_surface_is_rejected() {
    let measured = noise(grid(9, 4, 1.0, 1.0), 5);
    let filled = fill_missing(&measured).unwrap();
    assert_eq!((filled.heights(), filled.filled_cells()), (&measured, 0));
    let empty = Field::constant(grid(9, 4, 1.0, 1.0), f64::NAN);
    kit::assert_refused! { fill_missing(&empty) => Error::Undetermined { unknowns: 36, known: 0, .. } }
    let mut infinite = measured;
    infinite.as_mut_slice()[13] = f64::NEG_INFINITY;
    kit::assert_refused! { fill_missing(&infinite) => Error::Sample { index: 13, .. } }
}

#[test]
fn cropped_surface_keeps_heights() {
    let measured = with_holes(&noise(grid(9, 7, 0.5, 2.0), 1), |ix, iy| ix == iy);
    let part = crop(&measured, 2..9, 3..4).unwrap();
    assert_eq!(part.grid(), grid(7, 1, 0.5, 2.0));
    for ix in 0..7 {
        let [a, b] = [part.get(ix, 0), measured.get(ix + 2, 3)].map(Option::unwrap);
        assert_eq!(a.to_bits(), b.to_bits());
    }
    #[expect(clippy::reversed_empty_ranges, reason = "it must be rejected")]
    let ranges = [
        (3..3, 0..7),
        (5..3, 0..7),
        (0..10, 0..7),
        (0..9, 7..8),
        (0..9, 0..usize::MAX),
    ];
    for (columns, rows) in ranges {
        let error = crop(&measured, columns.clone(), rows.clone()).err();
        let Some(Error::Range {
            quantity,
            start,
            end,
            count,
        }) = error
        else {
            panic!("{columns:?} x {rows:?} must be rejected");
        };
        let is_columns = quantity == "columns";
        let (range, expected) = if is_columns { (columns, 9) } else { (rows, 7) };
        assert_eq!((start, end, count), (range.start, range.end, expected));
    }
}

#[test]
fn resampling_is_exact_for_cubics_and_on_the_same_grid() {
    let cubic = |x: f64, y: f64| 1.0 + x - 2.0 * y + x * x * y - 0.5 * x * x * x * y * y * y;
    let source = Field::from_fn(grid(11, 8, 0.2, 0.3), cubic);
    for target in [
        grid(22, 16, 0.1, 0.15),
        grid(7, 5, 0.31, 0.45),
        grid(1, 40, 2.0, 0.06),
    ] {
        let expected = Field::from_fn(target, cubic);
        assert_close(&resample(&source, target).unwrap(), &expected, 1e-14);
    }
    let measured = noise(grid(13, 9, 0.7, 0.9), 2);
    let again = resample(&measured, measured.grid()).unwrap();
    assert_close(&again, &measured, 1e-13);
    for [nx, ny] in [[1, 6], [2, 2], [3, 1]] {
        let source = Field::from_fn(grid(nx, ny, 1.0, 1.0), |x, y| 1.0 + x + y);
        let fine = grid(3 * nx, 3 * ny, 1.0 / 3.0, 1.0 / 3.0);
        // An axis with a single sample has no slope.
        let expected = Field::from_fn(fine, |x, y| {
            1.0 + if nx > 1 { x } else { 0.0 } + if ny > 1 { y } else { 0.0 }
        });
        assert_close(&resample(&source, fine).unwrap(), &expected, 1e-14);
    }
}

#[test]
fn resampling_is_of_fourth_order() {
    let smooth = |x: f64, y: f64| (3.0 * x + 0.4).sin() * (2.0 * y - 0.3).cos();
    let target = grid(37, 41, 0.05, 0.045);
    let expected = Field::from_fn(target, smooth);
    let errors = [16_u16, 32, 64, 128].map(|n| {
        let cell = 2.0 / f64::from(n);
        let source = Field::from_fn(grid(n.into(), n.into(), cell, cell), smooth);
        let found = resample(&source, target).unwrap();
        let pairs = found.as_slice().iter().zip(expected.as_slice());
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    });
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((3.5..4.5).contains(&order), "{errors:?}");
    }
    assert!(errors[3] < 3e-7, "{errors:?}");
}

/// The memory in use is proportional to the result, not to the columns of the source times the rows of the result.
#[test]
fn long_profile_is_resampled_across_in_little_memory() {
    let along_y = Field::constant(grid(1, 1_000_000, 1.0, 1e-6), 3.0);
    let along_x = resample(&along_y, grid(1_000_000, 1, 1e-6, 1e-6)).unwrap();
    assert_close(&along_x, &Field::constant(along_x.grid(), 3.0), 1e-14);
}

#[test]
fn resampling_does_not_extrapolate() {
    let source = noise(grid(10, 6, 1.0, 2.0), 9);
    // The outermost centres may be on the edge of the source grid, half a cell beyond its samples.
    assert!(resample(&source, grid(11, 7, 1.0, 2.0)).is_ok());
    let error = resample(&source, grid(11, 6, 1.01, 2.0)).err();
    let Some(Error::BeyondSamples { axis, reach, limit }) = error else {
        panic!("the grid exceeds the source");
    };
    assert_eq!((axis, limit), ("x", 5.0));
    assert!((reach - 5.05).abs() < 1e-12);
    kit::assert_refused! { resample(&source, grid(10, 40, 1.0, 2.0)) => Error::BeyondSamples { axis: "y", .. } }
    let holed = with_holes(&source, |ix, iy| (ix, iy) == (4, 2));
    kit::assert_refused! { resample(&holed, source.grid()) => Error::Sample { index: 24, .. } }
}

#[test]
fn gap_requires_complete_surfaces_on_same_grid() {
    let lower = noise(grid(6, 4, 1.0, 1.0), 1);
    let upper = noise(grid(6, 4, 1.0, 1.1), 2);
    assert!(matches!(
        gap_between(&upper, &lower),
        Err(Error::GridMismatch {
            quantity: "upper surface",
            ..
        })
    ));
    let holed = with_holes(&lower, |ix, iy| (ix, iy) == (5, 1));
    for error in [
        gap_from_heights(&holed).err(),
        gap_between(&holed, &lower).err(),
        gap_between(&lower, &holed).err(),
    ] {
        assert!(matches!(error, Some(Error::Sample { index: 11, .. })));
    }
}

#[test]
fn cells_too_slender_to_couple_are_rejected() {
    let plane = Field::from_fn(grid(40, 40, 1.0, 1e8), |x, _| x);
    let column = with_holes(&plane, |ix, _| ix == 20);
    assert_close(fill_missing(&column).unwrap().heights(), &plane, 1e-12);
    // Known heights couple to this hole along y alone, with 1e-16 of the weight along x.
    let row = with_holes(&plane, |_, iy| (10..20).contains(&iy));
    kit::assert_refused! { fill_missing(&row) => Error::NotConverged(_) }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(22, 64)))]

    /// Peaks of both bodies reduce the gap, whose minimum is zero. The gap does not depend on the order of the bodies
    /// or on the datum.
    #[test]
    fn gap_is_independent_of_order_and_datum(nx in 1..12_usize, ny in 1..12_usize, seed: u64, datum in -10.0..10.0_f64) {
        let grid = grid(nx, ny, 1.0, 0.5);
        let (upper, lower) = (noise(grid, seed), noise(grid, seed ^ 1));
        let gap = gap_between(&upper, &lower).unwrap();
        prop_assert_eq!(gap.min(), 0.0);
        prop_assert_eq!(&gap, &gap_between(&lower, &upper).unwrap());
        let mut raised = upper.clone();
        raised.as_mut_slice().iter_mut().for_each(|z| *z += datum);
        assert_close(&gap_between(&raised, &lower).unwrap(), &gap, 1e-14);
        let plane = Field::constant(grid, datum);
        assert_close(&gap_between(&plane, &lower).unwrap(), &gap_from_heights(&lower).unwrap(), 1e-14);
        // A surface on its own replica has zero gap everywhere.
        prop_assert_eq!(gap_between(&inverted(&upper), &upper).unwrap().max(), 0.0);
        prop_assert_eq!(&mirror_x(&mirror_x(&upper)), &upper);
        prop_assert_eq!(mirror_x(&upper).get(0, ny - 1), upper.get(nx - 1, ny - 1));
        // Mirroring both surfaces mirrors the gap.
        let turned = gap_between(&mirror_x(&upper), &mirror_x(&lower)).unwrap();
        prop_assert_eq!(turned, mirror_x(&gap));
    }

    /// The filled heights follow changes of datum and unit, and lie between the known heights.
    #[test]
    fn filling_is_independent_of_datum_and_unit(
        nx in 1..20_usize,
        ny in 1..20_usize,
        aspect in 0.1..10.0_f64,
        share in 0.0..0.95_f64,
        seed: u64,
    ) {
        let measured = noise(grid(nx, ny, 1.0, aspect), seed);
        let mut random = Random(seed ^ 2);
        let kept = random.integer(0, nx * ny - 1);
        let holed = with_holes(&measured, |ix, iy| {
            iy * nx + ix != kept && random.uniform(0.0, 1.0) < share
        });
        let filled = fill_missing(&holed).unwrap().into_heights();
        let round_off = 1e-13;
        prop_assert!(filled.max() <= holed.max() + round_off);
        prop_assert!(filled.min() >= holed.min() - round_off);
        let other = |z: f64| 1e-6 * (z + 20.0);
        let mut changed = holed.clone();
        changed.as_mut_slice().iter_mut().for_each(|z| *z = other(*z));
        let mut expected = filled;
        expected.as_mut_slice().iter_mut().for_each(|z| *z = other(*z));
        assert_close(&fill_missing(&changed).unwrap().into_heights(), &expected, 1e-18);
    }
}
