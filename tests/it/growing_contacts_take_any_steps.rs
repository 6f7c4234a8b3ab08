//! A contact that grows while it is sheared comes to the same tractions in any number of steps: along straight legs
//! exactly, round bends to second order. Lengths are radii of the ball over 1000; the grid is 64 long and wide.

use kit::Random;
use stickslip::history::{AdaptiveSteps, EntryRule};
use stickslip::tangential::JaegerSuperposition;
use stickslip::{
    Axis, Boundary, ElasticPair, Error, Field, Friction, Grid, HalfSpace, History, LoadStep,
    Material, NormalControl, NormalProblem, TangentialControl, TangentialModel, surface,
};

const FRICTION: f64 = 0.5;
/// Length of the grid, and in the campaign its cells.
const SIDE: f64 = 64.0;
/// Contact radius at the approach of one.
const RADIUS: f64 = 24.0;

/// A ball of an approach of one at that radius, or one with waves on it.
struct Scene {
    bodies: HalfSpace,
    gap: Field,
    friction: Friction,
    model: TangentialModel,
    /// Normal force at an approach of one.
    load: f64,
}

impl Scene {
    fn new(poisson_ratio: f64, roughness: f64, model: TangentialModel) -> Self {
        let grid = Grid::square(kit::thorough(40, 64), SIDE).unwrap();
        let material = Material::new(1.0, poisson_ratio).unwrap();
        let bodies = HalfSpace::new(grid, ElasticPair::new(material, material).unwrap()).unwrap();
        let ball = surface::sphere(grid, RADIUS * RADIUS).unwrap();
        let gap = rough(&ball, roughness);
        let load = 4.0 / 3.0 * bodies.pair().contact_modulus() * RADIUS;
        Self {
            bodies,
            gap,
            friction: Friction::coulomb(FRICTION).unwrap(),
            model,
            load,
        }
    }

    fn history(&self, rule: EntryRule) -> History {
        History::builder(&self.bodies, &self.gap, self.friction.clone())
            .model(self.model)
            .entry_rule(rule)
            .tolerance(1e-11)
            .build()
            .unwrap()
    }
}

/// With waves of up to a part of the height of the ball at the corner of the grid.
fn rough(ball: &Field, part: f64) -> Field {
    let (grid, mut random) = (ball.grid(), Random(3));
    let waves: Vec<[f64; 4]> = (0..24)
        .map(|_| {
            let [kx, ky] = [0, 1].map(|_| random.uniform(-0.3, 0.3));
            [kx, ky, random.uniform(0.0, 6.0), random.uniform(0.0, 1.0)]
        })
        .collect();
    let bumps = Field::from_fn(grid, |x, y| {
        let height = |[kx, ky, phase, height]: &[f64; 4]| height * (kx * x + ky * y + phase).cos();
        waves.iter().map(height).sum()
    });
    let scale = part * ball.max() / kit::max_abs(bumps.as_slice());
    let mut gap = ball.clone();
    for (gap, bump) in gap.as_mut_slice().iter_mut().zip(bumps.as_slice()) {
        *gap += scale * bump;
    }
    let least = gap.min();
    for gap in gap.as_mut_slice() {
        *gap -= least;
    }
    gap
}

/// Approach or normal force, and shift or tangential force, at the end of a leg.
type Leg = (f64, [f64; 2]);

/// Along the legs in equal steps, those that only press in one.
fn follow(history: &mut History, legs: &[Leg], steps: usize, load: impl Fn(Leg) -> LoadStep) {
    let (mut press, mut shear) = (0.0, [0.0; 2]);
    for &(next_press, next_shear) in legs {
        let steps = if next_shear == shear { 1 } else { steps };
        for step in 1..=steps {
            let part = step as f64 / steps as f64;
            let between = |a: f64, b: f64| a + part * (b - a);
            let shear = [0, 1].map(|axis| between(shear[axis], next_shear[axis]));
            let step = history
                .step(&load((between(press, next_press), shear)))
                .unwrap();
            let energy = step.energy();
            let scale = energy.work.abs() + energy.elastic_before + energy.elastic_after;
            assert!(energy.imbalance().abs() <= 1e-12 * scale, "{energy:?}");
        }
        (press, shear) = (next_press, next_shear);
    }
}

