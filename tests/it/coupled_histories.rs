//! Tests of histories of dissimilar bodies: comparisons with CONTACT step by step, loops, wear, and steps of any
//! length.

use kit::contact::Case;
use kit::{Random, max_difference};
use std::ops::ControlFlow;
use stickslip::analytical::{FlatPunch, HertzSphere, SpencePressing};
use stickslip::history::wear::{self, CycleJump};
use stickslip::history::{AdaptiveSteps, Cycle, EntryRule, FrettingLoop, LoadPath};
use stickslip::{
    Axis, Coupling, ElasticPair, Error, Field, Grid, HalfSpace, History, LoadStep, Material,
    NormalLoad, Status, TangentialControl, TangentialModel, Warning, Zone,
};

/// Tolerance relative to the largest pressure.
const AGREED: f64 = 1e-7;

/// Compares every step of a case of CONTACT, including its zones, at the default tolerance. The bodies are only pressed.
/// The number of examinations is limited. One examination is allowed before each semismooth Newton step, one at the end,
/// and one for a start that is too poor for Newton steps.
fn assert_every_step_agrees(name: &str, steps: usize, examinations: usize) {
    let case = Case::read(name, steps);
    let bodies = HalfSpace::new(case.grid, case.pair).unwrap();
    let mut history = History::builder(
        &bodies,
        case.gap(&case.steps[0]),
        kit::coulomb(case.friction),
    )
    .entry_rule(EntryRule::WholeStep)
    .build()
    .unwrap();
    for (number, step) in case.steps.iter().enumerate() {
        history.set_gap(&case.gap(step)).unwrap();
        let load = LoadStep::shift([0.0; 2]).normal(step.normal_control().unwrap());
        history.step(&load).unwrap();
        let report = history.last_step().unwrap().tangential_report().unwrap();
        assert!(report.history.len() <= examinations, "{number}: {report:?}");
        assert!(
            (history.approach() / step.approach - 1.0).abs() < 1e-7,
            "{number}"
        );
        let energy = history.last_step().unwrap().energy();
        let elastic = step.elastic_energy.unwrap();
        assert!(
            (energy.elastic_after / elastic - 1.0).abs() < 1e-7,
            "{number}"
        );
        let lost = (energy.dissipated_energy - step.dissipated_energy).abs();
        assert!(lost < 1e-7 * elastic, "{number}: {lost:e}");
        if !step.cells.is_empty() {
            let fields = (history.pressure(), history.traction(), history.zones());
            case.assert_fields_agree(step, fields, AGREED, false);
        }
    }
}

/// Presses a sphere onto a rigid plane in 35 steps (Spence's compression).
#[test]
fn pressed_sphere_matches_contact_code() {
    assert_every_step_agrees("spence35_dissimilar", 35, 7);
}

/// Presses and then tilts a flat punch, so that some cells leave the contact and others reverse their slip.
#[test]
fn tilted_punch_matches_contact_code() {
    assert_every_step_agrees("tb25_tb26_flat_2d_dissimilar", 2, 10);
}

/// On a rigid punch, the closed form in full stick is valid for Poisson's ratio 1/2. For other bodies, pressing alone
/// slips at the edge, and shear moves the bodies farther than the closed form.
#[test]
fn pressed_punch_slips_unless_incompressible() {
    let grid = kit::square(kit::thorough(48, 64), 2.4);
    let gap = Field::from_fn(grid, |x, y| if x.hypot(y) < 1.0 { 0.0 } else { 1e3 });
    for (poisson_ratio, stick, ratios) in [(0.5, 1.0, [1.0, 1.0]), (0.3, 0.8, [1.03, 1.08])] {
        let pair = kit::on_rigid(1.0, poisson_ratio);
        let bodies = HalfSpace::new(grid, pair).unwrap();
        let builder =
            History::builder(&bodies, &gap, kit::coulomb(0.3)).model(TangentialModel::Vector);
        let mut history = builder.build().unwrap();
        history.step(&press_to(1.0)).unwrap();
        let found = history.last_step().unwrap().stick_ratio();
        assert!((found - stick).abs() < 0.03, "{poisson_ratio}: {found}");
        for (part, ratio) in [0.3, 0.6].into_iter().zip(ratios) {
            let drag = TangentialControl::Force(0.3 * part);
            history
                .step(&press_to(1.0).tangential(Axis::X, drag))
                .unwrap();
            let punch = FlatPunch::new(&pair, 1.0, 1.0).unwrap();
            let closed = punch.full_stick(0.3, 0.3 * part).unwrap().shift();
            let found = history.shift()[0] / closed;
            assert!((found - ratio).abs() < 0.01, "{poisson_ratio}: {found}");
        }
    }
}

