//! The random numbers of one wave, determined by the seed and the wave alone.

use std::f64::consts::TAU;

use num_complex::Complex;

use super::Amplitudes;

/// A complex number whose mean square over all seeds is one: of modulus one or normally distributed.
pub(super) fn wave(seed: u64, numbers: [i64; 2], amplitudes: Amplitudes) -> Complex<f64> {
    let bits = numbers.iter().fold(mix(seed), |bits, number| {
        mix(bits ^ u64::from_le_bytes(number.to_le_bytes()))
    });
    let modulus = match amplitudes {
        Amplitudes::Exact => 1.0,
        // Box and Muller: the squared modulus of a normal complex number is exponential.
        Amplitudes::Gaussian => (-(-fraction(mix(bits))).ln_1p()).sqrt(),
    };
    Complex::from_polar(modulus, TAU * fraction(bits))
}

/// The generator splitmix64: Steele, Lea and Flood (2014).
fn mix(bits: u64) -> u64 {
    let bits = bits.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// The upper 53 bits, in `[0, 1)`.
fn fraction(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}
