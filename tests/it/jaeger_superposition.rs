//! If normal and tangential compliances are proportional, the solution of partial slip is the difference of two normal
//! contacts. This is true for any surface and for every cell.

use kit::{max_abs, max_difference, rough, unit_bodies};
use stickslip::tangential::JaegerSuperposition;
use stickslip::{
    Boundary, Error, Field, HalfSpace, NormalLoad, NormalProblem, NormalSolution, TangentialLoad,
    TangentialSolution,
};

const FRICTION: f64 = 0.4;
const TOLERANCE: f64 = 1e-13;

fn press(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    kit::press(bodies, gap, NormalLoad::Force(force), TOLERANCE)
}

fn shear(bodies: &HalfSpace, normal: &NormalSolution, force: [f64; 2]) -> TangentialSolution {
    let (friction, load) = (kit::coulomb(FRICTION), TangentialLoad::force(force));
    kit::shear(bodies, normal, &friction, load, TOLERANCE)
}

#[test]
fn superposition_is_exact_for_zero_poisson_ratio() {
    let grid = kit::square(128, 100.0);
    let gap = rough(grid, 11);
    let bodies = unit_bodies(grid, 0.0);
    let load = 20.0;
    let full = press(&bodies, &gap, load);
    // The contact has many spots. It is neither limited to a few cells nor closed.
    let fraction = full.contact_cells() as f64 / grid.cells() as f64;
    assert!((0.02..0.2).contains(&fraction), "{fraction}");
    for f in [0.1, 0.5, 0.9, 0.999] {
        let stick = press(&bodies, &gap, load * (1.0 - f));
        let exact = JaegerSuperposition::new(&full, &stick, bodies.pair(), FRICTION).unwrap();
        for (axis, force) in [[1.0, 0.0], [0.0, -1.0]].into_iter().enumerate() {
            let sign = force[axis];
            let found = shear(&bodies, &full, force.map(|unit| unit * FRICTION * load * f));
            let expected: Vec<f64> = exact
                .traction()
                .as_slice()
                .iter()
                .map(|q| sign * q)
                .collect();
            let traction = found.traction()[axis].as_slice();
            let error = max_difference(traction, &expected) / max_abs(&expected);
            assert!(error <= 1e-9, "F/(mu W) = {f}, axis {axis}: {error:e}");
            assert_eq!(found.zones(), exact.zones(), "F/(mu W) = {f}, axis {axis}");
            let shift_error = (sign * found.shift()[axis] / exact.shift() - 1.0).abs();
            assert!(
                shift_error < 1e-10,
                "F/(mu W) = {f}, axis {axis}: {shift_error:e}"
            );
            assert_eq!(max_abs(found.traction()[1 - axis].as_slice()), 0.0);
        }
    }
}

/// For other Poisson's ratios the superposition is an approximation with a known error. The approximation must be close
/// but not exact, because otherwise the tangential compliance would equal the normal compliance.
#[test]
fn superposition_is_approximate_for_other_poisson_ratios() {
    let grid = kit::square(96, 100.0);
    let gap = rough(grid, 12);
    let (load, f) = (20.0, 0.4);
    for (nu, least, most) in [(0.29, 5e-3, 0.07), (0.5, 1e-2, 0.14)] {
        let bodies = unit_bodies(grid, nu);
        let full = press(&bodies, &gap, load);
        let stick = press(&bodies, &gap, load * (1.0 - f));
        let near = JaegerSuperposition::new(&full, &stick, bodies.pair(), FRICTION).unwrap();
        let found = shear(&bodies, &full, [FRICTION * load * f, 0.0]);
        let error = kit::l2_difference(near.traction().as_slice(), found.traction()[0].as_slice());
        assert!((least..most).contains(&error), "nu = {nu}: {error}");
        assert!((near.shift() / found.shift()[0] - 1.0).abs() < 0.03);
    }
}

/// Contacts of two different problems, contacts with exchanged loads and unsolved contacts have no meaningful
/// difference and are rejected.
#[test]
fn mismatched_contacts_are_rejected() {
    let grid = kit::square(32, 16.0);
    let gap = kit::sphere(grid, 20.0);
    let bodies = unit_bodies(grid, 0.0);
    let (full, stick) = (press(&bodies, &gap, 2.0), press(&bodies, &gap, 1.0));
    let refused =
        |full, stick| JaegerSuperposition::new(full, stick, bodies.pair(), FRICTION).unwrap_err();

    let Error::NegativeOrNotFinite { value, .. } = refused(&stick, &full) else {
        panic!("exchanged light and heavy contacts are accepted");
    };
    assert!((value + FRICTION).abs() < 1e-9);
    // Equal loads give a zero force of positive sign.
    let none = JaegerSuperposition::new(&full, &full, bodies.pair(), FRICTION).unwrap();
    assert_eq!(none.force(), 0.0);

    // The sphere of the lighter contact has another centre, or another radius.
    let aside = Field::from_fn(grid, |x, y| ((x - 3.0).powi(2) + y * y) / 40.0);
    let [aside, sharp] = [aside, kit::sphere(grid, 2.0)].map(|gap| press(&bodies, &gap, 1.0));
    for light in [&aside, &sharp] {
        kit::assert_refused! { refused(&full, light) => Error::OutdatedSolution { .. } }
    }

    let repeated = HalfSpace::with_boundary(grid, *bodies.pair(), Boundary::Periodic).unwrap();
    let repeated = press(&repeated, &gap, 1.0);
    kit::assert_refused! { refused(&full, &repeated) => Error::BoundaryMismatch { .. } }

    let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1.0));
    let unsolved = kit::solver(problem).new_solution();
    for error in [refused(&full, &unsolved), refused(&unsolved, &stick)] {
        assert!(matches!(error, Error::NotConverged(_)), "{error}");
    }
}
