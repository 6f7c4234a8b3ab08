//! CSV and other matrices in text, with one row per line.
//!
//! Lines are ordered towards larger y. The file contains neither cell sides nor a unit. Points in three columns are a
//! different format, [`xyz`](super::xyz). Nine or more points of a grid are rejected. A matrix after a header of
//! SPIP is also a different format, [`asc`](super::asc).

use std::fmt::Write;
use std::path::Path;

use super::asc::{check_esri, is_asc};
use super::text::{Separator, check_encoding, excerpt, lines};
use super::{Place, Sides, missing, parse_file, write_bytes};
use crate::error::{Error, Result};
use crate::files::Format;
use crate::grid::field::Field;

const FORMAT: Format = Format("CSV");

/// Number of evenly spaced numbers from which the first line or column alone may be coordinates. Shorter lines of heights can be
/// even by chance.
const COORDINATES: usize = 9;

/// Options for reading a matrix in text.
///
/// ```
/// use stickslip::io::csv;
/// let text = b"left,middle,right\n1,2,-32768\n4,5,6\n";
/// let heights = csv::Options::default().skip_rows(1).missing(-32768.0).parse(text, [1.0, 1.0])?;
/// assert_eq!(heights.as_slice()[3..], [4.0, 5.0, 6.0]);
/// assert!(heights.as_slice()[2].is_nan());
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[must_use = "options do nothing until read() or parse() is called"]
pub struct Options {
    missing: Option<f64>,
    skip_rows: usize,
    skip_columns: usize,
    is_unlabelled: bool,
}

impl Options {
    /// Sets the value that marks a missing point (default: the value given in a comment of the file, or none). Magnitudes from
    /// 1e30 match with a relative tolerance of 1e-5.
    ///
    /// Other numbers that may be marks are still rejected. NaN states that all numbers are heights. Read a file with several
    /// marks in this way, and replace the marks afterwards.
    pub fn missing(mut self, value: f64) -> Self {
        self.missing = Some(value);
        self
    }

    /// Sets the number of lines to skip at the beginning, for names of columns or a header (default 0). Comments and
    /// blank lines are counted.
    pub fn skip_rows(mut self, rows: usize) -> Self {
        self.skip_rows = rows;
        self
    }

