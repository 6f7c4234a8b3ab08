//! The border: what every exported function runs in.

use std::panic::{AssertUnwindSafe, catch_unwind};

use stickslip_rs::disable_global_pool;

use crate::environment::Environment;
use crate::error::{Failure, remember};
use crate::handle::{Opaque, cells_of};
use crate::status::{STICKSLIP_OK, STICKSLIP_PANIC, stickslip_status};
use crate::threads::enter;

/// What the inside of a function comes to.
pub(crate) type Outcome<T = ()> = Result<T, Failure>;

/// Runs the inside of a function: a failure is remembered for this thread and becomes its code. Nothing unwinds into C, and
/// what the caller has set of floating-point arithmetic is neither met nor changed.
pub(crate) fn call(work: impl FnOnce() -> Outcome) -> stickslip_status {
    let _environment = Environment::enter();
    match caught(work) {
        Ok(()) => STICKSLIP_OK,
        Err(failure) => {
            let code = failure.code;
            remember(failure);
            code
        }
    }
}

/// What is carried to another thread, while this one waits.
struct PanicPayload<F>(F);

// SAFETY: the pointers of a call obey the rule until it ends, whichever thread does its work.
unsafe impl<F> Send for PanicPayload<F> {}

impl<F: FnOnce() -> Outcome> PanicPayload<F> {
    fn run(self) -> Outcome {
        (self.0)()
    }
}

/// The same on the threads for an object of so many cells, which is an argument of the function.
pub(crate) fn call_on<T: Opaque>(
    object: *const T,
    work: impl FnOnce() -> Outcome,
) -> stickslip_status {
    // SAFETY: an argument of a function that asks for the rule for pointers.
    let cells = unsafe { cells_of(object) };
    let work = PanicPayload(work);
    call(move || enter(cells, move || work.run()))
}

/// The same for a function that returns a pointer, NULL if it fails.
pub(crate) fn call_for<T>(work: impl FnOnce() -> Outcome<*const T>) -> *const T {
    caught(work).unwrap_or_else(|failure| {
        remember(failure);
        std::ptr::null()
    })
}

/// Work outside of the threads of this interface stays on the thread that calls: rayon's own, which it would start, do not
/// live on in a forked process. A panic is a failure of its own. What was being changed is not trusted to be whole, but safe to be freed.
pub(crate) fn caught<T>(work: impl FnOnce() -> Outcome<T>) -> Outcome<T> {
    disable_global_pool();
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|payload| {
        let text = payload.downcast_ref::<&str>().copied();
        let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
        let text = text.unwrap_or("no message");
        Err(Failure::new(
            STICKSLIP_PANIC,
            format!("a defect of the library: {text}"),
        ))
    })
}
