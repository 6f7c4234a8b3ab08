//! Time and true error of a solve.

use std::time::{Duration, Instant};

use stickslip::influence::Component;
use stickslip::{Error, Field, HalfSpace, Operator, Result};

/// Number of solves, of which the fastest counts.
const REPEATS: usize = 3;
/// Total time after which no further repeat starts.
const PATIENCE: Duration = Duration::from_secs(10);

/// Returns the shortest time of a few solves, in milliseconds. A solve that does not converge is run once only, and its
/// report states the status.
pub fn fastest(mut solve: impl FnMut() -> Result<()>) -> Result<f64> {
    let mut least = f64::INFINITY;
    let first = Instant::now();
    for _ in 0..REPEATS {
        let start = Instant::now();
        let outcome = solve();
        least = least.min(1e3 * start.elapsed().as_secs_f64());
        match outcome {
            Ok(()) if first.elapsed() < PATIENCE => {}
            Ok(()) | Err(Error::NotConverged(_)) => break,
            Err(error) => return Err(error),
        }
    }
    Ok(least)
}

/// Returns the sum of all absolute differences divided by the sum of the absolute true values.
pub fn distance(found: &Field, truth: &Field) -> f64 {
    let pairs = found.as_slice().iter().zip(truth.as_slice());
    let difference: f64 = pairs.map(|(found, truth)| (found - truth).abs()).sum();
    difference
        / truth
            .as_slice()
            .iter()
            .map(|truth| truth.abs())
            .sum::<f64>()
}

/// Returns the energy norm of the difference divided by the energy norm of the solution found, as in the certified
/// bound.
pub fn energy_error(
    bodies: &HalfSpace,
    component: Component,
    found: &Field,
    truth: &Field,
) -> Result<f64> {
    let operator = bodies.operator(component)?;
    let mut workspace = operator.scratch().unwrap();
    let mut product = vec![0.0; operator.cells()];
    let mut energy = |x: &[f64]| -> f64 {
        operator.apply([x], [&mut product], &mut workspace);
        x.iter().zip(&product).map(|(x, u)| x * u).sum()
    };
    let pairs = found.as_slice().iter().zip(truth.as_slice());
    let difference: Vec<f64> = pairs.map(|(found, truth)| found - truth).collect();
    // Round-off may make the energy of a tiny difference negative.
    Ok((energy(&difference).max(0.0) / energy(found.as_slice())).sqrt())
}
