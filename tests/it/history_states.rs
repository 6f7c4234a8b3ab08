//! A state has the values of its history. A history of different bodies rejects the state.

use kit::{rough, unit_bodies};
use stickslip::history::State;
use stickslip::{
    Axis, Error, Field, Friction, Grid, History, LoadStep, NormalLoad, TangentialControl,
    TangentialModel,
};

fn grid() -> Grid {
    kit::square(64, 100.0)
}

fn start(lateral: TangentialModel) -> History {
    let friction = Friction::per_cell(Field::constant(grid(), 0.5)).unwrap();
    let (bodies, gap) = (unit_bodies(grid(), 0.3), rough(grid(), 11));
    let builder = History::builder(&bodies, &gap, friction).model(lateral);
    builder.tolerance(1e-7).build().unwrap()
}

fn load(normal: f64, shear: f64) -> LoadStep {
    let step = LoadStep::hold().normal(NormalLoad::Force(normal));
    step.tangential(Axis::X, TangentialControl::Force(shear))
}

fn run(history: &mut History, loads: &[[f64; 2]]) {
    for &[normal, shear] in loads {
        history.step(&load(normal, shear)).unwrap();
    }
}

/// The stick ratio belongs to the state, so that it remains after a restart.
#[test]
fn stick_ratio_of_history_equals_stick_ratio_of_last_step() {
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let mut history = start(model);
        assert_eq!(history.stick_ratio().to_bits(), 0.0_f64.to_bits());
        run(&mut history, &[[10.0, 0.0], [10.0, 3.0]]);
        let found = history.last_step().unwrap().stick_ratio();
        assert!(found > 0.0 && found < 1.0);
        let read = State::from_bytes(&history.to_bytes()).unwrap();
        let mut other = start(model);
        other.set_state(history.state()).unwrap();
        for ratio in [
            history.stick_ratio(),
            history.state().stick_ratio(),
            read.stick_ratio(),
            other.stick_ratio(),
        ] {
            assert_eq!(ratio.to_bits(), found.to_bits());
        }
    }
}

#[test]
fn state_of_different_bodies_is_rejected() {
    let mut history = start(TangentialModel::Scalar);
    run(&mut history, &[[10.0, 0.0], [10.0, 3.0]]);
    let bytes = history.to_bytes();
    let other = unit_bodies(grid(), 0.2);
    let builder = History::builder(&other, history.unloaded_gap(), history.friction().clone());
    let state = builder.build().unwrap().state().clone();
    kit::assert_refused! { history.set_state(&state) => Error::MaterialMismatch { .. } }
    assert_eq!(history.to_bytes(), bytes);
    let bodies = unit_bodies(grid(), 0.3);
    kit::assert_refused! { History::from_state(&bodies, state) => Error::MaterialMismatch { .. } }
}

#[test]
fn state_has_values_of_history() {
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
    assert_eq!(
        read.accumulated_dissipation(),
        history.accumulated_dissipation()
    );
    assert_eq!(read.unloaded_gap(), history.unloaded_gap());
    assert_eq!(read.friction(), history.friction());
    assert_eq!(read.settings(), history.settings());
    let bits = |[x, y]: [f64; 2]| [x.to_bits(), y.to_bits()];
    assert_eq!(bits(read.shift()), bits(history.shift()));
    assert_eq!(
        bits(read.tangential_force()),
        bits(history.tangential_force())
    );
}
