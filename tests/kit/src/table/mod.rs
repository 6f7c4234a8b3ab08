//! Histories of every type on small grids, for laws that every history obeys. Every option and load of a history occurs
//! in a scene. Lengths and pressures have no units, and directions refer to one orientation. A [`UnitTransform`]
//! transforms them.

mod kinds;
mod measure;
mod pose;

use std::sync::Arc;

use stickslip::history::{EntryRule, wear};
use stickslip::normal::Hardness;
use stickslip::ranks::Ranks;
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Axis, Boundary, Coupling, ElasticPair, Field, Friction, Grid, HalfSpace, History, LoadStep,
    Material, NormalControl, Result, TangentialControl, TangentialModel,
};

pub use kinds::scenes;
pub use measure::{Measured, bits, cells, known};
pub use pose::UnitTransform;

/// Boundary of the grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Around {
    Nothing,
    Everywhere,
    AlongY,
    /// A single row, in plane strain.
    Line,
}

/// Loads of a step.
#[derive(Debug, Clone, Copy)]
pub struct Step {
    pub normal: NormalControl,
    pub shear: [TangentialControl; 2],
    pub twist: Option<f64>,
    pub strain: Option<f64>,
}

/// A history: its options and its steps.
#[derive(Debug, Clone)]
pub struct Scene {
    pub name: &'static str,
    pub size: [usize; 2],
    /// Sides of a cell.
    pub sides: [f64; 2],
    pub around: Around,
    /// Young's modulus (infinite for a rigid body) and Poisson's ratio of each body.
    pub bodies: [(f64, f64); 2],
    pub gap: fn(f64, f64) -> f64,
    pub friction: f64,
    /// Position-dependent part of the friction coefficient.
    pub slippery: Option<fn(f64, f64) -> f64>,
    pub shear_strength: f64,
    pub model: TangentialModel,
    pub coupling: Coupling,
    pub entry_rule: EntryRule,
    pub hardness: Option<fn(f64, f64) -> f64>,
    pub is_set_permanent: bool,
    pub strain: Option<[[f64; 2]; 2]>,
    /// Wear depth divided by pressure and slip.
    pub wear: f64,
    pub tolerance: f64,
    pub path: Vec<Step>,
}

impl Scene {
    /// Returns the scene on a finer grid.
    #[must_use]
    pub fn finer(mut self, times: [usize; 2]) -> Self {
        for (axis, times) in times.into_iter().enumerate() {
            if axis == 0 || self.around != Around::Line {
                self.size[axis] *= times;
                self.sides[axis] /= times as f64;
            }
        }
        self
    }

    /// Returns whether the grid may exchange its axes.
    pub fn can_turn(&self) -> bool {
        matches!(self.around, Around::Nothing | Around::Everywhere)
    }

    /// Returns the length over which the contact carries a load, as a unit of the load.
    fn depth(&self, pose: &UnitTransform) -> f64 {
        if self.around == Around::Line {
            1.0
        } else {
            pose.length
        }
    }

    fn grid(&self, pose: &UnitTransform) -> Grid {
        let [nx, ny] = pose.swapped(self.size);
        let [dx, dy] = pose.swapped(self.sides).map(|side| side * pose.length);
        match self.around {
            Around::Line => Grid::line(nx, dx).unwrap(),
            _ => Grid::new(nx, ny, dx, dy).unwrap(),
        }
    }

    fn boundary(&self, grid: Grid) -> Boundary {
        match self.around {
            Around::Nothing => Boundary::NonPeriodic,
            Around::Everywhere => Boundary::Periodic,
            Around::AlongY | Around::Line => Boundary::PeriodicAlongY {
                datum: 4.0 * grid.dx() * grid.nx() as f64,
            },
        }
    }

    fn pair(&self, pose: &UnitTransform) -> ElasticPair {
        let [a, b] = self.bodies.map(|(modulus, poisson_ratio)| {
            if modulus.is_infinite() {
                Material::rigid()
            } else {
                Material::new(modulus * pose.pressure, poisson_ratio).unwrap()
            }
        });
        let pair = if pose.exchanges {
            ElasticPair::new(b, a)
        } else {
            ElasticPair::new(a, b)
        };
        pair.unwrap()
    }

    pub fn half_space(&self, pose: &UnitTransform) -> HalfSpace {
        let grid = self.grid(pose);
        HalfSpace::with_boundary(grid, self.pair(pose), self.boundary(grid)).unwrap()
    }

