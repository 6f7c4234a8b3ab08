//! Step in which the bodies roll.

use crate::cgm::reduce;
use crate::error::{Error, Result, finite};
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::history::LoadStep;
use crate::history::state::State;
use crate::history::step::solve::StepInput;
use crate::rolling::LeadingEdge;
use crate::rolling::RollingShift;
use crate::tangential::{
    Axis, RigidMotion, TangentialControl, TangentialModel, TangentialTarget, carry_offsets,
};
use crate::warning::Warning;

/// Rolling in a step: the number of cells, the leading edge, and the creepages and spin of body 2.
///
/// The default is free rolling to the [leading edge](LeadingEdge) at the largest x, with zero creepage and spin.
///
/// ```
/// use stickslip::history::{LeadingEdge, Rolling};
/// use stickslip::*;
/// let grid = Grid::square(24, 3.0)?;
/// let body = Material::from_shear_modulus(1.0, 0.25)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(body, body)?)?;
/// let ball = surface::sphere(grid, 1.0)?;
/// let friction = Friction::coulomb(0.3)?;
/// let builder = History::builder(&bodies, &ball, friction).model(TangentialModel::Vector);
/// let mut history = builder.build()?;
/// history.step(&LoadStep::hold().normal(NormalLoad::Force(1.0)))?;
///
/// // The creepage is prescribed, and the force approaches the force of steady rolling.
/// let rolling = Rolling::new(1).leading_edge(LeadingEdge::PlusX).creepage([0.05, 0.0]);
/// let mut last = 0.0;
/// for _ in 0..20 {
///     let force = history.step(&LoadStep::hold().roll(rolling))?.tangential_force()[0];
///     assert!(force > last && force < 0.3);
///     last = force;
/// }
/// // The force is prescribed, and the creepage follows.
/// let load = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(0.5 * last));
/// let step = history.step(&load.roll(Rolling::new(1)))?;
/// assert!(step.creepage().is_some_and(|[along, _]| along < 0.05));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Rolling {
    #[cfg_attr(feature = "serde", serde(default))]
    leading_edge: LeadingEdge,
    pub(crate) cells: usize,
    #[cfg_attr(feature = "serde", serde(default))]
    creepage: [f64; 2],
    #[cfg_attr(feature = "serde", serde(default))]
    spin: f64,
}

impl Rolling {
    /// Creates a rolling step of `cells` cells (at least 1). The particles of both surfaces move by this number of cells
    /// through the contact. A step with zero cells is rejected. The guide has [remedies for fractions of a
    /// cell](crate::guide::rolling#steps-of-whole-cells).
    #[must_use]
    pub fn new(cells: usize) -> Self {
        Self {
            leading_edge: LeadingEdge::default(),
            cells,
            creepage: [0.0; 2],
            spin: 0.0,
        }
    }

    /// Sets the side at which particles enter the contact (default [`LeadingEdge::PlusX`]).
    #[must_use]
    pub fn leading_edge(mut self, edge: LeadingEdge) -> Self {
        self.leading_edge = edge;
        self
    }

    /// Sets the creepages $`[\xi, \eta]`$ along x and y (dimensionless, default zero). A creepage is the motion of body 2
    /// over body 1 per length rolled. Positive creepages cause positive forces. Kalker's creepages have the opposite sign.
    /// If the step prescribes a force along an axis, the creepage along this axis follows and must be zero here.
    #[must_use]
    pub fn creepage(mut self, creepage: [f64; 2]) -> Self {
        self.creepage = creepage;
        self
    }

    /// Sets the spin $`\varphi`$ about the origin of the grid (one over a length, positive from x to y, default zero).
    /// The spin is the rotation of body 2 relative to body 1 per length rolled.
    #[must_use]
    pub fn spin(mut self, spin: f64) -> Self {
        self.spin = spin;
        self
    }

