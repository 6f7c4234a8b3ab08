//! Two elastic half-spaces on a grid.

use std::sync::Arc;

use stickslip_rs::layers::Layer;
use stickslip_rs::{Boundary, CellValue, ElasticPair, HalfSpace, Material};

use crate::call::{Outcome, call};
use crate::handle::{Handle, changing, free, give, opaque};
use crate::inputs::{
    STICKSLIP_CENTRE, STICKSLIP_UNIFORM, cell_value, stickslip_boundary, stickslip_grid,
    stickslip_layer, stickslip_material,
};
use crate::pointer::{Place, entries, input, optional};
use crate::ranks::stickslip_ranks;
use crate::status::stickslip_status;
use crate::text_fields::tell;
use crate::threads::enter;

/// Two elastic half-spaces on a grid, with the operators that all contacts on them share. Solvers and histories keep the
/// parts they need, so the half-spaces may be freed first. Many threads may use the same object simultaneously.
pub struct stickslip_half_space(Handle<HalfSpace>);

opaque!(stickslip_half_space holds HalfSpace, named "half-space");

/// Constants of a pair of materials.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_pair {
    /// Contact modulus E* (a pressure): 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
    pub contact_modulus: f64,
    /// Mindlin's tangential modulus G* (a pressure): 1/G* = (2 - nu_1)/G_1 + (2 - nu_2)/G_2. The tangential stiffness of a
    /// circular stick contact of radius a is 8 G* a.
    pub tangential_modulus: f64,
    /// Dundurs' second parameter beta; zero if pressure and traction are not coupled: beta = ((1 - 2 nu_1)/G_1 - (1 - 2
    /// nu_2)/G_2) / (2 ((1 - nu_1)/G_1 + (1 - nu_2)/G_2)). It is positive if body 1 has the larger value of (1 - 2 nu)/G,
    /// and an exchange of the bodies reverses its sign.
    pub dundurs_beta: f64,
    /// Nonzero if pressure and traction are coupled.
    pub is_coupled: i32,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Creates the half-spaces; nothing is computed yet. A NULL boundary means STICKSLIP_NON_PERIODIC.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_half_space_new(
    grid: *const stickslip_grid,
    body_1: *const stickslip_material,
    body_2: *const stickslip_material,
    boundary: *const stickslip_boundary,
    half_space: *mut *mut stickslip_half_space,
) -> stickslip_status {
    let none = std::ptr::null();
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        stickslip_half_space_new_coated(
            grid, body_1, none, 0, body_2, none, 0, boundary, half_space,
        )
    }
}

/// Creates coated half-spaces. Each body has at most eight layers, listed from the outermost inwards. A body without layers
/// is uncoated.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_half_space_new_coated(
    grid: *const stickslip_grid,
    body_1: *const stickslip_material,
    layers_1: *const stickslip_layer,
    layers_1_count: usize,
    body_2: *const stickslip_material,
    layers_2: *const stickslip_layer,
    layers_2_count: usize,
    boundary: *const stickslip_boundary,
    half_space: *mut *mut stickslip_half_space,
) -> stickslip_status {
    let alone = stickslip_ranks {
        rank: 0,
        size: 1,
        swap: None,
        user: std::ptr::null_mut(),
    };
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        stickslip_half_space_new_distributed(
            grid,
            body_1,
            layers_1,
            layers_1_count,
            body_2,
            layers_2,
            layers_2_count,
            boundary,
            &raw const alone,
            half_space,
        )
    }
}

