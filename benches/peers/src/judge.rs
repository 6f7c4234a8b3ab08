//! Error of a solution of any code relative to a reference solution.

use stickslip::influence::Component;
use stickslip::{HalfSpace, Operator};

use crate::Result;

/// Compares `[found, truth]`. Returns the relative errors in the energy norm, in the sum of absolute values, and of
/// the total force. The first two are norms of the difference, divided by the same norms of the reference.
///
/// The reference is a solution of this crate with a tolerance of 1e-11. If a code used different influence
/// coefficients, its solution would have an error that does not vanish at any tolerance.
pub(crate) fn judge(
    bodies: &HalfSpace,
    component: Component,
    [found, truth]: [&[f64]; 2],
    total: f64,
) -> Result<String> {
    let cells = bodies.grid().cells();
    if found.len() != cells || truth.len() != cells {
        return Err(format!("fields of {} and {} cells", found.len(), truth.len()).into());
    }
    let operator = bodies.operator(component)?;
    let mut workspace = operator.scratch().unwrap();
    let mut product = vec![0.0; cells];
    let mut energy = |x: &[f64]| -> f64 {
        operator.apply([x], [&mut product], &mut workspace);
        x.iter().zip(&product).map(|(x, u)| x * u).sum()
    };
    let pairs = found.iter().zip(truth);
    let difference: Vec<f64> = pairs.map(|(found, truth)| found - truth).collect();
    // Round-off can make the energy of a tiny difference negative.
    let in_energy = (energy(&difference).max(0.0) / energy(truth)).sqrt();
    let sum = |x: &[f64]| x.iter().map(|x| x.abs()).sum::<f64>();
    let in_sum = sum(&difference) / sum(truth);
    let force: f64 = found.iter().sum::<f64>() * bodies.grid().cell_area();
    let load = (force - total).abs() / total.abs();
    Ok(format!(
        r#"{{"energy": {in_energy:e}, "l1": {in_sum:e}, "load": {load:e}}}"#
    ))
}
