//! Solves a catalogue of difficult scenes, compares them with exact solutions, and prints one table. The exit code
//! reports whether every row is correct.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

use std::error::Error;
use std::process::ExitCode;

use kit::scenes::{catalogue, row};

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let rows = catalogue::rows(1)?;
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
