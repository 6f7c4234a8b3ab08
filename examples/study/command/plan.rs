//! Plan of a study: its cases, their order, and their common settings.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

use super::failure::Failure;
use super::row;

/// All combinations of the listed values, with their common settings.
///
/// Cases that differ only in friction have the same pressure field. Together they form a *press*, the unit of work. The case
/// number counts frictions first, then pressures, Hurst exponents and seeds. Because seeds come last, adding seeds does not
/// change the case numbers of a plan.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Plan {
    /// Number of cells along either side.
    pub(super) cells: usize,
    pub(super) hursts: Vec<f64>,
    /// Mean pressures, divided by the contact modulus times the rms slope.
    pub(super) pressures: Vec<f64>,
    pub(super) seeds: Vec<u64>,
    pub(super) frictions: Vec<f64>,
    /// Ratio of tangential to normal force.
    pub(super) pull: f64,
    /// Roll-off wavelength divided by the side.
    pub(super) roll_off: f64,
    /// Cut-off wavelength in cells.
    pub(super) cut_off: f64,
    pub(super) tolerance: f64,
    pub(super) iterations: usize,
}

impl Default for Plan {
    fn default() -> Self {
        Self {
            cells: 64,
            hursts: vec![0.8],
            pressures: vec![0.02, 0.05, 0.1],
            seeds: (1..=4).collect(),
            frictions: vec![0.2, 0.4],
            pull: 0.1,
            roll_off: 0.25,
            cut_off: 8.0,
            tolerance: 1e-6,
            iterations: 10_000,
        }
    }
}

/// Parameters that determine a pressure field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Press {
    pub(super) hurst: f64,
    pub(super) pressure: f64,
    pub(super) seed: u64,
}

/// Beginning of the first line of a table. It contains the version, because a different version might compute different
/// digits.
const TITLE: &str = concat!("# stickslip ", env!("CARGO_PKG_VERSION"), " study");
/// Number of lines above the first row.
pub(super) const HEAD_LINES: usize = 2;
/// Maximum number of cases. A larger number indicates a mistake in a range of seeds.
const MOST_CASES: usize = 10_000_000;

impl Plan {
    /// Sets the value of an option. Returns false if a plan has no such option.
    pub(super) fn set(&mut self, option: &str, value: &str) -> Result<bool, Failure> {
        let parsed = match option {
            "--cells" => one(value).map(|cells| self.cells = cells),
            "--hursts" => list(value).map(|hursts| self.hursts = hursts),
            "--pressures" => list(value).map(|pressures| self.pressures = pressures),
            "--seeds" => seeds(value).map(|seeds| self.seeds = seeds),
            "--frictions" => list(value).map(|frictions| self.frictions = frictions),
            "--pull" => one(value).map(|pull| self.pull = pull),
            "--roll-off" => one(value).map(|roll_off| self.roll_off = roll_off),
            "--cut-off" => one(value).map(|cut_off| self.cut_off = cut_off),
            "--tolerance" => one(value).map(|tolerance| self.tolerance = tolerance),
            "--iterations" => one(value).map(|iterations| self.iterations = iterations),
            _ => return Ok(false),
        };
        let refuse = |problem| Failure::Arguments(format!("{option} {value}: {problem}"));
        parsed.map(|()| true).map_err(refuse)
    }

