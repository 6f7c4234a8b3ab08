//! What an iteration writes to.

use crate::cgm::ConstraintSet;
use crate::cgm::linear::LinearWorkspace;
use crate::error::Result;
use crate::memory::fallible;
use crate::operator::{Operator, Scratch};
use crate::report::Report;

/// Everything an iteration writes to besides `x`; made once, reused by every solve of one size.
///
/// `S` is the kind of set of each cell: an [`Interval`](crate::cgm::Interval) or a [`Disc`](crate::cgm::Disc).
/// [`Problem::workspace`](crate::cgm::Problem::workspace) creates it.
#[derive(Debug, Clone)]
pub struct Workspace<S: ConstraintSet<N>, const N: usize = 1> {
    pub(super) linear: LinearWorkspace<S::CellMotion, N>,
    pub(super) product: [Vec<f64>; N],
    pub(super) gradient: [Vec<f64>; N],
    /// What a stage is restrained about; empty until sets cycle.
    pub(super) centre: [Vec<f64>; N],
    pub(super) conjugate: Conjugate<N>,
    pub(super) multiplier: [f64; N],
}

/// What conjugate gradients remember, of the cells that move.
#[derive(Debug, Clone)]
pub(super) struct Conjugate<const N: usize> {
    pub(super) last_residual: Vec<[f64; N]>,
    pub(super) direction: Vec<[f64; N]>,
}

impl<S: ConstraintSet<N>, const N: usize> Workspace<S, N> {
    /// Buffers for an operator and its preconditioner: `7 N + N^2` numbers and a motion per cell besides their own.
    ///
    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
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

    /// The product `C x` with the iterate last returned.
    #[must_use]
    pub fn product(&self) -> [&[f64]; N] {
        self.product.each_ref().map(Vec::as_slice)
    }

    /// That product alone.
    pub(crate) fn into_product(self) -> [Vec<f64>; N] {
        self.product
    }

    /// The scratch of a product, for one outside of the solves.
    pub(crate) fn operator_mut(&mut self) -> &mut Scratch {
        &mut self.linear.operator
    }

    /// Takes an iterate and multipliers as those of the last solve.
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

    /// Measures the product of the last solve in another unit.
    pub(crate) fn rescale(&mut self, factor: f64) {
        for value in self.product.iter_mut().flatten() {
            *value *= factor;
        }
    }

    /// The report of the last solve, converged or not.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.linear.report
    }

    /// The multipliers of the last solve, converged or not.
    #[must_use]
    pub fn multiplier(&self) -> [f64; N] {
        self.multiplier
    }
}
