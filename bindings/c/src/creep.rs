//! Creep curves and creep surfaces of steady rolling.

use std::mem::discriminant;

use stickslip_rs::rolling::CreepForce;

use crate::call::call_on;
use crate::error::Failure;
use crate::handle::changing;
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{collected, entries, entries_mut, optional};
use crate::results::stickslip_warning;
use crate::rolling::stickslip_rolling_solver;
use crate::status::stickslip_status;
use crate::text_fields::warn;

/// Creepages and spin: a point of a creep curve or a creep surface.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_creep_point {
    /// Creepages along x and y (dimensionless).
    pub creepage: [f64; 2],
    /// Spin (one over a length).
    pub spin: f64,
}

/// Loads due to creepages and spin.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_creep_force {
    /// Tangential force on body 1 along x and y.
    pub force: [f64; 2],
    /// Moment on body 1 about the origin of the grid (a force times a length).
    pub moment: f64,
    /// Ratio of stick cells to contact cells.
    pub stick_ratio: f64,
}

impl From<CreepForce> for stickslip_creep_force {
    fn from(at: CreepForce) -> Self {
        Self {
            force: at.force,
            moment: at.moment,
            stick_ratio: at.stick_ratio,
        }
    }
}

/// Computes the loads at count points and writes them to forces. Each solve starts from the solution of the previous point,
/// so consecutive points should be close to each other. All points are checked before the first solve. Afterwards the last
/// point is the prescribed load. After STICKSLIP_NOT_CONVERGED the failed point is the prescribed load. forces then contains the
/// points solved before, whose number is the member found of stickslip_last_error; its other entries are unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_creep_forces(
    solver: *mut stickslip_rolling_solver,
    points: *const stickslip_creep_point,
    count: usize,
    forces: *mut stickslip_creep_force,
) -> stickslip_status {
    let none = std::ptr::null();
    // SAFETY: the caller follows the rule for pointers.
    unsafe { stickslip_rolling_solver_creep_forces_observed(solver, points, count, none, forces) }
}

/// Computes the loads at count points with an observer (may be NULL), like stickslip_rolling_solver_creep_forces. The
/// observer is called before every product with an operator and may end the call. The call then returns
/// STICKSLIP_NOT_CONVERGED and leaves forces as after a point that does not converge.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_creep_forces_observed(
    solver: *mut stickslip_rolling_solver,
    points: *const stickslip_creep_point,
    count: usize,
    observer: *const stickslip_observer,
    forces: *mut stickslip_creep_force,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solver, || unsafe {
        let observer = watch(optional("observer", observer)?);
        let places = entries_mut("forces", forces, count)?;
        let points = entries("points", points, count)?;
        let points = points
            .iter()
            .map(|at| [at.creepage[0], at.creepage[1], at.spin]);
        let points = collected(Vec::new(), points)?;
        let mut solver = changing(solver)?;
        let (mut observer, mut found) = (observer, Vec::new());
        let outcome = solver
            .own
            .creep_forces_into(points, &mut found, |iteration, _| observer(iteration));
        for (place, force) in places.iter_mut().zip(&found) {
            *place = (*force).into();
        }
        solver.remarks.clear();
        for warning in found.iter().flat_map(CreepForce::warnings) {
            if !solver
                .remarks
                .iter()
                .any(|own| discriminant(own) == discriminant(&warning))
            {
                solver.remarks.push(warning);
            }
        }
        outcome.map_err(|error| Failure::from(error).after_entries(found.len()))
    })
}

/// Writes the warnings about the loads of the points that the last call of stickslip_rolling_solver_creep_forces has solved,
/// like stickslip_normal_solution_warnings. They include a creepage that may be in per cent. Each kind is listed once, for the
/// first point that has it. The list is empty before the first call. stickslip_rolling_solution_warnings also contains the
/// warnings about the contact, which is the same at all points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_rolling_solver_creep_warnings(
    solver: *const stickslip_rolling_solver,
    buffer: *mut stickslip_warning,
    capacity: usize,
    count: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        warn(solver, (buffer, capacity, count), |of| {
            Ok(of.remarks.clone())
        })
    }
}
