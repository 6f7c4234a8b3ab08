//! Results that combine several solutions reject solutions of different problems: other materials, loads, gaps or friction.

use kit::{assert_refused, coulomb, sphere, square, unit_bodies};
use stickslip::cgm::Method;
use stickslip::sensitivity::{Functional, Sensitivity};
use stickslip::stiffness::ContactStiffness;
use stickslip::subsurface::{Body, Planes, Stress, Tractions, at_points};
use stickslip::{
    Boundary, CoupledProblem, Error, Field, HalfSpace, History, LoadStep, NormalLoad,
    NormalProblem, NormalSolution, NormalSolver, Result, TangentialLoad, TangentialModel,
    TangentialProblem, TangentialSolution, TangentialSolver,
};

use crate::rank_contacts::on_ranks;

const FORCE: f64 = 4.0;
const DRAG: f64 = 0.8;
const FRICTION: f64 = 0.4;
const POINT: [f64; 3] = [0.2, -0.1, 0.5];

fn bodies() -> HalfSpace {
    unit_bodies(square(32, 12.0), 0.3)
}

fn ball(bodies: &HalfSpace) -> Field {
    sphere(bodies.grid(), 20.0)
}

/// Returns a gap of a round flat punch. Its contact cells do not depend on the force.
fn punch(bodies: &HalfSpace) -> Field {
    let height = |x: f64, y: f64| if x.hypot(y) < 2.0 { 0.0 } else { 100.0 };
    Field::from_fn(bodies.grid(), height)
}

fn pressed(bodies: &HalfSpace, gap: &Field, force: f64) -> (NormalSolver, NormalSolution) {
    let problem = NormalProblem::builder(bodies, gap, NormalLoad::Force(force));
    let mut solver = kit::solver(problem);
    let contact = kit::solved(&mut solver);
    (solver, contact)
}

fn sheared(
    bodies: &HalfSpace,
    contact: &NormalSolution,
    model: TangentialModel,
) -> (TangentialSolver, TangentialSolution) {
    let load = TangentialLoad::force([DRAG, 0.0]);
    let problem = TangentialProblem::builder(bodies, contact, coulomb(FRICTION), load);
    let mut solver = kit::solver(problem.model(model));
    let shear = kit::solved(&mut solver);
    (solver, shear)
}

/// Returns the changed input and the remedy of the error for an outdated solution.
#[track_caller]
fn outdated<T: std::fmt::Debug>(found: Result<T>) -> (&'static str, &'static str) {
    match found {
        Err(Error::OutdatedSolution {
            changed, remedy, ..
        }) => (changed, remedy),
        other => panic!("{other:?}"),
    }
}

const OTHER_PRESSURE: (&str, &str) = (
    "the pressure",
    "pass the normal solution whose pressure the tangential contact took",
);

fn stress_at_point(bodies: &HalfSpace, tractions: Tractions<'_>) -> Result<Stress> {
    at_points(bodies, Body::One, tractions, &[POINT]).map(|found| found[0].stress)
}

fn stress_in_plane(bodies: &HalfSpace, tractions: Tractions<'_>) -> Result<Stress> {
    let mut planes = Planes::new(bodies, &[POINT[2]])?;
    let plane = planes.solve(0, Body::One, tractions)?;
    Ok(plane.get(16, 16).unwrap_or_default())
}

#[test]
fn shear_under_different_pressure_is_rejected() {
    let bodies = bodies();
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        // A change by a thousandth moves no cell to another set, and the force never moves a cell of the punch.
        for (gap, factors) in [
            (ball(&bodies), [1.001, 1.2, 0.8]),
            (punch(&bodies), [1.001, 1.2, 0.8]),
        ] {
            let (_, contact) = pressed(&bodies, &gap, FORCE);
            let (_, shear) = sheared(&bodies, &contact, model);
            let friction = coulomb(FRICTION);
            shear.edges(&contact, &friction).unwrap();
            shear.spots(&contact).unwrap();
            let both = Tractions::from((&contact, &shear));
            stress_at_point(&bodies, both).unwrap();
            stress_in_plane(&bodies, both).unwrap();
            for factor in factors {
                let (_, other) = pressed(&bodies, &gap, factor * FORCE);
                assert_eq!(outdated(shear.edges(&other, &friction)), OTHER_PRESSURE);
                assert_eq!(outdated(shear.spots(&other)), OTHER_PRESSURE);
                let both = Tractions::from((&other, &shear));
                assert_eq!(outdated(stress_at_point(&bodies, both)), OTHER_PRESSURE);
                assert_eq!(outdated(stress_in_plane(&bodies, both)), OTHER_PRESSURE);
                // Fields have no solve to compare.
                let fields = Tractions::new(other.pressure()).with_traction(shear.traction());
                stress_at_point(&bodies, fields).unwrap();
                stress_at_point(&bodies, both.with_traction(shear.traction())).unwrap();
            }
        }
    }
}

