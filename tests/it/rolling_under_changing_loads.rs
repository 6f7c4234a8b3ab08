//! A rolling solver accepts new loads and pressures, and its results equal the results of new problems.

use stickslip::history::EntryRule;
use stickslip::rolling::{
    LeadingEdge, RollingControl, RollingProblem, RollingSolution, RollingSolver, SpinControl,
};
use stickslip::{
    ElasticPair, Error, Field, HalfSpace, Material, NormalLoad, NormalProblem, NormalSolution,
    Warning, surface,
};

const FRICTION: f64 = 0.3;

fn bodies(cells: usize, pair: &ElasticPair) -> HalfSpace {
    HalfSpace::new(kit::square(cells, 3.0), *pair).unwrap()
}

fn similar_pair() -> ElasticPair {
    let body = Material::from_shear_modulus(1.0, 0.25).unwrap();
    ElasticPair::new(body, body).unwrap()
}

fn problem(bodies: &HalfSpace, load: f64) -> NormalProblem {
    NormalProblem::builder(
        bodies,
        kit::sphere(bodies.grid(), 1.0),
        NormalLoad::Force(load),
    )
    .tolerance(1e-11)
    .build()
    .unwrap()
}

fn pressed(bodies: &HalfSpace, load: f64) -> NormalSolution {
    problem(bodies, load).solve().unwrap()
}

fn rolling(
    bodies: &HalfSpace,
    normal: &NormalSolution,
    (edge, rule): (LeadingEdge, EntryRule),
) -> RollingSolver {
    kit::solver(
        RollingProblem::builder(bodies, normal, kit::coulomb(FRICTION))
            .leading_edge(edge)
            .entry_rule(rule)
            .tolerance(1e-10),
    )
}

/// Asserts that tractions agree to `part` of the largest traction, and creepages and spins as well.
fn assert_close(found: &RollingSolution, expected: &RollingSolution, part: f64) {
    let fields = found.traction().into_iter().zip(expected.traction());
    let (mut largest, mut missed) = (0.0_f64, 0.0_f64);
    for (found, expected) in fields {
        for (found, expected) in found.as_slice().iter().zip(expected.as_slice()) {
            largest = largest.max(expected.abs());
            missed = missed.max((found - expected).abs());
        }
    }
    assert!(
        missed <= part * largest,
        "difference {missed}, largest traction {largest}"
    );
    for axis in 0..2 {
        let missed = found.creepage()[axis] - expected.creepage()[axis];
        assert!(missed.abs() <= part, "creepage {missed}");
    }
    assert!((found.spin() - expected.spin()).abs() <= part);
    let bounds = [found, expected].map(|rolling| rolling.report().duality_gap);
    assert!(bounds.iter().all(|bound| *bound <= 1e-10), "{bounds:?}");
}

/// The contact grows beyond its first window, shrinks, and grows again.
#[test]
fn rolling_solver_under_new_pressures_agrees_with_new_problems() {
    let rubber_on_glass = ElasticPair::new(
        Material::new(1.0, 0.3).unwrap(),
        Material::new(50.0, 0.2).unwrap(),
    );
    for (pair, edge, rule) in [
        (similar_pair(), LeadingEdge::PlusX, EntryRule::SinceTouch),
        (similar_pair(), LeadingEdge::MinusY, EntryRule::SinceTouch),
        (similar_pair(), LeadingEdge::PlusX, EntryRule::WholeStep),
        (
            rubber_on_glass.unwrap(),
            LeadingEdge::MinusX,
            EntryRule::SinceTouch,
        ),
    ] {
        let bodies = bodies(16, &pair);
        let mut solver = rolling(&bodies, &pressed(&bodies, 0.4), (edge, rule));
        let creepages = [0.03, -0.02].map(RollingControl::Creepage);
        let drag = [RollingControl::Force(0.05), RollingControl::Creepage(0.01)];
        for (load, controls, spin) in [
            (0.4, creepages, SpinControl::Spin(0.02)),
            (1.0, creepages, SpinControl::Spin(0.03)),
            (0.5, drag, SpinControl::Spin(0.03)),
            (0.9, drag, SpinControl::Moment(0.01)),
            (1.1, creepages, SpinControl::Spin(-0.05)),
        ] {
            let normal = pressed(&bodies, load);
            solver.set_pressure(&normal).unwrap();
            solver.set_load(controls, spin).unwrap();
            let mut new = rolling(&bodies, &normal, (edge, rule));
            new.set_load(controls, spin).unwrap();
            assert_close(&kit::solved(&mut solver), &kit::solved(&mut new), 1e-6);
            assert!((solver.friction_capacity() - FRICTION * load).abs() < 1e-9);
        }
    }
}

