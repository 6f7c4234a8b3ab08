//! Axes with ticks at round numbers.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// Largest number of intervals between ticks. A range of 1.4 receives seven intervals.
const INTERVALS: f64 = 7.2;

/// Axis with its ticks and their labels.
#[derive(Debug, Clone)]
pub(crate) struct Axis {
    range: Range<f64>,
    ticks: Vec<f64>,
    /// Positions of faint lines between the ticks.
    between: Vec<f64>,
    label: Label,
}

/// Form of the labels of ticks.
#[derive(Debug, Clone, Copy)]
enum Label {
    /// Number with the given number of decimals.
    Decimals(usize),
    /// Magnitude of a number with the given number of decimals.
    Magnitude(usize),
    /// Power of ten, given its exponent.
    Power,
    /// Number with one significant digit, given its logarithm.
    Number,
}

impl Axis {
    /// Returns a linear axis.
    pub(crate) fn linear(range: Range<f64>) -> Self {
        let (ticks, decimals) = round_numbers(&range, INTERVALS);
        let label = Label::Decimals(decimals);
        let between = Vec::new();
        Self {
            range,
            ticks,
            between,
            label,
        }
    }

    /// Returns a linear axis of negative positions whose labels are magnitudes, such as the depth below a surface.
    pub(crate) fn depth(range: Range<f64>) -> Self {
        let (ticks, decimals) = round_numbers(&range, INTERVALS);
        let label = Label::Magnitude(decimals);
        let between = Vec::new();
        Self {
            range,
            ticks,
            between,
            label,
        }
    }

    /// Returns an axis for decimal logarithms. Ticks are at powers of ten, or at one, two and five times powers of ten if the
    /// range contains fewer than two powers.
    pub(crate) fn decades(range: Range<f64>) -> Self {
        let contains = |exponent: &f64| range.start <= *exponent && *exponent <= range.end;
        let powers: Vec<_> = (-30..=30).map(f64::from).filter(contains).collect();
        let digits = |exponent: i32| {
            (2..10).map(move |digit| f64::from(exponent) + f64::from(digit).log10())
        };
        let between = (-30..30).flat_map(digits).filter(contains).collect();
        let few = powers.len() < 2;
        let ticks = if few {
            let digits = [1.0_f64, 2.0, 5.0].map(f64::log10);
            let numbers = (-30..30).flat_map(|exponent| digits.map(|d| f64::from(exponent) + d));
            numbers.filter(contains).collect()
        } else {
            let every = (1..=30).find(|every| powers.len() as f64 / f64::from(*every) <= INTERVALS);
            let every = f64::from(every.unwrap_or(1));
            let multiple = |exponent: &f64| exponent.rem_euclid(every) == 0.0;
            powers.into_iter().filter(multiple).collect()
        };
        let label = if few { Label::Number } else { Label::Power };
        Self {
            range,
            ticks,
            between,
            label,
        }
    }

    /// Returns an axis without ticks.
    pub(crate) fn without_ticks(range: Range<f64>) -> Self {
        Self {
            range,
            ticks: Vec::new(),
            between: Vec::new(),
            label: Label::Decimals(0),
        }
    }

    /// Removes ticks until their labels fit next to each other into a length.
    pub(crate) fn fitted(mut self, length: i32) -> Self {
        let mut intervals = INTERVALS;
        while intervals > 2.0 && (self.label_width() + 40) * self.count() > length {
            intervals -= 1.0;
            let (ticks, decimals) = round_numbers(&self.range, intervals);
            match self.label {
                Label::Decimals(_) => self.label = Label::Decimals(decimals),
                Label::Magnitude(_) => self.label = Label::Magnitude(decimals),
                Label::Power | Label::Number => break,
            }
            self.ticks = ticks;
        }
        self
    }

    fn count(&self) -> i32 {
        i32::try_from(self.ticks.len()).unwrap_or(0)
    }

    /// Returns the positions of faint lines between the ticks.
    pub(crate) fn between(&self) -> &[f64] {
        &self.between
    }

    /// Returns the width of the longest label of a tick; a digit is about half as wide as high.
    pub(crate) fn label_width(&self) -> i32 {
        let lengths = self
            .ticks
            .iter()
            .map(|tick| self.format_ext(tick).chars().count());
        30 * i32::try_from(lengths.max().unwrap_or(0)).unwrap_or(0)
    }

    /// Returns both ends.
    pub(crate) fn ends(&self) -> [f64; 2] {
        [self.range.start, self.range.end]
    }
}

/// Returns multiples of one, two or five times a power of ten in a range, with at most the given number of intervals, and the
/// number of their decimals.
fn round_numbers(range: &Range<f64>, intervals: f64) -> (Vec<f64>, usize) {
    let span = range.end - range.start;
    #[expect(clippy::cast_possible_truncation, reason = "a small number")]
    let first = (span / intervals).log10().floor() as i32;
    let steps =
        (first..first + 3).flat_map(|exponent| [1.0, 2.0, 5.0].map(|digit| (digit, exponent)));
    let mut steps = steps.map(|(digit, exponent)| (digit * 10_f64.powi(exponent), exponent));
    let (step, exponent) = steps
        .find(|(step, _)| span / step <= intervals)
        .unwrap_or((span, 0));
    // Both ends are ticks even if they are rounded.
    let ends = [range.start / step - 1e-6, range.end / step + 1e-6];
    #[expect(clippy::cast_possible_truncation, reason = "less than ten steps")]
    let [first, last] = [ends[0].ceil() as i64, ends[1].floor() as i64];
    let ticks = (first..=last).map(|tick| tick as f64 * step).collect();
    (ticks, (-exponent).max(0).unsigned_abs() as usize)
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (start, end): (i32, i32)) -> i32 {
        let part = (value - self.range.start) / (self.range.end - self.range.start);
        let (start, end) = (f64::from(start), f64::from(end));
        #[expect(clippy::cast_possible_truncation, reason = "pixels of a drawing")]
        let pixel = (start + part * (end - start)).round() as i32;
        pixel
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, value: &f64) -> String {
        match self.label {
            // Adding zero turns a negative zero into a positive one.
            Label::Decimals(digits) => format!("{:.digits$}", value + 0.0).replace('-', "\u{2212}"),
            Label::Magnitude(digits) => format!("{:.digits$}", value.abs()),
            Label::Power => power_of_ten(*value),
            Label::Number => format!("{}", one_digit(*value)),
        }
    }
}

/// Returns ten to a power, rounded to one significant digit.
fn one_digit(exponent: f64) -> f64 {
    let decade = exponent.floor();
    let digit = 10_f64.powf(exponent - decade).round();
    // Division by a power of ten returns the double nearest to the decimal number.
    if decade < 0.0 {
        digit / 10_f64.powf(-decade)
    } else {
        digit * 10_f64.powf(decade)
    }
}

/// Formats a power of ten: `10⁻⁶` for -6.
fn power_of_ten(exponent: f64) -> String {
    let superscript = |digit| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => {
            char::from_u32(u32::from('⁰') + u32::from(digit) - u32::from('0')).unwrap_or(digit)
        }
    };
    // Adding zero turns a negative zero into a positive one.
    let digits: String = format!("{:.0}", exponent.round() + 0.0)
        .chars()
        .map(superscript)
        .collect();
    format!("10{digits}")
}
