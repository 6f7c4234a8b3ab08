//! A contact that was large is worked on in windows of its present size: with the answers of the whole grid, and from a
//! saved state or after a step that failed to the same bits.

use std::ops::ControlFlow;

use kit::{boundaries, max_abs, max_difference, rough, unit_bodies, unit_pair};
use stickslip::history::TouchRule;
use stickslip::{
    Axis, Coupling, ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalControl, TangentialControl, TangentialModel, Zone, surface,
};

const FRICTION: f64 = 0.4;
const RADIUS: f64 = 1000.0;

/// Large, small, a little larger, large again, and down in two steps; shifts to and fro.
const PATH: [(f64, f64); 13] = [
    (36.0, 0.0),
    (36.0, 0.5),
    (36.0, -0.3),
    (8.0, 0.2),
    (8.0, -0.4),
    (8.0, 0.5),
    (9.0, 0.1),
    (9.0, -0.5),
    (36.0, 0.3),
    (36.0, -0.5),
    (20.0, 0.2),
    (8.0, 0.1),
    (8.0, -0.5),
];

/// To a contact of this radius, and a part of the shift at which all of it would slip.
fn step((radius, part): (f64, f64)) -> LoadStep {
    let approach = radius * radius / RADIUS;
    let shift = TangentialControl::Shift(part * FRICTION * approach);
    LoadStep::hold()
        .normal(NormalControl::Approach(approach))
        .tangential(Axis::X, shift)
}

fn sphere(grid: Grid) -> Field {
    surface::sphere(grid, RADIUS).unwrap()
}

fn start(bodies: &HalfSpace, gap: &Field, model: TangentialModel, coupling: Coupling) -> History {
    let builder = History::builder(bodies, gap, Friction::coulomb(FRICTION).unwrap());
    let builder = builder.model(model).coupling(coupling).tolerance(1e-9);
    builder.touch_rule(TouchRule::WholeStep).build().unwrap()
}

/// A history of every kind.
fn histories() -> Vec<History> {
    let grid = Grid::square(96, 96.0).unwrap();
    let mut bumpy = sphere(grid);
    bumpy.add_scaled(2e-4, &rough(grid, 3)).unwrap();
    let alike = unit_bodies(grid, 0.3);
    let (soft, hard) = (Material::new(1.0, 0.1).unwrap(), Material::rigid());
    let unlike = HalfSpace::new(grid, ElasticPair::new(soft, hard).unwrap()).unwrap();
    let [scalar, vector] = [TangentialModel::Scalar, TangentialModel::Vector];
    vec![
        start(&alike, &sphere(grid), scalar, Coupling::Full),
        start(&alike, &bumpy, scalar, Coupling::Full),
        start(&alike, &bumpy, vector, Coupling::Full),
        start(&unlike, &bumpy, scalar, Coupling::OneWay),
        start(&unlike, &sphere(grid), vector, Coupling::Full),
    ]
}

/// On a grid that repeats along y, where windows are cut along x alone.
fn rows() -> History {
    let grid = Grid::square(96, 96.0).unwrap();
    let [.., along_y] = boundaries(grid);
    let bodies = HalfSpace::with_boundary(grid, unit_pair(0.3), along_y).unwrap();
    start(
        &bodies,
        &sphere(grid),
        TangentialModel::Scalar,
        Coupling::Full,
    )
}

/// The windows are what makes the states of a grid longer or shorter.
#[test]
fn what_was_large_is_remembered_as_what_is_small() {
    // Pressure and shear found together remember all of the grid.
    let is_joint = |history: &History| {
        let state = history.state();
        state.pair().is_coupled() && state.coupling() == Coupling::Full
    };
    for mut history in histories().into_iter().filter(|history| !is_joint(history)) {
        let empty = history.to_bytes().len();
        let windows = |history: &History| history.to_bytes().len() - empty;
        let mut small = history.clone();
        small.step(&step((8.0, 0.0))).unwrap();
        history.step(&step((36.0, 0.0))).unwrap();
        let large = windows(&history);
        for part in [0.1, 0.2, -0.1] {
            history.step(&step((8.0, part))).unwrap();
            small.step(&step((8.0, part))).unwrap();
        }
        assert!(3 * windows(&history) < large);
        // One has margins to grow into.
        assert!(windows(&history) < 4 * windows(&small));
    }
}

/// Rows that repeat are cut along x alone: once small they remember less, and still three numbers of all cells of the columns
/// in contact, which are whole.
#[test]
fn rows_that_repeat_are_remembered_from_end_to_end() {
    let mut history = rows();
    let grid = history.grid();
    let numbers = |history: &History| history.to_bytes().len() / size_of::<f64>();
    let empty = numbers(&history);
    for load in [(36.0, 0.0), (8.0, 0.1)] {
        history.step(&step(load)).unwrap();
    }
    let large = numbers(&history);
    for part in [0.2, -0.1] {
        history.step(&step((8.0, part))).unwrap();
        let pressure = history.pressure().as_slice();
        let touches = |ix: &usize| (0..grid.ny()).any(|iy| pressure[iy * grid.nx() + ix] > 0.0);
        let columns = (0..grid.nx()).filter(touches).count();
        let least = empty + 3 * columns * grid.ny();
        assert!((least..large).contains(&numbers(&history)));
    }
}

