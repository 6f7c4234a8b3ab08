//! A contact that has become small is worked on in smaller windows.

use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::state::State;

/// Times the cells needed that a window has when it is left: to return to it costs no more than what a few steps in the
/// smaller one have saved.
const WASTE: f64 = 2.0;
/// The same of a window that the last step had to widen: that was a guess from an answer on too few cells.
const OVERSHOOT: f64 = 1.5;

/// Makes windows smaller that are much too large for the contact before the last step and after it. `before` is the
/// pressure that the step has changed, if it has, and `press_window` where that was found; `margins` is what rolling needs
/// beside the contact.
///
/// Nothing is lost: outside both contacts there is neither traction nor a memory of slip, and what a cell apart would
/// touch at follows from the tractions. The solvers of the next step follow the state.
pub(in crate::history) fn narrow(
    bodies: &HalfSpace,
    state: &mut State,
    before: Option<&Field>,
    press_window: Option<Window>,
    margins: [usize; 2],
) {
    let (grid, is_joint) = (state.grid(), state.is_joint());
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
    // Pressure and traction found together remember all of the grid.
    if let Some(memory) = state.contact.as_mut().filter(|_| !is_joint) {
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
