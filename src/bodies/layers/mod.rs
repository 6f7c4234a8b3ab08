//! Coated bodies: elastic layers bonded to each other and to a substrate.
//!
//! [`Material::coated`](crate::Material::coated) puts layers on an elastic half-space or on a rigid base. A pair of such bodies
//! is solved like any other pair. It supports pressure, traction, coupled problems, histories, stiffness and rolling, on free
//! grids, on periodic grids and on lines of cells. For homogeneous bodies neither the results nor the cost change.
//!
//! ```
//! use stickslip::layers::Layer;
//! use stickslip::{Boundary, ElasticPair, Field, Grid, HalfSpace, Material, NormalLoad, NormalProblem};
//! // A thin bed of rubber on a rigid base has the stiffness of its oedometric modulus.
//! let bed = Layer::new(1.0, 0.3, 0.02)?;
//! let pair = ElasticPair::new(Material::rigid().coated(&[bed])?, Material::rigid())?;
//! let grid = Grid::square(64, 3.0)?;
//! let bodies = HalfSpace::new(grid, pair)?;
//! let ball = stickslip::surface::sphere(grid, 100.0)?;
//! let contact = NormalProblem::builder(&bodies, &ball, NormalLoad::Approach(0.005)).build()?.solve()?;
//! let oedometric = 0.7 / (1.3 * 0.4);
//! let centre = contact.pressure().max();
//! assert!((centre / (oedometric * 0.005 / 0.02) - 1.0).abs() < 0.01);
//! # Ok::<(), stickslip::Error>(())
//! ```
//!
//! # Frequency responses
//!
//! Four functions of the wavelength ([`Response`]) describe the response of a layered body to a wave of traction with the wave
//! vector k. They are $`C_n`$ ($`u_z`$ from pressure), $`C_l`$ and $`C_t`$ (tangential displacement along and across k) and
//! $`C_c`$ (coupling of pressure and traction along k). With $`c = k_x/k`$ and $`s = k_y/k`$
//!
//! ```math
//! \hat C_{zz} = C_n, \quad \hat C_{xx} = C_l c^2 + C_t s^2, \quad \hat C_{yy} = C_l s^2 + C_t c^2, \quad
//! \hat C_{xy} = (C_l - C_t)\,c s, \quad \hat C_{zx} = -\hat C_{xz} = -\mathrm{i}\,C_c\,c, \quad
//! \hat C_{zy} = -\hat C_{yz} = -\mathrm{i}\,C_c\,s .
//! ```
//!
//! A half-space has $`G k\,(C_n, C_l, C_t, C_c) = (1 - \nu, 1 - \nu, 1, \tfrac12 - \nu)`$. A layer of thickness h maps the five
//! minors $`s (1, n, l, c, nl - c^2)`$ of the surface compliance $`n, l, c`$ (in $`1/Gk`$) linearly. The entries of this map,
//! except those for c, are sums of positive terms. There is no cancellation for any contrast of moduli, any k h and any
//! Poisson's ratio, including 1/2. Across k, the layer changes $`G k C_t`$ from x to $`(x + \tanh kh)/(1 + x \tanh kh)`$.
//! Consider one layer of modulus $`G_1`$ on a base of $`G_2`$. With $`m = G_1/G_2`$, $`a = kh`$, $`t = e^{-2a}`$,
//! $`\lambda = 1 - 4(1-\nu_1)/(1 + m(3 - 4\nu_2))`$ and $`\kappa = (m - 1)/(m + 3 - 4\nu_1)`$, the normal response is
//!
//! ```math
//! C_n = \frac{1-\nu_1}{G_1 k}\;\frac{1 + 4 a \kappa t - \lambda \kappa t^2}{1 - (\lambda + \kappa + 4 \kappa a^2) t + \lambda \kappa t^2} .
//! ```
//!
//! The limits are the substrate for $`k \to 0`$ and the outermost layer for $`k \to \infty`$. On a rigid base
//! $`C_n \to h (1-2\nu)/2G(1-\nu)`$ and $`C_l, C_t \to h/G`$ for $`k \to 0`$, and $`C_n \to k^2 h^3/3G`$ for an incompressible
//! layer. The matrix of $`C_n, C_l, C_c`$ is symmetric (reciprocity) and positive definite at every k (energy). $`C_t`$ is
//! positive.
//!
//! # From waves to cells
//!
//! Let A and B be the constant values of $`k\,C(k)`$ for half-spaces of the outermost layer and of the base, and H
//! twice the thickness of the outermost layer. Then
//!
//! ```math
//! k\,C(k) = A + (B - A)\,e^{-kH} + k R(k) .
//! ```
//!
//! The first part is the closed form of the [influence](crate::influence) page with the constants of the outermost
//! layer. The second part belongs to a force at the depth H. The remainder is smooth and negligible above $`kH = 40`$.
//! Its Hankel integrals are computed with Gauss-Legendre panels and tabulated once per pair as a function of the distance r. The
//! tables are Chebyshev polynomials, in two pieces up to H and in one piece per octave above H. Gauss rules integrate the
//! remainder over a cell, which is subdivided if it is wider than the layer. The response is not sampled on a padded grid in k,
//! so there is no aliasing and no pole at k = 0. Periodic grids use the response itself.
//!
//! # Limits of the model
//!
//! - Layers are bonded, and their surfaces are plane. There are at most [`LIMIT`] layers.
//! - On a [grid periodic along y only](crate::Boundary::PeriodicAlongY), the displacement far from the load equals the
//!   displacement of the substrate with the given datum. On a rigid base it tends to zero. The smallest eigenvalue for
//!   tractions with zero mean certifies the error of a solve on such a grid. If no sum is prescribed, the certificate also requires the
//!   energy of a flat punch. A solve returns [`Error::DatumTooNear`] if the datum is too near for a prescribed approach, shift or
//!   spring.
//! - The error of a solve on a free grid is certified by the smallest eigenvalue of a periodic continuation of the kernel. For
//!   layers stiffer than the bodies below, on grids many thicknesses long, this eigenvalue can be negative although the operator
//!   is positive. One example is an incompressible layer of ten times the modulus of its base, sheared on cells as wide as two
//!   thicknesses. Another example is a layer of 1000 times the modulus of its base, pressed over sixty thicknesses. A
//!   conservative estimate of the smallest eigenvalue of the infinite lattice of the same cells then replaces this eigenvalue.
//!   The estimate is computed from sums over the aliases of waves with selected phases. For coupled problems on such a grid, the
//!   separate problems of pressure and traction have bounds, and the coupled problem has only an estimate and [no
//!   bound](crate::Report).
//! - On a grid that is periodic along both axes a mean pressure and a mean traction cause no displacement. This convention also
//!   applies to a rigid base, where both displacements are finite. For one layer, add $`h (1-2\nu)/2G(1-\nu)`$ times the mean
//!   pressure to the approach, and $`h/G`$ times the mean traction to the shift. Several layers contribute the sum.
//! - [Edges](crate::edges) inside the cells need an outermost layer at least four cells thick.
//! - The law for cells that enter a growing or rolling contact uses the ratio of tangential to normal compliance. This ratio
//!   belongs to waves with a period of two cells, $`k = \pi/h_{max}`$.
//! - Scalar moduli of a pair ([`ElasticPair::contact_modulus`](crate::ElasticPair::contact_modulus), Dundurs' beta) are the
//!   moduli of the outermost layers. These layers determine the response to waves much shorter than the layer thickness. Closed
//!   forms depend only on these moduli and [reject](crate::Error::UnsupportedForCoatings) coated bodies. Stresses [at
//!   points](crate::subsurface::at_points) also reject coated bodies. Stresses on [planes](crate::subsurface::Planes) are
//!   available for coated bodies.
//!
//! Sources: J. W. Dunkin, Bull. Seismol. Soc. Am. 55 (1965) 335 (minors); T. C. O'Sullivan and R. B. King, J. Tribology
//! 110 (1988) 235, <https://doi.org/10.1115/1.3261591> (one layer); T. Nogi and T. Kato, J. Tribology 119 (1997) 493,
//! <https://doi.org/10.1115/1.2833525>.

