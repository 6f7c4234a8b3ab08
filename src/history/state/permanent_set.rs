//! Permanent plastic deformation under the hardness of a history.

use crate::history::state::State;

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

/// Adds the accumulated plastic depth to a gap that the caller has set.
pub(in crate::history) fn add_yielded(state: &mut State) {
    if let Some(yielded) = &state.yielded {
        let cells = state.gap.as_mut_slice().iter_mut();
        for (gap, yielded) in cells.zip(yielded.as_slice()) {
            *gap += yielded;
        }
    }
}
