//! Cylinders in plane strain: energies of partial slip under bulk stress, and stresses in the bodies, compared with
//! quadrature of independent expressions.

use super::*;
use stickslip::analytical::{
    CattaneoMindlinEllipse, CattaneoMindlinLine, HertzEllipse, HertzLine, MindlinDeresiewicz,
};

const LOAD: f64 = 100.0;
const DATUM: f64 = 50.0;

/// Returns a steel roller of radius 10 mm under 100 N/mm, in the units mm, N and MPa.
fn roller() -> Result<HertzLine> {
    HertzLine::new(&pair(210e3, 0.3)?, 10.0, LOAD)
}

/// Shears the roller by a fraction of the friction limit, with the stick strip shifted by `moved` half-widths.
fn shear_roller(part: f64, moved: f64) -> Result<CattaneoMindlinLine> {
    let hertz = roller()?;
    let shear = CattaneoMindlinLine::new(hertz, FRICTION, part * FRICTION * LOAD)?;
    shear.with_bulk_stress([4.0 * FRICTION * hertz.max_pressure() * moved, 0.0])
}

/// Integrates over the contact. The integrand may have square-root singularities at the edges of the contact and of the
/// stick strip.
fn integrate_over_contact(shear: &CattaneoMindlinLine, integrand: impl Fn(f64) -> f64) -> f64 {
    let (a, c, e) = (
        shear.hertz().half_width(),
        shear.stick_half_width(),
        shear.stick_centre(),
    );
    let ends = [-a, e - c, e + c, a];
    let parts = ends.windows(2);
    parts
        .map(|ends| singular_integral(ends[0], ends[1], &integrand))
        .sum()
}

/// Returns the displacement along x by superposition of line loads, with a logarithmic kernel.
fn displacement(shear: &CattaneoMindlinLine, x: f64) -> f64 {
    let hertz = shear.hertz();
    let a = hertz.half_width();
    let (c, e) = (shear.stick_half_width(), shear.stick_centre());
    let mut ends = [-a, e - c, e + c, a, x];
    ends.sort_by(f64::total_cmp);
    let parts = ends.windows(2).map(|ends| {
        singular_integral(ends[0], ends[1], |s| {
            let distance = (x - s).abs().max(1e-300);
            -shear.traction(s) * (distance / DATUM).ln()
        })
    });
    2.0 / PI / hertz.pair().contact_modulus() * parts.sum::<f64>()
}

/// In the stick strip, displacement and strain add up to the shift. In the slip zones the slip is the difference, and
/// friction does work on this slip.
#[test]
fn shift_and_energy_under_bulk_stress_match_the_slip() -> Result<()> {
    for (part, moved) in [
        (0.6, 0.1238),
        (0.6, -0.2),
        (0.3, 0.15),
        (-0.8, 0.35),
        (0.9, 0.0),
    ] {
        let shear = shear_roller(part, moved)?;
        let hertz = shear.hertz();
        let (a, e, c) = (
            hertz.half_width(),
            shear.stick_centre(),
            shear.stick_half_width(),
        );
        assert_close(e, moved * a * part.signum());
        let steel = hertz.pair().bodies()[0];
        let strain = steel.plane_strain_under(4.0 * FRICTION * hertz.max_pressure() * moved);
        let slip = |x: f64| displacement(&shear, x) + strain * x - shear.shift(DATUM);
        for inside in [-0.9, 0.0, 0.4] {
            let error = slip(e + inside * c) / shear.shift(DATUM);
            assert!(error.abs() < 1e-9, "{part} {moved}: {error:e}");
        }
        let work = [[-a, e - c], [e + c, a]].map(|[from, to]| {
            singular_integral(from, to, |x| {
                assert!(shear.traction(x) * slip(x) <= 1e-12);
                -shear.traction(x) * slip(x)
            })
        });
        let quarter = shear.energy_of_first_quarter();
        assert_relative_eq!(work[0] + work[1], quarter, max_relative = 1e-6);
        assert_close(shear.energy_per_cycle(), 4.0 * quarter);
    }
    Ok(())
}

