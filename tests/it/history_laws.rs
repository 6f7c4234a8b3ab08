//! Properties of any history. A history without slip has no residual effects. Cells do not slip at first contact.
//! Tractions are within the limit of the current pressure.

use kit::{max_abs, max_difference, rough, unit_bodies};
use stickslip::{Axis, Error, Field, History, LoadStep, NormalControl, TangentialControl, Zone};

const FRICTION: f64 = 0.4;

fn new_history(gap: &Field, axis: Axis) -> History {
    let bodies = unit_bodies(gap.grid(), 0.3);
    let builder = History::builder(&bodies, gap, kit::coulomb(FRICTION));
    builder.axis(axis).tolerance(1e-9).build().unwrap()
}

fn take_steps(history: &mut History, steps: &[(NormalControl, TangentialControl)], sign: f64) {
    for &(normal, tangential) in steps {
        let tangential = match tangential {
            TangentialControl::Force(force) => TangentialControl::Force(sign * force),
            TangentialControl::Shift(shift) => TangentialControl::Shift(sign * shift),
            other => other,
        };
        let axis = history.axis().unwrap();
        let step = LoadStep::hold().normal(normal).tangential(axis, tangential);
        history.step(&step).unwrap();
        assert_within_limits(history);
    }
}

fn assert_within_limits(history: &History) {
    let traction = history.traction()[history.axis().unwrap().index()];
    let cells = traction
        .as_slice()
        .iter()
        .zip(history.pressure().as_slice());
    for ((q, p), zone) in cells.zip(history.zones()) {
        assert!(q.abs() <= FRICTION * p);
        assert_eq!(*zone == Zone::Separated, *p <= 0.0);
        assert_eq!(*zone == Zone::Stick, q.abs() < FRICTION * p);
    }
}

const PATH: [(NormalControl, TangentialControl); 6] = [
    (NormalControl::Force(30.0), TangentialControl::Hold),
    (NormalControl::Hold, TangentialControl::Force(9.0)),
    (NormalControl::Force(20.0), TangentialControl::Hold),
    (NormalControl::Force(35.0), TangentialControl::Force(-4.0)),
    (NormalControl::Approach(1.6), TangentialControl::Shift(0.05)),
    (NormalControl::Hold, TangentialControl::Hold),
];

/// If no cell slips, a load that is removed leaves the state exactly at zero.
#[test]
fn load_removed_without_slip_leaves_no_traction() {
    let grid = kit::square(40, 8.0);
    let bodies = unit_bodies(grid, 0.3);
    let builder = History::builder(&bodies, kit::sphere(grid, 10.0), kit::coulomb(1e6));
    let mut history = builder.build().unwrap();
    let press = LoadStep::hold().normal(NormalControl::Force(1.0));
    history.step(&press).unwrap();
    let force = |force| LoadStep::hold().tangential(Axis::X, TangentialControl::Force(force));
    for value in [0.7, 1.9, -0.4] {
        let step = history.step(&force(value)).unwrap();
        assert!(step.stick_ratio() == 1.0 && step.energy().dissipated_energy == 0.0);
    }
    history.step(&force(0.0)).unwrap();
    assert!(history.shift() == [0.0; 2] && history.accumulated_slip().max() == 0.0);
    assert!(max_abs(history.traction()[0].as_slice()) == 0.0);
    // Returning to zero by a prescribed shift also gives exactly zero force.
    let shift = |shift| LoadStep::hold().tangential(Axis::X, TangentialControl::Shift(shift));
    history.step(&shift(0.2)).unwrap();
    history.step(&shift(0.0)).unwrap();
    assert!(history.tangential_force() == [0.0; 2]);
}

/// A hold step changes the state only within the tolerance, and needs no product in the normal direction.
#[test]
fn hold_step_leaves_state_unchanged() {
    let gap = rough(kit::square(48, 100.0), 9);
    let mut history = new_history(&gap, Axis::X);
    take_steps(&mut history, &PATH, 1.0);
    let (before, path) = (
        history.traction()[0].clone(),
        history.accumulated_slip().clone(),
    );
    let step = history.step(&LoadStep::hold()).unwrap();
    assert!(step.normal_report().is_none());
    let report = step.tangential_report().unwrap();
    assert!(report.double_precision_products <= 3, "{report}");
    assert!(step.energy().work == 0.0);
    let difference = max_difference(history.traction()[0].as_slice(), before.as_slice());
    assert!(difference < 1e-8 * max_abs(before.as_slice()));
    let slipped = max_difference(history.accumulated_slip().as_slice(), path.as_slice());
    assert!(slipped < 1e-8 * path.max());
}