/// What slips in a step is the displacement by all changes of the tractions on the whole grid, less the shift: the
/// windows, which come and go, do not show. Coupling of one way only moves surfaces that the tractions do not.
#[test]
fn every_step_obeys_its_law_on_the_whole_grid() {
    let is_drawn = |history: &History| history.state().coupling() == Coupling::OneWay;
    let all = histories().into_iter().chain([rows()]);
    for mut history in all.filter(|history| !is_drawn(history)) {
        let area = history.grid().cell_area();
        for load in PATH {
            let ([before, _], shift) = (history.displacement().unwrap(), history.shift()[0]);
            history.step(&step(load)).unwrap();
            let [after, _] = history.displacement().unwrap();
            let moved = history.shift()[0] - shift;
            let scale = max_abs(after.as_slice()).max(max_abs(before.as_slice()));
            let (taken, mut dissipated) = (history.last_step(), 0.0);
            for (i, zone) in history.zones().iter().enumerate() {
                let [p, q] = [history.pressure(), history.traction()[0]].map(|f| f.as_slice()[i]);
                let slip = after.as_slice()[i] - before.as_slice()[i] - moved;
                match zone {
                    Zone::Separated => assert_eq!([p, q], [0.0; 2]),
                    Zone::Stick => assert!(slip.abs() <= 1e-7 * scale, "{slip:e} of {scale:e}"),
                    Zone::Slip => {
                        dissipated -= area * q * slip;
                        let found = taken.slip()[0].as_slice()[i];
                        assert!((found - slip).abs() <= 1e-6 * scale, "{found:e}, {slip:e}");
                    }
                }
            }
            let energy = taken.energy();
            let scale = energy.elastic_before.max(energy.elastic_after) + energy.work.abs();
            assert!(energy.imbalance().abs() <= 1e-12 * scale, "{energy:?}");
            assert!(dissipated <= energy.dissipated_energy + 1e-6 * scale);
            if history.axis().is_some() {
                let difference = (dissipated - energy.dissipated_energy).abs();
                assert!(difference <= 1e-6 * scale, "{difference:e} of {scale:e}");
            }
        }
    }
}

/// Small ones that were never large come to the same answers.
#[test]
fn without_slip_nothing_tells_that_it_was_large() {
    for mut history in histories() {
        let unsheared = |radius| step((radius, 0.0));
        // Without shear, pressing makes coupled bodies slip.
        if history.normal().pair().is_coupled() {
            continue;
        }
        let mut small = history.clone();
        for radius in [36.0, 8.0, 8.0] {
            history.step(&unsheared(radius)).unwrap();
        }
        small.step(&unsheared(8.0)).unwrap();
        for part in [0.3, -0.5, 0.1] {
            for history in [&mut history, &mut small] {
                history.step(&step((8.0, part))).unwrap();
            }
            let [a, b] = [&history, &small].map(|history| history.traction()[0].as_slice());
            assert!(max_difference(a, b) < 1e-6 * max_abs(a));
            let [a, b] = [&history, &small].map(|history| history.last_step().energy());
            let difference = a.dissipated_energy - b.dissipated_energy;
            assert!(difference.abs() < 1e-6 * a.elastic_after);
        }
    }
}

#[test]
fn saved_at_any_step_it_goes_on_to_the_same_bits() {
    for mut history in histories() {
        let bodies = HalfSpace::new(history.grid(), *history.normal().pair()).unwrap();
        let mut restored = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
        let mut returned = history.clone();
        let mut once = None;
        for (number, load) in PATH.into_iter().enumerate() {
            history.step(&step(load)).unwrap();
            restored.step(&step(load)).unwrap();
            returned.set_state(restored.state()).unwrap();
            let saved = history.to_bytes();
            assert_eq!(restored.to_bytes(), saved);
            assert_eq!(returned.to_bytes(), saved);
            restored = History::from_bytes(&bodies, &saved).unwrap();
            // One is saved before it shrinks, and goes on by itself.
            if number == 3 {
                once = Some(History::from_bytes(&bodies, &saved).unwrap());
            } else if let Some(once) = &mut once {
                once.step(&step(load)).unwrap();
                assert_eq!(once.to_bytes(), saved);
            }
        }
    }
}

#[test]
fn a_step_that_fails_on_the_way_leaves_no_trace() {
    for mut history in histories() {
        let mut twin = history.clone();
        for load in PATH {
            let before = history.to_bytes();
            for calls in [0, 3, 9] {
                let mut left = calls;
                let cancelled = history.step_observed(&step(load), |_| {
                    left -= 1;
                    if left < 0 {
                        ControlFlow::Break(())
                    } else {
                        ControlFlow::Continue(())
                    }
                });
                if cancelled.is_ok() {
                    break;
                }
                assert_eq!(history.to_bytes(), before);
            }
            if history.steps() == twin.steps() {
                history.step(&step(load)).unwrap();
            }
            twin.step(&step(load)).unwrap();
            assert_eq!(history.to_bytes(), twin.to_bytes());
        }
    }
}
