//! The edge as straight pieces.

use std::collections::HashMap;

use crate::buffer;
use crate::error::Result;
use crate::grid::Grid;
use crate::neighbours::neighbours;

/// Distances of the corners of a cell inside the edge, counter-clockwise from the first one of both axes.
pub(super) type Corners = [f64; 4];

/// The zero of the distances, which cells that share a corner average there; around cells without any, the sides at the edge
/// of the set.
pub(super) fn outline(
    grid: Grid,
    repeats: [bool; 2],
    cells: impl Iterator<Item = (usize, Option<Corners>)> + Clone,
    contains: impl Fn(usize) -> bool,
) -> Result<Vec<[[f64; 2]; 2]>> {
    let size @ [nx, ny] = grid.size();
    let corner = |cell: usize, which: usize| {
        let (column, row) = (cell % nx, cell / nx);
        let (column, row) = (column + [0, 1, 1, 0][which], row + [0, 0, 1, 1][which]);
        let round =
            |place: usize, count: usize, repeats| if repeats { place % count } else { place };
        round(row, ny, repeats[1]) * (nx + 1) + round(column, nx, repeats[0])
    };
    let mut sums: HashMap<usize, [f64; 2]> = HashMap::new();
    for (cell, corners) in cells.clone() {
        for (which, distance) in corners.iter().flatten().enumerate() {
            let sum = sums.entry(corner(cell, which)).or_default();
            // Far from the edge a distance is a guess, and of no use but for its sign.
            sum[0] += distance.clamp(-2.0, 2.0);
            sum[1] += 1.0;
        }
    }
    let half = [0.5 * grid.dx(), 0.5 * grid.dy()];
    let place = |cell: usize, which: usize| {
        let [x, y] = grid.position(cell % nx, cell / nx);
        [
            x + [-1.0, 1.0, 1.0, -1.0][which] * half[0],
            y + [-1.0, -1.0, 1.0, 1.0][which] * half[1],
        ]
    };
    let mut pieces = Vec::new();
    let is_fitted = |cell: usize| (0..4).all(|which| sums.contains_key(&corner(cell, which)));
    for (cell, corners) in cells {
        if corners.is_some() {
            let mean = |which| {
                let [sum, count] = sums
                    .get(&corner(cell, which))
                    .copied()
                    .unwrap_or([0.0, 1.0]);
                sum / count
            };
            let ends = [0, 1, 2, 3].map(|which| (place(cell, which), mean(which)));
            for piece in pieces_within(&ends).into_iter().flatten() {
                buffer::push(&mut pieces, piece)?;
            }
        } else if contains(cell) {
            // Left, below, right and above.
            let sides = [[3, 0], [0, 1], [1, 2], [2, 3]];
            for (next, side) in neighbours(cell, size, repeats).into_iter().zip(sides) {
                if next.is_none_or(|next| !contains(next) && !is_fitted(next)) {
                    buffer::push(&mut pieces, side.map(|which| place(cell, which)))?;
                }
            }
        }
    }
    Ok(pieces)
}

/// The pieces in a cell with these corners: none, one or, where opposite corners are alike, two.
fn pieces_within(ends: &[([f64; 2], f64); 4]) -> [Option<[[f64; 2]; 2]>; 2] {
    // Where the edge crosses the sides, in order.
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
    // The middle tells which two corners are cut off.
    let middle: f64 = ends.iter().map(|(_, distance)| distance).sum();
    if (middle > 0.0) == (ends[0].1 > 0.0) {
        [join(first, second), join(third, fourth)]
    } else {
        [join(fourth, first), join(second, third)]
    }
}
