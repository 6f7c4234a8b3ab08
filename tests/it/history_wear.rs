//! Gap and friction can change between steps without loss of the frictional state, and the wear depth follows the wear
//! law.

use std::ops::ControlFlow;

use kit::{Table2, rough, unit_bodies};
use stickslip::history::{Cycle, FrettingLoop, LoadPath, wear};
use stickslip::{
    Axis, Error, Field, Grid, HalfSpace, History, LoadStep, NormalLoad, Operator,
    TangentialControl, Warning, influence::Component,
};

fn shear(history: &mut History, tangential: TangentialControl) {
    let step = LoadStep::hold().tangential(Axis::X, tangential);
    history.step(&step).unwrap();
}

fn press(history: &mut History, normal: NormalLoad) {
    history.step(&LoadStep::hold().normal(normal)).unwrap();
}

/// Wear in full slip removes exactly k P s, since slip is the same in every cell.
#[test]
fn full_slip_wear_is_load_times_path() {
    let grid = kit::square(48, 100.0);
    let bodies = unit_bodies(grid, 0.3);
    let friction = kit::coulomb(0.4);
    for gap in [kit::sphere(grid, 300.0), rough(grid, 5)] {
        let builder = History::builder(&bodies, &gap, friction.clone());
        let mut history = builder.build().unwrap();
        press(&mut history, NormalLoad::Force(30.0));
        shear(&mut history, TangentialControl::Shift(50.0));
        let mut removed = [Field::zeros(grid), Field::zeros(grid)];
        let mut path = 0.0;
        for (from, to) in [(50.0, 53.0), (53.0, 61.0), (61.0, 65.0)] {
            shear(&mut history, TangentialControl::Shift(to));
            let step = history.last_step().unwrap();
            assert!(step.is_gross_slip());
            path += to - from;
            let [by_slip, by_energy] = &mut removed;
            wear::archard(2e-3, history.pressure(), step.slip_distance(), by_slip).unwrap();
            wear::energy(2e-3 / 0.4, step.dissipation(), by_energy).unwrap();
        }
        for removed in removed {
            let expected = 2e-3 * 30.0 * path;
            assert!((removed.integral() / expected - 1.0).abs() < 1e-12);
        }
    }
}

/// A new gap changes the state only in a step that solves for the pressure.
#[test]
fn new_gap_preserves_the_state() {
    let grid = kit::square(48, 12.0);
    let bodies = unit_bodies(grid, 0.3);
    let ball = kit::sphere(grid, 20.0);
    let friction = kit::coulomb(0.4);
    let build = || {
        let builder = History::builder(&bodies, &ball, friction.clone());
        let mut history = builder.build().unwrap();
        press(&mut history, NormalLoad::Force(4.0));
        shear(&mut history, TangentialControl::Force(1.2));
        shear(&mut history, TangentialControl::Force(-0.3));
        history
    };
    let (mut history, mut twin) = (build(), build());
    // A uniform offset changes only the approach.
    let raised = Field::from_fn(grid, |x, y| (x * x + y * y) / 40.0 + 0.125);
    history.set_gap(&raised).unwrap();
    assert_eq!(history.unloaded_gap(), &raised);
    for [a, b] in [
        [history.traction()[0], twin.traction()[0]],
        [history.slip()[0], twin.slip()[0]],
        [history.accumulated_slip(), twin.accumulated_slip()],
        [
            history.accumulated_dissipation(),
            twin.accumulated_dissipation(),
        ],
        [history.pressure(), twin.pressure()],
    ] {
        assert_eq!(a, b);
    }
    for history in [&mut history, &mut twin] {
        press(history, NormalLoad::Force(4.0));
        shear(history, TangentialControl::Force(0.5));
    }
    assert!((history.approach() - twin.approach() - 0.125).abs() < 1e-12);
    assert!((history.shift()[0] / twin.shift()[0] - 1.0).abs() < 1e-6);
    assert!((history.accumulated_slip().max() / twin.accumulated_slip().max() - 1.0).abs() < 1e-6);

    // The gap is worn in the middle under a constant pressure. The pressure changes only in a step that solves the
    // pressure problem.
    let mut worn = ball.clone();
    for (h, p) in worn
        .as_mut_slice()
        .iter_mut()
        .zip(twin.pressure().as_slice())
    {
        *h += 0.5 * p;
    }
    let (traction, pressure) = (twin.traction()[0].clone(), twin.pressure().clone());
    twin.set_gap(&worn).unwrap();
    shear(&mut twin, TangentialControl::Force(0.5));
    assert_eq!(twin.pressure(), &pressure);
    assert!(twin.last_step().unwrap().normal_report().is_none());
    let change = kit::max_difference(twin.traction()[0].as_slice(), traction.as_slice());
    assert!(change < 1e-7 * pressure.max());
    press(&mut twin, NormalLoad::Force(4.0));
    assert!(twin.pressure().max() < 0.99 * pressure.max());
    // The shift was constant. Force and traction followed the pressure.
    assert!(twin.tangential_force()[0] != 0.5 && twin.tangential_force()[0].abs() < 1.6);
}

