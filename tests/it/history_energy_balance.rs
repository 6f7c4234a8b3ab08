//! In a steady loop, all work is dissipated.

use kit::unit_bodies;
use stickslip::{Axis, Field, HalfSpace, History, LoadStep, NormalLoad, TangentialControl};

const FRICTION: f64 = 0.4;

fn sphere_problem() -> (HalfSpace, Field, f64) {
    let grid = kit::square(48, 12.0);
    (unit_bodies(grid, 0.3), kit::sphere(grid, 20.0), 4.0)
}

fn new_history((bodies, gap, load): &(HalfSpace, Field, f64), tolerance: f64) -> History {
    let builder = History::builder(bodies, gap, kit::coulomb(FRICTION)).tolerance(tolerance);
    let mut history = builder.build().unwrap();
    press(&mut history, *load);
    history
}

fn press(history: &mut History, load: f64) {
    let step = LoadStep::hold().normal(NormalLoad::Force(load));
    history.step(&step).unwrap();
}

fn shear(history: &mut History, tangential: TangentialControl) {
    let step = LoadStep::hold().tangential(Axis::X, tangential);
    history.step(&step).unwrap();
}

/// The loop area equals the dissipation of a closed loop.
#[test]
fn steady_loop_area_equals_dissipation() {
    let limit = FRICTION * sphere_problem().2;
    let scene = sphere_problem();
    let mut history = new_history(&scene, 1e-10);
    let amplitude = 0.7 * limit;
    let cycle = |history: &mut History| {
        let mut sums = [0.0; 4];
        for step in 1..=24 {
            let phase = std::f64::consts::TAU * f64::from(step) / 24.0;
            shear(history, TangentialControl::Force(amplitude * phase.sin()));
            let energy = history.last_step().unwrap().energy();
            sums[0] += energy.work;
            sums[1] += energy.dissipated_energy_midpoint;
            sums[2] += energy.dissipated_energy;
            sums[3] += energy.residual.abs();
        }
        sums
    };
    cycle(&mut history);
    let [work, mid_step, end_of_step, residual] = cycle(&mut history);
    assert!((work / mid_step - 1.0).abs() < 1e-9);
    // The trapezoidal rule underestimates the loop area. The dissipation by the tractions at the end of the steps does
    // not underestimate the area.
    assert!(end_of_step > mid_step && end_of_step < 1.1 * mid_step);
    assert!(residual < 1e-9 * work);
}
