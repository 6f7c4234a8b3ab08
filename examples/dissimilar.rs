//! An aluminium ball on steel, pressed in steps and then sheared back and forth, with coupled pressure and traction.
//!
//! `cargo run --release -p stickslip-examples --example dissimilar [cells]` (default 96) prints the effect of the coupling
//! between the two materials, and writes `target/gallery/dissimilar.csv` and `.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;
use stickslip::analytical::HertzSphere;
use stickslip::{
    Axis, Coupling, ElasticPair, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalLoad, TangentialControl, TangentialModel, surface,
};

const RADIUS: f64 = 10e-3;
const FORCE: f64 = 100.0;
const FRICTION: f64 = 0.3;
/// Tolerance of the tractions while the ball is pressed in steps.
const TOLERANCE: f64 = 2e-3;
/// Steps from one turning point to the next.
const STEPS: u32 = 10;
/// Turning points of the tangential force, divided by the sliding force.
const TURNS: [f64; 3] = [0.6, -0.6, 0.6];

fn main() -> Result<(), Box<dyn Error>> {
    let cells = std::env::args()
        .nth(1)
        .map_or(Ok(96), |cells| cells.parse())?;
    let (aluminium, steel) = (Material::new(70e9, 0.33)?, Material::new(210e9, 0.3)?);
    let pair = ElasticPair::new(aluminium, steel)?;
    let hertz = HertzSphere::new(&pair, RADIUS, FORCE)?;
    let grid = Grid::square(cells, 2.5 * hertz.contact_radius())?;
    let bodies = HalfSpace::new(grid, pair)?;
    println!(
        "Dundurs' beta {:.4}, friction {FRICTION}",
        pair.dundurs_beta()
    );

    let ball = surface::sphere(grid, RADIUS)?;
    let builder = || {
        History::builder(&bodies, &ball, Friction::coulomb(FRICTION)?)
            .tolerance(1e-8)
            .build()
    };
    let mut coupled = builder()?;
    let mut uncoupled = History::builder(&bodies, &ball, Friction::coulomb(FRICTION)?)
        .model(TangentialModel::Vector)
        .coupling(Coupling::Neglected)
        .build()?;
    for history in [&mut coupled, &mut uncoupled] {
        let press = LoadStep::hold().normal(NormalLoad::Force(FORCE));
        let steps = history.press(&press, TOLERANCE)?;
        println!("pressed in {steps} steps");
    }
    println!("\npressed        | coupled | not coupled");
    let row = |name: &str, value: &dyn Fn(&History) -> stickslip::Result<f64>| {
        println!(
            "{name:<14} | {:>7.4} | {:>7.4}",
            value(&coupled)?,
            value(&uncoupled)?
        );
        Ok::<_, stickslip::Error>(())
    };
    row("pressure/Hertz", &|h| {
        Ok(h.pressure().max() / hertz.max_pressure())
    })?;
    row("approach/Hertz", &|h| Ok(h.approach() / hertz.approach()))?;
    row("stick radius", &|h| Ok(h.last_step()?.stick_ratio().sqrt()))?;
    let pressed = coupled.clone();

    let start = |history: &History| vec![(1e6 * history.shift()[0], 0.0)];
    let mut loops = [start(&coupled), start(&uncoupled)];
    println!(
        "\nforce/limit | shift (µm), coupled | not coupled | stick ratio, coupled | not coupled"
    );
    let mut last = 0.0;
    for turn in TURNS {
        for part in 1..=STEPS {
            let force = last + (turn - last) * f64::from(part) / f64::from(STEPS);
            let drag = TangentialControl::Force(force * FRICTION * FORCE);
            let load = LoadStep::hold()
                .normal(NormalLoad::Force(FORCE))
                .tangential(Axis::X, drag);
            for (history, points) in [&mut coupled, &mut uncoupled].into_iter().zip(&mut loops) {
                history.step(&load)?;
                points.push((1e6 * history.shift()[0], force));
            }
        }
        last = turn;
        println!(
            "{turn:>11.1} | {:>19.4} | {:>11.4} | {:>20.3} | {:>11.3}",
            1e6 * coupled.shift()[0],
            1e6 * uncoupled.shift()[0],
            coupled.last_step()?.stick_ratio(),
            uncoupled.last_step()?.stick_ratio(),
        );
    }

    let csv = support::gallery("dissimilar.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    table.write_record(["x_um", "pressure_MPa", "uncoupled_MPa", "traction_x_MPa"])?;
    for row in profiles(&pressed, &uncoupled) {
        table.serialize(row)?;
    }
    table.flush()?;
    let svg = support::gallery("dissimilar.svg")?;
    draw(&svg, &pressed, &profiles(&pressed, &uncoupled), &loops)?;
    println!("\ntable: {}\nfigure: {}", csv.display(), svg.display());
    Ok(())
}

/// Returns, along the middle row, the position x, the pressures with and without coupling, and the traction after pressing.
fn profiles(pressed: &History, uncoupled: &History) -> Vec<[f64; 4]> {
    let grid = pressed.grid();
    let row = |field: &stickslip::Field, ix: usize| {
        field.get(ix, grid.ny() / 2).unwrap_or_default() * 1e-6
    };
    let sample = |ix: usize| {
        [
            1e6 * grid.x(ix),
            row(pressed.pressure(), ix),
            row(uncoupled.pressure(), ix),
            row(pressed.traction()[0], ix),
        ]
    };
    (0..grid.nx()).map(sample).collect()
}

/// Function that selects a quantity from a row of the profiles.
type Value = fn(&[f64; 4]) -> f64;

fn draw(
    path: &Path,
    pressed: &History,
    profiles: &[[f64; 4]],
    loops: &[Vec<(f64, f64)>; 2],
) -> Result<(), Box<dyn Error>> {
    let title = "Aluminium ball on steel, coupled pressure and shear traction";
    let figure = support::figure(path, (2 * support::PANEL, 2220), title)?;
    let (upper, lower) = figure.split_vertically(800);
    let (left, right) = lower.split_horizontally(support::PANEL);
    let reach = 1.1
        * profiles.iter().fold(
            0.0,
            |m: f64, row| if row[1] > 0.0 { m.max(row[0]) } else { m },
        );

    let largest = profiles.iter().fold(0.0, |m: f64, row| m.max(row[1]));
    let (x, y) = (-reach..reach, -0.5 * largest..1.1 * largest);
    let points = |value: Value| -> Vec<(f64, f64)> {
        let seen = profiles.iter().filter(|row| row[0].abs() <= reach);
        seen.map(|row| (row[0], value(row))).collect()
    };
    let pressure: Value = |row| row[1];
    let change: Value = |row| 20.0 * (row[1] - row[2]);
    let traction: Value = |row| row[3];
    let curves = [
        ("pressure", pressure, support::BLUE),
        ("20 × its change by coupling", change, support::ORANGE),
        ("shear traction", traction, support::GREEN),
    ];
    let upper = support::heading(&upper, "pressed, along x")?;
    let upper = support::key(&upper, &curves.map(|(name, _, colour)| (colour, name)))?;
    let mut chart = support::axes(&upper, (x, "x (µm)"), (y, "traction (MPa)"))?;
    for (name, value, colour) in curves {
        support::line(&mut chart, name, colour, points(value))?;
    }

    let left = support::heading(&left, "pressed; lines: shear traction")?;
    let left = support::key(&left, &support::maps::zones_key(pressed.zones()))?;
    let mut chart = support::map_axes(&left, (-reach..reach, "x (µm)"), (-reach..reach, "y (µm)"))?;
    let sight = [-reach..reach, -reach..reach];
    support::maps::zones(&mut chart, pressed.grid(), pressed.zones(), 1e-6, sight)?;
    arrows(&mut chart, pressed, reach)?;

    let width = loops
        .iter()
        .flatten()
        .fold(0.0, |m: f64, point| m.max(point.0.abs()));
    let (x, y) = (-1.1 * width..1.1 * width, -0.8..0.8);
    let right = support::heading(&right, "sheared back and forth")?;
    let mut chart = support::axes(&right, (x, "shift (µm)"), (y, "F / µW"))?;
    let names = ["coupled", "not coupled"];
    let colours = [support::BLUE, support::ORANGE];
    for ((points, name), colour) in loops.iter().zip(names).zip(colours) {
        support::line(&mut chart, name, colour, points.iter().copied())?;
    }
    support::legend(&mut chart, SeriesLabelPosition::UpperLeft)?;
    figure.present()?;
    Ok(())
}

/// Returns arrows for the tractions after pressing, on the surface of the ball.
fn arrows(
    chart: &mut support::Chart<'_>,
    pressed: &History,
    reach: f64,
) -> Result<(), Box<dyn Error>> {
    let (grid, [x, y]) = (pressed.grid(), pressed.traction());
    let largest = x.max().max(-x.min());
    let every = (grid.nx() / 16).max(1);
    let length = 0.9 * 2.0 * reach / 16.0;
    for iy in (every / 2..grid.ny()).step_by(every) {
        for ix in (every / 2..grid.nx()).step_by(every) {
            let traction = [x, y].map(|field| field.get(ix, iy).unwrap_or_default() / largest);
            if traction[0].hypot(traction[1]) < 0.02 {
                continue;
            }
            let from = (1e6 * grid.x(ix), 1e6 * grid.y(iy));
            let to = (from.0 + length * traction[0], from.1 + length * traction[1]);
            chart.draw_series([PathElement::new([from, to], support::stroke(BLACK))])?;
            chart.draw_series([Circle::new(from, 8, BLACK.filled())])?;
        }
    }
    Ok(())
}
