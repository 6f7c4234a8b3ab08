//! Displacements and stresses below a uniformly loaded rectangle on an elastic half-space.
//!
//! The body is the half-space `z >= 0`. The rectangle `|x| < a`, `|y| < b` of its surface carries a uniform traction. The
//! pressure `p` acts along `+z`, and the tractions `qx` and `qy` act on the body along `+x` and `+y`. Stresses are positive in
//! tension, so `szz = -p`, `sxz = -qx` and `syz = -qy` under the load. Displacements vanish at infinity.
//!
//! # Formulas
//!
//! Let `X = x - xi`, `Y = y - eta` and `r^2 = X^2 + Y^2 + z^2`. Boussinesq's and Cerruti's solutions follow from three harmonic
//! potentials, integrated over the rectangle. Each potential is the z derivative of the next potential:
//!
//! ```math
//! V = \iint \frac{1}{r}, \qquad L = \iint \ln(r + z), \qquad W = \iint [z \ln(r + z) - r], \qquad
//! V = L_z, \quad L = W_z.
//! ```
//!
//! With the shear modulus `G` and Poisson's ratio `nu`, a unit pressure causes the displacements
//!
//! ```math
//! 4 \pi G\,u_x = -(1 - 2\nu) L_x - z V_x, \quad
//! 4 \pi G\,u_y = -(1 - 2\nu) L_y - z V_y, \quad
//! 4 \pi G\,u_z = 2 (1 - \nu) V - z V_z,
//! ```
//!
//! and a unit traction along x
//!
//! ```math
//! 4 \pi G\,u_x = 2 V + 2 \nu W_{xx} - z L_{xx}, \quad
//! 4 \pi G\,u_y = 2 \nu W_{xy} - z L_{xy}, \quad
//! 4 \pi G\,u_z = (1 - 2\nu) L_x - z V_x.
//! ```
//!
//! Hooke's law then gives the stresses. Deep below the cell the stresses are smaller than the derivatives of the potentials in
//! their formulas. The combinations that remain in an incompressible body are therefore integrated as one function, with
//! `X_3 = z`:
//!
//! ```math
//! T_{ijk} = \iint \frac{3 X_i X_j X_k}{r^5}, \qquad \tfrac13 T_{iik} = -V_k.
//! ```
//!
//! Under a unit pressure
//!
//! ```math
//! 2 \pi\,\sigma_{ij} = -T_{ijz} + (1 - 2\nu)
//! \begin{pmatrix} L_{yy} & -L_{xy} & 0 \\ -L_{xy} & L_{xx} & 0 \\ 0 & 0 & 0 \end{pmatrix}_{ij}, \qquad
//! L_{xx} + L_{yy} = -V_z,
//! ```
//!
//! and under a unit traction along x
//!
//! ```math
//! 2 \pi\,\sigma_{ij} = -T_{ijx} + (1 - 2\nu)
//! \begin{pmatrix} W_{xyy} & -W_{xxy} & 0 \\ -W_{xxy} & W_{xxx} & 0 \\ 0 & 0 & 0 \end{pmatrix}_{ij}, \qquad
//! W_{xxx} + W_{xyy} = -V_x;
//! ```
//!
//! A traction along y acts like a traction along x with the axes exchanged. The result is a combination of the 19 functions of
//! [`PotentialIntegral`]. These depend on the cell and the point but not on `nu`. [`Weights`] contains the factors of the
//! components.
//!
//! Let the corners be `(X, Y, s) = (x+a, y+b, +), (x-a, y+b, -), (x+a, y-b, -), (x-a, y-b, +)`, at the distances `r`. With
//! `rho_X^2 = X^2 + z^2` and `rho_Y^2 = Y^2 + z^2`,
//!
//! ```math
//! V_x = \sum s \operatorname{asinh} \frac{Y}{\rho_X}, \quad
//! V_z = -\sum s \arctan \frac{X Y}{z r}, \quad
//! L_{xx} = \sum s\,\theta_x, \quad \theta_x = \arctan \frac{X Y}{\rho_X^2 + z r}, \quad
//! L_{xy} = \sum s \ln(r + z),
//! ```
//! ```math
//! V = \sum s \left[X \operatorname{asinh} \frac{Y}{\rho_X} + Y \operatorname{asinh} \frac{X}{\rho_Y}\right]
//!   + z V_z, \quad
//! L_x = \sum s\,[Y \ln(r + z) + X \theta_x] + z V_x,
//! ```
//! ```math
//! W_{xx} = z L_{xx} - \sum s\,X \operatorname{asinh} \frac{Y}{\rho_X}, \quad
//! W_{xy} = z L_{xy} - \sum s\,r, \quad
//! W_{xyy} = -\sum s \frac{Y}{r + z},
//! ```
//! ```math
//! T_{xxx} = -2 V_x - \sum s \frac{X^2 Y}{r \rho_X^2}, \quad
//! T_{xyy} = -V_x + \sum s \frac{Y}{r}, \quad
//! T_{xzz} = -\sum s \frac{z^2 Y}{r \rho_X^2}, \quad
//! T_{xyz} = \sum s \frac{z}{r},
//! ```
//! ```math
//! T_{xxz} = -V_z - \sum s \frac{z X Y}{r \rho_X^2}, \quad
//! T_{zzz} = -V_z + \sum s \frac{z X Y}{r} \left[\frac{1}{\rho_X^2} + \frac{1}{\rho_Y^2}\right],
//! ```
//!
//! and the same functions with x and y exchanged. Near the cell the functions are evaluated in closed form, as differences
//! between the two ends of an edge. This form has no cancellation next to an edge, on the extension of an edge or at small depth.
//! Far from the cell the integrands are integrated by Gauss-Legendre quadrature. A slender cell is divided into pieces.
//!
//! # On the surface
//!
//! The values at `z = 0` are the limits from inside the body. If the limits from the two sides of an edge differ, the value is
//! their mean. At a corner the value is the mean over the four quadrants. A stress may be logarithmically infinite at an edge or
//! a corner. Its finite part is then returned: inside the logarithm, the longer half side of the cell replaces the zero distance.
//! In a sum over equal cells with equal tractions these logarithms cancel, as required.
//!
//! # Accuracy
//!
//! Errors are relative to the largest displacement, or the largest stress, at the same point under the same load. They are about
//! 1e-15, and at most 1e-14, at any position and depth. The errors of slender cells are larger on the surface next to the middle
//! of a long edge. The largest stress is small at such a point, because the pressure on an infinite strip would cause no stress.
//! The error is then about 1e-16 times the ratio of the sides.
//!
//! # Sources
//!
//! - A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377, <https://doi.org/10.1098/rsta.1929.0009>.
//! - N. Ahmadi, L. M. Keer, T. Mura, Int. J. Solids Struct. 19 (1983) 357.
//! - J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990).
//! - K. L. Johnson, Contact Mechanics (1985), section 3.1.

mod cell;
mod edge;
mod far;
mod integral;
mod near;
mod piece;
mod point_force;
mod rectangle;
#[cfg(test)]
mod tests;
mod weights;

pub(crate) use integral::PotentialIntegral;
pub(crate) use point_force::{PointForceSums, add_point_forces, totals};
pub(crate) use rectangle::LoadedRectangle;
pub(crate) use weights::{FieldComponent, Load, Weights};
