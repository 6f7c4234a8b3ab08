//! Measures solves in units of one product in double precision on the whole grid, which depends less on the machine than
//! a time.
//!
//! `cargo bench -p stickslip-benches --bench time_in_products -- [cells ...]` prints one table for one thread and one for
//! two threads. Each time is the shortest of several rounds. Every round measures all rows in turn, so a load of
//! the machine affects all rows in the same way. The columns `double` and `single` are numbers of products. In the row of
//! the fretting step, they are the numbers of the whole cycle.

#![allow(clippy::print_stdout, reason = "a table is printed")]

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use kit::benchmark::{self, BenchmarkCase, FRICTION, LOADING};
use rayon::ThreadPoolBuilder;
use stickslip::cgm::Method;
use stickslip::influence::Component;
use stickslip::{Field, Friction, History, LoadStep, NormalLoad, Operator, Result};

const ROUNDS: usize = 7;
/// Tolerances of the solves without an earlier solution.
const COLD: [f64; 3] = [1e-4, 1e-6, 1e-8];
/// Tolerance of the solves from an earlier solution and of the steps of a history.
const WARM: f64 = 1e-6;
/// Number of steps of the cycle of the tangential force.
const STEPS: u32 = 20;

fn main() -> std::result::Result<(), Box<dyn Error>> {
    let is_test = std::env::args().any(|argument| argument == "--test");
    let mut sizes: Vec<u16> = std::env::args()
        .filter_map(|argument| argument.parse().ok())
        .collect();
    if sizes.is_empty() {
        sizes = if is_test {
            vec![64]
        } else {
            vec![64, 128, 256, 512]
        };
    }
    for threads in [1, 2] {
        println!("{threads} threads");
        println!(
            "{:>5} {:<34} {:>9} {:>9} {:>6} {:>6}",
            "N", "work", "ms", "products", "double", "single"
        );
        let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
        pool.install(|| sizes.iter().try_for_each(|&cells| print_size(cells)))?;
    }
    Ok(())
}

/// One line of the table.
struct Row {
    name: String,
    work: Box<dyn FnMut() -> Result<Sample> + Send>,
    best: Sample,
}

/// Time of one run in milliseconds, and its numbers of products.
#[derive(Clone, Copy)]
struct Sample {
    milliseconds: f64,
    products: [usize; 2],
}

fn print_size(cells: u16) -> Result<()> {
    let ball = benchmark::ball(cells)?;
    let [_, rough, _] = benchmark::rough(cells)?;
    let mut rows = products(&ball)?;
    for case in [&ball, &rough] {
        for tolerance in COLD {
            cold_solves(&mut rows, case, tolerance)?;
        }
        rows.push(warm_solve(case)?);
    }
    rows.push(fretting_step(&ball)?);
    for round in 0..=ROUNDS {
        for row in &mut rows {
            let sample = (row.work)()?;
            // The first round allocates memory and is not counted.
            if round > 0 && sample.milliseconds < row.best.milliseconds {
                row.best = sample;
            }
        }
    }
    let product = rows[0].best.milliseconds;
    for Row { name, best, .. } in &rows {
        let [double, single] = best.products;
        let relative = best.milliseconds / product;
        println!(
            "{cells:>5} {name:<34} {:>9.3} {relative:>9.1} {double:>6} {single:>6}",
            best.milliseconds
        );
    }
    Ok(())
}

impl Row {
    fn new(name: String, work: impl FnMut() -> Result<Sample> + Send + 'static) -> Self {
        let best = Sample {
            milliseconds: f64::INFINITY,
            products: [0, 0],
        };
        Self {
            name,
            work: Box::new(work),
            best,
        }
    }
}

/// Runs work that returns its numbers of products.
fn timed(work: impl FnOnce() -> Result<[usize; 2]>) -> Result<Sample> {
    let start = Instant::now();
    let products = work()?;
    Ok(Sample {
        milliseconds: 1e3 * start.elapsed().as_secs_f64(),
        products,
    })
}

