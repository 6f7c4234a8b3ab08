//! Problems and solvers reject an invalid load, gap or friction before any work, with the offending number. A rejected
//! change leaves them unchanged.

use kit::refusal::mismatch;
use kit::unit_bodies;
use stickslip::cgm::{Method, Settings};
use stickslip::tangential::JaegerSuperposition;
use stickslip::{
    Coupling, ElasticPair, Error, Field, Friction, Grid, HalfSpace, History, LoadStep, Material,
    NormalLoad, NormalProblem, NormalSolution, TangentialLoad, TangentialModel, TangentialProblem,
};

const NEGATIVE: [f64; 4] = [-1e-300, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// Returns whether two numbers are bitwise identical, NaN included.
fn is_identical(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}

fn unit_half_space() -> HalfSpace {
    unit_bodies(Grid::new(8, 6, 1.0, 1.0).unwrap(), 0.3)
}

fn ball_gap(bodies: &HalfSpace) -> Field {
    kit::sphere(bodies.grid(), 20.0)
}

fn press_ball(bodies: &HalfSpace) -> NormalSolution {
    kit::solve(NormalProblem::builder(
        bodies,
        ball_gap(bodies),
        NormalLoad::Force(1.0),
    ))
}

#[test]
fn normal_problem_with_invalid_load_or_gap_is_rejected() {
    let bodies = unit_half_space();
    let gap = ball_gap(&bodies);
    let build = |gap: &Field, load| NormalProblem::builder(&bodies, gap, load).build();
    for value in NEGATIVE {
        let error = build(&gap, NormalLoad::Force(value)).err();
        assert!(
            matches!(error, Some(Error::NegativeOrNotFinite { value: v, .. }) if is_identical(v, value))
        );
    }
    for value in NOT_FINITE {
        let error = build(&gap, NormalLoad::Approach(value)).err();
        assert!(matches!(error, Some(Error::NotFinite { value: v, .. }) if is_identical(v, value)));
        let mut broken = gap.clone();
        broken.as_mut_slice()[7] = value;
        let error = build(&broken, NormalLoad::Force(1.0)).err();
        assert!(
            matches!(error, Some(Error::Sample { index: 7, value: v, .. }) if is_identical(v, value))
        );
    }
    let other = Field::zeros(Grid::new(6, 8, 1.0, 1.0).unwrap());
    kit::assert_refused! {
        build(&other, NormalLoad::Force(1.0)) => error if error == mismatch("gap", bodies.grid(), other.grid()),
    }
    for tolerance in [0.0, 1.0, -1e-6, f64::NAN] {
        kit::assert_refused! {
            NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0)).tolerance(tolerance).build()
                => Error::Tolerance(t) if is_identical(t, tolerance),
        }
    }
    kit::assert_refused! {
        NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0)).max_iterations(0).build()
            => Error::IterationLimit,
    }
}

#[test]
fn normal_solver_rejected_change_leaves_it_unchanged() {
    let bodies = unit_half_space();
    let gap = ball_gap(&bodies);
    let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0))
        .build()
        .unwrap();
    let expected = problem.solve().unwrap();
    let mut solver = problem.into_solver().unwrap();
    kit::assert_refused! {
        solver.set_load(NormalLoad::Force(-1.0)) => _,
        solver.set_gap(&Field::constant(bodies.grid(), f64::NAN)) => _,
    }
    let other = Grid::new(6, 8, 1.0, 1.0).unwrap();
    assert!(solver.set_gap(&Field::zeros(other)).is_err());
    let mut foreign = kit::solve(NormalProblem::builder(
        &unit_bodies(other, 0.3),
        Field::zeros(other),
        NormalLoad::Force(1.0),
    ));
    let before = foreign.clone();
    kit::assert_refused! {
        solver.solve_into(&mut foreign) => error if error == mismatch("solution", bodies.grid(), other),
    }
    assert_eq!(foreign, before);
    let solution = kit::solved(&mut solver);
    assert_eq!(solution.pressure(), expected.pressure());

    let load = TangentialLoad::force([0.1, 0.0]);
    let problem = TangentialProblem::builder(&bodies, &expected, kit::coulomb(0.5), load)
        .build()
        .unwrap();
    let expected = problem.solve().unwrap();
    let mut solver = problem.into_solver().unwrap();
    assert!(solver.set_load(TangentialLoad::force([0.6, 0.0])).is_err());
    assert!(solver.set_load(TangentialLoad::shift([1.0, 1.0])).is_err());
    kit::assert_refused! { solver.set_friction(&kit::coulomb(0.05)) => Error::BeyondFrictionCapacity { .. } }
    let foreign = Friction::per_cell(Field::zeros(other)).unwrap();
    kit::assert_refused! { solver.set_friction(&foreign) => Error::GridMismatch { .. } }
    let solution = kit::solved(&mut solver);
    assert_eq!(solution.traction(), expected.traction());
}

