//! Exceptions of the module ``stickslip.errors``: one for each variant of the error of the crate, with its numbers as
//! attributes.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::{Error, Grid, ranks::RankFailure};

use crate::digits::{as_python, in_python};
use crate::report::Report;

/// Converts an error into its exception.
pub(crate) fn raised(py: Python<'_>, error: Error) -> PyErr {
    exception(py, error, None).unwrap_or_else(|failure| failure)
}

/// Conversion of a result into a value or an exception. If the grid is given, an exception about a sample reports its row
/// and column.
pub(crate) trait OrRaise<T> {
    fn or_raise(self, py: Python<'_>) -> PyResult<T>;

    fn or_raise_on(self, py: Python<'_>, grid: Grid) -> PyResult<T>;
}

impl<T> OrRaise<T> for stickslip::Result<T> {
    fn or_raise(self, py: Python<'_>) -> PyResult<T> {
        self.map_err(|error| raised(py, error))
    }

    fn or_raise_on(self, py: Python<'_>, grid: Grid) -> PyResult<T> {
        self.map_err(|error| exception(py, error, Some(grid)).unwrap_or_else(|failure| failure))
    }
}

/// Fields that may have missing samples, for example points that were not measured.
const MEASURED: [&str; 4] = ["gap", "height", "upper surface", "lower surface"];

/// Returns the message of an error about a sample, with row, column and remedy if available. Row and column are also
/// stored among the attributes.
fn of_sample(
    error: &Error,
    grid: Option<Grid>,
    attributes: &Bound<'_, PyDict>,
) -> PyResult<String> {
    let Error::Sample {
        quantity,
        index,
        value,
        rule,
    } = error
    else {
        return Ok(error.to_string());
    };
    let value = as_python(attributes.py(), *value)?;
    let place = grid
        .filter(|grid| *index < grid.cells())
        .map(|grid| (index / grid.nx(), index % grid.nx()));
    let (row, column) = place.unzip();
    attributes.set_item("row", row)?;
    attributes.set_item("column", column)?;
    let is_missing = value == "nan" && MEASURED.contains(quantity);
    let remedy = match (is_missing, rule.contains("fill missing heights")) {
        (true, false) => " (surface.fill_missing fills missing heights)",
        (true, true) => " (surface.fill_missing)",
        (false, _) => "",
    };
    Ok(match place {
        None => format!("{quantity} at index {index} is {value}, but {rule}{remedy}"),
        Some((row, column)) => format!(
            "{quantity} at row {row}, column {column} (index {index}) is {value}, but {rule}{remedy}"
        ),
    })
}

/// Creates an exception of ``stickslip.errors`` from its name, with a message and attributes.
pub(crate) fn named(
    py: Python<'_>,
    name: &str,
    message: &str,
    attributes: &Bound<'_, PyDict>,
) -> PyResult<PyErr> {
    let class = py.import("stickslip.errors")?.getattr(name)?;
    let value = class.call1((message,))?;
    for (attribute, number) in attributes {
        value.setattr(attribute.cast_into::<pyo3::types::PyString>()?, number)?;
    }
    Ok(PyErr::from_value(value))
}

/// Converts an error into its exception and attaches the last iterate if the solve has not converged.
pub(crate) fn with_iterate<'py>(
    py: Python<'py>,
    error: Error,
    iterate: impl FnOnce() -> PyResult<Bound<'py, PyAny>>,
) -> PyErr {
    let is_iterate = matches!(error, Error::NotConverged(_));
    let exception = raised(py, error);
    if is_iterate {
        let given =
            iterate().and_then(|iterate| exception.value(py).setattr("last_iterate", iterate));
        if let Err(failure) = given {
            return failure;
        }
    }
    exception
}

/// Maps each variant with named fields to its name and its numbers.
macro_rules! numbered {
    ($error:expr, $attributes:ident, {$($name:ident { $($field:ident),+ })+}) => {
        match $error {
            $(Error::$name { $($field),+ , .. } => {
                $($attributes.set_item(stringify!($field), $field.clone())?;)+
                Some(stringify!($name))
            })+
            _ => None,
        }
    };
}

#[expect(
    clippy::too_many_lines,
    reason = "a line for each variant of the error"
)]
fn exception(py: Python<'_>, error: Error, grid: Option<Grid>) -> PyResult<PyErr> {
    let attributes = PyDict::new(py);
    let message = of_sample(&error, grid, &attributes)?;
    let name = numbered!(&error, attributes, {
        GridSize { nx, ny }
        Memory { quantity, bytes }
        NotPositive { quantity, value }
        NegativeOrNotFinite { quantity, value }
        NotFinite { quantity, value }
        ExtremeNumber { quantity, value, least, most, remedy }
        Sample { quantity, index, value, rule }
        TooManyLayers { found, limit }
        UnsupportedForCoatings { quantity, bodies, remedy }
        NotDefinite { eigenvalue, sides }
        DatumTooNear { datum, least }
        CoupledMaterials { beta }
        CellsTooLong { sides }
        Length { quantity, expected, found }
        GridMismatch { quantity, expected_cells, expected_sides, found_cells, found_sides }
        BoundaryMismatch { quantity }
        CellValueMismatch { quantity }
        Method { method, quantity }
        Bounds { index, lower, upper }
        Total { total, lower, upper }
        BeyondFrictionCapacity { force, limit, remedy }
        BeyondFrictionMoment { moment, limit, range }
        BeyondHardness { force, capacity }
        Yielded { quantity, cells }
        ObliqueLoad { x, y }
        UnsupportedByModel { model, quantity, value, remedy }
        MaterialMismatch { quantity }
        ApproachBeyondMeanGap { approach, mean_gap }
        TooManyCells { cells, limit }
        NotPositiveDefinite { row }
        Undetermined { quantity, unknowns, known }
        Degree { degree, limit }
        Range { quantity, start, end, count }
        BeyondSamples { axis, reach, limit }
        BelowMinimum { quantity, value, least_is, least }
        GridTooShort { side, needed, found }
        NoWaveInBand { longest, shortest }
        HeightMomentsNotReached { skewness, kurtosis, reached }
        StepOutOfOrder { step, last }
        OutdatedSolution { quantity, changed, remedy }
        CycleNotClosed { residual, limit }
        StepTooLong { part, error, tolerance }
    });
    let name = match (name, &error) {
        (Some(name), _) => name,
        (_, Error::PoissonRatio(value)) => one(&attributes, "PoissonRatio", "value", *value)?,
        (_, Error::Hurst(value)) => one(&attributes, "Hurst", "value", *value)?,
        (_, Error::Tolerance(value)) => one(&attributes, "Tolerance", "value", *value)?,
        (_, Error::StepsPerCycle(steps)) => one(&attributes, "StepsPerCycle", "steps", *steps)?,
        (_, Error::IncompleteKernel(part)) => one(&attributes, "IncompleteKernel", "part", *part)?,
        (_, Error::RigidBody(body)) => one(&attributes, "RigidBody", "body", *body)?,
        (_, Error::DivergentPeriodicSum(quantity)) => {
            one(&attributes, "DivergentPeriodicSum", "quantity", *quantity)?
        }
        (
            _,
            Error::Format {
                file,
                format,
                place,
                problem,
                ..
            },
        ) => {
            attributes.set_item("file", file)?;
            attributes.set_item("format", format)?;
            attributes.set_item("place", place.to_string())?;
            one(&attributes, "Format", "problem", problem)?
        }
        (_, Error::Ranks(failure)) => {
            let rank = match failure {
                RankFailure::Disconnected { rank }
                | RankFailure::Timeout { rank, .. }
                | RankFailure::CollectiveMismatch { rank }
                | RankFailure::RejectedByRank { rank } => Some(*rank),
                _ => None,
            };
            one(&attributes, "Ranks", "rank", rank)?
        }
        (_, Error::File { path, source, .. }) => {
            attributes.set_item("path", path)?;
            attributes.set_item("filename", path)?;
            attributes.set_item("strerror", source.to_string())?;
            attributes.set_item("errno", source.code())?;
            one(&attributes, "File", "problem", source.to_string())?
        }
        (_, Error::NotConverged(report)) => {
            attributes.set_item("last_iterate", py.None())?;
            one(&attributes, "NotConverged", "report", Report::of(report))?
        }
        (_, Error::BothRigid) => "BothRigid",
        (_, Error::IterationLimit) => "IterationLimit",
        (_, Error::NoPressureToHold) => "NoPressureToHold",
        (_, Error::RepeatedDirection) => "RepeatedDirection",
        (_, Error::EmptyContact) => "EmptyContact",
        (_, Error::EmptyPath) => "EmptyPath",
        (_, Error::NoLastStep) => "NoLastStep",
        (_, Error::GapUnderLoad) => "GapUnderLoad",
        // The error enum of the crate is non-exhaustive.
        _ => "StickslipError",
    };
    let message = with_remedy(&error, in_words(py, &error, message)?);
    named(py, name, &message, &attributes)
}

