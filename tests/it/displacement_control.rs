//! If the displacement caused by a force is prescribed, the solve reproduces the force and the fields. On a periodic
//! grid, the certified error is relative to the solution for the computed force.

use kit::{energy_difference, l2_difference, rough, unit_bodies, unit_pair};
use stickslip::influence::Component;
use stickslip::{
    Boundary, Friction, Grid, HalfSpace, NormalLoad, NormalProblem, TangentialLoad,
    TangentialProblem, surface,
};

#[test]
fn approach_and_shift_reproduce_the_forces() {
    let grid = Grid::new(96, 80, 1.0, 1.2).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    for gap in [
        surface::ellipsoid(grid, 200.0, 500.0).unwrap(),
        rough(grid, 3),
    ] {
        let press = |load| {
            let builder = NormalProblem::builder(&bodies, &gap, load).tolerance(1e-12);
            kit::solve(builder)
        };
        let by_force = press(NormalLoad::Force(30.0));
        let by_approach = press(NormalLoad::Approach(by_force.approach()));
        assert!((by_approach.force() / 30.0 - 1.0).abs() < 1e-8);
        assert_eq!(by_approach.approach(), by_force.approach());
        assert!(
            l2_difference(
                by_approach.pressure().as_slice(),
                by_force.pressure().as_slice()
            ) < 1e-8
        );
        assert!(
            kit::max_difference(by_approach.gap().as_slice(), by_force.gap().as_slice())
                < 1e-8 * by_force.approach()
        );

        let friction = Friction::coulomb(0.6).unwrap();
        let shear = |load| {
            let builder = TangentialProblem::builder(&bodies, &by_force, friction.clone(), load);
            kit::solve(builder.tolerance(1e-12))
        };
        for force in [[0.9, 0.0], [-7.0, 0.0], [0.0, 12.0], [0.0, -17.9]] {
            let axis = usize::from(force[1] != 0.0);
            let by_force = shear(TangentialLoad::force(force));
            let by_shift = shear(TangentialLoad::shift(by_force.shift()));
            assert!(
                (by_shift.force()[axis] / force[axis] - 1.0).abs() < 1e-8,
                "{force:?}"
            );
            assert_eq!(by_shift.shift(), by_force.shift());
            assert_eq!(by_shift.zones(), by_force.zones());
            let (a, b) = (by_shift.traction()[axis], by_force.traction()[axis]);
            assert!(l2_difference(a.as_slice(), b.as_slice()) < 1e-8);
        }
    }
}

#[test]
fn error_of_prescribed_motion_on_periodic_grid_is_within_certificate() {
    let grid = Grid::new(96, 80, 1.0, 1.2).unwrap();
    let bodies = HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap();
    let gap = rough(grid, 3);
    let mean = gap.integral() / grid.area();
    let friction = Friction::coulomb(0.6).unwrap();
    for (closed, tolerance) in [(0.3, 1e-2), (0.9, 1e-2), (0.999, 1e-2), (0.9, 1e-5)] {
        let press = |load, tolerance| {
            let builder = NormalProblem::builder(&bodies, &gap, load).tolerance(tolerance);
            kit::solve(builder)
        };
        let found = press(NormalLoad::Approach(closed * mean), tolerance);
        let exact = press(NormalLoad::Force(found.force()), 1e-12);
        let error = energy_difference(&bodies, Component::ZZ, exact.pressure(), found.pressure());
        let bound = found.report().energy_error_bound();
        assert!(
            bound <= tolerance && error <= bound + 1e-11,
            "{error:e} {bound:e}"
        );

        let shear = |load, tolerance| {
            let builder = TangentialProblem::builder(&bodies, &exact, friction.clone(), load);
            kit::solve(builder.tolerance(tolerance))
        };
        let found = shear(TangentialLoad::shift([0.1 * mean, 0.0]), tolerance);
        let exact = shear(TangentialLoad::force(found.force()), 1e-12);
        let [found_x, exact_x] = [&found, &exact].map(|answer| answer.traction()[0]);
        let error = energy_difference(&bodies, Component::XX, exact_x, found_x);
        let bound = found.report().energy_error_bound();
        assert!(
            bound <= tolerance && error <= bound + 1e-11,
            "{error:e} {bound:e}"
        );
    }
}
