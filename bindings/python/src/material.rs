//! Materials and pairs of materials.

use std::hash::{DefaultHasher, Hash, Hasher};

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
#[cfg(feature = "stubs")]
use pyo3::{PyTypeInfo, inspect::PyStaticExpr, type_hint_union};

use crate::argument::by_value;
use crate::conversion::{Layers, entries, kind_of};
use crate::digits::short;
use crate::error::OrRaise;
use crate::kernel::Kernel;
use crate::layers::{Layer, WaveResponse, numbers};
use crate::pickle::picklable;
use crate::readers::readers;
use crate::real::{Real, unnamed};

/// A linear elastic, isotropic half-space, homogeneous or :meth:`coated`.
///
/// Parameters
/// ----------
/// youngs_modulus : float
///     Young's modulus (a pressure), positive.
/// poisson_ratio : float
///     Poisson's ratio, in (-1, 0.5].
/// hardness : float, optional
///     The hardness (a pressure), positive; none by default. It is used only for a warning if the pressure of a
///     solution exceeds it. To limit the pressure, pass ``hardness`` to the problem.
///
/// Raises
/// ------
/// NotPositive, PoissonRatio
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> steel = stickslip.Material(210e9, 0.3)
/// >>> round(steel.shear_modulus / 1e9, 1)
/// 80.8
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Material(pub(crate) stickslip::Material);

readers! { Material.0:
    /// Young's modulus (a pressure); infinite for a rigid body.
    youngs_modulus(): f64,
    /// Shear modulus (a pressure); infinite for a rigid body.
    shear_modulus(): f64,
    /// Poisson's ratio; zero for a rigid body.
    poisson_ratio(): f64,
    /// The stated hardness (a pressure); infinite if it is not stated.
    hardness(): f64,
    /// Whether the body is rigid.
    is_rigid(): bool,
    /// Whether the body is coated.
    is_coated(): bool,
}

by_value!(Material, ElasticPair);

#[pymethods]
impl Material {
    #[new]
    #[pyo3(signature = (youngs_modulus, poisson_ratio, *, hardness=None))]
    fn new(
        py: Python<'_>,
        youngs_modulus: Real,
        poisson_ratio: Real,
        hardness: Option<Real>,
    ) -> PyResult<Self> {
        let body = stickslip::Material::new(youngs_modulus.0, poisson_ratio.0).or_raise(py)?;
        match hardness {
            None => Ok(Self(body)),
            Some(Real(hardness)) => body.with_hardness(hardness).or_raise(py).map(Self),
        }
    }

    /// Creates a material from its shear modulus (a pressure) instead of Young's modulus.
    #[staticmethod]
    fn from_shear_modulus(
        py: Python<'_>,
        shear_modulus: Real,
        poisson_ratio: Real,
    ) -> PyResult<Self> {
        let body = stickslip::Material::from_shear_modulus(shear_modulus.0, poisson_ratio.0);
        body.or_raise(py).map(Self)
    }

    /// Returns a body that does not deform.
    #[staticmethod]
    fn rigid() -> Self {
        Self(stickslip::Material::rigid())
    }

    /// Returns this body with layers bonded on top of it and of its existing layers, outermost first. On a rigid body,
    /// the layers are elastic layers on a rigid base. The moduli of a coated body are the moduli of the body below the
    /// layers. A hardness that was set earlier is kept.
    ///
    /// Parameters
    /// ----------
    /// layers : sequence of Layer
    ///     The layers; at most eight in total.
    ///
    /// Raises
    /// ------
    /// TooManyLayers
    fn coated(&self, py: Python<'_>, layers: Layers) -> PyResult<Self> {
        self.0.coated(&layers.0).or_raise(py).map(Self)
    }

    /// The layers of a coated body, outermost first.
    #[getter]
    fn layers(&self) -> Vec<Layer> {
        self.0.layers().iter().copied().map(Layer).collect()
    }

