//! XYZ, points of a regular grid in three columns, `x y z`, in any order.
//!
//! Lengths are in the unit of the file.

use std::path::Path;

use super::asc::check_esri;
use super::text::{Separator, check_encoding, lines};
use super::{Place, missing, parse_file};
use crate::error::{Error, Result};
use crate::files::Format;
use crate::grid::field::Field;

const FORMAT: Format = Format("XYZ");
/// Largest number of cells of the grid per point.
const CELLS_PER_POINT: usize = 10;
/// Largest permitted distance of a point from its grid position, in spacings.
const TOLERANCE: f64 = 0.05;
/// Fraction of the widest step between neighbouring coordinates below which two coordinates count as equal.
const NOISE: f64 = 1e-3;
/// Smallest ratio of a step between two places to a step between points of the same place.
const JUMP: f64 = 4.0;

/// Options for reading points.
///
/// ```
/// use stickslip::io::xyz;
/// let text = b"Points 2\n0 0 1.5\n1 0 -9999\n";
/// let heights = xyz::Options::default().skip_rows(1).missing(-9999.0).parse(text)?;
/// assert_eq!(heights.as_slice()[0], 1.5);
/// assert!(heights.as_slice()[1].is_nan());
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[must_use = "options do nothing until read() or parse() is called"]
pub struct Options {
    missing: Option<f64>,
    skip_rows: usize,
}

impl Options {
    /// Sets the height that marks a missing point (default: the value given in a comment of the file, or none), as
    /// [`csv::Options::missing`](super::csv::Options::missing). NaN states that all numbers are heights.
    pub fn missing(mut self, value: f64) -> Self {
        self.missing = Some(value);
        self
    }

    /// Sets the number of lines to skip at the beginning, including comments and blank lines (default 0).
    pub fn skip_rows(mut self, rows: usize) -> Self {
        self.skip_rows = rows;
        self
    }

    /// Reads the surface in a file. See [`parse`].
    ///
    /// # Errors
    /// - [`Error::File`] if the file cannot be read.
    /// - [`Error::Format`] for the reasons given at [`parse`].
    pub fn read(self, path: impl AsRef<Path>) -> Result<Field> {
        parse_file(path.as_ref(), |bytes| self.parse(bytes))
    }

    /// Reads the surface in the bytes of a file. See [`parse`].
    ///
    /// # Errors
    /// - [`Error::Format`] for the reasons given at [`parse`].
    pub fn parse(self, bytes: &[u8]) -> Result<Field> {
        let mut points = points(bytes, self.skip_rows)?;
        let heights = points.iter().map(|point| point.height);
        let mark = missing::mark(FORMAT, bytes, self.missing, &heights)?;
        if let Some(mark) = mark {
            missing::remove(mark, points.iter_mut().map(|point| &mut point.height));
        }
        gridded(&points)
    }
}

/// Reads the surface in a file. See [`parse`].
///
/// # Errors
/// - [`Error::File`] if the file cannot be read.
/// - The errors of [`parse`].
pub fn read(path: impl AsRef<Path>) -> Result<Field> {
    Options::default().read(path)
}