/// All closed forms use the same names for the energy of first loading and the energy of a cycle.
#[test]
fn cycle_energy_is_four_first_quarters() -> Result<()> {
    let shear = sheared_ball(30.0)?;
    assert_close(
        shear.energy_per_cycle(),
        4.0 * shear.energy_of_first_quarter(),
    );
    let round = HertzEllipse::new(&steel()?, 3.5e-3, 3.5e-3, 100.0)?;
    let round = CattaneoMindlinEllipse::new(round, FRICTION, 30.0)?;
    let quarter = shear.energy_of_first_quarter();
    assert_relative_eq!(
        round.energy_of_first_quarter(),
        quarter,
        max_relative = 1e-9
    );
    assert_relative_eq!(round.energy_per_cycle(), 4.0 * quarter, max_relative = 1e-9);
    let cycled = MindlinDeresiewicz::new(ball()?, FRICTION, &[30.0, -30.0, 30.0])?;
    assert_close(cycled.energy_per_cycle(), 4.0 * quarter);
    assert_close(cycled.dissipated_energy(), 5.0 * quarter);
    Ok(())
}

#[test]
fn coupled_bodies_and_excessive_strain_are_rejected() -> Result<()> {
    let unlike = ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?;
    let hertz = HertzLine::new(&unlike, 10.0, 0.01)?;
    let refused = CattaneoMindlinLine::new(hertz, FRICTION, 1e-3);
    assert!(
        matches!(refused, Err(Error::CoupledMaterials { beta, .. }) if beta == unlike.dundurs_beta())
    );
    // The limit of the shift is 1 - sqrt(1 - f). With more strain the stick strip would leave the contact.
    assert!(shear_roller(0.6, 0.3675).is_ok());
    kit::assert_refused! {
        shear_roller(0.6, 0.3676) => Error::BelowMinimum { .. },
        shear_roller(0.0, 1e-3) => Error::BelowMinimum { .. },
        shear_roller(0.6, 0.1)?.with_bulk_stress([f64::NAN, 0.0]) => Error::Sample { .. },
    }
    Ok(())
}

/// Returns the stresses `[xx, zz, xz]` at the depth z under line loads at `s` along z and along x. Sources: Flamant,
/// and Johnson (1985), 2.13-2.16.
fn stress_of_line_loads([p, q]: [f64; 2], s: f64, x: f64, z: f64) -> [f64; 3] {
    let (x, square) = (x - s, (x - s).powi(2) + z * z);
    let radial = -2.0 / PI * (p * z + q * x) / (square * square);
    [radial * x * x, radial * z * z, radial * x * z]
}

/// Stresses below the surface are the superposition of line loads. In body 2 the traction has the opposite sign.
#[test]
fn stresses_match_superposition_of_line_loads() -> Result<()> {
    for (part, moved) in [(0.6, 0.12), (-0.7, 0.2), (0.9, 0.0), (1.0, -0.3)] {
        let shear = shear_roller(part, moved)?;
        let hertz = shear.hertz();
        let (a, p0) = (hertz.half_width(), hertz.max_pressure());
        let bulk = 4.0 * FRICTION * p0 * moved;
        for x in [-3.0, -1.02, -0.8, -0.1, 0.0, 0.45, 1.0, 1.7] {
            for z in [0.3, 1.0, 4.0] {
                let (x, z) = (x * a, z * a);
                let of = |component: usize, side: f64| {
                    integrate_over_contact(&shear, |s| {
                        let loads = [hertz.pressure(s), side * shear.traction(s)];
                        stress_of_line_loads(loads, s, x, z)[component]
                    })
                };
                let [one, two] = shear.stress(x, z);
                for (k, found) in one.into_iter().enumerate() {
                    let expected = of(k, 1.0) + if k == 0 { bulk } else { 0.0 };
                    assert!(
                        (found - expected).abs() < 1e-7 * p0,
                        "{k} {found} {expected}"
                    );
                }
                for (k, found) in two.into_iter().enumerate() {
                    // In the frame of body 2, the z axis is reversed.
                    let expected = if k == 2 { -of(k, -1.0) } else { of(k, -1.0) };
                    assert!(
                        (found - expected).abs() < 1e-7 * p0,
                        "{k} {found} {expected}"
                    );
                }
            }
        }
    }
    Ok(())
}

