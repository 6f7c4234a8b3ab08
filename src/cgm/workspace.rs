//! Buffers of an iteration.

use crate::cgm::ConstraintSet;
use crate::cgm::linear::LinearWorkspace;
use crate::error::Result;
use crate::memory::fallible;
use crate::operator::{Operator, Scratch};
use crate::report::Report;

/// Buffers of an iteration except `x`. They are created once and reused by every solve of the same size.
///
/// `S` is the type of the set of each cell: an [`Interval`](crate::cgm::Interval) or a [`Disc`](crate::cgm::Disc).
/// [`Problem::workspace`](crate::cgm::Problem::workspace) creates a workspace.
#[derive(Debug, Clone)]
pub struct Workspace<S: ConstraintSet<N>, const N: usize = 1> {
    pub(super) linear: LinearWorkspace<S::CellMotion, N>,
    pub(super) product: [Vec<f64>; N],
    pub(super) gradient: [Vec<f64>; N],
    /// Centre of the restraint in a proximal-point stage. The vectors are empty until sets cycle.
    pub(super) centre: [Vec<f64>; N],
    pub(super) conjugate: Conjugate<N>,
    pub(super) multiplier: [f64; N],
}

/// State of the conjugate gradients on the moving cells.
#[derive(Debug, Clone)]
pub(super) struct Conjugate<const N: usize> {
    pub(super) last_residual: Vec<[f64; N]>,
    pub(super) direction: Vec<[f64; N]>,
}

impl<S: ConstraintSet<N>, const N: usize> Workspace<S, N> {
    /// Creates buffers for an operator and its preconditioner.
    ///
    /// # Memory
    /// The buffers take `7 N + N^2` numbers and a motion per cell, in addition to the buffers of operator and preconditioner. The
    /// first scattered contact adds `N` numbers and two bytes per cell.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if the memory does not suffice.
    pub(crate) fn new(
        operator: &dyn Operator<N>,
        preconditioner: &dyn Operator<N>,
    ) -> Result<Self> {
        let cells = operator.cells();
        let mut linear = LinearWorkspace::new(operator, preconditioner)?;
        linear.make_room(cells)?;
        Ok(Self {
            linear,
            product: fallible::vector(cells)?,
            gradient: fallible::vector(cells)?,
            centre: std::array::from_fn(|_| Vec::new()),
            conjugate: Conjugate {
                last_residual: fallible::zeros(cells)?,
                direction: fallible::zeros(cells)?,
            },
            multiplier: [0.0; N],
        })
    }

    /// Returns the product `C x` with the iterate last returned.
    #[must_use]
    pub fn product(&self) -> [&[f64]; N] {
        self.product.each_ref().map(Vec::as_slice)
    }

    /// Returns the product and drops the other buffers.
    pub(crate) fn into_product(self) -> [Vec<f64>; N] {
        self.product
    }

    /// Returns the scratch of the operator, for a product outside a solve.
    pub(crate) fn operator_mut(&mut self) -> &mut Scratch {
        &mut self.linear.operator
    }

    /// Sets an iterate and multipliers as the result of the last solve.
    pub(crate) fn set_solution(
        &mut self,
        operator: &dyn Operator<N>,
        x: [&[f64]; N],
        multiplier: [f64; N],
    ) {
        let product = self.product.each_mut().map(Vec::as_mut_slice);
        operator.apply(x, product, &mut self.linear.operator);
        self.multiplier = multiplier;
    }

    /// Multiplies the product of the last solve by a factor, for a change of unit.
    pub(crate) fn rescale(&mut self, factor: f64) {
        for value in self.product.iter_mut().flatten() {
            *value *= factor;
        }
    }

    /// Returns the report of the last solve, converged or not.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.linear.report
    }

    /// Returns the multipliers of the last solve, converged or not.
    #[must_use]
    pub fn multiplier(&self) -> [f64; N] {
        self.multiplier
    }
}
