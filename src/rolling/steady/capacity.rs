//! The moment that friction holds.

use std::iter::successors;

use crate::numerics::cell_vector::dot;
use crate::rolling::RollingProblem;
use crate::tangential::centre;

/// Steps of Newton's method, and halvings of each: whatever is reached by then is a bound.
const STEPS: usize = 60;
/// Lengths that round the kinks of the bound off, as parts of the mean lever of the limits, one after the other.
const ROUNDINGS: [f64; 4] = [1e-1, 1e-3, 1e-5, 1e-7];
/// Sum of the tractions, relative to that of the limits, that counts as none.
const BALANCED: f64 = 1e-13;
/// Part of the expected decrease that a step has to bring.
const DECREASE: f64 = 1e-4;

/// Tractions at their limits m along $`v = t + c`$, the motion by a turn t and by a shift c, whose length is rounded to
/// $`\sqrt{v^2 + \epsilon^2}`$.
#[derive(Debug, Default)]
struct Sliding {
    /// The sum of m times the length.
    bound: f64,
    /// Their sums.
    sums: [f64; 2],
    /// Derivatives of the sums by c: `[xx, xy, yy]`.
    stiffness: [f64; 3],
}

impl RollingProblem {
    /// The largest moment about the origin of the grid, times the sign, beside prescribed sums of the tractions.
    ///
    /// Of tractions within their limits m whose sums are f along some axes,
    /// $`\sum q \cdot t \le \sum m |t + c| - c \cdot f`$ for every shift c along those axes; the least of these bounds is
    /// the moment of a contact that slides as a whole about another point than the origin.
    pub(in crate::rolling) fn moment_capacity(&self, sums: [Option<f64>; 2], sign: f64) -> f64 {
        let least = |shift: [f64; 2], rounding: f64| {
            let sliding = self.sliding(shift, sign, rounding);
            (sliding.bound - dot(shift, prescribed(sums)), sliding)
        };
        let total = self.pressed.limits.sum;
        let mut shift = [0.0; 2];
        let (mut bound, mut sliding) = least(shift, 0.0);
        // Beside no prescribed force the contact turns about the origin.
        let roundings = if sums == [None; 2] {
            &[][..]
        } else {
            &ROUNDINGS
        };
        let lever = bound / total;
        // A length that is rounded is longer: the bound stays one.
        for rounding in roundings.iter().map(|part| part * lever) {
            (bound, sliding) = least(shift, rounding);
            for _ in 0..STEPS {
                let slope =
                    [0, 1].map(|axis| sums[axis].map_or(0.0, |sum| sliding.sums[axis] - sum));
                if slope[0].hypot(slope[1]) <= BALANCED * total {
                    break;
                }
                let step = descent(sums, slope, sliding.stiffness);
                let expected = DECREASE * dot(slope, step);
                let mut parts = successors(Some(1.0), |part| Some(0.5 * part)).take(STEPS);
                let found = parts.find_map(|part: f64| {
                    let next = [0, 1].map(|axis| shift[axis] + part * step[axis]);
                    let (less, sliding) = least(next, rounding);
                    (less < bound + part * expected).then_some((next, less, sliding))
                });
                let Some((next, less, at_next)) = found else {
                    break;
                };
                (shift, bound, sliding) = (next, less, at_next);
            }
        }
        if !roundings.is_empty() {
            (bound, sliding) = least(shift, 0.0);
        }
        // The bound is about the middle of the way of the particles.
        let held = [0, 1].map(|axis| sums[axis].unwrap_or(sliding.sums[axis]));
        let [x, y] = self.halfway();
        (bound - sign * (x * held[1] - y * held[0])) * self.bodies.grid().cell_area()
    }

    fn sliding(&self, shift: [f64; 2], sign: f64, rounding: f64) -> Sliding {
        let (grid, [x, y]) = (self.bodies.grid(), self.halfway());
        let mut sliding = Sliding::default();
        for (index, limit) in self
            .pressed
            .window()
            .indices()
            .zip(&self.pressed.limits.cells)
        {
            let at = centre(grid, index);
            let turn = [-sign * (at[1] + y), sign * (at[0] + x)];
            let moved = [turn[0] + shift[0], turn[1] + shift[1]];
            let size = moved[0].hypot(moved[1]).hypot(rounding);
            if size > 0.0 && *limit > 0.0 {
                let [dx, dy] = moved.map(|part| part / size);
                let stiffness = limit / size;
                sliding.bound += limit * size;
                for (sum, part) in sliding.sums.iter_mut().zip([dx, dy]) {
                    *sum += limit * part;
                }
                let parts = [1.0 - dx * dx, -dx * dy, 1.0 - dy * dy];
                for (sum, part) in sliding.stiffness.iter_mut().zip(parts) {
                    *sum += stiffness * part;
                }
            }
        }
        sliding
    }
}

fn prescribed(sums: [Option<f64>; 2]) -> [f64; 2] {
    sums.map(|sum| sum.unwrap_or(0.0))
}

/// Newton's step down a slope, along the axes whose sums are prescribed.
fn descent(sums: [Option<f64>; 2], [x, y]: [f64; 2], [xx, xy, yy]: [f64; 3]) -> [f64; 2] {
    match sums {
        [Some(_), Some(_)] => {
            let determinant = xx * yy - xy * xy;
            [
                (xy * y - yy * x) / determinant,
                (xy * x - xx * y) / determinant,
            ]
        }
        _ => [
            sums[0].map_or(0.0, |_| -x / xx),
            sums[1].map_or(0.0, |_| -y / yy),
        ],
    }
}
