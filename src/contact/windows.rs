//! The loop of a contact that is found on a window of the grid: solve there, look at the whole grid, go on where the window
//! was too small.

use crate::contact::{HasSize, SizeCache};
use crate::error::{Error, Result};
use crate::grid::window::Window;
use crate::half_space::HalfSpace;

/// Overlap beyond the window, relative to the largest displacement, that a product may show by itself.
const ROUND_OFF: f64 = 1e-13;

/// What solves on a window.
pub(crate) trait WindowEngine: Sized {
    /// On a window, as [`HalfSpace::place`] has it.
    fn new(bodies: &HalfSpace, window: Window) -> Result<Self>;

    fn window(&self) -> Window;

    /// Moves to another place of the same size.
    fn move_to(&mut self, bodies: &HalfSpace, window: Window);

    /// Gives the buffers back that it borrows.
    fn rest(&mut self) {}
}

impl<E: WindowEngine> HasSize for E {
    fn size(&self) -> [usize; 2] {
        self.window().size
    }
}

/// What a pass on a window has come to.
pub(crate) enum PassOutcome {
    /// The answer.
    Accepted,
    /// On the grid the bound is wider than on the window, and wider than was asked for.
    BoundTooWide,
    /// Bodies overlap there, beyond the window.
    OverlapOutside(Window),
}

/// What solves on the window that a contact has, and on those it has left.
pub(crate) type Windows<E> = SizeCache<E>;

impl<E: WindowEngine> Windows<E> {
    /// The window of the contact; `None` before the first.
    pub(crate) fn window(&self) -> Option<Window> {
        self.present.as_ref().map(E::window)
    }

    /// Changes to a window.
    pub(crate) fn set_window(&mut self, bodies: &HalfSpace, window: Window) -> Result<()> {
        let window = bodies.place(window);
        let engine = self.get_or_create(window.size, || E::new(bodies, window))?;
        engine.move_to(bodies, window);
        Ok(())
    }

    /// Goes on as after a solve that ended with this window.
    pub(crate) fn resume(&mut self, bodies: &HalfSpace, window: Option<Window>) -> Result<()> {
        match window {
            _ if window == self.window() => {}
            Some(window) => self.set_window(bodies, window)?,
            None => self.present = None,
        }
        Ok(())
    }

    /// Makes passes, each on the present window and with a look at the whole grid, to a part of the tolerance. Where bodies
    /// overlap beyond the window the next has a wider one; where the bound is too wide the next is stricter.
    ///
    /// # Errors
    /// Those of the passes, which also end it.
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

/// Around the cells beyond a window where bodies overlap by more than round-off of the largest displacement; `gap` is that
/// under load, of a cell held here.
pub(crate) fn overlap_outside(
    bodies: &HalfSpace,
    window: Window,
    largest: f64,
    gap: impl Fn(usize) -> f64 + Sync,
) -> Option<Window> {
    let (first, round_off) = (bodies.first_cell(), ROUND_OFF * largest);
    bodies.around(|i| gap(i) < -round_off && !window.contains(first + i))
}