#[test]
fn tangential_load_beyond_capacity_or_not_finite_is_rejected() {
    let bodies = unit_half_space();
    let normal = press_ball(&bodies);
    let friction = kit::coulomb(0.5);
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
            kit::assert_refused! { build(load) => Error::NotFinite { value: v, .. } if is_identical(v, value) }
        }
    }
    kit::assert_refused! { build(TangentialLoad::force([0.1, 0.2])) => Error::ObliqueLoad { x: 0.1, y: 0.2, .. } }
    let Some(Error::BeyondFrictionCapacity { force, limit, .. }) =
        build(TangentialLoad::force([0.0, -0.51]))
    else {
        panic!("a force beyond the friction capacity was accepted");
    };
    assert!(is_identical(force, 0.51) && (limit - 0.5).abs() < 1e-12);
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
fn tangential_problem_with_unsuitable_pressure_is_rejected() {
    let bodies = unit_half_space();
    let normal = press_ball(&bodies);
    let friction = kit::coulomb(0.5);
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

    let apart = kit::solve(NormalProblem::builder(
        &bodies,
        ball_gap(&bodies),
        NormalLoad::Force(0.0),
    ));
    kit::assert_refused! {
        TangentialProblem::builder(&bodies, &apart, friction.clone(), TangentialLoad::force([0.0, 0.0])).build()
            => Error::EmptyContact,
        JaegerSuperposition::new(&apart, &apart, bodies.pair(), 0.5) => Error::EmptyContact,
        JaegerSuperposition::new(&normal, &apart, bodies.pair(), -0.5) => Error::NegativeOrNotFinite { .. },
    }

    // For a coupled pair, shear would change the prescribed pressure.
    let pair = ElasticPair::new(
        Material::new(200.0, 0.3).unwrap(),
        Material::new(1.0, 0.3).unwrap(),
    )
    .unwrap();
    let coupled = HalfSpace::new(bodies.grid(), pair).unwrap();
    let normal = press_ball(&coupled);
    let builder = || {
        TangentialProblem::builder(
            &coupled,
            &normal,
            friction.clone(),
            TangentialLoad::force([0.1, 0.0]),
        )
    };
    let asked = builder().coupling(Coupling::Full).build();
    let Some(Error::CoupledMaterials { beta, .. }) = asked.err() else {
        panic!("full coupling was accepted");
    };
    assert!((beta - pair.dundurs_beta()).abs() < 1e-15 && beta.abs() > 0.2);
    // Without coupling, the pressure causes no tangential displacement. With coupling, different tractions carry the
    // force.
    let [one_way, neglected] = [Coupling::OneWay, Coupling::Neglected]
        .map(|coupling| kit::solve(builder().coupling(coupling)));
    let by_default = kit::solve(builder());
    assert_eq!(by_default.traction(), one_way.traction());
    assert!(one_way.shift() != neglected.shift());
}

