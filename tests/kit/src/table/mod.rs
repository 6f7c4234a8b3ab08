//! Histories of every type on small grids, for laws that every history obeys. Every option and load of a history occurs
//! in a scene. Lengths and pressures have no units, and directions refer to one orientation. A [`UnitTransform`]
//! transforms them.

mod kinds;
mod measure;
mod pose;
mod problem;

use std::sync::Arc;

use stickslip::history::{EntryRule, LeadingEdge, Rolling, wear};
use stickslip::layers::Layer;
use stickslip::normal::Hardness;
use stickslip::ranks::Ranks;
use stickslip::tangential::RelativeDisplacement;
use stickslip::{
    Axis, Boundary, CellValue, Coupling, ElasticPair, Field, Friction, Grid, HalfSpace, History,
    Kernel, LoadStep, Material, NormalControl, Result, TangentialControl, TangentialModel,
};

pub use kinds::scenes;
pub use measure::{Measured, bits, cells, known};
pub use pose::UnitTransform;
pub use problem::{Found, Kind, Problem, ProblemSolver};

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
    pub roll: Option<Roll>,
}

/// Rolling of a step.
#[derive(Debug, Clone, Copy)]
pub struct Roll {
    pub cells: usize,
    pub edge: LeadingEdge,
    pub creepage: [f64; 2],
    pub spin: f64,
}