/// Creates half-spaces whose rows are distributed over ranks, which solve contacts together. Results are bitwise identical
/// to the results of one process. Every rank passes the whole grid, and all ranks then make the same calls in the same
/// order. The grid of the object contains only the local rows, starting at the row that stickslip_half_space_first_row
/// returns. Arrays and labels contain the local cells; sums, reports and spots describe the whole contact.
///
/// Functions that return or accept only a grid do not account for the distribution, so the program must compute the local
/// gap itself. If the ranks are threads of one process, the program must call stickslip_set_num_threads(1), which keeps the
/// work of each rank on its own thread. Otherwise the ranks wait for the same threads forever.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_half_space_new_distributed(
    grid: *const stickslip_grid,
    body_1: *const stickslip_material,
    layers_1: *const stickslip_layer,
    layers_1_count: usize,
    body_2: *const stickslip_material,
    layers_2: *const stickslip_layer,
    layers_2_count: usize,
    boundary: *const stickslip_boundary,
    ranks: *const stickslip_ranks,
    half_space: *mut *mut stickslip_half_space,
) -> stickslip_status {
    call(|| {
        // SAFETY: the caller follows the rule for pointers.
        let place = unsafe { Place::of_object("half_space", half_space)? };
        // SAFETY: the caller follows the rule for pointers.
        let (grid, bodies, boundary, ranks, layers) = unsafe {
            let bodies = [input("body_1", body_1)?, input("body_2", body_2)?];
            let layers = [
                entries("layers_1", layers_1, layers_1_count)?,
                entries("layers_2", layers_2, layers_2_count)?,
            ];
            let boundary = optional("boundary", boundary)?;
            let ranks = input("ranks", ranks)?.checked()?;
            (input("grid", grid)?, bodies, boundary, ranks, layers)
        };
        let boundary = boundary.map_or(Ok(Boundary::NonPeriodic), stickslip_boundary::checked)?;
        let coated = |n: usize| -> Outcome<Material> {
            let layers = layers[n].iter().map(stickslip_layer::checked);
            let layers = layers.collect::<Outcome<Vec<Layer>>>()?;
            Ok(bodies[n].checked()?.coated(&layers)?)
        };
        let one = coated(0)?;
        let pair = ElasticPair::new(one, coated(1)?)?;
        let grid = grid.checked()?;
        let make = || HalfSpace::distributed(grid, pair, boundary, Arc::new(ranks));
        let bodies = enter(grid.cells(), make)?;
        let cells = bodies.grid().cells();
        give(place, bodies, cells)
    })
}

/// Writes the number of the first local row in the whole grid; this number is zero without ranks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_half_space_first_row(
    half_space: *const stickslip_half_space,
    row: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(half_space, ("row", row), |of| Ok(of.grid().rows().start)) }
}

/// Sets the meaning of the pressure and the traction of a cell, STICKSLIP_UNIFORM (default) or STICKSLIP_CENTRE, for
/// objects that are created afterwards. On a grid with STICKSLIP_PERIODIC the values are always those at the centres.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_half_space_set_cell_value(
    half_space: *mut stickslip_half_space,
    value: i32,
) -> stickslip_status {
    call(|| {
        // SAFETY: the caller follows the rule for pointers.
        let mut bodies = unsafe { changing(half_space.cast_const())? };
        let chosen = cell_value(value)?;
        let changed = bodies.clone().with_cell_value(chosen)?;
        *bodies = changed;
        Ok(())
    })
}

/// Writes the meaning of the pressure and the traction of a cell: STICKSLIP_UNIFORM or STICKSLIP_CENTRE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_half_space_cell_value(
    half_space: *const stickslip_half_space,
    value: *mut i32,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(half_space, ("value", value), |of| {
            Ok(match of.cell_value() {
                CellValue::Centre => STICKSLIP_CENTRE,
                _ => STICKSLIP_UNIFORM,
            })
        })
    }
}

/// Frees the half-spaces; does nothing if the pointer is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_half_space_free(
    half_space: *mut stickslip_half_space,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(half_space) })
}

/// Writes the grid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_half_space_grid(
    half_space: *const stickslip_half_space,
    grid: *mut stickslip_grid,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(half_space, ("grid", grid), |of| Ok(of.grid().into())) }
}

/// Writes the constants of the pair of materials.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_half_space_pair(
    half_space: *const stickslip_half_space,
    pair: *mut stickslip_pair,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(half_space, ("pair", pair), |of| {
            let own = of.pair();
            Ok(stickslip_pair {
                contact_modulus: own.contact_modulus(),
                tangential_modulus: own.tangential_modulus(),
                dundurs_beta: own.dundurs_beta(),
                is_coupled: i32::from(own.is_coupled()),
                reserved: [0; 8],
            })
        })
    }
}
