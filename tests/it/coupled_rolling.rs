//! Rolling of dissimilar bodies with full coupling of pressure and traction. The tests compare solutions with numbers
//! of CONTACT, closed forms and limits. They also check that errors are below the reported estimates.

use std::ops::ControlFlow;

use proptest::prelude::*;
use stickslip::analytical::{BentallJohnson, HertzLine};
use stickslip::history::{EntryRule, Rolling};
use stickslip::rolling::{
    CoupledRollingProblem, CoupledRollingProblemBuilder, CoupledRollingSolution,
    CoupledRollingSolver, LeadingEdge, RollingControl, RollingProblem, SpinControl,
};
use stickslip::{
    Axis, Boundary, Coupling, ElasticPair, Error, Field, Grid, HalfSpace, History, LoadStep,
    Material, NormalLoad, NormalProblem, Operator, TangentialModel, Warning, Zone, surface,
};

fn against_rigid(grid: Grid, poisson_ratio: f64) -> HalfSpace {
    let body = Material::from_shear_modulus(1.0, poisson_ratio).unwrap();
    HalfSpace::new(grid, ElasticPair::new(body, Material::rigid()).unwrap()).unwrap()
}

/// Returns a ball of radius one on a square grid with the given number of cells along a side. Without friction, the
/// load gives a contact radius of one.
fn ball_problem(cells: usize, poisson_ratio: f64) -> (HalfSpace, Field, NormalLoad) {
    let grid = kit::square(cells, 2.6);
    let bodies = against_rigid(grid, poisson_ratio);
    let load = NormalLoad::Force(4.0 / 3.0 * bodies.pair().contact_modulus());
    (bodies, kit::sphere(grid, 1.0), load)
}

fn coupled_builder(
    (bodies, gap, load): &(HalfSpace, Field, NormalLoad),
    coefficient: f64,
) -> CoupledRollingProblemBuilder {
    CoupledRollingProblem::builder(bodies, gap, kit::coulomb(coefficient), *load)
}

fn solve(builder: CoupledRollingProblemBuilder) -> CoupledRollingSolution {
    kit::solve(builder)
}

fn zone_cells(rolling: &CoupledRollingSolution) -> [usize; 2] {
    let zones = rolling.rolling().zones();
    [Zone::Stick, Zone::Slip].map(|zone| zones.iter().filter(|z| **z == zone).count())
}

/// Compares with the example `bentall` of CONTACT (E. A. H. Vollebregt, Apache-2.0), cases 3 to 6, with an aluminium
/// roller on a steel roller. The printed creepages and forces have four digits. CONTACT alternates between pressure and
/// traction until both no longer change. If the change of the pressure is neglected, the creepages of CONTACT are
/// 3.628e-4, 4.281e-4, 2.094e-4 and 5.388e-4. No case then has 201 cells in contact. CONTACT defines the creepage as
/// the motion of body 1, so it has the opposite sign.
#[test]
fn coupled_rollers_match_printed_digits_of_contact() {
    let grid = Grid::new(216, 1, 0.001, 1000.0).unwrap();
    let (aluminium, steel) = (
        Material::from_shear_modulus(23_000.0, 0.31).unwrap(),
        Material::from_shear_modulus(82_000.0, 0.28).unwrap(),
    );
    let bodies = HalfSpace::new(grid, ElasticPair::new(aluminium, steel).unwrap()).unwrap();
    let (gap, load) = (Field::from_fn(grid, |x, _| 0.02 * x * x), 16_201.9);
    let pressed = (bodies, gap, NormalLoad::Force(load));
    let cases = [
        (10.0, 0.0, 3.591e-4, [200, 0], 103.8),
        (0.05, 0.0, 4.294e-4, [125, 75], 103.6),
        (0.05, 0.75, 2.108e-4, [36, 164], 103.2),
        (0.05, -0.75, 5.392e-4, [106, 95], 103.3),
    ];
    for (friction, part, creepage, zones, peak) in cases {
        let limit = friction * load;
        let rolling = solve(
            coupled_builder(&pressed, friction)
                .leading_edge(LeadingEdge::MinusX)
                .control(Axis::X, RollingControl::Force(part * limit))
                .entry_rule(EntryRule::WholeStep)
                .tolerance(1e-7),
        );
        let (found, force) = (
            -rolling.rolling().creepage()[0],
            rolling.rolling().force()[0],
        );
        assert!(
            (found - creepage).abs() <= 0.5001e-7,
            "{found:e} for {creepage:e}"
        );
        assert!((force / limit - part).abs() < 1e-6, "{force} for {part}");
        assert_eq!(zone_cells(&rolling), zones);
        assert!((rolling.normal().pressure().max() - peak).abs() <= 0.05);
    }
}

