//! Tests of the vector model. Slip is opposite to the traction, and loads can have any direction. If the two components
//! do not couple, the result equals the result of the scalar model.

use kit::{Table2, max_abs, rough, unit_pair};
use stickslip::{
    Boundary, Error, Field, HalfSpace, NormalLoad, NormalSolution, TangentialLoad, TangentialModel,
    TangentialProblem, TangentialSolution,
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
    kit::solve(
        TangentialProblem::builder(bodies, normal, kit::coulomb(FRICTION), load)
            .model(lateral)
            .tolerance(tolerance),
    )
}

/// Creates the ball of the paper on `cells` x `cells` cells, a square of three contact radii, with the given Poisson's
/// ratio.
fn ball(cells: usize, poisson_ratio: f64) -> (HalfSpace, NormalSolution) {
    let grid = kit::square(cells, 3.0 * Table2::CONTACT_RADIUS);
    let pair = unit_pair(poisson_ratio);
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let gap = kit::sphere(grid, Table2::RADIUS);
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
    let grid = kit::square(cells, 64.0);
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
fn force_at_limit_slides_and_beyond_limit_is_rejected() {
    let (bodies, normal) = ball(48, 0.3);
    let limit: f64 = FRICTION * normal.force();
    let sliding = TangentialLoad::force([0.6 * limit, -0.8 * limit]);
    let plane = shear(&bodies, &normal, TangentialModel::Vector, sliding, 1e-8);
    assert!(plane.is_gross_slip());
    assert!((plane.force()[0] / (0.6 * limit) - 1.0).abs() < 1e-12);
    let shift = plane.shift();
    assert!((shift[0] / shift[1] + 0.75).abs() < 0.05, "{shift:?}");

    let friction = kit::coulomb(FRICTION);
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
