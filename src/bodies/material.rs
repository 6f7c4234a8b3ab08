//! Elastic constants of a body and of a pair of bodies.

use crate::bodies::layers::{Base, Coating, Layer, LayerWaves, Response};
use crate::error::{
    Error, Result, at_least, finite, poisson_ratio as check_poisson_ratio, positive,
};

/// Dundurs' beta at or below which pressure and traction count as uncoupled.
const UNCOUPLED: f64 = 1e-12;

/// Linear elastic, isotropic half-space, homogeneous or [coated](Self::coated).
///
/// Moduli have the unit of a pressure, and Poisson's ratio lies in `(-1, 1/2]`. The moduli of a coated body are the
/// moduli of its substrate.
///
/// ```
/// let steel = stickslip::Material::new(210e9, 0.3)?;
/// assert!((steel.shear_modulus() - 80.769e9).abs() < 1e6);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "RawMaterial")
)]
pub struct Material {
    /// Young's modulus, infinite for a rigid body.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    youngs_modulus: f64,
    poisson_ratio: f64,
    /// Hardness, infinite if none is stated.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    hardness: f64,
    #[cfg_attr(feature = "serde", serde(rename = "layers"))]
    coating: Coating,
}

/// Deserialised values that have not been checked yet.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct RawMaterial {
    #[serde(with = "crate::support::serialise::number")]
    youngs_modulus: f64,
    poisson_ratio: f64,
    #[serde(
        default = "default_hardness",
        with = "crate::support::serialise::number"
    )]
    hardness: f64,
    #[serde(default)]
    layers: Vec<Layer>,
}

#[cfg(feature = "serde")]
fn default_hardness() -> f64 {
    f64::INFINITY
}

#[cfg(feature = "serde")]
impl TryFrom<RawMaterial> for Material {
    type Error = Error;

    fn try_from(read: RawMaterial) -> Result<Self> {
        let body = if read.youngs_modulus == f64::INFINITY {
            check_poisson_ratio(read.poisson_ratio)?;
            Self::rigid()
        } else {
            Self::new(read.youngs_modulus, read.poisson_ratio)?
        };
        body.coated(&read.layers)?.stating(read.hardness)
    }
}

impl Material {
    /// Creates a body of Young's modulus `youngs_modulus` (a pressure) and Poisson's ratio `poisson_ratio`.
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if the modulus is not positive.
    /// - [`Error::PoissonRatio`] if the ratio is out of range.
    pub fn new(youngs_modulus: f64, poisson_ratio: f64) -> Result<Self> {
        positive("Young's modulus", youngs_modulus)?;
        check_poisson_ratio(poisson_ratio)?;
        Self {
            youngs_modulus,
            poisson_ratio,
            hardness: f64::INFINITY,
            coating: Coating::NONE,
        }
        .checked(youngs_modulus)
    }

    /// Creates a body of shear modulus `shear_modulus` (a pressure) and Poisson's ratio `poisson_ratio`.
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if the modulus is not positive.
    /// - [`Error::PoissonRatio`] if the ratio is out of range.
    pub fn from_shear_modulus(shear_modulus: f64, poisson_ratio: f64) -> Result<Self> {
        positive("shear modulus", shear_modulus)?;
        check_poisson_ratio(poisson_ratio)?;
        Self {
            youngs_modulus: 2.0 * (1.0 + poisson_ratio) * shear_modulus,
            poisson_ratio,
            hardness: f64::INFINITY,
            coating: Coating::NONE,
        }
        .checked(shear_modulus)
    }

    /// Rejects a modulus that over- or underflows, or whose reciprocal does.
    fn checked(self, modulus: f64) -> Result<Self> {
        if self.youngs_modulus.is_normal() && self.compliance().is_normal() {
            Ok(self)
        } else {
            Err(Error::NotPositive {
                quantity: "the modulus and its reciprocal",
                value: modulus,
            })
        }
    }

    /// Creates a body that does not deform.
    #[must_use]
    pub fn rigid() -> Self {
        Self {
            youngs_modulus: f64::INFINITY,
            poisson_ratio: 0.0,
            hardness: f64::INFINITY,
            coating: Coating::NONE,
        }
    }

