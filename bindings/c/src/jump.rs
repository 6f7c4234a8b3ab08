//! How many cycles of wear may be jumped over.

use stickslip_rs::history::wear::{self, Coefficient, CycleJump};

use crate::call::{Outcome, call_on};
use crate::cycle::stickslip_cycle;
use crate::half_space::stickslip_half_space;
use crate::handle::reading;
use crate::inputs::stickslip_per_cell;
use crate::pointer::{answer, cells, input, optional};
use crate::reserved::known;
use crate::status::stickslip_status;

/// What limits a jump besides the pressure; stickslip_jump_limits_default() has the defaults.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_jump_limits {
    /// Most depth that is worn off at once (a length); infinite (default): any. A hundredth of the approach keeps the shape
    /// of a ball.
    pub largest_depth: f64,
    /// Cycles left to simulate; infinite (default): any number.
    pub cycles_left: f64,
    /// Largest cyclic_residual of a cycle that stands for those that follow (default 0.25).
    pub max_residual: f64,
    /// Room for members to come: zero.
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

/// The limits that jumps have by default.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_jump_limits_default() -> stickslip_jump_limits {
    stickslip_jump_limits {
        largest_depth: f64::INFINITY,
        cycles_left: f64::INFINITY,
        max_residual: 0.25,
        reserved: [0; 8],
    }
}

/// Writes how many cycles like this one may be jumped over to cycles, not rounded: as many as their wear may be taken off at
/// once without the pressure swinging, and no more than the limits (may be NULL: the defaults) allow; infinite if nothing
/// limits them.
///
/// depth (lengths, count entries) is what the cycle removed, of both bodies together. STICKSLIP_CYCLE_NOT_CLOSED for a cycle
/// that does not close, as the first from rest; STICKSLIP_NEGATIVE_OR_NOT_FINITE for a limit, STICKSLIP_SAMPLE for a depth.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_cycle_jump(
    half_space: *const stickslip_half_space,
    cycle: *const stickslip_cycle,
    depth: *const f64,
    count: usize,
    limits: *const stickslip_jump_limits,
    cycles: *mut f64,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
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

/// Writes to cycles how many cycles of wear may be taken off at once without the pressure swinging up: explicit wear by
/// Archard's law is stable below. coefficient (one over a pressure) is the sum of both bodies, slip_distance (lengths, count
/// entries) that of one cycle; for the energy law the coefficient is that of the law times that of friction. Infinite if
/// nothing slips.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_max_stable_cycles(
    half_space: *const stickslip_half_space,
    coefficient: *const stickslip_per_cell,
    slip_distance: *const f64,
    count: usize,
    cycles: *mut f64,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
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