    /// Returns the strain along x, stress (1 - nu^2) / E, of a body that cannot contract along y under a stress along x
    /// (a pressure). Stress and strain are positive in tension.
    fn plane_strain_under(&self, stress: Real) -> f64 {
        self.0.plane_strain_under(stress.0)
    }

    /// Equal materials have equal hashes.
    fn __hash__(&self) -> u64 {
        hash_of(&constants(&self.0))
    }

    fn __repr__(&self) -> String {
        if self.0.is_coated() {
            let layers = self.layers();
            let layers: Vec<_> = layers.iter().map(Layer::__repr__).collect();
            let youngs_modulus = self.0.youngs_modulus();
            let base = if youngs_modulus.is_finite() {
                format!(
                    "Material({}, {})",
                    short(youngs_modulus),
                    short(self.0.poisson_ratio())
                )
            } else {
                "Material.rigid()".into()
            };
            return format!("{base}.coated([{}])", layers.join(", "));
        }
        if self.0.is_rigid() {
            return "Material.rigid()".into();
        }
        let hardness = match self.0.hardness() {
            hardness if hardness.is_finite() => format!(", hardness={}", short(hardness)),
            _ => String::new(),
        };
        format!(
            "Material(youngs_modulus={}, poisson_ratio={}{hardness})",
            short(self.0.youngs_modulus()),
            short(self.0.poisson_ratio())
        )
    }
}

picklable!(Material: stickslip::Material);

/// Returns a hash of numbers; equal numbers have equal hashes.
pub(crate) fn hash_of(numbers: &[f64]) -> u64 {
    let mut hasher = DefaultHasher::new();
    for number in numbers {
        // Minus zero equals zero but has a different bit pattern; adding zero makes the bit patterns equal.
        (number + 0.0).to_bits().hash(&mut hasher);
    }
    hasher.finish()
}

/// Returns the numbers that define a body.
fn constants(body: &stickslip::Material) -> Vec<f64> {
    let own = [body.youngs_modulus(), body.poisson_ratio(), body.hardness()];
    let layers = body.layers().iter().flat_map(numbers);
    own.into_iter().chain(layers).collect()
}

/// Two bodies, at most one of them rigid.
///
/// Parameters
/// ----------
/// body_1, body_2 : Material
///     The two bodies. The z axis points into body 1. Pressure and traction are those that act on body 1; on body 2 they
///     have the opposite sign.
///
/// Raises
/// ------
/// BothRigid, NotPositive, NotFinite
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct ElasticPair(pub(crate) stickslip::ElasticPair);

impl From<&stickslip::ElasticPair> for ElasticPair {
    fn from(pair: &stickslip::ElasticPair) -> Self {
        Self(*pair)
    }
}

readers! { ElasticPair.0:
    /// The hardness of the softer body (a pressure); infinite if none is stated.
    hardness(): f64,
    /// Contact modulus E* (a pressure), 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
    contact_modulus(): f64,
    /// Tangential modulus G* (a pressure), 1/G* = (2 - nu_1)/G_1 + (2 - nu_2)/G_2.
    tangential_modulus(): f64,
    /// Shear modulus G of the single body with the compliance of both bodies (a pressure), 1/G = 1/G_1 + 1/G_2. It is
    /// half of the modulus of each of two equal bodies.
    equivalent_shear_modulus(): f64,
    /// Poisson's ratio of the single body with the compliance of both bodies, nu = G (nu_1/G_1 + nu_2/G_2).
    equivalent_poisson_ratio(): f64,
    /// Dundurs' second parameter, which measures the coupling of pressure and traction; zero if they are not coupled.
    ///
    /// beta = ((1 - 2 nu_1) / G_1 - (1 - 2 nu_2) / G_2) / (2 ((1 - nu_1) / G_1 + (1 - nu_2) / G_2)). It is positive if
    /// body 1 has the larger value of (1 - 2 nu) / G, and an exchange of the bodies reverses its sign. It is zero for
    /// bodies of the same material, for two incompressible bodies, and for an incompressible body on a rigid body.
    dundurs_beta(): f64,
    /// Whether pressure and traction are coupled.
    is_coupled(): bool,
    /// Whether one of the bodies is coated.
    is_coated(): bool,
}

