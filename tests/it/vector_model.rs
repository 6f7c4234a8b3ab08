//! Tests of the vector model. Slip is opposite to the traction, and loads can have any direction. If the two components
//! do not couple, the result equals the result of the scalar model.

use kit::{Table2, max_abs, rough, unit_bodies, unit_pair};
use proptest::prelude::*;
use stickslip::influence::Component;
use stickslip::{
    Boundary, Error, Field, Friction, Grid, HalfSpace, NormalLoad, NormalSolution, Operator,
    TangentialLoad, TangentialModel, TangentialProblem, TangentialSolution, surface,
};

const FRICTION: f64 = 0.5;

fn press(bodies: &HalfSpace, gap: &Field, force: f64) -> NormalSolution {
    kit::press(bodies, gap, NormalLoad::Force(force), 1e-10)
}

fn shear(
    bodies: &HalfSpace,
    normal: &NormalSolution,
    lateral: TangentialModel,
    load: TangentialLoad,
    tolerance: f64,
) -> TangentialSolution {
    let friction = Friction::coulomb(FRICTION).unwrap();
    kit::solve(
        TangentialProblem::builder(bodies, normal, friction, load)
            .model(lateral)
            .tolerance(tolerance),
    )
}

/// Creates the ball of the paper on `cells` x `cells` cells, a square of three contact radii, with the given Poisson's
/// ratio.
fn ball(cells: usize, poisson_ratio: f64) -> (HalfSpace, NormalSolution) {
    let grid = Grid::square(cells, 3.0 * Table2::CONTACT_RADIUS).unwrap();
    let pair = unit_pair(poisson_ratio);
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let gap = surface::sphere(grid, Table2::RADIUS).unwrap();
    let radius = Table2::CONTACT_RADIUS;
    let force = 4.0 * radius.powi(3) / (3.0 * Table2::RADIUS);
    let normal = press(&bodies, &gap, force);
    (bodies, normal)
}

fn rough_contact(
    cells: usize,
    poisson_ratio: f64,
    boundary: Boundary,
) -> (HalfSpace, NormalSolution) {
    let grid = Grid::square(cells, 64.0).unwrap();
    let bodies = HalfSpace::with_boundary(grid, unit_pair(poisson_ratio), boundary).unwrap();
    let normal = press(&bodies, &rough(grid, 5), 0.02 * grid.area());
    (bodies, normal)
}

fn force_along(normal: &NormalSolution, f: f64, [x, y]: [f64; 2]) -> TangentialLoad {
    let force = f * FRICTION * normal.force() / x.hypot(y);
    TangentialLoad::force([force * x, force * y])
}

#[test]
fn zero_poisson_ratio_gives_the_scalar_model() {
    for (bodies, normal) in [
        ball(96, 0.0),
        rough_contact(64, 0.0, Boundary::NonPeriodic),
        rough_contact(64, 0.0, Boundary::Periodic),
    ] {
        for f in [0.1, 0.5, 0.9, 0.999] {
            let load = force_along(&normal, f, [0.0, -1.0]);
            let [scalar, plane] = [TangentialModel::Scalar, TangentialModel::Vector]
                .map(|lateral| shear(&bodies, &normal, lateral, load, 1e-10));
            let scale = FRICTION * normal.pressure().max();
            let error = kit::max_difference(
                scalar.traction()[1].as_slice(),
                plane.traction()[1].as_slice(),
            );
            assert!(error < 1e-7 * scale, "{f} {:e}", error / scale);
            assert!(max_abs(plane.traction()[0].as_slice()) < 1e-10 * scale);
            assert_eq!(scalar.zones(), plane.zones());
            assert!((plane.shift()[1] / scalar.shift()[1] - 1.0).abs() < 1e-9);
        }
    }
}

