//! Additional compliance of the cells: the diagonal term `D` of `C + D`.

use crate::numerics::cell_vector::plus;

/// A symmetric tensor per cell: a multiple of the identity and, for two components, a traceless part.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct CellCompliance<'a> {
    /// Mean over all directions. The slice is empty if no cell has an additional compliance.
    mean: &'a [f64],
    /// Entries `[a, b]` of the matrix with the rows `[a, b]` and `[b, -a]`. The slice is empty if the matrix is zero in all
    /// cells.
    deviator: &'a [[f64; 2]],
}

impl<'a> CellCompliance<'a> {
    pub(crate) fn new(mean: &'a [f64], deviator: &'a [[f64; 2]]) -> Self {
        Self { mean, deviator }
    }

    /// Creates isotropic tensors, with the same compliance in all directions.
    pub(crate) fn isotropic(mean: &'a [f64]) -> Self {
        Self::new(mean, &[])
    }

    /// Returns whether no cell has an additional compliance.
    pub(crate) fn is_none(&self) -> bool {
        self.mean.is_empty()
    }

    pub(crate) fn parts(&self) -> (&'a [f64], &'a [[f64; 2]]) {
        (self.mean, self.deviator)
    }

    /// Returns the mean over all directions in a cell.
    pub(crate) fn mean(&self, cell: usize) -> f64 {
        self.mean.get(cell).copied().unwrap_or(0.0)
    }

    /// Returns `[a, b]` of the matrix with the rows `[a, b]` and `[b, -a]` in a cell.
    pub(crate) fn deviator(&self, cell: usize) -> [f64; 2] {
        self.deviator.get(cell).copied().unwrap_or_default()
    }

    /// Returns `u` plus `part` times the displacement of a cell by its own compliance under the tractions `q`.
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
