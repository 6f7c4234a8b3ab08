//! Solves random smooth contacts to random targets, and compares the true errors with the targets. The true error is the
//! difference from a solution with a smaller target.
//!
//! `accuracy_targets FIRST COUNT` prints the scenes whose error exceeds the target, the quantiles of the ratio of both, and a
//! histogram. It fails if more than 1 % of the errors exceed their target, or if an error exceeds twice the target.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a program that prints a table of quantiles"
)]

use std::process::ExitCode;
use std::time::Instant;

use kit::scenes::targets::{ALL, KINDS, TargetScene};
use stickslip::adaptive::AdaptiveStatus;

/// Targets of the reference solutions divided by the targets of the scene.
const REFERENCE: f64 = 0.15;
/// Limits of the ratios of the histogram.
const BINS: [f64; 8] = [0.001, 0.01, 0.03, 0.1, 0.3, 1.0, 2.0, f64::INFINITY];

fn main() -> ExitCode {
    let mut numbers = std::env::args().skip(1).map(|word| word.parse::<u64>());
    let (Some(Ok(first)), Some(Ok(count))) = (numbers.next(), numbers.next()) else {
        eprintln!("usage: accuracy_targets FIRST COUNT");
        return ExitCode::FAILURE;
    };
    let mut ratios = Vec::new();
    let mut slowest = (0.0, 0);
    for seed in first..first + count {
        let outcome = TargetScene::random(seed).and_then(|scene| {
            let start = Instant::now();
            let found = scene.solve(1.0)?;
            let time = start.elapsed().as_secs_f64();
            let reference = scene.solve(REFERENCE)?;
            let error = found.difference(&reference, scene.quantity)?;
            Ok((scene, found, reference, time, error))
        });
        let (scene, found, reference, time, error) = match outcome {
            Ok(outcome) => outcome,
            Err(error) => {
                println!("scene {seed}: {error}");
                continue;
            }
        };
        if time > slowest.0 {
            slowest = (time, seed);
        }
        let ratio = error / scene.target;
        let estimate = found.estimate(scene.quantity).unwrap_or(f64::NAN);
        let is_reached = found.status() == AdaptiveStatus::Reached;
        if ratio > 1.0 || !is_reached || reference.status() != AdaptiveStatus::Reached {
            let kind = KINDS[scene.kind];
            let grids: Vec<_> = found
                .grids()
                .iter()
                .map(|record| (record.grid.nx(), record.grid.ny()))
                .collect();
            println!(
                "scene {seed}: {kind}, {:?} {:.1e}: error {error:.1e}, estimate {estimate:.1e}, {:?}, reference {:?} {:?}, {grids:?}",
                scene.quantity,
                scene.target,
                found.status(),
                reference.status(),
                reference.grid().nx()
            );
        }
        if is_reached {
            ratios.push((ratio, scene.quantity));
        }
    }
    ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    for quantity in ALL {
        let own: Vec<f64> = ratios
            .iter()
            .filter(|r| r.1 == quantity)
            .map(|r| r.0)
            .collect();
        if own.is_empty() {
            continue;
        }
        let at = |part: f64| own[((own.len() - 1) as f64 * part).round() as usize];
        let over = own.iter().filter(|ratio| **ratio > 1.0).count();
        println!(
            "{quantity:?}: {} scenes, error over target: median {:.2}, 90 % {:.2}, 99 % {:.2}, most {:.2}; {over} above",
            own.len(),
            at(0.5),
            at(0.9),
            at(0.99),
            at(1.0)
        );
    }
    let over = ratios.iter().filter(|ratio| ratio.0 > 1.0).count();
    println!(
        "{} scenes reached, {over} above the target; slowest {:.2} s, scene {}",
        ratios.len(),
        slowest.0,
        slowest.1
    );
    let mut below = 0;
    for limit in BINS {
        let count = ratios.iter().filter(|ratio| ratio.0 <= limit).count();
        println!(
            "error at most {limit} times the target: {} scenes",
            count - below
        );
        below = count;
    }
    let largest = ratios.last().map_or(0.0, |ratio| ratio.0);
    if 100 * over > ratios.len() || largest > 2.0 {
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}
