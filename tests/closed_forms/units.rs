//! No length, force or pressure of its own.

use approx::assert_relative_eq;
use proptest::prelude::*;
use stickslip::Result;
use stickslip::analytical::{CattaneoMindlin, CattaneoMindlinEllipse, HertzEllipse, HertzSphere};

use crate::{FRICTION, LIMIT, assert_close, pair};

proptest! {
    /// The same contact in units of length and force `length` and `force` times smaller.
    #[test]
    fn units_do_not_matter(
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
        // Positions are rounded, and a root at an edge takes half of the digits of that.
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
}
