//! Tangential contact under a given pressure.

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

/// Options of a tangential solver; stickslip_tangential_options_default() returns the defaults.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_tangential_options {
    /// Model of the traction: STICKSLIP_SCALAR (default) or STICKSLIP_VECTOR.
    pub model: i32,
    /// Coupling of pressure and traction: STICKSLIP_ONE_WAY (default) or STICKSLIP_NEGLECTED; relevant only for dissimilar
    /// bodies.
    pub coupling: i32,
    /// Displacement of body 1 relative to body 2 that the contact does not cause, or NULL (default).
    pub relative_displacement: *const stickslip_relative_displacement,
    /// Method, tolerance and limits of the solves.
    pub settings: stickslip_settings,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Returns the default options of a tangential solver.
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

/// Solver for repeated tangential contacts, each loaded from rest. Each solve starts from the last solution.
pub struct stickslip_tangential_solver(Handle<Solver<TangentialSolver>>);

opaque!(stickslip_tangential_solver holds Solver<TangentialSolver>, named "tangential solver");

/// Traction, slip and shift of a tangential contact. Fields are read without a copy and remain valid until the next solve
/// into the solution or until it is freed.
pub struct stickslip_tangential_solution(Handle<TangentialSolution>);

opaque!(stickslip_tangential_solution holds TangentialSolution, named "tangential solution");

/// Creates a solver under the pressure of a solved normal contact on the same bodies. options may be NULL (the defaults).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_new(
    half_space: *const stickslip_half_space,
    normal: *const stickslip_normal_solution,
    friction: *const stickslip_friction,
    load: *const stickslip_tangential_load,
    options: *const stickslip_tangential_options,
    solver: *mut *mut stickslip_tangential_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(half_space, || unsafe {
        let normal = reading(normal)?;
        let source = PressureSource::Solved(&normal);
        new(half_space, source, (friction, load, options), solver)
    })
}

/// Creates a solver under a given pressure (count entries, zero or positive, copied). options may be NULL (the defaults).
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
    // SAFETY: the caller follows the rule for pointers.
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

/// Creates a solver under a pressure.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
unsafe fn new(
    half_space: *const stickslip_half_space,
    pressure: PressureSource<'_>,
    (friction, load, options): TangentialArguments,
    solver: *mut *mut stickslip_tangential_solver,
) -> Outcome {
    // SAFETY: the caller follows the safety contract of this function.
    let place = unsafe { Place::of_object("solver", solver)? };
    // SAFETY: the caller follows the safety contract of this function.
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
        // SAFETY: the caller follows the safety contract of this function.
        if let Some(relative) = unsafe { optional(name, options.relative_displacement)? } {
            // SAFETY: the caller follows the safety contract of this function.
            problem = problem.relative_displacement(unsafe { relative.checked(grid)? });
        }
    }
    let problem = problem.build()?;
    let own = problem.into_solver()?;
    give(place, Solver::new(own, grid), grid.cells())
}

/// Frees a solver; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_free(
    solver: *mut stickslip_tangential_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(solver) })
}

/// Sets the load of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_load(
    solver: *mut stickslip_tangential_solver,
    load: *const stickslip_tangential_load,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        let check = stickslip_tangential_load::checked;
        solver::change(solver, ("load", load), check, TangentialSolver::set_load)
    }
}

/// Sets the friction of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_friction(
    solver: *mut stickslip_tangential_solver,
    friction: *const stickslip_friction,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::set_friction(solver, friction, TangentialSolver::set_friction) }
}

/// Sets the pressure of the next solve to the pressure of a solved normal contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_normal(
    solver: *mut stickslip_tangential_solver,
    normal: *const stickslip_normal_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solver, || unsafe {
        let (mut solver, normal) = (changing(solver)?, reading(normal)?);
        Ok(solver.own.set_pressure(&*normal)?)
    })
}

/// Sets the pressure of the next solve to the given values (count entries, copied).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_pressure(
    solver: *mut stickslip_tangential_solver,
    pressure: *const f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        solver::change_cells(solver, ("pressure", pressure, count), |own, field| {
            own.set_pressure(field)
        })
    }
}

