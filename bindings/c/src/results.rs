//! Reports, warnings and scalar results: plain structs that the caller reads.

use std::ffi::c_char;

use stickslip_rs::{EigenvalueBound, NormalSolution, Report, Status, TangentialSolution, Warning};

use crate::call::Outcome;
use crate::error::Failure;
use crate::pointer::{Place, entries_mut};
use crate::status::STICKSLIP_BUFFER_TOO_SMALL;

/// Status: nothing has been solved yet.
pub const STICKSLIP_UNSOLVED: i32 = 0;
/// Status: the residual and the certified error, both computed from a new product, are at or below the tolerance.
pub const STICKSLIP_CONVERGED: i32 = 1;
/// Status: the iteration limit was reached first.
pub const STICKSLIP_AT_ITERATION_LIMIT: i32 = 2;
/// Status: the time limit was reached first.
pub const STICKSLIP_AT_TIME_LIMIT: i32 = 3;
/// Status: the residual no longer decreases because the tolerance is below round-off.
pub const STICKSLIP_STALLED: i32 = 4;
/// Status: the observer ended the solve.
pub const STICKSLIP_CANCELLED: i32 = 5;

/// No bound on the smallest eigenvalue of the operator, on which certified errors rely, is available. The error bound
/// is then the square root of the duality gap of the problem, and decreases only with the square root of the residual.
pub const STICKSLIP_EIGENVALUE_UNKNOWN: i32 = 0;
/// The eigenvalue bound is an estimate on the safe side, used for stiff coatings on long grids.
pub const STICKSLIP_EIGENVALUE_ESTIMATED: i32 = 1;
/// The eigenvalue bound is a computed lower bound.
pub const STICKSLIP_EIGENVALUE_PROVEN: i32 = 2;
/// The eigenvalue bound is a lower bound stated by a user-defined operator. The library does not check it.
pub const STICKSLIP_EIGENVALUE_STATED: i32 = 3;

/// Status, cost and error bounds of a solve.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_report {
    /// STICKSLIP_CONVERGED, the reason why the solve did not converge, or STICKSLIP_UNSOLVED.
    pub status: i32,
    /// Origin of the eigenvalue bound behind duality_gap and all other certified errors: STICKSLIP_EIGENVALUE_PROVEN,
    /// STICKSLIP_EIGENVALUE_STATED, STICKSLIP_EIGENVALUE_ESTIMATED or STICKSLIP_EIGENVALUE_UNKNOWN.
    pub eigenvalue_bound: i32,
    /// Number of conjugate-gradient iterations.
    pub iterations: usize,
    /// Number of products with the operator in double precision.
    pub double_precision_products: usize,
    /// Number of products with the operator in single precision.
    pub single_precision_products: usize,
    /// Largest complementarity residual, relative to the largest displacement.
    pub residual: f64,
    /// Certified bound on the squared relative error in the energy norm.
    pub duality_gap: f64,
    /// Certified bound on the relative error in the energy norm, the square root of duality_gap. On a periodic grid under
    /// a prescribed approach or shift, the bound excludes the error of the computed force.
    pub energy_error_bound: f64,
    /// Relative error of the prescribed total force.
    pub load_error: f64,
    /// Wall time of the solve (seconds).
    pub seconds: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<&Report> for stickslip_report {
    fn from(report: &Report) -> Self {
        Self {
            status: match report.status {
                Status::Unsolved => STICKSLIP_UNSOLVED,
                Status::Converged => STICKSLIP_CONVERGED,
                Status::IterationLimit => STICKSLIP_AT_ITERATION_LIMIT,
                Status::TimeLimit => STICKSLIP_AT_TIME_LIMIT,
                Status::Cancelled => STICKSLIP_CANCELLED,
                _ => STICKSLIP_STALLED,
            },
            eigenvalue_bound: match report.eigenvalue_bound {
                EigenvalueBound::Proven => STICKSLIP_EIGENVALUE_PROVEN,
                EigenvalueBound::Stated => STICKSLIP_EIGENVALUE_STATED,
                EigenvalueBound::Estimated => STICKSLIP_EIGENVALUE_ESTIMATED,
                _ => STICKSLIP_EIGENVALUE_UNKNOWN,
            },
            iterations: report.iterations,
            double_precision_products: report.double_precision_products,
            single_precision_products: report.single_precision_products,
            residual: report.residual,
            duality_gap: report.duality_gap,
            energy_error_bound: report.energy_error_bound(),
            load_error: report.load_error,
            seconds: report.time.as_secs_f64(),
            reserved: [0; 8],
        }
    }
}

