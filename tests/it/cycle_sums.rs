//! A cycle accumulates its steps: slip, wear, energy, the loop of force and shift, and the fretting regime.

use kit::{max_abs, max_difference, rough, unit_bodies, unit_pair};
use stickslip::analytical::{HertzSphere, MindlinDeresiewicz};
use stickslip::history::{Cycle, FrettingLoop, LoadPath, Regime, wear};
use stickslip::{
    Axis, Boundary, Coupling, ElasticPair, Error, Field, HalfSpace, History, LoadStep, Material,
    NormalLoad, TangentialControl, TangentialModel, Warning,
};

const FRICTION: f64 = 0.4;
const LOAD: f64 = 4.0;
const LIMIT: f64 = FRICTION * LOAD;

fn new_history(gap: &Field, load: f64, lateral: TangentialModel, tolerance: f64) -> History {
    let bodies = unit_bodies(gap.grid(), 0.3);
    let mut history = History::builder(&bodies, gap, kit::coulomb(FRICTION))
        .model(lateral)
        .tolerance(tolerance)
        .build()
        .unwrap();
    let press = LoadStep::force([0.0; 2]).normal(NormalLoad::Force(load));
    history.step(&press).unwrap();
    history
}

fn ball_history(tolerance: f64) -> History {
    let gap = kit::sphere(kit::square(48, 12.0), 20.0);
    new_history(&gap, LOAD, TangentialModel::Scalar, tolerance)
}

/// Takes the steps of one cycle of forces.
fn run_cycle(history: &mut History, cycle: &mut Cycle, path: &LoadPath) {
    cycle.begin(history).unwrap();
    for &force in path.steps() {
        history.step(&LoadStep::force(force)).unwrap();
        cycle.add(history).unwrap();
    }
}

/// A path through zero returns to its start in the other direction, and thus repeats no loop.
#[test]
fn cycle_of_several_loops_gives_warning() {
    let is_warned = |cycle: &Cycle| cycle.warnings().contains(&Warning::RepeatedLoop);
    let add = |history: &mut History, cycle: &mut Cycle, path: &LoadPath, steps: usize| {
        for &force in path.steps().iter().cycle().take(steps) {
            history.step(&LoadStep::force(force)).unwrap();
            cycle.add(history).unwrap();
        }
    };
    for part in [1e-3, 0.6] {
        let path = LoadPath::sine([part * LIMIT, 0.0], 8).unwrap();
        let mut history = ball_history(1e-7);
        let mut cycle = Cycle::new(&history);
        // The first cycle starts without tractions, so that it does not close if cells slip.
        add(&mut history, &mut cycle, &path, 8);
        assert!(!is_warned(&cycle));
        cycle.begin(&history).unwrap();
        add(&mut history, &mut cycle, &path, 8);
        assert!(!is_warned(&cycle));
        let energy = cycle.energy().dissipated_energy;
        add(&mut history, &mut cycle, &path, 8);
        assert!(is_warned(&cycle));
        let twice = cycle.energy().dissipated_energy;
        assert!((twice - 2.0 * energy).abs() <= 1e-4 * energy + 1e-20);
        // Pauses under a constant load repeat nothing.
        cycle.begin(&history).unwrap();
        for _ in 0..3 {
            history.step(&LoadStep::hold()).unwrap();
            cycle.add(&history).unwrap();
        }
        assert!(!is_warned(&cycle));
    }
    // Points next to the start of a finely divided loop are closer to it than the tolerance of closed loops.
    let fine = LoadPath::sine([0.5 * LIMIT, 0.0], 1000).unwrap();
    let gap = kit::sphere(kit::square(12, 12.0), 20.0);
    let mut history = new_history(&gap, LOAD, TangentialModel::Scalar, 1e-5);
    let mut cycle = Cycle::new(&history);
    for _ in 0..2 {
        cycle.begin(&history).unwrap();
        add(&mut history, &mut cycle, &fine, 1000);
        assert!(!is_warned(&cycle));
    }
    add(&mut history, &mut cycle, &fine, 20);
    assert!(is_warned(&cycle));
    let ellipse = LoadPath::ellipse([0.5 * LIMIT, 0.3 * LIMIT], 1.0, 12).unwrap();
    let gap = kit::sphere(kit::square(48, 12.0), 20.0);
    let mut history = new_history(&gap, LOAD, TangentialModel::Vector, 1e-7);
    let mut cycle = Cycle::new(&history);
    add(&mut history, &mut cycle, &ellipse, 12);
    assert!(!is_warned(&cycle));
    // The first loop starts without tractions and thus from a different point.
    add(&mut history, &mut cycle, &ellipse, 12);
    assert!(is_warned(&cycle));
}

