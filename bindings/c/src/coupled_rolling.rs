//! Steady rolling of dissimilar bodies with full coupling of pressure and traction.

use stickslip_rs::rolling::{
    CoupledRollingProblem, CoupledRollingReport, CoupledRollingSolution, CoupledRollingSolver,
};
use stickslip_rs::{Axis, Field};

use crate::call::{Outcome, call, call_on};
use crate::fields::*;
use crate::half_space::stickslip_half_space;
use crate::handle::{Handle, changing, free, give, opaque, reading};
use crate::history::entry_rule;
use crate::inputs::{stickslip_friction, stickslip_settings};
use crate::loads::stickslip_normal_load;
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{Place, field, input, optional};
use crate::reserved::known;
use crate::results::{stickslip_normal_result, stickslip_report, stickslip_warning};
use crate::rolling::{
    leading_edge, of_rolling, stickslip_rolling_load, stickslip_rolling_options,
    stickslip_rolling_result, stickslip_rolling_stiffness,
};
use crate::solver::{self, Solver};
use crate::status::stickslip_status;
use crate::text_fields::{show, tell, warn};

/// Solver for coupled steady rolling under a sequence of loads. Each solve starts from the last solution.
pub struct stickslip_coupled_rolling_solver(Handle<Solver<CoupledRollingSolver>>);

opaque!(stickslip_coupled_rolling_solver holds Solver<CoupledRollingSolver>, named "coupled rolling solver");

/// Pressure, traction, slip and creepage of coupled steady rolling. Fields are read without a copy and remain valid until
/// the next solve into the solution or until it is freed.
pub struct stickslip_coupled_rolling_solution(Handle<CoupledRollingSolution>);

opaque!(stickslip_coupled_rolling_solution holds CoupledRollingSolution, named "coupled rolling solution");

/// Report of a coupled rolling solve: status, cost, passes and certified errors.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_coupled_rolling_report {
    /// Report of all passes together; its duality gap is infinite for coupled bodies.
    pub work: stickslip_report,
    /// Number of passes: solves of the pressure, each followed by a solve of the tractions.
    pub passes: usize,
    /// Residual of the coupling: the lift within the contact that the last pass added, relative to the largest normal
    /// displacement.
    pub coupling_residual: f64,
    /// Change of the pressure in the last pass relative to the pressure (root mean squares).
    pub pressure_change: f64,
    /// Bound on the relative error of the pressure in the energy norm, for the tractions of the solution.
    pub pressure_error_bound: f64,
    /// Bound on the relative error of the tractions, for the pressure of the solution.
    pub traction_error_bound: f64,
    /// Estimate of the total relative error of the pressure; NaN if no estimate exists.
    pub error_estimate: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<&CoupledRollingReport> for stickslip_coupled_rolling_report {
    fn from(report: &CoupledRollingReport) -> Self {
        Self {
            work: (&report.work).into(),
            passes: report.passes,
            coupling_residual: report.coupling_residual,
            pressure_change: report.pressure_change,
            pressure_error_bound: report.pressure_error_bound,
            traction_error_bound: report.traction_error_bound,
            error_estimate: report.error_estimate.unwrap_or(f64::NAN),
            reserved: [0; 8],
        }
    }
}

/// Creates a solver for a gap before loading (lengths, count entries, copied) under a normal load. load and options may
/// be NULL. A NULL load means no creepage and no spin, and NULL options mean the defaults. For the extent of the grid
/// ahead of the contact, see stickslip_rolling_solver_new; here the solve returns STICKSLIP_GRID_TOO_SHORT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solver_new(
    half_space: *const stickslip_half_space,
    gap: *const f64,
    count: usize,
    friction: *const stickslip_friction,
    normal: *const stickslip_normal_load,
    load: *const stickslip_rolling_load,
    options: *const stickslip_rolling_options,
    solver: *mut *mut stickslip_coupled_rolling_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(half_space, || unsafe {
        let place = Place::of_object("solver", solver)?;
        let bodies = reading(half_space)?;
        let grid = bodies.grid();
        let friction = input("friction", friction)?.checked(grid)?;
        let gap = field("gap", grid, gap, count)?;
        let normal = input("normal", normal)?.of_problem()?;
        let mut problem = CoupledRollingProblem::builder(&bodies, gap, friction, normal);
        if let Some(load) = optional("load", load)? {
            let ([x, y], spin) = load.checked()?;
            problem = problem.control(Axis::X, x).control(Axis::Y, y).spin(spin);
        }
        if let Some(options) = optional("options", options)? {
            known("the options", &options.reserved)?;
            problem = problem
                .leading_edge(leading_edge(options.leading_edge)?)
                .entry_rule(entry_rule(options.entry_rule)?)
                .step(options.step)
                .slip_corrections(options.slip_corrections)
                .settings(options.settings.checked()?);
        }
        let own = problem.build()?.into_solver()?;
        give(place, Solver::new(own, grid), grid.cells())
    })
}

/// Frees a solver; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solver_free(
    solver: *mut stickslip_coupled_rolling_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(solver) })
}

/// Sets the normal load of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solver_set_normal_load(
    solver: *mut stickslip_coupled_rolling_solver,
    normal: *const stickslip_normal_load,
) -> stickslip_status {
    let set = CoupledRollingSolver::set_normal_load;
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        solver::change(
            solver,
            ("normal", normal),
            stickslip_normal_load::of_problem,
            set,
        )
    }
}

