//! Histories shared by ranks have the bits of those of one process.

use std::ops::ControlFlow;
use std::sync::Arc;

use stickslip::history::{AdaptiveSteps, FrettingLoop, LoadPath, State, wear};
use stickslip::normal::Hardness;
use stickslip::ranks::Threads;
use stickslip::tangential::RelativeDisplacement;
use stickslip::*;

use crate::ranks_share_a_contact::{Found, PATIENCE, Scene, assert_same, pair, same};

/// A ball beside the middle: it touches few rows, and ever more of them.
pub(crate) fn ball(bodies: &HalfSpace) -> Field {
    Field::from_fn(bodies.grid(), |x, y| {
        0.05 * ((x - 0.3).powi(2) + (y + 2.0).powi(2))
    })
}

/// Many chunks, as the windows of contacts on it have them: all ranks have work.
pub(crate) fn fine() -> Grid {
    Grid::new(128, 250, 0.08, 0.06).unwrap()
}

pub(crate) fn friction(bodies: &HalfSpace) -> Friction {
    let coefficient = Field::from_fn(bodies.grid(), |x, y| 0.3 + 0.01 * (x + y).sin());
    Friction::per_cell(coefficient).unwrap()
}

/// What a history has come to, in every cell and as every rank knows it.
pub(crate) fn found(history: &History, mut known: Vec<f64>) -> Found {
    let fields = [
        history.pressure(),
        history.normal().gap(),
        history.traction()[0],
        history.traction()[1],
        history.accumulated_slip(),
        history.dissipated_energy(),
    ]
    .map(Field::as_slice);
    let cell = |i: usize| {
        let [p, g, x, y, s, e] = fields.map(|field| field[i]);
        [p, g, x, y, s, e, f64::from(history.zones()[i] as u8)]
    };
    let ([fx, fy], [dx, dy]) = (history.force(), history.shift());
    known.extend([
        fx,
        fy,
        dx,
        dy,
        history.moment(),
        history.approach(),
        history.normal().force(),
        history.normal().contact_cells() as f64,
        history.friction_capacity(),
    ]);
    Found {
        cells: (0..history.grid().cells()).map(cell).collect(),
        known,
    }
}

/// Steps a history, and notes what each step did.
pub(crate) fn step(history: &mut History, load: &LoadStep, known: &mut Vec<f64>) {
    let step = history.step(load).unwrap();
    let energy = step.energy();
    known.extend([
        energy.work,
        energy.elastic_after,
        energy.dissipated_energy,
        energy.mid_step_dissipated_energy,
        energy.released,
        energy.residual,
        step.stick_ratio(),
        step.warnings().len() as f64,
    ]);
    for report in [step.normal_report(), step.tangential_report()] {
        known.extend(report.map(|report| report.iterations as f64));
        known.extend(report.map(|report| report.residual));
    }
}

/// Twenty steps of a contact that grows, is worn, shrinks and grows again.
fn worn(bodies: &HalfSpace, model: TangentialModel) -> Found {
    let mut gap = ball(bodies);
    let (mut known, across) = (Vec::new(), model == TangentialModel::Vector);
    let coupling = if across {
        Coupling::OneWay
    } else {
        Coupling::Neglected
    };
    let builder = History::builder(bodies, &gap, friction(bodies)).model(model);
    let mut history = builder.coupling(coupling).build().unwrap();
    for (k, force) in [2.0, 6.0, 10.0, 10.0, 3.0, 0.4, 0.6, 12.0, 12.0, 12.0]
        .into_iter()
        .cycle()
        .take(20)
        .enumerate()
    {
        let part = 0.2 * (k as f64).sin() * force;
        let mut load = LoadStep::hold()
            .normal(NormalControl::Force(force))
            .tangential(Axis::X, TangentialControl::Force(part));
        if across {
            load = load.tangential(Axis::Y, TangentialControl::Shift(0.02 * (k as f64).cos()));
            if bodies.boundary() == Boundary::NonPeriodic {
                load = load.twist(1e-3 * (k as f64 / 3.0).sin());
            }
        }
        step(&mut history, &load, &mut known);
        let mut depth = Field::zeros(bodies.grid());
        wear::archard(
            1e-2,
            history.pressure(),
            history.last_step().slip_distance(),
            &mut depth,
        )
        .unwrap();
        gap.add_scaled(1.0, &depth).unwrap();
        history.set_gap(&gap).unwrap();
    }
    found(&history, known)
}