/// Returns the report of a problem that has not been solved.
pub(crate) fn unsolved() -> stickslip_report {
    stickslip_report {
        status: STICKSLIP_UNSOLVED,
        eigenvalue_bound: STICKSLIP_EIGENVALUE_UNKNOWN,
        iterations: 0,
        double_precision_products: 0,
        single_precision_products: 0,
        residual: f64::INFINITY,
        duality_gap: f64::INFINITY,
        energy_error_bound: f64::INFINITY,
        load_error: 0.0,
        seconds: 0.0,
        reserved: [0; 8],
    }
}

/// Warning: there is no contact.
pub const STICKSLIP_WARNING_NO_CONTACT: i32 = 1;
/// Warning: contact cells (number in cells) lie on the edge of the grid.
pub const STICKSLIP_WARNING_CONTACT_AT_EDGE: i32 = 2;
/// Warning: some contact spots (number in cells, out of the total in of) are smaller than five cells and together contain a
/// tenth of the contact cells or more.
pub const STICKSLIP_WARNING_UNRESOLVED_SPOTS: i32 = 3;
/// Warning: the grid is a line of cells and not periodic.
pub const STICKSLIP_WARNING_SINGLE_ROW_OF_CELLS: i32 = 4;
/// Warning: a contact spot extends across the whole grid.
pub const STICKSLIP_WARNING_CONTACT_SPANS_GRID: i32 = 5;
/// Warning: the pressure of some cells (number in cells) exceeds the hardness of a material.
pub const STICKSLIP_WARNING_BEYOND_HARDNESS: i32 = 6;
/// Warning: the pressure was held although the gap had changed.
pub const STICKSLIP_WARNING_STALE_PRESSURE: i32 = 7;
/// Warning: the contact has too few cells (number in cells).
pub const STICKSLIP_WARNING_UNDERRESOLVED_CONTACT: i32 = 8;
/// Warning: too few cells (number in cells) stick.
pub const STICKSLIP_WARNING_UNDERRESOLVED_STICK_ZONE: i32 = 9;
/// Warning: the slip zone is narrower than two cells, or than one cell in a step with rolling.
pub const STICKSLIP_WARNING_UNDERRESOLVED_SLIP_ZONE: i32 = 10;
/// Warning: a coupled problem was pressed in one step.
pub const STICKSLIP_WARNING_SINGLE_LOAD_STEP: i32 = 11;
/// Warning: the estimated discretisation error of the pressure or the traction exceeds 5 %. An error of 1 % requires a
/// larger number of cells (number in cells) along the radius of a contact spot.
pub const STICKSLIP_WARNING_DISCRETISATION_ERROR: i32 = 12;
/// Warning: the approach exceeds the longest side of the grid.
pub const STICKSLIP_WARNING_APPROACH_BEYOND_GRID: i32 = 13;
/// Warning: the contact radius exceeds 0.3 of the radius of curvature.
pub const STICKSLIP_WARNING_LARGE_CONTACT_RADIUS: i32 = 14;
/// Warning: the rms slope of the surface within the contact exceeds 0.5.
pub const STICKSLIP_WARNING_STEEP_SURFACE: i32 = 15;
/// Warning: a step of a history held the shift, and the tangential force decreased by more than half.
pub const STICKSLIP_WARNING_HELD_SHIFT_LOST_FORCE: i32 = 16;
/// Warning: tractions of dissimilar rolling bodies change the pressure, and this change is neglected.
pub const STICKSLIP_WARNING_NEGLECTED_LIFT: i32 = 17;
/// Warning: a layer is more than ten times as thick as the longest side of the grid, so that the material below it has almost no effect.
pub const STICKSLIP_WARNING_COATING_BEYOND_GRID: i32 = 18;
/// Warning: a layer is too thin to have an effect on the cells.
pub const STICKSLIP_WARNING_COATING_BELOW_CELL: i32 = 19;
/// Warning: the shift or relative displacement of a step, or the range of the shift over steps, exceeds the side of the grid.
pub const STICKSLIP_WARNING_SHIFT_BEYOND_GRID: i32 = 20;
/// Warning: the twist of a step, or the range of the twist over steps, exceeds 0.2 rad.
pub const STICKSLIP_WARNING_LARGE_TWIST: i32 = 21;
/// Warning: the creepage of rolling bodies is 0.1 or more.
pub const STICKSLIP_WARNING_LARGE_CREEPAGE: i32 = 22;
/// Warning: a relative displacement of the amount zero has no effect on a step with a tangential load.
pub const STICKSLIP_WARNING_UNUSED_RELATIVE_DISPLACEMENT: i32 = 23;
/// Warning: a cycle repeats a closed loop, so that its energies are sums over several loops.
pub const STICKSLIP_WARNING_REPEATED_LOOP: i32 = 24;
/// Warning: the largest pressure exceeds half of the contact modulus.
pub const STICKSLIP_WARNING_PRESSURE_BEYOND_MODULUS: i32 = 25;
/// Warning: the solve ended before it converged.
pub const STICKSLIP_WARNING_NOT_CONVERGED: i32 = 26;
/// Warning: the largest coefficient of friction exceeds 5, as a coefficient in per cent.
pub const STICKSLIP_WARNING_LARGE_FRICTION: i32 = 27;
/// Warning: the gap of contact cells changed by more than the largest normal displacement of the last contact.
pub const STICKSLIP_WARNING_LARGE_GAP_CHANGE: i32 = 28;
/// Warning: almost all contact cells are at a hardness far below the contact modulus.
pub const STICKSLIP_WARNING_LOW_HARDNESS: i32 = 29;
/// Warning: the largest shear stress lowers the friction capacity to less than 1 %.
pub const STICKSLIP_WARNING_LOW_SHEAR_STRESS: i32 = 30;
/// Warning: the loads of a cycle turn back, but the cycle does not close.
pub const STICKSLIP_WARNING_OPEN_CYCLE: i32 = 31;
/// Warning: the largest prescribed pressure is below 1e-7 of the contact modulus.
pub const STICKSLIP_WARNING_LOW_PRESSURE: i32 = 32;
/// Warning: the gap jumps across the border of a periodic grid, as a tilted surface.
pub const STICKSLIP_WARNING_PERIODIC_SEAM: i32 = 33;
/// Warning: a component of a bulk strain exceeds 0.02, as a strain in per cent.
pub const STICKSLIP_WARNING_LARGE_BULK_STRAIN: i32 = 34;
/// Warning: the scalar model with one-way coupling neglects large tractions across its axis.
pub const STICKSLIP_WARNING_NEGLECTED_TRACTION: i32 = 35;
/// Warning: the hardness exceeds the modulus of the body and has no effect.
pub const STICKSLIP_WARNING_HARDNESS_BEYOND_MODULUS: i32 = 36;
/// Warning: the largest shear stress of the friction exceeds the modulus of the bodies.
pub const STICKSLIP_WARNING_SHEAR_STRESS_BEYOND_MODULUS: i32 = 37;
/// Warning: the gap before loading resembles the gap under load of an earlier solution.
pub const STICKSLIP_WARNING_CLOSED_GAP: i32 = 38;
/// Warning: the gap decreased in cells that have slipped, and increased in none.
pub const STICKSLIP_WARNING_NEGATIVE_WEAR: i32 = 39;
/// Warning: the depth of a plane is less than a side of a cell, and shear tractions above it end at the edge of a contact.
pub const STICKSLIP_WARNING_STRESS_AT_EDGE: i32 = 40;
/// Any other warning, described by its message.
pub const STICKSLIP_WARNING_OTHER: i32 = 127;

