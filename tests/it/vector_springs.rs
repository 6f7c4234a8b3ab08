//! Springs in the vector model act along x, along y or along both axes, together with any other load. Each spring
//! exerts the force k (X - delta). The solution equals the solution under the same forces or the same shifts.

use kit::{max_difference, rough, unit_bodies, unit_pair};
use stickslip::history::LoadPath;
use stickslip::{
    Axis, Boundary, Error, Field, HalfSpace, History, LoadStep, NormalLoad, TangentialControl,
    TangentialModel,
};

const FRICTION: f64 = 0.4;
const LOAD: f64 = 4.0;
const LIMIT: f64 = FRICTION * LOAD;
/// Approximate stiffness of the contact itself.
const STIFFNESS: f64 = 4.0;
const TOLERANCE: f64 = 1e-9;

fn pressed(poisson_ratio: f64, lateral: TangentialModel) -> History {
    let grid = kit::square(48, 12.0);
    let ball = kit::sphere(grid, 20.0);
    press(&unit_bodies(grid, poisson_ratio), &ball, lateral)
}

fn press(bodies: &HalfSpace, gap: &Field, lateral: TangentialModel) -> History {
    press_to(TOLERANCE, bodies, gap, lateral)
}

fn press_to(tolerance: f64, bodies: &HalfSpace, gap: &Field, lateral: TangentialModel) -> History {
    let builder = History::builder(bodies, gap, kit::coulomb(FRICTION)).model(lateral);
    let mut history = builder.tolerance(tolerance).build().unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(LOAD));
    history.step(&press).unwrap();
    history
}

fn both(x: TangentialControl, y: TangentialControl) -> LoadStep {
    LoadStep::hold()
        .tangential(Axis::X, x)
        .tangential(Axis::Y, y)
}

/// Returns the largest difference of the tractions, relative to the largest friction limit.
fn traction_error(a: &History, b: &History) -> f64 {
    let difference = |n: usize| {
        let [a, b] = [a, b].map(|history| history.traction()[n].as_slice());
        max_difference(a, b)
    };
    difference(0).max(difference(1)) / (FRICTION * a.pressure().max())
}

/// Returns the largest difference of the shifts, relative to the shift at which every cell slides.
fn shift_error(a: &History, b: &History) -> f64 {
    max_difference(&a.shift(), &b.shift()) / (LIMIT / STIFFNESS)
}

#[test]
fn springs_of_any_stiffness_match_forces_and_shifts() {
    use TangentialControl::{Force, Hold, Shift};
    let grid = kit::square(48, 12.0);
    let repeats = HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap();
    let scenes = [
        (unit_bodies(grid, 0.3), kit::sphere(grid, 20.0)),
        (repeats, rough(grid, 6)),
    ];
    for (bodies, gap) in &scenes {
        for &stiffness in kit::thorough(
            &[1e-3, STIFFNESS, 1e7][..],
            &[1e-3, 0.1, STIFFNESS, 1e3, 1e7],
        ) {
            let [mut by_spring, mut by_force, mut by_shift] =
                [(); 3].map(|()| press(bodies, gap, TangentialModel::Vector));
            // Returns a spring that exerts approximately `part` of the friction limit on a sticking contact.
            let pull = |part: f64, stiffness: f64| {
                let compliance = 1.0 / STIFFNESS + 1.0 / stiffness;
                kit::spring(part * LIMIT * compliance, stiffness)
            };
            let other = 3.0 * stiffness;
            for (x, y, twist) in [
                (pull(0.5, stiffness), pull(-0.3, other), 0.0),
                (pull(0.7, stiffness), Force(0.4 * LIMIT), 0.02),
                (Shift(-0.1), pull(0.4, stiffness), 0.02),
                (Hold, pull(-0.8, stiffness), -0.01),
                (pull(-0.6, other), pull(0.6, stiffness), 0.0),
            ] {
                let twist = match bodies.boundary() {
                    Boundary::NonPeriodic => twist,
                    _ => 0.0,
                };
                by_spring.step(&both(x, y).twist(twist)).unwrap();
                let (force, shift) = (by_spring.tangential_force(), by_spring.shift());
                for (axis, load) in [x, y].into_iter().enumerate() {
                    if let TangentialControl::Spring {
                        position,
                        stiffness,
                    } = load
                    {
                        // The tolerance is the accuracy to which the ends determine the extension of the spring.
                        let error = force[axis] - stiffness * (position - shift[axis]);
                        let round_off = stiffness * (position.abs() + shift[axis].abs());
                        assert!(
                            error.abs() < 1e-13 * (LIMIT + round_off),
                            "{stiffness}: {error:e}"
                        );
                    }
                }
                assert!(force[0].hypot(force[1]) <= LIMIT * (1.0 + 1e-12));
                let report = by_spring.last_step().unwrap().tangential_report().unwrap();
                assert!(report.is_converged() && report.residual <= TOLERANCE);
                assert!(report.energy_error_bound() <= TOLERANCE);

                by_force.step(&LoadStep::force(force).twist(twist)).unwrap();
                by_shift.step(&LoadStep::shift(shift).twist(twist)).unwrap();
                for other in [&by_force, &by_shift] {
                    let (traction, shift) = (
                        traction_error(&by_spring, other),
                        shift_error(&by_spring, other),
                    );
                    assert!(traction < 1e-6, "{stiffness}: {traction:e}");
                    assert!(shift < 1e-8, "{stiffness}: {shift:e}");
                }
            }
        }
    }
}

