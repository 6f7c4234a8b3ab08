//! A ball worn by small oscillations at a constant approach, with Archard's law and jumps over many cycles, towards Popov's
//! limiting shape.
//!
//! `cargo run --release -p stickslip-examples --example wear_loop [cells] [Poisson's ratio]` (default 128, at least 48; and 0)
//! writes `target/gallery/wear_loop.csv`, `wear_loop_profiles.csv` and `wear_loop.svg`.
//!
//! The limiting shape assumes equal wear in all directions, which requires equal slip and therefore a Poisson's ratio of zero.
//! At a Poisson's ratio of 0.29 the slip is larger across the motion than along the motion. Wear then extends into the stick
//! disc, and the remaining load is about 2 % below the closed form.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::f64::consts::PI;
use std::path::Path;

use plotters::prelude::{RGBColor, SeriesLabelPosition};
use stickslip::analytical::{CattaneoMindlin, HertzSphere, PopovLimitingShape};
use stickslip::history::wear::{self, CycleJump};
use stickslip::history::{Cycle, FrettingLoop, LoadPath};
use stickslip::{
    ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep, Material, NormalLoad, surface,
};

// SI units: metres, newtons, pascals.
const BALL_RADIUS: f64 = 3.5e-3;
/// Normal force that presses the unworn ball to the prescribed approach.
const NORMAL_FORCE: f64 = 100.0;
const FRICTION: f64 = 0.5;
/// Radius of the stick disc divided by the contact radius.
const STICK_RADIUS: f64 = 0.6;
/// Worn volume of both bodies per normal force and slip distance (1/Pa).
const WEAR_COEFFICIENT: f64 = 1e-13;
const CYCLES: f64 = 2e4;
/// Largest fraction of the approach that is worn in one jump.
const APPROACH_FRACTION: f64 = 0.01;
/// Numbers of cycles after which profiles are drawn. If such a cycle is not simulated, the profile of the next simulated cycle
/// is drawn.
const SHOWN: [f64; 4] = [0.0, 1000.0, 3000.0, CYCLES];
/// Largest pressure in the drawing, divided by the maximum pressure of the unworn ball.
const HIGHEST: f64 = 5.0;
/// Tolerance, far below the discretisation error.
const TOLERANCE: f64 = 1e-6;

fn main() -> Result<(), Box<dyn Error>> {
    let argument = |number| std::env::args().nth(number);
    let cells = argument(1).map_or(Ok(128), |cells| cells.parse())?;
    let poisson_ratio = argument(2).map_or(Ok(0.0), |ratio| ratio.parse())?;
    let body = Material::new(213e9, poisson_ratio)?;
    let pair = ElasticPair::new(body, body)?;
    let hertz = HertzSphere::new(&pair, BALL_RADIUS, NORMAL_FORCE)?;
    let (a, approach) = (hertz.contact_radius(), hertz.approach());
    let sliding_shift = CattaneoMindlin::new(hertz, FRICTION, 0.0)?.sliding_shift();
    let amplitude = (1.0 - STICK_RADIUS * STICK_RADIUS) * sliding_shift;
    let limit = PopovLimitingShape::new(&pair, BALL_RADIUS, approach, STICK_RADIUS * a)?;

    let grid = Grid::square(cells, 2.5 * limit.worn_radius())?;
    let bodies = HalfSpace::new(grid, pair)?;
    let ball = surface::sphere(grid, BALL_RADIUS)?;
    let mut gap = ball.clone();
    let mut history = History::builder(&bodies, &gap, Friction::coulomb(FRICTION)?)
        .tolerance(TOLERANCE)
        .build()?;
    let load = |shift| LoadStep::shift(shift).normal(NormalLoad::Approach(approach));
    let path = LoadPath::table(vec![[amplitude, 0.0], [-amplitude, 0.0]])?;
    let fretting = FrettingLoop::new(path, load);
    // Only a steady cycle can represent the skipped cycles.
    fretting.clone().until_steady(1e-3).run(&mut history, 10)?;
    let mut cycle = Cycle::new(&history);

    let mut stages = Vec::new();
    let (mut cycles, mut energy) = (0.0, 0.0);
    println!(
        "Difference of the gap from the limiting shape in % of the approach: largest, largest off the edge (farther"
    );
    println!("than a cell from the edge of the stick disc), and mean over the worn region.\n");
    println!(
        "  cycles    jump | load (N)  largest p (GPa) | worn volume / limit | largest off edge   mean"
    );
    loop {
        // Simulate a cycle with the pressure of the worn gap.
        fretting.cycle(&mut history, &mut cycle)?;
        let mut depth = Field::zeros(grid);
        let (pressure, slip) = (cycle.slip_pressure(), cycle.slip_distance());
        wear::archard(WEAR_COEFFICIENT, pressure, slip, &mut depth)?;
        let jump = CycleJump::new(&bodies, &cycle, &depth)?
            .largest_depth(APPROACH_FRACTION * approach)
            .cycles_left(CYCLES - cycles)
            .cycles()?;
        let shown = stages
            .iter()
            .filter(|stage: &&Stage| stage.is_shown)
            .count();
        let is_shown = cycles >= SHOWN[shown];
        let volume = gap.integral() - ball.integral();
        let stage = Stage::of(&history, &limit, [cycles, jump, energy, volume], is_shown);
        if is_shown {
            stage.print(&limit);
        }
        stages.push(stage);
        if jump <= 0.0 {
            break;
        }
        gap.add_scaled(jump, &depth)?;
        history.set_gap(&gap)?;
        cycles += jump;
        energy += jump * cycle.energy().dissipated_energy;
    }
    print_end(&stages, &history, &limit);
    write(&stages, &limit)
}

