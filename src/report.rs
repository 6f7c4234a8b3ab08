//! Report of a solver: status, residual and certified bounds.
//!
//! The error for a solve that has not converged contains the whole [`Report`].

use std::fmt;
use std::time::Duration;

/// Reason why an iteration ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Status {
    /// No solve has been started yet.
    Unsolved,
    /// The residual and the certified error are at or below the tolerance. Both are computed from a new product. For a
    /// user-defined operator without a [`lower_bound`](crate::Operator::lower_bound), only the residual is tested.
    Converged,
    /// The solve reached the iteration limit before it converged.
    IterationLimit,
    /// The solve reached the time limit before it converged.
    TimeLimit,
    /// The residual no longer decreases, because the tolerance is below round-off or an operator returns NaN.
    Stalled,
    /// The observer cancelled the solve.
    Cancelled,
}

impl fmt::Display for Status {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Unsolved => "not solved",
            Self::Converged => "converged",
            Self::IterationLimit => "stopped at the iteration limit",
            Self::TimeLimit => "stopped at the time limit",
            Self::Stalled => "stalled",
            Self::Cancelled => "cancelled",
        })
    }
}

/// Origin of the bound on the smallest eigenvalue of an operator, which a certified error requires.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum EigenvalueBound {
    /// No bound is available. [`Report::duality_gap`] is then the duality gap of the problem. The error bound is the
    /// square root of this gap. It decreases only with the square root of the residual.
    #[default]
    Unknown,
    /// Conservative estimate, used for stiff coatings on long grids ([`layers`](crate::layers#limits-of-the-model)).
    Estimated,
    /// Lower bound that a user-defined operator states. This crate does not check it.
    Stated,
    /// Rigorous lower bound, which this crate computes for its own operators.
    Proven,
}

/// One step of an iteration, as passed to an observer.
///
/// The observer is called before every product, including products on the coarser grids of a nested start. After a
/// cancellation or a time limit, the solver computes one more product on each grid in use. This product measures the
/// error of the last iterate. A cancelled solve always ends with [`Status::Cancelled`], even if the last iterate
/// satisfies the tolerance. A step of a history is then not taken. The residual and the number of free entries are the
/// last measured values. They do not change between two outer steps of the active-set method.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Iteration {
    /// Number of conjugate-gradient steps so far. Zero before the first step.
    pub iteration: usize,
    /// Number of products with the operator in double precision so far.
    pub double_precision_products: usize,
    /// Number of products in single precision so far.
    pub single_precision_products: usize,
    /// Largest complementarity residual, relative to the largest displacement (see [`Report::residual`]).
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub residual: f64,
    /// Number of entries strictly between their bounds. These are the contact cells of a normal problem and the
    /// sticking cells of a tangential problem.
    pub free: usize,
}

impl Iteration {
    /// Returns this step with the given numbers of earlier steps, double-precision products and single-precision
    /// products added.
    pub(crate) fn after(self, [iterations, double, single]: [usize; 3]) -> Self {
        Self {
            iteration: iterations + self.iteration,
            double_precision_products: double + self.double_precision_products,
            single_precision_products: single + self.single_precision_products,
            ..self
        }
    }
}

/// Status, cost and error bounds of a solve.
///
/// Every number is recomputed from a new product with the returned iterate, for every status.
#[derive(PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Report {
    /// Reason why the iteration ended.
    pub status: Status,
    /// Number of conjugate-gradient steps.
    pub iterations: usize,
    /// Number of products with the operator in double precision, including the final check. Like all counts of a
    /// report, it covers the requested grid only. The work of a nested start on coarser grids appears only in the time.
    pub double_precision_products: usize,
    /// Number of products in single precision, within the iteration only.
    pub single_precision_products: usize,
    /// Largest complementarity residual (dimensionless). The residual of an entry is `|g_i|` on free entries, and the
    /// wrong-signed part of `g_i` on entries at a bound. The divisor is the largest `|(Cx)_i|` over the entries that
    /// can move. If the smallest eigenvalue of the operator times the largest unknown is larger, this value is the
    /// divisor. It is needed on a periodic grid, where a uniform traction causes no displacement. If the sums of the
    /// unknowns are prescribed, the eigenvalue is the smallest one for unknowns with zero sums.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub residual: f64,
    /// Certified bound on the squared relative error in the energy norm (dimensionless):
    /// `(x - x*)' C (x - x*) <= duality_gap * x' C x`. If the operator maps constants to zero, or is not positive definite,
    /// `lambda x' x` can be larger than `x' C x` and then replaces it. Here `lambda` is the available bound on the eigenvalues
    /// for unknowns with zero sums. The value is a duality gap and not a distance.
    ///
    /// On a grid that is periodic along both axes, `x*` is the exact solution for the total of `x`, even if an approach or
    /// a shift is prescribed. The bound is then relative to the contact under the computed force. It does not bound the
    /// error of this force, which can be several times larger than the bound.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub duality_gap: f64,
    /// Origin of the eigenvalue bound on which [`Self::duality_gap`] relies. The certified bounds of a coupled contact
    /// and of a stiffness rely on it too.
    pub eigenvalue_bound: EigenvalueBound,
    /// Relative error of the prescribed total, `|sum x - total| / sum |x|`, or zero if no total is prescribed. The
    /// [duality gap](Self::duality_gap) refers to the total of the iterate. Near sliding, the directions of tractions
    /// change by the square root of this error.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub load_error: f64,
    /// Wall time of the solve.
    pub time: Duration,
    /// Iterates whose residual was measured, in order. The first entry is the start. The active-set method adds an
    /// entry per outer step, whose residual is computed in single precision while it is large. The Polonsky-Keer method
    /// adds an entry per step.
    pub history: Vec<Iteration>,
}

