//! Read access to the state of a history.

use crate::cgm::Settings;
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::history::{History, StepResult};
use crate::normal::NormalSolution;
use crate::tangential::{self, Axis, Friction, Zone};

impl History {
    /// Returns the settings of the next step.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        self.state.settings()
    }

    /// Returns the result of the last step. All its values are zero before the first step.
    #[must_use]
    pub fn last_step(&self) -> &StepResult {
        &self.step
    }

    /// Returns the number of steps taken since the start.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.state.steps()
    }

    /// Returns the grid of all fields.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.bodies.grid()
    }

    /// Returns the boundary condition at the edge of the grid.
    #[must_use]
    pub fn boundary(&self) -> Boundary {
        self.bodies.boundary()
    }

    /// Returns the axis of tangential load and tractions in the scalar model, or `None` in the vector model.
    #[must_use]
    pub fn axis(&self) -> Option<Axis> {
        self.state.axis()
    }

    /// Returns the gap before loading (lengths), which is the last gap set plus the [plastic
    /// depth](crate::history::State::yielded).
    #[must_use]
    pub fn gap(&self) -> &Field {
        self.state.gap()
    }

    /// Returns the friction of the next step.
    #[must_use]
    pub fn friction(&self) -> &Friction {
        self.state.friction()
    }

    /// Returns the normal contact: pressure, approach, gap under load, contact area and warnings.
    #[must_use]
    pub fn normal(&self) -> &NormalSolution {
        self.state.normal()
    }

    /// Returns the pressure p >= 0, which is exactly zero outside the contact.
    #[must_use]
    pub fn pressure(&self) -> &Field {
        self.state.pressure()
    }

    /// Returns the approach of the bodies from the datum of the gap (a length).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.state.approach()
    }

    /// Returns the shear traction q on body 1 (pressures), positive along the axes. The traction is exactly zero
    /// outside the contact.
    #[doc(alias = "shear stress")]
    #[must_use]
    pub fn traction(&self) -> [&Field; 2] {
        self.state.traction()
    }

    /// Computes the displacement of the surface of body 1 relative to the surface of body 2 due to the tractions
    /// (lengths). The result covers all cells, inside and outside the contact. The bodies cache the operators that this
    /// call creates. With [`Coupling::Full`](crate::Coupling::Full) the result includes the displacement due to the
    /// pressure.
    ///
    /// # Errors
    /// - Errors of [`HalfSpace::operator`](crate::HalfSpace::operator).
    /// - [`Error::Ranks`](crate::Error::Ranks) if ranks fail.
    pub fn displacement(&self) -> Result<[Field; 2]> {
        let joint = self.state.contact.as_ref();
        if let Some(memory) = joint.filter(|_| self.state.is_joint()) {
            return memory.fields(self.grid());
        }
        tangential::displacement(&self.bodies, self.state.axes, self.traction())
    }

    /// Returns the sum of the signed slips of all steps (lengths).
    #[must_use]
    pub fn slip(&self) -> [&Field; 2] {
        self.state.slip()
    }

    /// Returns the accumulated slip, the length of the slip path in all steps (lengths, non-negative).
    #[must_use]
    pub fn accumulated_slip(&self) -> &Field {
        self.state.accumulated_slip()
    }

    /// Returns the energy that each cell has dissipated in all steps, the sum of [`StepResult::dissipated_energy`]
    /// (energies, force times length, non-negative).
    #[doc(alias = "dissipated energy")]
    #[must_use]
    pub fn dissipated_energy(&self) -> &Field {
        self.state.dissipated_energy()
    }

    /// Returns the zone of every cell after the last step, row-major with x fastest.
    #[must_use]
    pub fn zones(&self) -> &[Zone] {
        self.state.zones()
    }

    /// Returns the shift of body 2 relative to body 1 since the start (lengths).
    #[must_use]
    pub fn shift(&self) -> [f64; 2] {
        self.state.shift()
    }

    /// Returns the rotation of body 2 relative to body 1 since the start (radians).
    #[must_use]
    pub fn twist(&self) -> f64 {
        self.state.twist()
    }

    /// Returns the tangential force that body 2 exerts on body 1.
    #[must_use]
    pub fn tangential_force(&self) -> [f64; 2] {
        self.state.tangential_force()
    }

    /// Returns the largest tangential force that friction can carry at the present pressure (a force), the integral of
    /// the friction limit.
    #[must_use]
    pub fn friction_capacity(&self) -> f64 {
        let alone = || self.state.capacity_with(&self.bodies, self.friction());
        self.state.capacity.unwrap_or_else(alone)
    }

    /// Returns the moment of the tractions on body 1 about the origin of the grid (force times length, positive from x
    /// to y).
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.state.moment()
    }
}
