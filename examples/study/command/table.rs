//! The table of a shard: rows are appended as they are finished, and counted when the program starts again.

use std::collections::BTreeSet;
use std::fs::{self, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::plan::Plan;
use super::row;

/// A table that grows by a row at a time.
pub(super) struct Table {
    path: PathBuf,
    lines: Box<dyn Write>,
    finished: BTreeSet<usize>,
}

impl Table {
    /// The table in a file, with the rows that it has already; without a path, a new one on standard output.
    ///
    /// A program that was killed may have left half a line at the end: it is cut off.
    pub(super) fn open(plan: &Plan, path: Option<&Path>) -> Result<Self, Failure> {
        let Some(path) = path else {
            let mut table = Self {
                path: PathBuf::from("standard output"),
                lines: Box::new(io::stdout()),
                finished: BTreeSet::new(),
            };
            table.write(&plan.head())?;
            return Ok(table);
        };
        let text = match fs::read_to_string(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => String::new(),
            text => text.map_err(Failure::of_file(path))?,
        };
        let head = plan.head();
        let has_head = text.len() >= head.len() || !head.starts_with(&text);
        let (finished, kept) = if has_head {
            let rows = rows(plan, &text, path)?;
            (
                rows.map(|row| row.map(|(case, _)| case))
                    .collect::<Result<_, _>>()?,
                whole(&text).len(),
            )
        } else {
            (BTreeSet::new(), 0)
        };
        let open = |options: &mut OpenOptions| options.open(path).map_err(Failure::of_file(path));
        if kept < text.len() {
            let file = open(OpenOptions::new().write(true))?;
            file.set_len(kept as u64).map_err(Failure::of_file(path))?;
        }
        let mut table = Self {
            path: path.to_owned(),
            lines: Box::new(open(OpenOptions::new().append(true).create(true))?),
            finished,
        };
        if kept == 0 {
            table.write(&head)?;
        }
        Ok(table)
    }

    pub(super) fn has(&self, case: usize) -> bool {
        self.finished.contains(&case)
    }

    pub(super) fn add(&mut self, row: &str) -> Result<(), Failure> {
        self.write(&format!("{row}\n"))
    }

    /// Whole lines in one call, so that a program killed later has written them.
    fn write(&mut self, lines: &str) -> Result<(), Failure> {
        let written = self.lines.write_all(lines.as_bytes());
        written
            .and_then(|()| self.lines.flush())
            .map_err(Failure::of_file(&self.path))
    }
}

/// The rows in the text of a table, each with its case; half a line at the end is not a row.
pub(super) fn rows<'a>(
    plan: &'a Plan,
    text: &'a str,
    path: &'a Path,
) -> Result<impl Iterator<Item = Result<(usize, &'a str), Failure>>, Failure> {
    let head = plan.head();
    let Some(lines) = whole(text).strip_prefix(&head) else {
        let first = |text: &str| text.lines().next().unwrap_or_default().to_owned();
        return Err(Failure::OtherStudy {
            path: path.to_owned(),
            found: first(text),
            expected: first(&head),
        });
    };
    let numbered = lines.lines().enumerate();
    Ok(
        numbered.map(move |(index, line)| match case_of(plan, line) {
            Some(case) => Ok((case, line)),
            None => Err(Failure::Damaged {
                path: path.to_owned(),
                line: head.lines().count() + index + 1,
                problem: "not a row of this study",
            }),
        }),
    )
}

/// The case of a row, if the row has all columns and the key of a case of the plan.
fn case_of(plan: &Plan, line: &str) -> Option<usize> {
    let (number, _) = line.split_once(',')?;
    let case = number.parse::<usize>().ok()?.checked_sub(1)?;
    let is_row = case < plan.cases()
        && line.split(',').count() == row::WIDTH
        && line.strip_prefix(&plan.key(case))?.starts_with(',');
    is_row.then_some(case)
}

/// All lines of a text that have ended.
fn whole(text: &str) -> &str {
    text.rfind('\n').map_or("", |end| &text[..=end])
}