    /// Returns the half-space on the slab of a rank.
    pub fn half_space_on(&self, rank: Arc<dyn Ranks>) -> Result<HalfSpace> {
        let pose = UnitTransform::IN_PLACE;
        let grid = self.grid(&pose);
        HalfSpace::distributed(grid, self.pair(&pose), self.boundary(grid), rank)
    }

    fn friction(&self, grid: Grid, pose: &UnitTransform) -> Friction {
        let friction = match self.slippery {
            Some(differs) => {
                Friction::per_cell(pose.field(grid, |x, y| self.friction + differs(x, y)))
            }
            None => Friction::coulomb(self.friction),
        };
        let friction = friction.unwrap();
        if self.shear_strength.is_finite() {
            let strength = self.shear_strength * pose.pressure;
            return friction.max_shear_stress(strength).unwrap();
        }
        friction
    }

    /// Returns the history before its first step.
    pub fn history(&self, bodies: &HalfSpace, pose: &UnitTransform) -> History {
        let grid = bodies.grid();
        let gap = pose.field(grid, self.gap).scaled(pose.length);
        let mut builder = History::builder(bodies, &gap, self.friction(grid, pose))
            .model(self.model)
            .coupling(self.coupling)
            .entry_rule(self.entry_rule)
            .axis(if pose.swaps { Axis::Y } else { Axis::X })
            .tolerance(self.tolerance);
        if let Some(limit) = self.hardness {
            let limits = pose.field(grid, limit).scaled(pose.pressure);
            let hardness = Hardness::per_cell(limits).unwrap();
            builder = builder
                .hardness(hardness)
                .permanent_set(self.is_set_permanent);
        }
        if let Some(strain) = self.strain {
            let strain = pose.tensor(strain);
            let bulk = RelativeDisplacement::bulk_strain(grid, strain).unwrap();
            builder = builder.relative_displacement(bulk);
        }
        builder.build().unwrap()
    }

    /// Returns a step of the path, transformed by the pose.
    pub fn load(&self, step: &Step, pose: &UnitTransform) -> LoadStep {
        let (length, stiffness) = (pose.length, pose.pressure * self.depth(pose));
        let force = stiffness * length;
        let normal = match step.normal {
            NormalControl::Force(value) => NormalControl::Force(value * force),
            NormalControl::Approach(value) => NormalControl::Approach(value * length),
            other => other,
        };
        let shear = step.shear;
        let posed = |axis: usize| {
            let sign = pose.signs[axis] * pose.side();
            match pose.swapped(shear)[axis] {
                TangentialControl::Force(value) => TangentialControl::Force(sign * value * force),
                TangentialControl::Shift(value) => TangentialControl::Shift(sign * value * length),
                TangentialControl::Spring {
                    position,
                    stiffness: k,
                } => TangentialControl::Spring {
                    position: sign * position * length,
                    stiffness: k * stiffness,
                },
                other => other,
            }
        };
        let mut load = LoadStep::hold()
            .normal(normal)
            .tangential(Axis::X, posed(0))
            .tangential(Axis::Y, posed(1));
        if let Some(twist) = step.twist {
            load = load.twist(pose.turn() * twist);
        }
        if let Some(amount) = step.strain {
            load = load.relative_displacement(amount);
        }
        load
    }

    /// Takes a step of the path, and applies its wear to the gap.
    pub fn take(&self, history: &mut History, step: &Step, pose: &UnitTransform) {
        let load = self.load(step, pose);
        let taken = history.step(&load).map(|_| ());
        taken.unwrap_or_else(|error| panic!("{}: {step:?}: {error}", self.name));
        self.wear(history, pose);
    }

    /// Applies the wear of the last step to the gap.
    pub fn wear(&self, history: &mut History, pose: &UnitTransform) {
        if self.wear == 0.0 {
            return;
        }
        let mut gap = history.gap().clone();
        let slipped = history.last_step().slip_distance();
        let mut depth = Field::zeros(gap.grid());
        let rate = self.wear / pose.pressure;
        wear::archard(rate, history.pressure(), slipped, &mut depth).unwrap();
        gap.add_scaled(1.0, &depth).unwrap();
        history.set_gap(&gap).unwrap();
    }

    /// Takes all steps of the path.
    pub fn run(&self, history: &mut History, pose: &UnitTransform) {
        for step in &self.path {
            self.take(history, step, pose);
        }
    }
}