    /// Returns the magnitude of a prescribed creepage that needs a warning, in per cent. The spin adds its motion of the contact
    /// cell that is farthest from the origin.
    pub(in crate::history) fn large_creepage(
        &self,
        (bodies, pressure): (&HalfSpace, &Field),
    ) -> Option<usize> {
        // Without a spin the distance has no effect.
        if self.spin == 0.0 {
            return Warning::creepage_beyond(self.creepage, 0.0);
        }
        let (grid, pressure) = (bodies.grid(), pressure.as_slice());
        let distance = reduce::max(&bodies.grid_layout(), |cell| {
            let [x, y] = grid.position(cell % grid.nx(), cell / grid.nx());
            if pressure[cell] > 0.0 {
                x.hypot(y)
            } else {
                0.0
            }
        });
        Warning::creepage_beyond(self.creepage, self.spin * distance)
    }

    /// Returns the path of the particles on the grid of these bodies.
    pub(in crate::history) fn travel(&self, bodies: &HalfSpace) -> RollingShift {
        RollingShift::new(bodies.grid(), self.leading_edge, self.cells)
    }

    /// Returns the creepages of a step. Each is the prescribed creepage or, along an axis with a prescribed force, the
    /// motion of body 2 divided by the length rolled.
    pub(in crate::history) fn reached(
        &self,
        load: &LoadStep,
        moved: [f64; 2],
        length: f64,
    ) -> [f64; 2] {
        let demand = load.demand(0.0);
        [0, 1].map(|axis| match demand.controls[axis] {
            TangentialControl::Force(_) => moved[axis] / length,
            _ => self.creepage[axis],
        })
    }

    /// Converts creepages and spin to shift and twist at the end of a step from this state.
    fn compute_target(
        &self,
        mut demand: TangentialTarget,
        state: &State,
        length: f64,
    ) -> TangentialTarget {
        for (axis, control) in demand.controls.iter_mut().enumerate() {
            // The shift along an axis with zero creepage stays constant, so that the start of the solve can distinguish this axis
            // from a moving one.
            if *control == TangentialControl::Hold && self.creepage[axis] != 0.0 {
                let shift = state.motion.shift[axis] + length * self.creepage[axis];
                *control = TangentialControl::Shift(shift);
            }
        }
        demand.twist = state.motion.twist + length * self.spin;
        demand
    }

    /// Returns an error if a history in this state cannot roll with this load.
    fn check(&self, bodies: &HalfSpace, state: &State, load: &LoadStep) -> Result<()> {
        let (travel, cells) = (self.travel(bodies), self.cells as f64);
        travel.check(bodies)?;
        let (grid, boundary, length) = (bodies.grid().whole(), bodies.boundary(), travel.length);
        for creepage in self.creepage {
            finite("creepage", creepage)?;
            finite("creepage of a step", creepage * length)?;
        }
        finite("spin", self.spin)?;
        let refused = |quantity, value, remedy| {
            Err(Error::UnsupportedByModel {
                model: "the model of rolling",
                quantity,
                value,
                remedy,
            })
        };
        let unsupported = [
            (
                bodies.is_shared(),
                "a grid that is distributed over ranks (value: the number of cells of the step)",
                "use bodies that are not distributed",
            ),
            (
                state.relative.is_some(),
                "a relative displacement (value: the number of cells of the step)",
                "build the history without a relative displacement",
            ),
            (
                state.yielded.is_some(),
                "a permanent set (value: the number of cells of the step)",
                "build the history without a permanent set",
            ),
        ];
        if let Some((_, quantity, remedy)) = unsupported.into_iter().find(|row| row.0) {
            return refused(quantity, cells, remedy);
        }
        if load.names_twist() {
            let twist = load.demand(0.0).twist;
            return refused(
                "a twist",
                twist,
                "prescribe the spin of the rolling step instead",
            );
        }
        for (axis, control) in Axis::BOTH.iter().zip(load.demand(0.0).controls) {
            let creepage = self.creepage[axis.index()];
            match control {
                TangentialControl::Hold => {}
                TangentialControl::Force(_) if creepage == 0.0 => {}
                TangentialControl::Force(_) => {
                    let remedy = "prescribe either the force or the creepage along an axis";
                    return refused(
                        "a creepage and a force along the same axis",
                        creepage,
                        remedy,
                    );
                }
                TangentialControl::Shift(_) | TangentialControl::Spring { .. } => {
                    let remedy = "prescribe forces or creepages in a rolling step";
                    let (_, value) = control.checked(*axis)?;
                    return refused("a shift or a spring", value, remedy);
                }
            }
            if creepage != 0.0 && !state.axes.contains(axis) {
                let quantity = ["creepage along x", "creepage along y"][axis.index()];
                return refused(quantity, creepage, TangentialModel::VECTOR_REMEDY);
            }
        }
        if self.spin != 0.0 && !boundary.may_turn() {
            let remedy = "a periodic grid does not allow rotation in any model";
            return refused("spin", self.spin, remedy);
        }
        if self.spin != 0.0 && state.axes.len() == 1 {
            return refused("spin", self.spin, TangentialModel::VECTOR_REMEDY);
        }
        let extent = (grid.dx() * grid.nx() as f64).hypot(grid.dy() * grid.ny() as f64);
        let demand = self.compute_target(load.demand(0.0), state, length);
        finite("rotation due to the spin", demand.twist * extent)?;
        travel.check_behind(bodies, state.pressure())
    }
}

