//! Linear responses: tractions caused by displacements of the cells while the states of the cells are fixed.

use crate::cgm::{CellCompliance, FixedSetSystem, LinearWorkspace, Row, reduce};
use crate::contact::with_counts_of;
use crate::error::{Error, Result, check_converged};
use crate::half_space::Compliance;
use crate::memory::fallible;
use crate::numerics::cell_vector::at;
use crate::observer::Observer;
use crate::operator::Operator;
use crate::parallel::layout::Layout;
use crate::report::Report;

/// Tolerance and observer of linear solves, and the report of all solves together.
pub(crate) struct ResponseContext<'a> {
    /// Relative residual at which a solve ends.
    pub(crate) tolerance: f64,
    pub(crate) report: &'a mut Report,
    pub(crate) observer: Observer<'a>,
}

/// Linear problem of cells with fixed states, and its solutions for at most three displacements.
#[derive(Debug, Clone)]
pub(crate) struct LinearResponse<R, const N: usize> {
    pub(crate) linear: LinearWorkspace<R, N>,
    pub(crate) layout: Layout,
    pub(crate) columns: [ResponseColumn<N>; 3],
}

/// Solution of `A y = P b` for the unknowns of the moving cells.
#[derive(Debug, Clone, Default)]
pub(crate) struct ResponseColumn<const N: usize> {
    pub(crate) right: Vec<[f64; N]>,
    pub(crate) y: Vec<[f64; N]>,
    /// `P b - A y`.
    pub(crate) left: Vec<[f64; N]>,
}

/// Operator and preconditioner of the cells, and their additional compliance.
pub(crate) type Elasticity<'a, const N: usize> =
    (&'a dyn Operator<N>, &'a dyn Operator<N>, CellCompliance<'a>);

impl<const N: usize> Compliance<N> {
    /// Returns the elasticity of cells with this additional compliance.
    pub(crate) fn with_cells<'a>(&'a self, own: CellCompliance<'a>) -> Elasticity<'a, N> {
        (&self.operator, &self.inverse, own)
    }
}

impl<R: Row<N>, const N: usize> LinearResponse<R, N> {
    pub(crate) fn new(
        operator: &dyn Operator<N>,
        preconditioner: &dyn Operator<N>,
        layout: Layout,
    ) -> Result<Self> {
        Ok(Self {
            linear: LinearWorkspace::new(operator, preconditioner)?,
            layout,
            columns: Default::default(),
        })
    }

    /// Solves for the tractions that cause the given displacements of the cells, to the tolerance or to the round-off limit. The
    /// solution is stored in a column, and the tractions in the linear problem.
    ///
    /// # Errors
    /// - [`Error::NotConverged`] if the observer cancels or the iteration fails.
    /// - [`Error::Memory`] if the memory does not suffice.
    pub(crate) fn respond(
        &mut self,
        column: usize,
        (operator, preconditioner, own): Elasticity<'_, N>,
        displacement: impl Fn(usize) -> [f64; N] + Sync,
        context: &mut ResponseContext<'_>,
    ) -> Result<()> {
        let ResponseColumn { right, y, left } = &mut self.columns[column];
        let linear = &mut self.linear;
        linear.restrict(displacement, right)?;
        let held = FixedSetSystem {
            operator,
            preconditioner,
            layout: &self.layout,
            own,
        };
        let mut observer = with_counts_of(context.report, &mut *context.observer);
        let outcome = held.respond(right, y, linear, context.tolerance, &mut observer);
        drop(observer);
        let bound = context.report.eigenvalue_bound;
        context.report.add_pass(linear.report());
        context.report.eigenvalue_bound = bound;
        left.clear();
        fallible::make_room(left, right.len())?;
        left.extend_from_slice(linear.residual_rows());
        outcome.map_err(|error| match error {
            Error::NotConverged(_) => Error::NotConverged(Box::new(context.report.clone())),
            other => other,
        })
    }

    /// Returns the tractions that cause the given displacements of the cells.
    ///
    /// # Errors
    /// - [`Error::NotConverged`] if the solve does not reach the tolerance.
    /// - [`Error::Memory`] if the memory does not suffice.
    pub(crate) fn tractions(
        &mut self,
        elasticity: Elasticity<'_, N>,
        displacement: impl Fn(usize) -> [f64; N] + Sync,
        context: &mut ResponseContext<'_>,
    ) -> Result<[&[f64]; N]> {
        self.respond(0, elasticity, displacement, context)?;
        // A stop at the round-off limit is also an error.
        check_converged(context.report)?;
        Ok(self.linear.tractions())
    }

    /// Computes the loads per unit of each of the first `count` motions, and zero for the other motions. `motion` returns the
    /// displacement of a cell for a unit of a motion, and `load` the loads of a cell under its tractions.
    ///
    /// # Errors
    /// The errors of [`Self::tractions`].
    pub(crate) fn responses<const M: usize>(
        &mut self,
        elasticity: Elasticity<'_, N>,
        count: usize,
        motion: impl Fn(usize, usize) -> [f64; N] + Sync,
        load: impl Fn(usize, [f64; N]) -> [f64; M] + Sync,
        context: &mut ResponseContext<'_>,
    ) -> Result<[[f64; M]; M]> {
        let mut loads = [[0.0; M]; M];
        for (a, loads) in loads.iter_mut().enumerate().take(count) {
            self.tractions(elasticity, |cell| motion(a, cell), context)?;
            let tractions = self.linear.tractions();
            *loads = reduce::sum(&self.layout, |cell| load(cell, at(&tractions, cell)));
        }
        Ok(loads)
    }
}
