//! Common style of axes, lines, points and legends for the examples.
//!
//! Drawings are about 2900 units wide for two panels, so that rounding to whole units is invisible. At 800 pixels the letters
//! are 12 pixels high or more.

#![allow(dead_code, reason = "no example needs all of it")]

pub(crate) mod axis;
pub(crate) mod maps;

use std::error::Error;
use std::ops::Range;
use std::path::{Path, PathBuf};

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use axis::Axis;

/// Part of a figure that contains one chart.
pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// Chart with two axes.
pub(crate) type Chart<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<Axis, Axis>>;

pub(crate) const BLUE: RGBColor = RGBColor(0, 90, 160);
pub(crate) const ORANGE: RGBColor = RGBColor(230, 120, 20);
pub(crate) const GREEN: RGBColor = RGBColor(20, 140, 90);
pub(crate) const PURPLE: RGBColor = RGBColor(130, 60, 150);

/// Width of a panel; a figure has one or two of them side by side.
pub(crate) const PANEL: u32 = 1440;
/// Height of the title of a figure.
pub(crate) const TITLE: u32 = 120;
/// Height of the letters.
pub(crate) const LETTERS: u32 = 60;
/// Width of a line.
pub(crate) const STROKE: u32 = 6;
/// Radius of a point.
pub(crate) const DOT: i32 = 11;
/// Length of the sample of a line in a legend.
const SAMPLE: i32 = 80;
/// Width that a legend reserves for samples.
const SAMPLES: u32 = 100;

/// Margins and labels of a chart: left, right, above and below.
const LEFT: u32 = 20 + Y_LABELS;
const RIGHT: u32 = 50;
const ABOVE: u32 = 30;
const BELOW: u32 = 10 + X_LABELS;
const Y_LABELS: u32 = 210;
const X_LABELS: u32 = 138;
/// Distance between the labels of ticks and the name of an axis, and the tick.
const NAME: i32 = 36;

/// Returns the path of the file `name` in `target/gallery`, and creates the folder if necessary.
pub(crate) fn gallery(name: &str) -> Result<PathBuf, std::io::Error> {
    let folder = Path::new("target").join("gallery");
    std::fs::create_dir_all(&folder)?;
    Ok(folder.join(name))
}

/// Creates an empty figure with a title, and returns the area below the title.
pub(crate) fn figure<'a>(
    path: &'a Path,
    size: (u32, u32),
    title: &str,
) -> Result<Area<'a>, Box<dyn Error>> {
    let area = SVGBackend::new(path, size).into_drawing_area();
    area.fill(&WHITE)?;
    headed(&area, title, (LETTERS + 6, TITLE))
}

/// Draws a heading, and returns the area below it.
pub(crate) fn heading<'a>(area: &Area<'a>, text: &str) -> Result<Area<'a>, Box<dyn Error>> {
    headed(area, text, (LETTERS - 2, 80))
}

fn headed<'a>(
    area: &Area<'a>,
    text: &str,
    (letters, height): (u32, u32),
) -> Result<Area<'a>, Box<dyn Error>> {
    let style = ("sans-serif", letters).into_font().color(&BLACK);
    let style = style.pos(Pos::new(HPos::Center, VPos::Center));
    let middle = (width(area) / 2, i32::try_from(height)? / 2);
    area.draw_text(text, &style, middle)?;
    Ok(area.margin(height, 0, 0, 0))
}

/// Returns the width of an area.
fn width(area: &Area<'_>) -> i32 {
    area.get_pixel_range()
        .0
        .len()
        .try_into()
        .unwrap_or(i32::MAX)
}

/// Draws a row of coloured squares with names above the rest of an area, and returns the rest.
pub(crate) fn key<'a>(
    area: &Area<'a>,
    entries: &[(RGBColor, &str)],
) -> Result<Area<'a>, Box<dyn Error>> {
    const HEIGHT: i32 = 80;
    const SQUARE: i32 = 40;
    // A letter is about half as wide as high; SVG files contain no exact widths.
    let entry_width =
        |name: &str| 2 * SQUARE + 28 * i32::try_from(name.chars().count()).unwrap_or(0);
    let style = ("sans-serif", LETTERS - 2).into_font().color(&BLACK);
    let style = style.pos(Pos::new(HPos::Left, VPos::Center));
    let total: i32 = entries.iter().map(|(_, name)| entry_width(name)).sum();
    let mut left = (width(area) - total + SQUARE) / 2;
    for (colour, name) in entries {
        let corners = [
            (left, (HEIGHT - SQUARE) / 2),
            (left + SQUARE, (HEIGHT + SQUARE) / 2),
        ];
        area.draw(&Rectangle::new(corners, colour.filled()))?;
        area.draw_text(name, &style, (left + SQUARE + 15, HEIGHT / 2))?;
        left += entry_width(name);
    }
    Ok(area.margin(HEIGHT, 0, 0, 0))
}

