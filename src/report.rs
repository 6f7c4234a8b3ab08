//! A solver's report on its own work: status, residual, certified gap.
//!
//! These types are kept next to [`Error`](crate::Error) because the error of
//! non-convergence carries the whole [`Report`].

use std::fmt;
use std::time::Duration;

/// Why an iteration ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Status {
    /// Nothing has been solved yet.
    Unsolved,
    /// A fresh product shows residual and certified error at or below the tolerance; only the residual, where a
    /// custom operator has no [`lower_bound`](crate::Operator::lower_bound).
    Converged,
    /// The iteration limit was reached first.
    IterationLimit,
    /// The time limit was reached first.
    TimeLimit,
    /// The residual no longer falls: the tolerance is below round-off, or an operator returns NaN.
    Stalled,
    /// The observer asked to stop.
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

/// How the smallest eigenvalue of an operator is known, on which a certified error rests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum EigenvalueBound {
    /// Not at all. [`Report::duality_gap`] is then the duality gap of the problem, and the bound of the error, its root, falls
    /// only with the root of the residual.
    #[default]
    Unknown,
    /// By an estimate on the safe side: of stiff coatings on long grids
    /// ([`layers`](crate::layers#limits-of-the-model)).
    Estimated,
    /// By a bound from below: computed for the operators of this crate, stated by those of a user.
    Proven,
}

/// One step of an iteration, as passed to an observer.
///
/// The observer is called before every product, also on the coarser grids of a nested start. After it cancels, or after
/// a time limit, one more product is made on each grid in use, to measure the error of the remaining iterate. A solve that
/// the observer has cancelled once ends as [`Status::Cancelled`], whatever that iterate shows, and a step of a history is
/// then not taken.
/// Residual and free entries are the last measured ones: between two outer steps of the active-set method they do not
/// change.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Iteration {
    /// Conjugate-gradient steps so far; zero before the first.
    pub iteration: usize,
    /// Products with the operator in double precision so far.
    pub double_precision_products: usize,
    /// Products in single precision so far.
    pub single_precision_products: usize,
    /// Largest complementarity residual, relative to the largest displacement (see [`Report::residual`]).
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub residual: f64,
    /// Entries strictly between their bounds: contact cells of a normal problem, sticking cells of a tangential one.
    pub free: usize,
}

impl Iteration {
    /// The same step, counted after the given numbers of steps and of products, double and single.
    pub(crate) fn after(self, [iterations, double, single]: [usize; 3]) -> Self {
        Self {
            iteration: iterations + self.iteration,
            double_precision_products: double + self.double_precision_products,
            single_precision_products: single + self.single_precision_products,
            ..self
        }
    }
}

/// How a solve ended, what it cost and how large its error can be.
///
/// Every number is recomputed from a fresh product with the returned iterate,
/// whatever the status.
#[derive(PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Report {
    /// Why the iteration ended.
    pub status: Status,
    /// Conjugate-gradient steps.
    pub iterations: usize,
    /// Products with the operator in double precision, including the final check. Like all counts here,
    /// this covers the requested grid only; the work of a nested start on coarser grids appears in the time.
    pub double_precision_products: usize,
    /// Products in single precision, within the iteration only.
    pub single_precision_products: usize,
    /// Largest complementarity residual: `|g_i|` on free entries, the wrong-signed part of
    /// `g_i` on entries at a bound, divided by the largest `|(Cx)_i|` over the entries that can
    /// move. If the operator's smallest eigenvalue times the largest unknown is larger, it is the divisor
    /// (a uniform traction displaces nothing on a periodic grid). Dimensionless.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub residual: f64,
    /// Certified bound on the squared relative error in the energy norm:
    /// `(x - x*)' C (x - x*) <= duality_gap * x' C x`. If `lambda x' x` is larger than `x' C x`, it takes its place,
    /// with `lambda` the operator's known smallest eigenvalue. Dimensionless: a duality gap, not a distance.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub duality_gap: f64,
    /// How the smallest eigenvalue is known that [`Self::duality_gap`] rests on, and what else is certified beside it: the
    /// bounds of a coupled contact, of a stiffness.
    pub eigenvalue_bound: EigenvalueBound,
    /// Relative error of the prescribed total, `|sum x - total| / sum |x|`; zero when no total
    /// is prescribed. The [duality gap](Self::duality_gap) is that of the total reached. Near sliding the directions of
    /// tractions change by the root of this error.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub load_error: f64,
    /// Wall time of the solve.
    pub time: Duration,
    /// Every iterate whose residual was measured, in order: the start, then one entry per outer step
    /// (active set, in single precision while the residual is large) or per step (Polonsky-Keer).
    pub history: Vec<Iteration>,
}

/// Number of outer steps that few solves exceed.
const ENTRIES: usize = 64;

impl Report {
    /// The report before any solve.
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

    /// The report before any solve, with memory for a history of the usual length: for a solver used repeatedly.
    pub(crate) fn with_room() -> Self {
        Self {
            history: Vec::with_capacity(ENTRIES),
            ..Self::unsolved()
        }
    }

    /// Before a solve, with the memory there is.
    pub(crate) fn clear(&mut self) {
        let mut history = std::mem::take(&mut self.history);
        history.clear();
        *self = Self {
            history,
            ..Self::unsolved()
        };
    }

    /// That of an answer known from before: what it showed then, without work.
    pub(crate) fn recall(&mut self, known: &Self) {
        self.clear();
        self.status = known.status;
        self.residual = known.residual;
        self.duality_gap = known.duality_gap;
        self.eigenvalue_bound = known.eigenvalue_bound;
        self.load_error = known.load_error;
    }

    /// Marks the solve as cancelled, and returns a copy.
    pub(crate) fn cancelled(&mut self) -> Self {
        self.status = Status::Cancelled;
        self.clone()
    }

    /// Whether the tolerance was reached.
    #[must_use]
    pub fn is_converged(&self) -> bool {
        self.status == Status::Converged
    }

    /// Products with the operator in either precision: the cost of a solve, independent of the machine.
    ///
    /// All count the same. A product in single precision takes nine tenths of the time of one in double on 64 x 64
    /// cells, and half to two thirds for 512 x 512 cells or more.
    #[must_use]
    pub fn products(&self) -> usize {
        self.double_precision_products + self.single_precision_products
    }

    /// Steps and products, in double and in single precision.
    pub(crate) fn counts(&self) -> [usize; 3] {
        [
            self.iterations,
            self.double_precision_products,
            self.single_precision_products,
        ]
    }

    /// Adds a further pass: appends its history, adds its counts, and takes over the rest.
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

    /// Whether residual, load error and certified error are all at or below a tolerance.
    pub(crate) fn is_within(&self, tolerance: f64) -> bool {
        self.residual <= tolerance
            && self.load_error <= tolerance
            && self.energy_error_bound() <= tolerance
    }

    /// Certified bound on the relative error in the energy norm, `sqrt(duality_gap)`.
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

    /// Reuses the memory of the history, since a solver fills the same report repeatedly.
    fn clone_from(&mut self, source: &Self) {
        let mut history = std::mem::take(&mut self.history);
        history.clone_from(&source.history);
        *self = Self { history, ..*source };
    }
}

/// One line, without the history, as printed by an error that carries a report.
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
        }
        write!(formatter, ", load error {:.1e}", self.load_error)
    }
}
