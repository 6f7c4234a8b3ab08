//! The meaning of the value that a cell has of a pressure or a traction.

/// The meaning of the pressure and of the traction of a cell: what is assumed between the values of cells.
///
/// The influence coefficients C of [uniformly loaded cells](crate::influence) smooth a traction: a wave of wave number k is
/// displaced $`1 - h^2 k^2/24`$ times as far as the wave whose values it has at the centres, h the side of a cell. A
/// pressure found with them is therefore wrong by $`h^2 \Delta p/24`$ inside a contact, and by the root of $`h^3`$ at its
/// edge. The coefficients of [`CellValue::Centre`] have that factor taken off, by a stencil over neighbouring distances,
///
/// ```math
/// C'(i, j) = C(i, j) + \frac{4\,C(i, j) - C(i - 1, j) - C(i + 1, j) - C(i, j - 1) - C(i, j + 1)}{24},
/// ```
///
/// for all components and any sides of the cells. They cost nothing in a product. On the sphere of the front page, 128 x
/// 128 cells on three contact radii, the pressure of all cells but those at the edge is then right to a sixth of the error.
///
/// Of dissimilar bodies it brings less, the less the larger Dundurs' beta is, and the raw tractions become worse from 0.5 up.
/// Elastic spheres on a rigid plane, pressed and dragged by 40 % of the sliding force at once, mu = 0.3, 64 x 64 cells on three
/// contact radii against 320 x 320, with centre values over uniform cells:
///
/// | error of | beta 0 | 0.1 | 0.29 | 0.375 | 0.5 | 0.67 |
/// |---|---|---|---|---|---|---|
/// | pressure of the cells | 0.75 | 0.83 | 0.87 | 0.88 | 0.98 | 0.97 |
/// | pressure with [`edges`](crate::edges) | 0.30 | 0.43 | 0.66 | 0.78 | 0.80 | 0.76 |
/// | traction of the cells | 0.88 | 0.86 | 0.90 | 0.91 | 1.05 | 1.09 |
/// | its magnitude with edges | 0.51 | 0.52 | 0.74 | 0.83 | 0.96 | 0.79 |
///
/// | of a pressure p of centre values | is |
/// |---|---|
/// | force, moments | the sums of cells times their area: those of $`p - \Delta_h p/24`$, the uniform cells that displace the surface as p does ($`\Delta_h`$ the sum of four neighbours less four times the cell, zero beyond a free edge), where the outermost cells of a free grid carry nothing |
/// | elastic energy | $`\tfrac A2 \sum p\,u`$ with displacements at the centres, the form that is minimised |
/// | stresses below the surface | those of the uniform cells $`p - \Delta_h p/24`$, in a ring around the contact too |
/// | friction limit, slip, dissipated energy, wear | those at the centres |
///
/// C' is positive definite where C is. On the torus of a product the stencil multiplies the symbol by
/// $`1 + (4 - 2 \cos \theta_x - 2 \cos \theta_y)/24`$, between 1 and 4/3, $`\theta`$ the phase from one cell to the next. Any
/// tractions t of a grid without images have therefore $`t' C t \le t' C' t \le \tfrac43\,t' C t`$, and the eigenvalues of C'
/// lie between the least of C and 4/3 of its greatest. The bounds that an operator reports are the eigenvalues of its own
/// periodic continuation, of which the grid is a part, as for C: the [certificate](crate::cgm) holds without change.
///
/// The remedy is that of a corrected trapezoidal rule for 1/r. It is not among those of the paper, and not the default:
/// answers of uniform cells compare to the last digit with those of the paper and of CONTACT.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum CellValue {
    /// The traction is uniform over each cell (default): the piecewise constant elements of Love and of the paper.
    #[default]
    Uniform,
    /// The value is that at the centre of the cell, of a traction that is smooth between the centres.
    Centre,
}
