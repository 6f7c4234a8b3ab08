//! Edges of contacts and stick zones inside the cells, and estimates of the discretisation error.

use stickslip_rs::edges::{Edges, TangentialEdges};
use stickslip_rs::{Field, Grid};

use crate::call::{Outcome, call_on};
use crate::coupled::stickslip_coupled_solution;
use crate::handle::reading;
use crate::inputs::stickslip_friction;
use crate::normal::stickslip_normal_solution;
use crate::pointer::{Place, cells_mut, input};
use crate::status::stickslip_status;
use crate::tangential::stickslip_tangential_solution;
use crate::text_fields::tell;

/// Edges of a contact and of its stick zone, located inside the cells. The members for the stick zone and the traction are
/// NaN for a contact without a tangential load.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_edges {
    /// Area of the contact, including the covered parts of the edge cells (a length squared).
    pub contact_area: f64,
    /// Fraction of the cells at the edge of the contact whose fit was rejected. Such a cell contributes a mean fraction of
    /// its area and keeps its own pressure.
    pub unfitted_fraction: f64,
    /// Largest pressure at the centre of a cell (a pressure).
    pub peak_pressure: f64,
    /// Area of the stick zone (a length squared).
    pub stick_area: f64,
    /// Area of the slip zone (a length squared).
    pub slip_area: f64,
    /// Ratio of stick area to contact area; zero without contact.
    pub stick_ratio: f64,
    /// Fraction of the cells at the edge of the stick zone whose fit was rejected.
    pub stick_unfitted_fraction: f64,
    /// Largest magnitude of the traction at the centre of a cell (a pressure).
    pub peak_traction: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<&Edges> for stickslip_edges {
    fn from(of: &Edges) -> Self {
        Self {
            contact_area: of.area(),
            unfitted_fraction: of.unfitted_fraction(),
            peak_pressure: of.centres().max(),
            stick_area: f64::NAN,
            slip_area: f64::NAN,
            stick_ratio: f64::NAN,
            stick_unfitted_fraction: f64::NAN,
            peak_traction: f64::NAN,
            reserved: [0; 8],
        }
    }
}

impl From<&TangentialEdges> for stickslip_edges {
    fn from(of: &TangentialEdges) -> Self {
        Self {
            stick_area: of.stick_area(),
            slip_area: of.slip_area(),
            stick_ratio: of.stick_ratio(),
            stick_unfitted_fraction: of.stick().unfitted_fraction(),
            peak_traction: of.peak_traction(),
            ..of.contact().into()
        }
    }
}

/// Output of the edge functions: the edges, the values at the centres, the means, and the number of cells.
type EdgeOutputs = (*mut stickslip_edges, [*mut f64; 2], usize);

/// Writes edges and the corresponding fields.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
unsafe fn put<E>(
    (edges, fields, cells): EdgeOutputs,
    grid: Grid,
    found: impl FnOnce() -> Outcome<E>,
    fields_of: impl FnOnce(&E) -> [&Field; 2],
) -> Outcome
where
    for<'e> stickslip_edges: From<&'e E>,
{
    let names = ["centres", "means"];
    // SAFETY: the caller follows the safety contract of this function.
    let (place, [centres, means]) = unsafe {
        let place = Place::new("edges", edges)?;
        let asked = |k: usize| -> Outcome<Option<&mut [f64]>> {
            let field: *mut f64 = fields[k];
            if field.is_null() {
                return Ok(None);
            }
            cells_mut(names[k], grid, field, cells).map(Some)
        };
        (place, [asked(0)?, asked(1)?])
    };
    let found = found()?;
    for (to, from) in [centres, means].into_iter().zip(fields_of(&found)) {
        if let Some(to) = to {
            to.copy_from_slice(from.as_slice());
        }
    }
    place.put((&found).into());
    Ok(())
}

/// Computes the edge of the contact inside the cells, and the pressure corrected for this edge.
///
/// The arrays centres and means (of length cells) receive the pressure at the centres of the cells and its means over the
/// cells. Either array may be NULL. The results are most accurate with STICKSLIP_CENTRE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solution_edges(
    solution: *const stickslip_normal_solution,
    edges: *mut stickslip_edges,
    centres: *mut f64,
    means: *mut f64,
    cells: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solution, || unsafe {
        let solution = reading(solution)?;
        let wanted = (edges, [centres, means], cells);
        put(wanted, solution.grid(), || Ok(solution.edges()?), pressures)
    })
}