/// Returns the energy norm of the difference of two pressures, relative to the energy norm of the second.
fn pressure_error(bodies: &HalfSpace, found: &Field, exact: &Field) -> f64 {
    let operator = bodies
        .operator(stickslip::influence::Component::ZZ)
        .unwrap();
    let energy = |p: &[f64]| {
        let mut u = vec![0.0; p.len()];
        let mut scratch = operator.scratch().unwrap();
        operator.apply([p], [&mut u], &mut scratch);
        p.iter().zip(&u).map(|(p, u)| p * u).sum::<f64>()
    };
    let pairs = found.as_slice().iter().zip(exact.as_slice());
    let difference: Vec<f64> = pairs.map(|(a, b)| a - b).collect();
    (energy(&difference) / energy(exact.as_slice())).sqrt()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(4, 100)))]

    /// Covers rough gaps of random pairs under creepages, forces and spin. The solve converges, and the estimated error
    /// of the pressure exceeds the difference from the solution for a smaller tolerance.
    #[test]
    fn coupled_rolling_of_random_scenes_is_within_error_estimate(
        poisson in 0.0..0.5_f64, stiff in 1.0..50.0_f64, other in 0.0..0.45_f64, roughness in 0.0..0.02_f64,
        creepage in prop::array::uniform2(-0.3..0.3_f64), spin in -0.3..0.3_f64,
        fraction in prop::option::of(-0.95..0.95_f64), friction in 0.05..1.0_f64, digits in 2..7_i32,
        depth in prop::option::of(0.2..0.6_f64),
    ) {
        let grid = Grid::new(20, 18, 0.14, 0.16).unwrap();
        let one = Material::from_shear_modulus(1.0, poisson).unwrap();
        let two = Material::from_shear_modulus(stiff, other).unwrap();
        let bodies = HalfSpace::new(grid, ElasticPair::new(one, two).unwrap()).unwrap();
        let gap = Field::from_fn(grid, |x, y| {
            0.5 * (x * x + y * y) + roughness * (9.0 * x).cos() * (7.0 * y + 1.0).cos()
        });
        let load = depth.map_or(NormalLoad::Force(1.0), NormalLoad::Approach);
        let pressed = (bodies, gap, load);
        let problem = |tolerance: f64| {
            let builder = coupled_builder(&pressed, friction).creepage(creepage).spin(spin).tolerance(tolerance);
            let builder = match fraction.filter(|_| depth.is_none()) {
                Some(fraction) => builder.control(Axis::X, RollingControl::Force(fraction * friction)),
                None => builder,
            };
            builder.build().unwrap().solve()
        };
        let tight = problem(1e-10);
        prop_assert!(tight.is_ok(), "{:?}", tight.err());
        let rough = problem(10_f64.powi(-digits)).unwrap();
        let error = pressure_error(&pressed.0, rough.normal().pressure(), tight.unwrap().normal().pressure());
        let estimate = rough.report().error_estimate.unwrap();
        prop_assert!(error <= estimate + 1e-9, "{error:e} {estimate:e}");
    }
}

