//! Arguments that accept several kinds of objects and are read once their grid is determined.

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
