//! In repeated solves, a load that continues in the same direction starts from an extrapolation. An unchanged load is
//! not solved again.

use kit::{rough, unit_bodies};
use stickslip::{
    Axis, Error, Field, HalfSpace, History, LoadStep, NormalLoad, NormalProblem, NormalSolution,
    NormalSolver, TangentialControl, TangentialModel,
};

const FORCE: f64 = 0.2;

fn scenes() -> [(HalfSpace, Field, f64); 2] {
    let ball = kit::square(96, 4.0);
    let plain = kit::square(96, 1.0);
    [
        (unit_bodies(ball, 0.3), kit::sphere(ball, 10.0), FORCE),
        (unit_bodies(plain, 0.3), rough(plain, 3), 0.02),
    ]
}

fn history(bodies: &HalfSpace, gap: &Field) -> History {
    History::builder(bodies, gap, kit::coulomb(0.4))
        .tolerance(1e-6)
        .build()
        .unwrap()
}

/// Returns a solver after its first solve, and its solution.
fn solved(bodies: &HalfSpace, gap: &Field, load: NormalLoad) -> (NormalSolver, NormalSolution) {
    let problem = NormalProblem::builder(bodies, gap, load).tolerance(1e-6);
    let mut press = kit::solver(problem);
    let contact = kit::solved(&mut press);
    (press, contact)
}

fn step(normal: f64, tangential: f64) -> LoadStep {
    LoadStep::hold()
        .normal(NormalLoad::Force(normal))
        .tangential(Axis::X, TangentialControl::Force(tangential))
}

/// Six more steps of one per cent of the load cost less along the trend of the previous steps. The reference is the
/// cost if each step is the first step after a cold solve.
#[test]
fn continued_load_costs_less() {
    for (bodies, gap, force) in scenes() {
        let solver = |load| solved(&bodies, &gap, load);
        let approach = solver(NormalLoad::Force(force)).1.approach();
        for by_force in [true, false] {
            let load = |percent: u32| {
                let grown = 1.0 + 0.01 * f64::from(percent);
                if by_force {
                    NormalLoad::Force(force * grown)
                } else {
                    NormalLoad::Approach(approach * grown)
                }
            };
            let (mut press, mut contact) = solver(load(0));
            let [mut along, mut cold_products] = [0, 0];
            for percent in 1..8 {
                press.set_load(load(percent)).unwrap();
                press.solve_into(&mut contact).unwrap();
                // The first change of the load has no previous change to extrapolate from.
                if percent > 1 {
                    along += contact.report().products();
                    let (mut press, mut contact) = solver(load(percent - 1));
                    press.set_load(load(percent)).unwrap();
                    press.solve_into(&mut contact).unwrap();
                    cold_products += contact.report().products();
                }
            }
            assert!(
                10 * along < 9 * cold_products,
                "{along} products along the load, {cold_products} from a cold start"
            );
            // The solution belongs to its load, wherever the solver starts.
            let (_, cold) = solver(load(7));
            let difference = (contact.force() / cold.force() - 1.0).abs();
            assert!(difference < 1e-6, "{difference}");
            let largest = cold.pressure().max();
            let error = contact
                .pressure()
                .as_slice()
                .iter()
                .zip(cold.pressure().as_slice())
                .map(|(p, exact)| (p - exact).abs() / largest)
                .fold(0.0, f64::max);
            assert!(error < 1e-4, "{error}");
        }
    }
}

/// If the extrapolated contact outgrows its window, the solve restarts with few more products than a cold solve.
#[test]
fn contact_outgrowing_its_window_costs_as_much_as_cold_solve() {
    let grid = kit::square(192, 4.0);
    let bodies = unit_bodies(grid, 0.3);
    let [cone, ball] = [|r: f64| 0.1 * r, |r: f64| 0.05 * r * r]
        .map(|profile| Field::from_fn(grid, |x, y| profile(x.hypot(y))));
    for gap in [ball, cone] {
        let solver = |load| solved(&bodies, &gap, load);
        let (_, small) = solver(NormalLoad::Force(0.05));
        let (_, large) = solver(NormalLoad::Force(0.15));
        for load in [
            NormalLoad::Force(0.15),
            NormalLoad::Approach(large.approach()),
        ] {
            let first = match load {
                NormalLoad::Force(_) => NormalLoad::Force(0.05),
                _ => NormalLoad::Approach(small.approach()),
            };
            let (mut press, mut contact) = solver(first);
            press.set_load(load).unwrap();
            press.solve_into(&mut contact).unwrap();
            let (_, cold) = solver(load);
            let [again, cold_products] =
                [&contact, &cold].map(|contact| contact.report().products());
            assert!(
                again <= cold_products + 2,
                "{again} products, {cold_products} from a cold start"
            );
            assert!((contact.force() / cold.force() - 1.0).abs() < 1e-6);
        }
    }
}