fn shifted((approach, shift): Leg) -> LoadStep {
    LoadStep::shift(shift).normal(NormalControl::Approach(approach))
}

fn forced((force, shear): Leg) -> LoadStep {
    LoadStep::force(shear).normal(NormalControl::Force(force))
}

/// Sum of the differences of the tractions over the sum of those of the second.
fn distance(a: &History, b: &History) -> f64 {
    let ([ax, ay], [bx, by]) = (a.traction(), b.traction());
    let cells = 0..ax.as_slice().len();
    let at = |field: &Field, i: usize| field.as_slice()[i];
    let difference = |i: usize| (at(ax, i) - at(bx, i)).hypot(at(ay, i) - at(by, i));
    let size = |i: usize| at(bx, i).hypot(at(by, i));
    cells.clone().map(difference).sum::<f64>() / cells.map(size).sum::<f64>()
}

/// Shear across and along in the vector model, along in the other.
fn turned(model: TangentialModel, legs: &[Leg]) -> Vec<Leg> {
    let turn = |&(press, [x, y]): &Leg| match model {
        TangentialModel::Vector => (press, [0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y]),
        _ => (press, [x, 0.0]),
    };
    legs.iter().map(turn).collect()
}

const MODELS: [TangentialModel; 2] = [TangentialModel::Scalar, TangentialModel::Vector];

/// Growth that would all stick, after a slip zone and without one.
const STRAIGHT: [&[Leg]; 2] = [
    &[(1.0, [0.28, 0.0])],
    &[(0.4, [0.0; 2]), (0.5, [0.2, 0.0]), (1.0, [0.35, 0.0])],
];

#[test]
fn straight_legs_take_one_step_under_shift_force_and_spring() {
    for model in MODELS {
        for &roughness in kit::thorough(&[0.15][..], &[0.0, 0.15]) {
            let scene = Scene::new(0.0, roughness, model);
            for legs in STRAIGHT {
                let legs = turned(model, legs);
                let (mut many, mut one) = (
                    scene.history(EntryRule::SinceTouch),
                    scene.history(EntryRule::SinceTouch),
                );
                follow(&mut many, &legs, kit::thorough(10, 40), shifted);
                follow(&mut one, &legs, 1, shifted);
                assert!(distance(&one, &many) < 1e-8);
                assert!(
                    (one.tangential_force()[0] / many.tangential_force()[0] - 1.0).abs() < 1e-9
                );

                // The same legs by springs whose ends go where the force and the shift ask for.
                let (stiffness, mut spring) =
                    (0.3 * scene.load, scene.history(EntryRule::SinceTouch));
                let mut guide = scene.history(EntryRule::SinceTouch);
                for leg in &legs {
                    guide.step(&shifted(*leg)).unwrap();
                    let end = [0, 1].map(|axis| {
                        guide.shift()[axis] + guide.tangential_force()[axis] / stiffness
                    });
                    let load = LoadStep::spring(end, stiffness);
                    spring
                        .step(&load.normal(NormalControl::Approach(leg.0)))
                        .unwrap();
                }
                assert!(distance(&spring, &many) < 1e-8);

                // By force along x and shift along y.
                if model == TangentialModel::Vector {
                    let mut mixed = scene.history(EntryRule::SinceTouch);
                    let mut guide = scene.history(EntryRule::SinceTouch);
                    for leg in &legs {
                        guide.step(&shifted(*leg)).unwrap();
                        let force = TangentialControl::Force(guide.tangential_force()[0]);
                        mixed
                            .step(&shifted(*leg).tangential(Axis::X, force))
                            .unwrap();
                    }
                    assert!(distance(&mixed, &many) < 1e-8);
                }
            }
            let legs = [(0.5, [0.0; 2]), (0.5, [0.15, 0.0]), (1.0, [0.3, 0.0])];
            let legs = turned(model, &legs).into_iter();
            let scaled = |(force, shear): Leg| (scene.load * force, shear.map(|f| scene.load * f));
            let legs: Vec<Leg> = legs.map(scaled).collect();
            let (mut many, mut one) = (
                scene.history(EntryRule::SinceTouch),
                scene.history(EntryRule::SinceTouch),
            );
            follow(&mut many, &legs, kit::thorough(10, 40), forced);
            follow(&mut one, &legs, 1, forced);
            assert!(distance(&one, &many) < 1e-8);
            assert!((one.shift()[0] / many.shift()[0] - 1.0).abs() < 1e-9);
        }
    }
}

