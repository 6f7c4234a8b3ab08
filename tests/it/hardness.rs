//! The pressure never exceeds the hardness. It minimises the energy among all pressures that satisfy this condition. The
//! references are other codes and a dense matrix. Contacts are also unloaded and loaded again.

use kit::{Random, max_difference, rough, unit_bodies};
use stickslip::cgm::Bounds;
use stickslip::dense::DenseOperator;
use stickslip::influence::Component;
use stickslip::normal::Hardness;
use stickslip::{
    Axis, CoupledProblem, Error, Field, Grid, HalfSpace, History, LoadStep, NormalLoad,
    NormalProblem, NormalSolution, Operator, Scratch, TangentialControl, TangentialLoad,
    TangentialModel, analytical, history::EntryRule, surface,
};

/// Returns steel on a rigid body. The contact modulus is in MPa.
fn steel(grid: Grid) -> HalfSpace {
    HalfSpace::new(grid, kit::on_rigid(115_384.615_384_615_39, 0.0)).unwrap()
}

fn solved(bodies: &HalfSpace, gap: &Field, force: f64, hardness: &Hardness) -> NormalSolution {
    kit::solve(
        NormalProblem::builder(bodies, gap, NormalLoad::Force(force))
            .hardness(hardness.clone())
            .tolerance(1e-12),
    )
}

/// Returns the numbers of contact cells below the hardness and at the hardness.
fn counts(contact: &NormalSolution, hardness: f64) -> [usize; 2] {
    let pressure = contact.pressure().as_slice().iter();
    let at = pressure.filter(|p| **p == hardness).count();
    [contact.contact_cells() - at, at]
}

/// The reference solution for this load comes from an active-set Newton method and from Tamaas 2.9.
#[test]
fn ball_at_hardness_matches_reference() {
    let grid = kit::square(64, 0.5);
    let (bodies, limit) = (steel(grid), 959.615_355_1);
    let ball = Field::from_fn(grid, |x, y| (x * x + y * y) / 20.0);
    let hardness = Hardness::uniform(limit).unwrap();
    let contact = solved(&bodies, &ball, 100.0, &hardness);
    assert!((contact.approach() / 0.003_589_337_413_622_2 - 1.0).abs() < 1e-10);
    assert_eq!(counts(&contact, limit), [548, 1396]);
    let overlap = hardness.overlap(&contact).unwrap();
    assert!((overlap.max() / 0.000_563_145_390_583_1 - 1.0).abs() < 1e-9);
    assert!((overlap.integral() / 2.080_208_148_299e-5 - 1.0).abs() < 1e-9);
    let energy = contact.elastic_energy(&bodies).unwrap();
    assert!((energy / 0.127_615_238_127_7 - 1.0).abs() < 1e-9);
}

/// The header of the file states the case and its source.
const ROUGH_CAP: &str = include_str!("../data/hardness/rough_cap.csv");

#[test]
fn rough_cap_at_hardness_matches_reference() {
    let lines = ROUGH_CAP.lines().filter(|line| !line.starts_with('#'));
    let column = |k: usize| {
        let entries = lines.clone().map(|line| line.split(',').nth(k));
        let numbers = entries.map(|entry| entry.map_or(0.0, |entry| entry.parse().unwrap()));
        numbers.collect::<Vec<f64>>()
    };
    let grid = kit::square(64, 0.64);
    let gap = Field::from_vec(grid, column(0)).unwrap();
    let hardness = Hardness::uniform(1800.0).unwrap();
    let contact = solved(&steel(grid), &gap, 60.0, &hardness);
    assert!((contact.approach() / 0.001_999_189_658_979_7 - 1.0).abs() < 1e-10);
    assert_eq!(counts(&contact, 1800.0), [511, 110]);
    let pressure = contact.pressure().as_slice();
    assert!(max_difference(pressure, &column(1)) < 1e-9 * 1800.0);
    let overlap = hardness.overlap(&contact).unwrap();
    assert!(max_difference(overlap.as_slice(), &column(2)) < 1e-10 * contact.approach());
}

