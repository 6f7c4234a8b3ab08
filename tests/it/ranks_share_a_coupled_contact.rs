//! Contacts of dissimilar bodies, whose pressure and shear are found together, have the bits of one process on ranks.

use std::ops::ControlFlow;
use std::sync::Arc;

use stickslip::coupled::{CoupledSolution, CoupledSolver};
use stickslip::history::wear;
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::tangential::RelativeDisplacement;
use stickslip::*;

use crate::ranks_share_a_contact::{Found, PATIENCE, Scene, assert_same, boundaries, pair, same};
use crate::ranks_share_a_history::{ball, fine, found, friction, step};

/// A ball, one beside the middle that touches few rows, and waves that touch everywhere.
const GAPS: [fn(f64, f64) -> f64; 3] = [
    |x, y| 0.05 * (x * x + y * y),
    |x, y| 0.05 * ((x - 5.0).powi(2) + (y + 8.0).powi(2)),
    |x, y| 0.1 * (2.0 + (0.9 * x).sin() * (1.3 * y).cos() + (0.31 * x + 0.17 * y).sin()),
];

fn solver(
    bodies: &HalfSpace,
    gap: fn(f64, f64) -> f64,
    friction: Friction,
    press: NormalControl,
    load: TangentialLoad,
) -> CoupledSolver {
    let gap = Field::from_fn(bodies.grid(), gap);
    let problem = CoupledProblem::builder(bodies, &gap, friction, press, load);
    problem.build().unwrap().into_solver().unwrap()
}

/// Samples of the answer in every cell, and numbers that every rank knows.
fn answer(contact: &CoupledSolution) -> Found {
    let (normal, shear) = (contact.normal(), contact.shear());
    let [ux, uy, uz] = contact.displacement().map(Field::as_slice);
    let [qx, qy] = shear.traction().map(Field::as_slice);
    let (p, g) = (normal.pressure().as_slice(), normal.gap().as_slice());
    let report = contact.report();
    let [[fx, fy], [dx, dy]] = [shear.force(), shear.shift()];
    let mut known = vec![
        normal.approach(),
        normal.force(),
        normal.contact_cells() as f64,
        fx,
        fy,
        dx,
        dy,
        shear.moment(),
        shear.stick_ratio(),
        shear.dissipated_energy(),
        contact.elastic_energy(),
        contact.warnings().len() as f64,
        report.pressure_error_bound,
        report.traction_error_bound,
    ];
    known.extend(report.error_bounds.into_iter().flatten());
    known.extend(report.error_estimate.map(|estimate| estimate.traction));
    for report in [&report.work, &report.normal, &report.tangential] {
        known.extend([
            report.iterations as f64,
            report.double_precision_products as f64,
            report.single_precision_products as f64,
        ]);
    }
    let cell = |i: usize| [p[i], g[i], qx[i], qy[i], ux[i], uy[i], uz[i]];
    Found {
        cells: (0..normal.grid().cells()).map(cell).collect(),
        known,
    }
}

pub(crate) fn contacts_from_rest() -> Vec<Scene> {
    let grid = Grid::new(80, 130, 0.3, 0.2).unwrap();
    let from_rest = |boundary, gap: usize, press, force| {
        Scene::new("from rest", grid, boundary, move |bodies| {
            let load = TangentialLoad::force(force);
            let mut solver = solver(bodies, GAPS[gap], friction(bodies), press, load);
            let mut contact = solver.new_solution();
            solver.solve_into(&mut contact).unwrap();
            answer(&contact)
        })
    };
    let [free, periodic, along_y] = boundaries(grid);
    let press = NormalControl::Force(8.0);
    let pressed = [(free, 0), (free, 1), (free, 2), (periodic, 2), (along_y, 1)];
    let pressed = pressed.map(|(boundary, gap)| from_rest(boundary, gap, press, [0.8, 0.6]));
    let mut scenes = Vec::from(pressed);
    let approach = NormalControl::Approach(0.3);
    scenes.push(from_rest(free, 0, approach, [0.08, 0.06]));
    scenes.push(Scene::new("strained", grid, free, move |bodies| {
        let gap = Field::from_fn(bodies.grid(), GAPS[0]);
        let strain = [[2e-3, 1e-3], [0.0, -1e-3]];
        let bulk = RelativeDisplacement::bulk_strain(bodies.grid(), strain).unwrap();
        let load = TangentialLoad::force([0.8, 0.6]);
        let problem = CoupledProblem::builder(bodies, &gap, friction(bodies), press, load);
        let problem = problem.relative_displacement(bulk).build().unwrap();
        answer(&problem.solve().unwrap())
    }));
    scenes
}

