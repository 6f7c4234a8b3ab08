//! What a history tells of its state.

use crate::cgm::Settings;
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::history::{History, StepResult};
use crate::normal::NormalSolution;
use crate::tangential::{self, Axis, Friction, Zone};

impl History {
    /// The settings of the next step.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        self.state.settings()
    }

    /// What the last step did; all zero before the first.
    #[must_use]
    pub fn last_step(&self) -> &StepResult {
        &self.step
    }

    /// Steps taken since the start.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.state.steps()
    }

    /// The grid of all fields.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.bodies.grid()
    }

    /// What lies beyond the edge of the grid.
    #[must_use]
    pub fn boundary(&self) -> Boundary {
        self.bodies.boundary()
    }

    /// The axis of tangential load and tractions in the scalar model, `None` in that of the plane.
    #[must_use]
    pub fn axis(&self) -> Option<Axis> {
        self.state.axis()
    }

    /// The gap before loading (lengths), as last set.
    #[must_use]
    pub fn gap(&self) -> &Field {
        self.state.gap()
    }

    /// The friction, as last set.
    #[must_use]
    pub fn friction(&self) -> &Friction {
        self.state.friction()
    }

    /// The normal contact: pressure, approach, gap under load, contact area, warnings.
    #[must_use]
    pub fn normal(&self) -> &NormalSolution {
        self.state.normal()
    }

    /// Pressure p >= 0; exactly zero outside the contact.
    #[must_use]
    pub fn pressure(&self) -> &Field {
        self.state.pressure()
    }

    /// Approach of the bodies from the datum of the gap (a length).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.state.approach()
    }

    /// Shear traction q on body 1 (pressures), positive along the axes; exactly zero outside the contact.
    #[doc(alias = "shear stress")]
    #[must_use]
    pub fn traction(&self) -> [&Field; 2] {
        self.state.traction()
    }

    /// Displacement of the surface of body 1 relative to that of body 2 by the tractions (lengths), of all
    /// cells, in contact or not: computed when asked for, by the operators that the bodies then keep. With
    /// [`Coupling::Full`](crate::Coupling::Full) that by the pressure is part of it.
    ///
    /// # Errors
    /// As [`HalfSpace::operator`](crate::HalfSpace::operator); [`Error::Ranks`](crate::Error::Ranks).
    pub fn displacement(&self) -> Result<[Field; 2]> {
        let joint = self.state.contact.as_ref();
        if let Some(memory) = joint.filter(|_| self.state.is_joint()) {
            return memory.fields(self.grid());
        }
        tangential::displacement(&self.bodies, self.state.axes, self.traction())
    }

    /// Sum of the slips of all steps, with their signs (lengths).
    #[must_use]
    pub fn slip(&self) -> [&Field; 2] {
        self.state.slip()
    }

    /// Length of the path slipped in all steps (lengths, non-negative).
    #[must_use]
    pub fn accumulated_slip(&self) -> &Field {
        self.state.accumulated_slip()
    }

    /// Energy each cell has dissipated in all steps, the sum of [`StepResult::dissipated_energy`] (energies, force
    /// times length, non-negative).
    #[doc(alias = "dissipated energy")]
    #[must_use]
    pub fn dissipated_energy(&self) -> &Field {
        self.state.dissipated_energy()
    }

    /// The zone of every cell after the last step, row-major with x fastest.
    #[must_use]
    pub fn zones(&self) -> &[Zone] {
        self.state.zones()
    }

    /// Shift of body 2 relative to body 1 since the start (lengths).
    #[must_use]
    pub fn shift(&self) -> [f64; 2] {
        self.state.shift()
    }

    /// Rotation of body 2 relative to body 1 since the start (radians).
    #[must_use]
    pub fn twist(&self) -> f64 {
        self.state.twist()
    }

    /// Tangential force that body 2 exerts on body 1.
    #[must_use]
    pub fn tangential_force(&self) -> [f64; 2] {
        self.state.tangential_force()
    }

    /// Largest tangential force friction holds at the present pressure (a force): the integral of the friction limit.
    #[must_use]
    pub fn friction_capacity(&self) -> f64 {
        let alone = || self.state.capacity_with(&self.bodies, self.friction());
        self.state.capacity.unwrap_or_else(alone)
    }

    /// Moment about z, at the origin of the grid, that the tractions of body 2 exert on body 1.
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.state.moment()
    }
}
