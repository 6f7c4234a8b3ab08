//! Parser of the command line.

use std::fmt;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::thread;

use super::failure::Failure;
use super::plan::{self, Plan};

pub(super) const HELP: &str = "\
Solves rough contacts, pressed and then sheared, for all combinations of the listed values; one row of CSV each.

study [options]                    solves what the table does not have yet
study --merge TABLE PART PART ...  joins the tables of all shards, ordered by case

Cases                                                                                     [default]
  --seeds LIST       surfaces, such as 1-50 or 1,2,7-9                                     [1-4]
  --pressures LIST   mean pressure over contact modulus and rms slope                      [0.02,0.05,0.1]
  --frictions LIST   coefficients of friction                                              [0.2,0.4]
  --hursts LIST      Hurst exponents                                                       [0.8]
What they share
  --cells N          cells along either side of the periodic square                        [64]
  --pull RATIO       tangential over normal force                                          [0.1]
  --roll-off RATIO   wavelength where the spectrum begins to fall, over the side           [0.25]
  --cut-off CELLS    shortest wavelength                                                   [8]
  --tolerance X      of both solves                                                        [1e-6]
  --iterations N     limit of either solve                                                 [10000]
This run
  --shard I/N        the I-th of N parts, I from 1 to N                                    [1/1]
  --out FILE         the table, to which rows are appended              [standard output, no restart]
  --threads N        solves at once, one thread each                                       [all cores]

A table belongs to its cases and to what they share: a file of another study is refused, but seeds may be added behind
those that it has. One program at a time writes a table. Exit status: 0 if every case
has a row, converged or not; 1 if the study failed; 2 if the arguments are wrong.
";

/// Task requested on the command line.
#[derive(Debug)]
pub(super) enum Task {
    Help,
    Study(Study),
    Merge { out: PathBuf, parts: Vec<PathBuf> },
}

/// Shard of a study, with the settings of the run.
#[derive(Debug)]
pub(super) struct Study {
    pub(super) plan: Plan,
    pub(super) shard: Shard,
    pub(super) threads: usize,
    pub(super) out: Option<PathBuf>,
}

/// Part of a study: every `parts`-th press of a sequence. The sequence is shifted by one when its pattern of
/// pressures and shards would repeat, so that all shards have about equal numbers of cases of each pressure. Adding
/// seeds does not move the other presses to different shards.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shard {
    /// Number of the shard, starting at 1 like the tasks of batch systems.
    number: usize,
    parts: usize,
}

impl Task {
    pub(super) fn parse(words: &[String]) -> Result<Self, Failure> {
        if words.iter().any(|word| word == "--help" || word == "-h") {
            return Ok(Self::Help);
        }
        if let [first, files @ ..] = words {
            if first == "--merge" {
                return merge(files);
            }
        }
        let mut study = Study {
            plan: Plan::default(),
            shard: Shard {
                number: 1,
                parts: 1,
            },
            threads: thread::available_parallelism().map_or(1, NonZeroUsize::get),
            out: None,
        };
        for pair in words.chunks(2) {
            let [option, value] = pair else {
                let problem = format!("{} needs a value", pair[0]);
                return Err(Failure::Arguments(problem));
            };
            if !study.plan.set(option, value)? {
                study.set(option, value)?;
            }
        }
        study.plan.check()?;
        Ok(Self::Study(study))
    }
}

fn merge(files: &[String]) -> Result<Task, Failure> {
    match files {
        [out, parts @ ..] if !parts.is_empty() => Ok(Task::Merge {
            out: out.into(),
            parts: parts.iter().map(PathBuf::from).collect(),
        }),
        _ => {
            let problem = "--merge needs the table to write and the parts to read";
            Err(Failure::Arguments(problem.to_owned()))
        }
    }
}

impl Study {
    fn set(&mut self, option: &str, value: &str) -> Result<(), Failure> {
        let problem = match option {
            "--out" => {
                self.out = Some(value.into());
                return Ok(());
            }
            "--threads" => match plan::one::<NonZeroUsize>(value) {
                Ok(threads) => {
                    self.threads = threads.get();
                    return Ok(());
                }
                Err(problem) => problem,
            },
            "--shard" => match Shard::parse(value) {
                Some(shard) => {
                    self.shard = shard;
                    return Ok(());
                }
                None => "not I/N with I from 1 to N",
            },
            _ => "no such option",
        };
        Err(Failure::Arguments(format!("{option} {value}: {problem}")))
    }
}

impl Shard {
    fn parse(value: &str) -> Option<Self> {
        let (number, parts) = value.split_once('/')?;
        let (number, parts) = (number.parse().ok()?, parts.parse().ok()?);
        (1..=parts)
            .contains(&number)
            .then_some(Self { number, parts })
    }

    /// Returns the presses of a plan that belong to this shard.
    pub(super) fn of(self, plan: &Plan) -> impl Iterator<Item = usize> {
        let (parts, of_seed) = (self.parts, plan.presses_of_seed());
        let period = of_seed / common_divisor(of_seed, parts) * parts;
        let part = move |press: usize| (press + press / period) % parts;
        (0..plan.presses()).filter(move |&press| part(press) == self.number - 1)
    }
}

fn common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { common_divisor(b, a % b) }
}

impl fmt::Display for Shard {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}/{}", self.number, self.parts)
    }
}