/// Size of the message of a warning in bytes.
pub const STICKSLIP_WARNING_LENGTH: usize = 384;

/// Warning about a converged solution that may be misleading.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_warning {
    /// Kind of warning: STICKSLIP_WARNING_NO_CONTACT or another constant of this group.
    pub kind: i32,
    /// Number of cells or spots concerned; zero if the warning has no such number.
    pub cells: usize,
    /// Total number of spots; zero if the warning has no such number.
    pub of: usize,
    /// Meaning of the warning and suggested remedy, in English; ends with a zero byte.
    pub message: [c_char; STICKSLIP_WARNING_LENGTH],
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<&Warning> for stickslip_warning {
    fn from(warning: &Warning) -> Self {
        let (kind, cells, of) = match *warning {
            Warning::NoContact => (STICKSLIP_WARNING_NO_CONTACT, 0, 0),
            Warning::ContactAtEdge { cells } => (STICKSLIP_WARNING_CONTACT_AT_EDGE, cells, 0),
            Warning::UnresolvedSpots { unresolved, spots } => {
                (STICKSLIP_WARNING_UNRESOLVED_SPOTS, unresolved, spots)
            }
            Warning::SingleRowOfCells => (STICKSLIP_WARNING_SINGLE_ROW_OF_CELLS, 0, 0),
            Warning::ContactSpansGrid { .. } => (STICKSLIP_WARNING_CONTACT_SPANS_GRID, 0, 0),
            Warning::BeyondHardness { cells } => (STICKSLIP_WARNING_BEYOND_HARDNESS, cells, 0),
            Warning::StalePressure => (STICKSLIP_WARNING_STALE_PRESSURE, 0, 0),
            Warning::UnderresolvedContact { cells } => {
                (STICKSLIP_WARNING_UNDERRESOLVED_CONTACT, cells, 0)
            }
            Warning::UnderresolvedStickZone { cells } => {
                (STICKSLIP_WARNING_UNDERRESOLVED_STICK_ZONE, cells, 0)
            }
            Warning::UnderresolvedSlipZone { .. } => {
                (STICKSLIP_WARNING_UNDERRESOLVED_SLIP_ZONE, 0, 0)
            }
            Warning::SingleLoadStep => (STICKSLIP_WARNING_SINGLE_LOAD_STEP, 0, 0),
            Warning::DiscretisationError {
                cells_per_radius, ..
            } => (STICKSLIP_WARNING_DISCRETISATION_ERROR, cells_per_radius, 0),
            Warning::ApproachBeyondGrid { .. } => (STICKSLIP_WARNING_APPROACH_BEYOND_GRID, 0, 0),
            Warning::LargeContactRadius { .. } => (STICKSLIP_WARNING_LARGE_CONTACT_RADIUS, 0, 0),
            Warning::SteepSurface { .. } => (STICKSLIP_WARNING_STEEP_SURFACE, 0, 0),
            Warning::HeldShiftLostForce { .. } => (STICKSLIP_WARNING_HELD_SHIFT_LOST_FORCE, 0, 0),
            Warning::NeglectedTraction { .. } => (STICKSLIP_WARNING_NEGLECTED_TRACTION, 0, 0),
            Warning::NeglectedLift { .. } => (STICKSLIP_WARNING_NEGLECTED_LIFT, 0, 0),
            Warning::CoatingBeyondGrid { .. } => (STICKSLIP_WARNING_COATING_BEYOND_GRID, 0, 0),
            Warning::CoatingBelowCell { .. } => (STICKSLIP_WARNING_COATING_BELOW_CELL, 0, 0),
            Warning::ShiftBeyondGrid { .. } => (STICKSLIP_WARNING_SHIFT_BEYOND_GRID, 0, 0),
            Warning::LargeTwist { .. } => (STICKSLIP_WARNING_LARGE_TWIST, 0, 0),
            Warning::LargeCreepage { .. } => (STICKSLIP_WARNING_LARGE_CREEPAGE, 0, 0),
            Warning::UnusedRelativeDisplacement => {
                (STICKSLIP_WARNING_UNUSED_RELATIVE_DISPLACEMENT, 0, 0)
            }
            Warning::RepeatedLoop => (STICKSLIP_WARNING_REPEATED_LOOP, 0, 0),
            Warning::PressureBeyondModulus { .. } => {
                (STICKSLIP_WARNING_PRESSURE_BEYOND_MODULUS, 0, 0)
            }
            Warning::LargeFriction { .. } => (STICKSLIP_WARNING_LARGE_FRICTION, 0, 0),
            Warning::LargeGapChange { .. } => (STICKSLIP_WARNING_LARGE_GAP_CHANGE, 0, 0),
            Warning::LowHardness { .. } => (STICKSLIP_WARNING_LOW_HARDNESS, 0, 0),
            Warning::LowShearStress { .. } => (STICKSLIP_WARNING_LOW_SHEAR_STRESS, 0, 0),
            Warning::LowPressure { .. } => (STICKSLIP_WARNING_LOW_PRESSURE, 0, 0),
            Warning::PeriodicSeam { .. } => (STICKSLIP_WARNING_PERIODIC_SEAM, 0, 0),
            Warning::LargeBulkStrain { .. } => (STICKSLIP_WARNING_LARGE_BULK_STRAIN, 0, 0),
            Warning::HardnessBeyondModulus { .. } => {
                (STICKSLIP_WARNING_HARDNESS_BEYOND_MODULUS, 0, 0)
            }
            Warning::ShearStressBeyondModulus { .. } => {
                (STICKSLIP_WARNING_SHEAR_STRESS_BEYOND_MODULUS, 0, 0)
            }
            Warning::ClosedGap { cells } => (STICKSLIP_WARNING_CLOSED_GAP, cells, 0),
            Warning::NegativeWear { cells } => (STICKSLIP_WARNING_NEGATIVE_WEAR, cells, 0),
            Warning::StressAtEdge => (STICKSLIP_WARNING_STRESS_AT_EDGE, 0, 0),
            Warning::OpenCycle { .. } => (STICKSLIP_WARNING_OPEN_CYCLE, 0, 0),
            Warning::NotConverged => (STICKSLIP_WARNING_NOT_CONVERGED, 0, 0),
            _ => (STICKSLIP_WARNING_OTHER, 0, 0),
        };
        let mut message: [c_char; STICKSLIP_WARNING_LENGTH] = [0; STICKSLIP_WARNING_LENGTH];
        let text = warning.to_string();
        let ascii = text.bytes().filter(u8::is_ascii);
        for (to, from) in message[..STICKSLIP_WARNING_LENGTH - 1]
            .iter_mut()
            .zip(ascii)
        {
            *to = c_char::from_ne_bytes([from]);
        }
        Self {
            kind,
            cells,
            of,
            message,
            reserved: [0; 8],
        }
    }
}

