//! Statistics, spectrum and level of heights that ranks hold slab by slab.

use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::surface::{Form, Levelled, PowerSpectrum, Slab, Statistics, level_slab};

/// All ranks call these alike, each with its slab, and all get the same answer, with the bits of one process. Without
/// ranks they are [`Statistics::of`], [`PowerSpectrum::of`] and
/// [`surface::level`](crate::surface::level()).
impl HalfSpace {
    /// The statistics of a surface on the whole grid. See [`Statistics::of`].
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch); as [`Statistics::of`], where an index is one of the slab;
    /// [`Error::Ranks`](crate::Error::Ranks).
    pub fn statistics(&self, heights: &Field) -> Result<Statistics> {
        self.checked(heights)?;
        Statistics::of_slab(heights, &self.slab())
    }

    /// The power spectrum of a surface on the whole grid. See [`PowerSpectrum::of`].
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch); as [`PowerSpectrum::of`], where an index is one of the
    /// slab; [`Error::Ranks`](crate::Error::Ranks).
    pub fn power_spectrum(&self, heights: &Field) -> Result<PowerSpectrum> {
        self.checked(heights)?;
        PowerSpectrum::of_slab(heights, &self.slab())
    }

    /// Removes the mean or the plane of a surface on the whole grid; heights and form are those of the cells held here. See
    /// [`surface::level`](crate::surface::level()).
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch); as [`surface::level`](crate::surface::level()), where an
    /// index is one of the slab; [`Error::Ranks`](crate::Error::Ranks), also for a polynomial on bodies that ranks share.
    pub fn level(&self, heights: &Field, form: Form) -> Result<Levelled> {
        let checked = self.grid().expect("the field", heights.grid());
        self.collective_result_checked(checked, &[("form", &form)])?;
        level_slab(heights, &self.slab(), form)
    }

    /// `Ok` if the fields of all ranks are on their grids.
    fn slab(&self) -> Slab {
        let size = self.size();
        Slab::new(self.grid().whole(), self.share(size))
    }
}