/// A solve that unloads a large contact far starts like a first solve. Smaller changes start from the last pressure.
#[test]
fn far_unloading_of_large_contact_starts_like_a_first_solve() {
    let grid = kit::square(160, 2.2);
    let bodies = unit_bodies(grid, 0.3);
    let ball = kit::sphere(grid, 10.0);
    let solver = |load| solved(&bodies, &ball, load);
    let force = 4.0 / 30.0;
    let approach = |part: f64| solver(NormalLoad::Force(part * force)).1.approach();
    for (part, is_far) in [(0.3, true), (0.8, false)] {
        for [first, load] in [
            [force, part * force].map(NormalLoad::Force),
            [approach(1.0), approach(part)].map(NormalLoad::Approach),
        ] {
            let (mut press, mut contact) = solver(first);
            press.set_load(load).unwrap();
            press.solve_into(&mut contact).unwrap();
            let (_, cold) = solver(load);
            let is_same = contact.pressure() == cold.pressure();
            assert_eq!(is_same, is_far, "{load:?}");
            assert!((contact.force() / cold.force() - 1.0).abs() < 1e-6);
            if is_far {
                assert_eq!(contact.report().products(), cold.report().products());
            }
        }
    }
}

#[test]
fn pressure_under_same_load_is_not_solved_again() {
    for (bodies, gap, force) in scenes() {
        let mut history = history(&bodies, &gap);
        history.step(&step(force, 0.0)).unwrap();
        let pressed = history.pressure().clone();
        let work = |history: &History| {
            let report = history.last_step().unwrap().normal_report().unwrap();
            assert!(report.is_converged() && report.residual <= 1e-6);
            report.products()
        };
        for k in 1..4 {
            history
                .step(&step(force, 0.05 * f64::from(k) * force))
                .unwrap();
            assert_eq!(work(&history), 0);
            assert_eq!(history.pressure(), &pressed);
        }
        // A different gap gives a different contact. The first gap gives the first contact again.
        let mut worn = gap.clone();
        for (i, gap) in worn.as_mut_slice().iter_mut().enumerate() {
            *gap += 1e-4 * (i % 7) as f64;
        }
        history.set_gap(&worn).unwrap();
        history.set_gap(&gap).unwrap();
        history.step(&step(force, 0.1 * force)).unwrap();
        assert_eq!(work(&history), 0);
        history.set_gap(&worn).unwrap();
        history.step(&step(force, 0.1 * force)).unwrap();
        assert!(work(&history) > 0);
        // The known pressure is not accurate enough for a smaller tolerance.
        let finer = history.state().settings().tolerance(1e-10);
        history.set_settings(finer).unwrap();
        history.step(&step(force, 0.1 * force)).unwrap();
        assert!(work(&history) > 0);
    }
}

#[test]
fn failed_step_does_not_move_start() {
    for (bodies, gap, force) in scenes() {
        let path = [
            step(force, 0.0),
            step(1.02 * force, 0.05 * force),
            step(1.05 * force, 0.11 * force),
        ];
        let mut straight = history(&bodies, &gap);
        let mut stopped = history(&bodies, &gap);
        for load in &path {
            straight.step(load).unwrap();
            let before = stopped.to_bytes();
            let beyond = step(1.3 * force, force);
            kit::assert_refused! { stopped.step(&beyond) => Error::BeyondFrictionCapacity { .. } }
            assert_eq!(stopped.to_bytes(), before);
            stopped.step(load).unwrap();
            assert_eq!(stopped.to_bytes(), straight.to_bytes());
        }
        // Returning to a saved state does not move the start either.
        let kept = straight.state().clone();
        straight.step(&step(1.1 * force, 0.2 * force)).unwrap();
        straight.set_state(&kept).unwrap();
        let next = step(1.08 * force, 0.16 * force);
        straight.step(&next).unwrap();
        stopped.step(&next).unwrap();
        assert_eq!(stopped.to_bytes(), straight.to_bytes());
    }
}

/// A step that holds everything has no direction in which the next step could continue.
#[test]
fn continued_shear_costs_less_than_paused_shear() {
    for (bodies, gap, force) in scenes() {
        for model in [TangentialModel::Scalar, TangentialModel::Vector] {
            let builder = History::builder(&bodies, &gap, kit::coulomb(0.4));
            let mut history = builder.tolerance(1e-6).model(model).build().unwrap();
            let mut paused = history.clone();
            history.step(&step(force, 0.0)).unwrap();
            let [mut along, mut cold_products] = [0, 0];
            for part in [0.05, 0.1, 0.15, 0.2, 0.25] {
                let before = history.state().clone();
                let taken = history.step(&step(force, part * force)).unwrap();
                let cost = taken.tangential_report().unwrap().products();
                if part > 0.05 {
                    along += cost;
                    paused.set_state(&before).unwrap();
                    paused.step(&LoadStep::hold()).unwrap();
                    let taken = paused.step(&step(force, part * force)).unwrap();
                    cold_products += taken.tangential_report().unwrap().products();
                }
            }
            let saved = format!(
                "{model:?}: {along} products along the load, {cold_products} from a cold start"
            );
            assert!(along < cold_products, "{saved}");
        }
    }
}