/// Writes warnings into a buffer, and their number.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn put_warnings(
    buffer: *mut stickslip_warning,
    capacity: usize,
    count: *mut usize,
    find: impl FnOnce() -> Outcome<Vec<Warning>>,
) -> Outcome {
    let name = "buffer of warnings";
    // SAFETY: the caller follows the safety contract of this function.
    let (count, buffer) = unsafe {
        let count = Place::new("count", count)?;
        (count, entries_mut(name, buffer, capacity)?)
    };
    let warnings = find()?;
    count.put(warnings.len());
    if capacity > 0 && capacity < warnings.len() {
        let lengths = [warnings.len(), capacity];
        return Err(Failure::length(STICKSLIP_BUFFER_TOO_SMALL, name, lengths));
    }
    for (to, warning) in buffer.iter_mut().zip(&warnings) {
        *to = warning.into();
    }
    Ok(())
}

/// Scalar results of a normal contact.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_normal_result {
    /// Approach of the bodies from the datum of the gap (a length).
    pub approach: f64,
    /// Normal force.
    pub force: f64,
    /// Total area of the contact cells.
    pub contact_area: f64,
    /// Contact area corrected for the staircase shape of its perimeter.
    pub contact_area_corrected: f64,
    /// Ratio of force to contact area; zero without contact.
    pub mean_pressure: f64,
    /// Moments of the pressure about x and y at the origin of the grid (forces times lengths).
    pub moments: [f64; 2],
    /// Centre of pressure (lengths); NaN without contact.
    pub centre_of_pressure: [f64; 2],
    /// Number of contact cells.
    pub contact_cells: usize,
    /// Number of cells whose pressure equals their hardness.
    pub yielded_cells: usize,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<&NormalSolution> for stickslip_normal_result {
    fn from(solution: &NormalSolution) -> Self {
        Self {
            approach: solution.approach(),
            force: solution.force(),
            contact_area: solution.contact_area(),
            contact_area_corrected: solution.contact_area_corrected(),
            mean_pressure: solution.mean_pressure(),
            moments: solution.moments(),
            centre_of_pressure: solution.centre_of_pressure().unwrap_or([f64::NAN; 2]),
            contact_cells: solution.contact_cells(),
            yielded_cells: solution.yielded_cells(),
            reserved: [0; 8],
        }
    }
}