#[test]
fn cycle_that_does_not_close_gives_warning() {
    let stated = |cycle: &Cycle| {
        let mut warnings = cycle.warnings().into_iter();
        warnings.find_map(|warning| match warning {
            Warning::OpenCycle { per_cent } => Some(per_cent),
            _ => None,
        })
    };
    // Partial slip under a force, gross slip under a shift, and torsion.
    let force: fn([f64; 2]) -> LoadStep = LoadStep::force;
    let shift: fn([f64; 2]) -> LoadStep = LoadStep::shift;
    let twist = |[angle, _]: [f64; 2]| LoadStep::hold().twist(angle);
    for (amplitude, step) in [(0.8 * LIMIT, force), (0.5, shift), (0.1, twist)] {
        let gap = kit::sphere(kit::square(24, 12.0), 20.0);
        let mut history = new_history(&gap, LOAD, TangentialModel::Vector, 1e-7);
        let path = LoadPath::sine([amplitude, 0.0], 8).unwrap();
        let mut cycle = Cycle::new(&history);
        for repeat in 0..2 {
            cycle.begin(&history).unwrap();
            for (count, load) in path.steps().iter().enumerate() {
                history.step(&step(*load)).unwrap();
                cycle.add(&history).unwrap();
                // The first quarter does not turn back.
                let residual = cycle.cyclic_residual().unwrap();
                assert!(residual > 0.3 || repeat > 0);
                let open = (count > 1 && residual > 0.105).then_some(100.0 * residual);
                let per_cent = stated(&cycle).map(|per_cent| per_cent as f64);
                assert_eq!(per_cent, open.map(f64::round));
            }
        }
        assert_eq!(stated(&cycle), None);
    }
    // The first loop between two turning points starts from rest, and ends at a turning point.
    let gap = kit::sphere(kit::square(24, 12.0), 20.0);
    let mut history = new_history(&gap, LOAD, TangentialModel::Scalar, 1e-7);
    let mut cycle = Cycle::new(&history);
    let mut energies = [0.0; 2];
    for (repeat, energy) in energies.iter_mut().enumerate() {
        cycle.begin(&history).unwrap();
        for side in [1.0, -1.0, 1.0] {
            let step = LoadStep::force([0.8 * side * LIMIT, 0.0]);
            history.step(&step).unwrap();
            cycle.add(&history).unwrap();
        }
        assert_eq!(stated(&cycle).is_some(), repeat == 0);
        *energy = cycle.energy().dissipated_energy;
    }
    assert!(energies[0] > 1.1 * energies[1]);
    // Steps that only press bodies of different materials with friction change their tractions, but do not form a loop.
    let grid = kit::square(24, 12.0);
    let rubber = Material::new(2.0, 0.1).unwrap();
    let pair = ElasticPair::new(rubber, Material::rigid()).unwrap();
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let gap = kit::sphere(grid, 20.0);
    let builder = History::builder(&bodies, &gap, kit::coulomb(FRICTION));
    let mut history = builder.coupling(Coupling::Full).build().unwrap();
    let mut cycle = Cycle::new(&history);
    for part in 1..=4 {
        let load = NormalLoad::Force(0.25 * f64::from(part) * LOAD);
        history
            .step(&LoadStep::force([0.0; 2]).normal(load))
            .unwrap();
        cycle.add(&history).unwrap();
        assert!(cycle.cyclic_residual().unwrap() > 0.5);
        assert_eq!(stated(&cycle), None);
    }
}

