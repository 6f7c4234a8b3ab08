//! Influence coefficients: displacements of a half-space under a uniformly loaded rectangle.
//!
//! A cell of sides `2a x 2b` centred on the origin carries a uniform traction. The coefficient `C_ij(x, y)` is the displacement
//! component `i` at the surface point `(x, y)` per unit traction component `j` (a length over a pressure). Traction and
//! displacement refer to body 1, with z into the body. Pressure is positive if it pushes into the body.
//!
//! Let the corners be `(X, Y, s) = (x+a, y+b, +), (x-a, y+b, -), (x+a, y-b, -), (x-a, y-b, +)`, with `R = hypot(X, Y)`. The five
//! integrals of the Boussinesq and Cerruti kernels over the cell are
//!
//! ```math
//! S_X = \sum s\,X \operatorname{asinh}(Y/|X|), \quad
//! S_Y = \sum s\,Y \operatorname{asinh}(X/|Y|), \quad
//! S_{XY} = -\sum s\,R,
//! ```
//! ```math
//! D_X = \sum s\,[Y \ln R + X \arctan(Y/X)], \quad
//! D_Y = \sum s\,[X \ln R + Y \arctan(X/Y)],
//! ```
//!
//! and one body of shear modulus `G` and Poisson's ratio `nu` has
//!
//! ```math
//! C_{xx} = \frac{(1-\nu) S_X + S_Y}{2 \pi G}, \quad
//! C_{yy} = \frac{S_X + (1-\nu) S_Y}{2 \pi G}, \quad
//! C_{zz} = \frac{(1-\nu)(S_X + S_Y)}{2 \pi G}, \quad
//! C_{xy} = C_{yx} = \frac{\nu\,S_{XY}}{2 \pi G},
//! ```
//! ```math
//! C_{zx} = -C_{xz} = \frac{(1-2\nu) D_X}{4 \pi G}, \quad
//! C_{zy} = -C_{yz} = \frac{(1-2\nu) D_Y}{4 \pi G}.
//! ```
//!
//! On a periodic grid a wave of traction with the wave vector `k` causes a wave of displacement. The ratio of their amplitudes is
//! the symbol. It is the Fourier transform of the displacement under a point force, not averaged over cells:
//!
//! ```math
//! \hat C_{xx} = \frac{1 - \nu k_x^2/k^2}{G k}, \quad
//! \hat C_{yy} = \frac{1 - \nu k_y^2/k^2}{G k}, \quad
//! \hat C_{zz} = \frac{1 - \nu}{G k}, \quad
//! \hat C_{xy} = -\frac{\nu k_x k_y}{G k^3}, \quad
//! \hat C_{zx} = -\hat C_{xz} = -\mathrm{i}\,\frac{(1 - 2\nu) k_x}{2 G k^2},
//! ```
//!
//! and correspondingly for `zy` and `yz`. The symbol of wave number zero, a mean traction, is undefined and set to zero.
//!
//! On a grid that is periodic along y alone, the integrals are summed over all images of the cell along y. A line of cells is
//! uniform along y. Its coefficients are integrals over a strip of half width a, relative to the datum d (Johnson 1985, sections
//! 2.2 and 2.3). Constant terms of $`S_X`$ and $`S_Y`$ are omitted, because they only displace the body as a whole:
//!
//! ```math
//! S_X + S_Y = -2 \int_{-a}^{a} \ln\frac{|x - s|}{d}\,\mathrm{d}s, \quad S_Y = S_{XY} = D_Y = 0, \quad
//! D_X = \pi \int_{-a}^{a} \operatorname{sgn}(x - s)\,\mathrm{d}s .
//! ```
//!
//! The coefficients of [coated](crate::layers) bodies are the sum of two terms. The first term consists of these coefficients
//! with the constants of the outermost layers. The second term is the correction described in [`layers`](crate::layers). The
//! symbols of coated bodies follow from the responses described on the same page.
//!
//! Source: Appendix A of Wang, De Boer, Neville & Ghanbarzadeh, Tribology International 159 (2021) 106947. Three printed errors
//! are corrected. In `C_xx`, `C_yy` and `C_zz` the numerator of the second logarithm is `(x+a) + hypot(x+a, y+b)`. The stray
//! terms before the third logarithm are omitted. The third term of `C_xx` has the factor `(1 - nu)(x - a)`.

mod coefficient;
mod far_field;
pub(crate) mod hankel;
mod inhomogeneous;
mod integrals;
mod lattice_bound;
mod layered;
pub(crate) mod periodic_images;
mod rectangle;
mod samples;
mod symbols;
mod table;

pub use crate::bodies::component::{Component, Direction};
pub(crate) use coefficient::InfluenceKernel;
pub(crate) use inhomogeneous::KernelCorrection;
pub(crate) use lattice_bound::least_of_lattice;
pub(crate) use layered::{LayerCorrection, slowest};
pub use rectangle::{Rectangle, Tensor};
pub(crate) use samples::Samples;
pub(crate) use symbols::Symbols;
pub use table::Table;

use crate::bodies::material::Compliances;
use integrals::Integral;

impl Component {
    /// Returns the integrals and their weights. The coefficient is the weighted sum divided by `2 pi`.
    fn parts(self, c: Compliances) -> impl Iterator<Item = (f64, Integral)> {
        let alone = |weight, integral| [Some((weight, integral)), None];
        let parts = match self {
            // C_xx is (1 - nu) (S_X + S_Y) + nu S_Y, where S_X + S_Y is the potential.
            Self::XX => [
                Some((c.normal, Integral::Potential)),
                Some((c.lateral, Integral::AlongX)),
            ],
            Self::YY => [
                Some((c.normal + c.lateral, Integral::Potential)),
                Some((-c.lateral, Integral::AlongX)),
            ],
            Self::ZZ => alone(c.normal, Integral::Potential),
            Self::XY | Self::YX => alone(c.lateral, Integral::Diagonal),
            Self::XZ => alone(-0.5 * c.coupling, Integral::RadialX),
            Self::ZX => alone(0.5 * c.coupling, Integral::RadialX),
            Self::YZ => alone(-0.5 * c.coupling, Integral::RadialY),
            Self::ZY => alone(0.5 * c.coupling, Integral::RadialY),
        };
        parts.into_iter().flatten()
    }
}
