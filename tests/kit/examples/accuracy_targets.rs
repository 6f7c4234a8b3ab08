//! Solves random smooth contacts to random targets and compares the estimated errors with the true errors.
//!
//! `accuracy_targets FIRST COUNT` prints the quantiles of the ratio of the true error to the target.

use std::process::ExitCode;
use std::time::Instant;

use stickslip::adaptive::{AdaptiveProblem, AdaptiveSolution, AdaptiveStatus, Quantity, Region};
use stickslip::{ElasticPair, Friction, Material, NormalControl, Result, TangentialLoad};
use kit::Random;

const KINDS: [&str; 5] = ["ellipse", "cone", "power", "two balls", "waves"];
const ALL: [Quantity; 6] = [
    Quantity::Pressure,
    Quantity::Area,
    Quantity::Approach,
    Quantity::Traction,
    Quantity::StickRatio,
    Quantity::Shift,
];
/// Targets of the reference solutions divided by the targets of the scene.
const REFERENCE: f64 = 0.15;

/// A contact of unit force and unit size with a random gap, region and load.
struct Scene {
    kind: usize,
    gap: Box<dyn Fn(f64, f64) -> f64 + Sync>,
    region: Region,
    friction: Option<(f64, [f64; 2])>,
    quantity: Quantity,
    target: f64,
}

impl Scene {
    fn random(seed: u64) -> Result<Self> {
        let mut random = Random(seed);
        let kind = random.integer(0, KINDS.len() - 1);
        let middle = [random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)];
        let angle = random.uniform(0.0, std::f64::consts::PI);
        let ratio = random.decade(0.0, 0.7);
        let power = random.uniform(1.5, 4.0);
        let apart = random.uniform(0.5, 2.0);
        let lower = random.uniform(0.0, 0.5);
        let (number, height) = (random.uniform(1.0, 8.0), random.decade(-2.5, -0.7));
        let phase = random.uniform(0.0, 6.0);
        let gap = move |x: f64, y: f64| {
            let (x, y) = (x - middle[0], y - middle[1]);
            let (u, v) = (
                x * angle.cos() + y * angle.sin(),
                y * angle.cos() - x * angle.sin(),
            );
            let r = u.hypot(v);
            match kind {
                0 => 0.5 * (u * u + v * v * ratio),
                1 => r,
                2 => 0.5 * r.powf(power),
                3 => {
                    let second = 0.5 * ((u - apart).powi(2) + v * v) + 0.3 * lower;
                    (0.5 * (u * u + v * v)).min(second)
                }
                _ => {
                    let waves = (number * u * 3.0 + phase).cos() + (number * v * 2.0).cos();
                    0.5 * r * r + height * waves / number
                }
            }
        };
        let reach = random.decade(0.5, 2.0);
        let offset = [random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)];
        let [x, y] = [0, 1].map(|axis| {
            let centre = middle[axis] + offset[axis] * reach;
            [centre - reach, centre + reach]
        });
        let friction = random.chance(0.5).then(|| {
            let (size, angle) = (random.uniform(0.1, 0.95), random.uniform(0.0, 1.5));
            let oblique = random.chance(0.3);
            let angle = if oblique { angle } else { 0.0 };
            (0.5, [size * 0.5 * angle.cos(), size * 0.5 * angle.sin()])
        });
        let quantities = if friction.is_some() { 6 } else { 3 };
        Ok(Self {
            kind,
            gap: Box::new(gap),
            region: Region::rectangle(x, y)?,
            friction,
            quantity: ALL[random.integer(0, quantities - 1)],
            target: random.decade(-3.0, -1.3),
        })
    }

    fn solve(&self, factor: f64) -> Result<AdaptiveSolution> {
        let body = Material::new(2.0, 0.0)?;
        let pair = ElasticPair::new(body, body)?;
        let gap = &self.gap;
        let gap = |x: f64, y: f64| gap(x, y);
        let load = NormalControl::Force(1.0);
        let mut builder = AdaptiveProblem::builder(pair, &gap, load, self.region)
            .target(self.quantity, factor * self.target)
            .cell_limit(1 << 22);
        if let Some((friction, force)) = self.friction {
            builder = builder.shear(Friction::coulomb(friction)?, TangentialLoad::force(force));
            if force[1] != 0.0 {
                builder = builder.model(stickslip::TangentialModel::Vector);
            }
        }
        builder.build()?.solve()
    }
}

fn main() -> ExitCode {
    let mut numbers = std::env::args().skip(1).map(|word| word.parse::<u64>());
    let (Some(Ok(first)), Some(Ok(count))) = (numbers.next(), numbers.next()) else {
        eprintln!("usage: accuracy_targets FIRST COUNT");
        return ExitCode::FAILURE;
    };
    let mut ratios = Vec::new();
    let mut slowest = (0.0, 0);
    for seed in first..first + count {
        let outcome = Scene::random(seed).and_then(|scene| {
            let start = Instant::now();
            let found = scene.solve(1.0)?;
            let time = start.elapsed().as_secs_f64();
            let reference = scene.solve(REFERENCE)?;
            Ok((scene, found, reference, time))
        });
        let (scene, found, reference, time) = match outcome {
            Ok(outcome) => outcome,
            Err(error) => {
                println!("scene {seed}: {error}");
                continue;
            }
        };
        if count == 1 {
            for solution in [&found, &reference] {
                for record in solution.grids() {
                    println!("{:?}", record);
                }
                println!("approach {} area {} force {} estimate {:?} report {:?}", solution.normal().approach(), solution.area(), solution.normal().force(), solution.normal().discretisation_estimate(), solution.normal().report());
            }
            for quantity in ALL { println!("{quantity:?} {:?}", found.difference(&reference, quantity)); }
        }
        if time > slowest.0 {
            slowest = (time, seed);
        }
        let error = found.difference(&reference, scene.quantity);
        let ratio = error / scene.target;
        let estimate = found.estimate(scene.quantity).unwrap_or(f64::NAN);
        let is_reached = found.status() == AdaptiveStatus::Reached;
        if ratio > 1.0 || !is_reached || reference.status() != AdaptiveStatus::Reached {
            let kind = KINDS[scene.kind];
            let grids: Vec<_> = found.grids().iter().map(|record| (record.grid.nx(), record.grid.ny())).collect();
            println!(
                "scene {seed}: {kind}, {:?} {:.1e}: error {error:.1e}, estimate {estimate:.1e}, {:?}, reference {:?} {:?}, {grids:?}",
                scene.quantity, scene.target, found.status(), reference.status(), reference.grid().nx()
            );
        }
        if is_reached {
            ratios.push((ratio, scene.quantity, scene.kind, time, found.grid().cells()));
        }
    }
    ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    for quantity in ALL {
        let own: Vec<f64> = ratios.iter().filter(|r| r.1 == quantity).map(|r| r.0).collect();
        if own.is_empty() {
            continue;
        }
        let at = |part: f64| own[((own.len() - 1) as f64 * part).round() as usize];
        let over = own.iter().filter(|ratio| **ratio > 1.0).count();
        println!(
            "{quantity:?}: {} scenes, error over target: median {:.2}, 90 % {:.2}, 99 % {:.2}, most {:.2}; {over} above",
            own.len(), at(0.5), at(0.9), at(0.99), at(1.0)
        );
    }
    let over = ratios.iter().filter(|ratio| ratio.0 > 1.0).count();
    println!("{} scenes reached, {over} above the target; slowest {:.2} s, scene {}", ratios.len(), slowest.0, slowest.1);
    ExitCode::SUCCESS
}
