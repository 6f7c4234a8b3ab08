//! Tangential contact under a pressure that is given.

use stickslip_rs::{PressureSource, TangentialProblem, TangentialSolution, TangentialSolver, Zone};

use crate::call::{Outcome, call, call_on};
use crate::fields::of_tangential;
use crate::half_space::stickslip_half_space;
use crate::handle::{Handle, changing, free, give, opaque, reading};
use crate::inputs::{
    stickslip_friction, stickslip_relative_displacement, stickslip_settings,
    stickslip_settings_default,
};
use crate::loads::stickslip_tangential_load;
use crate::model::{STICKSLIP_ONE_WAY, STICKSLIP_SCALAR, coupling, model};
use crate::normal::stickslip_normal_solution;
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{Place, field, input, optional};
use crate::reserved::known;
use crate::results::{stickslip_report, stickslip_tangential_result, stickslip_warning};
use crate::solver::{self, Solver};
use crate::status::stickslip_status;
use crate::stiffness::stickslip_tangential_stiffness;
use crate::text_fields::{show, tell, warn};

/// Options of a tangential solver; stickslip_tangential_options_default() has the defaults.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_tangential_options {
    /// STICKSLIP_SCALAR (default) or STICKSLIP_VECTOR.
    pub model: i32,
    /// STICKSLIP_ONE_WAY (default) or STICKSLIP_NEGLECTED; of meaning for dissimilar bodies only.
    pub coupling: i32,
    /// A displacement of body 1 relative to body 2 that the contact does not cause, or NULL (default).
    pub relative_displacement: *const stickslip_relative_displacement,
    /// Method, tolerance and limits.
    pub settings: stickslip_settings,
    /// Room for members to come: zero.
    pub reserved: [u64; 8],
}

/// The options that tangential solvers have by default.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_tangential_options_default() -> stickslip_tangential_options {
    stickslip_tangential_options {
        model: STICKSLIP_SCALAR,
        coupling: STICKSLIP_ONE_WAY,
        relative_displacement: std::ptr::null(),
        settings: stickslip_settings_default(),
        reserved: [0; 8],
    }
}

/// Solves tangential contacts again and again, each from rest, beginning with the last answer.
pub struct stickslip_tangential_solver(Handle<Solver<TangentialSolver>>);

opaque!(stickslip_tangential_solver holds Solver<TangentialSolver>, named "tangential solver");

/// Traction, slip and shift of a tangential contact. Its fields are read without a copy, and are valid until the next solve
/// into it, or until it is freed.
pub struct stickslip_tangential_solution(Handle<TangentialSolution>);

opaque!(stickslip_tangential_solution holds TangentialSolution, named "tangential solution");

/// Makes a solver under the pressure of a solved normal contact on the same bodies. options may be NULL (the defaults).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_new(
    half_space: *const stickslip_half_space,
    normal: *const stickslip_normal_solution,
    friction: *const stickslip_friction,
    load: *const stickslip_tangential_load,
    options: *const stickslip_tangential_options,
    solver: *mut *mut stickslip_tangential_solver,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(half_space, || unsafe {
        let normal = reading(normal)?;
        let source = PressureSource::Solved(&normal);
        new(half_space, source, (friction, load, options), solver)
    })
}

/// Makes a solver under a pressure from elsewhere (count entries, zero or positive, copied). options may be NULL (the
/// defaults).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_new_under(
    half_space: *const stickslip_half_space,
    pressure: *const f64,
    count: usize,
    friction: *const stickslip_friction,
    load: *const stickslip_tangential_load,
    options: *const stickslip_tangential_options,
    solver: *mut *mut stickslip_tangential_solver,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(half_space, || unsafe {
        let grid = reading(half_space)?.grid();
        let pressure = field("pressure", grid, pressure, count)?;
        let source = PressureSource::Prescribed(&pressure);
        new(half_space, source, (friction, load, options), solver)
    })
}

type TangentialArguments = (
    *const stickslip_friction,
    *const stickslip_tangential_load,
    *const stickslip_tangential_options,
);

/// # Safety
/// The rule for pointers.
unsafe fn new(
    half_space: *const stickslip_half_space,
    pressure: PressureSource<'_>,
    (friction, load, options): TangentialArguments,
    solver: *mut *mut stickslip_tangential_solver,
) -> Outcome {
    // SAFETY: as of this function.
    let place = unsafe { Place::new("solver", solver)? };
    // SAFETY: as of this function.
    let (bodies, friction, load, options) = unsafe {
        let bodies = reading(half_space)?;
        let friction = input("friction", friction)?.checked(bodies.grid())?;
        let load = input("load", load)?.checked()?;
        (bodies, friction, load, optional("options", options)?)
    };
    let grid = bodies.grid();
    let mut problem = TangentialProblem::builder(&bodies, pressure, friction, load);
    if let Some(options) = options {
        known("the options", &options.reserved)?;
        problem = problem
            .model(model(options.model)?)
            .coupling(coupling(options.coupling)?)
            .settings(options.settings.checked()?);
        let name = "relative_displacement of the options";
        // SAFETY: as of this function.
        if let Some(relative) = unsafe { optional(name, options.relative_displacement)? } {
            // SAFETY: as of this function.
            problem = problem.relative_displacement(unsafe { relative.checked(grid)? });
        }
    }
    let problem = problem.build()?;
    let own = problem.into_solver()?;
    give(place, Solver { own, grid }, grid.cells())
}

/// Frees a solver; nothing for NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_free(
    solver: *mut stickslip_tangential_solver,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call(|| unsafe { free(solver) })
}

