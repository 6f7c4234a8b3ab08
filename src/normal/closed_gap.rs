//! Recognition of a gap under load that was passed as the gap before loading.

use crate::cgm::reduce;
use crate::half_space::HalfSpace;

/// Largest gap of a closed cell, relative to the displacement. Solves of adaptive contacts leave gaps of this size.
pub(super) const CLOSED: f64 = 1e-5;
/// Smallest gap of a closed cell, relative to the largest gap. Smaller gaps of a flat surface are round-off.
const ROUND_OFF: f64 = 4.0 * f64::EPSILON;
/// Least part of the contact cells that are closed in a gap under load.
const CLOSED_PART: f64 = 0.2;
/// Least ratio of the gap next to a closed cell to the gap of this cell. Gaps of smooth surfaces grow more slowly.
const STEP: f64 = 100.0;
/// Least second difference of the gap along a row or column of closed cells, relative to the gap. Residuals of a solve are rougher
/// than this value, and small wear is smoother.
const ROUGH: f64 = 0.1;
/// Largest gap next to a closed cell, relative to the displacement. The gap at the edge of a punch is larger.
const NEAR: f64 = 0.1;

/// Returns the number of contact cells with almost closed gaps if the gap before loading resembles a gap under load. Otherwise
/// returns zero. `largest` is the largest pressure. `cells` are the number of contact cells, and an upper bound of the closed ones
/// for a displacement up to the size of the grid.
///
/// The gap under load is almost zero in the contact, where it varies like the residuals of a solve. Next to the contact it is much
/// larger, but still small compared with the displacement. Almost flat surfaces do not have all these properties. On a grid that is
/// periodic along both axes, all cells can be closed. Neighbours on different ranks do not count.
pub(super) fn closed_cells(
    bodies: &HalfSpace,
    (gap, pressure): (&[f64], &[f64]),
    largest: f64,
    [contact, possibly_closed]: [usize; 2],
) -> usize {
    let is_large = |closed: usize| closed as f64 >= CLOSED_PART * contact as f64;
    if contact == 0 || !is_large(possibly_closed) {
        return 0;
    }
    let (grid, layout) = (bodies.grid(), bodies.grid_layout());
    let [nx, ny] = grid.size();
    let extent = match grid.whole().size() {
        [_, 1] => contact as f64 * grid.dx(),
        [1, _] => contact as f64 * grid.dy(),
        _ => (contact as f64 * grid.cell_area()).sqrt(),
    };
    let displacement = largest * extent / bodies.pair().contact_modulus();
    let round_off = ROUND_OFF * reduce::max(&layout, |cell| gap[cell].abs());
    let is_small = |cell: usize| gap[cell].abs() < CLOSED * displacement;
    let is_closed = |cell: usize| gap[cell].abs() > round_off && is_small(cell);
    let [closed, open, edges, triples, rough] = reduce::sum(&layout, |cell| {
        let mut counts = [0; 5];
        if pressure[cell] <= 0.0 || !is_closed(cell) {
            return counts;
        }
        counts[0] = 1;
        let (column, row) = (cell % nx, cell / nx);
        let neighbours = [
            (column > 0).then(|| cell - 1),
            (column + 1 < nx).then_some(cell + 1),
            (row > 0).then(|| cell - nx),
            (row + 1 < ny).then_some(cell + nx),
        ];
        for next in neighbours.into_iter().flatten() {
            if !is_small(next) {
                counts[1] += 1;
                let is_edge = gap[next] > STEP * gap[cell].abs() && gap[next] < NEAR * displacement;
                counts[2] += usize::from(is_edge);
            }
        }
        let [left, right, below, above] = neighbours;
        for (before, after) in [left.zip(right), below.zip(above)].into_iter().flatten() {
            if is_closed(before) && is_closed(after) {
                let second = (gap[before] + gap[after] - 2.0 * gap[cell]).abs();
                counts[3] += 1;
                counts[4] += usize::from(second > ROUGH * gap[cell].abs());
            }
        }
        counts
    });
    let is_whole = open == 0 && bodies.boundary().repeats() == [true; 2];
    let is_rough = triples == 0 || 2 * rough > triples;
    if is_large(closed) && is_rough && (is_whole || 2 * edges > open) {
        closed
    } else {
        0
    }
}
