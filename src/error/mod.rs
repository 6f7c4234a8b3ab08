//! Error type: the reasons why a call can fail, with the offending numbers.

mod check;
mod kind;
mod messages;
mod place;
mod ranks;
mod result;
mod system;
#[cfg(test)]
pub(crate) mod tests;

pub(crate) use check::{
    ROLL, ROLL_UNDER_CAP, SLIDE, SLIDE_UNDER_CAP, all_finite, all_non_negative, at_least,
    check_converged, check_solved, finite, has_squares, length, memory, non_negative,
    not_converged, poisson_ratio, positive, samples_obey, with_remedy,
};
pub(crate) use messages::counted;
pub use {kind::ErrorKind, place::Place, ranks::RankFailure, result::Result, system::SystemError};

use crate::report::Report;

/// Reason why a call failed. Each variant belongs to one violated rule and contains the offending number.
///
/// `Debug` writes the name of the variant and the sentence of `Display`, because a program whose `main` returns the
/// error prints it with `Debug`. [`kind`](Self::kind) groups the variants by how a program can respond to them. Arguments are
/// checked before any work, and a failed call leaves the state of the caller unchanged. [`Error::NotConverged`] is the exception:
/// `solve_into` and `solve_observed` then leave the last feasible iterate in the solution.
///
/// A match requires a wildcard arm, because minor releases may add variants. Variants of the kinds
/// [`Argument`](ErrorKind::Argument) and [`Memory`](ErrorKind::Memory) have fixed fields, so that a program can construct them
/// for its own checks. Minor releases may add fields to the variants of other kinds, and a pattern for their fields ends with
/// `..`.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The grid has no cell along an axis.
    #[error("the grid must have at least one cell along each axis, got {nx} x {ny} cells")]
    GridSize {
        /// Number of cells along x.
        nx: usize,
        /// Number of cells along y.
        ny: usize,
    },
    /// Memory for a quantity cannot be allocated. [The state is unchanged](crate::guide::memory_and_errors#when-memory-runs-out).
    #[error("cannot allocate {} for {quantity}", messages::size(*bytes))]
    Memory {
        /// The quantity that requires the memory, in words.
        quantity: &'static str,
        /// Required number of bytes.
        bytes: u128,
    },
    /// A quantity that must be positive and finite is not positive or not finite.
    #[error("{quantity} must be positive and finite, got {value:?}")]
    NotPositive {
        /// The quantity, in words.
        quantity: &'static str,
        /// The given value.
        value: f64,
    },
    /// A quantity that must be zero or positive, and finite, is negative or not finite.
    #[error("{quantity} must be non-negative and finite, got {value:?}")]
    NegativeOrNotFinite {
        /// The quantity, in words.
        quantity: &'static str,
        /// The given value.
        value: f64,
    },
    /// A quantity that must be finite is not finite.
    #[error("{quantity} must be finite, got {value:?}")]
    NotFinite {
        /// The quantity, in words.
        quantity: &'static str,
        /// The given value.
        value: f64,
    },
    /// The squares of a number overflow or underflow, so that no error could be certified.
    #[error(
        "{quantity} must lie between {least:e} and {most:e} so that its squares do not overflow or underflow, got {value:e}: {remedy}"
    )]
    ExtremeNumber {
        /// The quantity, in words.
        quantity: &'static str,
        /// The actual value.
        value: f64,
        /// The smallest permitted value.
        least: f64,
        /// The largest permitted value.
        most: f64,
        /// The remedy, in words.
        remedy: &'static str,
    },
    /// A sample of a field violates a rule for that field.
    #[error("{quantity} at index {index} is {value:?}, but {rule}")]
    Sample {
        /// The field, in words.
        quantity: &'static str,
        /// Index into the row-major samples.
        index: usize,
        /// The value at this index.
        value: f64,
        /// The rule, in words.
        rule: &'static str,
    },
    /// Poisson's ratio lies outside `(-1, 1/2]`, the range in which an isotropic body is stable.
    #[error("Poisson's ratio must lie in (-1, 0.5], got {0:?}")]
    PoissonRatio(f64),
    /// Both bodies are rigid. Neither body deforms, so there is nothing to solve.
    #[error("both bodies are rigid: give at least one body a finite Young's modulus")]
    BothRigid,
    /// A coated body has more layers than the limit.
    #[error("a coated body must have at most {limit} layers, got {found}: combine thin layers")]
    TooManyLayers {
        /// Number of given layers.
        found: usize,
        /// Largest number of layers.
        limit: usize,
    },
    /// A quantity is available for homogeneous bodies only, and not for these coated bodies or this
    /// [`Kernel`](crate::Kernel).
    #[error("{quantity} is not available for {bodies}: {remedy}")]
    #[non_exhaustive]
    UnsupportedForCoatings {
        /// The requested quantity, in words.
        quantity: &'static str,
        /// The bodies for which the quantity is not available, in words.
        bodies: &'static str,
        /// The remedy, in words.
        remedy: &'static str,
    },
    /// A [`Kernel`](crate::Kernel) is incomplete: its table lacks a coefficient, its operators lack a direction, or the pair that
    /// represents the kernel was given without it.
    #[error("the kernel is missing or incomplete: {0}")]
    IncompleteKernel(&'static str),
    /// The smallest eigenvalue of the compliance of coated bodies, or of a [`Kernel`](crate::Kernel), is not positive on this
    /// grid. No error could be certified. The documentation of [`kernel`](crate::kernel#certificate) lists the available bounds.
    #[error(
        "the smallest eigenvalue of the compliance must be positive, got {eigenvalue:?} on cells of sides {sides:?}: use a grid that is smaller relative to the layer thickness, a periodic grid, or a kernel of positive energy"
    )]
    NotDefinite {
        /// The smallest eigenvalue (a length over a pressure).
        eigenvalue: f64,
        /// Sides of a cell (lengths).
        sides: [f64; 2],
    },
    /// The [datum](crate::Boundary::PeriodicAlongY) makes the compliance indefinite. A prescribed approach, a
    /// prescribed shift or a spring then has no unique solution.
    #[error(
        "the datum distance {datum:?} makes the compliance indefinite, so that a prescribed approach, shift or spring has no unique solution: prescribe the force, or use a distance above {least:?}"
    )]
    DatumTooNear {
        /// Distance of the datum (a length).
        datum: f64,
        /// Distance beyond which the compliance is definite (a length).
        least: f64,
    },
    /// The stress or displacement of a rigid body was requested, but it is undetermined.
    #[error(
        "{0} is rigid, so its stress is undetermined: request the stress of an elastic body or layer"
    )]
    RigidBody(&'static str),
    /// A sum over images does not converge.
    #[error(
        "{0} does not converge on a grid that is periodic along both axes: compute the stress on planes instead"
    )]
    DivergentPeriodicSum(&'static str),
    /// The materials couple pressure and traction, and the requested model neglects the effect of shear on the
    /// pressure.
    #[error(
        "the materials couple pressure and traction (Dundurs' beta = {beta:?}), which this model neglects: use a coupled problem or a history with full coupling, or accept the error of one-way or neglected coupling"
    )]
    #[non_exhaustive]
    CoupledMaterials {
        /// Dundurs' second parameter of the pair. For coated bodies it is the equivalent parameter for the waves with the
        /// strongest coupling.
        beta: f64,
    },
    /// The cells are so elongated that round-off dominates the smallest eigenvalue of the compliance. No error could be
    /// certified.
    #[error(
        "cells of sides {sides:?} are too elongated for double precision to resolve the compliance of short waves: use cells of a smaller aspect ratio"
    )]
    CellsTooLong {
        /// Sides of a cell (lengths).
        sides: [f64; 2],
    },
    /// A slice, field or list has the wrong number of entries.
    #[error("{quantity} has {}, expected {expected}", counted(*found, "entry"))]
    Length {
        /// The slice or list, in words.
        quantity: &'static str,
        /// Expected number of entries.
        expected: usize,
        /// Actual number of entries.
        found: usize,
    },
    /// Two fields or bodies have different grids.
    #[error(
        "{quantity} is on a grid of {found_cells:?} cells of sides {found_sides:?}, expected {expected_cells:?} cells of sides {expected_sides:?}"
    )]
    GridMismatch {
        /// The field, in words.
        quantity: &'static str,
        /// Numbers of cells along x and y of the expected grid.
        expected_cells: [usize; 2],
        /// Cell sides of the expected grid (lengths).
        expected_sides: [f64; 2],
        /// Numbers of cells along x and y of the field.
        found_cells: [usize; 2],
        /// Cell sides of the field (lengths).
        found_sides: [f64; 2],
    },
    /// A solution belongs to bodies with a different boundary.
    #[error(
        "{quantity} belongs to bodies with a different boundary: use the bodies for which it was computed"
    )]
    BoundaryMismatch {
        /// The solution, in words.
        quantity: &'static str,
    },
    /// A solution belongs to bodies with a different interpretation of cell values.
    #[error(
        "{quantity} belongs to bodies with a different interpretation of cell values: use the bodies for which it was computed"
    )]
    CellValueMismatch {
        /// The solution, in words.
        quantity: &'static str,
    },
    /// The tolerance lies outside the open interval `(0, 1)`.
    #[error("the tolerance must lie strictly between 0 and 1, got {0:?}")]
    Tolerance(f64),
    /// The iteration limit is zero.
    #[error("the iteration limit must be at least 1, got 0")]
    IterationLimit,
    /// The load control holds the pressure, but a normal problem has no earlier pressure. Only a step of a history can hold one.
    #[error(
        "a normal contact has no earlier pressure to hold, only a history has one: prescribe a normal force or an approach"
    )]
    NoPressureToHold,
    /// The method does not support the problem.
    #[error("the {method} method does not support {quantity}: use the active-set method")]
    #[non_exhaustive]
    Method {
        /// The requested method.
        method: &'static str,
        /// The unsupported property of the problem, in words.
        quantity: &'static str,
    },
    /// The bounds of an entry contain no finite value.
    #[error(
        "the bounds [{lower:?}, {upper:?}] of entry {index} contain no finite value: give a lower bound that does not exceed the upper bound"
    )]
    Bounds {
        /// Index of the entry.
        index: usize,
        /// Lower bound of the entry.
        lower: f64,
        /// Upper bound of the entry.
        upper: f64,
    },
    /// No point within the bounds has the prescribed total.
    #[error(
        "the total {total:?} is outside the range [{lower:?}, {upper:?}] allowed by the bounds: prescribe a total in this range, or widen the bounds"
    )]
    #[non_exhaustive]
    Total {
        /// The prescribed total.
        total: f64,
        /// The smallest total within the bounds.
        lower: f64,
        /// The largest total within the bounds.
        upper: f64,
    },
    /// A direction occurs twice among the directions of an operator.
    #[error("an operator has the same direction twice: give each of its directions once")]
    RepeatedDirection,
    /// The bodies do not touch, so there is no contact to load tangentially.
    #[error(
        "the contact is empty because no cell carries pressure: first prescribe a positive normal force, or an approach above the smallest gap"
    )]
    EmptyContact,
    /// The tangential force exceeds the force that friction can carry, so that no equilibrium exists.
    #[error("{}", messages::beyond_capacity(*force, *limit, remedy))]
    #[non_exhaustive]
    BeyondFrictionCapacity {
        /// Magnitude of the requested force.
        force: f64,
        /// Largest force that friction can carry, the area integral of the friction limit.
        limit: f64,
        /// The loads that are possible instead, in words.
        remedy: &'static str,
    },
    /// The moment about the normal does not lie between the moments for large spins of both signs. These moments depend on the
    /// prescribed creepages and forces.
    #[error(
        "the moment {moment:?} reaches or exceeds the friction limit {limit:?} for the prescribed creepages and forces: prescribe a moment between {:?} and {:?}, or the spin", .range[0], .range[1]
    )]
    #[non_exhaustive]
    BeyondFrictionMoment {
        /// The requested moment.
        moment: f64,
        /// The end of the range that the moment reaches or exceeds: the largest moment, or the smallest moment if the requested
        /// moment is at or below it.
        limit: f64,
        /// The smallest and the largest moment of full sliding.
        range: [f64; 2],
    },
    /// The normal force exceeds the largest force that the cells can carry at their hardness.
    #[error("{}", messages::beyond_hardness(*force, *capacity))]
    #[non_exhaustive]
    BeyondHardness {
        /// Requested normal force.
        force: f64,
        /// Largest force that the cells can carry, the integral of the hardness.
        capacity: f64,
    },
    /// A quantity for elastic contacts was requested for a contact with cells at their hardness.
    #[error(
        "{quantity} requires an elastic contact, but {} reached the hardness: lower the load, or raise the hardness", counted(*cells, "cell")
    )]
    #[non_exhaustive]
    Yielded {
        /// The quantity, in words.
        quantity: &'static str,
        /// Number of cells at their hardness.
        cells: usize,
    },
    /// The load has components along both axes, which the scalar tangential model does not allow.
    #[error(
        "the tangential load [{x:?}, {y:?}] has two components, but the scalar model requires one of them to be zero: use the vector model"
    )]
    #[non_exhaustive]
    ObliqueLoad {
        /// Component along x.
        x: f64,
        /// Component along y.
        y: f64,
    },
    /// A model does not include this load, or this property of an operator.
    #[error("{model} does not support {quantity}{}: {remedy}", messages::given(*value))]
    #[non_exhaustive]
    UnsupportedByModel {
        /// The model, in words.
        model: &'static str,
        /// The load or property, in words.
        quantity: &'static str,
        /// The value of the load or property. If it has no value, a related number that `quantity` names, or zero.
        value: f64,
        /// The options that add the load or property to the model, in words, or a statement that there is no such
        /// option.
        remedy: &'static str,
    },
    /// A solution or a saved history belongs to bodies of different materials.
    #[error(
        "{quantity} belongs to bodies of other materials: use the bodies for which it was computed"
    )]
    MaterialMismatch {
        /// The solution or the saved quantity, in words.
        quantity: &'static str,
    },
    /// The approach is not below the mean gap of a periodic contact. All cells are then in contact, and the pressure is
    /// undetermined.
    #[error("{}", messages::beyond_mean_gap(*approach, *mean_gap))]
    #[non_exhaustive]
    ApproachBeyondMeanGap {
        /// The requested approach.
        approach: f64,
        /// The mean of the initial gap.
        mean_gap: f64,
    },
    /// An explicit matrix of this size exceeds the limit.
    #[error(
        "an explicit matrix of {cells} cells exceeds the limit of {limit} cells: use a smaller grid"
    )]
    TooManyCells {
        /// Requested number of cells.
        cells: usize,
        /// Largest number of cells.
        limit: usize,
    },
    /// A matrix is not symmetric positive definite.
    #[error(
        "the matrix must be symmetric positive definite, but its factorisation fails at row {row}: check its symmetry and its sign in this row"
    )]
    NotPositiveDefinite {
        /// The first row at which the factorisation fails.
        row: usize,
    },
    /// The known points do not determine an unknown quantity.
    #[error("{}", messages::undetermined(quantity, *unknowns, *known))]
    Undetermined {
        /// The unknown quantity, in words.
        quantity: &'static str,
        /// Number of unknowns.
        unknowns: usize,
        /// Number of known points.
        known: usize,
    },
    /// The degree of a polynomial exceeds the limit.
    #[error("the degree of the polynomial must be at most {limit}, got {degree}")]
    Degree {
        /// Requested degree.
        degree: usize,
        /// Largest degree.
        limit: usize,
    },
    /// A range of rows or columns is empty, or it extends beyond the grid.
    #[error(
        "the range {start}..{end} of {quantity} is empty or extends beyond the {count} {quantity} of the grid: give a first index below the end, and an end of at most {count}"
    )]
    Range {
        /// The quantity: rows or columns.
        quantity: &'static str,
        /// First index of the range.
        start: usize,
        /// First index after the range.
        end: usize,
        /// Number of rows or columns in the grid.
        count: usize,
    },
    /// A position lies outside the samples from which a grid or a gap is interpolated.
    #[error(
        "a position at {reach:?} along {axis} lies outside the samples, which extend to {limit:?} on both sides of their centre: use a smaller grid or region, or more samples"
    )]
    BeyondSamples {
        /// The axis, x or y.
        axis: &'static str,
        /// Coordinate of the position relative to the centre of the samples. For a grid it is the distance of the outermost cell
        /// centres from the middle.
        reach: f64,
        /// Distance of the edge of the samples from their centre.
        limit: f64,
    },
    /// The Hurst exponent lies outside `[0, 1]`.
    #[error("the Hurst exponent must lie in [0, 1], got {0:?}")]
    Hurst(f64),
    /// A quantity is below its lower limit. A check of an upper limit reports the ratio of the permitted to the actual
    /// value, whose lower limit is 1.
    #[error("{quantity} must be at least {least:?} ({least_is}), got {value:?}")]
    BelowMinimum {
        /// The quantity, in words.
        quantity: &'static str,
        /// The given value.
        value: f64,
        /// The meaning of the lower limit, in words.
        least_is: &'static str,
        /// The lower limit.
        least: f64,
    },
    /// The distance between the contact and the edge of the grid is too small for a rolling step.
    #[error(
        "a rolling step requires {} {side} the contact, but the grid has {found}: extend the grid there by at least {}",
        counted(*needed, "cell"),
        counted(needed.saturating_sub(*found), "cell")
    )]
    GridTooShort {
        /// The side of the contact: "ahead of" or "behind".
        side: &'static str,
        /// Number of cells that a step needs on this side.
        needed: usize,
        /// Number of cells that the grid has on this side.
        found: usize,
    },
    /// No wave that is periodic on the surface has a wavelength within the requested band.
    #[error(
        "no periodic wave of the surface has a wavelength between {shortest:?} and {longest:?}: widen the range of wavelengths, or use a larger grid"
    )]
    NoWaveInBand {
        /// Requested longest wavelength.
        longest: f64,
        /// Requested shortest wavelength.
        shortest: f64,
    },
    /// The search found no phases for which the heights have the requested skewness and kurtosis.
    #[error("{}", messages::heights_not_reached(*skewness, *kurtosis, *reached))]
    #[non_exhaustive]
    HeightMomentsNotReached {
        /// Requested skewness.
        skewness: f64,
        /// Requested kurtosis.
        kurtosis: f64,
        /// Skewness and kurtosis at which the search ended.
        reached: [f64; 2],
    },
    /// The operating system could not read or write a file.
    #[error("{path}: {source}")]
    #[non_exhaustive]
    File {
        /// Path of the file.
        path: String,
        /// The error of the operating system.
        source: SystemError,
    },
    /// A file violates the rules of its format, or uses an unsupported feature of the format.
    #[error("{}{format}, {place}: {problem}", messages::prefix(.file.as_deref()))]
    #[non_exhaustive]
    Format {
        /// Name of the file, or `None` if the bytes were not read from a file.
        file: Option<String>,
        /// Usual abbreviation of the format.
        format: &'static str,
        /// Position of the violation in the file.
        place: Place,
        /// The violated rule or the unsupported feature, with the actual value.
        problem: String,
    },
    /// The number of steps per cycle is not a positive multiple of 4. No step would end at a turning point.
    #[error("the number of steps per cycle must be a positive multiple of 4, got {0}")]
    StepsPerCycle(usize),
    /// A load path or a cycle has no steps.
    #[error("the load path or cycle has no steps: at least one step is needed")]
    EmptyPath,
    /// A cycle contains the steps of its history up to the step `last`. The step `step` is not the next one, or it is a step of
    /// another history.
    #[error("{}", messages::out_of_order(*step, *last))]
    StepOutOfOrder {
        /// The number of the step, counted from 1, or zero before the first step.
        step: u64,
        /// The number of the last step that the cycle contains, or after which it begins.
        last: u64,
    },
    /// The result of the last step was requested, but no step led to the present state of the history. The history is new, or
    /// its state was set or restored.
    #[error(
        "the history has no last step, because it took no step since it was created or its state was set or restored: make a step first"
    )]
    NoLastStep,
    /// The new gap of a solver or a history is the gap under load of the last contact, which contains the displacements. A solve
    /// would press the deformed surfaces again. The gaps of earlier solutions and of closed contacts are not recognised.
    #[error(
        "the gap is the gap under load of the last solution, which contains the displacements: give the gap before loading, which is the last given gap plus the depth of wear"
    )]
    GapUnderLoad,
    /// The requested result would combine a solution with a different input. Examples are a derivative after a change of the
    /// input, and the edges of a tangential contact with the pressure of another normal contact.
    #[error("{changed} changed since the last solution, to which the {quantity} belongs: {remedy}")]
    #[non_exhaustive]
    OutdatedSolution {
        /// The requested quantity, in words.
        quantity: &'static str,
        /// The changed input, in words.
        changed: &'static str,
        /// The remedy, in words.
        remedy: &'static str,
    },
    /// The cycle does not close, so that it cannot represent the following cycles.
    #[error("{}", messages::not_closed(*residual, *limit))]
    #[non_exhaustive]
    CycleNotClosed {
        /// The value of [`Cycle::cyclic_residual`](crate::history::Cycle::cyclic_residual).
        residual: f64,
        /// The largest permitted residual.
        limit: f64,
    },
    /// A load was divided into the shortest permitted steps, and the error of a step still exceeds its tolerance.
    #[error(
        "the shortest permitted step ({part:?} of the load) has an error of {error:?}, which exceeds its share of the tolerance {tolerance:?}: raise this tolerance, or lower the tolerance of the history"
    )]
    #[non_exhaustive]
    StepTooLong {
        /// Length of the step, as a fraction of the load.
        part: f64,
        /// The value of [`StepErrorEstimate::traction`](crate::history::StepErrorEstimate::traction) for the step.
        error: f64,
        /// The tolerance of the whole load.
        tolerance: f64,
    },
    /// Ranks that solve together cannot continue.
    #[error("{0}")]
    Ranks(RankFailure),
    /// The iteration ended before it reached the tolerance. After `solve_into` or `solve_observed` the solution contains the last
    /// feasible iterate. A [`History`](crate::History) remains unchanged.
    #[error("{}", messages::not_converged(.0))]
    NotConverged(Box<Report>),
}
