//! For the first steps of CONTACT's cases with tractions along both axes, the results agree with CONTACT cell by cell.

use kit::contact::{Case, Normal, ReferenceStep, Tangential};
use kit::press;
use stickslip::tangential::TangentialProblemBuilder;
use stickslip::{
    Friction, HalfSpace, NormalControl, TangentialLoad, TangentialModel, TangentialProblem, Zone,
};

const TOLERANCE: f64 = 1e-10;

/// Tolerance relative to the largest pressure for fields, and relative to the value for each scalar.
const AGREED: f64 = 1e-6;

/// Returns the tangential load of a step. All cases are symmetric about the x axis, so zero shift along y implies zero
/// force along y.
fn tangential_load(step: &ReferenceStep) -> TangentialLoad {
    match step.tangential {
        [Tangential::Force(x), Tangential::Force(y)] => TangentialLoad::force([x, y]),
        [Tangential::Shift(x), Tangential::Shift(y)] => TangentialLoad::shift([x, y]),
        [Tangential::Force(x), Tangential::Shift(0.0)] => TangentialLoad::force([x, 0.0]),
        other => panic!("{other:?}"),
    }
}

fn assert_first_step_agrees(text: &str) {
    let case = Case::parse(text);
    let step = &case.steps[0];
    assert!(!step.continues);
    let bodies = HalfSpace::new(case.grid, case.pair).unwrap();
    let friction = Friction::coulomb(case.friction).unwrap();
    let pressure = case.field(step, |cell| cell.pressure);
    let normal_load = match step.normal {
        Normal::Force(force) => NormalControl::Force(force),
        Normal::Approach(approach) => NormalControl::Approach(approach),
        Normal::Pressure => {
            let shear =
                TangentialProblem::builder(&bodies, &pressure, friction, tangential_load(step));
            assert_tractions_agree(&case, step, shear);
            return;
        }
    };
    let gap = case.gap(step);
    let normal = press(&bodies, &gap, normal_load, TOLERANCE);
    let largest = normal.pressure().max();
    let error = kit::max_difference(normal.pressure().as_slice(), pressure.as_slice());
    assert!(error < AGREED * largest, "pressure {:e}", error / largest);
    assert!((normal.force() / step.load - 1.0).abs() < AGREED);
    assert!((normal.approach() / step.approach - 1.0).abs() < AGREED);
    assert_eq!(normal.contact_cells(), step.cells.len());
    let shear = TangentialProblem::builder(&bodies, &normal, friction, tangential_load(step));
    assert_tractions_agree(&case, step, shear);
}

fn assert_tractions_agree(
    case: &Case,
    step: &ReferenceStep,
    shear: TangentialProblemBuilder<'_, '_>,
) {
    let shear = shear.model(TangentialModel::Vector).tolerance(TOLERANCE);
    let shear = kit::solve(shear);
    let pressures = step.cells.iter().map(|cell| cell.pressure);
    let largest = pressures.fold(0.0, f64::max);
    for axis in 0..2 {
        let traction = case.field(step, |cell| cell.traction[axis]);
        let found = shear.traction()[axis];
        let error = kit::max_difference(found.as_slice(), traction.as_slice());
        assert!(
            error < AGREED * largest,
            "traction {axis} {:e}",
            error / largest
        );
        let size = step.force[0].hypot(step.force[1]);
        assert!((shear.force()[axis] - step.force[axis]).abs() < AGREED * size);
        let size = step.shift[0].hypot(step.shift[1]);
        assert!((shear.shift()[axis] - step.shift[axis]).abs() < AGREED * size);
    }
    assert!((shear.dissipated_energy() / step.dissipated_energy - 1.0).abs() < AGREED);
    for cell in &step.cells {
        let zone = shear.zones()[cell.iy * case.grid.nx() + cell.ix];
        let limit = case.friction * cell.pressure;
        let is_close = (cell.traction[0].hypot(cell.traction[1]) / limit - 1.0).abs() < AGREED;
        let expected = if cell.sticks { Zone::Stick } else { Zone::Slip };
        assert!(
            zone == expected || (cell.sticks && is_close),
            "{cell:?} {zone:?}"
        );
    }
}

#[test]
fn ball_under_force_matches() {
    assert_first_step_agrees(include_str!("../data/contact/cattaneo_pe_ball.txt"));
}

#[test]
fn ball_under_shift_matches() {
    assert_first_step_agrees(include_str!("../data/contact/tb01_cattaneo_disp.txt"));
}

#[test]
fn ball_with_prescribed_pressure_matches() {
    assert_first_step_agrees(include_str!(
        "../data/contact/tb13_cattaneo_hertz_bound.txt"
    ));
}

#[test]
fn ball_before_unloading_matches() {
    assert_first_step_agrees(include_str!("../data/contact/tb10_tb11_mindlin_steps.txt"));
}

#[test]
fn ball_before_rolling_matches() {
    assert_first_step_agrees(include_str!("../data/contact/catt_to_cart_start.txt"));
}

#[test]
fn ball_before_moving_matches() {
    assert_first_step_agrees(include_str!(
        "../data/contact/catt_to_cart_shift_history.txt"
    ));
}
