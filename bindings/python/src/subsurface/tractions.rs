//! Arguments that are converted to the tractions of a contact.

use std::sync::Arc;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
#[cfg(feature = "stubs")]
use pyo3::{inspect::PyStaticExpr, type_hint_identifier};
use stickslip::Field;
use stickslip::subsurface::Tractions;

use crate::conversion::{entries, kind_of};
use crate::coupled::CoupledSolution;
use crate::history::{History, State};
use crate::normal::NormalSolution;
use crate::real::is_plane;
use crate::samples::Samples;
use crate::subsurface::Stress;
use crate::tangential::TangentialSolution;

/// Source of tractions: a solution of any kind, a pair of a normal and a tangential solution, a state, a history, or
/// fields (a pressure, or a pressure and two tractions).
pub(crate) struct Loaded<'py>(Vec<Bound<'py, PyAny>>);

impl<'py> FromPyObject<'_, 'py> for Loaded<'py> {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_identifier!("typing", "Any");

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        // A list can also contain the rows of a pressure.
        let parts = entries(&object).filter(|parts| {
            let first = parts.get_item(0);
            let is_whole = |first| is_plane(&first) || first.is_instance_of::<NormalSolution>();
            object.is_instance_of::<PyTuple>() || first.is_ok_and(is_whole)
        });
        Ok(Self(match parts {
            Some(parts) => parts.iter().collect(),
            None => vec![object.to_owned()],
        }))
    }
}

/// Tractions with their owner.
pub(crate) enum TractionSource<'a> {
    Normal(&'a stickslip::NormalSolution),
    ShearTractions(
        &'a stickslip::NormalSolution,
        &'a stickslip::TangentialSolution,
    ),
    Coupled(&'a stickslip::CoupledSolution),
    State(Arc<stickslip::history::State>),
    Fields(Arc<Field>, Option<[Arc<Field>; 2]>),
}

impl TractionSource<'_> {
    /// Returns the tractions, with a uniform stress of the examined body if given.
    pub(crate) fn tractions(&self, uniform: Option<Stress>) -> Tractions<'_> {
        let tractions = match self {
            Self::Normal(normal) => Tractions::from(*normal),
            Self::ShearTractions(normal, shear) => Tractions::from((*normal, *shear)),
            Self::Coupled(solution) => Tractions::from(*solution),
            Self::State(state) => Tractions::from(&**state),
            Self::Fields(pressure, None) => Tractions::new(pressure),
            Self::Fields(pressure, Some([x, y])) => Tractions::new(pressure).with_traction([x, y]),
        };
        match uniform {
            None => tractions,
            Some(stress) => tractions.with_uniform_stress(stress.0),
        }
    }
}

impl Loaded<'_> {
    /// Returns the tractions on the grid of the bodies.
    pub(crate) fn held(
        &self,
        py: Python<'_>,
        grid: stickslip::Grid,
    ) -> PyResult<TractionSource<'_>> {
        let field = |object: &Bound<'_, PyAny>, quantity| {
            let samples: Samples<'_> = object.extract()?;
            samples.on(py, quantity, grid)
        };
        match &self.0[..] {
            [normal, shear] if normal.is_instance_of::<NormalSolution>() => {
                let shear = shear.cast::<TangentialSolution>().map_err(|_| {
                    PyTypeError::new_err(format!(
                        "expected (normal, shear), a NormalSolution and a TangentialSolution, got {} as shear",
                        kind_of(shear)
                    ))
                })?;
                let normal = normal.cast::<NormalSolution>()?.get().get();
                Ok(TractionSource::ShearTractions(normal, shear.get().get()))
            }
            [one] => {
                if let Ok(normal) = one.cast::<NormalSolution>() {
                    Ok(TractionSource::Normal(normal.get().get()))
                } else if let Ok(solution) = one.cast::<CoupledSolution>() {
                    Ok(TractionSource::Coupled(&solution.get().0))
                } else if let Ok(state) = one.cast::<State>() {
                    Ok(TractionSource::State(Arc::clone(&state.get().0)))
                } else if let Ok(history) = one.cast::<History>() {
                    let state = history.get().read(|history| history.state().clone())?;
                    Ok(TractionSource::State(Arc::new(state)))
                } else if one.is_instance_of::<TangentialSolution>() {
                    Err(PyTypeError::new_err(
                        "a TangentialSolution has no pressure: give the normal solution too, as (normal, shear)",
                    ))
                } else {
                    Ok(TractionSource::Fields(field(one, "pressure")?, None))
                }
            }
            [pressure, shear] => {
                let [x, y]: [Bound<'_, PyAny>; 2] = shear.extract().map_err(|_| {
                    PyTypeError::new_err(format!(
                        "expected (normal, shear) of two solutions or (pressure, (x, y)) of fields, got ({}, {})",
                        kind_of(pressure),
                        kind_of(shear)
                    ))
                })?;
                let shear = [field(&x, "traction")?, field(&y, "traction")?];
                Ok(TractionSource::Fields(
                    field(pressure, "pressure")?,
                    Some(shear),
                ))
            }
            _ => Err(PyTypeError::new_err(
                "tractions must be a solution, a pair (normal, shear) of solutions, a state, a history, a pressure, or (pressure, (x, y))",
            )),
        }
    }
}