fn ball_problem(cells: usize) -> (HalfSpace, Field) {
    let grid = kit::square(cells, 2.6);
    let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, 0.0)).unwrap();
    (bodies, kit::sphere(grid, 10.0))
}

/// The stick radius of a pressed sphere converges to the value of the punch (0.5), with an error inversely proportional to
/// the number of steps.
#[test]
fn stick_radius_converges_with_first_order_in_steps() {
    let (bodies, gap) = ball_problem(53);
    let whole = 4.0 / 30.0 * bodies.pair().contact_modulus();
    let hertz = HertzSphere::new(bodies.pair(), 10.0, whole).unwrap();
    assert!((hertz.contact_radius() - 1.0).abs() < 1e-9);
    let errors = [2_u32, 4, 8, 16].map(|steps| {
        let builder = History::builder(&bodies, &gap, kit::coulomb(0.29872)).tolerance(1e-6);
        let mut history = builder.build().unwrap();
        for step in 1..=steps {
            let radius = f64::from(step) / f64::from(steps);
            let force = NormalLoad::Force(whole * radius.powi(3));
            history.step(&LoadStep::hold().normal(force)).unwrap();
        }
        assert!((history.approach() / hertz.approach() - 0.979).abs() < 2e-3);
        0.5 - history.last_step().unwrap().stick_ratio().sqrt()
    });
    // On fine grids the stick radii are 0.368, 0.438, 0.473 and 0.489.
    for (error, expected) in errors.into_iter().zip([0.132, 0.062, 0.027, 0.011]) {
        assert!((error - expected).abs() < 0.012, "{errors:?}");
    }
}

/// The dissipation of a closed loop of force and shift equals its area.
#[test]
fn loop_area_equals_dissipation() {
    let (bodies, gap) = ball_problem(27);
    let mut history = History::builder(&bodies, &gap, kit::coulomb(0.4))
        .tolerance(1e-10)
        .build()
        .unwrap();
    let press = |shift| LoadStep::shift([shift, 0.0]).normal(NormalLoad::Force(0.1));
    history.step(&press(0.0)).unwrap();
    let turns = [0.05, 0.0, -0.05, 0.0];
    let cycle =
        |history: &mut History| turns.map(|shift| *history.step(&press(shift)).unwrap().energy());
    for _ in 0..4 {
        cycle(&mut history);
    }
    let energies = cycle(&mut history);
    let work: f64 = energies.iter().map(|energy| energy.work).sum();
    let lost = energies
        .map(|energy| energy.dissipated_energy_midpoint + energy.released + energy.residual);
    let lost: f64 = lost.iter().sum();
    assert!(
        lost > 0.0 && (work / lost - 1.0).abs() < 1e-8,
        "{work:e} {lost:e}"
    );
}

