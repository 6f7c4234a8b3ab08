//! Properties of the closed forms of normal contact.

use std::f64::consts::{FRAC_PI_2, PI};

use approx::assert_relative_eq;
use stickslip::Result;
use stickslip::analytical::{CattaneoMindlinEllipse, HertzEllipse};

use super::{FRICTION, assert_close, ball, disc_integral, integral, sheared_ball, steel};

#[test]
fn pressure_integrates_to_the_load() -> Result<()> {
    let ball = ball()?;
    let a = ball.contact_radius();
    assert_close(disc_integral(0.5 * a, a, |r| ball.pressure(r)), 100.0);

    let barrel = HertzEllipse::new(&steel()?, 7e-3, 2e-3, 100.0)?;
    let [along_x, along_y] = barrel.semi_axes();
    // Every ray from the centre contributes the same load.
    let per_ray = disc_integral(0.5, 1.0, |rho| {
        barrel.pressure(0.6 * rho * along_x, 0.8 * rho * along_y)
    });
    assert_close(per_ray * along_x * along_y, 100.0);
    Ok(())
}

#[test]
fn ellipse_of_equal_radii_matches_sphere() -> Result<()> {
    let pair = steel()?;
    let ball = ball()?;
    let shear = sheared_ball(20.0)?;
    let a = ball.contact_radius();
    for difference in [0.0, 1e-15, -1e-12, 1e-9, -1e-6] {
        let round = HertzEllipse::new(&pair, 3.5e-3 * (1.0 + difference), 3.5e-3, 100.0)?;
        let sheared = CattaneoMindlinEllipse::new(round, FRICTION, 20.0)?;
        let near = |found: f64, expected: f64| {
            let tolerance = 1e-14 + f64::abs(difference);
            assert_relative_eq!(found, expected, max_relative = tolerance, epsilon = 0.0);
        };
        near(round.semi_axes()[0], a);
        near(round.semi_axes()[1], a);
        near(round.max_pressure(), ball.max_pressure());
        near(round.approach(), ball.approach());
        near(round.pressure(0.3 * a, 0.4 * a), ball.pressure(0.5 * a));
        near(sheared.shift(), shear.shift());
        near(sheared.stick_ratio(), shear.stick_ratio());
        near(
            sheared.energy_of_first_quarter(),
            shear.energy_of_first_quarter(),
        );
        near(sheared.traction(0.3 * a, 0.4 * a), shear.traction(0.5 * a));
    }
    Ok(())
}

/// The Hertz pressure of the ellipse displaces its centre by the approach and flattens the gap.
#[test]
fn ellipse_pressure_closes_the_gap_in_contact() -> Result<()> {
    let pair = steel()?;
    for [radius_x, radius_y] in [
        [7e-3, 2e-3],
        [2e-3, 7e-3],
        [1.0, 1e-3],
        [1e-3, 1.0],
        [3e-3, 3e-3],
    ] {
        let hertz = HertzEllipse::new(&pair, radius_x, radius_y, 100.0)?;
        let [along_x, along_y] = hertz.semi_axes();
        assert_eq!(along_x > along_y, radius_x > radius_y);
        // Integrates Boussinesq's kernel along chords in the direction (along_x cos t, along_y sin t). These chords map
        // to the chords of a unit disc.
        let displacement = |x: f64, y: f64| {
            let (xi, eta) = (x / along_x, y / along_y);
            let sum = integral(0.0, PI, |t| {
                let (sine, cosine) = t.sin_cos();
                let distance = xi * sine - eta * cosine;
                let stretch = (along_x * cosine).hypot(along_y * sine);
                FRAC_PI_2 * (1.0 - distance * distance) * along_x * along_y / stretch
            });
            hertz.max_pressure() * sum / (PI * pair.contact_modulus())
        };
        for (xi, eta) in [(0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.6, 0.7)] {
            let (x, y) = (xi * along_x, eta * along_y);
            let gap = x * x / (2.0 * radius_x) + y * y / (2.0 * radius_y);
            assert_relative_eq!(
                displacement(x, y) + gap,
                hertz.approach(),
                max_relative = 1e-9,
                epsilon = 0.0
            );
        }
    }
    Ok(())
}

/// Long ellipses have the logarithmic terms of a line contact, at any aspect ratio that a double can represent.
#[test]
fn thin_ellipse_is_accurate() -> Result<()> {
    let pair = steel()?;
    for ratio in [1e3_f64, 1e6, 1e100, 1e290] {
        let along = HertzEllipse::new(&pair, 1e-3 * ratio, 1e-3, 1.0)?;
        let across = HertzEllipse::new(&pair, 1e-3, 1e-3 * ratio, 1.0)?;
        let [a, b] = along.semi_axes();
        assert_close(across.semi_axes()[0], b);
        assert_close(across.approach(), along.approach());
        // With L = ln(4a/b): R''/R' = (b/a)^2 (L - 1), a^3 = 3 W R' (L - 1)/(pi E*).
        let logarithm = (4.0 * (a / b)).ln() - 1.0;
        let near = |found: f64, expected: f64| {
            let tolerance = 1e-12 + 30.0 * (b / a).powi(2);
            assert_relative_eq!(found, expected, max_relative = tolerance, epsilon = 0.0);
        };
        near(b / a * logarithm.sqrt() * ratio.sqrt(), 1.0);
        let cube = 3.0 / (PI * pair.contact_modulus()) * 1e-3 * ratio * logarithm;
        near(a, cube.cbrt());
    }
    Ok(())
}
