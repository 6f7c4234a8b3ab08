//! After a contact has shrunk, its windows fit its present size. Its solution agrees with the solution of a contact
//! that was never large.

use kit::{boundaries, max_abs, max_difference, rough, unit_bodies, unit_pair};
use stickslip::history::EntryRule;
use stickslip::{
    Axis, Coupling, ElasticPair, Field, Grid, HalfSpace, History, LoadStep, Material, NormalLoad,
    TangentialControl, TangentialModel,
};

const FRICTION: f64 = 0.4;
const RADIUS: f64 = 1000.0;

/// Returns a step to a contact of the given radius. The shift is the given fraction of the shift at which the whole
/// contact would slip.
fn step_to((radius, part): (f64, f64)) -> LoadStep {
    let approach = radius * radius / RADIUS;
    let shift = TangentialControl::Shift(part * FRICTION * approach);
    LoadStep::hold()
        .normal(NormalLoad::Approach(approach))
        .tangential(Axis::X, shift)
}

fn sphere_gap(grid: Grid) -> Field {
    kit::sphere(grid, RADIUS)
}

fn new_history(
    bodies: &HalfSpace,
    gap: &Field,
    model: TangentialModel,
    coupling: Coupling,
) -> History {
    let builder = History::builder(bodies, gap, kit::coulomb(FRICTION));
    let builder = builder.model(model).coupling(coupling).tolerance(1e-9);
    builder.entry_rule(EntryRule::WholeStep).build().unwrap()
}

/// Returns one history of each kind.
fn histories() -> Vec<History> {
    let grid = kit::square(96, 96.0);
    let mut bumpy = sphere_gap(grid);
    bumpy.add_scaled(2e-4, &rough(grid, 3)).unwrap();
    let alike = unit_bodies(grid, 0.3);
    let (soft, hard) = (Material::new(1.0, 0.1).unwrap(), Material::rigid());
    let unlike = HalfSpace::new(grid, ElasticPair::new(soft, hard).unwrap()).unwrap();
    let [scalar, vector] = [TangentialModel::Scalar, TangentialModel::Vector];
    vec![
        new_history(&alike, &sphere_gap(grid), scalar, Coupling::Full),
        new_history(&alike, &bumpy, scalar, Coupling::Full),
        new_history(&alike, &bumpy, vector, Coupling::Full),
        new_history(&unlike, &bumpy, scalar, Coupling::OneWay),
        new_history(&unlike, &sphere_gap(grid), vector, Coupling::Full),
    ]
}

/// Returns a history on a grid that is periodic along y. Its windows are cropped only along x.
fn periodic_history() -> History {
    let grid = kit::square(96, 96.0);
    let [.., along_y] = boundaries(grid);
    let bodies = HalfSpace::with_boundary(grid, unit_pair(0.3), along_y).unwrap();
    new_history(
        &bodies,
        &sphere_gap(grid),
        TangentialModel::Scalar,
        Coupling::Full,
    )
}

/// The length of a saved state depends on the windows.
#[test]
fn window_state_after_shrinking_is_small() {
    // If pressure and traction are coupled, the state covers the whole grid.
    let is_joint = |history: &History| {
        let state = history.state();
        state.pair().is_coupled() && state.coupling() == Coupling::Full
    };
    for mut history in histories().into_iter().filter(|history| !is_joint(history)) {
        let empty = history.to_bytes().len();
        let windows = |history: &History| history.to_bytes().len() - empty;
        let mut small = history.clone();
        small.step(&step_to((8.0, 0.0))).unwrap();
        history.step(&step_to((36.0, 0.0))).unwrap();
        let large = windows(&history);
        for part in [0.1, 0.2, -0.1] {
            history.step(&step_to((8.0, part))).unwrap();
            small.step(&step_to((8.0, part))).unwrap();
        }
        assert!(3 * windows(&history) < large);
        // One of the two histories has margins for growth.
        assert!(windows(&history) < 4 * windows(&small));
    }
}

/// Windows of rows on a periodic axis are cropped along x only. After shrinking, the state is shorter but still has
/// three numbers for every cell of the columns in contact, which remain whole.
#[test]
fn window_on_periodic_rows_keeps_whole_columns() {
    let mut history = periodic_history();
    let grid = history.grid();
    let numbers = |history: &History| history.to_bytes().len() / size_of::<f64>();
    let empty = numbers(&history);
    for load in [(36.0, 0.0), (8.0, 0.1)] {
        history.step(&step_to(load)).unwrap();
    }
    let large = numbers(&history);
    for part in [0.2, -0.1] {
        history.step(&step_to((8.0, part))).unwrap();
        let pressure = history.pressure().as_slice();
        let touches = |ix: &usize| (0..grid.ny()).any(|iy| pressure[iy * grid.nx() + ix] > 0.0);
        let columns = (0..grid.nx()).filter(touches).count();
        let least = empty + 3 * columns * grid.ny();
        assert!((least..large).contains(&numbers(&history)));
    }
}

/// Small contacts that were never large have the same solutions.
#[test]
fn window_shrinking_without_slip_leaves_no_trace() {
    for mut history in histories() {
        let unsheared = |radius| step_to((radius, 0.0));
        // Pressing causes slip of coupled bodies even without shear.
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
                history.step(&step_to((8.0, part))).unwrap();
            }
            let [a, b] = [&history, &small].map(|history| history.traction()[0].as_slice());
            assert!(max_difference(a, b) < 1e-6 * max_abs(a));
            let [a, b] = [&history, &small].map(|history| history.last_step().unwrap().energy());
            let difference = a.dissipated_energy - b.dissipated_energy;
            assert!(difference.abs() < 1e-6 * a.elastic_after);
        }
    }
}
