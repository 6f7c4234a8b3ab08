//! A problem or a solver refuses a load, a gap or a friction that makes no sense, with the offending number, before
//! any work; nothing it had is changed.

use kit::refusal::mismatch;
use kit::unit_bodies;
use stickslip::cgm::{Method, Settings};
use stickslip::tangential::JaegerSuperposition;
use stickslip::{
    Coupling, ElasticPair, Error, Field, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalControl, NormalProblem, NormalSolution, TangentialLoad, TangentialModel,
    TangentialProblem, surface,
};

const NEGATIVE: [f64; 4] = [-1e-300, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// The same number, NaN included.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}

fn bodies() -> HalfSpace {
    unit_bodies(Grid::new(8, 6, 1.0, 1.0).unwrap(), 0.3)
}

fn ball(bodies: &HalfSpace) -> Field {
    surface::sphere(bodies.grid(), 20.0).unwrap()
}

fn pressed(bodies: &HalfSpace) -> NormalSolution {
    NormalProblem::builder(bodies, ball(bodies), NormalControl::Force(1.0))
        .build()
        .unwrap()
        .solve()
        .unwrap()
}

#[test]
fn normal_problems() {
    let bodies = bodies();
    let gap = ball(&bodies);
    let build = |gap: &Field, load| NormalProblem::builder(&bodies, gap, load).build();
    for value in NEGATIVE {
        let error = build(&gap, NormalControl::Force(value)).err();
        assert!(
            matches!(error, Some(Error::NegativeOrNotFinite { value: v, .. }) if same(v, value))
        );
    }
    for value in NOT_FINITE {
        let error = build(&gap, NormalControl::Approach(value)).err();
        assert!(matches!(error, Some(Error::NotFinite { value: v, .. }) if same(v, value)));
        let mut broken = gap.clone();
        broken.as_mut_slice()[7] = value;
        let error = build(&broken, NormalControl::Force(1.0)).err();
        assert!(matches!(error, Some(Error::Sample { index: 7, value: v, .. }) if same(v, value)));
    }
    let other = Field::zeros(Grid::new(6, 8, 1.0, 1.0).unwrap());
    assert_eq!(
        build(&other, NormalControl::Force(1.0)).err(),
        Some(mismatch("gap", bodies.grid(), other.grid()))
    );
    for tolerance in [0.0, 1.0, -1e-6, f64::NAN] {
        let error = NormalProblem::builder(&bodies, &gap, NormalControl::Force(1.0))
            .tolerance(tolerance)
            .build()
            .err();
        assert!(matches!(error, Some(Error::Tolerance(t)) if same(t, tolerance)));
    }
    let error = NormalProblem::builder(&bodies, &gap, NormalControl::Force(1.0))
        .max_iterations(0)
        .build()
        .err();
    assert_eq!(error, Some(Error::IterationLimit));
}

#[test]
fn a_refused_change_leaves_the_solver_as_it_was() {
    let bodies = bodies();
    let gap = ball(&bodies);
    let problem = NormalProblem::builder(&bodies, &gap, NormalControl::Force(1.0))
        .build()
        .unwrap();
    let expected = problem.solve().unwrap();
    let mut solver = problem.into_solver().unwrap();
    assert!(solver.set_load(NormalControl::Force(-1.0)).is_err());
    assert!(
        solver
            .set_gap(&Field::constant(bodies.grid(), f64::NAN))
            .is_err()
    );
    let other = Grid::new(6, 8, 1.0, 1.0).unwrap();
    assert!(solver.set_gap(&Field::zeros(other)).is_err());
    let mut foreign = NormalProblem::builder(
        &unit_bodies(other, 0.3),
        Field::zeros(other),
        NormalControl::Force(1.0),
    )
    .build()
    .unwrap()
    .solve()
    .unwrap();
    let before = foreign.clone();
    assert_eq!(
        solver.solve_into(&mut foreign),
        Err(mismatch("solution", bodies.grid(), other))
    );
    assert_eq!(foreign, before);
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(solution.pressure(), expected.pressure());

    let load = TangentialLoad::force([0.1, 0.0]);
    let friction = Friction::coulomb(0.5).unwrap();
    let problem = TangentialProblem::builder(&bodies, &expected, friction, load)
        .build()
        .unwrap();
    let expected = problem.solve().unwrap();
    let mut solver = problem.into_solver().unwrap();
    assert!(solver.set_load(TangentialLoad::force([0.6, 0.0])).is_err());
    assert!(solver.set_load(TangentialLoad::shift([1.0, 1.0])).is_err());
    let slippery = Friction::coulomb(0.05).unwrap();
    assert!(matches!(
        solver.set_friction(&slippery),
        Err(Error::BeyondFrictionCapacity { .. })
    ));
    let foreign = Friction::per_cell(Field::zeros(other)).unwrap();
    assert!(matches!(
        solver.set_friction(&foreign),
        Err(Error::GridMismatch { .. })
    ));
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(solution.traction(), expected.traction());
}

#[test]
fn tangential_loads() {
    let bodies = bodies();
    let normal = pressed(&bodies);
    let friction = Friction::coulomb(0.5).unwrap();
    let build = |load| {
        TangentialProblem::builder(&bodies, &normal, friction.clone(), load)
            .build()
            .err()
    };
    for value in NOT_FINITE {
        for load in [
            TangentialLoad::force([value, 0.0]),
            TangentialLoad::shift([0.0, value]),
        ] {
            assert!(
                matches!(build(load), Some(Error::NotFinite { value: v, .. }) if same(v, value))
            );
        }
    }
    assert_eq!(
        build(TangentialLoad::force([0.1, 0.2])),
        Some(Error::ObliqueLoad { x: 0.1, y: 0.2 })
    );
    let Some(Error::BeyondFrictionCapacity { force, limit, .. }) =
        build(TangentialLoad::force([0.0, -0.51]))
    else {
        panic!("more than friction holds");
    };
    assert!(same(force, 0.51) && (limit - 0.5).abs() < 1e-12);
    let error = TangentialProblem::builder(
        &bodies,
        &normal,
        friction.clone(),
        TangentialLoad::force([0.1, 0.0]),
    )
    .tolerance(2.0)
    .build()
    .err();
    assert_eq!(error, Some(Error::Tolerance(2.0)));
}

#[test]
fn what_a_tangential_problem_stands_on() {
    let bodies = bodies();
    let normal = pressed(&bodies);
    let friction = Friction::coulomb(0.5).unwrap();
    let other = unit_bodies(Grid::new(8, 6, 1.0, 1.1).unwrap(), 0.3);
    let error = TangentialProblem::builder(
        &other,
        &normal,
        friction.clone(),
        TangentialLoad::force([0.1, 0.0]),
    )
    .build()
    .err();
    assert_eq!(
        error,
        Some(mismatch("normal solution", other.grid(), bodies.grid()))
    );

    let apart = NormalProblem::builder(&bodies, ball(&bodies), NormalControl::Force(0.0))
        .build()
        .unwrap()
        .solve()
        .unwrap();
    let error = TangentialProblem::builder(
        &bodies,
        &apart,
        friction.clone(),
        TangentialLoad::force([0.0, 0.0]),
    )
    .build()
    .err();
    assert_eq!(error, Some(Error::EmptyContact));
    assert_eq!(
        JaegerSuperposition::new(&apart, &apart, bodies.pair(), 0.5).err(),
        Some(Error::EmptyContact)
    );
    assert!(matches!(
        JaegerSuperposition::new(&normal, &apart, bodies.pair(), -0.5),
        Err(Error::NegativeOrNotFinite { .. })
    ));

    // The pressure of a coupled pair is not given where shear changes it.
    let pair = ElasticPair::new(
        Material::new(200.0, 0.3).unwrap(),
        Material::new(1.0, 0.3).unwrap(),
    )
    .unwrap();
    let coupled = HalfSpace::new(bodies.grid(), pair).unwrap();
    let normal = pressed(&coupled);
    let builder = || {
        TangentialProblem::builder(
            &coupled,
            &normal,
            friction.clone(),
            TangentialLoad::force([0.1, 0.0]),
        )
    };
    let asked = builder().coupling(Coupling::Full).build();
    let Some(Error::CoupledMaterials { beta }) = asked.err() else {
        panic!("coupled materials");
    };
    assert!((beta - pair.dundurs_beta()).abs() < 1e-15 && beta.abs() > 0.2);
    // Without coupling no axis moves by the pressure; with it, the force is carried by other tractions.
    let [one_way, neglected] = [Coupling::OneWay, Coupling::Neglected].map(|coupling| {
        builder()
            .coupling(coupling)
            .build()
            .unwrap()
            .solve()
            .unwrap()
    });
    let by_default = builder().build().unwrap().solve().unwrap();
    assert_eq!(by_default.traction(), one_way.traction());
    assert!(one_way.shift() != neglected.shift());
}

/// Cells whose sides differ by round-off are the same cells; those that differ by more are not.
#[test]
fn sides_are_compared_to_round_off() {
    let own = Grid::new(8, 6, 0.8 / 8.0, 0.6 / 6.0).unwrap();
    let bodies = unit_bodies(own, 0.3);
    let contact = |gap: &Field| {
        let problem = NormalProblem::builder(&bodies, gap, NormalControl::Force(0.01));
        problem.tolerance(1e-12).build()?.solve()
    };
    let expected = contact(&surface::sphere(own, 2.0).unwrap()).unwrap();
    let near = Grid::new(8, 6, 0.09999999999999999, 0.1 * (1.0 + 9e-13)).unwrap();
    assert_ne!(own, near);
    let found = contact(&surface::sphere(near, 2.0).unwrap()).unwrap();
    let most = expected.pressure().max();
    let pairs = found.pressure().as_slice().iter();
    for (found, expected) in pairs.zip(expected.pressure().as_slice()) {
        assert!(
            (found - expected).abs() < 1e-10 * most,
            "{found} {expected}"
        );
    }
    let friction = Friction::per_cell(Field::constant(near, 0.5)).unwrap();
    let load = TangentialLoad::force([0.001, 0.0]);
    let problem = TangentialProblem::builder(&bodies, &found, friction, load).build();
    assert!(problem.unwrap().solve().is_ok());
    let mut sum = surface::sphere(own, 2.0).unwrap();
    assert_eq!(sum.add_scaled(1.0, &Field::zeros(near)), Ok(()));

    let far = Grid::new(8, 6, 0.1, 0.1 * (1.0 + 3e-12)).unwrap();
    assert_eq!(contact(&Field::zeros(far)), Err(mismatch("gap", own, far)));
    let other = Grid::new(6, 8, 0.1, 0.1).unwrap();
    assert!(contact(&Field::zeros(other)).is_err());
}

/// A pressure solved for on other materials is refused; as a field it is anyone's.
#[test]
fn solutions_of_other_materials() {
    let bodies = bodies();
    let normal = pressed(&bodies);
    let softer = unit_bodies(bodies.grid(), 0.2);
    let foreign = pressed(&softer);
    assert_eq!(foreign.pair(), softer.pair());
    let refused = |quantity| Err(Error::MaterialMismatch { quantity });
    let friction = Friction::coulomb(0.5).unwrap();
    let load = TangentialLoad::force([0.1, 0.0]);
    let builder = TangentialProblem::builder(&bodies, &foreign, friction.clone(), load);
    assert_eq!(builder.build().map(drop), refused("normal solution"));
    let builder = TangentialProblem::builder(&bodies, &normal, friction, load);
    let mut solver = builder.build().unwrap().into_solver().unwrap();
    assert_eq!(solver.set_pressure(&foreign), refused("normal solution"));
    assert_eq!(solver.set_pressure(foreign.pressure()), Ok(()));

    let superposed = |full, stick| JaegerSuperposition::new(full, stick, bodies.pair(), 0.5);
    for (full, stick, quantity) in [
        (&foreign, &normal, "full contact"),
        (&normal, &foreign, "lighter contact"),
    ] {
        assert_eq!(superposed(full, stick).map(drop), refused(quantity));
    }

    // A solution that is solved into anew belongs to the bodies of the solver.
    let (mut solution, gap) = (foreign, ball(&bodies));
    let problem = NormalProblem::builder(&bodies, &gap, NormalControl::Force(1.0));
    let mut solver = problem.build().unwrap().into_solver().unwrap();
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(solution.pair(), normal.pair());
    assert_eq!(solution.pressure(), normal.pressure());
}

/// In the plane a load may have any direction, but no other number.
#[test]
fn loads_in_the_plane() {
    let bodies = bodies();
    let normal = pressed(&bodies);
    let build = |load| {
        let friction = Friction::coulomb(0.5).unwrap();
        let builder = TangentialProblem::builder(&bodies, &normal, friction, load);
        builder.model(TangentialModel::Vector).build()
    };
    let problem = build(TangentialLoad::force([0.1, 0.2])).unwrap();
    let expected = problem.solve().unwrap();
    let mut solver = problem.into_solver().unwrap();
    for value in NOT_FINITE {
        for [x, y] in [[value, 0.1], [0.1, value]] {
            for load in [TangentialLoad::force([x, y]), TangentialLoad::shift([x, y])] {
                for refused in [build(load).err(), solver.set_load(load).err()] {
                    assert!(
                        matches!(refused, Some(Error::NotFinite { value: v, .. }) if same(v, value))
                    );
                }
            }
        }
    }
    // Each component alone could be held.
    for load in [[0.4, 0.4], [-0.4, 0.4], [1e300, -1e300]] {
        let load = TangentialLoad::force(load);
        for refused in [build(load).err(), solver.set_load(load).err()] {
            assert!(
                matches!(refused, Some(Error::BeyondFrictionCapacity { .. })),
                "{refused:?}"
            );
        }
    }
    let mut solution = solver.new_solution();
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(solution.traction(), expected.traction());
}

/// A pressure that does not fit the load is refused, and the solver keeps the one it had.
#[test]
fn a_refused_pressure_changes_nothing() {
    let bodies = bodies();
    let normal = pressed(&bodies);
    let other = unit_bodies(Grid::new(6, 8, 1.0, 1.0).unwrap(), 0.3);
    let gap = ball(&bodies);
    let light = |force| {
        let problem = NormalProblem::builder(&bodies, &gap, NormalControl::Force(force));
        problem.build().unwrap().solve().unwrap()
    };
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        let friction = Friction::coulomb(0.5).unwrap();
        let load = TangentialLoad::force([0.2, 0.0]);
        let builder = TangentialProblem::builder(&bodies, &normal, friction, load);
        let problem = builder.model(lateral).build().unwrap();
        let expected = problem.solve().unwrap();
        let mut solver = problem.into_solver().unwrap();
        let sliding = solver.friction_capacity();
        let refused = solver.set_pressure(&pressed(&other)).unwrap_err();
        assert_eq!(
            refused,
            mismatch("normal solution", bodies.grid(), other.grid())
        );
        assert_eq!(solver.set_pressure(&light(0.0)), Err(Error::EmptyContact));
        let refused = solver.set_pressure(&light(0.3));
        assert!(
            matches!(refused, Err(Error::BeyondFrictionCapacity { .. })),
            "{refused:?}"
        );
        let unsolved = NormalProblem::builder(&bodies, &gap, NormalControl::Force(1.0));
        let unsolved = unsolved
            .build()
            .unwrap()
            .into_solver()
            .unwrap()
            .new_solution();
        assert!(matches!(
            solver.set_pressure(&unsolved),
            Err(Error::NotConverged(_))
        ));
        let superposed = JaegerSuperposition::new(&normal, &unsolved, bodies.pair(), 0.5);
        assert!(matches!(superposed, Err(Error::NotConverged(_))));
        assert!(same(solver.friction_capacity(), sliding));
        let mut solution = solver.new_solution();
        solver.solve_into(&mut solution).unwrap();
        assert_eq!(solution.traction(), expected.traction());
    }
}

