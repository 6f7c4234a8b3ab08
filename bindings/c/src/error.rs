//! Last failure of a thread.

use std::cell::{Cell, RefCell};
use std::ffi::c_char;

use stickslip_rs::{Error, ranks::RankFailure};

use crate::call::{Outcome, call};
use crate::pointer::answer;
use crate::results::stickslip_report;
use crate::status::*;

/// Numbers that describe the last failure on this thread; members without a meaning for the failure are zero.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
pub struct stickslip_error {
    /// Return value of the function; STICKSLIP_OK before any failure.
    pub code: stickslip_status,
    /// Invalid value.
    pub value: f64,
    /// Limit that the value violates.
    pub limit: f64,
    /// Index of the invalid sample, or position in a batch.
    pub index: usize,
    /// Number of entries required.
    pub expected: usize,
    /// Number of entries supplied.
    pub found: usize,
    /// Reserved for future members: zero.
    pub reserved: [u64; 4],
}

/// Failure of an exported function.
#[derive(Debug)]
pub(crate) struct Failure {
    pub(crate) code: stickslip_status,
    message: String,
    numbers: stickslip_error,
    report: Option<Box<stickslip_report>>,
}

impl Failure {
    pub(crate) fn new(code: stickslip_status, message: String) -> Self {
        Self {
            code,
            message,
            numbers: stickslip_error {
                code,
                ..stickslip_error::default()
            },
            report: None,
        }
    }

    /// Creates the failure for an invalid value.
    pub(crate) fn at_value(code: stickslip_status, value: f64, message: String) -> Self {
        Self::new(code, message).with(|numbers| numbers.value = value)
    }

    /// Creates the failure for an entry, an argument or a handle that is required but missing.
    pub(crate) fn pointer(name: &str) -> Self {
        Self::new(
            STICKSLIP_BAD_POINTER,
            format!("{name} is NULL or misaligned"),
        )
    }

    /// Creates the failure for an object that has not been created.
    pub(crate) fn object(name: &str) -> Self {
        Self::new(
            STICKSLIP_BAD_POINTER,
            format!(
                "{name} is NULL or misaligned: create the object and check the status of its creation, and do not use an object that was moved or freed"
            ),
        )
    }

    /// Creates the failure for a quantity with a number of cells but without their values.
    pub(crate) fn missing_cells(name: &str, count: usize) -> Self {
        Self::new(
            STICKSLIP_BAD_POINTER,
            format!(
                "the member cells of the {name} is NULL, but count is {count}: set cells to an array, or count to zero"
            ),
        )
    }

    pub(crate) fn busy(name: &str) -> Self {
        Self::new(
            STICKSLIP_BUSY,
            format!(
                "{name} is in use by another thread or by the call that made this call: wait until that call returns"
            ),
        )
    }

    /// Creates the failure for a history that a batch contains twice.
    pub(crate) fn repeated([first, second]: [usize; 2]) -> Self {
        Self::new(
            STICKSLIP_BUSY,
            format!(
                "history {second} is the same object as history {first}: pass each history once"
            ),
        )
    }

    /// Returns the failure of a call that has written this number of entries before it failed.
    pub(crate) fn after_entries(self, written: usize) -> Self {
        self.with(|numbers| numbers.found = written)
    }

    /// Creates the failure for a number that is not a constant of its kind. The remedy names the constants.
    pub(crate) fn option(name: &str, value: i32, constants: &str) -> Self {
        let message = format!("the value {value} is not a valid {name}: use {constants}");
        Self::at_value(STICKSLIP_UNKNOWN_OPTION, f64::from(value), message)
    }

    /// Creates the failure for an index that no depth of the planes has.
    pub(crate) fn depth(index: usize, depths: usize) -> Self {
        let message = match depths.checked_sub(1) {
            None => "the planes have no depths: create them with at least one depth".into(),
            Some(last) => format!(
                "no depth has the index {index}, counted from zero: use 0 to {last}, because the number of depths is {depths}"
            ),
        };
        Self::new(STICKSLIP_LENGTH, message).with(|numbers| {
            numbers.index = index;
            (numbers.expected, numbers.found) = (index.saturating_add(1), depths);
        })
    }

