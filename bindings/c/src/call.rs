//! Entry point of every exported function.

use std::panic::{AssertUnwindSafe, catch_unwind};

use stickslip_rs::disable_global_pool;

use crate::environment::Environment;
use crate::error::{Failure, remember};
use crate::handle::{Opaque, cells_of};
use crate::status::{STICKSLIP_OK, STICKSLIP_PANIC, stickslip_status};
use crate::threads::enter;

/// Result of the body of an exported function.
pub(crate) type Outcome<T = ()> = Result<T, Failure>;

/// Runs the body of an exported function and returns its code; a failure is stored for the calling thread. Panics do not
/// unwind into C. The body runs in the default floating-point environment, and the environment of the caller is restored
/// afterwards.
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

/// Work that runs on another thread while the calling thread waits.
struct PanicPayload<F>(F);

// SAFETY: the pointers of a call follow the rule until the call ends, on every thread that works for the call.
unsafe impl<F> Send for PanicPayload<F> {}

impl<F: FnOnce() -> Outcome> PanicPayload<F> {
    fn run(self) -> Outcome {
        (self.0)()
    }
}

/// Like [`call`], but runs on the threads for the number of cells of an object, which is an argument of the exported
/// function.
pub(crate) fn call_on<T: Opaque>(
    object: *const T,
    work: impl FnOnce() -> Outcome,
) -> stickslip_status {
    // SAFETY: the object is an argument of a function whose safety contract is the rule for pointers.
    let cells = unsafe { cells_of(object) };
    let work = PanicPayload(work);
    call(move || enter(cells, move || work.run()))
}

/// Runs the body of an exported function that returns a pointer; returns NULL if the body fails.
pub(crate) fn call_for<T>(work: impl FnOnce() -> Outcome<*const T>) -> *const T {
    caught(work).unwrap_or_else(|failure| {
        remember(failure);
        std::ptr::null()
    })
}

/// Runs work and turns a panic into a failure. Work outside the threads of this interface stays on the calling thread,
/// because the threads that rayon would start itself do not survive a fork. After a panic, an object that was being
/// changed can still be freed, but its contents are no longer reliable.
pub(crate) fn caught<T>(work: impl FnOnce() -> Outcome<T>) -> Outcome<T> {
    disable_global_pool();
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|payload| {
        let text = payload.downcast_ref::<&str>().copied();
        let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
        let text = text.unwrap_or("no message");
        Err(Failure::new(
            STICKSLIP_PANIC,
            format!("internal error of the library: {text}"),
        ))
    })
}
