//! A surface from a file: levelled, its holes filled, characterised, pressed on a plane, sheared, and every
//! field written for other programs.
//!
//! `cargo run --release -p stickslip --example measured_surface [file]` reads SDF, SUR, XYZ, and X3P with
//! `--features x3p`, lengths in metres. Without a file it generates one, tilted, bent and with holes, as
//! `target/gallery/measured.sdf`. Results: `target/gallery/measured.vti` (ParaView), `.npy`, `.csv`
//! and `.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::path::{Path, PathBuf};

use stickslip::analytical::{Persson, RoughSphere};
use stickslip::io::vti::Array;
use stickslip::surface::{self, Form, SelfAffine, Statistics};
use stickslip::{
    Boundary, ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalControl,
    NormalProblem, NormalSolution, TangentialLoad, TangentialProblem, TangentialSolution, Zone, io,
};
use support::maps;

// SI units.
const FRICTION: f64 = 0.3;
/// Tangential force over the sliding force.
const LOADING: f64 = 0.5;
/// Fraction of the surface that should be in contact, by theory.
const AREA: f64 = 0.05;

fn main() -> Result<(), Box<dyn Error>> {
    let file = match std::env::args().nth(1) {
        Some(file) => PathBuf::from(file),
        None => make_measurement()?,
    };
    let measured = io::read(&file)?;
    let heights = prepare(&measured)?;
    let statistics = Statistics::of(&heights)?;
    println!("{statistics}");

    let steel = Material::new(210e9, 0.3)?;
    let pair = ElasticPair::new(steel, steel)?;
    // The grid is a sample of a larger, nominally flat surface.
    let bodies = HalfSpace::with_boundary(heights.grid(), pair, Boundary::Periodic)?;
    // A measurement is not periodic: its spectral slope would include the step from edge to edge.
    let slope = statistics.finite_difference_rms_slope();
    let pressure = AREA / RoughSphere::AREA_COEFFICIENT * slope * pair.contact_modulus();
    let gap = surface::gap_from_heights(&heights)?;
    let force = pressure * gap.grid().area();
    let normal = NormalProblem::builder(&bodies, &gap, NormalControl::Force(force))
        .tolerance(1e-6)
        .build()?
        .solve()?;
    let friction = Friction::coulomb(FRICTION)?;
    let load = TangentialLoad::force([LOADING * FRICTION * force, 0.0]);
    let tangential = TangentialProblem::builder(&bodies, &normal, friction, load)
        .tolerance(1e-6)
        .build()?
        .solve()?;

    let theory = Persson::new(&pair, slope, pressure)?
        .with_area_coefficient(RoughSphere::AREA_COEFFICIENT)?;
    print_contact(&normal, &tangential, &theory);
    write_fields(&heights, &normal, &tangential)?;
    let path = support::gallery("measured.svg")?;
    draw(&path, &heights, &normal, &tangential)?;
    println!("figure: {}", path.display());
    Ok(())
}

/// A typical measurement: 400 x 300 points of a ground surface, tilted, with form and holes.
fn make_measurement() -> Result<PathBuf, Box<dyn Error>> {
    let grid = Grid::new(400, 300, 0.5e-6, 0.4e-6)?;
    let rough = SelfAffine::with_rms_height(0.25e-6)
        .roll_off_wavelength(40e-6)
        .cut_off_wavelength(4e-6)
        .skewness(-0.4)
        .kurtosis(3.2)
        .cropped()
        .generate(grid)?;
    let form = Field::from_fn(grid, |x, y| {
        4e-3 * x - 7e-3 * y + 30.0 * (x * x - 0.3 * x * y)
    });
    let mut measured = surface::sum(&[rough.heights(), &form])?;
    // Steep valleys and a speck of dust reflect no light.
    let statistics = Statistics::of(rough.heights())?;
    let dust = Field::from_fn(grid, |x, y| (x - 31e-6).hypot(y + 12e-6));
    let flat = rough.heights().as_slice().iter().zip(dust.as_slice());
    for (height, (z, distance)) in measured.as_mut_slice().iter_mut().zip(flat) {
        if *z < -2.2 * statistics.rms_height() || *distance < 3e-6 {
            *height = f64::NAN;
        }
    }
    let path = support::gallery("measured.sdf")?;
    io::sdf::write(&path, &measured)?;
    Ok(path)
}

