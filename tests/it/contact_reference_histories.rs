//! For CONTACT's cases with tractions along both axes, the results agree with CONTACT cell by cell after every step.

use kit::contact::{Case, Normal, ReferenceStep, Tangential};
use kit::max_difference;
use stickslip::history::EntryRule;
use stickslip::{
    Axis, Friction, HalfSpace, History, LoadStep, NormalControl, TangentialControl,
    TangentialModel, Zone,
};

const TOLERANCE: f64 = 1e-10;

/// Tolerance relative to the largest pressure for fields, and relative to the value for each scalar.
const AGREED: f64 = 1e-6;

fn load_step(step: &ReferenceStep, shift: [f64; 2]) -> LoadStep {
    let mut load = LoadStep::hold().normal(match step.normal {
        Normal::Force(force) => NormalControl::Force(force),
        Normal::Approach(approach) => NormalControl::Approach(approach),
        Normal::Pressure => panic!("no gap"),
    });
    for axis in [Axis::X, Axis::Y] {
        let component = axis.index();
        let tangential = match step.tangential[component] {
            Tangential::Force(force) => TangentialControl::Force(force),
            Tangential::Shift(gain) => TangentialControl::Shift(shift[component] + gain),
        };
        load = load.tangential(axis, tangential);
    }
    load
}

fn assert_every_step_agrees(text: &str, steps: usize) {
    let case = Case::parse(text);
    assert_eq!(case.steps.len(), steps);
    let bodies = HalfSpace::new(case.grid, case.pair).unwrap();
    let friction = Friction::coulomb(case.friction).unwrap();
    let mut history = History::builder(&bodies, case.gap(&case.steps[0]), friction)
        .model(TangentialModel::Vector)
        .entry_rule(EntryRule::WholeStep)
        .tolerance(TOLERANCE)
        .build()
        .unwrap();
    let mut shift = [0.0; 2];
    for (number, step) in case.steps.iter().enumerate() {
        assert_eq!(step.continues, number > 0);
        history.set_gap(&case.gap(step)).unwrap();
        history.step(&load_step(step, history.shift())).unwrap();
        for (shift, gain) in shift.iter_mut().zip(step.shift) {
            *shift += gain;
        }
        assert_scalars_agree(&case, step, shift, &history);
        assert_cells_agree(&case, step, &history);
    }
}

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
    let (normal, energy) = (history.normal(), history.last_step().energy());
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

fn assert_cells_agree(case: &Case, step: &ReferenceStep, history: &History) {
    let largest = history.pressure().max();
    let pressure = case.field(step, |cell| cell.pressure);
    let error = max_difference(history.pressure().as_slice(), pressure.as_slice());
    assert!(error < AGREED * largest, "pressure {:e}", error / largest);
    for axis in 0..2 {
        let traction = case.field(step, |cell| cell.traction[axis]);
        let found = history.traction()[axis];
        let error = max_difference(found.as_slice(), traction.as_slice()) / largest;
        assert!(error < AGREED, "traction {axis} {error:e}");
    }
    for cell in &step.cells {
        let zone = history.zones()[cell.iy * case.grid.nx() + cell.ix];
        let limit = case.friction * cell.pressure;
        let is_close = (cell.traction[0].hypot(cell.traction[1]) / limit - 1.0).abs() < AGREED;
        let expected = if cell.sticks { Zone::Stick } else { Zone::Slip };
        assert!(zone == expected || is_close, "{cell:?} {zone:?}");
    }
    assert_eq!(history.normal().contact_cells(), step.cells.len());
}

#[test]
fn ball_under_force_matches() {
    assert_every_step_agrees(include_str!("../data/contact/cattaneo_pe_ball.txt"), 1);
}

#[test]
fn ball_under_shift_matches() {
    assert_every_step_agrees(include_str!("../data/contact/tb01_cattaneo_disp.txt"), 1);
}

#[test]
fn ball_partly_unloaded_matches() {
    assert_every_step_agrees(
        include_str!("../data/contact/tb10_tb11_mindlin_steps.txt"),
        2,
    );
}

#[test]
fn ball_before_rolling_matches() {
    assert_every_step_agrees(include_str!("../data/contact/catt_to_cart_start.txt"), 1);
}

#[test]
fn ball_with_shift_history_matches() {
    let text = include_str!("../data/contact/catt_to_cart_shift_history.txt");
    assert_every_step_agrees(text, 21);
}
