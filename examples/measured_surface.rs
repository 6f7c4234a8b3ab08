//! A measured surface from a file: levelling, removal of outliers, filtering, filling of holes, contact with a plane,
//! and shear. All fields are written to files for other programs. A table shows the effect of each step on the surface
//! and the contact.
//!
//! `cargo run --release -p stickslip-examples --example measured_surface [file]` reads SDF, SUR and XYZ, and X3P with
//! `--features x3p`; lengths are in metres. Without a file it generates a surface with tilt, curvature, noise, outliers
//! and holes as `target/gallery/measured.sur`. Results: `target/gallery/measured.vti` (ParaView), `.npy`, `.csv` and
//! `.svg`.

#![allow(
    clippy::print_stdout,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "an example shows its numbers, and writes a file of 32 bits a point"
)]

mod support;

use std::error::Error;
use std::path::{Path, PathBuf};

use stickslip::analytical::{Persson, RoughSphere};
use stickslip::io::vti::Array;
use stickslip::surface::{self, Form, GaussianFilter, SelfAffine, Statistics};
use stickslip::{
    Boundary, ElasticPair, Field, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
    NormalSolution, TangentialLoad, TangentialProblem, TangentialSolution, Zone, io,
};
use support::maps;

// SI units.
const FRICTION: f64 = 0.3;
/// Tangential force divided by the sliding force.
const LOADING: f64 = 0.5;
/// Theoretical fraction of the surface in contact.
const AREA: f64 = 0.05;
/// Nesting index of the S filter, five cells. Shorter waves are noise of the instrument.
const S_FILTER: f64 = 2.5e-6;
/// Number of standard deviations from the surrounding heights beyond which a height is an outlier.
const OUTLYING: f64 = 6.0;

fn main() -> Result<(), Box<dyn Error>> {
    let file = match std::env::args().nth(1) {
        Some(file) => PathBuf::from(file),
        None => make_measurement()?,
    };
    let measured = io::read(&file)?;
    let levelled = surface::level(&measured, Form::Polynomial(2))?.into_heights();
    let inlying = without_outliers(&levelled)?;
    // Missing heights have no weight in the filter and are filled afterwards.
    let filtered = GaussianFilter::s(S_FILTER).apply(&inlying)?.into_heights();
    // The surface is levelled first, because holes near its edges would otherwise be filled incorrectly.
    let filled =
        |heights: &Field| surface::fill_missing(heights).map(surface::Filled::into_heights);
    let heights = filled(&filtered)?;

    let steel = Material::new(210e9, 0.3)?;
    let pair = ElasticPair::new(steel, steel)?;
    // The grid is a sample of a larger, nominally flat surface.
    let bodies = HalfSpace::with_boundary(heights.grid(), pair, Boundary::Periodic)?;
    // A measurement is not periodic, so its spectral slope would include the step between opposite edges.
    let slope = Statistics::of(&heights)?.finite_difference_rms_slope();
    let pressure = AREA / RoughSphere::AREA_COEFFICIENT * slope * pair.contact_modulus();
    let force = pressure * heights.grid().area();

    println!("normal force {force:.3e} N, holes filled:");
    println!(
        "step       missing  rms height (nm)  rms slope  spots  largest pressure (GPa)  contact (%)"
    );
    for (step, heights) in [("levelled", &levelled), ("cleaned", &inlying)] {
        print_step(step, heights, &press(&bodies, &filled(heights)?, force)?)?;
    }
    let normal = press(&bodies, &heights, force)?;
    print_step("filtered", &filtered, &normal)?;
    let friction = Friction::coulomb(FRICTION)?;
    let load = TangentialLoad::force([LOADING * FRICTION * force, 0.0]);
    let tangential = TangentialProblem::builder(&bodies, &normal, friction, load)
        .tolerance(1e-6)
        .build()?
        .solve()?;

    let theory = Persson::new(&pair, slope, pressure)?
        .with_area_coefficient(RoughSphere::AREA_COEFFICIENT)?;
    print_contact(&normal, &tangential, &theory)?;
    write_fields(&heights, &normal, &tangential)?;
    let path = support::gallery("measured.svg")?;
    draw(&path, &heights, &normal, &tangential)?;
    println!("figure: {}", path.display());
    Ok(())
}

