//! What functions return.

/// What a function returns: STICKSLIP_OK or the kind of failure.
pub type stickslip_status = i32;

/// Done.
pub const STICKSLIP_OK: i32 = 0;
/// The tolerance was not reached, or the observer or a limit ended the solve. The solution holds the last feasible iterate
/// and its report; a history is as it was, and stickslip_last_error_report has the report.
pub const STICKSLIP_NOT_CONVERGED: i32 = 1;
/// The tangential force or moment (value) exceeds what friction can carry (limit): no equilibrium exists.
pub const STICKSLIP_BEYOND_FRICTION_CAPACITY: i32 = 2;
/// The normal force (value) exceeds what the hardness lets the cells carry (limit).
pub const STICKSLIP_BEYOND_HARDNESS: i32 = 3;
/// The bodies do not touch: there is nothing to load tangentially.
pub const STICKSLIP_EMPTY_CONTACT: i32 = 4;
/// The approach (value) is not below the mean gap (limit) of a periodic contact.
pub const STICKSLIP_APPROACH_BEYOND_MEAN_GAP: i32 = 5;
/// The materials couple pressure and traction (value: Dundurs' beta), and what was asked for does not model that.
pub const STICKSLIP_COUPLED_MATERIALS: i32 = 6;
/// The model does not include this load (value).
pub const STICKSLIP_UNSUPPORTED_BY_MODEL: i32 = 7;
/// The load has components along both axes, which the scalar model does not allow (value: along x, limit: along y).
pub const STICKSLIP_OBLIQUE_LOAD: i32 = 8;
/// A load was cut into the shortest steps allowed, and the error of one (value) is still beyond its tolerance (limit).
pub const STICKSLIP_STEP_TOO_LONG: i32 = 9;
/// Cells (index: how many) are at their hardness, where only elastic contacts have what was asked for.
pub const STICKSLIP_YIELDED: i32 = 10;
/// A history that a cycle already counts, or of another step.
pub const STICKSLIP_STEP_ALREADY_COUNTED: i32 = 11;
/// The cycle does not close: the residual of its loop (value) is more than what stands for those that follow (limit).
pub const STICKSLIP_CYCLE_NOT_CLOSED: i32 = 12;

/// A handle or another pointer that is needed is NULL, or misaligned.
pub const STICKSLIP_BAD_POINTER: i32 = 32;
/// The handle is in use by another thread; nothing was done.
pub const STICKSLIP_BUSY: i32 = 33;
/// The number (value) is no constant of the kind that is needed there, or a struct has a member that this library does not
/// know: reserved is not zero.
pub const STICKSLIP_UNKNOWN_OPTION: i32 = 34;
/// The buffer has room for fewer entries (found) than there are (expected).
pub const STICKSLIP_BUFFER_TOO_SMALL: i32 = 35;
/// Some contacts of a batch failed: the codes of each say why, the last error is that of the first (index).
pub const STICKSLIP_SOME_FAILED: i32 = 36;
/// The threads cannot be made.
pub const STICKSLIP_NO_THREADS: i32 = 37;
/// A defect of the library. The objects of the call can be freed, and should not be used otherwise.
pub const STICKSLIP_PANIC: i32 = 38;

/// A grid needs at least one cell along each axis.
pub const STICKSLIP_GRID_SIZE: i32 = 64;
/// Memory cannot be allocated, and none was.
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
/// The cells are too long: double precision does not resolve the compliance of their short waves.
pub const STICKSLIP_CELLS_TOO_LONG: i32 = 72;
/// An array has the wrong number of entries (found for expected).
pub const STICKSLIP_LENGTH: i32 = 73;
/// Two objects live on different grids.
pub const STICKSLIP_GRID_MISMATCH: i32 = 74;
/// Two objects belong to bodies with different boundaries.
pub const STICKSLIP_BOUNDARY_MISMATCH: i32 = 75;
/// Two objects belong to bodies of different materials.
pub const STICKSLIP_MATERIAL_MISMATCH: i32 = 76;
/// The tolerance (value) lies outside (0, 1).
pub const STICKSLIP_TOLERANCE: i32 = 77;
/// The iteration limit is zero.
pub const STICKSLIP_ITERATION_LIMIT: i32 = 78;
/// A solver that is to hold its pressure has none yet: give it a force or an approach.
pub const STICKSLIP_NO_PRESSURE_TO_HOLD: i32 = 79;
/// The method does not solve this kind of problem.
pub const STICKSLIP_METHOD: i32 = 80;
/// A quantity (value) is below its lower limit (limit).
pub const STICKSLIP_BELOW_MINIMUM: i32 = 81;
/// The bytes are no saved history, of another version, or damaged.
pub const STICKSLIP_FORMAT: i32 = 82;
/// The body is rigid: nothing determines its stress.
pub const STICKSLIP_RIGID_BODY: i32 = 83;
/// A sum over images that does not converge on a grid that repeats along both axes.
pub const STICKSLIP_DIVERGENT_PERIODIC_SUM: i32 = 84;
/// The Hurst exponent (value) lies outside [0, 1].
pub const STICKSLIP_HURST: i32 = 85;
/// No wave of the surface has a wavelength between the longest (value) and the shortest (limit).
pub const STICKSLIP_NO_WAVE_IN_BAND: i32 = 86;
/// No heights of this skewness (value) and kurtosis (limit) were found.
pub const STICKSLIP_HEIGHT_MOMENTS_NOT_REACHED: i32 = 87;
/// Two objects belong to bodies whose cells have values of another meaning.
pub const STICKSLIP_CELL_VALUE_MISMATCH: i32 = 88;
/// Ranks cannot go on together: one of them (index) is lost, makes other calls or has refused its part, or they came with
/// different inputs, which the message names.
pub const STICKSLIP_RANK_FAILURE: i32 = 89;
/// A rolled step needs more cells (expected) next to the contact than the grid has there (found): ahead of it or behind it.
pub const STICKSLIP_GRID_TOO_SHORT: i32 = 90;
/// A quantity (value) is beyond a limit (limit) outside which its squares leave the range of numbers: choose other units.
pub const STICKSLIP_EXTREME_NUMBER: i32 = 91;
/// Any other refusal: the message says which.
pub const STICKSLIP_INVALID_ARGUMENT: i32 = 127;
