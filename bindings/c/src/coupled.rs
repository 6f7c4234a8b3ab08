//! Coupled pressure and traction of dissimilar bodies.

use stickslip_rs::coupled::CoupledReport;
use stickslip_rs::{
    CoupledProblem, CoupledSolution, CoupledSolver, Field, NormalLoad, TangentialLoad,
};

use crate::call::{Outcome, call, call_on};
use crate::fields::*;
use crate::half_space::stickslip_half_space;
use crate::handle::{Handle, changing, free, give, opaque, reading};
use crate::inputs::{
    stickslip_friction, stickslip_per_cell, stickslip_relative_displacement, stickslip_settings,
};
use crate::loads::{stickslip_normal_load, stickslip_tangential_load};
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{Place, field, input, optional};
use crate::results::{
    stickslip_normal_result, stickslip_report, stickslip_tangential_result, stickslip_warning,
};
use crate::solver::{self, Solver};
use crate::status::stickslip_status;
use crate::stiffness::stickslip_stiffness;
use crate::text_fields::{show, tell, warn};

/// Solver for repeated coupled contacts, each loaded from rest in one step. Each solve starts from the last solution.
pub struct stickslip_coupled_solver(Handle<Solver<CoupledSolver>>);

opaque!(stickslip_coupled_solver holds Solver<CoupledSolver>, named "coupled solver");

/// Pressure, tractions and displacements of a coupled contact. Fields are read without a copy and remain valid until the
/// next solve into the solution or until it is freed.
pub struct stickslip_coupled_solution(Handle<CoupledSolution>);

opaque!(stickslip_coupled_solution holds CoupledSolution, named "coupled solution");

/// Report of a coupled solve. The total errors of pressure and traction have bounds if friction is weak; otherwise only
/// the error of the pressure for the computed tractions, and the error of the tractions for the computed pressure, are
/// certified.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_coupled_report {
    /// Report of the whole solve; its duality gap is infinite.
    pub work: stickslip_report,
    /// Bound on the error of the pressure in the energy norm, for the tractions of the solution.
    pub pressure_error_bound: f64,
    /// Bound on the error of the tractions, for the pressure of the solution.
    pub traction_error_bound: f64,
    /// Bounds on the total errors of pressure and traction; NaN if no bounds exist.
    pub error_bounds: [f64; 2],
    /// Estimates of the total errors of pressure and traction; NaN if no estimates exist.
    pub error_estimate: [f64; 2],
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<&CoupledReport> for stickslip_coupled_report {
    fn from(report: &CoupledReport) -> Self {
        let estimate = report.error_estimate.as_ref();
        Self {
            work: (&report.work).into(),
            pressure_error_bound: report.pressure_error_bound,
            traction_error_bound: report.traction_error_bound,
            error_bounds: report.error_bounds.unwrap_or([f64::NAN; 2]),
            error_estimate: estimate.map_or([f64::NAN; 2], |of| [of.pressure, of.traction]),
            reserved: [0; 8],
        }
    }
}

/// Creates a solver for a gap before loading (lengths, count entries, copied). hardness, relative and settings may be NULL.
/// A NULL hardness means no limit of the pressure, a NULL relative means no relative displacement, and NULL settings mean
/// the defaults.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solver_new(
    half_space: *const stickslip_half_space,
    gap: *const f64,
    count: usize,
    friction: *const stickslip_friction,
    normal: *const stickslip_normal_load,
    tangential: *const stickslip_tangential_load,
    hardness: *const stickslip_per_cell,
    relative: *const stickslip_relative_displacement,
    settings: *const stickslip_settings,
    solver: *mut *mut stickslip_coupled_solver,
) -> stickslip_status {
    call_on(half_space, || {
        // SAFETY: the caller follows the rule for pointers.
        let place = unsafe { Place::of_object("solver", solver)? };
        // SAFETY: the caller follows the rule for pointers.
        let (bodies, gap, friction) = unsafe {
            let bodies = reading(half_space)?;
            let grid = bodies.grid();
            let friction = input("friction", friction)?.checked(grid)?;
            (bodies, field("gap", grid, gap, count)?, friction)
        };
        let grid = bodies.grid();
        // SAFETY: the caller follows the rule for pointers.
        let (normal, tangential) = unsafe { loads(normal, tangential)? };
        let mut problem = CoupledProblem::builder(&bodies, gap, friction, normal, tangential);
        // SAFETY: the caller follows the rule for pointers.
        unsafe {
            if let Some(limit) = optional("hardness", hardness)? {
                problem = problem.hardness(limit.hardness(grid)?);
            }
            if let Some(relative) = optional("relative", relative)? {
                problem = problem.relative_displacement(relative.checked(grid)?);
            }
            if let Some(settings) = optional("settings", settings)? {
                problem = problem.settings(settings.checked()?);
            }
        }
        let problem = problem.build()?;
        let own = problem.into_solver()?;
        give(place, Solver::new(own, grid), grid.cells())
    })
}

/// Frees a solver; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solver_free(
    solver: *mut stickslip_coupled_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(solver) })
}

/// Returns both loads after checking them.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
unsafe fn loads(
    normal: *const stickslip_normal_load,
    tangential: *const stickslip_tangential_load,
) -> Outcome<(NormalLoad, TangentialLoad)> {
    // SAFETY: the caller follows the safety contract of this function.
    let (normal, tangential) =
        unsafe { (input("normal", normal)?, input("tangential", tangential)?) };
    Ok((normal.of_problem()?, tangential.checked()?))
}