/// Computes the edges of the contact and of the stick zone inside the cells. The normal solution and the friction must be
/// those of the problem. The method assumes a contact that is loaded once.
///
/// The arrays centres and means (of length cells) receive the magnitude of the traction at the centres of the cells and its
/// means over the cells. Either array may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_edges(
    solution: *const stickslip_tangential_solution,
    normal: *const stickslip_normal_solution,
    friction: *const stickslip_friction,
    edges: *mut stickslip_edges,
    centres: *mut f64,
    means: *mut f64,
    cells: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solution, || unsafe {
        let (solution, normal) = (reading(solution)?, reading(normal)?);
        let grid = solution.grid();
        let friction = input("friction", friction)?.checked(grid)?;
        let wanted = (edges, [centres, means], cells);
        let find = || Ok(solution.edges(&normal, &friction)?);
        put(wanted, grid, find, tractions)
    })
}

/// Computes the edges of a coupled contact, like stickslip_tangential_solution_edges. The corresponding pressure comes from
/// stickslip_coupled_solution_pressure_edges.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_edges(
    solution: *const stickslip_coupled_solution,
    friction: *const stickslip_friction,
    edges: *mut stickslip_edges,
    centres: *mut f64,
    means: *mut f64,
    cells: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solution, || unsafe {
        let solution = reading(solution)?;
        let (normal, tangential) = (solution.normal(), solution.tangential());
        let grid = normal.grid();
        let friction = input("friction", friction)?.checked(grid)?;
        let wanted = (edges, [centres, means], cells);
        let find = || Ok(tangential.edges(normal, &friction)?);
        put(wanted, grid, find, tractions)
    })
}

/// Computes the edge of a coupled contact with its pressure, like stickslip_normal_solution_edges.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_pressure_edges(
    solution: *const stickslip_coupled_solution,
    edges: *mut stickslip_edges,
    centres: *mut f64,
    means: *mut f64,
    cells: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solution, || unsafe {
        let solution = reading(solution)?;
        let normal = solution.normal();
        let wanted = (edges, [centres, means], cells);
        put(wanted, normal.grid(), || Ok(normal.edges()?), pressures)
    })
}

fn pressures(found: &Edges) -> [&Field; 2] {
    [found.centres(), found.means()]
}

fn tractions(found: &TangentialEdges) -> [&Field; 2] {
    [found.traction(), found.mean_traction()]
}

/// Estimates the relative discretisation error of the pressure: the sum of the absolute errors of the cell means,
/// relative to the sum of the pressure. The estimate is NaN without contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solution_discretisation_estimate(
    solution: *const stickslip_normal_solution,
    estimate: *mut f64,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(solution, ("estimate", estimate), |of| {
            Ok(of.discretisation_estimate().unwrap_or(f64::NAN))
        })
    }
}

/// Estimates the relative discretisation error of the traction, like stickslip_normal_solution_discretisation_estimate.
/// The estimate is NaN without traction.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_discretisation_estimate(
    solution: *const stickslip_tangential_solution,
    estimate: *mut f64,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(solution, ("estimate", estimate), |of| {
            Ok(of.discretisation_estimate().unwrap_or(f64::NAN))
        })
    }
}

/// Estimates the relative discretisation errors of the pressure and the traction of a coupled contact. An estimate is NaN
/// without contact or without traction.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_coupled_solution_discretisation_estimates(
    solution: *const stickslip_coupled_solution,
    of_pressure: *mut f64,
    of_traction: *mut f64,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solution, || unsafe {
        let places = [
            Place::new("of_pressure", of_pressure)?,
            Place::new("of_traction", of_traction)?,
        ];
        let solution = reading(solution)?;
        let estimates = [
            solution.normal().discretisation_estimate(),
            solution.tangential().discretisation_estimate(),
        ];
        for (place, found) in places.into_iter().zip(estimates) {
            place.put(found.unwrap_or(f64::NAN));
        }
        Ok(())
    })
}
