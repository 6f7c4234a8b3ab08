//! Energies and displacements on the whole grid, by the public operators only.

use stickslip::dense::DenseOperator;
use stickslip::influence::Component;
use stickslip::{ElasticOperator, HalfSpace, Operator, Result};

/// Compliance for one traction component, or for two components in the plane (all x components, then all y components).
#[derive(Debug)]
pub(crate) struct Compliance {
    cells: usize,
    blocks: usize,
    /// Row, column, and the operator between them.
    parts: Vec<(usize, usize, ElasticOperator)>,
    /// Lower bound of the eigenvalues. For the vector model it is the bound of single axes, which may be slightly
    /// larger.
    pub(crate) lower_bound: f64,
    /// Round-off of a product relative to its largest value, including the round-off of the coefficients.
    pub(crate) round_off: f64,
}

impl Compliance {
    pub(crate) fn of(bodies: &HalfSpace, components: &[Component]) -> Result<Self> {
        let place = |component: &Component| match component {
            Component::XY => (0, 1),
            Component::YX => (1, 0),
            Component::YY if components.len() > 1 => (1, 1),
            _ => (0, 0),
        };
        let mut parts = Vec::new();
        let mut lower_bound = f64::INFINITY;
        for component in components {
            let (row, column) = place(component);
            let operator = bodies.operator(*component)?;
            if row == column {
                lower_bound = lower_bound.min(operator.lower_bound());
            }
            parts.push((row, column, operator));
        }
        let blocks = if parts.len() > 1 { 2 } else { 1 };
        Ok(Self {
            cells: bodies.grid().cells(),
            blocks,
            parts,
            lower_bound,
            // The tables of layers are accurate to 1e-13.
            round_off: if bodies.pair().is_coated() {
                1e-13
            } else {
                16.0 * f64::EPSILON
            },
        })
    }

    pub(crate) fn pressure(bodies: &HalfSpace) -> Result<Self> {
        Self::of(bodies, &[Component::ZZ])
    }

    /// Returns the compliance along an axis, or in the plane.
    pub(crate) fn shear(bodies: &HalfSpace, axis: Option<usize>) -> Result<Self> {
        match axis {
            Some(0) => Self::of(bodies, &[Component::XX]),
            Some(_) => Self::of(bodies, &[Component::YY]),
            None => Self::of(
                bodies,
                &[Component::XX, Component::XY, Component::YX, Component::YY],
            ),
        }
    }

    pub(crate) fn cells(&self) -> usize {
        self.cells
    }

    pub(crate) fn product(&self, x: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.blocks * self.cells];
        let mut part = vec![0.0; self.cells];
        for (row, column, operator) in &self.parts {
            let traction = &x[column * self.cells..][..self.cells];
            operator.apply([traction], [&mut part], &mut operator.scratch().unwrap());
            for (sum, part) in sum[row * self.cells..].iter_mut().zip(&part) {
                *sum += part;
            }
        }
        sum
    }

    /// Returns the smallest eigenvalue for unknowns whose components have zero sums, from a dense matrix. The cost grows with the
    /// cube of the number of unknowns.
    pub(crate) fn bound_without_sums(&self) -> f64 {
        let len = self.blocks * self.cells;
        let centre = |v: &mut [f64]| {
            for part in v.chunks_mut(self.cells) {
                let mean = part.iter().sum::<f64>() / part.len() as f64;
                for v in part {
                    *v -= mean;
                }
            }
        };
        let mut entries = Vec::with_capacity(len * len);
        for k in 0..len {
            let mut unit = vec![0.0; len];
            unit[k] = 1.0;
            centre(&mut unit);
            let mut row = self.product(&unit);
            centre(&mut row);
            entries.extend(row);
        }
        // The trace exceeds all eigenvalues. It becomes the eigenvalue of uniform components.
        let trace: f64 = (0..len).map(|k| entries[k * len + k]).sum();
        for (k, row) in entries.chunks_mut(len).enumerate() {
            let part = k / self.cells * self.cells;
            let uniform = trace / self.cells as f64;
            for u in &mut row[part..part + self.cells] {
                *u += uniform;
            }
        }
        let matrix = DenseOperator::from_rows(len, entries);
        matrix.map_or(0.0, |matrix| matrix.lower_bound())
    }

    /// Returns `sqrt(x' C x)`.
    pub(crate) fn norm(&self, x: &[f64]) -> f64 {
        dot(x, &self.product(x)).max(0.0).sqrt()
    }
}

pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
