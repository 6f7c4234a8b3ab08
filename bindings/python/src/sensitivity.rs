//! Sensitivities: derivatives of functionals of a contact by the adjoint.

use std::sync::Arc;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
#[cfg(feature = "stubs")]
use pyo3::{inspect::PyStaticExpr, type_hint_identifier, type_hint_subscript};
use stickslip::Axis;
use stickslip::sensitivity::{Functional as Content, Sensitivity as Found, Weights};
use stickslip::stiffness::StiffnessWorkspace;

use crate::choice::Choice;
use crate::conversion::{self, kind_of};
use crate::digits::short;
use crate::error::OrRaise;
use crate::field::Field;
use crate::grid::Grid;
use crate::pickle::{Reduced, Stored, picklable, reduced};
use crate::readers::{by_name, readers, table};
use crate::real::Real;
use crate::report::Report;
use crate::samples::{Samples, grid_of};
use crate::sequence::pair;
use crate::solver::{Reused, Solver};
use crate::work::Observer;

/// Number that depends on the solution of a contact; created by its static methods.
///
/// A functional of tractions, slips or shifts needs the solver of a tangential or coupled contact. The approach needs the
/// solver of a normal or coupled contact.
///
/// Examples
/// --------
/// >>> from stickslip.sensitivity import Functional
/// >>> Functional.tangential_force("x")
/// Functional.tangential_force('x')
#[pyclass(frozen, eq, module = "stickslip.sensitivity", from_py_object)]
#[derive(Clone, PartialEq)]
pub(crate) struct Functional(Content);

picklable!(Functional: Content);

#[pymethods]
impl Functional {
    /// Returns the generalised mean of the pressure, weighted by the load: ``(sum(p**(k + 1)) / sum(p))**(1 / k)``.
    ///
    /// The mean tends to the largest pressure for a large exponent k. Cells that come into contact at pressure zero do not
    /// change it.
    ///
    /// Parameters
    /// ----------
    /// exponent : float
    ///     The exponent k, at least 1.
    #[staticmethod]
    fn pressure_norm(exponent: Real) -> Self {
        let Real(exponent) = exponent;
        Self(Content::PressureNorm { exponent })
    }

    /// Returns the root mean square of the pressure, weighted by the load: ``pressure_norm(2.0)``.
    #[staticmethod]
    fn rms_pressure() -> Self {
        Self(Content::RMS_PRESSURE)
    }

    /// Returns the elastic energy (force times length): of the pressure in a normal contact, of the tractions in a
    /// tangential contact, and of both in a coupled contact.
    #[staticmethod]
    fn elastic_energy() -> Self {
        Self(Content::ElasticEnergy)
    }

    /// Returns the normal force.
    #[staticmethod]
    fn normal_force() -> Self {
        Self(Content::NormalForce)
    }

    /// Returns the approach of the bodies.
    #[staticmethod]
    fn approach() -> Self {
        Self(Content::Approach)
    }

    /// Returns the tangential force along an axis.
    #[staticmethod]
    fn tangential_force(axis: Choice<Axis>) -> Self {
        Self(Content::TangentialForce(axis.0))
    }

    /// Returns the shift along an axis.
    #[staticmethod]
    fn shift(axis: Choice<Axis>) -> Self {
        Self(Content::Shift(axis.0))
    }

    /// Returns the part of the tangential force along an axis that the sticking cells carry.
    #[staticmethod]
    fn stick_force(axis: Choice<Axis>) -> Self {
        Self(Content::StickForce(axis.0))
    }

    /// Returns the energy dissipated by the step, computed from the tractions at its end (force times length).
    #[staticmethod]
    fn dissipated_energy() -> Self {
        Self(Content::DissipatedEnergy)
    }