/// Loads at the ends of what doubles can say: an answer with its certificate, or an error with a number.
#[test]
fn loads_at_the_ends_of_the_doubles() {
    let bodies = bodies();
    let gap = ball(&bodies);
    let all = [5e-324, 1e-310, 1e-300, 1e-200, 1e-100, 1e100, 1e200, 1e300];
    for &value in kit::thorough(&[5e-324, 1e-300, 1e-100, 1e200][..], &all) {
        for load in [
            NormalControl::Force(value),
            NormalControl::Approach(value),
            NormalControl::Approach(-value),
        ] {
            let problem = NormalProblem::builder(&bodies, &gap, load).build();
            match problem.and_then(|problem| problem.solve()) {
                Ok(contact) => {
                    assert!(contact.report().is_converged(), "{load:?}");
                    assert!(contact.pressure().min() >= 0.0 && contact.approach().is_finite());
                    if let NormalControl::Force(force) = load {
                        assert!(
                            (contact.force() / force - 1.0).abs() < 1e-12 || force < 1e-300,
                            "{load:?}"
                        );
                    }
                }
                Err(Error::ExtremeNumber { value, .. }) => {
                    assert!(!(1e-130..=1e130).contains(&value), "{load:?}: {value:e}");
                }
                Err(Error::NotFinite { .. }) => {}
                Err(error) => panic!("{load:?}: {error}"),
            }
        }
    }
}