    /// Returns an error if a member without effect is given, that is, not zero. The reason names the member that excludes it,
    /// and the remedy.
    pub(crate) fn if_given(member: &str, value: f64, reason: &str) -> Outcome {
        if value == 0.0 {
            return Ok(());
        }
        let message = format!("{member} is {value} but has no effect: {reason}");
        Err(Self::at_value(STICKSLIP_INVALID_ARGUMENT, value, message))
    }

    pub(crate) fn time_limit(value: f64) -> Self {
        let message = format!("the time limit must be non-negative, got {value}");
        Self::at_value(STICKSLIP_NEGATIVE_OR_NOT_FINITE, value, message)
    }

    pub(crate) fn length(
        code: stickslip_status,
        name: &str,
        [expected, found]: [usize; 2],
    ) -> Self {
        Self::new(
            code,
            format!("{name} has {found} entries, expected {expected}"),
        )
        .with(|numbers| {
            (numbers.expected, numbers.found) = (expected, found);
        })
    }

    /// Adds a position in a batch to the failure.
    pub(crate) fn at(mut self, index: usize) -> Self {
        self.code = STICKSLIP_SOME_FAILED;
        self.message = format!("contact {index}: {}", self.message);
        self.with(|numbers| (numbers.code, numbers.index) = (STICKSLIP_SOME_FAILED, index))
    }

    fn with(mut self, set: impl FnOnce(&mut stickslip_error)) -> Self {
        set(&mut self.numbers);
        self
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        let code = code_of(&error);
        let message = error.to_string();
        let report = match &error {
            Error::NotConverged(report) => Some(Box::new(stickslip_report::from(&**report))),
            _ => None,
        };
        let failure = Self::new(code, message);
        Self { report, ..failure }.with(|numbers| fill(numbers, &error))
    }
}

fn code_of(error: &Error) -> stickslip_status {
    match error {
        Error::NotConverged(_) => STICKSLIP_NOT_CONVERGED,
        Error::BeyondFrictionCapacity { .. } | Error::BeyondFrictionMoment { .. } => {
            STICKSLIP_BEYOND_FRICTION_CAPACITY
        }
        Error::BeyondHardness { .. } => STICKSLIP_BEYOND_HARDNESS,
        Error::EmptyContact => STICKSLIP_EMPTY_CONTACT,
        Error::ApproachBeyondMeanGap { .. } => STICKSLIP_APPROACH_BEYOND_MEAN_GAP,
        Error::CoupledMaterials { .. } => STICKSLIP_COUPLED_MATERIALS,
        Error::UnsupportedByModel { .. } => STICKSLIP_UNSUPPORTED_BY_MODEL,
        Error::ObliqueLoad { .. } => STICKSLIP_OBLIQUE_LOAD,
        Error::StepTooLong { .. } => STICKSLIP_STEP_TOO_LONG,
        Error::Yielded { .. } => STICKSLIP_YIELDED,
        Error::StepOutOfOrder { .. } => STICKSLIP_STEP_OUT_OF_ORDER,
        Error::CycleNotClosed { .. } => STICKSLIP_CYCLE_NOT_CLOSED,
        Error::NoLastStep => STICKSLIP_NO_LAST_STEP,
        Error::OutdatedSolution { .. } => STICKSLIP_OUTDATED_SOLUTION,
        Error::GapUnderLoad => STICKSLIP_GAP_UNDER_LOAD,
        Error::GridSize { .. } => STICKSLIP_GRID_SIZE,
        Error::Memory { .. } => STICKSLIP_MEMORY,
        Error::NotPositive { .. } => STICKSLIP_NOT_POSITIVE,
        Error::NegativeOrNotFinite { .. } => STICKSLIP_NEGATIVE_OR_NOT_FINITE,
        Error::NotFinite { .. } => STICKSLIP_NOT_FINITE,
        Error::Sample { .. } => STICKSLIP_SAMPLE,
        Error::PoissonRatio(_) => STICKSLIP_POISSON_RATIO,
        Error::BothRigid => STICKSLIP_BOTH_RIGID,
        Error::CellsTooLong { .. } => STICKSLIP_CELLS_TOO_LONG,
        Error::Length { .. } => STICKSLIP_LENGTH,
        Error::GridMismatch { .. } => STICKSLIP_GRID_MISMATCH,
        Error::BoundaryMismatch { .. } => STICKSLIP_BOUNDARY_MISMATCH,
        Error::CellValueMismatch { .. } => STICKSLIP_CELL_VALUE_MISMATCH,
        Error::MaterialMismatch { .. } => STICKSLIP_MATERIAL_MISMATCH,
        Error::Tolerance(_) => STICKSLIP_TOLERANCE,
        Error::IterationLimit => STICKSLIP_ITERATION_LIMIT,
        Error::NoPressureToHold => STICKSLIP_NO_PRESSURE_TO_HOLD,
        Error::Method { .. } => STICKSLIP_METHOD,
        Error::BelowMinimum { .. } => STICKSLIP_BELOW_MINIMUM,
        Error::GridTooShort { .. } => STICKSLIP_GRID_TOO_SHORT,
        Error::Format { .. } => STICKSLIP_FORMAT,
        Error::RigidBody(_) => STICKSLIP_RIGID_BODY,
        Error::DivergentPeriodicSum(_) => STICKSLIP_DIVERGENT_PERIODIC_SUM,
        Error::Hurst(_) => STICKSLIP_HURST,
        Error::NoWaveInBand { .. } => STICKSLIP_NO_WAVE_IN_BAND,
        Error::HeightMomentsNotReached { .. } => STICKSLIP_HEIGHT_MOMENTS_NOT_REACHED,
        Error::Ranks(_) => STICKSLIP_RANK_FAILURE,
        Error::ExtremeNumber { .. } => STICKSLIP_EXTREME_NUMBER,
        _ => STICKSLIP_INVALID_ARGUMENT,
    }
}