/// Reads the surface in the bytes of a file.
///
/// The spacing of `n` columns is $`(x_{\max} - x_{\min}) / (n - 1)`$, and the spacing of rows is computed in the same
/// way. The grid has cells of these sides centred on the points. If points are not on this grid, the grid is fitted to
/// them by least squares. A single column or row has the spacing of the other axis.
///
/// Grid positions without a point, or with a missing height, are set to NaN. Separators, decimal commas, comments and
/// words for missing heights are as in [`csv`](super::csv::parse).
///
/// Lines of names before the first point are skipped. [`Options::skip_rows`] skips lines with numbers. Cells after the
/// third cell of a line are ignored, but every line must have the same number of cells.
///
/// Scattered points are rejected. The distance of every point from its grid position must be at most 5 % of a spacing.
/// At least a tenth of the positions must have a point, and fewer than a thousand successive columns or rows may be
/// empty. If the points of a column or row differ by more than 0.1 % of a spacing, more than half of the positions must
/// have a point.
///
/// # Errors
/// - [`Error::Format`], with the line, if a line does not have three numbers or if its number of cells differs from the
///   number in the first line.
/// - [`Error::Format`], with the line, if a point is off the grid, or if a grid position has two points.
/// - [`Error::Format`] if the text is in UTF-16, if the points have fewer than two grid positions, or if there are too
///   few points for the grid that they span.
/// - [`Error::Format`] if commas separate more than three whole numbers, because the commas might be decimal commas.
/// - [`Error::Format`] if a height may mark missing points, as in [`csv`](super::csv::parse).
///
/// ```
/// use stickslip::io::xyz;
/// let heights = xyz::parse(b"1 0 5.0\n0 0 4.0\n0 2 6.0\n")?;
/// assert_eq!((heights.grid().dx(), heights.grid().dy()), (1.0, 2.0));
/// assert_eq!(heights.as_slice()[..3], [4.0, 5.0, 6.0]);
/// assert!(heights.as_slice()[3].is_nan());
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn parse(bytes: &[u8]) -> Result<Field> {
    Options::default().parse(bytes)
}

/// Returns whether a text resembles a list of points. It must have at least four lines, and each of its first lines (up
/// to 64) must have three numbers.
pub(super) fn is_like_points(bytes: &[u8]) -> bool {
    const LINES: usize = 64;
    let mut separator = None;
    let mut count = 0;
    for (number, line) in lines(bytes).take(LINES) {
        let separator = *separator.get_or_insert_with(|| Separator::of(&line));
        let mut cells = separator.split(&line).map(|cell| {
            let value = separator.number(FORMAT, number, cell);
            value.is_ok()
        });
        if !cells.by_ref().take(3).eq([true; 3]) || cells.next().is_some() {
            return false;
        }
        count += 1;
    }
    count >= 4
}

/// Returns the field on the finest grid that fits the points.
fn gridded(points: &[SamplePoint]) -> Result<Field> {
    let axes = [0, 1].map(|axis| PlaceAxis::candidates(points, axis));
    let mut refused = None;
    for coarseness in 0..axes[0].len() + axes[1].len() - 1 {
        for (index, &x) in axes[0].iter().enumerate().take(coarseness + 1) {
            let Some(&y) = axes[1].get(coarseness - index) else {
                continue;
            };
            // A coarse grid with few points is rejected, because scattered points can fit it by chance.
            if coarseness > 0 && x.count * y.count >= 2.0 * points.len() as f64 {
                continue;
            }
            match on_grid(points, x, y) {
                Ok(field) => return Ok(field),
                // The error of the finest grid is reported, unless that grid only follows the scatter of the points.
                Err((error, is_off)) if refused.is_none() || is_off && coarseness > 0 => {
                    refused = Some(error);
                }
                Err(_) => {}
            }
        }
    }
    Err(refused.unwrap_or_else(|| FORMAT.on_line(1, "the file contains no points")))
}

/// Returns the field on the grid of two axes. The error states whether a point is off the grid.
fn on_grid(
    points: &[SamplePoint],
    x: PlaceAxis,
    y: PlaceAxis,
) -> std::result::Result<Field, (Error, bool)> {
    let cells = x.count * y.count;
    let limit = (CELLS_PER_POINT * points.len()) as f64;
    if cells.is_nan() || cells > limit {
        let problem = format!(
            "the points are too few for a regular grid: {} points for {} x {} positions",
            points.len(),
            x.count,
            y.count
        );
        return Err((FORMAT.in_entry("all points", problem), false));
    }
    let (nx, ny) = (whole(x.count), whole(y.count));
    if nx * ny < 2 {
        let problem = format!(
            "the number of positions must be at least 2 to define a spacing, got {}",
            nx * ny
        );
        return Err((FORMAT.in_entry("all points", problem), false));
    }
    let sides = match (nx, ny) {
        (1, _) => [y.spacing; 2],
        (_, 1) => [x.spacing; 2],
        _ => [x.spacing, y.spacing],
    };
    let place = Place::Entry("all points".into());
    let grid = FORMAT
        .grid(place, [nx, ny], sides)
        .map_err(|error| (error, false))?;

    let mut samples = vec![f64::NAN; grid.cells()];
    let mut is_taken = vec![false; grid.cells()];
    for point in points {
        let ix = x.index(point.position[0]);
        let iy = y.index(point.position[1]);
        let [px, py] = point.position;
        let (Some(ix), Some(iy)) = (ix, iy) else {
            let problem = format!(
                "the position ({px}, {py}) deviates by more than 5 % from the regular grid that starts at ({}, {}) with spacings of {} and {}",
                x.least, y.least, x.spacing, y.spacing
            );
            return Err((FORMAT.on_line(point.line, problem), true));
        };
        let cell = iy * nx + ix;
        if is_taken[cell] {
            let problem =
                format!("the position ({px}, {py}) is already the position of an earlier point");
            return Err((FORMAT.on_line(point.line, problem), false));
        }
        is_taken[cell] = true;
        samples[cell] = point.height;
    }
    Field::from_vec(grid, samples).map_err(|error| (error, false))
}

