//! The paper's ball (its Table 2) under a constant normal force and a cyclic tangential force in partial slip. The
//! example compares the loop of force and shift, the tractions around the loop, and the energy of a cycle with the
//! closed forms.
//!
//! `cargo run --release -p stickslip-examples --example fretting_loop [cells]` (default 256, at least 32)
//! writes `target/gallery/fretting_loop.csv` and `.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::path::Path;

use plotters::prelude::{RGBColor, SeriesLabelPosition};
use stickslip::analytical::{HertzSphere, MindlinDeresiewicz};
use stickslip::history::{Cycle, LoadPath, StepResult};
use stickslip::{
    ElasticPair, Friction, Grid, HalfSpace, History, LoadStep, Material, NormalLoad, surface,
};
use support::Area;

// SI units: metres, newtons, pascals.
const BALL_RADIUS: f64 = 3.5e-3;
const NORMAL_FORCE: f64 = 100.0;
/// Amplitude of the force: twice the paper's tangential force, for a wider loop. Gross sliding starts at 50 N.
const AMPLITUDE: f64 = 40.0;
const FRICTION: f64 = 0.5;
const STEPS: usize = 40;
/// Number of cycles. The first cycle contains the first loading. The second cycle is a full loop.
const CYCLES: usize = 2;

/// Half-width of the view, in contact radii.
const VIEW: f64 = 1.25;
const MICRO: f64 = 1e6;

