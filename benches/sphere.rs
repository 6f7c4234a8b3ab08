//! What the contact of a sphere costs from a cold start: the normal problem, then the tangential.

#![allow(
    missing_docs,
    reason = "the macros of criterion write functions without"
)]

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use stickslip::{
    ElasticPair, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem, Result,
    TangentialLoad, TangentialProblem, surface,
};

const SIDES: [usize; 2] = [256, 512];
const TOLERANCE: f64 = 1e-6;

/// Table 2 of the paper, in SI units, on a square of about three contact radii.
fn press(cells_along_side: usize) -> Result<(HalfSpace, NormalProblem)> {
    let steel = Material::new(213e9, 0.29)?;
    let grid = Grid::square(cells_along_side, 0.40e-3)?;
    let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
    let ball = surface::sphere(grid, 3.5e-3)?;
    let problem = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(100.0))
        .tolerance(TOLERANCE)
        .build()?;
    Ok((bodies, problem))
}

fn shear(cells_along_side: usize) -> Result<TangentialProblem> {
    let (bodies, press) = press(cells_along_side)?;
    let load = TangentialLoad::Force([20.0, 0.0]);
    TangentialProblem::builder(&bodies, &press.solve()?, Friction::coulomb(0.5)?, load)
        .tolerance(TOLERANCE)
        .build()
}

fn normal(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("normal sphere");
    group.sample_size(10);
    for side in SIDES {
        let (_, problem) = press(side).expect("valid scene");
        let mut solver = problem.into_solver().expect("valid grid");
        let mut solution = solver.new_solution();
        group.bench_function(BenchmarkId::from_parameter(side), |bencher| {
            bencher.iter(|| {
                solver.reset();
                solver.solve_into(&mut solution).expect("converged");
            });
        });
    }
    group.finish();
}

fn tangential(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("tangential sphere");
    group.sample_size(10);
    for side in SIDES {
        let problem = shear(side).expect("valid scene");
        let mut solver = problem.into_solver().expect("valid grid");
        let mut solution = solver.new_solution();
        group.bench_function(BenchmarkId::from_parameter(side), |bencher| {
            bencher.iter(|| {
                solver.reset();
                solver.solve_into(&mut solution).expect("converged");
            });
        });
    }
    group.finish();
}

criterion_group!(benches, normal, tangential);
criterion_main!(benches);
