//! Measures memory and time as functions of the number of cells: bodies, normal and tangential solves, and histories of
//! a sphere.
//!
//! `cargo run --release -p stickslip-testkit --example memory_and_time [cells ...]` prints two tables on one thread. The
//! contact spans two thirds of the grid along each axis. Memory is the largest number of bytes that are allocated at
//! the same time. Times are minima of at least seven repeats, at the default tolerance.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

use std::error::Error;
use std::time::{Duration, Instant};

use kit::benchmark::{self, BenchmarkCase, FRICTION, LOADING};
use stickslip::{
    Friction, HalfSpace, History, LoadStep, NormalLoad, NormalProblem, NormalSolution, Result,
    TangentialLoad, TangentialModel, TangentialProblem,
};

/// Least number of repeats, of which the fastest counts.
const REPEATS: usize = 7;
/// Time up to which further repeats start.
const PATIENCE: Duration = Duration::from_secs(2);
/// Number of steps of the cycle of the tangential force.
const STEPS: u32 = 16;

fn main() -> std::result::Result<(), Box<dyn Error>> {
    let mut sizes = Vec::new();
    for argument in std::env::args().skip(1) {
        sizes.push(argument.parse()?);
    }
    if sizes.is_empty() {
        sizes = vec![128, 256, 512, 1024, 2048];
    }

    println!(
        "largest memory, MB; in the first column, memory that bodies keep after a normal and a scalar solve"
    );
    println!(
        "{:>5} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}",
        "N", "kept", "normal", "scalar", "vector", "history", "vector"
    );
    for &cells in &sizes {
        let case = benchmark::ball(cells)?;
        let [scalar, vector] = [TangentialModel::Scalar, TangentialModel::Vector];
        let shear = |model| allocated(|| case.press_and_shear(model));
        let history = |model| allocated(|| case.history(model));
        let ([kept, sheared], [_, pressed]) = (shear(Some(scalar))?, shear(None)?);
        let [_, in_plane] = shear(Some(vector))?;
        let ([_, along_axis], [_, both]) = (history(scalar)?, history(vector)?);
        print!("{cells:>5}");
        for bytes in [kept, pressed, sheared, in_plane, along_axis, both] {
            print!(" {:>9.2}", bytes as f64 / 1e6);
        }
        println!();
    }

    println!("\nshortest time, ms");
    println!(
        "{:>5} {:>9} {:>9} {:>9} {:>9} {:>9}",
        "N", "first", "normal", "scalar", "vector", "step"
    );
    for &cells in &sizes {
        print!("{cells:>5}");
        for time in benchmark::ball(cells)?.times()? {
            print!(" {time:>9.2}");
        }
        println!();
    }
    Ok(())
}

/// Returns the number of bytes that the result of `work` keeps, and the largest number of bytes that are allocated at
/// the same time.
fn allocated<T>(work: impl FnOnce() -> Result<T>) -> Result<[u64; 2]> {
    let mut outcome = None;
    let counted = allocation_counter::measure(|| outcome = Some(work()));
    outcome.transpose()?;
    let kept = u64::try_from(counted.bytes_current).unwrap_or(0);
    Ok([kept, counted.bytes_max])
}

/// Returns the shortest time of several repeats in milliseconds.
fn shortest(mut work: impl FnMut() -> Result<()>) -> Result<f64> {
    let (first, mut least, mut repeats) = (Instant::now(), f64::INFINITY, 0);
    while repeats < REPEATS || (first.elapsed() < PATIENCE && repeats < 100) {
        let start = Instant::now();
        work()?;
        least = least.min(1e3 * start.elapsed().as_secs_f64());
        repeats += 1;
    }
    Ok(least)
}

/// Work with the bodies of a case, which are new for each call and therefore have no operators.
trait FirstSolve {
    fn new_bodies(&self) -> Result<HalfSpace>;
    fn press_and_shear(&self, model: Option<TangentialModel>) -> Result<HalfSpace>;
    fn history(&self, model: TangentialModel) -> Result<History>;
    fn times(&self) -> Result<[f64; 5]>;
}

impl FirstSolve for BenchmarkCase {
    fn new_bodies(&self) -> Result<HalfSpace> {
        HalfSpace::new(self.bodies.grid(), *self.bodies.pair())
    }

    fn press_and_shear(&self, model: Option<TangentialModel>) -> Result<HalfSpace> {
        let bodies = self.new_bodies()?;
        let normal = press(self, &bodies)?;
        if let Some(model) = model {
            shear(self, &bodies, &normal, model)?;
        }
        Ok(bodies)
    }

    fn history(&self, model: TangentialModel) -> Result<History> {
        let friction = Friction::coulomb(FRICTION)?;
        let bodies = self.new_bodies()?;
        let builder = History::builder(&bodies, &self.gap, friction);
        let mut history = builder.model(model).build()?;
        history.step(&LoadStep::hold().normal(NormalLoad::Force(self.force)))?;
        history.step(&LoadStep::force([LOADING * FRICTION * self.force, 0.0]))?;
        Ok(history)
    }

    /// Returns the times of new bodies with the first normal solve, of a further normal solve, of a tangential solve in
    /// the scalar and in the vector model, and the mean time of the steps of a cycle.
    fn times(&self) -> Result<[f64; 5]> {
        let first = shortest(|| press(self, &self.new_bodies()?).map(drop))?;
        let bodies = self.new_bodies()?;
        let normal = press(self, &bodies)?;
        let pressed = shortest(|| press(self, &bodies).map(drop))?;
        let [scalar, vector] = [TangentialModel::Scalar, TangentialModel::Vector].map(|model| {
            shear(self, &bodies, &normal, model)?;
            shortest(|| shear(self, &bodies, &normal, model))
        });
        drop(bodies);

        let mut history = self.history(TangentialModel::Scalar)?;
        let amplitude = LOADING * FRICTION * self.force;
        let cycle = shortest(|| {
            for turn in 0..STEPS {
                let angle = f64::from(turn) * std::f64::consts::TAU / f64::from(STEPS);
                history.step(&LoadStep::force([amplitude * angle.sin(), 0.0]))?;
            }
            Ok(())
        })?;
        Ok([first, pressed, scalar?, vector?, cycle / f64::from(STEPS)])
    }
}

fn press(case: &BenchmarkCase, bodies: &HalfSpace) -> Result<NormalSolution> {
    let load = NormalLoad::Force(case.force);
    NormalProblem::builder(bodies, &case.gap, load)
        .build()?
        .solve()
}

fn shear(
    case: &BenchmarkCase,
    bodies: &HalfSpace,
    normal: &NormalSolution,
    model: TangentialModel,
) -> Result<()> {
    let load = TangentialLoad::force([LOADING * FRICTION * case.force, 0.0]);
    let friction = Friction::coulomb(FRICTION)?;
    let problem = TangentialProblem::builder(bodies, normal, friction, load).model(model);
    problem.build()?.solve().map(drop)
}