/// Friction that differs from cell to cell, and a grid that repeats.
#[test]
fn straight_legs_take_one_step_on_any_grid_and_friction() {
    let mut scene = Scene::new(0.0, 0.15, TangentialModel::Vector);
    let grid = scene.gap.grid();
    let coefficient = Field::from_fn(grid, |x, y| 0.6 + 0.15 * (0.3 * x).sin() * (0.2 * y).cos());
    let uneven = Friction::per_cell(coefficient).unwrap();
    let repeating =
        HalfSpace::with_boundary(grid, *scene.bodies.pair(), Boundary::Periodic).unwrap();
    for (bodies, friction) in [
        (scene.bodies.clone(), uneven),
        (repeating, scene.friction.clone()),
    ] {
        (scene.bodies, scene.friction) = (bodies, friction);
        let legs: Vec<Leg> = [(0.3, [0.0; 2]), (0.3, [0.1, 0.0]), (0.6, [0.17, 0.05])]
            .map(|(force, shear)| (scene.load * force, shear.map(|f| scene.load * f)))
            .into();
        let (mut many, mut one) = (
            scene.history(EntryRule::SinceTouch),
            scene.history(EntryRule::SinceTouch),
        );
        follow(&mut many, &legs, kit::thorough(8, 24), forced);
        follow(&mut one, &legs, 1, forced);
        assert!(distance(&one, &many) < 1e-8);
        let mut old = scene.history(EntryRule::WholeStep);
        follow(&mut old, &legs, 1, forced);
        assert!(distance(&old, &many) > 0.05);
    }
}

/// Jaeger's superposition: to the tractions of the contact before come those in proportion to the growth of the
/// pressure, on any surface without Poisson's effect.
#[test]
fn growth_is_the_superposition_of_jaeger() {
    let scene = Scene::new(0.0, 0.15, TangentialModel::Scalar);
    let contact = |force: f64| {
        NormalProblem::builder(
            &scene.bodies,
            &scene.gap,
            NormalControl::Force(force * scene.load),
        )
        .tolerance(1e-11)
        .build()
        .unwrap()
        .solve()
        .unwrap()
    };
    let (before, after) = (contact(0.5), contact(0.9));
    let (force, stick) = (0.15, contact(0.5 - 0.15 / FRICTION));
    let sheared = JaegerSuperposition::new(&before, &stick, scene.bodies.pair(), FRICTION).unwrap();
    let ratio = 0.3;
    let legs = [
        (0.5, [0.0; 2]),
        (0.5, [force, 0.0]),
        (0.9, [force + ratio * 0.4, 0.0]),
    ]
    .map(|(press, shear)| (scene.load * press, shear.map(|f| scene.load * f)));
    let mut history = scene.history(EntryRule::SinceTouch);
    follow(&mut history, &legs, 1, forced);
    let grown = after
        .pressure()
        .as_slice()
        .iter()
        .zip(before.pressure().as_slice());
    let expected: Vec<f64> = sheared
        .traction()
        .as_slice()
        .iter()
        .zip(grown)
        .map(|(q, (after, before))| q + ratio * (after - before))
        .collect();
    let error = kit::max_difference(history.traction()[0].as_slice(), &expected);
    assert!(error < 1e-8 * kit::max_abs(&expected), "{error:e}");
    let kappa = 1.0;
    let shift = sheared.shift() + kappa * ratio * (after.approach() - before.approach());
    assert!((history.shift()[0] / shift - 1.0).abs() < 1e-8);
}

