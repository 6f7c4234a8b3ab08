//! The wavy surface: reference values and properties.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use proptest::prelude::*;
use stickslip::Result;
use stickslip::analytical::{Westergaard, WestergaardPartialSlip};

use super::{FRICTION, assert_close, rubber, singular_integral};

const AMPLITUDE: f64 = 1e-6;
const WAVELENGTH: f64 = 1e-4;
/// Mean pressure of full contact. Like all values in this file, it is the closed form evaluated in extended precision.
const FULL: f64 = 785398.1633974483;

/// Mean pressure divided by [`FULL`], half-width, contact fraction, and pressures at 0, 1/5 .. 5/5 of the half-width.
#[rustfmt::skip] // one row per line
const WAVES: [(f64, f64, f64, [f64; 6]); 3] = [
    (0.05, 7.178314656435313e-06, 0.14356629312870628, [351240.7365520363,
        343676.5098686153, 320169.53759359906, 277566.7570308437, 206189.7102989635, 0.0]),
    (0.3, 1.845050597827727e-05, 0.36901011956554536, [860360.5814318215,
        835312.2879903275, 760088.4201234346, 633189.7424683241, 444159.95494441956, 0.0]),
    (0.7, 3.154949402172273e-05, 0.6309898804344546, [1314222.4964558466,
        1252282.3390002481, 1075434.4498631752, 808492.1651622115, 483611.1191345562, 0.0]),
];

/// Mean pressures from light contact to three times full contact, relative to [`FULL`].
const RATIOS: [f64; 7] = [1e-3, 0.05, 0.5, 0.999, 1.0, 1.2, 3.0];

fn wavy_contact(ratio: f64) -> Result<Westergaard> {
    Westergaard::new(&rubber()?, AMPLITUDE, WAVELENGTH, ratio * FULL)
}

fn shear_waves(ratio: f64, fraction: f64) -> Result<WestergaardPartialSlip> {
    WestergaardPartialSlip::new(
        wavy_contact(ratio)?,
        FRICTION,
        fraction * FRICTION * ratio * FULL,
    )
}

/// Returns the displacement at `x` due to `stress` within the half-width `a` of each crest. The mean displacement is
/// zero. The kernel is the logarithmic kernel of a periodic half-space in plane strain.
fn displacement(a: f64, x: f64, kinks: &[f64], stress: impl Fn(f64) -> f64) -> Result<f64> {
    let kernel = |d: f64| -(2.0 * (PI * d / WAVELENGTH).sin().abs()).ln();
    let part = |side: f64| {
        // The ends are the distances of x, on either side, from the jumps of the stress or of its slope.
        let mut ends: Vec<f64> = kinks.iter().map(|kink| side * (kink - x)).collect();
        ends.extend([side * (-a - x), side * (a - x), 0.0]);
        ends.retain(|&d| d >= 0.0);
        ends.sort_by(f64::total_cmp);
        let pieces = ends.windows(2);
        pieces
            .map(|ends| singular_integral(ends[0], ends[1], |d| stress(x + side * d) * kernel(d)))
            .sum::<f64>()
    };
    Ok(2.0 * (part(1.0) + part(-1.0)) / (PI * rubber()?.contact_modulus()))
}

#[test]
fn waves_match_reference_values() -> Result<()> {
    for (ratio, half_width, fraction, pressures) in WAVES {
        let waves = wavy_contact(ratio)?;
        assert_close(waves.full_contact_pressure(), FULL);
        assert_close(waves.contact_half_width(), half_width);
        assert_close(waves.contact_fraction(), fraction);
        assert_close(waves.max_pressure(), pressures[0]);
        for (x, pressure) in [0.0, 0.2, 0.4, 0.6, 0.8].into_iter().zip(pressures) {
            for crest in [0.0, 3.0, -7.0] {
                let x = x * half_width + crest * WAVELENGTH;
                // The phase seven waves away is less accurate by one digit.
                let found = [waves.pressure(x), waves.pressure(-x)];
                assert_relative_eq!(found[0], pressure, max_relative = 1e-11);
                assert_relative_eq!(found[1], pressure, max_relative = 1e-11);
            }
        }
        // The square root at the edge halves the number of accurate digits.
        assert!(waves.pressure(half_width) < 1e-7 * FULL);
        assert_close(waves.pressure(1.001 * half_width), 0.0);
    }
    Ok(())
}

#[test]
fn pressure_integrates_to_the_load() -> Result<()> {
    for ratio in RATIOS {
        let waves = wavy_contact(ratio)?;
        let a = waves.contact_half_width();
        let load = singular_integral(-a, a, |x| waves.pressure(x));
        assert_relative_eq!(load / WAVELENGTH, ratio * FULL, max_relative = 1e-11);
    }
    Ok(())
}