/// The derivatives include the changes of the pressure and of the friction limits, and the entry rule.
#[test]
fn coupled_stiffness_matches_finite_differences() {
    for (entry_rule, poisson_ratio, motion) in [
        (EntryRule::WholeStep, 0.0, [0.1, 0.06, 0.08]),
        (EntryRule::SinceTouch, 0.4, [0.04, 0.02, 0.03]),
    ] {
        let pressed = ball_problem(18, poisson_ratio);
        let at = |motion: [f64; 3]| {
            let builder = coupled_builder(&pressed, 0.4)
                .entry_rule(entry_rule)
                .tolerance(1e-11);
            builder
                .creepage([motion[0], motion[1]])
                .spin(motion[2])
                .build()
                .unwrap()
        };
        let mut solver = at(motion).into_solver().unwrap();
        assert!(matches!(solver.stiffness(), Err(Error::NotConverged(_))));
        let rolling = kit::solved(&mut solver);
        let stiffness = solver.stiffness().unwrap();
        let most = stiffness[0][0].abs();
        let one_way = stiffness_at_fixed_pressure(&pressed, &rolling, motion, entry_rule);
        let mut change: f64 = 0.0;
        for column in 0..3 {
            let step = 2e-5;
            let [more, less] = [step, -step].map(|step| {
                let mut motion = motion;
                motion[column] += step;
                let rolling = at(motion).solve().unwrap();
                let [x, y] = rolling.rolling().force();
                [x, y, rolling.rolling().moment()]
            });
            for row in 0..3 {
                let slope = (more[row] - less[row]) / (2.0 * step);
                let found = stiffness[row][column];
                assert!(
                    (found - slope).abs() < 1e-4 * most,
                    "{row} {column}: {found} {slope}"
                );
                change = change.max((one_way[row][column] - slope).abs());
            }
        }
        // The derivatives at constant pressure differ.
        assert!(change > 3e-3 * most, "{change}");
    }
}

/// Computes the stiffness for the fixed pressure of a solution.
fn stiffness_at_fixed_pressure(
    (bodies, ..): &(HalfSpace, Field, NormalLoad),
    rolling: &CoupledRollingSolution,
    motion: [f64; 3],
    entry_rule: EntryRule,
) -> [[f64; 3]; 3] {
    let mut solver = kit::solver(
        RollingProblem::builder(bodies, rolling.normal(), kit::coulomb(0.4))
            .creepage([motion[0], motion[1]])
            .spin(motion[2])
            .entry_rule(entry_rule),
    );
    let _solution = kit::solved(&mut solver);
    solver.stiffness().unwrap()
}

/// For nearly uncoupled bodies and for weak friction, the solution tends to the solution of one-way coupling.
#[test]
fn weak_coupling_and_weak_friction_tend_to_one_way_coupling() {
    let differences = |poisson_ratio: f64, coefficient: f64| {
        let pressed = ball_problem(20, poisson_ratio);
        let both = solve(coupled_builder(&pressed, coefficient).creepage([0.6, 0.0]));
        let smooth = NormalProblem::builder(&pressed.0, &pressed.1, pressed.2);
        let smooth = kit::solve(smooth);
        pressure_error(&pressed.0, both.normal().pressure(), smooth.pressure())
    };
    let [strong, weak, weakest] = [0.0, 0.45, 0.495].map(|nu| differences(nu, 0.3));
    // The values of the coupling strength are 0.5, 0.091 and 0.0099.
    assert!((weak / strong / 0.182 - 1.0).abs() < 0.3, "{strong} {weak}");
    assert!(
        (weakest / weak / 0.109 - 1.0).abs() < 0.1,
        "{weak} {weakest}"
    );
    let [little, least] = [1e-2, 1e-3].map(|mu| differences(0.0, mu));
    assert!((least / little / 0.1 - 1.0).abs() < 0.1, "{little} {least}");
}

/// For weak friction, the creepage of free rollers agrees with Bentall and Johnson, and the pressure hardly changes.
#[test]
fn coupled_free_rollers_match_bentall_johnson() {
    let (radius, load, friction, cells) = (10.0, 100.0, 1e-4, 128);
    let (one, two) = (
        Material::new(1e3, 0.2).unwrap(),
        Material::new(1e5, 0.3).unwrap(),
    );
    for pair in [ElasticPair::new(one, two), ElasticPair::new(two, one)] {
        let pair = pair.unwrap();
        let hertz = HertzLine::new(&pair, radius, load).unwrap();
        let free = BentallJohnson::new(hertz, friction).unwrap();
        let grid = Grid::line(cells + 8, 2.0 * hertz.half_width() / cells as f64).unwrap();
        let boundary = Boundary::PeriodicAlongY { datum: 50.0 };
        let bodies = HalfSpace::with_boundary(grid, pair, boundary).unwrap();
        let gap = surface::cylinder(grid, radius).unwrap();
        let problem = coupled_builder(&(bodies, gap, NormalLoad::Force(load)), friction);
        let rolling = solve(problem.control(Axis::X, RollingControl::Force(0.0)));
        let creepage = rolling.rolling().creepage()[0];
        assert!(
            (creepage / free.creepage() - 1.0).abs() < 2e-3,
            "{creepage:e}"
        );
    }
}

