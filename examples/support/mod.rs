//! Common style of axes, lines, points and legends for the examples.

#![allow(dead_code, reason = "no example needs all of it")]

pub(crate) mod maps;

use std::error::Error;
use std::ops::Range;
use std::path::{Path, PathBuf};

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

/// Part of a figure that contains one chart.
pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// Chart with two linear axes.
pub(crate) type Chart<'a> =
    ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

pub(crate) const BLUE: RGBColor = RGBColor(0, 90, 160);
pub(crate) const ORANGE: RGBColor = RGBColor(230, 120, 20);
pub(crate) const GREEN: RGBColor = RGBColor(20, 140, 90);
pub(crate) const PURPLE: RGBColor = RGBColor(130, 60, 150);

/// Height of the letters, in units of the drawing.
pub(crate) const LETTERS: u32 = 30;

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
    let area = area.margin(20, 0, 0, 0);
    Ok(area.titled(title, ("sans-serif", LETTERS + 6))?)
}

/// Draws axes with labels in an area; `x` and `y` are the ranges and labels.
pub(crate) fn axes<'a>(
    area: &Area<'a>,
    x: (Range<f64>, &str),
    y: (Range<f64>, &str),
) -> Result<Chart<'a>, Box<dyn Error>> {
    let formats = [ticks(&x.0), ticks(&y.0)];
    labelled_axes(
        area,
        x,
        y,
        [7, 7],
        formats.each_ref().map(|format| format as Format<'_>),
    )
}

/// Draws axes of equal scale, as large as the area permits; the rest of the area remains empty.
pub(crate) fn map_axes<'a>(
    area: &Area<'a>,
    x: (Range<f64>, &str),
    y: (Range<f64>, &str),
) -> Result<Chart<'a>, Box<dyn Error>> {
    let (width, height) = area.dim_in_pixel();
    let inside = [width, height].map(f64::from);
    let room = [inside[0] - f64::from(BESIDE), inside[1] - f64::from(BELOW)];
    let spans = [&x.0, &y.0].map(|range| range.end - range.start);
    let scale = (room[0] / spans[0]).min(room[1] / spans[1]);
    #[expect(clippy::cast_possible_truncation, reason = "pixels of a drawing")]
    let [right, above] = [0, 1].map(|axis| (room[axis] - scale * spans[axis]) as i32);
    axes(&area.margin(above, 0, 0, right), x, y)
}

/// Width of the margins and labels of a chart.
const BESIDE: u32 = 20 + 40 + 120;
/// Height of the margins and labels of a chart.
const BELOW: u32 = 20 + 20 + 80;

/// Format of the value of a tick.
type Format<'f> = &'f dyn Fn(&f64) -> String;

/// Returns a format with the number of decimals required for seven ticks over the range.
fn ticks(range: &Range<f64>) -> impl Fn(&f64) -> String + use<> {
    let digits = (0.8 - (range.end - range.start).log10()).ceil();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a small number that is not negative"
    )]
    let digits = digits.clamp(0.0, 9.0) as usize;
    move |value| {
        let text = format!("{value:.digits$}");
        let is_zero = text.trim_start_matches(['-', '0', '.']).is_empty();
        if is_zero {
            text.replace('-', "")
        } else {
            text.replace('-', "\u{2212}")
        }
    }
}

/// Draws axes for decimal logarithms; the ranges are ranges of exponents. Labels are at powers of ten, or at a few
/// other numbers if fewer than two powers are in the range.
pub(crate) fn decades<'a>(
    area: &Area<'a>,
    x: (Range<f64>, &str),
    y: (Range<f64>, &str),
) -> Result<Chart<'a>, Box<dyn Error>> {
    let (width, height) = (x.0.clone(), y.0.clone());
    let integers = || (-30..=30).map(f64::from);
    // More labels than integer exponents would fall between them, and more than eight labels would touch.
    let labels = [&width, &height].map(|range| {
        let inside = integers().filter(|exponent| range.contains(exponent));
        let count = inside.count();
        if count < 2 { 5 } else { count.min(8) }
    });
    let format: Format<'_> = &|&exponent| power_of_ten(exponent);
    let number: Format<'_> = &|&exponent| two_digits(10_f64.powf(exponent));
    let formats = labels.map(|count| if count == 5 { number } else { format });
    let mut chart = labelled_axes(area, x, y, labels, formats)?;
    let lines = integers()
        .flat_map(|exponent| (2..10).map(move |digit| exponent + f64::from(digit).log10()))
        .filter(|y| height.contains(y))
        .map(|y| PathElement::new([(width.start, y), (width.end, y)], BLACK.mix(0.05)));
    chart.draw_series(lines)?;
    Ok(chart)
}