    /// Adds layers that are bonded to this body, the outermost first, above any layers that it already has. On a
    /// [rigid](Self::rigid) body they form a bed on a rigid base. The documentation of [`layers`](crate::layers) describes the
    /// model and its limits. The moduli of a coated [`Material`] are the moduli of the body below the layers. A
    /// hardness that was set earlier is kept. The hardness of the coating must be set afterwards.
    ///
    /// ```
    /// use stickslip::{ElasticPair, Material, layers::Layer};
    /// let steel = Material::new(210e9, 0.3)?;
    /// let hard = steel.coated(&[Layer::new(400e9, 0.25, 2e-6)?])?;
    /// let response = |waves_per_metre| ElasticPair::new(hard, Material::rigid())?.response(waves_per_metre);
    /// // Waves that are long compared with the coating respond like the steel, short waves like the coating.
    /// let plane = |modulus: f64, nu: f64| modulus / (1.0 - nu * nu);
    /// assert!((response(1.0)?.normal * 0.5 * plane(210e9, 0.3) - 1.0).abs() < 1e-4);
    /// assert!((response(1e8)?.normal * 0.5e8 * plane(400e9, 0.25) - 1.0).abs() < 1e-12);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::TooManyLayers`] if the number of layers exceeds [`layers::LIMIT`](crate::layers::LIMIT).
    pub fn coated(mut self, layers: &[Layer]) -> Result<Self> {
        self.coating = self.coating.under(layers)?;
        Ok(self)
    }

    /// Returns the layers of a coated body, the outermost first. A homogeneous body has no layers.
    #[must_use]
    pub fn layers(&self) -> &[Layer] {
        self.coating.layers()
    }

    /// Returns whether the body is coated.
    #[must_use]
    pub fn is_coated(&self) -> bool {
        !self.layers().is_empty()
    }

    /// Returns the strain of the bulk along x under the stress `stress` along x, without strain along y or stress along z:
    /// $`\varepsilon = \sigma (1 - \nu^2)/E`$, positive in tension. A body that is free to contract along y has the strains
    /// $`\sigma/E`$ along x and $`-\nu\sigma/E`$ along y.
    #[must_use]
    pub fn plane_strain_under(&self, stress: f64) -> f64 {
        stress * (1.0 - self.poisson_ratio * self.poisson_ratio) / self.youngs_modulus
    }

    /// Sets the hardness (a pressure). If an elastic contact exceeds it, the solution has the warning
    /// [`Warning::BeyondHardness`](crate::Warning::BeyondHardness). To limit the pressure, give the problem a
    /// [`Hardness`](crate::normal::Hardness). A Vickers number HV in kgf/mm2 times 9.81 is a hardness in MPa.
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if the hardness is not positive and finite.
    pub fn with_hardness(self, hardness: f64) -> Result<Self> {
        self.stating(positive("hardness", hardness)?)
    }

    /// Sets the hardness, which may be infinite if none is stated.
    pub(crate) fn stating(mut self, hardness: f64) -> Result<Self> {
        if hardness != f64::INFINITY {
            positive("hardness", hardness)?;
        }
        self.hardness = hardness;
        Ok(self)
    }

    /// Returns the stated hardness (a pressure), or infinity if none is stated.
    #[must_use]
    pub fn hardness(&self) -> f64 {
        self.hardness
    }

    /// Returns whether the body does not deform: it is rigid and not coated.
    #[must_use]
    pub fn is_rigid(&self) -> bool {
        self.youngs_modulus.is_infinite() && !self.is_coated()
    }

    /// Returns Young's modulus `E` (a pressure), which is infinite for a rigid body.
    #[must_use]
    pub fn youngs_modulus(&self) -> f64 {
        self.youngs_modulus
    }

    /// Returns the shear modulus `G = E / (2 (1 + nu))` (a pressure), which is infinite for a rigid body.
    #[must_use]
    pub fn shear_modulus(&self) -> f64 {
        1.0 / self.compliance()
    }

    /// Returns Poisson's ratio. It is zero for a rigid body, for which it has no effect.
    #[must_use]
    pub fn poisson_ratio(&self) -> f64 {
        self.poisson_ratio
    }

    /// Returns `1/G`, or zero for a rigid body.
    fn compliance(&self) -> f64 {
        2.0 * (1.0 + self.poisson_ratio) / self.youngs_modulus
    }

    /// Returns the three constants for the influence coefficients of short waves: the constants of the outermost layer, if any.
    pub(crate) fn compliances(&self) -> Compliances {
        match self.layers() {
            [] => self.base_compliances(),
            [outermost, ..] => {
                Compliances::new(1.0 / outermost.shear_modulus(), outermost.poisson_ratio())
            }
        }
    }

    /// Returns the three constants for long waves: the constants of the body below all layers.
    pub(crate) fn base_compliances(&self) -> Compliances {
        Compliances::new(self.compliance(), self.poisson_ratio)
    }