/// Young's modulus, Poisson's ratio and thickness of a coating.
pub type Coating = (f64, f64, f64);

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
    /// Coating of each body.
    pub coatings: [Option<Coating>; 2],
    /// Whether the response of the coated bodies is given by a closure.
    pub is_kernel: bool,
    pub cell_value: CellValue,
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

    /// Returns the unit of energies and moments.
    fn energy_unit(&self, pose: &UnitTransform) -> f64 {
        pose.pressure * pose.length * pose.length * self.depth(pose)
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

    /// Returns whether the bodies roll in a step.
    pub fn rolls(&self) -> bool {
        self.path.iter().any(|step| step.roll.is_some())
    }

    /// Returns the bodies, or half-spaces of their outermost materials.
    fn pair(&self, pose: &UnitTransform, is_outermost: bool) -> ElasticPair {
        let material = |modulus: f64, poisson_ratio: f64| {
            if modulus.is_infinite() {
                return Material::rigid();
            }
            Material::new(modulus * pose.pressure, poisson_ratio).unwrap()
        };
        let [a, b] = [0, 1].map(|body| {
            let (modulus, ratio) = self.bodies[body];
            match self.coatings[body] {
                None => material(modulus, ratio),
                Some((modulus, ratio, _)) if is_outermost => material(modulus, ratio),
                Some((coating, own, thickness)) => {
                    let layer = Layer::new(coating * pose.pressure, own, thickness * pose.length);
                    let base = material(modulus, ratio);
                    base.coated(&[layer.unwrap()]).unwrap()
                }
            }
        });
        let [a, b] = if pose.exchanges { [b, a] } else { [a, b] };
        ElasticPair::new(a, b).unwrap()
    }

    fn kernel(&self, pose: &UnitTransform) -> Kernel {
        let pair = self.pair(pose, false);
        if !self.is_kernel {
            return pair.into();
        }
        let thicknesses = self.coatings.iter().flatten().map(|coating| coating.2);
        let thickness = thicknesses.fold(f64::INFINITY, f64::min) * pose.length;
        let response = move |wave_number| pair.response(wave_number).unwrap();
        Kernel::isotropic(self.pair(pose, true), thickness, response).unwrap()
    }

    pub fn half_space(&self, pose: &UnitTransform) -> HalfSpace {
        let grid = self.grid(pose);
        let bodies = HalfSpace::with_boundary(grid, self.kernel(pose), self.boundary(grid));
        bodies.unwrap().with_cell_value(self.cell_value).unwrap()
    }

    /// Returns the half-space on the slab of a rank.
    pub fn half_space_on(&self, rank: Arc<dyn Ranks>) -> Result<HalfSpace> {
        let pose = UnitTransform::IN_PLACE;
        let grid = self.grid(&pose);
        HalfSpace::distributed(grid, self.kernel(&pose), self.boundary(grid), rank)?
            .with_cell_value(self.cell_value)
    }

    pub fn friction(&self, grid: Grid, pose: &UnitTransform) -> Friction {
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

    pub fn gap(&self, grid: Grid, pose: &UnitTransform) -> Field {
        pose.field(grid, self.gap).scaled(pose.length)
    }

    pub fn hardness(&self, grid: Grid, pose: &UnitTransform) -> Option<Hardness> {
        let limits = pose.field(grid, self.hardness?).scaled(pose.pressure);
        Some(Hardness::per_cell(limits).unwrap())
    }

    pub fn bulk_strain(
        &self,
        grid: Grid,
        pose: &UnitTransform,
        amount: f64,
    ) -> Option<RelativeDisplacement> {
        let strain = pose.tensor(self.strain?);
        let fields = strain.map(|row| {
            let [x_part, y_part] = row.map(|part| amount * part);
            Field::from_fn(grid, |x, y| x_part * x + y_part * y)
        });
        Some(RelativeDisplacement::new(fields).unwrap())
    }

    /// Returns whether the tractions change the pressure.
    pub fn is_fully_coupled(&self) -> bool {
        let pair = self.pair(&UnitTransform::IN_PLACE, false);
        self.coupling == Coupling::Full && pair.is_coupled()
    }

    /// Returns the history before its first step.
    pub fn history(&self, bodies: &HalfSpace, pose: &UnitTransform) -> History {
        let grid = bodies.grid();
        let mut builder = History::builder(bodies, self.gap(grid, pose), self.friction(grid, pose))
            .model(self.model)
            .coupling(self.coupling)
            .entry_rule(self.entry_rule)
            .axis(if pose.swaps { Axis::Y } else { Axis::X })
            .tolerance(self.tolerance);
        if let Some(hardness) = self.hardness(grid, pose) {
            builder = builder
                .hardness(hardness)
                .permanent_set(self.is_set_permanent);
        }
        if let Some(bulk) = self.bulk_strain(grid, pose, 1.0) {
            builder = builder.relative_displacement(bulk);
        }
        builder.build().unwrap()
    }

    /// Returns the loads of a step, transformed by the pose.
    fn transformed(&self, step: &Step, pose: &UnitTransform) -> Step {
        let (length, stiffness) = (pose.length, pose.pressure * self.depth(pose));
        let force = stiffness * length;
        let posed = |axis: usize| {
            let sign = pose.signs[axis] * pose.side();
            match pose.swapped(step.shear)[axis] {
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
        Step {
            normal: match step.normal {
                NormalControl::Force(value) => NormalControl::Force(value * force),
                NormalControl::Approach(value) => NormalControl::Approach(value * length),
                other => other,
            },
            shear: [posed(0), posed(1)],
            twist: step.twist.map(|twist| pose.turn() * twist),
            strain: step.strain,
            roll: step.roll.map(|roll| {
                let creepage = pose.swapped(roll.creepage);
                Roll {
                    edge: pose.edge(roll.edge),
                    creepage: [0, 1].map(|axis| pose.signs[axis] * pose.side() * creepage[axis]),
                    spin: pose.turn() * roll.spin / length,
                    ..roll
                }
            }),
        }
    }

    /// Returns a step of the path, transformed by the pose.
    pub fn load(&self, step: &Step, pose: &UnitTransform) -> LoadStep {
        let step = self.transformed(step, pose);
        let [x, y] = step.shear;
        let mut load = LoadStep::hold()
            .normal(step.normal)
            .tangential(Axis::X, x)
            .tangential(Axis::Y, y);
        if let Some(twist) = step.twist {
            load = load.twist(twist);
        }
        if let Some(amount) = step.strain {
            load = load.relative_displacement(amount);
        }
        if let Some(roll) = step.roll {
            let rolling = Rolling::new(roll.cells)
                .leading_edge(roll.edge)
                .creepage(roll.creepage)
                .spin(roll.spin);
            load = load.roll(rolling);
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
        let mut gap = history.unloaded_gap().clone();
        let slipped = history.last_step().unwrap().slip_distance();
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
