//! A sphere of a different material is pressed in steps. The tests compare with Spence's stick zone and with contact
//! without slip.

use std::ops::ControlFlow;

use rayon::prelude::*;
use stickslip::analytical::{HertzSphere, NoSlipSphere};
use stickslip::history::Cycle;
use stickslip::{
    ElasticPair, Error, Grid, HalfSpace, History, Iteration, LoadStep, Material, NormalLoad,
    Status, Warning,
};

const RADIUS: f64 = 10.0;

/// Presses a sphere in steps of equal increments until the Hertzian contact has a radius of one.
fn pressed(poisson_ratio: f64, coefficient: f64, steps: u32) -> (History, f64) {
    let grid = kit::square(65, 2.4);
    let pair = kit::on_rigid(1.0, poisson_ratio);
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let whole = 4.0 / (3.0 * RADIUS) * pair.contact_modulus();
    let builder = History::builder(
        &bodies,
        kit::sphere(grid, RADIUS),
        kit::coulomb(coefficient),
    );
    let mut history = builder.tolerance(1e-6).build().unwrap();
    for step in 1..=steps {
        let radius = f64::from(step) / f64::from(steps);
        let force = NormalLoad::Force(whole * radius.powi(3));
        history.step(&LoadStep::hold().normal(force)).unwrap();
    }
    (history, whole)
}

/// Dundurs' beta, ratio of stick radius to contact radius, and the corresponding friction coefficient. The values were
/// computed for a punch from ring elements with elliptic integrals, to 3e-5. A sphere has the same values (Spence,
/// Proc. R. Soc. A 305 (1968) 55).
const STICK: [[f64; 3]; 10] = [
    [0.5, 0.1, 0.15508],
    [0.5, 0.3, 0.22659],
    [0.5, 0.5, 0.29872],
    [0.5, 0.7, 0.40124],
    [0.5, 0.9, 0.64746],
    [2.0 / 7.0, 0.1, 0.08072],
    [2.0 / 7.0, 0.3, 0.11704],
    [2.0 / 7.0, 0.5, 0.15249],
    [2.0 / 7.0, 0.7, 0.20053],
    [2.0 / 7.0, 0.9, 0.30387],
];

/// With 32 steps the stick radius is accurate to half a step.
#[test]
fn stepwise_pressed_sphere_sticks_as_in_spence() {
    let stick: Vec<_> = STICK.into_iter().step_by(kit::thorough(4, 1)).collect();
    stick
        .into_par_iter()
        .for_each(|[beta, radius, coefficient]| {
            let poisson_ratio = (1.0 - 2.0 * beta) / (2.0 - 2.0 * beta);
            let (history, _) = pressed(poisson_ratio, coefficient, 32);
            let found = history.last_step().unwrap().stick_ratio().sqrt();
            let error = (found - radius).abs();
            assert!(error < 0.5 / 32.0, "{beta} {radius}: {found}");
        });
}

/// Without slip a sphere is stiffer than without friction. The test compares the ratio of the load to the Hertzian load
/// at the same approach, extrapolated from 16 and 32 steps.
#[test]
fn sphere_without_slip_is_stiffer() {
    kit::thorough(&[0.3][..], &[0.0, 0.1, 0.2, 0.3, 0.4])
        .into_par_iter()
        .for_each(|&poisson_ratio| {
            let ratios = [16, 32].map(|steps| {
                let (history, whole) = pressed(poisson_ratio, 20.0, steps);
                assert!(history.last_step().unwrap().stick_ratio() > 0.99);
                let pair = *history.state().pair();
                let exact = NoSlipSphere::new(&pair, RADIUS, whole).unwrap();
                let error = (history.approach() / exact.approach() - 1.0).abs();
                assert!(
                    error < 0.1 / f64::from(steps),
                    "{poisson_ratio} {steps}: {error}"
                );
                let hertz = HertzSphere::new(&pair, RADIUS, whole).unwrap();
                (hertz.approach() / history.approach()).powf(1.5)
            });
            let pair = kit::on_rigid(1.0, poisson_ratio);
            let exact = NoSlipSphere::new(&pair, RADIUS, 1.0).unwrap();
            let hertz = HertzSphere::new(&pair, RADIUS, 1.0).unwrap();
            let exact = (hertz.approach() / exact.approach()).powf(1.5);
            let found = 2.0 * ratios[1] - ratios[0];
            assert!(
                (found - exact).abs() < 3e-4,
                "{poisson_ratio}: {found} for {exact}"
            );
        });
}

/// The observer receives only the accepted steps, and its errors undo all of them.
#[test]
fn observer_of_pressing_receives_accepted_steps() {
    let grid = Grid::square(16, 0.30e-3).unwrap();
    let metal = |modulus: f64, ratio: f64| Material::new(modulus, ratio).unwrap();
    let pair = ElasticPair::new(metal(70e9, 0.33), metal(210e9, 0.3)).unwrap();
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let build = || {
        let builder = History::builder(&bodies, kit::sphere(grid, 3.5e-3), kit::coulomb(0.1));
        builder.build().unwrap()
    };
    let load = LoadStep::hold().normal(NormalLoad::Force(60.0));
    let (mut history, mut plain) = (build(), build());
    let mut cycle = Cycle::new(&history);
    let mut forces = vec![];
    let mut iterations = [0; 2];
    let iterate = |_: &Iteration| {
        iterations[0] += 1;
        ControlFlow::Continue(())
    };
    let count = history.press_steps_observed(&load, 0.05, iterate, |history| {
        forces.push(history.normal().force());
        cycle.add(history)
    });
    let iterate = |_: &Iteration| {
        iterations[1] += 1;
        ControlFlow::Continue(())
    };
    assert_eq!(plain.press_observed(&load, 0.05, iterate), count);
    // The second taking of the accepted steps is observed too.
    assert!(iterations[0] > iterations[1]);
    assert_eq!(history.state(), plain.state());
    let [last, other] = [&history, &plain].map(|history| history.last_step().unwrap());
    assert!(last.energy() == other.energy() && last.slip() == other.slip());
    let count = count.unwrap();
    assert!(count > 2 && forces.len() == count && cycle.steps() == count);
    assert!(forces.is_sorted() && (forces[count - 1] / 60.0 - 1.0).abs() < 1e-9);
    assert!(!cycle.warnings().contains(&Warning::SingleLoadStep));
    // The sum over the steps is the energy of the whole load.
    let total: f64 = plain.accumulated_dissipation().as_slice().iter().sum();
    assert!((cycle.energy().dissipated_energy / total - 1.0).abs() < 1e-12);
    assert!(last.energy().dissipated_energy < 0.9 * total);

    let mut failed = build();
    let mut seen = 0;
    let unobserved = |_: &Iteration| ControlFlow::Continue(());
    let outcome = failed.press_steps_observed(&load, 0.05, unobserved, |_| {
        seen += 1;
        if seen == 2 {
            Err(Error::EmptyPath)
        } else {
            Ok(())
        }
    });
    assert_eq!(outcome, Err(Error::EmptyPath));
    assert_eq!(failed.state(), build().state());

    // The observer of the iterations cancels the call after the first observed step, and before.
    for limit in [1, iterations[1] + 1] {
        let mut count = 0;
        let cancel = |_: &Iteration| {
            count += 1;
            if count < limit {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        };
        let outcome = failed.press_steps_observed(&load, 0.05, cancel, |_| Ok(()));
        assert!(
            matches!(&outcome, Err(Error::NotConverged(report)) if report.status == Status::Cancelled)
        );
        assert_eq!(failed.state(), build().state());
    }
}
