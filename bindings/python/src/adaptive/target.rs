//! Required accuracy of the quantities of a contact.

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
#[cfg(feature = "stubs")]
use pyo3::{inspect::PyStaticExpr, type_hint_identifier, type_hint_subscript, type_hint_union};
use stickslip::adaptive::Quantity;

use crate::choice::Choice;
use crate::conversion::kind_of;
use crate::digits::as_python;
use crate::error::named;
use crate::real::{Real, named_by};

/// Argument with one number for the fields, or one number for each quantity.
pub(super) enum Target {
    OfFields(f64),
    OfQuantities(Vec<(Quantity, f64)>),
}

impl FromPyObject<'_, '_> for Target {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        <f64 as FromPyObject<'_, '_>>::INPUT_TYPE,
        type_hint_subscript!(
            type_hint_identifier!("builtins", "dict"),
            type_hint_identifier!("typing", "Any"),
            type_hint_identifier!("builtins", "float")
        )
    );

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(numbers) = object.cast::<PyDict>() {
            let of_quantity = |(name, target): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
                let quantity: Choice<Quantity> = name
                    .extract()
                    .map_err(|error| named_by(object.py(), error, "a key of target"))?;
                let Real(target) = target.extract()?;
                Ok((quantity.0, target))
            };
            let targets: PyResult<Vec<_>> = numbers.iter().map(of_quantity).collect();
            return match targets? {
                targets if targets.is_empty() => Err(PyValueError::new_err(
                    "target must contain at least one quantity",
                )),
                targets => Ok(Self::OfQuantities(targets)),
            };
        }
        if object.hasattr("keys")? || object.is_none() {
            return Err(PyTypeError::new_err(format!(
                "target must be a number or a dictionary of numbers, got {}",
                kind_of(&object)
            )));
        }
        let Real(target) = object.extract()?;
        Ok(Self::OfFields(target))
    }
}

impl Target {
    /// Returns the target of each quantity, or an error if a target is out of range. A number is the target of the
    /// pressure, and of the traction if there is friction.
    pub(super) fn of_quantities(
        self,
        py: Python<'_>,
        has_friction: bool,
    ) -> PyResult<Vec<(Quantity, f64)>> {
        let targets = match self {
            Self::OfFields(target) if has_friction => {
                vec![(Quantity::Pressure, target), (Quantity::Traction, target)]
            }
            Self::OfFields(target) => vec![(Quantity::Pressure, target)],
            Self::OfQuantities(targets) => targets,
        };
        for &(_, target) in &targets {
            // This form of the comparison rejects NaN.
            if !(target > 0.0 && target < 1.0) {
                let given = as_python(py, target)?;
                let message = format!("target must lie strictly between 0 and 1, got {given}");
                let numbers = PyDict::new(py);
                numbers.set_item("value", target)?;
                return Err(named(py, "Tolerance", &message, &numbers)?);
            }
        }
        Ok(targets)
    }
}

/// Numbers of quantities, which become a dictionary.
pub(super) struct OfQuantities(pub(super) Vec<(Quantity, f64)>);

impl<'py> IntoPyObject<'py> for OfQuantities {
    type Target = PyDict;
    type Output = Bound<'py, PyDict>;
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const OUTPUT_TYPE: PyStaticExpr = type_hint_subscript!(
        type_hint_identifier!("builtins", "dict"),
        type_hint_identifier!("builtins", "str"),
        type_hint_identifier!("builtins", "float")
    );

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let numbers = PyDict::new(py);
        for (quantity, number) in self.0 {
            numbers.set_item(Choice(quantity).name(), number)?;
        }
        Ok(numbers)
    }
}
