//! Problems of every kind satisfy the conditions of contact and friction. Their solutions are invariant under changes
//! of units, swapped axes, mirroring and exchange of the bodies. They do not depend on the kind of load, the start or
//! the solver.

use std::ops::ControlFlow;
use std::time::Duration;

use kit::table::{Found, Kind, Measured, Problem, Scene, UnitTransform, scenes};
use kit::{max_abs, thorough};
use stickslip::cgm::{Method, Settings};
use stickslip::history::{EntryRule, LeadingEdge};
use stickslip::influence::Direction::{X, Y, Z};
use stickslip::{
    Coupling, Error, Field, Iteration, NormalControl, Operator, Report, Status, TangentialControl,
    TangentialModel, Zone,
};

use crate::history_continuation_is_bitwise::some_scenes;
use crate::scene_laws::{LawResult, assert_every, check, compare_groups, round_off};

const POSE: UnitTransform = UnitTransform::IN_PLACE;

/// Asserts a law for the problems of scenes that cover every option. In the campaign these are all scenes.
fn assert_every_problem(count: usize, mut law: impl FnMut(&Problem) -> LawResult) {
    assert_every(some_scenes(), |scene| {
        let mut problems = Problem::of(scene, count).into_iter();
        problems.try_for_each(|problem| law(&problem).map_err(|by| format!("{problem}: {by}")))
    });
}

fn measured(problem: &Problem, found: &Found, pose: &UnitTransform) -> Measured {
    found.measured(&problem.scene, pose, problem.step.roll.is_some())
}

/// Checks that two solutions of a problem agree within solver residuals and round-off.
fn check_same(problem: &Problem, found: &Found, expected: &Found, what: &str) -> LawResult {
    let [found, expected] = [found, expected].map(|found| measured(problem, found, &POSE));
    let same = compare_groups(&expected, &found, round_off(&problem.scene));
    same.map_err(|by| format!("{what}: {by}"))
}

/// Changes of units by powers of two cause no rounding, even far from one.
#[test]
fn problem_in_any_units_is_invariant() {
    assert_every_problem(thorough(1, 3), |problem| {
        let one = measured(problem, &problem.solve(problem.scene.tolerance), &POSE);
        let units = [(-10, -30), (-10, 400), (7, -400)].map(<[i32; 2]>::from);
        // Coupled rolling has round-off in units far from one, and may stall.
        let is_coupled_rolling = problem.kind == Kind::Coupled && problem.step.roll.is_some();
        let count = if is_coupled_rolling { 1 } else { 3 };
        for [length, pressure] in
            &units.map(|powers| powers.map(|power| 2_f64.powi(power)))[..count]
        {
            let pose = UnitTransform::in_units(*length, *pressure);
            let found = problem.solve_in(&pose, problem.scene.tolerance);
            compare_groups(&one, &measured(problem, &found, &pose), 0.0)
                .map_err(|by| format!("{length:e}, {pressure:e}: {by}"))?;
        }
        Ok(())
    });
}

/// Covers all leading edges of rolling.
#[test]
fn problem_turned_mirrored_or_exchanged_is_invariant() {
    assert_every_problem(1, |problem| {
        let one = measured(problem, &problem.solve(problem.scene.tolerance), &POSE);
        let turns: &[_] = if problem.scene.can_turn() {
            &[true, false]
        } else {
            &[false]
        };
        let signs = [[1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, 1.0]];
        let signs = &signs[..thorough(2, 4)];
        for (&swaps, &signs) in turns
            .iter()
            .flat_map(|turn| signs.iter().map(move |s| (turn, s)))
        {
            let exchanges = signs[0] < 0.0;
            let pose = UnitTransform {
                swaps,
                signs,
                exchanges,
                ..POSE
            };
            let found = problem.solve_in(&pose, problem.scene.tolerance);
            let found = measured(problem, &found, &pose);
            compare_groups(&one, &found, round_off(&problem.scene))
                .map_err(|by| format!("{pose:?}: {by}"))?;
        }
        Ok(())
    });
}

/// Evaluates gaps and slip with the operator of all three directions on the whole grid.
#[test]
fn problem_satisfies_contact_and_friction_laws() {
    let mut slipped = 0;
    assert_every_problem(thorough(2, 6), |problem| {
        let mut problem = problem.clone();
        if problem.step.roll.is_some() {
            problem.scene.entry_rule = EntryRule::WholeStep;
        }
        let found = problem.solve(problem.scene.tolerance);
        check_normal(&problem, &found)?;
        check_loads(&problem, &found)?;
        if problem.kind != Kind::Normal {
            slipped += check_friction(&problem, &found)?;
        }
        Ok(())
    });
    assert!(slipped > 500, "{slipped} cells slip");
}

