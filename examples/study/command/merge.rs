//! Merging of the tables of all shards.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::plan::Plan;
use super::table::{self, Contents};

/// Writes the rows of all parts into one file, ordered by case, and returns their number.
///
/// The bytes of the file depend only on the study, not on its division into shards. A row may occur twice if both
/// copies are identical. The plan is the largest plan of the parts. If rows disagree or are missing, no file is
/// written.
pub(super) fn merge(out: &Path, parts: &[PathBuf]) -> Result<usize, Failure> {
    let read = |path: &PathBuf| fs::read(path).map_err(Failure::of_file(path));
    let files = parts.iter().map(read).collect::<Result<Vec<_>, _>>()?;
    let texts: Vec<_> = files
        .iter()
        .map(|bytes| table::whole_lines(bytes))
        .collect();
    let mut plan: Option<Plan> = None;
    for (path, text) in parts.iter().zip(&texts) {
        let stated = table::plan_of(text).ok_or_else(|| Failure::Damaged {
            path: path.clone(),
            line: 1,
            problem: "not a table of this version of the program",
        })?;
        plan = match plan {
            Some(plan) if !stated.is_akin_to(&plan) => {
                return Err(Failure::other_study(path, stated.command(), &plan));
            }
            Some(plan) => Some(plan.larger(&stated).clone()),
            None => Some(stated),
        };
    }
    let plan = plan.ok_or_else(|| Failure::Arguments("--merge without parts".to_owned()))?;

    let mut found: BTreeMap<usize, (&str, &Path)> = BTreeMap::new();
    for (path, text) in parts.iter().zip(&texts) {
        let contents = Contents::of(&plan, text);
        contents.say_damaged(path);
        for (case, row) in contents.rows {
            match found.entry(case) {
                Entry::Vacant(place) => {
                    place.insert((row, path));
                }
                Entry::Occupied(other) if other.get().0 == row => {}
                Entry::Occupied(other) => {
                    return Err(Failure::Disagreement {
                        case: case + 1,
                        paths: [path.clone(), other.get().1.to_owned()],
                    });
                }
            }
        }
    }
    let total = plan.cases();
    if let Some(first) = (0..total).find(|case| !found.contains_key(case)) {
        return Err(Failure::Missing {
            missing: total - found.len(),
            total,
            first: first + 1,
        });
    }

    let mut merged = plan.head();
    for (row, _) in found.values() {
        merged.push_str(row);
        merged.push('\n');
    }
    replace(out, merged.as_bytes()).map_err(Failure::of_file(out))?;
    Ok(total)
}

/// Replaces a file atomically: it contains the old or the new bytes, even if the program is killed.
fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().ok_or(io::ErrorKind::InvalidInput)?);
    name.push(format!(".{}", std::process::id()));
    let temporary = path.with_file_name(name);
    let written = File::create(&temporary).and_then(|mut file| {
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::rename(&temporary, path)
    });
    if written.is_err() {
        // Only the error of writing is reported.
        let _ = fs::remove_file(&temporary);
    }
    written
}