/// On the surface, the stress components along z equal the tractions. Inside and outside the contact, the stress along
/// x is the principal value $`-\frac2\pi \int q(s)/(x-s)\,ds`$ minus the pressure.
#[test]
fn surface_stress_matches_the_principal_value() -> Result<()> {
    for (part, moved) in [(0.6, 0.12), (-0.7, 0.2), (0.9, 0.0)] {
        let shear = shear_roller(part, moved)?;
        let hertz = shear.hertz();
        let (a, p0) = (hertz.half_width(), hertz.max_pressure());
        let bulk = 4.0 * FRICTION * p0 * moved;
        for x in [-2.0, -1.01, -0.97, -0.4, 0.05, 0.3, 0.9, 1.3].map(|x| x * a) {
            // The traction at x is subtracted from the integrand. The principal value for this constant traction is a
            // logarithm.
            let here = shear.traction(x);
            let (c, e) = (shear.stick_half_width(), shear.stick_centre());
            let mut ends = vec![-a, e - c, e + c, a];
            if x.abs() < a {
                ends.push(x);
                ends.sort_by(f64::total_cmp);
            }
            let rest: f64 = ends
                .windows(2)
                .map(|ends| {
                    singular_integral(ends[0], ends[1], |s| {
                        if (s - x).abs() <= 0.0 {
                            0.0
                        } else {
                            (shear.traction(s) - here) / (x - s)
                        }
                    })
                })
                .sum();
            let value = rest + here * ((x + a) / (x - a)).abs().ln();
            let expected = bulk - hertz.pressure(x) - 2.0 / PI * value;
            let [found, of_two] = shear.surface_stress(x);
            assert!(
                (found - expected).abs() < 1e-6 * p0,
                "{x}: {found} {expected}"
            );
            let opposite = -hertz.pressure(x) + 2.0 / PI * value;
            assert!(
                (of_two - opposite).abs() < 1e-6 * p0,
                "{x}: {of_two} {opposite}"
            );
            let [[_, zz, xz], _] = shear.stress(x, 0.0);
            assert_eq!([-zz, -xz].map(|q| q == 0.0), [x.abs() >= a; 2]);
            assert!((zz + hertz.pressure(x)).abs() < 1e-13 * p0);
            assert!((xz + here).abs() < 1e-13 * p0);
        }
        // The largest tension occurs at the edge that the traction pulls away from.
        let edge = -a * part.signum();
        let [largest, _] = shear.surface_stress(edge);
        for k in -400..=400 {
            let [stress, _] = shear.surface_stress(a * f64::from(k) / 200.0);
            assert!(stress <= largest + 1e-9 * p0);
        }
        // In gross slip the tension results from the complete traction.
        let sliding = CattaneoMindlinLine::new(hertz, FRICTION, FRICTION * LOAD)?;
        assert_close(sliding.surface_stress(-a)[0], 2.0 * FRICTION * p0);
    }
    Ok(())
}

/// Functions of a depth above the surface and of a datum that is not positive have no value.
#[test]
fn values_outside_their_range_are_nan() -> Result<()> {
    let (hertz, shear) = (roller()?, shear_roller(0.5, 0.05)?);
    let is_nan = |stress: [f64; 3]| stress.iter().all(|part| part.is_nan());
    let is_finite = |stress: [f64; 3]| stress.iter().all(|part| part.is_finite());
    assert!(is_nan(hertz.stress(0.0, -1e-3)) && is_finite(hertz.stress(0.0, 0.0)));
    assert!(shear.stress(0.0, -1e-3).into_iter().all(is_nan));
    assert!(shear.stress(0.0, 0.0).into_iter().all(is_finite));
    for datum in [0.0, -DATUM] {
        assert!(hertz.approach(datum).is_nan() && shear.shift(datum).is_nan());
    }
    Ok(())
}
