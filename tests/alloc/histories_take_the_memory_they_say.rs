//! A history takes the bytes per cell that its documentation says.

use kit::unit_bodies;
use stickslip::{
    Axis, Friction, Grid, HalfSpace, History, LoadStep, NormalControl, TangentialControl,
    TangentialModel, surface,
};

const RADIUS: f64 = 1000.0;

/// Pressed until the contact has about this radius, sheared while it grows, and eased a little.
fn history(bodies: &HalfSpace, lateral: TangentialModel, contact_radius: f64) -> History {
    let sphere = surface::sphere(bodies.grid(), RADIUS).unwrap();
    let builder = History::builder(bodies, &sphere, Friction::coulomb(0.4).unwrap());
    let mut history = builder.tolerance(1e-4).model(lateral).build().unwrap();
    let approach = contact_radius * contact_radius / RADIUS;
    let shift = LoadStep::hold().tangential(Axis::X, TangentialControl::Shift(1.0));
    for approach in [approach, 0.999 * approach] {
        let step = shift.normal(NormalControl::Approach(approach));
        history.step(&step).unwrap();
    }
    history
}

/// Cells of the contact's bounding box, and bytes of the history beside the bodies.
fn measured(bodies: &HalfSpace, lateral: TangentialModel, contact_radius: f64) -> [f64; 2] {
    // What the bodies keep for all histories is made by the first.
    drop(history(bodies, lateral, contact_radius));
    // Only the allocations of one thread are counted: the steps must run on it.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
    let (mut kept, pool) = (None, pool.build().unwrap());
    let bytes = pool.install(|| {
        let make = || kept = Some(history(bodies, lateral, contact_radius));
        allocation_counter::measure(make).bytes_current
    });
    let kept = kept.unwrap();
    let (grid, pressure) = (bodies.grid(), kept.pressure());
    let touches = |ix, iy| pressure.get(ix, iy).is_some_and(|p| p > 0.0);
    let columns = (0..grid.nx()).filter(|&ix| (0..grid.ny()).any(|iy| touches(ix, iy)));
    let rows = (0..grid.ny()).filter(|&iy| (0..grid.nx()).any(|ix| touches(ix, iy)));
    [(columns.count() * rows.count()) as f64, bytes as f64]
}

#[test]
fn per_cell_of_the_grid_and_of_the_contact() {
    let grid = Grid::square(512, 512.0).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    for (lateral, per_contact_cell) in [
        (TangentialModel::Scalar, 395.0),
        (TangentialModel::Vector, 670.0),
    ] {
        let [[small, less], [large, more]] =
            [100.0, 155.0].map(|radius| measured(&bodies, lateral, radius));
        let slope = (more - less) / (large - small);
        assert!((slope / per_contact_cell - 1.0).abs() < 0.05, "{slope}");
        // A megabyte or two whatever the size.
        let per_cell = (less - slope * small) / grid.cells() as f64;
        assert!((per_cell - 180.0).abs() < 10.0, "{per_cell}");
    }
}