/// The same of a shear: no force is held but a small one, and any shift slides at most.
#[test]
fn shears_at_the_ends_of_the_doubles() {
    let bodies = bodies();
    let normal = pressed(&bodies);
    for value in [5e-324, 1e-310, 1e-300, 1e-200, 1e-100, 1e100, 1e200, 1e300] {
        for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
            for load in [
                TangentialLoad::force([0.0, value]),
                TangentialLoad::shift([0.0, value]),
                TangentialLoad::shift([0.0, -value]),
            ] {
                let friction = Friction::coulomb(0.5).unwrap();
                let builder = TangentialProblem::builder(&bodies, &normal, friction, load);
                let problem = builder.model(lateral).build();
                match problem.and_then(|problem| problem.solve()) {
                    Ok(shear) => {
                        assert!(shear.report().is_converged());
                        assert!(shear.force()[1].abs() <= 0.5 * (1.0 + 1e-12), "{load:?}");
                    }
                    Err(Error::ExtremeNumber { value, .. }) => {
                        assert!(!(1e-130..=1e130).contains(&value), "{load:?}: {value:e}");
                    }
                    Err(Error::BeyondFrictionCapacity { .. }) => {}
                    Err(error) => panic!("{load:?}: {error}"),
                }
            }
        }
    }
}

