//! Normal contact.

use stickslip_rs::{NormalProblem, NormalSolution, NormalSolver};

use crate::call::{call, call_on};
use crate::fields::of_normal;
use crate::half_space::stickslip_half_space;
use crate::handle::{Handle, free, give, opaque, reading};
use crate::inputs::{stickslip_per_cell, stickslip_settings};
use crate::loads::stickslip_normal_load;
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{Place, field, input, optional};
use crate::results::{stickslip_normal_result, stickslip_report, stickslip_warning};
use crate::solver::{self, Solver};
use crate::status::stickslip_status;
use crate::stiffness::stickslip_normal_stiffness;
use crate::text_fields::{show, tell, warn};

/// Solver for repeated normal contacts of two bodies. Each solve starts from the last solution.
pub struct stickslip_normal_solver(Handle<Solver<NormalSolver>>);

opaque!(stickslip_normal_solver holds Solver<NormalSolver>, named "normal solver");

/// Pressure, gap and approach of a normal contact. Fields are read without a copy and remain valid until the next solve
/// into the solution or until it is freed.
pub struct stickslip_normal_solution(Handle<NormalSolution>);

opaque!(stickslip_normal_solution holds NormalSolution, named "normal solution");

/// Creates a solver for a gap before loading (lengths, count entries, copied) under a load.
///
/// hardness is the largest pressure that the cells can carry. It may be NULL if there is no limit, and settings may be
/// NULL for the defaults.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solver_new(
    half_space: *const stickslip_half_space,
    gap: *const f64,
    count: usize,
    load: *const stickslip_normal_load,
    hardness: *const stickslip_per_cell,
    settings: *const stickslip_settings,
    solver: *mut *mut stickslip_normal_solver,
) -> stickslip_status {
    call_on(half_space, || {
        // SAFETY: the caller follows the rule for pointers.
        let place = unsafe { Place::of_object("solver", solver)? };
        // SAFETY: the caller follows the rule for pointers.
        let (bodies, load, hardness, settings) = unsafe {
            let hardness = optional("hardness", hardness)?;
            let settings = optional("settings", settings)?;
            (
                reading(half_space)?,
                input("load", load)?,
                hardness,
                settings,
            )
        };
        let grid = bodies.grid();
        // SAFETY: the caller follows the rule for pointers.
        let gap = unsafe { field("gap", grid, gap, count)? };
        let mut problem = NormalProblem::builder(&bodies, gap, load.of_problem()?);
        if let Some(settings) = settings {
            problem = problem.settings(settings.checked()?);
        }
        if let Some(limit) = hardness {
            // SAFETY: the caller follows the rule for pointers.
            problem = problem.hardness(unsafe { limit.hardness(grid)? });
        }
        let problem = problem.build()?;
        let own = problem.into_solver()?;
        give(place, Solver::new(own, grid), grid.cells())
    })
}

/// Frees a solver; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solver_free(
    solver: *mut stickslip_normal_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(solver) })
}

/// Sets the load of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solver_set_load(
    solver: *mut stickslip_normal_solver,
    load: *const stickslip_normal_load,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        let check = stickslip_normal_load::of_problem;
        solver::change(solver, ("load", load), check, NormalSolver::set_load)
    }
}

/// Sets the gap before loading of the next solve (lengths, count entries, copied). Returns STICKSLIP_GAP_UNDER_LOAD for the gap
/// of the last solution, which is the gap under load.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solver_set_gap(
    solver: *mut stickslip_normal_solver,
    gap: *const f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::change_cells(solver, ("gap", gap, count), NormalSolver::set_gap) }
}

/// Sets the method, the tolerance and the limits of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solver_set_settings(
    solver: *mut stickslip_normal_solver,
    settings: *const stickslip_settings,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::set_settings(solver, settings) }
}

/// Discards the last solution: the next solve starts as the first solve did.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solver_reset(
    solver: *mut stickslip_normal_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::reset(solver, NormalSolver::reset) }
}

/// Solves into a solution of stickslip_normal_solution_new for the same bodies. observer may be NULL.
///
/// After STICKSLIP_NOT_CONVERGED the solution contains the last feasible iterate and its report. Any other failure leaves
/// the solution unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solver_solve(
    solver: *mut stickslip_normal_solver,
    solution: *mut stickslip_normal_solution,
    observer: *const stickslip_observer,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::solve(solver, solution, observer) }
}

/// Creates an empty solution of the right size for a solver.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solution_new(
    solver: *const stickslip_normal_solver,
    solution: *mut *mut stickslip_normal_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::new_solution(solver, solution) }
}

/// Frees a solution; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solution_free(
    solution: *mut stickslip_normal_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(solution) })
}

/// Returns a field, STICKSLIP_PRESSURE or STICKSLIP_GAP, and writes its number of cells to count (may be NULL); returns
/// NULL on failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solution_field(
    solution: *const stickslip_normal_solution,
    which: i32,
    count: *mut usize,
) -> *const f64 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(solution, count, |of| Ok(of_normal(of, which)?.as_slice())) }
}

/// Writes the scalar results of the contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solution_result(
    solution: *const stickslip_normal_solution,
    result: *mut stickslip_normal_result,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(solution, ("result", result), |of| Ok(of.into())) }
}

/// Writes the report of the solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solution_report(
    solution: *const stickslip_normal_solution,
    report: *mut stickslip_report,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(solution, ("report", report), |of| Ok(of.report().into())) }
}

/// Writes the warnings about the solution to a buffer of capacity entries, and their number to count. With a capacity of 0
/// it writes only the number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solution_warnings(
    solution: *const stickslip_normal_solution,
    buffer: *mut stickslip_warning,
    capacity: usize,
    count: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        warn(
            solution,
            (buffer, capacity, count),
            NormalSolution::try_warnings,
        )
    }
}

/// Computes the stiffness of a normal contact. The bodies must be those of the solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solution_stiffness(
    solution: *const stickslip_normal_solution,
    half_space: *const stickslip_half_space,
    stiffness: *mut stickslip_normal_stiffness,
) -> stickslip_status {
    let nobody = std::ptr::null();
    // SAFETY: the caller follows the rule for pointers.
    unsafe { stickslip_normal_solution_stiffness_observed(solution, half_space, nobody, stiffness) }
}

/// Computes the stiffness with an observer (may be NULL). The observer is called before every product with the operator and
/// may end the call: the function then returns STICKSLIP_NOT_CONVERGED and leaves stiffness unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solution_stiffness_observed(
    solution: *const stickslip_normal_solution,
    half_space: *const stickslip_half_space,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_normal_stiffness,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(solution, ("stiffness", stiffness), |of| {
            let (bodies, observer) = (reading(half_space)?, optional("observer", observer)?);
            Ok(of.stiffness_observed(&bodies, watch(observer))?.into())
        })
    }
}
