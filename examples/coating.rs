//! Two equal spheres with coatings that are softer or harder than the spheres, pressed and sheared. The example compares pressure
//! and contact radius with an axisymmetric solution. It also computes the traction, the stick zone, and the von Mises stress
//! above and below the interface.
//!
//! `cargo run --release -p stickslip-examples --example coating` prints the comparison and writes `target/gallery/coating.csv`
//! and `.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;
use stickslip::analytical::HertzSphere;
use stickslip::layers::Layer;
use stickslip::subsurface::{Body, Planes};
use stickslip::{
    ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
    NormalSolution, TangentialLoad, TangentialProblem, TangentialSolution, surface,
};

/// Young's modulus of steel, radius of the gap, and load, in mm, N and MPa.
const MODULUS: f64 = 210e3;
const POISSON_RATIO: f64 = 0.3;
const RADIUS: f64 = 10.0;
const LOAD: f64 = 100.0;
const FRICTION: f64 = 0.3;
/// Tangential force divided by the sliding force.
const LOADING: f64 = 0.5;
const CELLS: usize = 128;

/// Ratio of the moduli of coating and body, with the axisymmetric solution for a coating whose thickness is half the contact
/// radius `a0` without coating. The solution consists of the contact radius divided by `a0`, and of the central pressure and
/// the approach divided by their values without coating.
const COATINGS: [(f64, [f64; 3]); 5] = [
    (0.25, [1.330897, 0.634832, 1.319233]),
    (0.5, [1.149909, 0.807562, 1.127525]),
    (1.0, [1.0, 1.0, 1.0]),
    (2.0, [0.869692, 1.228033, 0.910205]),
    (4.0, [0.745816, 1.574471, 0.836737]),
];
const COLOURS: [RGBColor; 5] = [
    support::PURPLE,
    support::BLUE,
    BLACK,
    support::GREEN,
    support::ORANGE,
];

/// Number of depth steps above the interface. Below the interface the same number of steps spans three times the distance.
const DEPTHS: usize = 20;

/// Contact of coated spheres.
struct Contact {
    normal: NormalSolution,
    sheared: TangentialSolution,
    /// Depth and von Mises stress on the axis, above and below the interface.
    stress: [Vec<(f64, f64)>; 2],
}

fn main() -> Result<(), Box<dyn Error>> {
    let steel = Material::new(MODULUS, POISSON_RATIO)?;
    let hertz = HertzSphere::new(&ElasticPair::new(steel, steel)?, RADIUS, LOAD)?;
    let thickness = 0.5 * hertz.contact_radius();

    println!(
        "E1/E2 | radius a/a0   (exact) | pressure p/p0   (exact) | approach  (exact) | shift | stick ratio"
    );
    let path = support::gallery("coating.csv")?;
    let mut table = csv::Writer::from_path(&path)?;
    table.write_record([
        "ratio",
        "radius",
        "pressure",
        "approach",
        "shift",
        "stick_ratio",
    ])?;
    let mut contacts = Vec::new();
    let mut bare_shift = None;
    for (ratio, _) in [COATINGS[2]].iter().chain(&COATINGS) {
        let layer = Layer::new(ratio * MODULUS, POISSON_RATIO, thickness)?;
        let contact = solve(steel.coated(&[layer])?, &hertz)?;
        let shift = contact.sheared.shift()[0];
        let bare = *bare_shift.get_or_insert(shift);
        contacts.push((contact, shift / bare));
    }
    let contacts = contacts.split_off(1);
    for ((ratio, exact), (contact, shift)) in COATINGS.iter().zip(&contacts) {
        let area = contact.normal.edges()?.area();
        let radius = (area / std::f64::consts::PI).sqrt() / hertz.contact_radius();
        let pressure = contact.normal.pressure().max() / hertz.max_pressure();
        let approach = contact.normal.approach() / hertz.approach();
        let stick_ratio = contact.sheared.stick_ratio();
        println!(
            "{ratio:>5} | {radius:>12.5} ({:.5}) | {pressure:>14.5} ({:.5}) | {approach:.5} ({:.5}) | {shift:.4} | {stick_ratio:.4}",
            exact[0], exact[1], exact[2],
        );
        table.serialize((ratio, radius, pressure, approach, shift, stick_ratio))?;
    }
    table.flush()?;
    let svg = support::gallery("coating.svg")?;
    draw(&svg, &contacts, &hertz)?;
    println!("\nE1/E2 | largest von Mises stress / p0, in the coating | below it");
    for ((ratio, _), (contact, _)) in COATINGS.iter().zip(&contacts) {
        let [above, below] = contact.stress.each_ref().map(|line| {
            let most = line.iter().map(|(_, stress)| *stress).fold(0.0, f64::max);
            most / hertz.max_pressure()
        });
        println!("{ratio:>5} | {above:>47.4} | {below:.4}");
    }
    println!("\ntable: {}\nfigure: {}", path.display(), svg.display());
    Ok(())
}

