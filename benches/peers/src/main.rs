//! Program for the comparison of stickslip with its peers. It writes the gaps that all codes read, solves them with
//! stickslip, and computes the errors of the solutions of all codes in the same norm.
//!
//! `stickslip-bench-peers write FOLDER CELLS..` writes the gaps and prints one line of JSON for each. `stickslip-bench-peers
//! serve` reads one request per line and prints one line of JSON for each request.
//!
//! Lengths are in units of the side of the grid, and pressures are in units of the contact modulus. No code therefore
//! receives a system of units for which it was not tuned.

#![allow(
    clippy::cast_precision_loss,
    clippy::similar_names,
    reason = "as in the library"
)]

mod judge;
mod serve;

use std::error::Error;
use std::fs;
use std::path::Path;

use kit::benchmark;
use stickslip::Field;

type Result<T> = std::result::Result<T, Box<dyn Error>>;

const USAGE: &str = "usage: stickslip-bench-peers write FOLDER CELLS.. | stickslip-bench-peers serve";

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.as_slice() {
        [command] if command == "serve" => serve::serve(),
        [command, folder, sizes @ ..] if command == "write" && !sizes.is_empty() => {
            for size in sizes {
                write_scenes(Path::new(folder), size.parse()?)?;
            }
            Ok(())
        }
        _ => Err(USAGE.into()),
    }
}

/// Writes the gap of every benchmark problem on `cells` x `cells` cells, row by row, as 64-bit floats.
fn write_scenes(folder: &Path, cells: u16) -> Result<()> {
    fs::create_dir_all(folder)?;
    for scene in std::iter::once(benchmark::ball(cells)?).chain(benchmark::rough(cells)?) {
        let grid = scene.bodies.grid();
        let side = grid.dx() * f64::from(cells);
        let path = folder.join(format!("{}-{cells}.f64", scene.name.replace('%', "")));
        let gap: Vec<f64> = scene.gap.as_slice().iter().map(|gap| gap / side).collect();
        write_floats(&path, &gap)?;
        let pressure = scene.force / (grid.area() * scene.bodies.pair().contact_modulus());
        println!(
            r#"{{"scene": "{}", "cells": {cells}, "gap": "{}", "pressure": {pressure:e}, "friction": {}, "loading": {}}}"#,
            scene.name,
            path.display(),
            benchmark::FRICTION,
            benchmark::LOADING,
        );
    }
    Ok(())
}

fn write_floats(path: &Path, floats: &[f64]) -> Result<()> {
    let bytes: Vec<u8> = floats.iter().flat_map(|x| x.to_le_bytes()).collect();
    Ok(fs::write(path, bytes)?)
}

fn write_field(path: &str, field: &Field) -> Result<()> {
    write_floats(Path::new(path), field.as_slice())
}

fn read_floats(path: &str) -> Result<Vec<f64>> {
    let bytes = fs::read(path)?;
    let (floats, rest) = bytes.as_chunks::<8>();
    if !rest.is_empty() {
        return Err(format!("{path} does not hold 64-bit floats").into());
    }
    Ok(floats.iter().map(|x| f64::from_le_bytes(*x)).collect())
}
