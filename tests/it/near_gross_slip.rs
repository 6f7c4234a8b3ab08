//! The vector model solves for forces that differ from the sliding force only in the last digits.

use kit::unit_bodies;
use stickslip::{
    Field, Friction, Grid, HalfSpace, NormalControl, NormalProblem, NormalSolution, TangentialLoad,
    TangentialModel, TangentialProblem, TangentialSolution, Zone, surface,
};

const FRICTION: f64 = 0.5;
const DIRECTION: [f64; 2] = [0.8, 0.6];

fn press_ball(cells: usize, poisson_ratio: f64) -> (HalfSpace, NormalSolution) {
    let bodies = unit_bodies(Grid::square(cells, 3.0).unwrap(), poisson_ratio);
    let gap = surface::sphere(bodies.grid(), 1.0).unwrap();
    let problem = NormalProblem::builder(&bodies, &gap, NormalControl::Force(0.6));
    let normal = problem.build().unwrap().solve().unwrap();
    (bodies, normal)
}

/// Solves for the sliding force reduced by the fraction `missing`.
fn shear(bodies: &HalfSpace, normal: &NormalSolution, missing: f64) -> TangentialSolution {
    let force = (1.0 - missing) * FRICTION * normal.force();
    let load = TangentialLoad::force(DIRECTION.map(|n| n * force));
    let friction = Friction::coulomb(FRICTION).unwrap();
    TangentialProblem::builder(bodies, normal, friction, load)
        .model(TangentialModel::Vector)
        .build()
        .unwrap()
        .solve()
        .unwrap()
}

/// All cells slip, each in a direction at an angle of order `theta` to the force. The force is then smaller than the
/// sliding force by the fraction `theta^2 / 2`. Since the displacements turn the slip of each cell, the shift beyond
/// the displacement is proportional to `1 / theta`.
#[test]
fn shift_grows_with_inverse_root_of_remaining_force() {
    for (cells, poisson_ratio) in [(5, 0.3), (9, 0.5), (16, 0.3), (32, 0.5), (64, 0.3)] {
        let (bodies, normal) = press_ball(cells, poisson_ratio);
        let limit = FRICTION * normal.force();
        let mut shifts = Vec::new();
        for missing in [1e-4, 1e-5, 1e-6, 1e-7] {
            let solution = shear(&bodies, &normal, missing);
            assert!(solution.is_gross_slip());
            for (found, n) in solution.force().into_iter().zip(DIRECTION) {
                let asked = (1.0 - missing) * limit * n;
                assert!((found - asked).abs() <= 2e-12 * limit);
            }
            let shift = solution.shift();
            shifts.push(shift[0] * DIRECTION[0] + shift[1] * DIRECTION[1]);
        }
        let gains: Vec<f64> = shifts.windows(2).map(|pair| pair[1] - pair[0]).collect();
        for pair in gains.windows(2) {
            let growth = pair[1] / pair[0];
            assert!(
                (growth / 10_f64.sqrt() - 1.0).abs() < 0.02,
                "{cells} cells: {shifts:?}"
            );
        }
    }
}

/// Close to the sliding force some cells stick only if no displacement rotates the direction of slip. This requires
/// a Poisson's ratio of zero.
#[test]
fn zero_poisson_ratio_keeps_a_stick_cell_until_sliding() {
    let (bodies, normal) = press_ball(16, 0.0);
    for missing in [1e-4, 1e-7, 1e-10] {
        let solution = shear(&bodies, &normal, missing);
        assert!(solution.zones().contains(&Zone::Stick));
    }
}

/// The sum of many equal limits depends on the order of summation, so the engine must accept exactly the reported
/// limit.
#[test]
fn reported_friction_capacity_causes_gross_slip() {
    let grid = Grid::square(330, 1.0).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let pressure = Field::constant(grid, 0.1);
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        let problem = |force| {
            let load = TangentialLoad::force([force, 0.0]);
            let friction = Friction::coulomb(0.7).unwrap();
            let problem = TangentialProblem::builder(&bodies, &pressure, friction, load);
            problem.model(lateral).build().unwrap()
        };
        let limit = problem(0.0).friction_capacity();
        let solution = problem(limit).solve().unwrap();
        assert!(solution.is_gross_slip());
    }
}

/// The squares of some friction limits underflow compared with the squares of the others.
#[test]
fn negligible_pressures_converge() {
    let grid = Grid::square(48, 100.0).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let bowl = |x: f64, y: f64| 1.0 - (x * x + y * y) / 900.0;
    let pressure = Field::from_fn(grid, |x, y| bowl(x, y).max(1e-200));
    let friction = Friction::coulomb(0.7).unwrap();
    let load = TangentialLoad::force([0.3 * pressure.integral(), 0.0]);
    let problem = TangentialProblem::builder(&bodies, &pressure, friction, load);
    let solution = problem
        .model(TangentialModel::Vector)
        .build()
        .unwrap()
        .solve();
    assert!(solution.unwrap().report().is_converged());
}
