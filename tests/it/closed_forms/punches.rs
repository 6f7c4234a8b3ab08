//! The cone, the flat punch and the circle in full stick: reference values and properties.

use std::f64::consts::{FRAC_PI_2, PI};

use approx::assert_relative_eq;
use proptest::prelude::*;
use stickslip::Result;
use stickslip::analytical::{CattaneoMindlin, Cone, ConePartialSlip, FlatPunch, MindlinFullStick};

use super::{
    FRICTION, assert_close, ball, chord_integral, pair, rubber, singular_integral, steel,
    sum_over_chords,
};

/// Columns: distance divided by the contact radius, pressure, displacement, and tangential displacement per force at
/// the angles [`ANGLES`] from the force. The values are closed forms evaluated in extended precision and rounded.
#[rustfmt::skip] // one row per line
const FLAT_PUNCH: [[f64; 6]; 13] = [
    [0.0, 159154943.09189534, 4.333333333333333e-06, 5.2619047619047615e-09, 5.2619047619047615e-09, 5.2619047619047615e-09],
    [0.1, 159956736.29278272, 4.333333333333333e-06, 5.2619047619047615e-09, 5.2619047619047615e-09, 5.2619047619047615e-09],
    [0.25, 164374518.41639996, 4.333333333333333e-06, 5.2619047619047615e-09, 5.2619047619047615e-09, 5.2619047619047615e-09],
    [0.5, 183776298.4739307, 4.333333333333333e-06, 5.2619047619047615e-09, 5.2619047619047615e-09, 5.2619047619047615e-09],
    [0.75, 240619656.77016708, 4.333333333333333e-06, 5.2619047619047615e-09, 5.2619047619047615e-09, 5.2619047619047615e-09],
    [0.9, 365126480.68554664, 4.333333333333333e-06, 5.2619047619047615e-09, 5.2619047619047615e-09, 5.2619047619047615e-09],
    [0.95, 509703744.1251781, 4.333333333333333e-06, 5.2619047619047615e-09, 5.2619047619047615e-09, 5.2619047619047615e-09],
    [0.99, 1128219478.4201589, 4.333333333333333e-06, 5.2619047619047615e-09, 5.2619047619047615e-09, 5.2619047619047615e-09],
    [1.0, 0.0, 4.333333333333333e-06, 5.2619047619047615e-09, 5.2619047619047615e-09, 5.2619047619047615e-09],
    [1.05, 0.0, 3.4785693625729374e-06, 4.395640903753325e-09, 4.316727441244289e-09, 4.052313262495237e-09],
    [1.25, 0.0, 2.558116039274177e-06, 3.390034289088194e-09, 3.25959482606592e-09, 2.8225332348633785e-09],
    [2.0, 0.0, 1.4444444444444445e-06, 2.0099423839855146e-09, 1.892271666659171e-09, 1.4979941239509933e-09],
    [5.0, 0.0, 5.554832126911161e-07, 7.903559973082156e-10, 7.371043095203482e-10, 5.586746620844948e-10],
];
const ANGLES: [f64; 3] = [0.0, 0.5, FRAC_PI_2];

/// Columns: distance divided by the contact radius, and pressure, computed as in [`FLAT_PUNCH`].
const CONE_PRESSURE: [[f64; 2]; 7] = [
    [0.1, 1870764.278828988],
    [0.25, 1289648.1680597253],
    [0.5, 823098.6855780104],
    [0.75, 497103.413264941],
    [0.9, 291965.81756453874],
    [0.95, 201897.77454487706],
    [0.99, 88759.02546629818],
];

/// Columns: force divided by the friction limit, stick radius divided by contact radius, stick ratio and shift.
const CONE_PARTIAL_SLIP: [[f64; 4]; 6] = [
    [0.1, 0.9486832980505138, 0.9, 2.7286945795841224e-08],
    [0.2, 0.8944271909999159, 0.8, 5.613687955893348e-08],
    [0.4, 0.7745966692414834, 0.6, 1.1985510048295876e-07],
    [0.6, 0.6324555320336759, 0.4, 1.954366822877791e-07],
    [0.8, 0.4472135954999579, 0.2, 2.9393651741529413e-07],
    [0.95, 0.22360679774997896, 0.05, 4.128363363434745e-07],
];