fn main() -> Result<(), Box<dyn Error>> {
    let cells = std::env::args()
        .nth(1)
        .map_or(Ok(256), |cells| cells.parse())?;
    let steel = Material::new(213e9, 0.29)?;
    let pair = ElasticPair::new(steel, steel)?;
    let hertz = HertzSphere::new(&pair, BALL_RADIUS, NORMAL_FORCE)?;
    let grid = Grid::square(cells, 2.5 * hertz.contact_radius())?;
    let bodies = HalfSpace::new(grid, pair)?;
    let ball = surface::sphere(grid, BALL_RADIUS)?;
    let mut history = History::builder(&bodies, &ball, Friction::coulomb(FRICTION)?).build()?;
    history.step(&LoadStep::hold().normal(NormalLoad::Force(NORMAL_FORCE)))?;

    let path = LoadPath::sine([AMPLITUDE, 0.0], STEPS)?;
    let mut forces = Vec::new();
    let mut points = Vec::new();
    let mut profiles = Vec::new();
    let mut cycle = Cycle::new(&history);
    for force in path.cycles(CYCLES) {
        if cycle.steps() == STEPS {
            cycle.begin(&history)?;
        }
        history.step(&LoadStep::force(force))?;
        cycle.add(&history)?;
        forces.push(force[0]);
        let exact = MindlinDeresiewicz::new(hertz, FRICTION, &forces)?;
        points.push(Point::of(history.last_step()?, &exact));
        // Keep the turning points and both zero crossings of the second cycle.
        if forces.len() > STEPS && forces.len() % (STEPS / 4) == 0 {
            profiles.push(Profile::of(&history, exact));
        }
    }

    print_table(&points, &profiles, &cycle)?;
    let header = [
        "force_N",
        "shift_um",
        "closed_form_um",
        "stick_ratio",
        "dissipated_uJ",
        "dissipated_mid_step_uJ",
        "work_uJ",
        "products",
    ];
    let csv = support::gallery("fretting_loop.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    table.write_record(header)?;
    for row in points.iter().map(Point::row) {
        table.serialize(row)?;
    }
    table.flush()?;
    let svg = support::gallery("fretting_loop.svg")?;
    draw(&svg, &points, &profiles)?;
    println!("\ntable: {}\nfigure: {}", csv.display(), svg.display());
    Ok(())
}

/// State at the end of a step.
struct Point {
    force: f64,
    shift: f64,
    exact_shift: f64,
    stick_ratio: f64,
    dissipated_energy: f64,
    dissipated_energy_midpoint: f64,
    work: f64,
    products: usize,
}

impl Point {
    fn of(step: &StepResult, exact: &MindlinDeresiewicz) -> Self {
        let energy = step.energy();
        Self {
            force: step.tangential_force()[0],
            shift: step.shift()[0],
            exact_shift: exact.shift(),
            stick_ratio: step.stick_ratio(),
            dissipated_energy: energy.dissipated_energy,
            dissipated_energy_midpoint: energy.dissipated_energy_midpoint,
            work: energy.work,
            products: step.tangential_report().map_or(0, |report| {
                report.double_precision_products + report.single_precision_products
            }),
        }
    }

    fn row(&self) -> [f64; 8] {
        [
            self.force,
            self.shift * MICRO,
            self.exact_shift * MICRO,
            self.stick_ratio,
            self.dissipated_energy * MICRO,
            self.dissipated_energy_midpoint * MICRO,
            self.work * MICRO,
            self.products as f64,
        ]
    }
}

/// Traction along the row of cells nearest to the x axis.
struct Profile {
    exact: MindlinDeresiewicz,
    /// Distance of the row from the axis.
    y: f64,
    samples: Vec<(f64, f64)>,
}

impl Profile {
    fn of(history: &History, exact: MindlinDeresiewicz) -> Self {
        let grid = history.grid();
        let row = grid.ny() / 2;
        let sample = |ix| Some((grid.x(ix), history.traction()[0].get(ix, row)?));
        Self {
            exact,
            y: grid.y(row),
            samples: (0..grid.nx()).filter_map(sample).collect(),
        }
    }

    /// Returns the mean absolute difference.
    fn mean_difference(&self) -> f64 {
        let differences = self
            .samples
            .iter()
            .map(|&(x, q)| (q - self.exact.traction(x.hypot(self.y))).abs());
        differences.sum::<f64>() / self.samples.len() as f64
    }
}

fn print_table(points: &[Point], profiles: &[Profile], cycle: &Cycle) -> stickslip::Result<()> {
    println!(
        "{:<36} | {:>12} | {:>12} | relative difference",
        "quantity", "computed", "closed form"
    );
    let print = |quantity: &str, computed: f64, closed_form: f64| {
        let difference = computed / closed_form - 1.0;
        println!("{quantity:<36} | {computed:>12.6} | {closed_form:>12.6} | {difference:>19.1e}");
    };
    let last = &points[STEPS..];
    let turns = [
        ("shift at the largest force (µm)", STEPS / 4),
        ("shift at zero force, unloading (µm)", STEPS / 2),
        ("shift at the smallest force (µm)", STEPS / 4 * 3),
        ("shift at zero force, reloading (µm)", STEPS),
    ];
    for (quantity, step) in turns {
        let point = &last[step - 1];
        print(quantity, point.shift * MICRO, point.exact_shift * MICRO);
    }
    let exact = &profiles[0].exact;
    let (energy, of_loop) = (exact.energy_per_cycle(), cycle.energy());
    for (quantity, computed) in [
        ("energy per cycle (µJ)", of_loop.dissipated_energy),
        (
            "  from mean tractions of a step (µJ)",
            of_loop.dissipated_energy_midpoint,
        ),
        ("  area of the polygonal loop (µJ)", of_loop.work),
    ] {
        print(quantity, computed * MICRO, energy * MICRO);
    }
    let rectangle = 4.0 * AMPLITUDE * points[STEPS / 4 - 1].exact_shift;
    print("energy ratio", cycle.energy_ratio()?, energy / rectangle);
    let imbalance = of_loop.dissipated_energy_midpoint / of_loop.work - 1.0;
    println!("\nenergy from mean tractions / area of the loop, minus one: {imbalance:.1e}");
    println!("cyclic residual: {:.1e}", cycle.cyclic_residual()?);

    let farthest = points
        .iter()
        .map(|p| (p.shift - p.exact_shift).abs())
        .fold(0.0, f64::max);
    let amplitude = points[STEPS / 4 - 1].exact_shift;
    println!(
        "largest difference of a shift / amplitude: {:.1e}",
        farthest / amplitude
    );
    for profile in profiles {
        let max_traction = FRICTION * profile.exact.hertz().max_pressure();
        let difference = profile.mean_difference() / max_traction;
        // The addition of zero turns a negative zero into a positive zero.
        let force = profile.exact.force() + 0.0;
        println!("traction at {force:>5.1} N, mean difference / (mu p0): {difference:.1e}");
    }
    let products: usize = points.iter().map(|point| point.products).sum();
    let most = points.iter().map(|point| point.products).max().unwrap_or(0);
    println!(
        "products per step: mean {:.1}, largest {most}",
        products as f64 / points.len() as f64
    );
    Ok(())
}

fn draw(path: &Path, points: &[Point], profiles: &[Profile]) -> Result<(), Box<dyn Error>> {
    let title = "Steel ball on steel, W = 100 N, F = ±40 N, friction 0.5";
    let figure = support::figure(path, (2 * support::PANEL, 1480), title)?;
    let figure = support::heading(&figure, support::COMPARED)?;
    let (left, right) = figure.split_horizontally(support::PANEL);
    draw_loop(&left, points, &profiles[0].exact)?;
    draw_tractions(&right, profiles)?;
    figure.present()?;
    Ok(())
}

/// Draws the force divided by the friction limit against the shift divided by the sliding shift.
fn draw_loop(
    area: &Area<'_>,
    points: &[Point],
    exact: &MindlinDeresiewicz,
) -> Result<(), Box<dyn Error>> {
    let (limit, sliding) = (FRICTION * NORMAL_FORCE, exact.sliding_shift());
    let mut chart = support::axes(
        area,
        (-0.8..0.8, "shift / sliding shift"),
        (-1.0..1.0, "F / µW"),
    )?;
    let mut line = Vec::new();
    // The closed form consists of the first loading and a loop.
    for (turns, from, to) in [
        (&[][..], 0.0, AMPLITUDE),
        (&[AMPLITUDE], AMPLITUDE, -AMPLITUDE),
        (&[AMPLITUDE, -AMPLITUDE], -AMPLITUDE, AMPLITUDE),
    ] {
        for i in 0..=100 {
            let force = from + (to - from) * f64::from(i) / 100.0;
            let path = [turns, &[force]].concat();
            let on_way = MindlinDeresiewicz::new(exact.hertz(), FRICTION, &path)?;
            line.push((on_way.shift() / sliding, force / limit));
        }
    }
    let dots = points.iter().map(|p| (p.shift / sliding, p.force / limit));
    support::compare(&mut chart, "loop", support::BLUE, line, dots)?;
    support::legend(&mut chart, SeriesLabelPosition::UpperLeft)
}

/// Draws the tractions at the turning points and between them. The other half of the loop is symmetric.
fn draw_tractions(area: &Area<'_>, profiles: &[Profile]) -> Result<(), Box<dyn Error>> {
    let hertz = profiles[0].exact.hertz();
    let (a, scale) = (hertz.contact_radius(), FRICTION * hertz.max_pressure());
    let mut chart = support::axes(
        area,
        (-VIEW..VIEW, "x / a"),
        (-1.0..1.6, "shear traction q / µp₀"),
    )?;
    let names: [(&str, RGBColor); 3] = [
        ("F = 40 N", support::BLUE),
        ("F = 0, unloading", support::ORANGE),
        ("F = −40 N", support::GREEN),
    ];
    for ((name, colour), profile) in names.into_iter().zip(profiles) {
        let line = (-500..=500)
            .map(|i| VIEW * f64::from(i) / 500.0)
            .map(|x| (x, profile.exact.traction((x * a).hypot(profile.y)) / scale));
        // Only every fourth cell is drawn, so that the points do not hide the lines.
        let dots = profile.samples.iter().step_by(4);
        let dots = dots.map(|&(x, q)| (x / a, q / scale));
        support::compare(&mut chart, name, colour, line, dots)?;
    }
    support::legend(&mut chart, SeriesLabelPosition::UpperMiddle)
}
