//! Histories with both tractions: loads of any direction and twist, slip against traction, every work found
//! again, all or nothing, to the same bits after a restart.

use std::ops::ControlFlow;

use kit::{Random, max_abs, max_difference, rough, unit_bodies, unit_pair};
use stickslip::analytical::{HertzSphere, LubkinTorsion};
use stickslip::history::LoadPath;
use stickslip::{
    Axis, Boundary, Error, Field, Friction, Grid, HalfSpace, History, LoadStep, NormalControl,
    TangentialControl, TangentialModel, Zone, surface,
};

const FRICTION: f64 = 0.4;
const LOAD: f64 = 4.0;
const LIMIT: f64 = FRICTION * LOAD;

fn sphere(cells: usize) -> Field {
    surface::sphere(Grid::square(cells, 12.0).unwrap(), 20.0).unwrap()
}

fn pressed(bodies: &HalfSpace, gap: &Field, lateral: TangentialModel, tolerance: f64) -> History {
    let friction = Friction::coulomb(FRICTION).unwrap();
    let mut history = History::builder(bodies, gap, friction)
        .model(lateral)
        .tolerance(tolerance)
        .build()
        .unwrap();
    let press = LoadStep::hold().normal(NormalControl::Force(LOAD));
    history.step(&press).unwrap();
    history
}

/// The sphere in the vector model.
fn ball(poisson_ratio: f64, tolerance: f64) -> History {
    let gap = sphere(48);
    let bodies = unit_bodies(gap.grid(), poisson_ratio);
    pressed(&bodies, &gap, TangentialModel::Vector, tolerance)
}

fn both(x: TangentialControl, y: TangentialControl) -> LoadStep {
    LoadStep::hold()
        .tangential(Axis::X, x)
        .tangential(Axis::Y, y)
}

fn forces([x, y]: [f64; 2]) -> LoadStep {
    both(TangentialControl::Force(x), TangentialControl::Force(y))
}