    /// Returns the layers and the base, which determine the response of the body to waves.
    pub(crate) fn waves(&self) -> LayerWaves<'_> {
        LayerWaves {
            layers: self.layers(),
            base: if self.youngs_modulus.is_infinite() {
                Base::Rigid
            } else {
                Base::Elastic([self.shear_modulus(), self.poisson_ratio])
            },
        }
    }
}

/// Two half-spaces in contact, described by the relative displacement `u_1 - u_2`.
///
/// The tractions act on body 1, and the opposite tractions act on body 2. The compliances of both bodies are therefore
/// added, and the normal-shear couplings are subtracted.
///
/// ```
/// use stickslip::{ElasticPair, Material};
/// let steel = Material::new(213e9, 0.29)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// assert!((pair.contact_modulus() / 116.27906977e9 - 1.0).abs() < 1e-9);
/// // For equal bodies, G* is G over 2 (2 - nu).
/// let expected = steel.shear_modulus() / (2.0 * 1.71);
/// assert!((pair.tangential_modulus() / expected - 1.0).abs() < 1e-12);
/// assert_eq!(pair.dundurs_beta(), 0.0);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "RawPair")
)]
pub struct ElasticPair {
    bodies: [Material; 2],
    #[cfg_attr(feature = "serde", serde(skip_serializing))]
    compliances: Compliances,
    #[cfg_attr(feature = "serde", serde(skip_serializing))]
    coupling: f64,
    /// Mark of the kernel that the pair represents, if any.
    kernel: Option<KernelMark>,
}

/// Data that distinguish a pair that represents a [`Kernel`](crate::Kernel) from other pairs.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct KernelMark {
    /// Digest of values of the kernel.
    pub(crate) digest: u64,
    /// Equivalent of Dundurs' beta for the waves with the strongest coupling.
    pub(crate) coupling: f64,
}

/// Deserialised values that have not been checked yet.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct RawPair {
    bodies: [Material; 2],
    #[serde(default)]
    kernel: Option<KernelMark>,
}

#[cfg(feature = "serde")]
impl TryFrom<RawPair> for ElasticPair {
    type Error = Error;

    fn try_from(read: RawPair) -> Result<Self> {
        let [body_1, body_2] = read.bodies;
        let pair = Self::new(body_1, body_2)?;
        Ok(read.kernel.map_or(pair, |mark| pair.standing_for(mark)))
    }
}

/// Least ratio of two moduli of a coated body, and of two thicknesses of layers.
const LEAST_PART: f64 = 1e-12;
const LEAST_IS: &str = "the smallest permitted ratio";

/// Returns the smallest and the largest of several positive numbers.
fn extremes(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers.fold([f64::INFINITY, 0.0], |[least, most], number| {
        [least.min(number), most.max(number)]
    })
}

impl ElasticPair {
    /// Creates the pair of `body_1` (into which z points) and `body_2`.
    ///
    /// # Errors
    /// - [`Error::BothRigid`] if neither body deforms.
    /// - [`Error::NotPositive`] or [`Error::NotFinite`] if a combined constant of the pair over- or underflows.
    /// - [`Error::BelowMinimum`] if moduli or thicknesses of layers differ by more than a factor of 1e12.
    pub fn new(body_1: Material, body_2: Material) -> Result<Self> {
        if body_1.is_rigid() && body_2.is_rigid() {
            return Err(Error::BothRigid);
        }
        let (one, two) = (body_1.compliances(), body_2.compliances());
        let mut pair = Self {
            bodies: [body_1, body_2],
            compliances: Compliances {
                normal: one.normal + two.normal,
                lateral: one.lateral + two.lateral,
                coupling: one.coupling - two.coupling,
            },
            coupling: 0.0,
            kernel: None,
        };
        positive("contact modulus of the pair", pair.contact_modulus())?;
        positive("shear modulus of the pair", pair.equivalent_shear_modulus())?;
        positive("tangential modulus of the pair", pair.tangential_modulus())?;
        finite("Dundurs' beta of the pair", pair.dundurs_beta())?;
        pair.check_layers()?;
        pair.coupling = pair.strongest_coupling();
        Ok(pair)
    }

    /// Returns the pair that represents a kernel whose response tends to the response of this pair.
    pub(crate) fn standing_for(self, mark: KernelMark) -> Self {
        Self {
            coupling: mark.coupling,
            kernel: Some(mark),
            ..self
        }
    }

    /// Returns whether the pair represents a [`Kernel`](crate::Kernel) and does not define bodies by itself.
    #[must_use]
    pub fn stands_for_kernel(&self) -> bool {
        self.kernel.is_some()
    }