    /// Sets the number of cells to skip at the beginning of each line, for names or numbers of rows (default 0).
    ///
    /// ```
    /// use stickslip::io::csv;
    /// let of_pandas = b",0,1\n0,1.5,2.5\n1,3.5,4.5\n";
    /// assert!(csv::parse(of_pandas, [1.0, 1.0]).is_err());
    /// let options = csv::Options::default().skip_rows(1).skip_columns(1);
    /// let heights = options.parse(of_pandas, [1.0, 1.0])?;
    /// assert_eq!(heights.as_slice(), [1.5, 2.5, 3.5, 4.5]);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    pub fn skip_columns(mut self, columns: usize) -> Self {
        self.skip_columns = columns;
        self
    }

    /// Declares that the file has no labels. A first line or column that counts 0, 1, 2 or is evenly spaced then contains
    /// heights.
    ///
    /// Without this option, such a line or column is rejected.
    pub fn without_labels(mut self) -> Self {
        self.is_unlabelled = true;
        self
    }

    /// Reads the field in a file. The [`Sides`] (lengths) are the sides of a cell, `[dx, dy]`, or the sides of the
    /// whole grid. See [`parse`].
    ///
    /// # Errors
    /// - [`Error::File`] if the file cannot be read.
    /// - The errors of [`parse`].
    pub fn read(self, path: impl AsRef<Path>, sides: impl Into<Sides>) -> Result<Field> {
        let sides = sides.into().checked()?;
        parse_file(path.as_ref(), |bytes| self.parse(bytes, sides))
    }

    /// Reads the field in the bytes of a file. The [`Sides`] (lengths) are the sides of a cell, `[dx, dy]`, or the
    /// sides of the whole grid. See [`parse`].
    ///
    /// # Errors
    /// See [`parse`].
    pub fn parse(self, bytes: &[u8], sides: impl Into<Sides>) -> Result<Field> {
        let sides = sides.into().checked()?;
        check_encoding(FORMAT, bytes)?;
        if is_asc(bytes) && self == Self::default() {
            let problem =
                "the header contains sides, unit and missing points: read the file as ASC";
            return Err(FORMAT.on_line(1, problem));
        }
        check_esri(FORMAT, bytes, self.skip_rows)?;
        let (mut samples, mut width) = (Vec::new(), 0);
        let mut spelling = Spelling::default();
        let mut fractions = Fractions::default();
        let (mut separator, mut first_line) = (None, 0);
        let mut ends_with_separator = true;
        for (number, line) in lines(bytes).filter(|(number, _)| *number > self.skip_rows) {
            let separator = *separator.get_or_insert_with(|| Separator::of(&line));
            let (start, mut last) = (samples.len(), "");
            for (column, cell) in separator.split(&line).skip(self.skip_columns).enumerate() {
                let sample = separator.parse(cell).map_err(|rule| {
                    let place = [number, self.skip_columns + column + 1];
                    rejected(place, cell, rule, [start == 0, column == 0])
                })?;
                samples.push(sample);
                if separator == Separator::Comma {
                    fractions.read([number, column], cell);
                }
                spelling.read(start == 0, column, cell);
                last = cell;
            }
            let found = samples.len() - start;
            if start == 0 {
                (width, first_line) = (found, number);
            }
            if found != 0 && found != width {
                let is_unclear = separator == Separator::Comma && !fractions.is_excluded;
                let remedy = if is_unclear {
                    ": if the commas are decimal commas, separate the cells by semicolons or tabs"
                } else {
                    ""
                };
                let problem = format!(
                    "the line must have {width} cells, as the previous lines, but it has {found}{remedy}"
                );
                return Err(FORMAT.on_line(number, problem));
            }
            ends_with_separator &= found == 0 || last.is_empty();
        }
        if samples.is_empty() {
            return Err(FORMAT.on_line(1, "the file contains no numbers"));
        }
        let height = samples.len() / width;
        if ends_with_separator && width > 1 {
            let mut index = 0;
            samples.retain(|_| {
                index += 1;
                index % width != 0
            });
            width -= 1;
        }
        fractions.check(width, self.skip_columns)?;
        if !self.is_unlabelled {
            self.check_labels(&spelling, &samples, width, first_line)?;
        }
        let mark = missing::mark(FORMAT, bytes, self.missing, &samples.iter().copied())?;
        if let Some(mark) = mark {
            missing::remove(mark, samples.iter_mut());
        }
        let grid = FORMAT.grid(
            Place::Line(1),
            [width, height],
            sides.of_cell([width, height]),
        )?;
        Field::from_vec(grid, samples)
    }

    /// Returns an error if the first line, with the number `line`, or the first column may contain labels.
    fn check_labels(
        self,
        spelling: &Spelling,
        samples: &[f64],
        width: usize,
        line: usize,
    ) -> Result<()> {
        if width == 3 && are_points(samples) {
            let problem = "the lines may contain points x, y, z of a grid: read the file as XYZ, or read the numbers as heights by \
                           the option without_labels";
            return Err(FORMAT.on_line(line, problem));
        }
        let (rows, columns) = (self.skip_rows.max(line), self.skip_columns + 1);
        let (labels, remedy) = match spelling.labels(samples, width) {
            [false, false] => return Ok(()),
            [true, false] => ("the first line", format!("skip_rows = {rows}")),
            [false, true] => ("the first column", format!("skip_columns = {columns}")),
            [true, true] => (
                "the first line and column",
                format!("skip_rows = {rows} and skip_columns = {columns}"),
            ),
        };
        let problem = format!(
            "{labels} may contain labels, because the numbers are evenly spaced: skip the labels by the option {remedy}, or \
             read them as heights by the option without_labels"
        );
        Err(FORMAT.on_line(line, problem))
    }
}

