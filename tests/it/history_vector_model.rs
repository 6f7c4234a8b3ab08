//! Tests of histories of the vector model under loads of any direction and twist, in closed loops, and in sliding.

use kit::{max_abs, max_difference, rough, unit_bodies, unit_pair};
use stickslip::analytical::{HertzSphere, LubkinTorsion};
use stickslip::history::LoadPath;
use stickslip::{
    Axis, Boundary, Error, Field, HalfSpace, History, LoadStep, NormalLoad, TangentialControl,
    TangentialModel,
};

const FRICTION: f64 = 0.4;
const LOAD: f64 = 4.0;
const LIMIT: f64 = FRICTION * LOAD;

fn sphere_gap(cells: usize) -> Field {
    kit::sphere(kit::square(cells, 12.0), 20.0)
}

fn press(bodies: &HalfSpace, gap: &Field, lateral: TangentialModel, tolerance: f64) -> History {
    let mut history = History::builder(bodies, gap, kit::coulomb(FRICTION))
        .model(lateral)
        .tolerance(tolerance)
        .build()
        .unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(LOAD));
    history.step(&press).unwrap();
    history
}

/// Presses the sphere in the vector model.
fn press_ball(poisson_ratio: f64, tolerance: f64) -> History {
    let gap = sphere_gap(48);
    let bodies = unit_bodies(gap.grid(), poisson_ratio);
    press(&bodies, &gap, TangentialModel::Vector, tolerance)
}

fn step_of(x: TangentialControl, y: TangentialControl) -> LoadStep {
    LoadStep::hold()
        .tangential(Axis::X, x)
        .tangential(Axis::Y, y)
}

fn force_step([x, y]: [f64; 2]) -> LoadStep {
    step_of(TangentialControl::Force(x), TangentialControl::Force(y))
}

/// For Poisson's ratio zero, the tractions along x and y are uncoupled.
#[test]
fn load_along_an_axis_gives_the_scalar_model() {
    let gap = sphere_gap(48);
    let bodies = unit_bodies(gap.grid(), 0.0);
    let [mut plane, mut scalar] = [TangentialModel::Vector, TangentialModel::Scalar]
        .map(|lateral| press(&bodies, &gap, lateral, 1e-9));
    assert_eq!((plane.axis(), scalar.axis()), (None, Some(Axis::X)));
    let there = LoadPath::triangle([0.8 * LIMIT, 0.0], 16).unwrap();
    for force in there.cycles(2) {
        let load = force_step(force);
        plane.step(&load).unwrap();
        scalar.step(&load).unwrap();
        let [along, across] = plane.traction();
        let largest = FRICTION * scalar.pressure().max();
        let error = max_difference(along.as_slice(), scalar.traction()[0].as_slice());
        assert!(error < 1e-7 * largest, "{:e}", error / largest);
        assert!(max_abs(across.as_slice()) < 1e-7 * largest);
        let scale = 1e-7 * scalar.accumulated_slip().max();
        let [a, b] = [&plane, &scalar].map(|history| history.accumulated_slip().as_slice());
        assert!(max_difference(a, b) <= scale);
        assert!((plane.shift()[0] - scalar.shift()[0]).abs() < 1e-7);
        assert_eq!(plane.zones(), scalar.zones());
    }
}

/// Follows an ellipse of forces, and in a second case also an oscillating twist. The steady cycle, which is reached
/// only gradually, stores no energy.
#[test]
fn steady_closed_loop_dissipates_its_work() {
    let mut history = press_ball(0.3, 1e-10);
    let path = LoadPath::ellipse([0.6 * LIMIT, 0.4 * LIMIT], 1.0, 24).unwrap();
    let turns = LoadPath::sine([1.0, 0.0], 24).unwrap();
    for (turn, steadiness) in [(0.0, 1e-5), (0.04, 1e-4)] {
        let (mut work, mut dissipated, mut stored) = (0.0, 0.0, 0.0);
        for cycle in 0..5 {
            (work, dissipated, stored) = (0.0, 0.0, 0.0);
            for (force, part) in path.steps().iter().zip(turns.steps()) {
                let load = force_step(*force).twist(turn * part[0]);
                let energy = *history.step(&load).unwrap().energy();
                assert!(
                    energy.dissipated_energy >= 0.0 && energy.dissipated_energy_midpoint >= 0.0
                );
                work += energy.work;
                dissipated += energy.dissipated_energy_midpoint;
                stored += energy.elastic_after - energy.elastic_before;
            }
            let lost = (work - stored) / dissipated - 1.0;
            assert!(lost.abs() < 1e-9, "{cycle}: {lost:e}");
        }
        let unsteady = stored / dissipated;
        assert!(unsteady.abs() < steadiness, "{unsteady:e}");
        assert!((work / dissipated - 1.0).abs() < steadiness);
    }
}

