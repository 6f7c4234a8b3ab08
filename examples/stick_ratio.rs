//! Stick ratio of a rough contact as a function of the tangential load, for four surfaces from zero load to sliding,
//! compared with the straight line 1 - F / mu W and the curve of a smooth ball. Maps show the stick and slip zones of
//! magnified spots (the paper's Figs 24 to 26).
//!
//! `cargo run --release -p stickslip-examples --example stick_ratio [cells]` (default 512, at least 128)
//! writes `target/gallery/stick_ratio.csv` and `.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::path::Path;

use plotters::prelude::SeriesLabelPosition;
use rayon::prelude::*;
use stickslip::surface::{self, SelfAffine};
use stickslip::{
    Boundary, ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
    NormalSolution, TangentialLoad, TangentialProblem, TangentialSolution,
};
use support::Area;

// Micrometres, megapascals, micronewtons.
const SIDE: f64 = 100.0;
/// Shortest wavelength, eight cells of the default grid.
const CUT_OFF: f64 = 8.0 * SIDE / 512.0;
const FRICTION: f64 = 0.5;
const STEPS: u32 = 10;
const TOLERANCE: f64 = 1e-6;
/// Width of the magnified part, in cells.
const MAGNIFIED: usize = 72;

/// Surface and the load that presses it.
struct PressedBody {
    rms_slope: f64,
    roll_off: f64,
    /// Mean pressure divided by the contact modulus.
    mean_pressure: f64,
}

const SCENES: [PressedBody; 4] = [
    PressedBody {
        rms_slope: 0.1,
        roll_off: 50.0,
        mean_pressure: 1e-3,
    },
    PressedBody {
        rms_slope: 0.2,
        roll_off: 25.0,
        mean_pressure: 5e-3,
    },
    PressedBody {
        rms_slope: 0.4,
        roll_off: 12.5,
        mean_pressure: 20e-3,
    },
    PressedBody {
        rms_slope: 0.8,
        roll_off: 6.25,
        mean_pressure: 10e-3,
    },
];

/// Results for a surface along its load path.
struct Sheared {
    normal: NormalSolution,
    /// Solution at half of the sliding force.
    half: TangentialSolution,
    /// Pairs of F / mu W and the stick ratio.
    ratios: Vec<[f64; 2]>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let cells = std::env::args()
        .nth(1)
        .map_or(Ok(512), |cells| cells.parse())?;
    // The paper's rubber on a rigid plane: E* = 25 MPa. The half-spaces are periodic, because the pressure would vary near free
    // edges.
    let pair = ElasticPair::new(Material::new(18.75, 0.5)?, Material::rigid())?;
    let grid = Grid::square(cells, SIDE)?;
    let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic)?;
    let seeded: Vec<_> = (0..).zip(&SCENES).collect();
    let contacts = seeded
        .par_iter()
        .map(|(seed, scene)| shear(&bodies, scene, *seed))
        .collect::<stickslip::Result<Vec<_>>>()?;

    print_table(&contacts)?;
    let header = [
        "surface",
        "load_ratio",
        "stick_ratio",
        "straight_line",
        "ball",
    ];
    let rows = contacts.iter().enumerate().flat_map(|(i, contact)| {
        let row = move |&[f, stick]: &[f64; 2]| [i as f64, f, stick, 1.0 - f, ball(f)];
        contact.ratios.iter().map(row)
    });
    let csv = support::gallery("stick_ratio.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    table.write_record(header)?;
    for row in rows {
        table.serialize(row)?;
    }
    table.flush()?;
    let svg = support::gallery("stick_ratio.svg")?;
    draw(&svg, &contacts)?;
    println!("\ntable: {}\nfigure: {}", csv.display(), svg.display());
    Ok(())
}

/// Presses a surface and shears it in steps. Each step starts from the last solution.
fn shear(bodies: &HalfSpace, scene: &PressedBody, seed: u64) -> stickslip::Result<Sheared> {
    let grid = bodies.grid();
    let rough = SelfAffine::with_rms_slope(scene.rms_slope)
        .roll_off_wavelength(scene.roll_off)
        .cut_off_wavelength(CUT_OFF)
        .seed(seed)
        .generate(grid)?;
    let gap = surface::gap_from_heights(rough.heights())?;
    let force = scene.mean_pressure * bodies.pair().contact_modulus() * grid.area();
    let normal = NormalProblem::builder(bodies, &gap, NormalLoad::Force(force))
        .tolerance(TOLERANCE)
        .build()?
        .solve()?;

    let friction = Friction::coulomb(FRICTION)?;
    let none = TangentialLoad::force([0.0, 0.0]);
    let mut solver = TangentialProblem::builder(bodies, &normal, friction, none)
        .tolerance(TOLERANCE)
        .build()?
        .into_solver()?;
    let mut solution = solver.new_solution();
    let mut half = solution.clone();
    let mut ratios = Vec::new();
    for step in 0..=STEPS {
        let f = f64::from(step) / f64::from(STEPS);
        solver.set_load(TangentialLoad::force([f * solver.friction_capacity(), 0.0]))?;
        solver.solve_into(&mut solution)?;
        ratios.push([f, solution.stick_ratio()]);
        if 2 * step == STEPS {
            half.clone_from(&solution);
        }
    }
    Ok(Sheared {
        normal,
        half,
        ratios,
    })
}

