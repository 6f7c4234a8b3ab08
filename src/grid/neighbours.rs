//! Neighbours of a cell, which share a side with the cell, and the second difference of a field over these neighbours.

/// Returns the cells to the left, below, to the right and above a cell of an `nx` x `ny` grid. Beyond an edge the entry
/// is `None`, or the periodic image.
pub(crate) fn neighbours(i: usize, [nx, ny]: [usize; 2], repeats: [bool; 2]) -> [Option<usize>; 4] {
    let (ix, last_row) = (i % nx, nx * (ny - 1));
    let step = |axis: usize, is_inside: bool, next: usize, image: usize| {
        if is_inside {
            Some(next)
        } else {
            repeats[axis].then_some(image)
        }
    };
    [
        step(0, ix > 0, i.wrapping_sub(1), i + nx - 1),
        step(1, i >= nx, i.wrapping_sub(nx), i + last_row),
        step(0, ix + 1 < nx, i + 1, i - ix),
        step(1, i < last_row, i + nx, ix),
    ]
}

/// Returns the sum of a field over the four neighbours minus four times the value of the cell. Beyond an edge the field
/// is zero.
pub(crate) fn second_difference(
    field: &[f64],
    i: usize,
    size: [usize; 2],
    repeats: [bool; 2],
) -> f64 {
    let [left, below, right, above] =
        neighbours(i, size, repeats).map(|next| next.map_or(0.0, |next| field[next]));
    (left + right) + (below + above) - 4.0 * field[i]
}