#[test]
fn coupled_rolling_solver_starts_from_last_solution() {
    let pressed = ball_problem(20, 0.2);
    let mut solver = kit::solver(coupled_builder(&pressed, 0.3));
    let mut rolling = kit::solved(&mut solver);
    let cold = rolling.report().work.products();
    let moved = [
        RollingControl::Creepage(0.002),
        RollingControl::Creepage(0.0),
    ];
    solver.set_load(moved, SpinControl::Spin(0.0)).unwrap();
    solver.solve_into(&mut rolling).unwrap();
    assert!(rolling.report().work.products() < cold);
    let alone = solve(coupled_builder(&pressed, 0.3).creepage([0.002, 0.0]));
    let [found, expected] = [&rolling, &alone].map(|rolling| rolling.rolling().force()[0]);
    assert!((found - expected).abs() < 1e-8, "{found} {expected}");
    // Solve for a different load, gap and friction, then reset to a cold start.
    solver.set_normal_load(NormalLoad::Force(0.5)).unwrap();
    solver.set_friction(&kit::coulomb(0.2)).unwrap();
    solver.set_gap(&kit::sphere(pressed.0.grid(), 1.1)).unwrap();
    solver.solve_into(&mut rolling).unwrap();
    assert!((rolling.normal().force() - 0.5).abs() < 1e-9);
    solver.reset();
    let again = kit::solved(&mut solver);
    let [found, expected] = [&rolling, &again].map(|rolling| rolling.rolling().force()[0]);
    assert!((found - expected).abs() < 1e-8, "{found} {expected}");
}

#[test]
fn coupled_rolling_with_invalid_input_is_rejected() {
    let pressed = ball_problem(16, 0.2);
    let builder = || coupled_builder(&pressed, 0.3);
    kit::assert_refused! {
        builder().creepage([f64::NAN, 0.0]).build() => Error::NotFinite { .. },
        builder().step(0).build() => Error::NotPositive { .. },
        builder().tolerance(0.0).build() => Error::Tolerance(_),
    }
    // A prescribed normal force bounds the capacity before the solve.
    let dragged = |force: f64| builder().control(Axis::X, RollingControl::Force(force));
    let NormalLoad::Force(press) = pressed.2 else {
        panic!("the scene prescribes a force");
    };
    kit::assert_refused! { dragged(0.301 * press).build() => Error::BeyondFrictionCapacity { .. } }
    let mut solver = dragged(0.2 * press).build().unwrap().into_solver().unwrap();
    let controls = |force: f64| [RollingControl::Force(force), RollingControl::Creepage(0.0)];
    kit::assert_refused! {
        solver.set_load(controls(-0.301 * press), SpinControl::Spin(0.0)) => Error::BeyondFrictionCapacity { .. },
        solver.set_normal_load(NormalLoad::Force(0.6 * press)) => Error::BeyondFrictionCapacity { .. },
        solver.set_friction(&kit::coulomb(0.1)) => Error::BeyondFrictionCapacity { .. },
    }
    solver
        .set_load(controls(0.05 * press), SpinControl::Spin(0.0))
        .unwrap();
    solver
        .set_normal_load(NormalLoad::Force(0.6 * press))
        .unwrap();
    // The capacity under a prescribed approach follows from the solve.
    let deep = (
        pressed.0.clone(),
        pressed.1.clone(),
        NormalLoad::Approach(0.05),
    );
    let deep = coupled_builder(&deep, 0.3).control(Axis::X, RollingControl::Force(1e9 * press));
    kit::assert_refused! { deep.build().unwrap().solve() => Error::BeyondFrictionCapacity { .. } }
    let apart = (
        pressed.0.clone(),
        pressed.1.clone(),
        NormalLoad::Approach(-1.0),
    );
    kit::assert_refused! { coupled_builder(&apart, 0.3).build().unwrap().solve() => Error::EmptyContact }
    let waves = HalfSpace::with_boundary(pressed.0.grid(), *pressed.0.pair(), Boundary::Periodic);
    let waves = (waves.unwrap(), pressed.1.clone(), pressed.2);
    kit::assert_refused! { coupled_builder(&waves, 0.3).build() => Error::UnsupportedByModel { .. } }
}