/// With Poisson's effect a long step has an error of some per cent, far less than that of the whole step; where all
/// slips from the moment it touches the two are the same.
#[test]
fn long_steps_err_far_less_than_whole_ones() {
    let paths: [&[Leg]; 5] = [
        &[(1.0, [0.224, 0.168])],
        &[(0.4, [0.0; 2]), (0.5, [0.2, 0.0]), (1.0, [0.35, 0.0])],
        &[(0.5, [0.0; 2]), (0.6, [0.15, 0.0]), (1.0, [0.2, 0.2])],
        &[(0.5, [0.0; 2]), (0.7, [0.3, 0.0])],
        &[
            (0.5, [0.0; 2]),
            (0.55, [0.2, 0.0]),
            (0.9, [-0.02, 0.0]),
            (0.6, [-0.1, 0.0]),
        ],
    ];
    for &roughness in kit::thorough(&[0.15][..], &[0.0, 0.15]) {
        let scene = Scene::new(0.3, roughness, TangentialModel::Vector);
        for (number, legs) in paths.iter().enumerate() {
            let mut many = scene.history(EntryRule::SinceTouch);
            follow(&mut many, legs, kit::thorough(12, 40), shifted);
            for steps in [1, 4] {
                let [with, without] = [EntryRule::SinceTouch, EntryRule::WholeStep].map(|rule| {
                    let mut few = scene.history(rule);
                    follow(&mut few, legs, steps, shifted);
                    distance(&few, &many)
                });
                assert!(
                    with <= 1.001 * without,
                    "path {number}: {with:e} {without:e}"
                );
                // Beyond the last straight leg the direction of slip decides.
                if number <= 2 {
                    let bound = if steps == 1 { 0.045 } else { 0.025 };
                    assert!(with < bound, "path {number}: {with:e}");
                    assert!(with < 0.25 * without, "path {number}: {with:e} {without:e}");
                }
            }
        }
    }
}

/// A shift in proportion to the square of the approach, and one that turns; with Poisson's effect nearly of second order.
#[test]
fn bent_paths_are_of_second_order() {
    let scenes = [(0.0, 0.0, 1.9), (0.3, 0.15, 1.6)];
    for (poisson_ratio, roughness, least) in scenes.into_iter().take(kit::thorough(1, 2)) {
        let scene = Scene::new(poisson_ratio, roughness, TangentialModel::Vector);
        bends_are_of_order(&scene, least);
    }
}

fn bends_are_of_order(scene: &Scene, least: f64) {
    let straight = |part: f64| 0.3 + 0.7 * part;
    let paths: [fn(f64) -> [f64; 2]; 2] = [
        |part| [0.25 * 0.7 * part * (0.3 + 0.7 * part), 0.0],
        |part| [0.15 * part, 0.1 * part * part],
    ];
    for path in paths {
        let taken = |rule: EntryRule, steps: usize| {
            let mut history = scene.history(rule);
            history.step(&shifted((straight(0.0), [0.0; 2]))).unwrap();
            for step in 1..=steps {
                let part = step as f64 / steps as f64;
                history
                    .step(&shifted((straight(part), path(part))))
                    .unwrap();
            }
            history
        };
        let unit = kit::thorough(1, 2);
        let exact = taken(EntryRule::SinceTouch, 64 * unit);
        let [coarse, fine] =
            [4, 16].map(|steps| distance(&taken(EntryRule::SinceTouch, unit * steps), &exact));
        let order = (coarse / fine).log2() / 2.0;
        assert!(order > least, "{order}: {coarse:e} {fine:e}");
        let [coarse, fine] =
            [2, 8].map(|steps| distance(&taken(EntryRule::WholeStep, unit * steps), &exact));
        assert!((coarse / fine).log2() / 2.0 < 1.2);
    }
}

