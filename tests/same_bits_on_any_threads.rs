//! The same bits on any number of threads, and without.

#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "a test fails loudly, compares exact results, and counts small things"
)]

mod common;

use common::{rough, unit_bodies};
use stickslip::{
    Friction, Grid, NormalLoad, NormalProblem, NormalSolution, TangentialLoad, TangentialProblem,
    TangentialSolution,
};

fn solve() -> (NormalSolution, TangentialSolution) {
    let grid = Grid::new(150, 133, 1.0, 1.1).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let gap = rough(grid, 21);
    let normal = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(60.0));
    let normal = normal.build().unwrap().solve().unwrap();
    let load = TangentialLoad::Force([12.0, 0.0]);
    let friction = Friction::coulomb(0.4).unwrap();
    let shear = TangentialProblem::builder(&bodies, &normal, friction, load);
    (normal.clone(), shear.build().unwrap().solve().unwrap())
}

/// Leaves the bits of a solve behind, in a file for each way to build the crate: `.ci/run` compares them.
#[test]
fn with_threads_and_without() {
    let (normal, shear) = solve();
    let [along_x, along_y] = shear.traction();
    let fields = [normal.pressure(), normal.gap(), along_x, along_y];
    let samples = fields.iter().flat_map(|field| field.as_slice());
    let scalars = [normal.approach(), shear.shift()[0]];
    let bits: Vec<u8> = samples
        .chain(&scalars)
        .flat_map(|value| value.to_bits().to_le_bytes())
        .collect();
    let way = if cfg!(feature = "parallel") {
        "bits_with_threads"
    } else {
        "bits_without_threads"
    };
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(folder.join(way), &bits).unwrap();

    // Here at least: again the same.
    let (again, _) = solve();
    assert_eq!(normal.pressure(), again.pressure());
}

#[cfg(feature = "parallel")]
#[test]
fn on_one_two_four_and_seven_threads() {
    let solve_on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(solve)
    };
    let (normal, shear) = solve_on(1);
    for threads in [2, 4, 7] {
        let (other_normal, other_shear) = solve_on(threads);
        assert_eq!(normal.pressure(), other_normal.pressure());
        assert_eq!(
            normal.approach().to_bits(),
            other_normal.approach().to_bits()
        );
        assert_eq!(shear.traction(), other_shear.traction());
        assert_eq!(shear.zones(), other_shear.zones());
        assert_eq!(shear.shift(), other_shear.shift());
        assert_eq!(
            normal.report().convolutions,
            other_normal.report().convolutions
        );
    }
}
