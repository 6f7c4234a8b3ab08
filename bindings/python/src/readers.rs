//! Getters that read one value each, and the surfaces and tables that share their methods.

/// Declares getters that read a field (`name: type`) or call a method (`name(): type`) of the content of a class. A function
/// after `=>` converts the value. The content is `Class.0` or `Class.get()`.
macro_rules! readers {
    ($class:ident.0: $($getters:tt)+) => {
        crate::readers::readers! { $class (content, object => &object.0): $($getters)+ }
    };
    ($class:ident.get(): $($getters:tt)+) => {
        crate::readers::readers! { $class (content, object => object.get()): $($getters)+ }
    };
    ($class:ident ($content:ident, $object:ident => $read:expr):
        $($(#[$doc:meta])* $name:ident $(($($of:tt)*))?: $type:ty $(=> $convert:expr)?),+ $(,)?) => {
        #[pyo3::pymethods]
        impl $class {
            $(
                $(#[$doc])*
                #[getter]
                fn $name(&self) -> $type {
                    let $object = self;
                    let $content = $read;
                    let value = $content.$name$(($($of)*))?;
                    $(let value = $convert(value);)?
                    value
                }
            )+
        }
    };
}

/// Declares the ISO names of getters, and the methods that return all of them as a dictionary and as a series of pandas.
macro_rules! iso_names {
    ($class:ident: $($iso:ident = $name:ident),+; $($other:ident),*) => {
        #[pyo3::pymethods]
        #[allow(non_snake_case, reason = "the names of the standard")]
        impl $class {
            $(
                #[doc = concat!("ISO 25178-2 name of :attr:`", stringify!($name), "`.")]
                #[getter]
                fn $iso(&self) -> f64 {
                    self.0.$name()
                }
            )+
        }

        crate::readers::record!($class: $($other,)* $($iso),+);
    };
}

/// Declares the methods that return attributes of an object as a dictionary and as a series of pandas.
macro_rules! record {
    ($class:ident: $($name:ident),+) => {
        #[pyo3::pymethods]
        impl $class {
            /// Returns the numbers by name; a pair (x, y) becomes two numbers with the endings ``_x`` and ``_y``. The numbers of
            /// an object with the same method have its name as the prefix.
            fn to_dict<'py>(
                slf: &pyo3::Bound<'py, Self>,
            ) -> pyo3::PyResult<pyo3::Bound<'py, pyo3::types::PyDict>> {
                crate::readers::by_name(slf, "record", &[$(stringify!($name)),+])
            }

            /// Returns the numbers of :meth:`to_dict` as a :class:`pandas.Series` (requires pandas).
            fn to_series<'py>(
                slf: &pyo3::Bound<'py, Self>,
            ) -> pyo3::PyResult<pyo3::Bound<'py, pyo3::PyAny>> {
                let values = Self::to_dict(slf)?;
                crate::readers::table(slf.py(), "to_series", (values, stringify!($class)))
            }
        }
    };
}

/// Declares the methods that return a sequence as a dictionary of arrays and as a frame of pandas. The function of the
/// module `_tables` collects the arrays: `record` from attributes of the sequence, `columns` from its entries.
macro_rules! frame {
    ($class:ident, $function:ident: $($name:ident),+) => {
        #[pyo3::pymethods]
        impl $class {
            /// Returns arrays by name, with one entry per element; a vector becomes one array per component with the endings
            /// ``_x``, ``_y`` and ``_z``, and stresses have endings such as ``_xx``.
            fn to_dict<'py>(
                slf: &pyo3::Bound<'py, Self>,
            ) -> pyo3::PyResult<pyo3::Bound<'py, pyo3::types::PyDict>> {
                crate::readers::by_name(slf, stringify!($function), &[$(stringify!($name)),+])
            }

            /// Returns the arrays of :meth:`to_dict` as columns of a :class:`pandas.DataFrame` (requires pandas).
            fn to_frame<'py>(
                slf: &pyo3::Bound<'py, Self>,
            ) -> pyo3::PyResult<pyo3::Bound<'py, pyo3::PyAny>> {
                let columns = Self::to_dict(slf)?;
                crate::readers::table(slf.py(), "to_frame", (columns,))
            }
        }
    };
}

pub(crate) use {frame, iso_names, readers, record};

use pyo3::PyClass;
use pyo3::call::PyCallArgs;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Collects attributes in a dictionary by a function of the module `_tables`.
pub(crate) fn by_name<'py, T: PyClass>(
    object: &Bound<'py, T>,
    function: &str,
    names: &[&str],
) -> PyResult<Bound<'py, PyDict>> {
    let found = table(object.py(), function, (object, names))?;
    Ok(found.cast_into::<PyDict>()?)
}

/// Calls a function of the module `_tables`.
pub(crate) fn table<'py>(
    py: Python<'py>,
    function: &str,
    arguments: impl PyCallArgs<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    let module = py.import("stickslip._tables")?;
    module.getattr(function)?.call1(arguments)
}
