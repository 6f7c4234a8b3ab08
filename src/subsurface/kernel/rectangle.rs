//! The loaded rectangle in any unit of length.

use super::cell::LoadedCell;
use super::integral::PotentialIntegral;

/// Cell of half sides `a` along x and `b` along y, centred on the origin of the surface `z = 0`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LoadedRectangle {
    /// Cell in units of its size, so that no power of a length overflows.
    cell: LoadedCell,
    /// Largest power of two that does not exceed the longer side. Division by a power of two is exact, so a point very
    /// close to an edge keeps its distance from the edge.
    unit: f64,
}

impl LoadedRectangle {
    /// Creates a cell of half sides `a` and `b` (lengths). All results are NaN unless both half sides are positive and
    /// finite. Displacements and stresses that are computed from the integrals have errors of about 1e-15 of the
    /// largest displacement or stress at the point.
    pub(crate) fn new(a: f64, b: f64) -> Self {
        let is_valid = a > 0.0 && b > 0.0 && a.is_finite() && b.is_finite();
        let [a, b] = if is_valid { [a, b] } else { [f64::NAN; 2] };
        let longer = 2.0 * a.max(b);
        // Clearing the mantissa bits leaves a power of two.
        let unit = f64::from_bits(longer.to_bits() & f64::INFINITY.to_bits());
        let (a, b) = (a / unit, b / unit);
        let cell = LoadedCell {
            a,
            b,
            unit: a.max(b),
        };
        Self { cell, unit }
    }

    /// Computes the integrals at the points `(x, y, z)` of a row (lengths, `z >= 0`). The result has one slice for each
    /// integral, in the order of [`PotentialIntegral::index`]. The result at a point does not depend on the other
    /// points. Points beyond the end of the shortest slice are ignored.
    pub(crate) fn integrals_along_row(
        &self,
        xs: &[f64],
        y: f64,
        z: f64,
        out: &mut [&mut [f64]; PotentialIntegral::COUNT],
    ) {
        let count = out.iter().map(|row| row.len()).fold(xs.len(), usize::min);
        let scaled: Vec<f64> = xs[..count].iter().map(|x| x / self.unit).collect();
        self.cell
            .along_row(&scaled, [y / self.unit, z / self.unit], out);
        for row in &mut out[..PotentialIntegral::LENGTHS] {
            for value in &mut row[..count] {
                *value *= self.unit;
            }
        }
    }
}

#[cfg(test)]
impl LoadedRectangle {
    /// Returns the integrals at `[x, y, z]` (lengths, `z >= 0`), in the order of [`PotentialIntegral::index`].
    pub(super) fn integrals(&self, point: [f64; 3]) -> [f64; PotentialIntegral::COUNT] {
        let mut values = self.cell.at(point.map(|length| length / self.unit));
        for value in &mut values[..PotentialIntegral::LENGTHS] {
            *value *= self.unit;
        }
        values
    }
}
