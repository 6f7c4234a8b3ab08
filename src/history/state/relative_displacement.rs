//! What displaces one body relative to the other beside the contact, step by step.

use crate::error::{Error, Result, finite};
use crate::grid::field::clone_in_place;
use crate::history::state::State;
use crate::history::{History, LoadStep};
use crate::memory::fallible::{TryClone, try_clone};
use crate::tangential::RelativeDisplacement;

/// A pattern of relative displacement, how much of it is reached, and what that is in each cell.
#[derive(Debug)]
pub(in crate::history) struct RelativeDisplacementState {
    pub(in crate::history) pattern: RelativeDisplacement,
    pub(in crate::history) amount: f64,
    /// The displacement that is in the offsets: of another pattern, if it has been changed since.
    pub(in crate::history) reached: RelativeDisplacement,
}

clone_in_place!(RelativeDisplacementState {
    pattern,
    amount,
    reached,
});

try_clone!(RelativeDisplacementState { pattern, reached } { amount });

impl RelativeDisplacementState {
    /// None of it reached.
    pub(in crate::history) fn new(pattern: RelativeDisplacement) -> Result<Self> {
        let [along_x, _] = pattern.fields();
        Ok(Self {
            reached: RelativeDisplacement::zeros(along_x.grid())?,
            amount: 0.0,
            pattern,
        })
    }

    /// How much a step reaches.
    fn end(&self, load: &LoadStep) -> f64 {
        load.relative_amount().unwrap_or(self.amount)
    }
}

impl State {
    /// `Ok` if an amount is asked of a history that has a pattern for it.
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
                    remedy: "build it with a pattern of relative displacement",
                });
            }
            None => {}
        }
        Ok(())
    }

    /// How far a step displaces a cell along an axis.
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

    /// A step has displaced the cells.
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
    /// Changes the pattern of the [relative displacement](crate::history::HistoryBuilder::relative_displacement): the next
    /// step leads from what was reached of the old one to its amount of the new one, also if it is the first of
    /// [adaptive](crate::history::AdaptiveSteps) ones, and the first of them then takes up all of the change. Copies without allocating, unless the
    /// history had none.
    ///
    /// # Errors
    /// [`Error::GridMismatch`]; [`Error::UnsupportedByModel`] for one along an axis of which the model finds no traction; [`Error::Sample`] for a
    /// bulk strain along an axis on which the grid repeats; [`Error::Memory`]; [`Error::Ranks`]; the
    /// pattern is then as it was.
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
