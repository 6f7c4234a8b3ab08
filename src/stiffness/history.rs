//! Stiffness of the contact of a history.

use std::ops::ControlFlow;

use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::history::{History, State};
use crate::numerics::cell_vector::slices;
use crate::observer::unwatched;
use crate::report::Iteration;
use crate::stiffness::contact::SolvedContact;
use crate::stiffness::{ContactStiffness, StiffnessWorkspace};

impl History {
    /// Computes the stiffness of the contact (see [`crate::stiffness`]). The result contains the normal stiffness and the
    /// tangential stiffness on loading and at reversal. It also contains the derivatives of the tangential loads with respect to
    /// the approach.
    ///
    /// The loading stiffness belongs to the last step. It is the derivative of the force with respect to the motion of this
    /// step, at fixed sets. In the vector model the slip of this step adds to the stiffness of slipping cells. Cells that [came
    /// into contact](crate::guide::load_steps) in that step follow the motion with their entry compliance. The
    /// [state](Self::state) contains slip and entry compliance. The stiffness after [`set_state`](Self::set_state) or a restart
    /// is therefore bitwise identical. Cells that come into contact during further motion are not included.
    ///
    /// The stiffness of the next step is an option of [`stiffness_with`](Self::stiffness_with):
    /// [`StiffnessWorkspace::next_step`].
    ///
    /// Both stiffnesses belong to the solution of the last step. Both are an error until the next step after
    /// [`set_friction`](Self::set_friction) has changed the friction limits, or
    /// [`set_relative_displacement`](Self::set_relative_displacement) the relative displacement. After
    /// [`set_gap`](Self::set_gap) has changed the gap, both are an error until a step prescribes the normal load.
    ///
    /// # Errors
    /// - [`Error::OutdatedSolution`] if the friction, the gap or the relative displacement has changed since the last step.
    /// - [`Error::NotFinite`] if a periodic contact is closed everywhere.
    /// - [`Error::NotConverged`] if a linear solve fails or is cancelled.
    /// - The errors of [`HalfSpace::operator`](crate::HalfSpace::operator).
    #[doc(alias = "tangential stiffness")]
    #[doc(alias = "jacobian")]
    #[doc(alias = "tangent")]
    #[doc(alias = "slope")]
    pub fn stiffness(&self) -> Result<ContactStiffness> {
        self.stiffness_observed(unwatched)
    }

    /// Computes the [`stiffness`](Self::stiffness) with an observer. The observer is called before every product with an
    /// operator and may cancel. The reported residual is the residual of the current linear problem.
    ///
    /// # Errors
    /// The errors of [`stiffness`](Self::stiffness).
    pub fn stiffness_observed(
        &self,
        observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<ContactStiffness> {
        self.stiffness_with(&mut StiffnessWorkspace::new(), observer)
    }

    /// Computes the stiffness like [`stiffness_observed`](Self::stiffness_observed), with the tolerance of a workspace. The
    /// workspace stores the report and the buffers, so that later calls do not allocate.
    ///
    /// # Errors
    /// The errors of [`stiffness`](Self::stiffness).
    pub fn stiffness_with(
        &self,
        workspace: &mut StiffnessWorkspace,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<ContactStiffness> {
        self.bodies
            .collective_result(self.state.check_current("stiffness"))?;
        let contact = self.solved_contact(workspace.is_of_next_step());
        let pressing = (self.normal(), self.friction());
        if self.state.is_joint() {
            contact.coupled_stiffness(pressing, workspace, &mut observer)
        } else {
            contact.stiffness(pressing, workspace, &mut observer)
        }
    }

    /// Returns the contact with the states of the cells in the last step, or at the start of the next step.
    pub(crate) fn solved_contact(&self, is_of_next_step: bool) -> SolvedContact<'_> {
        let grid = self.grid();
        let memory = self.state.contact.as_ref();
        // Without contact the state contains no last step. In the stiffness of the next step, no cell has slipped or come into
        // contact yet.
        let step = memory.filter(|_| !is_of_next_step);
        let window = memory.map_or(Window::whole(grid), |memory| memory.window);
        SolvedContact {
            hardness: self.state.hardness.as_ref(),
            axis: self.axis(),
            zones: self.zones(),
            traction: self.traction().map(Field::as_slice),
            slip: step.map_or([&[]; 2], |memory| slices(&memory.slip)),
            entered: step.map_or(&[], |memory| &memory.entered),
            last_window: window.held(grid),
            windows: [self.state.press_window, memory.map(|memory| memory.window)],
            is_drawn: self.state.coupling.is_one_way(self.bodies.pair()),
            ..SolvedContact::of(&self.bodies)
        }
    }
}

impl State {
    /// Returns an error if friction, gap or relative displacement have changed since the tractions and the pressure were
    /// solved for.
    pub(crate) fn check_current(&self, quantity: &'static str) -> Result<()> {
        if self.is_pressure_stale() {
            return Err(Error::OutdatedSolution {
                quantity,
                changed: "the gap",
                remedy: "take a step with a prescribed normal load first",
            });
        }
        if self.is_relative_new() {
            return Err(Error::OutdatedSolution {
                quantity,
                changed: "the relative displacement",
                remedy: "take a step first",
            });
        }
        self.check_friction(quantity)
    }

    /// Returns an error if the friction has changed since the tractions were solved for.
    pub(crate) fn check_friction(&self, quantity: &'static str) -> Result<()> {
        if self.is_friction_new() {
            return Err(Error::OutdatedSolution {
                quantity,
                changed: "the friction",
                remedy: "take a step first",
            });
        }
        Ok(())
    }
}
