//! Pickling, through the crate's own serialisation in a compact format.

use pyo3::PyClass;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// What an object is made of, and made again from.
pub(crate) trait Stored: Sized {
    type Content: Serialize + DeserializeOwned;

    const KIND: &'static str;

    fn of_content(content: Self::Content) -> Self;
}

/// How an object is pickled: what restores it, and from what.
pub(crate) type Reduced<'py> = (
    Bound<'py, PyAny>,
    (&'static str, &'static str, Bound<'py, PyBytes>),
);

/// The same of what has bytes of its own: what restores it, and its arguments.
pub(crate) type ByItself<'py, A> = (Bound<'py, PyAny>, A);

/// What restores an object of this content.
pub(crate) fn reduced<'py, T: Stored>(
    py: Python<'py>,
    content: &T::Content,
) -> PyResult<Reduced<'py>> {
    let bytes =
        postcard::to_stdvec(content).map_err(|error| PyValueError::new_err(error.to_string()))?;
    let restore = py.import("stickslip._stickslip")?.getattr("_restore")?;
    let version = env!("CARGO_PKG_VERSION");
    Ok((restore, (T::KIND, version, PyBytes::new(py, &bytes))))
}

fn restored<'py, T>(py: Python<'py>, bytes: &[u8]) -> PyResult<Bound<'py, PyAny>>
where
    T: Stored + PyClass + Into<PyClassInitializer<T>>,
{
    let content = postcard::from_bytes(bytes)
        .map_err(|error| PyValueError::new_err(format!("not a pickled {}: {error}", T::KIND)))?;
    Ok(Bound::new(py, T::of_content(content))?.into_any())
}

/// Makes a class of one serialisable field picklable.
macro_rules! picklable {
    ($class:ident: $content:ty) => {
        impl crate::pickle::Stored for $class {
            type Content = $content;

            const KIND: &'static str = stringify!($class);

            fn of_content(content: $content) -> Self {
                Self(content.into())
            }
        }

        #[pyo3::pymethods]
        impl $class {
            fn __reduce__<'py>(
                &self,
                py: pyo3::Python<'py>,
            ) -> pyo3::PyResult<crate::pickle::Reduced<'py>> {
                crate::pickle::reduced::<Self>(py, &self.0)
            }
        }
    };
}

pub(crate) use picklable;

macro_rules! kinds {
    ($($class:path),+ $(,)?) => {
        /// What pickle calls. Pickles are read by the version that wrote them alone; histories have bytes of their own,
        /// which later versions read too.
        #[pyfunction]
        pub(crate) fn _restore<'py>(
            py: Python<'py>,
            kind: &str,
            version: &str,
            bytes: &[u8],
        ) -> PyResult<Bound<'py, PyAny>> {
            if version != env!("CARGO_PKG_VERSION") {
                return Err(PyValueError::new_err(format!(
                    "a {kind} pickled by stickslip {version} cannot be read by stickslip {}",
                    env!("CARGO_PKG_VERSION")
                )));
            }
            $(if kind == <$class as Stored>::KIND {
                return restored::<$class>(py, bytes);
            })+
            Err(PyTypeError::new_err(format!("no class {kind}")))
        }
    };
}

kinds!(
    crate::grid::Grid,
    crate::grid::Material,
    crate::grid::ElasticPair,
    crate::grid::Boundary,
    crate::field::Field,
    crate::settings::Settings,
    crate::load::LoadStep,
    crate::load::TangentialLoad,
    crate::friction::Friction,
    crate::friction::Hardness,
    crate::history::EnergyBalance,
    crate::history::LoadPath,
    crate::history::StepResult,
    crate::history::Cycle,
    crate::normal::NormalSolution,
    crate::surface::SelfAffine,
    crate::coupled::CoupledReport,
    crate::coupled::CoupledSolution,
    crate::tangential::TangentialSolution,
);
