//! Maps of heights, and of stick and slip.

use std::error::Error;
use std::ops::Range;

use plotters::prelude::*;
use stickslip::{Field, TangentialSolution, Zone};

use super::{BLUE, Chart, ORANGE};

const GREY: RGBColor = RGBColor(225, 225, 225);

/// Stick, slip and gap of every cell in sight, in lengths of the unit `scale`.
pub(crate) fn zones(
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
                Zone::Separated => GREY,
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

/// Blocks along the longer side of a map of heights: more would make a heavy drawing.
const BLOCKS: usize = 120;

/// Heights in shades of grey, the highest white, in lengths of the unit `scale`.
pub(crate) fn heights(
    chart: &mut Chart<'_>,
    heights: &Field,
    scale: f64,
) -> Result<(), Box<dyn Error>> {
    let grid = heights.grid();
    let (low, high) = (heights.min(), heights.max());
    let block = grid.nx().max(grid.ny()).div_ceil(BLOCKS);
    let starts = |cells: usize| (0..cells).step_by(block);
    let corners = starts(grid.ny()).flat_map(|iy| starts(grid.nx()).map(move |ix| [ix, iy]));
    // As above, a block reaches into those drawn later.
    let rectangles = corners.map(|[ix, iy]| {
        let (columns, rows) = (
            ix..(ix + block).min(grid.nx()),
            iy..(iy + block).min(grid.ny()),
        );
        let cells = || {
            rows.clone()
                .flat_map(|iy| columns.clone().filter_map(move |ix| heights.get(ix, iy)))
        };
        let mean = cells().sum::<f64>() / cells().count() as f64;
        let grey = HSLColor(0.0, 0.0, (mean - low) / (high - low));
        let edge = |ix: f64, iy: f64| {
            let (x, y) = (
                grid.x(0) + (ix - 0.5) * grid.dx(),
                grid.y(0) + (iy - 0.5) * grid.dy(),
            );
            (x / scale, y / scale)
        };
        let far = |end: usize, cells: usize| (end as f64 + 0.5 * block as f64).min(cells as f64);
        let opposite = edge(far(columns.end, grid.nx()), far(rows.end, grid.ny()));
        Rectangle::new([edge(ix as f64, iy as f64), opposite], grey.filled())
    });
    chart.draw_series(rectangles)?;
    Ok(())
}
