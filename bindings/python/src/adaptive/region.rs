//! Regions where contact may occur.

use pyo3::prelude::*;
use serde::{Deserialize, Serialize};
use stickslip::adaptive::Region as Checked;

use crate::argument::by_value;
use crate::boundary::Boundary;
use crate::conversion::{RegionX, RegionY};
use crate::digits::{short, tuple};
use crate::error::OrRaise;
use crate::pickle::picklable;
use crate::real::Real;
use crate::sequence::pair;

/// Arguments from which a region is created.
#[derive(Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) enum Ends {
    Rectangle([[f64; 2]; 2]),
    Periodic([[f64; 2]; 2]),
    Line([f64; 2], f64),
}

/// Region of the surface where contact may occur, in the coordinates of the gap. Its static methods create a region.
///
/// The grid of an :class:`AdaptiveProblem` covers only the part of the region where the bodies touch. Along a periodic
/// axis, it covers the whole region.
///
/// Examples
/// --------
/// >>> import stickslip as ss
/// >>> ss.adaptive.Region.rectangle((-1e-3, 1e-3), (-1e-3, 1e-3))
/// Region.rectangle((-0.001, 0.001), (-0.001, 0.001))
#[pyclass(frozen, eq, module = "stickslip.adaptive")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Region(Ends);

impl Region {
    /// Returns the region if the crate accepts it.
    fn checked(py: Python<'_>, ends: Ends) -> PyResult<Self> {
        let region = Self(ends);
        region.get().or_raise(py).map(|_| region)
    }

    pub(super) fn get(&self) -> stickslip::Result<Checked> {
        match self.0 {
            Ends::Rectangle([x, y]) => Checked::rectangle(x, y),
            Ends::Periodic([x, y]) => Checked::periodic(x, y),
            Ends::Line(x, datum) => Checked::line(x, datum),
        }
    }
}

by_value!(Region);

#[pymethods]
impl Region {
    /// Creates a rectangle with these ends. The bodies extend beyond it.
    ///
    /// Parameters
    /// ----------
    /// x, y : (float, float)
    ///     Start and end along x and along y (lengths).
    ///
    /// Raises
    /// ------
    /// NotFinite, NotPositive
    #[staticmethod]
    fn rectangle(py: Python<'_>, x: RegionX, y: RegionY) -> PyResult<Self> {
        Self::checked(py, Ends::Rectangle([x.0, y.0]))
    }

    /// Creates a rectangle of periodic surroundings. The gap must have these periods.
    ///
    /// Parameters
    /// ----------
    /// x, y : (float, float)
    ///     Start and end along x and along y (lengths).
    ///
    /// Raises
    /// ------
    /// NotFinite, NotPositive
    #[staticmethod]
    fn periodic(py: Python<'_>, x: RegionX, y: RegionY) -> PyResult<Self> {
        Self::checked(py, Ends::Periodic([x.0, y.0]))
    }

    /// Creates a part of a line contact in plane strain. All forces are per unit length.
    ///
    /// Parameters
    /// ----------
    /// x : (float, float)
    ///     Start and end along x (lengths).
    /// datum : float
    ///     The datum of :meth:`Boundary.periodic_along_y` (a length), at least the length of the line.
    ///
    /// Raises
    /// ------
    /// NotFinite, NotPositive, BelowMinimum
    #[staticmethod]
    fn line(py: Python<'_>, x: RegionX, datum: Real) -> PyResult<Self> {
        Self::checked(py, Ends::Line(x.0, datum.0))
    }

    /// Start and end along x (lengths).
    #[getter]
    fn x(&self) -> (f64, f64) {
        match self.0 {
            Ends::Rectangle([x, _]) | Ends::Periodic([x, _]) | Ends::Line(x, _) => pair(x),
        }
    }

    /// Start and end along y (lengths); ``None`` for a line.
    #[getter]
    fn y(&self) -> Option<(f64, f64)> {
        match self.0 {
            Ends::Rectangle([_, y]) | Ends::Periodic([_, y]) => Some(pair(y)),
            Ends::Line(..) => None,
        }
    }

    /// Boundary condition at the edge of the grids.
    #[getter]
    fn boundary(&self) -> Boundary {
        Boundary(match self.0 {
            Ends::Rectangle(_) => stickslip::Boundary::NonPeriodic,
            Ends::Periodic(_) => stickslip::Boundary::Periodic,
            Ends::Line(_, datum) => stickslip::Boundary::PeriodicAlongY { datum },
        })
    }

    fn __repr__(&self) -> String {
        match self.0 {
            Ends::Rectangle([x, y]) => format!("Region.rectangle({}, {})", tuple(&x), tuple(&y)),
            Ends::Periodic([x, y]) => format!("Region.periodic({}, {})", tuple(&x), tuple(&y)),
            Ends::Line(x, datum) => format!("Region.line({}, {})", tuple(&x), short(datum)),
        }
    }
}

picklable!(Region: Ends);