/// Simulated cycle.
struct Stage {
    /// Number of cycles before the simulated cycle.
    cycles: f64,
    /// Number of cycles that the wear of this cycle represents.
    jump: f64,
    load: f64,
    max_pressure: f64,
    /// Energy dissipated before the cycle.
    energy: f64,
    /// Volume worn before the cycle.
    volume: f64,
    /// Largest difference between the gap and the limiting shape, divided by the approach.
    largest: f64,
    /// Largest difference more than a cell away from the edge of the stick disc, where the shape is vertical.
    largest_off_edge: f64,
    /// Mean of the difference over the worn region.
    mean: f64,
    /// Whether the gap and the pressure along the row of cells nearest to the x axis are drawn.
    is_shown: bool,
    profile: Vec<[f64; 3]>,
}

impl Stage {
    fn of(
        history: &History,
        limit: &PopovLimitingShape,
        [cycles, jump, energy, volume]: [f64; 4],
        is_shown: bool,
    ) -> Self {
        let (grid, gap) = (history.grid(), history.unloaded_gap());
        let (b, c) = (limit.worn_radius(), limit.stick_radius());
        let mut samples = gap.as_slice().iter();
        let mut largest_off_edge = 0.0_f64;
        let differences = Field::from_fn(grid, |x, y| {
            let r = x.hypot(y);
            let sample = samples.next().copied().unwrap_or(0.0);
            let difference = (sample - limit.profile(r)).abs() / limit.approach();
            if (r - c).abs() > grid.dx() {
                largest_off_edge = largest_off_edge.max(difference);
            }
            difference
        });
        let worn_area = PI * (b - c) * (b + c);
        let row = grid.ny() / 2;
        let sample = |ix| {
            let pressure = history.pressure().get(ix, row)?;
            Some([grid.x(ix), gap.get(ix, row)?, pressure])
        };
        Self {
            cycles,
            jump,
            load: history.normal().force(),
            max_pressure: history.pressure().max(),
            energy,
            volume,
            largest: differences.max(),
            largest_off_edge,
            mean: differences.integral() / worn_area,
            is_shown,
            profile: (0..grid.nx()).filter_map(sample).collect(),
        }
    }

    fn print(&self, limit: &PopovLimitingShape) {
        println!(
            "{:>8.0} {:>7.1} | {:>8.3}  {:>15.3} | {:>19.4} | {:>7.2} {:>8.2} {:>6.2}",
            self.cycles,
            self.jump,
            self.load,
            self.max_pressure / 1e9,
            self.volume / limit.worn_volume(),
            1e2 * self.largest,
            1e2 * self.largest_off_edge,
            1e2 * self.mean,
        );
    }

    fn row(&self) -> [f64; 9] {
        [
            self.cycles,
            self.jump,
            self.load,
            self.max_pressure,
            self.energy,
            self.volume,
            self.largest,
            self.largest_off_edge,
            self.mean,
        ]
    }
}

