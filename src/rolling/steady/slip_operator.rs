//! The contribution of steady tractions to the slip of a step.

use crate::error::Result;
use crate::half_space::ElasticOperator;
use crate::operator::{Operator, Scratch};
use crate::report::EigenvalueBound;
use crate::rolling::WindowShift;

/// The operator $`(1 - T)\,C`$ on a window that extends a step ahead of the contact.
#[derive(Debug, Clone)]
pub(in crate::rolling) struct SteadyOperator {
    compliance: ElasticOperator<2>,
    step: WindowShift,
    /// Lower bound on the eigenvalues of C.
    bound: f64,
    lower_bound: f64,
    eigenvalue_bound: EigenvalueBound,
    self_compliance: f64,
}

impl SteadyOperator {
    /// Creates the operator for chains of at most `chain` cells that are one step apart. A unit traction of a cell
    /// makes that cell slip by `self_compliance` over a step.
    pub(in crate::rolling) fn new(
        compliance: ElasticOperator<2>,
        step: WindowShift,
        chain: usize,
        self_compliance: f64,
    ) -> Self {
        // The difference over a step cancels a constant displacement, and with it the mean.
        let (bound, eigenvalue_bound) = compliance.bound_without_mean();
        Self {
            bound,
            lower_bound: least(chain) * bound,
            eigenvalue_bound,
            compliance,
            step,
            self_compliance,
        }
    }

    /// Sets the bound on the eigenvalues for chains of at most `chain` cells. Consecutive cells of a chain are one step
    /// apart.
    pub(in crate::rolling) fn set_chain(&mut self, chain: usize) {
        self.lower_bound = least(chain) * self.bound;
    }
}

/// Returns the least eigenvalue of the symmetric part of `1 - T` on the given number of consecutive cells.
fn least(chain: usize) -> f64 {
    let angle = std::f64::consts::PI / (chain as f64 + 1.0);
    // 1 - cos(angle) without cancellation.
    2.0 * (0.5 * angle).sin().powi(2)
}

impl Operator<2> for SteadyOperator {
    fn cells(&self) -> usize {
        self.compliance.cells()
    }

    fn scratch(&self) -> Result<Scratch> {
        self.compliance.scratch()
    }

    /// Uses double precision only, because the difference over a step would cancel most digits of single precision.
    fn apply(&self, x: [&[f64]; 2], mut out: [&mut [f64]; 2], scratch: &mut Scratch) {
        let displacement = out.each_mut().map(|part| &mut **part);
        self.compliance.apply(x, displacement, scratch);
        for out in out {
            self.step.difference(out);
        }
    }

    fn lower_bound(&self) -> f64 {
        self.lower_bound
    }

    fn eigenvalue_bound(&self) -> EigenvalueBound {
        self.eigenvalue_bound
    }

    fn self_compliance(&self) -> f64 {
        self.self_compliance
    }

    fn is_symmetric(&self) -> bool {
        false
    }
}
