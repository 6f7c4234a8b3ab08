//! A rolling elliptic contact of steel: creep curves compared with CONTACT and closed forms, and stick and slip zones under
//! creepage and spin.
//!
//! `cargo run --release -p stickslip-examples --example creep_curves` prints the creep forces of CONTACT's example `tractcurv`
//! with and without the entry rule, and writes `target/gallery/creep_curves.csv` and `.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;
use stickslip::analytical::{HertzEllipse, VermeulenJohnson};
use stickslip::history::EntryRule;
use stickslip::rolling::{RollingControl, RollingProblem, RollingSolution, SpinControl};
use stickslip::{
    ElasticPair, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem, surface,
};

/// Normal load in N. The problem is `tractcurv`, which CONTACT solves on 48 x 44 cells, in mm, N and MPa.
const LOAD: f64 = 106_700.0;
const FRICTION: f64 = 0.33;
const CELLS: [usize; 2] = [48, 44];
const SIDES: [f64; 2] = [0.288_914_873_561_06, 0.630_359_724_763_98];
/// Radii of curvature along x and y.
const RADII: [f64; 2] = [625.0, 1_776.720_812_928_627_5];

/// Creepages, and the forces divided by the friction limit, as printed by CONTACT.
const CONTACT: [(f64, f64); 6] = [
    (4e-4, 0.2588),
    (8e-4, 0.4742),
    (12e-4, 0.6482),
    (16e-4, 0.7831),
    (20e-4, 0.8816),
    (24e-4, 0.9467),
];
/// Creepages along x and y and spin (1/mm) for the map of zones.
const COMBINED: ([f64; 2], f64) = ([6e-4, -4e-4], 1e-4);

fn main() -> Result<(), Box<dyn Error>> {
    let grids = [1, 2].map(|part: usize| CELLS.map(|cells| cells / part));
    let [fine, coarse] = grids;
    let whole = creep_curve(fine, EntryRule::WholeStep)?;
    let law = creep_curve(fine, EntryRule::SinceTouch)?;
    let half = creep_curve(coarse, EntryRule::SinceTouch)?;
    let hertz = HertzEllipse::new(&steel()?, RADII[0], RADII[1], LOAD)?;
    let closed_form = |xi: f64| -> stickslip::Result<f64> {
        let curve = VermeulenJohnson::new(hertz, FRICTION, [xi, 0.0])?;
        Ok(curve.force()[0] / (FRICTION * LOAD))
    };

    println!("creepage | CONTACT | no entry rule | entry rule | 24 x 22 | Vermeulen and Johnson");
    let csv = support::gallery("creep_curves.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    table.write_record([
        "creepage",
        "contact",
        "without_law",
        "law",
        "law_24x22",
        "closed_form",
    ])?;
    for (i, (xi, contact)) in CONTACT.into_iter().enumerate() {
        let row = [xi, contact, whole[i], law[i], half[i], closed_form(xi)?];
        println!(
            "{:>8.1e} | {:>7.4} | {:>13.4} | {:>10.4} | {:>7.4} | {:>7.4}",
            row[0], row[1], row[2], row[3], row[4], row[5]
        );
        table.serialize(row)?;
    }
    table.flush()?;

    let rolling = combined()?;
    println!(
        "\ncreepages {:?}, spin {:e}/mm: F/µP = {:.3?}, moment {:.0} N mm, stick ratio {:.3}",
        rolling.creepage(),
        rolling.spin(),
        rolling.force().map(|force| force / (FRICTION * LOAD)),
        rolling.moment(),
        rolling.stick_ratio(),
    );
    let svg = support::gallery("creep_curves.svg")?;
    let curve: stickslip::Result<Vec<_>> = (0..=60)
        .map(|i| f64::from(i) * 5e-5)
        .map(|xi| Ok((1e3 * xi, closed_form(xi)?)))
        .collect();
    draw(&svg, &rolling, &law, &curve?)?;
    println!("\ntable: {}\nfigure: {}", csv.display(), svg.display());
    Ok(())
}

fn steel() -> stickslip::Result<ElasticPair> {
    let steel = Material::from_shear_modulus(82e3, 0.28)?;
    ElasticPair::new(steel, steel)
}

/// Creates the rolling problem on a grid with the given numbers of cells and a fixed area.
fn problem(cells: [usize; 2], entry_rule: EntryRule) -> stickslip::Result<RollingProblem> {
    let [dx, dy] = [0, 1].map(|axis| SIDES[axis] * (CELLS[axis] / cells[axis]) as f64);
    let grid = Grid::new(cells[0], cells[1], dx, dy)?;
    let bodies = HalfSpace::new(grid, steel()?)?;
    let gap = surface::ellipsoid(grid, RADII[0], RADII[1])?;
    let normal = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(LOAD))
        .build()?
        .solve()?;
    RollingProblem::builder(&bodies, &normal, Friction::coulomb(FRICTION)?)
        .entry_rule(entry_rule)
        .build()
}

