//! The engines of a coupled contact: on the window that it has, and on those it has left.

use crate::coupled::engine::Engine;
use crate::error::Result;
use crate::half_space::HalfSpace;
use crate::left_behind::LeftBehind;
use crate::window::Window;

#[derive(Debug, Clone, Default)]
pub(super) struct Engines {
    /// `None` before the first contact.
    pub(super) present: Option<Engine>,
    left_behind: LeftBehind<Engine>,
}

impl Engines {
    /// Counts a solve.
    pub(super) fn age(&mut self) {
        self.left_behind.age();
    }

    /// Goes on as after a step that ended with this window.
    pub(super) fn resume(&mut self, bodies: &HalfSpace, window: Option<Window>) -> Result<()> {
        match window {
            Some(window) => self.work_on(bodies, window)?,
            None => self.present = None,
        }
        Ok(())
    }

    /// Changes to a window.
    pub(super) fn work_on(&mut self, bodies: &HalfSpace, window: Window) -> Result<()> {
        let window = bodies.place(window);
        let (present, make) = (&mut self.present, || Engine::new(bodies, window));
        let engine = self.left_behind.provide(present, window.size, make)?;
        engine.move_to(bodies, window);
        Ok(())
    }
}
