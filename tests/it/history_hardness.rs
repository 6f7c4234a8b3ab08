//! In a history with a hardness, the pressure does not exceed the hardness. If permanent set is enabled, yielded
//! material keeps its shape.

use kit::{max_difference, rough, unit_bodies};
use stickslip::normal::Hardness;
use stickslip::{
    Coupling, ElasticPair, Error, Field, HalfSpace, History, LoadStep, Material, NormalLoad,
    NormalProblem, TangentialModel, Warning,
};

const LIMIT: f64 = 0.02;

fn rough_problem() -> (HalfSpace, Field) {
    let grid = kit::square(48, 1.0);
    (unit_bodies(grid, 0.3), rough(grid, 5))
}

fn new_history(bodies: &HalfSpace, gap: &Field, model: TangentialModel, stays: bool) -> History {
    let builder = History::builder(bodies, gap, kit::coulomb(0.4));
    let builder = builder.hardness(Hardness::uniform(LIMIT).unwrap());
    let builder = builder.permanent_set(stays).model(model);
    builder.tolerance(1e-10).build().unwrap()
}

fn press_step(force: f64) -> LoadStep {
    LoadStep::hold().normal(NormalLoad::Force(force))
}

#[test]
fn second_loading_is_elastic() {
    let (bodies, gap) = rough_problem();
    let mut stays = new_history(&bodies, &gap, TangentialModel::Scalar, true);
    let mut forgets = new_history(&bodies, &gap, TangentialModel::Scalar, false);
    for history in [&mut stays, &mut forgets] {
        history.step(&press_step(0.004)).unwrap();
        assert_eq!(history.pressure().max(), LIMIT);
        assert!(history.normal().yielded_cells() > 10);
    }
    assert_eq!(stays.pressure(), forgets.pressure());
    assert!(forgets.state().yielded().is_none());
    let yielded = stays.state().yielded().unwrap().clone();
    // The yielded surfaces fit together: the gap under load is zero in the cells that overlap without permanent set.
    assert!(forgets.normal().gap().min() < -1e-3 * stays.approach());
    assert!(stays.normal().gap().min() > -1e-9 * stays.approach());
    let worn = gap.as_slice().iter().zip(yielded.as_slice());
    let worn = Field::from_vec(gap.grid(), worn.map(|(a, b)| a + b).collect()).unwrap();
    assert_eq!(stays.state().unloaded_gap(), &worn);

    for force in [0.001, 0.0, 0.0039] {
        stays.step(&press_step(force)).unwrap();
        assert_eq!(stays.state().yielded(), Some(&yielded), "at {force}");
        let elastic = NormalProblem::builder(&bodies, &worn, NormalLoad::Force(force));
        let elastic = kit::solve(elastic.tolerance(1e-10));
        let (a, b) = (stays.pressure().as_slice(), elastic.pressure().as_slice());
        assert!(max_difference(a, b) < 1e-7 * LIMIT);
    }
    // Beyond the first load, yielding continues and no cell recovers.
    stays.step(&press_step(0.006)).unwrap();
    let further = stays.state().yielded().unwrap();
    assert!(further.integral() > 1.1 * yielded.integral());
    let grew = further.as_slice().iter().zip(yielded.as_slice());
    assert!(grew.into_iter().all(|(now, before)| now >= before));
}