fn print_end(stages: &[Stage], history: &History, limit: &PopovLimitingShape) {
    let last = &stages[stages.len() - 1];
    println!(
        "\n{} of {:.0} cycles simulated, {} steps",
        stages.len(),
        last.cycles,
        history.steps()
    );
    println!(
        "remaining load: {:.3} N; limiting shape: {:.3} N",
        last.load,
        limit.load()
    );
    let by_energy = WEAR_COEFFICIENT / FRICTION * last.energy;
    println!(
        "worn volume: {:.1} µm³; k / mu times the energy: {:.1} µm³; relative difference {:.1e}",
        last.volume * 1e18,
        by_energy * 1e18,
        last.volume / by_energy - 1.0
    );
}

fn write(stages: &[Stage], limit: &PopovLimitingShape) -> Result<(), Box<dyn Error>> {
    let header = [
        "cycles",
        "jump",
        "load_N",
        "max_pressure_Pa",
        "energy_J",
        "worn_volume_m3",
        "largest_difference_over_approach",
        "largest_difference_off_edge_over_approach",
        "mean_difference_over_approach",
    ];
    let csv = support::gallery("wear_loop.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    table.write_record(header)?;
    for row in stages.iter().map(Stage::row) {
        table.serialize(row)?;
    }
    table.flush()?;
    let shown: Vec<&Stage> = stages.iter().filter(|stage| stage.is_shown).collect();
    let rows = shown.iter().flat_map(|stage| {
        let samples = stage.profile.iter();
        samples.map(|&[x, gap, pressure]| [stage.cycles, x, gap, limit.profile(x), pressure])
    });
    let header = ["cycles", "x_m", "gap_m", "limiting_gap_m", "pressure_Pa"];
    let profiles = support::gallery("wear_loop_profiles.csv")?;
    let mut table = csv::Writer::from_path(&profiles)?;
    table.write_record(header)?;
    for row in rows {
        table.serialize(row)?;
    }
    table.flush()?;
    let svg = support::gallery("wear_loop.svg")?;
    draw(&svg, &shown, limit)?;
    println!(
        "\ntables: {}, {}\nfigure: {}",
        csv.display(),
        profiles.display(),
        svg.display()
    );
    Ok(())
}

fn draw(path: &Path, shown: &[&Stage], limit: &PopovLimitingShape) -> Result<(), Box<dyn Error>> {
    let title = "Fretting wear of a ball at a constant approach d";
    let figure = support::figure(path, (2 * support::PANEL, 1400), title)?;
    let (left, right) = figure.split_horizontally(support::PANEL);
    let colours = [
        support::BLUE,
        support::GREEN,
        support::ORANGE,
        support::PURPLE,
    ];
    let a = (limit.radius() * limit.approach()).sqrt();
    let max_pressure = shown[0].max_pressure;
    let limit_at = |of: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        (0..=700)
            .map(|i| 1.4 * f64::from(i) / 700.0)
            .map(|x| (x, of(x * a)))
            .collect()
    };

    let mut chart = support::axes(&left, (0.0..1.4, "x / a"), (0.0..1.2, "gap / d"))?;
    let gap = limit_at(&|r| limit.profile(r) / limit.approach());
    support::law(&mut chart, "limiting shape", true, gap)?;
    draw_stages(&mut chart, shown, colours, a, |&[_, gap, _]| {
        gap / limit.approach()
    })?;
    support::legend(&mut chart, SeriesLabelPosition::UpperLeft)?;

    let mut chart = support::axes(
        &right,
        (0.0..1.4, "x / a"),
        (0.0..HIGHEST, "p / p₀ of the unworn ball"),
    )?;
    let pressure = limit_at(&|r| (limit.pressure(r) / max_pressure).min(HIGHEST));
    support::law(&mut chart, "limiting shape", true, pressure)?;
    draw_stages(&mut chart, shown, colours, a, |&[_, _, pressure]| {
        pressure / max_pressure
    })?;
    support::legend(&mut chart, SeriesLabelPosition::UpperRight)?;
    figure.present()?;
    Ok(())
}

fn draw_stages(
    chart: &mut support::Chart<'_>,
    shown: &[&Stage],
    colours: [RGBColor; 4],
    a: f64,
    of: impl Fn(&[f64; 3]) -> f64,
) -> Result<(), Box<dyn Error>> {
    for (stage, colour) in shown.iter().zip(colours) {
        let name = format!("{:.0} cycles", stage.cycles);
        let samples = stage.profile.iter();
        let points = samples.map(|sample| (sample[0] / a, of(sample)));
        let in_sight = points.filter(|(x, y)| (0.0..1.4).contains(x) && (0.0..HIGHEST).contains(y));
        support::dots(chart, &name, (colour, true), in_sight)?;
    }
    Ok(())
}