/// Cells that may be the digits after decimal commas in a text whose cells are separated by commas.
#[derive(Debug, Default)]
struct Fractions {
    /// Whether a cell cannot belong to numbers with decimal commas.
    is_excluded: bool,
    /// Line and column of the first cell in every second column with a leading zero, and its text.
    zero: Option<([usize; 2], String)>,
}

impl Fractions {
    /// Reads a cell. Digits after a comma have no sign and may begin with zeros, and the digits before it do not.
    fn read(&mut self, [line, column]: [usize; 2], cell: &str) {
        let is_second = column % 2 == 1;
        let digits = cell.strip_prefix('-').filter(|_| !is_second);
        let digits = digits.unwrap_or(cell);
        let begins_with_zero = digits.len() > 1 && digits.starts_with('0');
        let is_whole = digits.bytes().all(|byte| byte.is_ascii_digit());
        self.is_excluded |= !is_whole || begins_with_zero && !is_second;
        if begins_with_zero && is_second && self.zero.is_none() {
            self.zero = Some(([line, column], cell.into()));
        }
    }

    /// Returns an error if the cells of a matrix of this width may be the digits before and after decimal commas.
    fn check(&self, width: usize, skipped: usize) -> Result<()> {
        let zero = self
            .zero
            .as_ref()
            .filter(|_| !self.is_excluded && width % 2 == 0);
        let Some(([line, column], cell)) = zero else {
            return Ok(());
        };
        let problem = format!(
            "{} in column {} begins with a zero, and all cells are whole numbers: if the commas are decimal commas, separate the \
             cells by semicolons or tabs, otherwise remove the leading zeros",
            excerpt(cell),
            skipped + column + 1
        );
        Err(FORMAT.on_line(*line, problem))
    }
}

/// Returns the error for a cell that violates a rule for numbers. The error for a name in the first line or the first column suggests the
/// option that skips the cell.
fn rejected(
    [line, column]: [usize; 2],
    cell: &str,
    rule: &str,
    [is_first_line, is_first_column]: [bool; 2],
) -> Error {
    let is_name = cell.starts_with(|first: char| first.is_alphabetic() || "\"'_".contains(first));
    let rows = format!(": skip header lines by the option skip_rows = {line}");
    let columns = format!("skip row names by the option skip_columns = {column}");
    let is_split = cell.contains('"') && cell.contains(|inner: char| inner.is_ascii_digit());
    let remedy = match (is_first_line, is_first_column) {
        _ if is_split => {
            ": write the quoted numbers with decimal points, or separate them by semicolons".into()
        }
        (true, true) if is_name => format!("{rows}, or {columns}"),
        (true, false) if is_name => rows,
        (false, true) if is_name => format!(": {columns}"),
        _ => String::new(),
    };
    let problem = format!("{} in column {column} {rule}{remedy}", excerpt(cell));
    FORMAT.on_line(line, problem)
}

/// Spelling of the cells, which identifies numbers that may be labels.
#[derive(Debug)]
struct Spelling {
    corner: Corner,
    /// Form of the cells of the first line, apart from the corner.
    line: Form,
    /// Form of the cells of the first column, apart from the corner.
    column: Form,
    /// Number of cells outside the first line and column.
    others: usize,
    /// Number of cells outside the first line and column that consist of digits only.
    whole_others: usize,
    /// Number of cells outside the first line and column that are whole numbers, with or without decimals of zero.
    integral_others: usize,
}

/// First cell of the first line.
#[derive(Debug, PartialEq)]
enum Corner {
    Empty,
    Number(Form),
}

/// Form of a number, or the least special form of several numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Form {
    /// Digits only, or empty. An empty cell becomes NaN, which interrupts the count.
    Whole,
    /// Digits, a decimal point and zeros.
    Integral,
    Other,
}

impl Form {
    fn of(cell: &str) -> Self {
        let has_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
        match cell.split_once(['.', ',']) {
            None if has_digits(cell) => Self::Whole,
            Some((digits, zeros))
                if has_digits(digits) && zeros.bytes().all(|byte| byte == b'0') =>
            {
                Self::Integral
            }
            _ => Self::Other,
        }
    }
}