/// Covers loads along an axis and in the plane, with a pressure that changes from step to step.
#[test]
fn cycle_quantities_are_sums_over_steps() {
    let gap = rough(kit::square(48, 100.0), 6);
    let (load, grid) = (30.0, gap.grid());
    for (lateral, phase) in [
        (TangentialModel::Scalar, 0.0),
        (TangentialModel::Vector, std::f64::consts::FRAC_PI_2),
    ] {
        let mut history = new_history(&gap, load, lateral, 1e-7);
        let across = if phase > 0.0 { 0.2 } else { 0.0 };
        let path = LoadPath::ellipse([0.3 * load, across * load], phase, 16).unwrap();
        let mut cycle = Cycle::new(&history);
        // Steps before `begin` do not count.
        run_cycle(&mut history, &mut cycle, &path);
        cycle.begin(&history).unwrap();

        let mut slip_distance = Field::zeros(grid);
        let mut dissipation = Field::zeros(grid);
        let mut depth = Field::zeros(grid);
        let mut slips = vec![history.slip().map(Clone::clone)];
        let (mut work, mut mid_step, mut imbalance) = (0.0, 0.0, 0.0);
        let mut ratios = Vec::new();
        let mut shifts = vec![history.shift()];
        for (number, &force) in path.steps().iter().enumerate() {
            let part = 1.0 + 0.1 * (number as f64).sin();
            let load = LoadStep::force(force).normal(NormalLoad::Force(part * load));
            let pressure = |history: &History| history.pressure().clone();
            history.step(&load).unwrap();
            cycle.add(&history).unwrap();
            let (pressure, step) = (pressure(&history), history.last_step().unwrap());
            slip_distance.add_scaled(1.0, step.slip_distance()).unwrap();
            dissipation.add_scaled(1.0, step.dissipation()).unwrap();
            wear::archard(0.1, &pressure, step.slip_distance(), &mut depth).unwrap();
            slips.push(history.slip().map(Clone::clone));
            work += step.energy().work;
            mid_step += step.energy().dissipated_energy_midpoint;
            imbalance += step.energy().imbalance();
            ratios.push(step.stick_ratio());
            shifts.push(history.shift());
        }
        assert_eq!(cycle.steps(), 16);
        assert_eq!(cycle.slip_distance(), &slip_distance);
        assert_eq!(cycle.dissipation(), &dissipation);
        let mut by_cycle = Field::zeros(grid);
        wear::archard(
            0.1,
            cycle.slip_pressure(),
            cycle.slip_distance(),
            &mut by_cycle,
        )
        .unwrap();
        let error = max_difference(by_cycle.as_slice(), depth.as_slice());
        assert!(depth.max() > 0.0 && error < 1e-14 * depth.max());

        let energy = cycle.energy();
        assert_eq!(
            (energy.work, energy.dissipated_energy_midpoint),
            (work, mid_step)
        );
        assert!((energy.imbalance() - imbalance).abs() < 1e-13 * work);
        for axis in 0..2 {
            let amplitude = Field::from_indices(grid, |ix, iy| {
                let values = slips.iter().map(|slip| slip[axis].get(ix, iy).unwrap());
                let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |ends, value| {
                    [ends[0].min(value), ends[1].max(value)]
                });
                0.5 * (high - low)
            });
            let found = cycle.slip_amplitude()[axis].as_slice();
            let error = max_difference(found, amplitude.as_slice());
            assert!(error <= 1e-14 * max_abs(slip_distance.as_slice()));
            let of_axis = shifts.iter().map(|shift| shift[axis]);
            let half = 0.5
                * (of_axis.clone().fold(f64::NEG_INFINITY, f64::max)
                    - of_axis.fold(f64::INFINITY, f64::min));
            assert_eq!(cycle.shift_amplitude()[axis], half);
        }
        let found: Vec<_> = cycle.points().iter().map(|point| point.shift).collect();
        assert_eq!(found, shifts);
        let force = cycle.points()[4].force[0];
        assert!((force / path.steps()[3][0] - 1.0).abs() < 1e-12);
        let least = ratios.iter().copied().fold(1.0, f64::min);
        let largest = ratios.iter().copied().fold(0.0, f64::max);
        assert_eq!(cycle.stick_ratios().unwrap(), [least, largest]);
        assert_eq!(cycle.regime().unwrap(), Regime::PartialSlip);
    }
}

