//! The paper's ball (its Table 2) under a constant normal force and a tangential force that follows ellipses, from a
//! line to a circle. The example computes the paths of force and shift, slip and traction of the steady loop, and the
//! energy dissipated per cycle.
//!
//! If tractions rotate, the error of a step is proportional to its length. Each loop is therefore also run with half as
//! many steps. The example also prints the energy extrapolated to a step length of zero.
//!
//! `cargo run --release -p stickslip-examples --example elliptical_path [cells]` (default 64, at least 32)
//! writes `target/gallery/elliptical_path.csv`, `elliptical_path_energy.csv` and `elliptical_path.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::path::Path;

use plotters::element::PathElement;
use plotters::prelude::{RGBColor, SeriesLabelPosition};
use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::history::{FrettingLoop, FrettingResult, LoadPath, LoopPoint};
use stickslip::{
    ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep, Material, NormalLoad, Result,
    TangentialModel, surface,
};
use support::{Area, Chart, maps};

// SI units: metres, newtons, pascals.
const BALL_RADIUS: f64 = 3.5e-3;
const NORMAL_FORCE: f64 = 100.0;
const FRICTION: f64 = 0.5;
/// Amplitude of the force along x. Gross sliding starts at 50 N.
const AMPLITUDE: f64 = 40.0;
const STEPS: usize = 64;
/// Ratios of the amplitude along y to the amplitude along x.
const ASPECTS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
/// Loops drawn as paths: a line, an ellipse and a circle.
const SHOWN: [(usize, &str, RGBColor); 3] = [
    (0, "line", support::BLUE),
    (2, "ellipse", support::ORANGE),
    (4, "circle", support::GREEN),
];
/// Index of the loop drawn as a map.
const MAPPED: usize = 2;
/// Largest change of a traction in a cycle, relative to the largest traction, in a steady loop.
const STEADY: f64 = 1e-3;
const MAX_CYCLES: usize = 20;
const TOLERANCE: f64 = 1e-6;

const MICRO: f64 = 1e6;
/// Half-width of the view, in contact radii.
const VIEW: f64 = 1.2;

