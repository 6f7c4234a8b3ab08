//! Profile of a roller that minimises the largest pressure, found with gradients from sensitivities. The pressure of a straight
//! roller is largest at its ends. The example compares the computed profile with Lundberg's profile, under which the load per
//! length is nearly uniform.
//!
//! `cargo run --release -p stickslip-examples --example roller_profile` prints the comparison and writes
//! `target/gallery/roller_profile.csv` and `.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;

use plotters::prelude::*;
use stickslip::sensitivity::Functional;
use stickslip::{
    ElasticPair, Field, Grid, HalfSpace, Material, NormalLoad, NormalProblem, NormalSolution,
    NormalSolver, Result, surface,
};

/// Modulus of both bodies, radius and length of the roller, and load, in mm, N and MPa.
const MODULUS: f64 = 210e3;
const POISSON_RATIO: f64 = 0.3;
const RADIUS: f64 = 10.0;
const LENGTH: f64 = 20.0;
const LOAD: f64 = 10e3;
/// Numbers of cells and sides of the grid. The gap beyond the ends of the roller exceeds the approach.
const CELLS: (usize, usize) = (32, 128);
const SIDES: (f64, f64) = (0.75, LENGTH * 128.0 / 120.0);
const WIDE: f64 = 1.0;
/// Number of parameters of the profile.
const POINTS: usize = 16;
/// Exponents of the mean pressure, in order. The mean tends to the largest pressure for large exponents.
const EXPONENTS: [f64; 3] = [4.0, 16.0, 64.0];
/// Largest number of descents for an exponent, and relative decrease of the mean pressure at which the search ends.
const DESCENTS: usize = 40;
const ENOUGH: f64 = 1e-6;

fn main() -> std::result::Result<(), Box<dyn Error>> {
    let mut roller = Roller::new()?;
    let straight = roller.press(&|_| 0.0)?;
    let crowned = roller.press(&lundberg)?;
    let mut profile = [0.0; POINTS];
    let mut searched = Vec::new();
    for exponent in EXPONENTS {
        searched.extend(roller.minimise(exponent, &mut profile)?);
    }
    let computed = roller.press(&|y| drop(&profile, y))?;
    let contacts = [
        ("straight", &straight),
        ("Lundberg", &crowned),
        ("computed", &computed),
    ];

    println!("profile  | largest pressure / uniform | largest load per length / mean");
    for (name, contact) in contacts {
        let pressure = contact.pressure().max() / uniform_pressure();
        let load = line_load(contact).map(|(_, load)| load).fold(0.0, f64::max);
        println!("{name} | {pressure:>26.4} | {load:>30.4}");
    }
    println!(
        "\n{} evaluations of the mean pressure and its {POINTS} derivatives: {} products in solves, {} for the derivatives",
        searched.len(),
        roller.products[0],
        roller.products[1],
    );
    let path = support::gallery("roller_profile.csv")?;
    let mut table = csv::Writer::from_path(&path)?;
    table.write_record(["y", "lundberg", "computed", "line_load"])?;
    for (y, load) in line_load(&computed).filter(|(y, _)| y.abs() < 0.5 * LENGTH) {
        table.serialize((y, lundberg(y), drop(&profile, y), load))?;
    }
    table.flush()?;
    let svg = support::gallery("roller_profile.svg")?;
    draw(&svg, &profile, contacts, &searched)?;
    println!("\ntable: {}\nfigure: {}", path.display(), svg.display());
    Ok(())
}

/// Roller pressed onto a half-space by a force.
struct Roller {
    solver: NormalSolver,
    contact: NormalSolution,
    /// Products of the solves and of the sensitivities.
    products: [usize; 2],
}

impl Roller {
    fn new() -> Result<Self> {
        let steel = Material::new(MODULUS, POISSON_RATIO)?;
        let ((nx, ny), (side_x, side_y)) = (CELLS, SIDES);
        let grid = Grid::new(nx, ny, side_x / nx as f64, side_y / ny as f64)?;
        let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
        let gap = gap(bodies.grid(), &|_| 0.0)?;
        let load = NormalLoad::Force(LOAD);
        let solver = NormalProblem::builder(&bodies, &gap, load)
            .build()?
            .into_solver()?;
        Ok(Self {
            contact: solver.new_solution(),
            solver,
            products: [0; 2],
        })
    }

    /// Returns the contact of a roller whose radius decreases by `drop` towards the ends.
    fn press(&mut self, drop: &dyn Fn(f64) -> f64) -> Result<NormalSolution> {
        self.solver.set_gap(&gap(self.contact.grid(), drop)?)?;
        self.solver.solve_into(&mut self.contact)?;
        self.products[0] += self.contact.report().products();
        Ok(self.contact.clone())
    }

