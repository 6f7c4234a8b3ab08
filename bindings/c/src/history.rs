//! Load histories: steps with memory of slip.

use stickslip_rs::history::EntryRule;
use stickslip_rs::stiffness::StiffnessWorkspace;
use stickslip_rs::{Axis, History, TryClone};

use crate::call::{Outcome, call, call_on};
use crate::cycle::stickslip_cycle;
use crate::error::Failure;
use crate::half_space::stickslip_half_space;
use crate::handle::{Changing, Handle, changing, free, give, opaque, reading};
use crate::inputs::{
    stickslip_friction, stickslip_per_cell, stickslip_relative_displacement, stickslip_settings,
    stickslip_settings_default,
};
use crate::loads::stickslip_load_step;
use crate::model::{STICKSLIP_FULL, STICKSLIP_SCALAR, coupling, model};
use crate::observer::{StepWatch, stickslip_observer, stickslip_step_observer, watch};
use crate::pointer::{Place, cells, field, input, optional};
use crate::reserved::known;
use crate::status::stickslip_status;
use crate::stiffness::stickslip_stiffness;
use crate::text_fields::tell;

/// Contact that is loaded step by step, with memory of slip. A failed step leaves the history bitwise unchanged. Fields are
/// read without a copy and remain valid until the next call that changes the history.
pub struct stickslip_history(Handle<History>);

opaque!(stickslip_history holds History, named "history");

/// Axis x.
pub const STICKSLIP_X: i32 = 0;
/// Axis y.
pub const STICKSLIP_Y: i32 = 1;

/// Entry rule: a cell that comes into contact within a step follows the motion from its first touch, proportionally to
/// the growth of its own pressure (default).
pub const STICKSLIP_SINCE_TOUCH: i32 = 0;
/// Entry rule: a cell that comes into contact within a step follows the whole motion of the step.
pub const STICKSLIP_WHOLE_STEP: i32 = 1;

/// Options of a history; stickslip_history_options_default() returns the defaults.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_history_options {
    /// Axis of load and traction in the scalar model: STICKSLIP_X (default) or STICKSLIP_Y.
    pub axis: i32,
    /// Model of the traction: STICKSLIP_SCALAR (default) or STICKSLIP_VECTOR.
    pub model: i32,
    /// Coupling of pressure and traction: STICKSLIP_FULL (default), STICKSLIP_ONE_WAY or STICKSLIP_NEGLECTED; relevant only
    /// for dissimilar bodies.
    pub coupling: i32,
    /// Entry rule: STICKSLIP_SINCE_TOUCH (default) or STICKSLIP_WHOLE_STEP.
    pub entry_rule: i32,
    /// Largest pressure that the cells can carry, or NULL (default, no limit).
    pub hardness: *const stickslip_per_cell,
    /// Nonzero if yielding leaves a permanent set (default 0); zero without a hardness.
    pub permanent_set: i32,
    /// Pattern of a displacement that the contact does not cause, or NULL (default). Each step prescribes a multiple of the
    /// pattern.
    pub relative_displacement: *const stickslip_relative_displacement,
    /// Method, tolerance and limits of the solves.
    pub settings: stickslip_settings,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Returns the default options of a history.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_history_options_default() -> stickslip_history_options {
    stickslip_history_options {
        axis: STICKSLIP_X,
        model: STICKSLIP_SCALAR,
        coupling: STICKSLIP_FULL,
        entry_rule: STICKSLIP_SINCE_TOUCH,
        hardness: std::ptr::null(),
        permanent_set: 0,
        relative_displacement: std::ptr::null(),
        settings: stickslip_settings_default(),
        reserved: [0; 8],
    }
}

