//! Arguments that are objects of the package, and arguments that accept several kinds of objects and are read once their grid
//! is determined.

use std::ops::Deref;

use pyo3::PyClass;
#[cfg(feature = "stubs")]
use pyo3::inspect::PyStaticExpr;
use pyo3::prelude::*;
use pyo3::pyclass::boolean_struct::True;

use crate::conversion::kind_of;
use crate::real::unnamed;

/// Declares an argument that accepts an object of one of these classes, an array, or anything else that NumPy converts to
/// an array.
macro_rules! argument {
    ($(#[$doc:meta])* $name:ident: $($class:ty)|+ $(; $builtin:literal)?) => {
        $(#[$doc])*
        pub(crate) struct $name<'py>(pyo3::Bound<'py, pyo3::PyAny>);

        const _: () = {
            #[cfg(feature = "stubs")]
            use pyo3::{PyTypeInfo, inspect::PyStaticExpr, type_hint_identifier, type_hint_union};

            impl<'py> pyo3::FromPyObject<'_, 'py> for $name<'py> {
                type Error = pyo3::PyErr;

                #[cfg(feature = "stubs")]
                const INPUT_TYPE: PyStaticExpr = type_hint_union!(
                    $(<$class>::TYPE_HINT,)+
                    $(type_hint_identifier!("builtins", $builtin),)?
                    type_hint_identifier!("numpy.typing", "ArrayLike")
                );

                fn extract(object: pyo3::Borrowed<'_, 'py, pyo3::PyAny>) -> pyo3::PyResult<Self> {
                    Ok(Self(object.to_owned()))
                }
            }
        };
    };
}

pub(crate) use argument;

/// Argument that must be an object of a class of the package. The error message contains the name of the argument.
pub(crate) struct Object<T> {
    object: Py<T>,
}

impl<T: PyClass<Frozen = True> + Sync> Deref for Object<T> {
    type Target = T;

    fn deref(&self) -> &T {
        self.object.get()
    }
}

impl<T> Object<T> {
    /// Returns the object for Python.
    pub(crate) fn object<'py>(&self, py: Python<'py>) -> Bound<'py, T> {
        self.object.bind(py).clone()
    }
}

impl<T: PyClass<Frozen = True> + Sync> FromPyObject<'_, '_> for Object<T> {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = T::TYPE_HINT;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(object) = object.cast::<T>() {
            let object = object.to_owned().unbind();
            return Ok(Self { object });
        }
        let message = format!("must be of the class {}, got {}", T::NAME, kind_of(&object));
        Err(unnamed(object.py(), "ArgumentType", &message))
    }
}

/// Implements the extraction of arguments of these classes by value, with the messages of [`Object`].
macro_rules! by_value {
    ($($class:ty),+ $(,)?) => {$(
        impl pyo3::FromPyObject<'_, '_> for $class {
            type Error = pyo3::PyErr;

            #[cfg(feature = "stubs")]
            const INPUT_TYPE: pyo3::inspect::PyStaticExpr = <Self as pyo3::PyTypeInfo>::TYPE_HINT;

            fn extract(object: pyo3::Borrowed<'_, '_, pyo3::PyAny>) -> pyo3::PyResult<Self> {
                let object: crate::argument::Object<Self> = object.extract()?;
                Ok((*object).clone())
            }
        }
    )+};
}

pub(crate) use by_value;
