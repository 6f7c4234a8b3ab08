//! Measures the cost of each digit of the solution. The program prints the time and the true error for the ball and a
//! rough surface, at five tolerances and by both methods. With `--large` the program also uses 1024 x 1024 cells.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

#[path = "../../../examples/support/mod.rs"]
mod support;

use std::error::Error;
use std::fs::File;
use std::io::Write;
use std::path::Path;

use kit::benchmark::{self, BenchmarkCase};
use kit::measure::{distance, energy_error, fastest};
use plotters::prelude::*;
use stickslip::Report;
use stickslip::cgm::Method;
use stickslip::influence::Component;

const TOLERANCES: [f64; 5] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10];
/// Tolerance of the best solutions, which are taken as exact.
const BEST: f64 = 1e-12;
/// Number of cells along each side in the figure.
const SHOWN: usize = 256;

/// Columns of a row: the scene and the settings, the normal problem, the tangential problem under the best pressure,
/// and the distances of the best solutions from the closed forms. The bound is certified by the library. `energy` and
/// `l1` are true errors: `energy` in the energy norm, and `l1` of the tractions summed over the cells.
const COLUMNS: &str = "scene,cells,contact,method,tolerance,\
    normal_ms,normal_double,normal_single,normal_bound,normal_energy,normal_l1,normal_status,\
    shear_ms,shear_double,shear_single,shear_bound,shear_energy,shear_l1,shear_status,\
    discretisation_normal,discretisation_shear";

const COLOURS: [(&str, RGBColor); 4] = [
    ("sphere", BLACK),
    ("rough-2%", support::BLUE),
    ("rough-10%", RGBColor(0, 150, 110)),
    ("rough-40%", support::ORANGE),
];

struct TimingRow {
    scene: &'static str,
    cells: usize,
    /// Fraction of the cells in contact.
    contact: f64,
    method: Method,
    tolerance: f64,
    /// Results of the normal and the tangential problem.
    runs: [Run; 2],
    /// Distances of the best solutions from the closed forms.
    discretisation: Option<[f64; 2]>,
}

/// One problem solved to one tolerance.
struct Run {
    milliseconds: f64,
    report: Report,
    /// Relative true error in the energy norm.
    energy: f64,
    /// True error of the tractions: sum of all differences divided by the sum of all tractions.
    l1: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let large = std::env::args().any(|argument| argument == "--large");
    let table = support::gallery("speed_against_error.csv")?;
    let mut file = File::create(&table)?;
    writeln!(file, "{COLUMNS}")?;
    print_heading();
    let mut rows = Vec::new();
    for cells in [128, 256, 512, 1024] {
        if cells > 512 && !large {
            break;
        }
        let methods = if cells <= 256 || large {
            vec![Method::ActiveSet, Method::PolonskyKeer]
        } else {
            vec![Method::ActiveSet]
        };
        for scene in std::iter::once(benchmark::ball(cells)?).chain(benchmark::rough(cells)?) {
            measure(&scene, &methods, |row| {
                let line = row.line();
                println!("{line}");
                let values = line.split_whitespace().filter(|value| *value != "|");
                let values: Vec<_> = values.map(|value| value.trim_matches('-')).collect();
                writeln!(file, "{}", values.join(","))?;
                rows.push(row);
                Ok(())
            })?;
            println!();
        }
    }

    let runs: Vec<_> = rows.iter().flat_map(|row| &row.runs).collect();
    println!(
        "of {} solves {} converged; the true error in energy is below the bound in {}",
        runs.len(),
        runs.iter().filter(|run| run.report.is_converged()).count(),
        runs.iter().filter(|run| run.is_bounded()).count(),
    );
    println!("table:  {}", table.display());
    let path = support::gallery("speed_against_error.svg")?;
    draw(&path, &rows)?;
    println!("figure: {}", path.display());
    Ok(())
}

/// Solves a scene by every method to every tolerance, and passes each row to `show` when it is complete.
fn measure(
    scene: &BenchmarkCase,
    methods: &[Method],
    mut show: impl FnMut(TimingRow) -> std::io::Result<()>,
) -> Result<(), Box<dyn Error>> {
    let normal = scene.normal(Method::ActiveSet, BEST)?.solve()?;
    let shear = scene
        .tangential(&normal, Method::ActiveSet, BEST)?
        .solve()?;
    let [pressure, traction] = [normal.pressure(), shear.traction()[0]];
    let discretisation = scene.closed_form().map(|exact| {
        let [exact_pressure, exact_traction] = &exact;
        [
            distance(pressure, exact_pressure),
            distance(traction, exact_traction),
        ]
    });
    let grid = normal.grid();
    for &method in methods {
        for tolerance in TOLERANCES {
            let mut solver = scene.normal(method, tolerance)?.into_solver()?;
            let mut found = solver.new_solution();
            let milliseconds = fastest(|| {
                solver.reset();
                solver.solve_into(&mut found)
            })?;
            let pressing = Run {
                milliseconds,
                report: found.report().clone(),
                energy: energy_error(&scene.bodies, Component::ZZ, found.pressure(), pressure)?,
                l1: distance(found.pressure(), pressure),
            };
            // The best pressure is used, so that only the tangential solve contributes to the error.
            let mut solver = scene
                .tangential(&normal, method, tolerance)?
                .into_solver()?;
            let mut found = solver.new_solution();
            let milliseconds = fastest(|| {
                solver.reset();
                solver.solve_into(&mut found)
            })?;
            let [along_x, _] = found.traction();
            let shearing = Run {
                milliseconds,
                report: found.report().clone(),
                energy: energy_error(&scene.bodies, Component::XX, along_x, traction)?,
                l1: distance(along_x, traction),
            };
            show(TimingRow {
                scene: scene.name,
                cells: grid.nx(),
                contact: normal.contact_cells() as f64 / grid.cells() as f64,
                method,
                tolerance,
                runs: [pressing, shearing],
                discretisation,
            })?;
        }
    }
    Ok(())
}

