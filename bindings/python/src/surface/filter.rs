//! Gaussian filters of measured surfaces.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use stickslip::surface::{self, GaussianFilter};

use crate::digits::short;
use crate::field::Field;
use crate::real::Real;
use crate::samples::Samples;
use crate::surface::processed::processed;
use crate::unit::Unit;
use crate::work::unobserved_on;

/// A filtered surface and the removed components: the three add up to the given surface.
#[pyclass(frozen, eq, module = "stickslip.surface")]
#[derive(PartialEq)]
pub(crate) struct Filtered(surface::Filtered, Option<Unit>, [usize; 4]);

processed! { Filtered: surface::Filtered, [usize; 4];
    /// The remaining heights (lengths); missing heights remain missing.
}

#[pymethods]
impl Filtered {
    /// Short waves removed by the S filter (lengths), such as noise; ``None`` without an S filter.
    #[getter]
    fn short_waves(&self) -> Option<Field> {
        self.0.short_waves().map(|field| self.with_unit(field))
    }

    /// Long waves removed by the L filter (lengths), the waviness; ``None`` without an L filter.
    #[getter]
    fn long_waves(&self) -> Option<Field> {
        self.0.long_waves().map(|field| self.with_unit(field))
    }

    /// Columns and rows that are not affected by an edge: those at least half a nesting index away from each edge, in the
    /// form that :func:`crop` accepts.
    #[getter]
    fn valid_range(&self) -> ((usize, usize), (usize, usize)) {
        let [first, end, low, high] = self.2;
        ((first, end), (low, high))
    }

    fn __repr__(&self) -> String {
        let heights = self.0.heights();
        let (low, high) = (short(heights.min()), short(heights.max()));
        format!("Filtered(heights from {low} to {high})")
    }
}

/// Removes short waves, long waves or both from a surface with Gaussian filters (ISO 16610-61; along lines ISO 16610-21).
///
/// The mean of a filter transmits half of a wave whose length equals the nesting index, and the fraction
/// 2^(-(index/length)^2) of a wave of any other length. Missing heights (NaN) have no weight and remain missing;
/// therefore filter before :func:`fill_missing`. Near an edge or a hole, the mean is taken over the existing heights;
/// heights within half a nesting index of the edge or hole are affected. Level the surface before filtering.
///
/// Parameters
/// ----------
/// heights : Field or topography
///     The heights (lengths).
/// s, l : float, optional
///     Nesting indices, that is, cut-off wavelengths (lengths). The S filter removes shorter waves, such as noise; the L
///     filter removes longer waves, the waviness. With both, the result is the S-L surface.
/// periodic : bool, default False
///     Whether the surface continues periodically beyond its edges.
/// along : "xy", "x" or "y", default "xy"
///     Whether heights are averaged over the area ("xy") or along one axis only.
///
/// Raises
/// ------
/// NotPositive, BelowMinimum
///     If a nesting index is not positive, shorter than two cells or longer than the surface, or if the index of the S
///     filter exceeds the index of the L filter.
/// Sample, Undetermined, NotFinite, Memory
///
/// Examples
/// --------
/// >>> import numpy as np, stickslip as ss
/// >>> grid = ss.Grid.square(128, 128.0)
/// >>> wave = ss.Field(grid, np.tile(np.sin(2.0 * np.pi * grid.x / 8.0), (128, 1)), unit="um")
/// >>> filtered = ss.surface.gaussian_filter(wave, s=8.0, periodic=True)
/// >>> float(np.abs(filtered.heights / wave - 0.5).max().round(12)), filtered.heights.unit
/// (0.0, 'um')
#[pyfunction]
#[pyo3(signature = (heights, *, s=None, l=None, periodic=false, along="xy"))]
pub(crate) fn gaussian_filter(
    py: Python<'_>,
    heights: Samples<'_>,
    s: Option<Real>,
    l: Option<Real>,
    #[pyo3(from_py_with = crate::real::flag)] periodic: bool,
    along: &str,
) -> PyResult<Filtered> {
    let (unit, heights) = (heights.unit()?, heights.alone("heights")?);
    let filter = match (s, l) {
        (Some(Real(s)), Some(Real(l))) => GaussianFilter::sl(s, l),
        (Some(Real(s)), None) => GaussianFilter::s(s),
        (None, Some(Real(l))) => GaussianFilter::l(l),
        (None, None) => {
            return Err(PyTypeError::new_err(
                "give the nesting index of the S filter (s=), of the L filter (l=), or both",
            ));
        }
    };
    let filter = match along {
        "xy" => filter,
        "x" => filter.along_x(),
        "y" => filter.along_y(),
        _ => return Err(PyTypeError::new_err("along must be 'xy', 'x' or 'y'")),
    };
    let filter = if periodic { filter.periodic() } else { filter };
    let parts = unobserved_on(py, heights.grid(), || filter.apply(&heights))?;
    let [columns, rows] = filter.valid_range(heights.grid());
    let range = [columns.start, columns.end, rows.start, rows.end];
    Ok(Filtered(parts, unit, range))
}