/// Returns the warnings without the warnings about the resolution, which other tests check.
fn without_resolution_warnings(warnings: Vec<Warning>) -> Vec<Warning> {
    let is_other = |warning: &Warning| !matches!(warning, Warning::UnderresolvedSlipZone { .. });
    warnings.into_iter().filter(is_other).collect()
}

/// A wear loop that does not state the normal load gives a warning in every step. A loop that states the load gives no
/// warning.
#[test]
fn stale_pressure_causes_a_warning() {
    let grid = kit::square(32, 12.0);
    let bodies = unit_bodies(grid, 0.3);
    let builder = History::builder(&bodies, kit::sphere(grid, 20.0), kit::coulomb(0.4));
    let mut history = builder.build().unwrap();
    let worn = Field::from_fn(grid, |x, y| 0.025 * (x * x + y * y) + 0.01);
    // A change of the gap before the first contact does not make the pressure stale.
    history.set_gap(&worn).unwrap();
    history.step(&LoadStep::hold()).unwrap();
    assert_eq!(
        without_resolution_warnings(history.last_step().unwrap().warnings()),
        [Warning::NoContact]
    );
    press(&mut history, NormalLoad::Force(4.0));
    // Setting an identical gap does not make the pressure stale, either.
    history.set_gap(&worn).unwrap();
    shear(&mut history, TangentialControl::Shift(0.1));
    assert_eq!(
        without_resolution_warnings(history.last_step().unwrap().warnings()),
        []
    );

    let path = LoadPath::sine([0.1, 0.0], 4).unwrap();
    let forgetful = FrettingLoop::new(path.clone(), LoadStep::shift);
    let load = |shift| LoadStep::shift(shift).normal(NormalLoad::Force(4.0));
    let mindful = FrettingLoop::new(path, load);
    let mut warnings = Vec::new();
    let mut wear = |history: &mut History, _: &Cycle| {
        warnings.push(without_resolution_warnings(
            history.last_step().unwrap().warnings(),
        ));
        let mut gap = history.unloaded_gap().clone();
        gap.add_scaled(0.1, history.pressure())?;
        history.set_gap(&gap)?;
        Ok(ControlFlow::Continue(()))
    };
    forgetful.run_observed(&mut history, 1, &mut wear).unwrap();
    mindful.run_observed(&mut history, 1, &mut wear).unwrap();
    let held = vec![Warning::StalePressure];
    let mut expected = vec![held; 4];
    // The gap is worn after each step, so the pressure of the first step is up to date.
    expected[0].clear();
    expected.resize(8, Vec::new());
    assert_eq!(warnings, expected);

    // The result of a loop includes the warnings of all its steps.
    let outcome = forgetful.run(&mut history, 1).unwrap();
    assert_eq!(
        without_resolution_warnings(outcome.last.warnings()),
        [Warning::StalePressure]
    );
    // The first cycle under the new pressure does not close.
    let outcome = mindful.run(&mut history, 2).unwrap();
    assert_eq!(without_resolution_warnings(outcome.last.warnings()), []);

    history.set_gap(&worn).unwrap();
    // After a step that fails, the pressure is still stale.
    kit::assert_refused! { history.step(&LoadStep::force([99.0, 0.0]).normal(NormalLoad::Force(4.0))) => _ }
    let step = history.step(&LoadStep::hold()).unwrap();
    assert_eq!(
        without_resolution_warnings(step.warnings()),
        [Warning::StalePressure]
    );
    assert!(step.warnings()[0].to_string().contains("old gap"));
}

/// If the contact extends to the edge of the grid, the half-space result is affected.
#[test]
fn contact_at_grid_edge_causes_a_warning() {
    let grid = Grid::new(9, 7, 1.0, 1.0).unwrap();
    let bodies = unit_bodies(grid, 0.3);
    let flat = Field::zeros(grid);
    let builder = History::builder(&bodies, &flat, kit::coulomb(0.4));
    let mut history = builder.build().unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(4.0));
    let step = history.step(&press).unwrap();
    let expected = [Warning::ContactAtEdge {
        cells: 2 * (9 + 7) - 4,
    }];
    assert_eq!(step.warnings(), expected);
    let path = LoadPath::sine([0.1, 0.0], 4).unwrap();
    let outcome = FrettingLoop::new(path, LoadStep::force).run(&mut history, 1);
    assert_eq!(outcome.unwrap().last.warnings(), expected);
}

