//! A steel ball on steel under a normal and then a tangential load (Table 2 of the paper), compared with the closed
//! forms.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

#[path = "../support/mod.rs"]
mod support;

use std::error::Error;
use std::f64::consts::TAU;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use stickslip::analytical::{CattaneoMindlin, HertzSphere};
use stickslip::{
    ElasticPair, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem, NormalSolution,
    TangentialLoad, TangentialProblem, TangentialSolution, surface,
};
use support::Area;

// SI units: metres, newtons, pascals.
const BALL_RADIUS: f64 = 3.5e-3;
const NORMAL_FORCE: f64 = 100.0;
const TANGENTIAL_FORCE: f64 = 20.0;
const FRICTION: f64 = 0.5;
const CELLS: usize = 512;

/// Half-width of the view, in contact radii.
const VIEW: f64 = 1.25;

fn main() -> Result<(), Box<dyn Error>> {
    let steel = Material::new(213e9, 0.29)?;
    let pair = ElasticPair::new(steel, steel)?;
    let hertz = HertzSphere::new(&pair, BALL_RADIUS, NORMAL_FORCE)?;
    let exact = CattaneoMindlin::new(hertz, FRICTION, TANGENTIAL_FORCE)?;

    let grid = Grid::square(CELLS, 3.0 * hertz.contact_radius())?;
    let bodies = HalfSpace::new(grid, pair)?;
    let ball = surface::sphere(grid, BALL_RADIUS)?;
    let normal = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(NORMAL_FORCE))
        .build()?
        .solve()?;
    let friction = Friction::coulomb(FRICTION)?;
    let load = TangentialLoad::force([TANGENTIAL_FORCE, 0.0]);
    let tangential = TangentialProblem::builder(&bodies, &normal, friction, load)
        .build()?
        .solve()?;

    print_table(&normal, &tangential, &exact);
    println!("\nnormal:     {}", normal.report());
    println!("tangential: {}", tangential.report());
    for warning in normal.warnings().iter().chain(&tangential.warnings()) {
        println!("warning: {warning}");
    }

    let path = support::gallery("sphere.svg")?;
    let title = "Steel ball on steel: R = 3.5 mm, W = 100 N, F = 20 N, friction 0.5";
    let figure = support::figure(&path, (2 * support::PANEL, 1538), title)?;
    let (left, right) = figure.split_horizontally(support::PANEL);
    draw_profiles(&left, &normal, &tangential, &exact)?;
    draw_zones(&right, &tangential, &exact)?;
    figure.present()?;
    println!("\nfigure: {}", path.display());
    Ok(())
}

fn print_table(normal: &NormalSolution, tangential: &TangentialSolution, exact: &CattaneoMindlin) {
    let hertz = exact.hertz();
    let mega = 1e-6;
    let micro = 1e6;
    let rows = [
        (
            "largest pressure (MPa)",
            normal.pressure().max() * mega,
            hertz.max_pressure() * mega,
        ),
        (
            "approach (µm)",
            normal.approach() * micro,
            hertz.approach() * micro,
        ),
        (
            "contact area (µm²)",
            normal.contact_area_corrected() * micro * micro,
            hertz.contact_area() * micro * micro,
        ),
        (
            "shift (µm)",
            tangential.shift()[0] * micro,
            exact.shift() * micro,
        ),
        ("stick ratio", tangential.stick_ratio(), exact.stick_ratio()),
        (
            "largest traction (MPa)",
            tangential.traction()[0].max() * mega,
            exact.traction(exact.stick_radius()) * mega,
        ),
        (
            "dissipated energy (µJ)",
            tangential.dissipated_energy() * micro,
            exact.energy_of_first_quarter() * micro,
        ),
    ];
    println!(
        "{:<26} | {:>12} | {:>12} | relative difference",
        "quantity", "computed", "closed form"
    );
    for (quantity, computed, closed_form) in rows {
        let difference = computed / closed_form - 1.0;
        println!("{quantity:<26} | {computed:>12.6} | {closed_form:>12.6} | {difference:>19.1e}");
    }
}

/// Draws pressure and traction along the row of cells nearest to the x axis.
fn draw_profiles(
    area: &Area<'_>,
    normal: &NormalSolution,
    tangential: &TangentialSolution,
    exact: &CattaneoMindlin,
) -> Result<(), Box<dyn Error>> {
    let hertz = exact.hertz();
    let a = hertz.contact_radius();
    let grid = normal.pressure().grid();
    let row = grid.ny() / 2;
    let line = |f: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        (-500..=500)
            .map(|i| VIEW * f64::from(i) / 500.0)
            .map(|x| (x, f((x * a).hypot(grid.y(row)))))
            .collect()
    };
    // Only every sixth cell is drawn, so that the points do not hide the lines.
    let points = |field: &stickslip::Field, scale: f64| -> Vec<(f64, f64)> {
        (0..grid.nx())
            .step_by(6)
            .filter_map(|ix| Some((grid.x(ix) / a, field.get(ix, row)? / scale)))
            .filter(|(x, _)| x.abs() <= VIEW)
            .collect()
    };
    let pressure_scale = hertz.max_pressure();
    let shear_scale = FRICTION * pressure_scale;

    let area = support::heading(area, support::COMPARED)?;
    let mut chart = support::axes(
        &area,
        (-VIEW..VIEW, "x / a"),
        (0.0..1.1, "p / p₀ and q / µp₀"),
    )?;
    support::compare(
        &mut chart,
        "pressure p",
        support::BLUE,
        line(&|r| hertz.pressure(r) / pressure_scale),
        points(normal.pressure(), pressure_scale),
    )?;
    support::compare(
        &mut chart,
        "traction q",
        support::ORANGE,
        line(&|r| exact.traction(r) / shear_scale),
        points(tangential.traction()[0], shear_scale),
    )?;
    support::legend(&mut chart, SeriesLabelPosition::MiddleMiddle)
}

/// Draws the map of stick and slip, and the circles that bound the two zones in the closed form.
fn draw_zones(
    area: &Area<'_>,
    tangential: &TangentialSolution,
    exact: &CattaneoMindlin,
) -> Result<(), Box<dyn Error>> {
    let a = exact.hertz().contact_radius();
    let area = support::heading(area, "zones; circles: closed form")?;
    let mut chart = support::map_axes(&area, (-VIEW..VIEW, "x / a"), (-VIEW..VIEW, "y / a"))?;
    support::maps::zones(
        &mut chart,
        tangential.grid(),
        tangential.zones(),
        a,
        [-VIEW..VIEW, -VIEW..VIEW],
    )?;

    let circle = |radius: f64| -> Vec<(f64, f64)> {
        (0..=180)
            .map(|i| TAU * f64::from(i) / 180.0)
            .map(|angle| (radius * angle.cos() / a, radius * angle.sin() / a))
            .collect()
    };
    for radius in [a, exact.stick_radius()] {
        chart.draw_series(LineSeries::new(circle(radius), BLACK.stroke_width(4)))?;
    }
    let ring = 0.5 * (1.0 + exact.stick_radius() / a);
    let names = [
        ("stick", 0.0, &WHITE),
        ("slip", -ring, &BLACK),
        ("no contact", -1.12, &BLACK),
    ];
    for (name, y, colour) in names {
        let style = ("sans-serif", support::LETTERS).into_font().color(colour);
        let style = style.pos(Pos::new(HPos::Center, VPos::Center));
        chart.draw_series([Text::new(name, (0.0, y), style)])?;
    }
    Ok(())
}