/// Returns the displacements along x, y and z of a scene under tractions along these axes.
fn displacements(scene: &Scene, tractions: [&[f64]; 3]) -> [Vec<f64>; 3] {
    let operator = scene.half_space(&POSE).tensor_operator([X, Y, Z]).unwrap();
    let mut moved = [(); 3].map(|()| vec![0.0; operator.cells()]);
    let slices = moved.each_mut().map(Vec::as_mut_slice);
    operator.apply(tractions, slices, &mut operator.scratch().unwrap());
    moved
}

fn check_normal(problem: &Problem, found: &Found) -> LawResult {
    let (scene, normal, grid) = (&problem.scene, &found.normal, found.normal.grid());
    let (p, zeros) = (normal.pressure().as_slice(), vec![0.0; grid.cells()]);
    let [x, y] = match problem.kind {
        Kind::Coupled => found.traction.each_ref().map(Field::as_slice),
        _ => [&zeros[..]; 2],
    };
    let [.., sunk] = displacements(scene, [x, y, p]);
    let (initial, hardness) = (scene.gap(grid, &POSE), scene.hardness(grid, &POSE));
    let overlap = 1e-8 * max_abs(&sunk);
    for i in 0..grid.cells() {
        let gap = initial.as_slice()[i] + sunk[i] - normal.approach();
        let most = hardness
            .as_ref()
            .map_or(f64::INFINITY, |limit| limit.of_cell(i));
        let what = || format!("cell {i}, pressure {:e} of {most:e}, gap {gap:e}", p[i]);
        let error = (gap - normal.gap().as_slice()[i]).abs();
        check((0.0..=most).contains(&p[i]) && error <= overlap, what)?;
        check(gap >= -overlap || p[i] == most, what)?;
        check(gap <= overlap || p[i] == 0.0, what)?;
    }
    Ok(())
}

fn check_loads(problem: &Problem, found: &Found) -> LawResult {
    let close = |found: f64, asked: f64, what: &str| {
        check((found - asked).abs() <= 1e-8 * asked.abs(), || {
            format!("{what} of {found:e} for {asked:e}")
        })
    };
    let (normal, step) = (&found.normal, &problem.step);
    match step.normal {
        NormalControl::Force(force) => close(normal.force(), force, "normal force")?,
        NormalControl::Approach(approach) => close(normal.approach(), approach, "approach")?,
        _ => {}
    }
    let axes = if problem.kind == Kind::Normal { 0 } else { 2 };
    for (axis, control) in step.shear.into_iter().enumerate().take(axes) {
        let (force, motion) = (found.force[axis], found.motion[axis]);
        match (control, step.roll) {
            (TangentialControl::Force(asked), _) => close(force, asked, "force")?,
            (TangentialControl::Shift(asked), _) => close(motion, asked, "shift")?,
            (
                TangentialControl::Spring {
                    position,
                    stiffness,
                },
                _,
            ) => {
                close(force, stiffness * (position - motion), "spring force")?;
            }
            (_, Some(roll)) => close(motion, roll.creepage[axis], "creepage")?,
            _ => {}
        }
    }
    let turn = step
        .roll
        .map_or(step.twist.unwrap_or(0.0), |roll| roll.spin);
    check(axes == 0 || found.motion[2] == turn, || "turn".to_owned())
}

