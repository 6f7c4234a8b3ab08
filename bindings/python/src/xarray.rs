//! Objects with one height per cell as operands of arrays of xarray.

use pyo3::exceptions::{PyAttributeError, PyTypeError};
use pyo3::prelude::*;

use crate::conversion::kind_of;
use crate::field::Field;

/// Makes xarray reject objects of a class as second operands of its arrays. Its operators read the attribute ``variable`` of their
/// operands. Without this attribute they would combine the axes by position, whatever their names.
macro_rules! only_first_operand {
    ($class:ty) => {
        #[pyo3::pymethods]
        impl $class {
            fn __getattr__(
                slf: &pyo3::Bound<'_, Self>,
                name: &str,
            ) -> pyo3::PyResult<pyo3::Py<pyo3::PyAny>> {
                Err(crate::xarray::missing_attribute(slf, name))
            }
        }
    };
}

pub(crate) use only_first_operand;

/// Returns the exception for an attribute that a class does not have.
pub(crate) fn missing_attribute(object: &Bound<'_, PyAny>, name: &str) -> PyErr {
    let class = kind_of(object);
    if name == "variable" {
        let field = if object.is_instance_of::<Field>() {
            "the Field"
        } else {
            "its .heights"
        };
        return PyTypeError::new_err(format!(
            "a {class} cannot be the second operand of an array of xarray, which would combine their axes by position: \
             give {field} as the first operand, or convert the array by io.from_xarray(array)"
        ));
    }
    PyAttributeError::new_err(format!("'{class}' object has no attribute '{name}'"))
}