fn fill(numbers: &mut stickslip_error, error: &Error) {
    match *error {
        Error::NotPositive { value, .. }
        | Error::NegativeOrNotFinite { value, .. }
        | Error::NotFinite { value, .. }
        | Error::UnsupportedByModel { value, .. }
        | Error::PoissonRatio(value)
        | Error::Tolerance(value)
        | Error::Hurst(value)
        | Error::CoupledMaterials { beta: value, .. } => numbers.value = value,
        Error::BeyondFrictionCapacity {
            force: value,
            limit,
            ..
        }
        | Error::BeyondFrictionMoment {
            moment: value,
            limit,
            ..
        }
        | Error::CycleNotClosed {
            residual: value,
            limit,
            ..
        }
        | Error::DatumTooNear {
            datum: value,
            least: limit,
        }
        | Error::BeyondHardness {
            force: value,
            capacity: limit,
            ..
        }
        | Error::ApproachBeyondMeanGap {
            approach: value,
            mean_gap: limit,
            ..
        }
        | Error::ObliqueLoad {
            x: value, y: limit, ..
        }
        | Error::NoWaveInBand {
            longest: value,
            shortest: limit,
        }
        | Error::HeightMomentsNotReached {
            skewness: value,
            kurtosis: limit,
            ..
        }
        | Error::BelowMinimum {
            value,
            least: limit,
            ..
        }
        | Error::StepTooLong {
            error: value,
            tolerance: limit,
            ..
        } => (numbers.value, numbers.limit) = (value, limit),
        Error::ExtremeNumber {
            value, least, most, ..
        } => {
            let limit = if value < least { least } else { most };
            (numbers.value, numbers.limit) = (value, limit);
        }
        Error::Sample { index, value, .. } => (numbers.index, numbers.value) = (index, value),
        Error::Yielded { cells: index, .. }
        | Error::Ranks(
            RankFailure::Disconnected { rank: index }
            | RankFailure::CollectiveMismatch { rank: index }
            | RankFailure::RejectedByRank { rank: index },
        ) => numbers.index = index,
        Error::Length {
            expected, found, ..
        }
        | Error::GridTooShort {
            needed: expected,
            found,
            ..
        } => (numbers.expected, numbers.found) = (expected, found),
        Error::GridMismatch {
            expected_cells,
            found_cells,
            ..
        } => {
            numbers.expected = expected_cells[0].saturating_mul(expected_cells[1]);
            numbers.found = found_cells[0].saturating_mul(found_cells[1]);
        }
        _ => {}
    }
}