/// The area of the loop by the trapezoidal rule equals the dissipation by mean tractions. The dissipation by the
/// tractions at the end of the steps agrees with Mindlin and Deresiewicz.
#[test]
fn cycle_loop_area_equals_dissipation() {
    let gap = kit::sphere(kit::square(kit::thorough(80, 128), 10.0), 20.0);
    let mut history = new_history(&gap, LOAD, TangentialModel::Scalar, 1e-9);
    let mut cycle = Cycle::new(&history);
    let hertz = HertzSphere::new(&unit_pair(0.3), 20.0, LOAD).unwrap();
    let path = LoadPath::sine([0.7 * LIMIT, 0.0], 24).unwrap();
    for _ in 0..2 {
        run_cycle(&mut history, &mut cycle, &path);
    }
    let mut area = 0.0;
    for ends in cycle.points().windows(2) {
        let mean = 0.5 * (ends[0].force[0] + ends[1].force[0]);
        area += mean * (ends[1].shift[0] - ends[0].shift[0]);
    }
    let energy = cycle.energy();
    assert!((area / energy.dissipated_energy_midpoint - 1.0).abs() < 1e-7);
    assert!((cycle.cyclic_residual().unwrap()) < 1e-7);
    let exact = MindlinDeresiewicz::new(hertz, FRICTION, &[0.7 * LIMIT]).unwrap();
    let error = energy.dissipated_energy / exact.energy_per_cycle() - 1.0;
    assert!(error.abs() < 2e-3, "{error:e}");
    let [shift, _] = cycle.shift_amplitude();
    let ratio = exact.energy_per_cycle() / (4.0 * 0.7 * LIMIT * shift);
    assert!((cycle.energy_ratio().unwrap() / ratio - 1.0).abs() < 2e-3);
}

/// For a sphere the energy ratio is 1/5 at the onset of sliding for all materials. It then increases to one.
#[test]
fn energy_ratio_separates_partial_from_gross_slip() {
    let gap = kit::sphere(kit::square(kit::thorough(64, 96), 10.0), 20.0);
    let mut history = new_history(&gap, LOAD, TangentialModel::Scalar, 1e-7);
    let mut cycle = Cycle::new(&history);
    let mut ratio_at = |amplitude: f64| {
        let path = LoadPath::triangle([amplitude, 0.0], 16).unwrap();
        for _ in 0..2 {
            cycle.begin(&history).unwrap();
            for &shift in path.steps() {
                history.step(&LoadStep::shift(shift)).unwrap();
                cycle.add(&history).unwrap();
            }
        }
        (cycle.energy_ratio().unwrap(), cycle.regime().unwrap())
    };
    let hertz = HertzSphere::new(&unit_pair(0.3), 20.0, LOAD).unwrap();
    let sliding = MindlinDeresiewicz::new(hertz, FRICTION, &[]).unwrap();
    let sliding = sliding.sliding_shift();
    let (ratio, regime) = ratio_at(0.5 * sliding);
    assert!(ratio < 0.15 && regime == Regime::PartialSlip);
    // Close to sliding the closed form is close to 1/5.
    let part: f64 = 0.99;
    let force = LIMIT * (1.0 - (1.0 - part).powf(1.5));
    let exact = MindlinDeresiewicz::new(hertz, FRICTION, &[force]).unwrap();
    let exact = exact.energy_per_cycle() / (4.0 * force * part * sliding);
    let (ratio, regime) = ratio_at(part * sliding);
    assert!((ratio / exact - 1.0).abs() < 1e-3 && (exact - 0.2).abs() < 1e-2);
    assert_eq!(regime, Regime::PartialSlip);
    let (ratio, regime) = ratio_at(1.05 * sliding);
    assert!(ratio > 0.2 && regime == Regime::GrossSlip);
    let (ratio, regime) = ratio_at(20.0 * sliding);
    assert!(ratio > 0.9 && ratio < 1.0 && regime == Regime::GrossSlip);
}

