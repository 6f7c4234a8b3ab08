//! If an unchanged problem is solved again, one product on the window and one product on the whole grid verify its
//! solution. No other products are computed.

use kit::{rough, unit_bodies};
use stickslip::{
    Axis, Boundary, CoupledProblem, Coupling, Field, Grid, HalfSpace, History, LoadStep,
    NormalLoad, NormalProblem, Report, TangentialControl, TangentialLoad, TangentialModel,
    TangentialProblem, surface,
};

/// Asserts that a solve only verified the solution on the window, and on the grid if it differs from the window.
fn assert_only_verified(report: &Report, products: usize, what: &str) {
    assert!(report.is_converged(), "{what}: {report:?}");
    assert!(
        report.double_precision_products <= products,
        "{what}: {report:?}"
    );
    assert_eq!(report.single_precision_products, 0, "{what}: {report:?}");
    assert_eq!(report.iterations, 0, "{what}: {report:?}");
}

fn scenes() -> Vec<(&'static str, HalfSpace, Field, f64)> {
    let ball = kit::square(48, 4.0);
    let rough_grid = kit::square(40, 1.0);
    let oblong = Grid::new(33, 21, 0.1, 0.17).unwrap();
    let flat = surface::ellipsoid(oblong, 8.0, 5.0).unwrap();
    let periodic =
        HalfSpace::with_boundary(rough_grid, kit::alike(1.0, 0.3), Boundary::Periodic).unwrap();
    vec![
        ("ball", unit_bodies(ball, 0.3), kit::sphere(ball, 10.0), 0.2),
        (
            "rough",
            unit_bodies(rough_grid, 0.3),
            rough(rough_grid, 3),
            0.02,
        ),
        ("oblong", unit_bodies(oblong, 0.2), flat, 0.1),
        ("periodic", periodic, rough(rough_grid, 5), 0.02),
    ]
}

const TOLERANCES: [f64; 3] = [1e-4, 1e-6, 1e-9];

#[test]
fn unchanged_pressures_and_tractions_are_only_verified() {
    for (name, bodies, gap, force) in scenes() {
        for tolerance in TOLERANCES {
            let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(force));
            let mut press = kit::solver(problem.tolerance(tolerance));
            let mut normal = kit::solved(&mut press);
            for control in [
                NormalLoad::Force(force),
                NormalLoad::Approach(normal.approach()),
            ] {
                press.set_load(control).unwrap();
                let before = normal.clone();
                press.solve_into(&mut normal).unwrap();
                assert_only_verified(
                    normal.report(),
                    2,
                    &format!("{name} {tolerance} {control:?}"),
                );
                assert_eq!(normal.pressure(), before.pressure(), "{name}");
            }
            for model in [TangentialModel::Scalar, TangentialModel::Vector] {
                let loads = [
                    TangentialLoad::force([0.1 * force, 0.0]),
                    TangentialLoad::shift([0.003, 0.0]),
                    TangentialLoad::spring([0.05, 0.0], 0.7),
                ];
                for load in loads {
                    let problem =
                        TangentialProblem::builder(&bodies, &normal, kit::coulomb(0.3), load);
                    let problem = problem.model(model).tolerance(tolerance).build().unwrap();
                    let mut solver = problem.into_solver().unwrap();
                    let mut shear = kit::solved(&mut solver);
                    let before = shear.clone();
                    solver.solve_into(&mut shear).unwrap();
                    let what = format!("{name} {tolerance} {model:?} {load:?}");
                    assert_only_verified(shear.report(), 1, &what);
                    assert_eq!(shear.traction(), before.traction(), "{what}");
                }
            }
        }
    }
}

#[test]
fn unchanged_histories_are_only_verified() {
    for (name, bodies, gap, force) in scenes() {
        for model in [TangentialModel::Scalar, TangentialModel::Vector] {
            let builder = History::builder(&bodies, &gap, kit::coulomb(0.3)).model(model);
            let mut history = builder.tolerance(1e-6).build().unwrap();
            let press = LoadStep::hold().normal(NormalLoad::Force(force));
            let drag = |force| press.tangential(Axis::X, TangentialControl::Force(force));
            history.step(&press).unwrap();
            for load in [drag(0.2 * force), drag(-0.1 * force)] {
                history.step(&load).unwrap();
                let step = history.step(&load).unwrap();
                let what = format!("{name} {model:?}");
                assert_only_verified(step.normal_report().unwrap(), 2, &what);
                assert_only_verified(step.tangential_report().unwrap(), 1, &what);
            }
            let restored = History::from_bytes(&bodies, &history.to_bytes());
            let mut restored = restored.unwrap();
            let step = restored.step(&drag(-0.1 * force)).unwrap();
            assert_only_verified(step.tangential_report().unwrap(), 1, name);
        }
    }
}

#[test]
fn unchanged_coupled_contacts_are_only_verified() {
    let grid = kit::square(40, 4.0);
    let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, 0.1)).unwrap();
    let gap = kit::sphere(grid, 10.0);
    let (press, load) = (NormalLoad::Force(0.1), TangentialLoad::force([0.01, 0.0]));
    let friction = kit::coulomb(0.3);
    let problem = CoupledProblem::builder(&bodies, &gap, friction.clone(), press, load);
    let mut solver = kit::solver(problem.tolerance(1e-6));
    let mut contact = kit::solved(&mut solver);
    solver.solve_into(&mut contact).unwrap();
    assert_only_verified(&contact.report().work, 2, "coupled");

    for coupling in [Coupling::Full, Coupling::OneWay] {
        let builder = History::builder(&bodies, &gap, friction.clone()).coupling(coupling);
        let mut history = builder.tolerance(1e-6).build().unwrap();
        let press = LoadStep::hold().normal(press);
        let drag = press.tangential(Axis::X, TangentialControl::Force(0.01));
        for load in [press, drag, drag] {
            history.step(&load).unwrap();
        }
        assert_only_verified(
            history.last_step().unwrap().tangential_report().unwrap(),
            2,
            "history",
        );
    }
}