/// Changes the load of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_load(
    solver: *mut stickslip_tangential_solver,
    load: *const stickslip_tangential_load,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        let check = stickslip_tangential_load::checked;
        solver::change(solver, ("load", load), check, TangentialSolver::set_load)
    }
}

/// Changes the friction of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_friction(
    solver: *mut stickslip_tangential_solver,
    friction: *const stickslip_friction,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { solver::set_friction(solver, friction, TangentialSolver::set_friction) }
}

/// Changes the pressure of the next solve to that of a solved normal contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_normal(
    solver: *mut stickslip_tangential_solver,
    normal: *const stickslip_normal_solution,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(solver, || unsafe {
        let (mut solver, normal) = (changing(solver)?, reading(normal)?);
        Ok(solver.own.set_pressure(&*normal)?)
    })
}

/// Changes the pressure of the next solve to one from elsewhere (count entries, copied).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_pressure(
    solver: *mut stickslip_tangential_solver,
    pressure: *const f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        solver::change_cells(solver, ("pressure", pressure, count), |own, field| {
            own.set_pressure(field)
        })
    }
}

/// Changes the relative displacement of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_relative_displacement(
    solver: *mut stickslip_tangential_solver,
    relative: *const stickslip_relative_displacement,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(solver, || unsafe {
        let mut solver = changing(solver)?;
        let relative = input("relative", relative)?.checked(solver.grid)?;
        Ok(solver.own.set_relative_displacement(&relative)?)
    })
}

/// Changes method, tolerance and limits of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_settings(
    solver: *mut stickslip_tangential_solver,
    settings: *const stickslip_settings,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { solver::set_settings(solver, settings) }
}

/// Forgets the last answer: the next solve starts as the first did.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_reset(
    solver: *mut stickslip_tangential_solver,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { solver::reset(solver, TangentialSolver::reset) }
}

/// The largest tangential force that friction holds.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_friction_capacity(
    solver: *const stickslip_tangential_solver,
    capacity: *mut f64,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        tell(solver, ("capacity", capacity), |of| {
            Ok(of.own.friction_capacity())
        })
    }
}

/// Solves into a solution of stickslip_tangential_solution_new for the same bodies. observer may be NULL.
///
/// With STICKSLIP_NOT_CONVERGED the solution holds the last feasible iterate and its report; after any other failure it is
/// as it was.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_solve(
    solver: *mut stickslip_tangential_solver,
    solution: *mut stickslip_tangential_solution,
    observer: *const stickslip_observer,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { solver::solve(solver, solution, observer) }
}

/// Makes an empty solution of the right size for a solver.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_new(
    solver: *const stickslip_tangential_solver,
    solution: *mut *mut stickslip_tangential_solution,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { solver::new_solution(solver, solution) }
}

/// Frees a solution; nothing for NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_free(
    solution: *mut stickslip_tangential_solution,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call(|| unsafe { free(solution) })
}

/// STICKSLIP_TRACTION_X, STICKSLIP_SLIP_X or those along y, and how many cells it has (count may be NULL); NULL on failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_field(
    solution: *const stickslip_tangential_solution,
    which: i32,
    count: *mut usize,
) -> *const f64 {
    // SAFETY: the rule for pointers.
    unsafe {
        show(solution, count, |of| {
            Ok(of_tangential(of, which)?.as_slice())
        })
    }
}

/// The zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; NULL on failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_zones(
    solution: *const stickslip_tangential_solution,
    count: *mut usize,
) -> *const u8 {
    // SAFETY: the rule for pointers.
    unsafe { show(solution, count, |of| Ok(of.zones())).cast() }
}

// Zones are read as bytes.
const _: () = assert!(size_of::<Zone>() == 1 && Zone::Slip as u8 == crate::fields::STICKSLIP_SLIP);

/// The numbers of the contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_result(
    solution: *const stickslip_tangential_solution,
    result: *mut stickslip_tangential_result,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { tell(solution, ("result", result), |of| Ok(of.into())) }
}

/// How it was solved.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_report(
    solution: *const stickslip_tangential_solution,
    report: *mut stickslip_report,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe { tell(solution, ("report", report), |of| Ok(of.report().into())) }
}

/// Diagnostics that may mislead: as stickslip_normal_solution_warnings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_warnings(
    solution: *const stickslip_tangential_solution,
    buffer: *mut stickslip_warning,
    capacity: usize,
    count: *mut usize,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        warn(
            solution,
            (buffer, capacity, count),
            TangentialSolution::try_warnings,
        )
    }
}

/// The stiffness of a tangential contact on the bodies it was solved for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_stiffness(
    solution: *const stickslip_tangential_solution,
    half_space: *const stickslip_half_space,
    stiffness: *mut stickslip_tangential_stiffness,
) -> stickslip_status {
    let nobody = std::ptr::null();
    // SAFETY: the rule for pointers.
    unsafe {
        stickslip_tangential_solution_stiffness_observed(solution, half_space, nobody, stiffness)
    }
}

/// The same with an observer (may be NULL), which is called before every product with the operator and may end it:
/// STICKSLIP_NOT_CONVERGED, and stiffness is as it was.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_stiffness_observed(
    solution: *const stickslip_tangential_solution,
    half_space: *const stickslip_half_space,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_tangential_stiffness,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    unsafe {
        tell(solution, ("stiffness", stiffness), |of| {
            let (bodies, observer) = (reading(half_space)?, optional("observer", observer)?);
            Ok(of.stiffness_observed(&bodies, watch(observer))?.into())
        })
    }
}
