//! Histories distributed over ranks are bitwise identical to histories on one process.

use std::ops::ControlFlow;
use std::sync::Arc;

use stickslip::history::{AdaptiveSteps, FrettingLoop, LoadPath, wear};
use stickslip::normal::Hardness;
use stickslip::ranks::Threads;
use stickslip::stiffness::{ContactStiffness, StiffnessWorkspace};
use stickslip::tangential::RelativeDisplacement;
use stickslip::*;

use crate::rank_contacts::{Found, PATIENCE, assert_shared, by_cell, on_ranks, pair, same};

/// Returns the gap of a ball off the centre, which touches few rows at first and an increasing number of rows later.
pub(crate) fn ball(bodies: &HalfSpace) -> Field {
    Field::from_fn(bodies.grid(), |x, y| {
        0.05 * ((x - 0.3).powi(2) + (y + 2.0).powi(2))
    })
}

/// Returns a grid with many chunks. The windows of its contacts also have many chunks, so that all ranks have work.
pub(crate) fn fine() -> Grid {
    let (rows, dy) = kit::thorough((100, 0.15), (250, 0.06));
    Grid::new(128, rows, 0.08, dy).unwrap()
}

pub(crate) fn friction(bodies: &HalfSpace) -> Friction {
    let coefficient = Field::from_fn(bodies.grid(), |x, y| 0.3 + 0.01 * (x + y).sin());
    Friction::per_cell(coefficient).unwrap()
}

/// Returns the local state of a history.
fn cells(history: &History) -> Vec<f64> {
    let [qx, qy] = history.traction();
    let [slipped, lost] = [
        history.accumulated_slip(),
        history.accumulated_dissipation(),
    ];
    by_cell([history.pressure(), qx, qy, slipped, lost])
}

/// Runs reversing loads with adaptive steps, and cycles and the results derived from them.
fn fretting_results(bodies: &HalfSpace) -> Found {
    let gap = ball(bodies);
    let builder = History::builder(bodies, &gap, friction(bodies));
    let builder = builder.coupling(Coupling::Neglected);
    let mut history = builder.build().unwrap();
    let mut known = Vec::new();
    let mut adaptive = AdaptiveSteps::new(&history, 0.05).unwrap();
    let press = LoadStep::force([1.5, 0.0]).normal(NormalLoad::Force(10.0));
    let mut seen = 0.0;
    let count = |_: &History| {
        seen += 1.0;
        Ok(())
    };
    let steps = adaptive.step_observed(&mut history, &press, count).unwrap();
    known.extend([steps as f64, seen]);
    let path = LoadPath::triangle([1.5, 0.0], 8).unwrap();
    let fretting = FrettingLoop::new(path, LoadStep::force).until_steady(1e-3);
    let outcome = fretting
        .run_observed(&mut history, 3, |_, _| Ok(ControlFlow::Continue(())))
        .unwrap();
    let cycle = &outcome.last;
    known.extend([
        outcome.cycles as f64,
        f64::from(cycle.regime().unwrap() == history::Regime::PartialSlip),
        cycle.cyclic_residual().unwrap(),
        cycle.energy_ratio().unwrap(),
        cycle.energy().work,
    ]);
    let mut depth = Field::zeros(bodies.grid());
    wear::energy(1e-2, cycle.dissipation(), &mut depth).unwrap();
    let jump = wear::CycleJump::new(bodies, cycle, &depth).unwrap();
    let most = wear::max_stable_cycles(bodies, 1e-2, cycle.slip_distance()).unwrap();
    known.extend([jump.max_residual(0.9).cycles().unwrap(), most]);
    let mut both = [history.clone(), history];
    let loads = [LoadStep::force([0.5, 0.0]), LoadStep::force([-0.5, 0.0])];
    assert!(History::step_all(&mut both, &loads).unwrap().is_empty());
    known.extend(both[0].shift());
    let restored = History::from_state(bodies, both[0].state().clone()).unwrap();
    known.extend([both[0].stick_ratio(), restored.stick_ratio()]);
    (cells(&both[1]), known)
}

#[test]
fn cycles_and_adaptive_steps_on_ranks_match_one_process() {
    assert_shared(fine(), Boundary::NonPeriodic, fretting_results);
}

/// Returns all entries of a stiffness.
fn entries(stiffness: &ContactStiffness) -> impl Iterator<Item = f64> + use<> {
    let ContactStiffness {
        normal,
        tangential,
        by_approach,
        normal_by_motion,
        ..
    } = *stiffness;
    let matrices = [tangential.loading, tangential.reversal].concat();
    let found = matrices.into_iter().flatten();
    let found = found.chain(by_approach).chain(normal_by_motion);
    let bounds = [normal.value, normal.bound, tangential.bound];
    found.map(|entry| entry.unwrap_or(-1.0)).chain(bounds)
}