    /// Checks all values before the first solve. Returns an error for values that no surface, load or solver accepts.
    pub(super) fn check(&self) -> Result<(), Failure> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let all = |values: &[f64], rule: fn(f64) -> bool| values.iter().all(|&value| rule(value));
        let shortest = self.cut_off / self.cells as f64;
        let lists = [&self.hursts, &self.pressures, &self.frictions];
        let distinct = lists.into_iter().all(|values| {
            let bits: Vec<u64> = values.iter().map(|value| value.to_bits()).collect();
            is_distinct(bits)
        });
        let presses = [self.hursts.len(), self.pressures.len(), self.seeds.len()];
        let lengths = presses.into_iter().chain([self.frictions.len()]);
        let cases = lengths.fold(1, usize::saturating_mul);
        let rules = [
            (
                all(&self.hursts, |hurst| (0.0..=1.0).contains(&hurst)),
                "--hursts must lie between 0 and 1",
            ),
            (
                all(&self.pressures, positive),
                "--pressures must be positive",
            ),
            (
                all(&self.frictions, positive),
                "--frictions must be positive",
            ),
            (positive(self.pull), "--pull must be positive"),
            (
                self.cut_off >= 2.0 && shortest <= self.roll_off && self.roll_off <= 1.0,
                "--cut-off must be at least two cells, --roll-off no shorter than it and no longer than the side",
            ),
            (
                self.tolerance > 0.0 && self.tolerance < 1.0,
                "--tolerance must lie between 0 and 1",
            ),
            (self.iterations > 0, "--iterations must be at least 1"),
            (
                distinct && is_distinct(self.seeds.clone()),
                "a value is listed twice",
            ),
            (cases <= MOST_CASES, "these are more than ten million cases"),
        ];
        match rules.into_iter().find(|(holds, _)| !holds) {
            Some((_, rule)) => Err(Failure::Arguments(rule.to_owned())),
            None => Ok(()),
        }
    }

    /// Returns whether the plans are equal, except that one of them may have additional seeds at the end.
    pub(super) fn is_akin_to(&self, other: &Self) -> bool {
        let common = self.seeds.len().min(other.seeds.len());
        let of = |plan: &Self| Self {
            seeds: plan.seeds[..common].to_vec(),
            ..plan.clone()
        };
        of(self) == of(other)
    }

    /// Returns the plan with more seeds, or `self` if the numbers are equal.
    pub(super) fn larger<'p>(&'p self, other: &'p Self) -> &'p Self {
        if other.seeds.len() > self.seeds.len() {
            other
        } else {
            self
        }
    }

    /// Returns the number of presses per seed.
    pub(super) fn presses_of_seed(&self) -> usize {
        self.hursts.len() * self.pressures.len()
    }

    pub(super) fn presses(&self) -> usize {
        self.presses_of_seed() * self.seeds.len()
    }

    pub(super) fn cases(&self) -> usize {
        self.presses() * self.frictions.len()
    }

    pub(super) fn press(&self, press: usize) -> Press {
        let (rest, pressure) = (press / self.pressures.len(), press % self.pressures.len());
        let (seed, hurst) = (rest / self.hursts.len(), rest % self.hursts.len());
        Press {
            hurst: self.hursts[hurst],
            pressure: self.pressures[pressure],
            seed: self.seeds[seed],
        }
    }

    pub(super) fn cases_of(&self, press: usize) -> Range<usize> {
        let frictions = self.frictions.len();
        press * frictions..(press + 1) * frictions
    }

    pub(super) fn friction(&self, case: usize) -> f64 {
        self.frictions[case % self.frictions.len()]
    }

    /// Returns the first columns of a row, [`row::KEY`].
    pub(super) fn key(&self, case: usize) -> String {
        let press = self.press(case / self.frictions.len());
        let Press {
            hurst,
            pressure,
            seed,
        } = press;
        format!(
            "{},{},{hurst:?},{pressure:?},{seed},{:?},{:?}",
            case + 1,
            self.cells,
            self.friction(case),
            self.pull,
        )
    }

    /// Returns the lines above the rows of a table: the command that repeats the study, and the columns.
    pub(super) fn head(&self) -> String {
        format!("{}{}\n", self.command(), row::columns())
    }

    /// Returns the line that states the plan.
    pub(super) fn command(&self) -> String {
        format!("{TITLE}{self}\n")
    }

    /// Parses the plan of a text that begins with a [head](Self::head).
    pub(super) fn of_head(text: &str) -> Option<Self> {
        let plan = Self::of_command(text.lines().next()?)?;
        text.starts_with(&plan.head()).then_some(plan)
    }

    /// Parses the plan that a line states.
    pub(super) fn of_command(line: &str) -> Option<Self> {
        let words: Vec<&str> = line.strip_prefix(TITLE)?.split_whitespace().collect();
        let mut plan = Self::default();
        for pair in words.chunks(2) {
            let [option, value] = *pair else { return None };
            plan.set(option, value).ok().filter(|&known| known)?;
        }
        plan.check().ok()?;
        (line == plan.command().trim_end()).then_some(plan)
    }
}

/// Formats the options that define this plan.
impl fmt::Display for Plan {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            " --cells {} --hursts {} --pressures {} --seeds {} --frictions {} --pull {:?} --roll-off {:?} \
             --cut-off {:?} --tolerance {:?} --iterations {}",
            self.cells,
            joined(&self.hursts),
            joined(&self.pressures),
            ranges(&self.seeds),
            joined(&self.frictions),
            self.pull,
            self.roll_off,
            self.cut_off,
            self.tolerance,
            self.iterations,
        )
    }
}

pub(super) fn one<T: FromStr>(value: &str) -> Result<T, &'static str> {
    value.parse().map_err(|_| "not a number of this option")
}

fn list(value: &str) -> Result<Vec<f64>, &'static str> {
    value.split(',').map(one).collect()
}

/// Parses numbers and ranges such as `1-20,25`.
fn seeds(value: &str) -> Result<Vec<u64>, &'static str> {
    let mut seeds = Vec::new();
    for part in value.split(',') {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        let (first, last): (u64, u64) = (one(first)?, one(last)?);
        match last.checked_sub(first) {
            None => return Err("a range that ends before it begins"),
            Some(more) if more >= MOST_CASES as u64 => return Err("more than ten million seeds"),
            Some(_) => seeds.extend(first..=last),
        }
    }
    Ok(seeds)
}

fn joined(values: &[f64]) -> String {
    let words: Vec<String> = values.iter().map(|value| format!("{value:?}")).collect();
    words.join(",")
}

/// Formats seeds as ranges, so that the text does not depend on the spelling of the option.
fn ranges(seeds: &[u64]) -> String {
    let runs = seeds.chunk_by(|&seed, &next| seed.checked_add(1) == Some(next));
    let words: Vec<String> = runs
        .map(|run| match *run {
            [first, .., last] => format!("{first}-{last}"),
            [seed] => seed.to_string(),
            [] => String::new(),
        })
        .collect();
    words.join(",")
}

fn is_distinct(mut values: Vec<u64>) -> bool {
    let count = values.len();
    values.sort_unstable();
    values.dedup();
    values.len() == count
}
