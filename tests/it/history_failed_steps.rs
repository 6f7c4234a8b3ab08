//! If a step is rejected or does not converge, the state and the start of the next step are bitwise unchanged.

use kit::{rough, unit_bodies};
use stickslip::Status;
use stickslip::{
    Axis, Error, Field, Friction, Grid, History, LoadStep, NormalLoad, TangentialControl,
    TangentialModel,
};

fn grid() -> Grid {
    kit::square(64, 100.0)
}

fn new_history(axis: Axis) -> History {
    let gap = rough(grid(), 11);
    let bodies = unit_bodies(grid(), 0.3);
    let builder = History::builder(&bodies, &gap, kit::coulomb(0.5)).axis(axis);
    builder.build().unwrap()
}

fn load_step(force: f64, axis: Axis, tangential: TangentialControl) -> LoadStep {
    let step = LoadStep::hold().normal(NormalLoad::Force(force));
    step.tangential(axis, tangential)
}

/// Takes three steps, which lead to first contact, to slip, and to a higher load.
fn advance(history: &mut History) {
    let axis = history.axis().unwrap();
    for step in [
        load_step(10.0, axis, TangentialControl::Hold),
        load_step(10.0, axis, TangentialControl::Force(3.0)),
        load_step(12.0, axis, TangentialControl::Force(-2.0)),
    ] {
        history.step(&step).unwrap();
    }
}

/// Checks that the history and an undisturbed copy are identical and remain so in further steps.
fn assert_unchanged(disturbed: &mut History, twin: &mut History) {
    assert_eq!(disturbed.to_bytes(), twin.to_bytes());
    let axis = twin.axis().unwrap();
    for step in [
        load_step(14.0, axis, TangentialControl::Force(1.0)),
        LoadStep::hold().tangential(axis, TangentialControl::Shift(0.3)),
    ] {
        disturbed.step(&step).unwrap();
        twin.step(&step).unwrap();
        assert_eq!(disturbed.to_bytes(), twin.to_bytes());
        let [a, b] = [&*disturbed, &*twin].map(|history| history.last_step().unwrap());
        assert_eq!(a.slip(), b.slip());
        assert_eq!(a.energy(), b.energy());
    }
}

#[test]
fn rejected_loads_leave_state_unchanged() {
    for axis in [Axis::X, Axis::Y] {
        let (mut history, mut twin) = (new_history(axis), new_history(axis));
        advance(&mut history);
        advance(&mut twin);
        let across = if axis == Axis::X { Axis::Y } else { Axis::X };
        let spring = |position, stiffness| TangentialControl::Spring {
            position,
            stiffness,
        };
        let hold = TangentialControl::Hold;
        for bad in [
            load_step(f64::NAN, axis, hold),
            load_step(-1.0, axis, hold),
            load_step(f64::INFINITY, axis, hold),
            LoadStep::hold().normal(NormalLoad::Approach(f64::NAN)),
            load_step(12.0, axis, TangentialControl::Force(f64::NAN)),
            load_step(12.0, axis, TangentialControl::Shift(f64::INFINITY)),
            load_step(12.0, axis, spring(f64::NAN, 1.0)),
            load_step(12.0, axis, spring(1.0, 0.0)),
            load_step(12.0, axis, spring(1.0, -2.0)),
            load_step(12.0, axis, spring(1.0, f64::INFINITY)),
            load_step(12.0, across, TangentialControl::Force(1.0)),
            load_step(12.0, across, TangentialControl::Shift(1.0)),
            load_step(12.0, across, spring(1.0, 1.0)),
            load_step(12.0, axis, hold).twist(0.1),
            load_step(12.0, axis, hold).twist(f64::NAN),
        ] {
            assert!(history.step(&bad).is_err(), "{bad:?}");
        }
        let refused = history.step(&load_step(12.0, across, TangentialControl::Force(1.5)));
        let Err(error @ Error::UnsupportedByModel { value, .. }) = refused else {
            panic!("{refused:?}")
        };
        assert!(value == 1.5);
        let message = error.to_string();
        let remedy = format!("with {across:?} as its axis, or use the vector model").to_lowercase();
        assert!(message.contains(&remedy), "{message}");
        let message = |load| history.clone().step(&load).unwrap_err().to_string();
        let turned = message(load_step(12.0, axis, hold).twist(0.1));
        assert!(turned.contains("twist, got 0.1") && turned.contains("use the vector model"));
        let dragged = message(LoadStep::hold().tangential(axis, spring(f64::NAN, 1.0)));
        let end = format!("position of the spring along {axis:?}").to_lowercase();
        assert!(dragged.contains(&end), "{dragged}");
        assert!(message(LoadStep::spring([1.0; 2], 1.0)).contains("position of the spring"));

        // The step requires a far wider contact, and then its force exceeds the friction limit.
        let refused = history.step(&load_step(400.0, axis, TangentialControl::Force(-250.0)));
        let Err(Error::BeyondFrictionCapacity { force, limit, .. }) = refused else {
            panic!("{refused:?}")
        };
        assert!(force == 250.0 && (limit / 200.0 - 1.0).abs() < 1e-12);
        // A constant force exceeds the friction limit after the normal load is reduced.
        let refused = history.step(&load_step(3.0, axis, TangentialControl::Force(-2.0)));
        assert!(matches!(refused, Err(Error::BeyondFrictionCapacity { .. })));

        let other = Field::zeros(kit::square(63, 100.0));
        assert!(history.set_gap(&other).is_err());
        assert!(history.set_gap(&Field::constant(grid(), f64::NAN)).is_err());
        let friction = Friction::per_cell(other).unwrap();
        assert!(history.set_friction(&friction).is_err());
        assert_unchanged(&mut history, &mut twin);
    }
}