/// Scalar results of a tangential contact.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_tangential_result {
    /// Shift (lengths): the rigid motion of body 2 relative to body 1 far from the contact, with the sign of the force.
    pub shift: [f64; 2],
    /// Tangential force that body 2 exerts on body 1.
    pub force: [f64; 2],
    /// Rotation of body 2 relative to body 1 (radians).
    pub twist: f64,
    /// Moment about z at the origin of the grid that the tractions exert on body 1 (a force times a length, positive from
    /// x to y).
    pub moment: f64,
    /// Ratio of stick cells to contact cells.
    pub stick_ratio: f64,
    /// Area of the stick zone.
    pub stick_area: f64,
    /// Area of the slip zone.
    pub slip_area: f64,
    /// Energy dissipated by slip (a force times a length).
    pub dissipated_energy: f64,
    /// Nonzero if the whole contact is at its friction limit.
    pub is_gross_slip: i32,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<&TangentialSolution> for stickslip_tangential_result {
    fn from(solution: &TangentialSolution) -> Self {
        Self {
            shift: solution.shift(),
            force: solution.force(),
            twist: solution.twist(),
            moment: solution.moment(),
            stick_ratio: solution.stick_ratio(),
            stick_area: solution.stick_area(),
            slip_area: solution.slip_area(),
            dissipated_energy: solution.dissipated_energy(),
            is_gross_slip: i32::from(solution.is_gross_slip()),
            reserved: [0; 8],
        }
    }
}
