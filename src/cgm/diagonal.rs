//! The compliance that cells have of their own beside the operator.

use crate::numerics::cell_vector::plus;

/// A symmetric tensor of each cell: a multiple of one and, of two components, a part without trace.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct CellCompliance<'a> {
    /// The mean of all directions; empty if no cell has a compliance of its own.
    mean: &'a [f64],
    /// `[a, b]` of the matrix of the rows `[a, b]` and `[b, -a]`; empty if it is zero in all cells.
    deviator: &'a [[f64; 2]],
}

impl<'a> CellCompliance<'a> {
    pub(crate) fn new(mean: &'a [f64], deviator: &'a [[f64; 2]]) -> Self {
        Self { mean, deviator }
    }

    /// The same in all directions.
    pub(crate) fn isotropic(mean: &'a [f64]) -> Self {
        Self::new(mean, &[])
    }

    /// Whether no cell has any.
    pub(crate) fn is_none(&self) -> bool {
        self.mean.is_empty()
    }

    pub(crate) fn parts(&self) -> (&'a [f64], &'a [[f64; 2]]) {
        (self.mean, self.deviator)
    }

    /// The mean of all directions in a cell.
    pub(crate) fn mean(&self, cell: usize) -> f64 {
        self.mean.get(cell).copied().unwrap_or(0.0)
    }

    /// `[a, b]` of the matrix of the rows `[a, b]` and `[b, -a]` in a cell.
    pub(crate) fn deviator(&self, cell: usize) -> [f64; 2] {
        self.deviator.get(cell).copied().unwrap_or_default()
    }

    /// Adds a multiple of what it displaces a cell with these tractions, if there is any.
    #[inline]
    pub(crate) fn added<const N: usize>(
        &self,
        u: [f64; N],
        part: f64,
        cell: usize,
        q: [f64; N],
    ) -> [f64; N] {
        let mut added = plus(u, part * self.mean(cell), q);
        if let (2, Some([a, b])) = (N, self.deviator.get(cell)) {
            added[0] += part * (a * q[0] + b * q[1]);
            added[1] += part * (b * q[0] - a * q[1]);
        }
        added
    }
}
