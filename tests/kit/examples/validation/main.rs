//! Compares the crate with closed forms and with other codes, and prints the tables of the guide's page on validation.
//!
//! With `--write` the program writes the tables to the page. With `--check` it fails if the page differs beyond rounding.
//! It always fails if a test that a row names does not exist.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

mod codes;
mod dissimilar;
mod histories;
mod normal;
mod page;
mod rolling;
mod rough;
mod row;
mod stresses;
mod tangential;

use std::error::Error;
use std::process::ExitCode;

use row::{Row, has_test};

/// Rows of one subject. The caption states the case.
pub(crate) struct Group {
    pub(crate) heading: &'static str,
    pub(crate) caption: &'static str,
    pub(crate) rows: Vec<Row>,
}

/// Computes all groups in the order of the page.
fn groups() -> Result<Vec<Group>, Box<dyn Error>> {
    Ok(vec![
        normal::group()?,
        tangential::group()?,
        histories::group()?,
        rolling::group()?,
        dissimilar::group()?,
        rough::group()?,
        stresses::group()?,
        codes::group()?,
    ])
}

/// Use of the tables.
enum Mode {
    Print,
    Write,
    Check,
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mode = match std::env::args().nth(1).as_deref() {
        None => Mode::Print,
        Some("--write") => Mode::Write,
        Some("--check") => Mode::Check,
        Some(other) => return Err(format!("{other}: expected --write, --check or nothing").into()),
    };
    let groups = groups()?;
    for row in groups.iter().flat_map(|group| &group.rows) {
        if !has_test(row.test)? {
            return Err(format!("{}: the test does not exist", row.test).into());
        }
    }
    let tables = page::tables(&groups);
    match mode {
        Mode::Print => println!("{tables}"),
        Mode::Write => page::write(&tables)?,
        Mode::Check => {
            let differences = page::differences(&tables)?;
            for difference in &differences {
                println!("{difference}");
            }
            if !differences.is_empty() {
                println!("the page is not current: run this program with --write");
                return Ok(ExitCode::FAILURE);
            }
        }
    }
    Ok(ExitCode::SUCCESS)
}