    /// Returns a weighted sum of the unknowns of all cells, of the approach and of the shifts.
    ///
    /// The result to be differentiated need not be linear: with its derivatives at the solution as weights, the sensitivity
    /// is the derivative of any smooth result.
    ///
    /// Parameters
    /// ----------
    /// pressure : Field or array_like of shape (ny, nx), optional
    ///     Weights of the pressures; zero by default.
    /// traction, slip : pair of Field or array_like of shape (ny, nx), optional
    ///     Weights of the tractions and the slips along x and y; zero by default.
    /// approach : float, default 0
    ///     Weight of the approach.
    /// shift : pair of float, default (0, 0)
    ///     Weights of the shifts along x and y.
    /// grid : Grid, optional
    ///     Grid of the weights; required for arrays, because only Fields have their own grid.
    ///
    /// Raises
    /// ------
    /// Shape
    ///
    /// Examples
    /// --------
    /// >>> import numpy as np, stickslip
    /// >>> grid = stickslip.Grid.square(32, 8.0)
    /// >>> x, _ = np.meshgrid(grid.x, grid.y)
    /// >>> moment = stickslip.sensitivity.Functional.weighted(pressure=-x * grid.cell_area, grid=grid)
    #[staticmethod]
    #[pyo3(signature = (*, pressure=None, traction=None, slip=None, approach=Real(0.0),
        shift=conversion::ShiftWeights([0.0; 2]), grid=None),
        text_signature = "(*, pressure=None, traction=None, slip=None, approach=0.0, shift=(0.0, 0.0), grid=None)")]
    fn weighted(
        py: Python<'_>,
        pressure: Option<Samples<'_>>,
        traction: Option<Pair<'_>>,
        slip: Option<Pair<'_>>,
        approach: Real,
        shift: conversion::ShiftWeights,
        grid: Option<&Grid>,
    ) -> PyResult<Self> {
        let traction = traction
            .map(|given| given.samples("traction"))
            .transpose()?;
        let slip = slip.map(|given| given.samples("slip")).transpose()?;
        let mut weights = Weights::new().approach(approach.0).shift(shift.0);
        let pairs = traction.iter().chain(&slip).flatten();
        let all: Vec<_> = pressure.iter().chain(pairs).collect();
        if all.is_empty() {
            return Ok(Self(Content::Weighted(weights)));
        }
        let grid = grid_of(grid, &all)?;
        let field = |name, given: &Samples<'_>| given.on(py, name, grid).map(Arc::unwrap_or_clone);
        let fields = |name, [x, y]: &[Samples<'_>; 2]| -> PyResult<_> {
            Ok([field(name, x)?, field(name, y)?])
        };
        if let Some(given) = &pressure {
            weights = weights.pressure(field("pressure", given)?);
        }
        if let Some(given) = &traction {
            weights = weights.traction(fields("traction", given)?);
        }
        if let Some(given) = &slip {
            weights = weights.slip(fields("slip", given)?);
        }
        Ok(Self(Content::Weighted(weights)))
    }

    fn __repr__(&self) -> String {
        let along = |name: &str, axis: &Axis| format!("{name}('{}')", Choice(*axis).name());
        let call = match &self.0 {
            Content::PressureNorm { exponent } => format!("pressure_norm({})", short(*exponent)),
            Content::ElasticEnergy => "elastic_energy()".into(),
            Content::NormalForce => "normal_force()".into(),
            Content::Approach => "approach()".into(),
            Content::TangentialForce(axis) => along("tangential_force", axis),
            Content::Shift(axis) => along("shift", axis),
            Content::StickForce(axis) => along("stick_force", axis),
            Content::DissipatedEnergy => "dissipated_energy()".into(),
            _ => "weighted(...)".into(),
        };
        format!("Functional.{call}")
    }
}

/// Argument with one field for each axis.
pub(crate) struct Pair<'py>(Bound<'py, PyAny>);

impl<'py> FromPyObject<'_, 'py> for Pair<'py> {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_subscript!(
        type_hint_identifier!("collections.abc", "Sequence"),
        <Samples<'_> as FromPyObject<'_, '_>>::INPUT_TYPE
    );

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        Ok(Self(object.to_owned()))
    }
}

impl<'py> Pair<'py> {
    /// Returns both entries; a pair can be a sequence or an array of shape (2, ny, nx).
    fn samples(&self, name: &str) -> PyResult<[Samples<'py>; 2]> {
        let refused = || {
            PyTypeError::new_err(format!(
                "{name} must be a pair (x, y) of fields, got {}",
                kind_of(&self.0)
            ))
        };
        let entries = self.0.try_iter().map_err(|_| refused())?;
        let entries: Vec<Samples<'py>> = entries
            .map(|entry| entry?.extract())
            .collect::<PyResult<_>>()?;
        entries.try_into().map_err(|_| refused())
    }
}

/// Derivatives of a functional with respect to the input of a contact, at fixed sets of contact, stick and slip cells.
///
/// A derivative is ``None`` if the problem does not have this input. Derivatives with respect to fields are per value of a
/// cell, and zero outside the contact.
#[pyclass(frozen, eq, module = "stickslip.sensitivity", from_py_object)]
#[derive(Clone, PartialEq)]
pub(crate) struct Sensitivity {
    /// Sensitivity without its fields.
    numbers: Found,
    gap: Option<Arc<stickslip::Field>>,
    pressure: Option<Arc<stickslip::Field>>,
    friction: Option<Arc<stickslip::Field>>,
}

impl From<Found> for Sensitivity {
    fn from(mut found: Found) -> Self {
        let [gap, pressure, friction] = [
            found.gap.take(),
            found.pressure.take(),
            found.friction.take(),
        ]
        .map(|field| field.map(Arc::new));
        Self {
            numbers: found,
            gap,
            pressure,
            friction,
        }
    }
}

