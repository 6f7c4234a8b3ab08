//! Results are bitwise identical on any number of threads, in any pool and during any other work. The binary
//! `tests/determinism` runs without threads.

use kit::{rough, unit_bodies};
use stickslip::{
    Field, Grid, HalfSpace, NormalLoad, NormalProblem, NormalSolution, TangentialLoad,
    TangentialModel, TangentialProblem, TangentialSolution,
};

fn solve() -> (NormalSolution, [TangentialSolution; 2]) {
    let grid = Grid::new(150, 133, 1.0, 1.1).unwrap();
    solve_on(&unit_bodies(grid, 0.3), &rough(grid, 21))
}

fn solve_on(bodies: &HalfSpace, gap: &Field) -> (NormalSolution, [TangentialSolution; 2]) {
    let normal = NormalProblem::builder(bodies, gap, NormalLoad::Force(60.0));
    let normal = kit::solve(normal);
    let load = TangentialLoad::force([12.0, 0.0]);
    let friction = kit::coulomb(0.4);
    let shear = [TangentialModel::Scalar, TangentialModel::Vector].map(|lateral| {
        let shear = TangentialProblem::builder(bodies, &normal, friction.clone(), load);
        kit::solve(shear.model(lateral))
    });
    (normal, shear)
}

/// Many threads solve simultaneously with one half-space. The first thread that needs an operator computes it for all.
#[test]
fn concurrent_solves_on_same_bodies_are_bitwise_identical() {
    let grid = Grid::new(70, 61, 1.0, 1.1).unwrap();
    let gap = rough(grid, 22);
    let alone = solve_on(&unit_bodies(grid, 0.3), &gap);
    let shared = unit_bodies(grid, 0.3);
    let answers: Vec<_> = std::thread::scope(|scope| {
        let solve = || scope.spawn(|| solve_on(&shared.clone(), &gap));
        let threads: Vec<_> = (0..6).map(|_| solve()).collect();
        threads
            .into_iter()
            .map(|thread| thread.join().unwrap())
            .collect()
    });
    for answer in answers {
        assert_same(&answer, &alone);
    }
}

type Solutions = (NormalSolution, [TangentialSolution; 2]);

/// Asserts that everything except the times is equal.
fn assert_same((normal, shear): &Solutions, (other_normal, other_shear): &Solutions) {
    assert_eq!(normal.pressure(), other_normal.pressure());
    assert_eq!(normal.gap(), other_normal.gap());
    assert_eq!(
        normal.approach().to_bits(),
        other_normal.approach().to_bits()
    );
    let costs = |normal: &NormalSolution| {
        let report = normal.report();
        (
            report.iterations,
            report.double_precision_products,
            report.single_precision_products,
        )
    };
    assert_eq!(costs(normal), costs(other_normal));
    for (shear, other) in shear.iter().zip(other_shear) {
        assert_eq!(shear.traction(), other.traction());
        assert_eq!(shear.slip(), other.slip());
        assert_eq!(shear.zones(), other.zones());
        assert_eq!(shear.shift(), other.shift());
    }
}

#[cfg(feature = "parallel")]
fn pool_of(threads: usize) -> rayon::ThreadPool {
    let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
    builder.build().unwrap()
}

/// Solves in a pool of the caller, in a pool within a pool, and as tasks that wait for each other's threads.
#[cfg(feature = "parallel")]
#[test]
fn solves_in_pools_of_caller_are_bitwise_identical() {
    use rayon::prelude::*;

    let grid = Grid::new(70, 61, 1.0, 1.1).unwrap();
    let gap = rough(grid, 22);
    let bodies = unit_bodies(grid, 0.3);
    let alone = pool_of(1).install(|| solve_on(&bodies, &gap));
    let nested = pool_of(2).install(|| pool_of(3).install(|| solve_on(&bodies, &gap)));
    assert_same(&nested, &alone);
    for threads in [1, 2, 3] {
        let tasks = (0..5).into_par_iter();
        let answers: Vec<_> =
            pool_of(threads).install(|| tasks.map(|_| solve_on(&bodies, &gap)).collect());
        for answer in answers {
            assert_same(&answer, &alone);
        }
    }
    let (left, right) = pool_of(2).install(|| {
        rayon::join(
            || pool_of(1).install(|| solve_on(&bodies, &gap)),
            || solve_on(&bodies, &gap),
        )
    });
    assert_same(&left, &alone);
    assert_same(&right, &alone);
}

#[cfg(feature = "parallel")]
#[test]
fn solves_on_1_2_4_and_7_threads_are_bitwise_identical() {
    let one = pool_of(1).install(solve);
    for threads in [2, 4, 7] {
        assert_same(&pool_of(threads).install(solve), &one);
    }
}