/// Compares the scalar model with the vector model at one shift. For Poisson's ratios of 0.29 and 0.5, theory gives a
/// traction across the load of up to 3.7 % and 7.4 % of the largest friction limit. The angles are up to 7.4 and 15
/// degrees, and the errors of the force are at most 5e-4 and 1.9e-3.
#[test]
fn error_of_scalar_model_agrees_with_theory() {
    for (poisson_ratio, across, angle, force) in [
        (0.29, 0.012..0.0375, 7.4, 5e-4),
        (0.5, 0.025..0.075, 15.0, 1.9e-3),
    ] {
        let (bodies, normal) = ball(96, poisson_ratio);
        for f in [0.1, 0.4, 0.9] {
            let scalar = shear(
                &bodies,
                &normal,
                TangentialModel::Scalar,
                force_along(&normal, f, [1.0, 0.0]),
                1e-9,
            );
            let load = TangentialLoad::shift(scalar.shift());
            let plane = shear(&bodies, &normal, TangentialModel::Vector, load, 1e-9);
            let [x, y] = plane.traction().map(Field::as_slice);
            let found = max_abs(y) / (FRICTION * normal.pressure().max());
            assert!(across.contains(&found), "{poisson_ratio} {f} {found}");
            let turned = x.iter().zip(y).filter(|(x, _)| x.abs() > 0.0);
            let largest = turned
                .map(|(x, y)| (y / x).atan().abs().to_degrees())
                .fold(0.0, f64::max);
            assert!(largest < angle, "{poisson_ratio} {f} {largest}");
            let error = plane.force()[0] / scalar.force()[0] - 1.0;
            assert!(error.abs() < force, "{poisson_ratio} {f} {error:e}");
            let differ = scalar
                .zones()
                .iter()
                .zip(plane.zones())
                .filter(|(a, b)| a != b);
            assert!(differ.count() <= 20);
        }
    }
}

#[test]
fn displacement_control_inverts_force_control() {
    for (bodies, normal) in [
        ball(64, 0.3),
        rough_contact(64, 0.5, Boundary::NonPeriodic),
        rough_contact(64, 0.3, Boundary::Periodic),
    ] {
        for f in [0.2, 0.7, 0.95] {
            let load = force_along(&normal, f, [1.0, -2.0]);
            let forced = shear(&bodies, &normal, TangentialModel::Vector, load, 1e-11);
            let load = TangentialLoad::shift(forced.shift());
            let back = shear(&bodies, &normal, TangentialModel::Vector, load, 1e-11);
            for axis in 0..2 {
                assert!((back.force()[axis] / forced.force()[axis] - 1.0).abs() < 1e-8);
            }
            assert_eq!(back.zones(), forced.zones());
        }
    }
}

#[test]
fn force_at_limit_slides_and_beyond_limit_is_rejected() {
    let (bodies, normal) = ball(48, 0.3);
    let limit: f64 = FRICTION * normal.force();
    let sliding = TangentialLoad::force([0.6 * limit, -0.8 * limit]);
    let plane = shear(&bodies, &normal, TangentialModel::Vector, sliding, 1e-8);
    assert!(plane.is_gross_slip());
    assert!((plane.force()[0] / (0.6 * limit) - 1.0).abs() < 1e-12);
    let shift = plane.shift();
    assert!((shift[0] / shift[1] + 0.75).abs() < 0.05, "{shift:?}");

    let friction = Friction::coulomb(FRICTION).unwrap();
    let beyond = TangentialLoad::force([0.61 * limit, -0.8 * limit]);
    let refused = TangentialProblem::builder(&bodies, &normal, friction.clone(), beyond)
        .model(TangentialModel::Vector)
        .build();
    let Err(Error::BeyondFrictionCapacity { force, .. }) = refused else {
        panic!("{refused:?}")
    };
    assert!((force / limit - 0.61_f64.hypot(0.8)).abs() < 1e-9);
    let oblique = TangentialProblem::builder(&bodies, &normal, friction, sliding).build();
    assert!(matches!(oblique, Err(Error::ObliqueLoad { .. })));
}