impl Default for Spelling {
    fn default() -> Self {
        Self {
            corner: Corner::Number(Form::Other),
            line: Form::Whole,
            column: Form::Whole,
            others: 0,
            whole_others: 0,
            integral_others: 0,
        }
    }
}

impl Spelling {
    fn read(&mut self, is_first_line: bool, column: usize, cell: &str) {
        let form = Form::of(cell);
        match (is_first_line, column) {
            (true, 0) if cell.is_empty() => self.corner = Corner::Empty,
            (true, 0) => self.corner = Corner::Number(form),
            (true, _) => self.line = self.line.max(form),
            (false, 0) => self.column = self.column.max(form),
            (false, _) => {
                self.others += 1;
                self.whole_others += usize::from(form == Form::Whole);
                self.integral_others += usize::from(form != Form::Other);
            }
        }
    }

    /// Returns whether the first line and the first column of a matrix are labels.
    ///
    /// Next to an empty corner, labels count 0, 1, 2 or 1, 2, 3, or are evenly spaced coordinates on both axes. Three or
    /// more coordinates on both axes are also labels next to a number that does not continue them, unless the lines below
    /// rise like the first line. Other labels are whole numbers that count while the other numbers do not count or have
    /// decimals. Two numbers are labels only if all others have decimals. Labels with decimals of zero are
    /// three or more, count from zero, and require other numbers with decimals that are not zero.
    ///
    /// Nine or more coordinates along one axis are also labels if no other line or column is evenly spaced. On an inclined
    /// surface all of them are.
    fn labels(&self, samples: &[f64], width: usize) -> [bool; 2] {
        let height = samples.len() / width;
        let line = |row: usize, from: usize| (from..width).map(move |ix| samples[row * width + ix]);
        let column =
            |ix: usize, from: usize| (from..height).map(move |iy| samples[iy * width + ix]);
        let spacings = spacing(line(0, 1)).zip(spacing(column(0, 1)));
        let is_even_alone = [
            width >= COORDINATES
                && height > 1
                && (0..height).all(|row| spacing(line(row, 1)).is_some() == (row == 0)),
            height >= COORDINATES
                && width > 1
                && (0..width).all(|ix| spacing(column(ix, 1)).is_some() == (ix == 0)),
        ];
        if self.corner == Corner::Empty {
            let does_line_count = self.line != Form::Other && counts(line(0, 1));
            let does_column_count = self.column != Form::Other && counts(column(0, 1));
            let is_pair = does_line_count && does_column_count || spacings.is_some();
            let is_long = does_line_count && width > 3 || does_column_count && height > 3;
            return [is_pair || is_long || is_even_alone != [false; 2]; 2];
        }
        if let Some((dx, dy)) = spacings.filter(|_| width > 3 && height > 3) {
            let continues = |first: f64, step: f64| is_equal(first - samples[0], step);
            let is_plane = || (1..height).all(|row| does_rise(line(row, 1), dx));
            let is_edge = continues(samples[1], dx) && continues(samples[width], dy);
            if !is_edge && !is_plane() {
                return [true; 2];
            }
        }
        let Corner::Number(corner) = self.corner else {
            return [false; 2];
        };
        let least = if self.whole_others > 0 { 3 } else { 2 };
        let have_decimals = self.whole_others < self.others;
        // Whole numbers with decimals of zero may be heights of a file that writes all numbers in this form.
        let are_floats = samples[0] == 0.0 && self.integral_others < self.others;
        let may_be = |labels: Form, count: usize| match labels.max(corner) {
            Form::Whole => count >= least,
            Form::Integral => count >= 3 && are_floats,
            Form::Other => false,
        };
        let is_line = may_be(self.line, width)
            && height > 1
            && counts(line(0, 0))
            && (have_decimals || (1..height).any(|row| !steps_by_one(line(row, 0))));
        let is_column = may_be(self.column, height)
            && width > 1
            && counts(column(0, 0))
            && (have_decimals || (1..width).any(|ix| !steps_by_one(column(ix, 0))));
        [is_line || is_even_alone[0], is_column || is_even_alone[1]]
    }
}

