//! Numbers that mark missing points in text files.

use super::text::comments;
use crate::error::{Result, counted};
use crate::files::Format;
use crate::memory::fallible;

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

/// Magnitudes of numbers that programs write for a missing point. The last four are the largest number in single precision with
/// different numbers of digits.
const MARKS: [f64; 16] = [
    999.0,
    9999.0,
    10_000.0,
    99999.0,
    999_999.0,
    32767.0,
    32768.0,
    2_147_483_647.0,
    2_147_483_648.0,
    1e20,
    1e30,
    1.70141e38,
    3.402_823e38,
    3.402_823_5e38,
    3.402_823_47e38,
    3.402_823_466_385_288_6e38,
];

/// Returns the number that marks the missing points of a file. It is the given number, or else the number that a comment
/// states.
///
/// # Errors
/// - A format error if the mark is neither given nor stated, but one of the numbers may be a mark.
/// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
pub(super) fn mark<I: Iterator<Item = f64> + Clone>(
    format: Format,
    bytes: &[u8],
    given: Option<f64>,
    numbers: &I,
) -> Result<Option<f64>> {
    let mark = given.or_else(|| comments(bytes).find_map(|comment| stated(&comment)));
    if mark.is_some() {
        return Ok(mark);
    }
    let Some(suspect) = suspect(numbers)? else {
        return Ok(None);
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

/// Returns a number that is a usual mark and farther from the other numbers than four fifths of them are apart.
fn suspect<I: Iterator<Item = f64> + Clone>(numbers: &I) -> Result<Option<f64>> {
    let marks = MARKS.into_iter().flat_map(|mark| [-mark, mark]);
    for mark in marks.filter(|mark| numbers.clone().any(|number| is(*mark)(&number))) {
        let others = numbers
            .clone()
            .filter(|number| !number.is_nan() && !is(mark)(number));
        let mut sorted = fallible::with_room(others.clone().count())?;
        sorted.extend(others);
        sorted.sort_unstable_by(f64::total_cmp);
        let last = sorted.len().saturating_sub(1);
        let (Some(low), Some(high)) = (sorted.get(last / 10), sorted.get(last - last / 10)) else {
            continue;
        };
        // Spikes do not widen this range.
        let nearest = sorted.iter().map(|number| (number - mark).abs());
        if nearest.fold(f64::INFINITY, f64::min) > high - low {
            return Ok(Some(mark));
        }
    }
    Ok(None)
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
