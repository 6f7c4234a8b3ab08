//! Both methods find the same solution within the requested tolerance, on smooth and rough bodies.

use kit::{Table2, energy_difference, rough, unit_bodies, unit_pair};
use stickslip::cgm::{self, AbsBound, Method, NonNegative, Problem, Settings};
use stickslip::influence::Component;
use stickslip::{
    Field, HalfSpace, NormalLoad, NormalSolution, Report, TangentialLoad, TangentialSolution,
};

const TOLERANCE: f64 = 1e-6;

fn press(bodies: &HalfSpace, gap: &Field, force: f64, method: Method) -> NormalSolution {
    kit::press_by(bodies, gap, NormalLoad::Force(force), TOLERANCE, method)
}

fn shear(
    bodies: &HalfSpace,
    normal: &NormalSolution,
    f: f64,
    method: Method,
) -> TangentialSolution {
    let load = TangentialLoad::force([f * 0.5 * normal.force(), 0.0]);
    kit::shear_by(bodies, normal, &kit::coulomb(0.5), load, TOLERANCE, method)
}

fn assert_agreement(bodies: &HalfSpace, gap: &Field, force: f64) {
    let [normal, single] =
        [Method::ActiveSet, Method::PolonskyKeer].map(|method| press(bodies, gap, force, method));
    let difference = energy_difference(bodies, Component::ZZ, single.pressure(), normal.pressure());
    assert!(difference <= TOLERANCE, "pressure: {difference:e}");
    assert!((single.approach() / normal.approach() - 1.0).abs() <= TOLERANCE);
    for f in [0.1, 0.4, 0.9] {
        let [sets, single] = [Method::ActiveSet, Method::PolonskyKeer]
            .map(|method| shear(bodies, &normal, f, method));
        let (a, b) = (single.traction()[0], sets.traction()[0]);
        let difference = energy_difference(bodies, Component::XX, a, b);
        assert!(difference <= TOLERANCE, "traction at {f}: {difference:e}");
        assert!((single.shift()[0] / sets.shift()[0] - 1.0).abs() <= TOLERANCE);
    }
}

#[test]
fn methods_agree_on_sphere_of_table_2_within_cost() {
    let grid = kit::square(kit::thorough(96, 256), 3.0 * Table2::CONTACT_RADIUS);
    let bodies = HalfSpace::new(grid, Table2::pair()).unwrap();
    let ball = kit::sphere(grid, Table2::RADIUS);
    assert_agreement(&bodies, &ball, Table2::FORCE);
    let normal = press(&bodies, &ball, Table2::FORCE, Method::ActiveSet);
    let costs = |method| {
        let (press, shear) = (
            press(&bodies, &ball, Table2::FORCE, method),
            shear(&bodies, &normal, 0.4, method),
        );
        [press.report(), shear.report()].map(Report::products)
    };
    let [sets, single] = [costs(Method::ActiveSet), costs(Method::PolonskyKeer)];
    assert!(
        sets.iter().all(|&count| count <= 25),
        "active sets: {sets:?} products"
    );
    assert!(
        single.iter().all(|&count| count <= 85),
        "single loop: {single:?} products"
    );
}

#[test]
fn methods_agree_on_rough_surfaces_from_few_spots_to_near_closure() {
    let grid = kit::square(128, 100.0);
    let bodies = unit_bodies(grid, 0.4);
    for (seed, force) in [(1, 0.5), (2, 20.0), (3, 300.0)] {
        assert_agreement(&bodies, &rough(grid, seed), force);
    }
}

/// Runs the engine directly on the whole grid, from a uniform start and with the circulant preconditioner only.
#[test]
fn active_set_method_solves_sphere_of_table_2_within_cost() {
    let grid = kit::square(kit::thorough(96, 256), 3.0 * Table2::CONTACT_RADIUS);
    let bodies = HalfSpace::new(grid, Table2::pair()).unwrap();
    let ball = kit::sphere(grid, Table2::RADIUS);
    let settings = Settings::default().tolerance(TOLERANCE);
    let total = Table2::FORCE / grid.cell_area();
    let engine = |component| {
        let inverse = bodies.preconditioner(component).unwrap().unwrap();
        (bodies.operator(component).unwrap(), inverse)
    };

    let (operator, inverse) = engine(Component::ZZ);
    let problem = Problem::new(operator, [ball.as_slice()], NonNegative);
    let problem = problem.preconditioner(inverse).total(total);
    let mut pressure = vec![total / grid.cells() as f64; grid.cells()];
    let normal = cgm::minimise(&problem, &settings, [&mut pressure])
        .unwrap()
        .report;

    let limits: Vec<f64> = pressure.iter().map(|p| Table2::FRICTION * p).collect();
    let (operator, inverse) = engine(Component::XX);
    let none = vec![0.0; grid.cells()];
    let problem = Problem::new(operator, [&none], AbsBound(&limits));
    let problem = problem
        .preconditioner(inverse)
        .total(0.4 * Table2::FRICTION * total);
    let mut traction: Vec<f64> = limits.iter().map(|m| 0.4 * m).collect();
    let tangential = cgm::minimise(&problem, &settings, [&mut traction])
        .unwrap()
        .report;
    for report in [normal, tangential] {
        let products = report.products();
        assert!(products <= 35, "{products} products: {report}");
    }
}

/// Under a tiny load, a step scaled by the gap would be much larger than any pressure. The pressure would then lose
/// its accuracy.
#[test]
fn methods_agree_under_tiny_load_on_rough_surface() {
    let grid = kit::square(32, 32.0);
    let gap = rough(grid, 4);
    for boundary in kit::boundaries(grid) {
        let bodies = HalfSpace::with_boundary(grid, unit_pair(0.3), boundary).unwrap();
        for force in [1e-9, 1e-15] {
            let [sets, plain] = [Method::ActiveSet, Method::PolonskyKeer]
                .map(|method| press(&bodies, &gap, force, method));
            assert_eq!(sets.contact_cells(), plain.contact_cells());
            assert!((plain.force() / force - 1.0).abs() < 1e-12);
        }
    }
}