/// Creates a history for a gap before loading (lengths, count entries, copied); the bodies do not touch before the first
/// step. options may be NULL (the defaults).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_new(
    half_space: *const stickslip_half_space,
    gap: *const f64,
    count: usize,
    friction: *const stickslip_friction,
    options: *const stickslip_history_options,
    history: *mut *mut stickslip_history,
) -> stickslip_status {
    call_on(half_space, || {
        // SAFETY: the caller follows the rule for pointers.
        let place = unsafe { Place::of_object("history", history)? };
        // SAFETY: the caller follows the rule for pointers.
        let (bodies, friction, options) = unsafe {
            let bodies = reading(half_space)?;
            let friction = input("friction", friction)?.checked(bodies.grid())?;
            (bodies, friction, optional("options", options)?)
        };
        let grid = bodies.grid();
        // SAFETY: the caller follows the rule for pointers.
        let gap = unsafe { field("gap", grid, gap, count)? };
        let mut builder = History::builder(&bodies, gap, friction);
        if let Some(options) = options {
            known("the options", &options.reserved)?;
            if options.hardness.is_null() {
                let reason = "hardness is NULL: set hardness, or permanent_set to zero";
                Failure::if_given("permanent_set", f64::from(options.permanent_set), reason)?;
            }
            builder = builder
                .axis(axis(options.axis)?)
                .model(model(options.model)?)
                .coupling(coupling(options.coupling)?)
                .entry_rule(entry_rule(options.entry_rule)?)
                .permanent_set(options.permanent_set != 0)
                .settings(options.settings.checked()?);
            // SAFETY: the caller follows the rule for pointers.
            unsafe {
                if let Some(limit) = optional("hardness of the options", options.hardness)? {
                    builder = builder.hardness(limit.hardness(grid)?);
                }
                let name = "relative_displacement of the options";
                if let Some(relative) = optional(name, options.relative_displacement)? {
                    builder = builder.relative_displacement(relative.checked(grid)?);
                }
            }
        }
        let made = builder.build()?;
        give(place, made, grid.cells())
    })
}

fn axis(value: i32) -> Outcome<Axis> {
    match value {
        STICKSLIP_X => Ok(Axis::X),
        STICKSLIP_Y => Ok(Axis::Y),
        other => Err(Failure::option("axis", other, "STICKSLIP_X or STICKSLIP_Y")),
    }
}

pub(crate) fn entry_rule(value: i32) -> Outcome<EntryRule> {
    match value {
        STICKSLIP_SINCE_TOUCH => Ok(EntryRule::SinceTouch),
        STICKSLIP_WHOLE_STEP => Ok(EntryRule::WholeStep),
        other => Err(Failure::option(
            "entry rule",
            other,
            "STICKSLIP_SINCE_TOUCH or STICKSLIP_WHOLE_STEP",
        )),
    }
}

/// Creates an independent copy of a history.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_clone(
    history: *const stickslip_history,
    copy: *mut *mut stickslip_history,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let place = Place::of_object("copy", copy)?;
        let history = reading(history)?;
        give(place, history.try_clone()?, history.grid().cells())
    })
}

/// Frees a history; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_free(
    history: *mut stickslip_history,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(history) })
}

/// Takes a step. observer may be NULL. A failure leaves the history unchanged; after STICKSLIP_NOT_CONVERGED,
/// stickslip_last_error_report writes the report.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_step(
    history: *mut stickslip_history,
    load: *const stickslip_load_step,
    observer: *const stickslip_observer,
) -> stickslip_status {
    call_on(history, || {
        // SAFETY: the caller follows the rule for pointers.
        let (mut history, load, observer) = unsafe {
            let (load, observer) = (input("load", load)?, optional("observer", observer)?);
            (changing(history)?, load.checked()?, watch(observer))
        };
        history.step_observed(&load, observer)?;
        Ok(())
    })
}

/// Applies a load in steps with equal growth of the contact, as many as a tolerance in (0, 1) requires, and writes
/// their number to taken (may be NULL). Press contacts of dissimilar bodies with this function or in several steps: a
/// single step issues a warning. The function applies the load in 1, 2, 4, 8, ... steps from the current state until
/// the change of the tractions is at most the tolerance times the friction limits. A tolerance of 0.01 is a good
/// choice. The argument observer may be NULL; it receives the iterations of all steps. After a failure, for example
/// STICKSLIP_STEP_TOO_LONG, the state of the history is unchanged. If the call has undone steps, the history has no
/// last step until its next step. After several steps, the result and the wear of the last step are those of the last one
/// alone; the field STICKSLIP_DISSIPATED_ENERGY contains the energy of all steps.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_press(
    history: *mut stickslip_history,
    load: *const stickslip_load_step,
    tolerance: f64,
    observer: *const stickslip_observer,
    taken: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let place = Place::if_asked("taken", taken)?;
        let (load, observer) = (input("load", load)?, optional("observer", observer)?);
        let (mut history, load, observer) = (changing(history)?, load.checked()?, watch(observer));
        let count = history.press_observed(&load, tolerance, observer)?;
        if let Some(place) = place {
            place.put(count);
        }
        Ok(())
    })
}

