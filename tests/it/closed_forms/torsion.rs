//! A sphere under a twist.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use stickslip::analytical::{HertzSphere, LubkinTorsion};
use stickslip::{ElasticPair, Material, Result};

use super::{
    FRICTION, assert_close, ball, chord_integral, singular_integral, steel, sum_over_chords,
};

/// Columns: the stick radius divided by the contact radius, the dimensionless twist and the dimensionless moment. The
/// twist is multiplied by the shear modulus and divided by the friction limit at the largest pressure. The moment is
/// divided by the product of friction, load and contact radius. The values follow from Lubkin's relations. They were
/// evaluated to 20 digits in extended precision, independently of this crate, and rounded to double.
const TORSION: [[f64; 3]; 5] = [
    [0.1, 1.3398219089823253, 0.5886198850944907],
    [0.3, 0.7656479073460584, 0.5768680425718781],
    [0.5, 0.47272980996559183, 0.5285759655649621],
    [0.7, 0.25852427848237813, 0.40973847957115656],
    [0.9, 0.08066327969565987, 0.17634538145161682],
];

/// Twists the steel ball. `strain` is the twist divided by the ratio of the friction limit at the largest pressure to
/// the shear modulus.
fn twist_ball(strain: f64) -> Result<LubkinTorsion> {
    let ball = ball()?;
    let unit = FRICTION * ball.max_pressure() / steel()?.equivalent_shear_modulus();
    LubkinTorsion::new(ball, FRICTION, strain * unit)
}

#[test]
fn torsion_matches_reference_values() -> Result<()> {
    let a = ball()?.contact_radius();
    let unit = FRICTION * 100.0 * a;
    for [ratio, strain, moment] in TORSION {
        for sign in [1.0, -1.0] {
            let torsion = twist_ball(sign * strain)?;
            assert_close(torsion.stick_radius(), ratio * a);
            assert_close(torsion.stick_ratio(), ratio * ratio);
            assert_close(torsion.moment(), sign * moment * unit);
            assert_close(torsion.sliding_moment(), 0.5890486225480862 * unit);
        }
    }
    Ok(())
}

#[test]
fn traction_integrates_to_the_moment() -> Result<()> {
    let ball = ball()?;
    let a = ball.contact_radius();
    for strain in [-1e-3, 0.05, 0.3, 1.0, 3.0] {
        let torsion = twist_ball(strain)?;
        let c = torsion.stick_radius();
        let arm = |r: f64| torsion.traction(r) * 2.0 * PI * r * r;
        let moment = singular_integral(0.0, c, arm) + singular_integral(c, a, arm);
        assert_relative_eq!(
            moment,
            torsion.moment(),
            max_relative = 1e-10,
            epsilon = 0.0
        );
        for i in 1..100 {
            let r = a * f64::from(i) / 100.0;
            let ratio = torsion.traction(r) / (FRICTION * ball.pressure(r)) * strain.signum();
            assert!(ratio > 0.0 && ratio <= 1.0 + 1e-14);
            assert_eq!(ratio < 1.0 - 1e-9, r < c);
        }
        assert_close(torsion.traction(0.0), 0.0);
        assert_close(torsion.traction(1.01 * a), 0.0);
        let (below, above) = (torsion.traction(c * (1.0 - 1e-12)), torsion.traction(c));
        assert_relative_eq!(below, above, max_relative = 1e-4, epsilon = 0.0);
    }
    Ok(())
}

/// Integrates Cerruti's kernel along chords, in which Poisson's ratio cancels. A ring rotates by the twist if it
/// sticks, and by less if it slips.
#[test]
fn stick_disc_rotates_by_the_twist() -> Result<()> {
    let rubber = Material::new(3e6, 0.5)?;
    let unlike = ElasticPair::new(Material::new(213e9, 0.1)?, rubber)?;
    let unlike_ball = HertzSphere::new(&unlike, 3.5e-3, 1e-3)?;
    let torsions = [
        LubkinTorsion::new(unlike_ball, 0.5, -0.2)?,
        twist_ball(1.0)?,
        twist_ball(0.05)?,
    ];
    for torsion in &torsions[..kit::thorough(1, 3)] {
        let (a, c) = (torsion.hertz().contact_radius(), torsion.stick_radius());
        let shear_modulus = torsion.hertz().pair().equivalent_shear_modulus();
        let rotation = |r: f64| {
            let sum = sum_over_chords(a, r, |d, t| {
                let along = chord_integral(c.max(d), a, d, |r| torsion.traction(r) / r);
                t.sin().powi(2) * along
            });
            sum / (2.0 * PI * shear_modulus)
        };
        for ratio in kit::thorough(&[0.5][..], &[0.1, 0.5, 0.9]) {
            let found = rotation(ratio * c);
            assert_relative_eq!(found, torsion.twist(), max_relative = 1e-9, epsilon = 0.0);
        }
        let slipping = rotation(0.5 * (a + c)) / torsion.twist();
        assert!(slipping > 0.0 && slipping < 1.0 - 1e-4, "{slipping}");
    }
    Ok(())
}

#[test]
fn small_and_large_twists_are_accurate() -> Result<()> {
    let ball = ball()?;
    let (a, shear_modulus) = (ball.contact_radius(), steel()?.equivalent_shear_modulus());
    let small = twist_ball(1e-13)?;
    let stiffness = 16.0 / 3.0 * shear_modulus * a.powi(3);
    assert_close(small.moment(), stiffness * small.twist());
    // This is the traction of a disc in full stick.
    for ratio in [0.1_f64, 0.6, 0.95] {
        let root = (1.0 - ratio * ratio).sqrt();
        let expected = 4.0 * shear_modulus * small.twist() / PI * ratio / root;
        assert_relative_eq!(small.traction(ratio * a), expected, max_relative = 2e-12);
    }
    // K - E is ln(4 a/c) - 1 for a small stick disc.
    for strain in [20.0, 300.0] {
        let large = twist_ball(strain)?;
        let expected = (2.0 * strain + 1.0 - 4.0_f64.ln()).exp().recip();
        assert_relative_eq!(large.stick_radius() / a, expected, max_relative = 1e-12);
        assert_close(large.moment(), large.sliding_moment());
    }
    // The derivative of the moment is the stiffness of a disc in full stick with the present stick radius.
    let (below, above) = (twist_ball(0.2 - 1e-5)?, twist_ball(0.2 + 1e-5)?);
    let slope = (above.moment() - below.moment()) / (above.twist() - below.twist());
    let stuck = 16.0 / 3.0 * shear_modulus * twist_ball(0.2)?.stick_radius().powi(3);
    assert_relative_eq!(slope, stuck, max_relative = 1e-8);
    let still = twist_ball(0.0)?;
    assert_close(still.moment(), 0.0);
    assert_close(still.stick_radius(), a);
    assert_close(still.traction(0.7 * a), 0.0);
    Ok(())
}
