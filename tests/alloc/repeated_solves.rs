//! After the first solves, changing the load, the gap, the friction or the pressure and solving again allocates
//! nothing.

use kit::{rough, unit_bodies};
use stickslip::rolling::{RollingControl, RollingProblem, SpinControl};
use stickslip::{
    Boundary, CoupledProblem, ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep,
    Material, NormalLoad, NormalProblem, TangentialLoad, TangentialModel, TangentialProblem,
    surface,
};

/// Counts the allocations of the current thread. The solve must run on this thread.
fn allocations(mut work: impl FnMut() + Send) -> u64 {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    pool.install(|| allocation_counter::measure(&mut work))
        .count_total
}

fn assert_no_allocations(gap: &Field, load: f64, lateral: TangentialModel) {
    let bodies = unit_bodies(gap.grid(), 0.3);
    let press = NormalProblem::builder(&bodies, gap, NormalLoad::Force(load)).tolerance(1e-6);
    let mut press = kit::solver(press);
    let mut normal = press.new_solution();
    press.solve_into(&mut normal).unwrap();

    let mut worn = gap.clone();
    for (i, h) in worn.as_mut_slice().iter_mut().enumerate() {
        *h += 1e-4 * load.sqrt() * (i % 7) as f64;
    }
    let friction =
        [0.4, 0.5].map(|mu| Friction::per_cell(Field::constant(gap.grid(), mu)).unwrap());
    let shear = TangentialProblem::builder(
        &bodies,
        &normal,
        friction[0].clone(),
        TangentialLoad::force([0.1 * load, 0.0]),
    );
    let mut shear = kit::solver(shear.model(lateral).tolerance(1e-6));
    let mut sheared = shear.new_solution();
    shear.solve_into(&mut sheared).unwrap();

    let mut cycle = || {
        for (part, gap, friction) in [
            (0.9, gap, &friction[0]),
            (0.95, &worn, &friction[1]),
            (1.0, gap, &friction[0]),
        ] {
            press.set_load(NormalLoad::Force(part * load)).unwrap();
            press.set_gap(gap).unwrap();
            press.solve_into(&mut normal).unwrap();
            shear.set_pressure(&normal).unwrap();
            shear.set_friction(friction).unwrap();
            shear
                .set_load(TangentialLoad::force([0.2 * part * load, 0.0]))
                .unwrap();
            shear.solve_into(&mut sheared).unwrap();
            shear.set_load(TangentialLoad::shift([0.0, 0.0])).unwrap();
            shear.solve_into(&mut sheared).unwrap();
        }
    };
    // The longest history and the largest window are reached after one cycle.
    cycle();
    assert_eq!(allocations(&mut cycle), 0);
}

/// A contact that outgrows its window receives a larger window, into which it then fits.
#[test]
fn solve_after_contact_growth_allocates_nothing() {
    let grid = Grid::square(64, 100.0).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let ball = surface::sphere(grid, 300.0).unwrap();
    let [light, heavy] = [5.0, 20.0].map(|force| {
        let press = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(force));
        kit::solve(press)
    });
    let (friction, load) = (
        Friction::coulomb(0.4).unwrap(),
        TangentialLoad::force([1.0, 0.0]),
    );
    let shear = TangentialProblem::builder(&bodies, &light, friction, load);
    let mut shear = kit::solver(shear);
    shear.set_pressure(&heavy).unwrap();
    assert_eq!(allocations(|| shear.set_pressure(&light).unwrap()), 0);
}

#[test]
fn repeated_solves_of_sphere_and_rough_surface_allocate_nothing() {
    let grid = Grid::square(96, 100.0).unwrap();
    for lateral in [TangentialModel::Scalar, TangentialModel::Vector] {
        assert_no_allocations(&surface::sphere(grid, 300.0).unwrap(), 20.0, lateral);
        assert_no_allocations(&rough(grid, 4), 30.0, lateral);
    }
}

/// Coupled solves with changing loads, gap and friction.
#[test]
fn repeated_coupled_solves_allocate_nothing() {
    let grid = Grid::new(40, 36, 0.1, 0.1).unwrap();
    let pair = ElasticPair::new(Material::new(1.0, 0.1).unwrap(), Material::rigid()).unwrap();
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let gap = surface::sphere(grid, 10.0).unwrap();
    let frictions = [0.4, 0.5].map(|coefficient| Friction::coulomb(coefficient).unwrap());
    let (press, still) = (NormalLoad::Force(0.1), TangentialLoad::shift([0.0; 2]));
    let problem = CoupledProblem::builder(&bodies, &gap, frictions[0].clone(), press, still);
    let mut solver = kit::solver(problem);
    let mut contact = solver.new_solution();
    let mut cycle = || {
        for (force, friction) in [0.1, 0.09].into_iter().zip(&frictions) {
            let drag = TangentialLoad::force([0.1 * force, 0.0]);
            solver.set_loads(NormalLoad::Force(force), drag).unwrap();
            solver.set_friction(friction).unwrap();
            solver.set_gap(&gap).unwrap();
            solver.solve_into(&mut contact).unwrap();
        }
    };
    for _ in 0..3 {
        cycle();
    }
    assert_eq!(allocations(&mut cycle), 0);
}

