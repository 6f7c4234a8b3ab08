//! Load cycles reach their turning points and close exactly, without rounding errors.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

use proptest::prelude::*;
use stickslip::Error;
use stickslip::history::LoadPath;

/// Constructor of a cycle from its amplitude and number of steps.
type Shape = fn([f64; 2], usize) -> Result<LoadPath, Error>;

const SHAPES: [Shape; 3] = [
    |amplitude, steps| LoadPath::sine(amplitude, steps),
    |amplitude, steps| LoadPath::triangle(amplitude, steps),
    |amplitude, steps| LoadPath::ellipse(amplitude, 0.0, steps),
];

#[test]
fn cycles_reach_amplitude_and_close() {
    let amplitude = [0.1, -7.3e5];
    for shape in SHAPES {
        for quarter in [1, 2, 3, 10, 97] {
            let path = shape(amplitude, 4 * quarter).unwrap();
            let at = |step: usize| path.steps()[step - 1];
            assert_eq!(path.steps().len(), 4 * quarter);
            assert_eq!(at(quarter), amplitude);
            assert_eq!(at(2 * quarter), [0.0, 0.0]);
            assert_eq!(at(3 * quarter), amplitude.map(|a| -a));
            assert_eq!(path.end(), [0.0, 0.0]);
            for step in 1..quarter {
                // All quarters are equal up to sign and order, and each increases monotonically.
                assert_eq!(at(step), at(2 * quarter - step));
                assert_eq!(at(step), at(2 * quarter + step).map(|value| -value));
                assert!(at(step)[0] > 0.0 && at(step)[0] < at(step + 1)[0]);
            }
        }
    }
}

#[test]
fn values_match_formulas() {
    let steps = 48;
    let sine = LoadPath::sine([2.0, 3.0], steps).unwrap();
    let triangle = LoadPath::triangle([2.0, 3.0], steps).unwrap();
    let phase = 0.7;
    let ellipse = LoadPath::ellipse([2.0, 3.0], phase, steps).unwrap();
    let near = |found: [f64; 2], expected: [f64; 2]| {
        assert!((found[0] - expected[0]).hypot(found[1] - expected[1]) < 1e-14);
    };
    for k in 1..=steps {
        let angle = TAU * k as f64 / steps as f64;
        let zigzag = angle.sin().asin() / FRAC_PI_2;
        near(sine.steps()[k - 1], [2.0 * angle.sin(), 3.0 * angle.sin()]);
        // The arc sine loses half of the digits near the turning points.
        let found = triangle.steps()[k - 1];
        assert!((found[0] - 2.0 * zigzag).abs() < 1e-7);
        assert_eq!(1.5 * found[0], found[1]);
        let expected = [2.0 * angle.sin(), 3.0 * (angle + phase).sin()];
        near(ellipse.steps()[k - 1], expected);
    }
    near(ellipse.end(), [0.0, 3.0 * phase.sin()]);
}

#[test]
fn ellipse_stays_within_amplitudes() {
    let circle = LoadPath::ellipse([5.0, 5.0], FRAC_PI_2, 100).unwrap();
    for [x, y] in circle.steps() {
        assert!((x.hypot(*y) / 5.0 - 1.0).abs() < 1e-15);
    }
    assert_eq!(circle.end(), [0.0, 5.0]);
    assert_eq!(circle.steps()[24][0], 5.0);
    assert_eq!(circle.steps()[49], [0.0, -5.0]);
    // With a phase of an eighth of a cycle, a step ends at a turning point of y. The rounded formula would exceed the
    // amplitude at this point.
    let tilted = LoadPath::ellipse([f64::MAX, f64::MAX], FRAC_PI_4, 8).unwrap();
    for value in tilted.steps().as_flattened() {
        assert!(value.is_finite());
    }
}

#[test]
fn table_is_unchanged_and_cycles_repeat() {
    let table = vec![[1.0, 0.0], [1.0, 2.0], [-1.0, 2.0]];
    let path = LoadPath::table(table.clone()).unwrap();
    assert_eq!(path.steps(), table);
    assert_eq!(path.end(), [-1.0, 2.0]);
    assert_eq!(path.cycles(0).count(), 0);
    let twice: Vec<[f64; 2]> = path.cycles(2).collect();
    assert_eq!(twice, [table.clone(), table].concat());
}

#[test]
fn invalid_paths_are_rejected() {
    // A phase of 90 is meant in degrees.
    let refused = LoadPath::ellipse([1.0; 2], 90.0, 8)
        .unwrap_err()
        .to_string();
    assert_eq!(
        refused,
        "an ellipse does not support a phase of more than 6.283 (2 pi), got 90.0: give the phase in radians"
    );
    assert!(LoadPath::ellipse([1.0; 2], -TAU, 8).is_ok());
    for shape in SHAPES {
        for steps in [0, 1, 2, 3, 5, 42] {
            kit::assert_refused! { shape([1.0, 0.0], steps) => error if error == Error::StepsPerCycle(steps) }
        }
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for amplitude in [[wrong, 0.0], [0.0, wrong]] {
                kit::assert_refused! { shape(amplitude, 8) => Error::NotFinite { .. } }
            }
            let refused = LoadPath::ellipse([1.0, 1.0], wrong, 8);
            assert!(matches!(refused, Err(Error::NotFinite { .. })));
            let refused = LoadPath::table(vec![[0.0, 1.0], [0.0, wrong]]);
            assert!(matches!(refused, Err(Error::Sample { index: 3, .. })));
        }
    }
    assert_eq!(LoadPath::table(Vec::new()), Err(Error::EmptyPath));
    assert!(LoadPath::sine([0.0, 0.0], 4).is_ok());
}

proptest! {
    #[test]
    fn values_stay_within_amplitudes(
        amplitudes in [-1e3..1e3_f64, -1e3..1e3],
        phase in -TAU..TAU,
        quarter in 1..20_usize,
    ) {
        let path = LoadPath::ellipse(amplitudes, phase, 4 * quarter).unwrap();
        for value in path.cycles(2) {
            prop_assert!(value[0].abs() <= amplitudes[0].abs());
            prop_assert!(value[1].abs() <= amplitudes[1].abs());
        }
        let middle = path.steps()[2 * quarter - 1];
        prop_assert_eq!(middle[1], -path.end()[1]);
    }
}