#[test]
fn stiffness_of_yielded_solution_is_rejected() {
    let grid = kit::square(16, 4.0);
    let rubber = Material::new(1.0, 0.5).unwrap();
    let soft = Material::new(1.0, 0.1).unwrap();
    let ball = kit::sphere(grid, 10.0);
    let limit = Hardness::uniform(0.01).unwrap();
    let builder = |bodies: &HalfSpace, coupling| {
        let builder = History::builder(bodies, &ball, kit::coulomb(0.4));
        builder.hardness(limit.clone()).coupling(coupling).build()
    };
    let pair = ElasticPair::new(soft, Material::rigid()).unwrap();
    let coupled = HalfSpace::new(grid, pair).unwrap();
    for coupling in [Coupling::OneWay, Coupling::Full] {
        let mut yields = builder(&coupled, coupling).unwrap();
        yields.step(&press_step(0.05)).unwrap();
        assert_eq!(yields.pressure().max(), 0.01);
    }
    // The solution does not record which cells have yielded, but the history records it.
    let (bodies, gap) = rough_problem();
    let mut yields = new_history(&bodies, &gap, TangentialModel::Scalar, false);
    yields.step(&press_step(0.004)).unwrap();
    kit::assert_refused! { yields.normal().stiffness(&bodies) => Error::Yielded { cells, .. } if cells > 10 }
    assert!(yields.stiffness().is_ok());

    // Without a limit, the hardness stated by a material only causes a warning.
    let stated = rubber.with_hardness(0.01).unwrap();
    let pair = ElasticPair::new(stated, Material::rigid()).unwrap();
    assert_eq!((pair.hardness(), rubber.hardness()), (0.01, f64::INFINITY));
    let bodies = HalfSpace::new(grid, pair).unwrap();
    let problem = |force| {
        let problem = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(force));
        kit::solve(problem)
    };
    let warns = |warnings: Vec<Warning>| {
        warnings
            .iter()
            .any(|w| matches!(w, Warning::BeyondHardness { cells } if *cells > 0))
    };
    assert!(!warns(problem(1e-5).warnings()) && warns(problem(0.05).warnings()));
    let builder = History::builder(&bodies, &ball, kit::coulomb(0.4));
    let mut history = builder.build().unwrap();
    assert!(warns(history.step(&press_step(0.05)).unwrap().warnings()));
    let bytes = history.to_bytes();
    assert_eq!(
        History::from_bytes(&bodies, &bytes).unwrap().to_bytes(),
        bytes
    );
    assert!(rubber.with_hardness(-1.0).is_err() && rubber.with_hardness(f64::NAN).is_err());
}

/// In a coupled contact, surfaces overlap only in cells at the hardness. The solution for weak coupling agrees with
/// one-way coupling.
#[test]
fn coupled_contact_yields_at_the_hardness() {
    let grid = kit::square(32, 4.0);
    let ball = kit::sphere(grid, 10.0);
    let hardness = Field::from_fn(grid, |x, _| 0.03 + 0.004 * x);
    let limit = Hardness::per_cell(hardness.clone()).unwrap();
    let load =
        |force: f64, shear: [f64; 2]| LoadStep::force(shear).normal(NormalLoad::Force(force));
    let sheared = |poisson_ratio: f64, coupling: Coupling| {
        let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, poisson_ratio)).unwrap();
        let builder = History::builder(&bodies, &ball, kit::coulomb(0.5));
        let builder = builder.model(TangentialModel::Vector).coupling(coupling);
        let mut history = builder.hardness(limit.clone()).build().unwrap();
        for (force, shear) in [(0.05, [0.0; 2]), (0.09, [0.02, 0.01]), (0.06, [0.0, 0.015])] {
            history.step(&load(force, shear)).unwrap();
            let energy = history.last_step().unwrap().energy();
            assert!(energy.imbalance().abs() < 1e-12 * energy.elastic_after);
            let normal = history.normal();
            let (mut yielded, mut largest) = (0, 0.0_f64);
            for i in 0..grid.cells() {
                let [p, g, most] =
                    [normal.pressure(), normal.gap(), &hardness].map(|field| field.as_slice()[i]);
                largest = largest.max(g.abs());
                assert!((0.0..=most).contains(&p));
                yielded += usize::from(p == most);
                assert!(
                    p == 0.0 || g.abs() < 1e-9 || (p == most && g < 0.0),
                    "{p} {g}"
                );
                assert!(p > 0.0 || g > -1e-9);
            }
            assert!(yielded > 20 && normal.yielded_cells() == yielded && largest > 1e-3);
        }
        history
    };
    sheared(0.0, Coupling::Full);
    let [full, one_way] = [Coupling::Full, Coupling::OneWay].map(|c| sheared(0.49, c));
    let beta = full.normal().pair().dundurs_beta();
    assert!(beta > 0.005 && full.normal().yielded_cells() > 20);
    let difference = full.pressure().minus(one_way.pressure()).unwrap();
    assert!(difference.max().max(-difference.min()) < 2.0 * beta * full.pressure().max());
    assert!((full.shift()[1] / one_way.shift()[1] - 1.0).abs() < beta);
}

/// A load beyond the capacity of the last window at the hardness requires a wider window.
#[test]
fn load_beyond_capacity_of_last_window_is_carried() {
    let grid = kit::square(64, 4.0);
    let ball = kit::sphere(grid, 10.0);
    let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, 0.1)).unwrap();
    for coupling in [Coupling::Neglected, Coupling::Full] {
        let builder = History::builder(&bodies, &ball, kit::coulomb(0.2));
        let builder = builder.hardness(Hardness::uniform(0.02).unwrap());
        let mut history = builder.coupling(coupling).build().unwrap();
        for force in [0.05, 0.09, 0.12, 0.3] {
            history.step(&press_step(force)).unwrap();
            assert!((history.normal().force() / force - 1.0).abs() < 1e-9);
            assert!(history.pressure().max() <= 0.02);
        }
    }
}