#[test]
fn steps_not_converged_leave_state_unchanged() {
    let grid = kit::square(64, 12.0);
    let ball = kit::sphere(grid, 20.0);
    let bodies = unit_bodies(grid, 0.3);
    let friction = kit::coulomb(0.5);
    let builder = || {
        History::builder(&bodies, &ball, friction.clone())
            .max_iterations(15)
            .tolerance(1e-9)
    };
    let [mut history, mut twin] = [builder(), builder()].map(|builder| builder.build().unwrap());
    for history in [&mut history, &mut twin] {
        let press = LoadStep::hold().normal(NormalLoad::Force(3.0));
        history.step(&press).unwrap();
    }
    let step = |force| LoadStep::hold().tangential(Axis::X, TangentialControl::Force(force));
    let mut failures = 0;
    for force in [1.4, 0.2, -1.4, 1.0] {
        let before = history.to_bytes();
        match history.step(&step(force)) {
            Ok(_) => {
                twin.step(&step(force)).unwrap();
            }
            Err(Error::NotConverged(report)) => {
                assert_eq!(report.status, Status::IterationLimit);
                assert_eq!(history.to_bytes(), before);
                failures += 1;
            }
            Err(error) => panic!("{error}"),
        }
    }
    assert!(failures > 0);
    assert_eq!(history.to_bytes(), twin.to_bytes());
}

/// Loads near the limits of the floating-point range give finite results, or an error that leaves the state unchanged.
#[test]
fn loads_of_extreme_size_give_finite_results_or_errors() {
    let grid = kit::square(8, 12.0);
    let ball = kit::sphere(grid, 20.0);
    let bodies = unit_bodies(grid, 0.3);
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        let builder = History::builder(&bodies, &ball, kit::coulomb(0.5)).model(lateral);
        let mut history = builder.build().unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(3.0));
        let drag = press.tangential(Axis::X, TangentialControl::Force(0.7));
        history.step(&press).unwrap();
        history.step(&drag).unwrap();
        let saved = history.to_bytes();
        let all = [5e-324, 1e-310, 1e-300, 1e-200, 1e-100, 1e100, 1e200, 1e300];
        for &size in kit::thorough(&[5e-324, 1e300][..], &all) {
            let spring = |position, stiffness| TangentialControl::Spring {
                position,
                stiffness,
            };
            for tangential in [
                TangentialControl::Force(size),
                TangentialControl::Shift(size),
                TangentialControl::Shift(-size),
                spring(size, 1.0),
                spring(1.0, size),
            ] {
                for step in [
                    drag.tangential(Axis::X, tangential),
                    drag.tangential(Axis::X, tangential).twist(size),
                    press
                        .normal(NormalLoad::Force(size))
                        .tangential(Axis::X, tangential),
                    press
                        .normal(NormalLoad::Approach(size))
                        .tangential(Axis::X, tangential),
                    press
                        .normal(NormalLoad::Approach(-size))
                        .tangential(Axis::X, tangential),
                ] {
                    if history.step(&step).is_err() {
                        assert!(history.to_bytes() == saved, "{step:?}");
                        continue;
                    }
                    assert!(is_finite_history(&history), "{step:?}");
                    history = History::from_bytes(&bodies, &saved).unwrap();
                }
            }
        }
    }
}

fn is_finite_history(history: &History) -> bool {
    let fields = history.traction().into_iter().chain(history.slip());
    let fields = fields.chain([history.pressure(), history.accumulated_slip()]);
    let energy = history.last_step().unwrap().energy();
    let scalars = [
        history.shift(),
        history.tangential_force(),
        [energy.work, energy.dissipated_energy],
    ]
    .concat();
    let mut numbers = fields.flat_map(Field::as_slice).chain(&scalars);
    numbers.all(|number| number.is_finite())
}