/// Cells whose sides differ only by round-off count as equal. Cells with a larger difference do not.
#[test]
fn grids_with_sides_equal_to_round_off_are_accepted() {
    let own = Grid::new(8, 6, 0.8 / 8.0, 0.6 / 6.0).unwrap();
    let bodies = unit_bodies(own, 0.3);
    let contact = |gap: &Field| {
        let problem = NormalProblem::builder(&bodies, gap, NormalLoad::Force(0.01));
        problem.tolerance(1e-12).build()?.solve()
    };
    let expected = contact(&kit::sphere(own, 2.0)).unwrap();
    let near = Grid::new(8, 6, 0.09999999999999999, 0.1 * (1.0 + 9e-13)).unwrap();
    assert_ne!(own, near);
    let found = contact(&kit::sphere(near, 2.0)).unwrap();
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
    let mut sum = kit::sphere(own, 2.0);
    assert_eq!(sum.add_scaled(1.0, &Field::zeros(near)), Ok(()));

    let far = Grid::new(8, 6, 0.1, 0.1 * (1.0 + 3e-12)).unwrap();
    assert_eq!(contact(&Field::zeros(far)), Err(mismatch("gap", own, far)));
    let other = Grid::new(6, 8, 0.1, 0.1).unwrap();
    assert!(contact(&Field::zeros(other)).is_err());
}

/// A pressure solved for other materials is rejected, but its field can be used with any bodies.
#[test]
fn solution_for_other_materials_is_rejected() {
    let bodies = unit_half_space();
    let normal = press_ball(&bodies);
    let softer = unit_bodies(bodies.grid(), 0.2);
    let foreign = press_ball(&softer);
    assert_eq!(foreign.pair(), softer.pair());
    let refused = |quantity| Err(Error::MaterialMismatch { quantity });
    let friction = kit::coulomb(0.5);
    let load = TangentialLoad::force([0.1, 0.0]);
    let builder = TangentialProblem::builder(&bodies, &foreign, friction.clone(), load);
    assert_eq!(builder.build().map(drop), refused("normal solution"));
    let builder = TangentialProblem::builder(&bodies, &normal, friction, load);
    let mut solver = kit::solver(builder);
    assert_eq!(solver.set_pressure(&foreign), refused("normal solution"));
    assert_eq!(solver.set_pressure(foreign.pressure()), Ok(()));

    let superposed = |full, stick| JaegerSuperposition::new(full, stick, bodies.pair(), 0.5);
    for (full, stick, quantity) in [
        (&foreign, &normal, "full contact"),
        (&normal, &foreign, "lighter contact"),
    ] {
        assert_eq!(superposed(full, stick).map(drop), refused(quantity));
    }

    // A solution that is overwritten by a solver belongs to the bodies of the solver.
    let (mut solution, gap) = (foreign, ball_gap(&bodies));
    let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0));
    let mut solver = kit::solver(problem);
    solver.solve_into(&mut solution).unwrap();
    assert_eq!(solution.pair(), normal.pair());
    assert_eq!(solution.pressure(), normal.pressure());
}

/// A load in the plane can have any direction, but its components must be finite.
#[test]
fn vector_loads_that_are_not_finite_or_too_large_are_rejected() {
    let bodies = unit_half_space();
    let normal = press_ball(&bodies);
    let build = |load| {
        let builder = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.5), load);
        builder.model(TangentialModel::Vector).build()
    };
    let problem = build(TangentialLoad::force([0.1, 0.2])).unwrap();
    let expected = problem.solve().unwrap();
    let mut solver = problem.into_solver().unwrap();
    for value in NOT_FINITE {
        for [x, y] in [[value, 0.1], [0.1, value]] {
            for load in [TangentialLoad::force([x, y]), TangentialLoad::shift([x, y])] {
                for refused in [build(load).err(), solver.set_load(load).err()] {
                    kit::assert_refused! { refused => Error::NotFinite { value: v, .. } if is_identical(v, value) }
                }
            }
        }
    }
    // Friction could carry each component alone.
    for load in [[0.4, 0.4], [-0.4, 0.4], [1e300, -1e300]] {
        let load = TangentialLoad::force(load);
        for refused in [build(load).err(), solver.set_load(load).err()] {
            kit::assert_refused! { refused => Error::BeyondFrictionCapacity { .. } }
        }
    }
    let solution = kit::solved(&mut solver);
    assert_eq!(solution.traction(), expected.traction());
}

