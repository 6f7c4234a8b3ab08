//! The stick zone of a history has a subcell edge, including after the force has reversed.

use kit::smooth::{Smooth, l1_difference};
use kit::unit_pair;
use stickslip::analytical::{HertzSphere, MindlinDeresiewicz};
use stickslip::*;

use crate::rank_contacts::PATIENCE;

const FRICTION: f64 = 0.5;
/// Load that gives a contact radius of one.
const LOAD: f64 = 4.0 / 3.0;
const OFFSETS: [[f64; 2]; 8] = [
    [0.0, 0.0],
    [0.31, -0.17],
    [-0.42, 0.48],
    [0.12, 0.43],
    [0.23, 0.11],
    [-0.29, -0.36],
    [0.47, -0.05],
    [-0.08, 0.27],
];

fn bodies(cells: usize) -> HalfSpace {
    let bodies = HalfSpace::new(kit::square(cells, 3.0), unit_pair(0.0)).unwrap();
    bodies.with_cell_value(CellValue::Centre).unwrap()
}

fn shear(force: f64) -> LoadStep {
    LoadStep::hold().tangential(Axis::X, TangentialControl::Force(force))
}

/// Returns the history of a ball that is pressed and then loaded by the tangential forces.
fn history(bodies: &HalfSpace, offset: [f64; 2], forces: &[f64]) -> History {
    let gap = Smooth::sphere().gap(bodies.grid(), offset);
    let builder = History::builder(bodies, &gap, kit::coulomb(FRICTION));
    let mut history = builder.tolerance(1e-7).build().unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(LOAD));
    history.step(&press).unwrap();
    for force in forces {
        history.step(&shear(*force)).unwrap();
    }
    history
}

/// Returns the relative errors of the counted stick area, the fitted stick area, the raw tractions and the fitted
/// tractions.
fn errors(history: &History, offset: [f64; 2], forces: &[f64]) -> [f64; 4] {
    let grid = history.grid();
    let hertz = HertzSphere::new(&unit_pair(0.0), 1.0, LOAD).unwrap();
    let exact = MindlinDeresiewicz::new(hertz, FRICTION, forces).unwrap();
    let area = std::f64::consts::PI * exact.stick_radius().powi(2);
    let sticking = history.zones().iter().filter(|zone| **zone == Zone::Stick);
    let [x0, y0] = offset.map(|place| place * grid.dx());
    let traction = Field::from_fn(grid, |x, y| exact.traction((x - x0).hypot(y - y0)).abs());
    let mut raw = history.traction()[0].clone();
    for q in raw.as_mut_slice() {
        *q = q.abs();
    }
    let edges = history.edges().unwrap();
    assert_eq!(edges.contact(), &history.normal().edges().unwrap());
    [
        (sticking.count() as f64 * grid.cell_area() / area - 1.0).abs(),
        (edges.stick_area() / area - 1.0).abs(),
        l1_difference(&raw, &traction, |_| true),
        l1_difference(edges.traction(), &traction, |_| true),
    ]
}

