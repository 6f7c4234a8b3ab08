//! The table of a shard: rows are appended as they are finished, and counted when the program starts again.

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

/// Rows that a machine without power may lose are those of the last second.
const BETWEEN_SYNCS: Duration = Duration::from_secs(1);

/// A table that grows by a row at a time.
pub(super) struct Table {
    path: PathBuf,
    lines: Lines,
    finished: BTreeSet<usize>,
}

/// Where lines go.
enum Lines {
    Output,
    /// A file that no other program writes while it is open here.
    File {
        file: File,
        /// Bytes of whole lines.
        length: u64,
        synced: Instant,
    },
}

impl Table {
    /// The table in a file, with the rows that it has already; without a path, a new one on standard output.
    ///
    /// Half a line at its end, of a program that was killed, is cut off. Lines that are no rows are left where they are,
    /// and named. A table of a plan of fewer seeds is continued as one of this plan.
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
        // The system gives it back when the program ends, however it ends.
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

    /// Waits until the disk has what was written.
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

    /// Whole lines in one call, so that a program killed later has written them; or nothing, where the disk is full.
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
                    // A part that cannot be taken back is cut off by the next program.
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

/// What the lines of a table say.
pub(super) struct Contents<'a> {
    /// Each row with its case.
    pub(super) rows: Vec<(usize, &'a str)>,
    /// Numbers of the lines that are neither rows nor plans.
    damaged: Vec<usize>,
}

impl<'a> Contents<'a> {
    /// Below the head, by a plan that has all cases.
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

    /// Names the lines that are left out.
    pub(super) fn say_damaged(&self, path: &Path) {
        for line in &self.damaged {
            let path = path.display();
            eprintln!("study: {path}, line {line}: not a row of this study, left out");
        }
    }
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

/// The largest plan that a table states; none if the text does not begin with the head of a table.
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

/// All lines that have ended; what is no text in them is replaced, and makes no row.
pub(super) fn whole_lines(bytes: &[u8]) -> Cow<'_, str> {
    String::from_utf8_lossy(&bytes[..text_end(bytes)])
}

/// Behind the last line that has ended.
fn text_end(bytes: &[u8]) -> usize {
    bytes
        .iter()
        .rposition(|&byte| byte == b'\n')
        .map_or(0, |end| end + 1)
}