/// In the vector model the direction of the load does not affect the energy ratio.
#[test]
fn energy_ratio_is_the_same_in_all_directions() {
    let gap = kit::sphere(kit::square(48, 12.0), 20.0);
    let ratios = [[1.0, 0.0], [0.8, 0.6], [0.0, 1.0]].map(|[x, y]| {
        let mut history = new_history(&gap, LOAD, TangentialModel::Vector, 1e-7);
        let mut cycle = Cycle::new(&history);
        let force = 0.7 * LIMIT;
        let path = LoadPath::triangle([x * force, y * force], 8).unwrap();
        for _ in 0..2 {
            run_cycle(&mut history, &mut cycle, &path);
        }
        cycle.energy_ratio().unwrap()
    });
    assert!((ratios[2] / ratios[0] - 1.0).abs() < 1e-6);
    assert!((ratios[1] / ratios[0] - 1.0).abs() < 2e-2, "{ratios:?}");
}

#[test]
fn cycle_without_slip_is_full_stick() {
    let mut history = ball_history(1e-8);
    let mut cycle = Cycle::new(&history);
    assert_eq!(cycle.steps(), 0);
    // Ratios and regime of a cycle without steps are undefined.
    assert_eq!(cycle.regime(), Err(Error::EmptyPath));
    assert_eq!(cycle.stick_ratios(), Err(Error::EmptyPath));
    assert_eq!(cycle.cyclic_residual(), Err(Error::EmptyPath));
    assert_eq!(cycle.energy_ratio(), Err(Error::EmptyPath));
    assert_eq!(cycle.summary_as_csv(), Err(Error::EmptyPath));
    assert_eq!(cycle.energy().work, 0.0);
    // The outermost cells have a hundredth of the largest pressure, so this small force does not reach their friction
    // limit.
    run_cycle(
        &mut history,
        &mut cycle,
        &LoadPath::sine([1e-4 * LIMIT, 0.0], 8).unwrap(),
    );
    assert_eq!(cycle.regime().unwrap(), Regime::FullStick);
    assert_eq!(cycle.slip_distance().max(), 0.0);
    assert_eq!(cycle.stick_ratios().unwrap(), [1.0, 1.0]);
    assert_eq!(cycle.slip_pressure().max(), 0.0);
    // The cycle closes, although its first and last tractions almost vanish.
    assert!(
        cycle.cyclic_residual().unwrap() < 1e-5,
        "{}",
        cycle.cyclic_residual().unwrap()
    );
}

#[test]
fn cycle_of_first_loading_does_not_close() {
    let mut history = ball_history(1e-8);
    let mut cycle = Cycle::new(&history);
    let path = LoadPath::sine([0.0, 0.0], 4).unwrap();
    run_cycle(&mut history, &mut cycle, &path);
    assert_eq!(cycle.regime().unwrap(), Regime::FullStick);
    let path = LoadPath::sine([0.8 * LIMIT, 0.0], 8).unwrap();
    run_cycle(&mut history, &mut cycle, &path);
    assert!(cycle.cyclic_residual().unwrap() > 0.1);
    run_cycle(&mut history, &mut cycle, &path);
    assert!(cycle.cyclic_residual().unwrap() < 1e-6);
}

/// A cycle of torsion alone also has an energy ratio.
#[test]
fn cycle_of_torsion_has_an_energy_ratio() {
    let gap = kit::sphere(kit::square(48, 12.0), 20.0);
    let mut history = new_history(&gap, LOAD, TangentialModel::Vector, 1e-7);
    let path = LoadPath::sine([0.05, 0.0], 8).unwrap();
    let fretting = FrettingLoop::new(path, |[twist, _]| LoadStep::force([0.0; 2]).twist(twist));
    let outcome = fretting.run(&mut history, 3).unwrap();
    let cycle = outcome.last;
    let turn = cycle.points()[2];
    assert!(turn.twist == 0.05 && turn.moment > 0.0);
    let expected = cycle.energy().dissipated_energy / (4.0 * turn.moment * turn.twist);
    let ratio = cycle.energy_ratio().unwrap();
    assert!(
        (ratio / expected - 1.0).abs() < 1e-3 && ratio > 0.01,
        "{ratio} {expected} {}",
        cycle.cyclic_residual().unwrap()
    );
}

