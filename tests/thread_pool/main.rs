//! Work too short to share stays off the pool: a program of its own, whose global pool nothing else may start.

#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

mod few_cells;

use std::ops::ControlFlow;
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

/// Threads of this process, where the system tells them.
fn threads() -> Option<usize> {
    std::fs::read_dir("/proc/self/task")
        .ok()
        .map(Iterator::count)
}

/// On a thread of no pool, which would start the global one if anything shared its work.
fn nothing_on_few_cells_enters_the_pool() {
    let mut looks = 0;
    for grid in [
        Grid::square(64, 8.0).unwrap(),
        Grid::new(9, 12, 0.8, 0.6).unwrap(),
        Grid::new(1, 12, 0.8, 0.6).unwrap(),
    ] {
        assert!(grid.cells() <= SERIAL_CELL_LIMIT);
        let mut watch = |what: &str, work: &mut dyn FnMut() -> Result<()>| {
            let before = threads();
            work().unwrap_or_else(|error| panic!("{what} on {grid:?}: {error}"));
            assert_eq!(threads(), before, "{what} on {grid:?} starts threads");
            looks += 1;
        };
        few_cells::operators(grid, &mut watch);
        if grid.nx() > 1 {
            few_cells::surfaces(grid, &mut watch);
            few_cells::solutions(grid, &mut watch);
            few_cells::histories(grid, &mut watch);
        }
    }
    assert!(looks > 30);
}

/// Whether a step on so many cells is taken by another thread than that which calls, and what it comes to.
fn step_elsewhere(cells: usize) -> (bool, [f64; 2], Field) {
    let bodies = HalfSpace::new(Grid::square(cells, 8.0).unwrap(), pair()).unwrap();
    let mut history = begun(&bodies, TangentialModel::Scalar);
    let own = thread::current().id();
    let mut is_elsewhere = false;
    let see = |_: &Iteration| {
        is_elsewhere |= thread::current().id() != own;
        ControlFlow::Continue(())
    };
    history.step_observed(&load(1), see).unwrap();
    let energy = history.dissipated_energy().integral();
    let stiffness = history.stiffness().unwrap().normal.value;
    let pressure = history.pressure().clone();
    (is_elsewhere, [energy, stiffness], pressure)
}

#[test]
fn work_on_few_cells_does_not_enter_the_pool() {
    // First, while no other pool has threads that come or go.
    nothing_on_few_cells_enters_the_pool();

    // Nor do steps on the thread of no pool, of a contact that was begun in one.
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
    assert!(global.build_global().is_ok(), "something entered the pool");

    // Steps of more cells do share, unless the global pool is avoided, with the same bits.
    let (is_elsewhere, numbers, pressure) = step_elsewhere(80);
    assert!(is_elsewhere);
    disable_global_pool();
    assert!((false, numbers, pressure.clone()) == step_elsewhere(80));
    let in_own = apart.install(|| step_elsewhere(80));
    assert_eq!((in_own.1, in_own.2), (numbers, pressure));
}