/// Without Poisson's ratio the tractions along x and y do not see each other's displacements.
#[test]
fn a_load_along_an_axis_is_that_of_the_scalar_model() {
    let gap = sphere(48);
    let bodies = unit_bodies(gap.grid(), 0.0);
    let [mut plane, mut scalar] = [TangentialModel::Vector, TangentialModel::Scalar]
        .map(|lateral| pressed(&bodies, &gap, lateral, 1e-9));
    assert_eq!((plane.axis(), scalar.axis()), (None, Some(Axis::X)));
    let there = LoadPath::triangle([0.8 * LIMIT, 0.0], 16).unwrap();
    for force in there.cycles(2) {
        let load = forces(force);
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

/// Turns a path of forces, shifts and twist by a right angle, from x to y.
#[test]
fn a_turned_path_turns_the_answer() {
    let (mut one, mut other) = (ball(0.3, 1e-9), ball(0.3, 1e-9));
    let n = one.grid().nx();
    let shift = TangentialControl::Shift;
    let force = TangentialControl::Force;
    for (x, y, twist) in [
        (force(0.5), force(-0.9), 0.0),
        (force(-0.4), shift(0.1), 0.05),
        (shift(0.2), force(0.3), 0.02),
        (shift(-0.1), TangentialControl::Hold, -0.03),
        (force(0.0), force(0.0), 0.0),
    ] {
        let minus = match y {
            TangentialControl::Force(y) => force(-y),
            TangentialControl::Shift(y) => shift(-y),
            other => other,
        };
        one.step(&both(x, y).twist(twist)).unwrap();
        other.step(&both(minus, x).twist(twist)).unwrap();
        let [a, b] = [&one, &other].map(History::shift);
        assert!((b[0] + a[1]).abs() < 1e-8 && (b[1] - a[0]).abs() < 1e-8);
        assert!((one.moment() - other.moment()).abs() < 1e-8);
        let [ax, ay] = one.traction();
        let [bx, by] = other.traction();
        for iy in 0..n {
            for ix in 0..n {
                let (i, turned) = (iy * n + ix, ix * n + (n - 1 - iy));
                let error = [
                    bx.as_slice()[turned] + ay.as_slice()[i],
                    by.as_slice()[turned] - ax.as_slice()[i],
                ];
                assert!(max_abs(&error) < 1e-7, "{error:?}");
            }
        }
    }
}

/// Slip of any step is against the traction at its end, and there is none in stick.
#[test]
fn slip_opposes_traction() {
    let mut history = ball(0.3, 1e-10);
    let mut random = Random(7);
    let mut slipped = 0;
    for _ in 0..12 {
        let angle = random.uniform(0.0, std::f64::consts::TAU);
        let size = random.uniform(0.2, 0.95) * LIMIT;
        let load = forces([size * angle.cos(), size * angle.sin()]);
        let step = history.step(&load).unwrap().clone();
        let largest = step.slip_distance().max();
        for (i, zone) in history.zones().iter().enumerate() {
            let slip = step.slip().map(|slip| slip.as_slice()[i]);
            let traction = history.traction().map(|traction| traction.as_slice()[i]);
            let limit = FRICTION * history.pressure().as_slice()[i];
            let size = traction[0].hypot(traction[1]);
            if *zone == Zone::Slip {
                slipped += 1;
                assert!((size / limit - 1.0).abs() < 1e-11);
                let along = (slip[0] * traction[0] + slip[1] * traction[1]) / size;
                let across = (slip[0] * traction[1] - slip[1] * traction[0]) / size;
                assert!(along <= 0.0 && across.abs() < 1e-6 * largest, "{across:e}");
            } else {
                assert!(slip == [0.0; 2] && size <= limit);
            }
        }
    }
    assert!(slipped > 1000, "{slipped}");
}

/// Forces, shifts and twist at once, on a sphere, a rough surface and one that repeats.
#[test]
fn every_step_balances() {
    let grid = Grid::square(48, 12.0).unwrap();
    let mut rough = rough(grid, 3);
    for height in rough.as_mut_slice() {
        *height *= 0.1;
    }
    let free = unit_bodies(grid, 0.3);
    let periodic = HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap();
    for (bodies, gap) in [(&free, &sphere(48)), (&free, &rough), (&periodic, &rough)] {
        let mut history = pressed(bodies, gap, TangentialModel::Vector, 1e-7);
        let turn = if bodies.boundary() == Boundary::NonPeriodic {
            0.05
        } else {
            0.0
        };
        let mut random = Random(5);
        for number in 0..16 {
            let mut part = || random.uniform(-0.6, 0.6);
            let (x, y) = (TangentialControl::Force(part() * LIMIT), part());
            let y = match number % 3 {
                0 => TangentialControl::Force(y * LIMIT),
                1 => TangentialControl::Shift(0.3 * y),
                _ => TangentialControl::Hold,
            };
            let twist = turn * part();
            // The pressure changes now and then, and takes contact away.
            let mut load = both(x, y).twist(twist);
            let held = number % 4 != 3;
            if !held {
                let normal = if number % 8 == 3 { 0.8 } else { 1.0 };
                load = load.normal(NormalControl::Force(normal * LOAD));
            }
            let step = history.step(&load).unwrap();
            let energy = step.energy();
            let scale = energy.elastic_before.max(energy.elastic_after) + energy.work.abs();
            assert!(energy.imbalance().abs() < 1e-12 * scale, "{energy:?}");
            assert!(step.dissipated_energy().min() >= 0.0);
            if held {
                assert!(step.mid_step_dissipated_energy().min() >= -1e-9 * scale);
                assert!(energy.residual.abs() < 1e-5 * scale, "{energy:?}");
                assert!(energy.released.abs() < 1e-14 * scale);
            }
            let sum: f64 = step.dissipated_energy().as_slice().iter().sum();
            assert!((sum - energy.dissipated_energy).abs() <= 1e-12 * energy.dissipated_energy);
        }
    }
}

/// Half of traction times displacement, over all cells, is the elastic energy of the step.
#[test]
fn displacement_stores_the_elastic_energy() {
    let gap = sphere(48);
    let free = unit_bodies(gap.grid(), 0.3);
    let periodic = HalfSpace::with_boundary(gap.grid(), *free.pair(), Boundary::Periodic).unwrap();
    for bodies in [free, periodic] {
        for (lateral, across) in [
            (TangentialModel::Scalar, 0.0),
            (TangentialModel::Vector, 0.4),
        ] {
            let mut history = pressed(&bodies, &gap, lateral, 1e-8);
            history.step(&forces([0.7, across])).unwrap();
            let displacement = history.displacement().unwrap();
            let pairs = history.traction().into_iter().zip(&displacement);
            let products = pairs.flat_map(|(q, u)| q.as_slice().iter().zip(u.as_slice()));
            let sum: f64 = products.map(|(q, u)| q * u).sum();
            let energy = 0.5 * gap.grid().cell_area() * sum;
            let error = energy / history.last_step().energy().elastic_after - 1.0;
            assert!(error.abs() < 1e-12, "{error:e}");
        }
    }
}

/// Around an ellipse of forces, and to and fro in twist too; the steady cycle, to which it shakes down only
/// gradually, stores nothing.
#[test]
fn a_closed_loop_dissipates_its_work() {
    let mut history = ball(0.3, 1e-10);
    let path = LoadPath::ellipse([0.6 * LIMIT, 0.4 * LIMIT], 1.0, 24).unwrap();
    let turns = LoadPath::sine([1.0, 0.0], 24).unwrap();
    for (turn, steadiness) in [(0.0, 1e-5), (0.04, 1e-4)] {
        let (mut work, mut dissipated, mut stored) = (0.0, 0.0, 0.0);
        for cycle in 0..5 {
            (work, dissipated, stored) = (0.0, 0.0, 0.0);
            for (force, part) in path.steps().iter().zip(turns.steps()) {
                let load = forces(*force).twist(turn * part[0]);
                let energy = *history.step(&load).unwrap().energy();
                assert!(
                    energy.dissipated_energy >= 0.0 && energy.mid_step_dissipated_energy >= 0.0
                );
                work += energy.work;
                dissipated += energy.mid_step_dissipated_energy;
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
fn without_slip_the_way_back_ends_at_the_start() {
    let gap = sphere(48);
    let bodies = unit_bodies(gap.grid(), 0.3);
    let friction = Friction::coulomb(50.0).unwrap();
    let builder = History::builder(&bodies, &gap, friction).model(TangentialModel::Vector);
    let mut history = builder.tolerance(1e-10).build().unwrap();
    let press = LoadStep::hold().normal(NormalControl::Force(LOAD));
    history.step(&press).unwrap();
    let mut largest = 0.0_f64;
    for (force, twist) in [
        ([1.0, 0.0], 0.01),
        ([0.5, 0.7], -0.02),
        ([-0.3, 0.2], 0.0),
        ([0.0; 2], 0.0),
    ] {
        history.step(&forces(force).twist(twist)).unwrap();
        largest = largest.max(history.traction()[0].max());
    }
    assert!(history.accumulated_slip().max() == 0.0);
    for axis in 0..2 {
        assert!(max_abs(history.traction()[axis].as_slice()) < 1e-8 * largest);
        assert!(history.shift()[axis].abs() < 1e-10);
    }
    assert!(history.moment().abs() < 1e-10);
}

/// Lubkin's closed form under a twist that grows, in one step or several.
#[test]
fn a_twist_follows_lubkin() {
    let mut errors = Vec::new();
    for cells in [48, 96] {
        let gap = sphere(cells);
        let bodies = unit_bodies(gap.grid(), 0.3);
        let hertz = HertzSphere::new(bodies.pair(), 20.0, LOAD).unwrap();
        let strain =
            FRICTION * hertz.max_pressure() / (2.0 * bodies.pair().equivalent_shear_modulus());
        for steps in [1, 4] {
            let mut history = pressed(&bodies, &gap, TangentialModel::Vector, 1e-9);
            let twist = 1.5 * strain;
            for step in 1..=steps {
                let part = f64::from(step) / f64::from(steps);
                history.step(&LoadStep::hold().twist(part * twist)).unwrap();
            }
            let exact = LubkinTorsion::new(hertz, FRICTION, twist).unwrap();
            let moment = (history.moment() / exact.moment() - 1.0).abs();
            let stick = (history.last_step().stick_ratio() - exact.stick_ratio()).abs();
            // A held step keeps the twist.
            history.step(&LoadStep::hold()).unwrap();
            assert!((history.twist() - twist).abs() <= 1e-15);
            errors.push([moment, stick]);
        }
    }
    for [moment, stick] in &errors {
        assert!(*moment < 5e-3 && *stick < 2e-2, "{errors:?}");
    }
}

/// At the limit along x, the motion prescribed along y stays what it is.
#[test]
fn sliding_along_x_leaves_the_shift_along_y() {
    let mut history = ball(0.3, 1e-9);
    history
        .step(&both(
            TangentialControl::Force(LIMIT),
            TangentialControl::Shift(0.01),
        ))
        .unwrap();
    assert!(history.last_step().is_gross_slip());
    assert!((history.shift()[1] - 0.01).abs() < 1e-15);
    assert!((history.force()[0] / LIMIT - 1.0).abs() < 1e-12);
    assert!(history.last_step().dissipated_energy().min() >= 0.0);
}

/// Dragged along y through the friction limit, or turned through it, under a force it goes on carrying.
#[test]
fn all_slides_under_a_force() {
    let gap = sphere(48);
    let free = unit_bodies(gap.grid(), 0.3);
    let periodic = HalfSpace::with_boundary(gap.grid(), *free.pair(), Boundary::Periodic).unwrap();
    for bodies in [free, periodic] {
        for part in [0.0, 0.5, 0.9] {
            let mut history = pressed(&bodies, &gap, TangentialModel::Vector, 1e-8);
            let force = TangentialControl::Force(part * LIMIT);
            for shift in [0.1, 1.0, 1.2, 0.0, -1.0] {
                let load = both(force, TangentialControl::Shift(shift));
                history.step(&load).unwrap();
                let [x, y] = history.force();
                assert!((x - part * LIMIT).abs() < 1e-11 * LIMIT);
                assert!(history.last_step().dissipated_energy().min() >= 0.0);
                if shift.abs() >= 1.0 {
                    assert!(history.last_step().is_gross_slip());
                    let sliding = (LIMIT * LIMIT - x * x).sqrt().copysign(shift);
                    assert!((y / sliding - 1.0).abs() < 1e-4);
                }
            }
            for twist in [0.1, 0.5, 1.0, -0.5, 0.0] {
                let load = forces([part * LIMIT, 0.0]).twist(twist);
                if bodies.boundary() == Boundary::NonPeriodic {
                    history.step(&load).unwrap();
                    assert!(twist.abs() < 0.5 || history.last_step().is_gross_slip());
                }
            }
        }
    }
}

/// The steps of a run that presses, shears, turns and loses contact.
fn run(history: &mut History, first: usize) {
    let hold = TangentialControl::Hold;
    let shift = TangentialControl::Shift;
    let steps = [
        forces([0.8, -0.6]),
        both(shift(0.1), hold).twist(0.03),
        forces([0.2, 0.5]).normal(NormalControl::Force(0.7 * LOAD)),
        both(hold, shift(-0.1)).normal(NormalControl::Force(2.0 * LOAD)),
        forces([-0.3, 0.1]).twist(-0.01),
    ];
    for load in &steps[first..] {
        history.step(load).unwrap();
    }
}

#[test]
fn a_restored_history_goes_on_to_the_same_bits() {
    let gap = sphere(48);
    let bodies = unit_bodies(gap.grid(), 0.3);
    let mut whole = pressed(&bodies, &gap, TangentialModel::Vector, 1e-8);
    run(&mut whole, 3);
    let saved = whole.to_bytes();
    let mut restored = History::from_bytes(&bodies, &saved).unwrap();
    assert_eq!(restored.to_bytes(), saved);
    assert!(restored.twist() != 0.0 && restored.moment() == whole.moment());
    run(&mut whole, 0);
    run(&mut restored, 0);
    assert_eq!(restored.to_bytes(), whole.to_bytes());
}

#[test]
fn a_failed_step_leaves_every_bit() {
    let (mut history, mut twin) = (ball(0.3, 1e-8), ball(0.3, 1e-8));
    run(&mut history, 2);
    run(&mut twin, 2);
    assert!(history.step(&LoadStep::hold().twist(f64::NAN)).is_err());
    assert!(history.step(&forces([0.0, f64::NAN])).is_err());
    let wide = forces([30.0, 40.0]).normal(NormalControl::Force(20.0 * LOAD));
    let refused = history.step(&wide);
    assert!(matches!(refused, Err(Error::BeyondFrictionCapacity { force, .. }) if force == 50.0));
    for patience in [1, 8] {
        let mut seen = 0;
        let outcome = history.step_observed(&forces([0.3, 0.9]).twist(0.02), |_| {
            seen += 1;
            if seen > patience {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        assert!(matches!(outcome, Err(Error::NotConverged(_))));
    }
    assert_eq!(history.to_bytes(), twin.to_bytes());
    run(&mut history, 0);
    run(&mut twin, 0);
    assert_eq!(history.to_bytes(), twin.to_bytes());
}

#[test]
fn what_repeats_does_not_turn() {
    let grid = Grid::square(32, 12.0).unwrap();
    let bodies = HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap();
    let mut history = pressed(&bodies, &rough(grid, 6), TangentialModel::Vector, 1e-6);
    let refused = history.step(&LoadStep::hold().twist(0.1));
    let Err(error @ Error::NotModelled { value, .. }) = refused else {
        panic!("{refused:?}")
    };
    let message = error.to_string();
    assert!(value == 0.1 && message.contains("repeats") && !message.contains("TangentialModel"));
}
