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
        let remedy = match T::NAME {
            "HalfSpace" => ": the bodies are the first argument, created by HalfSpace(grid, pair)",
            "Grid" => ": create a grid by Grid(nx, ny, dx, dy)",
            "History" => ": create a history by History(bodies, gap, friction)",
            "Cycle" => ": create a cycle by Cycle(history)",
            _ => "",
        };
        let message = format!(
            "must be of the class {}, got {}{remedy}",
            T::NAME,
            kind_of(&object)
        );
        Err(unnamed(object.py(), "ArgumentType", &message))
    }
}

/// Argument that must be a sequence of objects of a class of the package. The error message contains the name of the argument.
pub(crate) struct Listed<'py, T> {
    pub(crate) objects: Vec<Bound<'py, T>>,
}

impl<'py, T: PyClass> FromPyObject<'_, 'py> for Listed<'py, T> {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = <Vec<Bound<'py, T>> as FromPyObject<'_, 'py>>::INPUT_TYPE;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let refuse = |found: String| {
            let message = format!("must be a sequence of {}, got {found}", T::NAME);
            unnamed(object.py(), "ArgumentType", &message)
        };
        let Ok(entries) = object.try_iter() else {
            let remedy = if object.is_instance_of::<T>() {
                ": give a list with one entry for each history"
            } else {
                ""
            };
            return Err(refuse(format!("{}{remedy}", kind_of(&object))));
        };
        let mut objects = Vec::new();
        for (index, entry) in entries.enumerate() {
            let entry = entry?;
            objects.push(entry.cast_into::<T>().map_err(|error| {
                let found = kind_of(&error.into_inner());
                refuse(format!("{found} as the entry {index}"))
            })?);
        }
        Ok(Self { objects })
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
