//! The error type: every way a call can be refused or fail, with the offending number.

mod check;
mod messages;
mod place;
mod ranks;
mod result;

pub(crate) use check::{
    SLIDE, all_finite, all_non_negative, at_least, finite, has_squares, length, memory,
    non_negative, not_converged, of_rolling, poisson_ratio, positive, samples_obey,
};
pub use {place::Place, ranks::RankFailure, result::Result};

use crate::report::Report;

/// The reason a call failed: one variant per violated rule, with the offending number.
///
/// `Debug` writes the same sentence as `Display`: it is what a program prints whose `main` returns the error.
/// Arguments are checked before any work, and a failed call leaves the caller's state unchanged. The exception is
/// [`Error::NotConverged`]: `solve_into` and `solve_observed` then leave the last feasible iterate in the solution.
#[derive(Clone, PartialEq, thiserror::Error)]
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
    /// Memory for a quantity cannot be allocated; [nothing has changed](crate::guide::embedding#when-memory-runs-out).
    #[error("cannot allocate {} for {quantity}", messages::size(*bytes))]
    Memory {
        /// The quantity that needs the memory, in words.
        quantity: &'static str,
        /// Bytes needed.
        bytes: u128,
    },
    /// A quantity that must be positive and finite is not.
    #[error("{quantity} must be positive and finite, got {value:?}")]
    NotPositive {
        /// The quantity, in words.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A quantity that must be zero or positive, and finite, is not.
    #[error("{quantity} must be non-negative and finite, got {value:?}")]
    NegativeOrNotFinite {
        /// The quantity, in words.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A quantity that must be finite is not.
    #[error("{quantity} must be finite, got {value:?}")]
    NotFinite {
        /// The quantity, in words.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A number is so small or so large that squares of it leave the range of numbers, and no error could be certified.
    #[error(
        "{quantity} is {value:e}, and must lie between {least:e} and {most:e}, where its squares are numbers: {remedy}"
    )]
    ExtremeNumber {
        /// The quantity, in words.
        quantity: &'static str,
        /// The value found.
        value: f64,
        /// The least value allowed.
        least: f64,
        /// The largest value allowed.
        most: f64,
        /// The remedy, in words.
        remedy: &'static str,
    },
    /// A sample of a field violates a rule for that field.
    #[error("{quantity} at index {index} is {value:?}: {rule}")]
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
    /// Poisson's ratio lies outside `(-1, 1/2]`, the range in which an isotropic body is stable.
    #[error("Poisson's ratio must lie in (-1, 0.5], got {0:?}")]
    PoissonRatio(f64),
    /// Both bodies are rigid. Neither deforms, so there is nothing to solve.
    #[error("both bodies are rigid")]
    BothRigid,
    /// More layers than a coated body may have.
    #[error("a body of {found} layers exceeds the limit of {limit}")]
    TooManyLayers {
        /// Layers given.
        found: usize,
        /// Layers allowed.
        limit: usize,
    },
    /// A quantity is modelled for homogeneous bodies only, and not for these coated bodies or this
    /// [`Kernel`](crate::Kernel).
    #[error("{quantity} is not modelled for {bodies}: {remedy}")]
    UnsupportedForCoatings {
        /// The requested quantity, in words.
        quantity: &'static str,
        /// The bodies for which it is not modelled, in words.
        bodies: &'static str,
        /// What to do instead.
        remedy: &'static str,
    },
    /// A pair that stands for a [`Kernel`](crate::Kernel) was given without the kernel, or its table lacks a coefficient, or its
    /// operators a direction.
    #[error("the kernel is missing: {0}")]
    IncompleteKernel(&'static str),
    /// The least eigenvalue of the compliance of coated bodies, or of a [`Kernel`](crate::Kernel), is not positive on this
    /// grid: nothing could be certified. The page of [`kernel`](crate::kernel#certificate) tells which bounds are tried.
    #[error(
        "the least eigenvalue of the compliance, {eigenvalue:?}, is not positive on cells of sides {sides:?}: take a grid of fewer thicknesses of the layers, or one that repeats, or a kernel that stores energy"
    )]
    NotDefinite {
        /// The least eigenvalue (a length over a pressure).
        eigenvalue: f64,
        /// Sides of a cell (lengths).
        sides: [f64; 2],
    },
    /// A [datum](crate::Boundary::PeriodicAlongY) that makes the compliance indefinite. A prescribed approach, a prescribed
    /// shift or a spring then has no unique solution.
    #[error(
        "the datum {datum:e} makes the compliance of the grid indefinite, so that a prescribed approach, shift or spring has no unique solution: prescribe the force, or take a datum beyond {least:e}"
    )]
    DatumTooNear {
        /// Distance of the datum (a length).
        datum: f64,
        /// Distance beyond which the compliance is definite (a length).
        least: f64,
    },
    /// Stress or displacement of a body that is rigid: nothing determines them.
    #[error("{0} is rigid: nothing determines its stress")]
    RigidBody(&'static str),
    /// A sum over images that does not converge.
    #[error("{0} does not converge on a grid that repeats along both axes")]
    DivergentPeriodicSum(&'static str),
    /// The materials couple pressure and traction, and what was asked for does not model how shear changes the pressure.
    #[error(
        "the pair couples pressure and traction (Dundurs beta = {beta:?}): a coupled problem or a history finds both together; elsewhere choose one-way or neglected coupling, and its error"
    )]
    CoupledMaterials {
        /// Dundurs' second parameter of the pair; of coated bodies the like of it for the waves that couple most.
        beta: f64,
    },
    /// Cells so much longer than wide that the least eigenvalue of the compliance is round-off: no error is certified.
    #[error(
        "cells of sides {sides:?} are too long: double precision does not resolve the compliance of their short waves"
    )]
    CellsTooLong {
        /// Sides of a cell (lengths).
        sides: [f64; 2],
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
        /// Cells along x and y of the expected grid.
        expected_cells: [usize; 2],
        /// Cell sides of the expected grid (lengths).
        expected_sides: [f64; 2],
        /// Cells along x and y of the field.
        found_cells: [usize; 2],
        /// Cell sides of the field (lengths).
        found_sides: [f64; 2],
    },
    /// A solution belongs to bodies with a different boundary.
    #[error("{quantity} belongs to bodies with a different boundary")]
    BoundaryMismatch {
        /// The solution, in words.
        quantity: &'static str,
    },
    /// A solution belongs to bodies whose cells have values of another meaning.
    #[error("{quantity} belongs to bodies with another CellValue")]
    CellValueMismatch {
        /// The solution, in words.
        quantity: &'static str,
    },
    /// The tolerance lies outside `(0, 1)`, where it is meaningless.
    #[error("the tolerance must lie strictly between 0 and 1, got {0:?}")]
    Tolerance(f64),
    /// The iteration limit is zero.
    #[error("the iteration limit must be at least 1")]
    IterationLimit,
    /// A normal problem that is to hold its pressure: it has none yet.
    #[error("a normal problem has no pressure to hold: give it a force or an approach")]
    NoPressureToHold,
    /// The method is not defined for the problem.
    #[error("the method {method} does not solve problems with {quantity}: use ActiveSet")]
    Method {
        /// The method asked for.
        method: &'static str,
        /// What it does not solve, in words.
        quantity: &'static str,
    },
    /// No finite value lies between the bounds of an entry.
    #[error("the bounds [{lower:?}, {upper:?}] of entry {index} contain no finite value")]
    Bounds {
        /// The entry.
        index: usize,
        /// Its lower bound.
        lower: f64,
        /// Its upper bound.
        upper: f64,
    },
    /// No point within the bounds has the prescribed total.
    #[error(
        "the total {total:?} is outside the range [{lower:?}, {upper:?}] allowed by the bounds"
    )]
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
    /// The bodies do not touch: there is no contact to load tangentially.
    #[error(
        "the contact is empty, no cell carries pressure: press the bodies first, by a force or an approach beyond the least gap"
    )]
    EmptyContact,
    /// The tangential force exceeds what friction can carry: no equilibrium exists.
    #[error("{}", messages::beyond_capacity(*force, *limit, remedy))]
    BeyondFrictionCapacity {
        /// Magnitude of the force requested.
        force: f64,
        /// Largest force that friction can carry, the area integral of the shear limit.
        limit: f64,
        /// The loads that are possible instead, in words.
        remedy: &'static str,
    },
    /// The moment about the normal is not between the moments that large spins of both signs cause, next to the prescribed
    /// creepages and forces.
    #[error(
        "a moment of {moment:?} is not less than the friction limit {limit:?} next to the prescribed creepages and forces: give a moment between {:?} and {:?}, or prescribe the spin", .range[0], .range[1]
    )]
    BeyondFrictionMoment {
        /// The moment requested, positive in the direction of the limit.
        moment: f64,
        /// The moment of a contact that slides as a whole, in the same direction.
        limit: f64,
        /// The least and the greatest moment of a contact that slides as a whole.
        range: [f64; 2],
    },
    /// The normal force exceeds what the hardness lets the cells carry.
    #[error("{}", messages::beyond_hardness(*force, *capacity))]
    BeyondHardness {
        /// Normal force requested.
        force: f64,
        /// Largest force that the cells carry, the integral of the hardness.
        capacity: f64,
    },
    /// A quantity that only elastic contacts have was asked of one in which cells are at their hardness.
    #[error(
        "{quantity} is that of an elastic contact, and {cells} cells of this one are at their hardness"
    )]
    Yielded {
        /// The quantity, in words.
        quantity: &'static str,
        /// Cells at their hardness.
        cells: usize,
    },
    /// The load has components along both axes, which the scalar tangential model does not allow.
    #[error(
        "the tangential load [{x:?}, {y:?}] has two components; the scalar model requires one of them to be zero"
    )]
    ObliqueLoad {
        /// Component along x.
        x: f64,
        /// Component along y.
        y: f64,
    },
    /// A model does not include this load, or this property of an operator.
    #[error("{model} does not include {quantity}, got {value:?}: {remedy}")]
    UnsupportedByModel {
        /// The model, in words.
        model: &'static str,
        /// The load or the property, in words.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// The options that add it to the model, or that there is no such option, in words.
        remedy: &'static str,
    },
    /// A solution or a saved history belongs to bodies of different materials.
    #[error("{quantity} belongs to bodies of different materials")]
    MaterialMismatch {
        /// The solution or the saved quantity, in words.
        quantity: &'static str,
    },
    /// The approach is not below the mean gap of a periodic contact: all touches, and the pressure is undetermined.
    #[error("{}", messages::beyond_mean_gap(*approach, *mean_gap))]
    ApproachBeyondMeanGap {
        /// The approach requested.
        approach: f64,
        /// Mean of the initial gap.
        mean_gap: f64,
    },
    /// An explicit matrix of this size exceeds the limit.
    #[error("an explicit matrix of {cells} cells exceeds the limit of {limit} cells")]
    TooManyCells {
        /// Cells requested.
        cells: usize,
        /// Cells allowed.
        limit: usize,
    },
    /// A matrix is not symmetric positive definite.
    #[error("the matrix is not symmetric positive definite (row {row})")]
    NotPositiveDefinite {
        /// The first row that shows it.
        row: usize,
    },
    /// The known points do not determine the unknowns.
    #[error("{quantity} has {unknowns} unknowns, which {known} known points do not determine")]
    Undetermined {
        /// The unknown quantity, in words.
        quantity: &'static str,
        /// Number of unknowns.
        unknowns: usize,
        /// Number of known points.
        known: usize,
    },
    /// The degree of a polynomial exceeds the limit.
    #[error("a polynomial of degree {degree} exceeds the limit of {limit}")]
    Degree {
        /// Degree requested.
        degree: usize,
        /// Degree allowed.
        limit: usize,
    },
    /// A range of rows or columns is empty or extends beyond the grid.
    #[error(
        "the range {start}..{end} of {quantity} is empty or extends beyond the {count} of the grid"
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
    /// A grid extends beyond the samples it is to be filled from.
    #[error(
        "the grid extends to {reach:?} from the centre along {axis}, the samples only to {limit:?}"
    )]
    BeyondSamples {
        /// The axis, x or y.
        axis: &'static str,
        /// Distance of the outermost cell centres from the middle.
        reach: f64,
        /// Distance of the edge of the samples' grid from the middle.
        limit: f64,
    },
    /// The Hurst exponent lies outside `[0, 1]`.
    #[error("the Hurst exponent must lie in [0, 1], got {0:?}")]
    Hurst(f64),
    /// A quantity is below its lower limit.
    #[error("{quantity} must be at least {least:?} ({least_is}), got {value:?}")]
    BelowMinimum {
        /// The quantity, in words.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// The meaning of the lower limit, in words.
        least_is: &'static str,
        /// The lower limit.
        least: f64,
    },
    /// The grid ends too near the contact for a rolled step.
    #[error(
        "the grid is too small in the rolling direction: a step needs {needed} cells {side} the contact, the grid has {found}; add at least {} cells there",
        needed.saturating_sub(*found)
    )]
    GridTooShort {
        /// The side of the contact: "ahead of" or "behind".
        side: &'static str,
        /// Cells that a step needs there.
        needed: usize,
        /// Cells that the grid has there.
        found: usize,
    },
    /// No wave that is periodic on the surface has a wavelength within the requested band.
    #[error("the surface has no wave with a wavelength between {shortest:?} and {longest:?}")]
    NoWaveInBand {
        /// Longest wavelength requested.
        longest: f64,
        /// Shortest wavelength requested.
        shortest: f64,
    },
    /// No phases were found that give the heights the requested skewness and kurtosis.
    #[error("{}", messages::heights_not_reached(*skewness, *kurtosis, *reached))]
    HeightMomentsNotReached {
        /// Skewness requested.
        skewness: f64,
        /// Kurtosis requested.
        kurtosis: f64,
        /// Skewness and kurtosis at which the search ended.
        reached: [f64; 2],
    },
    /// The operating system could not read or write a file.
    #[error("{path}: {problem}")]
    File {
        /// The file.
        path: String,
        /// The message of the operating system.
        problem: String,
        /// Its number of the error, if it has one.
        code: Option<i32>,
    },
    /// A file violates the rules of its format, or uses an unsupported part of it.
    #[error("{}{format}, {place}: {problem}", messages::prefix(.file.as_deref()))]
    Format {
        /// The file, if it was read from one.
        file: Option<String>,
        /// The format, by its usual abbreviation.
        format: &'static str,
        /// Where the file violates the rule.
        place: Place,
        /// The rule or the unsupported part, with what was found.
        problem: String,
    },
    /// The number of steps per cycle is not a positive multiple of 4, so no step would end at a turning point.
    #[error("the steps per cycle must be a positive multiple of 4, got {0}")]
    StepsPerCycle(usize),
    /// A load path has no steps.
    #[error("the load path has no steps")]
    EmptyPath,
    /// A cycle already holds the steps of its history up to some step, and this step does not come after it.
    #[error(
        "step {step} of the history does not come after step {last}, the last step of the cycle: each step is counted once"
    )]
    StepAlreadyCounted {
        /// The number of the step, counted from 1; zero before the first step.
        step: u64,
        /// The number of the last step that the cycle holds or begins after.
        last: u64,
    },
    /// A cycle that does not close was to stand for those that follow.
    #[error("{}", messages::not_closed(*residual, *limit))]
    CycleNotClosed {
        /// [`Cycle::cyclic_residual`](crate::history::Cycle::cyclic_residual).
        residual: f64,
        /// The largest one allowed.
        limit: f64,
    },
    /// A load was cut into the shortest steps allowed, and the error of one is still beyond its tolerance.
    #[error(
        "a step of {part:?} of the load still has an error of {error:?}, more than its share of {tolerance:?}: raise the tolerance, or tighten that of the history"
    )]
    StepTooLong {
        /// Length of the step, as a part of the load.
        part: f64,
        /// [`StepErrorEstimate::traction`](crate::history::StepErrorEstimate::traction) of the step.
        error: f64,
        /// The tolerance of the whole load.
        tolerance: f64,
    },
    /// Ranks that solve together cannot go on together.
    #[error("{0}")]
    Ranks(RankFailure),
    /// The iteration ended before it reached the tolerance. After `solve_into` or `solve_observed` the solution holds
    /// the last feasible iterate; a [`History`](crate::History) remains as it was before the step.
    #[error("not converged: {0}")]
    NotConverged(Box<Report>),
}
