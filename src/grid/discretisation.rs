//! Estimate of the discretisation error of a field.

use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::field::Field;
use crate::grid::neighbours::second_difference;
use crate::parallel::reduce;

/// Estimates the sum of the errors divided by the sum of the values, for a vector field with the given components. The
/// estimate uses the second differences of the field. Returns `None` if the field covers only a slab of the grid, or if
/// all values are zero.
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
    // The factors are means over spheres, ellipses, quartics, rough surfaces and partial slip.
    let factor = match (boundary, cell_value) {
        (Boundary::Periodic, _) => 1.25,
        (_, CellValue::Uniform) => 1.4,
        (_, CellValue::Centre) => 1.0,
    };
    let estimate = factor * curvature / (24.0 * sum);
    estimate.is_finite().then_some(estimate)
}
