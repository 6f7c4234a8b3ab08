//! Tolerance, method and limits can be set together and changed between solves. Rejected settings change nothing.

use kit::unit_bodies;
use stickslip::cgm::{Method, Settings};
use stickslip::{
    Axis, Error, Field, HalfSpace, History, LoadStep, NormalLoad, NormalProblem, Status,
    TangentialControl, TangentialLoad, TangentialProblem,
};

fn ball() -> (HalfSpace, Field) {
    let grid = kit::square(40, 12.0);
    (unit_bodies(grid, 0.3), kit::sphere(grid, 20.0))
}

fn invalid_settings() -> [(Settings, Error); 2] {
    [
        (Settings::default().tolerance(0.0), Error::Tolerance(0.0)),
        (Settings::default().max_iterations(0), Error::IterationLimit),
    ]
}

#[test]
fn builder_accepts_all_settings() {
    let (bodies, gap) = ball();
    let settings = Settings::default()
        .tolerance(1e-5)
        .method(Method::PolonskyKeer);
    let load = NormalLoad::Force(4.0);
    let builder = || NormalProblem::builder(&bodies, &gap, load);
    let at_once = builder().settings(settings).build().unwrap();
    let one_by_one = builder().tolerance(1e-5).method(Method::PolonskyKeer);
    let one_by_one = kit::solve(one_by_one);
    assert_eq!(at_once.solve().unwrap().pressure(), one_by_one.pressure());
    assert_eq!(*at_once.into_solver().unwrap().settings(), settings);

    let friction = kit::coulomb(0.4);
    for (settings, error) in invalid_settings() {
        assert_eq!(builder().settings(settings).build().unwrap_err(), error);
        let history = History::builder(&bodies, &gap, friction.clone());
        assert_eq!(history.settings(settings).build().unwrap_err(), error);
    }
}

#[test]
fn solver_accepts_new_settings() {
    let (bodies, gap) = ball();
    let rough = Settings::default().tolerance(1e-3);
    let fine = Settings::default().tolerance(1e-10);
    let problem = NormalProblem::builder(&bodies, &gap, NormalLoad::Force(4.0)).settings(rough);
    let mut press = kit::solver(problem);
    let mut contact = kit::solved(&mut press);
    assert!(contact.report().energy_error_bound() > 1e-10);
    for (settings, error) in invalid_settings() {
        assert_eq!(press.set_settings(settings).unwrap_err(), error);
        assert_eq!(*press.settings(), rough);
    }
    press.set_settings(fine).unwrap();
    press.solve_into(&mut contact).unwrap();
    assert!(contact.report().energy_error_bound() <= 1e-10);

    let load = TangentialLoad::force([0.6, 0.0]);
    let problem =
        TangentialProblem::builder(&bodies, &contact, kit::coulomb(0.4), load).settings(rough);
    let mut shear = kit::solver(problem);
    let mut slip = kit::solved(&mut shear);
    assert!(slip.report().energy_error_bound() > 1e-10);
    for (settings, error) in invalid_settings() {
        assert_eq!(shear.set_settings(settings).unwrap_err(), error);
        assert_eq!(*shear.settings(), rough);
    }
    shear.set_settings(fine).unwrap();
    shear.solve_into(&mut slip).unwrap();
    assert!(slip.report().energy_error_bound() <= 1e-10);
    shear.set_settings(fine.max_iterations(1)).unwrap();
    shear.set_load(TangentialLoad::force([-0.9, 0.0])).unwrap();
    assert!(shear.solve_into(&mut slip).is_err());
    assert_eq!(slip.report().status, Status::IterationLimit);
}

#[test]
fn history_accepts_new_settings_for_pressure_and_traction() {
    let (bodies, gap) = ball();
    let rough = Settings::default().tolerance(1e-3);
    let builder = History::builder(&bodies, &gap, kit::coulomb(0.4)).settings(rough);
    let mut history = builder.build().unwrap();
    let step = |load, pull| {
        LoadStep::hold()
            .normal(NormalLoad::Force(load))
            .tangential(Axis::X, TangentialControl::Force(pull))
    };
    history.step(&step(4.0, 0.6)).unwrap();
    let before = history.to_bytes();
    for (settings, error) in invalid_settings() {
        assert_eq!(history.set_settings(settings).unwrap_err(), error);
        assert_eq!(history.to_bytes(), before);
    }
    let fine = Settings::default().tolerance(1e-10);
    history.set_settings(fine).unwrap();
    let step = history.step(&step(5.0, -0.6)).unwrap();
    for report in [step.normal_report(), step.tangential_report()] {
        assert!(report.unwrap().energy_error_bound() <= 1e-10);
    }

    // A restored history has the same settings, which can be changed.
    let mut restored = History::from_bytes(&bodies, &history.to_bytes()).unwrap();
    assert_eq!(*restored.settings(), fine);
    restored.set_settings(rough).unwrap();
    assert_eq!(*restored.settings(), rough);
}