/// Returns whether lines of three numbers are the points (x, y, z) of an evenly spaced grid, row by row or column by column.
#[expect(clippy::float_cmp, reason = "coordinates are repeated digit by digit")]
fn are_points(samples: &[f64]) -> bool {
    let count = samples.len() / 3;
    let at = |point: usize, axis: usize| samples[3 * point + axis];
    let is_grid = |fast: usize, slow: usize| {
        let differs = |point: &usize| at(*point, slow) != at(0, slow);
        let run = (1..count).find(differs).unwrap_or(count);
        let rows = count / run;
        let repeats = |point: usize| {
            at(point, fast) == at(point % run, fast)
                && at(point, slow) == at(point - point % run, slow)
        };
        run > 1
            && rows > 1
            && rows * run == count
            && (0..count).all(repeats)
            && spacing((0..run).map(|point| at(point, fast))).is_some()
            && spacing((0..rows).map(|row| at(row * run, slow))).is_some()
    };
    count >= COORDINATES && (is_grid(0, 1) || is_grid(1, 0))
}

/// Returns whether the numbers are 0, 1, 2 and so on, or 1, 2, 3 and so on.
fn counts(numbers: impl Iterator<Item = f64> + Clone) -> bool {
    let first = numbers.clone().next();
    steps_by_one(numbers) && (first == Some(0.0) || first == Some(1.0))
}

/// Returns whether each number exceeds its predecessor by one.
#[expect(clippy::float_cmp, reason = "whole numbers are exact")]
fn steps_by_one(numbers: impl Iterator<Item = f64> + Clone) -> bool {
    let next = numbers.clone().skip(1);
    numbers.zip(next).all(|(a, b)| b - a == 1.0)
}

/// Returns the spacing of two or more numbers that are evenly spaced within the rounding of a few decimals.
fn spacing(numbers: impl ExactSizeIterator<Item = f64> + Clone) -> Option<f64> {
    let (count, first, last) = (
        numbers.len(),
        numbers.clone().next()?,
        numbers.clone().last()?,
    );
    let step = (last - first) / (count as f64 - 1.0);
    let is_even = |(index, number)| is_equal(number - first - index as f64 * step + step, step);
    (count > 1 && step != 0.0 && numbers.enumerate().all(is_even)).then_some(step)
}

/// Returns whether each number exceeds its predecessor by a step.
fn does_rise(numbers: impl Iterator<Item = f64> + Clone, step: f64) -> bool {
    let next = numbers.clone().skip(1);
    numbers.zip(next).all(|(a, b)| is_equal(b - a, step))
}

/// Returns whether a difference equals a step within the rounding of a few decimals.
fn is_equal(difference: f64, step: f64) -> bool {
    (difference - step).abs() <= 0.02 * step.abs()
}

/// Reads the field in a file. The [`Sides`] (lengths) are the sides of a cell, `[dx, dy]`, or the sides of the whole
/// grid. See [`parse`].
///
/// # Errors
/// - [`Error::File`] if the file cannot be read.
/// - The errors of [`parse`].
pub fn read(path: impl AsRef<Path>, sides: impl Into<Sides>) -> Result<Field> {
    Options::default().read(path, sides)
}