#[test]
fn cycle_rejects_history_on_a_different_grid() {
    let history = ball_history(1e-6);
    let other = kit::sphere(kit::square(40, 12.0), 20.0);
    let mut other = new_history(&other, LOAD, TangentialModel::Scalar, 1e-6);
    let mut cycle = Cycle::new(&history);
    let untouched = cycle.clone();
    let drag = LoadStep::hold().tangential(Axis::X, TangentialControl::Shift(0.1));
    other.step(&drag).unwrap();
    for outcome in [cycle.begin(&other), cycle.add(&other)] {
        assert!(matches!(outcome, Err(Error::GridMismatch { .. })));
    }
    assert_eq!(cycle, untouched);
}

#[test]
fn cycle_rejects_history_of_other_bodies() {
    let history = ball_history(1e-6);
    let (grid, gap) = (history.grid(), history.unloaded_gap());
    let mut cycle = Cycle::new(&history);
    let untouched = cycle.clone();
    let materials = unit_bodies(grid, 0.2);
    let periodic = HalfSpace::with_boundary(grid, unit_pair(0.3), Boundary::Periodic).unwrap();
    let drag = LoadStep::force([0.5 * LIMIT, 0.0]);
    let stepped = |bodies: &HalfSpace| {
        let builder = History::builder(bodies, gap, kit::coulomb(FRICTION));
        let mut other = builder.tolerance(1e-6).build().unwrap();
        let press = LoadStep::force([0.0; 2]).normal(NormalLoad::Force(LOAD));
        other.step(&press).unwrap();
        other.step(&drag).unwrap();
        other
    };
    let quantity = "history of the cycle";
    for (bodies, error) in [
        (materials, Error::MaterialMismatch { quantity }),
        (periodic, Error::BoundaryMismatch { quantity }),
    ] {
        let other = stepped(&bodies);
        assert_eq!(cycle.add(&other), Err(error.clone()));
        assert_eq!(cycle.begin(&other), Err(error));
    }
    assert_eq!(cycle, untouched);
    assert_eq!(cycle.add(&stepped(&unit_bodies(grid, 0.3))), Ok(()));
    let jump = wear::CycleJump::new(&unit_bodies(grid, 0.2), &cycle, &Field::zeros(grid));
    let quantity = "bodies of the jump";
    assert_eq!(jump, Err(Error::MaterialMismatch { quantity }));
}

/// Each step is added once, in order. No step is skipped or added twice, and no step is added before it has been taken.
#[test]
fn cycle_rejects_step_that_is_not_new() {
    let mut history = ball_history(1e-6);
    let mut cycle = Cycle::new(&history);
    let not_new = |step, last| Err(Error::StepOutOfOrder { step, last });
    let bodies = unit_bodies(history.grid(), 0.3);
    let jump = wear::CycleJump::new(&bodies, &cycle, history.accumulated_dissipation());
    assert!(matches!(jump, Err(Error::EmptyPath)));
    assert_eq!(cycle.add(&history), not_new(1, 1));
    let drag = LoadStep::force([0.5 * LIMIT, 0.0]);
    history.step(&drag).unwrap();
    assert_eq!(cycle.add(&history), Ok(()));
    let once = cycle.clone();
    assert_eq!(cycle.add(&history), not_new(2, 2));
    // The first history is different. The second is the same history after a restart.
    assert_eq!(cycle.add(&ball_history(1e-6)), not_new(1, 2));
    let mut restored = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
    assert_eq!(cycle.add(&restored), Err(Error::NoLastStep));
    assert_eq!(cycle, once);

    restored.step(&drag).unwrap();
    let mut late = restored.clone();
    late.step(&drag).unwrap();
    assert_eq!(cycle.add(&late), not_new(4, 2));
    assert_eq!(cycle.add(&restored), Ok(()));
    assert_eq!(cycle.steps(), 2);
    cycle.begin(&history).unwrap();
    assert_eq!(cycle.add(&history), not_new(2, 2));
}

