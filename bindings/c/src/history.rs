//! Histories: steps with memory of slip.

use stickslip_rs::history::EntryRule;
use stickslip_rs::stiffness::StiffnessWorkspace;
use stickslip_rs::{Axis, History, TryClone};

use crate::call::{Outcome, call, call_on};
use crate::error::Failure;
use crate::half_space::stickslip_half_space;
use crate::handle::{Changing, Handle, changing, free, give, opaque, reading};
use crate::inputs::{
    stickslip_friction, stickslip_per_cell, stickslip_relative_displacement, stickslip_settings,
    stickslip_settings_default,
};
use crate::loads::stickslip_load_step;
use crate::model::{STICKSLIP_FULL, STICKSLIP_SCALAR, coupling, model};
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{Place, cells, field, input, optional};
use crate::reserved::known;
use crate::status::stickslip_status;
use crate::stiffness::stickslip_stiffness;
use crate::text_fields::tell;

/// A contact that is loaded step by step, with memory of slip. A step that fails leaves it bit for bit as it was. Its
/// fields are read without a copy, and are valid until the next call that changes it.
pub struct stickslip_history(Handle<History>);

opaque!(stickslip_history holds History, named "history");

/// Along x.
pub const STICKSLIP_X: i32 = 0;
/// Along y.
pub const STICKSLIP_Y: i32 = 1;

/// A cell that touches within a step follows its motion as far as it would if all that grows stuck (default).
pub const STICKSLIP_SINCE_TOUCH: i32 = 0;
/// It follows all of the motion of the step.
pub const STICKSLIP_WHOLE_STEP: i32 = 1;

/// Options of a history; stickslip_history_options_default() has the defaults.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_history_options {
    /// Axis of load and traction in the scalar model: STICKSLIP_X (default) or STICKSLIP_Y.
    pub axis: i32,
    /// STICKSLIP_SCALAR (default) or STICKSLIP_VECTOR.
    pub model: i32,
    /// STICKSLIP_FULL (default), STICKSLIP_ONE_WAY or STICKSLIP_NEGLECTED; of meaning for dissimilar bodies only.
    pub coupling: i32,
    /// STICKSLIP_SINCE_TOUCH (default) or STICKSLIP_WHOLE_STEP.
    pub entry_rule: i32,
    /// Largest pressure that the cells carry, or NULL (default).
    pub hardness: *const stickslip_per_cell,
    /// Not zero if what yields stays (default 0).
    pub permanent_set: i32,
    /// Pattern of a displacement that the contact does not cause, or NULL (default); steps reach an amount of it.
    pub relative_displacement: *const stickslip_relative_displacement,
    /// Method, tolerance and limits.
    pub settings: stickslip_settings,
    /// Room for members to come: zero.
    pub reserved: [u64; 8],
}

/// The options that histories have by default.
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

/// Makes a history of a gap before loading (lengths, count entries, copied); nothing touches before the first step. options
/// may be NULL (the defaults).
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
        // SAFETY: the rule for pointers.
        let place = unsafe { Place::new("history", history)? };
        // SAFETY: the rule for pointers.
        let (bodies, friction, options) = unsafe {
            let bodies = reading(half_space)?;
            let friction = input("friction", friction)?.checked(bodies.grid())?;
            (bodies, friction, optional("options", options)?)
        };
        let grid = bodies.grid();
        // SAFETY: the rule for pointers.
        let gap = unsafe { field("gap", grid, gap, count)? };
        let mut builder = History::builder(&bodies, gap, friction);
        if let Some(options) = options {
            known("the options", &options.reserved)?;
            builder = builder
                .axis(axis(options.axis)?)
                .model(model(options.model)?)
                .coupling(coupling(options.coupling)?)
                .entry_rule(entry_rule(options.entry_rule)?)
                .permanent_set(options.permanent_set != 0)
                .settings(options.settings.checked()?);
            // SAFETY: the rule for pointers.
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
        other => Err(Failure::option("axis", other)),
    }
}

pub(crate) fn entry_rule(value: i32) -> Outcome<EntryRule> {
    match value {
        STICKSLIP_SINCE_TOUCH => Ok(EntryRule::SinceTouch),
        STICKSLIP_WHOLE_STEP => Ok(EntryRule::WholeStep),
        other => Err(Failure::option("entry rule", other)),
    }
}

