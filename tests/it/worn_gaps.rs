//! The warning about wear deeper than the displacement of the last contact, from solvers whose gap changes.

use std::f64::consts::PI;

use stickslip::rolling::CoupledRollingProblem;
use stickslip::{
    CoupledProblem, Field, HalfSpace, NormalLoad, NormalProblem, NormalSolution, TangentialLoad,
    Warning,
};

fn ball() -> (HalfSpace, Field, NormalLoad) {
    let grid = kit::square(32, 4.0);
    let bodies = HalfSpace::new(grid, kit::unit_pair(0.3)).unwrap();
    (bodies, kit::sphere(grid, 2.0), NormalLoad::Force(0.5))
}

fn tenths(warnings: Vec<Warning>) -> Option<usize> {
    warnings.into_iter().find_map(|warning| match warning {
        Warning::LargeGapChange { tenths } => Some(tenths),
        _ => None,
    })
}

/// Returns the gap with this depth of wear in some cells.
fn worn(gap: &Field, depth: f64, is_worn: impl Fn(usize) -> bool) -> Field {
    let cells = gap.as_slice().iter().enumerate();
    let worn = cells.map(|(i, gap)| gap + if is_worn(i) { depth } else { 0.0 });
    Field::from_vec(gap.grid(), worn.collect()).unwrap()
}

/// Returns the largest displacement of the contact, and the condition that a cell is in contact.
fn contact_of(contact: &NormalSolution, gap: &Field) -> (f64, impl Fn(usize) -> bool) {
    let pressure = contact.pressure().clone();
    let is_contact = move |i: usize| pressure.as_slice()[i] > 0.0;
    (contact.approach() - gap.min(), is_contact)
}

#[test]
fn wear_differs_from_change_of_surface() {
    let (bodies, ball, load) = ball();
    let grid = bodies.grid();
    let contact = kit::solve(NormalProblem::builder(&bodies, &ball, load));
    let (depth, is_contact) = contact_of(&contact, &ball);
    let radius = (contact.contact_area() / PI).sqrt();
    let is_track = |i: usize| grid.y(i / grid.nx()).abs() <= radius;
    let wear = |part: f64| worn(&ball, part * depth, &is_contact);
    let cases = [
        (wear(0.9), None),
        (wear(2.5), Some(25)),
        (wear(-2.5), Some(25)),
        (wear(1e6), Some(10_000_000)),
        (worn(&ball, 2.5 * depth, is_track), Some(25)),
        // A change of the datum, other surfaces, and a change outside the contact.
        (worn(&ball, 2.5 * depth, |_| true), None),
        (kit::rough(grid, 5).scaled(100.0 * depth), None),
        (kit::sphere(grid, 0.1), None),
        (worn(&ball, 1e3, |i| !is_contact(i)), None),
    ];
    for (gap, expected) in cases {
        let mut solver = kit::solver(NormalProblem::builder(&bodies, &ball, load));
        let mut solution = solver.new_solution();
        let mut solve = |gap: &Field, is_new: bool| {
            if is_new {
                solver.reset();
            }
            solver.set_gap(gap).unwrap();
            solver.solve_into(&mut solution).unwrap();
            tenths(solution.warnings())
        };
        // The first solve has no earlier contact.
        assert_eq!(solve(&gap, false), None);
        assert_eq!(solve(&ball, true), None);
        assert_eq!(solve(&gap, false), expected);
        assert_eq!(solve(&gap, false), None);
    }
}

/// Another part of a rough surface has summits at other places. The contact of a light load is then unrelated to the last contact.
#[test]
fn other_parts_of_rough_surface_have_no_warning() {
    let grid = kit::square(48, 48.0);
    let bodies = HalfSpace::new(grid, kit::unit_pair(0.3)).unwrap();
    let parts = |seed: u64| kit::rough(grid, seed);
    for force in [0.01, 1.0, 30.0] {
        let load = NormalLoad::Force(force);
        let mut solver = kit::solver(NormalProblem::builder(&bodies, parts(0), load));
        let mut solution = solver.new_solution();
        for seed in 1..20 {
            solver.set_gap(&parts(seed)).unwrap();
            solver.solve_into(&mut solution).unwrap();
            assert_eq!(tenths(solution.warnings()), None, "{force} {seed}");
        }
    }
}

#[test]
fn wear_of_coupled_solvers_has_warning() {
    let (bodies, ball, load) = ball();
    let (friction, pull) = (kit::coulomb(0.3), TangentialLoad::shift([1e-3, 0.0]));
    let mut solver = kit::solver(CoupledProblem::builder(
        &bodies,
        &ball,
        friction.clone(),
        load,
        pull,
    ));
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    let (depth, is_contact) = contact_of(solution.normal(), &ball);
    let gap = worn(&ball, 3.0 * depth, is_contact);
    solver.set_gap(&gap).unwrap();
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(tenths(solution.warnings()), Some(30));
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(tenths(solution.warnings()), None);

    let coupled = HalfSpace::new(bodies.grid(), kit::on_rigid(1.0, 0.3)).unwrap();
    for bodies in [bodies, coupled] {
        let problem = CoupledRollingProblem::builder(&bodies, &ball, friction.clone(), load);
        let mut solver = kit::solver(problem.creepage([1e-3, 0.0]));
        let mut solution = solver.new_solution();
        solver.solve_into(&mut solution).unwrap();
        let (depth, is_contact) = contact_of(solution.normal(), &ball);
        let gap = worn(&ball, 3.0 * depth, is_contact);
        solver.set_gap(&gap).unwrap();
        solver.solve_into(&mut solution).unwrap();
        let found = tenths(solution.warnings()).unwrap();
        assert!(found.abs_diff(30) <= 1, "{found}");
        solver.solve_into(&mut solution).unwrap();
        assert_eq!(tenths(solution.warnings()), None);
    }
}