    /// Returns the mean pressure and its derivatives with respect to the parameters of the profile.
    fn mean_pressure(&mut self, exponent: f64, profile: &Profile) -> Result<(f64, Profile)> {
        self.press(&|y| drop(profile, y))?;
        let functional = Functional::PressureNorm { exponent };
        let found = self.solver.sensitivity(&self.contact, &functional)?;
        self.products[1] += found.report.products();
        let mut slope = [0.0; POINTS];
        let by_gap = found.gap.as_ref().map_or(&[][..], Field::as_slice);
        let grid = self.contact.grid();
        for (row, by_gap) in by_gap.chunks(grid.nx()).enumerate() {
            let sum: f64 = by_gap.iter().sum();
            for (k, weight) in weights(grid.y(row)) {
                slope[k] += sum * weight;
            }
        }
        Ok((found.value, slope))
    }

    /// Minimises the mean pressure by the method of Broyden, Fletcher, Goldfarb and Shanno. Returns the mean and the
    /// largest pressure of all evaluations.
    fn minimise(&mut self, exponent: f64, profile: &mut Profile) -> Result<Vec<[f64; 2]>> {
        let (mut value, mut slope) = self.mean_pressure(exponent, profile)?;
        let mut values = vec![[value, self.contact.pressure().max()]];
        let size = dot(&slope, &slope).sqrt();
        let mut inverse = [[0.0; POINTS]; POINTS];
        for (k, row) in inverse.iter_mut().enumerate() {
            row[k] = unit() / size;
        }
        for _ in 0..DESCENTS {
            let step = inverse.map(|row| -dot(&row, &slope));
            let expected = dot(&step, &slope);
            let mut part = 1.0;
            let (next, trial, trial_slope) = loop {
                let trial: Profile = std::array::from_fn(|k| profile[k] + part * step[k]);
                let (next, trial_slope) = self.mean_pressure(exponent, &trial)?;
                values.push([next, self.contact.pressure().max()]);
                if next <= value + 1e-4 * part * expected || part < 1e-3 {
                    break (next, trial, trial_slope);
                }
                part *= 0.5;
            };
            if next > value * (1.0 - ENOUGH) {
                break;
            }
            let moved = step.map(|step| part * step);
            let change = std::array::from_fn(|k| trial_slope[k] - slope[k]);
            update(&mut inverse, &moved, &change);
            (*profile, value, slope) = (trial, next, trial_slope);
        }
        Ok(values)
    }
}

/// Decreases of the radius at the points of the profile, except for the point in the middle, where the decrease is zero.
type Profile = [f64; POINTS];

/// Updates the inverse of the matrix of second derivatives by a move and the change of the slope.
fn update(inverse: &mut [Profile; POINTS], moved: &Profile, change: &Profile) {
    let curvature = dot(moved, change);
    if curvature <= 0.0 {
        return;
    }
    let response = inverse.map(|row| dot(&row, change));
    let factor = (1.0 + dot(change, &response) / curvature) / curvature;
    for (i, row) in inverse.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry += factor * moved[i] * moved[j]
                - (response[i] * moved[j] + moved[i] * response[j]) / curvature;
        }
    }
}

fn dot(a: &Profile, b: &Profile) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Returns the contact modulus.
fn modulus() -> f64 {
    0.5 * MODULUS / (1.0 - POISSON_RATIO * POISSON_RATIO)
}

/// Returns the pressure under a uniform load per length.
fn uniform_pressure() -> f64 {
    (LOAD / LENGTH * modulus() / (PI * RADIUS)).sqrt()
}

/// Returns the unit of profiles: load per length divided by pi and the contact modulus.
fn unit() -> f64 {
    LOAD / (LENGTH * PI * modulus())
}

/// Returns Lundberg's profile, which is infinite at the ends of the roller.
fn lundberg(y: f64) -> f64 {
    -unit() * (1.0 - (2.0 * y / LENGTH).powi(2)).ln()
}

/// Returns the position of a point of the profile. The distances decrease towards the end.
fn point(k: usize) -> f64 {
    0.5 * LENGTH * (FRAC_PI_2 * k as f64 / POINTS as f64).sin()
}

/// Returns the two parameters between which the profile is linear at a position, with their weights. Beyond the ends there are
/// none.
fn weights(y: f64) -> impl Iterator<Item = (usize, f64)> {
    let y = y.abs();
    let k = (1..=POINTS).find(|&k| y <= point(k));
    k.into_iter().flat_map(move |k| {
        let part = (y - point(k - 1)) / (point(k) - point(k - 1));
        // Point k has the parameter with the index k - 1.
        let inner = (k > 1).then(|| (k - 2, 1.0 - part));
        inner.into_iter().chain([(k - 1, part)])
    })
}