/// Returns a small random problem with arbitrary cells, gap and limits. Some of the limits are zero.
fn random_problem(seed: u64) -> (HalfSpace, Field, Field, Random) {
    let mut random = Random(seed);
    let (nx, ny) = (random.integer(2, 11), random.integer(2, 11));
    let dx = 10_f64.powf(random.uniform(-3.0, 3.0));
    let grid = Grid::new(nx, ny, dx, dx * random.uniform(0.4, 2.5)).unwrap();
    let bodies = unit_bodies(grid, random.uniform(0.0, 0.5));
    let size = dx * nx.max(ny) as f64;
    let (bowl, noise) = (
        random.uniform(0.0, 0.3),
        10_f64.powf(random.uniform(-4.0, -1.0)),
    );
    let gap = Field::from_fn(grid, |x, y| {
        bowl * (x * x + y * y) / size + noise * size * random.uniform(0.0, 1.0)
    });
    let softest = 10_f64.powf(random.uniform(-3.0, 0.0));
    let limits = Field::from_fn(grid, |_, _| {
        let is_hole = random.uniform(0.0, 1.0) < 0.05;
        if is_hole {
            0.0
        } else {
            softest * random.uniform(1.0, 3.0)
        }
    });
    (bodies, gap, limits, random)
}

#[test]
fn certificate_bounds_error_on_random_problems() {
    let mut at_limit = 0;
    for seed in 0..200 {
        let (bodies, gap, limits, mut random) = random_problem(seed);
        let hardness = Hardness::per_cell(limits.clone()).unwrap();
        let force = random.uniform(0.02, 0.98) * hardness.capacity(bodies.grid());
        let settings = 10_f64.powf(random.uniform(-11.0, -2.0));
        let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(force));
        let problem = problem.hardness(hardness).tolerance(settings);
        let found = kit::solve(problem);

        let matrix = DenseOperator::of_half_space(&bodies, Component::ZZ).unwrap();
        let zeros = vec![0.0; limits.as_slice().len()];
        let bounds = Bounds {
            lower: &zeros,
            upper: limits.as_slice(),
        };
        let total = Some(force / bodies.grid().cell_area());
        let exact = matrix.minimise(gap.as_slice(), &bounds, total).unwrap();
        let norm = |x: &[f64]| {
            let mut product = vec![0.0; x.len()];
            matrix.apply([x], [&mut product], &mut Scratch::none());
            let energy: f64 = x.iter().zip(&product).map(|(x, u)| x * u).sum();
            energy.sqrt()
        };
        let pressure = found.pressure().as_slice();
        let difference: Vec<f64> = pressure.iter().zip(&exact.x).map(|(a, b)| a - b).collect();
        let error = norm(&difference) / norm(&exact.x);
        // The round-off of the dense matrix is not part of the bound.
        let bound = found.report().energy_error_bound() + 1e-12;
        assert!(
            error <= bound,
            "{seed}: error {error:e} exceeds bound {bound:e}"
        );
        for (p, limit) in pressure.iter().zip(limits.as_slice()) {
            assert!((0.0..=*limit).contains(p));
            at_limit += usize::from(*p == *limit && *limit > 0.0);
        }
    }
    assert!(at_limit > 1000, "{at_limit}");
}

/// The permanent set remains, so the worn surfaces fit under the same load without yielding.
#[test]
fn yielded_contact_is_elastic_when_loaded_again() {
    let grid = kit::square(48, 1.0);
    for boundary in kit::boundaries(grid) {
        let bodies = HalfSpace::with_boundary(grid, kit::unit_pair(0.3), boundary).unwrap();
        let gap = rough(grid, 5);
        let hardness = Hardness::uniform(0.02).unwrap();
        let first = solved(&bodies, &gap, 0.004, &hardness);
        let yielded = hardness.overlap(&first).unwrap();
        assert!(yielded.max() > 1e-4 * first.approach().abs());
        let worn = Field::from_vec(
            grid,
            gap.as_slice()
                .iter()
                .zip(yielded.as_slice())
                .map(|(a, b)| a + b)
                .collect(),
        )
        .unwrap();
        let again = solved(&bodies, &worn, 0.004, &hardness);
        assert!((again.approach() / first.approach() - 1.0).abs() < 1e-10);
        let (a, b) = (first.pressure().as_slice(), again.pressure().as_slice());
        assert!(max_difference(a, b) < 1e-9 * 0.02);
        let yielded_again = hardness.overlap(&again).unwrap().max();
        assert!(yielded_again < 1e-9 * yielded.max(), "{yielded_again:e}");
        // Under a smaller load the contact is elastic as well.
        let less = solved(&bodies, &worn, 0.002, &hardness);
        let free = NormalProblem::builder(&bodies, &worn, NormalLoad::Force(0.002));
        let free = kit::solve(free.tolerance(1e-12));
        let (a, b) = (less.pressure().as_slice(), free.pressure().as_slice());
        assert!(max_difference(a, b) < 1e-9 * 0.02);
    }
}