/// Returns the rows of one product in double and one in single precision.
fn products(case: &BenchmarkCase) -> Result<Vec<Row>> {
    let rows = [
        ("product, double precision", false),
        ("product, single precision", true),
    ];
    let row = |(name, single): (&str, bool)| {
        let operator = case.bodies.operator(Component::ZZ)?;
        let pressure = Field::from_fn(case.bodies.grid(), |x, y| (1e4 * x).sin() + (2e4 * y).cos());
        let mut out = vec![0.0; operator.cells()];
        let mut workspace = operator.scratch()?;
        Ok(Row::new(name.to_owned(), move || {
            timed(|| {
                let pressure = black_box(pressure.as_slice());
                if single {
                    operator.apply_f32([pressure], [&mut out], &mut workspace);
                    return Ok([0, 1]);
                }
                operator.apply([pressure], [&mut out], &mut workspace);
                Ok([1, 0])
            })
        }))
    };
    rows.into_iter().map(row).collect()
}

/// Adds the rows of a normal and a tangential solve without an earlier solution.
fn cold_solves(rows: &mut Vec<Row>, case: &BenchmarkCase, tolerance: f64) -> Result<()> {
    let name = case.name;
    let mut press = case.normal(Method::ActiveSet, tolerance)?.into_solver()?;
    let mut pressed = press.new_solution();
    press.solve_into(&mut pressed)?;
    let problem = case.tangential(&pressed, Method::ActiveSet, tolerance)?;
    let mut shear = problem.into_solver()?;
    let mut sheared = shear.new_solution();
    rows.push(Row::new(
        format!("{name}, pressure to {tolerance:.0e}"),
        move || {
            press.reset();
            timed(|| {
                press.solve_into(&mut pressed)?;
                Ok(counts(pressed.report()))
            })
        },
    ));
    rows.push(Row::new(
        format!("{name}, traction to {tolerance:.0e}"),
        move || {
            shear.reset();
            timed(|| {
                shear.solve_into(&mut sheared)?;
                Ok(counts(sheared.report()))
            })
        },
    ));
    Ok(())
}

/// Returns the row of a normal solve after a solve under a force smaller by 1 %.
fn warm_solve(case: &BenchmarkCase) -> Result<Row> {
    let mut press = case.normal(Method::ActiveSet, WARM)?.into_solver()?;
    let mut pressed = press.new_solution();
    let force = case.force;
    Ok(Row::new(
        format!("{}, 1 % more force to {WARM:.0e}", case.name),
        move || {
            press.reset();
            press.set_load(NormalLoad::Force(force))?;
            press.solve_into(&mut pressed)?;
            press.set_load(NormalLoad::Force(1.01 * force))?;
            timed(|| {
                press.solve_into(&mut pressed)?;
                Ok(counts(pressed.report()))
            })
        },
    ))
}

/// Returns the row of the mean step of a cycle of the tangential force under a constant normal force.
fn fretting_step(case: &BenchmarkCase) -> Result<Row> {
    let friction = Friction::coulomb(FRICTION)?;
    let builder = History::builder(&case.bodies, &case.gap, friction);
    let mut history = builder.tolerance(WARM).build()?;
    history.step(&LoadStep::hold().normal(NormalLoad::Force(case.force)))?;
    let amplitude = LOADING * FRICTION * case.force;
    Ok(Row::new(
        format!("fretting step to {WARM:.0e}"),
        move || {
            let cycle = timed(|| {
                let mut products = [0, 0];
                for turn in 0..STEPS {
                    let angle = f64::from(turn) * std::f64::consts::TAU / f64::from(STEPS);
                    let step = history.step(&LoadStep::force([amplitude * angle.sin(), 0.0]))?;
                    let reports = [step.normal_report(), step.tangential_report()];
                    for report in reports.into_iter().flatten() {
                        let of_report = counts(report);
                        products = [0, 1].map(|i| products[i] + of_report[i]);
                    }
                }
                Ok(products)
            })?;
            Ok(Sample {
                milliseconds: cycle.milliseconds / f64::from(STEPS),
                ..cycle
            })
        },
    ))
}

fn counts(report: &stickslip::Report) -> [usize; 2] {
    [
        report.double_precision_products,
        report.single_precision_products,
    ]
}