/// Solves the contact. Both bodies have the coating, so that pressure and shear are uncoupled.
fn solve(coated: Material, hertz: &HertzSphere) -> stickslip::Result<Contact> {
    let grid = Grid::square(CELLS, 3.2 * hertz.contact_radius())?;
    let bodies = HalfSpace::new(grid, ElasticPair::new(coated, coated)?)?;
    let gap = surface::sphere(grid, RADIUS)?;
    let normal = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(LOAD))
        .build()?
        .solve()?;
    let friction = Friction::coulomb(FRICTION)?;
    let load = TangentialLoad::force([LOADING * FRICTION * LOAD, 0.0]);
    let sheared = TangentialProblem::builder(&bodies, &normal, friction, load)
        .build()?
        .solve()?;
    let thickness = coated.layers()[0].thickness();
    let part = |n: usize| n as f64 / DEPTHS as f64;
    let above: Vec<f64> = (0..=DEPTHS).map(|n| thickness * part(n)).collect();
    // The first point is just below the interface.
    let next = f64::from_bits(thickness.to_bits() + 1);
    let below: Vec<f64> = (0..=DEPTHS)
        .map(|n| next + 3.0 * thickness * part(n))
        .collect();
    let stress = |depths: &[f64]| {
        let mut line = Vec::new();
        let mut planes = Planes::new(&bodies, depths)?;
        planes.through(Body::One, (&normal, &sheared), |plane| {
            let middle = plane.get(CELLS / 2, CELLS / 2).unwrap_or_default();
            line.push((plane.depth(), middle.von_mises()));
            Ok(())
        })?;
        Ok::<_, stickslip::Error>(line)
    };
    let stress = [stress(&above)?, stress(&below)?];
    Ok(Contact {
        normal,
        sheared,
        stress,
    })
}

fn draw(
    path: &Path,
    contacts: &[(Contact, f64)],
    hertz: &HertzSphere,
) -> Result<(), Box<dyn Error>> {
    const HEIGHT: u32 = 1060;
    let title = "Coated spheres; a₀ and p₀: contact radius and pressure without coating";
    let size = (2 * support::PANEL, support::TITLE + 2 * HEIGHT);
    let figure = support::figure(path, size, title)?;
    let panels = figure.split_evenly((2, 2));
    let radius = hertz.contact_radius();
    let along_x = |field: &Field, unit: f64| -> Vec<(f64, f64)> {
        let grid = field.grid();
        let row = grid.ny() / 2;
        let value = |ix| field.get(ix, row).unwrap_or_default() / unit;
        let points = (0..grid.nx()).map(|ix| (grid.x(ix) / radius, value(ix)));
        points.filter(|(x, _)| *x >= 0.0).collect()
    };
    let curves = |field: &dyn Fn(&Contact) -> Field, unit: f64| -> Vec<Vec<(f64, f64)>> {
        let fields = contacts.iter().map(|(contact, _)| field(contact));
        fields.map(|field| along_x(&field, unit)).collect()
    };
    let pressures = curves(
        &|contact| contact.normal.pressure().clone(),
        hertz.max_pressure(),
    );
    let tractions = curves(
        &|contact| contact.sheared.traction()[0].clone(),
        FRICTION * hertz.max_pressure(),
    );
    for (panel, curves, name) in [
        (&panels[0], pressures, "pressure p / p₀"),
        (&panels[1], tractions, "shear traction q / µp₀"),
    ] {
        // The highest curve remains below the upper end of the axis.
        let most = curves.iter().flatten().map(|(_, y)| *y).fold(0.0, f64::max);
        let mut chart = support::axes(panel, (0.0..1.6, "x / a₀"), (0.0..1.08 * most, name))?;
        for (((ratio, _), colour), points) in COATINGS.iter().zip(COLOURS).zip(curves) {
            support::line(&mut chart, &format!("E₁/E₂ = {ratio}"), colour, points)?;
        }
        support::legend(&mut chart, SeriesLabelPosition::UpperRight)?;
    }

    let mut stresses = support::axes(
        &panels[2],
        (0.0..2.0, "depth / a₀, below the centre"),
        (0.0..1.9, "von Mises stress / p₀"),
    )?;
    support::mark(&mut stresses, "interface", [(0.5, 0.0), (0.5, 1.9)])?;
    for (colour, (contact, _)) in COLOURS.into_iter().zip(contacts) {
        for side in &contact.stress {
            let unit = hertz.max_pressure();
            let points = side.iter().map(|(z, stress)| (z / radius, stress / unit));
            stresses.draw_series(LineSeries::new(points, support::stroke(colour)))?;
        }
    }
    support::legend(&mut stresses, SeriesLabelPosition::UpperRight)?;
    let mut zones = support::axes(
        &panels[3],
        (-2.0..2.0, "log₂(E₁/E₂)"),
        (0.0..1.4, "radius / a₀"),
    )?;
    let area_radius = |cells: usize, contact: &Contact| {
        let area = cells as f64 * contact.normal.grid().cell_area();
        (area / std::f64::consts::PI).sqrt() / radius
    };
    let of = |cells: &dyn Fn(&Contact) -> usize| -> Vec<(f64, f64)> {
        let points = COATINGS.iter().zip(contacts);
        points
            .map(|((ratio, _), (contact, _))| (ratio.log2(), area_radius(cells(contact), contact)))
            .collect()
    };
    let contact = of(&|contact| contact.normal.contact_cells());
    let stick = of(&|contact| {
        let contact_cells = contact.normal.contact_cells() as f64;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a part of some cells"
        )]
        let cells = (contact.sheared.stick_ratio() * contact_cells).round() as usize;
        cells
    });
    for (points, name, colour) in [
        (contact, "contact", support::BLUE),
        (stick, "stick zone", support::ORANGE),
    ] {
        support::line(&mut zones, name, colour, points)?;
    }
    support::legend(&mut zones, SeriesLabelPosition::UpperRight)?;
    figure.present()?;
    Ok(())
}