/// Two solves of one problem differ by their errors. These solutions count as equal, and a load that is larger by 1e-4 does not.
#[test]
fn shear_under_pressure_of_second_solve_is_accepted() {
    let bodies = bodies();
    let friction = coulomb(FRICTION);
    for gap in [ball(&bodies), kit::rough(bodies.grid(), 3)] {
        let (mut press, contact) = pressed(&bodies, &gap, FORCE);
        let (mut solver, shear) = sheared(&bodies, &contact, TangentialModel::Vector);
        let found = by_pressure(&solver, &shear);
        let mut solve = |factor: f64| {
            press.set_load(NormalLoad::Force(1.7 * FORCE)).unwrap();
            kit::solved(&mut press);
            press.set_load(NormalLoad::Force(factor * FORCE)).unwrap();
            kit::solved(&mut press)
        };
        let (again, other) = (solve(1.0), solve(1.0 + 1e-4));
        let difference = |one: &NormalSolution| {
            kit::l2_difference(one.pressure().as_slice(), contact.pressure().as_slice())
        };
        assert!(
            difference(&again) > 1e-9,
            "the second solve is a different solve"
        );
        assert!(difference(&other) > 1e-5);
        let two_steps = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(FORCE));
        let two_steps = kit::solve(two_steps.method(Method::PolonskyKeer));
        for same in [&again, &two_steps] {
            shear.edges(same, &friction).unwrap();
            shear.spots(same).unwrap();
            stress_at_point(&bodies, Tractions::from((same, &shear))).unwrap();
            ContactStiffness::new(&bodies, same, &friction, &shear).unwrap();
            let (press, _) = pressed(&bodies, &gap, FORCE);
            press.chain(same, found.clone()).unwrap();
            solver.set_pressure(same).unwrap();
            by_pressure(&solver, &shear);
        }
        solver.set_pressure(&other).unwrap();
        let found_there = solver.sensitivity(&shear, &Functional::ElasticEnergy);
        assert_eq!(outdated(found_there).0, "the pressure or the friction");
        assert_eq!(outdated(shear.edges(&other, &friction)), OTHER_PRESSURE);
        assert_eq!(outdated(shear.spots(&other)), OTHER_PRESSURE);
        let stiffness = ContactStiffness::new(&bodies, &other, &friction, &shear);
        assert_eq!(outdated(stiffness).0, "the pressure or the friction");
        let (press, _) = pressed(&bodies, &gap, (1.0 + 1e-4) * FORCE);
        assert_eq!(outdated(press.chain(&other, found)), OTHER_SENSITIVITY);
    }
}

#[test]
fn shear_under_pressure_at_another_place_is_rejected() {
    let bodies = bodies();
    let gap_at = |x0: f64| Field::from_fn(bodies.grid(), |x, y| ((x - x0).powi(2) + y * y) / 40.0);
    let [(_, contact), (_, moved)] =
        [0.0, 0.375].map(|place| pressed(&bodies, &gap_at(place), FORCE));
    let (_, shear) = sheared(&bodies, &contact, TangentialModel::Scalar);
    assert_eq!(outdated(shear.spots(&moved)), OTHER_PRESSURE);
    assert_eq!(
        outdated(shear.edges(&moved, &coulomb(FRICTION))),
        OTHER_PRESSURE
    );
}

#[test]
fn edges_under_different_friction_are_rejected() {
    let bodies = bodies();
    let (_, contact) = pressed(&bodies, &ball(&bodies), FORCE);
    for model in [TangentialModel::Scalar, TangentialModel::Vector] {
        let (_, shear) = sheared(&bodies, &contact, model);
        for coefficient in [0.401, 0.399, 0.8] {
            assert_eq!(
                outdated(shear.edges(&contact, &coulomb(coefficient))),
                (
                    "the friction",
                    "pass the friction of the tangential contact"
                )
            );
        }
    }
}

