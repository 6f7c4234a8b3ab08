//! The paper's ball (its Table 2) under a constant normal force, dragged round ellipses of force in the plane:
//! paths of force and shift, slip and traction of the steady loop, and what a cycle dissipates, from a line
//! to a circle.
//!
//! `cargo run --release --example elliptical_path [cells]` (default 64, at least 32)
//! writes `target/gallery/elliptical_path.csv`, `elliptical_path_energy.csv` and `elliptical_path.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::path::Path;

use plotters::element::PathElement;
use plotters::prelude::{Color, RGBColor, SeriesLabelPosition};
use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::history::{FrettingLoop, LoadPath, LoopOutcome, LoopPoint};
use stickslip::{
    ElasticPair, Field, Friction, Grid, HalfSpace, History, Lateral, LoadStep, Material,
    NormalStep, surface,
};
use support::{Area, Chart};

// SI units: metres, newtons, pascals.
const BALL_RADIUS: f64 = 3.5e-3;
const NORMAL_FORCE: f64 = 100.0;
const FRICTION: f64 = 0.5;
/// Along x; the contact slides at 50 N.
const AMPLITUDE: f64 = 40.0;
const STEPS: usize = 24;
/// Of the amplitude, that along y.
const ASPECTS: [f64; 9] = [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0];
/// Drawn as paths: a line, an ellipse, a circle.
const SHOWN: [(usize, &str, RGBColor); 3] = [
    (0, "line", support::BLUE),
    (4, "ellipse", support::ORANGE),
    (8, "circle", support::GREEN),
];
/// Drawn as a map.
const MAPPED: usize = 4;
/// A loop is steady when no traction changes by more, of the largest, in a cycle.
const STEADY: f64 = 1e-3;
const MAX_CYCLES: usize = 20;
const TOLERANCE: f64 = 1e-6;

const MICRO: f64 = 1e6;
/// Half the width shown, in contact radii.
const VIEW: f64 = 1.2;

