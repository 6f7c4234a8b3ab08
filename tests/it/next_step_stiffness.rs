//! The stiffness of the next step of a history agrees with the difference quotient of a small next step under the same
//! normal load.

use std::ops::ControlFlow;

use stickslip::analytical::{HertzSphere, MindlinFullStick};
use stickslip::stiffness::{ContactStiffness, StiffnessWorkspace};
use stickslip::{
    Coupling, ElasticPair, HalfSpace, History, LoadStep, Material, NormalLoad, TangentialModel,
    Zone,
};

const FORCE: f64 = 100.0;
const FRICTION: f64 = 0.4;

fn pressed(pair: &ElasticPair, model: TangentialModel, coupling: Coupling) -> History {
    let grid = kit::square(24, 0.30e-3);
    let bodies = HalfSpace::new(grid, *pair).unwrap();
    let builder =
        History::builder(&bodies, kit::sphere(grid, 3.5e-3), kit::coulomb(FRICTION)).model(model);
    let builder = builder.coupling(coupling).tolerance(1e-13);
    let mut history = builder.build().unwrap();
    for part in [0.5, 1.0] {
        let press = NormalLoad::Force(FORCE * part);
        history.step(&LoadStep::hold().normal(press)).unwrap();
    }
    history
}

fn steel() -> ElasticPair {
    let steel = Material::new(213e9, 0.29).unwrap();
    ElasticPair::new(steel, steel).unwrap()
}

fn dissimilar() -> ElasticPair {
    let aluminium = Material::new(70e9, 0.33).unwrap();
    ElasticPair::new(aluminium, Material::new(210e9, 0.3).unwrap()).unwrap()
}

fn stiffness_of(history: &History, is_of_next_step: bool) -> ContactStiffness {
    let mut workspace = StiffnessWorkspace::new().next_step(is_of_next_step);
    let go_on = |_: &_| ControlFlow::Continue(());
    history.stiffness_with(&mut workspace, go_on).unwrap()
}

/// Returns the change of the force along x and y in a small next step with this motion, divided by the length of the
/// motion.
fn quotient(history: &History, [x, y]: [f64; 2]) -> [f64; 2] {
    let (shift, force) = (history.shift(), history.tangential_force());
    let length = 1e-6 * history.approach();
    let by = |parts: f64| {
        let mut history = history.clone();
        let change = parts * length;
        let end = [shift[0] + change * x, shift[1] + change * y];
        let step = history.step(&LoadStep::shift(end)).unwrap();
        let reached = step.tangential_force();
        [0, 1].map(|axis| (reached[axis] - force[axis]) / change)
    };
    // The error is of first order in the length of the step.
    let [short, long] = [by(1.0), by(2.0)];
    [0, 1].map(|axis| 2.0 * short[axis] - long[axis])
}

/// Returns the largest difference between the quotient and the stiffness times the motion, relative to the stiffness at
/// reversal.
fn error(history: &History, motion: [f64; 2]) -> f64 {
    let found = stiffness_of(history, true);
    let entry = |matrix: [[Option<f64>; 3]; 3], row: usize, column: usize| {
        matrix[row][column].unwrap_or(0.0)
    };
    // The normal force is constant while shear changes the pressure.
    let slope = |row: usize, column: usize| {
        let normal = found.normal_by_motion[column].unwrap_or(0.0) / found.normal.value;
        let by_approach = found.by_approach[row].unwrap_or(0.0);
        entry(found.tangential.loading, row, column) - by_approach * normal
    };
    let scale = entry(found.tangential.reversal, 0, 0);
    let quotient = quotient(history, motion);
    let errors = [0, 1].map(|row| {
        let expected = slope(row, 0) * motion[0] + slope(row, 1) * motion[1];
        (quotient[row] - expected).abs() / scale
    });
    errors[0].max(errors[1])
}

fn slipping(history: &History) -> usize {
    let slips = |zone: &&Zone| **zone == Zone::Slip;
    history.zones().iter().filter(slips).count()
}

#[test]
fn next_step_stiffness_after_pressing_matches_mindlin() {
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let history = pressed(&steel(), model, Coupling::Full);
        let [last, next] = [false, true].map(|next| stiffness_of(&history, next).tangential);
        let along = |matrix: [[Option<f64>; 3]; 3]| matrix[0][0].unwrap();
        let [loading, reversal] = [next.loading, next.reversal].map(along);
        assert!(
            (loading / reversal - 1.0).abs() < 1e-9,
            "{loading} {reversal}"
        );
        // Cells that entered in the last step follow the motion of this step in part.
        assert!(along(last.loading) < 0.9 * loading);
        let hertz = HertzSphere::new(&steel(), 3.5e-3, FORCE).unwrap();
        let mindlin = MindlinFullStick::new(&steel(), hertz.contact_radius(), 1.0).unwrap();
        assert!((loading * mindlin.shift() - 1.0).abs() < 0.03);
        let error = error(&history, [1.0, 0.0]);
        assert!(error < 1e-7, "{error:e}");
    }
}

/// The traction of slipping cells is constant in the scalar model, and rotates in the vector model.
#[test]
fn next_step_stiffness_continues_slip_of_sheared_contact() {
    let scenes = [
        (TangentialModel::Scalar, [0.7, 0.0], [1.0, 0.0]),
        (TangentialModel::Vector, [0.7, 0.0], [1.0, 0.0]),
        (TangentialModel::Vector, [0.5, 0.5], [0.9, 0.4]),
    ];
    for (model, parts, motion) in scenes {
        let mut history = pressed(&steel(), model, Coupling::Full);
        let force = parts.map(|part| part * FRICTION * FORCE);
        history.step(&LoadStep::force(force)).unwrap();
        assert!(slipping(&history) > 10);
        let error = error(&history, motion);
        assert!(error < 1e-7, "{model:?} {parts:?}: {error:e}");
    }
}

/// If pressure and shear are coupled, the stiffness at a constant normal force follows from the loading stiffness and
/// the derivatives of the normal force.
#[test]
fn next_step_stiffness_of_dissimilar_bodies_continues_slip() {
    for coupling in [Coupling::Full, Coupling::OneWay] {
        let mut history = pressed(&dissimilar(), TangentialModel::Vector, coupling);
        history
            .step(&LoadStep::force([0.8 * FRICTION * FORCE, 0.0]))
            .unwrap();
        assert!(slipping(&history) > 10);
        let error = error(&history, [1.0, 0.0]);
        assert!(error < 1e-7, "{coupling:?}: {error:e}");
    }
}

/// The stiffness of the next step follows from the state alone.
#[test]
fn next_step_stiffness_after_restart_is_identical() {
    let mut history = pressed(&steel(), TangentialModel::Vector, Coupling::Full);
    history.step(&LoadStep::force([20.0, 5.0])).unwrap();
    let grid = history.grid();
    let bodies = HalfSpace::new(grid, steel()).unwrap();
    let restored = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
    let [a, b] = [&history, &restored].map(|history| stiffness_of(history, true));
    assert_eq!(a, b);
}
