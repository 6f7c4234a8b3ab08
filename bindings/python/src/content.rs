//! Bytes as an argument.

use std::ops::Deref;

#[cfg(feature = "stubs")]
use pyo3::inspect::PyStaticExpr;
use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyBytes, PyMemoryView, PyString};
#[cfg(feature = "stubs")]
use pyo3::{type_hint_identifier, type_hint_union};

use crate::conversion::kind_of;
use crate::real::unnamed;

/// Bytes of a file or an object. A ``bytearray`` and a ``memoryview`` are copied, because they may change.
pub(crate) struct Content<'py>(Bound<'py, PyBytes>);

impl Deref for Content<'_> {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        self.0.as_bytes()
    }
}

impl<'py> FromPyObject<'_, 'py> for Content<'py> {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        type_hint_identifier!("builtins", "bytes"),
        type_hint_identifier!("builtins", "bytearray"),
        type_hint_identifier!("builtins", "memoryview")
    );

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let py = object.py();
        if let Ok(bytes) = object.cast::<PyBytes>() {
            return Ok(Self(bytes.to_owned()));
        }
        if object.is_instance_of::<PyByteArray>() || object.is_instance_of::<PyMemoryView>() {
            let copy = py.get_type::<PyBytes>().call1((object,))?;
            return Ok(Self(copy.cast_into::<PyBytes>()?));
        }
        let remedy = if object.is_instance_of::<PyString>() {
            ": convert text by text.encode()"
        } else {
            ""
        };
        let message = format!("must be bytes, got {}{remedy}", kind_of(&object));
        Err(unnamed(py, "ArgumentType", &message))
    }
}
