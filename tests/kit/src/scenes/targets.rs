//! Random smooth contacts with a random target for the error of one quantity.

use stickslip::adaptive::{AdaptiveProblem, AdaptiveSolution, Quantity, Region};
use stickslip::{
    ElasticPair, Friction, Material, NormalLoad, Result, TangentialLoad, TangentialModel,
};

use crate::Random;

/// Names of the kinds of gaps.
pub const KINDS: [&str; 5] = ["ellipse", "cone", "power", "two balls", "waves"];
/// Quantities of a target.
pub const ALL: [Quantity; 6] = [
    Quantity::Pressure,
    Quantity::Area,
    Quantity::Approach,
    Quantity::Traction,
    Quantity::StickRatio,
    Quantity::Shift,
];
/// A contact of unit force and unit size with a random gap, region and load.
pub struct TargetScene {
    /// Index of the kind of the gap.
    pub kind: usize,
    gap: Box<dyn Fn(f64, f64) -> f64 + Sync>,
    region: Region,
    friction: Option<(f64, [f64; 2])>,
    /// Quantity of the target.
    pub quantity: Quantity,
    /// Target of the quantity.
    pub target: f64,
}

impl std::fmt::Debug for TargetScene {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (kind, target) = (KINDS[self.kind], self.target);
        write!(formatter, "{kind}, {:?} {target:e}", self.quantity)
    }
}

impl TargetScene {
    /// Draws a scene.
    ///
    /// # Errors
    /// Errors of the region.
    pub fn random(seed: u64) -> Result<Self> {
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

    /// Solves the scene with its target multiplied by a factor.
    ///
    /// # Errors
    /// Errors of the problem and of its solves.
    pub fn solve(&self, factor: f64) -> Result<AdaptiveSolution> {
        let body = Material::new(2.0, 0.0)?;
        let pair = ElasticPair::new(body, body)?;
        let gap = &self.gap;
        let gap = |x: f64, y: f64| gap(x, y);
        let load = NormalLoad::Force(1.0);
        let mut builder = AdaptiveProblem::builder(pair, &gap, load, self.region)
            .target(self.quantity, factor * self.target)
            .cell_limit(1 << 22);
        if let Some((friction, force)) = self.friction {
            builder = builder.shear(Friction::coulomb(friction)?, TangentialLoad::force(force));
            if force[1] != 0.0 {
                builder = builder.model(TangentialModel::Vector);
            }
        }
        builder.build()?.solve()
    }
}
