//! The way of the particles of rolling bodies through the contact in one step.

use crate::error::{Error, Result, finite, positive};
use crate::field::Field;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::history::LeadingEdge;
use crate::history::state::State;
use crate::tangential::{Axis, Motion};
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
        let [line, way] = self.line();
        let place = cell % line;
        if self.edge.is_positive() {
            (way < line - place).then(|| cell + way)
        } else {
            (way <= place).then(|| cell - way)
        }
    }

    /// `T f` in place, each value where its particle is after the step; zero in cells whose particles come from beyond the
    /// rectangle.
    pub(crate) fn carry(&self, field: &mut [f64]) {
        let [line, way] = self.line();
        let way = way.min(line);
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

    /// The cells of a line, and how far in it a particle moves: along y all rows are one line.
    pub(crate) fn line(&self) -> [usize; 2] {
        let [nx, ny] = self.size;
        match self.edge.axis() {
            Axis::X => [nx, self.cells],
            Axis::Y => [nx * ny, self.cells.saturating_mul(nx)],
        }
    }
}

/// The way on a grid.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Travel {
    grid: Grid,
    edge: LeadingEdge,
    cells: usize,
    /// How far the bodies roll.
    pub(crate) length: f64,
    /// From where a particle is after the step to where it was before.
    pub(super) back: [f64; 2],
}

impl Travel {
    pub(crate) fn new(grid: Grid, edge: LeadingEdge, cells: usize) -> Self {
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

    /// `Ok` if its length is positive and finite and the grid does not repeat along it.
    pub(crate) fn check(&self, bodies: &HalfSpace) -> Result<()> {
        positive("cells that a step rolls", self.cells as f64)?;
        let length = finite("length of a rolled step", self.length)?;
        bodies.kernel().check_no_operators("rolling")?;
        if bodies.boundary().repeats()[self.edge.axis().index()] {
            return Err(Error::NotModelled {
                model: "the model of rolling",
                quantity: "a step along an axis on which the grid repeats",
                value: length,
                remedy: "roll along the other axis, or on a grid that does not repeat",
            });
        }
        Ok(())
    }

    /// The way through a rectangle of cells.
    pub(crate) fn through(&self, size: [usize; 2]) -> Passage {
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

    /// The traction of a cell that follows its pressure from `before` to `after`: their ratio hardly changes in a contact
    /// that rolls. A cell that comes into contact has the ratio of where its particle was.
    pub(super) fn in_proportion(
        &self,
        traction: &Field,
        [before, after]: [&Field; 2],
        cell: usize,
    ) -> f64 {
        let [traction, before, after] = [traction, before, after].map(Field::as_slice);
        let touched = |cell: &usize| before[*cell] > 0.0;
        let like = Some(cell).filter(touched);
        let like = like.or_else(|| self.before(cell).filter(touched));
        like.map_or(0.0, |like| traction[like] / before[like] * after[cell])
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

    /// `Ok` if the particles of a contact at the end of the step were on the grid before it.
    pub(super) fn check_ahead(&self, bodies: &HalfSpace, pressure: &Field) -> Result<()> {
        let contact = contact_of(bodies, pressure);
        contact.map_or(Ok(()), |contact| self.ahead(contact).map(|_| ()))
    }

    /// The window of a step, with where the particles in the contact of its end were before, and where those of the contact
    /// of its beginning have come to; if it has to be wider, it is by some more, so that the contact may grow.
    pub(super) fn reach(
        &self,
        bodies: &HalfSpace,
        window: Window,
        [before, after]: [&Field; 2],
    ) -> Result<Window> {
        let mut reach = window;
        if let Some(contact) = contact_of(bodies, after) {
            reach = reach.union(self.ahead(contact)?);
        }
        if let Some(contact) = contact_of(bodies, before) {
            reach = reach.union(contact).union(self.behind(contact)?);
        }
        if reach == window {
            return Ok(window);
        }
        Ok(bodies.confined(reach.widened(self.grid)))
    }

    /// Where the particles of a window were before the step.
    pub(crate) fn ahead(&self, window: Window) -> Result<Window> {
        self.moved(window, true, "ahead of")
    }

    /// Where a window has come to after the step.
    fn behind(&self, window: Window) -> Result<Window> {
        self.moved(window, false, "behind")
    }

    /// A window that lies a step ahead or behind.
    fn moved(&self, window: Window, ahead: bool, side: &'static str) -> Result<Window> {
        let (axis, mut corner) = (self.edge.axis().index(), window.corner());
        let is_up = ahead == self.edge.is_positive();
        let room = if is_up {
            self.grid.size()[axis] - corner[axis] - window.size[axis]
        } else {
            corner[axis]
        };
        if room < self.cells {
            return Err(Error::GridTooShort {
                side,
                needed: self.cells,
                found: room,
            });
        }
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
    /// Writes to where the trend of a step is to be what it is measured from: the tractions that have followed the pressure
    /// from `before` on, if it has changed.
    pub(super) fn keep_traction(&mut self, travel: &Travel, before: Option<&Field>) {
        let (grid, after) = (self.grid(), self.normal.pressure());
        let before = before.unwrap_or(after);
        if let Some(memory) = &mut self.contact {
            let held = memory.window.held(grid);
            for (kept, traction) in memory.trend.change.iter_mut().zip(&self.traction) {
                for (kept, cell) in kept.iter_mut().zip(held.indices()) {
                    *kept = travel.in_proportion(traction, [before, after], cell);
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