#[test]
fn shear_of_different_materials_is_rejected() {
    let (bodies, softer) = (bodies(), unit_bodies(square(32, 12.0), 0.2));
    let [(_, contact), (_, other)] =
        [&bodies, &softer].map(|bodies| pressed(bodies, &ball(bodies), FORCE));
    let (_, shear) = sheared(&bodies, &contact, TangentialModel::Vector);
    let both = Tractions::from((&contact, &shear));
    let mixed = Tractions::from((&other, &shear));
    assert_refused! {
        shear.displacement(&softer) => Error::MaterialMismatch { quantity: "tangential contact" },
        shear.elastic_energy(&softer) => Error::MaterialMismatch { quantity: "tangential contact" },
        shear.stiffness(&softer) => Error::MaterialMismatch { quantity: "tangential contact" },
        shear.edges(&other, &coulomb(FRICTION)) => Error::MaterialMismatch { quantity: "normal contact" },
        shear.spots(&other) => Error::MaterialMismatch { quantity: "normal contact" },
        stress_at_point(&softer, both) => Error::MaterialMismatch { .. },
        stress_in_plane(&softer, both) => Error::MaterialMismatch { .. },
        stress_at_point(&softer, mixed) => Error::MaterialMismatch { quantity: "normal contact" },
    }
    // A solver that writes to a solution of other materials replaces the materials.
    let (mut solver, _) = sheared(&softer, &other, TangentialModel::Vector);
    let mut written = shear.clone();
    solver.solve_into(&mut written).unwrap();
    assert!(written.displacement(&softer).is_ok() && written.displacement(&bodies).is_err());
}

/// Both halves of a coupled solution belong to the same pressure.
#[test]
fn halves_of_coupled_solution_are_accepted() {
    let bodies = HalfSpace::new(square(32, 12.0), kit::on_rigid(1.0, 0.3)).unwrap();
    let (load, drag) = (NormalLoad::Force(FORCE), TangentialLoad::force([DRAG, 0.2]));
    let friction = coulomb(FRICTION);
    let problem = CoupledProblem::builder(&bodies, ball(&bodies), friction.clone(), load, drag);
    let contact = kit::solve(problem);
    let (normal, shear) = (contact.normal(), contact.tangential());
    shear.edges(normal, &friction).unwrap();
    shear.spots(normal).unwrap();
    stress_at_point(&bodies, Tractions::from((normal, shear))).unwrap();
    let (_, other) = pressed(&bodies, &ball(&bodies), FORCE);
    assert_eq!(outdated(shear.spots(&other)), OTHER_PRESSURE);
}

/// The work of the pressure on the displacement due to the tractions is part of neither half.
#[test]
fn energies_of_halves_differ_from_energy_of_coupled_solution() {
    let bodies = HalfSpace::new(square(32, 12.0), kit::on_rigid(1.0, 0.3)).unwrap();
    let (load, drag) = (NormalLoad::Force(FORCE), TangentialLoad::force([DRAG, 0.2]));
    let problem = CoupledProblem::builder(&bodies, ball(&bodies), coulomb(FRICTION), load, drag);
    let contact = kit::solve(problem);
    let (normal, shear) = (contact.normal(), contact.tangential());
    let alone = normal.displacement(&bodies).unwrap();
    let [_, _, together] = contact.displacement();
    let cells = normal.pressure().iter().zip(together).zip(&alone);
    let work: f64 = cells.map(|((p, all), own)| p * (all - own)).sum();
    let shared = work * bodies.grid().cell_area();
    let halves = normal.elastic_energy(&bodies).unwrap() + shear.elastic_energy(&bodies).unwrap();
    let whole = contact.elastic_energy();
    assert!(
        (halves + shared - whole).abs() < 1e-12 * whole,
        "{halves} {shared} {whole}"
    );
    assert!((halves - whole).abs() > 1e-3 * whole);
}

const OTHER_SENSITIVITY: (&str, &str) = (
    "the pressure",
    "solve the tangential contact under the new pressure, and chain its new sensitivities",
);

