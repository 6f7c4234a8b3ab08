//! Measures the cost of each digit of the solution. The example prints the time and the distance from closed forms for
//! several grids and tolerances. It compares uniform cells without edges to centre values with subcell edges.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

#[path = "../../../examples/support/mod.rs"]
mod support;

use std::error::Error;
use std::f64::consts::TAU;
use std::fs::File;
use std::io::Write;
use std::path::Path;

use kit::measure::{distance, fastest};
use kit::smooth::Smooth;
use kit::unit_pair;
use plotters::prelude::*;
use stickslip::analytical::{CattaneoMindlin, Cone, HertzSphere, Westergaard};
use stickslip::{
    Boundary, CellValue, Field, Friction, Grid, HalfSpace, NormalLoad, NormalProblem, Result,
    TangentialLoad, TangentialProblem,
};

/// Numbers of cells along each side.
const GRIDS: [usize; 5] = [32, 64, 128, 256, 512];
const TOLERANCES: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
/// Indices of the tolerances in the figure, with their colours.
const SHOWN: [(usize, RGBColor); 3] = [(0, support::ORANGE), (2, support::BLUE), (4, BLACK)];
/// Offsets of the contact relative to the cells, in cells. The errors are means over these offsets.
const OFFSETS: [[f64; 2]; 4] = [[0.0, 0.0], [0.31, -0.17], [-0.42, 0.48], [0.12, 0.43]];
/// Side of the grid, in contact radii, which are one.
const SIDE: f64 = 3.0;
const FRICTION: f64 = 0.5;
/// Tangential force relative to the force at which the contact slides.
const LOADING: f64 = 0.4;

const COLUMNS: &str = "scene,cells,tolerance,uniform_ms,uniform_error,uniform_area,\
    centre_ms,centre_error,centre_area";

type Function = Box<dyn Fn(f64, f64) -> f64>;

/// Contact of the unit pair whose pressure or traction is known.
struct ClosedFormCase {
    name: &'static str,
    gap: Function,
    exact: Function,
    force: f64,
    /// Area of the contact, or of its stick zone if it is sheared.
    area: f64,
    boundary: Boundary,
    /// Force along x after pressing. If there is a force, the traction is compared instead of the pressure.
    shear: Option<f64>,
}

/// Time, error of the field, and error of the area.
type Measured = [f64; 3];

struct ErrorRow {
    scene: &'static str,
    cells: usize,
    tolerance: f64,
    uniform: Measured,
    centre: Measured,
}

fn main() -> std::result::Result<(), Box<dyn Error>> {
    let table = support::gallery("grid_against_error.csv")?;
    let mut file = File::create(&table)?;
    writeln!(file, "{COLUMNS}")?;
    println!(
        "{:17} {:>4} {:>5} | {:^27} | {:^27}\n{:28} | {:>8} {:>9} {:>8} | {:>8} {:>9} {:>8}",
        "scene",
        "N",
        "tol",
        "uniform cells, counted",
        "centres, with edges",
        "",
        "ms",
        "L1",
        "area",
        "ms",
        "L1",
        "area",
    );
    let mut rows = Vec::new();
    for scene in scenes()? {
        for cells in GRIDS {
            for tolerance in TOLERANCES {
                let measured = |value| scene.measure(cells, value, tolerance);
                let row = ErrorRow {
                    scene: scene.name,
                    cells,
                    tolerance,
                    uniform: measured(CellValue::Uniform)?,
                    centre: measured(CellValue::Centre)?,
                };
                row.show(&mut file)?;
                rows.push(row);
            }
        }
        println!();
    }
    println!("table:  {}", table.display());
    let path = support::gallery("grid_against_error.svg")?;
    draw(&path, &rows)?;
    println!("figure: {}", path.display());
    Ok(())
}

fn scenes() -> Result<[ClosedFormCase; 5]> {
    let pair = unit_pair(0.0);
    let smooth = |shape: fn() -> Smooth| {
        let (gap, pressure) = (shape(), shape());
        ClosedFormCase {
            name: gap.name,
            force: gap.force,
            area: gap.area,
            gap: Box::new(move |x, y| gap.height(x, y)),
            exact: Box::new(move |x, y| pressure.pressure_at(x, y)),
            boundary: Boundary::NonPeriodic,
            shear: None,
        }
    };
    let sphere = smooth(Smooth::sphere);
    let hertz = HertzSphere::new(&pair, 1.0, sphere.force)?;
    let shear = CattaneoMindlin::new(hertz, FRICTION, LOADING * FRICTION * sphere.force)?;
    let sheared = ClosedFormCase {
        name: "Cattaneo-Mindlin",
        exact: Box::new(move |x, y| shear.traction(x.hypot(y))),
        area: shear.stick_ratio() * hertz.contact_area(),
        shear: Some(shear.force()),
        ..smooth(Smooth::sphere)
    };
    // The contact radius is one.
    let slope = 0.5;
    let first = Cone::new(&pair, slope, 1.0)?;
    let cone = Cone::new(&pair, slope, first.contact_radius().powi(-2))?;
    let amplitude = 0.1;
    let full = Westergaard::new(&pair, amplitude, SIDE, 1.0)?.full_contact_pressure();
    let wave = Westergaard::new(&pair, amplitude, SIDE, 0.25 * full)?;
    Ok([
        sphere,
        smooth(Smooth::ellipse),
        ClosedFormCase {
            name: "cone",
            gap: Box::new(move |x, y| slope * x.hypot(y)),
            exact: Box::new(move |x, y| cone.pressure(x.hypot(y))),
            force: cone.load(),
            area: cone.contact_area(),
            boundary: Boundary::NonPeriodic,
            shear: None,
        },
        ClosedFormCase {
            name: "wave",
            gap: Box::new(move |x, _| amplitude * (1.0 - (TAU * x / SIDE).cos())),
            exact: Box::new(move |x, _| wave.pressure(x)),
            force: wave.mean_pressure() * SIDE * SIDE,
            area: 2.0 * wave.contact_half_width() * SIDE,
            boundary: Boundary::Periodic,
            shear: None,
        },
        sheared,
    ])
}

