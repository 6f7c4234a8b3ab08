//! Progress on standard error: finished cases, rate and remaining time.

use std::io::{IsTerminal, stderr};
use std::time::{Duration, Instant};

/// Intervals between two lines on a terminal, and in the log of a batch system.
const INTERVALS: [Duration; 2] = [Duration::from_secs(1), Duration::from_secs(10)];

/// Counter of cases that prints the progress at intervals.
#[derive(Debug)]
pub(super) struct Progress {
    shard: String,
    total: usize,
    /// Number of cases that this run has to solve.
    missing: usize,
    solved: usize,
    unsolved: usize,
    begin: Instant,
    said: Instant,
    interval: Duration,
}

impl Progress {
    pub(super) fn new(shard: String, total: usize, missing: usize) -> Self {
        if missing < total {
            let there = total - missing;
            eprintln!("study {shard}: {there} of {total} cases are there already");
        }
        let now = Instant::now();
        Self {
            shard,
            total,
            missing,
            solved: 0,
            unsolved: 0,
            begin: now,
            said: now,
            interval: INTERVALS[usize::from(!stderr().is_terminal())],
        }
    }

    pub(super) fn count(&mut self, is_solved: bool) {
        self.solved += 1;
        self.unsolved += usize::from(!is_solved);
        if self.said.elapsed() < self.interval || self.solved == self.missing {
            return;
        }
        self.said = Instant::now();
        let rate = self.rate();
        let remaining = self.missing - self.solved;
        eprintln!(
            "study {}: {} of {} cases, {rate:.2} a second, {} left",
            self.shard,
            self.total - remaining,
            self.total,
            clock(remaining as f64 / rate),
        );
    }

    pub(super) fn end(&self) {
        eprintln!(
            "study {}: all {} cases, {} of them now in {}, {:.2} a second; {} unsolved",
            self.shard,
            self.total,
            self.solved,
            clock(self.begin.elapsed().as_secs_f64()),
            self.rate(),
            self.unsolved,
        );
    }

    /// Returns the number of cases per second of this run.
    fn rate(&self) -> f64 {
        let seconds = self.begin.elapsed().as_secs_f64();
        self.solved as f64 / seconds.max(f64::MIN_POSITIVE)
    }
}

/// Formats a time in readable units: `35.1 s`, `12 min`, `7.5 h`.
fn clock(seconds: f64) -> String {
    if seconds < 100.0 {
        format!("{seconds:.1} s")
    } else if seconds < 6000.0 {
        format!("{:.0} min", seconds / 60.0)
    } else {
        format!("{:.1} h", seconds / 3600.0)
    }
}