/// Checks tractions and slip of all cells, and returns the number of slipping cells.
fn check_friction(problem: &Problem, found: &Found) -> Result<usize, String> {
    let (scene, step, grid) = (&problem.scene, &problem.step, found.normal.grid());
    let friction = scene.friction(grid, &POSE);
    let (p, zeros) = (found.normal.pressure().as_slice(), vec![0.0; grid.cells()]);
    let q = found.traction.each_ref().map(Field::as_slice);
    let is_neglected = step.roll.is_none() && scene.coupling == Coupling::Neglected;
    let pressed = if is_neglected { &zeros } else { p };
    let moved = displacements(scene, [q[0], q[1], pressed]);
    let bulk = scene.strain.unwrap_or_default();
    let bulk = bulk.map(|row| row.map(|part| step.strain.unwrap_or(0.0) * part));
    let small = 1e-6 * max_abs(&moved[0]).max(max_abs(&moved[1]));
    let is_scalar = step.roll.is_none() && scene.model == TangentialModel::Scalar;
    // Length rolled, the vector to the middle of the path, and the distance to the cell before.
    let (unit, [half_x, half_y], far) = step.roll.map_or((1.0, [0.0; 2], 0), |roll| {
        let (n, row) = (roll.cells as isize, grid.nx() as isize);
        let [x, y] = [grid.dx(), grid.dy()].map(|side| 0.5 * n as f64 * side);
        match roll.edge {
            LeadingEdge::PlusX => (2.0 * x, [x, 0.0], n),
            LeadingEdge::MinusX => (2.0 * x, [-x, 0.0], -n),
            LeadingEdge::PlusY => (2.0 * y, [0.0, y], n * row),
            LeadingEdge::MinusY => (2.0 * y, [0.0, -y], -n * row),
        }
    });
    let ([mx, my, turn], mut slipped) = (found.motion, 0);
    for (i, zone) in found.zones.iter().enumerate() {
        let ([x, y], q) = (grid.position(i % grid.nx(), i / grid.nx()), q.map(|q| q[i]));
        let (size, limit) = (q[0].hypot(q[1]), friction.limit(i, p[i]));
        let rigid = [mx - turn * (y + half_y), my + turn * (x + half_x)];
        let slip = [0, 1].map(|axis| {
            let before = i.checked_add_signed(far).filter(|_| far != 0);
            let before = before.and_then(|before| moved[axis].get(before));
            let stretched = bulk[axis][0] * x + bulk[axis][1] * y;
            let slip = moved[axis][i] - before.unwrap_or(&0.0) + stretched - unit * rigid[axis];
            if axis == 1 && is_scalar { 0.0 } else { slip }
        });
        let slides = slip[0].hypot(slip[1]);
        let is_right = match zone {
            Zone::Separated => p[i] == 0.0 && size == 0.0,
            Zone::Stick => size <= limit && slides <= small,
            Zone::Slip => {
                let work = q[0] * slip[0] + q[1] * slip[1];
                let fields = found.slip.iter().zip(slip);
                let mut errors = fields.map(|(field, slip)| unit * field.as_slice()[i] - slip);
                (size - limit).abs() <= 1e-11 * limit
                    && (work + limit * slides).abs() <= small * limit
                    && errors.all(|error| error.abs() <= small)
            }
        };
        check(is_right, || {
            format!("{zone:?} cell {i}: {q:?} of {limit:e}, slip {slip:?} of {small:e}")
        })?;
        slipped += usize::from(*zone == Zone::Slip);
    }
    Ok(slipped)
}

/// Prescribing the motion of a solution gives its forces, and prescribing its forces gives its motion. Springs whose ends fit
/// this solution give the same solution.
#[test]
fn problem_with_motion_forces_or_springs_of_solution_has_this_solution() {
    assert_every_problem(thorough(2, 6), |problem| {
        let tolerance = problem.scene.tolerance;
        let found = problem.solve(tolerance);
        let mut alike = vec![("motion", problem.moved_as(&found))];
        // A force that slides the whole contact does not determine the motion.
        if problem.kind == Kind::Normal || found.zones.contains(&Zone::Stick) {
            alike.push(("forces", problem.forced_as(&found)));
        }
        if problem.step.roll.is_none() {
            let mut spring = problem.clone();
            for axis in 0..2 {
                let stiffness = 0.4;
                let position = found.motion[axis] + found.force[axis] / stiffness;
                spring.step.shear[axis] = TangentialControl::Spring {
                    position,
                    stiffness,
                };
            }
            alike.push(("springs", spring));
        }
        for (what, mut other) in alike {
            if problem.scene.model == TangentialModel::Scalar && problem.step.roll.is_none() {
                other.step.shear[1] = TangentialControl::Hold;
            }
            check_same(problem, &other.solve(tolerance), &found, what)?;
        }
        Ok(())
    });
}

