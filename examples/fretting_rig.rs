//! A fretting rig: a cylinder of Ti-6Al-4V under 200 N/mm on a flat specimen of the same alloy. The tangential load and the
//! bulk stress of the specimen oscillate in phase until the loop is steady. The example then computes the stresses below the
//! surface of the specimen.
//!
//! `cargo run --release -p stickslip-examples --example fretting_rig [cells]` (default 512) compares contact, stick zone, loop
//! and the tension at the edge with closed forms, and writes `target/gallery/fretting_rig.csv`, `.svg` and `.vti` (ParaView).

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;
use stickslip::analytical::{CattaneoMindlinLine, HertzLine};
use stickslip::history::{FrettingLoop, LoadPath};
use stickslip::subsurface::{Body, Planes, Stress, Tractions};
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Boundary, ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalLoad, Zone, surface,
};
use support::axis::Axis;
use support::maps;

/// Radius of the cylinder, normal load, and amplitudes of the tangential load and of the bulk stress, in mm, N/mm and MPa.
const RADIUS: f64 = 50.0;
const LOAD: f64 = 200.0;
const FRICTION: f64 = 0.6;
const SHEAR: f64 = 0.55 * FRICTION * LOAD;
const BULK: f64 = 150.0;
/// Distance along the surface of the point that is assumed to be at rest, in mm.
const DATUM: f64 = 50.0;
/// Largest depth of the stresses, in half-widths of the contact.
const DEPTH: f64 = 2.0;
/// Number of planes of the stresses.
const PLANES: u32 = 81;

fn main() -> Result<(), Box<dyn Error>> {
    let cells = std::env::args()
        .nth(1)
        .map_or(Ok(512), |cells| cells.parse())?;
    let titanium = Material::new(115e3, 0.32)?;
    let hertz = HertzLine::new(&ElasticPair::new(titanium, titanium)?, RADIUS, LOAD)?;
    let a = hertz.half_width();
    let grid = Grid::line(cells, 3.0 * a / cells as f64)?;
    let boundary = Boundary::PeriodicAlongY { datum: DATUM };
    let bodies = HalfSpace::with_boundary(grid, *hertz.pair(), boundary)?;

    // The specimen is body 1. A bulk stress of 1 MPa causes this strain in the specimen.
    let strain = [[titanium.plane_strain_under(1.0), 0.0], [0.0, 0.0]];
    let bulk = RelativeDisplacement::bulk_strain(grid, strain)?;
    let cylinder = surface::cylinder(grid, RADIUS)?;
    let builder = History::builder(&bodies, &cylinder, Friction::coulomb(FRICTION)?);
    let builder = builder.relative_displacement(bulk).tolerance(1e-8);
    let mut history = builder.build()?;
    history.step(&LoadStep::hold().normal(NormalLoad::Force(LOAD)))?;

    let exact = CattaneoMindlinLine::new(hertz, FRICTION, SHEAR)?;
    let exact = exact.with_bulk_stress([BULK, 0.0])?;
    let points = fret(&mut history, &exact)?;
    compare(&history, &exact);
    let profile = profile(&history, &exact)?;
    let (rows, largest) = stresses(&history, &bodies, &exact)?;

    let svg = support::gallery("fretting_rig.svg")?;
    let map = Map {
        reach: 1.5,
        largest,
        rows: rows.iter().map(Field::as_slice).collect(),
    };
    draw(&svg, &points, &profile, &map)?;
    println!("figure: {}", svg.display());
    Ok(())
}

/// Shears back and forth until the loop is steady, and then to the largest force. Returns the shift in µm and the force divided
/// by the sliding force around the loop.
fn fret(
    history: &mut History,
    exact: &CattaneoMindlinLine,
) -> Result<Vec<[f64; 2]>, Box<dyn Error>> {
    let path = LoadPath::sine([SHEAR, 0.0], 80)?;
    let quarter = path.steps()[..20].to_vec();
    let load =
        |force: [f64; 2]| LoadStep::force(force).relative_displacement(BULK * force[0] / SHEAR);
    let outcome = FrettingLoop::new(path, load)
        .until_steady(1e-6)
        .run(history, 10)?;
    let (energy, of_loads) = (outcome.last.energy(), outcome.last.work_of_loads());
    println!(
        "The loop is steady after {} cycles. Work of the tangential load in a cycle, the area of the loop: {:.5} mJ/mm. \
         Work of the bulk stress: {:.5} mJ/mm. Energy dissipated by slip: {:.5} mJ/mm (closed form: {:.5}).\n",
        outcome.cycles,
        of_loads,
        energy.work - of_loads,
        energy.dissipated_energy_midpoint,
        exact.energy_per_cycle()
    );
    for force in quarter {
        history.step(&load(force))?;
    }
    let points = outcome.last.points().iter();
    let points = points.map(|point| [1e3 * point.shift[0], point.force[0] / (FRICTION * LOAD)]);
    Ok(points.collect())
}

