//! Exact minimum on a small grid, by pivoting between active sets. The equations of an active set are solved by Cholesky
//! factorisation.
//!
//! For a given multiplier the method is block principal pivoting, with Murty's single pivots as a fallback (Judice & Pires,
//! Computers & Operations Research 21 (1994) 587, <https://doi.org/10.1016/0305-0548(94)90106-6>). It terminates for every
//! symmetric positive definite matrix. A prescribed total gives one equation for the multiplier, with an increasing, piecewise
//! linear left-hand side. This equation is solved by Newton's method between brackets.

use faer::linalg::cholesky::llt::factor::LltError;
use faer::linalg::solvers::{Llt, Solve};
use faer::{Mat, MatRef, Side};

use crate::cgm::{Constraint, Interval, check_constraint};
use crate::dense::{DIRECT_ASYMMETRY, DenseOperator};
use crate::error::{Error, Result, all_finite, length};
use crate::report::{Report, Status};

/// Minimum and its multiplier, exact up to round-off.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct DenseMinimum {
    /// Unknowns.
    pub x: Vec<f64>,
    /// Multiplier of the total, or zero if no total is prescribed.
    pub multiplier: f64,
}

/// Active bound of an entry, or `Free`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mark {
    Lower,
    Upper,
    Free,
}

/// Number of block pivots without a decrease of the number of wrong entries, after which single pivots start.
const BLOCK_TRIALS: usize = 10;

impl DenseOperator {
    /// Minimises `1/2 x'Cx + b'x` over the constraint, with `sum x = total` if a total is given. The total must be strictly
    /// between the sums of the bounds. The method is direct. Its result is the minimum that
    /// [`cgm::minimise`](crate::cgm::minimise) approximates.
    ///
    /// # Errors
    /// - [`Error::Length`] if the linear term or the constraint has a different number of entries.
    /// - [`Error::Sample`] if an entry is not finite.
    /// - [`Error::Bounds`] if a lower bound exceeds its upper bound.
    /// - [`Error::Total`] if the bounds do not allow the total.
    /// - [`Error::NotPositiveDefinite`] if the matrix is not symmetric positive definite.
    /// - [`Error::NotConverged`] if the active sets do not settle because of round-off.
    pub fn minimise(
        &self,
        linear: &[f64],
        constraint: &impl Constraint<1, Set = Interval>,
        total: Option<f64>,
    ) -> Result<DenseMinimum> {
        length("linear term", self.len, linear.len())?;
        all_finite("linear term", linear)?;
        check_constraint(constraint, self.len)?;
        if let Some(row) = self.first_asymmetric_row(DIRECT_ASYMMETRY) {
            return Err(Error::NotPositiveDefinite { row });
        }
        let mut search = ActiveSetSearch {
            operator: self,
            linear,
            bounds: (0..self.len)
                .map(|i| constraint.of(i))
                .map(|Interval { lower, upper }| [lower, upper])
                .collect(),
            marks: vec![Mark::Free; self.len],
        };
        for (mark, [lower, upper]) in search.marks.iter_mut().zip(&search.bounds) {
            if lower >= upper {
                *mark = Mark::Lower;
            }
        }
        match total {
            None => Ok(DenseMinimum {
                x: search.pivot_until_optimal(0.0)?,
                multiplier: 0.0,
            }),
            Some(total) => search.balance(total),
        }
    }
}

struct ActiveSetSearch<'a> {
    operator: &'a DenseOperator,
    linear: &'a [f64],
    bounds: Vec<[f64; 2]>,
    marks: Vec<Mark>,
}

