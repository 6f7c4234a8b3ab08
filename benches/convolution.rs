//! Time of a product with the normal compliance in either precision, and time of its setup.

#![allow(
    missing_docs,
    reason = "the macros of criterion write functions without"
)]

use std::hint::black_box;

use criterion::measurement::WallTime;
use criterion::{
    BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main,
};
use stickslip::influence::{Component, Table};
use stickslip::{ElasticPair, Field, Grid, HalfSpace, Material, Operator, Result};

const SIDES: [usize; 3] = [256, 512, 1024];

fn bodies(cells_along_side: usize) -> Result<HalfSpace> {
    let steel = Material::new(213e9, 0.29)?;
    let grid = Grid::square(cells_along_side, 0.40e-3)?;
    HalfSpace::new(grid, ElasticPair::new(steel, steel)?)
}

/// Creates a benchmark group whose throughput is measured in cells.
fn group<'a>(
    criterion: &'a mut Criterion,
    name: &str,
    side: usize,
) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group.sample_size(10);
    group.throughput(Throughput::Elements((side * side) as u64));
    group
}

/// Measures the time to compute displacements from pressures in either precision, and pressures from displacements by
/// the preconditioner, without the setup.
fn product(criterion: &mut Criterion) {
    for side in SIDES {
        let bodies = bodies(side).expect("valid bodies");
        let operator = bodies.operator(Component::ZZ).expect("valid grid");
        let inverse = bodies.preconditioner(Component::ZZ).expect("valid grid");
        let inverse = inverse.expect("a compliance has one");
        let pressure = Field::from_fn(bodies.grid(), |x, y| (1e4 * x).sin() + (2e4 * y).cos());
        let pressure = pressure.as_slice();
        let mut out = vec![0.0; operator.cells()];
        let mut scratch = operator.scratch().expect("memory for a product");
        let mut group = group(criterion, "convolution", side);
        group.bench_function(BenchmarkId::new("double", side), |bencher| {
            bencher.iter(|| operator.apply([black_box(pressure)], [&mut out], &mut scratch));
        });
        group.bench_function(BenchmarkId::new("single", side), |bencher| {
            bencher.iter(|| operator.apply_f32([black_box(pressure)], [&mut out], &mut scratch));
        });
        let mut scratch = inverse.scratch().expect("memory for a product");
        group.bench_function(BenchmarkId::new("preconditioner", side), |bencher| {
            bencher.iter(|| inverse.apply([black_box(pressure)], [&mut out], &mut scratch));
        });
        group.finish();
    }
}

/// Measures the time to compute the influence coefficients alone, and together with their spectrum and the plans of the
/// transforms.
fn set_up(criterion: &mut Criterion) {
    for side in SIDES {
        let mut group = group(criterion, "set-up", side);
        group.bench_function(BenchmarkId::new("kernel table", side), |bencher| {
            let bodies = bodies(side).expect("valid bodies");
            bencher.iter(|| Table::sample(bodies.grid(), bodies.pair(), Component::ZZ));
        });
        group.bench_function(BenchmarkId::new("operator", side), |bencher| {
            bencher
                .iter(|| bodies(black_box(side)).and_then(|bodies| bodies.operator(Component::ZZ)));
        });
        group.finish();
    }
}

criterion_group!(benches, product, set_up);
criterion_main!(benches);
