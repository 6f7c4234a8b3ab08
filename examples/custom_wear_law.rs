//! A simulation with a user-defined wear law. It steps the contact through load cycles, updates the gap by the wear after every
//! step, saves the state halfway, and continues from the saved state with bitwise identical results.
//!
//! `cargo run --release -p stickslip-examples --example custom_wear_law [cells]` (default 64, at least 32)
//! writes `target/gallery/custom_wear_law.csv` and `.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::ops::ControlFlow;
use std::path::Path;

use stickslip::history::{FrettingLoop, LoadPath};
use stickslip::{
    ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep, Material, NormalLoad, Result,
    surface,
};

// SI units: metres, newtons, pascals, joules.
const BALL_RADIUS: f64 = 3.5e-3;
const NORMAL_FORCE: f64 = 100.0;
const FRICTION: f64 = 0.5;
/// Amplitude of the shift; gross sliding starts at 2.99 µm.
const SHIFT_AMPLITUDE: f64 = 2.5e-6;
const STEPS: usize = 40;
const CYCLES: usize = 20;
/// Worn volume per energy after running-in (1/Pa).
const WEAR_COEFFICIENT: f64 = 2e-11;
/// Additional depth worn during running-in.
const RUNNING_IN_DEPTH: f64 = 0.3e-6;
/// Energy per square metre that running-in requires.
const RUNNING_IN_ENERGY: f64 = 5e3;

/// Returns the worn depth as a function of the energy per area that a cell has dissipated. The surface wears faster
/// during running-in.
fn worn_depth(energy: f64) -> f64 {
    let run_in = 1.0 - (-energy / RUNNING_IN_ENERGY).exp();
    WEAR_COEFFICIENT * energy + RUNNING_IN_DEPTH * run_in
}

/// Results of a cycle.
struct Leaving {
    energy: f64,
    depth: f64,
    max_pressure: f64,
    worn_volume: f64,
}

/// Runs the time loop. After every step, the gap is set to the gap of the ball plus the worn depth.
fn run(history: &mut History, ball: &Field, cycles: usize) -> Result<Vec<Leaving>> {
    let path = LoadPath::sine([SHIFT_AMPLITUDE, 0.0], STEPS)?;
    let load = |shift| LoadStep::shift(shift).normal(NormalLoad::Force(NORMAL_FORCE));
    let cell_area = ball.grid().cell_area();
    let mut gap = ball.clone();
    let mut done = Vec::new();
    FrettingLoop::new(path, load).run_observed(history, cycles, |history, cycle| {
        let energy = history.accumulated_dissipation();
        let unworn = ball.as_slice().iter().zip(energy.as_slice());
        for (gap, (ball, energy)) in gap.as_mut_slice().iter_mut().zip(unworn) {
            *gap = ball + worn_depth(energy / cell_area);
        }
        let depth = worn_depth(energy.max() / cell_area);
        history.set_gap(&gap)?;
        if cycle.steps() == STEPS {
            done.push(Leaving {
                energy: cycle.energy().dissipated_energy,
                depth,
                max_pressure: history.pressure().max(),
                worn_volume: gap.integral() - ball.integral(),
            });
        }
        Ok(ControlFlow::Continue(()))
    })?;
    Ok(done)
}

fn main() -> std::result::Result<(), Box<dyn Error>> {
    let cells = std::env::args()
        .nth(1)
        .map_or(Ok(64), |cells| cells.parse())?;
    let steel = Material::new(213e9, 0.29)?;
    let grid = Grid::square(cells, 0.4e-3)?;
    let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
    let ball = surface::sphere(grid, BALL_RADIUS)?;

    let build = || History::builder(&bodies, &ball, Friction::coulomb(FRICTION)?).build();
    let mut straight = build()?;
    let cycles = run(&mut straight, &ball, CYCLES)?;

    let mut first_half = build()?;
    run(&mut first_half, &ball, CYCLES / 2)?;
    let saved = first_half.to_bytes();
    let mut restored = History::from_bytes(&bodies, &saved)?;
    run(&mut restored, &ball, CYCLES - CYCLES / 2)?;

    println!("cycle | energy (µJ)  worn depth (µm)  largest pressure (GPa)  worn volume (µm³)");
    for (number, cycle) in (1..).zip(&cycles) {
        let [_, energy, depth, pressure, volume] = cycle.row(number);
        println!("{number:>5} | {energy:>11.4}  {depth:>15.4}  {pressure:>22.4}  {volume:>17.2}");
    }
    println!("\nsaved after half of the cycles: {} bytes", saved.len());
    for (name, field) in [
        ("gap", History::unloaded_gap as fn(&History) -> &Field),
        ("pressure", History::pressure),
        ("traction", |history| history.traction()[0]),
        ("slip path", History::accumulated_slip),
        ("dissipated energy", History::accumulated_dissipation),
    ] {
        let bits = |history| {
            field(history)
                .as_slice()
                .iter()
                .map(|value| value.to_bits())
        };
        let differing = bits(&straight).zip(bits(&restored)).filter(|(a, b)| a != b);
        println!(
            "{name}: {} cells differ after the restart",
            differing.count()
        );
    }

    let header = [
        "cycle",
        "energy_uJ",
        "deepest_wear_um",
        "max_pressure_GPa",
        "worn_volume_um3",
    ];
    let rows: Vec<_> = (1..).zip(&cycles).map(|(n, cycle)| cycle.row(n)).collect();
    let svg = support::gallery("custom_wear_law.svg")?;
    draw(&svg, &rows)?;
    let csv = support::gallery("custom_wear_law.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    table.write_record(header)?;
    for row in rows {
        table.serialize(row)?;
    }
    table.flush()?;
    println!("\ntable: {}\nfigure: {}", csv.display(), svg.display());
    Ok(())
}

impl Leaving {
    fn row(&self, number: u32) -> [f64; 5] {
        [
            f64::from(number),
            self.energy * 1e6,
            self.depth * 1e6,
            self.max_pressure * 1e-9,
            self.worn_volume * 1e18,
        ]
    }
}

fn draw(path: &Path, rows: &[[f64; 5]]) -> std::result::Result<(), Box<dyn Error>> {
    let title = "Wear of a ball during and after running-in";
    let figure = support::figure(path, (2 * support::PANEL, 1300), title)?;
    let (left, right) = figure.split_horizontally(support::PANEL);
    let cycles = 0.0..CYCLES as f64 + 1.0;
    let points = |column: usize| rows.iter().map(move |row| (row[0], row[column]));
    let panels = [
        (left, 2, "largest worn depth (µm)", support::BLUE),
        (right, 3, "largest pressure (GPa)", support::ORANGE),
    ];
    for (area, column, name, colour) in panels {
        let top = 1.2 * points(column).map(|(_, value)| value).fold(0.0, f64::max);
        let mut chart = support::axes(
            &area,
            (cycles.clone(), "number of cycles"),
            (0.0..top, name),
        )?;
        support::dots(&mut chart, name, (colour, true), points(column))?;
    }
    figure.present()?;
    Ok(())
}
