//! Schemes that solve the steps of a history: pressure and traction one after the other, or together.

use std::ops::{Deref, DerefMut};

use crate::contact::LoadTrend;
use crate::coupled::CoupledIncrement;
use crate::error::Result;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::state::State;
use crate::history::step::sequential::SequentialSolver;
use crate::history::step::solve::StepInput;
use crate::memory::pool::PooledBuffer;
use crate::normal::NormalSolution;
use crate::observer::Observer;
use crate::report::Report;
use crate::tangential::{RigidMotion, StepSolution};

/// Solver of the steps of a history.
pub(in crate::history) trait StepSolver {
    /// Solves a step and returns the motion of body 2 at its end. A new pressure is written to `normal`. The solve may widen the
    /// window of the memory, and leaves the rest of the state unchanged.
    fn solve(
        &mut self,
        bodies: &HalfSpace,
        step: &StepInput<'_>,
        state: &mut State,
        normal: &mut PooledBuffer<NormalSolution>,
        observer: Observer<'_>,
    ) -> Result<RigidMotion>;

    /// Returns the tractions of the last step, or `None` before the first contact.
    fn solution(&self) -> Option<StepSolution<'_>>;

    /// Returns the report of the last solve.
    fn report(&self) -> &Report;

    /// Returns the window of the pressure, or `None` before the first contact.
    fn window(&self) -> Option<Window>;

    /// Makes the solver continue from a state. Existing buffers are reused if they belong to the window of the state.
    fn resume(&mut self, bodies: &HalfSpace, state: &State) -> Result<()>;

    /// Writes the change of the pressure with the load.
    fn write_trend(&self, _: &mut LoadTrend<1>) {}

    /// Returns the lift due to the tractions of a rolled step that the pressure ignores, in millionths of the normal
    /// displacement. Returns `None` if the lift is within the tolerance.
    fn neglected_lift(&self) -> Option<usize> {
        None
    }

    /// Returns the buffers of a finished step to their pools.
    fn release(&mut self) {}
}

/// Scheme of the steps of a history.
#[derive(Clone)]
pub(in crate::history) enum Scheme {
    /// Solves for the pressure, then for the tractions under this pressure.
    Sequential(Box<SequentialSolver>),
    /// Solves for pressure and tractions together.
    Coupled(Box<CoupledIncrement>),
}

impl Default for Scheme {
    fn default() -> Self {
        Self::Sequential(Box::default())
    }
}

impl Scheme {
    /// Returns whether the scheme can solve the steps of a state.
    pub(in crate::history) fn is_for(&self, state: &State) -> bool {
        matches!(self, Self::Coupled(_)) == state.is_joint()
    }

    /// Makes the scheme continue from a state. Selects the other scheme if the state requires it.
    pub(in crate::history) fn continue_from(
        &mut self,
        bodies: &HalfSpace,
        state: &State,
    ) -> Result<()> {
        if !self.is_for(state) {
            *self = match self {
                Self::Sequential(_) => Self::Coupled(Box::new(CoupledIncrement::new(bodies)?)),
                Self::Coupled(_) => Self::default(),
            };
        }
        self.resume(bodies, state)
    }
}

impl Deref for Scheme {
    type Target = dyn StepSolver;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Sequential(solver) => &**solver,
            Self::Coupled(solver) => &**solver,
        }
    }
}

impl DerefMut for Scheme {
    fn deref_mut(&mut self) -> &mut Self::Target {
        match self {
            Self::Sequential(solver) => &mut **solver,
            Self::Coupled(solver) => &mut **solver,
        }
    }
}
