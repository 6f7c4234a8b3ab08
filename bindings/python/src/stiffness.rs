//! Slopes of the forces.

use pyo3::prelude::*;

use crate::conversion;
use crate::digits::{rough, short, tuple};
use crate::error::OrRaise;
use crate::friction::AnyFriction;
use crate::half_space::HalfSpace;
use crate::normal::NormalSolution;
use crate::tangential::TangentialSolution;
use crate::work::{observed_on, watch};

/// The slope of the normal force by the approach (a force over a length), with a bound of its relative error.
#[pyclass(frozen, eq, module = "stickslip.stiffness")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct NormalStiffness(pub(crate) stickslip::stiffness::NormalStiffness);

#[pymethods]
impl NormalStiffness {
    /// The slope (a force over a length), zero without contact.
    #[getter]
    fn value(&self) -> f64 {
        self.0.value
    }

    /// Bound of its relative error; infinite where pressure and traction are found together.
    #[getter]
    fn bound(&self) -> f64 {
        self.0.bound
    }

    fn __float__(&self) -> f64 {
        self.0.value
    }

    fn __repr__(&self) -> String {
        format!(
            "NormalStiffness(value={}, bound={})",
            short(self.0.value),
            rough(self.0.bound)
        )
    }
}

/// Slopes of the tangential forces along x and y and of the moment (rows) by the shifts along x and y and by the twist
/// (columns), under a load that goes on and at its reversal. Forces over lengths in the first two rows and columns, the
/// moment over radians in the last place. NaN for loads and motions that the model does not have: in the scalar model what
/// is across its axis and the twist, on grids that repeat the twist.
#[pyclass(frozen, eq, module = "stickslip.stiffness")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct TangentialStiffness(pub(crate) stickslip::stiffness::TangentialStiffness);

#[pymethods]
impl TangentialStiffness {
    /// Derivative of the forces of the last step with respect to the motions at its end, if the motion continues in its
    /// direction. Cells that came into contact in the step follow the motion only in part. After a step that presses a ball
    /// the derivative is about two thirds of Mindlin's stiffness, although all cells stick.
    /// ``history.stiffness(next_step=True)`` has the derivative of the next step, in which they resist fully.
    #[getter]
    fn loading(&self) -> [[f64; 3]; 3] {
        numbers(&self.0.loading)
    }

    /// Derivative if the motion reverses: all contact cells stick.
    #[getter]
    fn reversal(&self) -> [[f64; 3]; 3] {
        numbers(&self.0.reversal)
    }

    /// Bound of the errors, relative to the root of the product of the two entries on the diagonal; infinite where
    /// pressure and traction are found together.
    #[getter]
    fn bound(&self) -> f64 {
        self.0.bound
    }

    /// The stiffness behind springs along x and y (forces over lengths).
    fn in_series_with(&self, py: Python<'_>, springs: conversion::Stiffnesses) -> PyResult<Self> {
        self.0.in_series_with(springs.0).or_raise(py).map(Self)
    }

    fn __repr__(&self) -> String {
        format!(
            "TangentialStiffness(loading={}, reversal={}, bound={})",
            rows(&numbers(&self.0.loading)),
            rows(&numbers(&self.0.reversal)),
            rough(self.0.bound)
        )
    }
}

/// All slopes of a contact.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// normal : NormalSolution
///     The normal contact.
/// friction : Friction, float or array_like of shape (ny, nx)
///     The friction of the tangential contact.
/// shear : TangentialSolution
///     The tangential contact under that pressure.
///
/// Raises
/// ------
/// GridMismatch, BoundaryMismatch, MaterialMismatch, NotFinite, Yielded, NotConverged
/// CoupledMaterials
///     For the halves of a coupled solution of dissimilar bodies.
#[pyclass(frozen, eq, module = "stickslip.stiffness")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct ContactStiffness(pub(crate) stickslip::stiffness::ContactStiffness);

#[pymethods]
impl ContactStiffness {
    #[new]
    fn new(
        py: Python<'_>,
        bodies: &HalfSpace,
        normal: &NormalSolution,
        friction: AnyFriction<'_>,
        shear: &TangentialSolution,
    ) -> PyResult<Self> {
        let bodies = &bodies.0;
        let friction = friction.on(py, bodies.grid())?;
        let (normal, shear) = (normal.get(), shear.get());
        let found = observed_on(py, bodies.grid(), |observer| {
            let observer = watch(observer);
            stickslip::stiffness::ContactStiffness::observed(
                bodies, normal, &friction, shear, observer,
            )
        });
        found.map(Self)
    }

    /// By the approach, of the normal force.
    #[getter]
    fn normal(&self) -> NormalStiffness {
        NormalStiffness(self.0.normal)
    }

    /// By shifts and twist, of the tangential forces and the moment.
    #[getter]
    fn tangential(&self) -> TangentialStiffness {
        TangentialStiffness(self.0.tangential)
    }

    /// By the approach, of the tangential forces and the moment; NaN for those that the model does not have.
    #[getter]
    fn by_approach(&self) -> (f64, f64, f64) {
        present(self.0.by_approach).into()
    }

    /// By shifts along x and y and the twist, of the normal force: zero but where pressure and traction are found together.
    /// NaN for motions that the model does not have.
    #[getter]
    fn normal_by_motion(&self) -> (f64, f64, f64) {
        present(self.0.normal_by_motion).into()
    }

    fn __repr__(&self) -> String {
        format!(
            "ContactStiffness(normal={}, tangential={}, by_approach={})",
            short(self.0.normal.value),
            rows(&numbers(&self.0.tangential.loading)),
            tuple(&present(self.0.by_approach))
        )
    }
}

/// What a model does not have as NaN.
fn present(slopes: [Option<f64>; 3]) -> [f64; 3] {
    slopes.map(|slope| slope.unwrap_or(f64::NAN))
}

fn numbers(matrix: &[[Option<f64>; 3]; 3]) -> [[f64; 3]; 3] {
    matrix.map(present)
}

/// A matrix as its rows.
fn rows(matrix: &[[f64; 3]; 3]) -> String {
    let [x, y, turn] = matrix.each_ref().map(|row| tuple(row));
    format!("({x}, {y}, {turn})")
}
