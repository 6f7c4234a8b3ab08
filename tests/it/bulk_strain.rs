//! Tests of a displacement of one body relative to the other that the contact does not cause, such as bulk strain. Bulk
//! strain shifts the stick zone and, if it is large, reverses slip. The work of the bulk stress is part of the energy
//! balance.

use kit::{boundaries, max_difference, unit_bodies, unit_pair};
use stickslip::analytical::{CattaneoMindlinLine, HertzLine};
use stickslip::history::Cycle;
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Boundary, CoupledProblem, ElasticPair, Error, Field, Grid, HalfSpace, History, LoadStep,
    Material, NormalLoad, NormalProblem, NormalSolution, TangentialLoad, TangentialModel,
    TangentialProblem, TangentialSolution, Warning, Zone, surface,
};
#[cfg(feature = "dense")]
use stickslip::{cgm::AbsBound, dense::DenseOperator, influence::Component};

const FRICTION: f64 = 0.5;
const LOAD: f64 = 100.0;
const RADIUS: f64 = 10.0;

fn steel() -> Material {
    Material::new(210e3, 0.3).unwrap()
}

fn hertz() -> HertzLine {
    HertzLine::new(&ElasticPair::new(steel(), steel()).unwrap(), RADIUS, LOAD).unwrap()
}

/// Presses a steel roller on a line of `n` cells.
fn press_roller(n: usize) -> (HalfSpace, NormalSolution) {
    let grid = Grid::line(n, 2.4 * hertz().half_width() / n as f64).unwrap();
    let boundary = Boundary::PeriodicAlongY { datum: 50.0 };
    let bodies = HalfSpace::with_boundary(grid, *hertz().pair(), boundary).unwrap();
    let gap = surface::cylinder(grid, RADIUS).unwrap();
    let press = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(LOAD));
    let normal = kit::solve(press.tolerance(1e-11));
    (bodies, normal)
}

/// Shears and stretches the same roller.
fn shear_roller(n: usize, force: f64, bulk_stress: f64) -> TangentialSolution {
    let (bodies, normal) = press_roller(n);
    let load = TangentialLoad::force([force, 0.0]);
    let strain = [[steel().plane_strain_under(bulk_stress), 0.0], [0.0; 2]];
    let bulk = RelativeDisplacement::bulk_strain(bodies.grid(), strain).unwrap();
    let shear = TangentialProblem::builder(&bodies, &normal, kit::coulomb(FRICTION), load);
    let shear = shear.relative_displacement(bulk).tolerance(1e-11);
    kit::solve(shear)
}

/// Returns the centre and half-width of the stick zone.
fn stick_zone(shear: &TangentialSolution) -> [f64; 2] {
    let grid = shear.grid();
    let sticks = |i: &usize| shear.zones()[*i] == Zone::Stick;
    let first = (0..grid.nx()).find(sticks).unwrap();
    let last = (0..grid.nx()).rfind(sticks).unwrap();
    [
        0.5 * (grid.x(first) + grid.x(last)),
        0.5 * (grid.x(last) - grid.x(first) + grid.dx()),
    ]
}