#[test]
fn contacts_from_rest_have_the_same_bits() {
    assert_same(contacts_from_rest());
}

/// From the last answer, in boxes that are left for wider ones; on small boxes some ranks have no cells. A prescribed
/// shift under weak friction has bounds of the whole.
pub(crate) fn sequences() -> Vec<Scene> {
    let grid = Grid::new(80, 130, 0.3, 0.2).unwrap();
    let sequence = Scene::new("a sequence", grid, Boundary::NonPeriodic, |bodies| {
        let (press, weak) = (NormalControl::Force(0.5), Friction::coulomb(0.01).unwrap());
        let still = TangentialLoad::shift([0.0, 0.0]);
        let mut solver = solver(bodies, GAPS[1], weak, press, still);
        let mut contact = solver.new_solution();
        let mut bounds = 0;
        for force in [0.5, 0.52, 6.0, 0.5] {
            solver.set_normal(NormalControl::Force(force)).unwrap();
            solver.solve_into(&mut contact).unwrap();
            bounds += usize::from(contact.report().error_bounds.is_some());
            let load = TangentialLoad::shift([0.01 * force, 0.0]);
            solver.set_load(load).unwrap();
        }
        solver.set_friction(&friction(bodies)).unwrap();
        solver.solve_into(&mut contact).unwrap();
        assert_eq!(bounds, 4);
        answer(&contact)
    });
    vec![sequence]
}

#[test]
fn solvers_continue_with_the_same_bits() {
    assert_same(sequences());
}

/// Steps in which the contact grows, is worn, shrinks and turns.
fn worn(bodies: &HalfSpace, steps: usize) -> (History, Vec<f64>) {
    let mut gap = ball(bodies);
    // A grid that repeats has no bulk strain, but any displacement of its cells.
    let along_x = Field::from_fn(bodies.grid(), |x, _| 1e-3 * x);
    let along_y = Field::from_fn(bodies.grid(), |_, y| 2e-3 * y);
    let stretch = RelativeDisplacement::new([along_x, along_y]).unwrap();
    let builder = History::builder(bodies, &gap, friction(bodies)).relative_displacement(stretch);
    let mut history = builder.build().unwrap();
    let mut known = Vec::new();
    for (k, force) in [1.0, 4.0, 7.0, 2.0, 0.3, 9.0]
        .into_iter()
        .take(steps)
        .enumerate()
    {
        let part = 0.2 * (k as f64).sin() * force;
        let mut load = LoadStep::hold()
            .normal(NormalControl::Force(force))
            .tangential(Axis::X, TangentialControl::Force(part))
            .relative_displacement(0.1 * k as f64);
        if bodies.boundary() == Boundary::NonPeriodic {
            load = load.twist(1e-3 * (k as f64 / 3.0).sin());
        }
        step(&mut history, &load, &mut known);
        let mut depth = Field::zeros(bodies.grid());
        let slipped = history.last_step().slip_distance();
        wear::archard(1e-2, history.pressure(), slipped, &mut depth).unwrap();
        gap.add_scaled(1.0, &depth).unwrap();
        history.set_gap(&gap).unwrap();
    }
    (history, known)
}

pub(crate) fn histories() -> Vec<Scene> {
    let repeating = Grid::new(65, 130, 0.3, 0.2).unwrap();
    let scenes = [
        (fine(), Boundary::NonPeriodic),
        (repeating, Boundary::Periodic),
    ];
    let scenes = scenes.map(|(grid, boundary)| {
        Scene::new("a history", grid, boundary, |bodies| {
            let (history, known) = worn(bodies, 6);
            found(&history, known)
        })
    });
    scenes.into()
}

#[test]
fn histories_have_the_same_bits() {
    assert_same(histories());
}

