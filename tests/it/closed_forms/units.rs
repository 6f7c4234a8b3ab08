//! Closed forms do not depend on the system of units.

use approx::assert_relative_eq;
use proptest::prelude::*;
use stickslip::Result;
use stickslip::analytical::{
    CattaneoMindlin, CattaneoMindlinEllipse, Cone, ConePartialSlip, FlatPunch, HertzEllipse,
    HertzSphere, LubkinTorsion, MindlinDeresiewicz, Persson, PopovLimitingShape, RoughSphere,
    Westergaard, WestergaardPartialSlip,
};

use super::{FRICTION, LIMIT, assert_close, pair};

proptest! {
    /// Solves the same contact in different units. The units of length and force are smaller by the factors
    /// `length` and `force`.
    #[test]
    fn paraboloid_contacts_in_any_units_are_invariant(
        exponents in [-6.0..6.0_f64, -6.0..6.0],
        ratio in -3.0..3.0_f64,
        poisson_ratio in -0.5..0.5_f64,
        fraction in -1.0..1.0_f64,
        x in -2.0..2.0_f64,
        y in -2.0..2.0_f64,
    ) {
        let (length, force) = (10f64.powf(exponents[0]), 10f64.powf(exponents[1]));
        let solve = |length: f64, force: f64| -> Result<_> {
            let pair = pair(213e9 * force / (length * length), poisson_ratio)?;
            let ball = HertzSphere::new(&pair, 3.5e-3 * length, 100.0 * force)?;
            let radii = [3.5e-3 * length, 3.5e-3 * length * 10f64.powf(ratio)];
            let barrel = HertzEllipse::new(&pair, radii[0], radii[1], 100.0 * force)?;
            let load = fraction * LIMIT * force;
            Ok((
                CattaneoMindlin::new(ball, FRICTION, load)?,
                CattaneoMindlinEllipse::new(barrel, FRICTION, load)?,
            ))
        };
        let (ours, barrel) = solve(1.0, 1.0).map_err(|e| TestCaseError::fail(e.to_string()))?;
        let (theirs, their_barrel) =
            solve(length, force).map_err(|e| TestCaseError::fail(e.to_string()))?;
        let pressure = force / (length * length);
        // Positions are rounded, and the square root at an edge halves the number of accurate digits.
        let near = |found: f64, expected: f64, scale: f64| {
            assert_relative_eq!(found, expected, epsilon = 1e-7 * scale, max_relative = 0.0);
        };
        assert_close(theirs.hertz().contact_radius(), length * ours.hertz().contact_radius());
        assert_close(theirs.hertz().approach(), length * ours.hertz().approach());
        assert_close(theirs.stick_ratio(), ours.stick_ratio());
        assert_close(theirs.shift(), length * ours.shift());
        assert_close(their_barrel.shift(), length * barrel.shift());
        assert_close(their_barrel.hertz().semi_axes()[1], length * barrel.hertz().semi_axes()[1]);
        assert_close(their_barrel.hertz().approach(), length * barrel.hertz().approach());
        let a = ours.hertz().contact_radius();
        let (x, y) = (x * a, y * a);
        let here = [ours.traction(x), ours.displacement(x, y), ours.slip(x, y)];
        let (x, y) = (x * length, y * length);
        let scale = FRICTION * theirs.hertz().max_pressure();
        near(theirs.traction(x), pressure * here[0], scale);
        near(theirs.displacement(x, y), length * here[1], theirs.hertz().approach());
        near(theirs.slip(x, y), length * here[2], theirs.hertz().approach());
    }

    /// Covers the contacts that are not paraboloids.
    #[test]
    fn other_contacts_in_any_units_are_invariant(
        exponents in [-6.0..6.0_f64, -6.0..6.0],
        poisson_ratio in -0.5..0.5_f64,
        fraction in -0.99..0.99_f64,
        ratio in 0.01..2.0_f64,
        x in 0.01..2.0_f64,
    ) {
        let (length, force) = (10f64.powf(exponents[0]), 10f64.powf(exponents[1]));
        // The function returns lengths, pressures and dimensionless numbers of every contact, and for some contacts
        // also tractions at x.
        let solve = |length: f64, force: f64| -> Result<_> {
            let pressure = force / (length * length);
            let pair = pair(213e9 * pressure, poisson_ratio)?;
            let held = fraction * LIMIT * force;
            let cone = Cone::new(&pair, 0.01, 100.0 * force)?;
            let cone = ConePartialSlip::new(cone, FRICTION, held)?;
            let punch = FlatPunch::new(&pair, 1e-3 * length, 100.0 * force)?;
            let stick = punch.full_stick(FRICTION, held)?;
            // At nu = 0.29, full contact requires a mean pressure of 3.65e8 units of pressure.
            let mean = ratio * 4e8 * pressure;
            let waves = Westergaard::new(&pair, 1e-6 * length, 1e-3 * length, mean)?;
            let waves = WestergaardPartialSlip::new(waves, FRICTION, fraction * FRICTION * mean)?;
            let ball = HertzSphere::new(&pair, 3.5e-3 * length, 100.0 * force)?;
            let rough = RoughSphere::new(ball, 0.1)?;
            let plane = Persson::new(&pair, 0.1, mean)?;
            let cycled = MindlinDeresiewicz::new(ball, FRICTION, &[held, -0.5 * held])?;
            let torsion = LubkinTorsion::new(ball, FRICTION, 0.1 * fraction)?;
            let (c, a) = (cycled.stick_radius(), ball.contact_radius());
            let worn = PopovLimitingShape::new(&pair, ball.radius(), ball.approach(), c)?;
            let r = x * cone.cone().contact_radius();
            let lengths = [
                cone.stick_radius(),
                cone.shift(),
                cone.cone().approach(),
                cone.cone().displacement(r),
                punch.approach(),
                punch.displacement(2e-3 * x * length),
                stick.shift(),
                waves.contact().approach(),
                cycled.shift(),
                torsion.stick_radius(),
                worn.worn_radius(),
            ];
            let pressures = [
                cone.cone().mean_pressure(),
                punch.mean_pressure(),
                waves.contact().max_pressure(),
            ];
            let numbers = [
                waves.stick_ratio(),
                waves.contact().contact_fraction(),
                rough.relative_contact_area(),
                plane.contact_fraction(),
                plane.stick_ratio(FRICTION, fraction * FRICTION * mean)?,
                torsion.moment() / torsion.sliding_moment(),
                worn.load() / ball.load(),
            ];
            let fields = [
                cone.traction(r) / cone.cone().mean_pressure(),
                waves.traction(1e-3 * x * length) / waves.contact().max_pressure(),
                waves.contact().gap(1e-3 * x * length) / (1e-6 * length),
                cycled.traction(x * a) / ball.max_pressure(),
                torsion.traction(x * a) / ball.max_pressure(),
                worn.wear_depth(x * a) / ball.approach(),
            ];
            Ok((lengths, pressures, numbers, fields))
        };
        let ours = solve(1.0, 1.0).map_err(|e| TestCaseError::fail(e.to_string()))?;
        let theirs = solve(length, force).map_err(|e| TestCaseError::fail(e.to_string()))?;
        let pressure = force / (length * length);
        let pairs = |factor: f64, theirs: &[f64], ours: &[f64]| {
            for (theirs, ours) in theirs.iter().zip(ours) {
                assert_relative_eq!(*theirs, factor * ours, max_relative = 1e-11, epsilon = 0.0);
            }
        };
        pairs(length, &theirs.0, &ours.0);
        pairs(pressure, &theirs.1, &ours.1);
        pairs(1.0, &theirs.2, &ours.2);
        for (theirs, ours) in theirs.3.iter().zip(ours.3) {
            // Positions are rounded, as in the test of paraboloids.
            assert_relative_eq!(*theirs, ours, epsilon = 1e-7, max_relative = 0.0);
        }
    }
}