/// Draws axes with labels in an area; `x` and `y` are the ranges and labels.
pub(crate) fn axes<'a>(
    area: &Area<'a>,
    x: (Range<f64>, &str),
    y: (Range<f64>, &str),
) -> Result<Chart<'a>, Box<dyn Error>> {
    axes_of(area, (Axis::linear(x.0), x.1), (Axis::linear(y.0), y.1))
}

/// Draws axes for decimal logarithms; the ranges are ranges of exponents.
pub(crate) fn decades<'a>(
    area: &Area<'a>,
    x: (Range<f64>, &str),
    y: (Range<f64>, &str),
) -> Result<Chart<'a>, Box<dyn Error>> {
    axes_of(area, (Axis::decades(x.0), x.1), (Axis::decades(y.0), y.1))
}

/// Draws axes of equal scale, as large as the area permits; the right or the lower part of the area remains empty.
pub(crate) fn map_axes<'a>(
    area: &Area<'a>,
    x: (Range<f64>, &str),
    y: (Range<f64>, &str),
) -> Result<Chart<'a>, Box<dyn Error>> {
    let area = equal_scale(area, [&x.0, &y.0].map(|range| [range.start, range.end]));
    axes(&area, x, y)
}

/// Returns the upper left part of an area in which both axes of a chart have the same scale.
fn equal_scale<'a>(area: &Area<'a>, ends: [[f64; 2]; 2]) -> Area<'a> {
    let (width, height) = area.dim_in_pixel();
    let room = [width - LEFT - RIGHT, height - ABOVE - BELOW].map(f64::from);
    let spans = ends.map(|[start, end]| end - start);
    let scale = (room[0] / spans[0]).min(room[1] / spans[1]);
    #[expect(clippy::cast_possible_truncation, reason = "pixels of a drawing")]
    let [right, below] = [0, 1].map(|axis| (room[axis] - scale * spans[axis]) as i32);
    area.margin(0, below, 0, right)
}

/// Draws axes with labels in an area.
pub(crate) fn axes_of<'a>(
    area: &Area<'a>,
    x: (Axis, &str),
    y: (Axis, &str),
) -> Result<Chart<'a>, Box<dyn Error>> {
    let x = (x.0.fitted(width(area) - i32::try_from(LEFT + RIGHT)?), x.1);
    let faint = [&x.0, &y.0].map(|axis| axis.between().to_vec());
    let ends = [&x.0, &y.0].map(Axis::ends);
    let height = i32::try_from(area.dim_in_pixel().1 - BELOW + ABOVE)?;
    let beside = i32::try_from(LEFT)? - NAME - y.0.label_width();
    area.draw_text(y.1, &upright(VPos::Bottom), (beside, height / 2))?;
    let mut chart = ChartBuilder::on(area)
        .margin_left(LEFT - Y_LABELS)
        .margin_right(RIGHT)
        .margin_top(ABOVE)
        .margin_bottom(BELOW - X_LABELS)
        .x_label_area_size(X_LABELS)
        .y_label_area_size(Y_LABELS)
        .build_cartesian_2d(x.0, y.0)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.15).stroke_width(2))
        .axis_style(BLACK.stroke_width(3))
        .set_all_tick_mark_size(10)
        .x_desc(x.1)
        .label_style(("sans-serif", LETTERS - 2))
        .axis_desc_style(("sans-serif", LETTERS))
        .draw()?;
    let [[left, right], [bottom, top]] = ends;
    let vertical = faint[0].iter().map(|&x| [(x, bottom), (x, top)]);
    let level = faint[1].iter().map(|&y| [(left, y), (right, y)]);
    let lines = vertical
        .chain(level)
        .map(|ends| PathElement::new(ends, BLACK.mix(0.06).stroke_width(2)));
    chart.draw_series(lines)?;
    Ok(chart)
}

/// Returns the style of the name of a vertical axis, which is read upwards. The position is a side of the text.
fn upright(side: VPos) -> TextStyle<'static> {
    let style = ("sans-serif", LETTERS).into_font();
    let style = style.transform(FontTransform::Rotate270).color(&BLACK);
    style.pos(Pos::new(HPos::Center, side))
}

/// Returns the style of the line of a curve.
pub(crate) fn stroke(colour: RGBColor) -> ShapeStyle {
    colour.stroke_width(STROKE)
}

/// Draws a line through points.
pub(crate) fn line(
    chart: &mut Chart<'_>,
    name: &str,
    colour: RGBColor,
    points: impl IntoIterator<Item = (f64, f64)>,
) -> Result<(), Box<dyn Error>> {
    chart
        .draw_series(LineSeries::new(points, stroke(colour)))?
        .label(name)
        .legend(move |(x, y)| PathElement::new([(x, y), (x + SAMPLE, y)], stroke(colour)));
    Ok(())
}

/// Heading of charts that [`compare`].
pub(crate) const COMPARED: &str = "lines: closed form; points: computed";

