//! The entry rule of rolling: the compliance of cells that come into contact in a step.

use crate::grid::neighbours::neighbours;
use crate::normal::NormalSolution;
use crate::rolling::WindowShift;
use crate::tangential::{
    EntryCompliance, PressureOnWindow, entry_compliance, ratios_of_compliances,
};

/// Returns the entry compliance $`B = \kappa\,g/p`$ of a cell. Here p is the pressure of the cell. The gap g belongs to
/// its particle at the previous position, the cell `before`. The factor is
///
/// ```math
/// \kappa = n\,n' + \left(1 + \frac{c_l}{c_n}\right) (1 - n\,n') ,
/// ```
///
/// with the sums $`c_n`$ of $`(1-\nu)/G`$ and $`c_l`$ of $`\nu/G`$ of both bodies. The unit vector n is normal to the
/// contact edge at the cell `before`. The surface ahead of the contact moves in plane strain across the edge and in
/// antiplane strain along it. For coated bodies, $`C_l/C_n`$ and $`C_t/C_n`$ of waves two cells long replace 1 and
/// $`1 + c_l/c_n`$. For rough surfaces n follows the mean slope: $`n\,n'`$ is an average over the surrounding 3 x 3 cells.
pub(crate) fn compliance(
    normal: &NormalSolution,
    before: usize,
    gap: f64,
    pressure: f64,
) -> EntryCompliance {
    if gap <= 0.0 || pressure <= 0.0 {
        return EntryCompliance::NONE;
    }
    let [through, along] = ratios_of_compliances(normal.pair(), normal.grid());
    let most = entry_compliance(along * gap, pressure);
    let [xx, xy, yy] = across(normal, before);
    let less = most * (1.0 - through / along);
    EntryCompliance {
        xx: most - less * xx,
        xy: -less * xy,
        yy: most - less * yy,
    }
}

/// Writes the entry compliance of each cell of a window under a constant pressure.
pub(crate) fn entering(
    normal: &NormalSolution,
    pressed: &PressureOnWindow,
    step: WindowShift,
    own: &mut [EntryCompliance],
) {
    own.fill(EntryCompliance::NONE);
    let (gap, window) = (normal.gap().as_slice(), pressed.window());
    let pressure = normal.pressure().as_slice();
    for (cell, own) in own.iter_mut().enumerate() {
        let Some(before) = step.before(cell).map(|before| window.index(before)) else {
            continue;
        };
        if pressure[before] <= 0.0 && pressed.pressure[cell] > 0.0 {
            *own = compliance(normal, before, gap[before], pressed.pressure[cell]);
        }
    }
}

/// Returns $`n\,n'`$ as `[xx, xy, yy]` with trace one. It is the mean over the slopes of the gap around a cell, weighted
/// by the squares of the slopes.
fn across(normal: &NormalSolution, cell: usize) -> [f64; 3] {
    let grid = normal.grid();
    let (size, repeats) = (grid.size(), normal.boundary().repeats());
    let gap = normal.gap().as_slice();
    let slope = |at: usize| {
        let [west, south, east, north] = neighbours(at, size, repeats);
        let along = |one: Option<usize>, other: Option<usize>, side: f64| {
            let spacings = [one, other].iter().flatten().count().max(1);
            let [one, other] = [one, other].map(|next| gap[next.unwrap_or(at)]);
            (other - one) / (side * spacings as f64)
        };
        [along(west, east, grid.dx()), along(south, north, grid.dy())]
    };
    let mut sum = [0.0; 3];
    let [west, _, east, _] = neighbours(cell, size, repeats);
    for column in [west, Some(cell), east].into_iter().flatten() {
        let [_, south, _, north] = neighbours(column, size, repeats);
        for at in [south, Some(column), north].into_iter().flatten() {
            let [x, y] = slope(at);
            for (sum, part) in sum.iter_mut().zip([x * x, x * y, y * y]) {
                *sum += part;
            }
        }
    }
    let trace = sum[0] + sum[2];
    if trace > 0.0 && trace.is_finite() {
        sum.map(|part| part / trace)
    } else {
        [0.5, 0.0, 0.5]
    }
}