pub(crate) fn worn_contacts() -> Vec<Scene> {
    let (free, vector) = (Boundary::NonPeriodic, TangentialModel::Vector);
    let repeating = Grid::new(65, 250, 0.3, 0.1).unwrap();
    let scenes = [
        (fine(), free, TangentialModel::Scalar),
        (fine(), free, vector),
        (repeating, Boundary::Periodic, vector),
    ];
    let scenes = scenes.map(|(grid, boundary, model)| {
        let what = format!("wear, {model:?}");
        Scene::new(what, grid, boundary, move |bodies| worn(bodies, model))
    });
    scenes.into()
}

#[test]
fn worn_contacts_that_grow_and_shrink_have_the_same_bits() {
    assert_same(worn_contacts());
}

/// Loads that turn, with adaptive steps, cycles and what they add up to.
fn fretted(bodies: &HalfSpace) -> Found {
    let gap = ball(bodies);
    let builder = History::builder(bodies, &gap, friction(bodies));
    let builder = builder.coupling(Coupling::Neglected);
    let mut history = builder.build().unwrap();
    let mut known = Vec::new();
    let mut adaptive = AdaptiveSteps::new(&history, 0.05).unwrap();
    let press = LoadStep::force([1.5, 0.0]).normal(NormalControl::Force(10.0));
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
        f64::from(cycle.regime() == history::Regime::PartialSlip),
        cycle.cyclic_residual(),
        cycle.energy_ratio(),
        cycle.energy().work,
    ]);
    let mut depth = Field::zeros(bodies.grid());
    wear::energy(1e-2, cycle.dissipated_energy(), &mut depth).unwrap();
    let jump = wear::CycleJump::new(bodies, cycle, &depth).unwrap();
    let most = wear::max_stable_cycles(bodies, 1e-2, cycle.slip_distance()).unwrap();
    known.extend([jump.closed_within(0.9).cycles().unwrap(), most]);
    let mut both = [history.clone(), history];
    let loads = [LoadStep::force([0.5, 0.0]), LoadStep::force([-0.5, 0.0])];
    assert!(History::step_all(&mut both, &loads).unwrap().is_empty());
    known.extend(both[0].shift());
    found(&both[1], known)
}

pub(crate) fn cycles() -> Vec<Scene> {
    vec![Scene::new("cycles", fine(), Boundary::NonPeriodic, fretted)]
}

#[test]
fn cycles_and_adaptive_steps_have_the_same_bits() {
    assert_same(cycles());
}

/// What yields and stays, and a strained body under a contact.
pub(crate) fn yielding_and_strained_contacts() -> Vec<Scene> {
    let yielding = Scene::new("yielding", fine(), Boundary::NonPeriodic, |bodies| {
        let gap = ball(bodies);
        let builder = History::builder(bodies, &gap, friction(bodies));
        let builder = builder.coupling(Coupling::Neglected);
        let hard = Hardness::uniform(0.3).unwrap();
        let mut history = builder.hardness(hard).permanent_set(true).build().unwrap();
        let mut known = Vec::new();
        for force in [4.0, 10.0, 2.0] {
            let load = LoadStep::force([0.1 * force, 0.0]).normal(NormalControl::Force(force));
            step(&mut history, &load, &mut known);
            known.push(history.normal().yielded_cells() as f64);
        }
        found(&history, known)
    });
    let along_y = Boundary::PeriodicAlongY { datum: 50.0 };
    let grid = Grid::new(128, 250, 0.125, 0.25).unwrap();
    let mut scenes = vec![yielding];
    for (grid, boundary) in [
        (grid, Boundary::NonPeriodic),
        (grid, along_y),
        // All of a line is on one rank.
        (Grid::line(64, 0.25).unwrap(), along_y),
    ] {
        scenes.push(Scene::new("strain", grid, boundary, |bodies| {
            let roller = Field::from_fn(bodies.grid(), |x, _| 0.05 * x * x);
            let strain = [[1e-2, 0.0], [0.0, 0.0]];
            let bulk = RelativeDisplacement::bulk_strain(bodies.grid(), strain).unwrap();
            let coulomb = Friction::coulomb(0.3).unwrap();
            let builder = History::builder(bodies, &roller, coulomb).relative_displacement(bulk);
            let mut history = builder.coupling(Coupling::OneWay).build().unwrap();
            let (mut known, length) = (Vec::new(), bodies.grid().whole().ny() as f64);
            for (force, amount) in [(0.1, 0.0), (0.1, 1.0), (0.12, -1.0)] {
                let load = LoadStep::force([0.0, 0.0]).relative_displacement(amount);
                let load = load.normal(NormalControl::Force(force * length));
                step(&mut history, &load, &mut known);
            }
            found(&history, known)
        }));
    }
    scenes
}