/// Point on a line of a file.
#[derive(Debug)]
struct SamplePoint {
    line: usize,
    position: [f64; 2],
    height: f64,
}

fn points(bytes: &[u8], skip_rows: usize) -> Result<Vec<SamplePoint>> {
    check_encoding(FORMAT, bytes)?;
    check_esri(FORMAT, bytes, skip_rows)?;
    let mut separator = None;
    let mut width = 0;
    let mut points = Vec::new();
    for (number, line) in lines(bytes).filter(|(number, _)| *number > skip_rows) {
        let separator = match separator {
            Some(separator) => separator,
            None if has_no_number(number, &line) => continue,
            None => *separator.insert(Separator::of(&line)),
        };
        let mut cells = separator.split(&line);
        let (Some(x), Some(y), Some(z)) = (cells.next(), cells.next(), cells.next()) else {
            let problem = "a point requires three cells: x, y and z";
            return Err(FORMAT.on_line(number, hinted(problem.into(), &points, number)));
        };
        let found = 3 + cells.count();
        if points.is_empty() {
            width = found;
            if separator == Separator::Comma && found > 3 && !line.contains('.') {
                let problem = format!(
                    "a point requires three cells (x, y and z), but commas separate {found} whole numbers: if they are \
                     decimal commas, separate the cells by semicolons or tabs"
                );
                return Err(FORMAT.on_line(number, problem));
            }
        }
        if found != width {
            let problem = format!(
                "the line must have {width} cells, as the previous lines, but it has {found}"
            );
            return Err(FORMAT.on_line(number, problem));
        }
        let read = |cell| {
            let value = separator.number(FORMAT, number, cell);
            value.map_err(|error| match error {
                Error::Format { problem, .. } => {
                    FORMAT.on_line(number, hinted(problem, &points, number))
                }
                error => error,
            })
        };
        let (position, height) = ([read(x)?, read(y)?], read(z)?);
        if !position.iter().all(|coordinate| coordinate.is_finite()) {
            return Err(FORMAT.on_line(number, "the position of a point must be finite"));
        }
        points.push(SamplePoint {
            line: number,
            position,
            height,
        });
    }
    if points.is_empty() {
        return Err(FORMAT.on_line(1, "the file contains no points"));
    }
    Ok(points)
}

/// Adds a remedy to the problem of a line if the line may belong to a header.
fn hinted(problem: String, points: &[SamplePoint], number: usize) -> String {
    if points.is_empty() {
        format!("{problem}; skip a header by the option skip_rows = {number}")
    } else {
        problem
    }
}

/// Returns whether no cell of a line is a number, as in a line of names.
fn has_no_number(number: usize, line: &str) -> bool {
    let separator = Separator::of(line);
    let mut cells = separator.split(line);
    cells.all(|cell| separator.number(FORMAT, number, cell).is_err())
}

/// Places of a grid along an axis, `least + i * spacing` with `i < count`.
#[derive(Debug, Clone, Copy)]
struct PlaceAxis {
    least: f64,
    /// Spacing of the places, or zero if there is only one place.
    spacing: f64,
    /// Number of places. It is an integer, or it is not finite if no grid fits.
    count: f64,
}