/// A ball that turns while it is pressed, about its centre and about a point beside it.
#[test]
fn a_twist_grows_with_the_contact() {
    for poisson_ratio in [0.0, 0.3] {
        let scene = Scene::new(poisson_ratio, 0.0, TangentialModel::Vector);
        for shift in [[0.0; 2], [0.15, 0.0]] {
            let pressed = |rule: EntryRule, steps: usize| {
                let mut history = scene.history(rule);
                for step in 1..=steps {
                    let part = step as f64 / steps as f64;
                    let load = shifted((part, shift.map(|shift| part * shift)));
                    history.step(&load.twist(part * 0.15 / RADIUS)).unwrap();
                }
                history
            };
            let many = pressed(EntryRule::SinceTouch, 40);
            let [once, four] =
                [1, 4].map(|steps| distance(&pressed(EntryRule::SinceTouch, steps), &many));
            assert!(once < 0.13 && four < 0.45 * once, "{once:e} {four:e}");
            assert!(distance(&pressed(EntryRule::WholeStep, 1), &many) > 3.0 * once);
        }
    }
}

/// Material worn off evenly changes nothing but the approach: not how far new cells follow.
#[test]
fn even_wear_between_steps_changes_nothing() {
    let scene = Scene::new(0.0, 0.15, TangentialModel::Scalar);
    let legs = [(0.4, [0.1, 0.0]), (0.8, [0.22, 0.0])]
        .map(|(press, shear)| (scene.load * press, shear.map(|f| scene.load * f)));
    let mut plain = scene.history(EntryRule::SinceTouch);
    follow(&mut plain, &legs, 1, forced);
    let mut worn = scene.history(EntryRule::SinceTouch);
    worn.step(&forced(legs[0])).unwrap();
    let mut gap = scene.gap.clone();
    for gap in gap.as_mut_slice() {
        *gap += 0.25;
    }
    worn.set_gap(&gap).unwrap();
    worn.step(&forced(legs[1])).unwrap();
    assert!((worn.approach() - plain.approach() - 0.25).abs() < 1e-9);
    assert!(distance(&worn, &plain) < 1e-9);
}

/// What the steps dissipate comes to the same, by the tractions at their ends, and the rule spends no energy where
/// nothing slips.
#[test]
fn growth_that_sticks_dissipates_nothing() {
    let scene = Scene::new(0.0, 0.15, TangentialModel::Scalar);
    let dissipated = |rule: EntryRule, legs: &[Leg]| {
        let mut history = scene.history(rule);
        let (mut sum, mut work) = (0.0, 0.0);
        for leg in legs {
            let energy = *history.step(&shifted(*leg)).unwrap().energy();
            sum += energy.dissipated_energy;
            work += energy.work;
        }
        (sum, work)
    };
    let (lost, work) = dissipated(EntryRule::SinceTouch, &[(1.0, [0.28, 0.0])]);
    assert!(lost.abs() < 1e-9 * work);
    let (lost, work) = dissipated(EntryRule::WholeStep, &[(1.0, [0.28, 0.0])]);
    assert!(lost > 1e-2 * work);
    // All slip is that of the leg under a constant approach.
    let legs = [(0.5, [0.0; 2]), (0.5, [0.2, 0.0]), (1.0, [0.34, 0.0])];
    let (until, _) = dissipated(EntryRule::SinceTouch, &legs[..2]);
    let (all, _) = dissipated(EntryRule::SinceTouch, &legs);
    assert!(until > 0.0 && (all / until - 1.0).abs() < 1e-9);
}

