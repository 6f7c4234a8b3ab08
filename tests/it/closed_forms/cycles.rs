//! A sphere under an oscillating tangential force.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

use approx::assert_relative_eq;
use proptest::prelude::*;
use stickslip::Result;
use stickslip::analytical::MindlinDeresiewicz;

use super::{FRICTION, LIMIT, assert_close, ball, disc_integral, integral, sheared_ball};

/// Returns the ball after a sequence of forces, given as fractions of the friction limit.
fn after_path(path: &[f64]) -> Result<MindlinDeresiewicz> {
    let forces: Vec<f64> = path.iter().map(|part| part * LIMIT).collect();
    MindlinDeresiewicz::new(ball()?, FRICTION, &forces)
}

/// The header of the file states the case and its source.
const UNLOADING: &str = include_str!("../../data/unloading.csv");

/// Force as a fraction of the friction limit, and energy per cycle.
const CYCLES: [[f64; 2]; 3] = [
    [0.4, 1.9278027314025586e-06],
    [0.8, 2.62446228167928e-05],
    [1.0, 0.00011841904562427609],
];

/// Checks equality up to the round-off of a sum with terms of size up to `scale`.
#[track_caller]
fn assert_near(found: f64, expected: f64, scale: f64) {
    assert_relative_eq!(found, expected, max_relative = 0.0, epsilon = 1e-14 * scale);
}

#[test]
fn unloading_and_reloading_match_reference_values() -> Result<()> {
    let ball = ball()?;
    let (a, mu_p0) = (ball.contact_radius(), FRICTION * ball.max_pressure());
    let mut lines = UNLOADING.lines().filter(|line| !line.starts_with('#'));
    let heading = lines.next().unwrap().split(',').skip(4);
    let distances: Vec<f64> = heading.map(|word| word.parse().unwrap()).collect();
    let mut cases = 0;
    for line in lines {
        let numbers: Vec<f64> = line.split(',').map(|word| word.parse().unwrap()).collect();
        let [from, to, shift, stick, ref tractions @ ..] = numbers[..] else {
            panic!("{line}");
        };
        let unloaded = after_path(&[from, to])?;
        // Reloading follows the unloading path with opposite sign.
        let reloaded = after_path(&[from, -from, -to])?;
        for (contact, sign) in [(&unloaded, 1.0), (&reloaded, -1.0)] {
            assert_close(contact.force(), sign * to * LIMIT);
            assert_close(contact.amplitude(), from * LIMIT);
            assert_close(contact.stick_radius(), stick * a);
            assert_near(contact.shift(), sign * shift, contact.sliding_shift());
            for (ratio, traction) in distances.iter().zip(tractions) {
                let found = contact.traction(ratio * a);
                assert_near(found, sign * traction * mu_p0, mu_p0);
            }
        }
        cases += 1;
    }
    assert_eq!(cases, 12);
    for [part, energy] in CYCLES {
        assert_close(after_path(&[part])?.energy_per_cycle(), energy);
        // This is Johnson's form, which the crate factorises.
        let s = 1.0 - part;
        let bracket = 1.0 - s.powf(5.0 / 3.0) - 5.0 * s.powf(2.0 / 3.0) + 5.0 * s;
        let scale = LIMIT * sheared_ball(LIMIT)?.shift();
        assert_relative_eq!(energy, 0.8 * scale * bracket, max_relative = 1e-13);
    }
    Ok(())
}

#[test]
fn energy_of_small_cycles_is_accurate() -> Result<()> {
    let scale = LIMIT * sheared_ball(LIMIT)?.shift();
    for part in [1e-3_f64, 1e-6, 1e-9] {
        let series = 4.0 / 27.0 * part.powi(3) * (1.0 + 2.0 / 3.0 * part);
        let found = after_path(&[part])?.energy_per_cycle() / scale;
        assert_relative_eq!(
            found,
            series,
            max_relative = 2.0 * part * part + 1e-13,
            epsilon = 0.0
        );
    }
    Ok(())
}

