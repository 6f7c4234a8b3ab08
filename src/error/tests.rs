//! Texts of all errors.

use std::fmt::Display;

use crate::error::{
    Error, Place, ROLL, ROLL_UNDER_CAP, RankFailure, SLIDE, SLIDE_UNDER_CAP, with_remedy,
};
use crate::report::{Report, Status};

/// Enumeration whose variants are listed here. The `match` has no wildcard, so a new variant must be added to the list.
pub(crate) trait Variants: Display {
    const ALL: &'static [&'static str];

    fn variant(&self) -> &'static str;
}

macro_rules! variants {
    ($name:ident: $($variant:ident)+) => {
        impl Variants for $name {
            const ALL: &'static [&'static str] = &[$(stringify!($variant)),+];

            fn variant(&self) -> &'static str {
                match self {
                    $(Self::$variant { .. } => stringify!($variant),)+
                }
            }
        }
    };
}

pub(crate) use variants;

variants! { Error:
    GridSize Memory NotPositive NegativeOrNotFinite NotFinite ExtremeNumber Sample PoissonRatio BothRigid TooManyLayers
    UnsupportedForCoatings IncompleteKernel NotDefinite DatumTooNear RigidBody DivergentPeriodicSum CoupledMaterials
    CellsTooLong Length GridMismatch BoundaryMismatch CellValueMismatch Tolerance IterationLimit NoPressureToHold Method
    Bounds Total RepeatedDirection EmptyContact BeyondFrictionCapacity BeyondFrictionMoment BeyondHardness Yielded
    ObliqueLoad UnsupportedByModel MaterialMismatch ApproachBeyondMeanGap TooManyCells NotPositiveDefinite Undetermined
    Degree Range BeyondSamples Hurst BelowMinimum GridTooShort NoWaveInBand HeightMomentsNotReached File Format
    StepsPerCycle EmptyPath StepOutOfOrder NoLastStep GapUnderLoad OutdatedSolution CycleNotClosed StepTooLong Ranks NotConverged
}

/// Returns whether a text contains the name of an item of one language. The messages are the same in all languages.
fn names_an_item(text: &str) -> bool {
    let is_joint =
        |part: &[u8]| part[1] == b'_' && [part[0], part[2]].iter().all(u8::is_ascii_lowercase);
    text.contains("::") || text.contains('`') || text.as_bytes().windows(3).any(is_joint)
}

/// Checks the texts of the examples, and that every variant has an example.
#[track_caller]
pub(crate) fn check_texts<T: Variants>(examples: &[(T, &str)]) {
    for (value, text) in examples {
        assert_eq!(value.to_string(), *text);
        assert!(!names_an_item(text), "{text}");
    }
    for variant in T::ALL {
        let has_example = examples
            .iter()
            .any(|(value, _)| value.variant() == *variant);
        assert!(has_example, "{variant} has no example");
    }
}

