//! An estimate of what the cells leave of a field's error.

use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::field::Field;
use crate::grid::neighbours::second_difference;
use crate::parallel::reduce;

/// The sum of the errors over that of the values, by the second differences of the parts of a vector field of a whole grid;
/// `None` for a slab or without any value.
pub(crate) fn estimate<const N: usize>(
    parts: [&Field; N],
    boundary: Boundary,
    cell_value: CellValue,
) -> Option<f64> {
    let grid = parts[0].grid();
    if grid != grid.whole() {
        return None;
    }
    let (size, repeats) = (grid.size(), boundary.repeats());
    let [curvature, sum] = reduce::sum(&grid.layout(), |i| {
        let (mut difference, mut value) = (0.0_f64, 0.0_f64);
        for part in parts.map(Field::as_slice) {
            difference = difference.hypot(second_difference(part, i, size, repeats));
            value = value.hypot(part[i]);
        }
        [difference, value]
    });
    // Of the means, on spheres, ellipses, quartics, rough surfaces and in partial slip.
    let factor = match (boundary, cell_value) {
        (Boundary::Periodic, _) => 1.25,
        (_, CellValue::Uniform) => 1.4,
        (_, CellValue::Centre) => 1.0,
    };
    let estimate = factor * curvature / (24.0 * sum);
    estimate.is_finite().then_some(estimate)
}
