//! What the figures of the examples share: one style of axes, lines, points and legend.

use std::error::Error;
use std::ops::Range;
use std::path::{Path, PathBuf};

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

/// The part of a figure that one chart fills.
pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// A chart with two linear axes.
pub(crate) type Chart<'a> =
    ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

pub(crate) const BLUE: RGBColor = RGBColor(0, 90, 160);
pub(crate) const ORANGE: RGBColor = RGBColor(230, 120, 20);

/// Height of the letters, in the units of the drawing.
pub(crate) const LETTERS: u32 = 30;

/// The file `name` in `target/gallery`, a folder made if need be.
pub(crate) fn gallery(name: &str) -> Result<PathBuf, std::io::Error> {
    let folder = Path::new("target").join("gallery");
    std::fs::create_dir_all(&folder)?;
    Ok(folder.join(name))
}

/// An empty figure with a title, and the area below the title.
pub(crate) fn figure<'a>(
    path: &'a Path,
    size: (u32, u32),
    title: &str,
) -> Result<Area<'a>, Box<dyn Error>> {
    let area = SVGBackend::new(path, size).into_drawing_area();
    area.fill(&WHITE)?;
    let area = area.margin(20, 0, 0, 0);
    Ok(area.titled(title, ("sans-serif", LETTERS + 6))?)
}

/// Axes with labels in an area; `x` and `y` are the ranges shown.
pub(crate) fn axes<'a>(
    area: &Area<'a>,
    x: (Range<f64>, &str),
    y: (Range<f64>, &str),
) -> Result<Chart<'a>, Box<dyn Error>> {
    let mut chart = ChartBuilder::on(area)
        .margin(20)
        .margin_right(40)
        .x_label_area_size(80)
        .y_label_area_size(120)
        .build_cartesian_2d(x.0, y.0)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.1))
        .x_desc(x.1)
        .y_desc(y.1)
        .x_labels(7)
        .y_labels(7)
        .x_label_formatter(&|x| format!("{x:.1}"))
        .y_label_formatter(&|y| format!("{y:.1}"))
        .label_style(("sans-serif", LETTERS - 2))
        .axis_desc_style(("sans-serif", LETTERS))
        .draw()?;
    Ok(chart)
}

/// One quantity twice: the closed form as a line, what was computed as points.
pub(crate) fn compare(
    chart: &mut Chart<'_>,
    name: &str,
    colour: RGBColor,
    closed_form: impl IntoIterator<Item = (f64, f64)>,
    computed: impl IntoIterator<Item = (f64, f64)>,
) -> Result<(), Box<dyn Error>> {
    let line = colour.stroke_width(3);
    chart
        .draw_series(LineSeries::new(closed_form, line))?
        .label(format!("{name}, closed form"))
        .legend(move |(x, y)| PathElement::new([(x, y), (x + 40, y)], line));
    let point = move |at| Circle::new(at, 6, colour.filled());
    chart
        .draw_series(computed.into_iter().map(point))?
        .label(format!("{name}, computed"))
        .legend(move |(x, y)| Circle::new((x + 20, y), 6, colour.filled()));
    Ok(())
}

/// The names of everything drawn so far.
pub(crate) fn legend(
    chart: &mut Chart<'_>,
    position: SeriesLabelPosition,
) -> Result<(), Box<dyn Error>> {
    chart
        .configure_series_labels()
        .position(position)
        .legend_area_size(50)
        .margin(15)
        .background_style(WHITE.mix(0.9))
        .border_style(BLACK.mix(0.3))
        .label_font(("sans-serif", LETTERS - 2))
        .draw()?;
    Ok(())
}
