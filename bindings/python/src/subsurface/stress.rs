//! Stress tensor at a point.

use pyo3::prelude::*;

use crate::argument::by_value;
use crate::digits::{short, tuple};
use crate::pickle::picklable;
use crate::readers::readers;
use crate::real::Real;

/// Principal stresses, the largest first, with their unit vectors.
#[pyclass(frozen, eq, module = "stickslip.subsurface")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Principal(stickslip::subsurface::Principal);

by_value!(Stress);

#[pymethods]
impl Principal {
    /// The principal stresses (pressures, tensile positive).
    #[getter]
    fn values(&self) -> (f64, f64, f64) {
        self.0.values.into()
    }

    /// Unit vectors of the principal stresses, in the same order.
    #[getter]
    fn directions(&self) -> [[f64; 3]; 3] {
        self.0.directions
    }

    fn __repr__(&self) -> String {
        format!("Principal(values={})", tuple(&self.0.values))
    }
}

picklable!(Principal: stickslip::subsurface::Principal);

/// The symmetric stress tensor at a point (pressures), tensile positive, with z into body 1. Stresses can be added,
/// subtracted and multiplied by numbers.
///
/// Parameters
/// ----------
/// xx, yy, zz, xy, xz, yz : float, default 0
///     Components (pressures).
///
/// Examples
/// --------
/// >>> from stickslip.subsurface import Stress
/// >>> Stress(xy=2.0).principal.values
/// (2.0, 0.0, -2.0)
/// >>> Stress(xx=1.0) + 2.0 * Stress(xx=3.0)
/// Stress(xx=7, yy=0, zz=0, xy=0, xz=0, yz=0)
#[pyclass(frozen, eq, module = "stickslip.subsurface")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Stress(pub(crate) stickslip::subsurface::Stress);

readers! { Stress.0:
    /// Component xx.
    xx: f64,
    /// Component yy.
    yy: f64,
    /// Component zz.
    zz: f64,
    /// Component xy.
    xy: f64,
    /// Component xz.
    xz: f64,
    /// Component yz.
    yz: f64,
    /// Von Mises' equivalent stress (a pressure).
    von_mises(): f64,
    /// Mean of the normal stresses (a pressure, tensile positive).
    hydrostatic(): f64,
    /// Largest shear stress (a pressure).
    max_shear(): f64,
    /// Principal stresses with their directions.
    principal(): Principal => Principal,
}

#[pymethods]
impl Stress {
    #[new]
    #[pyo3(signature = (*, xx=Real(0.0), yy=Real(0.0), zz=Real(0.0), xy=Real(0.0), xz=Real(0.0), yz=Real(0.0)),
        text_signature = "(*, xx=0.0, yy=0.0, zz=0.0, xy=0.0, xz=0.0, yz=0.0)")]
    fn new(xx: Real, yy: Real, zz: Real, xy: Real, xz: Real, yz: Real) -> Self {
        Self(stickslip::subsurface::Stress {
            xx: xx.0,
            yy: yy.0,
            zz: zz.0,
            xy: xy.0,
            xz: xz.0,
            yz: yz.0,
        })
    }

    /// Adds a stress.
    fn __add__(&self, other: &Self) -> Self {
        Self(self.0 + other.0)
    }

    fn __radd__(&self, other: &Self) -> Self {
        other.__add__(self)
    }

    /// Subtracts a stress.
    fn __sub__(&self, other: &Self) -> Self {
        Self(self.0 - other.0)
    }

    fn __rsub__(&self, other: &Self) -> Self {
        other.__sub__(self)
    }

    /// Multiplies the stress by a number.
    fn __mul__(&self, factor: Real) -> Self {
        Self(self.0 * factor.0)
    }

    fn __rmul__(&self, factor: Real) -> Self {
        self.__mul__(factor)
    }

    fn __repr__(&self) -> String {
        let stress = self.0;
        format!(
            "Stress(xx={}, yy={}, zz={}, xy={}, xz={}, yz={})",
            short(stress.xx),
            short(stress.yy),
            short(stress.zz),
            short(stress.xy),
            short(stress.xz),
            short(stress.yz)
        )
    }
}

picklable!(Stress: stickslip::subsurface::Stress);
