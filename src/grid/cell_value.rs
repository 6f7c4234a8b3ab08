//! Interpretation of the pressure and traction values of cells.

/// Interpretation of the pressure and traction values of cells, which is the assumed variation between these values.
///
/// The influence coefficients C of [uniformly loaded cells](crate::influence) smooth a traction. Consider a wave of wave
/// number k on cells with the side h. The coefficients give $`1 - h^2 k^2/24`$ times the displacement of the wave with
/// the same values at the centres. The error of a pressure computed with these coefficients is therefore
/// $`h^2 \Delta p/24`$ inside a contact. At the edge it is of the order of the square root of $`h^3`$. The coefficients
/// of [`CellValue::Centre`] remove this factor with a stencil over neighbouring distances,
///
/// ```math
/// C'(i, j) = C(i, j) + \frac{4\,C(i, j) - C(i - 1, j) - C(i + 1, j) - C(i, j - 1) - C(i, j + 1)}{24},
/// ```
///
/// for all components and any sides of the cells. The cost of a product does not change. The sphere of the front page has
/// 128 x 128 cells on three contact radii. At the centres of cells more than one cell side from the edge, its pressure
/// error is a seventh of the error with uniform cells.
///
/// For dissimilar bodies the gain is smaller. It decreases as Dundurs' beta increases. For beta of 0.5 or more the
/// tractions of the cells become less accurate. The table lists the error with centre values divided by the error with
/// uniform cells. Elastic spheres on a rigid plane are pressed and simultaneously dragged by 40 % of the sliding force,
/// with mu = 0.3. The grid has 64 x 64 cells on three contact radii. The reference has 320 x 320 cells.
///
/// | error | beta 0 | 0.1 | 0.29 | 0.375 | 0.5 | 0.67 |
/// |---|---|---|---|---|---|---|
/// | pressure of the cells | 0.75 | 0.83 | 0.87 | 0.88 | 0.98 | 0.97 |
/// | pressure with [`edges`](crate::edges) | 0.30 | 0.43 | 0.66 | 0.78 | 0.80 | 0.76 |
/// | traction of the cells | 0.88 | 0.86 | 0.90 | 0.91 | 1.05 | 1.09 |
/// | magnitude of the traction with edges | 0.51 | 0.52 | 0.74 | 0.83 | 0.96 | 0.79 |
///
/// | quantity for a pressure p of centre values | definition |
/// |---|---|
/// | force, moments | the sums over cells times the cell area. If the outermost cells of a free grid carry no pressure, these equal the sums of $`p - \Delta_h p/24`$, the uniform cells that displace the surface as p does. $`\Delta_h`$ is the sum over the four neighbours minus four times the cell, with zero beyond a free edge. |
/// | elastic energy | $`\tfrac A2 \sum p\,u`$ with displacements at the centres, the form that is minimised |
/// | stresses below the surface | the stresses of the uniform cells $`p - \Delta_h p/24`$, including a ring around the contact |
/// | friction limit, slip, dissipated energy, wear | the values at the centres |
///
/// C' is positive definite if C is. Products are computed on a torus, where the stencil multiplies the symbol by
/// $`1 + (4 - 2 \cos \theta_x - 2 \cos \theta_y)/24`$. Here $`\theta`$ is the phase between neighbouring cells, and the factor
/// lies between 1 and 4/3. Therefore any tractions t of a grid without images satisfy
/// $`t' C t \le t' C' t \le \tfrac43\,t' C t`$. The eigenvalues of C' lie between the smallest eigenvalue of C and 4/3 of the
/// largest eigenvalue of C. As for C, an operator reports bounds from the eigenvalues of its periodic continuation, which
/// contains the grid. The [certificate](crate::cgm) thus remains valid without change.
///
/// The stencil is the correction of a corrected trapezoidal rule for 1/r. It is not part of the paper. It is not the default,
/// because results of uniform cells agree to the last digit with the paper and with CONTACT.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum CellValue {
    /// Traction that is uniform over each cell (default), as in the piecewise constant elements of Love and of the paper.
    #[default]
    Uniform,
    /// Traction at the centre of the cell, with a smooth variation between the centres.
    Centre,
}