#[test]
fn one_way_rolling_of_dissimilar_bodies_warns_of_neglected_lift() {
    let (bodies, gap, load) = ball_problem(20, 0.2);
    let normal = kit::solve(NormalProblem::builder(&bodies, &gap, load));
    let one_way = |coefficient: f64, tolerance: f64| {
        kit::solve(
            RollingProblem::builder(&bodies, &normal, kit::coulomb(coefficient))
                .creepage([0.05, 0.0])
                .tolerance(tolerance),
        )
    };
    let warned = one_way(0.3, 1e-8).warnings();
    let [Warning::NeglectedLift { per_million }] = warned[..] else {
        panic!("{warned:?}");
    };
    // The first pass of the coupled solve has the same lift, so the change of the pressure is of similar size.
    let both =
        solve(coupled_builder(&(bodies.clone(), gap.clone(), load), 0.3).creepage([0.05, 0.0]));
    assert_eq!(both.rolling().warnings(), []);
    let change = both.normal().pressure().max() / normal.pressure().max() - 1.0;
    let lift = 1e-6 * per_million as f64;
    assert!(
        lift > 0.3 * change && lift < 10.0 * change,
        "{lift} {change}"
    );
    // A point of a creep curve has the warning too.
    let problem = RollingProblem::builder(&bodies, &normal, kit::coulomb(0.3)).build();
    let mut solver = problem.unwrap().into_solver().unwrap();
    let points = solver.creep_forces([[0.05, 0.0, 0.0]]).unwrap();
    assert_eq!(points[0].warnings(), warned);
    // The neglected lift is within the tolerance.
    assert_eq!(one_way(1e-5, 1e-2).warnings(), []);

    let history = |coupling: Coupling| {
        let builder = History::builder(&bodies, &gap, kit::coulomb(0.3));
        let builder = builder.model(TangentialModel::Vector).coupling(coupling);
        let mut history = builder.build().unwrap();
        let rolled = Rolling::new(1).creepage([0.05, 0.0]);
        history.step(&LoadStep::hold().normal(load)).unwrap();
        let is_lift = |warning: &Warning| matches!(warning, Warning::NeglectedLift { .. });
        assert!(!history.last_step().unwrap().warnings().iter().any(is_lift));
        let step = history.step(&LoadStep::hold().roll(rolled)).unwrap();
        step.warnings().iter().any(is_lift)
    };
    assert!(history(Coupling::OneWay));
    assert!(!history(Coupling::Full) && !history(Coupling::Neglected));
}

/// The pressure and traction of a history in continued rolling converge to coupled steady rolling.
#[test]
fn coupled_history_converges_to_coupled_steady_rolling() {
    let pressed = ball_problem(16, 0.0);
    let (bodies, gap, load) = &pressed;
    for entry_rule in [EntryRule::SinceTouch, EntryRule::WholeStep] {
        let (creepage, spin) = ([0.12, 0.06], 0.1);
        let mut history = History::builder(bodies, gap, kit::coulomb(0.3))
            .entry_rule(entry_rule)
            .tolerance(1e-9)
            .build()
            .unwrap();
        let rolling = Rolling::new(1).creepage(creepage).spin(spin);
        for _ in 0..200 {
            history
                .step(&LoadStep::hold().normal(*load).roll(rolling))
                .unwrap();
        }
        let steady = solve(
            coupled_builder(&pressed, 0.3)
                .creepage(creepage)
                .spin(spin)
                .entry_rule(entry_rule)
                .tolerance(1e-9),
        );
        let most = steady.normal().pressure().max();
        let pairs = [
            (history.pressure(), steady.normal().pressure()),
            (history.traction()[0], steady.rolling().traction()[0]),
            (history.traction()[1], steady.rolling().traction()[1]),
        ];
        for (found, expected) in pairs {
            for (found, expected) in found.as_slice().iter().zip(expected.as_slice()) {
                assert!((found - expected).abs() < 1e-5 * most, "{found} {expected}");
            }
        }
        assert_eq!(history.zones(), steady.rolling().zones());
    }
}

