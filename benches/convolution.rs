//! What one product with the normal compliance costs, and what setting it up costs.

#![allow(
    missing_docs,
    reason = "the macros of criterion write functions without"
)]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use stickslip::influence::Component;
use stickslip::{ElasticPair, Field, Grid, HalfSpace, Material, Operator, Result};

const SIDES: [usize; 3] = [128, 256, 512];

fn bodies(cells_along_side: usize) -> Result<HalfSpace> {
    let steel = Material::new(213e9, 0.29)?;
    let grid = Grid::square(cells_along_side, 0.40e-3)?;
    HalfSpace::new(grid, ElasticPair::new(steel, steel)?)
}

/// Displacements from pressures, with everything set up.
fn product(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("product");
    group.sample_size(10);
    for side in SIDES {
        let bodies = bodies(side).expect("valid bodies");
        let operator = bodies.operator(Component::ZZ).expect("valid grid");
        let pressure = Field::from_fn(bodies.grid(), |x, y| (1e4 * x).sin() + (2e4 * y).cos());
        let mut displacement = vec![0.0; operator.len()];
        let mut workspace = operator.workspace();
        group.throughput(Throughput::Elements(operator.len() as u64));
        group.bench_function(BenchmarkId::from_parameter(side), |bencher| {
            bencher.iter(|| {
                operator.apply(
                    black_box(pressure.as_slice()),
                    &mut displacement,
                    &mut workspace,
                );
            });
        });
    }
    group.finish();
}

/// Influence coefficients, their spectrum and the plans of the transforms.
fn set_up(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("set-up");
    group.sample_size(10);
    for side in SIDES {
        group.throughput(Throughput::Elements((side * side) as u64));
        group.bench_function(BenchmarkId::from_parameter(side), |bencher| {
            bencher
                .iter(|| bodies(black_box(side)).and_then(|bodies| bodies.operator(Component::ZZ)));
        });
    }
    group.finish();
}

criterion_group!(benches, product, set_up);
criterion_main!(benches);
