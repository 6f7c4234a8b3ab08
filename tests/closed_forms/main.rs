//! The closed-form contacts against their numbers and against the laws they obey.
//!
//! The case is the paper's Table 2 unless a test says otherwise: a steel ball, in SI units.

mod normal;
mod numbers;
mod tangential;
mod units;

use std::f64::consts::{FRAC_PI_2, PI};

use approx::assert_relative_eq;
use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::{ElasticPair, Material, Result};

const FRICTION: f64 = 0.5;
/// The largest tangential force friction holds.
const LIMIT: f64 = 50.0;

fn pair(youngs_modulus: f64, poisson_ratio: f64) -> Result<ElasticPair> {
    let body = Material::new(youngs_modulus, poisson_ratio)?;
    ElasticPair::new(body, body)
}

fn steel() -> Result<ElasticPair> {
    pair(213e9, 0.29)
}

fn ball() -> Result<HertzSphere> {
    HertzSphere::new(&steel()?, 3.5e-3, 100.0)
}

fn sheared_ball(force: f64) -> Result<CattaneoMindlin> {
    CattaneoMindlin::new(ball()?, FRICTION, force)
}

/// Equal to a few roundings, whatever the unit: no absolute part.
#[track_caller]
fn assert_close(found: f64, expected: f64) {
    assert_relative_eq!(found, expected, max_relative = 1e-12, epsilon = 0.0);
}

/// Simpson's rule.
fn integral(from: f64, to: f64, integrand: impl Fn(f64) -> f64) -> f64 {
    let intervals = 2000_u32;
    let step = (to - from) / f64::from(intervals);
    let sum: f64 = (0..=intervals)
        .map(|i| {
            let weight = match i {
                0 => 1.0,
                i if i == intervals => 1.0,
                i if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            weight * integrand(from + step * f64::from(i))
        })
        .sum();
    sum * step / 3.0
}

/// The area integral of `field(r)`, smooth but for a kink at `kink`, over the disc of radius `edge`.
fn disc_integral(kink: f64, edge: f64, field: impl Fn(f64) -> f64) -> f64 {
    // r = R sin t removes the square root at r = R.
    let part = |scale: f64, from: f64| {
        integral(from, FRAC_PI_2, |t| {
            let r = scale * t.sin();
            field(r) * 2.0 * PI * r * scale * t.cos()
        })
    };
    part(kink, 0.0) + part(edge, (kink / edge).asin())
}
