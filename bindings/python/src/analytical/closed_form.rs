//! Declaration of the classes of closed-form solutions from their arguments, numbers and functions.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// Declares the class of a closed-form solution. The parts of the declaration are, in order: the object from which the
/// solution is constructed; further keyword arguments, which are numbers unless a type is given; the objects, numbers and pairs
/// of numbers of the solution; its functions of one and of two coordinates; and its additional methods.
macro_rules! closed_form {
    (
        $(#[$doc:meta])*
        $class:ident(
            $subject:ident: $subject_type:ty => $subject_value:expr
            $(, $number_argument:ident)*
            $(; $other:ident: $other_type:ty => $other_value:expr)?
        )
        $(objects { $($(#[$object_doc:meta])* $object:ident: $object_class:ty),* $(,)? })?
        numbers { $($(#[$number_doc:meta])* $number:ident),* $(,)? }
        $(pairs { $($(#[$pair_doc:meta])* $pair:ident),* $(,)? })?
        $(along { $($(#[$along_doc:meta])* $along:ident($coordinate:ident)),* $(,)? })?
        $(across { $($(#[$across_doc:meta])* $across:ident),* $(,)? })?
        $(also { $($also:item)* })?
    ) => {
        // The docs of a class start with its signature for Python. The signature of the constructor accepts further positional
        // arguments, which it rejects with the names of the keywords.
        #[doc = concat!(
            stringify!($class), "(", stringify!($subject), ", *"
            $(, ", ", stringify!($number_argument))* $(, ", ", stringify!($other))?, ")\n--\n"
        )]
        $(#[$doc])*
        #[pyo3::pyclass(frozen, eq, module = "stickslip.analytical")]
        #[derive(Clone, PartialEq)]
        pub(crate) struct $class(pub(crate) stickslip::analytical::$class);

        impl From<stickslip::analytical::$class> for $class {
            fn from(form: stickslip::analytical::$class) -> Self {
                Self(form)
            }
        }

        #[pyo3::pymethods]
        impl $class {
            #[new]
            #[pyo3(signature = ($subject, *positional, $($number_argument,)* $($other)?), text_signature = None)]
            fn new(
                py: pyo3::Python<'_>,
                $subject: $subject_type,
                positional: &pyo3::Bound<'_, pyo3::types::PyTuple>,
                $($number_argument: crate::real::Real,)*
                $($other: $other_type,)?
            ) -> pyo3::PyResult<Self> {
                crate::analytical::closed_form::by_keyword(
                    stringify!($class),
                    positional,
                    &[$(stringify!($number_argument),)* $(stringify!($other))?],
                )?;
                let form = stickslip::analytical::$class::new(
                    $subject_value,
                    $($number_argument.0,)*
                    $($other_value,)?
                );
                crate::error::OrRaise::or_raise(form, py).map(Self)
            }

            $($(
                $(#[$object_doc])*
                #[getter]
                fn $object(&self) -> $object_class {
                    self.0.$object().into()
                }
            )*)?

            $(
                $(#[$number_doc])*
                #[getter]
                fn $number(&self) -> f64 {
                    self.0.$number()
                }
            )*

            $($(
                $(#[$pair_doc])*
                #[getter]
                fn $pair(&self) -> (f64, f64) {
                    crate::sequence::pair(self.0.$pair())
                }
            )*)?

            $($(
                $(#[$along_doc])*
                fn $along(
                    &self,
                    $coordinate: crate::analytical::coordinates::Coordinates,
                ) -> crate::analytical::coordinates::Values {
                    $coordinate.along(|at| self.0.$along(at))
                }
            )*)?

            $($(
                $(#[$across_doc])*
                fn $across(
                    &self,
                    x: crate::analytical::coordinates::Coordinates,
                    y: crate::analytical::coordinates::Coordinates,
                ) -> pyo3::PyResult<crate::analytical::coordinates::Values> {
                    x.across(y, |x, y| self.0.$across(x, y))
                }
            )*)?

            fn __repr__(&self) -> String {
                let numbers: Vec<String> =
                    vec![$(format!(
                        "{}={}",
                        stringify!($number),
                        crate::digits::short(self.0.$number())
                    )),*];
                format!("{}({})", stringify!($class), numbers.join(", "))
            }
        }

        crate::argument::by_value!($class);
        crate::pickle::picklable!($class: stickslip::analytical::$class);

        $(#[pyo3::pymethods] impl $class { $($also)* })?
    };
}

pub(super) use closed_form;

/// Returns an error if numbers of a closed form are given by position, with their keywords. Closed forms have numbers of the same
/// type, whose order differs between them.
pub(super) fn by_keyword(
    form: &str,
    given: &Bound<'_, PyTuple>,
    keywords: &[&str],
) -> PyResult<()> {
    if given.is_empty() {
        return Ok(());
    }
    let keywords: Vec<_> = keywords.iter().map(|name| format!("{name}=")).collect();
    Err(PyTypeError::new_err(format!(
        "{form} takes its numbers by keyword, got {} by position: give {}",
        given.get_item(0)?.repr()?,
        keywords.join(", ")
    )))
}