/// The stick zone is shifted as in the solution of Nowell and Hills. The traction agrees with their closed form within
/// the discretisation error.
/// A pattern without an amount has no effect. A step with a tangential load and no amount has a warning.
#[test]
fn relative_displacement_without_amount_gives_warning() {
    let bodies = unit_bodies(kit::square(24, 3.0), 0.3);
    let grid = bodies.grid();
    let strain = RelativeDisplacement::bulk_strain(grid, [[1e-3, 0.0], [0.0, 0.0]]).unwrap();
    let (gap, friction) = (kit::sphere(grid, 1.0), kit::coulomb(0.3));
    let press = LoadStep::hold().normal(NormalLoad::Force(1.0));
    let shear = LoadStep::force([0.1, 0.0]);
    let start = |pattern: Option<&RelativeDisplacement>| {
        let mut builder = History::builder(&bodies, &gap, friction.clone());
        if let Some(pattern) = pattern {
            builder = builder.relative_displacement(pattern.clone());
        }
        builder.build().unwrap()
    };
    let is_unused = |history: &mut History, load: LoadStep| {
        let warnings = history.step(&load).unwrap().warnings();
        warnings.contains(&Warning::UnusedRelativeDisplacement)
    };
    let (mut history, mut plain) = (start(Some(&strain)), start(None));
    assert!(!is_unused(&mut history, press) && !is_unused(&mut plain, press));
    let mut cycle = Cycle::new(&history);
    assert!(is_unused(&mut history, shear) && !is_unused(&mut plain, shear));
    cycle.add(&history).unwrap();
    assert!(
        cycle
            .warnings()
            .contains(&Warning::UnusedRelativeDisplacement)
    );
    assert_eq!(history.traction(), plain.traction());
    assert!(!is_unused(&mut history, shear.relative_displacement(0.0)));
    assert!(!is_unused(&mut history, shear.relative_displacement(1.0)));
    assert!(!is_unused(&mut history, LoadStep::force([0.05, 0.0])));
}

#[test]
fn moderate_strain_shifts_the_stick_zone() {
    let limit = FRICTION * LOAD;
    for (force, bulk_stress) in [(0.6, 150.0), (-0.6, 150.0), (0.6, -150.0), (0.8, 300.0)] {
        let exact = CattaneoMindlinLine::new(hertz(), FRICTION, force * limit).unwrap();
        let exact = exact
            .with_strain(steel().plane_strain_under(bulk_stress))
            .unwrap();
        assert!(exact.stick_centre().abs() > 0.1 * hertz().half_width());
        for n in [128, 256, 512, 1024] {
            let found = shear_roller(n, force * limit, bulk_stress);
            let (grid, traction) = (found.grid(), found.traction()[0]);
            let [centre, half_width] = stick_zone(&found);
            assert!((centre - exact.stick_centre()).abs() < grid.dx());
            assert!((half_width - exact.stick_half_width()).abs() < grid.dx());
            let cells = traction.as_slice().iter().enumerate();
            let error: f64 = cells
                .map(|(i, q)| (q - exact.traction(grid.x(i))).abs())
                .sum();
            let error = error * grid.dx() / (force.abs() * limit);
            let law = 4e-3 * (128.0 / n as f64).powf(1.5);
            assert!(error < law, "{force} {bulk_stress} {n}: {error:e}");
        }
    }
    // Larger strains reverse slip at one end.
    let exact = CattaneoMindlinLine::new(hertz(), FRICTION, 0.6 * limit).unwrap();
    kit::assert_refused! { exact.with_strain(steel().plane_strain_under(600.0)) => Error::BelowMinimum { .. } }
    let found = shear_roller(1024, 0.6 * limit, 600.0);
    let slips = |i: usize| found.zones()[i] == Zone::Slip;
    let slipping = (0..1024).filter(|&i| slips(i));
    let signs: Vec<f64> = slipping
        .map(|i| found.slip()[0].as_slice()[i].signum())
        .collect();
    assert!(signs.contains(&1.0) && signs.contains(&-1.0));
    assert!(signs.windows(2).filter(|pair| pair[0] != pair[1]).count() == 1);
}