/// A step of another history with the expected number is not the next step of the cycle.
#[test]
fn cycle_rejects_step_of_another_history_with_the_next_number() {
    let mut history = ball_history(1e-6);
    let mut other = ball_history(1e-6);
    let drag = |part: f64| LoadStep::force([part * LIMIT, 0.0]);
    let mut cycle = Cycle::new(&history);
    history.step(&drag(0.5)).unwrap();
    cycle.add(&history).unwrap();
    other.step(&drag(0.4)).unwrap();
    other.step(&drag(0.3)).unwrap();
    let untouched = cycle.clone();
    let not_next = Err(Error::StepOutOfOrder { step: 3, last: 2 });
    assert_eq!(cycle.add(&other), not_next);
    assert_eq!(cycle, untouched);
    // A state of the other history under the same number is not the state after the added step either.
    let mut replaced = history.clone();
    replaced.set_state(other.state()).unwrap();
    assert_eq!(cycle.add(&replaced), Err(Error::NoLastStep));
    history.step(&drag(0.3)).unwrap();
    cycle.add(&history).unwrap();

    // Two spheres under the same load differ in their approach before any tangential load.
    let mut cycle = Cycle::new(&ball_history(1e-6));
    let larger = kit::sphere(history.grid(), 21.0);
    let mut other = new_history(&larger, LOAD, TangentialModel::Scalar, 1e-6);
    other.step(&drag(0.5)).unwrap();
    assert_eq!(
        cycle.add(&other),
        Err(Error::StepOutOfOrder { step: 2, last: 1 })
    );
}

/// Before the first step, the forces and motions of all histories are equal. A press does not depend on the friction.
#[test]
fn cycle_rejects_step_of_history_with_other_input() {
    let gap = kit::sphere(kit::square(16, 12.0), 20.0);
    let bodies = unit_bodies(gap.grid(), 0.3);
    let build = |gap: &Field, friction: f64| {
        let builder = History::builder(&bodies, gap, kit::coulomb(friction));
        builder.tolerance(1e-6).build().unwrap()
    };
    let press = LoadStep::hold().normal(NormalLoad::Force(LOAD));
    let vector = History::builder(&bodies, &gap, kit::coulomb(FRICTION))
        .tolerance(1e-6)
        .model(TangentialModel::Vector);
    let others = [
        build(&gap, 0.3),
        build(&kit::sphere(gap.grid(), 21.0), FRICTION),
        vector.build().unwrap(),
    ];
    for mut other in others {
        let mut history = build(&gap, FRICTION);
        let mut cycle = Cycle::new(&history);
        other.step(&press).unwrap();
        let not_next = |step| {
            Err(Error::StepOutOfOrder {
                step,
                last: step - 1,
            })
        };
        assert_eq!(cycle.add(&other), not_next(1));
        history.step(&press).unwrap();
        cycle.add(&history).unwrap();
        other.step(&press).unwrap();
        assert_eq!(cycle.add(&other), not_next(2));
        // A change of friction and gap belongs to the same history, and so does a copy of its state.
        history.set_friction(&kit::coulomb(0.3)).unwrap();
        history.set_gap(&gap).unwrap();
        history.step(&press).unwrap();
        cycle.add(&history).unwrap();
        let mut copy = History::from_state(&bodies, history.state().clone()).unwrap();
        copy.step(&press).unwrap();
        cycle.add(&copy).unwrap();
        let mut restarted = History::from_bytes(&bodies, &copy.to_bytes()).unwrap();
        restarted.step(&press).unwrap();
        cycle.add(&restarted).unwrap();
        // An equal history counts as the same.
        let mut cycle = Cycle::new(&build(&gap, FRICTION));
        let mut equal = build(&gap, FRICTION);
        equal.step(&press).unwrap();
        cycle.add(&equal).unwrap();
    }
}
