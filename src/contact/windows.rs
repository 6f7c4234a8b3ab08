//! Loop over windows. A pass solves the contact on a window of the grid and checks the whole grid. If the window was too small,
//! the loop continues on a larger window.

use crate::contact::{HasSize, SizeCache};
use crate::error::{Error, Result};
use crate::grid::window::Window;
use crate::half_space::HalfSpace;

/// Overlap outside the window that round-off of a product can cause, relative to the largest displacement.
const ROUND_OFF: f64 = 1e-13;

/// A solver on a window.
pub(crate) trait WindowEngine: Sized {
    /// Creates the solver on a window placed by [`HalfSpace::place`].
    fn new(bodies: &HalfSpace, window: Window) -> Result<Self>;

    fn window(&self) -> Window;

    /// Moves the solver to another window of the same size.
    fn move_to(&mut self, bodies: &HalfSpace, window: Window);

    /// Releases the pooled buffers.
    fn rest(&mut self) {}
}

impl<E: WindowEngine> HasSize for E {
    fn size(&self) -> [usize; 2] {
        self.window().size
    }
}

/// Outcome of a pass on a window.
pub(crate) enum PassOutcome {
    /// The solution is accepted.
    Accepted,
    /// The error bound on the whole grid exceeds the bound on the window and the tolerance.
    BoundTooWide,
    /// Bodies overlap outside the window of the pass, within this window.
    OverlapOutside(Window),
}

/// The solver on the current window of a contact, and the solvers on earlier windows.
pub(crate) type Windows<E> = SizeCache<E>;

impl<E: WindowEngine> Windows<E> {
    /// Returns the window of the contact, or `None` before the first contact.
    pub(crate) fn window(&self) -> Option<Window> {
        self.present.as_ref().map(E::window)
    }

    /// Switches to the solver on a window, creating it if necessary.
    pub(crate) fn set_window(&mut self, bodies: &HalfSpace, window: Window) -> Result<()> {
        let window = bodies.place(window);
        let engine = self.get_or_create(window.size, || E::new(bodies, window))?;
        engine.move_to(bodies, window);
        Ok(())
    }

    /// Restores the state after a solve that ended with this window.
    pub(crate) fn resume(&mut self, bodies: &HalfSpace, window: Option<Window>) -> Result<()> {
        match window {
            _ if window == self.window() => {}
            Some(window) => self.set_window(bodies, window)?,
            None => self.present = None,
        }
        Ok(())
    }

    /// Runs passes on the current window. Each pass checks the whole grid and uses a fraction of the tolerance. If bodies overlap
    /// beyond the window, the next pass has a larger window. If the error bound is too large, the next pass is stricter.
    ///
    /// # Errors
    /// The errors of the passes, which also end the loop.
    pub(crate) fn solve(
        &mut self,
        bodies: &HalfSpace,
        mut pass: impl FnMut(&mut E, f64) -> Result<PassOutcome>,
    ) -> Result<()> {
        let mut part = 1.0;
        loop {
            let engine = self.present.as_mut().ok_or(Error::EmptyContact)?;
            match pass(engine, part)? {
                PassOutcome::Accepted => return Ok(()),
                PassOutcome::BoundTooWide => part *= 0.5,
                PassOutcome::OverlapOutside(missed) => {
                    let wider = engine.window().union(missed).widened(bodies.grid());
                    engine.rest();
                    self.set_window(bodies, wider)?;
                }
            }
        }
    }
}

/// Returns the bounding box of the overlapping cells outside a window. The bodies overlap in these cells by more than round-off
/// of the largest displacement. `gap` is the gap under load of a local cell.
pub(crate) fn overlap_outside(
    bodies: &HalfSpace,
    window: Window,
    largest: f64,
    gap: impl Fn(usize) -> f64 + Sync,
) -> Option<Window> {
    let (first, round_off) = (bodies.first_cell(), ROUND_OFF * largest);
    bodies.around(|i| gap(i) < -round_off && !window.contains(first + i))
}
