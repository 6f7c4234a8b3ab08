//! How tractions answer motions of the bodies, while each cell goes on to move as it does.

use std::ops::ControlFlow;

use crate::buffer;
use crate::cgm::linear::gmres::Equations;
use crate::cgm::linear::{Border, Linear};
use crate::cgm::motion::Row;
use crate::cgm::run::Precision;
use crate::cgm::vector::{slices, within};
use crate::error::{Error, Result};
use crate::operator::Operator;
use crate::report::Status;

/// Residual of a response, over that without one.
const SOLVED: f64 = 1e-11;
/// Bases after which a response counts as not found.
const BASES: usize = 100;

/// A motion of the cells, and the unknowns that answer it.
struct Response<'a, const N: usize> {
    motion: [&'a [f64]; N],
    unknowns: &'a mut [[f64; N]],
    /// The size of the equations of the motion.
    first: Option<f64>,
}

impl<C: Operator<N>, P: Operator<N>, R: Row<N>, const N: usize> Equations<C, P, R, N>
    for Response<'_, N>
{
    fn set_residual(&mut self, linear: &mut Linear<'_, '_, C, P, R, N>) -> ControlFlow<Status> {
        linear.proceed()?;
        linear.workspace.correction.copy_from_slice(self.unknowns);
        linear.apply_to_correction(Precision::Double);
        let w = &mut *linear.workspace;
        let (rows, correction, image) = (&w.rows, &w.correction, slices(&w.image));
        let residual = w.moving.compressed(&mut w.residual);
        w.moving.sweep(residual, |entries, residual| {
            let [image, motion] = [&image, &self.motion].map(|v| within(v, &entries.chunk));
            for (k, place) in entries.places().enumerate() {
                let row = entries.row(rows, k, place);
                let left = std::array::from_fn(|c| motion[c][place] - image[c][place]);
                let bend = row.bend(correction[entries.range.start + k]);
                let left = row.restrict(left);
                residual.items[k] = std::array::from_fn(|c| left[c] - bend[c]);
            }
        });
        let size = linear.residual_size();
        let first = *self.first.get_or_insert(size);
        let residual = if first > 0.0 { size / first } else { 0.0 };
        linear.workspace.report.residual = residual;
        ControlFlow::Continue(())
    }

    fn advance(
        &mut self,
        linear: &mut Linear<'_, '_, C, P, R, N>,
        _: [f64; N],
    ) -> ControlFlow<Status> {
        for (whole, part) in self.unknowns.iter_mut().zip(&linear.workspace.correction) {
            *whole = std::array::from_fn(|c| whole[c] + part[c]);
        }
        ControlFlow::Continue(())
    }
}

impl<C: Operator<N>, P: Operator<N>, R: Row<N>, const N: usize> Linear<'_, '_, C, P, R, N> {
    /// Finds the unknowns that answer a motion of the cells, in double precision; what they leave stays in the residual,
    /// their tractions and displacements in `direction` and `image`.
    ///
    /// # Errors
    /// [`Error::NotConverged`]; [`Error::Memory`].
    pub(crate) fn respond(
        &mut self,
        motion: [&[f64]; N],
        unknowns: &mut Vec<[f64; N]>,
    ) -> Result<()> {
        unknowns.clear();
        buffer::resize(unknowns, self.workspace.residual.len(), [0.0; N])?;
        let mut response = Response {
            motion,
            unknowns,
            first: None,
        };
        let found = self.solve(&Border::NONE, [0.0; N], (BASES, SOLVED), &mut response);
        if let Some(lack) = self.monitor.lack.take() {
            return Err(lack);
        }
        let status = match found {
            ControlFlow::Continue(left) if left <= SOLVED => return Ok(()),
            ControlFlow::Continue(_) => Status::Stalled,
            ControlFlow::Break(status) => status,
        };
        let report = &mut self.workspace.report;
        report.status = status;
        Err(Error::NotConverged(Box::new(report.clone())))
    }
}
