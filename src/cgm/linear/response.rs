//! Tractions caused by motions of the bodies at fixed states of the cells, computed with GMRES.

use std::ops::ControlFlow;

use crate::cgm::Settings;
use crate::cgm::active_set_solve::Precision;
use crate::cgm::diagonal::CellCompliance;
use crate::cgm::law::state::Row;
use crate::cgm::linear::gmres::Equations;
use crate::cgm::linear::{Border, Linear, LinearWorkspace};
use crate::cgm::monitor::Monitor;
use crate::error::{Error, Result};
use crate::memory::fallible;
use crate::numerics::cell_vector::{at, dot, minus, plus, slices};
use crate::observer::Observer;
use crate::operator::Operator;
use crate::parallel::layout::Layout;
use crate::report::{Report, Status};

/// Maximum number of bases for a response. Beyond this number the response has not converged.
const BASES: usize = 100;

/// Right-hand side of the equations and their solution.
struct LinearResponse<'a, const N: usize> {
    right: &'a [[f64; N]],
    unknowns: &'a mut [[f64; N]],
    /// Size of the right-hand side.
    first: f64,
    /// Size of the residual before the last basis.
    last: f64,
}

impl<R: Row<N>, const N: usize> Equations<R, N> for LinearResponse<'_, N> {
    fn set_residual(&mut self, linear: &mut Linear<'_, '_, R, N>) -> ControlFlow<Status> {
        linear.monitor.proceed()?;
        linear.workspace.correction.copy_from_slice(self.unknowns);
        linear.apply_to_correction(Precision::Double);
        let w = &mut *linear.workspace;
        let (right, correction, image) = (self.right, &w.correction, slices(&w.image));
        w.moving.set(&w.rows, &mut w.residual, |k, cell, row: R| {
            let (moved, bend) = (row.restrict(at(&image, cell)), row.bend(correction[k]));
            minus(right[k], plus(moved, 1.0, bend))
        });
        let size = linear.residual_size();
        if self.first.is_infinite() {
            self.first = size;
        }
        let is_stalled = self.last.is_finite() && size > 0.5 * self.last;
        let residual = if self.first > 0.0 {
            size / self.first
        } else {
            0.0
        };
        (self.last, linear.monitor.report.residual) = (size, residual);
        if is_stalled {
            ControlFlow::Break(Status::Stalled)
        } else {
            ControlFlow::Continue(())
        }
    }

    fn advance(&mut self, linear: &mut Linear<'_, '_, R, N>, _: [f64; N]) -> ControlFlow<Status> {
        for (whole, part) in self.unknowns.iter_mut().zip(&linear.workspace.correction) {
            *whole = std::array::from_fn(|c| whole[c] + part[c]);
        }
        ControlFlow::Continue(())
    }
}

/// Operator and preconditioner of cells with fixed motion states.
#[derive(Clone, Copy)]
pub(crate) struct FixedSetSystem<'a, const N: usize> {
    pub(crate) operator: &'a dyn Operator<N>,
    pub(crate) preconditioner: &'a dyn Operator<N>,
    pub(crate) layout: &'a Layout,
    /// Additional compliance of the cells.
    pub(crate) own: CellCompliance<'a>,
}

