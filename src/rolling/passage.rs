//! The way of the particles of rolling bodies through the contact in one step.

use crate::error::{Error, Result, finite, positive};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::rolling::LeadingEdge;
use crate::tangential::Axis;

/// Lines that are summed at once.
const LINES: usize = 4;

/// The way through a rectangle of cells.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WindowShift {
    pub(crate) size: [usize; 2],
    pub(crate) edge: LeadingEdge,
    pub(crate) cells: usize,
}

impl WindowShift {
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
    pub(crate) fn shift_with_particles(&self, field: &mut [f64]) {
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

    /// `(1 - T) f` in place; zero in cells whose particles come from beyond the window.
    pub(crate) fn difference(&self, field: &mut [f64]) {
        let [line, way] = self.line();
        for line in field.chunks_exact_mut(line) {
            let (cells, way) = (line.len(), way.min(line.len()));
            if self.edge.is_positive() {
                for cell in 0..cells - way {
                    line[cell] -= line[cell + way];
                }
                line[cells - way..].fill(0.0);
            } else {
                for cell in (way..cells).rev() {
                    line[cell] -= line[cell - way];
                }
                line[..way].fill(0.0);
            }
        }
    }

    /// The sum from the leading edge on, the inverse of `1 - T` for fields that vanish there, in place.
    pub(crate) fn sum(&self, field: &mut [f64]) {
        let [line, way] = self.line();
        // Several lines at once, so that additions overlap.
        for lines in field.chunks_mut(LINES * line) {
            for place in way..line {
                let (at, before) = if self.edge.is_positive() {
                    (line - 1 - place, line - 1 - place + way)
                } else {
                    (place, place - way)
                };
                for line in lines.chunks_exact_mut(line) {
                    line[at] += line[before];
                }
            }
        }
    }

    /// A cell that is the last on its particles' way.
    pub(crate) fn trailing_cell(&self) -> usize {
        if self.edge.is_positive() {
            0
        } else {
            self.size[0] * self.size[1] - 1
        }
    }

    /// The most cells, a step apart, that lie one behind the other where `length` cells do along the axis.
    pub(crate) fn chain(&self, length: usize) -> usize {
        length.div_ceil(self.cells)
    }
}

/// The way on a grid.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RollingShift {
    grid: Grid,
    edge: LeadingEdge,
    cells: usize,
    /// How far the bodies roll.
    pub(crate) length: f64,
    /// From where a particle is after the step to where it was before.
    pub(crate) back: [f64; 2],
}

impl RollingShift {
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
            return Err(Error::UnsupportedByModel {
                model: "the model of rolling",
                quantity: "a step along an axis on which the grid repeats",
                value: length,
                remedy: "roll along the other axis, or on a grid that does not repeat",
            });
        }
        Ok(())
    }

    /// The way through a rectangle of cells.
    pub(crate) fn through(&self, size: [usize; 2]) -> WindowShift {
        WindowShift {
            size,
            edge: self.edge,
            cells: self.cells,
        }
    }

    /// Where the particle of a cell of the grid was before, if that was on the grid.
    pub(crate) fn before(&self, cell: usize) -> Option<usize> {
        self.through(self.grid.size()).before(cell)
    }

    /// The traction of a cell that follows its pressure from `before` to `after`: their ratio hardly changes in a contact
    /// that rolls. A cell that comes into contact has the ratio of where its particle was.
    pub(crate) fn in_proportion(
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
    pub(crate) fn rotation_correction(&self, turn: f64) -> [f64; 2] {
        [-turn * self.back[1], turn * self.back[0]]
    }

    /// `Ok` if what is in contact is still on the grid after the step.
    pub(crate) fn check_behind(&self, bodies: &HalfSpace, pressure: &Field) -> Result<()> {
        let contact = contact_of(bodies, pressure);
        contact.map_or(Ok(()), |contact| self.behind(contact).map(|_| ()))
    }

    /// `Ok` if the particles of a contact at the end of the step were on the grid before it.
    pub(crate) fn check_ahead(&self, bodies: &HalfSpace, pressure: &Field) -> Result<()> {
        let contact = contact_of(bodies, pressure);
        contact.map_or(Ok(()), |contact| self.shifted_upstream(contact).map(|_| ()))
    }

    /// The window of a step, with where the particles in the contact of its end were before, and where those of the contact
    /// of its beginning have come to; if it has to be wider, it is by some more, so that the contact may grow.
    pub(crate) fn reach(
        &self,
        bodies: &HalfSpace,
        window: Window,
        [before, after]: [&Field; 2],
    ) -> Result<Window> {
        let mut reach = window;
        if let Some(contact) = contact_of(bodies, after) {
            reach = reach.union(self.shifted_upstream(contact)?);
        }
        if let Some(contact) = contact_of(bodies, before) {
            reach = reach.union(contact).union(self.behind(contact)?);
        }
        if reach == window {
            return Ok(window);
        }
        Ok(bodies.restrict_to_window(reach.widened(self.grid)))
    }

    /// Where the particles of a window were before the step.
    pub(crate) fn shifted_upstream(&self, window: Window) -> Result<Window> {
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
    pub(crate) fn margins(&self) -> [usize; 2] {
        let mut margins = [0; 2];
        margins[self.edge.axis().index()] = self.cells;
        margins
    }
}

fn contact_of(bodies: &HalfSpace, pressure: &Field) -> Option<Window> {
    let samples = pressure.as_slice();
    bodies
        .around(|i| samples[i] > 0.0)
        .map(|window| bodies.restrict_to_window(window))
}
