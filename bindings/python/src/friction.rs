//! Friction and hardness.

use pyo3::prelude::*;
#[cfg(feature = "stubs")]
use pyo3::{PyTypeInfo, inspect::PyStaticExpr, type_hint_identifier, type_hint_union};

use crate::error::OrRaise;
use crate::field::{Samples, grid_of};
use crate::grid::Grid;
use crate::pickle::picklable;

/// Coulomb friction, uniform or one coefficient per cell, optionally capped: the friction limit of a cell is
/// ``min(mu p, tau_max)``.
///
/// Parameters
/// ----------
/// coefficient : float, or array_like of shape (ny, nx)
///     Not negative.
/// max_shear_stress : float, optional
///     The shear strength of the weaker body (a pressure).
/// grid : Grid, optional
///     Where an array lives; a Field knows it.
///
/// Raises
/// ------
/// Negative, Sample, NotPositive
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, PartialEq)]
pub(crate) struct Friction(pub(crate) stickslip::Friction);

#[pymethods]
impl Friction {
    #[new]
    #[pyo3(signature = (coefficient, *, max_shear_stress=None, grid=None))]
    fn new(
        py: Python<'_>,
        coefficient: Bound<'_, PyAny>,
        max_shear_stress: Option<f64>,
        grid: Option<&Grid>,
    ) -> PyResult<Self> {
        let friction = if let Ok(uniform) = coefficient.extract::<f64>() {
            stickslip::Friction::coulomb(uniform)
        } else {
            let samples: Samples<'_> = coefficient.extract()?;
            let grid = grid_of(grid, &samples, "coefficient of friction")?;
            let cells = samples.on(py, "coefficient of friction", grid)?;
            stickslip::Friction::per_cell((*cells).clone())
        };
        let friction = friction.or_raise(py)?;
        match max_shear_stress {
            None => Ok(Self(friction)),
            Some(cap) => friction.max_shear_stress(cap).or_raise(py).map(Self),
        }
    }

    /// The friction limit of a cell (row-major index) under a pressure; NaN beyond the coefficients.
    fn limit(&self, index: usize, pressure: f64) -> f64 {
        self.0.limit(index, pressure)
    }

    fn __repr__(&self) -> String {
        // The limit of no pressure at all is that of the cap alone.
        let (first, cap) = (self.0.limit(0, 1.0), self.0.limit(0, f64::INFINITY));
        let is_uniform = !self.0.limit(usize::MAX, 1.0).is_nan();
        let coefficient = if is_uniform {
            first.to_string()
        } else {
            "<per cell>".into()
        };
        if cap.is_finite() {
            format!("Friction({coefficient}, max_shear_stress={cap})")
        } else {
            format!("Friction({coefficient})")
        }
    }
}

picklable!(Friction: stickslip::Friction);

/// What is taken for friction: friction, or a coefficient or one per cell.
pub(crate) struct AnyFriction<'py>(Bound<'py, PyAny>);

impl<'py> FromPyObject<'_, 'py> for AnyFriction<'py> {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        Friction::TYPE_HINT,
        type_hint_identifier!("builtins", "float"),
        type_hint_identifier!("numpy.typing", "ArrayLike")
    );

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        Ok(Self(object.to_owned()))
    }
}

impl AnyFriction<'_> {
    pub(crate) fn on(self, py: Python<'_>, grid: stickslip::Grid) -> PyResult<stickslip::Friction> {
        match self.0.cast::<Friction>() {
            Ok(friction) => Ok(friction.get().0.clone()),
            Err(_) => Friction::new(py, self.0, None, Some(&Grid(grid))).map(|friction| friction.0),
        }
    }
}

/// The largest pressure that the softer body carries, of all cells or of each. Cells at it yield.
///
/// Parameters
/// ----------
/// limit : float, or array_like of shape (ny, nx)
///     Pressures: positive, or not negative per cell.
/// grid : Grid, optional
///     Where an array lives; a Field knows it.
///
/// Raises
/// ------
/// NotPositive, Sample
#[pyclass(frozen, eq, module = "stickslip.normal")]
#[derive(Clone, PartialEq)]
pub(crate) struct Hardness(pub(crate) stickslip::normal::Hardness);

#[pymethods]
impl Hardness {
    #[new]
    #[pyo3(signature = (limit, *, grid=None))]
    fn new(py: Python<'_>, limit: Bound<'_, PyAny>, grid: Option<&Grid>) -> PyResult<Self> {
        use stickslip::normal::Hardness as Limit;
        let hardness = if let Ok(uniform) = limit.extract::<f64>() {
            Limit::uniform(uniform)
        } else {
            let samples: Samples<'_> = limit.extract()?;
            let grid = grid_of(grid, &samples, "hardness")?;
            Limit::per_cell((*samples.on(py, "hardness", grid)?).clone())
        };
        hardness.or_raise(py).map(Self)
    }

    /// The largest pressure of a cell (row-major index); NaN beyond the limits.
    fn of_cell(&self, index: usize) -> f64 {
        self.0.of_cell(index)
    }

    /// The largest normal force that the cells of a grid carry.
    fn capacity(&self, grid: &Grid) -> f64 {
        self.0.capacity(grid.0)
    }

    /// By how much the surfaces of a solved contact overlap where its pressure is at the limit (lengths).
    fn overlap(
        &self,
        py: Python<'_>,
        contact: &crate::normal::NormalSolution,
    ) -> PyResult<crate::field::Field> {
        self.0.overlap(contact.get()).or_raise(py).map(Into::into)
    }

    fn __repr__(&self) -> String {
        if self.0.of_cell(usize::MAX).is_nan() {
            "Hardness(<per cell>)".into()
        } else {
            format!("Hardness({})", self.0.of_cell(0))
        }
    }
}

picklable!(Hardness: stickslip::normal::Hardness);

/// What is taken for a hardness: one, or a pressure or one per cell.
pub(crate) struct AnyHardness<'py>(Bound<'py, PyAny>);

impl<'py> FromPyObject<'_, 'py> for AnyHardness<'py> {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        Hardness::TYPE_HINT,
        type_hint_identifier!("builtins", "float"),
        type_hint_identifier!("numpy.typing", "ArrayLike")
    );

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        Ok(Self(object.to_owned()))
    }
}

impl AnyHardness<'_> {
    pub(crate) fn on(
        self,
        py: Python<'_>,
        grid: stickslip::Grid,
    ) -> PyResult<stickslip::normal::Hardness> {
        match self.0.cast::<Hardness>() {
            Ok(hardness) => Ok(hardness.get().0.clone()),
            Err(_) => Hardness::new(py, self.0, Some(&Grid(grid))).map(|hardness| hardness.0),
        }
    }
}
