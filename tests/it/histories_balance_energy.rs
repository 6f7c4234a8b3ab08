//! The work of a steady loop is all dissipated.

use kit::unit_bodies;
use stickslip::{
    Axis, Field, Friction, Grid, HalfSpace, History, LoadStep, NormalControl, TangentialControl,
    surface,
};

const FRICTION: f64 = 0.4;

fn sphere() -> (HalfSpace, Field, f64) {
    let grid = Grid::square(48, 12.0).unwrap();
    let gap = surface::sphere(grid, 20.0).unwrap();
    (unit_bodies(grid, 0.3), gap, 4.0)
}

fn history((bodies, gap, load): &(HalfSpace, Field, f64), tolerance: f64) -> History {
    let friction = Friction::coulomb(FRICTION).unwrap();
    let builder = History::builder(bodies, gap, friction).tolerance(tolerance);
    let mut history = builder.build().unwrap();
    press(&mut history, *load);
    history
}

fn press(history: &mut History, load: f64) {
    let step = LoadStep::hold().normal(NormalControl::Force(load));
    history.step(&step).unwrap();
}

fn shear(history: &mut History, tangential: TangentialControl) {
    let step = LoadStep::hold().tangential(Axis::X, tangential);
    history.step(&step).unwrap();
}

/// Loop area and dissipation of a closed loop are the same number.
#[test]
fn a_steady_loop_dissipates_its_area() {
    let limit = FRICTION * sphere().2;
    let scene = sphere();
    let mut history = history(&scene, 1e-10);
    let amplitude = 0.7 * limit;
    let cycle = |history: &mut History| {
        let mut sums = [0.0; 4];
        for step in 1..=24 {
            let phase = std::f64::consts::TAU * f64::from(step) / 24.0;
            shear(history, TangentialControl::Force(amplitude * phase.sin()));
            let energy = history.last_step().energy();
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
    // The trapezoids of the loop miss some of its area; the tractions at the end of the steps do not.
    assert!(end_of_step > mid_step && end_of_step < 1.1 * mid_step);
    assert!(residual < 1e-9 * work);
}