/// The overlap of a contact that was solved with another hardness would be zero or belong to other cells.
#[test]
fn overlap_of_other_hardness_is_rejected() {
    let grid = kit::square(24, 4.0);
    let bodies = unit_bodies(grid, 0.3);
    let ball = kit::sphere(grid, 10.0);
    let hertz = analytical::HertzSphere::new(bodies.pair(), 10.0, 0.1).unwrap();
    let limit = |part: f64| part * hertz.max_pressure();
    let uniform = |part: f64| Hardness::uniform(limit(part)).unwrap();
    let contact = solved(&bodies, &ball, 0.1, &uniform(0.7));
    assert!(uniform(0.7).overlap(&contact).unwrap().max() > 0.0);
    // Equal limits per cell are accepted.
    let of_cells = Hardness::per_cell(Field::constant(grid, limit(0.7))).unwrap();
    assert!(of_cells.overlap(&contact).unwrap().max() > 0.0);
    for part in [0.6, 0.69, 0.71, 2.0] {
        kit::assert_refused! { uniform(part).overlap(&contact) => Error::OutdatedSolution { quantity: "overlap", .. } }
    }
    let elastic = kit::solve(NormalProblem::builder(
        &bodies,
        &ball,
        NormalLoad::Force(0.1),
    ));
    kit::assert_refused! { uniform(0.7).overlap(&elastic) => Error::OutdatedSolution { .. } }
    assert_eq!(uniform(1.2).overlap(&elastic).unwrap().max(), 0.0);
}

#[test]
fn unreached_hardness_changes_nothing() {
    let grid = kit::square(40, 4.0);
    let bodies = unit_bodies(grid, 0.3);
    let ball = kit::sphere(grid, 10.0);
    let hertz = analytical::HertzSphere::new(bodies.pair(), 10.0, 0.1).unwrap();
    let limit = 1.1 * hertz.max_pressure();
    let unlimited = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.1));
    let unlimited = kit::solve(unlimited.tolerance(1e-12));
    let uniform = Hardness::uniform(limit).unwrap();
    let of_cells = Hardness::per_cell(Field::constant(grid, limit)).unwrap();
    for hardness in [uniform, of_cells] {
        let limited = solved(&bodies, &ball, 0.1, &hardness);
        let pressures = [&limited, &unlimited].map(|contact| contact.pressure().as_slice());
        assert!(max_difference(pressures[0], pressures[1]) < 1e-11 * limit);
        assert!((limited.approach() / unlimited.approach() - 1.0).abs() < 1e-12);
        assert_eq!(limited.yielded_cells(), 0);
        assert_eq!(hardness.overlap(&limited).unwrap().max(), 0.0);
    }
}