/// If the coupling is negligible, the coupled algorithm gives the same solution as the uncoupled algorithm. Dundurs'
/// constant is just above the threshold below which bodies count as uncoupled.
#[test]
fn weak_coupling_matches_uncoupled_solution() {
    let grid = kit::square(27, 2.6);
    let gap = kit::sphere(grid, 10.0);
    let one = Material::new(1.0, 0.3).unwrap();
    let other = Material::new(1.0 + 1e-8, 0.3).unwrap();
    let [coupled, uncoupled] = [other, one].map(|body| {
        let bodies = HalfSpace::new(grid, ElasticPair::new(one, body).unwrap()).unwrap();
        let builder =
            History::builder(&bodies, &gap, kit::coulomb(0.4)).model(TangentialModel::Vector);
        let builder = builder.entry_rule(EntryRule::WholeStep);
        let mut history = builder.tolerance(1e-11).build().unwrap();
        assert_eq!(bodies.pair().is_coupled(), body == other);
        let press = |force| LoadStep::hold().normal(NormalLoad::Force(force));
        let drag = TangentialControl::Force(0.01);
        history.step(&press(0.04)).unwrap();
        history
            .step(&press(0.06).tangential(Axis::X, drag))
            .unwrap();
        history
            .step(&press(0.05).tangential(Axis::Y, drag).twist(0.01))
            .unwrap();
        history
    });
    let largest = coupled.pressure().max();
    let [a, b] = [&coupled, &uncoupled].map(|history| history.pressure().as_slice());
    assert!(max_difference(a, b) < 1e-7 * largest);
    for axis in 0..2 {
        let [a, b] = [&coupled, &uncoupled].map(|history| history.traction()[axis].as_slice());
        assert!(max_difference(a, b) < 1e-7 * largest);
    }
    assert_eq!(coupled.zones(), uncoupled.zones());
}

/// For rough bodies of random pairs, every step converges.
#[test]
fn rough_histories_of_random_pairs_converge() {
    let mut random = Random(3);
    for scene in 0..12 {
        let grid = Grid::new(random.integer(12, 28), random.integer(12, 28), 1.0, 1.0).unwrap();
        let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, random.uniform(0.0, 0.3))).unwrap();
        let height = random.decade(-2.0, 0.0);
        let gap = Field::from_fn(grid, |x, y| {
            0.002 * (x * x + y * y) + height * random.uniform(0.0, 1.0)
        });
        let coefficient = random.decade(-1.0, 0.0);
        let mut history = History::builder(&bodies, &gap, kit::coulomb(coefficient))
            .build()
            .unwrap();
        for _ in 0..6 {
            let force = random.decade(-3.0, -1.5) * grid.area();
            let (angle, part) = (
                random.uniform(0.0, std::f64::consts::TAU),
                random.uniform(0.0, 0.9),
            );
            let shear = part * coefficient * force;
            let load = LoadStep::force([shear * angle.cos(), shear * angle.sin()]);
            let step = history
                .step(&load.normal(NormalLoad::Force(force)))
                .unwrap();
            assert!(
                step.tangential_report().unwrap().history.len() < 30,
                "{scene}"
            );
        }
    }
}

fn aluminium_on_steel(cells: usize, coefficient: f64, coupling: Coupling) -> History {
    let grid = kit::square(cells, 0.3e-3);
    let [aluminium, steel] =
        [(70e9, 0.33), (210e9, 0.3)].map(|(modulus, ratio)| Material::new(modulus, ratio).unwrap());
    let pair = ElasticPair::new(aluminium, steel).unwrap();
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let builder = History::builder(
        &bodies,
        kit::sphere(grid, 3.5e-3),
        kit::coulomb(coefficient),
    );
    let builder = builder.model(TangentialModel::Vector).coupling(coupling);
    builder.build().unwrap()
}

fn press_to(force: f64) -> LoadStep {
    LoadStep::hold().normal(NormalLoad::Force(force))
}