/// Makes a copy of a history, independent of it: steps of one do not change the other.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_clone(
    history: *const stickslip_history,
    copy: *mut *mut stickslip_history,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(history, || unsafe {
        let place = Place::new("copy", copy)?;
        let history = reading(history)?;
        give(place, history.try_clone()?, history.grid().cells())
    })
}

/// Frees a history; nothing for NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_free(
    history: *mut stickslip_history,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call(|| unsafe { free(history) })
}

/// Takes a step. observer may be NULL. After a failure the history is as it was; after STICKSLIP_NOT_CONVERGED
/// stickslip_last_error_report has the report.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_step(
    history: *mut stickslip_history,
    load: *const stickslip_load_step,
    observer: *const stickslip_observer,
) -> stickslip_status {
    call_on(history, || {
        // SAFETY: the rule for pointers.
        let (mut history, load, observer) = unsafe {
            let (load, observer) = (input("load", load)?, optional("observer", observer)?);
            (changing(history)?, load.checked()?, watch(observer))
        };
        history.step_observed(&load, observer)?;
        Ok(())
    })
}

/// Takes a load in as many steps of equal growth of the contact as a tolerance in (0, 1) needs, and writes their number to
/// taken (may be NULL). A contact of dissimilar bodies must be pressed so. It takes the load in 1, 2, 4, 8, ... steps from the
/// present state, until the tractions change by no more than the tolerance times the friction limits: 0.01 is a good choice.
/// observer may be NULL; it receives the iterations of all steps. After a failure, which may be STICKSLIP_STEP_TOO_LONG, the
/// state of the history is unchanged; its last step is the last one that succeeded.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_press(
    history: *mut stickslip_history,
    load: *const stickslip_load_step,
    tolerance: f64,
    observer: *const stickslip_observer,
    taken: *mut usize,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
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

/// Changes the gap before loading (lengths, count entries, copied), as wear does. The pressure stays until a step that
/// gives a normal load again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_set_gap(
    history: *mut stickslip_history,
    gap: *const f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(history, || unsafe {
        let mut history: Changing<'_, History> = changing(history)?;
        let samples = cells("gap", history.grid(), gap, count)?;
        history
            .spare()
            .with_copy(history.grid(), samples, |gap| Ok(history.set_gap(gap)?))
    })
}

/// Changes the friction from the next step on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_set_friction(
    history: *mut stickslip_history,
    friction: *const stickslip_friction,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(history, || unsafe {
        let mut history = changing(history)?;
        let (grid, spare) = (history.grid(), history.spare());
        let set = |friction: &_| history.set_friction(friction);
        input("friction", friction)?.lend(grid, spare, set)
    })
}

/// Changes method, tolerance and limits from the next step on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_set_settings(
    history: *mut stickslip_history,
    settings: *const stickslip_settings,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(history, || unsafe {
        let settings = input("settings", settings)?.checked()?;
        Ok(changing(history)?.set_settings(settings)?)
    })
}

/// Changes the pattern of the relative displacement from the next step on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_set_relative_displacement(
    history: *mut stickslip_history,
    pattern: *const stickslip_relative_displacement,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(history, || unsafe {
        let mut history = changing(history)?;
        let pattern = input("pattern", pattern)?.checked(history.grid())?;
        Ok(history.set_relative_displacement(&pattern)?)
    })
}

/// The stiffness of the contact after the last step: normal, tangential on loading and at reversal.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_stiffness(
    history: *const stickslip_history,
    stiffness: *mut stickslip_stiffness,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { stickslip_history_stiffness_observed(history, std::ptr::null(), stiffness) }
}

/// The same with an observer (may be NULL), which is called before every product with an operator and may end it:
/// STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_stiffness_observed(
    history: *const stickslip_history,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_stiffness,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        tell(history, ("stiffness", stiffness), |of| {
            let observer = optional("observer", observer)?;
            Ok(of.stiffness_observed(watch(observer))?.into())
        })
    }
}

/// The stiffness of a next step that starts from the present state. In loading and by_approach cells that stick resist fully,
/// also those that came into contact in the last step, and cells at their limit continue to slip. A host that shears the contact
/// further under the same normal load needs this. observer may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_next_stiffness(
    history: *const stickslip_history,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_stiffness,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        tell(history, ("stiffness", stiffness), |of| {
            let observer = optional("observer", observer)?;
            let mut workspace = StiffnessWorkspace::new().next_step(true);
            Ok(of.stiffness_with(&mut workspace, watch(observer))?.into())
        })
    }
}