    /// Returns the mark of the kernel that the pair represents, if any.
    pub(crate) fn kernel(&self) -> Option<KernelMark> {
        self.kernel
    }

    /// Checks that the pair does not represent a kernel.
    pub(crate) fn check_no_kernel(&self) -> Result<()> {
        match self.kernel {
            None => Ok(()),
            Some(_) => Err(Error::IncompleteKernel(
                "the pair represents a kernel; pass the kernel itself",
            )),
        }
    }

    /// Checks that the contrasts of layers are small enough for the integrals over their waves.
    fn check_layers(&self) -> Result<()> {
        for body in self.bodies.iter().filter(|body| body.is_coated()) {
            let base = (!body.youngs_modulus.is_infinite()).then(|| body.shear_modulus());
            let moduli = body.layers().iter().map(Layer::shear_modulus).chain(base);
            let [least, most] = extremes(moduli);
            let quantity = "ratio of the smallest to the largest modulus of a coated body";
            at_least(LEAST_IS, LEAST_PART, quantity, least / most)?;
        }
        let layers = self.bodies.iter().flat_map(Material::layers);
        if !self.is_coated() {
            return Ok(());
        }
        let [least, most] = extremes(layers.map(Layer::thickness));
        let quantity = "ratio of the smallest to the largest thickness of the layers";
        at_least(LEAST_IS, LEAST_PART, quantity, least / most)?;
        Ok(())
    }

    /// Returns the largest ratio of the coupling to the mean of normal and tangential response, over waves of any
    /// length.
    fn strongest_coupling(&self) -> f64 {
        let near = self.dundurs_beta();
        let layers = || self.bodies.iter().flat_map(Material::layers);
        if !self.is_coated() {
            return near;
        }
        let thickest: f64 = layers().map(Layer::thickness).sum();
        let thinnest = layers().map(Layer::thickness).fold(f64::INFINITY, f64::min);
        let (longest, shortest) = (1e-3 / thickest, 20.0 / thinnest);
        let waves = std::iter::successors(Some(longest), |k| Some(k * 0.25_f64.exp2()));
        let waves = waves.take_while(|k| *k < shortest);
        waves.fold(near, |strongest, k| {
            let found = self.times_k(k);
            let ratio = found.coupling / found.normal.sqrt() / found.along.sqrt();
            if ratio.abs() > strongest.abs() {
                ratio
            } else {
                strongest
            }
        })
    }

    /// Returns the response of the relative displacement `u_1 - u_2` to waves of traction of the wave number `k` (one
    /// over a length). For homogeneous bodies the response is given by the constants of the
    /// [`influence`](crate::influence) page divided by k.
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if the wave number is not positive, or if the response over- or underflows at this wave
    ///   number.
    /// - [`Error::NotFinite`] if a coupling overflows.
    /// - [`Error::IncompleteKernel`] if the pair represents a [`Kernel`](crate::Kernel).
    pub fn response(&self, k: f64) -> Result<Response> {
        self.check_no_kernel()?;
        positive("wave number", k)?;
        let response = self.times_k(k).map(|value| value / k);
        positive("response to waves of pressure", response.normal)?;
        positive("response to traction along waves", response.along)?;
        positive("response to traction across waves", response.across)?;
        finite("coupling of pressure and traction", response.coupling)?;
        Ok(response)
    }

    /// Returns the wave number k > 0 times the response to waves of this wave number.
    pub(crate) fn times_k(&self, k: f64) -> Response {
        let [one, two] = self.bodies.each_ref().map(|body| body.waves().times_k(k));
        one.and_second(two)
    }

    /// Returns whether at least one body is coated.
    #[must_use]
    pub fn is_coated(&self) -> bool {
        self.bodies.iter().any(Material::is_coated)
    }

    /// Returns whether both bodies are homogeneous half-spaces.
    pub(crate) fn is_homogeneous(&self) -> bool {
        !self.is_coated() && self.kernel.is_none()
    }

    /// Checks that both bodies are homogeneous, for a quantity that is not available for other bodies.
    pub(crate) fn check_homogeneous(
        &self,
        quantity: &'static str,
        remedy: &'static str,
    ) -> Result<()> {
        if self.is_homogeneous() {
            Ok(())
        } else {
            let bodies = if self.kernel.is_some() {
                "kernels"
            } else {
                "coated bodies"
            };
            Err(Error::UnsupportedForCoatings {
                quantity,
                bodies,
                remedy,
            })
        }
    }

    /// Checks that both bodies are homogeneous, as a closed form requires.
    pub(crate) fn check_closed_form(&self) -> Result<()> {
        let remedy = "solve the contact on a grid";
        self.check_homogeneous("a closed form with one modulus", remedy)
    }

