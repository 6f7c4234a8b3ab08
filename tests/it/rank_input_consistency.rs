//! Ranks with inconsistent inputs immediately report the input that differs. Different results on different
//! ranks are therefore impossible.

use std::fmt::Debug;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

use stickslip::cgm::Settings;
use stickslip::history::{AdaptiveSteps, EntryRule, wear};
use stickslip::normal::Hardness;
use stickslip::ranks::{RankFailure, Ranks, Threads};
use stickslip::stiffness::StiffnessWorkspace;
use stickslip::surface::{Form, SelfAffine};
use stickslip::tangential::RelativeDisplacement;
use stickslip::*;

use crate::rank_contacts::pair;

const RANKS: usize = 3;

fn grid() -> Grid {
    Grid::new(40, 306, 0.5, 0.5).unwrap()
}

/// Returns the outcomes on all ranks if the input of the second rank differs from the others.
fn outcomes<T: Send>(of: impl Fn(Arc<dyn Ranks>, bool) -> Result<T> + Sync) -> Vec<Result<T>> {
    Threads::run(RANKS, Duration::from_secs(60), |rank| {
        let is_odd = rank.rank() == 1;
        of(Arc::new(rank), is_odd)
    })
}

fn assert_reported<T: Debug + Send>(
    name: &'static str,
    of: impl Fn(Arc<dyn Ranks>, bool) -> Result<T> + Sync,
) {
    for outcome in outcomes(of) {
        let error = outcome.expect_err(name);
        assert_eq!(
            error,
            Error::Ranks(RankFailure::InconsistentInput(name)),
            "{name}"
        );
        assert_eq!(
            error.to_string(),
            format!(
                "the {name} must be the same on all ranks: compute it on one rank, or from equal input"
            )
        );
    }
}

fn bodies(ranks: Arc<dyn Ranks>) -> HalfSpace {
    HalfSpace::distributed(grid(), pair(), Boundary::NonPeriodic, ranks).unwrap()
}

fn ball(bodies: &HalfSpace) -> Field {
    Field::from_fn(bodies.grid(), |x, y| 0.05 * (x * x + y * y))
}

/// Selects one of two values by rank.
fn one_of<T>(is_odd: bool, odd: T, even: T) -> T {
    if is_odd { odd } else { even }
}

#[test]
fn inconsistent_bodies_are_reported() {
    let periodic = Boundary::Periodic;
    for odd in [
        Grid::new(40, 306, 0.5 * (1.0 + f64::EPSILON), 0.5),
        Grid::new(40, 306, 0.5, 0.6),
        Grid::new(41, 306, 0.5, 0.5),
        Grid::new(40, 300, 0.5, 0.5),
    ] {
        let odd = odd.unwrap();
        assert_reported("grid", |ranks, is_odd| {
            HalfSpace::distributed(one_of(is_odd, odd, grid()), pair(), periodic, ranks)
        });
    }
    let hard = Material::new(1.0, 0.3).unwrap().with_hardness(5.0).unwrap();
    for odd in [
        hard,
        Material::new(1.1, 0.3).unwrap(),
        Material::new(1.0, 0.31).unwrap(),
    ] {
        let odd = ElasticPair::new(odd, Material::rigid()).unwrap();
        assert_reported("pair of bodies", |ranks, is_odd| {
            HalfSpace::distributed(grid(), one_of(is_odd, odd, pair()), periodic, ranks)
        });
    }
    let along_y = |datum| Boundary::PeriodicAlongY { datum };
    for [odd, even] in [
        [periodic, Boundary::NonPeriodic],
        [along_y(500.0), along_y(501.0)],
    ] {
        assert_reported("boundary", |ranks, is_odd| {
            HalfSpace::distributed(grid(), pair(), one_of(is_odd, odd, even), ranks)
        });
    }
}

#[test]
fn inconsistent_surfaces_are_reported() {
    assert_reported("rough surface", |ranks, is_odd| {
        let rough = SelfAffine::with_rms_slope(0.1).seed(one_of(is_odd, 2, 1));
        rough.generate_on(&bodies(ranks))
    });
    // This input is rejected by a rank on its own.
    assert_reported("rough surface", |ranks, is_odd| {
        SelfAffine::with_rms_slope(one_of(is_odd, f64::NAN, 0.1)).generate_on(&bodies(ranks))
    });
    assert_reported("form", |ranks, is_odd| {
        let bodies = bodies(ranks);
        let form = one_of(is_odd, Form::Plane, Form::Mean);
        bodies.level(&ball(&bodies), form).map(drop)
    });
}

