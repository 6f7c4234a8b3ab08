//! XYZ: points of a regular grid in three columns, `x y z`, in any order.
//!
//! Lengths are in the unit of the file.

use std::path::Path;

use super::text::{Separator, lines};
use super::{Format, Place, parse_file};
use crate::error::Result;
use crate::field::Field;

const FORMAT: Format = Format("XYZ");
/// Largest number of cells of the grid per point.
const CELLS_PER_POINT: usize = 10;
/// Largest distance of a point from its place in the grid, in spacings.
const TOLERANCE: f64 = 0.05;
/// Coordinates closer than this fraction of the widest step between neighbours count as one.
const NOISE: f64 = 1e-3;

/// The surface in a file. See [`parse`].
///
/// # Errors
/// [`Error::File`](crate::Error::File) if the file cannot be read, otherwise as [`parse`].
pub fn read(path: impl AsRef<Path>) -> Result<Field> {
    parse_file(path.as_ref(), parse)
}

/// The surface in the bytes of a file.
///
/// The spacing of `n` columns is $`(x_{\max} - x_{\min}) / (n - 1)`$, likewise along y; the grid has
/// cells of these sides about the points. A single column or row takes the spacing of the other axis.
/// Places of the grid without a point, or with a missing height, are NaN. Separators, comments and
/// missing heights are as in [`csv`](super::csv::parse).
///
/// A point must lie within 5 % of a spacing of its place, at least a tenth of the places must have a
/// point, and fewer than a thousand successive columns or rows may be empty: scattered points do not form
/// a grid.
///
/// # Errors
/// [`Error::Format`](crate::Error::Format), with the line, for a line that does not have three numbers, a
/// point off the grid, or a second point at a place; also for fewer than two places, or too few points for
/// the grid that they span.
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
    let points = points(bytes)?;
    let axes = [0, 1].map(|axis| Axis::through(points.iter().map(|point| point.position[axis])));
    let [x, y] = axes;
    let cells = x.count * y.count;
    let limit = (CELLS_PER_POINT * points.len()) as f64;
    if cells.is_nan() || cells > limit {
        let problem = format!(
            "too few for a regular grid: {} for {} x {} places",
            points.len(),
            x.count,
            y.count
        );
        return Err(FORMAT.in_entry("all points", problem));
    }
    let (nx, ny) = (whole(x.count), whole(y.count));
    if nx * ny < 2 {
        let problem = format!("{} places do not define a spacing", nx * ny);
        return Err(FORMAT.in_entry("all points", problem));
    }
    let sides = match (nx, ny) {
        (1, _) => [y.spacing; 2],
        (_, 1) => [x.spacing; 2],
        _ => [x.spacing, y.spacing],
    };
    let place = Place::Entry("all points".into());
    let grid = FORMAT.grid(place, [nx, ny], sides)?;

    let mut samples = vec![f64::NAN; grid.cells()];
    let mut is_taken = vec![false; grid.cells()];
    for point in &points {
        let ix = x.index(point.position[0]);
        let iy = y.index(point.position[1]);
        let [px, py] = point.position;
        let (Some(ix), Some(iy)) = (ix, iy) else {
            let problem = format!(
                "({px}, {py}) is off the regular grid from ({}, {}) in steps of {} and {}",
                x.least, y.least, x.spacing, y.spacing
            );
            return Err(FORMAT.on_line(point.line, problem));
        };
        let cell = iy * nx + ix;
        if is_taken[cell] {
            let problem = format!("({px}, {py}) repeats the place of an earlier point");
            return Err(FORMAT.on_line(point.line, problem));
        }
        is_taken[cell] = true;
        samples[cell] = point.height;
    }
    Field::from_vec(grid, samples)
}

/// One line of a file.
#[derive(Debug)]
struct Point {
    line: usize,
    position: [f64; 2],
    height: f64,
}

fn points(bytes: &[u8]) -> Result<Vec<Point>> {
    let mut separator = None;
    let mut points = Vec::new();
    for (number, line) in lines(bytes) {
        let separator = *separator.get_or_insert_with(|| Separator::of(&line));
        let mut cells = separator.split(&line);
        let (Some(x), Some(y), Some(z), None) =
            (cells.next(), cells.next(), cells.next(), cells.next())
        else {
            return Err(FORMAT.on_line(number, "a point needs three cells: x, y and z"));
        };
        let [x, y, height] = [x, y, z].map(|cell| separator.number(FORMAT, number, cell));
        let position = [x?, y?];
        if !position.iter().all(|coordinate| coordinate.is_finite()) {
            return Err(FORMAT.on_line(number, "the position of a point is not finite"));
        }
        points.push(Point {
            line: number,
            position,
            height: height?,
        });
    }
    if points.is_empty() {
        return Err(FORMAT.on_line(1, "the file has no points"));
    }
    Ok(points)
}

/// The places of a grid along one axis, `least + i * spacing` with `i < count`.
#[derive(Debug, Clone, Copy)]
struct Axis {
    least: f64,
    /// Zero if there is one place only.
    spacing: f64,
    /// An integer, or not finite if there is no such grid.
    count: f64,
}

impl Axis {
    /// The grid through the coordinates; some of its places may be empty everywhere. Steps between
    /// neighbours are multiples of the shortest.
    fn through(coordinates: impl Iterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = coordinates.collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let (least, greatest) = (sorted[0], sorted[sorted.len() - 1]);
        let gaps = || sorted.windows(2).map(|pair| pair[1] - pair[0]);
        let widest = gaps().fold(0.0, f64::max);
        if widest == 0.0 {
            return Self {
                least,
                spacing: 0.0,
                count: 1.0,
            };
        }
        let mut steps = Vec::new();
        let mut start = least;
        for (&here, gap) in sorted[1..].iter().zip(gaps()) {
            if gap >= NOISE * widest {
                steps.push(here - start);
                start = here;
            }
        }
        let shortest = steps.iter().copied().fold(f64::INFINITY, f64::min);
        let intervals: f64 = steps.iter().map(|step| (step / shortest).round()).sum();
        Self {
            least,
            spacing: (greatest - least) / intervals,
            count: intervals + 1.0,
        }
    }

    /// The place to which a coordinate belongs, `None` if it is too far from every place.
    fn index(&self, coordinate: f64) -> Option<usize> {
        if self.spacing == 0.0 {
            return Some(0);
        }
        let steps = (coordinate - self.least) / self.spacing;
        let index = steps.round();
        let is_near = (steps - index).abs() <= TOLERANCE && index < self.count;
        is_near.then(|| whole(index))
    }
}

/// A small non-negative integer as an index.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the limit on the number of cells has been checked"
)]
fn whole(value: f64) -> usize {
    value as usize
}