/// On first loading the result agrees with Cattaneo and Mindlin, for any number of steps.
#[test]
fn first_loading_matches_cattaneo_mindlin() -> Result<()> {
    let a = ball()?.contact_radius();
    let unloaded = after_path(&[])?;
    assert_close(unloaded.shift(), 0.0);
    assert_close(unloaded.traction(0.3 * a), 0.0);
    assert_close(unloaded.stick_radius(), a);
    assert_close(unloaded.energy_per_cycle(), 0.0);
    let shear = sheared_ball(-30.0)?;
    for path in [&[-0.6][..], &[0.0, -0.6], &[-0.1, -0.2, -0.2, -0.6, -0.6]] {
        let contact = after_path(path)?;
        assert_close(contact.shift(), shear.shift());
        assert_close(contact.stick_radius(), shear.stick_radius());
        assert_close(contact.traction(0.4 * a), shear.traction(0.4 * a));
        let (x, y) = (0.6 * a, 0.7 * a);
        assert_close(contact.displacement(x, y), shear.displacement(x, y));
        assert_close(contact.slip(x, y), shear.slip(x, y));
        assert_close(
            contact.displacement(y, 2.0 * x),
            shear.displacement(y, 2.0 * x),
        );
        assert_close(contact.dissipated_energy(), shear.energy_of_first_quarter());
    }
    Ok(())
}

/// A closed loop affects only the dissipated energy.
#[test]
fn closed_loops_leave_only_their_dissipation() -> Result<()> {
    let a = ball()?.contact_radius();
    let loop_energy = |half_range: f64| after_path(&[half_range]).unwrap().energy_per_cycle();
    // A path, the same path without its closed loops, and the half ranges of these loops.
    #[rustfmt::skip] // one row per line
    let cases = [
        (&[0.5, 0.1, 0.5][..], &[0.5][..], &[0.2][..]),
        (&[0.5, 0.1, 0.7], &[0.7], &[0.2]),
        (&[0.8, -0.4, 0.2, -0.4], &[0.8, -0.4], &[0.3]),
        (&[0.8, -0.4, 0.2, -0.1, 0.2, -0.6], &[0.8, -0.6], &[0.15, 0.3]),
        (&[0.8, -0.4, 0.2, -0.1, 0.1], &[0.8, -0.4, 0.2, -0.1, 0.1], &[]),
    ];
    for (path, rest, half_ranges) in cases {
        let (long, short) = (after_path(path)?, after_path(rest)?);
        assert_near(long.shift(), short.shift(), short.sliding_shift());
        assert_close(long.stick_radius(), short.stick_radius());
        for i in 0..20 {
            let r = a * f64::from(i) / 20.0;
            assert_near(long.traction(r), short.traction(r), ball()?.max_pressure());
            assert_near(long.slip(r, 0.0), short.slip(r, 0.0), short.sliding_shift());
        }
        let closed: f64 = half_ranges.iter().copied().map(loop_energy).sum();
        let expected = short.dissipated_energy() + closed;
        assert_relative_eq!(
            long.dissipated_energy(),
            expected,
            max_relative = 1e-12,
            epsilon = 0.0
        );
    }
    // After a full reversal the contact equals the contact after first loading in that direction.
    let (turned, loaded) = (after_path(&[0.7, -0.7])?, after_path(&[-0.7])?);
    assert_close(turned.shift(), loaded.shift());
    assert_close(turned.traction(0.9 * a), loaded.traction(0.9 * a));
    let tripled = 3.0 * loaded.dissipated_energy();
    assert_close(turned.dissipated_energy(), tripled);
    // The dissipation also adds up over a hundred cycles.
    let many: Vec<f64> = (0..=200)
        .map(|i| if i % 2 == 0 { 0.7 } else { -0.7 })
        .collect();
    let cycled = after_path(&many)?;
    let expected = loaded.dissipated_energy() + 100.0 * loaded.energy_per_cycle();
    assert_relative_eq!(cycled.dissipated_energy(), expected, max_relative = 1e-13);
    Ok(())
}

