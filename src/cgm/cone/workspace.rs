//! Buffers of a solve with friction cones.

use crate::cgm::cone::N;
use crate::cgm::cone::cell_state::ConeCellState;
use crate::cgm::linear::LinearWorkspace;
use crate::error::Result;
use crate::memory::fallible;
use crate::operator::Operator;

/// Buffers of a solve except its tractions. They are created once and reused by every solve of the same size.
#[derive(Debug, Clone)]
pub(crate) struct ConeWorkspace {
    /// Linear problem whose rows are the states of the cells.
    pub(crate) linear: LinearWorkspace<ConeCellState, N>,
    pub(super) product: [Vec<f64>; N],
    /// Friction limit of every cell.
    pub(super) limits: Vec<f64>,
    pub(crate) multiplier: [f64; N],
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

    /// Returns the product `C x` of the tractions last returned.
    pub(crate) fn product(&self) -> [&[f64]; N] {
        self.product.each_ref().map(Vec::as_slice)
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
