//! Phases of given waves for which the heights have exactly the requested skewness and kurtosis.
//!
//! Let `x` be heights of mean zero and mean square one. If the heights change, the skewness $`s`$ and the kurtosis
//! $`k`$ change by
//!
//! ```math
//! \delta s = 3 \langle e_s, \delta x\rangle, \quad e_s = x^2 - s x - 1, \qquad
//! \delta k = 4 \langle e_k, \delta x\rangle, \quad e_k = x^3 - k x - s ,
//! ```
//!
//! and a wave $`a`$ whose phase changes by $`\delta\varphi`$ changes by $`\mathrm{i} a\,\delta\varphi`$. The Newton
//! step consists of the phase changes that yield the required $`\delta s`$ and $`\delta k`$ with the smallest change of
//! the heights.

use num_complex::Complex;

use super::crop_window::CropWindow;
use super::moments::{Standardised, deviation};
use crate::error::{Error, Result};
use crate::observer::WorkObserver;
use crate::surface::waves::Waves;

/// Tolerance of skewness and kurtosis.
const TOLERANCE: f64 = 1e-9;
/// Maximum number of steps. Three to ten steps are usual.
const LIMIT: usize = 60;
/// Largest root mean square of the change of the heights in one step, relative to the root mean square of the heights.
const LONGEST_STEP: f64 = 0.1;

/// Changes the phases of the waves until the heights of the selected part have the requested skewness and kurtosis.
/// Returns the number of steps.
pub(super) fn turn(
    waves: &mut Waves,
    cut: &CropWindow,
    wanted: [f64; 2],
    watch: &mut WorkObserver<'_>,
) -> Result<usize> {
    let mut reached = [f64::NAN; 2];
    for step in 0..=LIMIT {
        watch.notify_observer()?;
        let surface = Standardised::new(cut.of(&waves.clone().into_field()));
        reached = surface.moments();
        watch.shown().residual = deviation(reached, wanted);
        let missing = [wanted[0] - reached[0], wanted[1] - reached[1]];
        if missing.iter().all(|missing| missing.abs() < TOLERANCE) {
            return Ok(step);
        }
        if !newton_step(waves, cut, &surface, missing) {
            break;
        }
        watch.shown().iteration += 1;
    }
    let [skewness, kurtosis] = wanted;
    Err(Error::HeightMomentsNotReached {
        skewness,
        kurtosis,
        reached,
    })
}

/// Changes the phases of the waves by a Newton step towards the requested skewness and kurtosis. `missing` is the
/// deficit of the two moments. Returns false if no phase change can correct both moments.
fn newton_step(
    waves: &mut Waves,
    cut: &CropWindow,
    surface: &Standardised,
    missing: [f64; 2],
) -> bool {
    let [skewness, kurtosis] = surface.moments();
    let direction = |f: &dyn Fn(f64) -> f64| {
        let mut direction = surface.heights.clone();
        for x in direction.as_mut_slice() {
            *x = f(*x);
        }
        Waves::of(&cut.padded(&direction))
    };
    let of_skewness = direction(&|x| x * x - skewness * x - 1.0);
    let of_kurtosis = direction(&|x| x * x * x - kurtosis * x - skewness);

    // The variables hold the mean products of the changes of the heights along the two directions.
    let [mut ss, mut sk, mut kk, mut square] = [0.0; 4];
    let directions = of_skewness.iter().zip(of_kurtosis.iter());
    for ((mode, wave), ((_, s), (_, k))) in waves.iter().zip(directions) {
        let [s, k] = [s, k].map(|direction| wave.norm() * turn_along(wave, direction));
        ss += mode.copies * s * s;
        sk += mode.copies * s * k;
        kk += mode.copies * k * k;
        square += mode.copies * wave.norm_sqr();
    }
    let share = cut.whole.cells() as f64 / cut.part.cells() as f64;
    let scale = surface.deviation / share;
    let [s, k] = [missing[0] / 3.0 * scale, missing[1] / 4.0 * scale];
    let determinant = ss * kk - sk * sk;
    if determinant == 0.0 {
        return false;
    }
    let along = [
        (kk * s - sk * k) / determinant,
        (ss * k - sk * s) / determinant,
    ];
    let length = ((along[0] * s + along[1] * k) / square).sqrt();
    let [s, k] = along.map(|along| along * (LONGEST_STEP / length).min(1.0));
    waves.update_with([&of_skewness, &of_kurtosis], |_, wave, directions| {
        let [by_s, by_k] = directions.map(|direction| turn_along(wave, direction));
        wave * Complex::cis(s * by_s + k * by_k)
    });
    // The step amplifies the round-off of the directions. The factor of this amplification is large if phase changes
    // have little effect on one of the two moments.
    waves.pair_opposite_rows();
    true
}

/// Returns the angle by which the phase of a wave changes if the field changes along a direction.
fn turn_along(wave: Complex<f64>, direction: Complex<f64>) -> f64 {
    let square = wave.norm_sqr();
    if square > 0.0 {
        (wave.conj() * direction).im / square
    } else {
        0.0
    }
}
