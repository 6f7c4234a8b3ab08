//! Integrals far from the cell, computed with Taylor series of their kernels.

use crate::influence::integrals::{Cell, Integral};

/// Distance, in units of the longer side, beyond which the series replaces quadrature. The truncation error, measured against
/// values with 60 digits, is below 6e-16 of every integral.
const FAR: f64 = 20.0;

/// Number of pairs of derivatives in the series.
const PAIRS: usize = 5;

/// Number of exponents of a monomial along one axis. The exponent of a kernel is at most two, and each derivative adds
/// one.
const EXPONENTS: usize = 2 * PAIRS + 3;

/// Evaluation of an integral over a cell at the points of rows. Far from the cell the evaluation uses the series of the
/// kernel $`f`$ of the integral
///
/// ```math
/// 4 a b \sum_{i + j \le 5} \frac{a^{2 i}}{(2 i + 1)!} \frac{b^{2 j}}{(2 j + 1)!}
/// \partial_x^{2 i} \partial_y^{2 j} f(x, y) .
/// ```
///
/// All kernels are homogeneous of degree -1. The sum is therefore $`\sum_n s^n P_n(u)`$ with $`s = 1/r^2`$, $`u = x^2 s`$ and
/// polynomials $`P_n`$ of degree $`n + 1`$ or less. The factor of this sum is the product of the coordinates in which $`f`$ is
/// odd, divided by a power of $`r`$.
#[derive(Debug)]
pub(super) struct FarFieldSeries {
    cell: Cell,
    integral: Integral,
    /// Coefficients of each polynomial in ascending order of the powers.
    polynomials: [[f64; PAIRS + 2]; PAIRS + 1],
}

impl FarFieldSeries {
    pub(super) fn new(cell: Cell, integral: Integral) -> Self {
        let [a, b] = [cell.a, cell.b];
        let mut polynomials = [[0.0; PAIRS + 2]; PAIRS + 1];
        let mut along_x = Monomials::of(integral);
        let mut weight_x = 4.0 * a * b;
        for i in 0..=PAIRS {
            if i > 0 {
                along_x = along_x.derived(0).derived(0);
                weight_x *= a * a / (2 * i * (2 * i + 1)) as f64;
            }
            let (mut derivative, mut weight) = (along_x, weight_x);
            for j in 0..=PAIRS - i {
                if j > 0 {
                    derivative = derivative.derived(1).derived(1);
                    weight *= b * b / (2 * j * (2 * j + 1)) as f64;
                }
                derivative.add_to(&mut polynomials[i + j], weight);
            }
        }
        Self {
            cell,
            integral,
            polynomials,
        }
    }

    /// Computes the integral at the points `(x, y)` of a row, with ascending `x >= 0` and with `y >= 0`. The points can be near
    /// or far.
    pub(super) fn along_row(&self, xs: &[f64], y: f64, out: &mut [f64]) {
        let far = FAR * 2.0 * self.cell.a.max(self.cell.b);
        let near = xs.partition_point(|x| x.hypot(y) < far);
        self.cell
            .along_row(self.integral, &xs[..near], y, &mut out[..near]);
        self.far_along_row(&xs[near..], y, &mut out[near..]);
    }

    fn far_along_row(&self, xs: &[f64], y: f64, out: &mut [f64]) {
        match self.integral {
            Integral::Potential | Integral::AlongX => self.sum(xs, y, out, |_, s| s.sqrt()),
            Integral::Diagonal => self.sum(xs, y, out, |x, s| x * y * s * s.sqrt()),
            Integral::RadialX => self.sum(xs, y, out, |x, s| x * s),
            Integral::RadialY => self.sum(xs, y, out, |_, s| y * s),
        }
    }

    /// Computes the sum of `s^n P_n(u)` times a factor that depends on `x` and `s`.
    fn sum(&self, xs: &[f64], y: f64, out: &mut [f64], factor: impl Fn(f64, f64) -> f64) {
        for (out, &x) in out.iter_mut().zip(xs) {
            let s = 1.0 / (x * x + y * y);
            let u = x * x * s;
            let mut sum = 0.0;
            for (n, polynomial) in self.polynomials.iter().enumerate().rev() {
                let mut value = 0.0;
                for coefficient in polynomial[..n + 2].iter().rev() {
                    value = value * u + coefficient;
                }
                sum = sum * s + value;
            }
            *out = factor(x, s) * sum;
        }
    }
}

/// Derivative of a kernel: a sum of terms `c x^p y^q / r^m`, indexed by `[p][q]`. The exponent `m` is `p + q + 1` plus the order
/// of the derivative.
#[derive(Clone, Copy)]
struct Monomials {
    order: usize,
    coefficients: [[f64; EXPONENTS]; EXPONENTS],
}

impl Monomials {
    /// Creates the kernel itself.
    fn of(integral: Integral) -> Self {
        let mut coefficients = [[0.0; EXPONENTS]; EXPONENTS];
        let [p, q] = match integral {
            Integral::Potential => [0, 0],
            Integral::AlongX => [2, 0],
            Integral::Diagonal => [1, 1],
            Integral::RadialX => [1, 0],
            Integral::RadialY => [0, 1],
        };
        coefficients[p][q] = 1.0;
        Self {
            order: 0,
            coefficients,
        }
    }