/// Tractions at the distances of [`CONE_PRESSURE`], for each force of [`CONE_PARTIAL_SLIP`].
#[rustfmt::skip] // one row per line
const CONE_TRACTION: [[f64; 7]; 6] = [
    [6620.0317779015395, 6813.410989378136, 7674.208889227462,
        10332.123711074917, 17461.894733250447, 40379.554908975406, 17751.805093259634],
    [14025.262404287856, 14462.117775624185, 16440.965714876947,
        23040.042535673572, 58393.163512907755, 40379.554908975406, 17751.805093259634],
    [32137.042073079945, 33316.3099248907, 38971.7689057567, 67494.08116761378,
        58393.163512907755, 40379.554908975406, 17751.805093259634],
    [57743.16995724999, 60464.233858711144, 75531.17817368881,
        99420.68265298821, 58393.163512907755, 40379.554908975406, 17751.805093259634],
    [101868.8294781881, 109750.86221121992, 164619.7371156021,
        99420.68265298821, 58393.163512907755, 40379.554908975406, 17751.805093259634],
    [193698.42136844632, 257929.63361194506, 164619.7371156021,
        99420.68265298821, 58393.163512907755, 40379.554908975406, 17751.805093259634],
];

const CONE_FRICTION: f64 = 0.2;
const CONE_LOAD: f64 = 1e-3;

fn punch() -> Result<FlatPunch> {
    FlatPunch::new(&pair(210e9, 0.3)?, 1e-3, 1000.0)
}

fn cone() -> Result<Cone> {
    Cone::new(&rubber()?, 0.05, CONE_LOAD)
}

#[test]
fn flat_punch_matches_reference_values() -> Result<()> {
    let punch = punch()?;
    let a = punch.contact_radius();
    assert_close(punch.approach(), 4.333333333333333e-06);
    assert_close(punch.mean_pressure(), 318309886.1837907);
    assert_close(punch.contact_area() * punch.mean_pressure(), punch.load());
    let stick = punch.full_stick(FRICTION, -20.0)?;
    assert_close(stick.shift(), -20.0 * 5.2619047619047615e-09);
    for [ratio, pressure, normal, tangential @ ..] in FLAT_PUNCH {
        let r = ratio * a;
        assert_close(punch.pressure(r), pressure);
        assert_close(punch.displacement(r), normal);
        assert_close(stick.traction(r), -20.0 / 1000.0 * pressure);
        for (displacement, theta) in tangential.into_iter().zip(ANGLES) {
            // Rounding may move a point at the edge just outside the contact, where the slope is infinite.
            let r = if ratio > 1.0 { r } else { r * (1.0 - 1e-15) };
            let found = stick.displacement(r * theta.cos(), r * theta.sin());
            assert_close(found, -20.0 * displacement);
        }
    }
    Ok(())
}

#[test]
fn cone_matches_reference_values() -> Result<()> {
    let cone = cone()?;
    let a = cone.contact_radius();
    assert_close(a, 2.256758334191025e-05);
    assert_close(cone.approach(), 1.772453850905516e-06);
    assert_close(cone.mean_pressure(), 625e3);
    assert_close(cone.contact_area() * cone.mean_pressure(), CONE_LOAD);
    for [ratio, pressure] in CONE_PRESSURE {
        assert_close(cone.pressure(ratio * a), pressure);
    }
    for ([fraction, radius, stick, shift], tractions) in CONE_PARTIAL_SLIP.iter().zip(CONE_TRACTION)
    {
        let shear =
            ConePartialSlip::new(cone, CONE_FRICTION, fraction * CONE_FRICTION * CONE_LOAD)?;
        assert_close(shear.stick_radius(), radius * a);
        assert_close(shear.stick_ratio(), *stick);
        assert_close(shear.shift(), *shift);
        for ([ratio, _], traction) in CONE_PRESSURE.iter().zip(tractions) {
            assert_close(shear.traction(ratio * a), traction);
        }
    }
    Ok(())
}

#[test]
fn stress_integrates_to_the_force() -> Result<()> {
    let (cone, punch) = (cone()?, punch()?);
    let a = cone.contact_radius();
    let load = singular_integral(0.0, a, |r| 2.0 * PI * r * cone.pressure(r));
    assert_close(load, CONE_LOAD);
    for fraction in [1e-3, 0.4, 0.95, 1.0] {
        let force = fraction * CONE_FRICTION * CONE_LOAD;
        let shear = ConePartialSlip::new(cone, CONE_FRICTION, force)?;
        let c = shear.stick_radius();
        let ring = |r: f64| 2.0 * PI * r * shear.traction(r);
        let carried = singular_integral(0.0, c, ring) + singular_integral(c, a, ring);
        // In the slip ring, r < a holds only up to rounding.
        assert_relative_eq!(carried, force, max_relative = 1e-10, epsilon = 0.0);
    }
    // Every chord of the punch carries W/2a. The substitution l = L sin t removes the pole at the ends of the chord,
    // and the midpoint rule avoids the ends.
    let a = punch.contact_radius();
    for d in [0.0, 0.5 * a, 0.99 * a] {
        let half = ((a - d) * (a + d)).sqrt();
        let along = |t: f64| punch.pressure(d.hypot(half * t.sin())) * half * t.cos();
        let step = PI / 100.0;
        let chord: f64 = (0..50).map(|i| along(step * (f64::from(i) + 0.5))).sum();
        assert_relative_eq!(2.0 * step * chord, 1000.0 / (2.0 * a), max_relative = 1e-10);
    }
    Ok(())
}

