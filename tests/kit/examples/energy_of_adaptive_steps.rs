//! Errors of the energy that adaptive steps dissipate, against their tolerance. The reference takes 1024 equal steps, and 256 for
//! the pressed ball.
//!
//! `cargo run --release -p stickslip-testkit --example energy_of_adaptive_steps`

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

use std::fmt::Display;
use std::ops::ControlFlow;

use stickslip::history::{AdaptiveSteps, Cycle};
use stickslip::{
    ElasticPair, Field, Friction, Grid, HalfSpace, History, Iteration, LoadStep, Material,
    NormalLoad, Result, TangentialModel, surface,
};

const REFERENCE: u32 = 1024;
const EQUAL: [u32; 3] = [16, 64, 256];
const TOLERANCES: [f64; 5] = [0.1, 0.03, 0.01, 0.003, 0.001];

/// Loads of a case: those that prepare the history, and the load that is divided into steps.
type Loads = (Vec<LoadStep>, [f64; 3], [f64; 3]);

/// Creates the step with these normal and tangential values.
type Step = fn([f64; 3]) -> LoadStep;

fn by_force([normal, x, y]: [f64; 3]) -> LoadStep {
    LoadStep::force([x, y]).normal(NormalLoad::Force(normal))
}

fn by_shift([normal, x, y]: [f64; 3]) -> LoadStep {
    LoadStep::shift([x, y]).normal(NormalLoad::Force(normal))
}

fn build(modulus: f64, friction: f64) -> Result<History> {
    let grid = Grid::square(64, 0.45e-3)?;
    let steel = Material::new(210e9, 0.3)?;
    let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(modulus, 0.3)?, steel)?)?;
    let ball: Field = surface::sphere(grid, 3.5e-3)?;
    let builder = History::builder(&bodies, ball, Friction::coulomb(friction)?);
    builder.model(TangentialModel::Vector).build()
}

fn started(modulus: f64, friction: f64, loads: &Loads, step: Step) -> Result<History> {
    let mut history = build(modulus, friction)?;
    for load in &loads.0 {
        history.step(load)?;
    }
    history.step(&step(loads.1))?;
    Ok(history)
}

/// Takes a load in equal steps.
fn equal(steps: u32, loads: &Loads, step: Step) -> Result<Cycle> {
    let mut history = started(210e9, 0.5, loads, step)?;
    let mut cycle = Cycle::new(&history);
    let [from, to] = [loads.1, loads.2];
    for k in 1..=steps {
        let part = f64::from(k) / f64::from(steps);
        let values = std::array::from_fn(|i| from[i] + part * (to[i] - from[i]));
        history.step(&step(values))?;
        cycle.add(&history)?;
    }
    Ok(cycle)
}

/// Prints the errors of both energies relative to the reference.
fn print(name: &str, tolerance: impl Display, steps: usize, cycle: &Cycle, exact: f64) {
    let energy = cycle.energy();
    let error = |found: f64| 100.0 * (found / exact - 1.0);
    let errors = [energy.dissipated_energy, energy.dissipated_energy_midpoint].map(error);
    println!(
        "| {name} | {tolerance} | {steps} | {:.2} | {:.2} |",
        errors[0], errors[1]
    );
}

fn main() -> Result<()> {
    let press = |force| vec![LoadStep::hold().normal(NormalLoad::Force(force))];
    let cases: [(&str, Step, Loads); 4] = [
        (
            "growing, shift",
            by_shift,
            (press(100.0), [100.0, 0.0, 0.0], [200.0, 2e-6, 0.0]),
        ),
        (
            "growing, turning force",
            by_force,
            (press(100.0), [100.0, 30.0, 0.0], [200.0, 0.0, 50.0]),
        ),
        (
            "unloaded during slip",
            by_force,
            (press(200.0), [200.0, 40.0, 0.0], [90.0, 40.0, 0.0]),
        ),
        (
            "constant normal load",
            by_force,
            (press(200.0), [200.0, 0.0, 0.0], [200.0, 80.0, 0.0]),
        ),
    ];
    println!("| load | tolerance | steps | final tractions, % | mean tractions, % |");
    println!("|---|---|---|---|---|");
    for (name, step, loads) in &cases {
        let exact = equal(REFERENCE, loads, *step)?;
        let exact = exact.energy().dissipated_energy_midpoint;
        for steps in EQUAL {
            print(
                name,
                "",
                steps as usize,
                &equal(steps, loads, *step)?,
                exact,
            );
        }
        for tolerance in TOLERANCES {
            let mut history = started(210e9, 0.5, loads, *step)?;
            let mut cycle = Cycle::new(&history);
            let mut adaptive = AdaptiveSteps::new(&history, tolerance)?;
            let load = step(loads.2);
            let steps = adaptive.step_observed(&mut history, &load, |now| cycle.add(now))?;
            print(name, tolerance, steps, &cycle, exact);
        }
    }
    // A ball of a different material is pressed from zero load.
    let load = LoadStep::hold().normal(NormalLoad::Force(200.0));
    let pressed = |tolerance: f64| -> Result<(usize, Cycle)> {
        let mut history = build(70e9, 0.1)?;
        let mut cycle = Cycle::new(&history);
        let unobserved = |_: &Iteration| ControlFlow::Continue(());
        let steps =
            history.press_steps_observed(&load, tolerance, unobserved, |now| cycle.add(now))?;
        Ok((steps, cycle))
    };
    let mut history = build(70e9, 0.1)?;
    let mut cycle = Cycle::new(&history);
    for k in 1..=256 {
        let radius = f64::from(k) / 256.0;
        history.step(&LoadStep::hold().normal(NormalLoad::Force(200.0 * radius.powi(3))))?;
        cycle.add(&history)?;
    }
    let exact = cycle.energy().dissipated_energy_midpoint;
    for tolerance in TOLERANCES {
        let (steps, cycle) = pressed(tolerance)?;
        print("dissimilar, pressed", tolerance, steps, &cycle, exact);
    }
    Ok(())
}
