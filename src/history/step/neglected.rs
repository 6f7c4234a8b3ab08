//! Lift due to tractions that the pressure of a step ignores.

use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::memory::fallible;
use crate::normal::NormalSolution;
use crate::tangential::{Axis, Lifting, StepSolution, lift_residual};
use crate::warning::Warning;

/// Operator of the lift on the window of a contact with one-way coupling, and the lift of the last rolled step.
#[derive(Debug, Clone)]
pub(in crate::history) struct StepLift {
    size: [usize; 2],
    lifting: Lifting,
    lift: Vec<f64>,
    /// Lift in millionths of the normal displacement, if the lift exceeds the tolerance.
    pub(super) found: Option<usize>,
}

impl StepLift {
    /// Measures the lift due to the tractions of a step. `pressed` contains the normal contact and its gap before
    /// loading. The buffers in `slot` are reused if they have the size of the window.
    pub(in crate::history) fn measure(
        slot: &mut Option<Self>,
        bodies: &HalfSpace,
        answer: &StepSolution<'_>,
        (normal, gap): (&NormalSolution, &Field),
        tolerance: f64,
    ) -> Result<()> {
        let size = answer.region.window().size;
        let of_size = slot.take().filter(|own| own.size == size);
        let own = match of_size {
            Some(own) => slot.insert(own),
            None => slot.insert(Self {
                size,
                lifting: Lifting::new(bodies, size)?,
                lift: fallible::zeros(answer.region.cells())?,
                found: None,
            }),
        };
        let traction = [Axis::X, Axis::Y].map(|axis| {
            let is_solved = answer.axes.contains(&axis);
            is_solved.then_some(answer.traction[axis.index()])
        });
        own.lifting.lift(traction, &mut own.lift);
        let (window, lift) = (answer.region.own(), &own.lift);
        let (gap, under_load) = (gap.as_slice(), normal.gap().as_slice());
        let residual = lift_residual(
            answer.region.layout(),
            |k| answer.pressure[k] > 0.0,
            |k| lift[k],
            |k| {
                let i = window.index(k);
                under_load[i] + (normal.approach() - gap[i])
            },
            false,
        );
        own.found = Warning::lift_beyond(residual, tolerance);
        Ok(())
    }
}
