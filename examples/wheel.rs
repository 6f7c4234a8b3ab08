//! A wheel on a rail in the time loop of a vehicle simulation: load, creepages and spin change in every step.
//!
//! `cargo run --release -p stickslip-examples --example wheel [STEPS]` runs 20 000 steps of 1 ms on 24 x 24 cells. It prints
//! the time of a step and the error of the forces, next to FASTSIM with the same number of cells.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::time::Instant;

use stickslip::analytical::{HertzEllipse, KalkerCoefficients};
use stickslip::rolling::{RollingControl, RollingProblem, RollingSolver, SpinControl};
use stickslip::{
    ElasticPair, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem, surface,
};

/// Radii of curvature of wheel and rail, mean wheel load and friction, in m, N and Pa.
const RADII: [f64; 2] = [0.46, 0.30];
const LOAD: f64 = 80e3;
const FRICTION: f64 = 0.35;
const CELLS: usize = 24;
/// Number of cells along each side of the grid of the reference.
const FINE: usize = 96;
/// Number of steps compared with the reference.
const SAMPLES: usize = 25;
const TIME_STEP: f64 = 1e-3;

/// State of a wheel in a time step.
#[derive(Debug, Clone, Copy)]
struct Wheel {
    load: f64,
    creepage: [f64; 2],
    spin: f64,
}

impl Wheel {
    /// Returns the state at a time. Traction and braking alternate at 0.4 Hz, hunting has 1.7 Hz, bouncing has 3 Hz and the rail
    /// excitation has 23 Hz.
    fn at(time: f64) -> Self {
        let wave = |frequency: f64, phase: f64| (TAU * frequency * time + phase).sin();
        Self {
            load: LOAD * (1.0 + 0.25 * wave(3.0, 0.0) + 0.05 * wave(23.0, 1.0)),
            creepage: [
                1.5e-3 * wave(0.4, 0.3) + 1e-4 * wave(23.0, 0.0),
                2e-3 * wave(1.7, 0.0),
            ],
            spin: 0.15 + 0.5 * wave(1.7, 0.5),
        }
    }
}

/// Sorted times, for the minimum, the median and the mean.
struct Times(Vec<f64>);

impl Times {
    fn show(mut self, name: &str) {
        self.0.sort_by(f64::total_cmp);
        let mean = self.0.iter().sum::<f64>() / self.0.len() as f64;
        let (least, median) = (self.0[0], self.0[self.0.len() / 2]);
        println!("{name:<34} {least:>8.4} {median:>8.4} {mean:>8.4}");
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let steps = std::env::args().nth(1).map_or(Ok(20_000), |n| n.parse())?;
    let wheels: Vec<_> = (0..steps)
        .map(|step: u32| Wheel::at(TIME_STEP * f64::from(step)))
        .collect();
    let every = (wheels.len() / SAMPLES).max(1);
    let sampled: Vec<_> = wheels.iter().step_by(every).copied().collect();
    let mut reference = solver(FINE, 1e-6)?;
    let exact = forces(&mut reference, &sampled)?.forces;

    println!("{} steps, {CELLS} x {CELLS} cells", wheels.len());
    println!("time per step (ms)                  minimum   median     mean");
    for tolerance in [1e-6, 1e-4, 1e-3] {
        let mut solver = solver(CELLS, tolerance)?;
        let run = forces(&mut solver, &wheels)?;
        run.times
            .show(&format!("solver, tolerance {tolerance:.0e}"));
        run.load_times.show("    of which pressure solve");
        let found = run.forces.iter().step_by(every);
        show_error(found, &exact, &sampled);
        println!(
            "    products per step: {:.1}",
            run.products as f64 / f64::from(steps)
        );
    }
    let fastsim = Fastsim::new(CELLS)?;
    let mut times = Vec::new();
    let mut found = Vec::new();
    for wheel in &wheels {
        let start = Instant::now();
        found.push(fastsim.force(wheel));
        times.push(1e3 * start.elapsed().as_secs_f64());
    }
    Times(times).show("FASTSIM");
    show_error(found.iter().step_by(every), &exact, &sampled);
    Ok(())
}

/// Prints the error of the forces divided by the friction limit.
fn show_error<'a>(found: impl Iterator<Item = &'a [f64; 2]>, exact: &[[f64; 2]], wheels: &[Wheel]) {
    let errors = found.zip(exact).zip(wheels).map(|((found, exact), wheel)| {
        let missed = (found[0] - exact[0]).hypot(found[1] - exact[1]);
        100.0 * missed / (FRICTION * wheel.load)
    });
    let errors: Vec<f64> = errors.collect();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let largest = errors.iter().copied().fold(0.0, f64::max);
    println!(
        "    error of the force, % of the friction limit: mean {mean:.3}, largest {largest:.3}"
    );
}

fn steel() -> stickslip::Result<ElasticPair> {
    let steel = Material::new(210e9, 0.28)?;
    ElasticPair::new(steel, steel)
}