/// Draws the closed form of a quantity as a line and its computed values as points.
pub(crate) fn compare(
    chart: &mut Chart<'_>,
    name: &str,
    colour: RGBColor,
    closed_form: impl IntoIterator<Item = (f64, f64)>,
    computed: impl IntoIterator<Item = (f64, f64)>,
) -> Result<(), Box<dyn Error>> {
    chart.draw_series(LineSeries::new(closed_form, stroke(colour)))?;
    let point = move |at| Circle::new(at, DOT, colour.filled());
    chart
        .draw_series(computed.into_iter().map(point))?
        .label(name)
        .legend(move |at| {
            EmptyElement::at(at)
                + PathElement::new([(0, 0), (SAMPLE, 0)], stroke(colour))
                + Circle::new((SAMPLE / 2, 0), DOT, colour.filled())
        });
    Ok(())
}

/// Draws full points on a line, or hollow points on a dashed line. A curve without a name is not part of the legend.
pub(crate) fn curve(
    chart: &mut Chart<'_>,
    name: &str,
    (colour, is_full): (RGBColor, bool),
    points: &[(f64, f64)],
) -> Result<(), Box<dyn Error>> {
    let line = stroke(colour);
    let inside = if is_full { colour } else { WHITE };
    let points = points.iter().copied();
    if is_full {
        chart.draw_series(LineSeries::new(points.clone(), line))?;
    } else {
        chart.draw_series(DashedLineSeries::new(points.clone(), 18, 14, line))?;
    }
    let filled = move |at| Circle::new(at, DOT, inside.filled());
    let outlined = move |at| Circle::new(at, DOT, line);
    chart.draw_series(points.clone().map(filled))?;
    let series = chart.draw_series(points.map(outlined))?;
    if !name.is_empty() {
        series.label(name).legend(move |at| {
            EmptyElement::at(at)
                + PathElement::new([(0, 0), (SAMPLE, 0)], line)
                + Circle::new((SAMPLE / 2, 0), DOT, inside.filled())
                + Circle::new((SAMPLE / 2, 0), DOT, line)
        });
    }
    Ok(())
}

/// Draws points without a line, full or hollow.
pub(crate) fn dots(
    chart: &mut Chart<'_>,
    name: &str,
    (colour, is_full): (RGBColor, bool),
    points: impl IntoIterator<Item = (f64, f64)>,
) -> Result<(), Box<dyn Error>> {
    let inside = if is_full { colour } else { WHITE };
    let dot = move |at| {
        EmptyElement::at(at)
            + Circle::new((0, 0), DOT, inside.filled())
            + Circle::new((0, 0), DOT, stroke(colour))
    };
    chart
        .draw_series(points.into_iter().map(dot))?
        .label(name)
        .legend(move |(x, y)| {
            EmptyElement::at((x + SAMPLE / 2, y))
                + Circle::new((0, 0), DOT, inside.filled())
                + Circle::new((0, 0), DOT, stroke(colour))
        });
    Ok(())
}

/// Draws a law as a thin black line.
pub(crate) fn law(
    chart: &mut Chart<'_>,
    name: &str,
    is_full: bool,
    points: impl IntoIterator<Item = (f64, f64)>,
) -> Result<(), Box<dyn Error>> {
    let line = BLACK.stroke_width(4);
    let points: Vec<_> = points.into_iter().collect();
    if is_full {
        let series = LineSeries::new(points, line);
        chart
            .draw_series(series)?
            .label(name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + SAMPLE, y)], line));
    } else {
        let series = DashedLineSeries::new(points, 18, 14, line);
        chart
            .draw_series(series)?
            .label(name)
            .legend(move |(x, y)| {
                let dash = |from, to| PathElement::new([(from, 0), (to, 0)], line);
                EmptyElement::at((x, y)) + dash(0, 20) + dash(30, 50) + dash(60, SAMPLE)
            });
    }
    Ok(())
}

/// Draws a wide grey line as a marker.
pub(crate) fn mark(
    chart: &mut Chart<'_>,
    name: &str,
    ends: [(f64, f64); 2],
) -> Result<(), Box<dyn Error>> {
    let line = BLACK.mix(0.3).stroke_width(16);
    chart
        .draw_series([PathElement::new(ends, line)])?
        .label(name)
        .legend(move |(x, y)| PathElement::new([(x, y), (x + SAMPLE, y)], line));
    Ok(())
}

/// Draws the legend of all series drawn so far.
pub(crate) fn legend(
    chart: &mut Chart<'_>,
    position: SeriesLabelPosition,
) -> Result<(), Box<dyn Error>> {
    chart
        .configure_series_labels()
        .position(position)
        .legend_area_size(SAMPLES)
        .margin(25)
        .background_style(WHITE.mix(0.9))
        .border_style(BLACK.mix(0.3).stroke_width(2))
        .label_font(("sans-serif", LETTERS - 2))
        .draw()?;
    Ok(())
}