fn print_heading() {
    let run = "ms  dbl  sgl    bound   energy       L1 status   ";
    println!(
        "{:41} | {:^54} | {:^54} | discretisation\n\
         {:<9} {:>4} contact {:<12} {:>5} | {run:>54} | {run:>54} |  normal   shear",
        "", "normal", "tangential, on the best pressure", "scene", "N", "method", "tol",
    );
}

impl Run {
    /// Returns whether the true error is below the bound, with an allowance for the error of the best solution.
    fn is_bounded(&self) -> bool {
        self.energy <= self.report.energy_error_bound() + BEST
    }

    fn line(&self) -> String {
        format!(
            "{:>8.2} {:>4} {:>4} {:>8.1e} {:>8.1e} {:>8.1e} {:<9}",
            self.milliseconds,
            self.report.double_precision_products,
            self.report.single_precision_products,
            self.report.energy_error_bound(),
            self.energy,
            self.l1,
            format!("{:?}", self.report.status),
        )
    }
}

impl TimingRow {
    fn line(&self) -> String {
        let method = format!("{:?}", self.method);
        let [normal, shear] = self.runs.each_ref().map(Run::line);
        let discretisation = match self.discretisation {
            Some([pressure, traction]) => format!("{pressure:>7.1e} {traction:>7.1e}"),
            None => format!("{:>7} {:>7}", "-", "-"),
        };
        format!(
            "{:<9} {:>4} {:>7.3} {method:<12} {:>5.0e} | {normal} | {shear} | {discretisation}",
            self.scene, self.cells, self.contact, self.tolerance,
        )
    }
}

/// Draws the time against the true error, with the normal problem on the left and the tangential problem on the right.
fn draw(path: &Path, rows: &[TimingRow]) -> Result<(), Box<dyn Error>> {
    let rows: Vec<_> = rows.iter().filter(|row| row.cells == SHOWN).collect();
    let runs = rows.iter().flat_map(|row| &row.runs);
    let exponents = runs.map(|run| run.milliseconds.log10());
    let (least, most) = exponents.fold((f64::MAX, f64::MIN), |(least, most), exponent| {
        (least.min(exponent), most.max(exponent))
    });
    // A third of the height is reserved for the legend below the curves.
    let (bottom, top) = (least - 0.5 * (most - least), most + 0.2);

    let title = format!("{SHOWN} × {SHOWN} cells, tolerances 1e-2 (right) to 1e-10 (left)");
    let figure = support::figure(path, (2 * support::PANEL, 1540), &title)?;
    let figure = support::key(&figure, &COLOURS.map(|(scene, colour)| (colour, scene)))?;
    let (left, right) = figure.split_horizontally(support::PANEL);
    for (index, area, name) in [(0, left, "pressure"), (1, right, "shear traction")] {
        let label = format!("relative error of the {name} (L1)");
        let y = (bottom..top, "time (ms)");
        let mut chart = support::decades(&area, (-12.0..-1.0, &label), y)?;
        if let Some(errors) = rows.iter().find_map(|row| row.discretisation) {
            let x = errors[index].log10();
            let ends = [(x, bottom), (x, top)];
            support::mark(&mut chart, "sphere: discretisation", ends)?;
        }
        for curve in rows.chunk_by(|a, b| a.scene == b.scene && a.method == b.method) {
            let (scene, method) = (curve[0].scene, curve[0].method);
            let colour = COLOURS.iter().find(|(name, _)| *name == scene);
            let colour = colour.map_or(BLACK, |(_, colour)| *colour);
            let points: Vec<_> = curve
                .iter()
                .map(|row| &row.runs[index])
                .map(|run| (run.l1.log10().max(-12.0), run.milliseconds.log10()))
                .collect();
            let style = (colour, method == Method::default());
            // The legend contains the methods. The key above the charts contains the scenes.
            let name = if scene == COLOURS[0].0 {
                format!("{method:?}")
            } else {
                String::new()
            };
            support::curve(&mut chart, &name, style, &points)?;
        }
        if index == 0 {
            support::legend(&mut chart, SeriesLabelPosition::LowerLeft)?;
        }
    }
    figure.present()?;
    Ok(())
}