impl ClosedFormCase {
    /// Measures the shortest time of a solve with its evaluation, and the mean errors over the offsets.
    fn measure(&self, cells: usize, value: CellValue, tolerance: f64) -> Result<Measured> {
        let grid = Grid::square(cells, SIDE)?;
        let pair = unit_pair(0.0);
        let bodies = HalfSpace::with_boundary(grid, pair, self.boundary)?.with_cell_value(value)?;
        let mut found = [f64::INFINITY, 0.0, 0.0];
        for offset in OFFSETS {
            let [x0, y0] = [offset[0] * grid.dx(), offset[1] * grid.dy()];
            let gap = Field::from_fn(grid, |x, y| (self.gap)(x - x0, y - y0));
            let exact = Field::from_fn(grid, |x, y| (self.exact)(x - x0, y - y0));
            let (time, field, area) =
                self.solve(&bodies, &gap, (tolerance, value == CellValue::Centre))?;
            let parts = OFFSETS.len() as f64;
            found[0] = found[0].min(time);
            found[1] += distance(&field, &exact) / parts;
            found[2] += (area / self.area - 1.0).abs() / parts;
        }
        Ok(found)
    }

    /// Returns the time, the field and the area, as cell values or with edges.
    fn solve(
        &self,
        bodies: &HalfSpace,
        gap: &Field,
        (tolerance, with_edges): (f64, bool),
    ) -> Result<(f64, Field, f64)> {
        let load = NormalLoad::Force(self.force);
        let problem = NormalProblem::builder(bodies, gap, load);
        let mut presser = problem.tolerance(tolerance).build()?.into_solver()?;
        let mut contact = presser.new_solution();
        let Some(force) = self.shear else {
            let mut edges = None;
            let time = fastest(|| {
                presser.reset();
                presser.solve_into(&mut contact)?;
                edges = with_edges.then(|| contact.edges()).transpose()?;
                Ok(())
            })?;
            return Ok(match edges {
                Some(edges) => (time, edges.centres().clone(), edges.area()),
                None => (time, contact.pressure().clone(), contact.contact_area()),
            });
        };
        presser.solve_into(&mut contact)?;
        let (friction, load) = (
            Friction::coulomb(FRICTION)?,
            TangentialLoad::force([force, 0.0]),
        );
        let problem = TangentialProblem::builder(bodies, &contact, friction.clone(), load);
        let mut shearer = problem.tolerance(tolerance).build()?.into_solver()?;
        let mut sheared = shearer.new_solution();
        let mut edges = None;
        let time = fastest(|| {
            shearer.reset();
            shearer.solve_into(&mut sheared)?;
            edges = with_edges
                .then(|| sheared.edges(&contact, &friction))
                .transpose()?;
            Ok(())
        })?;
        Ok(match edges {
            Some(edges) => (time, edges.traction().clone(), edges.stick_area()),
            None => (time, sheared.traction()[0].clone(), sheared.stick_area()),
        })
    }
}

impl ErrorRow {
    fn show(&self, file: &mut File) -> std::io::Result<()> {
        let (scene, cells, tolerance) = (self.scene, self.cells, self.tolerance);
        let ([a, b, c], [d, e, f]) = (self.uniform, self.centre);
        println!(
            "{scene:17} {cells:>4} {tolerance:>5.0e} | {a:>8.2} {b:>9.1e} {c:>8.1e} | {d:>8.2} {e:>9.1e} {f:>8.1e}"
        );
        writeln!(
            file,
            "{scene},{cells},{tolerance:e},{a},{b},{c},{d},{e},{f}"
        )
    }
}

/// Draws the time against the error, for the pressure of the sphere on the left and for its traction on the right. The
/// grid size increases along a curve.
fn draw(path: &Path, rows: &[ErrorRow]) -> std::result::Result<(), Box<dyn Error>> {
    let title = "Grids of 32 × 32 cells (right) to 512 × 512 cells (left)";
    let figure = support::figure(path, (2 * support::PANEL, 1540), title)?;
    let (left, right) = figure.split_horizontally(support::PANEL);
    for (area, scene, name) in [
        (left, "sphere", "pressure"),
        (right, "Cattaneo-Mindlin", "shear traction"),
    ] {
        let label = format!("relative error of the {name} (L1)");
        let mut chart = support::decades(&area, (-5.0..-1.0, &label), (-3.0..2.0, "time (ms)"))?;
        for (place, colour) in SHOWN {
            for (is_full, kind) in [(false, "uniform"), (true, "centres, edges")] {
                let points: Vec<_> = rows
                    .iter()
                    .filter(|row| row.scene == scene)
                    .skip(place)
                    .step_by(TOLERANCES.len())
                    .map(|row| if is_full { row.centre } else { row.uniform })
                    .map(|[time, error, _]| (error.log10(), time.log10()))
                    .collect();
                let name = format!("{kind}, {:e}", TOLERANCES[place]);
                support::curve(&mut chart, &name, (colour, is_full), &points)?;
            }
        }
        if scene == "sphere" {
            support::legend(&mut chart, SeriesLabelPosition::LowerLeft)?;
        }
    }
    figure.present()?;
    Ok(())
}
