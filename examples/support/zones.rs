//! Maps of stick and slip.

use std::error::Error;
use std::ops::Range;

use plotters::prelude::*;
use stickslip::{TangentialSolution, Zone};

use super::{BLUE, Chart, ORANGE};

const GREY: RGBColor = RGBColor(225, 225, 225);

/// Stick, slip and gap of every cell in sight, in lengths of the unit `scale`.
pub(crate) fn map(
    chart: &mut Chart<'_>,
    shear: &TangentialSolution,
    scale: f64,
    [x, y]: [Range<f64>; 2],
) -> Result<(), Box<dyn Error>> {
    let grid = shear.grid();
    let in_sight = |value: f64, range: &Range<f64>| value.clamp(range.start, range.end);
    // Neighbours in one zone make one rectangle. It reaches into the next row, which covers that part
    // again: no seam shows between rows.
    let mut rectangles = Vec::new();
    for (iy, row) in shear.zones().chunks_exact(grid.nx()).enumerate() {
        let edges = [-0.5, 1.5].map(|cells| (grid.y(iy) + cells * grid.dy()) / scale);
        let [bottom, top] = edges.map(|edge| in_sight(edge, &y));
        if bottom >= top {
            continue;
        }
        let mut first = 0;
        for run in row.chunk_by(|cell, next| cell == next) {
            let end = first + run.len();
            let edge = |ix| in_sight((grid.x(ix) - 0.5 * grid.dx()) / scale, &x);
            let (left, right) = (edge(first), edge(end));
            first = end;
            let colour = match run[0] {
                Zone::Stick => BLUE,
                Zone::Slip => ORANGE,
                Zone::Separate => GREY,
            };
            if left < right {
                rectangles.push(Rectangle::new(
                    [(left, bottom), (right, top)],
                    colour.filled(),
                ));
            }
        }
    }
    chart.plotting_area().fill(&GREY)?;
    chart.draw_series(rectangles)?;
    Ok(())
}
