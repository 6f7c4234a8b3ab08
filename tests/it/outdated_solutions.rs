//! Derivatives reject solutions of earlier input. Each test changes one input after a solve.

use kit::{assert_refused, coulomb, sphere, square, unit_bodies};
use stickslip::history::EntryRule;
use stickslip::normal::Hardness;
use stickslip::sensitivity::{Functional, Sensitivity};
use stickslip::stiffness::ContactStiffness;
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Axis, Boundary, CoupledProblem, CoupledSolution, CoupledSolver, Error, Field, Friction,
    HalfSpace, History, LoadStep, NormalLoad, NormalProblem, NormalSolution, NormalSolver, Result,
    TangentialControl, TangentialLoad, TangentialModel, TangentialProblem, TangentialSolution,
    TangentialSolver,
};

use crate::rank_contacts::on_ranks;

const FORCE: f64 = 4.0;
const DRAG: f64 = 0.8;

fn bodies() -> HalfSpace {
    unit_bodies(square(32, 12.0), 0.3)
}

fn dissimilar() -> HalfSpace {
    HalfSpace::new(square(32, 12.0), kit::on_rigid(1.0, 0.3)).unwrap()
}

fn ball(bodies: &HalfSpace) -> Field {
    sphere(bodies.grid(), 20.0)
}

fn pressed(bodies: &HalfSpace, load: NormalLoad) -> (NormalSolver, NormalSolution) {
    let problem = NormalProblem::builder(bodies, ball(bodies), load).tolerance(1e-10);
    let mut solver = kit::solver(problem);
    let mut contact = solver.new_solution();
    solver.solve_into(&mut contact).unwrap();
    (solver, contact)
}

fn sheared(
    bodies: &HalfSpace,
    contact: &NormalSolution,
    friction: &Friction,
    load: TangentialLoad,
    model: TangentialModel,
) -> (TangentialSolver, TangentialSolution) {
    let problem = TangentialProblem::builder(bodies, contact, friction.clone(), load);
    let mut solver = kit::solver(problem.model(model).tolerance(1e-10));
    let mut shear = solver.new_solution();
    solver.solve_into(&mut shear).unwrap();
    (solver, shear)
}

/// Asserts that a result is the error for this changed input.
#[track_caller]
fn assert_outdated<T: std::fmt::Debug>(found: Result<T>, expected: &str) {
    match found {
        Err(Error::OutdatedSolution { changed, .. }) => assert_eq!(changed, expected),
        other => panic!("{other:?}"),
    }
}

#[test]
fn stiffness_of_pressure_and_traction_under_different_loads_is_rejected() {
    let (bodies, friction) = (bodies(), coulomb(0.4));
    let load = TangentialLoad::force([DRAG, 0.0]);
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let (_, contact) = pressed(&bodies, NormalLoad::Force(FORCE));
        let (_, shear) = sheared(&bodies, &contact, &friction, load, model);
        ContactStiffness::new(&bodies, &contact, &friction, &shear).unwrap();
        // A change by a thousandth moves no cell to another set. A change by a tenth does.
        for factor in [1.001, 1.1, 0.9] {
            let (_, other) = pressed(&bodies, NormalLoad::Force(factor * FORCE));
            let found = ContactStiffness::new(&bodies, &other, &friction, &shear);
            assert_outdated(found, "the pressure or the friction");
        }
        let found = ContactStiffness::new(&bodies, &contact, &coulomb(0.41), &shear);
        assert_outdated(found, "the pressure or the friction");
    }
}

#[test]
fn stiffness_of_coupled_solution_under_different_friction_is_rejected() {
    let bodies = dissimilar();
    let (_, contact) = coupled(&bodies);
    contact.stiffness(&bodies, &coulomb(0.4)).unwrap();
    let found = contact.stiffness(&bodies, &coulomb(0.5));
    assert_outdated(found, "the pressure or the friction");
}

fn approach_of(solver: &NormalSolver, contact: &NormalSolution) -> Result<Sensitivity> {
    solver.sensitivity(contact, &Functional::Approach)
}

