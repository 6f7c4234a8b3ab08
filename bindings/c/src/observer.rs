//! Observer of a solve, which may end it.

use std::ffi::c_void;
use std::ops::ControlFlow;

use stickslip_rs::history::Cycle;
use stickslip_rs::{Error, History, Iteration, Result};

use crate::call::Outcome;
use crate::error::Failure;
use crate::handle::Changing;
use crate::history_reading::stickslip_step_result;
use crate::status::STICKSLIP_NOT_CONVERGED;

/// Progress of an iteration.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_iteration {
    /// Number of conjugate-gradient iterations so far.
    pub iteration: usize,
    /// Number of products in double precision so far.
    pub double_precision_products: usize,
    /// Number of products in single precision so far.
    pub single_precision_products: usize,
    /// Last measured value of the largest complementarity residual, relative to the largest displacement.
    pub residual: f64,
    /// Number of contact cells of a normal problem, or of stick cells of a tangential problem.
    pub free: usize,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Function that is called before every product with the operator, also on the coarser grids of a nested start. It
/// returns 0 to end the solve and any non-zero value to continue. Only one thread calls it at a time; on more than 4096
/// cells this thread may differ from the thread that started the solve. The function must not unwind or jump out, and
/// must not call functions with handles that the solve uses (STICKSLIP_BUSY).
pub type stickslip_observe =
    Option<unsafe extern "C" fn(iteration: *const stickslip_iteration, user: *mut c_void) -> i32>;

/// Observer of a solve: a function with data of the caller.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_observer {
    /// Function; NULL for no observer.
    pub observe: stickslip_observe,
    /// Data passed unchanged to the function.
    pub user: *mut c_void,
}

// SAFETY: the header states that another thread may call the function, and the caller accepts this.
unsafe impl Send for stickslip_observer {}

/// Converts the observer to a closure for the crate.
pub(crate) fn watch(
    observer: Option<&stickslip_observer>,
) -> impl FnMut(&Iteration) -> ControlFlow<()> + Send + use<> {
    let observer = observer.copied();
    move |iteration| {
        let watched = observer.as_ref();
        let Some((observe, user)) = watched.and_then(|it| Some((it.observe?, it.user))) else {
            return ControlFlow::Continue(());
        };
        let iteration = stickslip_iteration {
            iteration: iteration.iteration,
            double_precision_products: iteration.double_precision_products,
            single_precision_products: iteration.single_precision_products,
            residual: iteration.residual,
            free: iteration.free,
            reserved: [0; 8],
        };
        // SAFETY: the function of the caller is called according to its type.
        match unsafe { observe(&raw const iteration, user) } {
            0 => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        }
    }
}

/// Function that is called after every accepted step of a load that is taken in several steps, in their order. It receives
/// the results of the step. It returns 0 to end the call, which then undoes all steps, and any non-zero value to continue. The
/// function must not unwind or jump out, and must not call functions with the history or the cycle of the call
/// (STICKSLIP_BUSY). It may run on a different thread than the call.
pub type stickslip_observe_step =
    Option<unsafe extern "C" fn(step: *const stickslip_step_result, user: *mut c_void) -> i32>;

/// Observer of the accepted steps of a load: a function with data of the caller.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_step_observer {
    /// Function; NULL for no observer.
    pub observe: stickslip_observe_step,
    /// Data passed unchanged to the function.
    pub user: *mut c_void,
}

// SAFETY: the header states that another thread may call the function, and the caller accepts this.
unsafe impl Send for stickslip_step_observer {}

/// Receiver of the accepted steps of a load, with a cycle to which they are added.
pub(crate) struct StepWatch<'a> {
    observer: Option<stickslip_step_observer>,
    cycle: Option<Changing<'a, Cycle>>,
    has_ended: bool,
}

impl<'a> StepWatch<'a> {
    pub(crate) fn new(
        observer: Option<&stickslip_step_observer>,
        cycle: Option<Changing<'a, Cycle>>,
    ) -> Self {
        Self {
            observer: observer.copied(),
            cycle,
            has_ended: false,
        }
    }

    /// Adds a step to the cycle and calls the observer.
    pub(crate) fn receive(&mut self, history: &History) -> Result<()> {
        if let Some(cycle) = &mut self.cycle {
            cycle.add(history)?;
        }
        let observer = self.observer.as_ref();
        let Some((observe, user)) = observer.and_then(|it| Some((it.observe?, it.user))) else {
            return Ok(());
        };
        let step = stickslip_step_result::from(history);
        // SAFETY: the function of the caller is called according to its type.
        self.has_ended = unsafe { observe(&raw const step, user) } == 0;
        // Any error ends the call. `outcome` replaces it.
        if self.has_ended {
            Err(Error::EmptyPath)
        } else {
            Ok(())
        }
    }

    /// Returns the number of steps, or the failure of a call that the observer ended.
    pub(crate) fn outcome(&self, steps: Result<usize>) -> Outcome<usize> {
        if self.has_ended {
            let message = "the observer ended the call: all its steps were undone".to_owned();
            return Err(Failure::new(STICKSLIP_NOT_CONVERGED, message));
        }
        Ok(steps?)
    }
}
