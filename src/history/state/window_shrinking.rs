//! Reduction of the windows of a contact that has become small.

use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::state::State;

/// Ratio of the cells of a window to the needed cells. At this ratio a smaller window replaces the present window. A
/// few steps on the smaller window save at least the cost of a later return to the larger window.
const WASTE: f64 = 2.0;
/// Ratio for a window that the last step had to widen. The size of such a window was estimated from a solution on too
/// few cells.
const OVERSHOOT: f64 = 1.5;

/// Reduces windows that are too large, by [`WASTE`] or [`OVERSHOOT`], for the contact before and after the last step.
/// `before` is the earlier pressure if the step has changed the pressure. `press_window` is the window of the pressure
/// solve before the step. `margins` are the additional cells that rolling needs next to the contact.
///
/// No information is lost, because cells outside both contacts have no traction and no earlier slip. The offset of a
/// separated cell follows from the tractions. The solvers of the next step adopt the windows of the state.
pub(in crate::history) fn narrow(
    bodies: &HalfSpace,
    state: &mut State,
    before: Option<&Field>,
    press_window: Option<Window>,
    margins: [usize; 2],
) {
    let grid = state.grid();
    let after = state.pressure().as_slice();
    let before = before.map_or(after, Field::as_slice);
    let Some(contact) = bodies.around(|i| before[i] > 0.0 || after[i] > 0.0) else {
        return;
    };
    let needed = bodies.restrict_to_window(contact.widened(grid).with_margins(grid, margins));
    let smaller = |window: Window, waste: f64| {
        let is_left = window.cells() as f64 >= waste * needed.cells() as f64;
        needed.intersection(window).filter(|_| is_left)
    };
    // The memory of coupled bodies always covers the whole grid.
    let has_window = !state.is_joint();
    if let Some(memory) = state.contact.as_mut().filter(|_| has_window) {
        if let Some(window) = smaller(memory.window, WASTE) {
            memory.narrow(grid, window);
        }
    }
    let is_widened = press_window.is_some() && press_window != state.press_window;
    let waste = if is_widened { OVERSHOOT } else { WASTE };
    let left = state.press_window;
    if let Some((left, window)) = left.and_then(|left| Some((left, smaller(left, waste)?))) {
        let (held, held_before) = (window.held(grid), left.held(grid));
        for change in &mut state.trend.change {
            if change.len() == held_before.cells() {
                held.cut(held_before, change);
            }
        }
        state.press_window = Some(window);
    }
}
