//! Buffers for stiffnesses that are computed repeatedly.

use stickslip_rs::stiffness::StiffnessWorkspace;

use crate::call::{Outcome, call, call_on};
use crate::handle::{Handle, changing, free, give, opaque, reading};
use crate::history::stickslip_history;
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{Place, input, optional};
use crate::reserved::known;
use crate::results::stickslip_report;
use crate::status::stickslip_status;
use crate::stiffness::stickslip_stiffness;
use crate::text_fields::tell;

/// Buffers, options and report of stiffnesses that are computed repeatedly, for example in a Newton iteration. The first
/// stiffness allocates. Later stiffnesses allocate only for other bodies, another size of the window, or more cells or steps
/// than before.
pub struct stickslip_stiffness_workspace(Handle<StiffnessWorkspace>);

opaque!(stickslip_stiffness_workspace holds StiffnessWorkspace, named "stiffness workspace");

/// Options of a stiffness; stickslip_stiffness_options_default() returns the defaults.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_stiffness_options {
    /// Relative residual at which the linear problems count as solved, between 0 and 1 (default 1e-11). The error of a
    /// stiffness is of the order of the square of this residual.
    pub tolerance: f64,
    /// Nonzero (default 1) to compute the stiffness at reversal. Zero halves the cost, and the entries at reversal are NaN.
    pub reversal: i32,
    /// Nonzero for the stiffness of the next step, like stickslip_history_next_stiffness; zero (default) for the last step.
    pub next_step: i32,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl stickslip_stiffness_options {
    /// Sets the options of a workspace, which keeps its buffers. Invalid options leave the workspace unchanged.
    fn apply(&self, workspace: &mut StiffnessWorkspace) -> Outcome {
        known("the options of a stiffness", &self.reserved)?;
        StiffnessWorkspace::new().tolerance(self.tolerance)?;
        *workspace = std::mem::take(workspace)
            .tolerance(self.tolerance)?
            .reversal(self.reversal != 0)
            .next_step(self.next_step != 0);
        Ok(())
    }
}

/// Returns the default options of a stiffness.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_stiffness_options_default() -> stickslip_stiffness_options {
    stickslip_stiffness_options {
        tolerance: 1e-11,
        reversal: 1,
        next_step: 0,
        reserved: [0; 8],
    }
}

/// Creates a workspace without buffers, for histories on any grid. options may be NULL (the defaults).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_stiffness_workspace_new(
    options: *const stickslip_stiffness_options,
    workspace: *mut *mut stickslip_stiffness_workspace,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe {
        let place = Place::of_object("workspace", workspace)?;
        let mut made = StiffnessWorkspace::new();
        if let Some(options) = optional("options", options)? {
            options.apply(&mut made)?;
        }
        give(place, made, 0)
    })
}

/// Frees a workspace; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_stiffness_workspace_free(
    workspace: *mut stickslip_stiffness_workspace,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(workspace) })
}

/// Sets the options of the next stiffness. The workspace keeps its buffers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_stiffness_workspace_set_options(
    workspace: *mut stickslip_stiffness_workspace,
    options: *const stickslip_stiffness_options,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(workspace, || unsafe {
        input("options", options)?.apply(&mut *changing(workspace)?)
    })
}

/// Writes the report of the last stiffness. Iterations and products are the sums over all linear problems. Residual and
/// status belong to the last problem. The time is not measured.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_stiffness_workspace_report(
    workspace: *const stickslip_stiffness_workspace,
    report: *mut stickslip_report,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(workspace, ("report", report), |of| Ok(of.report().into())) }
}

/// Computes the stiffness like stickslip_history_stiffness_observed, with the options and the buffers of a workspace. A call
/// that needs no larger buffers than the last one allocates nothing. observer may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_stiffness_with(
    history: *const stickslip_history,
    workspace: *mut stickslip_stiffness_workspace,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_stiffness,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let place = Place::new("stiffness", stiffness)?;
        let observer = optional("observer", observer)?;
        let history = reading(history)?;
        let mut workspace = changing(workspace)?;
        let found = history.stiffness_with(&mut workspace, watch(observer))?;
        place.put(found.into());
        Ok(())
    })
}