/// A pressure that does not fit the load is rejected, and the solver keeps its previous pressure.
#[test]
fn tangential_solver_rejected_pressure_leaves_it_unchanged() {
    let bodies = unit_half_space();
    let normal = press_ball(&bodies);
    let other = unit_bodies(Grid::new(6, 8, 1.0, 1.0).unwrap(), 0.3);
    let gap = ball_gap(&bodies);
    let light = |force| {
        let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(force));
        kit::solve(problem)
    };
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        let load = TangentialLoad::force([0.2, 0.0]);
        let builder = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.5), load);
        let problem = builder.model(lateral).build().unwrap();
        let expected = problem.solve().unwrap();
        let mut solver = problem.into_solver().unwrap();
        let sliding = solver.friction_capacity();
        let refused = solver.set_pressure(&press_ball(&other)).unwrap_err();
        assert_eq!(
            refused,
            mismatch("normal solution", bodies.grid(), other.grid())
        );
        kit::assert_refused! {
            solver.set_pressure(&light(0.0)) => Error::EmptyContact,
            solver.set_pressure(&light(0.3)) => Error::BeyondFrictionCapacity { .. },
        }
        let unsolved = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0));
        let unsolved = kit::solver(unsolved).new_solution();
        kit::assert_refused! {
            solver.set_pressure(&unsolved) => Error::NotConverged(_),
            JaegerSuperposition::new(&normal, &unsolved, bodies.pair(), 0.5) => Error::NotConverged(_),
        }
        assert!(is_identical(solver.friction_capacity(), sliding));
        let solution = kit::solved(&mut solver);
        assert_eq!(solution.traction(), expected.traction());
    }
}

/// Loads near the limits of the floating-point range give a certified solution, or an error that contains the value.
#[test]
fn normal_loads_of_extreme_size_converge_or_are_rejected() {
    let bodies = unit_half_space();
    let gap = ball_gap(&bodies);
    let all = [5e-324, 1e-310, 1e-300, 1e-200, 1e-100, 1e100, 1e200, 1e300];
    for &value in kit::thorough(&[5e-324, 1e-300, 1e-100, 1e200][..], &all) {
        for load in [
            NormalLoad::Force(value),
            NormalLoad::Approach(value),
            NormalLoad::Approach(-value),
        ] {
            let problem = NormalProblem::builder(&bodies, &gap, load).build();
            match problem.and_then(|problem| problem.solve()) {
                Ok(contact) => {
                    assert!(contact.report().is_converged(), "{load:?}");
                    assert!(contact.pressure().min() >= 0.0 && contact.approach().is_finite());
                    if let NormalLoad::Force(force) = load {
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

/// Friction carries only a small tangential force. A shift of any size causes at most gross slip.
#[test]
fn tangential_loads_of_extreme_size_converge_or_are_rejected() {
    let bodies = unit_half_space();
    let normal = press_ball(&bodies);
    for value in [5e-324, 1e-310, 1e-300, 1e-200, 1e-100, 1e100, 1e200, 1e300] {
        for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
            for load in [
                TangentialLoad::force([0.0, value]),
                TangentialLoad::shift([0.0, value]),
                TangentialLoad::shift([0.0, -value]),
            ] {
                let builder = TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.5), load);
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

/// A setting that a model does not support causes an error in problems, solvers and histories.
#[test]
fn unsupported_method_is_rejected() {
    let bodies = unit_bodies(kit::square(24, 12.0), 0.3);
    let gap = kit::sphere(bodies.grid(), 20.0);
    let press = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(4.0));
    let normal = kit::solve(press);
    let friction = kit::coulomb(0.5);
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
    let mut solver = kit::solver(shear());
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
}

#[test]
fn step_all_with_wrong_number_of_loads_is_rejected() {
    let bodies = unit_half_space();
    let history = History::builder(&bodies, ball_gap(&bodies), kit::coulomb(0.3)).build();
    let mut histories = [history.unwrap()];
    let before = histories[0].to_bytes();
    let two = [LoadStep::hold().normal(NormalLoad::Force(1.0)); 2];
    for loads in [&two[..0], &two] {
        assert!(matches!(
            History::step_all(&mut histories, loads),
            Err(Error::Length { expected: 1, found, .. }) if found == loads.len()
        ));
    }
    assert_eq!(histories[0].to_bytes(), before);
    assert!(History::step_all(&mut [], &[]).unwrap().is_empty());
}
