//! Removal of outliers from measured surfaces.

use pyo3::prelude::*;
use stickslip::surface::{self, OutlierFilter};

use crate::array::{Array, mask};
use crate::digits::counted;
use crate::field::Field;
use crate::real::{Count, Real};
use crate::samples::Samples;
use crate::surface::processed::processed;
use crate::unit::Unit;
use crate::work::unobserved_on;

/// A surface without its outliers.
#[pyclass(frozen, eq, module = "stickslip.surface")]
#[derive(PartialEq)]
pub(crate) struct WithoutOutliers(surface::WithoutOutliers, Option<Unit>);

processed! { WithoutOutliers: surface::WithoutOutliers;
    /// The heights (lengths), with NaN at the outliers; missing heights remain missing.
}

#[pymethods]
impl WithoutOutliers {
    /// Mask of the outliers, booleans of shape (ny, nx).
    #[getter]
    fn outliers<'py>(&self, py: Python<'py>) -> Array<'py, bool> {
        let grid = self.0.heights().grid();
        let mut is_outlier = vec![false; grid.cells()];
        for &cell in self.0.outliers() {
            is_outlier[cell] = true;
        }
        mask(py, grid, is_outlier.into_iter())
    }

    /// Number of outliers.
    #[getter]
    fn outlier_cells(&self) -> usize {
        self.0.outliers().len()
    }

    /// Returns the heights (lengths) with interpolated heights at the outliers, as by :func:`fill_missing`. Heights that were
    /// missing before remain missing.
    ///
    /// Raises
    /// ------
    /// Undetermined
    ///     If no measured height remains.
    /// NotConverged
    fn interpolated(&self, py: Python<'_>) -> PyResult<Field> {
        let grid = self.0.heights().grid();
        let heights = unobserved_on(py, grid, || self.0.interpolated())?;
        Ok(Field::made(heights, self.1.clone()))
    }

    fn __repr__(&self) -> String {
        let count = counted(self.0.outliers().len(), "outlier");
        format!("WithoutOutliers({count})")
    }
}

/// Removes outliers from a surface: points that are not typical of the heights around them, such as spikes of an optical
/// instrument.
///
/// The deviation of a point is its height minus the median of the means of pairs. A pair consists of two measured points on
/// opposite sides of the point, so a tilt causes no deviation. A point is an outlier if its absolute deviation exceeds
/// ``threshold`` times the larger of two scales, also relative to the pairs without larger outliers. The first scale is 1.4826
/// times the median of the absolute deviations of all points (Hampel, 1974). The second scale follows from the deviations
/// around the point, because all points along an edge, ridge or groove deviate, whereas an outlier deviates alone. ISO 25178-2
/// defines outliers and leaves the method open.
///
/// Parameters
/// ----------
/// heights : Field or topography
///     The heights (lengths); NaN marks missing heights.
/// threshold : float, default 6
///     Threshold in estimated standard deviations. The value 3 removes about 0.3 % of normally distributed independent
///     heights. The default removes no points of smooth surfaces such as spheres, waves, steps, ramps and cones.
/// radius : int, default 2
///     Largest distance of the points of a pair along each axis, in cells, at least 1. A group of more than ``2 * radius``
///     outliers counts as an edge. An outlier next to an edge must exceed the deviation at the edge several times.
///
/// Returns
/// -------
/// WithoutOutliers
///     ``heights`` contains NaN at the outliers; ``interpolated()`` contains interpolated heights there.
///
/// Raises
/// ------
/// NegativeOrNotFinite, BelowMinimum, Sample
///
/// Examples
/// --------
/// >>> import numpy as np, stickslip as ss
/// >>> grid = ss.Grid.square(32, 32.0)
/// >>> heights = np.tile(np.sin(0.3 * grid.x), (32, 1))
/// >>> heights[5, 7] += 40.0
/// >>> cleaned = ss.surface.remove_outliers(ss.Field(grid, heights))
/// >>> cleaned.outlier_cells, bool(np.isnan(cleaned.heights[5, 7])), bool(abs(cleaned.interpolated()[5, 7]) < 1.0)
/// (1, True, True)
#[pyfunction]
#[pyo3(signature = (heights, *, threshold=Real(6.0), radius=Count(2)))]
pub(crate) fn remove_outliers(
    py: Python<'_>,
    heights: Samples<'_>,
    threshold: Real,
    radius: Count,
) -> PyResult<WithoutOutliers> {
    let (unit, heights) = (heights.unit()?, heights.alone("heights")?);
    let filter = OutlierFilter::new(threshold.0).radius(radius.0);
    let found = unobserved_on(py, heights.grid(), || filter.apply(&heights))?;
    Ok(WithoutOutliers(found, unit))
}
