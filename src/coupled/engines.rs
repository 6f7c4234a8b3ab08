//! The engines of a coupled contact: on the window that it has, and on those it has left.

use crate::coupled::engine::Engine;
use crate::error::Result;
use crate::half_space::HalfSpace;
use crate::kept::Kept;
use crate::window::Window;

#[derive(Debug, Clone, Default)]
pub(super) struct Engines {
    /// `None` before the first contact.
    pub(super) present: Option<Engine>,
    kept: Kept<Engine>,
}

impl Engines {
    /// Counts a solve.
    pub(super) fn age(&mut self) {
        self.kept.age();
    }

    /// Goes on as after a step that ended with this window.
    pub(super) fn resume(&mut self, bodies: &HalfSpace, window: Option<Window>) -> Result<()> {
        let present = self.present.as_ref().map(|engine| engine.window);
        match window {
            Some(window) if present == Some(window) => {}
            Some(window) => self.work_on(bodies, window)?,
            None => self.present = None,
        }
        Ok(())
    }

    /// Changes to a window.
    pub(super) fn work_on(&mut self, bodies: &HalfSpace, window: Window) -> Result<()> {
        let window = bodies.place(window);
        let next = match self.kept.take(window.size) {
            Some(engine) => engine.at(window),
            None => Engine::new(bodies, window)?,
        };
        if let Some(left) = self.present.replace(next) {
            self.kept.leave(left.window.size, left, window.size);
        }
        Ok(())
    }
}
