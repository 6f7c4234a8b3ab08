//! A parameter study of rough contacts, in parts on any number of machines: a table of one row per case, which a
//! program that was killed continues.
//!
//! `cargo run --release -p stickslip-examples --example study -- --help` lists the options; without any, 24 small cases are
//! solved and written to standard output. The guide page `studies` has the columns, a script for Slurm and a line for
//! GNU parallel.

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
