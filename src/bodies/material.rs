//! Elastic constants of one body and of a pair.

use crate::bodies::layers::{Base, Coating, Layer, LayerWaves, Response};
use crate::error::{
    Error, Result, at_least, finite, poisson_ratio as check_poisson_ratio, positive,
};

/// Dundurs' beta at or below which pressure and traction count as uncoupled.
const UNCOUPLED: f64 = 1e-12;

/// A linear elastic, isotropic half-space, homogeneous or [coated](Self::coated).
///
/// Moduli have the unit of a pressure; Poisson's ratio lies in `(-1, 1/2]`. Those of a coated body are its substrate's.
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
    /// Infinite for a rigid body.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    youngs_modulus: f64,
    poisson_ratio: f64,
    /// Infinite where none is stated.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    hardness: f64,
    #[cfg_attr(feature = "serde", serde(rename = "layers"))]
    coating: Coating,
}

/// The values read, before they are checked.
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
    /// A body of Young's modulus `youngs_modulus` (a pressure) and Poisson's ratio `poisson_ratio`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the modulus, [`Error::PoissonRatio`] for the ratio.
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

    /// A body of shear modulus `shear_modulus` (a pressure) and Poisson's ratio `poisson_ratio`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the modulus, [`Error::PoissonRatio`] for the ratio.
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
                quantity: "the modulus, and its reciprocal,",
                value: modulus,
            })
        }
    }

    /// A body that does not deform.
    #[must_use]
    pub fn rigid() -> Self {
        Self {
            youngs_modulus: f64::INFINITY,
            poisson_ratio: 0.0,
            hardness: f64::INFINITY,
            coating: Coating::NONE,
        }
    }

    /// This body under layers that are bonded to it, the outermost first; over the layers it has, if it is coated
    /// already. On a [rigid](Self::rigid) body it is a bed on a rigid base. What is known of such bodies, and what is
    /// not, is on the page of [`layers`](crate::layers). The moduli of a coated [`Material`] are those of the body below the
    /// layers. A hardness stated before is kept: state that of the coating after.
    ///
    /// ```
    /// use stickslip::{ElasticPair, Material, layers::Layer};
    /// let steel = Material::new(210e9, 0.3)?;
    /// let hard = steel.coated(&[Layer::new(400e9, 0.25, 2e-6)?])?;
    /// let response = |waves_per_metre| ElasticPair::new(hard, Material::rigid())?.response(waves_per_metre);
    /// // LayerWaves long beside the coating see the steel, short ones the coating.
    /// let plane = |modulus: f64, nu: f64| modulus / (1.0 - nu * nu);
    /// assert!((response(1.0)?.normal * 0.5 * plane(210e9, 0.3) - 1.0).abs() < 1e-4);
    /// assert!((response(1e8)?.normal * 0.5e8 * plane(400e9, 0.25) - 1.0).abs() < 1e-12);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::TooManyLayers`] beyond [`layers::LIMIT`](crate::layers::LIMIT).
    pub fn coated(mut self, layers: &[Layer]) -> Result<Self> {
        self.coating = self.coating.under(layers)?;
        Ok(self)
    }

    /// The layers of a coated body, the outermost first; none of a homogeneous one.
    #[must_use]
    pub fn layers(&self) -> &[Layer] {
        self.coating.layers()
    }

    /// Whether the body is coated.
    #[must_use]
    pub fn is_coated(&self) -> bool {
        !self.layers().is_empty()
    }

    /// The strain of the bulk along x under the stress `stress` along x, without strain along y and stress along z:
    /// $`\varepsilon = \sigma (1 - \nu^2)/E`$, positive where it is stretched. A body that is free to contract along y is
    /// strained by $`\sigma/E`$ along x and by $`-\nu\sigma/E`$ along y.
    #[must_use]
    pub fn plane_strain_under(&self, stress: f64) -> f64 {
        stress * (1.0 - self.poisson_ratio * self.poisson_ratio) / self.youngs_modulus
    }

    /// With the hardness it has (a pressure): where an elastic contact presses harder, its solution warns
    /// ([`Warning::BeyondHardness`](crate::Warning::BeyondHardness)). To limit the pressure, give the problem a
    /// [`Hardness`](crate::normal::Hardness).
    ///
    /// # Errors
    /// [`Error::NotPositive`].
    pub fn with_hardness(self, hardness: f64) -> Result<Self> {
        self.stating(positive("hardness", hardness)?)
    }

    /// The same, or none if infinite.
    pub(crate) fn stating(mut self, hardness: f64) -> Result<Self> {
        if hardness != f64::INFINITY {
            positive("hardness", hardness)?;
        }
        self.hardness = hardness;
        Ok(self)
    }

    /// The hardness stated (a pressure); infinite where none is.
    #[must_use]
    pub fn hardness(&self) -> f64 {
        self.hardness
    }

    /// Whether the body does not deform: it is rigid, and not coated.
    #[must_use]
    pub fn is_rigid(&self) -> bool {
        self.youngs_modulus.is_infinite() && !self.is_coated()
    }

    /// Young's modulus `E` (a pressure); infinite for a rigid body.
    #[must_use]
    pub fn youngs_modulus(&self) -> f64 {
        self.youngs_modulus
    }

    /// Shear modulus `G = E / (2 (1 + nu))` (a pressure); infinite for a rigid body.
    #[must_use]
    pub fn shear_modulus(&self) -> f64 {
        1.0 / self.compliance()
    }

    /// Poisson's ratio; zero for a rigid body, where it has no effect.
    #[must_use]
    pub fn poisson_ratio(&self) -> f64 {
        self.poisson_ratio
    }

    /// `1/G`; zero for a rigid body.
    fn compliance(&self) -> f64 {
        2.0 * (1.0 + self.poisson_ratio) / self.youngs_modulus
    }

    /// The three constants that the influence coefficients of short waves need: those of the outermost layer, if any.
    pub(crate) fn compliances(&self) -> Compliances {
        match self.layers() {
            [] => self.base_compliances(),
            [outermost, ..] => {
                Compliances::new(1.0 / outermost.shear_modulus(), outermost.poisson_ratio())
            }
        }
    }

    /// Those of long waves: of what lies below all layers.
    pub(crate) fn base_compliances(&self) -> Compliances {
        Compliances::new(self.compliance(), self.poisson_ratio)
    }

    /// The response of the body to waves.
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
/// The tractions act on body 1 and the opposite shear on body 2. Compliances of like components
/// therefore add, and the normal-shear couplings subtract.
///
/// ```
/// use stickslip::{ElasticPair, Material};
/// let steel = Material::new(213e9, 0.29)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// assert!((pair.contact_modulus() / 116.27906977e9 - 1.0).abs() < 1e-9);
/// // Of equal bodies, G* is G over 2 (2 - nu).
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
    /// Of a pair that stands for a kernel.
    kernel: Option<KernelMark>,
}