#[test]
fn pressure_displacement_matches_gap_and_approach() -> Result<()> {
    for ratio in RATIOS {
        let waves = wavy_contact(ratio)?;
        let a = waves.contact_half_width();
        for x in [
            0.0,
            0.3 * a,
            0.95 * a,
            0.5 * (a + 0.5 * WAVELENGTH),
            0.5 * WAVELENGTH,
        ] {
            let initial = AMPLITUDE * (1.0 - (2.0 * PI * x / WAVELENGTH).cos());
            let moved = displacement(a, x, &[], |x| waves.pressure(x))?;
            assert_relative_eq!(
                initial + moved - waves.approach(),
                waves.gap(x),
                epsilon = 1e-10 * AMPLITUDE,
                max_relative = 0.0
            );
        }
        // The mean gap is the remaining distance between the mean planes.
        let half = 0.5 * WAVELENGTH;
        let mean = singular_integral(a.min(half), half, |x| waves.gap(x)) / half;
        assert_relative_eq!(
            mean,
            AMPLITUDE - waves.approach(),
            epsilon = 1e-12 * AMPLITUDE,
            max_relative = 1e-10
        );
    }
    Ok(())
}

#[test]
fn gap_near_the_edge_is_accurate() -> Result<()> {
    let waves = wavy_contact(0.3)?;
    let a = waves.contact_half_width();
    let slope = |x: f64| {
        let [sine, edge] = [x, a].map(|x| (PI * x / WAVELENGTH).sin());
        let root = ((sine - edge) * (sine + edge)).sqrt();
        4.0 * FULL / 25e6 * (PI * x / WAVELENGTH).cos() * root
    };
    for far in [1e-3, 0.1, 0.5] {
        let x = a + far * a;
        let expected = singular_integral(0.0, x - a, |d| slope(a + d));
        assert_relative_eq!(waves.gap(x), expected, max_relative = 1e-9, epsilon = 0.0);
    }
    assert_close(waves.gap(0.99 * a), 0.0);
    assert!(waves.gap(1.01 * a) > 0.0);
    Ok(())
}

/// A single crest is a cylinder of radius `lambda^2/(4 pi^2 Delta)`. With the load per length W, `a^2 = 4 W R/(pi E*)`
/// and `p_0 = 2 W/(pi a)`.
#[test]
fn light_loads_give_hertzian_line_contacts() -> Result<()> {
    let waves = wavy_contact(1e-12)?;
    let a = waves.contact_half_width();
    let load = waves.mean_pressure() * WAVELENGTH;
    let radius = WAVELENGTH * WAVELENGTH / (4.0 * PI * PI * AMPLITUDE);
    assert_relative_eq!(
        a * a,
        4.0 * load * radius / (PI * 25e6),
        max_relative = 1e-11,
        epsilon = 0.0
    );
    let peak = 2.0 * load / (PI * a);
    for ratio in [0.0_f64, 0.5, 0.9] {
        let expected = peak * (1.0 - ratio * ratio).sqrt();
        assert_relative_eq!(
            waves.pressure(ratio * a),
            expected,
            max_relative = 1e-11,
            epsilon = 0.0
        );
    }
    // Partial slip on the crests agrees with Cattaneo, c/a = (1 - f)^(1/2).
    assert_relative_eq!(
        shear_waves(1e-12, 0.75)?.stick_ratio(),
        0.5,
        max_relative = 1e-11
    );
    Ok(())
}

#[test]
fn full_contact_continues_partial_contact() -> Result<()> {
    let (below, above) = (wavy_contact(1.0 - 1e-13)?, wavy_contact(1.0 + 1e-13)?);
    assert!(!below.is_full_contact() && above.is_full_contact());
    assert_relative_eq!(below.contact_fraction(), 1.0, max_relative = 1e-6);
    assert_close(above.contact_half_width(), 0.5 * WAVELENGTH);
    for x in [0.0, 0.2, 0.4, 0.49] {
        let x = x * WAVELENGTH;
        assert_relative_eq!(below.pressure(x), above.pressure(x), max_relative = 1e-9);
    }
    let heavy = wavy_contact(2.5)?;
    for x in [0.0, 0.2, 0.5, 0.77] {
        let wave = (2.0 * PI * x).cos();
        assert_close(heavy.pressure(x * WAVELENGTH), FULL * (2.5 + wave));
        assert_close(heavy.gap(x * WAVELENGTH), 0.0);
    }
    assert_close(heavy.approach(), AMPLITUDE);
    Ok(())
}

