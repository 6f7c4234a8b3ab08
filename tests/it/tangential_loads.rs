//! A tangential problem accepts a force, shift or spring along each axis, in any combination, and a twist. Its solution
//! equals the first shear step of a history.

use kit::{max_difference, rough, unit_bodies, unit_pair};
use stickslip::{
    Axis, Boundary, Field, Friction, Grid, HalfSpace, History, LoadStep, NormalLoad, NormalProblem,
    TangentialControl, TangentialLoad, TangentialModel, TangentialProblem, surface,
};

const FRICTION: f64 = 0.4;
const LOAD: f64 = 4.0;
const LIMIT: f64 = FRICTION * LOAD;
const TOLERANCE: f64 = 1e-10;

fn spring(position: f64, stiffness: f64) -> TangentialControl {
    TangentialControl::Spring {
        position,
        stiffness,
    }
}

/// Solves the problem and the corresponding step of a history, and compares them.
fn assert_problem_matches_step(
    bodies: &HalfSpace,
    gap: &Field,
    model: TangentialModel,
    controls: [TangentialControl; 2],
    twist: f64,
) {
    let friction = Friction::coulomb(FRICTION).unwrap();
    let normal = NormalProblem::builder(bodies, gap, NormalLoad::Force(LOAD))
        .tolerance(TOLERANCE)
        .build()
        .unwrap();
    let pressed = normal.solve().unwrap();
    let load = TangentialLoad::force([0.0; 2])
        .along(Axis::X, controls[0])
        .along(Axis::Y, controls[1])
        .twist(twist);
    let problem = TangentialProblem::builder(bodies, &pressed, friction.clone(), load)
        .model(model)
        .tolerance(TOLERANCE)
        .build()
        .unwrap();
    let found = problem.solve().unwrap();

    let axis = match (model, controls) {
        (TangentialModel::Scalar, [TangentialControl::Force(0.0), _]) => Axis::Y,
        _ => Axis::X,
    };
    let builder = History::builder(bodies, gap, friction).tolerance(TOLERANCE);
    let builder = match model {
        TangentialModel::Scalar => builder.axis(axis),
        _ => builder.model(model),
    };
    let mut history = builder.build().unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(LOAD));
    history.step(&press).unwrap();
    let step = match model {
        TangentialModel::Scalar => LoadStep::hold().tangential(axis, controls[axis as usize]),
        _ => LoadStep::hold()
            .tangential(Axis::X, controls[0])
            .tangential(Axis::Y, controls[1])
            .twist(twist),
    };
    history.step(&step).unwrap();

    let what = format!("{model:?} {controls:?} twist {twist}");
    let largest = FRICTION * pressed.pressure().max();
    for n in 0..2 {
        let [a, b] = [found.traction()[n], history.traction()[n]].map(Field::as_slice);
        assert!(max_difference(a, b) < 1e-8 * largest, "{what}");
    }
    assert!(
        max_difference(&found.force(), &history.tangential_force()) < 1e-8 * LIMIT,
        "{what}"
    );
    assert!(
        max_difference(&found.shift(), &history.shift()) < 1e-8,
        "{what}"
    );
    assert_eq!(found.twist(), history.twist());
    assert!(found.report().is_converged() && found.report().energy_error_bound() <= TOLERANCE);
    for (n, control) in controls.into_iter().enumerate() {
        let (force, shift) = (found.force()[n], found.shift()[n]);
        match control {
            TangentialControl::Force(asked) => assert!((force - asked).abs() < 1e-11 * LIMIT),
            TangentialControl::Shift(asked) => assert_eq!(shift, asked),
            TangentialControl::Spring {
                position,
                stiffness,
            } => {
                let error = force - stiffness * (position - shift);
                assert!(error.abs() < 1e-11 * LIMIT, "{what}: {error:e}");
            }
            _ => {}
        }
    }
}

#[test]
fn vector_model_problem_matches_history_step() {
    use TangentialControl::{Force, Shift};
    let grid = Grid::square(40, 12.0).unwrap();
    let (bodies, ball) = (unit_bodies(grid, 0.3), surface::sphere(grid, 20.0).unwrap());
    for (controls, twist) in [
        ([Force(0.5 * LIMIT), Force(-0.3 * LIMIT)], 0.02),
        ([Force(0.5 * LIMIT), Shift(0.05)], 0.0),
        ([Shift(0.04), spring(-0.3, 2.0)], -0.01),
        ([spring(0.4, 0.5), spring(0.2, 30.0)], 0.02),
        ([spring(0.3, 1.0), Force(0.0)], 0.0),
        ([Force(0.0), Force(0.0)], 0.03),
    ] {
        assert_problem_matches_step(&bodies, &ball, TangentialModel::Vector, controls, twist);
    }
}

#[test]
fn scalar_model_problem_matches_history_step() {
    use TangentialControl::{Force, Shift};
    let grid = Grid::square(40, 12.0).unwrap();
    let (bodies, ball) = (unit_bodies(grid, 0.3), surface::sphere(grid, 20.0).unwrap());
    for along in [
        Force(-0.7 * LIMIT),
        Shift(0.05),
        spring(0.4, 0.5),
        spring(-0.2, 1e4),
    ] {
        for controls in [[along, Force(0.0)], [Force(0.0), along]] {
            assert_problem_matches_step(&bodies, &ball, TangentialModel::Scalar, controls, 0.0);
        }
    }
}

#[test]
fn periodic_problem_matches_history_step() {
    use TangentialControl::{Force, Shift};
    let grid = Grid::square(32, 12.0).unwrap();
    let bodies = HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap();
    let gap = rough(grid, 6);
    for controls in [
        [spring(0.4, 0.5), Force(0.2 * LIMIT)],
        [Shift(0.01), spring(0.3, 20.0)],
    ] {
        assert_problem_matches_step(&bodies, &gap, TangentialModel::Vector, controls, 0.0);
    }
}
