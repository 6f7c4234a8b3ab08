//! The window of the contact, with the engine that works there.

use crate::error::Result;
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::history::engine::Engine;
use crate::history::layout::Layout;
use crate::history::memory::Memory;
use crate::history::motion::{Motion, centre};
use crate::history::state::State;
use crate::tangential::{Axis, Friction, Limits, Zone};
use crate::window::Window;

/// The engine on the window of the contact, and the step under way there.
///
/// Vectors have the [layout](Layout) of the engine.
#[derive(Debug, Clone)]
pub(super) struct Patch {
    pub(super) window: Window,
    pub(super) engine: Engine,
    /// Displacement u after the step under way.
    pub(super) next: Vec<f64>,
    pub(super) pressure: Vec<f64>,
    pub(super) limits: Limits,
}

impl Patch {
    pub(super) fn new(bodies: &HalfSpace, axis: Option<Axis>, window: Window) -> Result<Self> {
        let layout = Layout::new(axis, window.cells());
        Ok(Self {
            window,
            engine: Engine::new(bodies, axis, window.size)?,
            next: vec![0.0; layout.len()],
            pressure: vec![0.0; layout.cells],
            limits: Limits::new(layout.cells),
        })
    }

    /// Wide enough for a contact too, and a little wider, so that it may grow some more; with what its cells
    /// remember.
    pub(super) fn widened(
        &self,
        memory: &Memory,
        bodies: &HalfSpace,
        contact: Window,
        state: &State,
    ) -> Result<(Self, Memory)> {
        let (grid, axis) = (bodies.grid(), state.axis);
        let window = self.window.union(contact.widened(grid));
        let mut patch = Self::new(bodies, axis, window)?;
        let mut wider = Memory::first(grid, axis, window, state.motion);
        patch.take(state);
        wider.displacement = patch.engine.displacement();
        for (offset, displacement) in wider.offset.iter_mut().zip(&wider.displacement) {
            *offset += displacement;
        }
        let mut whole = vec![0.0; grid.cells()];
        let (wide, narrow) = (patch.layout(), self.layout());
        let pairs = wide
            .parts_mut(&mut wider.offset)
            .zip(narrow.parts(&memory.offset));
        for ((_, wide), (_, narrow)) in pairs {
            window.scatter(wide, &mut whole);
            for (i, offset) in self.window.indices().zip(narrow) {
                if state.zones[i] != Zone::Separate {
                    whole[i] = *offset;
                }
            }
            window.gather(&whole, wide);
        }
        Ok((patch, wider))
    }

    pub(super) fn layout(&self) -> Layout {
        self.engine.layout()
    }

    pub(super) fn set_limits(&mut self, pressure: &Field, friction: &Friction) {
        self.window.gather(pressure.as_slice(), &mut self.pressure);
        self.limits.set(friction, self.window, &self.pressure);
    }

    /// The shift that, with a twist, would leave the cell of the largest limit without traction: measured from
    /// there, a contact that has nowhere slipped asks for exactly none.
    pub(super) fn datum(&self, memory: &Memory, state: &State, twist: f64) -> [f64; 2] {
        let cells = self.limits.cells.iter().zip(self.window.indices());
        let strongest = cells
            .enumerate()
            .max_by(|(_, a), (_, b)| a.0.total_cmp(b.0));
        let Some((cell, (_, index))) = strongest else {
            return [0.0; 2];
        };
        let offset = self.layout().at(&memory.offset, cell);
        let turned = Motion {
            shift: offset,
            twist,
        }
        .at(centre(state.grid(), index));
        turned.map(|motion| -motion)
    }

    /// Starts from the last traction.
    fn take(&mut self, state: &State) {
        for (axis, part) in self.layout().parts_mut(self.engine.traction_mut()) {
            self.window
                .gather(state.traction[axis.index()].as_slice(), part);
        }
    }

    /// Poses the problem of a step: from the last traction, with a prescribed motion and the compliances
    /// of springs.
    pub(super) fn pose(
        &mut self,
        memory: &Memory,
        state: &State,
        prescribed: Motion,
        compliance: [f64; 2],
    ) {
        self.take(state);
        self.engine.set_compliance(compliance);
        let layout = self.layout();
        let linear = self.engine.linear_mut();
        for (k, i) in self.window.indices().enumerate() {
            let (offset, motion) = (
                layout.at(&memory.offset, k),
                prescribed.at(centre(state.grid(), i)),
            );
            // What cannot carry traction does not ask for any.
            let asked = if self.limits.cells[k] > 0.0 {
                [0, 1].map(|axis| -(offset[axis] + motion[axis]))
            } else {
                [0.0; 2]
            };
            layout.set(linear, k, asked);
        }
    }
}
