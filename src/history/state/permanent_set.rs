//! Permanent plastic deformation under the hardness of a history.

use crate::cgm::reduce;
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::history::state::State;
use crate::parallel::layout::Layout;

/// Removes the overlap from the surfaces of the cells whose new pressure is at the hardness. The surfaces then fit each
/// other under the same load. The contact under a smaller load is elastic.
pub(in crate::history) fn update_permanent_set(state: &mut State) {
    let (Some(yielded), Some(hardness)) = (&mut state.yielded, &state.hardness) else {
        return;
    };
    let (pressure, under_load) = state.normal.yielding_mut();
    let limits = hardness.limits();
    for (cell, pressure) in pressure.iter().enumerate() {
        let overlap = -under_load[cell];
        if overlap > 0.0 && limits.are_reached(cell, *pressure) {
            under_load[cell] = 0.0;
            yielded.as_mut_slice()[cell] += overlap;
            state.gap.as_mut_slice()[cell] += overlap;
            state.pressed_gap.as_mut_slice()[cell] += overlap;
        }
    }
}

/// Largest mean distance of a new gap from the gap with the permanent set that counts as equal, relative to the set.
const EQUAL: f64 = 0.05;
/// Least number of yielded cells for the comparison. The depth of wear can equal the set of fewer cells.
const LEAST_CELLS: usize = 10;

/// Returns an error if a new gap already contains the accumulated plastic depth, which [`add_yielded`] would add again. Changes of up
/// to a twentieth of this depth do not matter. The function is collective.
pub(in crate::history) fn check_without_set(
    state: &State,
    layout: &Layout,
    gap: &Field,
) -> Result<()> {
    let Some(yielded) = state.yielded.as_ref().map(Field::as_slice) else {
        return Ok(());
    };
    let (new, present) = (gap.as_slice(), state.gap.as_slice());
    let ([set, distance], cells) = reduce::sum(layout, |cell| {
        if yielded[cell] > 0.0 {
            ([yielded[cell], (new[cell] - present[cell]).abs()], 1)
        } else {
            ([0.0; 2], 0)
        }
    });
    if cells >= LEAST_CELLS && distance < EQUAL * set {
        return Err(Error::UnsupportedByModel {
            model: "a history with a permanent set",
            quantity: "a gap that already contains the set (largest depth)",
            value: reduce::max(layout, |cell| yielded[cell]),
            remedy: "change the gap as it was set, because the history adds the permanent set to it",
        });
    }
    Ok(())
}

/// Adds the accumulated plastic depth to a gap that the caller has set.
pub(in crate::history) fn add_yielded(state: &mut State) {
    if let Some(yielded) = &state.yielded {
        let cells = state.gap.as_mut_slice().iter_mut();
        for (gap, yielded) in cells.zip(yielded.as_slice()) {
            *gap += yielded;
        }
    }
}
