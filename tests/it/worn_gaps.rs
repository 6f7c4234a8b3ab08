//! Changes of the gap between solves: the warning about deep wear, and the rejection of gaps under load.

use std::f64::consts::PI;
use std::ops::ControlFlow;

use stickslip::history::AdaptiveSteps;
use stickslip::rolling::{CoupledRollingProblem, RollingProblem};
use stickslip::{
    Boundary, CoupledProblem, Error, Field, Grid, HalfSpace, History, LoadStep, NormalLoad,
    NormalProblem, NormalSolution, TangentialLoad, Warning, surface,
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
fn contact_of(contact: &NormalSolution, gap: &Field) -> (f64, impl Fn(usize) -> bool + use<>) {
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
    let lowered = wear(20.0).map(|gap| gap - 3.0 * depth);
    let cases = [
        (wear(9.0), false),
        (wear(20.0), true),
        (wear(-20.0), true),
        (wear(1e6), true),
        (worn(&ball, 20.0 * depth, is_track), true),
        (lowered, true),
        // A change of the datum, other surfaces, and a change outside the contact.
        (worn(&ball, 20.0 * depth, |_| true), false),
        (kit::rough(grid, 5).scaled(100.0 * depth), false),
        (kit::sphere(grid, 0.01), false),
        (worn(&ball, 1e3, |i| !is_contact(i)), false),
    ];
    for (gap, is_deep) in cases {
        let mut solver = kit::solver(NormalProblem::builder(&bodies, &ball, load));
        let mut solution = solver.new_solution();
        let mut solve = |gap: &Field, is_new: bool| {
            solver.set_gap(gap).unwrap();
            if is_new {
                solver.reset();
            }
            solver.solve_into(&mut solution).unwrap();
            tenths(solution.warnings()).is_some()
        };
        // The first solve has no earlier contact.
        assert!(!solve(&gap, false));
        assert!(!solve(&ball, true));
        assert_eq!(solve(&gap, false), is_deep);
        assert!(!solve(&gap, false));
    }
}

#[test]
fn wear_of_solver_is_the_net_change_since_the_last_solve() {
    let (bodies, ball, load) = ball();
    let mut solver = kit::solver(NormalProblem::builder(&bodies, &ball, load));
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    let (depth, is_contact) = contact_of(&solution, &ball);
    solver
        .set_gap(&worn(&ball, 100.0 * depth, &is_contact))
        .unwrap();
    solver.set_gap(&ball).unwrap();
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(tenths(solution.warnings()), None);
    for part in 1..=50 {
        let gap = worn(&ball, f64::from(part) * depth, &is_contact);
        solver.set_gap(&gap).unwrap();
    }
    solver.solve_into(&mut solution).unwrap();
    // The displacement after the wear is larger, because the contact has moved to a ring of larger gap.
    let found = tenths(solution.warnings()).unwrap();
    assert!((200..=500).contains(&found), "{found}");
}

#[test]
fn cancelled_solve_leaves_the_warning_to_the_next_solve() {
    let (bodies, ball, load) = ball();
    for calls in [0, 1, 3] {
        let mut solver = kit::solver(NormalProblem::builder(&bodies, &ball, load));
        let mut solution = solver.new_solution();
        solver.solve_into(&mut solution).unwrap();
        let (depth, is_contact) = contact_of(&solution, &ball);
        solver
            .set_gap(&worn(&ball, 30.0 * depth, is_contact))
            .unwrap();
        let mut left = calls;
        let cancelled = solver.solve_observed(&mut solution, |_| {
            if left == 0 {
                return ControlFlow::Break(());
            }
            left -= 1;
            ControlFlow::Continue(())
        });
        assert!(cancelled.is_err());
        solver.solve_into(&mut solution).unwrap();
        assert!(tenths(solution.warnings()).is_some(), "{calls}");
        solver.solve_into(&mut solution).unwrap();
        assert_eq!(tenths(solution.warnings()), None);
    }
}

/// Wear can be added while the bodies are almost unloaded. It is small if it is less than the displacement under the next load.
#[test]
fn wear_under_low_load_is_relative_to_the_displacement_of_the_next_load() {
    let (bodies, ball, NormalLoad::Force(force)) = ball() else {
        unreachable!("the load is a force")
    };
    let low = NormalLoad::Force(1e-4 * force);
    let mut solver = kit::solver(NormalProblem::builder(&bodies, &ball, low));
    let mut history = History::builder(&bodies, &ball, kit::coulomb(0.3))
        .build()
        .unwrap();
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    history.step(&LoadStep::hold().normal(low)).unwrap();
    let (depth, is_contact) = contact_of(&solution, &ball);
    let gap = worn(&ball, 20.0 * depth, is_contact);
    for (load, is_deep) in [(NormalLoad::Force(force), false), (low, true)] {
        solver.set_load(load).unwrap();
        solver.set_gap(&gap).unwrap();
        solver.solve_into(&mut solution).unwrap();
        let mut worn = history.clone();
        worn.set_gap(&gap).unwrap();
        let step = worn.step(&LoadStep::hold().normal(load)).unwrap();
        assert_eq!(tenths(step.warnings()).is_some(), is_deep);
        assert_eq!(tenths(solution.warnings()).is_some(), is_deep);
        solver.set_load(low).unwrap();
        solver.set_gap(&ball).unwrap();
        solver.solve_into(&mut solution).unwrap();
    }
}

/// The first of several steps solves for the pressure after the wear. The last step keeps its warning.
#[test]
fn wear_before_several_steps_has_warning_of_last_step() {
    let (bodies, ball, load) = ball();
    let press = LoadStep::hold().normal(load);
    let mut history = History::builder(&bodies, &ball, kit::coulomb(0.3))
        .build()
        .unwrap();
    history.step(&press).unwrap();
    let (depth, is_contact) = contact_of(history.normal(), &ball);
    history
        .set_gap(&worn(&ball, 20.0 * depth, is_contact))
        .unwrap();
    let load = LoadStep::shift([1e-3, 0.0]).normal(load);
    let mut pressed = history.clone();
    assert!(pressed.press(&load, 1e-2).unwrap() > 1);
    let mut stepped = history.clone();
    let mut steps = AdaptiveSteps::new(&stepped, 1e-2).unwrap();
    assert!(steps.step(&mut stepped, &load).unwrap() > 1);
    let once = tenths(history.step(&load).unwrap().warnings()).unwrap();
    for history in [pressed, stepped] {
        let found = tenths(history.last_step().unwrap().warnings()).unwrap();
        assert!(found.abs_diff(once) <= once / 2, "{found} {once}");
    }
}

/// Returns the number of cells in the warning about wear of the wrong sign, or zero.
fn negative(history: &History) -> usize {
    let warnings = history.last_step().unwrap().warnings();
    let cells = warnings.into_iter().find_map(|warning| match warning {
        Warning::NegativeWear { cells } => Some(cells),
        _ => None,
    });
    cells.unwrap_or(0)
}

/// Wear that is subtracted from the gap reduces it in slipped cells only. Other reductions of the gap have no warning.
#[test]
fn negative_wear_has_warning() {
    let (bodies, ball, load) = ball();
    let mut history = History::builder(&bodies, &ball, kit::coulomb(0.3))
        .build()
        .unwrap();
    let press = LoadStep::hold().normal(load);
    history.step(&press).unwrap();
    // Growth without slip has no warning.
    let contact = history.pressure().clone();
    let grown = worn(&ball, -1e-4, |i| contact.as_slice()[i] > 0.0);
    let mut pressed = history.clone();
    pressed.set_gap(&grown).unwrap();
    pressed.step(&press).unwrap();
    assert_eq!(negative(&pressed), 0);

    history.step(&LoadStep::force([0.1, 0.0])).unwrap();
    let slip = history.accumulated_slip().clone();
    let slips = |i: usize| slip.as_slice()[i] > 0.0;
    let slipped = (0..slip.as_slice().len()).filter(|i| slips(*i)).count();
    let sticks = |i: usize| contact.as_slice()[i] > 0.0 && !slips(i);
    assert!(slipped > 20 && (0..contact.as_slice().len()).any(sticks));
    let wear = |depth: f64| worn(&ball, depth, slips);
    let cases = [
        (wear(1e-4), 0),
        (wear(-1e-4), slipped),
        (wear(-1e-9), slipped),
        (wear(-1e-4).map(|gap| gap + 0.3), slipped),
        // A grown centre, a new datum, another surface, and a change of both signs.
        (worn(&ball, -1e-4, sticks), 0),
        (worn(&ball, -1e-4, |_| true), 0),
        (kit::sphere(bodies.grid(), 1.9), 0),
        (worn(&wear(-1e-4), 1e-4, sticks), 0),
    ];
    for (gap, cells) in cases {
        let mut next = history.clone();
        next.set_gap(&gap).unwrap();
        let step = LoadStep::force([-0.1, 0.0]).normal(load);
        next.step(&step).unwrap();
        assert_eq!(negative(&next), cells);
        // The next step compares with the gap that it has.
        next.step(&LoadStep::force([0.1, 0.0]).normal(load))
            .unwrap();
        assert_eq!(negative(&next), 0);
        // Several steps keep the warning of the first.
        let mut several = history.clone();
        several.set_gap(&gap).unwrap();
        let mut steps = AdaptiveSteps::new(&several, 1e-2).unwrap();
        steps.step(&mut several, &step).unwrap();
        assert_eq!(negative(&several), cells);
    }
}

/// The displacement of a line depends on the arbitrary datum. The warning does not.
#[test]
fn wear_of_line_contact_does_not_depend_on_datum() {
    let grid = Grid::line(64, 0.05).unwrap();
    let cylinder = surface::cylinder(grid, 2.0).unwrap();
    let found = [1e2, 1e8].map(|datum| {
        let bodies = HalfSpace::with_boundary(
            grid,
            kit::unit_pair(0.3),
            Boundary::PeriodicAlongY { datum },
        )
        .unwrap();
        let load = NormalLoad::Force(0.2 * grid.dy());
        let mut solver = kit::solver(NormalProblem::builder(&bodies, &cylinder, load));
        let mut solution = solver.new_solution();
        solver.solve_into(&mut solution).unwrap();
        let (_, is_contact) = contact_of(&solution, &cylinder);
        solver.set_gap(&worn(&cylinder, 8.0, is_contact)).unwrap();
        solver.solve_into(&mut solution).unwrap();
        tenths(solution.warnings()).unwrap()
    });
    assert!(found[0].abs_diff(found[1]) <= 1, "{found:?}");
    // The force per length over the contact modulus is 0.2.
    assert!(found[0].abs_diff(400) <= 4, "{found:?}");
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

/// A closed contact has no cells outside. A change of the datum does not count.
#[test]
fn closed_contact_compares_deviations_from_mean_change() {
    let grid = kit::square(16, 1.0);
    let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), Boundary::Periodic).unwrap();
    let wave = surface::bisinusoidal(grid, 1e-3, [1.0; 2]).unwrap();
    let load = NormalLoad::Force(1.0);
    let mut solver = kit::solver(NormalProblem::builder(&bodies, &wave, load));
    let mut solution = solver.new_solution();
    for (gap, is_deep) in [
        (wave.map(|gap| gap + 1.0), false),
        (wave.scaled(2.0), false),
        (worn(&wave, 1.0, |i| i == 40), true),
    ] {
        solver.set_gap(&wave).unwrap();
        solver.solve_into(&mut solution).unwrap();
        assert_eq!(solution.contact_cells(), grid.cells());
        solver.set_gap(&gap).unwrap();
        solver.solve_into(&mut solution).unwrap();
        assert_eq!(tenths(solution.warnings()).is_some(), is_deep);
        solver.reset();
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
    solver
        .set_gap(&worn(&ball, 30.0 * depth, is_contact))
        .unwrap();
    solver.solve_into(&mut solution).unwrap();
    let found = tenths(solution.warnings()).unwrap();
    assert!((100..=300).contains(&found), "{found}");
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(tenths(solution.warnings()), None);

    let coupled = HalfSpace::new(bodies.grid(), kit::on_rigid(1.0, 0.3)).unwrap();
    for bodies in [bodies, coupled] {
        let problem = CoupledRollingProblem::builder(&bodies, &ball, friction.clone(), load);
        let mut solver = kit::solver(problem.creepage([1e-3, 0.0]));
        let mut solution = solver.new_solution();
        solver.solve_into(&mut solution).unwrap();
        let (depth, is_contact) = contact_of(solution.normal(), &ball);
        solver
            .set_gap(&worn(&ball, 30.0 * depth, is_contact))
            .unwrap();
        solver.solve_into(&mut solution).unwrap();
        let found = tenths(solution.warnings()).unwrap();
        assert!((100..=300).contains(&found), "{found}");
        solver.solve_into(&mut solution).unwrap();
        assert_eq!(tenths(solution.warnings()), None);
    }
}

/// The gap of a solution is the gap under load. As a gap before loading it is an error, also with wear in the contact.
#[test]
fn gap_under_load_is_rejected() {
    let (bodies, ball, load) = ball();
    let friction = kit::coulomb(0.3);
    let with_wear = |normal: &NormalSolution| {
        let (depth, is_contact) = contact_of(normal, &ball);
        worn(normal.gap(), 0.01 * depth, is_contact)
    };
    let mut solver = kit::solver(NormalProblem::builder(&bodies, &ball, load));
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    for gap in [solution.gap().clone(), with_wear(&solution)] {
        kit::assert_refused! { solver.set_gap(&gap) => Error::GapUnderLoad }
    }
    assert_eq!(solver.gap(), &ball);
    // The gap of an open contact is its gap before loading.
    let mut open = kit::solver(NormalProblem::builder(
        &bodies,
        &ball,
        NormalLoad::Force(0.0),
    ));
    open.solve_into(&mut solution).unwrap();
    open.set_gap(solution.gap()).unwrap();

    let still = TangentialLoad::shift([0.0; 2]);
    let problem = CoupledProblem::builder(&bodies, &ball, friction.clone(), load, still);
    let mut solver = kit::solver(problem);
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    let gap = with_wear(solution.normal());
    kit::assert_refused! { solver.set_gap(&gap) => Error::GapUnderLoad }

    let problem = CoupledRollingProblem::builder(&bodies, &ball, friction.clone(), load);
    let mut solver = kit::solver(problem);
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    let gap = with_wear(solution.normal());
    kit::assert_refused! { solver.set_gap(&gap) => Error::GapUnderLoad }

    let mut history = History::builder(&bodies, &ball, friction).build().unwrap();
    let loaded = history.normal().gap().clone();
    history.set_gap(&loaded).unwrap();
    history.step(&LoadStep::hold().normal(load)).unwrap();
    let gap = with_wear(history.normal());
    let before = history.to_bytes();
    kit::assert_refused! { history.set_gap(&gap) => Error::GapUnderLoad }
    assert_eq!(history.to_bytes(), before);
}

/// The normal contact that a rolling solver computes is not in the hands of the caller.
#[test]
fn rolling_solution_has_warnings_of_its_normal_contact() {
    let (bodies, ball, load) = ball();
    let mut press = kit::solver(NormalProblem::builder(&bodies, &ball, load));
    let mut normal = press.new_solution();
    press.solve_into(&mut normal).unwrap();
    let problem = RollingProblem::builder(&bodies, &normal, kit::coulomb(0.3));
    let mut solver = kit::solver(problem.creepage([1e-3, 0.0]));
    let mut solution = solver.new_solution();
    let (depth, is_contact) = contact_of(&normal, &ball);
    press
        .set_gap(&worn(&ball, 30.0 * depth, is_contact))
        .unwrap();
    solver.set_normal_solver(press).unwrap();
    solver.set_normal_load(load).unwrap();
    solver.solve_into(&mut solution).unwrap();
    assert!(tenths(solution.warnings()).is_some());
    // A pressure that is set belongs to a solution with its own warnings.
    solver.set_pressure(&normal).unwrap();
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(tenths(solution.warnings()), None);
}