/// The dissipation of a cycle equals the area of its loop of force over shift.
#[test]
fn cycle_energy_equals_loop_area() -> Result<()> {
    for part in [0.3, 0.9] {
        let unloading = |force: f64| after_path(&[part, force]).unwrap().shift();
        let area = integral(-part, part, |force| {
            let reloading = -unloading(-force);
            LIMIT * (unloading(force) - reloading)
        });
        let energy = after_path(&[part])?.energy_per_cycle();
        assert_relative_eq!(area, energy, max_relative = 1e-10, epsilon = 0.0);
    }
    Ok(())
}

/// On each segment of the path, the dissipation is the traction in the slip ring times the slip increment.
#[test]
fn energy_increment_equals_traction_times_slip() -> Result<()> {
    let a = ball()?.contact_radius();
    let path = [0.8, -0.4, 0.3, 0.1];
    for turns in 1..path.len() {
        let (before, now) = (after_path(&path[..turns])?, after_path(&path[..=turns])?);
        // The mean over all directions is the value at 45 degrees.
        let work = disc_integral(now.stick_radius(), a, |r| {
            let along = r * FRAC_1_SQRT_2;
            let gained = now.slip(along, along) - before.slip(along, along);
            -now.traction(r) * gained
        });
        let gained = now.dissipated_energy() - before.dissipated_energy();
        assert_relative_eq!(work, gained, max_relative = 1e-8, epsilon = 0.0);
    }
    Ok(())
}

/// Integrates the traction after three reversals, each of which leaves a kink.
#[test]
fn traction_integrates_to_the_force() -> Result<()> {
    let a = ball()?.contact_radius();
    let contact = after_path(&[0.8, -0.4, 0.3])?;
    let mut carried = 0.0;
    let mut from = 0.0;
    for half_range in [0.8, 0.6, 0.35, 0.0_f64] {
        let edge = a * (1.0 - half_range).cbrt();
        // r = R sin t removes the square root at the edge.
        carried += integral((from / edge).asin(), FRAC_PI_2, |t| {
            let r = edge * t.sin();
            contact.traction(r) * 2.0 * PI * r * edge * t.cos()
        });
        from = edge;
    }
    assert_relative_eq!(carried, 0.3 * LIMIT, max_relative = 1e-9, epsilon = 0.0);
    Ok(())
}

#[test]
fn gross_slip_erases_the_load_history() -> Result<()> {
    let a = ball()?.contact_radius();
    let sliding = after_path(&[0.8, -0.5, 0.2, 1.0])?;
    assert_close(sliding.stick_radius(), 0.0);
    assert_close(sliding.shift(), sheared_ball(LIMIT)?.shift());
    for ratio in [0.1, 0.9] {
        assert_close(
            sliding.traction(ratio * a),
            FRICTION * ball()?.pressure(ratio * a),
        );
    }
    let back = after_path(&[0.8, 1.0, -1.0])?;
    assert_close(back.shift(), -sliding.shift());
    Ok(())
}

proptest! {
    /// For any path, the traction is within the friction limit and at the limit throughout the slip ring. The disc that
    /// has never slipped moves as a rigid body.
    #[test]
    fn any_path_satisfies_the_friction_law(path in proptest::collection::vec(-1.0..1.0_f64, 1..12)) {
        let (ball, contact) = (ball().unwrap(), after_path(&path).unwrap());
        let a = ball.contact_radius();
        let c = contact.stick_radius();
        for i in 0..40 {
            let r = a * f64::from(i) / 40.0;
            let ratio = contact.traction(r).abs() / (FRICTION * ball.pressure(r));
            prop_assert!(ratio <= 1.0 + 1e-12);
            prop_assert!(r <= c || ratio >= 1.0 - 1e-12);
        }
        let never = 0.999 * sheared_ball(contact.amplitude()).unwrap().stick_radius();
        for angle in [0.0_f64, 0.8, 2.0] {
            let (x, y) = (never * angle.cos(), never * angle.sin());
            assert_near(contact.slip(x, y), 0.0, contact.sliding_shift());
            assert_near(contact.displacement(x, y), contact.shift(), contact.sliding_shift());
        }
        prop_assert!(contact.dissipated_energy() > 0.0);
        prop_assert!((contact.force() - path[path.len() - 1] * LIMIT).abs() <= 0.0);
    }
}
