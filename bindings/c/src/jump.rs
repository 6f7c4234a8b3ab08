//! Number of wear cycles that a jump may skip.

use stickslip_rs::history::wear::{self, Coefficient, CycleJump};

use crate::call::{Outcome, call_on};
use crate::cycle::stickslip_cycle;
use crate::half_space::stickslip_half_space;
use crate::handle::reading;
use crate::inputs::stickslip_per_cell;
use crate::pointer::{answer, cells, input, optional};
use crate::reserved::known;
use crate::status::stickslip_status;

/// Limits of a jump in addition to the stability limit of the pressure. Start from stickslip_jump_limits_default(), which
/// returns the defaults: a struct of zeros permits no depth, no cycles and no residual.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_jump_limits {
    /// Largest depth removed in one jump (a length); infinite (default) for no limit. A hundredth of the approach preserves
    /// the shape of a ball.
    pub largest_depth: f64,
    /// Number of cycles left to simulate; infinite (default) for no limit.
    pub cycles_left: f64,
    /// Largest cyclic_residual of a cycle that may represent the following cycles (default 0.25).
    pub max_residual: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl stickslip_jump_limits {
    fn checked(&self) -> Outcome<&Self> {
        known("the limits", &self.reserved)?;
        Ok(self)
    }

    fn limit(&self, mut jump: CycleJump) -> CycleJump {
        if self.largest_depth != f64::INFINITY {
            jump = jump.largest_depth(self.largest_depth);
        }
        if self.cycles_left != f64::INFINITY {
            jump = jump.cycles_left(self.cycles_left);
        }
        jump.max_residual(self.max_residual)
    }
}

/// Returns the default limits of a jump.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_jump_limits_default() -> stickslip_jump_limits {
    stickslip_jump_limits {
        largest_depth: f64::INFINITY,
        cycles_left: f64::INFINITY,
        max_residual: 0.25,
        reserved: [0; 8],
    }
}

/// Writes to cycles the number of cycles like this one that a jump may skip, not rounded. Up to this number, removing the
/// wear in one step does not make the pressure oscillate, and the limits are met. limits may be NULL (the defaults). The
/// number is infinite if nothing limits it, as in full stick: set cycles_left or largest_depth before using the number.
///
/// depth (lengths, count entries) is the depth that the cycle removed from both bodies together. Returns
/// STICKSLIP_CYCLE_NOT_CLOSED if the cycle does not close, like the first cycle from rest. Returns
/// STICKSLIP_NEGATIVE_OR_NOT_FINITE for an invalid limit, and STICKSLIP_SAMPLE for an invalid depth.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_cycle_jump(
    half_space: *const stickslip_half_space,
    cycle: *const stickslip_cycle,
    depth: *const f64,
    count: usize,
    limits: *const stickslip_jump_limits,
    cycles: *mut f64,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(half_space, || unsafe {
        answer("cycles", cycles, || {
            let (bodies, cycle) = (reading(half_space)?, reading(cycle)?);
            let limits = optional("limits", limits)?;
            let limits = limits.map(stickslip_jump_limits::checked).transpose()?;
            let grid = bodies.grid();
            let samples = cells("depth", grid, depth, count)?;
            cycle.spare().with_copy(grid, samples, |depth| {
                let jump = CycleJump::new(&bodies, &cycle, depth)?;
                let jump = limits.map_or(jump, |limits| limits.limit(jump));
                Ok(jump.cycles()?)
            })
        })
    })
}

/// Writes to cycles the number of cycles whose wear may be removed in one step without growing oscillations of the
/// pressure. Explicit integration of Archard's law is stable below this number. coefficient (one over a pressure) is the
/// sum of the wear coefficients of both bodies, and slip_distance (lengths, count entries) is the slip distance of one
/// cycle. For the energy law, coefficient is the wear coefficient times the coefficient of friction. The number is infinite
/// if no cell slips.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_max_stable_cycles(
    half_space: *const stickslip_half_space,
    coefficient: *const stickslip_per_cell,
    slip_distance: *const f64,
    count: usize,
    cycles: *mut f64,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(half_space, || unsafe {
        answer("cycles", cycles, || {
            let bodies = reading(half_space)?;
            let (grid, spare) = (bodies.grid(), bodies.spare());
            let coefficient = input("coefficient", coefficient)?;
            let coefficients = coefficient.cells("wear coefficient", grid)?;
            let slip = cells("slip distance", grid, slip_distance, count)?;
            spare.with_copy(grid, slip, |slip| match coefficients {
                None => {
                    let uniform = Coefficient::Uniform(coefficient.value);
                    Ok(wear::max_stable_cycles(&bodies, uniform, slip)?)
                }
                Some(samples) => spare.with_copy(grid, samples, |field| {
                    let per_cell = Coefficient::PerCell(field);
                    Ok(wear::max_stable_cycles(&bodies, per_cell, slip)?)
                }),
            })
        })
    })
}
