//! The way of the particles of rolling bodies through the contact in one step.

use crate::error::{Error, Result, at_least};
use crate::field::Field;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::history::LeadingEdge;
use crate::history::state::State;
use crate::tangential::Motion;
use crate::window::Window;

/// The way through a rectangle of cells.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Passage {
    pub(crate) size: [usize; 2],
    pub(crate) edge: LeadingEdge,
    pub(crate) cells: usize,
}

impl Passage {
    /// Where the particle of a cell was before, if that is in the rectangle.
    pub(crate) fn before(&self, cell: usize) -> Option<usize> {
        let [nx, _] = self.size;
        let axis = self.edge.axis().index();
        let (place, stride) = ([cell % nx, cell / nx][axis], [1, nx][axis]);
        if self.cells >= self.size[axis] {
            return None;
        }
        let way = self.cells * stride;
        if self.edge.is_positive() {
            (place + self.cells < self.size[axis]).then(|| cell + way)
        } else {
            (place >= self.cells).then(|| cell - way)
        }
    }

    /// `T f` in place, each value where its particle is after the step; zero in cells whose particles come from beyond the
    /// rectangle.
    pub(crate) fn carry(&self, field: &mut [f64]) {
        let [nx, _] = self.size;
        let axis = self.edge.axis().index();
        let way = self.cells.min(self.size[axis]) * [1, nx][axis];
        let line = [nx, field.len()][axis];
        for line in field.chunks_exact_mut(line) {
            let kept = line.len() - way;
            if self.edge.is_positive() {
                line.copy_within(way.., 0);
                line[kept..].fill(0.0);
            } else {
                line.copy_within(..kept, way);
                line[..way].fill(0.0);
            }
        }
    }
}

/// The way on the grid of a history.
#[derive(Debug, Clone, Copy)]
pub(super) struct Travel {
    grid: Grid,
    edge: LeadingEdge,
    cells: usize,
    /// How far the bodies roll.
    pub(super) length: f64,
    /// From where a particle is after the step to where it was before.
    pub(super) back: [f64; 2],
}

impl Travel {
    pub(super) fn new(grid: Grid, edge: LeadingEdge, cells: usize) -> Self {
        let axis = edge.axis().index();
        let length = [grid.dx(), grid.dy()][axis] * cells as f64;
        let mut back = [0.0; 2];
        back[axis] = if edge.is_positive() { length } else { -length };
        Self {
            grid,
            edge,
            cells,
            length,
            back,
        }
    }

    /// The way through a rectangle of cells.
    pub(super) fn through(&self, size: [usize; 2]) -> Passage {
        Passage {
            size,
            edge: self.edge,
            cells: self.cells,
        }
    }

    /// Where the particle of a cell of the grid was before, if that was on the grid.
    pub(super) fn before(&self, cell: usize) -> Option<usize> {
        self.through(self.grid.size()).before(cell)
    }

    /// What a turn moves a particle beyond the turn of where it is after the step, because it was elsewhere before.
    pub(super) fn turned(&self, turn: f64) -> [f64; 2] {
        [-turn * self.back[1], turn * self.back[0]]
    }

    /// `Ok` if what is in contact is still on the grid after the step.
    pub(super) fn check_behind(&self, bodies: &HalfSpace, pressure: &Field) -> Result<()> {
        let contact = contact_of(bodies, pressure);
        contact.map_or(Ok(()), |contact| self.behind(contact).map(|_| ()))
    }

    /// The window of a step, with where the particles in the contact of its end were before, and where those of the contact
    /// of its beginning have come to.
    pub(super) fn reach(
        &self,
        bodies: &HalfSpace,
        window: Window,
        [before, after]: [&Field; 2],
    ) -> Result<Window> {
        let mut reach = window;
        if let Some(contact) = contact_of(bodies, after) {
            reach = reach.union(self.moved(contact, true, "cells ahead of the contact")?);
        }
        if let Some(contact) = contact_of(bodies, before) {
            reach = reach.union(contact).union(self.behind(contact)?);
        }
        Ok(reach)
    }

    /// Where a window has come to after the step.
    fn behind(&self, window: Window) -> Result<Window> {
        self.moved(window, false, "cells behind the contact")
    }

    /// A window that lies a step ahead or behind.
    fn moved(&self, window: Window, ahead: bool, rest: &'static str) -> Result<Window> {
        let (axis, mut corner) = (self.edge.axis().index(), window.corner());
        let is_up = ahead == self.edge.is_positive();
        let room = if is_up {
            self.grid.size()[axis] - corner[axis] - window.size[axis]
        } else {
            corner[axis]
        };
        at_least("those of a step", self.cells as f64, rest, room as f64)?;
        corner[axis] = if is_up {
            corner[axis] + self.cells
        } else {
            corner[axis] - self.cells
        };
        Window::at(self.grid, corner, window.size).ok_or(Error::EmptyContact)
    }

    /// How much wider than the contact a window has to be.
    pub(super) fn margins(&self) -> [usize; 2] {
        let mut margins = [0; 2];
        margins[self.edge.axis().index()] = self.cells;
        margins
    }
}

fn contact_of(bodies: &HalfSpace, pressure: &Field) -> Option<Window> {
    let samples = pressure.as_slice();
    bodies
        .around(|i| samples[i] > 0.0)
        .map(|window| bodies.confined(window))
}

impl State {
    /// Writes the tractions of the cells to where the trend of a step is to be.
    pub(super) fn keep_traction(&mut self) {
        let grid = self.grid();
        if let Some(memory) = &mut self.contact {
            let held = memory.window.held(grid);
            for (kept, traction) in memory.trend.change.iter_mut().zip(&self.traction) {
                if !kept.is_empty() {
                    held.gather(traction.as_slice(), kept);
                }
            }
        }
    }

    /// Carries what the particles have to where they are after a step that ended with this motion; they come without any of
    /// it from beyond the grid.
    pub(super) fn carry(&mut self, travel: &Travel, end: Motion) {
        let passage = travel.through(self.grid().size());
        let fields = [&mut self.accumulated_slip, &mut self.dissipated_energy];
        for field in self.traction.iter_mut().chain(&mut self.slip).chain(fields) {
            passage.carry(field.as_mut_slice());
        }
        if let Some(memory) = &mut self.contact {
            let passage = travel.through(memory.window.size);
            for part in memory
                .displacement
                .iter_mut()
                .filter(|part| !part.is_empty())
            {
                passage.carry(part);
            }
            let turned = travel.turned(0.5 * (self.motion.twist + end.twist));
            for (part, turned) in memory.offset.iter_mut().zip(turned) {
                if !part.is_empty() {
                    passage.carry(part);
                }
                for offset in part {
                    *offset += turned;
                }
            }
        }
    }
}
