//! Boundary conditions at the edge of the grid.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
#[cfg(feature = "stubs")]
use pyo3::{PyTypeInfo, inspect::PyStaticExpr, type_hint_identifier, type_hint_union};

use crate::conversion::entries;
use crate::digits::short;
use crate::pickle::picklable;
use crate::real::Real;

/// Boundary condition at the edge of the grid.
///
/// Every argument of this type also accepts ``"non_periodic"``, ``"periodic"`` and ``("periodic_along_y", datum)``. On a
/// grid that is periodic along x and y, the approach is measured from the mean gap and the shift from the mean plane of
/// the surface.
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Boundary(pub(crate) stickslip::Boundary);

#[pymethods]
impl Boundary {
    /// Unloaded half-space outside the grid.
    #[classattr]
    const NON_PERIODIC: Self = Self(stickslip::Boundary::NonPeriodic);

    /// Grid that is periodic along x and y.
    #[classattr]
    const PERIODIC: Self = Self(stickslip::Boundary::Periodic);

    /// Returns the boundary of a grid that is periodic along y only, for cylinders, rollers and line contacts. The datum
    /// (a length, at least the length of the grid) is the distance along x from a line load at which that load causes no
    /// displacement. Approach and shift are relative to this datum.
    #[staticmethod]
    fn periodic_along_y(datum: Real) -> Self {
        Self(stickslip::Boundary::PeriodicAlongY { datum: datum.0 })
    }

    /// Name of the boundary condition.
    #[getter]
    fn name(&self) -> &'static str {
        match self.0 {
            stickslip::Boundary::NonPeriodic => "non_periodic",
            stickslip::Boundary::Periodic => "periodic",
            stickslip::Boundary::PeriodicAlongY { .. } => "periodic_along_y",
            _ => "unknown",
        }
    }

    /// The datum (a length) of a grid that is periodic along y only; ``None`` for other grids.
    #[getter]
    fn datum(&self) -> Option<f64> {
        match self.0 {
            stickslip::Boundary::PeriodicAlongY { datum } => Some(datum),
            _ => None,
        }
    }

    pub(crate) fn __repr__(&self) -> String {
        match self.0 {
            stickslip::Boundary::NonPeriodic => "Boundary.NON_PERIODIC".into(),
            stickslip::Boundary::Periodic => "Boundary.PERIODIC".into(),
            stickslip::Boundary::PeriodicAlongY { datum } => {
                format!("Boundary.periodic_along_y({})", short(datum))
            }
            other => format!("{other:?}"),
        }
    }
}

picklable!(Boundary: stickslip::Boundary);

/// Argument that is converted to a boundary.
pub(crate) struct Surroundings(pub(crate) stickslip::Boundary);

impl FromPyObject<'_, '_> for Surroundings {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        Boundary::TYPE_HINT,
        type_hint_identifier!("builtins", "str"),
        <(String, Real) as FromPyObject>::INPUT_TYPE
    );

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(boundary) = object.cast::<Boundary>() {
            return Ok(Self(boundary.get().0));
        }
        let named = entries(&object).and_then(|named| named.extract::<(String, Real)>().ok());
        if let Some((_, Real(datum))) = named.filter(|(name, _)| name == "periodic_along_y") {
            return Ok(Self(stickslip::Boundary::PeriodicAlongY { datum }));
        }
        match object.extract::<String>().as_deref() {
            Ok("non_periodic") => Ok(Self(stickslip::Boundary::NonPeriodic)),
            Ok("periodic") => Ok(Self(stickslip::Boundary::Periodic)),
            _ => Err(PyValueError::new_err(format!(
                "boundary must be 'non_periodic', 'periodic', ('periodic_along_y', datum) or a Boundary, got {}",
                object.repr()?
            ))),
        }
    }
}
