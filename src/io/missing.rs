//! Numbers that mark missing points in text files and arrays.

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

/// Magnitudes of numbers that programs write for a missing point, the smallest first. The last number is 1e20 in single precision.
const MARKS: [f64; 15] = [
    999.0,
    9999.0,
    10_000.0,
    99999.0,
    100_000.0,
    999_999.0,
    1_000_000.0,
    32767.0,
    32768.0,
    65535.0,
    2_147_483_647.0,
    2_147_483_648.0,
    4_294_967_295.0,
    1e20,
    1.000_000_020_040_877_3e20,
];

/// Number of equal heights from which the largest or the smallest height may be a mark. A single such height may be a spike. Most of
/// the other heights must differ from each other, as in a measurement and unlike the levels of a pattern. Zeros are excluded, because
/// pressures are zero outside a contact.
const REPEATED: usize = 4;

/// Smallest magnitude of numbers that may mark missing points whatever their digits are, such as the largest number in single
/// precision.
const HUGE: f64 = 1e30;
/// Largest relative difference of huge numbers that represent the same mark, because files contain different numbers of digits.
const DIGITS: f64 = 1e-5;

/// Returns the number that marks the missing points of a text. It is the given number, or else the number that a comment
/// states.
///
/// # Errors
/// - A format error if another number may be a mark.
/// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
pub(super) fn mark<I: Iterator<Item = f64> + Clone>(
    format: Format,
    bytes: &[u8],
    given: Option<f64>,
    numbers: &I,
) -> Result<Option<f64>> {
    let mark = given.or_else(|| comments(bytes).find_map(|comment| stated(&comment)));
    match problem(mark, numbers)? {
        Some(problem) => Err(format.on_line(1, problem)),
        None => Ok(mark),
    }
}

/// Returns the problem if the numbers contain a further number that may be a mark. NaN as the mark states that all numbers are heights.
///
/// # Errors
/// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
pub(super) fn problem<I: Iterator<Item = f64> + Clone>(
    mark: Option<f64>,
    numbers: &I,
) -> Result<Option<String>> {
    if mark.is_some_and(f64::is_nan) {
        return Ok(None);
    }
    let is_height = |number: &f64| !number.is_nan() && !mark.is_some_and(|mark| is(mark)(number));
    let heights = numbers.clone().filter(is_height);
    let Some(suspect) = suspect(&heights)? else {
        return Ok(None);
    };
    let count = counted(heights.filter(is(suspect)).count(), "number");
    Ok(Some(match mark {
        None => format!(
            "{count} with the value {suspect:?} may mark missing points: set the option missing to {suspect:?}, or to NaN if these are heights"
        ),
        Some(mark) => format!(
            "{count} with the value {suspect:?} may mark missing points, besides the mark {mark:?}: set the option missing to \
             {suspect:?}, or to NaN to read all numbers as heights"
        ),
    }))
}

/// Returns a function that tests whether a number is a mark.
#[expect(
    clippy::float_cmp,
    reason = "the digits in the file are those of the mark"
)]
fn is(mark: f64) -> impl Fn(&f64) -> bool {
    move |&number| {
        let is_near = || is_huge(number) && (number / mark - 1.0).abs() <= DIGITS;
        number == mark || is_huge(mark) && is_near()
    }
}

/// Replaces the heights that equal a mark by NaN.
pub(super) fn remove<'a>(mark: f64, heights: impl Iterator<Item = &'a mut f64>) {
    let marked = heights.filter(|height| is(mark)(height));
    marked.for_each(|height| *height = f64::NAN);
}

fn is_huge(number: f64) -> bool {
    number.is_finite() && number.abs() >= HUGE
}

/// Returns a number that may be a mark. It is huge, a usual mark, or a repeated largest or smallest number, and farther from the other
/// numbers than four fifths of them are apart. The numbers must not be NaN.
fn suspect<I: Iterator<Item = f64> + Clone>(numbers: &I) -> Result<Option<f64>> {
    if let Some(huge) = numbers.clone().find(|&number| is_huge(number)) {
        // Other huge numbers may be further marks.
        let others = numbers.clone().filter(|&number| !is_huge(number));
        if is_apart(huge, &sorted(&others)?) {
            return Ok(Some(huge));
        }
    }
    let mut is_present = [[false; 2]; MARKS.len()];
    for number in numbers.clone().filter(|number| number.abs() >= MARKS[0]) {
        let position = MARKS.iter().position(|&mark| is(mark)(&number.abs()));
        if let Some(index) = position {
            is_present[index][usize::from(number > 0.0)] = true;
        }
    }
    for (mark, is_present) in MARKS.into_iter().zip(is_present) {
        for mark in [-mark, mark] {
            let others = numbers.clone().filter(|number| !is(mark)(number));
            if is_present[usize::from(mark > 0.0)] && is_apart(mark, &sorted(&others)?) {
                return Ok(Some(mark));
            }
        }
    }
    for extreme in [f64::min, f64::max] {
        let Some(mark) = numbers.clone().reduce(extreme) else {
            return Ok(None);
        };
        let is_repeated = numbers.clone().filter(is(mark)).nth(REPEATED - 1).is_some();
        if mark == 0.0 || !is_repeated {
            continue;
        }
        let others = sorted(&numbers.clone().filter(|number| !is(mark)(number)))?;
        let different = others.windows(2).filter(|pair| pair[0] < pair[1]);
        let is_rough = 2 * different.count() + 2 > others.len();
        if others.len() >= REPEATED && is_rough && is_apart(mark, &others) {
            return Ok(Some(mark));
        }
    }
    Ok(None)
}

/// Returns the numbers in ascending order.
fn sorted<I: Iterator<Item = f64> + Clone>(numbers: &I) -> Result<Vec<f64>> {
    let mut sorted = fallible::with_room(numbers.clone().count())?;
    sorted.extend(numbers.clone());
    sorted.sort_unstable_by(f64::total_cmp);
    Ok(sorted)
}

/// Returns whether a number is farther from the other numbers, which are sorted, than four fifths of them are apart.
fn is_apart(mark: f64, others: &[f64]) -> bool {
    let last = others.len().saturating_sub(1);
    let (Some(low), Some(high)) = (others.get(last / 10), others.get(last - last / 10)) else {
        return false;
    };
    // Spikes do not widen this range.
    let nearest = others.iter().map(|number| (number - mark).abs());
    nearest.fold(f64::INFINITY, f64::min) > high - low
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
