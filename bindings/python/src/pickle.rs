//! Pickling, through the crate's own serialisation in a compact format.

use pyo3::PyClass;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyTuple, PyType};
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

/// How an object with bytes of its own is pickled: what restores it, and from which arguments.
pub(crate) type Standalone<'py, A> = (Bound<'py, PyAny>, A);

/// A function of the module, by which objects are restored.
fn restoring<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("stickslip._stickslip")?.getattr(name)
}

/// What restores an object that has bytes of its own, by ``from_bytes`` of its class: the first of the arguments.
pub(crate) fn by_itself<A>(py: Python<'_>, arguments: A) -> PyResult<Standalone<'_, A>> {
    Ok((restoring(py, "_from_bytes")?, arguments))
}

/// What pickle calls for what has bytes of its own.
#[pyfunction]
#[pyo3(signature = (kind, *arguments))]
pub(crate) fn _from_bytes<'py>(
    kind: Bound<'py, PyType>,
    arguments: Bound<'py, PyTuple>,
) -> PyResult<Bound<'py, PyAny>> {
    kind.call_method1("from_bytes", arguments)
}

/// The parts of a content of the crate that it shows in its serialised form alone, in their order.
pub(crate) fn parts<T: DeserializeOwned>(content: &impl Serialize) -> PyResult<T> {
    let refused = |error: postcard::Error| PyValueError::new_err(error.to_string());
    let bytes = postcard::to_stdvec(content).map_err(refused)?;
    postcard::from_bytes(&bytes).map_err(refused)
}

/// How an object of this content is pickled.
pub(crate) fn reduced<'py, T: Stored>(
    py: Python<'py>,
    content: &T::Content,
) -> PyResult<Reduced<'py>> {
    let bytes =
        postcard::to_stdvec(content).map_err(|error| PyValueError::new_err(error.to_string()))?;
    let version = env!("CARGO_PKG_VERSION");
    let arguments = (T::KIND, version, PyBytes::new(py, &bytes));
    Ok((restoring(py, "_restore")?, arguments))
}

fn restored<'py, T>(py: Python<'py>, bytes: &[u8]) -> PyResult<Bound<'py, PyAny>>
where
    T: Stored + PyClass + Into<PyClassInitializer<T>>,
{
    let content = postcard::from_bytes(bytes)
        .map_err(|error| PyValueError::new_err(format!("not a pickled {}: {error}", T::KIND)))?;
    Ok(Bound::new(py, T::of_content(content))?.into_any())
}

/// What a problem is made from, by which it is pickled: the positional arguments and the keywords of its class.
pub(crate) struct Recipe {
    arguments: Py<PyTuple>,
    keywords: Py<PyDict>,
}

impl Recipe {
    pub(crate) fn new<'py>(
        py: Python<'py>,
        arguments: impl IntoPyObject<'py, Target = PyTuple, Output = Bound<'py, PyTuple>, Error = PyErr>,
    ) -> PyResult<Self> {
        Ok(Self {
            arguments: arguments.into_pyobject(py)?.unbind(),
            keywords: PyDict::new(py).unbind(),
        })
    }

    /// With a keyword, unless it was not given.
    pub(crate) fn with<'py>(
        self,
        py: Python<'py>,
        name: &str,
        value: Option<impl IntoPyObject<'py>>,
    ) -> PyResult<Self> {
        if let Some(value) = value {
            self.keywords.bind(py).set_item(name, value)?;
        }
        Ok(self)
    }

    /// With the keywords of a normal load, of which the force may have another name.
    pub(crate) fn with_normal(
        self,
        py: Python<'_>,
        load: stickslip::NormalControl,
        force: &str,
    ) -> PyResult<Self> {
        match load {
            stickslip::NormalControl::Force(value) => self.with(py, force, Some(value)),
            stickslip::NormalControl::Approach(value) => self.with(py, "approach", Some(value)),
            _ => Ok(self),
        }
    }

    /// Both, for ``__getnewargs_ex__``.
    pub(crate) fn parts<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        Ok((
            self.arguments.bind(py).clone(),
            self.keywords.bind(py).copy()?,
        ))
    }
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
    crate::cgm::Minimum,
    crate::grid::Grid,
    crate::layers::Layer,
    crate::material::Material,
    crate::material::ElasticPair,
    crate::boundary::Boundary,
    crate::field::Field,
    crate::settings::Settings,
    crate::load::LoadStep,
    crate::load::TangentialLoad,
    crate::friction::Friction,
    crate::normal::Hardness,
    crate::history::EnergyBalance,
    crate::history::LoadPath,
    crate::history::Rolling,
    crate::history::StepResult,
    crate::history::Cycle,
    crate::normal::NormalSolution,
    crate::surface::SelfAffine,
    crate::surface::Statistics,
    crate::coupled::CoupledReport,
    crate::coupled::CoupledSolution,
    crate::tangential::RelativeDisplacement,
    crate::tangential::TangentialSolution,
    crate::report::Iteration,
    crate::report::Report,
    crate::report::Warning,
    crate::spots::Spot,
    crate::spots::ContactSpots,
    crate::history::LoopPoint,
    crate::history::LoopPoints,
    crate::history::StepErrorEstimate,
    crate::coupled::ErrorEstimate,
    crate::subsurface::Stress,
    crate::subsurface::Principal,
    crate::subsurface::PointResult,
    crate::subsurface::PointResults,
    crate::rolling::CreepForce,
    crate::rolling::CreepForces,
    crate::analytical::BentallJohnson,
    crate::analytical::Carter,
    crate::analytical::CattaneoMindlin,
    crate::analytical::CattaneoMindlinEllipse,
    crate::analytical::CattaneoMindlinLine,
    crate::analytical::Cone,
    crate::analytical::ConePartialSlip,
    crate::analytical::FlatPunch,
    crate::analytical::HertzEllipse,
    crate::analytical::HertzLine,
    crate::analytical::HertzSphere,
    crate::analytical::KalkerCoefficients,
    crate::analytical::LubkinTorsion,
    crate::analytical::MindlinDeresiewicz,
    crate::analytical::MindlinFullStick,
    crate::analytical::NoSlipPunch,
    crate::analytical::NoSlipSphere,
    crate::analytical::Persson,
    crate::analytical::PopovLimitingShape,
    crate::analytical::RoughSphere,
    crate::analytical::RoundedPunch,
    crate::analytical::SpencePressing,
    crate::analytical::VermeulenJohnson,
    crate::analytical::Westergaard,
    crate::analytical::WestergaardPartialSlip,
);