/// A limit that the solution does not reach changes no iterate, although intermediate pressures of a punch are far
/// above the limit.
#[test]
fn unreached_hardness_leaves_punch_bitwise_identical() {
    let mut random = Random(33);
    for case in 0..120 {
        let (cells, radius, recess) = if case == 0 {
            (6, 1.8, 1.0)
        } else {
            let cells = random.integer(4, 16);
            let radius = random.uniform(0.2, 0.5) * cells as f64;
            (cells, radius, random.decade(-2.0, 1.0))
        };
        let grid = kit::square(cells, cells as f64);
        let bodies = unit_bodies(grid, 0.3);
        let gap = surface::flat_punch(grid, radius, recess).unwrap();
        let load = match case {
            0 => 1e-3,
            _ => random.decade(-5.0, -1.0),
        };
        let problem = || NormalProblem::builder(&bodies, &gap, NormalLoad::Force(load));
        let free = kit::solve(problem());
        let limit = free.pressure().max() * random.uniform(1.001, 3.0);
        let limited = problem().hardness(Hardness::uniform(limit).unwrap());
        let limited = kit::solve(limited);
        assert_eq!(limited.pressure(), free.pressure(), "case {case}");
        assert_eq!(limited.approach(), free.approach());
        assert_eq!(limited.report().iterations, free.report().iterations);
        // A limit that the solution reaches is not exceeded.
        let reached = Hardness::uniform(free.mean_pressure() * random.uniform(1.001, 1.2)).unwrap();
        let limited = problem().hardness(reached.clone()).build().unwrap();
        let limited = limited.solve().unwrap();
        assert!(limited.pressure().max() <= reached.of_cell(0));
        assert!((limited.force() / load - 1.0).abs() < 1e-12);
    }
}

/// A prescribed approach may bring all cells to their limit. A force is limited by the capacity of all cells.
#[test]
fn loads_beyond_capacity_are_rejected() {
    let grid = kit::square(16, 1.0);
    let bodies = unit_bodies(grid, 0.3);
    let flat = Field::zeros(grid);
    let hardness = Hardness::uniform(0.1).unwrap();
    let problem = |load| NormalProblem::builder(&bodies, &flat, load).hardness(hardness.clone());
    let capacity = hardness.capacity(grid);
    let beyond = problem(NormalLoad::Force(1.01 * capacity)).build();
    assert!(matches!(beyond, Err(Error::BeyondHardness { force, .. }) if force > capacity));
    for load in [NormalLoad::Force(capacity), NormalLoad::Approach(10.0)] {
        let contact = kit::solve(problem(load));
        assert!(contact.pressure().as_slice().iter().all(|p| *p == 0.1));
    }
    let press = problem(NormalLoad::Force(0.5 * capacity));
    let mut press = kit::solver(press);
    kit::assert_refused! { press.set_load(NormalLoad::Force(2.0 * capacity)) => _ }
    let contact = kit::solved(&mut press);
    assert!((contact.force() / capacity - 0.5).abs() < 1e-12);

    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        kit::assert_refused! { Hardness::uniform(bad) => Error::NotPositive { .. } }
    }
    let negative = Field::constant(grid, -1.0);
    kit::assert_refused! { Hardness::per_cell(negative) => Error::Sample { .. } }
    let other = Field::constant(kit::square(8, 1.0), 1.0);
    let other = Hardness::per_cell(other).unwrap();
    let problem = NormalProblem::builder(&bodies, &flat, NormalLoad::Force(0.01));
    kit::assert_refused! {
        problem.hardness(other.clone()).build() => Error::GridMismatch { .. },
        other.overlap(&contact) => Error::GridMismatch { .. },
    }
}

/// Each load is carried by a whole number of cells at their limit. No cell has a pressure between zero and its limit.
/// Any approach within a range is then a multiplier.
#[test]
fn all_cells_may_be_at_their_bounds() {
    let grid = kit::square(16, 4.0);
    let bodies = unit_bodies(grid, 0.1);
    let ball = kit::sphere(grid, 10.0);
    let mut without_elastic_cells = 0;
    for cells in (4..=200).step_by(4) {
        for limit in [0.005, 0.01, 0.02] {
            let force = f64::from(cells) * limit * grid.cell_area();
            let hardness = Hardness::uniform(limit).unwrap();
            let contact = solved(&bodies, &ball, force, &hardness);
            assert!((contact.force() / force - 1.0).abs() < 1e-12);
            let [elastic, _] = counts(&contact, limit);
            without_elastic_cells += usize::from(elastic == 0);
            // Bodies overlap only where the pressure is at the hardness.
            let (pressure, gap) = (contact.pressure().as_slice(), contact.gap().as_slice());
            let mut beyond = pressure.iter().zip(gap).filter(|(p, _)| **p < limit);
            assert!(beyond.all(|(_, gap)| *gap > -1e-11 * contact.approach()));
        }
    }
    assert!(without_elastic_cells > 10, "{without_elastic_cells}");
}