#[test]
fn sensitivity_of_normal_solution_of_earlier_input_is_rejected() {
    let bodies = bodies();
    let (mut solver, contact) = pressed(&bodies, NormalLoad::Force(FORCE));
    approach_of(&solver, &contact).unwrap();
    // A prescribed approach that equals the computed approach does not outdate the solution.
    solver
        .set_load(NormalLoad::Approach(contact.approach()))
        .unwrap();
    let peak = Functional::PressureNorm { exponent: 4.0 };
    solver.sensitivity(&contact, &peak).unwrap();
    solver
        .set_load(NormalLoad::Approach(1.001 * contact.approach()))
        .unwrap();
    assert_outdated(solver.sensitivity(&contact, &peak), "the normal load");
    solver.set_load(NormalLoad::Force(1.001 * FORCE)).unwrap();
    assert_outdated(approach_of(&solver, &contact), "the normal load");
    solver.set_load(NormalLoad::Force(FORCE)).unwrap();

    // The gap changes within the contact, and in a cell outside the contact.
    let centre = bodies.grid().cells() / 2 + bodies.grid().nx() / 2;
    for (cell, by) in [(centre, 1e-6), (centre, -1e-3), (0, -1e-2)] {
        let mut gap = ball(&bodies);
        gap.as_mut_slice()[cell] += by;
        solver.set_gap(&gap).unwrap();
        assert_outdated(approach_of(&solver, &contact), "the gap");
        let chained = solver.chain(&contact, Vec::new());
        assert_outdated(chained, "the gap");
    }
    solver.set_gap(&ball(&bodies)).unwrap();
    approach_of(&solver, &contact).unwrap();
}

#[test]
fn sensitivity_of_solution_of_earlier_hardness_is_rejected() {
    let bodies = bodies();
    let (_, elastic) = pressed(&bodies, NormalLoad::Force(FORCE));
    let limit = |part: f64| Hardness::uniform(part * elastic.pressure().max()).unwrap();
    let problem = NormalProblem::builder(&bodies, ball(&bodies), NormalLoad::Force(FORCE));
    let mut solver = kit::solver(problem.hardness(limit(0.8)).tolerance(1e-10));
    let mut contact = solver.new_solution();
    solver.solve_into(&mut contact).unwrap();
    assert!(contact.yielded_cells() > 0);
    approach_of(&solver, &contact).unwrap();
    for part in [0.75, 0.85] {
        solver.set_hardness(&limit(part)).unwrap();
        assert_outdated(approach_of(&solver, &contact), "the hardness");
    }
}

#[test]
fn sensitivity_of_tangential_solution_of_earlier_input_is_rejected() {
    let (bodies, friction) = (bodies(), coulomb(0.4));
    let (_, contact) = pressed(&bodies, NormalLoad::Force(FORCE));
    let (_, less) = pressed(&bodies, NormalLoad::Force(0.999 * FORCE));
    let energy = Functional::DissipatedEnergy;
    let spring = |position: f64| TangentialLoad::spring([position, 0.0], 5.0);
    let loads: [(TangentialLoad, TangentialLoad); 3] = [
        (
            TangentialLoad::force([DRAG, 0.0]),
            TangentialLoad::force([1.001 * DRAG, 0.0]),
        ),
        (
            TangentialLoad::shift([0.1, 0.0]),
            TangentialLoad::shift([0.1001, 0.0]),
        ),
        (spring(0.25), spring(0.2501)),
    ];
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        for (load, other) in loads {
            let (mut solver, shear) = sheared(&bodies, &contact, &friction, load, model);
            assert!(shear.slip_area() > 0.0 && shear.stick_area() > 0.0);
            let found = |solver: &TangentialSolver| solver.sensitivity(&shear, &energy);
            found(&solver).unwrap();
            solver.set_load(other).unwrap();
            assert_outdated(found(&solver), "the tangential load");
            solver.set_load(load).unwrap();
            solver.set_friction(&coulomb(0.401)).unwrap();
            assert_outdated(found(&solver), "the pressure or the friction");
            solver.set_friction(&friction).unwrap();
            solver.set_pressure(&less).unwrap();
            assert_outdated(found(&solver), "the pressure or the friction");
            solver.set_pressure(&contact).unwrap();
            found(&solver).unwrap();
        }
    }
    let load = loads[0].0;
    let (mut solver, shear) = sheared(&bodies, &contact, &friction, load, TangentialModel::Vector);
    solver.set_load(load.twist(1e-4)).unwrap();
    assert_outdated(solver.sensitivity(&shear, &energy), "the tangential load");
}

