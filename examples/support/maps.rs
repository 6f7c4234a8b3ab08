//! Maps of heights, of other fields in colour, of stick and slip zones, and of contact spots.

use std::error::Error;
use std::ops::Range;

use plotters::prelude::*;
use plotters::style::text_anchor::VPos;
use stickslip::{ContactSpots, Field, Grid, Zone};

use super::axis::Axis;
use super::{
    ABOVE, Area, BELOW, BLUE, Chart, GREEN, LETTERS, NAME, ORANGE, PURPLE, axes_of, equal_scale,
    upright,
};

/// Colour of cells without contact.
const GREY: RGBColor = RGBColor(225, 225, 225);

/// Returns the key of a map of zones, without zones that do not occur.
pub(crate) fn zones_key(zones: &[Zone]) -> Vec<(RGBColor, &'static str)> {
    let names = [
        (Zone::Stick, BLUE, "stick"),
        (Zone::Slip, ORANGE, "slip"),
        (Zone::Separated, GREY, "no contact"),
    ];
    let present = names.into_iter().filter(|(zone, ..)| zones.contains(zone));
    present.map(|(_, colour, name)| (colour, name)).collect()
}

/// Draws stick, slip and separation of every visible cell, with lengths in units of `scale`.
pub(crate) fn zones(
    chart: &mut Chart<'_>,
    grid: Grid,
    zones: &[Zone],
    scale: f64,
    [x, y]: [Range<f64>; 2],
) -> Result<(), Box<dyn Error>> {
    let colours = zones.iter().map(|zone| match zone {
        Zone::Stick => BLUE,
        Zone::Slip => ORANGE,
        Zone::Separated => GREY,
    });
    cells(chart, grid, &colours.collect::<Vec<_>>(), scale, [x, y])
}

/// Draws contact spots. Spots whose centres are near each other have different colours.
pub(crate) fn spots(
    chart: &mut Chart<'_>,
    spots: &ContactSpots,
    scale: f64,
    sight: [Range<f64>; 2],
) -> Result<(), Box<dyn Error>> {
    const COLOURS: [RGBColor; 6] = [
        BLUE,
        ORANGE,
        GREEN,
        PURPLE,
        RGBColor(200, 40, 60),
        RGBColor(90, 60, 30),
    ];
    let centres = spots.as_slice().iter().map(|spot| spot.centroid);
    let centres: Vec<[f64; 2]> = centres.collect();
    // Each spot receives the colour whose nearest spot is the farthest.
    let mut chosen: Vec<usize> = Vec::new();
    for centre in &centres {
        let nearest = |colour: &usize| {
            let alike = chosen.iter().zip(&centres).filter(|(c, _)| *c == colour);
            let distances = alike.map(|(_, of)| (of[0] - centre[0]).hypot(of[1] - centre[1]));
            distances.fold(f64::INFINITY, f64::min)
        };
        let best = (0..COLOURS.len())
            .rev()
            .max_by(|a, b| nearest(a).total_cmp(&nearest(b)));
        chosen.push(best.unwrap_or_default());
    }
    let colours = spots.labels().iter().map(|&label| match label {
        0 => GREY,
        label => COLOURS[chosen[label as usize - 1]],
    });
    cells(
        chart,
        spots.grid(),
        &colours.collect::<Vec<_>>(),
        scale,
        sight,
    )
}

/// Draws every visible cell in its colour, with lengths in units of `scale`.
fn cells(
    chart: &mut Chart<'_>,
    grid: Grid,
    colours: &[RGBColor],
    scale: f64,
    [x, y]: [Range<f64>; 2],
) -> Result<(), Box<dyn Error>> {
    let in_sight = |value: f64, range: &Range<f64>| value.clamp(range.start, range.end);
    // Adjacent cells of the same colour form one rectangle. It overlaps the next row, which is drawn over it, so that no
    // seam is visible between rows.
    let mut rectangles = Vec::new();
    for (iy, row) in colours.chunks_exact(grid.nx()).enumerate() {
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
            if left < right {
                rectangles.push(Rectangle::new(
                    [(left, bottom), (right, top)],
                    run[0].filled(),
                ));
            }
        }
    }
    chart.plotting_area().fill(&GREY)?;
    chart.draw_series(rectangles)?;
    Ok(())
}

/// Maximum number of blocks along the longer side of a map of a field, which limits the size of the file.
const BLOCKS: usize = 200;

/// Function from a number between 0 and 1 to a colour.
pub(crate) type Colours = fn(f64) -> RGBColor;

/// Scale of the values of a map and of its colour bar.
#[derive(Clone, Copy)]
pub(crate) struct Scale {
    colours: Colours,
    low: f64,
    high: f64,
    /// Width of bands of equal colour, or zero.
    band: f64,
}

impl Scale {
    /// Returns a scale from zero, for values without sign.
    pub(crate) fn from_zero(colours: Colours, high: f64) -> Self {
        let (low, band) = (0.0, 0.0);
        Self {
            colours,
            low,
            high,
            band,
        }
    }

    /// Returns a scale with zero in the middle, for values with a sign.
    pub(crate) fn around_zero(most: f64) -> Self {
        Self {
            colours: diverging,
            low: -most,
            high: most,
            band: 0.0,
        }
    }

    /// Divides the values into bands of equal colour, whose edges form contours.
    pub(crate) fn in_bands(self, band: f64) -> Self {
        Self { band, ..self }
    }

    /// Returns the colour of a value.
    pub(crate) fn colour(self, value: f64) -> RGBColor {
        let value = if self.band > 0.0 {
            ((value / self.band).floor() + 0.5) * self.band
        } else {
            value
        };
        (self.colours)((value - self.low) / (self.high - self.low))
    }
}