fn drop(profile: &Profile, y: f64) -> f64 {
    weights(y).map(|(k, weight)| weight * profile[k]).sum()
}

fn gap(grid: Grid, drop: &dyn Fn(f64) -> f64) -> Result<Field> {
    let cylinder = surface::cylinder(grid, RADIUS)?;
    let drops = Field::from_fn(grid, |_, y| {
        if y.abs() < 0.5 * LENGTH {
            drop(y)
        } else {
            WIDE
        }
    });
    surface::sum(&[&cylinder, &drops])
}

/// Returns the positions along the roller with the load per length, divided by its mean.
fn line_load(contact: &NormalSolution) -> impl Iterator<Item = (f64, f64)> {
    let grid = contact.grid();
    let rows = contact.pressure().as_slice().chunks(grid.nx()).enumerate();
    rows.map(move |(row, pressure)| {
        let load = pressure.iter().sum::<f64>() * grid.dx();
        (grid.y(row), load * LENGTH / LOAD)
    })
}

fn draw(
    path: &Path,
    profile: &Profile,
    contacts: [(&str, &NormalSolution); 3],
    searched: &[[f64; 2]],
) -> std::result::Result<(), Box<dyn Error>> {
    const HEIGHT: u32 = 1060;
    const COLOURS: [RGBColor; 3] = [BLACK, support::ORANGE, support::BLUE];
    let title =
        "Profile of a roller for the least pressure; p₀: pressure under a uniform load per length";
    let size = (2 * support::PANEL, support::TITLE + 2 * HEIGHT);
    let figure = support::figure(path, size, title)?;
    let panels = figure.split_evenly((2, 2));
    // The profile has no effect beyond the last centre of a cell.
    let last = 0.5 * (LENGTH - contacts[0].1.grid().dy());
    let half = || (0..=400).map(|n| last * f64::from(n) / 400.0);

    let mut profiles = support::axes(&panels[0], (0.0..10.0, "y, mm"), (0.0..8.0, "drop, µm"))?;
    let curve = half().map(|y| (y, 1e3 * lundberg(y)));
    let curve = curve.filter(|(_, drop)| *drop <= 8.0);
    support::line(&mut profiles, "Lundberg", COLOURS[1], curve)?;
    let curve = half().map(|y| (y, 1e3 * drop(profile, y)));
    support::line(&mut profiles, "computed", COLOURS[2], curve)?;
    support::legend(&mut profiles, SeriesLabelPosition::UpperLeft)?;

    let mut loads = support::axes(
        &panels[1],
        (0.0..10.0, "y, mm"),
        (0.0..1.6, "load per length / mean"),
    )?;
    let mut largest = support::axes(
        &panels[2],
        (0.0..10.0, "y, mm"),
        (0.0..2.0, "largest pressure across / p₀"),
    )?;
    for ((name, contact), colour) in contacts.into_iter().zip(COLOURS) {
        let on_roller = |(y, _): &(f64, f64)| (0.0..0.5 * LENGTH).contains(y);
        let curve = line_load(contact).filter(on_roller);
        support::line(&mut loads, name, colour, curve)?;
        let grid = contact.grid();
        let rows = contact.pressure().as_slice().chunks(grid.nx()).enumerate();
        let curve = rows.map(|(row, pressure)| {
            let most = pressure.iter().copied().fold(0.0, f64::max);
            (grid.y(row), most / uniform_pressure())
        });
        support::line(&mut largest, name, colour, curve.filter(on_roller))?;
    }
    support::legend(&mut loads, SeriesLabelPosition::LowerLeft)?;
    support::legend(&mut largest, SeriesLabelPosition::LowerLeft)?;

    let mut search = support::axes(
        &panels[3],
        (0.0..searched.len() as f64, "evaluation"),
        (0.8..2.0, "pressure / p₀"),
    )?;
    for (which, name, colour) in [
        (1, "largest", support::GREEN),
        (0, "mean, exponents 4, 16, 64", COLOURS[2]),
    ] {
        let curve = searched.iter().enumerate();
        let curve =
            curve.map(|(n, values)| (n as f64, (values[which] / uniform_pressure()).min(2.0)));
        support::line(&mut search, name, colour, curve)?;
    }
    support::legend(&mut search, SeriesLabelPosition::UpperRight)?;
    figure.present()?;
    Ok(())
}