impl<const N: usize> FixedSetSystem<'_, N> {
    /// Solves for a right-hand side with GMRES in double precision, to a given relative residual. If a basis does not
    /// halve the residual, the current unknowns are kept and the report has [`Status::Stalled`]. Afterwards the residual
    /// is in [`LinearWorkspace::residual_rows`], and the tractions are in [`LinearWorkspace::tractions`].
    ///
    /// # Errors
    /// - [`Error::NotConverged`] if the observer cancels or the iteration fails.
    /// - [`Error::Memory`] if the memory does not suffice.
    pub(crate) fn respond<R: Row<N>>(
        &self,
        right: &[[f64; N]],
        unknowns: &mut Vec<[f64; N]>,
        workspace: &mut LinearWorkspace<R, N>,
        tolerance: f64,
        observer: Observer<'_>,
    ) -> Result<()> {
        unknowns.clear();
        fallible::resize(unknowns, right.len(), [0.0; N])?;
        let settings = Settings::default().max_iterations(usize::MAX);
        let report = &mut workspace.report;
        let mut monitor = Monitor::new(&settings, self.layout, observer, report);
        monitor.free = workspace.moving.free(&workspace.rows);
        let mut linear = Linear {
            operator: self.operator,
            preconditioner: self.preconditioner,
            sparse: None,
            layout: self.layout,
            own: self.own,
            self_compliance: self.operator.self_compliance(),
            restraint: 0.0,
            stiff: f64::INFINITY,
            monitor: &mut monitor,
            workspace: &mut *workspace,
        };
        let mut response = LinearResponse {
            right,
            unknowns,
            first: f64::INFINITY,
            last: f64::INFINITY,
        };
        let limits = (BASES, tolerance);
        let found = linear.solve(&Border::NONE, [0.0; N], limits, &mut response);
        workspace.report = monitor.report;
        if let Some(allocation_error) = monitor.allocation_error {
            return Err(allocation_error);
        }
        let is_solved = workspace.report.residual <= tolerance;
        let status = match found {
            ControlFlow::Continue(_) | ControlFlow::Break(Status::Stalled) if is_solved => {
                Status::Converged
            }
            ControlFlow::Continue(_) => Status::Stalled,
            ControlFlow::Break(status) => status,
        };
        let report = &mut workspace.report;
        report.status = status;
        if matches!(status, Status::Converged | Status::Stalled) {
            Ok(())
        } else {
            Err(Error::NotConverged(Box::new(report.clone())))
        }
    }
}

impl<R: Row<N>, const N: usize> LinearWorkspace<R, N> {
    /// Stores the row of each cell, and allocates the unknowns of the moving cells.
    ///
    /// # Errors
    /// - [`Error::Memory`] if the memory does not suffice.
    pub(crate) fn hold(&mut self, row: impl Fn(usize) -> R + Sync) -> Result<()> {
        self.moving.update(|i| row(i).moves());
        self.update_rows(|cell, held| *held = row(cell));
        self.list()
    }

    /// Restricts displacements of the cells to the right-hand side of the equations.
    ///
    /// # Errors
    /// - [`Error::Memory`] if the memory does not suffice.
    pub(crate) fn restrict(
        &self,
        displacement: impl Fn(usize) -> [f64; N] + Sync,
        right: &mut Vec<[f64; N]>,
    ) -> Result<()> {
        fallible::resize(right, self.moving.len(), [0.0; N])?;
        let restricted = |_, cell: usize, row: R| row.restrict(displacement(cell));
        self.moving.set(&self.rows, right, restricted);
        Ok(())
    }

    /// Returns the scalar product of two vectors of unknowns.
    pub(crate) fn product(&self, a: &[[f64; N]], b: &[[f64; N]]) -> f64 {
        let products = |k: usize| dot(a[k], b[k]);
        self.moving
            .sum(|range| range.fold(0.0, |sum, k| sum + products(k)))
    }

    /// Visits the moving cells with their position among the unknowns.
    pub(crate) fn places(&self, mut f: impl FnMut(usize, usize)) {
        self.moving.places(&mut f);
    }

    /// Returns the displacement that the row of a cell adds under these tractions.
    pub(crate) fn lag(&self, cell: usize, tractions: [f64; N]) -> [f64; N] {
        if R::HAS_LAG {
            self.rows[cell].lag(tractions)
        } else {
            [0.0; N]
        }
    }

    /// Computes `C x` for any tractions.
    pub(crate) fn displace(
        &mut self,
        operator: &dyn Operator<N>,
        x: [&[f64]; N],
        out: [&mut [f64]; N],
    ) {
        operator.apply(x, out, &mut self.operator);
    }

    /// Returns the report of the last response.
    pub(crate) fn report(&self) -> &Report {
        &self.report
    }

    /// Returns the residual of the last response.
    pub(crate) fn residual_rows(&self) -> &[[f64; N]] {
        &self.residual
    }

    /// Returns the tractions of the last response.
    pub(crate) fn tractions(&self) -> [&[f64]; N] {
        slices(&self.direction)
    }
}