/// Above a certain bulk stress the slip at one end is reversed, which is the limit of the solution of Nowell and Hills.
/// Below and above this stress the traction is the exact minimum computed with active sets. The zones are the active
/// sets.
#[cfg(feature = "dense")]
#[test]
fn any_strain_gives_the_exact_minimum() {
    let limit = FRICTION * LOAD;
    for (force, bulk_stress) in [
        (0.6, 600.0),
        (-0.6, 600.0),
        (0.9, -900.0),
        (0.3, 5000.0),
        (0.6, 150.0),
    ] {
        let (bodies, normal) = press_roller(96);
        let grid = bodies.grid();
        let limits = normal.pressure().scaled(FRICTION);
        let strain = steel().plane_strain_under(bulk_stress);
        let along_x = Field::from_fn(grid, |x, _| strain * x);
        let twin = DenseOperator::of_half_space(&bodies, Component::XX).unwrap();
        let sum = force * limit / grid.cell_area();
        let bounds = AbsBound(limits.as_slice());
        let exact = twin.minimise(along_x.as_slice(), &bounds, Some(sum));
        let exact = exact.unwrap().x;
        let found = shear_roller(96, force * limit, bulk_stress);
        let error = max_difference(found.traction()[0].as_slice(), &exact) / limits.max();
        assert!(error < 1e-9, "{force} {bulk_stress}: {error:e}");
        let mut signs = Vec::new();
        for ((q, limit), zone) in exact.iter().zip(limits.as_slice()).zip(found.zones()) {
            assert_eq!(*zone == Zone::Slip, *limit > 0.0 && q.abs() == *limit);
            if *zone == Zone::Slip {
                signs.push(q.signum());
            }
        }
        signs.dedup();
        let is_reversed = bulk_stress.abs() > 500.0;
        assert_eq!(signs.len(), if is_reversed { 2 } else { 1 });
    }
}

/// Computes `K(m) - E(m)` by the arithmetic-geometric mean.
fn difference_of_elliptic_integrals(m: f64) -> f64 {
    let (mut a, mut b, mut sum, mut power) = (1.0, (1.0 - m).sqrt(), 0.5 * m, 0.5);
    for _ in 0..30 {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        power *= 2.0;
        sum += power * c * c;
    }
    std::f64::consts::FRAC_PI_2 / a * sum
}

/// Under bulk stress alone both ends slip inwards, and the traction is bounded at both ends of the stick zone. The
/// singular integral equation has such a solution if $`\sigma = \frac8\pi \mu p_0 [K(m) - E(m)]`$ with
/// $`m = 1 - c^2/a^2`$.
#[test]
fn strain_alone_causes_inward_slip_at_both_ends() {
    let (a, limit) = (hertz().half_width(), FRICTION * hertz().max_pressure());
    for part in [0.3, 0.6, 0.9] {
        let integrals = difference_of_elliptic_integrals(1.0 - part * part);
        let bulk_stress = 8.0 / std::f64::consts::PI * limit * integrals;
        for n in [256, 1024] {
            let found = shear_roller(n, 0.0, bulk_stress);
            let grid = found.grid();
            let [centre, half_width] = stick_zone(&found);
            assert!(centre.abs() < 1e-12 * a);
            assert!(
                (half_width - part * a).abs() < 1.01 * grid.dx(),
                "{part} {n}: {}",
                half_width / a
            );
            let traction = found.traction()[0].as_slice();
            let odd = (0..n).map(|i| (traction[i] + traction[n - 1 - i]).abs());
            assert!(odd.fold(0.0, f64::max) < 1e-8 * limit);
            assert!(traction[n - n / 10] <= 0.0 && found.slip()[0].max() > 0.0);
        }
    }
}