/// Levels the surface before its holes are filled: near an edge, holes in a tilted surface would be filled askew.
fn prepare(measured: &Field) -> Result<Field, Box<dyn Error>> {
    let grid = measured.grid();
    let levelled = surface::level(measured, Form::Polynomial(2))?;
    let filled = surface::fill_missing(levelled.heights())?;
    println!(
        "{} x {} points of {:.3e} x {:.3e} m, {} filled; form of {:.2e} m taken off",
        grid.nx(),
        grid.ny(),
        grid.dx(),
        grid.dy(),
        filled.filled_cells(),
        levelled.form().max() - levelled.form().min()
    );
    Ok(filled.into_heights())
}

fn print_contact(normal: &NormalSolution, tangential: &TangentialSolution, theory: &Persson) {
    let area = normal.grid().area();
    println!(
        "force {:.3e} N, approach {:.3e} m, largest pressure {:.3e} Pa",
        normal.force(),
        normal.approach(),
        normal.pressure().max()
    );
    println!(
        "contact {:.2} % by counting, {:.2} % with the perimeter corrected; theory {:.2} %",
        100.0 * normal.contact_area() / area,
        100.0 * normal.contact_area_corrected() / area,
        100.0 * theory.contact_fraction()
    );
    let spots = normal.spots();
    println!(
        "{} spots, the largest of {} cells",
        spots.as_slice().len(),
        spots.largest().map_or(0, |spot| spot.cells)
    );
    println!(
        "stick ratio {:.3} at F = {LOADING} mu W, shift {:.3e} m",
        tangential.stick_ratio(),
        tangential.shift()[0]
    );
    println!(
        "normal:     {}\ntangential: {}",
        normal.report(),
        tangential.report()
    );
    for warning in normal.warnings() {
        println!("warning: {warning}");
    }
}

fn write_fields(
    heights: &Field,
    normal: &NormalSolution,
    tangential: &TangentialSolution,
) -> Result<(), Box<dyn Error>> {
    let zone = |zone: &Zone| match zone {
        Zone::Separated => 0.0,
        Zone::Stick => 1.0,
        Zone::Slip => 2.0,
    };
    let zones = tangential.zones().iter().map(zone).collect();
    let zones = Field::from_vec(heights.grid(), zones)?;
    let path = support::gallery("measured.vti")?;
    io::vti::write(
        &path,
        &[
            ("height", Array::from(heights)),
            ("gap", normal.gap().into()),
            ("pressure", normal.pressure().into()),
            ("traction", tangential.traction().into()),
            ("slip", tangential.slip().into()),
            ("zone", (&zones).into()),
        ],
    )?;
    println!("fields: {}", path.display());
    let path = support::gallery("measured.npy")?;
    io::npy::write(&path, normal.pressure())?;
    let path_of_text = support::gallery("measured.csv")?;
    io::csv::write(&path_of_text, normal.pressure())?;
    println!("pressure: {}, {}", path.display(), path_of_text.display());
    Ok(())
}

/// Heights in grey, pressure in colour, and the zones of stick and slip.
fn draw(
    path: &Path,
    heights: &Field,
    normal: &NormalSolution,
    tangential: &TangentialSolution,
) -> Result<(), Box<dyn Error>> {
    let figure = support::figure(
        path,
        (2600, 620),
        "A measured surface: heights, pressure, and the zones of stick (blue) and slip (orange)",
    )?;
    let (left, rest) = figure.split_horizontally(930);
    let (middle, right) = rest.split_horizontally(930);
    let micro = 1e6;
    let grid = heights.grid();
    let range = |side: f64, cells: usize| -> std::ops::Range<f64> {
        let half = 0.5 * side * cells as f64 * micro;
        -half..half
    };
    let (x, y) = (range(grid.dx(), grid.nx()), range(grid.dy(), grid.ny()));
    let axes = || ((x.clone(), "x, µm"), (y.clone(), "y, µm"));
    for (area, field, unit, colours, name) in [
        (
            &left,
            heights,
            micro,
            maps::grey as maps::Colours,
            "height, µm",
        ),
        (
            &middle,
            normal.pressure(),
            1e-9,
            maps::heat,
            "pressure, GPa",
        ),
    ] {
        let (map, bar) = area.split_horizontally(700);
        let mut chart = support::map_axes(&map, axes().0, axes().1)?;
        maps::field(&mut chart, field, 1.0 / micro, colours)?;
        maps::bar(
            &bar,
            colours,
            [field.min() * unit, field.max() * unit],
            name,
        )?;
    }
    let (right, _) = right.split_horizontally(700);
    let mut map = support::map_axes(&right, axes().0, axes().1)?;
    maps::zones(
        &mut map,
        tangential.grid(),
        tangential.zones(),
        1.0 / micro,
        [x.clone(), y.clone()],
    )?;
    figure.present()?;
    Ok(())
}