/// The stick ratio of a pressed sphere approaches Spence's law as the tolerance decreases.
#[test]
fn press_to_tolerance_matches_spence() {
    let cells = kit::thorough(32, 96);
    let exact = 0.7117;
    let all = [(0.06, 8, 0.12), (0.03, 16, 0.08), (0.01, 32, 0.04)];
    let mut last = f64::INFINITY;
    for (tolerance, most, bound) in all.into_iter().take(kit::thorough(2, 3)) {
        let mut history = aluminium_on_steel(cells, 0.1, Coupling::OneWay);
        let spence = SpencePressing::round(history.state().pair(), 0.1).unwrap();
        assert!((spence.stick_radius().powi(2) - exact).abs() < 1e-4);
        let steps = history.press(&press_to(60.0), tolerance).unwrap();
        let error = (history.last_step().unwrap().stick_ratio() - exact).abs();
        assert!(
            steps <= most && error < bound && error < last,
            "{steps} {error}"
        );
        assert_eq!(history.steps(), steps as u64);
        last = error;
    }
}

/// The difference from a solution with half as many steps bounds the difference from a solution with many steps.
#[test]
fn press_to_tolerance_estimates_its_error() {
    let press = |load: LoadStep, tolerance: f64| {
        let mut history = aluminium_on_steel(24, 0.1, Coupling::OneWay);
        history.press(&load, tolerance).unwrap();
        history
    };
    let loads = [
        press_to(60.0),
        LoadStep::hold().normal(NormalLoad::Approach(3.5e-6)),
        press_to(60.0).tangential(Axis::X, TangentialControl::Force(2.0)),
    ];
    for load in loads.into_iter().take(kit::thorough(1, 3)) {
        let many = press(load, kit::thorough(0.01, 0.004));
        for tolerance in [0.1, 0.04] {
            let few = press(load, tolerance);
            let [q, r] = [&few, &many].map(History::traction);
            let [x, y] = [0, 1].map(|axis| q[axis].minus(r[axis]).unwrap());
            let lengths = x.as_slice().iter().zip(y.as_slice());
            let sum: f64 = lengths.map(|(x, y)| x.hypot(*y)).sum();
            let error = sum * few.grid().cell_area() / few.friction_capacity();
            assert!(error < tolerance, "{tolerance}: {error}");
        }
    }
}

/// One step is exact for equal materials, for a contact of constant size, and without friction.
#[test]
fn press_to_tolerance_takes_two_steps_if_one_is_exact() {
    let punch = |cells: usize| {
        let grid = kit::square(cells, 2.6);
        let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, 0.0)).unwrap();
        let gap = Field::from_fn(grid, |x, y| if x.hypot(y) < 1.0 { 0.0 } else { 9.0 });
        History::builder(&bodies, gap, kit::coulomb(0.3))
            .build()
            .unwrap()
    };
    let alike = |cells: usize| {
        let grid = kit::square(cells, 2.6);
        let bodies = HalfSpace::new(grid, kit::unit_pair(0.3)).unwrap();
        History::builder(&bodies, kit::sphere(grid, 10.0), kit::coulomb(0.3))
            .build()
            .unwrap()
    };
    let smooth = aluminium_on_steel(24, 0.0, Coupling::OneWay);
    let ends_at_two_steps = |mut history: History, force: f64| {
        assert_eq!(history.press(&press_to(force), 1e-4).unwrap(), 2);
        let warnings = history.last_step().unwrap().warnings();
        assert!(!warnings.contains(&Warning::SingleLoadStep), "{warnings:?}");
        let reached = history.normal().force() / force;
        assert!((reached - 1.0).abs() < 1e-8);
    };
    ends_at_two_steps(punch(24), 0.1);
    ends_at_two_steps(alike(24), 0.05);
    ends_at_two_steps(smooth, 60.0);
}

/// Loads that increase from an earlier load or decrease to zero are also divided into steps with equal changes of the
/// contact size.
#[test]
fn press_to_tolerance_continues_from_a_load_and_unloads() {
    let mut history = aluminium_on_steel(24, 0.1, Coupling::OneWay);
    history.press(&press_to(20.0), 0.05).unwrap();
    history.press(&press_to(60.0), 0.05).unwrap();
    let mut direct = aluminium_on_steel(24, 0.1, Coupling::OneWay);
    direct.press(&press_to(60.0), 0.05).unwrap();
    let [a, b] = [&history, &direct].map(|history| history.last_step().unwrap().stick_ratio());
    assert!((a - b).abs() < 0.06, "{a} {b}");
    history.press(&press_to(0.0), 0.05).unwrap();
    assert!(history.normal().force() == 0.0 && history.pressure().max() == 0.0);
}