/// Size of a message in bytes, including the zero at its end; longer messages are truncated.
const LONGEST: usize = 4096;

/// Last failure in the form that C reads.
struct Last {
    numbers: stickslip_error,
    report: Option<stickslip_report>,
}

thread_local! {
    static LAST: RefCell<Last> = const { RefCell::new(Last {
        numbers: stickslip_error { code: STICKSLIP_OK, value: 0.0, limit: 0.0, index: 0, expected: 0, found: 0, reserved: [0; 4] },
        report: None,
    }) };
    /// Message of the last failure. Its address never changes, so that a pointer to it stays valid until the thread ends.
    static MESSAGE: [Cell<u8>; LONGEST] = const { [const { Cell::new(0) }; LONGEST] };
}

/// Stores a failure for the functions below.
pub(crate) fn remember(failure: Failure) {
    let mut end = failure.message.len().min(LONGEST - 1);
    while !failure.message.is_char_boundary(end) {
        end -= 1;
    }
    let text = failure.message[..end].bytes().chain([0]);
    let _ =
        MESSAGE.try_with(|message| message.iter().zip(text).for_each(|(to, from)| to.set(from)));
    // Access fails only while the thread is ending, when no function can read the failure any more.
    let _ = LAST.try_with(|last| {
        last.replace(Last {
            numbers: failure.numbers,
            report: failure.report.map(|report| *report),
        })
    });
}

/// Returns the message of the last failure on this thread, in English and UTF-8; the message is empty before any failure.
/// The pointer is the same for all failures of a thread and valid until the thread ends. The text remains until the next
/// failing call of the same thread overwrites it. Successful calls and the calls of other threads do not change it.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_last_error_message() -> *const c_char {
    MESSAGE
        .try_with(|message| message.as_ptr().cast())
        .unwrap_or(c"".as_ptr())
}

/// Copies the message of the last failure on this thread to buffer, which has room for capacity bytes, and returns the length
/// of the message without the zero at its end. A message that does not fit is truncated to whole characters. The copy ends
/// with a zero unless the capacity is 0. With a NULL buffer or a capacity of 0 only the length is returned. The call does not
/// fail and does not change the last failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_last_error_copy(buffer: *mut c_char, capacity: usize) -> usize {
    MESSAGE
        .try_with(|message| {
            let bytes = || message.iter().map(Cell::get).take_while(|&byte| byte != 0);
            let length = bytes().count();
            if buffer.is_null() || capacity == 0 {
                return length;
            }
            let mut end = length.min(capacity - 1);
            // The bytes after the first byte of a character have the form 10xxxxxx.
            while end < length && end > 0 && message[end].get() & 0b1100_0000 == 0b1000_0000 {
                end -= 1;
            }
            for (offset, byte) in bytes().take(end).chain([0]).enumerate() {
                // SAFETY: the buffer has room for `capacity` bytes by the rule for pointers, and `end < capacity`.
                unsafe { buffer.cast::<u8>().add(offset).write(byte) };
            }
            length
        })
        .unwrap_or(0)
}

/// Writes the numbers that describe the last failure on this thread.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_last_error(error: *mut stickslip_error) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe {
        answer("error", error, || {
            let numbers = LAST.try_with(|last| last.borrow().numbers);
            Ok(numbers.unwrap_or_default())
        })
    })
}

/// Writes the report of the last failure on this thread if its code was STICKSLIP_NOT_CONVERGED, and returns
/// STICKSLIP_INVALID_ARGUMENT otherwise.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_last_error_report(
    report: *mut stickslip_report,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe {
        answer("report", report, || {
            let last = LAST.try_with(|last| last.borrow().report).ok().flatten();
            let none = || {
                Failure::new(
                    STICKSLIP_INVALID_ARGUMENT,
                    "the last failure has no report: only STICKSLIP_NOT_CONVERGED has one".into(),
                )
            };
            last.ok_or_else(none)
        })
    })
}
