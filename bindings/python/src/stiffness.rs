//! Derivatives of the forces with respect to the motions of the bodies.

use pyo3::prelude::*;

use crate::argument::Object;
use crate::conversion;
use crate::digits::{rough, short, tuple};
use crate::error::OrRaise;
use crate::friction::AnyFriction;
use crate::half_space::HalfSpace;
use crate::normal::NormalSolution;
use crate::pickle::picklable;
use crate::readers::readers;
use crate::tangential::TangentialSolution;
use crate::work::{observed_on, watch};

/// Derivative of the normal force with respect to the approach (a force over a length), with a bound on its
/// relative error. The set of contact cells is fixed. On a sphere the derivative is 2 E* a (Hertz).
#[pyclass(frozen, eq, module = "stickslip.stiffness")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct NormalStiffness(pub(crate) stickslip::stiffness::NormalStiffness);

readers! { NormalStiffness.0:
    /// Value of the derivative (a force over a length); zero without contact.
    value: f64,
    /// Bound on the relative error of the linear solve; infinite if pressure and traction are solved simultaneously. It
    /// excludes the effect of errors of the pressure.
    bound: f64,
}

#[pymethods]
impl NormalStiffness {
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

picklable!(NormalStiffness: stickslip::stiffness::NormalStiffness);

/// Derivatives of the tangential forces along x and y and of the moment (rows) with respect to the shifts along x
/// and y and the twist (columns), for continued loading and at its reversal. The sets of stick and slip cells are
/// fixed, and the pressure is constant unless it is solved simultaneously. The first two rows and columns are
/// forces over lengths; the last diagonal entry is a moment over radians, and the other entries are forces over
/// radians. An entry is NaN if the model does not have the load or the motion. Such entries are those of the
/// direction across the axis and of the twist in the scalar model, and of the twist on periodic grids.
#[pyclass(frozen, eq, module = "stickslip.stiffness")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct TangentialStiffness(pub(crate) stickslip::stiffness::TangentialStiffness);

#[pymethods]
impl TangentialStiffness {
    /// Derivative of the forces of the last step with respect to the motions at its end, if the motion continues in its
    /// direction. Stick cells follow the motion, and slip cells stay at their friction limit. In the vector model the
    /// traction of slip cells turns with the slip. On a ball under a constant normal load, the derivative is 8 G* a (1
    /// - F / (mu W))^(1/3) (Cattaneo and Mindlin).
    ///
    /// Cells that came into contact in the step follow the motion only partially. After a step that presses a ball from
    /// zero load, the derivative is about two thirds of Mindlin's stiffness 8 G* a, although all cells stick.
    /// ``history.stiffness(next_step=True)`` computes the derivative for the next step, in which these cells resist
    /// fully.
    #[getter]
    fn loading(&self) -> [[f64; 3]; 3] {
        numbers(&self.0.loading)
    }

    /// Derivative for a reversal of the motion, at which all contact cells stick. For a circular contact it is
    /// Mindlin's stiffness 8 G* a.
    #[getter]
    fn reversal(&self) -> [[f64; 3]; 3] {
        numbers(&self.0.reversal)
    }

    /// Bound on the errors, relative to the square root of the product of the diagonal entries of the row and the
    /// column, for the twist about the centre of the contact; infinite if pressure and traction are solved
    /// simultaneously. It excludes the effect of errors of pressure and traction.
    #[getter]
    fn bound(&self) -> f64 {
        self.0.bound
    }

    /// Returns the stiffness in series with springs along x and y (forces over lengths).
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

picklable!(TangentialStiffness: stickslip::stiffness::TangentialStiffness);

/// Derivatives of all forces of a contact with respect to its motions.
///
/// The sets of contact, stick and slip cells are fixed. The pressure is constant while the bodies are sheared,
/// unless pressure and traction are solved simultaneously. This class computes the stiffness of a contact that was
/// loaded from rest; :meth:`History.stiffness` computes the stiffness after load steps.
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
///     The tangential contact under the pressure of ``normal``.
///
/// Raises
/// ------
/// GridMismatch, BoundaryMismatch, MaterialMismatch, NotFinite, Yielded, NotConverged
/// CoupledMaterials
///     If the two solutions are parts of a coupled solution of dissimilar bodies.
#[pyclass(frozen, eq, module = "stickslip.stiffness")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct ContactStiffness(pub(crate) stickslip::stiffness::ContactStiffness);

readers! { ContactStiffness.0:
    /// Derivative of the normal force with respect to the approach.
    normal: NormalStiffness => NormalStiffness,
    /// Derivatives of the tangential forces and the moment with respect to the shifts and the twist.
    tangential: TangentialStiffness => TangentialStiffness,
}

#[pymethods]
impl ContactStiffness {
    #[new]
    fn new(
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        normal: Object<NormalSolution>,
        friction: AnyFriction<'_>,
        shear: Object<TangentialSolution>,
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

    /// Derivatives of the tangential forces (forces over lengths) and the moment (a force) with respect to the
    /// approach, while slip continues. The friction limit of slip cells follows the pressure, and the tangential force
    /// follows the limit. NaN for components that the model does not have.
    ///
    /// The derivatives are valid if the shift grows in the same step, or if the approach decreases. If the bodies are
    /// pressed further at a constant shift, the slip cells stick and the derivatives are zero. The derivatives have no
    /// error bound. After a solve with one-way coupling they exclude the tangential displacement due to the pressure;
    /// after steps of a history they include it.
    #[getter]
    fn by_approach(&self) -> (f64, f64, f64) {
        present(self.0.by_approach).into()
    }

    /// Derivatives of the normal force with respect to the shifts along x and y (forces over lengths) and the twist (a
    /// force). They are zero unless pressure and traction are solved simultaneously, and NaN for motions that the model
    /// does not have.
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

picklable!(ContactStiffness: stickslip::stiffness::ContactStiffness);

/// Replaces components that a model does not have with NaN.
fn present(slopes: [Option<f64>; 3]) -> [f64; 3] {
    slopes.map(|slope| slope.unwrap_or(f64::NAN))
}

fn numbers(matrix: &[[Option<f64>; 3]; 3]) -> [[f64; 3]; 3] {
    matrix.map(present)
}

/// Formats a matrix by rows.
fn rows(matrix: &[[f64; 3]; 3]) -> String {
    let [x, y, turn] = matrix.each_ref().map(|row| tuple(row));
    format!("({x}, {y}, {turn})")
}