/// Integrates Boussinesq's kernel along chords, independently of all formulas for `u_z`.
#[test]
fn displacement_matches_integral_of_pressure() -> Result<()> {
    let cone = cone()?;
    let a = cone.contact_radius();
    for ratio in [0.0, 0.3, 0.8, 1.0, 1.01, 1.5, 10.0] {
        let r = ratio * a;
        let sum = sum_over_chords(a, r, |d, _| chord_integral(d, a, d, |r| cone.pressure(r)));
        let expected = sum / (PI * cone.pair().contact_modulus());
        assert_relative_eq!(
            cone.displacement(r),
            expected,
            max_relative = 1e-10,
            epsilon = 0.0
        );
        assert_relative_eq!(
            cone.gap(r),
            cone.displacement(r) + cone.slope() * r - cone.approach(),
            max_relative = 1e-12,
            epsilon = 1e-14 * cone.approach() * (1.0 + ratio)
        );
    }
    // Every chord of a flat punch carries the same load.
    let punch = punch()?;
    let a = punch.contact_radius();
    for ratio in [0.0, 0.5, 1.0, 1.2, 7.0] {
        let sum = sum_over_chords(a, ratio * a, |_, _| punch.load() / (2.0 * a));
        let expected = sum / (PI * punch.pair().contact_modulus());
        assert_close(punch.displacement(ratio * a), expected);
    }
    Ok(())
}

/// Integrates Cerruti's kernel along chords: throughout the stick zone of the closed form, the displacement equals the
/// shift.
#[test]
fn tangential_displacement_matches_integral_of_traction() -> Result<()> {
    let nu = 0.3;
    let pair = pair(210e9, nu)?;
    let kernel = |angle: f64| {
        (1.0 - nu + nu * angle.cos().powi(2)) / (2.0 * PI * pair.equivalent_shear_modulus())
    };
    let cone = Cone::new(&pair, 0.02, 10.0)?;
    let a = cone.contact_radius();
    for force in [-4.0, 0.5, 4.9] {
        let shear = ConePartialSlip::new(cone, FRICTION, force)?;
        let c = shear.stick_radius();
        let at = |r: f64, theta: f64| {
            sum_over_chords(a, r, |d, t| {
                kernel(theta + t) * chord_integral(c.max(d), a, d, |r| shear.traction(r))
            })
        };
        for (ratio, theta) in [(0.0, 0.0), (0.5, 0.3), (0.9, 2.0)] {
            let found = at(ratio * c, theta);
            assert_relative_eq!(found, shear.shift(), max_relative = 1e-9, epsilon = 0.0);
        }
        // Outside the stick zone, the displacement is smaller than the shift.
        assert!(at(0.5 * (a + c), 0.0) / shear.shift() < 1.0);
    }
    let stick = MindlinFullStick::new(&pair, 1e-3, 7.0)?;
    let a = stick.contact_radius();
    for (ratio, theta) in [
        (0.0, 0.0),
        (0.7, 1.0),
        (1.1, 0.0),
        (1.5, 0.8),
        (4.0, FRAC_PI_2),
    ] {
        let r = ratio * a;
        let expected = sum_over_chords(a, r, |_, t| kernel(theta + t) * 7.0 / (2.0 * a));
        let found = stick.displacement(r * f64::cos(theta), r * f64::sin(theta));
        assert_close(found, expected);
    }
    Ok(())
}

/// For very large friction, partial slip tends to full stick.
#[test]
fn full_stick_is_the_limit_for_large_friction() -> Result<()> {
    let ball = ball()?;
    let stick = MindlinFullStick::new(&steel()?, ball.contact_radius(), 20.0)?;
    let shear = CattaneoMindlin::new(ball, 1e5, 20.0)?;
    let cone = Cone::new(&steel()?, 0.05, 100.0)?;
    let cone_stick = MindlinFullStick::new(&steel()?, cone.contact_radius(), 20.0)?;
    let cone_shear = ConePartialSlip::new(cone, 1e5, 20.0)?;
    let near = |found: f64, expected: f64| {
        assert_relative_eq!(found, expected, max_relative = 1e-5, epsilon = 0.0);
    };
    near(shear.shift(), stick.shift());
    near(cone_shear.shift(), cone_stick.shift());
    for ratio in [0.0, 0.5, 0.9] {
        let r = ratio * ball.contact_radius();
        near(shear.traction(r), stick.traction(r));
        near(
            shear.displacement(3.0 * r, r),
            stick.displacement(3.0 * r, r),
        );
        let r = ratio * cone.contact_radius();
        near(cone_shear.traction(r), cone_stick.traction(r));
    }
    Ok(())
}