/// Returns the sentence of an error with its numbers in Python notation.
fn in_words(py: Python<'_>, error: &Error, sentence: String) -> PyResult<String> {
    // File names must not be read as numbers, and the message of a sample is already formatted.
    if let Error::File { .. } | Error::Format { .. } | Error::Sample { .. } = error {
        return Ok(sentence);
    }
    in_python(py, &sentence)
}

/// Returns the sentence of an error with the names of classes and arguments of the package in its remedy.
fn with_remedy(error: &Error, sentence: String) -> String {
    match error {
        Error::CoupledMaterials { .. } => sentence.replace(
            "a coupled problem or a history with full coupling, or accept the error of one-way or neglected coupling",
            "CoupledProblem or History with coupling=\"full\", or accept the error of coupling=\"one_way\" or \"neglected\"",
        ),
        Error::GridMismatch {
            expected_cells,
            expected_sides,
            found_cells,
            found_sides,
            ..
        } if found_cells == expected_cells && differ_by_unit(*found_sides, *expected_sides) => {
            format!("{sentence}: if the lengths have different units, convert the surface by surface.to_unit(...)")
        }
        // The two arguments are probably in the wrong order.
        Error::PoissonRatio(value) if value.is_finite() && value.abs() > 1.0 => {
            format!("{sentence}: the modulus precedes Poisson's ratio")
        }
        _ => sentence,
    }
}

/// Returns whether the sides of cells differ by the same power of ten, as in different units.
fn differ_by_unit(found: [f64; 2], expected: [f64; 2]) -> bool {
    let powers = [0, 1].map(|axis| (found[axis] / expected[axis]).log10());
    let power = powers[0].round();
    power != 0.0 && powers.iter().all(|found| (found - power).abs() < 1e-6)
}

fn one<'py>(
    attributes: &Bound<'py, PyDict>,
    name: &'static str,
    attribute: &str,
    value: impl IntoPyObject<'py>,
) -> PyResult<&'static str> {
    attributes.set_item(attribute, value)?;
    Ok(name)
}
