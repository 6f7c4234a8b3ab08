//! A preconditioner that is not positive definite, as the cause of an iteration that has failed.

use crate::cgm::iterate::Run;
use crate::cgm::law::state::Linearised;
use crate::cgm::{Constraint, reduce};
use crate::error::{Error, Result};
use crate::numerics::cell_vector::{at, dot, minus, norm, slices, slices_mut, update_cells};

impl<K: Constraint<N>, const N: usize> Run<'_, '_, K, N> {
    /// `Ok` if `v' M v` is a positive number of a uniform vector, of the residual that is left, and of its largest part, on
    /// the cells that can move.
    pub(super) fn check_preconditioner(&mut self) -> Result<()> {
        let (problem, multiplier) = (self.problem, self.workspace.multiplier);
        let forbidden = |i: usize, x, gradient| {
            let set = problem.constraint.of(i);
            set.forbidden(x, minus(gradient, multiplier))
        };
        let (x, gradient) = (slices(&self.x), slices(&self.workspace.gradient));
        let size = |i: usize| norm(forbidden(i, at(&x, i), at(&gradient, i)));
        let largest = reduce::max(self.layout(), size);
        let mut flaw = self.flaw_along(|_, _, _| [1.0; N]);
        for least in [0.0, 0.5 * largest] {
            flaw = flaw.or_else(|| {
                self.flaw_along(|i, x, gradient| {
                    let residual = forbidden(i, x, gradient);
                    if norm(residual) >= least {
                        residual
                    } else {
                        [0.0; N]
                    }
                })
            });
        }
        flaw.map_or(Ok(()), |value| {
            let quantity = "v'Mv with the preconditioner M of the iteration that failed";
            Err(Error::NotPositive { quantity, value })
        })
    }

    /// `v' M v` of a vector that follows from unknowns and gradient of each cell, if that is not positive but could be.
    fn flaw_along(
        &mut self,
        v: impl Fn(usize, [f64; N], [f64; N]) -> [f64; N] + Sync,
    ) -> Option<f64> {
        let x = slices(&self.x);
        let (problem, w) = (self.problem, &mut *self.workspace);
        let gradient = slices(&w.gradient);
        update_cells(&mut w.linear.direction, |i, _| {
            if problem.constraint.of(i).can_move() {
                v(i, at(&x, i), at(&gradient, i))
            } else {
                [0.0; N]
            }
        });
        let (direction, image) = (slices(&w.linear.direction), slices_mut(&mut w.linear.image));
        (problem.preconditioner).apply(direction, image, &mut w.linear.preconditioner);
        let image = slices(&w.linear.image);
        let [square, product] = reduce::sum(problem.layout, |i| {
            let v = at(&direction, i);
            [dot(v, v), dot(v, at(&image, i))]
        });
        let is_fine = product > 0.0 && product.is_finite();
        (square > 0.0 && square.is_finite() && !is_fine).then_some(product)
    }
}
