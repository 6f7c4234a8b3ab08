//! What a history tells of its state.

use std::ops::ControlFlow;

use crate::cgm::Settings;
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::history::{History, StepResult};
use crate::normal::NormalSolution;
use crate::numerics::cell_vector::slices;
use crate::observer::unwatched;
use crate::report::Iteration;
use crate::stiffness::{ContactStiffness, Coupled, LastStep, Pressed, Sheared, StiffnessWorkspace};
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

    /// The stiffness of the contact: normal, tangential on loading and at reversal, and of the tangential load by the
    /// approach; see [`crate::stiffness`].
    ///
    /// Loading is the derivative of the force of the last step by its motion, the sets held. In the vector model the slip
    /// of that step adds to the stiffness of cells that slip. The cells that [entered](crate::guide::growing_contacts) the
    /// contact in that step follow the motion by a compliance of their own. The [state](Self::state) keeps both, so that
    /// the stiffness after [`set_state`](Self::set_state) or a restart has the same bits. Cells that come into contact
    /// during further motion are not included.
    ///
    /// The stiffness of the next step is an option of [`stiffness_with`](Self::stiffness_with):
    /// [`StiffnessWorkspace::next_step`].
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) where a periodic contact is closed everywhere,
    /// [`Error::NotConverged`](crate::Error::NotConverged), as [`HalfSpace::operator`](crate::HalfSpace::operator).
    #[doc(alias = "tangential stiffness")]
    #[doc(alias = "jacobian")]
    #[doc(alias = "tangent")]
    #[doc(alias = "slope")]
    pub fn stiffness(&self) -> Result<ContactStiffness> {
        self.stiffness_observed(unwatched)
    }

    /// [`stiffness`](Self::stiffness) with an observer that is asked before every product with an operator and may cancel;
    /// the residual it sees is that of the linear problem under way.
    ///
    /// # Errors
    /// As [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &self,
        observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<ContactStiffness> {
        self.stiffness_with(&mut StiffnessWorkspace::new(), observer)
    }

    /// [`stiffness_observed`](Self::stiffness_observed) in buffers that are kept: after the first time without allocations,
    /// to its tolerance, with a report.
    ///
    /// # Errors
    /// As [`stiffness`](Self::stiffness).
    pub fn stiffness_with(
        &self,
        workspace: &mut StiffnessWorkspace,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<ContactStiffness> {
        let (pair, grid) = (self.bodies.pair(), self.grid());
        let memory = self.state.contact.as_ref();
        // Without contact there is no memory, and in the next step no cell has slipped or entered yet.
        let step = memory.filter(|_| !workspace.is_of_next_step());
        let window = memory.map_or(Window::whole(grid), |memory| memory.window);
        let last = LastStep {
            window: window.held(grid),
            slip: step.map_or([&[]; 2], |memory| slices(&memory.slip)),
            entered: step.map_or(&[], |memory| &memory.entered),
        };
        if self.state.is_joint() {
            let coupled = Coupled {
                pressure: self.pressure(),
                traction: self.traction(),
                slip: step.map(|_| last.slip),
                entered: last.entered,
                friction: self.friction(),
                hardness: self.state.hardness.as_ref(),
                window: self.state.press_window,
            };
            return coupled.stiffness(&self.bodies, workspace, &mut observer);
        }
        let sheared = Sheared {
            zones: self.zones(),
            traction: self.traction(),
            last,
            window: memory.map(|memory| memory.window),
        };
        let pressed = Pressed {
            normal: self.normal(),
            window: self.state.press_window,
            friction: self.friction(),
            hardness: self.state.hardness.as_ref(),
            is_drawn: self.state.coupling.is_one_way(pair),
        };
        let (bodies, axis) = (&self.bodies, self.axis());
        ContactStiffness::of(bodies, &pressed, &sheared, axis, workspace, &mut observer)
    }

    /// Moment about z, at the origin of the grid, that the tractions of body 2 exert on body 1.
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.state.moment()
    }
}
