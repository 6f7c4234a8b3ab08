//! For CONTACT's cases with tractions along both axes, the results agree with CONTACT cell by cell after every step.

use kit::contact::{AGREED, Case, ReferenceStep};
use stickslip::history::EntryRule;
use stickslip::{HalfSpace, History, TangentialModel};

const TOLERANCE: f64 = 1e-10;

fn assert_scalars_agree(case: &Case, step: &ReferenceStep, shift: [f64; 2], history: &History) {
    let close = |name: &str, found: f64, expected: f64, scale: f64| {
        let error = (found - expected).abs() / scale;
        assert!(error < AGREED, "{name} {error:e}");
    };
    for axis in 0..2 {
        let size = step.force[0].hypot(step.force[1]);
        close(
            "force",
            history.tangential_force()[axis],
            step.force[axis],
            size,
        );
        let size = shift[0].hypot(shift[1]);
        close("shift", history.shift()[axis], shift[axis], size);
    }
    let (normal, energy) = (history.normal(), history.last_step().unwrap().energy());
    close("load", normal.force(), step.load, step.load);
    close("approach", normal.approach(), step.approach, step.approach);
    let dissipated = step.dissipated_energy;
    close(
        "dissipated",
        energy.dissipated_energy,
        dissipated,
        dissipated,
    );
    if let Some(expected) = step.elastic_energy {
        let gap = case.gap(step);
        let cells = normal.pressure().as_slice().iter().zip(gap.as_slice());
        let work: f64 = cells.map(|(p, gap)| p * (normal.approach() - gap)).sum();
        let pressed = 0.5 * case.grid.cell_area() * work;
        close(
            "elastic",
            pressed + energy.elastic_after,
            expected,
            expected,
        );
    }
}

fn assert_every_step_agrees(name: &str, steps: usize) {
    let case = Case::read(name, steps);
    let bodies = HalfSpace::new(case.grid, case.pair).unwrap();
    let builder = History::builder(
        &bodies,
        case.gap(&case.steps[0]),
        kit::coulomb(case.friction),
    )
    .model(TangentialModel::Vector)
    .entry_rule(EntryRule::WholeStep);
    let mut history = builder.tolerance(TOLERANCE).build().unwrap();
    let mut shift = [0.0; 2];
    for (number, step) in case.steps.iter().enumerate() {
        assert_eq!(step.continues, number > 0);
        history.set_gap(&case.gap(step)).unwrap();
        history.step(&step.load_step(history.shift())).unwrap();
        for (shift, gain) in shift.iter_mut().zip(step.shift) {
            *shift += gain;
        }
        assert_scalars_agree(&case, step, shift, &history);
        let fields = (history.pressure(), history.traction(), history.zones());
        case.assert_fields_agree(step, fields, AGREED, true);
        assert_eq!(history.normal().contact_cells(), step.cells.len());
    }
}

#[test]
fn ball_under_force_matches() {
    assert_every_step_agrees("cattaneo_pe_ball", 1);
}

#[test]
fn ball_under_shift_matches() {
    assert_every_step_agrees("tb01_cattaneo_disp", 1);
}

#[test]
fn ball_partly_unloaded_matches() {
    assert_every_step_agrees("tb10_tb11_mindlin_steps", 2);
}

#[test]
fn ball_before_rolling_matches() {
    assert_every_step_agrees("catt_to_cart_start", 1);
}

#[test]
fn ball_with_shift_history_matches() {
    assert_every_step_agrees("catt_to_cart_shift_history", 21);
}
