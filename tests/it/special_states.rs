//! Special states of a contact, and the outcomes of a solve.

use kit::{Table2, max_abs, unit_bodies};
use stickslip::Status;
use stickslip::cgm::{self, AbsBound, Method, Problem, Settings};
use stickslip::influence::Component;
use stickslip::{
    Error, Field, Friction, Grid, HalfSpace, NormalLoad, NormalProblem, NormalSolution,
    NormalSolver, TangentialLoad, TangentialProblem, Warning, Zone,
};

fn table_2(n: usize) -> (HalfSpace, NormalSolution) {
    let grid = kit::square(n, 2.6 * Table2::CONTACT_RADIUS);
    let bodies = HalfSpace::new(grid, Table2::pair()).unwrap();
    let problem = NormalProblem::builder(
        &bodies,
        kit::sphere(grid, Table2::RADIUS),
        NormalLoad::Force(Table2::FORCE),
    )
    .build()
    .unwrap();
    let normal = problem.solve().unwrap();
    (bodies, normal)
}

#[test]
fn gross_slip_has_shift_of_onset() {
    let (bodies, normal) = table_2(128);
    let friction = kit::coulomb(Table2::FRICTION);
    let build = |load| TangentialProblem::builder(&bodies, &normal, friction.clone(), load).build();
    let limit = build(TangentialLoad::force([0.0, 0.0]))
        .unwrap()
        .friction_capacity();
    assert!((limit / 50.0 - 1.0).abs() < 1e-12);
    for fraction in [1.0, 1.0 - 5e-13, 1.0 + 5e-13, -1.0] {
        let sliding = build(TangentialLoad::force([0.0, fraction * limit]))
            .unwrap()
            .solve()
            .unwrap();
        assert!(sliding.is_gross_slip());
        assert_eq!((sliding.stick_ratio(), sliding.stick_area()), (0.0, 0.0));
        // The onset is the shift at which the last cell starts to slip, delta_0 of the closed form.
        let onset = 2.9604761406069e-6 * fraction.signum();
        assert!((sliding.shift()[1] / onset - 1.0).abs() < 1e-3);
        let pressures = normal.pressure().as_slice().iter();
        for (q, p) in sliding.traction()[1].as_slice().iter().zip(pressures) {
            assert!(
                (q - fraction.signum() * Table2::FRICTION * p).abs()
                    <= 1e-15 * Table2::MAX_PRESSURE
            );
        }
    }
    kit::assert_refused! { build(TangentialLoad::force([1.001 * limit, 0.0])) => Error::BeyondFrictionCapacity { .. } }
    // A prescribed shift can increase further, while the force stays constant.
    let dragged = build(TangentialLoad::shift([-9e-6, 0.0]))
        .unwrap()
        .solve()
        .unwrap();
    assert!(dragged.is_gross_slip());
    assert!((dragged.force()[0] / -limit - 1.0).abs() < 1e-12);
    assert!((dragged.shift()[0] + 9e-6).abs() < 1e-20);
    assert!(dragged.dissipated_energy() > 0.0);
}

#[test]
fn few_cells_stick_close_to_sliding() {
    let (bodies, normal) = table_2(64);
    let friction = kit::coulomb(Table2::FRICTION);
    let mut last = usize::MAX;
    for f in [0.99, 0.999, 0.9999, 0.999999] {
        let load = TangentialLoad::force([f * 50.0, 0.0]);
        let shear = kit::solve(TangentialProblem::builder(
            &bodies,
            &normal,
            friction.clone(),
            load,
        ));
        let stick = shear
            .zones()
            .iter()
            .filter(|&&zone| zone == Zone::Stick)
            .count();
        assert!(stick > 0 && stick <= last, "{stick} cells at {f}");
        let exact = 2.9604761406069e-6 * (1.0 - (1.0_f64 - f).powf(2.0 / 3.0));
        assert!((shear.shift()[0] / exact - 1.0).abs() < 1e-3);
        last = stick;
    }
}

