//! Contact spots.

use stickslip_rs::{ContactSpots, Spot};

use crate::call::{Outcome, call_on};
use crate::error::Failure;
use crate::handle::reading;
use crate::history::stickslip_history;
use crate::normal::stickslip_normal_solution;
use crate::pointer::{Place, entries_mut, expect_cells};
use crate::status::{STICKSLIP_BUFFER_TOO_SMALL, stickslip_status};
use crate::tangential::stickslip_tangential_solution;

/// Contact spot: contact cells connected through their sides, also across the edges of a periodic grid.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_spot {
    /// Number of cells.
    pub cells: usize,
    /// Total area of the cells (a length squared).
    pub area: f64,
    /// Normal force on the spot.
    pub load: f64,
    /// Ratio of load to area (a pressure).
    pub mean_pressure: f64,
    /// Largest pressure of a cell (a pressure).
    pub max_pressure: f64,
    /// Centroid of the area (lengths), inside the grid; without meaning for a spot that spans the whole period.
    pub centroid: [f64; 2],
    /// Length of the edge along the sides of the cells (a length). For a round spot, this length exceeds the perimeter of
    /// the circle by a factor of 4/pi.
    pub perimeter: f64,
    /// Ratio of stick cells to all cells of the spot; NaN for a contact without a tangential load.
    pub stick_ratio: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<&Spot> for stickslip_spot {
    fn from(of: &Spot) -> Self {
        Self {
            cells: of.cells,
            area: of.area,
            load: of.load,
            mean_pressure: of.mean_pressure,
            max_pressure: of.max_pressure,
            centroid: of.centroid,
            perimeter: of.perimeter,
            stick_ratio: of.stick_ratio.unwrap_or(f64::NAN),
            reserved: [0; 8],
        }
    }
}

/// Output of the spot functions: a buffer with its capacity, the number of spots, and the labels of all cells with their
/// number.
type SpotOutputs = ((*mut stickslip_spot, usize, *mut usize), (*mut u32, usize));

/// Writes spots and labels.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
unsafe fn put(
    ((buffer, capacity, count), (labels, cells)): SpotOutputs,
    find: impl FnOnce() -> Outcome<ContactSpots>,
) -> Outcome {
    let name = "buffer of spots";
    // SAFETY: the caller follows the safety contract of this function.
    let (count, buffer, labels) = unsafe {
        let count = Place::new("count", count)?;
        let labels = if labels.is_null() {
            None
        } else {
            Some(entries_mut("labels", labels, cells)?)
        };
        (count, entries_mut(name, buffer, capacity)?, labels)
    };
    let found = find()?;
    if labels.is_some() {
        expect_cells("labels", found.grid(), cells)?;
    }
    let spots = found.as_slice();
    count.put(spots.len());
    if capacity > 0 && capacity < spots.len() {
        let lengths = [spots.len(), capacity];
        return Err(Failure::length(STICKSLIP_BUFFER_TOO_SMALL, name, lengths));
    }
    for (to, spot) in buffer.iter_mut().zip(spots) {
        *to = spot.into();
    }
    if let Some(labels) = labels {
        labels.copy_from_slice(found.labels());
    }
    Ok(())
}

/// Writes the contact spots, in the order of their first cells, to buffer, and their number to count. With a NULL buffer
/// and a capacity of 0 it writes only the number. If the buffer is too small, the call returns STICKSLIP_BUFFER_TOO_SMALL
/// and writes nothing to it.
///
/// The array labels (of length cells) receives the number of the spot of every cell, counted from one, and zero outside the
/// contact. This array may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_normal_solution_spots(
    solution: *const stickslip_normal_solution,
    buffer: *mut stickslip_spot,
    capacity: usize,
    count: *mut usize,
    labels: *mut u32,
    cells: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solution, || unsafe {
        let wanted = ((buffer, capacity, count), (labels, cells));
        put(wanted, || Ok(reading(solution)?.spots()?))
    })
}

/// Writes the contact spots under the pressure of a normal contact with the stick ratio of each, like
/// stickslip_normal_solution_spots.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_tangential_solution_spots(
    solution: *const stickslip_tangential_solution,
    normal: *const stickslip_normal_solution,
    buffer: *mut stickslip_spot,
    capacity: usize,
    count: *mut usize,
    labels: *mut u32,
    cells: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(solution, || unsafe {
        let wanted = ((buffer, capacity, count), (labels, cells));
        put(wanted, || {
            let (solution, normal) = (reading(solution)?, reading(normal)?);
            Ok(solution.spots(&normal)?)
        })
    })
}

/// Writes the contact spots after the last step with the stick ratio of each, like stickslip_normal_solution_spots.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_spots(
    history: *const stickslip_history,
    buffer: *mut stickslip_spot,
    capacity: usize,
    count: *mut usize,
    labels: *mut u32,
    cells: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let wanted = ((buffer, capacity, count), (labels, cells));
        put(wanted, || Ok(reading(history)?.spots()?))
    })
}
