//! A contact that grows while it is sheared, in few and in many steps: effect of the entry rule.
//!
//! `cargo run --release -p stickslip-examples --example growing_contact [reference]` prints, for a ball and a rough ball, the
//! error of the traction field without and with the entry rule, for 1, 4 and 8 steps per leg. The reference uses 64 steps per
//! leg.

#![allow(clippy::print_stdout, reason = "an example shows its numbers")]

use std::error::Error;

use stickslip::history::EntryRule;
use stickslip::{
    ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep, Material, NormalLoad,
    TangentialModel, surface,
};

const CELLS: usize = 64;
const FRICTION: f64 = 0.5;
/// Contact radius at an approach of one.
const RADIUS: f64 = 24.0;

/// Approach or normal force, and shift or tangential force, at the end of a leg.
type Leg = (f64, [f64; 2]);

const SHIFTS: [(&str, &[Leg]); 4] = [
    ("proportional, oblique", &[(1.0, [0.224, 0.168])]),
    (
        "with a slip zone",
        &[(0.4, [0.0; 2]), (0.5, [0.2, 0.0]), (1.0, [0.35, 0.0])],
    ),
    (
        "turning",
        &[(0.5, [0.0; 2]), (0.6, [0.15, 0.0]), (1.0, [0.2, 0.2])],
    ),
    ("c > mu", &[(0.5, [0.0; 2]), (0.7, [0.3, 0.0])]),
];

const FORCES: [(&str, &[Leg]); 3] = [
    ("proportional", &[(1.0, [0.3, 0.0])]),
    (
        "with a slip zone",
        &[(0.5, [0.0; 2]), (0.5, [0.15, 0.0]), (1.0, [0.3, 0.0])],
    ),
    (
        "turning",
        &[(0.5, [0.0; 2]), (0.5, [0.15, 0.0]), (1.0, [0.15, 0.2])],
    ),
];

fn main() -> Result<(), Box<dyn Error>> {
    let reference = match std::env::args().nth(1) {
        Some(steps) => steps.parse()?,
        None => 64,
    };
    println!(
        "error of the traction field, without / with the entry rule, for 1, 4 and 8 steps per leg"
    );
    println!(
        "{:<32} {:<13} {:>19} {:>19} {:>19}",
        "path", "scene", "1", "4", "8"
    );
    for (poisson_ratio, roughness, name) in [
        (0.0, 0.15, "nu 0, rough"),
        (0.3, 0.0, "nu 0.3, ball"),
        (0.3, 0.15, "nu 0.3, rough"),
    ] {
        let scene = GrowingCase::new(poisson_ratio, roughness)?;
        for (kind, paths) in [("shift", &SHIFTS[..]), ("force", &FORCES[..])] {
            for (path, legs) in paths {
                let follow = |steps, rule| scene.follow(legs, kind == "force", steps, rule);
                let exact = follow(reference, EntryRule::SinceTouch)?;
                print!("{:<32} {name:<13}", format!("{kind}, {path}"));
                for steps in [1, 4, 8] {
                    let without = distance(&follow(steps, EntryRule::WholeStep)?, &exact);
                    let with = distance(&follow(steps, EntryRule::SinceTouch)?, &exact);
                    print!(" {without:>9.1e}/{with:>9.1e}");
                }
                println!();
            }
        }
    }
    Ok(())
}

struct GrowingCase {
    bodies: HalfSpace,
    gap: Field,
    /// Normal force on the smooth ball at an approach of one.
    force: f64,
}

impl GrowingCase {
    fn new(poisson_ratio: f64, roughness: f64) -> Result<Self, stickslip::Error> {
        let grid = Grid::square(CELLS, CELLS as f64)?;
        let body = Material::new(1.0, poisson_ratio)?;
        let bodies = HalfSpace::new(grid, ElasticPair::new(body, body)?)?;
        let ball = surface::sphere(grid, RADIUS * RADIUS)?;
        // The roughness consists of twelve waves of 20 cells or more, in all directions.
        let waves = |x: f64, y: f64| -> f64 {
            let wave = |number: i32| {
                let (turn, number) = (2.4 * f64::from(number), f64::from(number));
                let along = x * turn.cos() + y * turn.sin();
                (0.3 * along * (number / 12.0).sqrt() + number * number).cos()
            };
            (1..=12).map(wave).sum()
        };
        let bumps = Field::from_fn(grid, waves);
        let scale = roughness * ball.max() / bumps.max().max(-bumps.min());
        let mut gap = ball;
        for (gap, bump) in gap.as_mut_slice().iter_mut().zip(bumps.as_slice()) {
            *gap += scale * bump;
        }
        let least = gap.min();
        for gap in gap.as_mut_slice() {
            *gap -= least;
        }
        Ok(Self {
            force: 4.0 / 3.0 * bodies.pair().contact_modulus() * RADIUS,
            bodies,
            gap,
        })
    }

    /// Follows the legs of the load path in equal steps. A leg that only presses is a single step.
    fn follow(
        &self,
        legs: &[Leg],
        is_force: bool,
        steps: u32,
        rule: EntryRule,
    ) -> Result<History, stickslip::Error> {
        let friction = Friction::coulomb(FRICTION)?;
        let mut history = History::builder(&self.bodies, &self.gap, friction)
            .model(TangentialModel::Vector)
            .entry_rule(rule)
            .tolerance(1e-11)
            .build()?;
        let mut last: Leg = (0.0, [0.0; 2]);
        for &leg in legs {
            let shears = (leg.1[0] - last.1[0]).hypot(leg.1[1] - last.1[1]) > 0.0;
            let steps = if shears { steps } else { 1 };
            for step in 1..=steps {
                let part = f64::from(step) / f64::from(steps);
                let between = |a: f64, b: f64| a + part * (b - a);
                let press = between(last.0, leg.0);
                let shear = [0, 1].map(|axis| between(last.1[axis], leg.1[axis]));
                history.step(&if is_force {
                    let press = NormalLoad::Force(self.force * press);
                    LoadStep::force(shear.map(|shear| self.force * shear)).normal(press)
                } else {
                    LoadStep::shift(shear).normal(NormalLoad::Approach(press))
                })?;
            }
            last = leg;
        }
        Ok(history)
    }
}

/// Returns the sum of the differences of the tractions divided by the sum of the tractions of the second history.
fn distance(a: &History, b: &History) -> f64 {
    let ([ax, ay], [bx, by]) = (a.traction(), b.traction());
    let (mut difference, mut size) = (0.0, 0.0);
    for i in 0..ax.as_slice().len() {
        let [ax, ay, bx, by] = [ax, ay, bx, by].map(|field| field.as_slice()[i]);
        difference += (ax - bx).hypot(ay - by);
        size += bx.hypot(by);
    }
    difference / size
}