impl LoadStep {
    /// Returns an error if the step rolls, because it cannot roll by a fraction of a cell.
    pub(in crate::history) fn check_still(&self) -> Result<()> {
        self.rolling().map_or(Ok(()), |rolling| {
            Err(Error::UnsupportedByModel {
                model: "the method of adaptive steps",
                quantity: "rolling steps (value: the number of cells of the step)",
                value: rolling.cells as f64,
                remedy: "take rolling steps one cell at a time",
            })
        })
    }
}

impl State {
    /// Returns the input of a step from this state.
    pub(in crate::history) fn input<'a>(
        &self,
        load: &'a LoadStep,
        bodies: &HalfSpace,
    ) -> StepInput<'a> {
        let mut target = load.demand(self.motion.twist);
        let rolled = load
            .rolling()
            .map(|rolling| (rolling, rolling.travel(bodies)));
        if let Some((rolling, travel)) = rolled {
            target = rolling.compute_target(target, self, travel.length);
        }
        StepInput {
            load,
            target,
            travel: rolled.map(|(_, travel)| travel),
        }
    }

    /// Returns an error if a step prescribes rolling that is not possible.
    pub(in crate::history) fn check_rolling(
        &self,
        load: &LoadStep,
        bodies: &HalfSpace,
    ) -> Result<()> {
        match load.rolling() {
            Some(rolling) => rolling.check(bodies, self, load),
            None => Ok(()),
        }
    }
}

impl State {
    /// Writes the reference tractions of the next trend to its buffer. The reference tractions are the tractions before
    /// the step, scaled with the pressure if the pressure has changed from `before`.
    pub(crate) fn keep_traction(&mut self, travel: &RollingShift, before: Option<&Field>) {
        let (grid, after) = (self.grid(), self.normal.pressure());
        let before = before.unwrap_or(after);
        if let Some(memory) = &mut self.contact {
            let held = memory.window.held(grid);
            for (kept, traction) in memory.trend.change.iter_mut().zip(&self.traction) {
                for (kept, cell) in kept.iter_mut().zip(held.indices()) {
                    *kept = travel.in_proportion(traction, [before, after], cell);
                }
            }
        }
    }

    /// Moves the fields of the particles to their positions after a step that ended with this motion. Particles from
    /// outside the grid have zero fields.
    pub(crate) fn shift_with_particles(&mut self, travel: &RollingShift, end: RigidMotion) {
        let passage = travel.through(self.grid().size());
        let fields = [&mut self.accumulated_slip, &mut self.dissipated_energy];
        for field in self.traction.iter_mut().chain(&mut self.slip).chain(fields) {
            passage.shift_with_particles(field.as_mut_slice());
        }
        if let Some(memory) = &mut self.contact {
            let passage = travel.through(memory.window.size);
            for part in &mut memory.displacement {
                passage.shift_with_particles(part);
            }
            let turned = travel.rotation_correction(0.5 * (self.motion.twist + end.twist));
            let carry = |part: &mut [f64]| passage.shift_with_particles(part);
            carry_offsets(&mut memory.offset, carry, turned);
        }
    }
}