/// The paths are loading, unloading, reversal and two reversals, in steps of any length. There are 96 cells over
/// three contact radii. The test uses the mean and the largest error over eight positions in the thorough run, and
/// over three positions otherwise.
#[test]
fn stick_edges_after_reversals_match_mindlin_deresiewicz() {
    let bodies = bodies(96);
    let offsets = &OFFSETS[..kit::thorough(3, 8)];
    let part =
        |parts: &[f64]| -> Vec<f64> { parts.iter().map(|part| part * FRICTION * LOAD).collect() };
    // Each case lists the path, the limits of two errors with fitted edges, and the limit of the largest error of the
    // area. The first two limits are fractions of the errors of the counted area and of the raw traction.
    for (name, forces, area_left, traction_left, worst_area) in [
        ("loaded", part(&[0.4]), 0.05, 0.3, 1e-3),
        (
            "loaded in steps",
            part(&[0.1, 0.2, 0.3, 0.4]),
            0.1,
            0.4,
            2e-3,
        ),
        ("unloaded", part(&[0.7, 0.0]), 0.1, 0.6, 2e-3),
        (
            "unloaded in steps",
            part(&[0.7, 0.5, 0.25, 0.0]),
            0.1,
            0.6,
            2e-3,
        ),
        ("reversed", part(&[0.7, -0.3]), 0.2, 0.8, 4e-3),
        ("turned twice", part(&[0.7, -0.7, 0.0]), 0.1, 0.6, 2e-3),
    ] {
        let (mut means, mut worst) = ([0.0; 4], 0.0_f64);
        for &offset in offsets {
            let found = errors(&history(&bodies, offset, &forces), offset, &forces);
            worst = worst.max(found[1]);
            for (mean, error) in means.iter_mut().zip(found) {
                *mean += error / offsets.len() as f64;
            }
        }
        let [counted, area, raw, traction] = means;
        assert!(area < area_left * counted, "{name} {means:?}");
        assert!(traction < traction_left * raw, "{name} {means:?}");
        assert!(worst < worst_area, "{name} {worst}");
    }
}

/// After a return to a state, the last step of the history does not belong to this state. The edge must then follow
/// from the interior values alone.
#[test]
fn stick_edges_after_return_to_state_are_accurate() {
    let (bodies, offset) = (bodies(64), OFFSETS[1]);
    let mut history = history(&bodies, offset, &[0.2]);
    let [counted, stepped, ..] = errors(&history, offset, &[0.2]);
    let state = history.state().clone();
    history.step(&shear(-0.2)).unwrap();
    history.set_state(&state).unwrap();
    let [_, returned, ..] = errors(&history, offset, &[0.2]);
    assert!(
        stepped < 0.1 * counted && returned < 0.2 * counted,
        "{stepped} {returned} {counted}"
    );
    let restarted = History::from_state(&bodies, state).unwrap();
    assert_eq!(restarted.edges().unwrap(), history.edges().unwrap());
}

/// Without contact there is no edge. If no cell slips, the stick zone is the contact for any tractions. If every cell
/// slips, the stick zone is empty.
#[test]
fn every_state_has_stick_edges() {
    let bodies = bodies(48);
    let gap = Smooth::sphere().gap(bodies.grid(), [0.0; 2]);
    let builder = History::builder(&bodies, &gap, kit::coulomb(FRICTION));
    let mut history = builder.build().unwrap();
    let edges = history.edges().unwrap();
    assert_eq!((edges.stick_area(), edges.contact().area()), (0.0, 0.0));
    history
        .step(&LoadStep::hold().normal(NormalLoad::Force(LOAD)))
        .unwrap();
    let edges = history.edges().unwrap();
    assert!(
        (edges.stick_ratio() - 1.0).abs() < 2e-3,
        "{}",
        edges.stick_ratio()
    );
    assert!(edges.peak_traction() < 1e-9);
    let all = FRICTION * LOAD;
    history.step(&shear(all)).unwrap();
    let edges = history.edges().unwrap();
    assert_eq!(edges.stick_area(), 0.0);
    let force = edges.mean_traction().integral();
    assert!((force / all - 1.0).abs() < 2e-3, "{force}");
}

#[test]
fn stick_edges_of_slabs_are_rejected() {
    let grid = Grid::new(64, 256, 0.05, 0.05).unwrap();
    let outcomes = ranks::Threads::run(2, PATIENCE, |rank| {
        let boundary = Boundary::NonPeriodic;
        let rank = std::sync::Arc::new(rank);
        let bodies = HalfSpace::distributed(grid, unit_pair(0.0), boundary, rank).unwrap();
        let gap = Smooth::sphere().gap(bodies.grid(), [0.0; 2]);
        let builder = History::builder(&bodies, &gap, kit::coulomb(FRICTION));
        let history = builder.build().unwrap();
        matches!(history.edges(), Err(Error::Ranks(_)))
    });
    assert!(outcomes.iter().all(|is_refused| *is_refused));
}
