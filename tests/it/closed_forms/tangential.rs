//! Properties of contacts in partial slip, and rejected arguments.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

use approx::assert_relative_eq;
use stickslip::Result;
use stickslip::analytical::{CattaneoMindlin, CattaneoMindlinEllipse, HertzEllipse};

use super::{FRICTION, LIMIT, assert_close, ball, disc_integral, integral, sheared_ball, steel};

#[test]
fn traction_integrates_to_the_force_within_friction_limit() -> Result<()> {
    let ball = ball()?;
    let a = ball.contact_radius();
    for fraction in [0.01, 0.4, 0.95] {
        let force = fraction * LIMIT;
        let shear = sheared_ball(force)?;
        let c = shear.stick_radius();
        // The quadrature has few points near c, where the slope of the traction changes, and limits the accuracy.
        let carried = disc_integral(c, a, |r| shear.traction(r));
        assert_relative_eq!(carried, force, max_relative = 1e-10);
        for i in 0..200 {
            let r = a * f64::from(i) / 200.0;
            let limit = FRICTION * ball.pressure(r);
            assert!(shear.traction(r) > 0.0);
            assert!(shear.traction(r) <= limit * (1.0 + 1e-14));
            assert_eq!(shear.traction(r) < limit * (1.0 - 1e-9), r < c);
        }
    }
    let barrel = HertzEllipse::new(&steel()?, 2e-3, 7e-3, 100.0)?;
    let shear = CattaneoMindlinEllipse::new(barrel, FRICTION, 20.0)?;
    let [along_x, along_y] = barrel.semi_axes();
    let stick = shear.stick_ratio().sqrt();
    let per_ray = disc_integral(stick, 1.0, |rho| {
        shear.traction(0.6 * rho * along_x, 0.8 * rho * along_y)
    });
    assert_close(per_ray * along_x * along_y, 20.0);
    Ok(())
}

/// Integrates Cerruti's kernel over the traction, independently of all formulas for `u_x`.
#[test]
fn displacement_matches_integral_of_traction() -> Result<()> {
    let pair = steel()?;
    let ball = ball()?;
    let (a, p0) = (ball.contact_radius(), ball.max_pressure());
    let (nu, shear_modulus) = (
        pair.equivalent_poisson_ratio(),
        pair.equivalent_shear_modulus(),
    );
    // Along a chord at the distance d from the centre, the integral of q0 sqrt(1 - r^2/b^2) is (pi/2) q0 (b^2 - d^2)/b.
    // The kernel depends only on the direction t of the chord.
    let hertzian = |q0: f64, b: f64, x: f64, y: f64| {
        let (r, theta) = (x.hypot(y), y.atan2(x));
        let reach = if r > b { (b / r).asin() } else { FRAC_PI_2 };
        let sum = integral(theta - reach, theta + reach, |t| {
            let d = r * (t - theta).sin();
            let kernel = 1.0 - nu + nu * t.cos().powi(2);
            kernel * FRAC_PI_2 * q0 * (b * b - d * d) / b
        });
        sum / (2.0 * PI * shear_modulus)
    };
    for force in [5.0, 20.0, 49.0] {
        let shear = sheared_ball(force)?;
        let c = shear.stick_radius();
        for ratio in [0.0, 0.3, 0.8, 0.97, 1.0, 1.01, 1.3, 4.0, 50.0] {
            for theta in [0.0_f64, 0.7, FRAC_PI_2, 2.5, -1.0] {
                let (x, y) = (ratio * a * theta.cos(), ratio * a * theta.sin());
                let mu_p0 = FRICTION * p0;
                let expected = hertzian(mu_p0, a, x, y) - hertzian(mu_p0 * c / a, c, x, y);
                assert_relative_eq!(
                    shear.displacement(x, y),
                    expected,
                    max_relative = 1e-11,
                    epsilon = 0.0
                );
            }
        }
    }
    Ok(())
}

#[test]
fn far_displacement_matches_point_force() -> Result<()> {
    let pair = steel()?;
    let far = 1e6 * ball()?.contact_radius();
    let normal = 100.0 / (PI * pair.contact_modulus() * far);
    assert_close(ball()?.displacement(far), normal);
    let shear = sheared_ball(20.0)?;
    let unit = 20.0 / (2.0 * PI * pair.equivalent_shear_modulus() * far);
    assert_close(shear.displacement(far, 0.0), unit);
    let across = unit * (1.0 - pair.equivalent_poisson_ratio());
    assert_close(shear.displacement(0.0, far), across);
    Ok(())
}

#[test]
fn stick_disc_is_rigid_and_slip_opposes_traction() -> Result<()> {
    let a = ball()?.contact_radius();
    for force in [-45.0, -10.0, 0.5, 20.0, 49.9] {
        let shear = sheared_ball(force)?;
        let c = shear.stick_radius();
        for i in 0..=50 {
            let theta = 0.1 * f64::from(i);
            let (sine, cosine) = theta.sin_cos();
            let inner = c * f64::from(i) / 51.0;
            assert_close(
                shear.displacement(inner * cosine, inner * sine),
                shear.shift(),
            );
            assert_close(shear.slip(inner * cosine, inner * sine), 0.0);
            let outer = c + (a - c) * (f64::from(i) + 0.5) / 51.0;
            let slip = shear.slip(outer * cosine, outer * sine);
            assert!(slip * shear.traction(outer) < 0.0);
            let sum = shear.shift() + slip;
            assert_close(shear.displacement(outer * cosine, outer * sine), sum);
            assert_close(shear.slip(1.01 * a * cosine, 1.01 * a * sine), 0.0);
        }
    }
    Ok(())
}

