//! Surfaces that a function of the package returns with their unit.

/// Declares the parts that classes of processed surfaces share: heights with a unit, the conversion to an array, and pickling.
/// A class is a tuple of the surface, its unit, and optionally further data.
macro_rules! processed {
    ($class:ident: $content:ty $(, $extra:ty)?; $(#[$doc:meta])+) => {
        #[pyo3::pymethods]
        impl $class {
            $(#[$doc])+
            #[getter]
            fn heights(&self) -> crate::field::Field {
                self.with_unit(self.0.heights())
            }

            #[pyo3(signature = (dtype=None, copy=None))]
            fn __array__<'py>(
                slf: &pyo3::Bound<'py, Self>,
                dtype: Option<pyo3::Bound<'py, pyo3::PyAny>>,
                copy: Option<bool>,
            ) -> pyo3::PyResult<pyo3::Bound<'py, pyo3::PyAny>> {
                let heights = crate::array::view(slf, |surface| surface.0.heights());
                crate::numpy_functions::as_numpy(heights.0, dtype, copy)
            }

            /// Implements NumPy functions of the heights. Operands of different units are rejected.
            #[pyo3(signature = (ufunc, method, *inputs, **kwargs))]
            fn __array_ufunc__<'py>(
                &self,
                ufunc: pyo3::Bound<'py, pyo3::PyAny>,
                method: &str,
                inputs: Vec<pyo3::Bound<'py, pyo3::PyAny>>,
                kwargs: Option<pyo3::Bound<'py, pyo3::types::PyDict>>,
            ) -> pyo3::PyResult<pyo3::Bound<'py, pyo3::PyAny>> {
                crate::numpy_functions::apply_to_heights(&ufunc, method, inputs, kwargs.as_ref())
            }

            /// Implements other NumPy functions of the heights, in the same way.
            fn __array_function__<'py>(
                &self,
                function: &pyo3::Bound<'py, pyo3::PyAny>,
                _types: &pyo3::Bound<'py, pyo3::PyAny>,
                arguments: &pyo3::Bound<'py, pyo3::PyAny>,
                options: &pyo3::Bound<'py, pyo3::types::PyDict>,
            ) -> pyo3::PyResult<pyo3::Bound<'py, pyo3::PyAny>> {
                crate::numpy_functions::apply_to_arrays(function, arguments, options)
            }

            fn __reduce__<'py>(
                &self,
                py: pyo3::Python<'py>,
            ) -> pyo3::PyResult<crate::pickle::Reduced<'py>> {
                let unit = self.1.as_deref().map(String::from);
                crate::pickle::reduced::<Self>(py, &(self.0.clone(), unit $(, <$extra>::from(self.2))?))
            }
        }

        crate::xarray::only_first_operand!($class);

        impl $class {
            fn with_unit(&self, field: &stickslip::Field) -> crate::field::Field {
                crate::field::Field::made(field.clone(), self.1.clone())
            }
        }

        impl crate::pickle::Stored for $class {
            type Content = ($content, Option<String> $(, $extra)?);

            const KIND: &'static str = stringify!($class);

            fn of_content(content: Self::Content) -> Self {
                Self(
                    content.0,
                    content.1.map(crate::unit::Unit::from)
                    $(, <$extra>::from(content.2))?
                )
            }
        }
    };
}

pub(super) use processed;
