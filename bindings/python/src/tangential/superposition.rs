//! Traction as the difference of two pressures (Jaeger's superposition).

use pyo3::prelude::*;

use crate::argument::Object;
use crate::array::{Array, view, zones};
use crate::digits::short;
use crate::error::OrRaise;
use crate::grid::Grid;
use crate::material::Pair;
use crate::normal::NormalSolution;
use crate::readers::readers;
use crate::real::Real;

/// Jaeger's superposition: the traction of a contact under one force as the difference of two pressures.
///
/// Parameters
/// ----------
/// full, stick : NormalSolution
///     The contact under its load W, and the contact of the same bodies under the load W - F / mu for a tangential
///     force F. The contact area under the second load is the stick zone.
/// pair : ElasticPair or two Materials
///     The bodies. The coupling between pressure and traction of different materials is neglected.
/// friction : float
///     Coefficient of friction mu (dimensionless), not negative.
///
/// Raises
/// ------
/// NegativeOrNotFinite, GridMismatch, BoundaryMismatch, MaterialMismatch, NotConverged, EmptyContact,
/// OutdatedSolution
#[pyclass(frozen, module = "stickslip.tangential")]
pub(crate) struct JaegerSuperposition(stickslip::tangential::JaegerSuperposition);

readers! { JaegerSuperposition.0:
    /// The shift, the rigid motion of body 2 relative to body 1 (a length).
    shift(): f64,
    /// The tangential force, mu times the difference of the two loads.
    force(): f64,
}

#[pymethods]
impl JaegerSuperposition {
    /// Grid of the traction.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.0.traction().grid())
    }

    #[new]
    fn new(
        py: Python<'_>,
        full: Object<NormalSolution>,
        stick: Object<NormalSolution>,
        pair: Pair,
        friction: Real,
    ) -> PyResult<Self> {
        let (full, stick) = (full.get(), stick.get());
        let found =
            stickslip::tangential::JaegerSuperposition::new(full, stick, &pair.0, friction.0);
        found.or_raise(py).map(Self)
    }

    /// The traction along the load (pressures).
    #[getter]
    fn traction<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |found| found.0.traction())
    }

    /// Zone of each cell; see :attr:`TangentialSolution.zones`.
    #[getter]
    fn zones<'py>(&self, py: Python<'py>) -> PyResult<Array<'py, u8>> {
        zones(py, self.0.traction().grid(), self.0.zones())
    }

    fn __repr__(&self) -> String {
        format!(
            "JaegerSuperposition(force={}, shift={})",
            short(self.0.force()),
            short(self.0.shift())
        )
    }
}