#[test]
fn fields_are_continuous_at_the_edges() -> Result<()> {
    let ball = ball()?;
    let a = ball.contact_radius();
    let shear = sheared_ball(20.0)?;
    let near = |found: f64, expected: f64| {
        assert_relative_eq!(found, expected, max_relative = 1e-6, epsilon = 0.0);
    };
    let (below, above) = (1.0 - 1e-9, 1.0 + 1e-9);
    near(ball.displacement(a * above), ball.displacement(a * below));
    assert!(ball.gap(a * above) >= 0.0 && ball.gap(a * above) < 1e-9 * ball.approach());
    for (cosine, sine) in [(1.0, 0.0), (0.6, 0.8), (0.0, 1.0)] {
        for edge in [a, shear.stick_radius()] {
            let at = |r: f64| shear.displacement(r * cosine, r * sine);
            near(at(edge * above), at(edge * below));
        }
    }
    let c = shear.stick_radius();
    assert_relative_eq!(
        shear.traction(c * above),
        shear.traction(c * below),
        max_relative = 1e-4
    );
    Ok(())
}

#[test]
fn reversed_force_reverses_all_fields() -> Result<()> {
    let (forth, back) = (sheared_ball(20.0)?, sheared_ball(-20.0)?);
    let a = forth.hertz().contact_radius();
    assert_close(back.shift(), -forth.shift());
    assert_close(back.stick_radius(), forth.stick_radius());
    assert_close(
        back.energy_of_first_quarter(),
        forth.energy_of_first_quarter(),
    );
    for ratio in [0.0, 0.5, 0.9, 1.0, 1.5] {
        let (x, y) = (0.6 * ratio * a, 0.8 * ratio * a);
        assert_close(back.traction(ratio * a), -forth.traction(ratio * a));
        assert_close(back.displacement(x, y), -forth.displacement(x, y));
        assert_close(back.slip(x, y), -forth.slip(x, y));
    }
    let barrel = HertzEllipse::new(&steel()?, 2e-3, 7e-3, 100.0)?;
    let forth = CattaneoMindlinEllipse::new(barrel, FRICTION, 20.0)?;
    let back = CattaneoMindlinEllipse::new(barrel, FRICTION, -20.0)?;
    assert_close(back.shift(), -forth.shift());
    assert_close(back.traction(1e-5, 2e-5), -forth.traction(1e-5, 2e-5));
    Ok(())
}

#[test]
fn dissipated_energy_equals_traction_times_slip() -> Result<()> {
    let a = ball()?.contact_radius();
    for force in [1.0, 20.0, 49.0] {
        let shear = sheared_ball(force)?;
        let c = shear.stick_radius();
        // The mean over all directions is the value at 45 degrees, where cos 2 theta = 0.
        let work = disc_integral(c, a, |r| {
            let along = r * FRAC_1_SQRT_2;
            -shear.traction(r) * shear.slip(along, along)
        });
        assert_relative_eq!(
            work,
            shear.energy_of_first_quarter(),
            max_relative = 1e-8,
            epsilon = 0.0
        );
    }
    // For a small force, the energy is mu W delta_0 f^3/27 to full precision.
    let gross = sheared_ball(LIMIT)?.shift();
    let fraction = 1e-5_f64;
    assert_relative_eq!(
        sheared_ball(fraction * LIMIT)?.energy_of_first_quarter(),
        LIMIT * gross * fraction.powi(3) / 27.0,
        max_relative = 3e-5,
        epsilon = 0.0
    );
    Ok(())
}

#[test]
fn zero_force_sticks_and_limit_force_slides() -> Result<()> {
    let ball = ball()?;
    let a = ball.contact_radius();
    let still = sheared_ball(0.0)?;
    assert_close(still.stick_radius(), a);
    for r in [0.0, 0.5 * a, a, 2.0 * a] {
        assert_close(still.traction(r), 0.0);
        assert_close(still.displacement(r, 0.0), 0.0);
        assert_close(still.slip(r, 0.0), 0.0);
    }
    let sliding = sheared_ball(-LIMIT)?;
    assert_close(sliding.stick_radius(), 0.0);
    assert_close(sliding.shift(), -2.960476140606902e-06);
    assert_close(
        sliding.traction(0.3 * a),
        -FRICTION * ball.pressure(0.3 * a),
    );
    assert_close(sliding.displacement(0.0, 0.0), sliding.shift());
    // Without friction there is neither a stick zone nor a shift.
    let smooth = CattaneoMindlin::new(ball, 0.0, 0.0)?;
    assert_close(smooth.stick_radius(), 0.0);
    assert_close(smooth.shift(), 0.0);
    assert_close(smooth.traction(0.5 * a), 0.0);
    Ok(())
}

#[test]
fn small_forces_are_accurate() -> Result<()> {
    let pair = steel()?;
    let a = ball()?.contact_radius();
    let force = 1e-12;
    let shear = sheared_ball(force)?;
    let compliance =
        (2.0 - pair.equivalent_poisson_ratio()) / (8.0 * pair.equivalent_shear_modulus() * a);
    assert_close(shear.shift(), force * compliance);
    // The slip ring is 1e-14 wide and does not affect the traction of full stick here.
    let full_stick = |r: f64| force / (2.0 * PI * a * (a * a - r * r).sqrt());
    assert_close(shear.traction(0.0), full_stick(0.0));
    assert_close(shear.traction(0.9 * a), full_stick(0.9 * a));
    Ok(())
}
