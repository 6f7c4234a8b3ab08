//! The generated part of the guide's page on validation.

use std::error::Error;
use std::fmt::Write;
use std::fs;

use crate::Group;

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../src/guide/validation.md");
const START: &str =
    "<!-- The example `validation` of the package `stickslip-testkit` writes the tables. -->\n";
const END: &str = "<!-- End of the tables. -->\n";

/// Column of the error, counted in the parts of a line between vertical bars.
const ERROR: usize = 4;
/// Errors above this value are discretisation errors. Smaller errors depend on the last iterations and on the rounding of
/// the reference, and differ between processors.
const DISCRETISATION: f64 = 1e-7;
/// Errors below this value count as equal.
const ROUND_OFF: f64 = 1e-11;

/// Returns the tables of all groups with their headings and captions.
pub(crate) fn tables(groups: &[Group]) -> String {
    let mut text = String::new();
    for group in groups {
        let line = "| closed form or code | quantity | cells | relative error | test |\n|---|---|---|---|---|";
        let _ = write!(
            text,
            "\n# {}\n\n{}\n\n{line}\n",
            group.heading, group.caption
        );
        // Names of tests are too long for a column.
        let mut tests = Vec::new();
        for row in &group.rows {
            let place = tests.iter().position(|&test| test == row.test);
            let place = place.unwrap_or_else(|| {
                tests.push(row.test);
                tests.len() - 1
            });
            let _ = writeln!(
                text,
                "| {} | {} | {} | {:.1e} | {} |",
                row.reference,
                row.quantity,
                row.cells,
                row.error,
                place + 1
            );
        }
        text.push_str("\nTests:\n\n");
        for (place, test) in tests.iter().enumerate() {
            let _ = writeln!(text, "{}. `{test}`", place + 1);
        }
    }
    text.push('\n');
    text
}

/// Replaces the tables of the page.
pub(crate) fn write(tables: &str) -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(PAGE)?;
    let (before, _, after) = split(&text)?;
    fs::write(PAGE, format!("{before}{START}{tables}{END}{after}"))?;
    Ok(())
}

/// Returns a description of each line of the page that differs from the tables beyond rounding.
pub(crate) fn differences(tables: &str) -> Result<Vec<String>, Box<dyn Error>> {
    let text = fs::read_to_string(PAGE)?;
    let (_, listed, _) = split(&text)?;
    let pairs = tables.lines().zip(listed.lines());
    let mut differences: Vec<String> = pairs
        .filter(|(found, listed)| !agree(found, listed))
        .map(|(found, listed)| format!("page:  {listed}\nfound: {found}"))
        .collect();
    if tables.lines().count() != listed.lines().count() {
        differences.push("the numbers of lines differ".to_owned());
    }
    Ok(differences)
}

/// Splits the page into the text before the tables, the tables, and the text after them.
fn split(text: &str) -> Result<(&str, &str, &str), Box<dyn Error>> {
    let parts = text.split_once(START).and_then(|(before, rest)| {
        let (tables, after) = rest.split_once(END)?;
        Some((before, tables, after))
    });
    parts.ok_or_else(|| format!("{PAGE}: the markers of the tables are missing").into())
}

/// Returns whether two lines are equal except for the rounding of the error.
fn agree(found: &str, listed: &str) -> bool {
    let [found, listed] = [found, listed].map(|line| line.split('|').collect::<Vec<_>>());
    let others = |line: &[&str]| {
        let cells = line.iter().enumerate().filter(|(n, _)| *n != ERROR);
        cells
            .map(|(_, cell)| (*cell).to_owned())
            .collect::<Vec<_>>()
    };
    if others(&found) != others(&listed) {
        return false;
    }
    let errors = [&found, &listed].map(|line| line.get(ERROR).map(|cell| cell.trim()));
    match errors {
        [None, None] => true,
        [Some(found), Some(listed)] if found == listed => true,
        [Some(found), Some(listed)] => match (found.parse(), listed.parse()) {
            (Ok(found), Ok(listed)) => is_same_error(found, listed),
            _ => false,
        },
        _ => false,
    }
}

fn is_same_error(found: f64, listed: f64) -> bool {
    let (less, more) = (found.min(listed), found.max(listed));
    let factor = if less > DISCRETISATION { 1.3 } else { 10.0 };
    more < ROUND_OFF || more <= factor * less
}