    /// Returns the smaller of the stated hardnesses (a pressure), or infinity if none is stated.
    #[must_use]
    pub fn hardness(&self) -> f64 {
        self.bodies[0].hardness.min(self.bodies[1].hardness)
    }

    /// Returns the two bodies.
    #[must_use]
    pub fn bodies(&self) -> [Material; 2] {
        self.bodies
    }

    /// Returns the contact modulus `E*` of Johnson, `1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2` (a pressure). For one
    /// body on a rigid body, it is the plane-strain modulus. For coated bodies this modulus and the other scalar
    /// constants of the pair are the values for the outermost layers (see [`response`](Self::response)).
    #[must_use]
    pub fn contact_modulus(&self) -> f64 {
        2.0 / self.compliances.normal
    }

    /// Returns the tangential modulus `G*` (a pressure), with `1/G* = (2 - nu_1)/G_1 + (2 - nu_2)/G_2`. It is the
    /// modulus in the stiffness `8 G* a` of Johnson and Mindlin for a sticking circular contact of radius `a`.
    #[must_use]
    pub fn tangential_modulus(&self) -> f64 {
        1.0 / (2.0 * self.compliances.normal + self.compliances.lateral)
    }

    /// Returns the shear modulus of a single body that is as compliant as both bodies together, `1/G = 1/G_1 + 1/G_2` (a
    /// pressure); see [`tangential_modulus`](Self::tangential_modulus) for `G*`. For two bodies of the same material it is
    /// half of their modulus.
    #[must_use]
    pub fn equivalent_shear_modulus(&self) -> f64 {
        1.0 / (self.compliances.normal + self.compliances.lateral)
    }

    /// Returns Poisson's ratio of a single body that is as compliant as both bodies together, `nu = G (nu_1/G_1 + nu_2/G_2)`.
    #[must_use]
    pub fn equivalent_poisson_ratio(&self) -> f64 {
        self.compliances.lateral * self.equivalent_shear_modulus()
    }

    /// Returns Dundurs' second parameter `beta`, the strength of the coupling between pressure and traction.
    ///
    /// `beta = ((1-2 nu_1)/G_1 - (1-2 nu_2)/G_2) / (2 ((1-nu_1)/G_1 + (1-nu_2)/G_2))`. It vanishes for identical bodies, for two
    /// incompressible bodies, and for an incompressible body on a rigid body. A positive value means that pressure draws the
    /// surface of body 1 inwards over the surface of body 2. Johnson (1985), section 5.1, uses the same sign. Texts on interface
    /// cracks often use the opposite sign. The magnitude of beta is at most 1/2 if no Poisson's ratio is negative. It is below
    /// 3/4 for auxetic bodies (2/3 for a body with Poisson's ratio -1/2 on a rigid body).
    #[must_use]
    pub fn dundurs_beta(&self) -> f64 {
        0.5 * self.compliances.coupling / self.compliances.normal
    }

    /// Returns whether pressure moves the surfaces tangentially and shear moves them normally. The bodies are coupled if
    /// [`dundurs_beta`](Self::dundurs_beta) exceeds 1e-12 in magnitude. For coated bodies the ratio $`C_c/\sqrt{C_n C_l}`$ of
    /// their [response](Self::response) must exceed this limit for waves of some length.
    #[must_use]
    pub fn is_coupled(&self) -> bool {
        self.coupling.abs() > UNCOUPLED
    }

    /// Returns Dundurs' beta, or, for coated bodies, its equivalent for the most strongly coupled waves.
    pub(crate) fn coupling_strength(&self) -> f64 {
        self.coupling
    }

    /// Returns the sums that the influence coefficients of the pair require.
    pub(crate) fn compliances(&self) -> Compliances {
        self.compliances
    }
}

/// Elastic constants for the influence coefficients, each per pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Compliances {
    /// `(1 - nu)/G`, summed over the bodies.
    pub(crate) normal: f64,
    /// `nu/G`, summed over the bodies.
    pub(crate) lateral: f64,
    /// `(1 - 2 nu)/G`, body 1 minus body 2.
    pub(crate) coupling: f64,
}

impl Compliances {
    /// Returns the constants of one body with the given reciprocal shear modulus.
    fn new(compliance: f64, poisson_ratio: f64) -> Self {
        Self {
            normal: (1.0 - poisson_ratio) * compliance,
            lateral: poisson_ratio * compliance,
            coupling: (1.0 - 2.0 * poisson_ratio) * compliance,
        }
    }
}