fn main() -> std::result::Result<(), Box<dyn Error>> {
    let cells = std::env::args()
        .nth(1)
        .map_or(Ok(64), |cells| cells.parse())?;
    let steel = Material::new(213e9, 0.29)?;
    let pair = ElasticPair::new(steel, steel)?;
    let hertz = HertzSphere::new(&pair, BALL_RADIUS, NORMAL_FORCE)?;
    let grid = Grid::square(cells, 2.0 * VIEW * hertz.contact_radius())?;
    let bodies = HalfSpace::new(grid, pair)?;
    let ball = surface::sphere(grid, BALL_RADIUS)?;

    let loops: Vec<_> = ASPECTS
        .iter()
        .map(|&aspect| Loop::run(&bodies, &ball, aspect))
        .collect::<Result<_>>()?;
    print_table(&loops);

    let paths = loops.iter().flat_map(|of| {
        let points = of.outcome.last.points().iter();
        points.map(|point| {
            let ([fx, fy], [x, y]) = (point.force, point.shift);
            [of.aspect, fx, fy, x * MICRO, y * MICRO]
        })
    });
    let header = [
        "aspect",
        "force_x_N",
        "force_y_N",
        "shift_x_um",
        "shift_y_um",
    ];
    let csv = support::gallery("elliptical_path.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    table.write_record(header)?;
    for row in paths {
        table.serialize(row)?;
    }
    table.flush()?;
    let header = [
        "aspect",
        "energy_uJ",
        "energy_extrapolated_uJ",
        "energy_ratio",
        "longest_path_slipped_um",
        "least_stick_ratio",
        "cycles",
    ];
    let rows = loops.iter().map(Loop::row);
    let energies = support::gallery("elliptical_path_energy.csv")?;
    let mut table = csv::Writer::from_path(&energies)?;
    table.write_record(header)?;
    for row in rows {
        table.serialize(row)?;
    }
    table.flush()?;
    let svg = support::gallery("elliptical_path.svg")?;
    draw(&svg, &loops, &CattaneoMindlin::new(hertz, FRICTION, 0.0)?)?;
    println!(
        "\ntables: {}, {}\nfigure: {}",
        csv.display(),
        energies.display(),
        svg.display()
    );
    Ok(())
}

/// Steady loop.
struct Loop {
    aspect: f64,
    outcome: FrettingResult,
    energy_ratio: f64,
    least_stick_ratio: f64,
    /// Traction at the end of the loop, where the force is along y.
    traction: [Field; 2],
    /// Energy of a cycle with infinitely many steps, extrapolated from cycles with all steps and with half as many.
    extrapolated_energy: f64,
}

impl Loop {
    fn run(bodies: &HalfSpace, ball: &Field, aspect: f64) -> Result<Self> {
        let (_, half) = steady_loop(bodies, ball, aspect, STEPS / 2)?;
        let (history, outcome) = steady_loop(bodies, ball, aspect, STEPS)?;
        let [few, many] = [&half, &outcome].map(|of| of.last.energy().dissipated_energy);
        Ok(Self {
            aspect,
            energy_ratio: outcome.last.energy_ratio()?,
            least_stick_ratio: outcome.last.stick_ratios()?[0],
            outcome,
            traction: history.traction().map(Clone::clone),
            extrapolated_energy: 2.0 * many - few,
        })
    }

    fn row(&self) -> [f64; 7] {
        let cycle = &self.outcome.last;
        [
            self.aspect,
            cycle.energy().dissipated_energy * MICRO,
            self.extrapolated_energy * MICRO,
            self.energy_ratio,
            cycle.slip_distance().max() * MICRO,
            self.least_stick_ratio,
            self.outcome.cycles as f64,
        ]
    }
}

/// Presses the ball and then drags it until the loop is steady.
fn steady_loop(
    bodies: &HalfSpace,
    ball: &Field,
    aspect: f64,
    steps: usize,
) -> Result<(History, FrettingResult)> {
    let mut history = History::builder(bodies, ball, Friction::coulomb(FRICTION)?)
        .model(TangentialModel::Vector)
        .tolerance(TOLERANCE)
        .build()?;
    history.step(&LoadStep::hold().normal(NormalLoad::Force(NORMAL_FORCE)))?;
    let path = LoadPath::ellipse([AMPLITUDE, aspect * AMPLITUDE], FRAC_PI_2, steps)?;
    let outcome = FrettingLoop::new(path, LoadStep::force)
        .until_steady(STEADY)
        .run(&mut history, MAX_CYCLES)?;
    Ok((history, outcome))
}

fn print_table(loops: &[Loop]) {
    println!(
        "aspect | energy (µJ)  extrapolated (µJ)  energy ratio  longest slip path (µm)  smallest stick ratio | cycles"
    );
    for of in loops {
        let [aspect, energy, extrapolated, ratio, slip, stick, cycles] = of.row();
        println!(
            "{aspect:>6.2} | {energy:>11.4}  {extrapolated:>17.4}  {ratio:>12.4}  {slip:>22.4}  {stick:>20.4} | {cycles:>3} {:?}",
            of.outcome.ending
        );
    }
}

fn draw(
    path: &Path,
    loops: &[Loop],
    sliding: &CattaneoMindlin,
) -> std::result::Result<(), Box<dyn Error>> {
    let title = "Steel ball on steel, W = 100 N: tangential force along ellipses";
    let figure = support::figure(path, (2 * support::PANEL, 2860), title)?;
    let (upper, lower) = figure.split_vertically(1510);
    let panels = [upper, lower].map(|row| row.split_horizontally(support::PANEL));
    let key = SHOWN.map(|(_, name, colour)| (colour, name));
    let limit = FRICTION * NORMAL_FORCE;
    let name = ["x", "y"].map(|axis| format!("F{axis} / µW"));
    let panel = support::heading(&panels[0].0, "force")?;
    let panel = support::key(&panel, &key)?;
    let mut chart = support::map_axes(&panel, (-1.0..1.0, &name[0]), (-1.0..1.0, &name[1]))?;
    draw_paths(&mut chart, loops, |point| point.force.map(|f| f / limit))?;
    let scale = sliding.sliding_shift();
    let name = ["x", "y"].map(|axis| format!("δ{axis} / δ₀"));
    let panel = support::heading(&panels[0].1, "shift, steady loop")?;
    let panel = support::key(&panel, &key)?;
    let mut chart = support::map_axes(&panel, (-0.8..0.8, &name[0]), (-0.8..0.8, &name[1]))?;
    draw_paths(&mut chart, loops, |point| point.shift.map(|x| x / scale))?;
    let (_, name, _) = SHOWN[1];
    let panel = support::heading(
        &panels[1].0,
        &format!("{name}: slip path, traction (arrows)"),
    )?;
    draw_map(&panel, &loops[MAPPED], &sliding.hertz())?;
    let panel = support::heading(&panels[1].1, "ratio to the values of the line")?;
    draw_energy(&panel, loops)?;
    figure.present()?;
    Ok(())
}

fn draw_paths(
    chart: &mut Chart<'_>,
    loops: &[Loop],
    of: impl Fn(&LoopPoint) -> [f64; 2],
) -> std::result::Result<(), Box<dyn Error>> {
    for (number, name, colour) in SHOWN {
        let points = loops[number].outcome.last.points().iter().map(&of);
        let points: Vec<_> = points.map(|[x, y]| (x, y)).collect();
        // The path is closed: the first point is the end of the previous cycle.
        let closed = points.iter().chain(points.first()).copied();
        support::line(chart, name, colour, closed)?;
    }
    Ok(())
}

/// Draws the slip path of a cycle (darker for a longer path) and the traction as arrows.
fn draw_map(
    area: &Area<'_>,
    of: &Loop,
    hertz: &HertzSphere,
) -> std::result::Result<(), Box<dyn Error>> {
    let (a, longest) = (hertz.contact_radius(), FRICTION * hertz.max_pressure());
    let view = -VIEW..VIEW;
    let slip = of.outcome.last.slip_distance();
    let grid = slip.grid();
    let scale = maps::Scale::from_zero(maps::dark, slip.max() * MICRO);
    let sides = [(view.clone(), "x / a"), (view, "y / a")];
    let mut chart = maps::axes_and_bar(area, sides, (scale, "slip path of a cycle (µm)"))?;
    maps::field(&mut chart, slip, [a, 1.0 / MICRO], scale)?;

    let stride = grid.nx() / 16;
    let first = stride / 2;
    let length = 2.0 * stride as f64 * grid.dx() / a / longest;
    let [x, y] = &of.traction;
    let mut arrows = Vec::new();
    for iy in (first..grid.ny()).step_by(stride) {
        for ix in (first..grid.nx()).step_by(stride) {
            let traction = [x.get(ix, iy), y.get(ix, iy)].map(Option::unwrap_or_default);
            if traction[0].hypot(traction[1]) > 0.0 {
                let tail = grid.position(ix, iy).map(|x| x / a);
                arrows.push(arrow(tail, traction.map(|q| q * length)));
            }
        }
    }
    chart.draw_series(arrows)?;
    Ok(())
}

/// Returns an arrow along a vector, with a head proportional to its length.
fn arrow([x, y]: [f64; 2], [u, v]: [f64; 2]) -> PathElement<(f64, f64)> {
    let at = |along: f64, across: f64| (x + along * u - across * v, y + along * v + across * u);
    let line = [
        at(0.0, 0.0),
        at(1.0, 0.0),
        at(0.7, 0.15),
        at(0.7, -0.15),
        at(1.0, 0.0),
    ];
    PathElement::new(line, support::stroke(support::ORANGE))
}

fn draw_energy(area: &Area<'_>, loops: &[Loop]) -> std::result::Result<(), Box<dyn Error>> {
    let mut chart = support::axes(
        area,
        (0.0..1.0, "amplitude along y / amplitude along x"),
        (0.0..6.0, "ratio"),
    )?;
    let relative = |column: usize| -> Vec<(f64, f64)> {
        let of_line = loops[0].row()[column];
        let rows = loops.iter().map(Loop::row);
        rows.map(|row| (row[0], row[column] / of_line)).collect()
    };
    for (name, column, colour, is_full) in [
        ("energy per cycle", 1, support::BLUE, true),
        ("energy, extrapolated", 2, support::BLUE, false),
        ("longest slip path", 4, support::ORANGE, true),
    ] {
        support::curve(&mut chart, name, (colour, is_full), &relative(column))?;
    }
    support::legend(&mut chart, SeriesLabelPosition::UpperLeft)
}