/// Sets the relative displacement of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_relative_displacement(
    solver: *mut stickslip_tangential_solver,
    relative: *const stickslip_relative_displacement,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solver, || unsafe {
        let mut solver = changing(solver)?;
        let relative = input("relative", relative)?.checked(solver.grid)?;
        Ok(solver.own.set_relative_displacement(&relative)?)
    })
}

/// Sets the method, the tolerance and the limits of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_set_settings(
    solver: *mut stickslip_tangential_solver,
    settings: *const stickslip_settings,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::set_settings(solver, settings) }
}

/// Discards the last solution: the next solve starts as the first solve did.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_reset(
    solver: *mut stickslip_tangential_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::reset(solver, TangentialSolver::reset) }
}

/// Writes the largest tangential force that friction can carry.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_friction_capacity(
    solver: *const stickslip_tangential_solver,
    capacity: *mut f64,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(solver, ("capacity", capacity), |of| {
            Ok(of.own.friction_capacity())
        })
    }
}

/// Solves into a solution of stickslip_tangential_solution_new for the same bodies. observer may be NULL.
///
/// After STICKSLIP_NOT_CONVERGED the solution contains the last feasible iterate and its report. Any other failure leaves
/// the solution unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solver_solve(
    solver: *mut stickslip_tangential_solver,
    solution: *mut stickslip_tangential_solution,
    observer: *const stickslip_observer,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::solve(solver, solution, observer) }
}

/// Creates an empty solution of the right size for a solver.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_new(
    solver: *const stickslip_tangential_solver,
    solution: *mut *mut stickslip_tangential_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::new_solution(solver, solution) }
}

/// Frees a solution; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_free(
    solution: *mut stickslip_tangential_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(solution) })
}

/// Returns a field, STICKSLIP_TRACTION_X, STICKSLIP_TRACTION_Y, STICKSLIP_SLIP_X or STICKSLIP_SLIP_Y, and writes its number
/// of cells to count (may be NULL); returns NULL on failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_field(
    solution: *const stickslip_tangential_solution,
    which: i32,
    count: *mut usize,
) -> *const f64 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        show(solution, count, |of| {
            Ok(of_tangential(of, which)?.as_slice())
        })
    }
}

/// Returns the zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; returns NULL on failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_zones(
    solution: *const stickslip_tangential_solution,
    count: *mut usize,
) -> *const u8 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(solution, count, |of| Ok(of.zones())).cast() }
}

// C reads zones as bytes.
const _: () = assert!(size_of::<Zone>() == 1 && Zone::Slip as u8 == crate::fields::STICKSLIP_SLIP);

/// Writes the scalar results of the contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_result(
    solution: *const stickslip_tangential_solution,
    result: *mut stickslip_tangential_result,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(solution, ("result", result), |of| Ok(of.into())) }
}

/// Writes the report of the solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_report(
    solution: *const stickslip_tangential_solution,
    report: *mut stickslip_report,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(solution, ("report", report), |of| Ok(of.report().into())) }
}

/// Writes the warnings about the solution, like stickslip_normal_solution_warnings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_warnings(
    solution: *const stickslip_tangential_solution,
    buffer: *mut stickslip_warning,
    capacity: usize,
    count: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        warn(
            solution,
            (buffer, capacity, count),
            TangentialSolution::try_warnings,
        )
    }
}

/// Computes the stiffness of a tangential contact. The bodies must be those of the solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_stiffness(
    solution: *const stickslip_tangential_solution,
    half_space: *const stickslip_half_space,
    stiffness: *mut stickslip_tangential_stiffness,
) -> stickslip_status {
    let nobody = std::ptr::null();
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        stickslip_tangential_solution_stiffness_observed(solution, half_space, nobody, stiffness)
    }
}

/// Computes the stiffness with an observer (may be NULL). The observer is called before every product with the operator and
/// may end the call: the function then returns STICKSLIP_NOT_CONVERGED and leaves stiffness unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_stiffness_observed(
    solution: *const stickslip_tangential_solution,
    half_space: *const stickslip_half_space,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_tangential_stiffness,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(solution, ("stiffness", stiffness), |of| {
            let (bodies, observer) = (reading(half_space)?, optional("observer", observer)?);
            Ok(of.stiffness_observed(&bodies, watch(observer))?.into())
        })
    }
}
