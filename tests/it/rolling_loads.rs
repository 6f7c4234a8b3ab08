//! Stiffness, moments and creep curves of steady rolling agree with single solves, and solves stay within limits on the
//! number of products.

use std::ops::ControlFlow;

use stickslip::rolling::{
    LeadingEdge, RollingControl, RollingProblem, RollingProblemBuilder, SpinControl,
};
use stickslip::{
    Axis, Error, Field, Friction, Grid, HalfSpace, NormalLoad, NormalProblem, NormalSolution,
    Status,
};

/// Kalker's longitudinal coefficient of a circular contact for a Poisson's ratio of 0.25.
const KALKER: f64 = 4.12;
const FRICTION: f64 = 0.3;

struct RollingSphere {
    bodies: HalfSpace,
    normal: NormalSolution,
    /// Creepage at which the linear theory reaches the friction limit.
    unit: f64,
    limit: f64,
}

impl RollingSphere {
    /// Returns a sphere of contact radius one on the given number of cells across.
    fn across(cells: usize) -> Self {
        let size = cells + 6;
        let grid = kit::square(size, 2.0 * size as f64 / cells as f64);
        let bodies = HalfSpace::new(grid, kit::alike_in_shear(1.0, 0.25)).unwrap();
        let load = 4.0 / 3.0 * bodies.pair().contact_modulus();
        let normal =
            NormalProblem::builder(&bodies, kit::sphere(grid, 1.0), NormalLoad::Force(load));
        let normal = kit::solve(normal.tolerance(1e-11));
        let limit = FRICTION * load;
        Self {
            bodies,
            normal,
            unit: limit / KALKER,
            limit,
        }
    }

    fn rolling(&self) -> RollingProblemBuilder<'_> {
        RollingProblem::builder(&self.bodies, &self.normal, kit::coulomb(FRICTION))
    }

    fn at(&self, [xi, eta, spin]: [f64; 3]) -> RollingProblemBuilder<'_> {
        let rolling = self.rolling().creepage([xi * self.unit, eta * self.unit]);
        rolling.spin(spin * self.unit).tolerance(1e-11)
    }

    fn loads(&self, point: [f64; 3]) -> [f64; 3] {
        loads(self.at(point))
    }
}

/// Returns the forces along x and y, and the moment.
fn loads(rolling: RollingProblemBuilder<'_>) -> [f64; 3] {
    let rolling = kit::solve(rolling);
    [rolling.force()[0], rolling.force()[1], rolling.moment()]
}

#[test]
fn rolling_stiffness_matches_differences_of_solves() {
    let scene = RollingSphere::across(24);
    for (edge, point) in [
        (LeadingEdge::PlusX, [0.5, 0.4, 0.5]),
        (LeadingEdge::MinusX, [1.2, 0.0, 0.1]),
        (LeadingEdge::PlusY, [0.1, -1.0, -0.6]),
    ] {
        let at = |point: [f64; 3]| scene.at(point).leading_edge(edge);
        let mut solver = kit::solver(at(point));
        let mut rolling = kit::solved(&mut solver);
        let found = solver.stiffness().unwrap();
        for motion in 0..3 {
            let step = 1e-5;
            let [before, after] = [-step, step].map(|step| {
                let mut moved = point;
                moved[motion] += step;
                loads(at(moved))
            });
            for load in 0..3 {
                let slope = (after[load] - before[load]) / (2.0 * step * scene.unit);
                let error = (found[load][motion] - slope).abs();
                assert!(error < 1e-6, "{load} by {motion}: {error:e} of {slope}");
            }
        }
        // Prescribed forces must give the same stiffness.
        let forces = rolling.force().map(RollingControl::Force);
        solver
            .set_load(forces, SpinControl::Spin(rolling.spin()))
            .unwrap();
        solver.solve_into(&mut rolling).unwrap();
        let again = solver.stiffness().unwrap();
        let errors = again.iter().flatten().zip(found.iter().flatten());
        assert!(
            errors
                .into_iter()
                .all(|(again, found)| (again - found).abs() < 1e-6)
        );
    }
}