impl From<Sensitivity> for Found {
    fn from(own: Sensitivity) -> Self {
        let mut found = own.numbers;
        found.gap = own.gap.map(Arc::unwrap_or_clone);
        found.pressure = own.pressure.map(Arc::unwrap_or_clone);
        found.friction = own.friction.map(Arc::unwrap_or_clone);
        found
    }
}

impl Stored for Sensitivity {
    type Content = Found;

    const KIND: &'static str = "Sensitivity";

    fn of_content(content: Found) -> Self {
        content.into()
    }
}

readers! { Sensitivity (numbers, object => &object.numbers):
    /// Value of the functional.
    value: f64,
    /// Derivative with respect to the prescribed normal force or approach.
    normal_load: Option<f64>,
    /// Derivatives with respect to the prescribed loads along x and y: forces, shifts, or positions of the far ends of
    /// springs.
    tangential_load: (Option<f64>, Option<f64>) => <(Option<f64>, Option<f64>)>::from,
    /// Derivative with respect to the prescribed twist (per radian).
    twist: Option<f64>,
    /// Derivative with respect to a uniform coefficient of friction, the sum over all cells.
    friction_coefficient: Option<f64>,
    /// Derivative with respect to the contact modulus E*, if all moduli of both bodies change in proportion at constant
    /// Poisson's ratios. ``None`` for steps of histories.
    contact_modulus: Option<f64>,
}

#[pymethods]
impl Sensitivity {
    /// Derivative with respect to the gap of each cell.
    #[getter]
    fn gap(&self) -> Option<Field> {
        self.gap.clone().map(Field::from)
    }

    /// Derivative with respect to the pressure of each cell, for a tangential contact.
    #[getter]
    fn pressure(&self) -> Option<Field> {
        self.pressure.clone().map(Field::from)
    }

    /// Derivative with respect to the coefficient of friction of each cell. It is zero in cells that do not slip, and in
    /// cells at the largest shear stress of the friction.
    #[getter]
    fn friction(&self) -> Option<Field> {
        self.friction.clone().map(Field::from)
    }

    /// Derivatives with respect to Poisson's ratio of each body at constant Young's moduli. ``None`` for coatings and
    /// kernels. For tangential and coupled contacts also ``None`` on ranks and without ``poisson_ratio=True``.
    #[getter]
    fn poisson_ratio(&self) -> Option<(f64, f64)> {
        self.numbers.poisson_ratio.map(pair)
    }

    /// Termination and cost of the linear problem of this functional. The report excludes the responses to prescribed
    /// forces, which all functionals share. The time is not measured.
    #[getter]
    fn report(&self) -> Report {
        Report::of(&self.numbers.report)
    }

    /// Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``, and Poisson's
    /// ratios of the bodies have the endings ``_1`` and ``_2``. Fields are not included.
    fn to_dict<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyDict>> {
        const NUMBERS: [&str; 6] = [
            "value",
            "normal_load",
            "tangential_load",
            "twist",
            "friction_coefficient",
            "contact_modulus",
        ];
        let numbers = by_name(slf, "record", &NUMBERS)?;
        let (one, two) = slf.get().poisson_ratio().unzip();
        numbers.set_item("poisson_ratio_1", one)?;
        numbers.set_item("poisson_ratio_2", two)?;
        Ok(numbers)
    }

    /// Returns the numbers of :meth:`to_dict` as a series of pandas, which must be installed.
    fn to_series<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        table(slf.py(), "to_series", (Self::to_dict(slf)?, "Sensitivity"))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced::<Self>(py, &self.clone().into())
    }

    fn __repr__(&self) -> String {
        let fields = [
            ("gap", &self.gap),
            ("pressure", &self.pressure),
            ("friction", &self.friction),
        ];
        let numbers = &self.numbers;
        let scalars = [
            ("normal_load", numbers.normal_load),
            ("tangential_load_x", numbers.tangential_load[0]),
            ("tangential_load_y", numbers.tangential_load[1]),
            ("twist", numbers.twist),
            ("friction_coefficient", numbers.friction_coefficient),
            ("contact_modulus", numbers.contact_modulus),
        ];
        let fields = fields.into_iter().filter(|(_, field)| field.is_some());
        let fields: Vec<_> = fields.map(|(name, _)| name).collect();
        let scalars = scalars
            .into_iter()
            .filter_map(|(name, value)| value.map(|value| format!("{name}={}", short(value))));
        let mut parts = vec![format!("value={}", short(numbers.value))];
        parts.extend(scalars);
        parts.push(format!("fields: {}", fields.join(", ")));
        format!("Sensitivity({})", parts.join(", "))
    }
}

