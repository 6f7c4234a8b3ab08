//! Interpolation at Chebyshev nodes on an interval that consists of equal cells.

use std::array::from_fn;
use std::f64::consts::PI;

use crate::error::Result;
use crate::memory::fallible;
use crate::numerics::gauss::GAUSS_12;

/// Number of nodes along each axis of a block.
pub(super) const NODES: usize = 24;

/// Value per node.
pub(super) type PerNode = [f64; NODES];

/// Returns the nodes on [-1, 1].
pub(super) fn nodes() -> PerNode {
    from_fn(|k| ((2 * k + 1) as f64 * PI / (2 * NODES) as f64).cos())
}

/// Returns the Chebyshev polynomials of degree 0 to `NODES - 1`.
fn polynomials(x: f64) -> PerNode {
    let mut values = [1.0; NODES];
    values[1] = x;
    for j in 2..NODES {
        values[j] = 2.0 * x * values[j - 1] - values[j - 2];
    }
    values
}

/// Returns the integrals of the cardinal function of each node over each cell of an interval. The cells have the given
/// half side. A cardinal function is one at its node and zero at the others.
pub(super) fn integrals(cells: usize, half_side: f64) -> Result<Vec<PerNode>> {
    let at_nodes = nodes().map(polynomials);
    let half = 1.0 / cells as f64;
    let of_cell = |cell: usize| {
        let middle = (2 * cell + 1) as f64 * half - 1.0;
        let mut sums = [0.0; NODES];
        // This rule is exact for polynomials of degree 23.
        for [node, weight] in GAUSS_12 {
            for (sum, value) in sums.iter_mut().zip(polynomials(middle + half * node)) {
                *sum += weight * value;
            }
        }
        // The polynomial of degree zero has half the weight of the others.
        sums[0] *= 0.5;
        at_nodes.map(|polynomials| {
            let mut integral = 0.0;
            for (sum, polynomial) in sums.iter().zip(polynomials) {
                integral += sum * polynomial;
            }
            2.0 / NODES as f64 * half_side * integral
        })
    };
    fallible::collected(cells, (0..cells).map(of_cell))
}
