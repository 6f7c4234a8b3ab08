//! What fields that ranks hold slab by slab come to on the whole grid.

use crate::error::Result;
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::surface::{Form, Levelled, PowerSpectrum, Slab, Statistics, level_slab};

/// All ranks call these alike, each with its slab, and all get the same answer, with the bits of one process. Without
/// ranks they are [`Field::max`] and the like, [`Statistics::of`], [`PowerSpectrum::of`] and
/// [`surface::level`](crate::surface::level()).
impl HalfSpace {
    /// Largest sample of a field of the whole grid, in its units; NaN samples are ignored. See [`Field::max`].
    ///
    /// ```
    /// use std::sync::Arc;
    /// use std::time::Duration;
    /// use stickslip::ranks::Threads;
    /// use stickslip::surface::SelfAffine;
    /// use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Material};
    /// // Heights to a gap that just closes, on slabs.
    /// let pair = ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?;
    /// let grid = Grid::new(64, 256, 0.5, 0.5)?;
    /// let statistics = Threads::run(3, Duration::from_secs(60), |rank| {
    ///     let bodies = HalfSpace::distributed(grid, pair, Boundary::Periodic, Arc::new(rank))?;
    ///     let heights = SelfAffine::with_rms_height(0.1).generate_on(&bodies)?;
    ///     let highest = bodies.max_of(&heights)?;
    ///     let gap = heights.map(|z| highest - z);
    ///     assert_eq!(bodies.min_of(&gap)?, 0.0);
    ///     bodies.statistics(&heights)
    /// });
    /// for statistics in statistics {
    ///     assert!((statistics?.rms_height() - 0.1).abs() < 1e-12);
    /// }
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::GridMismatch`](crate::Error::GridMismatch); [`Error::Ranks`](crate::Error::Ranks).
    pub fn max_of(&self, field: &Field) -> Result<f64> {
        self.checked(field)?;
        let largest = self.largest(field);
        self.joint(Ok(largest))
    }

    /// Smallest sample of a field of the whole grid, in its units; NaN samples are ignored. See [`Field::min`].
    ///
    /// # Errors
    /// As [`HalfSpace::max_of`].
    pub fn min_of(&self, field: &Field) -> Result<f64> {
        self.checked(field)?;
        let least = self.least(field);
        self.joint(Ok(least))
    }

    /// Integral of a field over the whole grid, in its units times a length squared. See [`Field::integral`].
    ///
    /// # Errors
    /// As [`HalfSpace::max_of`].
    pub fn integral_of(&self, field: &Field) -> Result<f64> {
        self.checked(field)?;
        let integral = self.integral(field);
        self.joint(Ok(integral))
    }

    /// Mean of a field over the whole grid, in its units: its [integral](Self::integral_of) over the area.
    ///
    /// # Errors
    /// As [`HalfSpace::max_of`].
    pub fn mean_of(&self, field: &Field) -> Result<f64> {
        let integral = self.integral_of(field)?;
        Ok(integral / self.grid().whole().area())
    }

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
        self.agreed_alike(checked, &[("form", &form)])?;
        level_slab(heights, &self.slab(), form)
    }

    /// `Ok` if the fields of all ranks are on their grids.
    fn checked(&self, field: &Field) -> Result<()> {
        self.agreed(self.grid().expect("the field", field.grid()))
    }

    fn slab(&self) -> Slab {
        let size = self.size();
        Slab::new(self.grid().whole(), self.share(size))
    }
}