/// A solver whose loads and tolerance have changed finds the solution of a new solver. A reset solver repeats the first
/// solve bitwise.
#[test]
fn problem_of_used_or_reset_solver_has_solution_of_new_solver() {
    let go = &mut |_: &Iteration| ControlFlow::Continue(());
    assert_every_problem(thorough(1, 6), |problem| {
        let settings = Settings::default().tolerance(problem.scene.tolerance);
        let mut solver = problem.solver(&POSE, settings).unwrap();
        let (outcome, first) = solver.solve(go);
        outcome.unwrap();
        for (normal, tangential) in [(0.9, 0.3), (1.2, -0.5)] {
            solver
                .set_settings(Settings::default().tolerance(1e-3))
                .unwrap();
            solver.set_loads(&problem.part(normal, tangential)).unwrap();
            solver.solve(go).0.unwrap();
        }
        // The pressure of a separate problem remains.
        let normal = if problem.kind == Kind::Separate {
            1.0
        } else {
            0.98
        };
        let next = problem.part(normal, 0.8);
        solver.set_settings(settings).unwrap();
        solver.set_loads(&next).unwrap();
        let mut copy = solver.clone();
        let (outcome, again) = solver.solve(go);
        outcome.unwrap();
        check_same(
            problem,
            &again,
            &next.solve(problem.scene.tolerance),
            "used solver",
        )?;
        check(copy.solve(go).1.is_same(&again), || {
            "copied solver".to_owned()
        })?;
        solver.reset();
        solver.set_loads(problem).unwrap();
        check(solver.solve(go).1.is_same(&first), || {
            "reset solver".to_owned()
        })
    });
}

/// Checks the status of a stopped solve. Its iterate carries the forces, and its tractions are within the limits.
fn check_stopped(
    problem: &Problem,
    (outcome, found): (Result<(), Error>, Found),
    status: Status,
) -> LawResult {
    let Err(Error::NotConverged(report)) = outcome else {
        return Err(format!("{status:?}: {outcome:?}"));
    };
    let ending = |report: &Report| (report.status, report.residual.to_bits(), report.products());
    let is_reported = ending(&report) == ending(&found.report) && report.residual > 0.0;
    check(is_reported && report.status == status, || {
        format!("{status:?}: {report}")
    })?;
    let (grid, pressure) = (found.normal.grid(), found.normal.pressure());
    check(pressure.min() >= 0.0, || "negative pressure".to_owned())?;
    let friction = problem.scene.friction(grid, &POSE);
    let [x, y] = found.traction.each_ref().map(Field::as_slice);
    for (i, p) in pressure.as_slice().iter().enumerate() {
        let limit = friction.limit(i, *p) * (1.0 + 1e-12);
        let traction = x[i].hypot(y[i]);
        check(traction <= limit, || {
            format!("{status:?}: traction {traction:e} in cell {i}, limit {limit:e}")
        })?;
    }
    match (problem.kind, problem.step.roll) {
        (Kind::Coupled, _) | (_, Some(_)) => Ok(()),
        _ => check_loads(problem, &found),
    }
}

/// The observer stops each solve once. A solve can also be stopped by the limits of iterations and of time, and at any
/// grid of a nested start. The solver then continues from its iterate.
#[test]
fn problem_stopped_anywhere_is_feasible_and_continues() {
    let mut fine: Vec<_> = scenes();
    fine.retain(|scene| ["scalar", "plane", "coupled"].contains(&scene.name));
    let fine = fine.into_iter().map(|scene| scene.finer([3, 4]));
    assert_every(some_scenes().into_iter().chain(fine).collect(), |scene| {
        for problem in Problem::of(scene, 1) {
            check_stops(&problem).map_err(|by| format!("{problem}: {by}"))?;
        }
        Ok(())
    });
}