/// The stiffness of a sticking contact has Kalker's coefficients, and is reciprocal within the discretisation error.
#[test]
fn stiffness_before_first_solve_is_that_of_full_stick() {
    let scene = RollingSphere::across(64);
    let mut solver = kit::solver(scene.rolling());
    let of = solver.stiffness().unwrap();
    for (found, expected) in [
        (of[0][0], 4.12),
        (of[1][1], 3.67),
        (of[1][2], 1.47),
        (of[2][2], 1.19),
    ] {
        assert!((found / expected - 1.0).abs() < 6e-3, "{found} {expected}");
    }
    assert!((of[1][2] + of[2][1]).abs() < 1e-2 * of[1][2]);
    assert!(of[0][1].abs().max(of[1][0].abs()).max(of[0][2].abs()) < 1e-9);
}

#[test]
fn prescribed_moment_gives_spin_that_causes_it() {
    let scene = RollingSphere::across(20);
    for [xi, eta, spin] in [[0.0, 0.0, 0.5], [0.5, 0.3, -0.4], [0.2, 0.0, 3.0]] {
        let [x, y, moment] = scene.loads([xi, eta, spin]);
        let motions = scene.at([xi, eta, 0.0]).spin(SpinControl::Moment(moment));
        // With prescribed forces the creepages are part of the solution.
        let loads = motions.clone().control(Axis::X, RollingControl::Force(x));
        let loads = loads.control(Axis::Y, RollingControl::Force(y));
        for problem in [motions, loads] {
            let found = kit::solve(problem.tolerance(1e-10));
            assert!(found.report().is_converged() && found.report().load_error < 1e-10);
            let motion = [found.creepage()[0], found.creepage()[1], found.spin()];
            for (found, expected) in motion.into_iter().zip([xi, eta, spin]) {
                assert!(
                    (found / scene.unit - expected).abs() < 1e-6,
                    "{found} {expected}"
                );
            }
        }
    }
}

#[test]
fn moment_beyond_friction_is_rejected() {
    let scene = RollingSphere::across(16);
    // The integral of the distance weighted by a Hertzian pressure is 3 pi/16 times the load and the radius.
    let capacity = 3.0 * std::f64::consts::PI / 16.0 * scene.limit;
    let of = |moment: f64| scene.rolling().spin(SpinControl::Moment(moment)).build();
    kit::assert_refused! { of(1.02 * capacity) => Error::BeyondFrictionMoment { .. } }
    // A negative moment is reported with its sign, and with the end of the range that it exceeds.
    let Err(Error::BeyondFrictionMoment {
        moment,
        limit,
        range,
        ..
    }) = of(-1.02 * capacity)
    else {
        panic!("the negative moment is accepted")
    };
    assert!(moment == -1.02 * capacity && limit == range[0] && range[0] < 0.0);
    assert!(matches!(of(f64::NAN), Err(Error::NotFinite { .. })));
    let mut solver = of(0.97 * capacity).unwrap().into_solver().unwrap();
    let mut rolling = kit::solved(&mut solver);
    assert!((rolling.moment() / (0.97 * capacity) - 1.0).abs() < 1e-7);
    // Prescribed forces reduce the largest moment, so that the moment is rejected before any solve.
    let force = RollingControl::Force(0.6 * scene.limit);
    let far = SpinControl::Moment(0.97 * capacity);
    let Err(Error::BeyondFrictionMoment { moment, limit, .. }) = solver.set_load([force; 2], far)
    else {
        panic!("the moment is accepted although no spin has it");
    };
    // The factor 0.428 belongs to a contact of 17 cells across that slides about a different point.
    assert!(moment == 0.97 * capacity && (limit / (0.428 * capacity) - 1.0).abs() < 0.03);
    // Nearly all of the moment of a fully sliding contact is reached.
    let near = SpinControl::Moment(0.95 * limit);
    solver.set_load([force; 2], near).unwrap();
    solver.solve_into(&mut rolling).unwrap();
    assert!((rolling.moment() / (0.95 * limit) - 1.0).abs() < 1e-6);
    for sum in rolling.force() {
        assert!((sum / (0.6 * scene.limit) - 1.0).abs() < 1e-6);
    }
    let beyond = SpinControl::Moment(-1.01 * limit);
    kit::assert_refused! { solver.set_load([force; 2], beyond) => Error::BeyondFrictionMoment { .. } }
    solver.solve_into(&mut rolling).unwrap();
    let (force, moment) = (RollingControl::Force(0.1 * scene.limit), 0.1 * capacity);
    solver
        .set_load([force; 2], SpinControl::Moment(moment))
        .unwrap();
    solver.solve_into(&mut rolling).unwrap();
    assert!((rolling.moment() / moment - 1.0).abs() < 1e-6);
}