/// Returns a workspace with these options.
pub(crate) fn workspace(
    py: Python<'_>,
    tolerance: Option<Real>,
    poisson_ratio: bool,
) -> PyResult<StiffnessWorkspace> {
    let workspace = StiffnessWorkspace::new().poisson_ratio(poisson_ratio);
    match tolerance {
        None => Ok(workspace),
        Some(Real(tolerance)) => workspace.tolerance(tolerance).or_raise(py),
    }
}

/// Computes sensitivities with a solver, which a signal can end.
pub(crate) fn computed<S: Solver>(
    py: Python<'_>,
    solver: &Reused<S>,
    mut workspace: StiffnessWorkspace,
    work: impl FnOnce(&S, &mut StiffnessWorkspace, Observer<'_>) -> stickslip::Result<Vec<Found>> + Send,
) -> PyResult<Vec<Sensitivity>> {
    let found = solver.observed(py, |solver, observer| {
        work(solver, &mut workspace, observer)
    });
    found.map(objects)
}

/// Returns sensitivities as objects.
pub(crate) fn objects(found: Vec<Found>) -> Vec<Sensitivity> {
    found.into_iter().map(Sensitivity::from).collect()
}

/// Functionals in the form of the crate.
pub(crate) fn contents(functionals: Vec<Functional>) -> Vec<Content> {
    functionals
        .into_iter()
        .map(|functional| functional.0)
        .collect()
}

/// Declares the methods that compute sensitivities with a solver.
macro_rules! sensitive {
    ($class:ident: $solution:ident) => {
        #[pyo3::pymethods]
        impl $class {
            /// Computes the derivatives of a functional with respect to the input of the problem: gap, loads, friction and
            /// moduli.
            ///
            /// The derivatives of all cells together cost about one linear solve on the contact cells (the adjoint). The
            /// sets of contact, stick and slip cells are constant in the derivatives.
            ///
            /// Parameters
            /// ----------
            #[doc = concat!("solution : ", stringify!($solution))]
            ///     The solution of the present problem of this solver.
            /// functional : Functional
            ///     The functional; see :class:`stickslip.sensitivity.Functional`.
            /// tolerance : float, optional
            ///     Relative residual at which a linear problem counts as solved; 1e-11 by default.
            /// poisson_ratio : bool, default False
            ///     Whether to compute the derivatives with respect to Poisson's ratios of tangential and coupled contacts,
            ///     which require further operators. Normal contacts always have them.
            ///
            /// Returns
            /// -------
            /// Sensitivity
            ///
            /// Raises
            /// ------
            /// GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch
            ///     If the solution belongs to other bodies, or if weights have a different grid.
            /// UnsupportedByModel
            ///     If the functional depends on a quantity that the problem does not have.
            /// BelowMinimum, Sample, NotPositive, Tolerance
            ///     If a number of the functional or the tolerance is invalid.
            /// EmptyContact
            ///     If no cell carries pressure under a prescribed force.
            /// NotFinite
            ///     If a number of the functional is not finite, if a periodic contact is closed everywhere, or if the contact
            ///     cannot resist a change of the prescribed force, as in sliding.
            /// NotConverged
            ///     If the solution has not converged, or if a linear solve fails.
            #[pyo3(signature = (solution, functional, *, tolerance=None, poisson_ratio=false))]
            fn sensitivity(
                &self,
                py: pyo3::Python<'_>,
                solution: &$solution,
                functional: crate::sensitivity::Functional,
                tolerance: Option<crate::real::Real>,
                #[pyo3(from_py_with = crate::real::flag)] poisson_ratio: bool,
            ) -> pyo3::PyResult<crate::sensitivity::Sensitivity> {
                let functionals = vec![functional];
                let mut found =
                    self.sensitivities(py, solution, functionals, tolerance, poisson_ratio)?;
                // One functional has one sensitivity.
                Ok(found.remove(0))
            }

            /// Computes the sensitivities of several functionals, in their order. They share the responses to prescribed
            /// forces. The options and the exceptions are those of :meth:`sensitivity`.
            #[pyo3(signature = (solution, functionals, *, tolerance=None, poisson_ratio=false))]
            fn sensitivities(
                &self,
                py: pyo3::Python<'_>,
                solution: &$solution,
                functionals: Vec<crate::sensitivity::Functional>,
                tolerance: Option<crate::real::Real>,
                #[pyo3(from_py_with = crate::real::flag)] poisson_ratio: bool,
            ) -> pyo3::PyResult<Vec<crate::sensitivity::Sensitivity>> {
                let solution = solution.get();
                let functionals = crate::sensitivity::contents(functionals);
                let workspace = crate::sensitivity::workspace(py, tolerance, poisson_ratio)?;
                crate::sensitivity::computed(
                    py,
                    &self.0,
                    workspace,
                    |solver, workspace, observer| {
                        let observer = crate::work::watch(observer);
                        solver.sensitivities_with(solution, &functionals, workspace, observer)
                    },
                )
            }
        }
    };
}

pub(crate) use sensitive;