fn coupled(bodies: &HalfSpace) -> (CoupledSolver, CoupledSolution) {
    let loads = (NormalLoad::Force(FORCE), TangentialLoad::force([DRAG, 0.0]));
    let problem = CoupledProblem::builder(bodies, ball(bodies), coulomb(0.4), loads.0, loads.1);
    let mut solver = kit::solver(problem.tolerance(1e-10));
    let mut contact = solver.new_solution();
    solver.solve_into(&mut contact).unwrap();
    (solver, contact)
}

#[test]
fn sensitivity_of_coupled_solution_of_earlier_input_is_rejected() {
    let bodies = dissimilar();
    let (mut solver, contact) = coupled(&bodies);
    let found = |solver: &CoupledSolver| solver.sensitivity(&contact, &Functional::Approach);
    found(&solver).unwrap();
    let (press, drag) = (NormalLoad::Force(FORCE), TangentialLoad::force([DRAG, 0.0]));
    solver
        .set_loads(NormalLoad::Force(1.001 * FORCE), drag)
        .unwrap();
    assert_outdated(found(&solver), "the normal load");
    solver
        .set_loads(press, drag.along(Axis::Y, TangentialControl::Force(1e-3)))
        .unwrap();
    assert_outdated(found(&solver), "the tangential load");
    solver.set_loads(press, drag).unwrap();
    solver.set_friction(&coulomb(0.401)).unwrap();
    assert_outdated(found(&solver), "the friction");
    solver.set_friction(&coulomb(0.4)).unwrap();
    let mut gap = ball(&bodies);
    gap.as_mut_slice()[0] += 1e-4;
    solver.set_gap(&gap).unwrap();
    assert_outdated(found(&solver), "the gap");
    solver.set_gap(&ball(&bodies)).unwrap();
    found(&solver).unwrap();
}

#[test]
fn sensitivity_of_history_for_a_different_load_is_rejected() {
    let bodies = bodies();
    let builder = History::builder(&bodies, ball(&bodies), coulomb(0.4));
    let mut history = builder.entry_rule(EntryRule::WholeStep).build().unwrap();
    let step =
        |force: f64, drag: f64| LoadStep::force([drag, 0.0]).normal(NormalLoad::Force(force));
    history.step(&step(FORCE, DRAG)).unwrap();
    let found = |load: LoadStep| history.sensitivity(&load, &Functional::Shift(Axis::X));
    found(step(FORCE, DRAG)).unwrap();
    assert_outdated(found(step(FORCE, 0.99 * DRAG)), "the tangential load");
    assert_outdated(found(step(0.99 * FORCE, DRAG)), "the normal load");
}

/// The check adds one product, before which the observer is called.
#[test]
fn check_of_the_gap_can_be_cancelled() {
    use std::ops::ControlFlow::Break;
    use stickslip::stiffness::StiffnessWorkspace;
    let bodies = bodies();
    let (solver, contact) = pressed(&bodies, NormalLoad::Force(FORCE));
    let workspace = &mut StiffnessWorkspace::new();
    let all = [Functional::Approach];
    let cancelled = solver.sensitivities_with(&contact, &all, workspace, |_| Break(()));
    assert_refused! { cancelled => Error::NotConverged(_) }
}

