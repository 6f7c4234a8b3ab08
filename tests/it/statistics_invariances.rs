//! Invariances of the parameters of any surface when it is moved, scaled, rotated or mirrored.

use kit::Random;
use proptest::prelude::*;
use stickslip::surface::{PowerSpectrum, Statistics, inverted, mirror_x};
use stickslip::{Field, Grid};

/// Generates skewed heights on odd, even and slender grids.
fn surface() -> impl Strategy<Value = Field> {
    (
        2..24_usize,
        1..24_usize,
        0.2..5.0_f64,
        1..5_i32,
        any::<u64>(),
    )
        .prop_map(|(nx, ny, dy, power, seed)| {
            let mut random = Random(seed);
            let grid = Grid::new(nx, ny, 1.0, dy).unwrap();
            Field::from_fn(grid, |_, _| random.uniform(-1.0, 1.0).powi(power))
        })
}

fn mapped(field: &Field, f: impl Fn(f64) -> f64) -> Field {
    let samples = field.as_slice().iter().map(|&z| f(z)).collect();
    Field::from_vec(field.grid(), samples).unwrap()
}

/// Returns the field with its axes exchanged.
fn transposed(field: &Field) -> Field {
    let grid = field.grid();
    let turned = Grid::new(grid.ny(), grid.nx(), grid.dy(), grid.dx()).unwrap();
    let samples = (0..grid.nx())
        .flat_map(|ix| (0..grid.ny()).map(move |iy| (ix, iy)))
        .map(|(ix, iy)| field.get(ix, iy).unwrap())
        .collect();
    Field::from_vec(turned, samples).unwrap()
}

/// Returns the parameters that are lengths, and the parameters without a unit.
fn parameters(field: &Field) -> ([f64; 4], [f64; 6]) {
    let found = Statistics::of(field).unwrap();
    let [along_x, along_y] = found.profile_rms_slope();
    (
        [
            found.arithmetic_mean_height(),
            found.rms_height(),
            found.highest_peak(),
            found.deepest_valley(),
        ],
        [
            found.skewness(),
            found.kurtosis(),
            along_x,
            along_y,
            found.spectral_rms_slope(),
            found.developed_area_ratio(),
        ],
    )
}

#[track_caller]
fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
    let largest = expected.iter().fold(1.0, |a: f64, b| a.max(b.abs()));
    for (a, b) in found.iter().zip(expected) {
        assert!(
            (a - b).abs() <= tolerance * largest,
            "{found:?} is not {expected:?}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(43, 128)))]

    #[test]
    fn shift_changes_mean_only(heights in surface(), shift in -100.0..100.0_f64) {
        let raised = mapped(&heights, |z| z + shift);
        let [found, expected] = [&raised, &heights].map(parameters);
        assert_close(&found.0, &expected.0, 1e-12);
        assert_close(&found.1, &expected.1, 1e-10);
        let [raised, level] = [&raised, &heights].map(|z| Statistics::of(z).unwrap().mean_height());
        prop_assert!((raised - level - shift).abs() < 1e-13 * (1.0 + shift.abs()));
    }

    #[test]
    fn lengths_scale_with_unit(heights in surface(), exponent in -150..100_i32) {
        let unit = 10_f64.powi(exponent);
        let grid = heights.grid();
        let scaled = Grid::new(grid.nx(), grid.ny(), unit * grid.dx(), unit * grid.dy()).unwrap();
        let scaled = Field::from_vec(scaled, mapped(&heights, |z| unit * z).into_vec()).unwrap();
        let (found, expected) = (parameters(&scaled), parameters(&heights));
        assert_close(&found.0.map(|length| length / unit), &expected.0, 1e-13);
        assert_close(&found.1, &expected.1, 1e-12);
    }

    #[test]
    fn heights_and_slopes_scale_with_heights(heights in surface(), factor in 0.01..100.0_f64) {
        let found = Statistics::of(&mapped(&heights, |z| factor * z)).unwrap();
        let expected = Statistics::of(&heights).unwrap();
        let pairs = [
            (found.rms_height(), expected.rms_height()),
            (found.finite_difference_rms_slope(), expected.finite_difference_rms_slope()),
            (found.spectral_rms_slope(), expected.spectral_rms_slope()),
        ];
        for (found, expected) in pairs {
            prop_assert!((found - factor * expected).abs() < 1e-13 * found);
        }
    }

    #[test]
    fn inversion_exchanges_peaks_and_valleys(heights in surface()) {
        let found = Statistics::of(&inverted(&heights)).unwrap();
        let expected = Statistics::of(&heights).unwrap();
        assert_close(
            &[-found.skewness(), found.kurtosis(), found.deepest_valley(), found.highest_peak()],
            &[
                expected.skewness(),
                expected.kurtosis(),
                expected.highest_peak(),
                expected.deepest_valley(),
            ],
            1e-13,
        );
    }

    #[test]
    fn parameters_are_independent_of_mirroring_and_axes(heights in surface()) {
        let expected = parameters(&heights);
        let found = parameters(&mirror_x(&heights));
        assert_close(&found.0, &expected.0, 1e-13);
        assert_close(&found.1, &expected.1, 1e-12);
        let (lengths, mut numbers) = parameters(&transposed(&heights));
        numbers.swap(2, 3);
        assert_close(&lengths, &expected.0, 1e-13);
        assert_close(&numbers, &expected.1, 1e-12);
    }

    #[test]
    fn parameters_fulfil_inequalities(heights in surface()) {
        let found = Statistics::of(&heights).unwrap();
        prop_assert!(found.kurtosis() >= found.skewness().powi(2) + 1.0 - 1e-12);
        prop_assert!(found.arithmetic_mean_height() <= found.rms_height() * (1.0 + 1e-14));
        prop_assert!(found.rms_height() <= found.highest_peak().max(found.deepest_valley()));
        // Cauchy's inequality gives m_2^2 <= m_0 m_4 / (3/2).
        let spectrum = PowerSpectrum::of(&heights).unwrap();
        prop_assert!(spectrum.nayak_parameter() >= 1.5 - 1e-12);
        // The term sqrt(1 + s^2) - 1 increases with the slope no faster than its square.
        let gentle = Statistics::of(&mapped(&heights, |z| 1e-4 * z)).unwrap();
        prop_assert!(found.developed_area_ratio() <= 1.0001e8 * gentle.developed_area_ratio());
        prop_assert!(gentle.developed_area_ratio() <= 1.0001e-4 * found.developed_area_ratio());
    }

    #[test]
    fn spectrum_and_statistics_agree(heights in surface()) {
        let statistics = Statistics::of(&heights).unwrap();
        let [m0, m2, _] = PowerSpectrum::of(&heights).unwrap().moments();
        let close = |a: f64, b: f64| (a - b).abs() < 1e-13 * b;
        prop_assert!(close(m0.sqrt(), statistics.rms_height()));
        prop_assert!(close((2.0 * m2).sqrt(), statistics.spectral_rms_slope()));
    }
}