impl ActiveSetSearch<'_> {
    /// Computes the minimum for a given multiplier and stores its active set in the marks.
    fn pivot_until_optimal(&mut self, multiplier: f64) -> Result<Vec<f64>> {
        let (mut fewest, mut trials) = (usize::MAX, BLOCK_TRIALS);
        for _ in 0..100 * (self.marks.len() + 10) {
            let x = self.solve_free(multiplier)?;
            let wrong = self.wrong_marks(&x, multiplier);
            if wrong.is_empty() {
                return Ok(self.clip(x));
            }
            if wrong.len() < fewest {
                (fewest, trials) = (wrong.len(), BLOCK_TRIALS);
            } else {
                trials = trials.saturating_sub(1);
            }
            let first = if trials > 0 { 0 } else { wrong.len() - 1 };
            for &(i, mark) in &wrong[first..] {
                self.marks[i] = mark;
            }
        }
        Err(not_converged())
    }

    /// Computes the minimum with the given total.
    fn balance(&mut self, total: f64) -> Result<DenseMinimum> {
        let [lower, upper] = self
            .bounds
            .iter()
            .fold([0.0, 0.0], |sum: [f64; 2], bounds| {
                [sum[0] + bounds[0], sum[1] + bounds[1]]
            });
        if !(total > lower && total < upper) {
            return Err(Error::Total {
                total,
                lower,
                upper,
            });
        }
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let x = self.solve_free(0.0)?;
        let mut multiplier = (total - x.iter().sum::<f64>()) / self.stiffness()?;
        for _ in 0..200 {
            let x = self.pivot_until_optimal(multiplier)?;
            let magnitude: f64 = x.iter().map(|x| x.abs()).sum();
            let missing = total - x.iter().sum::<f64>();
            if missing.abs() <= 1e-14 * magnitude.max(total.abs()) {
                return Ok(DenseMinimum { x, multiplier });
            }
            if missing > 0.0 {
                low = multiplier;
            } else {
                high = multiplier;
            }
            let (from, stiffness) = if self.marks.contains(&Mark::Free) {
                (multiplier, self.stiffness()?)
            } else {
                self.next_to_move(&x, missing > 0.0)
            };
            let newton = from + missing / stiffness;
            let next = if newton > low && newton < high {
                newton
            } else {
                0.5 * (low + high)
            };
            if (next - multiplier).abs() <= f64::EPSILON * multiplier.abs() {
                return Ok(DenseMinimum { x, multiplier });
            }
            if !next.is_finite() {
                // One bracket is still infinite and the Newton step violates the other bracket. The cause is round-off, or no
                // entry can move.
                let is_round_off = missing.abs() <= 1e-12 * magnitude.max(total.abs());
                return if is_round_off {
                    Ok(DenseMinimum { x, multiplier })
                } else {
                    Err(not_converged())
                };
            }
            multiplier = next;
        }
        Err(not_converged())
    }

    /// Returns the multiplier at which the first entry would leave its bound, and the stiffness of this entry. The
    /// search needs both values if no entry is free.
    fn next_to_move(&self, x: &[f64], upward: bool) -> (f64, f64) {
        let from = if upward { Mark::Lower } else { Mark::Upper };
        let sign = if upward { 1.0 } else { -1.0 };
        let movable = (0..x.len()).filter(|&i| {
            let [lower, upper] = self.bounds[i];
            lower < upper && self.marks[i] == from
        });
        let (least, row) = movable
            .map(|i| (sign * self.gradient(i, x), i))
            .fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a });
        (sign * least, 1.0 / self.operator.row(row)[row])
    }

    /// Returns `e' C_FF^-1 e`, the derivative of the total with respect to the multiplier.
    fn stiffness(&self) -> Result<f64> {
        let free = self.free();
        let ones = Mat::from_fn(free.len(), 1, |_, _| 1.0);
        Ok(self.factorise(&free)?.solve(&ones).col(0).iter().sum())
    }

    fn free(&self) -> Vec<usize> {
        (0..self.marks.len())
            .filter(|&i| self.marks[i] == Mark::Free)
            .collect()
    }

    /// Solves the equations of the free entries. The other entries are at their bounds.
    fn solve_free(&self, multiplier: f64) -> Result<Vec<f64>> {
        let mut x: Vec<f64> = (self.marks.iter().zip(&self.bounds))
            .map(|(mark, [lower, upper])| match mark {
                Mark::Free => 0.0,
                Mark::Lower => *lower,
                Mark::Upper => *upper,
            })
            .collect();
        let free = self.free();
        if !free.is_empty() {
            let right = Mat::from_fn(free.len(), 1, |k, _| {
                multiplier - self.gradient(free[k], &x)
            });
            let solution = self.factorise(&free)?.solve(&right);
            for (&i, value) in free.iter().zip(solution.col(0).iter()) {
                x[i] = *value;
            }
        }
        Ok(x)
    }

    /// Returns `(C x + b)_i`.
    fn gradient(&self, i: usize, x: &[f64]) -> f64 {
        let product: f64 = self.operator.row(i).iter().zip(x).map(|(c, x)| c * x).sum();
        product + self.linear[i]
    }

    fn factorise(&self, free: &[usize]) -> Result<Llt<f64>> {
        let block: Vec<f64> = free
            .iter()
            .flat_map(|&i| free.iter().map(move |&j| self.operator.row(i)[j]))
            .collect();
        let matrix = MatRef::from_row_major_slice(&block, free.len(), free.len());
        matrix
            .llt(Side::Lower)
            .map_err(
                |LltError::NonPositivePivot { index }| Error::NotPositiveDefinite {
                    row: free[index],
                },
            )
    }

    /// Returns the entries with a wrong mark in ascending order, each with its correct mark.
    fn wrong_marks(&self, x: &[f64], multiplier: f64) -> Vec<(usize, Mark)> {
        let largest = x.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
        let gradients: Vec<f64> = (0..x.len())
            .map(|i| self.gradient(i, x) - multiplier)
            .collect();
        let steepest = (gradients.iter().zip(self.linear))
            .fold(multiplier.abs(), |a, (g, b)| a.max(g.abs()).max(b.abs()));
        let (value_noise, gradient_noise) = (1e-15 * largest, 1e-15 * steepest);
        let correction = |i: usize| {
            let [lower, upper] = self.bounds[i];
            match self.marks[i] {
                _ if lower >= upper => None,
                Mark::Free if x[i] < lower - value_noise => Some(Mark::Lower),
                Mark::Free if x[i] > upper + value_noise => Some(Mark::Upper),
                Mark::Lower if gradients[i] < -gradient_noise => Some(Mark::Free),
                Mark::Upper if gradients[i] > gradient_noise => Some(Mark::Free),
                _ => None,
            }
        };
        (0..x.len())
            .filter_map(|i| correction(i).map(|mark| (i, mark)))
            .collect()
    }

    fn clip(&self, mut x: Vec<f64>) -> Vec<f64> {
        for (x, [lower, upper]) in x.iter_mut().zip(&self.bounds) {
            *x = x.max(*lower).min(*upper);
        }
        x
    }
}

fn not_converged() -> Error {
    Error::NotConverged(Box::new(Report {
        status: Status::Stalled,
        residual: f64::NAN,
        duality_gap: f64::INFINITY,
        ..Report::unsolved()
    }))
}
