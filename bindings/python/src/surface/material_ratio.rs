//! Areal material ratio curves.

use pyo3::prelude::*;
use stickslip::surface;

use crate::analytical::coordinates::{Coordinates, Values};
use crate::digits::short;
use crate::pickle::picklable;
use crate::readers::{iso_names, readers};
use crate::samples::Samples;
use crate::work::unobserved_on;

/// The areal material ratio curve (Abbott-Firestone curve) of a surface, and the parameters of its core, peaks and valleys
/// according to ISO 25178-2. Heights are relative to the mean, and ratios are fractions, not percentages.
///
/// The equivalent straight line is a least-squares line through the 40 % of the points in which the curve is flattest, that
/// is, where the secant over 40 % of the material ratio has the smallest height difference. The core is the part between the
/// heights of this line at the material ratios 0 and 1.
///
/// Parameters
/// ----------
/// heights : Field or topography
///     The heights (lengths). Missing heights (NaN) have no weight.
///
/// Raises
/// ------
/// Sample, Undetermined, NotFinite, Memory
///
/// Examples
/// --------
/// >>> import numpy as np, stickslip as ss
/// >>> grid = ss.Grid(1000, 1, 0.002, 1.0)
/// >>> ramp = ss.surface.MaterialRatio(ss.Field(grid, grid.x[None, :]))  # heights from -1 to 1, uniformly distributed
/// >>> round(ramp.Sk, 9), ramp.Spk, ramp.Svk, round(float(ramp.height(0.75)), 9)
/// (2.0, 0.0, 0.0, -0.5)
#[pyclass(frozen, eq, module = "stickslip.surface")]
#[derive(Clone, PartialEq)]
pub(crate) struct MaterialRatio(surface::MaterialRatio);

picklable!(MaterialRatio: surface::MaterialRatio);

readers! { MaterialRatio.0:
    /// Number of measured heights, on which the parameters are based.
    measured_points(): usize,
    /// Core height (a length): the height difference of the equivalent straight line.
    core_height(): f64,
    /// Reduced peak height (a length): the height of a right triangle with the area of the peaks above the core.
    reduced_peak_height(): f64,
    /// Reduced valley depth (a length): the height of a right triangle with the area of the valleys below the core.
    reduced_valley_depth(): f64,
    /// Material ratio that separates the peaks from the core (a fraction).
    peak_material_ratio(): f64,
    /// Material ratio that separates the core from the valleys (a fraction).
    valley_material_ratio(): f64,
}

iso_names! { MaterialRatio:
    Sk = core_height,
    Spk = reduced_peak_height,
    Svk = reduced_valley_depth,
    Smr1 = peak_material_ratio,
    Smr2 = valley_material_ratio;
    measured_points
}

#[pymethods]
impl MaterialRatio {
    #[new]
    fn new(py: Python<'_>, heights: Samples<'_>) -> PyResult<Self> {
        let heights = heights.alone("heights")?;
        unobserved_on(py, heights.grid(), || surface::MaterialRatio::of(&heights)).map(Self)
    }

    /// Returns the areal material ratio Smr(c): the fraction of the points that are at least as high as each of the given
    /// heights above the mean (lengths).
    fn material_ratio(&self, height: Coordinates) -> Values {
        height.along(|height| self.0.material_ratio(height))
    }

    /// Returns the inverse areal material ratio Smc(p): the heights above the mean (lengths) at material ratios from 0 to 1.
    ///
    /// Raises
    /// ------
    /// ArgumentRange
    ///     If a ratio is not from 0 to 1, as a ratio in per cent.
    fn height(&self, py: Python<'_>, material_ratio: Coordinates) -> PyResult<Values> {
        let name = "material_ratio";
        let ratio = material_ratio.check(py, name, "a ratio from 0 to 1", |ratio| {
            (0.0..=1.0).contains(&ratio)
        })?;
        Ok(ratio.along(|ratio| self.0.height(ratio)))
    }

    fn __repr__(&self) -> String {
        format!(
            "MaterialRatio(Sk={}, Spk={}, Svk={}, Smr1={}, Smr2={})",
            short(self.0.core_height()),
            short(self.0.reduced_peak_height()),
            short(self.0.reduced_valley_depth()),
            short(self.0.peak_material_ratio()),
            short(self.0.valley_material_ratio())
        )
    }
}