#[test]
fn adaptive_steps_meet_their_tolerance() {
    let scene = Scene::new(0.0, 0.0, TangentialModel::Vector);
    let mut start = scene.history(EntryRule::SinceTouch);
    start.step(&shifted((0.5, [0.0; 2]))).unwrap();
    start.step(&shifted((0.5, [0.2, 0.0]))).unwrap();
    // The shift comes back while the contact grows, with slip.
    let load = shifted((0.7, [-0.05, 0.1]));
    let mut exact = start.clone();
    let mut finest = AdaptiveSteps::new(&start, kit::thorough(2e-4, 1e-4)).unwrap();
    let steps = finest.step(&mut exact, &load).unwrap();
    assert!(exact.steps() == 2 + steps as u64 && exact.shift() == [-0.05, 0.1]);
    let capacity = exact.friction_capacity();
    let size: f64 = [0, 1]
        .map(|axis| {
            exact.traction()[axis]
                .as_slice()
                .iter()
                .map(|q| q.abs())
                .sum::<f64>()
        })
        .iter()
        .sum();
    let mut most = 0;
    for &tolerance in kit::thorough(&[1e-2, 1e-3][..], &[1e-2, 3e-3, 1e-3]) {
        let mut history = start.clone();
        let mut steps = AdaptiveSteps::new(&history, tolerance).unwrap();
        let (mut seen, mut copy) = (Vec::new(), history.clone());
        let taken = steps
            .step_observed(&mut history, &load, |history| {
                seen.push(history.approach());
                copy = history.clone();
                // A copy goes on by itself from what is shown.
                copy.clone().step(&LoadStep::hold()).map(|_| ())
            })
            .unwrap();
        assert_eq!(copy.state().to_bytes(), history.state().to_bytes());
        assert!(seen.len() == taken && seen.is_sorted() && taken >= 2);
        let error = distance(&history, &exact) * size / capacity;
        assert!(error < 4.0 * tolerance, "{tolerance}: {error:e} in {taken}");
        most = most.max(taken);
    }

    // Larger cells have errors of their own, and take fewer steps.
    let expected = kit::thorough(15..40, 20..60);
    assert!(expected.contains(&most), "{most}");

    // A straight leg is one step, in two halves.
    let mut history = start.clone();
    let mut steps = AdaptiveSteps::new(&history, 1e-6).unwrap();
    let straight = shifted((1.0, [0.35, 0.0]));
    let before = history.state().to_bytes();
    let error = steps.error(&mut history, &straight).unwrap();
    assert!(error.traction < 1e-8 && error.dissipated_energy.abs() < 1e-8);
    assert_eq!(history.state().to_bytes(), before);
    assert_eq!(steps.step(&mut history, &straight).unwrap(), 2);
}

#[test]
fn adaptive_steps_fail_without_a_trace() {
    let scene = Scene::new(0.3, 0.0, TangentialModel::Scalar);
    let mut history = scene.history(EntryRule::SinceTouch);
    history.step(&shifted((0.5, [0.1, 0.0]))).unwrap();
    let before = history.state().to_bytes();
    let mut steps = AdaptiveSteps::new(&history, 1e-3).unwrap();
    let unbearable = LoadStep::force([10.0 * scene.load, 0.0]);
    let outcome = steps.step(&mut history, &unbearable);
    assert!(matches!(outcome, Err(Error::BeyondFrictionCapacity { .. })));
    assert_eq!(history.state().to_bytes(), before);
    // A tolerance that asks for more than the solves have.
    let mut hopeless = AdaptiveSteps::new(&history, 1e-15).unwrap();
    let outcome = hopeless.step(&mut history, &shifted((0.8, [-0.1, 0.0])));
    assert!(
        matches!(outcome, Err(Error::StepTooLong { .. })),
        "{outcome:?}"
    );
    assert_eq!(history.state().to_bytes(), before);
    let other = Grid::square(8, 1.0).unwrap();
    let bodies = HalfSpace::new(other, *scene.bodies.pair()).unwrap();
    let flat = Field::zeros(other);
    let mut other = History::builder(&bodies, &flat, scene.friction.clone())
        .build()
        .unwrap();
    let outcome = steps.step(&mut other, &LoadStep::hold());
    assert!(matches!(outcome, Err(Error::GridMismatch { .. })));
    for tolerance in [0.0, 1.0, -1.0, f64::NAN] {
        assert!(matches!(
            AdaptiveSteps::new(&history, tolerance),
            Err(Error::Tolerance(_))
        ));
    }
}
