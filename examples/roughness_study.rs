//! Dependence of the area and the stick ratio of a nominally flat rough contact on rms height, rms slope, skewness and
//! kurtosis, each varied separately (the paper's Figs 16 to 19). The shortest wave of the surfaces spans eight cells or, as in
//! the paper, two cells, the limit of the grid.
//!
//! `cargo run --release -p stickslip-examples --example roughness_study [cells]` (default 512, at least 500)
//! writes `target/gallery/roughness_study.csv` and `.svg`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod support;

use std::error::Error;
use std::ops::Range;
use std::path::Path;

use plotters::prelude::*;
use rayon::prelude::*;
use stickslip::surface::{self, RoughSurface, SelfAffine};
use stickslip::{
    Boundary, ElasticPair, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
    TangentialLoad, TangentialProblem,
};

// Micrometres, megapascals, micronewtons.
const SIDE: f64 = 100.0;
const FRICTION: f64 = 0.5;
/// Tangential force divided by the sliding force.
const LOADING: f64 = 0.5;
const SEEDS: usize = 3;
const TOLERANCE: f64 = 1e-5;

/// Parameter that is varied.
#[derive(Clone, Copy, PartialEq)]
enum Question {
    /// Rms height at constant slope, varied by the roll-off.
    Height,
    /// Rms slope at constant height, varied by the roll-off.
    Slope,
    Skewness,
    Kurtosis,
}

const QUESTIONS: [Question; 4] = [
    Question::Height,
    Question::Slope,
    Question::Skewness,
    Question::Kurtosis,
];
const SLOPE: f64 = 0.5;
const HEIGHT: f64 = 0.1;
const ROLL_OFF: f64 = SIDE / 8.0;

impl Question {
    /// Returns the values: roll-off wavelengths, skewness or kurtosis.
    fn values(self) -> &'static [f64] {
        match self {
            Self::Height => &[50.0, 25.0, 12.5, 6.25, 3.125, 1.75],
            Self::Slope => &[30.0, 15.0, 7.5, 4.0, 2.25, 1.6],
            Self::Skewness => &[-1.0, -0.5, 0.0, 0.5, 1.0],
            Self::Kurtosis => &[2.5, 3.0, 4.0, 5.0, 6.0],
        }
    }

    fn surface(self, value: f64) -> SelfAffine {
        let steep = SelfAffine::with_rms_slope(SLOPE).roll_off_wavelength(ROLL_OFF);
        match self {
            Self::Height => steep.roll_off_wavelength(value),
            Self::Slope => SelfAffine::with_rms_height(HEIGHT).roll_off_wavelength(value),
            Self::Skewness => steep.skewness(value).kurtosis(4.0),
            Self::Kurtosis => steep.skewness(0.0).kurtosis(value),
        }
    }

    /// Returns the actual value of the varied parameter.
    fn varied(self, surface: &RoughSurface) -> f64 {
        match self {
            Self::Height => surface.rms_height(),
            Self::Slope => surface.rms_slope(),
            Self::Skewness => surface.skewness(),
            Self::Kurtosis => surface.kurtosis(),
        }
    }

    fn axis(self) -> (Range<f64>, &'static str) {
        match self {
            Self::Height => (0.0..1.6, "rms height (µm)"),
            Self::Slope => (0.0..0.7, "rms slope"),
            Self::Skewness => (-1.2..1.2, "skewness"),
            Self::Kurtosis => (2.0..6.5, "kurtosis"),
        }
    }
}

/// Shortest waves, in cells.
const CUT_OFFS: [(f64, &str); 2] = [(8.0, "waves ≥ 8 cells"), (2.0, "waves ≥ 2 cells")];
/// Height of the key of the colours.
const KEY: u32 = 90;
/// Mean pressure divided by the contact modulus.
const PRESSURE: f64 = 5e-3;

struct Job {
    question: Question,
    value: f64,
    /// Index of the cut-off.
    kind: usize,
    seed: u64,
}

struct Answer {
    varied: f64,
    rms_slope: f64,
    cells: usize,
    /// Contact area divided by the nominal area: counted in cells, and corrected with the perimeter.
    areas: [f64; 2],
    stick_ratio: f64,
}

