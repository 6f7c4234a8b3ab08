//! Real area of contact of a rough ball on a plane as a function of the reduced pressure, for three rms heights of
//! equal slope, compared with Mueser's curve (the paper's Fig 14 and Table 3).
//!
//! `cargo run --release -p stickslip-examples --example rough_sphere [cells]` (default 640, at least 200)
//! writes `target/gallery/rough_sphere.csv` and `.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::path::Path;

use plotters::prelude::SeriesLabelPosition;
use rayon::prelude::*;
use stickslip::analytical::{HertzSphere, RoughSphere};
use stickslip::surface::{self, SelfAffine};
use stickslip::{ElasticPair, Grid, HalfSpace, Material, NormalLoad, NormalProblem, Warning};

// Micrometres, megapascals, micronewtons.
const SIDE: f64 = 640.0;
const RADIUS: f64 = 3500.0;
const SLOPE: f64 = 0.7518;
/// Shortest wavelength, more than six cells of the default grid. Shorter waves would not be resolved.
const CUT_OFF: f64 = 6.4;
/// Roll-off wavelengths, which determine the height at constant slope.
const ROLL_OFFS: [f64; 3] = [192.0, 112.0, 64.0];
const SEEDS: usize = 4;
/// The paper's four loads, with an additional load between each pair.
const LOADS: [f64; 7] = [0.15e3, 0.5e3, 1.5e3, 5e3, 15e3, 50e3, 150e3];
/// Number of contact cells above which the corrected area is within 10 % of the law.
const RESOLVED: usize = 600;
/// Tolerance, far below the discretisation error.
const TOLERANCE: f64 = 1e-5;

