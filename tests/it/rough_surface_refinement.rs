//! A seed determines one rough surface, independently of the grid that samples it.

use std::f64::consts::TAU;

use kit::waves::{Wave, waves};
use kit::{max_abs, max_difference};
use stickslip::surface::{Amplitudes, SelfAffine};
use stickslip::{Field, Grid};

fn mean_square(samples: &[f64]) -> f64 {
    samples.iter().map(|z| z * z).sum::<f64>() / samples.len() as f64
}

/// Samples the waves of a field at the centres of a different grid of the same rectangle.
fn sample_waves(found: &[Wave], grid: Grid) -> Field {
    Field::from_fn(grid, |x, y| {
        let height = |wave: &Wave| {
            let (s, c) = (wave.vector[0] * x + wave.vector[1] * y).sin_cos();
            wave.amplitude[0] * c - wave.amplitude[1] * s
        };
        found.iter().map(height).sum()
    })
}

#[test]
fn finer_grid_samples_the_same_surface() {
    let sizes = kit::thorough(
        &[([20, 18], [40, 36]), ([21, 18], [39, 56])][..],
        &[
            ([32, 32], [64, 64]),
            ([32, 24], [64, 48]),
            ([31, 24], [57, 90]),
        ],
    );
    for &(coarse, fine) in sizes {
        let grid =
            |[nx, ny]: [usize; 2]| Grid::new(nx, ny, 2.0 / nx as f64, 1.5 / ny as f64).unwrap();
        for amplitudes in [Amplitudes::Exact, Amplitudes::Gaussian] {
            for target in [
                SelfAffine::with_rms_height(1.0),
                SelfAffine::with_rms_slope(1.0),
            ] {
                let asked = target.amplitudes(amplitudes).seed(3);
                let fixed = asked.cut_off_wavelength(0.25);
                let expected = fixed.generate(grid(coarse)).unwrap();
                let found = waves(fixed.generate(grid(fine)).unwrap().heights());
                let again = sample_waves(&found, grid(coarse));
                let (again, heights) = (again.as_slice(), expected.heights().as_slice());
                assert!(max_difference(again, heights) < 1e-12 * max_abs(heights));
            }
        }
    }
}

#[test]
fn adding_short_waves_scales_the_long_waves_uniformly() {
    let asked = SelfAffine::with_rms_height(1.0).seed(3);
    let [coarse, fine] = [32, 64].map(|n| {
        let surface = asked.generate(kit::square(n, 1.0)).unwrap();
        waves(surface.heights())
    });
    let band = |found: &[Wave]| -> Vec<[f64; 2]> {
        let long = found.iter().filter(|wave| wave.wave_number() < TAU * 4.001);
        long.map(|wave| wave.amplitude).collect()
    };
    let (long, same) = (band(&coarse), band(&fine));
    let total = |amplitudes: &[[f64; 2]]| mean_square(&amplitudes.concat());
    let factor = (total(&long) / total(&same)).sqrt();
    assert!(factor > 1.001);
    for (a, b) in long.concat().iter().zip(same.concat()) {
        assert!((a - factor * b).abs() < 1e-13);
    }
    assert!(fine.iter().filter(|wave| wave.power() > 1e-20).count() > 4 * 40);
}

#[test]
fn cropped_surface_on_finer_grid_is_the_same_and_not_periodic() {
    for [nx, ny] in [[20, 16], [15, 21]] {
        let grid = |part: usize| {
            let cell = |n: usize| 1.0 / (part * n) as f64;
            Grid::new(part * nx, part * ny, cell(nx), cell(ny)).unwrap()
        };
        let asked = SelfAffine::with_rms_height(1.0)
            .cut_off_wavelength(0.25)
            .cropped()
            .seed(9);
        // Both surfaces are scaled to the target on their own cells, so they agree up to a factor and a mean.
        let [coarse, fine] = [1, 3].map(|part| asked.generate(grid(part)).unwrap().into_heights());
        let within = (0..ny).flat_map(|iy| (0..nx).map(move |ix| (3 * ix + 1, 3 * iy + 1)));
        let same: Vec<_> = within.map(|(ix, iy)| fine.get(ix, iy).unwrap()).collect();
        let mean = same.iter().sum::<f64>() / same.len() as f64;
        let same: Vec<_> = same.iter().map(|z| z - mean).collect();
        let rms = mean_square(&same).sqrt();
        assert!((rms - 1.0).abs() < 0.02);
        let same: Vec<_> = same.iter().map(|z| z / rms).collect();
        assert!(max_difference(&same, coarse.as_slice()) < 1e-12);

        // The jump between opposite edges is as large as any other step.
        let rows = coarse.rows().map(|row| (row[0] - row[nx - 1]).abs());
        let step = rows.fold(0.0, f64::max);
        assert!(step > 0.5, "{step}");
    }
}