/// Generates a typical measurement: 400 x 300 points of a ground surface with tilt, form, holes, outliers and noise of
/// the instrument.
fn make_measurement() -> Result<PathBuf, Box<dyn Error>> {
    let grid = Grid::new(400, 300, 0.5e-6, 0.4e-6)?;
    let rough = SelfAffine::with_rms_height(0.25e-6)
        .roll_off_wavelength(40e-6)
        .cut_off_wavelength(8e-6)
        .skewness(-0.4)
        .kurtosis(3.2)
        .cropped()
        .generate(grid)?;
    // The noise is white, like the noise of a camera: independent values at each point.
    let noise = SelfAffine::with_rms_height(5e-9)
        .hurst(0.0)
        .roll_off_wavelength(1e-6)
        .cut_off_wavelength(1e-6)
        .seed(1)
        .generate(grid)?;
    let form = Field::from_fn(grid, |x, y| {
        4e-3 * x - 7e-3 * y + 30.0 * (x * x - 0.3 * x * y)
    });
    let mut measured = surface::sum(&[rough.heights(), noise.heights(), &form])?;
    // Steep valleys and dust reflect no light. Single points reflect too much light.
    let statistics = Statistics::of(rough.heights())?;
    let dust = Field::from_fn(grid, |x, y| (x - 31e-6).hypot(y + 12e-6));
    let flat = rough.heights().as_slice().iter().zip(dust.as_slice());
    for (cell, (height, (z, distance))) in measured.as_mut_slice().iter_mut().zip(flat).enumerate()
    {
        if *z < -2.2 * statistics.rms_height() || *distance < 3e-6 {
            *height = f64::NAN;
        } else if cell % 3989 == 0 {
            *height += 1.2e-6;
        }
    }
    let path = support::gallery("measured.sur")?;
    std::fs::write(&path, sur(&measured))?;
    Ok(path)
}

/// Returns a SUR file with 32 bits per point, in units of 0.1 nm, as an instrument writes it.
fn sur(heights: &Field) -> Vec<u8> {
    let (grid, unit) = (heights.grid(), 1e-10);
    let counts = heights.iter().map(|z| (z / unit).round() as i32);
    let counts: Vec<i32> = counts.collect();
    let known = || heights.iter().zip(&counts).filter(|(z, _)| !z.is_nan());
    let least = known().map(|(_, &count)| count).min().unwrap_or(0);
    let most = known().map(|(_, &count)| count).max().unwrap_or(0);
    let mut file = vec![0; 512];
    let mut put = |at: usize, bytes: &[u8]| file[at..at + bytes.len()].copy_from_slice(bytes);
    put(0, b"DIGITAL SURF");
    // Header: number of objects, version, type (surface), flag for missing points, and bits per point.
    for (at, value) in [(14, 1u16), (16, 1), (18, 2), (86, 1), (98, 32)] {
        put(at, &value.to_le_bytes());
    }
    put(100, &least.to_le_bytes());
    put(104, &most.to_le_bytes());
    let (nx, ny) = (grid.nx() as u32, grid.ny() as u32);
    for (at, count) in [(108, nx), (112, ny), (116, nx * ny)] {
        put(at, &count.to_le_bytes());
    }
    for (at, side) in [(120, grid.dx()), (124, grid.dy()), (128, unit)] {
        put(at, &(side as f32).to_le_bytes());
    }
    for at in [180, 196, 212] {
        put(at, b"m");
    }
    let points = heights.iter().zip(counts);
    let points = points.map(|(z, count)| if z.is_nan() { least - 2 } else { count });
    file.extend(points.flat_map(i32::to_le_bytes));
    file
}

/// Replaces heights that differ too much from the surrounding mean by NaN.
fn without_outliers(heights: &Field) -> Result<Field, Box<dyn Error>> {
    let grid = heights.grid();
    let around = GaussianFilter::s(8.0 * grid.dx().max(grid.dy())).apply(heights)?;
    let mut differences: Vec<f64> = (heights.minus(around.heights())?.iter())
        .filter(|z| !z.is_nan())
        .map(|z| z.abs())
        .collect();
    // The median is insensitive to a few outliers.
    differences.sort_by(f64::total_cmp);
    let deviation = 1.4826 * differences[differences.len() / 2];
    let mut inlying = heights.clone();
    for (z, mean) in inlying
        .as_mut_slice()
        .iter_mut()
        .zip(around.heights().iter())
    {
        if (*z - mean).abs() > OUTLYING * deviation {
            *z = f64::NAN;
        }
    }
    Ok(inlying)
}

