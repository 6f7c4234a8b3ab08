//! Statistics, spectrum and levelling of distributed heights.

use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::surface::{Form, Levelled, PowerSpectrum, Slab, Statistics, level_slab};

/// Statistics, spectrum and levelling of a surface on the grid of the bodies. The calls are collective. Each rank passes its
/// slab, and all ranks receive the same result. This result is bitwise identical to the result of a single process. Without ranks
/// the methods are equivalent to [`Statistics::of`], [`PowerSpectrum::of`] and [`surface::level`](crate::surface::level()).
impl HalfSpace {
    /// Computes the statistics of a surface on the whole grid. See [`Statistics::of`].
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the field is on a different grid.
    /// - The errors of [`Statistics::of`], with indices of cells in the slab.
    /// - [`Error::Ranks`](crate::Error::Ranks) if a rank fails.
    pub fn statistics(&self, heights: &Field) -> Result<Statistics> {
        self.checked(heights)?;
        Statistics::of_slab(heights, &self.slab())
    }

    /// Computes the power spectrum of a surface on the whole grid. See [`PowerSpectrum::of`].
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the field is on a different grid.
    /// - The errors of [`PowerSpectrum::of`], with indices of cells in the slab.
    /// - [`Error::Ranks`](crate::Error::Ranks) if a rank fails.
    pub fn power_spectrum(&self, heights: &Field) -> Result<PowerSpectrum> {
        self.checked(heights)?;
        PowerSpectrum::of_slab(heights, &self.slab())
    }

    /// Removes the mean or the plane of a surface on the whole grid. The returned heights and form contain the local cells. See
    /// [`surface::level`](crate::surface::level()).
    ///
    /// # Errors
    /// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the field is on a different grid.
    /// - The errors of [`surface::level`](crate::surface::level()), with indices of cells in the slab.
    /// - [`Error::Ranks`](crate::Error::Ranks) if a rank fails, or if the form is a polynomial and the bodies are distributed.
    pub fn level(&self, heights: &Field, form: Form) -> Result<Levelled> {
        let checked = self.grid().check_equal("the field", heights.grid());
        self.collective_result_checked(checked, &[("form", &form)])?;
        level_slab(heights, &self.slab(), form)
    }

    /// Returns the local slab of the grid.
    fn slab(&self) -> Slab {
        let size = self.size();
        Slab::new(self.grid().whole(), self.share(size))
    }
}