mod depth;
mod response;

pub(crate) use depth::SubsurfaceResponse;
pub use response::Response;
pub(crate) use response::{Base, LayerWaves};

use std::fmt;

use crate::error::{Error, Result, poisson_ratio as checked_ratio, positive};

/// Largest number of layers of a coating.
pub const LIMIT: usize = 8;

/// Elastic, isotropic layer bonded to the layer or substrate below it.
///
/// ```
/// use stickslip::{Material, layers::Layer};
/// let oxide = Layer::new(380e9, 0.22, 5e-6)?;
/// let anodised = Material::new(70e9, 0.33)?.coated(&[oxide])?;
/// assert_eq!(anodised.layers()[0].thickness(), 5e-6);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "RawLayer")
)]
pub struct Layer {
    youngs_modulus: f64,
    poisson_ratio: f64,
    thickness: f64,
}

/// Deserialised values before their check.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct RawLayer {
    youngs_modulus: f64,
    poisson_ratio: f64,
    thickness: f64,
}

#[cfg(feature = "serde")]
impl TryFrom<RawLayer> for Layer {
    type Error = Error;

    fn try_from(read: RawLayer) -> Result<Self> {
        Self::new(read.youngs_modulus, read.poisson_ratio, read.thickness)
    }
}

impl Layer {
    /// Creates a layer of Young's modulus `youngs_modulus` (a pressure), Poisson's ratio `poisson_ratio` and
    /// `thickness` (a length).
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if the modulus or the thickness is not positive.
    /// - [`Error::PoissonRatio`] if the ratio is out of range.
    pub fn new(youngs_modulus: f64, poisson_ratio: f64, thickness: f64) -> Result<Self> {
        positive("Young's modulus of the layer", youngs_modulus)?;
        checked_ratio(poisson_ratio)?;
        positive("thickness of the layer", thickness)?;
        let layer = Self {
            youngs_modulus,
            poisson_ratio,
            thickness,
        };
        if layer.shear_modulus().is_normal() && (1.0 / layer.shear_modulus()).is_normal() {
            return Ok(layer);
        }
        Err(Error::NotPositive {
            quantity: "the modulus of the layer and its reciprocal",
            value: youngs_modulus,
        })
    }