fn check_stops(problem: &Problem) -> LawResult {
    let go = &mut |_: &Iteration| ControlFlow::Continue(());
    let settings = Settings::default().tolerance(problem.scene.tolerance);
    let new = |settings: Settings| problem.solver(&POSE, settings).unwrap();
    let (mut all, mut first) = (0, None);
    let mut solver = new(settings);
    let (outcome, expected) = solver.solve(&mut |step| {
        all += 1;
        first.get_or_insert(*step);
        ControlFlow::Continue(())
    });
    outcome.unwrap();
    // Before its first product a solve has no values, not even values of the previous solve.
    let is_forced = matches!(problem.step.normal, NormalControl::Force(_));
    if is_forced && problem.kind != Kind::Coupled {
        let mut again = None;
        solver.set_loads(&problem.part(1.01, 0.9)).unwrap();
        let keep = &mut |step: &Iteration| {
            again.get_or_insert(*step);
            ControlFlow::Continue(())
        };
        solver.solve(keep).0.unwrap();
        for first in [first, again].map(Option::unwrap) {
            let nothing = first.iteration + first.free == 0 && first.residual.is_infinite();
            check(nothing, || format!("first call with {first:?}"))?;
        }
    }
    let (mut last, mut before) = (1, 1);
    while last < all {
        let mut solver = new(settings);
        let mut calls = 0;
        let stopped = solver.solve(&mut |_| {
            calls += 1;
            if calls == last {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        check(calls == last, || {
            format!("{calls} calls, stopped at {last}")
        })?;
        check_stopped(problem, stopped, Status::Cancelled)
            .map_err(|by| format!("call {last} of {all}: {by}"))?;
        let (outcome, found) = solver.solve(go);
        outcome.map_err(|error| format!("after call {last}: {error}"))?;
        check_same(problem, &found, &expected, "continued")?;
        (last, before) = (last + thorough(before, 1), last);
    }
    for limit in [1, expected.report.iterations / 2] {
        if limit > 0 && limit < expected.report.iterations {
            let stopped = new(settings.max_iterations(limit)).solve(go);
            check_stopped(problem, stopped, Status::IterationLimit)?;
        }
    }
    let (mut calls, limit) = (0, Duration::from_millis(5));
    let stopped = new(settings.time_limit(limit)).solve(&mut |_| {
        calls += 1;
        if calls == 2 {
            std::thread::sleep(limit);
        }
        ControlFlow::Continue(())
    });
    // A solve of several grids and passes ends each of them without a call of the observer.
    check(calls <= 2, || format!("{calls} calls, the time ends at 2"))?;
    check_stopped(problem, stopped, Status::TimeLimit)
}

/// The step presses and shears the bodies together.
#[test]
fn problem_equals_first_step_of_history() {
    assert_every_problem(thorough(2, 6), |problem| {
        if problem.kind == Kind::Normal || problem.step.roll.is_some() {
            return Ok(());
        }
        let scene = Scene {
            entry_rule: EntryRule::WholeStep,
            is_set_permanent: false,
            ..problem.scene.clone()
        };
        let found = problem.solve(scene.tolerance);
        let mut history = scene.history(&scene.half_space(&POSE), &POSE);
        history.step(&scene.load(&problem.step, &POSE)).unwrap();
        let ([x, y], [fx, fy]) = (history.shift(), history.tangential_force());
        let step = Found {
            normal: history.normal().clone(),
            traction: history.traction().map(Field::clone),
            slip: history.last_step().unwrap().slip().map(Field::clone),
            zones: history.zones().to_vec(),
            motion: [x, y, history.twist()],
            force: [fx, fy, history.moment()],
            ..found.clone()
        };
        check_same(problem, &step, &found, "step")?;
        check(step.zones == found.zones, || "zones".to_owned())
    });
}

/// Without coupling of pressure and traction, the coupled problem reduces to the normal problem followed by the
/// tangential problem or by rolling.
#[test]
fn problem_of_uncoupled_bodies_solved_together_equals_separate_solves() {
    let mut count = 0;
    assert_every_problem(thorough(1, 6), |problem| {
        let scene = &problem.scene;
        let has_model = problem.step.roll.is_some() || scene.model == TangentialModel::Vector;
        if problem.kind != Kind::Separate || scene.coupling != Coupling::Full || !has_model {
            return Ok(());
        }
        count += 1;
        let found = problem.solve(scene.tolerance);
        let both = Problem {
            kind: Kind::Coupled,
            ..problem.clone()
        };
        let both = both.solve(scene.tolerance);
        if problem.step.roll.is_some() {
            let same = both.normal == found.normal && both.traction == found.traction;
            return check(same && both.slip == found.slip, || "differs".to_owned());
        }
        check_same(problem, &both, &found, "coupled solve")
    });
    assert!(count > 2);
}

/// Solves the pressure, and the tractions along one axis, without active sets.
#[test]
fn problem_solved_by_both_methods_has_one_solution() {
    assert_every_problem(thorough(1, 6), |problem| {
        let is_scalar =
            problem.scene.model == TangentialModel::Scalar && problem.step.roll.is_none();
        let is_spring =
            |shear: &TangentialControl| matches!(shear, TangentialControl::Spring { .. });
        let is_suitable = match problem.kind {
            Kind::Coupled => false,
            Kind::Separate => is_scalar && !problem.step.shear.iter().any(is_spring),
            Kind::Normal => true,
        };
        if !is_suitable {
            return Ok(());
        }
        let settings = Settings::default().tolerance(problem.scene.tolerance);
        let solver = problem.solver(&POSE, settings.method(Method::PolonskyKeer));
        let (outcome, found) = solver.unwrap().solve(&mut |_| ControlFlow::Continue(()));
        outcome.unwrap();
        check_same(
            problem,
            &found,
            &problem.solve(problem.scene.tolerance),
            "single loop",
        )
    });
}