#[test]
fn inconsistent_normal_problems_are_reported() {
    let force = NormalLoad::Force(2.0);
    let build = |ranks, load, hardness: Option<f64>, settings| {
        let bodies = bodies(ranks);
        let mut builder = NormalProblem::builder(&bodies, ball(&bodies), load);
        if let Some(limit) = hardness {
            builder = builder.hardness(Hardness::uniform(limit)?);
        }
        builder.settings(settings).build()
    };
    let usual = Settings::default();
    for odd in [
        NormalLoad::Force(2.1),
        NormalLoad::Force(-0.0),
        NormalLoad::Approach(2.0),
    ] {
        assert_reported("normal load", |ranks, is_odd| {
            build(ranks, one_of(is_odd, odd, force), None, usual)
        });
        assert_reported("normal load", |ranks, is_odd| {
            let mut solver = build(ranks, force, None, usual)?.into_solver()?;
            solver.set_load(one_of(is_odd, odd, force))
        });
    }
    for odd in [None, Some(0.6)] {
        assert_reported("hardness", |ranks, is_odd| {
            build(ranks, force, one_of(is_odd, odd, Some(0.5)), usual)
        });
    }
    let mut odd = usual;
    odd.tolerance *= 0.5;
    assert_reported("settings", |ranks, is_odd| {
        build(ranks, force, None, one_of(is_odd, odd, usual))
    });
    assert_reported("settings", |ranks, is_odd| {
        let mut solver = build(ranks, force, None, usual)?.into_solver()?;
        solver.set_settings(one_of(is_odd, odd, usual))
    });
}

/// A rejected call changes nothing, and the ranks can continue together.
#[test]
fn ranks_continue_after_reported_inconsistency() {
    let alone = {
        let bodies = HalfSpace::new(grid(), pair()).unwrap();
        let problem = NormalProblem::builder(&bodies, ball(&bodies), NormalLoad::Force(2.0));
        kit::solve(problem).approach()
    };
    let found = outcomes(|ranks, is_odd| {
        let bodies = bodies(ranks);
        let load = NormalLoad::Force(2.0);
        let problem = NormalProblem::builder(&bodies, ball(&bodies), load).build()?;
        let mut solver = problem.into_solver()?;
        kit::assert_refused! { solver.set_load(NormalLoad::Force(one_of(is_odd, -1.0, 1.0))) => _ }
        let mut contact = solver.new_solution();
        solver.solve_into(&mut contact)?;
        Ok(contact.approach())
    });
    for approach in found {
        assert_eq!(approach.unwrap().to_bits(), alone.to_bits());
    }
}

#[test]
fn inconsistent_tangential_problems_are_reported() {
    let force = TangentialLoad::force([0.1, 0.0]);
    let build = |ranks, odd: &str| {
        let bodies = bodies(ranks);
        let normal = NormalProblem::builder(&bodies, ball(&bodies), NormalLoad::Force(2.0));
        let normal = normal.build()?.solve()?;
        let is = |name: &str| odd == name;
        let load = one_of(
            is("tangential load"),
            TangentialLoad::force([0.11, 0.0]),
            force,
        );
        let friction = kit::coulomb(one_of(is("friction"), 0.31, 0.3));
        let mut builder = TangentialProblem::builder(&bodies, &normal, friction, load);
        if is("relative displacement") {
            let none = RelativeDisplacement::bulk_strain(bodies.grid(), [[0.0; 2]; 2])?;
            builder = builder.relative_displacement(none);
        }
        let (scalar, vector) = (TangentialModel::Scalar, TangentialModel::Vector);
        builder
            .model(one_of(is("model"), vector, scalar))
            .coupling(one_of(
                is("coupling"),
                Coupling::Neglected,
                Coupling::OneWay,
            ))
            .tolerance(one_of(is("settings"), 1e-7, 1e-8))
            .build()
    };
    for name in [
        "tangential load",
        "friction",
        "relative displacement",
        "model",
        "coupling",
        "settings",
    ] {
        assert_reported(name, |ranks, is_odd| build(ranks, one_of(is_odd, name, "")));
    }
    assert_reported("tangential load", |ranks, is_odd| {
        let mut solver = build(ranks, "")?.into_solver()?;
        // The load is along the other axis, for which all ranks must compute an operator.
        solver.set_load(TangentialLoad::force(one_of(
            is_odd,
            [0.0, 0.1],
            [0.1, 0.0],
        )))
    });
    assert_reported("settings", |ranks, is_odd| {
        let mut solver = build(ranks, "")?.into_solver()?;
        let mut settings = *solver.settings();
        settings.max_iterations -= usize::from(is_odd);
        solver.set_settings(settings)
    });
}

