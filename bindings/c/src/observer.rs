//! What watches a solve and may end it.

use std::ffi::c_void;
use std::ops::ControlFlow;

use stickslip_rs::Iteration;

/// One step of an iteration.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_iteration {
    /// Conjugate-gradient steps so far.
    pub iteration: usize,
    /// Products in double precision so far.
    pub double_precision_products: usize,
    /// Products in single precision so far.
    pub single_precision_products: usize,
    /// Largest complementarity residual, relative to the largest displacement, as last measured.
    pub residual: f64,
    /// Contact cells of a normal problem, sticking cells of a tangential one.
    pub free: usize,
    /// Room for members to come: zero.
    pub reserved: [u64; 8],
}

/// Called before every product with the operator, also on the coarser grids of a start: returns 0 to end the solve, any other
/// number to continue. It is called by one thread at a time, on more than 4096 cells possibly another than that which called the
/// solve. It must not unwind or jump out, nor call functions with handles that the solve uses (STICKSLIP_BUSY).
pub type stickslip_observe =
    Option<unsafe extern "C" fn(iteration: *const stickslip_iteration, user: *mut c_void) -> i32>;

/// A function that watches a solve, with data of yours.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_observer {
    /// The function; NULL watches nothing.
    pub observe: stickslip_observe,
    /// Passed to the function as it is.
    pub user: *mut c_void,
}

// SAFETY: the header says that the function may be called by another thread, and the caller has agreed.
unsafe impl Send for stickslip_observer {}

/// The observer as the crate calls it.
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
        // SAFETY: the caller's function, called as its type says.
        match unsafe { observe(&raw const iteration, user) } {
            0 => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        }
    }
}