    /// Creates a part of a body, whose thickness may be zero.
    fn of_shear(modulus: f64, poisson_ratio: f64, thickness: f64) -> Self {
        Self {
            youngs_modulus: 2.0 * (1.0 + poisson_ratio) * modulus,
            poisson_ratio,
            thickness,
        }
    }

    fn of_thickness(self, thickness: f64) -> Self {
        Self { thickness, ..self }
    }

    /// Returns Young's modulus (a pressure).
    #[must_use]
    pub fn youngs_modulus(&self) -> f64 {
        self.youngs_modulus
    }

    /// Returns Poisson's ratio.
    #[must_use]
    pub fn poisson_ratio(&self) -> f64 {
        self.poisson_ratio
    }

    /// Returns the thickness (a length).
    #[must_use]
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// Returns the shear modulus (a pressure).
    #[must_use]
    pub fn shear_modulus(&self) -> f64 {
        self.youngs_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }
}

/// Layers of a body, the outermost first. A homogeneous body has no layers.
#[derive(Clone, Copy)]
pub(crate) struct Coating {
    layers: [Layer; LIMIT],
    count: usize,
}

impl Coating {
    pub(crate) const NONE: Self = Self {
        layers: [Layer {
            youngs_modulus: 1.0,
            poisson_ratio: 0.0,
            thickness: 1.0,
        }; LIMIT],
        count: 0,
    };

    /// Adds layers above the existing layers.
    pub(crate) fn under(self, layers: &[Layer]) -> Result<Self> {
        let found = layers.len() + self.count;
        if found > LIMIT {
            return Err(Error::TooManyLayers {
                found,
                limit: LIMIT,
            });
        }
        let mut all = Self::NONE;
        for (place, layer) in all
            .layers
            .iter_mut()
            .zip(layers.iter().chain(self.layers()))
        {
            *place = *layer;
        }
        all.count = found;
        Ok(all)
    }

    pub(crate) fn layers(&self) -> &[Layer] {
        &self.layers[..self.count]
    }
}

impl PartialEq for Coating {
    fn eq(&self, other: &Self) -> bool {
        self.layers() == other.layers()
    }
}

impl fmt::Debug for Coating {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.layers().fmt(f)
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Coating {
    fn serialize<S: serde::Serializer>(
        &self,
        serializer: S,
    ) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_seq(self.layers())
    }
}