#[test]
fn creep_forces_match_single_solves() {
    let scene = RollingSphere::across(16);
    let points = [-1.0, -0.3, 0.2, 0.9].map(|xi| [0.4, 0.0].map(|eta| [xi, eta, 0.2]));
    let points: Vec<_> = points.into_iter().flatten().collect();
    let solver = scene.rolling().tolerance(1e-11).build().unwrap();
    let scaled = points
        .iter()
        .map(|point| point.map(|part| part * scene.unit));
    let found = solver.into_solver().unwrap().creep_forces(scaled).unwrap();
    assert_eq!(found.len(), points.len());
    for (found, point) in found.iter().zip(points) {
        let [x, y, moment] = scene.loads(point);
        let [fx, fy] = found.force;
        let errors = [fx - x, fy - y, found.moment - moment].map(|error| error.abs() / scene.limit);
        assert!(errors.iter().all(|error| *error < 1e-8), "{errors:?}");
        assert_eq!(found.spin, 0.2 * scene.unit);
    }
}

/// On 64 cells across, a cold solve to 1e-8 takes at most 150 products for any force. If the creepages then increase by
/// one per cent, the next solve takes at most 60 products. A stiffness takes at most 170 products.
#[test]
fn rolling_solves_take_few_products() {
    let scene = RollingSphere::across(64);
    let points = [
        [0.5, 0.5, 0.5],
        [1.0, 0.0, 0.0],
        [0.3, 0.0, 0.0],
        [2.0, 0.0, 0.0],
    ];
    for &[xi, eta, spin] in &points[..kit::thorough(2, 4)] {
        let problem = scene.at([xi, eta, spin]).tolerance(1e-8).build().unwrap();
        let mut solver = problem.into_solver().unwrap();
        let mut rolling = kit::solved(&mut solver);
        assert!(rolling.report().products() <= 150, "{}", rolling.report());
        let creepage = [xi, eta].map(|part| RollingControl::Creepage(1.01 * part * scene.unit));
        solver
            .set_load(creepage, SpinControl::Spin(spin * scene.unit))
            .unwrap();
        solver.solve_into(&mut rolling).unwrap();
        assert!(rolling.report().products() <= 60, "{}", rolling.report());
        let mut products = 0;
        let stiffness = solver.stiffness_observed(|step| {
            products = step.double_precision_products + step.single_precision_products;
            ControlFlow::Continue(())
        });
        stiffness.unwrap();
        assert!(products <= 170, "{products}");
    }
    for &part in kit::thorough(&[0.99][..], &[0.9, 0.99, 0.999]) {
        let force = RollingControl::Force(part * scene.limit);
        let problem = scene.rolling().control(Axis::X, force).build().unwrap();
        let rolling = problem.solve().unwrap();
        assert!(rolling.report().products() <= 150, "{}", rolling.report());
    }
}