impl PlaceAxis {
    /// Returns candidate grids through the coordinates of points, the finest first. The candidates differ in the
    /// threshold for a step to a new place.
    ///
    /// The threshold of the finest grid is [`NOISE`] times the widest step. If points scatter about their places, there
    /// are also short steps. A jump in the sorted steps separates the short steps from the steps between places.
    fn candidates(points: &[SamplePoint], axis: usize) -> Vec<Self> {
        let mut sorted: Vec<f64> = points.iter().map(|point| point.position[axis]).collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let mut steps: Vec<f64> = sorted.windows(2).map(|pair| pair[1] - pair[0]).collect();
        steps.sort_unstable_by(f64::total_cmp);
        let widest = steps.last().copied().unwrap_or(0.0);
        if widest == 0.0 {
            let (least, spacing, count) = (sorted[0], 0.0, 1.0);
            return vec![Self {
                least,
                spacing,
                count,
            }];
        }
        let noise = NOISE * widest;
        let jumps = steps.windows(2).filter(|pair| {
            let [short, long] = [pair[0], pair[1]];
            short >= noise && long >= JUMP * short
        });
        let mut thresholds = vec![noise];
        thresholds.extend(jumps.map(|pair| pair[1]));
        let through = |threshold| Self::through(&sorted, threshold);
        thresholds.into_iter().map(through).collect()
    }

    /// Returns the grid through sorted coordinates. Some of its places may have no points. A step that is not shorter
    /// than the threshold leads to a new place. Such a step counts as a multiple of the shortest step.
    fn through(sorted: &[f64], threshold: f64) -> Self {
        let (least, greatest) = (sorted[0], sorted[sorted.len() - 1]);
        let steps = || {
            let mut start = least;
            sorted.windows(2).filter_map(move |pair| {
                let step = (pair[1] - pair[0] >= threshold).then_some(pair[1] - start);
                start = if step.is_some() { pair[1] } else { start };
                step
            })
        };
        let shortest = steps().fold(f64::INFINITY, f64::min);
        let intervals: f64 = steps().map(|step| (step / shortest).round()).sum();
        let axis = Self {
            least,
            spacing: (greatest - least) / intervals,
            count: intervals + 1.0,
        };
        if sorted
            .iter()
            .all(|&coordinate| axis.index(coordinate).is_some())
        {
            axis
        } else {
            axis.fitted(sorted)
        }
    }

    /// Fits the grid to the coordinates by least squares. Each coordinate belongs to its nearest place on the current
    /// grid.
    fn fitted(self, coordinates: &[f64]) -> Self {
        let number = coordinates.len() as f64;
        let place = |coordinate: f64| ((coordinate - self.least) / self.spacing).round();
        let mean_place = coordinates.iter().map(|&at| place(at)).sum::<f64>() / number;
        let mean = coordinates.iter().map(|&at| at - self.least).sum::<f64>() / number;
        let (mut product, mut square) = (0.0, 0.0);
        for &coordinate in coordinates {
            let distance = place(coordinate) - mean_place;
            product += distance * (coordinate - self.least - mean);
            square += distance * distance;
        }
        let spacing = product / square;
        if !(spacing.is_finite() && spacing > 0.0) {
            return self;
        }
        let least = self.least + mean - spacing * mean_place;
        Self {
            least,
            spacing,
            ..self
        }
    }

    /// Returns the index of the place to which a coordinate belongs, or `None` if the coordinate is too far from every
    /// place.
    fn index(&self, coordinate: f64) -> Option<usize> {
        if self.spacing == 0.0 {
            return Some(0);
        }
        let steps = (coordinate - self.least) / self.spacing;
        let index = steps.round();
        let is_near = (steps - index).abs() <= TOLERANCE && index < self.count;
        (is_near && index >= 0.0).then(|| whole(index))
    }
}

/// Converts a small non-negative integer to an index.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the limit on the number of cells has been checked"
)]
fn whole(value: f64) -> usize {
    value as usize
}
