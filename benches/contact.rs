//! Times of solves for smooth and rough contacts. Normal and tangential solves have a cold start and existing
//! operators. A step of a fretting loop starts from the previous step.

#![allow(
    missing_docs,
    reason = "the macros of criterion write functions without"
)]

use criterion::measurement::WallTime;
use criterion::{
    BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main,
};
use kit::benchmark::{self, BenchmarkCase};
use stickslip::cgm::Method;
use stickslip::{Field, Result, TangentialLoad};

const SIDES: [u16; 2] = [256, 512];
const TOLERANCE: f64 = 1e-6;

fn scenes(side: u16) -> Result<Vec<BenchmarkCase>> {
    let mut scenes = vec![benchmark::ball(side)?];
    scenes.extend(benchmark::rough(side)?);
    Ok(scenes)
}

/// Creates a benchmark group whose throughput is measured in cells.
fn group<'a>(criterion: &'a mut Criterion, name: &str, side: u16) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group.sample_size(10);
    group.throughput(Throughput::Elements(u64::from(side).pow(2)));
    group
}

fn normal(criterion: &mut Criterion) {
    for side in SIDES {
        for scene in scenes(side).expect("valid scenes") {
            let problem = scene.normal(Method::ActiveSet, TOLERANCE);
            let problem = problem.expect("valid problem");
            let mut solver = problem.into_solver().expect("valid grid");
            let mut solution = solver.new_solution();
            let mut group = group(criterion, "normal", side);
            group.bench_function(BenchmarkId::new(scene.name, side), |bencher| {
                bencher.iter(|| {
                    solver.reset();
                    solver.solve_into(&mut solution).expect("converged");
                });
            });
            group.finish();
        }
    }
}

fn tangential(criterion: &mut Criterion) {
    for side in SIDES {
        for scene in scenes(side).expect("valid scenes") {
            let pressed = scene
                .normal(Method::ActiveSet, TOLERANCE)
                .and_then(|problem| problem.solve())
                .expect("converged");
            let problem = scene.tangential(&pressed, Method::ActiveSet, TOLERANCE);
            let mut solver = problem.expect("valid problem").into_solver().expect("grid");
            let mut solution = solver.new_solution();
            let mut group = group(criterion, "tangential", side);
            group.bench_function(BenchmarkId::new(scene.name, side), |bencher| {
                bencher.iter(|| {
                    solver.reset();
                    solver.solve_into(&mut solution).expect("converged");
                });
            });
            group.finish();
        }
    }
}

/// Measures a step with a small change of the gap by wear and a small change of the load. Both subproblems start from
/// their last solutions.
fn fretting_step(criterion: &mut Criterion) {
    for side in SIDES {
        let scene = benchmark::ball(side).expect("valid scene");
        let problem = scene.normal(Method::ActiveSet, TOLERANCE);
        let mut press = problem.expect("valid problem").into_solver().expect("grid");
        let mut pressed = press.new_solution();
        press.solve_into(&mut pressed).expect("converged");
        let problem = scene.tangential(&pressed, Method::ActiveSet, TOLERANCE);
        let mut shear = problem.expect("valid problem").into_solver().expect("grid");
        let mut sheared = shear.new_solution();
        shear.solve_into(&mut sheared).expect("converged");

        let force = pressed.force();
        let depth = 1e-4 * pressed.approach() / pressed.pressure().max();
        let worn: Vec<Field> = (1..=8)
            .map(|step| {
                let mut gap = scene.gap.clone();
                let cells = gap.as_mut_slice().iter_mut();
                for (gap, pressure) in cells.zip(pressed.pressure().as_slice()) {
                    *gap += f64::from(step) * depth * pressure;
                }
                gap
            })
            .collect();
        let mut step = 0;
        let mut group = group(criterion, "fretting step", side);
        group.bench_function(BenchmarkId::from_parameter(side), |bencher| {
            bencher.iter(|| {
                step += 1;
                press.set_gap(&worn[step % worn.len()]).expect("gap");
                press.solve_into(&mut pressed).expect("converged");
                shear.set_pressure(&pressed).expect("contact");
                let fraction = 0.2 * (0.3 * step as f64).sin();
                let load = TangentialLoad::force([fraction * force, 0.0]);
                shear.set_load(load).expect("below sliding");
                shear.solve_into(&mut sheared).expect("converged");
            });
        });
        group.finish();
    }
}

criterion_group!(benches, normal, tangential, fretting_step);
criterion_main!(benches);