/// Initial capacity of the history. Few solves need more outer steps.
const ENTRIES: usize = 64;

impl Report {
    /// Returns the report before any solve.
    pub(crate) fn unsolved() -> Self {
        Self {
            status: Status::Unsolved,
            iterations: 0,
            double_precision_products: 0,
            single_precision_products: 0,
            residual: f64::INFINITY,
            duality_gap: f64::INFINITY,
            eigenvalue_bound: EigenvalueBound::Unknown,
            load_error: 0.0,
            time: Duration::ZERO,
            history: Vec::new(),
        }
    }

    /// Returns the report before any solve, with memory for a history of the usual length. Solvers that are used
    /// repeatedly start from this report.
    pub(crate) fn with_room() -> Self {
        Self {
            history: Vec::with_capacity(ENTRIES),
            ..Self::unsolved()
        }
    }

    /// Resets the report before a solve and keeps the memory of the history.
    pub(crate) fn clear(&mut self) {
        let mut history = std::mem::take(&mut self.history);
        history.clear();
        *self = Self {
            history,
            ..Self::unsolved()
        };
    }

    /// Sets the report of a solution that needs no work. Status and errors receive the values of an earlier report, and
    /// all counts become zero.
    pub(crate) fn recall(&mut self, known: &Self) {
        self.clear();
        self.status = known.status;
        self.residual = known.residual;
        self.duality_gap = known.duality_gap;
        self.eigenvalue_bound = known.eigenvalue_bound;
        self.load_error = known.load_error;
    }

    /// Marks the solve as cancelled, and returns a copy of the report.
    pub(crate) fn cancelled(&mut self) -> Self {
        self.status = Status::Cancelled;
        self.clone()
    }

    /// Returns whether the tolerance was reached.
    #[must_use]
    pub fn is_converged(&self) -> bool {
        self.status == Status::Converged
    }

    /// Returns the number of products with the operator in either precision. This number measures the cost of a solve
    /// independently of the machine.
    ///
    /// Products in both precisions have the same weight. On 64 x 64 cells a product in single precision takes nine
    /// tenths of the time of a product in double precision. On 512 x 512 cells or more it takes half to two thirds of
    /// this time.
    #[must_use]
    pub fn products(&self) -> usize {
        self.double_precision_products + self.single_precision_products
    }

    /// Returns the numbers of steps, double-precision products and single-precision products.
    pub(crate) fn counts(&self) -> [usize; 3] {
        [
            self.iterations,
            self.double_precision_products,
            self.single_precision_products,
        ]
    }

    /// Adds a further pass. Appends the history of the pass, adds its counts, and replaces all other values by the
    /// values of the pass.
    pub(crate) fn add_pass(&mut self, pass: &Self) {
        let before = self.counts();
        let mut history = std::mem::take(&mut self.history);
        history.extend(pass.history.iter().map(|step| step.after(before)));
        *self = Self {
            iterations: before[0] + pass.iterations,
            double_precision_products: before[1] + pass.double_precision_products,
            single_precision_products: before[2] + pass.single_precision_products,
            history,
            ..*pass
        };
    }

    /// Returns whether residual, load error and certified error are all at or below a tolerance.
    pub(crate) fn is_within(&self, tolerance: f64) -> bool {
        self.residual <= tolerance
            && self.load_error <= tolerance
            && self.energy_error_bound() <= tolerance
    }

    /// Returns the certified bound on the relative error in the energy norm, `sqrt(duality_gap)`.
    #[must_use]
    pub fn energy_error_bound(&self) -> f64 {
        self.duality_gap.sqrt()
    }
}

impl Clone for Report {
    fn clone(&self) -> Self {
        let mut copy = Self::unsolved();
        copy.clone_from(self);
        copy
    }

    /// Reuses the memory of the history, because a solver fills the same report repeatedly.
    fn clone_from(&mut self, source: &Self) {
        let mut history = std::mem::take(&mut self.history);
        history.clone_from(&source.history);
        *self = Self { history, ..*source };
    }
}

/// Formats the report on one line, without the history, as in the message of an error that contains a report.
impl fmt::Debug for Report {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "Report({self})")
    }
}

impl fmt::Display for Report {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.status == Status::Unsolved {
            return write!(formatter, "{}", self.status);
        }
        let plural = if self.iterations == 1 { "" } else { "s" };
        write!(
            formatter,
            "{} in {} iteration{plural}, {} + {} convolutions (double + single), {:.3} s: residual {:.1e}, ",
            self.status,
            self.iterations,
            self.double_precision_products,
            self.single_precision_products,
            self.time.as_secs_f64(),
            self.residual,
        )?;
        let bound = self.energy_error_bound();
        if bound.is_infinite() {
            write!(formatter, "energy error not bounded")?;
        } else {
            write!(formatter, "energy error <= {bound:.1e}")?;
            if self.eigenvalue_bound == EigenvalueBound::Estimated {
                write!(formatter, " by an estimate of the smallest eigenvalue")?;
            }
            if self.eigenvalue_bound == EigenvalueBound::Stated {
                write!(formatter, " by the stated bound of the smallest eigenvalue")?;
            }
        }
        write!(formatter, ", load error {:.1e}", self.load_error)
    }
}