#[test]
fn traction_integrates_to_the_force_and_stick_strips_are_rigid() -> Result<()> {
    for ratio in RATIOS {
        for fraction in [-0.3, 0.02, 0.6, 0.95, 1.0] {
            let shear = shear_waves(ratio, fraction)?;
            let contact = shear.contact();
            let (a, c) = (contact.contact_half_width(), shear.stick_half_width());
            let strips = [(-a, -c), (-c, c), (c, a)];
            let carried: f64 = strips
                .into_iter()
                .map(|(from, to)| singular_integral(from, to, |x| shear.traction(x)))
                .sum();
            let expected = shear.mean_traction();
            assert_relative_eq!(
                carried / WAVELENGTH,
                expected,
                max_relative = 1e-8,
                epsilon = 0.0
            );
            // The kernel along the waves equals the kernel of the pressure in plane strain.
            let moved = |x: f64| displacement(a, x, &[-c, c], |x| shear.traction(x));
            let (centre, scale) = (moved(0.0)?, FRICTION * AMPLITUDE);
            for x in [0.4 * c, 0.9 * c] {
                assert_relative_eq!(
                    moved(x)?,
                    centre,
                    epsilon = 1e-9 * scale,
                    max_relative = 0.0
                );
            }
            if c < 0.99 * a {
                // Outside the stick strips, the displacement is smaller than the shift.
                let lag = moved(0.5 * (a + c))? - centre;
                assert!(lag * shear.mean_traction() < 0.0);
            }
        }
    }
    Ok(())
}

#[test]
fn full_contact_sticks_until_the_difference_contact_opens() -> Result<()> {
    for x in [0.0, 0.3, 0.5] {
        let shear = shear_waves(2.0, 0.4)?;
        assert_close(shear.traction(x * WAVELENGTH), 0.4 * FRICTION * 2.0 * FULL);
        assert_close(shear.stick_ratio(), 1.0);
    }
    let shear = shear_waves(2.0, 0.75)?;
    assert_close(shear.stick_ratio(), 0.5);
    assert_close(
        shear.traction(0.4 * WAVELENGTH),
        FRICTION * shear.contact().pressure(0.4 * WAVELENGTH),
    );
    // Results for small forces are accurate.
    let small = shear_waves(0.3, 1e-14)?;
    let contact = small.contact();
    // The derivative of the pressure with respect to the load is the pressure under a row of flat strips.
    let (sine, cosine) = f64::sin_cos(0.1 * PI);
    let rate = cosine / (0.3 - sine * sine).sqrt();
    assert_close(
        small.traction(0.1 * WAVELENGTH),
        1e-14 * FRICTION * contact.mean_pressure() * rate,
    );
    // Covers zero force, gross slip, and zero friction.
    assert_close(shear_waves(0.3, 0.0)?.traction(0.0), 0.0);
    assert_close(shear_waves(0.3, 0.0)?.stick_ratio(), 1.0);
    let sliding = shear_waves(0.3, -1.0)?;
    assert_close(sliding.stick_half_width(), 0.0);
    assert_close(sliding.traction(0.0), -FRICTION * contact.max_pressure());
    let smooth = WestergaardPartialSlip::new(contact, 0.0, 0.0)?;
    assert_close(smooth.traction(0.0), 0.0);
    assert_close(smooth.stick_ratio(), 0.0);
    Ok(())
}

proptest! {
    #[test]
    fn contact_grows_with_load_and_stick_falls_with_force(
        ratio in 1e-6..3.0_f64, more in 1.0..2.0_f64, fractions in [-1.0..1.0_f64, 0.0..1.0],
        x in -0.5..0.5_f64,
    ) {
        let solve = || -> Result<_> {
            let greater = fractions[0].abs() + fractions[1] * (1.0 - fractions[0].abs());
            let shears = (shear_waves(ratio, fractions[0])?, shear_waves(ratio, greater)?);
            Ok((wavy_contact(ratio)?, wavy_contact(more * ratio)?, shears))
        };
        let (light, heavy, (shear, greater)) =
            solve().map_err(|e| TestCaseError::fail(e.to_string()))?;
        let x = x * WAVELENGTH;
        prop_assert!(heavy.contact_half_width() >= light.contact_half_width());
        prop_assert!(heavy.approach() >= light.approach() * (1.0 - 1e-14));
        prop_assert!(heavy.pressure(x) >= light.pressure(x) - 1e-13 * FULL);
        prop_assert!(heavy.gap(x) <= light.gap(x) + 1e-13 * AMPLITUDE);
        let bound = FRICTION * light.pressure(x) * (1.0 + 1e-12) + 1e-15 * FULL;
        prop_assert!(shear.traction(x).abs() <= bound);
        prop_assert!(shear.traction(x) * shear.mean_traction() >= 0.0);
        prop_assert!(greater.stick_ratio() <= shear.stick_ratio());
    }
}