#[test]
fn sensitivity_of_solution_of_earlier_relative_displacement_is_rejected() {
    let strain = |bodies: &HalfSpace, strain: f64| {
        let strain = [[strain, 0.0], [0.0, 0.0]];
        RelativeDisplacement::bulk_strain(bodies.grid(), strain).unwrap()
    };
    let (friction, load) = (coulomb(0.4), TangentialLoad::force([DRAG, 0.0]));
    for (bodies, model) in [
        (bodies(), TangentialModel::Scalar),
        (bodies(), TangentialModel::Vector),
        (dissimilar(), TangentialModel::Vector),
    ] {
        let (_, contact) = pressed(&bodies, NormalLoad::Force(FORCE));
        let problem = TangentialProblem::builder(&bodies, &contact, friction.clone(), load);
        let problem = problem.relative_displacement(strain(&bodies, 0.01));
        let mut solver = kit::solver(problem.model(model).tolerance(1e-8));
        let shear = kit::solved(&mut solver);
        assert!(shear.slip_area() > 0.0);
        let found =
            |solver: &TangentialSolver| solver.sensitivity(&shear, &Functional::DissipatedEnergy);
        found(&solver).unwrap();
        solver
            .set_relative_displacement(&strain(&bodies, 0.010_001))
            .unwrap();
        assert_outdated(found(&solver), "the relative displacement");
    }
    let bodies = dissimilar();
    let press = NormalLoad::Force(FORCE);
    let problem = CoupledProblem::builder(&bodies, ball(&bodies), friction, press, load);
    let mut solver = kit::solver(problem.relative_displacement(strain(&bodies, 0.01)));
    let contact = kit::solved(&mut solver);
    let found = |solver: &CoupledSolver| solver.sensitivity(&contact, &Functional::Approach);
    found(&solver).unwrap();
    solver
        .set_relative_displacement(&strain(&bodies, 0.010_001))
        .unwrap();
    assert_outdated(found(&solver), "the relative displacement");
}

/// The check of the gap accepts every solution of the present input: coarse tolerances, windows, rough and periodic contacts, and
/// solves that start from an earlier solution.
#[test]
fn sensitivity_of_present_solution_is_accepted() {
    for boundary in [Boundary::NonPeriodic, Boundary::Periodic] {
        for (side, tolerance) in [(12.0, 1e-2), (40.0, 1e-4), (40.0, 1e-8)] {
            let grid = square(64, side);
            let pair = kit::on_rigid(1.0, 0.3);
            let bodies = HalfSpace::with_boundary(grid, pair, boundary).unwrap();
            for gap in [sphere(grid, 20.0), kit::rough(grid, 3)] {
                let force = 1e-3 * side * side;
                let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(force));
                let mut solver = kit::solver(problem.tolerance(tolerance));
                for part in [1.0, 1.2, 0.7] {
                    solver.set_load(NormalLoad::Force(part * force)).unwrap();
                    let contact = kit::solved(&mut solver);
                    approach_of(&solver, &contact).unwrap();
                }
            }
        }
    }
}

/// A change on one rank causes an error on all ranks.
#[test]
fn solution_of_earlier_gap_of_one_rank_is_rejected_on_all_ranks() {
    let grid = square(32, 12.0);
    let outcomes = on_ranks(3, grid, Boundary::NonPeriodic, |bodies, rank| {
        let mut gap = ball(bodies);
        let problem = NormalProblem::builder(bodies, &gap, NormalLoad::Force(FORCE));
        let mut solver = kit::solver(problem);
        let contact = kit::solved(&mut solver);
        approach_of(&solver, &contact).unwrap();
        if rank == 2 {
            gap.as_mut_slice()[0] += 1e-3;
        }
        solver.set_gap(&gap).unwrap();
        let outdated = approach_of(&solver, &contact);

        let (friction, load) = (coulomb(0.4), TangentialLoad::force([DRAG, 0.0]));
        let model = TangentialModel::Vector;
        let (mut solver, shear) = sheared(bodies, &contact, &friction, load, model);
        ContactStiffness::new(bodies, &contact, &friction, &shear).unwrap();
        let other = ContactStiffness::new(bodies, &contact, &coulomb(0.41), &shear);
        assert_outdated(other, "the pressure or the friction");
        let energy = Functional::DissipatedEnergy;
        solver.sensitivity(&shear, &energy).unwrap();
        solver.set_friction(&coulomb(0.41)).unwrap();
        assert_outdated(
            solver.sensitivity(&shear, &energy),
            "the pressure or the friction",
        );
        outdated
    });
    for outcome in outcomes {
        assert_outdated(outcome, "the gap");
    }
}