#[test]
fn far_displacement_matches_point_force() -> Result<()> {
    let (cone, punch) = (cone()?, punch()?);
    let far = 1e7 * cone.contact_radius();
    let unit = CONE_LOAD / (PI * cone.pair().contact_modulus() * far);
    assert_close(cone.displacement(far), unit);
    let far = 1e7 * punch.contact_radius();
    let unit = 1000.0 / (PI * punch.pair().contact_modulus() * far);
    assert_close(punch.displacement(far), unit);
    let stick = punch.full_stick(FRICTION, 20.0)?;
    let unit = 20.0 / (2.0 * PI * punch.pair().equivalent_shear_modulus() * far);
    assert_close(stick.displacement(far, 0.0), unit);
    assert_close(stick.displacement(0.0, -far), 0.7 * unit);
    Ok(())
}

#[test]
fn zero_force_gross_slip_and_edges_are_exact() -> Result<()> {
    let cone = cone()?;
    let a = cone.contact_radius();
    let limit = FRICTION * CONE_LOAD;
    let shear = |friction, force| ConePartialSlip::new(cone, friction, force);
    let still = shear(FRICTION, 0.0)?;
    assert_close(still.stick_radius(), a);
    let smooth = shear(0.0, 0.0)?;
    assert_close(smooth.stick_ratio(), 0.0);
    for r in [0.0, 0.5 * a, a, 2.0 * a] {
        assert_close(still.traction(r), 0.0);
        assert_close(smooth.traction(r), 0.0);
    }
    let sliding = shear(FRICTION, -limit)?;
    assert_close(sliding.stick_ratio(), 0.0);
    assert_close(sliding.shift(), -sliding.sliding_shift());
    assert_close(
        sliding.traction(0.3 * a),
        -FRICTION * cone.pressure(0.3 * a),
    );
    assert!(cone.pressure(0.0).is_infinite());
    // At the apex the pressure and the pressure subtracted from it are infinite. Their difference is a logarithm.
    let forth = shear(FRICTION, 0.3 * limit)?;
    let c = forth.stick_radius();
    assert_close(forth.traction(0.0), FRICTION * 625e3 * (a / c).ln());
    // For small forces, the traction is accurate and equals the traction of full stick.
    let small = shear(FRICTION, 1e-14 * limit)?;
    let stick = MindlinFullStick::new(cone.pair(), a, 1e-14 * limit)?;
    assert_close(small.shift(), stick.shift());
    assert_close(small.traction(0.6 * a), stick.traction(0.6 * a));
    // Outside the contact all stresses are zero, and at the edge they are finite.
    let punch = punch()?;
    let b = punch.contact_radius();
    for r in [b, 1.5 * b, -2.0 * b] {
        assert_close(punch.pressure(r), 0.0);
        assert_close(cone.pressure(r), 0.0);
    }
    assert_close(punch.full_stick(0.0, 0.0)?.traction(0.5 * b), 0.0);
    Ok(())
}

proptest! {
    #[test]
    fn traction_satisfies_the_friction_law(
        fraction in -1.0..1.0_f64, more in 0.0..1.0_f64, ratio in 0.0..1.2_f64,
    ) {
        let build = || -> Result<_> {
            let (cone, limit) = (cone()?, FRICTION * CONE_LOAD);
            // The second force has the same sign and is closer to sliding.
            let greater = fraction + more * (fraction.signum() - fraction);
            let one = ConePartialSlip::new(cone, FRICTION, fraction * limit)?;
            Ok((one, ConePartialSlip::new(cone, FRICTION, greater * limit)?))
        };
        let (shear, greater) = build().map_err(|e| TestCaseError::fail(e.to_string()))?;
        let cone = shear.cone();
        let r = ratio * cone.contact_radius();
        let bound = FRICTION * cone.pressure(r);
        let traction = shear.traction(r);
        prop_assert!(traction.abs() <= bound * (1.0 + 1e-13));
        prop_assert!(traction * shear.force() >= 0.0);
        if r > shear.stick_radius() {
            assert_close(traction.abs(), bound);
        }
        prop_assert!(greater.stick_radius() <= shear.stick_radius());
        prop_assert!(greater.shift().abs() >= shear.shift().abs());
        prop_assert!(greater.traction(r).abs() >= traction.abs() * (1.0 - 1e-13));
    }
}
