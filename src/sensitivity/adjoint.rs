//! Adjoint of the linear problem at fixed sets.
//!
//! The unknowns v of the moving cells and the free motions $`\delta_c`$ satisfy
//!
//! ```math
//! A\,dv - \sum_c R e_c\,d\delta_c = R\,dr, \qquad e_c' E\,dv + d_c\,d\delta_c = d\varrho_c .
//! ```
//!
//! E extends unknowns to tractions and R restricts displacements to equations. The vector $`e_c`$ is one in component c of all
//! cells. The compliance of a spring is $`1/d_c`$, and $`d_c = 0`$ under a prescribed sum. A functional has the derivatives w
//! with respect to the tractions and $`s_c`$ with respect to the motions. With the multipliers $`\Lambda = R' \lambda`$ of the
//! displacements and $`\nu`$ of the sums,
//!
//! ```math
//! dJ = \Lambda \cdot dr + \nu \cdot d\varrho, \qquad
//! A' \lambda = E' \Bigl(w - \sum_c e_c \nu_c\Bigr), \qquad -e_c' \Lambda + d_c \nu_c = s_c .
//! ```
//!
//! The unit responses $`z_c = A'^{-1} E' e_c`$ do not depend on the functional. They are computed once for all functionals.

use crate::cgm::{Row, Total, reduce};
use crate::contact::ResponseContext;
use crate::error::{Result, finite};
use crate::memory::fallible;
use crate::numerics::cell_vector::{at, slices};
use crate::numerics::small_matrix::Small;
use crate::stiffness::System;

/// Multipliers of the displacements of all cells and of the sums of the tractions.
pub(super) struct Multipliers<const N: usize> {
    pub(super) cells: [Vec<f64>; N],
    pub(super) sums: [f64; N],
}

/// System of the transposed problem, whose rows have been set, with its unit responses.
pub(super) struct Adjoint<'s, R, const N: usize> {
    pub(super) system: &'s mut System<R, N>,
    pub(super) totals: [Total; N],
    /// Multipliers per unit of each sum.
    unit: [[Vec<f64>; N]; N],
    /// Sums of the unit responses, including the springs.
    matrix: Small<N>,
}

impl<'s, R: Row<N>, const N: usize> Adjoint<'s, R, N> {
    /// Computes the unit responses of the motions that follow from these totals.
    pub(super) fn new(
        system: &'s mut System<R, N>,
        totals: [Total; N],
        context: &mut ResponseContext<'_>,
    ) -> Result<Self> {
        let mut adjoint = Self {
            system,
            totals,
            unit: std::array::from_fn(|_| [const { Vec::new() }; N]),
            matrix: Small([[0.0; N]; N]),
        };
        for c in 0..N {
            let added = match totals[c] {
                Total::Free => continue,
                Total::Sum(_) => 0.0,
                Total::Spring { compliance, .. } => compliance.recip(),
            };
            let mut unit = [0.0; N];
            unit[c] = 1.0;
            adjoint.unit[c] = adjoint.response(|_| unit, context)?;
            let sums = adjoint.sums(&adjoint.unit[c]);
            for (row, sum) in adjoint.matrix.0.iter_mut().zip(sums) {
                row[c] = sum;
            }
            adjoint.matrix.0[c][c] += added;
        }
        Ok(adjoint)
    }

    /// Computes the multipliers of a functional with these derivatives with respect to the tractions and the motions.
    ///
    /// # Errors
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the sums do not determine the motions.
    /// - The errors of [`System::tractions`].
    pub(super) fn multipliers(
        &mut self,
        weights: impl Fn(usize) -> [f64; N] + Sync,
        motion: [f64; N],
        context: &mut ResponseContext<'_>,
    ) -> Result<Multipliers<N>> {
        let mut cells = self.response(weights, context)?;
        let sums = self.sums(&cells);
        let right = std::array::from_fn(|c| motion[c] + sums[c]);
        let sums = self
            .matrix
            .solve(right, self.totals.map(|total| total != Total::Free));
        for (sum, unit) in sums.iter().zip(&self.unit).filter(|(sum, _)| **sum != 0.0) {
            finite(
                "derivative with respect to a force that the contact cannot resist",
                *sum,
            )?;
            for (part, unit) in cells.iter_mut().zip(unit) {
                for (value, unit) in part.iter_mut().zip(unit) {
                    *value -= sum * unit;
                }
            }
        }
        Ok(Multipliers { cells, sums })
    }

    /// Solves the transposed problem. Zero weights need no solve.
    fn response(
        &mut self,
        weights: impl Fn(usize) -> [f64; N] + Sync,
        context: &mut ResponseContext<'_>,
    ) -> Result<[Vec<f64>; N]> {
        let layout = &self.system.response.layout;
        if !reduce::any(layout, |cell| weights(cell) != [0.0; N]) {
            context.finish_at_once();
            return fallible::vector(layout.cells());
        }
        let found = self.system.tractions(weights, context)?;
        fallible::try_each(|c| fallible::copied(found[c]))
    }

    fn sums(&self, cells: &[Vec<f64>; N]) -> [f64; N] {
        let cells = slices(cells);
        reduce::sum(&self.system.response.layout, |cell| at(&cells, cell))
    }

    /// Returns the derivative with respect to each prescribed sum (of tractions), motion or far end of a spring.
    pub(super) fn by_load(&self, found: &Multipliers<N>, motion: [f64; N]) -> [f64; N] {
        let sums = self.sums(&found.cells);
        std::array::from_fn(|c| match self.totals[c] {
            Total::Free => motion[c] + sums[c],
            Total::Sum(_) => found.sums[c],
            Total::Spring { compliance, .. } => found.sums[c] / compliance,
        })
    }
}