#[test]
fn rolling_solver_finds_the_pressure_of_a_new_load() {
    let bodies = bodies(24, &similar_pair());
    let by_default = (LeadingEdge::PlusX, EntryRule::SinceTouch);
    let mut solver = rolling(&bodies, &pressed(&bodies, 1.0), by_default);
    let refused = solver.set_normal_load(NormalLoad::Force(0.7)).unwrap_err();
    assert!(
        refused.to_string().contains("set a normal solver first"),
        "{refused}"
    );
    let press = problem(&bodies, 1.0).into_solver().unwrap();
    solver.set_normal_solver(press).unwrap();
    assert!(solver.normal().is_none());
    for (load, creepage) in [(0.7, 0.02), (1.2, 0.03), (0.6, 0.05)] {
        let controls = [creepage, 0.01].map(RollingControl::Creepage);
        solver.set_normal_load(NormalLoad::Force(load)).unwrap();
        solver.set_load(controls, SpinControl::Spin(0.02)).unwrap();
        assert!((solver.normal().unwrap().force() - load).abs() < 1e-9);
        let mut new = rolling(&bodies, &pressed(&bodies, load), by_default);
        new.set_load(controls, SpinControl::Spin(0.02)).unwrap();
        let expected = kit::solved(&mut new);
        // A copy continues like the original solver.
        let mut copy = solver.clone();
        let found = [kit::solved(&mut solver), kit::solved(&mut copy)];
        assert_close(&found[0], &expected, 1e-6);
        assert_eq!(found[0].traction(), found[1].traction());
    }
}

/// A pressure without a gap cannot be combined with the entry rule.
#[test]
fn rolling_solver_accepts_pressure_field_without_entry_law() {
    let bodies = bodies(24, &similar_pair());
    let [first, normal] = [0.6, 1.0].map(|load| pressed(&bodies, load));
    let creepages = [0.03, -0.02].map(RollingControl::Creepage);
    let of = |rule| {
        let mut solver = rolling(&bodies, &first, (LeadingEdge::PlusX, rule));
        solver.set_load(creepages, SpinControl::Spin(0.02)).unwrap();
        solver
    };
    let mut by_field = of(EntryRule::WholeStep);
    let mut by_solution = by_field.clone();
    by_field.set_pressure(normal.pressure()).unwrap();
    by_solution.set_pressure(&normal).unwrap();
    let found = kit::solved(&mut by_field);
    assert_eq!(found.traction(), kit::solved(&mut by_solution).traction());
    kit::assert_refused! {
        of(EntryRule::SinceTouch).set_pressure(normal.pressure()) => Error::UnsupportedByModel { .. },
    }
}

