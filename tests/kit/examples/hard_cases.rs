//! Solves a catalogue of difficult scenes, compares them with exact solutions, and prints one table. The exit code
//! reports whether every row is correct.
//!
//! With `--write` the program also writes the table to `tests/data/hard_cases.csv`.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

use std::error::Error;
use std::fs::File;
use std::io::Write;
use std::process::ExitCode;

use kit::scenes::row::Row;
use kit::scenes::{catalogue, row};
use stickslip::Report;

const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../data/hard_cases.csv");
const COLUMNS: [&str; 9] = [
    "case",
    "part",
    "result",
    "iterations",
    "double_precision_products",
    "single_precision_products",
    "certified_bound",
    "error",
    "reference",
];

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let option = std::env::args().nth(1);
    let rows = catalogue::rows(1)?;
    match option.as_deref() {
        None => {}
        Some("--write") => write(&rows)?,
        Some(other) => return Err(format!("{other}: expected --write or nothing").into()),
    }
    println!("{}", row::HEADER);
    for row in &rows {
        println!("{row}");
    }
    let wrong = rows.iter().filter(|row| !row.is_right()).count();
    println!("\n{} solves, {wrong} wrong", rows.len());
    Ok(if wrong == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

/// Writes the results without the times, which differ between machines.
fn write(rows: &[Row]) -> Result<(), Box<dyn Error>> {
    let mut file = File::create(TABLE)?;
    writeln!(
        file,
        "# Catalogue of difficult cases. The example `hard_cases` of the package `stickslip-testkit` writes this file. Bound and\n\
         # error are relative, in the energy norm. The reference is the solution or the law with which the solve is compared."
    )?;
    let mut table = csv::Writer::from_writer(file);
    table.write_record(COLUMNS)?;
    for row in rows {
        let report = row.report.as_ref();
        let count = |value: fn(&Report) -> usize| {
            report.map_or_else(String::new, |report| value(report).to_string())
        };
        let bound = report.map(Report::energy_error_bound);
        let number = |value: Option<f64>| value.map_or_else(String::new, |v| format!("{v:.1e}"));
        table.write_record([
            row.scene.clone(),
            row.half.clone(),
            row.ending.clone(),
            count(|report| report.iterations),
            count(|report| report.double_precision_products),
            count(|report| report.single_precision_products),
            number(bound),
            number(row.error.map(|error| error.value)),
            row.error
                .map_or_else(String::new, |error| error.against.to_owned()),
        ])?;
    }
    table.flush()?;
    Ok(())
}
