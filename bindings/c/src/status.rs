//! Return codes of the functions.

/// Return code of a function: STICKSLIP_OK or the kind of failure.
pub type stickslip_status = i32;

/// Success.
pub const STICKSLIP_OK: i32 = 0;
/// The tolerance was not reached, or the observer or a limit ended the solve. The solution contains the last feasible
/// iterate and its report. A history is unchanged, and stickslip_last_error_report writes the report.
pub const STICKSLIP_NOT_CONVERGED: i32 = 1;
/// The tangential force exceeds the friction capacity, or the moment about the normal is at or beyond an end of the range that
/// friction can carry (value and limit): no equilibrium exists.
pub const STICKSLIP_BEYOND_FRICTION_CAPACITY: i32 = 2;
/// The normal force (value) exceeds the largest force that the cells can carry at their hardness (limit).
pub const STICKSLIP_BEYOND_HARDNESS: i32 = 3;
/// The bodies do not touch: a tangential load requires a contact.
pub const STICKSLIP_EMPTY_CONTACT: i32 = 4;
/// The approach (value) is not below the mean gap (limit) of a periodic contact.
pub const STICKSLIP_APPROACH_BEYOND_MEAN_GAP: i32 = 5;
/// The materials couple pressure and traction (value: Dundurs' beta), and the requested model does not include the
/// coupling.
pub const STICKSLIP_COUPLED_MATERIALS: i32 = 6;
/// The model does not include this load (value).
pub const STICKSLIP_UNSUPPORTED_BY_MODEL: i32 = 7;
/// The load has components along both axes, which the scalar model does not allow (value: along x, limit: along y).
pub const STICKSLIP_OBLIQUE_LOAD: i32 = 8;
/// The load was divided into the shortest steps allowed, and the error of a step (value) still exceeds its tolerance
/// (limit).
pub const STICKSLIP_STEP_TOO_LONG: i32 = 9;
/// Some cells (index: their number) are at their hardness, but the requested operation requires an elastic contact.
pub const STICKSLIP_YIELDED: i32 = 10;
/// The history has taken no step since the last step of the cycle.
pub const STICKSLIP_STEP_OUT_OF_ORDER: i32 = 11;
/// The cycle does not close: its cyclic residual (value) exceeds the limit (limit) for a cycle that represents the
/// following cycles.
pub const STICKSLIP_CYCLE_NOT_CLOSED: i32 = 12;

/// The history has no last step: it took no step since it was created or its state was set. Make a step after
/// stickslip_history_set_state or stickslip_history_from_bytes.
pub const STICKSLIP_NO_LAST_STEP: i32 = 13;
/// A stiffness was requested after a change of friction, gap, pressure or load, to which the last solution does not belong. Solve
/// again, or take a step, before you compute the stiffness. Or a rolling solver does not have the pressure of a normal load: set a
/// normal load before you copy its normal contact.
pub const STICKSLIP_OUTDATED_SOLUTION: i32 = 14;
/// A new gap is the gap under load of the last solution. Add the wear to the gap before loading.
pub const STICKSLIP_GAP_UNDER_LOAD: i32 = 15;

/// A required handle or another required pointer is NULL or misaligned.
pub const STICKSLIP_BAD_POINTER: i32 = 32;
/// Another thread is using the handle, or a batch contains it twice; nothing was done with it.
pub const STICKSLIP_BUSY: i32 = 33;
/// The number (value) is not a constant of the required kind, or a struct has a member that this library does not support:
/// reserved is not zero.
pub const STICKSLIP_UNKNOWN_OPTION: i32 = 34;
/// The capacity of the buffer (found) is smaller than the number of entries (expected).
pub const STICKSLIP_BUFFER_TOO_SMALL: i32 = 35;
/// Some histories of a batch failed: codes has the reason for each, and the last error belongs to the first failure
/// (index).
pub const STICKSLIP_SOME_FAILED: i32 = 36;
/// The threads cannot be created.
pub const STICKSLIP_NO_THREADS: i32 = 37;
/// The library has a defect. The objects of the call can be freed but should not be used otherwise.
pub const STICKSLIP_PANIC: i32 = 38;

