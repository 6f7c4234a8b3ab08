//! Texts of the warnings.

use crate::error::counted;
use crate::warning::Warning;
use crate::warning::limits::{
    LARGEST_COUPLING, LARGEST_RESIDUAL, LARGEST_SEAM, LOWEST_CAP, LOWEST_HARDNESS, LOWEST_PRESSURE,
    MANY_SPOTS, THICKEST_LAYER, refinement,
};
use crate::warning::resolution::{RESOLVED, RESOLVED_AREA, RESOLVED_LINE};

#[expect(clippy::too_many_lines, reason = "a text for each warning")]
impl std::fmt::Display for Warning {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NoContact => formatter.write_str(
                "no cell carries pressure because the normal force is zero or nothing has been solved yet: prescribe a positive normal force, or an approach above the smallest gap, and solve"
            ),
            Self::ContactAtEdge { cells } => {
                write!(
                    formatter,
                    "the edge of the grid contains {}: use a larger grid",
                    counted(*cells, "contact cell")
                )
            }
            Self::UnresolvedSpots { unresolved, spots } => write!(
                formatter,
                "contact spots of fewer than {RESOLVED} cells ({unresolved} of {}) contain at least a tenth of the contact cells: refine the grid, or filter out the short waves of the surface",
                counted(*spots, "spot")
            ),
            Self::SingleRowOfCells => write!(
                formatter,
                "the grid is a single row of rectangular cells and not periodic, so it does not model a line contact in plane strain: use a row along x with a boundary that is periodic along y"
            ),
            Self::ContactSpansGrid { along_x, along_y } => {
                let axes = axes(*along_x, *along_y);
                write!(
                    formatter,
                    "a contact spot extends across the whole grid along {axes}, which causes pressure peaks at the edges: increase the gap towards the edges, or use a boundary that is periodic along y or along both axes"
                )
            }
            Self::BeyondHardness { cells } => write!(
                formatter,
                "the pressure exceeds the hardness of the softer body in {}: limit the pressure to the hardness",
                counted(*cells, "cell")
            ),
            Self::StalePressure => formatter.write_str(
                "the gap has changed, but the step kept the pressure, which belongs to the old gap: prescribe the normal load again",
            ),
            Self::StressAtEdge => write!(
                formatter,
                "the error of the stress along the surface at the edge of a sheared contact decreases only with the square root of the cell size: use a plane at a depth of at least one cell side"
            ),
            Self::UnderresolvedContact { cells } => write!(
                formatter,
                "the contact has only {}, so that its area and its stick ratio are inaccurate: refine the grid until it has {} (a line of cells: {})",
                counted(*cells, "cell"),
                RESOLVED_AREA[0],
                RESOLVED_LINE[0]
            ),
            Self::UnderresolvedStickZone { cells } => write!(
                formatter,
                "the stick zone has only {}, so that its size is inaccurate: refine the grid until it has {} (a line of cells: {})",
                counted(*cells, "cell"),
                RESOLVED_AREA[1],
                RESOLVED_LINE[1]
            ),
            Self::UnderresolvedSlipZone { tenths: 0 } => formatter.write_str(
                "no cell slips, because the slip zone is narrower than a cell, so that slip and dissipated energy are zero: refine the grid until the zone is two cells wide, or check the unit of a tangential load"
            ),
            Self::UnderresolvedSlipZone { tenths } => write!(
                formatter,
                "the slip zone is only {}.{} cells wide on average, so that slip and dissipated energy are inaccurate: refine the grid until the zone is two cells wide",
                tenths / 10,
                tenths % 10
            ),
            Self::DiscretisationError {
                per_mille, spots, ..
            } if *spots > MANY_SPOTS => write!(
                formatter,
                "the estimated discretisation error of the fields of {spots} contact spots is {}.{} %: for an error of 1 %, resample the surface onto cells {:.1} times smaller, or filter out its short waves",
                per_mille / 10,
                per_mille % 10,
                refinement(1e-3 * *per_mille as f64)
            ),
            Self::DiscretisationError {
                per_mille,
                cells_per_radius,
                ..
            } => write!(
                formatter,
                "the estimated discretisation error of the fields is {}.{} %: for an error of 1 %, use {} on the radius of a contact spot",
                per_mille / 10,
                per_mille % 10,
                counted(*cells_per_radius, "cell")
            ),
            Self::SingleLoadStep => write!(
                formatter,
                "bodies whose pressure moves their surfaces tangentially (of different materials, or coated) were pressed in too few steps, although different cells stick and slip while the load grows: let the history press in steps that it chooses for a tolerance"
            ),
            Self::ApproachBeyondGrid { tenths } => write!(
                formatter,
                "the approach is {}.{} times the side of the grid, expected less than 1: check the units of gap, grid, modulus and load",
                tenths / 10,
                tenths % 10
            ),
            Self::ShiftBeyondGrid { tenths } => write!(
                formatter,
                "the shift or relative displacement of the step or cycle is {}.{} times the side of the grid, expected less than 1: check the units of displacements and grid, or ignore this for a flat counterbody",
                tenths / 10,
                tenths % 10
            ),
            Self::LargeBulkStrain { per_mille } => write!(
                formatter,
                "the bulk strain of the relative displacement is {}.{} %, expected at most 2 %: give a strain of 0.05 % as 0.0005, and check its amount; the model assumes small strains",
                per_mille / 10,
                per_mille % 10
            ),
            Self::LargeTwist { tenths } => write!(
                formatter,
                "the twist of the step or cycle is {}.{} radians, expected at most 0.2: convert a twist in degrees; the model assumes small rotations, except of bodies of revolution",
                tenths / 10,
                tenths % 10
            ),
            Self::LargeCreepage { per_cent } => write!(
                formatter,
                "creepage and spin move the surfaces by {per_cent} % of the length rolled, expected less than 10 %: give a creepage of 1 % as 0.01, and check the unit of the spin; the model assumes small creepages"
            ),
            Self::LargeFriction { tenths } => write!(
                formatter,
                "the largest coefficient of friction is {}, expected at most 5: give 30 % as 0.3, or ignore this warning if the bodies must stick everywhere",
                *tenths as f64 / 10.0
            ),
            Self::LowHardness { parts } => write!(
                formatter,
                "almost all contact cells are at the hardness, and the largest pressure is 1/{parts} of the contact modulus, expected at least 1/{LOWEST_HARDNESS}: check the units of hardness and modulus, or prescribe the normal force"
            ),
            Self::HardnessBeyondModulus { per_mille } => write!(
                formatter,
                "the hardness is {} times the modulus, expected about 0.01, so that it has no effect: check the units of hardness and modulus, or omit the hardness",
                times(*per_mille)
            ),
            Self::LowShearStress { parts } => write!(
                formatter,
                "the largest shear stress lowers the friction capacity to 1/{parts}, expected at least 1/{LOWEST_CAP}: check the units of this stress and of the pressure, or prescribe the tangential force"
            ),
            Self::ShearStressBeyondModulus { per_mille } => write!(
                formatter,
                "the largest shear stress of the friction is {} times the modulus, expected less than 0.01: check the units of stress and modulus, or omit this stress",
                times(*per_mille)
            ),
            Self::LowPressure { parts } => write!(
                formatter,
                "the largest prescribed pressure is 1/{parts} of the contact modulus, expected at least 1/{LOWEST_PRESSURE}: check the units of pressure and modulus"
            ),
            Self::LargeGapChange { tenths } => write!(
                formatter,
                "the gap of contact cells changed by {}.{} times the largest normal displacement of the contacts before and after, expected at most 1: check the unit of the wear coefficient (1 mm3/(N m) is 1e-9 1/Pa), change the gap in more updates, or ignore this for another surface",
                tenths / 10,
                tenths % 10
            ),
            Self::ClosedGap { cells } => write!(
                formatter,
                "the gap before loading is almost closed in {}, like the gap under load of an earlier solution: pass the gap of the unloaded surfaces",
                counted(*cells, "contact cell")
            ),
            Self::NegativeWear { cells } => write!(
                formatter,
                "the gap decreased in {} that have slipped, and increased in none: wear increases the gap, so add its depth, as in gap + depth",
                counted(*cells, "cell")
            ),
            Self::LargeContactRadius { per_mille } => write!(
                formatter,
                "the contact radius is about {:.2} of the radius of curvature, expected at most 0.3: check the units of gap and grid, or lower the load; half-spaces assume small slopes",
                1e-3 * *per_mille as f64
            ),
            Self::PressureBeyondModulus { per_mille } => write!(
                formatter,
                "the largest pressure is {:.2} of the contact modulus, expected at most 0.5: check the units of modulus and load (or prescribed pressure), and multiply a mean pressure by the area of the grid; half-spaces assume small strains",
                1e-3 * *per_mille as f64
            ),
            Self::PeriodicSeam {
                along_x,
                along_y,
                times,
            } => {
                let axes = axes(*along_x, *along_y);
                write!(
                    formatter,
                    "the gap jumps across the border of the grid along {axes} by {times} times the largest mean step between neighbouring cells, expected at most {LARGEST_SEAM}: level the surface, or use a boundary that is not periodic along {axes}"
                )
            }
            Self::NotConverged => formatter.write_str(
                "the solve ended before it converged, so that the solution is its last iterate: check the status in the report, and solve again with a larger limit or tolerance"
            ),
            Self::SteepSurface { per_mille } => write!(
                formatter,
                "the rms slope of the surface at the contact is {:.2}, expected at most 0.5: check the units of heights and grid, or filter out short waves; half-spaces assume small slopes",
                1e-3 * *per_mille as f64
            ),
            Self::HeldShiftLostForce { per_cent } => write!(
                formatter,
                "the tangential force decreased by {per_cent} % under a held shift, expected at most 50 %: to keep the force, prescribe it in each step"
            ),
            Self::UnusedRelativeDisplacement => formatter.write_str(
                "the relative displacement has no effect because its amount is zero: prescribe the amount in each step, for example 1 for the pattern itself, or 0 for a step without it"
            ),
            Self::RepeatedLoop => formatter.write_str(
                "the cycle repeats a closed loop, so that energies and slip distances are sums over several loops: begin the cycle anew before each loop"
            ),
            Self::OpenCycle { per_cent } => write!(
                formatter,
                "the cycle deviates by {per_cent} % from a closed loop, expected at most {LARGEST_RESIDUAL} %, so that energies and slip distances are not those of a steady cycle: begin the cycle anew and repeat the loop until it closes"
            ),
            Self::NeglectedLift { per_million } => write_lift(formatter, *per_million),
            Self::NeglectedTraction { per_cent } => write!(
                formatter,
                "Dundurs' beta is {per_cent} % of the mean coefficient of friction, expected at most {LARGEST_COUPLING} % in the scalar model with one-way coupling, which neglects the tractions across its axis: use the vector model, or full coupling"
            ),
            Self::CoatingBeyondGrid { sides } => write!(
                formatter,
                "a layer is {sides} times as thick as the side of the grid, expected at most {THICKEST_LAYER}, so that the material below it has almost no effect on the contact: check the units of thickness and grid"
            ),
            Self::CoatingBelowCell { parts } => write!(
                formatter,
                "a cell is {parts} times as long as a layer is thick, so that the layer has almost no effect on the contact: check the units of thickness and grid"
            ),
            Self::AccuracyNotReached { tenths } => write_accuracy(formatter, *tenths),
        }
    }
}