#[test]
fn rejected_load_leaves_rolling_solver_unchanged() {
    let bodies = bodies(24, &similar_pair());
    let mut solver = rolling(
        &bodies,
        &pressed(&bodies, 1.0),
        (LeadingEdge::PlusX, EntryRule::SinceTouch),
    );
    let press = problem(&bodies, 1.0).into_solver().unwrap();
    solver.set_normal_solver(press).unwrap();
    let drag = [RollingControl::Force(0.2), RollingControl::Creepage(0.01)];
    solver.set_load(drag, SpinControl::Spin(0.02)).unwrap();
    solver.set_normal_load(NormalLoad::Force(0.9)).unwrap();
    let mut rolling = kit::solved(&mut solver);
    let stiffness = solver.stiffness().unwrap();

    let other = self::bodies(25, &similar_pair());
    let harder = Material::from_shear_modulus(2.0, 0.25).unwrap();
    let harder = self::bodies(24, &ElasticPair::new(harder, harder).unwrap());
    let untouched = solver.clone();
    let grid = bodies.grid();
    let is_refused = [
        matches!(
            solver.set_pressure(&pressed(&other, 1.0)),
            Err(Error::GridMismatch { .. })
        ),
        matches!(
            solver.set_pressure(&pressed(&harder, 1.0)),
            Err(Error::MaterialMismatch { .. })
        ),
        matches!(
            solver.set_pressure(&Field::zeros(grid)),
            Err(Error::UnsupportedByModel { .. })
        ),
        matches!(
            solver.set_normal_solver(problem(&other, 1.0).into_solver().unwrap()),
            Err(Error::GridMismatch { .. })
        ),
        // Covers a load too small for the prescribed force, a zero load, and a load whose contact leaves no room ahead.
        matches!(
            solver.set_normal_load(NormalLoad::Force(0.5)),
            Err(Error::BeyondFrictionCapacity { .. })
        ),
        matches!(
            solver.set_normal_load(NormalLoad::Force(0.0)),
            Err(Error::EmptyContact)
        ),
        matches!(
            solver.set_normal_load(NormalLoad::Force(20.0)),
            Err(Error::GridTooShort { .. })
        ),
        matches!(
            solver.set_normal_load(NormalLoad::Force(-1.0)),
            Err(Error::NegativeOrNotFinite { .. })
        ),
    ];
    assert_eq!(is_refused, [true; 8]);
    assert_eq!(solver.normal(), untouched.normal());
    assert_eq!(solver.stiffness().unwrap(), stiffness);
    let again = kit::solved(&mut solver);
    assert_eq!(
        again.traction(),
        kit::solved(&mut untouched.clone()).traction()
    );
    solver.set_normal_load(NormalLoad::Force(1.0)).unwrap();
    solver.solve_into(&mut rolling).unwrap();
    assert!((rolling.force()[0] - 0.2).abs() < 1e-9);
}

/// After a new pressure the call for the stiffness returns an error until the next solve, for any window of the new
/// contact.
#[test]
fn stiffness_after_new_pressure_requires_solve() {
    let bodies = bodies(24, &similar_pair());
    let by_default = (LeadingEdge::PlusX, EntryRule::SinceTouch);
    let [light, heavy] = [0.5, 1.1].map(|load| pressed(&bodies, load));
    let mut solver = rolling(&bodies, &light, by_default);
    // Before the first solve the stiffness is the stiffness of full stick.
    solver.set_pressure(&heavy).unwrap();
    let expected = rolling(&bodies, &heavy, by_default).stiffness().unwrap();
    let check = |found: [[f64; 3]; 3], expected: [[f64; 3]; 3]| {
        for (found, expected) in found.as_flattened().iter().zip(expected.as_flattened()) {
            let missed = (found - expected).abs();
            assert!(
                missed < 1e-7 * expected.abs().max(0.1),
                "{found} {expected}"
            );
        }
    };
    check(solver.stiffness().unwrap(), expected);

    let mut solver = rolling(&bodies, &light, by_default);
    let controls = [RollingControl::Force(0.05), RollingControl::Creepage(0.01)];
    solver.set_load(controls, SpinControl::Spin(0.03)).unwrap();
    kit::solved(&mut solver);
    assert!(solver.stiffness().is_ok());
    for normal in [&heavy, &light] {
        solver.set_pressure(normal).unwrap();
        kit::assert_refused! { solver.stiffness() => Error::OutdatedSolution { changed: "the pressure", .. } }
        let solution = kit::solved(&mut solver);
        let mut fresh = rolling(&bodies, normal, by_default);
        fresh.set_load(controls, SpinControl::Spin(0.03)).unwrap();
        let expected = kit::solved(&mut fresh);
        assert!((solution.moment() / expected.moment() - 1.0).abs() < 1e-6);
        check(solver.stiffness().unwrap(), fresh.stiffness().unwrap());
    }
}

