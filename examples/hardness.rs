//! Rough steel on steel, elastic and with a hardness, pressed, released and pressed again.
//!
//! `cargo run --release -p stickslip-examples --example hardness [cells]` (default 192) prints area, largest pressure and
//! approach, and writes `target/gallery/hardness.csv` and `.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;
use stickslip::normal::Hardness;
use stickslip::surface::{self, SelfAffine};
use stickslip::{
    Boundary, ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalLoad,
};

/// Side of the surface, rms slope and hardness, in SI units.
const SIDE: f64 = 100e-6;
const RMS_SLOPE: f64 = 0.1;
const HARDNESS: f64 = 6e9;
/// Largest mean pressure, as a fraction of the hardness.
const LARGEST: f64 = 0.15;
const STEPS: i32 = 12;

fn main() -> Result<(), Box<dyn Error>> {
    let cells = std::env::args()
        .nth(1)
        .map_or(Ok(192), |cells| cells.parse())?;
    let steel = Material::new(210e9, 0.3)?;
    let grid = Grid::square(cells, SIDE)?;
    let bodies =
        HalfSpace::with_boundary(grid, ElasticPair::new(steel, steel)?, Boundary::Periodic)?;
    let heights = SelfAffine::with_rms_slope(RMS_SLOPE)
        .longest_wavelength(SIDE / 2.0)
        .cut_off_wavelength(SIDE / 32.0)
        .seed(3)
        .generate(grid)?;
    let gap = surface::gap_from_heights(heights.heights())?;
    let builder =
        || Ok::<_, stickslip::Error>(History::builder(&bodies, &gap, Friction::coulomb(0.1)?));
    let mut elastic = builder()?.tolerance(1e-6).build()?;
    let hardness = Hardness::uniform(HARDNESS)?;
    let plastic = builder()?.hardness(hardness).permanent_set(true);
    let mut plastic = plastic.tolerance(1e-6).build()?;

    println!("           | contact area (%)  | largest pressure (GPa) | at the limit");
    println!("mean p / H | elastic | limited | elastic | limited      | (% of contact)");
    let up = (1..=STEPS).map(|step| (step, "pressed"));
    let down = (0..STEPS).rev().map(|step| (step, "released"));
    let again = (1..=STEPS).map(|step| (step, "pressed again"));
    let mut points = Vec::new();
    for (step, phase) in up.chain(down).chain(again) {
        let part = LARGEST * f64::from(step) / f64::from(STEPS);
        let load = NormalLoad::Force(part * HARDNESS * grid.area());
        let mut point = [part, 0.0, 0.0, 0.0, 0.0];
        for (place, history) in [&mut elastic, &mut plastic].into_iter().enumerate() {
            history.step(&LoadStep::hold().normal(load))?;
            point[1 + place] = 100.0 * history.normal().contact_area() / grid.area();
            point[3 + place] = 1e6 * history.approach();
        }
        let (touching, at_limit) = (
            plastic.normal().contact_cells(),
            plastic.normal().yielded_cells(),
        );
        if step % 3 == 0 && step > 0 {
            println!(
                "{part:>10.4} | {:>7.2} | {:>7.2} | {:>7.2} | {:>12.2} | {:>5.1} {phase}",
                point[1],
                point[2],
                1e-9 * elastic.pressure().max(),
                1e-9 * plastic.pressure().max(),
                100.0 * at_limit as f64 / touching.max(1) as f64,
            );
        }
        points.push((phase, point));
    }
    let depth = plastic.state().yielded().map_or(0.0, Field::max);
    println!(
        "\nThe highest summit is flattened by {:.3} µm.",
        1e6 * depth
    );

    let csv = support::gallery("hardness.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    let head = [
        "phase",
        "mean_pressure_over_hardness",
        "area_elastic_percent",
        "area_limited_percent",
    ];
    table.write_record(
        head.into_iter()
            .chain(["approach_elastic_um", "approach_limited_um"]),
    )?;
    for row in &points {
        table.serialize(row)?;
    }
    table.flush()?;
    let svg = support::gallery("hardness.svg")?;
    draw(&svg, &points, [&elastic, &plastic])?;
    println!("\ntable: {}\nfigure: {}", csv.display(), svg.display());
    Ok(())
}

fn draw(
    path: &Path,
    points: &[(&str, [f64; 5])],
    [elastic, plastic]: [&History; 2],
) -> Result<(), Box<dyn Error>> {
    let title = "Rough steel, elastic and with a hardness of 6 GPa";
    let figure = support::figure(path, (2 * support::PANEL, 1900), title)?;
    let (upper, lower) = figure.split_vertically(980);
    let areas = upper.split_evenly((1, 2));
    let series = |phase: &'static str, column: usize| {
        let chosen = points.iter().filter(move |(of, _)| *of == phase);
        chosen.map(move |(_, point)| (point[0], point[column]))
    };
    let limits = |columns: [usize; 2]| {
        let values = points
            .iter()
            .flat_map(|(_, point)| columns.map(|column| point[column]));
        values.fold((0.0_f64, 0.0_f64), |(low, high), value| {
            (low.min(value), high.max(value))
        })
    };
    let curves = [
        ("elastic", "pressed", 0, support::BLUE),
        ("limited, pressed", "pressed", 1, support::ORANGE),
        ("limited, released", "released", 1, support::GREEN),
    ];
    for (place, (name, first)) in [("contact area (%)", 1), ("approach (µm)", 3)]
        .into_iter()
        .enumerate()
    {
        let (low, high) = limits([first, first + 1]);
        let x = (0.0..1.05 * LARGEST, "mean pressure / H");
        let y = (1.1 * low..1.6 * high, name);
        let mut chart = support::axes(&areas[place], x, y)?;
        for (label, phase, offset, colour) in curves {
            support::line(&mut chart, label, colour, series(phase, first + offset))?;
        }
        let again = series("pressed again", first + 1);
        support::dots(&mut chart, "pressed again", (support::GREEN, false), again)?;
        support::legend(&mut chart, SeriesLabelPosition::UpperLeft)?;
    }

    let lower = support::heading(&lower, "at the largest load, along a row of cells")?;
    draw_profiles(&lower, elastic, plastic)?;
    figure.present()?;
    Ok(())
}

/// Draws the pressures along the row that carries the largest load, cut off at three times the hardness.
fn draw_profiles(
    area: &support::Area<'_>,
    elastic: &History,
    plastic: &History,
) -> Result<(), Box<dyn Error>> {
    let grid = plastic.grid();
    let at = |of: &History, ix, iy| of.pressure().get(ix, iy).unwrap_or_default();
    let loaded = |iy: usize| (0..grid.nx()).map(|ix| at(plastic, ix, iy)).sum::<f64>();
    let row = (0..grid.ny())
        .max_by(|a, b| loaded(*a).total_cmp(&loaded(*b)))
        .unwrap_or_default();
    let (reach, highest) = (1e6 * 0.5 * SIDE, 3e-9 * HARDNESS);
    let (x, y) = ((-reach..reach, "x (µm)"), (0.0..highest, "pressure (GPa)"));
    let mut chart = support::axes(area, x, y)?;
    for (name, of, colour) in [
        ("elastic", elastic, support::BLUE),
        ("limited", plastic, support::ORANGE),
    ] {
        let profile =
            (0..grid.nx()).map(|ix| (1e6 * grid.x(ix), (1e-9 * at(of, ix, row)).min(highest)));
        support::line(&mut chart, name, colour, profile)?;
    }
    support::legend(&mut chart, SeriesLabelPosition::UpperLeft)
}
