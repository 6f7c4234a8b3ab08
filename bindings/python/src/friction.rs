//! Friction laws.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::PyTuple;
#[cfg(feature = "stubs")]
use pyo3::{PyTypeInfo, inspect::PyStaticExpr, type_hint_union};

use crate::argument::{Object, argument};
use crate::digits::short;
use crate::error::OrRaise;
use crate::grid::Grid;
use crate::load::none_by_position;
use crate::pickle::picklable;
use crate::real::Real;
use crate::samples::{Samples, Spread};

/// Coulomb friction with a uniform coefficient or one coefficient per cell, and with an optional cap: the friction limit
/// of a cell is ``min(mu p, tau_max)``.
///
/// Parameters
/// ----------
/// coefficient : float, Field or array_like of shape (ny, nx)
///     Coefficient of friction mu (dimensionless), not negative.
/// max_shear_stress : float, optional
///     The shear strength tau_max of the weaker body (a pressure), positive; no limit by default.
/// grid : Grid, optional
///     Grid of the coefficients; required for an array, because only a Field has its own grid.
///
/// Raises
/// ------
/// NegativeOrNotFinite, Sample, Shape, GridMismatch, NotPositive
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, PartialEq)]
pub(crate) struct Friction(pub(crate) stickslip::Friction);

#[pymethods]
impl Friction {
    #[new]
    #[pyo3(signature = (coefficient, *positional, max_shear_stress=None, grid=None),
        text_signature = "(coefficient, *, max_shear_stress=None, grid=None)")]
    fn new(
        py: Python<'_>,
        coefficient: Samples<'_>,
        positional: &Bound<'_, PyTuple>,
        max_shear_stress: Option<Real>,
        grid: Option<Object<Grid>>,
    ) -> PyResult<Self> {
        let words = "Friction takes arguments after the coefficient";
        none_by_position(words, positional, "max_shear_stress= or grid=")?;
        let friction = coulomb(py, &coefficient, grid.as_deref())?;
        match max_shear_stress {
            None => Ok(Self(friction)),
            Some(Real(cap)) => friction.max_shear_stress(cap).or_raise(py).map(Self),
        }
    }

    /// The shear strength tau_max (a pressure), or ``None`` without a limit.
    #[getter]
    fn max_shear_stress(&self) -> Option<f64> {
        self.0.cap()
    }

    /// Returns the friction limit of a cell (row-major index) under a pressure, or NaN if the index is out of range.
    fn limit(&self, index: usize, pressure: Real) -> f64 {
        self.0.limit(index, pressure.0)
    }

    fn __repr__(&self) -> String {
        let first = self.0.limit(0, 1.0);
        let is_uniform = !self.0.limit(usize::MAX, 1.0).is_nan();
        let coefficient = if is_uniform {
            short(first)
        } else {
            "<per cell>".into()
        };
        match self.0.cap() {
            Some(cap) => format!("Friction({coefficient}, max_shear_stress={})", short(cap)),
            None => format!("Friction({coefficient})"),
        }
    }
}

/// Issues a warning if coefficients alone have replaced a law with a largest shear stress.
pub(crate) fn warn_of_lost_cap(py: Python<'_>, last: Option<f64>, is_law: bool) -> PyResult<()> {
    let Some(cap) = last.filter(|_| !is_law) else {
        return Ok(());
    };
    let message = format!(
        "the new friction has no max_shear_stress, but the last law had {0}: \
         give Friction(coefficient, max_shear_stress={0}) to keep it, or Friction(coefficient) to remove it",
        short(cap)
    );
    let module = py.import("stickslip._remarks")?;
    module.call_method1("warn", (vec![("lost_max_shear_stress", message)],))?;
    Ok(())
}

/// Returns the friction law of one coefficient, or of one coefficient per cell of a grid.
fn coulomb(
    py: Python<'_>,
    coefficient: &Samples<'_>,
    grid: Option<&Grid>,
) -> PyResult<stickslip::Friction> {
    match coefficient.spread(py, "coefficient of friction", grid)? {
        Spread::Uniform(coefficient) => stickslip::Friction::coulomb(coefficient).or_raise(py),
        Spread::PerCell(field) => {
            let grid = field.grid();
            stickslip::Friction::per_cell(Arc::unwrap_or_clone(field)).or_raise_on(py, grid)
        }
    }
}

picklable!(Friction: stickslip::Friction);

/// Argument that is converted to a friction law without a grid: a Friction or one coefficient.
pub(crate) struct GridlessFriction(pub(crate) stickslip::Friction);

impl FromPyObject<'_, '_> for GridlessFriction {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        Friction::TYPE_HINT,
        <f64 as FromPyObject<'_, '_>>::INPUT_TYPE
    );

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(friction) = object.cast::<Friction>() {
            return Ok(Self(friction.get().0.clone()));
        }
        let Real(coefficient) = object.extract()?;
        let friction = stickslip::Friction::coulomb(coefficient);
        friction.or_raise(object.py()).map(Self)
    }
}

argument! {
    /// Argument that is converted to a friction law: a Friction, one coefficient, or one coefficient per cell.
    AnyFriction: Friction; "float"
}

impl AnyFriction<'_> {
    /// Returns whether the argument is a law, not coefficients alone.
    pub(crate) fn is_law(&self) -> bool {
        self.0.is_instance_of::<Friction>()
    }

    pub(crate) fn on(self, py: Python<'_>, grid: stickslip::Grid) -> PyResult<stickslip::Friction> {
        if let Ok(friction) = self.0.cast::<Friction>() {
            return Ok(friction.get().0.clone());
        }
        coulomb(py, &self.0.extract()?, Some(&Grid(grid)))
    }
}
