//! A nested start and a window around the contact save work without changing the solution. The solution equals the
//! solution of a single loop over the whole grid that starts without coarser grids.

use kit::{Random, l2_difference, press, rough, shear, unit_bodies};
use stickslip::cgm::Method;
use stickslip::{
    Axis, Field, Friction, Grid, HalfSpace, NormalLoad, NormalProblem, TangentialLoad,
    TangentialProblem, Zone,
};

const TOLERANCE: f64 = 1e-9;

/// Compares the solutions of both methods. The single loop starts without coarser grids and uses the whole grid.
fn assert_same(bodies: &HalfSpace, gap: &Field, load: NormalLoad, friction: &Friction, f: f64) {
    let normal = press(bodies, gap, load, TOLERANCE);
    let plain = kit::press_by(bodies, gap, load, TOLERANCE, Method::PolonskyKeer);
    let pressures = [&normal, &plain].map(|solution| solution.pressure().as_slice());
    let error = l2_difference(pressures[0], pressures[1]);
    assert!(
        error < 1e-6,
        "pressure: {error:e}\n{}\n{}",
        normal.report(),
        plain.report()
    );
    let depth = normal.approach() - gap.min();
    assert!(
        normal.gap().min() >= -2.0 * TOLERANCE * depth,
        "no cell overlaps"
    );
    let problem = TangentialProblem::builder(
        bodies,
        &normal,
        friction.clone(),
        TangentialLoad::shift([0.0; 2]),
    );
    let limit = problem.build().unwrap().friction_capacity();
    for load in [
        TangentialLoad::force([f * limit, 0.0]),
        TangentialLoad::force([0.0, -f * limit]),
    ] {
        let [sets, plain] = [Method::ActiveSet, Method::PolonskyKeer]
            .map(|method| kit::shear_by(bodies, &normal, friction, load, TOLERANCE, method));
        let axis = sets.axis().unwrap().index();
        let (a, b) = (sets.traction()[axis], plain.traction()[axis]);
        let error = l2_difference(a.as_slice(), b.as_slice());
        assert!(
            error < 1e-6,
            "traction: {error:e}\n{}\n{}",
            sets.report(),
            plain.report()
        );
        let by_shift = shear(
            bodies,
            &normal,
            friction,
            TangentialLoad::shift(sets.shift()),
            TOLERANCE,
        );
        assert!((by_shift.force()[axis] / sets.force()[axis] - 1.0).abs() < 1e-6);
    }
}

/// Returns the gap of a sphere in the middle and a tip of one cell in a corner. Coarser cells do not resolve the tip.
fn sphere_and_tip(grid: Grid) -> Field {
    let mut gap = Field::from_fn(grid, |x, y| (x * x + y * y) / (2.0 * 30.0));
    let tip = grid.nx() * (grid.ny() - 4) + 3;
    gap.as_mut_slice()[tip] = -0.2;
    gap
}

#[test]
fn tip_missed_by_coarse_cells_is_found() {
    let grid = Grid::new(90, 101, 0.25, 0.25).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let gap = sphere_and_tip(grid);
    for load in [
        NormalLoad::Force(2.0),
        NormalLoad::Approach(0.3),
        NormalLoad::Approach(-0.1),
    ] {
        assert_same(&bodies, &gap, load, &kit::coulomb(0.3), 0.5);
        let solution = press(&bodies, &gap, load, TOLERANCE);
        let tip = grid.nx() * (grid.ny() - 4) + 3;
        assert!(solution.pressure().as_slice()[tip] > 0.0);
    }
}

/// Far from the contact, a load may be smaller than the round-off of the gap. A solve that stalls there must continue
/// where the bodies overlap.
#[test]
fn tip_is_found_under_tiny_load() {
    let grid = Grid::new(90, 101, 0.25, 0.25).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let gap = sphere_and_tip(grid);
    let tip = grid.nx() * (grid.ny() - 4) + 3;
    for force in [1e-8, 1e-10, 1e-14] {
        let load = NormalLoad::Force(force);
        let solution = press(&bodies, &gap, load, TOLERANCE);
        assert_eq!(solution.contact_cells(), 1);
        assert!(
            (solution.pressure().as_slice()[tip] * grid.cell_area() / force - 1.0).abs() < 1e-12
        );
    }
}