#[test]
fn load_path_without_slip_is_reversible() {
    let gap = sphere_gap(48);
    let bodies = unit_bodies(gap.grid(), 0.3);
    let builder =
        History::builder(&bodies, &gap, kit::coulomb(50.0)).model(TangentialModel::Vector);
    let mut history = builder.tolerance(1e-10).build().unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(LOAD));
    history.step(&press).unwrap();
    let mut largest = 0.0_f64;
    for (force, twist) in [
        ([1.0, 0.0], 0.01),
        ([0.5, 0.7], -0.02),
        ([-0.3, 0.2], 0.0),
        ([0.0; 2], 0.0),
    ] {
        history.step(&force_step(force).twist(twist)).unwrap();
        largest = largest.max(history.traction()[0].max());
    }
    assert!(history.accumulated_slip().max() == 0.0);
    for axis in 0..2 {
        assert!(max_abs(history.traction()[axis].as_slice()) < 1e-8 * largest);
        assert!(history.shift()[axis].abs() < 1e-10);
    }
    assert!(history.moment().abs() < 1e-10);
}

/// Compares with Lubkin's closed form under an increasing twist, in one step or several.
#[test]
fn twist_matches_lubkin() {
    let mut errors = Vec::new();
    for cells in [48, 96] {
        let gap = sphere_gap(cells);
        let bodies = unit_bodies(gap.grid(), 0.3);
        let hertz = HertzSphere::new(bodies.pair(), 20.0, LOAD).unwrap();
        let strain =
            FRICTION * hertz.max_pressure() / (2.0 * bodies.pair().equivalent_shear_modulus());
        for steps in [1, 4] {
            let mut history = press(&bodies, &gap, TangentialModel::Vector, 1e-9);
            let twist = 1.5 * strain;
            for step in 1..=steps {
                let part = f64::from(step) / f64::from(steps);
                history.step(&LoadStep::hold().twist(part * twist)).unwrap();
            }
            let exact = LubkinTorsion::new(hertz, FRICTION, twist).unwrap();
            let moment = (history.moment() / exact.moment() - 1.0).abs();
            let stick = (history.last_step().unwrap().stick_ratio() - exact.stick_ratio()).abs();
            // A hold step keeps the twist.
            history.step(&LoadStep::hold()).unwrap();
            assert!((history.twist() - twist).abs() <= 1e-15);
            errors.push([moment, stick]);
        }
    }
    for [moment, stick] in &errors {
        assert!(*moment < 5e-3 && *stick < 2e-2, "{errors:?}");
    }
}

/// When the contact slides along x, the prescribed motion along y is unaffected.
#[test]
fn sliding_along_x_preserves_the_shift_along_y() {
    let mut history = press_ball(0.3, 1e-9);
    history
        .step(&step_of(
            TangentialControl::Force(LIMIT),
            TangentialControl::Shift(0.01),
        ))
        .unwrap();
    assert!(history.last_step().unwrap().is_gross_slip());
    assert!((history.shift()[1] - 0.01).abs() < 1e-15);
    assert!((history.tangential_force()[0] / LIMIT - 1.0).abs() < 1e-12);
    assert!(history.last_step().unwrap().dissipation().min() >= 0.0);
}

/// The contact is dragged along y or twisted beyond the friction limit while it carries a constant force.
#[test]
fn contact_slides_at_constant_force() {
    let gap = sphere_gap(48);
    let free = unit_bodies(gap.grid(), 0.3);
    let periodic = HalfSpace::with_boundary(gap.grid(), *free.pair(), Boundary::Periodic).unwrap();
    for bodies in [free, periodic] {
        for part in [0.0, 0.5, 0.9] {
            let mut history = press(&bodies, &gap, TangentialModel::Vector, 1e-8);
            let force = TangentialControl::Force(part * LIMIT);
            for shift in [0.1, 1.0, 1.2, 0.0, -1.0] {
                let load = step_of(force, TangentialControl::Shift(shift));
                history.step(&load).unwrap();
                let [x, y] = history.tangential_force();
                assert!((x - part * LIMIT).abs() < 1e-11 * LIMIT);
                assert!(history.last_step().unwrap().dissipation().min() >= 0.0);
                if shift.abs() >= 1.0 {
                    assert!(history.last_step().unwrap().is_gross_slip());
                    let sliding = (LIMIT * LIMIT - x * x).sqrt().copysign(shift);
                    assert!((y / sliding - 1.0).abs() < 1e-4);
                }
            }
            for twist in [0.1, 0.5, 1.0, -0.5, 0.0] {
                let load = force_step([part * LIMIT, 0.0]).twist(twist);
                if bodies.boundary() == Boundary::NonPeriodic {
                    history.step(&load).unwrap();
                    assert!(twist.abs() < 0.5 || history.last_step().unwrap().is_gross_slip());
                }
            }
        }
    }
}

#[test]
fn twist_on_periodic_grid_is_rejected() {
    let grid = kit::square(32, 12.0);
    let bodies = HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap();
    let mut history = press(&bodies, &rough(grid, 6), TangentialModel::Vector, 1e-6);
    let refused = history.step(&LoadStep::hold().twist(0.1));
    let Err(error @ Error::UnsupportedByModel { value, .. }) = refused else {
        panic!("{refused:?}")
    };
    let message = error.to_string();
    assert!(value == 0.1 && message.contains("periodic") && !message.contains("TangentialModel"));
}