fn main() -> Result<(), Box<dyn Error>> {
    let cells = std::env::args()
        .nth(1)
        .map_or(Ok(64), |cells| cells.parse())?;
    let steel = Material::new(213e9, 0.29)?;
    let pair = ElasticPair::new(steel, steel)?;
    let hertz = HertzSphere::new(&pair, BALL_RADIUS, NORMAL_FORCE)?;
    let grid = Grid::square(cells, 2.0 * VIEW * hertz.contact_radius())?;
    let bodies = HalfSpace::new(grid, pair)?;
    let ball = surface::sphere(grid, BALL_RADIUS)?;

    let mut loops = Vec::new();
    for aspect in ASPECTS {
        let mut history = History::builder(&bodies, &ball, Friction::coulomb(FRICTION)?)
            .lateral(Lateral::Coupled)
            .tolerance(TOLERANCE)
            .build()?;
        history.step(&LoadStep::hold().normal(NormalStep::Force(NORMAL_FORCE)))?;
        let path = LoadPath::ellipse([AMPLITUDE, aspect * AMPLITUDE], FRAC_PI_2, STEPS)?;
        let outcome = FrettingLoop::new(path, LoadStep::force)
            .until_steady(STEADY)
            .run(&mut history, MAX_CYCLES)?;
        loops.push(Loop {
            aspect,
            outcome,
            traction: history.traction().map(Clone::clone),
        });
    }
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
    let csv = support::table::csv("elliptical_path.csv", header, paths)?;
    let header = [
        "aspect",
        "energy_uJ",
        "energy_ratio",
        "largest_slip_path_um",
        "least_stick_ratio",
        "cycles",
    ];
    let rows = loops.iter().map(Loop::row);
    let energies = support::table::csv("elliptical_path_energy.csv", header, rows)?;
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

/// A steady loop.
struct Loop {
    aspect: f64,
    outcome: LoopOutcome,
    /// At its end, where the force is along y.
    traction: [Field; 2],
}

impl Loop {
    fn row(&self) -> [f64; 6] {
        let cycle = &self.outcome.last;
        [
            self.aspect,
            cycle.energy().dissipated * MICRO,
            cycle.energy_ratio(),
            cycle.slip_length().max() * MICRO,
            cycle.stick_ratios()[0],
            self.outcome.cycles as f64,
        ]
    }
}

fn print_table(loops: &[Loop]) {
    println!(
        "aspect | energy, uJ  energy ratio  largest slip path, um  least stick ratio | cycles"
    );
    for of in loops {
        let [aspect, energy, ratio, slip, stick, cycles] = of.row();
        println!(
            "{aspect:>6.3} | {energy:>10.4}  {ratio:>12.4}  {slip:>21.4}  {stick:>17.4} | {cycles:>3} {:?}",
            of.outcome.ending
        );
    }
}

fn draw(path: &Path, loops: &[Loop], sliding: &CattaneoMindlin) -> Result<(), Box<dyn Error>> {
    let title = "Steel ball on steel, W = 100 N, dragged round ellipses of force of 40 N along x";
    let figure = support::figure(path, (1960, 2000), title)?;
    let panels = figure.split_evenly((2, 2));
    let limit = FRICTION * NORMAL_FORCE;
    let name = ["x", "y"].map(|axis| format!("F{axis} / μW"));
    let mut chart = support::axes(&panels[0], (-1.0..1.0, &name[0]), (-1.0..1.0, &name[1]))?;
    draw_paths(&mut chart, loops, |point| point.force.map(|f| f / limit))?;
    let scale = sliding.sliding_shift();
    let name = ["x", "y"].map(|axis| format!("δ{axis} / δ₀"));
    let mut chart = support::axes(&panels[1], (-0.8..0.8, &name[0]), (-0.8..0.8, &name[1]))?;
    draw_paths(&mut chart, loops, |point| point.shift.map(|x| x / scale))?;
    draw_map(&panels[2], &loops[MAPPED], &sliding.hertz())?;
    draw_energy(&panels[3], loops)?;
    figure.present()?;
    Ok(())
}

fn draw_paths(
    chart: &mut Chart<'_>,
    loops: &[Loop],
    of: impl Fn(&LoopPoint) -> [f64; 2],
) -> Result<(), Box<dyn Error>> {
    for (number, name, colour) in SHOWN {
        let points = loops[number].outcome.last.points().iter().map(&of);
        let points: Vec<_> = points.map(|[x, y]| (x, y)).collect();
        support::curve(chart, name, (colour, true), &points)?;
    }
    support::legend(chart, SeriesLabelPosition::UpperLeft)
}

/// Path slipped in a cycle, the darker the longer, and traction as arrows.
fn draw_map(area: &Area<'_>, of: &Loop, hertz: &HertzSphere) -> Result<(), Box<dyn Error>> {
    let (a, longest) = (hertz.contact_radius(), FRICTION * hertz.max_pressure());
    let view = -VIEW..VIEW;
    let mut chart = support::axes(area, (view.clone(), "x / a"), (view, "y / a"))?;
    let slip = of.outcome.last.slip_length();
    let grid = slip.grid();
    let mut brightness = Field::zeros(grid);
    brightness.add_scaled(-1.0, slip)?;
    support::maps::heights(&mut chart, &brightness, a)?;

    let stride = grid.nx() / 16;
    let first = stride / 2;
    let length = 2.0 * stride as f64 * grid.dx() / a / longest;
    let [x, y] = &of.traction;
    let mut arrows = Vec::new();
    for iy in (first..grid.ny()).step_by(stride) {
        for ix in (first..grid.nx()).step_by(stride) {
            let traction = [x.get(ix, iy), y.get(ix, iy)].map(Option::unwrap_or_default);
            if traction != [0.0; 2] {
                let tail = grid.position(ix, iy).map(|x| x / a);
                arrows.push(arrow(tail, traction.map(|q| q * length)));
            }
        }
    }
    chart.draw_series(arrows)?;
    Ok(())
}

/// From a tail by a vector, with a head in proportion.
fn arrow([x, y]: [f64; 2], [u, v]: [f64; 2]) -> PathElement<(f64, f64)> {
    let at = |along: f64, across: f64| (x + along * u - across * v, y + along * v + across * u);
    let line = [
        at(0.0, 0.0),
        at(1.0, 0.0),
        at(0.7, 0.15),
        at(0.7, -0.15),
        at(1.0, 0.0),
    ];
    PathElement::new(line, support::ORANGE.stroke_width(3))
}

fn draw_energy(area: &Area<'_>, loops: &[Loop]) -> Result<(), Box<dyn Error>> {
    let of_line = &loops[0].outcome.last;
    let mut chart = support::axes(
        area,
        (0.0..1.0, "aspect"),
        (0.0..5.0, "over that of the line"),
    )?;
    let relative = |of: &dyn Fn(&Loop) -> f64| -> Vec<(f64, f64)> {
        let points = loops
            .iter()
            .map(|each| (each.aspect, of(each) / of(&loops[0])));
        points.collect()
    };
    let energy = relative(&|of| of.outcome.last.energy().dissipated);
    let slip = relative(&|of| of.outcome.last.slip_length().max());
    let energy_name = format!(
        "energy of a cycle ({:.1} uJ)",
        of_line.energy().dissipated * MICRO
    );
    let slip_name = format!(
        "longest path slipped ({:.2} um)",
        of_line.slip_length().max() * MICRO
    );
    support::curve(&mut chart, &energy_name, (support::BLUE, true), &energy)?;
    support::curve(&mut chart, &slip_name, (support::ORANGE, false), &slip)?;
    support::legend(&mut chart, SeriesLabelPosition::UpperLeft)
}