/// Sets the creepages, forces, spin or moment of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solver_set_load(
    solver: *mut stickslip_coupled_rolling_solver,
    load: *const stickslip_rolling_load,
) -> stickslip_status {
    let set = |own: &mut CoupledRollingSolver, (controls, spin)| own.set_load(controls, spin);
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::change(solver, ("load", load), stickslip_rolling_load::checked, set) }
}

/// Sets the gap before loading of the next solve (lengths, count entries, copied). Returns STICKSLIP_GAP_UNDER_LOAD for the gap
/// of the last solution, which is the gap under load.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solver_set_gap(
    solver: *mut stickslip_coupled_rolling_solver,
    gap: *const f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::change_cells(solver, ("gap", gap, count), CoupledRollingSolver::set_gap) }
}

/// Sets the friction of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solver_set_friction(
    solver: *mut stickslip_coupled_rolling_solver,
    friction: *const stickslip_friction,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::set_friction(solver, friction, CoupledRollingSolver::set_friction) }
}

/// Sets the method, the tolerance and the limits of the next solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solver_set_settings(
    solver: *mut stickslip_coupled_rolling_solver,
    settings: *const stickslip_settings,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::set_settings(solver, settings) }
}

/// Discards the last solution: the next solve starts as the first solve did.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solver_reset(
    solver: *mut stickslip_coupled_rolling_solver,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::reset(solver, CoupledRollingSolver::reset) }
}

/// Solves into a solution of stickslip_coupled_rolling_solution_new for the same bodies. observer may be NULL. After
/// STICKSLIP_NOT_CONVERGED the solution contains the last iterate and its report.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solver_solve(
    solver: *mut stickslip_coupled_rolling_solver,
    solution: *mut stickslip_coupled_rolling_solution,
    observer: *const stickslip_observer,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::solve(solver, solution, observer) }
}

/// Computes the derivatives of the loads at the last solution, including the change of the pressure with the tractions.
/// observer may be NULL. Returns STICKSLIP_NOT_CONVERGED before the first solve or after a solve that has not converged, and
/// STICKSLIP_OUTDATED_SOLUTION if a load, the gap or the friction has changed since the last solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solver_stiffness(
    solver: *mut stickslip_coupled_rolling_solver,
    observer: *const stickslip_observer,
    stiffness: *mut stickslip_rolling_stiffness,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solver, || unsafe {
        let place = Place::new("stiffness", stiffness)?;
        let observer = optional("observer", observer)?;
        let slopes = changing(solver)?.own.stiffness_observed(watch(observer))?;
        place.put(stickslip_rolling_stiffness {
            slopes,
            reserved: [0; 8],
        });
        Ok(())
    })
}

/// Creates an empty solution of the right size for a solver.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solution_new(
    solver: *const stickslip_coupled_rolling_solver,
    solution: *mut *mut stickslip_coupled_rolling_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { solver::new_solution(solver, solution) }
}

/// Frees a solution; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solution_free(
    solution: *mut stickslip_coupled_rolling_solution,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(solution) })
}

fn own_field(solution: &CoupledRollingSolution, which: i32) -> Outcome<&Field> {
    match which {
        STICKSLIP_PRESSURE | STICKSLIP_GAP => of_normal(solution.normal(), which),
        STICKSLIP_TRACTION_X..=STICKSLIP_SLIP_Y => of_rolling(solution.rolling(), which),
        other => Err(none(
            "a coupled rolling solution",
            other,
            "STICKSLIP_PRESSURE to STICKSLIP_SLIP_Y",
        )),
    }
}

/// Returns a field, STICKSLIP_PRESSURE, STICKSLIP_GAP, STICKSLIP_TRACTION_X, STICKSLIP_TRACTION_Y, STICKSLIP_SLIP_X or
/// STICKSLIP_SLIP_Y, and writes its number of cells to count (may be NULL); returns NULL on failure. The slip is given per
/// unit length rolled (dimensionless).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solution_field(
    solution: *const stickslip_coupled_rolling_solution,
    which: i32,
    count: *mut usize,
) -> *const f64 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(solution, count, |of| Ok(own_field(of, which)?.as_slice())) }
}

/// Returns the zone of every cell, STICKSLIP_SEPARATED, STICKSLIP_STICK or STICKSLIP_SLIP; returns NULL on failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solution_zones(
    solution: *const stickslip_coupled_rolling_solution,
    count: *mut usize,
) -> *const u8 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(solution, count, |of| Ok(of.rolling().zones())).cast() }
}

/// Writes the scalar results of the normal and the rolling part; either pointer may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solution_results(
    solution: *const stickslip_coupled_rolling_solution,
    normal: *mut stickslip_normal_result,
    rolling: *mut stickslip_rolling_result,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solution, || unsafe {
        let normal = Place::if_asked("normal", normal)?;
        let rolling = Place::if_asked("rolling", rolling)?;
        let solution = reading(solution)?;
        if let Some(place) = normal {
            place.put(solution.normal().into());
        }
        if let Some(place) = rolling {
            place.put(solution.rolling().into());
        }
        Ok(())
    })
}

/// Writes the report of the solve.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solution_report(
    solution: *const stickslip_coupled_rolling_solution,
    report: *mut stickslip_coupled_rolling_report,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(solution, ("report", report), |of| Ok(of.report().into())) }
}

/// Writes the warnings about the solution, like stickslip_normal_solution_warnings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_rolling_solution_warnings(
    solution: *const stickslip_coupled_rolling_solution,
    buffer: *mut stickslip_warning,
    capacity: usize,
    count: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        warn(
            solution,
            (buffer, capacity, count),
            CoupledRollingSolution::try_warnings,
        )
    }
}