/// Flat periodic surfaces in full contact do not deform under a uniform traction, so only the springs deform.
#[test]
fn flat_periodic_surface_moves_by_its_springs_only() {
    let grid = kit::square(16, 12.0);
    let bodies = HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap();
    for stiffness in [1e-3, 1.0, 1e3, 1e5] {
        for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
            let mut history = press(&bodies, &Field::zeros(grid), lateral);
            for part in [0.5, -0.8, 0.1] {
                let pull = kit::spring(part * LIMIT / stiffness, stiffness);
                let load = match lateral {
                    TangentialModel::Scalar => LoadStep::hold().tangential(Axis::X, pull),
                    _ => both(pull, kit::spring(0.1 * LIMIT, 1.0)),
                };
                history.step(&load).unwrap();
                let error = history.tangential_force()[0] / (part * LIMIT) - 1.0;
                assert!(error.abs() < 1e-12, "{stiffness}, {lateral:?}: {error:e}");
                assert!(history.accumulated_slip().max() == 0.0);
            }
        }
    }
}

/// These surfaces deform so little that the error of the shift allowed by the tolerance may be relatively large. The
/// error of the force must remain small.
#[test]
fn stiff_spring_gives_accurate_force_or_an_error() {
    let grid = kit::square(16, 12.0);
    let bodies = HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap();
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        for tolerance in [1e-4, 1e-6, 1e-8] {
            let mut solved = 0;
            for stiffness in [1e3, 1e5, 1e7, 1e9, 1e11] {
                let mut history = press_to(tolerance, &bodies, &Field::zeros(grid), lateral);
                let pull = kit::spring(0.5 * LIMIT / stiffness, stiffness);
                let step = LoadStep::hold().tangential(Axis::X, pull);
                if history.step(&step).is_ok() {
                    solved += 1;
                    let error = (history.tangential_force()[0] / (0.5 * LIMIT) - 1.0).abs();
                    assert!(
                        error < 2.0 * tolerance,
                        "{stiffness}, {lateral:?}: {error:e}"
                    );
                }
            }
            assert!(solved >= 2, "{lateral:?}, {tolerance}");
        }
    }
}

/// A very stiff spring prescribes the shift. A very soft spring with a distant far end prescribes the force.
#[test]
fn stiff_and_soft_springs_prescribe_shift_and_force() {
    let [mut rod, mut by_shift, mut soft, mut by_force] =
        [(); 4].map(|()| pressed(0.3, TangentialModel::Vector));
    for part in [[0.5, 0.2], [-0.3, 0.6], [0.1, -0.8]] {
        let shift = part.map(|part| part * LIMIT / STIFFNESS);
        let [x, y] = shift.map(|shift| kit::spring(shift, 1e10));
        rod.step(&both(x, y)).unwrap();
        by_shift.step(&LoadStep::shift(shift)).unwrap();
        let error = traction_error(&rod, &by_shift);
        assert!(error < 1e-7, "{error:e}");

        let force = part.map(|part| part * LIMIT);
        let [x, y] = force.map(|force| kit::spring(1e4 * force, 1e-4));
        soft.step(&both(x, y)).unwrap();
        by_force.step(&LoadStep::force(force)).unwrap();
        let error = traction_error(&soft, &by_force);
        // The motion of the contact reduces the force of the spring.
        assert!(error < 1e-4, "{error:e}");
    }
}

/// For a Poisson's ratio of zero the tractions along x and y are uncoupled.
#[test]
fn uncoupled_spring_matches_scalar_model() {
    let [mut plane, mut scalar] =
        [TangentialModel::Vector, TangentialModel::Scalar].map(|lateral| pressed(0.0, lateral));
    for (position, stiffness) in [(0.4, 2.0), (0.7, 2.0), (-0.5, 8.0), (0.1, 0.5), (3.0, 2.0)] {
        let load = LoadStep::hold().tangential(Axis::X, kit::spring(position, stiffness));
        plane.step(&load).unwrap();
        scalar.step(&load).unwrap();
        let (traction, shift) = (
            traction_error(&plane, &scalar),
            shift_error(&plane, &scalar),
        );
        assert!(traction < 1e-7 && shift < 1e-8, "{traction:e}, {shift:e}");
        assert_eq!(plane.zones(), scalar.zones());
    }
}

