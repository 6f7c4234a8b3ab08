//! A rank stores only its local part of a distributed grid.

use std::sync::Arc;
use std::time::Duration;

use kit::unit_pair;
use stickslip::influence::Component;
use stickslip::ranks::Threads;
use stickslip::{Boundary, Field, Grid, HalfSpace, Operator};

/// Returns the largest number of bytes that a rank stores after products in both precisions, for bodies, operator,
/// buffers and fields.
fn max_bytes(size: usize, grid: Grid, boundary: Boundary) -> f64 {
    let hold = |rank: Threads| {
        let mut kept = None;
        let make = || {
            let pair = unit_pair(0.3);
            let bodies = HalfSpace::distributed(grid, pair, boundary, Arc::new(rank)).unwrap();
            let operator = bodies.operator(Component::ZZ).unwrap();
            let mut workspace = operator.scratch().unwrap();
            let pressure = Field::from_fn(bodies.grid(), |x, y| x.cos() + y.sin());
            let mut out = Field::zeros(bodies.grid());
            let x = [pressure.as_slice()];
            operator.apply(x, [out.as_mut_slice()], &mut workspace);
            operator.apply_f32(x, [out.as_mut_slice()], &mut workspace);
            kept = Some((bodies, operator, workspace, pressure, out));
        };
        allocation_counter::measure(make).bytes_current
    };
    // Only the allocations of one thread are counted, so each rank has one thread.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let ranks = || Threads::run(size, Duration::from_secs(120), hold);
    let bytes = pool.unwrap().install(ranks);
    bytes.into_iter().max().unwrap() as f64
}

/// With twice the number of ranks, each rank stores half as much, in addition to a fixed part. The fixed part consists
/// of a band of columns and the tables of the transforms.
#[test]
fn rank_memory_is_proportional_to_its_part() {
    // A free grid is transformed on twice as many cells along each side.
    for (boundary, cells) in [
        (Boundary::NonPeriodic, kit::thorough(512, 1024)),
        (Boundary::Periodic, 1024),
    ] {
        let grid = Grid::square(cells, 8.0).unwrap();
        let alone = max_bytes(1, grid, boundary);
        for &size in kit::thorough(&[2][..], &[2, 4]) {
            let part = 1.0 / size as f64;
            let fixed_part = (max_bytes(size, grid, boundary) / alone - part) / (1.0 - part);
            assert!(
                fixed_part < 0.03,
                "{boundary:?}, {size} ranks: {fixed_part}"
            );
        }
    }
}