fn by_pressure(solver: &TangentialSolver, shear: &TangentialSolution) -> Vec<Sensitivity> {
    let functionals = [Functional::ElasticEnergy, Functional::DissipatedEnergy];
    solver.sensitivities(shear, &functionals).unwrap()
}

#[test]
fn chain_of_sensitivities_under_different_pressure_is_rejected() {
    let bodies = bodies();
    let tilted = Field::from_fn(bodies.grid(), |x, y| (x * x + y * y) / 40.0 + 1e-3 * x);
    let (mut press, mut contact) = pressed(&bodies, &ball(&bodies), FORCE);
    let (mut solver, mut shear) = sheared(&bodies, &contact, TangentialModel::Vector);
    let found = by_pressure(&solver, &shear);
    press.chain(&contact, found.clone()).unwrap();

    for factor in [1.001, 1.2] {
        press.set_load(NormalLoad::Force(factor * FORCE)).unwrap();
        press.solve_into(&mut contact).unwrap();
        let chained = press.chain(&contact, found.clone());
        assert_eq!(outdated(chained), OTHER_SENSITIVITY);
    }
    press.set_load(NormalLoad::Force(FORCE)).unwrap();
    press.set_gap(&tilted).unwrap();
    press.solve_into(&mut contact).unwrap();
    assert_eq!(outdated(press.chain(&contact, found)), OTHER_SENSITIVITY);

    solver.set_pressure(&contact).unwrap();
    solver.solve_into(&mut shear).unwrap();
    press.chain(&contact, by_pressure(&solver, &shear)).unwrap();
}

/// A second chain would add the derivatives of the normal contact twice.
#[test]
fn sensitivity_that_was_chained_before_is_rejected() {
    let bodies = bodies();
    let (press, contact) = pressed(&bodies, &ball(&bodies), FORCE);
    let (solver, shear) = sheared(&bodies, &contact, TangentialModel::Vector);
    let mut found = by_pressure(&solver, &shear);
    let chained = press.chain(&contact, found.clone()).unwrap();
    found[1] = chained[1].clone();
    for again in [chained, found] {
        let outcome = press.chain(&contact, again).map(|_| ());
        kit::assert_refused! { outcome => Error::UnsupportedByModel { quantity, .. }
        if quantity.contains("already contains") }
    }
}

/// A history that holds the normal load supplies sensitivities and its own normal contact.
#[test]
fn chain_of_history_under_different_pressure_is_rejected() {
    let bodies = bodies();
    let gap = ball(&bodies);
    let builder = History::builder(&bodies, &gap, coulomb(FRICTION));
    let mut history = builder.tolerance(1e-10).build().unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(FORCE));
    history.step(&press).unwrap();
    let drag = LoadStep::force([DRAG, 0.0]);
    history.step(&drag).unwrap();
    let found = history.sensitivity(&drag, &Functional::DissipatedEnergy);
    let found = vec![found.unwrap()];
    let (mut press, _) = pressed(&bodies, &gap, FORCE);
    press.chain(history.normal(), found.clone()).unwrap();
    press.set_load(NormalLoad::Force(1.001 * FORCE)).unwrap();
    let other = kit::solved(&mut press);
    assert_eq!(outdated(press.chain(&other, found)), OTHER_SENSITIVITY);
}

/// Solutions on ranks are compared like solutions on the whole grid.
#[test]
fn mixed_solutions_are_rejected_on_ranks() {
    let grid = square(32, 12.0);
    on_ranks(3, grid, Boundary::NonPeriodic, |bodies, _| {
        let gap = ball(bodies);
        let (mut press, contact) = pressed(bodies, &gap, FORCE);
        let (solver, shear) = sheared(bodies, &contact, TangentialModel::Vector);
        shear.spots(&contact).unwrap();
        stress_in_plane(bodies, Tractions::from((&contact, &shear))).unwrap();
        let found = by_pressure(&solver, &shear);
        press.chain(&contact, found.clone()).unwrap();

        press.set_load(NormalLoad::Force(1.001 * FORCE)).unwrap();
        let other = kit::solved(&mut press);
        assert_eq!(outdated(shear.spots(&other)), OTHER_PRESSURE);
        let both = Tractions::from((&other, &shear));
        assert_eq!(outdated(stress_in_plane(bodies, both)), OTHER_PRESSURE);
        assert_eq!(outdated(press.chain(&other, found)), OTHER_SENSITIVITY);
    });
}