/// Sets the normal and the tangential load of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solver_set_loads(
    solver: *mut stickslip_coupled_solver,
    normal: *const stickslip_normal_load,
    tangential: *const stickslip_tangential_load,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solver, || unsafe {
        let (normal, tangential) = loads(normal, tangential)?;
        Ok(changing(solver)?.own.set_loads(normal, tangential)?)
    })
}

/// Sets the gap before loading of the next solve (lengths, count entries, copied). Returns STICKSLIP_GAP_UNDER_LOAD for the gap
/// of the last solution, which is the gap under load.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solver_set_gap(
    solver: *mut stickslip_coupled_solver,
    gap: *const f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::change_cells(solver, ("gap", gap, count), CoupledSolver::set_gap) }
}

/// Sets the friction of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solver_set_friction(
    solver: *mut stickslip_coupled_solver,
    friction: *const stickslip_friction,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::set_friction(solver, friction, CoupledSolver::set_friction) }
}

/// Sets the method, the tolerance and the limits of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solver_set_settings(
    solver: *mut stickslip_coupled_solver,
    settings: *const stickslip_settings,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::set_settings(solver, settings) }
}

/// Discards the last solution: the next solve starts as the first solve did.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solver_reset(
    solver: *mut stickslip_coupled_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::reset(solver, CoupledSolver::reset) }
}

/// Solves into a solution of stickslip_coupled_solution_new for the same bodies. observer may be NULL. After
/// STICKSLIP_NOT_CONVERGED the solution contains the last iterate and its report. Any other failure leaves the solution
/// unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solver_solve(
    solver: *mut stickslip_coupled_solver,
    solution: *mut stickslip_coupled_solution,
    observer: *const stickslip_observer,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::solve(solver, solution, observer) }
}

/// Creates an empty solution of the right size for a solver.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_new(
    solver: *const stickslip_coupled_solver,
    solution: *mut *mut stickslip_coupled_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::new_solution(solver, solution) }
}

/// Frees a solution; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_free(
    solution: *mut stickslip_coupled_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(solution) })
}

/// Returns a field, STICKSLIP_PRESSURE to STICKSLIP_DISPLACEMENT_Z, and writes its number of cells to count (may be NULL);
/// returns NULL on failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_field(
    solution: *const stickslip_coupled_solution,
    which: i32,
    count: *mut usize,
) -> *const f64 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(solution, count, |of| Ok(own_field(of, which)?.as_slice())) }
}

fn own_field(solution: &CoupledSolution, which: i32) -> Outcome<&Field> {
    match which {
        STICKSLIP_PRESSURE | STICKSLIP_GAP => of_normal(solution.normal(), which),
        STICKSLIP_DISPLACEMENT_X => Ok(solution.displacement()[0]),
        STICKSLIP_DISPLACEMENT_Y => Ok(solution.displacement()[1]),
        STICKSLIP_DISPLACEMENT_Z => Ok(solution.displacement()[2]),
        STICKSLIP_TRACTION_X..=STICKSLIP_SLIP_Y => of_tangential(solution.tangential(), which),
        other => Err(none(
            "a coupled solution",
            other,
            "STICKSLIP_PRESSURE to STICKSLIP_DISPLACEMENT_Z",
        )),
    }
}

/// Returns the zone of every cell, or NULL on failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_zones(
    solution: *const stickslip_coupled_solution,
    count: *mut usize,
) -> *const u8 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(solution, count, |of| Ok(of.tangential().zones())).cast() }
}

/// Writes the scalar results of the normal and the tangential part; either pointer may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_results(
    solution: *const stickslip_coupled_solution,
    normal: *mut stickslip_normal_result,
    tangential: *mut stickslip_tangential_result,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solution, || unsafe {
        let normal = Place::if_asked("normal", normal)?;
        let tangential = Place::if_asked("tangential", tangential)?;
        let solution = reading(solution)?;
        if let Some(place) = normal {
            place.put(solution.normal().into());
        }
        if let Some(place) = tangential {
            place.put(solution.tangential().into());
        }
        Ok(())
    })
}

/// Writes the report of the solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_report(
    solution: *const stickslip_coupled_solution,
    report: *mut stickslip_coupled_report,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(solution, ("report", report), |of| Ok(of.report().into())) }
}

/// Writes the warnings about the solution, like stickslip_normal_solution_warnings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_warnings(
    solution: *const stickslip_coupled_solution,
    buffer: *mut stickslip_warning,
    capacity: usize,
    count: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        warn(
            solution,
            (buffer, capacity, count),
            CoupledSolution::try_warnings,
        )
    }
}

/// Computes the stiffness of a coupled contact. Bodies and friction must be those of the solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_stiffness(
    solution: *const stickslip_coupled_solution,
    half_space: *const stickslip_half_space,
    friction: *const stickslip_friction,
    stiffness: *mut stickslip_stiffness,
) -> stickslip_status {
    let nobody = std::ptr::null();
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        stickslip_coupled_solution_stiffness_observed(
            solution, half_space, friction, nobody, stiffness,
        )
    }
}

/// Computes the stiffness with an observer (may be NULL). The observer is called before every product with the operator and
/// may end the call: the function then returns STICKSLIP_NOT_CONVERGED and leaves stiffness unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_stiffness_observed(
    solution: *const stickslip_coupled_solution,
    half_space: *const stickslip_half_space,
    friction: *const stickslip_friction,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_stiffness,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(solution, ("stiffness", stiffness), |of| {
            let bodies = reading(half_space)?;
            let friction = input("friction", friction)?.checked(bodies.grid())?;
            let observer = watch(optional("observer", observer)?);
            Ok(of.stiffness_observed(&bodies, &friction, observer)?.into())
        })
    }
}