/// A call that fails or is cancelled leaves the state bitwise unchanged.
#[test]
fn press_to_tolerance_that_fails_leaves_state_unchanged() {
    let mut history = aluminium_on_steel(16, 0.1, Coupling::OneWay);
    history.step(&press_to(20.0)).unwrap();
    let before = history.to_bytes();
    let load = press_to(60.0);
    for tolerance in [0.0, 1.0, f64::NAN] {
        kit::assert_refused! { history.press(&load, tolerance) => Error::Tolerance(_) }
    }
    kit::assert_refused! { history.press(&press_to(f64::NAN), 0.05) => Error::NegativeOrNotFinite { .. } }
    // The first step succeeds, and a later step causes sliding.
    let slide = load.tangential(Axis::X, TangentialControl::Force(1e3));
    kit::assert_refused! { history.press(&slide, 0.05) => Error::BeyondFrictionCapacity { .. } }
    assert!(history.to_bytes() == before);
    let mut seen = 0;
    let outcome = history.press_observed(&load, 0.01, |_| {
        seen += 1;
        if seen < 20 {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    });
    let Err(Error::NotConverged(report)) = outcome else {
        panic!("{outcome:?}");
    };
    assert!(report.status == Status::Cancelled && history.to_bytes() == before);
    if kit::thorough(false, true) {
        kit::assert_refused! { history.press(&load, 1e-9) => Error::StepTooLong { .. } }
        assert!(history.to_bytes() == before);
    }
}

#[test]
fn adaptive_steps_divide_the_pressing() {
    let (bodies, gap) = ball_problem(27);
    let mut history = History::builder(&bodies, &gap, kit::coulomb(0.3))
        .build()
        .unwrap();
    let press = |force| LoadStep::hold().normal(NormalLoad::Force(force));
    history.step(&press(0.01)).unwrap();
    let mut adaptive = AdaptiveSteps::new(&history, 0.02).unwrap();
    let taken = adaptive.step(&mut history, &press(0.13)).unwrap();
    let radius = history.last_step().unwrap().stick_ratio().sqrt();
    assert!(taken > 1 && radius > 0.46, "{taken} {radius}");
}

/// Applies a thousand cycles of wear in jumps. A history that is saved and restored halfway has bitwise identical
/// results.
#[test]
fn wear_after_restart_is_bitwise_identical() {
    let (bodies, gap) = ball_problem(21);
    let mut history = History::builder(&bodies, &gap, kit::coulomb(0.4))
        .build()
        .unwrap();
    let press = NormalLoad::Force(0.1);
    history.step(&LoadStep::hold().normal(press)).unwrap();
    let path = LoadPath::triangle([0.05, 0.0], 4).unwrap();
    let fretting = FrettingLoop::new(path, |shift| LoadStep::shift(shift).normal(press));
    let steady = fretting.clone().until_steady(1e-3);
    steady.run(&mut history, 20).unwrap();
    let wear = |history: &mut History, mut cycles: f64, end: f64| {
        let mut gap = history.unloaded_gap().clone();
        let mut cycle = Cycle::new(history);
        while cycles < end {
            for _ in 0..2 {
                fretting.cycle(history, &mut cycle).unwrap();
            }
            let mut depth = Field::zeros(gap.grid());
            wear::energy(1e-3, cycle.dissipation(), &mut depth).unwrap();
            let jump = CycleJump::new(&bodies, &cycle, &depth).unwrap();
            let jump = jump.largest_depth(0.02 * history.approach());
            let jump = jump.cycles_left(end - cycles).cycles().unwrap();
            gap.add_scaled(jump, &depth).unwrap();
            history.set_gap(&gap).unwrap();
            cycles += jump;
        }
    };
    wear(&mut history, 0.0, 500.0);
    let mut restored = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
    for history in [&mut history, &mut restored] {
        wear(history, 500.0, 1000.0);
    }
    assert!(history.to_bytes() == restored.to_bytes());
    let worn = history.unloaded_gap().minus(&gap).unwrap();
    assert!(worn.max() > 1e-4 && worn.min() >= 0.0, "{}", worn.max());
}

/// Presses and shears along a straight load path. With the rule [`EntryRule::SinceTouch`], one step is as accurate as many
/// whole steps, for both strengths of coupling.
#[test]
fn growing_contact_in_one_step_matches_many_steps() {
    let scenes = [(0.3, [0.02, 0.005]), (0.45, [0.003, 0.002])];
    for (poisson_ratio, bounds) in scenes.into_iter().take(kit::thorough(1, 2)) {
        let grid = kit::square(41, 2.6);
        let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, poisson_ratio)).unwrap();
        let leg = |rule: EntryRule, steps: u32| {
            let builder = History::builder(&bodies, kit::sphere(grid, 10.0), kit::coulomb(0.6))
                .entry_rule(rule);
            let mut history = builder.tolerance(1e-8).build().unwrap();
            let press = |force| LoadStep::hold().normal(NormalLoad::Force(force));
            let mut take = |load: LoadStep| {
                let energy = history.step(&load).unwrap().energy();
                assert!(energy.imbalance().abs() < 1e-13 * energy.elastic_after);
            };
            for step in 1..=8_u32 {
                take(press(0.02 * (f64::from(step) / 8.0).powi(3)));
            }
            for step in 1..=steps {
                let part = f64::from(step) / f64::from(steps);
                let drag = TangentialControl::Force(0.036 * part);
                take(press(0.02 + 0.1 * part).tangential(Axis::X, drag));
            }
            history.shift()[0]
        };
        let many = kit::thorough(32, 64);
        let exact = leg(EntryRule::SinceTouch, many);
        assert!((leg(EntryRule::WholeStep, many) / exact - 1.0).abs() < 5e-3);
        for (steps, bound) in [1, 4].into_iter().zip(bounds) {
            let growth = (leg(EntryRule::SinceTouch, steps) / exact - 1.0).abs();
            assert!(growth < bound, "{steps}: {growth}");
        }
        let [growth, whole] = [EntryRule::SinceTouch, EntryRule::WholeStep]
            .map(|rule| (leg(rule, 1) / exact - 1.0).abs());
        assert!(whole > 3.0 * growth, "{growth} {whole}");
    }
}

/// Weakly coupled bodies that are pressed in a few long steps stick everywhere, as they do in many steps. Under
/// [`EntryRule::WholeStep`] a ring slips.
#[test]
fn weakly_coupled_press_sticks_for_any_number_of_steps() {
    let grid = kit::square(41, 2.6);
    let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, 0.45)).unwrap();
    let whole = 4.0 / 30.0 * bodies.pair().contact_modulus();
    let slipping = |rule: EntryRule, steps: u32| {
        let builder =
            History::builder(&bodies, kit::sphere(grid, 10.0), kit::coulomb(0.3)).entry_rule(rule);
        let mut history = builder.build().unwrap();
        for step in 1..=steps {
            let part = f64::from(step) / f64::from(steps);
            let press = NormalLoad::Force(whole * part.powi(3));
            history.step(&LoadStep::hold().normal(press)).unwrap();
        }
        let slips = |zone: &&Zone| **zone == Zone::Slip;
        history.zones().iter().filter(slips).count()
    };
    for steps in [1, 4] {
        assert_eq!(slipping(EntryRule::SinceTouch, steps), 0);
        assert!(slipping(EntryRule::WholeStep, steps) > 50);
    }
}
