//! Closed-form contacts, compared with reference values and with the laws that they satisfy.
//!
//! Unless a test states otherwise, the case is the paper's Table 2: a steel ball, in SI units.

mod cycles;
mod lines;
mod normal;
mod numbers;
mod pressing;
mod punches;
mod roughness;
mod tangential;
mod torsion;
mod units;
mod waves;
mod worn;

use std::f64::consts::{FRAC_PI_2, PI};

use approx::assert_relative_eq;
use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::{ElasticPair, Error, Material, Result};

const FRICTION: f64 = 0.5;
/// Largest tangential force that friction can carry.
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

/// Returns an incompressible body on a rigid one, with a contact modulus of 25 MPa and without coupling.
fn rubber() -> Result<ElasticPair> {
    ElasticPair::new(Material::new(18.75e6, 0.5)?, Material::rigid())
}

/// Checks equality up to a few roundings, without an absolute tolerance, for any unit.
#[track_caller]
fn assert_close(found: f64, expected: f64) {
    assert_relative_eq!(found, expected, max_relative = 1e-12, epsilon = 0.0);
}

/// Integrates by Simpson's rule.
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

/// Returns the area integral of `field(r)`, smooth except for a kink at `kink`, over the disc of radius `edge`.
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

/// Integrates by the double-exponential rule, for integrands that are singular at the ends.
fn singular_integral(from: f64, to: f64, integrand: impl Fn(f64) -> f64) -> f64 {
    let step = 0.05;
    let length = to - from;
    if length <= 0.0 {
        return 0.0;
    }
    let terms = (-76..=76).map(|i| {
        let t = step * f64::from(i);
        let stretch = (PI * t.sinh()).exp();
        let fraction = stretch / (1.0 + stretch);
        let weight = PI * t.cosh() * fraction / (1.0 + stretch);
        weight * integrand(from + length * fraction)
    });
    terms.sum::<f64>() * step * length
}

/// Integrates the axisymmetric `field(r)` of radius `edge`, with a kink at `kink`, along the chord at the distance `d`
/// from the centre.
fn chord_integral(kink: f64, edge: f64, d: f64, field: impl Fn(f64) -> f64) -> f64 {
    let half = |radius: f64| ((radius - d) * (radius + d)).max(0.0).sqrt();
    let along = |l: f64| field(d.hypot(l));
    let inner = singular_integral(0.0, half(kink), along);
    2.0 * (inner + singular_integral(half(kink), half(edge), along))
}

/// Integrates `chord(d, t)` over all chords of a disc of radius `edge` through a point at the distance `r` from the
/// centre. `d` is the distance of the chord from the centre, and `t` is its angle to the radius.
fn sum_over_chords(edge: f64, r: f64, chord: impl Fn(f64, f64) -> f64) -> f64 {
    let reach = if r > edge {
        (edge / r).asin()
    } else {
        FRAC_PI_2
    };
    singular_integral(0.0, reach, |t| {
        let d = r * t.sin();
        chord(d, t) + chord(d, -t)
    })
}