#[test]
fn yielding_and_strained_contacts_have_the_same_bits() {
    assert_same(yielding_and_strained_contacts());
}

/// A history with all that a state may hold, or with what is the same everywhere.
pub(crate) fn begun(bodies: &HalfSpace, is_rich: bool) -> History {
    let gap = ball(bodies);
    let coulomb = Friction::coulomb(0.3).unwrap();
    let builder = History::builder(
        bodies,
        &gap,
        if is_rich { friction(bodies) } else { coulomb },
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
    let worn = history.gap().map(|gap| gap + 1e-4);
    history.set_gap(&worn).unwrap();
    history
}

/// Histories that some ranks have saved are continued by others, or by none.
#[test]
fn slabs_are_put_together_on_other_numbers_of_ranks() {
    let grid = fine();
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("slabs");
    std::fs::create_dir_all(&folder).unwrap();
    for (boundary, is_rich) in [(Boundary::NonPeriodic, true), (Boundary::Periodic, false)] {
        let alone = HalfSpace::with_boundary(grid, pair(), boundary).unwrap();
        let mut whole = begun(&alone, is_rich);
        let saved_alone = whole.to_bytes();
        let spots = whole.normal().spots();
        let yielded = whole.normal().yielded_cells();
        assert_eq!(yielded > 0, is_rich);
        run(&mut whole, 5..8);
        let expected = found(&whole, Vec::new());
        for (from, to) in [(1, 3), (3, 1), (2, 7), (7, 4)] {
            let file = folder.join(format!("{from}-{to}.state"));
            let states = Threads::run(from, PATIENCE, |rank| {
                let bodies = HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank));
                let history = begun(&bodies.unwrap(), is_rich);
                history.save(&file).unwrap();
                history.state().clone()
            });
            let parts = Threads::run(to, PATIENCE, |rank| {
                let bodies =
                    HalfSpace::distributed(grid, pair(), boundary, Arc::new(rank)).unwrap();
                // From the file, or from what is in memory.
                let mut history = if from == 7 {
                    let slabs = states.iter().map(|state| Ok(state.clone()));
                    let state = State::of_slabs(&bodies, slabs).unwrap();
                    History::from_state(&bodies, state).unwrap()
                } else {
                    History::load(&bodies, &file).unwrap()
                };
                assert_eq!(history.normal().yielded_cells(), yielded);
                if to == 1 {
                    assert!(history.to_bytes() == saved_alone);
                    assert_eq!(history.normal().spots(), spots);
                }
                run(&mut history, 5..8);
                found(&history, Vec::new())
            });
            for part in &parts {
                same(&part.known, &expected.known).unwrap();
            }
            let cells: Vec<[f64; 7]> = parts.into_iter().flat_map(|part| part.cells).collect();
            same(cells.as_flattened(), expected.cells.as_flattened()).unwrap();
        }
    }
}

/// Some steps of a load that grows and turns.
pub(crate) fn run(history: &mut History, steps: std::ops::Range<u32>) {
    for k in steps.map(f64::from) {
        let load = LoadStep::force([0.2 * (1.0 + k) * k.sin(), 0.1 * k]).normal(
            NormalControl::Force(2.0 + (1.0 + k) * (2.0 + (1.7 * k).cos())),
        );
        history.step(&load).unwrap();
    }
}
