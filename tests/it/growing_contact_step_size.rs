//! A contact that grows under shear reaches the same tractions for any number of steps. The agreement is exact along
//! straight load paths, and of second order along curved paths. The unit of length is the radius of the ball divided
//! by 1000. The grid is 64 long and wide.

use kit::Random;
use stickslip::history::{AdaptiveSteps, EntryRule};
use stickslip::tangential::JaegerSuperposition;
use stickslip::{
    Axis, Boundary, Error, Field, Friction, HalfSpace, History, LoadStep, NormalLoad,
    NormalProblem, TangentialControl, TangentialModel,
};

const FRICTION: f64 = 0.5;
/// Side length of the grid. In the campaign it is also the number of cells along a side.
const SIDE: f64 = 64.0;
/// Contact radius at an approach of one.
const RADIUS: f64 = 24.0;

/// A ball with contact radius [`RADIUS`] at an approach of one, smooth or with waves.
struct GrowingCase {
    bodies: HalfSpace,
    gap: Field,
    friction: Friction,
    model: TangentialModel,
    /// Normal force at an approach of one.
    load: f64,
}

impl GrowingCase {
    fn new(poisson_ratio: f64, roughness: f64, model: TangentialModel) -> Self {
        let grid = kit::square(kit::thorough(40, 64), SIDE);
        let bodies = HalfSpace::new(grid, kit::alike(1.0, poisson_ratio)).unwrap();
        let ball = kit::sphere(grid, RADIUS * RADIUS);
        let gap = with_waves(&ball, roughness);
        let load = 4.0 / 3.0 * bodies.pair().contact_modulus() * RADIUS;
        Self {
            bodies,
            gap,
            friction: kit::coulomb(FRICTION),
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

/// Adds waves of up to the fraction `part` of the height of the ball at the corner of the grid.
fn with_waves(ball: &Field, part: f64) -> Field {
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

/// Approach or normal force, and shift or tangential force, at the end of a leg of the path.
type Leg = (f64, [f64; 2]);

/// Follows the legs of a load path in equal steps. A leg that only presses is a single step.
fn follow_legs(history: &mut History, legs: &[Leg], steps: usize, load: impl Fn(Leg) -> LoadStep) {
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

fn shift_step((approach, shift): Leg) -> LoadStep {
    LoadStep::shift(shift).normal(NormalLoad::Approach(approach))
}

fn force_step((force, shear): Leg) -> LoadStep {
    LoadStep::force(shear).normal(NormalLoad::Force(force))
}

/// Returns the sum of the differences of the tractions, relative to the sum of the second tractions.
fn traction_difference(a: &History, b: &History) -> f64 {
    let ([ax, ay], [bx, by]) = (a.traction(), b.traction());
    let cells = 0..ax.as_slice().len();
    let at = |field: &Field, i: usize| field.as_slice()[i];
    let difference = |i: usize| (at(ax, i) - at(bx, i)).hypot(at(ay, i) - at(by, i));
    let size = |i: usize| at(bx, i).hypot(at(by, i));
    cells.clone().map(difference).sum::<f64>() / cells.map(size).sum::<f64>()
}

/// Rotates the shear in the vector model, and projects it onto the x axis in the scalar model.
fn rotate_legs(model: TangentialModel, legs: &[Leg]) -> Vec<Leg> {
    let turn = |&(press, [x, y]): &Leg| match model {
        TangentialModel::Vector => (press, [0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y]),
        _ => (press, [x, 0.0]),
    };
    legs.iter().map(turn).collect()
}

const MODELS: [TangentialModel; 2] = [TangentialModel::Scalar, TangentialModel::Vector];

/// Covers growing contacts in which all cells stick, with and without a prior slip zone.
const STRAIGHT: [&[Leg]; 2] = [
    &[(1.0, [0.28, 0.0])],
    &[(0.4, [0.0; 2]), (0.5, [0.2, 0.0]), (1.0, [0.35, 0.0])],
];

#[test]
fn straight_path_in_one_step_is_exact_under_any_control() {
    for model in MODELS {
        for &roughness in kit::thorough(&[0.15][..], &[0.0, 0.15]) {
            let scene = GrowingCase::new(0.0, roughness, model);
            for legs in STRAIGHT {
                let legs = rotate_legs(model, legs);
                let (mut many, mut one) = (
                    scene.history(EntryRule::SinceTouch),
                    scene.history(EntryRule::SinceTouch),
                );
                follow_legs(&mut many, &legs, kit::thorough(10, 40), shift_step);
                follow_legs(&mut one, &legs, 1, shift_step);
                assert!(traction_difference(&one, &many) < 1e-8);
                assert!(
                    (one.tangential_force()[0] / many.tangential_force()[0] - 1.0).abs() < 1e-9
                );

                // Springs follow the same legs. The positions of the far ends of the springs are computed from the
                // force and the shift.
                let (stiffness, mut spring) =
                    (0.3 * scene.load, scene.history(EntryRule::SinceTouch));
                let mut guide = scene.history(EntryRule::SinceTouch);
                for leg in &legs {
                    guide.step(&shift_step(*leg)).unwrap();
                    let end = [0, 1].map(|axis| {
                        guide.shift()[axis] + guide.tangential_force()[axis] / stiffness
                    });
                    let load = LoadStep::spring(end, stiffness);
                    spring
                        .step(&load.normal(NormalLoad::Approach(leg.0)))
                        .unwrap();
                }
                assert!(traction_difference(&spring, &many) < 1e-8);

                // The force along x and the shift along y are prescribed.
                if model == TangentialModel::Vector {
                    let mut mixed = scene.history(EntryRule::SinceTouch);
                    let mut guide = scene.history(EntryRule::SinceTouch);
                    for leg in &legs {
                        guide.step(&shift_step(*leg)).unwrap();
                        let force = TangentialControl::Force(guide.tangential_force()[0]);
                        mixed
                            .step(&shift_step(*leg).tangential(Axis::X, force))
                            .unwrap();
                    }
                    assert!(traction_difference(&mixed, &many) < 1e-8);
                }
            }
            let legs = [(0.5, [0.0; 2]), (0.5, [0.15, 0.0]), (1.0, [0.3, 0.0])];
            let legs = rotate_legs(model, &legs).into_iter();
            let scaled = |(force, shear): Leg| (scene.load * force, shear.map(|f| scene.load * f));
            let legs: Vec<Leg> = legs.map(scaled).collect();
            let (mut many, mut one) = (
                scene.history(EntryRule::SinceTouch),
                scene.history(EntryRule::SinceTouch),
            );
            follow_legs(&mut many, &legs, kit::thorough(10, 40), force_step);
            follow_legs(&mut one, &legs, 1, force_step);
            assert!(traction_difference(&one, &many) < 1e-8);
            assert!((one.shift()[0] / many.shift()[0] - 1.0).abs() < 1e-9);
        }
    }
}

/// Covers friction that varies between cells, and a periodic grid.
#[test]
fn straight_path_in_one_step_is_exact_on_any_grid_and_friction() {
    let mut scene = GrowingCase::new(0.0, 0.15, TangentialModel::Vector);
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
        follow_legs(&mut many, &legs, kit::thorough(8, 24), force_step);
        follow_legs(&mut one, &legs, 1, force_step);
        assert!(traction_difference(&one, &many) < 1e-8);
        let mut old = scene.history(EntryRule::WholeStep);
        follow_legs(&mut old, &legs, 1, force_step);
        assert!(traction_difference(&old, &many) > 0.05);
    }
}

/// Jaeger's superposition gives the tractions of the initial contact, plus tractions proportional to the growth of the
/// pressure. The superposition is valid for any surface if Poisson's ratio is zero.
#[test]
fn growing_contact_matches_jaeger_superposition() {
    let scene = GrowingCase::new(0.0, 0.15, TangentialModel::Scalar);
    let contact = |force: f64| {
        kit::solve(
            NormalProblem::builder(
                &scene.bodies,
                &scene.gap,
                NormalLoad::Force(force * scene.load),
            )
            .tolerance(1e-11),
        )
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
    follow_legs(&mut history, &legs, 1, force_step);
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

/// For a nonzero Poisson's ratio, one long step has an error of less than 4.5 % on the first three paths. This error is
/// less than a quarter of the error under the rule [`EntryRule::WholeStep`]. If every cell slips from first contact,
/// both rules give the same result.
#[test]
fn long_steps_with_growth_rule_are_accurate() {
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
        let scene = GrowingCase::new(0.3, roughness, TangentialModel::Vector);
        for (number, legs) in paths.iter().enumerate() {
            let mut many = scene.history(EntryRule::SinceTouch);
            follow_legs(&mut many, legs, kit::thorough(12, 40), shift_step);
            for steps in [1, 4] {
                let [with, without] = [EntryRule::SinceTouch, EntryRule::WholeStep].map(|rule| {
                    let mut few = scene.history(rule);
                    follow_legs(&mut few, legs, steps, shift_step);
                    traction_difference(&few, &many)
                });
                assert!(
                    with <= 1.001 * without,
                    "path {number}: {with:e} {without:e}"
                );
                // After the last straight leg, the direction of slip dominates the error.
                if number <= 2 {
                    let bound = if steps == 1 { 0.045 } else { 0.025 };
                    assert!(with < bound, "path {number}: {with:e}");
                    assert!(with < 0.25 * without, "path {number}: {with:e} {without:e}");
                }
            }
        }
    }
}

/// Covers a shift in proportion to the square of the approach, and a shift that changes direction. For a nonzero
/// Poisson's ratio the convergence is nearly of second order.
#[test]
fn curved_paths_converge_with_second_order() {
    let scenes = [(0.0, 0.0, 1.9), (0.3, 0.15, 1.6)];
    for (poisson_ratio, roughness, least) in scenes.into_iter().take(kit::thorough(1, 2)) {
        let scene = GrowingCase::new(poisson_ratio, roughness, TangentialModel::Vector);
        assert_order_on_curved_paths(&scene, least);
    }
}

fn assert_order_on_curved_paths(scene: &GrowingCase, least: f64) {
    let straight = |part: f64| 0.3 + 0.7 * part;
    let paths: [fn(f64) -> [f64; 2]; 2] = [
        |part| [0.25 * 0.7 * part * (0.3 + 0.7 * part), 0.0],
        |part| [0.15 * part, 0.1 * part * part],
    ];
    for path in paths {
        let taken = |rule: EntryRule, steps: usize| {
            let mut history = scene.history(rule);
            history
                .step(&shift_step((straight(0.0), [0.0; 2])))
                .unwrap();
            for step in 1..=steps {
                let part = step as f64 / steps as f64;
                history
                    .step(&shift_step((straight(part), path(part))))
                    .unwrap();
            }
            history
        };
        let unit = kit::thorough(1, 2);
        let exact = taken(EntryRule::SinceTouch, 64 * unit);
        let [coarse, fine] = [4, 16]
            .map(|steps| traction_difference(&taken(EntryRule::SinceTouch, unit * steps), &exact));
        let order = (coarse / fine).log2() / 2.0;
        assert!(order > least, "{order}: {coarse:e} {fine:e}");
        let [coarse, fine] = [2, 8]
            .map(|steps| traction_difference(&taken(EntryRule::WholeStep, unit * steps), &exact));
        assert!((coarse / fine).log2() / 2.0 < 1.2);
    }
}

/// The ball is pressed and twisted simultaneously, about its centre and about an eccentric point.
#[test]
fn twist_in_a_growing_contact_is_accurate() {
    for poisson_ratio in [0.0, 0.3] {
        let scene = GrowingCase::new(poisson_ratio, 0.0, TangentialModel::Vector);
        for shift in [[0.0; 2], [0.15, 0.0]] {
            let pressed = |rule: EntryRule, steps: usize| {
                let mut history = scene.history(rule);
                for step in 1..=steps {
                    let part = step as f64 / steps as f64;
                    let load = shift_step((part, shift.map(|shift| part * shift)));
                    history.step(&load.twist(part * 0.15 / RADIUS)).unwrap();
                }
                history
            };
            let many = pressed(EntryRule::SinceTouch, 40);
            let [once, four] = [1, 4]
                .map(|steps| traction_difference(&pressed(EntryRule::SinceTouch, steps), &many));
            assert!(once < 0.13 && four < 0.45 * once, "{once:e} {four:e}");
            assert!(traction_difference(&pressed(EntryRule::WholeStep, 1), &many) > 3.0 * once);
        }
    }
}

/// Uniform wear changes only the approach, and not the motion that new cells follow.
#[test]
fn uniform_wear_between_steps_changes_only_the_approach() {
    let scene = GrowingCase::new(0.0, 0.15, TangentialModel::Scalar);
    let legs = [(0.4, [0.1, 0.0]), (0.8, [0.22, 0.0])]
        .map(|(press, shear)| (scene.load * press, shear.map(|f| scene.load * f)));
    let mut plain = scene.history(EntryRule::SinceTouch);
    follow_legs(&mut plain, &legs, 1, force_step);
    let mut worn = scene.history(EntryRule::SinceTouch);
    worn.step(&force_step(legs[0])).unwrap();
    let mut gap = scene.gap.clone();
    for gap in gap.as_mut_slice() {
        *gap += 0.25;
    }
    worn.set_gap(&gap).unwrap();
    worn.step(&force_step(legs[1])).unwrap();
    assert!((worn.approach() - plain.approach() - 0.25).abs() < 1e-9);
    assert!(traction_difference(&worn, &plain) < 1e-9);
}

/// The dissipation by the tractions at the ends of the steps does not depend on the number of steps. Under the entry
/// rule no energy is dissipated without slip.
#[test]
fn growing_contact_that_sticks_dissipates_nothing() {
    let scene = GrowingCase::new(0.0, 0.15, TangentialModel::Scalar);
    let dissipated = |rule: EntryRule, legs: &[Leg]| {
        let mut history = scene.history(rule);
        let (mut sum, mut work) = (0.0, 0.0);
        for leg in legs {
            let energy = *history.step(&shift_step(*leg)).unwrap().energy();
            sum += energy.dissipated_energy;
            work += energy.work;
        }
        (sum, work)
    };
    let (lost, work) = dissipated(EntryRule::SinceTouch, &[(1.0, [0.28, 0.0])]);
    assert!(lost.abs() < 1e-9 * work);
    let (lost, work) = dissipated(EntryRule::WholeStep, &[(1.0, [0.28, 0.0])]);
    assert!(lost > 1e-2 * work);
    // All slip occurs during the leg at constant approach.
    let legs = [(0.5, [0.0; 2]), (0.5, [0.2, 0.0]), (1.0, [0.34, 0.0])];
    let (until, _) = dissipated(EntryRule::SinceTouch, &legs[..2]);
    let (all, _) = dissipated(EntryRule::SinceTouch, &legs);
    assert!(until > 0.0 && (all / until - 1.0).abs() < 1e-9);
}

#[test]
fn adaptive_steps_meet_their_tolerance() {
    let scene = GrowingCase::new(0.0, 0.0, TangentialModel::Vector);
    let mut start = scene.history(EntryRule::SinceTouch);
    start.step(&shift_step((0.5, [0.0; 2]))).unwrap();
    start.step(&shift_step((0.5, [0.2, 0.0]))).unwrap();
    // The shift reverses while the contact grows and slips.
    let load = shift_step((0.7, [-0.05, 0.1]));
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
                // A copy of the reported history can continue independently.
                copy.clone().step(&LoadStep::hold()).map(|_| ())
            })
            .unwrap();
        assert_eq!(copy.state().to_bytes(), history.state().to_bytes());
        assert!(seen.len() == taken && seen.is_sorted() && taken >= 2);
        let error = traction_difference(&history, &exact) * size / capacity;
        assert!(error < 4.0 * tolerance, "{tolerance}: {error:e} in {taken}");
        most = most.max(taken);
    }

    // Coarser grids have larger discretisation errors and take fewer steps.
    let expected = kit::thorough(15..40, 20..60);
    assert!(expected.contains(&most), "{most}");

    // A straight leg is a single step, which is taken in two halves.
    let mut history = start.clone();
    let mut steps = AdaptiveSteps::new(&history, 1e-6).unwrap();
    let straight = shift_step((1.0, [0.35, 0.0]));
    let before = history.state().to_bytes();
    let error = steps.error(&mut history, &straight).unwrap();
    assert!(error.traction < 1e-8 && error.dissipated_energy.abs() < 1e-8);
    assert_eq!(history.state().to_bytes(), before);
    assert_eq!(steps.step(&mut history, &straight).unwrap(), 2);
}

#[test]
fn adaptive_steps_that_fail_leave_state_unchanged() {
    let scene = GrowingCase::new(0.3, 0.0, TangentialModel::Scalar);
    let mut history = scene.history(EntryRule::SinceTouch);
    history.step(&shift_step((0.5, [0.1, 0.0]))).unwrap();
    let before = history.state().to_bytes();
    let mut steps = AdaptiveSteps::new(&history, 1e-3).unwrap();
    let unbearable = LoadStep::force([10.0 * scene.load, 0.0]);
    kit::assert_refused! { steps.step(&mut history, &unbearable) => Error::BeyondFrictionCapacity { .. } }
    assert_eq!(history.state().to_bytes(), before);
    // The tolerance is smaller than the accuracy of the solves.
    let mut hopeless = AdaptiveSteps::new(&history, 1e-15).unwrap();
    kit::assert_refused! { hopeless.step(&mut history, &shift_step((0.8, [-0.1, 0.0]))) => Error::StepTooLong { .. } }
    assert_eq!(history.state().to_bytes(), before);
    let other = kit::square(8, 1.0);
    let bodies = HalfSpace::new(other, *scene.bodies.pair()).unwrap();
    let flat = Field::zeros(other);
    let mut other = History::builder(&bodies, &flat, scene.friction.clone())
        .build()
        .unwrap();
    kit::assert_refused! { steps.step(&mut other, &LoadStep::hold()) => Error::GridMismatch { .. } }
    for tolerance in [0.0, 1.0, -1.0, f64::NAN] {
        kit::assert_refused! { AdaptiveSteps::new(&history, tolerance) => Error::Tolerance(_) }
    }
}