/// Reads the field in the bytes of a file. The [`Sides`] (lengths) are the sides of a cell, `[dx, dy]`, or the sides of
/// the whole grid.
///
/// - Cells are separated by semicolons, tabs, commas or white space. The separator of the file is the first of these,
///   in this order, that occurs in the first line. Commas within numbers in white space (`1,5 2,5`) are decimal commas.
/// - A decimal comma counts as a point unless commas separate the cells. A matrix of whole numbers between commas is rejected if
///   only cells of every second column begin with zeros, as `0,05,1,5`, because these may be the digits after decimal commas.
/// - Cells may be in quotes, as `"1.5"`.
/// - Blank lines and lines that begin with `#` or `%` are skipped. A comment such as `# missing value = -32768` or
///   `# NODATA_value -9999` sets the value of missing points. Such a comment consists of a name, then `=`, `:` or a space,
///   and a single number. The name is `missing`, `missing value`, `no data`, `no data value`, `bad value`,
///   `invalid value`, `void` or `void value`. It may be in upper or lower case, with any separators between words or none,
///   such as `nodata` and `NODATA_value`. All other comments are ignored. Use
///   [`Options::missing`] if a comment of a different form contains the value of missing points.
/// - A cell is missing (NaN) if it is empty, consists of stars (`***`) or is `--`. It is also missing if it is one of
///   these words in upper or lower case: `nan`, `-nan`, `BAD`, `No Data`, `no_data`, `no-data`, `N/A`, `#N/A`,
///   `NA`, `null`, `none`, `void`, `invalid` and `missing`. Any other text is rejected.
/// - A separator at the end of every line adds no cell.
/// - Names of columns and rows are rejected. [`Options::skip_rows`] and [`Options::skip_columns`] skip them.
/// - Numbers that may be labels are also rejected. A first line or column may be labels if it counts 0, 1, 2 or 1, 2, 3
///   in whole numbers, whereas the other numbers do not count or have decimals. Three or more numbers
///   0.0, 1.0, 2.0 are also labels if other numbers have decimals that are not zero. Evenly spaced coordinates on both axes are
///   also labels, after an empty first cell or after a number that does not continue them. Coordinates on one axis are labels
///   if they are nine or more and no other line or column is evenly spaced. With [`Options::without_labels`] all of these
///   numbers are read as heights.
/// - Nine or more lines with the points x, y, z of a grid are rejected, unless [`Options::without_labels`] is set.
/// - Evenly spaced numbers in other first lines or columns are heights, because an inclined surface has the same form.
///
/// # Errors
/// - [`Error::NotPositive`] if a cell side is not positive and finite.
/// - [`Error::Format`], with line and column, if a cell contains other text.
/// - [`Error::Format`], with the line, if the width of a line differs from the width of the
///   first line, if the first line or column may be labels, or if the lines may be points.
/// - [`Error::Format`] if the text is in UTF-16, if the file contains no numbers, or if it is a file of
///   [`asc`](super::asc).
/// - [`Error::Format`], with the options that read the file, if it starts with the header of an ESRI ASCII grid.
/// - [`Error::Format`] if a number may mark missing points, as -9999, -32768 or 1e20, but neither a comment nor
///   [`Options::missing`] states this mark. Any magnitude from 1e30 may be a mark, such as the largest number in single
///   precision. The largest or the smallest number may also be a mark if it occurs four times, is not zero, and most of the other
///   numbers differ from each other. All such numbers are farther from the other numbers than four fifths of them are apart.
///
/// ```
/// use stickslip::io::csv;
/// let heights = csv::parse(b"# height in um\n1,5;2\n;-3e-1\n", [0.1, 0.1])?;
/// assert_eq!(heights.as_slice()[..2], [1.5, 2.0]);
/// assert!(heights.as_slice()[2].is_nan());
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn parse(bytes: &[u8], sides: impl Into<Sides>) -> Result<Field> {
    Options::default().parse(bytes, sides)
}

/// Writes a field to a file in the form of [`to_bytes`].
///
/// # Errors
/// - [`Error::File`] if the file cannot be written.
pub fn write(path: impl AsRef<Path>, field: &Field) -> Result<()> {
    write_bytes(path.as_ref(), &to_bytes(field))
}

/// Returns the bytes of a file with a field. Commas separate the cells, each number has enough digits to be restored
/// exactly, and missing values are `NaN`. The cell sides are not stored. If the first line or column counts 0, 1, 2, read
/// the file with [`Options::without_labels`].
#[must_use]
pub fn to_bytes(field: &Field) -> Vec<u8> {
    let mut text = String::new();
    for row in field.rows() {
        for (index, value) in row.iter().enumerate() {
            let separator = if index == 0 { "" } else { "," };
            write!(text, "{separator}{value:?}").expect("writing to a string cannot fail");
        }
        text.push('\n');
    }
    text.into_bytes()
}
