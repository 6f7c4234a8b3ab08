//! The final shape of a paraboloid worn by fretting.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

use approx::assert_relative_eq;
use stickslip::analytical::{CattaneoMindlin, HertzSphere, PopovLimitingShape};
use stickslip::{Error, Result};

use super::{
    FRICTION, LIMIT, assert_close, ball, chord_integral, integral, singular_integral, steel,
    sum_over_chords,
};

/// Stick radii as fractions of the contact radius.
const STICK: [f64; 5] = [0.05, 0.3, 0.6, 0.9, 0.99];

/// Returns the limiting shape of the steel ball at its approach.
fn limiting_shape(stick: f64) -> Result<PopovLimitingShape> {
    let ball = ball()?;
    let c = stick * ball.contact_radius();
    PopovLimitingShape::new(&steel()?, ball.radius(), ball.approach(), c)
}

/// The profile is the transformation to three dimensions of a plane contact that is worn off at the depth of the
/// approach.
#[test]
fn profile_matches_the_worn_plane_contact() -> Result<()> {
    let ball = ball()?;
    let (radius, depth) = (ball.radius(), ball.approach());
    for stick in STICK {
        let shape = limiting_shape(stick)?;
        let (c, b) = (shape.stick_radius(), shape.worn_radius());
        assert!(b > ball.contact_radius());
        for part in [1e-6, 0.1, 0.5, 0.9, 1.0 - 1e-6] {
            let r = c + part * (b - c);
            // The substitution x = r sin(t) removes the square root.
            let edge = (c / r).asin();
            let stuck = integral(0.0, edge, |t| (r * t.sin()).powi(2) / radius);
            let expected = FRAC_2_PI * (stuck + depth * (FRAC_PI_2 - edge));
            assert_relative_eq!(
                shape.profile(r),
                expected,
                max_relative = 1e-11,
                epsilon = 0.0
            );
        }
    }
    Ok(())
}

#[test]
fn profile_outside_the_worn_ring_is_unchanged() -> Result<()> {
    let radius = ball()?.radius();
    for stick in STICK {
        let shape = limiting_shape(stick)?;
        let (c, b) = (shape.stick_radius(), shape.worn_radius());
        let before = |r: f64| 0.5 * r * r / radius;
        for r in [0.0, 0.5 * c, c, b, 1.5 * b] {
            assert_close(shape.profile(r), before(r));
        }
        // At the outer edge the formula itself approaches the paraboloid.
        let edge = b * (1.0 - 1e-9);
        assert!(shape.wear_depth(edge) > 0.0);
        assert_relative_eq!(shape.profile(edge), before(edge), max_relative = 1e-7);
        assert!(shape.wear_depth(c * (1.0 + 1e-12)) < 1e-5 * shape.approach());
        for i in 1..50 {
            let r = c + (b - c) * f64::from(i) / 50.0;
            assert!(shape.wear_depth(r) > 0.0);
            assert_close(shape.profile(-r), before(r) + shape.wear_depth(r));
        }
        let volume = singular_integral(c, b, |r| 2.0 * PI * r * shape.wear_depth(r));
        assert_relative_eq!(
            shape.worn_volume(),
            volume,
            max_relative = 1e-11,
            epsilon = 0.0
        );
    }
    Ok(())
}

/// Integrates Boussinesq's kernel along chords. The remaining pressure closes the stick disc, and in the worn ring the
/// surfaces just touch.
#[test]
fn worn_surfaces_just_touch_in_the_slip_ring() -> Result<()> {
    let pair = steel()?;
    for stick in STICK {
        let shape = limiting_shape(stick)?;
        let (c, b) = (shape.stick_radius(), shape.worn_radius());
        let gap = |r: f64| {
            let sum = sum_over_chords(c, r, |d, _| chord_integral(d, c, d, |r| shape.pressure(r)));
            shape.profile(r) + sum / (PI * pair.contact_modulus()) - shape.approach()
        };
        let near = |found: f64| assert!(found.abs() < 1e-7 * shape.approach(), "{found:e}");
        for part in [0.1, 0.5, 0.9] {
            near(gap(part * c));
            near(gap(c + part * (b - c)));
        }
        assert!(gap(1.1 * b) > 1e-3 * shape.approach());
        let load = singular_integral(0.0, c, |r| 2.0 * PI * r * shape.pressure(r));
        assert_relative_eq!(load, shape.load(), max_relative = 1e-7);
    }
    Ok(())
}

#[test]
fn full_stick_wears_nothing_and_gross_slip_wears_all() -> Result<()> {
    let ball = ball()?;
    let a = ball.contact_radius();
    let whole = limiting_shape(1.0)?;
    assert_close(whole.worn_radius(), a);
    assert_close(whole.load(), 100.0);
    assert_close(whole.pressure(0.6 * a), ball.pressure(0.6 * a));
    assert_close(whole.wear_depth(0.999999 * a), 0.0);
    assert!(whole.worn_volume() < 1e-30 * a.powi(3));
    let slid = limiting_shape(0.0)?;
    assert_close(slid.load(), 0.0);
    assert_close(slid.pressure(0.0), 0.0);
    // The worn end is flat at the depth of the approach, up to the radius at which the paraboloid has that depth.
    assert_close(slid.worn_radius(), 2.0_f64.sqrt() * a);
    assert_close(slid.profile(0.3 * a), ball.approach());
    let cap = PI * ball.radius() * ball.approach().powi(2);
    assert_close(slid.worn_volume(), cap);
    Ok(())
}

/// The stick radius under a shift agrees with Cattaneo and Mindlin.
#[test]
fn shift_determines_the_stick_radius() -> Result<()> {
    let ball = ball()?;
    let shear = CattaneoMindlin::new(ball, FRICTION, 0.4 * LIMIT)?;
    let ratio = shear.stick_radius() / ball.contact_radius();
    assert_close(ratio * ratio, 1.0 - shear.shift() / shear.sliding_shift());
    Ok(())
}

#[test]
fn stick_radius_beyond_the_contact_is_rejected() -> Result<()> {
    let pair = steel()?;
    let shape = |radius, approach, stick| PopovLimitingShape::new(&pair, radius, approach, stick);
    kit::assert_refused! { shape(1.0, 1e-6, 1.1e-3) => Error::BelowMinimum { value, .. } if value < 1.1e-3 }
    // The radius is meant to equal the contact radius but is larger by a rounding error.
    assert!(shape(1.0, 1e-6, 1e-3 * (1.0 + 1e-15)).is_ok());
    let ball = HertzSphere::new(&pair, 3.5e-3, 100.0)?;
    assert!(shape(3.5e-3, ball.approach(), ball.contact_radius()).is_ok());
    Ok(())
}
