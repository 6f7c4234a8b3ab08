//! A solver with a changed input has the solution of a new problem with this input.

use kit::unit_bodies;
use stickslip::normal::Hardness;
use stickslip::rolling::{CoupledRollingProblem, RollingControl, RollingProblem};
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Axis, CoupledProblem, Error, Field, Friction, Grid, HalfSpace, History, LoadStep, NormalLoad,
    NormalProblem, TangentialLoad, TangentialProblem,
};

fn dissimilar(grid: Grid) -> (HalfSpace, Field) {
    (
        HalfSpace::new(grid, kit::on_rigid(1.0, 0.0)).unwrap(),
        kit::sphere(grid, 10.0),
    )
}

#[test]
fn normal_solver_with_new_hardness_has_solution_of_new_problem() {
    let grid = kit::square(32, 8.0);
    let (bodies, gap) = (unit_bodies(grid, 0.3), kit::sphere(grid, 10.0));
    let load = NormalLoad::Force(0.5);
    let builder = || NormalProblem::builder(&bodies, &gap, load).tolerance(1e-10);
    let mut solver = builder().build().unwrap().into_solver().unwrap();
    let mut contact = kit::solved(&mut solver);
    let largest = contact.pressure().max();
    for part in [0.8, 0.6, 0.9] {
        let hardness = Hardness::uniform(part * largest).unwrap();
        solver.set_hardness(&hardness).unwrap();
        solver.solve_into(&mut contact).unwrap();
        let expected = builder()
            .hardness(hardness)
            .build()
            .unwrap()
            .solve()
            .unwrap();
        let difference = contact
            .pressure()
            .minus(expected.pressure())
            .unwrap()
            .map(f64::abs)
            .max();
        assert!(difference < 1e-7 * largest, "{part}: {difference:e}");
        assert!((contact.approach() / expected.approach() - 1.0).abs() < 1e-8);
        assert_eq!(contact.yielded_cells(), expected.yielded_cells());
        assert!(contact.yielded_cells() > 0);
    }
    let soft = Hardness::uniform(0.001 * 0.5 / grid.area()).unwrap();
    let refused = solver.set_hardness(&soft);
    assert!(
        matches!(refused, Err(Error::BeyondHardness { .. })),
        "{refused:?}"
    );
    let before = contact.clone();
    solver.solve_into(&mut contact).unwrap();
    assert_eq!(contact.yielded_cells(), before.yielded_cells());
}

#[test]
fn coupled_solver_with_new_fields_has_solution_of_new_problem() {
    let grid = kit::square(24, 3.0);
    let (bodies, gap) = dissimilar(grid);
    let (press, drag) = (NormalLoad::Force(0.1), TangentialLoad::force([0.01, 0.0]));
    let builder =
        || CoupledProblem::builder(&bodies, &gap, kit::coulomb(0.3), press, drag).tolerance(1e-10);
    let mut solver = builder().build().unwrap().into_solver().unwrap();
    let mut contact = kit::solved(&mut solver);
    let largest = contact.normal().pressure().max();
    for (part, strain) in [(0.9, 2e-3), (0.7, -1e-3)] {
        let hardness = Hardness::uniform(part * largest).unwrap();
        let bulk = RelativeDisplacement::bulk_strain(grid, [[strain, 0.0], [0.0, 0.0]]).unwrap();
        solver.set_hardness(&hardness).unwrap();
        solver.set_relative_displacement(&bulk).unwrap();
        solver.solve_into(&mut contact).unwrap();
        let posed = builder().hardness(hardness).relative_displacement(bulk);
        let expected = posed.build().unwrap().solve().unwrap();
        let [found, expected] = [&contact, &expected].map(|contact| {
            let [x, y] = contact.tangential().traction();
            [contact.normal().pressure(), x, y]
        });
        for (found, expected) in found.into_iter().zip(expected) {
            let difference = found.minus(expected).unwrap().map(f64::abs).max();
            assert!(difference < 1e-6 * largest, "{part}: {difference:e}");
        }
    }
    let bulk =
        RelativeDisplacement::bulk_strain(kit::square(16, 3.0), [[1e-3, 0.0], [0.0, 0.0]]).unwrap();
    let refused = solver.set_relative_displacement(&bulk);
    assert!(
        matches!(refused, Err(Error::GridMismatch { .. })),
        "{refused:?}"
    );
    let soft = Hardness::uniform(0.001 * 0.1 / grid.area()).unwrap();
    let refused = solver.set_hardness(&soft);
    assert!(
        matches!(refused, Err(Error::BeyondHardness { .. })),
        "{refused:?}"
    );
}