/// A setting that a model cannot honour is an error, in problems, solvers and histories.
#[test]
fn a_method_that_the_model_does_not_have() {
    let bodies = unit_bodies(Grid::square(24, 12.0).unwrap(), 0.3);
    let gap = surface::sphere(bodies.grid(), 20.0).unwrap();
    let press = NormalProblem::builder(&bodies, &gap, NormalControl::Force(4.0));
    let normal = press.build().unwrap().solve().unwrap();
    let friction = Friction::coulomb(0.5).unwrap();
    let is_refused = |error: Option<Error>| matches!(error, Some(Error::Method { .. }));
    let load = TangentialLoad::force([0.5, 0.0]);
    let shear = || {
        TangentialProblem::builder(&bodies, &normal, friction.clone(), load)
            .model(TangentialModel::Vector)
    };
    assert!(is_refused(
        shear().method(Method::PolonskyKeer).build().err()
    ));
    let settings = Settings::default().method(Method::PolonskyKeer);
    let mut solver = shear().build().unwrap().into_solver().unwrap();
    assert!(is_refused(solver.set_settings(settings).err()));
    assert_eq!(solver.settings().method, Method::ActiveSet);
    let history =
        || History::builder(&bodies, &gap, friction.clone()).model(TangentialModel::Vector);
    assert!(is_refused(
        history().method(Method::PolonskyKeer).build().err()
    ));
    assert!(is_refused(
        history().build().unwrap().set_settings(settings).err()
    ));
    // A normal problem has no pressure to hold.
    let held = NormalProblem::builder(&bodies, &gap, NormalControl::Hold).build();
    assert_eq!(held.err(), Some(Error::NoPressureToHold));
}

#[test]
fn loads_of_another_number_than_the_histories() {
    let bodies = bodies();
    let friction = Friction::coulomb(0.3).unwrap();
    let history = History::builder(&bodies, ball(&bodies), friction).build();
    let mut histories = [history.unwrap()];
    let before = histories[0].to_bytes();
    let two = [LoadStep::hold().normal(NormalControl::Force(1.0)); 2];
    for loads in [&two[..0], &two] {
        assert!(matches!(
            History::step_all(&mut histories, loads),
            Err(Error::Length { expected: 1, found, .. }) if found == loads.len()
        ));
    }
    assert_eq!(histories[0].to_bytes(), before);
    assert!(History::step_all(&mut [], &[]).unwrap().is_empty());
}
