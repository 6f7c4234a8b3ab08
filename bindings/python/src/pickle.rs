//! Pickling through the serialisation of the crate, in a compact format.

use pyo3::PyClass;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyTuple, PyType};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Conversion of an object to and from its serialised content.
pub(crate) trait Stored: Sized {
    type Content: Serialize + DeserializeOwned;

    const KIND: &'static str;

    fn of_content(content: Self::Content) -> Self;
}

/// Reduced form of an object for pickle: the restoring function and its arguments.
pub(crate) type Reduced<'py> = (
    Bound<'py, PyAny>,
    (&'static str, &'static str, Bound<'py, PyBytes>),
);

/// Reduced form of an object with its own byte format: the restoring function and its arguments.
pub(crate) type Standalone<'py, A> = (Bound<'py, PyAny>, A);

/// Returns a function of the module that restores objects.
fn restoring<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("stickslip._stickslip")?.getattr(name)
}

/// Returns the reduced form of an object with its own byte format. The first argument is its class, whose ``from_bytes``
/// restores the object.
pub(crate) fn by_itself<A>(py: Python<'_>, arguments: A) -> PyResult<Standalone<'_, A>> {
    Ok((restoring(py, "_from_bytes")?, arguments))
}

/// Restores objects with their own byte format; called by pickle.
#[pyfunction]
#[pyo3(signature = (kind, *arguments))]
pub(crate) fn _from_bytes<'py>(
    kind: Bound<'py, PyType>,
    arguments: Bound<'py, PyTuple>,
) -> PyResult<Bound<'py, PyAny>> {
    kind.call_method1("from_bytes", arguments)
}

/// Extracts the parts of a content that the crate exposes only in its serialised form, in their order.
pub(crate) fn parts<T: DeserializeOwned>(content: &impl Serialize) -> PyResult<T> {
    let refused = |error: postcard::Error| PyValueError::new_err(error.to_string());
    let bytes = postcard::to_stdvec(content).map_err(refused)?;
    postcard::from_bytes(&bytes).map_err(refused)
}

/// Returns the reduced form of an object with this content.
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
    let content = postcard::from_bytes(bytes).map_err(|error| {
        PyValueError::new_err(format!("the bytes are not a pickled {}: {error}", T::KIND))
    })?;
    Ok(Bound::new(py, T::of_content(content))?.into_any())
}

/// Constructor arguments of a problem, positional and keyword, from which it is pickled.
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

    /// Adds a keyword unless its value is `None`.
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

    /// Adds the keywords of a normal load; the name of the force is a parameter.
    pub(crate) fn with_normal(
        self,
        py: Python<'_>,
        load: stickslip::NormalLoad,
        force: &str,
    ) -> PyResult<Self> {
        match load {
            stickslip::NormalLoad::Force(value) => self.with(py, force, Some(value)),
            stickslip::NormalLoad::Approach(value) => self.with(py, "approach", Some(value)),
            _ => Ok(self),
        }
    }

    /// Returns the warnings of the normal solution at this index of the positional arguments. An argument of another type has none.
    pub(crate) fn warnings_of_normal(
        &self,
        py: Python<'_>,
        index: usize,
    ) -> Vec<stickslip::Warning> {
        let argument = self.arguments.bind(py).get_item(index).ok();
        let normal = argument
            .and_then(|argument| argument.cast_into::<crate::normal::NormalSolution>().ok());
        normal.map_or_else(Vec::new, |normal| normal.get().get().warnings())
    }

    /// Returns both kinds of arguments, for ``__getnewargs_ex__``.
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

/// Makes a class with one serialisable field picklable.
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
        /// Restores an object; called by pickle. A pickle can only be read by the version that wrote it. Histories have
        /// their own byte format, which later versions can also read.
        #[pyfunction]
        pub(crate) fn _restore<'py>(
            py: Python<'py>,
            kind: &str,
            version: &str,
            bytes: &[u8],
        ) -> PyResult<Bound<'py, PyAny>> {
            if version != env!("CARGO_PKG_VERSION") {
                return Err(PyValueError::new_err(format!(
                    "a {kind} pickled by stickslip {version} cannot be read by stickslip {}: use the same version",
                    env!("CARGO_PKG_VERSION")
                )));
            }
            $(if kind == <$class as Stored>::KIND {
                return restored::<$class>(py, bytes);
            })+
            Err(PyTypeError::new_err(format!("stickslip has no class {kind} that can be pickled")))
        }
    };
}

kinds!(
    crate::adaptive::Region,
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
    crate::surface::RoughSurface,
    crate::surface::PowerSpectrum,
    crate::surface::Filled,
    crate::surface::Filtered,
    crate::surface::Levelled,
    crate::surface::MaterialRatio,
    crate::surface::Autocorrelation,
    crate::surface::WithoutOutliers,
    crate::edges::Edges,
    crate::edges::TangentialEdges,
    crate::sensitivity::Functional,
    crate::sensitivity::Sensitivity,
    crate::stiffness::NormalStiffness,
    crate::stiffness::TangentialStiffness,
    crate::stiffness::ContactStiffness,
    crate::rolling::RollingSolution,
    crate::rolling::CoupledRollingSolution,
    crate::rolling::CoupledRollingReport,
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