#[test]
fn zero_load_sticks_without_traction() {
    let (bodies, normal) = table_2(64);
    for load in [
        TangentialLoad::force([0.0, 0.0]),
        TangentialLoad::shift([0.0, 0.0]),
    ] {
        let shear = kit::solve(TangentialProblem::builder(
            &bodies,
            &normal,
            kit::coulomb(0.5),
            load,
        ));
        assert_eq!(max_abs(shear.traction()[0].as_slice()), 0.0);
        assert_eq!((shear.shift(), shear.force()), ([0.0; 2], [0.0; 2]));
        assert_eq!(shear.stick_ratio(), 1.0);
        assert!(shear.report().is_converged() && shear.report().duality_gap == 0.0);
    }
}

#[test]
fn friction_can_vary_vanish_and_be_limited() {
    let (bodies, normal) = table_2(96);
    let grid = bodies.grid();
    // The surface is frictionless on one side of the y axis, and has twice the friction on the other side.
    let coefficients = Field::from_fn(grid, |x, _| if x < 0.0 { 0.0 } else { 0.8 });
    let friction = Friction::per_cell(coefficients).unwrap();
    let load = TangentialLoad::force([-14.0, 0.0]);
    let shear = kit::solve(TangentialProblem::builder(&bodies, &normal, friction, load));
    for (i, zone) in shear.zones().iter().enumerate() {
        let (p, q) = (
            normal.pressure().as_slice()[i],
            shear.traction()[0].as_slice()[i],
        );
        if p > 0.0 && grid.x(i % grid.nx()) < 0.0 {
            assert!(*zone == Zone::Slip && q == 0.0);
        }
        assert!(q <= 0.0 && q.abs() <= 0.8 * p);
    }
    assert!((shear.force()[0] + 14.0).abs() < 1e-11);
    // Without friction no tangential force can be carried, and the contact slides under a zero force.
    let none = kit::coulomb(0.0);
    let build = |force| {
        TangentialProblem::builder(
            &bodies,
            &normal,
            none.clone(),
            TangentialLoad::force([force, 0.0]),
        )
        .build()
    };
    kit::assert_refused! { build(1e-9) => Error::BeyondFrictionCapacity { limit: 0.0, .. } }
    assert!(build(0.0).unwrap().solve().unwrap().is_gross_slip());
    // A limit of the shear stress flattens the traction.
    let cap = 0.3 * Table2::FRICTION * Table2::MAX_PRESSURE;
    let friction = Friction::coulomb(Table2::FRICTION)
        .unwrap()
        .max_shear_stress(cap)
        .unwrap();
    let shear = kit::solve(TangentialProblem::builder(
        &bodies,
        &normal,
        friction,
        TangentialLoad::force([15.0, 0.0]),
    ));
    assert!((shear.traction()[0].max() / cap - 1.0).abs() < 1e-15);
}

#[test]
fn first_touch_and_separation_are_solved() {
    let grid = kit::square(16, 1.0);
    let bodies = unit_bodies(grid, 0.3);
    let mut ball = kit::sphere(grid, 2.0);
    for height in ball.as_mut_slice() {
        *height += 0.5;
    }
    for load in [
        NormalLoad::Force(0.0),
        NormalLoad::Approach(0.4),
        NormalLoad::Approach(-3.0),
    ] {
        let apart = kit::solve(NormalProblem::builder(&bodies, &ball, load));
        assert_eq!(
            (apart.force(), apart.contact_cells(), apart.mean_pressure()),
            (0.0, 0, 0.0)
        );
        assert_eq!(apart.warnings(), [Warning::NoContact]);
        assert!(apart.gap().min() >= 0.0);
        if load == NormalLoad::Force(0.0) {
            assert!((apart.approach() - ball.min()).abs() < 1e-15);
        }
    }
}

#[test]
fn warnings_can_be_compared() {
    let grid = kit::square(32, 1.0);
    let bodies = unit_bodies(grid, 0.3);
    let press = |gap: &Field, force| {
        kit::solve(NormalProblem::builder(
            &bodies,
            gap,
            NormalLoad::Force(force),
        ))
    };
    let flat = press(&Field::zeros(grid), 1e-3);
    let across = Warning::ContactSpansGrid {
        along_x: true,
        along_y: true,
    };
    assert_eq!(
        flat.warnings(),
        [Warning::ContactAtEdge { cells: 4 * 31 }, across]
    );
    assert_eq!(flat.contact_cells(), 1024);
    let point = press(&kit::sphere(grid, 0.01), 1e-7);
    assert!(matches!(
        point.warnings()[..],
        [
            Warning::UnresolvedSpots {
                unresolved: 1,
                spots: 1
            },
            Warning::DiscretisationError { .. },
            Warning::SteepSurface { .. }
        ]
    ));
    let load = TangentialLoad::force([1e-8, 0.0]);
    let shear = kit::solve(TangentialProblem::builder(
        &bodies,
        &point,
        kit::coulomb(0.5),
        load,
    ));
    assert_eq!(shear.warnings(), point.warnings()[..2]);
    assert!(press(&kit::sphere(grid, 1.0), 0.01).warnings().is_empty());
}