/// The contact grows and slips. The bodies are similar, coupled one way, or fully coupled. One case has the scalar
/// model.
#[test]
fn stiffnesses_on_ranks_match_one_process() {
    let (similar, dissimilar) = (Coupling::Neglected, [Coupling::OneWay, Coupling::Full]);
    let kinds = [
        (similar, TangentialModel::Scalar),
        (similar, TangentialModel::Vector),
        (dissimilar[0], TangentialModel::Vector),
        (dissimilar[1], TangentialModel::Vector),
    ];
    for (coupling, model) in kinds {
        let grid = Grid::new(128, 80, 0.2, 0.16).unwrap();
        assert_shared(grid, Boundary::NonPeriodic, |bodies| {
            let gap = ball(bodies);
            let builder = History::builder(bodies, &gap, friction(bodies)).model(model);
            let mut history = builder.coupling(coupling).build().unwrap();
            let mut known = Vec::new();
            let mut workspace = StiffnessWorkspace::new();
            for (force, approach) in [(0.0, 0.1), (0.4, 0.2), (0.2, 0.2)] {
                let press = LoadStep::shift([0.1 * force, 0.0]);
                history
                    .step(&press.normal(NormalLoad::Approach(approach)))
                    .unwrap();
                let go_on = |_: &Iteration| ControlFlow::Continue(());
                let stiffness = history.stiffness_with(&mut workspace, go_on).unwrap();
                known.extend(entries(&stiffness));
                known.push(workspace.report().products() as f64);
            }
            (cells(&history), known)
        });
    }
}

/// Returns a history whose state contains all optional parts, or only uniform parts.
pub(crate) fn started(bodies: &HalfSpace, is_rich: bool) -> History {
    let gap = ball(bodies);
    let builder = History::builder(
        bodies,
        &gap,
        if is_rich {
            friction(bodies)
        } else {
            kit::coulomb(0.3)
        },
    );
    let builder = builder
        .coupling(Coupling::Neglected)
        .model(TangentialModel::Vector);
    let mut history = if is_rich {
        let hard = Field::from_fn(bodies.grid(), |x, _| 0.25 + 0.001 * x);
        let strain = [[1e-3, 0.0], [0.0, 2e-3]];
        let bulk = RelativeDisplacement::bulk_strain(bodies.grid(), strain).unwrap();
        let builder = builder
            .hardness(Hardness::per_cell(hard).unwrap())
            .permanent_set(true);
        builder.relative_displacement(bulk).build().unwrap()
    } else {
        builder.build().unwrap()
    };
    run(&mut history, 0..5);
    let worn = history.gap_as_set().unwrap().map(|gap| gap + 1e-4);
    history.set_gap(&worn).unwrap();
    history
}

/// A history that is saved by ranks continues on a different number of ranks or on one process.
#[test]
fn saved_slabs_continue_on_different_number_of_ranks() {
    let grid = fine();
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("slabs");
    std::fs::create_dir_all(&folder).unwrap();
    for (boundary, is_rich) in [(Boundary::NonPeriodic, true), (Boundary::Periodic, false)] {
        let alone = HalfSpace::with_boundary(grid, pair(), boundary).unwrap();
        let mut whole = started(&alone, is_rich);
        let saved_alone = whole.to_bytes();
        let spots = whole.normal().spots().unwrap();
        let yielded = whole.normal().yielded_cells();
        assert_eq!(yielded > 0, is_rich);
        run(&mut whole, 5..6);
        let expected = cells(&whole);
        let everyday = if is_rich { [(3, 2)] } else { [(2, 1)] };
        for &(from, to) in kit::thorough(&everyday[..], &[(3, 1), (2, 3), (3, 2), (2, 1)]) {
            let file = folder.join(format!("{from}-{to}.state"));
            Threads::run(from, PATIENCE, |rank| {
                let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank));
                started(&bodies.unwrap(), is_rich).save(&file).unwrap();
            });
            let parts = on_ranks(to, grid, boundary, |bodies, _| {
                let mut history = History::load(bodies, &file).unwrap();
                assert_eq!(history.normal().yielded_cells(), yielded);
                if to == 1 {
                    assert!(history.to_bytes() == saved_alone);
                    assert_eq!(history.normal().spots().unwrap(), spots);
                }
                run(&mut history, 5..6);
                cells(&history)
            });
            same(&parts.concat(), &expected).unwrap();
        }
    }
}

/// Takes some steps of a load that grows and changes its direction.
pub(crate) fn run(history: &mut History, steps: std::ops::Range<u32>) {
    for k in steps.map(f64::from) {
        let load = LoadStep::force([0.2 * (1.0 + k) * k.sin(), 0.1 * k])
            .normal(NormalLoad::Force(2.0 + (1.0 + k) * (2.0 + (1.7 * k).cos())));
        history.step(&load).unwrap();
    }
}
