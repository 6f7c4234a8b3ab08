//! Moments of the pressure and traction, and elastic energies, agree with their closed forms.

use stickslip::analytical::HertzSphere;
use stickslip::{
    Boundary, Error, Field, Grid, HalfSpace, NormalLoad, NormalProblem, NormalSolution,
    TangentialLoad, TangentialModel, TangentialProblem, TangentialSolution,
};

const RADIUS: f64 = 20.0;

fn press(bodies: &HalfSpace, [x0, y0]: [f64; 2], force: f64) -> NormalSolution {
    let ball = |x: f64, y: f64| ((x - x0).powi(2) + (y - y0).powi(2)) / (2.0 * RADIUS);
    let gap = Field::from_fn(bodies.grid(), ball);
    let problem = NormalProblem::builder(bodies, &gap, NormalLoad::Force(force));
    kit::solve(problem.tolerance(1e-9))
}

fn shear(bodies: &HalfSpace, normal: &NormalSolution, load: TangentialLoad) -> TangentialSolution {
    kit::solve(
        TangentialProblem::builder(bodies, normal, kit::coulomb(0.4), load)
            .model(TangentialModel::Vector)
            .tolerance(1e-9),
    )
}

#[test]
fn moments_match_position_of_ball() {
    let bodies = kit::unit_bodies(Grid::new(64, 48, 0.25, 0.25).unwrap(), 0.3);
    let force = 3.0;
    // The ball is at the centre of a cell, so that the contact is symmetric about this point.
    let place = [1.625, -0.875];
    let contact = press(&bodies, place, force);
    let [x, y] = contact.centre_of_pressure().unwrap();
    assert!((x - place[0]).abs() < 1e-9 && (y - place[1]).abs() < 1e-9);
    // The reference is the moment of a force along +z on body 1.
    let [about_x, about_y] = contact.moments();
    assert!((about_x - place[1] * force).abs() < 1e-9);
    assert!((about_y + place[0] * force).abs() < 1e-9);
    let apart = press(&bodies, place, 0.0);
    assert_eq!(
        (apart.centre_of_pressure(), apart.moments()),
        (None, [0.0; 2])
    );

    // Without twist and without Poisson's effect the traction has no moment about the ball.
    let stuck = kit::unit_bodies(bodies.grid(), 0.0);
    let contact = press(&stuck, place, force);
    let [fx, fy] = [0.3, 0.2];
    let shear = shear(&stuck, &contact, TangentialLoad::force([fx, fy]));
    let expected = place[0] * fy - place[1] * fx;
    assert!((shear.moment() - expected).abs() < 1e-9);
}

#[test]
fn energies_match_hertz_and_mindlin() {
    let grid = kit::square(128, 12.0);
    let bodies = kit::unit_bodies(grid, 0.3);
    let contact = press(&bodies, [0.0; 2], 4.0);
    let hertz = HertzSphere::new(bodies.pair(), RADIUS, 4.0).unwrap();
    // The energy is the work of the force, which is proportional to the approach to the power 3/2.
    let exact = 0.4 * 4.0 * hertz.approach();
    let energy = contact.elastic_energy(&bodies).unwrap();
    assert!((energy / exact - 1.0).abs() < 2e-4);
    // Within the contact the displacement equals the approach minus the gap.
    let displacement = contact.displacement(&bodies).unwrap();
    for i in 0..grid.cells() {
        let radius = grid.x(i % 128).hypot(grid.y(i / 128));
        let overlap = contact.approach() - radius * radius / (2.0 * RADIUS);
        let gap = displacement.as_slice()[i] - overlap;
        assert!((gap - contact.gap().as_slice()[i]).abs() < 1e-12);
    }

    // In full stick the work is half of the force times the shift.
    let load = TangentialLoad::force([0.002, 0.001]);
    let shear = shear(&bodies, &contact, load);
    let [dx, dy] = shear.shift();
    let work = 0.5 * (0.002 * dx + 0.001 * dy);
    let energy = shear.elastic_energy(&bodies).unwrap();
    assert!((energy / work - 1.0).abs() < 1e-6);
    let [ux, _] = shear.displacement(&bodies).unwrap();
    let middle = 64 * 128 + 64;
    assert!((ux.as_slice()[middle] / dx - 1.0).abs() < 1e-6);
}

#[test]
fn different_bodies_are_rejected() {
    let grid = kit::square(16, 12.0);
    let bodies = kit::unit_bodies(grid, 0.3);
    let contact = press(&bodies, [0.0; 2], 4.0);
    let shear = shear(&bodies, &contact, TangentialLoad::force([1.0, 0.0]));
    let smaller = kit::unit_bodies(kit::square(15, 12.0), 0.3);
    let softer = kit::unit_bodies(grid, 0.2);
    let repeating = HalfSpace::with_boundary(grid, *bodies.pair(), Boundary::Periodic).unwrap();
    kit::assert_refused! {
        contact.displacement(&smaller) => Error::GridMismatch { .. },
        contact.elastic_energy(&softer) => Error::MaterialMismatch { .. },
        shear.displacement(&repeating) => Error::BoundaryMismatch { .. },
        shear.displacement(&softer) => Error::MaterialMismatch { quantity: "tangential contact" },
        shear.elastic_energy(&softer) => Error::MaterialMismatch { quantity: "tangential contact" },
        shear.stiffness(&softer) => Error::MaterialMismatch { quantity: "tangential contact" },
        shear.spots(&press(&smaller, [0.0; 2], 1.0)) => Error::GridMismatch { .. },
    }
}