/// The far ends of two springs move around an ellipse. Their work minus the stored energy equals the energy dissipated
/// by slip.
#[test]
fn closed_loop_dissipates_work_of_far_ends() {
    let mut history = pressed(0.3, TangentialModel::Vector);
    let stiffness = [2.0, 6.0];
    let path = LoadPath::ellipse([0.6, 0.3], 1.0, 24).unwrap();
    let mut last = [0.0; 2];
    let spring_energy = |force: [f64; 2]| {
        0.5 * (force[0] * force[0] / stiffness[0] + force[1] * force[1] / stiffness[1])
    };
    for cycle in 0..3 {
        let before = history.tangential_force();
        let (mut work, mut dissipated, mut stored) = (0.0, 0.0, 0.0);
        for position in path.steps() {
            let force = history.tangential_force();
            let [x, y] = [0, 1].map(|axis| kit::spring(position[axis], stiffness[axis]));
            let step = history.step(&both(x, y)).unwrap();
            let (after, energy) = (step.tangential_force(), step.energy());
            for axis in 0..2 {
                work += 0.5 * (force[axis] + after[axis]) * (position[axis] - last[axis]);
            }
            last = *position;
            assert!(energy.dissipated_energy >= 0.0 && energy.dissipated_energy_midpoint >= 0.0);
            let scale = energy.elastic_before.max(energy.elastic_after) + energy.work.abs();
            assert!(energy.imbalance().abs() < 1e-12 * scale, "{energy:?}");
            dissipated += energy.dissipated_energy_midpoint;
            stored += energy.elastic_after - energy.elastic_before;
        }
        stored += spring_energy(history.tangential_force()) - spring_energy(before);
        let lost = (work - stored) / dissipated - 1.0;
        assert!(lost.abs() < 1e-9, "{cycle}: {lost:e}");
    }
}

/// Springs can slide the contact: their total force is at the friction limit, and body 2 follows their far ends.
#[test]
fn springs_can_slide_the_contact() {
    let mut history = pressed(0.3, TangentialModel::Vector);
    let limit = FRICTION * history.pressure().integral();
    let stiffness = [4.0, 2.0];
    for (way, slides) in [(2.0, true), (4.0, true), (80.0, true), (79.5, false)] {
        let position = [0.6 * way, 0.8 * way];
        let [x, y] = [0, 1].map(|axis| kit::spring(position[axis], stiffness[axis]));
        let before = history.shift();
        let step = history.step(&both(x, y)).unwrap();
        assert_eq!(step.is_gross_slip(), slides, "{way}");
        let (force, shift) = (step.tangential_force(), step.shift());
        let pull = force[0].hypot(force[1]);
        for axis in 0..2 {
            let given_way = position[axis] - force[axis] / stiffness[axis];
            assert!((shift[axis] - given_way).abs() < 1e-12 * way);
        }
        if slides {
            assert!((pull / limit - 1.0).abs() < 1e-3 && pull <= limit * (1.0 + 1e-12));
            // The force is along the motion of body 2, except for the part due to the deformation of the surfaces.
            let [dx, dy] = [0, 1].map(|axis| shift[axis] - before[axis]);
            let along = (force[0] * dx + force[1] * dy) / (pull * dx.hypot(dy));
            assert!(along > 0.99);
        } else {
            assert!(pull < 0.9 * limit);
        }
    }

    // If a force at the friction limit causes gross slip, the force of a spring across this force is zero.
    let slide = both(TangentialControl::Force(limit), kit::spring(70.0, 2.0));
    let step = history.step(&slide).unwrap();
    assert!(step.is_gross_slip());
    assert!(
        (step.tangential_force()[0] / limit - 1.0).abs() < 1e-12
            && step.tangential_force()[1].abs() < 1e-12
    );
    assert!((step.shift()[1] - 70.0).abs() < 1e-12);
}

#[test]
fn invalid_springs_are_rejected() {
    let mut history = pressed(0.3, TangentialModel::Vector);
    history
        .step(&both(kit::spring(0.2, 3.0), kit::spring(0.1, 2.0)))
        .unwrap();
    let saved = history.to_bytes();
    for stiffness in [0.0, -2.0, f64::INFINITY, f64::NAN] {
        let bad = kit::spring(0.1, stiffness);
        for load in [
            both(bad, TangentialControl::Hold),
            both(TangentialControl::Force(0.1), bad),
        ] {
            let Err(Error::NotPositive { value, .. }) = history.step(&load) else {
                panic!("{load:?}")
            };
            assert_eq!(value.to_bits(), stiffness.to_bits());
        }
    }
    let refused = history.step(&both(TangentialControl::Hold, kit::spring(f64::NAN, 2.0)));
    assert!(matches!(refused, Err(Error::NotFinite { .. })));
    assert_eq!(history.to_bytes(), saved);
}
