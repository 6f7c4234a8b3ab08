//! Random difficult scenes. `campaign FIRST COUNT` solves COUNT scenes from index FIRST, verifies the solutions and
//! prints the faults. `campaign coated FIRST COUNT` uses coated bodies. `campaign kinds FIRST COUNT` uses contacts of
//! every type, and counts the outcomes of their solves.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "an example prints its results and its progress"
)]

use std::collections::BTreeMap;
use std::error::Error;
use std::process::ExitCode;

use kit::scenes::row::Row;
use kit::scenes::{campaign, kinds};
use rayon::prelude::*;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1).peekable();
    let mut takes = |kind: &str| arguments.next_if(|word| word == kind).is_some();
    let (has_kinds, is_coated) = (takes("kinds"), takes("coated"));
    let (name, rows): (&str, fn(u64) -> Vec<Row>) = match (has_kinds, is_coated) {
        (true, _) => ("campaign kinds", kinds::rows),
        (_, true) => ("campaign coated", campaign::coated_rows),
        _ => ("campaign", campaign::rows),
    };
    let mut number = |default: u64| arguments.next().map_or(Ok(default), |word| word.parse());
    let (first, count) = (number(0)?, number(200)?);

    let indices: Vec<u64> = (first..first + count).collect();
    let mut summary = Summary {
        name,
        has_kinds,
        ..Summary::default()
    };
    for part in indices.chunks(500) {
        let found: Vec<(u64, Vec<Row>)> =
            part.par_iter().map(|&index| (index, rows(index))).collect();
        for (index, rows) in found {
            for row in &rows {
                summary.add(index, row);
            }
        }
        eprintln!(
            "{} scenes, {} faults",
            part[part.len() - 1] + 1 - first,
            summary.faults
        );
    }
    println!("{summary}");
    Ok(if summary.faults == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

/// Summary of all scenes.
#[derive(Debug, Default)]
struct Summary {
    /// Words before the index in the command.
    name: &'static str,
    /// Whether endings are counted for each kind separately.
    has_kinds: bool,
    /// Number of solves with each ending, and number of products of these solves.
    endings: BTreeMap<String, [usize; 2]>,
    compared: BTreeMap<&'static str, usize>,
    /// Largest ratio of the true error to the certified error, and its scene.
    tightest: (f64, u64),
    slowest: (f64, u64),
    steps: (usize, u64),
    faults: usize,
}

impl Summary {
    fn add(&mut self, index: u64, row: &Row) {
        let ending = if self.has_kinds {
            format!("{}: {}", row.scene, row.ending)
        } else {
            row.ending.clone()
        };
        let products = row.report.as_ref().map_or(0, |report| {
            report.double_precision_products + report.single_precision_products
        });
        let [solves, sum] = self.endings.entry(ending).or_default();
        (*solves, *sum) = (*solves + 1, *sum + products);
        if let (Some(error), Some(report)) = (row.error, &row.report) {
            *self.compared.entry(error.against).or_default() += 1;
            let ratio = (error.value - error.slack).max(0.0) / report.energy_error_bound();
            if ratio > self.tightest.0 {
                self.tightest = (ratio, index);
            }
        }
        let seconds = row.time.as_secs_f64();
        if seconds > self.slowest.0 {
            self.slowest = (seconds, index);
        }
        let steps = row.report.as_ref().map_or(0, |report| report.iterations);
        if steps > self.steps.0 {
            self.steps = (steps, index);
        }
        if let Some(fault) = &row.fault {
            self.faults += 1;
            println!(
                "{} {index} 1 | {} | {} | {} | {fault}",
                self.name, row.scene, row.half, row.ending
            );
        }
    }
}

impl std::fmt::Display for Summary {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (ending, [solves, products]) in &self.endings {
            writeln!(formatter, "{solves:>8}  {ending}, {products} products")?;
        }
        for (against, count) in &self.compared {
            writeln!(formatter, "{count:>8}  compared with: {against}")?;
        }
        writeln!(
            formatter,
            "true error / certified error: at most {:.3}, scene {}",
            self.tightest.0, self.tightest.1
        )?;
        writeln!(
            formatter,
            "slowest solve: {:.2} s, scene {}",
            self.slowest.0, self.slowest.1
        )?;
        writeln!(
            formatter,
            "most steps: {}, scene {}",
            self.steps.0, self.steps.1
        )?;
        write!(formatter, "faults: {}", self.faults)
    }
}
