//! Self-affine surfaces have the requested spectrum, target and band of waves.

use std::f64::consts::TAU;

use kit::waves::{Wave, waves};
use kit::{max_abs, max_difference};
use proptest::prelude::*;
use stickslip::surface::{Amplitudes, SelfAffine};
use stickslip::{Error, Grid};

/// Independent implementation of the spectral law.
#[derive(Debug, Clone, Copy)]
struct SpectralLaw {
    hurst: f64,
    longest: f64,
    roll_off: f64,
    cut_off: f64,
}

impl SpectralLaw {
    fn power(&self, wave: &Wave, grid: Grid) -> f64 {
        let [i, j] = wave.numbers;
        let is_at_limit = 2 * i.unsigned_abs() as usize == grid.nx()
            || 2 * j.unsigned_abs() as usize == grid.ny();
        let q = wave.wave_number();
        // A wave on the limit belongs to the band.
        let is_short = q > TAU / self.cut_off + 1e-9;
        let is_long = q < TAU / self.longest - 1e-9;
        if is_at_limit || is_short || is_long {
            0.0
        } else {
            (q * self.roll_off / TAU)
                .max(1.0)
                .powf(-2.0 - 2.0 * self.hurst)
        }
    }

    fn surface(&self, target: SelfAffine) -> SelfAffine {
        target
            .hurst(self.hurst)
            .longest_wavelength(self.longest)
            .roll_off_wavelength(self.roll_off)
            .cut_off_wavelength(self.cut_off)
    }
}

/// Returns square, oblong, odd and one-dimensional grids, with and without a plateau of the spectrum.
fn scenes() -> Vec<(Grid, SpectralLaw)> {
    let law = |hurst, longest, roll_off, cut_off| SpectralLaw {
        hurst,
        longest,
        roll_off,
        cut_off,
    };
    vec![
        (kit::square(64, 64.0), law(0.8, 64.0, 64.0, 8.0)),
        (kit::square(64, 64.0), law(0.5, 32.0, 16.0, 2.0)),
        (
            Grid::new(96, 40, 0.5, 1.2).unwrap(),
            law(0.3, 48.0, 12.0, 2.5),
        ),
        (
            Grid::new(45, 63, 1.0, 0.7).unwrap(),
            law(1.0, 45.0, 30.0, 4.0),
        ),
        (
            Grid::new(128, 1, 1.0, 1.0).unwrap(),
            law(0.8, 64.0, 32.0, 4.0),
        ),
        (
            Grid::new(1, 50, 1.0, 1.0).unwrap(),
            law(0.0, 50.0, 50.0, 2.0),
        ),
    ]
}

fn mean_square(samples: &[f64]) -> f64 {
    samples.iter().map(|z| z * z).sum::<f64>() / samples.len() as f64
}

#[test]
fn exact_amplitudes_match_law_for_each_wave() {
    for (grid, law) in scenes() {
        for cropped in [false, true] {
            let asked = law.surface(SelfAffine::with_rms_height(3.0)).seed(5);
            let asked = if cropped { asked.cropped() } else { asked };
            let surface = asked.generate(grid).unwrap();
            let heights = surface.heights();
            assert_eq!(heights.grid(), grid);
            assert!((mean_square(heights.as_slice()).sqrt() / 3.0 - 1.0).abs() < 1e-12);
            assert!((surface.rms_height() / 3.0 - 1.0).abs() < 1e-12);
            let mean = heights.integral() / grid.area();
            assert!(mean.abs() < 1e-13, "{mean}");
        }
        let surface = law.surface(SelfAffine::with_rms_height(3.0)).seed(5);
        let found = waves(surface.generate(grid).unwrap().heights());
        let total: f64 = found.iter().map(|wave| law.power(wave, grid)).sum();
        for wave in found {
            let expected = 9.0 * law.power(&wave, grid) / total;
            let error = (wave.power().sqrt() - expected.sqrt()).abs();
            assert!(error < 1e-14, "{law:?} {wave:?}: {expected}");
        }
    }
}

#[test]
fn requested_slope_is_that_of_the_waves() {
    for (grid, law) in scenes() {
        let asked = law.surface(SelfAffine::with_rms_slope(0.2)).seed(11);
        let surface = asked.generate(grid).unwrap();
        let found = waves(surface.heights());
        let square: f64 = found
            .iter()
            .map(|wave| wave.wave_number().powi(2) * wave.power())
            .sum();
        assert!((square.sqrt() / 0.2 - 1.0).abs() < 1e-12);
        assert!((surface.rms_slope() / 0.2 - 1.0).abs() < 1e-12);
        let cropped = asked.cropped().generate(grid).unwrap();
        assert!((cropped.rms_slope() / 0.2 - 1.0).abs() < 1e-12);
    }
    // The slope of a cropped surface agrees with finite differences if the cells are fine enough.
    let grid = kit::square(96, 1.0);
    let asked = SelfAffine::with_rms_slope(0.2).cut_off_wavelength(0.5);
    let surface = asked.cropped().generate(grid).unwrap();
    let heights = surface.heights();
    let slope = |ix: usize, iy: usize| {
        let at = |ix, iy| heights.get(ix, iy).unwrap();
        let x = (at(ix + 1, iy) - at(ix - 1, iy)) / (2.0 * grid.dx());
        let y = (at(ix, iy + 1) - at(ix, iy - 1)) / (2.0 * grid.dy());
        x.hypot(y)
    };
    let inner = (1..95).flat_map(|iy| (1..95).map(move |ix| (ix, iy)));
    let slopes: Vec<_> = inner.map(|(ix, iy)| slope(ix, iy)).collect();
    assert!((mean_square(&slopes).sqrt() / 0.2 - 1.0).abs() < 0.02);
}

