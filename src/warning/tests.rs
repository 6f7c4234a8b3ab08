//! Texts of all warnings.

use crate::error::tests::{Variants, check_texts, variants};
use crate::warning::Warning;

variants! { Warning:
    NoContact ContactAtEdge UnresolvedSpots SingleRowOfCells ContactSpansGrid BeyondHardness StalePressure StressAtEdge
    UnderresolvedContact UnderresolvedStickZone UnderresolvedSlipZone DiscretisationError SingleLoadStep
    ApproachBeyondGrid ShiftBeyondGrid LargeBulkStrain LargeTwist LargeCreepage LargeFriction LowHardness LowShearStress LowPressure LargeGapChange
    HardnessBeyondModulus ShearStressBeyondModulus ClosedGap NegativeWear
    LargeContactRadius PressureBeyondModulus PeriodicSeam
    NotConverged SteepSurface HeldShiftLostForce
    UnusedRelativeDisplacement RepeatedLoop OpenCycle NeglectedLift NeglectedTraction CoatingBeyondGrid
    CoatingBelowCell AccuracyNotReached
}

#[test]
#[expect(clippy::too_many_lines, reason = "a table")]
fn every_warning_has_its_text() {
    check_texts(&[
        (
            Warning::NoContact,
            "no cell carries pressure because the normal force is zero or nothing has been solved yet: prescribe a positive normal force, or an approach above the smallest gap, and solve",
        ),
        (
            Warning::ContactAtEdge { cells: 12 },
            "the edge of the grid contains 12 contact cells: use a larger grid",
        ),
        (
            Warning::ContactAtEdge { cells: 1 },
            "the edge of the grid contains 1 contact cell: use a larger grid",
        ),
        (
            Warning::UnresolvedSpots {
                unresolved: 1,
                spots: 1,
            },
            "contact spots of fewer than 5 cells (1 of 1 spot) contain at least a tenth of the contact cells: refine the grid, or filter out the short waves of the surface",
        ),
        (
            Warning::UnresolvedSpots {
                unresolved: 7,
                spots: 40,
            },
            "contact spots of fewer than 5 cells (7 of 40 spots) contain at least a tenth of the contact cells: refine the grid, or filter out the short waves of the surface",
        ),
        (
            Warning::SingleRowOfCells,
            "the grid is a single row of rectangular cells and not periodic, so it does not model a line contact in plane strain: use a row along x with a boundary that is periodic along y",
        ),
        (
            Warning::ContactSpansGrid {
                along_x: true,
                along_y: false,
            },
            "a contact spot extends across the whole grid along x, which causes pressure peaks at the edges: increase the gap towards the edges, or use a boundary that is periodic along y or along both axes",
        ),
        (
            Warning::ContactSpansGrid {
                along_x: false,
                along_y: true,
            },
            "a contact spot extends across the whole grid along y, which causes pressure peaks at the edges: increase the gap towards the edges, or use a boundary that is periodic along y or along both axes",
        ),
        (
            Warning::ContactSpansGrid {
                along_x: true,
                along_y: true,
            },
            "a contact spot extends across the whole grid along x and y, which causes pressure peaks at the edges: increase the gap towards the edges, or use a boundary that is periodic along y or along both axes",
        ),
        (
            Warning::BeyondHardness { cells: 3 },
            "the pressure exceeds the hardness of the softer body in 3 cells: limit the pressure to the hardness",
        ),
        (
            Warning::StalePressure,
            "the gap has changed, but the step kept the pressure, which belongs to the old gap: prescribe the normal load again",
        ),
        (
            Warning::StressAtEdge,
            "the error of the stress along the surface at the edge of a sheared contact decreases only with the square root of the cell size: use a plane at a depth of at least one cell side",
        ),
        (
            Warning::UnderresolvedContact { cells: 80 },
            "the contact has only 80 cells, so that its area and its stick ratio are inaccurate: refine the grid until it has 100 (a line of cells: 20)",
        ),
        (
            Warning::UnderresolvedStickZone { cells: 30 },
            "the stick zone has only 30 cells, so that its size is inaccurate: refine the grid until it has 50 (a line of cells: 10)",
        ),
        (
            Warning::UnderresolvedSlipZone { tenths: 14 },
            "the slip zone is only 1.4 cells wide on average, so that slip and dissipated energy are inaccurate: refine the grid until the zone is two cells wide",
        ),
        (
            Warning::UnderresolvedSlipZone { tenths: 0 },
            "no cell slips, because the slip zone is narrower than a cell, so that slip and dissipated energy are zero: refine the grid until the zone is two cells wide, or check the unit of a tangential load",
        ),
        (
            Warning::DiscretisationError {
                per_mille: 80,
                cells_per_radius: 40,
                spots: 11,
            },
            "the estimated discretisation error of the fields of 11 contact spots is 8.0 %: for an error of 1 %, resample the surface onto cells 4.0 times smaller, or filter out its short waves",
        ),
        (
            Warning::DiscretisationError {
                per_mille: 82,
                cells_per_radius: 40,
                spots: 10,
            },
            "the estimated discretisation error of the fields is 8.2 %: for an error of 1 %, use 40 cells on the radius of a contact spot",
        ),
        (
            Warning::SingleLoadStep,
            "bodies whose pressure moves their surfaces tangentially (of different materials, or coated) were pressed in too few steps, although different cells stick and slip while the load grows: let the history press in steps that it chooses for a tolerance",
        ),
        (
            Warning::ApproachBeyondGrid { tenths: 15 },
            "the approach is 1.5 times the side of the grid, expected less than 1: check the units of gap, grid, modulus and load",
        ),
        (
            Warning::ShiftBeyondGrid { tenths: 25 },
            "the shift or relative displacement of the step or cycle is 2.5 times the side of the grid, expected less than 1: check the units of displacements and grid, or ignore this for a flat counterbody",
        ),
        (
            Warning::LargeBulkStrain { per_mille: 52 },
            "the bulk strain of the relative displacement is 5.2 %, expected at most 2 %: give a strain of 0.05 % as 0.0005, and check its amount; the model assumes small strains",
        ),
        (
            Warning::LargeTwist { tenths: 20 },
            "the twist of the step or cycle is 2.0 radians, expected at most 0.2: convert a twist in degrees; the model assumes small rotations, except of bodies of revolution",
        ),
        (
            Warning::LargeCreepage { per_cent: 50 },
            "creepage and spin move the surfaces by 50 % of the length rolled, expected less than 10 %: give a creepage of 1 % as 0.01, and check the unit of the spin; the model assumes small creepages",
        ),
        (
            Warning::LargeFriction { tenths: 300 },
            "the largest coefficient of friction is 30, expected at most 5: give 30 % as 0.3, or ignore this warning if the bodies must stick everywhere",
        ),
        (
            Warning::LargeFriction { tenths: 63 },
            "the largest coefficient of friction is 6.3, expected at most 5: give 30 % as 0.3, or ignore this warning if the bodies must stick everywhere",
        ),
        (
            Warning::LowHardness { parts: 115_000_000 },
            "almost all contact cells are at the hardness, and the largest pressure is 1/115000000 of the contact modulus, expected at least 1/10000: check the units of hardness and modulus, or prescribe the normal force",
        ),
        (
            Warning::HardnessBeyondModulus { per_mille: 12_340 },
            "the hardness is 12.34 times the modulus, expected about 0.01, so that it has no effect: check the units of hardness and modulus, or omit the hardness",
        ),
        (
            Warning::ShearStressBeyondModulus {
                per_mille: 4_350_000,
            },
            "the largest shear stress of the friction is 4350.00 times the modulus, expected less than 0.01: check the units of stress and modulus, or omit this stress",
        ),
        (
            Warning::LowShearStress { parts: 650_000 },
            "the largest shear stress lowers the friction capacity to 1/650000, expected at least 1/100: check the units of this stress and of the pressure, or prescribe the tangential force",
        ),
        (
            Warning::LowPressure { parts: 231_000_000 },
            "the largest prescribed pressure is 1/231000000 of the contact modulus, expected at least 1/10000000: check the units of pressure and modulus",
        ),
        (
            Warning::OpenCycle { per_cent: 71 },
            "the cycle deviates by 71 % from a closed loop, expected at most 10 %, so that energies and slip distances are not those of a steady cycle: begin the cycle anew and repeat the loop until it closes",
        ),
        (
            Warning::LargeGapChange { tenths: 125 },
            "the gap of contact cells changed by 12.5 times the largest normal displacement of the contacts before and after, expected at most 1: check the unit of the wear coefficient (1 mm3/(N m) is 1e-9 1/Pa), change the gap in more updates, or ignore this for another surface",
        ),
        (
            Warning::ClosedGap { cells: 480 },
            "the gap before loading is almost closed in 480 contact cells, like the gap under load of an earlier solution: pass the gap of the unloaded surfaces",
        ),
        (
            Warning::NegativeWear { cells: 812 },
            "the gap decreased in 812 cells that have slipped, and increased in none: wear increases the gap, so add its depth, as in gap + depth",
        ),
        (
            Warning::LargeContactRadius { per_mille: 350 },
            "the contact radius is about 0.35 of the radius of curvature, expected at most 0.3: check the units of gap and grid, or lower the load; half-spaces assume small slopes",
        ),
        (
            Warning::PressureBeyondModulus { per_mille: 750 },
            "the largest pressure is 0.75 of the contact modulus, expected at most 0.5: check the units of modulus and load (or prescribed pressure), and multiply a mean pressure by the area of the grid; half-spaces assume small strains",
        ),
        (
            Warning::PeriodicSeam {
                along_x: true,
                along_y: false,
                times: 31,
            },
            "the gap jumps across the border of the grid along x by 31 times the largest mean step between neighbouring cells, expected at most 5: level the surface, or use a boundary that is not periodic along x",
        ),
        (
            Warning::NotConverged,
            "the solve ended before it converged, so that the solution is its last iterate: check the status in the report, and solve again with a larger limit or tolerance",
        ),
        (
            Warning::SteepSurface { per_mille: 750 },
            "the rms slope of the surface at the contact is 0.75, expected at most 0.5: check the units of heights and grid, or filter out short waves; half-spaces assume small slopes",
        ),
        (
            Warning::HeldShiftLostForce { per_cent: 60 },
            "the tangential force decreased by 60 % under a held shift, expected at most 50 %: to keep the force, prescribe it in each step",
        ),
        (
            Warning::UnusedRelativeDisplacement,
            "the relative displacement has no effect because its amount is zero: prescribe the amount in each step, for example 1 for the pattern itself, or 0 for a step without it",
        ),
        (
            Warning::RepeatedLoop,
            "the cycle repeats a closed loop, so that energies and slip distances are sums over several loops: begin the cycle anew before each loop",
        ),
        (
            Warning::NeglectedLift {
                per_million: 10_500,
            },
            "tractions displace the surfaces of bodies that couple pressure and traction by 1.0500 % of the normal displacement, which the pressure neglects: use coupled rolling, or a history with full coupling",
        ),
        (
            Warning::NeglectedTraction { per_cent: 73 },
            "Dundurs' beta is 73 % of the mean coefficient of friction, expected at most 50 % in the scalar model with one-way coupling, which neglects the tractions across its axis: use the vector model, or full coupling",
        ),
        (
            Warning::CoatingBeyondGrid { sides: 1000 },
            "a layer is 1000 times as thick as the side of the grid, expected at most 10, so that the material below it has almost no effect on the contact: check the units of thickness and grid",
        ),
        (
            Warning::CoatingBelowCell { parts: 1_000_000 },
            "a cell is 1000000 times as long as a layer is thick, so that the layer has almost no effect on the contact: check the units of thickness and grid",
        ),
        (
            Warning::AccuracyNotReached { tenths: 35 },
            "the refinement ended at 3.5 times the required error: raise the limit that the status states (cells, time or distance of the samples), or the target",
        ),
    ]);
}
