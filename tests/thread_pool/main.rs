//! Work too short to be parallelised stays off the thread pool. This is a separate program, because nothing else may
//! start its global pool.

#![allow(clippy::unwrap_used, reason = "tests panic on failure")]

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

/// Presses and shears a ball once, so that the buffers for the next steps exist.
fn started(bodies: &HalfSpace, model: TangentialModel) -> History {
    let ball = surface::sphere(bodies.grid(), 10.0).unwrap();
    let builder = History::builder(bodies, &ball, Friction::coulomb(0.3).unwrap());
    let builder = builder.model(model).coupling(Coupling::Neglected);
    let mut history = builder.build().unwrap();
    history.step(&load(0)).unwrap();
    history
}

fn load(step: u32) -> LoadStep {
    let part = f64::from(step).sin();
    LoadStep::force([0.05 * part, 0.0]).normal(NormalLoad::Force(0.5 + 0.01 * part))
}

/// Takes steps on a thread outside any pool, which would start the global pool if it shared its work.
fn run(history: &mut History) {
    let steps = || {
        for step in 1..6 {
            history.step(&load(step)).unwrap();
        }
    };
    thread::scope(|scope| scope.spawn(steps).join().unwrap());
}

/// Returns the number of threads of this process, if the system reports it.
fn threads() -> Option<usize> {
    std::fs::read_dir("/proc/self/task")
        .ok()
        .map(Iterator::count)
}

/// The work runs on a thread outside any pool, which would start the global pool if any work were shared.
fn assert_few_cells_stay_off_pool() {
    let mut checks = 0;
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
            checks += 1;
        };
        few_cells::operators(grid, &mut watch);
        if grid.nx() > 1 {
            few_cells::surfaces(grid, &mut watch);
            few_cells::solutions(grid, &mut watch);
            few_cells::histories(grid, &mut watch);
        }
    }
    assert!(checks > 30);
}

/// Returns whether a step on this many cells runs on a thread other than the caller's, and its results.
fn observe_step(cells: usize) -> (bool, [f64; 2], Field) {
    let bodies = HalfSpace::new(Grid::square(cells, 8.0).unwrap(), pair()).unwrap();
    let mut history = started(&bodies, TangentialModel::Scalar);
    let own = thread::current().id();
    let mut is_elsewhere = false;
    let see = |_: &Iteration| {
        is_elsewhere |= thread::current().id() != own;
        ControlFlow::Continue(())
    };
    history.step_observed(&load(1), see).unwrap();
    let energy = history.accumulated_dissipation().integral();
    let stiffness = history.stiffness().unwrap().normal.value;
    let pressure = history.pressure().clone();
    (is_elsewhere, [energy, stiffness], pressure)
}

#[test]
fn work_on_few_cells_stays_off_pool() {
    // This check comes first, while no other pool starts or ends threads.
    assert_few_cells_stay_off_pool();

    // Steps on a thread outside any pool stay on this thread, even if their contact was created in a pool.
    let apart = rayon::ThreadPoolBuilder::new()
        .num_threads(3)
        .build()
        .unwrap();
    let grid = Grid::square(64, 8.0).unwrap();
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let bodies = HalfSpace::new(grid, pair()).unwrap();
        run(&mut apart.install(|| started(&bodies, model)));
        apart.install(|| {
            Threads::run(3, Duration::from_secs(60), |rank| {
                let boundary = Boundary::NonPeriodic;
                let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank));
                run(&mut started(&bodies.unwrap(), model));
            });
        });
    }
    // The global pool can be built only once, and any work shared outside of pools would have built it.
    let global = rayon::ThreadPoolBuilder::new().num_threads(1);
    assert!(global.build_global().is_ok(), "something entered the pool");

    // Steps on more cells are shared, unless the global pool is disabled, with bitwise identical results.
    let (is_elsewhere, numbers, pressure) = observe_step(80);
    assert!(is_elsewhere);
    disable_global_pool();
    assert!((false, numbers, pressure.clone()) == observe_step(80));
    let in_own = apart.install(|| observe_step(80));
    assert_eq!((in_own.1, in_own.2), (numbers, pressure));
}
