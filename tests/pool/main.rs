//! Steps too short to share stay off the pool: a program of their own, whose global pool nothing else may start.

#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use std::sync::Arc;
use std::thread;
use std::time::Duration;

use stickslip::ranks::Threads;
use stickslip::*;

fn pair() -> ElasticPair {
    ElasticPair::new(Material::new(1.0, 0.3).unwrap(), Material::rigid()).unwrap()
}

/// A ball that is pressed and sheared once: what the next steps need is made.
fn begun(bodies: &HalfSpace, model: TangentialModel) -> History {
    let ball = surface::sphere(bodies.grid(), 10.0).unwrap();
    let builder = History::builder(bodies, &ball, Friction::coulomb(0.3).unwrap());
    let builder = builder.model(model).coupling(Coupling::Neglected);
    let mut history = builder.build().unwrap();
    history.step(&load(0)).unwrap();
    history
}

fn load(step: u32) -> LoadStep {
    let part = f64::from(step).sin();
    LoadStep::force([0.05 * part, 0.0]).normal(NormalControl::Force(0.5 + 0.01 * part))
}

/// Steps on a thread of no pool, which would start the global one if it shared its work.
fn run(history: &mut History) {
    let steps = || {
        for step in 1..6 {
            history.step(&load(step)).unwrap();
        }
    };
    thread::scope(|scope| scope.spawn(steps).join().unwrap());
}

#[test]
fn warm_steps_of_few_cells_do_not_enter_the_pool() {
    // What is made first may be shared, on a pool of its own.
    let apart = rayon::ThreadPoolBuilder::new()
        .num_threads(3)
        .build()
        .unwrap();
    let grid = Grid::square(64, 8.0).unwrap();
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let bodies = HalfSpace::new(grid, pair()).unwrap();
        run(&mut apart.install(|| begun(&bodies, model)));
        apart.install(|| {
            Threads::run(3, Duration::from_secs(60), |rank| {
                let boundary = Boundary::NonPeriodic;
                let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank));
                run(&mut begun(&bodies.unwrap(), model));
            });
        });
    }
    // The global pool can be made once only, and whatever shares work outside of pools has it made.
    let global = rayon::ThreadPoolBuilder::new().num_threads(1);
    assert!(global.build_global().is_ok(), "a step entered the pool");

    // Steps of more cells do share.
    let grid = Grid::square(80, 8.0).unwrap();
    let bodies = HalfSpace::new(grid, pair()).unwrap();
    let mut history = begun(&bodies, TangentialModel::Scalar);
    let own = thread::current().id();
    let mut is_elsewhere = false;
    let see = |_: &Iteration| {
        is_elsewhere |= thread::current().id() != own;
        std::ops::ControlFlow::Continue(())
    };
    history.step_observed(&load(1), see).unwrap();
    assert!(is_elsewhere);
}
