//! A surface is distributed over ranks in slabs. Its parameters and levelled heights are bitwise identical to the
//! results of one process.

use stickslip::ranks::RankFailure;
use stickslip::surface::{self, Form, PowerSpectrum, Statistics};
use stickslip::*;

use crate::distributed_io::{SIZES, bits, height, on_ranks, ranks};
use crate::rank_contacts::assert_rejected_by;

/// Returns all parameters of a surface, and the local levelled heights.
fn characterise(bodies: &HalfSpace, z: impl Fn(f64, f64) -> f64) -> (Vec<f64>, Vec<f64>) {
    let heights = Field::from_fn(bodies.grid(), z);
    let statistics = bodies.statistics(&heights).unwrap();
    let spectrum = bodies.power_spectrum(&heights).unwrap();
    let mut known = vec![
        bodies.max_of(&heights).unwrap(),
        bodies.min_of(&heights).unwrap(),
        bodies.integral_of(&heights).unwrap(),
        bodies.mean_of(&heights).unwrap(),
    ];
    known.extend(numbers_of(&statistics, &spectrum));
    let mut missing = heights;
    let nx = missing.grid().nx();
    for (iy, row) in missing.grid().rows().zip(0..) {
        let left_out = (7 * iy) % (2 * nx);
        if left_out < nx && iy > 0 {
            missing.as_mut_slice()[row * nx + left_out] = f64::NAN;
        }
    }
    let mut cells = Vec::new();
    for form in [Form::Mean, Form::Plane] {
        let levelled = bodies.level(&missing, form).unwrap();
        cells.extend_from_slice(levelled.heights().as_slice());
        cells.extend_from_slice(levelled.form().as_slice());
    }
    (known, cells)
}

fn numbers_of(statistics: &Statistics, spectrum: &PowerSpectrum) -> Vec<f64> {
    let [along_x, along_y] = statistics.profile_rms_slope();
    let mut numbers = vec![
        statistics.mean_height(),
        statistics.arithmetic_mean_height(),
        statistics.rms_height(),
        statistics.skewness(),
        statistics.kurtosis(),
        statistics.highest_peak(),
        statistics.deepest_valley(),
        along_x,
        along_y,
        statistics.developed_area_ratio(),
        statistics.spectral_rms_slope(),
    ];
    numbers.extend(spectrum.moments());
    numbers.extend(spectrum.values());
    numbers.extend(spectrum.wave_numbers());
    numbers.extend(spectrum.modes().iter().map(|modes| *modes as f64));
    numbers
}

/// Joins the local parts of four fields, field by field.
fn joined(parts: &[Vec<f64>]) -> Vec<f64> {
    let field = |index: usize| {
        parts.iter().flat_map(move |part| {
            let cells = part.len() / 4;
            part[index * cells..(index + 1) * cells].iter().copied()
        })
    };
    (0..4).flat_map(field).collect()
}

#[test]
fn surfaces_on_ranks_match_one_process() {
    for [nx, ny] in SIZES {
        let grid = Grid::new(nx, ny, 0.3, 0.2).unwrap();
        let alone = on_ranks(1, grid, |bodies, _| bodies.clone()).remove(0);
        let (known, cells) = characterise(&alone, height);
        let heights = Field::from_fn(grid, height);
        assert_eq!(
            bits(&known[..3]),
            bits(&[heights.max(), heights.min(), heights.integral()])
        );
        let (statistics, spectrum) = (
            Statistics::of(&heights).unwrap(),
            PowerSpectrum::of(&heights).unwrap(),
        );
        assert_eq!(bits(&known[4..]), bits(&numbers_of(&statistics, &spectrum)));
        for &size in ranks() {
            let parts = on_ranks(size, grid, |bodies, _| characterise(bodies, height));
            let (others, parts): (Vec<_>, Vec<_>) = parts.into_iter().unzip();
            for other in others {
                assert_eq!(bits(&other), bits(&known), "{nx} x {ny}, {size} ranks");
            }
            assert_eq!(
                bits(&joined(&parts)),
                bits(&cells),
                "{nx} x {ny}, {size} ranks"
            );
        }
    }
}

#[test]
fn statistics_with_missing_heights_are_identical_on_all_ranks() {
    let grid = Grid::new(40, 30, 0.3, 0.2).unwrap();
    let holed = |bodies: &HalfSpace| {
        let is_missing = |x: f64, y: f64| (3.0 * x + 7.0 * y).sin() > 0.8;
        Field::from_fn(bodies.grid(), |x, y| {
            if is_missing(x, y) {
                f64::NAN
            } else {
                height(x, y)
            }
        })
    };
    let numbers = |bodies: &HalfSpace| {
        let found = bodies.statistics(&holed(bodies)).unwrap();
        let [along_x, along_y] = found.profile_rms_slope();
        let points = found.measured_points() as f64;
        [
            points,
            found.mean_height(),
            found.rms_height(),
            along_x,
            along_y,
            found.developed_area_ratio(),
        ]
    };
    let [alone] = &on_ranks(1, grid, |bodies, _| numbers(bodies))[..] else {
        panic!("one rank has one result");
    };
    assert!(alone[0] < grid.cells() as f64 && alone.iter().all(|number| number.is_finite()));
    for count in [2, 3] {
        for found in on_ranks(count, grid, |bodies, _| numbers(bodies)) {
            assert_eq!(bits(&found), bits(alone));
        }
    }
}

#[test]
fn invalid_surfaces_are_rejected_by_all_ranks() {
    let grid = Grid::new(40, 300, 0.3, 0.2).unwrap();
    let outcomes = on_ranks(3, grid, |bodies, rank| {
        let mut heights = Field::from_fn(bodies.grid(), height);
        let nothing = heights.map(|_| f64::NAN);
        let few = bodies.level(&nothing, Form::Mean).map(drop);
        kit::assert_refused! {
            bodies.level(&heights, Form::Polynomial(2)) => Error::Ranks(RankFailure::UnsupportedOnRanks(_)),
            few => Error::Undetermined { known: 0, .. },
        }
        if rank == 2 {
            heights.as_mut_slice()[5] = f64::INFINITY;
        }
        [
            bodies.statistics(&heights).map(drop),
            bodies.power_spectrum(&heights).map(drop),
            bodies.level(&heights, Form::Plane).map(drop),
        ]
    });
    for place in 0..3 {
        let outcomes: Vec<_> = outcomes.iter().map(|of| of[place].clone()).collect();
        assert_rejected_by(2, &outcomes, |error| {
            matches!(error, Error::Sample { index: 5, .. })
        });
    }
    // A slab without rows is not a surface on its own.
    let empty = on_ranks(7, Grid::new(3, 2, 0.3, 0.2).unwrap(), |bodies, _| {
        let slab = Field::zeros(bodies.grid());
        let outcome = Statistics::of(&slab).map(drop);
        let level = surface::level(&slab, Form::Mean).map(drop);
        if bodies.grid().cells() > 0 {
            return false;
        }
        assert!(matches!(outcome, Err(Error::GridSize { .. })));
        assert!(matches!(level, Err(Error::GridSize { .. })));
        true
    });
    assert!(empty.contains(&true));
}
