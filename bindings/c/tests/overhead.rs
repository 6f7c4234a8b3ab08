//! Times of warm steps in Rust, for comparison with the times of `overhead.c` for the same contact and loads.

#![allow(clippy::print_stdout, reason = "it is what it is for")]

use std::time::Instant;

use stickslip_rs::{
    ElasticPair, Friction, Grid, HalfSpace, History, LoadStep, Material, NormalControl, Result,
    surface,
};

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1).map_while(|one| one.parse().ok());
    let (n, steps) = (
        arguments.next().unwrap_or(64),
        arguments.next().unwrap_or(2000),
    );
    let grid = Grid::square(n, 0.30e-3)?;
    let steel = Material::new(213e9, 0.29)?;
    let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
    let ball = surface::sphere(grid, 3.5e-3)?;
    let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
    history.step(&LoadStep::hold().normal(NormalControl::Force(100.0)))?;
    let mut times = Vec::with_capacity(steps);
    for step in 0..steps {
        let force = 10.0 * (0.1 * step as f64).sin();
        let load = LoadStep::force([force, 0.0]).normal(NormalControl::Force(100.0));
        let start = Instant::now();
        history.step(&load)?;
        times.push(start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    let part = |part: usize| 1e6 * times[steps * part / 100];
    println!(
        "Rust {n}^2: median {:.2} us, tenth {:.2} us, shift {:e}",
        part(50),
        part(10),
        history.shift()[0]
    );
    Ok(())
}