/// Slabs of some ranks continue on others, or on none.
#[test]
fn slabs_continue_on_other_numbers_of_ranks() {
    let (grid, boundary) = (fine(), Boundary::NonPeriodic);
    let last = |history: &mut History| {
        let load = LoadStep::force([0.4, 0.1]).normal(NormalControl::Force(5.0));
        let mut known = Vec::new();
        step(history, &load, &mut known);
        found(history, known)
    };
    let alone = HalfSpace::with_boundary(grid, pair(), boundary).unwrap();
    let expected = last(&mut worn(&alone, 3).0);
    for (from, to) in [(1, 3), (3, 2)] {
        let slabs: Vec<_> = Threads::run(from, PATIENCE, |rank| {
            let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank));
            worn(&bodies.unwrap(), 3).0.to_bytes()
        });
        let parts = Threads::run(to, PATIENCE, |rank| {
            let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap();
            let slabs = slabs.iter().map(|bytes| history::State::from_bytes(bytes));
            let state = history::State::of_slabs(&bodies, slabs).unwrap();
            last(&mut History::from_state(&bodies, state).unwrap())
        });
        for part in &parts {
            same(&part.known, &expected.known).unwrap();
        }
        let cells: Vec<[f64; 7]> = parts.into_iter().flat_map(|part| part.cells).collect();
        same(cells.as_flattened(), expected.cells.as_flattened()).unwrap();
    }
}

/// Only the observer of the first rank ends the solve: on coarse cells that every rank solves by itself, as those of the
/// smaller grid, and on those that ranks share.
#[test]
fn the_first_rank_decides_for_all() {
    for cells in [96, 600] {
        the_first_rank_decides_on(Grid::square(cells, 8.0).unwrap());
    }
}

fn the_first_rank_decides_on(grid: Grid) {
    let solve = |bodies: &HalfSpace, last: usize| {
        let load = TangentialLoad::force([0.05, 0.0]);
        let coulomb = Friction::coulomb(0.3).unwrap();
        let press = NormalControl::Force(0.5);
        let mut solver = solver(bodies, GAPS[0], coulomb, press, load);
        let (mut contact, mut left) = (solver.new_solution(), last);
        let outcome = solver.solve_observed(&mut contact, |_| {
            left -= 1;
            if left == 0 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        (outcome, answer(&contact))
    };
    let alone = HalfSpace::new(grid, pair()).unwrap();
    let (outcome, expected) = solve(&alone, usize::MAX);
    outcome.unwrap();
    for (first, others) in [(usize::MAX, 3), (3, usize::MAX)] {
        let parts = Threads::run(3, PATIENCE, |rank| {
            let own = if rank.rank() == 0 { first } else { others };
            let boundary = Boundary::NonPeriodic;
            let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank));
            solve(&bodies.unwrap(), own)
        });
        for (outcome, part) in parts {
            if first == usize::MAX {
                outcome.unwrap();
                same(&part.known, &expected.known).unwrap();
            } else {
                let Err(Error::NotConverged(report)) = outcome else {
                    panic!("{outcome:?}")
                };
                assert_eq!(report.status, Status::Cancelled);
            }
        }
    }
}

/// What one rank refuses all refuse; kinds of friction that differ are told.
#[test]
fn what_one_rank_refuses_all_refuse() {
    let grid = Grid::square(128, 8.0).unwrap();
    let outcomes = Threads::run(3, PATIENCE, |rank| {
        let is_other = rank.rank() == 1;
        let boundary = Boundary::NonPeriodic;
        let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap();
        let build = |curvature: f64, mu: f64| {
            let gap = Field::from_fn(bodies.grid(), |x, y| curvature * (x * x + y * y));
            let (press, still) = (NormalControl::Force(0.5), TangentialLoad::shift([0.0, 0.0]));
            let coulomb = Friction::coulomb(mu).unwrap();
            let problem = CoupledProblem::builder(&bodies, &gap, coulomb, press, still);
            problem.build().map(drop)
        };
        [
            build(if is_other { f64::NAN } else { 1.0 }, 0.3),
            build(1.0, if is_other { 0.4 } else { 0.3 }),
        ]
    });
    for (rank, [gap, friction]) in outcomes.into_iter().enumerate() {
        let is_refused = gap == Err(Error::Ranks(RankFailure::Refused { rank: 1 }));
        assert_eq!(is_refused, rank != 1, "{gap:?}");
        assert!(gap.is_err());
        let different = Error::Ranks(RankFailure::Different("friction"));
        assert_eq!(friction, Err(different));
    }
}
