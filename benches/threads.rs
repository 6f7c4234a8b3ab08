//! Scaling of solves and of batches of small contacts with the number of threads of a pool, as a table of milliseconds.
//! Arguments are the numbers of cells along the side of the single contacts (512, 1024 and 2048 by default).

#![allow(clippy::print_stdout, reason = "a table is printed")]

use std::time::Instant;

use kit::benchmark::{self, FRICTION};
use rayon::{ThreadPool, ThreadPoolBuilder};
use stickslip::cgm::Method;
use stickslip::{
    Axis, Friction, Grid, HalfSpace, History, LoadStep, NormalLoad, Result, TangentialControl,
    surface,
};

/// Numbers of cells along the side of a single contact. For a batch: number of cells along the side, and number of
/// contacts.
struct Sizes {
    sides: Vec<u16>,
    batches: &'static [(usize, usize)],
    repeats: usize,
}

const TOLERANCE: f64 = 1e-6;

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().collect();
    let sides: Vec<u16> = arguments
        .iter()
        .filter_map(|argument| argument.parse().ok())
        .collect();
    let sizes = if arguments.iter().any(|argument| argument == "--test") {
        Sizes {
            sides: vec![64],
            batches: &[(16, 4)],
            repeats: 1,
        }
    } else {
        Sizes {
            sides: if sides.is_empty() {
                vec![512, 1024, 2048]
            } else {
                sides
            },
            batches: &[(16, 4000), (64, 1000)],
            repeats: 5,
        }
    };
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let counts = [1, 2, 4, 8, 16, 32, 64];
    println!("{:26}{:>8}{:>10}{:>10}", "", "threads", "least", "median");
    for threads in counts.into_iter().take_while(|count| *count <= cores) {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.expect("threads can be started");
        pool.install(|| measure(&pool, &sizes))?;
    }
    Ok(())
}

fn measure(pool: &ThreadPool, sizes: &Sizes) -> Result<()> {
    let report = |what: String, mut times: Vec<f64>| {
        times.sort_by(f64::total_cmp);
        let (threads, median) = (pool.current_num_threads(), times[times.len() / 2]);
        println!("{what:26}{threads:8}{:10.2}{median:10.2}", times[0]);
    };
    for &side in &sizes.sides {
        let [_, rough, _] = benchmark::rough(side)?;
        for scene in [benchmark::ball(side)?, rough] {
            let mut press = scene.normal(Method::ActiveSet, TOLERANCE)?.into_solver()?;
            let mut pressed = press.new_solution();
            let times = timed(sizes.repeats, || {
                press.reset();
                press.solve_into(&mut pressed)
            })?;
            report(format!("{} pressure {side}", scene.name), times);
            let problem = scene.tangential(&pressed, Method::ActiveSet, TOLERANCE)?;
            let mut shear = problem.into_solver()?;
            let mut sheared = shear.new_solution();
            let times = timed(sizes.repeats, || {
                shear.reset();
                shear.solve_into(&mut sheared)
            })?;
            report(format!("{} shear {side}", scene.name), times);
        }
    }
    for &(side, contacts) in sizes.batches {
        let times = batch(side, contacts, sizes.repeats)?;
        report(format!("{contacts} contacts of {side}"), times);
    }
    Ok(())
}

/// Measures the time of a step of many balls under an oscillating force after a first cycle, in milliseconds.
fn batch(side: usize, contacts: usize, repeats: usize) -> Result<Vec<f64>> {
    let scene = benchmark::ball(64)?;
    let grid = Grid::square(side, scene.bodies.grid().area().sqrt())?;
    let bodies = HalfSpace::new(grid, *scene.bodies.pair())?;
    let balls = (0..contacts).map(|i| {
        let radius = 3e-3 * (1.0 + i as f64 / contacts as f64);
        let ball = surface::sphere(grid, radius)?;
        History::builder(&bodies, &ball, Friction::coulomb(FRICTION)?)
            .tolerance(1e-4)
            .build()
    });
    let mut histories = balls.collect::<Result<Vec<_>>>()?;
    let press = LoadStep::hold().normal(NormalLoad::Force(scene.force));
    let drag = |share: f64| {
        let force = share * FRICTION * scene.force;
        press.tangential(Axis::X, TangentialControl::Force(force))
    };
    let mut step = |share: f64| {
        let failed = History::step_all(&mut histories, &vec![drag(share); contacts])?;
        assert!(failed.is_empty(), "the step of a contact failed");
        Ok(())
    };
    for share in [0.4, -0.4] {
        step(share)?;
    }
    let mut share = 0.4;
    timed(repeats, || {
        share *= -0.9;
        step(share)
    })
}

/// Returns the time of each repetition in milliseconds, after a repetition that is not counted.
fn timed(repeats: usize, mut work: impl FnMut() -> Result<()>) -> Result<Vec<f64>> {
    work()?;
    let once = |_| {
        let start = Instant::now();
        work()?;
        Ok(1e3 * start.elapsed().as_secs_f64())
    };
    (0..repeats).map(once).collect()
}
