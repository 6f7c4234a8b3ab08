//! For the first steps of CONTACT's cases with tractions along both axes, the results agree with CONTACT cell by cell.

use kit::contact::{AGREED, Case};
use kit::press;
use stickslip::{HalfSpace, TangentialModel, TangentialProblem};

const TOLERANCE: f64 = 1e-10;

fn assert_first_step_agrees(name: &str, steps: usize) {
    let case = Case::read(name, steps);
    let step = &case.steps[0];
    assert!(!step.continues);
    let bodies = HalfSpace::new(case.grid, case.pair).unwrap();
    let friction = kit::coulomb(case.friction);
    let pressure = case.field(step, |cell| cell.pressure);
    let load = step.tangential_load();
    let normal = step.normal_control().map(|control| {
        let normal = press(&bodies, &case.gap(step), control, TOLERANCE);
        assert!((normal.force() / step.load - 1.0).abs() < AGREED, "{name}");
        assert!(
            (normal.approach() / step.approach - 1.0).abs() < AGREED,
            "{name}"
        );
        assert_eq!(normal.contact_cells(), step.cells.len(), "{name}");
        normal
    });
    let builder = match &normal {
        Some(normal) => TangentialProblem::builder(&bodies, normal, friction, load),
        None => TangentialProblem::builder(&bodies, &pressure, friction, load),
    };
    let shear = kit::solve(builder.model(TangentialModel::Vector).tolerance(TOLERANCE));
    let found = normal
        .as_ref()
        .map_or(&pressure, |normal| normal.pressure());
    case.assert_fields_agree(step, (found, shear.traction(), shear.zones()), AGREED, true);
    for (found, expected) in [(shear.force(), step.force), (shear.shift(), step.shift)] {
        let size = expected[0].hypot(expected[1]);
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < AGREED * size, "{name}");
        }
    }
    assert!((shear.dissipated_energy() / step.dissipated_energy - 1.0).abs() < AGREED);
}

#[test]
fn ball_under_force_matches() {
    assert_first_step_agrees("cattaneo_pe_ball", 1);
}

#[test]
fn ball_under_shift_matches() {
    assert_first_step_agrees("tb01_cattaneo_disp", 1);
}

#[test]
fn ball_with_prescribed_pressure_matches() {
    assert_first_step_agrees("tb13_cattaneo_hertz_bound", 1);
}

#[test]
fn ball_before_unloading_matches() {
    assert_first_step_agrees("tb10_tb11_mindlin_steps", 2);
}

#[test]
fn ball_before_rolling_matches() {
    assert_first_step_agrees("catt_to_cart_start", 1);
}

#[test]
fn ball_before_moving_matches() {
    assert_first_step_agrees("catt_to_cart_shift_history", 21);
}
