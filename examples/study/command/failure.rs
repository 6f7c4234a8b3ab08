//! Errors of the program.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use super::plan::Plan;

/// Error of a command. A solve that does not converge is not an error, but results in a row.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    #[error("{0}; `study --help` lists the options")]
    Arguments(String),
    #[error(transparent)]
    Contact(#[from] stickslip::Error),
    #[error("threads: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    #[error("{}: {source}", path.display())]
    File { path: PathBuf, source: io::Error },
    /// Another program is writing the table. Two programs would solve each case twice.
    #[error("{}: another program is writing this table", .0.display())]
    Busy(PathBuf),
    /// The head of the file belongs to a different study.
    #[error(
        "{} is not a table of this study\n  its head: {}\n  expected: {}",
        path.display(), Start(found), Start(expected)
    )]
    OtherStudy {
        path: PathBuf,
        found: String,
        expected: String,
    },
    #[error("{}, line {line}: {problem}", path.display())]
    Damaged {
        path: PathBuf,
        line: usize,
        problem: &'static str,
    },
    #[error("case {case} has other results in {} than in {}", paths[0].display(), paths[1].display())]
    Disagreement { case: usize, paths: [PathBuf; 2] },
    #[error("{missing} of {total} cases are missing, the first of them is case {first}")]
    Missing {
        missing: usize,
        total: usize,
        first: usize,
    },
}

impl Failure {
    /// Creates the error for a table whose first line does not state the expected plan.
    pub(super) fn other_study(path: &Path, found: String, expected: &Plan) -> Self {
        Self::OtherStudy {
            path: path.to_owned(),
            found,
            expected: expected.command(),
        }
    }

    /// Returns a function for `map_err` that adds the path of the file.
    pub(super) fn of_file(path: &Path) -> impl Fn(io::Error) -> Self {
        move |source| Self::File {
            path: path.to_owned(),
            source,
        }
    }
}

/// Beginning of a text, short enough for the screen.
struct Start<'a>(&'a str);

impl fmt::Display for Start<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.trim_end().char_indices().nth(400) {
            None => write!(formatter, "{}", self.0.trim_end()),
            Some((end, _)) => write!(formatter, "{} ...", &self.0[..end]),
        }
    }
}
