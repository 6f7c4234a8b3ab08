//! A state that was kept is returned to, bit for bit and without new buffers, whatever the history did since.

use kit::{rough, unit_bodies};
use stickslip::history::State;
use stickslip::{
    Axis, Error, Field, Friction, Grid, History, LoadStep, NormalControl, TangentialControl,
    TangentialModel, surface,
};

fn grid() -> Grid {
    Grid::square(64, 100.0).unwrap()
}

fn start(lateral: TangentialModel) -> History {
    let friction = Friction::per_cell(Field::constant(grid(), 0.5)).unwrap();
    let (bodies, gap) = (unit_bodies(grid(), 0.3), rough(grid(), 11));
    let builder = History::builder(&bodies, &gap, friction).model(lateral);
    builder.tolerance(1e-7).build().unwrap()
}

fn load(normal: f64, shear: f64) -> LoadStep {
    let step = LoadStep::hold().normal(NormalControl::Force(normal));
    step.tangential(Axis::X, TangentialControl::Force(shear))
}

fn run(history: &mut History, loads: &[[f64; 2]]) {
    for &[normal, shear] in loads {
        history.step(&load(normal, shear)).unwrap();
    }
}

#[test]
fn to_the_same_bits() {
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        let mut history = start(lateral);
        // Before anything has touched, and with slip to remember.
        for loads in [&[][..], &[[10.0, 0.0], [10.0, 3.0], [12.0, -2.0]]] {
            run(&mut history, loads);
            let (kept, bytes) = (history.state().clone(), history.to_bytes());
            let twin = history.clone();
            // Another gap, friction and tolerance, and a contact that outgrows its box.
            let other = rough(grid(), 12);
            history.set_gap(&other).unwrap();
            let slippery = Friction::coulomb(0.3).unwrap();
            history.set_friction(&slippery).unwrap();
            let settings = history.settings().tolerance(1e-5);
            history.set_settings(settings).unwrap();
            run(&mut history, &[[20.0, 1.0], [300.0, 50.0]]);
            history.step(&load(1.0, 200.0)).unwrap_err();

            history.set_state(&kept).unwrap();
            assert_eq!(history.to_bytes(), bytes);
            let mut elsewhere = start(TangentialModel::Vector);
            elsewhere.set_state(&kept).unwrap();
            for history in [&mut history, &mut elsewhere] {
                let mut twin = twin.clone();
                run(history, &[[11.0, 1.0], [40.0, -4.0]]);
                run(&mut twin, &[[11.0, 1.0], [40.0, -4.0]]);
                assert_eq!(history.to_bytes(), twin.to_bytes());
            }
        }
    }
}

#[test]
fn but_not_to_one_of_other_bodies() {
    let mut history = start(TangentialModel::Scalar);
    run(&mut history, &[[10.0, 0.0], [10.0, 3.0]]);
    let bytes = history.to_bytes();
    let other = unit_bodies(grid(), 0.2);
    let builder = History::builder(&other, history.gap(), history.friction().clone());
    let state = builder.build().unwrap().state().clone();
    let refused = history.set_state(&state);
    assert!(matches!(refused, Err(Error::MaterialMismatch { .. })));
    assert_eq!(history.to_bytes(), bytes);
    let bodies = unit_bodies(grid(), 0.3);
    let refused = History::from_state(&bodies, state);
    assert!(matches!(refused, Err(Error::MaterialMismatch { .. })));
}

#[test]
fn of_numbers_that_the_history_shows_too() {
    let mut history = start(TangentialModel::Vector);
    run(&mut history, &[[10.0, 0.0], [10.0, 3.0], [12.0, -2.0]]);
    let state: &State = history.state();
    assert_eq!(state.grid(), history.grid());
    assert_eq!(state.axis(), history.axis());
    assert_eq!(state.pressure(), history.normal().pressure());
    assert_eq!(state.traction(), history.traction());
    assert_eq!(state.slip(), history.slip());
    assert_eq!(state.zones(), history.zones());
    assert_eq!(state.steps(), 3);
    let read = State::from_bytes(&state.to_bytes()).unwrap();
    assert_eq!(read.accumulated_slip(), history.accumulated_slip());
    assert_eq!(read.dissipated_energy(), history.dissipated_energy());
    assert_eq!(read.gap(), history.gap());
    assert_eq!(read.friction(), history.friction());
    assert_eq!(read.settings(), history.settings());
    let bits = |[x, y]: [f64; 2]| [x.to_bits(), y.to_bits()];
    assert_eq!(bits(read.shift()), bits(history.shift()));
    assert_eq!(bits(read.force()), bits(history.force()));
}

#[test]
fn what_a_step_did_is_nowhere_else_after_a_return() {
    let grid = Grid::square(48, 4.0).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let gap = surface::sphere(grid, 10.0).unwrap();
    let builder = History::builder(&bodies, &gap, Friction::coulomb(0.3).unwrap());
    let mut history = builder.build().unwrap();
    let blank = history.state().clone();
    let step = |force: f64, part: f64| {
        let shear = TangentialControl::Force(part * force);
        let press = LoadStep::hold().normal(NormalControl::Force(force));
        press.tangential(Axis::X, shear)
    };
    history.step(&step(0.01, 0.0)).unwrap();
    let small = history.state().clone();
    for part in [0.0, 0.25] {
        history.step(&step(0.3, part)).unwrap();
    }
    assert!(history.last_step().slip_distance().max() > 0.0);
    // A step on the small contact slips there alone, as in a history that never was elsewhere.
    history.set_state(&small).unwrap();
    let mut fresh = History::from_state(&bodies, small).unwrap();
    for history in [&mut history, &mut fresh] {
        history.step(&step(0.01, 0.2)).unwrap();
    }
    assert_eq!(history.last_step().slip(), fresh.last_step().slip());
    let energies = [&history, &fresh].map(|history| history.last_step().dissipated_energy());
    assert_eq!(energies[0], energies[1]);
    // Bodies apart slip nowhere.
    history.set_state(&blank).unwrap();
    history.step(&LoadStep::hold()).unwrap();
    assert_eq!(history.last_step().slip_distance().max(), 0.0);
    assert_eq!(history.last_step().dissipated_energy().max(), 0.0);
}