/// A uniform displacement is equivalent to a shift of opposite sign, for similar and for dissimilar bodies.
#[test]
fn uniform_displacement_is_equivalent_to_a_shift() {
    let grid = Grid::new(26, 22, 0.1, 0.12).unwrap();
    let gap = surface::ellipsoid(grid, 9.0, 7.0).unwrap();
    let uniform = [0.004, -0.002].map(|w| Field::constant(grid, w));
    let uniform = RelativeDisplacement::new(uniform).unwrap();
    for boundary in boundaries(grid) {
        let bodies = HalfSpace::with_boundary(grid, unit_pair(0.3), boundary).unwrap();
        let press = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(0.08));
        let normal = kit::solve(press.tolerance(1e-12));
        let shear = |shift: [f64; 2], relative: Option<&RelativeDisplacement>| {
            let load = TangentialLoad::shift(shift);
            let problem =
                TangentialProblem::builder(&bodies, &normal, kit::coulomb(FRICTION), load);
            let problem = problem.model(TangentialModel::Vector).tolerance(1e-11);
            let problem = match relative {
                Some(relative) => problem.relative_displacement(relative.clone()),
                None => problem,
            };
            kit::solve(problem)
        };
        let moved = shear([0.001, 0.001], Some(&uniform));
        let shifted = shear([-0.003, 0.003], None);
        for axis in 0..2 {
            let [a, b] = [&moved, &shifted].map(|found| found.traction()[axis].as_slice());
            assert!(max_difference(a, b) < 1e-9 * normal.pressure().max());
            let [a, b] = [&moved, &shifted].map(|found| found.slip()[axis].as_slice());
            assert!(max_difference(a, b) < 1e-9);
        }

        let bodies = HalfSpace::with_boundary(grid, kit::on_rigid(1.0, 0.1), boundary).unwrap();
        let coupled = |shift: [f64; 2], relative: Option<&RelativeDisplacement>| {
            let load = TangentialLoad::shift(shift);
            let press = NormalLoad::Force(0.08);
            let problem =
                CoupledProblem::builder(&bodies, &gap, kit::coulomb(FRICTION), press, load);
            let problem = problem.tolerance(1e-10);
            let problem = match relative {
                Some(relative) => problem.relative_displacement(relative.clone()),
                None => problem,
            };
            kit::solve(problem)
        };
        let moved = coupled([0.001, 0.001], Some(&uniform));
        let shifted = coupled([-0.003, 0.003], None);
        let [a, b] = [&moved, &shifted].map(|found| found.tangential().traction()[0].as_slice());
        assert!(max_difference(a, b) < 1e-7 * normal.pressure().max());
    }
}

/// A constant strain remains until a different field replaces the previous displacement, also after a restart.
#[test]
fn replaced_relative_displacement_survives_restart() {
    let grid = Grid::new(26, 22, 0.1, 0.12).unwrap();
    let gap = surface::ellipsoid(grid, 9.0, 7.0).unwrap();
    let bulk = RelativeDisplacement::bulk_strain(grid, [[1.0, 0.2], [0.2, -0.3]]).unwrap();
    let other = RelativeDisplacement::bulk_strain(grid, [[0.3, 0.0], [0.0, 1.0]]).unwrap();
    for pair in [unit_pair(0.3), kit::on_rigid(1.0, 0.1)] {
        let bodies = HalfSpace::new(grid, pair).unwrap();
        let builder = History::builder(&bodies, &gap, kit::coulomb(FRICTION)).tolerance(1e-8);
        let builder = builder.model(TangentialModel::Vector);
        let mut history = builder.relative_displacement(bulk.clone()).build().unwrap();
        let press = LoadStep::force([0.0, 0.0]).normal(NormalLoad::Force(0.08));
        history.step(&press.relative_displacement(0.02)).unwrap();
        let reached = |history: &History| {
            let reached = history.state().relative_displacement();
            reached.map(|displacement| displacement[0].clone())
        };
        let before = reached(&history);
        history.step(&LoadStep::force([0.01, 0.0])).unwrap();
        assert_eq!(reached(&history), before);
        history.set_relative_displacement(&other).unwrap();
        let mut restored = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
        for history in [&mut history, &mut restored] {
            let load = LoadStep::force([0.01, 0.0]).relative_displacement(0.015);
            let energy = *history.step(&load).unwrap().energy();
            let size = energy.elastic_before + energy.elastic_after + energy.work.abs();
            assert!(energy.imbalance().abs() <= 1e-12 * size, "{energy:?}");
        }
        assert_eq!(history.to_bytes(), restored.to_bytes());
        let [_, along_y] = history.state().relative_displacement().unwrap();
        assert_eq!(along_y.get(3, 21), Some(0.015 * grid.y(21)));
    }
}

