//! The answer to a tangential contact.

use crate::boundary::Boundary;
use crate::contact_map::{ContactMap, Warning};
use crate::field::Field;
use crate::grid::Grid;
use crate::report::Report;
use crate::tangential::{Axis, Zone};
use crate::window::Window;

/// Traction, slip, zones and shift of a tangential contact.
///
/// Vectors are `[x, y]`; the scalar model leaves the component across the load at zero.
#[derive(Debug, Clone, PartialEq)]
pub struct TangentialSolution {
    traction: [Field; 2],
    slip: [Field; 2],
    zones: Vec<Zone>,
    boundary: Boundary,
    axis: Axis,
    shift: f64,
    report: Report,
}

/// What a solver hands over, on the window of the contact.
pub(super) struct Answer<'a> {
    pub(super) window: Window,
    pub(super) axis: Axis,
    pub(super) pressure: &'a [f64],
    pub(super) limits: &'a [f64],
    pub(super) traction: &'a [f64],
    pub(super) displacement: &'a [f64],
    pub(super) shift: f64,
    pub(super) report: &'a Report,
}

impl TangentialSolution {
    /// No contact yet.
    pub(super) fn empty(grid: Grid, boundary: Boundary) -> Self {
        let zeros = || [Field::zeros(grid), Field::zeros(grid)];
        Self {
            traction: zeros(),
            slip: zeros(),
            zones: vec![Zone::Separate; grid.cells()],
            boundary,
            axis: Axis::X,
            shift: 0.0,
            report: Report::unsolved(),
        }
    }

    pub(super) fn fill(&mut self, answer: &Answer<'_>) {
        // The component across the load is zero already unless the axis has changed.
        self.zones.fill(Zone::Separate);
        for field in [&mut self.traction, &mut self.slip] {
            field[self.axis.index()].as_mut_slice().fill(0.0);
        }
        self.axis = answer.axis;
        self.shift = answer.shift;
        self.report.clone_from(answer.report);
        let traction = self.traction[answer.axis.index()].as_mut_slice();
        let slip = self.slip[answer.axis.index()].as_mut_slice();
        for (k, i) in answer.window.indices().enumerate() {
            if answer.pressure[k] > 0.0 {
                traction[i] = answer.traction[k];
                self.zones[i] = if answer.traction[k].abs() < answer.limits[k] {
                    Zone::Stick
                } else {
                    slip[i] = answer.displacement[k] - answer.shift;
                    Zone::Slip
                };
            }
        }
    }

    /// The grid of all its fields.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.traction[0].grid()
    }

    /// Shear traction q on body 1 along x and along y (pressures), positive along the axis; exactly
    /// zero outside the contact.
    #[must_use]
    pub fn traction(&self) -> [&Field; 2] {
        self.traction.each_ref()
    }

    /// Slip `s = u - delta` of the surface of body 1 over that of body 2 (lengths): against the traction in
    /// slip cells, exactly zero in stick cells and outside the contact.
    #[must_use]
    pub fn slip(&self) -> [&Field; 2] {
        self.slip.each_ref()
    }

    /// What lies beyond the edge of the grid.
    #[must_use]
    pub fn boundary(&self) -> Boundary {
        self.boundary
    }

    /// The zone of every cell, row-major with x fastest.
    #[must_use]
    pub fn zones(&self) -> &[Zone] {
        &self.zones
    }

    /// The axis of the load.
    #[must_use]
    pub fn axis(&self) -> Axis {
        self.axis
    }

    /// Shift delta, the rigid motion of body 2 relative to body 1 (lengths, of the sign of the force):
    /// prescribed, or the multiplier of the force. On a periodic grid it is measured from the mean plane
    /// of the surface.
    /// Under a force that slides the whole contact, the shift at which the last cell lets go.
    #[must_use]
    pub fn shift(&self) -> [f64; 2] {
        self.vector(self.shift)
    }

    /// Tangential force that body 2 exerts on body 1, the integral of the traction.
    #[must_use]
    pub fn force(&self) -> [f64; 2] {
        self.vector(self.traction[self.axis.index()].integral())
    }

    /// Whether the whole contact slips.
    #[must_use]
    pub fn is_gross_sliding(&self) -> bool {
        self.cells(Zone::Stick) == 0 && self.cells(Zone::Slip) > 0
    }

    /// Stick area over contact area, by counting cells; zero for an empty solution.
    #[must_use]
    pub fn stick_ratio(&self) -> f64 {
        let (stick, slip) = (self.cells(Zone::Stick), self.cells(Zone::Slip));
        if stick == 0 {
            0.0
        } else {
            stick as f64 / (stick + slip) as f64
        }
    }

    /// Area of the stick zone, by counting cells.
    #[must_use]
    pub fn stick_area(&self) -> f64 {
        self.cells(Zone::Stick) as f64 * self.grid().cell_area()
    }

    /// Area of the slip zone, by counting cells.
    #[must_use]
    pub fn slip_area(&self) -> f64 {
        self.cells(Zone::Slip) as f64 * self.grid().cell_area()
    }

    /// Energy dissipated by the step, `-Delta sum q s >= 0`, with the tractions at its end.
    #[must_use]
    pub fn dissipated_energy(&self) -> f64 {
        let axis = self.axis.index();
        let (traction, slip) = (&self.traction[axis], &self.slip[axis]);
        let work: f64 = traction
            .as_slice()
            .iter()
            .zip(slip.as_slice())
            .map(|(q, s)| q * s)
            .sum();
        // Not the negative of it: full stick dissipates 0, not -0.
        0.0 - work * self.grid().cell_area()
    }

    /// How the solve ended, what it cost, how large its error can be.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Remarks on the contact: at the edge of the grid, spots too small to resolve.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let contact = ContactMap {
            grid: self.grid(),
            boundary: self.boundary,
            contains: |i: usize| self.zones[i] != Zone::Separate,
        };
        contact.warnings()
    }

    fn cells(&self, zone: Zone) -> usize {
        self.zones.iter().filter(|&&z| z == zone).count()
    }

    fn vector(&self, value: f64) -> [f64; 2] {
        match self.axis {
            Axis::X => [value, 0.0],
            Axis::Y => [0.0, value],
        }
    }
}