    /// Returns the nonzero terms: exponents along x and y, and the coefficient.
    fn terms(&self) -> impl Iterator<Item = ([usize; 2], f64)> {
        let rows = self.coefficients.iter().enumerate();
        rows.flat_map(|(p, row)| row.iter().enumerate().map(move |(q, c)| ([p, q], *c)))
            .filter(|(_, c)| *c != 0.0)
    }

    /// Returns the derivative along an axis.
    fn derived(&self, axis: usize) -> Self {
        let mut coefficients = [[0.0; EXPONENTS]; EXPONENTS];
        for ([p, q], c) in self.terms() {
            let (power, exponent) = ((p + q + 1 + self.order) as f64, [p, q][axis]);
            let mut add = |exponent: usize, c: f64| {
                let mut place = [p, q];
                place[axis] = exponent;
                coefficients[place[0]][place[1]] += c;
            };
            if exponent > 0 {
                add(exponent - 1, exponent as f64 * c);
            }
            add(exponent + 1, -power * c);
        }
        Self {
            order: self.order + 1,
            coefficients,
        }
    }

    /// Adds the terms, times a weight, as a polynomial of `u`. Each term is `u^(p/2) (1 - u)^(q/2)`, with halves rounded
    /// down.
    fn add_to(&self, polynomial: &mut [f64], weight: f64) {
        for ([p, q], c) in self.terms() {
            let mut binomial = weight * c;
            for k in 0..=q / 2 {
                polynomial[p / 2 + k] += binomial;
                binomial *= -((q / 2 - k) as f64) / (k + 1) as f64;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks that the series and the quadrature give the same integral.
    #[test]
    fn series_equal_quadrature() {
        let integrals = [
            Integral::Potential,
            Integral::AlongX,
            Integral::Diagonal,
            Integral::RadialX,
            Integral::RadialY,
        ];
        let shapes = [[0.5, 0.5], [0.5, 0.35], [0.01, 0.5], [0.5, 1e-9]];
        for (integral, [a, b]) in integrals.into_iter().flat_map(|i| shapes.map(|s| (i, s))) {
            let cell = Cell { a, b };
            let series = FarFieldSeries::new(cell, integral);
            for distance in [FAR, 31.0, 260.0, 2e4, 1e9] {
                for turn in 0..=40 {
                    let angle = 0.025 * f64::from(turn) * std::f64::consts::FRAC_PI_2;
                    let [x, y] = [distance * angle.cos(), distance * angle.sin()];
                    let [x, y] = if turn == 40 { [0.0, y] } else { [x, y] };
                    let mut found = [0.0];
                    series.far_along_row(&[x], y, &mut found);
                    let expected = cell.at(integral, x, y);
                    // The error is relative to the integral of 1/R, as for the quadrature.
                    let error = (found[0] - expected).abs() / (4.0 * a * b / distance);
                    assert!(
                        error <= 4e-15,
                        "{integral:?} {a} {b} {distance} {turn}: {error:e}"
                    );
                }
            }
        }
    }

    /// Checks that rows start with the closed form or quadrature and continue with the series.
    #[test]
    fn rows_go_over_from_quadrature_to_series() {
        let xs: Vec<f64> = (0..60).map(f64::from).collect();
        for integral in [
            Integral::Potential,
            Integral::AlongX,
            Integral::Diagonal,
            Integral::RadialX,
            Integral::RadialY,
        ] {
            let cell = Cell { a: 0.5, b: 0.35 };
            let mut row = vec![0.0; xs.len()];
            FarFieldSeries::new(cell, integral).along_row(&xs, 3.0, &mut row);
            for (x, found) in xs.iter().zip(row) {
                let error = found - cell.at(integral, *x, 3.0);
                let scale = 4.0 * cell.a * cell.b / x.hypot(3.0);
                assert!(error.abs() <= 4e-15 * scale, "{integral:?} {x}: {error:e}");
            }
        }
    }

    /// Compares the series with values of 40 digits, for large integrals and for integrals that nearly vanish.
    #[test]
    fn series_keep_their_relative_accuracy() {
        for (integral, [a, b], [x, y], expected) in [
            (
                Integral::Potential,
                [0.5, 0.5],
                [20.0, 0.0],
                0.050_005_207_193_684_27,
            ),
            (
                Integral::AlongX,
                [0.5, 0.5],
                [0.0, 20.0],
                1.042_382_528_657_544e-5,
            ),
            (
                Integral::AlongX,
                [0.5, 0.35],
                [15.0, 14.0],
                0.018_230_644_983_524_13,
            ),
            (
                Integral::Diagonal,
                [0.5, 0.5],
                [0.5, 21.0],
                0.001_132_501_742_908_004_7,
            ),
            (
                Integral::RadialX,
                [0.01, 0.5],
                [17.0, 13.0],
                7.424_222_898_085_648e-4,
            ),
            (
                Integral::Potential,
                [0.5, 0.01],
                [260.0, 180.0],
                6.324_558_029_323_84e-5,
            ),
        ] {
            let mut found = [0.0];
            FarFieldSeries::new(Cell { a, b }, integral).far_along_row(&[x], y, &mut found);
            let error: f64 = found[0] / expected - 1.0;
            assert!(error.abs() <= 6e-16, "{integral:?}: {error:e}");
        }
    }
}