#[test]
fn warm_started_load_path_matches_cold_solve() {
    let (bodies, normal) = rough_contact(64, 0.4, Boundary::NonPeriodic);
    let friction = Friction::coulomb(FRICTION).unwrap();
    let mut solver = kit::solver(
        TangentialProblem::builder(&bodies, &normal, friction, TangentialLoad::force([0.0; 2]))
            .model(TangentialModel::Vector)
            .tolerance(1e-10),
    );
    let mut warm = solver.new_solution();
    for (f, direction) in [(0.3, [1.0, 0.0]), (0.8, [1.0, 1.0]), (0.5, [-1.0, 2.0])] {
        let load = force_along(&normal, f, direction);
        solver.set_load(load).unwrap();
        solver.solve_into(&mut warm).unwrap();
        let cold = shear(&bodies, &normal, TangentialModel::Vector, load, 1e-10);
        let scale = FRICTION * normal.pressure().max();
        for (warm, cold) in warm.traction().into_iter().zip(cold.traction()) {
            assert!(kit::max_difference(warm.as_slice(), cold.as_slice()) < 1e-6 * scale);
        }
    }
}

/// Minimises by accelerated projected gradients with restarts on plain vectors. The method is slow and shares nothing
/// with the engine except the operators.
fn projected_gradient_solution(bodies: &HalfSpace, limits: &[f64], shift: [f64; 2]) -> Vec<f64> {
    let cells = limits.len();
    let operators =
        [Component::XX, Component::XY, Component::YY].map(|c| bodies.operator(c).unwrap());
    let product = |q: &[f64]| {
        let (x, y) = q.split_at(cells);
        let apply = |k: usize, v: &[f64]| {
            let mut u = vec![0.0; cells];
            operators[k].apply([v], [&mut u], &mut operators[k].scratch().unwrap());
            u
        };
        let sum =
            |a: Vec<f64>, b: Vec<f64>| a.into_iter().zip(b).map(|(a, b)| a + b).collect::<Vec<_>>();
        [sum(apply(0, x), apply(1, y)), sum(apply(1, x), apply(2, y))].concat()
    };
    let project = |mut q: Vec<f64>| {
        for i in 0..cells {
            let size = q[i].hypot(q[cells + i]);
            if size > limits[i] {
                q[i] *= limits[i] / size;
                q[cells + i] *= limits[i] / size;
            }
        }
        q
    };
    // The row sum of the largest compliance bounds the largest eigenvalue.
    let length = 1.0 / (1.5 * max_abs(&product(&vec![1.0; 2 * cells])));
    let (mut q, mut ahead, mut momentum) = (vec![0.0; 2 * cells], vec![0.0; 2 * cells], 1.0_f64);
    for _ in 0..20_000 {
        let u = product(&ahead);
        let step = ahead.iter().zip(&u).enumerate();
        let next = project(
            step.map(|(i, (q, u))| q - length * (u - shift[i / cells]))
                .collect(),
        );
        let change: Vec<f64> = next.iter().zip(&q).map(|(next, q)| next - q).collect();
        let uphill: f64 = ahead
            .iter()
            .zip(&next)
            .zip(&change)
            .map(|((a, n), c)| (a - n) * c)
            .sum();
        let following = 0.5 * (1.0 + (1.0 + 4.0 * momentum * momentum).sqrt());
        let pull = if uphill > 0.0 {
            0.0
        } else {
            (momentum - 1.0) / following
        };
        momentum = if uphill > 0.0 { 1.0 } else { following };
        ahead = next
            .iter()
            .zip(&change)
            .map(|(q, c)| q + pull * c)
            .collect();
        q = next;
        if max_abs(&change) < 1e-15 * max_abs(&q) {
            break;
        }
    }
    q
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(6, 12)))]

    #[test]
    fn solution_matches_projected_gradients(
        (n, nu, f, angle, seed) in (8..14_usize, 0.0..0.5_f64, 0.05..0.98_f64, 0.0..std::f64::consts::TAU, any::<u64>())
    ) {
        let grid = Grid::new(n, n + 1, 1.0, 0.8).unwrap();
        let bodies = unit_bodies(grid, nu);
        let normal = press(&bodies, &rough(grid, seed), 0.1 * grid.area());
        let load = force_along(&normal, f, [angle.cos(), angle.sin()]);
        let plane = shear(&bodies, &normal, TangentialModel::Vector, load, 1e-10);
        let limits: Vec<f64> = normal.pressure().as_slice().iter().map(|p| FRICTION * p).collect();
        let other = projected_gradient_solution(&bodies, &limits, plane.shift());
        let own = plane.traction().map(Field::as_slice).concat();
        let error = kit::max_difference(&own, &other) / max_abs(&limits);
        prop_assert!(error < 1e-6, "{error:e} {}", plane.report());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(kit::thorough(16, 48)))]

    /// Every scene converges, and its error relative to the solution for a far smaller tolerance is within the
    /// certificate.
    #[test]
    fn error_is_within_certificate(
        (n, m, nu, f, angle, is_periodic, pressure, tolerance, seed) in (
            8..40_usize, 8..40_usize, 0.0..0.5_f64, 0.01..0.999_f64, 0.0..std::f64::consts::TAU, any::<bool>(),
            -3.0..0.5_f64, -9.0..-1.0_f64, any::<u64>(),
        )
    ) {
        let grid = Grid::new(n, m, 1.0, 1.3).unwrap();
        let boundary = if is_periodic { Boundary::Periodic } else { Boundary::NonPeriodic };
        let bodies = HalfSpace::with_boundary(grid, unit_pair(nu), boundary).unwrap();
        let normal = press(&bodies, &rough(grid, seed), 10_f64.powf(pressure) * grid.area());
        let load = force_along(&normal, f, [angle.cos(), angle.sin()]);
        let exact = shear(&bodies, &normal, TangentialModel::Vector, load, 1e-11);
        let tolerance = 10_f64.powf(tolerance);
        let rough = shear(&bodies, &normal, TangentialModel::Vector, load, tolerance);
        let difference: Vec<Vec<f64>> = rough.traction().into_iter().zip(exact.traction())
            .map(|(a, b)| a.as_slice().iter().zip(b.as_slice()).map(|(a, b)| a - b).collect())
            .collect();
        let energy = |q: [&[f64]; 2]| {
            let parts = [(Component::XX, 0, 0, 1.0), (Component::YY, 1, 1, 1.0), (Component::XY, 0, 1, 2.0)];
            let part = |(component, a, b, copies): (Component, usize, usize, f64)| -> f64 {
                let operator = bodies.operator(component).unwrap();
                let mut u = vec![0.0; grid.cells()];
                operator.apply([q[b]], [&mut u], &mut operator.scratch().unwrap());
                copies * u.iter().zip(q[a]).map(|(u, q)| u * q).sum::<f64>()
            };
            parts.into_iter().map(part).sum::<f64>().max(0.0)
        };
        let size = rough.traction().map(Field::as_slice);
        let squares: f64 = size.iter().flat_map(|q| q.iter()).map(|q| q * q).sum();
        // Uniform tractions have no energy on a periodic grid. Their energy is replaced by the bound from the smallest
        // eigenvalue of the tensor. This eigenvalue equals the smallest eigenvalue of the normal compliance.
        let smallest = bodies.operator(Component::ZZ).unwrap().lower_bound();
        let whole = energy(size).max(if is_periodic { smallest * squares } else { 0.0 });
        let error = (energy([&difference[0], &difference[1]]) / whole).sqrt();
        let bound = rough.report().energy_error_bound();
        let noise = exact.report().energy_error_bound();
        prop_assert!(bound <= tolerance);
        prop_assert!(error <= bound + 2.0 * noise + 1e-12, "{error:e} {bound:e}");
    }
}