/// Colour scale from blue through pale grey to dark red.
fn diverging(value: f64) -> RGBColor {
    if value < 0.5 {
        mix([(20, 60, 140), (240, 240, 240)], 2.0 * value)
    } else {
        mix([(240, 240, 240), (150, 20, 30)], 2.0 * value - 1.0)
    }
}

/// Colour scale from white to black.
pub(crate) fn dark(value: f64) -> RGBColor {
    mix([(255, 255, 255), (0, 0, 0)], value)
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

/// Draws axes of equal scale and a colour bar of the same height to their right, as large as the area permits; `name` is the
/// label of the bar.
pub(crate) fn axes_and_bar<'a>(
    area: &Area<'a>,
    sides: [(Range<f64>, &str); 2],
    bar: (Scale, &str),
) -> Result<Chart<'a>, Box<dyn Error>> {
    let sides = sides.map(|(range, name)| (Axis::linear(range), name));
    axes_and_bar_of(area, sides, bar)
}

/// Draws axes as [`axes_and_bar`], with other ticks or labels.
pub(crate) fn axes_and_bar_of<'a>(
    area: &Area<'a>,
    [x, y]: [(Axis, &str); 2],
    (scale, name): (Scale, &str),
) -> Result<Chart<'a>, Box<dyn Error>> {
    let (map, _) = area.split_horizontally(area.dim_in_pixel().0 - BAR);
    let map = equal_scale(&map, [x.0.ends(), y.0.ends()]);
    let (width, height) = map.dim_in_pixel();
    let (_, rest) = area.split_horizontally(width);
    let (rest, _) = rest.split_vertically(height);
    let (place, _) = rest.split_horizontally(BAR);
    bar(&place, scale, name)?;
    axes_of(&map, x, y)
}

/// Width of a colour bar with its labels.
pub(crate) const BAR: u32 = 290;
/// Width of the labels of a colour bar.
const BAR_LABELS: u32 = 230;

/// Draws a colour bar with the name of the quantity.
fn bar(area: &Area<'_>, scale: Scale, name: &str) -> Result<(), Box<dyn Error>> {
    const STEPS: u32 = 128;
    let Scale { low, high, .. } = scale;
    let (x, y) = (Axis::without_ticks(0.0..1.0), Axis::linear(low..high));
    let label_width = y.label_width();
    let mut chart = ChartBuilder::on(area)
        .margin_top(ABOVE)
        .margin_bottom(BELOW)
        .right_y_label_area_size(BAR_LABELS)
        .build_cartesian_2d(x, y)?;
    let value = |step: u32| f64::from(step) / f64::from(STEPS);
    // Each rectangle is covered by the next, so that no seam is visible.
    let rectangles = (0..STEPS).map(|step| {
        let start = low + value(step) * (high - low);
        let colour = scale.colour(start + 0.5 * (high - low) / f64::from(STEPS));
        Rectangle::new([(0.0, start), (1.0, high)], colour.filled())
    });
    chart.draw_series(rectangles)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .axis_style(BLACK.stroke_width(3))
        .set_all_tick_mark_size(10)
        .label_style(("sans-serif", LETTERS - 2))
        .draw()?;
    let height = i32::try_from(area.dim_in_pixel().1 - BELOW + ABOVE)?;
    let beside = i32::try_from(BAR - BAR_LABELS)? + NAME + label_width;
    area.draw_text(name, &upright(VPos::Top), (beside, height / 2))?;
    Ok(())
}

/// Draws a field in colours, with lengths in units of `length` and values in units of `unit`.
pub(crate) fn field(
    chart: &mut Chart<'_>,
    values: &Field,
    [length, unit]: [f64; 2],
    scale: Scale,
) -> Result<(), Box<dyn Error>> {
    let grid = values.grid();
    let block = grid.nx().max(grid.ny()).div_ceil(BLOCKS);
    let starts = |cells: usize| (0..cells).step_by(block);
    let ends = |start: usize, cells: usize| start..(start + block).min(cells);
    let mean = |columns: Range<usize>, rows: Range<usize>| {
        let count = columns.len() * rows.len();
        let row = |iy| columns.clone().filter_map(move |ix| values.get(ix, iy));
        rows.flat_map(row).sum::<f64>() / count as f64
    };
    let corner = |ix: f64, iy: f64| {
        let x = grid.x(0) + (ix - 0.5) * grid.dx();
        let y = grid.y(0) + (iy - 0.5) * grid.dy();
        (x / length, y / length)
    };
    let mut rectangles = Vec::new();
    for iy in starts(grid.ny()) {
        let rows = ends(iy, grid.ny());
        // As above, a block overlaps the next blocks, which are drawn over it.
        let beyond = |end: usize, cells: usize| (end as f64 + 0.5 * block as f64).min(cells as f64);
        let top = beyond(rows.end, grid.ny());
        let colour = |ix| scale.colour(mean(ends(ix, grid.nx()), rows.clone()) / unit);
        let colours: Vec<_> = starts(grid.nx()).map(|ix| (ix, colour(ix))).collect();
        for run in colours.chunk_by(|block, next| block.1 == next.1) {
            let (first, last) = (run[0], run[run.len() - 1]);
            let right = beyond(ends(last.0, grid.nx()).end, grid.nx());
            let corners = [corner(first.0 as f64, iy as f64), corner(right, top)];
            rectangles.push(Rectangle::new(corners, first.1.filled()));
        }
    }
    chart.draw_series(rectangles)?;
    Ok(())
}
