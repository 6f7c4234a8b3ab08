//! A sphere sheared to and fro under a constant load follows Mindlin and Deresiewicz: traction, shift and
//! energy, the better the finer the cells, whatever the steps.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

mod common;

use common::{Table2, l2_difference, max_difference};
use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::{
    Axis, Field, Friction, Grid, HalfSpace, History, LoadStep, NormalStep, TangentialStep, Zone,
    surface,
};

/// Largest force over the friction limit.
const AMPLITUDE: f64 = 0.8;
const LIMIT: f64 = Table2::FRICTION * Table2::FORCE;

/// The sphere of Table 2, pressed; 1.3 contact diameters on a side.
fn pressed(cells: usize, tolerance: f64) -> History {
    let grid = Grid::square(cells, 2.6 * Table2::CONTACT_RADIUS).unwrap();
    let bodies = HalfSpace::new(grid, Table2::pair()).unwrap();
    let ball = surface::sphere(grid, Table2::RADIUS).unwrap();
    let friction = Friction::coulomb(Table2::FRICTION).unwrap();
    let builder = History::builder(&bodies, &ball, friction).tolerance(tolerance);
    let mut history = builder.build().unwrap();
    let press = LoadStep::hold().normal(NormalStep::Force(Table2::FORCE));
    history.step(&press).unwrap();
    history
}

/// To a part of the friction limit, in equal steps.
fn shear_to(history: &mut History, part: f64, steps: usize) {
    let start = history.force()[0];
    for step in 1..=steps {
        let force = start + (part * LIMIT - start) * step as f64 / steps as f64;
        let load = LoadStep::hold().tangential(Axis::X, TangentialStep::Force(force));
        history.step(&load).unwrap();
    }
}

/// The monotonic solution under a part of the friction limit.
fn monotonic(part: f64) -> CattaneoMindlin {
    let hertz = HertzSphere::new(&Table2::pair(), Table2::RADIUS, Table2::FORCE).unwrap();
    CattaneoMindlin::new(hertz, Table2::FRICTION, part * LIMIT).unwrap()
}

/// Traction and shift on the way back from `AMPLITUDE`: that of the way there, less twice that of half the
/// change.
fn unloading(part: f64) -> (impl Fn(f64) -> f64, f64) {
    let (there, back) = (monotonic(AMPLITUDE), monotonic(0.5 * (AMPLITUDE - part)));
    let shift = there.shift() - 2.0 * back.shift();
    (move |r| there.traction(r) - 2.0 * back.traction(r), shift)
}

fn difference_from(history: &History, traction: impl Fn(f64) -> f64) -> f64 {
    let exact = Field::from_fn(history.grid(), |x, y| traction(x.hypot(y)));
    l2_difference(history.traction()[0].as_slice(), exact.as_slice())
}

/// Errors of shift, over that of sliding, and of traction on the way back to `part`.
fn errors(cells: usize, part: f64) -> [f64; 2] {
    let mut history = pressed(cells, 1e-9);
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
fn traction_and_shift_on_the_way_back() {
    for part in [0.4, 0.0, -0.5, -AMPLITUDE] {
        let [coarse, middle, fine] = [48, 96, 192].map(|cells| errors(cells, part));
        println!("{part}: shift {:e} {:e} {:e}, traction {:e} {:e} {:e}", coarse[0], middle[0], fine[0], coarse[1], middle[1], fine[1]);
    }
}

#[test]
fn energy_of_a_cycle() {
    let exact = 4.0 * monotonic(AMPLITUDE).dissipated_energy();
    for cells in [48, 96, 192] {
        for steps in [4, 16] {
            let mut history = pressed(cells, 1e-9);
            shear_to(&mut history, AMPLITUDE, steps);
            let before = history.dissipated_energy().as_slice().iter().sum::<f64>();
            shear_to(&mut history, -AMPLITUDE, 2 * steps);
            shear_to(&mut history, AMPLITUDE, 2 * steps);
            let after = history.dissipated_energy().as_slice().iter().sum::<f64>();
            println!("{cells} {steps} {:e}", (after - before) / exact - 1.0);
        }
    }
}

#[test]
fn cost() {
    for tolerance in [1e-6, 1e-8] {
        let mut history = pressed(256, tolerance);
        shear_to(&mut history, AMPLITUDE, 10);
        let (mut double, mut single) = (0, 0);
        for k in 1..=40 {
            let f = AMPLITUDE * LIMIT * (std::f64::consts::TAU * k as f64 / 40.0).cos();
            let step = history.step(&LoadStep::hold().tangential(Axis::X, TangentialStep::Force(f))).unwrap();
            let report = step.tangential_report().unwrap();
            print!("{}+{} ", report.convolutions, report.rough_convolutions);
            double += report.convolutions;
            single += report.rough_convolutions;
        }
        println!("\n{tolerance:e}: {double} {single}");
    }
}
