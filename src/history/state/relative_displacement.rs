//! Relative displacement of the bodies that the contact does not cause, in the steps of a history.

use crate::error::{Error, Result, finite};
use crate::grid::field::clone_in_place;
use crate::half_space::HalfSpace;
use crate::history::state::{State, clones};
use crate::history::{History, LoadStep};
use crate::memory::fallible::{TryClone, try_clone};
use crate::tangential::RelativeDisplacement;
use crate::warning::Warning;

/// Pattern of relative displacement, its present amount, and the resulting displacement of each cell.
#[derive(Debug)]
pub(in crate::history) struct RelativeDisplacementState {
    pub(in crate::history) pattern: RelativeDisplacement,
    pub(in crate::history) amount: f64,
    /// Displacement that is included in the offsets. The displacement belongs to an earlier pattern if the pattern has
    /// changed since the last step.
    pub(in crate::history) reached: RelativeDisplacement,
}

clones!(RelativeDisplacementState { pattern, reached } { amount });

impl RelativeDisplacementState {
    /// Creates a state with zero displacement.
    pub(in crate::history) fn new(pattern: RelativeDisplacement) -> Result<Self> {
        let [along_x, _] = pattern.fields();
        Ok(Self {
            reached: RelativeDisplacement::zeros(along_x.grid())?,
            amount: 0.0,
            pattern,
        })
    }

    /// Returns the amount at the end of a step.
    fn end(&self, load: &LoadStep) -> f64 {
        load.relative_amount().unwrap_or(self.amount)
    }
}

impl State {
    /// Returns an error if a step prescribes an amount but the history has no pattern.
    pub(in crate::history) fn check_relative(&self, load: &LoadStep) -> Result<()> {
        let Some(amount) = load.relative_amount() else {
            return Ok(());
        };
        finite("amount of the relative displacement", amount)?;
        match &self.relative {
            Some(relative) => {
                let largest = relative.pattern.largest();
                finite("largest relative displacement", amount * largest)?;
            }
            None if amount != 0.0 => {
                return Err(Error::UnsupportedByModel {
                    model: "the model of this history",
                    quantity: "a relative displacement",
                    value: amount,
                    remedy: "build the history with a pattern of relative displacement",
                });
            }
            None => {}
        }
        Ok(())
    }

    /// Returns the displacement of a cell along an axis in a step.
    pub(in crate::history) fn displaced_by(
        &self,
        load: &LoadStep,
    ) -> Option<impl Fn(usize, usize) -> f64 + use<'_>> {
        let relative = self.relative.as_ref()?;
        let RelativeDisplacementState {
            pattern, reached, ..
        } = relative;
        let amount = relative.end(load);
        Some(move |axis, cell| amount * pattern.at(axis, cell) - reached.at(axis, cell))
    }

    /// Returns the largest displacement of a contact cell in a step over the longest side of the grid, in tenths, or `None` if
    /// it is small.
    pub(in crate::history) fn displacement_tenths(
        &self,
        bodies: &HalfSpace,
        load: &LoadStep,
    ) -> Option<usize> {
        let displacement = self.displaced_by(load)?;
        let pressure = self.normal.pressure().as_slice();
        let contains = |cell: usize| pressure[cell] > 0.0;
        let largest = RelativeDisplacement::largest_in(bodies, contains, displacement);
        Warning::shift_beyond(bodies.grid(), [largest, 0.0])
    }

    /// Returns the largest component of the bulk strain at the end of a step in thousandths, or `None` if it is small.
    pub(in crate::history) fn large_strain(
        &self,
        bodies: &HalfSpace,
        load: &LoadStep,
    ) -> Option<usize> {
        let relative = self.relative.as_ref()?;
        relative.pattern.large_strain(bodies, relative.end(load))
    }

    /// Returns whether the pattern has changed since the last step, so that the next step changes the displacement. A
    /// change of the pattern has no effect at the amount zero.
    pub(crate) fn is_relative_new(&self) -> bool {
        self.relative.as_ref().is_some_and(|relative| {
            let parts = relative.reached.fields().into_iter();
            parts
                .zip(relative.pattern.fields())
                .any(|(reached, pattern)| {
                    let mut cells = reached.as_slice().iter().zip(pattern.as_slice());
                    cells.any(|(reached, pattern)| reached - relative.amount * pattern != 0.0)
                })
        })
    }

    /// Returns whether a step prescribes a tangential load without an amount, and the amount of the displacement is zero.
    pub(in crate::history) fn has_unused_displacement(&self, load: &LoadStep) -> bool {
        let is_zero = |relative: &RelativeDisplacementState| relative.amount == 0.0;
        let is_sheared = load.prescribes_shear() && load.relative_amount().is_none();
        is_sheared && self.relative.as_ref().is_some_and(is_zero)
    }

    /// Sets the displacement at the end of a step.
    pub(in crate::history) fn reach(&mut self, load: &LoadStep) {
        let Some(relative) = &mut self.relative else {
            return;
        };
        relative.amount = relative.end(load);
        let reached = relative.reached.fields_mut();
        for (reached, pattern) in reached.into_iter().zip(relative.pattern.fields()) {
            let cells = reached.as_mut_slice().iter_mut();
            for (reached, pattern) in cells.zip(pattern.as_slice()) {
                *reached = relative.amount * pattern;
            }
        }
    }
}

impl History {
    /// Changes the pattern of the [relative displacement](crate::history::HistoryBuilder::relative_displacement). In
    /// the next step the displacement changes from its present value, which uses the old pattern. At the end of the
    /// step it is the amount times the new pattern. The first of several [adaptive](crate::history::AdaptiveSteps)
    /// steps includes the whole change of the pattern. The pattern is copied without allocation, unless the history had
    /// no pattern.
    ///
    /// The pattern has no effect at the amount zero, which is the initial amount. The next
    /// [amount](crate::LoadStep::relative_displacement) that a step prescribes refers to the new pattern.
    ///
    /// If the amount is not zero, the [stiffness](History::stiffness) and the sensitivities are an error until the next step.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid differs.
    /// - [`Error::UnsupportedByModel`] for a displacement along an axis without tractions.
    /// - [`Error::Sample`] for a bulk strain along a periodic axis.
    /// - [`Error::Memory`] if memory runs out.
    /// - [`Error::Ranks`] if ranks fail.
    ///
    /// The pattern is unchanged after an error.
    pub fn set_relative_displacement(&mut self, pattern: &RelativeDisplacement) -> Result<()> {
        let checked = pattern.check(&self.bodies, self.state.axes);
        self.bodies.collective_result(checked)?;
        match &mut self.state.relative {
            Some(relative) => relative.pattern.try_clone_from(pattern)?,
            none => *none = Some(RelativeDisplacementState::new(pattern.try_clone()?)?),
        }
        Ok(())
    }
}
