//! Table of a shard. Rows are appended when they are finished. A restarted program skips the existing rows.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fs::{File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use fs2::FileExt;

use super::failure::Failure;
use super::plan::{self, Plan};
use super::row;

/// Time between two syncs to the disk. A power failure can lose only the rows of the last second.
const BETWEEN_SYNCS: Duration = Duration::from_secs(1);

/// Table to which rows are appended.
pub(super) struct Table {
    path: PathBuf,
    lines: Lines,
    finished: BTreeSet<usize>,
}

/// Destination of the lines.
enum Lines {
    Output,
    /// A locked file, which no other program writes.
    File {
        file: File,
        /// Number of bytes of complete lines.
        length: u64,
        synced: Instant,
    },
}

impl Table {
    /// Opens the table in a file with its existing rows. Without a path, creates a new table on standard output.
    ///
    /// An incomplete last line, left by a program that was killed, is removed. Lines that are not rows are kept and
    /// reported. A table of a plan with fewer seeds is continued as a table of this plan.
    pub(super) fn open(plan: &Plan, path: Option<&Path>) -> Result<Self, Failure> {
        let Some(path) = path else {
            let mut table = Self {
                path: PathBuf::from("standard output"),
                lines: Lines::Output,
                finished: BTreeSet::new(),
            };
            table.write(&plan.head())?;
            return Ok(table);
        };
        let of_file = Failure::of_file(path);
        let mut options = OpenOptions::new();
        options.read(true).append(true).create(true);
        let mut file = options.open(path).map_err(&of_file)?;
        // The operating system releases the lock when the program ends for any reason.
        if let Err(error) = file.try_lock_exclusive() {
            let is_busy = error.kind() == fs2::lock_contended_error().kind();
            let busy = || Failure::Busy(path.to_owned());
            return Err(if is_busy { busy() } else { of_file(error) });
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(&of_file)?;
        let head = plan.head();
        let is_new = bytes.len() < head.len() && head.as_bytes().starts_with(&bytes);
        let text = whole_lines(&bytes);
        let mut finished = BTreeSet::new();
        let (mut length, mut addition) = (0, head);
        if !is_new {
            let stated = plan_of(&text).filter(|stated| stated.is_akin_to(plan));
            let Some(stated) = stated else {
                let found = text.lines().next().unwrap_or_default().to_owned();
                return Err(Failure::other_study(path, found, plan));
            };
            let larger = stated.larger(plan);
            let contents = Contents::of(larger, &text);
            contents.say_damaged(path);
            finished.extend(contents.rows.iter().map(|(case, _)| case));
            length = text_end(&bytes) as u64;
            addition = if stated == *larger {
                String::new()
            } else {
                plan.command()
            };
        }
        if length < bytes.len() as u64 {
            file.set_len(length).map_err(&of_file)?;
        }
        let lines = Lines::File {
            file,
            length,
            synced: Instant::now(),
        };
        let mut table = Self {
            path: path.to_owned(),
            lines,
            finished,
        };
        if !addition.is_empty() {
            table.write(&addition)?;
            table.sync()?;
        }
        Ok(table)
    }

    pub(super) fn has(&self, case: usize) -> bool {
        self.finished.contains(&case)
    }

    pub(super) fn add(&mut self, row: &str) -> Result<(), Failure> {
        self.write(&format!("{row}\n"))
    }

    /// Waits until all written rows are on the disk.
    pub(super) fn sync(&mut self) -> Result<(), Failure> {
        let synced = match &mut self.lines {
            Lines::Output => io::stdout().flush(),
            Lines::File { file, synced, .. } => {
                *synced = Instant::now();
                file.sync_data()
            }
        };
        synced.map_err(Failure::of_file(&self.path))
    }

    /// Writes complete lines in one call, so that they are kept if the program is killed later. If the disk is full, no
    /// part of the lines is kept.
    fn write(&mut self, lines: &str) -> Result<(), Failure> {
        match &mut self.lines {
            Lines::Output => {
                let mut output = io::stdout().lock();
                let written = output.write_all(lines.as_bytes());
                let flushed = written.and_then(|()| output.flush());
                flushed.map_err(Failure::of_file(&self.path))
            }
            Lines::File {
                file,
                length,
                synced,
            } => {
                if let Err(error) = file.write_all(lines.as_bytes()) {
                    // If the incomplete line cannot be removed now, the next run removes it.
                    let _ = file.set_len(*length);
                    return Err(Failure::of_file(&self.path)(error));
                }
                *length += lines.len() as u64;
                if synced.elapsed() < BETWEEN_SYNCS {
                    return Ok(());
                }
                self.sync()
            }
        }
    }
}

/// Parsed lines of a table.
pub(super) struct Contents<'a> {
    /// Rows with their case numbers.
    pub(super) rows: Vec<(usize, &'a str)>,
    /// Numbers of the lines that are neither rows nor plans.
    damaged: Vec<usize>,
}

impl<'a> Contents<'a> {
    /// Parses the lines below the head for a plan that contains all cases.
    pub(super) fn of(plan: &Plan, text: &'a str) -> Self {
        let (mut rows, mut damaged) = (Vec::new(), Vec::new());
        for (index, line) in text.lines().enumerate().skip(plan::HEAD_LINES) {
            if let Some(case) = case_of(plan, line) {
                rows.push((case, line));
            } else if !Plan::of_command(line).is_some_and(|other| other.is_akin_to(plan)) {
                damaged.push(index + 1);
            }
        }
        Self { rows, damaged }
    }

    /// Reports the ignored lines.
    pub(super) fn say_damaged(&self, path: &Path) {
        for line in &self.damaged {
            let path = path.display();
            eprintln!("study: {path}, line {line}: not a row of this study, left out");
        }
    }
}

/// Returns the case of a row, or `None` if the row lacks columns or its key is not a case of the plan.
fn case_of(plan: &Plan, line: &str) -> Option<usize> {
    let (number, _) = line.split_once(',')?;
    let case = number.parse::<usize>().ok()?.checked_sub(1)?;
    let is_row = case < plan.cases()
        && line.split(',').count() == row::WIDTH
        && line.strip_prefix(&plan.key(case))?.starts_with(',');
    is_row.then_some(case)
}

/// Returns the largest plan that a table states, or `None` if the text does not begin with the head of a table.
pub(super) fn plan_of(text: &str) -> Option<Plan> {
    let first = Plan::of_head(text)?;
    let others = text.lines().skip(plan::HEAD_LINES);
    let others = others.filter_map(Plan::of_command);
    let larger = |plan: Plan, other: Plan| {
        if other.is_akin_to(&plan) {
            plan.larger(&other).clone()
        } else {
            plan
        }
    };
    Some(others.fold(first, larger))
}

/// Returns all complete lines. Bytes that are not UTF-8 are replaced, so that such a line is not a valid row.
pub(super) fn whole_lines(bytes: &[u8]) -> Cow<'_, str> {
    String::from_utf8_lossy(&bytes[..text_end(bytes)])
}

/// Returns the position after the last complete line.
fn text_end(bytes: &[u8]) -> usize {
    bytes
        .iter()
        .rposition(|&byte| byte == b'\n')
        .map_or(0, |end| end + 1)
}
