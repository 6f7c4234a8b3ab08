//! A history uses the documented number of bytes per cell.

use kit::unit_bodies;
use stickslip::{
    Axis, Friction, Grid, HalfSpace, History, LoadStep, NormalLoad, TangentialControl,
    TangentialModel, surface,
};

const RADIUS: f64 = 1000.0;

/// Presses until the contact has about this radius, shears while it grows, and unloads slightly.
fn history(bodies: &HalfSpace, lateral: TangentialModel, contact_radius: f64) -> History {
    let sphere = surface::sphere(bodies.grid(), RADIUS).unwrap();
    let builder = History::builder(bodies, &sphere, Friction::coulomb(0.4).unwrap());
    let mut history = builder.tolerance(1e-4).model(lateral).build().unwrap();
    let approach = contact_radius * contact_radius / RADIUS;
    let shift = LoadStep::hold().tangential(Axis::X, TangentialControl::Shift(1.0));
    for approach in [approach, 0.999 * approach] {
        let step = shift.normal(NormalLoad::Approach(approach));
        history.step(&step).unwrap();
    }
    history
}

/// Returns the number of cells in the window of the contact and three numbers of bytes: of a first history without the
/// bodies, of a second history, and of a state.
fn measured(bodies: &HalfSpace, lateral: TangentialModel, contact_radius: f64) -> [f64; 4] {
    // The first history creates the data that the bodies keep for all histories.
    drop(history(bodies, lateral, contact_radius));
    // Only the allocations of one thread are counted, so the steps must run on this thread.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
    let (mut kept, pool) = (Vec::new(), pool.build().unwrap());
    let [first, second] = [(); 2].map(|()| {
        pool.install(|| {
            let make = || kept.push(history(bodies, lateral, contact_radius));
            allocation_counter::measure(make).bytes_current
        })
    });
    let mut state = None;
    let copy = || state = Some(kept[0].state().clone());
    let copied = allocation_counter::measure(copy).bytes_current;
    let (grid, pressure) = (bodies.grid(), kept[0].pressure());
    let touches = |ix, iy| pressure.get(ix, iy).is_some_and(|p| p > 0.0);
    let columns = (0..grid.nx()).filter(|&ix| (0..grid.ny()).any(|iy| touches(ix, iy)));
    let rows = (0..grid.ny()).filter(|&iy| (0..grid.nx()).any(|ix| touches(ix, iy)));
    let cells = (columns.count() * rows.count()) as f64;
    [cells, first as f64, second as f64, copied as f64]
}

#[test]
fn history_uses_documented_bytes_per_cell() {
    let grid = Grid::square(512, 512.0).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    // Bytes per cell of the grid and per cell of the contact, for the first history, a second history and a state.
    let models = [
        (
            TangentialModel::Vector,
            [[168.0, 588.0], [121.0, 91.0], [81.0, 74.0]],
        ),
        (
            TangentialModel::Scalar,
            [[168.0, 347.0], [121.0, 51.0], [81.0, 34.0]],
        ),
    ];
    for (lateral, expected) in models.into_iter().take(kit::thorough(1, 2)) {
        let [small, large] = [100.0, 155.0].map(|radius| measured(&bodies, lateral, radius));
        for (what, [per_cell, per_contact_cell]) in (1..).zip(expected) {
            let slope = (large[what] - small[what]) / (large[0] - small[0]);
            // The rest includes one or two megabytes that do not depend on the size.
            let rest = (small[what] - slope * small[0]) / grid.cells() as f64;
            let difference = (slope - per_contact_cell).abs();
            assert!(difference < 0.02 * per_contact_cell + 1.0, "{slope}");
            assert!((rest - per_cell).abs() < 0.02 * per_cell, "{rest}");
        }
    }
}

/// If a large contact becomes small, the memory of the large contact is released after some time. Only the capacity of
/// the state remains.
#[test]
fn history_of_shrunk_contact_releases_memory() {
    let bodies = unit_bodies(Grid::square(256, 256.0).unwrap(), 0.3);
    let models = [
        (TangentialModel::Scalar, 34.0),
        (TangentialModel::Vector, 58.0),
    ];
    for (lateral, room) in models.into_iter().take(kit::thorough(1, 2)) {
        let [small, large] = [15.0, 75.0].map(|radius| measured(&bodies, lateral, radius));
        let mut kept = None;
        let work = || {
            let mut history = history(&bodies, lateral, 75.0);
            let press = LoadStep::hold().normal(NormalLoad::Approach(15.0 * 15.0 / RADIUS));
            history.step(&press).unwrap();
            for _ in 0..300 {
                history.step(&LoadStep::hold()).unwrap();
            }
            kept = Some(history);
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
        let found = pool.build().unwrap();
        let found = found.install(|| allocation_counter::measure(work).bytes_current) as f64;
        let allowed = small[1] + 1.2 * room * large[0];
        assert!(
            found < allowed && allowed < 0.8 * large[1],
            "{found} bytes, allowed {allowed}"
        );
    }
}
