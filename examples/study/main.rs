//! A parameter study of rough contacts that can be divided between any number of machines. The result is a table with one row per
//! case. A restarted program continues the table.
//!
//! `cargo run --release -p stickslip-examples --example study -- --help` lists the options; without options, 24 small cases are
//! solved and written to standard output. The guide page `studies` describes the columns and contains a script for Slurm and a
//! command for GNU parallel.

mod command;

use std::process::ExitCode;

use command::Failure;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match command::run(&words) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            command::complain(&failure);
            match failure {
                Failure::Arguments(_) => ExitCode::from(2),
                _ => ExitCode::FAILURE,
            }
        }
    }
}