/// The bulk stress is in phase with the force. The area of the loop of force and shift is the work of the force. The
/// bulk stress does the rest of the dissipated work, one sixth in this test. Both shares agree with Nowell and Hills.
#[test]
fn loop_of_force_and_shift_encloses_work_of_force() {
    let (part, bulk_stress) = (0.6, 150.0);
    let force = part * FRICTION * LOAD;
    let exact = CattaneoMindlinLine::new(hertz(), FRICTION, force).unwrap();
    let exact = exact.with_bulk_stress([bulk_stress, 0.0]).unwrap();
    let (bodies, _) = press_roller(512);
    let gap = surface::cylinder(bodies.grid(), RADIUS).unwrap();
    let strain = [[steel().plane_strain_under(1.0), 0.0], [0.0; 2]];
    let bulk = RelativeDisplacement::bulk_strain(bodies.grid(), strain).unwrap();
    let builder = History::builder(&bodies, &gap, kit::coulomb(FRICTION)).tolerance(1e-10);
    let mut history = builder.relative_displacement(bulk).build().unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(LOAD));
    history.step(&press).unwrap();
    let load = |force: [f64; 2]| {
        let amount = bulk_stress * force[0] / (part * FRICTION * LOAD);
        LoadStep::force(force).relative_displacement(amount)
    };
    // The load consists of the first quarter and then a cycle between the extremes, in steps of equal force.
    let first = *history.step(&load([force, 0.0])).unwrap().energy();
    let quarter = first.dissipated_energy / exact.energy_of_first_quarter();
    assert!((quarter - 1.0).abs() < 1e-4, "{quarter}");
    let mut cycle = Cycle::new(&history);
    let steps = 40;
    for step in 1..=steps {
        let along = 4.0 * f64::from(step) / f64::from(steps);
        let level = if along <= 2.0 {
            1.0 - along
        } else {
            along - 3.0
        };
        history.step(&load([level * force, 0.0])).unwrap();
        cycle.add(&history).unwrap();
    }
    let energy = cycle.energy();
    let dissipated = energy.dissipated_energy / exact.energy_per_cycle();
    assert!((dissipated - 1.0).abs() < 1e-3, "{dissipated}");
    // The area of the loop includes one third of the energy added by the strain, because the stick zone is off centre.
    let unit =
        (FRICTION * LOAD).powi(2) / (std::f64::consts::PI * hertz().pair().contact_modulus());
    let moved = exact.stick_centre() / hertz().half_width();
    let without = exact.with_strain(0.0).unwrap().energy_per_cycle();
    let of_loop = without + 8.0 / 3.0 * unit * part * moved * moved;
    let found = cycle.work_of_loads();
    assert!(
        (found / of_loop - 1.0).abs() < 1e-2,
        "{} {}",
        found / unit,
        of_loop / unit
    );
    assert!(found < 0.9 * energy.work);
    assert!((energy.work / energy.dissipated_energy_midpoint - 1.0).abs() < 1e-4);
}

#[test]
fn relative_displacement_on_wrong_grid_or_axis_is_rejected() {
    let grid = kit::square(8, 4.0);
    let bodies = unit_bodies(grid, 0.3);
    let gap = kit::sphere(grid, 10.0);
    let across = RelativeDisplacement::bulk_strain(grid, [[0.0, 0.0], [0.0, 0.25]]).unwrap();
    let builder = || History::builder(&bodies, &gap, kit::coulomb(FRICTION));
    kit::assert_refused! {
        builder().relative_displacement(across.clone()).build() => Error::UnsupportedByModel { value: -0.4375, .. },
    }
    let other = kit::square(9, 4.0);
    let elsewhere = RelativeDisplacement::bulk_strain(other, [[0.0; 2]; 2]).unwrap();
    let mut history = builder().build().unwrap();
    for (wrong, is_grid) in [(across, false), (elsewhere, true)] {
        let refused = history.set_relative_displacement(&wrong);
        assert_eq!(matches!(refused, Err(Error::GridMismatch { .. })), is_grid);
        assert!(refused.is_err());
    }
    let bytes = history.to_bytes();
    let press = LoadStep::hold().normal(NormalLoad::Force(0.1));
    kit::assert_refused! {
        history.step(&press.relative_displacement(2.0)) => Error::UnsupportedByModel { value: 2.0, .. },
        history.step(&press.relative_displacement(f64::NAN)) => Error::NotFinite { .. },
    }
    assert_eq!(history.to_bytes(), bytes);
    let stretch = RelativeDisplacement::bulk_strain(grid, [[2.0, 0.0], [0.0; 2]]).unwrap();
    history.set_relative_displacement(&stretch).unwrap();
    let bytes = history.to_bytes();
    kit::assert_refused! { history.step(&LoadStep::hold().relative_displacement(f64::MAX)) => Error::NotFinite { .. } }
    assert_eq!(history.to_bytes(), bytes);
    let refused = RelativeDisplacement::bulk_strain(grid, [[f64::INFINITY, 0.0], [0.0; 2]]);
    assert!(matches!(refused, Err(Error::Sample { .. })));
    let fields = [Field::zeros(grid), Field::zeros(other)];
    kit::assert_refused! { RelativeDisplacement::new(fields) => Error::GridMismatch { .. } }
}

