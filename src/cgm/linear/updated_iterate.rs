//! Iterate of a semismooth Newton step, updated by the corrections of GMRES.

use std::ops::ControlFlow;

use crate::cgm::active_set_solve::Precision;
use crate::cgm::law::state::Row;
use crate::cgm::linear::Linear;
use crate::cgm::linear::gmres::Equations;
use crate::numerics::cell_vector::{at, minus, plus, slices};
use crate::parallel;
use crate::report::Status;

/// Unknowns, displacements and multipliers of an iterate, and the initial gap. The gap is added to the displacements. The slice
/// of the gap is empty if the displacements already include it.
pub(in crate::cgm) struct UpdatedIterate<'a, 'x, const N: usize> {
    pub(in crate::cgm) x: &'a mut [&'x mut [f64]; N],
    pub(in crate::cgm) displacement: &'a mut [Vec<f64>; N],
    pub(in crate::cgm) gap: [&'a [f64]; N],
    pub(in crate::cgm) multiplier: &'a mut [f64; N],
}

impl<R: Row<N>, const N: usize> Equations<R, N> for UpdatedIterate<'_, '_, N> {
    fn set_residual(&mut self, linear: &mut Linear<'_, '_, R, N>) -> ControlFlow<Status> {
        let (x, u, gap) = (slices(self.x), slices(self.displacement), self.gap);
        let multiplier = *self.multiplier;
        let w = &mut *linear.workspace;
        w.moving.set(&w.rows, &mut w.residual, |_, cell, row: R| {
            let gap = gap.map(|gap| gap.get(cell).copied().unwrap_or(0.0));
            let g = minus(plus(at(&u, cell), 1.0, gap), multiplier);
            let (left, bend) = (row.restrict(g), row.bend(row.restrict(at(&x, cell))));
            std::array::from_fn(|c| -left[c] - bend[c])
        });
        ControlFlow::Continue(())
    }

    fn advance(
        &mut self,
        linear: &mut Linear<'_, '_, R, N>,
        change: [f64; N],
    ) -> ControlFlow<Status> {
        linear.monitor.proceed()?;
        linear.apply_to_correction(Precision::Single);
        linear.monitor.count_step();
        *self.multiplier = plus(*self.multiplier, 1.0, change);
        let w = &*linear.workspace;
        let add = |target: &mut [f64], source: &[f64]| {
            parallel::update(target, |first, chunk| {
                for (target, source) in chunk.iter_mut().zip(&source[first..]) {
                    *target += source;
                }
            });
        };
        for c in 0..N {
            add(&mut *self.x[c], &w.direction[c]);
            add(&mut self.displacement[c], &w.image[c]);
        }
        ControlFlow::Continue(())
    }
}