fn press(bodies: &HalfSpace, heights: &Field, force: f64) -> stickslip::Result<NormalSolution> {
    let gap = surface::gap_from_heights(heights)?;
    NormalProblem::builder(bodies, gap, NormalLoad::Force(force))
        .tolerance(1e-6)
        .build()?
        .solve()
}

/// Prints a step of the preparation: the surface before filling, and the resulting contact.
fn print_step(step: &str, heights: &Field, normal: &NormalSolution) -> stickslip::Result<()> {
    let filled = surface::fill_missing(heights)?;
    let statistics = Statistics::of(filled.heights())?;
    println!(
        "{step:10} {:7}  {:15.1}  {:9.4}  {:5}  {:22.2}  {:11.2}",
        filled.filled_cells(),
        1e9 * statistics.rms_height(),
        statistics.finite_difference_rms_slope(),
        normal.spots()?.as_slice().len(),
        1e-9 * normal.pressure().max(),
        100.0 * normal.contact_area_corrected() / normal.grid().area()
    );
    Ok(())
}

fn print_contact(
    normal: &NormalSolution,
    tangential: &TangentialSolution,
    theory: &Persson,
) -> stickslip::Result<()> {
    let area = normal.grid().area();
    println!(
        "force {:.3e} N, approach {:.3e} m, largest pressure {:.3e} Pa",
        normal.force(),
        normal.approach(),
        normal.pressure().max()
    );
    println!(
        "contact {:.2} % counted, {:.2} % with the perimeter corrected; theory {:.2} %",
        100.0 * normal.contact_area() / area,
        100.0 * normal.contact_area_corrected() / area,
        100.0 * theory.contact_fraction()
    );
    let spots = normal.spots()?;
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
    Ok(())
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

/// Draws the heights, the pressure, the stick and slip zones, and the contact spots.
fn draw(
    path: &Path,
    heights: &Field,
    normal: &NormalSolution,
    tangential: &TangentialSolution,
) -> Result<(), Box<dyn Error>> {
    let title = "Contact of a measured surface with a plane";
    let size = (2 * support::PANEL, support::TITLE + 2 * 840);
    let figure = support::figure(path, size, title)?;
    let panels = figure.split_evenly((2, 2));
    let micro = 1e6;
    let grid = heights.grid();
    let range = |side: f64, cells: usize| -> std::ops::Range<f64> {
        let half = 0.5 * side * cells as f64 * micro;
        -half..half
    };
    let (x, y) = (range(grid.dx(), grid.nx()), range(grid.dy(), grid.ny()));
    let axes = || [(x.clone(), "x (µm)"), (y.clone(), "y (µm)")];
    let largest = heights.max().max(-heights.min()) * micro;
    let pressure = normal.pressure();
    for (area, field, unit, scale, name) in [
        (
            &panels[0],
            heights,
            1.0 / micro,
            maps::Scale::around_zero(largest),
            "height (µm)",
        ),
        (
            &panels[1],
            pressure,
            1e9,
            maps::Scale::from_zero(maps::heat, 1e-9 * pressure.max()),
            "pressure (GPa)",
        ),
    ] {
        let area = area.margin(40, 0, 0, 0);
        let mut chart = maps::axes_and_bar(&area, axes(), (scale, name))?;
        maps::field(&mut chart, field, [1.0 / micro, unit], scale)?;
    }
    let [left, right] = [2, 3].map(|panel| panels[panel].margin(0, 0, 0, maps::BAR));
    let area = support::key(&left, &maps::zones_key(tangential.zones()))?;
    let [first, second] = axes();
    let mut map = support::map_axes(&area, first, second)?;
    let sight = [x.clone(), y.clone()];
    let (grid, zones) = (tangential.grid(), tangential.zones());
    maps::zones(&mut map, grid, zones, 1.0 / micro, sight)?;
    let area = support::heading(&right, "contact spots")?;
    let [first, second] = axes();
    let mut map = support::map_axes(&area, first, second)?;
    maps::spots(&mut map, &normal.spots()?, 1.0 / micro, [x, y])?;
    figure.present()?;
    Ok(())
}
