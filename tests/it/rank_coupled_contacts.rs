//! Coupled contacts of dissimilar bodies on ranks are bitwise identical to contacts solved by one process.

use std::ops::ControlFlow;
use std::sync::Arc;

use stickslip::coupled::{CoupledSolution, CoupledSolver};
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::*;

use crate::rank_contacts::{
    Found, PATIENCE, assert_rejected_by, assert_shared, by_cell, on_ranks, pair, same,
};
use crate::rank_histories::friction;

/// Gap of a centred ball.
const BALL: fn(f64, f64) -> f64 = |x, y| 0.05 * (x * x + y * y);
/// Gap of a ball off the centre, which touches few rows.
const OFF_CENTRE_BALL: fn(f64, f64) -> f64 = |x, y| 0.05 * ((x - 5.0).powi(2) + (y + 8.0).powi(2));

fn solver(
    bodies: &HalfSpace,
    gap: fn(f64, f64) -> f64,
    friction: Friction,
    press: NormalLoad,
    load: TangentialLoad,
) -> CoupledSolver {
    let gap = Field::from_fn(bodies.grid(), gap);
    let problem = CoupledProblem::builder(bodies, &gap, friction, press, load);
    kit::solver(problem)
}

/// Returns the samples of the solution in every cell, and results that every rank has.
fn samples(contact: &CoupledSolution) -> Found {
    let (normal, shear) = (contact.normal(), contact.tangential());
    let ([ux, uy, uz], [qx, qy]) = (contact.displacement(), shear.traction());
    let report = contact.report();
    let ([fx, fy], [dx, dy]) = (shear.force(), shear.shift());
    let mut known = vec![
        normal.approach(),
        normal.force(),
        fx,
        fy,
        dx,
        dy,
        shear.moment(),
        shear.dissipated_energy(),
        contact.elastic_energy(),
        report.pressure_error_bound,
        report.traction_error_bound,
        report.work.iterations as f64,
    ];
    known.extend(report.error_bounds.into_iter().flatten());
    known.extend(report.error_estimate.map(|estimate| estimate.traction));
    let cells = by_cell([normal.pressure(), normal.gap(), qx, qy, ux, uy, uz]);
    (cells, known)
}

/// Solvers continue from the last solution and in windows that are replaced by larger windows. In small windows some
/// ranks have no cells. With a prescribed shift and weak friction, the error bounds refer to the whole contact.
#[test]
fn continued_coupled_solves_on_ranks_match_one_process() {
    let grid = Grid::new(80, 130, 0.3, 0.2).unwrap();
    assert_shared(grid, Boundary::NonPeriodic, |bodies| {
        let (press, weak) = (NormalLoad::Force(0.5), kit::coulomb(0.01));
        let mut load = TangentialLoad::shift([0.0, 0.0]);
        let mut solver = solver(bodies, OFF_CENTRE_BALL, weak, press, load);
        let mut contact = solver.new_solution();
        let mut bounds = 0;
        for force in [0.5, 0.52, 6.0, 0.5] {
            solver.set_loads(NormalLoad::Force(force), load).unwrap();
            solver.solve_into(&mut contact).unwrap();
            bounds += usize::from(contact.report().error_bounds.is_some());
            load = TangentialLoad::shift([0.01 * force, 0.0]);
        }
        solver.set_friction(&friction(bodies)).unwrap();
        solver.solve_into(&mut contact).unwrap();
        assert_eq!(bounds, 4);
        samples(&contact)
    });
}

/// Only the observer of the first rank ends the solve. Every rank solves the coarse cells of the smaller grid on its own, whereas
/// the coarse cells of the larger grid are distributed.
#[test]
fn first_rank_decides_for_all() {
    for &cells in kit::thorough(&[96][..], &[96, 600]) {
        assert_first_rank_decides(kit::square(cells, 8.0));
    }
}

fn assert_first_rank_decides(grid: Grid) {
    let solve = |bodies: &HalfSpace, last: usize| {
        let load = TangentialLoad::force([0.05, 0.0]);
        let press = NormalLoad::Force(0.5);
        let mut solver = solver(bodies, BALL, kit::coulomb(0.3), press, load);
        let (mut contact, mut left) = (solver.new_solution(), last);
        let outcome = solver.solve_observed(&mut contact, |_| {
            left -= 1;
            if left == 0 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        (outcome, samples(&contact))
    };
    let alone = HalfSpace::new(grid, pair()).unwrap();
    let (outcome, expected) = solve(&alone, usize::MAX);
    outcome.unwrap();
    for (first, others) in [(usize::MAX, 3), (usize::MAX, 12), (3, usize::MAX)] {
        let parts = Threads::run(3, PATIENCE, |rank| {
            let own = if rank.rank() == 0 { first } else { others };
            let boundary = Boundary::NonPeriodic;
            let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank));
            solve(&bodies.unwrap(), own)
        });
        for (outcome, part) in parts {
            if first == usize::MAX {
                outcome.unwrap();
                same(&part.1, &expected.1).unwrap();
            } else {
                let Err(Error::NotConverged(report)) = outcome else {
                    panic!("{outcome:?}")
                };
                assert_eq!(report.status, Status::Cancelled);
            }
        }
    }
}

/// Input that one rank rejects is rejected by all ranks. Different types of friction are reported.
#[test]
fn input_rejected_by_one_rank_is_rejected_by_all() {
    let outcomes = on_ranks(
        3,
        kit::square(128, 8.0),
        Boundary::NonPeriodic,
        |bodies, rank| {
            let is_other = rank == 1;
            let build = |curvature: f64, mu: f64| {
                let gap = Field::from_fn(bodies.grid(), |x, y| curvature * (x * x + y * y));
                let (press, still) = (NormalLoad::Force(0.5), TangentialLoad::shift([0.0, 0.0]));
                let problem = CoupledProblem::builder(bodies, &gap, kit::coulomb(mu), press, still);
                problem.build().map(drop)
            };
            [
                build(if is_other { f64::NAN } else { 1.0 }, 0.3),
                build(1.0, if is_other { 0.4 } else { 0.3 }),
            ]
        },
    );
    let (gaps, frictions): (Vec<_>, Vec<_>) = outcomes.into_iter().map(|[a, b]| (a, b)).unzip();
    assert_rejected_by(1, &gaps, |error| matches!(error, Error::Sample { .. }));
    let different = Error::Ranks(RankFailure::InconsistentInput("friction"));
    assert_eq!(frictions, vec![Err(different); 3]);
}
