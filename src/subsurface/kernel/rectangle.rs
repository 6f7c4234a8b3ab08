//! The loaded rectangle, in any unit of length.

use super::cell::Cell;
use super::integral::Integral;

/// A cell of half sides `a` along x and `b` along y, centred on the origin of the surface `z = 0`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LoadedRectangle {
    /// The cell in units of its size, so that no power of a length overflows.
    cell: Cell,
    /// The greatest power of two that is not above the longer side. Division by it is exact, so a point very close to
    /// an edge keeps its distance from it.
    unit: f64,
}

impl LoadedRectangle {
    /// A cell of half sides `a` and `b` (lengths), positive and finite; otherwise all results are NaN. Displacements
    /// and stresses composed of its integrals have errors of about 1e-15 of the largest one at the point.
    pub(crate) fn new(a: f64, b: f64) -> Self {
        let is_valid = a > 0.0 && b > 0.0 && a.is_finite() && b.is_finite();
        let [a, b] = if is_valid { [a, b] } else { [f64::NAN; 2] };
        let longer = 2.0 * a.max(b);
        // The mantissa bits are cleared.
        let unit = f64::from_bits(longer.to_bits() & f64::INFINITY.to_bits());
        let (a, b) = (a / unit, b / unit);
        let cell = Cell {
            a,
            b,
            unit: a.max(b),
        };
        Self { cell, unit }
    }

    /// The integrals at the points `(x, y, z)` of a row (lengths, `z >= 0`), one slice for each by
    /// [`Integral::index`], each point evaluated as if it were alone. Points beyond the end of the
    /// shortest slice are left out.
    pub(crate) fn integrals_along_row(
        &self,
        xs: &[f64],
        y: f64,
        z: f64,
        out: &mut [&mut [f64]; Integral::COUNT],
    ) {
        let count = out.iter().map(|row| row.len()).fold(xs.len(), usize::min);
        let scaled: Vec<f64> = xs[..count].iter().map(|x| x / self.unit).collect();
        self.cell
            .along_row(&scaled, [y / self.unit, z / self.unit], out);
        for row in &mut out[..Integral::LENGTHS] {
            for value in &mut row[..count] {
                *value *= self.unit;
            }
        }
    }
}

#[cfg(test)]
impl LoadedRectangle {
    /// The integrals at `[x, y, z]` (lengths, `z >= 0`), by [`Integral::index`].
    pub(super) fn integrals(&self, point: [f64; 3]) -> [f64; Integral::COUNT] {
        let mut values = self.cell.at(point.map(|length| length / self.unit));
        for value in &mut values[..Integral::LENGTHS] {
            *value *= self.unit;
        }
        values
    }
}
