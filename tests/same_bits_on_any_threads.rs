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
    Field, Friction, Grid, Lateral, NormalLoad, NormalProblem, NormalSolution, TangentialLoad,
    TangentialProblem, TangentialSolution,
};

fn solve() -> (NormalSolution, [TangentialSolution; 2]) {
    let grid = Grid::new(150, 133, 1.0, 1.1).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let gap = rough(grid, 21);
    let normal = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(60.0));
    let normal = normal.build().unwrap().solve().unwrap();
    let load = TangentialLoad::Force([12.0, 0.0]);
    let friction = Friction::coulomb(0.4).unwrap();
    let shear = [Lateral::Neglected, Lateral::Coupled].map(|lateral| {
        let shear = TangentialProblem::builder(&bodies, &normal, friction.clone(), load);
        shear.lateral(lateral).build().unwrap().solve().unwrap()
    });
    (normal, shear)
}

/// Leaves the bits of a solve behind, in a file for each way to build the crate: `.ci/run` compares them.
#[test]
fn with_threads_and_without() {
    let (normal, shear) = solve();
    let tractions = shear.iter().flat_map(TangentialSolution::traction);
    let fields = [normal.pressure(), normal.gap()]
        .into_iter()
        .chain(tractions);
    let samples = fields.flat_map(Field::as_slice);
    let scalars = [normal.approach(), shear[0].shift()[0], shear[1].shift()[0]];
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
        for (shear, other) in shear.iter().zip(&other_shear) {
            assert_eq!(shear.traction(), other.traction());
            assert_eq!(shear.zones(), other.zones());
            assert_eq!(shear.shift(), other.shift());
        }
        assert_eq!(
            normal.report().convolutions,
            other_normal.report().convolutions
        );
    }
}
