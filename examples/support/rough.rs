//! A rough surface, the same on every machine.

use std::f64::consts::TAU;

use stickslip::{Field, Grid, Result};

/// Heights fall off with the wave number q as q^-(1 + Hurst).
const HURST: f64 = 0.8;
/// Longest wave: this part of the side.
const LONGEST: i64 = 4;
/// Shortest wave, in cells.
const SHORTEST: i64 = 8;
/// Root mean square of the slope.
const SLOPE: f64 = 0.1;

/// A self-affine surface on a square of `cells` x `cells` unit cells, of mean zero: every wave between
/// a quarter of the side and eight cells, with a phase that depends on `seed` and on the wave alone,
/// so that a finer grid adds waves to the same surface.
pub(crate) fn self_affine(cells: u16, seed: u64) -> Result<Field> {
    let side = usize::from(cells);
    let grid = Grid::square(side, f64::from(cells))?;
    let most = i64::from(cells) / SHORTEST;
    let angle = |wave: i64, i: usize| TAU * (wave as f64) * (i as f64) / f64::from(cells);

    // sum of a cos(kx x + ky y + phase) = sum over kx of [C(kx, y) cos(kx x) - S(kx, y) sin(kx x)]
    let mut samples = vec![0.0; grid.cells()];
    let mut squared_slope = 0.0;
    for wave_x in 0..=most {
        let mut cosines = vec![0.0; side];
        let mut sines = vec![0.0; side];
        for wave_y in -most..=most {
            let length = (wave_x as f64).hypot(wave_y as f64);
            let is_twin = wave_x == 0 && wave_y <= 0;
            if is_twin || length < LONGEST as f64 || length > most as f64 {
                continue;
            }
            let amplitude = length.powf(-1.0 - HURST);
            let wave_number = TAU * length / f64::from(cells);
            squared_slope += 0.5 * (amplitude * wave_number).powi(2);
            let phase = phase(seed, wave_x, wave_y);
            for (i, (cosine, sine)) in cosines.iter_mut().zip(&mut sines).enumerate() {
                let (s, c) = (angle(wave_y, i) + phase).sin_cos();
                *cosine += amplitude * c;
                *sine += amplitude * s;
            }
        }
        let waves: Vec<_> = (0..side).map(|i| angle(wave_x, i).sin_cos()).collect();
        let coefficients = cosines.iter().zip(&sines);
        for (row, (cosine, sine)) in samples.chunks_exact_mut(side).zip(coefficients) {
            for (height, (s, c)) in row.iter_mut().zip(&waves) {
                *height += cosine * c - sine * s;
            }
        }
    }
    let scale = SLOPE / squared_slope.sqrt();
    for height in &mut samples {
        *height *= scale;
    }
    Field::from_vec(grid, samples)
}

/// A phase from the numbers of a wave, by the generator splitmix64.
fn phase(seed: u64, wave_x: i64, wave_y: i64) -> f64 {
    let mut bits = seed;
    for wave in [wave_x, wave_y] {
        bits ^= u64::from_le_bytes(wave.to_le_bytes());
        bits = bits.wrapping_add(0x9E37_79B9_7F4A_7C15);
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^= bits >> 31;
    }
    // The upper 53 bits, as a fraction.
    TAU * (bits >> 11) as f64 / (1_u64 << 53) as f64
}