/// A force and a normal load that are admissible together are set together. An error changes neither.
#[test]
fn loads_of_coupled_rolling_are_set_together() {
    let bodies = HalfSpace::new(kit::square(24, 3.0), kit::on_rigid(1.0, 0.0)).unwrap();
    let (ball, friction) = (kit::sphere(bodies.grid(), 1.0), kit::coulomb(0.3));
    let drag = |force: f64| [RollingControl::Force(force), RollingControl::Creepage(0.0)];
    let new = || {
        let load = NormalLoad::Force(1.0);
        let problem = CoupledRollingProblem::builder(&bodies, &ball, friction.clone(), load);
        kit::solver(problem.control(Axis::X, RollingControl::Force(0.25)))
    };
    let mut solver = new();
    let unchanged = |solver: &CoupledRollingSolver| format!("{solver:?}");
    let before = unchanged(&solver);
    assert!(solver.set_normal_load(NormalLoad::Force(0.5)).is_err());
    let beyond = solver.set_loads(NormalLoad::Force(0.5), drag(0.2), SpinControl::Spin(0.0));
    kit::assert_refused! { beyond => Error::BeyondFrictionCapacity { .. } }
    let infinite = solver.set_loads(
        NormalLoad::Force(0.5),
        drag(0.1),
        SpinControl::Spin(f64::NAN),
    );
    kit::assert_refused! { infinite => Error::NotFinite { .. } }
    let negative = solver.set_loads(NormalLoad::Force(-0.5), drag(0.0), SpinControl::Spin(0.0));
    kit::assert_refused! { negative => Error::NegativeOrNotFinite { .. } }
    assert_eq!(unchanged(&solver), before);

    solver
        .set_loads(NormalLoad::Force(0.5), drag(0.1), SpinControl::Spin(0.0))
        .unwrap();
    let together = kit::solved(&mut solver);
    let mut solver = new();
    solver.set_load(drag(0.1), SpinControl::Spin(0.0)).unwrap();
    solver.set_normal_load(NormalLoad::Force(0.5)).unwrap();
    assert_eq!(together, kit::solved(&mut solver));
    assert!((together.normal().force() - 0.5).abs() < 1e-9);
}

/// A solve can be cancelled before any product. The tractions of its iterate are within the friction limits of its pressure,
/// also if the buffer contained the solution under a different load.
#[test]
fn cancelled_coupled_rolling_is_within_friction_limits() {
    let pressed = ball_problem(16, 0.1);
    let coefficient = 0.2;
    let builder = coupled_builder(&pressed, coefficient).creepage([0.1, -0.05]);
    let solver = || kit::solver(builder.clone().tolerance(1e-6));
    let mut calls = 0;
    let mut larger = solver();
    let mut earlier = larger.new_solution();
    let counted = larger.solve_observed(&mut earlier, |_| {
        calls += 1;
        ControlFlow::Continue(())
    });
    counted.unwrap();
    let (_, _, NormalLoad::Force(force)) = pressed else {
        panic!("the load is not a force");
    };
    let mut checked = 0;
    for last in 1..calls {
        for (load, mut found) in [(1.0, larger.new_solution()), (0.7, earlier.clone())] {
            let (mut solver, mut count) = (solver(), 0);
            solver
                .set_normal_load(NormalLoad::Force(load * force))
                .unwrap();
            let outcome = solver.solve_observed(&mut found, |_| {
                count += 1;
                if count < last {
                    ControlFlow::Continue(())
                } else {
                    ControlFlow::Break(())
                }
            });
            if outcome.is_ok() {
                continue;
            }
            checked += 1;
            let [x, y] = found.rolling().traction();
            for (cell, &pressure) in found.normal().pressure().iter().enumerate() {
                let traction = x.as_slice()[cell].hypot(y.as_slice()[cell]);
                let limit = coefficient * pressure * (1.0 + 1e-12);
                assert!(traction <= limit, "call {last}, cell {cell}: {traction:e}");
                let is_apart = found.rolling().zones()[cell] == Zone::Separated;
                assert_eq!(is_apart, pressure == 0.0, "call {last}, cell {cell}");
            }
        }
    }
    assert!(checked > 20, "{checked} solves were cancelled");
}
