//! Memory that an object keeps for its calls.

use std::sync::{Mutex, MutexGuard, PoisonError};

use stickslip_rs::{Field, Grid};

use crate::call::Outcome;
use crate::pointer::collected;

/// Arrays of earlier calls on an object. What C passes as an array is a [`Field`] for the crate: its copy takes the memory of
/// the last one, so that repeated calls allocate nothing.
#[derive(Debug, Default)]
pub(crate) struct Spare(Mutex<Vec<Vec<f64>>>);

impl Spare {
    /// Runs work on a copy of the samples of all cells.
    pub(crate) fn with_copy<T>(
        &self,
        grid: Grid,
        samples: &[f64],
        work: impl FnOnce(&Field) -> Outcome<T>,
    ) -> Outcome<T> {
        let copy = self.copy(grid, samples)?;
        let outcome = work(&copy);
        self.keep(copy);
        outcome
    }

    /// Changes the samples of all cells, or leaves them as they were if that fails.
    pub(crate) fn change(
        &self,
        grid: Grid,
        samples: &mut [f64],
        work: impl FnOnce(&mut Field) -> Outcome,
    ) -> Outcome {
        let mut copy = self.copy(grid, samples)?;
        let outcome = work(&mut copy);
        if outcome.is_ok() {
            samples.copy_from_slice(copy.as_slice());
        }
        self.keep(copy);
        outcome
    }

    /// A copy of the samples of all cells, to be [kept](Self::keep) when it is done with.
    pub(crate) fn copy(&self, grid: Grid, samples: &[f64]) -> Outcome<Field> {
        // Calls on one object at the same time each have an array of their own.
        let array = self.arrays().pop().unwrap_or_default();
        let array = collected(array, samples.iter().copied())?;
        Ok(Field::from_vec(grid, array)?)
    }

    /// Takes the memory of a copy back.
    pub(crate) fn keep(&self, copy: Field) {
        self.arrays().push(copy.into_vec());
    }

    fn arrays(&self) -> MutexGuard<'_, Vec<Vec<f64>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