/// What tells a pair that stands for a [`Kernel`](crate::Kernel) from others.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct KernelMark {
    /// Of values of the kernel.
    pub(crate) digest: u64,
    /// The like of Dundurs' beta for the waves that couple most.
    pub(crate) coupling: f64,
}

/// The values read, before they are checked.
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
const LEAST_IS: &str = "the least allowed";

/// The least and the largest of some positive numbers.
fn extremes(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers.fold([f64::INFINITY, 0.0], |[least, most], number| {
        [least.min(number), most.max(number)]
    })
}

impl ElasticPair {
    /// The pair of `body_1` (into which z points) and `body_2`.
    ///
    /// # Errors
    /// [`Error::BothRigid`] if neither body deforms; [`Error::NotPositive`] or [`Error::NotFinite`] if a combined
    /// constant of the pair over- or underflows; [`Error::BelowMinimum`] for layers whose moduli or thicknesses differ by more than
    /// a factor of 1e12.
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

    /// The pair that stands for a kernel which tends to it.
    pub(crate) fn standing_for(self, mark: KernelMark) -> Self {
        Self {
            coupling: mark.coupling,
            kernel: Some(mark),
            ..self
        }
    }

    /// Whether the pair stands for a [`Kernel`](crate::Kernel), and describes no bodies by itself.
    #[must_use]
    pub fn stands_for_kernel(&self) -> bool {
        self.kernel.is_some()
    }

    /// The mark of the kernel that the pair stands for, if it does.
    pub(crate) fn kernel(&self) -> Option<KernelMark> {
        self.kernel
    }

    /// `Ok` for a pair that is known without a kernel.
    pub(crate) fn check_no_kernel(&self) -> Result<()> {
        match self.kernel {
            None => Ok(()),
            Some(_) => Err(Error::IncompleteKernel(
                "the pair stands for a kernel: hand over the kernel itself",
            )),
        }
    }

    /// `Ok` if layers differ little enough for the numbers of the integrals over their waves.
    fn check_layers(&self) -> Result<()> {
        for body in self.bodies.iter().filter(|body| body.is_coated()) {
            let base = (!body.youngs_modulus.is_infinite()).then(|| body.shear_modulus());
            let moduli = body.layers().iter().map(Layer::shear_modulus).chain(base);
            let [least, most] = extremes(moduli);
            let quantity = "least over largest modulus of a coated body";
            at_least(LEAST_IS, LEAST_PART, quantity, least / most)?;
        }
        let layers = self.bodies.iter().flat_map(Material::layers);
        if !self.is_coated() {
            return Ok(());
        }
        let [least, most] = extremes(layers.map(Layer::thickness));
        let quantity = "least over largest thickness of the layers";
        at_least(LEAST_IS, LEAST_PART, quantity, least / most)?;
        Ok(())
    }

    /// The largest ratio of the coupling to the mean of normal and tangential response, of waves of any length.
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