/// Returns a ratio in thousandths as a number.
fn times(per_mille: usize) -> String {
    const LARGEST: usize = 1_000_000_000;
    if per_mille < LARGEST {
        format!("{:.2}", 1e-3 * per_mille as f64)
    } else {
        format!("more than {}", LARGEST / 1_000)
    }
}

/// Returns the names of the axes to which a warning applies.
fn axes(along_x: bool, along_y: bool) -> &'static str {
    match (along_x, along_y) {
        (true, false) => "x",
        (false, true) => "y",
        _ => "x and y",
    }
}

/// Writes the warning about the neglected lift.
fn write_lift(formatter: &mut std::fmt::Formatter<'_>, per_million: usize) -> std::fmt::Result {
    write!(
        formatter,
        "tractions displace the surfaces of bodies that couple pressure and traction by {}.{:04} % of the normal displacement, which the pressure neglects: use coupled rolling, or a history with full coupling",
        per_million / 10_000,
        per_million % 10_000
    )
}

/// Writes the warning about the accuracy of an adaptive contact.
fn write_accuracy(formatter: &mut std::fmt::Formatter<'_>, tenths: usize) -> std::fmt::Result {
    if tenths == 0 {
        return formatter.write_str(
            "the refinement ended after the first grid, so that no error is estimated: raise the limit that the status states (cells, time or distance of the samples)",
        );
    }
    write!(
        formatter,
        "the refinement ended at {}.{} times the required error: raise the limit that the status states (cells, time or distance of the samples), or the target",
        tenths / 10,
        tenths % 10
    )
}
