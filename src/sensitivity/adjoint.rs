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
use crate::numerics::cell_vector::{at, dot, minus, plus, slices, update_cells};
use crate::numerics::small_matrix::Small;
use crate::sensitivity::functional::entry;
use crate::stiffness::System;

/// Returns whether all components are zero.
pub(super) fn is_zero<const N: usize>(vector: [f64; N]) -> bool {
    vector.into_iter().all(|part| part == 0.0)
}

/// Multipliers of the displacements of all cells and of the sums of the tractions.
pub(super) struct Multipliers<const N: usize> {
    pub(super) cells: [Vec<f64>; N],
    pub(super) sums: [f64; N],
    /// Derivatives with respect to the prescribed sums, the prescribed motions or the far ends of springs.
    pub(super) loads: [f64; N],
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

    /// Computes the multipliers of a functional with these derivatives with respect to the tractions, the slips and the motions.
    /// The slip of a cell is its displacement minus its motion.
    ///
    /// # Errors
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the sums do not determine the motions.
    /// - The errors of [`System::tractions`].
    pub(super) fn multipliers(
        &mut self,
        weights: impl Fn(usize) -> [f64; N] + Sync,
        slip: impl Fn(usize) -> [f64; N] + Sync,
        motion: [f64; N],
        context: &mut ResponseContext<'_>,
    ) -> Result<Multipliers<N>> {
        let layout = self.system.response.layout.clone();
        let mut by_slip = [const { Vec::new() }; N];
        if reduce::any(&layout, |cell| !is_zero(slip(cell))) {
            by_slip = self.whole_displacement(&slip, context)?;
        }
        let slipped: [f64; N] = reduce::sum(&layout, &slip);
        let motion = minus(motion, slipped);
        let total = |cell: usize| {
            let by_slip = std::array::from_fn(|c| entry(&by_slip[c], cell));
            plus(weights(cell), 1.0, by_slip)
        };
        let mut cells = self.response(total, context)?;
        let sums = plus(motion, 1.0, self.sums(&cells));
        let is_free = self.totals.map(|total| total != Total::Free);
        let sums = self.matrix.solve(sums, is_free);
        let mut loads = motion;
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
        for (c, multiplier) in self.sums(&cells).into_iter().enumerate() {
            match self.totals[c] {
                Total::Free => loads[c] += multiplier,
                Total::Sum(_) => loads[c] = sums[c],
                Total::Spring { compliance, .. } => loads[c] = sums[c] / compliance,
            }
        }
        update_cells(&mut cells, |cell, multiplier| minus(multiplier, slip(cell)));
        Ok(Multipliers { cells, sums, loads })
    }

    /// Computes the displacement of the cells under these tractions, including the displacement due to their own compliance, with
    /// the transposed system.
    fn whole_displacement(
        &mut self,
        tractions: impl Fn(usize) -> [f64; N] + Sync,
        context: &mut ResponseContext<'_>,
    ) -> Result<[Vec<f64>; N]> {
        let mut displacement = self.displacement(&tractions, context)?;
        let system = &*self.system;
        update_cells(&mut displacement, |cell, u| {
            system.with_own_displacement(u, cell, tractions(cell))
        });
        Ok(displacement)
    }

    /// Computes the displacement that the operator gives under these tractions.
    pub(super) fn displacement(
        &mut self,
        tractions: impl Fn(usize) -> [f64; N] + Sync,
        context: &mut ResponseContext<'_>,
    ) -> Result<[Vec<f64>; N]> {
        let system = &mut *self.system;
        update_cells(&mut system.forced, |cell, _| tractions(cell));
        system.displace(context)?;
        fallible::try_each(|c| fallible::copied(&system.displacement[c]))
    }

    /// Computes the derivative with respect to the friction limit of each cell. A limit imposes a traction along `direction`,
    /// which is zero in cells that do not slip. `weights` are the derivatives with respect to the tractions.
    pub(super) fn by_limit(
        &mut self,
        found: &Multipliers<N>,
        weights: impl Fn(usize) -> [f64; N] + Sync,
        direction: impl Fn(usize) -> [f64; N] + Sync,
        context: &mut ResponseContext<'_>,
    ) -> Result<Vec<f64>> {
        let multipliers = slices(&found.cells);
        let imposed = self.whole_displacement(|cell| at(&multipliers, cell), context)?;
        let imposed = slices(&imposed);
        let by_limit = |cell: usize| {
            let resisted = plus(at(&imposed, cell), 1.0, found.sums);
            dot(direction(cell), minus(weights(cell), resisted))
        };
        let cells = self.system.response.layout.cells();
        fallible::collected(cells, (0..cells).map(by_limit))
    }

    /// Solves the transposed problem. Zero weights need no solve.
    fn response(
        &mut self,
        weights: impl Fn(usize) -> [f64; N] + Sync,
        context: &mut ResponseContext<'_>,
    ) -> Result<[Vec<f64>; N]> {
        let layout = &self.system.response.layout;
        if !reduce::any(layout, |cell| !is_zero(weights(cell))) {
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
}