/// Compares the contact and its stick zone with the closed forms.
fn compare(history: &History, exact: &CattaneoMindlinLine) {
    let (grid, hertz) = (history.grid(), exact.hertz());
    let a = hertz.half_width();
    let sticks = |i: &usize| history.zones()[*i] == Zone::Stick;
    let ends = [(0..grid.nx()).find(sticks), (0..grid.nx()).rfind(sticks)];
    let ends = ends.map(|end| end.map_or(0.0, |i| grid.x(i)));
    let width = |cells: usize| 0.5 * cells as f64 * grid.dx();
    println!("                           | computed | closed form");
    for (name, computed, closed) in [
        (
            "largest pressure (MPa)",
            history.pressure().max(),
            hertz.max_pressure(),
        ),
        (
            "half-width (mm)",
            width(history.normal().contact_cells()),
            a,
        ),
        (
            "approach (µm)",
            1e3 * history.approach(),
            1e3 * hertz.approach(DATUM),
        ),
        (
            "stick zone: middle / a",
            0.5 * (ends[0] + ends[1]) / a,
            exact.stick_centre() / a,
        ),
        (
            "stick zone: half-width / a",
            0.5 * (ends[1] - ends[0] + grid.dx()) / a,
            exact.stick_half_width() / a,
        ),
    ] {
        println!("{name:26} | {computed:8.4} | {closed:8.4}");
    }
}