/// The result equals the result of a solver built with the new friction, and loads beyond the new friction limit are
/// rejected.
#[test]
fn friction_can_change_between_solves() {
    let scene = RollingSphere::across(16);
    let of = |friction: &Friction, force: f64| {
        RollingProblem::builder(&scene.bodies, &scene.normal, friction.clone())
            .control(Axis::X, RollingControl::Force(force))
            .tolerance(1e-11)
            .build()
    };
    let half = Field::from_fn(scene.bodies.grid(), |x, _| if x > 0.2 { 0.0 } else { 0.3 });
    let (dry, half) = (kit::coulomb(0.3), Friction::per_cell(half).unwrap());
    let mut solver = of(&half, 0.1).unwrap().into_solver().unwrap();
    let mut rolling = solver.new_solution();
    for friction in [&dry, &half, &dry] {
        solver.set_friction(friction).unwrap();
        solver.solve_into(&mut rolling).unwrap();
        let fresh = of(friction, 0.1).unwrap().solve().unwrap();
        assert!((rolling.creepage()[0] / fresh.creepage()[0] - 1.0).abs() < 1e-8);
    }
    let stiffness = solver.stiffness().unwrap();
    kit::assert_refused! { solver.set_friction(&kit::coulomb(0.01)) => Error::BeyondFrictionCapacity { .. } }
    let small = Friction::per_cell(Field::constant(kit::square(3, 1.0), 0.3)).unwrap();
    kit::assert_refused! { solver.set_friction(&small) => Error::GridMismatch { .. } }
    // A rejected friction leaves the stiffness valid. A new friction does not.
    assert_eq!(solver.stiffness().unwrap(), stiffness);
    solver.set_friction(&half).unwrap();
    kit::assert_refused! { solver.stiffness() => Error::OutdatedSolution { changed: "the friction", .. } }
    solver.solve_into(&mut rolling).unwrap();
    assert!(solver.stiffness().is_ok());
}

/// Tractions whose squares overflow or underflow are solved consecutively by the same solver.
#[test]
fn friction_can_change_by_any_factor() {
    let scene = RollingSphere::across(16);
    let of = |coefficient: f64| kit::coulomb(coefficient);
    let creepages = |coefficient: f64| {
        [0.8, 0.2].map(|part| RollingControl::Creepage(part * coefficient / FRICTION * scene.unit))
    };
    let mut solver = kit::solver(RollingProblem::builder(
        &scene.bodies,
        &scene.normal,
        of(1.0),
    ));
    let mut rolling = solver.new_solution();
    solver
        .set_load(creepages(1.0), SpinControl::Spin(0.0))
        .unwrap();
    solver.solve_into(&mut rolling).unwrap();
    let (ordinary, zones) = (rolling.force(), rolling.zones().to_vec());
    assert!(0.1 < rolling.stick_ratio() && rolling.stick_ratio() < 0.9);
    for coefficient in [1e290, 1e-290, 1e160, 1.0, 1e-160, 1e290] {
        solver.set_friction(&of(coefficient)).unwrap();
        solver
            .set_load(creepages(coefficient), SpinControl::Spin(0.0))
            .unwrap();
        solver.solve_into(&mut rolling).unwrap();
        for (found, expected) in rolling.force().iter().zip(ordinary) {
            let ratio = found / coefficient / expected;
            assert!((ratio - 1.0).abs() < 1e-7, "{coefficient:e}: {ratio}");
        }
        assert!(*rolling.zones() == *zones, "{coefficient:e}");
    }
}

/// Far beyond sliding, a larger creepage does not increase the force along this creepage. A creepage across the force
/// only rotates the force.
#[test]
fn sliding_contact_resists_rotation_of_force_only() {
    let scene = RollingSphere::across(16);
    let creepage = 1e3 * scene.unit;
    let problem = scene.rolling().creepage([creepage, 0.0]).tolerance(1e-11);
    let mut solver = kit::solver(problem);
    let sticking = solver.stiffness().unwrap();
    let rolling = kit::solved(&mut solver);
    assert_eq!(rolling.stick_ratio(), 0.0);
    let sliding = solver.stiffness().unwrap();
    for row in 0..3 {
        // The slip of the cells deviates slightly from the creepage because of the tractions.
        assert!(sliding[row][0].abs() < 1e-5 * sticking[0][0], "{sliding:?}");
    }
    let turned = sliding[1][1] * creepage / scene.limit;
    assert!((turned - 1.0).abs() < 1e-2, "{turned}");
}