#[test]
#[expect(clippy::too_many_lines, reason = "a table")]
fn every_error_has_its_text() {
    check_texts(&[
        (
            Error::GridSize { nx: 0, ny: 4 },
            "the grid must have at least one cell along each axis, got 0 x 4 cells",
        ),
        (
            Error::Memory {
                quantity: "a padded grid",
                bytes: 128_000_000_000,
            },
            "cannot allocate 119.2 GiB for a padded grid",
        ),
        (
            Error::NotPositive {
                quantity: "load",
                value: 0.0,
            },
            "load must be positive and finite, got 0.0",
        ),
        (
            Error::NegativeOrNotFinite {
                quantity: "coefficient of friction",
                value: -0.5,
            },
            "coefficient of friction must be non-negative and finite, got -0.5",
        ),
        (
            Error::NotFinite {
                quantity: "approach",
                value: f64::NAN,
            },
            "approach must be finite, got NaN",
        ),
        (
            Error::ExtremeNumber {
                quantity: "the pressure due to the normal load",
                value: 1e-140,
                least: 1e-130,
                most: 1e130,
                remedy: "choose different units of length or pressure, or a zero load",
            },
            "the pressure due to the normal load must lie between 1e-130 and 1e130 so that its squares do not overflow or underflow, got 1e-140: choose different units of length or pressure, or a zero load",
        ),
        (
            Error::Sample {
                quantity: "height",
                index: 7,
                value: f64::NAN,
                rule: "must be finite; fill missing heights first",
            },
            "height at index 7 is NaN, but must be finite; fill missing heights first",
        ),
        (
            Error::PoissonRatio(0.7),
            "Poisson's ratio must lie in (-1, 0.5], got 0.7",
        ),
        (
            Error::BothRigid,
            "both bodies are rigid: give at least one body a finite Young's modulus",
        ),
        (
            Error::TooManyLayers { found: 9, limit: 8 },
            "a coated body must have at most 8 layers, got 9: combine thin layers",
        ),
        (
            Error::UnsupportedForCoatings {
                quantity: "a closed form with one modulus",
                bodies: "coated bodies",
                remedy: "solve the contact on a grid",
            },
            "a closed form with one modulus is not available for coated bodies: solve the contact on a grid",
        ),
        (
            Error::IncompleteKernel("give at least one operator"),
            "the kernel is missing or incomplete: give at least one operator",
        ),
        (
            Error::NotDefinite {
                eigenvalue: -2e-9,
                sides: [0.5, 0.25],
            },
            "the smallest eigenvalue of the compliance must be positive, got -2e-9 on cells of sides [0.5, 0.25]: use a grid that is smaller relative to the layer thickness, a periodic grid, or a kernel of positive energy",
        ),
        (
            Error::DatumTooNear {
                datum: 2.0,
                least: 3.5,
            },
            "the datum distance 2.0 makes the compliance indefinite, so that a prescribed approach, shift or spring has no unique solution: prescribe the force, or use a distance above 3.5",
        ),
        (
            Error::RigidBody("body 2"),
            "body 2 is rigid, so its stress is undetermined: request the stress of an elastic body or layer",
        ),
        (
            Error::DivergentPeriodicSum("the sum over loaded cells"),
            "the sum over loaded cells does not converge on a grid that is periodic along both axes: compute the stress on planes instead",
        ),
        (
            Error::CoupledMaterials { beta: 0.25 },
            "the materials couple pressure and traction (Dundurs' beta = 0.25), which this model neglects: use a coupled problem or a history with full coupling, or accept the error of one-way or neglected coupling",
        ),
        (
            Error::CellsTooLong { sides: [1e9, 1.0] },
            "cells of sides [1000000000.0, 1.0] are too elongated for double precision to resolve the compliance of short waves: use cells of a smaller aspect ratio",
        ),
        (
            Error::Length {
                quantity: "matrix",
                expected: 9,
                found: 8,
            },
            "matrix has 8 entries, expected 9",
        ),
        (
            Error::GridMismatch {
                quantity: "gap",
                expected_cells: [4, 2],
                expected_sides: [0.5, 0.25],
                found_cells: [4, 3],
                found_sides: [0.5, 0.5],
            },
            "gap is on a grid of [4, 3] cells of sides [0.5, 0.5], expected [4, 2] cells of sides [0.5, 0.25]",
        ),
        (
            Error::BoundaryMismatch {
                quantity: "normal solution",
            },
            "normal solution belongs to bodies with a different boundary: use the bodies for which it was computed",
        ),
        (
            Error::CellValueMismatch {
                quantity: "normal solution",
            },
            "normal solution belongs to bodies with a different interpretation of cell values: use the bodies for which it was computed",
        ),
        (
            Error::Tolerance(2.0),
            "the tolerance must lie strictly between 0 and 1, got 2.0",
        ),
        (
            Error::IterationLimit,
            "the iteration limit must be at least 1, got 0",
        ),
        (
            Error::NoPressureToHold,
            "a normal contact has no earlier pressure to hold, only a history has one: prescribe a normal force or an approach",
        ),
        (
            Error::Method {
                method: "Polonsky-Keer",
                quantity: "springs",
            },
            "the Polonsky-Keer method does not support springs: use the active-set method",
        ),
        (
            Error::Bounds {
                index: 3,
                lower: 2.0,
                upper: 1.0,
            },
            "the bounds [2.0, 1.0] of entry 3 contain no finite value: give a lower bound that does not exceed the upper bound",
        ),
        (
            Error::Total {
                total: 5.0,
                lower: 0.0,
                upper: 4.0,
            },
            "the total 5.0 is outside the range [0.0, 4.0] allowed by the bounds: prescribe a total in this range, or widen the bounds",
        ),
        (
            Error::RepeatedDirection,
            "an operator has the same direction twice: give each of its directions once",
        ),
        (
            Error::EmptyContact,
            "the contact is empty because no cell carries pressure: first prescribe a positive normal force, or an approach above the smallest gap",
        ),
        (
            Error::BeyondFrictionCapacity {
                force: 3.0,
                limit: 2.5,
                remedy: SLIDE,
            },
            "the tangential force 3.0 exceeds the friction limit 2.5: prescribe a shift or a spring to let the body slide",
        ),
        (
            Error::BeyondFrictionCapacity {
                force: 18.0,
                limit: 18.000_000_000_000_004,
                remedy: ROLL,
            },
            "the tangential force 18.0 reaches the friction limit 18.000000000000004: prescribe the creepage, or lower the force",
        ),
        (
            Error::BeyondFrictionCapacity {
                force: 3.0,
                limit: 0.0,
                remedy: SLIDE,
            },
            "the tangential force 3.0 exceeds the friction limit 0.0: give a positive coefficient of friction",
        ),
        (
            Error::BeyondFrictionCapacity {
                force: 100.0,
                limit: 1.0,
                remedy: SLIDE,
            },
            "the tangential force 100.0 exceeds the friction limit 1.0: prescribe a shift or a spring to let the body slide",
        ),
        (
            Error::BeyondFrictionCapacity {
                force: 101.0,
                limit: 1.0,
                remedy: SLIDE,
            },
            "the tangential force 101.0 exceeds the friction limit 1.0: prescribe a shift or a spring to let the body slide, or check the units of force and pressure",
        ),
        (
            Error::BeyondFrictionCapacity {
                force: 3.0,
                limit: 1e-6,
                remedy: SLIDE_UNDER_CAP,
            },
            "the tangential force 3.0 exceeds the friction limit 1e-6: check the unit of the largest shear stress, or prescribe a shift or a spring to let the body slide",
        ),
        (
            with_remedy(
                Error::BeyondFrictionCapacity {
                    force: 3.0,
                    limit: 1e-6,
                    remedy: SLIDE_UNDER_CAP,
                },
                ROLL_UNDER_CAP,
            ),
            "the tangential force 3.0 exceeds the friction limit 1e-6: check the unit of the largest shear stress, or prescribe the creepage, or lower the force",
        ),
        (
            Error::BeyondFrictionMoment {
                moment: 0.5,
                limit: 0.25,
                range: [-0.25, 0.25],
            },
            "the moment 0.5 reaches or exceeds the friction limit 0.25 for the prescribed creepages and forces: prescribe a moment between -0.25 and 0.25, or the spin",
        ),
        (
            Error::BeyondHardness {
                force: 2e9,
                capacity: 3e-8,
            },
            "the normal force 2000000000.0 exceeds 3e-8, the largest force that the cells can carry at their hardness: check the unit of the hardness, use a larger grid, or prescribe an approach",
        ),
        (
            Error::Yielded {
                quantity: "the superposition",
                cells: 12,
            },
            "the superposition requires an elastic contact, but 12 cells reached the hardness: lower the load, or raise the hardness",
        ),
        (
            Error::ObliqueLoad { x: 1.0, y: 2.0 },
            "the tangential load [1.0, 2.0] has two components, but the scalar model requires one of them to be zero: use the vector model",
        ),
        (
            Error::UnsupportedByModel {
                model: "the model of this contact",
                quantity: "twist",
                value: 0.25,
                remedy: "use the vector model",
            },
            "the model of this contact does not support twist, got 0.25: use the vector model",
        ),
        (
            Error::UnsupportedByModel {
                model: "a normal contact",
                quantity: "a functional of tractions",
                value: 0.0,
                remedy: "use the solver of a tangential contact",
            },
            "a normal contact does not support a functional of tractions: use the solver of a tangential contact",
        ),
        (
            Error::MaterialMismatch {
                quantity: "normal solution",
            },
            "normal solution belongs to bodies of other materials: use the bodies for which it was computed",
        ),
        (
            Error::ApproachBeyondMeanGap {
                approach: 0.5,
                mean_gap: 0.25,
            },
            "the approach 0.5 closes the gap of a periodic contact everywhere, so that the pressure is undetermined: prescribe an approach below the mean gap 0.25, or a normal force",
        ),
        (
            Error::TooManyCells {
                cells: 5000,
                limit: 4096,
            },
            "an explicit matrix of 5000 cells exceeds the limit of 4096 cells: use a smaller grid",
        ),
        (
            Error::NotPositiveDefinite { row: 2 },
            "the matrix must be symmetric positive definite, but its factorisation fails at row 2: check its symmetry and its sign in this row",
        ),
        (
            Error::Undetermined {
                quantity: "form",
                unknowns: 6,
                known: 4,
            },
            "the form has 6 unknowns, but there are only 4 known points: provide more known points",
        ),
        (
            Error::Undetermined {
                quantity: "surface",
                unknowns: 256,
                known: 0,
            },
            "the surface has 256 unknowns, but all points are missing (NaN): check the source of the data, and provide known points",
        ),
        (
            Error::Degree {
                degree: 13,
                limit: 12,
            },
            "the degree of the polynomial must be at most 12, got 13",
        ),
        (
            Error::Range {
                quantity: "rows",
                start: 3,
                end: 9,
                count: 8,
            },
            "the range 3..9 of rows is empty or extends beyond the 8 rows of the grid: give a first index below the end, and an end of at most 8",
        ),
        (
            Error::BeyondSamples {
                axis: "x",
                reach: 1.5,
                limit: 1.25,
            },
            "a position at 1.5 along x lies outside the samples, which extend to 1.25 on both sides of their centre: use a smaller grid or region, or more samples",
        ),
        (
            Error::Hurst(1.5),
            "the Hurst exponent must lie in [0, 1], got 1.5",
        ),
        (
            Error::BelowMinimum {
                quantity: "kurtosis",
                value: 0.5,
                least_is: "the squared skewness plus one",
                least: 1.0,
            },
            "kurtosis must be at least 1.0 (the squared skewness plus one), got 0.5",
        ),
        (
            Error::GridTooShort {
                side: "ahead of",
                needed: 3,
                found: 1,
            },
            "a rolling step requires 3 cells ahead of the contact, but the grid has 1: extend the grid there by at least 2 cells",
        ),
        (
            Error::GridTooShort {
                side: "behind",
                needed: 1,
                found: 0,
            },
            "a rolling step requires 1 cell behind the contact, but the grid has 0: extend the grid there by at least 1 cell",
        ),
        (
            Error::Length {
                quantity: "matrix",
                expected: 9,
                found: 1,
            },
            "matrix has 1 entry, expected 9",
        ),
        (
            Error::NoWaveInBand {
                longest: 0.5,
                shortest: 0.25,
            },
            "no periodic wave of the surface has a wavelength between 0.25 and 0.5: widen the range of wavelengths, or use a larger grid",
        ),
        (
            Error::HeightMomentsNotReached {
                skewness: 1.0,
                kurtosis: 2.5,
                reached: [0.5, 3.0],
            },
            "no surface of this spectrum was found with a skewness of 1.0 and a kurtosis of 2.5: request values nearer to 0.5 and 3.0, at which the search ended",
        ),
        (
            Error::File {
                path: "a.npy".into(),
                source: std::io::Error::from_raw_os_error(2).into(),
            },
            "a.npy: No such file or directory (os error 2)",
        ),
        (
            Error::Format {
                file: Some("a.npy".into()),
                format: "NPY",
                place: Place::Byte(6),
                problem: "version 4.0 is not supported".into(),
            },
            "a.npy: NPY, at byte 6: version 4.0 is not supported",
        ),
        (
            Error::Format {
                file: None,
                format: "CSV",
                place: Place::Line(2),
                problem: "\"x\" is not a number".into(),
            },
            "CSV, on line 2: \"x\" is not a number",
        ),
        (
            Error::Format {
                file: None,
                format: "ASC",
                place: Place::Entry("z-unit".into()),
                problem: "\"ft\" is not a known unit of length".into(),
            },
            "ASC, in z-unit: \"ft\" is not a known unit of length",
        ),
        (
            Error::StepsPerCycle(6),
            "the number of steps per cycle must be a positive multiple of 4, got 6",
        ),
        (
            Error::EmptyPath,
            "the load path or cycle has no steps: at least one step is needed",
        ),
        (
            Error::StepOutOfOrder { step: 3, last: 5 },
            "step 3 of the history does not follow step 5, the last step of the cycle: add every step of one history once, in order, after it is accepted",
        ),
        (
            Error::StepOutOfOrder { step: 6, last: 5 },
            "step 6 did not start from the state after step 5, with which the cycle ends: add steps of one history only, and begin the cycle anew after a change of the state",
        ),
        (
            Error::NoLastStep,
            "the history has no last step, because it took no step since it was created or its state was set or restored: make a step first",
        ),
        (
            Error::GapUnderLoad,
            "the gap is the gap under load of the last solution, which contains the displacements: give the gap before loading, which is the last given gap plus the depth of wear",
        ),
        (
            Error::OutdatedSolution {
                quantity: "stiffness",
                changed: "the friction",
                remedy: "solve again first",
            },
            "the friction changed since the last solution, to which the stiffness belongs: solve again first",
        ),
        (
            Error::CycleNotClosed {
                residual: 0.5,
                limit: 0.25,
            },
            "the residual of the cycle (relative to its amplitude) is 0.5, but must be at most 0.25 for a jump: compute another cycle on this gap first, or raise the limit",
        ),
        (
            Error::StepTooLong {
                part: 0.001,
                error: 0.02,
                tolerance: 0.01,
            },
            "the shortest permitted step (0.001 of the load) has an error of 0.02, which exceeds its share of the tolerance 0.01: raise this tolerance, or lower the tolerance of the history",
        ),
        (
            Error::Ranks(RankFailure::MissingSlab { row: 3 }),
            "no slab contains row 3: give the slabs of all ranks",
        ),
        (
            Error::NotConverged(Box::new(Report {
                status: Status::IterationLimit,
                iterations: 3,
                residual: 0.25,
                ..Report::unsolved()
            })),
            "the calculation has not converged: stopped at the iteration limit in 3 iterations, 0 + 0 convolutions (double + single), 0.000 s: residual 2.5e-1, energy error not bounded, load error 0.0e0",
        ),
    ]);
}
