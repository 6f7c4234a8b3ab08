//! A contact that was large is worked on in windows of its present size, and answers as one that never was large.

use kit::{boundaries, max_abs, max_difference, rough, unit_bodies, unit_pair};
use stickslip::history::EntryRule;
use stickslip::{
    Axis, Coupling, ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalControl, TangentialControl, TangentialModel, surface,
};

const FRICTION: f64 = 0.4;
const RADIUS: f64 = 1000.0;

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
    builder.entry_rule(EntryRule::WholeStep).build().unwrap()
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
    // Pressure and traction found together remember all of the grid.
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