#[test]
fn inconsistent_coupled_problems_are_reported() {
    let build = |ranks, odd: &str| {
        let bodies = bodies(ranks);
        let is = |name: &str| odd == name;
        let friction = kit::coulomb(one_of(is("friction"), 0.31, 0.3));
        let press = NormalLoad::Force(one_of(is("normal load"), 2.1, 2.0));
        let load = TangentialLoad::shift([one_of(is("tangential load"), 0.1, 0.0), 0.0]);
        let gap = ball(&bodies);
        let builder = CoupledProblem::builder(&bodies, &gap, friction, press, load);
        builder
            .tolerance(one_of(is("settings"), 1e-7, 1e-8))
            .build()
    };
    for name in ["friction", "normal load", "tangential load", "settings"] {
        assert_reported(name, |ranks, is_odd| build(ranks, one_of(is_odd, name, "")));
    }
    assert_reported("normal load", |ranks, is_odd| {
        let mut solver = build(ranks, "")?.into_solver()?;
        let still = TangentialLoad::shift([0.0, 0.0]);
        solver.set_loads(NormalLoad::Force(one_of(is_odd, 2.1, 2.0)), still)
    });
    assert_reported("tangential load", |ranks, is_odd| {
        let mut solver = build(ranks, "")?.into_solver()?;
        let moved = TangentialLoad::shift([one_of(is_odd, 0.1, 0.0), 0.0]);
        solver.set_loads(NormalLoad::Force(2.0), moved)
    });
}

/// If one rank skipped half of the solves or ended them early, the other ranks would wait for this rank.
#[test]
fn inconsistent_stiffnesses_are_reported() {
    for coupling in [Coupling::Neglected, Coupling::Full] {
        for is_tolerance in [true, false] {
            assert_reported("settings of the stiffness", |ranks, is_odd| {
                let bodies = bodies(ranks);
                let gap = ball(&bodies);
                let builder = History::builder(&bodies, &gap, kit::coulomb(0.3)).coupling(coupling);
                let mut history = builder.build()?;
                history.step(&LoadStep::hold().normal(NormalLoad::Force(2.0)))?;
                let tolerance = one_of(is_odd && is_tolerance, 1e-9, 1e-11);
                let workspace = StiffnessWorkspace::new().tolerance(tolerance)?;
                let mut workspace = workspace.reversal(!is_odd || is_tolerance);
                let found = history.stiffness_with(&mut workspace, |_| ControlFlow::Continue(()));
                found.map(drop)
            });
        }
    }
}

#[test]
fn inconsistent_histories_are_reported() {
    let build = |ranks, odd: &str| {
        let bodies = bodies(ranks);
        let gap = ball(&bodies);
        let is = |name: &str| odd == name;
        let friction = kit::coulomb(one_of(is("friction"), 0.31, 0.3));
        let mut builder = History::builder(&bodies, &gap, friction);
        if is("relative displacement") {
            let none = RelativeDisplacement::bulk_strain(bodies.grid(), [[0.0; 2]; 2])?;
            builder = builder.relative_displacement(none);
        }
        let (scalar, vector) = (TangentialModel::Scalar, TangentialModel::Vector);
        builder
            .axis(one_of(is("axis"), Axis::Y, Axis::X))
            .model(one_of(is("model"), vector, scalar))
            .coupling(one_of(
                is("coupling"),
                Coupling::Neglected,
                Coupling::OneWay,
            ))
            .entry_rule(one_of(
                is("entry rule"),
                EntryRule::WholeStep,
                EntryRule::SinceTouch,
            ))
            .hardness(Hardness::uniform(one_of(is("hardness"), 5.0, 4.0))?)
            .permanent_set(is("permanent set"))
            .tolerance(one_of(is("settings"), 1e-7, 1e-8))
            .build()
    };
    for name in [
        "friction",
        "axis",
        "model",
        "coupling",
        "entry rule",
        "hardness",
        "permanent set",
        "relative displacement",
        "settings",
    ] {
        assert_reported(name, |ranks, is_odd| build(ranks, one_of(is_odd, name, "")));
    }
    let press = |force| LoadStep::force([0.0, 0.0]).normal(NormalLoad::Force(force));
    assert_reported("load", |ranks, is_odd| {
        let mut history = build(ranks, "")?;
        history.step(&press(2.0))?;
        let before = history.to_bytes();
        let outcome = history.step(&press(one_of(is_odd, 2.1, 2.0))).map(drop);
        assert!(history.to_bytes() == before);
        outcome
    });
    assert_reported("load", |ranks, is_odd| {
        let load = LoadStep::hold().tangential(Axis::X, TangentialControl::Shift(0.1));
        build(ranks, "")?
            .step(&one_of(is_odd, LoadStep::hold(), load))
            .map(drop)
    });
    assert_reported("settings", |ranks, is_odd| {
        let mut history = build(ranks, "")?;
        let mut settings = *history.settings();
        settings.max_iterations -= usize::from(is_odd);
        history.set_settings(settings)
    });
    assert_reported("tolerance of adaptive steps", |ranks, is_odd| {
        let mut history = build(ranks, "")?;
        let mut steps = AdaptiveSteps::new(&history, one_of(is_odd, 0.1, 0.2))?;
        steps.step(&mut history, &press(2.0))
    });
    assert_reported("wear coefficient", |ranks, is_odd| {
        let bodies = bodies(ranks);
        let slip = Field::from_fn(bodies.grid(), |_, _| 1.0);
        wear::max_stable_cycles(&bodies, one_of(is_odd, 0.1, 0.2), &slip)
    });
}
