//! A machine that drags a body by a spring exerts the force k (X - delta) for any stiffness. The contact is the same as
//! under the equivalent force or shift.

use kit::{max_difference, unit_bodies};
use stickslip::{Axis, History, LoadStep, NormalLoad, TangentialControl};

const FRICTION: f64 = 0.4;
const LOAD: f64 = 4.0;
const LIMIT: f64 = FRICTION * LOAD;
const TOLERANCE: f64 = 1e-8;

fn press_sphere() -> History {
    let grid = kit::square(64, 12.0);
    let ball = kit::sphere(grid, 20.0);
    let bodies = unit_bodies(grid, 0.3);
    let builder = History::builder(&bodies, &ball, kit::coulomb(FRICTION)).axis(Axis::Y);
    let mut history = builder.tolerance(TOLERANCE).build().unwrap();
    let press = LoadStep::hold().normal(NormalLoad::Force(LOAD));
    history.step(&press).unwrap();
    history
}

fn shear(history: &mut History, tangential: TangentialControl) {
    let step = LoadStep::hold().tangential(Axis::Y, tangential);
    history.step(&step).unwrap();
}

#[test]
fn springs_of_any_stiffness_match_force_and_shift() {
    // The stiffness of the contact itself is about four.
    for stiffness in [1e-3, 0.1, 4.0, 1e3, 1e7] {
        let (mut by_spring, mut by_force, mut by_shift) =
            (press_sphere(), press_sphere(), press_sphere());
        let compliance = 0.25 + 1.0 / stiffness;
        for part in [0.5, 0.9, 0.2, -0.9, 0.4] {
            let position = part * LIMIT * compliance;
            shear(
                &mut by_spring,
                TangentialControl::Spring {
                    position,
                    stiffness,
                },
            );
            let (force, shift) = (by_spring.tangential_force()[1], by_spring.shift()[1]);
            // The tolerance accounts for cancellation in the elongation of the spring.
            let error = force - stiffness * (position - shift);
            let round_off = 1e-13 * stiffness * (position.abs() + shift.abs());
            assert!(
                error.abs() < 1e-13 * LIMIT + round_off,
                "{stiffness}: {error:e}"
            );
            assert!(force.abs() < LIMIT && by_spring.tangential_force()[0] == 0.0);

            shear(&mut by_force, TangentialControl::Force(force));
            shear(&mut by_shift, TangentialControl::Shift(shift));
            for other in [&by_force, &by_shift] {
                let [a, b] = [&by_spring, other].map(|history| history.traction()[1].as_slice());
                let difference = max_difference(a, b) / by_spring.pressure().max();
                assert!(difference < 1e-5, "{stiffness}: {difference:e}");
                let difference = (other.shift()[1] - shift).abs() / 0.4;
                assert!(difference < 1e-7, "{stiffness}: {difference:e}");
            }
            let report = by_spring.last_step().unwrap().tangential_report().unwrap();
            assert!(report.is_converged() && report.residual <= TOLERANCE);
        }
    }
}

/// A spring can slide the contact. The force of the spring then remains at the limit during further motion.
#[test]
fn spring_slides_the_contact_at_the_limit() {
    let mut history = press_sphere();
    let limit = FRICTION * history.pressure().integral();
    for (position, slides) in [(2.0, true), (4.0, true), (8.0, true), (7.0, false)] {
        let spring = TangentialControl::Spring {
            position,
            stiffness: 4.0,
        };
        shear(&mut history, spring);
        let step = history.last_step().unwrap();
        assert_eq!(step.is_gross_slip(), slides);
        if slides {
            assert!((step.tangential_force()[1] / limit - 1.0).abs() < 1e-12);
            assert!((step.shift()[1] - (position - limit / 4.0)).abs() < 1e-12);
        } else {
            assert!(step.tangential_force()[1].abs() < 0.5 * limit);
        }
    }
}