/// Creates a rolling solver on `cells` x `cells` cells for varying loads.
fn solver(cells: usize, tolerance: f64) -> stickslip::Result<RollingSolver> {
    let pair = steel()?;
    let largest = HertzEllipse::new(&pair, RADII[0], RADII[1], 1.35 * LOAD)?;
    let [a, b] = largest.semi_axes();
    // The grid must contain the largest contact and the gap ahead of it.
    let sides = [a, b].map(|radius| 2.3 * radius / cells as f64);
    let grid = Grid::new(cells, cells, sides[0], sides[1])?;
    let bodies = HalfSpace::new(grid, pair)?;
    let gap = surface::ellipsoid(grid, RADII[0], RADII[1])?;
    let press = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(LOAD))
        .tolerance(tolerance)
        .build()?;
    let normal = press.solve()?;
    let mut solver = RollingProblem::builder(&bodies, &normal, Friction::coulomb(FRICTION)?)
        .tolerance(tolerance)
        .build()?
        .into_solver()?;
    solver.set_normal_solver(press.into_solver()?)?;
    Ok(solver)
}

/// Forces of all steps, and the time of each step in ms.
struct Run {
    forces: Vec<[f64; 2]>,
    times: Times,
    load_times: Times,
    products: u64,
}

fn forces(solver: &mut RollingSolver, wheels: &[Wheel]) -> stickslip::Result<Run> {
    let mut rolling = solver.new_solution();
    let mut run = Run {
        forces: Vec::new(),
        times: Times(Vec::new()),
        load_times: Times(Vec::new()),
        products: 0,
    };
    for wheel in wheels {
        let start = Instant::now();
        solver.set_normal_load(NormalLoad::Force(wheel.load))?;
        let pressed = start.elapsed();
        solver.set_load(
            wheel.creepage.map(RollingControl::Creepage),
            SpinControl::Spin(wheel.spin),
        )?;
        solver.solve_into(&mut rolling)?;
        let force = rolling.force();
        run.times.0.push(1e3 * start.elapsed().as_secs_f64());
        run.load_times.0.push(1e3 * pressed.as_secs_f64());
        run.forces.push(force);
        let report = rolling.report();
        run.products +=
            (report.single_precision_products + report.double_precision_products) as u64;
    }
    Ok(run)
}

/// Kalker's simplified theory, in which each cell is a spring. Strips of cells are swept from the leading edge. J. J. Kalker,
/// Vehicle System Dynamics 11 (1982) 1, <https://doi.org/10.1080/00423118208968684>.
struct Fastsim {
    cells: usize,
    shear_modulus: f64,
    coefficients: KalkerCoefficients,
    /// Semi-axes under the mean load. They are proportional to the cube root of the load.
    axes: [f64; 2],
}

impl Fastsim {
    fn new(cells: usize) -> stickslip::Result<Self> {
        let pair = steel()?;
        let axes = HertzEllipse::new(&pair, RADII[0], RADII[1], LOAD)?.semi_axes();
        Ok(Self {
            cells,
            shear_modulus: 210e9 / (2.0 * 1.28),
            coefficients: KalkerCoefficients::new(axes[0] / axes[1], 0.28)?,
            axes,
        })
    }

    fn force(&self, wheel: &Wheel) -> [f64; 2] {
        let (g, kalker) = (self.shear_modulus, &self.coefficients);
        let [a, b] = self.axes.map(|axis| axis * (wheel.load / LOAD).cbrt());
        // Flexibilities of the springs for both creepages and for spin.
        let along = 8.0 * a / (3.0 * g * kalker.c11());
        let across = 8.0 * a / (3.0 * g * kalker.c22());
        let turning = PI * a * a / (4.0 * g * (a * b).sqrt() * kalker.c23());
        let strips = self.cells;
        let width = 2.0 * b / strips as f64;
        // The friction limit of the simplified theory is a paraboloid.
        let largest = FRICTION * 2.0 * wheel.load / (PI * a * b);
        let mut force = [0.0; 2];
        for strip in 0..strips {
            let y = -b + (strip as f64 + 0.5) * width;
            let half = a * (1.0 - (y / b).powi(2)).sqrt();
            let way = 2.0 * half / strips as f64;
            let mut q = [0.0; 2];
            for cell in 0..strips {
                let x = half - (cell as f64 + 0.5) * way;
                q[0] += way * (wheel.creepage[0] / along - wheel.spin * y / turning);
                q[1] += way * (wheel.creepage[1] / across + wheel.spin * x / turning);
                let limit = largest * (1.0 - (x / a).powi(2) - (y / b).powi(2));
                let size = q[0].hypot(q[1]);
                if size > limit {
                    q = q.map(|q| q * limit / size);
                }
                for (force, q) in force.iter_mut().zip(q) {
                    *force += q * way * width;
                }
            }
        }
        force
    }
}
