//! Numbers that mark missing points in text files.

use super::text::comments;
use crate::error::{Result, counted};
use crate::files::Format;

/// Names that introduce the value of missing points in a comment, in lower-case letters and digits.
const NAMES: [&str; 8] = [
    "missing",
    "missingvalue",
    "nodata",
    "nodatavalue",
    "badvalue",
    "invalidvalue",
    "void",
    "voidvalue",
];

/// Magnitudes of numbers that programs write for a missing point.
const MARKS: [f64; 8] = [
    999.0, 9999.0, 99999.0, 999_999.0, 32767.0, 32768.0, 1e30, 1.70141e38,
];

/// Returns the number that marks the missing points of a file. It is the given number, or else the number that a comment
/// states.
///
/// # Errors
/// - A format error if the mark is neither given nor stated, but the least or the greatest of the numbers may be a mark.
pub(super) fn mark<I: Iterator<Item = f64> + Clone>(
    format: Format,
    bytes: &[u8],
    given: Option<f64>,
    numbers: &I,
) -> Result<Option<f64>> {
    let mark = given.or_else(|| comments(bytes).find_map(|comment| stated(&comment)));
    let Some(suspect) = suspect(numbers).filter(|_| mark.is_none()) else {
        return Ok(mark);
    };
    let count = numbers.clone().filter(is(suspect)).count();
    let problem = format!(
        "{} with the value {suspect:?} may mark missing points: set the option missing to {suspect:?}, or to NaN if these are heights",
        counted(count, "number")
    );
    Err(format.on_line(1, problem))
}

/// Returns a function that tests whether a number is a mark.
#[expect(
    clippy::float_cmp,
    reason = "the digits in the file are those of the mark"
)]
pub(super) fn is(mark: f64) -> impl Fn(&f64) -> bool {
    move |&number| number == mark
}

/// Returns the least or the greatest number if it is a usual mark and farther from the other numbers than their range.
fn suspect<I: Iterator<Item = f64> + Clone>(numbers: &I) -> Option<f64> {
    let (least, most) = range(numbers.clone());
    [least, most].into_iter().find(|&end| {
        if !MARKS.contains(&end.abs()) {
            return false;
        }
        let is_end = is(end);
        let (low, high) = range(numbers.clone().filter(|number| !is_end(number)));
        low <= high && (low - end).max(end - high) > high - low
    })
}

/// Returns the least and the greatest number.
fn range(numbers: impl Iterator<Item = f64>) -> (f64, f64) {
    let none = (f64::INFINITY, f64::NEG_INFINITY);
    numbers.fold(none, |(least, most), number| {
        (least.min(number), most.max(number))
    })
}

/// Returns the value of missing points if a comment contains it, as `# missing value = -32768` or
/// `# NODATA_value -9999`.
pub(super) fn stated(comment: &str) -> Option<f64> {
    let by_space = || comment.trim_end().rsplit_once(char::is_whitespace);
    let (name, value) = comment.split_once(['=', ':']).or_else(by_space)?;
    let letters = name.chars().filter(char::is_ascii_alphanumeric);
    let name: String = letters.collect::<String>().to_ascii_lowercase();
    let value = value.trim().parse().ok()?;
    NAMES.contains(&name.as_str()).then_some(value)
}