fn main() -> Result<(), Box<dyn Error>> {
    let cells = std::env::args()
        .nth(1)
        .map_or(Ok(640), |cells| cells.parse())?;
    // The contact modulus is E / (1 - nu^2) = 25 MPa, on a rigid plane.
    let pair = ElasticPair::new(Material::new(18.75, 0.5)?, Material::rigid())?;
    let bodies = HalfSpace::new(Grid::square(cells, SIDE)?, pair)?;
    let kinds = 0..ROLL_OFFS.len();
    let jobs: Vec<_> = kinds
        .flat_map(|kind| (0..SEEDS).map(move |seed| (kind, seed as u64)))
        .collect();
    let balls = jobs
        .par_iter()
        .map(|&(kind, seed)| press(&bodies, kind, seed))
        .collect::<stickslip::Result<Vec<_>>>()?;

    print_table(&balls);
    let header = [
        "rms_height_um",
        "load_uN",
        "reduced_pressure",
        "cells_in_contact",
        "cells_at_edge",
        "area_by_counting",
        "area_corrected",
        "mueser",
    ];
    let rows = balls
        .iter()
        .flat_map(|ball| ball.contacts.iter().map(|c| c.row(ball)));
    let csv = support::gallery("rough_sphere.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    table.write_record(header)?;
    for row in rows {
        table.serialize(row)?;
    }
    table.flush()?;
    let svg = support::gallery("rough_sphere.svg")?;
    draw(&svg, &balls)?;
    println!("\ntable: {}\nfigure: {}", csv.display(), svg.display());
    Ok(())
}

/// Rough ball under all loads.
struct Ball {
    /// Index of the roll-off of the surface.
    kind: usize,
    rms_height: f64,
    contacts: Vec<Contact>,
}

/// Function that selects an area of a contact.
type AreaOf = fn(&Contact) -> f64;

/// Results of a contact. Areas are fractions of the contact area of the smooth ball.
struct Contact {
    hertz: RoughSphere,
    cells: usize,
    cells_at_edge: usize,
    counted: f64,
    corrected: f64,
}

impl Contact {
    fn row(&self, ball: &Ball) -> [f64; 8] {
        [
            ball.rms_height,
            self.hertz.hertz().load(),
            self.hertz.reduced_pressure(),
            self.cells as f64,
            self.cells_at_edge as f64,
            self.counted,
            self.corrected,
            self.hertz.relative_contact_area(),
        ]
    }
}

fn press(bodies: &HalfSpace, kind: usize, seed: u64) -> stickslip::Result<Ball> {
    let grid = bodies.grid();
    let roughness = SelfAffine::with_rms_slope(SLOPE)
        .roll_off_wavelength(ROLL_OFFS[kind])
        .cut_off_wavelength(CUT_OFF)
        .seed(seed)
        .generate(grid)?;
    let smooth = surface::sphere(grid, RADIUS)?;
    let gap = surface::sum(&[&smooth, &surface::inverted(roughness.heights())])?;
    let mut solver = NormalProblem::builder(bodies, &gap, NormalLoad::Force(LOADS[0]))
        .tolerance(TOLERANCE)
        .build()?
        .into_solver()?;
    let mut solution = solver.new_solution();
    let mut contacts = Vec::new();
    for load in LOADS {
        solver.set_load(NormalLoad::Force(load))?;
        solver.solve_into(&mut solution)?;
        let hertz = HertzSphere::new(bodies.pair(), RADIUS, load)?;
        let at_edge = |warning: &Warning| match warning {
            Warning::ContactAtEdge { cells } => *cells,
            _ => 0,
        };
        contacts.push(Contact {
            hertz: RoughSphere::new(hertz, SLOPE)?,
            cells: solution.contact_cells(),
            cells_at_edge: solution.warnings().iter().map(at_edge).sum(),
            counted: solution.contact_area() / hertz.contact_area(),
            corrected: solution.contact_area_corrected() / hertz.contact_area(),
        });
    }
    Ok(Ball {
        kind,
        rms_height: roughness.rms_height(),
        contacts,
    })
}

/// Prints the means over the seeds.
fn print_table(balls: &[Ball]) {
    println!(
        "area / area of Mueser's law, mean of {SEEDS} surfaces: counted, and with the perimeter corrected"
    );
    print!("{:>9} {:>9} {:>7}", "load (mN)", "P", "cells");
    for ball in balls.iter().step_by(SEEDS) {
        print!(" | rms {:>5.2} µm ", ball.rms_height);
    }
    println!();
    for (i, load) in LOADS.iter().enumerate() {
        let contacts = |kind: usize| {
            let alike = balls.iter().filter(move |ball| ball.kind == kind);
            alike.map(|ball| &ball.contacts[i]).collect::<Vec<_>>()
        };
        let all: Vec<&Contact> = balls.iter().map(|ball| &ball.contacts[i]).collect();
        let cells = mean(&all, |contact| contact.cells as f64);
        let pressure = all[0].hertz.reduced_pressure();
        print!("{:>9.2} {pressure:>9.5} {cells:>7.0}", load / 1e3);
        for kind in 0..ROLL_OFFS.len() {
            let areas: [AreaOf; 2] = [|c| c.counted, |c| c.corrected];
            let [counted, corrected] = areas.map(|area| {
                mean(&contacts(kind), |c| {
                    area(c) / c.hertz.relative_contact_area()
                })
            });
            print!(" | {counted:>6.3} {corrected:>6.3}");
        }
        println!();
    }
}

fn mean(contacts: &[&Contact], of: impl Fn(&Contact) -> f64) -> f64 {
    contacts.iter().map(|contact| of(contact)).sum::<f64>() / contacts.len() as f64
}

fn draw(path: &Path, balls: &[Ball]) -> Result<(), Box<dyn Error>> {
    let title = "Rough ball on a plane, rms slope 0.75, four surfaces per rms height";
    let figure = support::figure(path, (2 * support::PANEL, 1500), title)?;
    let halves = figure.split_evenly((1, 2));
    let colours = [support::BLUE, support::ORANGE, support::GREEN];
    let areas: [(&str, AreaOf); 2] = [
        ("area / Hertz area, counted", |c| c.counted),
        ("area / Hertz area, corrected", |c| c.corrected),
    ];
    for (number, (half, (name, area))) in halves.iter().zip(areas).enumerate() {
        let mut chart = support::decades(
            half,
            (-2.5..-1.3, "reduced pressure W / (π a² E* g)"),
            (-2.2..-0.5, name),
        )?;
        let curve = |k: f64| {
            let pressures = (0..=60).map(|i| -2.5 + 1.2 * f64::from(i) / 60.0);
            pressures
                .map(|p| Ok((p, RoughSphere::area_law(10_f64.powf(p), k)?.log10())))
                .collect::<stickslip::Result<Vec<_>>>()
        };
        support::law(
            &mut chart,
            "Mueser, k = 2",
            true,
            curve(RoughSphere::AREA_COEFFICIENT)?,
        )?;
        for (kind, colour) in colours.into_iter().enumerate() {
            let alike = || balls.iter().filter(|ball| ball.kind == kind);
            let height = alike().map(|ball| ball.rms_height).sum::<f64>() / SEEDS as f64;
            for is_resolved in [true, false] {
                let points = alike()
                    .flat_map(|ball| &ball.contacts)
                    .filter(|c| (c.cells >= RESOLVED) == is_resolved)
                    .map(|c| (c.hertz.reduced_pressure().log10(), area(c).log10()));
                let name = if is_resolved {
                    format!("rms height {height:.1} µm")
                } else {
                    format!("{height:.1} µm, < {RESOLVED} cells")
                };
                support::dots(&mut chart, &name, (colour, is_resolved), points)?;
            }
        }
        if number == 0 {
            support::legend(&mut chart, SeriesLabelPosition::UpperLeft)?;
        }
    }
    figure.present()?;
    Ok(())
}