/// In a contact of one cell, all linear systems have a single unknown.
#[test]
fn single_contact_cell_is_solved() {
    for (grid, gap) in [
        (Grid::new(1, 1, 2.0, 3.0).unwrap(), vec![0.7]),
        (Grid::new(3, 1, 2.0, 3.0).unwrap(), vec![100.0, 0.7, 100.0]),
    ] {
        let bodies = unit_bodies(grid, 0.2);
        let gap = Field::from_vec(grid, gap).unwrap();
        for method in [Method::ActiveSet, Method::PolonskyKeer] {
            let builder =
                NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.2)).method(method);
            let normal = kit::solve(builder);
            assert_eq!(normal.contact_cells(), 1);
            assert!(
                (normal.pressure().max() - 0.2).abs() < 1e-13,
                "{grid:?} {method:?} {:e}",
                normal.pressure().max() - 0.2
            );
            let builder = TangentialProblem::builder(
                &bodies,
                &normal,
                kit::coulomb(0.5),
                TangentialLoad::force([0.3, 0.0]),
            );
            let shear = kit::solve(builder.method(method));
            assert!((shear.traction()[0].max() - 0.05).abs() < 1e-13);
            assert_eq!(shear.stick_ratio(), 1.0);
        }
    }
}

#[test]
fn tolerance_below_round_off_stalls() {
    let (bodies, _) = table_2(32);
    for method in [Method::ActiveSet, Method::PolonskyKeer] {
        let builder = NormalProblem::builder(
            &bodies,
            kit::sphere(bodies.grid(), Table2::RADIUS),
            NormalLoad::Force(100.0),
        )
        .method(method);
        let outcome = builder.tolerance(1e-17).build().unwrap().solve();
        let Err(Error::NotConverged(report)) = outcome else {
            panic!("a tolerance of 1e-17 must not be reached");
        };
        assert_eq!(report.status, Status::Stalled);
        assert!(
            report.residual < 1e-13 && report.energy_error_bound() < 1e-12,
            "{report}"
        );
    }
}

/// A solve without contact leaves no initial guess: the next solve is bitwise identical to the solve of a new solver.
/// An absurd load is rejected and changes nothing.
#[test]
fn solve_without_contact_leaves_no_start() {
    let grid = kit::square(96, 8.0);
    let bodies = unit_bodies(grid, 0.3);
    for method in [Method::ActiveSet, Method::PolonskyKeer] {
        let solver = |load| {
            let builder =
                NormalProblem::builder(&bodies, kit::sphere(grid, 10.0), load).method(method);
            kit::solver(builder)
        };
        let mut cold = solver(NormalLoad::Force(0.5));
        let expected = kit::solved(&mut cold);
        let assert_cold = |solver: &mut NormalSolver, solution: &mut NormalSolution| {
            solver.set_load(NormalLoad::Force(0.5)).unwrap();
            solver.solve_into(solution).unwrap();
            assert_eq!(solution.pressure(), expected.pressure());
            assert_eq!(solution.report().history, expected.report().history);
        };

        for apart in [NormalLoad::Force(0.0), NormalLoad::Approach(-0.1)] {
            let mut solver = solver(apart);
            let mut solution = solver.new_solution();
            for _ in 0..2 {
                solver.solve_into(&mut solution).unwrap();
                assert_eq!(solution.contact_cells(), 0);
            }
            assert_cold(&mut solver, &mut solution);
        }

        for absurd in [1e160, 1e305] {
            let mut solver = solver(NormalLoad::Force(0.4));
            let mut solution = kit::solved(&mut solver);
            kit::assert_refused! { solver.set_load(NormalLoad::Force(absurd)) => Error::ExtremeNumber { .. } }
            solver.solve_into(&mut solution).unwrap();
            assert!((solution.force() / 0.4 - 1.0).abs() < 1e-12);
        }
    }
}

