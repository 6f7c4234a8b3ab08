//! The lift due to the tractions between bodies of different materials, which a given pressure ignores.

use crate::bodies::component::Direction;
use crate::error::Result;
use crate::half_space::{ElasticOperator, HalfSpace};
use crate::memory::fallible;
use crate::operator::{Operator, Scratch};
use crate::tangential::{Lifting, PressureOnWindow, lift_residual};

/// Operators of the normal displacement due to tractions and pressure on a window.
#[derive(Debug, Clone)]
pub(in crate::rolling) struct SteadyLift {
    lifting: Lifting,
    lift: Vec<f64>,
    pressing: ElasticOperator<1>,
    scratch: Scratch,
    /// Normal displacement due to the pressure on the window.
    displacement: Vec<f64>,
}

impl SteadyLift {
    /// Creates the operators of coupled bodies. Returns `None` for bodies without coupling.
    pub(super) fn new(bodies: &HalfSpace, pressed: &PressureOnWindow) -> Result<Option<Self>> {
        if !bodies.pair().is_coupled() {
            return Ok(None);
        }
        let (size, cells) = (pressed.window().size, pressed.region.cells());
        let pressing = bodies.compliance([Direction::Z], size)?.operator;
        let mut created = Self {
            lifting: Lifting::new(bodies, size)?,
            lift: fallible::zeros(cells)?,
            scratch: pressing.scratch()?,
            pressing,
            displacement: fallible::zeros(cells)?,
        };
        created.press(pressed);
        Ok(Some(created))
    }

    /// Computes the normal displacement due to a new pressure.
    pub(super) fn press(&mut self, pressed: &PressureOnWindow) {
        let displacement = [&mut self.displacement[..]];
        self.pressing
            .apply([&pressed.pressure], displacement, &mut self.scratch);
    }

    /// Returns the residual that the lift due to tractions in this unit causes in the contact, relative to the normal
    /// displacement.
    pub(super) fn residual(
        &mut self,
        pressed: &PressureOnWindow,
        traction: [&[f64]; 2],
        unit: f64,
    ) -> f64 {
        self.lifting.lift(traction.map(Some), &mut self.lift);
        let (lift, displacement) = (&self.lift, &self.displacement);
        lift_residual(
            pressed.region.layout(),
            |i| pressed.pressure[i] > 0.0,
            |i| unit * lift[i],
            |i| displacement[i],
            false,
        )
    }
}