/// Every cell slips along one direction, and no cell may be released along the other. Cells are therefore repeatedly
/// forced to stick. In the third step, cells are forced to stick so often that forcing all of them simultaneously no
/// longer helps.
#[test]
fn solves_that_force_cells_to_stick_allocate_nothing() {
    let grid = Grid::new(2, 4, 1.0, 1.0).unwrap();
    let pair = ElasticPair::new(Material::new(1.0, -0.5).unwrap(), Material::rigid()).unwrap();
    let bodies = HalfSpace::with_boundary(grid, pair, Boundary::Periodic).unwrap();
    let of = |samples: [f64; 8]| Field::from_vec(grid, samples.to_vec()).unwrap();
    let gap = of([0.02, 0.04, 0.34, 0.1, 0.0, 0.54, 0.22, 0.01]);
    let friction = of([0.05, 0.09, 0.12, 0.08, 0.05, 0.09, 0.04, 0.02]);
    let friction = Friction::per_cell(friction).unwrap();
    let mut history = History::builder(&bodies, &gap, friction).build().unwrap();
    let press = |force| LoadStep::force([0.0; 2]).normal(NormalLoad::Force(force));
    for force in [0.06, 0.02] {
        history.step(&press(force)).unwrap();
    }
    let before = history.state().clone();
    let mut again = || {
        history.set_state(&before).unwrap();
        history.step(&press(0.05)).unwrap();
    };
    // Several solutions alternate as the candidate of a step. After these runs each of them has its buffers.
    for _ in 0..4 {
        again();
    }
    assert_eq!(allocations(&mut again), 0);
}

#[test]
fn repeated_rolling_solves_allocate_nothing() {
    let grid = Grid::square(24, 3.0).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let ball = surface::sphere(grid, 1.0).unwrap();
    let press = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(1.0));
    let normal = kit::solve(press);
    let problem = RollingProblem::builder(&bodies, &normal, Friction::coulomb(0.3).unwrap());
    let mut solver = kit::solver(problem);
    let mut rolling = solver.new_solution();
    let mut cycle = || {
        for part in [0.2, 0.9, 0.5] {
            let creepage = RollingControl::Creepage(0.2 * part);
            for force in [creepage, RollingControl::Force(0.2 * part)] {
                solver
                    .set_load([creepage, force], SpinControl::Spin(0.1 * part))
                    .unwrap();
                solver.solve_into(&mut rolling).unwrap();
                solver.stiffness().unwrap();
            }
            let moment = SpinControl::Moment(0.01 * part);
            solver.set_load([creepage; 2], moment).unwrap();
            solver.solve_into(&mut rolling).unwrap();
        }
    };
    cycle();
    assert_eq!(allocations(&mut cycle), 0);
}

/// Load, creepages, spin and friction change as in the time loop of a vehicle, in the window of the largest load.
#[test]
fn rolling_solves_under_changing_loads_allocate_nothing() {
    let grid = Grid::square(24, 3.0).unwrap();
    let frictions = [0.3, 0.25].map(|coefficient| Friction::coulomb(coefficient).unwrap());
    let ball = surface::sphere(grid, 1.0).unwrap();
    let (soft, hard) = (
        Material::new(1.0, 0.3).unwrap(),
        Material::new(9.0, 0.3).unwrap(),
    );
    for other in [soft, hard] {
        let bodies = HalfSpace::new(grid, ElasticPair::new(soft, other).unwrap()).unwrap();
        let press = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.3));
        let press = press.build().unwrap();
        let normal = press.solve().unwrap();
        let problem = RollingProblem::builder(&bodies, &normal, frictions[0].clone());
        let mut solver = kit::solver(problem);
        solver
            .set_normal_solver(press.into_solver().unwrap())
            .unwrap();
        let mut rolling = solver.new_solution();
        let mut cycle = || {
            for (load, part) in [(0.3, 0.2), (0.5, 0.9), (0.4, 0.5), (0.3, -0.4)] {
                solver.set_normal_load(NormalLoad::Force(load)).unwrap();
                let creepages = [0.2 * part, -0.1 * part].map(RollingControl::Creepage);
                for friction in &frictions {
                    solver.set_friction(friction).unwrap();
                    solver
                        .set_load(creepages, SpinControl::Spin(0.1 * part))
                        .unwrap();
                    solver.solve_into(&mut rolling).unwrap();
                }
            }
        };
        // The largest window and the longest bases exist after a few cycles.
        for _ in 0..3 {
            cycle();
        }
        assert_eq!(allocations(&mut cycle), 0);
    }
}
