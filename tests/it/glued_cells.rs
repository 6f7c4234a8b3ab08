//! Coefficients of friction so large that cells stick under any load.

use kit::unit_bodies;
use stickslip::rolling::RollingProblem;
use stickslip::{
    Field, Friction, HalfSpace, NormalLoad, NormalProblem, NormalSolution, TangentialLoad,
    TangentialModel, TangentialProblem, Zone,
};

/// Coefficients of the glued cells. A coefficient of 100 already prevents slip.
const COEFFICIENTS: [f64; 6] = [100.0, 1e20, 1e28, 1e32, 1e100, 1e290];
const TOLERANCE: f64 = 1e-9;

fn ball() -> (HalfSpace, NormalSolution) {
    let bodies = unit_bodies(kit::square(24, 3.0), 0.3);
    let gap = kit::sphere(bodies.grid(), 1.0);
    let normal = kit::solve(NormalProblem::builder(&bodies, gap, NormalLoad::Force(0.6)));
    (bodies, normal)
}

/// Returns the coefficient 0.5 in all cells except a disc that does not contain the centre.
fn glued(bodies: &HalfSpace, coefficient: f64) -> Friction {
    let is_glued = |x: f64, y: f64| (x - 0.2).hypot(y) < 0.2;
    let of = |x, y| if is_glued(x, y) { coefficient } else { 0.5 };
    Friction::per_cell(Field::from_fn(bodies.grid(), of)).unwrap()
}

/// Compares tractions with the tractions of the smallest coefficient, in parts of the largest.
fn compare(found: [&Field; 2], expected: [&Field; 2], coefficient: f64) {
    let largest = expected[0].max();
    for (found, expected) in found.into_iter().zip(expected) {
        for (found, expected) in found.as_slice().iter().zip(expected.as_slice()) {
            let difference = (found - expected).abs() / largest;
            assert!(difference < 1e-6, "{coefficient:e}: {difference:e}");
        }
    }
}

#[test]
fn tractions_are_independent_of_the_coefficient_of_glued_cells() {
    let (bodies, normal) = ball();
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let force = TangentialLoad::force([0.2, 0.0]);
        for load in [force, TangentialLoad::shift([0.3, 0.0])] {
            let solutions = COEFFICIENTS.map(|coefficient| {
                let friction = glued(&bodies, coefficient);
                let problem = TangentialProblem::builder(&bodies, &normal, friction, load);
                kit::solve(problem.model(model).tolerance(TOLERANCE))
            });
            for (found, coefficient) in solutions.iter().zip(COEFFICIENTS) {
                assert_eq!(found.zones(), solutions[0].zones());
                compare(found.traction(), solutions[0].traction(), coefficient);
            }
        }
    }
}

#[test]
fn rolling_is_independent_of_the_coefficient_of_glued_cells() {
    let (bodies, normal) = ball();
    let solutions = COEFFICIENTS.map(|coefficient| {
        let friction = glued(&bodies, coefficient);
        let problem = RollingProblem::builder(&bodies, &normal, friction);
        kit::solve(problem.creepage([0.05, 0.0]).tolerance(TOLERANCE))
    });
    for (found, coefficient) in solutions.iter().zip(COEFFICIENTS) {
        compare(found.traction(), solutions[0].traction(), coefficient);
    }
}

/// The pressure of a cell exceeds the other pressures by many decades.
#[test]
fn cells_next_to_a_glued_cell_slip_at_their_limit() {
    let bodies = unit_bodies(kit::square(16, 100.0), 0.3);
    let solve = |pressure: f64| {
        let mut pressures = Field::constant(bodies.grid(), 1.0);
        pressures.as_mut_slice()[100] = pressure;
        let load = TangentialLoad::shift([200.0, 0.0]);
        kit::solve(
            TangentialProblem::builder(&bodies, &pressures, kit::coulomb(0.7), load)
                .tolerance(TOLERANCE),
        )
    };
    let expected = solve(1e6);
    assert!([Zone::Slip, Zone::Stick].map(|zone| expected.zones().contains(&zone)) == [true; 2]);
    for pressure in [1e10, 1e28, 1e32, 1e60] {
        let found = solve(pressure);
        assert_eq!(found.zones(), expected.zones());
        compare(found.traction(), expected.traction(), pressure);
    }
}