impl Answer {
    /// Returns `(A/A0) E* g / p`. Theories predict a constant between 1.6 and 2.5. Simulations give about 2.
    fn coefficient(&self, area: usize) -> f64 {
        self.areas[area] * self.rms_slope / PRESSURE
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let cells: usize = std::env::args()
        .nth(1)
        .map_or(Ok(512), |cells| cells.parse())?;
    // The paper's rubber on a rigid plane: E* = 25 MPa. The half-spaces are periodic, because the pressure would vary near free
    // edges.
    let pair = ElasticPair::new(Material::new(18.75, 0.5)?, Material::rigid())?;
    let bodies = HalfSpace::with_boundary(Grid::square(cells, SIDE)?, pair, Boundary::Periodic)?;
    let mut jobs = Vec::new();
    for question in QUESTIONS {
        for kind in 0..CUT_OFFS.len() {
            for &value in question.values() {
                jobs.extend((0..SEEDS as u64).map(|seed| Job {
                    question,
                    value,
                    kind,
                    seed,
                }));
            }
        }
    }
    let answers = jobs
        .par_iter()
        .map(|job| solve(&bodies, job))
        .collect::<stickslip::Result<Vec<_>>>()?;

    print_table(&jobs, &answers);
    let header = [
        "question",
        "waves_down_to_cells",
        "seed",
        "varied",
        "rms_slope",
        "contact_cells",
        "area_by_counting",
        "area_corrected",
        "stick_ratio",
    ];
    let rows = jobs.iter().zip(&answers).map(|(job, answer)| {
        let Answer {
            varied,
            rms_slope,
            cells,
            areas: [counted, corrected],
            stick_ratio,
        } = *answer;
        let question = job.question as usize as f64;
        let (cut_off, _) = CUT_OFFS[job.kind];
        [
            question,
            cut_off,
            job.seed as f64,
            varied,
            rms_slope,
            cells as f64,
            counted,
            corrected,
            stick_ratio,
        ]
    });
    let csv = support::gallery("roughness_study.csv")?;
    let mut table = csv::Writer::from_path(&csv)?;
    table.write_record(header)?;
    for row in rows {
        table.serialize(row)?;
    }
    table.flush()?;
    let svg = support::gallery("roughness_study.svg")?;
    draw(&svg, &jobs, &answers)?;
    println!("\ntable: {}\nfigure: {}", csv.display(), svg.display());
    Ok(())
}

fn solve(bodies: &HalfSpace, job: &Job) -> stickslip::Result<Answer> {
    let grid = bodies.grid();
    let (cut_off, _) = CUT_OFFS[job.kind];
    let rough = job
        .question
        .surface(job.value)
        .cut_off_wavelength(cut_off * grid.dx())
        .seed(job.seed)
        .generate(grid)?;
    let gap = surface::gap_from_heights(rough.heights())?;
    let force = PRESSURE * bodies.pair().contact_modulus() * grid.area();
    let normal = NormalProblem::builder(bodies, &gap, NormalLoad::Force(force))
        .tolerance(TOLERANCE)
        .build()?
        .solve()?;
    let friction = Friction::coulomb(FRICTION)?;
    let load = TangentialLoad::force([LOADING * FRICTION * force, 0.0]);
    let tangential = TangentialProblem::builder(bodies, &normal, friction, load)
        .tolerance(TOLERANCE)
        .build()?
        .solve()?;
    Ok(Answer {
        varied: job.question.varied(&rough),
        rms_slope: rough.rms_slope(),
        cells: normal.contact_cells(),
        areas: [normal.contact_area(), normal.contact_area_corrected()]
            .map(|area| area / grid.area()),
        stick_ratio: tangential.stick_ratio(),
    })
}

/// Returns the results for one parameter and one type of surface.
fn of<'a>(
    (question, kind): (Question, usize),
    jobs: &'a [Job],
    answers: &'a [Answer],
) -> impl Iterator<Item = &'a Answer> + Clone {
    let alike = move |(job, _): &(&Job, &Answer)| job.question == question && job.kind == kind;
    jobs.iter()
        .zip(answers)
        .filter(alike)
        .map(|(_, answer)| answer)
}

