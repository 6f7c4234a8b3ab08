//! Buffers of a solve with friction cones.

use crate::cgm::cone::N;
use crate::cgm::cone::cell_state::ConeCellState;
use crate::cgm::law::state::Row;
use crate::cgm::linear::LinearWorkspace;
use crate::error::Result;
use crate::memory::fallible;
use crate::operator::Operator;
use crate::report::Report;

/// Buffers of a solve except its tractions. They are created once and reused by every solve of the same size.
#[derive(Debug, Clone)]
pub(crate) struct ConeWorkspace {
    /// Linear problem whose rows are the states of the cells.
    pub(super) linear: LinearWorkspace<ConeCellState, N>,
    pub(super) product: [Vec<f64>; N],
    /// Friction limit of every cell.
    pub(super) limits: Vec<f64>,
    pub(super) multiplier: [f64; N],
}

impl ConeWorkspace {
    /// Creates buffers for an operator and its preconditioner.
    pub(crate) fn new(
        operator: &dyn Operator<N>,
        preconditioner: &dyn Operator<N>,
    ) -> Result<Self> {
        let cells = operator.cells();
        Ok(Self {
            linear: LinearWorkspace::new(operator, preconditioner)?,
            product: fallible::vector(cells)?,
            limits: fallible::zeros(cells)?,
            multiplier: [0.0; N],
        })
    }

    /// Writes `C x` to `out` without a change of the stored solution.
    pub(crate) fn apply(
        &mut self,
        operator: &dyn Operator<N>,
        x: [&[f64]; N],
        out: [&mut [f64]; N],
    ) {
        operator.apply(x, out, &mut self.linear.operator);
    }

    /// Returns the product `C x` of the tractions last returned.
    pub(crate) fn product(&self) -> [&[f64]; N] {
        self.product.each_ref().map(Vec::as_slice)
    }

    pub(crate) fn multiplier(&self) -> [f64; N] {
        self.multiplier
    }

    pub(crate) fn set_multiplier(&mut self, multiplier: [f64; N]) {
        self.multiplier = multiplier;
    }

    pub(crate) fn report(&self) -> &Report {
        &self.linear.report
    }
}

/// Returns gap and slip of the cells.
pub(super) fn gradient<'a>(
    product: &'a [Vec<f64>; N],
    linear: [&'a [f64]; N],
    multiplier: [f64; N],
) -> impl Fn(usize) -> [f64; N] + Sync + 'a {
    move |i| std::array::from_fn(|c| product[c][i] + linear[c][i] - multiplier[c])
}