/// A grid needs at least one cell along each axis.
pub const STICKSLIP_GRID_SIZE: i32 = 64;
/// Memory cannot be allocated, and none was allocated.
pub const STICKSLIP_MEMORY: i32 = 65;
/// A quantity (value) that must be positive and finite is not.
pub const STICKSLIP_NOT_POSITIVE: i32 = 66;
/// A quantity (value) that must be zero or positive, and finite, is not.
pub const STICKSLIP_NEGATIVE_OR_NOT_FINITE: i32 = 67;
/// A quantity (value) that must be finite is not.
pub const STICKSLIP_NOT_FINITE: i32 = 68;
/// A sample (value, at index) of a field violates a rule for that field.
pub const STICKSLIP_SAMPLE: i32 = 69;
/// Poisson's ratio (value) lies outside (-1, 1/2].
pub const STICKSLIP_POISSON_RATIO: i32 = 70;
/// Both bodies are rigid: nothing deforms.
pub const STICKSLIP_BOTH_RIGID: i32 = 71;
/// The cells are too long: double precision does not resolve the compliance of their shortest waves.
pub const STICKSLIP_CELLS_TOO_LONG: i32 = 72;
/// An array has the wrong number of entries (found instead of expected).
pub const STICKSLIP_LENGTH: i32 = 73;
/// Two objects have different grids.
pub const STICKSLIP_GRID_MISMATCH: i32 = 74;
/// Two objects belong to bodies with different boundaries.
pub const STICKSLIP_BOUNDARY_MISMATCH: i32 = 75;
/// Two objects belong to bodies of different materials.
pub const STICKSLIP_MATERIAL_MISMATCH: i32 = 76;
/// The tolerance (value) lies outside (0, 1).
pub const STICKSLIP_TOLERANCE: i32 = 77;
/// The iteration limit is zero.
pub const STICKSLIP_ITERATION_LIMIT: i32 = 78;
/// A solver cannot hold a pressure, which only a history can: prescribe a force or an approach.
pub const STICKSLIP_NO_PRESSURE_TO_HOLD: i32 = 79;
/// The method does not solve this kind of problem.
pub const STICKSLIP_METHOD: i32 = 80;
/// A quantity (value) is below its lower limit (limit).
pub const STICKSLIP_BELOW_MINIMUM: i32 = 81;
/// The bytes are not a saved history, have a different version, or are damaged.
pub const STICKSLIP_FORMAT: i32 = 82;
/// The body is rigid: its stress is not determined.
pub const STICKSLIP_RIGID_BODY: i32 = 83;
/// A sum over images does not converge on a grid that is periodic along both axes.
pub const STICKSLIP_DIVERGENT_PERIODIC_SUM: i32 = 84;
/// The Hurst exponent (value) lies outside [0, 1].
pub const STICKSLIP_HURST: i32 = 85;
/// No wave of the surface has a wavelength between the longest (value) and the shortest (limit).
pub const STICKSLIP_NO_WAVE_IN_BAND: i32 = 86;
/// No heights of this skewness (value) and kurtosis (limit) were found.
pub const STICKSLIP_HEIGHT_MOMENTS_NOT_REACHED: i32 = 87;
/// Two objects belong to bodies with different meanings of the cell values.
pub const STICKSLIP_CELL_VALUE_MISMATCH: i32 = 88;
/// The ranks cannot continue together: a rank (index) is lost, makes different calls or has rejected its part, or the ranks
/// have different inputs, which the message names.
pub const STICKSLIP_RANK_FAILURE: i32 = 89;
/// A step with rolling requires more cells (expected) ahead of the contact or behind it than the grid has there (found).
pub const STICKSLIP_GRID_TOO_SHORT: i32 = 90;
/// A quantity (value) is beyond a limit (limit) outside which its square overflows or underflows: choose other units.
pub const STICKSLIP_EXTREME_NUMBER: i32 = 91;
/// Any other error, described by its message.
pub const STICKSLIP_INVALID_ARGUMENT: i32 = 127;
