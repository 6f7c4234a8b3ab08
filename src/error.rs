//! Every way a call can be refused or fail, with the offending number.

mod check;

use std::fmt;

pub(crate) use check::{
    all_finite, all_non_negative, at_least, finite, length, memory, non_negative, not_converged,
    positive, samples_obey,
};

use crate::report::Report;

/// The result of a call that can be refused.
pub type Result<T> = std::result::Result<T, Error>;

/// What was wrong: one variant per rule broken, with the offending number.
///
/// Arguments are checked before any work, and a call that fails leaves the caller's state as it was; except that on
/// [`Error::NotConverged`] `solve_into` and `solve_observed` leave the last feasible iterate in the solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A grid needs at least one cell along each axis.
    #[error("a grid of {nx} x {ny} cells is empty")]
    GridSize {
        /// Cells along x.
        nx: usize,
        /// Cells along y.
        ny: usize,
    },
    /// The memory something takes cannot be had. Nothing was taken.
    #[error("{quantity} takes {bytes} bytes of memory, which cannot be had")]
    Memory {
        /// What takes it, in words.
        quantity: &'static str,
        /// Bytes needed.
        bytes: u128,
    },
    /// A quantity that must be positive and finite is not.
    #[error("{quantity} must be positive and finite, got {value}")]
    NotPositive {
        /// The quantity, in words.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A quantity that must be zero or positive, and finite, is not.
    #[error("{quantity} must be non-negative and finite, got {value}")]
    Negative {
        /// The quantity, in words.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A quantity that must be finite is not.
    #[error("{quantity} must be finite, got {value}")]
    NotFinite {
        /// The quantity, in words.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// One sample of a field breaks the rule its field must keep.
    #[error("{quantity} at index {index} is {value}: {rule}")]
    Sample {
        /// The field, in words.
        quantity: &'static str,
        /// Index into the row-major samples.
        index: usize,
        /// The value found there.
        value: f64,
        /// The rule, in words.
        rule: &'static str,
    },
    /// Poisson's ratio lies outside `(-1, 1/2]`, where an isotropic body is stable.
    #[error("Poisson's ratio must lie in (-1, 0.5], got {0}")]
    PoissonRatio(f64),
    /// Two rigid bodies do not deform: there is nothing to solve.
    #[error("both bodies are rigid")]
    BothRigid,
    /// Normal and tangential tractions of the two materials are coupled, and the model neglects that.
    #[error(
        "the pair couples pressure and shear (Dundurs beta = {beta:e}): call neglect_coupling() to accept an error of that order"
    )]
    CoupledMaterials {
        /// Dundurs' second parameter of the pair.
        beta: f64,
    },
    /// A slice, field or list has the wrong number of entries.
    #[error("{quantity} has {found} entries, expected {expected}")]
    Length {
        /// The slice or list, in words.
        quantity: &'static str,
        /// Entries needed.
        expected: usize,
        /// Entries given.
        found: usize,
    },
    /// Two fields or bodies live on different grids.
    #[error(
        "{quantity} lives on {found_cells:?} cells of sides {found_sides:?}, expected {expected_cells:?} of {expected_sides:?}"
    )]
    GridMismatch {
        /// The field, in words.
        quantity: &'static str,
        /// Cells along x and y of the rest.
        expected_cells: [usize; 2],
        /// Sides of the cells of the rest (lengths).
        expected_sides: [f64; 2],
        /// Cells along x and y of the field.
        found_cells: [usize; 2],
        /// Sides of the cells of the field (lengths).
        found_sides: [f64; 2],
    },
    /// A solution belongs to bodies with another boundary.
    #[error("{quantity} belongs to bodies with another boundary")]
    BoundaryMismatch {
        /// The solution, in words.
        quantity: &'static str,
    },
    /// A tolerance outside `(0, 1)` certifies nothing.
    #[error("the tolerance must lie strictly between 0 and 1, got {0}")]
    Tolerance(f64),
    /// A limit of zero iterations leaves nothing to report.
    #[error("the iteration limit must be at least 1")]
    IterationLimit,
    /// The bounds of one entry leave it no value.
    #[error("the bounds [{lower}, {upper}] of entry {index} hold no finite value")]
    Bounds {
        /// The entry.
        index: usize,
        /// Its lower bound.
        lower: f64,
        /// Its upper bound.
        upper: f64,
    },
    /// No point within the bounds has the prescribed total.
    #[error("the total {total:e} is outside what the bounds allow, [{lower:e}, {upper:e}]")]
    Total {
        /// The total prescribed.
        total: f64,
        /// The least total within the bounds.
        lower: f64,
        /// The greatest total within the bounds.
        upper: f64,
    },
    /// A direction occurs twice among those of one operator.
    #[error("the directions of an operator must differ from each other")]
    RepeatedDirection,
    /// The bodies do not touch: there is no contact to shear.
    #[error(
        "the contact is empty: no cell carries pressure, as under no load or an approach that does not close the least gap"
    )]
    EmptyContact,
    /// More tangential force than friction can hold: no equilibrium exists.
    #[error("a tangential force of {force:e} exceeds the friction limit {limit:e}")]
    BeyondSliding {
        /// Magnitude of the force asked for.
        force: f64,
        /// Largest force friction holds, the area integral of the shear limit.
        limit: f64,
    },
    /// The load has components along both axes, which the scalar tangential model cannot carry.
    #[error(
        "the tangential load [{x:e}, {y:e}] is along neither axis; the scalar model needs one of them to be zero"
    )]
    ObliqueLoad {
        /// Component along x.
        x: f64,
        /// Component along y.
        y: f64,
    },
    /// A load that the model of a history does not have.
    #[error("a {quantity} of {value:e} is not part of the model of this history: {remedy}")]
    NotModelled {
        /// The load, in words.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// The options that bring it in, or that none does, in words.
        remedy: &'static str,
    },
    /// A solution or a saved history belongs to bodies of other materials.
    #[error("{quantity} belongs to bodies of other materials")]
    MaterialMismatch {
        /// The solution, or what was saved, in words.
        quantity: &'static str,
    },
    /// The approach is not below the mean gap of a periodic contact: the surfaces then touch everywhere, and the pressure
    /// is not determined.
    #[error(
        "an approach of {approach:e} is not below the mean gap {mean_gap:e} of a periodic contact, which it would close everywhere under any pressure"
    )]
    ApproachBeyondMeanGap {
        /// The approach asked for.
        approach: f64,
        /// Mean of the initial gap.
        mean_gap: f64,
    },
    /// An explicit matrix of this size is refused.
    #[error("an explicit matrix of {cells} cells is larger than the limit of {limit} cells")]
    TooManyCells {
        /// Cells asked for.
        cells: usize,
        /// Cells allowed.
        limit: usize,
    },
    /// A matrix is not symmetric positive definite.
    #[error("the matrix is not symmetric positive definite (row {row})")]
    NotPositiveDefinite {
        /// The first row where that shows.
        row: usize,
    },
    /// The points known do not determine what is asked of them.
    #[error("{quantity} has {unknowns} unknowns, which {known} known points do not determine")]
    Undetermined {
        /// What is sought, in words.
        quantity: &'static str,
        /// Numbers sought.
        unknowns: usize,
        /// Points given.
        known: usize,
    },
    /// A polynomial of this degree is refused.
    #[error("a polynomial of degree {degree} exceeds the limit of {limit}")]
    Degree {
        /// Degree asked for.
        degree: usize,
        /// Degree allowed.
        limit: usize,
    },
    /// A range of rows or columns is empty or leaves the grid.
    #[error(
        "the {quantity} {start}..{end} are an empty range, or reach beyond the {count} of the grid"
    )]
    Range {
        /// Rows or columns.
        quantity: &'static str,
        /// First of the range.
        start: usize,
        /// First after the range.
        end: usize,
        /// Number in the grid.
        count: usize,
    },
    /// A grid reaches beyond the samples it is to be filled from.
    #[error("the grid reaches {reach:e} from the middle along {axis}, the samples only {limit:e}")]
    BeyondSamples {
        /// The axis, x or y.
        axis: &'static str,
        /// Distance of the outermost centres from the middle.
        reach: f64,
        /// Distance of the edge of the samples' grid from the middle.
        limit: f64,
    },
    /// A Hurst exponent outside `[0, 1]` belongs to no rough surface.
    #[error("the Hurst exponent must lie in [0, 1], got {0}")]
    Hurst(f64),
    /// A quantity is less than its least value.
    #[error("{quantity} must be at least {least_is}, {least:e}, got {value:e}")]
    Below {
        /// The quantity, in words.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// What the least value is, in words.
        least_is: &'static str,
        /// The least value.
        least: f64,
    },
    /// No wave that is periodic on the surface has a length within the band asked for.
    #[error("no wave of the surface is between {longest:e} and {shortest:e} long")]
    EmptyBand {
        /// Longest wavelength asked for.
        longest: f64,
        /// Shortest wavelength asked for.
        shortest: f64,
    },
    /// No phases were found that give the heights the skewness and kurtosis asked for.
    #[error(
        "no surface of this spectrum was found with a skewness of {skewness} and a kurtosis of {kurtosis}; the search ended at {} and {}",
        .reached[0], .reached[1]
    )]
    HeightsNotReached {
        /// Skewness asked for.
        skewness: f64,
        /// Kurtosis asked for.
        kurtosis: f64,
        /// Skewness and kurtosis where the search ended.
        reached: [f64; 2],
    },
    /// The operating system refused to read or write a file.
    #[error("{path}: {problem}")]
    File {
        /// The file.
        path: String,
        /// What the operating system said.
        problem: String,
    },
    /// A file breaks the rules of its format, or uses a part of it that is not supported.
    #[error("{format}, {place}: {problem}")]
    Format {
        /// The format, by its usual abbreviation.
        format: &'static str,
        /// Where the rule is broken.
        place: Place,
        /// The rule, or the part, with what was found.
        problem: String,
    },
    /// A number of steps per cycle of which none would end at the turning points.
    #[error("the steps per cycle must be a positive multiple of 4, got {0}")]
    StepsPerCycle(usize),
    /// A path of no steps.
    #[error("the load path has no steps")]
    EmptyPath,
    /// A cycle holds the steps of its history up to one already, and this one is not after it.
    #[error(
        "step {step} of the history is not after step {last}, the last the cycle has seen: it takes each once"
    )]
    StepNotNew {
        /// The number of the step, from 1; zero for none.
        step: u64,
        /// The number of the last step the cycle holds or begins after.
        last: u64,
    },
    /// The iteration ended before the tolerance was reached. After `solve_into` or `solve_observed` the solution holds
    /// the last feasible iterate; a [`History`](crate::History) is as it was before the step.
    #[error("not converged: {0}")]
    NotConverged(Box<Report>),
}

/// A place in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// Bytes from the beginning of the file.
    Byte(u64),
    /// A line of text; the first is line 1.
    Line(usize),
    /// A named part: a file within an archive, an element of a header, a field.
    Entry(String),
}

impl fmt::Display for Place {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Byte(byte) => write!(formatter, "at byte {byte}"),
            Self::Line(line) => write!(formatter, "on line {line}"),
            Self::Entry(name) => write!(formatter, "in {name}"),
        }
    }
}