fn print_table(jobs: &[Job], answers: &[Answer]) {
    println!("means of {SEEDS} surfaces, pressure {PRESSURE} E*, F = {LOADING} mu W");
    println!("area: (A/A0) E* g / p, counted, and with the perimeter corrected");
    for question in QUESTIONS {
        for (kind, (_, name)) in CUT_OFFS.iter().enumerate() {
            println!(
                "\n{:>16} | slope | cells |  area       | stick   ({name})",
                question.axis().1
            );
            let answers: Vec<_> = of((question, kind), jobs, answers).collect();
            for alike in answers.chunks(SEEDS) {
                let mean = |f: &dyn Fn(&Answer) -> f64| {
                    alike.iter().map(|answer| f(answer)).sum::<f64>() / alike.len() as f64
                };
                println!(
                    "{:>16.3} | {:>5.2} | {:>5.0} | {:>5.2}  {:>5.2} | {:>6.3}",
                    mean(&|a| a.varied),
                    mean(&|a| a.rms_slope),
                    mean(&|a| a.cells as f64),
                    mean(&|a| a.coefficient(0)),
                    mean(&|a| a.coefficient(1)),
                    mean(&|a| a.stick_ratio),
                );
            }
            if question == Question::Slope {
                let exponents = [0, 1].map(|area| {
                    let points = answers
                        .iter()
                        .map(|a| [a.rms_slope.ln(), a.areas[area].ln()]);
                    incline(&points.collect::<Vec<_>>())
                });
                println!(
                    "area ~ slope^n: n = {:.2} counted, {:.2} corrected",
                    exponents[0], exponents[1]
                );
            }
        }
    }
}

/// Returns the slope of the least-squares line through points.
fn incline(points: &[[f64; 2]]) -> f64 {
    let count = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|point| point[axis]).sum::<f64>() / count;
    let (x, y) = (mean(0), mean(1));
    let sum = |f: &dyn Fn([f64; 2]) -> f64| points.iter().copied().map(f).sum::<f64>();
    sum(&|p| (p[0] - x) * (p[1] - y)) / sum(&|p| (p[0] - x).powi(2))
}

fn draw(path: &Path, jobs: &[Job], answers: &[Answer]) -> Result<(), Box<dyn Error>> {
    const HEIGHT: u32 = 830;
    let title = "Nominally flat rough contact: each parameter varied alone";
    let size = (2 * support::PANEL, support::TITLE + KEY + 4 * HEIGHT);
    let figure = support::figure(path, size, title)?;
    let (key, panels) = figure.split_vertically(KEY);
    let colours = [support::BLUE, support::ORANGE];
    let names = colours.iter().zip(CUT_OFFS);
    let names: Vec<_> = names.map(|(&colour, (_, name))| (colour, name)).collect();
    support::key(&key, &names)?;
    let rows = panels.split_evenly((QUESTIONS.len(), 2));
    for (question, row) in QUESTIONS.into_iter().zip(rows.chunks_exact(2)) {
        let (range, name) = question.axis();
        let label = "(A/A₀) E* g / p";
        let mut chart = support::axes(&row[0], (range.clone(), name), (1.0..7.0, label))?;
        support::mark(&mut chart, "2", [(range.start, 2.0), (range.end, 2.0)])?;
        for (kind, colour) in colours.into_iter().enumerate() {
            for (area, is_full, name) in [(0, false, "counted"), (1, true, "corrected")] {
                let points = of((question, kind), jobs, answers);
                let points = points.map(|answer| (answer.varied, answer.coefficient(area)));
                support::dots(&mut chart, name, (colour, is_full), points)?;
            }
        }
        if question == Question::Height {
            support::legend(&mut chart, SeriesLabelPosition::UpperRight)?;
        }

        let label = "stick ratio at F = µW/2";
        let mut chart = support::axes(&row[1], (range.clone(), name), (0.4..0.62, label))?;
        let line = [(range.start, 0.5), (range.end, 0.5)];
        support::mark(&mut chart, "1 − F/µW", line)?;
        if question == Question::Height {
            support::legend(&mut chart, SeriesLabelPosition::UpperRight)?;
        }
        for (kind, colour) in colours.into_iter().enumerate() {
            let points = of((question, kind), jobs, answers);
            let points = points.map(|answer| (answer.varied, answer.stick_ratio));
            support::dots(&mut chart, CUT_OFFS[kind].1, (colour, true), points)?;
        }
    }
    figure.present()?;
    Ok(())
}