/// Computes the force divided by the friction limit at each creepage of CONTACT.
fn creep_curve(cells: [usize; 2], entry_rule: EntryRule) -> stickslip::Result<Vec<f64>> {
    let mut solver = problem(cells, entry_rule)?.into_solver()?;
    let mut rolling = solver.new_solution();
    let mut force = |(xi, _): (f64, f64)| {
        solver.set_load(
            [xi, 0.0].map(RollingControl::Creepage),
            SpinControl::Spin(0.0),
        )?;
        solver.solve_into(&mut rolling)?;
        Ok(rolling.force()[0] / (FRICTION * LOAD))
    };
    CONTACT.into_iter().map(&mut force).collect()
}

/// Solves rolling with both creepages and spin.
fn combined() -> stickslip::Result<RollingSolution> {
    let mut solver = problem(CELLS, EntryRule::SinceTouch)?.into_solver()?;
    let mut rolling = solver.new_solution();
    solver.set_load(
        COMBINED.0.map(RollingControl::Creepage),
        SpinControl::Spin(COMBINED.1),
    )?;
    solver.solve_into(&mut rolling)?;
    Ok(rolling)
}

fn draw(
    path: &Path,
    rolling: &RollingSolution,
    law: &[f64],
    closed_form: &[(f64, f64)],
) -> Result<(), Box<dyn Error>> {
    let title = "Elliptical steel contact that rolls towards positive x";
    let figure = support::figure(path, (2400, support::TITLE + 1200), title)?;
    let (left, right) = figure.split_horizontally(960);

    let left = support::heading(&left, "with spin; lines: traction")?;
    let left = support::key(&left, &support::maps::zones_key(rolling.zones()))?;
    let right = support::heading(&right, "creepage along x alone")?;
    let reach = [0, 1].map(|axis| 0.5 * SIDES[axis] * CELLS[axis] as f64);
    let sight = reach.map(|reach| -reach..reach);
    let [x, y] = sight.clone();
    let mut chart = support::map_axes(&left, (x, "x (mm)"), (y, "y (mm)"))?;
    support::maps::zones(&mut chart, rolling.grid(), rolling.zones(), 1.0, sight)?;
    tractions(&mut chart, rolling)?;

    let mut chart = support::axes(
        &right,
        (0.0..3.0, "creepage ξ (10⁻³)"),
        (0.0..1.05, "F / µP"),
    )?;
    support::law(
        &mut chart,
        "Vermeulen and Johnson",
        true,
        closed_form.iter().copied(),
    )?;
    let points = |values: &mut dyn Iterator<Item = (f64, f64)>| -> Vec<_> {
        values.map(|(xi, force)| (1e3 * xi, force)).collect()
    };
    let contact = points(&mut CONTACT.into_iter());
    let ours = points(&mut CONTACT.iter().map(|(xi, _)| *xi).zip(law.iter().copied()));
    support::dots(
        &mut chart,
        "CONTACT; no entry rule",
        (support::ORANGE, false),
        contact,
    )?;
    support::dots(
        &mut chart,
        "with the entry rule",
        (support::BLUE, true),
        ours,
    )?;
    support::legend(&mut chart, SeriesLabelPosition::LowerRight)?;
    figure.present()?;
    Ok(())
}

/// Returns arrows for the tractions on body 1. Each arrow starts at the centre of its cell.
fn tractions(
    chart: &mut support::Chart<'_>,
    rolling: &RollingSolution,
) -> Result<(), Box<dyn Error>> {
    let (grid, [x, y]) = (rolling.grid(), rolling.traction());
    let sizes = x
        .as_slice()
        .iter()
        .zip(y.as_slice())
        .map(|(x, y)| x.hypot(*y));
    let largest = sizes.fold(0.0, f64::max);
    let every = [6, 3];
    let length = 1.2 * every[0] as f64 * grid.dx();
    for iy in (every[1] / 2..grid.ny()).step_by(every[1]) {
        for ix in (every[0] / 2..grid.nx()).step_by(every[0]) {
            let traction = [x, y].map(|field| field.get(ix, iy).unwrap_or_default() / largest);
            if traction[0].hypot(traction[1]) < 1e-3 {
                continue;
            }
            let from = (grid.x(ix), grid.y(iy));
            let to = (from.0 + length * traction[0], from.1 + length * traction[1]);
            chart.draw_series([PathElement::new([from, to], support::stroke(BLACK))])?;
            chart.draw_series([Circle::new(from, 8, BLACK.filled())])?;
        }
    }
    Ok(())
}