/// Round-off is accepted. Half of the engineering shear strain belongs into both corners.
#[test]
fn strain_that_is_not_symmetric_is_rejected() {
    let grid = kit::square(8, 4.0);
    for (strain, value) in [
        ([[0.0, 2e-3], [0.0, 0.0]], 0.0),
        ([[0.0, 0.0], [2e-3, 0.0]], 2e-3),
        ([[0.0, 1e-3], [-1e-3, 0.0]], -1e-3),
        ([[1.0, 1e-3], [1e-3 + 1e-11, 1.0]], 1e-3 + 1e-11),
    ] {
        let error = RelativeDisplacement::bulk_strain(grid, strain).unwrap_err();
        let Error::Sample {
            quantity: "bulk strain",
            index: 2,
            value: found,
            rule,
        } = error
        else {
            panic!("{error:?}");
        };
        assert!(found == value && rule.contains("half of the engineering shear strain"));
    }
    let rounded = [[1.0, 1e-3], [1e-3 + 1e-13, 1.0]];
    assert!(RelativeDisplacement::bulk_strain(grid, rounded).is_ok());
}

/// A strain in per cent has the warning, also if it was created from fields. A strain of 0.02, a rotation and a strain that is
/// zero in the mean do not have it.
#[test]
fn bulk_strain_in_per_cent_gives_warning() {
    let grid = Grid::square(16, 2.8).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let gap = kit::sphere(grid, 20.0);
    let force = NormalLoad::Force(0.07);
    let normal = kit::solve(NormalProblem::builder(&bodies, &gap, force));
    let friction = || kit::coulomb(FRICTION);
    let still = TangentialLoad::force([0.0; 2]);
    for (strain, per_mille) in [
        ([[0.02, 0.0], [0.0, -0.01]], None),
        ([[0.05, 0.0], [0.0, 0.0]], Some(50)),
        ([[0.0, -0.03], [-0.03, 0.01]], Some(30)),
        ([[0.0, 0.0], [0.0, 1.0]], Some(1000)),
    ] {
        let expected = per_mille.map(|per_mille| Warning::LargeBulkStrain { per_mille });
        let bulk = RelativeDisplacement::bulk_strain(grid, strain).unwrap();
        let shear = |bulk: &RelativeDisplacement| {
            let shear = TangentialProblem::builder(&bodies, &normal, friction(), still);
            kit::solve(
                shear
                    .model(TangentialModel::Vector)
                    .relative_displacement(bulk.clone()),
            )
        };
        assert_eq!(large_strain(shear(&bulk).warnings()), expected);
        let fields = bulk.fields().map(Field::clone);
        let fields = RelativeDisplacement::new(fields).unwrap();
        assert_eq!(large_strain(shear(&fields).warnings()), expected);
        let coupled = CoupledProblem::builder(&bodies, &gap, friction(), force, still);
        let coupled = kit::solve(coupled.relative_displacement(bulk.clone()));
        assert_eq!(large_strain(coupled.warnings()), expected);

        let mut history = History::builder(&bodies, &gap, friction())
            .model(TangentialModel::Vector)
            .relative_displacement(RelativeDisplacement::bulk_strain(grid, strain).unwrap())
            .build()
            .unwrap();
        let press = LoadStep::force([0.0; 2]).normal(force);
        let mut after = |load: &LoadStep| large_strain(history.step(load).unwrap().warnings());
        assert_eq!(after(&press), None);
        assert_eq!(after(&press.relative_displacement(0.01)), None);
        assert_eq!(after(&press.relative_displacement(-1.0)), expected);
        // The amount is kept.
        assert_eq!(after(&LoadStep::hold()), expected);
        let mut restored = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
        let step = restored.step(&LoadStep::hold()).unwrap();
        assert_eq!(large_strain(step.warnings()), expected);
    }
    let rotation = |x: f64, y: f64| [-0.1 * y, 0.1 * x];
    let wave = |x: f64, _: f64| [0.1 * (4.0 * x).cos(), 0.0];
    for pattern in [&rotation as &dyn Fn(f64, f64) -> [f64; 2], &wave] {
        let fields = [0, 1].map(|axis| Field::from_fn(grid, |x, y| pattern(x, y)[axis]));
        let fields = RelativeDisplacement::new(fields).unwrap();
        let shear = TangentialProblem::builder(&bodies, &normal, friction(), still);
        let shear = shear
            .model(TangentialModel::Vector)
            .relative_displacement(fields);
        assert_eq!(large_strain(kit::solve(shear).warnings()), None);
    }
}