/// A lower friction coefficient causes further slip. A higher coefficient changes nothing.
#[test]
fn new_friction_limits_the_force() {
    let grid = kit::square(48, 12.0);
    let bodies = unit_bodies(grid, 0.3);
    let builder = History::builder(&bodies, kit::sphere(grid, 20.0), kit::coulomb(0.4));
    let mut history = builder.build().unwrap();
    assert_eq!(history.friction_capacity(), 0.0);
    press(&mut history, NormalLoad::Force(4.0));
    shear(&mut history, TangentialControl::Force(1.2));
    let (shift, path) = (history.shift()[0], history.accumulated_slip().integral());
    assert!((history.friction_capacity() - 1.6).abs() < 1e-12);

    history.set_friction(&kit::coulomb(0.8)).unwrap();
    assert!((history.friction_capacity() - 3.2).abs() < 1e-12);
    shear(&mut history, TangentialControl::Force(1.2));
    assert!((history.shift()[0] / shift - 1.0).abs() < 1e-7);
    assert!((history.accumulated_slip().integral() / path - 1.0).abs() < 1e-7);

    history.set_friction(&kit::coulomb(0.32)).unwrap();
    shear(&mut history, TangentialControl::Force(1.2));
    assert!(
        history.shift()[0] > 1.05 * shift && history.accumulated_slip().integral() > 1.05 * path
    );
    history.set_friction(&kit::coulomb(0.2)).unwrap();
    let holds = history.friction_capacity();
    let held = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(1.2));
    kit::assert_refused! {
        history.step(&held) => Error::BeyondFrictionCapacity { limit, .. } if (limit - holds).abs() < 1e-12,
    }
    shear(&mut history, TangentialControl::Force(holds));
    assert!(history.last_step().unwrap().is_gross_slip());
}

#[test]
fn max_stable_cycles_separate_stable_from_unstable_wear() {
    let bodies = HalfSpace::new(kit::square(32, 32.0), Table2::pair()).unwrap();
    let grid = bodies.grid();
    let modulus = bodies.pair().contact_modulus();
    let stable = |slip: f64| wear::max_stable_cycles(&bodies, 1e-12, &Field::constant(grid, slip));
    // The expected number of cycles is 1.16 dx/E* divided by k s.
    let cycles = stable(0.5).unwrap();
    assert!((cycles * 1e-12 * 0.5 * modulus / 1.161 - 1.0).abs() < 1e-3);
    assert!(stable(0.0).unwrap() == f64::INFINITY && stable(-1.0).is_err());

    // On slender cells the limit is the Rayleigh quotient of the stiffest pattern.
    let slender = unit_bodies(Grid::new(32, 32, 1.0, 0.25).unwrap(), 0.3);
    let grid = slender.grid();
    let cycles = wear::max_stable_cycles(&slender, 1.0, &Field::constant(grid, 1.0)).unwrap();
    let board = Field::from_indices(grid, |ix, iy| if (ix + iy) % 2 == 0 { 1.0 } else { -1.0 });
    let operator = slender.operator(Component::ZZ).unwrap();
    let mut image = Field::zeros(grid);
    operator.apply(
        [board.as_slice()],
        [image.as_mut_slice()],
        &mut operator.scratch().unwrap(),
    );
    let rayleigh = image.get(16, 16).unwrap() * board.get(16, 16).unwrap();
    assert!(cycles <= 2.0 * rayleigh * (1.0 + 1e-2) && cycles > 1.5 * rayleigh);

    // For wear below the limit the pressure evens out. For wear above the limit the pressure oscillates with growing
    // amplitude.
    for (factor, settles) in [(0.9, true), (1.6, false)] {
        let bodies = unit_bodies(kit::square(16, 16.0), 0.0);
        let grid = bodies.grid();
        let mut gap = Field::from_fn(grid, |x, y| 1e-3 * ((3.0 * x).sin() + (7.0 * y).cos()));
        let slip = Field::constant(grid, 1.0);
        let cycles = factor * wear::max_stable_cycles(&bodies, 1.0, &slip).unwrap();
        let builder = History::builder(&bodies, &gap, kit::coulomb(0.0));
        let mut history = builder.build().unwrap();
        for _ in 0..30 {
            press(&mut history, NormalLoad::Force(25.6));
            let pressure = history.pressure();
            wear::archard(cycles, pressure, &slip, &mut gap).unwrap();
            history.set_gap(&gap).unwrap();
        }
        // The mean pressure is 0.1.
        let [least, most] = [history.pressure().min(), history.pressure().max()];
        assert_eq!(least > 0.09 && most < 0.11, settles, "{least} {most}");
    }
}