/// A new friction without a cap replaces the earlier friction with its cap.
#[test]
fn new_friction_without_cap_removes_cap() {
    let grid = kit::square(16, 2.8);
    let (bodies, gap) = (unit_bodies(grid, 0.3), kit::sphere(grid, 20.0));
    let press = NormalLoad::Force(0.05);
    let normal = kit::solve(NormalProblem::builder(&bodies, &gap, press));
    let uncapped = kit::coulomb(0.3);
    let cap = 0.03 * normal.pressure().max();
    let capped = uncapped.clone().max_shear_stress(cap).unwrap();
    let slide = TangentialLoad::shift([0.5, 0.0]);
    let check = |force: f64| assert!((force / (0.3 * 0.05) - 1.0).abs() < 1e-6, "{force}");

    let problem = TangentialProblem::builder(&bodies, &normal, capped.clone(), slide);
    let mut solver = problem.build().unwrap().into_solver().unwrap();
    assert!(solver.friction_capacity() < 0.5 * 0.3 * 0.05);
    solver.set_friction(&uncapped).unwrap();
    check(kit::solved(&mut solver).force()[0]);

    let problem = CoupledProblem::builder(&bodies, &gap, capped.clone(), press, slide);
    let mut solver = problem.build().unwrap().into_solver().unwrap();
    solver.set_friction(&uncapped).unwrap();
    check(kit::solved(&mut solver).tangential().force()[0]);

    let problem = RollingProblem::builder(&bodies, &normal, capped.clone());
    let problem = problem.creepage([0.5, 0.0]).build().unwrap();
    let mut solver = problem.into_solver().unwrap();
    solver.set_friction(&uncapped).unwrap();
    check(kit::solved(&mut solver).force()[0]);

    let mut history = History::builder(&bodies, &gap, capped).build().unwrap();
    history.set_friction(&uncapped).unwrap();
    let slide = LoadStep::shift([0.5, 0.0]).normal(press);
    check(history.step(&slide).unwrap().tangential_force()[0]);
}

#[test]
fn friction_of_solver_is_last_friction_accepted() {
    let grid = kit::square(16, 2.8);
    let (bodies, gap) = (unit_bodies(grid, 0.3), kit::sphere(grid, 20.0));
    let press = NormalLoad::Force(0.05);
    let normal = kit::solve(NormalProblem::builder(&bodies, &gap, press));
    let capped = kit::coulomb(0.3).max_shear_stress(0.5).unwrap();
    let per_cell = Friction::per_cell(Field::constant(grid, 0.4)).unwrap();
    let foreign = Friction::per_cell(Field::constant(kit::square(8, 2.8), 0.4)).unwrap();
    let drag = TangentialLoad::force([0.01, 0.0]);
    let force = RollingControl::Force(0.01);
    macro_rules! check {
        ($solver:expr) => {{
            let mut solver = $solver;
            assert_eq!(solver.friction(), &capped);
            solver.set_friction(&per_cell).unwrap();
            assert_eq!(solver.friction(), &per_cell);
            solver.set_friction(&capped).unwrap();
            solver.set_friction(&foreign).unwrap_err();
            assert_eq!(solver.friction(), &capped);
            solver
        }};
    }

    let problem = TangentialProblem::builder(&bodies, &normal, capped.clone(), drag);
    let mut solver = check!(kit::solver(problem));
    // The new friction cannot carry the load.
    solver.set_friction(&kit::coulomb(0.1)).unwrap_err();
    assert_eq!(solver.friction(), &capped);

    let problem = CoupledProblem::builder(&bodies, &gap, capped.clone(), press, drag);
    check!(kit::solver(problem));

    let problem = RollingProblem::builder(&bodies, &normal, capped.clone());
    let mut solver = check!(kit::solver(problem.control(Axis::X, force)));
    solver.set_friction(&kit::coulomb(0.1)).unwrap_err();
    assert_eq!(solver.friction(), &capped);

    let problem = CoupledRollingProblem::builder(&bodies, &gap, capped.clone(), press);
    let mut solver = check!(kit::solver(problem.control(Axis::X, force)));
    solver.set_friction(&kit::coulomb(0.1)).unwrap_err();
    assert_eq!(solver.friction(), &capped);

    let history = History::builder(&bodies, &gap, capped.clone());
    check!(history.build().unwrap());
}
