//! The integrals at points and along rows of points.

use super::far;
use super::integral::{PotentialIntegral, Values, sign};
use super::piece::{CellPart, Extent};
use crate::numerics::gauss::QuadratureRule;

/// Cell of half sides `a` and `b`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LoadedCell {
    pub(super) a: f64,
    pub(super) b: f64,
    /// Length that replaces a zero distance inside a logarithm.
    pub(super) unit: f64,
}

/// Number of points of a row that are integrated together in vector registers.
const LANES: usize = 4;

impl LoadedCell {
    /// Returns the integrals at a point with `z >= 0`.
    pub(super) fn at(&self, [x, y, z]: [f64; 3]) -> Values {
        let Self { a, b, unit } = *self;
        // Computing in one quadrant makes the parity exact.
        let (x_abs, y_abs) = (x.abs(), y.abs());
        let mut values = if let Some(rule) = self.rule([x, y, z]) {
            far::integrals([a, b], rule, &[x_abs], [y_abs, z]).map(|[value]| value)
        } else {
            let (x, y) = (Extent::new(x_abs, a), Extent::new(y_abs, b));
            CellPart { x, y, z, unit }.integrals()
        };
        for (value, integral) in values.iter_mut().zip(PotentialIntegral::ALL) {
            *value *= sign(integral, [x, y]);
        }
        values
    }

    /// Computes the integrals at the points of a row, bitwise identical to the results of [`at`](Self::at).
    pub(super) fn along_row(
        &self,
        xs: &[f64],
        [y, z]: [f64; 2],
        out: &mut [&mut [f64]; PotentialIntegral::COUNT],
    ) {
        let mut done = 0;
        while let Some(&x) = xs.get(done) {
            let Some(rule) = self.rule([x, y, z]) else {
                for (row, value) in out.iter_mut().zip(self.at([x, y, z])) {
                    row[done] = value;
                }
                done += 1;
                continue;
            };
            // These points share a quadrature rule. Copies of the first point fill the rest of the block.
            let mut block = [x.abs(); LANES];
            let rest = xs[done..].iter().take(LANES);
            let count = rest
                .take_while(|&&x| {
                    self.rule([x, y, z])
                        .is_some_and(|other| other.len() == rule.len())
                })
                .zip(&mut block)
                .map(|(x, place)| *place = x.abs())
                .count();
            let sums = far::integrals([self.a, self.b], rule, &block, [y.abs(), z]);
            for ((row, sums), integral) in out.iter_mut().zip(sums).zip(PotentialIntegral::ALL) {
                for ((value, sum), &x) in
                    row[done..].iter_mut().zip(&sums[..count]).zip(&xs[done..])
                {
                    *value = sum * sign(integral, [x, y]);
                }
            }
            done += count;
        }
    }

    fn rule(&self, point: [f64; 3]) -> Option<QuadratureRule> {
        far::rule([self.a, self.b], point)
    }
}