    /// The response of the relative displacement `u_1 - u_2` to waves of traction of the wave number `k` (one over a
    /// length); of homogeneous bodies the constants of the [`influence`](crate::influence) page over k.
    ///
    /// # Errors
    /// - [`Error::NotPositive`] for the wave number, and for a response that over- or underflows at this wave number.
    /// - [`Error::NotFinite`] for a coupling that overflows.
    /// - [`Error::IncompleteKernel`] if the pair stands for a [`Kernel`](crate::Kernel).
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

    /// The wave number k > 0 times the response to waves of it.
    pub(crate) fn times_k(&self, k: f64) -> Response {
        let [one, two] = self.bodies.each_ref().map(|body| body.waves().times_k(k));
        one.and_second(two)
    }

    /// Whether a body is coated.
    #[must_use]
    pub fn is_coated(&self) -> bool {
        self.bodies.iter().any(Material::is_coated)
    }

    /// Whether both bodies are homogeneous half-spaces.
    pub(crate) fn is_homogeneous(&self) -> bool {
        !self.is_coated() && self.kernel.is_none()
    }

    /// `Ok` for homogeneous bodies, of what knows no others.
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

    /// The same of a closed form.
    pub(crate) fn check_closed_form(&self) -> Result<()> {
        let remedy = "solve the contact on a grid";
        self.check_homogeneous("a closed form with one modulus", remedy)
    }

    /// Hardness of the softer body (a pressure); infinite where none is stated.
    #[must_use]
    pub fn hardness(&self) -> f64 {
        self.bodies[0].hardness.min(self.bodies[1].hardness)
    }

    /// The two bodies.
    #[must_use]
    pub fn bodies(&self) -> [Material; 2] {
        self.bodies
    }

    /// Contact modulus `E*`, `1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2` (a pressure), Johnson's; for one body on a rigid
    /// one its plane-strain modulus. Of coated bodies, as the constants below, that of the outermost layers; see
    /// [`response`](Self::response).
    #[must_use]
    pub fn contact_modulus(&self) -> f64 {
        2.0 / self.compliances.normal
    }

    /// Tangential modulus `G*`, `1/G* = (2 - nu_1)/G_1 + (2 - nu_2)/G_2` (a pressure), as in Johnson's and Mindlin's
    /// stiffness `8 G* a` of a circular contact of radius `a` that sticks.
    #[must_use]
    pub fn tangential_modulus(&self) -> f64 {
        1.0 / (2.0 * self.compliances.normal + self.compliances.lateral)
    }

    /// Shear modulus of the one body that is as compliant as both, `1/G = 1/G_1 + 1/G_2` (a pressure); see
    /// [`tangential_modulus`](Self::tangential_modulus) for `G*`.
    #[must_use]
    pub fn equivalent_shear_modulus(&self) -> f64 {
        1.0 / (self.compliances.normal + self.compliances.lateral)
    }

    /// Poisson's ratio of the one body that is as compliant as both, `nu = G (nu_1/G_1 + nu_2/G_2)`.
    #[must_use]
    pub fn equivalent_poisson_ratio(&self) -> f64 {
        self.compliances.lateral * self.equivalent_shear_modulus()
    }

    /// Dundurs' second parameter `beta`, the strength of the coupling between pressure and traction.
    ///
    /// `beta = ((1-2 nu_1)/G_1 - (1-2 nu_2)/G_2) / (2 ((1-nu_1)/G_1 + (1-nu_2)/G_2))`. It vanishes
    /// for identical bodies, for two incompressible bodies, and for an incompressible body on a rigid one. Its size is at
    /// most 1/2 where no Poisson's ratio is negative, and below 3/4 for auxetic bodies (2/3 for one of -1/2 on a rigid one).
    #[must_use]
    pub fn dundurs_beta(&self) -> f64 {
        0.5 * self.compliances.coupling / self.compliances.normal
    }

    /// Whether pressure moves the surfaces tangentially and shear moves them normally:
    /// [`dundurs_beta`](Self::dundurs_beta) is more than 1e-12 in size; of coated bodies the ratio
    /// $`C_c/\sqrt{C_n C_l}`$ of their [response](Self::response) is, for waves of some length.
    #[must_use]
    pub fn is_coupled(&self) -> bool {
        self.coupling.abs() > UNCOUPLED
    }

    /// Dundurs' beta; of coated bodies the like of it for the waves that couple most.
    pub(crate) fn coupling_strength(&self) -> f64 {
        self.coupling
    }

    /// The sums that the influence coefficients of the pair need.
    pub(crate) fn compliances(&self) -> Compliances {
        self.compliances
    }
}

/// The elastic constants that the influence coefficients need, each per pressure.
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
    /// Of one body, by one over its modulus of shear.
    fn new(compliance: f64, poisson_ratio: f64) -> Self {
        Self {
            normal: (1.0 - poisson_ratio) * compliance,
            lateral: poisson_ratio * compliance,
            coupling: (1.0 - 2.0 * poisson_ratio) * compliance,
        }
    }
}
