//! Memory that an object keeps for its calls.

use std::sync::{Mutex, MutexGuard, PoisonError};

use stickslip_rs::{Field, Grid};

use crate::call::Outcome;
use crate::pointer::collected;

/// Arrays of earlier calls on an object. The crate requires a [`Field`] where C passes an array. Each array is copied into
/// a field in the memory of an earlier copy, so that repeated calls allocate nothing.
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

    /// Changes the samples of all cells; a failure leaves them unchanged.
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

    /// Returns a copy of the samples of all cells; pass it to [`keep`](Self::keep) after use.
    pub(crate) fn copy(&self, grid: Grid, samples: &[f64]) -> Outcome<Field> {
        // Simultaneous calls on the same object each use a separate array.
        let array = self.arrays().pop().unwrap_or_default();
        let array = collected(array, samples.iter().copied())?;
        Ok(Field::from_vec(grid, array)?)
    }

    /// Keeps the memory of a copy for later calls.
    pub(crate) fn keep(&self, copy: Field) {
        self.arrays().push(copy.into_vec());
    }

    fn arrays(&self) -> MutexGuard<'_, Vec<Vec<f64>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