#[test]
fn targets_of_any_magnitude_are_met() {
    for target in [1e-200, 1e-160, 1e160, 1e200] {
        for asked in [
            SelfAffine::with_rms_height(target),
            SelfAffine::with_rms_height(target).cropped(),
        ] {
            let surface = asked.generate(kit::square(32, 32.0)).unwrap();
            assert!((surface.rms_height() / target - 1.0).abs() < 1e-12);
            let samples = surface.heights().as_slice();
            let relative: Vec<f64> = samples.iter().map(|z| z / target).collect();
            assert!((mean_square(&relative).sqrt() - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn mean_is_excluded_from_every_band() {
    let grid = kit::square(32, 32.0);
    let asked = SelfAffine::with_rms_height(1.0).roll_off_wavelength(16.0);
    let surface = asked.longest_wavelength(f64::MAX).generate(grid).unwrap();
    assert_eq!(
        surface,
        asked.longest_wavelength(100.0).generate(grid).unwrap()
    );
}

/// The squared moduli relative to the law are exponentially distributed with mean one. The mean of M squared moduli is
/// therefore 1, with a standard error of 1 divided by sqrt(M). Their mean square is 2, with a standard error of
/// sqrt(20) divided by sqrt(M).
#[test]
fn gaussian_amplitudes_match_law_on_average() {
    let law = SpectralLaw {
        hurst: 0.8,
        longest: 48.0,
        roll_off: 16.0,
        cut_off: 4.0,
    };
    let grid = Grid::new(48, 40, 1.0, 1.2).unwrap();
    let asked = law
        .surface(SelfAffine::with_rms_height(2.0))
        .amplitudes(Amplitudes::Gaussian);
    let mut rings = vec![Vec::new(); 13];
    let mut mean_squares = Vec::new();
    for seed in 0..60 {
        let surface = asked.seed(seed).generate(grid).unwrap();
        mean_squares.push(surface.rms_height().powi(2) / 4.0);
        let found = waves(surface.heights());
        let total: f64 = found.iter().map(|wave| law.power(wave, grid)).sum();
        for wave in found {
            let expected = 4.0 * law.power(&wave, grid) / total;
            let [i, j] = wave.numbers;
            if expected > 0.0 && (i > 0 || (i == 0 && j > 0)) {
                let ring = (i * i + j * j).isqrt().unsigned_abs() as usize;
                rings[ring].push(wave.power() / expected);
            }
        }
    }
    let every = rings.concat();
    for ring in rings.iter().chain([&every]).filter(|ring| !ring.is_empty()) {
        let count = ring.len() as f64;
        let mean = ring.iter().sum::<f64>() / count;
        assert!((mean - 1.0).abs() < 4.0 / count.sqrt(), "{mean} of {count}");
        let fourth = mean_square(ring);
        assert!((fourth - 2.0).abs() < 4.0 * (20.0 / count).sqrt());
    }
    assert!(every.len() > 10_000);
    // The target is met on average, but not by each surface.
    let mean = mean_squares.iter().sum::<f64>() / 60.0;
    assert!((mean - 1.0).abs() < 0.1);
    assert!(
        mean_squares
            .iter()
            .any(|square| (square - mean).abs() > 0.05)
    );
}

#[test]
fn seed_determines_surface() {
    let grid = Grid::new(48, 40, 1.0, 1.25).unwrap();
    let asked = SelfAffine::with_rms_height(1.0);
    let plain = |seed| asked.seed(seed).generate(grid).unwrap().into_heights();
    assert_eq!(plain(0), asked.generate(grid).unwrap().into_heights());
    for seed in [1, 2, 1 << 40, u64::MAX] {
        let product: f64 = plain(0)
            .as_slice()
            .iter()
            .zip(plain(seed).as_slice())
            .map(|(a, b)| a * b)
            .sum();
        // The product is smaller than the squares by a margin that allows for the few dominant waves.
        assert!(product.abs() < 0.9 * grid.cells() as f64);
    }
    // The surfaces equal the surfaces of the first release.
    let golden = [
        (
            asked,
            [-0.643_551_167_338, 0.586_680_001_703, 0.236_479_981_638],
        ),
        (
            asked.seed(7).amplitudes(Amplitudes::Gaussian),
            [-0.459_802_407_999, 0.017_434_592_774, 0.786_419_478_320],
        ),
        (
            asked.seed(7).cropped(),
            [0.137_905_567_588, -0.155_108_187_467, 0.936_594_599_240],
        ),
        (
            asked.seed(7).skewness(-0.5).kurtosis(4.0),
            [-0.237_262_824_769, -0.632_498_041_517, 1.154_438_046_537],
        ),
    ];
    for (asked, expected) in golden {
        let heights = asked.generate(grid).unwrap().into_heights();
        let found = [(0, 0), (13, 7), (47, 20)].map(|(ix, iy)| heights.get(ix, iy).unwrap());
        assert!(max_difference(&found, &expected) < 1e-9, "{found:?}");
    }
}

#[test]
fn surface_is_independent_of_threads() {
    let grid = Grid::new(150, 128, 1.0, 1.0).unwrap();
    let asked = SelfAffine::with_rms_slope(0.1).cropped().kurtosis(4.0);
    let [one, three] = [1, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build()
            .unwrap()
            .install(|| asked.generate(grid).unwrap())
    });
    assert_eq!(one, three);
}

fn is_below(result: &Result<impl Sized, Error>, asked: &str, value: f64) -> bool {
    matches!(result, Err(Error::BelowMinimum { quantity, value: v, .. }) if *quantity == asked && *v == value)
}

#[test]
fn invalid_input_is_rejected() {
    let grid = kit::square(32, 32.0);
    let good = SelfAffine::with_rms_height(1.0);
    for hurst in [-0.1, 1.1, f64::NAN] {
        kit::assert_refused! { good.hurst(hurst).generate(grid) => Error::Hurst(h) if h.to_bits() == hurst.to_bits() }
    }
    let below = |asked: SelfAffine, quantity, value| {
        assert!(
            is_below(&asked.generate(grid), quantity, value),
            "{quantity}"
        );
    };
    below(good.cut_off_wavelength(1.9), "cut-off wavelength", 1.9);
    below(good.roll_off_wavelength(7.0), "roll-off wavelength", 7.0);
    below(good.roll_off_wavelength(40.0), "longest wavelength", 32.0);
    let order = good.longest_wavelength(10.0).roll_off_wavelength(16.0);
    below(order, "longest wavelength", 10.0);
    // The default cut-off of eight cells is longer than this domain.
    let small = good.generate(kit::square(4, 1.0));
    assert!(is_below(&small, "longest side of the surface", 1.0));
    // The longest waves have wavelengths of 32, 32 / sqrt(2) and 16.
    let between = good.longest_wavelength(22.0).cut_off_wavelength(17.0);
    kit::assert_refused! { between.generate(grid) => Error::NoWaveInBand { longest: 22.0, shortest: 17.0 } }
    assert!(good.cut_off_wavelength(2.0).generate(grid).is_ok());
    let same = good.longest_wavelength(16.0).cut_off_wavelength(16.0);
    assert!(same.generate(grid).is_ok());
}

fn any_grid() -> impl Strategy<Value = Grid> {
    (8..40_usize, 8..40_usize, 0.3..3.0_f64)
        .prop_map(|(nx, ny, dy)| Grid::new(nx, ny, 1.0, dy).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(11, 32)))]

    /// Lengths in a different unit give the same surface.
    #[test]
    fn surface_is_independent_of_unit(grid in any_grid(), seed: u64, unit in -9..9_i32, cropped: bool) {
        let unit = 10_f64.powi(unit);
        let surface = |unit: f64, target: SelfAffine| {
            let grid = Grid::new(grid.nx(), grid.ny(), unit, grid.dy() * unit).unwrap();
            let asked = target.cut_off_wavelength(6.0 * unit).seed(seed);
            let asked = if cropped { asked.cropped() } else { asked };
            asked.generate(grid).unwrap().into_heights()
        };
        for (one, other) in [
            (SelfAffine::with_rms_height(0.7), SelfAffine::with_rms_height(0.7 * unit)),
            (SelfAffine::with_rms_slope(0.7), SelfAffine::with_rms_slope(0.7)),
        ] {
            let (one, other) = (surface(1.0, one), surface(unit, other));
            let other: Vec<_> = other.as_slice().iter().map(|z| z / unit).collect();
            prop_assert!(max_difference(&other, one.as_slice()) < 1e-11 * max_abs(&other));
        }
    }

    /// The mean is zero, and heights are proportional to the target.
    #[test]
    fn heights_are_proportional_to_the_target(grid in any_grid(), seed: u64, factor in 0.01..100.0_f64) {
        let surface = |rms: f64| {
            let asked = SelfAffine::with_rms_height(rms).cut_off_wavelength(6.0).seed(seed);
            asked.generate(grid).unwrap().into_heights()
        };
        let (one, other) = (surface(1.0), surface(factor));
        prop_assert!((one.integral() / grid.area()).abs() < 1e-14);
        let other: Vec<_> = other.as_slice().iter().map(|z| z / factor).collect();
        prop_assert!(max_difference(&other, one.as_slice()) < 1e-13 * max_abs(&other));
    }
}