#[test]
fn odd_slender_and_tilted_grids_match_plain_loop() {
    let mut random = Random(77);
    for (nx, ny, dx, dy) in [
        (97, 131, 1.0, 1.0),
        (257, 9, 0.5, 2.0),
        (1500, 1, 1.0, 1.0),
        (3, 700, 1.0, 0.2),
        (64, 64, 1.0, 3.0),
        (41, 40, 1.0, 1.0),
    ] {
        let grid = Grid::new(nx, ny, dx, dy).unwrap();
        let bodies = unit_bodies(grid, random.uniform(0.0, 0.5));
        let size = dx * nx as f64 + dy * ny as f64;
        let tilt = random.uniform(-0.01, 0.01);
        let gap = Field::from_fn(grid, |x, y| {
            0.1 * (x * x + y * y) / size + tilt * x + 1e-3 * dx * random.uniform(0.0, 1.0)
        });
        // Part of the surface is frictionless, so that the limits jump between neighbouring cells.
        let friction = Field::from_fn(grid, |x, _| if x > 0.2 * size { 0.0 } else { 0.5 });
        let friction = Friction::per_cell(friction).unwrap();
        for part in [1e-4, 3e-3] {
            let load = NormalLoad::Force(part * grid.area());
            assert_same(&bodies, &gap, load, &friction, 0.7);
        }
    }
}

#[test]
fn rough_gaps_and_load_beyond_window_match_plain_loop() {
    let grid = kit::square(96, 100.0);
    let bodies = unit_bodies(grid, 0.25);
    for seed in 0..kit::thorough(2, 4) {
        let gap = rough(grid, 100 + seed);
        assert_same(
            &bodies,
            &gap,
            NormalLoad::Force(10.0),
            &kit::coulomb(0.4),
            0.9,
        );
    }
    // The window of the first, light contact is much too small for the last contact.
    let gap = sphere_and_tip(grid);
    let problem =
        NormalProblem::builder(&bodies, &gap, NormalLoad::Force(1e-3)).tolerance(TOLERANCE);
    let mut solver = kit::solver(problem);
    let mut solution = solver.new_solution();
    for force in [1e-3, 1.0, 100.0, 1e4, 1e-3] {
        solver.set_load(NormalLoad::Force(force)).unwrap();
        solver.solve_into(&mut solution).unwrap();
        let plain = kit::press_by(
            &bodies,
            &gap,
            NormalLoad::Force(force),
            TOLERANCE,
            Method::PolonskyKeer,
        );
        let error = l2_difference(solution.pressure().as_slice(), plain.pressure().as_slice());
        assert!(error < 1e-6, "{force}: {error:e}");
    }
}

/// Between two loads along y the solver solves a zero load under a different pressure. The axis must not change.
#[test]
fn solver_under_zero_load_keeps_axis() {
    let grid = kit::square(64, 8.0);
    let bodies = unit_bodies(grid, 0.3);
    let ball = kit::sphere(grid, 10.0);
    let [light, heavy] = [0.05, 0.5].map(|force| {
        let load = NormalLoad::Force(force);
        press(&bodies, &ball, load, TOLERANCE)
    });
    let along_y = |force| TangentialLoad::force([0.0, force]);
    let problem = TangentialProblem::builder(&bodies, &light, kit::coulomb(0.5), along_y(0.01));
    let mut solver = kit::solver(problem);
    let mut shear = kit::solved(&mut solver);
    solver.set_load(along_y(0.0)).unwrap();
    solver.set_pressure(&heavy).unwrap();
    solver.solve_into(&mut shear).unwrap();
    assert_eq!(shear.axis(), Some(Axis::Y));
    assert!(shear.zones().iter().all(|zone| *zone != Zone::Slip));
}