/// A fretting loop repeatedly passes through zero load.
#[test]
fn used_solver_returns_to_zero_load() {
    let (bodies, normal) = table_2(64);
    for method in [Method::ActiveSet, Method::PolonskyKeer] {
        let builder = TangentialProblem::builder(
            &bodies,
            &normal,
            kit::coulomb(0.5),
            TangentialLoad::shift([1e-6, 0.0]),
        );
        let mut solver = kit::solver(builder.method(method));
        let mut shear = solver.new_solution();
        for load in [
            TangentialLoad::shift([0.0, 0.0]),
            TangentialLoad::force([0.0, 0.0]),
        ] {
            solver
                .set_load(TangentialLoad::force([-30.0, 0.0]))
                .unwrap();
            solver.solve_into(&mut shear).unwrap();
            assert!(shear.stick_ratio() < 1.0);
            solver.set_load(load).unwrap();
            solver.solve_into(&mut shear).unwrap();
            assert_eq!(
                (shear.stick_ratio(), max_abs(shear.traction()[0].as_slice())),
                (1.0, 0.0)
            );
            assert_eq!(shear.dissipated_energy().to_bits(), 0);
        }
    }
}

/// A solution before any solve has the status `Unsolved`, and is rejected as an input.
#[test]
fn empty_solution_is_unsolved() {
    let (bodies, normal) = table_2(32);
    let press = NormalProblem::builder(
        &bodies,
        kit::sphere(bodies.grid(), Table2::RADIUS),
        NormalLoad::Force(1.0),
    );
    let empty = kit::solver(press).new_solution();
    assert_eq!(empty.report().status, Status::Unsolved);
    assert!(empty.report().energy_error_bound().is_infinite());
    let load = TangentialLoad::force([0.1, 0.0]);
    let build =
        |normal| TangentialProblem::builder(&bodies, normal, kit::coulomb(0.5), load).build();
    kit::assert_refused! { build(&empty) => Error::NotConverged(report) if report.status == Status::Unsolved }
    let empty = build(&normal)
        .unwrap()
        .into_solver()
        .unwrap()
        .new_solution();
    assert_eq!(empty.report().status, Status::Unsolved);
    assert!(!empty.is_gross_slip());
}

/// The total force is zero, and the linear term is uniform over all cells that can carry a traction. The multiplier
/// balances it completely.
#[test]
fn uniform_linear_term_is_balanced_by_multiplier() {
    let n = kit::thorough(16, 32);
    let bodies = unit_bodies(kit::square(n, 4.0), 0.3);
    let grid = bodies.grid();
    let limits = Field::from_fn(grid, |x, y| 0.1 * (2.0 - x * x - y * y).max(0.0).sqrt());
    let offset = |limit: &f64| if *limit > 0.0 { 3.0 } else { 0.0 };
    let linear: Vec<f64> = limits.as_slice().iter().map(offset).collect();
    let operator = bodies.operator(Component::XX).unwrap();
    let inverse = bodies.preconditioner(Component::XX).unwrap().unwrap();
    let problem = Problem::new(operator, [&linear], AbsBound(limits.as_slice()));
    let problem = problem.preconditioner(inverse).total(0.0);
    let mut x = vec![0.0; grid.cells()];
    let minimum = cgm::minimise(&problem, &Settings::default(), [&mut x]).unwrap();
    assert!(x.iter().all(|&x| x == 0.0));
    assert_eq!(minimum.multiplier, [3.0]);

    // The linear term is almost uniform. The problem must be solved, or end with an error after a bounded number of
    // steps.
    let mut linear = linear;
    linear[n / 2 * n + n / 2] += 1e-13;
    let operator = bodies.operator(Component::XX).unwrap();
    let inverse = bodies.preconditioner(Component::XX).unwrap().unwrap();
    let problem = Problem::new(operator, [&linear], AbsBound(limits.as_slice()));
    let problem = problem.preconditioner(inverse).total(0.0);
    let outcome = cgm::minimise(&problem, &Settings::default(), [&mut x]);
    assert!(matches!(outcome, Ok(_) | Err(Error::NotConverged(_))));
}