/// Histories of the same bodies share buffers. The content left by one history must not affect another history.
#[test]
fn histories_with_shared_buffers_are_independent() {
    let grid = kit::square(24, 4.0);
    let ball = kit::sphere(grid, 10.0);
    let bodies = HalfSpace::new(grid, kit::on_rigid(1.0, 0.1)).unwrap();
    let new = |coupling: Coupling, hardness: Option<f64>| {
        let builder = History::builder(&bodies, &ball, kit::coulomb(0.3));
        let builder = builder.coupling(coupling);
        match hardness {
            Some(limit) => builder.hardness(Hardness::uniform(limit).unwrap()).build(),
            None => builder.build(),
        }
        .unwrap()
    };
    let mut yields = new(Coupling::Full, Some(0.02));
    let (mut full, mut one_way) = (new(Coupling::Full, None), new(Coupling::OneWay, None));
    for force in [0.02, 0.05, 0.08] {
        for history in [&mut yields, &mut full, &mut one_way] {
            history.step(&press_step(force)).unwrap();
        }
        assert!(yields.normal().yielded_cells() > 0);
        assert_eq!(full.normal().yielded_cells(), 0);
        assert!(one_way.stiffness().is_ok() && one_way.normal().stiffness(&bodies).is_ok());
        assert!(full.normal().stiffness(&bodies).is_err());
    }
}

/// A program that sets the gap that it reads does not add the plastic depth twice.
#[test]
fn gap_as_set_excludes_plastic_depth() {
    let (bodies, gap) = rough_problem();
    let mut history = new_history(&bodies, &gap, TangentialModel::Scalar, true);
    assert_eq!(&history.gap_as_set().unwrap(), &gap);
    for force in [0.004, 0.006] {
        history.step(&press_step(force)).unwrap();
        let set = history.gap_as_set().unwrap();
        assert!(max_difference(set.as_slice(), gap.as_slice()) < 1e-15);
        let depth = history.state().yielded().unwrap().max();
        assert!(depth > 1e-6);
        let (before, bytes) = (history.unloaded_gap().clone(), history.to_bytes());
        history.set_gap(&set).unwrap();
        assert!(max_difference(history.unloaded_gap().as_slice(), before.as_slice()) < 1e-15);
        // A gap with the depth would add the depth again.
        assert!(history.set_gap(&before).is_err());
        history = History::from_bytes(&bodies, &bytes).unwrap();
    }
    let forgets = new_history(&bodies, &gap, TangentialModel::Scalar, false);
    assert_eq!(&forgets.gap_as_set().unwrap(), &gap);

    let worn = rough(bodies.grid(), 6);
    let load = NormalLoad::Force(0.004);
    let mut solver = kit::solver(NormalProblem::builder(&bodies, &gap, load));
    assert_eq!(solver.gap(), &gap);
    let contact = kit::solved(&mut solver);
    assert_ne!(contact.gap(), &gap);
    solver.set_gap(&worn).unwrap();
    assert_eq!(solver.gap(), &worn);
}

/// The history adds the permanent set to each gap that is set, so that a gap with the set would contain it twice.
#[test]
fn gap_that_contains_the_permanent_set_is_rejected() {
    let (bodies, gap) = rough_problem();
    let mut history = new_history(&bodies, &gap, TangentialModel::Scalar, true);
    history.set_gap(&history.unloaded_gap().clone()).unwrap();
    history.step(&press_step(0.004)).unwrap();
    let set = history.state().yielded().unwrap().clone();
    assert!(set.max() > 0.0);
    let as_set = history.gap_as_set().unwrap();
    for depth in [0.0, 1e-9, 0.05] {
        let wear = |gap: &Field| {
            let mut worn = gap.clone();
            worn.add_scaled(depth, &set).unwrap();
            worn
        };
        let before = history.state().clone();
        let refused = history.set_gap(&wear(history.unloaded_gap()));
        kit::assert_refused! { refused => Error::UnsupportedByModel { .. } }
        assert!(*history.state() == before);
        history.set_gap(&wear(&as_set)).unwrap();
        history.set_gap(&as_set).unwrap();
    }
    // Wear that is deeper than the set.
    let mut worn = as_set;
    worn.add_scaled(1.5, &set).unwrap();
    history.set_gap(&worn).unwrap();
}