/// Applies a load in steps like stickslip_history_press, and writes their number to taken (may be NULL). Every accepted step is
/// added to cycle (may be NULL), and observer (may be NULL) receives its results. For this purpose the accepted steps are taken a
/// second time, with identical results. The cycle must start or end at the current state. After a failure the state of the
/// history is unchanged, but the cycle may contain undone steps: begin it again. Returns STICKSLIP_NOT_CONVERGED if the observer
/// ends the call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_press_stepwise(
    history: *mut stickslip_history,
    load: *const stickslip_load_step,
    tolerance: f64,
    cycle: *mut stickslip_cycle,
    observer: *const stickslip_step_observer,
    taken: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let place = Place::if_asked("taken", taken)?;
        let (load, observer) = (input("load", load)?, optional("observer", observer)?);
        let (mut history, load) = (changing(history)?, load.checked()?);
        let cycle = (!cycle.is_null()).then(|| changing(cycle)).transpose()?;
        let (unobserved, mut watch) = (watch(None), StepWatch::new(observer, cycle));
        let outcome = history.press_steps_observed(&load, tolerance, unobserved, |history| {
            watch.receive(history)
        });
        let count = watch.outcome(outcome)?;
        if let Some(place) = place {
            place.put(count);
        }
        Ok(())
    })
}

/// Sets the gap before loading (lengths, count entries, copied), for example after wear. The pressure does not change until
/// a step prescribes a normal load. Returns STICKSLIP_GAP_UNDER_LOAD for the gap under load of the present contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_set_gap(
    history: *mut stickslip_history,
    gap: *const f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let mut history: Changing<'_, History> = changing(history)?;
        let samples = cells("gap", history.grid(), gap, count)?;
        history
            .spare()
            .with_copy(history.grid(), samples, |gap| Ok(history.set_gap(gap)?))
    })
}

/// Sets the friction of the following steps.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_set_friction(
    history: *mut stickslip_history,
    friction: *const stickslip_friction,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let mut history = changing(history)?;
        let (grid, spare) = (history.grid(), history.spare());
        let set = |friction: &_| history.set_friction(friction);
        input("friction", friction)?.lend(grid, spare, set)
    })
}

/// Sets the method, the tolerance and the limits of the following steps.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_set_settings(
    history: *mut stickslip_history,
    settings: *const stickslip_settings,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let settings = input("settings", settings)?.checked()?;
        Ok(changing(history)?.set_settings(settings)?)
    })
}

/// Sets the pattern of the relative displacement of the following steps.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_set_relative_displacement(
    history: *mut stickslip_history,
    pattern: *const stickslip_relative_displacement,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let mut history = changing(history)?;
        let pattern = input("pattern", pattern)?.checked(history.grid())?;
        Ok(history.set_relative_displacement(&pattern)?)
    })
}

/// Computes the stiffness of the contact after the last step: normal stiffness, and tangential stiffness on loading and
/// at reversal. It is the derivative of the last step with respect to the motions at its end. Returns
/// STICKSLIP_OUTDATED_SOLUTION if the friction limits or the gap have changed since the last step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_stiffness(
    history: *const stickslip_history,
    stiffness: *mut stickslip_stiffness,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { stickslip_history_stiffness_observed(history, std::ptr::null(), stiffness) }
}

/// Computes the stiffness with an observer (may be NULL). The observer is called before every product with an operator and
/// may end the call: the function then returns STICKSLIP_NOT_CONVERGED and leaves stiffness unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_stiffness_observed(
    history: *const stickslip_history,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_stiffness,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(history, ("stiffness", stiffness), |of| {
            let observer = optional("observer", observer)?;
            Ok(of.stiffness_observed(watch(observer))?.into())
        })
    }
}

/// Computes the stiffness of the next step from the current state. In the members loading and by_approach, stick cells
/// resist fully, including those that came into contact in the last step, and cells at their friction limit continue to
/// slip. Use this stiffness to shear the contact further under the same normal load. observer may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_next_stiffness(
    history: *const stickslip_history,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_stiffness,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(history, ("stiffness", stiffness), |of| {
            let observer = optional("observer", observer)?;
            let mut workspace = StiffnessWorkspace::new().next_step(true);
            Ok(of.stiffness_with(&mut workspace, watch(observer))?.into())
        })
    }
}
