//! The law of cells that enter the contact by rolling.

use crate::buffer::filled;
use crate::error::Result;
use crate::neighbours::neighbours;
use crate::normal::NormalSolution;
use crate::rolling::step::Step;
use crate::tangential::{Pressed, own_compliance};

/// The compliance of its own of a cell, a symmetric tensor.
#[derive(Debug, Clone, Copy)]
pub(super) struct Compliance {
    pub(super) xx: f64,
    pub(super) xy: f64,
    pub(super) yy: f64,
}

impl Compliance {
    pub(super) const NONE: Self = Self {
        xx: 0.0,
        xy: 0.0,
        yy: 0.0,
    };

    pub(super) fn of(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.xx * x + self.xy * y, self.xy * x + self.yy * y]
    }

    /// The mean of all directions.
    pub(super) fn mean(&self) -> f64 {
        0.5 * (self.xx + self.yy)
    }
}

/// $`B = \kappa\,g/p`$ of each cell of a window, with the gap g where its particle was before,
///
/// ```math
/// \kappa = n\,n' + \left(1 + \frac{c_l}{c_n}\right) (1 - n\,n') ,
/// ```
///
/// with the sums $`c_n`$ of $`(1-\nu)/G`$ and $`c_l`$ of $`\nu/G`$ of both bodies, and n across the edge of the contact: the surface ahead moves in plane strain across it, and in antiplane strain along it.
/// Of rough surfaces n is a matter of the mean slope: $`n\,n'`$ is that of the 3 x 3 cells around.
pub(super) fn entering(
    normal: &NormalSolution,
    pressed: &Pressed,
    step: Step,
) -> Result<Vec<Compliance>> {
    let mut own = filled(Compliance::NONE, pressed.region.cells())?;
    let (gap, window) = (normal.gap().as_slice(), pressed.window());
    let pressure = normal.pressure().as_slice();
    let compliances = normal.pair().compliances();
    let along = 1.0 + compliances.lateral / compliances.normal;
    for (cell, own) in own.iter_mut().enumerate() {
        let Some(before) = step.before(cell).map(|before| window.index(before)) else {
            continue;
        };
        let enters = pressure[before] <= 0.0 && gap[before] > 0.0;
        if enters && pressed.limits.cells[cell] > 0.0 {
            let most = own_compliance(along * gap[before], pressed.pressure[cell]);
            let [xx, xy, yy] = across(normal, before);
            let less = most * (1.0 - 1.0 / along);
            *own = Compliance {
                xx: most - less * xx,
                xy: -less * xy,
                yy: most - less * yy,
            };
        }
    }
    Ok(own)
}

/// $`n\,n'`$ by the slopes of the gap around a cell, each weighted by its square: `[xx, xy, yy]` of trace one.
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