#[test]
fn cancelled_work_leaves_solver_usable() {
    let scene = RollingSphere::across(16);
    let moment = SpinControl::Moment(0.3 * scene.limit);
    let problem = scene.rolling().spin(moment).tolerance(1e-9);
    let expected = kit::solve(problem.clone());
    let mut solver = kit::solver(problem);
    let mut rolling = solver.new_solution();
    for allowed in [0, 5, 40] {
        let mut asked = 0;
        let cut = solver.solve_observed(&mut rolling, |_| {
            asked += 1;
            if asked > allowed {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        let Err(Error::NotConverged(report)) = cut else {
            panic!("not cancelled: {cut:?}");
        };
        assert_eq!(report.status, Status::Cancelled);
        // A cancelled solve has no stiffness.
        kit::assert_refused! { solver.stiffness() => Error::NotConverged(cut) if cut.status == Status::Cancelled }
    }
    solver.solve_into(&mut rolling).unwrap();
    assert!(solver.stiffness().unwrap()[0][0] > 0.0);
    kit::assert_refused! { solver.stiffness_observed(|_| ControlFlow::Break(())) => Error::NotConverged(_) }
    assert!((rolling.spin() / expected.spin() - 1.0).abs() < 1e-6);
    let mut steps = 0;
    let watched = solver.creep_forces_observed([[0.1, 0.0, 0.0], [0.2, 0.0, 0.0]], |_| {
        steps += 1;
        ControlFlow::Continue(())
    });
    assert!(watched.unwrap().len() == 2 && steps > 0);
    let cut = solver.creep_forces_observed([[0.3, 0.0, 0.0]], |_| ControlFlow::Break(()));
    assert!(matches!(cut, Err(Error::NotConverged(_))));
    solver
        .set_load([RollingControl::Creepage(0.0); 2], moment)
        .unwrap();
    solver.solve_into(&mut rolling).unwrap();
    assert!((rolling.spin() / expected.spin() - 1.0).abs() < 1e-6);
}

/// Returns the minimum of a convex function of one variable between bounds.
fn minimum(f: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    for _ in 0..120 {
        let third = (high - low) / 3.0;
        if f(low + third) < f(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    f(0.5 * (low + high))
}

/// A contact of one row can rotate without moving along the row, where the bound has kinks.
#[test]
fn row_has_least_bound_of_moment() {
    let (cells, length) = (24, 3.0);
    let grid = Grid::new(cells, 1, length / cells as f64, 0.1).unwrap();
    let bodies = HalfSpace::new(grid, kit::alike_in_shear(1.0, 0.25)).unwrap();
    let normal = NormalProblem::builder(&bodies, kit::sphere(grid, 1.0), NormalLoad::Force(0.05));
    let normal = kit::solve(normal);
    let (cell, total) = (length / cells as f64, FRICTION * normal.force());
    let limits: Vec<_> = normal.pressure().as_slice().to_vec();
    let limits = limits.iter().map(|p| FRICTION * p * grid.cell_area());
    let limits: Vec<_> = limits.collect();
    for (parts, sign) in [
        ([Some(0.6), Some(0.0)], 1.0),
        ([Some(0.3), Some(0.3)], 1.0),
        ([Some(0.3), Some(0.3)], -1.0),
        ([None, Some(0.5)], 1.0),
    ] {
        // Particles enter at plus x. In the middle of their step the particles are half a cell from the centres.
        let bound = |shift: [f64; 2]| {
            let turning = limits.iter().enumerate().map(|(i, limit)| {
                let x = (i as f64 + 1.0) * cell - 0.5 * length;
                limit * shift[0].hypot(sign * x + shift[1])
            });
            let [x, y] = parts.map(|part| part.unwrap_or(0.0) * total);
            turning.sum::<f64>() - shift[0] * x - (shift[1] + sign * 0.5 * cell) * y
        };
        let range = [-2.0 * length, 2.0 * length];
        let along_y = |x: f64| minimum(|y| bound([x, y]), range);
        let expected = if parts[0].is_some() {
            minimum(along_y, range)
        } else {
            along_y(0.0)
        };
        let controls = parts.map(|part| match part {
            Some(part) => RollingControl::Force(part * total),
            None => RollingControl::Creepage(0.0),
        });
        let rolling = RollingProblem::builder(&bodies, &normal, kit::coulomb(FRICTION))
            .control(Axis::X, controls[0])
            .control(Axis::Y, controls[1])
            .spin(SpinControl::Moment(sign * 1e3));
        let Err(Error::BeyondFrictionMoment { limit, .. }) = rolling.build() else {
            panic!("the moment far beyond all limits is accepted");
        };
        assert!(
            (limit / (sign * expected) - 1.0).abs() < 1e-6,
            "{parts:?} {sign}: {limit} {expected}"
        );
    }
}
