//! A self-affine surface attains the requested skewness and kurtosis without any change of its spectrum.

use kit::max_difference;
use kit::waves::waves;
use stickslip::surface::{Amplitudes, SelfAffine};
use stickslip::{Error, Field, Grid};

const SKEWNESSES: [f64; 5] = [-1.0, -0.5, 0.0, 0.5, 1.0];
const KURTOSES: [f64; 6] = [2.5, 3.0, 3.5, 4.0, 5.0, 6.0];

/// Returns the skewness and the kurtosis of the samples.
fn moments(field: &Field) -> [f64; 2] {
    let samples = field.as_slice();
    let count = samples.len() as f64;
    let mean = samples.iter().sum::<f64>() / count;
    let central = |power| samples.iter().map(|z| (z - mean).powi(power)).sum::<f64>() / count;
    let square = central(2);
    [central(3) / square.powf(1.5), central(4) / square.powi(2)]
}

fn wave_amplitudes(field: &Field) -> Vec<f64> {
    waves(field)
        .iter()
        .map(|wave| wave.power().sqrt())
        .collect()
}

/// Returns surfaces with waves over a decade of lengths, with a roll-off plateau and without. Without a plateau a few
/// long waves dominate.
fn spectra() -> [(Grid, SelfAffine); 3] {
    let asked = SelfAffine::with_rms_height(1.0);
    [
        (kit::square(64, 64.0), asked),
        (
            Grid::new(80, 63, 1.0, 1.2).unwrap(),
            asked.cut_off_wavelength(6.0).hurst(0.5),
        ),
        (
            kit::square(96, 96.0),
            asked.roll_off_wavelength(16.0).cut_off_wavelength(4.0),
        ),
    ]
}

#[test]
fn skewness_and_kurtosis_are_attained_with_unchanged_spectrum() {
    for (grid, asked) in spectra() {
        for seed in 0..kit::thorough(1, 2) {
            let asked = asked.seed(seed);
            let plain = asked.generate(grid).unwrap();
            assert_eq!(plain.iterations(), 0);
            let spectrum = wave_amplitudes(plain.heights());
            let step = kit::thorough(2, 1);
            for skewness in SKEWNESSES.into_iter().step_by(step) {
                for kurtosis in KURTOSES.into_iter().step_by(step) {
                    let asked = asked.skewness(skewness).kurtosis(kurtosis);
                    let surface = asked.generate(grid).unwrap();
                    let found = moments(surface.heights());
                    let expected = [skewness, kurtosis];
                    assert!(max_difference(&found, &expected) < 2e-9, "{found:?}");
                    let reported = [surface.skewness(), surface.kurtosis()];
                    assert!(max_difference(&found, &reported) < 1e-12);
                    assert!((surface.rms_height() - 1.0).abs() < 1e-12);
                    assert!((surface.rms_slope() / plain.rms_slope() - 1.0).abs() < 1e-12);
                    let kept = wave_amplitudes(surface.heights());
                    assert!(max_difference(&kept, &spectrum) < 1e-14);
                    assert!((1..80).contains(&surface.iterations()));
                }
            }
        }
    }
}

#[test]
fn cropped_and_gaussian_surfaces_attain_moments() {
    let grid = Grid::new(60, 49, 1.0, 1.2).unwrap();
    let asked = SelfAffine::with_rms_slope(0.1).cut_off_wavelength(4.0);
    for seed in 0..3 {
        let asked = asked.seed(seed).skewness(-0.7).kurtosis(4.5);
        let surface = asked.cropped().generate(grid).unwrap();
        assert!(max_difference(&moments(surface.heights()), &[-0.7, 4.5]) < 2e-9);
        assert!((surface.rms_slope() / 0.1 - 1.0).abs() < 1e-12);
        let surface = asked
            .amplitudes(Amplitudes::Gaussian)
            .generate(grid)
            .unwrap();
        assert!(max_difference(&moments(surface.heights()), &[-0.7, 4.5]) < 2e-9);
    }
}

#[test]
fn moment_not_requested_is_gaussian() {
    let asked = SelfAffine::with_rms_height(1.0);
    for (asked, expected) in [
        (asked.skewness(0.6), [0.6, 3.0]),
        (asked.kurtosis(3.8), [0.0, 3.8]),
    ] {
        let surface = asked.generate(kit::square(48, 1.0)).unwrap();
        assert!(max_difference(&moments(surface.heights()), &expected) < 2e-9);
    }
}

/// Most cells follow the distribution, so the moments do not depend on a few extreme cells. The lognormal distribution
/// `exp(w g)` with w = 0.31436 has skewness 1. For this skewness and its kurtosis, the 16 %, 50 % and 84 % quantiles of
/// the heights are the values for `g = -1, 0, 1`.
#[test]
fn heights_follow_the_johnson_distribution() {
    const WIDTH: f64 = 0.314_361;
    let omega = (WIDTH * WIDTH).exp();
    let kurtosis = omega.powi(4) + 2.0 * omega.powi(3) + 3.0 * omega.powi(2) - 3.0;
    let asked = SelfAffine::with_rms_height(1.0)
        .roll_off_wavelength(16.0)
        .cut_off_wavelength(4.0);
    let surface = asked
        .skewness(1.0)
        .kurtosis(kurtosis)
        .generate(kit::square(128, 128.0))
        .unwrap();
    let mut heights = surface.into_heights().into_vec();
    heights.sort_by(f64::total_cmp);
    // The numbers are ranks among 128^2 heights.
    for (rank, normal) in [(2600, -1.0), (8192, 0.0), (13784, 1.0)] {
        let height = heights[rank];
        let mean = (0.5 * WIDTH * WIDTH).exp();
        let expected = ((WIDTH * normal).exp() - mean) / (mean * (omega - 1.0).sqrt());
        assert!((height - expected).abs() < 0.02, "{height} {expected}");
    }
}

