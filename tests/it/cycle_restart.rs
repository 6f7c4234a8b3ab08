//! A program that saves a history and its unfinished cycle continues both with bitwise identical results.

use kit::{serde_json, unit_bodies};
use stickslip::history::{Cycle, LoadPath};
use stickslip::{History, LoadStep, NormalLoad, TangentialModel};

#[test]
fn cycle_after_restart_equals_cycle_without_restart() {
    let bodies = unit_bodies(kit::square(32, 12.0), 0.3);
    let gap = kit::sphere(bodies.grid(), 20.0);
    let path = LoadPath::triangle([0.9, 0.6], 8).unwrap();
    for interrupted in [0, 1, 5, 8] {
        let builder = History::builder(&bodies, &gap, kit::coulomb(0.4));
        let mut whole = builder.model(TangentialModel::Vector).build().unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(4.0));
        whole.step(&press).unwrap();
        let mut expected = Cycle::new(&whole);
        let (first, rest) = path.steps().split_at(interrupted);
        for &force in first {
            whole.step(&LoadStep::force(force)).unwrap();
            expected.add(&whole).unwrap();
        }
        let saved = (whole.to_bytes(), serde_json::to_vec(&expected).unwrap());

        let mut history = History::from_bytes(&bodies, &saved.0).unwrap();
        let mut cycle: Cycle = serde_json::from_slice(&saved.1).unwrap();
        for &force in rest {
            for (history, cycle) in [(&mut whole, &mut expected), (&mut history, &mut cycle)] {
                history.step(&LoadStep::force(force)).unwrap();
                cycle.add(history).unwrap();
            }
        }
        assert!(cycle == expected, "after {interrupted} steps");
        assert_eq!(cycle.steps(), 8);
        // Text of the numbers shows all bits.
        let text = [&cycle, &expected].map(|cycle| serde_json::to_string(cycle).unwrap());
        assert_eq!(text[0], text[1]);
        assert_eq!(history.to_bytes(), whole.to_bytes());
    }
}
