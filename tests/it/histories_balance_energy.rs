//! The work of every step is found again: dissipated, stored, or named; over a steady loop it is all
//! dissipated.

use kit::{Random, rough, unit_bodies};
use stickslip::{
    Axis, Boundary, Field, Friction, Grid, HalfSpace, History, LoadStep, NormalControl,
    TangentialControl, surface,
};

const FRICTION: f64 = 0.4;

fn sphere() -> (HalfSpace, Field, f64) {
    let grid = Grid::square(48, 12.0).unwrap();
    let gap = surface::sphere(grid, 20.0).unwrap();
    (unit_bodies(grid, 0.3), gap, 4.0)
}

fn rough_surface() -> (HalfSpace, Field, f64) {
    let grid = Grid::square(48, 100.0).unwrap();
    (unit_bodies(grid, 0.3), rough(grid, 3), 30.0)
}

fn repeating() -> (HalfSpace, Field, f64) {
    let grid = Grid::square(48, 100.0).unwrap();
    let pair = *unit_bodies(grid, 0.3).pair();
    let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
    (bodies, rough(grid, 4), 60.0)
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

#[test]
fn every_step_balances() {
    for scene in [sphere(), rough_surface(), repeating()] {
        let tolerance = 1e-7;
        let mut history = history(&scene, tolerance);
        let limit = FRICTION * scene.2;
        let mut random = Random(5);
        let mut total = 0.0;
        for _ in 0..25 {
            let force = random.uniform(-0.95, 0.95) * limit;
            shear(&mut history, TangentialControl::Force(force));
            let step = history.last_step();
            let energy = step.energy();
            let scale = energy.elastic_before.max(energy.elastic_after) + energy.work.abs();
            assert!(energy.imbalance().abs() < 1e-12 * scale, "{energy:?}");
            // The pressure stands: nothing is let go, and the tolerance leaves next to nothing.
            assert!(energy.released.abs() < 1e-14 * scale);
            assert!(energy.residual.abs() < 10.0 * tolerance * scale);

            assert!(step.dissipated_energy().min() >= 0.0);
            assert!(step.mid_step_dissipated_energy().min() >= 0.0);
            assert!(step.mid_step_dissipated_energy().max() <= step.dissipated_energy().max());
            let sums = [step.dissipated_energy(), step.mid_step_dissipated_energy()]
                .map(|field| field.as_slice().iter().sum::<f64>());
            assert!((sums[0] - energy.dissipated_energy).abs() <= 1e-12 * energy.dissipated_energy);
            assert!(
                (sums[1] - energy.mid_step_dissipated_energy).abs()
                    <= 1e-12 * energy.dissipated_energy
            );
            total += energy.dissipated_energy;
        }
        let sum: f64 = history.dissipated_energy().as_slice().iter().sum();
        assert!(total > 0.0 && (sum / total - 1.0).abs() < 1e-12);
    }
}

/// Loads of all kinds at once, contact lost and won: what leaves the contact takes its energy along.
#[test]
fn a_changing_pressure_balances_too() {
    for scene in [sphere(), rough_surface()] {
        let mut history = history(&scene, 1e-8);
        let limit = FRICTION * scene.2;
        let mut released = 0.0_f64;
        for (load, tangential) in [
            (1.0, TangentialControl::Force(0.5 * limit)),
            (0.7, TangentialControl::Hold),
            (0.8, TangentialControl::Force(0.1 * limit)),
            (0.3, TangentialControl::Shift(0.0)),
            (1.5, TangentialControl::Hold),
            (1.0, TangentialControl::Force(-0.9 * limit)),
        ] {
            let step = LoadStep::hold()
                .normal(NormalControl::Force(load * scene.2))
                .tangential(Axis::X, tangential);
            let step = history.step(&step).unwrap();
            let energy = step.energy();
            let scale = energy.elastic_before.max(energy.elastic_after) + energy.work.abs();
            assert!(energy.imbalance().abs() <= 1e-12 * scale, "{energy:?}");
            assert!(step.dissipated_energy().min() >= 0.0);
            released = released.max(energy.released);
        }
        assert!(released > 0.0);
    }
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
            sums[1] += energy.mid_step_dissipated_energy;
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
