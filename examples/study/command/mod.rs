//! Execution of the commands of the program. The tests of the crate also call these functions.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program prints its help, its progress and its errors"
)]

mod arguments;
mod failure;
mod merge;
mod plan;
mod progress;
mod row;
mod solve;
mod table;
mod workers;

use arguments::{Study, Task};
pub(crate) use failure::Failure;
use progress::Progress;
use table::Table;
use workers::Job;

/// Executes the command given by the words of the command line.
pub(crate) fn run(words: &[String]) -> Result<(), Failure> {
    match Task::parse(words)? {
        Task::Help => print!("{}", arguments::HELP),
        Task::Study(study) => solve(&study)?,
        Task::Merge { out, parts } => {
            let cases = merge::merge(&out, &parts)?;
            eprintln!("study: {cases} cases in {}", out.display());
        }
    }
    Ok(())
}

/// Prints the reason for a failed command to standard error.
pub(crate) fn complain(failure: &Failure) {
    eprintln!("study: {failure}");
}

/// Solves the cases of a shard that its table does not contain yet.
fn solve(study: &Study) -> Result<(), Failure> {
    let plan = &study.plan;
    let mut table = Table::open(plan, study.out.as_deref())?;
    let mut jobs = Vec::new();
    let (mut total, mut missing) = (0, 0);
    for press in study.shard.of(plan) {
        let mut cases: Vec<usize> = plan.cases_of(press).collect();
        total += cases.len();
        cases.retain(|&case| !table.has(case));
        missing += cases.len();
        if !cases.is_empty() {
            jobs.push(Job { press, cases });
        }
    }
    let mut progress = Progress::new(study.shard.to_string(), total, missing);
    workers::work(plan, &jobs, study.threads, |row| {
        let Some(row) = row else {
            return table.sync();
        };
        table.add(&row.text)?;
        progress.count(row.is_solved);
        Ok(())
    })?;
    table.sync()?;
    progress.end();
    Ok(())
}