/// Returns the warning about a large strain.
fn large_strain(warnings: Vec<Warning>) -> Option<Warning> {
    let mut warnings = warnings.into_iter();
    warnings.find(|warning| matches!(warning, Warning::LargeBulkStrain { .. }))
}

/// On a periodic axis, a strain along the axis would make the displacement discontinuous between periods.
#[test]
fn strain_along_periodic_axis_is_rejected() {
    let grid = kit::square(8, 4.0);
    let gap = kit::sphere(grid, 10.0);
    let force = NormalLoad::Force(0.1);
    for boundary in boundaries(grid) {
        let bodies = HalfSpace::with_boundary(grid, unit_pair(0.3), boundary).unwrap();
        let normal = NormalProblem::builder(&bodies, &gap, force)
            .build()
            .unwrap();
        let normal = normal.solve().unwrap();
        let repeats = match boundary {
            Boundary::NonPeriodic => [false; 2],
            Boundary::PeriodicAlongY { .. } => [false, true],
            _ => [true; 2],
        };
        // The first component along a periodic axis has this index.
        for (strain, index) in [
            ([[0.25, 0.0], [0.0, 0.0]], 0),
            ([[0.0, 0.25], [0.25, 0.0]], if repeats[1] { 1 } else { 2 }),
            ([[0.0, 0.0], [0.0, 0.25]], 3),
        ] {
            let bulk = RelativeDisplacement::bulk_strain(grid, strain).unwrap();
            let history = History::builder(&bodies, &gap, kit::coulomb(FRICTION))
                .model(TangentialModel::Vector)
                .relative_displacement(bulk.clone())
                .build();
            let load = TangentialLoad::force([0.0; 2]);
            let shear = TangentialProblem::builder(&bodies, &normal, kit::coulomb(FRICTION), load)
                .model(TangentialModel::Vector)
                .relative_displacement(bulk.clone())
                .build();
            let coupled =
                CoupledProblem::builder(&bodies, &gap, kit::coulomb(FRICTION), force, load)
                    .relative_displacement(bulk)
                    .build();
            for error in [history.err(), shear.err(), coupled.err()] {
                let is_refused = strain.iter().any(|row| {
                    let parts = row.iter().zip(repeats);
                    parts
                        .into_iter()
                        .any(|(part, repeats)| *part != 0.0 && repeats)
                });
                if is_refused {
                    let Some(Error::Sample {
                        quantity,
                        index: at,
                        value,
                        ..
                    }) = error
                    else {
                        panic!("{boundary:?} {strain:?}: {error:?}");
                    };
                    assert_eq!((quantity, at, value), ("bulk strain", index, 0.25));
                } else {
                    assert_eq!(error, None, "{boundary:?} {strain:?}");
                }
            }
        }
    }
}