/// A coupled problem equals the first step of a history with the same hardness. The pressure is limited by the hardness,
/// and the tractions by friction under this pressure.
#[test]
fn coupled_problem_with_hardness_matches_first_history_step() {
    let grid = kit::square(36, 3.0);
    let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, 0.1)).unwrap();
    let ball = kit::sphere(grid, 10.0);
    let (friction, press) = (kit::coulomb(0.4), NormalLoad::Force(0.2));
    let sloping = Field::from_fn(grid, |x, _| 0.06 + 0.01 * x);
    for hardness in [Hardness::uniform(0.06), Hardness::per_cell(sloping)] {
        let hardness = hardness.unwrap();
        let load = TangentialLoad::force([0.03, 0.0]);
        let problem = CoupledProblem::builder(&bodies, &ball, friction.clone(), press, load);
        let problem = problem.hardness(hardness.clone()).tolerance(1e-11).build();
        let mut solver = problem.unwrap().into_solver().unwrap();
        let mut contact = kit::solved(&mut solver);

        let history = History::builder(&bodies, &ball, friction.clone());
        let history = history
            .model(TangentialModel::Vector)
            .entry_rule(EntryRule::WholeStep);
        let mut history = history
            .hardness(hardness.clone())
            .tolerance(1e-11)
            .build()
            .unwrap();
        let drag = |axis, force| LoadStep::hold().tangential(axis, TangentialControl::Force(force));
        let step = drag(Axis::X, 0.03).tangential(Axis::Y, TangentialControl::Force(0.0));
        history.step(&step.normal(press)).unwrap();

        let (normal, tangential) = (contact.normal(), contact.tangential());
        assert!(normal.yielded_cells() > 20 && normal.yielded_cells() < normal.contact_cells());
        assert_eq!(normal.yielded_cells(), history.normal().yielded_cells());
        let pressure = normal.pressure().as_slice();
        assert!(max_difference(pressure, history.pressure().as_slice()) < 1e-9);
        for (found, step) in tangential.traction().iter().zip(history.traction()) {
            assert!(max_difference(found.as_slice(), step.as_slice()) < 1e-9);
        }
        let [x, y] = tangential.traction().map(Field::as_slice);
        for (cell, p) in pressure.iter().enumerate() {
            assert!(*p <= hardness.of_cell(cell));
            assert!(x[cell].hypot(y[cell]) <= 0.4 * p * (1.0 + 1e-12));
        }

        // If the solve continues under a smaller load, no cell is at the limit, and the contact equals the contact of elastic
        // bodies.
        let lighter = (NormalLoad::Force(0.02), TangentialLoad::force([0.003, 0.0]));
        solver.set_loads(lighter.0, lighter.1).unwrap();
        solver.solve_into(&mut contact).unwrap();
        let elastic =
            CoupledProblem::builder(&bodies, &ball, friction.clone(), lighter.0, lighter.1);
        let elastic = kit::solve(elastic.tolerance(1e-11));
        assert_eq!(contact.normal().yielded_cells(), 0);
        let [found, known] = [&contact, &elastic].map(|of| of.normal().pressure().as_slice());
        assert!(max_difference(found, known) < 1e-9);

        // A force beyond the capacity of all cells is rejected and leaves the loads unchanged.
        let beyond = NormalLoad::Force(1.01 * hardness.capacity(grid));
        kit::assert_refused! { solver.set_loads(beyond, lighter.1) => Error::BeyondHardness { .. } }
        solver.solve_into(&mut contact).unwrap();
        assert!((contact.normal().force() / 0.02 - 1.0).abs() < 1e-10);
    }
    let elsewhere = Field::constant(kit::square(35, 3.0), 1.0);
    let problem = CoupledProblem::builder(
        &bodies,
        &ball,
        friction,
        press,
        TangentialLoad::shift([0.0, 0.0]),
    );
    let hardness = Hardness::per_cell(elsewhere).unwrap();
    kit::assert_refused! { problem.hardness(hardness).build() => Error::GridMismatch { .. } }
}
