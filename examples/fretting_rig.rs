//! A fretting rig: a cylinder of Ti-6Al-4V on a flat specimen of the same, 200 N/mm, sheared to and fro while the bulk
//! stress of the specimen follows, until the loop repeats; then the stresses below the surface of the specimen.
//!
//! `cargo run --release --example fretting_rig [cells]` (default 512) prints contact, stick zone, loop and largest stresses
//! beside closed forms, and writes `target/gallery/fretting_rig.csv`, `.svg` and `.vti` (ParaView).

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;
use stickslip::analytical::{CattaneoMindlinLine, HertzLine};
use stickslip::history::{FrettingLoop, LoadPath};
use stickslip::subsurface::{Body, Planes, Stress};
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Boundary, ElasticPair, Friction, Grid, HalfSpace, History, LoadStep, Material, NormalControl,
    surface,
};
use support::maps;

/// Radius of the cylinder, normal load, amplitudes of the tangential load and of the bulk stress: mm, N/mm, MPa.
const RADIUS: f64 = 50.0;
const LOAD: f64 = 200.0;
const FRICTION: f64 = 0.6;
const SHEAR: f64 = 0.55 * FRICTION * LOAD;
const BULK: f64 = 150.0;
/// Distance along the surface that is taken to be at rest, mm.
const DATUM: f64 = 50.0;
/// Depth of the stresses, in half-widths of the contact, and number of planes.
const DEPTH: f64 = 2.0;
const PLANES: u32 = 81;

fn main() -> Result<(), Box<dyn Error>> {
    let cells = std::env::args()
        .nth(1)
        .map_or(Ok(512), |cells| cells.parse())?;
    let titanium = Material::new(115e3, 0.32)?;
    let pair = ElasticPair::new(titanium, titanium)?;
    let hertz = HertzLine::new(&pair, RADIUS, LOAD)?;
    let (a, p0) = (hertz.half_width(), hertz.max_pressure());
    let grid = Grid::line(cells, 3.0 * a / cells as f64)?;
    let boundary = Boundary::PeriodicAlongY { datum: DATUM };
    let bodies = HalfSpace::with_boundary(grid, pair, boundary)?;

    // The specimen is body 1. A bulk stress of 1 MPa stretches it by this much.
    let strain = [[titanium.plane_strain(1.0), 0.0], [0.0, 0.0]];
    let bulk = RelativeDisplacement::bulk_strain(grid, strain)?;
    let cylinder = surface::cylinder(grid, RADIUS)?;
    let builder = History::builder(&bodies, &cylinder, Friction::coulomb(FRICTION)?);
    let builder = builder.relative_displacement(bulk).tolerance(1e-8);
    let mut history = builder.build()?;
    history.step(&LoadStep::hold().normal(NormalControl::Force(LOAD)))?;

    let path = LoadPath::sine([SHEAR, 0.0], 80)?;
    let quarter = path.steps()[..20].to_vec();
    let load =
        |force: [f64; 2]| LoadStep::force(force).relative_displacement(BULK * force[0] / SHEAR);
    let outcome = FrettingLoop::new(path, load)
        .until_steady(1e-6)
        .run(&mut history, 10)?;
    let last = &outcome.last;
    let points: Vec<[f64; 2]> = last
        .points()
        .iter()
        .map(|point| [1e3 * point.shift[0], point.force[0] / (FRICTION * LOAD)])
        .collect();
    for force in quarter {
        history.step(&load(force))?;
    }

    let exact = CattaneoMindlinLine::new(hertz, FRICTION, SHEAR)?;
    let exact = exact.with_strain(titanium.plane_strain(BULK))?;
    let sticks: Vec<f64> = (0..cells)
        .filter(|&i| history.zones()[i] == stickslip::Zone::Stick)
        .map(|i| grid.x(i))
        .collect();
    let ends = [sticks.first(), sticks.last()].map(|x| x.copied().unwrap_or_default());
    let pressure = history.pressure();
    println!("                            | computed | closed form");
    let row = |name: &str, computed: f64, closed: f64| {
        println!("{name:27} | {computed:8.4} | {closed:8.4}");
    };
    row("largest pressure, MPa", pressure.max(), p0);
    row(
        "half-width, mm",
        0.5 * history.normal().contact_cells() as f64 * grid.dx(),
        a,
    );
    row(
        "approach, um",
        1e3 * history.approach(),
        1e3 * hertz.approach(DATUM),
    );
    row(
        "stick zone: middle / a",
        0.5 * (ends[0] + ends[1]) / a,
        exact.stick_centre() / a,
    );
    row(
        "stick zone: half-width / a",
        0.5 * (ends[1] - ends[0] + grid.dx()) / a,
        exact.stick_half_width() / a,
    );
    println!(
        "\nThe loop is steady after {} cycles. In one, load and bulk stress do the work of {:.5} mJ/mm, of which slip dissipates \
         {:.5}.",
        outcome.cycles,
        last.energy().work,
        last.energy().mid_step_dissipated_energy
    );

    // At the largest force: stress of the contact and of the bulk, in plane strain.
    let depths: Vec<f64> = (0..PLANES)
        .map(|k| DEPTH * a * f64::from(k) / f64::from(PLANES - 1))
        .collect();
    let with_bulk = |stress: Stress| Stress {
        xx: stress.xx + BULK,
        yy: stress.yy + 0.32 * BULK,
        ..stress
    };
    let mut planes = Planes::new(&bodies, &depths)?;
    let (mut rows, mut largest, mut tension) = (Vec::new(), [0.0; 3], [0.0; 2]);
    planes.through(Body::One, &history, |plane| {
        let von_mises = plane.map(|stress| with_bulk(stress).von_mises() / p0);
        for (i, stress) in plane.stresses().enumerate() {
            let equivalent = von_mises.as_slice()[i];
            if equivalent > largest[0] {
                largest = [equivalent, grid.x(i) / a, plane.depth() / a];
            }
            let along = (stress.xx + BULK) / p0;
            if plane.depth() == 0.0 && along > tension[0] {
                tension = [along, grid.x(i) / a];
            }
        }
        rows.push(von_mises);
        Ok(())
    })?;
    println!(
        "\nAt the largest force: von Mises {:.3} p0 at x = {:.2} a, z = {:.2} a; largest tension of the surface {:.3} p0 at \
         x = {:.2} a, where a crack would start.",
        largest[0], largest[1], largest[2], tension[0], tension[1]
    );
    let vti = support::gallery("fretting_rig.vti")?;
    planes.write_vti(&vti, Body::One, &history)?;

    let csv = support::gallery("fretting_rig.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    table.write_record(["x_over_a", "p_over_p0", "q_over_mu_p0", "q_closed_form"])?;
    let mut profile = Vec::new();
    for ix in 0..cells {
        let (x, limit) = (grid.x(ix), FRICTION * p0);
        let q = history.traction()[0].as_slice()[ix] / limit;
        let row = [
            x / a,
            pressure.as_slice()[ix] / p0,
            q,
            exact.traction(x) / limit,
        ];
        table.serialize(row)?;
        profile.push(row);
    }
    table.flush()?;
    let svg = support::gallery("fretting_rig.svg")?;
    let map = Map {
        reach: 1.5,
        largest: largest[0],
        rows: rows.iter().map(|row| row.as_slice()).collect(),
    };
    draw(&svg, &points, &profile, &map)?;
    println!(
        "\ntable: {}\nfigure: {}\nvolume: {}",
        csv.display(),
        svg.display(),
        vti.display()
    );
    Ok(())
}

/// Von Mises stress over p0, plane by plane from the surface down.
struct Map<'a> {
    /// Half the length of a row, in half-widths of the contact.
    reach: f64,
    largest: f64,
    rows: Vec<&'a [f64]>,
}