#[test]
fn unattainable_moments_are_rejected() {
    let grid = kit::square(64, 64.0);
    let asked = SelfAffine::with_rms_height(1.0);
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for asked in [asked.skewness(value), asked.kurtosis(value)] {
            kit::assert_refused! {
                asked.generate(grid) => Error::NotFinite { value: v, .. } if v.to_bits() == value.to_bits(),
            }
        }
    }
    let error = asked
        .skewness(1.5)
        .kurtosis(3.2)
        .generate(grid)
        .unwrap_err();
    assert!(
        matches!(
            error,
            Error::BelowMinimum {
                quantity: "kurtosis",
                value: 3.2,
                least: 3.25,
                ..
            }
        ),
        "{error}"
    );
    // A distribution with the smallest kurtosis has only two values, and a few long waves cannot form a sharp peak.
    for (skewness, kurtosis) in [(0.0, 1.0), (1.0, 2.0), (0.0, 40.0), (4.0, 18.0)] {
        let asked = asked.skewness(skewness).kurtosis(kurtosis);
        kit::assert_refused! {
            asked.generate(grid)
                => Error::HeightMomentsNotReached { reached, .. } if reached.iter().all(|m| m.is_finite()),
        }
    }
    // The kurtosis of a single wave is fixed.
    let line = Grid::new(64, 1, 1.0, 1.0).unwrap();
    let wave = asked.longest_wavelength(32.0).cut_off_wavelength(32.0);
    let error = wave.kurtosis(2.0).generate(line).unwrap_err();
    assert!(
        matches!(error, Error::HeightMomentsNotReached { reached, .. } if (reached[1] - 1.5).abs() < 1e-12)
    );
}

/// Small grids have few waves in the band. A wave along y with a round-off amplitude has a mirror image with an
/// unrelated phase, which must not reduce both amplitudes.
#[test]
fn small_grids_keep_the_rms_height() {
    let sides = kit::thorough(
        &[1, 4, 7, 16][..],
        &[1, 2, 3, 4, 5, 7, 8, 12, 15, 16, 17, 24, 31, 32],
    );
    let moments_asked = [[-0.5, 2.1], [0.0, 3.0], [0.5, 2.5], [-1.0, 4.0]];
    let [mut reached, mut rejected] = [0, 0];
    for (&nx, &ny) in sides
        .iter()
        .flat_map(|nx| sides.iter().map(move |ny| (nx, ny)))
    {
        let grid = Grid::new(nx, ny, 1.0, 1.0).unwrap();
        for cut_off in [3.0, 8.0] {
            for seed in kit::thorough(19..20, 0..20) {
                for target in [
                    SelfAffine::with_rms_height(1.0),
                    SelfAffine::with_rms_slope(1.0),
                ] {
                    for amplitudes in [Amplitudes::Exact, Amplitudes::Gaussian] {
                        let asked = target.cut_off_wavelength(cut_off).seed(seed);
                        let asked = asked.amplitudes(amplitudes);
                        // A grid shorter than the cut-off wavelength has no wave.
                        let Ok(plain) = asked.generate(grid) else {
                            continue;
                        };
                        for [skewness, kurtosis] in moments_asked {
                            let asked = asked.skewness(skewness).kurtosis(kurtosis);
                            match asked.generate(grid) {
                                Ok(surface) => {
                                    let rms = [surface.rms_height(), surface.rms_slope()];
                                    let expected = [plain.rms_height(), plain.rms_slope()];
                                    for (rms, expected) in rms.into_iter().zip(expected) {
                                        let ratio = rms / expected;
                                        assert!(
                                            (ratio - 1.0).abs() < 1e-12,
                                            "{nx} x {ny}, {asked:?}: {ratio}"
                                        );
                                    }
                                    let kept = wave_amplitudes(surface.heights());
                                    let drawn = wave_amplitudes(plain.heights());
                                    assert!(
                                        max_difference(&kept, &drawn) < 1e-13 * expected[0],
                                        "{nx} x {ny}, {asked:?}"
                                    );
                                    let found = moments(surface.heights());
                                    let asked_for = [skewness, kurtosis];
                                    assert!(max_difference(&found, &asked_for) < 2e-9);
                                    reached += 1;
                                }
                                Err(Error::HeightMomentsNotReached { .. }) => rejected += 1,
                                Err(error) => panic!("{nx} x {ny}, {asked:?}: {error}"),
                            }
                        }
                    }
                }
            }
        }
    }
    assert!(reached > 50 && rejected > 50, "{reached} {rejected}");
    // Two waves along y cannot have these moments for any phases.
    let asked = SelfAffine::with_rms_height(1.0).seed(19);
    kit::assert_refused! {
        asked.skewness(-0.5).kurtosis(2.1).generate(Grid::new(4, 16, 1.0, 1.0).unwrap())
            => Error::HeightMomentsNotReached { .. },
    }
}
