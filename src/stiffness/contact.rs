//! Solved contact, as input of a stiffness, and its values in the cells of a window.

use crate::error::{Result, finite};
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::{HalfSpace, Region};
use crate::memory::fallible;
use crate::normal::{Hardness, NormalSolution};
use crate::tangential::{Axis, Friction, TangentialSolution, Zone};

/// Pressure of a contact, and the friction that limits its tractions.
pub(crate) type Pressing<'a> = (&'a NormalSolution, &'a Friction);

/// Solved contact. Slices are empty if the stiffness does not depend on them.
#[derive(Clone, Copy)]
pub(crate) struct SolvedContact<'a> {
    pub(crate) bodies: &'a HalfSpace,
    pub(crate) hardness: Option<&'a Hardness>,
    /// Axis of the tractions in the scalar model.
    pub(crate) axis: Option<Axis>,
    pub(crate) zones: &'a [Zone],
    pub(crate) traction: [&'a [f64]; 2],
    /// Slip of the last step in the cells of `last_window`.
    pub(crate) slip: [&'a [f64]; 2],
    /// Entry compliance of the cells that came into contact in the last step, in the cells of `last_window`.
    pub(crate) entered: &'a [f64],
    /// Window of the last step, relative to the slab.
    pub(crate) last_window: Window,
    /// Windows in which the pressure and the tractions were solved, if known.
    pub(crate) windows: [Option<Window>; 2],
    /// Whether the pressure moves the surfaces tangentially while shear does not change the pressure.
    pub(crate) is_drawn: bool,
}

impl<'a> SolvedContact<'a> {
    /// Creates a contact of elastic bodies without values in its cells.
    pub(crate) fn of(bodies: &'a HalfSpace) -> Self {
        let grid = bodies.grid();
        Self {
            bodies,
            hardness: None,
            axis: None,
            zones: &[],
            traction: [&[]; 2],
            slip: [&[]; 2],
            entered: &[],
            last_window: Window::whole(grid).held(grid),
            windows: [None; 2],
            is_drawn: false,
        }
    }

    /// Creates a contact that was sheared from rest.
    pub(crate) fn sheared(bodies: &'a HalfSpace, shear: &'a TangentialSolution) -> Self {
        Self {
            axis: shear.axis(),
            zones: shear.zones(),
            traction: shear.traction().map(Field::as_slice),
            slip: shear.slip().map(Field::as_slice),
            ..Self::of(bodies)
        }
    }

    /// Returns the window of the contact solution, whose operators exist already. If this window is unknown or does not cover
    /// the contact, returns the smallest window around the contact. Returns `None` without contact.
    pub(crate) fn region(
        &self,
        found: Option<Window>,
        touches: impl Fn(usize) -> bool + Sync,
    ) -> Option<Region> {
        let bodies = self.bodies;
        let contact = bodies.around(touches)?;
        let found = found.filter(|window| window.covers(contact));
        let window = found.unwrap_or_else(|| bodies.restrict_to_window(contact));
        Some(Region::new(bodies, window))
    }

    /// Returns a value of the last step in a cell of the grid, or zero if there is no value.
    fn of_last_step(&self, part: &[f64], cell: usize) -> f64 {
        let place = self.last_window.place(cell);
        let value = place.and_then(|place| part.get(place));
        value.copied().unwrap_or(0.0)
    }
}

/// Returns an error for a periodic contact that is closed everywhere, because it resists a common motion without limit.
pub(crate) fn check_open(bodies: &HalfSpace, is_open: impl FnOnce() -> bool) -> Result<()> {
    if bodies.boundary() == Boundary::Periodic && !is_open() {
        finite(
            "stiffness of a contact that is closed everywhere",
            f64::INFINITY,
        )?;
    }
    Ok(())
}

/// Values of the contact in the cells of a window.
#[derive(Debug, Default)]
pub(crate) struct ContactCells {
    /// Change of the pressures of the local cells of the grid per unit of approach.
    pub(super) growth_on_grid: Vec<f64>,
    /// One in cells whose pressure follows the approach, else zero.
    pub(super) follows: Vec<f64>,
    /// Zone of each cell: zero for separated cells, one for sticking cells, two for slipping cells.
    pub(crate) zone: Vec<f64>,
    pub(crate) pressure: Vec<f64>,
    pub(crate) hardness: Vec<f64>,
    pub(crate) traction: [Vec<f64>; 2],
    pub(crate) slip: [Vec<f64>; 2],
    pub(crate) entered: Vec<f64>,
    /// Change of the friction limit, relative change of the pressure, and change of the pressure per unit of approach.
    pub(super) limit: Vec<f64>,
    pub(super) relative: Vec<f64>,
    pub(super) growth: Vec<f64>,
}

/// Copies the values of `of` for the local cells of the grid to the cells of the region.
pub(crate) fn collect(
    region: &Region,
    of: impl Fn(usize) -> f64,
    part: &mut Vec<f64>,
) -> Result<()> {
    fallible::resize(part, region.cells(), 0.0)?;
    region.collect(of, part);
    Ok(())
}

impl ContactCells {
    /// Copies tractions, slip and entry compliance to the cells of the region.
    pub(crate) fn take(&mut self, region: &Region, contact: &SolvedContact<'_>) -> Result<()> {
        for axis in [0, 1] {
            let (q, slip) = (contact.traction[axis], contact.slip[axis]);
            collect(region, |i| q[i], &mut self.traction[axis])?;
            let slip = |i: usize| contact.of_last_step(slip, i);
            collect(region, slip, &mut self.slip[axis])?;
        }
        let entered = |i: usize| contact.of_last_step(contact.entered, i);
        collect(region, entered, &mut self.entered)
    }
}