fn draw(
    path: &Path,
    points: &[[f64; 2]],
    profile: &[[f64; 4]],
    map: &Map<'_>,
) -> Result<(), Box<dyn Error>> {
    let title =
        "Cylinder on flat, Ti-6Al-4V, 200 N/mm, bulk stress in phase with the tangential load";
    let figure = support::figure(path, (2600, 860), title)?;
    let (curves, rest) = figure.split_horizontally(1540);
    let [first, second] = [0, 1].map(|k| curves.split_evenly((1, 2))[k].clone());

    let shifts = points.iter().map(|[shift, _]| shift.abs());
    let span = 1.15 * shifts.fold(0.0, f64::max);
    let mut chart = support::axes(
        &first,
        (-span..span, "shift, µm"),
        (-0.8..0.8, "tangential load / µP"),
    )?;
    let around = points.iter().chain(points.first()).map(|[x, y]| (*x, *y));
    chart.draw_series(LineSeries::new(around, support::BLUE.stroke_width(3)))?;

    let mut chart = support::axes(
        &second,
        (-1.2..1.2, "x / a"),
        (-0.2..1.6, "at the largest force"),
    )?;
    let column = |k: usize| profile.iter().map(move |row| (row[0], row[k]));
    let in_sight = |(x, _): &(f64, f64)| x.abs() < 1.2;
    chart
        .draw_series(LineSeries::new(
            column(1).filter(in_sight),
            support::GREEN.stroke_width(3),
        ))?
        .label("pressure / p0")
        .legend(|(x, y)| PathElement::new([(x, y), (x + 40, y)], support::GREEN.stroke_width(3)));
    let every = (profile.len() / 64).max(1);
    support::compare(
        &mut chart,
        "traction / µp0",
        support::ORANGE,
        column(3).filter(in_sight),
        column(2).step_by(every).filter(in_sight),
    )?;
    support::legend(&mut chart, SeriesLabelPosition::UpperLeft)?;

    let (area, bar) = rest.split_horizontally(840);
    let x = (-map.reach..map.reach, "x / a");
    let mut chart = support::axes(&area, x, (-DEPTH..0.0, "z / a, into the specimen"))?;
    let (columns, planes) = (map.rows[0].len(), map.rows.len() - 1);
    let block = columns.div_ceil(128);
    // Bands of a twentieth of p0: their edges are the contours.
    let band = |value: f64| (value * 20.0).floor() / 20.0 / map.largest;
    let width = 2.0 * map.reach / columns as f64;
    let rectangles = (0..planes).flat_map(|k| {
        let level = |k: f64| (-DEPTH * k / planes as f64).max(-DEPTH);
        (0..columns).step_by(block).map(move |first| {
            let ends = [first, (first + block).min(columns)];
            let [left, right] = ends.map(|end| width * end as f64 - map.reach);
            let value = map.rows[k][first + (ends[1] - first) / 2];
            // It reaches into the next blocks, which cover that part again: no seam shows.
            let right = (right + 0.5 * (right - left)).min(map.reach);
            let corners = [(left, level(k as f64)), (right, level(k as f64 + 1.5))];
            Rectangle::new(corners, maps::heat(band(value)).filled())
        })
    });
    chart.draw_series(rectangles)?;
    maps::bar(&bar, maps::heat, [0.0, map.largest], "von Mises / p0")?;
    figure.present()?;
    Ok(())
}