/// In a time loop of a vehicle, a solve starts from scaled and extrapolated tractions.
#[test]
fn vehicle_time_loop_takes_few_products() {
    let bodies = bodies(24, &similar_pair());
    let press = problem(&bodies, 1.0);
    let normal = press.solve().unwrap();
    let problem = RollingProblem::builder(&bodies, &normal, kit::coulomb(0.3));
    let problem = problem.tolerance(1e-3).build().unwrap();
    let products = |is_reset: bool| {
        let mut solver = problem.clone().into_solver().unwrap();
        solver
            .set_normal_solver(press.clone().into_solver().unwrap())
            .unwrap();
        let mut rolling = solver.new_solution();
        let mut products = 0;
        for step in 0..30 {
            let phase = 0.05 * f64::from(step);
            let load = NormalLoad::Force(1.0 + 0.25 * (1.7 * phase).sin());
            let creepages = [0.1 * phase.sin(), 0.05 * phase.cos()];
            if is_reset {
                solver.reset();
            }
            solver.set_normal_load(load).unwrap();
            let controls = creepages.map(RollingControl::Creepage);
            solver
                .set_load(controls, SpinControl::Spin(0.03 * phase.sin()))
                .unwrap();
            solver.solve_into(&mut rolling).unwrap();
            let report = rolling.report();
            products += report.single_precision_products + report.double_precision_products;
        }
        products
    };
    let [warm, cold] = [false, true].map(products);
    assert!(3 * warm < 2 * cold, "{warm} products, {cold} from rest");
}

#[test]
fn rolling_solution_warns_of_contact_at_edge() {
    let bodies = bodies(24, &similar_pair());
    let by_default = (LeadingEdge::PlusX, EntryRule::SinceTouch);
    let fine = kit::solved(&mut rolling(&bodies, &pressed(&bodies, 1.0), by_default));
    assert_eq!(fine.warnings(), []);
    let coarse = kit::solved(&mut rolling(&bodies, &pressed(&bodies, 0.02), by_default));
    assert!(matches!(
        coarse.warnings()[..],
        [Warning::UnderresolvedContact { .. }]
    ));
    // The contact is an ellipse that is long across the rolling direction, so that it leaves the grid at the sides.
    let gap = surface::ellipsoid(bodies.grid(), 1.0, 10.0).unwrap();
    let press = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0));
    let normal = kit::solve(press);
    let wide = kit::solved(&mut rolling(&bodies, &normal, by_default)).warnings();
    assert!(
        wide.iter()
            .any(|warning| matches!(warning, Warning::ContactAtEdge { .. })),
        "{wide:?}"
    );
}

/// The normal contact of the solver is the contact of its pressure, or absent.
#[test]
fn normal_contact_is_absent_after_a_new_pressure() {
    let bodies = bodies(24, &similar_pair());
    let [first, second] = [1.0, 0.8].map(|load| pressed(&bodies, load));
    let mut solver = rolling(&bodies, &first, (LeadingEdge::PlusX, EntryRule::WholeStep));
    assert!(solver.normal().is_none());
    solver
        .set_normal_solver(problem(&bodies, 1.0).into_solver().unwrap())
        .unwrap();
    assert!(solver.normal().is_none());
    solver.set_normal_load(NormalLoad::Force(0.9)).unwrap();
    let force = |solver: &RollingSolver| solver.normal().map(NormalSolution::force);
    assert!((force(&solver).unwrap() - 0.9).abs() < 1e-9);
    solver.set_pressure(&second).unwrap();
    assert_eq!(force(&solver), None);
    // A rejected load leaves the pressure and its contact unchanged.
    assert!(solver.set_normal_load(NormalLoad::Force(-1.0)).is_err());
    assert_eq!(force(&solver), None);
    solver.set_normal_load(NormalLoad::Force(0.7)).unwrap();
    assert!((force(&solver).unwrap() - 0.7).abs() < 1e-9);
    assert!(solver.set_normal_load(NormalLoad::Force(-1.0)).is_err());
    assert!((force(&solver).unwrap() - 0.7).abs() < 1e-9);
    assert!(
        solver
            .set_pressure(&surface::sphere(bodies.grid(), 1.0).unwrap().scaled(-1.0))
            .is_err()
    );
    assert!((force(&solver).unwrap() - 0.7).abs() < 1e-9);
}