#[pymethods]
impl ElasticPair {
    #[new]
    fn new(py: Python<'_>, body_1: Material, body_2: Material) -> PyResult<Self> {
        stickslip::ElasticPair::new(body_1.0, body_2.0)
            .or_raise(py)
            .map(Self)
    }

    /// The two bodies.
    #[getter]
    fn bodies(&self) -> (Material, Material) {
        self.0.bodies().map(Material).into()
    }

    /// Returns the response of the relative displacement u_1 - u_2 to waves of traction of the wave number k > 0 (one
    /// over a length).
    ///
    /// Raises
    /// ------
    /// NotPositive, IncompleteKernel
    fn response(&self, py: Python<'_>, k: Real) -> PyResult<WaveResponse> {
        self.0.response(k.0).or_raise(py).map(WaveResponse)
    }

    /// Equal pairs have equal hashes.
    fn __hash__(&self) -> u64 {
        hash_of(&self.0.bodies().each_ref().map(constants).concat())
    }

    pub(crate) fn __repr__(&self) -> String {
        let [body_1, body_2] = self.0.bodies().map(|body| Material(body).__repr__());
        format!("ElasticPair({body_1}, {body_2})")
    }
}

picklable!(ElasticPair: stickslip::ElasticPair);

/// Argument that is converted to bodies: a pair, two materials, or a kernel.
pub(crate) struct Bodies(pub(crate) stickslip::Kernel);

impl FromPyObject<'_, '_> for Bodies {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        ElasticPair::TYPE_HINT,
        Kernel::TYPE_HINT,
        <(Material, Material) as FromPyObject>::INPUT_TYPE
    );

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(pair) = object.cast::<ElasticPair>() {
            return Ok(Self(pair.get().0.into()));
        }
        if let Ok(kernel) = object.cast::<Kernel>() {
            return Ok(Self(kernel.get().0.clone()));
        }
        let bodies = entries(&object).and_then(|bodies| bodies.extract().ok());
        let (body_1, body_2): (Material, Material) = bodies.ok_or_else(|| {
            PyTypeError::new_err(format!(
                "pair must be an ElasticPair, a Kernel or a tuple of two Materials, (material_1, material_2), got {}",
                entries(&object).map_or_else(|| kind_of(&object), |bodies| kinds_of(&bodies))
            ))
        })?;
        ElasticPair::new(object.py(), body_1, body_2).map(|pair| Self(pair.0.into()))
    }
}

/// Argument that is converted to a pair of bodies without a kernel: a pair, or two materials.
pub(crate) struct Pair(pub(crate) stickslip::ElasticPair);

impl FromPyObject<'_, '_> for Pair {
    type Error = PyErr;

    #[cfg(feature = "stubs")]
    const INPUT_TYPE: PyStaticExpr = type_hint_union!(
        ElasticPair::TYPE_HINT,
        <(Material, Material) as FromPyObject>::INPUT_TYPE
    );

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(pair) = object.cast::<ElasticPair>() {
            return Ok(Self(pair.get().0));
        }
        let bodies = entries(&object).and_then(|bodies| bodies.extract().ok());
        let (body_1, body_2): (Material, Material) = bodies.ok_or_else(|| {
            let found = match entries(&object) {
                Some(bodies) => kinds_of(&bodies),
                None => kind_of(&object),
            };
            let due =
                "must be an ElasticPair or a tuple of two Materials, (material_1, material_2)";
            unnamed(object.py(), "ArgumentType", &format!("{due}, got {found}"))
        })?;
        ElasticPair::new(object.py(), body_1, body_2).map(|pair| Self(pair.0))
    }
}

/// Returns the names of the types of the entries of a tuple.
fn kinds_of(entries: &Bound<'_, PyTuple>) -> String {
    let kinds: Vec<_> = entries.iter().map(|entry| kind_of(&entry)).collect();
    format!("({})", kinds.join(", "))
}