/// Returns the stick ratio of a smooth ball (eq 28).
fn ball(f: f64) -> f64 {
    (1.0 - f).powf(2.0 / 3.0)
}

fn print_table(contacts: &[Sheared]) -> stickslip::Result<()> {
    println!("surface | contact cells | spots | area (%) | F / mu W: stick ratio - (1 - F / mu W)");
    for (i, contact) in contacts.iter().enumerate() {
        let normal = &contact.normal;
        print!(
            "{:>7} | {:>13} | {:>5} | {:>8.2} |",
            i + 1,
            normal.contact_cells(),
            normal.spots()?.as_slice().len(),
            100.0 * normal.contact_area() / normal.grid().area()
        );
        for [f, stick] in &contact.ratios {
            print!(" {f:.1}: {:+.3}", stick - (1.0 - f));
        }
        println!();
    }
    Ok(())
}

fn draw(path: &Path, contacts: &[Sheared]) -> Result<(), Box<dyn Error>> {
    let title = "Stick ratio of rough contacts, and zones at F = µW / 2";
    let figure = support::figure(path, (2 * support::PANEL, 1540), title)?;
    let (left, right) = figure.split_horizontally(support::PANEL);
    let right = support::key(&right, &support::maps::zones_key(contacts[2].half.zones()))?;
    draw_ratios(&left, contacts)?;
    draw_zones(&right, &contacts[2])?;
    figure.present()?;
    Ok(())
}

fn draw_ratios(area: &Area<'_>, contacts: &[Sheared]) -> Result<(), Box<dyn Error>> {
    let mut chart = support::axes(area, (0.0..1.0, "F / µW"), (0.0..1.4, "stick ratio"))?;
    let loads = || (0..=100).map(|i| f64::from(i) / 100.0);
    let straight = [(0.0, 1.0), (1.0, 0.0)];
    support::law(&mut chart, "1 − F / µW", true, straight)?;
    support::law(
        &mut chart,
        "smooth ball",
        false,
        loads().map(|f| (f, ball(f))),
    )?;
    let colours = [
        support::BLUE,
        support::ORANGE,
        support::GREEN,
        support::PURPLE,
    ];
    for ((contact, colour), scene) in contacts.iter().zip(colours).zip(&SCENES) {
        let name = format!(
            "slope {}, p / E* = {}",
            scene.rms_slope, scene.mean_pressure
        );
        let points = contact.ratios.iter().map(|&[f, stick]| (f, stick));
        support::dots(&mut chart, &name, (colour, false), points)?;
    }
    support::legend(&mut chart, SeriesLabelPosition::UpperRight)
}

/// Draws the square of [`MAGNIFIED`] x [`MAGNIFIED`] cells with the largest number of contact cells.
fn draw_zones(area: &Area<'_>, contact: &Sheared) -> Result<(), Box<dyn Error>> {
    let [column, row] = most_crowded(contact.normal.pressure());
    let grid = contact.normal.grid();
    let x = grid.x(column) - 0.5 * grid.dx();
    let y = grid.y(row) - 0.5 * grid.dy();
    let [x, y] = [(x, grid.dx()), (y, grid.dy())]
        .map(|(start, cell)| start..start + MAGNIFIED as f64 * cell);
    let names = ("x (µm)", "y (µm)");
    let mut chart = support::map_axes(area, (x.clone(), names.0), (y.clone(), names.1))?;
    support::maps::zones(
        &mut chart,
        contact.half.grid(),
        contact.half.zones(),
        1.0,
        [x, y],
    )
}

/// Returns the first column and row of the square of [`MAGNIFIED`] x [`MAGNIFIED`] cells with the largest number of
/// contact cells.
fn most_crowded(pressure: &Field) -> [usize; 2] {
    let grid = pressure.grid();
    let touching = |column: usize, row: usize| {
        let rows = pressure.rows().skip(row).take(MAGNIFIED);
        let cells = rows.flat_map(|cells| &cells[column..column + MAGNIFIED]);
        cells.filter(|&&p| p > 0.0).count()
    };
    let corners = |cells: usize| (0..=cells - MAGNIFIED).step_by(8);
    let squares =
        corners(grid.ny()).flat_map(|row| corners(grid.nx()).map(move |column| [column, row]));
    squares
        .max_by_key(|&[column, row]| touching(column, row))
        .unwrap_or_default()
}
