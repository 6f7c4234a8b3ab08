//! A sphere under an oscillating tangential force and a constant normal load follows the theory of Mindlin and
//! Deresiewicz. Traction, shift and energy converge with the grid for any number of steps.

use kit::{Table2, l2_difference, max_difference};
use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::{Axis, Field, HalfSpace, History, LoadStep, NormalLoad, TangentialControl, Zone};

/// Largest force relative to the friction limit.
const AMPLITUDE: f64 = 0.8;
const LIMIT: f64 = Table2::FRICTION * Table2::FORCE;

/// Presses the sphere of Table 2 on a square with a side of 1.3 contact diameters.
fn press_sphere(cells: usize, tolerance: f64) -> History {
    let grid = kit::square(cells, 2.6 * Table2::CONTACT_RADIUS);
    let bodies = HalfSpace::new(grid, Table2::pair()).unwrap();
    let builder = History::builder(
        &bodies,
        kit::sphere(grid, Table2::RADIUS),
        kit::coulomb(Table2::FRICTION),
    )
    .tolerance(tolerance);
    let mut history = builder.build().unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(Table2::FORCE));
    history.step(&press).unwrap();
    history
}

/// Shears in equal steps to the fraction `part` of the friction limit.
fn shear_to(history: &mut History, part: f64, steps: usize) {
    let start = history.tangential_force()[0];
    for step in 1..=steps {
        let force = start + (part * LIMIT - start) * step as f64 / steps as f64;
        let load = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(force));
        history.step(&load).unwrap();
    }
}

/// Returns the solution for first loading to the fraction `part` of the friction limit.
fn monotonic(part: f64) -> CattaneoMindlin {
    let hertz = HertzSphere::new(&Table2::pair(), Table2::RADIUS, Table2::FORCE).unwrap();
    CattaneoMindlin::new(hertz, Table2::FRICTION, part * LIMIT).unwrap()
}

/// Returns traction and shift during unloading from `AMPLITUDE`. They are the values at `AMPLITUDE` minus twice the
/// values for half the change of the force.
fn unloading(part: f64) -> (impl Fn(f64) -> f64, f64) {
    let (there, back) = (monotonic(AMPLITUDE), monotonic(0.5 * (AMPLITUDE - part)));
    let shift = there.shift() - 2.0 * back.shift();
    (move |r| there.traction(r) - 2.0 * back.traction(r), shift)
}

fn difference_from(history: &History, traction: impl Fn(f64) -> f64) -> f64 {
    let exact = Field::from_fn(history.grid(), |x, y| traction(x.hypot(y)));
    l2_difference(history.traction()[0].as_slice(), exact.as_slice())
}

/// Returns the error of the shift, relative to the shift at sliding, and the error of the traction, during unloading at
/// `part`.
fn unloading_errors(cells: usize, part: f64) -> [f64; 2] {
    let mut history = press_sphere(cells, 1e-9);
    shear_to(&mut history, AMPLITUDE, 4);
    shear_to(&mut history, part, 6);
    let (traction, shift) = unloading(part);
    let scale = monotonic(AMPLITUDE).sliding_shift();
    [
        (history.shift()[0] - shift).abs() / scale,
        difference_from(&history, traction),
    ]
}

#[test]
fn unloading_traction_and_shift_converge() {
    for &part in kit::thorough(&[-0.5][..], &[0.4, 0.0, -0.5, -AMPLITUDE]) {
        let [coarse, middle, fine] = [48, 96, 192].map(|cells| unloading_errors(cells, part));
        // The error of the shift due to slip zones is irregular and at least of order 3/2. The error of the tractions
        // is of order 1.
        for ([shift, traction], bounds) in [
            (coarse, [3e-4, 8e-2]),
            (middle, [3e-5, 3e-2]),
            (fine, [1e-5, 1.5e-2]),
        ] {
            assert!(shift < bounds[0], "{part}: {shift:e}");
            assert!(traction < bounds[1], "{part}: {traction:e}");
        }
        assert!(fine[1] < 0.35 * coarse[1]);
    }
}

#[test]
fn energy_of_a_cycle_converges() {
    let exact = monotonic(AMPLITUDE).energy_per_cycle();
    let energy = |history: &History| {
        history
            .accumulated_dissipation()
            .as_slice()
            .iter()
            .sum::<f64>()
    };
    for (cells, bound) in [(48, 4e-4), (96, 8e-5), (192, 5e-5)] {
        let mut history = press_sphere(cells, 1e-9);
        shear_to(&mut history, AMPLITUDE, 1);
        let before = energy(&history);
        shear_to(&mut history, -AMPLITUDE, 3);
        shear_to(&mut history, AMPLITUDE, 3);
        let error = (energy(&history) - before) / exact - 1.0;
        assert!(error.abs() < bound, "{cells}: {error:e}");
    }
}

/// For any number of steps, the state at the end of a cycle equals the state at its start. The state in the middle of
/// the cycle is the mirror image.
#[test]
fn number_of_steps_does_not_change_the_cycle() {
    let mut ends: Vec<History> = Vec::new();
    for &steps in kit::thorough(&[2, 8][..], &[2, 8, 32]) {
        let mut history = press_sphere(64, 1e-9);
        shear_to(&mut history, AMPLITUDE, steps);
        let there = history.traction()[0].clone();
        shear_to(&mut history, -AMPLITUDE, 2 * steps);
        let back: Vec<f64> = history.traction()[0]
            .as_slice()
            .iter()
            .map(|q| -q)
            .collect();
        let largest = there.max();
        assert!(max_difference(&back, there.as_slice()) < 1e-6 * largest);
        shear_to(&mut history, AMPLITUDE, 2 * steps);
        let again = history.traction()[0].as_slice();
        assert!(max_difference(again, there.as_slice()) < 1e-6 * largest);
        shear_to(&mut history, 0.3, steps);
        ends.push(history);
    }
    let [few, others @ ..] = &ends[..] else {
        unreachable!("three histories")
    };
    for many in others {
        let scale = few.traction()[0].max();
        let [a, b] = [few, many].map(|history| history.traction()[0].as_slice());
        assert!(max_difference(a, b) < 1e-6 * scale);
        assert!((few.shift()[0] / many.shift()[0] - 1.0).abs() < 1e-7);
        let [a, b] = [few, many].map(|history| history.accumulated_slip().as_slice());
        assert!(max_difference(a, b) < 1e-6 * few.accumulated_slip().max());
        let [a, b] = [few, many].map(|history| history.accumulated_dissipation().integral());
        assert!((a / b - 1.0).abs() < 1e-7, "{a:e} {b:e}");
        let [a, b] = [few, many].map(stick_cells);
        assert_eq!(a, b);
    }
}

fn stick_cells(history: &History) -> usize {
    let zones = history.zones().iter();
    zones.filter(|&&zone| zone == Zone::Stick).count()
}

/// Each of the forty steps of a cycle needs two or three products in double precision, and at most eighteen in single
/// precision.
#[test]
fn warm_start_step_needs_few_products() {
    let mut history = press_sphere(kit::thorough(128, 256), 1e-6);
    shear_to(&mut history, AMPLITUDE, 10);
    let (mut double, mut single) = (0, 0);
    for step in 1..=40 {
        let part = AMPLITUDE * (std::f64::consts::TAU * f64::from(step) / 40.0).cos();
        shear_to(&mut history, part, 1);
        let report = history.last_step().unwrap().tangential_report().unwrap();
        double += report.double_precision_products;
        single += report.single_precision_products;
    }
    assert!(double <= 40 * 3 && single <= 40 * 18, "{double} + {single}");
}
