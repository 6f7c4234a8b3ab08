//! The solve of a coupled contact converges, or ends with an error that states the cause.

use std::f64::consts::TAU;

use stickslip::{
    Axis, Boundary, CoupledProblem, ElasticPair, Error, Field, Friction, Grid, HalfSpace, History,
    LoadStep, NormalLoad, TangentialControl, TangentialLoad,
};

const FRICTION: f64 = 0.3;

fn against_rigid(modulus: f64, poisson_ratio: f64) -> ElasticPair {
    kit::on_rigid(modulus, poisson_ratio)
}

fn ball_problem(cells: usize, poisson_ratio: f64) -> (HalfSpace, Field) {
    let grid = kit::square(cells, 2.6);
    let bodies = HalfSpace::new(grid, against_rigid(1.0, poisson_ratio)).unwrap();
    (bodies, kit::sphere(grid, 10.0))
}

/// Flat bodies on a periodic grid touch everywhere under a uniform pressure. This pressure causes no displacement to
/// which a residual could be relative. With waves of negligible height the displacement remains negligible.
#[test]
fn flat_periodic_bodies_touch_everywhere() {
    for size in [[4, 3], [24, 27], [5, 7], [3, 1], [8, 8]] {
        let grid = Grid::new(size[0], size[1], 1.0, 1.0).unwrap();
        let loads = [
            TangentialLoad::shift([0.0; 2]),
            TangentialLoad::force([0.1, 0.05]),
            TangentialLoad::force([0.0; 2]),
        ];
        for (poisson_ratio, height) in [(0.0, 0.0), (0.3, 0.0), (0.0, 1e-8), (0.3, 1e-8)] {
            let pair = against_rigid(1.0, poisson_ratio);
            let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
            let side = grid.dx() * size[0] as f64;
            let gap = Field::from_fn(grid, |x, _| height * (TAU * x / side).cos());
            for load in loads {
                let press = NormalLoad::Force(grid.area());
                let problem =
                    CoupledProblem::builder(&bodies, &gap, kit::coulomb(FRICTION), press, load);
                let contact = kit::solve(problem);
                let pressure = contact.normal().pressure();
                let part = 4.0 * TAU * height / side;
                assert!((pressure.max() - 1.0).abs() <= part + 1e-7);
                assert!((pressure.min() - 1.0).abs() <= part + 1e-7);
                let asked = match load.control(Axis::X) {
                    TangentialControl::Force(force) => force / grid.area(),
                    _ => 0.0,
                };
                let [x, _] = contact.tangential().traction();
                assert!((x.max() - asked).abs() <= part + 1e-7);
                assert!((x.min() - asked).abs() <= part + 1e-7);
            }
        }
    }
}

/// A single cell that has slipped in one direction then carries a force in a different direction.
#[test]
fn single_cell_sheared_in_a_new_direction_converges() {
    for (cells, poisson_ratio) in [(1, -0.17), (1, 0.0), (5, -0.17), (5, 0.0)] {
        let grid = kit::square(cells, cells as f64);
        let bodies = HalfSpace::new(grid, against_rigid(1.0 / 3.06, poisson_ratio)).unwrap();
        let gap = Field::from_fn(grid, |x, y| if x.hypot(y) < 0.5 { 0.0 } else { 1e3 });
        let mut history = History::builder(&bodies, &gap, kit::coulomb(0.111))
            .build()
            .unwrap();
        let press = LoadStep::hold().normal(NormalLoad::Force(1.0));
        history.step(&press).unwrap();
        history.step(&LoadStep::shift([1.88, 2.48])).unwrap();
        assert!(history.last_step().unwrap().is_gross_slip());
        let asked = [0.016, 0.034];
        history.step(&LoadStep::force(asked)).unwrap();
        for (traction, asked) in history.traction().into_iter().zip(asked) {
            assert!((traction.integral() - asked).abs() < 1e-8);
        }
    }
}

/// The shift grows with the inverse root of the distance to the sliding force.
#[test]
fn forces_close_to_sliding_converge() {
    for (cells, poisson_ratio) in [(17, 0.0), (17, 0.3), (24, 0.2)] {
        let (bodies, gap) = ball_problem(cells, poisson_ratio);
        let press = NormalLoad::Force(0.1);
        let mut shifts = Vec::new();
        for missing in [1e-5, 1e-6, 1e-7, 1e-8] {
            let force = (1.0 - missing) * FRICTION * 0.1;
            let load = TangentialLoad::force([0.8 * force, 0.6 * force]);
            let problem =
                CoupledProblem::builder(&bodies, &gap, kit::coulomb(FRICTION), press, load);
            // The error of the force must be at most a tenth of its distance to the sliding force.
            let problem = problem.tolerance(1e-9).build().unwrap();
            let contact = problem.solve().unwrap();
            assert!(contact.tangential().is_gross_slip());
            let [x, y] = contact.tangential().shift();
            shifts.push(x.hypot(y));
        }
        for pair in shifts.windows(2) {
            let growth = pair[1] / pair[0];
            assert!(
                (growth / 10_f64.sqrt() - 1.0).abs() < 0.05,
                "{cells} cells: {shifts:?}"
            );
        }
    }
}

/// Under a prescribed approach, or with friction that varies between cells, the friction capacity depends on the
/// unknown pressure. A force that is too large is still rejected, and the error contains the sliding force.
#[test]
fn forces_beyond_sliding_are_rejected() {
    let (bodies, gap) = ball_problem(12, 0.0);
    let halves = Field::from_fn(bodies.grid(), |x, _| if x < 0.0 { 0.1 } else { FRICTION });
    let rough = Friction::per_cell(halves).unwrap();
    let capped = kit::coulomb(FRICTION).max_shear_stress(0.01).unwrap();
    let (approach, force) = (NormalLoad::Approach(0.09), NormalLoad::Force(0.1));
    for (friction, press) in [
        (kit::coulomb(FRICTION), approach),
        (rough.clone(), approach),
        (rough, force),
        (capped.clone(), approach),
        (capped, force),
    ] {
        let solve = |load| {
            let problem = CoupledProblem::builder(&bodies, &gap, friction.clone(), press, load);
            problem.build().unwrap().solve()
        };
        let slid = solve(TangentialLoad::shift([1e4, 0.0])).unwrap();
        let sliding = slid.tangential().traction()[0].integral();
        for part in [1.02, 1.1, 1.25] {
            let along_both = TangentialLoad::force([part * sliding, 0.0]);
            let across_held = along_both.along(Axis::Y, TangentialControl::Shift(0.0));
            for load in [along_both, across_held] {
                let Err(Error::BeyondFrictionCapacity { force, limit, .. }) = solve(load) else {
                    panic!("{part} of {sliding} under {press:?}");
                };
                assert!(force == part * sliding && (limit / sliding - 1.0).abs() < 1e-4);
            }
        }
        let held = solve(TangentialLoad::force([0.98 * sliding, 0.0])).unwrap();
        assert!((held.tangential().traction()[0].integral() / sliding - 0.98).abs() < 1e-8);
    }
}