/// In a contact that grows under a constant force without slip, new cells carry no traction.
#[test]
fn new_contact_cells_start_without_traction() {
    let mut history = new_history(&kit::sphere(kit::square(64, 16.0), 20.0), Axis::X);
    let hold = TangentialControl::Hold;
    take_steps(&mut history, &[(NormalControl::Force(2.0), hold)], 1.0);
    let force = TangentialControl::Force(0.5);
    take_steps(&mut history, &[(NormalControl::Hold, force)], 1.0);
    let zones = history.zones().to_vec();
    let (path, traction) = (
        history.accumulated_slip().clone(),
        history.traction()[0].clone(),
    );
    // The contact grows far beyond the window of the small contact.
    take_steps(&mut history, &[(NormalControl::Force(12.0), force)], 1.0);
    assert_eq!(history.last_step().unwrap().stick_ratio(), 1.0);
    let mut entered = 0;
    for (i, zone) in zones.iter().enumerate() {
        let now = history.zones()[i];
        assert!(now == Zone::Stick || *zone == Zone::Separated);
        assert!(history.accumulated_slip().as_slice()[i] == path.as_slice()[i]);
        entered += usize::from(*zone == Zone::Separated && now == Zone::Stick);
    }
    assert!(entered > 100);
    // All cells stick under the same force. Without slip, no traction changes.
    let difference = max_difference(history.traction()[0].as_slice(), traction.as_slice());
    assert!(difference < 1e-6 * traction.max(), "{difference:e}");

    // After separation there is no traction at any shift, and a force cannot be applied.
    take_steps(
        &mut history,
        &[(NormalControl::Force(0.0), TangentialControl::Force(0.0))],
        1.0,
    );
    let shift = history.shift()[0];
    assert!(max_abs(history.traction()[0].as_slice()) == 0.0 && shift > 0.0);
    let push = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(0.1));
    assert!(matches!(history.step(&push), Err(Error::EmptyContact)));
    // If the bodies are pressed together at a different shift, they stick at this shift without traction or slip.
    take_steps(
        &mut history,
        &[(NormalControl::Hold, TangentialControl::Shift(3.0))],
        1.0,
    );
    take_steps(
        &mut history,
        &[(NormalControl::Force(2.0), TangentialControl::Hold)],
        1.0,
    );
    assert!(max_abs(history.traction()[0].as_slice()) < 1e-12);
    take_steps(
        &mut history,
        &[(NormalControl::Hold, TangentialControl::Force(0.0))],
        1.0,
    );
    assert!((history.shift()[0] - 3.0).abs() < 1e-9);
}

/// Before first contact, the shift takes its prescribed value or follows a spring, and a nonzero force cannot be
/// applied.
#[test]
fn force_before_first_contact_is_rejected() {
    for axis in [Axis::X, Axis::Y] {
        let mut history = new_history(&kit::sphere(kit::square(32, 16.0), 20.0), axis);
        let step = |tangential| {
            let apart = LoadStep::hold().normal(NormalControl::Force(0.0));
            apart.tangential(axis, tangential)
        };
        let position = -0.75;
        let spring = TangentialControl::Spring {
            position,
            stiffness: 2.0,
        };
        for (tangential, shift) in [
            (TangentialControl::Force(0.0), 0.0),
            (TangentialControl::Shift(0.5), 0.5),
            (TangentialControl::Hold, 0.5),
            (spring, position),
            (TangentialControl::Force(-0.0), position),
        ] {
            history.step(&step(tangential)).unwrap();
            assert_eq!(history.shift()[axis.index()], shift, "{tangential:?}");
            kit::assert_refused! { history.step(&step(TangentialControl::Force(-0.1))) => Error::EmptyContact }
            assert_eq!(history.shift()[axis.index()], shift);
        }
        // The bodies are pressed together at this shift and stick.
        let hold = TangentialControl::Hold;
        take_steps(&mut history, &[(NormalControl::Force(2.0), hold)], 1.0);
        assert_eq!(history.shift()[axis.index()], position);
        assert_eq!(max_abs(history.traction()[axis.index()].as_slice()), 0.0);
        assert_eq!(history.accumulated_slip().max(), 0.0);
    }
}

/// At the friction limit the contact slides by the smallest possible shift, and the shift remains constant under the
/// same force.
#[test]
fn force_at_the_limit_slides_by_the_smallest_shift() {
    let mut history = new_history(&kit::sphere(kit::square(48, 12.0), 20.0), Axis::X);
    take_steps(
        &mut history,
        &[(NormalControl::Force(4.0), TangentialControl::Hold)],
        1.0,
    );
    let limit = FRICTION * history.pressure().integral();
    let mut shifts = Vec::new();
    for force in [limit, limit, -limit, -limit, 0.0] {
        take_steps(
            &mut history,
            &[(NormalControl::Hold, TangentialControl::Force(force))],
            1.0,
        );
        assert_eq!(history.last_step().unwrap().is_gross_slip(), force != 0.0);
        shifts.push(history.shift()[0]);
    }
    assert!((shifts[1] - shifts[0]).abs() < 1e-12 * shifts[0]);
    assert!((shifts[3] - shifts[2]).abs() < 1e-12 * shifts[0]);
    assert!(
        (shifts[2] + shifts[0]).abs() < 1e-3 * shifts[0],
        "{shifts:?}"
    );
}