/// Returns pressure and traction along x at the largest force, and writes them to a table. The columns are x/a, p/p0, q/(mu p0),
/// and the closed form of the traction.
fn profile(
    history: &History,
    exact: &CattaneoMindlinLine,
) -> Result<Vec<[f64; 4]>, Box<dyn Error>> {
    let (grid, hertz) = (history.grid(), exact.hertz());
    let limit = FRICTION * hertz.max_pressure();
    let (pressure, [traction, _]) = (history.pressure(), history.traction());
    let row = |ix: usize| {
        let x = grid.x(ix);
        let (p, q) = (pressure.as_slice()[ix], traction.as_slice()[ix]);
        let p0 = hertz.max_pressure();
        [
            x / hertz.half_width(),
            p / p0,
            q / limit,
            exact.traction(x) / limit,
        ]
    };
    let profile: Vec<_> = (0..grid.nx()).map(row).collect();
    let csv = support::gallery("fretting_rig.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    table.write_record(["x_over_a", "p_over_p0", "q_over_mu_p0", "q_closed_form"])?;
    for row in &profile {
        table.serialize(row)?;
    }
    table.flush()?;
    println!("\ntable: {}", csv.display());
    Ok(profile)
}

/// Computes the von Mises stress of contact and bulk below the surface of the specimen, divided by p0, plane by plane, and its
/// largest value.
fn stresses(
    history: &History,
    bodies: &HalfSpace,
    exact: &CattaneoMindlinLine,
) -> Result<(Vec<Field>, f64), Box<dyn Error>> {
    let (grid, nu) = (history.grid(), bodies.pair().bodies()[0].poisson_ratio());
    let (a, p0) = (exact.hertz().half_width(), exact.hertz().max_pressure());
    // The bulk stress acts in plane strain.
    let bulk = Stress {
        xx: BULK,
        yy: nu * BULK,
        ..Stress::default()
    };
    let loads = Tractions::from(history).with_uniform_stress(bulk);
    let depth = |k: u32| DEPTH * a * f64::from(k) / f64::from(PLANES - 1);
    let depths: Vec<f64> = (0..PLANES).map(depth).collect();
    let mut planes = Planes::new(bodies, &depths)?;
    let (mut rows, mut largest, mut tension) = (Vec::new(), [0.0; 3], [0.0; 2]);
    planes.through(Body::One, loads, |plane| {
        for (ix, stress) in plane.stresses().enumerate() {
            let (x, von_mises, along) = (grid.x(ix) / a, stress.von_mises() / p0, stress.xx / p0);
            if von_mises > largest[0] {
                largest = [von_mises, x, plane.depth() / a];
            }
            if plane.depth() == 0.0 && along > tension[0] {
                tension = [along, x];
            }
        }
        rows.push(plane.map(|stress| stress.von_mises() / p0));
        Ok(())
    })?;
    let vti = support::gallery("fretting_rig.vti")?;
    planes.write_vti(&vti, Body::One, loads)?;
    println!("volume: {}", vti.display());
    println!(
        "\nAt the largest force, with the bulk stress: von Mises {:.3} p0 at x = {:.2} a, z = {:.2} a.",
        largest[0], largest[1], largest[2]
    );
    compare_tension(history, bodies, exact, (bulk, tension))?;
    Ok((rows, largest[0]))
}

/// Compares the largest tension, at the edge where a crack would start, with the closed form. The tension is computed for the
/// cells of the surface and for a plane at a depth of a fiftieth of a. The error on the surface decreases only with the square
/// root of the cell side.
fn compare_tension(
    history: &History,
    bodies: &HalfSpace,
    exact: &CattaneoMindlinLine,
    (bulk, [found, at]): (Stress, [f64; 2]),
) -> Result<(), Box<dyn Error>> {
    let (a, p0) = (exact.hertz().half_width(), exact.hertz().max_pressure());
    let [at_edge, _] = exact.surface_stress(-a);
    println!(
        "Largest tension of the surface: {found:.3} p0 in the cell at x = {at:.2} a; closed form at the edge: {:.3} p0.",
        at_edge / p0
    );
    let depth = 0.02 * a;
    let loads = Tractions::from(history).with_uniform_stress(bulk);
    let plane = Planes::new(bodies, &[depth])?.solve(0, Body::One, loads)?;
    let below = plane.stresses().map(|stress| stress.xx);
    let below = below.fold(0.0, f64::max);
    let cells = (0..history.grid().nx()).map(|ix| history.grid().x(ix));
    let exact = cells.map(|x| exact.stress(x, depth)[0][0]);
    let exact = exact.fold(0.0, f64::max);
    println!(
        "Largest tension at a depth of 0.02 a: {:.3} p0, closed form {:.3} p0.\n",
        below / p0,
        exact / p0
    );
    Ok(())
}

/// Von Mises stress divided by p0, plane by plane from the surface downwards.
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
    let title = "Cylinder on flat, Ti-6Al-4V, 200 N/mm, with bulk stress";
    let figure = support::figure(path, (2 * support::PANEL, 2300), title)?;
    let (curves, lower) = figure.split_vertically(1000);
    let (first, second) = curves.split_horizontally(support::PANEL);
    let first = support::heading(&first, "steady loop")?;
    let second = support::heading(&second, support::COMPARED)?;

    let shifts = points.iter().map(|[shift, _]| shift.abs());
    let span = 1.15 * shifts.fold(0.0, f64::max);
    let mut chart = support::axes(
        &first,
        (-span..span, "shift (µm)"),
        (-0.8..0.8, "tangential load / µP"),
    )?;
    let around = points.iter().chain(points.first()).map(|[x, y]| (*x, *y));
    chart.draw_series(LineSeries::new(around, support::stroke(support::BLUE)))?;

    let mut chart = support::axes(
        &second,
        (-1.2..1.2, "x / a"),
        (-0.1..1.6, "tractions at the largest load"),
    )?;
    let column = |k: usize| profile.iter().map(move |row| (row[0], row[k]));
    let in_sight = |(x, _): &(f64, f64)| x.abs() < 1.2;
    let every = (profile.len() / 64).max(1);
    let hertz = column(0).map(|(x, _)| (x, (1.0 - x * x).max(0.0).sqrt()));
    support::compare(
        &mut chart,
        "p / p₀",
        support::GREEN,
        hertz.filter(in_sight),
        column(1).step_by(every).filter(in_sight),
    )?;
    support::compare(
        &mut chart,
        "q / µp₀",
        support::ORANGE,
        column(3).filter(in_sight),
        column(2).step_by(every).filter(in_sight),
    )?;
    support::legend(&mut chart, SeriesLabelPosition::UpperLeft)?;

    let scale = maps::Scale::from_zero(maps::heat, map.largest).in_bands(0.1);
    let lower = support::heading(
        &lower,
        "below the surface of the specimen, at the largest load",
    )?;
    let lower = lower.margin(0, 0, 400, 0);
    let (x, depth) = (-map.reach..map.reach, Axis::depth(-DEPTH..0.0));
    let sides = [(Axis::linear(x), "x / a"), (depth, "depth / a")];
    let mut chart = maps::axes_and_bar_of(&lower, sides, (scale, "von Mises stress / p₀"))?;
    let (columns, planes) = (map.rows[0].len(), map.rows.len() - 1);
    let block = columns.div_ceil(128);
    let width = 2.0 * map.reach / columns as f64;
    let rectangles = (0..planes).flat_map(|k| {
        let level = |k: f64| (-DEPTH * k / planes as f64).max(-DEPTH);
        (0..columns).step_by(block).map(move |first| {
            let ends = [first, (first + block).min(columns)];
            let [left, right] = ends.map(|end| width * end as f64 - map.reach);
            let value = map.rows[k][first + (ends[1] - first) / 2];
            // Each block extends under the next blocks, which are drawn later, so that no seam is visible.
            let right = (right + 0.5 * (right - left)).min(map.reach);
            let corners = [(left, level(k as f64)), (right, level(k as f64 + 1.5))];
            Rectangle::new(corners, scale.colour(value).filled())
        })
    });
    chart.draw_series(rectangles)?;
    figure.present()?;
    Ok(())
}