/// Formats a number with two significant digits.
fn two_digits(value: f64) -> String {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a small number that is not negative"
    )]
    let decimals = (1.0 - value.log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{value:.decimals$}")
}

/// Formats a power of ten: `10⁻⁶` for -6.
fn power_of_ten(exponent: f64) -> String {
    let superscript = |digit| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => {
            char::from_u32(u32::from('⁰') + u32::from(digit) - u32::from('0')).unwrap_or(digit)
        }
    };
    // Adding zero turns a negative zero into a positive one.
    let digits: String = format!("{:.0}", exponent.round() + 0.0)
        .chars()
        .map(superscript)
        .collect();
    format!("10{digits}")
}

fn labelled_axes<'a>(
    area: &Area<'a>,
    x: (Range<f64>, &str),
    y: (Range<f64>, &str),
    labels: [usize; 2],
    formats: [Format<'_>; 2],
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
        .x_labels(labels[0])
        .y_labels(labels[1])
        .x_label_formatter(&formats[0])
        .y_label_formatter(&formats[1])
        .label_style(("sans-serif", LETTERS - 2))
        .axis_desc_style(("sans-serif", LETTERS))
        .draw()?;
    Ok(chart)
}

/// Draws the closed form of a quantity as a line and its computed values as points.
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

/// Draws full points on a line, or hollow points on a dashed line.
pub(crate) fn curve(
    chart: &mut Chart<'_>,
    name: &str,
    (colour, is_full): (RGBColor, bool),
    points: &[(f64, f64)],
) -> Result<(), Box<dyn Error>> {
    let line = colour.stroke_width(3);
    let inside = if is_full { colour } else { WHITE };
    let points = points.iter().copied();
    if is_full {
        chart.draw_series(LineSeries::new(points.clone(), line))?;
    } else {
        chart.draw_series(DashedLineSeries::new(points.clone(), 8, 6, line))?;
    }
    let filled = move |at| Circle::new(at, 7, inside.filled());
    let outlined = move |at| Circle::new(at, 7, line);
    chart.draw_series(points.clone().map(filled))?;
    chart
        .draw_series(points.map(outlined))?
        .label(name)
        .legend(move |at| {
            EmptyElement::at(at)
                + PathElement::new([(0, 0), (40, 0)], line)
                + Circle::new((20, 0), 7, inside.filled())
                + Circle::new((20, 0), 7, line)
        });
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
            + Circle::new((0, 0), 7, inside.filled())
            + Circle::new((0, 0), 7, colour.stroke_width(3))
    };
    chart
        .draw_series(points.into_iter().map(dot))?
        .label(name)
        .legend(move |(x, y)| {
            EmptyElement::at((x + 20, y))
                + Circle::new((0, 0), 7, inside.filled())
                + Circle::new((0, 0), 7, colour.stroke_width(3))
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
    let line = BLACK.stroke_width(2);
    let points: Vec<_> = points.into_iter().collect();
    if is_full {
        let series = LineSeries::new(points, line);
        chart
            .draw_series(series)?
            .label(name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 40, y)], line));
    } else {
        let series = DashedLineSeries::new(points, 8, 6, line);
        chart
            .draw_series(series)?
            .label(name)
            .legend(move |(x, y)| {
                let dash = |from, to| PathElement::new([(from, 0), (to, 0)], line);
                EmptyElement::at((x, y)) + dash(0, 10) + dash(15, 25) + dash(30, 40)
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
    let line = BLACK.mix(0.3).stroke_width(8);
    chart
        .draw_series([PathElement::new(ends, line)])?
        .label(name)
        .legend(move |(x, y)| PathElement::new([(x, y), (x + 40, y)], line));
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
        .legend_area_size(50)
        .margin(15)
        .background_style(WHITE.mix(0.9))
        .border_style(BLACK.mix(0.3))
        .label_font(("sans-serif", LETTERS - 2))
        .draw()?;
    Ok(())
}
