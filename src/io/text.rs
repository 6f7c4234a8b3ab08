//! Parsing of numbers in text files.

use std::borrow::Cow;

use crate::error::Result;
use crate::files::Format;

/// Words for a missing number, in upper or lower case.
const MISSING: [&str; 14] = [
    "bad", "nodata", "no_data", "no-data", "n/a", "na", "#n/a", "null", "none", "void", "invalid",
    "missing", "-nan", "--",
];

/// Removes the byte order mark of UTF-8 from the beginning of a text.
pub(super) fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}

/// Returns an error if a text is compressed, or if it is in UTF-16 or UTF-32, which encode digits differently from UTF-8.
pub(super) fn check_encoding(format: Format, bytes: &[u8]) -> Result<()> {
    format.check_compression(bytes)?;
    // Both bytes after the mark are tested, because a damaged file might begin with the bytes of the mark.
    let encoding = match bytes {
        [0xff, 0xfe, 0, 0, ..] | [0, 0, 0xfe, 0xff, ..] => "UTF-32",
        [0xff, 0xfe, 1..=0xff, 0, ..] | [1..=0x7f, 0, 1..=0x7f, 0, ..] => "UTF-16 (little-endian)",
        [0xfe, 0xff, 0, 1..=0xff, ..] | [0, 1..=0x7f, 0, 1..=0x7f, ..] => "UTF-16 (big-endian)",
        _ => return Ok(()),
    };
    let problem = format!("the text is encoded in {encoding}: save it as UTF-8");
    Err(format.on_line(1, problem))
}

/// Returns the lines of a text that are neither blank nor comments (`#` or `%`), with their numbers. Bytes that are not
/// UTF-8 are harmless in a comment. In a number they are an error. The words `No Data` are joined, so that they are
/// read as one cell.
pub(super) fn lines(bytes: &[u8]) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let lines = without_mark(bytes).split(|&byte| byte == b'\n').enumerate();
    lines.filter_map(|(index, line)| {
        let line = String::from_utf8_lossy(line.strip_suffix(b"\r").unwrap_or(line));
        let line = with_joined_words(line);
        let content = line.trim_start_matches(' ');
        let is_data = !content.is_empty() && !content.starts_with(['#', '%']);
        is_data.then_some((index + 1, line))
    })
}

/// Joins the words `no data` (in upper or lower case) of a line.
fn with_joined_words(line: Cow<'_, str>) -> Cow<'_, str> {
    let words = b"no data";
    let begins = |place: &[u8]| place.eq_ignore_ascii_case(words);
    if !line.as_bytes().windows(words.len()).any(begins) {
        return line;
    }
    let rest = |index: usize| line.as_bytes().get(index.checked_sub(2)?..);
    let is_within =
        |index: usize| rest(index).is_some_and(|rest| rest.get(..words.len()).is_some_and(begins));
    let kept = line.char_indices().filter(|&(index, _)| !is_within(index));
    kept.map(|(_, character)| character).collect()
}

/// Returns the comments of a text (`#` or `%`) without their first character.
pub(super) fn comments(bytes: &[u8]) -> impl Iterator<Item = String> {
    let lines = without_mark(bytes).split(|&byte| byte == b'\n');
    lines.filter_map(|line| {
        let line = String::from_utf8_lossy(line);
        let comment = line.trim_start().strip_prefix(['#', '%'])?;
        Some(comment.trim().to_owned())
    })
}

/// Separator between the cells of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Separator {
    Semicolon,
    Tab,
    Comma,
    /// Any amount of white space.
    Space,
}

impl Separator {
    /// Determines the separator of a line. The separator is a semicolon if the line contains a semicolon, or else a tab if the
    /// line contains a tab. Otherwise it is a comma if the line contains commas. The exception is a line of several numbers in
    /// which every comma may be a decimal comma (`1,5 2,5`). In this case and in all other cases the separator is white space.
    pub(super) fn of(line: &str) -> Self {
        if line.contains(';') {
            Self::Semicolon
        } else if line.contains('\t') {
            Self::Tab
        } else if line.contains(',') && !has_decimal_commas(line) {
            Self::Comma
        } else {
            Self::Space
        }
    }

    /// Returns the trimmed cells of a line, without quotes around a cell.
    pub(super) fn split(self, line: &str) -> impl Iterator<Item = &str> {
        let ends_cell = move |character: char| match self {
            Self::Semicolon => character == ';',
            Self::Tab => character == '\t',
            Self::Comma => character == ',',
            Self::Space => character.is_whitespace(),
        };
        let cells = line.split(ends_cell).map(str::trim);
        let cells = cells.filter(move |cell| self != Self::Space || !cell.is_empty());
        cells.map(unquoted)
    }

    /// Parses the number in a cell of a line, as [`parse`](Self::parse).
    pub(super) fn number(self, format: Format, line: usize, cell: &str) -> Result<f64> {
        let problem = |rule| format.on_line(line, format!("{} {rule}", excerpt(cell)));
        self.parse(cell).map_err(problem)
    }

    /// Parses the number in a cell. The result is NaN if the cell is empty or consists of stars, or is `nan` or a word
    /// of [`MISSING`]. A decimal comma counts as a point unless commas separate the cells. The error is the violated rule, in
    /// words.
    pub(super) fn parse(self, cell: &str) -> std::result::Result<f64, &'static str> {
        let is_stars = cell.bytes().all(|byte| byte == b'*');
        if is_stars || MISSING.iter().any(|word| word.eq_ignore_ascii_case(cell)) {
            return Ok(f64::NAN);
        }
        let value = if self == Self::Comma || !cell.contains(',') {
            cell.parse()
        } else {
            cell.replace(',', ".").parse()
        };
        match value {
            // Only a word can represent infinity. Digits that overflow are rejected.
            Ok(value) if f64::is_finite(value) || !cell.contains(|c: char| c.is_ascii_digit()) => {
                Ok(value)
            }
            Ok(_) => Err("exceeds the range of double precision"),
            Err(_) => Err("is not a number"),
        }
    }
}

/// Removes the quotes around a cell.
fn unquoted(cell: &str) -> &str {
    let inner = cell
        .strip_prefix('"')
        .and_then(|rest| rest.strip_suffix('"'));
    inner.map_or(cell, str::trim)
}

/// Returns whether the line has several words and every comma is the only comma within a word.
fn has_decimal_commas(line: &str) -> bool {
    let is_one = |word: &str| {
        let mut parts = word.split(',');
        parts.next() != Some("") && parts.next() != Some("") && parts.next().is_none()
    };
    line.split_whitespace().nth(1).is_some() && line.split_whitespace().all(is_one)
}

/// Returns the quoted beginning of a text for an error message.
pub(super) fn excerpt(text: &str) -> String {
    format!("{:?}", text.chars().take(32).collect::<String>())
}
