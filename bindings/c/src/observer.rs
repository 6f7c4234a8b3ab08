//! Observer of a solve, which may end it.

use std::ffi::c_void;
use std::ops::ControlFlow;

use stickslip_rs::Iteration;

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
