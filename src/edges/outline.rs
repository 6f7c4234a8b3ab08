//! The edge as a list of straight pieces.

use std::collections::HashMap;

use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::grid::neighbours::neighbours;
use crate::memory::fallible;

/// Signed distances of the corners of a cell from the edge (positive inside). The corners are in counter-clockwise order from the
/// corner with the smallest x and y.
pub(super) type Corners = [f64; 4];

/// Returns the zero line of the distances. The distance at a corner is the mean over the cells around the corner. Around cells
/// without a fit, the pieces are the cell sides at the edge of the set. The cells must be sorted by index.
pub(super) fn outline(
    grid: Grid,
    repeats: [bool; 2],
    cells: &[(usize, Option<Corners>)],
    contains: impl Fn(usize) -> bool,
) -> Result<Vec<[[f64; 2]; 2]>> {
    let size = grid.size();
    let means = Means::new(grid, repeats, cells)?;
    let mut pieces = Vec::new();
    let mut beside = Vec::new();
    for (cell, corners) in cells {
        if corners.is_some() {
            means.add_pieces(*cell, &contains, &mut pieces)?;
            // The edge can also cut off a corner of a cell if all its neighbours are on the same side of the edge.
            let is_new =
                |next: &usize| cells.binary_search_by_key(next, |(cell, _)| *cell).is_err();
            let around = neighbours(*cell, size, repeats).into_iter().flatten();
            for next in around.filter(is_new) {
                fallible::push(&mut beside, next)?;
            }
        } else if contains(*cell) {
            // The sides are left, below, right and above.
            let sides = [[3, 0], [0, 1], [1, 2], [2, 3]];
            for (next, side) in neighbours(*cell, size, repeats).into_iter().zip(sides) {
                if next.is_none_or(|next| !contains(next) && !means.has_all_of(next)) {
                    let piece = side.map(|which| means.place(*cell, which));
                    fallible::push(&mut pieces, piece)?;
                }
            }
        }
    }
    beside.sort_unstable();
    beside.dedup();
    for cell in beside {
        means.add_pieces(cell, &contains, &mut pieces)?;
    }
    Ok(pieces)
}

/// Mean distances at the corners of fitted cells.
struct Means {
    grid: Grid,
    repeats: [bool; 2],
    /// Sum and number of the distances at each corner.
    sums: HashMap<usize, [f64; 2]>,
}

/// Largest distance that is used, in cells. Only the sign of larger distances is reliable.
const FAR: f64 = 2.0;

impl Means {
    fn new(grid: Grid, repeats: [bool; 2], cells: &[(usize, Option<Corners>)]) -> Result<Self> {
        let mut means = Self {
            grid,
            repeats,
            sums: HashMap::new(),
        };
        let corners = cells
            .iter()
            .filter(|(_, corners)| corners.is_some())
            .count()
            * 4;
        let room = means.sums.try_reserve(corners);
        room.map_err(|_| Error::Memory {
            quantity: "a table of the corners at an edge",
            bytes: corners as u128 * size_of::<(usize, [f64; 2])>() as u128,
        })?;
        for (cell, corners) in cells {
            for (which, distance) in corners.iter().flatten().enumerate() {
                let sum = means.sums.entry(means.corner(*cell, which)).or_default();
                sum[0] += distance.clamp(-FAR, FAR);
                sum[1] += 1.0;
            }
        }
        Ok(means)
    }

    /// Returns the index of a corner of a cell. The index is the same for all cells around this corner.
    fn corner(&self, cell: usize, which: usize) -> usize {
        let [nx, ny] = self.grid.size();
        let (column, row) = (
            cell % nx + [0, 1, 1, 0][which],
            cell / nx + [0, 0, 1, 1][which],
        );
        let round = |place: usize, count, repeats| if repeats { place % count } else { place };
        let column = round(column, nx, self.repeats[0]);
        round(row, ny, self.repeats[1]) * (nx + 1) + column
    }

    fn place(&self, cell: usize, which: usize) -> [f64; 2] {
        let grid = self.grid;
        let [x, y] = grid.position(cell % grid.nx(), cell / grid.nx());
        [
            x + [-0.5, 0.5, 0.5, -0.5][which] * grid.dx(),
            y + [-0.5, -0.5, 0.5, 0.5][which] * grid.dy(),
        ]
    }

    fn has_all_of(&self, cell: usize) -> bool {
        (0..4).all(|which| self.sums.contains_key(&self.corner(cell, which)))
    }

    fn add_pieces(
        &self,
        cell: usize,
        contains: &impl Fn(usize) -> bool,
        pieces: &mut Vec<[[f64; 2]; 2]>,
    ) -> Result<()> {
        let unknown = if contains(cell) { FAR } else { -FAR };
        let ends = [0, 1, 2, 3].map(|which| {
            let sum = self.sums.get(&self.corner(cell, which));
            let distance = sum.map_or(unknown, |[sum, count]| sum / count);
            (self.place(cell, which), distance)
        });
        for piece in pieces_within(&ends).into_iter().flatten() {
            fallible::push(pieces, piece)?;
        }
        Ok(())
    }
}

/// Returns the pieces in a cell with these corners. There are at most two pieces, and two only if opposite corners have the same
/// sign.
fn pieces_within(ends: &[([f64; 2], f64); 4]) -> [Option<[[f64; 2]; 2]>; 2] {
    // The array holds the points at which the edge crosses the sides, in order.
    let mut crossings = [None; 4];
    let mut count = 0;
    for side in 0..4 {
        let ((from, a), (to, b)) = (ends[side], ends[(side + 1) % 4]);
        if (a > 0.0) != (b > 0.0) {
            let part = a / (a - b);
            crossings[count] = Some([0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis])));
            count += 1;
        }
    }
    let [first, second, third, fourth] = crossings;
    let join = |a: Option<_>, b: Option<_>| a.zip(b).map(|(a, b)| [a, b]);
    if count < 4 {
        return [join(first, second), None];
    }
    // The sign at the middle determines which two corners are cut off.
    let middle: f64 = ends.iter().map(|(_, distance)| distance).sum();
    if (middle > 0.0) == (ends[0].1 > 0.0) {
        [join(first, second), join(third, fourth)]
    } else {
        [join(fourth, first), join(second, third)]
    }
}
