//! Maps of heights, of other fields in colour, and of stick and slip zones.

use std::error::Error;
use std::ops::Range;

use plotters::prelude::*;
use stickslip::{Field, Grid, Zone};

use super::{Area, BLUE, Chart, ORANGE, labelled_axes, ticks};

const GREY: RGBColor = RGBColor(225, 225, 225);

/// Draws stick, slip and separation of every visible cell, with lengths in units of `scale`.
pub(crate) fn zones(
    chart: &mut Chart<'_>,
    grid: Grid,
    zones: &[Zone],
    scale: f64,
    [x, y]: [Range<f64>; 2],
) -> Result<(), Box<dyn Error>> {
    let in_sight = |value: f64, range: &Range<f64>| value.clamp(range.start, range.end);
    // Adjacent cells of the same zone form one rectangle. It overlaps the next row, which is drawn over it, so that no
    // seam is visible between rows.
    let mut rectangles = Vec::new();
    for (iy, row) in zones.chunks_exact(grid.nx()).enumerate() {
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

/// Maximum number of blocks along the longer side of a map of a field, which limits the size of the file.
const BLOCKS: usize = 120;

/// Colours of a map; the arguments 0 and 1 correspond to the smallest and the largest value.
pub(crate) type Colours = fn(f64) -> RGBColor;

/// Colour scale from black to white.
pub(crate) fn grey(value: f64) -> RGBColor {
    mix([(0, 0, 0), (255, 255, 255)], value)
}

/// Colour scale from white to black.
pub(crate) fn dark(value: f64) -> RGBColor {
    grey(1.0 - value)
}

/// Colour scale from pale grey through orange to dark red. Unloaded cells are pale.
pub(crate) fn heat(value: f64) -> RGBColor {
    if value < 0.5 {
        mix([(235, 235, 235), (240, 150, 40)], 2.0 * value)
    } else {
        mix([(240, 150, 40), (120, 0, 20)], 2.0 * value - 1.0)
    }
}

fn mix([a, b]: [(u8, u8, u8); 2], part: f64) -> RGBColor {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between two bytes"
    )]
    let between =
        |a: u8, b: u8| (f64::from(a) + part.clamp(0.0, 1.0) * (f64::from(b) - f64::from(a))) as u8;
    RGBColor(between(a.0, b.0), between(a.1, b.1), between(a.2, b.2))
}

/// Draws a colour bar in an area, with the values from `low` to `high` and the name of the quantity.
pub(crate) fn bar(
    area: &Area<'_>,
    colours: Colours,
    [low, high]: [f64; 2],
    name: &str,
) -> Result<(), Box<dyn Error>> {
    const STEPS: u32 = 64;
    let format = ticks(&(low..high));
    let (x, y) = ((0.0..1.0, ""), (low..high, name));
    let mut chart = labelled_axes(area, x, y, [0, 7], [&format; 2])?;
    let value = |step: u32| f64::from(step) / f64::from(STEPS);
    let rectangles = (0..STEPS).map(|step| {
        let ends = [step, step + 1].map(|step| low + value(step) * (high - low));
        let colour = colours(value(step) + 0.5 / f64::from(STEPS));
        Rectangle::new([(0.0, ends[0]), (1.0, ends[1])], colour.filled())
    });
    chart.draw_series(rectangles)?;
    Ok(())
}

/// Draws a field in colours, with lengths in units of `scale`.
pub(crate) fn field(
    chart: &mut Chart<'_>,
    heights: &Field,
    scale: f64,
    colours: Colours,
) -> Result<(), Box<dyn Error>> {
    let grid = heights.grid();
    let (low, high) = (heights.min(), heights.max());
    let block = grid.nx().max(grid.ny()).div_ceil(BLOCKS);
    let starts = |cells: usize| (0..cells).step_by(block);
    let corners = starts(grid.ny()).flat_map(|iy| starts(grid.nx()).map(move |ix| [ix, iy]));
    // As above, a block overlaps the blocks drawn later.
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
        let colour = colours((mean - low) / (high - low));
        let edge = |ix: f64, iy: f64| {
            let (x, y) = (
                grid.x(0) + (ix - 0.5) * grid.dx(),
                grid.y(0) + (iy - 0.5) * grid.dy(),
            );
            (x / scale, y / scale)
        };
        let far = |end: usize, cells: usize| (end as f64 + 0.5 * block as f64).min(cells as f64);
        let opposite = edge(far(columns.end, grid.nx()), far(rows.end, grid.ny()));
        Rectangle::new([edge(ix as f64, iy as f64), opposite], colour.filled())
    });
    chart.draw_series(rectangles)?;
    Ok(())
}
