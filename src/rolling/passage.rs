//! The paths of particles through the contact of rolling bodies in one step.

use crate::error::{Error, Result, finite, positive};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::rolling::LeadingEdge;
use crate::tangential::Axis;

/// Number of lines that are summed simultaneously.
const LINES: usize = 4;

/// Shift of particles through a rectangle of cells.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WindowShift {
    pub(crate) size: [usize; 2],
    pub(crate) edge: LeadingEdge,
    pub(crate) cells: usize,
}

impl WindowShift {
    /// Returns the previous position of the particle of a cell, or `None` if this position is outside the rectangle.
    pub(crate) fn before(&self, cell: usize) -> Option<usize> {
        let [line, way] = self.line();
        let place = cell % line;
        if self.edge.is_positive() {
            (way < line - place).then(|| cell + way)
        } else {
            (way <= place).then(|| cell - way)
        }
    }

    /// Applies T in place: moves each value with its particle over the step. Cells whose particles come from outside the
    /// rectangle become zero.
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

    /// Returns the number of cells per line and the shift of a particle within a line. For rolling along y all rows form
    /// one line.
    pub(crate) fn line(&self) -> [usize; 2] {
        let [nx, ny] = self.size;
        match self.edge.axis() {
            Axis::X => [nx, self.cells],
            Axis::Y => [nx * ny, self.cells.saturating_mul(nx)],
        }
    }

    /// Applies `1 - T` in place. Cells whose particles come from outside the window become zero.
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

    /// Sums in place from the leading edge. The sum is the inverse of `1 - T` for fields that vanish at the leading edge.
    pub(crate) fn sum(&self, field: &mut [f64]) {
        let [line, way] = self.line();
        // Several lines are summed simultaneously so that additions overlap.
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

    /// Returns a cell at the trailing end of the path of its particle.
    pub(crate) fn trailing_cell(&self) -> usize {
        if self.edge.is_positive() {
            0
        } else {
            self.size[0] * self.size[1] - 1
        }
    }

    /// Returns the length of the longest chain of cells one step apart, for `length` consecutive cells along the axis.
    pub(crate) fn chain(&self, length: usize) -> usize {
        length.div_ceil(self.cells)
    }
}

/// Shift of particles on a grid.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RollingShift {
    grid: Grid,
    edge: LeadingEdge,
    cells: usize,
    /// Length rolled per step.
    pub(crate) length: f64,
    /// Vector from the position of a particle after the step to its position before the step.
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

    /// Checks that the length is positive and finite and that the grid is not periodic along the rolling direction.
    pub(crate) fn check(&self, bodies: &HalfSpace) -> Result<()> {
        positive("number of cells that a step rolls", self.cells as f64)?;
        let length = finite("length of a rolling step", self.length)?;
        bodies.kernel().check_no_operators("rolling")?;
        if bodies.boundary().repeats()[self.edge.axis().index()] {
            return Err(Error::UnsupportedByModel {
                model: "the model of rolling",
                quantity: "a step along a periodic axis (value: the length of the step)",
                value: length,
                remedy: "roll along the other axis, or use a grid that is not periodic",
            });
        }
        Ok(())
    }

    /// Returns the motion of the particles through a rectangle of cells in one step.
    pub(crate) fn through(&self, size: [usize; 2]) -> WindowShift {
        WindowShift {
            size,
            edge: self.edge,
            cells: self.cells,
        }
    }

    /// Returns the previous position of the particle of a grid cell, or `None` if this position was outside the grid.
    pub(crate) fn before(&self, cell: usize) -> Option<usize> {
        self.through(self.grid.size()).before(cell)
    }

    /// Returns the traction of a cell after its pressure has changed from `before` to `after`, if the traction follows the
    /// pressure. In a rolling contact the ratio of traction to pressure hardly changes. A cell that comes into contact has
    /// the ratio at the previous position of its particle.
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

    /// Returns the displacement of a particle by a rotation at its previous position, minus the displacement at its
    /// position after the step.
    pub(crate) fn rotation_correction(&self, turn: f64) -> [f64; 2] {
        [-turn * self.back[1], turn * self.back[0]]
    }

    /// Checks that all particles in contact are still on the grid after the step.
    pub(crate) fn check_behind(&self, bodies: &HalfSpace, pressure: &Field) -> Result<()> {
        let contact = contact_of(bodies, pressure);
        contact.map_or(Ok(()), |contact| self.behind(contact).map(|_| ()))
    }

    /// Checks that all particles in the contact at the end of the step were on the grid before the step.
    pub(crate) fn check_ahead(&self, bodies: &HalfSpace, pressure: &Field) -> Result<()> {
        let contact = contact_of(bodies, pressure);
        contact.map_or(Ok(()), |contact| self.shifted_upstream(contact).map(|_| ()))
    }

    /// Returns the window of a step. The window contains the previous positions of the particles in the final contact. It
    /// also contains the final positions of the particles in the initial contact. If the window must be widened, it
    /// receives an additional margin for growth of the contact.
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

    /// Returns the window of the previous positions of particles in a window.
    pub(crate) fn shifted_upstream(&self, window: Window) -> Result<Window> {
        self.moved(window, true, "ahead of")
    }

    /// Returns the window of the positions after the step of particles in a window.
    fn behind(&self, window: Window) -> Result<Window> {
        self.moved(window, false, "behind")
    }

    /// Returns a window shifted by one step upstream (`shifted_upstream`) or downstream.
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

    /// Returns the margins by which a window must exceed the contact.
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
